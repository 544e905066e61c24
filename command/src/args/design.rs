//! The arguments of the inverse problems, and of identification.

use super::{AnswerArgs, Format, MachineArgs, UnitArgs};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, Subcommand, ValueEnum};
use std::path::PathBuf;
use stickslip::design::{AmplitudeKind, PhaseKind};

/// What is asked, in ratios or in physical units.
#[derive(Debug, Subcommand)]
#[command(after_help = "\
Examples:
  stickslip design force --mass 50 --stiffness 1000 --friction 5 --frequency 6
  stickslip design friction --mass 50 --stiffness 1000 --frequency 6 --force 12
  stickslip design friction --mass 800kg --period 2.2s --base-displacement 50mm --over 0.2Hz:2Hz --of absolute-displacement
  stickslip design friction --mass 50kg --stiffness 1kN/m --frequency 6rad/s --force 12N --target-amplitude 5mm
  stickslip design bands --alpha 12 --from 0.1 --to 2
  stickslip design bands --alpha 80 --from 0.3 --to 0.4 --no-stop
  stickslip design hold --mass 20kg --stiffness 20kN/m --friction 80N --base-displacement 10mm
  stickslip design displacement --omega 1.5 --target 2
  stickslip design dissipation --mass 50t --stiffness 1000kN/m --frequency 6rad/s --force 12kN --units kN,m
  stickslip design stiffness --mass 50 --friction 5 --frequency 6 --force 12 --from 500 --to 1500")]
pub(crate) enum Question {
    /// The minimum force, or base motion, that keeps the body from sticking
    Force(QuestionArgs),
    /// The maximum friction with which a force keeps the body from sticking. With --over, the friction that minimises
    /// the peak amplitude over a frequency band. With --target-amplitude, every friction that gives this amplitude
    Friction(QuestionArgs),
    /// The frequencies, between --from and --to, at which the body never sticks
    Bands(QuestionArgs),
    /// The frequency up to which friction holds a body at rest, or without a friction the least one that holds it
    Hold(QuestionArgs),
    /// The force for the peak displacement --target
    Displacement(QuestionArgs),
    /// The force for the peak velocity --target
    Velocity(QuestionArgs),
    /// The friction that dissipates most, without sticking or, with --sticking, among all motions
    Dissipation(QuestionArgs),
    /// The stiffness, between --from and --to, that dissipates most without sticking
    Stiffness(QuestionArgs),
}

/// The amplitude that a friction makes small over a band.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum DesignAim {
    /// The displacement x
    Displacement,
    /// The displacement in space, with a base that carries the surface
    AbsoluteDisplacement,
    /// The force on the support
    TransmittedForce,
    /// The acceleration in space
    Acceleration,
}

#[derive(Debug, Args)]
pub(crate) struct QuestionArgs {
    #[command(flatten)]
    pub(crate) machine: MachineArgs,
    /// Lower end of the range: of Ω or, in physical units, of the frequency or the stiffness
    #[arg(long, value_name = "LOW", allow_hyphen_values = true)]
    pub(crate) from: Option<String>,
    /// Upper end of the range
    #[arg(long, value_name = "HIGH", allow_hyphen_values = true)]
    pub(crate) to: Option<String>,
    /// For dissipation: allow sticking, with a proven tolerance of 1e-6
    #[arg(long)]
    pub(crate) sticking: bool,
    /// For force and bands: include every motion without a stop, also those of six reversals a cycle near
    /// Ω = 1/3, 1/5, …
    #[arg(long)]
    pub(crate) no_stop: bool,
    /// For friction: the band of frequencies, such as 0.5Hz:2Hz, over which the peak amplitude is to be minimised
    #[arg(long, value_name = "LOW:HIGH", requires = "of", allow_hyphen_values = true)]
    pub(crate) over: Option<String>,
    /// The amplitude to minimise: displacement, absolute-displacement, transmitted-force or acceleration (in
    /// space)
    #[arg(long, value_enum, value_name = "WHAT", requires = "over", hide_possible_values = true)]
    pub(crate) of: Option<DesignAim>,
    /// The response curves with half the best friction, the best and twice the best, FILE.svg, FILE.png or FILE.pdf
    #[arg(long, value_name = "FILE", requires = "over")]
    pub(crate) picture: Option<PathBuf>,
    /// Replace a picture that exists
    #[arg(long, requires = "picture")]
    pub(crate) overwrite: bool,
    /// For friction: the peak displacement to reach, unit of length
    #[arg(long, value_name = "X", allow_hyphen_values = true, conflicts_with = "over")]
    pub(crate) target_amplitude: Option<String>,
    /// Target value: in units of B or B ω_d, or of length or length per time
    #[arg(long, value_name = "X", allow_hyphen_values = true)]
    pub(crate) target: Option<String>,
    #[command(flatten)]
    pub(crate) answer: AnswerArgs,
}

