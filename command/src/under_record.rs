//! `stickslip record`: the motion of a body under a record.

#[cfg(all(feature = "mp", not(test)))]
mod in_full;

use crate::args::{Header, RecordArgs, StreamFormat};
use crate::bits::{Value, at_bits, digits};
use crate::enclose;
use crate::failure::{Failure, Outcome};
use crate::figure::Target;
use crate::floor::FloorSpectrum;
use crate::measured::{self, Described};
use crate::motion_plot;
use crate::output::{self, PendingFile};
use crate::physical::Physical;
use crate::row::{Cell, Cells, Number};
use crate::shaken::{Shaken, needs_mass};
use crate::sink::Sink;
use crate::system::steady_motion;
use crate::{input, interrupt};
use serde::Serialize;
use std::io::Write;
use std::path::Path;
use stickslip::motion::record::{After, Entry, Record, RecordAnswer, RecordMotion, RecordState};
use stickslip_draw::{Axis, Figure, Panel, Series, Style};
use stickslip_front::inputs::units::{Kind, System};
use stickslip_front::system::{Answer, OneBody, Repeated};

pub(crate) fn run(args: &RecordArgs, out: &mut impl Write) -> Outcome {
    if args.enclose && args.repeats {
        let why = "the bounds are those of one pass of the record. More digits of the limit are those of --bits 128";
        return Err(format!("--enclose: must be left out with --repeats: {why}").into());
    }
    if args.enclose {
        return enclose::record(args, out);
    }
    if args.repeats {
        return repeated(args, out);
    }
    at_bits!(args.answer.bits, follow(args: &RecordArgs, out))
}

/// The motion under a record that repeats itself.
fn repeated(args: &RecordArgs, out: &mut impl Write) -> Outcome {
    let files = Files::new(args)?;
    let wide = args.answer.bits.filter(|bits| *bits > f64::MANTISSA_DIGITS);
    if let (Some(bits), true) = (wide, files.are_asked()) {
        let most = f64::MANTISSA_DIGITS;
        return Err(format!("--bits {bits}: must be ≤ {most} with --repeats and --out or --picture").into());
    }
    let shaken = Shaken::<f64>::read(args)?;
    let Shaken { given, body, record, summary, start, has_mass, .. } = &shaken;
    let system = given.system;
    if system.name(Kind::Acceleration) == "g" {
        return Err(
            "--units: must have no g with --repeats, such as kN,mm: its answer has no accelerations".into()
        );
    }
    if !has_mass {
        input::note_unit_mass(&system);
    }
    let one = OneBody::new(body, system, *start, Repeated::Record(record));
    let one = one.map_err(|e| format!("{}: {e}", args.file.display()))?;
    if let Some(bits) = wide {
        #[cfg(all(feature = "mp", not(test)))]
        return in_full::repeated(args, bits, &one.system.described, out);
        #[cfg(any(not(feature = "mp"), test))]
        return crate::bits::without_mp(bits);
    }
    let one = one.while_allowed(interrupt::keep_going);
    let found = one.steady()?;
    if files.are_asked() {
        let named = |e: stickslip::Error| Failure::Input(format!("{}: {e}", args.file.display()));
        let (whole, end) = cycles(record, found.periods).map_err(named)?;
        let [x, v] = [&found.start.displacement, &found.start.velocity].map(|list| list.first().copied());
        let motion = |interval: f64| -> Result<RecordMotion<f64>, stickslip::Error> {
            let mut motion = body.motion(&whole, x.unwrap_or(0.0), v.unwrap_or(0.0), interval)?;
            let within = motion.states.partition_point(|state| state.time < end);
            motion.states.truncate(within.saturating_add(1));
            // A body that rests there does so as long as the load stays.
            motion.states.last_mut().into_iter().for_each(|state| state.time = end);
            Ok(motion)
        };
        let drawn = whole.clone().between(record.time(0), end).map_err(named)?;
        files.write(&shaken, &drawn, |interval| motion(interval).map_err(named), out)?;
    }
    if args.answer.format.is_json("record")? {
        let answer = Answer::steady(&one.system.described, &found);
        return output::json(&Described::repeated(&answer, summary), out);
    }
    writeln!(out, "{}\nIt repeats itself.\n", measured::line(summary))?;
    steady_motion(&one.system, &found, None, out)
}

