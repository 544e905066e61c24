//! The steady state of the motion.

use super::measures::{CycleStatistics, ErrorMeasures, Extreme, seam};
use super::propagation::{HalfTurns, follow};
use crate::cycle::equivalent::Equivalent;
use crate::float::Float;
use crate::machine::error::Error;
use crate::machine::ratios::Ratios;
use crate::motion::broken::{Broken, Budget};
use crate::motion::slide::equation::Equation;
use crate::motion::state::{PhasePoint, State};
use crate::motion::trajectory::resolved;

/// A periodic motion, with or without stops.
///
/// Displacements in units of B = r_y/k, velocities in B ω_d, energies in r_y B, phases ω_d t in [0, 2π).
///
/// ```
/// use stickslip::Ratios;
/// use stickslip::motion::{LongRun, State};
/// let motion = LongRun::from_start(Ratios::new(0.4f64, 6.0)?, State::default())?;
/// let steady = motion.steady_state().unwrap();
/// assert!((steady.max_displacement.value - 6.79382).abs() < 1e-5);
/// assert_eq!((steady.sticks_per_cycle, steady.velocity_zeros_per_cycle), (2, 4));
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(
        from = "crate::serialized::SteadyFields<F>",
        bound(deserialize = "F: Float + serde::Deserialize<'de>")
    )
)]
#[non_exhaustive]
#[must_use]
pub struct SteadyState<F> {
    /// Maximum displacement x/B; its phase is that of the arrival.
    pub max_displacement: Extreme<F>,
    /// Minimum displacement x/B; its phase is that of the arrival.
    pub min_displacement: Extreme<F>,
    /// Maximum velocity x′/(Bω_d).
    pub max_velocity: Extreme<F>,
    /// Minimum velocity x′/(Bω_d).
    pub min_velocity: Extreme<F>,
    /// Stops in a cycle.
    pub sticks_per_cycle: u32,
    /// The number of velocity zeros in a cycle, which are the ends of slides. A stop counts once.
    pub velocity_zeros_per_cycle: u32,
    /// The fraction of a cycle during which the body is at rest, in [0, 1).
    pub stick_fraction: F,
    /// Work of the drive in a cycle, `∮ p₀ sin ω_d t dx`, in r_y B. It has its own closed form, where this is
    /// accurate, and its agreement with [`SteadyState::energy_out`], plus [`SteadyState::damper_work`] with
    /// damping, is then a check. Elsewhere (near Ω = 1, and where a motion is small compared with the force)
    /// it follows from the energy balance of each slide. The relative accuracy at f64 is 1e-13 (1 + Δ₀/B)(1 +
    /// 1/Ω), where Δ₀ is the maximum displacement.
    pub energy_in: F,
    /// Work against friction in a cycle, `∮ r_y |dx|`, in r_y B: 4Δ₀/B where the body reverses only at the
    /// extrema. It is as accurate as the displacements.
    pub energy_out: F,
    /// Work against the damper in a cycle, `∮ c x′ dx`, in r_y B. It has its own closed form, so that the sum
    /// with [`SteadyState::energy_out`] is a check of [`SteadyState::energy_in`]. Zero without a damper.
    pub damper_work: F,
    /// The Floquet multipliers of the cycle, each (re, im): the factors of a small disturbance in one period.
    /// If the body stops, one is zero.
    pub multipliers: [(F, F); 2],
    /// Turns of the drive in a cycle of the motion: 1, except for some motions with a static friction above
    /// the kinetic one.
    pub turns_per_cycle: u32,
    /// Whether each half of a cycle is the mirror image of the other. All motions are symmetric except for
    /// members of a family at Ω = 1/(2n) and some motions with a static friction above the kinetic one. The
    /// mirror image of an asymmetric motion is also a motion.
    pub is_symmetric: bool,
    /// A state of the motion, from which [`crate::motion::Trajectory::new`] follows it.
    pub state: State<F>,
    /// Estimated distance of the computed motion from the limit, (x/B, x′/(Bω_d)) at [`SteadyState::state`]:
    /// the residual of half a turn and its rounding, multiplied by `|(1 + M)⁻¹|`, M the derivative of the
    /// half-turn map at that state.
    ///
    /// This estimate is no proven bound, because the map is curved and has kinks. In 27,557 pairs of starts
    /// the computed motions were never further apart than 0.78 of the sum of their estimates. Where Ω is
    /// 1/(2n) to within rounding, the limit is the closed form, and the estimate is rounding.
    pub distance: (F, F),
    /// The number of periods of the drive that were followed to find the motion.
    pub periods: F,
    pub(crate) equation: Equation<F>,
    pub(crate) start: PhasePoint<F>,
}

/// The parts from which a steady state is made.
pub(crate) struct SteadyParts<F> {
    pub(crate) equation: Equation<F>,
    pub(crate) start: PhasePoint<F>,
    /// The number of half turns after which the state repeats, mirrored if the number is odd.
    pub(crate) half_turns: u32,
    /// The statistics of one whole cycle.
    pub(crate) statistics: CycleStatistics<F>,
    pub(crate) multipliers: [(F, F); 2],
    /// (x, w), where w = Ω x′.
    pub(crate) distance: (F, F),
    pub(crate) periods: F,
}

