//! The kind of a value: its dimension, and its usual units.

/// Exponents of mass, length, time and angle.
pub(super) type Dimension = [i8; 4];

/// The kind of a quantity, which determines the units of its values.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Kind {
    /// A plain number, or a percentage.
    Ratio,
    /// kg, g, t, lb.
    Mass,
    /// m, mm, in.
    Length,
    /// s, ms.
    Time,
    /// rad, deg.
    Angle,
    /// Hz, rad/s, rpm; in rad/s, whatever the system.
    Frequency,
    /// Frequency in cycles per second: Hz.
    Hertz,
    /// m/s, mm/s, in/s.
    Velocity,
    /// g, m/s², mm/s².
    Acceleration,
    /// N, kN, lbf.
    Force,
    /// N/m, kN/m, kN/mm, lbf/in.
    Stiffness,
    /// N·s/m, kN·s/m.
    Damping,
    /// J, kJ.
    Energy,
    /// Mass times length: kg·m, g·mm.
    Unbalance,
}

impl Kind {
    const ALL: [Self; 13] = [
        Self::Ratio,
        Self::Mass,
        Self::Length,
        Self::Time,
        Self::Angle,
        Self::Frequency,
        Self::Velocity,
        Self::Acceleration,
        Self::Force,
        Self::Stiffness,
        Self::Damping,
        Self::Energy,
        Self::Unbalance,
    ];

    pub(super) const fn dimension(self) -> Dimension {
        match self {
            Self::Ratio => [0, 0, 0, 0],
            Self::Mass => [1, 0, 0, 0],
            Self::Length => [0, 1, 0, 0],
            Self::Time => [0, 0, 1, 0],
            Self::Angle => [0, 0, 0, 1],
            Self::Frequency | Self::Hertz => [0, 0, -1, 1],
            Self::Velocity => [0, 1, -1, 0],
            Self::Acceleration => [0, 1, -2, 0],
            Self::Force => [1, 1, -2, 0],
            Self::Stiffness => [1, 0, -2, 0],
            Self::Damping => [1, 0, -1, 0],
            Self::Energy => [1, 2, -2, 0],
            Self::Unbalance => [1, 1, 0, 0],
        }
    }

    /// The kind of a dimension, if there is one.
    pub(super) fn of(dimension: Dimension) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.dimension() == dimension)
    }

    /// The kind of this name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }

    /// Whether the number is the same in all systems of units.
    #[must_use]
    pub(crate) const fn is_dimensionless(self) -> bool {
        matches!(self, Self::Ratio | Self::Angle)
    }

    /// The name of the kind.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Ratio => "ratio",
            Self::Mass => "mass",
            Self::Length => "length",
            Self::Time => "time",
            Self::Angle => "angle",
            Self::Frequency | Self::Hertz => "frequency",
            Self::Velocity => "velocity",
            Self::Acceleration => "acceleration",
            Self::Force => "force",
            Self::Stiffness => "stiffness",
            Self::Damping => "damping constant",
            Self::Energy => "energy",
            Self::Unbalance => "unbalance",
        }
    }

    /// The quantity with its usual units, for the error about another unit.
    pub(super) const fn expected(self) -> &'static str {
        match self {
            Self::Ratio => "a plain number, or a percentage (%)",
            Self::Mass => "a mass (kg, g, t, lb)",
            Self::Length => "a length (m, mm, in)",
            Self::Time => "a time (s, ms)",
            Self::Angle => "an angle (rad, deg)",
            Self::Frequency | Self::Hertz => "a frequency (Hz, rad/s, rpm, cpm)",
            Self::Velocity => "a velocity (m/s, mm/s, in/s)",
            Self::Acceleration => "an acceleration (g, m/s^2, mm/s^2)",
            Self::Force => "a force (N, kN, lbf)",
            Self::Stiffness => "a stiffness (N/m, kN/m, kN/mm, lbf/in)",
            Self::Damping => "a damping constant (N*s/m, kN*s/m)",
            Self::Energy => "an energy (J, kJ)",
            Self::Unbalance => "an unbalance (kg*m, g*mm)",
        }
    }
}
