//! From the given quantities to the library's oscillator, drive and ratios.

use crate::bits::Value;
use crate::failure::Failure;
use crate::given::{Given, Parameter as P};
use stickslip::units::System;
use stickslip::{Drive, Error, Excitation, Oscillator, Ratios, Scales};

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
    /// Whether the damper stands on the spring's moving foot. Its heat is then not the work of `c x′`, and the
    /// foot's work not that of p: neither is known here.
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

/// The transmitted force in r_y and the transmissibility of a machine, from those of a body under a force.
pub(crate) fn transmitted<F: Value>(
    machine: Option<&Machine<F>>,
    ratios: &Ratios<F>,
    force: F,
    acceleration: F,
) -> (F, F) {
    let excitation = machine.map_or(Excitation::Force, |m| m.drive.excitation());
    excitation.transmitted(ratios, force, acceleration)
}

/// The kind of base motion, and the meaning of x; `None` for a force.
pub(crate) const fn base_motion(excitation: Excitation) -> Option<&'static str> {
    match excitation {
        Excitation::Force => None,
        Excitation::FootMotion => {
            Some("of the spring's foot over a fixed surface: p₀ = k u₀, x over the surface")
        }
        Excitation::DampedFootMotion => Some(
            "of the foot of spring and damper over a fixed surface: p₀ = √(k² + c²ω_d²) u₀, x over the surface",
        ),
        // The library may add kinds of motion of a base that carries the surface.
        Excitation::SurfaceMotion | Excitation::SurfaceVelocity | Excitation::SurfaceAcceleration | _ => {
            Some("of a base that carries the surface: p₀ = m ω_d² u₀, x relative to the base")
        }
    }
}

impl<F: Value> Given<F> {
    pub(crate) fn mass(&self) -> Result<F, Failure> {
        self.required(P::Mass).map_err(|missing| self.in_units_beside_ratios().unwrap_or(missing))
    }

    /// The stiffness, given directly or by the natural period; `None` where neither is given.
    pub(crate) fn stiffness(&self) -> Result<Option<F>, Failure> {
        Ok(match self.one_of(&[P::Stiffness, P::Period])? {
            Some((P::Period, period)) => {
                let natural = F::int(2) * F::pi() / self.positive(P::Period, period)?;
                Some(self.mass()? * natural.square())
            }
            Some((_, stiffness)) => Some(stiffness),
            None => None,
        })
    }

    /// The friction bound, given directly or as µ m g; `None` where neither is given.
    pub(crate) fn friction(&self) -> Result<Option<F>, Failure> {
        let found = self.one_of(&[P::Friction, P::FrictionCoefficient])?;
        if let Some((P::FrictionCoefficient, coefficient)) = found {
            let weight = self.mass()? * self.gravity()?;
            return Ok(Some(self.positive(P::FrictionCoefficient, coefficient)? * weight));
        }
        if self.has(P::Gravity) {
            return Err(Failure::Input(
                "--gravity: must be left out without --friction-coefficient".to_owned(),
            ));
        }
        Ok(found.map(|(_, friction)| friction))
    }

    pub(crate) fn gravity(&self) -> Result<F, Failure> {
        self.get(P::Gravity).map_or_else(|| Ok(self.system.gravity()), |g| self.positive(P::Gravity, g))
    }

    /// The body, whose stiffness may follow from Ω and the frequency of the drive. Two of Ω, the frequency and
    /// the spring are given.
    pub(crate) fn oscillator(&self) -> Result<Oscillator<F>, Failure> {
        let mass = self.mass()?;
        let missing = |names: &str| Failure::Input(format!("{names} is missing"));
        let friction = self.friction()?.ok_or_else(|| missing("--friction (or --friction-coefficient)"))?;
        let spring = self.one_of(&[P::Stiffness, P::Period])?.map(|(parameter, _)| parameter.option());
        match (self.get(P::Omega), self.get(P::Frequency), spring) {
            (Some(_), Some(_), Some(spring)) => {
                return Err(Failure::Input(format!(
                    "--omega, --frequency and {spring}: give two of the three, because they determine the third"
                )));
            }
            (Some(omega), Some(frequency), None) => Oscillator::tuned(mass, friction, frequency, omega),
            (Some(_), None, None) => return Err(missing("--frequency (or --stiffness, or --period)")),
            (_, _, Some(_)) => {
                let stiffness = self.stiffness()?.unwrap_or(F::int(0));
                Oscillator::new(mass, stiffness, friction)
            }
            (None, _, None) => return Err(missing("--stiffness (or --period, or --omega)")),
        }
        .map_err(|e| self.at_fault(e))
        .and_then(|body| self.with_damper(body))
    }

