//! The verdict on a statement.

use crate::failure::Failure;
use crate::{interrupt, progress};
use serde::Serialize;

/// Whether an equation of the paper holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Standing {
    /// The equation holds at every point.
    Holds,
    /// As printed, the equation does not hold where `docs/errata.md` says so, and the check must show this.
    Refuted,
}

/// A statement, and its result over the points so far.
#[derive(Debug, Serialize)]
pub(super) struct StatementVerdict {
    /// The equation's number.
    pub(super) equation: &'static str,
    /// The statement in words.
    pub(super) statement: &'static str,
    /// Whether the statement must hold or fail.
    pub(super) standing: Standing,
    /// The number of points to which the statement applies.
    pub(super) points: usize,
    /// For a statement that holds: the largest residual, in units of the last place of its terms, or of the
    /// square root of this unit for a difference quotient. For one that is refuted: the smallest residual,
    /// relative to its terms.
    pub(super) worst_residual: f64,
    /// The point of the worst residual.
    #[serde(flatten)]
    pub(super) worst: Place,
    /// Whether the statement holds within the rounding of its terms, or is refuted by more than that
    /// rounding, at every point, of which there is one or more.
    pub(super) passed: bool,
}

/// The ratios at a point, with all digits.
#[derive(Debug, Default, Serialize)]
pub(super) struct Place {
    #[serde(rename = "worst_omega")]
    pub(super) omega: Option<String>,
    #[serde(rename = "worst_alpha")]
    pub(super) alpha: Option<String>,
    /// Only for identities with damping.
    #[serde(rename = "worst_damping_ratio", skip_serializing_if = "Option::is_none")]
    pub(super) damping_ratio: Option<String>,
}

/// The residual of a statement at a point.
#[derive(Clone, Copy)]
pub(super) struct Residue {
    /// Its size, or a bound of it, in units in the last place of the terms.
    pub(super) units: f64,
    /// Its size, or a lower bound of it, relative to the terms.
    pub(super) least: f64,
    /// Whether it is zero but for rounding, and whether it is certainly not. A residual that is unknown is neither.
    pub(super) is_zero: bool,
    pub(super) is_off: bool,
}

impl StatementVerdict {
    /// The verdict before the first point.
    pub(super) fn of(equation: &'static str, statement: &'static str, standing: Standing) -> Self {
        let worst = Place::default();
        Self { equation, statement, standing, points: 0, worst_residual: 0.0, worst, passed: false }
    }

    pub(super) fn add(&mut self, residue: Residue, place: impl FnOnce() -> Place) {
        let (passes, size, is_worse) = match self.standing {
            Standing::Holds => (residue.is_zero, residue.units, residue.units > self.worst_residual),
            Standing::Refuted => (residue.is_off, residue.least, residue.least < self.worst_residual),
        };
        // For either kind, a residual of NaN is the worst of all.
        if self.points == 0 || !self.worst_residual.is_nan() && (is_worse || size.is_nan()) {
            (self.worst_residual, self.worst) = (size, place());
        }
        self.passed = passes && (self.passed || self.points == 0);
        self.points += 1;
    }
}

/// The verdicts after all points, by their residuals at each, with a progress bar.
pub(super) fn verdicts<P>(
    mut verdicts: Vec<StatementVerdict>,
    points: &[P],
    residues: impl Fn(&P) -> Vec<Option<Residue>>,
    written: impl Fn(&P) -> Place,
) -> Result<Vec<StatementVerdict>, Failure> {
    let bar = progress::bar(points.len() as u64, "points");
    for point in points {
        interrupt::check()?;
        for (verdict, residue) in verdicts.iter_mut().zip(residues(point)) {
            residue.into_iter().for_each(|residue| verdict.add(residue, || written(point)));
        }
        bar.inc(1);
    }
    interrupt::check()?;
    bar.finish_and_clear();
    Ok(verdicts)
}
