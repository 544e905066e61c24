//! `f32` and `f64`: the operations that IEEE 754 rounds correctly, and the circular functions of the
//! crate `libm`, so that results do not depend on the platform.

use super::circular::ARCTANGENT;
use super::fused::{self, exact};
use super::{Field, Float, Real, Task};

macro_rules! primitive {
    ($float:ident, $bits:ty, ratio_exponent: $ratio_exponent:literal, pi_rest: $second:literal $third:literal,
     $sin_cos:ident $atan2:ident $hypot:ident $fma:ident $sqrt:ident, exact: $($exact:ident = $exact_name:ident)*,
     circular: $($circular:ident = $circular_name:ident)*, exponential: $($exponential:ident = $exponential_name:ident)*) => {
        impl Field for $float {
            #[inline(always)]
            fn int(n: i32) -> Self {
                n as $float
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                exact!(self.sqrt(), libm::$sqrt(self))
            }
            #[inline(always)]
            fn abs(self) -> Self {
                self.abs()
            }
            #[inline]
            fn hypot(self, other: Self) -> Self {
                libm::$hypot(self, other)
            }
        }

        impl Real for $float {
            #[inline(always)]
            fn pi() -> Self {
                core::$float::consts::PI
            }
            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                libm::$sin_cos(self)
            }
            $(
                #[inline]
                fn $circular(self) -> Self {
                    libm::$circular_name(self)
                }
            )*
            #[inline]
            fn atan2(self, x: Self) -> Self {
                libm::$atan2(self, x)
            }
            #[inline(always)]
            fn mul_add(self, a: Self, b: Self) -> Self {
                fused::$fma(self, a, b)
            }
        }

        impl Float for $float {
            const PRECISION: u32 = $float::MANTISSA_DIGITS;
            const RATIO_EXPONENT: i32 = $ratio_exponent;

            #[inline(always)]
            fn pi_rest() -> (Self, Self) {
                (<$float>::from_bits($second), <$float>::from_bits($third))
            }
            #[inline(always)]
            fn epsilon() -> Self {
                $float::EPSILON
            }
            #[inline(always)]
            fn exp2i(e: i32) -> Self {
                // The biased exponent alone: exact, and valid for every normal power of two.
                const BIAS: i32 = $float::MAX_EXP - 1;
                <$float>::from_bits((e.saturating_add(BIAS) as $bits) << ($float::MANTISSA_DIGITS - 1))
            }
            #[inline(always)]
            fn power_of_two(n: Self) -> Self {
                // The sum has n and the bias in its last bits, which become the exponent.
                const BIASED: $float = (3 * (1 as $bits) << ($float::MANTISSA_DIGITS - 2)) as $float
                    + ($float::MAX_EXP - 1) as $float;
                <$float>::from_bits((n + BIASED).to_bits() << ($float::MANTISSA_DIGITS - 1))
            }
            #[inline(always)]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
            #[inline(always)]
            fn from_f64(x: f64) -> Self {
                x as $float
            }
            $(
                #[inline(always)]
                fn $exact(self) -> Self {
                    exact!(self.$exact(), libm::$exact_name(self))
                }
            )*
            #[inline(always)]
            fn is_finite(self) -> bool {
                self.is_finite()
            }
            $(
                #[inline]
                fn $exponential(self) -> Self {
                    libm::$exponential_name(self)
                }
            )*
            #[inline(always)]
            fn angle_of(sine: Self, cosine: Self) -> Self {
                ARCTANGENT.of().angle(sine, cosine)
            }
            #[inline(always)]
            fn fused<T: Task>(task: T) -> T::Output {
                fused(task)
            }
            #[inline(always)]
            fn times_sign_of(self, sign: Self) -> Self {
                // The sign is set by bits, which compilers vectorise without a comparison.
                <$float>::from_bits(self.to_bits() ^ (sign.to_bits() & (-0.0 as $float).to_bits()))
            }
        }
    };
}

/// Runs the task compiled for fused operations on an x86-64 processor that has them, if the program was not
/// compiled for them. The standard library looks for them.
#[cfg(all(feature = "std", target_arch = "x86_64", not(target_feature = "fma")))]
#[inline(always)]
#[allow(unsafe_code, reason = "a call that needs a feature of the processor, which is looked for")]
fn fused<T: Task>(task: T) -> T::Output {
    #[target_feature(enable = "fma")]
    unsafe fn with_fma<T: Task>(task: T) -> T::Output {
        task.run()
    }
    #[cold]
    #[inline(never)]
    fn without<T: Task>(task: T) -> T::Output {
        task.run()
    }
    if std::arch::is_x86_feature_detected!("fma") {
        // SAFETY: the processor has the feature.
        unsafe { with_fma(task) }
    } else {
        without(task)
    }
}

#[cfg(not(all(feature = "std", target_arch = "x86_64", not(target_feature = "fma"))))]
#[inline(always)]
fn fused<T: Task>(task: T) -> T::Output {
    task.run()
}

primitive!(f32, u32, ratio_exponent: 30, pi_rest: 0xb3bb_bd2e 0xa777_2ced, sincosf atan2f hypotf fmaf sqrtf,
    exact: floor = floorf round = roundf, circular: sin = sinf cos = cosf tan = tanf, exponential: exp = expf exp_m1 = expm1f);
primitive!(f64, u64, ratio_exponent: 250, pi_rest: 0x3ca1_a626_3314_5c07 0xb92f_1976_b7ed_8fbc,
    sincos atan2 hypot fma sqrt, exact: floor = floor round = round,
    circular: sin = sin cos = cos tan = tan, exponential: exp = exp exp_m1 = expm1);

#[cfg(test)]
mod tests {
    use super::{Field, Float};

    #[test]
    fn powers_of_two_are_exact() {
        assert_eq!(<f64 as Float>::exp2i(250), 2f64.powi(250));
        assert_eq!(<f64 as Float>::exp2i(-250), 2f64.powi(-250));
        assert_eq!(<f32 as Float>::exp2i(-30), 2f32.powi(-30));
        assert_eq!(<f32 as Float>::exp2i(0), 1.0);
        for n in -250..=250i16 {
            assert_eq!(<f64 as Float>::power_of_two(f64::from(n)), 2f64.powi(n.into()));
            if n.abs() <= 30 {
                assert_eq!(<f32 as Float>::power_of_two(f32::from(n)), 2f32.powi(n.into()));
            }
        }
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
        assert_eq!(<f64 as Field>::ratio(1, 3), 1.0 / 3.0);
        assert_eq!(<f32 as Field>::ratio(2, 7), 2.0f32 / 7.0);
    }
}
