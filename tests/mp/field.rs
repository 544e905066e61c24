//! nalgebra over `Mp`: matrices, and every function of its traits compared with that of `f64`.

use crate::traits::{NUMBERS, same_rows};
use approx::{AbsDiffEq, RelativeEq, UlpsEq};
use nalgebra::{ComplexField, RealField, SMatrix, SVector, SimdValue};
use simba::scalar::{SubsetOf, SupersetOf};
use stickslip::float::Mp;

type Number = Mp<4>;

#[test]
fn a_hilbert_system_at_256_bits() {
    let matrix = SMatrix::<Number, 5, 5>::from_fn(|i, j| Number::from(1) / Number::from(i + j + 1));
    let right = SVector::<Number, 5>::from_fn(|i, _| Number::from(i) - Number::from(2));
    let solution = matrix.lu().solve(&right).unwrap();
    let residual = (matrix * solution - right).amax();
    assert!(residual < Number::from(1).scale2(-256 + 14), "{residual:e}");
    // At f64 the same residual is about 200 bits larger, so that the solution did use the precision.
    assert!(solution.amax() > Number::from(1000));
    // det = 1/266 716 800 000
    let determinant = matrix.determinant() * Number::from(266_716_800_000u64);
    assert!((determinant - Number::from(1)).abs() < Number::from(1).scale2(-256 + 24));
}

#[test]
fn eigenvalues_and_singular_values() {
    let matrix = SMatrix::<Number, 2, 2>::new(2.into(), 1.into(), 1.into(), 2.into());
    let eigen = matrix.symmetric_eigen().eigenvalues;
    let near = |x: Number, n: i32| (x - Number::from(n)).abs() < Number::from(1).scale2(-250);
    assert!(near(eigen.amin(), 1) && near(eigen.amax(), 3));
    assert!(near(matrix.svd(true, true).singular_values.amax(), 3));
}

/// Every function of nalgebra's number types at x and y, expressed as numbers.
fn functions<T: RealField + Copy>(x: T, y: T) -> Vec<(&'static str, T)> {
    let truth = |is: bool| if is { T::one() } else { T::zero() };
    let or_two = |value: Option<T>| value.unwrap_or(T::one() + T::one());
    macro_rules! row {
        ($($name:ident($($argument:expr),*))*) => { vec![$((stringify!($name), x.$name($($argument),*))),*] };
    }
    let mut row = row! {
        real() imaginary() modulus() modulus_squared() argument() norm1() scale(y) unscale(y) conjugate() recip()
        floor() ceil() round() trunc() abs() sqrt() cbrt() sin() cos() tan() asin() acos() atan() sinh() cosh() tanh()
        asinh() acosh() atanh() exp() exp2() exp_m1() ln() log2() log10() ln_1p() mul_add(y, y) hypot(y) powf(y) powc(y) powi(3)
        powi(-2) log(y) copysign(y) clamp(-y.abs(), y.abs()) clamp(y.abs(), y.abs() + x.abs()) atan2(y)
    };
    let (sine, cosine) = x.sin_cos();
    row.extend([
        ("sine", sine),
        ("cosine", cosine),
        ("from_real", T::from_real(x)),
        ("is_finite", truth(ComplexField::is_finite(&x))),
        ("try_sqrt", or_two(x.try_sqrt())),
    ]);
    // For two equal zeros f64 may return either.
    if x != y {
        row.extend([("max", x.max(y)), ("min", x.min(y))]);
    }
    // MPFR's fraction of an integer has its sign, and that of an infinity is zero.
    if ComplexField::is_finite(&x) {
        row.push(("fract", x.fract().abs()));
    }
    if x.partial_cmp(&x).is_some() {
        row.push(("is_sign_positive", truth(RealField::is_sign_positive(&x))));
        row.push(("is_sign_negative", truth(RealField::is_sign_negative(&x))));
    }
    row
}

fn constants<T: RealField>() -> Vec<(&'static str, T)> {
    macro_rules! row {
        ($($name:ident)*) => { vec![$((stringify!($name), T::$name())),*] };
    }
    row! {
        pi two_pi frac_pi_2 frac_pi_3 frac_pi_4 frac_pi_6 frac_pi_8 frac_1_pi frac_2_pi frac_2_sqrt_pi e log2_e log10_e ln_2 ln_10
    }
}

#[test]
fn every_function_is_that_of_f64() {
    for x in NUMBERS {
        for y in NUMBERS {
            same_rows(&functions(x, y), &functions(Number::from(x), Number::from(y)), &format!("{x} {y}"));
        }
    }
    same_rows(&constants::<f64>(), &constants::<Number>(), "constants");
    assert_eq!(<Number as RealField>::max_value(), Some(<Number as num_traits::real::Real>::max_value()));
    assert_eq!(<Number as RealField>::min_value(), Some(-<Number as num_traits::real::Real>::max_value()));
}

