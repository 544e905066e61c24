//! The forces at which the symmetric motion loses its symmetry.
//!
//! Let H advance the state by half a turn of the drive and change its sign, and let J be its derivative. A
//! symmetric motion of one turn is a fixed point of H, and its multipliers per turn are those of J², the
//! squares λ² of those of J. At λ = +1 two symmetric motions meet. At λ = −1 a pair of points that H
//! exchanges branches off, y ≠ H(y), H²(y) = y: an asymmetric motion of one turn, and its mirror image. So
//! **symmetry breaks at λ = −1**, where
//!
//! ```text
//! f = det(1 + J) = (1 + λ₁)(1 + λ₂)
//! ```
//!
//! changes its sign. With a stop in each half turn one multiplier is 0, and f = 1 + tr J.
//!
//! A symmetric motion can also be lost by a jump, where the excess force at one of its velocity zeros reaches
//! η: a stop begins or ends there, and the sequence of slides and stops changes. No multiplier announces it.

use crate::float::Float;
use crate::machine::error::Error;
use crate::machine::ratios::Ratios;
use crate::motion::DrivePhase;
use crate::motion::broken::Budget;
use crate::motion::limit::fixed_point::{Located, Trial, distance, size};
use crate::motion::limit::matrix::Matrix;
use crate::motion::limit::propagation::HalfTurns;
use crate::motion::limit::steady::SteadyState;
use crate::motion::slide::equation::Equation;
use crate::motion::state::PhasePoint;
use crate::motion::trajectory::resolved;
use crate::root::enclosed;
use alloc::vec::Vec;
use core::ops::RangeInclusive;

/// How a symmetric motion is lost.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum Loss {
    /// A multiplier per half turn passes −1: the symmetric motion continues, unstable, together with a mirror
    /// pair.
    Multiplier,
    /// A multiplier per half turn reaches +1: two symmetric motions meet, and beyond neither exists.
    Fold,
    /// The excess force at one of its velocity zeros reaches η: the motion ends, or its multipliers jump.
    Jump,
}

/// A force ratio at which a stable symmetric motion of one turn is lost.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "F: Float + serde::Serialize",
        deserialize = "F: Float + serde::Deserialize<'de>"
    ))
)]
#[non_exhaustive]
pub struct SymmetryBreak<F> {
    /// The force ratio α.
    pub alpha: F,
    /// Whether the motion is stable above that force ratio; otherwise below.
    pub is_stable_above: bool,
    /// How the motion is lost.
    pub loss: Loss,
    /// The motion at this force ratio, on the stable side.
    pub motion: SteadyState<F>,
}

/// A symmetric motion at a force ratio.
#[derive(Clone, Copy)]
struct Symmetric<F> {
    alpha: F,
    state: Located<F>,
    derivative: Matrix<F>,
    steady: SteadyState<F>,
}

impl<F: Float> Symmetric<F> {
    /// `f = det(1 + J)`.
    fn f(&self) -> F {
        let m = self.derivative;
        F::int(1) + m.trace() + m.determinant()
    }

    /// `det(1 − J) = (1 − λ₁)(1 − λ₂)`, which vanishes where two symmetric motions meet.
    fn fold(&self) -> F {
        self.derivative.determinant_of_one_minus()
    }

    /// Whether no multiplier has passed −1 or +1, by a margin. (A multiplier that jumps past +1 leaves f
    /// above 0.)
    fn is_stable_by(&self, margin: F) -> bool {
        self.f() > margin && self.fold() > margin
    }

    /// Velocity zeros and stops in a cycle.
    fn shape(&self) -> (u32, u32) {
        (self.steady.velocity_zeros_per_cycle, self.steady.sticks_per_cycle)
    }

    fn is_near(&self, other: &Self) -> bool {
        let (y, there) = (&self.state.at, &other.state.at);
        distance(y, there) <= F::exp2i(-16) * size(y)
    }
}

