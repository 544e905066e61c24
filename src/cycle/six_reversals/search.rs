//! Where to start: a point of an edge at f64, found along its curve.
//!
//! On an edge, four of the five equations are linear once the two arcs a and b are known: [`arcs`] solves
//! three of them for (s, c, p). The two conditions of antisymmetry leave `p X + q Y = 0`, which gives one arc
//! from the other, and `cot β = −Y/p`. So each edge is a curve parametrised by its short arc (b at the third
//! reversal, a at the second), from cot β = 0 at an arc of zero, where α is infinite, to the greatest |cot β|
//! and back. The other arc is close to a polynomial in the first, for any Ω: the difference between Ω = 0 and
//! 1/3 is 0.025.

use super::equations::{Closing, Unknowns};
use super::newton::solve;
use crate::root::bracketed;

/// A point of an edge: the unknowns, and the cot β at which they solve the matching problem.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sample {
    pub(super) unknowns: Unknowns<f64>,
    pub(super) cotangent: f64,
}

/// Which edge: at the second or at the third reversal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Edge {
    Second,
    Third,
}

impl Edge {
    pub(super) const fn closing<F>(self) -> Closing<F> {
        match self {
            Self::Second => Closing::Second,
            Self::Third => Closing::Third,
        }
    }

    /// The long arc, by the short one, to within 0.013.
    fn long_arc(self, short: f64) -> f64 {
        let [c0, c1, c2, c3, c4] = match self {
            Self::Second => [2.343, -0.776, -0.313, 0.044, -0.158],
            Self::Third => [2.344, -2.301, 1.611, -0.706, 0.131],
        };
        c0 + short * (c1 + short * (c2 + short * (c3 + short * c4)))
    }

    /// The short arcs between which |cot β| has its maximum.
    const fn around_tip(self) -> (f64, f64) {
        match self {
            Self::Second => (0.4, 0.8),
            Self::Third => (0.25, 0.6),
        }
    }

    /// The point of the edge at a short arc.
    pub(super) fn at(self, omega: f64, short: f64) -> Sample {
        let guess = self.long_arc(short);
        let arcs_of = |long: f64| match self {
            Self::Second => (short, long),
            Self::Third => (long, short),
        };
        let symmetry = |long: f64| {
            let (a, b) = arcs_of(long);
            arcs(self, omega, a, b).map_or(f64::NAN, |y| {
                y.swing * (a.cos() + b.cos() - 1.0) + y.quarter_swing() * (a.sin() - b.sin())
            })
        };
        let (a, b) = arcs_of(bracketed(guess - WIDTH, guess + WIDTH, symmetry));
        let nowhere = Unknowns { before: a, after: b, sine: f64::NAN, cosine: f64::NAN, swing: f64::NAN };
        let unknowns = arcs(self, omega, a, b).unwrap_or(nowhere);
        Sample { unknowns, cotangent: (b.sin() - a.sin()) / unknowns.swing }
    }

    /// The short arc at which |cot β| is greatest, by golden-section search.
    pub(super) fn tip(self, omega: f64) -> f64 {
        let share = (5f64.sqrt() - 1.0) / 2.0;
        let size = |short| self.at(omega, short).cotangent.abs();
        let (mut low, mut high) = self.around_tip();
        let (mut left, mut right) = (high - share * (high - low), low + share * (high - low));
        let (mut at_left, mut at_right) = (size(left), size(right));
        while high - low > 1e-7 {
            if at_left > at_right {
                (high, right, at_right) = (right, left, at_left);
                left = high - share * (high - low);
                at_left = size(left);
            } else {
                (low, left, at_left) = (left, right, at_right);
                right = low + share * (high - low);
                at_right = size(right);
            }
        }
        (low + high) / 2.0
    }

    /// The point with the given cot β between two short arcs, if there is one.
    pub(super) fn with_cotangent(self, omega: f64, cotangent: f64, from: f64, to: f64) -> Option<Sample> {
        let excess = |short| self.at(omega, short).cotangent - cotangent;
        if !((excess(from) <= 0.0) ^ (excess(to) <= 0.0)) {
            return None;
        }
        Some(self.at(omega, bracketed(from, to, excess)))
    }
}

/// How far the long arc may be from its polynomial.
const WIDTH: f64 = 0.08;

/// (s, c, p) on an edge for two arcs.
fn arcs(edge: Edge, omega: f64, a: f64, b: f64) -> Option<Unknowns<f64>> {
    let kappa = |u: f64| 2.0 * ((1.0 + omega) * u / 2.0).sin() * ((1.0 - omega) * u / 2.0).sin() / u.sin();
    let mu = |u: f64| (omega * u).sin() / (omega * u.sin());
    let (slow_sine, slow_cosine) = (omega * b).sin_cos();
    let (last, right) = match edge {
        Edge::Second => ([0.0, -1.0, -1.0], 1.0 - a.cos() + b.cos()),
        Edge::Third => (
            [omega * slow_sine - b.sin(), -slow_cosine, -b.cos()],
            -1.0 - (a + b).cos() + b.cos() - (a.sin() + b.sin()) * b.sin(),
        ),
    };
    let rows = [[-kappa(a), mu(a), 1.0], [-kappa(b), -mu(b), -1.0], last];
    let [sine, cosine, swing] = solve(rows, [1.0 + a.cos() - b.cos(), 1.0 + b.cos() - a.cos(), right])?;
    Some(Unknowns { before: a, after: b, sine, cosine, swing })
}
