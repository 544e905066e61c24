//! Designs and response curves beside the samples.

use super::{keys, rows};
use crate::command_line::{json, stdout};
use crate::compared::Origin::{ByHand, DenseSamples};
use crate::compared::{agreed, compared, near};
use crate::sampled::{Harmonic, Limit, Load, Machine, Of};
use serde_json::Value;
use std::collections::BTreeSet;
use std::f64::consts::TAU;

/// Designs by the command: the samples stop on one side of each answer only.
#[test]
fn designs_of_the_command_are_those_of_the_samples() {
    let (mass, stiffness, friction, frequency) = (50.0, 1000.0, 5.0, 6.0);
    let is_free = |amplitude: f64, friction: f64, eta: f64, load: Load| {
        let machine = Machine::new([mass, stiffness, 0.0], [friction, 0.0, eta], 0.0);
        let harmonic = Harmonic { machine, load, amplitude, frequency };
        match harmonic.limit([0.0, 0.0], 0.0, 3000) {
            Limit::Periodic(cycle) => (cycle.found.rests == 0, true),
            Limit::Rest(_) => (false, false),
            limit @ Limit::Unsettled => panic!("{limit:?}"),
        }
    };
    let answer = json(
        "design force --mass 50 --stiffness 1000 --friction 5 --frequency 6 --mean-force 3 --format json",
    );
    let of = |answer: &Value, name: &str| answer[name].as_f64().unwrap();
    let square = frequency * frequency;
    for (name, load, size) in [
        ("force", Load::Force, 1.0),
        ("unbalance", Load::Force, square),
        ("foot_displacement", Load::Foot, 1.0),
        ("base_displacement", Load::Surface, -square),
        ("base_acceleration", Load::Surface, -1.0),
    ] {
        let amplitude = size * of(&answer, name);
        let found = [0.9999, 1.0001].map(|by| is_free(amplitude * by, friction, 1.0, load).0);
        agreed(&format!("design force {name}"), found, [false, true], DenseSamples);
    }
    compared("design force mean_displacement", of(&answer, "mean_displacement"), 3.0 / 1000.0, ByHand, 1e-15);
    // In ratios, Ω = 6/√20: with static friction from a start at rest, and from every start.
    let omega = frequency / 20f64.sqrt();
    let given = "--static-ratio 1.2 --damping-ratio 0.1 --format json";
    let ratios = json(&format!("design force --omega {omega} {given}"));
    let units = json(&format!("design force --mass 50 --stiffness 1000 --friction 5 --frequency 6 {given}"));
    compared("design force omega", of(&ratios, "omega"), omega, ByHand, 0.0);
    let damping = 2.0 * 0.1 * 5e4f64.sqrt();
    let limits = |force: f64| {
        [[0.0, 0.0], [0.05, 0.0], [-0.3, 0.2], [0.0, -0.5]].map(|start| {
            let machine = Machine::new([mass, stiffness, damping], [friction, 0.0, 1.2], 0.0);
            let harmonic = Harmonic { machine, load: Load::Force, amplitude: force, frequency };
            match harmonic.limit(start, 0.0, 3000) {
                Limit::Periodic(cycle) => Some(cycle.found.rests),
                _ => None,
            }
        })
    };
    // The least force of a cycle without stops: the samples on it go on, and stop below.
    let slides = |force: f64, by: f64| {
        let machine = Machine::new([mass, stiffness, damping], [friction, 0.0, 1.2], 0.0);
        let start = |force: f64| Harmonic { machine, load: Load::Force, amplitude: force, frequency };
        // From far away, so that the body is moving when it comes to the cycle.
        match start(force * by).limit([5.0, 0.0], 0.0, 3000) {
            Limit::Periodic(cycle) => cycle.found.rests == 0,
            _ => false,
        }
    };
    for (name, force) in
        [("force_ratio", friction * of(&ratios, "force_ratio")), ("force", of(&units, "force"))]
    {
        let found = [slides(force, 0.9999), slides(force, 1.0001)];
        agreed(&format!("design force {name}"), found, [false, true], DenseSamples);
    }
    for (name, force) in [
        ("release_force", of(&units, "release_force")),
        ("release_force_ratio", friction * of(&ratios, "release_force_ratio")),
    ] {
        let output = format!("design force {name}");
        let found = [0.999, 1.001].map(|by| limits(by * force)[0].is_some());
        agreed(&output, found, [false, true], DenseSamples);
        near(&output, force, 1.2 * friction, ByHand, 1e-12);
    }
    for (name, force) in [
        ("every_start_force", of(&units, "every_start_force")),
        ("every_start_force_ratio", friction * of(&ratios, "every_start_force_ratio")),
    ] {
        agreed(&format!("design force {name}"), limits(force * (1.0 + 1e-9)), [Some(0); 4], DenseSamples);
    }
    let ratios = json(&format!("design friction --omega {omega} --format json"));
    compared("design friction omega", of(&ratios, "omega"), omega, ByHand, 0.0);
    let greatest = 12.0 * of(&ratios, "friction_to_force");
    let found = [0.9999, 1.0001].map(|by| is_free(12.0, by * greatest, 1.0, Load::Force).0);
    agreed("design friction friction_to_force", found, [true, false], DenseSamples);
    let answer = json(
        "design friction --mass 50 --stiffness 1000 --frequency 6 --force 12 --static-ratio 1.2 --format json",
    );
    let best = json("design friction --mass 50 --stiffness 1000 --frequency 6 --force 12 --format json");
    let found = [0.9999, 1.0001].map(|by| is_free(12.0, by * of(&best, "friction"), 1.0, Load::Force).0);
    agreed("design friction friction", found, [true, false], DenseSamples);
    let due = of(&best, "friction") / (mass * 9.80665);
    near("design friction friction_coefficient", of(&best, "friction_coefficient"), due, ByHand, 1e-12);
    // A body at rest is released below this friction, and not above.
    let release = of(&answer, "release_friction");
    assert!(is_free(12.0, release * 0.999, 1.2, Load::Force).1);
    assert!(!is_free(12.0, release * 1.001, 1.2, Load::Force).1);
}

