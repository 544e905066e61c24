//! `stickslip system`: several bodies with contacts, elastic contacts and stops.

mod options;
mod picture;
mod sketch;
mod table;
mod words;

use crate::args::{Format, Header, LoadArgs, StreamFormat, SystemArgs, SystemQuestion};
use crate::failure::{Failure, Outcome};
use crate::figure::Target;
use crate::interrupt;
use crate::measured::Described as OfRecord;
use crate::output::{self, PendingFile};
use crate::row::{Cell, Cells};
use crate::rows;
use crate::sink::Sink;
use options::{folder, is_json, note_of_units, path_and_value};
use serde_json::Value;
use std::io::{Read, Write};
use std::path::Path;
use stickslip::motion::record::Record;
use stickslip::system::State;
use stickslip_draw::Figure;
use stickslip_front::inputs::units::Kind as Of;
use stickslip_front::record::Summary;
use stickslip_front::system::{Answer, LONGEST, NamedSystem, OfBorder, Samples, decoded, parsed};

/// The memory of the samples of a motion in bytes.
const MEMORY: u64 = 200_000_000;

pub(crate) fn run(args: &SystemArgs, out: &mut impl Write) -> Outcome {
    check_options(args)?;
    let value = read(&args.file)?;
    if is_table(args) {
        return table::run(&value, args, out);
    }
    let (mut asked, read) = named(&value, args)?;
    match args.question {
        SystemQuestion::Describe => describe(&asked, args, out),
        SystemQuestion::Steady => steady(&asked, args, out),
        SystemQuestion::Simulate | SystemQuestion::Record => simulate(&mut asked, read.as_ref(), args, out),
        SystemQuestion::Border => border(&asked, args, out),
        SystemQuestion::Curve | SystemQuestion::Spectrum => Ok(()),
    }
}

/// Whether the answer is a row for each place of a grid.
fn is_table(args: &SystemArgs) -> bool {
    let is_grid = args.set.iter().any(|text| text.contains([':', ',']));
    matches!(args.question, SystemQuestion::Curve | SystemQuestion::Spectrum)
        || is_grid
        || args.records.len() > 1
}

/// The value of the file.
fn read(file: &Path) -> Result<Value, Failure> {
    let name = file.display().to_string();
    let mut bytes = Vec::new();
    let read = rows::open(file, &name)?.take(LONGEST as u64 + 1).read_to_end(&mut bytes);
    read.map_err(|e| Failure::Input(format!("{name}: {e}")))?;
    Ok(parsed(&decoded(bytes, &name)?, &name)?)
}

/// A record, and what was read of its file.
type Shaking = (Summary, Record<f64>);

/// The system of a value with the values of `--set`, and with a record, if there is one.
fn named(value: &Value, args: &SystemArgs) -> Result<(NamedSystem, Option<Shaking>), Failure> {
    let set = args.set.iter().map(|text| path_and_value(text)).collect::<Result<Vec<_>, _>>()?;
    let about = |e: String| Failure::Input(format!("{}: {e}", args.file.display()));
    let found = NamedSystem::new(value, set, folder(args), args.units.units.as_ref()).map_err(about)?;
    let (mut found, read) = match args.records.first() {
        Some(file) => {
            let (record, summary) =
                crate::measured::read::<f64>(file, &LoadArgs::default(), &found.reader())?;
            note_of_units(found.described.units.as_ref(), &file.display().to_string());
            (found.with_record(&record, &file.display().to_string())?, Some((summary, record)))
        }
        None => (found, None),
    };
    found.system = found.system.while_allowed(interrupt::keep_going);
    Ok((found, read))
}

