//! The answer in the machine's units: the physical names of the values, and their units.

use crate::bits::Value;
use crate::outputs::{Key, plain};
use crate::row::{Cell, Number};
use serde::ser::{Serialize, SerializeMap, Serializer};
use stickslip::{Excitation, Measure};
use stickslip_front::inputs::units::{Kind, System};
use stickslip_front::inputs::{Driven, Given};
use stickslip_front::quantities;

/// Values with their units.
#[derive(Debug, Clone)]
pub(crate) struct Physical<F> {
    system: System,
    /// The kind of excitation.
    drive: Option<&'static str>,
    /// Whether the values also stand beside those in ratios in JSON, without their units.
    is_beside: bool,
    /// The unit of frequencies in the names of columns, where it is not that of the system.
    frequency: Option<&'static str>,
    pub(crate) values: Vec<(&'static str, Kind, Cell<F>)>,
}

impl<F> Default for Physical<F> {
    fn default() -> Self {
        Self::of(System::default())
    }
}

impl<F> Physical<F> {
    /// A system of units without values.
    pub(crate) const fn of(system: System) -> Self {
        Self { system, drive: None, is_beside: false, frequency: None, values: Vec::new() }
    }

    /// Values that stand beside those in ratios.
    pub(crate) const fn beside(system: System, values: Vec<(&'static str, Kind, Cell<F>)>) -> Self {
        Self { system, drive: None, is_beside: true, frequency: None, values }
    }

    /// The same with frequencies in this unit.
    pub(crate) const fn with_frequencies_in(mut self, unit: Option<&'static str>) -> Self {
        self.frequency = unit;
        self
    }

    /// The unit of a value.
    fn unit(&self, kind: Kind) -> String {
        match (kind, self.frequency) {
            (Kind::Frequency, Some(unit)) => unit.to_owned(),
            _ => self.system.name(kind),
        }
    }

    /// The values that stand beside those in ratios, in JSON and in a table.
    pub(crate) fn values_beside(&self) -> &[(&'static str, Kind, Cell<F>)] {
        if self.is_beside { &self.values } else { &[] }
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.values.is_empty()
    }
}

impl<F: Value> Physical<F> {
    /// The values as they are written.
    pub(crate) fn shown(self) -> Physical<Number> {
        let Self { system, drive, is_beside, frequency, values } = self;
        let values = values.into_iter().map(|(name, kind, cell)| (name, kind, cell.shown())).collect();
        Physical { system, drive, is_beside, frequency, values }
    }

    /// The machine and its drive: the given quantities and those that follow from them.
    pub(crate) fn of_machine(given: &Given<F>, machine: &Driven<F>) -> Self {
        let quantities = quantities::of_machine(given, machine).into_iter();
        let values = quantities.map(|(own, value)| (own.name, own.kind, Cell::Number(Some(value)))).collect();
        Self { drive: Some(machine.drive.excitation().name()), values, ..Self::of(given.system) }
    }

    /// The frequency of a border.
    pub(crate) fn of_border(given: &Given<F>, machine: &Driven<F>) -> Self {
        let frequency = Cell::Number(Some(machine.drive.angular_frequency()));
        Self { values: vec![("angular_frequency", Kind::Frequency, frequency)], ..Self::of(given.system) }
    }

    /// Adds each number of `fields` that has a name under this excitation, with the size of its unit.
    pub(crate) fn with(
        mut self,
        fields: &[(Key, Cell<F>)],
        excitation: Excitation,
        size: impl Fn(Measure) -> F,
    ) -> Self {
        for (key, cell) in fields {
            let Some(name) = key.physical_name(excitation) else { continue };
            let unit = size(key.measure);
            let scaled = match cell {
                Cell::Number(value) => Cell::Number(value.map(|v| v * unit)),
                Cell::Intervals(intervals) => {
                    let scaled = |(low, high): (F, Option<F>)| (low * unit, high.map(|x| x * unit));
                    Cell::Intervals(intervals.map(|interval| interval.map(scaled)))
                }
                Cell::Text(_) | Cell::Count(_) | Cell::Flag(_) | Cell::Pairs(_) => continue,
            };
            self.values.push((name, key.measure.kind(), scaled));
        }
        self
    }
}

impl Physical<Number> {
    pub(crate) fn has(&self, wanted: &str) -> bool {
        self.values.iter().any(|(name, kind, _)| self.is_called(name, *kind, wanted))
    }

    /// The names of the physical values, without values.
    pub(crate) fn blank(&self) -> Self {
        let values = self.values.iter().map(|(name, kind, cell)| (*name, *kind, cell.blank())).collect();
        Self { values, ..*self }
    }

    /// Whether `wanted` refers to the value with this name, with its unit in brackets or without.
    fn is_called(&self, name: &str, kind: Kind, wanted: &str) -> bool {
        match wanted.split_once('[') {
            Some((own, unit)) => {
                let due = self.unit(kind);
                own == name && unit.strip_suffix(']').is_some_and(|unit| unit == due || unit == plain(&due))
            }
            None => wanted == name,
        }
    }

    /// Only the values with these names, in this order.
    pub(crate) fn only<'a>(self, wanted: impl Iterator<Item = &'a str>) -> Self {
        let found = |wanted: &str| {
            self.values.iter().find(|(name, kind, _)| self.is_called(name, *kind, wanted)).cloned()
        };
        let values = wanted.filter_map(found).collect();
        Self { values, ..self }
    }

    /// Each name with its unit in brackets, as for a column of a table.
    pub(crate) fn names(&self) -> impl Iterator<Item = String> + '_ {
        self.values.iter().flat_map(|(name, kind, cell)| {
            let unit = plain(&self.unit(*kind));
            cell.part_names(name).into_iter().map(move |name| format!("{name}[{unit}]"))
        })
    }
}

impl Serialize for Physical<Number> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        if let Some(drive) = self.drive {
            map.serialize_entry("drive", drive)?;
        }
        for (name, _, cell) in &self.values {
            map.serialize_entry(name, cell)?;
        }
        let kinds = self.values.iter().map(|(name, kind, _)| (*name, *kind)).collect();
        map.serialize_entry("units", &Units(self.system, kinds))?;
        map.end()
    }
}

/// The unit of each value, under the name of the value.
pub(crate) struct Units(pub(crate) System, pub(crate) Vec<(&'static str, Kind)>);

impl Serialize for Units {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self(system, values) = self;
        serializer.collect_map(values.iter().map(|(name, kind)| (name, system.name(*kind))))
    }
}