impl<F: Float> SteadyState<F> {
    #[inline]
    pub(crate) fn of(found: SteadyParts<F>) -> Self {
        let (statistics, start, omega) = (found.statistics, found.start, found.equation.omega);
        let is_symmetric = found.half_turns % 2 == 1;
        let turns = if is_symmetric { found.half_turns } else { found.half_turns / 2 };
        Self {
            max_displacement: statistics.max_x,
            min_displacement: statistics.min_x,
            max_velocity: statistics.max_v,
            min_velocity: statistics.min_v,
            sticks_per_cycle: statistics.sticks,
            velocity_zeros_per_cycle: statistics.zeros,
            stick_fraction: statistics.rest / (F::int(2) * F::pi() * F::from_f64(f64::from(turns))),
            energy_in: statistics.work_in,
            energy_out: statistics.work_out,
            damper_work: statistics.damper,
            multipliers: found.multipliers,
            turns_per_cycle: turns,
            is_symmetric,
            state: start.state(omega),
            distance: (found.distance.0, found.distance.1 / omega),
            periods: found.periods,
            equation: found.equation,
            start,
        }
    }

    /// The number of half turns after which the state repeats, mirrored if the number is odd.
    pub(crate) const fn half_turns(&self) -> u32 {
        if self.is_symmetric { self.turns_per_cycle } else { self.turns_per_cycle.saturating_mul(2) }
    }

    /// Whether neighbouring motions approach this one: both multipliers are within the unit circle. Every
    /// limit of a motion is stable; a search for periodic motions ([`crate::motion::periodic_motions()`])
    /// also finds unstable ones.
    pub fn is_stable(&self) -> bool {
        self.multipliers.iter().all(|(re, im)| re.hypot(*im) < F::int(1))
    }

    /// Contraction per cycle: the modulus of the larger multiplier.
    pub fn contraction(&self) -> F {
        let [(a, b), (c, d)] = self.multipliers;
        a.hypot(b).or_larger(c.hypot(d))
    }

    /// The equivalent oscillator, by the work in a turn of the drive and half the range of the displacement.
    pub(crate) fn equivalent(&self) -> Equivalent<F> {
        let turns = F::from_f64(f64::from(self.turns_per_cycle));
        Equivalent {
            omega: self.equation.omega,
            amplitude: (self.max_displacement.value - self.min_displacement.value) / F::int(2),
            work: (self.energy_out + self.damper_work) / turns,
        }
    }

    /// The paper's error measures of one cycle. The cycle is followed for this purpose, and both of its
    /// halves are computed independently. It begins within a slide: a stop that it cut in two would have two
    /// instants of arrival.
    ///
    /// # Errors
    /// [`Error::SearchBound`].
    pub fn errors(&self) -> Result<ErrorMeasures<F>, Error> {
        let Self { equation, start, .. } = *self;
        let turns = self.turns_per_cycle;
        let greatest = self.max_velocity.value.abs().or_larger(self.min_velocity.value.abs());
        let usual = F::pi() / equation.omega;
        let seam = seam(&start, greatest * equation.omega, |visit| {
            let half_turns = turns.saturating_mul(2);
            follow(equation, start, half_turns, usual, &mut Budget::of(0), |part| visit(&part)).map(|_| ())
        })?;
        error_measures(equation, &seam.map_or(start, |(seam, _)| seam), turns)
    }
}

impl<F: Float> HalfTurns<F> {
    /// The steady state of a motion that repeats after these half turns; `distance` is the possible distance of
    /// (x, w) at their start from the limit.
    ///
    /// # Errors
    /// As for [`follow`].
    pub(crate) fn steady(&self, distance: (F, F), budget: &mut Budget<'_>) -> Result<SteadyState<F>, Broken> {
        let derivative = self.derivative;
        Ok(SteadyState::of(SteadyParts {
            equation: self.equation,
            start: self.start,
            half_turns: self.m,
            statistics: CycleStatistics::of_cycle(self, budget)?,
            multipliers: if self.m.is_multiple_of(2) {
                derivative.eigenvalues()
            } else {
                derivative.squared_eigenvalues()
            },
            distance,
            periods: budget.periods(),
        }))
    }
}

/// The error measures of the cycle of `turns` turns that begins at a point.
fn error_measures<F: Float>(
    equation: Equation<F>,
    start: &PhasePoint<F>,
    turns: u32,
) -> Result<ErrorMeasures<F>, Error> {
    let usual = F::pi() / equation.omega;
    let mut statistics = CycleStatistics::at(start, equation.omega);
    follow(equation, *start, turns.saturating_mul(2), usual, &mut Budget::of(0), |part| {
        statistics.add(&part)
    })?;
    Ok(statistics.errors(turns))
}

/// The paper's error measures of a motion that has not settled: those of the first cycle after `cycles`
/// cycles from a start, as in its Figure 3.
///
/// # Errors
/// As for [`crate::motion::Trajectory::new`].
pub fn errors_after<F: Float>(
    ratios: Ratios<F>,
    start: State<F>,
    cycles: u32,
) -> Result<ErrorMeasures<F>, Error> {
    let equation = Equation::new(resolved(ratios)?);
    let usual = F::pi() / equation.omega;
    let mut point = PhasePoint::of(&start, equation.omega);
    for _ in 0..cycles {
        (point, _) = follow(equation, point, 2, usual, &mut Budget::of(0), |_| Ok(()))?;
    }
    error_measures(equation, &point, 1)
}

#[cfg(test)]
mod tests;
