//! Where there is no solution, the solver reports it.

use stickslip::cycle::matching::newton::{self, MatchingError};
use stickslip::{Border, Cycle, PhaseFunction, Ratios};

#[test]
fn below_the_end_of_the_branch_there_is_no_cycle() {
    let omega = 0.7f64;
    let end = PhaseFunction::new(omega).unwrap().value().abs();
    let error = newton::solve(Ratios::new(omega, end * 0.8).unwrap()).unwrap_err();
    // The path from zero friction ends where α is |K|: at 0.8 of the friction.
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

#[test]
fn an_iteration_that_does_not_settle_is_no_answer() {
    // On the border at Ω = 1 itself, the cycle is infinitely small compared with A.
    let error = newton::solve_border(1.0).unwrap_err();
    assert!(matches!(error, MatchingError::NoConvergence { .. }), "{error}");
    assert!(error.to_string().starts_with("last Newton step = "), "{error}");
}

#[test]
fn the_lost_bits_hold_far_from_resonance() {
    for omega in [1e-4f64, 1e-2, 1e2, 1e4] {
        let alpha = Border::new(omega).unwrap().min_force_ratio * 2.0;
        let c = Cycle::new(Ratios::new(omega, alpha).unwrap()).unwrap();
        let found = newton::solve(c.ratios).unwrap();
        let error = found.unknowns.max_displacement / c.max_displacement - 1.0;
        let bound = f64::EPSILON * 2f64.powi(found.lost_bits as i32);
        assert!(error.abs() <= bound && bound < 1e-3, "{omega}: {error:e}, {} bits", found.lost_bits);
    }
    // The same code runs at single precision.
    let found = newton::solve(Ratios::new(0.7f32, 2.0).unwrap()).unwrap();
    assert!((found.unknowns.max_displacement - 3.488_508).abs() < 2e-5);
}

#[test]
fn where_the_digits_do_not_suffice_it_is_said() {
    // On the border 80 bits are lost at a distance of 1e-12, while f64 has 53.
    for off in [1e-9, 1e-10, 1e-11, 1e-12, 1e-13, -1e-9, -1e-10, -1e-11, -1e-12, -1e-13] {
        let omega = 1.0 + off;
        let alpha = Border::new(omega).unwrap().min_force_ratio;
        let answer = newton::solve(Ratios::new(omega, alpha).unwrap());
        match answer {
            Ok(found) => {
                assert!(found.lost_bits > 40 && found.residuals.iter().all(|r| *r < 32.0), "{found:?}")
            }
            Err(MatchingError::NotACycle { .. } | MatchingError::NoConvergence { .. }) => {}
            Err(other) => panic!("{off}: {other}"),
        }
    }
}

/// The search for the fastest instant takes 1/Ω of time; Ω → 0 is refused, and what is answered takes its time at most.
#[test]
fn a_low_frequency_ratio_is_refused_or_answered_in_time() {
    for omega in [1e-70, 1e-20, 1e-6, 6e-5] {
        let errors =
            [newton::solve(Ratios::new(omega, 2.0).unwrap()).err(), newton::solve_border(omega).err()];
        for error in errors.map(Option::unwrap) {
            let words = error.to_string();
            assert!(matches!(error, MatchingError::Input(_)), "{words}");
            assert!(
                words.contains("frequency ratio Ω = ") && words.contains("≥ 0.00006103515625"),
                "{words}"
            );
        }
    }
    // Where the path meets many folds, its searches have a budget.
    let begin = std::time::Instant::now();
    for alpha in [1.0, 1.02, 1.3, 3.0] {
        drop(newton::solve(Ratios::new(7e-5, alpha).unwrap()));
    }
    drop(newton::solve_border(7e-5));
    let time = begin.elapsed();
    assert!(time.as_secs_f64() < 60.0, "{time:?}");
}
