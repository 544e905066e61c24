//! The answers about a system, as JSON has them.

use super::described::Described;
use super::tabled::Digits;
use crate::inputs::units::{Kind as Of, System};
use serde::Serialize;
use stickslip::system::{Border, Cycle, Element, Kind, Motion, State, Steady};

/// Displacements and velocities.
#[derive(Debug, Clone, Serialize)]
struct Place<'a, N> {
    displacement: Vec<&'a N>,
    velocity: Vec<&'a N>,
}

impl<'a, N> Place<'a, N> {
    fn of(described: &'a Described, state: &'a State<N>) -> Self {
        let part = |list: &'a [N]| described.shown(list).collect();
        Self { displacement: part(&state.displacement), velocity: part(&state.velocity) }
    }
}

/// The answers of an element.
#[derive(Debug, Clone, Serialize)]
struct OfElement<'a, N> {
    name: &'a str,
    kind: &'static str,
    time_at_rest: &'a N,
    stops: usize,
    /// Of a stop with a restitution.
    #[serde(skip_serializing_if = "Option::is_none")]
    blows: Option<usize>,
    work: &'a N,
}

#[derive(Debug, Clone, Serialize)]
struct OfEvent<'a, N> {
    time: &'a N,
    /// The place of the element in the file, from 0; the levels follow the elements.
    element: usize,
    name: &'a str,
    kind: &'static str,
    /// The velocities along the stop before and after a blow.
    #[serde(skip_serializing_if = "Option::is_none")]
    velocity_before: Option<&'a N>,
    #[serde(skip_serializing_if = "Option::is_none")]
    velocity_after: Option<&'a N>,
}

/// A motion, or a period of a steady one. The numbers are those of an engine, or texts of their digits.
#[derive(Debug, Clone, Serialize)]
pub struct Answer<'a, N = f64> {
    kind: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    period: Option<&'a N>,
    #[serde(skip_serializing_if = "Option::is_none")]
    duration: Option<&'a N>,
    /// All, or those that are chosen; the lists below have one entry for each.
    coordinates: Vec<&'a String>,
    start: Place<'a, N>,
    #[serde(skip_serializing_if = "Option::is_none")]
    end: Option<Place<'a, N>>,
    max_displacement: Vec<&'a N>,
    min_displacement: Vec<&'a N>,
    max_velocity: Vec<&'a N>,
    min_velocity: Vec<&'a N>,
    /// On a base that moves.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    max_absolute_acceleration: Vec<&'a N>,
    elements: Vec<OfElement<'a, N>>,
    events: Vec<OfEvent<'a, N>>,
    load_work: &'a N,
    damper_work: &'a N,
    stored_energy: &'a N,
    /// The displacement of each coordinate in a period that no force notices, and the mean velocity.
    #[serde(skip_serializing_if = "Option::is_none")]
    drift: Option<Vec<&'a N>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    mean_velocity: Option<Vec<&'a N>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    multipliers: Option<&'a [(f64, f64)]>,
    /// The change of the motion over the last period that was followed, relative to its size, and the factor of this change from period to
    /// period.
    #[serde(skip_serializing_if = "Option::is_none")]
    change: Option<&'a N>,
    #[serde(skip_serializing_if = "Option::is_none")]
    decay: Option<&'a N>,
    #[serde(skip_serializing_if = "Option::is_none")]
    periods: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    periods_followed: Option<usize>,
    /// The greatest factor by which a small disturbance grew on the way to the motion.
    #[serde(skip_serializing_if = "Option::is_none")]
    disturbance_growth: Option<f64>,
    /// Where laws are curves.
    #[serde(skip_serializing_if = "Option::is_none")]
    laws: Option<&'a Digits>,
    #[serde(skip_serializing_if = "Option::is_none")]
    units: Option<Units>,
}

/// The units of an answer by its quantities.
#[derive(Debug, Clone, Serialize)]
pub struct Units {
    time: &'static str,
    displacement: String,
    velocity: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    acceleration: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    force: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    work: Option<String>,
}

impl Units {
    /// The units of states; none for matrices.
    #[must_use]
    pub fn states(described: &Described) -> Option<Self> {
        Self::of(described).map(|(units, system)| Self { force: Some(system.name(Of::Force)), ..units })
    }

    /// The units of displacements, velocities and accelerations, and the system they are of; none for matrices.
    fn of(described: &Described) -> Option<(Self, System)> {
        let system = described.units?;
        let units = Self {
            time: "s",
            displacement: system.name(Of::Length),
            velocity: system.name(Of::Velocity),
            acceleration: described.base.is_some().then(|| system.name(Of::Acceleration)),
            force: None,
            work: None,
        };
        Some((units, system))
    }
}

