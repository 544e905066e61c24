//! `--enclose`: the motion of a system with every event proved, and every number as certain digits, then ±.

use super::asked::{is_table, named, of_file};
use super::options::{folder, is_json, path_and_value};
use super::wide::without_others;
use super::words;
use crate::args::SystemArgs;
use crate::bits;
use crate::enclose::BITS;
use crate::failure::{Failure, Outcome};
use crate::interrupt;
use crate::output;
use crate::row::Number;
use crate::style;
use serde_json::Value;
use std::io::Write;
use stickslip::enclosed::Enclosure;
use stickslip_front::system::{Answer, WideSystem, plural};

/// The precision at which the file is read: above that of all balls.
const READ_AT: u32 = 4096;
/// The greatest number of bits of an answer.
const MOST: u32 = 1500;

pub(super) fn run(value: &Value, args: &SystemArgs, out: &mut impl Write) -> Outcome {
    without_others("--enclose", args)?;
    let refused = |what: &str| Err(Failure::Input(format!("{what} beside --enclose")));
    if is_table(args) {
        return refused("--set: must not be a grid");
    }
    if args.samples.is_some() {
        return refused("--samples: must be left out");
    }
    let wanted = args.bits.unwrap_or(BITS);
    if wanted > MOST {
        return refused(&format!("--bits {wanted}: must be ≤ {MOST}"));
    }
    if let Some(until) = args.until.as_deref().filter(|until| until.contains('=')) {
        return refused(&format!("--until {until}: must be a time"));
    }
    bits::in_one_copy(READ_AT, || answer(value, wanted, args, out))
}

fn answer(value: &Value, wanted: u32, args: &SystemArgs, out: &mut impl Write) -> Outcome {
    // The names, the units and what is wrong with the file are those of the doubles.
    let (plain, _) = named(value, &[], args)?;
    let about = |e: String| Failure::Input(format!("{}: {e}", args.file.display()));
    let set = args.set.iter().map(|text| path_and_value(text)).collect::<Result<Vec<_>, _>>()?;
    let units = args.units.units.as_ref();
    let mut asked =
        WideSystem::new(value, &set, folder(args), units, interrupt::keep_going).map_err(about)?;
    let until = asked.until("--until", args.until.as_deref())?;
    let (start, found) = asked.enclosed(until, wanted).map_err(|e| of_file(args, e.into()))?;
    let described = &plain.described;
    if is_json(args)? {
        return output::json(&Answer::from_start(described, &start, &found), out);
    }
    let seconds = if described.units.is_some() { " s" } else { "" };
    let until = words::shown(&until).digits();
    let events = match found.events.len() {
        0 => "no event".to_owned(),
        count => plural(count, "event", "events"),
    };
    let verdict = format!("Proved: the motion from the start to {until}{seconds} has {events}.");
    writeln!(out, "{}\n", style::verdict(&verdict))?;
    words::motion(described, &found.map(&text), out)?;
    Ok(writeln!(
        out,
        "\nEach value lies within ± of the number printed, for the numbers of the file as typed."
    )?)
}

fn text(x: &Enclosure) -> Number {
    Number::Wide(x.to_string().into(), true)
}
