//! Answers under records beside the samples of the motion.

use super::file;
use super::units::si;
use crate::command_line::{json, stdout};
use crate::compared::Origin::{ByHand, DenseSamples};
use crate::compared::{agreed, compared};
use crate::random::Random;
use crate::sampled::{Load, Machine, Of, record};
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// A body under loads of every kind through `record` and `spectrum`.
#[test]
fn answers_under_a_record_are_those_of_the_samples() {
    let folder = tempfile::tempdir().unwrap();
    let mut random = Random(72);
    for (column, load, size) in [
        ("force[N]", Load::Force, 30.0),
        ("acceleration[m/s^2]", Load::Surface, 6.0),
        ("foot-displacement[mm]", Load::Foot, 100.0),
        ("damped-foot-displacement[mm]", Load::DampedFoot, 100.0),
    ] {
        for i in 0..3 {
            let times: Vec<f64> = (0..14).map(|i| f64::from(i) * 0.08).collect();
            let samples: Vec<f64> = times.iter().map(|_| size * random.between(-1.0, 1.0)).collect();
            let mut text = format!("time[s],{column}\n");
            for (t, x) in times.iter().zip(&samples) {
                text += &format!("{t},{x}\n");
            }
            let file = file(&folder, &format!("{load:?}{i}.csv"), &text);
            let (mass, stiffness, friction) = (5.0, 200.0, 4.0);
            let damping = 6.0;
            let si_samples: Vec<f64> =
                if load.is_foot() { samples.iter().map(|x| x * 1e-3).collect() } else { samples };
            let machine = Machine::new([mass, stiffness, damping], [friction, 0.0, 1.0], 0.0);
            let found = record(machine, load, &times, &si_samples, [0.0, 0.0], 128.0);
            let body = format!(
                "{file} --mass {mass}kg --stiffness {stiffness}N/m --damping {damping}N*s/m --friction {friction}N"
            );
            let answer = json(&format!("record {body} --units kN,mm --format json"));
            let period = TAU * (mass / stiffness).sqrt();
            let rows = stdout(&format!(
                "spectrum --quiet {file} --period {period}s --mass {mass}kg --friction {friction}N --damping {damping}N*s/m"
            ));
            let mut reader = csv::Reader::from_reader(rows.as_bytes());
            let header = reader.headers().unwrap().clone();
            let row = reader.records().next().unwrap().unwrap();
            let of_spectrum: BTreeMap<&str, (f64, &str)> = header
                .iter()
                .zip(row.iter())
                .filter_map(|(name, value)| {
                    let (name, unit) = name.strip_suffix(']').and_then(|name| name.split_once('['))?;
                    Some((name, (value.parse().unwrap_or(f64::NAN), unit)))
                })
                .collect();
            for (name, due) in [("mass", mass), ("period", period), ("friction", friction)] {
                let (value, unit) = of_spectrum[name];
                compared(&format!("spectrum {name}"), value * si(unit), due, ByHand, 1e-15 * due);
            }
            agreed("spectrum record", file.ends_with(&row[0]), true, ByHand);
            let path = found.found.path[0] + found.found.path[1];
            let span = 1.04;
            let work = friction * path + found.found.damper_work;
            let x = found.found.greatest(Of::Displacement).value;
            let v = found.found.greatest(Of::Velocity).value;
            let a = found.found.greatest(Of::AbsoluteAcceleration).value;
            let force = found.found.greatest(Of::Transmitted).value;
            let most = |of: Of| found.found.most(of);
            let least = |of: Of| found.found.least(of);
            let [amplitude, secant, ratio] = found.greatest_cycle(&machine, [0.0, 0.0]).unwrap();
            for (name, expected, room) in [
                ("max_displacement", most(Of::Displacement).value, x),
                ("max_displacement_time", most(Of::Displacement).time, 1e3 * span),
                ("min_displacement", least(Of::Displacement).value, x),
                ("min_displacement_time", least(Of::Displacement).time, 1e3 * span),
                ("max_velocity", most(Of::Velocity).value, v),
                ("max_velocity_time", most(Of::Velocity).time, 1e3 * span),
                ("min_velocity", least(Of::Velocity).value, v),
                ("min_velocity_time", least(Of::Velocity).time, 1e3 * span),
                ("max_absolute_acceleration", a, a),
                ("max_transmitted_force", force, force),
                ("end_displacement", found.end[0], x),
                ("end_velocity", found.end[1], v),
                ("residual_displacement", found.last, x),
                ("peak_displacement", x, x),
                ("cycle_amplitude", amplitude, amplitude),
                ("equivalent_stiffness", secant, secant),
                ("equivalent_damping_ratio", ratio, ratio),
                ("path", path, path),
                ("slides", found.counts[0] as f64, 0.0),
                ("stops", found.counts[1] as f64, 0.0),
                ("reversals", found.counts[2] as f64, 0.0),
                ("stick_time", found.rest, span),
                ("friction_work", friction * path, work),
                ("damper_work", found.found.damper_work, work),
                ("load_work", found.found.load_work, work),
            ] {
                let unit = answer["units"][name].as_str().unwrap_or("1");
                let value = answer[name].as_f64().unwrap_or_else(|| panic!("{name} of {body}")) * si(unit);
                compared(&format!("record {name}"), value, expected, DenseSamples, 1e-9 * room);
                let (value, unit) = of_spectrum[name];
                let value = value * si(&unit.replace("*", "·").replace("^2", "²"));
                let output = format!("spectrum {name} by motion::record::follow_each");
                compared(&output, value, expected, DenseSamples, 1e-8 * room);
            }
        }
    }
}

