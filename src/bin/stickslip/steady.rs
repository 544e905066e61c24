//! `stickslip steady`.

use crate::args::{Format, SteadyArgs};
use crate::bits::{self, Task, Value};
use crate::enclose;
use crate::failure::{Failure, Outcome};
use crate::given::{Given, Parameter};
use crate::input::{self, Point};
use crate::machine::{Machine, base_motion, transmitted};
use crate::note::{both, decay, digits};
use crate::physical::Physical;
use crate::points;
use crate::record::{Cell, Record};
use crate::response::single_format;
use crate::style;
use std::io::{self, Write};
use stickslip::exact::{Irregular, LongRun, Peaks, State, SteadyState};
use stickslip::regime::{Observed, observed};
use stickslip::units::{Kind, System};
use stickslip::{Error, Quantity, Ratios, Regime};

/// The command with its arguments and where its answer goes.
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
            let start = input::start(&args.start, point.machine.as_ref(), &reader)?;
            answer(given, point, start, args.max_periods, true)
        };
        if let Some(file) = &args.output.points {
            let (used, ratios) = (&Parameter::ALL, &[Parameter::Omega, Parameter::Alpha]);
            let asked = points::Asked { file, output: &args.output, reader: &reader, given, used, ratios };
            return points::run(asked, out, |given| {
                answer(given, &input::point(given)?).map(|(_, record)| record)
            });
        }
        let point = input::point(&given)?;
        let (limit, record) = answer(&given, &point)?;
        match args.output.format.unwrap_or(Format::Text) {
            Format::Text => Ok(note(&point, &limit, &given.system, out)?),
            Format::Json => record.write_pretty(out),
            Format::Jsonl | Format::Csv => Err(single_format()),
        }
    }
}

/// The long run from a start, and its record.
pub(crate) fn answer<F: Value>(
    given: &Given<F>,
    point: &Point<F>,
    start: State<F>,
    max_periods: u32,
    peaks: bool,
) -> Result<(LongRun<F>, Record<F>), Failure> {
    let limit = LongRun::within(point.ratios, start, max_periods).map_err(|e| of_motion(given, e))?;
    let record = record(point.ratios, &limit, peaks).map_err(|e| given.at_fault(e))?;
    let zeta = point.ratios.damping_ratio();
    let record = if given.has_damper() {
        let mut record = record.with_damping_ratio(zeta);
        let work = limit.steady_state().map(SteadyState::damper_work);
        record.fields.push(("damper_work", Cell::Number(work)));
        record
    } else {
        record
    };
    let record = if given.has_static_friction() {
        with_static_friction(record, &point.ratios, &limit)
    } else {
        record
    };
    let record = match &point.machine {
        Some(machine) => with_machine(record, machine).finite().map_err(|e| given.behind_all(e))?,
        None => record,
    };
    Ok((limit, record))
}

/// The record with η, and with what only a static friction above the kinetic one brings about.
fn with_static_friction<F: Value>(record: Record<F>, ratios: &Ratios<F>, limit: &LongRun<F>) -> Record<F> {
    let mut record = record.with_static_friction_ratio(ratios.static_friction_ratio());
    let steady = limit.steady_state();
    let irregular = limit.irregular();
    let number = |value: fn(&Irregular<F>) -> F| Cell::Number(irregular.map(value));
    let symmetric = steady.map_or("", |s| if s.is_symmetric() { "yes" } else { "no" });
    let extrema = limit.extrema();
    for (name, cell) in &mut record.fields {
        match *name {
            "max_displacement" => *cell = Cell::Number(extrema.map(|(_, most)| most)),
            "min_displacement" => *cell = Cell::Number(extrema.map(|(least, _)| least)),
            _ => {}
        }
    }
    record.fields.extend([
        ("turns_per_cycle", Cell::Count(steady.map(|s| u64::from(s.turns_per_cycle())))),
        ("symmetric", Cell::Text(symmetric)),
        ("lyapunov_exponent", number(|m| m.lyapunov_exponent())),
        ("lyapunov_exponent_error", number(|m| m.lyapunov_exponent_error())),
        ("turns_observed", Cell::Count(irregular.map(Irregular::turns))),
    ]);
    record
}

/// The failure behind the argument that the exact motion cannot be followed with.
pub(crate) fn of_motion<F: Value>(given: &Given<F>, error: Error) -> Failure {
    if matches!(error.quantity(), Some(Quantity::DampingRatio | Quantity::StaticFrictionRatio)) {
        return given.at_fault(error);
    }
    Failure::Input(format!("--omega or --frequency: {error}"))
}

