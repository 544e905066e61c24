//! Implementations of the traits of num-traits.

use super::{Mp, ParseError};
use num_traits::{FloatConst, FromPrimitive, Inv, MulAdd, Num, NumCast, One, Pow, Signed, ToPrimitive, Zero};

impl<const LIMBS: usize> Zero for Mp<LIMBS> {
    fn zero() -> Self {
        Self::ZERO
    }
    fn is_zero(&self) -> bool {
        (*self).is_zero()
    }
}

impl<const LIMBS: usize> One for Mp<LIMBS> {
    fn one() -> Self {
        Self::of_int(1)
    }
}

impl<const LIMBS: usize> Num for Mp<LIMBS> {
    type FromStrRadixErr = ParseError;
    fn from_str_radix(text: &str, radix: u32) -> Result<Self, ParseError> {
        Self::parse_radix(text, radix)
    }
}

impl<const LIMBS: usize> Signed for Mp<LIMBS> {
    fn abs(&self) -> Self {
        (*self).abs()
    }
    fn abs_sub(&self, other: &Self) -> Self {
        if self <= other { Self::ZERO } else { *self - *other }
    }
    /// ±1, for zeros too, and NaN for NaN, as for `f64`.
    fn signum(&self) -> Self {
        if self.is_nan() { *self } else { Self::of_int(if self.is_sign_negative() { -1 } else { 1 }) }
    }
    fn is_positive(&self) -> bool {
        !self.is_nan() && !self.is_sign_negative()
    }
    fn is_negative(&self) -> bool {
        self.is_sign_negative()
    }
}

macro_rules! exactly {
    ($($name:ident $primitive:ident)*) => {$(
        fn $name(x: $primitive) -> Option<Self> {
            Some(x.into())
        }
    )*};
}

impl<const LIMBS: usize> FromPrimitive for Mp<LIMBS> {
    exactly!(from_i64 i64 from_u64 u64 from_i128 i128 from_u128 u128 from_f32 f32 from_f64 f64);
}

/// Integers drop the fraction, and are `None` out of range or for NaN; floats round to nearest.
impl<const LIMBS: usize> ToPrimitive for Mp<LIMBS> {
    fn to_i64(&self) -> Option<i64> {
        self.to_i128()?.try_into().ok()
    }
    fn to_u64(&self) -> Option<u64> {
        self.to_u128()?.try_into().ok()
    }
    fn to_i128(&self) -> Option<i128> {
        // The bound is tested first, so that a huge exponent does not create a huge integer.
        self.exponent().is_none_or(|e| e <= 128).then(|| self.trunc().to_rug().to_integer())??.to_i128()
    }
    fn to_u128(&self) -> Option<u128> {
        self.exponent().is_none_or(|e| e <= 128).then(|| self.trunc().to_rug().to_integer())??.to_u128()
    }
    fn to_f32(&self) -> Option<f32> {
        Some((*self).to_f32())
    }
    fn to_f64(&self) -> Option<f64> {
        Some((*self).to_f64())
    }
}

/// Converts any number that has an integer or an `f64` value; an integer is preferred.
impl<const LIMBS: usize> NumCast for Mp<LIMBS> {
    fn from<T: ToPrimitive>(x: T) -> Option<Self> {
        let float = x.to_f64()?;
        // Beyond 2⁵³ an integer's f64 is rounded, while the integer itself is exact.
        let integer = (float.trunc() == float).then(|| x.to_i128()).flatten();
        Some(integer.map_or_else(|| float.into(), Into::into))
    }
}

macro_rules! constants {
    ($($name:ident = $value:expr;)*) => {
        /// Computed from correctly rounded parts, to within one unit in the last place.
        impl<const LIMBS: usize> FloatConst for Mp<LIMBS> {$(
            fn $name() -> Self {
                $value
            }
        )*}
    };
}
constants! {
    E = Self::of_int(1).exp();
    FRAC_1_PI = Self::of_int(1) / Self::pi();
    FRAC_1_SQRT_2 = Self::of_f64(0.5).sqrt();
    FRAC_2_PI = Self::of_int(2) / Self::pi();
    FRAC_2_SQRT_PI = Self::of_int(2) / Self::pi().sqrt();
    FRAC_PI_2 = Self::pi().scale2(-1);
    FRAC_PI_3 = Self::pi() / Self::of_int(3);
    FRAC_PI_4 = Self::pi().scale2(-2);
    FRAC_PI_6 = Self::pi() / Self::of_int(6);
    FRAC_PI_8 = Self::pi().scale2(-3);
    LN_10 = Self::of_int(10).ln();
    LN_2 = Self::ln_2();
    LOG10_E = Self::of_int(1).exp().log10();
    LOG2_E = Self::of_int(1) / Self::ln_2();
    PI = Self::pi();
    SQRT_2 = Self::of_int(2).sqrt();
}

impl<const LIMBS: usize> Inv for Mp<LIMBS> {
    type Output = Self;
    fn inv(self) -> Self {
        Self::of_int(1) / self
    }
}

impl<const LIMBS: usize> MulAdd for Mp<LIMBS> {
    type Output = Self;
    fn mul_add(self, a: Self, b: Self) -> Self {
        self.mul_add(a, b)
    }
}

impl<const LIMBS: usize> Pow<Self> for Mp<LIMBS> {
    type Output = Self;
    fn pow(self, exponent: Self) -> Self {
        self.powf(exponent)
    }
}

impl<const LIMBS: usize> Pow<i32> for Mp<LIMBS> {
    type Output = Self;
    fn pow(self, n: i32) -> Self {
        self.powi(n)
    }
}
