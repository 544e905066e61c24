//! The number itself and MPFR's functions of it, through MPFR's custom interface.
//!
//! All unsafe code is in this file, and rests on two facts. A value's fields are written only by
//! [`Mp::output`], from the result of an MPFR call, and by [`Mp::of_int`] (`parts` only changes signs), so that they always describe
//! a valid MPFR number of `words` ≤ LIMBS limbs whose exponent is in range. MPFR writes only to the number that a
//! function names as its result, whose significand has the right size and is on the stack during the call.
//!
//! Limbs that MPFR has not written hold nothing. Only [`Mp::significand`] reads limbs here: those of a regular number.

#![allow(unsafe_code, reason = "the calls of MPFR, each behind a safe function")]

mod parts;

use super::words;
use core::cmp::Ordering;
use core::ffi::{c_int, c_void};
use core::mem::MaybeUninit;
use gmp_mpfr_sys::gmp::{self, limb_t};
use gmp_mpfr_sys::mpfr::{self, exp_t, mpfr_t, prec_t, rnd_t};

/// Binary floating point with a significand of `64 · LIMBS` bits, LIMBS ≥ 1.
///
/// Every function gives the exact result rounded once, to nearest, ties to even. An infinity, a NaN or a zero
/// is made from that of `f64`: `Mp::from(f64::NAN)`.
///
/// Two capacities, of 26 and 130 limbs, serve [`with_precision`](super::with_precision): inside it their numbers have as
/// many bits as it says, in place of a type for every precision.
///
/// The limbs are inline, so that the type is `Copy` and the generic code reads the same as for `f64`.
/// Exponents reach ±2³⁰; a result beyond becomes an infinity or a zero of the right sign, without subnormal
/// numbers. Zeros have signs and NaN is unordered, as in IEEE 754.
///
/// A formula over this type rounds at every step and loses some of the last digits, as it does at f64.
/// [`Float::guarded`](crate::float::Float::guarded) runs it with a guard limb and rounds once: then every
/// output of the closed forms is accurate to one unit in the last place (`tests/closed_forms/precision.rs`).
///
/// ```
/// use stickslip::float::Mp;
/// use stickslip::{Cycle, Ratios};
/// let cycle = Cycle::new(Ratios::new(Mp::<4>::from(1.5), "2.5".parse()?)?)?;
/// assert_eq!(format!("{:.39}", cycle.max_velocity), "1.654152276482076417806358492889845786447");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy)]
pub struct Mp<const LIMBS: usize> {
    /// The kind of number in MPFR's encoding, with its sign.
    kind: c_int,
    /// The number of limbs of the significand, the first ones of `limbs`: see [`words`].
    words: u32,
    /// The exponent of a regular number in `[1/2, 1) · 2^exponent`; 0 for the other kinds.
    exponent: exp_t,
    /// The significand of a regular number, least limb first, top bit of the last one set; nothing beyond `words`.
    limbs: [MaybeUninit<limb_t>; LIMBS],
}

impl<const LIMBS: usize> Mp<LIMBS> {
    /// The number of limbs of results now.
    #[inline]
    pub(super) fn words() -> u32 {
        if const { words::is_capacity(LIMBS) } { words::here().min(Self::BITS / 64) } else { Self::BITS / 64 }
    }

    /// The number of bits of results now: [`Mp::BITS`], or fewer where a computation has set them.
    #[inline]
    pub(crate) fn bits_now() -> u32 {
        64 * Self::words()
    }

    /// The number of bits of this number.
    #[inline]
    pub(crate) const fn bits(&self) -> u32 {
        64 * self.words
    }

    /// The significand of a regular number, least limb first; nothing for the other kinds.
    #[inline]
    pub(super) fn significand(&self) -> &[limb_t] {
        let count = if self.kind.abs() == mpfr::REGULAR_KIND { self.words as usize } else { 0 };
        // SAFETY: the `words` ≤ LIMBS limbs of a regular number have been written.
        unsafe { core::slice::from_raw_parts(self.limbs.as_ptr().cast(), count) }
    }

    /// An MPFR number whose significand is at `limbs`.
    #[inline]
    fn header(kind: c_int, words: u32, exponent: exp_t, limbs: *mut c_void) -> mpfr_t {
        let mut header = MaybeUninit::uninit();
        // SAFETY: this writes all fields of the header and reads nothing.
        unsafe {
            mpfr::custom_init_set(header.as_mut_ptr(), kind, exponent, 64 * prec_t::from(words), limbs);
            header.assume_init()
        }
    }

    /// This number as MPFR reads it. It is valid while `self` is borrowed, and must never be written through.
    #[inline]
    fn input(&self) -> mpfr_t {
        Self::header(self.kind, self.words, self.exponent, self.limbs.as_ptr().cast_mut().cast())
    }

