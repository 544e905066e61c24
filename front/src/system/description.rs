//! A system as it is, before it is asked for a motion.

use super::answer::kind_of;
use super::built::NamedSystem;
use serde::Serialize;
use stickslip::system::Element;

/// The system in words and numbers.
#[derive(Debug, Clone, Serialize)]
pub struct Description<'a> {
    /// The names of the coordinates.
    pub coordinates: &'a [String],
    /// The elements.
    pub elements: Vec<OfElement<'a>>,
    /// In rad/s, or in radians per unit of time for matrices, with all contacts sliding.
    pub natural_frequencies: Vec<f64>,
    /// The natural frequencies with all contacts at rest.
    pub natural_frequencies_stuck: Vec<f64>,
    /// The number of motions without a restoring force.
    pub rigid_modes: usize,
    /// The frequencies of the harmonic loads.
    pub harmonics: Vec<f64>,
    /// The number of records.
    pub records: usize,
}

/// An element of a system.
#[derive(Debug, Clone, Serialize)]
pub struct OfElement<'a> {
    /// Its name.
    pub name: &'a str,
    /// contact, elastic or stop.
    pub kind: &'static str,
    /// With this element alone at rest.
    pub natural_frequencies_stuck: Vec<f64>,
}

impl<'a> Description<'a> {
    /// The description of a system.
    #[must_use]
    pub fn new(of: &'a NamedSystem) -> Self {
        let (described, system) = (&of.described, &of.system);
        let elements = &described.model.elements;
        let held: Vec<usize> = (0..elements.len()).collect();
        let natural_frequencies = system.natural_frequencies(&[]);
        let element = |(i, element): (usize, &'a Element<f64>)| OfElement {
            name: &element.name,
            kind: kind_of(element),
            natural_frequencies_stuck: system.natural_frequencies(&[i]),
        };
        Self {
            coordinates: &described.coordinates,
            elements: elements.iter().enumerate().map(element).collect(),
            rigid_modes: natural_frequencies.iter().filter(|omega| **omega == 0.0).count(),
            natural_frequencies,
            natural_frequencies_stuck: system.natural_frequencies(&held),
            harmonics: described.model.harmonics.iter().map(|h| h.frequency).collect(),
            records: described.model.records.len(),
        }
    }
}
