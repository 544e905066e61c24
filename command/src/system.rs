//! `stickslip system`: several bodies with contacts, elastic contacts and stops.

mod asked;
#[cfg(all(feature = "mp", not(test)))]
mod enclosed;
mod options;
mod picture;
mod sketch;
mod table;
#[cfg(all(feature = "mp", not(test)))]
pub(crate) mod wide;
mod words;

use crate::args::{SystemArgs, SystemQuestion};
use crate::failure::{Failure, Outcome};
use crate::figure::Target;
use crate::measured::Described as OfRecord;
use crate::output;
use crate::rows;
use asked::{Shaking, is_table, named, of_file, sampled, samples, until_in_words};
use options::is_json;
use serde_json::Value;
use std::io::{Read, Write};
use std::path::Path;
use stickslip_draw::Figure;
use stickslip_front::system::{
    Answer, Digits, LONGEST, NamedSystem, OfBorder, Why, decoded, parsed, parsed_as_typed,
};

pub(crate) fn run(args: &SystemArgs, out: &mut impl Write) -> Outcome {
    check_options(args)?;
    let is_wide = args.bits.is_some() || args.enclose;
    let mut value = read(&args.file, if is_wide { parsed_as_typed } else { parsed })?;
    if let Some(text) = &args.law_tolerance {
        NamedSystem::set_tolerance(&mut value, text).map_err(|e| format!("--law-tolerance {text}: {e}"))?;
    }
    if args.enclose {
        #[cfg(all(feature = "mp", not(test)))]
        return enclosed::run(&value, args, out);
        #[cfg(any(not(feature = "mp"), test))]
        return Err(crate::enclose::no_balls());
    }
    if let Some(bits) = args.bits {
        #[cfg(all(feature = "mp", not(test)))]
        return wide::run(&value, args, bits, out);
        #[cfg(any(not(feature = "mp"), test))]
        return crate::bits::without_mp(bits);
    }
    if is_table(args) {
        return table::run(&value, args, None, out);
    }
    let (mut asked, read) = named(&value, &args.records, args)?;
    match args.question {
        SystemQuestion::Describe => describe(&asked, args, out),
        SystemQuestion::Steady => steady(&asked, args, out),
        SystemQuestion::Simulate | SystemQuestion::Record => simulate(&mut asked, read.as_ref(), args, out),
        SystemQuestion::Border => border(&asked, args, out),
        SystemQuestion::Curve | SystemQuestion::Spectrum => Ok(()),
    }
}

/// The value of the file.
fn read(file: &Path, parsed: fn(&str, &str) -> Result<Value, String>) -> Result<Value, Failure> {
    let name = file.display().to_string();
    let mut bytes = Vec::new();
    let read = rows::open(file, &name)?.take(LONGEST as u64 + 1).read_to_end(&mut bytes);
    read.map_err(|e| Failure::Input(format!("{name}: {e}")))?;
    Ok(parsed(&decoded(bytes, &name)?, &name)?)
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
    uses("--frequencies-below", args.frequencies_below.is_some(), &[Q::Describe])?;
    let of_coordinates = [Q::Describe, Q::Steady, Q::Simulate, Q::Record, Q::Curve, Q::Spectrum];
    uses("--coordinates", args.coordinates.is_some(), &of_coordinates)?;
    uses("--bits", args.bits.is_some(), &[Q::Steady, Q::Simulate, Q::Record, Q::Curve, Q::Border])?;
    uses("--enclose", args.enclose, &[Q::Simulate])?;
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
        target.write_svg(|title, size| Ok(sketch::svg(&asked.described, title, size)))?;
    }
    words::describe(asked, args, out)
}

fn simulate(
    asked: &mut NamedSystem,
    read: Option<&Shaking>,
    args: &SystemArgs,
    out: &mut impl Write,
) -> Outcome {
    let until = asked.until("--until", args.until.as_deref())?;
    let (asked, start) = (&*asked, &asked.described.start);
    if let Some(times) = samples(&asked.described, args, until)? {
        let states = asked.states(start, &times).map_err(|e| of_file(args, e))?;
        return sampled(&asked.described, args, &times, &states, out);
    }
    let (motion, digits) = asked.simulate(start, until).map_err(|e| of_file(args, e))?;
    drawn(args, || picture::motion(asked, start, &motion, &picture::title(&asked.described, "Motion")))?;
    if is_json(args)? {
        let answer = Answer::transient(&asked.described, &motion).with_digits(digits.as_ref());
        return match read {
            Some((summary, record)) => output::json(&OfRecord::new(&answer, summary, record), out),
            None => output::json(&answer, out),
        };
    }
    if let Some((summary, record)) = read {
        writeln!(out, "{}", crate::measured::lines(summary, record))?;
    }
    until_in_words(&asked.described, &words::shown(&until), out)?;
    words::digits_known(&asked.described, digits.as_ref(), out)?;
    writeln!(out)?;
    words::motion(&asked.described, &words::text_of(motion), out)
}

fn steady(asked: &NamedSystem, args: &SystemArgs, out: &mut impl Write) -> Outcome {
    let (found, digits) = asked.steady(&asked.described.start).map_err(|e| of_file(args, e))?;
    if let Some(times) = samples(&asked.described, args, found.period)? {
        let states = asked.states(&found.start, &times).map_err(|e| of_file(args, e))?;
        return sampled(&asked.described, args, &times, &states, out);
    }
    let title = || picture::title(&asked.described, &format!("Steady motion ({})", found.kind.name()));
    drawn(args, || picture::motion(asked, &found.start, &found.motion, &title()))?;
    if is_json(args)? {
        return output::json(&Answer::steady(&asked.described, &found).with_digits(digits.as_ref()), out);
    }
    steady_motion(asked, &found, digits.as_ref(), out)
}

/// A steady motion in words.
pub(crate) fn steady_motion(
    asked: &NamedSystem,
    found: &stickslip::system::Steady<f64>,
    digits: Option<&Digits>,
    out: &mut impl Write,
) -> Outcome {
    words::steady(&asked.described, found, digits, out)?;
    words::motion(&asked.described, &words::text_of(found.motion.clone()), out)
}

fn border(asked: &NamedSystem, args: &SystemArgs, out: &mut impl Write) -> Outcome {
    let (found, cycle) = asked.border().map_err(|e| of_file(args, e.into()))?;
    if is_json(args)? {
        return output::json(&OfBorder::new(&found, cycle.as_ref()), out);
    }
    words::border(&asked.described, &asked.described.model, &found, cycle.as_ref(), out)
}

impl From<Why> for Failure {
    fn from(why: Why) -> Self {
        match why {
            Why::Engine(error) => error.into(),
            Why::Law(why) => Self::Input(why),
        }
    }
}

impl From<stickslip::system::Error> for Failure {
    fn from(error: stickslip::system::Error) -> Self {
        if error == stickslip::system::Error::Interrupted {
            return Self::Interrupted;
        }
        Self::Input(error.to_string())
    }
}
