//! The period map: Hᵐ, m half turns of the drive with a change of sign after each, its derivative and its
//! fixed points.

use super::matrix::Matrix;
use super::measures::CycleStatistics;
use super::propagation::{MotionPart, follow, propagate};
use super::shooting::{Residual, is_known};
use super::steady::{SteadyParts, SteadyState, Summary};
use crate::float::Float;
use crate::motion::broken::{Broken, Budget};
use crate::motion::slide::Direction;
use crate::motion::slide::equation::Equation;
use crate::motion::state::Point;

/// Some half turns of a motion.
pub(crate) struct MapStep<F> {
    /// The point at the end, with the opposite sign after an odd number of half turns.
    pub(crate) end: Point<F>,
    /// The derivative of the end by the state at the beginning.
    pub(crate) derivative: Matrix<F>,
    /// The position at which the body rests permanently, if it does.
    pub(crate) rest: Option<F>,
    /// A number that represents the sequence of slides and stops; most sequences differ in it.
    pub(crate) pattern: u64,
}

/// `Hᵐ` at a point, with its derivative.
pub(crate) fn half_turns<F: Float>(
    equation: Equation<F>,
    from: &Point<F>,
    m: u64,
    budget: &mut Budget<'_>,
    mut visit: impl FnMut(&MotionPart<F>),
) -> Result<MapStep<F>, Broken> {
    let (mut rest, mut pattern) = (None, 0u64);
    let usual = F::pi() / equation.omega;
    let count = i64::try_from(m).unwrap_or(i64::MAX);
    let (end, derivative) = follow(equation, *from, count, usual, budget, |part| {
        let kind = match &part {
            MotionPart::Slide(slide, _) | MotionPart::Onward(slide, ..) => match slide.direction {
                Direction::Forward => 1,
                Direction::Backward => 2,
            },
            MotionPart::Stick(stick, _) => {
                rest = if stick.release.is_none() { Some(stick.x) } else { None };
                3
            }
        };
        pattern = pattern.wrapping_mul(0x9e37_79b9_7f4a_7c15).wrapping_add(kind);
        visit(&part);
        Ok(())
    })?;
    budget.spend(m);
    Ok(if m % 2 == 1 {
        let end = Point { phase: from.phase, x: -end.x, w: -end.w };
        MapStep { end, derivative: derivative.negated(), rest, pattern }
    } else {
        MapStep { end: Point { phase: from.phase, ..end }, derivative, rest, pattern }
    })
}

/// A periodic motion of m half turns, with the properties of its cycle.
pub(crate) fn steady<F: Float>(
    equation: Equation<F>,
    start: Point<F>,
    m: u64,
    multipliers: [(F, F); 2],
    distance: (F, F),
    budget: &mut Budget<'_>,
) -> Result<SteadyState<F>, Broken> {
    let half_turns = u32::try_from(m).unwrap_or(u32::MAX);
    let usual = F::pi() / equation.omega;
    let once = propagate(equation, start, i64::from(half_turns), usual, Vec::new(), budget)?;
    let statistics = CycleStatistics::of_periodic(equation, start, i64::from(half_turns), &once, budget)?;
    let statistics = if m % 2 == 1 { statistics.doubled() } else { statistics };
    Ok(SteadyState::of(SteadyParts {
        equation,
        start,
        half_turns,
        statistics: Summary::of(&statistics, half_turns),
        multipliers,
        distance,
        periods: budget.periods(),
    }))
}

/// A state of a periodic motion with a bound on its error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Located<F> {
    pub(crate) at: Point<F>,
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

/// A trial for a fixed point of Hᵐ: a point and its image.
pub(crate) struct Trial<F> {
    pub(crate) y: Point<F>,
    pub(crate) m: u64,
    pub(crate) step: MapStep<F>,
    pub(crate) left: Residual<F>,
}

impl<F: Float> Trial<F> {
    pub(crate) fn at(
        equation: Equation<F>,
        y: Point<F>,
        m: u64,
        budget: &mut Budget<'_>,
    ) -> Result<Self, Broken> {
        // A negligible speed counts as rest, as in a start, because the slide would end after a time that
        // underflows.
        let y = if y.w.abs() < F::least_ratio() { Point { w: F::int(0), ..y } } else { y };
        let step = half_turns(equation, &y, m, budget, |_| {})?;
        let left = Residual::new(&equation, &y, (step.end.x - y.x, step.end.w - y.w)).of_half_turns(m);
        Ok(Self { y, m, step, left })
    }

