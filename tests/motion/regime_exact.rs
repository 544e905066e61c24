//! The regime near the border and the multipliers, compared with the exact motion where f64 does not suffice;
//! the stops per cycle. The whole plane at f64 is in `regime.rs`.

#![allow(clippy::print_stdout, reason = "the figures measured, shown with --nocapture")]

use crate::random::Random;
use stickslip::float::Mp;
use stickslip::internal::{Stops, stops_per_cycle};
use stickslip::motion::{LongRun, State};
use stickslip::{Border, Cycle, Error, Float, Ratios, Regime, Verdict};

/// The regime of the exact motion from rest; `None` where it is undecided.
fn exact_regime<F: Float>(ratios: Ratios<F>) -> Option<Regime> {
    match LongRun::from_start(ratios, State::default()).unwrap() {
        LongRun::Periodic(steady) | LongRun::Family(steady) => {
            let (sticks, zeros) = (steady.sticks_per_cycle, steady.velocity_zeros_per_cycle);
            assert!(zeros >= 2, "{ratios:?}");
            Some(if sticks > 0 { Regime::Sticking } else { Regime::NonSticking })
        }
        LongRun::Rest(_) => Some(Regime::Stuck),
        LongRun::Unbounded { .. } => Some(Regime::Unbounded),
        LongRun::Irregular(_) | LongRun::NotConverged { .. } => None,
    }
}

/// Counts the points at which both sides have an answer, and those at which one of them has none.
///
/// A body that nearly stops in the middle of a slide touches zero to within the rounding of its velocity.
/// There the exact motion at f64 cannot distinguish a stop from none, and 256 bits decide on both sides.
#[derive(Default)]
struct Count {
    agreed: u32,
    undecided: u32,
    unsettled: u32,
    wider: u32,
    /// The greatest distance from the border, |α/α_min − 1|, at which f64 could not decide.
    furthest: f64,
}

impl Count {
    fn print(&self, name: &str) {
        let Self { agreed, undecided, unsettled, wider, furthest } = self;
        println!(
            "{name}: {agreed} agree, {undecided} undecided, {unsettled} unsettled, {wider} at 256 bits up \
             to {furthest:e}"
        );
    }

    fn compare(&mut self, omega: f64, alpha: f64) {
        let ratios = Ratios::new(omega, alpha).unwrap();
        match (Verdict::new(ratios).regime(), exact_regime(ratios)) {
            (None, _) => self.undecided += 1,
            (Some(_), None) => self.unsettled += 1,
            (Some(here), Some(exact)) if here == exact => self.agreed += 1,
            (Some(here), Some(exact)) => {
                let wide = Ratios::new(Mp::<4>::from(omega), Mp::from(alpha)).unwrap();
                let margin = wide.alpha() / Border::of(&wide).min_force_ratio;
                let off = (margin.to_f64() - 1.0).abs();
                assert_eq!(Verdict::new(wide).regime(), Some(here), "({omega:?}, {alpha:?})");
                assert_eq!(
                    exact_regime(wide),
                    Some(here),
                    "({omega:?}, {alpha:?}) {exact:?} at f64, {off:e} off"
                );
                self.wider += 1;
                self.furthest = self.furthest.max(off);
            }
        }
    }
}

#[test]
fn within_1e_9_of_the_border_more_bits_decide() {
    let mut random = Random(52);
    let mut count = Count::default();
    for i in 0..20_000 {
        let omega = random.scale(0.05, 20.0);
        let border = Border::new(omega).unwrap().min_force_ratio;
        let off = random.scale(1e-12, 1e-9);
        count.compare(omega, border * (1.0 + if i % 2 == 0 { off } else { -off }));
    }
    count.print("border");
    assert!(count.agreed > 15_000);
}

