//! Circular functions on bounded angles, without branches, so that loops over them can be vectorised.
//!
//! They are polynomials that interpolate at Chebyshev nodes, computed with 60 digits and rounded. The errors
//! below are those of the rounded coefficients, without the rounding of the evaluation:
//!
//! | function | on | form | error |
//! |---|---|---|---|
//! | sin x | \|x\| ≤ π/2 | x (1 + x² S₇(x²)) | 3.6e-17 of it |
//! | cos x | \|x\| ≤ π/2 | 1 − x²/2 + x⁴ C₇(x²) | 1.5e-17 |
//! | sin x | \|x\| ≤ 1.0625 | x + x³ S₆(x²) | 9.2e-18 of it |
//! | cos x | \|x\| ≤ 1.0625 | 1 − x²/2 + x⁴ C₅(x²) | 6.5e-17 |
//! | sin x | \|x\| ≤ 0.28125 | x (1 + x² S₄(x²)) | 6.7e-19 of it |
//! | cos x | \|x\| ≤ 0.28125 | 1 − x²/2 + x⁴ C₃(x²) | 4.0e-18 |
//! | atan t | \|t\| ≤ tan π/8 | t (1 + t² A₁₀(t²)) | 7.1e-18 of it |
//! | 6 (sinh √z)/√z − 6 | −5/2 ≤ z ≤ 6 | z + z² H₈(z) | 1.5e-17 of it |
//! | 2 cosh √z − 2 | −5/2 ≤ z ≤ 6 | z + z² K₈(z) | 2.4e-17 of it |

use super::Float;
use super::pair::Pair;
use core::ops::Neg;

/// Coefficients of S and C in the table, from the constant term up.
#[derive(Clone, Copy)]
pub(crate) struct SinCos<F, const S: usize, const C: usize> {
    sin: [F; S],
    cos: [F; C],
}

/// For |x| ≤ π/2.
pub(crate) const TO_HALF_PI: SinCos<f64, 8, 8> = SinCos {
    sin: [
        -0.166_666_666_666_666_66,
        0.008_333_333_333_333_316,
        -0.000_198_412_698_412_549_74,
        2.755_731_921_916_323_4e-6,
        -2.505_210_761_699_618_2e-8,
        1.605_897_731_246_407e-10,
        -7.643_970_296_797_94e-13,
        2.731_444_766_978_509_3e-15,
    ],
    cos: [
        0.041_666_666_666_666_664,
        -0.001_388_888_888_888_888,
        2.480_158_730_157_985e-5,
        -2.755_731_922_156_956_3e-7,
        2.087_675_660_287_546_3e-9,
        -1.147_071_227_274_945_7e-11,
        4.777_877_925_245_528_5e-14,
        -1.521_863_836_920_402_4e-16,
    ],
};
/// For |x| ≤ 1.0625.
pub(crate) const TO_ONE: SinCos<f64, 7, 6> = SinCos {
    sin: [
        -0.166_666_666_666_666_66,
        0.008_333_333_333_333_264,
        -0.000_198_412_698_411_722_87,
        2.755_731_917_211_878_7e-6,
        -2.505_209_525_046_19e-8,
        1.605_733_547_624_149e-10,
        -7.536_853_922_235_775e-13,
    ],
    cos: [
        0.041_666_666_666_666_616,
        -0.001_388_888_888_885_841_7,
        2.480_158_727_008_862e-5,
        -2.755_730_731_261_133_6e-7,
        2.087_471_996_537_950_4e-9,
        -1.130_999_282_121_549_6e-11,
    ],
};
/// For |x| ≤ 0.28125.
pub(crate) const TO_QUARTER: SinCos<f64, 5, 4> = SinCos {
    sin: [
        -0.166_666_666_666_666_66,
        0.008_333_333_333_332_719,
        -0.000_198_412_698_350_657_76,
        2.755_729_726_120_461e-6,
        -2.502_037_042_989_127e-8,
    ],
    cos: [
        0.041_666_666_666_666_026,
        -0.001_388_888_888_630_789_6,
        2.480_157_098_597_306e-5,
        -2.752_431_127_195_208_5e-7,
    ],
};
/// Coefficients of A in the table, from the constant term up.
#[derive(Clone, Copy)]
pub(crate) struct Arctangent<F>([F; 11]);

/// The coefficients for |t| ≤ tan π/8.
pub(crate) const ARCTANGENT: Arctangent<f64> = Arctangent([
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
]);

/// Hyperbolic functions of √z, which are the circular ones of √−z for z < 0: coefficients of H and K in the table, from
/// the constant term up.
#[derive(Clone, Copy)]
pub(crate) struct Swell<F> {
    sine: [F; 9],
    cosine: [F; 9],
}

