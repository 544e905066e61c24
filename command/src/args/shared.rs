//! The arguments that several commands have.

use clap::{Args, ValueEnum};
use std::path::PathBuf;
use stickslip::units::{Reader, System};

/// The oscillator and its frequency. A value may have a unit, such as 800kg. Bare numbers are in one
/// consistent system.
#[derive(Debug, Clone, Default, Args)]
pub(crate) struct MachineArgs {
    /// Frequency ratio Ω = ω_d/ω_n
    #[arg(long, value_name = "Ω", allow_hyphen_values = true)]
    pub(crate) omega: Option<String>,
    /// Mass m, such as 800kg
    #[arg(long, value_name = "M", allow_hyphen_values = true)]
    pub(crate) mass: Option<String>,
    /// Stiffness k, such as 12kN/mm, or in its place a period, or Ω and a frequency
    #[arg(long, value_name = "K", allow_hyphen_values = true)]
    pub(crate) stiffness: Option<String>,
    /// Natural period of the body on its spring, such as 2.2s, in place of the stiffness: k = m (2π/T)²
    #[arg(long, value_name = "T", allow_hyphen_values = true)]
    pub(crate) period: Option<String>,
    /// Friction bound r_y, such as 5kN
    #[arg(long, value_name = "RY", allow_hyphen_values = true)]
    pub(crate) friction: Option<String>,
    /// Coefficient of friction µ of a body that rests on its surface, in place of the bound: r_y = µ m g
    #[arg(long, value_name = "µ", allow_hyphen_values = true)]
    pub(crate) friction_coefficient: Option<String>,
    /// Gravity g for the coefficient of friction [default: 9.80665 m/s²]
    #[arg(long, value_name = "G", allow_hyphen_values = true)]
    pub(crate) gravity: Option<String>,
    /// Friction bound of backward motion, such as 4kN, where it differs from that of forward motion (r_y and
    /// r_s are the means of both directions, and at rest the bounds are η r_y ± (r₊ − r₋)/2)
    #[arg(long, value_name = "R", allow_hyphen_values = true)]
    pub(crate) friction_backward: Option<String>,
    /// Viscous damping ratio ζ = c/(2√(k m)), such as 0.05 or 5% (a bare 5 is 500 %)
    #[arg(long, value_name = "ζ", allow_hyphen_values = true)]
    pub(crate) damping_ratio: Option<String>,
    /// Damping constant c of a viscous damper, such as 20kN*s/m, in place of the ratio
    #[arg(long, value_name = "C", allow_hyphen_values = true)]
    pub(crate) damping: Option<String>,
    /// Static friction ratio η = r_s/r_y, such as 1.3: a body at rest stays until the force exceeds η r_y
    /// [default: 1]
    #[arg(long, value_name = "η", allow_hyphen_values = true, visible_alias = "static-ratio")]
    pub(crate) static_friction_ratio: Option<String>,
    /// Static friction r_s, such as 6.5kN, in place of the ratio
    #[arg(long, value_name = "RS", allow_hyphen_values = true)]
    pub(crate) static_friction: Option<String>,
    /// Constant force on the body, such as a preload of 2kN. It shifts the motion by P/k, and displacements are
    /// measured from the mean displacement
    #[arg(long, value_name = "P", allow_hyphen_values = true)]
    pub(crate) mean_force: Option<String>,
    /// Frequency of the drive, such as 2Hz, 120rpm or 12.5rad/s, where a bare number is ω_d in rad/s
    #[arg(long, value_name = "WD", allow_hyphen_values = true)]
    pub(crate) frequency: Option<String>,
}

/// What shakes the body: one of these.
#[derive(Debug, Clone, Default, Args)]
pub(crate) struct ForceArgs {
    /// Force ratio α = p₀/r_y
    #[arg(long, value_name = "α", allow_hyphen_values = true)]
    pub(crate) alpha: Option<String>,
    /// Amplitude p₀ of a force on the body, such as 12kN
    #[arg(long, value_name = "P0", allow_hyphen_values = true)]
    pub(crate) force: Option<String>,
    /// Acceleration amplitude of a base that carries the surface, such as 0.15g: p₀ = m a₀, x relative to the
    /// base
    #[arg(long, value_name = "A0", allow_hyphen_values = true)]
    pub(crate) base_acceleration: Option<String>,
    /// Velocity amplitude of a base that carries the surface, such as 30mm/s: p₀ = m ω_d v₀
    #[arg(long, value_name = "V0", allow_hyphen_values = true)]
    pub(crate) base_velocity: Option<String>,
    /// Displacement amplitude of a base that carries the surface, such as 9mm: p₀ = m ω_d² u₀
    #[arg(long, value_name = "U0", allow_hyphen_values = true)]
    pub(crate) base_displacement: Option<String>,
    /// Displacement amplitude of the spring's foot over a fixed surface, such as 9mm: p₀ = k u₀
    #[arg(long, value_name = "U0", allow_hyphen_values = true, alias = "base-motion")]
    pub(crate) foot_displacement: Option<String>,
    /// The same with the damper on the moving foot, too: p₀ = √(k² + c²ω_d²) u₀
    #[arg(long, value_name = "U0", allow_hyphen_values = true)]
    pub(crate) damped_foot_displacement: Option<String>,
}

#[derive(Debug, Args)]
pub(crate) struct OutputArgs {
    /// CSV with a header, answered row by row: columns omega and alpha, or of a machine, such as
    /// frequency[Hz] (values that all rows share may be arguments). - is standard input
    #[arg(long, value_name = "FILE")]
    pub(crate) points: Option<PathBuf>,
    /// text or json for one answer [default: text], jsonl or csv for --points [default: jsonl]
    #[arg(long, value_enum)]
    pub(crate) format: Option<Format>,
    /// Header of CSV: names, or names with their units in brackets, such as max_displacement[B]
    #[arg(long, value_enum, default_value = "names", value_name = "HEADER")]
    pub(crate) header: Header,
    /// Bits of precision (needs a build with the feature mp)
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = super::bits)]
    pub(crate) bits: Option<u32>,
    #[command(flatten)]
    pub(crate) units: UnitArgs,
}

/// The system of units.
#[derive(Debug, Clone, Default, Args)]
pub(crate) struct UnitArgs {
    /// Units of the answers, such as kN,mm, and the system of bare numbers (values with units are converted)
    /// [default: N,m]
    #[arg(long, value_name = "FORCE,LENGTH")]
    pub(crate) units: Option<System>,
}

impl UnitArgs {
    pub(crate) fn reader(&self) -> Reader {
        Reader::new(self.units.as_ref(), "--units kN,m")
    }
}

/// What stands in the first line of CSV.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Header {
    Names,
    Units,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    Text,
    Json,
    Jsonl,
    Csv,
}
