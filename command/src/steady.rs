//! `stickslip steady`.

mod note;

use crate::args::{Format, SteadyArgs};
use crate::bits::{self, Task, Value};
use crate::enclose;
use crate::failure::{Failure, Outcome};
use crate::given::{Given, Parameter};
use crate::input::{self, Point};
use crate::interrupt;
use crate::machine::Machine;
use crate::physical::Physical;
use crate::points;
use crate::record::{Cell, Record};
use std::io::Write;
use stickslip::exact::{Irregular, LongRun, State, SteadyState};
use stickslip::observed;
use stickslip::units::Kind;
use stickslip::{Error, Quantity, Ratios};

use note::note;

/// The command with its arguments and its output.
struct Run<'a, W>(&'a SteadyArgs, &'a mut W);

pub(crate) fn run(args: &SteadyArgs, out: &mut impl Write) -> Outcome {
    if args.enclose {
        return enclose::steady(&args.machine, &args.force.alpha, &args.output, out);
    }
    bits::run(args.output.bits, Run(args, out))
}

impl<W: Write> Task for Run<'_, W> {
    fn run<F: Value>(self) -> Outcome {
        let Self(args, out) = self;
        input::periods(args.max_periods)?;
        let reader = args.output.units.reader();
        let given = Given::<F>::of(&args.machine, &args.force, &reader)?;
        let answer = |given: &Given<F>, point: &Point<F>| {
            let start = input::start(&args.start, given, point.machine.as_ref(), &reader)?;
            answer(given, point, start, args.max_periods, true)
        };
        if let Some(file) = &args.output.points {
            let (used, ratios) = (&Parameter::ALL, &[Parameter::Omega, Parameter::Alpha]);
            let start = Some(&args.start);
            let asked =
                points::Asked { file, output: &args.output, reader: &reader, given, used, ratios, start };
            return points::run(asked, out, |given| {
                answer(given, &input::point(given)?).map(|(_, record)| record)
            });
        }
        let point = input::point(&given)?;
        let (limit, record) = answer(&given, &point)?;
        match args.output.format.unwrap_or(Format::Text) {
            Format::Text => Ok(note(&point, &limit, &given.system, out)?),
            Format::Json => record.write_pretty(out),
            Format::Jsonl | Format::Csv => Err(Failure::single_format()),
        }
    }
}

/// The steady state from a start, and its record.
pub(crate) fn answer<F: Value>(
    given: &Given<F>,
    point: &Point<F>,
    start: State<F>,
    max_periods: u32,
    peaks: bool,
) -> Result<(LongRun<F>, Record<F>), Failure> {
    let limit = LongRun::within(point.ratios, start, max_periods, &mut interrupt::keep_going)
        .map_err(|e| of_motion(given, e))?;
    let record = of_limit(given, point, &limit, peaks)?;
    Ok((limit, record))
}

/// A record of no motion, for the names of its values.
pub(crate) fn form<F: Value>(given: &Given<F>, point: &Point<F>, peaks: bool) -> Result<Record<F>, Failure> {
    of_limit(given, point, &LongRun::Unbounded { growth: F::int(0) }, peaks)
}

/// The record of a limit.
fn of_limit<F: Value>(
    given: &Given<F>,
    point: &Point<F>,
    limit: &LongRun<F>,
    peaks: bool,
) -> Result<Record<F>, Failure> {
    let record = record(point.ratios, limit, peaks).map_err(|e| given.at_fault(e))?;
    let zeta = point.ratios.damping_ratio();
    let record = if given.has_damper() {
        let mut record = record.with_damping_ratio(zeta);
        let work = limit.steady_state().map(|it| it.damper_work);
        record.fields.push(("damper_work", Cell::Number(work)));
        record
    } else {
        record
    };
    let record =
        if given.has_static_friction() { with_static_friction(record, &point.ratios, limit) } else { record };
    match &point.machine {
        Some(machine) => with_machine(record, machine).finite().map_err(|e| given.behind_all(e)),
        None => Ok(record),
    }
}

/// The record with η, and with the outputs that exist only for a static friction above the kinetic one.
fn with_static_friction<F: Value>(record: Record<F>, ratios: &Ratios<F>, limit: &LongRun<F>) -> Record<F> {
    let mut record = record.with_static_friction_ratio(ratios.static_friction_ratio());
    let steady = limit.steady_state();
    let irregular = limit.irregular();
    let number = |value: fn(&Irregular<F>) -> F| Cell::Number(irregular.map(value));
    let extrema = limit.extrema();
    for (name, cell) in &mut record.fields {
        match *name {
            "max_displacement" => *cell = Cell::Number(extrema.map(|(_, most)| most)),
            "min_displacement" => *cell = Cell::Number(extrema.map(|(least, _)| least)),
            _ => {}
        }
    }
    record.fields.extend([
        ("turns_per_cycle", Cell::Count(steady.map(|s| u64::from(s.turns_per_cycle)))),
        ("symmetric", Cell::Flag(steady.map(|s| s.is_symmetric))),
        ("lyapunov_exponent", number(|m| m.lyapunov_exponent)),
        ("lyapunov_exponent_error", number(|m| m.lyapunov_exponent_error)),
        ("turns_observed", Cell::Count(irregular.map(|m| m.turns))),
    ]);
    record
}

/// The failure, preceded by the argument for which the exact motion cannot be computed.
pub(crate) fn of_motion<F: Value>(given: &Given<F>, error: Error) -> Failure {
    if matches!(error.quantity(), Some(Quantity::DampingRatio | Quantity::StaticFrictionRatio)) {
        return given.at_fault(error);
    }
    Failure::from(error).about("--omega or --frequency")
}

