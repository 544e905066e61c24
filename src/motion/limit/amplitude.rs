//! One amplitude of the steady motion, stops included.

use super::long_run::LongRun;
use super::observed::observed;
use super::peaks::Peaks;
use crate::cycle::regime::Regime;
use crate::cycle::response::Response;
use crate::float::{Float, Real};
use crate::machine::error::Error;
use crate::machine::oscillator::{Excitation, Scales};
use crate::machine::ratios::Ratios;
use crate::machine::support::Support;
use crate::motion::State;

/// An amplitude of the steady motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "kebab-case"))]
#[non_exhaustive]
pub enum Amplitude {
    /// The greatest displacement |x|, in B.
    Displacement,
    /// The greatest velocity |x′|, in B ω_d.
    Velocity,
    /// The greatest acceleration |x″|, in B ω_d²; on a base that carries the surface in relation to the base.
    Acceleration,
    /// The greatest force on the support, in r_y, as [`crate::Output::TransmittedForce`].
    TransmittedForce,
    /// The transmissibility, as [`crate::Output::Transmissibility`].
    Transmissibility,
    /// The greatest displacement in space, on a base that carries the surface, in B.
    AbsoluteDisplacement,
}

/// An amplitude at one point.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Reached<F> {
    /// The amplitude; `None` where the motion is unbounded, or no limit was found.
    pub value: Option<F>,
    /// The regime of the motion; `None` where no limit was found.
    pub regime: Option<Regime>,
}

impl Amplitude {
    /// The amplitude under an excitation: of the cycle in closed form where there is one, otherwise of the exact motion
    /// from rest. At rest friction carries the whole force, and the body moves with its base.
    ///
    /// ```
    /// use stickslip::{Excitation, Ratios, Regime, motion::Amplitude};
    /// let at = |omega, alpha| Amplitude::Displacement.of(Ratios::new(omega, alpha)?, Excitation::Force);
    /// assert!((at(1.5, 2.5)?.value.ok_or("none")? - 1.632_993_161_855_452_f64).abs() < 1e-14);
    /// assert_eq!((at(1.5, 0.9)?.value, at(1.5, 0.9)?.regime), (Some(0.0), Some(Regime::Stuck)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`LongRun::from_start`] and [`super::steady::SteadyState::peaks`].
    pub fn of<F: Float>(self, ratios: Ratios<F>, excitation: Excitation) -> Result<Reached<F>, Error> {
        let ratios = ratios.with_excitation(excitation);
        let response = Response::new(ratios);
        if let Some(cycle) = &response.cycle {
            let value = match self {
                Self::Displacement => cycle.max_displacement,
                Self::Velocity => cycle.max_velocity,
                Self::Acceleration => cycle.max_acceleration(),
                Self::TransmittedForce => cycle.transmitted_force(),
                Self::Transmissibility => cycle.transmissibility(),
                Self::AbsoluteDisplacement => cycle.max_absolute_displacement(),
            };
            return Ok(Reached { value: Some(value), regime: Some(Regime::NonSticking) });
        }
        if response.regime == Regime::Unbounded {
            return Ok(Reached { value: None, regime: Some(Regime::Unbounded) });
        }
        let limit = LongRun::from_start(ratios, State::default())?;
        let Some(steady) = limit.steady_state() else {
            let LongRun::Rest(_) = limit else { return Ok(Reached { value: None, regime: None }) };
            let peaks = Peaks::at_rest(&Support::from(&ratios), F::int(0));
            let value = match self {
                Self::Displacement | Self::Velocity | Self::Acceleration => F::int(0),
                Self::TransmittedForce => peaks.transmitted_force,
                Self::Transmissibility => peaks.transmissibility,
                Self::AbsoluteDisplacement => peaks.absolute_displacement,
            };
            return Ok(Reached { value: Some(value), regime: Some(Regime::Stuck) });
        };
        let value = match self {
            Self::Displacement => {
                steady.max_displacement.value.abs().or_larger(steady.min_displacement.value.abs())
            }
            Self::Velocity => steady.max_velocity.value.abs().or_larger(steady.min_velocity.value.abs()),
            Self::Acceleration => steady.peaks()?.acceleration,
            Self::TransmittedForce => steady.peaks()?.transmitted_force,
            Self::Transmissibility => steady.peaks()?.transmissibility,
            Self::AbsoluteDisplacement => steady.peaks()?.absolute_displacement,
        };
        Ok(Reached { value: Some(value), regime: Some(observed(ratios, &limit).regime) })
    }

    /// The physical size of the unit of the amplitude.
    pub fn unit<F: Real>(self, scales: &Scales<F>) -> F {
        match self {
            Self::Displacement | Self::AbsoluteDisplacement => scales.length,
            Self::Velocity => scales.velocity,
            Self::Acceleration => scales.velocity / scales.time,
            Self::TransmittedForce => scales.force,
            Self::Transmissibility => F::int(1),
        }
    }
}
