//! The names of columns, what they say, and their units.

use super::super::lines::Line;
use super::super::text;
use super::cells::{Delimiter, comment};
use crate::inputs::units::{Kind, Reader};
use crate::names::name_and_unit;
use stickslip::Excitation;

/// The loads: the name of the column, its synonyms, the kind of its values, and the excitation.
pub(super) const LOADS: [(&str, &[&str], Kind, Excitation); 4] = [
    (
        "acceleration",
        &[
            "acc",
            "accel",
            "accn",
            "a",
            "ag",
            "ax",
            "ay",
            "az",
            "ground-acceleration",
            "base-acceleration",
            "surface-acceleration",
            "beschleunigung",
            "accélération",
            "aceleración",
            "aceleracion",
            "aceleração",
            "aceleracao",
            "accelerazione",
            "versnelling",
            "przyspieszenie",
            "ivme",
        ],
        Kind::Acceleration,
        Excitation::SurfaceAcceleration,
    ),
    (
        "force",
        &["f", "load", "kraft", "fuerza", "força", "forca", "forza", "kracht", "siła", "sila", "kuvvet"],
        Kind::Force,
        Excitation::Force,
    ),
    ("foot-displacement", &[], Kind::Length, Excitation::FootMotion),
    ("damped-foot-displacement", &[], Kind::Length, Excitation::DampedFootMotion),
];

/// The names of the time: in English, German, French, Spanish, Italian and Portuguese, Dutch, Polish, and Turkish, and
/// those of programs.
const TIMES: [&str; 18] = [
    "time",
    "t",
    "times",
    "seconds",
    "zeit",
    "temps",
    "tiempo",
    "tempo",
    "tijd",
    "czas",
    "zaman",
    "x-value",
    "elapsed-time",
    "time-elapsed",
    "timestamp",
    "time-stamp",
    "datetime",
    "date-time",
];

/// What a column is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    Time,
    Load(usize),
    Other,
}

/// A name in a header.
#[derive(Debug, Clone)]
pub(super) struct Name {
    /// As it is written, without its unit.
    pub(super) own: String,
    pub(super) unit: Option<String>,
    pub(super) role: Role,
}

fn role(name: &str) -> Role {
    // “Latest: Time” is the time of a run.
    let name = name.rsplit(": ").next().unwrap_or_default();
    let name = name.to_lowercase().replace(['_', ' '], "-");
    if TIMES.contains(&name.as_str()) {
        return Role::Time;
    }
    let is_of = |(own, others, ..): &(&str, &[&str], Kind, Excitation)| {
        *own == name || others.contains(&name.as_str())
    };
    if let Some(load) = LOADS.iter().position(is_of) {
        return Role::Load(load);
    }
    // One of several: acc-x, a_x, acc1, acceleration-ns, force-0.
    let stems = [("acceleration", 0), ("accel", 0), ("acc", 0), ("a", 0), ("force", 1)];
    let found = stems.into_iter().find_map(|(stem, load)| Some((name.strip_prefix(stem)?, load)));
    match found {
        Some((rest, load)) if rest.starts_with(|c: char| !c.is_alphabetic()) => Role::Load(load),
        _ => Role::Other,
    }
}

/// Whether a word behind the name of a column is its unit: “acc N” is a direction.
fn fits(role: Role, unit: &str) -> bool {
    Reader::is_unit(unit)
        && match role {
            Role::Other => false,
            Role::Load(0) => unit.contains('/') || matches!(unit, "g" | "mg" | "gal" | "Gal"),
            Role::Time | Role::Load(_) => true,
        }
}

impl Name {
    pub(super) fn new(header: &str) -> Self {
        let (own, unit) = name_and_unit(header);
        let mut name = Self { own: own.to_owned(), unit: unit.map(str::to_owned), role: role(own) };
        // “Time s”, “acc_g”, “t/s”, “a/(m/s²)”.
        let whole = header.trim();
        for (stem, last) in [own.rsplit_once([' ', '_', ',']), whole.split_once('/')].into_iter().flatten() {
            let stem = stem.trim_end_matches([' ', ',']);
            let last = text::unit(last);
            if fits(role(stem), &last) && (name.unit.is_none() || name.role == Role::Other) {
                name = Self { own: stem.to_owned(), role: role(stem), unit: Some(last) };
            }
        }
        name
    }

    /// Whether the name says that the column is the time or a load.
    pub(super) fn is_known(&self) -> bool {
        self.role != Role::Other
    }

    /// Whether the column may be a load: by its name, or by its unit.
    pub(super) fn is_load(&self) -> bool {
        match self.role {
            Role::Load(_) => true,
            Role::Time => false,
            Role::Other => self.is_in_unit_of(Kind::Acceleration) || self.is_in_unit_of(Kind::Force),
        }
    }

    /// Whether the column has a unit of this kind.
    pub(super) fn is_in_unit_of(&self, kind: Kind) -> bool {
        let reader = Reader::new(None, "");
        let unit = self.unit.as_ref().map(|unit| text::unit(unit));
        unit.is_some_and(|unit| reader.factor_of_column("", &unit, kind).is_ok())
    }

    /// Whether the name is one of a displacement or a velocity.
    pub(super) fn is_named_as(&self, kind: Kind) -> bool {
        let names: &[&str] = match kind {
            Kind::Length => {
                &["displacement", "foot-displacement", "damped-foot-displacement", "disp", "x", "u"]
            }
            Kind::Velocity => &["velocity", "vel", "v", "speed"],
            _ => &[],
        };
        names.contains(&self.own.to_lowercase().replace(['_', ' '], "-").as_str())
    }

