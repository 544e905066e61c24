//! Every output of every command: it has its row in docs/development/evidence.md, and a number of another origin beside it.

use crate::command_line::{json, refused, stdout, stickslip};
use crate::machines::{DRIVES, Driven};
use crate::random::Random;
use crate::sampled::{Cycle, Harmonic, Limit, Load, Machine, Of, positions, record};
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::{PI, TAU};
use stickslip::Excitation;

const PAGE: &str = include_str!("../../../docs/development/evidence.md");

/// The names in the rows of a command, and those of its kinds such as `simulate --samples`.
fn rows() -> BTreeMap<&'static str, BTreeSet<&'static str>> {
    let mut all: BTreeMap<_, BTreeSet<_>> = BTreeMap::new();
    for line in PAGE.lines().filter_map(|line| line.strip_prefix("| `")) {
        let cells: Vec<&str> = line.split(" | ").collect();
        let of = cells[0].split('`').next().unwrap();
        all.entry(of).or_default().extend(cells[1].split('`').skip(1).step_by(2));
    }
    all
}

/// The names of an answer: the keys of an object, or those of a header without units.
fn keys(text: &str) -> BTreeSet<String> {
    let Ok(value) = serde_json::from_str::<Value>(text) else {
        let header = text.lines().next().unwrap();
        return header.split(',').map(|name| name.split('[').next().unwrap().to_owned()).collect();
    };
    let object = if value.is_array() { &value[0] } else { &value };
    object.as_object().unwrap().keys().cloned().collect()
}

/// A file of the test with this text.
fn file(folder: &tempfile::TempDir, name: &str, text: &str) -> String {
    let path = folder.path().join(name);
    std::fs::write(&path, text).unwrap();
    path.display().to_string()
}

/// The inputs that an answer repeats before its outputs, and what says in which units they are.
const INPUTS: [&str; 7] =
    ["omega", "alpha", "damping_ratio", "static_friction_ratio", "physical", "units", "record"];

