//! The arguments of response curves and plots of a motion.

use super::{LookArgs, MachineArgs, StartArgs, UnitArgs};
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// What a response curve shows over the frequency.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum CurveQuantity {
    /// Maximum displacement
    Displacement,
    /// Maximum velocity
    Velocity,
    /// Maximum acceleration
    Acceleration,
    /// Maximum force of spring and friction on their support
    Force,
    /// That force over p₀, or with a base that carries the surface the ratio of absolute accelerations
    Transmissibility,
    /// Maximum absolute displacement, with a base that carries the surface
    Absolute,
}

#[derive(Debug, Args)]
#[command(after_help = "\
The frequency is a grid FROM:TO:COUNT, or FROM:TO:COUNT:log. Any other quantity may be a list A,B,C of at most five
values, with one curve for each. Where the body stops, the values are those of the exact motion from rest, and the
line is dashed.

Every peak is resolved, whatever the COUNT: rows are added at it and beside it, until a line through the rows is right
to half a pixel of a picture. The column `point` tells grid, natural (Ω = 1), peak and flank apart. Without a damper the
motion is unbounded at Ω = 1 from α = 4/π on: the value is empty, the regime `unbounded`, and a picture has an arrowhead.

Examples:
  stickslip response-curve --mass 800kg --period 2.2s --friction-coefficient 0.05,0.08 --base-acceleration 0.15g \\
    --frequency 0.3Hz:5Hz:200 --units N,mm --out stroke.svg
  stickslip response-curve transmissibility --mass 800kg --period 2.2s --friction-coefficient 0.05 \\
    --base-acceleration 0.15g --frequency 0.3Hz:5Hz:200:log --out transmissibility.csv
  stickslip response-curve --omega 0.2:2:300 --alpha 1.2,2,4 --out amplification.svg")]
pub(crate) struct CurveArgs {
    /// displacement, velocity, acceleration, force, transmissibility or absolute
    #[arg(value_enum, value_name = "WHAT", default_value = "displacement", hide_possible_values = true)]
    pub(crate) what: CurveQuantity,
    #[command(flatten)]
    pub(crate) machine: MachineArgs,
    #[command(flatten)]
    pub(crate) units: UnitArgs,
    /// Output file: a picture in FILE.svg or FILE.png, rows in FILE.csv [default: rows to standard output]
    #[arg(long, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,
    /// Replace FILE if it exists
    #[arg(long)]
    pub(crate) overwrite: bool,
    #[command(flatten)]
    pub(crate) look: LookArgs,
    /// The horizontal range of the picture, in the unit of the axis [default: that of the grid]
    #[arg(long, value_name = "LOW:HIGH", allow_hyphen_values = true)]
    pub(crate) x_range: Option<String>,
    /// The vertical range of the picture, in the unit of the answer [default: all values]
    #[arg(long, value_name = "LOW:HIGH", allow_hyphen_values = true)]
    pub(crate) y_range: Option<String>,
    /// A linear vertical axis in place of a logarithmic one
    #[arg(long)]
    pub(crate) linear: bool,
}

#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  stickslip motion-plot --omega 0.15 --alpha 3 --out motion.svg
  stickslip motion-plot --mass 50t --stiffness 1kN/mm --friction 5kN --frequency 0.3Hz --force 12kN --out motion.svg")]
pub(crate) struct MotionPlotArgs {
    #[command(flatten)]
    pub(crate) machine: MachineArgs,
    #[command(flatten)]
    pub(crate) start: StartArgs,
    #[command(flatten)]
    pub(crate) units: UnitArgs,
    #[command(flatten)]
    pub(crate) look: LookArgs,
    /// Output file: a picture in FILE.svg or FILE.png, its data in FILE.csv [default: SVG to standard output]
    #[arg(long, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,
    /// Replace FILE if it exists
    #[arg(long)]
    pub(crate) overwrite: bool,
}
