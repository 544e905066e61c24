//! Conversions from and to primitive numbers, `rug` numbers, and text in other radixes.

use super::Mp;
use rug::{Float, Rational};

impl<const LIMBS: usize> Mp<LIMBS> {
    /// The number nearest to a ratio of integers, rounded once.
    #[must_use]
    pub fn from_rational(ratio: &Rational) -> Self {
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

/// The error for a number with more bits than the type.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("the number has more significant bits than the {bits} of the type")]
#[non_exhaustive]
pub struct Inexact {
    /// The number of bits of the type.
    pub bits: u32,
}

/// Exact, or an error; [`Mp::from_rug`] rounds instead.
impl<const LIMBS: usize> TryFrom<&Float> for Mp<LIMBS> {
    type Error = Inexact;

    fn try_from(x: &Float) -> Result<Self, Inexact> {
        let nearest = Self::from_rug(x);
        let is_exact = x.is_nan() || nearest.to_rug() == *x;
        if is_exact { Ok(nearest) } else { Err(Inexact { bits: Self::bits_now() }) }
    }
}

/// Exact.
impl<const LIMBS: usize> From<Mp<LIMBS>> for Float {
    fn from(x: Mp<LIMBS>) -> Self {
        x.to_rug()
    }
}
