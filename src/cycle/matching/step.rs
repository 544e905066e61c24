//! Newton's method on the equations of the matching problem: its steps, its results, and its failures.

use super::Unknowns;
use crate::float::{Field, Float, Real};
use crate::machine::error::{Error, Number, written};
use nalgebra::{DMatrix, DVector, RealField};

/// Why the matching problem has no solution here.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MatchingError {
    /// The frequency ratio is not in its domain.
    #[error(transparent)]
    Input(#[from] Error),
    /// At Ω = 1 no bounded motion has this friction.
    #[error("frequency ratio Ω = 1 must be ≠ 1: there is no cycle to match")]
    Resonance,
    /// The path from the motion without friction ends, at this part of the friction: there is no cycle with
    /// α, or Ω is so far from 1 that f64 cannot follow it.
    #[error("friction = {part:.6} of r_y must reach 1: no cycle found at Ω = {omega}, α = {alpha} beyond it")]
    NoCycle {
        /// Frequency ratio Ω.
        omega: Number,
        /// Force ratio α.
        alpha: Number,
        /// Part of the friction that was reached.
        part: f64,
    },
    /// Newton's method settles on a solution that is no cycle, with a negative Δ₀ or α.
    #[error("{what} = {value} must be > 0: the iteration has left the branch of the cycle")]
    NotACycle {
        /// Δ₀/B or α.
        what: &'static str,
        /// Its value.
        value: Number,
    },
    /// Newton's method does not settle.
    #[error(
        "last Newton step = {step:e} must be rounding only after {iterations} iterations, residual {residual:e}"
    )]
    NoConvergence {
        /// Iterations done.
        iterations: u32,
        /// Size of the last step.
        step: f64,
        /// Largest residual, in units of A.
        residual: f64,
    },
}

/// A solution of eq. 21–25.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Solution<F> {
    /// t₁, t₂, V₀, Δ₀, Δ₁; lengths in units of B. t₂ in `[0, 2π)`, t₁ in the half cycle before it.
    pub unknowns: Unknowns<F>,
    /// |left − right| of eq. 21–25, or with damping of the same conditions, in units of the last place of their
    /// largest term.
    pub residuals: [F; 5],
    /// Newton iterations at the full precision.
    pub iterations: u32,
    /// Bits of the type that V₀, Δ₀ or a phase may lack, from the inverse Jacobian: at 53 bits and
    /// `lost_bits` = 10, 43 are good.
    pub lost_bits: u32,
}

/// The border by eq. 21–25, 58 and 59.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct BorderSolution<F> {
    /// The force ratio α, which eq. 61 gives in closed form.
    pub force_ratio: F,
    /// The cycle on the border, as in [`Solution`]. Near Ω = 1, unlike α, it lacks the digits counted by
    /// [`Solution::lost_bits`]; t₁ is not searched again.
    pub unknowns: Unknowns<F>,
    /// |left − right| of eq. 21–25 and 59, in units of the last place of their largest term.
    pub residuals: [F; 6],
    /// Newton iterations at the full precision.
    pub iterations: u32,
}

/// Where the iteration ends.
pub(super) struct Found<F, const N: usize> {
    pub(super) at: [F; N],
    pub(super) iterations: u32,
    pub(super) step: f64,
    pub(super) residual: f64,
}

impl<F, const N: usize> Found<F, N> {
    /// The error where this is no solution.
    pub(super) const fn failure(&self) -> MatchingError {
        let Self { iterations, step, residual, .. } = *self;
        MatchingError::NoConvergence { iterations, step, residual }
    }
}

pub(super) fn positive<F: Float>(what: &'static str, value: F) -> Result<(), MatchingError> {
    if value > F::int(0) { Ok(()) } else { Err(MatchingError::NotACycle { what, value: written(value) }) }
}

pub(super) fn in_order<F: Real>(u: &Unknowns<F>) -> [F; 5] {
    [u.velocity_phase, u.displacement_phase, u.max_velocity, u.max_displacement, u.deviation]
}

pub(super) fn unknowns<F: Real>(x: &[F; 5]) -> Unknowns<F> {
    let [velocity_phase, displacement_phase, max_velocity, max_displacement, deviation] = *x;
    Unknowns { velocity_phase, displacement_phase, max_velocity, max_displacement, deviation }
}

/// Where the error is only halved, one iteration for each bit, and some.
pub(super) fn most_iterations<F: Float>() -> u32 {
    F::precision() + 64
}

/// The solution of `jacobian · step = residuals` by LU with partial pivoting.
pub(super) fn newton_step<F: Float + RealField, const N: usize>(
    residuals: &[F; N],
    jacobian: &[[F; N]; N],
) -> Option<[F; N]> {
    let matrix = DMatrix::from_row_iterator(N, N, jacobian.iter().flatten().copied());
    let step = matrix.lu().solve(&DVector::from_column_slice(residuals))?;
    let mut result = [<F as Field>::int(0); N];
    for (slot, value) in result.iter_mut().zip(step.iter()) {
        *slot = *value;
    }
    result.iter().all(|x| Float::is_finite(*x)).then_some(result)
}

pub(super) fn largest<F: Float>(x: &[F]) -> F {
    x.iter().fold(F::int(0), |most, x| most.or_larger(x.abs()))
}

/// Newton's method until the step is rounding: it falls below the last places, or stops shrinking where the
/// residuals are rounding.
///
/// From ten correct digits each step doubles them. Near the end of the branch, α → |K|, where two cycles
/// meet, a step only halves the error, which takes one iteration per bit; that many are allowed.
pub(super) fn iterate<F: Float + RealField, const N: usize>(
    start: [F; N],
    mut system: impl FnMut(&[F; N]) -> ([F; N], [[F; N]; N]),
) -> Result<Found<F, N>, MatchingError> {
    let (mut at, mut last) = (start, <F as Field>::int(1));
    let small = Field::sqrt(<F as Float>::epsilon());
    let mut residual = last;
    for iterations in 1..=most_iterations::<F>() {
        let (residuals, jacobian) = system(&at);
        residual = largest(&residuals);
        let Some(step) = newton_step(&residuals, &jacobian) else { break };
        for (x, dx) in at.iter_mut().zip(&step) {
            *x -= *dx;
        }
        let size = largest(&step);
        let least = last <= small || residual <= <F as Field>::int(16) * <F as Float>::epsilon();
        let settled = size <= <F as Float>::epsilon() || (least && size * <F as Field>::ratio(3, 2) >= last);
        if settled {
            let (step, residual) = (Float::to_f64(size), Float::to_f64(residual));
            return Ok(Found { at, iterations, step, residual });
        }
        last = size;
    }
    let (step, residual) = (Float::to_f64(last), Float::to_f64(residual));
    Err(MatchingError::NoConvergence { iterations: most_iterations::<F>(), step, residual })
}

#[cfg(test)]
mod tests {
    use super::positive;

    #[test]
    fn what_is_not_above_zero_is_no_cycle() {
        assert!(positive("Δ₀/B", f64::MIN_POSITIVE).is_ok());
        for value in [0.0, -0.25, f64::NAN] {
            let error = positive("Δ₀/B", value).unwrap_err().to_string();
            assert!(
                error.contains("Δ₀/B") && error.contains(&crate::machine::error::written(value).to_string()),
                "{error}"
            );
        }
    }
}
