//! The columns of a table that are read: its time and its load.

use super::super::{Options, Unit};
use super::Known;
use super::header::{LOADS, Name, Role};
use crate::inputs::units::Kind;
use crate::names::is_misspelt;
use stickslip::Excitation;

/// The columns that are read.
pub(super) struct Columns {
    pub(super) time: Option<usize>,
    pub(super) load: usize,
    /// The excitation and the unit of the load; without one, a value may have its own.
    pub(super) excitation: Excitation,
    pub(super) kind: Kind,
    pub(super) unit: Option<Unit>,
    /// The unit of the time other than the second.
    pub(super) second: Option<Unit>,
    pub(super) channel: Option<String>,
    pub(super) unused: Vec<String>,
    pub(super) name: String,
    /// Every number is a sample.
    pub(super) all: bool,
    /// The last column is one of remarks, which a row may leave out.
    pub(super) has_remarks: bool,
}

/// The column of a name or of a number from 1.
fn chosen(names: &[Name], column: &str) -> Option<usize> {
    let same = |name: &Name| name.is(column);
    names.iter().position(same).or_else(|| {
        let place = column.trim().parse::<usize>().ok()?.checked_sub(1)?;
        names.get(place).map(|_| place)
    })
}

/// The own names of the columns at these places.
fn listed(names: &[Name], places: impl IntoIterator<Item = usize>) -> String {
    let names: Vec<_> = places.into_iter().filter_map(|place| Some(names.get(place)?.own.as_str())).collect();
    names.join(", ")
}

/// The column of the time: the one that was asked for, the one of that name, or the only one with a unit of time.
fn time(names: &[Name], options: &Options<'_>) -> Result<Option<usize>, String> {
    if let Some(asked) = options.time_column {
        return chosen(names, asked).map(Some).ok_or_else(|| {
            let all = listed(names, 0..names.len());
            format!("{} {asked}: must be a column of {}: {all}", options.words.time_column, options.name)
        });
    }
    let of_role = |(place, name): (usize, &Name)| (name.role == Role::Time).then_some(place);
    let named: Vec<usize> = names.iter().enumerate().filter_map(of_role).collect();
    if named.len() > 1 {
        let all = listed(names, named);
        let word = options.words.time_column;
        return Err(format!("{}: has several columns of time: {all}. Choose one by {word}", options.name));
    }
    let of_name = named.first().copied();
    let is_time = |name: &&(usize, &Name)| {
        let unit = name.1.unit.as_ref().map(|unit| super::text::unit(unit));
        name.1.role == Role::Other
            && unit.is_some_and(|unit| {
                matches!(unit.as_str(), "s" | "sec" | "ms" | "us" | "µs" | "μs" | "min" | "h")
            })
    };
    let all: Vec<(usize, &Name)> = names.iter().enumerate().collect();
    let of_unit: Vec<usize> = all.iter().filter(is_time).map(|(place, _)| *place).collect();
    Ok(of_name.or(match of_unit.as_slice() {
        [one] => Some(*one),
        _ => None,
    }))
}

/// The load of a table with names.
fn load(
    names: &[Name],
    time: Option<usize>,
    title: &str,
    options: &Options<'_>,
    known: &Known,
) -> Result<usize, String> {
    let file = options.name;
    if let (None, Some(kind)) = (options.column, options.quantity) {
        return of_quantity(names, time, kind, options);
    }
    let is_load = |place: usize, name: &Name| {
        Some(place) != time && (name.is_load() || (known.unit.is_some() && name.role != Role::Time))
    };
    let loads =
        || names.iter().enumerate().filter(|(place, name)| is_load(*place, name)).map(|(place, _)| place);
    // A name that says what the column is goes before a unit that does.
    let said: Vec<usize> =
        loads().filter(|place| names.get(*place).is_some_and(|name| name.role != Role::Other)).collect();
    if said.is_empty() && options.column.is_none() {
        let spelt = LOADS.iter().map(|(name, ..)| *name).chain(["time"]);
        for name in names.iter().filter(|name| name.role == Role::Other) {
            if let Some(known) = spelt.clone().find(|known| is_misspelt(&name.own, known)) {
                return Err(format!(
                    "{file}: column {} is unknown. Spell it {known}, or rename it",
                    name.own
                ));
            }
        }
    }
    let loads: Vec<usize> = if said.is_empty() { loads().collect() } else { said };
    match (options.column, loads.as_slice()) {
        (Some(column), _) => chosen(names, column).ok_or_else(|| {
            let all = listed(names, 0..names.len());
            format!("{} {column}: must be a column of {file}: {all}", options.words.column)
        }),
        (None, [one]) => Ok(*one),
        (None, []) => {
            let spelt: Vec<_> = LOADS.iter().map(|(name, ..)| *name).collect();
            // A column without a unit may be one of a load; a unit says that it is none.
            let may = |(place, name): (usize, &Name)| Some(place) != time && name.unit.is_none();
            let choose = match names.iter().enumerate().any(may) {
                true => format!(", or choose one by {}", options.words.column),
                false => String::new(),
            };
            Err(format!(
                "{file}: a column of the load is missing in the header “{title}”. Name one of {}, such as \
                 acceleration[g]{choose}",
                spelt.join(", "),
            ))
        }
        (None, many) => Err(format!(
            "{file}: has the columns {}. Choose one by {}",
            listed(names, many.iter().copied()),
            options.words.column
        )),
    }
}

