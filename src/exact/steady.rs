//! The motion in the long run.

use super::drive::DrivePhase;
use super::measures::{ErrorMeasures, Extreme, Tally};
use super::rest::{Rest, come_to_rest};
use super::shooting::{Budget, Shot, shoot};
use super::slide::{Direction, Equation, Slide};
use super::trajectory::{Body, State, Trajectory, resolved};
use super::walk::{Point, walk};
use super::{family, trajectory};
use crate::error::Error;
use crate::float::Float;
use crate::nonsticking::Cycle;
use crate::phase_function::PhaseFunction;
use crate::ratios::Ratios;

/// What a motion tends to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LongRun<F> {
    /// One periodic motion, the same from every start: its multipliers are inside the unit circle.
    Periodic(SteadyState<F>),
    /// Ω = 1/(2n) without sticking: one of a family of periodic motions, the one that this start leads to.
    Family(SteadyState<F>),
    /// α ≤ 1: rest.
    Rest(Rest<F>),
    /// Ω = 1 and α > 4/π: no bounded motion. The amplitude grows by πα − 4 (in B) a cycle, once it is large.
    Unbounded {
        /// Growth of the maximum displacement in a cycle, in the limit.
        growth: F,
    },
    /// No limit within the budget: where the motion is, and how far half a cycle still takes it.
    NotConverged {
        /// The state reached.
        state: State<F>,
        /// `hypot(δx, δv Ω)` of half a cycle: what has not settled.
        residual: F,
        /// Periods of the drive that were followed.
        periods: F,
    },
}

impl<F: Float> LongRun<F> {
    /// What the motion at (Ω, α) tends to from a start.
    ///
    /// # Errors
    /// As for [`Trajectory::new`].
    pub fn from_start(ratios: Ratios<F>, start: State<F>) -> Result<Self, Error> {
        Self::within(ratios, start, DEFAULT_BUDGET)
    }

    /// The same, following the motion for at most `periods` periods of the drive.
    ///
    /// # Errors
    /// As for [`Trajectory::new`].
    pub fn within(ratios: Ratios<F>, start: State<F>, periods: u32) -> Result<Self, Error> {
        let ratios = resolved(ratios)?;
        let (one, alpha) = (F::int(1), ratios.alpha());
        let mut budget = Budget { half_turns: 0, most: 2 * u64::from(periods) };
        if alpha <= one {
            return Ok(come_to_rest(ratios, start, &mut budget));
        }
        if ratios.omega() == one && F::pi() * alpha > F::int(4) {
            return Ok(Self::Unbounded { growth: F::pi() * alpha - F::int(4) });
        }
        let equation = Equation::new(ratios);
        let (section, hint) = settle_in(equation, start, &mut budget);
        if family::is_one(ratios) {
            return Ok(family::member(equation, section, hint, budget));
        }
        let guess = || Cycle::new(ratios).ok().map(|cycle| fastest_point(equation, &cycle));
        Ok(Self::shot(equation, section, hint, guess, budget))
    }

    fn shot(
        equation: Equation<F>,
        section: Point<F>,
        hint: F,
        guess: impl FnOnce() -> Option<(Point<F>, F)>,
        mut budget: Budget,
    ) -> Self {
        match shoot(equation, section, hint, guess, &mut budget) {
            Shot::Settled(fixed) => {
                let periods = F::from_f64(budget.half_turns as f64) / F::int(2);
                let multipliers = fixed.walk.monodromy.squared_eigenvalues();
                let tally = Tally::of(&fixed.start, equation.omega, &fixed.walk.parts).doubled();
                Self::Periodic(SteadyState {
                    equation,
                    start: fixed.start,
                    tally: Summary::of(&tally),
                    multipliers,
                    distance: fixed.distance,
                    periods,
                })
            }
            Shot::Unsettled(y, residual) => unsettled(&equation, &y, residual, &budget),
        }
    }

    /// The periodic motion, where there is one.
    pub const fn steady_state(&self) -> Option<&SteadyState<F>> {
        match self {
            Self::Periodic(steady) | Self::Family(steady) => Some(steady),
            Self::Rest(_) | Self::Unbounded { .. } | Self::NotConverged { .. } => None,
        }
    }
}

/// Periods of the drive that a motion is followed for unless said otherwise.
pub const DEFAULT_BUDGET: u32 = 20_000;

/// [`LongRun::NotConverged`] at a point.
pub(crate) fn unsettled<F: Float>(
    equation: &Equation<F>,
    y: &Point<F>,
    residual: F,
    budget: &Budget,
) -> LongRun<F> {
    LongRun::NotConverged {
        state: State { phase: y.phase, x: y.x, v: y.w / equation.omega },
        residual,
        periods: F::from_f64(budget.half_turns as f64) / F::int(2),
    }
}

