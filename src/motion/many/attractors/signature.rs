//! Signatures that distinguish limits.

use crate::float::Float;
use crate::machine::error::Error;
use crate::motion::broken::Budget;
use crate::motion::drive_phase::DrivePhase;
use crate::motion::limit::fixed_point::{Located, Trial};
use crate::motion::limit::long_run::LongRun;
use crate::motion::limit::steady::SteadyState;
use crate::motion::state::PhasePoint;
use crate::motion::trajectory::Trajectory;

/// The signature of a limit: it identifies the limit but does not describe the motion. A signature that was
/// written and read again represents a limit found earlier ([`super::Attractors::count`]).
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Signature<F> {
    /// A periodic motion, by its state at a phase 2nπ of the drive.
    Periodic {
        /// The number of half turns of the drive after which the state repeats, with the opposite sign if
        /// odd.
        half_turns: u32,
        /// Displacement x/B.
        x: F,
        /// Velocity x′/(Bω_d).
        v: F,
        /// Estimated distance of x and v from the limit ([`SteadyState::distance`]).
        distance: (F, F),
    },
    /// A member of a family, by the middle of its displacements x/B.
    Family {
        /// Half the sum of its extrema.
        middle: F,
    },
    /// Rest.
    Rest {
        /// Position of rest x/B.
        position: F,
    },
    /// An irregular motion, by its extrema x/B.
    Irregular {
        /// The peak displacement.
        max_displacement: F,
        /// The minimum displacement.
        min_displacement: F,
    },
    /// Growth without bound.
    Unbounded,
    /// No limit: the start had not settled.
    NotConverged,
}

impl<F: Float> Signature<F> {
    /// The signature of a limit.
    ///
    /// # Errors
    /// As for [`Trajectory::new`].
    pub fn of(limit: &LongRun<F>) -> Result<Self, Error> {
        Ok(match limit {
            LongRun::Periodic(steady) => {
                let Located { at, off } = at_zero(steady)?;
                let omega = steady.equation.omega;
                Self::Periodic {
                    half_turns: steady.half_turns(),
                    x: at.x,
                    v: at.w / omega,
                    distance: (off.0, off.1 / omega),
                }
            }
            LongRun::Family(member) => {
                let sum = member.max_displacement.value + member.min_displacement.value;
                Self::Family { middle: sum / F::int(2) }
            }
            LongRun::Rest(rest) => Self::Rest { position: rest.position },
            LongRun::Irregular(motion) => Self::Irregular {
                max_displacement: motion.max_displacement,
                min_displacement: motion.min_displacement,
            },
            LongRun::Unbounded { .. } => Self::Unbounded,
            LongRun::NotConverged { .. } => Self::NotConverged,
        })
    }

    /// The position of rest, or the middle of a member of a family.
    pub(super) const fn middle(&self) -> Option<F> {
        match self {
            Self::Rest { position: x } | Self::Family { middle: x } => Some(*x),
            Self::Periodic { .. } | Self::Irregular { .. } | Self::Unbounded | Self::NotConverged => None,
        }
    }
}

/// The state of a periodic motion at the next phase 2nπ. It does not depend on the phase at which the motion
/// was found; after an odd number of half turns the state would be that of the mirror image.
pub(crate) fn at_zero<F: Float>(steady: &SteadyState<F>) -> Result<Located<F>, Error> {
    let (x, v) = state_at_zero(steady)?;
    let phase = DrivePhase::of_half_turn(0, F::int(0));
    let y = PhasePoint { phase, x, w: v * steady.equation.omega };
    Ok(Trial::at(steady.equation, y, steady.half_turns(), &mut Budget::of(0))?.located())
}

/// x/B and x′/(Bω_d) at the next phase 2nπ.
fn state_at_zero<F: Float>(steady: &SteadyState<F>) -> Result<(F, F), Error> {
    let (start, zero) = (steady.state, F::int(0));
    let angle = start.phase.angle();
    if angle == zero && start.phase.is_even() {
        return Ok((start.x, start.v));
    }
    let next = DrivePhase::of_half_turn(start.phase.half_turns(), zero)
        .later_by_half_turns(i64::from(angle >= zero));
    let target = next.later_by_half_turns(i64::from(!next.is_even()));
    for phase in Trajectory::of(steady.equation, start) {
        let phase = phase?;
        if phase.end().is_none_or(|end| target.since(end.phase) <= zero) {
            let state = phase.at(target).state;
            return Ok((state.x, state.v));
        }
    }
    Ok((start.x, zero))
}
