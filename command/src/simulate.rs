//! `stickslip simulate`.

mod drifting;
mod extent;
mod rows;
mod shaped;

use crate::args::{Header, ShapeArg, SimulateArgs, StreamFormat};
use crate::bits::{Value, at_bits};
use crate::failure::Outcome;
use crate::input;
use crate::interrupt;
use crate::output::PendingFile;
use crate::physical::Physical;
use crate::progress;
use crate::row::{Cell, Cells, Row};
use crate::sink::Sink;
use crate::steady::of_motion;
use core::ops::ControlFlow;
use extent::{Extent, Spacing, at_phase};
use indicatif::ProgressDrawTarget;
use std::io::{IsTerminal, Write, stdout};
use stickslip::Error;
use stickslip::motion::{DrivePhase, End, Instant, Kind, Segment, Trajectory};
use stickslip_front::inputs::units::System;
use stickslip_front::inputs::{Driven, Given, Input};

pub(crate) fn run(args: &SimulateArgs, out: &mut impl Write) -> Outcome {
    at_bits!(args.bits, follow(args: &SimulateArgs, out))
}

fn follow<F: Value>(args: &SimulateArgs, out: &mut impl Write) -> Outcome {
    let format = args.format()?;
    match &args.out {
        None if format == StreamFormat::Parquet => {
            Err("--format parquet: give its file by --out FILE".into())
        }
        None => write::<F>(args, format, out),
        Some(file) => {
            let argument = format!("--out {}", file.display());
            PendingFile::create(file, &argument, args.overwrite)?.fill(|out| write::<F>(args, format, out))
        }
    }
}

fn write<F: Value>(args: &SimulateArgs, format: StreamFormat, out: &mut impl Write) -> Outcome {
    let mut sink = Sink::new(format, out, Header::Names)?;
    let reader = args.units.reader();
    if let Some(shape) = args.shape.filter(|shape| *shape != ShapeArg::Sine) {
        shaped::write::<F>(args, shape, &mut sink, &reader)?;
        return sink.finish();
    }
    let of_shapes = [
        ("--rise", args.rise.is_some()),
        ("--speed", args.speed.is_some()),
        ("--slope", args.surface.slope.is_some()),
        ("--one-way", args.surface.one_way),
    ];
    if let Some((option, _)) = of_shapes.into_iter().find(|(_, is_typed)| *is_typed) {
        return Err(format!("{option}: needs --shape step, ramp, pull or free").into());
    }
    if let Some(given) = crate::drifting::asked(&args.machine, &reader)? {
        drifting::write(args, &given, &mut sink, &reader)?;
        return sink.finish();
    }
    let given = input::read::<F>(&args.machine, &reader)?;
    let mut given = input::with_any_mass(&given).into_owned();
    if given.get(Input::Alpha) == Some(F::int(0)) {
        given.set(Input::Alpha, Given::<F>::nothing());
    }
    let point = input::point(&given)?;
    let extent = Extent::new::<F>(args, point.machine.as_ref(), &reader)?;
    extent.refuse_years(point.ratios.omega().to_f64())?;
    let start = input::start(&args.start, &given, point.machine.as_ref(), &reader)?;
    let start = at_phase(start, args.phase.as_deref(), &reader)?;
    let (has_friction, has_spring) = (!given.is_without_friction(), !given.is_without_spring());
    let in_units = |row: Row| row.in_units_of(has_friction, has_spring);
    let motion = Trajectory::new(point.ratios, start).map_err(|e| of_motion(&given, e))?;
    let machine = point.machine.as_ref();
    let bar = progress::bar(extent.cycles(), "cycles");
    if stdout().is_terminal() {
        bar.set_draw_target(ProgressDrawTarget::hidden());
    }
    let mut shown = 0;
    let mut tick = |cycle: i64| {
        if cycle != shown {
            shown = cycle;
            bar.set_position(u64::try_from(cycle).unwrap_or(0));
        }
    };
    let outcome = match extent.spacing {
        None => stream(&mut sink, motion, |phase| {
            let begins = phase.start().phase;
            tick(begins.cycles());
            extent
                .contains(begins, start.phase)
                .then(|| in_units(of_phase(&phase, start.phase, given.system, machine)))
        }),
        Some(spacing) => {
            let mut samples = match spacing {
                Spacing::PerCycle(n) => motion
                    .samples(u32::try_from(n).unwrap_or(u32::MAX))
                    .map_err(|e| format!("--samples {n}: {e}"))?,
                Spacing::Turns(turns) => {
                    motion.samples_every(F::from_f64(turns)).map_err(|e| of_motion(&given, e))?
                }
            };
            if args.phase.is_some() {
                samples = samples.from_start();
            }
            let mut left = extent.rows(spacing);
            let heard = || interrupt::check().map_or(ControlFlow::Break(()), ControlFlow::Continue);
            let samples = core::iter::from_fn(|| samples.next_while(heard));
            stream(&mut sink, samples, |instant| {
                tick(instant.state.phase.cycles());
                left = left.checked_sub(1)?;
                Some(in_units(of_instant(&instant, start.phase, given.system, machine)))
            })
        }
    };
    bar.finish_and_clear();
    sink.finish()?;
    outcome
}

