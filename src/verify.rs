//! The equations of the paper, held against the cycles this crate computes, at the precision of the type.
//!
//! [`verify`] evaluates every identity at a spread of points and reports the worst residual of each in units of
//! the last place of its terms. A true identity leaves the rounding of its operations; a false one misses by
//! some `2^PRECISION` units. What is wrong as printed is there too, and has to fail.
//!
//! ```
//! let verdicts = stickslip::verify::verify::<f64>(|_, _| ());
//! assert!(verdicts.iter().all(|v| v.passed));
//! ```

mod cycle;
mod matching;
mod points;
mod printed;

use crate::float::Float;
use crate::nonsticking::den_hartog::FallingHalf;
use crate::nonsticking::matching::{Given, Unknowns};
use crate::nonsticking::{Border, Cycle};
use crate::phase_function::{PhaseFunction, one_minus_square};

/// Units in the last place of its largest term that rounding may leave of a true identity.
///
/// Measured: at most 32, at 53 to 4096 bits.
pub const TOLERANCE: f64 = 128.0;

/// How an equation of the paper stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Standing {
    /// It holds at every point.
    Holds,
    /// As printed it does not hold where the [errata] say so, and must be seen to fail there.
    ///
    /// [errata]: crate::nonsticking::printed
    Refuted,
}

/// One identity: which, and what is left of it in a case.
#[derive(Debug, Clone, Copy)]
pub struct Identity<F> {
    /// The equation's number, with a letter where one has parts.
    pub equation: &'static str,
    /// What it says.
    pub statement: &'static str,
    /// Whether it is to hold or to fail.
    pub standing: Standing,
    residual: fn(&Case<F>) -> Option<F>,
}

impl<F: Float> Identity<F> {
    /// Left less right side against the size of the terms; `None` where the identity does not apply.
    pub fn relative_residual(&self, case: &Case<F>) -> Option<F> {
        (self.residual)(case).map(|r| r.abs() / case.scale)
    }
}

/// A cycle with all that the identities ask of it.
#[derive(Debug, Clone, Copy)]
pub struct Case<F> {
    cycle: Cycle<F>,
    phase_function: PhaseFunction<F>,
    given: Given<F>,
    unknowns: Unknowns<F>,
    half: FallingHalf<F>,
    one_minus_square: F,
    scale: F,
}

impl<F: Float> Case<F> {
    /// The case of a cycle.
    pub fn new(cycle: Cycle<F>) -> Self {
        let omega = cycle.ratios().omega();
        let phase_function = PhaseFunction::of_valid(omega);
        let given = cycle.given();
        // The amplitudes: of the drive, of friction, of the motion, and of what swings freely, |T| being that of ρ and X.
        let scale =
            F::int(1) + given.amplitude.abs() + cycle.max_displacement() + phase_function.tangent().abs();
        Self {
            cycle,
            phase_function,
            given,
            unknowns: cycle.unknowns(),
            half: cycle.den_hartog(),
            one_minus_square: one_minus_square(omega),
            scale,
        }
    }

    /// Ω.
    fn omega(&self) -> F {
        self.given.omega
    }

    /// α.
    fn alpha(&self) -> F {
        self.cycle.ratios().alpha()
    }

    /// sgn(1 − Ω).
    fn sign(&self) -> F {
        F::int(1).with_sign_of(F::int(1) - self.omega())
    }

    /// The residual of an identity that holds 1 + cos π₁ as the paper writes it: beside Ω = 1/(2n+1) the sum keeps
    /// no more than the digits of 1/T², so that its terms count as larger by |T|.
    fn near_pole(&self, residual: F) -> F {
        residual / self.scale
    }

    /// `1 + cos π₁ = 2 cos² β`, without cancellation.
    fn one_plus_cos(&self) -> F {
        F::int(2) * self.phase_function.sin_cos().1.square()
    }
}

/// What came of an identity over all points.
#[derive(Debug, Clone, PartialEq)]
pub struct Verdict {
    /// The equation's number.
    pub equation: &'static str,
    /// What it says.
    pub statement: &'static str,
    /// Whether it is to hold or to fail.
    pub standing: Standing,
    /// The number of points where it applies.
    pub points: usize,
    /// Of an identity that holds, the largest residual in units of the last place of its terms; of one that is
    /// refuted, the smallest, relative to its terms.
    pub worst: f64,
    /// Ω and α where that is, with all digits.
    pub at: Option<(String, String)>,
    /// Holds within [`TOLERANCE`], or is refuted by more than that.
    pub passed: bool,
}

/// Every identity there is.
pub fn identities<F: Float>() -> Vec<Identity<F>> {
    [matching::identities(), cycle::identities(), printed::identities()].concat()
}

