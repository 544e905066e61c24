//! The motion over a cycle of its steady state, or from rest where there is none.

use crate::asked::Asked;
use serde_json::{Value, json};
use std::f64::consts::TAU;
use stickslip::Error;
use stickslip::inputs::units::Kind;
use stickslip::motion::{LongRun, State, Trajectory};

/// The most turns of the drive in a cycle that is shown whole.
const MOST_TURNS: u32 = 8;

/// Samples of the motion, `count` in a turn of the drive: of its cycle, or of the first turns from rest.
pub(crate) fn motion(asked: &Asked<'_>) -> Result<Value, String> {
    let given = asked.given(&asked.reader()?)?;
    let point = given.point()?;
    let named = |e: Error| String::from(given.at_fault(&e));
    let start = State::default();
    let limit = LongRun::from_start(point.ratios, start).map_err(named)?;
    let (begin, turns, is_steady) = match limit.steady_state() {
        Some(steady) => (steady.state, steady.turns_per_cycle.min(MOST_TURNS), true),
        None => (start, MOST_TURNS, false),
    };
    let per_turn = u32::try_from(asked.count("count", 240, 10_000)).unwrap_or(240).max(8);
    let scales = point.machine.map(|machine| machine.scales);
    let of = |scale: fn(&stickslip::Scales<f64>) -> f64| scales.as_ref().map_or(1.0, scale);
    let (size, speed, force) = (of(|s| s.length), of(|s| s.velocity), of(|s| s.force));
    let mean_friction = scales.map_or(0.0, |s| s.mean_friction);
    let (mut times, mut x, mut v, mut r, mut rests) =
        (Vec::new(), Vec::new(), Vec::new(), Vec::new(), Vec::new());
    let samples =
        Trajectory::new(point.ratios, begin).and_then(|motion| motion.samples(per_turn)).map_err(named)?;
    // The drive begins its cycle at t = 0.
    let samples = samples.skip_while(|sample| sample.as_ref().is_ok_and(|s| s.state.phase.reduced() != 0.0));
    for (place, sample) in samples.take((per_turn * turns + 1) as usize).enumerate() {
        let sample = sample.map_err(named)?;
        times.push(TAU * place as f64 / f64::from(per_turn) * of(|s| s.time));
        x.push(sample.state.x * size);
        v.push(sample.state.v * speed);
        r.push(sample.friction * force + mean_friction);
        rests.push(sample.state.v == 0.0 && sample.acceleration == 0.0);
    }
    let unit = |kind: Kind, ratio: &str| match scales {
        Some(_) => given.system.name(kind),
        None => ratio.to_owned(),
    };
    Ok(json!({
        "time": times, "displacement": x, "velocity": v, "friction": r, "rest": rests, "turns": turns, "steady": is_steady,
        "units": {
            "time": unit(Kind::Time, "rad"), "displacement": unit(Kind::Length, "B"),
            "velocity": unit(Kind::Velocity, "B ω_d"), "friction": unit(Kind::Force, "r_y"),
        },
    }))
}
