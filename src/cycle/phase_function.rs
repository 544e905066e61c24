//! The phase function K(Ω), on which every closed form depends.
//!
//! The paper's formulae depend on Ω through `T = sin π₁/(1 + cos π₁) = tan(π/2Ω)` with `π₁ = π/Ω` (eq. 26)
//! and `K(Ω) = (1 − Ω²) T/Ω`: `cos ω_d t₂ = K/α` (eq. 40, 41), `Δ₀/B = √(α² − K²)/|1 − Ω²|` (eq. 44), the
//! border (eq. 61) and the best force ratio (eq. 65). T has a pole at Ω = 1, where K has none: `K(1) = −4/π`.
//! The poles of K are exactly Ω = 1/(2n+1), n ≥ 1, and its zeros are Ω = 1/(2n).
//!
//! All functions here start from the angle `β = π/2Ω`, reduced to the nearest multiple of π/2,
//!
//! ```text
//! β = q π/2 + w,   q = round(1/Ω),   w = (π/2) (1 − qΩ)/Ω,   |w| ≤ π/4,
//! ```
//!
//! where `1 − qΩ` is formed with one rounding (exactly, near a pole or a zero). The floats near Ω = 1 and Ω =
//! 1/n are therefore no special cases.

mod cotangent;
mod excess;
mod frequency;
mod nearest;
mod parts;
mod reduction;
mod slope;
mod value;

use crate::float::Float;
use crate::float::pair::Pair;
use crate::machine::error::Error;
use crate::machine::ratios::frequency_ratio;
use cotangent::cotangent_defect;
pub(crate) use excess::{excess_close_to_one, is_close_to_one, sum};
pub(crate) use frequency::{Frequency, Offset};
use nearest::{nearest_of_three, nearest_quarter};
use parts::is_beside_one;
#[cfg(feature = "batch")]
pub(crate) use parts::one_minus_moderate_square;
pub use parts::{PhaseFunction, phase_function_of_tangent};
pub(crate) use parts::{one_minus_square, one_minus_square_wide, reduced, tangent, turned};
pub(crate) use reduction::LowAngle;
pub(crate) use slope::arc_less_sine;
#[cfg(feature = "batch")]
pub(crate) use value::Quotient;
#[cfg(feature = "mp")]
pub(crate) use value::phase_function_beside_one;

impl<F: Float> PhaseFunction<F> {
    /// The phase function at the frequency ratio Ω.
    ///
    /// # Errors
    /// Where Ω is not finite, not > 0 or outside the domain of [`crate::Ratios`].
    #[inline(always)]
    pub fn new(omega: F) -> Result<Self, Error> {
        frequency_ratio(omega).map(Self::of_valid)
    }

    /// The phase function of an Ω known to be in the domain.
    // Always inline: the common path then keeps everything in registers.
    #[inline(always)]
    pub(crate) fn of_valid(omega: F) -> Self {
        if Self::is_rational_enough(omega) { Self::by_quotient(omega) } else { Self::refined_at(omega) }
            .differentiated()
    }

    /// Frequency ratio Ω.
    #[inline]
    pub(crate) const fn omega(&self) -> F {
        self.omega
    }

    /// `q mod 4`, where `q = round(1/Ω)` is the multiple of π/2 nearest to `β = π/2Ω`.
    #[inline]
    pub(crate) const fn quarter(&self) -> u8 {
        self.quarter
    }

    /// `w = β − q π/2`, in `[−π/4, π/4]`.
    #[inline]
    pub(crate) const fn remainder(&self) -> F {
        self.remainder.hi
    }

    /// Whether Ω lies in the neighbourhood of 1, where the forms smooth through 1 are used.
    #[inline]
    pub(crate) fn is_beside_one(&self) -> bool {
        is_beside_one(self.omega)
    }

    /// Whether Ω is exactly 1/(2n), where K = 0; for a binary type it is then a power of two.
    pub(crate) fn is_even_subharmonic(&self) -> bool {
        self.value() == F::int(0)
    }

    /// `T = tan(π/2Ω) = sin π₁/(1 + cos π₁)`. It is infinite only at Ω = 1, since no other float is a pole.
    #[inline]
    #[doc(hidden)]
    pub fn tangent(&self) -> F {
        tangent(self.quarter, self.remainder.hi)
    }

    /// `(sin β, cos β)` of `β = π/2Ω`; the cosine keeps its relative accuracy where it vanishes.
    #[doc(hidden)]
    #[inline]
    pub fn sin_cos(&self) -> (F, F) {
        let (s, c) = if const { F::PRECISION > f64::MANTISSA_DIGITS } {
            // At high precision, a circular function costs as much as fifty products.
            let t = self.remainder_tangent();
            let c = F::int(1) / (F::int(1) + t.square()).sqrt();
            (t * c, c)
        } else {
            self.remainder.hi.sin_cos()
        };
        turned(self.quarter, (s, c))
    }

    /// `(sin β, cos β)` as batches compute them: without circular functions for Ω ≥ 1/2.
    #[inline(always)]
    pub(crate) fn sin_cos_of_cycle(&self) -> (F, F) {
        if Self::is_rational_enough(self.omega) {
            Frequency::new(&Offset::new(), self.omega, self.value).sin_cos_beta()
        } else if Self::is_acute_enough(self.omega) {
            let (sine, cosine) = LowAngle::of(self).sin_cos();
            (sine.value(), cosine.value())
        } else {
            self.sin_cos()
        }
    }

    /// `tan w`, from K.
    fn remainder_tangent(&self) -> F {
        let (omega, k) = (self.omega, self.value.value());
        if is_beside_one(omega) {
            F::int(-2) * (F::int(1) + omega) * self.remainder.hi / (F::pi() * k)
        } else if self.quarter & 1 == 0 {
            k * omega / one_minus_square(omega)
        } else {
            -(one_minus_square(omega) / (k * omega))
        }
    }

    /// `γ = β mod π`, in `[0, π)`: the phase of β within its lobe. Zero at Ω = 1/(2n).
    #[inline]
    pub(crate) fn lobe_phase(&self) -> Pair<F> {
        LowAngle::of(self).lobe_phase()
    }

    /// The phase function `K(Ω) = (1 − Ω²) T/Ω`, finite for every float Ω.
    ///
    /// Near Ω = 1 it is `−(2/π)(1 + Ω) y cot y` with `y = π(Ω − 1)/(2Ω)`, and `K(1) = −4/π`.
    ///
    /// Source: Hong & Liu 2001, eq. 41, written by its own reduced angle. Accuracy at f64: 1 ulp.
    #[inline(always)]
    pub fn value(&self) -> F {
        self.value.value()
    }

    /// K(Ω) to more digits than the type has. Its relative error is below half a unit in the last place of
    /// the type, and for Ω ≥ 1/2 it decreases with (1 − 1/Ω)², down to u².
    #[inline(always)]
    pub(crate) const fn wide(&self) -> Pair<F> {
        self.value
    }

    /// `1 − Ω²` as a pair.
    #[inline(always)]
    pub(crate) fn one_minus_square(&self) -> Pair<F> {
        one_minus_square_wide(self.omega)
    }
}

#[cfg(test)]
mod tests;
