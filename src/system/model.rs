//! The description of a system: matrices, loads and elements, as they are given.

use crate::float::Float;
use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;

/// A structure with its loads and its elements: `M q″ + C q′ + K q = f(t) − Σ b T`.
///
/// All numbers are in one consistent system of units, with frequencies in radians per unit of time. Nothing is
/// checked before [`System::new`](super::System::new).
#[derive(Debug, Clone, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, bound(deserialize = "F: Default + serde::Deserialize<'de>")))]
pub struct Model<F> {
    /// The names of the coordinates, which errors use; their places where it is empty.
    pub coordinates: Vec<String>,
    /// M by rows: symmetric and positive definite, but for coordinates whose row is 0. These have no mass: their forces balance.
    pub mass: Vec<Vec<F>>,
    /// C by rows.
    pub damping: Vec<Vec<F>>,
    /// K by rows.
    pub stiffness: Vec<Vec<F>>,
    /// The elements.
    pub elements: Vec<Element<F>>,
    /// The constant force on each coordinate; none where it is empty.
    pub constant: Vec<F>,
    /// The harmonic loads. Moving sides and normal loads use their frequencies.
    pub harmonics: Vec<Harmonic<F>>,
    /// The loads given by samples. Moving sides, normal loads and moved coordinates use them.
    pub records: Vec<Record<F>>,
    /// The coordinates whose motion is prescribed.
    pub moved: Vec<Moved<F>>,
    /// The values whose passage is an event.
    pub levels: Vec<Level<F>>,
}

/// A value that `displacement·q + velocity·q′` passes.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Level<F> {
    /// The name that errors and answers use.
    pub name: String,
    /// The factor of each displacement; none where it is empty.
    pub displacement: Vec<F>,
    /// The factor of each velocity; none where it is empty.
    pub velocity: Vec<F>,
    /// The value.
    pub value: F,
}

/// The load `sin · sin ωt + cos · cos ωt`.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Harmonic<F> {
    /// ω > 0.
    pub frequency: F,
    /// The force on each coordinate in phase with sin ωt; none where it is empty.
    pub sin: Vec<F>,
    /// The force on each coordinate in phase with cos ωt; none where it is empty.
    pub cos: Vec<F>,
}

/// The load `force · p(t)`, where p is straight between its samples.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Record<F> {
    /// The times of the samples, which increase. Two samples at one time are a step of the load.
    pub times: Vec<F>,
    /// p at these times.
    pub values: Vec<F>,
    /// The force on each coordinate where p = 1: for a base that moves with the acceleration p, −M ι.
    pub force: Vec<F>,
    /// p beyond the samples.
    pub beyond: Beyond,
}

/// What a record is beyond its samples.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum Beyond {
    /// Zero before the first sample and after the last.
    #[default]
    Zero,
    /// The value of the first sample before it, and of the last after it.
    Hold,
    /// The same again and again, also before the first sample: the period is the time from the first sample to the last. Where
    /// their values differ, p changes at once.
    Repeat,
}

/// `constant + Σ (sin sin ωt + cos cos ωt) + Σ (records p + rates p′)` over the harmonics and the records of the model, in their
/// order. Factors are zero where a list ends early.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Signal<F> {
    /// The constant part.
    pub constant: F,
    /// The factors of sin ωt.
    pub sin: Vec<F>,
    /// The factors of cos ωt.
    pub cos: Vec<F>,
    /// The factors of the records p.
    pub records: Vec<F>,
    /// The factors of their slopes p′.
    pub rates: Vec<F>,
}

impl<F: Float> Signal<F> {
    /// A constant.
    #[must_use]
    pub const fn constant(constant: F) -> Self {
        Self { constant, sin: Vec::new(), cos: Vec::new(), records: Vec::new(), rates: Vec::new() }
    }
}

/// A coordinate whose motion is prescribed, whatever force that takes: a carriage, a shaken support, the pulled end of a spring.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Moved<F> {
    /// Its place among the coordinates.
    pub coordinate: usize,
    /// The quantity that the signal prescribes.
    pub by: MovedBy,
    /// The quantity over time. Its `rates` are empty.
    pub signal: Signal<F>,
}

/// The quantity that is prescribed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum MovedBy {
    /// The displacement. Its velocity changes at once at the samples of a record, and its displacement at two values at one time.
    Displacement,
    /// The velocity, from the displacement of the start.
    Velocity,
    /// The acceleration, from the displacement and the velocity of the start.
    Acceleration,
}

/// The motion of the base over which the coordinates are measured.
///
/// It adds no load: that of a base which moves with the acceleration a is `−M influence · a`, among the loads of the model.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Base<F> {
    /// ι: the displacement of each coordinate where the base alone moves by 1.
    pub influence: Vec<F>,
    /// Its acceleration.
    pub acceleration: Signal<F>,
}

