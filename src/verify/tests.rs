//! Tests of `verify.rs`.

use super::{Case, Digits, Identity, Residual, Standing, TOLERANCE, Tally, Verdict, above_border, verify};
use crate::nonsticking::Solvable;
use core::ops::ControlFlow;

fn verdicts<F: Solvable>() -> Vec<Verdict> {
    match verify::<F, ()>(|_, _| ControlFlow::Continue(())) {
        ControlFlow::Continue(verdicts) => verdicts,
        ControlFlow::Break(()) => panic!("ended by nobody"),
    }
}

fn all_hold<F: Solvable>() {
    let verdicts = verdicts::<F>();
    let failed: Vec<_> = verdicts.iter().filter(|v| !v.passed || v.points < 3).collect();
    assert!(failed.is_empty() && verdicts.len() > 80, "{} {failed:#?}", verdicts.len());
    let worst = verdicts.iter().filter(|v| v.standing == Standing::Holds);
    let worst = worst.map(|v| v.worst).fold(0.0, f64::max);
    assert!(worst > 1.0 && worst < TOLERANCE / 2.0, "{worst}");
}

#[test]
fn all_hold_and_the_misprints_fail() {
    all_hold::<f64>();
}

#[cfg(feature = "mp")]
#[test]
fn at_256_bits_too() {
    all_hold::<crate::float::mp::Mp<4>>();
}

#[test]
fn a_wrong_sign_is_caught() {
    // Eq. 29 with b of eq. 31 taken with the wrong sign.
    let wrong: Identity<f64> = Identity {
        equation: "29",
        statement: "b with the wrong sign",
        standing: Standing::Holds,
        digits: Digits::All,
        residual: Residual::OfCase(|c: &Case<'_, f64>| {
            let (s, cosine) = c.given.lag(&c.unknowns).sin_cos();
            let (a, b) = (c.given.coefficient_a(&c.unknowns), c.given.coefficient_b(&c.unknowns));
            Some(a * s + b * cosine - 2.0)
        }),
    };
    let cycle = above_border(0.7, 1.5).unwrap();
    let residual = wrong.relative_residual(&Case::new(cycle)).unwrap();
    assert!(residual > 1e-3);
    // An identity without points does not pass, nor does a wrong one, whether alone or among right ones. A
    // misprint passes if it is refuted.
    let passed = |standing, residuals: &[f64]| {
        let mut tally = Tally { points: 0, worst: None };
        residuals.iter().for_each(|&residual| tally.add(standing, residual, &cycle));
        let verdict = tally.verdict(wrong.equation, wrong.statement, standing);
        assert_eq!(verdict.points, residuals.len());
        verdict.passed
    };
    assert!(!passed(Standing::Holds, &[]) && !passed(Standing::Refuted, &[]));
    assert!(passed(Standing::Holds, &[0.0, 1e-16]) && !passed(Standing::Refuted, &[0.0, 1e-16]));
    assert!(
        !passed(Standing::Holds, &[0.0, residual, 1e-16]) && !passed(Standing::Refuted, &[residual, 0.0])
    );
    assert!(
        !passed(Standing::Holds, &[0.0, f64::NAN, 0.0]) && !passed(Standing::Refuted, &[1.0, f64::NAN, 1.0])
    );
    assert!(passed(Standing::Refuted, &[residual, 1.0]));
}

#[test]
fn progress_reaches_its_end() {
    let mut last = (0, 0);
    let told = verify::<f64, ()>(|done, all| {
        assert!(done >= last.0 && done <= all);
        last = (done, all);
        ControlFlow::Continue(())
    });
    assert!(last.0 == last.1 && last.1 > 50 && told.is_continue());
    // The check stops when the callback says so.
    let mut steps = 0;
    let ended = verify::<f64, usize>(|done, _| {
        steps += 1;
        if done == 2 { ControlFlow::Break(done) } else { ControlFlow::Continue(()) }
    });
    assert!(matches!(ended, ControlFlow::Break(2)) && (5..20).contains(&steps));
}
