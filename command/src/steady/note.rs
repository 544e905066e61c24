//! The note on a steady state.

use crate::bits::Value;
use crate::bits::digits;
use crate::input::Point;
use crate::machine::{Machine, transmitted};
use crate::note::{both, both_in_words, decay, measured_from, without_mean_force};
use crate::style;
use std::io::{self, Write};
use stickslip::inputs::units::{Kind, System};
use stickslip::motion::{LongRun, Peaks, SteadyState};
use stickslip::words;

/// The answer as a note.
pub(super) fn note<F: Value>(
    point: &Point<F>,
    limit: &LongRun<F>,
    units: &System,
    out: &mut impl Write,
) -> io::Result<()> {
    let scales = point.machine.as_ref().map(|m| &m.scales);
    let length = |x| both(x, "B", scales.map(|s| s.length), units.length());
    let in_words = |x| both_in_words(x, "B", scales.map(|s| s.length), units.length());
    if let Some(base) = point.machine.as_ref().and_then(|m| words::base_motion(m.drive.excitation())) {
        writeln!(out, "Base motion {base}.")?;
    }
    measured_from(point.machine.as_ref(), out)?;
    let verdict =
        style::verdict(&words::limit(point.ratios, limit, in_words, " Allow more with --max-periods."));
    match limit {
        LongRun::Periodic(steady) | LongRun::Family(steady) => {
            writeln!(out, "{verdict} {}\n", words::origin(point.ratios, limit))?;
            motion(steady, point, units, out)
        }
        LongRun::Irregular(found) => {
            writeln!(out, "{verdict}\n")?;
            writeln!(out, "  greatest displacement    {}", length(found.max_displacement))?;
            writeln!(out, "  least displacement       {}", length(found.min_displacement))?;
            let (exponent, error) = (found.lyapunov_exponent, found.lyapunov_exponent_error);
            writeln!(
                out,
                "  Lyapunov exponent        {} a turn, ± {:.1e}",
                digits(exponent),
                error.to_f64()
            )?;
            writeln!(out, "  stops                    {}", found.stops)
        }
        LongRun::Rest(_) | LongRun::Unbounded { .. } | LongRun::NotConverged { .. } => {
            writeln!(out, "{verdict}")
        }
    }
}

fn motion<F: Value>(
    steady: &SteadyState<F>,
    point: &Point<F>,
    units: &System,
    out: &mut impl Write,
) -> io::Result<()> {
    let scales = point.machine.as_ref().map(|m| &m.scales);
    let speed_unit = format!("{}/s", units.length());
    let work_unit = format!("{}·{}", units.force(), units.length());
    let length = |x| both(x, "B", scales.map(|s| s.length), units.length());
    let phase = |x| both(x, "rad", scales.map(|s| s.time), "s");
    let speed = |x| both(x, "B ω_d", scales.map(|s| s.velocity), &speed_unit);
    let work = |x| both(x, "r_y B", scales.map(|s| s.force * s.length), &work_unit);
    writeln!(out, "  maximum displacement     {}", length(steady.max_displacement.value))?;
    writeln!(out, "    at ω_d t               {}", phase(steady.max_displacement.phase.reduced()))?;
    writeln!(out, "  minimum displacement     {}", length(steady.min_displacement.value))?;
    writeln!(out, "    at ω_d t               {}", phase(steady.min_displacement.phase.reduced()))?;
    writeln!(out, "  maximum velocity         {}", speed(steady.max_velocity.value))?;
    writeln!(out, "    at ω_d t               {}", phase(steady.max_velocity.phase.reduced()))?;
    writeln!(out, "  minimum velocity         {}", speed(steady.min_velocity.value))?;
    writeln!(out, "    at ω_d t               {}", phase(steady.min_velocity.phase.reduced()))?;
    if let Ok(found) = steady.peaks() {
        peaks(&found, point, units, out)?;
    }
    writeln!(out, "  velocity zeros in a cycle {}", steady.velocity_zeros_per_cycle)?;
    let has_damped_foot = point.machine.as_ref().is_some_and(Machine::has_damped_foot);
    if !has_damped_foot {
        writeln!(out, "  work of the drive        {}", work(steady.energy_in))?;
    }
    writeln!(out, "  work against friction    {}", work(steady.energy_out))?;
    if steady.damper_work > F::int(0) && !has_damped_foot {
        writeln!(out, "  work against the damper  {}", work(steady.damper_work))?;
    }
    writeln!(out, "  a disturbance            {}", decay(steady.contraction(), "a cycle"))?;
    let far = format!("{:.0e}", steady.distance.0.to_f64());
    let periods = digits(steady.periods.to_f64());
    writeln!(out, "  found in {periods} periods, within {far} B of the limit")
}

/// The loads on the machine: acceleration, transmitted force and, for a base that carries the surface, the
/// absolute motion.
fn peaks<F: Value>(
    peaks: &Peaks<F>,
    point: &Point<F>,
    units: &System,
    out: &mut impl Write,
) -> io::Result<()> {
    let scales = point.machine.as_ref().map(|m| &m.scales);
    let acceleration = scales.map(|s| s.velocity / s.time);
    let text = both(peaks.acceleration, "B ω_d²", acceleration, &units.name(Kind::Acceleration));
    writeln!(out, "  maximum acceleration     {text}")?;
    let machine = point.machine.as_ref();
    let (force, ratio) = transmitted(machine, &point.ratios, peaks.transmitted_force, peaks.acceleration);
    writeln!(
        out,
        "  transmitted force        {}",
        both(force, "r_y", scales.map(|s| s.force), units.force())
    )?;
    without_mean_force(machine, out)?;
    let unit = if machine.is_some_and(|m| m.drive.excitation().moves_foot()) { "" } else { " p₀" };
    writeln!(out, "  transmissibility         {}{unit}", digits(ratio))?;
    if point.machine.as_ref().is_some_and(|m| m.drive.excitation().carries_surface()) {
        let absolute = both(peaks.absolute_displacement, "B", scales.map(|s| s.length), units.length());
        writeln!(out, "  absolute displacement    {absolute}")?;
    }
    Ok(())
}