/// All outputs of a steady state; the peaks only if requested.
fn record<F: Value>(ratios: Ratios<F>, limit: &LongRun<F>, peaks: bool) -> Result<Record<F>, Error> {
    let steady = limit.steady_state();
    let number = |value: fn(&SteadyState<F>) -> F| Cell::Number(steady.map(value));
    let count = |value: fn(&SteadyState<F>) -> u32| Cell::Count(steady.map(|s| u64::from(value(s))));
    let errors = steady.map(SteadyState::errors).transpose()?;
    let peaks = steady.filter(|_| peaks).map(SteadyState::peaks).transpose()?;
    let seen = observed(ratios, limit);
    let (regime, kind) = (seen.regime.name(), limit.name());
    let larger = |a: F, b: F| if a > b { a } else { b };
    let amplitude = steady.map(|s| larger(s.max_displacement.value.abs(), s.min_displacement.value.abs()));
    Ok(Record {
        fields: vec![
            ("omega", Cell::Number(Some(ratios.omega()))),
            ("alpha", Cell::Number(Some(ratios.alpha()))),
            ("regime", Cell::Text(regime)),
            ("limit", Cell::Text(kind)),
            ("max_displacement", number(|s| s.max_displacement.value)),
            ("max_displacement_phase", number(|s| s.max_displacement.phase.reduced())),
            ("min_displacement", number(|s| s.min_displacement.value)),
            ("min_displacement_phase", number(|s| s.min_displacement.phase.reduced())),
            ("max_velocity", number(|s| s.max_velocity.value)),
            ("max_velocity_phase", number(|s| s.max_velocity.phase.reduced())),
            ("min_velocity", number(|s| s.min_velocity.value)),
            ("min_velocity_phase", number(|s| s.min_velocity.phase.reduced())),
            ("sticks_per_cycle", Cell::Count(seen.sticks.map(u64::from))),
            ("velocity_zeros_per_cycle", count(|s| s.velocity_zeros_per_cycle)),
            ("stick_fraction", number(|s| s.stick_fraction)),
            ("error_1", Cell::Number(errors.map(|e| e.error_1))),
            ("error_2", Cell::Number(errors.map(|e| e.error_2))),
            ("error_3", Cell::Number(errors.map(|e| e.error_3))),
            ("error_4", Cell::Number(errors.map(|e| e.error_4))),
            ("energy_in", number(|s| s.energy_in)),
            ("energy_out", number(|s| s.energy_out)),
            ("multipliers", Cell::Pairs(steady.map(|it| it.multipliers))),
            ("distance", number(|s| s.distance.0)),
            ("rest_position", Cell::Number(limit.rest_position())),
            ("periods", Cell::Number(limit.periods())),
            ("reversals_per_cycle", Cell::Count(seen.reversals.map(u64::from))),
            ("dynamic_amplification", Cell::Number(amplitude.map(|x| x / ratios.alpha()))),
            ("max_acceleration", Cell::Number(peaks.map(|p| p.acceleration))),
            ("transmitted_force", Cell::Number(peaks.map(|p| p.transmitted_force))),
            ("transmissibility", Cell::Number(peaks.map(|p| p.transmitted_force / ratios.alpha()))),
            ("max_absolute_displacement", Cell::Number(peaks.map(|p| p.absolute_displacement))),
        ],
        physical: Physical::default(),
    })
}

/// Adds the machine and the answer in its units.
fn with_machine<F: Value>(record: Record<F>, machine: &Machine<F>) -> Record<F> {
    let mut record = record.felt_around(machine);
    let scales = &machine.scales;
    let turn = F::int(2) * F::pi() * scales.time;
    record.physical = Physical::of_machine(machine).with(&record.fields, |name| {
        Some(match name {
            "max_displacement" => ("max_displacement", Kind::Length, scales.length),
            "max_displacement_phase" => ("max_displacement_time", Kind::Time, scales.time),
            "min_displacement" => ("min_displacement", Kind::Length, scales.length),
            "min_displacement_phase" => ("min_displacement_time", Kind::Time, scales.time),
            "max_velocity" => ("max_velocity", Kind::Velocity, scales.velocity),
            "max_velocity_phase" => ("max_velocity_time", Kind::Time, scales.time),
            "min_velocity" => ("min_velocity", Kind::Velocity, scales.velocity),
            "min_velocity_phase" => ("min_velocity_time", Kind::Time, scales.time),
            "max_acceleration" => ("max_acceleration", Kind::Acceleration, scales.velocity / scales.time),
            "transmitted_force" => ("transmitted_force", Kind::Force, scales.force),
            "max_absolute_displacement" if machine.drive.excitation().carries_surface() => {
                ("max_absolute_displacement", Kind::Length, scales.length)
            }
            "energy_in" | "damper_work" if machine.has_damped_foot() => return None,
            "energy_in" => ("energy_in", Kind::Energy, scales.force * scales.length),
            "energy_out" => ("energy_out", Kind::Energy, scales.force * scales.length),
            "damper_work" => ("damper_energy_per_cycle", Kind::Energy, scales.force * scales.length),
            "distance" => ("distance", Kind::Length, scales.length),
            "rest_position" => ("rest_position", Kind::Length, scales.length),
            "periods" => ("followed_for", Kind::Time, turn),
            _ => return None,
        })
    });
    record
}
