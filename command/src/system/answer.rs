//! The answers about a system, as JSON and as text.

use super::described::Described;
use crate::bits::digits;
use crate::failure::Outcome;
use crate::note::line;
use serde::Serialize;
use std::io::Write;
use stickslip::inputs::units::Kind as Of;
use stickslip::system::{Border, Cycle, Element, Event, Kind, Motion, State, Steady};

/// Displacements and velocities.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Place<'a> {
    displacement: &'a [f64],
    velocity: &'a [f64],
}

impl<'a> Place<'a> {
    pub(super) fn of(state: &'a State<f64>) -> Self {
        Self { displacement: &state.displacement, velocity: &state.velocity }
    }
}

/// The answers of an element.
#[derive(Debug, Clone, Serialize)]
struct OfElement<'a> {
    name: &'a str,
    kind: &'static str,
    time_at_rest: f64,
    stops: usize,
    work: f64,
}

#[derive(Debug, Clone, Serialize)]
struct OfEvent<'a> {
    time: f64,
    /// The place of the element in the file, from 0.
    element: usize,
    name: &'a str,
    kind: &'static str,
}

/// A motion, or a period of a steady one.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Answer<'a> {
    kind: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    period: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    duration: Option<f64>,
    coordinates: &'a [String],
    start: Place<'a>,
    #[serde(skip_serializing_if = "Option::is_none")]
    end: Option<Place<'a>>,
    max_displacement: &'a [f64],
    min_displacement: &'a [f64],
    max_velocity: &'a [f64],
    min_velocity: &'a [f64],
    elements: Vec<OfElement<'a>>,
    events: Vec<OfEvent<'a>>,
    load_work: f64,
    damper_work: f64,
    stored_energy: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    multipliers: Option<&'a [(f64, f64)]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    periods: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    periods_followed: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    units: Option<Units>,
}

/// The units of the answer.
#[derive(Debug, Clone, Serialize)]
struct Units {
    time: &'static str,
    displacement: String,
    velocity: String,
    work: String,
}

/// The kind of an element in a word.
pub(super) const fn kind_of(element: &Element<f64>) -> &'static str {
    match element.kind {
        Kind::Contact { .. } => "contact",
        Kind::Elastic { .. } => "elastic",
        Kind::Stop { .. } => "stop",
    }
}

impl<'a> Answer<'a> {
    fn of(described: &'a Described, motion: &'a Motion<f64>, start: &'a State<f64>, kind: &'a str) -> Self {
        let elements = described.model.elements.iter().zip(&motion.elements);
        let name = |event: &Event<f64>| {
            described.model.elements.get(event.element).map_or("", |element| element.name.as_str())
        };
        let units = described.units.map(|system| Units {
            time: "s",
            displacement: system.name(Of::Length),
            velocity: system.name(Of::Velocity),
            work: system.name(Of::Energy),
        });
        Self {
            kind,
            period: None,
            duration: None,
            coordinates: &described.coordinates,
            start: Place::of(start),
            end: None,
            max_displacement: &motion.max_displacement,
            min_displacement: &motion.min_displacement,
            max_velocity: &motion.max_velocity,
            min_velocity: &motion.min_velocity,
            elements: elements
                .map(|(element, found)| OfElement {
                    name: &element.name,
                    kind: kind_of(element),
                    time_at_rest: found.time_at_rest,
                    stops: found.stops,
                    work: found.work,
                })
                .collect(),
            events: motion
                .events
                .iter()
                .map(|event| OfEvent {
                    time: event.time,
                    element: event.element,
                    name: name(event),
                    kind: event.kind.name(),
                })
                .collect(),
            load_work: motion.load_work,
            damper_work: motion.damper_work,
            stored_energy: motion.stored,
            multipliers: None,
            periods: None,
            periods_followed: None,
            units,
        }
    }

    /// The motion from a start to its end.
    pub(super) fn transient(described: &'a Described, motion: &'a Motion<f64>) -> Self {
        Self {
            duration: Some(motion.duration),
            end: Some(Place::of(&motion.end)),
            ..Self::of(described, motion, &described.start, "transient")
        }
    }

    /// A period of a steady motion.
    pub(super) fn steady(described: &'a Described, found: &'a Steady<f64>) -> Self {
        Self {
            period: Some(found.period),
            periods: Some(found.periods),
            periods_followed: Some(found.followed),
            multipliers: Some(&found.multipliers),
            ..Self::of(described, &found.motion, &found.start, found.kind.name())
        }
    }
}

/// The most events that a text lists.
const LISTED: usize = 24;

