//! The lobes of the border: between two poles it has one minimum, and no more.
//!
//! The poles of α_min are Ω = 1/(2n+1), n ≥ 1. Lobe n is the interval between 1/(2n+3) and 1/(2n+1); lobe 0
//! has no upper pole. Within a lobe α_min decreases from the lower pole to one minimum and then increases, so
//! that a given force keeps the body sliding on at most one interval of Ω ([`crate::design`]). With u = 1/Ω:
//!
//! * **u ≤ 2.** `−K = (4/π) [1 + Σ_{m = 9, 25, 49, …} (1 − u²)/(m − u²)]` by the partial fractions of the
//!   tangent: falling and concave in v = u², say κ(v). `α_min² = κ² + (v − 1)²` has the second derivative
//!   `2κ′² + 2 + 2κκ″`, and κ|κ″| < 1/4 there: strictly convex in 1/Ω², one minimum. As Ω → ∞ α_min rises to
//!   √(1 + π²/4).
//! * **2n < u < 2n + 1**, T > 0: α_min rises with u. K² = (u − 1/u)² T² does, and
//!   `(1 − Ω²) S = (u − 1/u) N/sin τ` with `N = sin σ + T(cos τ − cos σ)` does by its explicit derivative
//!   `∂N/∂u = [(τ − π/2) cos ξ cos γ + (π/2)(cos τ + sin γ sin ξ)]/cos²γ = [τ cos ξ cos γ + (π/2)(cos τ − cos
//!   σ)]/cos²γ > 0`: g(ξ) = 0 asks for cos ξ > 0, so that τ < σ < π.
//! * **2n + 1 < u < 2n + 2**, T < 0, t = |T|, c = |cos γ|, n ≥ 1: there `∂N/∂u = −[(π/2)(cos τ + sin γ sin
//!   ξ) + (π/2 − τ) c cos ξ]/c²` is negative, so that `S/(1/Ω²) = N/(u sin τ)` falls throughout, from ∞ at
//!   the pole to less than 1/2 at 2n + 2: it is 1 **once**, at u_e, the end of the band where eq. 61 falls
//!   short. Up to u_e both K² and S fall fast enough for α_min to fall: `|∂N/∂u|/N ≥ (π/2) t` and
//!   `|T′/T| ≥ π` by u, against `(u² + 1)/(u³ − u) < 1/2`, the rate of u − 1/u; and t > 1/3, because
//!   N ≤ 2t + 1 < u sin(γ/u) otherwise. From u_e on α_min is eq. 61, `(u² − 1)² (1 + t²/u²)`, whose
//!   derivative has the sign of `1 − H`, `H = [π t (1 + t²) + 2t²/u] (u² − 1)/(4u (u² + t²))`. As u grows t
//!   falls. H grows with t at a given u: t(1 + t²)/(u² + t²) and t²/(u² + t²) do. It falls with u at a given
//!   t ≤ √3: the derivative of (u² − 1)/(u (u² + t²)) has the sign of
//!   `−u⁴ + (3 + t²)u² + t² ≤ −(u⁴ − 6u² − 3)`, negative for u ≥ 3. So H falls from u_e on, and there is one
//!   minimum.
//!
//! **t(u_e) = u_e tan(π/2u_e).** At σ = π, τ = π/u, the condition g = 0 reads t = u tan(π/2u), and there
//! |f| = t u cot(π/2u) = u², the limit at the turning point: both suprema meet where the condition holds. As
//! u tan(π/2u) falls with u, t(u_e) is below 3 tan(π/6) = √3 for n ≥ 1, below 5 tan(π/10) = 1.6246 for n ≥ 2, and tends to π/2.
//!
//! So the minimum is where H = 1 or at u_e, whichever u is larger. In lobe 1 it is the former, smooth. For
//! n ≥ 2 H(u_e) ≤ H at (t, u) = (1.6246, 5), which is 0.853: the minimum is the **corner** at u_e.
//!
//! The minima grow with n: that of lobe n is below α_min(1/(2n+2)) = (2n+2)² − 1, that of lobe n + 1 above
//! (2n+3)² − 1.

