//! Inverse problems beside dense samples: the motion of each answer, and of others.

use crate::compared::Origin::DenseSamples;
use crate::compared::{agreed, compared, near};
use crate::machines::Driven;
use crate::random::Random;
use crate::sampled::{Cycle, Limit, Load, Machine, Of, positions, record};
use std::f64::consts::TAU;
use stickslip::design::{
    Aim, BandFrictionKind, Holding, Identified, Measurement, OptimumKind, Reading, TurningPoints, bands,
    bands_without_stop, best_friction_over_band, force_for_displacement, force_for_velocity,
    force_ratio_for_displacement, force_ratio_for_velocity, forces_without_stop, frequency_bands,
    frequency_bands_without_stop, holding_frequency, identify, identify_decay, identify_motion,
    identify_turning_points, max_friction, min_amplitude, most_dissipating_force_ratio,
    most_dissipating_force_ratio_of_all, most_dissipating_frequency_ratio, most_dissipating_friction,
    most_dissipating_friction_of_all, most_dissipating_stiffness,
};
use stickslip::motion::record::Record;
use stickslip::{Drive, Error, Excitation, Oscillator};

/// The cycle of the samples from rest; `None` where it rests or has not settled.
fn cycle(driven: &Driven, turns: u32) -> Option<Cycle> {
    let harmonic = driven.harmonic();
    match harmonic.limit([harmonic.mean(), 0.0], 0.0, turns) {
        Limit::Periodic(cycle) => Some(*cycle),
        Limit::Rest(_) | Limit::Unsettled => None,
    }
}

/// Whether the cycle has two reversals and no stop.
fn is_free(driven: &Driven) -> bool {
    cycle(driven, 4000).is_some_and(|cycle| cycle.found.rests == 0 && cycle.found.ends == 2)
}

fn plain(mass: f64, stiffness: f64, damping: f64, friction: f64, force: f64, frequency: f64) -> Driven {
    Driven {
        mass,
        stiffness,
        damping,
        friction,
        offset: 0.0,
        eta: 1.0,
        mean: 0.0,
        excitation: Excitation::Force,
        amplitude: force,
        frequency,
    }
}

/// The work of friction in a cycle of the samples.
fn friction_work(driven: &Driven) -> f64 {
    let cycle = cycle(driven, 3000);
    cycle.map_or(0.0, |cycle| driven.friction * (cycle.found.path[0] + cycle.found.path[1]))
}

/// The least amplitude of every drive, and the greatest friction: the motion of the samples stops on one side only.
#[test]
fn the_least_force_and_the_greatest_friction_divide_the_samples() {
    let mut random = Random(41);
    for excitation in Excitation::ALL {
        for _ in 0..4 {
            let at = [random.scale(0.2, 2.5), 3.0, random.scale(0.01, 0.6), 1.0];
            let driven = Driven::at(&mut random, at, excitation);
            let least = min_amplitude(&driven.oscillator(), excitation, driven.frequency).unwrap();
            let with = |amplitude: f64| is_free(&Driven { amplitude, ..driven });
            let name = match excitation {
                Excitation::Force => "force",
                Excitation::Unbalance => "unbalance",
                Excitation::FootMotion => "foot_displacement",
                Excitation::SurfaceMotion => "base_displacement",
                Excitation::SurfaceAcceleration => "base_acceleration",
                _ => "",
            };
            let found = [with(least * (1.0 - 1e-4)), with(least * (1.0 + 1e-4))];
            if name.is_empty() {
                assert_eq!(found, [false, true], "{driven:?}");
            } else {
                let output = format!("design force {name} by design::min_amplitude");
                agreed(&output, found, [false, true], DenseSamples);
            }
            let greatest = max_friction(&driven.oscillator(), &driven.drive()).unwrap();
            let with = |friction: f64| {
                let offset = driven.offset / driven.friction * friction;
                is_free(&Driven { friction, offset, ..driven })
            };
            let found = [with(greatest * (1.0 - 1e-4)), with(greatest * (1.0 + 1e-4))];
            agreed("design friction friction by design::max_friction", found, [true, false], DenseSamples);
        }
    }
}

