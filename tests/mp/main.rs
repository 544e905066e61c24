//! `Mp<LIMBS>` compared with `rug::Float` of the same precision: every operation, on ordinary numbers and on
//! zeros of both signs, infinities, NaN, and the ends of the exponent range.

#[macro_use]
#[path = "../invariants/multiple.rs"]
mod multiple;
#[macro_use]
mod widths;
#[path = "../drawn/mod.rs"]
mod drawn;
#[path = "../kept/mod.rs"]
mod kept;
#[path = "../machine_box/mod.rs"]
mod machine_box;
#[path = "../random/mod.rs"]
mod random;

mod boxes;
mod cases;
mod enclosed;
#[cfg(feature = "matching")]
mod field;
mod formulae;
mod machines;
mod set_precision;
mod text;
mod traits;

use drawn::cases;
use multiple::{END, Recipe, binary, same, ternary, text, unary};
use num_traits::{FloatConst, FromPrimitive, One, Signed, ToPrimitive, Zero};
use proptest::prelude::*;
use rug::ops::AssignRound;
use rug::{Assign, Float, Integer, Rational};
use stickslip::float::{Mp, WIDTHS, WithPrecision, with_precision};
use stickslip::{Field, Float as _, Real};

fn recipe() -> impl Strategy<Value = Recipe> {
    let regular = |exponents: std::ops::RangeInclusive<i32>| {
        (any::<bool>(), proptest::collection::vec(words(), 1..4), exponents)
            .prop_map(|(negative, words, exponent)| Recipe::Regular { negative, words, exponent })
    };
    prop_oneof![
        2 => (0u8..5).prop_map(Recipe::Special),
        1 => (-40i64..40).prop_map(Recipe::Whole),
        8 => regular(-4..=4),
        3 => regular(-200..=200),
        1 => regular(END - 3..=END),
        1 => regular(-END + 1..=-END + 4),
    ]
}

/// Words of zeros or ones only cause long carries and ties.
fn words() -> impl Strategy<Value = u64> {
    prop_oneof![2 => any::<u64>(), 1 => Just(0), 1 => Just(u64::MAX), 1 => Just(1u64 << 63)]
}

proptest! {
    #![proptest_config(cases(700))]

    #[test]
    fn functions_of_one_number(x in recipe()) {
        at_widths!(unary(&x));
    }

    #[test]
    fn functions_of_two_numbers(x in recipe(), y in recipe()) {
        at_widths!(binary(&x, &y));
    }

    #[test]
    fn fused_multiply_add(x in recipe(), y in recipe(), z in recipe()) {
        at_widths!(ternary(&x, &y, &z));
    }

    #[test]
    fn text_reads_back(x in recipe()) {
        at_widths!(text(&x));
    }

    #[test]
    fn primitive_numbers(
        n in any::<i64>(),
        m in any::<i128>(),
        u in any::<u128>(),
        x in any::<f64>(),
        y in any::<f32>(),
    ) {
        macro_rules! check {
            ($($value:expr),*) => {$(
                assert_same!(Mp::<1>::from($value), Float::with_val(64, $value), "{:?}", $value);
                assert_same!(Mp::<3>::from($value), Float::with_val(192, $value), "{:?}", $value);
            )*};
        }
        check!(n, n as i32, n as u64, n as i8, n as u16, n as usize, n as isize, m, u, x, y);
        prop_assert_eq!(Mp::<1>::from(x).to_f64().to_bits(), x.to_bits());
        prop_assert_eq!(Mp::<1>::from(y).to_f32().map(f32::to_bits), Some(y.to_bits()));
        let wide = Mp::<2>::from(m);
        prop_assert_eq!(wide.to_i128(), Some(m));
        prop_assert_eq!(Mp::<2>::from(u).to_u128(), Some(u));
        prop_assert_eq!(Mp::<1>::from(n).to_i64(), Some(n));
        prop_assert_eq!((wide.to_i64(), wide.to_u64(), wide.to_u128()), (m.to_i64(), m.to_u64(), m.to_u128()));
        prop_assert_eq!(<Mp<2> as num_traits::NumCast>::from(m), Some(wide));
        prop_assert_eq!(<Mp<2> as num_traits::NumCast>::from(x), Some(Mp::from(x)));
        prop_assert_eq!(<Mp<4> as FromPrimitive>::from_u128(u).and_then(|v| v.to_u128()), Some(u));
    }

    #[test]
    fn big_integers_and_ratios(numerator in any::<i128>(), denominator in 1..i128::MAX) {
        let ratio = Rational::from((numerator, denominator));
        assert_same!(Mp::<4>::from(&ratio), Float::with_val(256, &ratio), "{ratio}");
        assert_same!(Mp::<1>::from(&ratio), Float::with_val(64, &ratio), "{ratio}");
        let square = Integer::from(numerator) * denominator;
        assert_same!(Mp::<2>::from(&Rational::from(&square)), Float::with_val(128, &square), "{square}");
        // 2¹²⁷ · 2¹²⁷ fits, and is returned unchanged.
        prop_assert_eq!(Mp::<4>::from(&Rational::from(&square)).to_rational(), Some(Rational::from(square)));
    }
}

