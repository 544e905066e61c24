//! A body with dry friction by small steps and dense samples: the reference of every number that a motion has.
//!
//! It shares no code and no formula with the library. The state (x, x′, load, second state of the load, 1) obeys a linear
//! equation in each direction of the motion and at rest. A step is its matrix exponential, by the power series with
//! scaling and squaring; a change of direction is bisected. Extremes are those of the samples, and between samples the
//! bisected zero of the derivative. Works are integrals over the steps by Hermite's formula of the sixth order.

//!
//! | file | content |
//! |---|---|
//! | `found` | extremes, paths and works of a stretch of a motion |
//! | `follower` | the motion, step by step and event by event |
//! | `harmonic` | its limit under a harmonic load |
//! | `recorded` | its answers under a record and after it |

#![allow(dead_code, unused_imports, reason = "each test takes what it needs")]

#[path = "sampled/follower.rs"]
mod follower;
#[path = "sampled/found.rs"]
mod found;
#[path = "sampled/harmonic.rs"]
mod harmonic;
#[path = "sampled/recorded.rs"]
mod recorded;

pub(crate) use follower::Follower;
pub(crate) use found::{Floor, Found, GAUSS};
pub(crate) use harmonic::{Cycle, Harmonic, Limit};
pub(crate) use recorded::{Recorded, positions, record, watched};

pub(crate) type Row = [f64; 5];
pub(crate) type Matrix = [Row; 5];

fn dot(a: &Row, b: &Row) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3] + a[4] * b[4]
}

fn times(a: &Matrix, z: &Row) -> Row {
    [dot(&a[0], z), dot(&a[1], z), dot(&a[2], z), dot(&a[3], z), dot(&a[4], z)]
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    let mut c = [[0.0; 5]; 5];
    for (row, into) in a.iter().zip(&mut c) {
        for (factor, other) in row.iter().zip(b) {
            for (sum, x) in into.iter_mut().zip(other) {
                *sum += factor * x;
            }
        }
    }
    c
}

fn sum(terms: &[(f64, Row)]) -> Row {
    let mut total = [0.0; 5];
    for (factor, row) in terms {
        for (into, x) in total.iter_mut().zip(row) {
            *into += factor * x;
        }
    }
    total
}

/// e^{Ah}, by the power series of A h/2ⁿ and n squarings. The rate is the greatest one of A, whatever the units of its
/// rows: a squaring more than needed would cost a bit.
fn exponential(a: &Matrix, h: f64, rate: f64) -> Matrix {
    let size = rate * h;
    let halvings = if size > 0.25 { (size / 0.25).log2().ceil() as i32 } else { 0 };
    let scale = h / 2f64.powi(halvings);
    let unit = |i: usize| {
        let mut row = [0.0; 5];
        row[i] = 1.0;
        row
    };
    let mut term: Matrix = std::array::from_fn(unit);
    let mut total = term;
    for k in 1..20 {
        term = product(a, &term);
        for (row, into) in term.iter_mut().zip(&mut total) {
            for (x, sum) in row.iter_mut().zip(into) {
                *x *= scale / f64::from(k);
                *sum += *x;
            }
        }
    }
    (0..halvings).fold(total, |power, _| product(&power, &power))
}

/// e^{At} z, by the power series over short parts of t.
fn moved(a: &Matrix, z: &Row, t: f64) -> Row {
    let mut term = *z;
    let mut total = *z;
    for k in 1..18 {
        let next = times(a, &term);
        for ((x, y), into) in term.iter_mut().zip(&next).zip(&mut total) {
            *x = y * t / f64::from(k);
            *into += *x;
        }
    }
    total
}

/// The load: its first state is a force on the body, the displacement of the support of the spring, that of the support of
/// spring and damper, or the acceleration of the surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Load {
    Force,
    Foot,
    DampedFoot,
    Surface,
}

impl Load {
    pub(crate) fn is_foot(self) -> bool {
        matches!(self, Self::Foot | Self::DampedFoot)
    }
}

/// `m x″ + c x′ + k x + friction = load + p̄`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Machine {
    pub(crate) mass: f64,
    pub(crate) stiffness: f64,
    pub(crate) damping: f64,
    /// Friction against motion with x′ > 0 and with x′ < 0.
    pub(crate) friction: [f64; 2],
    /// The forces that release the body forwards and backwards.
    pub(crate) held: [f64; 2],
    pub(crate) mean: f64,
    pub(crate) is_one_way: bool,
}

impl Machine {
    /// A body with friction r_y in the mean, ±`offset` by direction, and static friction of η times the mean.
    pub(crate) fn new(
        [mass, stiffness, damping]: [f64; 3],
        [friction, offset, eta]: [f64; 3],
        mean: f64,
    ) -> Self {
        Self {
            mass,
            stiffness,
            damping,
            friction: [friction + offset, friction - offset],
            held: [eta * friction + offset, eta * friction - offset],
            mean,
            is_one_way: false,
        }
    }

