//! The limit of a motion.

use super::irregular::Irregular;
use super::steady::SteadyState;
use crate::float::Float;
use crate::machine::ratios::Ratios;
use crate::motion::broken::Budget;
use crate::motion::slide::equation::Equation;
use crate::motion::state::{PhasePoint, State};

/// The limit of a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "F: Float + serde::Serialize",
        deserialize = "F: Float + serde::Deserialize<'de>"
    ))
)]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
#[must_use]
pub enum LongRun<F> {
    /// One periodic motion, symmetric and the same from every start (proved in docs/development/theory/stability.md).
    /// Where Ω is 1/(2n) to within rounding only, one multiplier rounds to 1: no start comes close to the
    /// limit within the lifetime of a machine.
    ///
    /// With a static friction above the kinetic one (η > 1) this is the limit of one start: other starts can
    /// have other limits, and the motion can be asymmetric or take several turns of the drive
    /// ([`SteadyState::turns_per_cycle`]).
    Periodic(SteadyState<F>),
    /// The member of a family of periodic motions to which this start leads: Ω = 1/(2n) exactly, without
    /// damping and without sticking.
    Family(SteadyState<F>),
    /// Rest: from every start where α ≤ 1, and from this start where 1 < α ≤ η.
    Rest(Rest<F>),
    /// η > 1: the motion from this start did not become periodic in the turns followed, and neighbours do not
    /// approach it.
    Irregular(Irregular<F>),
    /// Ω = 1 and α > 4/π without damping: no bounded motion. The amplitude grows by πα − 4 (in B) a cycle,
    /// once it is large.
    Unbounded {
        /// Growth of the maximum displacement in a cycle, in the limit.
        growth: F,
    },
    /// No limit within the budget: the state of the motion, and its change in half a cycle. This also occurs
    /// at Ω = 1/(2n) where friction is so small compared with the motion that the type cannot resolve the
    /// rate of convergence.
    NotConverged {
        /// The state at the end.
        state: State<F>,
        /// The change in half a cycle, `hypot(δx, δv Ω)`.
        residual: F,
        /// The number of periods of the drive that were followed.
        periods: F,
    },
}

/// The rest in which a motion ends.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Rest<F> {
    /// Position of rest x/B, `|x| ≤ η − α`.
    pub position: F,
    /// The number of slides until permanent rest; `None` if the body creeps for ever towards
    /// [`Rest::position`].
    pub slides: Option<u64>,
    /// The number of periods of the drive that were followed.
    pub periods: F,
}

impl<F: Float> LongRun<F> {
    /// The periodic motion, if the limit is one.
    pub const fn steady_state(&self) -> Option<&SteadyState<F>> {
        match self {
            Self::Periodic(steady) | Self::Family(steady) => Some(steady),
            Self::Rest(_) | Self::Irregular(_) | Self::Unbounded { .. } | Self::NotConverged { .. } => None,
        }
    }

    /// The number of periods of the drive for which the motion was followed; `None` for unbounded motion,
    /// which is known without following it.
    pub const fn periods(&self) -> Option<F> {
        match self {
            Self::Periodic(steady) | Self::Family(steady) => Some(steady.periods),
            Self::Rest(rest) => Some(rest.periods),
            Self::Irregular(motion) => Some(motion.periods),
            Self::Unbounded { .. } => None,
            Self::NotConverged { periods, .. } => Some(*periods),
        }
    }

    /// The position of rest, x/B; `None` for all other limits.
    pub(crate) const fn rest_position(&self) -> Option<F> {
        if let Self::Rest(rest) = self { Some(rest.position) } else { None }
    }

    /// The irregular motion, if the limit is one.
    pub(crate) const fn irregular(&self) -> Option<&Irregular<F>> {
        if let Self::Irregular(motion) = self { Some(motion) } else { None }
    }

    /// The minimum and the maximum displacement x/B of a moving limit, over a cycle or over the observed
    /// turns of an irregular motion.
    pub fn extrema(&self) -> Option<(F, F)> {
        let of_cycle =
            |steady: &SteadyState<F>| (steady.min_displacement.value, steady.max_displacement.value);
        let irregular = self.irregular().map(|motion| (motion.min_displacement, motion.max_displacement));
        irregular.or_else(|| self.steady_state().map(of_cycle))
    }
}

// For the programs of this repository.
#[doc(hidden)]
impl<F: Float> LongRun<F> {
    /// The name of this kind of limit, one of [`LongRun::NAMES`]: [`Display`](core::fmt::Display) as a static
    /// text.
    #[must_use]
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
}

/// Displays the kind of limit, as the command prints it.
impl<F: Float> core::fmt::Display for LongRun<F> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.pad(self.name())
    }
}

/// The number of periods of the drive for which a motion is followed by default.
pub const DEFAULT_BUDGET: u32 = 20_000;

/// The growth per cycle of a motion at Ω = 1 without damping, πα − 4, where it is above zero.
pub(crate) fn growth_at_resonance<F: Float>(ratios: &Ratios<F>) -> Option<F> {
    let growth = F::pi() * ratios.alpha() - F::int(4);
    (ratios.is_at_resonance() && growth > F::int(0)).then_some(growth)
}

/// [`LongRun::NotConverged`] with the state at a point.
pub(crate) fn unsettled<F: Float>(
    equation: &Equation<F>,
    y: &PhasePoint<F>,
    residual: F,
    budget: &Budget<'_>,
) -> LongRun<F> {
    LongRun::NotConverged { state: y.state(equation.omega), residual, periods: budget.periods() }
}
