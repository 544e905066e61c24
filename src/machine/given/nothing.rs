//! A friction or a drive of 0, which no ratio has.

use super::{Driven, Given};
use crate::float::Float;
use crate::machine::input::{Input, Role};
use crate::machine::oscillator::{Drive, Excitation};
use crate::machine::units::InputError;
use alloc::borrow::Cow;
use core::str::FromStr;

impl<F: Float + FromStr> Given<F> {
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
        let nothing = F::epsilon().square();
        let drive = self.drive_of_zero();
        if !self.is_without_friction() && drive.is_none() {
            return Ok(Cow::Borrowed(self));
        }
        let mut given = self.clone();
        if self.is_without_friction() {
            given.take(Input::FrictionBackward);
            let label = Input::of_role(Role::Friction).into_iter().find(|input| self.has(*input));
            let label = label.and_then(|input| {
                given.take(input);
                self.values.iter().find(|(own, ..)| *own == input)?.2.clone()
            });
            // Gravity of a coefficient of friction has no other use.
            if !(self.has(Input::PendulumRadius) || self.has(Input::Weight)) {
                given.take(Input::Gravity);
            }
            given.put(Input::Friction, F::int(1), label.clone());
            let friction = if drive.is_none() {
                let Driven { drive, oscillator, .. } = given.driven()?;
                drive.force_amplitude(&oscillator)
            } else {
                given.oscillator()?.stiffness() * nothing
            };
            given.put(Input::Friction, friction * nothing, label);
        }
        if let Some(input) = drive {
            let body = given.oscillator()?;
            let excitation = input.excitation().unwrap_or(Excitation::Force);
            let unit = Drive::new(excitation, F::int(1), given.frequency(&body)?);
            let unit = unit.map_err(|e| given.at_fault(&e))?.force_amplitude(&body);
            let amplitude = body.friction_bound() * nothing / unit;
            let label =
                given.values.iter().find(|(own, ..)| *own == input).and_then(|(.., text)| text.clone());
            given.put(input, amplitude, label);
        }
        Ok(Cow::Owned(given))
    }
}
