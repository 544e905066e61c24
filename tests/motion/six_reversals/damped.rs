//! Six reversals with a damper, compared with the exact motion.

use super::without_stop;
use super::{counts, matching_problem_gives_the_exact_motion, ulps};
use crate::random::Random;
use stickslip::NoStop;
use stickslip::float::Mp;
use stickslip::{Border, Ratios, Regime, Response};

/// Frequency and damping ratios near the poles with a cycle of six reversals, and its edges.
fn damped_beside_poles(seed: u64) -> impl Iterator<Item = (Ratios<f64>, f64, f64)> {
    let mut random = Random(seed);
    let points = std::iter::from_fn(move || {
        let pole = 3.0 + 2.0 * random.between(0.0, 5.0).floor();
        let off = random.between(-0.0207, 0.0346);
        let off = if random.between(0.0, 1.0) < 0.3 { off * random.scale(1e-4, 1.0) } else { off };
        let ratios = Ratios::new(1.0 / (pole + off), 2.0).unwrap();
        Some(ratios.with_damping_ratio(random.scale(1e-6, 7e-3)).unwrap())
    });
    points.filter_map(|ratios| {
        let found = NoStop::of(&ratios);
        found.six_reversals.map(|(low, high)| (ratios, low, high))
    })
}

fn damped_at(ratios: Ratios<f64>, alpha: f64) -> Ratios<f64> {
    let at = Ratios::new(ratios.omega(), alpha).unwrap();
    at.with_damping_ratio(ratios.damping_ratio()).unwrap()
}

fn at_256_bits(ratios: Ratios<f64>) -> Ratios<Mp<4>> {
    let at = Ratios::new(Mp::from(ratios.omega()), Mp::from(ratios.alpha())).unwrap();
    at.with_damping_ratio(Mp::from(ratios.damping_ratio())).unwrap()
}

/// Both sides of each edge with damping, next to it and anywhere; the differences are returned.
fn damped_edges_against_the_motion(points: usize, seed: u64) -> (u32, u32, Vec<String>) {
    let (mut random, mut compared, mut unsettled, mut wrong) = (Random(seed + 1), 0, 0, Vec::new());
    for (ratios, low, high) in damped_beside_poles(seed).take(points) {
        let border = Border::of(&ratios).min_force_ratio;
        assert!(low < high && high < border, "{ratios:?}: {low} {high} {border}");
        let within = [low * (1.0 + 1e-9), low * (high / low).powf(random.next()), high * (1.0 - 1e-9)];
        let gap = high + (border - high) * random.next();
        let below = 1.0 + (low - 1.0) * random.next();
        let beyond = [below, low * (1.0 - 1e-9), high * (1.0 + 1e-9), gap];
        let all = within.map(|alpha| (alpha, true)).into_iter().chain(beyond.map(|alpha| (alpha, false)));
        for (alpha, slides) in all {
            let at = damped_at(ratios, alpha);
            assert_eq!(regime_of(at) == Regime::NonSticking, slides, "{at:?}");
            match counts(at) {
                Some((0, 6)) if slides => compared += 1,
                Some((1.., _)) if !slides => compared += 1,
                // Beyond an edge close to a pole, the motion creeps from one stop to the next.
                None => unsettled += 1,
                // Close to a pole the rounding of the motion corresponds to another Ω, which moves an edge by
                // more.
                Some(other) => match counts(at_256_bits(at)) {
                    Some((0, 6)) if slides => compared += 1,
                    Some((1.., _)) if !slides => compared += 1,
                    wide => wrong.push(format!("{at:?} of {low} to {high}: {other:?} {wide:?}")),
                },
            }
        }
    }
    (compared, unsettled, wrong)
}

fn regime_of(ratios: Ratios<f64>) -> Regime {
    Response::new(ratios).regime
}

#[test]
fn with_a_damper_the_edges_are_where_stops_begin() {
    let (compared, unsettled, wrong) = damped_edges_against_the_motion(60, 71);
    println!("{compared} compared, {unsettled} unsettled");
    assert!(wrong.is_empty(), "{} of {compared}: {wrong:#?}", wrong.len());
    assert!(compared > 300, "{compared}");
}

#[test]
#[ignore = "minutes: the whole campaign"]
fn campaign_of_six_reversals_with_a_damper() {
    let count: usize = std::env::var("POINTS").map_or(1500, |n| n.parse().unwrap());
    let (compared, unsettled, wrong) = damped_edges_against_the_motion(count, 81);
    println!("{compared} compared, {unsettled} unsettled, {} wrong", wrong.len());
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Where there are no edges and therefore no cycle of six reversals with damping, the motion below the border
/// stops.
fn damped_elsewhere(points: usize, seed: u64) -> (u32, Vec<String>) {
    let (mut random, mut compared, mut wrong) = (Random(seed), 0, Vec::new());
    for _ in 0..points {
        let pole = 3.0 + 2.0 * random.between(0.0, 5.0).floor();
        let half_turns =
            if random.next() < 0.8 { pole + random.between(-0.05, 0.06) } else { random.between(2.0, 12.0) };
        let zeta = if random.next() < 0.5 { random.scale(1e-6, 2e-2) } else { random.scale(5e-4, 8e-3) };
        let ratios = Ratios::new(1.0 / half_turns, 2.0).unwrap().with_damping_ratio(zeta).unwrap();
        let border = Border::of(&ratios).min_force_ratio;
        let alpha = (border * random.scale(0.02, 1.0)).max(1.01);
        let at = damped_at(ratios, alpha);
        if alpha >= border {
            continue;
        }
        if let Some((stops, zeros)) = counts(at) {
            compared += 1;
            if (regime_of(at) == Regime::NonSticking) != (stops == 0) {
                wrong.push(format!("{at:?}: {stops} {zeros}, {border}"));
            }
        }
    }
    (compared, wrong)
}

#[test]
fn with_a_damper_there_is_no_other_motion_without_a_stop() {
    let (compared, wrong) = damped_elsewhere(1000, 91);
    println!("{compared} compared");
    assert!(wrong.is_empty(), "{} of {compared}: {wrong:#?}", wrong.len());
}

#[test]
#[ignore = "minutes: the whole campaign"]
fn campaign_of_stops_below_the_border_with_a_damper() {
    let count: usize = std::env::var("POINTS").map_or(20_000, |n| n.parse().unwrap());
    let (compared, wrong) = damped_elsewhere(count, 101);
    println!("{compared} compared, {} wrong", wrong.len());
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn with_a_damper_its_matching_problem_gives_the_exact_motion() {
    let mut random = Random(111);
    for (ratios, low, high) in damped_beside_poles(112).take(60) {
        let at = damped_at(ratios, low * (high / low).powf(random.between(0.001, 0.999)));
        matching_problem_gives_the_exact_motion(at);
    }
}

/// The edges at f64 are compared with those at 512 bits.
#[test]
fn with_a_damper_the_edges_are_known_to_rounding() {
    let mut worst = 0.0;
    for (ratios, low, high) in damped_beside_poles(121).take(60).filter(|(_, low, high)| high > &(low * 1.2))
    {
        let wide = without_stop(Mp::<8>::from(ratios.omega()), Mp::from(ratios.damping_ratio()));
        let (wide_low, wide_high) = wide.unwrap().six_reversals.unwrap();
        let error = ulps(low, wide_low).max(ulps(high, wide_high));
        assert!(error < 64.0, "{ratios:?}: {error}");
        worst = f64::max(worst, error);
    }
    println!("edges at f64: {worst} ulp");
}