fn largest<const L: usize>() -> Mp<L> {
    <Mp<L> as num_traits::real::Real>::max_value()
}

#[test]
fn what_overflows_is_infinite_and_what_underflows_is_zero() {
    let huge = Mp::<2>::from(1).scale2(END - 1);
    assert!(huge.is_finite() && (huge * huge) == Mp::INFINITY && (-huge * huge) == -Mp::INFINITY);
    let tiny = Mp::<2>::from(1).scale2(1 - END);
    assert!((tiny * tiny).is_zero() && !(tiny * tiny).is_negative());
    assert!((-tiny * tiny).is_zero() && (-tiny * tiny).is_negative());
    assert_eq!(largest::<1>() + largest().ulp(), Mp::INFINITY);
    assert!(largest::<3>().is_finite());
}

#[test]
fn constants_and_units() {
    fn check<const L: usize>() {
        let bits = 64 * L as u32;
        assert!(same(<Mp<L> as Real>::pi(), &Float::with_val(bits, rug::float::Constant::Pi)));
        assert!(same(<Mp<L> as FloatConst>::LN_2(), &Float::with_val(bits, rug::float::Constant::Log2)));
        assert!(same(Mp::<L>::one(), &Float::with_val(bits, 1)) && Mp::<L>::zero().is_zero());
        assert!(same(Mp::<L>::ratio(-7, 3), &Float::with_val(bits, Rational::from((-7, 3)))));
        let epsilon = Mp::<L>::epsilon();
        assert_eq!(epsilon, Mp::from(1).ulp());
        assert_eq!(Mp::<L>::from(1) + epsilon.scale2(-1), Mp::from(1));
        assert_eq!(Mp::<L>::exp2i(-250).to_f64(), 2f64.powi(-250));
        assert_eq!(<Mp<L> as stickslip::Float>::PRECISION, bits);
        // The derived constants are within one unit in the last place of those at twice the bits.
        let near =
            |ours: Mp<L>, exact: Mp<40>| (Mp::<40>::rounded(ours) - exact).abs() <= Mp::rounded(ours.ulp());
        macro_rules! constants {
            ($($name:ident)*) => {$(
                assert!(near(Mp::$name(), <Mp<40> as FloatConst>::$name()), stringify!($name));
                let double = <f64 as FloatConst>::$name();
                assert!((Mp::<L>::$name().to_f64() - double).abs() <= f64::EPSILON * double, stringify!($name));
            )*};
        }
        constants!(E FRAC_1_PI FRAC_1_SQRT_2 FRAC_2_PI FRAC_2_SQRT_PI FRAC_PI_2 FRAC_PI_3 FRAC_PI_4 FRAC_PI_6
            FRAC_PI_8 LN_10 LN_2 LOG10_E LOG2_E PI SQRT_2 TAU LOG2_10 LOG10_2);
    }
    check::<1>();
    check::<2>();
    check::<16>();
}

#[test]
fn sums_and_products() {
    let numbers = || (1..=10).map(Mp::<1>::from);
    assert_eq!(numbers().sum::<Mp<1>>(), Mp::from(55));
    assert_eq!(numbers().product::<Mp<1>>(), Mp::from(3_628_800));
    assert_eq!(Mp::<2>::default(), Mp::ZERO);
}

