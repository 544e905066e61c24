//! `stickslip verify`: the equations of the paper and the answers of the library, checked against each other
//! and against the exact motion, at any precision.
//!
//! | file | content |
//! |---|---|
//! | `points` | the points at which the statements are checked |
//! | `case` | the answers at a point, and the terms of the equations |
//! | `statements` | the equations with the answers put in, in any arithmetic |
//! | `plain` | the statements in plain numbers, and the answers against the exact motion |
//! | `balls` | the statements in ball arithmetic, and the answers against motions that are proved to exist |
//!
//! A true statement leaves the rounding of its operations; a false one is off by about `2^PRECISION` units.
//! Statements that are wrong as printed are included, and must fail.

#[cfg(all(feature = "mp", not(test)))]
mod balls;
mod case;
mod plain;
mod points;
mod statements;

use crate::args::VerifyArgs;
use crate::bits::{Value, at_bits};
use crate::enclose;
use crate::failure::{Failure, Outcome};
use crate::interrupt;
use crate::output;
use crate::progress;
use serde::Serialize;
use statements::Standing;
use std::io::{self, Write};

/// A statement, and its result over the points so far.
#[derive(Debug, Serialize)]
struct StatementVerdict {
    /// The equation's number.
    equation: &'static str,
    /// The statement in words.
    statement: &'static str,
    /// Whether the statement must hold or fail.
    standing: Standing,
    /// The number of points to which the statement applies.
    points: usize,
    /// For a statement that holds: the largest residual, in units of the last place of its terms, or of the
    /// square root of this unit for a difference quotient. For one that is refuted: the smallest residual,
    /// relative to its terms.
    worst_residual: f64,
    /// The point of the worst residual.
    #[serde(flatten)]
    worst: Place,
    /// Whether the statement holds within the rounding of its terms, or is refuted by more than that
    /// rounding, at every point, of which there is one or more.
    passed: bool,
}

/// The ratios at a point, with all digits.
#[derive(Debug, Default, Serialize)]
struct Place {
    #[serde(rename = "worst_omega")]
    omega: Option<String>,
    #[serde(rename = "worst_alpha")]
    alpha: Option<String>,
    /// Only for identities with damping.
    #[serde(rename = "worst_damping_ratio", skip_serializing_if = "Option::is_none")]
    damping_ratio: Option<String>,
}

/// The residual of a statement at a point.
#[derive(Clone, Copy)]
struct Residue {
    /// Its size, or a bound of it, in units in the last place of the terms.
    units: f64,
    /// Its size, or a lower bound of it, relative to the terms.
    least: f64,
    /// Whether it is zero but for rounding, and whether it is certainly not. A residual that is unknown is neither.
    is_zero: bool,
    is_off: bool,
}

impl StatementVerdict {
    /// The verdict before the first point.
    fn of(equation: &'static str, statement: &'static str, standing: Standing) -> Self {
        let worst = Place::default();
        Self { equation, statement, standing, points: 0, worst_residual: 0.0, worst, passed: false }
    }

