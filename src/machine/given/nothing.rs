//! A friction or a drive of 0, which no ratio has.

use super::{Driven, Given};
use crate::float::Float;
use crate::machine::input::{Input, Role};
use crate::machine::oscillator::{Drive, Excitation};
use crate::machine::units::InputError;
use alloc::borrow::Cow;
use alloc::string::String;
use core::str::FromStr;

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

    /// These inputs with a friction or a drive far below the rounding of every motion in place of one of 0: without
    /// friction ε² p₀, and without a drive ε² r_y. Without both friction is that of a displacement ε⁴.
    ///
    /// # Errors
    /// As for [`Given::oscillator`].
    pub fn without_zeros(&self) -> Result<Cow<'_, Self>, InputError> {
        let nothing = Self::nothing();
        let drive = self.drive_of_zero();
        if !self.is_without_friction() && drive.is_none() {
            return Ok(Cow::Borrowed(self));
        }
        let mut given = self.clone();
        if self.is_without_friction() {
            given.replace_friction(F::int(1));
            let friction = if drive.is_none() {
                let Driven { drive, oscillator, .. } = given.driven()?;
                drive.force_amplitude(&oscillator)
            } else {
                given.oscillator()?.stiffness() * nothing
            };
            given.replace_friction(friction * nothing);
        }
        if let Some(input) = drive {
            let body = given.oscillator()?;
            let excitation = input.excitation().unwrap_or(Excitation::Force);
            let unit = Drive::new(excitation, F::int(1), given.frequency(&body)?);
            let unit = unit.map_err(|e| given.at_fault(&e))?.force_amplitude(&body);
            let amplitude = body.friction_bound() * nothing / unit;
            let label = given.own_label(input);
            given.put(input, amplitude, label);
        }
        Ok(Cow::Owned(given))
    }
}
