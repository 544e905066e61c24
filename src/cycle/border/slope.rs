//! The derivative dα_min/dΩ of the exact border.
//!
//! With b = (1 − Ω²) S, `α_min² = K² + b²` and
//!
//! ```text
//! α_min′ = (K/α_min) K′ + (b/α_min) b′.
//! ```
//!
//! Where eq. 61 is exact, b = 1/Ω² − 1 and b′ = −2/Ω³. Elsewhere S is the value of f at a point where f is
//! stationary in τ, so that only the explicit dependence on Ω counts. With σ = τ/Ω = γ + ξ of the border's
//! module, T′ = −(π/2Ω²)/cos²β and cos σ + T sin σ = cos(σ − β)/cos β,
//!
//! ```text
//! S′ = −S/Ω − [τ cos ξ/|cos β| + sgn T (π/2)(cos τ − cos σ)/cos²β]/(Ω³ sin τ).
//! ```
//!
//! The border is smooth but at two kinds of points below Ω = 1/2. At Ω = 1/(2n) both pieces have the slope
//! −2/Ω³ and only the second derivative jumps, because S − 1/Ω² is of the order T². At the end Ω_e of the
//! band next to a pole, where the two values of S cross, the slope jumps: [`Border::slope`] gives that of the
//! side whose S is the larger one as rounded.

use super::Border;
use super::stationary::inner_change;
use crate::cycle::phase_function::{PhaseFunction, one_minus_square};
use crate::float::Float;

impl<F: Float> Border<F> {
    /// The derivative dα_min/dΩ of the exact border at the frequency ratio of `p`.
    ///
    /// This is a closed form except for the bracketed root of the border. No float is a pole 1/(2n+1), so
    /// that it is finite for every float Ω unless its value overflows: at f64 it can for Ω below 2⁻²³⁶. Accuracy at
    /// f64: a few units in the last place of the larger of its two terms, so that near a minimum of the
    /// border the accuracy is absolute.
    #[must_use]
    pub fn slope(p: &PhaseFunction<F>) -> F {
        let border = Self::at(p);
        border.relative_slope(p) * border.min_force_ratio / p.omega()
    }

    /// `Ω α_min′/α_min = [K (Ω K′) + b (Ω b′)]/α_min²`, in quotients that stay in range for any Ω.
    fn relative_slope(&self, p: &PhaseFunction<F>) -> F {
        let (omega, k, alpha) = (p.omega(), p.value(), self.min_force_ratio);
        let (s, q) = (self.least_displacement, one_minus_square(omega));
        let (b, b_change) = if self.border_phase == F::int(0) {
            let inverse_square = F::int(1) / omega.square();
            (q * inverse_square, F::int(-2) * inverse_square)
        } else {
            (q * s, q * inner_change(p) - F::int(2) * omega.square() * s)
        };
        k / alpha * (omega * p.slope() / alpha) + b / alpha * (b_change / alpha)
    }
}

#[cfg(test)]
mod tests {
    use super::{Border, PhaseFunction};

    fn slope(omega: f64) -> f64 {
        Border::slope(&PhaseFunction::new(omega).unwrap())
    }

    #[test]
    fn values_at_forty_digits() {
        // The derivative of the border by mpmath, by differences at 60 digits.
        for (omega, exact) in [
            (0.07, -32_321.812_170_538_575),
            (0.13, -849.344_343_609_495_9),
            (0.21, -4_466.718_529_588_457),
            (0.22, -1_102.816_022_636_625_1),
            (0.299, 13.822_988_511_730_633),
            (0.3, 386.268_561_975_801_33),
            (0.31, 781.169_942_710_029),
            (0.35, -1_522.901_126_149_316_7),
            (0.4, -97.463_209_876_333_75),
            (0.45, -32.450_529_155_299_46),
            (0.499, -16.193_928_840_325_37),
            (0.55, -10.928_439_068_699_52),
            (0.7, -2.934_145_466_965_71),
            (0.84, -0.089_331_772_447_681_85),
            (0.95, 0.548_813_596_980_087_4),
            (1.2, 0.596_645_630_131_612_2),
            (2.5, 0.093_621_472_504_785_67),
            (40.0, 2.41290131119934e-05),
        ] {
            let found = slope(omega);
            assert!((found / exact - 1.0f64).abs() < 1e-14, "{omega}: {found} against {exact}");
        }
    }

    #[test]
    fn one_slope_on_both_sides_of_one_over_2n() {
        for n in [1.0f64, 2.0, 4.0] {
            let omega = 0.5 / n;
            let both = [slope(omega), slope(omega.next_down()), slope(omega.next_up())];
            for found in both {
                assert!((found / (-2.0 / omega.powi(3)) - 1.0).abs() < 1e-13, "{omega} {found}");
            }
        }
    }

    #[test]
    fn the_relative_slope_grows_like_the_inverse_distance_from_a_pole() {
        let p = PhaseFunction::<f64>::new((1.0 + 1e-9) / 3.0).unwrap();
        assert!((Border::at(&p).relative_slope(&p) * 1e-9 + 1.0).abs() < 1e-6);
    }
}