/// Each command by its examples: together they have the outputs of its rows, no more and no fewer.
#[test]
fn every_output_of_every_command_has_its_row() {
    let folder = tempfile::tempdir().unwrap();
    let load = file(&folder, "load.csv", "time[s],force[kN]\n0,0\n0.1,12\n0.3,12\n0.4,0\n");
    let curve = file(&folder, "curve.csv", &curve_of_samples(&mut Random(1), 0.0));
    let peaks = file(&folder, "peaks.csv", "peak[mm]\n40\n33.1\n26.5\n20.2\n14.1\n");
    let motion = file(&folder, "motion.csv", &load_and_motion());
    let turns = folder.path().join("turns.csv").display().to_string();
    let system = file(&folder, "system.toml", crate::systems::MACHINE);
    let shaken = file(&folder, "shaken.toml", &crate::systems::shaken());
    let machine =
        "--mass 800kg --period 2.2s --friction-coefficient 0.05 --damping-ratio 2% --static-ratio 1.2";
    let quake = "--frequency 2Hz --base-acceleration 0.15g --format json";
    let ratios = "--omega 0.6 --alpha 3 --static-ratio 1.5";
    let body = "--mass 50 --stiffness 1000 --friction 5";
    let examples: &[(&str, &[String])] = &[
        ("response", &[format!("response {machine} {quake}")]),
        (
            "border",
            &[
                format!("border {machine} --frequency 2Hz --format json"),
                "border --omega 0.331 --no-stop --format json".to_owned(),
            ],
        ),
        ("steady", &[format!("steady {machine} {quake}")]),
        ("attractors", &[format!("attractors {ratios} --format json")]),
        ("basins", &[format!("basins {ratios} --x0=-2:2:3 --v0=-2:2:3")]),
        ("simulate", &[format!("simulate {body} --force 12 --frequency 3 --cycles 1 --format csv")]),
        (
            "simulate --samples",
            &[format!("simulate {body} --force 12 --frequency 3 --cycles 1 --samples 3 --format csv")],
        ),
        ("decay", &["decay --x0 5.5 --format json".to_owned(), format!("decay --x0 5.5 --out {turns} --format json")]),
        ("record", &[format!("record {load} --mass 50t --stiffness 1kN/mm --friction 5kN --format json")]),
        ("spectrum", &[format!("spectrum --quiet {load} --period 1s,2s --mass 50t --friction 5kN")]),
        (
            "identify",
            &[
                format!("identify {curve} --mass 5kg --stiffness 2kN/m --force 100N --format json"),
                format!("identify {curve} --mass 5kg --force 100N --format json"),
                format!("identify {curve} --mass 5kg --stiffness 2kN/m --format json"),
            ],
        ),
        (
            "identify --motion",
            &[format!("identify --motion {motion} --mass 2kg --format json")],
        ),
        ("identify --decay", &[format!("identify --decay {peaks} --stiffness 12kN/m --format json")]),
        (
            "design force",
            &[
                format!("design force {body} --frequency 6 --static-ratio 1.2 --damping-ratio 0.1 --mean-force 3 --format json"),
                "design force --omega 0.4 --static-ratio 1.2 --damping-ratio 0.1 --format json".to_owned(),
            ],
        ),
        (
            "design friction",
            &[
                "design friction --mass 50 --stiffness 1000 --frequency 6 --force 12 --static-ratio 1.2 --damping-ratio 0.1 --format json".to_owned(),
                "design friction --omega 0.4 --static-ratio 1.2 --damping-ratio 0.1 --format json".to_owned(),
            ],
        ),
        (
            "design friction --over",
            &["design friction --mass 800kg --period 2.2s --base-displacement 50mm --over 0.2Hz:2Hz --of absolute-displacement --format json".to_owned()],
        ),
        (
            "design friction --target-amplitude",
            &["design friction --mass 50kg --stiffness 1000N/m --frequency 6rad/s --force 12N --target-amplitude 10mm --format json".to_owned()],
        ),
        ("system", &[format!("system {system} --format json")]),
        ("system steady", &[format!("system {system} steady --format json"), format!("system {shaken} steady --format json")]),
        (
            "system simulate",
            &[
                format!("system {system} simulate --until 2s --format json"),
                format!("system {shaken} simulate --until 2s --format json"),
            ],
        ),
        ("system border", &[format!("system {system} border --format json")]),
        (
            "pull",
            &["pull --mass 2kg --stiffness 450N/m --friction 3N --static-friction 4N --speed 20mm/s --format json".to_owned()],
        ),
        (
            "design hold",
            &[
                format!("design hold {body} --unbalance 1 --format json"),
                format!("design hold {body} --force 60 --format json"),
            ],
        ),
        (
            "design bands",
            &[
                "design bands --alpha 12 --damping-ratio 0.1 --from 0.1 --to 2 --format json".to_owned(),
                "design bands --alpha 80 --from 0.3 --to 0.4 --no-stop --format json".to_owned(),
                format!("design bands {body} --force 60 --from 1 --to 9 --format json"),
            ],
        ),
        (
            "design displacement, velocity",
            &[
                "design displacement --omega 1.5 --target 2 --format json".to_owned(),
                format!("design velocity {body} --frequency 6 --target 0.2 --format json"),
            ],
        ),
        (
            "design dissipation",
            &[
                "design dissipation --mass 50 --stiffness 1000 --frequency 6 --force 12 --format json".to_owned(),
                "design dissipation --omega 0.8 --format json".to_owned(),
            ],
        ),
        (
            "design dissipation --sticking",
            &[
                "design dissipation --mass 50 --stiffness 1000 --frequency 6 --force 12 --sticking --format json".to_owned(),
                "design dissipation --omega 0.3 --sticking --format json".to_owned(),
            ],
        ),
        (
            "design stiffness",
            &["design stiffness --mass 50 --friction 5 --frequency 6 --force 12 --from 500 --to 1500 --format json".to_owned()],
        ),
    ];
    let page = rows();
    for (of, runs) in examples {
        let mut found = BTreeSet::new();
        for run in *runs {
            found.extend(keys(&stdout(run)).into_iter().filter(|name| {
                // `design force --omega` repeats Ω, which is then no output either.
                !INPUTS.contains(&name.as_str()) || page[of].contains(name.as_str())
            }));
        }
        if *of == "decay" {
            found.extend(keys(&std::fs::read_to_string(&turns).unwrap()));
        }
        // The kind of the number in brackets of a header is of the same output.
        let page: BTreeSet<String> = page[of].iter().map(|name| (*name).to_owned()).collect();
        let lacks: Vec<_> = found.difference(&page).collect();
        assert!(lacks.is_empty(), "{of}: outputs without a row in docs/development/evidence.md: {lacks:?}");
        let beyond: Vec<_> = page.difference(&found).collect();
        assert!(
            beyond.is_empty(),
            "{of}: docs/development/evidence.md has outputs that no example has: {beyond:?}"
        );
    }
    let limits = json(&format!("attractors {ratios} --format json"));
    let found: BTreeSet<_> = keys(&limits["attractors"].to_string());
    assert_eq!(found, page["attractors[]"].iter().map(|name| (*name).to_owned()).collect());
    let frictions = json(
        "design friction --mass 50kg --stiffness 1000N/m --frequency 6rad/s --force 12N --target-amplitude 10mm --format json",
    );
    let mut found: BTreeSet<_> = keys(&frictions["solutions"].to_string());
    found.remove("units");
    let names = &page["design friction --target-amplitude[]"];
    assert_eq!(found, names.iter().map(|name| (*name).to_owned()).collect());
    let block = format!("record {load} --mass 50t --stiffness 1kN/mm --friction 5kN");
    let floors = json(&format!("{block} --floor-spectrum 0.1s --both-polarities --format json"));
    let mut found: BTreeSet<_> = keys(&floors["floor_spectrum"]["rows"].to_string());
    found.insert("floor_spectrum".to_owned());
    assert!(floors["polarity"].is_string() && floors["polarities"].is_object());
    let names = |of: &str| page[of].iter().map(|name| (*name).to_owned()).collect::<BTreeSet<_>>();
    assert_eq!(found, names("record --floor-spectrum"));
    let history = folder.path().join("history.csv").display().to_string();
    stdout(&format!("{block} --out {history}"));
    assert_eq!(keys(&std::fs::read_to_string(&history).unwrap()), names("record --out"));
    // Every command has its rows, or gives pictures, texts and the outputs of others.
    let help = stdout("help");
    let commands = help.lines().skip_while(|line| !line.starts_with("Commands:")).skip(1);
    let commands =
        commands.take_while(|line| !line.is_empty()).filter_map(|line| line.split_whitespace().next());
    let others = [
        "verify",
        "figure",
        "figures",
        "sweep",
        "motion-plot",
        "outputs",
        "options",
        "completions",
        "man",
        "help",
    ];
    for command in commands {
        let is_there = page.keys().any(|of| of.split([' ', ',']).next() == Some(command));
        assert!(
            is_there || others.contains(&command),
            "{command} has no row in docs/development/evidence.md"
        );
    }
}