/// With static friction: at the friction that is low enough for every start, none of the samples stops, and a body at rest is
/// released up to the friction over the static ratio.
#[test]
fn frictions_for_every_start_and_for_release_are_those_of_the_samples() {
    let (mass, stiffness, damping, frequency, force, eta) = (50.0, 1000.0, 60.0, 6.0, 12.0, 1.2);
    let limit = |friction: f64, start: [f64; 2]| {
        let machine = Machine::new([mass, stiffness, damping], [friction, 0.0, eta], 0.0);
        let harmonic = Harmonic { machine, load: Load::Force, amplitude: force, frequency };
        harmonic.limit(start, 0.0, 3000)
    };
    let moves = |friction: f64| !matches!(limit(friction, [0.0, 0.0]), Limit::Rest(_));
    let rests = |friction: f64| -> Vec<u64> {
        let starts = [[0.0, 0.0], [0.05, 0.0], [-0.3, 0.2], [0.0, -0.5], [1.0, 0.0]];
        let found = starts.map(|start| match limit(friction, start) {
            Limit::Periodic(cycle) => cycle.found.rests,
            limit => panic!("{start:?}: {limit:?}"),
        });
        found.to_vec()
    };
    let physical = json(
        "design friction --mass 50 --stiffness 1000 --damping 60 --frequency 6 --force 12 --static-ratio 1.2 --format json",
    );
    // Ω = 6/√20, ζ = 60/(2 √50000).
    let (omega, zeta) = (frequency / 20f64.sqrt(), damping / (2.0 * 5e4f64.sqrt()));
    let ratios = json(&format!(
        "design friction --omega {omega} --damping-ratio {zeta} --static-ratio 1.2 --format json"
    ));
    let of = |answer: &Value, name: &str| answer[name].as_f64().unwrap();
    for (output, friction) in [
        ("every_start_friction", of(&physical, "every_start_friction")),
        ("every_start_friction_to_force", force * of(&ratios, "every_start_friction_to_force")),
    ] {
        agreed(&format!("design friction {output}"), rests(friction), vec![0; 5], DenseSamples);
    }
    for (output, friction) in [
        ("release_friction", of(&physical, "release_friction")),
        ("release_friction_to_force", force * of(&ratios, "release_friction_to_force")),
    ] {
        let output = format!("design friction {output}");
        agreed(&output, [moves(0.999 * friction), moves(1.001 * friction)], [true, false], DenseSamples);
        compared(&output, friction, force / eta, ByHand, 1e-12 * force);
    }
    // The bound for every start is not the friction of the cycle: above it there are starts that stop.
    assert!(of(&physical, "every_start_friction") < of(&physical, "friction"));
}

