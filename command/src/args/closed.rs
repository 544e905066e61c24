//! The arguments of what the closed forms answer.

use super::{BodyArgs, Format, MachineArgs, OutputArgs};
use clap::Args;

#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  stickslip response --omega 1.5 --alpha 2.5
  stickslip response --omega 1.5 --alpha 2.5 --enclose --bits 128
  stickslip response --mass 50 --stiffness 877.3 --friction 5 --frequency 6.2832 --force 12.5 --units kN,m
  stickslip response --mass 50 --friction 5 --frequency 6.2832 --omega 1.5 --alpha 2.5 --format json
  stickslip response --points points.csv --format csv")]
pub(crate) struct ResponseArgs {
    #[command(flatten)]
    pub(crate) machine: MachineArgs,
    /// Guaranteed digits: each output with an error bound, rounding included, for --omega and --alpha exactly
    /// as typed (needs a build with the feature mp)
    #[arg(long)]
    pub(crate) enclose: bool,
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}

#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  stickslip border --omega 0.4
  stickslip border --omega 0.331 --no-stop
  stickslip border --mass 50 --stiffness 877.3 --friction 5 --frequency 6.2832 --format json
  stickslip border --points - --format csv < frequencies.csv")]
pub(crate) struct BorderArgs {
    #[command(flatten)]
    pub(crate) machine: BodyArgs,
    /// Guaranteed digits: each output with an error bound, rounding included, for --omega exactly as typed
    /// (needs a build with the feature mp)
    #[arg(long, conflicts_with = "no_stop")]
    pub(crate) enclose: bool,
    /// Also list all force ratios without any stop, including those of six reversals a cycle below the border
    /// near Ω = 1/3, 1/5, …
    #[arg(long)]
    pub(crate) no_stop: bool,
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}

#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  stickslip verify
  stickslip verify --bits 1024
  stickslip verify --enclose --bits 128
  stickslip verify --bits 256 --format json")]
pub(crate) struct VerifyArgs {
    /// Residuals in ball arithmetic, rounding included: a ball that contains 0 confirms an equation, any
    /// other refutes it (needs a build with the feature mp)
    #[arg(long)]
    pub(crate) enclose: bool,
    /// Bits of precision (needs a build with the feature mp) [default: 53 (f64), with --enclose 64]
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = super::bits)]
    pub(crate) bits: Option<u32>,
    /// text or json
    #[arg(long, value_enum, default_value = "text", hide_possible_values = true)]
    pub(crate) format: Format,
}