use super::Border;
use super::band_end::BandEnd;
use crate::cycle::phase_function::PhaseFunction;
use crate::float::Float;
use crate::machine::error::{Error, Quantity, written};
use crate::machine::ratios::frequency_ratio;
use crate::root;

/// One lobe of the border: Ω from the pole 1/(2n+3) to the pole 1/(2n+1), for lobe 0 from 1/3 on.
///
/// The index goes to 65535, Ω = 7.6e-6: beyond, a force ratio of 1.7e10 does not keep the body sliding
/// anywhere.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) struct Lobe {
    index: u16,
}

/// The minimum force ratio of a lobe.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Minimum<F> {
    /// Frequency ratio Ω of the minimum.
    pub omega: F,
    /// The border there: the minimum force ratio that keeps the body sliding anywhere in the lobe.
    pub force_ratio: F,
    /// Whether the border has a corner there (lobes from 2 on), not a horizontal tangent (lobes 0 and 1).
    pub is_corner: bool,
}

impl Lobe {
    /// Lobe n.
    #[must_use]
    pub(crate) const fn new(index: u16) -> Self {
        Self { index }
    }

    /// The lobe that contains Ω. It is exact: one fused operation decides the side of a pole.
    ///
    /// # Errors
    /// Where Ω is not in the domain of [`crate::Ratios`], or below the lowest lobe.
    pub(crate) fn containing<F: Float>(omega: F) -> Result<Self, Error> {
        let lowest = Self::new(u16::MAX).low_pole();
        let omega = frequency_ratio(omega)?;
        if omega < lowest {
            return Err(Error::OutOfRange {
                quantity: Quantity::FrequencyRatio,
                value: written(omega),
                least: written(lowest),
                greatest: written(F::exp2i(F::RATIO_EXPONENT)),
            });
        }
        // Within one of the right index whatever the rounding; the casts saturate.
        let near = ((1.0 / omega.to_f64() - 1.0) / 2.0) as u16;
        let guess = near.saturating_add(1);
        let above_low_pole = |index: &u16| odd::<F>(*index, 3).mul_add(omega, F::int(-1)) > F::int(0);
        let first = (near.saturating_sub(1)..guess).find(above_low_pole);
        Ok(Self::new(first.unwrap_or(guess)))
    }

    /// The index n.
    #[must_use]
    pub(crate) const fn index(self) -> u16 {
        self.index
    }

    /// The next lobe towards high frequencies; `None` for lobe 0.
    #[must_use]
    pub(crate) fn above(self) -> Option<Self> {
        self.index.checked_sub(1).map(Self::new)
    }

    /// The next lobe towards low frequencies; `None` for the last.
    #[must_use]
    pub(crate) fn below(self) -> Option<Self> {
        self.index.checked_add(1).map(Self::new)
    }

    /// The pole 1/(2n+3) at the lower end, rounded.
    #[must_use]
    pub(crate) fn low_pole<F: Float>(self) -> F {
        F::int(1) / odd(self.index, 3)
    }

    /// The pole 1/(2n+1) at the upper end, rounded; `None` for lobe 0.
    #[must_use]
    pub(crate) fn high_pole<F: Float>(self) -> Option<F> {
        (self.index > 0).then(|| F::int(1) / odd(self.index, 1))
    }

    /// The minimum force ratio in this lobe ([`Border::minimum`]).
    #[must_use]
    pub(crate) fn minimum<F: Float>(self) -> Minimum<F> {
        // Brackets that hold the minimum of eq. 61 and no end of a band.
        let (low, high) = match self.index {
            0 => (F::ratio(1, 2), F::int(1)),
            1 => (F::ratio(1, 4), F::ratio(299, 1000)),
            n => {
                let end = BandEnd::of(n);
                return Minimum { omega: end.omega(), force_ratio: end.border(), is_corner: true };
            }
        };
        let (_, omega) = root::enclosed(low, high, |omega| Border::slope(&PhaseFunction::of_valid(omega)));
        let force_ratio = Border::at(&PhaseFunction::of_valid(omega)).min_force_ratio;
        Minimum { omega, force_ratio, is_corner: false }
    }
}

