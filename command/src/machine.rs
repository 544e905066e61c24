//! A machine in physical units, for the answers.

use crate::bits::Value;
use stickslip::inputs::units::System;
use stickslip::{Drive, Excitation, Oscillator, Scales};

/// A machine in physical units and the scale of its answers.
pub(crate) struct Machine<F> {
    pub(crate) oscillator: Oscillator<F>,
    pub(crate) drive: Drive<F>,
    pub(crate) scales: Scales<F>,
    pub(crate) system: System,
    /// Whether damping was given, even if zero.
    pub(crate) has_damper: bool,
    /// Whether static friction was given, even if equal to the kinetic one.
    pub(crate) has_static_friction: bool,
    /// The friction against forward and against backward motion, if they were given apart.
    pub(crate) directional_friction: Option<(F, F)>,
    /// The constant force, if it was given, even if zero.
    pub(crate) mean_force: Option<F>,
    /// The coefficient of friction, if friction was given by it.
    pub(crate) friction_coefficient: Option<F>,
}

impl<F> Machine<F> {
    /// Whether the damper stands on the spring's moving foot. The heat of the damper is then not the work of
    /// `c x′`, and the work of the foot is not that of p: neither is known here.
    pub(crate) fn has_damped_foot(&self) -> bool
    where
        F: Value,
    {
        self.drive.excitation() == Excitation::DampedFootMotion
    }

    /// The name of a displacement, which in a shifted motion is measured from the mean.
    pub(crate) const fn displacement(&self) -> &'static str {
        if self.is_shifted() { "displacement from the mean" } else { "displacement" }
    }

    /// Whether a constant force or backward friction was given, which shift the motion.
    pub(crate) const fn is_shifted(&self) -> bool {
        self.mean_force.is_some() || self.directional_friction.is_some()
    }
}

/// The excitation of a machine, or of ratios alone: a force.
pub(crate) fn excitation<F: Value>(machine: Option<&Machine<F>>) -> Excitation {
    machine.map_or(Excitation::Force, |machine| machine.drive.excitation())
}