/// The coefficients for −5/2 ≤ z ≤ 6.
const SWELL: Swell<f64> = Swell {
    sine: [
        0.05,
        0.001_190_476_190_476_191_2,
        1.653_439_153_439_220_3e-5,
        1.503_126_503_118_959_9e-7,
        9.635_426_300_322_157e-10,
        4.588_298_448_821_065e-12,
        1.686_873_251_779_601_4e-14,
        4.930_720_645_458_878e-17,
        1.211_630_237_969_436_4e-19,
    ],
    cosine: [
        0.083_333_333_333_333_33,
        0.002_777_777_777_777_783_5,
        4.960_317_460_317_975e-5,
        5.511_463_844_739_222e-7,
        4.175_351_396_212_049e-9,
        2.294_149_280_687_92e-11,
        9.558_946_228_817_105e-14,
        3.122_565_299_811_282e-16,
        8.506_720_142_810_93e-19,
    ],
};

impl<F: Float> Swell<F> {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self { sine: SWELL.sine.map(F::from_f64), cosine: SWELL.cosine.map(F::from_f64) }
    }

    /// `(6 (sinh √z)/√z − 6, 2 cosh √z − 2)`, exact except for the roundings of all but the leading term.
    #[inline(always)]
    pub(crate) fn at(&self, z: Pair<F>) -> (Pair<F>, Pair<F>) {
        (led(z, &self.sine), led(z, &self.cosine))
    }
}

/// `z + z² p(z)`, |z p(z)| ≤ 1.
#[inline(always)]
fn led<F: Float, const N: usize>(z: Pair<F>, coefficients: &[F; N]) -> Pair<F> {
    let bend = polynomial(coefficients, z.hi) * z.hi;
    let hi = bend.mul_add(z.hi, z.hi);
    Pair::new(hi, bend.mul_add(z.hi, z.hi - hi) + (bend + bend).mul_add(z.lo, z.lo))
}

/// Hides the coefficients' values from the compiler. It then keeps each in a vector register for the whole
/// loop instead of rebuilding it from the constant at every use, a quarter of a loop's instructions with
/// AVX2.
#[cfg(feature = "batch")]
#[inline(always)]
pub(crate) fn held<T>(coefficients: T) -> T {
    core::hint::black_box(coefficients)
}

/// A polynomial by Horner's rule, with fused operations.
#[inline(always)]
pub(crate) fn polynomial<F: Float, const N: usize>(coefficients: &[F; N], z: F) -> F {
    let mut falling = coefficients.iter().rev();
    let first = falling.next().copied().unwrap_or(z);
    falling.fold(first, |sum, &c| sum.mul_add(z, c))
}

impl<const S: usize, const C: usize> SinCos<f64, S, C> {
    /// These coefficients in another number type.
    #[inline(always)]
    pub(crate) fn of<F: Float>(&self) -> SinCos<F, S, C> {
        SinCos { sin: self.sin.map(F::from_f64), cos: self.cos.map(F::from_f64) }
    }
}

impl<F: Float, const S: usize, const C: usize> SinCos<F, S, C> {
    /// `(sin x, cos x)`.
    #[inline(always)]
    pub(crate) fn sin_cos(&self, x: F) -> (F, F) {
        let z = x * x;
        ((polynomial(&self.sin, z) * z).mul_add(x, x), self.cos(z))
    }

    /// `(sin x, cos x − 1)`.
    #[inline(always)]
    pub(crate) fn sin_fall(&self, x: F) -> (F, F) {
        let z = x * x;
        let bend = polynomial(&self.cos, z).mul_add(z, -F::ratio(1, 2));
        ((polynomial(&self.sin, z) * z).mul_add(x, x), bend * z)
    }

    /// `(sin x, cos x)`, exact except for the roundings of all but the leading terms.
    #[inline(always)]
    pub(crate) fn wide(&self, x: Pair<F>) -> (Pair<F>, Pair<F>) {
        let (one, half) = (F::int(1), F::ratio(1, 2));
        let square = Pair::two_prod(x.hi, x.hi);
        let z = square.hi;
        // sin x − x and cos x − 1 + x²/2
        let (bend, rest) = (polynomial(&self.sin, z) * z * x.hi, polynomial(&self.cos, z) * z * z);
        let fall = Pair::fast_two_sum(one, -(half * z));
        let (sine, cosine) = (x.hi + bend, fall.hi + rest);
        let less = (-half).mul_add(square.lo, fall.lo);
        (
            Pair::fast_two_sum(x.hi, cosine.mul_add(x.lo, bend)),
            Pair::fast_two_sum(fall.hi, (-sine).mul_add(x.lo, less) + rest),
        )
    }