/// Writes the records until there are no more.
fn stream<T>(
    sink: &mut Sink<impl Write>,
    items: impl Iterator<Item = Result<T, Error>>,
    mut record: impl FnMut(T) -> Option<Row>,
) -> Outcome {
    for item in items {
        let Some(record) = record(item?) else { break };
        sink.write(&record.finite()?)?;
        interrupt::check()?;
    }
    Ok(())
}

/// The whole cycles and the angle of a phase, as cells.
fn when<F: Value>(phase: DrivePhase<F>) -> (Cell<F>, Cell<F>) {
    (Cell::Count(u64::try_from(phase.cycles()).ok()), Cell::Number(Some(phase.reduced())))
}

/// The time of a phase since the start, in the machine's units.
fn time<F: Value>(phase: DrivePhase<F>, start: DrivePhase<F>, machine: &Driven<F>) -> F {
    let cycles = F::from_f64(phase.cycles() as f64);
    (F::int(2) * F::pi() * cycles + phase.reduced() - start.reduced()) * machine.scales.time
}

fn of_phase<F: Value>(
    phase: &Segment<F>,
    origin: DrivePhase<F>,
    system: System,
    machine: Option<&Driven<F>>,
) -> Row {
    let kind = match phase.kind {
        Kind::SlideForward => "slide-forward",
        Kind::SlideBackward => "slide-backward",
        Kind::Stick => "stick",
    };
    let ends_by = match phase.ends_by {
        End::Reversal => "reversal",
        End::Stop => "stop",
        End::Grazing => "grazing",
        End::Release => "release",
        End::Never => "never",
    };
    let (start, end) = (phase.start(), phase.end());
    let end_when = end.map_or((Cell::Count(None), Cell::Number(None)), |e| when(e.phase));
    let fields = rows::segment(
        kind,
        ends_by,
        [when(start.phase), end_when],
        [phase.duration(), Some(start.x), Some(start.v), end.map(|e| e.x)],
    );
    let physical = machine.map_or_else(Physical::default, |machine| {
        let scales = &machine.scales;
        let time = |phase| time(phase, origin, machine);
        rows::segment_in_units(
            system,
            [Some(time(start.phase)), end.map(|e| time(e.phase))],
            [
                Some(start.x * scales.length),
                Some(start.v * scales.velocity),
                end.map(|e| e.x * scales.length),
            ],
        )
    });
    Cells::of(fields).with_physical(physical).shown()
}

fn of_instant<F: Value>(
    instant: &Instant<F>,
    origin: DrivePhase<F>,
    system: System,
    machine: Option<&Driven<F>>,
) -> Row {
    let state = instant.state;
    let friction = instant.friction;
    let fields = rows::sample(when(state.phase), [state.x, state.v, friction, friction + state.x].map(Some));
    let physical = machine.map_or_else(Physical::default, |machine| {
        let scales = &machine.scales;
        let acceleration = scales.velocity / scales.time;
        rows::sample_in_units(
            system,
            [
                time(state.phase, origin, machine),
                state.x * scales.length,
                state.v * scales.velocity,
                instant.acceleration * acceleration,
            ],
            Some(friction * scales.force + scales.mean_friction),
        )
    });
    Cells::of(fields).with_physical(physical).shown()
}
