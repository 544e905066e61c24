//! The quantities of Ω ≥ 1/2 that the velocity depends on, in one form through Ω = 1 and up to the largest Ω.
//!
//! With `T = tan β`, `u = (1 − sin β)/cos β = tan(π/4 − β/2)`, t = 1/Ω and z = (1 − t)², the zero and the
//! pole of u are rational in t, and the remaining factor is almost constant:
//!
//! ```text
//! u = (Ω − 1) Ω/((Ω + 1)(3Ω − 1)) U(z),   0 ≤ z ≤ 1,   U from π to 3.
//! ```

use crate::float::Float;
use crate::float::circular::polynomial;
use crate::float::pair::Pair;

/// The coefficients of U from the constant term up: interpolated at Chebyshev nodes, computed with 60 digits
/// and rounded. The error is 5.6e-17.
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

/// The coefficients of U in a number type.
#[derive(Clone, Copy)]
pub(crate) struct Offset<F>([F; 8]);

impl<F: Float> Offset<F> {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self(U.map(F::from_f64))
    }
}

/// The quantities of Ω that the velocity depends on; none has a pole.
#[derive(Clone, Copy)]
pub(crate) struct Frequency<F> {
    pub(crate) omega: F,
    /// 1/Ω.
    pub(crate) inverse: F,
    /// `κ = (1 − Ω) T = KΩ/(1 + Ω)`.
    pub(crate) kappa: F,
    /// `u/(Ω − 1)`.
    pub(crate) offset_slope: F,
}

impl<F: Float> Frequency<F> {
    /// From Ω ≥ 1/2 and K(Ω).
    #[inline(always)]
    pub(crate) fn new(offset: &Offset<F>, omega: F, phase_function: Pair<F>) -> Self {
        let one = F::int(1);
        let inverse = one / omega;
        let from_one = (omega - one) * inverse;
        let shared = omega / (one + omega);
        Self {
            omega,
            inverse,
            // κ = KΩ/(1 + Ω)
            kappa: phase_function.hi.mul_add(shared, phase_function.lo * shared),
            offset_slope: polynomial(&offset.0, from_one * from_one) * shared
                / F::int(3).mul_add(omega, -one),
        }
    }

    /// `u = (1 − sin β)/cos β = tan(π/4 − β/2)`.
    #[inline(always)]
    pub(crate) fn offset(&self) -> F {
        (self.omega - F::int(1)) * self.offset_slope
    }

    /// `F = −(1 − Ω²)/cos β`, the forcing in v″ + Ω²v = F sin ψ, with 1/cos β = T + u.
    #[inline(always)]
    pub(crate) fn forcing(&self) -> F {
        let less = F::int(1) - self.omega;
        -(F::int(1) + self.omega) * less.mul_add(self.offset(), self.kappa)
    }

    /// `(sin β, cos β)`.
    #[inline(always)]
    pub(crate) fn sin_cos_beta(&self) -> (F, F) {
        let (u, one) = (self.offset(), F::int(1));
        let quotient = F::int(2) / u.mul_add(u, one);
        // sin β = (1 − u²)/(1 + u²), which is small far above Ω = 1.
        let beside_one = (one - u) * (one + u) * (quotient * F::ratio(1, 2));
        let above = -(self.kappa * self.offset_slope * quotient);
        (if self.omega < F::int(2) { beside_one } else { above }, u * quotient)
    }
}
