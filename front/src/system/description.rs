//! A system as it is, before it is asked for a motion.

use super::answer::kind_of;
use super::built::NamedSystem;
use serde::Serialize;
use stickslip::system::{Element, Kind, Model, System};

/// The system in words and numbers.
#[derive(Debug, Clone, Serialize)]
pub struct Description<'a> {
    /// The names of the coordinates, or of those that are chosen.
    pub coordinates: Vec<&'a String>,
    /// The elements.
    pub elements: Vec<OfElement<'a>>,
    /// In rad/s, or in radians per unit of time for matrices, with all contacts sliding, those on a side that travels in one
    /// direction. A direction of negative stiffness has the negative of its rate of growth.
    pub natural_frequencies: Vec<f64>,
    /// The natural frequencies with all contacts at rest.
    pub natural_frequencies_stuck: Vec<f64>,
    /// The number of motions without a restoring force.
    pub rigid_modes: usize,
    /// The stability of steady sliding, where a contact slides on a side that travels.
    pub sliding: Option<OfSliding>,
    /// The contacts whose friction changes with the displacement and slide both ways: it has no part in the frequencies.
    pub sliding_both_ways: Vec<&'a str>,
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
    /// contact, elastic, stop or spring.
    pub kind: &'static str,
    /// With this element alone at rest.
    pub natural_frequencies_stuck: Vec<f64>,
}

/// The stability of steady sliding.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct OfSliding {
    /// The greatest rate of growth of a disturbance in a unit of time, and its angular frequency.
    pub growth: f64,
    /// 0 where it does not oscillate.
    pub frequency: f64,
    /// The friction from which on sliding is unstable.
    pub threshold: Option<OfThreshold>,
    /// Whether a contact that slides so has a friction that changes with the displacement.
    #[serde(skip)]
    pub is_coupled: bool,
}

/// The friction from which on sliding is unstable.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct OfThreshold {
    /// flutter or divergence.
    pub kind: &'static str,
    /// The factor of the coefficients of all contacts whose friction changes with the displacement.
    pub factor: f64,
    /// The coefficient of friction, where these have the same.
    pub coefficient: Option<f64>,
    /// The angular frequency of flutter.
    pub frequency: f64,
}

impl OfSliding {
    /// The stability of a system that slides.
    fn new(model: &Model<f64>, system: &System<f64>) -> Option<Self> {
        let found = system.sliding()?;
        let mut coefficients =
            model.elements.iter().filter(|element| element.moves.constant != 0.0).filter_map(coupled);
        let first = coefficients.next();
        let shared = first.filter(|first| coefficients.all(|other| other == *first));
        let threshold = found.threshold.map(|threshold| OfThreshold {
            kind: if threshold.frequency > 0.0 { "flutter" } else { "divergence" },
            factor: threshold.factor,
            coefficient: shared.map(|one| one * threshold.factor),
            frequency: threshold.frequency,
        });
        let (growth, frequency) = (found.growth, found.frequency);
        Some(Self { growth, frequency, threshold, is_coupled: first.is_some() })
    }
}

/// The coefficient of a contact whose normal load changes with the displacement.
fn coupled(element: &Element<f64>) -> Option<f64> {
    let Kind::Contact { law, normal: Some(normal), .. } = &element.kind else { return None };
    let coefficient = law.points.first()?.1;
    normal.displacement.iter().any(|by| *by != 0.0).then_some(coefficient)
}

impl<'a> Description<'a> {
    /// This description without the natural frequencies above a bound.
    #[must_use]
    pub fn below(mut self, bound: f64) -> Self {
        let own = [&mut self.natural_frequencies, &mut self.natural_frequencies_stuck];
        let elements = self.elements.iter_mut().map(|element| &mut element.natural_frequencies_stuck);
        own.into_iter().chain(elements).for_each(|list| list.retain(|omega| *omega <= bound));
        self
    }

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
            coordinates: described.shown(&described.coordinates).collect(),
            elements: elements.iter().enumerate().map(element).collect(),
            rigid_modes: natural_frequencies.iter().filter(|omega| **omega == 0.0).count(),
            natural_frequencies,
            natural_frequencies_stuck: system.natural_frequencies(&held),
            sliding: OfSliding::new(&described.model, system),
            sliding_both_ways: elements
                .iter()
                .filter(|element| element.moves.constant == 0.0 && coupled(element).is_some())
                .map(|element| element.name.as_str())
                .collect(),
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
