//! The file of a system as a program makes and writes it.

use super::built::NamedSystem;
use crate::inputs::units::System as Units;
use serde_json::{Map, Value, json};
use std::fmt;
use std::path::Path;

/// The file of a system: bodies by name, and what is between them, in the words of its fields. Each step returns the file; nothing is
/// checked before it is read, by the reader of every file.
///
/// ```
/// use std::path::Path;
/// use serde_json::json;
/// use stickslip_front::system::{File, parsed};
/// let file = File::new("N,mm")
///     .mass("block", "1 t")
///     .spring("ground", "block", "200 N/mm")
///     .contact("ground", "block", "450 N")
///     .with("forces", json!({ "on": "block", "amplitude": "1.5 kN", "frequency": "3 Hz" }));
/// let system = file.read(Path::new(""))?;
/// assert_eq!(system.described.coordinates, ["block"]);
/// // Its text is what the command reads.
/// assert_eq!(parsed(&file.to_string(), "written")?, *file.value());
/// # Ok::<(), String>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct File(Value);

impl File {
    /// A file without bodies, in a system of units such as `N,mm`.
    #[must_use]
    pub fn new(units: &str) -> Self {
        Self(json!({ "units": units }))
    }

    /// This file with a body: its mass, or a table with its mass, its start or its prescribed motion.
    #[must_use]
    pub fn mass(mut self, name: &str, mass: impl Into<Value>) -> Self {
        if let Some(Value::Object(bodies)) = self.field("masses", || Value::Object(Map::new())) {
            bodies.insert(name.to_owned(), mass.into());
        }
        self
    }

    /// This file with a spring between two bodies, or `ground` and a body.
    #[must_use]
    pub fn spring(self, first: &str, second: &str, stiffness: impl Into<Value>) -> Self {
        self.with("springs", json!({ "between": [first, second], "stiffness": stiffness.into() }))
    }

    /// This file with a contact of one friction force between two bodies, or `ground` and a body.
    #[must_use]
    pub fn contact(self, first: &str, second: &str, friction: impl Into<Value>) -> Self {
        self.with("contacts", json!({ "between": [first, second], "friction": friction.into() }))
    }

    /// This file with a further entry of a list: `springs`, `contacts`, `stops`, `forces` or `levels`, with the fields that the pages on systems
    /// describe.
    #[must_use]
    pub fn with(mut self, list: &str, entry: Value) -> Self {
        if let Some(Value::Array(entries)) = self.field(list, || Value::Array(Vec::new())) {
            entries.push(entry);
        }
        self
    }

    /// This file with another value of a field that is no list, such as `base`.
    #[must_use]
    pub fn with_field(mut self, name: &str, value: Value) -> Self {
        if let Value::Object(fields) = &mut self.0 {
            fields.insert(name.to_owned(), value);
        }
        self
    }

    /// A field, which is made where there is none.
    fn field(&mut self, name: &str, empty: fn() -> Value) -> Option<&mut Value> {
        let Value::Object(fields) = &mut self.0 else { return None };
        Some(fields.entry(name).or_insert_with(empty))
    }

    /// The value of the file.
    #[must_use]
    pub const fn value(&self) -> &Value {
        &self.0
    }

    /// The system that the file describes; files that it names are in the folder.
    ///
    /// # Errors
    /// As [`NamedSystem::new`].
    pub fn read(&self, folder: &Path) -> Result<NamedSystem, String> {
        NamedSystem::new(&self.0, [], folder, None::<&Units>)
    }
}

/// The text of the file, in JSON.
impl fmt::Display for File {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:#}", self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::File;
    use crate::system::parsed;
    use serde_json::json;
    use std::path::Path;

    #[test]
    fn what_is_written_is_read() {
        let file = File::new("N,mm")
            .mass("block", "1 t")
            .mass("roof", json!({ "mass": 0.5, "start": "3 mm" }))
            .spring("ground", "block", 200)
            .spring("block", "roof", "300 N/mm")
            .contact("ground", "block", 450.0)
            .with("stops", json!({ "between": ["ground", "block"], "gap": "20 mm", "stiffness": 1000 }))
            .with_field("base", json!({ "acceleration": { "amplitude": "0.1 g", "frequency": "2 Hz" } }));
        let value = parsed(&file.to_string(), "written").unwrap();
        assert_eq!(value, *file.value());
        let read = file.read(Path::new("")).unwrap().described;
        assert_eq!(
            (read.coordinates, read.model.elements.len()),
            (vec!["block".to_owned(), "roof".to_owned()], 2)
        );
        assert_eq!(read.start.displacement, [0.0, 3.0]);
        let wrong = File::new("N,mm").mass("block", "1 t").spring("ground", "rof", 1).read(Path::new(""));
        assert!(wrong.unwrap_err().contains("rof"));
    }
}