    /// Whether this is the name of a column that was asked for: with or without its unit, and of “Latest: Force” the last
    /// part, too.
    pub(super) fn is(&self, asked: &str) -> bool {
        let asked = asked.trim();
        let last = self.own.rsplit(": ").next().unwrap_or_default();
        [asked, Self::new(asked).own.as_str()]
            .into_iter()
            .any(|asked| self.own.eq_ignore_ascii_case(asked) || last.eq_ignore_ascii_case(asked))
    }
}

/// The names of the columns and their units: the last line without numbers that has a name of a time or of a load, or else
/// the last one; the line below may have the units.
pub(super) fn header(titles: &[Line], remark: Option<&str>, width: usize) -> Vec<Name> {
    let of = |text: &str| -> Vec<Name> {
        Delimiter::names(text, width).iter().map(|name| Name::new(name)).collect()
    };
    let is_known = |names: &Vec<Name>| names.iter().any(Name::is_known);
    // Words in a sentence are no names, unless they are as many as the columns.
    let titles: Vec<Line> = titles
        .iter()
        .filter(|(_, line)| Delimiter::of(line) != Delimiter::Blanks || width == 0 || of(line).len() == width)
        .cloned()
        .collect();
    let titles = titles.as_slice();
    let Some(((_, last), above)) = titles.split_last() else {
        // The header of a table may be a comment, which then names a time or a unit: “# a comment” does not.
        let is_header = |names: &Vec<Name>| {
            names.len() == width
                && is_known(names)
                && names.iter().any(|name| name.role == Role::Time || name.unit.is_some())
        };
        return remark.map(of).filter(is_header).unwrap_or_default();
    };
    let found = of(last);
    if is_known(&found) {
        return with_label(found, titles);
    }
    let units = Delimiter::names(last, width);
    let are_units = units.iter().any(|unit| !unit.is_empty())
        && units.iter().all(|unit| unit.is_empty() || unit == "-" || Reader::is_unit(&text::unit(unit)));
    let rows = || above.iter().rev().map(|(_, text)| of(text));
    let same = |names: &Vec<Name>| names.len() == units.len();
    // A row of units is below the names, whatever these are; another one may be below a name that is known.
    let before = if are_units { rows().find(same) } else { rows().find(is_known) };
    let Some(mut before) = before else { return found };
    if are_units && same(&before) {
        for (name, unit) in before.iter_mut().zip(units) {
            if name.unit.is_none() && !unit.is_empty() && unit != "-" {
                name.unit = Some(text::unit(&unit));
            }
        }
    }
    with_label(before, titles)
}

/// The names of LabVIEW, whose units stand in a line of the header.
fn with_label(mut names: Vec<Name>, titles: &[Line]) -> Vec<Name> {
    let labels = titles.iter().find_map(|(_, line)| line.strip_prefix("Y_Unit_Label"));
    let units = labels.map(|labels| labels.split(['\t', ',']).skip(1).map(str::trim)).into_iter().flatten();
    let values = names.iter_mut().filter(|name| name.role != Role::Time && !name.is_remark());
    for (name, unit) in values.zip(units) {
        if name.unit.is_none() && !unit.is_empty() {
            name.unit = Some(unit.to_owned());
        }
    }
    names
}

impl Name {
    /// Whether this is the column of remarks, which most rows do not have.
    pub(super) fn is_remark(&self) -> bool {
        self.own.eq_ignore_ascii_case("comment")
    }
}

/// The keys of a step, and those of samples a second, in lines before the columns.
const STEPS: [&str; 11] = [
    "dt",
    "delta t",
    "delta x",
    "time step",
    "timestep",
    "time interval",
    "sampling interval",
    "sample interval",
    "sampling period",
    "sample period",
    "sampling time",
];
const RATES: [&str; 8] = [
    "fs",
    "sample rate",
    "samplerate",
    "sampling rate",
    "sampling frequency",
    "sample frequency",
    "abtastrate",
    "abtastfrequenz",
];

/// The step in a line such as `Sample rate: 100 Hz`, `dt = 0.01 s` or `Sampling rate (Hz),100`: the text of its number, its
/// unit, and whether it is one of samples a second.
pub(super) fn step(line: &str) -> Option<(String, String, bool)> {
    let line = comment(line).unwrap_or(line);
    let (key, value) = line.split_once([':', '=', '\t', ';', ','])?;
    let (key, unit) = name_and_unit(key);
    let key = key.to_lowercase().replace(['_', '-'], " ");
    let (is_step, is_rate) = (STEPS.contains(&key.as_str()), RATES.contains(&key.as_str()));
    let value = value.trim().trim_matches(['"', '\t', ';', ',']);
    // “10,000 Hz” may be ten or ten thousand.
    let after = value.split_once(',').map(|(_, after)| after.bytes().take_while(u8::is_ascii_digit).count());
    if after == Some(3) {
        return None;
    }
    let value = value.replace(',', ".");
    let (digits, own) = crate::inputs::units::split(&value);
    text::number::<f64>(digits).filter(|number| *number > 0.0 && (is_step || is_rate))?;
    let unit = if own.is_empty() { unit.unwrap_or_default() } else { own };
    Some((digits.to_owned(), unit.to_owned(), is_rate))
}
