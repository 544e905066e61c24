//! K(Ω) by a form for each range of Ω: rational where its errors count little, by the quotient of pairs elsewhere.

use super::{
    PhaseFunction, cotangent, is_beside_one, nearest_quarter, one_minus_square, one_minus_square_pair,
    phase_function_of_tangent, reduced, tangent,
};
use crate::float::{Float, pair::Pair};

impl<F: Float> PhaseFunction<F> {
    /// The same with the derivative of K by its own closed form.
    #[inline]
    pub(super) fn differentiated(self) -> Self {
        let hi = self.value.hi.differentiated_as(|| self.slope().constant() * self.omega);
        Self { value: Pair::new(hi, self.value.lo.constant()), ..self }
    }

    /// `K = −(2/π) [(1 + Ω) − (1 + Ω) g]`, g = 1 − w cot w, w = (π/2) (1 − Ω)/Ω, for 2/3 ≤ Ω < 2: the rounding errors of g
    /// are all that counts.
    #[inline(always)]
    pub(super) fn beside_one(omega: F) -> Self {
        let half_pi = Pair::pi() * F::ratio(1, 2);
        let r = Pair::halved_ratio(F::int(1) - omega, omega);
        let square = half_pi.hi * half_pi.hi * r.halved_square().value();
        // Where a doubt below that of the pairs themselves would let them through.
        if square < F::exp2i(-(F::PRECISION as i32 / 3)) {
            return Self::refined_at(omega);
        }
        let defect = cotangent::plain_defect(square);
        let one_plus = Pair::ordered_sum(F::int(1), omega);
        let Pair { hi, lo } = Pair::ordered_sum(one_plus.hi, -(one_plus.hi * defect));
        let scale = Pair::exact(F::int(-2)) / Pair::pi();
        let value = scale.halved().times_halved(Pair::new(hi, lo + one_plus.lo).halved());
        Self { omega, quarter: 1, remainder: half_pi.halved().times_halved(r).value(), value, doubt: defect }
    }

    /// `K = −(π/2) (1 − v)(1 + h) = −(π/2) {1 − [v − h (1 − v)]}`, v = 1/Ω², h = tan β/β − 1, for Ω ≥ 2: the errors of v and h
    /// are all that counts.
    #[inline(always)]
    pub(super) fn above(omega: F) -> Self {
        let (one, half_pi) = (F::int(1), Pair::pi() * F::ratio(1, 2));
        let v = one / (omega * omega);
        let excess = cotangent::tangent_excess(half_pi.hi * half_pi.hi * v);
        let y = Pair::ordered_sum(one, excess * (one - v) - v);
        let value = (-half_pi).halved().times_halved(y.halved());
        Self { omega, quarter: 0, remainder: half_pi.hi / omega + half_pi.lo / omega, value, doubt: excess }
    }

    /// `K = (1 − Ω²) w/(Ω w cot w)`, w = (π/2) (1 − 2Ω)/Ω, for 1/2 ≤ Ω < 2/3: small beside the border, so that its roundings count
    /// little.
    #[inline]
    pub(super) fn between(omega: F) -> Self {
        let half_pi = F::pi() * F::ratio(1, 2);
        let remainder = half_pi * ((F::int(1) - F::int(2) * omega) / omega);
        let cotangent = F::int(1) - cotangent::plain_defect(remainder * remainder);
        let value = Pair::exact(one_minus_square(omega) * remainder / (omega * cotangent));
        Self { omega, quarter: 2, remainder, value, doubt: F::int(1) }
    }

    /// K by the quotient of pairs.
    #[inline]
    pub(crate) fn refined_at(omega: F) -> Self {
        let (quarter, remainder, value) = refined_parts(omega);
        Self { omega, quarter, remainder, value, doubt: Self::none() }.differentiated()
    }

    /// K with the digits of the type, of which there are enough.
    #[inline]
    pub(super) fn of_many_digits(omega: F) -> Self {
        let (quarter, rest) = nearest_quarter(omega);
        let remainder = F::pi() * rest / (F::int(2) * omega);
        let value = Pair::exact(phase_function(omega, quarter, remainder));
        Self { omega, quarter, remainder, value, doubt: Self::none() }
    }

    /// The doubt of a K that is as good as it gets: no comparison finds that less is at stake.
    #[inline]
    pub(super) fn none() -> F {
        F::int(1) / F::int(0)
    }
}

/// K(Ω) from the angle `β = q π/2 + w`, in the form that keeps its accuracy there.
#[inline]
fn phase_function<F: Float>(omega: F, quarter: u8, w: F) -> F {
    if is_beside_one(omega) {
        F::int(-2) * (F::int(1) + omega) / F::pi() * y_cot_y(w)
    } else {
        phase_function_of_tangent(omega, tangent(quarter, w))
    }
}

/// K(Ω) from the angle `β = q π/2 + w` to more digits than the type has: with E = w cot w,
///
/// ```text
/// K = −(2/π)(1 + Ω) E  beside Ω = 1,   (1 − Ω²) w/(Ω E)  for even q,   −(1 − Ω²) E/(Ω w)  for odd q.
/// ```
#[inline]
fn compensated<F: Float>(omega: F, quarter: u8, w: Pair<F>) -> Pair<F> {
    let cotangent = cotangent::y_cot_y(w);
    if is_beside_one(omega) {
        return Pair::sum(F::int(1), omega) * cotangent * (Pair::exact(F::int(-2)) / Pair::pi());
    }
    let square = one_minus_square_pair(omega);
    if quarter & 1 == 0 { square * w / (cotangent * omega) } else { -(square * cotangent) / (w * omega) }
}

/// q mod 4, w and K by the quotient of pairs; not a whole [`PhaseFunction`], so that the common path keeps its own in registers.
#[cold]
#[inline(never)]
fn refined_parts<F: Float>(omega: F) -> (u8, F, Pair<F>) {
    let (quarter, w) = reduced(omega);
    (quarter, w.hi, compensated(omega, quarter, w).normalised())
}

/// `y cot y`, smooth through y = 0.
#[inline]
pub(super) fn y_cot_y<F: Float>(y: F) -> F {
    let y2 = y.square();
    // Below √ε the first two terms of the series, 1 − y²/3 − y⁴/45, are already exact to rounding.
    if y2 < F::epsilon() { F::int(1) - y2 / F::int(3) } else { y / y.tan() }
}

#[cfg(test)]
mod tests {
    use super::{one_minus_square, y_cot_y};

    #[test]
    fn series_and_quotient_meet() {
        let edge = f64::EPSILON.sqrt();
        let (above, below) = (y_cot_y(edge * 1.001), y_cot_y(edge * 0.999));
        assert!((above - below).abs() <= 2.0 * f64::EPSILON, "{above:e} against {below:e}");
        assert_eq!(y_cot_y(0.0), 1.0);
        assert_eq!(one_minus_square(1f64.next_down()), f64::EPSILON * (1.0 - f64::EPSILON / 4.0));
    }
}
