//! `--bits`: a system in numbers of any precision.
//!
//! The file is read again into such numbers, with its decimals as they are typed. They become texts at once, so that writing is compiled for
//! one type only.

use super::asked::{is_table, named, of_file, sampled, samples, until_in_words};
use super::options::{folder, is_json, note_of_units, path_and_value};
use super::table::{self, cell};
use super::words::{self, shown, text_of};
use crate::args::{LoadArgs, SystemArgs, SystemQuestion};
use crate::bits;
use crate::failure::{Failure, Outcome};
use crate::interrupt;
use crate::measured::Described as OfRecord;
use crate::note::line;
use crate::output;
use crate::row::{Cell, Number};
use serde_json::Value;
use std::io::Write;
use stickslip::Float;
use stickslip::float::Widest;
use stickslip::motion::record::Record;
use stickslip::system::{Motion, Steady};
use stickslip_front::record::Summary;
use stickslip_front::system::{Answer, Described, Grid, NamedSystem, OfBorder, WideSystem};

/// A question with its file, in numbers of at least so many bits.
pub(super) fn run(value: &Value, args: &SystemArgs, bits: u32, out: &mut impl Write) -> Outcome {
    without_others("--bits", args)?;
    if is_table(args) && !args.records.is_empty() {
        return Err(format!("--bits {bits}: must be left out of a grid under records").into());
    }
    bits::in_one_copy(bits, || {
        if is_table(args) {
            return table::run(value, args, Some(answered), out);
        }
        answer(value, args, out)
    })
}

/// Refuses what only doubles have, beside an option.
pub(super) fn without_others(option: &str, args: &SystemArgs) -> Outcome {
    let without = |name: &str, is_given: bool| {
        if is_given {
            Err(Failure::Input(format!("{name}: must be left out beside {option}")))
        } else {
            Ok(())
        }
    };
    without("--picture", args.picture.is_some())?;
    without("--resolve", args.resolve)?;
    without("--law-tolerance", args.law_tolerance.is_some())
}

/// The cells of a row of a grid.
fn answered(grid: &Grid<'static>, row: u64, until: Option<&str>) -> Result<Vec<Cell<Number>>, Failure> {
    let found = grid.answer_in_full(row, until.map(|text| ("--until", text)))?;
    Ok(found.iter().map(|found| cell(found).shown()).collect())
}

fn answer(value: &Value, args: &SystemArgs, out: &mut impl Write) -> Outcome {
    // The names, the units and what is wrong with the file are those of the doubles.
    let (mut plain, _) = named(value, &[], args)?;
    let (mut asked, read) = system(value, args, &mut plain)?;
    let described = &plain.described;
    match args.question {
        SystemQuestion::Steady => steady(&asked, described, args, out),
        SystemQuestion::Border => border(&asked, described, args, out),
        SystemQuestion::Simulate | SystemQuestion::Record => {
            simulate(&mut asked, described, read.as_ref(), args, out)
        }
        // Refused before, and rows.
        SystemQuestion::Describe | SystemQuestion::Curve | SystemQuestion::Spectrum => Ok(()),
    }
}

/// A record, and what was read of its file.
type Shaking = (Summary, Record<Widest>);

/// The system with its record, of whose base the system of doubles is told, too.
fn system(
    value: &Value,
    args: &SystemArgs,
    plain: &mut NamedSystem,
) -> Result<(WideSystem, Option<Shaking>), Failure> {
    let about = |e: String| Failure::Input(format!("{}: {e}", args.file.display()));
    let set = args.set.iter().map(|text| path_and_value(text)).collect::<Result<Vec<_>, _>>()?;
    let units = args.units.units.as_ref();
    let found = WideSystem::new(value, &set, folder(args), units, interrupt::keep_going).map_err(about)?;
    let Some(file) = args.records.first() else { return Ok((found, None)) };
    let reader = plain.reader();
    let (record, summary) = crate::measured::read::<Widest>(file, &LoadArgs::default(), &reader)?;
    let name = file.display().to_string();
    note_of_units(plain.described.units.as_ref(), &name);
    plain.described.stands_on_a_base();
    Ok((found.with_record(&record, &name)?, Some((summary, record))))
}

fn simulate(
    asked: &mut WideSystem,
    described: &Described,
    read: Option<&Shaking>,
    args: &SystemArgs,
    out: &mut impl Write,
) -> Outcome {
    let until = asked.until("--until", args.until.as_deref())?;
    let mut described = described.clone();
    // A value that is passed is an event with its name.
    described.name_levels(&asked.named().described);
    let (described, start) = (&described, &asked.named().described.start);
    if let Some(times) = samples(described, args, until)? {
        let states = asked.states(start, &times).map_err(|e| of_file(args, e.into()))?;
        return sampled(described, args, &times, &states, out);
    }
    let found: Motion<Widest> = asked.simulate(until).map_err(|e| of_file(args, e.into()))?;
    if is_json(args)? {
        let (start, found) = (start.map(&shown), found.map(&shown));
        let answer = Answer::from_start(described, &start, &found);
        return match read {
            Some((summary, record)) => output::json(&OfRecord::new(&answer, summary, record), out),
            None => output::json(&answer, out),
        };
    }
    if let Some((summary, record)) = read {
        writeln!(out, "{}", crate::measured::lines(summary, record))?;
    }
    until_in_words(described, &shown(&until), out)?;
    writeln!(out)?;
    words::motion(described, &text_of(found), out)
}

fn steady(asked: &WideSystem, described: &Described, args: &SystemArgs, out: &mut impl Write) -> Outcome {
    let found = asked.steady().map_err(|e| of_file(args, e.into()))?;
    if let Some(times) = samples(described, args, found.period)? {
        let states = asked.states(&found.start, &times).map_err(|e| of_file(args, e.into()))?;
        return sampled(described, args, &times, &states, out);
    }
    if is_json(args)? {
        return output::json(&Answer::steady(described, &steady_texts(&found)), out);
    }
    steady_motion(&found, described, out)
}

/// The texts of a steady motion.
pub(crate) fn steady_texts(found: &Steady<Widest>) -> Steady<Number> {
    let mut text = found.clone().map(&shown);
    // An estimate, in doubles.
    text.decay = Number::of(found.decay.to_f64());
    text
}

/// A steady motion in words.
pub(crate) fn steady_motion(found: &Steady<Widest>, described: &Described, out: &mut impl Write) -> Outcome {
    let mut rounded: Steady<f64> = found.clone().map(&|x: &Widest| x.to_f64());
    // How near rounding comes to the motion, in the rounding of doubles.
    rounded.disturbance_growth *= (Widest::epsilon() / Widest::from_f64(f64::EPSILON)).to_f64();
    words::steady(described, &rounded, None, out)?;
    let seconds = if described.units.is_some() { " s" } else { "" };
    line(out, "period", format!("{}{seconds}", shown(&found.period).digits()))?;
    words::motion(described, &text_of(found.motion.clone()), out)
}

fn border(asked: &WideSystem, described: &Described, args: &SystemArgs, out: &mut impl Write) -> Outcome {
    let (found, cycle) = asked.border().map_err(|e| of_file(args, e.into()))?;
    if is_json(args)? {
        let (found, cycle) = (found.map(&shown), cycle.map(|cycle| cycle.map(&shown)));
        return output::json(&OfBorder::new(&found, cycle.as_ref()), out);
    }
    words::border(described, &asked.named().described.model, &found, cycle.as_ref(), out)?;
    Ok(line(out, "least load factor", shown(&found.least_load_factor).digits())?)
}