/// Without friction and damper a motion after a record is cut after one more period.
#[test]
fn a_motion_without_an_end_is_cut_after_a_period() {
    let folder = tempfile::tempdir().unwrap();
    let file = file(&folder, "pulse.csv", "time[s],force[N]\n0,0\n0.1,12\n0.3,12\n0.4,0\n");
    let answer = json(&format!("record {file} --mass 5kg --stiffness 200N/m --friction 0N --format json"));
    let due = 0.4 + TAU * (5.0_f64 / 200.0).sqrt();
    compared("record cut_time", answer["cut_time"].as_f64().unwrap(), due, ByHand, 1e-14);
    let rows = stdout(&format!("spectrum --quiet {file} --period 1s --mass 5kg --friction 0N"));
    let mut reader = csv::Reader::from_reader(rows.as_bytes());
    let place = reader.headers().unwrap().iter().position(|name| name.starts_with("cut_time")).unwrap();
    let row = reader.records().next().unwrap().unwrap();
    compared("spectrum cut_time", row[place].parse().unwrap(), 1.4, ByHand, 1e-14);
}

/// The rows of `record --out` at the samples of a record, with those at events between them; and the periods of `--floor-spectrum`.
#[test]
fn rows_of_a_record_are_those_of_the_samples() {
    let folder = tempfile::tempdir().unwrap();
    let mut random = Random(77);
    let times: Vec<f64> = (0..14).map(|i| f64::from(i) * 0.08).collect();
    let samples: Vec<f64> = times.iter().map(|_| 6.0 * random.between(-1.0, 1.0)).collect();
    let rows = times.iter().zip(&samples).map(|(t, x)| format!("{t},{x}\n"));
    let text = format!("time[s],acceleration[m/s^2]\n{}", rows.collect::<String>());
    let (file, out) = (file(&folder, "quake.csv", &text), folder.path().join("motion.csv"));
    let (mass, stiffness, damping, friction) = (5.0, 200.0, 6.0, 4.0);
    let line = format!("record {file} --mass 5kg --stiffness 200N/m --damping 6N*s/m --friction 4N");
    stdout(&format!("{line} --out {}", out.display()));
    let text = std::fs::read_to_string(&out).unwrap();
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let names: Vec<String> =
        reader.headers().unwrap().iter().map(|name| name.split('[').next().unwrap().to_owned()).collect();
    let rows: Vec<BTreeMap<String, f64>> = reader
        .records()
        .map(|row| names.iter().cloned().zip(row.unwrap().iter().map(|cell| cell.parse().unwrap())).collect())
        .collect();
    let of = |name: &str| format!("record --out {name}");
    let machine = Machine::new([mass, stiffness, damping], [friction, 0.0, 1.0], 0.0);
    for (place, time) in times.iter().enumerate() {
        let row = rows.iter().find(|row| (row["time"] - time).abs() < 1e-12);
        compared(&of("time"), row.map_or(f64::NAN, |row| row["time"]), *time, ByHand, 1e-12);
        let row = row.unwrap();
        if place < 2 || place + 1 == times.len() {
            continue;
        }
        let end = record(machine, Load::Surface, &times[..=place], &samples[..=place], [0.0, 0.0], 128.0).end;
        compared(&of("displacement"), row["displacement"], end[0], DenseSamples, 1e-11);
        compared(&of("velocity"), row["velocity"], end[1], DenseSamples, 1e-10);
        let direction = if end[1].abs() < 1e-9 { 0.0 } else { end[1].signum() };
        compared(&of("direction"), row["direction"], direction, DenseSamples, 0.0);
        let load = -mass * samples[place];
        let held = load - stiffness * end[0] - damping * end[1];
        let against = if direction == 0.0 { held } else { direction * friction };
        let acceleration = (held - against) / mass;
        for (name, due) in [
            ("load", load),
            ("friction", -against),
            ("acceleration", acceleration),
            ("absolute_acceleration", acceleration + samples[place]),
            ("transmitted_force", stiffness * end[0] + damping * end[1] + against),
        ] {
            compared(&of(name), row[name], due, ByHand, 1e-9);
        }
    }
    let answer = json(&format!("{line} --floor-spectrum 0.1s,0.3s --format json"));
    let rows = answer["floor_spectrum"]["rows"].as_array().unwrap();
    let of = |name: &str| format!("record --floor-spectrum {name}");
    agreed(&of("floor_spectrum"), rows.len(), 2, ByHand);
    for (row, due) in rows.iter().zip([0.1, 0.3]) {
        compared(&of("period"), row["period"].as_f64().unwrap(), due, ByHand, 0.0);
    }
}

