//! The rows of an answer of design.

use crate::bits::Value;
use crate::physical::Units;
use crate::row::{Cell, Number};
use serde::ser::{Serialize, SerializeMap, Serializer};
use stickslip_front::inputs::units::{Kind, System};

/// A row of an answer: name, kind and value of each number.
pub(crate) type AnswerRow<F> = Vec<(&'static str, Kind, Cell<F>)>;

/// The row as it is written.
pub(crate) fn shown<F: Value>(row: &AnswerRow<F>) -> AnswerRow<Number> {
    row.iter().map(|(name, kind, cell)| (*name, *kind, cell.shown())).collect()
}

/// An answer: a sentence and its numbers.
pub(super) struct DesignAnswer<F> {
    pub(super) sentence: String,
    pub(super) rows: Vec<AnswerRow<F>>,
}

/// A row as JSON; in physical units it includes the kind of base motion and the unit of each value.
pub(crate) struct NamedRow {
    pub(crate) row: AnswerRow<Number>,
    pub(crate) system: Option<System>,
    pub(crate) base_motion: Option<&'static str>,
}

impl Serialize for NamedRow {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for (name, _, cell) in &self.row {
            map.serialize_entry(name, cell)?;
        }
        if let Some(base) = self.base_motion {
            map.serialize_entry("base_motion", base)?;
        }
        if let Some(system) = self.system {
            let numbers =
                self.row.iter().filter(|(_, _, cell)| matches!(cell, Cell::Number(_) | Cell::Intervals(_)));
            let kinds = numbers.map(|(name, kind, _)| (*name, *kind)).collect();
            map.serialize_entry("units", &Units(system, kinds))?;
        }
        map.end()
    }
}
