//! Answers in units beside the samples of the motion.

use super::rows;
use crate::command_line::json;
use crate::compared::Origin::{ByHand, DenseSamples};
use crate::compared::{agreed, compared, near};
use crate::machines::Driven;
use crate::random::Random;
use crate::sampled::{Cycle, Limit, Load, Of};
use serde_json::Value;
use std::collections::BTreeSet;
use std::f64::consts::{PI, TAU};
use stickslip::Excitation;

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
pub(super) fn si(unit: &str) -> f64 {
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

/// Those that repeat the machine or follow from it by their definitions.
const INPUTS: [&str; 23] = [
    "frequency",
    "angular_frequency",
    "natural_frequency",
    "period",
    "mass",
    "stiffness",
    "friction",
    "friction_backward",
    "friction_bound",
    "damping",
    "static_friction",
    "force_amplitude",
    "unbalance",
    "foot_displacement",
    "damped_foot_displacement",
    "lead_time",
    "base_displacement",
    "base_velocity",
    "base_acceleration",
    "friction_displacement",
    "mean_force",
    "mean_displacement",
    "friction_coefficient",
];

/// Answers of machines in units under every drive: each value is that of the samples, in three systems of units.
#[test]
fn answers_in_units_are_those_of_the_samples() {
    let mut random = Random(71);
    let mut seen = BTreeSet::new();
    for excitation in Excitation::ALL {
        let mut done = 0;
        while done < 6 {
            let mut driven = Driven::any(&mut random, excitation);
            if done < 3 {
                driven.eta = 1.0;
            }
            let harmonic = driven.harmonic();
            let start = [harmonic.mean(), 0.0];
            let Limit::Periodic(cycle) = harmonic.limit(start, -driven.lead(), 400) else { continue };
            done += 1;
            let systems = ["N,m", "kN,mm", "lbf,in"];
            for (question, units) in [("response", systems[done % 3]), ("steady", systems[(done + 1) % 3])] {
                let line = format!("{question} {} --units {units} --format json", options(&driven));
                let answer = json(&line);
                let physical = &answer["physical"];
                let said = match driven.excitation {
                    Excitation::Force => "force",
                    Excitation::Unbalance => "unbalance",
                    Excitation::FootMotion | Excitation::DampedFootMotion => "support",
                    _ => "base",
                };
                agreed("physical drive", physical["drive"].as_str().unwrap().contains(said), true, ByHand);
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
                    // The ratio of these has its own comparison; here it is their unit.
                    let of_samples = !INPUTS.contains(&name.as_str())
                        && !name.contains("best")
                        && !name.contains("min_force");
                    let origin = if of_samples && name != "followed_for" { DenseSamples } else { ByHand };
                    compared(&format!("physical {name}"), value, expected, origin, room);
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
    compared(
        "physical friction_coefficient",
        physical["friction_coefficient"].as_f64().unwrap(),
        0.3,
        ByHand,
        0.0,
    );
    near("physical friction", physical["friction"].as_f64().unwrap(), 0.3 * 2.0 * 9.80665, ByHand, 1e-13);
    compared("physical rest_position", physical["rest_position"].as_f64().unwrap(), 0.0, ByHand, 0.0);
}
