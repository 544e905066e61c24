//! `stickslip record`: the motion of a body under a record.

use crate::args::{RecordArgs, SurfaceArgs};
use crate::bits::{Value, at_bits, digits};
use crate::enclose;
use crate::failure::{Failure, Outcome};
use crate::figure::Target;
use crate::given;
use crate::measured;
use crate::output::{self, PendingFile};
use crate::physical::Physical;
use crate::record::Cell;
use std::io::Write;
use std::path::Path;
use stickslip::inputs::units::{Kind, Reader, System};
use stickslip::inputs::{Given, Input, Role};
use stickslip::motion::record::{Body, Entry, Record, RecordAnswer, RecordMotion};
use stickslip_figures::{Axis, Figure, Panel, Series, Style};

pub(crate) fn run(args: &RecordArgs, out: &mut impl Write) -> Outcome {
    if args.enclose {
        return enclose::record(args, out);
    }
    at_bits!(args.bits, follow(args: &RecordArgs, out))
}

fn follow<F: Value>(args: &RecordArgs, out: &mut impl Write) -> Outcome {
    args.look.needs("--picture", args.picture.as_deref())?;
    if let Some(file) = &args.out {
        output::refuse_existing(file, &format!("--out {}", file.display()), args.overwrite)?;
    }
    let target = Target::new("--picture", args.picture.as_deref(), args.overwrite, &args.look)?;
    let interval = args.interval.as_ref();
    let interval = interval.map(|text| args.units.reader().value::<F>("--interval", text, Kind::Time));
    let interval = interval.transpose()?;
    if args.interval.is_some() && args.out.is_none() {
        return Err("--interval: needs a file for the motion, --out FILE.csv".into());
    }
    let Shaken { given, body, record, start: [x0, v0] } = Shaken::read(args)?;
    let named = |e: stickslip::Error| Failure::Input(format!("{}: {e}", args.file.display()));
    let answer = body.follow_from(&record, x0, v0).map_err(named)?;
    let motion = |interval: F| body.motion(&record, x0, v0, interval).map_err(named);
    if let Some(file) = &args.out {
        let motion = motion(interval.unwrap_or_else(|| record.longest_step()))?;
        let argument = format!("--out {}", file.display());
        PendingFile::create(file, &argument, args.overwrite)?
            .fill(|out| states(&motion, &given.system, out))?;
    }
    if args.picture.is_some() {
        let motion = motion((record.end() - record.time(0)) / F::int(4000))?;
        let machine = given::line(&args.machine, |_| true, &given.system);
        target.draw(out, || Ok(drawing(&record, &motion, &given.system, &args.file, &machine)))?;
    }
    let physical = physical(&answer, given.system);
    for (name, _, cell) in &physical.values {
        cell.finite(name)?;
    }
    if args.format.is_json("record")? {
        return output::json(&physical, out);
    }
    text(&answer, &physical, &given.system, out)
}

/// The body, the record and the start of a motion.
pub(crate) struct Shaken<F> {
    pub(crate) given: Given<F>,
    pub(crate) body: Body<F>,
    pub(crate) record: Record<F>,
    pub(crate) start: [F; 2],
}

impl<F: Value> Shaken<F> {
    pub(crate) fn read(args: &RecordArgs) -> Result<Self, Failure> {
        args.format.is_json("record")?;
        let reader = args.units.reader();
        let given = given::read::<F>(&args.machine, &reader)?;
        let body = Surface::read(&args.surface, &reader)?.body(&given)?;
        let start = |option: &str, text: &Option<String>, kind: Kind| match text {
            Some(text) => reader.value::<F>(option, text, kind),
            None => Ok(F::int(0)),
        };
        let start = [start("--x0", &args.x0, Kind::Length)?, start("--v0", &args.v0, Kind::Velocity)?];
        let record = measured::read::<F>(&args.file, &args.load, &reader)?;
        Ok(Self { given, body, record, start })
    }
}

/// The surface that a body slides on.
pub(crate) struct Surface<F> {
    slope: Option<F>,
    has_spring: bool,
    is_one_way: bool,
}

impl<F: Value> Surface<F> {
    pub(crate) fn read(args: &SurfaceArgs, reader: &Reader) -> Result<Self, Failure> {
        let slope = args.slope.as_ref().map(|text| reader.value::<F>("--slope", text, Kind::Angle));
        Ok(Self { slope: slope.transpose()?, has_spring: !args.no_spring, is_one_way: args.one_way })
    }

    /// The body of the given inputs on this surface.
    pub(crate) fn body(&self, given: &Given<F>) -> Result<Body<F>, Failure> {
        match (given.one_of(Role::Spring)?, self.has_spring) {
            (None, true) => {
                let missing = given.missing(&Input::of_role(Role::Spring));
                return Err(format!("{missing}. A body without a spring has --no-spring").into());
            }
            (Some((spring, _)), false) => {
                let spring = given.label(spring);
                return Err(format!("{spring}: must be left out with --no-spring").into());
            }
            _ => {}
        }
        let body = Body::given(given, self.slope)?;
        Ok(if self.is_one_way { body.one_way() } else { body })
    }
}

/// The answers with their units.
pub(crate) fn physical<F: Value>(answer: &RecordAnswer<F>, system: System) -> Physical<F> {
    let mut physical = Physical::of(system);
    physical.values = columns(answer).into();
    physical
}

