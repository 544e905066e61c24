//! The machine in physical units: the body on its spring, damper and friction surface (eq. 1), its drive, and
//! the scales of the answers.

pub use crate::machine::drive::Drive;
pub use crate::machine::excitation::Excitation;
pub use crate::machine::scales::Scales;

use crate::float::Float;
use crate::machine::error::{Error, Quantity};
use crate::machine::ratios::{
    frequency_ratio, non_negative, one_friction, positive, springless, valid_static_friction_ratio,
};

/// The critical damping `2√(k m)`, the damping constant at which free vibration ceases. Every damping ratio is of this one.
///
/// The roots are apart, so that neither a great nor a small product leaves the range of numbers.
#[must_use]
pub fn critical_damping<F: Float>(mass: F, stiffness: F) -> F {
    F::int(2) * (stiffness.sqrt() * mass.sqrt())
}

/// A body of mass m on a spring of stiffness k, with a viscous damper c, on a surface whose friction is at
/// most r_y.
///
/// Any consistent system of units may be used. m, k and r_y are finite and > 0; c is finite and ≥ 0, and 0 by
/// default ([`Oscillator::with_damping`]).
///
/// **Static friction** r_s = η r_y ≥ r_y is the force at which a body at rest is released; it is r_y by
/// default ([`Oscillator::with_static_friction`]).
///
/// **Friction that differs by direction** ([`Oscillator::with_directional_friction`]): r₊ against motion with
/// x′ > 0 and r₋ against motion with x′ < 0 are equivalent to the bound `r_y = (r₊ + r₋)/2` and a constant
/// force `−(r₊ − r₋)/2`. A constant force only shifts the motion, stops included, by
/// [`Scales::mean_displacement`]; all else is as with r_y in both directions. Static friction then exceeds
/// the kinetic one by (η − 1) r_y in each direction.
#[derive(Debug, Clone, Copy)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(
        try_from = "crate::serialized::OscillatorFields<F>",
        bound(deserialize = "F: Float + serde::Deserialize<'de>")
    )
)]
pub struct Oscillator<F> {
    mass: F,
    stiffness: F,
    friction_bound: F,
    damping: F,
    friction_offset: F,
    static_friction_ratio: F,
    /// r_s where it was given as a force, which stays as it is if the friction force changes.
    static_friction: Option<F>,
}

/// Equal where the machines are, whether the static friction was given as a force or as a ratio.
impl<F: PartialEq> PartialEq for Oscillator<F> {
    fn eq(&self, other: &Self) -> bool {
        self.mass == other.mass
            && self.stiffness == other.stiffness
            && self.friction_bound == other.friction_bound
            && self.damping == other.damping
            && self.friction_offset == other.friction_offset
            && self.static_friction_ratio == other.static_friction_ratio
    }
}

/// Displays the quantities that are given: `m = 50, k = 1000, r_y = 5, c = 4`.
impl<F: Float> core::fmt::Display for Oscillator<F> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let zero = F::int(0);
        write!(f, "m = {}, k = {}", self.mass, self.stiffness)?;
        if self.friction_offset == zero {
            write!(f, ", r_y = {}", self.friction_bound)?;
        } else {
            let (forward, backward) = self.directional_friction();
            write!(f, ", r₊ = {forward}, r₋ = {backward}")?;
        }
        if self.damping != zero {
            write!(f, ", c = {}", self.damping)?;
        }
        if self.static_friction_ratio > F::int(1) {
            write!(f, ", η = {}", self.static_friction_ratio)?;
        }
        Ok(())
    }
}

impl<F: Float> Oscillator<F> {
    /// An oscillator from mass m, stiffness k and friction force r_y, without a damper.
    ///
    /// # Errors
    /// Where m, k or r_y is not finite or not > 0.
    pub fn new(mass: F, stiffness: F, friction_bound: F) -> Result<Self, Error> {
        Ok(Self {
            mass: positive(Quantity::Mass, mass)?,
            stiffness: positive(Quantity::Stiffness, stiffness)?,
            friction_bound: positive(Quantity::FrictionBound, friction_bound)?,
            damping: F::int(0),
            friction_offset: F::int(0),
            static_friction_ratio: F::int(1),
            static_friction: None,
        })
    }

    /// The oscillator of given mass m and friction force r_y whose frequency ratio is Ω when driven at
    /// ω_d: `ω_n = ω_d/Ω`, `k = m ω_n²` (the way the paper's own examples are set up).
    ///
    /// # Errors
    /// Where an argument is not finite or not > 0, or k is not.
    pub fn tuned(mass: F, friction_bound: F, angular_frequency: F, omega: F) -> Result<Self, Error> {
        let omega = frequency_ratio(omega)?;
        let natural_frequency = positive(Quantity::AngularFrequency, angular_frequency)? / omega;
        Self::new(mass, mass * natural_frequency.square(), friction_bound)
    }