/// Follows the motion for two half turns, and takes the middle of its longest slide since as the place to shoot from.
fn settle_in<F: Float>(equation: Equation<F>, start: State<F>, budget: &mut Budget) -> (Point<F>, F) {
    let mut longest: Option<(Slide<F>, F)> = None;
    let begin = start.phase;
    let turn = F::pi();
    for phase in Trajectory::of(equation, start) {
        let Body::Slide(slide, end) = &phase.body else { continue };
        let longer = longest.as_ref().is_none_or(|(_, length)| end.phi >= *length);
        let after = end.phase.since(begin);
        if longer || after < turn {
            longest = Some((*slide, end.phi));
        }
        if after >= F::int(2) * turn {
            break;
        }
    }
    budget.half_turns += 2;
    let here = Point { phase: begin, x: start.x, w: start.v * equation.omega };
    let Some((slide, length)) = longest else { return (here, turn / equation.omega) };
    let half = length / F::int(2);
    (middle(&slide, half), half)
}

/// The fastest point of a non-sticking cycle, and the natural time from there to the maximum displacement.
fn fastest_point<F: Float>(equation: Equation<F>, cycle: &Cycle<F>) -> (Point<F>, F) {
    let minimum = DrivePhase::of_half_turn(0, F::int(0)).advanced(cycle.displacement_phase() - F::pi());
    let slide = Slide::new(equation, minimum, -cycle.max_displacement(), F::int(0), Direction::Forward);
    let lag = cycle.displacement_phase() - cycle.velocity_phase();
    let lag = if lag < F::int(0) { lag + F::int(2) * F::pi() } else { lag };
    (middle(&slide, (F::pi() - lag) / equation.omega), lag / equation.omega)
}

/// The point of a slide at natural time φ.
fn middle<F: Float>(slide: &Slide<F>, phi: F) -> Point<F> {
    let motion = slide.motion(phi);
    let phase = slide.start.advanced(slide.equation.omega * phi);
    Point { phase, x: motion.x, w: motion.w }
}

/// The parts of a tally that a steady state keeps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Summary<F> {
    max_x: Extreme<F>,
    min_x: Extreme<F>,
    max_v: Extreme<F>,
    min_v: Extreme<F>,
    sticks: u32,
    zeros: u32,
    stick_fraction: F,
    energy_in: F,
    energy_out: F,
}

impl<F: Float> Summary<F> {
    /// Of the tally of one whole cycle.
    pub(crate) fn of(tally: &Tally<F>) -> Self {
        Self {
            max_x: tally.max_x,
            min_x: tally.min_x,
            max_v: tally.max_v,
            min_v: tally.min_v,
            sticks: tally.sticks,
            zeros: tally.zeros,
            stick_fraction: tally.rest / (F::int(2) * F::pi()),
            energy_in: tally.work_in,
            energy_out: tally.work_out,
        }
    }
}

/// A periodic motion, with or without stops.
///
/// Displacements in units of B = r_y/k, velocities in B ω_d, energies in r_y B, phases ω_d t in [0, 2π).
///
/// ```
/// use stickslip::Ratios;
/// use stickslip::exact::{LongRun, State};
/// let motion = LongRun::from_start(Ratios::new(0.4f64, 6.0)?, State::rest())?;
/// let steady = motion.steady_state().unwrap();
/// assert!((steady.max_displacement() - 6.79382).abs() < 1e-5);
/// assert_eq!((steady.sticks_per_cycle(), steady.velocity_zeros_per_cycle()), (2, 4));
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SteadyState<F> {
    pub(crate) equation: Equation<F>,
    pub(crate) start: Point<F>,
    pub(crate) tally: Summary<F>,
    pub(crate) multipliers: [(F, F); 2],
    pub(crate) distance: (F, F),
    pub(crate) periods: F,
}

impl<F: Float> SteadyState<F> {
    /// The exact motion that the closed forms of the non-sticking cycle lead to: confirmed where they hold, from half a cycle
    /// of the motion itself.
    ///
    /// # Errors
    /// [`Error::Sticks`] never, since there is a cycle; as for [`Trajectory::new`].
    pub fn from_cycle(cycle: &Cycle<F>) -> Result<LongRun<F>, Error> {
        let ratios = resolved(cycle.ratios())?;
        let equation = Equation::new(ratios);
        let budget = Budget { half_turns: 0, most: 2 * u64::from(DEFAULT_BUDGET) };
        let (section, hint) = fastest_point(equation, cycle);
        if family::is_one(ratios) {
            return Ok(family::member(equation, section, hint, budget));
        }
        Ok(LongRun::shot(equation, section, hint, || None, budget))
    }

    /// Maximum displacement x/B; its phase is [`SteadyState::max_displacement_phase`].
    pub const fn max_displacement(&self) -> F {
        self.tally.max_x.value
    }

