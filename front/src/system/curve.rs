//! Laws that are curves, friction over speed or a spring's force over its stretch, and the tables that stand for them.
//!
//! **The knots.** On a piece of length h a straight line through two points of f errs by at most `h² max|f″|/8`. So the knots have equal
//! parts of `∫ √|f″|`, which makes that error the same in all pieces. It is measured on a fine mesh as `√(8 · error)` of each of its
//! intervals, without a derivative. A table with twice as many pieces has all knots of the first, and a quarter of its error.
//!
//! A fifth more of them lies evenly over the whole length, so that the pieces also shrink in proportion where the curve is nearly straight:
//! extrapolation needs that.
//!
//! **The shift.** A chord lies on one side of f. Each knot is moved to the other side by half of that error, which halves it. The first point of a
//! friction law, its static friction, and the middle of an odd spring stay.

use super::formula::Formula;
use super::interval::{Interval, Jet};
use std::ops::Neg;

/// The most pieces of a table; one that is twice as fine has twice as many.
const MOST_PIECES: usize = 4000;
/// The intervals with which a mesh begins, and how often one is halved.
const INTERVALS: usize = 256;
const HALVINGS: u32 = 44;
/// The most intervals of a mesh.
const MOST_INTERVALS: usize = 200_000;
/// The part of the force within which a mesh is straight, over that of the table.
const FINER: f64 = 64.0;
/// The share of the chord's error by which knots are moved.
const SHIFT: f64 = 0.5;
/// The part of the knots that lies evenly, over those by curvature.
const EVEN: f64 = 0.2;
/// The points of a piece at which its error is measured.
const POINTS: usize = 16;
/// A bound of a table's error is at most so much above the greatest error that was measured, where it takes no more than so many enclosures
/// a piece, each of an interval halved so often at most.
const CLOSE: f64 = 1.01;
const ENCLOSURES: usize = 400;
const DEEPEST: u32 = 60;

/// A curve.
#[derive(Debug, Clone)]
pub(super) enum Curve {
    /// `kinetic + (static − kinetic) exp(−(v/speed)^exponent) + viscous v`.
    Stribeck {
        kinetic: f64,
        static_: f64,
        speed: f64,
        exponent: f64,
        viscous: f64,
    },
    Formula(Formula),
}

impl Curve {
    pub(super) fn at(&self, x: f64) -> f64 {
        match self {
            Self::Stribeck { kinetic, static_, speed, exponent, viscous } => {
                let part = x / speed;
                let power = if *exponent == 2.0 { part * part } else { libm::pow(part, *exponent) };
                kinetic + (static_ - kinetic) * libm::exp(-power) + viscous * x
            }
            Self::Formula(formula) => formula.at(x),
        }
    }

    /// It and its first two derivatives over an interval.
    fn jet(&self, x: Interval) -> Jet {
        match self {
            Self::Stribeck { kinetic, static_, speed, exponent, viscous } => {
                let (x, number) = (Jet::variable(x), Jet::number);
                let power = x.over(number(*speed)).power(number(*exponent));
                let falls = number(*static_).minus(number(*kinetic)).times(power.negative().apply("exp"));
                number(*kinetic).plus(falls).plus(number(*viscous).times(x))
            }
            Self::Formula(formula) => formula.jet(x),
        }
    }

    /// Its value as the law of something: below 0 that of an odd spring is mirrored.
    pub(super) fn of(&self, of: Of, x: f64) -> f64 {
        if of == Of::OddSpring && x < 0.0 { -self.at(-x) } else { self.at(x) }
    }

    /// A length over which it bends, where one is known.
    pub(super) const fn scale(&self) -> Option<f64> {
        match self {
            Self::Stribeck { speed, .. } => Some(*speed),
            Self::Formula(_) => None,
        }
    }
}

/// What a curve is the law of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Of {
    /// A contact: over speeds from 0 up, ≥ 0.
    Friction,
    /// A spring: over stretches of both signs.
    Spring,
    /// A spring whose formula holds from 0 up, and mirrored below.
    OddSpring,
}

impl Of {
    const fn variable(self) -> &'static str {
        match self {
            Self::Friction => "v",
            Self::Spring | Self::OddSpring => "x",
        }
    }
}

/// A mesh of a curve up to a greatest speed or stretch.
pub(super) struct Mesh<'c> {
    curve: &'c Curve,
    of: Of,
    /// Places with the sum of the measure up to each.
    places: Vec<(f64, f64)>,
    /// The force within which it is straight.
    straight: f64,
}

/// The points of a table.
pub(super) type Points = Vec<(f64, f64)>;

/// Points from (0, 0) up, with those below 0 of the opposite sign.
pub(super) fn mirrored<F: Copy + Neg<Output = F>>(points: &[(F, F)]) -> Vec<(F, F)> {
    let below = points.iter().skip(1).rev().map(|&(x, force)| (-x, -force));
    below.chain(points.iter().copied()).collect()
}