/// The machine, whose force ratio varies.
struct VariedForce<F>(Ratios<F>);

impl<F: Float> VariedForce<F> {
    /// The symmetric motion to which Newton's method converges from a state.
    fn symmetric(&self, alpha: F, seed: PhasePoint<F>) -> Result<Option<Symmetric<F>>, Error> {
        let equation = Equation::new(resolved(self.0.with_force_ratio(alpha)?)?);
        let budget = &mut Budget::of(0);
        let trial = Trial::at(equation, seed, 1, budget)?.newton_from_far(budget)?;
        if trial.motion.rest.is_some() || !trial.is_periodic(64) {
            return Ok(None);
        }
        let (state, derivative) = (trial.located(), trial.motion.derivative);
        let steady = trial.steady(budget)?;
        Ok(Some(Symmetric { alpha, state, derivative, steady }))
    }

    /// The symmetric motion at another force, with the same slides and stops as `self`. The search starts on
    /// the line through two known motions, then at the last one.
    fn continued(
        &self,
        (before, last): (&Symmetric<F>, &Symmetric<F>),
        alpha: F,
    ) -> Result<Option<Symmetric<F>>, Error> {
        let share = (alpha - last.alpha) / (last.alpha - before.alpha);
        let ahead = |a: F, b: F| b + (b - a) * share;
        if share.is_finite() {
            let (from, to) = (before.state.at, last.state.at);
            let y = PhasePoint { x: ahead(from.x, to.x), w: ahead(from.w, to.w), ..to };
            let found = self.symmetric(alpha, y)?.filter(|found| found.shape() == last.shape());
            if found.is_some() {
                return Ok(found);
            }
        }
        let found = self.symmetric(alpha, last.state.at)?;
        Ok(found.filter(|found| found.shape() == last.shape()))
    }

    /// The symmetric motions to which some starts and the given states lead.
    fn all(&self, alpha: F, known: &[Symmetric<F>]) -> Result<Vec<Symmetric<F>>, Error> {
        let equation = Equation::new(resolved(self.0.with_force_ratio(alpha)?)?);
        let origin = DrivePhase::of_half_turn(0, F::int(0));
        let mut seeds: Vec<PhasePoint<F>> = known.iter().map(|motion| motion.state.at).collect();
        for (place, speed) in [(0, 0), (1, -1), (-1, 1), (3, -3)] {
            let mut y =
                PhasePoint { phase: origin, x: F::ratio(place, 2) * alpha, w: F::ratio(speed, 3) * alpha };
            for _ in 0..FOLLOWED {
                y = HalfTurns::new(equation, y, 1, F::pi() / equation.omega, &mut Budget::of(0))?.end;
            }
            seeds.push(y);
        }
        let mut found: Vec<Symmetric<F>> = Vec::new();
        for seed in seeds {
            if let Some(motion) = self.symmetric(alpha, seed)?
                && !found.iter().any(|known| known.state.agrees(&motion.state))
            {
                found.push(motion);
            }
        }
        Ok(found)
    }
}

/// The number of half turns for which a start is followed.
const FOLLOWED: u32 = 24;

