//! Answers with other numbers in them, such as their digits as text.

use super::border::{Border, Cycle};
use super::events::Event;
use super::model::State;
use super::motion::{ElementMotion, Motion};
use super::steady::Steady;
use alloc::vec::Vec;

fn list<F, G>(numbers: &[F], of: &impl Fn(&F) -> G) -> Vec<G> {
    numbers.iter().map(of).collect()
}

impl<F> State<F> {
    /// This state with a function of each number in its place.
    #[doc(hidden)]
    pub fn map<G>(&self, of: &impl Fn(&F) -> G) -> State<G> {
        State {
            displacement: list(&self.displacement, of),
            velocity: list(&self.velocity, of),
            force: list(&self.force, of),
            absolute_acceleration: list(&self.absolute_acceleration, of),
        }
    }
}

impl<F> Motion<F> {
    /// This motion with a function of each number in its place.
    #[doc(hidden)]
    pub fn map<G>(&self, of: &impl Fn(&F) -> G) -> Motion<G> {
        let event = |event: &Event<F>| Event {
            time: of(&event.time),
            element: event.element,
            kind: event.kind,
            velocities: event.velocities.as_ref().map(|(before, after)| (of(before), of(after))),
        };
        let element = |element: &ElementMotion<F>| ElementMotion {
            name: element.name.clone(),
            time_at_rest: of(&element.time_at_rest),
            stops: element.stops,
            blows: element.blows,
            work: of(&element.work),
            reach: element.reach.as_ref().map(of),
        };
        Motion {
            duration: of(&self.duration),
            end: self.end.map(of),
            max_displacement: list(&self.max_displacement, of),
            min_displacement: list(&self.min_displacement, of),
            max_velocity: list(&self.max_velocity, of),
            min_velocity: list(&self.min_velocity, of),
            max_absolute_acceleration: list(&self.max_absolute_acceleration, of),
            events: self.events.iter().map(event).collect(),
            elements: self.elements.iter().map(element).collect(),
            load_work: of(&self.load_work),
            damper_work: of(&self.damper_work),
            stored: of(&self.stored),
        }
    }
}

impl<F> Steady<F> {
    /// This motion with a function of each number in its place.
    #[doc(hidden)]
    pub fn map<G>(&self, of: &impl Fn(&F) -> G) -> Steady<G> {
        Steady {
            kind: self.kind,
            period: of(&self.period),
            periods: self.periods,
            start: self.start.map(of),
            motion: self.motion.map(of),
            drift: list(&self.drift, of),
            mean_velocity: list(&self.mean_velocity, of),
            multipliers: self.multipliers.clone(),
            change: of(&self.change),
            decay: of(&self.decay),
            followed: self.followed,
            disturbance_growth: self.disturbance_growth,
        }
    }
}

impl<F> Border<F> {
    /// This border with a function of each number in its place.
    #[doc(hidden)]
    pub fn map<G>(&self, of: &impl Fn(&F) -> G) -> Border<G> {
        Border {
            least_load_factor: of(&self.least_load_factor),
            touching_time: of(&self.touching_time),
            least_load_factor_from_rest: self.least_load_factor_from_rest.as_ref().map(of),
        }
    }
}

impl<F> Cycle<F> {
    /// This cycle with a function of each number in its place.
    #[doc(hidden)]
    pub fn map<G>(&self, of: &impl Fn(&F) -> G) -> Cycle<G> {
        Cycle {
            max_displacement: of(&self.max_displacement),
            displacement_time: of(&self.displacement_time),
            max_velocity: of(&self.max_velocity),
            velocity_time: of(&self.velocity_time),
            work: of(&self.work),
            margin: of(&self.margin),
        }
    }
}