/// What a design repeats or follows from by a definition, beside arithmetic.
#[test]
fn what_designs_repeat_is_computed_by_hand() {
    let of = |answer: &Value, name: &str| answer[name].as_f64().unwrap();
    let body = "--mass 50kg --stiffness 1000N/m --friction 5N";
    let omega = 6.0 / 20f64.sqrt();
    for (kind, option) in [("design dissipation", ""), ("design dissipation --sticking", " --sticking")] {
        let units = json(&format!(
            "design dissipation --mass 50kg --stiffness 1000N/m --frequency 6rad/s --force 12N{option} --format json"
        ));
        let ratios = json(&format!("design dissipation --omega {omega}{option} --format json"));
        // A search ends where the energy is flat: within the root of its rounding.
        let part = if option.is_empty() { 1e-12 } else { 1e-6 };
        let (ratio, size) = (12.0 / of(&units, "friction"), of(&units, "energy") * 2.0 * 1000.0 / 144.0);
        near(&format!("{kind} force_ratio"), of(&ratios, "force_ratio"), ratio, ByHand, part);
        near(&format!("{kind} loop_size_stiffness"), of(&ratios, "loop_size_stiffness"), size, ByHand, 1e-12);
    }
    // Bands in units and in ratios: Ω times ω_n = √20.
    let natural = 20f64.sqrt();
    let bands = json(&format!("design bands {body} --force 60N --from 1rad/s --to 9rad/s --format json"));
    let ratios = json(&format!(
        "design bands --alpha 12 --from {} --to {} --format json",
        1.0 / natural,
        9.0 / natural
    ));
    let (bands, ratios) = (bands.as_array().unwrap(), ratios.as_array().unwrap());
    assert!(bands.len() == 2 && ratios.len() == 2);
    // The border in closed form without a damper; with one its ends are searched.
    let damped = json(&format!(
        "design bands {body} --damping 10N*s/m --force 60N --from 1rad/s --to 9rad/s --format json"
    ));
    let found_by = [&bands[0], &damped[0]].map(|band| band["found_by"].as_str());
    let output = "design bands found_by by design::Bands::is_searched";
    agreed(output, found_by, [None, Some("search")], ByHand);
    for (band, same) in bands.iter().zip(ratios) {
        for end in ["from", "to"] {
            let due = of(same, &format!("omega_{end}")) * natural;
            near(
                &format!("design bands frequency_{end}"),
                of(band, &format!("frequency_{end}")),
                due,
                ByHand,
                1e-12,
            );
        }
    }
    // Friction over a band: the coefficient, and the crest at this friction.
    let best = json(
        "design friction --mass 50kg --stiffness 1000N/m --damping 10N*s/m --over 0.2Hz:2Hz --of displacement --force 12N --format json",
    );
    let output = "design friction --over";
    let coefficient = of(&best, "friction") / 50.0 / 9.80665;
    near(
        &format!("{output} friction_coefficient"),
        of(&best, "friction_coefficient"),
        coefficient,
        ByHand,
        1e-12,
    );
}

const ON_BASE: &str = "the base carries the surface: p₀ = m ω_d² u₀, x relative to the base";

/// The least crest of a body that moves with its base is between rest and hardly any friction, where only a search finds it.
#[test]
fn the_least_crest_on_a_base_is_searched() {
    let answer = json(
        "design friction --mass 2kg --stiffness 50N/m --damping 1N*s/m --base-displacement 50mm --over 0.7Hz:1.2Hz \
         --of absolute-displacement --format json",
    );
    agreed("design friction --over found_by", answer["found_by"].as_str(), Some("search"), ByHand);
    agreed("design friction --over base_motion", answer["base_motion"].as_str(), Some(ON_BASE), ByHand);
}

