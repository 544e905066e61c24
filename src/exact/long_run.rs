//! What a motion tends to, by name.

use super::broken::Broken;
use super::equation::Equation;
use super::family;
use super::followed;
use super::irregular::Irregular;
use super::measures::CycleStatistics;
use super::rest::{Rest, come_to_rest};
use super::section::{Settled, cycle_guess, on_six_reversals, settle_in};
use super::shooting::{Budget, Guess, Shot, shoot};
use super::state::Point;
use super::state::State;
use super::steady::{SteadyState, Summary};
use super::stops::Sticking;
use super::trajectory::resolved;
use crate::error::Error;
use crate::float::Float;
use crate::nonsticking::{Cycle, SixReversals};
use crate::ratios::Ratios;
use core::ops::ControlFlow;

/// What a motion tends to.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(bound(serialize = "F: Float + serde::Serialize")))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
#[must_use]
pub enum LongRun<F> {
    /// One periodic motion, symmetric and the same from every start (proved in docs/theory/stability.md). Where Ω is 1/(2n) to within
    /// rounding only, one multiplier rounds to 1: no start comes close to the limit in any time that a machine runs.
    ///
    /// With a static friction above the kinetic one (η > 1) it is the limit of this start: others can have another, and it need not be
    /// symmetric nor take one turn of the drive only ([`SteadyState::turns_per_cycle`]).
    Periodic(SteadyState<F>),
    /// Ω = 1/(2n) exactly, without damping and without sticking: one of a family of periodic motions, the one that this start leads to.
    Family(SteadyState<F>),
    /// Rest: from every start where α ≤ 1, and from this one where 1 < α ≤ η.
    Rest(Rest<F>),
    /// η > 1: the motion from this start did not become periodic in the turns followed, and neighbours do not approach it.
    Irregular(Irregular<F>),
    /// Ω = 1 and α > 4/π without damping: no bounded motion. The amplitude grows by πα − 4 (in B) a cycle, once it is large.
    Unbounded {
        /// Growth of the maximum displacement in a cycle, in the limit.
        growth: F,
    },
    /// No limit within the budget: where the motion is, and how far half a cycle still takes it. So too at Ω = 1/(2n) where friction is
    /// so small beside the motion that the type cannot tell how fast it settles.
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
    /// With η = 1 the limit is the same from every start, but for a family and for rest, and a motion with stops is found from stop to stop without
    /// following this one.
    ///
    /// With η > 1 what is found holds for this start: a periodic motion of up to 64 turns of the drive (127, if it is symmetric), rest, or an irregular motion.
    ///
    /// # Errors
    /// As for [`super::Trajectory::new`].
    pub fn from_start(ratios: Ratios<F>, start: State<F>) -> Result<Self, Error> {
        Self::within(ratios, start, DEFAULT_BUDGET)
    }

    /// The same, following the motion for at most `periods` periods of the drive.
    ///
    /// # Errors
    /// As for [`super::Trajectory::new`].
    pub fn within(ratios: Ratios<F>, start: State<F>, periods: u32) -> Result<Self, Error> {
        Self::budgeted(ratios, start, Budget::of(2 * u64::from(periods)))
    }