    /// `((sin x)/x, cos x)`.
    #[inline(always)]
    pub(crate) fn sinc_cos(&self, x: F) -> (F, F) {
        let z = x * x;
        (polynomial(&self.sin, z).mul_add(z, F::int(1)), self.cos(z))
    }

    #[inline(always)]
    fn cos(&self, square: F) -> F {
        polynomial(&self.cos, square).mul_add(square, -F::ratio(1, 2)).mul_add(square, F::int(1))
    }
}

impl Arctangent<f64> {
    /// These coefficients in another number type.
    #[inline(always)]
    pub(crate) fn of<F: Float>(&self) -> Arctangent<F> {
        Arctangent(self.0.map(F::from_f64))
    }
}

impl<F: Float> SinCos<F, 8, 8> {
    /// `(sin y, cos y)` for y in [0, π].
    #[inline(always)]
    pub(crate) fn upper(&self, angle: F) -> (F, F) {
        let (s, c) = self.sin_cos(angle - F::pi() * F::ratio(1, 2));
        (c, -s)
    }

    /// `(sin x, cos x)` for |x| up to some thousands.
    #[inline(always)]
    pub(crate) fn turned(&self, x: F) -> (F, F) {
        let (half, (rest, _)) = (F::ratio(1, 2), F::pi_rest());
        let turns = (x * (F::int(2) / F::pi())).round();
        let acute = (-turns).mul_add(half * rest, (-turns).mul_add(half * F::pi(), x));
        by_quarters(turns, self.sin_cos(acute))
    }
}

/// (sin, cos) of `q π/2 + w` from those of w, for an integer q of either sign; without branches.
#[inline(always)]
pub(crate) fn by_quarters<F: Float, R: Copy + Neg<Output = R>>(q: F, (s, c): (R, R)) -> (R, R) {
    // q mod 4, in {−2, −1, 0, 1, 2}
    let quarter = F::int(-4).mul_add((q * F::ratio(1, 4)).round(), q);
    let is_odd = quarter.abs() == F::int(1);
    let (s, c) = if is_odd { (c, -s) } else { (s, c) };
    let is_turned = (quarter.abs() == F::int(2)) | (quarter == F::int(-1));
    if is_turned { (-s, -c) } else { (s, c) }
}

/// Coefficients of `eʳ = 1 + r + r² E(r)`.
#[derive(Clone, Copy)]
pub(crate) struct Exponential<F>([F; 13]);

impl<F: Float> Exponential<F> {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self(RECIPROCAL_FACTORIALS.map(F::from_f64))
    }

    /// `eˣ` for |x| up to [`Float::RATIO_EXPONENT`]/2, within two units in the last place.
    #[inline(always)]
    pub(crate) fn at(&self, x: F) -> F {
        let (one, (hi, lo)) = (F::int(1), LN_2);
        let n = (x * F::from_f64(core::f64::consts::LOG2_E)).round();
        let hi_rest = hi - F::from_f64(hi).to_f64();
        let r = (-n).mul_add(F::from_f64(hi), x);
        let r = (-n).mul_add(F::from_f64(hi_rest + lo), r);
        polynomial(&self.0, r).mul_add(r * r, r + one) * F::power_of_two(n)
    }
}

/// ln 2, to twice the digits of f64.
pub(crate) const LN_2: (f64, f64) = (core::f64::consts::LN_2, 2.319_046_813_846_299_6e-17);

/// 1/n!, n from 2 to 14.
pub(crate) const RECIPROCAL_FACTORIALS: [f64; 13] = [
    1.0 / 2.0,
    1.0 / 6.0,
    1.0 / 24.0,
    1.0 / 120.0,
    1.0 / 720.0,
    1.0 / 5040.0,
    1.0 / 40_320.0,
    1.0 / 362_880.0,
    1.0 / 3_628_800.0,
    1.0 / 39_916_800.0,
    1.0 / 479_001_600.0,
    1.0 / 6_227_020_800.0,
    1.0 / 87_178_291_200.0,
];

impl<F: Float> Arctangent<F> {
    /// The angle in [0, π] with this sine ≥ 0 and this cosine.
    #[inline(always)]
    pub(crate) fn angle(&self, sine: F, cosine: F) -> F {
        let acute = self.first_quadrant_angle(sine, cosine.abs(), F::int(1));
        if cosine < F::int(0) { F::pi() - acute } else { acute }
    }

