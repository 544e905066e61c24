//! The equations of the paper and the answers of this crate, checked against the motion at the precision of
//! the type.
//!
//! [`verify`] evaluates every identity at a set of points and reports the worst residual of each, in units of
//! the last place of its terms. A true identity leaves the rounding of its operations; a false one is off by
//! about `2^PRECISION` units. Statements that are wrong as printed are included, and must fail.
//!
//! There are three independent references, none of which uses the closed forms:
//!
//! * the equations of the paper themselves, into which the answers are substituted;
//! * the **exact motion** from rest ([`crate::exact`]): its extrema and their phases, its work, its
//!   multipliers, its half-turn map by differences, and its stops on either side of the border;
//! * **Newton's method** on eq. 21–25 ([`Solvable`]), at the same points and on the border.
//!
//! The cycle with viscous damping is checked against the same three (`damped`).
//!
//! ```
//! use core::ops::ControlFlow;
//! use stickslip::verify::verify;
//! let ControlFlow::Continue(verdicts) = verify::<f64, ()>(|_, _| ControlFlow::Continue(())) else { panic!() };
//! assert!(verdicts.iter().all(|v| v.passed));
//! ```

mod case;
mod cycle;
mod damped;
mod edge;
#[cfg(feature = "mp")]
#[cfg_attr(
    not(test),
    allow(
        clippy::arithmetic_side_effects,
        reason = "operators of balls, of rational numbers and of bits up to 4096"
    )
)]
mod enclosed;
mod followed;
mod formulae;
mod matching;
mod motion;
#[cfg(test)]
mod mutants;
mod on_border;
mod points;
mod printed;
mod solved;
mod terms;

use crate::float::Float;
use crate::nonsticking::Solvable;
use crate::nonsticking::{Border, Cycle};
use crate::ratios::Ratios;
pub(crate) use case::Case;
use core::ops::ControlFlow;
#[cfg(feature = "mp")]
pub use enclosed::verify_enclosed;
use formulae::{Formulae, Library};
use terms::{Claim, Terms};

/// The greatest residual that rounding may leave of a true identity, in units of the last place of its
/// largest term.
///
/// Measured residuals are below 64, at 53 to 4096 bits.
pub(crate) const TOLERANCE: f64 = 128.0;

/// Whether an equation of the paper holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum Standing {
    /// It holds at every point.
    Holds,
    /// As printed it does not hold where `docs/errata.md` says so, and the check must show that.
    Refuted,
}

/// The share of the type's digits to which an identity holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Digits {
    All,
    /// A difference quotient keeps half of them. Its residual is in units of the square root of the last
    /// place.
    Half,
}

/// One identity and its residual in a case.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Identity<F> {
    /// The equation's number, with a letter where the equation has parts.
    pub(crate) equation: &'static str,
    /// The statement in words.
    pub(crate) statement: &'static str,
    /// Whether it must hold or fail.
    pub(crate) standing: Standing,
    digits: Digits,
    residual: Residual<F>,
}