/// All outputs of a steady state; the peaks where they are asked for.
fn record<F: Value>(ratios: Ratios<F>, limit: &LongRun<F>, peaks: bool) -> Result<Record<F>, Error> {
    let steady = limit.steady_state();
    let number = |value: fn(&SteadyState<F>) -> F| Cell::Number(steady.map(value));
    let count = |value: fn(&SteadyState<F>) -> u32| Cell::Count(steady.map(|s| u64::from(value(s))));
    let errors = steady.map(SteadyState::errors).transpose()?;
    let peaks = steady.filter(|_| peaks).map(SteadyState::peaks).transpose()?;
    let seen = observed(ratios, limit);
    let (regime, kind) = (seen.regime.name(), limit.name());
    let larger = |a: F, b: F| if a > b { a } else { b };
    let amplitude = steady.map(|s| larger(s.max_displacement().abs(), s.min_displacement().abs()));
    Ok(Record {
        fields: vec![
            ("omega", Cell::Number(Some(ratios.omega()))),
            ("alpha", Cell::Number(Some(ratios.alpha()))),
            ("regime", Cell::Text(regime)),
            ("limit", Cell::Text(kind)),
            ("max_displacement", number(|s| s.max_displacement())),
            ("max_displacement_phase", number(|s| s.max_displacement_phase())),
            ("min_displacement", number(|s| s.min_displacement())),
            ("min_displacement_phase", number(|s| s.min_displacement_phase())),
            ("max_velocity", number(|s| s.max_velocity())),
            ("max_velocity_phase", number(|s| s.max_velocity_phase())),
            ("min_velocity", number(|s| s.min_velocity())),
            ("min_velocity_phase", number(|s| s.min_velocity_phase())),
            ("sticks_per_cycle", Cell::Count(seen.sticks.map(u64::from))),
            ("velocity_zeros_per_cycle", count(|s| s.velocity_zeros_per_cycle())),
            ("stick_fraction", number(|s| s.stick_fraction())),
            ("error_1", Cell::Number(errors.map(|e| e.error_1))),
            ("error_2", Cell::Number(errors.map(|e| e.error_2))),
            ("error_3", Cell::Number(errors.map(|e| e.error_3))),
            ("error_4", Cell::Number(errors.map(|e| e.error_4))),
            ("energy_in", number(|s| s.energy_in())),
            ("energy_out", number(|s| s.energy_out())),
            ("multipliers", Cell::Pairs(steady.map(SteadyState::multipliers))),
            ("distance", number(|s| s.distance().0)),
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

/// With the machine and the answer in its units.
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

/// The answer as an engineer's note.
fn note<F: Value>(
    point: &Point<F>,
    limit: &LongRun<F>,
    units: &System,
    out: &mut impl Write,
) -> io::Result<()> {
    let scales = point.machine.as_ref().map(|m| &m.scales);
    let length = |x| both(x, "B", scales.map(|s| s.length), units.length());
    let seen = observed(point.ratios, limit);
    if let Some(base) = point.machine.as_ref().and_then(|m| base_motion(m.drive.excitation())) {
        writeln!(out, "Base motion {base}.")?;
    }
    match limit {
        LongRun::Periodic(steady) => {
            let verdict = style::verdict(&verdict(steady, &seen));
            writeln!(out, "{verdict} {}\n", from_where(point, steady))?;
            motion(steady, point, units, out)
        }
        LongRun::Family(steady) => {
            writeln!(
                out,
                "{} At Ω = 1/(2n) the periodic motions are a family; this is the one that the start leads to.\n",
                style::verdict(&verdict(steady, &seen))
            )?;
            motion(steady, point, units, out)
        }
        LongRun::Rest(rest) => {
            let place = length(rest.position);
            let sentence = match rest.slides {
                Some(0) => format!("Stuck: the body never moves from {place}."),
                Some(1) => format!("Stuck: the body comes to rest at {place} after one slide."),
                Some(slides) => format!("Stuck: the body comes to rest at {place} after {slides} slides."),
                None => format!("Stuck: the body creeps towards rest at {place} for ever."),
            };
            writeln!(out, "{}", style::verdict(&sentence))
        }
        LongRun::Irregular(found) => {
            let turns = found.turns();
            let sentence = format!(
                "Irregular: the motion from this start did not repeat itself in {turns} turns of the drive."
            );
            writeln!(out, "{}\n", style::verdict(&sentence))?;
            writeln!(out, "  greatest displacement    {}", length(found.max_displacement()))?;
            writeln!(out, "  least displacement       {}", length(found.min_displacement()))?;
            let (exponent, error) = (found.lyapunov_exponent(), found.lyapunov_exponent_error());
            writeln!(
                out,
                "  Lyapunov exponent        {} a turn, ± {:.1e}",
                digits(exponent),
                error.to_f64()
            )?;
            writeln!(out, "  stops                    {}", found.stops())
        }
        LongRun::Unbounded { growth } => {
            let growth = length(*growth);
            let sentence = format!("Unbounded: the amplitude grows by {growth} in a cycle, in the long run.");
            writeln!(out, "{}", style::verdict(&sentence))
        }
        LongRun::NotConverged { residual, periods, .. } => {
            let (periods, left) = (digits(periods.to_f64()), length(*residual));
            let sentence = format!(
                "Undecided: after {periods} periods half a cycle still moves it by {left}; allow more with --max-periods. By the borders its limit is {}.",
                seen.regime.name()
            );
            writeln!(out, "{}", style::verdict(&sentence))
        }
    }
}

/// From which starts the motion comes, and what there is to say of its cycle.
fn from_where<F: Value>(point: &Point<F>, steady: &SteadyState<F>) -> String {
    if !point.ratios.has_higher_static_friction() {
        return "One periodic motion, from every start.".to_owned();
    }
    let cycle = match steady.turns_per_cycle() {
        1 => String::new(),
        turns => format!(" A cycle takes {turns} turns of the drive."),
    };
    let symmetry = if steady.is_symmetric() {
        ""
    } else {
        " It is not symmetric: its mirror image is a motion from other starts."
    };
    format!("The limit of this start; others can have another.{cycle}{symmetry}")
}

fn verdict<F: Value>(steady: &SteadyState<F>, seen: &Observed) -> String {
    match seen.sticks.unwrap_or_default() {
        0 if seen.regime == Regime::Sticking => {
            "Sticking: α is so close below the border that the stops are too short for this arithmetic."
                .to_owned()
        }
        0 => match seen.reversals {
            Some(n) if n > 2 => format!("Non-sticking: the body never stops; it reverses {n} times a cycle."),
            Some(_) | None => "Non-sticking: the body never stops.".to_owned(),
        },
        n => {
            let part = digits((steady.stick_fraction().to_f64() * 1e4).round() / 1e2);
            format!("Sticking: {n} stops in a cycle, {part} % of the time.")
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
    writeln!(out, "  maximum displacement     {}", length(steady.max_displacement()))?;
    writeln!(out, "    at ω_d t               {}", phase(steady.max_displacement_phase()))?;
    writeln!(out, "  minimum displacement     {}", length(steady.min_displacement()))?;
    writeln!(out, "    at ω_d t               {}", phase(steady.min_displacement_phase()))?;
    writeln!(out, "  maximum velocity         {}", speed(steady.max_velocity()))?;
    writeln!(out, "    at ω_d t               {}", phase(steady.max_velocity_phase()))?;
    writeln!(out, "  minimum velocity         {}", speed(steady.min_velocity()))?;
    writeln!(out, "    at ω_d t               {}", phase(steady.min_velocity_phase()))?;
    if let Ok(found) = steady.peaks() {
        peaks(&found, point, units, out)?;
    }
    writeln!(out, "  velocity zeros in a cycle {}", steady.velocity_zeros_per_cycle())?;
    writeln!(out, "  work of the drive        {}", work(steady.energy_in()))?;
    writeln!(out, "  work against friction    {}", work(steady.energy_out()))?;
    if steady.damper_work() > F::int(0) {
        writeln!(out, "  work against the damper  {}", work(steady.damper_work()))?;
    }
    writeln!(out, "  a disturbance            {}", decay(steady.contraction(), "a cycle"))?;
    let far = format!("{:.0e}", steady.distance().0.to_f64());
    let periods = digits(steady.periods().to_f64());
    writeln!(out, "  found in {periods} periods, within {far} B of the limit")
}

/// What the machine feels: acceleration, transmitted force, and under a base that carries the surface the
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
    let (machine, at) = (point.machine.as_ref(), (point.ratios.omega(), point.ratios.alpha()));
    let (force, ratio) = transmitted(machine, at, peaks.transmitted_force, peaks.acceleration);
    writeln!(
        out,
        "  transmitted force        {}",
        both(force, "r_y", scales.map(|s| s.force), units.force())
    )?;
    let unit = if machine.is_some_and(|m| m.drive.excitation().moves_foot()) { "" } else { " p₀" };
    writeln!(out, "  transmissibility         {}{unit}", digits(ratio))?;
    if point.machine.as_ref().is_some_and(|m| m.drive.excitation().carries_surface()) {
        let absolute = both(peaks.absolute_displacement, "B", scales.map(|s| s.length), units.length());
        writeln!(out, "  absolute displacement    {absolute}")?;
    }
    Ok(())
}