/// Friction holds a body at rest, at the mean displacement, up to a frequency: the samples move beyond it, and not below.
#[test]
fn friction_holds_the_samples_up_to_a_frequency() {
    let mut random = Random(47);
    let mut counts = [0; 3];
    for n in 0..140 {
        let excitation = Excitation::ALL[n % 7];
        let at = [
            random.scale(0.2, 2.5),
            random.scale(0.3, 3.0),
            random.scale(0.01, 0.6),
            random.between(1.0, 1.6),
        ];
        let driven = Driven { offset: 0.0, ..Driven::at(&mut random, at, excitation) };
        let found = holding_frequency(&driven.oscillator(), &driven.drive()).unwrap();
        // From rest over two cycles.
        let is_held = |frequency: f64| {
            let driven = Driven { frequency, ..driven };
            let harmonic = driven.harmonic();
            let start = [harmonic.mean(), 0.0];
            harmonic.after(start, 0.0, 2) == start
        };
        match found {
            Holding::UpTo(frequency) => {
                let found = [is_held(frequency * (1.0 - 1e-6)), is_held(frequency * (1.0 + 1e-3))];
                agreed(
                    "design hold holding_frequency by design::holding_frequency",
                    found,
                    [true, false],
                    DenseSamples,
                );
                agreed("design hold holds", found, [true, false], DenseSamples);
                counts[0] += 1;
            }
            Holding::Always => {
                let found = [0.1, 1.0, 10.0].map(|share| is_held(driven.frequency * share));
                agreed("design hold holds", found, [true; 3], DenseSamples);
                counts[1] += 1;
            }
            _ => {
                let found = [0.1, 1.0, 10.0].map(|share| is_held(driven.frequency * share));
                agreed("design hold holds", found, [false; 3], DenseSamples);
                counts[2] += 1;
            }
        }
    }
    assert!(counts.iter().all(|count| *count > 8), "{counts:?}");
}

/// Bands of frequencies: without stops inside their ends, and not outside; in ratios and in units.
#[test]
fn bands_end_where_the_samples_begin_to_stop() {
    let of = |omega: f64, zeta: f64, alpha: f64| plain(1.0, 1.0, 2.0 * zeta, 1.0, alpha, omega);
    let counts =
        |driven: &Driven| cycle(driven, 4000).map_or((1, 0), |cycle| (cycle.found.rests, cycle.found.ends));
    let mut edges = 0;
    for (alpha, zeta) in [(12.0_f64, 0.0_f64), (5.0, 0.03)] {
        let all: Vec<_> = bands(alpha, zeta, 0.22..=2.0).unwrap().map(Result::unwrap).collect();
        let physical = frequency_bands(
            &Oscillator::new(4.0, 100.0, 3.0).unwrap().with_damping_ratio(zeta).unwrap(),
            &Drive::force(3.0 * alpha, 1.0).unwrap(),
            1.1..=10.0,
        );
        let physical: Vec<_> = physical.unwrap().map(Result::unwrap).collect();
        assert_eq!(all.len(), physical.len());
        for (band, same) in all.iter().zip(&physical) {
            // ω_n = 5.
            assert!((band.low * 5.0 - same.low).abs() < 1e-9 && (band.high * 5.0 - same.high).abs() < 1e-9);
            for (end, out, which) in
                [(band.low, -1.0, ["from", "low_edge"]), (band.high, 1.0, ["to", "high_edge"])]
            {
                if end == 0.22 || end == 2.0 {
                    continue;
                }
                edges += 1;
                let [inside, outside] =
                    [-1e-4, 1e-4].map(|by| counts(&of(end * (1.0 + out * by), zeta, alpha)));
                let divides = (inside, outside == (0, 2));
                for name in
                    [format!("omega_{}", which[0]), format!("frequency_{}", which[0]), which[1].to_owned()]
                {
                    let output = format!("design bands {name} by design::frequency_bands");
                    agreed(&output, divides, ((0, 2), false), DenseSamples);
                }
            }
        }
        // Between the bands a few frequencies stop.
        for pair in all.windows(2) {
            let middle = (pair[0].high + pair[1].low) / 2.0;
            assert_ne!(counts(&of(middle, zeta, alpha)), (0, 2), "{middle} {alpha} {zeta}");
        }
    }
    assert!(edges >= 3, "{edges}");
    // Near a third of resonance six reversals, too.
    let all = bands_without_stop(80.0_f64, 0.0, 0.3..=0.4).unwrap();
    let body = Oscillator::new(4.0, 100.0, 3.0).unwrap();
    let physical =
        frequency_bands_without_stop(&body, &Drive::force(240.0, 1.0).unwrap(), 1.5..=2.0).unwrap();
    assert_eq!(all.len(), physical.len());
    assert!(all.iter().any(|band| band.reversals_per_cycle == 6));
    for (band, same) in all.iter().zip(&physical) {
        assert!((band.low * 5.0 - same.low).abs() < 1e-8 && (band.high * 5.0 - same.high).abs() < 1e-8);
        let middle = counts(&of((band.low * band.high).sqrt(), 0.0, 80.0));
        let reversals = band.reversals_per_cycle;
        let output = "design bands reversals_per_cycle by design::frequency_bands_without_stop";
        agreed(output, (0, reversals.into()), middle, DenseSamples);
    }
    let forces = forces_without_stop(&body, 5.0 * 0.331).unwrap();
    for (low, high) in forces.intervals() {
        let with = |force: f64| counts(&plain(4.0, 100.0, 0.0, 3.0, force, 5.0 * 0.331)).0;
        let inside = with(high.map_or(1.1 * low, |high| (low * high).sqrt()));
        let stops = [with(low * (1.0 - 1e-3)) == 0, inside == 0];
        for name in ["no_stop_forces", "no_stop_force_ratios"] {
            let output = format!("design force --no-stop {name} by design::forces_without_stop");
            agreed(&output, stops, [false, true], DenseSamples);
        }
    }
}

