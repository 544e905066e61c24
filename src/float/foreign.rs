//! An adapter for the number types of other crates.

use super::{Field, Float, Real};
use core::cmp::Ordering;
use core::fmt::{self, Debug, Display, Formatter, LowerExp};
use core::ops::{Add, Div, Mul, Neg, Sub};
use num_traits::{FloatConst, NumCast};

/// A number of any type that implements the traits of num-traits, as a number of this crate.
///
/// `PRECISION` and `RATIO_EXPONENT` are the constants of [`Float`], for which num-traits has no names: the
/// bits of the significand, and about a quarter of the largest exponent.
/// [`conformance`](super::conformance()) finds out whether they are right, and whether the type
/// rounds as the formulae need.
///
/// ```
/// use stickslip::{Cycle, Ratios, float::Foreign};
/// type Number = Foreign<f64, 53, 255>;
/// stickslip::float::conformance::<Number>()?;
/// let cycle = Cycle::new(Ratios::new(Foreign(1.5), Foreign(2.5))?)?;
/// let found: Number = cycle.max_displacement;
/// assert!((found.0 - 1.632993161855452).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, PartialEq)]
pub struct Foreign<T, const PRECISION: u32, const RATIO_EXPONENT: i32>(pub T);

impl<T: PartialOrd, const P: u32, const E: i32> PartialOrd for Foreign<T, P, E> {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.0.partial_cmp(&other.0)
    }
}

macro_rules! operators {
    ($($trait:ident $method:ident $operator:tt)*) => {$(
        impl<T: $trait<Output = T>, const P: u32, const E: i32> $trait for Foreign<T, P, E> {
            type Output = Self;

            #[inline]
            fn $method(self, other: Self) -> Self {
                Self(self.0 $operator other.0)
            }
        }
    )*};
}

operators! { Add add + Sub sub - Mul mul * Div div / }

impl<T: Neg<Output = T>, const P: u32, const E: i32> Neg for Foreign<T, P, E> {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

macro_rules! written {
    ($($trait:ident)*) => {$(
        impl<T: $trait, const P: u32, const E: i32> $trait for Foreign<T, P, E> {
            fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
                self.0.fmt(f)
            }
        }
    )*};
}

written! { Debug Display LowerExp }

/// Functions that are those of the number.
macro_rules! of_number {
    ($($name:ident($($argument:ident),*);)*) => {$(
        #[inline]
        fn $name(self $(, $argument: Self)*) -> Self {
            Self(self.0.$name($($argument.0),*))
        }
    )*};
}

impl<T: num_traits::Float + Debug, const P: u32, const E: i32> Field for Foreign<T, P, E> {
    #[inline]
    fn int(n: i32) -> Self {
        Self(<T as NumCast>::from(n).unwrap_or_else(T::nan))
    }
    of_number! { sqrt(); abs(); }
}

impl<T: num_traits::Float + FloatConst + Debug, const P: u32, const E: i32> Real for Foreign<T, P, E> {
    #[inline]
    fn pi() -> Self {
        Self(T::PI())
    }
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.0.sin_cos();
        (Self(sine), Self(cosine))
    }
    of_number! { tan(); atan2(x); mul_add(a, b); }
}

impl<T, const P: u32, const E: i32> Float for Foreign<T, P, E>
where
    T: num_traits::Float + FloatConst + Debug + Display + LowerExp,
{
    const PRECISION: u32 = P;
    const RATIO_EXPONENT: i32 = E;

    #[inline]
    fn epsilon() -> Self {
        Self(T::epsilon())
    }
    #[inline]
    fn exp2i(e: i32) -> Self {
        let two = T::one() + T::one();
        Self(two.powi(e))
    }
    #[inline]
    fn to_f64(self) -> f64 {
        self.0.to_f64().unwrap_or(f64::NAN)
    }
    #[inline]
    fn from_f64(x: f64) -> Self {
        Self(<T as NumCast>::from(x).unwrap_or_else(T::nan))
    }
    of_number! { floor(); round(); exp(); exp_m1(); }
    #[inline]
    fn is_finite(self) -> bool {
        self.0.is_finite()
    }
}
