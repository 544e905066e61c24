//! The kind of a value: its dimension, and its usual units.

/// Exponents of mass, length, time and angle.
pub type Dimension = [i8; 4];

/// One row for each kind: its dimension, its name, and the quantity with its usual units. Of two kinds of one
/// dimension the first is that of a unit.
macro_rules! kinds {
    ($($(#[$doc:meta])+ $kind:ident $dimension:tt $name:literal $expected:literal;)*) => {
        /// The kind of a quantity, which determines the units of its values.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum Kind {
            $($(#[$doc])+ $kind,)*
        }

        impl Kind {
            const ALL: [Self; [$($name),*].len()] = [$(Self::$kind),*];

            /// The exponents of mass, length, time and angle.
            #[must_use]
            pub const fn dimension(self) -> Dimension {
                match self {
                    $(Self::$kind => $dimension,)*
                }
            }

            /// The name of the kind.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$kind => $name,)*
                }
            }

            /// The quantity with its usual units, for the error about another unit.
            #[must_use]
            pub const fn expected(self) -> &'static str {
                match self {
                    $(Self::$kind => $expected,)*
                }
            }
        }
    };
}

kinds! {
    /// A plain number, or a percentage.
    Ratio [0, 0, 0, 0] "ratio" "a plain number, or a percentage (%)";
    /// kg, g, t, lb.
    Mass [1, 0, 0, 0] "mass" "a mass (kg, g, t, lb)";
    /// m, mm, in.
    Length [0, 1, 0, 0] "length" "a length (m, mm, in)";
    /// s, ms.
    Time [0, 0, 1, 0] "time" "a time (s, ms)";
    /// rad, deg.
    Angle [0, 0, 0, 1] "angle" "an angle (rad, deg)";
    /// Hz, rad/s, rpm; in rad/s, whatever the system.
    Frequency [0, 0, -1, 1] "frequency" "a frequency (Hz, rad/s, rpm, cpm)";
    /// Frequency in cycles per second: Hz.
    Hertz [0, 0, -1, 1] "frequency" "a frequency (Hz, rad/s, rpm, cpm)";
    /// m/s, mm/s, in/s.
    Velocity [0, 1, -1, 0] "velocity" "a velocity (m/s, mm/s, in/s)";
    /// g, m/s², mm/s².
    Acceleration [0, 1, -2, 0] "acceleration" "an acceleration (g, m/s^2, mm/s^2)";
    /// N, kN, lbf.
    Force [1, 1, -2, 0] "force" "a force (N, kN, lbf)";
    /// N/m, kN/m, kN/mm, lbf/in.
    Stiffness [1, 0, -2, 0] "stiffness" "a stiffness (N/m, kN/m, kN/mm, lbf/in)";
    /// N·s/m, kN·s/m.
    Damping [1, 0, -1, 0] "damping constant" "a damping constant (N*s/m, kN*s/m)";
    /// J, kJ.
    Energy [1, 2, -2, 0] "energy" "an energy (J, kJ)";
    /// Mass times length: kg·m, g·mm.
    Unbalance [1, 1, 0, 0] "unbalance" "an unbalance (kg*m, g*mm)";
}

impl Kind {
    /// The kind of a dimension, if there is one.
    #[must_use]
    pub fn of(dimension: Dimension) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.dimension() == dimension)
    }

    /// The kind of this name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }

    /// Whether the number is the same in all systems of units.
    #[must_use]
    pub const fn is_dimensionless(self) -> bool {
        matches!(self, Self::Ratio | Self::Angle)
    }
}
