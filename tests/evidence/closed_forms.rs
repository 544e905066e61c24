//! The closed forms, every column of them and the border, beside dense samples of the motion.

use crate::compared::Origin::DenseSamples;
use crate::compared::{agreed, near};
use crate::machines::Driven;
use crate::random::Random;
use crate::sampled::{Cycle, Extreme, Limit, Of};
use crate::steady::{Expected, Units, equivalent, hold, spring, transmitted};
use stickslip::internal::{ResponseAnswer, Value};
use stickslip::{Border, Excitation, Output, Ratios, Response};

/// The size of the loop in p₀²/(2k) by the samples, at Ω, α and ζ.
fn loop_size(random: &mut Random, [omega, alpha, zeta]: [f64; 3]) -> Option<(f64, Cycle)> {
    let driven = Driven::at(random, [omega, alpha, zeta, 1.0], Excitation::Force);
    let harmonic = driven.harmonic();
    let Limit::Periodic(cycle) = harmonic.limit([harmonic.mean(), 0.0], 0.0, 3000) else { return None };
    let work = driven.friction * (cycle.found.path[0] + cycle.found.path[1]);
    Some((2.0 * work * driven.stiffness / driven.force().powi(2), *cycle))
}

fn absolute(extreme: [Extreme; 2], by: f64) -> Extreme {
    let size = |of: fn(&Extreme) -> f64| extreme.iter().map(|e| (of(e) - by).abs()).fold(0.0, f64::max);
    Extreme { sampled: size(|e| e.sampled), value: size(|e| e.value), time: 0.0 }
}

/// What the samples give for a column of the closed forms, of a motion with two reversals or of another.
fn expected(name: &str, driven: &Driven, cycle: &Cycle, value: Value<f64>) -> Expected {
    let units = Units::of(driven);
    let found = &cycle.found;
    let mean = driven.harmonic().mean();
    let (most, fastest) = (found.most(Of::Displacement), found.most(Of::Velocity));
    let reach = (most.value - mean).abs();
    let has_cycle = found.rests == 0 && found.ends == 2;
    let of_cycle = |expected: Expected| if has_cycle { expected } else { Expected::Nothing };
    let greatest = |extreme: Extreme, unit: f64| {
        of_cycle(Expected::Most(extreme, unit, 1e-9 * (extreme.value / unit).abs()))
    };
    let number = |x: f64| of_cycle(Expected::Number(x, 1e-9 * x.abs()));
    let work = driven.friction * (found.path[0] + found.path[1]);
    let p0 = driven.force();
    match name {
        // A motion without stops exists, and another start may lead to one with stops.
        "regime" if driven.eta > 1.0 && value == Value::Text("depends-on-start") => Expected::Elsewhere,
        "regime" => Expected::Text(if found.rests > 0 { "sticking" } else { "non-sticking" }),
        "motion_without_stop" if found.rests == 0 => Expected::Flag(true),
        "motion_without_stop" if driven.eta > 1.0 => Expected::Elsewhere,
        "motion_without_stop" => Expected::Flag(false),
        "moves_from_rest" => Expected::Flag(p0 > driven.eta * driven.friction),
        "max_displacement" => {
            let extreme = Extreme { sampled: most.sampled - mean, value: most.value - mean, ..most };
            greatest(extreme, units.length)
        }
        "displacement_phase" => of_cycle(Expected::Phase(driven.phase(most.time), 2e-7)),
        "max_velocity" => greatest(fastest, units.velocity),
        "velocity_phase" => of_cycle(Expected::Phase(driven.phase(fastest.time), 2e-7)),
        "deviation" => {
            let at = driven.harmonic().states(cycle, driven.frequency * fastest.time);
            of_cycle(Expected::Number((at[0][0] - mean) / units.length, 1e-6 * reach / units.length))
        }
        // Tests of their own hold these beside the motion.
        "min_force_ratio"
        | "min_force_ratio_turning_point"
        | "best_force_ratio"
        | "best_loop_size"
        | "best_force_ratio_slides" => Expected::Elsewhere,
        "loop_size_stiffness" => number(2.0 * work * driven.stiffness / (p0 * p0)),
        "loop_size_inertia" => number(2.0 * work * driven.mass * (driven.frequency / p0).powi(2)),
        // The greater multiplier of a cycle is the square of that of half a cycle.
        "contraction" => {
            let [sum, product] = cycle.multipliers;
            let root = sum * sum / 4.0 - product;
            let size = if root < 0.0 { product.sqrt() } else { sum.abs() / 2.0 + root.sqrt() };
            of_cycle(Expected::Number(size.sqrt(), 1e-5))
        }
        "reversals_per_cycle" if found.rests > 0 => Expected::Nothing,
        "reversals_per_cycle" => Expected::Count(found.ends),
        "dynamic_amplification" => number((most.value - mean) * driven.stiffness / p0),
        "max_acceleration" => greatest(found.greatest(Of::Acceleration), units.acceleration),
        "transmitted_force" => greatest(transmitted(driven, cycle).0, units.force),
        "transmissibility" => greatest(transmitted(driven, cycle).1, 1.0),
        "max_absolute_displacement" if driven.is_surface() => {
            let ends = [found.most(Of::AbsoluteDisplacement), found.least(Of::AbsoluteDisplacement)];
            greatest(absolute(ends, mean), units.length)
        }
        "max_absolute_displacement" if driven.is_foot() => {
            greatest(absolute([most, found.least(Of::Displacement)], mean), units.length)
        }
        "max_absolute_displacement" => Expected::Nothing,
        "max_spring_force" => greatest(spring(driven, cycle), units.force),
        "equivalent_damping"
        | "equivalent_damping_ratio"
        | "equivalent_stiffness"
        | "effective_damping_ratio" => number(equivalent(name, driven, cycle)),
        "damper_work" => {
            of_cycle(Expected::Number(found.damper_work / units.work, 1e-9 * p0 * reach * 4.0 / units.work))
        }
        _ => panic!("no reference of {name}"),
    }
}

