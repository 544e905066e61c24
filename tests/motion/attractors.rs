//! The limit that a start leads to, if there are several.

use std::ops::ControlFlow;
use stickslip::Ratios;
use stickslip::motion::{LongRun, Starts, State, attractors};

/// Each start, at any phase, is counted for the limit that it leads to, and not for the mirror image of that
/// limit.
#[test]
fn a_start_is_counted_for_its_own_limit() {
    for (omega, alpha, zeta, eta) in [(0.573, 3.92, 0.005, 1.87), (0.5, 4.0, 0.02, 1.3)] {
        let ratios = Ratios::new(omega, alpha).unwrap().with_damping_ratio(zeta).unwrap();
        let ratios = ratios.with_static_friction_ratio(eta).unwrap();
        let spread = Starts::within(8.0).unwrap();
        let at = |i: u32| {
            let start = spread.get(u64::from(i));
            State::new(0.7 * f64::from(i), start.x, start.v).unwrap()
        };
        let starts: Vec<_> = (0..40).map(at).collect();
        let all = attractors(ratios, &starts, 2000).unwrap();
        for (i, start) in starts.iter().enumerate() {
            let own = LongRun::within(ratios, *start, 2000, &mut || ControlFlow::Continue(()))
                .unwrap()
                .extrema()
                .unwrap();
            let counted = all.limits[all.of_start[i].unwrap()].limit.extrema().unwrap();
            let is_same = (own.0 - counted.0).abs() < 1e-9 && (own.1 - counted.1).abs() < 1e-9;
            assert!(is_same, "{i}: {own:?}, counted for {counted:?}");
        }
        assert!(all.limits.len() >= 2);
    }
}

/// The starts fill a square evenly: each quarter has its share.
#[test]
fn starts_fill_the_square() {
    let ratios = Ratios::new(0.5f64, 4.0).unwrap();
    // 3 + 2 (η + α/(1 − Ω²))
    let spread = Starts::around(&ratios);
    assert!((spread.reach() - (5.0 + 2.0 * 4.0 / 0.75)).abs() < 1e-12);
    assert_eq!(spread.get(0), State::default());
    let first = (1..=1000).map(|i| spread.get(i)).filter(|s| s.x > 0.0 && s.v > 0.0).count();
    assert!((240..=260).contains(&first), "{first}");
    assert!((1..1000).all(|i| spread.get(i).x.abs().max(spread.get(i).v.abs()) <= spread.reach()));
    assert!(Starts::within(0.0).is_none() && Starts::within(2f64.powi(41)).is_none());
    assert!(Starts::within(f64::NAN).is_none());
}