/// `2n + offset`.
fn odd<F: Float>(index: u16, offset: i32) -> F {
    F::int(i32::from(index).saturating_mul(2).saturating_add(offset))
}

impl<F: Float> Border<F> {
    /// The minimum force ratio between two neighbouring poles, and its place. In lobe n, from the pole
    /// 1/(2n+3) to the pole 1/(2n+1), and for n = 0 from 1/3 on, it is the only minimum of α_min.
    ///
    /// 1.20999843633807… at Ω = 0.849158848834442 in lobe 0, 11.3641047199701 at 0.297128660867652 in lobe 1;
    /// a corner from lobe 2 on. Accuracy at f64: 8 ulp in both.
    pub fn minimum(lobe: u16) -> Minimum<F> {
        Lobe::new(lobe).minimum()
    }
}

#[cfg(test)]
mod tests {
    use super::Lobe;
    use crate::cycle::border::tests::{at, close};
    use crate::{Border, Error, PhaseFunction};

    #[test]
    fn minima_at_forty_digits() {
        for (n, omega, force_ratio, is_corner) in [
            (0, 0.849_158_848_834_442_1, 1.209_998_436_338_071_6, false),
            (1, 0.297_128_660_867_652_44, 11.364_104_719_970_088, false),
            (2, 0.186_828_225_506_139_28, 28.884_281_620_560_04, true),
            (3, 0.135_934_367_957_850_08, 54.352_307_003_111_26, true),
            (7, 0.065_104_590_685_760_67, 236.160_374_325_403_58, true),
            (100, 0.004_966_207_411_299_988, 40_546.446_242_767_13, true),
            (5000, 9.998639278110747e-05, 100_027_220.227_185_74, true),
            (65535, 7.62943173153576e-06, 17_179_701_650.265_942, true),
        ] {
            let found = Lobe::new(n).minimum::<f64>();
            close(found.omega, omega, 4.0);
            close(found.force_ratio, force_ratio, 8.0);
            assert_eq!(found.is_corner, is_corner);
        }
    }
    #[test]
    fn single_precision_finds_them_too() {
        assert!((Lobe::new(0).minimum::<f32>().omega - 0.849_158_8).abs() < 1e-6);
        assert!((Lobe::new(2).minimum::<f32>().omega - 0.186_828_2).abs() < 1e-6);
    }

    #[test]
    fn a_float_is_in_the_lobe_on_its_side_of_the_pole() {
        for n in [1u16, 2, 3, 7, 100, 65_534] {
            let pole: f64 = Lobe::new(n).high_pole().unwrap();
            let index = |omega: f64| Lobe::containing(omega).unwrap().index();
            assert_eq!(index(pole.next_down()), n);
            assert_eq!(index(pole.next_up()), n - 1);
            let is_above = f64::from(2 * u32::from(n) + 1).mul_add(pole, -1.0) > 0.0;
            assert_eq!(index(pole), if is_above { n - 1 } else { n });
        }
        for (omega, index) in [(1e3, 0), (0.34, 0), (0.33, 1), (0.21, 1), (0.19, 2)] {
            assert_eq!(Lobe::containing(omega), Ok(Lobe::new(index)));
        }
        assert!(matches!(Lobe::containing(7e-6), Err(Error::OutOfRange { .. })));
    }

    /// Checks the statement of the module's proof on a grid: in each lobe the border decreases, then
    /// increases.
    #[test]
    fn one_minimum_in_each_lobe() {
        for n in [0, 1, 2, 3, 10, 200] {
            let lobe = Lobe::new(n);
            let (low, high) = (lobe.low_pole::<f64>(), lobe.high_pole().unwrap_or(20.0));
            let minimum = lobe.minimum::<f64>();
            for i in 1..4000 {
                let omega = low + (high - low) * f64::from(i) / 4000.0;
                let slope = Border::slope(&PhaseFunction::new(omega).unwrap());
                if (omega / minimum.omega - 1.0).abs() > 1e-9 {
                    assert_eq!(slope > 0.0, omega > minimum.omega, "lobe {n}, {omega}: {slope}");
                }
                assert!(at(omega) >= minimum.force_ratio * (1.0 - 1e-15));
            }
        }
    }
}