/// The kind of an element in a word.
pub const fn kind_of<N>(element: &Element<N>) -> &'static str {
    match element.kind {
        Kind::Contact { .. } | Kind::UnderStop { .. } => "contact",
        Kind::Elastic { .. } => "elastic",
        Kind::Stop { .. } | Kind::HardStop { .. } => "stop",
        Kind::Spring { .. } => "spring",
    }
}

/// Whether an element is a contact, rigid or elastic: it may be at rest.
#[must_use]
pub const fn is_contact(element: &Element<f64>) -> bool {
    matches!(element.kind, Kind::Contact { .. } | Kind::UnderStop { .. } | Kind::Elastic { .. })
}

/// Whether an element is a stop with a restitution.
#[must_use]
pub const fn is_hard<N>(element: &Element<N>) -> bool {
    matches!(element.kind, Kind::HardStop { .. })
}

impl<'a, N> Answer<'a, N> {
    /// This answer with what is known of its digits.
    #[must_use]
    pub fn with_digits(self, laws: Option<&'a Digits>) -> Self {
        Self { laws, ..self }
    }

    fn of(described: &'a Described, motion: &'a Motion<N>, start: &'a State<N>, kind: &'a str) -> Self {
        let elements = described.model.elements.iter().zip(&motion.elements);
        let units = Units::of(described)
            .map(|(units, system)| Units { work: Some(system.name(Of::Energy)), ..units });
        let part = |list: &'a [N]| described.shown(list).collect();
        Self {
            kind,
            period: None,
            duration: None,
            coordinates: described.shown(&described.coordinates).collect(),
            start: Place::of(described, start),
            end: None,
            max_displacement: part(&motion.max_displacement),
            min_displacement: part(&motion.min_displacement),
            max_velocity: part(&motion.max_velocity),
            min_velocity: part(&motion.min_velocity),
            max_absolute_acceleration: part(&motion.max_absolute_acceleration),
            elements: elements
                .map(|(element, found)| OfElement {
                    name: &element.name,
                    kind: kind_of(element),
                    time_at_rest: &found.time_at_rest,
                    stops: found.stops,
                    blows: is_hard(element).then_some(found.blows),
                    work: &found.work,
                })
                .collect(),
            events: motion
                .events
                .iter()
                .map(|event| OfEvent {
                    time: &event.time,
                    element: event.element,
                    name: described.name_of(event.element),
                    kind: event.kind.name(),
                    velocity_before: event.velocities.as_ref().map(|pair| &pair.0),
                    velocity_after: event.velocities.as_ref().map(|pair| &pair.1),
                })
                .collect(),
            load_work: &motion.load_work,
            damper_work: &motion.damper_work,
            stored_energy: &motion.stored,
            drift: None,
            mean_velocity: None,
            multipliers: None,
            change: None,
            decay: None,
            periods: None,
            periods_followed: None,
            disturbance_growth: None,
            laws: None,
            units,
        }
    }

    /// The motion from a start to its end.
    pub fn from_start(described: &'a Described, start: &'a State<N>, motion: &'a Motion<N>) -> Self {
        Self {
            duration: Some(&motion.duration),
            end: Some(Place::of(described, &motion.end)),
            ..Self::of(described, motion, start, "transient")
        }
    }

    /// A period of a steady motion.
    pub fn steady(described: &'a Described, found: &'a Steady<N>) -> Self {
        Self {
            period: Some(&found.period),
            periods: Some(found.periods),
            periods_followed: Some(found.followed),
            disturbance_growth: Some(found.disturbance_growth),
            drift: Some(described.shown(&found.drift).collect()),
            mean_velocity: Some(described.shown(&found.mean_velocity).collect()),
            multipliers: Some(&found.multipliers),
            change: Some(&found.change),
            decay: Some(&found.decay),
            ..Self::of(described, &found.motion, &found.start, found.kind.name())
        }
    }
}

impl<'a> Answer<'a> {
    /// The motion from the start of the file to its end.
    #[must_use]
    pub fn transient(described: &'a Described, motion: &'a Motion<f64>) -> Self {
        Self::from_start(described, &described.start, motion)
    }
}