/// The options of a machine and its drive.
fn options(driven: &Driven) -> String {
    let drive = match driven.excitation {
        Excitation::Force => "force",
        Excitation::Unbalance => "unbalance",
        Excitation::FootMotion => "foot-displacement",
        Excitation::DampedFootMotion => "damped-foot-displacement",
        Excitation::SurfaceMotion => "base-displacement",
        Excitation::SurfaceVelocity => "base-velocity",
        _ => "base-acceleration",
    };
    let Driven { mass, stiffness, damping, friction, offset, eta, mean, amplitude, frequency, .. } = *driven;
    let unit = match driven.excitation {
        Excitation::Force => "N",
        Excitation::Unbalance => "kg*m",
        Excitation::SurfaceVelocity => "m/s",
        Excitation::SurfaceAcceleration => "m/s^2",
        _ => "m",
    };
    let mut text = format!(
        "--mass {mass}kg --stiffness {stiffness}N/m --damping {damping}N*s/m --friction {}N --{drive} \
         {amplitude}{unit} --frequency {frequency}rad/s",
        friction + offset
    );
    if offset != 0.0 {
        text += &format!(" --friction-backward {}N", friction - offset);
    }
    if mean != 0.0 {
        text += &format!(" --mean-force={mean}N");
    }
    if eta > 1.0 {
        text += &format!(" --static-ratio {eta}");
    }
    text
}

/// The size of a unit of an answer in SI.
fn si(unit: &str) -> f64 {
    match unit {
        "N" | "m" | "s" | "kg" | "m/s" | "m/s²" | "N·m" | "N/m" | "N·s/m" | "kg·m" | "1" | "Hz" | "rad/s" => {
            1.0
        }
        "kN" | "kN·s²" | "t" | "N·s²/mm" => 1e3,
        "mm" | "mm/s" | "mm/s²" | "N·mm" | "kg·mm" => 1e-3,
        "N/mm" | "N·s/mm" => 1e3,
        "kN·mm" | "t·mm" => 1.0,
        "kN/mm" | "kN·s/mm" | "kN·s²/mm" | "kt" => 1e6,
        "lbf" => 4.448_221_615_260_5,
        "in" | "in/s" | "in/s²" => 0.0254,
        "lbf·in" => 4.448_221_615_260_5 * 0.0254,
        "lbf/in" | "lbf·s/in" | "lbf·s²/in" => 4.448_221_615_260_5 / 0.0254,
        "lbf·s²" => 4.448_221_615_260_5,
        _ => panic!("{unit}"),
    }
}

