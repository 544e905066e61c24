//! `num_traits::real::Real`: the functions of a real number, each rounded once except for three that state
//! their roundings.

use super::Mp;
use num_traits::real::Real;

impl<const LIMBS: usize> Mp<LIMBS> {
    pub(super) fn is_sign_positive(self) -> bool {
        !self.is_nan() && !self.is_sign_negative()
    }
    pub(super) fn recip(self) -> Self {
        Self::of_int(1) / self
    }
    /// Rounded three times.
    pub(super) fn log(self, base: Self) -> Self {
        self.ln() / base.ln()
    }
    pub(super) fn max(self, other: Self) -> Self {
        if self >= other || other.is_nan() { self } else { other }
    }
    pub(super) fn min(self, other: Self) -> Self {
        if self <= other || other.is_nan() { self } else { other }
    }
}

impl<const LIMBS: usize> Real for Mp<LIMBS> {
    same_name! {
        floor(); ceil(); round(); trunc(); fract(); abs(); sqrt(); cbrt();
        sin(); cos(); tan(); asin(); acos(); atan(); sinh(); cosh(); tanh(); asinh(); acosh(); atanh();
        exp(); exp2(); exp_m1(); ln(); log2(); log10(); ln_1p();
        mul_add(a, b); hypot(other); powf(n); atan2(other); powi(n: i32); sin_cos() -> (Self, Self);
        recip(); log(base); max(other); min(other); is_sign_positive() -> bool; is_sign_negative() -> bool;
    }
    fn min_value() -> Self {
        -Self::largest()
    }
    fn max_value() -> Self {
        Self::largest()
    }
    fn min_positive_value() -> Self {
        Self::ZERO.ulp()
    }
    fn epsilon() -> Self {
        Self::of_int(1).ulp()
    }
    fn signum(self) -> Self {
        num_traits::Signed::signum(&self)
    }
    /// Rounded three times.
    fn to_degrees(self) -> Self {
        self * (Self::of_int(180) / Self::pi())
    }
    /// Rounded three times.
    fn to_radians(self) -> Self {
        self * (Self::pi() / Self::of_int(180))
    }
    fn abs_sub(self, other: Self) -> Self {
        num_traits::Signed::abs_sub(&self, &other)
    }
}