/// The force for a displacement or a velocity: the samples reach it.
#[test]
fn the_force_for_a_target_reaches_it() {
    let mut random = Random(43);
    let mut found = 0;
    for i in 0..30 {
        let zeta = if i % 2 == 0 { 0.0 } else { random.scale(0.01, 0.6) };
        let at = [random.scale(0.4, 2.5), 3.0, zeta, 1.0];
        let driven = Driven::at(&mut random, at, Excitation::Force);
        let body = driven.oscillator();
        let border = min_amplitude(&body, Excitation::Force, driven.frequency).unwrap();
        let Some(of_border) = cycle(&Driven { amplitude: border * 1.001, ..driven }, 3000) else { continue };
        let mean = driven.harmonic().mean();
        let by = random.between(1.1, 6.0);
        let length = by * (of_border.found.most(Of::Displacement).value - mean);
        let speed = by * of_border.found.most(Of::Velocity).value;
        let (b, w) = (driven.friction / driven.stiffness, driven.frequency);
        for (target, force, ratio, of) in [
            (
                length,
                force_for_displacement(&body, w, length),
                force_ratio_for_displacement(at[0], zeta, length / b),
                Of::Displacement,
            ),
            (
                speed,
                force_for_velocity(&body, w, speed),
                force_ratio_for_velocity(at[0], zeta, speed / (b * w)),
                Of::Velocity,
            ),
        ] {
            let (force, ratio) = (force.unwrap(), ratio.unwrap());
            let Some(cycle) = cycle(&Driven { amplitude: force, ..driven }, 3000) else { continue };
            found += 1;
            let reached = cycle.found.most(of).value - if of == Of::Displacement { mean } else { 0.0 };
            let function = if of == Of::Displacement { "displacement" } else { "velocity" };
            let output = format!("design displacement, velocity force by design::force_for_{function}");
            near(&output, target, reached, DenseSamples, 1e-8);
            assert!((force / driven.friction / ratio - 1.0).abs() < 1e-9, "{driven:?}: {force} {ratio}");
            near("design displacement, velocity force_ratio", target, reached, DenseSamples, 1e-8);
        }
    }
    assert!(found > 40, "{found}");
}

