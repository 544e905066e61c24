//! Conversions from and to primitive numbers, `rug` numbers, and text in other radixes.

use super::Mp;
use rug::{Float, Rational};

impl<const LIMBS: usize> Mp<LIMBS> {
    /// The number nearest to a ratio of integers, rounded once.
    pub(crate) fn from_rational(ratio: &Rational) -> Self {
        Self::from_rug(&Float::with_val(Self::bits_now(), ratio))
    }

    /// The exact value as a ratio of integers; `None` for infinities and NaN.
    ///
    /// Its length grows with the exponent: `2^(2³⁰)` has a hundred million digits.
    #[doc(hidden)]
    #[must_use]
    pub fn to_rational(self) -> Option<Rational> {
        self.to_rug().to_rational()
    }
}

/// Exact, since no `f64` has more bits than a limb.
impl<const LIMBS: usize> From<f64> for Mp<LIMBS> {
    #[inline]
    fn from(x: f64) -> Self {
        Self::of_f64(x)
    }
}

/// Exact, as for `f64`.
impl<const LIMBS: usize> From<f32> for Mp<LIMBS> {
    #[inline]
    fn from(x: f32) -> Self {
        Self::of_f64(x.into())
    }
}

macro_rules! from_integers {
    ($($integer:ident)*) => {$(
        /// The nearest number; exact where the significand has enough bits.
        impl<const LIMBS: usize> From<$integer> for Mp<LIMBS> {
            #[inline]
            fn from(n: $integer) -> Self {
                Self::from_rug(&Float::with_val(Self::bits_now(), n))
            }
        }
    )*};
}

from_integers!(i8 i16 i64 i128 isize u8 u16 u32 u64 u128 usize);

/// Exact.
impl<const LIMBS: usize> From<i32> for Mp<LIMBS> {
    #[inline]
    fn from(n: i32) -> Self {
        Self::of_int(n)
    }
}

/// The nearest number; exact where the significand has enough bits.
impl<const LIMBS: usize> From<&Float> for Mp<LIMBS> {
    fn from(x: &Float) -> Self {
        Self::from_rug(x)
    }
}

/// The nearest number, rounded once.
impl<const LIMBS: usize> From<&Rational> for Mp<LIMBS> {
    fn from(ratio: &Rational) -> Self {
        Self::from_rational(ratio)
    }
}

/// Exact.
impl<const LIMBS: usize> From<Mp<LIMBS>> for Float {
    fn from(x: Mp<LIMBS>) -> Self {
        x.to_rug()
    }
}