/// The only column with a unit of a quantity, or else of its name, or else beside the time.
fn of_quantity(
    names: &[Name],
    time: Option<usize>,
    kind: Kind,
    options: &Options<'_>,
) -> Result<usize, String> {
    let all = || names.iter().enumerate().filter(|(place, name)| Some(*place) != time && !name.is_remark());
    let places = |is: &dyn Fn(&Name) -> bool| -> Vec<usize> {
        all().filter(|(_, name)| is(name)).map(|(place, _)| place).collect()
    };
    let found = [
        places(&|name| name.is_in_unit_of(kind)),
        places(&|name| name.is_named_as(kind)),
        places(&|name| name.role == Role::Other && name.unit.is_none()),
    ];
    let found = found.into_iter().find(|places| !places.is_empty()).unwrap_or_default();
    match found.as_slice() {
        [one] => Ok(*one),
        [] => {
            let (due, file) = (kind.expected(), options.name);
            let all = listed(names, 0..names.len());
            Err(format!(
                "{file}: has no column of {due}: {all}. Write its unit after its name, as in time[s]"
            ))
        }
        many => Err(format!(
            "{}: has the columns {}. Choose one by {}",
            options.name,
            listed(names, many.iter().copied()),
            options.words.column
        )),
    }
}

/// The columns of a table with names.
pub(super) fn named(
    names: &[Name],
    title: &str,
    options: &Options<'_>,
    known: &Known,
) -> Result<Columns, String> {
    let file = options.name;
    let time = time(names, options)?;
    let load = load(names, time, title, options, known)?;
    let name = names.get(load).ok_or_else(|| format!("{file}: no load"))?;
    let at = format!("{file}: column {}", name.own);
    let of_role = match name.role {
        Role::Load(index) => LOADS.get(index).map(|(own, _, kind, excitation)| (*own, *kind, *excitation)),
        _ if Some(load) == time => return Err(format!("{at}: must be a load, not the time")),
        _ => None,
    };
    let is_mass = |word: &&str| name.own.to_lowercase().contains(*word);
    if of_role.is_none()
        && name.unit.as_deref().is_some_and(|unit| matches!(super::text::unit(unit).as_str(), "g" | "mg"))
        && ["mass", "weight", "gewicht", "peso", "poids", "massa"].iter().any(is_mass)
    {
        return Err(format!("{at}: must be a load, and its unit is that of a mass"));
    }
    let kind = of_role.map(|(_, kind, _)| kind);
    if let (Some(due), Some(own)) = (options.quantity, kind)
        && due != own
    {
        return Err(format!("{at}: must be {}", due.expected()));
    }
    let kind = kind.or(options.quantity);
    let unit = match (&known.unit, &name.unit, options.units) {
        (Some(unit), ..) => Some(unit.clone()),
        (None, Some(_), Some(typed)) => {
            return Err(format!(
                "{} {typed}: must be left out, because {at} has a unit",
                options.words.units
            ));
        }
        (None, Some(unit), None) => Some(options.named_unit(&at, Some(unit), kind)?),
        (None, None, Some(typed)) => Some(options.named_unit(options.words.units, Some(typed), kind)?),
        (None, None, None) if options.sensitivity().is_some() => Some(options.named_unit(&at, None, kind)?),
        (None, None, None) if kind.is_none() => {
            return Err(format!("{at}: has no unit. Give it by {}, such as g", options.words.units));
        }
        (None, None, None) => None,
    };
    // A signal in volts is what its sensitivity says.
    let is_said = |unit: &&Unit| options.sensitivity().is_some() && Some(unit.kind) != kind;
    let excitation = match (of_role, &unit) {
        (_, Some(unit)) if is_said(&unit) => Some(unit.excitation()),
        (Some((.., excitation)), _) => Some(excitation),
        (None, unit) => unit.as_ref().map(Unit::excitation),
    };
    let second = match time.and_then(|time| names.get(time)?.unit.as_ref()) {
        Some(unit) => {
            Some(Unit::new(&format!("{file}: column time"), unit, options.reader, Some(Kind::Time))?)
        }
        None => None,
    };
    let is_used = |place: &usize| *place == load || Some(*place) == time;
    let is_kept = |place: &usize| !is_used(place) && names.get(*place).is_some_and(|name| !name.is_remark());
    let unused = (0..names.len()).filter(is_kept).filter_map(|place| Some(names.get(place)?.own.clone()));
    Ok(Columns {
        time,
        load,
        excitation: excitation.unwrap_or(Excitation::SurfaceAcceleration),
        kind: unit.as_ref().map(|unit| unit.kind).or(kind).unwrap_or(Kind::Acceleration),
        unit,
        second,
        channel: Some(name.own.clone()),
        unused: if options.column.is_some() { Vec::new() } else { unused.collect() },
        name: of_role.map_or_else(|| name.own.clone(), |(own, ..)| own.to_owned()),
        all: false,
        has_remarks: names.last().is_some_and(Name::is_remark),
    })
}