    /// The number that `compute` writes to the place it is given.
    #[inline(always)]
    fn output(compute: impl FnOnce(*mut mpfr_t)) -> Self {
        let words = Self::words();
        let mut limbs = [MaybeUninit::uninit(); LIMBS];
        let mut header = Self::header(mpfr::NAN_KIND, words, 0, limbs.as_mut_ptr().cast());
        compute(&mut header);
        // SAFETY: both read fields of a header that was initialised above.
        let (kind, exponent) = unsafe { (mpfr::custom_get_kind(&header), mpfr::custom_get_exp(&header)) };
        let exponent = if kind.abs() == mpfr::REGULAR_KIND { exponent } else { 0 };
        Self::of_parts(kind, exponent, words, &limbs)
    }

    /// The number with these fields, of whose limbs `words` are copied, or a few more.
    #[inline(always)]
    fn of_parts(kind: c_int, exponent: exp_t, words: u32, limbs: &[MaybeUninit<limb_t>; LIMBS]) -> Self {
        // Copying a whole capacity takes longer than adding two numbers of a few words. The counts are constants, because only
        // then do the limbs go straight to the place of the result.
        if const { words::is_capacity(LIMBS) } {
            if words <= 5 {
                return Self { kind, words, exponent, limbs: Self::first::<5>(limbs) };
            }
            if words <= 17 {
                return Self { kind, words, exponent, limbs: Self::first::<17>(limbs) };
            }
        }
        Self { kind, words, exponent, limbs: *limbs }
    }

    /// The first COUNT of some limbs.
    #[inline(always)]
    fn first<const COUNT: usize>(limbs: &[MaybeUninit<limb_t>; LIMBS]) -> [MaybeUninit<limb_t>; LIMBS] {
        let mut first = [MaybeUninit::uninit(); LIMBS];
        let count = const { if COUNT < LIMBS { COUNT } else { LIMBS } };
        if let (Some(to), Some(from)) = (first.get_mut(..count), limbs.get(..count)) {
            to.copy_from_slice(from);
        }
        first
    }

    /// The integer n, exactly. The formulae contain many, so that they are made without MPFR.
    #[inline(never)]
    #[must_use]
    pub(crate) fn of_int(n: i32) -> Self {
        let words = Self::words();
        if n == 0 {
            return Self { words, ..Self::ZERO };
        }
        let magnitude = u64::from(n.unsigned_abs());
        let unused = magnitude.leading_zeros();
        let mut limbs = [MaybeUninit::new(0); LIMBS];
        if let Some(top) = limbs.get_mut(words as usize - 1) {
            *top = MaybeUninit::new(magnitude << unused);
        }
        let kind = if n < 0 { -mpfr::REGULAR_KIND } else { mpfr::REGULAR_KIND };
        Self::of_parts(kind, exp_t::from(64 - unused as i32), words, &limbs)
    }

    /// The largest finite number.
    #[must_use]
    pub(crate) fn largest() -> Self {
        // SAFETY: the result is a valid place, first written, then replaced by its neighbour.
        Self::output(|r| unsafe {
            mpfr::set_inf(r, 1);
            mpfr::nextbelow(r);
        })
    }

    /// The order of two numbers; `None` where one is NaN.
    #[inline(never)]
    pub(super) fn order(&self, other: &Self) -> Option<Ordering> {
        if self.is_nan() || other.is_nan() {
            return None;
        }
        let (a, b) = (self.input(), other.input());
        // SAFETY: both are valid numbers; neither is written.
        Some(unsafe { mpfr::cmp(&a, &b) }.cmp(&0))
    }

    /// `(sin self, cos self)`.
    #[inline(never)]
    #[must_use]
    pub(crate) fn sin_cos(self) -> (Self, Self) {
        let x = self.input();
        let mut sine = Self::NAN;
        let cosine = Self::output(|cosine| {
            sine = Self::output(|sine| {
                // SAFETY: `x` is valid and only read; the results are distinct.
                unsafe { mpfr::sin_cos(sine, cosine, &x, rnd_t::RNDN) };
            });
        });
        (sine, cosine)
    }

    /// `self · other`.
    #[inline(always)]
    pub(super) fn times_full(&self, other: &Self) -> Self {
        let (x, y) = (self.input(), other.input());
        // SAFETY: the arguments are valid and only read.
        Self::output(|r| unsafe {
            mpfr::mul(r, &x, &y, rnd_t::RNDN);
        })
    }

