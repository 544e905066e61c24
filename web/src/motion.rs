//! The motion over a cycle of its steady state, or from its start.

use crate::asked::{Asked, Problem};
use crate::drift::Drifting;
use serde_json::{Value, json};
use std::f64::consts::TAU;
use stickslip::Error;
use stickslip::motion::{LongRun, Trajectory};
use stickslip_front::inputs::Driven;
use stickslip_front::inputs::units::Kind;

/// The most turns of the drive that are shown.
pub(crate) const MOST_TURNS: u32 = 60;
/// The turns of a motion from its start, where no rest ends it before.
pub(crate) const FIRST_TURNS: u32 = 12;

/// Samples of the motion, `count` in a turn of the drive: of its cycle, or with `from_start`, and where there is no
/// cycle, from its start, to its rest.
pub(crate) fn motion(asked: &Asked<'_>) -> Result<Value, String> {
    if let Some(drifting) = Drifting::asked(asked)? {
        return drifting.samples(is_from_start(asked), per_turn(asked));
    }
    let problem = asked.problem()?;
    let Problem { given, point, start, .. } = &problem;
    let named = |e: Error| String::from(given.at_fault(&e));
    let limit = LongRun::from_start(point.ratios, *start).map_err(named)?;
    let from_start = is_from_start(asked);
    let (begin, turns, is_steady) = match (limit.steady_state(), &limit) {
        (Some(steady), _) if !from_start => (steady.state, steady.turns_per_cycle.min(MOST_TURNS), true),
        (None, LongRun::Rest(rest)) => {
            let turns = (rest.periods + 1.0).clamp(2.0, f64::from(MOST_TURNS));
            (*start, turns.ceil() as u32, false)
        }
        _ => (*start, FIRST_TURNS, false),
    };
    let per_turn = per_turn(asked);
    let scales = point.machine.map(|machine| machine.scales);
    let of = |scale: fn(&stickslip::Scales<f64>) -> f64| scales.as_ref().map_or(1.0, scale);
    let (size, speed, force) = (of(|s| s.length), of(|s| s.velocity), of(|s| s.force));
    let mean_friction = scales.map_or(0.0, |s| s.mean_friction);
    let (mut times, mut x, mut v, mut r, mut loads, mut rests) =
        (Vec::new(), Vec::new(), Vec::new(), Vec::new(), Vec::new(), Vec::new());
    let samples =
        Trajectory::new(point.ratios, begin).and_then(|motion| motion.samples(per_turn)).map_err(named)?;
    // The drive begins its cycle at t = 0.
    let samples = samples.skip_while(|sample| sample.as_ref().is_ok_and(|s| s.state.phase.reduced() != 0.0));
    for (place, sample) in samples.take((per_turn * turns + 1) as usize).enumerate() {
        let sample = sample.map_err(named)?;
        times.push(TAU * place as f64 / f64::from(per_turn) * of(|s| s.time));
        x.push(sample.state.x * size);
        v.push(sample.state.v * speed);
        r.push(if problem.is_frictionless { 0.0 } else { sample.friction * force + mean_friction });
        let load = if problem.is_free { 0.0 } else { point.ratios.alpha() * force };
        loads.push(load * sample.state.phase.reduced().sin());
        rests.push(sample.state.v == 0.0 && sample.acceleration == 0.0);
    }
    let unit = |kind: Kind, ratio: &str| match scales {
        Some(_) => given.system.name(kind),
        None => ratio.to_owned(),
    };
    Ok(json!({
        "time": times, "displacement": x, "velocity": v, "friction": r, "load": loads, "rest": rests, "turns": turns,
        "steady": is_steady, "support": point.machine.as_ref().map(|machine| support(machine, problem.is_free)),
        "bound": if problem.is_frictionless { 0.0 } else { point.ratios.static_friction_ratio() * force },
        "units": {
            "time": unit(Kind::Time, "rad"), "displacement": unit(Kind::Length, "B"),
            "velocity": unit(Kind::Velocity, "B ω_d"), "friction": unit(Kind::Force, "r_y"),
        },
    }))
}

/// Whether the motion is that from its start.
fn is_from_start(asked: &Asked<'_>) -> bool {
    asked.0.get("from_start").and_then(Value::as_bool).unwrap_or(false)
}

/// The samples in a turn of the drive.
fn per_turn(asked: &Asked<'_>) -> u32 {
    u32::try_from(asked.count("count", 240, 10_000)).unwrap_or(240).max(8)
}

/// The part of the support that moves, and its amplitude in the unit of displacements: the load is
/// `p₀ sin ω_d t` where the motion is `u₀ sin (ω_d t − lead)`.
pub(crate) fn support(machine: &Driven<f64>, is_free: bool) -> Value {
    let (body, drive) = (&machine.oscillator, &machine.drive);
    let excitation = drive.excitation();
    let force = if is_free { 0.0 } else { drive.force_amplitude(body) };
    if excitation.carries_surface() {
        let size = body.mass() * drive.angular_frequency().powi(2);
        json!({ "moves": "base", "amplitude": force / size, "lead": 0.0 })
    } else if excitation.moves_foot() {
        let amplitude = if is_free { 0.0 } else { drive.amplitude() };
        json!({ "moves": "foot", "amplitude": amplitude, "lead": drive.phase_lead(body) })
    } else {
        Value::Null
    }
}
