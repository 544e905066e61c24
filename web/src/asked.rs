//! The inputs of a question: a machine in units, or its ratios.

use serde_json::Value;
use stickslip::inputs::units::{Reader, System};
use stickslip::inputs::{Given, Input, Naming, Point};

/// A question as the page asks it.
pub struct Asked<'a>(pub(crate) &'a Value);

/// The size of B, or 1 for ratios.
pub(crate) fn length(point: &Point<f64>) -> f64 {
    point.machine.map_or(1.0, |machine| machine.scales.length)
}

impl Asked<'_> {
    /// The reader of typed values in the units of the question.
    pub(crate) fn reader(&self) -> Result<Reader, String> {
        let named = self.0.get("units").and_then(Value::as_str).filter(|text| !text.is_empty());
        let system =
            named.map(|text| text.parse::<System>().map_err(|e| format!("units {text}: {e}"))).transpose()?;
        Ok(Reader::new(system.as_ref(), "units, such as kN,m"))
    }

    /// The typed inputs.
    pub(crate) fn given(&self, reader: &Reader) -> Result<Given<f64>, String> {
        let mut given = Given::empty(reader, Naming::Field);
        for (name, text) in self.0.get("inputs").and_then(Value::as_object).into_iter().flatten() {
            let input = Input::named(name).ok_or_else(|| format!("{name}: is unknown"))?;
            let text = text.as_str().unwrap_or_default().trim();
            if !text.is_empty() {
                given.read(input, text, reader)?;
            }
        }
        Ok(given)
    }

    /// A number of the question.
    pub(crate) fn number(&self, name: &str, otherwise: f64) -> f64 {
        self.0.get(name).and_then(Value::as_f64).unwrap_or(otherwise)
    }

    /// A count of the question, of at most `most`.
    pub(crate) fn count(&self, name: &str, otherwise: u64, most: u64) -> u64 {
        self.0.get(name).and_then(Value::as_u64).unwrap_or(otherwise).min(most)
    }

    /// The numbers of a list of the question.
    pub(crate) fn numbers(&self, name: &str) -> Vec<f64> {
        let list = self.0.get(name).and_then(Value::as_array);
        list.into_iter().flatten().filter_map(Value::as_f64).collect()
    }

    /// A text of the question.
    pub(crate) fn text(&self, name: &str) -> Option<&str> {
        self.0.get(name).and_then(Value::as_str).filter(|text| !text.trim().is_empty())
    }
}