/// The value that the samples give for an output in units, in SI, and the room for it.
fn in_units(name: &str, driven: &Driven, cycle: &Cycle, ratios: &Value) -> Option<(f64, f64)> {
    let found = &cycle.found;
    let mean = driven.harmonic().mean();
    let reach = found.most(Of::Displacement).value - found.least(Of::Displacement).value;
    let w = driven.frequency;
    let natural = (driven.stiffness / driven.mass).sqrt();
    let time = |time: f64| (driven.phase(time) / w, 1e-6 / w);
    let near = |x: f64| (x, 1e-8 * x.abs());
    let of = |of: Of, by: f64| found.most(of).value.max(by);
    let _ = of;
    let greatest =
        |of: Of, by: f64| (found.most(of).value - by).abs().max((found.least(of).value - by).abs());
    let ratio = |name: &str| ratios[name].as_f64();
    let force = driven.force();
    let base = force / driven.mass / w / w;
    let work = |x: f64| (x, 1e-8 * force * reach);
    let equivalent = {
        let (machine, range) = (driven.machine(), reach);
        let work = (found.friction_work(&machine) + found.damper_work) / f64::from(cycle.turns);
        let [forward, backward] = machine.friction;
        (4.0 * work / (PI * w * range * range), driven.stiffness + (forward + backward) / range)
    };
    Some(match name {
        "frequency" => near(w / TAU),
        "angular_frequency" => near(w),
        "natural_frequency" => near(natural),
        "period" => near(TAU / natural),
        "mass" => near(driven.mass),
        "stiffness" => near(driven.stiffness),
        "friction" => near(driven.friction + driven.offset),
        "friction_backward" => near(driven.friction - driven.offset),
        "friction_bound" => near(driven.friction),
        "damping" => near(driven.damping),
        "static_friction" => near(driven.eta * driven.friction),
        "force_amplitude" => near(force),
        "unbalance" | "foot_displacement" | "damped_foot_displacement" => near(driven.amplitude),
        "lead_time" => (driven.lead() / w, 1e-9 / w),
        "base_displacement" => near(base),
        "base_velocity" => near(base * w),
        "base_acceleration" => near(base * w * w),
        "friction_displacement" => near(driven.friction / driven.stiffness),
        "mean_force" => near(driven.mean),
        "mean_displacement" => (mean, 1e-12 * (mean.abs() + reach)),
        "max_displacement" => (found.most(Of::Displacement).value - mean, 1e-8 * reach),
        "min_displacement" => (found.least(Of::Displacement).value - mean, 1e-8 * reach),
        "displacement_time" | "max_displacement_time" => time(found.most(Of::Displacement).time),
        "min_displacement_time" => time(found.least(Of::Displacement).time),
        "max_velocity" => near(found.most(Of::Velocity).value),
        "min_velocity" => near(found.least(Of::Velocity).value),
        "velocity_time" | "max_velocity_time" => time(found.most(Of::Velocity).time),
        "min_velocity_time" => time(found.least(Of::Velocity).time),
        "deviation" => {
            let at = driven.harmonic().states(cycle, w * found.most(Of::Velocity).time);
            (at[0][0] - mean, 1e-6 * reach)
        }
        // The ratio has its own test beside the samples; the unit is the friction force.
        "min_force" => near(ratio("min_force_ratio")? * driven.friction),
        "min_force_turning_point" => near(ratio("min_force_ratio_turning_point")? * driven.friction),
        "best_force" => near(ratio("best_force_ratio")? * driven.friction),
        "best_force_energy" => {
            let best = ratio("best_force_ratio")? * driven.friction;
            near(ratio("best_loop_size")? * best * best / 2.0 / driven.stiffness)
        }
        "energy_per_cycle" | "energy_out" => work(driven.friction * (found.path[0] + found.path[1])),
        "energy_in" if driven.harmonic().load == Load::DampedFoot => work(found.foot_work),
        "energy_in" => work(found.load_work),
        "damper_energy_per_cycle" => work(found.damper_work),
        "max_acceleration" => near(greatest(Of::Acceleration, 0.0)),
        "transmitted_force" => near(greatest(Of::Transmitted, driven.mean)),
        "max_absolute_displacement" if driven.is_surface() => near(greatest(Of::AbsoluteDisplacement, mean)),
        "max_absolute_displacement" => near(greatest(Of::Displacement, mean)),
        "max_spring_force" => near(greatest(Of::Spring, driven.stiffness * mean)),
        "equivalent_damping" => near(equivalent.0),
        "equivalent_stiffness" => near(equivalent.1),
        "distance" => (0.0, 1e-8 * reach),
        "followed_for" => near(ratio("periods")? * TAU / w),
        _ => return None,
    })
}