/// Holds every identity against the cycles at a spread of points; `progress` is told (done, all) points.
///
/// The points lie on both sides of Ω = 1, in the bands between 1/5, 1/4, 1/3, 1/2, and beside Ω = 1, 1/3, 1/5 and 1/7
/// at distances down to 10⁻³⁰ where the precision is at least twice as fine; α is 1.01, 1.5 and 4 times the exact border.
pub fn verify<F: Float>(mut progress: impl FnMut(usize, usize)) -> Vec<Verdict> {
    let identities = identities::<F>();
    let mut tallies = vec![Tally { points: 0, worst: None }; identities.len()];
    let cycles = points::cycles::<F>();
    for (done, cycle) in cycles.iter().enumerate() {
        let case = Case::new(*cycle);
        for (identity, tally) in identities.iter().zip(&mut tallies) {
            if let Some(residual) = identity.relative_residual(&case) {
                tally.add(identity.standing, residual, cycle);
            }
        }
        progress(done.saturating_add(1), cycles.len());
    }
    identities.iter().zip(tallies).map(|(identity, tally)| tally.verdict(identity)).collect()
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
        // A residual that is not a number is the worst of all, of either kind.
        let worse = self.worst.as_ref().is_none_or(|(worst, _)| match standing {
            Standing::Holds => residual > *worst || is_nan(residual),
            Standing::Refuted => residual < *worst || is_nan(residual),
        });
        if worse {
            self.worst = Some((residual, *cycle));
        }
    }

    fn verdict(self, identity: &Identity<F>) -> Verdict {
        let (residual, at) = match self.worst {
            Some((residual, cycle)) => {
                let ratios = cycle.ratios();
                (residual, Some((ratios.omega().to_string(), ratios.alpha().to_string())))
            }
            None => (F::int(0), None),
        };
        let in_last_places = (residual / F::epsilon()).to_f64();
        let (worst, passed) = match identity.standing {
            Standing::Holds => (in_last_places, in_last_places <= TOLERANCE),
            Standing::Refuted => (residual.to_f64(), in_last_places > TOLERANCE),
        };
        Verdict {
            equation: identity.equation,
            statement: identity.statement,
            standing: identity.standing,
            points: self.points,
            worst,
            at,
            passed: passed && self.points > 0,
        }
    }
}

fn is_nan<F: Float>(x: F) -> bool {
    x.partial_cmp(&x).is_none()
}

/// The cycle at α `times` the exact border, where there is one.
fn above_border<F: Float>(omega: F, times: F) -> Option<Cycle<F>> {
    let least = Border::new(omega).ok()?.min_force_ratio();
    crate::Ratios::new(omega, least * times).and_then(Cycle::new).ok()
}

#[cfg(test)]
mod tests {
    use super::{Case, Identity, Standing, Tally, above_border, verify};

    #[test]
    fn all_hold_and_the_misprints_fail() {
        for v in verify::<f64>(|_, _| ()) {
            assert!(v.passed, "{}: {} at {:?}", v.equation, v.worst, v.at);
            assert!(v.points >= 3, "{}: {} points", v.equation, v.points);
        }
    }

    #[test]
    fn a_wrong_sign_is_caught() {
        // Eq. 31 with a plus sign, in eq. 29.
        let wrong: Identity<f64> = Identity {
            equation: "29",
            statement: "b with the wrong sign",
            standing: Standing::Holds,
            residual: |c: &Case<f64>| {
                let (s, cosine) = c.given.lag(&c.unknowns).sin_cos();
                let (a, b) = (c.given.coefficient_a(&c.unknowns), c.given.coefficient_b(&c.unknowns));
                Some(a * s + b * cosine - 2.0)
            },
        };
        let cycle = above_border(0.7, 1.5).unwrap();
        let residual = wrong.relative_residual(&Case::new(cycle)).unwrap();
        assert!(residual > 1e-3);
        // Nothing said of no point passes, nor does a wrong one, or a wrong one among right ones; as a misprint it is refuted.
        let passed = |standing, residuals: &[f64]| {
            let mut tally = Tally { points: 0, worst: None };
            residuals.iter().for_each(|&residual| tally.add(standing, residual, &cycle));
            let verdict = tally.verdict(&Identity { standing, ..wrong });
            assert_eq!(verdict.points, residuals.len());
            verdict.passed
        };
        assert!(!passed(Standing::Holds, &[]) && !passed(Standing::Refuted, &[]));
        assert!(passed(Standing::Holds, &[0.0, 1e-16]) && !passed(Standing::Refuted, &[0.0, 1e-16]));
        assert!(
            !passed(Standing::Holds, &[0.0, residual, 1e-16]) && !passed(Standing::Refuted, &[residual, 0.0])
        );
        assert!(
            !passed(Standing::Holds, &[0.0, f64::NAN, 0.0])
                && !passed(Standing::Refuted, &[1.0, f64::NAN, 1.0])
        );
        assert!(passed(Standing::Refuted, &[residual, 1.0]));
    }

    #[test]
    fn progress_reaches_its_end() {
        let mut last = (0, 0);
        verify::<f32>(|done, all| last = (done, all));
        assert!(last.0 == last.1 && last.1 > 50);
    }
}