/// A number of cycles of a record in a row, after which the load stays for as long as a cycle, and the end of the cycles.
fn cycles(record: &Record<f64>, count: usize) -> Result<(Record<f64>, f64), stickslip::Error> {
    let (start, length) = (record.time(0), record.end() - record.time(0));
    let begin = |turn: usize| start + turn as f64 * length;
    let (mut times, mut values): (Vec<f64>, Vec<f64>) = (Vec::new(), Vec::new());
    for turn in 0..count.max(1) {
        for (place, &value) in record.samples().iter().enumerate() {
            // The seam is one sample where both values are equal, and else a step.
            if place == 0 && values.last() == Some(&value) {
                continue;
            }
            let is_last = place.saturating_add(1) == record.samples().len();
            let within = || begin(turn) + (record.time(place) - start);
            times.push(if is_last { begin(turn.saturating_add(1)) } else { within() });
            values.push(value);
        }
    }
    let end = begin(count.max(1));
    times.push(end + length);
    values.extend(values.last().copied());
    Ok((Record::at_times(record.excitation(), times, values)?.followed_by(After::Hold), end))
}

/// The files of a motion that were asked for.
struct Files<'a> {
    args: &'a RecordArgs,
    target: Target<'a>,
}

impl<'a> Files<'a> {
    fn new(args: &'a RecordArgs) -> Result<Self, Failure> {
        args.look.needs("--picture", args.picture.as_deref())?;
        if let Some(file) = &args.out {
            if is_parquet(file) && !cfg!(feature = "parquet") {
                return Err(
                    format!("--out {}: needs a build with the feature parquet", file.display()).into()
                );
            }
            output::refuse_existing(file, &format!("--out {}", file.display()), args.overwrite)?;
        }
        let target = Target::new("--picture", args.picture.as_deref(), args.overwrite, &args.look)?;
        if args.interval.is_some() && args.out.is_none() {
            return Err("--interval: needs a file for the motion, --out FILE.csv".into());
        }
        Ok(Self { args, target })
    }

    const fn are_asked(&self) -> bool {
        self.args.out.is_some() || self.args.picture.is_some()
    }

    /// Writes the motion under a record, whose states are at most an interval apart.
    fn write<F: Value>(
        &self,
        shaken: &Shaken<F>,
        record: &Record<F>,
        motion: impl Fn(F) -> Result<RecordMotion<F>, Failure>,
        out: &mut impl Write,
    ) -> Outcome {
        let Self { args, target } = self;
        let Shaken { given, interval, has_mass, .. } = shaken;
        let system = given.system;
        if let Some(file) = &args.out {
            if let (Some(interval), Some(text)) = (*interval, &args.interval) {
                refuse_many(record, interval, text)?;
            }
            let motion = motion(interval.unwrap_or_else(|| record.longest_step()))?;
            let argument = format!("--out {}", file.display());
            PendingFile::create(file, &argument, args.overwrite)?
                .fill(|out| states(&motion, (system, *has_mass), file, out))?;
        }
        if args.picture.is_some() {
            let motion = motion((record.end() - record.time(0)) / F::int(4000))?;
            let machine = input::line(&args.machine, |_| true, &system);
            target.draw(out, || Ok(drawing(record, &motion, (&system, *has_mass), &args.file, &machine)))?;
        }
        Ok(())
    }
}

fn follow<F: Value>(args: &RecordArgs, out: &mut impl Write) -> Outcome {
    let files = Files::new(args)?;
    let shaken = Shaken::<F>::read(args)?;
    let Shaken { given, body, summary, start: [x0, v0], .. } = &shaken;
    let (system, read) = (given.system, measured::lines(summary, &shaken.record));
    let mirrored = args.both_polarities.then(|| shaken.record.clone().scaled(-F::int(1))).transpose()?;
    let (record, mirrored) = (&shaken.record, mirrored.as_ref());
    let own = Answered::new(args, &shaken, record)?;
    let other = mirrored.map(|mirrored| Answered::new(args, &shaken, mirrored)).transpose()?;
    let peak = |answered: &Answered<F>| answered.answer.peak_displacement;
    let is_other_greater = other.as_ref().is_some_and(|other| peak(other) > peak(&own));
    let shown = if is_other_greater { mirrored.unwrap_or(record) } else { record };
    let named = |e: stickslip::Error| Failure::Input(format!("{}: {e}", args.file.display()));
    files.write(&shaken, shown, |interval| body.motion(shown, *x0, *v0, interval).map_err(named), out)?;
    let both = other.as_ref().map(|other| [&own, other]);
    let first = other.as_ref().filter(|_| is_other_greater).unwrap_or(&own);
    if args.answer.format.is_json("record")? {
        let polarities = both.map(|[recorded, mirrored]| Polarities { recorded, mirrored });
        let polarity = polarities.is_some().then_some(if is_other_greater { "mirrored" } else { "recorded" });
        let answer = Polar { answer: first, polarity, polarities };
        return output::json(&Described::new(&answer, summary, &shaken.record), out);
    }
    text(first, &system, &read, both, out)
}

