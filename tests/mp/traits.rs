//! Generic code gets the same from `Mp` as from `f64`: the functions of num-traits, and the comparison that
//! the tests of nalgebra share.

use num_traits::{FromPrimitive, Inv, MulAdd, One, Pow, Signed, ToPrimitive, Zero};
use stickslip::float::Mp;

/// Doubles of every kind: both signs, integers, fractions, ties, beyond the integers, infinite, NaN.
pub(crate) const NUMBERS: [f64; 17] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.375,
    -0.625,
    2.5,
    -1.5,
    7.0,
    -12.0,
    1e-9,
    123.456,
    -9.0e15,
    2.0e19,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
];

/// Asserts the same values under the same names, to within the accuracy of the system's functions.
pub(crate) fn same_rows<const L: usize>(of_f64: &[(&str, f64)], of_mp: &[(&str, Mp<L>)], at: &str) {
    assert_eq!(of_f64.len(), of_mp.len());
    for ((name, double), (_, wide)) in of_f64.iter().zip(of_mp) {
        let near = stickslip::Float::to_f64(*wide);
        let is_same = near == *double
            || (near.is_nan() && double.is_nan())
            || (near - double).abs() <= 4.0 * f64::EPSILON * double.abs()
            // The double overflows or underflows, while `Mp` does not yet.
            || (double.is_infinite() && near.signum() == double.signum() && near.abs() >= f64::MAX)
            || (double.abs() < f64::MIN_POSITIVE && near.abs() < f64::MIN_POSITIVE);
        assert!(is_same, "{name} of {at}: {wide:e} for {double:e}");
        let sign_counts = *double == 0.0 && wide.is_zero();
        assert!(
            !sign_counts || double.is_sign_negative() == wide.is_negative(),
            "{name} of {at}: {wide:?} {double:?}"
        );
    }
}

trait Number:
    Signed
    + FromPrimitive
    + ToPrimitive
    + num_traits::NumCast
    + Inv<Output = Self>
    + MulAdd<Output = Self>
    + Pow<i32, Output = Self>
    + Pow<Self, Output = Self>
    + PartialOrd
    + Copy
{
}
impl Number for f64 {}
impl<const L: usize> Number for Mp<L> {}

fn functions<T: Number>(x: T, y: T) -> Vec<(&'static str, T)> {
    let truth = |is: bool| if is { T::one() } else { T::zero() };
    let mut row = vec![
        ("abs", x.abs()),
        ("abs_sub", if x == y { T::zero() } else { x.abs_sub(&y) }),
        ("signum", x.signum()),
        ("inv", x.inv()),
        ("mul_add", x.mul_add(y, x)),
        ("pow", Pow::pow(x, y)),
        ("pow of 3", Pow::pow(x, 3)),
        ("is_zero", truth(x.is_zero())),
        ("is_one", truth(x.is_one())),
        ("rem", x % y),
    ];
    if x.partial_cmp(&x).is_some() {
        row.extend([("is_positive", truth(x.is_positive())), ("is_negative", truth(x.is_negative()))]);
    }
    row
}

#[test]
fn every_function_is_that_of_f64() {
    for x in NUMBERS {
        for y in NUMBERS {
            same_rows(&functions(x, y), &functions(Mp::<1>::from(x), Mp::<1>::from(y)), &format!("{x} {y}"));
        }
    }
    assert_eq!((Mp::<2>::zero(), Mp::<2>::one()), (Mp::from(0), Mp::from(1)));
}

#[test]
fn casts_are_those_of_f64() {
    for x in NUMBERS
        .into_iter()
        .chain([9.2e18, -9.3e18, 1.8e19, 1.9e19, 1.7e38, 1.8e38, -1.8e38, 3.4e38, 3.5e38, -0.9, 1e300])
    {
        let wide = Mp::<2>::from(x);
        macro_rules! same {
            ($($cast:ident)*) => {$(
                assert_eq!(ToPrimitive::$cast(&wide), ToPrimitive::$cast(&x), "{} of {x}", stringify!($cast));
            )*};
        }
        same!(to_i64 to_u64 to_i128 to_u128 to_i32 to_u8);
        if !x.is_nan() {
            same!(to_f32 to_f64);
            assert_eq!(<Mp<2> as num_traits::NumCast>::from(x), Some(wide));
            assert_eq!(<Mp<2> as num_traits::NumCast>::from(wide), Some(wide));
            assert_eq!(
                (Mp::from_f64(x), Mp::<2>::from_f32(x as f32)),
                (Some(wide), Some(Mp::from(x as f32)))
            );
        }
    }
    let n = i64::MAX - 1;
    assert_eq!(
        (Mp::<1>::from_i64(-n), Mp::<1>::from_u64(u64::MAX)),
        (Some(Mp::from(-n)), Some(Mp::from(u64::MAX)))
    );
    let m = i128::MAX - 1;
    assert_eq!(
        (Mp::<2>::from_i128(-m), Mp::<2>::from_u128(u128::MAX)),
        (Some(Mp::from(-m)), Some(Mp::from(u128::MAX)))
    );
    assert_eq!(<Mp<2> as num_traits::NumCast>::from(m), Some(Mp::from(m)));
    // An integer beyond the range of the integer types.
    assert_eq!(<Mp<2> as num_traits::NumCast>::from(1e40f64), Some(Mp::from(1e40)));
}
