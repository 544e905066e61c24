//! The verdict and the closed-form multipliers, compared with the exact motion.

use crate::random::Random;
use stickslip::motion::{LongRun, State};
use stickslip::{Border, Cycle, Ratios, Response, Verdict};

fn verdict(omega: f64, alpha: f64) -> Verdict<f64> {
    Verdict::new(Ratios::new(omega, alpha).unwrap())
}

/// Whether the verdict agrees with the motion from rest; `None` where one of them is undecided.
fn agrees(omega: f64, alpha: f64) -> Option<bool> {
    let ratios = Ratios::new(omega, alpha).unwrap();
    let motion = LongRun::from_start(ratios, State::default()).unwrap();
    let sticks = motion.steady_state().map(|s| (s.sticks_per_cycle, s.velocity_zeros_per_cycle));
    Some(match (Verdict::new(ratios), motion) {
        (Verdict::Undecided(..), _) | (_, LongRun::NotConverged { .. }) => return None,
        (_, motion) if hidden(&Response::new(ratios), &motion) => return None,
        (Verdict::AtRest, motion) => matches!(motion, LongRun::Rest(_)),
        (Verdict::Sticking, LongRun::Periodic(_)) => sticks.is_some_and(|(sticks, _)| sticks > 0),
        (Verdict::SixReversals, LongRun::Periodic(_)) => sticks == Some((0, 6)),
        (Verdict::NonSticking, LongRun::Periodic(_)) | (Verdict::Degenerate(_), LongRun::Family(_)) => {
            sticks == Some((0, 2))
        }
        (Verdict::Unbounded, motion) => matches!(motion, LongRun::Unbounded { .. }),
        _ => false,
    })
}

/// Whether the accuracy of the motion is too low to decide. Inside a half cycle the velocity comes within `|α
/// − α_min| sin τ*` of zero, and the motion states its possible distance from the limit.
fn hidden(answer: &Response<f64>, motion: &LongRun<f64>) -> bool {
    let border = answer.border;
    let miss = (answer.ratios.alpha() - border.min_force_ratio).abs() * border.border_phase.sin();
    let (x, v) = motion.steady_state().map_or((0.0, 0.0), |s| s.distance);
    miss > 0.0 && miss < 16.0 * x.max(v)
}

#[test]
fn the_verdict_is_that_of_the_motion() {
    let mut random = Random(17);
    let (mut open, count) = (0, 120_000);
    for i in 0..count {
        let omega = random.scale(0.05, 400.0);
        let alpha = match i % 3 {
            0 => random.scale(0.8, 600.0),
            1 => Border::new(omega).unwrap().min_force_ratio * random.between(0.9, 1.1),
            _ => Border::new(omega).unwrap().min_force_ratio * random.scale(0.3, 30.0),
        };
        match agrees(omega, alpha) {
            Some(agrees) => assert!(agrees, "({omega}, {alpha}): {:?}", verdict(omega, alpha)),
            None => open += 1,
        }
    }
    assert!(open <= count / 1000, "{open} of {count} not settled");
}

#[test]
fn a_billionth_from_the_border_the_motion_agrees() {
    let mut random = Random(23);
    let (mut open, count) = (0, 30_000);
    for i in 0..count {
        let omega = random.scale(0.05, 400.0);
        let side = if i % 2 == 0 { 1.0 } else { -1.0 };
        let alpha =
            Border::new(omega).unwrap().min_force_ratio * (1.0 + side * random.between(0.9e-9, 1.1e-9));
        match agrees(omega, alpha) {
            Some(agrees) => assert!(agrees, "({omega}, {alpha}): {:?}", verdict(omega, alpha)),
            None => open += 1,
        }
    }
    assert!(open <= count / 100, "{open} of {count} not settled");
}

