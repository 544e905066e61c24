//! The acceleration that a sliding isolator transmits.
//!
//! A server cabinet of 800 kg stands on sliding bearings with a coefficient of friction of 0.06 (471 N), and
//! on springs that give it a natural period of 2.5 s. The floor shakes harmonically with 2 m/s². How far does
//! the cabinet slide over the floor, and what acceleration does it experience?
//!
//! Springs and bearings both stand on the floor, which carries the surface along: x is the displacement relative to
//! the floor, and the floor's acceleration is the drive. The peak acceleration of the cabinet occurs just before it
//! reverses: (k Δ₀ + r_y)/m, the transmitted force over the mass.
//!
//! At 0.6 Hz the cabinet experiences the acceleration of the floor, and from 1 Hz less than half of it. The
//! gap it needs decreases from 0.23 m at 0.6 Hz to 12 mm at 2 Hz. At 1 Hz, the cabinet sticks in every cycle
//! if the floor shakes with less than 1.025 m/s².

use std::f64::consts::TAU;
use std::io::Write;
use stickslip::{Drive, Excitation, Oscillator, Output, Response, Scales, design};

const MASS: f64 = 800.0; // kg
const FRICTION: f64 = 0.06 * MASS * 9.81; // N
const FLOOR: f64 = 2.0; // m/s²

fn main() -> Result<(), Box<dyn std::error::Error>> {
    answer(&mut std::io::stdout().lock())
}

pub(crate) fn answer(out: &mut impl Write) -> Result<(), Box<dyn std::error::Error>> {
    let cabinet = Oscillator::new(MASS, MASS * (TAU / 2.5_f64).powi(2), FRICTION)?;
    writeln!(out, "floor at   slides by   cabinet feels   does not stick from")?;
    for hertz in [0.6, 0.8, 1.0, 2.0, 4.0] {
        let drive = Drive::new(Excitation::SurfaceAcceleration, FLOOR, TAU * hertz)?;
        let (response, scales) = (Response::new(drive.ratios(&cabinet)?), Scales::new(&cabinet, &drive)?);
        let found = |output: Output| Some(output.of(&response)? * output.unit(&scales));
        let slide = found(Output::MaxDisplacement).ok_or("it sticks: the exact motion has the answer")?;
        let felt = found(Output::TransmittedForce).ok_or("it sticks")? / MASS;
        let least = design::min_amplitude(&cabinet, Excitation::SurfaceAcceleration, TAU * hertz)?;
        writeln!(out, "{hertz:>5} Hz   {slide:>7.4} m   {felt:>8.3} m/s²   {least:>10.3} m/s²")?;
    }
    Ok(())
}
