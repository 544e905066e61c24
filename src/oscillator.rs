//! The machine in physical units: the body on its spring and friction surface, and its drive (eq. 1).

use crate::error::{Error, Quantity};
use crate::float::Float;
use crate::ratios::{Ratios, frequency_ratio, positive};

/// A body of mass m on a spring of stiffness k and a surface whose friction carries at most r_y.
///
/// Any consistent system of units; all three are finite and > 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Oscillator<F> {
    mass: F,
    stiffness: F,
    friction_bound: F,
}

impl<F: Float> Oscillator<F> {
    /// An oscillator from mass m, stiffness k and friction bound r_y.
    ///
    /// # Errors
    /// Where one of them is not finite or not > 0.
    pub fn new(mass: F, stiffness: F, friction_bound: F) -> Result<Self, Error> {
        Ok(Self {
            mass: positive(Quantity::Mass, mass)?,
            stiffness: positive(Quantity::Stiffness, stiffness)?,
            friction_bound: positive(Quantity::FrictionBound, friction_bound)?,
        })
    }

    /// The oscillator of given mass m and friction bound r_y whose frequency ratio is Ω when driven at
    /// ω_d: `ω_n = ω_d/Ω`, `k = m ω_n²` (the way the paper's own examples are set up).
    ///
    /// # Errors
    /// Where an argument is not finite or not > 0, or k is not.
    pub fn tuned(mass: F, friction_bound: F, angular_frequency: F, omega: F) -> Result<Self, Error> {
        let omega = frequency_ratio(omega)?;
        let natural_frequency = positive(Quantity::AngularFrequency, angular_frequency)? / omega;
        Self::new(mass, mass * natural_frequency.square(), friction_bound)
    }

    /// Mass m.
    pub const fn mass(&self) -> F {
        self.mass
    }

    /// Stiffness k.
    pub const fn stiffness(&self) -> F {
        self.stiffness
    }

    /// Friction bound r_y.
    pub const fn friction_bound(&self) -> F {
        self.friction_bound
    }

    /// Natural angular frequency `ω_n = √(k/m)` (eq. 7).
    pub fn natural_frequency(&self) -> F {
        (self.stiffness / self.mass).sqrt()
    }

    /// Friction displacement `B = r_y/k` (eq. 6): the deflection at which the spring just overcomes
    /// friction.
    pub fn friction_displacement(&self) -> F {
        self.friction_bound / self.stiffness
    }
}

/// What shakes the body.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Excitation<F> {
    Force(F),
    BaseMotion(F),
}

/// A harmonic drive: a force `p₀ sin ω_d t` on the body, or a motion `u_g0 sin ω_d t` of its base.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drive<F> {
    excitation: Excitation<F>,
    angular_frequency: F,
}

impl<F: Float> Drive<F> {
    /// A force `p₀ sin ω_d t`.
    ///
    /// # Errors
    /// Where p₀ or ω_d is not finite or not > 0.
    pub fn force(amplitude: F, angular_frequency: F) -> Result<Self, Error> {
        Ok(Self {
            excitation: Excitation::Force(positive(Quantity::ForceAmplitude, amplitude)?),
            angular_frequency: positive(Quantity::AngularFrequency, angular_frequency)?,
        })
    }

    /// A base motion `u_g0 sin ω_d t`: the same equation with `p₀ = k u_g0`, where x is relative to the
    /// base.
    ///
    /// # Errors
    /// Where u_g0 or ω_d is not finite or not > 0.
    pub fn base_motion(amplitude: F, angular_frequency: F) -> Result<Self, Error> {
        Ok(Self {
            excitation: Excitation::BaseMotion(positive(Quantity::BaseAmplitude, amplitude)?),
            angular_frequency: positive(Quantity::AngularFrequency, angular_frequency)?,
        })
    }

    /// The force `p₀ = α r_y` at the angular frequency ω_d.
    ///
    /// # Errors
    /// Where α or ω_d is not finite or not > 0, or p₀ over- or underflows.
    pub fn with_force_ratio(
        oscillator: &Oscillator<F>,
        alpha: F,
        angular_frequency: F,
    ) -> Result<Self, Error> {
        let alpha = positive(Quantity::ForceRatio, alpha)?;
        Self::force(alpha * oscillator.friction_bound(), angular_frequency)
    }

    /// The force that gives `oscillator` the ratios (Ω, α): `p₀ = α r_y`, `ω_d = Ω ω_n`.
    ///
    /// # Errors
    /// Where p₀ or ω_d over- or underflows.
    pub fn from_ratios(oscillator: &Oscillator<F>, ratios: &Ratios<F>) -> Result<Self, Error> {
        let angular_frequency = ratios.omega() * oscillator.natural_frequency();
        Self::with_force_ratio(oscillator, ratios.alpha(), angular_frequency)
    }

    /// Angular frequency ω_d.
    pub const fn angular_frequency(&self) -> F {
        self.angular_frequency
    }

    /// The amplitude it was given by: p₀ of a force, u_g0 of a base motion.
    pub const fn amplitude(&self) -> F {
        match self.excitation {
            Excitation::Force(amplitude) | Excitation::BaseMotion(amplitude) => amplitude,
        }
    }

    /// Whether it is the base that moves, so that the force on the body changes with its stiffness.
    pub const fn is_base_motion(&self) -> bool {
        matches!(self.excitation, Excitation::BaseMotion(_))
    }

    /// Amplitude of the force on the body of `oscillator`: p₀, or `k u_g0` under base motion.
    pub fn force_amplitude(&self, oscillator: &Oscillator<F>) -> F {
        match self.excitation {
            Excitation::Force(p0) => p0,
            Excitation::BaseMotion(ug0) => oscillator.stiffness() * ug0,
        }
    }

