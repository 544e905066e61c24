//! What is identified from curves, decays and motions of the samples.

use super::file;
use crate::command_line::{json, refused, stdout};
use crate::compared::Origin::{ByHand, DenseSamples};
use crate::compared::{agreed, compared, near};
use crate::random::Random;
use crate::sampled::{Cycle, Harmonic, Limit, Load, Machine, Of, positions, record};
use serde_json::{Value, json};
use std::f64::consts::TAU;

/// A response curve of the samples of 5 kg on 2 kN/m with 40 N and ζ = 3 % under 100 N, with relative noise.
pub(super) fn curve_of_samples(random: &mut Random, noise: f64) -> String {
    curve_of(random, noise, |_, cycle| cycle.found.most(Of::Displacement).value)
}

/// The motion of the samples at a frequency.
fn limit_at(frequency: f64) -> Cycle {
    let machine = Machine::new([5.0, 2000.0, 6.0], [40.0, 0.0, 1.0], 0.0);
    let harmonic = Harmonic { machine, load: Load::Force, amplitude: 100.0, frequency };
    match harmonic.limit([0.0, 0.0], 0.0, 3000) {
        Limit::Periodic(cycle) => *cycle,
        limit => panic!("{limit:?}"),
    }
}

fn stops_at(frequency: f64) -> bool {
    limit_at(frequency).found.rests > 0
}

/// The phases of the peaks of the samples with an error of 0.01 rad up and down in turn, and amplitudes with one of 1 %.
fn phases_are_identified(folder: &tempfile::TempDir) {
    let mut text = "frequency[rad/s],amplitude[mm],phase[rad]\n".to_owned();
    for i in 0..16 {
        let frequency = 20.0 * (0.5 + 0.09 * f64::from(i));
        let most = limit_at(frequency).found.most(Of::Displacement);
        let phase = (frequency * most.time).rem_euclid(TAU) + if i % 2 == 0 { 0.01 } else { -0.01 };
        let by = if i % 4 < 2 { 1.01 } else { 0.99 };
        text += &format!("{frequency},{},{phase}\n", 1e3 * by * most.value);
    }
    let name = file(folder, "phases.csv", &text);
    let answer = json(&format!("identify {name} --mass 5kg --stiffness 2kN/m --force 100N --format json"));
    let of = |name: &str| format!("identify {name}");
    agreed(&of("phase_kind"), answer["phase_kind"].as_str(), Some("peak"), ByHand);
    agreed(&of("better_phase"), &answer["better_phase"], &Value::Null, ByHand);
    compared(&of("phase_noise"), answer["phase_noise"].as_f64().unwrap(), 0.01, DenseSamples, 2e-3);
    for (i, residual) in answer["phase_residuals"].as_array().unwrap().iter().enumerate() {
        let due = if i % 2 == 0 { 0.01 } else { -0.01 };
        compared(&of("phase_residuals"), residual.as_f64().unwrap(), due, DenseSamples, 2e-3);
    }
}

/// The same with another amplitude of the motion.
fn curve_of(random: &mut Random, noise: f64, amplitude: impl Fn(&Harmonic, &Cycle) -> f64) -> String {
    let mut text = "frequency[rad/s],amplitude[mm]\n".to_owned();
    for i in 0..16 {
        let frequency = 20.0 * (0.5 + 0.09 * f64::from(i));
        let damping = 2.0 * 0.03 * 100.0;
        let machine = Machine::new([5.0, 2000.0, damping], [40.0, 0.0, 1.0], 0.0);
        let harmonic = Harmonic { machine, load: Load::Force, amplitude: 100.0, frequency };
        let Limit::Periodic(cycle) = harmonic.limit([0.0, 0.0], 0.0, 3000) else { continue };
        let by = 1.0 + noise * (random.next() + random.next() - 1.0) * 6f64.sqrt();
        text += &format!("{frequency},{}\n", 1e3 * by * amplitude(&harmonic, &cycle));
    }
    text
}

