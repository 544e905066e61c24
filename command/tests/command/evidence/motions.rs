//! Motions, their limits and maps of them beside the samples.

use crate::command_line::{json, stdout, stickslip};
use crate::compared::Origin::{ByHand, DenseSamples};
use crate::compared::{agreed, compared, near};
use crate::sampled::{Harmonic, Limit, Load, Machine, Of, record};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::TAU;

/// The harmonic machine of ratios.
fn ratios([omega, alpha, zeta, eta]: [f64; 4]) -> Harmonic {
    let machine = Machine::new([1.0, 1.0, 2.0 * zeta], [1.0, 0.0, eta], 0.0);
    Harmonic { machine, load: Load::Force, amplitude: alpha, frequency: omega }
}

/// Attractors with their shares, and the basin of each start of a plane.
#[test]
fn attractors_and_basins_are_those_of_the_samples() {
    let at = [0.5, 4.0, 0.02, 1.3];
    let options = "--omega 0.5 --alpha 4 --damping-ratio 0.02 --static-ratio 1.3";
    let answer = json(&format!("attractors {options} --starts 40 --format json"));
    let limits = answer["attractors"].as_array().unwrap();
    let number = |value: &Value| value.as_f64().unwrap();
    agreed("attractors starts", answer["starts"].as_u64(), Some(40), ByHand);
    for (name, due) in [("omega", 0.5), ("alpha", 4.0), ("static_friction_ratio", 1.3)] {
        agreed(&format!("attractors {name}"), answer[name].as_f64(), Some(due), ByHand);
    }
    let reach = number(&answer["reach"]);
    let harmonic = ratios(at);
    let cycle = |x: f64, v: f64| match harmonic.limit([x, v * at[0]], 0.0, 3000) {
        Limit::Periodic(cycle) => cycle,
        limit => panic!("{x} {v}: {limit:?}"),
    };
    let mut starts = 0;
    let of = |name: &str| format!("attractors[] {name}");
    for (place, limit) in limits.iter().enumerate() {
        starts += limit["starts"].as_u64().unwrap();
        compared(&of("share"), number(&limit["share"]), number(&limit["starts"]) / 40.0, ByHand, 1e-12);
        agreed(&of("attractor"), limit["attractor"].as_u64(), Some(place as u64 + 1), ByHand);
        let (x, v) = (number(&limit["first_x"]), number(&limit["first_v"]));
        agreed("attractors reach", x.abs() <= reach && v.abs() <= reach, true, ByHand);
        let found = cycle(x, v);
        agreed(&of("limit"), limit["limit"].as_str(), Some("periodic"), DenseSamples);
        let most = found.found.most(Of::Displacement).value;
        let least = found.found.least(Of::Displacement).value;
        for (name, due) in [("max_displacement", most), ("min_displacement", least)] {
            compared(&of(name), number(&limit[name]), due, DenseSamples, 1e-8);
            // The start that is named leads to this attractor, and no other one.
            compared(&of("first_x"), number(&limit[name]), due, DenseSamples, 1e-8);
            compared(&of("first_v"), number(&limit[name]), due, DenseSamples, 1e-8);
        }
        agreed(
            &of("sticks_per_cycle"),
            limit["sticks_per_cycle"].as_u64(),
            Some(found.found.rests),
            DenseSamples,
        );
        let zeros = limit["velocity_zeros_per_cycle"].as_u64();
        agreed(&of("velocity_zeros_per_cycle"), zeros, Some(found.found.ends), DenseSamples);
        agreed(
            &of("turns_per_cycle"),
            limit["turns_per_cycle"].as_u64(),
            Some(found.turns.into()),
            DenseSamples,
        );
        agreed(&of("symmetric"), limit["symmetric"].as_bool(), Some(found.is_symmetric), DenseSamples);
        let rest = found.found.rest * at[0] / TAU / f64::from(found.turns);
        compared(&of("stick_fraction"), number(&limit["stick_fraction"]), rest, DenseSamples, 1e-8);
        if let Some(mirror) = limit["mirror"].as_u64() {
            let other = &limits[mirror as usize - 1];
            compared(&of("mirror"), number(&other["max_displacement"]), -least, DenseSamples, 1e-8);
        }
    }
    agreed("attractors attractors", starts, 40, ByHand);
    let rows = stdout(&format!("basins {options} --x0=-6:6:7 --v0=-6:6:7"));
    let mut of_number: BTreeMap<String, [f64; 2]> = BTreeMap::new();
    let mut rows_compared = 0;
    for row in csv::Reader::from_reader(rows.as_bytes()).records() {
        let row = row.unwrap();
        let found = cycle(row[0].parse().unwrap(), row[1].parse().unwrap());
        let now = [found.found.most(Of::Displacement).value, found.found.least(Of::Displacement).value];
        let before = of_number.entry(row[2].to_owned()).or_insert(now);
        for (before, now) in before.iter().zip(now) {
            compared("basins attractor", *before, now, DenseSamples, 1e-7);
        }
        let place = |number: usize| -6.0 + 2.0 * number as f64;
        let sorted = [row[0].parse::<f64>().unwrap(), row[1].parse::<f64>().unwrap()];
        let is_there = sorted.map(|at| (0..7).any(|i| place(i) == at));
        agreed("basins x0", is_there[0], true, ByHand);
        agreed("basins v0", is_there[1], true, ByHand);
        // Said in words: the turns of the samples, and whether they are symmetric.
        let is_symmetric = !row[3].starts_with("Not symmetric");
        agreed("basins limit", is_symmetric, found.is_symmetric, DenseSamples);
        agreed("basins limit", row[3].contains("one turn"), found.turns == 1, DenseSamples);
        rows_compared += 1;
    }
    assert!(rows_compared == 49 && of_number.len() > 1, "{rows_compared} {of_number:?}");
    let mut values = of_number.values();
    let first = values.next().unwrap();
    assert!(values.all(|value| (value[0] - first[0]).abs() > 1e-3), "{of_number:?}");
}