/// The answers to one record.
#[derive(Serialize)]
#[serde(bound = "")]
struct Answered<F> {
    #[serde(skip)]
    answer: RecordAnswer<F>,
    #[serde(flatten)]
    physical: Physical<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    floor_spectrum: Option<FloorSpectrum>,
}

/// The answers to a record or its mirror image, the one that moves the body further, and those to both.
#[derive(Serialize)]
#[serde(bound = "")]
struct Polar<'a, F> {
    #[serde(flatten)]
    answer: &'a Answered<F>,
    #[serde(skip_serializing_if = "Option::is_none")]
    polarity: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    polarities: Option<Polarities<'a, F>>,
}

#[derive(Serialize)]
#[serde(bound = "")]
struct Polarities<'a, F> {
    recorded: &'a Answered<F>,
    mirrored: &'a Answered<F>,
}

impl<F: Value> Answered<F> {
    fn new(args: &RecordArgs, shaken: &Shaken<F>, record: &Record<F>) -> Result<Self, Failure> {
        let Shaken { given, body, start: [x0, v0], floor, has_mass, .. } = shaken;
        let named = |e: stickslip::Error| Failure::Input(format!("{}: {e}", args.file.display()));
        let answer = body.follow_from(record, *x0, *v0).map_err(named)?;
        let physical = physical(&answer, given.system, *has_mass);
        for (name, _, cell) in &physical.values {
            cell.finite(name)?;
        }
        let floor = floor.as_ref();
        let floor = floor.map(|asked| FloorSpectrum::new(asked, (body, [*x0, *v0]), record, given.system));
        Ok(Self { answer, physical, floor_spectrum: floor.transpose()? })
    }
}

/// Refuses an interval with which the states, until the record has passed and as long again, take too much memory.
fn refuse_many<F: Value>(record: &Record<F>, interval: F, text: &str) -> Outcome {
    const MOST: f64 = 2e6;
    let count = 2.0 * ((record.end() - record.time(0)) / interval).to_f64();
    if count <= MOST {
        return Ok(());
    }
    Err(format!("--interval {text}: about {count:.1e} states, must be ≤ {MOST:.0e}").into())
}

/// The answers with their units, but for those that need a mass where none is known.
fn physical<F: Value>(answer: &RecordAnswer<F>, system: System, has_mass: bool) -> Physical<Number> {
    let mut physical = Physical::of(system);
    physical.values =
        columns(answer, system).into_iter().filter(|(_, kind, _)| has_mass || !needs_mass(*kind)).collect();
    physical.shown()
}