/// The best force, friction, frequency and stiffness for dissipation: the energy is that of the samples, and no
/// neighbour that does not stick has more.
#[test]
fn no_other_machine_dissipates_more() {
    let mut random = Random(44);
    for i in 0..8 {
        let zeta = if i % 2 == 0 { 0.0 } else { random.scale(0.01, 0.2) };
        let at = [random.scale(0.55, 2.2), 4.0, zeta, 1.0];
        let mut driven = Driven::at(&mut random, at, Excitation::Force);
        (driven.offset, driven.mean) = (0.0, 0.0);
        let body = driven.oscillator();
        // Friction.
        let best = most_dissipating_friction(&body, &driven.drive()).unwrap();
        let with = |friction: f64| Driven { friction, ..driven };
        let value = friction_work(&with(best.at * (1.0 - 1e-9)));
        let of = |name: &str| format!("design dissipation {name}");
        near(&of("energy by design::most_dissipating_friction"), best.value, value, DenseSamples, 1e-6);
        let is_less = [0.5, 0.8, 0.95, 1.05, 1.3].map(|by| {
            let other = with(best.at * by);
            !is_free(&other) || friction_work(&other) < best.value
        });
        for name in ["friction", "force_ratio"] {
            agreed(&of(name), is_less, [true; 5], DenseSamples);
        }
        // On the border the samples begin to stop, and at an optimum between they do not.
        let is_border = best.kind == OptimumKind::Border;
        agreed(&of("optimum"), is_border, !is_free(&with(best.at * (1.0 + 1e-4))), DenseSamples);
        // The same as a force ratio: A₁ in p₀²/(2k).
        let ratio = most_dissipating_force_ratio(at[0], zeta).unwrap();
        assert!((driven.amplitude / best.at / ratio.at - 1.0).abs() < 1e-9, "{best:?} {ratio:?}");
        let unit = driven.amplitude * driven.amplitude / 2.0 / driven.stiffness;
        assert!((best.value / unit / ratio.value - 1.0).abs() < 1e-9, "{best:?} {ratio:?}");
        near(&of("loop_size_stiffness"), ratio.value, value / unit, DenseSamples, 2e-6);
        // Stiffness.
        let (soft, hard) = (0.6 * driven.stiffness, 1.7 * driven.stiffness);
        if let Ok(best) = most_dissipating_stiffness(&body, &driven.drive(), soft..=hard) {
            let with = |stiffness: f64| Driven { stiffness, ..driven };
            let inside = if best.kind == OptimumKind::Border { 1e-7 } else { 0.0 };
            let value = [1.0 - inside, 1.0 + inside].map(|by| friction_work(&with(best.at * by))).into_iter();
            let value = value.fold(0.0, f64::max);
            let output = "design stiffness energy by design::most_dissipating_stiffness";
            near(output, best.value, value, DenseSamples, 1e-4);
            let is_less: [bool; 12] = std::array::from_fn(|by| {
                let other = with(soft * (hard / soft).powf(by as f64 / 11.0));
                !is_free(&other) || friction_work(&other) < best.value * (1.0 + 1e-7)
            });
            agreed("design stiffness stiffness", is_less, [true; 12], DenseSamples);
            // At the border one of two neighbours stops.
            let both = [1.0 - 1e-4, 1.0 + 1e-4].map(|by| is_free(&with(best.at * by)));
            let is_border = best.kind == OptimumKind::Border;
            agreed("design stiffness optimum", is_border, both != [true, true], DenseSamples);
        }
    }
    // Frequency: A₂ in p₀²/(2 m ω_d²).
    let size = |omega: f64, alpha: f64| {
        let driven = plain(1.0, 1.0, 0.0, 1.0, alpha, omega);
        if is_free(&driven) { friction_work(&driven) / (alpha * alpha / 2.0 / (omega * omega)) } else { 0.0 }
    };
    for (alpha, low, high) in [(3.0, 0.7, 0.95), (6.0, 1.05, 2.0), (2.0, 1.1, 1.6)] {
        let best = most_dissipating_frequency_ratio(alpha, low..=high).unwrap();
        let value = size(best.at * if best.at > 1.0 { 1.0 + 1e-9 } else { 1.0 }, alpha);
        let of_stiffness = size(best.at, alpha) / best.at.powi(2);
        let is_one = [value, of_stiffness].iter().any(|value| (value / best.value - 1.0).abs() < 1e-4);
        assert!(is_one, "{value} {of_stiffness} {best:?}");
        let is_of_inertia = (value / best.value - 1.0).abs() < 1e-4;
        for i in 0..12 {
            let omega = low + (high - low) * f64::from(i) / 11.0;
            let other = size(omega, alpha) / if is_of_inertia { 1.0 } else { omega * omega };
            assert!(other <= best.value * (1.0 + 1e-6), "{omega} {other} {best:?}");
        }
    }
}

/// The best friction among all motions, stops included: no friction of a grid has more, and none is above the bound.
#[test]
fn no_other_friction_dissipates_more_with_stops() {
    let driven = plain(2.0, 50.0, 0.4, 1.0, 30.0, 1.7);
    let best = most_dissipating_friction_of_all(&driven.oscillator(), &driven.drive(), 1e-4).unwrap();
    let value = friction_work(&Driven { friction: best.at, ..driven });
    let of = |name: &str| format!("design dissipation --sticking {name}");
    let output = of("energy by design::most_dissipating_friction_of_all");
    near(&output, best.value, value, DenseSamples, 1e-7);
    let omega = 1.7 / 5.0;
    let ratio = most_dissipating_force_ratio_of_all(omega, 0.4 / 20.0, 1e-4).unwrap();
    assert!((30.0 / ratio.at / best.at - 1.0).abs() < 1e-6, "{ratio:?} {best:?}");
    assert!((ratio.value * 30.0 * 30.0 / 100.0 / best.value - 1.0).abs() < 1e-9, "{ratio:?} {best:?}");
    near(&of("loop_size_stiffness"), ratio.value, value * 100.0 / 900.0, DenseSamples, 1e-7);
    let others = (1..40).map(|i| friction_work(&Driven { friction: 30.0 * f64::from(i) / 40.0, ..driven }));
    let most = others.fold(0.0, f64::max);
    for name in ["friction", "force_ratio"] {
        agreed(&of(name), most <= best.value * (1.0 + 1e-4), true, DenseSamples);
    }
    agreed(&of("bound"), most <= best.bound, true, DenseSamples);
    let is_stopping = !is_free(&Driven { friction: best.at, ..driven });
    agreed(&of("optimum"), best.kind == OptimumKind::Sticking, is_stopping, DenseSamples);
}