    /// `self / other`.
    #[inline(always)]
    pub(super) fn over_full(&self, other: &Self) -> Self {
        let (x, y) = (self.input(), other.input());
        // SAFETY: the arguments are valid and only read.
        Self::output(|r| unsafe {
            mpfr::div(r, &x, &y, rnd_t::RNDN);
        })
    }

    /// `±n · self`.
    #[inline(never)]
    pub(super) fn times_int(&self, n: u64, is_negative: bool) -> Self {
        let x = self.input();
        // SAFETY: the argument is valid and only read; the result is written before its sign is changed.
        Self::output(|r| unsafe {
            mpfr::mul_ui(r, &x, n, rnd_t::RNDN);
            if is_negative {
                mpfr::neg(r, r, rnd_t::RNDN);
            }
        })
    }

    /// `±self / n`.
    #[inline(never)]
    pub(super) fn over_int(&self, n: u64, is_negative: bool) -> Self {
        let x = self.input();
        // SAFETY: as in `times_int`.
        Self::output(|r| unsafe {
            mpfr::div_ui(r, &x, n, rnd_t::RNDN);
            if is_negative {
                mpfr::neg(r, r, rnd_t::RNDN);
            }
        })
    }

    /// The nearest `f64`, ties to even, subnormal numbers included.
    #[inline]
    #[must_use]
    pub(crate) fn to_f64(self) -> f64 {
        let x = self.input();
        // SAFETY: the argument is valid and only read.
        unsafe { mpfr::get_d(&x, rnd_t::RNDN) }
    }

    /// The nearest `f32`, ties to even, rounded once.
    #[inline]
    #[must_use]
    pub(crate) fn to_f32(self) -> f32 {
        let x = self.input();
        // SAFETY: the argument is valid and only read.
        unsafe { mpfr::get_flt(&x, rnd_t::RNDN) }
    }

    /// The number nearest to one of another width.
    #[inline]
    #[must_use]
    pub fn rounded<const OTHER: usize>(other: Mp<OTHER>) -> Self {
        let x = other.input();
        // SAFETY: the argument is valid and only read.
        Self::output(|r| unsafe {
            mpfr::set(r, &x, rnd_t::RNDN);
        })
    }

    /// The number nearest to a `rug` number of any precision.
    pub(crate) fn from_rug(x: &rug::Float) -> Self {
        // SAFETY: a `rug::Float` is a valid number, and only read.
        Self::output(|r| unsafe {
            mpfr::set(r, x.as_raw(), rnd_t::RNDN);
        })
    }

    /// This number as a `rug::Float` of as many bits.
    #[must_use]
    pub(crate) fn to_rug(self) -> rug::Float {
        let mut result = rug::Float::new(self.bits());
        let x = self.input();
        // SAFETY: `result` is a valid number of the same precision; `x` is only read.
        unsafe { mpfr::set(result.as_raw_mut(), &x, rnd_t::RNDN) };
        result
    }
}

// For the programs of this repository.
#[doc(hidden)]
impl<const LIMBS: usize> Mp<LIMBS> {
    /// Bits of the significand.
    pub const BITS: u32 = {
        assert!(LIMBS > 0, "a number needs a limb");
        assert!(LIMBS <= 1 << 20, "a number lives on the stack");
        assert!(gmp::NUMB_BITS == 64, "a limb has 64 bits");
        64 * LIMBS as u32
    };

    /// +0.
    pub const ZERO: Self = Self {
        kind: mpfr::ZERO_KIND,
        words: Self::BITS / 64,
        exponent: 0,
        limbs: [MaybeUninit::uninit(); LIMBS],
    };

    /// +∞.
    pub const INFINITY: Self = Self { kind: mpfr::INF_KIND, ..Self::ZERO };

    /// Not a number.
    pub const NAN: Self = Self { kind: mpfr::NAN_KIND, ..Self::ZERO };

    /// The distance from `|self|` to the next larger number. For zero it is the least positive number; for an
    /// infinity or NaN it is NaN.
    #[must_use]
    pub fn ulp(self) -> Self {
        let x = self.abs();
        // SAFETY: the argument is valid and only read; the result starts as a copy of it.
        let next = Self::output(|r| unsafe {
            mpfr::set(r, &x.input(), rnd_t::RNDN);
            mpfr::nextabove(r);
        });
        next.minus(x)
    }
}