/// The columns of a table without names.
pub(super) fn unnamed(
    width: usize,
    has_step: bool,
    options: &Options<'_>,
    known: &Known,
) -> Result<Columns, String> {
    let (file, words) = (options.name, options.words);
    let all = options.column.is_some_and(|column| column.trim().eq_ignore_ascii_case("all"));
    let place = |word: &str, text: &str, more: &str| {
        let place = text.parse::<usize>().ok().filter(|place| (1..=width).contains(place));
        place.and_then(|place| place.checked_sub(1)).ok_or_else(|| {
            let due = format!(
                "must be a number from 1 to {width}{more}, because the columns of {file} have no names"
            );
            format!("{word} {text}: {due}")
        })
    };
    let asked = options.time_column.map(|text| place(words.time_column, text.trim(), "")).transpose()?;
    let time = asked.or((!has_step && !all && width > 1).then_some(0));
    let load = match options.column.map(str::trim) {
        Some(_) if all => 0,
        Some(column) => place(words.column, column, ", or all")?,
        None if width == 1 => 0,
        None if width == 2 && time.is_some() => usize::from(time == Some(0)),
        None => {
            return Err(format!(
                "{file}: has {width} columns without names. Choose one by {}, such as {width}, or all, row by row",
                words.column
            ));
        }
    };
    if time == Some(load) {
        let number = load.saturating_add(1);
        return Err(match asked {
            Some(_) => format!("{} {number}: must be a load, not the time", words.column),
            None => {
                format!("{} {number}: must be a load, because the first column is the time", words.column)
            }
        });
    }
    let unit = match (&known.unit, options.quantity) {
        (Some(unit), _) => Some(unit.clone()),
        // Bare numbers are in the system of the reader.
        (None, Some(_)) if options.units.is_none() => None,
        (None, _) => Some(options.unit(None, None)?),
    };
    let channel = options.column.map(|column| format!("column {}", column.trim()));
    Ok(Columns {
        time,
        load,
        excitation: unit.as_ref().map_or(Excitation::FootMotion, Unit::excitation),
        kind: unit.as_ref().map(|unit| unit.kind).or(options.quantity).unwrap_or(Kind::Acceleration),
        unit,
        second: None,
        channel: channel.filter(|_| !all),
        unused: Vec::new(),
        name: "the load".to_owned(),
        all,
        has_remarks: false,
    })
}
