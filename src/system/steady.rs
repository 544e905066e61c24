//! The motion that a start leads to, and its kind.

use super::model::State;
use super::motion::Motion;
use crate::named::named;
use alloc::vec::Vec;

named! {
    /// The kind of a motion after a long time.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "lowercase"))]
    pub enum SteadyKind [name] {
        /// It repeats itself.
        Periodic = "periodic",
        /// Nothing moves.
        Rest = "rest",
        /// All velocities are constant, and not all are 0.
        Uniform = "uniform",
        /// It grows without bound.
        Growing = "growing",
        /// It has not settled within the periods that were followed.
        Unsettled = "unsettled",
    }
}

/// The motion that a start leads to.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Steady<F> {
    /// Its kind.
    pub kind: SteadyKind,
    /// The least period of the motion: that of the loads times [`Steady::periods`], or its own without loads; 0 at rest and in a
    /// uniform motion without loads.
    pub period: F,
    /// After how many periods of the loads it repeats itself; 1 where it does not.
    pub periods: usize,
    /// The state at the phase 0 of the loads; without loads at some instant.
    pub start: State<F>,
    /// One period of it; the last one followed, where it does not repeat itself.
    pub motion: Motion<F>,
    /// The displacement of each coordinate in the period that no force notices, such as that of a body on a conveyor; 0 where springs hold
    /// the system. The motion repeats itself but for it.
    pub drift: Vec<F>,
    /// The mean velocity of each coordinate.
    pub mean_velocity: Vec<F>,
    /// The multipliers of a small disturbance over the period, (real, imaginary), by size: 1 for each number that an element keeps, and
    /// none for the drift. They are computed at f64, and empty where the motion does not repeat itself or they are not found.
    pub multipliers: Vec<(f64, f64)>,
    /// The change of the state over the period, relative to the motion's size.
    pub change: F,
    /// The factor by which the change is multiplied in a period, as it was seen; 0 where the motion has settled, and 1 where its change does
    /// not fall.
    pub decay: F,
    /// The number of periods that were followed; without loads, of spans of 32 periods of the lowest natural frequency.
    pub followed: usize,
    /// The greatest factor by which a small disturbance of the motion grew between two instants while it was followed, in units of the
    /// motion's sizes; 1 where it never grew, and where the motion was found within 8 periods. It is at most
    /// `1/F::epsilon()`, by which a rounding error becomes as large as the motion: near it rounding chooses to which of several motions this
    /// start leads, and the states of an unsettled motion are no prediction. It is an estimate: one disturbance is followed, in a direction
    /// that no symmetry knows.
    pub disturbance_growth: f64,
}
