//! The motion of six reversals near the poles 1/(2n+1), compared with the exact motion; every command has the
//! same verdict at a point.

#![allow(clippy::print_stdout, reason = "the figures measured, shown with --nocapture")]

mod damped;

use super::random::Random;
use std::f64::consts::PI;
use std::ops::ControlFlow;
use stickslip::cycle::SixReversals;
use stickslip::float::Mp;
use stickslip::internal::observed;
use stickslip::motion::{Kind, LongRun, State, Trajectory};
use stickslip::{Border, Error, Float, Ratios, Regime, Response};
use stickslip::{NoStop, stops_per_cycle};

/// The force ratios without a stop.
fn without_stop<F: Float>(omega: F, zeta: F) -> Result<NoStop<F>, Error> {
    Ok(NoStop::of(&Ratios::new(omega, F::int(1))?.with_damping_ratio(zeta)?))
}

/// The least and the greatest force ratio of six reversals.
fn force_ratios<F: Float>(omega: F) -> Result<Option<(F, F)>, Error> {
    without_stop(omega, F::int(0)).map(|found| found.six_reversals)
}

fn long_run<F: Float>(omega: F, alpha: F) -> LongRun<F> {
    LongRun::from_start(Ratios::new(omega, alpha).unwrap(), State::default()).unwrap()
}

/// (stops, velocity zeros) of the exact motion from rest.
fn counts<F: Float>(ratios: Ratios<F>) -> Option<(u32, u32)> {
    let motion = LongRun::from_start(ratios, State::default()).unwrap();
    motion.steady_state().map(|s| (s.sticks_per_cycle, s.velocity_zeros_per_cycle))
}

/// Frequency ratios near the poles, with the edges there.
fn beside_poles() -> impl Iterator<Item = (f64, f64, f64)> {
    let mut random = Random(61);
    let points = std::iter::from_fn(move || {
        let pole = 3.0 + 2.0 * random.between(0.0, 8.0).floor();
        let off = random.between(-0.0207, 0.0346);
        let off = if random.between(0.0, 1.0) < 0.3 { off * random.scale(1e-6, 1.0) } else { off };
        Some(1.0 / (pole + off))
    });
    points.filter_map(|omega| force_ratios(omega).unwrap().map(|(low, high)| (omega, low, high)))
}

#[test]
fn within_its_edges_the_exact_motion_reverses_six_times_and_beyond_them_it_stops() {
    let mut random = Random(62);
    for (omega, low, high) in beside_poles().take(100) {
        let border = Border::new(omega).unwrap().min_force_ratio;
        assert!(high < border, "{omega}");
        let at = |alpha: f64| Ratios::new(omega, alpha).unwrap();
        for share in [1e-7, random.between(0.0, 1.0), 1.0 - 1e-7] {
            // Uniform in the logarithm: the greatest may be 10⁶ times the least.
            let alpha = low * (high / low).powf(share);
            assert_eq!(counts(at(alpha)), Some((0, 6)), "{omega} {alpha} of {low} to {high}");
        }
        // In the gap below the border and close to the pole, the motion may take longer to settle than the
        // budget.
        let stops = |alpha: f64| counts(at(alpha)).map(|(stops, _)| stops > 0);
        let gap = [high * (1.0 + 1e-7), f64::midpoint(high, border), border * (1.0 - 1e-7)];
        for alpha in gap.into_iter().filter(|&alpha| alpha > high && alpha < border) {
            assert!(
                alpha > 1e5 || stops(alpha) == Some(true),
                "{omega} {alpha} of {low} to {high}, {border}"
            );
        }
        assert_eq!(stops(low * (1.0 - 1e-7)), Some(true), "{omega} {low}");
    }
}

/// The cycle of the matching problem is the limit of the motion from rest, checked at 97 phases.
fn matching_problem_gives_the_exact_motion(ratios: Ratios<f64>) {
    let cycle = SixReversals::new(ratios).unwrap_or_else(|| panic!("{ratios:?}"));
    let motion = LongRun::from_start(ratios, State::default()).unwrap();
    let steady = motion.steady_state().unwrap();
    let (start, size) = (steady.state, steady.max_displacement.value);
    let close = |a: f64, b: f64| {
        let error = 1e-9 * size + steady.distance.0;
        assert!((a - b).abs() < error, "{ratios:?}: {a} {b}");
    };
    for sample in Trajectory::new(ratios, start).unwrap().samples(97).unwrap().take(97) {
        let sample = sample.unwrap();
        let theta = sample.state.phase.reduced();
        close(cycle.displacement_at(theta), sample.state.x);
        close(cycle.velocity_at(theta), sample.state.v);
    }
    assert!(cycle.forces().into_iter().all(|force| force > 1.0));
    let [first, second, third] = cycle.reversal_phases();
    assert!(first < second && second < third, "{ratios:?}");
    if !ratios.is_damped() {
        assert!(0.0 < first && third < PI, "{ratios:?}");
    }
    close(cycle.displacement_at(first).max(cycle.displacement_at(third)), size);
}

