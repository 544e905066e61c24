//! A described system with its motions.

use super::described::{Described, samples};
use super::laws::set_points;
use super::node::nearest;
use super::{file, named};
use crate::inputs::units::{Kind, Reader, System as Units};
use serde_json::Value;
use std::f64::consts::TAU;
use std::ops::ControlFlow;
use std::path::Path;
use stickslip::Excitation;
use stickslip::motion::record::{After, Record};
use stickslip::system::{Beyond, Error, Level, Model, Record as Samples, System};

/// The longest motion, in steps: a step is a radian of the fastest vibration, or the time of the fastest damper. A large system
/// has [`System::most_steps`].
const MOST_STEPS: u64 = 1_000_000;
/// The steps in which a value must be passed: a few seconds of work with all of its events.
const STEPS_TO_PASSAGE: u64 = 100_000;

/// A described system with its motions.
#[derive(Debug, Clone)]
pub struct NamedSystem {
    /// The description.
    pub described: Described,
    /// Its motions, with laws that are curves as tables: [`NamedSystem::simulate`] and its like refine them.
    pub system: System<f64>,
    pub(super) keep_going: fn() -> ControlFlow<()>,
}

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
        let built = |value: &Value| Self::of(file::described(value, folder, units)?);
        let set: Vec<(&str, &str)> = set.into_iter().collect();
        if set.is_empty() {
            return built(value);
        }
        let mut other = value.clone();
        for (path, new) in &set {
            Self::set(&mut other, path, new)?;
        }
        built(&other).map_err(|why| {
            // What was typed is wrong where the file alone is not.
            let typed =
                || set.iter().map(|(path, new)| format!("{path}={new}")).collect::<Vec<_>>().join(" ");
            if built(value).is_ok() { format!("{}: {why}", typed()) } else { why }
        })
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

    /// A described system, if it has motions.
    pub(super) fn of(mut described: Described) -> Result<Self, String> {
        let Described { laws, model, start, .. } = &mut described;
        for law in laws {
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

    /// With a record of the base's acceleration beside the loads of the file.
    ///
    /// # Errors
    /// Where the record is of another load.
    pub fn with_record(mut self, record: &Record<f64>, name: &str) -> Result<Self, String> {
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
    pub fn at_frequency(mut self, frequency: f64) -> Result<Self, String> {
        if !(frequency > 0.0 && frequency.is_finite()) {
            return Err("must be > 0 and finite".to_owned());
        }
        let Model { harmonics, records, .. } = &mut self.described.model;
        let repeated = || records.iter().filter(|record| record.beyond == Beyond::Repeat).filter_map(rate);
        let all = harmonics.iter().map(|h| h.frequency).chain(repeated());
        let lowest = all.fold(f64::INFINITY, f64::min);
        if !lowest.is_finite() {
            return Err("the system has no load that repeats itself".to_owned());
        }
        for harmonic in harmonics {
            let is_lowest = harmonic.frequency == lowest;
            harmonic.frequency = if is_lowest { frequency } else { harmonic.frequency / lowest * frequency };
        }
        for record in records.iter_mut().filter(|record| record.beyond == Beyond::Repeat) {
            record.times.iter_mut().for_each(|t| *t *= lowest / frequency);
        }
        Self::of(self.described)
    }

    /// The reader of values in the units of the system.
    #[must_use]
    pub fn reader(&self) -> Reader {
        Reader::new(self.described.units.as_ref(), "units in the file")
    }

    /// The end of the last record, or of the first period of one that repeats itself; 0 without a record.
    #[must_use]
    pub fn end_of_records(&self) -> f64 {
        let ends = self.described.model.records.iter().filter_map(|record| record.times.last());
        ends.fold(0.0, |last: f64, &end| last.max(end))
    }

    /// The time at which a level is passed first, `NAME = VALUE`: a displacement of a body, a contact or a stop, or with `NAME.velocity` a
    /// velocity. Its passages are events of the motions then.
    ///
    /// # Errors
    /// Where there is no such name, or the value is not passed within the longest motion.
    pub fn until_level(&mut self, typed: &str) -> Result<f64, String> {
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
        let value: f64 = self.reader().value(typed, value.trim(), kind).map_err(|e| e.to_string())?;
        let (displacement, velocity) =
            if kind == Kind::Velocity { (Vec::new(), direction) } else { (direction, Vec::new()) };
        let level = self.described.model.levels.len();
        let mut described = self.described.clone();
        described.model.levels.push(Level { name: name.to_owned(), displacement, velocity, value });
        *self = Self::of(described)?.while_allowed(self.keep_going);
        let steps = self.system.most_steps().min(STEPS_TO_PASSAGE) as f64;
        let rate = self.system.steps_per_time();
        let latest = if rate > 0.0 { steps / rate } else { steps * self.end_of_records().max(1.0) };
        let found = self.first_passage(level, latest);
        found.map_err(|e| e.to_string())?.ok_or_else(|| {
            let unit = if self.described.units.is_some() { " s" } else { "" };
            let latest = crate::words::digits(latest);
            format!("{typed}: must be passed within {latest}{unit}, {steps} steps of the fastest motion, but is not")
        })
    }

    /// Fails where a motion to this time has no length, or more steps than 10⁶ or the system's budget, which only the motion itself tells where
    /// fast modes do not shorten its steps.
    ///
    /// # Errors
    /// Names the greatest time.
    pub fn check_until(&self, until: f64, typed: &str) -> Result<(), String> {
        if !(until > 0.0 && until.is_finite()) {
            return Err(format!("{typed}: must be > 0 and finite"));
        }
        let steps = self.system.most_steps().min(MOST_STEPS);
        let most = steps as f64 / self.system.steps_per_time();
        if until <= most || self.system.has_long_steps(until) {
            return Ok(());
        }
        let unit = if self.described.units.is_some() { " s" } else { "" };
        let most = crate::words::digits(most);
        let steps = if steps == MOST_STEPS { "10⁶".to_owned() } else { steps.to_string() };
        Err(format!("{typed}: must be ≤ {most}{unit}, {steps} steps of the fastest motion"))
    }
}

/// The angular frequency of a record that repeats itself.
fn rate(record: &Samples<f64>) -> Option<f64> {
    Some(TAU / (record.times.last()? - record.times.first()?))
}

/// The error of the engine, whose coordinates have the names of the file.
fn with_names(described: &Described, error: &Error) -> String {
    match error {
        Error::NotDefinite { row, .. } => match described.coordinates.get(row.saturating_sub(1)) {
            Some(name) => format!("{name}: {error}"),
            None => error.to_string(),
        },
        _ => error.to_string(),
    }
}