    /// The ratios of `oscillator` under this drive: `Ω = ω_d/ω_n` (eq. 9), `α = p₀/r_y` (eq. 8).
    ///
    /// # Errors
    /// Where a ratio leaves the domain of [`Ratios`].
    pub fn ratios(&self, oscillator: &Oscillator<F>) -> Result<Ratios<F>, Error> {
        Ratios::new(
            self.angular_frequency / oscillator.natural_frequency(),
            self.force_amplitude(oscillator) / oscillator.friction_bound(),
        )
    }
}

/// The physical size of the dimensionless answers of one oscillator under one drive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scales<F> {
    /// Length: `B = r_y/k` (eq. 6).
    pub length: F,
    /// Velocity: `B ω_d` (as in eq. 49).
    pub velocity: F,
    /// Time for one radian of phase: `1/ω_d`.
    pub time: F,
    /// Force: r_y.
    pub force: F,
    /// Energy for one unit of A₁: `p₀²/(2k)`, the lossless static elastic energy (eq. 64).
    pub energy_stiffness: F,
    /// Energy for one unit of A₂: `p₀²/(2 m ω_d²)` (eq. 67).
    pub energy_inertia: F,
}

impl<F: Float> Scales<F> {
    /// The scales of `oscillator` under `drive`.
    ///
    /// # Errors
    /// Where one of them over- or underflows, so that answers could not be stated in these units.
    pub fn new(oscillator: &Oscillator<F>, drive: &Drive<F>) -> Result<Self, Error> {
        let length = positive(Quantity::FrictionDisplacement, oscillator.friction_displacement())?;
        let frequency = drive.angular_frequency();
        let p0 = positive(Quantity::ForceAmplitude, drive.force_amplitude(oscillator))?;
        let inertia = positive(Quantity::PseudoStiffness, oscillator.mass() * frequency.square())?;
        let half = F::ratio(1, 2);
        Ok(Self {
            length,
            velocity: positive(Quantity::VelocityScale, length * frequency)?,
            time: positive(Quantity::TimeScale, F::int(1) / frequency)?,
            force: oscillator.friction_bound(),
            energy_stiffness: positive(Quantity::StaticEnergy, half * p0 * (p0 / oscillator.stiffness()))?,
            energy_inertia: positive(Quantity::PseudoStaticEnergy, half * p0 * (p0 / inertia))?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::{Drive, Oscillator, Scales};
    use crate::error::Error;
    use crate::ratios::Ratios;

    /// The paper's machine: m = 50 kN s²/m, r_y = 5 kN, ω_d = 2π rad/s, Ω chosen.
    fn paper(omega: f64) -> Oscillator<f64> {
        Oscillator::tuned(50.0, 5.0, std::f64::consts::TAU, omega).unwrap()
    }

    fn close(a: f64, b: f64) {
        assert!((a - b).abs() <= 4.0 * f64::EPSILON * b.abs(), "{a} against {b}");
    }

    #[test]
    fn ratios_and_physical_units_are_two_views() {
        let oscillator = paper(0.8);
        close(oscillator.natural_frequency(), std::f64::consts::TAU / 0.8);
        let ratios = Ratios::new(0.8, 2.5).unwrap();
        let drive = Drive::from_ratios(&oscillator, &ratios).unwrap();
        close(drive.force_amplitude(&oscillator), 12.5);
        close(drive.angular_frequency(), std::f64::consts::TAU);
        let back = drive.ratios(&oscillator).unwrap();
        close(back.omega(), 0.8);
        close(back.alpha(), 2.5);
    }

    #[test]
    fn base_motion_is_a_force_k_times_its_amplitude() {
        let oscillator = Oscillator::new(2.0, 8.0, 4.0).unwrap();
        let base = Drive::base_motion(1.5, 3.0).unwrap();
        assert_eq!(base.force_amplitude(&oscillator), 12.0);
        let ratios = base.ratios(&oscillator).unwrap();
        assert_eq!((ratios.omega(), ratios.alpha()), (1.5, 3.0));
    }

    #[test]
    fn scales_are_the_units_of_the_answers() {
        let oscillator = Oscillator::new(2.0, 8.0, 4.0).unwrap();
        let scales = Scales::new(&oscillator, &Drive::force(12.0, 4.0).unwrap()).unwrap();
        assert_eq!((scales.length, scales.velocity, scales.time, scales.force), (0.5, 2.0, 0.25, 4.0));
        assert_eq!(scales.energy_stiffness, 9.0);
        assert_eq!(scales.energy_inertia, 144.0 / 64.0);
    }

    #[test]
    fn bad_input_names_the_quantity() {
        let text = |r: Result<Oscillator<f64>, Error>| r.unwrap_err().to_string();
        assert_eq!(text(Oscillator::new(0.0, 1.0, 1.0)), "mass m = 0 must be > 0");
        assert_eq!(text(Oscillator::new(1.0, f64::NAN, 1.0)), "stiffness k = NaN must be finite");
        assert_eq!(text(Oscillator::new(1.0, 1.0, -2.0)), "friction bound r_y = -2 must be > 0");
        assert!(Drive::force(f64::INFINITY, 1.0).is_err());
        assert!(Drive::base_motion(1.0, 0.0).is_err());
        let tiny = Oscillator::new(1.0, 1e300, 1e-300).unwrap();
        let message = Scales::new(&tiny, &Drive::force(1.0, 1.0).unwrap()).unwrap_err().to_string();
        assert!(message.starts_with("friction displacement B"), "{message}");
    }
}
