use super::Border;

/// The border at Ω.
pub(super) fn at(omega: f64) -> f64 {
    Border::new(omega).unwrap().min_force_ratio
}

/// Fails where a is further from b than these units in the last place.
#[track_caller]
pub(super) fn close(a: f64, b: f64, ulps: f64) {
    assert!((a - b).abs() <= ulps * f64::EPSILON * b.abs(), "{a:e} against {b:e}");
}

/// The reference is the same condition at 60 digits.
#[test]
fn beside_one_over_2n_no_digit_is_lost() {
    for (omega, exact) in [
        (0.499_998_533_901_356_57, 3.000_023_457_784_889),
        (0.031_249_988_944_768_197, 1_023.000_724_637_401_5),
        (0.038_461_525_039_324_97, 675.000_471_869_339_2),
        (0.249_999_9, 15.000_012_800_043_951),
    ] {
        let found = at(omega);
        assert!((found / exact - 1.0f64).abs() < 8.0 * f64::EPSILON, "{omega}: {found} against {exact}");
    }
}