    /// Minimum displacement x/B.
    pub const fn min_displacement(&self) -> F {
        self.tally.min_x.value
    }

    /// Maximum velocity x′/(Bω_d).
    pub const fn max_velocity(&self) -> F {
        self.tally.max_v.value
    }

    /// Minimum velocity x′/(Bω_d).
    pub const fn min_velocity(&self) -> F {
        self.tally.min_v.value
    }

    /// Phase of the maximum displacement: where the body arrives at it.
    pub fn max_displacement_phase(&self) -> F {
        self.tally.max_x.phase.reduced()
    }

    /// Phase of the minimum displacement: where the body arrives at it.
    pub fn min_displacement_phase(&self) -> F {
        self.tally.min_x.phase.reduced()
    }

    /// Phase of the maximum velocity.
    pub fn max_velocity_phase(&self) -> F {
        self.tally.max_v.phase.reduced()
    }

    /// Phase of the minimum velocity.
    pub fn min_velocity_phase(&self) -> F {
        self.tally.min_v.phase.reduced()
    }

    /// Stops in a cycle.
    pub const fn sticks_per_cycle(&self) -> u32 {
        self.tally.sticks
    }

    /// Velocity zeros in a cycle: ends of slides. A stop counts once.
    pub const fn velocity_zeros_per_cycle(&self) -> u32 {
        self.tally.zeros
    }

    /// The part of a cycle that the body is at rest, in [0, 1).
    pub const fn stick_fraction(&self) -> F {
        self.tally.stick_fraction
    }

    /// Work of the drive in a cycle, `∮ p₀ sin ω_d t dx`, in r_y B: by its own closed form (except for |1 − Ω²| < 1/64),
    /// so that its agreement with [`SteadyState::energy_out`] is a check.
    pub const fn energy_in(&self) -> F {
        self.tally.energy_in
    }

    /// Work against friction in a cycle, `∮ r_y |dx|`, in r_y B: 4Δ₀/B where nothing but the extrema are reversals.
    pub const fn energy_out(&self) -> F {
        self.tally.energy_out
    }

    /// The multipliers of the cycle, each (re, im): what a small disturbance is multiplied by in one period. One is zero
    /// where the body stops.
    pub const fn multipliers(&self) -> [(F, F); 2] {
        self.multipliers
    }

    /// Contraction per cycle: the modulus of the larger multiplier.
    pub fn contraction(&self) -> F {
        let [(a, b), (c, d)] = self.multipliers;
        a.hypot(b).or_larger(c.hypot(d))
    }

    /// Bounds on how far the motion found is from the limit, (x/B, x′/(Bω_d)) at [`SteadyState::state`]: the residual of half a
    /// turn and its rounding, multiplied by what the map's contraction leaves of its resistance, `|(1 + M)⁻¹|`.
    pub fn distance(&self) -> (F, F) {
        let (x, w) = self.distance;
        (x, w / self.equation.omega)
    }

    /// Periods of the drive that were walked to find it.
    pub const fn periods(&self) -> F {
        self.periods
    }

    /// A state on the motion, from which [`Trajectory::new`] follows it.
    pub fn state(&self) -> State<F> {
        State { phase: self.start.phase, x: self.start.x, v: self.start.w / self.equation.omega }
    }

    /// The paper's error measures, over one cycle that is followed for the purpose: both halves on their own.
    pub fn errors(&self) -> ErrorMeasures<F> {
        error_measures(self.equation, &self.start)
    }
}

/// The error measures of the cycle that begins at a point.
fn error_measures<F: Float>(equation: Equation<F>, start: &Point<F>) -> ErrorMeasures<F> {
    let usual = F::pi() / equation.omega;
    let cycle = walk(equation, *start, 2, usual, Vec::new());
    Tally::of(start, equation.omega, &cycle.parts).errors()
}

/// The paper's error measures of a motion that has not settled: those of the first cycle after `cycles` of them from a start,
/// as in its Figure 3.
///
/// # Errors
/// As for [`Trajectory::new`].
pub fn errors_after<F: Float>(
    ratios: Ratios<F>,
    start: State<F>,
    cycles: u32,
) -> Result<ErrorMeasures<F>, Error> {
    let equation = Equation::new(trajectory::resolved(ratios)?);
    let usual = F::pi() / equation.omega;
    let mut point = Point { phase: start.phase, x: start.x, w: start.v * equation.omega };
    let mut parts = Vec::new();
    for _ in 0..cycles {
        let cycle = walk(equation, point, 2, usual, parts);
        (point, parts) = (cycle.end, cycle.parts);
    }
    Ok(error_measures(equation, &point))
}

/// Whether Ω is 1/(2n), to within the rounding of Ω.
pub(crate) fn is_even_subharmonic<F: Float>(omega: F) -> bool {
    PhaseFunction::of_valid(omega).is_even_subharmonic()
}
