//! The arguments of figures, maps, response curves and plots of a motion.

use super::{MachineArgs, StartArgs, UnitArgs};
use clap::builder::PossibleValuesParser;
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// The look of a picture.
#[derive(Debug, Args)]
pub(crate) struct LookArgs {
    /// The title of the picture
    #[arg(long, value_name = "TEXT")]
    pub(crate) title: Option<String>,
    /// The size of the picture in pixels, such as 900x500. A PNG has twice this width and height, and at most 40 million pixels, which are in memory
    #[arg(long, value_name = "WIDTHxHEIGHT")]
    pub(crate) size: Option<String>,
}

#[derive(Debug, Args)]
#[command(after_help = "\
Figures: 1, 2, 3, 4, 5, 6, 7, 8, 9a, 9b, 10a, 10b of the paper, and stops, portrait, accuracy, multipliers, poles, damping, impacts.
SVG leaves the text to the viewer's own font. PNG and PDF need a build with the feature png.

Examples:
  stickslip figure 8 --out border.svg
  stickslip figure stops > stops.svg
  stickslip figure 4 --out displacement.csv")]
pub(crate) struct FigureArgs {
    /// Name of the figure
    #[arg(
        value_name = "FIGURE",
        value_parser = PossibleValuesParser::new(stickslip_figures::NAMES),
        hide_possible_values = true
    )]
    pub(crate) name: String,
    /// Output file: a drawing in FILE.svg, FILE.png or FILE.pdf, its data in FILE.csv [default: SVG to standard output]
    #[arg(long, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,
    /// Replace FILE if it exists
    #[arg(long, requires = "out")]
    pub(crate) overwrite: bool,
}

#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  stickslip figures
  stickslip figures --all --dir figures
  stickslip figures --all --dir figures --overwrite
  stickslip figures --all --dir /tmp/data --format csv")]
pub(crate) struct FiguresArgs {
    /// Draw all figures (otherwise list their names)
    #[arg(long)]
    pub(crate) all: bool,
    /// Output folder
    #[arg(long, value_name = "DIR", default_value = "docs/figures")]
    pub(crate) dir: PathBuf,
    /// svg, png, pdf or csv
    #[arg(long, value_enum, default_value = "svg", hide_possible_values = true)]
    pub(crate) format: Picture,
    /// Replace existing files
    #[arg(long)]
    pub(crate) overwrite: bool,
}

/// What the file of a figure holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Picture {
    Svg,
    Png,
    Pdf,
    Csv,
}

impl Picture {
    /// The end of the file's name.
    pub(crate) const fn extension(self) -> &'static str {
        match self {
            Self::Svg => "svg",
            Self::Png => "png",
            Self::Pdf => "pdf",
            Self::Csv => "csv",
        }
    }
}

#[derive(Debug, Args)]
#[command(after_help = "\
Quantities: regime, margin (α/α_min), stops (per cycle, from rest), limits (their number, from 16 starts), an output
of `response`, such as loop_size_stiffness, or steady:NAME for one of `steady`, from rest, such as
steady:max_displacement. For a machine, a quantity with a unit is in the machine's units.

Two quantities are grids, FROM:TO:COUNT, FROM:TO:COUNT:log or A,B,C: Ω and α unless others are given [default:
--omega 0.0525:1.9975:390 --alpha 0.025:7.975:160]. The horizontal axis is Ω or the frequency. A picture has columns
added at Ω = 1 down to a pixel, and a line where the motion is unbounded. The rows of CSV are those of the grids.

Examples:
  stickslip map --out regime.svg
  stickslip map margin --omega 0.205:1.995:180 --alpha 0.5:8:76 --out margin.svg
  stickslip map steady:max_displacement --mass 800kg --period 2.2s --friction-coefficient 0.05 --units N,mm \\
    --frequency 0.6Hz:5Hz:200 --base-acceleration 0.02g:0.4g:100 --out stroke.svg
  stickslip map steady:stick_fraction --omega 0.05:1.5:300 --alpha 1.05:8:140 --out sticking.svg
  stickslip map limits --omega 0.1:1.2:56 --alpha 3.1:9.1:31 --damping-ratio 0.02 --static-friction-ratio 2 --out limits.svg")]
pub(crate) struct MapArgs {
    /// Quantity to map
    #[arg(value_name = "QUANTITY", default_value = "regime")]
    pub(crate) quantity: String,
    #[command(flatten)]
    pub(crate) machine: MachineArgs,
    #[command(flatten)]
    pub(crate) units: UnitArgs,
    /// Output file: a picture in FILE.svg, FILE.png or FILE.pdf, rows in FILE.csv [default: rows to standard output]
    #[arg(long, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,
    /// Replace FILE if it exists
    #[arg(long, requires = "out")]
    pub(crate) overwrite: bool,
    #[command(flatten)]
    pub(crate) look: LookArgs,
    /// The values of the lightest and the darkest shade, in the unit of the answer [default: all values]
    #[arg(long, value_name = "LOW:HIGH", allow_hyphen_values = true)]
    pub(crate) range: Option<String>,
}

/// What a response curve shows over the frequency.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum CurveQuantity {
    /// Peak displacement
    Displacement,
    /// Peak velocity
    Velocity,
    /// Peak acceleration
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

Every peak wider than a five-hundredth of the axis is resolved, whatever the COUNT, and so is the onset of sliding: rows
are added there and beside, until a line through the rows is right to half a pixel of a picture. The column `point` tells
grid, natural (Ω = 1), peak, onset and flank apart. Without a damper the motion is unbounded at Ω = 1 from α = 4/π on:
the value is empty, the regime `unbounded`, and a picture has an arrowhead.

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
    /// Output file: a picture in FILE.svg, FILE.png or FILE.pdf, rows in FILE.csv [default: rows to standard output]
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
    /// The vertical range of the picture, in the unit of the answer [default: all values, but for the tops of poles and deep dips]
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
    /// Output file: a picture in FILE.svg, FILE.png or FILE.pdf, its data in FILE.csv [default: SVG to standard output]
    #[arg(long, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,
    /// Replace FILE if it exists
    #[arg(long)]
    pub(crate) overwrite: bool,
}