    fn add(&mut self, residue: Residue, place: impl FnOnce() -> Place) {
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
fn verdicts<P>(
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

pub(crate) fn run(args: &VerifyArgs, out: &mut impl Write) -> Outcome {
    if args.enclose {
        return enclosed(args, out);
    }
    at_bits!(args.bits, check(args: &VerifyArgs, out))
}

/// `verify --enclose`: the statements in balls.
#[cfg(all(feature = "mp", not(test)))]
fn enclosed(args: &VerifyArgs, out: &mut impl Write) -> Outcome {
    let bits = args.bits.unwrap_or(enclose::BITS);
    Report::of(bits, true, balls::verdicts(bits)?).answer(args, out)
}

#[cfg(any(not(feature = "mp"), test))]
fn enclosed(_: &VerifyArgs, _: &mut impl Write) -> Outcome {
    Err(enclose::no_balls())
}

fn check<F: Value>(args: &VerifyArgs, out: &mut impl Write) -> Outcome {
    Report::of(F::precision(), false, plain::verdicts::<F>()?).answer(args, out)
}

#[derive(Serialize)]
struct Report {
    bits: u32,
    /// Whether a residual that holds is a bound from a ball.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    enclosed: bool,
    passed: bool,
    identities: Vec<StatementVerdict>,
}

impl Report {
    fn of(bits: u32, enclosed: bool, identities: Vec<StatementVerdict>) -> Self {
        let passed = identities.iter().all(|verdict| verdict.passed);
        Self { bits, enclosed, passed, identities }
    }

    /// Writes the verdicts; a failure if one of them is not as required.
    fn answer(&self, args: &VerifyArgs, out: &mut impl Write) -> Outcome {
        if args.format.is_json("verify")? {
            output::json(self, out)?
        } else {
            self.text(out)?
        }
        out.flush()?;
        self.conclusion()
    }

    /// A failure if an identity does not hold, or is not refuted, as required.
    fn conclusion(&self) -> Outcome {
        match self.identities.iter().filter(|v| !v.passed).count() {
            0 => Ok(()),
            failed => {
                Err(Failure::Verdict(format!("{failed} of {} identities failed", self.identities.len())))
            }
        }
    }

    fn text(&self, out: &mut impl Write) -> io::Result<()> {
        let verdicts = &self.identities;
        let wide =
            |s: &str, width: usize| format!("{s}{}", " ".repeat(width.saturating_sub(s.chars().count())));
        let widest = |text: fn(&StatementVerdict) -> &str| {
            verdicts.iter().map(|v| text(v).chars().count()).max().unwrap_or(0)
        };
        let (first, second) = (widest(|v| v.equation).max(3), widest(|v| v.statement).max(8));
        let what = if self.enclosed {
            "greatest magnitude in the ball of a residual, in units of the last place of the terms"
        } else {
            "residuals in units of the last place of the terms, or of its square root for differences"
        };
        writeln!(out, "{} bits, {what}\n", self.bits)?;
        writeln!(out, "{}  {}  points  worst      ", wide("eq.", first), wide("identity", second))?;
        for v in verdicts {
            let verdict = match (v.standing, v.passed) {
                (Standing::Holds, true) => "holds",
                (Standing::Holds, false) => "FAILS",
                (Standing::Refuted, true) => "refuted",
                (Standing::Refuted, false) => "NOT REFUTED",
            };
            let worst = match v.standing {
                Standing::Holds => format!("{:.3e}", v.worst_residual),
                Standing::Refuted => format!("{:.1e} rel.", v.worst_residual),
            };
            let (equation, statement) = (wide(v.equation, first), wide(v.statement, second));
            writeln!(out, "{equation}  {statement}  {:>6}  {worst:<12} {verdict}", v.points)?;
            if let (false, Place { omega: Some(omega), alpha: Some(alpha), damping_ratio }) =
                (v.passed, &v.worst)
            {
                let damper = damping_ratio.as_ref().map_or_else(String::new, |zeta| format!(", ζ = {zeta}"));
                writeln!(out, "         at Ω = {omega}, α = {alpha}{damper}")?;
            }
        }
        let passed = verdicts.iter().filter(|v| v.passed).count();
        writeln!(out, "\n{passed} of {} identities as expected", verdicts.len())?;
        if self.enclosed {
            writeln!(
                out,
                "The ball of an identity that holds contains 0 at every point, rounding included. That of a refuted one\n\
             contains 0 at none."
            )?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::{Place, Report, Standing, StatementVerdict};
    use crate::failure::Failure;

    #[test]
    fn one_failure_is_enough_and_says_where() {
        let verdict = |passed| StatementVerdict {
            equation: "36",
            statement: "ρ² = 2B²/(1 + cos π₁) − X²",
            standing: Standing::Holds,
            points: 3,
            worst_residual: 1e9,
            worst: Place {
                omega: Some("0.7".into()),
                alpha: Some("2".into()),
                damping_ratio: Some("0.05".into()),
            },
            passed,
        };
        let report = |second| Report::of(53, false, vec![verdict(true), verdict(second)]);
        assert!(report(true).conclusion().is_ok());
        let report = report(false);
        assert!(matches!(report.conclusion(), Err(Failure::Verdict(text)) if text.starts_with("1 of 2")));
        let mut table = Vec::new();
        report.text(&mut table).unwrap();
        let table = String::from_utf8(table).unwrap();
        assert!(table.contains("FAILS") && table.contains("at Ω = 0.7, α = 2, ζ = 0.05"), "{table}");
    }
}
