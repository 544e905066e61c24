//! The formulae get the same from `Mp` as from `f64`: `Real`, `Float`, and the widths for the start of an
//! iteration and for guard digits.

use crate::traits::{NUMBERS, same_rows};
use stickslip::float::AtPrecision;
use stickslip::float::Mp;
use stickslip::{Field, Float, Real};

/// Every function that the formulae use.
fn of_the_formulae<T: Float>(x: T, y: T) -> Vec<(&'static str, T)> {
    let truth = |is: bool| T::int(i32::from(is));
    let (sine, cosine) = Real::sin_cos(x);
    let mut row = vec![
        ("int", T::int(-7)),
        ("pi", <T as Real>::pi()),
        ("ratio", T::ratio(-22, 7)),
        ("sqrt", Field::sqrt(x)),
        ("abs", Field::abs(x)),
        ("sine", sine),
        ("cosine", cosine),
        ("sin", Real::sin(x)),
        ("cos", Real::cos(x)),
        ("tan", Real::tan(x)),
        ("atan2", Real::atan2(x, y)),
        ("hypot", Field::hypot(x, y)),
        ("mul_add", Real::mul_add(x, y, x)),
        ("square", Field::square(x)),
        ("exp2i", T::exp2i(-9)),
        ("from_f64", T::from_f64(0.1f32.into())),
        ("floor", Float::floor(x)),
        ("round", Float::round(x)),
        ("is_finite", truth(Float::is_finite(x))),
    ];
    if !x.to_f64().is_nan() && !y.to_f64().is_nan() {
        row.extend([("with_sign_of", x.with_sign_of(y)), ("or_larger", x.or_larger(y))]);
    }
    row
}

#[test]
fn the_formulae_see_what_they_see_of_f64() {
    for x in NUMBERS {
        let wide = Mp::<2>::from(x);
        assert!(Float::to_f64(wide) == x || x.is_nan() && Float::to_f64(wide).is_nan());
        for y in NUMBERS {
            same_rows(&of_the_formulae(x, y), &of_the_formulae(wide, Mp::<2>::from(y)), &format!("{x} {y}"));
        }
    }
}

/// The widths in bits at which starts are found and guard digits are kept.
#[test]
fn narrower_and_wider_types() {
    struct Width;
    impl<F> AtPrecision<F> for Width {
        type Output = u32;
        fn run<G: Float>(self, _: impl Fn(F) -> G, _: impl Fn(G) -> F) -> u32 {
            G::PRECISION
        }
    }
    fn widths<F: Float>() -> (u32, u32) {
        (F::narrowed(Width), F::guarded(Width))
    }
    let limbs = |(narrow, wide): (u32, u32)| (narrow as f64 / 64.0, wide as f64 / 64.0);
    assert_eq!(widths::<Mp<1>>().0, f64::MANTISSA_DIGITS);
    assert_eq!(widths::<Mp<3>>().0, f64::MANTISSA_DIGITS);
    macro_rules! check {
        ($($width:literal: $narrow:literal $wide:literal;)*) => {$(
            assert_eq!(limbs(widths::<Mp<$width>>()), ($narrow as f64, $wide as f64), "{}", $width);
        )*};
    }
    check! {
        4: 2 5; 5: 3 7; 6: 3 7; 7: 3 9; 8: 3 9; 9: 5 13; 12: 5 13; 13: 5 17; 16: 5 17; 17: 9 25; 24: 9 25; 25: 9 33; 32: 9 33;
        33: 17 49; 48: 17 49; 49: 17 65; 64: 17 65; 65: 33 97; 96: 33 97; 97: 33 129; 128: 33 129;
    }
    // A start has a quarter of the digits and a guard limb; the wider type has at least one limb more.
    assert_eq!(
        (limbs(widths::<Mp<1>>()).1, limbs(widths::<Mp<2>>()).1, limbs(widths::<Mp<3>>()).1),
        (2.0, 3.0, 4.0)
    );
    assert_eq!(limbs(widths::<Mp<129>>()), (65.0, 129.0));
}