/// `identify` of a curve of the samples, with a wrong value among them.
#[test]
fn a_curve_of_the_samples_is_identified() {
    let folder = tempfile::tempdir().unwrap();
    let options = "--mass 5kg --stiffness 2kN/m --force 100N --format json";
    let exact = file(&folder, "exact.csv", &curve_of_samples(&mut Random(73), 0.0));
    let answer = json(&format!("identify {exact} {options}"));
    let value = |name: &str| answer[name]["value"].as_f64().unwrap();
    let of = |name: &str| format!("identify {name}");
    for (name, due, part) in [
        ("friction", 40.0, 1e-4),
        ("damping_ratio", 0.03, 1e-3),
        ("damping", 6.0, 1e-3),
        ("friction_coefficient", 40.0 / 5.0 / 9.80665, 1e-4),
    ] {
        near(&of(name), value(name), due, DenseSamples, part);
    }
    compared(&of("noise"), answer["noise"].as_f64().unwrap(), 0.0, DenseSamples, 1e-4);
    for name in ["measurements", "used"] {
        agreed(&of(name), answer[name].as_u64(), Some(16), ByHand);
    }
    for (name, due) in [
        ("amplitude_kind", json!("peak")),
        ("search_is_complete", json!(true)),
        ("suspects", json!([])),
        ("better_reading", Value::Null),
        ("ignored_columns", json!([])),
    ] {
        agreed(&of(name), &answer[name], &due, ByHand);
    }
    // Of the samples of each frequency: whether they stop.
    let stops: Vec<bool> = (0..16).map(|i| stops_at(20.0 * (0.5 + 0.09 * f64::from(i)))).collect();
    agreed(&of("stops"), &answer["stops"], &json!(stops), DenseSamples);
    // With phases of the samples, by another reading of which the fit is worse.
    phases_are_identified(&folder);
    // A wrong value is named, and moves nothing.
    let noisy = curve_of_samples(&mut Random(74), 0.01);
    let mut lines: Vec<String> = noisy.lines().map(str::to_owned).collect();
    let (frequency, amplitude) = lines[8].split_once(',').unwrap();
    lines[8] = format!("{frequency},{}", 1.6 * amplitude.parse::<f64>().unwrap());
    let wrong = file(&folder, "wrong.csv", &lines.join("\n"));
    let answer = json(&format!("identify {wrong} {options}"));
    let interval = |name: &str| {
        let ends = answer[name]["interval_95"].as_array().unwrap();
        [ends[0].as_f64().unwrap(), ends[1].as_f64().unwrap()]
    };
    for (name, truth) in [("friction", 40.0), ("damping_ratio", 0.03), ("damping", 6.0)] {
        let [low, high] = interval(name);
        let room = 0.5 * (high - low);
        compared(&of(name), 0.5 * (low + high), truth, DenseSamples, high - low);
        assert!(low - room < truth && truth < high + room, "{name} {truth}: {answer}");
    }
    agreed(&of("used"), answer["used"].as_u64(), Some(15), DenseSamples);
    let output = "identify suspects by design::Residual::is_suspect";
    agreed(output, answer["suspects"].as_array().unwrap().len(), 1, DenseSamples);
    agreed(&of("residuals"), answer["residuals"].as_array().unwrap().len(), 16, ByHand);
    assert_eq!(answer["search_is_complete"], true, "{answer}");
    compared(&of("residuals"), answer["residuals"][7].as_f64().unwrap(), 0.6 / 1.6, DenseSamples, 0.02);
    assert!((0.004..0.025).contains(&answer["noise"].as_f64().unwrap()), "{answer}");
}

/// A curve in peak-to-peak or r.m.s. values that is read as peaks: the other reading is named, with its noise, which is that of the
/// values when they are read so.
#[test]
fn a_better_reading_is_the_one_in_which_the_samples_were_written() {
    let folder = tempfile::tempdir().unwrap();
    let options = "--mass 5kg --stiffness 2kN/m --force 100N --format json";
    // The integral of the square over a cycle after 300, by trapezes of the samples.
    let root_mean_square = |harmonic: &Harmonic, _: &Cycle| {
        let mut follower = harmonic.follower([0.0, 0.0], 0.0);
        for _ in 0..300 * harmonic.steps() {
            follower.advance(&mut None);
        }
        let (mut sum, mut before) = (0.0, [follower.time, follower.state[0]]);
        let begin = before[0];
        for _ in 0..harmonic.steps() {
            follower.advance(&mut None);
            let now = [follower.time, follower.state[0]];
            sum += 0.5 * (now[0] - before[0]) * (now[1] * now[1] + before[1] * before[1]);
            before = now;
        }
        (sum / (before[0] - begin)).sqrt()
    };
    let peak_to_peak = |_: &Harmonic, cycle: &Cycle| {
        cycle.found.most(Of::Displacement).value - cycle.found.least(Of::Displacement).value
    };
    // Another reading is tried by the factor of a harmonic motion, from which the r.m.s. of a motion with stops is some percent away.
    for (kind, text, noise) in [
        ("peak-to-peak", curve_of(&mut Random(73), 0.0, peak_to_peak), 1e-3),
        ("rms", curve_of(&mut Random(73), 0.0, root_mean_square), 0.05),
    ] {
        let name = file(&folder, &format!("{kind}.csv"), &text);
        let answer = json(&format!("identify {name} {options}"));
        let better = &answer["better_reading"];
        agreed("identify better_reading", better["amplitude"].as_str(), Some(kind), DenseSamples);
        compared("identify better_reading", better["noise"].as_f64().unwrap(), 0.0, DenseSamples, noise);
        assert!(answer["noise"].as_f64() > better["noise"].as_f64(), "{answer}");
        let read = json(&format!("identify {name} {options} --amplitude {kind}"));
        assert!(read["better_reading"].is_null(), "{read}");
        compared("identify friction", read["friction"]["value"].as_f64().unwrap(), 40.0, DenseSamples, 4e-2);
    }
}

