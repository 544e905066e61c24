//! K(Ω) to more digits than the type has, with one form for each range of Ω.
//!
//! **For Ω ≥ 1/2, at up to 53 bits.** With t = 1/Ω and the angle `y = (π/2)(1 − t)` in (−π/2, π/2), the zeros
//! and the nearest poles of `y cot y` are rational in t. The remaining factor is almost constant in `z = (1 −
//! t)²`:
//!
//! ```text
//! K = (2Ω − 1)/(3Ω − 1) G(z),   0 ≤ z ≤ 1,   G from −8/π to −3π/4.
//! ```
//!
//! The quotient and G's leading term, −8/π, are pairs. The rest of G is z times a polynomial and at most a
//! twelfth of G. Only its roundings matter: they give K a relative error of the order of u z. On the border
//! and above, an error of K is multiplied in Δ₀ by κ = K²/(α² − K²) ≤ K²/(1/Ω² − 1)², and κ z < 2.5. The
//! accuracy of K therefore increases towards Ω = 1 just as Δ₀ requires.
//!
//! **Elsewhere** the angle is reduced, and K is a quotient of pairs or is computed with guard digits.

use super::{
    PhaseFunction, cotangent, is_beside_one, nearest_of_three, nearest_quarter, one_minus_square_wide,
    phase_function_of_tangent, reduced, tangent,
};
use crate::float::pair::Pair;
use crate::float::{Float, Real, at_precision, fused};

/// `8/π`, to twice the digits of f64; G's leading term is its negative.
const EIGHT_OVER_PI: (f64, f64) = (2.546_479_089_470_325_5, -1.5742941340145989e-16);
/// `(G(z) + 8/π)/z`, from the constant term up: interpolated at Chebyshev nodes, computed with 60 digits and
/// rounded. The error is 6e-18 of G and decreases with z.
const REST: [f64; 9] = [
    0.184_535_785_290_451_48,
    0.005_451_195_028_815_732,
    0.000_280_237_262_226_511_3,
    1.632_443_057_952_603e-5,
    9.919_379_396_506_56e-7,
    6.126_054_203_459_787e-8,
    3.819_858_885_812_053e-9,
    2.277_823_869_500_360_2e-10,
    1.978_423_405_222_465_2e-11,
];
/// The binary exponent of the greatest Ω for which the form with G is used.
const GREATEST: i32 = 20;

impl<F: Float> PhaseFunction<F> {
    /// K with its value unchanged, and the derivative of K by its own closed form.
    #[inline(always)]
    pub(super) fn differentiated(self) -> Self {
        let hi = self.value.hi.differentiated_as(|| self.slope().constant() * self.omega);
        Self { value: Pair::new(hi, self.value.lo.constant()), ..self }
    }

    /// Whether the form with G is accurate to the precision of the type at this Ω.
    #[inline(always)]
    pub(crate) fn is_rational_enough(omega: F) -> bool {
        F::PRECISION <= f64::MANTISSA_DIGITS && omega >= F::ratio(1, 2) && omega <= F::exp2i(GREATEST)
    }

    /// Whether Ω is below 1/2 and the crate's own circular functions are accurate to the precision of the
    /// type.
    #[inline(always)]
    pub(crate) fn is_acute_enough(omega: F) -> bool {
        F::PRECISION <= f64::MANTISSA_DIGITS && omega < F::ratio(1, 2)
    }

    /// K by the form with G.
    #[inline(always)]
    pub(super) fn by_quotient(omega: F) -> Self {
        Self::of_three(omega, Quotient::new().at(omega))
    }

    #[inline(always)]
    fn of_three(omega: F, value: Pair<F>) -> Self {
        let (quarter, rest) = nearest_of_three(omega);
        let remainder = Pair::exact(F::pi() * F::ratio(1, 2) * (rest / omega));
        Self { omega, quarter, remainder, value }
    }

    /// The phase function at an Ω whose K is known.
    #[inline(always)]
    pub(crate) fn of_known(omega: F, value: Pair<F>) -> Self {
        if Self::is_rational_enough(omega) {
            return Self::of_three(omega, value);
        }
        let (quarter, remainder) = reduced(omega);
        Self { omega, quarter, remainder, value }
    }

    /// K by the reduced angle, in compensated arithmetic or with guard digits.
    #[inline]
    pub(crate) fn refined_at(omega: F) -> Self {
        let (quarter, remainder, value) = refined_parts(omega);
        Self { omega, quarter, remainder, value }
    }
}

/// The coefficients of the form with G.
#[derive(Clone, Copy)]
pub(crate) struct Quotient<F> {
    leading: Pair<F>,
    rest: [F; 9],
}