#[test]
fn functions_keep_all_digits() {
    let x = Number::from(0.375);
    macro_rules! same {
        ($($name:ident)*) => {$(
            assert_eq!(ComplexField::$name(x), x.$name(), stringify!($name));
        )*};
    }
    same!(sqrt cbrt sin cos tan asin acos atan sinh cosh tanh asinh atanh exp exp2 exp_m1 ln log2 log10 ln_1p sin_cos);
    assert_eq!(<Number as RealField>::two_pi(), Number::pi() + Number::pi());
}

/// A number is a vector with one lane, for every operation.
#[test]
#[expect(unsafe_code, reason = "two functions of the trait are unsafe by name; there is one lane")]
fn a_number_is_a_vector_of_one() {
    let (x, y) = (Number::from(3), Number::from(-0.5));
    assert_eq!(
        (Number::LANES, Number::splat(x), x.extract(0), unsafe { x.extract_unchecked(0) }),
        (1, x, x, x)
    );
    assert_eq!((x.select(true, y), x.select(false, y)), (x, y));
    let (mut one, mut other) = (x, x);
    one.replace(0, y);
    unsafe { other.replace_unchecked(0, y) };
    assert_eq!((one, other), (y, y));
}

#[test]
fn all_reals_are_one_set() {
    let x = Number::from(0.375);
    assert_eq!(
        (SubsetOf::<Number>::to_superset(&x), <Number as SubsetOf<Number>>::from_superset_unchecked(&x)),
        (x, x)
    );
    assert!(<Number as SubsetOf<Number>>::is_in_subset(&x));
    assert_eq!((Number::from_subset(&0.375f64), Number::from_subset(&0.375f32)), (x, x));
    assert_eq!((x.to_subset(), x.to_subset()), (Some(0.375f64), Some(0.375f32)));
    assert!(SupersetOf::<f64>::is_in_subset(&Number::pi()) && SupersetOf::<f32>::is_in_subset(&Number::pi()));
}

#[test]
fn close_is_what_approx_says() {
    let (one, zero) = (Number::from(1), Number::ZERO);
    let x = Number::from(1.375);
    let (step, away) = (x.ulp(), |steps: i32| x + x.ulp() * Number::from(steps));
    assert_eq!((Number::default_epsilon(), Number::default_max_relative()), (one.ulp(), one.ulp()));
    assert_eq!(Number::default_max_ulps(), 4);
    // Comparison by distance.
    assert!(x.abs_diff_eq(&away(3), step.scale2(2)) && x.abs_diff_eq(&away(-4), step.scale2(2)));
    assert!(!x.abs_diff_eq(&away(5), step.scale2(2)) && !x.abs_diff_eq(&away(-5), step.scale2(2)));
    // Comparison by distance, or by a fraction of the larger number.
    let share = |a: Number, b: Number, share: f64| a.relative_eq(&b, zero, Number::from(share));
    assert!(
        share(Number::from(-80), Number::from(-100), 0.2) && share(Number::from(100), Number::from(81), 0.2)
    );
    assert!(
        !share(Number::from(-79), Number::from(-100), 0.2) && !share(Number::from(2), Number::from(-2), 0.2)
    );
    assert!(Number::from(1).relative_eq(&Number::from(2), Number::from(1), zero));
    // Comparison in units in the last place of the larger number, on one side of zero.
    let units = |a: Number, b: Number, count: u32| a.ulps_eq(&b, zero, count);
    assert!(units(x, away(3), 3) && units(away(-3), x, 3) && units(-x, -away(3), 3));
    assert!(!units(x, away(4), 3) && !units(away(-4), x, 3) && !units(x, -x, u32::MAX));
    let tiny = Number::from(1).scale2(-1000);
    assert!(!units(tiny, -tiny, 4) && tiny.ulps_eq(&-tiny, tiny.scale2(1), 0));
    // Equal numbers are close, an infinity is close to no other number, and NaN to none.
    let infinite = Number::INFINITY;
    for close in [
        |a: &Number, b: &Number| a.abs_diff_eq(b, Number::from(1)),
        |a: &Number, b: &Number| a.relative_eq(b, Number::from(1), Number::from(1)),
        |a: &Number, b: &Number| a.ulps_eq(b, Number::from(1), 4),
    ] {
        assert!(close(&infinite, &infinite) && !close(&infinite, &Number::from(9)));
        assert!(!close(&infinite, &-infinite) && !close(&Number::NAN, &Number::NAN));
    }
}