/// An element between bodies, or between a body and the ground.
///
/// Its force acts along a direction b: `y = b·q − Y(t)` is its stretch and `v = b·q′ − V(t)` its velocity.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Element<F> {
    /// The name that errors and answers use.
    pub name: String,
    /// b: 1 at a body and −1 at the one that it slides on, for example.
    pub direction: Vec<F>,
    /// V(t): the prescribed velocity of the other side, such as that of a belt.
    pub moves: Signal<F>,
    /// Its law.
    pub kind: Kind<F>,
}

/// The law of an element.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum Kind<F> {
    /// Dry friction: it sticks while `|T| ≤ peak r(0) N`, and slides with `T = r(|v|) N sgn v`.
    Contact {
        /// r over the speed.
        law: Law<F>,
        /// The static friction over the kinetic one, ≥ 1.
        peak: F,
        /// N, by which the law is multiplied. Without it, N = 1.
        normal: Option<Normal<F>>,
    },
    /// A spring with a slider (Jenkins): `T′ = stiffness · v` while `|T| < friction N`. Where it opens, it forgets its force.
    Elastic {
        /// The stiffness of the spring.
        stiffness: F,
        /// The force at which the slider slides, for N = 1.
        friction: F,
        /// N. Without it, N = 1.
        normal: Option<Normal<F>>,
    },
    /// An elastic stop: `T = stiffness (y − gap) + damping v` where `y > gap` and T > 0. For the other side
    /// reverse its direction.
    Stop {
        /// The gap.
        gap: F,
        /// The stiffness.
        stiffness: F,
        /// The damping constant.
        damping: F,
    },
    /// A stop that gives no way: where y reaches the gap with a velocity v > 0, that becomes −restitution · v at once. After ever smaller
    /// blows, and with the restitution 0 after the first, it holds y = gap with a force T ≥ 0, and opens where T would be below 0.
    HardStop {
        /// The gap.
        gap: F,
        /// The coefficient of restitution, from 0 to 1.
        restitution: F,
    },
    /// Dry friction under the force N ≥ 0 of a stop that gives no way: it sticks while `|T| ≤ peak coefficient N`, and slides with
    /// `T = coefficient N sgn v`. Under a blow of the impulse P its own impulse is at most coefficient · P, and takes the velocity v to 0 at
    /// most. No force or impulse of the stop may depend on that friction, as where its direction b is across the stop's: `b·M⁻¹b_stop = 0`.
    UnderStop {
        /// The place of the stop among the elements.
        stop: usize,
        /// The coefficient of friction.
        coefficient: F,
        /// The static friction over the kinetic one, ≥ 1.
        peak: F,
    },
    /// A spring whose force T over y is straight between points (displacement, force), of which there are at least two. Their
    /// displacements increase, and the first and the last straight line go on beyond them. Its work is what it stores.
    Spring {
        /// The points.
        points: Vec<(F, F)>,
    },
}

/// The normal load of a contact, `signal + displacement·q + velocity·q′`; the contact is open while it is below 0. It does not
/// change at once.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Normal<F> {
    /// The part that depends on time.
    pub signal: Signal<F>,
    /// The part for each displacement; none where it is empty.
    pub displacement: Vec<F>,
    /// The part for each velocity; none where it is empty.
    pub velocity: Vec<F>,
}

/// A friction force over the speed: straight between its points.
///
/// Beyond the last point the last straight line goes on, if it falls down to zero, and stays there.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Law<F> {
    /// Speeds, which increase from 0, with the friction force at each.
    pub points: Vec<(F, F)>,
}

impl<F: Float> Law<F> {
    /// Coulomb's law: one force at every speed.
    #[must_use]
    pub fn constant(force: F) -> Self {
        Self { points: vec![(F::int(0), force)] }
    }
}

/// Displacements, velocities, and the forces of the elements at one instant.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct State<F> {
    /// q.
    pub displacement: Vec<F>,
    /// q′.
    pub velocity: Vec<F>,
    /// The force T of each element; a start needs those of the elastic contacts only, and takes 0 where the list
    /// ends early.
    pub force: Vec<F>,
    /// `q″ + influence · acceleration`, the absolute acceleration of each coordinate; at an instant where it jumps, such as an
    /// event, the value of one side. None without a [`Base`], and a start needs none.
    #[cfg_attr(feature = "serde", serde(default = "Vec::new"))]
    pub absolute_acceleration: Vec<F>,
}

impl<F: Float> State<F> {
    /// At rest in the origin, with unloaded elastic contacts.
    #[must_use]
    pub fn rest(coordinates: usize) -> Self {
        let zero = vec![F::int(0); coordinates];
        Self {
            displacement: zero.clone(),
            velocity: zero,
            force: Vec::new(),
            absolute_acceleration: Vec::new(),
        }
    }
}
