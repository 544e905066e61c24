//! An oscillator that hits a rigid stop, without friction, as of Thompson and Ghaffari (1982) and of Shaw and Holmes (1983): its blows over the frequency, and the motion of one blow a
//! period in closed form.
//!
//! `x″ + x = cos Ωt`, a stop at x = 0 with the restitution e. Between two blows, T = 2π/Ω apart, the motion is `A cos t + B sin t + G cos(Ωt + θ)`, where
//! x = 0 at both and the velocity jumps from v to −e v. Hence, with C = cos T, S = sin T and G = 1/(1 − Ω²),
//!
//! `B = A (1 − C)/S`, `A = −(1 + e) S v/(2 (1 − C))`, `−e v = B − G Ω sin θ`, `A = −G cos θ`.
//!
//! A disturbance goes through the blow by `[−e, 0; (a₊ + e a₋)/v, −e]` with the accelerations a₋ = a₊ = cos(Ωt) there, and through the flight by the rotation
//! by T. So the product of the multipliers is e², and their sum is `−2 e C + S (1 + e) a/v`. One of them is −1 where `1 + sum + e² = 0`: from there on the period doubles.

use crate::shared::{evenly, of_frequency_ratio};
use stickslip::system::{Element, EventKind, Harmonic, Model, State, System};
use stickslip_draw::{Axis, Figure, Panel, Series, Style};

const RESTITUTION: f64 = 0.8;
/// The frequencies.
const RANGE: (f64, f64) = (2.45, 2.85);
/// The frequencies at which motions are followed, and the periods of each: those that are not shown, and those that are.
const FREQUENCIES: u32 = 121;
const SETTLING: f64 = 50.0;
const SHOWN: f64 = 24.0;

/// The motion of one blow a period: the velocity at it, and the sum of the multipliers.
fn one_blow(omega: f64) -> (f64, f64) {
    let e = RESTITUTION;
    let (sine, cosine) = (std::f64::consts::TAU / omega).sin_cos();
    let gain = 1.0 / (omega * omega - 1.0);
    // Of v = 1: A, and −e − B = −G Ω sin θ.
    let a = -(1.0 + e) * sine / (2.0 * (1.0 - cosine));
    let slope = e + a * (1.0 - cosine) / sine;
    let velocity = gain / a.hypot(slope / omega);
    // G < 0 here: A = |G| cos θ, and the acceleration there is the load.
    let load = a * velocity / gain;
    (velocity, -2.0 * e * cosine + sine * (1.0 + e) * load / velocity)
}

/// The frequency from which on the period doubles.
fn doubling() -> f64 {
    let (mut low, mut high) = (2.5, 2.75);
    while high - low > 4.0 * f64::EPSILON * high {
        let middle = f64::midpoint(low, high);
        if beside_doubling(middle) > 0.0 { low = middle } else { high = middle }
    }
    high
}

/// `(1 + λ₁)(1 + λ₂)` of both multipliers, which is 0 where one of them is −1.
fn beside_doubling(omega: f64) -> f64 {
    1.0 + one_blow(omega).1 + RESTITUTION * RESTITUTION
}

fn system(omega: f64) -> Option<System<f64>> {
    let one = |x: f64| vec![vec![x]];
    System::new(&Model {
        mass: one(1.0),
        damping: one(0.0),
        stiffness: one(1.0),
        elements: vec![Element::hard_stop([1.0], 0.0, RESTITUTION)],
        harmonics: vec![Harmonic { frequency: omega, sin: Vec::new(), cos: vec![1.0] }],
        ..Model::default()
    })
    .ok()
}

/// The velocities at the blows of the motion that a start leads to, and the state at its end.
fn blows(omega: f64, start: &State<f64>) -> Option<(Vec<f64>, State<f64>)> {
    let period = std::f64::consts::TAU / omega;
    let motion = system(omega)?.simulate(start, (SETTLING + SHOWN) * period).ok()?;
    let shown =
        motion.events.iter().filter(|event| event.kind == EventKind::Blow && event.time > SETTLING * period);
    let speeds = shown.filter_map(|event| event.velocities.map(|pair| pair.0)).collect();
    Some((speeds, motion.end))
}

/// Blows over the frequency, and the multipliers of the motion of one blow a period.
pub(super) fn over_frequency() -> Figure {
    let (low, high) = RANGE;
    let border = doubling();
    let mut start = State { displacement: vec![-0.2], ..State::rest(1) };
    let mut dots = Vec::new();
    for omega in evenly(low, high, FREQUENCIES) {
        let Some((speeds, end)) = blows(omega, &start) else { continue };
        dots.extend(speeds.into_iter().map(|speed| (omega, speed)));
        // The phase of the load is 0 again.
        start = State { force: Vec::new(), ..end };
    }
    let line = |from: f64, to: f64| evenly(from, to, 81).map(|omega| (omega, one_blow(omega).0));
    // Each begins at the one before: other motions of this oscillator do not settle.
    let mut start = State { displacement: vec![-0.2], ..State::rest(1) };
    let mut found = Vec::new();
    for omega in evenly(border - 0.01, 2.56, 9) {
        let Some(steady) = system(omega).and_then(|system| system.steady(&start).ok()) else { continue };
        let [(a, b), (c, d)] = steady.multipliers[..] else { continue };
        found.push((omega, (1.0 + a) * (1.0 + c) - b * d));
        start = State { force: Vec::new(), ..steady.start };
    }
    let upright = |label: &str, low: f64, high: f64| {
        Series::new(format!("{label} at Ω = {border:.6}"), Style::Dotted, 3, [(border, low), (border, high)])
    };
    Figure::new(
        "impacts",
        "An impact oscillator whose period doubles",
        "Blows at a rigid stop with restitution 0.8 (dots), and the motion of one blow a period in closed form, one of whose \
         multipliers passes −1 where the period doubles.",
        vec![
            Panel::new(
                "velocity at the blows",
                of_frequency_ratio(low, high),
                Axis::linear("velocity before a blow", 0.0, 0.9),
                vec![
                    Series::new("blows of the exact motion", Style::Dots, 0, dots),
                    Series::new("one blow a period, stable", Style::Line, 1, line(low, border)),
                    Series::new("one blow a period, unstable", Style::Dashed, 1, line(border, high)),
                    upright("the period doubles", 0.0, 0.9),
                ],
            ),
            Panel::new(
                "multipliers of one blow a period",
                of_frequency_ratio(2.55, 2.75),
                Axis::linear("(1 + λ₁)(1 + λ₂)", -1.0, 1.0),
                vec![
                    Series::new(
                        "closed form",
                        Style::Line,
                        1,
                        evenly(2.55, 2.75, 101).map(|omega| (omega, beside_doubling(omega))),
                    ),
                    Series::new("exact motion", Style::Marks, 0, found),
                    upright("a multiplier is −1", -1.0, 1.0),
                ],
            ),
        ],
    )
}