/// The answers as cells.
pub(crate) fn columns<F: Value>(answer: &RecordAnswer<F>) -> [(&'static str, Kind, Cell<F>); 20] {
    answer.entries().map(|(name, kind, entry)| {
        let cell = match entry {
            Entry::Value(value) => Cell::Number(value.copied()),
            Entry::Count(count) => Cell::Count(Some(count)),
        };
        (name, kind, cell)
    })
}

fn text<F: Value>(
    answer: &RecordAnswer<F>,
    physical: &Physical<F>,
    system: &System,
    out: &mut impl Write,
) -> Outcome {
    let unit = |kind: Kind| system.name(kind);
    let times = |n: u64| if n == 1 { "once".to_owned() } else { format!("{n} times") };
    let slides = times(answer.slides);
    match answer.residual_displacement {
        _ if answer.slides == 0 => writeln!(out, "The body rests throughout.\n")?,
        Some(rest) => writeln!(
            out,
            "The body slides {slides}, and comes to rest at {} {}.\n",
            digits(rest),
            unit(Kind::Length)
        )?,
        None => writeln!(out, "The body slides {slides}, and does not come to rest.\n")?,
    }
    for (name, kind, cell) in &physical.values {
        let unit = if *kind == Kind::Ratio { String::new() } else { format!(" {}", unit(*kind)) };
        writeln!(out, "  {:<26} {}{unit}", name.replace('_', " "), cell.text())?;
    }
    Ok(())
}

/// The states of a motion as CSV.
fn states<F: Value>(motion: &RecordMotion<F>, system: &System, out: &mut impl Write) -> Outcome {
    let [length, velocity, acceleration] = [Kind::Length, Kind::Velocity, Kind::Acceleration]
        .map(|kind| crate::outputs::plain(&system.name(kind)));
    let mut table = csv::Writer::from_writer(out);
    table.write_record([
        "time[s]",
        &format!("displacement[{length}]"),
        &format!("velocity[{velocity}]"),
        &format!("acceleration[{acceleration}]"),
        "direction",
    ])?;
    for state in &motion.states {
        let numbers = [state.time, state.displacement, state.velocity, state.acceleration];
        let [time, x, v, a] = numbers.map(crate::bits::all_digits);
        table.write_record([time, x, v, a, state.direction.to_string()])?;
    }
    Ok(table.flush()?)
}

/// The load, the displacement and the velocity over time, and the displacement over the velocity's sign: rests apart.
fn drawing<F: Value>(
    record: &Record<F>,
    motion: &RecordMotion<F>,
    system: &System,
    file: &Path,
    machine: &str,
) -> Figure {
    let load: Vec<_> = record
        .samples()
        .iter()
        .enumerate()
        .map(|(index, sample)| (record.time(index).to_f64(), sample.to_f64()))
        .collect();
    let (name, kind) = match record.excitation() {
        stickslip::Excitation::Force => ("force", Kind::Force),
        stickslip::Excitation::SurfaceAcceleration => ("acceleration of the surface", Kind::Acceleration),
        stickslip::Excitation::Unbalance => ("unbalance", Kind::Unbalance),
        stickslip::Excitation::FootMotion
        | stickslip::Excitation::DampedFootMotion
        | stickslip::Excitation::SurfaceMotion
        | stickslip::Excitation::SurfaceVelocity
        | _ => ("displacement of the foot", Kind::Length),
    };
    let label = |name: &str, kind: Kind| format!("{name} ({})", system.name(kind));
    let of = |value: fn(&stickslip::motion::record::RecordState<F>) -> F, rests: bool| {
        let states = motion.states.iter();
        let mut points: Vec<_> = states
            .map(|state| {
                let shown = !rests || state.direction == 0;
                (state.time.to_f64(), if shown { value(state).to_f64() } else { f64::NAN })
            })
            .collect();
        // A rest is drawn to its end, which is the beginning of the next slide.
        if rests {
            for place in 1..points.len() {
                let is_end = motion.states.get(place - 1).is_some_and(|state| state.direction == 0);
                if let (true, Some(point), Some(state)) =
                    (is_end, points.get_mut(place), motion.states.get(place))
                {
                    point.1 = value(state).to_f64();
                }
            }
        }
        points
    };
    let ends = |points: &[(f64, f64)]| {
        let times = points.iter().map(|(time, _)| *time);
        times.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), t| (low.min(t), high.max(t)))
    };
    let displacement = of(|state| state.displacement, false);
    let (first, last) = ends(&displacement);
    let (_, end) = ends(&load);
    let last = last.max(end);
    let panel = |title: &str, y: String, series: Vec<Series>, values: &[(f64, f64)]| {
        Panel::new(
            title,
            Axis::linear("time (s)", first, last),
            crate::motion_plot::axis(&y, values.iter().map(|(_, value)| *value), 0.08),
            series,
        )
    };
    let moving = |value: fn(&stickslip::motion::record::RecordState<F>) -> F| {
        let points = of(value, false);
        let rests = of(value, true);
        let mut series = vec![Series::new("sliding", Style::Line, 2, points)];
        if rests.iter().any(|(_, value)| value.is_finite()) {
            series.push(Series::new("at rest", Style::Thick, 3, rests));
        }
        series
    };
    let velocity = of(|state| state.velocity, false);
    Figure::new(
        "record",
        format!("Motion under {}: {machine}", file.file_name().unwrap_or_default().to_string_lossy()),
        "",
        vec![
            panel(name, label(name, kind), vec![Series::new("", Style::Line, 1, load.clone())], &load),
            panel(
                "displacement",
                label("displacement", Kind::Length),
                moving(|state| state.displacement),
                &displacement,
            ),
            panel("velocity", label("velocity", Kind::Velocity), moving(|state| state.velocity), &velocity),
        ],
    )
}