/// Near a pole there is a motion below the border that does not stop: it reverses six times a cycle.
#[test]
fn beside_a_pole_below_the_border_it_may_reverse_instead_of_stopping() {
    for (omega, alpha) in [(0.334_325, 149.563), (0.330_15, 66.562), (0.198_7, 230.688), (0.090_71, 1362.534)]
    {
        assert_eq!(verdict(omega, alpha), Verdict::SixReversals);
        let motion = LongRun::from_start(Ratios::new(omega, alpha).unwrap(), State::default()).unwrap();
        let steady = motion.steady_state().unwrap();
        assert_eq!((steady.sticks_per_cycle, steady.velocity_zeros_per_cycle), (0, 6));
    }
    // Just below the border, the velocity touches zero while the force is just within the friction force:
    // there the body stops.
    let alpha = Border::new(0.334_325).unwrap().min_force_ratio * (1.0 - 1e-3);
    let motion = LongRun::from_start(Ratios::new(0.334_325, alpha).unwrap(), State::default()).unwrap();
    assert_eq!(motion.steady_state().map(|s| s.sticks_per_cycle), Some(2));
}

/// The closed form is compared with the eigenvalues of the monodromy matrix of the motion itself.
#[test]
fn the_multipliers_are_those_of_the_motion() {
    let mut random = Random(31);
    let mut seen = [0, 0];
    while seen[0] < 1000 || seen[1] < 1000 {
        let omega = random.scale(0.1, 10.0);
        let alpha = Border::new(omega).unwrap().min_force_ratio * random.scale(1.0001, 30.0);
        let Ok(cycle) = Cycle::new(Ratios::new(omega, alpha).unwrap()) else { continue };
        let Ok(LongRun::Periodic(steady)) = LongRun::try_from(&cycle) else { continue };
        let closed = cycle.multipliers().cycle;
        seen[usize::from(closed[0].1 == 0.0)] += 1;
        let (mut a, mut b) = (closed, steady.multipliers);
        a.sort_by(|x, y| y.partial_cmp(x).unwrap());
        b.sort_by(|x, y| y.partial_cmp(x).unwrap());
        // Sum and product are smooth, while the roots behave like a square root where they meet.
        let sum = |m: [(f64, f64); 2]| m[0].0 + m[1].0;
        let product = |[(a, b), (c, d)]: [(f64, f64); 2]| a * c - b * d;
        // The velocity at a reversal, which is a divisor, is small near the border.
        let slack = 1e-10 * (1.0 + 1.0 / omega).powi(3);
        assert!((sum(a) - sum(b)).abs() < slack, "{:?}: {a:?} {b:?}", cycle.ratios);
        assert!((product(a) - product(b)).abs() < slack, "{:?}: {a:?} {b:?}", cycle.ratios);
        let apart = (a[0].0 - a[1].0).hypot(a[0].1 - a[1].1);
        for (x, y) in a.iter().zip(&b) {
            let error = (x.0 - y.0).hypot(x.1 - y.1);
            assert!(error * apart < 4.0 * slack, "{:?}: {a:?} {b:?}", cycle.ratios);
        }
    }
    assert!(
        (Cycle::new(Ratios::new(0.7, 2.0).unwrap()).unwrap().multipliers().contraction - 0.261_820_7f64)
            .abs()
            < 1e-7
    );
}

/// Within a few floats of a pole, Newton's step leads so far out that rounding hides the residual: that is no
/// limit.
#[test]
fn a_few_floats_from_a_pole_the_motion_settles() {
    use stickslip::motion::{LongRun, State};
    for (odd, alphas) in
        [(3.0, [2.0, 15.0, 30.0, 60.0]), (5.0, [5.0, 40.0, 150.0, 151.0]), (7.0, [60.0, 100.0, 150.0, 300.0])]
    {
        for floats in -9_i32..=9 {
            let omega = 1.0 / odd * (1.0 + f64::from(floats) * f64::EPSILON);
            for alpha in alphas {
                let limit =
                    LongRun::from_start(Ratios::new(omega, alpha).unwrap(), State::default()).unwrap();
                let steady = limit.steady_state().unwrap_or_else(|| panic!("{omega:?} {alpha}: {limit:?}"));
                let reach = steady.max_displacement.value;
                assert!(reach > 0.0 && reach < 2.0 * alpha, "{omega:?} {alpha}: {reach}");
                if odd == 3.0 && alpha == 30.0 {
                    assert!((reach - 29.400_998_007_738).abs() < 1e-9, "{omega:?}: {reach}");
                    assert_eq!(steady.sticks_per_cycle, 2);
                }
            }
        }
    }
}
