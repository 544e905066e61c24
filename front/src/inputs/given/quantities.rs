//! What is known of a machine in units: the given quantities, and those that follow from them.

use super::{Driven, Given};
use crate::inputs::input::{Input, Role};
use crate::inputs::units::Kind;
use std::str::FromStr;
use stickslip::{Excitation, Float};

impl<F: Float + FromStr> Given<F> {
    /// The quantities of a machine that these inputs give, with their names and kinds. A friction or a drive that is given as
    /// 0 is 0 here; a friction that differs by direction is the one against forward motion, followed by the other and by the
    /// bound of both.
    pub fn quantities(&self, machine: &Driven<F>) -> Vec<(&'static str, Kind, F)> {
        let Driven { oscillator, drive, scales, .. } = machine;
        let p0 = self.drive_as_given(drive.force_amplitude(oscillator));
        let mut all = Vec::new();
        let mut add = |name, kind, value| all.push((name, kind, value));
        let turn = F::int(2) * F::pi();
        add("frequency", Kind::Hertz, drive.angular_frequency() / turn);
        add("angular_frequency", Kind::Frequency, drive.angular_frequency());
        let has_spring = !self.is_without_spring();
        if has_spring {
            add("natural_frequency", Kind::Frequency, oscillator.natural_frequency());
            add("period", Kind::Time, turn / oscillator.natural_frequency());
        }
        add("mass", Kind::Mass, oscillator.mass());
        add("stiffness", Kind::Stiffness, if has_spring { oscillator.stiffness() } else { F::int(0) });
        match self.directional_friction() {
            Ok(Some((forward, backward))) => {
                add("friction", Kind::Force, forward);
                add("friction_backward", Kind::Force, backward);
                add("friction_bound", Kind::Force, oscillator.friction_bound());
            }
            _ => add("friction", Kind::Force, self.friction_as_given(oscillator.friction_bound())),
        }
        if let Some(coefficient) = self.get(Input::FrictionCoefficient) {
            add("friction_coefficient", Kind::Ratio, coefficient);
        }
        if self.has_role(Role::Damper) {
            add("damping", Kind::Damping, oscillator.damping());
        }
        if self.has_role(Role::StaticFriction) {
            let ratio = oscillator.static_friction_ratio();
            add("static_friction", Kind::Force, ratio * oscillator.friction_bound());
        }
        add("force_amplitude", Kind::Force, p0);
        let amplitude = self.drive_as_given(drive.amplitude());
        match drive.excitation() {
            Excitation::Unbalance => add("unbalance", Kind::Unbalance, amplitude),
            Excitation::FootMotion => add("foot_displacement", Kind::Length, amplitude),
            Excitation::DampedFootMotion => {
                add("damped_foot_displacement", Kind::Length, amplitude);
                add("lead_time", Kind::Time, drive.phase_lead(oscillator) * scales.time);
            }
            excitation if excitation.carries_surface() => {
                let acceleration = p0 / oscillator.mass();
                add("base_displacement", Kind::Length, acceleration * scales.time.square());
                add("base_velocity", Kind::Velocity, acceleration * scales.time);
                add("base_acceleration", Kind::Acceleration, acceleration);
            }
            _ => {}
        }
        if has_spring {
            add("friction_displacement", Kind::Length, self.friction_as_given(scales.length));
        }
        if let Some(mean_force) = self.get(Input::MeanForce) {
            add("mean_force", Kind::Force, mean_force);
        }
        if self.is_shifted() && has_spring {
            add("mean_displacement", Kind::Length, scales.mean_displacement);
        }
        all
    }
}