/// A motion as text: its extremes, its elements and its events.
pub(super) fn text(described: &Described, motion: &Motion<f64>, out: &mut impl Write) -> Outcome {
    let unit =
        |kind: Of| described.units.map_or_else(String::new, |system| format!(" {}", system.name(kind)));
    let (length, velocity) = (unit(Of::Length), unit(Of::Velocity));
    for (i, name) in described.coordinates.iter().enumerate() {
        let at = |list: &[f64]| list.get(i).copied().map_or_else(String::new, digits);
        writeln!(out, "{name}")?;
        let range = |least: &[f64], most: &[f64], unit: &str| format!("{} to {}{unit}", at(least), at(most));
        line(out, "displacement", range(&motion.min_displacement, &motion.max_displacement, &length))?;
        line(out, "velocity", range(&motion.min_velocity, &motion.max_velocity, &velocity))?;
    }
    for (element, found) in described.model.elements.iter().zip(&motion.elements) {
        writeln!(out, "{} ({})", element.name, kind_of(element))?;
        let rest = match element.kind {
            Kind::Stop { .. } => "open",
            Kind::Elastic { .. } => "holds",
            _ => "sticks",
        };
        let seconds = if described.units.is_some() { " s" } else { "" };
        line(out, rest, format!("{}{seconds}, {} times", digits(found.time_at_rest), found.stops))?;
        line(out, "work", format!("{}{}", digits(found.work), unit(Of::Energy)))?;
    }
    writeln!(out, "energy")?;
    line(out, "work of the loads", format!("{}{}", digits(motion.load_work), unit(Of::Energy)))?;
    line(out, "work on the dampers", format!("{}{}", digits(motion.damper_work), unit(Of::Energy)))?;
    line(out, "stored", format!("{}{}", digits(motion.stored), unit(Of::Energy)))?;
    if motion.events.is_empty() {
        return Ok(writeln!(out, "no events")?);
    }
    writeln!(out, "events")?;
    for event in motion.events.iter().take(LISTED) {
        let name = described.model.elements.get(event.element).map_or("", |element| element.name.as_str());
        let seconds = if described.units.is_some() { " s" } else { "" };
        writeln!(out, "  {:>14}{seconds}  {name}: {}", digits(event.time), event.kind)?;
    }
    if motion.events.len() > LISTED {
        let more = motion.events.len() - LISTED;
        writeln!(out, "  and {more} more: all of them are in --format json")?;
    }
    Ok(())
}

/// States at times.
#[derive(Debug, Serialize)]
pub(super) struct Samples<'a> {
    coordinates: &'a [String],
    elements: Vec<&'a str>,
    time: &'a [f64],
    displacement: Vec<&'a [f64]>,
    velocity: Vec<&'a [f64]>,
    force: Vec<&'a [f64]>,
    #[serde(skip)]
    units: Option<stickslip::inputs::units::System>,
}

impl<'a> Samples<'a> {
    pub(super) fn new(described: &'a Described, time: &'a [f64], states: &'a [State<f64>]) -> Self {
        Self {
            coordinates: &described.coordinates,
            elements: described.model.elements.iter().map(|element| element.name.as_str()).collect(),
            time,
            displacement: states.iter().map(|state| &*state.displacement).collect(),
            velocity: states.iter().map(|state| &*state.velocity).collect(),
            force: states.iter().map(|state| &*state.force).collect(),
            units: described.units,
        }
    }

    /// A row for each time: the displacements, the velocities, and the force of each element on the bodies.
    pub(super) fn csv(&self, out: &mut impl Write) -> Outcome {
        let unit =
            |kind: Of| self.units.map_or_else(String::new, |system| format!("[{}]", system.name(kind)));
        let names = |what: &str, kind: Of| -> Vec<String> {
            self.coordinates.iter().map(|name| format!("{name}.{what}{}", unit(kind))).collect()
        };
        let mut writer = csv::Writer::from_writer(out);
        let mut header = vec![if self.units.is_some() { "time[s]".to_owned() } else { "time".to_owned() }];
        header.extend(names("displacement", Of::Length));
        header.extend(names("velocity", Of::Velocity));
        header.extend(self.elements.iter().map(|name| format!("{name}.force{}", unit(Of::Force))));
        writer.write_record(&header)?;
        let states = self.displacement.iter().zip(&self.velocity).zip(&self.force);
        for (time, ((displacement, velocity), force)) in self.time.iter().zip(states) {
            let numbers = [*time].into_iter().chain([*displacement, *velocity, *force].concat());
            writer.write_record(numbers.map(|x| x.to_string()))?;
        }
        Ok(writer.flush()?)
    }
}

/// The least load without sticking, and the cycle of two reversals at the load of the file.
#[derive(Debug, Serialize)]
pub(super) struct OfBorder<'a> {
    least_load_factor: f64,
    touching_time: f64,
    cycle: Option<OfCycle<'a>>,
}

#[derive(Debug, Serialize)]
struct OfCycle<'a> {
    max_displacement: &'a f64,
    displacement_time: &'a f64,
    max_velocity: &'a f64,
    velocity_time: &'a f64,
    work: &'a f64,
}

impl<'a> OfBorder<'a> {
    pub(super) fn new(found: &Border<f64>, cycle: Option<&'a Cycle<f64>>) -> Self {
        Self {
            least_load_factor: found.least_load_factor,
            touching_time: found.touching_time,
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
