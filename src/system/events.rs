//! The events of a motion, and what watches them and the stretches between.

use super::assembly::Assembly;
use super::blow::{Blow, Reset};
use super::branch::Branch;
use super::mode::Mode;
use super::propagator::Propagator;
use super::split::Leap;
use crate::float::Float;
use crate::named::named;
use alloc::vec::Vec;

named! {
    /// The kind of an event.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "lowercase"))]
    pub enum EventKind [name] {
        /// A contact comes to rest.
        Stick = "stick",
        /// A contact begins to slide.
        Slip = "slip",
        /// A contact turns without a rest.
        Reverse = "reverse",
        /// The velocity of a contact, or the force of a stop, touches zero and goes on.
        Touch = "touch",
        /// The slider of an elastic contact begins to slide.
        Yield = "yield",
        /// The slider of an elastic contact stops.
        Lock = "lock",
        /// A stop, or a contact's normal load, ends.
        Open = "open",
        /// A stop, or a contact's normal load, begins.
        Close = "close",
        /// A body hits a stop that gives no way.
        Blow = "blow",
        /// The quantity of a level passes its value upwards.
        Rise = "rise",
        /// The quantity of a level passes its value downwards.
        Fall = "fall",
    }
}

/// The kind of the event that leads from one mode to another.
pub(crate) fn kind_of(old: Mode, new: Mode, touched: bool) -> Option<EventKind> {
    match (old, new) {
        (Mode::Stuck, Mode::Slides { .. }) => Some(EventKind::Slip),
        (Mode::Slides { .. }, Mode::Stuck) => Some(EventKind::Stick),
        (Mode::Slides { forward: a, .. }, Mode::Slides { forward: b, .. }) if a != b => {
            Some(EventKind::Reverse)
        }
        (Mode::Slides { .. }, Mode::Slides { .. }) if touched => Some(EventKind::Touch),
        (Mode::Apart, Mode::Stuck | Mode::Slides { .. } | Mode::Holds | Mode::Yields { .. }) => {
            Some(EventKind::Close)
        }
        (Mode::Stuck | Mode::Slides { .. } | Mode::Holds | Mode::Yields { .. }, Mode::Apart) => {
            Some(EventKind::Open)
        }
        (Mode::Holds, Mode::Yields { .. }) => Some(EventKind::Yield),
        (Mode::Yields { .. }, Mode::Holds) => Some(EventKind::Lock),
        (Mode::Away | Mode::Lifted, Mode::Pressed | Mode::Resting) => Some(EventKind::Close),
        (Mode::Pressed | Mode::Resting, Mode::Away | Mode::Lifted) => Some(EventKind::Open),
        _ => None,
    }
}

/// An event.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Event<F> {
    /// Its time.
    pub time: F,
    /// The element's place in the model; the levels follow the elements.
    pub element: usize,
    /// Its kind.
    pub kind: EventKind,
    /// The velocities along the stop before and after a blow; none of other events.
    pub velocities: Option<(F, F)>,
}

/// What watches a motion.
pub(crate) trait Watch<F> {
    /// A part of the motion without an event.
    fn stretch(&mut self, system: &Assembly<F>, stretch: &Stretch<'_, F>);
    /// An event.
    fn event(&mut self, event: Event<F>);
    /// The velocities jump at a stop that gives no way; `to` is the state afterwards.
    fn blow(&mut self, _system: &Assembly<F>, _blow: &Blow<F>, _to: &[F]) {}
    /// The branch changes where the guard's row is zero, and the derivative of the state from `from` to `to`. Without a guard it changes
    /// with a sample, or with the event before it. With a reset the velocities jump, too.
    fn changes(&mut self, _guard: Option<&[F]>, _reset: Option<&Reset<F>>, _from: &[F], _to: &[F]) {}
    /// Whether it has seen enough: the motion then ends.
    fn is_over(&self) -> bool {
        false
    }
    /// Whether it needs the changes.
    fn needs_changes(&self) -> bool {
        false
    }
}

/// A part of the motion in one branch, within one step.
pub(crate) struct Stretch<'a, F> {
    pub(crate) branch: &'a Branch<F>,
    /// The state at its start.
    pub(crate) from: &'a [F],
    /// The state at its end.
    pub(crate) to: &'a [F],
    pub(crate) time: F,
    /// The instant at its start.
    pub(crate) at: F,
    /// e^{At} over its time, where it is known.
    pub(crate) motion: Option<&'a Propagator<F>>,
    /// The Taylor terms of the state over its time, where they are known.
    pub(crate) terms: Option<&'a [F]>,
    /// Whether it is a whole step of the branch, which goes on.
    pub(crate) is_whole: bool,
    /// Set where it is a long step, without the fast modes of the branch.
    pub(crate) leap: Option<Leap<'a, F>>,
}

impl<F: Float> Stretch<'_, F> {
    /// The Taylor terms of the state, in a long step without the fast modes.
    pub(crate) fn taylor(&self, terms: &mut Vec<F>) {
        match (&self.leap, self.terms) {
            (Some(leap), _) => leap.taylor(self.from, terms),
            (None, Some(known)) => {
                terms.clear();
                terms.extend_from_slice(known);
            }
            (None, None) => self.branch.taylor(self.from, self.time, terms),
        }
    }
}

/// Watches nothing.
impl<F> Watch<F> for () {
    fn stretch(&mut self, _: &Assembly<F>, _: &Stretch<'_, F>) {}
    fn event(&mut self, _: Event<F>) {}
}
