//! Every output at f64 and at f32 within its allowance of the one ulp table (`tests/ulps`), against 128 bits and f64.

use crate::ulps::OUTPUTS;
use crate::ulps::points::{ALPHAS, OMEGAS};
use crate::ulps::reference::Narrow;
use crate::ulps::worst::{Survey, hex};

fn no_error_exceeds_its_allowance_and_no_allowance_is_stale<F: Narrow>() {
    let survey = Survey::of::<F>(20, 200).merge(&Survey::of::<F>(21, 200));
    assert!(survey.points > 20_000);
    for (output, worst) in OUTPUTS.iter().zip(survey.worst) {
        let (omega, alpha) = (OMEGAS[worst.measures.0], ALPHAS[worst.measures.1]);
        let place = format!("at Ω = {} ({omega}), α = {} ({alpha})", hex(worst.omega), hex(worst.alpha));
        assert!(worst.error <= output.allowed, "{}: {} ulp {place}", output.symbol, worst.error);
        // So many points come within a third of the worst there is, or the allowance is too generous.
        assert!(
            output.allowed.is_infinite() || worst.error * 3.0 >= output.allowed,
            "{}: {} ulp at worst",
            output.name,
            worst.error
        );
    }
}

#[test]
fn double_precision() {
    no_error_exceeds_its_allowance_and_no_allowance_is_stale::<f64>();
}

#[test]
fn single_precision() {
    no_error_exceeds_its_allowance_and_no_allowance_is_stale::<f32>();
}

#[test]
fn the_allowances_meet_the_goals() {
    for output in OUTPUTS {
        assert!(output.goal.is_none_or(|goal| output.allowed <= goal), "{}", output.name);
    }
}