/// `identify --decay` of turning points of the samples.
#[test]
fn a_decay_of_the_samples_is_identified() {
    let folder = tempfile::tempdir().unwrap();
    let machine = Machine::new([2.0, 50.0, 2.0 * 0.02 * 10.0], [3.0, 0.0, 1.0], 0.0);
    let found = record(machine, Load::Force, &[0.0, 0.1], &[0.0, 0.0], [1.5, 0.0], 256.0);
    let mut text = "time[s],peak[m]\n0,1.5\n".to_owned();
    for [t, x] in found.found.stops.iter().take(7) {
        text += &format!("{t},{x}\n");
    }
    let peaks = file(&folder, "peaks.csv", &text);
    let answer = json(&format!("identify --decay {peaks} --mass 2kg --stiffness 50N/m --format json"));
    let value = |name: &str| answer[name]["value"].as_f64().unwrap();
    let of = |name: &str| format!("identify --decay {name}");
    for (name, due, part) in [
        ("friction_displacement", 0.06, 1e-6),
        ("damping_ratio", 0.02, 1e-5),
        ("damping", 0.4, 1e-5),
        ("amplitude", 1.5, 1e-7),
        ("natural_frequency", 5.0 / TAU, 1e-6),
        ("friction", 3.0, 1e-6),
        ("friction_coefficient", 3.0 / 2.0 / 9.80665, 1e-6),
    ] {
        near(&of(name), value(name), due, DenseSamples, part);
    }
    agreed(&of("measurements"), answer["measurements"].as_u64(), Some(8), ByHand);
    compared(&of("noise"), answer["noise"].as_f64().unwrap(), 0.0, DenseSamples, 1e-7);
    agreed(&of("noise_unit"), answer["noise_unit"].as_str(), Some("m"), ByHand);
    for residual in answer["residuals"].as_array().unwrap() {
        compared(&of("residuals"), residual.as_f64().unwrap(), 0.0, DenseSamples, 1e-6);
    }
    for (turn, [_, x]) in answer["turning_points"].as_array().unwrap().iter().skip(1).zip(&found.found.stops)
    {
        compared(&of("turning_points"), turn[1].as_f64().unwrap(), *x, DenseSamples, 1e-9);
    }
    // Peaks of both sides with signs; they end before the rest, which alone shows static friction.
    agreed(&of("read_as"), answer["read_as"].as_str(), Some("every-half-cycle"), DenseSamples);
    agreed(&of("ignored_columns"), &answer["ignored_columns"], &json!([]), ByHand);
    assert!(answer["half_cycles"].is_null() && answer["static_friction_displacement"].is_null(), "{answer}");
    // Peaks up to the rest and beyond: static friction holds the last one, and did not hold the one before. It is at least the kinetic one.
    let stops: Vec<f64> = found.found.stops.iter().map(|[_, x]| *x).collect();
    let [.., before, last] = stops[..] else { panic!("{stops:?}") };
    let text =
        stops.iter().chain(&[last; 2]).fold("peak[m]\n1.5\n".to_owned(), |text, x| text + &format!("{x}\n"));
    let to_rest = file(&folder, "to-rest.csv", &text);
    let answer = json(&format!("identify --decay {to_rest} --mass 2kg --stiffness 50N/m --format json"));
    agreed(&of("half_cycles"), answer["half_cycles"].as_u64(), Some(stops.len() as u64), DenseSamples);
    for (bound, due) in answer["static_friction_displacement"]
        .as_array()
        .unwrap()
        .iter()
        .zip([last.abs().max(0.06), before.abs()])
    {
        compared(&of("static_friction_displacement"), bound.as_f64().unwrap(), due, DenseSamples, 1e-6);
    }
}

