//! The steady motion of a machine in the units in which it was given.

use crate::cycle::Cycle;
use crate::cycle::regime::Regime;
use crate::cycle::response::Response;
use crate::float::Float;
use crate::machine::error::{Error, Quantity, written};
use crate::machine::excitation::Excitation;
use crate::machine::oscillator::{Drive, Oscillator, Scales};
use crate::machine::ratios::Ratios;
use crate::machine::support::Support;
use crate::motion::limit::observed::observed;
use crate::motion::slide::equation::Equation;
use crate::motion::{DrivePhase, Instant, LongRun, Peaks, State, SteadyState, Trajectory};
use alloc::vec::Vec;

/// The steady motion of a body under a harmonic drive, in the units of both.
///
/// Without a stop it is that of the closed form ([`Cycle`]), otherwise the exact motion from rest
/// ([`LongRun`]). [`Response`] and [`LongRun`] answer in ratios, from any start, and say more.
///
/// Displacements are measured from the mean displacement, times from a zero of the force on the body at which it
/// rises. Forces are without the mean force. Energies are those of a period.
///
/// ```
/// use stickslip::{Drive, Oscillator, Regime, Steady};
/// let body = Oscillator::new(50.0, 1000.0, 5.0)?.with_damping_ratio(0.02)?; // t, kN/m, kN
/// let drive = Drive::force(12.0, std::f64::consts::TAU)?; // kN, rad/s
/// let steady = Steady::of(&body, &drive)?;
/// assert_eq!(steady.regime, Regime::NonSticking);
/// assert!((steady.max_displacement - 0.009_527_638_f64).abs() < 1e-8); // m
/// assert!((steady.max_transmitted_force - 14.546_4_f64).abs() < 1e-3); // kN
///
/// // At a lower frequency the body stops in each period.
/// let slow = Steady::of(&body, &drive.at(1.8)?)?;
/// assert!(slow.regime == Regime::Sticking && slow.stops >= 2);
/// for sample in slow.samples(200)? {
///     assert!(sample.displacement <= slow.max_displacement * (1.0 + 1e-12));
/// }
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        deserialize = "F: Float + serde::Deserialize<'de>",
        serialize = "F: Float + serde::Serialize"
    ))
)]
#[non_exhaustive]
#[must_use]
pub struct Steady<F> {
    /// The regime: [`Regime::NonSticking`], [`Regime::Sticking`] or [`Regime::Stuck`].
    pub regime: Regime,
    /// The period of the motion; that of the drive, or a multiple of it for some motions with a static friction above
    /// the kinetic one.
    pub period: F,
    /// The maximum displacement.
    pub max_displacement: F,
    /// The minimum displacement.
    pub min_displacement: F,
    /// The maximum velocity.
    pub max_velocity: F,
    /// The minimum velocity.
    pub min_velocity: F,
    /// The maximum of |x″|, in relation to a base that carries the surface.
    pub max_acceleration: F,
    /// The maximum force on the support, as [`crate::Output::TransmittedForce`].
    pub max_transmitted_force: F,
    /// The transmissibility, as [`crate::Output::Transmissibility`].
    pub transmissibility: F,
    /// The maximum absolute displacement in space: |x + u| on a base that carries the surface, |x| otherwise.
    pub max_absolute_displacement: F,
    /// The maximum force in the spring.
    pub max_spring_force: F,
    /// The number of stops in a period.
    pub stops: u32,
    /// The time at rest in a period.
    pub stick_time: F,
    /// The energy that friction dissipates in a period.
    pub friction_work: F,
    /// The energy that the damper dissipates in a period.
    pub damper_work: F,
    /// The displacement from which displacements are measured ([`Scales::mean_displacement`]).
    pub mean_displacement: F,
    ratios: Ratios<F>,
    scales: Scales<F>,
    state: State<F>,
    turns: u32,
}

/// The steady motion at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Sample<F> {
    /// The time from a zero of the force at which it rises.
    pub time: F,
    /// The displacement, from the mean displacement.
    pub displacement: F,
    /// The velocity.
    pub velocity: F,
    /// The acceleration.
    pub acceleration: F,
    /// The friction force, against the motion; at rest the force that holds the body.
    pub friction: F,
}

/// The dimensionless numbers of a steady motion.
struct Found<F> {
    regime: Regime,
    displacement: (F, F),
    velocity: (F, F),
    peaks: Peaks<F>,
    stops: u32,
    stick_fraction: F,
    friction_work: F,
    damper_work: F,
    state: State<F>,
    turns: u32,
}

impl<F: Float> Found<F> {
    fn of_cycle(cycle: &Cycle<F>) -> Result<Self, Error> {
        let (x, v) = (cycle.max_displacement, cycle.max_velocity);
        let phase = DrivePhase::new(0, cycle.displacement_phase)?;
        let zero = F::int(0);
        Ok(Self {
            regime: Regime::NonSticking,
            displacement: (-x, x),
            velocity: (-v, v),
            peaks: Peaks {
                acceleration: cycle.max_acceleration(),
                transmitted_force: cycle.transmitted_force(),
                transmissibility: cycle.transmissibility(),
                absolute_displacement: cycle.max_absolute_displacement(),
                spring_force: cycle.max_spring_force(),
            },
            stops: 0,
            stick_fraction: zero,
            friction_work: F::int(4) * x,
            damper_work: cycle.damper_work(),
            state: State { phase, x, v: zero },
            turns: 1,
        })
    }

