//! The dither that keeps a valve spool from sticking.
//!
//! A spool of 50 g between springs of 20 kN/m sticks in its bore with 6 N, and small commands are lost. A
//! dither, a small force at a frequency above the useful ones, is to keep it sliding all the time. What
//! amplitude is needed, and how far does the spool then move? A margin of 20 % covers the scatter of the
//! friction.
//!
//! The natural frequency is 101 Hz. At 90 Hz, where resonance helps, 7.3 N suffice, and at 200 Hz 10 N; but
//! with the margin the spool moves nine times as far at 90 Hz. Low frequencies are a bad choice: 40 Hz, Ω =
//! 0.4, needs 43 N.

use std::f64::consts::TAU;
use std::io::Write;
use stickslip::{Cycle, Drive, Excitation, Oscillator, Scales, design};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    answer(&mut std::io::stdout().lock())
}

pub(crate) fn answer(out: &mut impl Write) -> Result<(), Box<dyn std::error::Error>> {
    let spool = Oscillator::new(0.050, 20e3, 6.0)?; // kg, N/m, N
    writeln!(out, "frequency  least force  with 20 % more: shakes by")?;
    for hertz in [40.0, 60.0, 90.0, 120.0, 200.0] {
        let least = design::min_amplitude(&spool, Excitation::Force, TAU * hertz)?;
        let dither = Drive::force(1.2 * least, TAU * hertz)?;
        let cycle = Cycle::new(dither.ratios(&spool)?)?;
        let shake = cycle.max_displacement * Scales::new(&spool, &dither)?.length;
        writeln!(out, "{hertz:>6} Hz  {least:>9.2} N  ± {:.0} µm", 1e6 * shake)?;
    }
    Ok(())
}