/// A load of two sines on a body of 2 kg, 50 N/m, 3 N and ζ = 2 %, and the displacements of the samples, from another zero.
pub(super) fn load_and_motion() -> String {
    let machine = Machine::new([2.0, 50.0, 2.0 * 0.02 * 10.0], [3.0, 0.0, 1.0], 0.0);
    let times: Vec<f64> = (0..250).map(|i| f64::from(i) * 0.03).collect();
    let load: Vec<f64> = times.iter().map(|t| 6.0 * (4.0 * t).sin() + 4.0 * (6.5 * t).sin()).collect();
    let found = positions(machine, Load::Force, [&times, &load], [0.0, 0.4], 128.0);
    let rows = times.iter().zip(&load).zip(&found);
    rows.fold("time[s],force[N],displacement[mm],temperature\n".to_owned(), |text, ((t, p), x)| {
        text + &format!("{t},{p},{},20\n", 1e3 * x + 7.0)
    })
}

/// `identify --motion` of a motion of the samples.
#[test]
fn a_motion_of_the_samples_is_identified() {
    let folder = tempfile::tempdir().unwrap();
    let motion = file(&folder, "motion.csv", &load_and_motion());
    let known = format!("identify --motion {motion} --mass 2kg --stiffness 50N/m");
    let free = format!("identify --motion {motion} --mass 2kg");
    for line in [&known, &free] {
        identified(line, line == &free);
    }
    let bare = file(&folder, "bare.csv", "time[s],displacement[mm]\n0,1\n");
    for (line, said) in [
        (format!("identify --motion {motion} --stiffness 50N/m"), "--mass is missing"),
        (format!("{known} --force 3N"), "--force 3N: identify does not use it"),
        (
            format!("identify --motion {bare} --mass 2kg --stiffness 50N/m"),
            "one of the columns force, acceleration and",
        ),
    ] {
        refused(&line, &[said]);
    }
}

/// The answers to a load and the motion of the samples, with the stiffness known or fitted.
fn identified(line: &str, is_fitted: bool) {
    let answer = json(&format!("{line} --format json"));
    let value = |name: &str| answer[name]["value"].as_f64().unwrap();
    let of = |name: &str| format!("identify --motion {name}");
    let of_spring = [("stiffness", 50.0), ("natural_frequency", 5.0 / TAU)];
    for (name, due) in of_spring.into_iter().filter(|_| is_fitted).chain([
        ("friction", 3.0),
        ("friction_coefficient", 3.0 / 2.0 / 9.80665),
        ("friction_displacement", 0.06),
        ("damping_ratio", 0.02),
        ("damping", 0.4),
        ("offset", 0.007),
        ("start_displacement", 0.007),
        ("start_velocity", 0.4),
    ]) {
        near(&of(name), value(name), due, DenseSamples, 1e-6);
        let interval = &answer[name]["interval_95"];
        assert!(
            interval[0].as_f64() <= Some(due * (1.0 + 1e-6))
                && interval[1].as_f64() >= Some(due * (1.0 - 1e-6))
        );
    }
    agreed(&of("measurements"), answer["measurements"].as_u64(), Some(250), ByHand);
    agreed(&of("load"), answer["load"].as_str(), Some("force"), ByHand);
    assert_eq!(answer["residuals"].as_array().map(Vec::len), Some(250));
    for residual in answer["residuals"].as_array().unwrap() {
        compared(&of("residuals"), residual.as_f64().unwrap(), 0.0, DenseSamples, 1e-7);
    }
    compared(&of("noise"), answer["noise"].as_f64().unwrap(), 0.0, DenseSamples, 1e-8);
    agreed(&of("noise_unit"), answer["noise_unit"].as_str(), Some("m"), ByHand);
    agreed(&of("ignored_columns"), &answer["ignored_columns"], &json!(["temperature"]), ByHand);
    assert_eq!(answer["stiffness"].is_null(), !is_fitted, "{answer}");
    let text = stdout(line);
    assert_eq!(text.contains("stiffness k         50 N/m"), is_fitted, "{text}");
    assert!(
        text.contains("friction force r_y  3 N") && text.contains("offset              0.007 m"),
        "{text}"
    );
}