/// `record --both-polarities` under a constant force, which distinguishes the two: the peaks of the samples of each, and the greater.
#[test]
fn both_polarities_are_those_of_the_samples() {
    let folder = tempfile::tempdir().unwrap();
    let mut random = Random(76);
    let mut mirrored = 0;
    for i in 0..6 {
        let times: Vec<f64> = (0..14).map(|i| f64::from(i) * 0.08).collect();
        let samples: Vec<f64> = times.iter().map(|_| 30.0 * random.between(-1.0, 1.0)).collect();
        let rows = times.iter().zip(&samples).map(|(t, x)| format!("{t},{x}\n"));
        let text = format!("time[s],force[N]\n{}", rows.collect::<String>());
        let file = file(&folder, &format!("{i}.csv"), &text);
        let answer = json(&format!(
            "record {file} --mass 5kg --stiffness 200N/m --damping 6N*s/m --friction 4N --mean-force 2N --both-polarities --format json"
        ));
        let machine = Machine::new([5.0, 200.0, 6.0], [4.0, 0.0, 1.0], 2.0);
        let [one, other] = [1.0, -1.0].map(|sign| {
            let samples: Vec<f64> = samples.iter().map(|x| sign * x).collect();
            let found = record(machine, Load::Force, &times, &samples, [0.0, 0.0], 128.0);
            found.found.greatest(Of::Displacement).value
        });
        for (name, due) in [("recorded", one), ("mirrored", other)] {
            let peak = answer["polarities"][name]["peak_displacement"].as_f64().unwrap();
            compared("record --both-polarities polarities", peak, due, DenseSamples, 1e-9 * due);
        }
        let due = if other > one { "mirrored" } else { "recorded" };
        agreed("record --both-polarities polarity", answer["polarity"].as_str(), Some(due), DenseSamples);
        mirrored += u32::from(other > one);
    }
    assert!((1..6).contains(&mirrored), "{mirrored}");
}
