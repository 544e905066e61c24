//! `f32` and `f64`: each operation is the standard library's own.

use super::{Float, Real};

macro_rules! primitive {
    ($float:ident, $bits:ty, low_half: $low:literal, ratio_exponent: $ratio_exponent:literal,
     pi_rest: $second:literal $third:literal, exp: $exp:ident $expm1:ident) => {
        impl Real for $float {
            #[inline]
            fn int(n: i32) -> Self {
                n as $float
            }
            #[inline]
            fn pi() -> Self {
                core::$float::consts::PI
            }
            #[inline]
            fn sqrt(self) -> Self {
                self.sqrt()
            }
            #[inline]
            fn abs(self) -> Self {
                self.abs()
            }
            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                self.sin_cos()
            }
            #[inline]
            fn sin(self) -> Self {
                self.sin()
            }
            #[inline]
            fn cos(self) -> Self {
                self.cos()
            }
            #[inline]
            fn tan(self) -> Self {
                self.tan()
            }
            #[inline]
            fn atan2(self, x: Self) -> Self {
                self.atan2(x)
            }
            #[inline]
            fn hypot(self, other: Self) -> Self {
                self.hypot(other)
            }
            #[inline]
            fn mul_add(self, a: Self, b: Self) -> Self {
                self.mul_add(a, b)
            }
        }

        impl Float for $float {
            const PRECISION: u32 = $float::MANTISSA_DIGITS;
            const RATIO_EXPONENT: i32 = $ratio_exponent;
            const IS_FUSED: bool = cfg!(target_feature = "fma");

            #[inline]
            fn pi_rest() -> (Self, Self) {
                (<$float>::from_bits($second), <$float>::from_bits($third))
            }
            #[inline]
            fn epsilon() -> Self {
                $float::EPSILON
            }
            #[inline]
            fn exp2i(e: i32) -> Self {
                // The biased exponent alone: exact, and valid for every normal power of two.
                const BIAS: i32 = $float::MAX_EXP - 1;
                <$float>::from_bits((e.saturating_add(BIAS) as $bits) << ($float::MANTISSA_DIGITS - 1))
            }
            #[inline]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
            #[inline]
            fn from_f64(x: f64) -> Self {
                x as $float
            }
            /// Without the instruction, the fused operation is a call into the library, which costs more than the halves.
            #[inline]
            fn product_less(self, other: Self, near: Self) -> Self {
                if Self::IS_FUSED {
                    return self.mul_add(other, -near);
                }
                let ((a, a_low), (b, b_low)) = (self.halves(), other.halves());
                ((a * b - near) + a * b_low) + a_low * other
            }
            #[inline]
            fn times_plus(self, factor: Self, addend: Self) -> Self {
                if Self::IS_FUSED { self.mul_add(factor, addend) } else { self * factor + addend }
            }
            #[inline]
            fn halves(self) -> (Self, Self) {
                let high = <$float>::from_bits(self.to_bits() & !$low);
                (high, self - high)
            }
            #[inline]
            fn floor(self) -> Self {
                self.floor()
            }
            #[inline]
            fn round(self) -> Self {
                self.round()
            }
            #[inline]
            fn is_finite(self) -> bool {
                self.is_finite()
            }
            #[inline]
            fn exp(self) -> Self {
                libm::$exp(self)
            }
            #[inline]
            fn exp_m1(self) -> Self {
                libm::$expm1(self)
            }
        }
    };
}

primitive!(f32, u32, low_half: 0xfff, ratio_exponent: 30, pi_rest: 0xb3bb_bd2e 0xa777_2ced, exp: expf expm1f);
primitive!(f64, u64, low_half: 0x7ff_ffff, ratio_exponent: 250,
    pi_rest: 0x3ca1_a626_3314_5c07 0xb92f_1976_b7ed_8fbc, exp: exp expm1);

#[cfg(test)]
mod tests {
    use super::{Float, Real};

    #[test]
    fn powers_of_two_are_exact() {
        assert_eq!(<f64 as Float>::exp2i(250), 2f64.powi(250));
        assert_eq!(<f64 as Float>::exp2i(-250), 2f64.powi(-250));
        assert_eq!(<f32 as Float>::exp2i(-30), 2f32.powi(-30));
        assert_eq!(<f32 as Float>::exp2i(0), 1.0);
    }

    #[test]
    fn sign_transfer_and_maximum() {
        assert_eq!(3f64.with_sign_of(-2.0), -3.0);
        assert_eq!((-3f64).with_sign_of(0.0), 3.0);
        assert_eq!(1f64.or_larger(2.0), 2.0);
        assert_eq!(2f64.or_larger(1.0), 2.0);
        assert_eq!(2f64.or_larger(f64::NAN), 2.0);
    }

    #[test]
    fn a_ratio_is_the_rounded_quotient() {
        assert_eq!(<f64 as Real>::ratio(1, 3), 1.0 / 3.0);
        assert_eq!(<f32 as Real>::ratio(2, 7), 2.0f32 / 7.0);
    }
}
