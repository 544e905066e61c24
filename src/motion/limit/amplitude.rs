//! One amplitude of the steady motion, stops included.

use super::long_run::{DEFAULT_BUDGET, LongRun};
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
use core::ops::ControlFlow;

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

/// Where the cycle in closed form is taken for the motion from rest, with a higher static friction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Trust {
    /// Where it exists and the force is twice that which releases the body: a guess.
    AboveRelease,
    /// Where the force is four times that of the border of the cycle, or twice with at least one percent of damping.
    ///
    /// Compared with 220,000 motions from rest (Ω from 0.1 to 4, ζ = 0 and from 10⁻⁴ to 1, η from 1.01 to 3): other limits
    /// were met up to 3.6 times the border with less damping, beside Ω = 1/(2n), and up to 1.5 times with more.
    FarAbove,
}

impl Trust {
    fn of<F: Float>(self, ratios: &Ratios<F>, border: F) -> bool {
        let alpha = ratios.alpha();
        match self {
            Self::AboveRelease => alpha >= ratios.static_friction_ratio() * F::int(2),
            Self::FarAbove if ratios.damping_ratio() >= F::ratio(1, 100) => alpha >= border * F::int(2),
            Self::FarAbove => alpha >= border * F::int(4),
        }
    }
}

/// An amplitude at one point.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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
        self.reached(ratios, Response::new(ratios), DEFAULT_BUDGET, &mut || ControlFlow::Continue(()))
    }

    /// The amplitude of the motion from rest, as long as `keep_going`, asked at every step of a search, returns
    /// [`ControlFlow::Continue`].
    ///
    /// With a higher static friction a body may rest, or move with stops, though the cycle in closed form exists: `trust`
    /// says where the cycle is taken for the motion.
    ///
    /// # Errors
    /// [`Error::Interrupted`] where `keep_going` ends the search, and as for [`Self::of`].
    pub(crate) fn reached_from_rest<F: Float>(
        self,
        ratios: Ratios<F>,
        excitation: Excitation,
        trust: Trust,
        keep_going: &mut dyn FnMut() -> ControlFlow<()>,
    ) -> Result<Reached<F>, Error> {
        let ratios = ratios.with_excitation(excitation);
        if !ratios.has_higher_static_friction() {
            return self.reached(ratios, Response::new(ratios), DEFAULT_BUDGET, keep_going);
        }
        let mut response = Response::new(ratios);
        if !ratios.moves_from_rest() {
            (response.cycle, response.regime) = (None, Regime::Stuck);
        } else if !trust.of(&ratios, response.border.min_force_ratio) {
            response.cycle = None;
        }
        self.reached(ratios, response, FEW_PERIODS, keep_going)
    }

    fn reached<F: Float>(
        self,
        ratios: Ratios<F>,
        response: Response<F>,
        periods: u32,
        keep_going: &mut dyn FnMut() -> ControlFlow<()>,
    ) -> Result<Reached<F>, Error> {
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
        let limit = LongRun::within(ratios, State::default(), periods, keep_going)?;
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
            Self::Acceleration => steady.peaks_while(keep_going)?.acceleration,
            Self::TransmittedForce => steady.peaks_while(keep_going)?.transmitted_force,
            Self::Transmissibility => steady.peaks_while(keep_going)?.transmissibility,
            Self::AbsoluteDisplacement => steady.peaks_while(keep_going)?.absolute_displacement,
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

/// The periods after which a motion with a higher static friction is not followed further in a search over many.
const FEW_PERIODS: u32 = 4_000;
