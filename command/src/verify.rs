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
mod verdict;

use crate::args::VerifyArgs;
use crate::bits::{Value, at_bits};
use crate::enclose;
use crate::failure::{Failure, Outcome};
use crate::output;
use serde::Serialize;
use std::io::{self, Write};
use verdict::{Place, Standing, StatementVerdict};

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
