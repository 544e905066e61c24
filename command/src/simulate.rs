//! `stickslip simulate`.

mod drifting;
mod shaped;

use crate::args::{Header, ShapeArg, SimulateArgs, StreamFormat};
use crate::bits::{Value, at_bits};
use crate::failure::{Failure, Outcome};
use crate::input;
use crate::interrupt;
use crate::output::PendingFile;
use crate::outputs::{DURATION, ENDS_BY, FRICTION, KIND, R, START_CYCLE, START_PHASE, START_V, START_X, key};
use crate::physical::Physical;
use crate::progress;
use crate::row::{Cell, Cells, Row};
use crate::sink::Sink;
use crate::steady::of_motion;
use core::ops::ControlFlow;
use indicatif::ProgressDrawTarget;
use std::f64::consts::TAU;
use std::io::{IsTerminal, Write, stdout};
use stickslip::Error;
use stickslip::motion::{DrivePhase, End, Instant, Kind, Segment, State, Trajectory};
use stickslip_front::inputs::units::{Kind as Quantity, Reader, System};
use stickslip_front::inputs::{Driven, Given, Input};

/// The greatest number of segments or samples of a run: hours at some millions per second.
const MOST_ROWS: f64 = 1e10;

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

/// The start at the phase of `--phase`.
fn at_phase<F: Value>(start: State<F>, phase: Option<&str>, reader: &Reader) -> Result<State<F>, Failure> {
    let Some(text) = phase else { return Ok(start) };
    let phase = reader.value::<F>("--phase", text, Quantity::Angle)?;
    if phase != F::int(0) && !Reader::has_unit(text) {
        return Err(format!("--phase {text}: must have a unit, {text}deg or {text}rad").into());
    }
    // A phase is one of a turn.
    let turn = F::int(2) * F::pi();
    if phase < F::int(0) || phase >= turn {
        return Err(format!("--phase {text}: must be ≥ 0 and < 360deg").into());
    }
    State::new(phase, start.x, start.v).map_err(|e| format!("--phase {text}: {e}").into())
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

/// The distance of samples: so many in a cycle, or turns of the drive from one to the next.
#[derive(Debug, Clone, Copy)]
enum Spacing {
    PerCycle(u64),
    Turns(f64),
}

/// How far the motion is followed.
struct Extent {
    /// The turns of the drive.
    turns: f64,
    /// The arguments as typed.
    typed: String,
    spacing: Option<Spacing>,
}

impl Extent {
    fn new<F: Value>(
        args: &SimulateArgs,
        machine: Option<&Driven<F>>,
        reader: &Reader,
    ) -> Result<Self, Failure> {
        // The used options make sure that there is a machine where times are given.
        let per_time = machine.map_or(1.0, |m| 1.0 / m.scales.time.to_f64() / TAU);
        let positive = |name: &str, text: &str, kind: Quantity| -> Result<f64, Failure> {
            let value = reader.value::<f64>(name, text, kind)?;
            if value > 0.0 && value.is_finite() {
                return Ok(value);
            }
            Err(format!("{name} {text}: must be > 0").into())
        };
        let spacing = match (&args.samples, &args.rate) {
            (Some(count), _) => {
                Some(Spacing::PerCycle(input::count("--samples", count, u64::from(u32::MAX))?))
            }
            (None, Some(rate)) => {
                Some(Spacing::Turns(per_time / (positive("--rate", rate, Quantity::Frequency)? / TAU)))
            }
            (None, None) => None,
        };
        let (turns, typed) = match (&args.cycles, &args.duration) {
            (_, Some(text)) => {
                (positive("--duration", text, Quantity::Time)? * per_time, format!("--duration {text}"))
            }
            (cycles, None) => {
                let missing = || Failure::Input("--cycles is missing, or --duration".to_owned());
                let text = cycles.as_deref().ok_or_else(missing)?;
                let cycles = input::count("--cycles", text, MOST_ROWS as u64)?;
                (cycles as f64, format!("--cycles {cycles}"))
            }
        };
        let typed = args.rate.as_ref().map_or(typed.clone(), |rate| format!("{typed} --rate {rate}"));
        Ok(Self { turns, typed, spacing })
    }

    /// Whole cycles, the last one begun.
    fn cycles(&self) -> u64 {
        self.turns.ceil() as u64
    }

    /// The number of samples; the end is included.
    fn rows(&self, spacing: Spacing) -> u64 {
        let per_turn = match spacing {
            Spacing::PerCycle(n) => n as f64,
            Spacing::Turns(turns) => 1.0 / turns,
        };
        // A count that is whole but for rounding is whole.
        ((self.turns * per_turn * (1.0 + 4.0 * f64::EPSILON)).floor() as u64).saturating_add(1)
    }

    /// Refuses a simulation that would take years. A slide is no longer than half a turn of the drive or of the
    /// body, so that a cycle has about 2 + 2/Ω slides.
    fn refuse_years(&self, omega: f64) -> Outcome {
        let (typed, slides) = (&self.typed, self.cycles() as f64 * (2.0 + 2.0 / omega));
        let rows = self.spacing.map(|spacing| (spacing, self.rows(spacing) as f64));
        let (argument, count, things) = match rows {
            Some((Spacing::PerCycle(n), rows)) if rows > MOST_ROWS + 1.0 => {
                (format!("{typed} --samples {n}"), rows - 1.0, "rows")
            }
            Some((Spacing::Turns(_), rows)) if rows > MOST_ROWS + 1.0 => (typed.clone(), rows, "rows"),
            _ if slides <= MOST_ROWS => return Ok(()),
            Some(_) => (typed.clone(), slides, "slides"),
            None => (typed.clone(), slides, "rows"),
        };
        Err(format!("{argument}: about {count:.1e} {things} at Ω = {omega}, must be ≤ {MOST_ROWS:.0e}")
            .into())
    }

    /// Whether a segment that begins at this phase is shown.
    fn contains<F: Value>(&self, phase: DrivePhase<F>, start: DrivePhase<F>) -> bool {
        phase.since(start).to_f64() / TAU < self.turns
    }
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
    let (start_cycle, start_phase) = when(start.phase);
    let (end_cycle, end_phase) = end.map_or((Cell::Count(None), Cell::Number(None)), |e| when(e.phase));
    let number = |x: F| Cell::Number(Some(x));
    let fields = vec![
        (KIND, Cell::Text(kind)),
        (ENDS_BY, Cell::Text(ends_by)),
        (START_CYCLE, start_cycle),
        (START_PHASE, start_phase),
        (key!("end_cycle"), end_cycle),
        (key!("end_phase"), end_phase),
        (DURATION, Cell::Number(phase.duration())),
        (START_X, number(start.x)),
        (START_V, number(start.v)),
        (key!("end_x"), Cell::Number(end.map(|e| e.x))),
    ];
    let physical = machine.map_or_else(Physical::default, |machine| {
        let scales = &machine.scales;
        Physical::beside(
            system,
            vec![
                ("start_time", Quantity::Time, number(time(start.phase, origin, machine))),
                ("end_time", Quantity::Time, Cell::Number(end.map(|e| time(e.phase, origin, machine)))),
                ("start_displacement", Quantity::Length, number(start.x * scales.length)),
                ("start_velocity", Quantity::Velocity, number(start.v * scales.velocity)),
                ("end_displacement", Quantity::Length, Cell::Number(end.map(|e| e.x * scales.length))),
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
    let (cycle, phase) = when(state.phase);
    let number = |x: F| Cell::Number(Some(x));
    let fields = vec![
        (key!("cycle"), cycle),
        (key!("phase"), phase),
        (key!("x"), number(state.x)),
        (key!("v"), number(state.v)),
        (FRICTION, number(instant.friction)),
        (R, number(instant.friction + instant.state.x)),
    ];
    let physical = machine.map_or_else(Physical::default, |machine| {
        let scales = &machine.scales;
        let friction = instant.friction * scales.force + scales.mean_friction;
        let acceleration = scales.velocity / scales.time;
        Physical::beside(
            system,
            vec![
                ("time", Quantity::Time, number(time(state.phase, origin, machine))),
                ("displacement", Quantity::Length, number(state.x * scales.length)),
                ("velocity", Quantity::Velocity, number(state.v * scales.velocity)),
                ("acceleration", Quantity::Acceleration, number(instant.acceleration * acceleration)),
                ("friction_force", Quantity::Force, number(friction)),
            ],
        )
    });
    Cells::of(fields).with_physical(physical).shown()
}

#[cfg(test)]
mod tests {
    use super::{Extent, Spacing};

    /// The limit is ten thousand million rows or slides; a cycle has 2 + 2/Ω slides.
    #[test]
    fn a_run_of_years_is_refused() {
        for (cycles, samples, omega, words) in [
            (1_666_666_666_u32, None, 0.5, None),
            (1_666_666_667, None, 0.5, Some("rows")),
            (2_500_000_000, None, 1.0, None),
            (2_500_000_001, None, 1.0, Some("rows")),
            (4_000_000_000, None, 4.0, None),
            (4_000_000_001, None, 4.0, Some("rows")),
            (100_000_000, Some(100), 1.0, None),
            (100_000_001, Some(100), 1.0, Some("rows")),
            (2_500_000_001, Some(1), 1.0, Some("slides")),
            (2_500_000_000, Some(1), 1.0, None),
        ] {
            let spacing = samples.map(Spacing::PerCycle);
            let extent = Extent { turns: f64::from(cycles), typed: String::new(), spacing };
            let found = extent.refuse_years(omega).err().map(|failure| failure.to_string());
            match words {
                None => assert!(found.is_none(), "{cycles} {samples:?} {omega}: {found:?}"),
                Some(words) => {
                    assert!(found.as_ref().is_some_and(|f| f.contains(words)), "{cycles}: {found:?}")
                }
            }
        }
    }
}
