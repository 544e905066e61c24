//! `record --enclose`: every answer with a bound of its error, and every stop proved.

use super::found::BITS;
use crate::args::RecordArgs;
use crate::failure::{Failure, Outcome};
use crate::measured::{self, Described};
use crate::output;
use crate::physical::Units;
use crate::shaken::{Shaken, needs_mass};
use crate::style;
use serde::ser::{Serialize, SerializeMap, Serializer};
use std::io::Write;
use stickslip::enclosed::{self, Enclosure};
use stickslip::float::Mp;
use stickslip::motion::record::{Entry, RecordAnswer};
use stickslip_front::inputs::units::{Kind, System};

/// The precision at which inputs are read, in words of 64 bits: that of the widest computation.
const WORDS: usize = 65;

/// The answers in a system of units.
struct EnclosedRecord {
    found: RecordAnswer<Enclosure>,
    system: System,
    has_mass: bool,
}

pub(crate) fn record(args: &RecordArgs, out: &mut impl Write) -> Outcome {
    let Shaken { given, body, record, summary, start: [x, v], has_mass, .. } =
        Shaken::<Mp<WORDS>>::read(args)?;
    let named = |e: stickslip::Error| Failure::Input(format!("{}: {e}", args.file.display()));
    let found = enclosed::follow(&body, &record, x, v, args.answer.bits.unwrap_or(BITS)).map_err(named)?;
    let answer = EnclosedRecord { found, system: given.system, has_mass };
    if args.answer.format.is_json("record")? {
        output::json(&Described::new(&answer, &summary, &record), out)
    } else {
        answer.text(&measured::lines(&summary, &record), out)
    }
}

impl EnclosedRecord {
    /// The answers, but for those that need a mass where none is known.
    fn entries(&self) -> impl Iterator<Item = (&'static str, Kind, Entry<'_, Enclosure>)> {
        self.found.entries().into_iter().filter(|(_, kind, _)| self.has_mass || !needs_mass(*kind))
    }

    fn text(&self, read: &str, out: &mut impl Write) -> Outcome {
        let found = &self.found;
        let ends = if found.residual_displacement.is_some() {
            stickslip_front::record::comes_to(found)
        } else {
            "does not come to"
        };
        let verdict = match found.slides {
            0 => "The body rests throughout. This is certain.".to_owned(),
            1 => format!("The body slides once, and {ends} rest. This is certain."),
            n => format!("The body slides {n} times, and {ends} rest. This is certain."),
        };
        writeln!(out, "{}\n{read}\n", style::verdict(&verdict))?;
        for (name, kind, entry) in self.entries() {
            let name = name.replace('_', " ");
            match entry {
                Entry::Value(Some(value)) => {
                    writeln!(out, "  {name:<26} {value} {}", self.system.name(kind))?
                }
                Entry::Value(None) => writeln!(out, "  {name:<26} –")?,
                Entry::Count(count) => writeln!(out, "  {name:<26} {count}")?,
            }
        }
        Ok(writeln!(out, "\nEach value lies within ± of the number printed, for the inputs as typed.")?)
    }
}

impl Serialize for EnclosedRecord {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let entries: Vec<_> = self.entries().collect();
        let mut map = serializer.serialize_map(None)?;
        for (name, _, entry) in &entries {
            match entry {
                Entry::Value(value) => map.serialize_entry(name, value)?,
                Entry::Count(count) => map.serialize_entry(name, count)?,
            }
        }
        let mut kinds: Vec<_> = entries.iter().map(|(name, kind, _)| (*name, *kind)).collect();
        kinds.sort_by_key(|(name, _)| *name);
        map.serialize_entry("units", &Units(self.system, kinds))?;
        map.end()
    }
}
