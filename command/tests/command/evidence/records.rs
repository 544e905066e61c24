//! Answers under records beside the samples of the motion.

use super::file;
use super::units::si;
use crate::command_line::{json, stdout};
use crate::compared::Origin::DenseSamples;
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
                compared(&format!("spectrum {name}"), value, expected, DenseSamples, 1e-8 * room);
            }
        }
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
