//! The definition of an output: its name, its equation, its units and its meaning.

use crate::float::Real;
use crate::machine::oscillator::{Excitation, Scales};
use crate::output::Kind;
use alloc::borrow::ToOwned;
use alloc::format;
use alloc::string::String;

/// Defines the measures from one row each: the unit in ratios as a text, the kind of the quantity in the units
/// of a machine, and the physical size of one unit.
macro_rules! measures {
    ($($(#[$doc:meta])* $measure:ident: $unit:literal, $kind:ident, $scales:ident => $size:expr;)*) => {
        /// The unit of an output: in ratios, and in the units of a machine.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum Measure {
            $($(#[$doc])* $measure,)*
        }

        impl Measure {
            /// The unit in ratios as a text, which is empty for counts, flags and texts.
            #[must_use]
            pub const fn unit(self) -> &'static str {
                match self {
                    $(Self::$measure => $unit,)*
                }
            }

            /// The kind of the quantity in the units of a machine.
            #[doc(hidden)]
            #[must_use]
            pub const fn kind(self) -> Kind {
                match self {
                    $(Self::$measure => Kind::$kind,)*
                }
            }

            /// The physical size of one unit; that of the largest loop at the best force ratio is half of p₀²/k for
            /// the best force.
            #[doc(hidden)]
            pub fn size_with<F: Real>(self, scales: &Scales<F>, best_force_ratio: F, stiffness: F) -> F {
                if matches!(self, Self::EnergyOfLargestLoop) {
                    let best_force = best_force_ratio * scales.force;
                    return F::ratio(1, 2) * best_force * (best_force / stiffness);
                }
                self.size(scales)
            }

            /// The physical size of one unit.
            #[doc(hidden)]
            pub fn size<F: Real>(self, scales: &Scales<F>) -> F {
                match self {
                    $(Self::$measure => {
                        let $scales = scales;
                        $size
                    })*
                }
            }
        }
    };
}

measures! {
    /// A count, a flag or a text, without a unit.
    Plain: "", Ratio, _scales => F::int(1);
    /// A plain number.
    One: "1", Ratio, _scales => F::int(1);
    /// A phase in rad; 1/ω_d.
    Angle: "rad", Time, scales => scales.time;
    /// Turns of the drive, 2π/ω_d.
    Turns: "2π/ω_d", Time, scales => F::int(2) * F::pi() * scales.time;
    /// B = r_y/k.
    Length: "B", Length, scales => scales.length;
    /// B ω_d.
    Velocity: "B ω_d", Velocity, scales => scales.velocity;
    /// B ω_d².
    Acceleration: "B ω_d²", Acceleration, scales => scales.velocity / scales.time;
    /// r_y.
    Force: "r_y", Force, scales => scales.force;
    /// k = r_y/B.
    Stiffness: "k", Stiffness, scales => scales.force / scales.length;
    /// k/ω_d.
    Damping: "k/ω_d", Damping, scales => scales.force / scales.velocity;
    /// A force over r_y as a plain number.
    ForceRatio: "1", Force, scales => scales.force;
    /// r_y B.
    Work: "r_y B", Energy, scales => scales.force * scales.length;
    /// A plain number; an energy in p₀²/(2k).
    EnergyStiffness: "1", Energy, scales => scales.energy_stiffness;
    /// A plain number; an energy in p₀²/(2 m ω_d²).
    EnergyInertia: "1", Energy, scales => scales.energy_inertia;
    /// A plain number; the energy of the largest loop, in p₀²/(2k).
    EnergyOfLargestLoop: "1", Energy, scales => scales.energy_stiffness;
}

/// The name of an output in the units of a machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
enum PhysicalName {
    /// The output has no such name.
    Absent,
    Named(&'static str),
    /// The name, which applies only where the support or the base moves.
    OverBase(&'static str),
}

/// The definition of an output.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub struct Definition {
    /// The output's name: the key in JSON, the column in tables.
    pub name: &'static str,
    /// The output's symbol, or an empty text.
    pub symbol: &'static str,
    /// The number of the output's equation in the paper.
    pub equation: Option<u8>,
    /// The output's unit.
    pub measure: Measure,
    /// The allowed error at f64 without damping, in units in the last place (docs/development/accuracy.md).
    pub ulps: Option<u8>,
    /// The output's meaning, in a few words and without its unit.
    pub meaning: &'static str,
    /// A title for a picture, or an empty text where the name is clear.
    #[doc(hidden)]
    pub title: &'static str,
    physical: PhysicalName,
    /// Whether the output needs a search, or another cycle, of its own.
    #[doc(hidden)]
    pub is_searched: bool,
}

/// Defines a function for each column that has a value by default.
macro_rules! facts {
    ($($column:ident($($value:ident: $type:ty)?) => $field:ident = $set:expr;)*) => {
        $(
            #[must_use]
            pub const fn $column(self $(, $value: $type)?) -> Self {
                Self { $field: $set, ..self }
            }
        )*
    };
}

/// The columns of the table, for constants.
#[doc(hidden)]
impl Definition {
    #[must_use]
    pub const fn new(name: &'static str, measure: Measure, meaning: &'static str) -> Self {
        let is_plain = matches!(measure.kind(), Kind::Ratio);
        let physical = if is_plain { PhysicalName::Absent } else { PhysicalName::Named(name) };
        let (symbol, title) = ("", "");
        Self {
            name,
            symbol,
            equation: None,
            measure,
            ulps: None,
            meaning,
            title,
            physical,
            is_searched: false,
        }
    }

    facts! {
        symbol(symbol: &'static str) => symbol = symbol;
        equation(number: u8) => equation = Some(number);
        ulps(ulps: u8) => ulps = Some(ulps);
        title(title: &'static str) => title = title;
        searched() => is_searched = true;
        physical(name: &'static str) => physical = PhysicalName::Named(name);
        without_physical() => physical = PhysicalName::Absent;
        over_base(name: &'static str) => physical = PhysicalName::OverBase(name);
    }
}

impl Definition {
    /// The name of the output's value in the units of a machine under this excitation; `None` where there is
    /// no such value.
    #[doc(hidden)]
    #[must_use]
    pub fn physical_name(&self, excitation: Excitation) -> Option<&'static str> {
        match self.physical {
            PhysicalName::Absent => None,
            PhysicalName::Named(name) => Some(name),
            PhysicalName::OverBase(name) => excitation.moves_base().then_some(name),
        }
    }

    /// The output's meaning, with the number of its equation.
    #[doc(hidden)]
    #[must_use]
    pub fn text(&self) -> String {
        match self.equation {
            Some(number) if !self.meaning.contains("eq. ") => format!("{} (eq. {number})", self.meaning),
            Some(_) | None => self.meaning.to_owned(),
        }
    }
}

/// Defines constants from one row each: the name in Rust, and the definition as in the table of outputs.
#[doc(hidden)]
#[macro_export]
macro_rules! define {
    ($(
        $visible:vis $constant:ident($name:literal, $measure:ident, $meaning:expr) $(.$column:ident($($fact:expr)?))*;
    )*) => {
        $(
            $visible const $constant: &$crate::Definition =
                &$crate::Definition::new($name, $crate::Measure::$measure, $meaning)$(.$column($($fact)?))*;
        )*
    };
}