/// Segments and samples of `simulate`, in ratios and in units.
#[test]
fn segments_of_the_command_are_those_of_the_samples() {
    let (mass, stiffness, friction, force, frequency) = (2.0, 50.0, 3.0, 14.0, 2.0);
    let machine = Machine::new([mass, stiffness, 0.0], [friction, 0.0, 1.0], 0.0);
    let harmonic = Harmonic { machine, load: Load::Force, amplitude: force, frequency };
    let options =
        "--mass 2kg --stiffness 50N/m --friction 3N --force 14N --frequency 2rad/s --cycles 2 --format csv";
    let (length, velocity) = (friction / stiffness, friction / stiffness * frequency);
    let state = |time: f64| {
        let mut follower = harmonic.follower([0.0, 0.0], 0.0);
        if time > 0.0 {
            follower.set_step(time / 600.0);
            (0..600).for_each(|_| follower.advance(&mut None));
        }
        (follower.state, follower.sign)
    };
    let rows = |text: &str| -> Vec<BTreeMap<String, String>> {
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        let names: Vec<String> =
            reader.headers().unwrap().iter().map(|name| name.split('[').next().unwrap().to_owned()).collect();
        let rows = reader.records().map(Result::unwrap);
        rows.map(|row| names.iter().cloned().zip(row.iter().map(str::to_owned)).collect()).collect()
    };
    let segments = rows(&stdout(&format!("simulate {options}")));
    assert!(segments.len() > 4, "{}", segments.len());
    let mut kinds = BTreeSet::new();
    for segment in &segments {
        let of = |name: &str| segment[name].parse::<f64>().unwrap();
        let phase = |cycle: &str, phase: &str| (TAU * of(cycle) + of(phase)) / frequency;
        let (start, end) = (phase("start_cycle", "start_phase"), phase("end_cycle", "end_phase"));
        assert!((start - of("start_time")).abs() < 1e-12 && (end - of("end_time")).abs() < 1e-12);
        assert!((of("duration") / frequency - (end - start)).abs() < 1e-12);
        let same = |name: &str, unit: f64, due: f64, room: f64| {
            compared(&format!("simulate {name}"), of(name) * unit, due, DenseSamples, room);
        };
        let (z, _) = state(start);
        same("start_displacement", 1.0, z[0], 1e-9);
        same("start_x", length, z[0], 1e-9);
        same("start_velocity", 1.0, z[1], 1e-8);
        same("start_v", velocity, z[1], 1e-8);
        let (z, _) = state(end);
        same("end_displacement", 1.0, z[0], 1e-9);
        same("end_x", length, z[0], 1e-9);
        // The direction changes at both ends, and only there.
        let (middle, before, after) =
            (state((start + end) / 2.0).1, state(end - 1e-6).1, state(end + 1e-6).1);
        let is_end = |output: &str| {
            agreed(output, [before == middle, after != middle], [true, true], DenseSamples);
        };
        for name in ["end_time", "end_cycle", "end_phase", "duration"] {
            is_end(&format!("simulate {name}"));
        }
        if start > 0.0 {
            let begins = [state(start - 1e-6).1 != middle, state(start + 1e-6).1 == middle];
            for name in ["start_time", "start_cycle", "start_phase"] {
                agreed(&format!("simulate {name}"), begins, [true, true], DenseSamples);
            }
        }
        let sign = state((start + end) / 2.0).1;
        let kind = ["slide-backward", "stick", "slide-forward"][(sign + 1) as usize];
        agreed("simulate kind", segment["kind"].as_str(), kind, DenseSamples);
        // A stick ends by a release; a slide by a stop, or by a reversal where the body goes back at once.
        let after = state(end + 1e-6).1;
        let ends_by = if sign == 0 {
            "release"
        } else if after == 0 {
            "stop"
        } else {
            "reversal"
        };
        agreed("simulate ends_by", segment["ends_by"].as_str(), ends_by, DenseSamples);
        kinds.insert(kind);
    }
    assert_eq!(kinds.len(), 3);
    for (number, sample) in rows(&stdout(&format!("simulate {options} --samples 9"))).iter().enumerate() {
        let of = |name: &str| sample[name].parse::<f64>().unwrap();
        let time = (TAU * of("cycle") + of("phase")) / frequency;
        assert!((time - of("time")).abs() < 1e-12);
        let (z, sign) = state(time);
        let held = force * (frequency * time).sin() - stiffness * z[0];
        let against = if sign == 0 { held } else { f64::from(sign) * friction };
        for (name, unit, due, room) in [
            ("displacement", 1.0, z[0], 1e-9),
            ("x", length, z[0], 1e-9),
            ("velocity", 1.0, z[1], 1e-8),
            ("v", velocity, z[1], 1e-8),
            ("friction_force", 1.0, against, 1e-8),
            ("friction", friction, against, 1e-8),
            ("r", friction, against + stiffness * z[0], 1e-7),
            ("acceleration", 1.0, (held - against) / mass, 1e-7),
        ] {
            compared(&format!("simulate --samples {name}"), of(name) * unit, due, DenseSamples, room);
        }
        // Nine samples a cycle.
        let place = number as f64 * TAU / 9.0 / frequency;
        for name in ["time", "cycle", "phase"] {
            compared(&format!("simulate --samples {name}"), time, place, ByHand, 1e-12);
        }
    }
}

