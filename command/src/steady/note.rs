//! The note on a steady state.

use crate::bits::{Value, digits};
use crate::note::{Note, decay, measured_from};
use crate::style;
use std::io::{self, Write};
use stickslip::inputs::{Given, Point};
use stickslip::motion::{LongRun, Peaks, SteadyState};
use stickslip::words;
use stickslip::{Excitation, Measure, Ratios};

/// The answer as a note.
pub(super) fn note<F: Value>(
    given: &Given<F>,
    point: &Point<F>,
    limit: &LongRun<F>,
    out: &mut impl Write,
) -> io::Result<()> {
    let mut note = Note::of(given, point.machine.as_ref(), out);
    if let Some(base) = note.machine.and_then(|m| words::base_motion(m.drive.excitation())) {
        writeln!(note.out, "Base motion {base}.")?;
    }
    measured_from(given, note.machine, note.out)?;
    let length = |x| note.both(Measure::Length, x).split_whitespace().collect::<Vec<_>>().join(" ");
    let verdict = words::limit(point.ratios, limit, length, " Allow more with --max-periods.");
    let verdict = style::verdict(&verdict);
    match limit {
        LongRun::Periodic(steady) | LongRun::Family(steady) => {
            writeln!(note.out, "{verdict} {}\n", words::origin(point.ratios, limit))?;
            motion(steady, &point.ratios, &mut note)
        }
        LongRun::Irregular(found) => {
            writeln!(note.out, "{verdict}\n")?;
            note.number("greatest displacement", Measure::Length, found.max_displacement)?;
            note.number("least displacement", Measure::Length, found.min_displacement)?;
            let (exponent, error) = (digits(found.lyapunov_exponent), found.lyapunov_exponent_error.to_f64());
            note.line("Lyapunov exponent", format_args!("{exponent} a turn, ± {error:.1e}"))?;
            note.line("stops", found.stops)
        }
        LongRun::Rest(_) | LongRun::Unbounded { .. } | LongRun::NotConverged { .. } => {
            writeln!(note.out, "{verdict}")
        }
    }
}

fn motion<F: Value>(
    steady: &SteadyState<F>,
    ratios: &Ratios<F>,
    note: &mut Note<'_, F, impl Write>,
) -> io::Result<()> {
    for (name, measure, extreme) in [
        ("maximum displacement", Measure::Length, steady.max_displacement),
        ("minimum displacement", Measure::Length, steady.min_displacement),
        ("maximum velocity", Measure::Velocity, steady.max_velocity),
        ("minimum velocity", Measure::Velocity, steady.min_velocity),
    ] {
        note.number(name, measure, extreme.value)?;
        note.number("  at ω_d t", Measure::Angle, extreme.phase.reduced())?;
    }
    if let Ok(found) = steady.peaks() {
        peaks(&found, ratios, note)?;
    }
    note.line("velocity zeros in a cycle", steady.velocity_zeros_per_cycle)?;
    let has_damped_foot = note.has_damped_foot();
    if !has_damped_foot {
        note.number("work of the drive", Measure::Work, steady.energy_in)?;
    }
    note.number("work against friction", Measure::Work, steady.energy_out)?;
    if steady.damper_work > F::int(0) && !has_damped_foot {
        note.number("work against the damper", Measure::Work, steady.damper_work)?;
    }
    note.line("a disturbance", decay(steady.contraction(), "a cycle"))?;
    let far = format!("{:.0e}", steady.distance.0.to_f64());
    let periods = digits(steady.periods.to_f64());
    writeln!(note.out, "  found in {periods} periods, within {far} B of the limit")
}

/// The loads on the machine: acceleration, transmitted force and, for a base that carries the surface, the
/// absolute motion.
fn peaks<F: Value>(
    peaks: &Peaks<F>,
    ratios: &Ratios<F>,
    note: &mut Note<'_, F, impl Write>,
) -> io::Result<()> {
    note.number("maximum acceleration", Measure::Acceleration, peaks.acceleration)?;
    let (force, acceleration) = (peaks.transmitted_force, peaks.acceleration);
    let ratio = note.transmitted(ratios, force, acceleration, "transmitted force")?;
    let unit = if note.is_driven(Excitation::moves_foot) { "" } else { " p₀" };
    note.line("transmissibility", format_args!("{ratio}{unit}"))?;
    if note.is_driven(Excitation::carries_surface) {
        note.number("absolute displacement", Measure::Length, peaks.absolute_displacement)?;
    }
    Ok(())
}
