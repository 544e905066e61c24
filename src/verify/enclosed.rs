//! The identities in ball arithmetic: the ball of each residual must contain 0 and be as small as the
//! requested number of bits implies.
//!
//! In plain arithmetic, a residual is rounding or looks like it. The ball of a residual contains the exact
//! residual of the identity. A ball without 0 refutes the identity at that point; a ball with 0 bounds any
//! possible error by its size. The exact motion is represented here by a motion that is proved to exist
//! ([`crate::enclosed::steady`]).
//!
//! | file | content |
//! |---|---|
//! | `point` | the points, and the answers there in balls |
//! | `answered` | the answers of the closed forms about a motion |
//! | `claims` | further statements, on the border and as printed |
//! | `damped` | points with damping, and the statements there |
//! | `proved` | comparison with motions that are proved to exist |

mod answered;
mod claims;
mod damped;
#[cfg(test)]
mod mutants;
mod point;
mod proved;
#[cfg(test)]
mod tests;

use super::formulae::{Formulae, Library};
use super::terms::Terms;
use super::{Standing, Verdict, cycle, matching};
use crate::error::{Error, Quantity};
use crate::float::ball::{Ball, Radius};
use crate::float::mp::Mp;
use crate::ratios::within;
use claims::Here;
use core::ops::ControlFlow;
use point::{Found, Place, places};

/// The greatest number of bits: near the poles, the computation uses more bits than requested.
const MOST: u32 = 4096;

/// An identity over balls.
struct Row<const W: usize> {
    equation: &'static str,
    statement: &'static str,
    standing: Standing,
    residual: Residual<W>,
}