/// `rest_friction`: from it on the samples from rest never move over the band, and below it they do somewhere.
#[test]
fn the_friction_of_rest_over_a_band_is_that_of_the_samples() {
    let (mass, stiffness, damping) = (50.0, 1000.0, 10.0);
    for (drive, load, size) in [
        ("force 12N", Load::Force, (|_| 12.0) as fn(f64) -> f64),
        ("foot-displacement 20mm", Load::Foot, |_| 0.02),
        ("base-displacement 20mm", Load::Surface, |frequency| -0.02 * frequency * frequency),
    ] {
        let answer = json(&format!(
            "design friction --mass 50kg --stiffness 1000N/m --damping 10N*s/m --over 0.2Hz:2Hz --of displacement --{drive} --format json"
        ));
        let found = answer["rest_friction"].as_f64().unwrap();
        let moves = |friction: f64| {
            (0..=9).any(|place| {
                let frequency = TAU * (0.2 + 0.2 * f64::from(place));
                let machine = Machine::new([mass, stiffness, damping], [friction, 0.0, 1.0], 0.0);
                let harmonic = Harmonic { machine, load, amplitude: size(frequency), frequency };
                !matches!(harmonic.limit([0.0, 0.0], 0.0, 3000), Limit::Rest(_))
            })
        };
        // A body at rest has no displacement, which needs no search.
        agreed("design friction --over found_by", answer["found_by"].as_str(), None, ByHand);
        let base = match load {
            Load::Surface => Some(ON_BASE),
            Load::Foot => {
                Some("the spring's support moves over a fixed surface: p₀ = k u₀, x over the surface")
            }
            _ => None,
        };
        agreed("design friction --over base_motion", answer["base_motion"].as_str(), base, ByHand);
        let output = "design friction --over rest_friction";
        agreed(output, [moves(0.999 * found), moves(1.001 * found)], [true, false], DenseSamples);
    }
}

/// `design friction --target-amplitude`: with each friction the samples have this amplitude, and between them they have
/// another.
#[test]
fn frictions_for_an_amplitude_are_those_of_the_samples() {
    let amplitude = |friction: f64| {
        let machine = Machine::new([50.0, 1000.0, 10.0], [friction, 0.0, 1.0], 0.0);
        let harmonic = Harmonic { machine, load: Load::Force, amplitude: 12.0, frequency: 3.0 };
        match harmonic.limit([0.0, 0.0], 0.0, 3000) {
            Limit::Periodic(cycle) => (cycle.found.most(Of::Displacement).value, cycle.found.rests > 0),
            limit => panic!("{limit:?}"),
        }
    };
    for target in [0.006, 0.01, 0.018] {
        let answer = json(&format!(
            "design friction --mass 50kg --stiffness 1000N/m --damping 10N*s/m --frequency 3rad/s --force 12N \
             --target-amplitude {target}m --format json"
        ));
        let solutions = answer["solutions"].as_array().unwrap();
        let of = |solution: &Value, name: &str| solution[name].as_f64().unwrap();
        assert!(!solutions.is_empty(), "{answer}");
        let output = "design friction --target-amplitude";
        compared(
            &format!("{output} target_amplitude"),
            of(&answer, "target_amplitude"),
            target,
            ByHand,
            1e-15,
        );
        for solution in solutions {
            let friction = of(solution, "friction");
            let (found, sticks) = amplitude(friction);
            let function = "design::frictions_for_displacement";
            near(&format!("{output}[] friction by {function}"), target, found, DenseSamples, 1e-8);
            near(
                &format!("{output}[] max_displacement"),
                of(solution, "max_displacement"),
                found,
                DenseSamples,
                1e-8,
            );
            let regime = if sticks { "sticking" } else { "non-sticking" };
            agreed(&format!("{output}[] regime"), solution["regime"].as_str(), Some(regime), DenseSamples);
            let coefficient = of(solution, "friction_coefficient");
            near(
                &format!("{output}[] friction_coefficient"),
                coefficient,
                friction / 50.0 / 9.80665,
                ByHand,
                1e-12,
            );
        }
        // Over a grid the samples pass the amplitude as often as there are solutions.
        let grid: Vec<bool> = (1..40).map(|i| amplitude(0.29 * f64::from(i)).0 > target).collect();
        let passes = grid.windows(2).filter(|pair| pair[0] != pair[1]).count();
        agreed(&format!("{output} solutions"), solutions.len(), passes, DenseSamples);
    }
}