    /// A body without a spring, from its mass m and friction force r_y, under drives of the angular frequency ω_d or more.
    ///
    /// It is the limit of soft springs: its stiffness is `m (ω_d/Ω)²` with an Ω (2²⁸ at f64) at which the force k x is less
    /// than ε/16 of the inertia m ω_d² x. Answers in units of r_y/(m ω_d²), ω_d and r_y, and so all in the machine's units
    /// but those of the spring itself, are those of the limit to this accuracy: Δ₀ = √(α² − π²/4) r_y/(m ω_d²), and the
    /// sticking threshold is √(η² + π²/4) r_y. Displacements are from the middle of the motion.
    ///
    /// A constant force and friction that differs by direction move such a body on for ever: a system of one body
    /// answers with its drift.
    ///
    /// # Errors
    /// Where an argument is not finite or not > 0.
    pub fn without_spring(mass: F, friction_bound: F, angular_frequency: F) -> Result<Self, Error> {
        Self::tuned(mass, friction_bound, angular_frequency, springless())
    }

    /// This body with a viscous damper: the force −c x′ on the body.
    ///
    /// # Errors
    /// Where c is not finite or < 0.
    pub fn with_damping(self, damping: F) -> Result<Self, Error> {
        Ok(Self { damping: non_negative(Quantity::Damping, damping)?, ..self })
    }

    /// This body with a damper of damping ratio ζ: `c = 2ζ √(k m)`.
    ///
    /// # Errors
    /// Where ζ or c is not finite or < 0.
    pub fn with_damping_ratio(self, damping_ratio: F) -> Result<Self, Error> {
        let ratio = non_negative(Quantity::DampingRatio, damping_ratio)?;
        self.with_damping(ratio * critical_damping(self.mass, self.stiffness))
    }

    /// This body with a static friction r_s: a body at rest stays at rest until the force on it exceeds r_s.
    ///
    /// # Errors
    /// Where r_s is not finite or not > 0, or is below r_y.
    pub fn with_static_friction(self, static_friction: F) -> Result<Self, Error> {
        let ratio = positive(Quantity::StaticFriction, static_friction)? / self.friction_bound;
        Ok(Self { static_friction: Some(static_friction), ..self.with_static_friction_ratio(ratio)? })
    }

    /// This body with a static friction of η times the kinetic one, r_s = η r_y.
    ///
    /// # Errors
    /// Where η is not finite, < 1 or outside the domain of [`crate::Ratios`].
    pub fn with_static_friction_ratio(self, static_friction_ratio: F) -> Result<Self, Error> {
        let static_friction_ratio = valid_static_friction_ratio(static_friction_ratio)?;
        Ok(Self { static_friction_ratio, static_friction: None, ..self })
    }

    /// This body with friction that differs by direction: r₊ against motion with x′ > 0, r₋ against motion
    /// with x′ < 0. Their mean is r_y, and a body at rest stays at rest until the force on it exceeds η r_y +
    /// (r₊ − r₋)/2 forwards or η r_y − (r₊ − r₋)/2 backwards.
    ///
    /// # Errors
    /// Where r₊ or r₋ is not finite or not > 0, their sum overflows, or r_s was given and is below their mean.
    pub fn with_directional_friction(self, forward: F, backward: F) -> Result<Self, Error> {
        let forward = positive(Quantity::ForwardFriction, forward)?;
        let backward = positive(Quantity::BackwardFriction, backward)?;
        let half = F::ratio(1, 2);
        let own = Self {
            friction_bound: positive(Quantity::FrictionBound, forward * half + backward * half)?,
            friction_offset: (forward - backward) * half,
            ..self
        };
        self.static_friction.map_or(Ok(own), |static_friction| own.with_static_friction(static_friction))
    }

    /// This body with friction that differs by direction by twice this force, `(r₊ − r₋)/2`.
    ///
    /// # Errors
    /// Where r₊ or r₋ is not finite or not > 0.
    #[cfg(feature = "serde")]
    pub(crate) fn with_friction_offset(self, friction_offset: F) -> Result<Self, Error> {
        positive(Quantity::ForwardFriction, self.friction_bound + friction_offset)?;
        positive(Quantity::BackwardFriction, self.friction_bound - friction_offset)?;
        Ok(Self { friction_offset, ..self })
    }

    /// This body with another friction force r_y, and the same ratio of static friction.
    pub(crate) fn with_friction_bound(self, friction_bound: F) -> Result<Self, Error> {
        Ok(Self { friction_bound: positive(Quantity::FrictionBound, friction_bound)?, ..self })
    }