/// The friction whose greatest amplitude over a band is least, beside amplitudes of the samples on a grid of frequencies
/// and frictions.
#[test]
fn no_other_friction_has_a_lower_crest() {
    for (excitation, aim, of, u0) in [
        (Excitation::SurfaceMotion, Aim::AbsoluteDisplacement, Of::AbsoluteDisplacement, 0.05),
        (Excitation::SurfaceAcceleration, Aim::TransmittedForce, Of::Transmitted, 2.0),
        (Excitation::SurfaceAcceleration, Aim::Acceleration, Of::AbsoluteAcceleration, 2.0),
    ] {
        let mut driven = plain(2.0, 50.0, 1.0, 1.0, u0, 1.0);
        driven.excitation = excitation;
        let (low, high) = (2.5, 15.0);
        let best = best_friction_over_band(&driven.oscillator(), &driven.drive(), low..=high, aim).unwrap();
        let amplitude = |friction: f64, frequency: f64| {
            let driven = Driven { friction, frequency, ..driven };
            match driven.harmonic().limit([0.0, 0.0], 0.0, 1500) {
                Limit::Periodic(cycle) => Some(cycle.found.greatest(of).value),
                // A body at rest moves with its base.
                Limit::Rest(_) => Some(match of {
                    Of::AbsoluteDisplacement => u0,
                    Of::Transmitted => driven.mass * u0,
                    _ => u0,
                }),
                Limit::Unsettled => None,
            }
        };
        let crest = |friction: f64| {
            let grid = (0..60).map(|i| low * (high / low).powf(f64::from(i) / 59.0));
            grid.filter_map(|frequency| amplitude(friction, frequency)).fold(0.0, f64::max)
        };
        let of_band = |name: &str| format!("design friction --over {name}");
        let highest = crest(best.friction);
        assert!(highest <= best.greatest * (1.0 + 1e-6), "{aim:?} {best:?}");
        if let Some(end) = best.up_to {
            assert!(crest((best.friction * end).sqrt()) <= best.greatest * (1.0 + 1e-6), "{aim:?} {best:?}");
            assert!(end < best.rest || crest(2.0 * end) <= best.greatest * (1.0 + 1e-6), "{aim:?} {best:?}");
        }
        // Of the frictions with this crest the greatest one: one between has it, too, and twice as much has a higher one or rest.
        let end = best.up_to.unwrap_or(best.friction);
        let as_low = [(best.friction * end).sqrt(), end]
            .map(|friction| crest(friction) <= best.greatest * (1.0 + 1e-6));
        let is_all = end >= best.rest * (1.0 - 1e-9) || crest(2.0 * end) > best.greatest * (1.0 + 1e-6);
        agreed(&of_band("greatest_friction"), (as_low, is_all), ([true; 2], true), DenseSamples);
        // Inside: the body slides somewhere over the band, and with hardly any friction the crest is higher.
        let slides = (0..60).any(|i| {
            let driven = Driven {
                friction: best.friction,
                frequency: low * (high / low).powf(f64::from(i) / 59.0),
                ..driven
            };
            matches!(driven.harmonic().limit([0.0, 0.0], 0.0, 1500), Limit::Periodic(_))
        });
        let is_interior = best.kind == BandFrictionKind::Interior;
        let of_samples = slides && crest(1e-3 * best.friction) > best.greatest;
        agreed(&of_band("optimum"), is_interior, of_samples, DenseSamples);
        let at = best.at.iter().filter_map(|(from, to)| amplitude(best.friction, (from * to).sqrt()));
        let at: Vec<f64> = at.collect();
        assert!(!at.is_empty(), "{aim:?} {best:?}");
        for at in at {
            near(
                &of_band("greatest by design::best_friction_over_band"),
                best.greatest,
                at,
                DenseSamples,
                1e-5,
            );
            near(&of_band("at_frequencies"), best.greatest, at, DenseSamples, 1e-5);
        }
        let is_more =
            [0.4, 0.8, 1.2, 2.0].map(|by| crest(best.friction * by) >= best.greatest * (1.0 - 2e-3));
        agreed(&of_band("friction"), is_more, [true; 4], DenseSamples);
        // Beyond the friction of rest nothing moves.
        let rest = [2.6, 6.0, 14.9].map(|w| {
            let driven = Driven { friction: best.rest * 1.001, frequency: w, ..driven };
            matches!(driven.harmonic().limit([0.0, 0.0], 0.0, 100), Limit::Rest(_))
        });
        assert_eq!(rest, [true; 3], "{aim:?} {best:?}");
    }
}