/// The force ratios between `low` and `high` at which a stable symmetric motion of one turn is lost: by its
/// multiplier, or because it ends.
///
/// The range is divided into `steps` equal steps, and Newton's method finds the symmetric motions at each
/// force ratio. If one of them is stable at one end of a step and unstable or absent at the other, the force
/// ratio in between is found to rounding. **Found by search**: a motion that is lost and regained within a
/// step is missed. The force ratio of `ratios` is ignored. With a static friction equal to the kinetic one
/// there are none: friction is monotone, and the only limit is symmetric (docs/development/theory/stability.md).
///
/// ```
/// use stickslip::Ratios;
/// use stickslip::motion::{Loss, symmetry_breaks};
/// let ratios = Ratios::new(0.5f64, 1.0)?.with_damping_ratio(0.02)?.with_static_friction_ratio(1.3)?;
/// let found = symmetry_breaks(ratios, 3.0..=3.8, 10)?;
/// assert!(found.len() == 1 && found[0].loss == Loss::Multiplier && !found[0].is_stable_above);
/// assert!((found[0].alpha - 3.514173764105).abs() < 1e-11);
/// # Ok::<(), stickslip::Error>(())
/// ```
///
/// # Errors
/// Where a force ratio is outside its domain, and as for [`crate::motion::Trajectory::new`].
pub fn symmetry_breaks<F: Float>(
    ratios: Ratios<F>,
    alphas: RangeInclusive<F>,
    steps: u32,
) -> Result<Vec<SymmetryBreak<F>>, Error> {
    let (low, high) = alphas.into_inner();
    let machine = VariedForce(ratios);
    let step = |i: u32| low + (high - low) * F::from_f64(f64::from(i)) / F::from_f64(f64::from(steps.max(1)));
    let mut breaks = Vec::new();
    if !ratios.has_higher_static_friction() {
        for alpha in [low, high] {
            resolved(ratios.with_force_ratio(alpha)?)?;
        }
        return Ok(breaks);
    }
    let (mut last, mut below) = (low, machine.all(low, &[])?);
    for i in 1..=steps.max(1) {
        let alpha = step(i);
        let above = machine.all(alpha, &below)?;
        for (here, there) in [(&below, alpha), (&above, last)] {
            for motion in here.iter().filter(|motion| motion.steady.is_stable()) {
                breaks.extend(lost(&machine, motion, there)?);
            }
        }
        (last, below) = (alpha, above);
    }
    Ok(breaks)
}

/// The force ratio at which a stable motion is lost on the way to another force ratio. If a stop merely
/// appears or disappears, the motion is continued.
fn lost<F: Float>(
    machine: &VariedForce<F>,
    motion: &Symmetric<F>,
    to: F,
) -> Result<Option<SymmetryBreak<F>>, Error> {
    let (zero, one) = (F::int(0), F::int(1));
    let is_stable_above = motion.alpha > to;
    let (mut before, mut last) = (*motion, *motion);
    for _ in 0..MOST_SHAPES {
        if machine.continued((&before, &last), to)?.is_some_and(|there| there.is_stable_by(zero)) {
            return Ok(None);
        }
        // The last two stable motions, from which the next is sought.
        let mut failure = None;
        let (below, above) = enclosed(last.alpha, to, |alpha| {
            let found = machine.continued((&before, &last), alpha).unwrap_or_else(|error| {
                failure = Some(error);
                None
            });
            let Some(found) = found.filter(|found| found.is_stable_by(zero)) else { return -one };
            (before, last) = (last, found);
            one
        });
        if let Some(error) = failure {
            return Err(error);
        }
        let beyond = if is_stable_above { below } else { above };
        let next = machine.symmetric(beyond, last.state.at)?;
        let loss = match next.filter(|next| next.is_near(&last)) {
            Some(_) if beyond == to => return Ok(None),
            Some(next) if next.is_stable_by(F::exp2i(-20)) => {
                (before, last) = (last, next);
                continue;
            }
            _ if last.fold() < F::exp2i(-12) => Loss::Fold,
            Some(next) if next.shape() == last.shape() && next.fold() > zero => Loss::Multiplier,
            Some(_) | None => Loss::Jump,
        };
        return Ok(Some(SymmetryBreak { alpha: last.alpha, is_stable_above, loss, motion: last.steady }));
    }
    let equation = Equation::new(machine.0.with_force_ratio(last.alpha)?);
    Err(equation
        .lost("the loss of a symmetric motion", last.state.at.phase, "256 changes of its stops")
        .into())
}

/// The greatest number of times that a stop may appear or disappear within a step.
const MOST_SHAPES: u32 = 256;

#[cfg(test)]
mod tests;
