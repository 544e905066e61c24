//! What the command, the Python package and the page in the browser share.
//!
//! | module | content |
//! |---|---|
//! | [`record`] | the file of a record, of an agency or of columns, as a [`Record`](stickslip::motion::record::Record) |
//! | [`curve`] | a response curve, resolved at its peaks and where the body begins to slide |
//! | [`inputs`] | the inputs of a machine with their rules, and numbers with units |
//! | [`quantities`] | the quantities of a machine under its drive, with their kinds and meanings |
//! | [`words`] | answers in sentences |
//! | [`limits`] | how far searches go |
//! | [`grid`] | `FROM:TO:COUNT` and `FROM:TO:COUNT:log` in place of one value |
//! | [`names`] | the names of columns with their units |
//! | [`text`] | what a terminal or a drawing must not receive, and files that are no text |
//! | `system` (a feature) | the file of several bodies, and the answers about them |

#![cfg_attr(
    not(test),
    deny(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::indexing_slicing,
        clippy::arithmetic_side_effects,
        clippy::unreachable
    )
)]

pub mod curve;
pub mod grid;
pub mod inputs;
pub mod limits;
pub mod names;
pub mod quantities;
pub mod record;
#[cfg(feature = "system")]
pub mod system;
pub mod text;
pub mod without;
pub mod words;
