//! `Mp<LIMBS>` compared with `rug::Float` of the same precision, operation by operation; shared by the
//! property tests and the fuzz target.

#![allow(dead_code, reason = "the fuzz target and the tests take what they need")]

use num_traits::real::Real;
use num_traits::{Inv, Pow, Signed, ToPrimitive, Zero};
use rug::float::Special;
use rug::ops::Pow as _;
use rug::{Float, Integer, Rational};
use stickslip::float::Mp;

/// Whether two numbers are the same: both NaN, or equal with the same sign.
pub(crate) fn same<const L: usize>(ours: Mp<L>, theirs: &Float) -> bool {
    let ours = Float::from(ours);
    assert_eq!(ours.prec(), theirs.prec());
    if theirs.is_nan() {
        ours.is_nan()
    } else {
        ours == *theirs && ours.is_sign_negative() == theirs.is_sign_negative()
    }
}

/// Asserts that two numbers are the same; the message names the operation and its operands.
macro_rules! assert_same {
    ($ours:expr, $theirs:expr, $($context:tt)*) => {{
        let (ours, theirs) = ($ours, $theirs);
        assert!(same(ours, &theirs), "{}: {ours:e} for {theirs}", format!($($context)*));
    }};
}

/// The ingredients of a number at any precision: a special value, or random significand bits with an exponent
/// that is ordinary, large, or at an end of the range.
#[derive(Debug, Clone)]
pub(crate) enum Recipe {
    Special(u8),
    Whole(i64),
    Regular { negative: bool, words: Vec<u64>, exponent: i32 },
}

pub(crate) const END: i32 = (1 << 30) - 1;

impl Recipe {
    pub(crate) fn cook(&self, bits: u32) -> Float {
        match self {
            Self::Special(0) => Float::with_val(bits, Special::Zero),
            Self::Special(1) => Float::with_val(bits, Special::NegZero),
            Self::Special(2) => Float::with_val(bits, Special::Infinity),
            Self::Special(3) => Float::with_val(bits, Special::NegInfinity),
            Self::Special(_) => Float::with_val(bits, Special::Nan),
            Self::Whole(n) => Float::with_val(bits, *n),
            Self::Regular { negative, words, exponent } => {
                let mut n = Integer::new();
                for word in words.iter().cycle().take(bits as usize / 64) {
                    n = (n << 64) + *word;
                }
                n.set_bit(bits - 1, true);
                let mut x = Float::with_val(bits, n);
                // First to [1/2, 1), then in two shifts, because a single one could leave the range on its
                // way.
                x >>= bits;
                x <<= *exponent;
                if *negative { -x } else { x }
            }
        }
    }
}

/// An argument for which circular functions and exponentials are fast.
fn moderate(x: &Float) -> bool {
    !x.is_normal() || x.get_exp().is_some_and(|e| e.abs() < 4000)
}

pub(crate) fn unary<const L: usize>(recipe: &Recipe) {
    let theirs = recipe.cook(64 * L as u32);
    let ours = Mp::<L>::from(&theirs);
    assert_same!(ours, theirs.clone(), "conversion");
    macro_rules! check {
        ($($ours:ident = $theirs:ident),*) => {$(
            assert_same!(ours.$ours(), theirs.clone().$theirs(), "{} {theirs}", stringify!($ours));
        )*};
    }
    check!(
        sqrt = sqrt,
        cbrt = cbrt,
        abs = abs,
        floor = floor,
        ceil = ceil,
        round = round,
        trunc = trunc,
        fract = fract,
        atan = atan,
        asin = asin,
        acos = acos,
        tanh = tanh,
        ln = ln,
        log2 = log2,
        log10 = log10,
        ln_1p = ln_1p,
        asinh = asinh,
        acosh = acosh,
        atanh = atanh
    );
    if moderate(&theirs) {
        check!(sin = sin, cos = cos, tan = tan);
        let (sine, cosine) = ours.sin_cos();
        assert_same!(sine, theirs.clone().sin(), "sin_cos {theirs}");
        assert_same!(cosine, theirs.clone().cos(), "sin_cos {theirs}");
    }
    // At both ends the exponential overflows or underflows quickly.
    check!(exp = exp, exp2 = exp2, exp_m1 = exp_m1, sinh = sinh, cosh = cosh);
    assert_same!(-ours, -theirs.clone(), "neg {theirs}");
    assert_same!(stickslip::Field::square(ours), theirs.clone().square(), "square {theirs}");
    assert_same!(Inv::inv(ours), theirs.clone().recip(), "inv {theirs}");
    for n in [-3, -1, 0, 1, 2, 5] {
        assert_same!(ours.powi(n), Float::with_val(64 * L as u32, (&theirs).pow(n)), "powi {theirs} {n}");
        assert_same!(Pow::pow(ours, n), Float::with_val(64 * L as u32, (&theirs).pow(n)), "pow {theirs} {n}");
    }
    for e in [-70, -1, 3, 90] {
        assert_same!(ours.scale2(e), theirs.clone() << e, "scale2 {theirs} {e}");
    }
    assert_eq!(ours.is_nan(), theirs.is_nan());
    assert_eq!(ours.is_zero(), theirs.is_zero());
    assert_eq!(stickslip::Float::is_finite(ours), theirs.is_finite());
    if !ours.is_nan() {
        assert_eq!(ours.is_sign_negative(), theirs.is_sign_negative());
        assert_eq!(Signed::signum(&ours).to_f64(), Some(theirs.clone().signum().to_f64()));
    }
    if theirs.is_finite() && !theirs.is_zero() {
        let (mut next, start) = (theirs.clone().abs(), theirs.clone().abs());
        next.next_up();
        assert_same!(ours.ulp(), next - start, "ulp {theirs}");
    }
    assert_eq!(ours.to_f64().map(f64::to_bits).map(|b| b << 1), Some(theirs.to_f64().to_bits() << 1));
    assert_eq!(ours.to_f32().map(f32::to_bits).map(|b| b << 1), Some(theirs.to_f32().to_bits() << 1));
    // A wider type holds the number exactly; a narrower one rounds once.
    assert!(same(Mp::<L>::rounded(Mp::<20>::rounded(ours)), &theirs));
    assert_same!(Mp::<1>::rounded(ours), Float::with_val(64, &theirs), "narrower {theirs}");
}