/// The function of the library that a column is from.
fn function(name: &str) -> &'static str {
    match name {
        "contraction" => "Cycle::contraction",
        "damper_work" => "Cycle::damper_work",
        "deviation" => "Cycle::deviation",
        "loop_size_inertia" => "Cycle::loop_size_inertia",
        "motion_without_stop" => "Response::has_motion_without_stop",
        "loop_size_stiffness" => "Cycle::loop_size_stiffness",
        "reversals_per_cycle" => "Response::reversals_per_cycle",
        _ => "Response::new",
    }
}

/// The border of a machine.
fn no_stop_above(driven: &Driven) -> f64 {
    Border::of(&driven.ratios()).min_force_ratio
}

/// Every column of the closed forms, of machines with and without a cycle of two reversals under every drive.
#[test]
fn every_column_of_the_closed_forms_is_that_of_the_samples() {
    let mut random = Random(12);
    let mut failures: Vec<String> = Vec::new();
    for excitation in Excitation::ALL {
        let (mut compared, mut cycles) = (0, 0);
        while compared < 40 {
            let mut driven = Driven::any(&mut random, excitation);
            if random.next() < 0.7 {
                let ratios = driven.ratios();
                let alpha = no_stop_above(&driven) * random.scale(1.01, 8.0);
                let eta = driven.eta;
                let at = [ratios.omega(), alpha, ratios.damping_ratio(), eta];
                driven = Driven::at(&mut random, at, excitation);
            }
            let harmonic = driven.harmonic();
            let start = [harmonic.mean(), 0.0];
            let Limit::Periodic(cycle) = harmonic.limit(start, -driven.lead(), 400) else { continue };
            compared += 1;
            cycles += u32::from(cycle.found.rests == 0 && cycle.found.ends == 2);
            // With static friction a body may stop from rest, and not from the motion without stops.
            let is_of_start = driven.eta > 1.0 && cycle.found.rests > 0;
            let response = Response::new(driven.ratios());
            let answer = ResponseAnswer { response: &response, peaks: true };
            if let Some(guarded) = Response::guarded(driven.ratios()).cycle.filter(|_| !is_of_start) {
                let value = Value::Number(Some(guarded.max_displacement));
                let expected = expected("max_displacement", &driven, &cycle, value);
                failures.extend(hold("fn Response::guarded", value, expected, &driven).err());
            }
            for column in ResponseAnswer::<f64>::COLUMNS {
                let name = column.definition.name;
                let value = (column.of)(&answer);
                if is_of_start && response.cycle.is_some() {
                    continue;
                }
                let expected = expected(name, &driven, &cycle, value);
                let output = format!("response {name} by {}", function(name));
                let of_output = Output::ALL.into_iter().find(|output| output.definition().name == name);
                // The same by its name alone, and among several.
                if let (Some(output), Value::Number(Some(_)), false) =
                    (of_output, value, expected.is_elsewhere())
                {
                    let one = Value::Number(output.of(&response));
                    let got = Value::Number(response.get(output));
                    failures.extend(hold("fn Response::get", got, expected, &driven).err());
                    let [of_all, _] = Output::values([output, Output::MinForceRatio], driven.ratios());
                    failures.extend(hold("fn Output::of", one, expected, &driven).err());
                    failures.extend(
                        hold("fn Output::values", Value::Number(Some(of_all)), expected, &driven).err(),
                    );
                }
                failures.extend(hold(&output, value, expected, &driven).err());
            }
        }
        assert!(cycles >= 20, "{excitation:?}: {cycles}");
    }
    failures.sort();
    assert!(failures.is_empty(), "{}: {}", failures.len(), failures.join("\n"));
}