/// The greatest size of a curve up to a place.
pub(super) fn size(curve: &Curve, of: Of, reach: f64) -> f64 {
    let count = INTERVALS as f64;
    let at = |i: usize| {
        let x = reach * (i as f64 / count);
        let other = if of == Of::Spring { curve.at(-x).abs() } else { 0.0 };
        curve.at(x).abs().max(other)
    };
    (0..=INTERVALS).map(at).fold(0.0, f64::max)
}

/// The value of a curve, where it is one.
fn valued(curve: &Curve, of: Of, x: f64) -> Result<f64, String> {
    let value = curve.at(x);
    let at = || format!("{} = {x}", of.variable());
    if !value.is_finite() {
        return Err(format!("is {value} at {}, must be finite as far as the motion may go", at()));
    }
    if of == Of::Friction && value < 0.0 {
        return Err(format!(
            "is {value} at {}, must be ≥ 0 as far as the motion may go: write max(…, 0) around a formula that falls",
            at()
        ));
    }
    Ok(value)
}

impl<'c> Mesh<'c> {
    /// The mesh up to `reach`, for tables within `tolerance` of the force.
    pub(super) fn new(curve: &'c Curve, of: Of, reach: f64, tolerance: f64) -> Result<Self, String> {
        let low = if of == Of::Spring { -reach } else { 0.0 };
        if of == Of::OddSpring && curve.at(0.0) != 0.0 {
            return Err(format!(
                "is {} at x = 0, must be 0 where odd mirrors it: leave out odd",
                curve.at(0.0)
            ));
        }
        let straight = tolerance / FINER;
        let mut mesh = Self { curve, of, places: vec![(low, 0.0)], straight };
        let mut from = (low, valued(curve, of, low)?);
        for i in 1..=INTERVALS {
            let x = low + (reach - low) * (i as f64 / INTERVALS as f64);
            let to = (x, valued(curve, of, x)?);
            mesh.add(from, to, HALVINGS)?;
            from = to;
        }
        Ok(mesh)
    }

    /// Adds an interval, halved until it is straight.
    fn add(&mut self, from: (f64, f64), to: (f64, f64), left: u32) -> Result<(), String> {
        let at = |part: f64| {
            let x = from.0 + part * (to.0 - from.0);
            valued(self.curve, self.of, x).map(|value| (x, value))
        };
        let inner = [at(0.25)?, at(0.5)?, at(0.75)?];
        let off = |part: f64, value: f64| (value - (from.1 + part * (to.1 - from.1))).abs();
        let error = inner.iter().zip([0.25, 0.5, 0.75]).map(|(p, part)| off(part, p.1)).fold(0.0, f64::max);
        // Below it are the roundings of the curve.
        let rounding = 8.0 * f64::EPSILON * (from.1.abs() + to.1.abs());
        if error <= self.straight.max(rounding) {
            let before = self.places.last().map_or(0.0, |place| place.1);
            self.places.push((to.0, before + (8.0 * error).sqrt()));
            return Ok(());
        }
        if left == 0 {
            let variable = self.of.variable();
            return Err(format!("must not jump, but does at {variable} = {}", from.0));
        }
        if self.places.len() > MOST_INTERVALS {
            return Err(format!(
                "needs too many pieces to be within {} of the curve: allow more by tolerance or --law-tolerance",
                self.straight * FINER
            ));
        }
        self.add(from, inner[1], left.saturating_sub(1))?;
        self.add(inner[1], to, left.saturating_sub(1))
    }

    /// The place at which this part of the measure is left behind.
    fn place(&self, part: f64) -> f64 {
        let (first, last) = (self.places.first().copied(), self.places.last().copied());
        let (Some((low, _)), Some((high, total))) = (first, last) else { return 0.0 };
        let flat = EVEN * total.max(f64::MIN_POSITIVE.sqrt()) / (high - low);
        let measure = |(x, own): (f64, f64)| own + flat * (x - low);
        let due = part * measure((high, total));
        let after = self.places.partition_point(|place| measure(*place) < due);
        let (Some(&to), Some(&from)) = (self.places.get(after), self.places.get(after.saturating_sub(1)))
        else {
            return high;
        };
        let (a, b) = (measure(from), measure(to));
        if b > a { from.0 + (to.0 - from.0) * ((due - a) / (b - a)).clamp(0.0, 1.0) } else { to.0 }
    }

