//! The parameters: each quantity with its option, symbol, kind and column.

use stickslip::Quantity;
use stickslip::units::Kind;

/// One quantity that can be given.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Parameter {
    Omega,
    Mass,
    Stiffness,
    Period,
    Friction,
    FrictionCoefficient,
    Gravity,
    FrictionBackward,
    DampingRatio,
    Damping,
    StaticFrictionRatio,
    StaticFriction,
    MeanForce,
    Frequency,
    Alpha,
    Force,
    BaseAcceleration,
    BaseVelocity,
    BaseDisplacement,
    FootDisplacement,
    DampedFootDisplacement,
    /// The start of a motion, where a file of points has it.
    X0,
    V0,
}

use Parameter as P;

impl Parameter {
    pub(crate) const ALL: [Self; 21] = [
        P::Omega,
        P::Mass,
        P::Stiffness,
        P::Period,
        P::Friction,
        P::FrictionCoefficient,
        P::Gravity,
        P::FrictionBackward,
        P::DampingRatio,
        P::Damping,
        P::StaticFrictionRatio,
        P::StaticFriction,
        P::MeanForce,
        P::Frequency,
        P::Alpha,
        P::Force,
        P::BaseAcceleration,
        P::BaseVelocity,
        P::BaseDisplacement,
        P::FootDisplacement,
        P::DampedFootDisplacement,
    ];

