//! What is known of a table before it is read.

use super::super::Unit;

/// What another layout knows of its columns.
pub(in crate::record) struct Known {
    pub(in crate::record) kind: &'static str,
    pub(in crate::record) names: Vec<String>,
    pub(in crate::record) unit: Option<Unit>,
}

impl Default for Known {
    fn default() -> Self {
        Self { kind: "columns", names: Vec::new(), unit: None }
    }
}