/// Refuses an option that the question does not use.
fn check_options(args: &SystemArgs) -> Outcome {
    use SystemQuestion as Q;
    let uses = |name: &str, is_given: bool, by: &[Q]| {
        if is_given && !by.contains(&args.question) {
            return Err(Failure::Input(format!("{name}: this question does not use it")));
        }
        Ok(())
    };
    uses("--until", args.until.is_some(), &[Q::Simulate, Q::Record, Q::Spectrum])?;
    uses("--samples", args.samples.is_some(), &[Q::Steady, Q::Simulate, Q::Record])?;
    uses("--frequency", args.frequency.is_some(), &[Q::Curve])?;
    uses("RECORD", !args.records.is_empty(), &[Q::Record, Q::Spectrum])?;
    let is_missing = |name: &str| Err(Failure::Input(format!("{name} is missing")));
    match args.question {
        Q::Simulate if args.until.is_none() => return is_missing("--until"),
        Q::Curve if args.frequency.is_none() => return is_missing("--frequency"),
        Q::Record | Q::Spectrum if args.records.is_empty() => return is_missing("RECORD"),
        Q::Describe | Q::Steady | Q::Simulate | Q::Record | Q::Spectrum | Q::Curve | Q::Border => {}
    }
    let paths: Vec<_> =
        args.set.iter().filter_map(|text| text.split_once('=')).map(|(path, _)| path.trim()).collect();
    if let Some(path) =
        paths.iter().enumerate().find_map(|(i, path)| paths.iter().take(i).find(|p| *p == path))
    {
        return Err(format!("--set {path}: must be given once").into());
    }
    if args.overwrite && args.picture.is_none() && !(args.out.is_some() && args.samples.is_some()) {
        return Err("--overwrite: needs --picture, or --samples with --out".into());
    }
    args.look.needs("--picture", args.picture.as_deref())?;
    uses(
        "--picture",
        args.picture.is_some(),
        &[Q::Describe, Q::Steady, Q::Simulate, Q::Record, Q::Spectrum, Q::Curve],
    )?;
    let (is_rows, is_table) = (args.samples.is_some(), is_table(args));
    if args.out.is_some() && !is_rows && !is_table {
        return Err("--out: holds rows, of a curve, a grid or --samples".into());
    }
    if is_rows && is_table {
        return Err("--samples: must be left out for a curve or a grid".into());
    }
    let of_grids =
        [("--resume", args.resume), ("--shard", args.shard.is_some()), ("--no-header", args.no_header)];
    if is_rows && args.picture.is_some() {
        return Err("--picture: must be left out beside --samples".into());
    }
    match of_grids.into_iter().find(|(_, is_given)| *is_given && !is_table) {
        Some((name, _)) => Err(format!("{name}: needs a curve or a grid").into()),
        None => Ok(()),
    }
}

/// Draws the picture, if there is to be one.
fn drawn(args: &SystemArgs, figure: impl FnOnce() -> Result<Figure, Failure>) -> Outcome {
    let Some(file) = &args.picture else { return Ok(()) };
    let target = Target::new("--picture", Some(file), args.overwrite, &args.look)?;
    target.draw(&mut std::io::sink(), figure)
}

/// The system in words, and as a drawing.
fn describe(asked: &NamedSystem, args: &SystemArgs, out: &mut impl Write) -> Outcome {
    if let Some(file) = &args.picture {
        let target = Target::new("--picture", Some(file), args.overwrite, &args.look)?;
        target.write_svg(|title, size| {
            sketch::svg(&asked.described, title, size).ok_or_else(|| {
                Failure::Input(format!("--picture {}: shows at most {} bodies", file.display(), sketch::MOST))
            })
        })?;
    }
    words::describe(asked, args, out)
}

/// The end of the motion: `--until`, a time or a value that is passed, or the end of the records.
fn until(asked: &mut NamedSystem, args: &SystemArgs) -> Result<f64, Failure> {
    let Some(text) = &args.until else {
        let end = asked.end_of_records();
        asked.check_until(end, &format!("end of the records {}", crate::bits::digits(end)))?;
        return Ok(end);
    };
    if text.contains('=') {
        let until = asked.until_level(text).map_err(|e| format!("--until {e}"))?;
        asked.system = asked.system.clone().while_allowed(interrupt::keep_going);
        return Ok(until);
    }
    let until: f64 = asked.reader().value("--until", text, Of::Time)?;
    asked.check_until(until, &format!("--until {text}"))?;
    Ok(until)
}

/// The times of the samples that are asked for, from 0 on.
fn samples(asked: &NamedSystem, args: &SystemArgs, until: f64) -> Result<Option<Vec<f64>>, Failure> {
    let Some(text) = &args.samples else { return Ok(None) };
    // Five lists of a state with what they take beside their numbers, which are four for each coordinate and one for each element.
    let described = &asked.described;
    let numbers = 4 * described.coordinates.len() + described.model.elements.len();
    let count = crate::input::count("--samples", text, MEMORY / (300 + 8 * numbers as u64))?;
    Ok(Some((0..=count).map(|i| until * (i as f64 / count as f64)).collect()))
}

