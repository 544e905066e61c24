//! Circular functions on the bounded angles a batch needs, without branches.
//!
//! Polynomials and quotients that interpolate at Chebyshev nodes, found at 60 digits and rounded; the errors below are those
//! of the rounded coefficients, without the rounding of their evaluation:
//!
//! | function | on | form | error |
//! |---|---|---|---|
//! | tan w | \|w\| ≤ π/4 | w P₃(w²)/Q₄(w²) | 1.8e-17 of it |
//! | sin x | \|x\| ≤ π/2 | x (1 + x² S₇(x²)) | 3.6e-17 of it |
//! | cos x | \|x\| ≤ π/2 | 1 − x²/2 + x⁴ C₇(x²) | 1.5e-17 |
//! | atan t | \|t\| ≤ tan π/8 | t (1 + t² A₁₀(t²)) | 7.1e-18 of it |

/// Coefficients from the constant term up.
const TAN_NUMERATOR: [f64; 4] =
    [1.0, -0.133_376_704_658_223_54, 0.003_424_063_140_443_030_7, -1.784_788_388_205_453e-5];
const TAN_DENOMINATOR: [f64; 5] = [
    1.0,
    -0.466_710_037_991_556_86,
    0.025_660_742_470_962_002,
    -0.000_311_677_610_249_349_43,
    4.975_309_970_811_631e-7,
];
const SIN: [f64; 8] = [
    -0.166_666_666_666_666_66,
    0.008_333_333_333_333_316,
    -0.000_198_412_698_412_549_74,
    2.755_731_921_916_323_4e-6,
    -2.505_210_761_699_618_2e-8,
    1.605_897_731_246_407e-10,
    -7.643_970_296_797_94e-13,
    2.731_444_766_978_509_3e-15,
];
const COS: [f64; 8] = [
    0.041_666_666_666_666_664,
    -0.001_388_888_888_888_888,
    2.480_158_730_157_985e-5,
    -2.755_731_922_156_956_3e-7,
    2.087_675_660_287_546_3e-9,
    -1.147_071_227_274_945_7e-11,
    4.777_877_925_245_528_5e-14,
    -1.521_863_836_920_402_4e-16,
];
const ATAN: [f64; 11] = [
    -0.333_333_333_333_333_3,
    0.199_999_999_999_955_2,
    -0.142_857_142_846_665_42,
    0.111_111_110_152_563_61,
    -0.090_909_045_781_238_98,
    0.076_921_831_908_260_21,
    -0.066_645_114_473_810_26,
    0.058_581_489_127_942_026,
    -0.050_854_497_378_983_586,
    0.039_231_658_294_376_685,
    -0.019_176_887_117_579_786,
];

/// A polynomial by Horner's rule, fused.
#[inline(always)]
fn polynomial<const N: usize>(coefficients: &[f64; N], z: f64) -> f64 {
    let mut falling = coefficients.iter().rev();
    let first = falling.next().copied().unwrap_or(0.0);
    falling.fold(first, |sum, &c| f64::mul_add(sum, z, c))
}

/// `(P, Q)` with `tan w = w P/Q` for |w| ≤ π/4, both near 1: the quotient is left to be merged with others.
#[inline(always)]
pub(crate) fn tan_quotient(w: f64) -> (f64, f64) {
    let z = w * w;
    (polynomial(&TAN_NUMERATOR, z), polynomial(&TAN_DENOMINATOR, z))
}

/// `((sin x)/x, cos x)` for |x| ≤ π/2.
#[inline(always)]
pub(crate) fn sinc_cos(x: f64) -> (f64, f64) {
    let z = x * x;
    let cosine = polynomial(&COS, z).mul_add(z, -0.5).mul_add(z, 1.0);
    (polynomial(&SIN, z).mul_add(z, 1.0), cosine)
}

/// `(sin x, cos x)` for |x| ≤ π/2.
#[inline(always)]
pub(crate) fn sin_cos(x: f64) -> (f64, f64) {
    let (sinc, cosine) = sinc_cos(x);
    // x + x·(sinc − 1) would be more accurate by a third of a unit in the last place, at the price of one operation.
    (x * sinc, cosine)
}

/// The angle in [0, π/2] of the point with ordinate `y` ≥ 0 and abscissa `x` ≥ 0.
///
/// With `r = hypot(x, y)` its half has the tangent `y/(x + r)`, at most 1; beyond tan π/8 that is taken from π/4.
#[inline(always)]
pub(crate) fn first_quadrant_angle(y: f64, x: f64, r: f64) -> f64 {
    use core::f64::consts::FRAC_PI_2;
    let sum = x + r;
    // tan(a − π/4) = (tan a − 1)/(tan a + 1)
    let beyond = y > 0.414_213_562_373_095_05 * sum;
    let numerator = if beyond { y - sum } else { y };
    let denominator = if beyond { y + sum } else { sum };
    let t = numerator / denominator;
    let z = t * t;
    let tail = polynomial(&ATAN, z) * z * t;
    let base = if beyond { FRAC_PI_2 } else { 0.0 };
    2.0f64.mul_add(t + tail, base)
}

#[cfg(test)]
mod tests {
    use super::{first_quadrant_angle, sin_cos, tan_quotient};
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

    /// Within `ulps` of the system's own, which is right to one unit in the last place.
    fn close(a: f64, b: f64, scale: f64, ulps: f64, at: f64) {
        assert!((a - b).abs() <= ulps * f64::EPSILON * scale, "at {at}: {a:e} against {b:e}");
    }

    #[test]
    fn as_the_system_has_them() {
        for i in -20_000..=20_000 {
            let x = f64::from(i) / 20_000.0;
            let (s, c) = sin_cos(x * FRAC_PI_2);
            let (s0, c0) = (x * FRAC_PI_2).sin_cos();
            close(s, s0, s0.abs(), 1.5, x);
            close(c, c0, 1.0, 1.0, x);
            let w = x * FRAC_PI_4;
            let (p, q) = tan_quotient(w);
            close(w * p / q, w.tan(), w.tan().abs(), 2.5, x);
            let angle = x.abs() * FRAC_PI_2;
            let (y, x) = angle.sin_cos();
            close(first_quadrant_angle(y, x.abs(), x.hypot(y)), y.atan2(x.abs()), angle, 2.0, angle);
        }
    }
}
