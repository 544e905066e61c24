//! Ratios at many points: each an array, or one number for all of them.

use crate::refused;
use numpy::PyReadonlyArray1;
use pyo3::prelude::*;
use stickslip::{Error, Ratios};

/// A ratio as Python gives it.
#[derive(FromPyObject)]
pub(crate) enum Given<'py> {
    Many(PyReadonlyArray1<'py, f64>),
    One(f64),
}

/// The values of a ratio at a number of points.
#[derive(Clone, Copy)]
pub(crate) enum Values<'a> {
    /// One number, and a slice filled with it for functions that take slices.
    One(f64, &'a [f64]),
    Many(&'a [f64]),
}

impl<'a> Values<'a> {
    pub(crate) fn of(given: &'a Given<'_>) -> PyResult<Self> {
        Ok(match given {
            Given::One(value) => Self::One(*value, &[]),
            Given::Many(array) => Self::Many(array.as_slice()?),
        })
    }

    pub(crate) fn at(self, i: usize) -> Option<f64> {
        match self {
            Self::One(value, _) => Some(value),
            Self::Many(values) => values.get(i).copied(),
        }
    }

    /// The values before a place, and those from the place on.
    fn split_at(self, place: usize) -> (Self, Self) {
        match self {
            Self::One(..) => (self, self),
            Self::Many(values) => {
                let (low, high) = values.split_at_checked(place).unwrap_or((values, &[]));
                (Self::Many(low), Self::Many(high))
            }
        }
    }

    /// These values, where a single number also gets a slice, stored in `room`.
    fn with_room<'b>(self, room: &'b mut Vec<f64>, most: usize) -> Values<'b>
    where
        'a: 'b,
    {
        match self {
            Self::One(value, _) => {
                room.resize(most, value);
                Values::One(value, room)
            }
            Self::Many(values) => Values::Many(values),
        }
    }

    fn slice(self, n: usize) -> &'a [f64] {
        match self {
            Self::One(_, room) => room.get(..n).unwrap_or_default(),
            Self::Many(values) => values,
        }
    }

    const fn len(self) -> Option<usize> {
        if let Self::Many(values) = self { Some(values.len()) } else { None }
    }

    fn is_constant(self, value: f64) -> bool {
        matches!(self, Self::One(own, _) if own == value)
    }
}

/// Points, each with its Ω, α, ζ and η.
#[derive(Clone, Copy)]
pub(crate) struct Points<'a> {
    pub(crate) omega: Values<'a>,
    pub(crate) alpha: Values<'a>,
    pub(crate) damping: Values<'a>,
    pub(crate) static_friction: Values<'a>,
    /// Phase, displacement and velocity at the start of a motion.
    pub(crate) start: [Values<'a>; 3],
    pub(crate) n: usize,
}

impl<'a> Points<'a> {
    /// The ratios at `n` points.
    pub(crate) fn of(given: &'a [Given<'_>; 4], n: usize) -> PyResult<Self> {
        let [omega, alpha, damping, static_friction] = given;
        let points = Self {
            omega: Values::of(omega)?,
            alpha: Values::of(alpha)?,
            damping: Values::of(damping)?,
            static_friction: Values::of(static_friction)?,
            start: [Values::One(0.0, &[]); 3],
            n,
        };
        points.checked()
    }

    /// These points with the starts of their motions.
    pub(crate) fn from(self, start: &'a [Given<'_>; 3]) -> PyResult<Self> {
        let [phase, displacement, velocity] = start;
        Self { start: [Values::of(phase)?, Values::of(displacement)?, Values::of(velocity)?], ..self }
            .checked()
    }

    /// These points, if each column has their number.
    fn checked(self) -> PyResult<Self> {
        let columns =
            [self.omega, self.alpha, self.damping, self.static_friction].into_iter().chain(self.start);
        if columns.filter_map(Values::len).any(|len| len != self.n) {
            return Err(refused("columns of different lengths"));
        }
        Ok(self)
    }

    pub(crate) fn split_at(self, place: usize) -> (Self, Self) {
        let (omega, alpha) = (self.omega.split_at(place), self.alpha.split_at(place));
        let (damping, friction) = (self.damping.split_at(place), self.static_friction.split_at(place));
        let part = |omega, alpha, damping, static_friction, start, n| Self {
            omega,
            alpha,
            damping,
            static_friction,
            start,
            n,
        };
        let start = self.start.map(|values| values.split_at(place));
        (
            part(omega.0, alpha.0, damping.0, friction.0, start.map(|start| start.0), place),
            part(
                omega.1,
                alpha.1,
                damping.1,
                friction.1,
                start.map(|start| start.1),
                self.n.saturating_sub(place),
            ),
        )
    }

    /// These points, where an Ω or α common to all points also gets a slice of length `most`, stored in
    /// `room`.
    pub(crate) fn with_room<'b>(self, room: &'b mut [Vec<f64>; 2], most: usize) -> Points<'b>
    where
        'a: 'b,
    {
        let [omega, alpha] = room;
        Points { omega: self.omega.with_room(omega, most), alpha: self.alpha.with_room(alpha, most), ..self }
    }

    /// Ω and α as slices; the number of points must not exceed the room.
    pub(crate) fn slices(self) -> (&'a [f64], &'a [f64]) {
        (self.omega.slice(self.n), self.alpha.slice(self.n))
    }

    /// Whether no point has damping or a static friction above the kinetic one.
    pub(crate) fn is_plain(self) -> bool {
        self.damping.is_constant(0.0) && self.static_friction.is_constant(1.0)
    }

    /// The ratios at a point.
    pub(crate) fn at(self, i: usize) -> Option<Point> {
        Some((self.omega.at(i)?, self.alpha.at(i)?, self.damping.at(i)?, self.static_friction.at(i)?))
    }

    /// The start of the motion at a point.
    pub(crate) fn start_at(&self, i: usize) -> Option<(f64, f64, f64)> {
        let [phase, x, v] = self.start;
        Some((phase.at(i)?, x.at(i)?, v.at(i)?))
    }

    /// The start of all motions, if it is one.
    pub(crate) const fn one_start(&self) -> Option<(f64, f64, f64)> {
        match self.start {
            [Values::One(phase, _), Values::One(x, _), Values::One(v, _)] => Some((phase, x, v)),
            _ => None,
        }
    }
}

/// Ω, α, ζ and η.
pub(crate) type Point = (f64, f64, f64, f64);

pub(crate) fn ratios((omega, alpha, damping, static_friction): Point) -> Result<Ratios<f64>, Error> {
    Ratios::new(omega, alpha)?.with_damping_ratio(damping)?.with_static_friction_ratio(static_friction)
}