    /// The same, as long as `keep_going` says [`ControlFlow::Continue`]: it is asked at every slide and stop, of which one takes
    /// about a microsecond at f64.
    ///
    /// ```
    /// use std::ops::ControlFlow;
    /// use stickslip::exact::{LongRun, State};
    /// use stickslip::{Error, Ratios};
    /// let mut slides = 0;
    /// let mut few = || { slides += 1; if slides < 1000 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) } };
    /// let limit = LongRun::within_while(Ratios::new(1e-5f64, 2.0)?, State::rest(), 100, &mut few);
    /// assert_eq!(limit, Err(Error::Interrupted));
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Interrupted`] where it breaks off, and as for [`super::Trajectory::new`].
    pub fn within_while(
        ratios: Ratios<F>,
        start: State<F>,
        periods: u32,
        keep_going: &mut dyn FnMut() -> ControlFlow<()>,
    ) -> Result<Self, Error> {
        Self::budgeted(ratios, start, Budget::of(2 * u64::from(periods)).with(keep_going))
    }

    fn budgeted(ratios: Ratios<F>, start: State<F>, mut budget: Budget<'_>) -> Result<Self, Error> {
        let ratios = resolved(ratios)?;
        let (one, alpha) = (F::int(1), ratios.alpha());
        if alpha <= one {
            return come_to_rest(ratios, start, &mut budget);
        }
        if ratios.has_higher_static_friction() {
            return followed::limit(ratios, start, &mut budget);
        }
        if ratios.omega() == one && F::pi() * alpha > F::int(4) && !ratios.is_damped() {
            return Ok(Self::Unbounded { growth: F::pi() * alpha - F::int(4) });
        }
        let equation = Equation::new(ratios);
        let sticking = Sticking::new(equation);
        let is_family = !sticking.is_below() && family::is_one(ratios);
        if sticking.is_below()
            && let Some(limit) = sticking.limit(&mut budget)?
        {
            return Ok(limit);
        }
        let at_stop = |budget: &mut Budget<'_>| {
            if sticking.is_open() { sticking.limit(budget) } else { Ok(None) }
        };
        let (section, hint) = match settle_in(equation, start, &mut budget, at_stop)? {
            Settled::Here(section, hint) => (section, hint),
            Settled::Known(limit) => return Ok(*limit),
        };
        if is_family {
            return family::member(equation, section, hint, budget);
        }
        let guess = || match Cycle::find(ratios) {
            Some(cycle) => Ok(Some(cycle_guess(equation, &cycle))),
            None => {
                // Below the border, of six reversals or with stops: then the limit is that from rest.
                let (at, hint) = match SixReversals::new(ratios) {
                    Some(cycle) => on_six_reversals(equation, &cycle),
                    None => match settle_in(equation, State::rest(), &mut Budget::of(0), |_| Ok(None))? {
                        Settled::Here(at, hint) => (at, hint),
                        Settled::Known(_) => return Ok(None),
                    },
                };
                Ok(Some(Guess { at, hint, is_limit: false }))
            }
        };
        Self::shot(equation, section, hint, guess, budget)
    }

    pub(crate) fn shot(
        equation: Equation<F>,
        section: Point<F>,
        hint: F,
        guess: impl FnOnce() -> Result<Option<Guess<F>>, Broken>,
        mut budget: Budget<'_>,
    ) -> Result<Self, Error> {
        match shoot(equation, section, hint, guess, &mut budget)? {
            Shot::Settled(fixed) => {
                let periods = F::from_f64(budget.half_turns as f64) / F::int(2);
                let multipliers = fixed.propagation.monodromy.squared_eigenvalues();
                let statistics =
                    CycleStatistics::of_periodic(equation, fixed.start, 1, &fixed.propagation, &mut budget)?
                        .doubled();
                Ok(Self::Periodic(SteadyState {
                    equation,
                    start: fixed.start,
                    half_turns: 1,
                    statistics: Summary::of(&statistics, 1),
                    multipliers,
                    distance: fixed.distance,
                    periods,
                }))
            }
            Shot::Unsettled(y, residual) => Ok(unsettled(&equation, &y, residual, &budget)),
        }
    }

    /// The periodic motion, where there is one.
    pub const fn steady_state(&self) -> Option<&SteadyState<F>> {
        match self {
            Self::Periodic(steady) | Self::Family(steady) => Some(steady),
            Self::Rest(_) | Self::Irregular(_) | Self::Unbounded { .. } | Self::NotConverged { .. } => None,
        }
    }

    /// What kind of limit it is, as the command prints it: one of [`LongRun::NAMES`].
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Periodic(_) => Self::NAMES[0],
            Self::Family(_) => Self::NAMES[1],
            Self::Rest(_) => Self::NAMES[2],
            Self::Irregular(_) => Self::NAMES[3],
            Self::Unbounded { .. } => Self::NAMES[4],
            Self::NotConverged { .. } => Self::NAMES[5],
        }
    }

    /// The names of all kinds of limit.
    pub const NAMES: [&'static str; 6] = ["periodic", "family", "rest", "irregular", "none", "not-converged"];

    /// Periods of the drive that the motion was followed for; `None` where it grows without bound, which takes none.
    pub const fn periods(&self) -> Option<F> {
        match self {
            Self::Periodic(steady) | Self::Family(steady) => Some(steady.periods()),
            Self::Rest(rest) => Some(rest.periods),
            Self::Irregular(motion) => Some(motion.periods),
            Self::Unbounded { .. } => None,
            Self::NotConverged { periods, .. } => Some(*periods),
        }
    }

    /// Where it comes to rest, x/B; `None` for all other limits.
    pub const fn rest_position(&self) -> Option<F> {
        if let Self::Rest(rest) = self { Some(rest.position) } else { None }
    }

    /// The irregular motion, where it is one.
    pub const fn irregular(&self) -> Option<&Irregular<F>> {
        if let Self::Irregular(motion) = self { Some(motion) } else { None }
    }

    /// The least and the greatest displacement x/B of a limit that moves: of a cycle, or of the turns of an irregular motion that were
    /// observed.
    pub fn extrema(&self) -> Option<(F, F)> {
        let of_cycle = |steady: &SteadyState<F>| (steady.min_displacement(), steady.max_displacement());
        let irregular = self.irregular().map(|motion| (motion.min_displacement, motion.max_displacement));
        irregular.or_else(|| self.steady_state().map(of_cycle))
    }
}

/// Periods of the drive that a motion is followed for unless said otherwise.
pub const DEFAULT_BUDGET: u32 = 20_000;

/// [`LongRun::NotConverged`] at a point.
pub(crate) fn unsettled<F: Float>(
    equation: &Equation<F>,
    y: &Point<F>,
    residual: F,
    budget: &Budget<'_>,
) -> LongRun<F> {
    LongRun::NotConverged {
        state: State { phase: y.phase, x: y.x, v: y.w / equation.omega },
        residual,
        periods: F::from_f64(budget.half_turns as f64) / F::int(2),
    }
}

#[cfg(test)]
mod tests {
    use super::LongRun;
    use crate::exact::State;
    use crate::{Border, Ratios};

    /// The periods followed over a grid of ratios and starts: a choice on the way to the limit that is of no use costs more.
    #[test]
    fn the_way_to_the_limit_is_short() {
        let (mut periods, mut most) = (0.0, 0.0f64);
        for i in 0..400u32 {
            let spread = |step: f64| (f64::from(i) * step).fract();
            let omega = 10f64.powf(2.0 * spread(0.618_034) - 1.3);
            let alpha = 1.05 + 2.0 * spread(0.754_878) * Border::new(omega).unwrap().min_force_ratio();
            let ratios = Ratios::new(omega, alpha).unwrap();
            let far = State::new(7.0 * spread(0.569_840), 3.0 * alpha, -2.0 * alpha / omega).unwrap();
            for start in [State::rest(), far] {
                let limit = LongRun::from_start(ratios, start).unwrap();
                let Some(steady) = limit.steady_state() else { panic!("{omega} {alpha} {limit:?}") };
                (periods, most) = (periods + steady.periods(), most.max(steady.periods()));
            }
        }
        // 4.33 a start.
        assert!(periods <= 3490.0 && most <= 44.0, "{periods} {most}");
    }
}
