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

#[cfg(feature = "mp")]
mod balls;
mod case;
mod plain;
mod points;
mod statements;

use crate::args::{Format, VerifyArgs};
use crate::bits::{Value, at_bits};
use crate::enclose;
use crate::failure::{Failure, Outcome};
use crate::interrupt;
use crate::progress;
use serde::Serialize;
use statements::Standing;
use std::io::{self, Write};
use std::ops::ControlFlow;

/// The result of a statement over all points.
#[derive(Debug, Clone, PartialEq)]
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
    worst: f64,
    /// Ω and α at the point of the worst residual, with all digits.
    at: Option<(String, String)>,
    /// The damping ratio ζ at the point of the worst residual, if there is a damper.
    damping_ratio: Option<String>,
    /// Whether the statement holds within the rounding of its terms, or is refuted by more than that
    /// rounding.
    passed: bool,
}

pub(crate) fn run(args: &VerifyArgs, out: &mut impl Write) -> Outcome {
    if args.enclose {
        return enclosed(args, out);
    }
    at_bits!(args.bits, check(args: &VerifyArgs, out))
}

/// `verify --enclose`: the statements in balls.
#[cfg(feature = "mp")]
fn enclosed(args: &VerifyArgs, out: &mut impl Write) -> Outcome {
    let bits = args.bits.unwrap_or(enclose::BITS);
    let verdicts = watched(|step| balls::verdicts(bits, step))?;
    answer(&verdicts, Residuals { bits, are_balls: true }, args, out)
}

#[cfg(not(feature = "mp"))]
fn enclosed(_: &VerifyArgs, _: &mut impl Write) -> Outcome {
    Err(enclose::no_balls())
}

/// The kind of the residuals.
#[derive(Clone, Copy)]
struct Residuals {
    bits: u32,
    /// Whether they are balls that contain the residuals, and not the residuals themselves.
    are_balls: bool,
}

fn check<F: Value>(args: &VerifyArgs, out: &mut impl Write) -> Outcome {
    let verdicts = watched(|step| Ok(plain::verdicts::<F, Failure>(step)))?;
    answer(&verdicts, Residuals { bits: F::PRECISION, are_balls: false }, args, out)
}

/// The verdicts, with a progress bar, unless interrupted.
fn watched(
    verify: impl FnOnce(
        &mut dyn FnMut(usize, usize) -> ControlFlow<Failure>,
    ) -> Result<ControlFlow<Failure, Vec<StatementVerdict>>, Failure>,
) -> Result<Vec<StatementVerdict>, Failure> {
    interrupt::listen();
    let bar = progress::bar(0, "points");
    let found = verify(&mut |done, all| {
        bar.set_length(all as u64);
        bar.set_position(done as u64);
        match interrupt::check() {
            Ok(()) => ControlFlow::Continue(()),
            Err(failure) => ControlFlow::Break(failure),
        }
    })?;
    match found {
        ControlFlow::Continue(verdicts) => {
            bar.finish_and_clear();
            Ok(verdicts)
        }
        ControlFlow::Break(failure) => Err(failure),
    }
}

/// Writes the verdicts; a failure if one of them is not as required.
fn answer(
    verdicts: &[StatementVerdict],
    residuals: Residuals,
    args: &VerifyArgs,
    out: &mut impl Write,
) -> Outcome {
    match args.format {
        Format::Json => json(verdicts, residuals, out)?,
        Format::Text => text(verdicts, residuals, out)?,
        Format::Jsonl | Format::Csv => {
            return Err(Failure::Input("--format: the answer to verify is text or json".to_owned()));
        }
    }
    out.flush()?;
    conclusion(verdicts)
}

/// A failure if an identity does not hold, or is not refuted, as required.
fn conclusion(verdicts: &[StatementVerdict]) -> Outcome {
    match verdicts.iter().filter(|v| !v.passed).count() {
        0 => Ok(()),
        failed => Err(Failure::Verdict(format!("{failed} of {} identities failed", verdicts.len()))),
    }
}