/// One of the kinds by its name.
fn named<T: Copy + Send + Sync + 'static, const N: usize>(
    kinds: [T; N],
    name: fn(T) -> &'static str,
) -> impl TypedValueParser<Value = T> {
    let kind = move |text: String| kinds.into_iter().find(|kind| name(*kind) == text).ok_or("is unknown");
    PossibleValuesParser::new(kinds.map(name)).try_map(kind)
}

const AMPLITUDES: [AmplitudeKind; 3] =
    [AmplitudeKind::Peak, AmplitudeKind::RootMeanSquare, AmplitudeKind::PeakToPeak];
const PHASES: [PhaseKind; 3] = [PhaseKind::Peak, PhaseKind::Lag, PhaseKind::TransferFunction];

#[derive(Debug, Args)]
#[command(after_help = "\
Friction and damping, with their standard errors, from a measured response curve of known mass, stiffness and drive.
The file has the columns frequency and amplitude, and optionally phase. The header may have units:
frequency[Hz],amplitude[mm],phase[deg]. Motion with stops counts, too. Wrong values do not move the answer: they are
left out and named. Without a spring the natural frequency is fitted, too, and without a drive the amplitude of the force.

With --decay the file is a free vibration that comes to rest: its peaks, in the column peak[mm], or the sampled
displacement, in the columns time[s] and displacement[mm]. The answer is a displacement r_y/k, and a force with the
stiffness, or with the mass where the frequency is known.

Examples:
  stickslip identify --decay peaks.csv --stiffness 12kN/m
  stickslip identify curve.csv --mass 800kg --period 2.2s --base-acceleration 0.15g
  stickslip identify curve.csv --mass 800kg --period 2.2s --force 1.2kN --amplitude rms --phase transfer-function
  stickslip identify curve.csv --mass 50t --stiffness 1kN/mm --force 12kN --units kN,mm --format json
  stickslip identify curve.csv --mass 800kg --force 1.2kN
  stickslip identify --motion test.csv --mass 800kg --stiffness 12kN/m")]
pub(crate) struct IdentifyArgs {
    /// CSV of a measured response curve, of a free decay, or of a load and a motion, - for standard input
    #[arg(value_name = "FILE")]
    pub(crate) file: PathBuf,
    #[command(flatten)]
    pub(crate) machine: MachineArgs,
    /// The kind of the amplitudes: peak (half of peak to peak), rms, or peak-to-peak
    #[arg(long, value_parser = named(AMPLITUDES, AmplitudeKind::name), value_name = "KIND", default_value = "peak", hide_possible_values = true)]
    pub(crate) amplitude: AmplitudeKind,
    /// The kind of the phases, the force being p₀ sin ω_d t: peak (ω_d t of the peak displacement), lag
    /// (of the displacement behind the force), or transfer-function (the lag, negative) [default: the one that
    /// fits best]
    #[arg(long, value_parser = named(PHASES, PhaseKind::name), value_name = "KIND", hide_possible_values = true)]
    pub(crate) phase: Option<PhaseKind>,
    /// The file is a free decay: columns time and displacement, or peak and optionally time. No machine is needed
    #[arg(long)]
    pub(crate) decay: bool,
    /// The file is a measured load and the motion under it: columns time, displacement, and force, acceleration or
    /// foot-displacement. Needs the mass. Without a spring the stiffness is fitted, too
    #[arg(long, conflicts_with = "decay")]
    pub(crate) motion: bool,
    /// With --decay: the peaks are those of both sides without their signs. Otherwise peaks of one sign are one in every
    /// cycle, and peaks whose signs alternate one in every half cycle
    #[arg(long, requires = "decay")]
    pub(crate) half_cycles: bool,
    /// text or json
    #[arg(long, value_enum, default_value = "text", hide_possible_values = true)]
    pub(crate) format: Format,
    #[command(flatten)]
    pub(crate) units: UnitArgs,
}
