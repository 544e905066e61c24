//! `nalgebra::RealField`, so that nalgebra's matrices and its LU run over [`Mp`].

use super::Mp;
use approx::{AbsDiffEq, RelativeEq, UlpsEq};
use nalgebra::{ComplexField, Field, RealField, SimdValue};
use num_traits::FloatConst;
use simba::scalar::SubsetOf;

impl<const LIMBS: usize> Field for Mp<LIMBS> {}

impl<const LIMBS: usize> SimdValue for Mp<LIMBS> {
    const LANES: usize = 1;
    type Element = Self;
    type SimdBool = bool;

    fn splat(value: Self) -> Self {
        value
    }
    fn extract(&self, _: usize) -> Self {
        *self
    }
    #[expect(unsafe_code, reason = "the trait names it so; there is one lane, and no access unchecked")]
    unsafe fn extract_unchecked(&self, _: usize) -> Self {
        *self
    }
    fn replace(&mut self, _: usize, value: Self) {
        *self = value;
    }
    #[expect(unsafe_code, reason = "the trait names it so; there is one lane, and no access unchecked")]
    unsafe fn replace_unchecked(&mut self, _: usize, value: Self) {
        *self = value;
    }
    fn select(self, condition: bool, other: Self) -> Self {
        if condition { self } else { other }
    }
}

impl<const LIMBS: usize> SubsetOf<Self> for Mp<LIMBS> {
    fn to_superset(&self) -> Self {
        *self
    }
    fn from_superset_unchecked(element: &Self) -> Self {
        *element
    }
    fn is_in_subset(_: &Self) -> bool {
        true
    }
}

macro_rules! primitive_subset {
    ($($primitive:ident by $to:ident)*) => {$(
        /// All real types count as the same set, as between `f32` and `f64`.
        impl<const LIMBS: usize> SubsetOf<Mp<LIMBS>> for $primitive {
            fn to_superset(&self) -> Mp<LIMBS> {
                (*self).into()
            }
            fn from_superset_unchecked(element: &Mp<LIMBS>) -> Self {
                element.$to()
            }
            fn is_in_subset(_: &Mp<LIMBS>) -> bool {
                true
            }
        }
    )*};
}
primitive_subset!(f32 by to_f32 f64 by to_f64);

impl<const LIMBS: usize> AbsDiffEq for Mp<LIMBS> {
    type Epsilon = Self;
    fn default_epsilon() -> Self {
        crate::Float::epsilon()
    }
    fn abs_diff_eq(&self, other: &Self, epsilon: Self) -> bool {
        self == other || (*self - *other).abs() <= epsilon
    }
}

impl<const LIMBS: usize> RelativeEq for Mp<LIMBS> {
    fn default_max_relative() -> Self {
        crate::Float::epsilon()
    }
    fn relative_eq(&self, other: &Self, epsilon: Self, max_relative: Self) -> bool {
        let larger = RealField::max(self.abs(), other.abs());
        self.abs_diff_eq(other, epsilon)
            || (larger.is_finite() && (*self - *other).abs() <= larger * max_relative)
    }
}

impl<const LIMBS: usize> UlpsEq for Mp<LIMBS> {
    fn default_max_ulps() -> u32 {
        4
    }
    fn ulps_eq(&self, other: &Self, epsilon: Self, max_ulps: u32) -> bool {
        let ulp = RealField::max(self.ulp(), other.ulp());
        self.abs_diff_eq(other, epsilon)
            || (self.is_sign_negative() == other.is_sign_negative()
                && (*self - *other).abs() <= ulp * Self::from(max_ulps))
    }
}

macro_rules! identity {
    ($($name:ident)*) => {$(
        fn $name(self) -> Self {
            self
        }
    )*};
}

impl<const LIMBS: usize> ComplexField for Mp<LIMBS> {
    type RealField = Self;

    identity! { real conjugate }
    same_name! {
        floor(); ceil(); round(); trunc(); fract(); abs(); sqrt(); cbrt();
        sin(); cos(); tan(); asin(); acos(); atan(); sinh(); cosh(); tanh(); asinh(); acosh(); atanh();
        exp(); exp2(); exp_m1(); ln(); log2(); log10(); ln_1p();
        mul_add(a, b); hypot(other); powf(n); powi(n: i32); sin_cos() -> (Self, Self); recip(); log(base);
    }
    fn from_real(re: Self) -> Self {
        re
    }
    fn imaginary(self) -> Self {
        Self::ZERO
    }
    fn modulus(self) -> Self {
        self.abs()
    }
    fn modulus_squared(self) -> Self {
        self.square()
    }
    fn argument(self) -> Self {
        if self >= Self::ZERO { Self::ZERO } else { Self::pi() }
    }
    fn norm1(self) -> Self {
        self.abs()
    }
    fn scale(self, factor: Self) -> Self {
        self * factor
    }
    fn unscale(self, factor: Self) -> Self {
        self / factor
    }
    fn powc(self, n: Self) -> Self {
        self.powf(n)
    }
    fn is_finite(&self) -> bool {
        (*self).is_finite()
    }
    fn try_sqrt(self) -> Option<Self> {
        (self >= Self::ZERO).then(|| self.sqrt())
    }
}

macro_rules! constants {
    ($($name:ident = $constant:ident;)*) => {$(
        fn $name() -> Self {
            <Self as FloatConst>::$constant()
        }
    )*};
}

impl<const LIMBS: usize> RealField for Mp<LIMBS> {
    constants! {
        pi = PI; two_pi = TAU; frac_pi_2 = FRAC_PI_2; frac_pi_3 = FRAC_PI_3; frac_pi_4 = FRAC_PI_4;
        frac_pi_6 = FRAC_PI_6; frac_pi_8 = FRAC_PI_8; frac_1_pi = FRAC_1_PI; frac_2_pi = FRAC_2_PI;
        frac_2_sqrt_pi = FRAC_2_SQRT_PI; e = E; log2_e = LOG2_E; log10_e = LOG10_E; ln_2 = LN_2; ln_10 = LN_10;
    }
    same_name! { max(other); min(other); atan2(other); }
    fn is_sign_positive(&self) -> bool {
        (*self).is_sign_positive()
    }
    fn is_sign_negative(&self) -> bool {
        (*self).is_sign_negative()
    }
    fn copysign(self, sign: Self) -> Self {
        if sign.is_sign_negative() { -self.abs() } else { self.abs() }
    }
    fn clamp(self, min: Self, max: Self) -> Self {
        if self < min {
            min
        } else if self > max {
            max
        } else {
            self
        }
    }
    fn min_value() -> Option<Self> {
        Some(-Self::largest())
    }
    fn max_value() -> Option<Self> {
        Some(Self::largest())
    }
}