/// A normal number.
fn normal(random: &mut Random) -> f64 {
    (0..12).map(|_| random.next()).sum::<f64>() - 6.0
}

/// Friction and damping from response curves of the samples: exactly without noise, and within twice the interval of
/// nineteen in twenty with it.
#[test]
fn friction_and_damping_of_the_samples_are_identified() {
    let mut random = Random(45);
    let (mut covered, mut all) = (0, 0);
    for _ in 0..12 {
        let (mass, stiffness, force) = (5.0, 2000.0, 100.0);
        let (friction, zeta) = (random.between(15.0, 55.0), random.between(0.01, 0.08));
        let damping = 2.0 * zeta * f64::sqrt(mass * stiffness);
        let curve: Vec<Measurement> = (0..16)
            .filter_map(|i| {
                let frequency = 20.0 * (0.5 + f64::from(i) * 0.09);
                let cycle = cycle(&plain(mass, stiffness, damping, friction, force, frequency), 3000)?;
                let amplitude = cycle.found.most(Of::Displacement).value;
                Some(Measurement { angular_frequency: frequency, amplitude, phase: None })
            })
            .collect();
        let exact = identify(mass, Some(stiffness), Some(force), &curve, Reading::default()).unwrap();
        let output = "identify friction by design::identify";
        near(output, exact.friction_bound.value, friction, DenseSamples, 1e-4);
        near("identify damping_ratio", exact.damping_ratio.value, zeta, DenseSamples, 1e-3);
        let noisy: Vec<_> = curve
            .iter()
            .map(|m| Measurement { amplitude: m.amplitude * (1.0 + 0.01 * normal(&mut random)), ..*m })
            .collect();
        let found = identify(mass, Some(stiffness), Some(force), &noisy, Reading::default()).unwrap();
        for (estimate, truth) in [(found.friction_bound, friction), (found.damping_ratio, zeta)] {
            let (low, high) = estimate.interval();
            all += 1;
            covered += u32::from((low..=high).contains(&truth));
            let room = 4.0 * estimate.standard_error;
            assert!((estimate.value - truth).abs() < room, "{truth} {estimate:?} {found:?}");
        }
        // The standard error of a standard deviation from 14 degrees of freedom is a fifth, and the noise is a sum of twelve.
        compared("identify noise", found.noise, 0.01, DenseSamples, 0.008);
    }
    // Of intervals of 95 %, fewer than 18 of 24 have a probability below 1e-3.
    assert!(covered >= 18, "{covered} of {all}");
}

/// The natural frequency, or the force, with friction and damping from curves of the samples: the truth without noise, and
/// within the interval nineteen times in twenty with it.
#[test]
fn the_natural_frequency_and_the_force_of_the_samples_are_identified() {
    let mut random = Random(48);
    let (mut covered, mut all) = (0, 0);
    for n in 0..10 {
        let (mass, force) = (random.scale(0.5, 50.0), random.scale(10.0, 500.0));
        let natural = random.scale(5.0, 60.0);
        let stiffness = mass * natural * natural;
        let (friction, zeta) = (force * random.between(0.1, 0.5), random.between(0.01, 0.08));
        let damping = 2.0 * zeta * mass * natural;
        let curve: Vec<Measurement> = (0..20)
            .filter_map(|i| {
                let frequency = natural * (0.55 + f64::from(i) * 0.06);
                let cycle = cycle(&plain(mass, stiffness, damping, friction, force, frequency), 3000)?;
                let amplitude = cycle.found.most(Of::Displacement).value;
                Some(Measurement { angular_frequency: frequency, amplitude, phase: None })
            })
            .collect();
        let fit = |curve: &[Measurement]| {
            if n % 2 == 0 {
                identify(mass, None, Some(force), curve, Reading::default()).unwrap()
            } else {
                identify(mass, Some(stiffness), None, curve, Reading::default()).unwrap()
            }
        };
        let truth = if n % 2 == 0 { natural } else { force };
        let scale = |found: &Identified| found.natural_frequency.or(found.force).unwrap();
        let exact = fit(&curve);
        let value = scale(&exact);
        let output = if n % 2 == 0 { "identify natural_frequency" } else { "identify force" };
        near(output, value.value, truth, DenseSamples, 1e-5);
        near("identify friction", exact.friction_bound.value, friction, DenseSamples, 1e-3);
        near("identify damping_ratio", exact.damping_ratio.value, zeta, DenseSamples, 3e-3);
        let noisy: Vec<_> = curve
            .iter()
            .map(|m| Measurement { amplitude: m.amplitude * (1.0 + 0.01 * normal(&mut random)), ..*m })
            .collect();
        let found = fit(&noisy);
        let value = scale(&found);
        for (estimate, truth) in
            [(found.friction_bound, friction), (found.damping_ratio, zeta), (value, truth)]
        {
            let (low, high) = estimate.interval();
            all += 1;
            covered += u32::from((low..=high).contains(&truth));
            let room = 4.5 * estimate.standard_error;
            assert!((estimate.value - truth).abs() < room, "{n}: {truth} {estimate:?} {found:?}");
        }
    }
    // Of intervals of 95 %, fewer than 24 of 30 have a probability below 1e-3.
    assert!(covered >= 24, "{covered} of {all}");
}

