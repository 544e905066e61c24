//! What does a sliding isolator let through?
//!
//! A server cabinet of 800 kg stands on sliding bearings: friction coefficient 0.06, so 471 N, and springs
//! that bring it back with a natural period of 2.5 s. The floor shakes harmonically with 2 m/s². How far does
//! the cabinet slide over the floor, and what acceleration does it feel itself?
//!
//! Springs and bearings are both on the floor, so x is the displacement over the floor and the drive is the
//! inertia of the floor's acceleration: p₀ = m ω_d² u_g0, the mass times the acceleration. The greatest
//! acceleration of the cabinet is just before it turns: (k Δ₀ + r_y)/m.
//!
//! The answer: at 0.6 Hz the cabinet feels what the floor does, from 1 Hz up less than half of it, and the
//! gap it needs falls from 0.23 m at 0.6 Hz to 12 mm at 2 Hz. If the floor shook with less than 1.025 m/s² at
//! 1 Hz, it would stick in every cycle.

use std::f64::consts::TAU;
use std::io::Write;
use stickslip::{Drive, Excitation, Oscillator, Response, Scales, design};

const MASS: f64 = 800.0; // kg
const FRICTION: f64 = 0.06 * MASS * 9.81; // N
const FLOOR: f64 = 2.0; // m/s²

fn main() -> Result<(), Box<dyn std::error::Error>> {
    answer(&mut std::io::stdout().lock())
}

pub(crate) fn answer(out: &mut impl Write) -> Result<(), Box<dyn std::error::Error>> {
    let stiffness = MASS * (TAU / 2.5_f64).powi(2);
    let cabinet = Oscillator::new(MASS, stiffness, FRICTION)?;
    writeln!(out, "floor at   slides by   cabinet feels   does not stick from")?;
    for hertz in [0.6, 0.8, 1.0, 2.0, 4.0] {
        let frequency = TAU * hertz;
        let drive = Drive::force(MASS * FLOOR, frequency)?;
        let response = Response::new(drive.ratios(&cabinet)?);
        let cycle = response.cycle.as_ref().ok_or("it sticks: the exact motion has the answer")?;
        let slide = cycle.max_displacement * Scales::new(&cabinet, &drive)?.length;
        let felt = (stiffness * slide + FRICTION) / MASS;
        let least = design::min_amplitude(&cabinet, Excitation::Force, frequency)? / MASS;
        writeln!(out, "{hertz:>5} Hz   {slide:>7.4} m   {felt:>8.3} m/s²   {least:>10.3} m/s²")?;
    }
    Ok(())
}
