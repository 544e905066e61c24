//! A described system with its motions.

use super::described::{Described, samples};
use super::laws::set_points;
use super::node::{Number, is_double, nearest};
use super::why::Why;
use super::{file, named};
use crate::inputs::units::{Kind, Reader, System as Units};
use crate::text::Folder;
use serde_json::Value;
use std::ops::ControlFlow;
use std::path::Path;
use stickslip::Excitation;
use stickslip::motion::record::{After, Record};
use stickslip::system::{Beyond, Border, Cycle, Error, Level, Model, Record as Samples, System};

/// The longest motion, in steps: a step is a radian of the fastest vibration, or the time of the fastest damper. A large system
/// has [`System::most_steps`].
const MOST_STEPS: u64 = 1_000_000;
/// The steps in which a value must be passed: a few seconds of work with all of its events.
const STEPS_TO_PASSAGE: u64 = 100_000;

/// Why a curve has no more digits than a double.
const OF_DOUBLES: &str =
    "must be a table with more bits than a double has: the digits of a curve are estimated";

/// A described system with its motions.
#[derive(Debug, Clone)]
pub struct NamedSystem<F = f64> {
    /// The description.
    pub described: Described<F>,
    /// Its motions, with laws that are curves as tables: [`NamedSystem::simulate`] and its like refine them.
    pub system: System<F>,
    pub(super) keep_going: fn() -> ControlFlow<()>,
}

