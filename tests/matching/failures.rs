//! Where there is nothing to find, the solver says so.

use stickslip::nonsticking::matching::newton::{self, MatchingError};
use stickslip::{PhaseFunction, Ratios};

#[test]
fn below_the_end_of_the_branch_there_is_no_cycle() {
    let omega = 0.7f64;
    let end = PhaseFunction::new(omega).unwrap().value().abs();
    let error = newton::solve(Ratios::new(omega, end * 0.8).unwrap()).unwrap_err();
    // The path from no friction ends where α is |K|: at 0.8 of the friction.
    match &error {
        MatchingError::NoCycle { part, .. } => assert!((part - 0.8).abs() < 1e-6, "{part}"),
        other => panic!("{other}"),
    }
    let message = error.to_string();
    assert!(message.contains("0.8") && message.contains("Ω = 0.7"), "{message}");
    assert!(newton::solve(Ratios::new(omega, end * 1.001).unwrap()).is_ok());
}

#[test]
fn at_resonance_there_is_none_either() {
    let error = newton::solve(Ratios::new(1.0, 2.0).unwrap()).unwrap_err();
    assert!(matches!(error, MatchingError::Resonance));
}

#[test]
fn a_frequency_ratio_outside_its_domain_is_refused() {
    let error = newton::solve_border(-1.0).unwrap_err();
    assert!(matches!(error, MatchingError::Input(_)) && error.to_string().contains("-1"), "{error}");
}