    /// Mass m.
    pub const fn mass(&self) -> F {
        self.mass
    }

    /// Stiffness k.
    pub const fn stiffness(&self) -> F {
        self.stiffness
    }

    /// Friction force r_y; the mean of both directions, `(r₊ + r₋)/2`, where they differ.
    pub const fn friction_bound(&self) -> F {
        self.friction_bound
    }

    /// Friction by direction, (r₊, r₋): against motion with x′ > 0, and against motion with x′ < 0.
    pub fn directional_friction(&self) -> (F, F) {
        (self.friction_bound + self.friction_offset, self.friction_bound - self.friction_offset)
    }

    /// Half the difference of friction by direction, `(r₊ − r₋)/2`; 0 by default.
    pub(crate) const fn friction_offset(&self) -> F {
        self.friction_offset
    }

    /// Damping constant c.
    pub const fn damping(&self) -> F {
        self.damping
    }

    /// Static friction ratio η = r_s/r_y; 1 by default.
    pub const fn static_friction_ratio(&self) -> F {
        self.static_friction_ratio
    }

    /// Refuses a body whose static friction is above the kinetic one, for calculations that do not include
    /// it.
    pub(crate) fn with_one_friction(&self) -> Result<(), Error> {
        one_friction(self.static_friction_ratio)
    }

    /// Damping ratio `ζ = c/(2√(k m))`.
    pub fn damping_ratio(&self) -> F {
        if self.damping == F::int(0) {
            self.damping
        } else {
            self.damping / critical_damping(self.mass, self.stiffness)
        }
    }

    /// Natural angular frequency `ω_n = √(k/m)` (eq. 7), without damper and friction.
    pub fn natural_frequency(&self) -> F {
        (self.stiffness / self.mass).sqrt()
    }

    /// Friction displacement `B = r_y/k` (eq. 6): the deflection at which the spring just overcomes
    /// friction.
    pub fn friction_displacement(&self) -> F {
        self.friction_bound / self.stiffness
    }
}

#[cfg(test)]
mod tests {
    use super::{Drive, Excitation, Oscillator, Scales};
    use crate::machine::error::Error;
    use crate::machine::ratios::Ratios;