    /// The frequency of the drive, given directly or as Ω ω_n of a body with a spring.
    pub(crate) fn frequency(&self, body: &Oscillator<F>) -> Result<F, Failure> {
        match (self.get(P::Frequency), self.get(P::Omega)) {
            (None, Some(omega)) => {
                let omega = self.positive(P::Omega, omega)?;
                Ok(omega * body.natural_frequency())
            }
            _ => self.required(P::Frequency),
        }
    }

    /// The body with its damper, its backward friction and its static friction, if given.
    pub(crate) fn with_damper(&self, body: Oscillator<F>) -> Result<Oscillator<F>, Failure> {
        self.one_of(&P::STATIC_FRICTIONS)?;
        let body = match self.get(P::FrictionBackward) {
            Some(backward) => body.with_directional_friction(body.friction_bound(), backward),
            None => Ok(body),
        }
        .map_err(|e| self.at_fault(e))?;
        match self.one_of(&P::DAMPERS)? {
            Some((P::Damping, damping)) => body.with_damping(damping),
            Some((_, ratio)) => body.with_damping_ratio(ratio),
            None => Ok(body),
        }
        .and_then(|body| self.with_static_friction(body))
        .map_err(|e| self.at_fault(e))
    }

    /// The body with its static friction, if given.
    fn with_static_friction(&self, body: Oscillator<F>) -> Result<Oscillator<F>, Error> {
        match (self.get(P::StaticFrictionRatio), self.get(P::StaticFriction)) {
            (Some(ratio), _) => body.with_static_friction_ratio(ratio),
            (None, Some(force)) => body.with_static_friction(force),
            (None, None) => Ok(body),
        }
    }

    /// Whether static friction is given, even if equal to the kinetic one.
    pub(crate) fn has_static_friction(&self) -> bool {
        P::STATIC_FRICTIONS.into_iter().any(|p| self.has(p))
    }

    /// Whether damping is given, even if zero.
    pub(crate) fn has_damper(&self) -> bool {
        P::DAMPERS.into_iter().any(|p| self.has(p))
    }

    /// The excitation and its amplitude.
    pub(crate) fn drive(&self, body: &Oscillator<F>, frequency: F) -> Result<Drive<F>, Failure> {
        let Some((parameter, amplitude)) = self.one_of(&P::DRIVES)? else {
            return Err(Failure::Input(
                "--force (or --base-acceleration, --base-velocity, --base-displacement, --foot-displacement, \
                 --damped-foot-displacement, --alpha) is missing"
                    .to_owned(),
            ));
        };
        let excitation = if parameter == P::FootDisplacement {
            Excitation::FootMotion
        } else if parameter == P::DampedFootDisplacement {
            Excitation::DampedFootMotion
        } else if parameter == P::BaseAcceleration {
            Excitation::SurfaceAcceleration
        } else if parameter == P::BaseVelocity {
            Excitation::SurfaceVelocity
        } else if parameter == P::BaseDisplacement {
            Excitation::SurfaceMotion
        } else if parameter == P::Force {
            Excitation::Force
        } else {
            return Drive::with_force_ratio(body, amplitude, frequency)
                .and_then(|drive| self.with_mean_force(drive))
                .map_err(|e| self.at_fault(e));
        };
        Drive::new(excitation, amplitude, frequency)
            .and_then(|drive| self.with_mean_force(drive))
            .map_err(|e| self.at_fault(e))
    }

    /// The drive with its constant force, if given.
    pub(crate) fn with_mean_force(&self, drive: Drive<F>) -> Result<Drive<F>, Error> {
        self.get(P::MeanForce).map_or(Ok(drive), |force| drive.with_mean_force(force))
    }

    /// The friction against forward and against backward motion, if given apart.
    pub(crate) fn directional_friction(&self) -> Result<Option<(F, F)>, Failure> {
        Ok(self.friction()?.zip(self.get(P::FrictionBackward)))
    }
}
