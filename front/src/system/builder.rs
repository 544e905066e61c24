//! What is known of a file of named bodies while it is read.

use super::laws::Law;
use crate::text::Folder;
use stickslip::system::{Base, Model, State};

/// The bodies, and the system as far as it is read.
pub(super) struct Builder<'p, F> {
    pub(super) names: Vec<String>,
    /// The names of springs and forces so far.
    pub(super) taken: Vec<String>,
    pub(super) model: Model<F>,
    pub(super) folder: &'p Folder<'p>,
    pub(super) base: Option<Base<F>>,
    pub(super) start: State<F>,
    /// The laws that are curves.
    pub(super) laws: Vec<Law>,
}