/// The function that gives the residual, by the data that it needs.
#[derive(Debug, Clone, Copy)]
enum Residual<F> {
    /// It needs only the closed forms, in any arithmetic.
    OfTerms(fn(&Terms<'_, F>) -> Option<F>),
    /// It also needs order, the exact motion or Newton's method.
    OfCase(fn(&Case<'_, F>) -> Option<F>),
}

impl<F> From<Claim<F>> for Identity<F> {
    fn from(Claim { equation, statement, residual }: Claim<F>) -> Self {
        let (standing, residual) = (Standing::Holds, Residual::OfTerms(residual));
        Self { equation, statement, standing, digits: Digits::All, residual }
    }
}

impl<F: Float> Identity<F> {
    /// The left side minus the right side, relative to the terms; `None` where the identity does not apply.
    pub(crate) fn relative_residual(&self, case: &Case<'_, F>) -> Option<F> {
        let unit = match self.digits {
            Digits::All => F::int(1),
            Digits::Half => F::epsilon().sqrt(),
        };
        let residual = match self.residual {
            Residual::OfTerms(residual) => residual(case),
            Residual::OfCase(residual) => residual(case),
        };
        residual.map(|r| r.abs() / case.scale * unit)
    }
}

/// The result of an identity over all points.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Verdict {
    /// The equation's number.
    pub equation: &'static str,
    /// The statement in words.
    pub statement: &'static str,
    /// Whether it must hold or fail.
    pub standing: Standing,
    /// The number of points where it applies.
    pub points: usize,
    /// For an identity that holds: the largest residual, in units of the last place of its terms, or of their
    /// square root for a difference quotient. For one that is refuted: the smallest residual, relative to its
    /// terms.
    pub worst: f64,
    /// Ω and α at that point, with all digits.
    pub at: Option<(String, String)>,
    /// The damping ratio ζ at that point, if there is a damper.
    pub damping_ratio: Option<String>,
    /// Whether it holds within 128 units in the last place of its largest term, or is refuted by more than
    /// that.
    pub passed: bool,
}

/// All identities. Those of the exact motion, of Newton's method and of the border apply only in [`verify`].
pub(crate) fn identities<F: Float>() -> Vec<Identity<F>> {
    let of_terms = matching::identities().into_iter().chain(cycle::identities());
    [
        of_terms.map(Identity::from).collect(),
        cycle::answered(),
        solved::identities(),
        motion::identities(),
        on_border::identities(),
        printed::identities(),
    ]
    .concat()
}

/// Checks every identity for the cycles at a set of points.
///
/// `step` receives the numbers of points (done, all) several times at each point, and may stop the check by
/// [`ControlFlow::Break`].
///
/// The points lie on both sides of Ω = 1, in the bands between 1/5, 1/4, 1/3 and 1/2, and near Ω = 1, 1/3,
/// 1/5 and 1/7 at distances down to 10⁻³⁰ where the precision is at least twice as fine. α is 1.01, 1.5 and 4
/// times the exact border. With damping there are twelve Ω from 0.18 to 4, including 1, and ζ from 0.01 to
/// 1.6, each with one of these α.
pub fn verify<F: Solvable, B>(
    mut step: impl FnMut(usize, usize) -> ControlFlow<B>,
) -> ControlFlow<B, Vec<Verdict>> {
    let undamped = points::points::<F>().len();
    let all = undamped.saturating_add(damped::POINTS);
    let mut verdicts = match verify_by::<F, B>(&Library, |done, _| step(done, all)) {
        ControlFlow::Continue(verdicts) => verdicts,
        ControlFlow::Break(ended) => return ControlFlow::Break(ended),
    };
    let damped = damped::verify_by::<F, B>(&damped::Library, |done| step(undamped.saturating_add(done), all));
    damped.map_continue(|damped| {
        verdicts.extend(damped);
        verdicts
    })
}

/// The same for another set of formulae.
fn verify_by<F: Solvable, B>(
    formulae: &dyn Formulae<F>,
    mut step: impl FnMut(usize, usize) -> ControlFlow<B>,
) -> ControlFlow<B, Vec<Verdict>> {
    let identities = identities::<F>();
    let mut tallies = vec![Tally { points: 0, worst: None }; identities.len()];
    let points = points::points::<F>();
    for (done, point) in points.iter().enumerate() {
        let mut case = Case::by(formulae, point.cycle);
        let motion = Case::<F>::MOTION.iter().filter(|_| point.with_motion);
        for stage in motion.chain(Case::<F>::BORDER.iter().filter(|_| point.with_border)) {
            step(done, points.len())?;
            case = stage(case);
        }
        for (identity, tally) in identities.iter().zip(&mut tallies) {
            if let Some(residual) = identity.relative_residual(&case) {
                tally.add(identity.standing, residual, &point.cycle);
            }
        }
        step(done.saturating_add(1), points.len())?;
    }
    ControlFlow::Continue(
        identities
            .iter()
            .zip(tallies)
            .map(|(identity, tally)| tally.verdict(identity.equation, identity.statement, identity.standing))
            .collect(),
    )
}

/// The worst residual so far.
#[derive(Debug, Clone)]
struct Tally<F> {
    points: usize,
    worst: Option<(F, Cycle<F>)>,
}

impl<F: Float> Tally<F> {
    fn add(&mut self, standing: Standing, residual: F, cycle: &Cycle<F>) {
        self.points = self.points.saturating_add(1);
        // For either kind, a residual of NaN is the worst of all.
        let worse = self.worst.as_ref().is_none_or(|(worst, _)| match standing {
            Standing::Holds => residual > *worst || is_nan(residual),
            Standing::Refuted => residual < *worst || is_nan(residual),
        });
        if worse {
            self.worst = Some((residual, *cycle));
        }
    }

    fn verdict(self, equation: &'static str, statement: &'static str, standing: Standing) -> Verdict {
        let (residual, at) = match self.worst {
            Some((residual, cycle)) => (residual, Some(cycle.ratios)),
            None => (F::int(0), None),
        };
        let damping_ratio = at.filter(Ratios::is_damped).map(|ratios| ratios.damping_ratio().to_string());
        let at = at.map(|ratios| (ratios.omega().to_string(), ratios.alpha().to_string()));
        let in_last_places = (residual / F::epsilon()).to_f64();
        let (worst, passed) = match standing {
            Standing::Holds => (in_last_places, in_last_places <= TOLERANCE),
            Standing::Refuted => (residual.to_f64(), in_last_places > TOLERANCE),
        };
        Verdict {
            equation,
            statement,
            standing,
            points: self.points,
            worst,
            at,
            damping_ratio,
            passed: passed && self.points > 0,
        }
    }
}

fn is_nan<F: Float>(x: F) -> bool {
    x.partial_cmp(&x).is_none()
}

/// The cycle at α `times` the exact border, where it exists.
fn above_border<F: Float>(omega: F, times: F) -> Option<Cycle<F>> {
    let least = Border::new(omega).ok()?.min_force_ratio;
    Ratios::new(omega, least * times).and_then(Cycle::new).ok()
}

#[cfg(test)]
mod tests;