impl<F: Number> NamedSystem<F> {
    /// As [`NamedSystem::new`], in any numbers.
    pub(super) fn read<'s>(
        value: &Value,
        set: impl IntoIterator<Item = (&'s str, &'s str)>,
        folder: &Folder<'_>,
        units: Option<&Units>,
    ) -> Result<Self, String> {
        let built = |value: &Value, folder: &Folder<'_>| Self::of(file::described(value, folder, units)?);
        let set: Vec<(&str, &str)> = set.into_iter().collect();
        if set.is_empty() {
            return built(value, folder);
        }
        let mut other = value.clone();
        for (path, new) in &set {
            NamedSystem::set(&mut other, path, new)?;
        }
        built(&other, folder).map_err(|why| {
            // What was typed is wrong where the file alone is not.
            let typed =
                || set.iter().map(|(path, new)| format!("{path}={new}")).collect::<Vec<_>>().join(" ");
            if built(value, &folder.again()).is_ok() { format!("{}: {why}", typed()) } else { why }
        })
    }

    /// A described system, if it has motions.
    pub(super) fn of(mut described: Described<F>) -> Result<Self, String> {
        let Described { laws, model, start, .. } = &mut described;
        for law in laws {
            if !is_double::<F>() {
                return Err(law.about(OF_DOUBLES));
            }
            law.begin(model, start);
            if let Some(element) = model.elements.get_mut(law.element) {
                let points = law.of_slopes(element)?;
                set_points(&mut element.kind, points);
            }
        }
        match described.moving(&described.model) {
            Ok(system) => Ok(Self { described, system, keep_going: || ControlFlow::Continue(()) }),
            Err(error) => Err(with_names(&described, &error)),
        }
    }

    /// This system, whose motions are followed as long as `keep_going` returns [`ControlFlow::Continue`].
    #[must_use]
    pub fn while_allowed(self, keep_going: fn() -> ControlFlow<()>) -> Self {
        Self { system: self.system.while_allowed(keep_going), keep_going, ..self }
    }

    /// Whether a law is a curve.
    #[must_use]
    pub fn has_curves(&self) -> bool {
        !self.described.laws.is_empty()
    }

    /// As [`NamedSystem::with_record`], in any numbers.
    pub(super) fn shaken(mut self, record: &Record<F>, name: &str) -> Result<Self, String> {
        if record.excitation() != Excitation::SurfaceAcceleration {
            return Err(format!("{name}: must be a record of an acceleration"));
        }
        let beyond = if record.after() == After::Hold { Beyond::Hold } else { Beyond::Zero };
        self.described.shake(samples(record, beyond));
        Self::of(self.described)
    }

    /// Under loads of another frequency: the lowest becomes this one, and all others change in proportion.
    ///
    /// # Errors
    /// Without a harmonic load or a record that repeats itself, or for a frequency that is not positive and finite.
    pub fn at_frequency(mut self, frequency: F) -> Result<Self, String> {
        if !(frequency > F::int(0) && frequency.is_finite()) {
            return Err("must be > 0 and finite".to_owned());
        }
        let Model { harmonics, records, .. } = &mut self.described.model;
        let repeated = || records.iter().filter(|record| record.beyond == Beyond::Repeat).filter_map(rate);
        let all = harmonics.iter().map(|h| h.frequency).chain(repeated());
        let lowest = all.reduce(|a, b| if b < a { b } else { a });
        let lowest = lowest.ok_or("the system has no load that repeats itself")?;
        for harmonic in harmonics {
            let is_lowest = harmonic.frequency == lowest;
            harmonic.frequency = if is_lowest { frequency } else { harmonic.frequency / lowest * frequency };
        }
        for record in records.iter_mut().filter(|record| record.beyond == Beyond::Repeat) {
            record.times.iter_mut().for_each(|t| *t = *t * (lowest / frequency));
        }
        Self::of(self.described)
    }

    /// As [`NamedSystem::border`], in any numbers.
    pub(super) fn border_with_cycle(&self) -> Result<(Border<F>, Option<Cycle<F>>), Error> {
        let found = self.system.border()?;
        Ok((found, self.system.cycle()?.filter(|cycle| cycle.margin >= F::int(1))))
    }

    /// The reader of values in the units of the system.
    #[must_use]
    pub fn reader(&self) -> Reader {
        Reader::new(self.described.units.as_ref(), "units in the file")
    }

    /// The end of the last record, or of the first period of one that repeats itself; 0 without a record.
    #[must_use]
    pub fn end_of_records(&self) -> F {
        let ends = self.described.model.records.iter().filter_map(|record| record.times.last());
        ends.fold(F::int(0), |last, &end| if end > last { end } else { last })
    }

    /// The end of a motion as it is typed for an argument of this name: a time, or `NAME = VALUE`, which adds a level and finds by `passage`
    /// when it is passed first; without one the end of the records.
    pub(super) fn until_by(
        &mut self,
        name: &str,
        typed: Option<&str>,
        passage: impl Fn(&Self, usize, F) -> Result<Option<F>, Why>,
    ) -> Result<F, String> {
        let (until, shown) = match typed {
            Some(text) if text.contains('=') => {
                return self.until_passage(text, passage).map_err(|e| format!("{name} {e}"));
            }
            Some(text) => {
                let until = self.reader().value(name, text, Kind::Time).map_err(|e| e.to_string())?;
                (until, format!("{name} {text}"))
            }
            None => {
                let end = self.end_of_records();
                (end, format!("end of the records {}", crate::words::digits(end.to_f64())))
            }
        };
        self.check_until(until, &shown)?;
        Ok(until)
    }

    fn until_passage(
        &mut self,
        typed: &str,
        passage: impl Fn(&Self, usize, F) -> Result<Option<F>, Why>,
    ) -> Result<F, String> {
        let (name, value) = typed.split_once('=').ok_or_else(|| format!("{typed}: must be NAME = VALUE"))?;
        let name = name.trim();
        let Described { model, coordinates, .. } = &self.described;
        let own = |name: &str| named::along(coordinates, model, name);
        let by = |end: &str| name.strip_suffix(end).and_then(own);
        let (direction, kind) = match (own(name), by(".velocity"), by(".displacement")) {
            (Some(direction), ..) | (None, None, Some(direction)) => (direction, Kind::Length),
            (None, Some(direction), _) => (direction, Kind::Velocity),
            (None, None, None) => {
                let names = coordinates.iter().chain(model.elements.iter().map(|element| &element.name));
                let near = nearest(name, names.map(String::as_str));
                return Err(format!("{typed}: {name} is neither a body nor a contact or stop. {near}"));
            }
        };
        let value: F = self.reader().value(typed, value.trim(), kind).map_err(|e| e.to_string())?;
        let (displacement, velocity) =
            if kind == Kind::Velocity { (Vec::new(), direction) } else { (direction, Vec::new()) };
        let level = self.described.model.levels.len();
        let mut described = self.described.clone();
        described.model.levels.push(Level { name: name.to_owned(), displacement, velocity, value });
        *self = Self::of(described)?.while_allowed(self.keep_going);
        let count = self.system.most_steps().min(STEPS_TO_PASSAGE);
        let (steps, zero, one) = (F::from_f64(count as f64), F::int(0), F::int(1));
        let (rate, end) = (self.system.steps_per_time(), self.end_of_records());
        let latest = if rate > zero { steps / rate } else { steps * if end > one { end } else { one } };
        let found = passage(self, level, latest);
        found.map_err(|e| e.to_string())?.ok_or_else(|| {
            let unit = if self.described.units.is_some() { " s" } else { "" };
            let latest = crate::words::digits(latest.to_f64());
            format!("{typed}: must be passed within {latest}{unit}, {count} steps of the fastest motion, but is not")
        })
    }

    /// Fails where a motion to this time has no length, or more steps than 10⁶ or the system's budget, which only the motion itself tells where
    /// fast modes do not shorten its steps.
    ///
    /// # Errors
    /// Names the greatest time.
    pub fn check_until(&self, until: F, typed: &str) -> Result<(), String> {
        if !(until > F::int(0) && until.is_finite()) {
            return Err(format!("{typed}: must be > 0 and finite"));
        }
        let steps = self.system.most_steps().min(MOST_STEPS);
        let most = F::from_f64(steps as f64) / self.system.steps_per_time();
        if until <= most || self.system.has_long_steps(until) {
            return Ok(());
        }
        let unit = if self.described.units.is_some() { " s" } else { "" };
        let most = crate::words::digits(most.to_f64());
        let steps = if steps == MOST_STEPS { "10⁶".to_owned() } else { steps.to_string() };
        Err(format!("{typed}: must be ≤ {most}{unit}, {steps} steps of the fastest motion"))
    }
}