    /// An even number of pieces for a table within a force of the curve.
    pub(super) fn pieces(&self, tolerance: f64) -> Result<usize, String> {
        let total = self.places.last().map_or(0.0, |place| place.1);
        let mut count = ((1.0 + EVEN) * total / (8.0 * tolerance / SHIFT).sqrt()).ceil().max(1.0);
        loop {
            if count > MOST_PIECES as f64 {
                return Err(format!(
                    "needs {count} pieces to be within {tolerance} of the curve, must need ≤ {MOST_PIECES}: allow more by tolerance or \
                     --law-tolerance"
                ));
            }
            let pieces = (count as usize).next_multiple_of(2);
            let table = self.table(pieces);
            // A curve without a bound, such as one with a corner, is measured alone.
            let is_bounded = || self.bound(&table, tolerance).is_none_or(|bound| bound <= tolerance);
            if self.within(&table) <= tolerance && is_bounded() {
                return Ok(pieces);
            }
            count = (count * 1.1).ceil() + 1.0;
        }
    }

    /// The table of so many pieces.
    pub(super) fn table(&self, pieces: usize) -> Points {
        let ends = [self.places.first(), self.places.last()].map(|place| place.map_or(0.0, |place| place.0));
        let mut knots: Vec<f64> = (0..=pieces).map(|i| self.place(i as f64 / pieces as f64)).collect();
        if let (Some(first), [low, _]) = (knots.first_mut(), ends) {
            *first = low;
        }
        if let (Some(last), [_, high]) = (knots.last_mut(), ends) {
            *last = high;
        }
        knots.dedup_by(|b, a| *b <= *a);
        let value = |x: f64| self.curve.at(x);
        // By how much the curve is above the middle of each chord.
        let pairs = || knots.iter().zip(knots.iter().skip(1)).map(|(a, b)| (*a, *b));
        let above: Vec<f64> =
            pairs().map(|(a, b)| value(f64::midpoint(a, b)) - f64::midpoint(value(a), value(b))).collect();
        let last = knots.len().saturating_sub(1);
        let keeps = |place: usize| place == 0 && self.of != Of::Spring;
        let moved = |(place, &x): (usize, &f64)| {
            let of = |place: usize| above.get(place).copied();
            let by = match (place.checked_sub(1).and_then(of), if place < last { of(place) } else { None }) {
                _ if keeps(place) => 0.0,
                (Some(a), Some(b)) => f64::midpoint(a, b),
                (Some(one), None) | (None, Some(one)) => one,
                (None, None) => 0.0,
            };
            let force = value(x) + SHIFT * by;
            (x, if self.of == Of::Friction { force.max(0.0) } else { force })
        };
        let points: Vec<(f64, f64)> = knots.iter().enumerate().map(moved).collect();
        if self.of == Of::OddSpring { mirrored(&points) } else { points }
    }

    /// The greatest difference of a table from the curve, measured at some points of each piece.
    pub(super) fn within(&self, points: &Points) -> f64 {
        let value = |x: f64| self.curve.of(self.of, x);
        let mut within = 0.0_f64;
        for (a, b) in points.iter().zip(points.iter().skip(1)) {
            for i in 0..=POINTS {
                let part = i as f64 / POINTS as f64;
                let x = a.0 + part * (b.0 - a.0);
                within = within.max((value(x) - (a.1 + part * (b.1 - a.1))).abs());
            }
        }
        within
    }

    /// A bound of the difference of a table from the curve, and whether it is proved: it is the greatest one at some points of each piece
    /// otherwise.
    pub(super) fn error(&self, points: &Points) -> (f64, bool) {
        let seen = self.within(points);
        self.bound(points, CLOSE * seen).map_or((seen, false), |bound| (bound.max(seen), true))
    }