/// The name, the kind and the cell of each answer.
pub(crate) type Columns<F> = [(&'static str, Kind, Cell<F>); 26];

/// The answers as cells, in the units of their names.
pub(crate) fn columns<F: Value>(answer: &RecordAnswer<F>, system: System) -> Columns<F> {
    answer.entries().map(|(name, kind, entry)| {
        let cell = match entry {
            Entry::Value(value) => Cell::Number(value.map(|value| system.shown(kind, *value))),
            Entry::Count(count) => Cell::Count(Some(count)),
        };
        (name, kind, cell)
    })
}

fn text<F: Value>(
    first: &Answered<F>,
    system: &System,
    read: &str,
    both: Option<[&Answered<F>; 2]>,
    out: &mut impl Write,
) -> Outcome {
    let unit = |kind: Kind| system.name(kind);
    let times = |n: u64| if n == 1 { "once".to_owned() } else { format!("{n} times") };
    let answer = &first.answer;
    let slides = times(answer.slides);
    match (answer.residual_displacement, answer.cut_time) {
        _ if answer.slides == 0 => writeln!(out, "The body rests throughout.")?,
        (Some(rest), _) => writeln!(
            out,
            "The body slides {slides}, and {} rest at {} {}.",
            stickslip_front::record::comes_to(answer),
            digits(rest),
            unit(Kind::Length)
        )?,
        (None, Some(cut)) => writeln!(
            out,
            "The body slides {slides}, and never comes to rest. Its motion is cut at {} {}.",
            digits(cut),
            unit(Kind::Time)
        )?,
        (None, None) => writeln!(out, "The body slides {slides}, and does not come to rest.")?,
    }
    writeln!(out, "{read}")?;
    if let Some([recorded, mirrored]) = both {
        let [one, two] = [recorded, mirrored].map(|answered| answered.answer.peak_displacement);
        let which = if two > one {
            "The mirror image of the record moves the body further than the record"
        } else if two < one {
            "The record moves the body further than its mirror image"
        } else {
            "The record and its mirror image move the body equally far"
        };
        writeln!(out, "{which}. Below, the record stands first, and its mirror image second.")?;
    }
    writeln!(out)?;
    let columns = both.map_or_else(|| vec![first], Vec::from);
    for (place, (name, kind, _)) in first.physical.values.iter().enumerate() {
        let cells = || columns.iter().filter_map(|answered| answered.physical.values.get(place));
        let is_none = cells().all(|(.., cell)| matches!(cell, Cell::Number(None)));
        if is_none && *name == "cut_time" {
            continue;
        }
        let unit = if *kind == Kind::Ratio || is_none { String::new() } else { format!(" {}", unit(*kind)) };
        let texts: Vec<_> = cells().map(|(.., cell)| cell.text()).collect();
        let (last, before) = texts.split_last().map_or(("", &[][..]), |(last, before)| (last, before));
        let before: String = before.iter().map(|text| format!("{text:<16} ")).collect();
        writeln!(out, "  {:<26} {before}{last}{unit}", name.replace('_', " "))?;
    }
    for (place, answered) in columns.iter().enumerate() {
        if let Some(spectrum) = &answered.floor_spectrum {
            let of = match (both.is_some(), place) {
                (false, _) => "",
                (true, 0) => " under the record",
                (true, _) => " under its mirror image",
            };
            spectrum.text(of, system, out)?;
        }
    }
    Ok(())
}

/// A column of a motion: its name, its kind and its value.
type OfState<F> = (&'static str, Kind, fn(&RecordState<F>) -> F);

/// The columns of a motion, but for the direction.
const fn of_state<F: Value>() -> [OfState<F>; 8] {
    [
        ("time", Kind::Time, |state| state.time),
        ("displacement", Kind::Length, |state| state.displacement),
        ("velocity", Kind::Velocity, |state| state.velocity),
        ("acceleration", Kind::Acceleration, |state| state.acceleration),
        ("absolute_acceleration", Kind::Acceleration, |state| state.absolute_acceleration),
        ("friction", Kind::Force, |state| state.friction),
        ("transmitted_force", Kind::Force, |state| state.transmitted_force),
        ("load", Kind::Force, |state| state.load),
    ]
}

/// Whether the file of a motion is to be Parquet, and not CSV, by the ending of its name.
fn is_parquet(file: &Path) -> bool {
    file.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("parquet"))
}

/// The states of a motion: as CSV, whose fifth column is the direction, or as Parquet, whose last one is.
fn states<F: Value>(
    motion: &RecordMotion<F>,
    (system, has_mass): (System, bool),
    file: &Path,
    out: &mut impl Write,
) -> Outcome {
    let columns = || of_state::<F>().into_iter().filter(|(_, kind, _)| has_mass || !needs_mass(*kind));
    if is_parquet(file) {
        let mut sink = Sink::new(StreamFormat::Parquet, out, Header::Names)?;
        for state in &motion.states {
            let direction = Cell::Number(Some(F::int(state.direction.into())));
            let cell = |kind, value| Cell::Number(Some(system.shown(kind, value)));
            let values = columns().map(|(name, kind, of)| (name, kind, cell(kind, of(state))));
            let values = values.chain([("direction", Kind::Ratio, direction)]).collect();
            sink.write(&Cells::of(Vec::new()).with_physical(Physical::beside(system, values)).shown())?;
        }
        return sink.finish();
    }
    let mut table = csv::Writer::from_writer(out);
    let names =
        columns().map(|(name, kind, _)| format!("{name}[{}]", crate::outputs::plain(&system.name(kind))));
    let with_direction = |mut cells: Vec<String>, direction: String| {
        cells.insert(4, direction);
        cells
    };
    table.write_record(with_direction(names.collect(), "direction".to_owned()))?;
    for state in &motion.states {
        let cells = columns().map(|(_, kind, of)| crate::bits::all_digits(system.shown(kind, of(state))));
        table.write_record(with_direction(cells.collect(), state.direction.to_string()))?;
    }
    Ok(table.flush()?)
}

/// The name and the kind of the samples of a record, and those that a picture shows, over their times.
pub(crate) fn drawn_load<F: Value>(
    record: &Record<F>,
    system: &System,
) -> (&'static str, Kind, Vec<(f64, f64)>) {
    let (name, kind) = match record.excitation() {
        stickslip::Excitation::Force => ("force", Kind::Force),
        stickslip::Excitation::SurfaceAcceleration => ("acceleration of the surface", Kind::Acceleration),
        stickslip::Excitation::Unbalance => ("unbalance", Kind::Unbalance),
        stickslip::Excitation::FootMotion
        | stickslip::Excitation::DampedFootMotion
        | stickslip::Excitation::SurfaceMotion
        | stickslip::Excitation::SurfaceVelocity
        | _ => ("displacement of the support", Kind::Length),
    };
    let time = |index: usize| record.time(index).to_f64();
    let samples = record.samples().iter().enumerate();
    let load: Vec<_> =
        samples.map(|(index, sample)| (time(index), system.shown(kind, *sample).to_f64())).collect();
    let places = motion_plot::drawn(&load.iter().map(|point| point.1).collect::<Vec<_>>());
    (name, kind, places.iter().filter_map(|place| load.get(*place)).copied().collect())
}

/// The load, the displacement, the velocity and the absolute acceleration over time, and the force on the support over the
/// displacement.
fn drawing<F: Value>(
    record: &Record<F>,
    motion: &RecordMotion<F>,
    (system, has_mass): (&System, bool),
    file: &Path,
    machine: &str,
) -> Figure {
    let (name, kind, load) = drawn_load(record, system);
    let label = |name: &str, kind: Kind| format!("{name} ({})", system.name(kind));
    let times = || motion.states.iter().map(|state| state.time.to_f64());
    let last = times().chain(load.iter().map(|(time, _)| *time)).fold(f64::NEG_INFINITY, f64::max);
    let x = || Axis::linear("time (s)", times().fold(f64::INFINITY, f64::min), last);
    // A rest is drawn to its end, which is the beginning of the next slide.
    let at_rest = || motion.states.iter().map(|state| state.direction == 0);
    let rests: Vec<_> = at_rest().zip([false].into_iter().chain(at_rest())).map(|(a, b)| a || b).collect();
    let moving = |name: &str, kind: Kind, value: fn(&RecordState<F>) -> F| {
        let points = times()
            .zip(motion.states.iter().map(|state| system.shown(kind, value(state)).to_f64()))
            .collect();
        motion_plot::panel(name, x(), &label(name, kind), points, &rests)
    };
    let y = motion_plot::axis(&label(name, kind), load.iter().map(|(_, value)| *value), 0.08);
    let of = |value: fn(&RecordState<F>) -> F| motion.states.iter().map(move |state| value(state).to_f64());
    let places = of(|state| state.displacement);
    let across = motion_plot::axis(&label("displacement", Kind::Length), places.clone(), 0.08);
    let points = places.zip(of(|state| state.transmitted_force)).collect();
    let force = label("transmitted force", Kind::Force);
    let force_loop = motion_plot::panel("force–displacement loop", across, &force, points, &rests);
    let mut panels = vec![
        Panel::new(name, x(), y, vec![Series::new("", Style::Line, 1, load.clone())]),
        moving("displacement", Kind::Length, |state| state.displacement),
        moving("velocity", Kind::Velocity, |state| state.velocity),
        moving("absolute acceleration", Kind::Acceleration, |state| state.absolute_acceleration),
    ];
    panels.extend(has_mass.then_some(force_loop));
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    Figure::new("record", format!("Motion under {name}: {machine}"), "", panels).stacked()
}
