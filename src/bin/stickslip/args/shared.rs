//! The arguments that several commands have.

use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// The oscillator and its frequency. In physical units, any consistent system.
#[derive(Debug, Args)]
pub(crate) struct MachineArgs {
    /// Frequency ratio Ω = ω_d/ω_n
    #[arg(long, value_name = "Ω", allow_hyphen_values = true)]
    pub(crate) omega: Option<String>,
    /// Mass m (SI: kg)
    #[arg(long, value_name = "M", allow_hyphen_values = true)]
    pub(crate) mass: Option<String>,
    /// Stiffness k (SI: N/m); or give --omega, and k = m (ω_d/Ω)²
    #[arg(long, value_name = "K", allow_hyphen_values = true)]
    pub(crate) stiffness: Option<String>,
    /// Friction bound r_y (SI: N)
    #[arg(long, value_name = "RY", allow_hyphen_values = true)]
    pub(crate) friction: Option<String>,
    /// Angular frequency ω_d of the drive, in rad per unit of time (SI: rad/s)
    #[arg(long, value_name = "WD", allow_hyphen_values = true)]
    pub(crate) frequency: Option<String>,
}

/// How hard it is shaken.
#[derive(Debug, Args)]
pub(crate) struct ForceArgs {
    /// Force ratio α = p₀/r_y
    #[arg(long, value_name = "α", allow_hyphen_values = true)]
    pub(crate) alpha: Option<String>,
    /// Force amplitude p₀ (SI: N)
    #[arg(long, value_name = "P0", allow_hyphen_values = true)]
    pub(crate) force: Option<String>,
    /// Amplitude u_g0 of the base motion (SI: m); p₀ = k u_g0
    #[arg(long, value_name = "UG", allow_hyphen_values = true)]
    pub(crate) base_motion: Option<String>,
}

#[derive(Debug, Args)]
pub(crate) struct OutputArgs {
    /// CSV of ratios with a header (columns omega, and alpha for a response), answered row by row; - is
    /// standard input
    #[arg(long, value_name = "FILE")]
    pub(crate) points: Option<PathBuf>,
    /// text or json for one answer [default: text]; jsonl or csv for --points [default: jsonl]
    #[arg(long, value_enum)]
    pub(crate) format: Option<Format>,
    /// Bits of precision (needs a build with the feature mp)
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = super::bits)]
    pub(crate) bits: Option<u32>,
    /// Names of the units of force and length in the text answer
    #[arg(long, value_name = "FORCE,LENGTH", default_value = "N,m", value_parser = UnitNames::parse)]
    pub(crate) units: UnitNames,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    Text,
    Json,
    Jsonl,
    Csv,
}

/// Names of the units of force and length, for the text answer.
#[derive(Debug, Clone)]
pub(crate) struct UnitNames {
    pub(crate) force: String,
    pub(crate) length: String,
}

impl UnitNames {
    pub(super) fn parse(text: &str) -> Result<Self, String> {
        match text.split_once(',') {
            Some((force, length)) if !force.is_empty() && !length.is_empty() => {
                Ok(Self { force: force.to_owned(), length: length.to_owned() })
            }
            Some(_) | None => Err("two names with a comma between are due, such as kN,m".to_owned()),
        }
    }
}