    /// `(1 − J)⁻¹`, with J the derivative of Hᵐ.
    fn inverse(&self) -> Matrix<F> {
        self.step.derivative.negated().inverse_of_one_plus()
    }

    /// Newton's method for a fixed point of Hᵐ, with full steps as long as each halves the residual.
    pub(crate) fn newton(self, equation: Equation<F>, budget: &mut Budget<'_>) -> Result<Self, Broken> {
        self.descend(equation, budget, &[1])
    }

    /// Newton's method for a distant fixed point of Hᵐ: where a full step does not help, a part of it, down
    /// to a sixteenth.
    pub(crate) fn newton_from_far(
        self,
        equation: Equation<F>,
        budget: &mut Budget<'_>,
    ) -> Result<Self, Broken> {
        self.descend(equation, budget, &[1, 2, 4, 16])
    }

    /// Newton's method with the first of the fractions 1/part of a step that reduces the residual to at most
    /// 1 − 1/(2 part) of itself.
    fn descend(self, equation: Equation<F>, budget: &mut Budget<'_>, parts: &[i32]) -> Result<Self, Broken> {
        let mut best = self;
        'steps: for _ in 0..MOST_STEPS {
            let (dx, dw) = best.inverse().times((best.left.x, best.left.w));
            if !(dx.is_finite() && dw.is_finite()) {
                break;
            }
            for part in parts.iter().map(|part| F::int(*part)) {
                let y = Point { x: best.y.x + dx / part, w: best.y.w + dw / part, ..best.y };
                let tried = Self::at(equation, y, best.m, budget)?;
                let two = F::int(2);
                if tried.left.norm() * two * part <= best.left.norm() * (two * part - F::int(1)) {
                    best = tried;
                    continue 'steps;
                }
            }
            break;
        }
        Ok(best)
    }

    /// Whether the motion repeats to within `times` times the rounding, with a known distance from a fixed
    /// point.
    pub(crate) fn is_periodic(&self, times: i32) -> bool {
        self.left.is_rounding(times) && is_known(&self.y, self.inverse(), &self.left)
    }

    /// The point with its possible distance from a fixed point, `|(1 − J)⁻¹| (|Hᵐ(y) − y| + rounding)`.
    pub(crate) fn located(&self) -> Located<F> {
        Located { at: self.y, off: self.inverse().absolute().times(self.left.bounds()) }
    }

    /// Whether `det(1 − J)` is positive, which is the index of the fixed point: +1 or −1.
    fn is_index_positive(&self) -> bool {
        let m = self.step.derivative;
        F::int(1) - m.trace() + m.determinant() > F::int(0)
    }

    /// This fixed point as a fixed point of the fewest half turns.
    ///
    /// Where the motion settles slowly, this point can be far from the fixed point compared with rounding.
    /// After fewer half turns its image is then off by twice its distance from the fixed point, which decides
    /// nothing. Therefore Newton's method on Hᵈ, d a divisor of m, decides. It leads to the same fixed point
    /// if the two agree to within their distances and have the same index as fixed points of Hᵐ. The index
    /// distinguishes a mirror pair from the symmetric motion from which it branches off, however near: the
    /// two have opposite indices.
    pub(crate) fn earliest(
        self,
        equation: Equation<F>,
        times: i32,
        budget: &mut Budget<'_>,
    ) -> Result<Self, Broken> {
        for divisor in (1..self.m).filter(|divisor| self.m.is_multiple_of(*divisor)) {
            let early = Self::at(equation, self.y, divisor, budget)?.newton(equation, budget)?;
            if early.is_periodic(times) {
                let again = Self::at(equation, early.y, self.m, budget)?;
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
    pub(crate) fn steady(
        self,
        equation: Equation<F>,
        budget: &mut Budget<'_>,
    ) -> Result<SteadyState<F>, Broken> {
        let distance = self.located().off;
        let derivative = self.step.derivative;
        let multipliers =
            if self.m % 2 == 1 { derivative.squared_eigenvalues() } else { derivative.eigenvalues() };
        steady(equation, self.y, self.m, multipliers, distance, budget)
    }
}

/// The greatest number of steps of Newton's method.
const MOST_STEPS: u32 = 24;

pub(crate) fn distance<F: Float>(p: &Point<F>, q: &Point<F>) -> F {
    (p.x - q.x).hypot(p.w - q.w)
}

pub(crate) fn size<F: Float>(p: &Point<F>) -> F {
    F::int(1) + p.x.abs() + p.w.abs()
}