    /// A bound of the difference of a table from the curve, by enclosures over intervals that are halved until it is `enough`.
    fn bound(&self, points: &Points, enough: f64) -> Option<f64> {
        let pairs = points.iter().zip(points.iter().skip(1));
        // An odd spring is mirrored.
        let own = pairs.filter(|(a, _)| self.of != Of::OddSpring || a.0 >= 0.0);
        let mut bound = 0.0_f64;
        for (a, b) in own {
            let slope = Interval::point(b.1)
                .minus(Interval::point(a.1))
                .over(Interval::point(b.0).minus(Interval::point(a.0)));
            let line = |x: Interval| Interval::point(a.1).plus(slope.times(x.minus(Interval::point(a.0))));
            let off =
                |x: f64| self.curve.jet(Interval::point(x)).value.minus(line(Interval::point(x))).size();
            let mut left = vec![((a.0, off(a.0)), (b.0, off(b.0)), DEEPEST)];
            let mut count = 0_usize;
            while let Some((from, to, deep)) = left.pop() {
                count = count.saturating_add(1);
                let x = Interval::new(from.0, to.0);
                let (jet, length) = (self.curve.jet(x), (to.0 - from.0).next_up());
                // By f″, by f′ and by f alone.
                let by_second = from.1.max(to.1) + length * length / 8.0 * jet.second.size();
                let by_first = f64::midpoint(from.1, to.1) + length / 2.0 * jet.first.minus(slope).size();
                let alone = jet.value.minus(line(x)).size();
                let here = by_second.min(by_first).min(alone);
                // Three sums, whose roundings are less than this.
                let here = here * (1.0 + 8.0 * f64::EPSILON);
                if here <= enough.max(bound) || deep == 0 || count > ENCLOSURES {
                    bound = bound.max(here);
                } else {
                    let x = f64::midpoint(from.0, to.0);
                    let (middle, deep) = ((x, off(x)), deep.saturating_sub(1));
                    left.extend([(from, middle, deep), (middle, to, deep)]);
                }
            }
            if !bound.is_finite() {
                return None;
            }
        }
        Some(bound)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn formula(text: &str, variable: &'static str) -> Curve {
        Curve::Formula(Formula::new(text, variable).unwrap())
    }

    fn straight(points: &[(f64, f64)], x: f64) -> f64 {
        let place = points.partition_point(|p| p.0 <= x).clamp(1, points.len() - 1);
        let (a, b) = (points[place - 1], points[place]);
        a.1 + (b.1 - a.1) * (x - a.0) / (b.0 - a.0)
    }

    /// Within the force on a mesh of its own, with the knots of `5 + v + 10 exp(−2v)` at equal parts of `∫√f″ = √40 (1 − e^(−v))` and a
    /// fifth of it even.
    #[test]
    fn tables_are_within_their_force_with_knots_by_curvature() {
        let curve = formula("5 + v + 10*exp(-2*v)", "v");
        for tolerance in [1e-1, 1e-3, 1e-5] {
            let mesh = Mesh::new(&curve, Of::Friction, 3.0, tolerance).unwrap();
            let count = mesh.pieces(tolerance).unwrap();
            let table = mesh.table(count);
            let total = 40.0_f64.sqrt() * (1.0 - (-3.0_f64).exp());
            let due = 1.2 * total / (16.0 * tolerance).sqrt();
            assert!((count as f64) < 1.25 * due + 3.0 && (count as f64) > due, "{tolerance}: {count} {due}");
            let fine = mesh.table(2 * count);
            for (table, most) in [(&table, tolerance), (&fine, 0.3 * tolerance)] {
                let within = mesh.within(table);
                assert!(within <= most, "{tolerance}: {within}");
                for i in 0..10_000 {
                    let v = 3.0 * f64::from(i) / 1e4;
                    let off = (curve.at(v) - straight(table, v)).abs();
                    assert!(off <= 1.01 * within, "{tolerance}: {v} {off}");
                }
                assert_eq!(table[0], (0.0, 15.0));
            }
            for (i, point) in table.iter().enumerate() {
                let part = (40.0_f64.sqrt() * (1.0 - (-point.0).exp()) / total + point.0 / 15.0) / 1.2;
                assert!((part - i as f64 / count as f64).abs() < 1e-3, "{i}: {point:?} {part}");
                assert!((fine[2 * i].0 - point.0).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn springs_of_both_kinds_and_what_is_no_law() {
        let cubic = formula("20*x + 300*x^3", "x");
        let made = |curve: &Curve, of: Of, reach: f64| {
            let mesh = Mesh::new(curve, of, reach, 1e-3).unwrap();
            mesh.table(mesh.pieces(1e-3).unwrap())
        };
        let table = made(&cubic, Of::Spring, 0.5);
        assert!(table.iter().all(|(x, force)| (cubic.at(*x) - force).abs() <= 1e-3));
        let root = formula("sqrt(x) * x", "x");
        let table = made(&root, Of::OddSpring, 2.0);
        let middle = table.len() / 2;
        assert_eq!(table[middle], (0.0, 0.0));
        assert!((straight(&table, -1.0) + 1.0).abs() < 1e-3);
        let why = |text: &str, of: Of, reach: f64| {
            let curve = formula(text, of.variable());
            Mesh::new(&curve, of, reach, 1e-3).and_then(|mesh| mesh.pieces(1e-3)).map(drop).unwrap_err()
        };
        assert!(why("5 - 10*v", Of::Friction, 1.0).contains("must be ≥ 0"));
        assert!(why("1/(v - 0.5)^2", Of::Friction, 1.0).contains("inf at v = 0.5"));
        assert!(why("sqrt(x)", Of::Spring, 1.0).contains("NaN at x = -1"));
        assert!(why("1 + sign(v - 0.3)", Of::Friction, 1.0).contains("must not jump"));
        assert!(why("cos(x)", Of::OddSpring, 1.0).contains("is 1 at x = 0"));
        assert!(why("1e6*v^2", Of::Friction, 1e3).contains("pieces"));
        assert!(why("1 + cos(1e5*v)", Of::Friction, 1.0).contains("allow more"));
    }
}