#[test]
fn its_matching_problem_gives_the_exact_motion() {
    let mut random = Random(63);
    for (omega, low, high) in beside_poles().take(200) {
        let alpha = low * (high / low).powf(random.between(0.001, 0.999));
        matching_problem_gives_the_exact_motion(Ratios::new(omega, alpha).unwrap());
    }
}

/// The error of a number at f64, in units in its last place.
fn ulps(found: f64, exact: Mp<8>) -> f64 {
    ((Mp::from(found) - exact) / exact).to_f64().abs() / f64::EPSILON
}

/// The number of stops in 40 turns of the drive from a start.
fn stops_from<F: Float>(start: State<F>, omega: F, alpha: F) -> usize {
    let motion = Trajectory::new(Ratios::new(omega, alpha).unwrap(), start).unwrap().map(Result::unwrap);
    let turns = F::int(80) * F::pi();
    motion.take_while(|p| p.start().phase - start.phase < turns).filter(|p| p.kind == Kind::Stick).count()
}

/// The edges at f64 are compared with those at 512 bits, and these with the exact motion at 512 bits. From
/// the cycle next to an edge, the motion never stops in 40 turns with a force inside the edge, and stops with
/// one outside. Where that motion settles, it stops in every cycle. Close to a pole, above the upper edge, it
/// creeps for more than 500 periods from one stop to the next.
#[test]
fn the_edges_are_sharp_at_any_precision() {
    let (mut worst, mut settled) = (0.0, 0);
    for (i, (omega, low, high)) in beside_poles().take(40).enumerate() {
        let wide = without_stop(Mp::<8>::from(omega), Mp::ZERO).unwrap();
        let (wide_low, wide_high) = wide.six_reversals.unwrap();
        let error = ulps(low, wide_low).max(ulps(high, wide_high));
        // Where the two edges meet, their error is a square root of rounding.
        if high > low * 1.2 {
            assert!(error < 40.0, "{omega}: {error}");
            worst = f64::max(worst, error);
        }
        if i < 4 {
            let (one, off) = (Mp::<8>::from(1), Mp::<8>::exp2i(-200));
            for (edge, inward) in [(wide_low, one + off), (wide_high, one - off)] {
                let (inside, beyond) = (edge * inward, edge * (one + one - inward));
                let motion = long_run(Mp::from(omega), inside);
                let steady = motion.steady_state().unwrap();
                assert_eq!((steady.sticks_per_cycle, steady.velocity_zeros_per_cycle), (0, 6), "{omega}");
                let stops = |alpha| stops_from(steady.state, Mp::from(omega), alpha);
                assert_eq!(stops(inside), 0, "{omega}");
                assert!(stops(beyond) > 0, "{omega}");
                let ratios = Ratios::new(Mp::from(omega), beyond).unwrap();
                assert!(SixReversals::new(ratios).is_none(), "{omega}");
                let motion =
                    LongRun::within(ratios, State::default(), 500, &mut || ControlFlow::Continue(()))
                        .unwrap();
                if let Some(limit) = motion.steady_state() {
                    assert!(limit.sticks_per_cycle > 0, "{omega}: {limit:?}");
                    settled += 1;
                }
            }
        }
    }
    assert!(settled >= 5, "{settled} of 8 settle");
    println!("edges at f64: {worst} ulp");
}

/// Ever closer to a pole, down to the float next to it, where the short arc is lost in rounding; and with ever
/// less damping there.
#[test]
fn the_edges_keep_their_digits_up_to_the_pole() {
    for n in [3.0, 5.0, 15.0, 217.0, 1001.0] {
        for exponent in 10..54 {
            for (sign, share) in [(-1.0, 0.0), (1.0, 0.0), (-1.0, 0.5), (1.0, 1.0)] {
                let off = 2f64.powi(-exponent);
                let (omega, zeta) = ((1.0 + sign * off) / n, share * off / n);
                let Some((low, high)) = without_stop(omega, zeta).unwrap().six_reversals else {
                    continue;
                };
                let wide = without_stop(Mp::<8>::from(omega), Mp::from(zeta)).unwrap();
                let (wide_low, wide_high) = wide.six_reversals.unwrap();
                let error = ulps(low, wide_low).max(ulps(high, wide_high));
                assert!(exponent < 14 || error < 40.0, "{omega} {zeta}: {error}");
            }
        }
    }
}