/// Answers of machines in units under every drive: each value is that of the samples, in three systems of units.
#[test]
fn answers_in_units_are_those_of_the_samples() {
    let mut random = Random(71);
    let mut seen = BTreeSet::new();
    for excitation in DRIVES {
        let mut compared = 0;
        while compared < 6 {
            let mut driven = Driven::any(&mut random, excitation);
            if compared < 3 {
                driven.eta = 1.0;
            }
            let harmonic = driven.harmonic();
            let start = [harmonic.mean(), 0.0];
            let Limit::Periodic(cycle) = harmonic.limit(start, -driven.lead(), 400) else { continue };
            compared += 1;
            let systems = ["N,m", "kN,mm", "lbf,in"];
            for (question, units) in
                [("response", systems[compared % 3]), ("steady", systems[(compared + 1) % 3])]
            {
                let line = format!("{question} {} --units {units} --format json", options(&driven));
                let answer = json(&line);
                let physical = &answer["physical"];
                for (name, value) in physical.as_object().unwrap() {
                    let (Some(value), Some(unit)) = (value.as_f64(), physical["units"][name].as_str()) else {
                        assert!(value.is_null() || value.is_string() || value.is_object(), "{line}: {name}");
                        seen.insert(name.clone());
                        continue;
                    };
                    let Some((expected, room)) = in_units(name, &driven, &cycle, &answer) else {
                        panic!("{line}: {name} = {value} {unit} has no number beside it");
                    };
                    let value = value * si(unit);
                    assert!((value - expected).abs() <= room, "{line}: {name} {value} {expected}");
                    seen.insert(name.clone());
                }
            }
        }
    }
    let page = &rows()["physical"];
    let beyond: Vec<_> =
        seen.iter().filter(|name| !page.contains(name.as_str()) && *name != "units").collect();
    assert!(beyond.is_empty(), "values in units without a row in docs/development/evidence.md: {beyond:?}");
    let unseen: Vec<_> = page.iter().filter(|name| !seen.contains(**name)).collect();
    // A coefficient needs gravity, and a rest has no cycle.
    assert!(unseen.iter().all(|name| ["friction_coefficient", "rest_position"].contains(name)), "{unseen:?}");
    let answer = json(
        "steady --mass 2kg --stiffness 100N/m --friction-coefficient 0.3 --force 1N --frequency 3rad/s --format json",
    );
    let physical = &answer["physical"];
    assert_eq!(physical["friction_coefficient"].as_f64(), Some(0.3));
    assert!((physical["friction"].as_f64().unwrap() - 0.3 * 2.0 * 9.80665).abs() < 1e-12);
    assert_eq!(physical["rest_position"].as_f64(), Some(0.0));
}

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
                assert!((value - expected).abs() <= 1e-9 * room, "{name}: {value} {expected} of {body}");
                let (value, unit) = of_spectrum[name];
                let value = value * si(&unit.replace("*", "·").replace("^2", "²"));
                assert!(
                    (value - expected).abs() <= 1e-8 * room,
                    "spectrum, {name}: {value} {expected} of {body}"
                );
            }
        }
    }
}

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
    assert_eq!(answer["starts"].as_u64(), Some(40));
    let reach = number(&answer["reach"]);
    let harmonic = ratios(at);
    let cycle = |x: f64, v: f64| match harmonic.limit([x, v * at[0]], 0.0, 3000) {
        Limit::Periodic(cycle) => cycle,
        limit => panic!("{x} {v}: {limit:?}"),
    };
    let mut starts = 0;
    for limit in limits {
        starts += limit["starts"].as_u64().unwrap();
        assert!((number(&limit["share"]) - number(&limit["starts"]) / 40.0).abs() < 1e-12);
        let (x, v) = (number(&limit["first_x"]), number(&limit["first_v"]));
        assert!(x.abs() <= reach && v.abs() <= reach);
        let found = cycle(x, v);
        let most = found.found.most(Of::Displacement).value;
        let least = found.found.least(Of::Displacement).value;
        assert!((number(&limit["max_displacement"]) - most).abs() < 1e-8, "{limit}");
        assert!((number(&limit["min_displacement"]) - least).abs() < 1e-8, "{limit}");
        assert_eq!(limit["sticks_per_cycle"].as_u64(), Some(found.found.rests), "{limit}");
        assert_eq!(limit["velocity_zeros_per_cycle"].as_u64(), Some(found.found.ends), "{limit}");
        assert_eq!(limit["turns_per_cycle"].as_u64(), Some(found.turns.into()), "{limit}");
        assert_eq!(limit["symmetric"].as_bool(), Some(found.is_symmetric), "{limit}");
        let rest = found.found.rest * at[0] / TAU / f64::from(found.turns);
        assert!((number(&limit["stick_fraction"]) - rest).abs() < 1e-8, "{limit}");
        if let Some(mirror) = limit["mirror"].as_u64() {
            let other = &limits[mirror as usize - 1];
            assert!((number(&other["max_displacement"]) + least).abs() < 1e-8, "{limit} {other}");
        }
    }
    assert_eq!(starts, 40);
    let rows = stdout(&format!("basins {options} --x0=-6:6:7 --v0=-6:6:7"));
    let mut of_number: BTreeMap<String, [f64; 2]> = BTreeMap::new();
    let mut compared = 0;
    for row in csv::Reader::from_reader(rows.as_bytes()).records() {
        let row = row.unwrap();
        let found = cycle(row[0].parse().unwrap(), row[1].parse().unwrap());
        let now = [found.found.most(Of::Displacement).value, found.found.least(Of::Displacement).value];
        let before = of_number.entry(row[2].to_owned()).or_insert(now);
        assert!(
            (before[0] - now[0]).abs() < 1e-7 && (before[1] - now[1]).abs() < 1e-7,
            "{row:?}: {before:?} {now:?}"
        );
        compared += 1;
    }
    assert!(compared == 49 && of_number.len() > 1, "{compared} {of_number:?}");
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
        let (z, _) = state(start);
        assert!(
            (of("start_displacement") - z[0]).abs() < 1e-9 && (of("start_x") * length - z[0]).abs() < 1e-9
        );
        assert!((of("start_velocity") - z[1]).abs() < 1e-8 && (of("start_v") * velocity - z[1]).abs() < 1e-8);
        let (z, _) = state(end);
        assert!((of("end_displacement") - z[0]).abs() < 1e-9 && (of("end_x") * length - z[0]).abs() < 1e-9);
        let sign = state((start + end) / 2.0).1;
        let kind = ["slide-backward", "stick", "slide-forward"][(sign + 1) as usize];
        assert_eq!(segment["kind"], kind);
        // A stick ends by a release; a slide by a stop, or by a reversal where the body goes back at once.
        let after = state(end + 1e-6).1;
        let ends_by = if sign == 0 {
            "release"
        } else if after == 0 {
            "stop"
        } else {
            "reversal"
        };
        assert_eq!(segment["ends_by"], ends_by, "{segment:?}");
        kinds.insert(kind);
    }
    assert_eq!(kinds.len(), 3);
    for sample in rows(&stdout(&format!("simulate {options} --samples 9"))) {
        let of = |name: &str| sample[name].parse::<f64>().unwrap();
        let time = (TAU * of("cycle") + of("phase")) / frequency;
        assert!((time - of("time")).abs() < 1e-12);
        let (z, sign) = state(time);
        let held = force * (frequency * time).sin() - stiffness * z[0];
        let against = if sign == 0 { held } else { f64::from(sign) * friction };
        assert!((of("displacement") - z[0]).abs() < 1e-9 && (of("x") * length - z[0]).abs() < 1e-9);
        assert!((of("velocity") - z[1]).abs() < 1e-8 && (of("v") * velocity - z[1]).abs() < 1e-8);
        assert!(
            (of("friction_force") - against).abs() < 1e-8
                && (of("friction") * friction - against).abs() < 1e-8
        );
        assert!((of("r") * friction - against - stiffness * z[0]).abs() < 1e-7);
        assert!((of("acceleration") - (held - against) / mass).abs() < 1e-7);
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
    let near = |value: &Value, expected: f64| (value.as_f64().unwrap() - expected).abs() < 1e-9;
    assert_eq!(answer["half_cycles"].as_u64(), Some(found.found.ends));
    assert!(
        near(&physical["rest_position"], found.last) && near(&answer["rest_position"], found.last / 0.06)
    );
    let last = found.found.stops[found.found.stops.len() - 1];
    assert!((physical["rest_time"].as_f64().unwrap() - last[0]).abs() < 1e-7);
    assert!((answer["rest_time"].as_f64().unwrap() - last[0] * 5.0).abs() < 1e-6);
    assert!(near(&physical["first_turn"], 0.7) && near(&answer["first_turn"], 0.7 / 0.06));
    let path = found.found.path[0] + found.found.path[1];
    assert!(near(&physical["path"], path) && near(&answer["path"], path / 0.06));
    let text = std::fs::read_to_string(&turns).unwrap();
    let rows: Vec<Vec<f64>> = csv::Reader::from_reader(text.as_bytes())
        .records()
        .map(|row| row.unwrap().iter().map(|cell| cell.parse().unwrap()).collect())
        .collect();
    assert_eq!(rows.len(), found.found.stops.len() + 1);
    for (i, row) in rows.iter().enumerate().skip(1) {
        let [t, x] = found.found.stops[i - 1];
        assert!(
            row[0] == i as f64 && (row[1] - t).abs() < 1e-7 && (row[2] - x).abs() < 1e-9,
            "{row:?} {t} {x}"
        );
    }
}

