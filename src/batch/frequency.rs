//! What depends on the frequency ratio alone, for the points of a block: Ω ≥ 1/2, one form through Ω = 1 and to the largest Ω.
//!
//! With t = 1/Ω and the angle `y = β − π/2` up to sign, `y = (π/2)(1 − t)` in (−π/2, π/2), the zeros and the nearest poles
//! of `y cot y` and `tan y/2` are rational in t, and what is left of them is all but constant in `z = (1 − t)²`:
//!
//! ```text
//! K = (2Ω − 1)/(3Ω − 1) G(z),   u = (1 − sin β)/cos β = (Ω − 1) Ω/((Ω + 1)(3Ω − 1)) U(z),   0 ≤ z ≤ 1,
//! ```
//!
//! G from −8/π to −3π/4, U from π to 3. The polynomials interpolate at Chebyshev nodes, found at 60 digits and rounded: errors 6.8e-17 and
//! 5.6e-17 of them, without the rounding of their evaluation, G's mostly that of its constant term.

use super::block::AtPoint;
use super::circular::{held, polynomial};

/// Coefficients from the constant term up.
const G: [f64; 10] = [
    -2.546_479_089_470_325_5,
    0.184_535_785_290_451_95,
    0.005_451_195_028_801_223,
    0.000_280_237_262_390_512_44,
    1.632_442_967_132_528e-5,
    9.919_407_222_316_25e-7,
    6.125_558_826_950_89e-8,
    3.824_957_415_390_187_5e-9,
    2.249_700_067_197_29e-10,
    2.042_750_970_966_037e-11,
];
const U: [f64; 8] = [
    core::f64::consts::PI,
    -0.139_434_065_891_205_55,
    -0.002_105_771_884_153_91,
    -5.140_297_346_191_658e-5,
    -1.374_078_437_160_709e-6,
    -3.769_354_746_133_135e-8,
    -1.036_644_203_893_500_4e-9,
    -3.234_302_248_390_718_7e-11,
];

/// G.
#[derive(Clone, Copy)]
pub(crate) struct PhaseFunction([f64; 10]);

impl PhaseFunction {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self(held(G))
    }

    /// `(K, 1/Ω)`.
    #[inline(always)]
    pub(crate) fn at(&self, omega: f64) -> (f64, f64) {
        // One quotient for two.
        let thrice = omega.mul_add(3.0, -1.0);
        let shared = 1.0 / (omega * thrice);
        let inverse = thrice * shared;
        let from_one = 1.0 - inverse;
        let quotient = omega.mul_add(2.0, -1.0) * (omega * shared);
        (quotient * polynomial(&self.0, from_one * from_one), inverse)
    }
}

/// What the velocity needs of Ω, with `T = tan β`, `u = (1 − sin β)/cos β`: none has a pole.
#[derive(Clone, Copy)]
pub(crate) struct Frequency {
    pub(crate) omega: f64,
    /// 1/Ω.
    pub(crate) inverse: f64,
    /// `κ = (1 − Ω) T = KΩ/(1 + Ω)`.
    pub(crate) kappa: f64,
    /// `u/(Ω − 1)`.
    pub(crate) offset_slope: f64,
}

/// What depends on Ω alone: G and U.
#[derive(Clone, Copy)]
pub(crate) struct Parts([f64; 10], [f64; 8]);

impl Parts {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self(held(G), held(U))
    }
}

impl AtPoint<1, 4> for Parts {
    /// `[K, 1/Ω, κ, u/(Ω − 1)]`.
    #[inline(always)]
    fn at(&self, [omega]: [f64; 1]) -> [f64; 4] {
        let inverse = 1.0 / omega;
        let from_one = 1.0 - inverse;
        let z = from_one * from_one;
        // One quotient for two.
        let (one_plus, thrice) = (1.0 + omega, omega.mul_add(3.0, -1.0));
        let shared = omega / (one_plus * thrice);
        let quotient = omega.mul_add(2.0, -1.0) * polynomial(&self.0, z);
        [quotient / thrice, inverse, quotient * shared, polynomial(&self.1, z) * shared]
    }
}

impl Frequency {
    /// `u = (1 − sin β)/cos β = tan(π/4 − β/2)`.
    #[inline(always)]
    pub(crate) fn offset(&self) -> f64 {
        (self.omega - 1.0) * self.offset_slope
    }

    /// `F = −(1 − Ω²)/cos β`: v″ + Ω²v = F sin ψ. With 1/cos β = T + u.
    #[inline(always)]
    pub(crate) fn forcing(&self) -> f64 {
        let less = 1.0 - self.omega;
        -(1.0 + self.omega) * less.mul_add(self.offset(), self.kappa)
    }

    /// `(sin β, cos β)`.
    #[inline(always)]
    pub(crate) fn sin_cos_beta(&self) -> (f64, f64) {
        let u = self.offset();
        let quotient = 2.0 / u.mul_add(u, 1.0);
        (-(self.kappa * self.offset_slope * quotient), u * quotient)
    }

    /// 1/cos β, away from Ω = 1.
    #[inline(always)]
    pub(crate) fn secant(&self) -> f64 {
        self.kappa / (1.0 - self.omega) + self.offset()
    }
}