pub(crate) fn binary<const L: usize>(a: &Recipe, b: &Recipe) {
    let bits = 64 * L as u32;
    let (a, b) = (a.cook(bits), b.cook(bits));
    let (x, y) = (Mp::<L>::from(&a), Mp::<L>::from(&b));
    macro_rules! operator {
        ($($operator:tt $assign:tt),*) => {$(
            let theirs = Float::with_val(bits, &a $operator &b);
            assert_same!(x $operator y, theirs.clone(), "{a} {} {b}", stringify!($operator));
            assert_same!(x $operator &y, theirs.clone(), "{a} {} &{b}", stringify!($operator));
            let mut z = x;
            z $assign y;
            assert_same!(z, theirs.clone(), "{a} {} {b}", stringify!($assign));
            let mut z = x;
            z $assign &y;
            assert_same!(z, theirs, "{a} {} &{b}", stringify!($assign));
            // The same number as both operands.
            let theirs = Float::with_val(bits, &a $operator &a);
            assert_same!(x $operator x, theirs.clone(), "{a} {} itself", stringify!($operator));
            let mut z = x;
            z $assign z;
            assert_same!(z, theirs, "{a} {} itself", stringify!($assign));
        )*};
    }
    operator!(+ +=, - -=, * *=, / /=);
    // The remainder for exponents a billion apart would be computed in full.
    if moderate(&a) && moderate(&b) {
        operator!(% %=);
    }
    assert_same!(x.hypot(y), a.clone().hypot(&b), "hypot {a} {b}");
    assert_same!(x.atan2(y), a.clone().atan2(&b), "atan2 {a} {b}");
    assert_same!(x.powf(y), Float::with_val(bits, (&a).pow(&b)), "powf {a} {b}");
    assert_same!(Pow::pow(x, y), Float::with_val(bits, (&a).pow(&b)), "pow {a} {b}");
    assert_eq!(x.partial_cmp(&y), a.partial_cmp(&b), "{} ? {}", a, b);
    assert_eq!(x == y, a == b);
    assert_eq!(x < y, a < b);
    assert_eq!(x >= y, a >= b);
    let copy = x;
    assert_eq!(x == copy, !a.is_nan());
    if a > b {
        assert_same!(Signed::abs_sub(&x, &y), Float::with_val(bits, &a - &b), "abs_sub {a} {b}");
    }
}

pub(crate) fn ternary<const L: usize>(a: &Recipe, b: &Recipe, c: &Recipe) {
    let bits = 64 * L as u32;
    let (a, b, c) = (a.cook(bits), b.cook(bits), c.cook(bits));
    let [x, y, z] = [&a, &b, &c].map(Mp::<L>::from);
    assert_same!(x.mul_add(y, z), a.clone().mul_add(&b, &c), "{a} · {b} + {c}");
    assert_same!(x.mul_add(x, x), a.clone().mul_add(&a, &a), "{a} · itself + itself");
    // If the sum cancels the product, its rounding error remains.
    let product = Float::with_val(bits, &a * &b);
    assert_same!(
        x.mul_add(y, -(x * y)),
        a.clone().mul_add(&b, &-product),
        "{a} · {b} less its rounded value"
    );
}

pub(crate) fn text<const L: usize>(recipe: &Recipe) {
    let theirs = recipe.cook(64 * L as u32);
    let x = Mp::<L>::from(&theirs);
    for text in [x.to_string(), format!("{x:e}"), format!("{x:?}")] {
        let back: Mp<L> = text.parse().unwrap();
        assert_same!(back, theirs.clone(), "{text}");
    }
    let padded = format!("{x:>9}");
    assert_eq!(padded.trim_start(), x.to_string());
    // With few digits: the same as rounding the exact value as a ratio of integers.
    if theirs.is_finite() && moderate(&theirs) {
        for places in [0usize, 1, 7, 60] {
            let scaled = theirs.to_rational().unwrap() * Integer::from(10).pow(places as u32);
            let (below, floor) = scaled.clone().fract_floor(Integer::new());
            let half = below.cmp(&Rational::from((1, 2)));
            let up = half.is_gt() || half.is_eq() && floor.is_odd();
            let nearest: Integer = floor + u32::from(up);
            let text = format!("{x:.places$}");
            let digits: String = text.chars().filter(char::is_ascii_digit).collect();
            assert_eq!(digits.parse::<Integer>().unwrap(), nearest.abs(), "{} of {}", &text, x);
            assert_eq!(text.starts_with('-'), theirs.is_sign_negative());
            assert_eq!(text.split('.').nth(1).map_or(0, str::len), places);
        }
    }
}
