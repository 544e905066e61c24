//! The quantities of the input.

use core::fmt::{self, Display};

/// One row for each quantity: its name in an error follows it.
macro_rules! quantities {
    ($($(#[$doc:meta])+ $quantity:ident $name:literal;)*) => {
        /// A physical or dimensionless quantity of the input.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum Quantity {
            $($(#[$doc])+ $quantity,)*
        }

        impl Quantity {
            /// The name with its symbol, as an error has it.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$quantity => $name,)*
                }
            }
        }
    };
}

quantities! {
    /// Mass m of the body.
    Mass "mass m";
    /// Stiffness k of the spring.
    Stiffness "stiffness k";
    /// Natural period T of the body on its spring.
    NaturalPeriod "natural period T";
    /// Natural angular frequency ω_n = √(k/m).
    NaturalFrequency "natural frequency ω_n";
    /// Weight W = m g of the body.
    Weight "weight W";
    /// Friction force r_y, the maximum force friction can carry.
    FrictionBound "friction force r_y";
    /// Coefficient of friction µ.
    FrictionCoefficient "coefficient of friction µ";
    /// Acceleration of the surface at which a block begins to slide, a_y.
    YieldAcceleration "yield acceleration a_y";
    /// Gravity g.
    Gravity "gravity g";
    /// Friction r₊ against motion with x′ > 0.
    ForwardFriction "forward friction r₊";
    /// Friction r₋ against motion with x′ < 0.
    BackwardFriction "backward friction r₋";
    /// Damping constant c.
    Damping "damping constant c";
    /// Damping ratio ζ = c/(2√(k m)).
    DampingRatio "damping ratio ζ";
    /// Static friction r_s, the force at which a body at rest is released.
    StaticFriction "static friction r_s";
    /// Static friction ratio η = r_s/r_y.
    StaticFrictionRatio "static friction ratio η";
    /// Constant force p̄.
    MeanForce "mean force p̄";
    /// Displacement about which the motion is symmetric, (p̄ − (r₊ − r₋)/2)/k.
    MeanDisplacement "mean displacement (p̄ − (r₊ − r₋)/2)/k";
    /// Amplitude p₀ of the driving force.
    ForceAmplitude "force amplitude p₀";
    /// Unbalance m_e e of a rotating mass.
    Unbalance "unbalance m_e e";
    /// Rotating mass m_e.
    EccentricMass "eccentric mass m_e";
    /// Eccentricity e of a rotating mass.
    Eccentricity "eccentricity e";
    /// Radius R of a friction pendulum.
    PendulumRadius "pendulum radius R";
    /// Amplitude u_g0 of the base motion.
    BaseAmplitude "base amplitude u_g0";
    /// Velocity amplitude of the base motion.
    BaseVelocity "base velocity amplitude";
    /// Acceleration amplitude of the base motion.
    BaseAcceleration "base acceleration amplitude";
    /// Angular frequency ω_d of the drive.
    AngularFrequency "angular frequency ω_d";
    /// Frequency ratio Ω = ω_d/ω_n.
    FrequencyRatio "frequency ratio Ω";
    /// Force ratio α = p₀/r_y.
    ForceRatio "force ratio α";
    /// Friction displacement B = r_y/k.
    FrictionDisplacement "friction displacement B = r_y/k";
    /// Velocity scale B ω_d.
    VelocityScale "velocity scale B ω_d";
    /// Time scale 1/ω_d.
    TimeScale "time scale 1/ω_d";
    /// Pseudo-elastic stiffness m ω_d².
    PseudoStiffness "pseudo-elastic stiffness m ω_d²";
    /// Lossless static elastic energy p₀²/(2k).
    StaticEnergy "static elastic energy p₀²/(2k)";
    /// Lossless static pseudo-elastic energy p₀²/(2 m ω_d²).
    PseudoStaticEnergy "static pseudo-elastic energy p₀²/(2 m ω_d²)";
    /// Phase ω_d t of the drive.
    DrivePhase "phase ω_d t";
    /// Whole cycles of the drive.
    DriveCycles "whole cycles";
    /// Displacement x/B.
    Displacement "displacement x/B";
    /// Velocity v, in units of B ω_d (of B ω_n without a drive).
    Velocity "velocity v";
    /// Samples in a cycle.
    SamplesPerCycle "samples per cycle";
    /// Time step between the samples of a record.
    TimeStep "time step";
    /// Time of a record.
    Time "time";
    /// Length of a record.
    Duration "duration";
    /// Sample of a record.
    Sample "sample";
    /// Factor by which a record is multiplied.
    ScaleFactor "scale factor";
    /// Peak displacement Δ₀, in physical units.
    MaxDisplacement "peak displacement Δ₀";
    /// Peak displacement Δ₀/B.
    MaxDisplacementRatio "peak displacement Δ₀/B";
    /// Peak velocity V₀, in physical units.
    MaxVelocity "peak velocity V₀";
    /// Peak velocity V₀/(B ω_d).
    MaxVelocityRatio "peak velocity V₀/(B ω_d)";
    /// Loop size A₁.
    LoopSizeStiffness "loop size A₁";
    /// Loop size A₂.
    LoopSizeInertia "loop size A₂";
    /// Relative tolerance of an answer.
    Tolerance "relative tolerance";
    /// Number of draws of the parameters.
    Draws "number of draws";
    /// Bits of precision.
    Precision "precision in bits";
}

impl Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
