//! The reversal of the motion to more digits than the type has: with which arguments eq. 40–44 are evaluated.
//!
//! `α² − K² = (α − |K|)(α + |K|)`, where α − |K| cancels for α ≈ |K|: an error of K is multiplied by κ =
//! K²/(α² − K²). K is a pair whose error decreases with (1 − 1/Ω)², as fast as κ grows on the border and
//! above ([`PhaseFunction::wide`]), so that pairs suffice for the formulae. The exception, at f64, is Ω
//! closer to 1 than 2⁻²⁴, where the pair itself has no further digits ([`excess_close_to_one`]).

use super::displacement::{
    cos_displacement_phase, displacement_of_leg, max_displacement_by, phase, sin_displacement_phase,
};
use super::dissipation::{loop_size_inertia, loop_size_stiffness_by};
use crate::cycle::phase_function::{PhaseFunction, excess_close_to_one, is_close_to_one};
use crate::float::pair::Pair;
use crate::float::{Field, Float};

/// The reversal at the peak displacement: K, 1 − Ω² and Δ₀/B to more digits than the type has.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reversal<F> {
    alpha: F,
    /// K(Ω).
    phase_function: Pair<F>,
    /// 1 − Ω².
    one_minus_square: Pair<F>,
    /// Δ₀/B (eq. 44).
    displacement: Pair<F>,
    /// 1/α, within a few units in the last place.
    inverse: F,
}

impl<F: Float> Reversal<F> {
    /// The reversal at the frequency ratio of `p` and the force ratio α: NaN where α < |K|, infinite at
    /// Ω = 1. An α below |K| by rounding is taken as the border, where Δ₀/B = 1/Ω².
    // Always inline: the common path then keeps everything in registers.
    #[inline(always)]
    pub fn new(p: &PhaseFunction<F>, alpha: F) -> Self {
        let (phase_function, one_minus_square) = (p.wide(), p.one_minus_square());
        if is_close_to_one(p.omega()) {
            let displacement = displacement_close_to_one(p.omega(), phase_function, one_minus_square, alpha);
            return Self {
                alpha,
                phase_function,
                one_minus_square,
                displacement,
                inverse: F::int(1) / alpha,
            };
        }
        Self::by_formula(phase_function, one_minus_square, alpha)
    }

    /// [`Reversal::new`] where K and 1 − Ω² have the digits that α asks for. One division gives 1/|1 − Ω²| and 1/α.
    #[inline(always)]
    pub(crate) fn by_formula(phase_function: Pair<F>, one_minus_square: Pair<F>, alpha: F) -> Self {
        let width = one_minus_square.hi.abs();
        let both = F::int(1) / (alpha * width);
        let displacement = max_displacement_by(phase_function, alpha.wide(), one_minus_square, |a, b| {
            a.over(b, both * alpha)
        });
        Self { alpha, phase_function, one_minus_square, displacement, inverse: both * width }
    }

    /// The reversal of a body that does not stick, which has Δ₀/B ≥ 1/Ω² (eq. 61).
    ///
    /// On the border α − |K| can consist of the rounding of α, and be too small or negative.
    #[inline(always)]
    pub(crate) fn of_sliding(self, omega: F) -> Self {
        if self.over_least(omega) >= least_but_for_rounding() { self } else { self.on_the_border(omega) }
    }

    /// This reversal, or one of NaN.
    #[cfg(feature = "batch")]
    #[inline(always)]
    pub(crate) fn or_nan(self, is_known: bool, nan: F) -> Self {
        let hi = if is_known { self.displacement.hi } else { nan };
        Self { displacement: Pair::new(hi, self.displacement.lo), ..self }
    }

    /// Whether Δ₀/B is less than that of a body that does not stick, by more than rounding; not where it is
    /// NaN.
    #[cfg(feature = "batch")]
    #[inline(always)]
    pub(crate) fn falls_short(&self, omega: F) -> bool {
        self.over_least(omega) < least_but_for_rounding()
    }

    /// `Ω²Δ₀/B`.
    #[inline(always)]
    fn over_least(&self, omega: F) -> F {
        self.max_displacement() * omega * omega
    }

    #[cold]
    #[inline(never)]
    fn on_the_border(self, omega: F) -> Self {
        Self { displacement: Pair::exact(F::int(1)) / omega.wide().square(), ..self }
    }

    /// Peak displacement Δ₀/B (eq. 44). Accuracy at f64: 2 ulp.
    #[inline(always)]
    pub fn max_displacement(&self) -> F {
        self.displacement.value()
    }

    /// Peak displacement Δ₀/B rounded, and its rounding remainder.
    #[inline(always)]
    pub(crate) fn max_displacement_pair(&self) -> Pair<F> {
        self.displacement.normalised()
    }

