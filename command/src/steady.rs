//! `stickslip steady`.

use crate::args::{SteadyArgs, Swept};
use crate::bits::{Value, at_bits, digits};
use crate::failure::{Failure, Outcome};
use crate::note::{Note, decay, equivalent, measured_from};
use crate::physical::Physical;
use crate::points::AskedPoints;
use crate::row::{Cells, Row};
use crate::{enclose, input, interrupt, style};
use std::io::{self, Write};
use stickslip::motion::{LongRun, Peaks, State, SteadyAnswer, SteadyState};
use stickslip::{Error, Excitation, Measure, Quantity};
use stickslip_front::inputs::units::Reader;
use stickslip_front::inputs::{Given, Point};
use stickslip_front::words;

pub(crate) fn run(args: &SteadyArgs, out: &mut impl Write) -> Outcome {
    if args.enclose {
        return enclose::answer(Swept::Steady, &args.machine, &args.output, out);
    }
    at_bits!(args.output.bits, respond(args: &SteadyArgs, out))
}

fn respond<F: Value>(args: &SteadyArgs, out: &mut impl Write) -> Outcome {
    input::periods(args.max_periods)?;
    let asked = AskedPoints { question: Swept::Steady, output: &args.output, start: Some(&args.start) };
    let answer = |given: &Given<F>, point: &Point<F>, reader: &Reader| {
        let start = input::start(&args.start, given, point.machine.as_ref(), reader)?;
        answer(given, point, start, args.max_periods, true)
    };
    asked
        .answered(&args.machine, out, answer, |point, limit, given, out| write_note(given, point, limit, out))
}

/// The steady state from a start, and its record.
pub(crate) fn answer<F: Value>(
    given: &Given<F>,
    point: &Point<F>,
    start: State<F>,
    max_periods: u32,
    peaks: bool,
) -> Result<(LongRun<F>, Row), Failure> {
    let limit = LongRun::within(point.ratios, start, max_periods, &mut interrupt::keep_going)
        .map_err(|e| of_motion(given, e))?;
    let record = of_limit(given, point, &limit, peaks)?;
    Ok((limit, record))
}

/// A record of no motion, for the names of its values.
pub(crate) fn form<F: Value>(given: &Given<F>, point: &Point<F>, peaks: bool) -> Result<Row, Failure> {
    of_limit(given, point, &LongRun::Unbounded { growth: F::int(0) }, peaks)
}

/// The record of a limit.
fn of_limit<F: Value>(
    given: &Given<F>,
    point: &Point<F>,
    limit: &LongRun<F>,
    peaks: bool,
) -> Result<Row, Failure> {
    let found = SteadyAnswer::new(point.ratios, limit, peaks).map_err(|e| given.at_fault(&e))?;
    if let (Some((least, most)), Some(machine)) = (limit.extrema(), &point.machine) {
        input::note_pendulum(given, most.abs().or_larger(least.abs()) * machine.scales.length);
    }
    let record = Cells::of_answer(given, &point.ratios, &found, SteadyAnswer::COLUMNS);
    record.in_units(given, point, Physical::of_machine)
}

/// The failure, preceded by the argument for which the exact motion cannot be computed.
pub(crate) fn of_motion<F: Value>(given: &Given<F>, error: Error) -> Failure {
    if matches!(error.quantity(), Some(Quantity::DampingRatio | Quantity::StaticFrictionRatio)) {
        return given.at_fault(&error).into();
    }
    Failure::from(error).about("--omega or --frequency")
}

/// The answer as a note.
fn write_note<F: Value>(
    given: &Given<F>,
    point: &Point<F>,
    limit: &LongRun<F>,
    out: &mut impl Write,
) -> io::Result<()> {
    let mut note = Note::of(given, point.machine.as_ref(), out);
    if let Some(base) = note.machine.and_then(|m| words::base_motion_sentence(m.drive.excitation())) {
        writeln!(note.out, "{base}")?;
    }
    measured_from(given, note.machine, note.out)?;
    let length = |x| note.both(Measure::Length, x).split_whitespace().collect::<Vec<_>>().join(" ");
    let verdict = words::limit(point.ratios, limit, length, " Allow more with --max-periods.");
    let verdict = style::verdict(&verdict);
    match limit {
        LongRun::Periodic(steady) | LongRun::Family(steady) => {
            writeln!(note.out, "{verdict} {}\n", words::origin(point.ratios, limit))?;
            motion(steady, &mut note)
        }
        LongRun::Irregular(found) => {
            writeln!(note.out, "{verdict}\n")?;
            note.number("maximum displacement", Measure::Length, found.max_displacement)?;
            note.number("minimum displacement", Measure::Length, found.min_displacement)?;
            let (exponent, error) = (digits(found.lyapunov_exponent), found.lyapunov_exponent_error.to_f64());
            note.line("Lyapunov exponent", format_args!("{exponent} a turn, ± {error:.1e}"))?;
            note.line("stops", found.stops)
        }
        LongRun::Rest(_) | LongRun::Unbounded { .. } | LongRun::NotConverged { .. } => {
            writeln!(note.out, "{verdict}")
        }
    }
}

fn motion<F: Value>(steady: &SteadyState<F>, note: &mut Note<'_, F, impl Write>) -> io::Result<()> {
    for (name, measure, extreme) in [
        ("maximum displacement", Measure::Length, steady.max_displacement),
        ("minimum displacement", Measure::Length, steady.min_displacement),
        ("maximum velocity", Measure::Velocity, steady.max_velocity),
        ("minimum velocity", Measure::Velocity, steady.min_velocity),
    ] {
        note.number(name, measure, extreme.value)?;
        note.number("  at ω_d t", Measure::Angle, extreme.phase.reduced())?;
    }
    peaks(&steady.peaks().map_err(io::Error::other)?, note)?;
    note.line("velocity zeros in a cycle", steady.velocity_zeros_per_cycle)?;
    note.number("work of the excitation", Measure::Work, steady.energy_in)?;
    note.number("work against friction", Measure::Work, steady.energy_out)?;
    if steady.damper_work > F::int(0) {
        note.number("work against the damper", Measure::Work, steady.damper_work)?;
    }
    equivalent(note, |_, output| Some(output.of(steady)))?;
    note.line("a disturbance", decay(steady.contraction(), "a cycle"))?;
    let far = steady.distance.0.to_f64();
    if note.given.is_without_friction() || note.given.is_without_spring() {
        return Ok(());
    }
    note.line("distance from the limit", format_args!("{far:.0e} B, estimated"))
}

/// The loads on the machine: acceleration, transmitted force and, for a base that carries the surface, the
/// absolute motion.
fn peaks<F: Value>(peaks: &Peaks<F>, note: &mut Note<'_, F, impl Write>) -> io::Result<()> {
    note.number("maximum acceleration", Measure::Acceleration, peaks.acceleration)?;
    note.in_spring("force in the spring", peaks.spring_force)?;
    note.transmitted("transmitted force", peaks.transmitted_force)?;
    let unit = if note.is_driven(Excitation::moves_foot) { "" } else { " p₀" };
    note.line("transmissibility", format_args!("{}{unit}", digits(peaks.transmissibility)))?;
    if note.is_driven(Excitation::carries_surface) {
        note.number("absolute displacement", Measure::Length, peaks.absolute_displacement)?;
    }
    Ok(())
}
