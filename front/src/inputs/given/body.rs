//! The body that a record moves.

use super::Given;
use crate::inputs::input::{Input, Role};
use crate::inputs::units::InputError;
use std::str::FromStr;
use stickslip::internal::non_negative;
use stickslip::motion::record::Body;
use stickslip::{Error, Float, Number, Quantity};

impl<F: Float + FromStr> Given<F> {
    /// The body of the given inputs: the mass, the friction, and where they are given the spring, the damper, static
    /// friction and a constant force. With `slope` it lies on a surface that falls in the direction of x by this angle:
    /// gravity along the slope is a constant force, and a coefficient of friction is of the force across it. A yield
    /// acceleration, which includes the slope, is in place of the friction.
    ///
    /// # Errors
    /// Where an input is missing, wrong or superfluous: a damping ratio without a spring, an angle beyond ±90°, a yield
    /// acceleration beside a friction or a slope.
    pub fn body(&self, slope: Option<F>) -> Result<Body<F>, InputError> {
        let wrong = |error: Error| self.at_fault(&error);
        let mass = self.mass()?;
        let friction = match self.get(Input::YieldAcceleration) {
            Some(yields) => {
                let label = self.label(Input::YieldAcceleration);
                if let Some((other, _)) = self.one_of(Role::Friction)? {
                    return Err(InputError(format!("{label}: must be left out with {}", self.label(other))));
                }
                if slope.is_some() {
                    return Err(InputError(format!(
                        "{label}: must be left out with a slope, which it includes"
                    )));
                }
                let yields = non_negative(Quantity::YieldAcceleration, yields);
                mass * yields.map_err(|error| InputError(format!("{label}: {error}")))?
            }
            None => self.friction()?.ok_or_else(|| self.missing(&Input::of_role(Role::Friction)))?,
        };
        let (sine, cosine) = match slope {
            Some(angle) if angle.abs() < F::pi() * F::ratio(1, 2) => angle.sin_cos(),
            Some(angle) => {
                let degrees = Number::from(angle * F::int(180) / F::pi());
                return Err(InputError(format!("slope = {degrees}°: must be > -90° and < 90°")));
            }
            None => (F::int(0), F::int(1)),
        };
        let across = if self.has(Input::FrictionCoefficient) { cosine } else { F::int(1) };
        let mut body = Body::new(mass, friction * across).map_err(wrong)?;
        if let Some(backward) = self.get(Input::FrictionBackward) {
            body = body.with_directional_friction(body.friction(), backward).map_err(wrong)?;
        }
        if let Some(stiffness) = self.stiffness()? {
            body = body.with_stiffness(stiffness).map_err(wrong)?;
        }
        if let Some((input, value)) = self.one_of(Role::Damper)? {
            let damping = if input == Input::Damping {
                value
            } else if body.stiffness() > F::int(0) {
                body.with_damping_ratio(value).map_err(wrong)?.damping()
            } else {
                return Err(InputError(format!(
                    "{}: a body without a spring has no critical damping. Give its damping constant",
                    self.label(input)
                )));
            };
            body = body.with_damping(damping).map_err(wrong)?;
        }
        if let Some((input, value)) = self.one_of(Role::StaticFriction)? {
            let ratio = if input == Input::StaticFriction { value / body.friction() } else { value };
            body = body.with_static_friction_ratio(ratio).map_err(wrong)?;
        }
        let along = if slope.is_some() { mass * self.gravity()? * sine } else { F::int(0) };
        body.with_mean_force(self.get(Input::MeanForce).unwrap_or(F::int(0)) + along).map_err(wrong)
    }
}