#[test]
fn stops_per_cycle_and_what_has_none() {
    let stops = |omega, alpha| stops_per_cycle(Ratios::new(omega, alpha).unwrap());
    let of = |sticks, velocity_zeros| Ok(Some(Stops { sticks, velocity_zeros }));
    for (omega, alpha, expected) in [
        (0.4, 6.0, of(2, 4)),
        (0.1, 3.0, of(4, 4)),
        (0.5, 2.0, of(2, 2)),
        (0.7, 1.2, of(2, 2)),
        (0.8, 1.1, of(2, 2)),
        (0.4, 7.0, of(0, 2)),
        (0.7, 2.0, of(0, 2)),
        (0.25, 40.0, of(0, 2)),
        (0.7, 0.9, Ok(None)),
        (1.0, 1.3, Ok(None)),
    ] {
        let expected: Result<_, Error> = expected;
        assert_eq!(stops(omega, alpha), expected, "({omega}, {alpha})");
        let verdict = Verdict::new(Ratios::new(omega, alpha).unwrap());
        let sticks = stops(omega, alpha).unwrap().is_some_and(|s| s.sticks > 0);
        assert_eq!(sticks, verdict == Verdict::Sticking, "({omega}, {alpha})");
    }
    assert!(stops(1e-9, 2.0).is_err());
    // A fifth below the border, near the pole 1/15, the body reverses without a stop.
    let below = Ratios::new(0.066_658_079_476_532_49, 42_358.137_294_718_49).unwrap();
    let wide = Ratios::new(Mp::<4>::from(below.omega()), Mp::from(below.alpha())).unwrap();
    assert!(below.alpha() < 0.8 * Border::of(&below).min_force_ratio);
    for found in [stops_per_cycle(below), stops_per_cycle(wide)] {
        assert!(matches!(found, Ok(Some(Stops { sticks: 0, velocity_zeros: 4.. }))), "{found:?}");
    }
}

/// The difference between the multipliers of a cycle in closed form and those of the exact motion.
fn multipliers_apart<F: Float>(omega: F, alpha: F) -> F {
    let cycle = Cycle::new(Ratios::new(omega, alpha).unwrap()).unwrap();
    let LongRun::Periodic(steady) = LongRun::try_from(&cycle).unwrap() else { panic!("({omega}, {alpha})") };
    let (closed, monodromy) = (cycle.multipliers().cycle, steady.multipliers);
    let apart = |(a, b): (F, F), (c, d): (F, F)| (a - c).hypot(b - d);
    let both = |i: usize| apart(closed[0], monodromy[i]).or_larger(apart(closed[1], monodromy[1 - i]));
    let (straight, crossed) = (both(0), both(1));
    let squared = |(a, b): (F, F)| a.hypot(b);
    let modulus = squared(closed[0]).or_larger(squared(closed[1]));
    assert!((modulus - cycle.contraction().square()).abs() < F::epsilon() * F::int(64));
    if straight < crossed { straight } else { crossed }
}

/// The discriminant of the multipliers, which behave like its square root.
fn discriminant(omega: f64, alpha: f64) -> f64 {
    let delta = Cycle::new(Ratios::new(omega, alpha).unwrap()).unwrap().max_displacement;
    (omega * omega * delta * (std::f64::consts::PI / omega).sin()).abs() - 1.0
}

/// Ω and α of cycles: away from the double multiplier, Ω from 0.05 to 20.
fn cycles(count: usize) -> impl Iterator<Item = (f64, f64)> {
    let mut random = Random(53);
    let points = std::iter::from_fn(move || {
        let omega = random.scale(0.05, 20.0);
        Some((omega, Border::new(omega).unwrap().min_force_ratio * random.scale(1.0001, 30.0)))
    });
    points.filter(|&(omega, alpha)| discriminant(omega, alpha).abs() > 1e-3).take(count)
}

#[test]
fn multipliers_in_closed_form_are_those_of_the_monodromy_at_256_bits() {
    let mut worst = 0.0;
    for (omega, alpha) in cycles(60) {
        let apart = multipliers_apart::<Mp<4>>(omega.into(), alpha.into()).to_f64();
        worst = f64::max(worst, apart);
        assert!(apart < 1e-68, "({omega:?}, {alpha:?}): {apart:e}");
    }
    println!("multipliers at 256 bits: {worst:e}");
}