/// A response curve of the samples of 5 kg on 2 kN/m with 40 N and ζ = 3 % under 100 N, with relative noise.
fn curve_of_samples(random: &mut Random, noise: f64) -> String {
    let mut text = "frequency[rad/s],amplitude[mm]\n".to_owned();
    for i in 0..16 {
        let frequency = 20.0 * (0.5 + 0.09 * f64::from(i));
        let damping = 2.0 * 0.03 * 100.0;
        let machine = Machine::new([5.0, 2000.0, damping], [40.0, 0.0, 1.0], 0.0);
        let harmonic = Harmonic { machine, load: Load::Force, amplitude: 100.0, frequency };
        let Limit::Periodic(cycle) = harmonic.limit([0.0, 0.0], 0.0, 3000) else { continue };
        let by = 1.0 + noise * (random.next() + random.next() - 1.0) * 6f64.sqrt();
        text += &format!("{frequency},{}\n", 1e3 * by * cycle.found.most(Of::Displacement).value);
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
    assert!((value("friction") / 40.0 - 1.0).abs() < 1e-4, "{answer}");
    assert!((value("damping_ratio") / 0.03 - 1.0).abs() < 1e-3, "{answer}");
    assert!((value("damping") / 6.0 - 1.0).abs() < 1e-3, "{answer}");
    let coefficient = answer["friction_coefficient"]["value"].as_f64().unwrap();
    assert!((coefficient / (40.0 / 5.0 / 9.80665) - 1.0).abs() < 1e-4, "{answer}");
    assert!(answer["noise"].as_f64().unwrap() < 1e-4, "{answer}");
    assert_eq!((answer["measurements"].as_u64(), answer["used"].as_u64()), (Some(16), Some(16)));
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
        assert!(low - room < truth && truth < high + room, "{name} {truth}: {answer}");
    }
    assert_eq!(answer["used"].as_u64(), Some(15), "{answer}");
    assert_eq!(answer["suspects"].as_array().unwrap().len(), 1, "{answer}");
    assert_eq!(answer["residuals"].as_array().unwrap().len(), 16, "{answer}");
    let residual = answer["residuals"][7].as_f64().unwrap();
    assert!((residual - 0.6 / 1.6).abs() < 0.02, "{answer}");
    assert!((0.004..0.025).contains(&answer["noise"].as_f64().unwrap()), "{answer}");
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
    assert!((value("friction_displacement") / 0.06 - 1.0).abs() < 1e-6, "{answer}");
    assert!((value("damping_ratio") / 0.02 - 1.0).abs() < 1e-5, "{answer}");
    assert!((value("amplitude") / 1.5 - 1.0).abs() < 1e-7, "{answer}");
    assert!((value("natural_frequency") * TAU / 5.0 - 1.0).abs() < 1e-6, "{answer}");
    assert!((value("friction") / 3.0 - 1.0).abs() < 1e-6, "{answer}");
    assert!(
        (answer["friction_coefficient"]["value"].as_f64().unwrap() / (3.0 / 2.0 / 9.80665) - 1.0).abs()
            < 1e-6
    );
    assert_eq!(answer["measurements"].as_u64(), Some(8), "{answer}");
    // Peaks of both sides with signs; they end before the rest, which alone shows static friction.
    assert_eq!(answer["read_as"], "every-half-cycle", "{answer}");
    assert!(answer["half_cycles"].is_null() && answer["static_friction_displacement"].is_null(), "{answer}");
}

