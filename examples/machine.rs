//! A machine in a file: the library's inputs are read from TOML, by the rules of their constructors.

use serde::Deserialize;
use std::io::Write;
use stickslip::{Cycle, Drive, Oscillator, Scales};

/// A feeder trough of 240 kg on springs, driven by a rotating unbalance at 10 revolutions a second. Any consistent units.
const FILE: &str = "
[body]
mass = 240
stiffness = 180e3
friction_bound = 150
damping = 300

[drive]
excitation = 'unbalance'
amplitude = 0.35
angular_frequency = 62.83185307179586
";

#[derive(Deserialize)]
struct Machine {
    body: Oscillator<f64>,
    drive: Drive<f64>,
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    answer(&mut std::io::stdout().lock())
}

pub(crate) fn answer(out: &mut impl Write) -> Result<(), Box<dyn std::error::Error>> {
    let Machine { body, drive } = toml::from_str(FILE)?;
    let cycle = Cycle::new(drive.ratios(&body)?)?;
    let stroke = cycle.max_displacement * Scales::new(&body, &drive)?.length;
    writeln!(out, "the trough moves {:.3} mm to either side", 1e3 * stroke)?;
    // A value outside its domain is an error that names the inequality it breaks, in its line.
    let wrong = FILE.replace("mass = 240", "mass = -240");
    if let Err(error) = toml::from_str::<Machine>(&wrong) {
        write!(out, "{error}")?;
    }
    Ok(())
}