fn text(verdicts: &[StatementVerdict], residuals: Residuals, out: &mut impl Write) -> io::Result<()> {
    let wide = |s: &str, width: usize| format!("{s}{}", " ".repeat(width.saturating_sub(s.chars().count())));
    let widest = |text: fn(&StatementVerdict) -> &str| {
        verdicts.iter().map(|v| text(v).chars().count()).max().unwrap_or(0)
    };
    let (first, second) = (widest(|v| v.equation).max(3), widest(|v| v.statement).max(8));
    let what = if residuals.are_balls {
        "how far the ball of a residual reaches from 0, in units of the last place of the terms"
    } else {
        "residuals in units of the last place of the terms, or of its square root for differences"
    };
    writeln!(out, "{} bits, {what}\n", residuals.bits)?;
    writeln!(out, "{}  {}  points  worst      ", wide("eq.", first), wide("identity", second))?;
    for v in verdicts {
        let verdict = match (v.standing, v.passed) {
            (Standing::Holds, true) => "holds",
            (Standing::Holds, false) => "FAILS",
            (Standing::Refuted, true) => "refuted",
            (Standing::Refuted, false) => "NOT REFUTED",
        };
        let worst = match v.standing {
            Standing::Holds => format!("{:.3e}", v.worst),
            Standing::Refuted => format!("{:.1e} rel.", v.worst),
        };
        let (equation, statement) = (wide(v.equation, first), wide(v.statement, second));
        writeln!(out, "{equation}  {statement}  {:>6}  {worst:<12} {verdict}", v.points)?;
        if let (false, Some((omega, alpha))) = (v.passed, &v.at) {
            let damper = v.damping_ratio.as_ref().map_or_else(String::new, |zeta| format!(", ζ = {zeta}"));
            writeln!(out, "         at Ω = {omega}, α = {alpha}{damper}")?;
        }
    }
    let passed = verdicts.iter().filter(|v| v.passed).count();
    writeln!(out, "\n{passed} of {} identities as expected", verdicts.len())?;
    if residuals.are_balls {
        writeln!(
            out,
            "The ball of an identity that holds contains 0 at every point, rounding included. That of a refuted one\n\
             contains 0 at none."
        )?;
    }
    Ok(())
}

#[derive(Serialize)]
struct Report<'a> {
    bits: u32,
    /// Whether `worst_residual` is a bound from a ball.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    enclosed: bool,
    passed: bool,
    identities: Vec<VerdictRecord<'a>>,
}

#[derive(Serialize)]
struct VerdictRecord<'a> {
    equation: &'a str,
    statement: &'a str,
    standing: &'a str,
    points: usize,
    /// In units in the last place (for differences: of its square root) where the identity holds, and
    /// relative to the terms where it is refuted.
    worst_residual: f64,
    worst_omega: Option<&'a str>,
    worst_alpha: Option<&'a str>,
    /// Only for identities with damping.
    #[serde(skip_serializing_if = "Option::is_none")]
    worst_damping_ratio: Option<&'a str>,
    passed: bool,
}

impl<'a> From<&'a StatementVerdict> for VerdictRecord<'a> {
    fn from(v: &'a StatementVerdict) -> Self {
        Self {
            equation: v.equation,
            statement: v.statement,
            standing: match v.standing {
                Standing::Holds => "holds",
                Standing::Refuted => "refuted",
            },
            points: v.points,
            worst_residual: v.worst,
            worst_omega: v.at.as_ref().map(|(omega, _)| omega.as_str()),
            worst_alpha: v.at.as_ref().map(|(_, alpha)| alpha.as_str()),
            worst_damping_ratio: v.damping_ratio.as_deref(),
            passed: v.passed,
        }
    }
}

fn json(verdicts: &[StatementVerdict], residuals: Residuals, out: &mut impl Write) -> Outcome {
    let report = Report {
        bits: residuals.bits,
        enclosed: residuals.are_balls,
        passed: verdicts.iter().all(|v| v.passed),
        identities: verdicts.iter().map(VerdictRecord::from).collect(),
    };
    serde_json::to_writer_pretty(&mut *out, &report)?;
    Ok(out.write_all(b"\n")?)
}

#[cfg(test)]
mod tests {
    use super::{Residuals, conclusion, text};
    use super::{Standing, StatementVerdict};
    use crate::failure::Failure;

    #[test]
    fn one_failure_is_enough_and_says_where() {
        let verdict = |passed| StatementVerdict {
            equation: "36",
            statement: "ρ² = 2B²/(1 + cos π₁) − X²",
            standing: Standing::Holds,
            points: 3,
            worst: 1e9,
            at: Some(("0.7".into(), "2".into())),
            damping_ratio: Some("0.05".into()),
            passed,
        };
        assert!(conclusion(&[verdict(true), verdict(true)]).is_ok());
        let verdicts = [verdict(true), verdict(false)];
        assert!(matches!(conclusion(&verdicts), Err(Failure::Verdict(text)) if text.starts_with("1 of 2")));
        let mut table = Vec::new();
        text(&verdicts, Residuals { bits: 53, are_balls: false }, &mut table).unwrap();
        let table = String::from_utf8(table).unwrap();
        assert!(table.contains("FAILS") && table.contains("at Ω = 0.7, α = 2, ζ = 0.05"), "{table}");
    }
}