#[test]
fn signs_and_casts() {
    let negative_zero = Mp::<1>::from(-0.0);
    assert!(negative_zero == Mp::ZERO && Signed::is_negative(&negative_zero));
    assert!(Signed::is_negative(&negative_zero) && !Signed::is_positive(&negative_zero));
    assert_eq!(Signed::signum(&negative_zero), Mp::from(-1));
    assert!(Signed::is_positive(&Mp::<1>::ZERO) && !Signed::is_positive(&Mp::<1>::NAN));
    assert!(Signed::signum(&Mp::<1>::NAN).is_nan());
    assert_eq!(Mp::<1>::from(1).abs_sub(&Mp::from(4)), Mp::ZERO);
    assert_eq!((Mp::<1>::from(-1.9).to_i64(), Mp::<1>::from(-1.0).to_u64()), (Some(-1), None));
    assert_eq!(
        (Mp::<1>::INFINITY.to_i64(), Mp::<1>::NAN.to_u128(), largest::<1>().to_i128()),
        (None, None, None)
    );
    assert_eq!(Mp::<1>::from(1).scale2(-END + 9).to_i64(), Some(0));
    assert_eq!(Mp::<2>::INFINITY.to_rational(), None);
}

#[test]
fn rounding_between_widths_is_to_nearest_even() {
    let one = Mp::<2>::from(1);
    let half_ulp = one.scale2(-64);
    assert_eq!(Mp::<1>::rounded(one + half_ulp), Mp::from(1));
    assert_eq!(Mp::<1>::rounded(one + half_ulp + half_ulp.scale2(-50)), Mp::from(1) + Mp::epsilon());
    assert_eq!(Mp::<1>::rounded(one + half_ulp * Mp::from(3)), Mp::from(1) + Mp::epsilon().scale2(1));
    // From a rug number of another precision, and back.
    let mut third = Float::new(200);
    third.assign_round(Rational::from((1, 3)), rug::float::Round::Nearest);
    assert!(same(Mp::<1>::from(&third), &Float::with_val(64, &third)));
    let mut back = Float::new(64);
    back.assign(Float::from(Mp::<1>::from(&third)));
    assert_eq!(back, Float::with_val(64, &third));
}

#[test]
fn numbers_cross_threads() {
    fn shareable<T: Copy + Send + Sync + 'static>() {}
    shareable::<Mp<7>>();
    // MPFR caches π per thread: each thread has its own, and they agree.
    let here = Mp::<8>::pi();
    let there: Vec<_> = (0..4).map(|_| std::thread::spawn(|| Mp::<8>::pi() * Mp::from(3))).collect();
    for thread in there {
        assert_eq!(thread.join().unwrap(), here * Mp::from(3));
    }
}

#[test]
fn the_least_sufficient_width_is_chosen() {
    struct Precision;
    impl WithPrecision for Precision {
        type Output = u32;
        fn run<F: stickslip::Float>(self) -> u32 {
            F::precision()
        }
    }
    assert!(WIDTHS.windows(2).all(|w| w[0] < w[1]));
    let mut least = 1;
    for &width in WIDTHS {
        assert_eq!(with_precision(least, Precision), Ok(width));
        assert_eq!(with_precision(width, Precision), Ok(width));
        least = width + 1;
    }
    assert!(least > 4096);
    let message = |bits| with_precision(bits, Precision).unwrap_err().to_string();
    assert_eq!(message(0), "precision = 0 bits must be ≥ 1 and ≤ 8192");
    assert_eq!(message(8193), "precision = 8193 bits must be ≥ 1 and ≤ 8192");
}

#[test]
fn a_rug_number_is_rounded_once() {
    let third = Float::with_val(128, 1) / 3u32;
    assert_eq!(Float::from(Mp::<2>::from(&third)), third);
    assert!(Mp::<1>::from(&Float::with_val(64, f64::NAN)).is_nan());
    assert_eq!(Mp::<1>::from(&third), Mp::<1>::int(1) / Mp::int(3));
}
