//! A system as it is, before it is asked for a motion.

use super::answer::kind_of;
use super::built::NamedSystem;
use serde::Serialize;
use stickslip::system::{Element, Model, System};

/// The system in words and numbers.
#[derive(Debug, Clone, Serialize)]
pub struct Description<'a> {
    /// The names of the coordinates.
    pub coordinates: &'a [String],
    /// The elements.
    pub elements: Vec<OfElement<'a>>,
    /// In rad/s, or in radians per unit of time for matrices, with all contacts sliding. A direction of negative stiffness has
    /// the negative of its rate of growth.
    pub natural_frequencies: Vec<f64>,
    /// The natural frequencies with all contacts at rest.
    pub natural_frequencies_stuck: Vec<f64>,
    /// The number of motions without a restoring force.
    pub rigid_modes: usize,
    /// Whether the dampers feed some motion instead of damping it.
    pub negative_damping: bool,
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
            negative_damping: is_fed(&described.model),
            harmonics: described.model.harmonics.iter().map(|h| h.frequency).collect(),
            records: described.model.records.len(),
        }
    }
}

/// Whether `v·C v` is negative for some velocity: by the roots of the symmetric part of C in place of the stiffness.
fn is_fed(model: &Model<f64>) -> bool {
    let at = |i: usize, j: usize| model.damping.get(i).and_then(|row| row.get(j)).copied().unwrap_or(0.0);
    let n = model.mass.len();
    let part = |i: usize| (0..n).map(|j| f64::midpoint(at(i, j), at(j, i))).collect();
    let like = Model {
        mass: model.mass.clone(),
        damping: vec![vec![0.0; n]; n],
        stiffness: (0..n).map(part).collect(),
        ..Model::default()
    };
    System::new(&like).is_ok_and(|system| system.natural_frequencies(&[]).iter().any(|root| *root < 0.0))
}
