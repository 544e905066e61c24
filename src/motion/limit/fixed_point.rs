//! The fixed points of Hᵐ, m half turns of the drive with a change of sign after each.
//!
//! Newton's step for them is `(1 − J)⁻¹ (Hᵐ(y) − y)`, with J the derivative of Hᵐ along the motion. Where a
//! step does not help, the motion is followed if η = 1, because H then never increases the residual
//! (`shooting`); with η > 1 it can, and the step is shortened instead.

use super::matrix::Matrix;
use super::propagation::HalfTurns;
use super::steady::SteadyState;
use crate::float::Float;
use crate::motion::broken::{Broken, Budget};
use crate::motion::slide::equation::Equation;
use crate::motion::state::PhasePoint;

/// The residual `Hᵐ(y) − y`, and its rounding error where it is zero.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Residual<F> {
    pub(crate) x: F,
    pub(crate) w: F,
    noise_x: F,
    noise_w: F,
}

impl<F: Float> Residual<F> {
    /// The residual (x, w) from y, with the rounding of the terms of x and w (two units each) and of the
    /// phase: half a unit of θ moves x by w/Ω and w by w′/Ω.
    pub(crate) fn new(equation: &Equation<F>, y: &PhasePoint<F>, (x, w): (F, F)) -> Self {
        let Equation { omega, alpha, damping, .. } = *equation;
        let (one, unit) = (F::int(1), F::int(4) * F::epsilon());
        let forced = alpha / (one + omega.square());
        let rate = (one + alpha + y.x.abs() + damping * y.w.abs()) / omega;
        Self {
            x,
            w,
            noise_x: unit * (y.x.abs() + forced + y.w.abs() / omega),
            noise_w: unit * (y.w.abs() + forced * omega + rate),
        }
    }

    /// This residual with the rounding of `count` half turns.
    pub(crate) fn of_half_turns(self, count: u32) -> Self {
        let count = F::from_f64(f64::from(count));
        Self { noise_x: count * self.noise_x, noise_w: count * self.noise_w, ..self }
    }

    /// The norm of the residual, a distance that the motion never increases.
    pub(crate) fn norm(&self) -> F {
        self.x.hypot(self.w)
    }

    /// Whether the residual is at most `times` times its rounding.
    pub(crate) fn is_rounding(&self, times: i32) -> bool {
        let times = F::int(times);
        self.x.abs() <= times * self.noise_x && self.w.abs() <= times * self.noise_w
    }

    /// Whether the rounding of this residual is at most four times that of the other one: at large
    /// displacements rounding hides any residual.
    pub(crate) fn is_as_fine_as(&self, other: &Self) -> bool {
        let four = F::int(4);
        self.noise_x <= four * other.noise_x && self.noise_w <= four * other.noise_w
    }

    /// The norm of the residual plus the norm of its rounding.
    pub(crate) fn bound(&self) -> F {
        self.norm() + self.noise_x.hypot(self.noise_w)
    }

    /// Bounds on x and w of the residual, rounding included.
    pub(crate) fn bounds(&self) -> (F, F) {
        (self.x.abs() + self.noise_x, self.w.abs() + self.noise_w)
    }
}

/// The rounding of the propagated disturbance after a number of parts of a motion, with a margin.
pub(crate) fn rate_noise<F: Float>(parts: u64) -> F {
    F::int(64) * F::epsilon() * F::from_f64(parts as f64 + 1.0)
}

/// Whether a possible distance from the limit is small compared with the motion itself.
pub(crate) fn is_known<F: Float>(y: &PhasePoint<F>, (x, w): (F, F)) -> bool {
    let size = y.x.abs() + y.w.abs();
    F::int(16) * x <= size && F::int(16) * w <= size
}

/// A state of a periodic motion with a bound on its error.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(bound(deserialize = "F: Float + serde::Deserialize<'de>")))]
pub(crate) struct Located<F> {
    pub(crate) at: PhasePoint<F>,
    /// The possible distance of (x, w) from the motion.
    pub(crate) off: (F, F),
}

impl<F: Float> Located<F> {
    /// Whether two states at one phase are the same to within the sum of their distances.
    ///
    /// The distances are steps of Newton's method. Next to a symmetry-breaking bifurcation the residual is
    /// μs + s³ at a distance s and the step at least s/3, so that thrice the sum of the distances is allowed.
    pub(crate) fn agrees(&self, other: &Self) -> bool {
        let (p, q) = (self.at, other.at);
        // An unknown distance (NaN) distinguishes nothing.
        let apart = |a: F, b: F, room: F| (a - b).abs() > F::int(3) * room;
        !apart(p.x, q.x, self.off.0 + other.off.0) && !apart(p.w, q.w, self.off.1 + other.off.1)
    }
}

/// A trial for a fixed point of Hᵐ: the half turns from a point, and their residual.
#[derive(Debug)]
pub(crate) struct Trial<F> {
    pub(crate) motion: HalfTurns<F>,
    pub(crate) left: Residual<F>,
    /// `(1 − J)⁻¹`, with J the derivative of Hᵐ.
    inverse: Matrix<F>,
}

impl<F: Float> Trial<F> {
    pub(crate) fn of(motion: HalfTurns<F>) -> Self {
        let (y, end) = (&motion.start, &motion.end);
        let left = Residual::new(&motion.equation, y, (end.x - y.x, end.w - y.w)).of_half_turns(motion.m);
        let inverse = motion.derivative.negated().inverse_of_one_plus();
        Self { motion, left, inverse }
    }