/// The rows of a response curve beside the samples at their frequencies.
#[test]
fn curves_of_the_command_are_those_of_the_samples() {
    let (mass, stiffness, damping, friction) = (50.0, 1000.0, 20.0, 5.0);
    let mut names = BTreeSet::new();
    for (drive, load, amplitude) in
        [("force 12N", Load::Force, 12.0), ("base-displacement 30mm", Load::Surface, 0.03)]
    {
        for what in ["displacement", "velocity", "acceleration", "force", "transmissibility", "absolute"] {
            if what == "absolute" && load == Load::Force {
                continue;
            }
            let line = format!(
                "response-curve {what} --mass 50kg --stiffness 1kN/m --damping 20N*s/m --friction 5N --{drive} --frequency 0.4Hz:1.5Hz:6"
            );
            let text = stdout(&line);
            let mut reader = csv::Reader::from_reader(text.as_bytes());
            let header: Vec<String> = reader.headers().unwrap().iter().map(str::to_owned).collect();
            names.extend(keys(&text));
            let column = header.iter().position(|name| name.starts_with(what)).unwrap();
            // The frequencies of the grid are those asked for, in their order; a peak is above its neighbours.
            let all: Vec<csv::StringRecord> =
                csv::Reader::from_reader(text.as_bytes()).records().map(Result::unwrap).collect();
            let number = |row: &csv::StringRecord, column: usize| row[column].parse::<f64>().unwrap();
            let of_grid: Vec<f64> =
                all.iter().filter(|row| &row[5] == "grid").map(|row| number(row, 1)).collect();
            assert_eq!(of_grid.len(), 6, "{line}");
            for (found, i) in of_grid.into_iter().zip(0..) {
                near("response-curve point", found, 0.4 + 0.22 * f64::from(i), ByHand, 1e-12);
            }
            for three in all.windows(3).filter(|three| &three[1][5] == "peak") {
                let [before, peak, after] = [0, 1, 2].map(|i| number(&three[i], column));
                agreed("response-curve point", peak >= before && peak >= after, true, ByHand);
            }
            let name = if what == "absolute" { "absolute displacement" } else { what };
            agreed("response-curve curve", all[0][0].contains(name), true, ByHand);
            let mut compared = 0;
            for row in reader.records().map(Result::unwrap).step_by(3) {
                let frequency = TAU * row[1].parse::<f64>().unwrap();
                let machine = Machine::new([mass, stiffness, damping], [friction, 0.0, 1.0], 0.0);
                let square = frequency * frequency;
                let size = if load == Load::Surface { -amplitude * square } else { amplitude };
                let harmonic = Harmonic { machine, load, amplitude: size, frequency };
                let force = if load == Load::Surface { mass * square * amplitude } else { amplitude };
                let Limit::Periodic(cycle) = harmonic.limit([0.0, 0.0], 0.0, 2000) else { continue };
                let found = &cycle.found;
                let expected = match what {
                    "displacement" => found.greatest(Of::Displacement).value,
                    "velocity" => found.greatest(Of::Velocity).value,
                    "acceleration" => found.greatest(Of::Acceleration).value,
                    "force" => found.greatest(Of::Transmitted).value,
                    "absolute" => found.greatest(Of::AbsoluteDisplacement).value,
                    _ => found.greatest(Of::Transmitted).value / force,
                };
                compared += 1;
                let value: f64 = row[column].parse().unwrap();
                near(&format!("response-curve {what}"), value, expected, DenseSamples, 1e-8);
                near("response-curve frequency", value, expected, DenseSamples, 1e-8);
                let regime = if found.rests == 0 { "non-sticking" } else { "sticking" };
                agreed("response-curve regime", &row[2], regime, DenseSamples);
                // The force over the least one that keeps the samples sliding.
                let margin: f64 = row[4].parse().unwrap();
                agreed("response-curve margin", margin > 1.0, found.rests == 0, DenseSamples);
            }
            assert!(compared > 4, "{line}: {compared}");
        }
    }
    let page = rows()["response-curve"].iter().map(|name| (*name).to_owned()).collect();
    assert_eq!(names, page);
}