    /// The shortest time in which the motion changes, as a period.
    pub(crate) fn period(&self) -> f64 {
        let natural = (self.stiffness / self.mass).sqrt();
        let rate = natural.max(self.damping / self.mass);
        std::f64::consts::TAU / rate.max(1e-300)
    }
}

/// Quantities that have extremes: x, x′, x″, the acceleration and the displacement in space, the force of spring,
/// damper and friction on their support, and that of the spring alone.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Of {
    Displacement,
    Velocity,
    Acceleration,
    AbsoluteAcceleration,
    AbsoluteDisplacement,
    Transmitted,
    Spring,
}
const QUANTITIES: [Of; 7] = [
    Of::Displacement,
    Of::Velocity,
    Of::Acceleration,
    Of::AbsoluteAcceleration,
    Of::AbsoluteDisplacement,
    Of::Transmitted,
    Of::Spring,
];

/// An extreme of the samples, that between samples, and the time of the latter.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Extreme {
    pub(crate) sampled: f64,
    pub(crate) value: f64,
    pub(crate) time: f64,
}

/// The body and its load as one linear equation.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Equation {
    pub(crate) machine: Machine,
    pub(crate) load: Load,
    /// The load's state l obeys `l′ = law · l`.
    pub(crate) law: [[f64; 2]; 2],
    /// The displacement of the surface over its acceleration, where there is one.
    pub(crate) surface: f64,
}

impl Equation {
    /// The greatest rate of change.
    fn rate(&self) -> f64 {
        (std::f64::consts::TAU / self.machine.period()).max(self.law[1][0].abs())
    }

    /// The rate of change of the load's first state.
    fn load_rate(&self) -> Row {
        [0.0, 0.0, self.law[0][0], self.law[0][1], 0.0]
    }

    /// The force of the load on the body.
    fn force(&self) -> Row {
        let Machine { mass, stiffness, damping, .. } = self.machine;
        let first = [0.0, 0.0, 1.0, 0.0, 0.0];
        match self.load {
            Load::Force => first,
            Load::Foot => sum(&[(stiffness, first)]),
            Load::DampedFoot => sum(&[(stiffness, first), (damping, self.load_rate())]),
            Load::Surface => sum(&[(-mass, first)]),
        }
    }

    /// The force on a body at rest.
    fn pull(&self) -> Row {
        sum(&[
            (1.0, self.force()),
            (1.0, [-self.machine.stiffness, -self.machine.damping, 0.0, 0.0, self.machine.mean]),
        ])
    }

    fn matrix(&self, sign: i32) -> Matrix {
        let Machine { mass, friction, .. } = self.machine;
        let law = self.law;
        let load = [[0.0, 0.0, law[0][0], law[0][1], 0.0], [0.0, 0.0, law[1][0], law[1][1], 0.0]];
        if sign == 0 {
            return [[0.0; 5], [0.0; 5], load[0], load[1], [0.0; 5]];
        }
        let against = if sign > 0 { -friction[0] } else { friction[1] };
        let pull = sum(&[(1.0 / mass, self.pull()), (against / mass, [0.0, 0.0, 0.0, 0.0, 1.0])]);
        [[0.0, 1.0, 0.0, 0.0, 0.0], pull, load[0], load[1], [0.0; 5]]
    }

    /// A quantity as a row that the state is multiplied by.
    fn row(&self, of: Of, a: &Matrix) -> Row {
        let unit = |i: usize| {
            let mut row = [0.0; 5];
            row[i] = 1.0;
            row
        };
        let of_surface = f64::from(u8::from(self.load == Load::Surface));
        match of {
            Of::Displacement => unit(0),
            Of::Velocity => unit(1),
            Of::Acceleration => a[1],
            Of::AbsoluteAcceleration => sum(&[(1.0, a[1]), (of_surface, unit(2))]),
            Of::AbsoluteDisplacement => sum(&[(1.0, unit(0)), (of_surface * self.surface, unit(2))]),
            Of::Transmitted => {
                // m x″ = load + p̄ − transmitted; support and surface bear the body together.
                let load = if self.load.is_foot() { 0.0 } else { 1.0 };
                sum(&[(load, self.force()), (self.machine.mean, unit(4)), (-self.machine.mass, a[1])])
            }
            // The support is the load's first state where it moves.
            Of::Spring => {
                let foot = if self.load.is_foot() { 1.0 } else { 0.0 };
                sum(&[(self.machine.stiffness, unit(0)), (-self.machine.stiffness * foot, unit(2))])
            }
        }
    }
}
