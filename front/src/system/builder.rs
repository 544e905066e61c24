//! What is known of a file of named bodies while it is read.

use super::laws::Law;
use std::path::Path;
use stickslip::system::{Base, Model, State};

/// The bodies, and the system as far as it is read.
pub(super) struct Builder<'p> {
    pub(super) names: Vec<String>,
    /// The names of springs and forces so far.
    pub(super) taken: Vec<String>,
    pub(super) model: Model<f64>,
    pub(super) folder: &'p Path,
    pub(super) base: Option<Base<f64>>,
    pub(super) start: State<f64>,
    /// The laws that are curves.
    pub(super) laws: Vec<Law>,
}