    /// The paper's machine at a chosen Ω: m = 50 kN s²/m, r_y = 5 kN, ω_d = 2π rad/s.
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
        let drive =
            Drive::force(2.5 * oscillator.friction_bound(), 0.8 * oscillator.natural_frequency()).unwrap();
        close(drive.force_amplitude(&oscillator), 12.5);
        close(drive.angular_frequency(), std::f64::consts::TAU);
        let back = drive.ratios(&oscillator).unwrap();
        close(back.omega(), 0.8);
        close(back.alpha(), 2.5);
    }

    #[test]
    fn base_motion_is_a_force_k_times_its_amplitude() {
        let oscillator = Oscillator::new(2.0, 8.0, 4.0).unwrap();
        let base = Drive::new(crate::Excitation::FootMotion, 1.5, 3.0).unwrap();
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
        assert_eq!(text(Oscillator::new(1.0, 1.0, -2.0)), "friction force r_y = -2 must be > 0");
        assert!(Drive::force(f64::INFINITY, 1.0).is_err());
        assert!(Drive::new(crate::Excitation::FootMotion, 1.0, 0.0).is_err());
        let tiny = Oscillator::new(1.0, 1e300, 1e-300).unwrap();
        let message = Scales::new(&tiny, &Drive::force(1.0, 1.0).unwrap()).unwrap_err().to_string();
        assert!(message.starts_with("friction displacement B"), "{message}");
    }

    #[test]
    fn a_mean_force_and_one_sided_friction_are_a_shift() {
        // k = 8, r₊ = 5, r₋ = 3: r_y = 4, offset 1. p̄ = 9: the mean position is (9 − 1)/8 = 1.
        let body = Oscillator::new(2.0, 8.0, 1.0).unwrap().with_directional_friction(5.0, 3.0).unwrap();
        let drive = Drive::force(12.0, 4.0).unwrap().with_mean_force(9.0).unwrap();
        assert_eq!((body.friction_bound(), body.friction_offset()), (4.0, 1.0));
        let scales = Scales::new(&body, &drive).unwrap();
        assert_eq!((scales.mean_displacement, scales.length), (1.0, 0.5));
        let ratios = Ratios::new(2.0, 3.0).unwrap().with_excitation(Excitation::Force);
        assert_eq!(drive.ratios(&body), Ok(ratios));
        assert!(body.with_directional_friction(5.0, 0.0).is_err());
        assert!(drive.with_mean_force(f64::NAN).is_err());
    }

    #[test]
    fn damping_by_constant_and_by_ratio() {
        // 2√(k m) = 8.
        let body = Oscillator::new(2.0, 8.0, 4.0).unwrap();
        close(body.with_damping(0.4).unwrap().damping_ratio(), 0.05);
        close(body.with_damping_ratio(0.05).unwrap().damping(), 0.4);
        assert_eq!(body.damping_ratio(), 0.0);
        let text = |r: Result<Oscillator<f64>, Error>| r.unwrap_err().to_string();
        assert_eq!(text(body.with_damping_ratio(-0.5)), "damping ratio ζ = -0.5 must be ≥ 0");
        assert_eq!(text(body.with_damping(f64::NAN)), "damping constant c = NaN must be finite");
    }

    #[test]
    fn static_friction_by_force_and_by_ratio() {
        let body = Oscillator::new(2.0, 8.0, 4.0).unwrap();
        assert_eq!(body.static_friction_ratio(), 1.0);
        assert_eq!(body.with_static_friction(5.0).unwrap().static_friction_ratio(), 1.25);
        let ratios = Drive::force(12.0, 4.0).unwrap().ratios(&body.with_static_friction(5.0).unwrap());
        let expected = Ratios::new(2.0, 3.0).unwrap().with_excitation(Excitation::Force);
        assert_eq!(ratios, expected.with_static_friction_ratio(1.25));
        let text = |r: Result<Oscillator<f64>, Error>| r.unwrap_err().to_string();
        assert_eq!(
            text(body.with_static_friction(3.0)),
            "static friction ratio η = 0.75 must be ≥ 1: static friction is not below the kinetic one"
        );
        assert_eq!(text(body.with_static_friction(f64::NAN)), "static friction r_s = NaN must be finite");
    }

    /// A static friction given as a force, or as a ratio, is what was given, whatever is given after it.
    #[test]
    fn the_order_of_the_builders_does_not_matter() {
        let body = Oscillator::new(50.0, 1000.0, 5.0).unwrap();
        let directional = body.with_directional_friction(4.0, 7.0).unwrap();
        let force = |body: Oscillator<f64>| body.static_friction_ratio() * body.friction_bound();
        close(
            force(body.with_static_friction(6.0).unwrap().with_directional_friction(4.0, 7.0).unwrap()),
            6.0,
        );
        close(force(directional.with_static_friction(6.0).unwrap()), 6.0);
        let by_ratio = body.with_static_friction_ratio(1.2).unwrap();
        close(force(by_ratio.with_directional_friction(4.0, 7.0).unwrap()), 6.6);
        assert_eq!(by_ratio.with_directional_friction(4.0, 7.0), directional.with_static_friction_ratio(1.2));
        // The last of two static frictions counts.
        let last = body.with_static_friction(9.0).unwrap().with_static_friction_ratio(1.2).unwrap();
        assert_eq!(last.with_directional_friction(4.0, 7.0), directional.with_static_friction_ratio(1.2));
        let text = body
            .with_static_friction(5.2)
            .unwrap()
            .with_directional_friction(4.0, 7.0)
            .unwrap_err()
            .to_string();
        assert!(text.starts_with("static friction ratio η = 0.94545"), "{text}");
    }

    #[test]
    fn each_base_motion_is_a_force_of_its_own() {
        // m = 2, k = 8, c = 3, ω_d = 4, u = 1.5: k u = 12, √(k² + c²ω²) u = √208 · 1.5, m ω² u = 48.
        let body = Oscillator::new(2.0, 8.0, 4.0).unwrap().with_damping(3.0).unwrap();
        let p0 =
            |excitation, amplitude| Drive::new(excitation, amplitude, 4.0).unwrap().force_amplitude(&body);
        close(p0(Excitation::FootMotion, 1.5), 12.0);
        close(p0(Excitation::DampedFootMotion, 1.5), 208f64.sqrt() * 1.5);
        for (excitation, amplitude) in [
            (Excitation::SurfaceMotion, 1.5),
            (Excitation::SurfaceVelocity, 6.0),
            (Excitation::SurfaceAcceleration, 24.0),
        ] {
            close(p0(excitation, amplitude), 48.0);
        }
        let foot = Drive::new(Excitation::DampedFootMotion, 1.5, 4.0).unwrap();
        close(foot.phase_lead(&body), 1.5f64.atan());
        assert_eq!(Drive::new(Excitation::SurfaceMotion, 1.5, 4.0).unwrap().phase_lead(&body), 0.0);
        // A moving surface acts by inertia: the force does not depend on the stiffness.
        let stiffer = Oscillator::new(2.0, 80.0, 4.0).unwrap();
        close(Drive::new(Excitation::SurfaceMotion, 1.5, 4.0).unwrap().force_amplitude(&stiffer), 48.0);
    }
}