/// Whether a motion has two reversals and no stop.
fn is_free(random: &mut Random, [omega, alpha, zeta, eta]: [f64; 4], start: Option<[f64; 3]>) -> bool {
    let driven = Driven::at(random, [omega, alpha, zeta, eta], Excitation::Force);
    let harmonic = driven.harmonic();
    let units = Units::of(&driven);
    let ([x, v], phase) = start.map_or(([0.0, 0.0], 0.0), |[x, v, phase]| ([x, v], phase));
    let start = [harmonic.mean() + x * units.length, v * units.velocity];
    match harmonic.limit(start, phase, 4000) {
        Limit::Periodic(cycle) => cycle.found.rests == 0 && cycle.found.ends == 2,
        Limit::Rest(_) | Limit::Unsettled => false,
    }
}

/// The border: just above it the motion of the samples has two reversals, and just below it others or stops.
#[test]
fn the_border_is_where_the_samples_begin_to_stop() {
    let mut random = Random(13);
    for i in 0..60 {
        let omega = random.scale(0.15, 3.0);
        let zeta = if i % 3 == 0 { 0.0 } else { random.scale(0.01, 2.0) };
        let ratios = Ratios::new(omega, 1.0).unwrap().with_damping_ratio(zeta).unwrap();
        let border = Border::of(&ratios);
        let least = border.min_force_ratio;
        assert_eq!(Response::new(ratios).border.min_force_ratio.to_bits(), least.to_bits());
        // Beside a pole of K, or far below resonance, a clearance of a millionth is lost in the samples.
        let off = 1e-4;
        let above = is_free(&mut random, [omega, least * (1.0 + off), zeta, 1.0], None);
        let below = is_free(&mut random, [omega, least * (1.0 - off), zeta, 1.0], None);
        for of in ["response", "border"] {
            agreed(
                &format!("{of} min_force_ratio by Border::of"),
                [below, above],
                [false, true],
                DenseSamples,
            );
        }
        // On the border the displacement is the least of a motion without stops.
        let (_, cycle) = loop_size(&mut random, [omega, least * (1.0 + 1e-9), zeta]).unwrap();
        let _ = cycle;
    }
}

/// α* and A₁max: no force has a larger loop, and the loop of the samples there is this large.
#[test]
fn no_force_has_a_larger_loop_than_the_best_one() {
    let mut random = Random(14);
    let mut slides = 0;
    for i in 0..40 {
        let omega = random.scale(0.6, 3.0);
        let zeta = if i % 3 == 0 { 0.0 } else { random.scale(0.01, 0.5) };
        let ratios = Ratios::new(omega, 2.0).unwrap().with_damping_ratio(zeta).unwrap();
        let response = Response::new(ratios);
        let (best, size) = (response.best_force_ratio, response.best_loop_size);
        let Some(size) = size else { continue };
        let Some((found, cycle)) = loop_size(&mut random, [omega, best, zeta]) else { continue };
        let is_free = cycle.found.rests == 0 && cycle.found.ends == 2;
        let output = "response best_force_ratio_slides by Response::best_is_reached";
        agreed(output, response.best_is_reached(), is_free, DenseSamples);
        if !is_free {
            continue;
        }
        slides += 1;
        near("response best_loop_size", size, found, DenseSamples, 1e-9);
        let others = [0.7, 0.9, 0.98, 1.02, 1.1, 1.4];
        let is_less = others.map(|by| loop_size(&mut random, [omega, best * by, zeta]).unwrap().0 < size);
        for of in ["response", "border"] {
            agreed(&format!("{of} best_force_ratio"), is_less, [true; 6], DenseSamples);
        }
    }
    assert!(slides > 8, "{slides}");
}
