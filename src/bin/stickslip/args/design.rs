//! The arguments of the inverse problems.

use super::{ForceArgs, Format, MachineArgs, UnitArgs};
use clap::{Args, Subcommand};

pub(crate) const DESIGN_EXAMPLES: &str = "\
Examples:
  stickslip design force --mass 50 --stiffness 1000 --friction 5 --frequency 6
  stickslip design friction --mass 50 --stiffness 1000 --frequency 6 --force 12
  stickslip design bands --alpha 12 --from 0.1 --to 2
  stickslip design bands --alpha 80 --from 0.3 --to 0.4 --no-stop
  stickslip design displacement --omega 1.5 --target 2
  stickslip design dissipation --mass 50t --stiffness 1000kN/m --frequency 6rad/s --force 12kN --units kN,m
  stickslip design stiffness --mass 50 --friction 5 --frequency 6 --force 12 --from 500 --to 1500";

/// What is asked, in ratios or in physical units.
#[derive(Debug, Subcommand)]
pub(crate) enum Question {
    /// The least force, or base motion, that keeps it from sticking
    Force(QuestionArgs),
    /// The greatest friction with which a force keeps it from sticking
    Friction(QuestionArgs),
    /// The frequencies, between --from and --to, at which it never sticks
    Bands(QuestionArgs),
    /// The force for the maximum displacement --target
    Displacement(QuestionArgs),
    /// The force for the maximum velocity --target
    Velocity(QuestionArgs),
    /// The friction that dissipates most, without sticking or, with --sticking, of all
    Dissipation(QuestionArgs),
    /// The stiffness, between --from and --to, that dissipates most without sticking
    Stiffness(QuestionArgs),
}

#[derive(Debug, Args)]
pub(crate) struct QuestionArgs {
    #[command(flatten)]
    pub(crate) machine: MachineArgs,
    #[command(flatten)]
    pub(crate) force: ForceArgs,
    /// Lower end of a range: of Ω or, in physical units, of what is asked for
    #[arg(long, value_name = "LOW", allow_hyphen_values = true)]
    pub(crate) from: Option<String>,
    /// Upper end of a range
    #[arg(long, value_name = "HIGH", allow_hyphen_values = true)]
    pub(crate) to: Option<String>,
    /// Of dissipation: sticking allowed, to a proven tolerance of 1e-6
    #[arg(long)]
    pub(crate) sticking: bool,
    /// Of force and bands: any motion without a stop counts, also of six reversals a cycle beside 1/3, 1/5, …
    #[arg(long)]
    pub(crate) no_stop: bool,
    /// What is to be reached: in units of B or B ω_d, or of length or length per time
    #[arg(long, value_name = "X", allow_hyphen_values = true)]
    pub(crate) target: Option<String>,
    /// text or json
    #[arg(long, value_enum, default_value = "text", hide_possible_values = true)]
    pub(crate) format: Format,
    /// Bits of precision (needs a build with the feature mp)
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = super::bits)]
    pub(crate) bits: Option<u32>,
    #[command(flatten)]
    pub(crate) units: UnitArgs,
}
