//! A friction or a drive of 0, which no ratio has.

use super::Given;
use crate::inputs::input::{Input, Role};
use crate::inputs::units::InputError;
use std::borrow::Cow;
use std::str::FromStr;
use stickslip::{Drive, Float, Oscillator};

impl<F: Float + FromStr> Given<F> {
    /// ε²: what takes the place of a 0, as a share far below the rounding of every motion.
    #[must_use]
    pub fn nothing() -> F {
        F::epsilon().square()
    }

    /// A friction that was computed, 0 where it is given as 0.
    pub fn friction_as_given(&self, computed: F) -> F {
        if self.is_without_friction() { F::int(0) } else { computed }
    }

    /// An amplitude of the drive that was computed, 0 where it is given as 0.
    pub fn drive_as_given(&self, computed: F) -> F {
        if self.is_without_drive() { F::int(0) } else { computed }
    }

    /// The input of a role that is given, the first if there are several.
    pub fn first_of(&self, role: Role) -> Option<Input> {
        Input::of_role(role).into_iter().find(|input| self.has(*input))
    }

    /// The words for an input, where it has words of its own.
    fn own_label(&self, input: Input) -> Option<String> {
        self.values.iter().find(|(own, ..)| *own == input)?.2.clone()
    }

    /// Puts a friction in the place of the given one, in both directions, under the words of that one.
    pub fn replace_friction(&mut self, friction: F) {
        self.take(Input::FrictionBackward);
        let input = self.first_of(Role::Friction);
        let label = input.and_then(|input| self.own_label(input));
        input.map(|input| self.take(input));
        // Gravity of a coefficient of friction has no other use.
        if !(self.has(Input::PendulumRadius) || self.has(Input::Weight)) {
            self.take(Input::Gravity);
        }
        self.put(Input::Friction, friction, label);
    }

    /// Whether friction is given as 0, in both directions.
    pub fn is_without_friction(&self) -> bool {
        let is_zero = |input: Input| self.get(input) == Some(F::int(0));
        Input::of_role(Role::Friction).into_iter().any(is_zero)
            && (!self.has(Input::FrictionBackward) || is_zero(Input::FrictionBackward))
    }

    /// Whether the amplitude of the drive is given as 0, other than by α.
    pub fn is_without_drive(&self) -> bool {
        self.drive_of_zero().is_some()
    }

    fn drive_of_zero(&self) -> Option<Input> {
        let is_zero = |input: &Input| *input != Input::Alpha && self.get(*input) == Some(F::int(0));
        Input::of_role(Role::Drive).into_iter().find(is_zero)
    }

    /// These inputs with a friction or a drive far below the rounding of every motion in place of one of 0
    /// ([`in_place_of_zeros`]).
    ///
    /// # Errors
    /// As for [`Given::oscillator`].
    pub fn without_zeros(&self) -> Result<Cow<'_, Self>, InputError> {
        let (is_free, still) = (self.is_without_friction(), self.drive_of_zero());
        if !is_free && still.is_none() {
            return Ok(Cow::Borrowed(self));
        }
        let mut given = self.clone();
        if self.is_without_spring() {
            self.check_without_spring()?;
        }
        if is_free {
            given.replace_friction(F::int(1));
        }
        if let Some(input) = still {
            given.put(input, F::int(1), given.own_label(input));
        }
        let body = given.oscillator()?;
        let drive = given.drive(&body, given.frequency(&body)?)?;
        let (friction, amplitude) = in_place_of_zeros(&body, &drive, is_free, still.is_some());
        if is_free {
            given.replace_friction(friction);
        }
        if let Some(input) = still {
            given.put(input, amplitude, given.own_label(input));
        }
        Ok(Cow::Owned(given))
    }
}

/// The friction r_y and the amplitude of the drive where that of a body without friction, or of one that nothing drives, is 0:
/// without friction ε² p₀, and without a drive that of a force ε² r_y. Without both, friction is that of a displacement ε⁴.
///
/// The body and the drive have 1 in place of what is 0.
pub fn in_place_of_zeros<F: Float>(
    body: &Oscillator<F>,
    drive: &Drive<F>,
    is_free: bool,
    is_still: bool,
) -> (F, F) {
    let (nothing, force) = (F::epsilon().square(), drive.force_amplitude(body));
    let driving = if is_still { body.stiffness() * nothing } else { force };
    let friction = if is_free { driving * nothing } else { body.friction_bound() };
    (friction, if is_still { friction * nothing / force } else { drive.amplitude() })
}
