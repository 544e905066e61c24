//! The quantities of the input.

use core::fmt::{self, Display};

/// A physical or dimensionless quantity of the input.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Quantity {
    /// Mass m of the body.
    Mass,
    /// Stiffness k of the spring.
    Stiffness,
    /// Natural period T of the body on its spring.
    NaturalPeriod,
    /// Friction bound r_y, the maximum force friction can carry.
    FrictionBound,
    /// Coefficient of friction µ.
    FrictionCoefficient,
    /// Gravity g.
    Gravity,
    /// Friction r₊ against motion with x′ > 0.
    ForwardFriction,
    /// Friction r₋ against motion with x′ < 0.
    BackwardFriction,
    /// Damping constant c.
    Damping,
    /// Damping ratio ζ = c/(2√(k m)).
    DampingRatio,
    /// Static friction r_s, the force at which a body at rest is released.
    StaticFriction,
    /// Static friction ratio η = r_s/r_y.
    StaticFrictionRatio,
    /// Constant force p̄.
    MeanForce,
    /// Displacement about which the motion is symmetric, (p̄ − (r₊ − r₋)/2)/k.
    MeanDisplacement,
    /// Amplitude p₀ of the driving force.
    ForceAmplitude,
    /// Unbalance m_e e of a rotating mass.
    Unbalance,
    /// Rotating mass m_e.
    EccentricMass,
    /// Eccentricity e of a rotating mass.
    Eccentricity,
    /// Radius R of a friction pendulum.
    PendulumRadius,
    /// Amplitude u_g0 of the base motion.
    BaseAmplitude,
    /// Velocity amplitude of the base motion.
    BaseVelocity,
    /// Acceleration amplitude of the base motion.
    BaseAcceleration,
    /// Angular frequency ω_d of the drive.
    AngularFrequency,
    /// Frequency ratio Ω = ω_d/ω_n.
    FrequencyRatio,
    /// Force ratio α = p₀/r_y.
    ForceRatio,
    /// Friction displacement B = r_y/k.
    FrictionDisplacement,
    /// Velocity scale B ω_d.
    VelocityScale,
    /// Time scale 1/ω_d.
    TimeScale,
    /// Pseudo-elastic stiffness m ω_d².
    PseudoStiffness,
    /// Lossless static elastic energy p₀²/(2k).
    StaticEnergy,
    /// Lossless static pseudo-elastic energy p₀²/(2 m ω_d²).
    PseudoStaticEnergy,
    /// Phase ω_d t of the drive.
    DrivePhase,
    /// Whole cycles of the drive.
    DriveCycles,
    /// Displacement x/B.
    Displacement,
    /// Velocity v, in units of B ω_d (of B ω_n without a drive).
    Velocity,
    /// Samples in a cycle.
    SamplesPerCycle,
    /// Time step between the samples of a record.
    TimeStep,
    /// Time of a record.
    Time,
    /// Length of a record.
    Duration,
    /// Sample of a record.
    Sample,
    /// Factor by which a record is multiplied.
    ScaleFactor,
    /// Maximum displacement Δ₀, in physical units.
    MaxDisplacement,
    /// Maximum displacement Δ₀/B.
    MaxDisplacementRatio,
    /// Maximum velocity V₀, in physical units.
    MaxVelocity,
    /// Maximum velocity V₀/(B ω_d).
    MaxVelocityRatio,
    /// Loop size A₁.
    LoopSizeStiffness,
    /// Loop size A₂.
    LoopSizeInertia,
    /// Relative tolerance of an answer.
    Tolerance,
    /// Number of draws of the parameters.
    Draws,
    /// Bits of precision.
    Precision,
}

impl Quantity {
    #[must_use]
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Mass => "mass m",
            Self::Stiffness => "stiffness k",
            Self::NaturalPeriod => "natural period T",
            Self::FrictionBound => "friction bound r_y",
            Self::FrictionCoefficient => "coefficient of friction µ",
            Self::Gravity => "gravity g",
            Self::ForwardFriction => "forward friction r₊",
            Self::BackwardFriction => "backward friction r₋",
            Self::Damping => "damping constant c",
            Self::DampingRatio => "damping ratio ζ",
            Self::StaticFriction => "static friction r_s",
            Self::StaticFrictionRatio => "static friction ratio η",
            Self::MeanForce => "mean force p̄",
            Self::MeanDisplacement => "mean displacement (p̄ − (r₊ − r₋)/2)/k",
            Self::ForceAmplitude => "force amplitude p₀",
            Self::Unbalance => "unbalance m_e e",
            Self::EccentricMass => "eccentric mass m_e",
            Self::Eccentricity => "eccentricity e",
            Self::PendulumRadius => "pendulum radius R",
            Self::BaseAmplitude => "base amplitude u_g0",
            Self::BaseVelocity => "base velocity amplitude",
            Self::BaseAcceleration => "base acceleration amplitude",
            Self::AngularFrequency => "angular frequency ω_d",
            Self::FrequencyRatio => "frequency ratio Ω",
            Self::ForceRatio => "force ratio α",
            Self::FrictionDisplacement => "friction displacement B = r_y/k",
            Self::VelocityScale => "velocity scale B ω_d",
            Self::TimeScale => "time scale 1/ω_d",
            Self::PseudoStiffness => "pseudo-elastic stiffness m ω_d²",
            Self::StaticEnergy => "static elastic energy p₀²/(2k)",
            Self::PseudoStaticEnergy => "static pseudo-elastic energy p₀²/(2 m ω_d²)",
            Self::DrivePhase => "phase ω_d t",
            Self::DriveCycles => "whole cycles",
            Self::Displacement => "displacement x/B",
            Self::Velocity => "velocity v",
            Self::TimeStep => "time step",
            Self::Time => "time",
            Self::Duration => "duration",
            Self::Sample => "sample",
            Self::ScaleFactor => "scale factor",
            Self::SamplesPerCycle => "samples per cycle",
            Self::MaxDisplacement => "maximum displacement Δ₀",
            Self::MaxDisplacementRatio => "maximum displacement Δ₀/B",
            Self::MaxVelocity => "maximum velocity V₀",
            Self::MaxVelocityRatio => "maximum velocity V₀/(B ω_d)",
            Self::LoopSizeStiffness => "loop size A₁",
            Self::LoopSizeInertia => "loop size A₂",
            Self::Tolerance => "relative tolerance",
            Self::Draws => "number of draws",
            Self::Precision => "precision in bits",
        }
    }
}

/// Displays the name and the symbol.
impl Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
