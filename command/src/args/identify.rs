//! The arguments of identification.

use super::{Format, MachineArgs, UnitArgs};
use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use std::path::PathBuf;
use stickslip::design::{AmplitudeKind, PhaseKind};

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
left out and named.

With --decay the file is a free vibration that comes to rest: its peaks, in the column peak[mm], or the sampled
displacement, in the columns time[s] and displacement[mm]. The answer is a displacement r_y/k, and a force with the
stiffness, or with the mass where the frequency is known.

Examples:
  stickslip identify --decay peaks.csv --stiffness 12kN/m
  stickslip identify curve.csv --mass 800kg --period 2.2s --base-acceleration 0.15g
  stickslip identify curve.csv --mass 800kg --period 2.2s --force 1.2kN --amplitude rms --phase transfer-function
  stickslip identify curve.csv --mass 50t --stiffness 1kN/mm --force 12kN --units kN,mm --format json")]
pub(crate) struct IdentifyArgs {
    /// CSV of a measured response curve, or of a free decay, - for standard input
    #[arg(value_name = "FILE")]
    pub(crate) file: PathBuf,
    #[command(flatten)]
    pub(crate) machine: MachineArgs,
    /// The kind of the amplitudes: peak (half of peak to peak), rms, or peak-to-peak
    #[arg(long, value_parser = named(AMPLITUDES, AmplitudeKind::name), value_name = "KIND", default_value = "peak", hide_possible_values = true)]
    pub(crate) amplitude: AmplitudeKind,
    /// The kind of the phases, the force being p₀ sin ω_d t: peak (ω_d t of the maximum displacement), lag
    /// (of the displacement behind the force), or transfer-function (the lag, negative) [default: the one that
    /// fits best]
    #[arg(long, value_parser = named(PHASES, PhaseKind::name), value_name = "KIND", hide_possible_values = true)]
    pub(crate) phase: Option<PhaseKind>,
    /// The file is a free decay: columns time and displacement, or peak and optionally time. No machine is needed
    #[arg(long)]
    pub(crate) decay: bool,
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