/// Free vibration by `decay`: its answers and the turning points in its file.
#[test]
fn a_decay_of_the_command_is_that_of_the_samples() {
    let folder = tempfile::tempdir().unwrap();
    let turns = folder.path().join("turns.csv");
    let options = "--mass 2kg --stiffness 50N/m --friction 3N --damping-ratio 3% --x0 700mm";
    let answer = json(&format!("decay {options} --out {} --format json", turns.display()));
    let damping = 2.0 * 0.03 * 10.0;
    let machine = Machine::new([2.0, 50.0, damping], [3.0, 0.0, 1.0], 0.0);
    let found = record(machine, Load::Force, &[0.0, 0.1], &[0.0, 0.0], [0.7, 0.0], 256.0);
    let physical = &answer["physical"];
    agreed("decay half_cycles", answer["half_cycles"].as_u64(), Some(found.found.ends), DenseSamples);
    let last = found.found.stops[found.found.stops.len() - 1];
    let path = found.found.path[0] + found.found.path[1];
    for (name, due, unit, room) in [
        ("rest_position", found.last, 0.06, 1e-9),
        ("rest_time", last[0], 0.2, 1e-7),
        ("first_turn", 0.7, 0.06, 1e-9),
        ("path", path, 0.06, 1e-9),
    ] {
        let output = format!("decay {name}");
        compared(&output, physical[name].as_f64().unwrap(), due, DenseSamples, room);
        compared(&output, answer[name].as_f64().unwrap(), due / unit, DenseSamples, room / unit);
    }
    let text = std::fs::read_to_string(&turns).unwrap();
    let rows: Vec<Vec<f64>> = csv::Reader::from_reader(text.as_bytes())
        .records()
        .map(|row| row.unwrap().iter().map(|cell| cell.parse().unwrap()).collect())
        .collect();
    assert_eq!(rows.len(), found.found.stops.len() + 1);
    for (i, row) in rows.iter().enumerate().skip(1) {
        let [t, x] = found.found.stops[i - 1];
        compared("decay turn", row[0], i as f64, DenseSamples, 0.0);
        compared("decay time", row[1], t, DenseSamples, 1e-7);
        compared("decay displacement", row[2], x, DenseSamples, 1e-9);
    }
}