/// MPFR functions whose arguments are numbers or convert to plain C types.
macro_rules! functions {
    ($($(#[$doc:meta])* $visible:vis $name:ident($($number:ident),*; $($plain:ident: $type:ty),*) = $mpfr:ident($($rnd:ident)?);)*) => {
        impl<const LIMBS: usize> Mp<LIMBS> {$(
            $(#[$doc])*
            #[inline(never)]
            #[must_use]
            $visible fn $name($($number: Self,)* $($plain: $type),*) -> Self {
                // SAFETY: the arguments are valid and only read.
                Self::output(|r| unsafe {
                    mpfr::$mpfr(r, $(&$number.input(),)* $($plain.into(),)* $(rnd_t::$rnd)?);
                })
            }
        )*}
    };
}

functions! {
    /// `√self`; NaN below zero.
    pub(crate) sqrt(self;) = sqrt(RNDN);
    /// The real cube root.
    pub(crate) cbrt(self;) = cbrt(RNDN);
    /// `self²`.
    pub(crate) square(self;) = sqr(RNDN);
    /// `sin self`.
    pub(crate) sin(self;) = sin(RNDN);
    /// `cos self`.
    pub(crate) cos(self;) = cos(RNDN);
    /// `tan self`.
    pub(crate) tan(self;) = tan(RNDN);
    /// The angle in `[−π/2, π/2]` whose sine is `self`.
    pub(crate) asin(self;) = asin(RNDN);
    /// The angle in `[0, π]` whose cosine is `self`.
    pub(crate) acos(self;) = acos(RNDN);
    /// The angle in `[−π/2, π/2]` whose tangent is `self`.
    pub(crate) atan(self;) = atan(RNDN);
    /// `sinh self`.
    pub(crate) sinh(self;) = sinh(RNDN);
    /// `cosh self`.
    pub(crate) cosh(self;) = cosh(RNDN);
    /// `tanh self`.
    pub(crate) tanh(self;) = tanh(RNDN);
    /// The inverse of `sinh`.
    pub(crate) asinh(self;) = asinh(RNDN);
    /// The inverse of `cosh`, ≥ 0; NaN below 1.
    pub(crate) acosh(self;) = acosh(RNDN);
    /// The inverse of `tanh`; NaN outside `[−1, 1]`.
    pub(crate) atanh(self;) = atanh(RNDN);
    /// `e^self`.
    pub(crate) exp(self;) = exp(RNDN);
    /// `2^self`.
    pub(crate) exp2(self;) = exp2(RNDN);
    /// `e^self − 1`, accurate near 0.
    pub(crate) exp_m1(self;) = expm1(RNDN);
    /// The natural logarithm; NaN below zero.
    pub(crate) ln(self;) = log(RNDN);
    /// The logarithm to base 2.
    pub(crate) log2(self;) = log2(RNDN);
    /// The logarithm to base 10.
    pub(crate) log10(self;) = log10(RNDN);
    /// `ln(1 + self)`, accurate near 0.
    pub(crate) ln_1p(self;) = log1p(RNDN);
    /// The largest integer not above `self`.
    pub(crate) floor(self;) = rint_floor(RNDN);
    /// The least integer not below `self`.
    pub(crate) ceil(self;) = rint_ceil(RNDN);
    /// The nearest integer, halves away from zero.
    pub(crate) round(self;) = rint_round(RNDN);
    /// `self` without its fraction.
    pub(crate) trunc(self;) = rint_trunc(RNDN);
    /// `self − trunc self`.
    pub(crate) fract(self;) = frac(RNDN);
    /// `self + other`.
    pub(super) plus(self, other;) = add(RNDN);
    /// `self − other`.
    pub(super) minus(self, other;) = sub(RNDN);
    /// `self + other`, rounded towards +∞.
    pub(in crate::float) plus_up(self, other;) = add(RNDU);
    /// `self − other`, rounded towards −∞.
    pub(in crate::float) minus_down(self, other;) = sub(RNDD);
    /// `self · a + b`, rounded once.
    pub(crate) mul_add(self, a, b;) = fma(RNDN);
    /// The remainder of `self` after division by `other` with the quotient truncated; it has the sign of
    /// `self`.
    pub(super) remainder(self, other;) = fmod(RNDN);
    /// The angle in `[−π, π]` of the point with ordinate `self` and abscissa `x`.
    pub(crate) atan2(self, x;) = atan2(RNDN);
    /// `√(self² + other²)` without needless overflow or underflow.
    pub(crate) hypot(self, other;) = hypot(RNDN);
    /// `self^exponent`.
    pub(crate) powf(self, exponent;) = pow(RNDN);
    /// `selfⁿ`.
    pub(crate) powi(self; n: i32) = pow_si(RNDN);
    /// `self · 2ᵉ`: exact within the range.
    #[doc(hidden)]
    pub scale2(self; e: i32) = mul_2si(RNDN);
    /// π.
    pub pi(;) = const_pi(RNDN);
    /// ln 2.
    pub(crate) ln_2(;) = const_log2(RNDN);
    /// The number nearest to `x`, which is `x` itself.
    pub(crate) of_f64(; x: f64) = set_d(RNDN);
}