/// Friction and damping from decays of the samples, by their turning points and by their samples.
#[test]
fn friction_and_damping_of_a_decay_are_identified() {
    let mut random = Random(46);
    let (mut covered, mut all) = (0, 0);
    for _ in 0..15 {
        // B = 1, ω_n = 1.
        let zeta = random.between(0.005, 0.06);
        let start = [random.between(14.0, 30.0), 0.0];
        let machine = Machine::new([1.0, 1.0, 2.0 * zeta], [1.0, 0.0, 1.0], 0.0);
        let found = record(machine, Load::Force, &[0.0, 0.1], &[0.0, 0.0], start, 64.0);
        let mut turns = vec![[0.0, start[0]]];
        turns.extend(&found.found.stops);
        // A last half cycle too short to pass zero ends on the side on which it began; turning points of both sides are
        // taken by their magnitudes.
        while turns.len() > 1 && turns[turns.len() - 1][1] * turns[turns.len() - 2][1] > 0.0 {
            turns.pop();
        }
        let (times, places): (Vec<f64>, Vec<f64>) = turns.iter().map(|[t, x]| (*t, *x)).unzip();
        let exact = identify_turning_points(&places, Some(&times), TurningPoints::EveryHalfCycle).unwrap();
        let of = |name: &str| format!("identify --decay {name}");
        let output = of("friction_displacement by design::identify_turning_points");
        near(&output, exact.friction_displacement.value, 1.0, DenseSamples, 1e-6);
        compared(&of("damping_ratio"), exact.damping_ratio.value, zeta, DenseSamples, 1e-7);
        near(&of("amplitude"), exact.amplitude.value, start[0], DenseSamples, 1e-7);
        near(&of("natural_frequency"), exact.natural_frequency.unwrap().value, 1.0, DenseSamples, 1e-6);
        let one: Vec<f64> = places.iter().step_by(2).copied().collect();
        if one.len() >= 4 {
            let exact = identify_turning_points(&one, None, TurningPoints::EveryCycle).unwrap();
            assert!((exact.friction_displacement.value - 1.0).abs() < 1e-5, "{zeta} {exact:?}");
        }
        let noisy: Vec<f64> = places.iter().map(|x| x + 0.05 * normal(&mut random)).collect();
        let found = identify_turning_points(&noisy, None, TurningPoints::EveryHalfCycle).unwrap();
        for (estimate, truth) in [(found.friction_displacement, 1.0), (found.damping_ratio, zeta)] {
            let (low, high) = estimate.interval();
            all += 1;
            covered += u32::from((low..=high).contains(&truth));
        }
        // The samples of the motion from the start to its last turning point.
        let last = times[times.len() - 1];
        let mut follower =
            crate::sampled::Harmonic { machine, load: Load::Force, amplitude: 0.0, frequency: TAU / last }
                .follower(start, 0.0);
        follower.set_step(last / 600.0);
        let (mut at, mut x) = (Vec::new(), Vec::new());
        for _ in 0..600 {
            at.push(follower.time);
            x.push(follower.state[0]);
            follower.advance(&mut None);
        }
        let exact = identify_decay(&at, &x).unwrap();
        let output = "fn design::identify_decay";
        compared(output, exact.friction_displacement.value, 1.0, DenseSamples, 0.02);
        compared(output, exact.damping_ratio.value, zeta, DenseSamples, 0.002);
    }
    assert!(covered * 10 >= all * 8, "{covered} of {all}");
}