    fn of_motion(regime: Regime, steady: &SteadyState<F>) -> Result<Self, Error> {
        Ok(Self {
            regime,
            displacement: (steady.min_displacement.value, steady.max_displacement.value),
            velocity: (steady.min_velocity.value, steady.max_velocity.value),
            peaks: steady.peaks()?,
            stops: steady.sticks_per_cycle,
            stick_fraction: steady.stick_fraction,
            friction_work: steady.energy_out,
            damper_work: steady.damper_work,
            state: steady.state,
            turns: steady.turns_per_cycle,
        })
    }

    fn at_rest(ratios: &Ratios<F>, x: F) -> Self {
        let zero = F::int(0);
        Self {
            regime: Regime::Stuck,
            displacement: (x, x),
            velocity: (zero, zero),
            peaks: Peaks::at_rest(&Support::from(ratios), x),
            stops: 1,
            stick_fraction: F::int(1),
            friction_work: zero,
            damper_work: Equation::new(*ratios).damper_work_at_rest(zero, F::int(2) * F::pi()),
            state: State { x, ..State::default() },
            turns: 1,
        }
    }
}

impl<F: Float> Steady<F> {
    /// The steady motion of `body` under `drive`, from rest at the mean displacement.
    ///
    /// Without a stop each number is as accurate as that of [`Response`]; with stops as that of [`SteadyState`].
    ///
    /// # Errors
    /// [`Error::Unbounded`] where the motion grows without bound, [`Error::NotSettled`] where it does not become
    /// periodic, as some with a static friction above the kinetic one. Where a ratio leaves the domain of [`Ratios`], or
    /// a scale overflows.
    pub fn of(body: &Oscillator<F>, drive: &Drive<F>) -> Result<Self, Error> {
        let (ratios, scales) = (drive.ratios(body)?, Scales::new(body, drive)?);
        let response = Response::new(ratios);
        let found = match (response.regime, &response.cycle) {
            (Regime::NonSticking, Some(cycle)) => Found::of_cycle(cycle)?,
            (Regime::Unbounded, _) => return Err(Error::Unbounded { alpha: written(ratios.alpha()) }),
            _ => {
                let limit = LongRun::from_start(ratios, State::default())?;
                match (limit.steady_state(), limit.rest_position()) {
                    (Some(steady), _) => Found::of_motion(observed(ratios, &limit).regime, steady)?,
                    (None, Some(x)) => Found::at_rest(&ratios, x),
                    (None, None) => {
                        let (omega, alpha) = (written(ratios.omega()), written(ratios.alpha()));
                        let grows = matches!(limit, LongRun::Unbounded { .. });
                        return Err(if grows {
                            Error::Unbounded { alpha }
                        } else {
                            Error::NotSettled { omega, alpha }
                        });
                    }
                }
            }
        };
        Ok(Self::in_units(ratios, scales, found))
    }

    fn in_units(ratios: Ratios<F>, scales: Scales<F>, found: Found<F>) -> Self {
        let Scales { length, velocity, time, force, .. } = scales;
        let period = F::int(2) * F::pi() * F::from_f64(f64::from(found.turns)) * time;
        let energy = force * length;
        let reach = found.displacement.1.abs().or_larger(found.displacement.0.abs());
        let is_carried = ratios.excitation().is_some_and(Excitation::carries_surface);
        let in_space = if is_carried { found.peaks.absolute_displacement } else { reach };
        Self {
            regime: found.regime,
            period,
            max_displacement: found.displacement.1 * length,
            min_displacement: found.displacement.0 * length,
            max_velocity: found.velocity.1 * velocity,
            min_velocity: found.velocity.0 * velocity,
            max_acceleration: found.peaks.acceleration * (velocity / time),
            max_transmitted_force: found.peaks.transmitted_force * force,
            transmissibility: found.peaks.transmissibility,
            max_absolute_displacement: in_space * length,
            max_spring_force: found.peaks.spring_force * force,
            stops: found.stops,
            stick_time: found.stick_fraction * period,
            friction_work: found.friction_work * energy,
            damper_work: found.damper_work * energy,
            mean_displacement: scales.mean_displacement,
            ratios,
            scales,
            state: found.state,
            turns: found.turns,
        }
    }

    /// `count` samples of a period, at equal steps of the time from 0 on.
    ///
    /// # Errors
    /// Where `count` is zero, and those of [`Trajectory`].
    pub fn samples(&self, count: u32) -> Result<Vec<Sample<F>>, Error> {
        if count == 0 {
            let value = written(f64::from(count));
            return Err(Error::NotPositive { quantity: Quantity::SamplesPerCycle, value });
        }
        let number = |n: u32| F::from_f64(f64::from(n));
        let (turns, whole) = (i64::from(self.turns), number(count));
        let step = number(self.turns) / whole;
        // From a state in the first period on, the samples after the end of the period are those of its beginning.
        let phase = self.state.phase;
        let phase = DrivePhase::new(phase.cycles().checked_rem_euclid(turns).unwrap_or(0), phase.reduced())?;
        let motion = Trajectory::new(self.ratios, State { phase, ..self.state })?.samples_every(step)?;
        let scales = &self.scales;
        let mut samples = Vec::new();
        for instant in motion.take(usize::try_from(count).unwrap_or(usize::MAX)) {
            let Instant { state, acceleration, friction, .. } = instant?;
            let turn =
                F::from_f64(state.phase.cycles() as f64) + state.phase.reduced() / (F::int(2) * F::pi());
            let place = (turn / step).round();
            let place = if place < whole { place } else { place - whole };
            samples.push(Sample {
                time: self.period * (place / whole),
                displacement: state.x * scales.length,
                velocity: state.v * scales.velocity,
                acceleration: acceleration * (scales.velocity / scales.time),
                friction: friction * scales.force + scales.mean_friction,
            });
        }
        let first = samples.iter().position(|sample| sample.time == F::int(0)).unwrap_or(0);
        samples.rotate_left(first);
        Ok(samples)
    }
}
