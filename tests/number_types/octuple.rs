//! A user-defined number type: the 237 bits of IEEE 754's octuple precision, by the crate `f256`.

use ::f256::{consts::PI, f256};
use core::fmt::{self, Display, Formatter, LowerExp};
use core::ops::{Add, Div, Mul, Neg, Sub};
use stickslip::{Field, Float, Real};

#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub(crate) struct Octuple(f256);

impl Add for Octuple {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Sub for Octuple {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

impl Mul for Octuple {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
}

impl Div for Octuple {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        Self(self.0 / other.0)
    }
}

impl Neg for Octuple {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Display for Octuple {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        Display::fmt(&self.0, f)
    }
}

impl LowerExp for Octuple {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        LowerExp::fmt(&self.0, f)
    }
}

impl Field for Octuple {
    fn int(n: i32) -> Self {
        Self(n.into())
    }
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }
    fn abs(self) -> Self {
        Self(self.0.abs())
    }
}

impl Real for Octuple {
    fn pi() -> Self {
        Self(PI)
    }
    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.0.sin_cos();
        (Self(sine), Self(cosine))
    }
    fn tan(self) -> Self {
        Self(self.0.tan())
    }
    fn atan2(self, x: Self) -> Self {
        // On the diagonals f256 0.11.3 gives ±π/2, as the conformance check found.
        if self.abs() == x.abs() && self != Self::int(0) {
            let eighth = Self::pi() * Self::ratio(if x > Self::int(0) { 1 } else { 3 }, 4);
            return eighth.times_sign_of(self);
        }
        Self(self.0.atan2(&x.0))
    }
    fn mul_add(self, a: Self, b: Self) -> Self {
        Self(self.0.mul_add(a.0, b.0))
    }
}

impl Float for Octuple {
    const PRECISION: u32 = 237;
    const RATIO_EXPONENT: i32 = 65_000;

    fn epsilon() -> Self {
        Self(f256::EPSILON)
    }
    fn exp2i(e: i32) -> Self {
        Self(f256::TWO.powi(e))
    }
    fn to_f64(self) -> f64 {
        // The crate converts to f64 only through decimal digits.
        format!("{:e}", self.0).parse().unwrap_or(f64::NAN)
    }
    fn from_f64(x: f64) -> Self {
        Self(x.into())
    }
    fn floor(self) -> Self {
        Self(self.0.floor())
    }
    fn round(self) -> Self {
        Self(self.0.round())
    }
    fn is_finite(self) -> bool {
        self.0.is_finite()
    }
}