impl<F: Float> Quotient<F> {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        let (first, second) = EIGHT_OVER_PI;
        let hi = F::from_f64(first);
        let lo = F::from_f64(first - hi.to_f64()) + F::from_f64(second);
        Self { leading: -Pair::new(hi, lo), rest: REST.map(F::from_f64) }
    }

    /// `K = (2Ω − 1)/(3Ω − 1) G(z)`, for 1/2 ≤ Ω.
    #[inline(always)]
    pub(crate) fn at(&self, omega: F) -> Pair<F> {
        let one = F::int(1);
        // Exact, like 2Ω − 1: both are multiples of Ω's last place, and not larger than 2Ω.
        let from_one = omega - one;
        let z = from_one * from_one * (one / (omega * omega));
        // Odd and even powers are summed side by side: Horner's rule would be half of the time that a point
        // waits for K.
        let [c0, c1, c2, c3, c4, c5, c6, c7, c8] = self.rest;
        let (z2, leading) = (z * z, self.leading);
        let odd = c7.mul_add(z2, c5).mul_add(z2, c3).mul_add(z2, c1);
        let even = c8.mul_add(z2, c6).mul_add(z2, c4).mul_add(z2, c2).mul_add(z2, c0);
        let rest = odd.mul_add(z, even);
        let hi = z.mul_add(rest, leading.hi);
        let g = Pair::new(hi, z.mul_add(rest, leading.hi - hi) + leading.lo);
        let twice_less_one = from_one + omega;
        // Below Ω = 1 the first term is the smaller one, but it is a multiple of the last place of the
        // second, so that the sum is still exact.
        g * twice_less_one / Pair::fast_two_sum(twice_less_one, omega)
    }
}

/// K(Ω) from the angle `β = q π/2 + w`, in the form that keeps its accuracy there.
#[inline]
fn phase_function<F: Float>(omega: F, quarter: u8, w: F) -> F {
    if is_beside_one(omega) {
        phase_function_beside_one(omega, y_cot_y(w))
    } else {
        phase_function_of_tangent(omega, tangent(quarter, w))
    }
}

/// `K = −(2/π)(1 + Ω) E` from `E = w cot w`, w = (π/2)(1 − Ω)/Ω: smooth through Ω = 1.
#[inline]
pub(crate) fn phase_function_beside_one<R: Real>(omega: R, w_cot_w: R) -> R {
    // K = −(2/π)(1 + Ω) w cot w
    R::int(-2) * (R::int(1) + omega) / R::pi() * w_cot_w
}

/// K(Ω) away from Ω = 1, from the angle `β = q π/2 + w`, to more digits than the type has: with E = w cot w,
///
/// ```text
/// K = (1 − Ω²) w/(Ω E)  for even q,   −(1 − Ω²) E/(Ω w)  for odd q.
/// ```
///
/// One quotient serves both, so that loops do not branch.
#[inline(always)]
pub(super) fn of_remainder<F: Float>(omega: F, is_even: bool, w: Pair<F>) -> Pair<F> {
    let cotangent = cotangent::y_cot_y(w);
    let (over, under) = if is_even { (w, cotangent) } else { (-cotangent, w) };
    (one_minus_square_wide(omega) * over / (under * omega)).normalised()
}

/// q mod 4, w and K of [`PhaseFunction::refined_at`]. It does not return a [`PhaseFunction`], so that the
/// common path keeps its own in registers.
#[cold]
#[inline(never)]
fn refined_parts<F: Float>(omega: F) -> (u8, Pair<F>, Pair<F>) {
    fused!(<F>(omega: F) -> (u8, Pair<F>, Pair<F>) {
        let (quarter, w) = reduced(omega);
        let value = if const { F::PRECISION > f64::MANTISSA_DIGITS } {
            guarded(omega)
        } else {
            of_remainder(omega, quarter & 1 == 0, w)
        };
        (quarter, w, value)
    })
}

/// K(Ω) with guard digits, as a pair.
fn guarded<F: Float>(omega: F) -> Pair<F> {
    at_precision!(guarded, <F>(omega: F) -> Pair<F>, |there, back: G| {
        let omega = there(omega);
        let (quarter, rest) = nearest_quarter(omega);
        let remainder = G::pi() * rest / (G::int(2) * omega);
        Pair::rounded(phase_function(omega, quarter, remainder), there, back)
    })
}

/// `y cot y`, smooth through y = 0.
#[inline]
pub(super) fn y_cot_y<F: Float>(y: F) -> F {
    let y2 = y.square();
    // Below √ε the first two terms of the series 1 − y²/3 − y⁴/45 − … are exact to rounding.
    if y2 < F::epsilon() { F::int(1) - y2 / F::int(3) } else { y / y.tan() }
}

#[cfg(test)]
mod tests {
    use super::y_cot_y;
    use crate::cycle::phase_function::one_minus_square;

    #[test]
    fn series_and_quotient_meet() {
        let edge = f64::EPSILON.sqrt();
        let (above, below) = (y_cot_y(edge * 1.001), y_cot_y(edge * 0.999));
        assert!((above - below).abs() <= 2.0 * f64::EPSILON, "{above:e} against {below:e}");
        assert_eq!(y_cot_y(0.0), 1.0);
        // 1 − 0.6 ε/3 is nearer to 1 than to 1 − ε/2, and 1 − 0.9 ε/3 is not.
        let small = [0.6, 0.9].map(|part| y_cot_y((part * f64::EPSILON).sqrt()));
        assert_eq!(small, [1.0, 1f64.next_down()]);
        assert_eq!(one_minus_square(1f64.next_down()), f64::EPSILON * (1.0 - f64::EPSILON / 4.0));
    }
}