    /// The option; without its dashes it is the name of a column.
    pub(crate) const fn option(self) -> &'static str {
        match self {
            P::Omega => "--omega",
            P::Mass => "--mass",
            P::Stiffness => "--stiffness",
            P::Period => "--period",
            P::Friction => "--friction",
            P::FrictionCoefficient => "--friction-coefficient",
            P::Gravity => "--gravity",
            P::FrictionBackward => "--friction-backward",
            P::DampingRatio => "--damping-ratio",
            P::Damping => "--damping",
            P::StaticFrictionRatio => "--static-friction-ratio",
            P::StaticFriction => "--static-friction",
            P::MeanForce => "--mean-force",
            P::Frequency => "--frequency",
            P::Alpha => "--alpha",
            P::Force => "--force",
            P::BaseAcceleration => "--base-acceleration",
            P::BaseVelocity => "--base-velocity",
            P::BaseDisplacement => "--base-displacement",
            P::FootDisplacement => "--foot-displacement",
            P::DampedFootDisplacement => "--damped-foot-displacement",
            P::X0 => "--x0",
            P::V0 => "--v0",
        }
    }

    /// The name of its column in a file of points.
    pub(crate) fn column(self) -> String {
        self.option().trim_start_matches('-').replace('-', "_")
    }

    /// Its symbol or short name, which a column of a file of points may have.
    pub(crate) const fn short(self) -> Option<&'static str> {
        if matches!(self, P::DampingRatio) {
            Some("zeta")
        } else if matches!(self, P::StaticFrictionRatio) {
            Some("eta")
        } else if matches!(self, P::FrictionCoefficient) {
            Some("mu")
        } else {
            None
        }
    }

    /// Whether a column of a file of points has its name, or that of its option's alias.
    pub(crate) fn is_column(self, name: &str) -> bool {
        self.column() == name || (self == P::StaticFrictionRatio && name == "static_ratio")
    }

    /// Whether it is a quantity of a machine in physical units.
    pub(crate) const fn is_physical(self) -> bool {
        !matches!(self, P::Omega | P::Alpha | P::DampingRatio | P::StaticFrictionRatio | P::X0 | P::V0)
    }

    /// Its symbol in checks that are made here and not by the library.
    pub(crate) const fn symbol(self) -> &'static str {
        match self {
            P::Omega => "frequency ratio Ω",
            P::Mass => "mass m",
            P::Stiffness => "stiffness k",
            P::Period => "natural period T",
            P::Friction => "friction bound r_y",
            P::FrictionCoefficient => "coefficient of friction µ",
            P::Gravity => "gravity g",
            P::FrictionBackward => "backward friction r₋",
            P::DampingRatio => "damping ratio ζ",
            P::Damping => "damping constant c",
            P::StaticFrictionRatio => "static friction ratio η",
            P::StaticFriction => "static friction r_s",
            P::MeanForce => "mean force p̄",
            P::Frequency => "angular frequency ω_d",
            P::Alpha => "force ratio α",
            P::Force => "force amplitude p₀",
            P::BaseAcceleration => "base acceleration amplitude",
            P::BaseVelocity => "base velocity amplitude",
            P::BaseDisplacement => "base amplitude",
            P::FootDisplacement | P::DampedFootDisplacement => "amplitude of the foot",
            P::X0 => "displacement at the start",
            P::V0 => "velocity at the start",
        }
    }

    pub(crate) const fn kind(self) -> Kind {
        match self {
            P::Omega | P::Alpha | P::FrictionCoefficient | P::DampingRatio | P::StaticFrictionRatio => {
                Kind::Ratio
            }
            P::Damping => Kind::Damping,
            P::Mass => Kind::Mass,
            P::Stiffness => Kind::Stiffness,
            P::Period => Kind::Time,
            P::Friction | P::FrictionBackward | P::StaticFriction | P::MeanForce | P::Force => Kind::Force,
            P::Gravity | P::BaseAcceleration => Kind::Acceleration,
            P::Frequency => Kind::Frequency,
            P::BaseVelocity | P::V0 => Kind::Velocity,
            P::BaseDisplacement | P::FootDisplacement | P::DampedFootDisplacement | P::X0 => Kind::Length,
        }
    }

    /// The quantities of the library that it determines.
    pub(super) const fn quantities(self) -> &'static [Quantity] {
        use Quantity as Q;
        match self {
            P::Omega => &[Q::FrequencyRatio, Q::Stiffness],
            P::Mass => &[Q::Mass, Q::FrequencyRatio, Q::PseudoStiffness],
            P::Stiffness | P::Period => &[Q::Stiffness, Q::FrequencyRatio, Q::FrictionDisplacement],
            P::Friction | P::FrictionCoefficient => {
                &[Q::FrictionBound, Q::ForwardFriction, Q::ForceRatio, Q::FrictionDisplacement]
            }
            P::Gravity => &[Q::FrictionBound, Q::ForwardFriction],
            P::FrictionBackward => &[Q::BackwardFriction],
            P::DampingRatio => &[Q::DampingRatio],
            P::Damping => &[Q::Damping, Q::DampingRatio],
            P::StaticFrictionRatio => &[Q::StaticFrictionRatio],
            P::StaticFriction => &[Q::StaticFriction, Q::StaticFrictionRatio],
            P::MeanForce => &[Q::MeanForce, Q::MeanDisplacement],
            P::Frequency => {
                &[Q::AngularFrequency, Q::FrequencyRatio, Q::VelocityScale, Q::TimeScale, Q::PseudoStiffness]
            }
            P::Alpha => &[Q::ForceRatio, Q::ForceAmplitude],
            P::Force => &[Q::ForceAmplitude, Q::ForceRatio, Q::StaticEnergy, Q::PseudoStaticEnergy],
            P::X0 => &[Q::Displacement],
            P::V0 => &[Q::Velocity],
            P::BaseAcceleration
            | P::BaseVelocity
            | P::BaseDisplacement
            | P::FootDisplacement
            | P::DampedFootDisplacement => &[
                Q::BaseAmplitude,
                Q::BaseVelocity,
                Q::BaseAcceleration,
                Q::ForceAmplitude,
                Q::ForceRatio,
                Q::StaticEnergy,
                Q::PseudoStaticEnergy,
            ],
        }
    }

    /// The parameters that the border of sticking depends on.
    pub(crate) const BORDER: [Self; 13] = [
        P::Omega,
        P::Mass,
        P::Stiffness,
        P::Period,
        P::Friction,
        P::FrictionCoefficient,
        P::Gravity,
        P::FrictionBackward,
        P::DampingRatio,
        P::Damping,
        P::StaticFrictionRatio,
        P::StaticFriction,
        P::Frequency,
    ];

    /// Damping, by its ratio or its constant.
    pub(crate) const DAMPERS: [Self; 2] = [P::DampingRatio, P::Damping];

    /// Static friction above the kinetic one, by its ratio or its force.
    pub(crate) const STATIC_FRICTIONS: [Self; 2] = [P::StaticFrictionRatio, P::StaticFriction];

    /// The start of a motion.
    pub(crate) const START: [Self; 2] = [P::X0, P::V0];

    /// The parameters of a machine and its drive: one of each of these groups.
    pub(crate) const OF_A_MACHINE: [&'static [Self]; 5] = [
        &[P::Mass],
        &[P::Stiffness, P::Period, P::Omega],
        &[P::Friction, P::FrictionCoefficient],
        &[P::Frequency, P::Omega],
        &Self::DRIVES,
    ];

    /// The excitations: exactly one of these is given.
    pub(crate) const DRIVES: [Self; 7] = [
        P::Force,
        P::BaseAcceleration,
        P::BaseVelocity,
        P::BaseDisplacement,
        P::FootDisplacement,
        P::DampedFootDisplacement,
        P::Alpha,
    ];
}