enum Residual<const W: usize> {
    /// A residual of the closed forms.
    OfTerms(fn(&Terms<'_, Ball<W>>) -> Option<Ball<W>>),
    /// A residual that also needs the border or the printed equations.
    OfPoint(fn(&Here<'_, W>) -> Option<Ball<W>>),
}

/// The residual of an identity at a point, relative to its terms.
#[derive(Debug, Clone, Copy)]
struct Residue {
    /// An upper bound of its magnitude.
    most: Radius,
    /// A lower bound of its magnitude.
    least: Radius,
    has_zero: bool,
}

impl Residue {
    fn of<const W: usize>(residual: Ball<W>, scale: Ball<W>) -> Self {
        let relative = residual / scale;
        if relative.is_entire() {
            return Self { most: Radius::INFINITE, least: Radius::ZERO, has_zero: true };
        }
        let (mid, rad) = (relative.mid(), relative.rad());
        Self {
            most: Radius::above(mid).plus(rad),
            least: Radius::below(mid).minus_down(rad),
            has_zero: relative.contains_zero(),
        }
    }

    /// Whether it is below one unit in the last of `bits` bits.
    fn is_small(&self, bits: u32) -> bool {
        !self.most.is_infinite() && self.most.scaled(i64::from(bits)) <= Radius::ONE
    }
}

/// All identities over balls: those of plain arithmetic, those on the border, and the equations that are
/// wrong as printed.
fn rows<const W: usize>() -> Vec<Row<W>> {
    let same = matching::identities().into_iter().chain(cycle::identities());
    let same = same.map(|claim| Row {
        equation: claim.equation,
        statement: claim.statement,
        standing: Standing::Holds,
        residual: Residual::OfTerms(claim.residual),
    });
    same.chain(claims::rows()).collect()
}

/// The residuals of all identities at a point; `None` where this precision does not find the answers.
fn residues<const W: usize>(
    place: &Place,
    formulae: &dyn Formulae<Ball<W>>,
    alter: impl Fn(Found<W>) -> Found<W>,
) -> Option<Vec<Option<Residue>>> {
    let found = alter(Found::at(place)?);
    let terms = Terms::new(formulae, found.point, found.answers);
    let here = Here { terms: &terms, edge: &found.edge };
    let residual = |row: &Row<W>| match row.residual {
        Residual::OfTerms(residual) => residual(&terms),
        Residual::OfPoint(residual) => residual(&here),
    };
    Some(rows::<W>().iter().map(|row| residual(row).map(|r| Residue::of(r, terms.scale))).collect())
}

/// The residuals with the library's own formulae and answers.
fn left<const W: usize>(place: &Place) -> Option<Vec<Option<Residue>>> {
    if place.is_damped() {
        damped::residues::<W>(place, |found| found)
    } else {
        residues::<W>(place, &Library, |found| found)
    }
}

/// The same, with as many bits as needed to bring the residuals to one unit in the last of `bits`.
fn sharp_residues(place: &Place, bits: u32) -> Vec<Option<Residue>> {
    let mut last = Vec::new();
    macro_rules! at {
        ($($width:literal)*) => {$(
            if Mp::<$width>::BITS >= bits + 64
                && let Some(found) = left::<$width>(place)
            {
                // A residual that excludes 0 needs no more bits.
                let is_sharp = |residue: &Residue| residue.is_small(bits) || !residue.has_zero;
                if found.iter().flatten().all(is_sharp) {
                    return found;
                }
                last = found;
            }
        )*};
    }
    at!(2 5 17 65 129);
    last
}

/// The worst residual of an identity so far.
struct Tally {
    points: usize,
    worst: Option<(Residue, usize)>,
    all_pass: bool,
}

impl Tally {
    fn add(&mut self, residue: Residue, at: usize, standing: Standing, bits: u32) {
        self.points = self.points.saturating_add(1);
        let (passes, is_worse) = match standing {
            Standing::Holds => (
                residue.has_zero && residue.is_small(bits),
                self.worst.as_ref().is_none_or(|(worst, _)| residue.most > worst.most),
            ),
            Standing::Refuted => {
                (!residue.has_zero, self.worst.as_ref().is_none_or(|(worst, _)| residue.least < worst.least))
            }
        };
        self.all_pass &= passes;
        if is_worse {
            self.worst = Some((residue, at));
        }
    }
}

/// An equation's number, a statement, and whether it must hold.
type Statement = (&'static str, &'static str, Standing);

/// Checks every identity among closed forms, and those of the exact motion, at a set of points in ball
/// arithmetic.
///
/// A statement passes if, at every point, its ball contains 0 and lies within one unit in the last of `bits`
/// bits of the identity's terms; [`Verdict::worst`] is the greatest distance from 0 in those units. A
/// statement that is wrong as printed passes if every ball excludes 0; `worst` is then the least certain
/// relative residual. Points and `step` are those of [`super::verify`].
///
/// # Errors
/// Where `bits` is not in [1, 4096].
pub fn verify_enclosed<B>(
    bits: u32,
    mut step: impl FnMut(usize, usize) -> ControlFlow<B>,
) -> Result<ControlFlow<B, Vec<Verdict>>, Error> {
    within(Quantity::Precision, f64::from(bits), 1.0, f64::from(MOST))?;
    let (plain, with_damping) = (places(), damped::places());
    let all = plain.len().saturating_add(with_damping.len());
    let of_forms: Vec<_> =
        rows::<2>().iter().map(|row| (row.equation, row.statement, row.standing)).collect();
    let of_damped: Vec<_> = damped::claims::<2>()
        .iter()
        .map(|claim| (claim.equation, claim.statement, Standing::Holds))
        .collect();
    let verdicts = verdicts(&plain, &of_forms, &proved::ROWS, bits, |done| step(done, all));
    let mut verdicts = match verdicts {
        ControlFlow::Continue(verdicts) => verdicts,
        ended @ ControlFlow::Break(_) => return Ok(ended),
    };
    let more = self::verdicts(&with_damping, &of_damped, &proved::DAMPED, bits, |done| {
        step(plain.len().saturating_add(done), all)
    });
    Ok(more.map_continue(|more| {
        verdicts.extend(more);
        verdicts
    }))
}

/// The verdicts on the statements about closed forms and motions at these points; `step` receives the number
/// done.
fn verdicts<B>(
    places: &[Place],
    of_forms: &[Statement],
    of_motions: &[(&'static str, &'static str)],
    bits: u32,
    mut step: impl FnMut(usize) -> ControlFlow<B>,
) -> ControlFlow<B, Vec<Verdict>> {
    let holding = of_motions.iter().map(|&(equation, statement)| (equation, statement, Standing::Holds));
    let statements: Vec<Statement> = of_forms.iter().copied().chain(holding).collect();
    let mut tallies: Vec<_> =
        statements.iter().map(|_| Tally { points: 0, worst: None, all_pass: true }).collect();
    for (number, place) in places.iter().enumerate() {
        step(number)?;
        let mut found = sharp_residues(place, bits);
        // Answers that no precision finds are undecided.
        found.resize(
            of_forms.len(),
            Some(Residue { most: Radius::INFINITE, least: Radius::ZERO, has_zero: true }),
        );
        found.extend(proved::residues(place, bits));
        for ((tally, residue), (_, _, standing)) in tallies.iter_mut().zip(found).zip(&statements) {
            if let Some(residue) = residue {
                tally.add(residue, number, *standing, bits);
            }
        }
    }
    step(places.len())?;
    let verdicts = statements.into_iter().zip(tallies).map(|((equation, statement, standing), tally)| {
        let worst = tally.worst.map_or(0.0, |(residue, _)| match standing {
            Standing::Holds => residue.most.scaled(i64::from(bits)).value::<1>().to_f64(),
            Standing::Refuted => residue.least.value::<1>().to_f64(),
        });
        let at = tally.worst.and_then(|(_, at)| places.get(at));
        Verdict {
            equation,
            statement,
            standing,
            points: tally.points,
            worst,
            at: at.map(Place::written),
            damping_ratio: at.and_then(Place::written_damping),
            passed: tally.all_pass && tally.points > 0,
        }
    });
    ControlFlow::Continue(verdicts.collect())
}