    /// The angle in [0, π/2] of the point with ordinate `y` ≥ 0 and abscissa `x` ≥ 0.
    ///
    /// With `r = hypot(x, y)`, half the angle has the tangent `y/(x + r)`, which is at most 1. Beyond tan π/8
    /// the half angle is measured from π/4.
    #[inline(always)]
    pub(crate) fn first_quadrant_angle(&self, y: F, x: F, r: F) -> F {
        let sum = x + r;
        // tan(a − π/4) = (tan a − 1)/(tan a + 1)
        let beyond = y > F::ratio(29, 70) * sum;
        let numerator = if beyond { y - sum } else { y };
        let denominator = if beyond { y + sum } else { sum };
        let t = numerator / denominator;
        let z = t * t;
        let tail = polynomial(&self.0, z) * z * t;
        let base = if beyond { F::pi() * F::ratio(1, 2) } else { F::int(0) };
        F::int(2).mul_add(t + tail, base)
    }
}

/// (sin x/x, cos x) by their series for |x| ≤ 3/8, for types with no more digits than f64.
#[inline]
pub(crate) fn sinc_cos_small<F: Float>(x: F) -> Option<(F, F)> {
    let square = x * x;
    if F::PRECISION > f64::MANTISSA_DIGITS || square > F::ratio(9, 64) {
        return None;
    }
    let series = |first: i32, last: i32| {
        (first..=last).rev().step_by(2).fold(F::int(1), |sum, k| {
            F::int(1) - square * F::ratio(1, k.saturating_mul(k.saturating_add(1))) * sum
        })
    };
    Some((series(2, 12), F::int(1) - square * F::ratio(1, 2) * series(3, 11)))
}

#[cfg(test)]
mod tests {
    use super::{ARCTANGENT, TO_HALF_PI, TO_ONE, TO_QUARTER, sinc_cos_small};
    use std::f64::consts::FRAC_PI_2;

    /// The errors of the wide functions, against 256 bits.
    #[cfg(feature = "mp")]
    #[test]
    fn wide_has_a_third_of_a_unit() {
        use super::Pair;
        use crate::float::mp::Mp;
        let (mut worst_sine, mut worst_cosine): (f64, f64) = (0.0, 0.0);
        for i in 1..=20_000 {
            let x = Pair::new(f64::from(i) / 20_000.0 * 1.0625, 1e-17);
            let (s, c) = TO_HALF_PI.wide(x);
            let (sine, cosine) = (Mp::<4>::from(x.hi) + Mp::from(x.lo)).sin_cos();
            let off = |found: Pair<f64>, exact: Mp<4>| {
                ((Mp::from(found.hi) + Mp::from(found.lo) - exact) / exact).abs().to_f64() / f64::EPSILON
            };
            (worst_sine, worst_cosine) = (worst_sine.max(off(s, sine)), worst_cosine.max(off(c, cosine)));
        }
        assert!(worst_sine < 0.34 && worst_cosine < 0.34, "{worst_sine} {worst_cosine}");
    }

    /// Within `ulps` of the platform's own function, which is accurate to one unit in the last place.
    fn close(a: f64, b: f64, scale: f64, ulps: f64, at: f64) {
        assert!((a - b).abs() <= ulps * f64::EPSILON * scale, "at {at}: {a:e} against {b:e}");
    }

    fn both((s, c): (f64, f64), x: f64) {
        close(s, x.sin(), x.sin().abs(), 1.5, x);
        close(c, x.cos(), 1.0, 1.0, x);
    }

    #[test]
    fn as_the_system_has_them() {
        for i in -20_000..=20_000 {
            let x = f64::from(i) / 20_000.0;
            both(TO_HALF_PI.sin_cos(x * FRAC_PI_2), x * FRAC_PI_2);
            both(TO_ONE.sin_cos(x * 1.0625), x * 1.0625);
            let (sinc, c) = TO_QUARTER.sinc_cos(x * 0.28125);
            both((x * 0.28125 * sinc, c), x * 0.28125);
            let angle = x.abs() * FRAC_PI_2;
            let (y, x) = f64::sin_cos(angle);
            close(
                ARCTANGENT.first_quadrant_angle(y, x.abs(), x.hypot(y)),
                y.atan2(x.abs()),
                angle,
                2.0,
                angle,
            );
        }
    }

    #[test]
    fn the_series_of_small_angles() {
        assert_eq!(sinc_cos_small(0.0), Some((1.0, 1.0)));
        for i in 1..=375 {
            let x = f64::from(i) / 1000.0;
            let (sinc, cos) = sinc_cos_small(x).unwrap();
            assert!((sinc - x.sin() / x).abs() <= 2.0 * f64::EPSILON, "{x}: {sinc}");
            assert!((cos - x.cos()).abs() <= 2.0 * f64::EPSILON, "{x}: {cos}");
        }
        assert_eq!(sinc_cos_small(0.376), None);
        assert!(sinc_cos_small(0.1f32).is_some());
        // More digits than the series has.
        #[cfg(feature = "mp")]
        assert_eq!(sinc_cos_small(crate::float::mp::Mp::<1>::of_f64(0.1)), None);
    }
}