fn simulate(
    asked: &mut NamedSystem,
    read: Option<&Shaking>,
    args: &SystemArgs,
    out: &mut impl Write,
) -> Outcome {
    let until = until(asked, args)?;
    let (asked, start) = (&*asked, &asked.described.start);
    if let Some(times) = samples(asked, args, until)? {
        return sampled(asked, args, start, &times, out);
    }
    let motion = asked.system.simulate(start, until).map_err(|e| of_file(args, &e))?;
    drawn(args, || picture::motion(asked, start, &motion, &picture::title(&asked.described, "Motion")))?;
    if is_json(args)? {
        let answer = Answer::transient(&asked.described, &motion);
        return match read {
            Some((summary, record)) => output::json(&OfRecord::new(&answer, summary, record), out),
            None => output::json(&answer, out),
        };
    }
    if let Some((summary, record)) = read {
        writeln!(out, "{}", crate::measured::lines(summary, record))?;
    }
    let seconds = if asked.described.units.is_some() { " s" } else { "" };
    writeln!(out, "The motion from the start to {}{seconds}.\n", crate::bits::digits(until))?;
    words::motion(&asked.described, &motion, out)
}

fn steady(asked: &NamedSystem, args: &SystemArgs, out: &mut impl Write) -> Outcome {
    let found = asked.system.steady(&asked.described.start).map_err(|e| of_file(args, &e))?;
    if let Some(times) = samples(asked, args, found.period)? {
        return sampled(asked, args, &found.start, &times, out);
    }
    let title = || picture::title(&asked.described, &format!("Steady motion ({})", found.kind.name()));
    drawn(args, || picture::motion(asked, &found.start, &found.motion, &title()))?;
    if is_json(args)? {
        return output::json(&Answer::steady(&asked.described, &found), out);
    }
    steady_motion(asked, &found, out)
}

/// A steady motion in words.
pub(crate) fn steady_motion(
    asked: &NamedSystem,
    found: &stickslip::system::Steady<f64>,
    out: &mut impl Write,
) -> Outcome {
    words::steady(&asked.described, found, out)?;
    words::motion(&asked.described, &found.motion, out)
}

/// States at times, as CSV or JSON.
fn sampled(
    asked: &NamedSystem,
    args: &SystemArgs,
    start: &State<f64>,
    times: &[f64],
    out: &mut impl Write,
) -> Outcome {
    let format = match (args.format, args.out.as_deref().and_then(Path::extension)) {
        (Some(Format::Json), Some(end)) if end != "json" => {
            return Err("--format json: the name of --out must end in .json".into());
        }
        (Some(Format::Json), _) => None,
        (None, Some(end)) if end == "parquet" => Some(StreamFormat::Parquet),
        (Some(Format::Csv) | None, _) => Some(StreamFormat::Csv),
        (Some(Format::Text | Format::Jsonl), _) => {
            return Err("--format: must be csv or json with --samples".into());
        }
    };
    let states = asked.system.states(start, times).map_err(|e| of_file(args, &e))?;
    let samples = Samples::new(&asked.described, times, &states);
    let write = |mut out: &mut dyn Write| -> Outcome {
        let Some(format) = format else {
            return output::json(&samples, &mut out);
        };
        let keys: Vec<_> = samples.names().into_iter().map(table::key).collect();
        let mut sink = Sink::new(format, out, Header::Names)?;
        for row in samples.rows() {
            let cells = row.into_iter().map(|x| Cell::Number(Some(x)));
            let row: Vec<(_, Cell<f64>)> = keys.iter().copied().zip(cells).collect();
            sink.write(&Cells::of(row).shown())?;
        }
        sink.finish()
    };
    match &args.out {
        Some(file) => {
            let argument = format!("--out {}", file.display());
            PendingFile::create(file, &argument, args.overwrite)?.fill(|out| write(out))
        }
        None => write(out),
    }
}

fn border(asked: &NamedSystem, args: &SystemArgs, out: &mut impl Write) -> Outcome {
    let found = asked.system.border().map_err(|e| of_file(args, &e))?;
    // Below the border the cycle is no motion.
    let cycle = asked.system.cycle().map_err(|e| of_file(args, &e))?.filter(|cycle| cycle.margin >= 1.0);
    if is_json(args)? {
        return output::json(&OfBorder::new(&found, cycle.as_ref()), out);
    }
    words::border(&asked.described, &found, cycle.as_ref(), out)
}

/// An error of the engine, with the name of the file.
fn of_file(args: &SystemArgs, error: &stickslip::system::Error) -> Failure {
    Failure::from(error.clone()).about(&args.file.display().to_string())
}

impl From<stickslip::system::Error> for Failure {
    fn from(error: stickslip::system::Error) -> Self {
        if error == stickslip::system::Error::Interrupted {
            return Self::Interrupted;
        }
        Self::Input(error.to_string())
    }
}
