//! The definition of an output: its name, its equation, its units and its meaning.

use crate::float::Real;
use crate::oscillator::{Excitation, Scales};
use crate::units::Kind;

/// The unit of an output: in ratios, and in the units of a machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Measure {
    /// A count, a flag or a text, without a unit.
    Plain,
    /// A plain number.
    One,
    /// A phase in rad; 1/ω_d.
    Angle,
    /// Turns of the drive, 2π/ω_d.
    Turns,
    /// B = r_y/k.
    Length,
    /// B ω_d.
    Velocity,
    /// B ω_d².
    Acceleration,
    /// r_y.
    Force,
    /// A force over r_y as a plain number.
    ForceRatio,
    /// r_y B.
    Work,
    /// A plain number; an energy in p₀²/(2k).
    EnergyStiffness,
    /// A plain number; an energy in p₀²/(2 m ω_d²).
    EnergyInertia,
    /// A plain number; the energy of the largest loop, in p₀²/(2k).
    EnergyOfLargestLoop,
}

impl Measure {
    /// The unit in ratios as a text, which is empty for counts, flags and texts.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Plain => "",
            Self::One
            | Self::ForceRatio
            | Self::EnergyStiffness
            | Self::EnergyInertia
            | Self::EnergyOfLargestLoop => "1",
            Self::Angle => "rad",
            Self::Turns => "2π/ω_d",
            Self::Length => "B",
            Self::Velocity => "B ω_d",
            Self::Acceleration => "B ω_d²",
            Self::Force => "r_y",
            Self::Work => "r_y B",
        }
    }

    /// The kind of the quantity in the units of a machine.
    #[doc(hidden)]
    #[must_use]
    pub const fn kind(self) -> Kind {
        match self {
            Self::Plain | Self::One => Kind::Ratio,
            Self::Angle | Self::Turns => Kind::Time,
            Self::Length => Kind::Length,
            Self::Velocity => Kind::Velocity,
            Self::Acceleration => Kind::Acceleration,
            Self::Force | Self::ForceRatio => Kind::Force,
            Self::Work | Self::EnergyStiffness | Self::EnergyInertia | Self::EnergyOfLargestLoop => {
                Kind::Energy
            }
        }
    }

    /// The physical size of one unit.
    pub fn size<F: Real>(self, scales: &Scales<F>) -> F {
        match self {
            Self::Plain | Self::One => F::int(1),
            Self::Angle => scales.time,
            Self::Turns => F::int(2) * F::pi() * scales.time,
            Self::Length => scales.length,
            Self::Velocity => scales.velocity,
            Self::Acceleration => scales.velocity / scales.time,
            Self::Force | Self::ForceRatio => scales.force,
            Self::Work => scales.force * scales.length,
            Self::EnergyStiffness | Self::EnergyOfLargestLoop => scales.energy_stiffness,
            Self::EnergyInertia => scales.energy_inertia,
        }
    }
}

/// The name of an output in the units of a machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Physical {
    /// It has none.
    Absent,
    Named(&'static str),
    /// Only under a base that carries the surface.
    OverBase(&'static str),
    /// Not where the damper stands on the moving foot: it dissipates by the velocity between body and foot.
    UnlessDampedFoot(&'static str),
}

/// The definition of an output.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct Definition {
    /// Its name: the key in JSON, the column in tables.
    pub name: &'static str,
    /// Its symbol, or an empty text.
    pub symbol: &'static str,
    /// The number of its equation in the paper.
    pub equation: Option<u8>,
    /// Its unit.
    pub measure: Measure,
    /// The allowed error at f64 without damping, in units in the last place (docs/accuracy.md).
    pub ulps: Option<u8>,
    /// Its meaning, in a few words and without its unit.
    pub meaning: &'static str,
    /// A title for a picture, or an empty text where the name is clear.
    #[doc(hidden)]
    pub title: &'static str,
    physical: Physical,
    /// Whether it needs a search, or another cycle, of its own.
    #[doc(hidden)]
    pub is_searched: bool,
}

/// The columns of the table, for constants.
#[doc(hidden)]
impl Definition {
    #[must_use]
    pub const fn new(name: &'static str, measure: Measure, meaning: &'static str) -> Self {
        let physical = match measure.kind() {
            Kind::Ratio => Physical::Absent,
            _ => Physical::Named(name),
        };
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

    #[must_use]
    pub const fn symbol(self, symbol: &'static str) -> Self {
        Self { symbol, ..self }
    }

    #[must_use]
    pub const fn equation(self, number: u8) -> Self {
        Self { equation: Some(number), ..self }
    }

    #[must_use]
    pub const fn ulps(self, ulps: u8) -> Self {
        Self { ulps: Some(ulps), ..self }
    }

    #[must_use]
    pub const fn title(self, title: &'static str) -> Self {
        Self { title, ..self }
    }

    #[must_use]
    pub const fn searched(self) -> Self {
        Self { is_searched: true, ..self }
    }

    #[must_use]
    pub const fn physical(self, name: &'static str) -> Self {
        Self { physical: Physical::Named(name), ..self }
    }

    #[must_use]
    pub const fn without_physical(self) -> Self {
        Self { physical: Physical::Absent, ..self }
    }

    #[must_use]
    pub const fn over_base(self) -> Self {
        Self { physical: Physical::OverBase(self.name), ..self }
    }

    #[must_use]
    pub const fn unless_damped_foot(self, name: &'static str) -> Self {
        Self { physical: Physical::UnlessDampedFoot(name), ..self }
    }
}

impl Definition {
    /// The name of its value in the units of a machine under this excitation; `None` where there is no such
    /// value.
    #[must_use]
    pub fn physical_name(&self, excitation: Excitation) -> Option<&'static str> {
        match self.physical {
            Physical::Absent => None,
            Physical::Named(name) => Some(name),
            Physical::OverBase(name) => excitation.carries_surface().then_some(name),
            Physical::UnlessDampedFoot(name) => (excitation != Excitation::DampedFootMotion).then_some(name),
        }
    }

    /// Its meaning, with the number of its equation.
    #[must_use]
    pub fn text(&self) -> String {
        match self.equation {
            Some(number) if !self.meaning.contains("eq. ") => format!("{} (eq. {number})", self.meaning),
            Some(_) | None => self.meaning.to_owned(),
        }
    }
}
