//! The arguments of identification.

use super::{ForceArgs, Format, MachineArgs, UnitArgs};
use clap::Args;
use std::path::PathBuf;

pub(crate) const IDENTIFY_EXAMPLES: &str = "\
Friction and damping, with their standard errors, from a measured response curve of known mass, stiffness and drive.
The file has the columns frequency and amplitude (half of peak to peak), and optionally phase: ω_d t of the maximum
displacement, if the force is p₀ sin ω_d t. The header may have units: frequency[Hz],amplitude[mm],phase[deg].

Examples:
  stickslip identify curve.csv --mass 800kg --period 2.2s --base-acceleration 0.15g
  stickslip identify curve.csv --mass 50t --stiffness 1kN/mm --force 12kN --units kN,mm --format json";

#[derive(Debug, Args)]
pub(crate) struct IdentifyArgs {
    /// CSV of a measured response curve; - is standard input
    #[arg(value_name = "FILE")]
    pub(crate) file: PathBuf,
    #[command(flatten)]
    pub(crate) machine: MachineArgs,
    #[command(flatten)]
    pub(crate) force: ForceArgs,
    /// text or json
    #[arg(long, value_enum, default_value = "text", hide_possible_values = true)]
    pub(crate) format: Format,
    #[command(flatten)]
    pub(crate) units: UnitArgs,
}