/// `response`, `steady` and `stops_per_cycle` at one point.
fn agree(omega: f64, alpha: f64) {
    let ratios = Ratios::new(omega, alpha).unwrap();
    let answer = Response::new(ratios);
    let limit = LongRun::from_start(ratios, State::default()).unwrap();
    let seen = observed(ratios, &limit);
    assert_eq!(seen.regime, answer.regime, "({omega:?}, {alpha:?}): {limit:?}");
    assert_eq!(seen.reversals, answer.reversals_per_cycle(), "({omega:?}, {alpha:?}): {limit:?}");
    match stops_per_cycle(ratios) {
        Ok(Some(stops)) => {
            assert_eq!(stops.sticks > 0, answer.regime == Regime::Sticking, "({omega:?}, {alpha:?})")
        }
        Ok(None) => assert!(matches!(answer.regime, Regime::Stuck | Regime::Unbounded)),
        Err(Error::Undecided { .. } | Error::NotSettled { .. }) => {
            assert!(seen.by_border, "({omega:?}, {alpha:?})")
        }
        Err(other) => panic!("({omega:?}, {alpha:?}): {other}"),
    }
}

/// A point below Ω = 1/2; six in ten are near a pole.
fn point(random: &mut Random, i: u32) -> (f64, f64) {
    let omega = if i % 10 < 6 {
        let pole = 3.0 + 2.0 * random.between(0.0, 6.0).floor();
        let off = random.scale(1e-12, 0.3);
        1.0 / if i.is_multiple_of(2) { pole + off } else { pole - off }
    } else {
        random.between(0.05, 0.5)
    };
    let border = Border::new(omega).unwrap().min_force_ratio;
    let edges = force_ratios(omega).unwrap();
    let alpha = match (i % 5, edges) {
        (0, _) => random.scale(1.0, border),
        (1, _) => border * random.between(0.9, 1.1),
        (2, Some((low, high))) => low * (high / low).powf(random.between(-0.2, 1.2)),
        (3, Some((low, high))) => {
            let edge = if random.between(0.0, 1.0) < 0.5 { low } else { high };
            edge * (1.0 + (random.between(0.0, 2.0) - 1.0) * random.scale(1e-14, 1e-2))
        }
        _ => random.scale(1.0, 30.0 * border),
    };
    (omega, alpha)
}

#[test]
fn one_verdict_for_one_point() {
    let count: u32 = std::env::var("VERDICTS").map_or(1500, |n| n.parse().unwrap());
    let mut random = Random(64);
    for i in 0..count {
        let (omega, alpha) = point(&mut random, i);
        agree(omega, alpha);
    }
}

#[cfg(feature = "generators")]
mod hard {
    use super::agree;
    use crate::any_bits::hard;
    use crate::drawn::cases;
    use proptest::prelude::*;
    use stickslip::Ratios;
    use stickslip::generators::Point;

    proptest! {
        #![proptest_config(cases(4_000))]

        /// A motion at Ω = 1/100 has a hundred slides in half a turn.
        #[test]
        fn one_verdict_for_a_hard_point(point in hard::<Point>()) {
            let Point { omega, alpha } = point;
            if (1e-2..1e6).contains(&omega) && Ratios::new(omega, alpha).is_ok() {
                agree(omega, alpha);
            }
        }
    }
}

/// A rounded border or edge, its neighbours, and points slightly further away.
#[test]
fn one_verdict_on_a_border_and_beside_it() {
    let mut random = Random(65);
    for (i, (beside, ..)) in beside_poles().take(40).enumerate() {
        let omega = if i % 3 == 0 { random.scale(0.05, 20.0) } else { beside };
        for edge in without_stop(omega, 0.0).unwrap().intervals().flat_map(|(low, high)| [Some(low), high]) {
            let Some(edge) = edge else { continue };
            for alpha in [edge, edge.next_up(), edge.next_down(), edge * (1.0 + 1e-11), edge * (1.0 - 1e-11)]
            {
                agree(omega, alpha);
            }
        }
    }
}

/// Points at which `response` once said "sticking" and the exact motion "non-sticking", or the reverse.
#[test]
fn found_points_have_one_verdict() {
    for (omega, alpha, expected) in [
        (0.331, 61.6, Regime::NonSticking),
        (0.334_325, 149.563, Regime::NonSticking),
        (0.33333, 0.999 * Border::new(0.33333f64).unwrap().min_force_ratio, Regime::NonSticking),
        (1.0 / 3.0, 80.0, Regime::NonSticking),
        (0.066_658_079_476_532_49, 42_358.137_294_718_49, Regime::NonSticking),
        (0.012_345_679_012_334_45, 41_074_586_362_949.69, Regime::NonSticking),
        (0.010_309_278_350_515_464, 3.335_884_628_701_366_8e16, Regime::NonSticking),
    ] {
        assert_eq!(Response::new(Ratios::new(omega, alpha).unwrap()).regime, expected, "{omega} {alpha}");
        agree(omega, alpha);
    }
}