// What is generic would be compiled again in each crate that calls it.
impl NamedSystem {
    /// The system of a value that [`parsed`](super::parsed) returned, with other values at some paths, in the units
    /// given or else in its own. Names of files in it are taken from the folder.
    ///
    /// # Errors
    /// One line with the place in the value, or the element, and the condition.
    pub fn new<'s>(
        value: &Value,
        set: impl IntoIterator<Item = (&'s str, &'s str)>,
        folder: &Path,
        units: Option<&Units>,
    ) -> Result<Self, String> {
        let set: Vec<(&str, &str)> = set.into_iter().collect();
        Self::in_folder(value, &set, &Folder::new(folder), units)
    }

    /// As [`NamedSystem::new`], where the folder keeps the first file that was not opened.
    ///
    /// # Errors
    /// As there.
    pub fn in_folder(
        value: &Value,
        set: &[(&str, &str)],
        folder: &Folder<'_>,
        units: Option<&Units>,
    ) -> Result<Self, String> {
        Self::read(value, set.iter().copied(), folder, units)
    }

    /// With a record of the base's acceleration beside the loads of the file.
    ///
    /// # Errors
    /// Where the record is of another load.
    pub fn with_record(self, record: &Record<f64>, name: &str) -> Result<Self, String> {
        self.shaken(record, name)
    }

    /// The border, and the cycle at the load of the file: below the border it is no motion.
    ///
    /// # Errors
    /// As [`System::border`].
    pub fn border(&self) -> Result<(Border<f64>, Option<Cycle<f64>>), Error> {
        self.border_with_cycle()
    }

    /// Sets a value at a path of a description: `name.field` of a named contact, spring, stop or body, or places in lists from
    /// 1, such as `forces[1].amplitude`.
    ///
    /// # Errors
    /// Where there is no such place.
    pub fn set(value: &mut Value, path: &str, new: &str) -> Result<(), String> {
        named::set(value, path.trim(), new.trim())
    }

    /// Sets the force within which the tables of all laws that are curves are.
    ///
    /// # Errors
    /// Where there is no such law.
    pub fn set_tolerance(value: &mut Value, force: &str) -> Result<(), String> {
        let curves = ["contacts", "springs", "elements"].into_iter().flat_map(|list| {
            let count = value.get(list).and_then(Value::as_array).map_or(0, Vec::len);
            (0..count).map(move |place| format!("/{list}/{place}/law"))
        });
        let curves: Vec<_> =
            curves.filter(|path| value.pointer(path).is_some_and(Value::is_object)).collect();
        if curves.is_empty() {
            return Err("must be left out: no law of the file is a curve".to_owned());
        }
        let typed = named::typed(force.trim());
        for path in curves {
            if let Some(law) = value.pointer_mut(&path).and_then(Value::as_object_mut) {
                law.insert("tolerance".to_owned(), typed.clone());
            }
        }
        Ok(())
    }
}

/// The angular frequency of a record that repeats itself.
fn rate<F: Number>(record: &Samples<F>) -> Option<F> {
    Some(F::int(2) * F::pi() / (*record.times.last()? - *record.times.first()?))
}

/// The error of the engine, whose coordinates have the names of the file.
fn with_names<F>(described: &Described<F>, error: &Error) -> String {
    match error {
        Error::NotDefinite { row, .. } => match described.coordinates.get(row.saturating_sub(1)) {
            Some(name) => format!("{name}: {error}"),
            None => error.to_string(),
        },
        _ => error.to_string(),
    }
}