/// A load of two sines on a body of 2 kg, 50 N/m, 3 N and ζ = 2 %, and the displacements of the samples, from another zero.
fn load_and_motion() -> String {
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
        assert!((value(name) / due - 1.0).abs() < 1e-6, "{name}: {answer}");
        let interval = &answer[name]["interval_95"];
        assert!(
            interval[0].as_f64() <= Some(due * (1.0 + 1e-6))
                && interval[1].as_f64() >= Some(due * (1.0 - 1e-6))
        );
    }
    assert_eq!((answer["measurements"].as_u64(), &answer["load"]), (Some(250), &json!("force")));
    assert_eq!(answer["residuals"].as_array().map(Vec::len), Some(250));
    assert!(answer["noise"].as_f64().unwrap() < 1e-8 && answer["noise_unit"] == "m", "{answer}");
    assert_eq!(answer["ignored_columns"], json!(["temperature"]));
    assert_eq!(answer["stiffness"].is_null(), !is_fitted, "{answer}");
    let text = stdout(line);
    assert_eq!(text.contains("stiffness k         50 N/m"), is_fitted, "{text}");
    assert!(
        text.contains("friction force r_y  3 N") && text.contains("offset              0.007 m"),
        "{text}"
    );
}

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
        assert!(is_free(amplitude * 1.0001, friction, 1.0, load).0, "{name}");
        assert!(!is_free(amplitude * 0.9999, friction, 1.0, load).0, "{name}");
    }
    assert!((of(&answer, "mean_displacement") - 0.003).abs() < 1e-15);
    let answer = json(
        "design friction --mass 50 --stiffness 1000 --frequency 6 --force 12 --static-ratio 1.2 --format json",
    );
    let best = json("design friction --mass 50 --stiffness 1000 --frequency 6 --force 12 --format json");
    assert!(is_free(12.0, of(&best, "friction") * 0.9999, 1.0, Load::Force).0);
    assert!(!is_free(12.0, of(&best, "friction") * 1.0001, 1.0, Load::Force).0);
    assert!((of(&best, "friction_coefficient") * mass * 9.80665 / of(&best, "friction") - 1.0).abs() < 1e-12);
    // A body at rest is released below this friction, and not above.
    let release = of(&answer, "release_friction");
    assert!(is_free(12.0, release * 0.999, 1.2, Load::Force).1);
    assert!(!is_free(12.0, release * 1.001, 1.2, Load::Force).1);
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
        assert!((of(&answer, "target_amplitude") - target).abs() < 1e-15, "{answer}");
        for solution in solutions {
            let friction = of(solution, "friction");
            let (found, sticks) = amplitude(friction);
            assert!((found / target - 1.0).abs() < 1e-8, "{solution}: {found}");
            assert!((of(solution, "max_displacement") / target - 1.0).abs() < 1e-8, "{solution}");
            assert_eq!(solution["regime"], if sticks { "sticking" } else { "non-sticking" }, "{solution}");
            let coefficient = of(solution, "friction_coefficient") * 50.0 * 9.80665;
            assert!((coefficient / friction - 1.0).abs() < 1e-12, "{solution}");
        }
        // Over a grid the samples pass the amplitude as often as there are solutions.
        let grid: Vec<bool> = (1..40).map(|i| amplitude(0.29 * f64::from(i)).0 > target).collect();
        let passes = grid.windows(2).filter(|pair| pair[0] != pair[1]).count();
        assert_eq!(passes, solutions.len(), "{target}: {answer} {grid:?}");
    }
}

