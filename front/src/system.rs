//! A system of several bodies from a file or a value: bodies by name with springs, contacts, stops and loads, or matrices;
//! and its answers, as every front prints them.
//!
//! A mistake is one line of text with the place in the file, the value and the inequality it breaks.

mod answer;
mod builder;
mod built;
mod curve;
mod decimal;
mod described;
mod description;
mod digits;
mod file;
mod formula;
mod grid;
mod interval;
mod laws;
mod named;
mod node;
mod one_body;
mod proved;
mod sentence;
mod shown;
mod signals;
mod smooth;
mod spring;
mod stored;
mod tabled;
mod typed;
mod unique;
mod why;
#[cfg(feature = "mp")]
mod wide;
mod written;

pub use answer::{Answer, OfBorder, Samples, Units, is_contact, is_hard, kind_of};
pub use built::NamedSystem;
pub use described::Described;
pub use description::{Description, OfElement, OfSliding, OfThreshold};
pub use file::{LONGEST, MOST_VALUES, decoded, parsed, units_of};
pub use grid::{Asked, Axis, Cell, Grid, MOST_ROWS};
pub use node::Number;
pub use one_body::{OneBody, Repeated};
pub use proved::{Proved, ProvedSteady};
pub use sentence::{
    border_verdict, digits_sentence, frequency_of, plural, sliding_verdict, steady_verdict, with_unit,
};
pub use shown::MOST_LISTED;
pub use tabled::{Digits, OfTable};
pub use typed::parsed_as_typed;
pub use why::Why;
#[cfg(feature = "mp")]
pub use wide::{WideSystem, steady_of_body};
pub use written::File;
