//! The sentence that a motion grazes a stop: where the closed form has a blow of hardly any velocity, or a gap that is hardly missed.

use serde_json::json;
use std::path::Path;
use stickslip::system::{EventKind, Steady};
use stickslip_front::system::{NamedSystem, steady_verdict};

const DAMPING: f64 = 0.05;
const RESTITUTION: f64 = 0.6;

/// `x″ + 2ζx′ + x = cos Ωt` with a stop: the verdict on its steady motion, and the motion.
fn verdict(omega: f64, gap: f64) -> (String, Steady<f64>) {
    // The start is that of the linear motion: others overshoot, and may lead to a motion with blows.
    let gain = 1.0 / (1.0 - omega * omega).hypot(2.0 * DAMPING * omega);
    let phase = (2.0 * DAMPING * omega).atan2(1.0 - omega * omega);
    let (x, v) = (gain * phase.cos(), gain * omega * phase.sin());
    let value = json!({
        "start": {"displacement": [x], "velocity": [v]},
        "mass": [[1]], "damping": [[2.0 * DAMPING]], "stiffness": [[1]],
        "elements": [{"type": "stop", "name": "wall", "direction": [1], "gap": gap, "restitution": RESTITUTION}],
        "harmonics": [{"frequency": omega, "cos": [1]}],
    });
    let found = NamedSystem::new(&value, [], Path::new(""), None).unwrap();
    let steady = found.steady(&found.described.start).unwrap().0;
    (steady_verdict(&found.described, &steady), steady)
}

const SAYS: &str = "The motion grazes wall: there a small disturbance may be multiplied without bound";

/// The amplitude of the linear motion is that of the gap but for a small part of it.
#[test]
fn a_stop_that_is_hardly_missed() {
    let omega = 1.3_f64;
    let amplitude = 1.0 / (1.0 - omega * omega).hypot(2.0 * DAMPING * omega);
    for (part, grazes) in [(5e-7, true), (1e-9, true), (2e-6, false), (1e-2, false)] {
        let (text, steady) = verdict(omega, amplitude * (1.0 + part));
        assert!(steady.motion.events.is_empty() && steady.periods == 1);
        assert!((steady.motion.max_displacement[0] / amplitude - 1.0).abs() < 1e-12);
        assert_eq!(text.contains(SAYS), grazes, "{part}: {text}");
    }
}

/// With Ω = 2ω_d half a free vibration takes a period T of the load, so that a blow of any velocity v repeats itself: `B e^{−ζt} sin ω_d t + G cos(Ωt + θ)` has
/// `G cos θ = d`, `ω_d B (1 + D) = −(1 + e) v`, D = e^{−ζT}, and `ω_d B − G Ω sin θ = −e v` after the blow. So `v = Ω √(G² − d²)/|e − (1 + e)/(1 + D)|`, and
/// both multipliers are D e: the motion is stable with the weakest blow.
#[test]
fn a_blow_of_hardly_any_velocity() {
    let natural = (1.0 - DAMPING * DAMPING).sqrt();
    let omega = 2.0 * natural;
    let amplitude = 1.0 / (1.0 - omega * omega).hypot(2.0 * DAMPING * omega);
    let decay = (-DAMPING * std::f64::consts::TAU / omega).exp();
    let factor = (RESTITUTION - (1.0 + RESTITUTION) / (1.0 + decay)).abs();
    let mut weakest = f64::INFINITY;
    for (part, doubt, grazes) in [(1e-4, 1e-9, false), (1e-6, 1e-9, false), (1e-8, 1e-6, true)] {
        let gap = amplitude * (1.0 - part);
        let (text, steady) = verdict(omega, gap);
        let due = omega * (amplitude * amplitude - gap * gap).sqrt() / factor;
        let blows: Vec<f64> = steady
            .motion
            .events
            .iter()
            .filter(|event| event.kind == EventKind::Blow)
            .map(|event| event.velocities.unwrap().0)
            .collect();
        assert!(blows.len() == 1 && steady.periods == 1, "{part}: {text} {:?}", steady.motion.events);
        assert!((blows[0] / due - 1.0).abs() < doubt, "{part}: {} {due}", blows[0]);
        assert_eq!(text.contains(SAYS), grazes, "{part}: {} of {}: {text}", blows[0], amplitude * omega);
        for (re, im) in &steady.multipliers {
            let due = decay * RESTITUTION;
            assert!((re.hypot(*im) / due - 1.0).abs() < 1e-3, "{:?}", steady.multipliers);
        }
        weakest = weakest.min(blows[0] / (amplitude * omega));
    }
    assert!(weakest < 1e-3, "{weakest}");
}