    /// Phase ω_d t₂ by eq. 40 and 41.
    #[inline(always)]
    pub(crate) fn displacement_phase(&self) -> F {
        let alpha = self.alpha.wide();
        let sine = sin_displacement_phase(self.displacement, alpha, self.one_minus_square);
        phase(sine.value(), cos_displacement_phase(self.phase_function, alpha).value())
    }

    /// K(Ω).
    #[inline(always)]
    pub(crate) const fn phase_function(&self) -> Pair<F> {
        self.phase_function
    }

    /// Loop size `A₁ = 8(Δ₀/B)/α²` (eq. 64). Accuracy at f64: 2 ulp.
    #[inline(always)]
    pub fn loop_size_stiffness(&self) -> F {
        self.wide_loop_size().value()
    }

    /// Loop size `A₂ = Ω² A₁` (eq. 67) at the frequency ratio Ω of this reversal. Accuracy at f64: 2 ulp.
    #[inline(always)]
    pub(crate) fn loop_size_inertia(&self, omega: F) -> F {
        loop_size_inertia(self.wide_loop_size(), omega.wide()).value()
    }

    #[inline(always)]
    fn wide_loop_size(&self) -> Pair<F> {
        loop_size_stiffness_by(self.displacement, self.alpha.wide(), |a, b| a.over(b, self.inverse))
    }

    /// Converts each part of the reversal to another number type.
    pub(crate) fn map<G: Float>(self, to: impl Fn(F) -> G) -> Reversal<G> {
        Reversal {
            alpha: to(self.alpha),
            phase_function: self.phase_function.map(&to),
            one_minus_square: self.one_minus_square.map(&to),
            displacement: self.displacement.map(&to),
            inverse: to(self.inverse),
        }
    }

    /// Δ₁/B of eq. 47 at the centred time ψ of the peak velocity.
    ///
    /// `α sin ω_d t₁ = −[α cos ω_d t₂ cos Ωψ + α sin ω_d t₂ sin Ωψ]`: without the rounding of ω_d t₁, and in
    /// pairs, because above Ω = 1 the terms are larger than V₀.
    #[inline]
    pub(crate) fn deviation(&self, omega: F, psi: F) -> F {
        let (s, c) = sin_cos(omega.wide() * psi);
        deviation_by(self.phase_function, self.one_minus_square * self.displacement, (s, c)).value()
    }
}

/// Δ₁/B of eq. 47 from α cos ω_d t₂ = K, α sin ω_d t₂ and (sin Ωψ, cos Ωψ).
#[inline(always)]
pub(crate) fn deviation_by<R: Field>(phase_function: R, sine: R, (s, c): (R, R)) -> R {
    -(phase_function * c + sine * s + R::int(1))
}

/// The least `Ω²Δ₀/B` of a body that does not stick, 1, minus its possible rounding error.
#[inline(always)]
fn least_but_for_rounding<F: Float>() -> F {
    F::int(1) - F::int(4) * F::epsilon()
}

/// Δ₀/B near Ω = 1.
#[cold]
#[inline(never)]
fn displacement_close_to_one<F: Float>(omega: F, k: Pair<F>, width: Pair<F>, alpha: F) -> Pair<F> {
    let excess = excess_close_to_one(omega, alpha);
    if excess.hi <= F::int(0) && -excess.hi <= F::int(2) * F::epsilon() * alpha {
        // The border differs from |K| by less than the rounding of α: there this is the border.
        return Pair::exact(F::int(1)) / omega.wide().square();
    }
    if width.hi == F::int(0) {
        // A pair has no infinity.
        return Pair::exact(excess.hi.sqrt() / width.hi.abs());
    }
    // K < 0
    displacement_of_leg(((alpha.wide() - k) * excess).sqrt(), width, |a, b| a / b)
}

/// `(sin, cos)` of a pair, each with the one rounding of the type's own function.
#[inline]
fn sin_cos<F: Float>(angle: Pair<F>) -> (Pair<F>, Pair<F>) {
    let (s, c) = angle.hi.sin_cos();
    (Pair::new(s, c * angle.lo), Pair::new(c, -(s * angle.lo)))
}

#[cfg(test)]
mod tests {
    use super::sin_cos;
    use crate::float::pair::Pair;

    /// The low part moves the sine by c lo and the cosine by −s lo.
    #[test]
    fn a_low_part_of_an_angle_counts() {
        for angle in [0.3f64, 1.2, 2.5, 4.0, 5.9] {
            let lo = 2f64.powi(-26);
            let (s, c) = sin_cos(Pair::new(angle, lo));
            let (expected_s, expected_c) = (angle + lo).sin_cos();
            assert!((s.value() - expected_s).abs() < 1e-15 && (c.value() - expected_c).abs() < 1e-15);
        }
    }
}
