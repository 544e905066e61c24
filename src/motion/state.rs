//! The state of the body, and the forces on it.

use super::drive_phase::DrivePhase;
use crate::float::Float;
use crate::machine::error::{Error, Quantity, written};
use crate::machine::ratios::finite;

/// The state of the body at one phase of the drive: x in units of B = r_y/k, v in units of B ω_d.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(
        try_from = "crate::serialized::StateFields<F>",
        bound(deserialize = "F: Float + serde::Deserialize<'de>")
    )
)]
pub struct State<F> {
    /// Phase θ = ω_d t.
    pub phase: DrivePhase<F>,
    /// Displacement x/B.
    pub x: F,
    /// Velocity x′/(Bω_d).
    pub v: F,
}

impl<F: Float> State<F> {
    /// The displacement x/B and the velocity x′/(Bω_d) at the phase θ. A speed below 2⁻ᵉ, e =
    /// [`Float::RATIO_EXPONENT`], counts as rest, because the slide would end after a time that underflows.
    ///
    /// # Errors
    /// Where θ, x or v is not finite, θ is too large for its digits, or |x| or |v| is above 2ᵉ, e =
    /// [`Float::RATIO_EXPONENT`].
    pub fn new(theta: F, x: F, v: F) -> Result<Self, Error> {
        let bounded = |quantity, value: F| {
            let most = F::exp2i(F::RATIO_EXPONENT);
            let value = finite(quantity, value)?;
            if value.abs() <= most {
                return Ok(value);
            }
            Err(Error::OutOfRange {
                quantity,
                value: written(value),
                least: written(-most),
                greatest: written(most),
            })
        };
        Ok(Self {
            phase: DrivePhase::of(theta)?,
            x: bounded(Quantity::Displacement, x)?,
            v: moving(bounded(Quantity::Velocity, v)?),
        })
    }
}

/// At rest at x = 0 and θ = 0.
impl<F: Float> Default for State<F> {
    fn default() -> Self {
        let zero = F::int(0);
        Self { phase: DrivePhase::of_half_turn(0, zero), x: zero, v: zero }
    }
}

/// A point of the motion: displacement x/B and velocity `w = Ωv` at a phase of the drive.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(bound(deserialize = "F: Float + serde::Deserialize<'de>")))]
pub(crate) struct PhasePoint<F> {
    pub(crate) phase: DrivePhase<F>,
    pub(crate) x: F,
    pub(crate) w: F,
}

impl<F: Float> PhasePoint<F> {
    /// The point of a state, at the frequency ratio Ω.
    pub(crate) fn of(state: &State<F>, omega: F) -> Self {
        Self { phase: state.phase, x: state.x, w: state.v * omega }
    }

    /// The state of this point, at the frequency ratio Ω.
    pub(crate) fn state(&self, omega: F) -> State<F> {
        State { phase: self.phase, x: self.x, v: self.w / omega }
    }

    /// The opposite point, half a turn of the drive later.
    pub(crate) fn mirrored(&self) -> Self {
        Self { phase: self.phase.later_by_half_turns(1), x: -self.x, w: -self.w }
    }
}

/// The motion at one instant: state, acceleration, forces. Forces in units of r_y.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(bound(deserialize = "F: Float + serde::Deserialize<'de>")))]
#[non_exhaustive]
pub struct Instant<F> {
    /// Phase, displacement and velocity.
    pub state: State<F>,
    /// Acceleration `x″/(Bω_d²)`.
    pub acceleration: F,
    /// Friction force `r_a/r_y`: ±1 in the direction of sliding, or the holding force at rest, within ±η.
    /// Together with x/B it is the constitutive force r/r_y of eq. 1. The force on the body is its opposite.
    pub friction: F,
}

/// `v`, or rest if it is negligible.
fn moving<F: Float>(v: F) -> F {
    if v.abs() < F::least_ratio() { F::int(0) } else { v }
}