/// Friction, damping and the offset from a load and the motion of the samples under it, with the stiffness known or not: the
/// truth without noise, and within the interval nineteen times in twenty with it. The body begins at rest or with a velocity.
#[test]
fn friction_and_damping_of_a_motion_of_the_samples_are_identified() {
    let mut random = Random(51);
    let (mut covered, mut all) = ([0, 0], [0, 0]);
    for n in 0..12 {
        let (mass, natural) = (random.scale(0.5, 50.0), random.scale(3.0, 30.0));
        let stiffness = mass * natural * natural;
        let zeta = random.between(0.005, 0.08);
        let friction = random.scale(1.0, 40.0);
        let (load, excitation, unit) = match n % 3 {
            0 => (Load::Force, Excitation::Force, 1.0),
            1 => (Load::Surface, Excitation::SurfaceAcceleration, mass),
            _ => (Load::Foot, Excitation::FootMotion, stiffness),
        };
        let machine = Machine::new([mass, stiffness, 2.0 * zeta * mass * natural], [friction, 0.0, 1.0], 0.0);
        let times: Vec<f64> = (0..300).map(|i| f64::from(i) * 0.15 / natural).collect();
        let rates = [random.between(0.6, 0.9), random.between(1.1, 1.6)];
        let wave = |t: f64| (rates[0] * natural * t).sin() + 0.8 * (rates[1] * natural * t).sin();
        let samples: Vec<f64> =
            times.iter().map(|t| random.between(1.8, 2.2) * friction / unit * wave(*t)).collect();
        let spread = friction / stiffness;
        let start = [0.0, if n % 2 == 0 { 0.0 } else { 2.0 * spread * natural }];
        let exact = positions(machine, load, [&times, &samples], start, 128.0);
        let offset = 3.0 * spread * random.between(-1.0, 1.0);
        let record = Record::at_times(excitation, times.clone(), samples.clone()).unwrap();
        for noise in [0.0, 0.02] {
            let measured: Vec<f64> =
                exact.iter().map(|x| x + offset + noise * spread * normal(&mut random)).collect();
            let known = identify_motion(mass, Some(stiffness), &record, &measured).unwrap();
            // Each load with each start, in half of the machines: a fit of the stiffness takes ten times as long.
            let free = (n % 4 < 2).then(|| identify_motion(mass, None, &record, &measured).unwrap());
            for (which, found) in core::iter::once((0, known)).chain(free.map(|found| (1, found))) {
                assert_eq!(found.residuals.len(), 300);
                let truths = [
                    ("friction", Some(found.friction), friction, friction),
                    ("damping_ratio", Some(found.damping_ratio), zeta, 1.0),
                    ("damping", Some(found.damping), 2.0 * zeta * mass * natural, mass * natural),
                    ("friction_displacement", Some(found.friction_displacement), spread, spread),
                    ("offset", Some(found.offset), offset, spread),
                    ("start_displacement", Some(found.start_displacement), offset, spread),
                    ("start_velocity", found.start_velocity, start[1], spread * natural),
                    ("stiffness", found.stiffness, stiffness, stiffness),
                ];
                assert_eq!(found.start_velocity.is_some(), n % 2 == 1, "{n} {noise}");
                let of = |name: &str| format!("identify --motion {name}");
                for (name, estimate, truth, scale) in truths {
                    let Some(estimate) = estimate else { continue };
                    if noise == 0.0 {
                        let output = format!("{} by design::identify_motion", of(name));
                        compared(&output, estimate.value, truth, DenseSamples, 1e-6 * scale);
                        continue;
                    }
                    let (low, high) = estimate.interval();
                    all[which] += 1;
                    covered[which] += u32::from((low..=high).contains(&truth));
                    assert!(
                        (estimate.value - truth).abs() < 4.5 * estimate.standard_error,
                        "{n}: {truth} {estimate:?}"
                    );
                }
                compared(&of("noise"), found.noise / spread, noise, DenseSamples, 0.2 * noise + 1e-6);
            }
        }
        // A body at rest says nothing, and noise has no reason.
        assert!(matches!(
            identify_motion(mass, Some(stiffness), &record, &vec![offset; 300]),
            Err(Error::MotionNotIdentified)
        ));
        let nothing: Vec<f64> = times.iter().map(|_| spread * normal(&mut random)).collect();
        assert!(matches!(
            identify_motion(mass, Some(stiffness), &record, &nothing),
            Err(Error::MotionUnexplained { .. } | Error::MotionNotIdentified)
        ));
    }
    // Of 78 and 45 intervals of 95 %, of which those of friction and of damping are two for one, fewer than 88 % have a
    // probability below 1e-2.
    assert!(
        all == [78, 45] && covered.iter().zip(all).all(|(of, all)| 100 * of >= 88 * all),
        "{covered:?} of {all:?}"
    );
}