/// `pull` beside a long motion of the samples under a foot that moves at the speed.
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
    assert!((stops[1][0] - stops[0][0] - period).abs() < 1e-8 * period, "{answer} {stops:?}");
    assert!((stops[0][0] - first - of("slip_time")).abs() < 1e-8 * period, "{answer} {stops:?}");
    assert!((of("slip_time") + of("stick_time") - period).abs() < 1e-12, "{answer}");
    assert!((stops[0][1] * 1e3 / of("slip_distance") - 1.0).abs() < 1e-8, "{answer} {stops:?}");
    let fastest = found.found.most(Of::Velocity).value * 1e3;
    assert!((fastest / of("max_velocity") - 1.0).abs() < 1e-9, "{answer} {fastest}");
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
        assert_eq!(has_stopped, !is_smooth, "{line}");
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
                assert!((value / expected - 1.0).abs() < 1e-8, "{line}: {row:?} {expected}");
                let regime = if found.rests == 0 { "non-sticking" } else { "sticking" };
                assert_eq!(&row[2], regime, "{line}: {row:?}");
                // The force over the least one that keeps the samples sliding.
                let margin: f64 = row[4].parse().unwrap();
                assert_eq!(margin > 1.0, found.rests == 0, "{line}: {row:?}");
            }
            assert!(compared > 4, "{line}: {compared}");
        }
    }
    let page = rows()["response-curve"].iter().map(|name| (*name).to_owned()).collect();
    assert_eq!(names, page);
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
        let mut compared = 0;
        for row in reader.records().map(Result::unwrap) {
            let of = |i: usize| row[i].parse::<f64>();
            let at = [of(omega).unwrap(), of(alpha).unwrap(), 0.0, 1.0];
            let (Limit::Periodic(cycle), Ok(value)) = (ratios(at).limit([0.0, 0.0], 0.0, 600), of(value))
            else {
                continue;
            };
            compared += 1;
            if what == "stops" {
                assert_eq!(value, cycle.found.rests as f64, "{row:?}");
            } else {
                assert_eq!(value >= 1.0, cycle.found.rests == 0, "{row:?}");
            }
        }
        assert!(compared > 20, "{what}: {compared}");
    }
}