/// States at times.
#[derive(Debug, Serialize)]
pub struct Samples<'a, N = f64> {
    /// All, or those that are chosen.
    coordinates: Vec<&'a String>,
    elements: Vec<&'a str>,
    time: &'a [N],
    /// At each time, of each coordinate.
    pub displacement: Vec<Vec<&'a N>>,
    /// At each time, of each coordinate.
    pub velocity: Vec<Vec<&'a N>>,
    /// At each time, of each element on the bodies.
    pub force: Vec<&'a [N]>,
    /// At each time, of each coordinate, on a base that moves.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub absolute_acceleration: Vec<Vec<&'a N>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    units: Option<Units>,
}

impl<'a, N> Samples<'a, N> {
    /// The states at these times.
    #[must_use]
    pub fn new(described: &'a Described, time: &'a [N], states: &'a [State<N>]) -> Self {
        let part = |list: fn(&State<N>) -> &[N]| -> Vec<Vec<&'a N>> {
            states.iter().map(|state| described.shown(list(state)).collect()).collect()
        };
        Self {
            coordinates: described.shown(&described.coordinates).collect(),
            elements: described.model.elements.iter().map(|element| element.name.as_str()).collect(),
            time,
            displacement: part(|state| &state.displacement),
            velocity: part(|state| &state.velocity),
            force: states.iter().map(|state| &*state.force).collect(),
            absolute_acceleration: if described.base.is_some() {
                part(|state| &state.absolute_acceleration)
            } else {
                Vec::new()
            },
            units: Units::states(described),
        }
    }

    /// The names of the columns of its rows, with their units.
    #[must_use]
    pub fn names(&self) -> Vec<String> {
        let bracketed = |unit: Option<&str>| unit.map_or_else(String::new, |unit| format!("[{unit}]"));
        let unit = |of: fn(&Units) -> Option<&str>| bracketed(self.units.as_ref().and_then(of));
        let names = |what: &str, unit: String| -> Vec<String> {
            self.coordinates.iter().map(|name| format!("{name}.{what}{unit}")).collect()
        };
        let mut header = vec![format!("time{}", unit(|units| Some(units.time)))];
        header.extend(names("displacement", unit(|units| Some(&units.displacement))));
        header.extend(names("velocity", unit(|units| Some(&units.velocity))));
        let force = unit(|units| units.force.as_deref());
        header.extend(self.elements.iter().map(|name| format!("{name}.force{force}")));
        if !self.absolute_acceleration.is_empty() {
            header.extend(names("absolute_acceleration", unit(|units| units.acceleration.as_deref())));
        }
        header
    }

    /// A row for each time: the displacements, the velocities, the force of each element on the bodies, and the absolute
    /// accelerations on a base that moves.
    pub fn rows(&self) -> impl Iterator<Item = Vec<N>> + '_
    where
        N: Clone,
    {
        let states = self.displacement.iter().zip(&self.velocity).zip(&self.force);
        self.time.iter().zip(states).enumerate().map(|(i, (time, ((displacement, velocity), force)))| {
            let absolute = self.absolute_acceleration.get(i).map_or(&[][..], Vec::as_slice);
            let states = displacement.iter().chain(velocity).copied();
            let all = std::iter::once(time).chain(states).chain(force.iter()).chain(absolute.iter().copied());
            all.cloned().collect()
        })
    }
}

/// The least load without sticking, and the cycle of two reversals at the load of the file.
#[derive(Debug, Serialize)]
pub struct OfBorder<'a, N = f64> {
    least_load_factor: &'a N,
    touching_time: &'a N,
    /// With a static friction above the kinetic one.
    #[serde(skip_serializing_if = "Option::is_none")]
    least_load_factor_from_rest: Option<&'a N>,
    cycle: Option<OfCycle<'a, N>>,
}

#[derive(Debug, Serialize)]
struct OfCycle<'a, N> {
    max_displacement: &'a N,
    displacement_time: &'a N,
    max_velocity: &'a N,
    velocity_time: &'a N,
    work: &'a N,
}

impl<'a, N> OfBorder<'a, N> {
    /// The border, and the cycle where there is one.
    #[must_use]
    pub fn new(found: &'a Border<N>, cycle: Option<&'a Cycle<N>>) -> Self {
        Self {
            least_load_factor: &found.least_load_factor,
            touching_time: &found.touching_time,
            least_load_factor_from_rest: found.least_load_factor_from_rest.as_ref(),
            cycle: cycle.map(|cycle| OfCycle {
                max_displacement: &cycle.max_displacement,
                displacement_time: &cycle.displacement_time,
                max_velocity: &cycle.max_velocity,
                velocity_time: &cycle.velocity_time,
                work: &cycle.work,
            }),
        }
    }
}