    /// The trial at a point y, without an expectation of its first velocity zero.
    ///
    /// # Errors
    /// As for [`HalfTurns::new`].
    pub(crate) fn at(
        equation: Equation<F>,
        y: PhasePoint<F>,
        m: u32,
        budget: &mut Budget<'_>,
    ) -> Result<Self, Broken> {
        Ok(Self::of(HalfTurns::new(equation, y, m, F::pi() / equation.omega, budget)?))
    }

    /// 1/`part` of Newton's step `(1 − J)⁻¹ (Hᵐ(y) − y)`, if it is finite.
    pub(crate) fn step(&self, part: i32) -> Option<(F, F)> {
        let (dx, dw) = self.inverse.times((self.left.x, self.left.w));
        (dx.is_finite() && dw.is_finite()).then(|| (dx / F::int(part), dw / F::int(part)))
    }

    /// Newton's method for a fixed point of Hᵐ, with full steps as long as each halves the residual.
    pub(crate) fn newton(self, budget: &mut Budget<'_>) -> Result<Self, Broken> {
        self.descend(budget, &[1])
    }

    /// Newton's method for a distant fixed point of Hᵐ: where a full step does not help, a part of it, down
    /// to a sixteenth.
    pub(crate) fn newton_from_far(self, budget: &mut Budget<'_>) -> Result<Self, Broken> {
        self.descend(budget, &[1, 2, 4, 16])
    }

    /// Newton's method with the first of the fractions 1/part of a step that reduces the residual to at most
    /// 1 − 1/(2 part) of itself.
    fn descend(self, budget: &mut Budget<'_>, parts: &[i32]) -> Result<Self, Broken> {
        let mut best = self;
        'steps: for _ in 0..MOST_STEPS {
            for part in parts {
                let Some((dx, dw)) = best.step(*part) else { return Ok(best) };
                let HalfTurns { equation, start: y, m, .. } = best.motion;
                let tried = Self::at(equation, PhasePoint { x: y.x + dx, w: y.w + dw, ..y }, m, budget)?;
                let twice = F::int(2) * F::int(*part);
                if tried.left.norm() * twice <= best.left.norm() * (twice - F::int(1)) {
                    best = tried;
                    continue 'steps;
                }
            }
            break;
        }
        Ok(best)
    }

    /// Whether the distance from the fixed point is known.
    pub(crate) fn is_known(&self) -> bool {
        let Located { at, off } = self.located();
        is_known(&at, off)
    }

    /// Whether the motion repeats to within `times` times the rounding, with a known distance from a fixed
    /// point.
    pub(crate) fn is_periodic(&self, times: i32) -> bool {
        self.left.is_rounding(times) && self.is_known()
    }

    /// The point with its possible distance from a fixed point, `|(1 − J)⁻¹| (|Hᵐ(y) − y| + rounding)`, entry
    /// by entry.
    pub(crate) fn located(&self) -> Located<F> {
        Located { at: self.motion.start, off: self.inverse.absolute().times(self.left.bounds()) }
    }

    /// Whether `det(1 − J)` is positive, which is the index of the fixed point: +1 or −1.
    fn is_index_positive(&self) -> bool {
        self.motion.derivative.determinant_of_one_minus() > F::int(0)
    }

    /// This fixed point as a fixed point of the fewest half turns.
    ///
    /// Where the motion settles slowly, this point can be far from the fixed point compared with rounding.
    /// After fewer half turns its image is then off by twice its distance from the fixed point, which decides
    /// nothing. Therefore Newton's method on Hᵈ, d a divisor of m, decides. It leads to the same fixed point
    /// if the two agree to within their distances and have the same index as fixed points of Hᵐ. The index
    /// distinguishes a mirror pair from the symmetric motion from which it branches off, however near: the
    /// two have opposite indices.
    pub(crate) fn earliest(self, times: i32, budget: &mut Budget<'_>) -> Result<Self, Broken> {
        let HalfTurns { equation, start, m, .. } = self.motion;
        for divisor in (1..m).filter(|divisor| m.is_multiple_of(*divisor)) {
            let early = Self::at(equation, start, divisor, budget)?.newton(budget)?;
            if early.is_periodic(times) {
                let again = Self::at(equation, early.motion.start, m, budget)?;
                if again.located().agrees(&self.located())
                    && again.is_index_positive() == self.is_index_positive()
                {
                    return Ok(early);
                }
            }
        }
        Ok(self)
    }

    /// The periodic motion through the fixed point.
    ///
    /// # Errors
    /// As for [`HalfTurns::steady`].
    pub(crate) fn steady(&self, budget: &mut Budget<'_>) -> Result<SteadyState<F>, Broken> {
        self.motion.steady(self.located().off, budget)
    }
}

/// The greatest number of steps of Newton's method.
const MOST_STEPS: u32 = 24;

pub(crate) fn distance<F: Float>(p: &PhasePoint<F>, q: &PhasePoint<F>) -> F {
    (p.x - q.x).hypot(p.w - q.w)
}

pub(crate) fn size<F: Float>(p: &PhasePoint<F>) -> F {
    F::int(1) + p.x.abs() + p.w.abs()
}
