use super::{Residue, Standing, Tally, damped, places, proved, verify_enclosed};
use crate::float::ball::Radius;
use core::ops::ControlFlow;

/// A ball that is too wide to decide and a point without a proved motion let no statement pass.
#[test]
fn what_is_not_decided_does_not_pass() {
    let undecided = Residue { most: Radius::INFINITE, least: Radius::ZERO, has_zero: true };
    let nothing = Residue { most: Radius::ZERO, ..undecided };
    let apart = Residue { most: Radius::ONE, least: Radius::ONE, has_zero: false };
    for (residue, holds, refuted) in [(undecided, false, false), (nothing, true, false), (apart, false, true)]
    {
        for (standing, passes) in [(Standing::Holds, holds), (Standing::Refuted, refuted)] {
            let mut tally = Tally { points: 0, worst: None, all_pass: true };
            tally.add(residue, 0, standing, 64);
            assert_eq!((tally.all_pass, tally.points), (passes, 1), "{residue:?} {standing:?}");
        }
    }
    let place = places().into_iter().find(|place| place.with_motion).unwrap();
    let found = proved::against::<5>(&place, 64, None);
    assert!(found.len() == proved::ROWS.len() && found.iter().flatten().count() == found.len());
    assert!(found.iter().flatten().all(|residue| residue.has_zero && !residue.is_small(64)));
}

#[test]
fn a_place_is_written_with_its_own_ratios() {
    let number = |text: &str| text.parse::<f64>().unwrap();
    for place in places().iter().chain(&damped::places()) {
        let (omega, alpha) = place.written();
        for (text, ratio) in [(omega, &place.omega), (alpha, &place.alpha)] {
            let expected = ratio.middle().to_f64();
            assert!((number(&text) - expected).abs() <= f64::EPSILON * expected, "{text} {expected}");
        }
    }
}

#[test]
fn every_ball_has_zero_in_it_and_is_small() {
    for bits in [53, 300] {
        let found = verify_enclosed::<()>(bits, |_, _| ControlFlow::Continue(())).unwrap();
        let ControlFlow::Continue(verdicts) = found else { panic!("ended by nobody") };
        let failed: Vec<_> = verdicts.iter().filter(|v| !v.passed || v.points < 3).collect();
        // No statement is checked at more points than there are.
        let most = verdicts.iter().map(|v| v.points).max().unwrap();
        assert!(most <= places().len().max(damped::places().len()), "{most}");
        assert!(failed.is_empty() && verdicts.len() > 60, "{} {failed:#?}", verdicts.len());
        // A residual that is exactly zero would prove nothing: most balls must have a width.
        let holding = || verdicts.iter().filter(|v| v.standing == Standing::Holds);
        assert!(holding().filter(|v| v.worst > 0.0).count() > 50);
    }
}

#[test]
fn it_ends_where_it_is_told_to_and_refuses_other_bits() {
    let mut steps = 0;
    let ended = verify_enclosed::<usize>(64, |done, all| {
        steps += 1;
        assert!(all > 100);
        if done == 2 { ControlFlow::Break(done) } else { ControlFlow::Continue(()) }
    });
    assert!(matches!(ended, Ok(ControlFlow::Break(2))) && steps == 3);
    for bits in [0, 4097] {
        let error = verify_enclosed::<()>(bits, |_, _| ControlFlow::Continue(())).unwrap_err();
        assert!(error.to_string().starts_with("precision in bits"), "{error}");
    }
}