/// `pull` beside a long motion of the samples under a support that moves at the speed.
#[test]
fn a_pull_of_the_command_is_that_of_the_samples() {
    let machine = Machine::new([2.0, 450.0, 0.6], [3.0, 0.0, 4.0 / 3.0], 0.0);
    let answer = json(
        "pull --mass 2kg --stiffness 450N/m --damping 0.6N*s/m --friction 3N --static-friction 4N --speed 20mm/s \
         --units N,mm --format json",
    );
    let of = |name: &str| answer[name].as_f64().unwrap();
    let period = of("period");
    // The first slip begins where the spring overcomes static friction; the record ends after the second one.
    let first = 4.0 / 450.0 / 0.02;
    let end = first + 1.9 * period;
    let found = record(machine, Load::Foot, &[0.0, end], &[0.0, 0.02 * end], [0.0, 0.0], 512.0);
    let stops = &found.found.stops;
    let slip = stops[0][0] - first;
    let turn = stops[1][0] - stops[0][0];
    near("pull period", period, turn, DenseSamples, 1e-8);
    compared("pull slip_time", of("slip_time"), slip, DenseSamples, 1e-8 * period);
    compared("pull stick_time", of("stick_time"), turn - slip, DenseSamples, 2e-8 * period);
    near("pull slip_distance", of("slip_distance"), stops[0][1] * 1e3, DenseSamples, 1e-8);
    let fastest = found.found.most(Of::Velocity).value * 1e3;
    near("pull max_velocity", of("max_velocity"), fastest, DenseSamples, 1e-9);
    for (by, is_smooth) in [(0.99, false), (1.01, true)] {
        let speed = by * of("smooth_above");
        let line = format!(
            "pull --mass 2kg --stiffness 450N/m --damping 0.6N*s/m --friction 3N --static-friction 4N --speed {speed}mm/s --format json"
        );
        assert_eq!(json(&line)["period"].is_null(), is_smooth, "{line}");
        let end = 2.0;
        let samples = [0.0, 1e-3 * speed * end];
        let found = record(machine, Load::Foot, &[0.0, end], &samples, [0.0, 0.0], 256.0);
        // Before the end it has stopped, or it still slides.
        let has_stopped = found.found.stops.first().is_some_and(|[time, _]| *time < end);
        agreed("pull smooth_above", !is_smooth, has_stopped, DenseSamples);
    }
}

/// The stops and the margin of a map at its points.
#[test]
fn a_map_of_stops_is_that_of_the_samples() {
    let folder = tempfile::tempdir().unwrap();
    for what in ["stops", "margin"] {
        let out = folder.path().join(format!("{what}.csv")).display().to_string();
        stickslip(&format!("map {what} --omega 0.3:1.7:6 --alpha 1.5:8:6 --out {out}")).assert().success();
        let text = std::fs::read_to_string(&out).unwrap();
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        let header = reader.headers().unwrap().clone();
        let place =
            |name: &str| header.iter().position(|other| other.split('[').next() == Some(name)).unwrap();
        let (omega, alpha, value) = (place("omega"), place("alpha"), place(what));
        let mut rows_compared = 0;
        for row in reader.records().map(Result::unwrap) {
            let of = |i: usize| row[i].parse::<f64>();
            let at = [of(omega).unwrap(), of(alpha).unwrap(), 0.0, 1.0];
            let (Limit::Periodic(cycle), Ok(value)) = (ratios(at).limit([0.0, 0.0], 0.0, 600), of(value))
            else {
                continue;
            };
            rows_compared += 1;
            if what == "stops" {
                compared("map stops", value, cycle.found.rests as f64, DenseSamples, 0.0);
            } else {
                agreed("map margin", value >= 1.0, cycle.found.rests == 0, DenseSamples);
            }
        }
        assert!(rows_compared > 20, "{what}: {rows_compared}");
    }
}
