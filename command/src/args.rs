//! The command line.

mod attractors;
mod checks;
mod closed;
mod design;
mod inputs;
mod motion;
mod pictures;
mod record;
mod shared;
mod shell;
mod sweep;
mod system;
pub(crate) mod used;

use crate::failure::Failure;
use crate::outputs;
use crate::style::STYLES;
pub(crate) use attractors::{AttractorsArgs, BasinsArgs, RowsArgs};
use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};
pub(crate) use closed::{BorderArgs, ResponseArgs, VerifyArgs};
pub(crate) use design::{DesignAim, IdentifyArgs, Question, QuestionArgs};
pub(crate) use inputs::{BodyArgs, MachineArgs, StartArgs, Typed, as_typed};
pub(crate) use motion::{DecayArgs, PullArgs, ShapeArg, SimulateArgs, SteadyArgs, StreamFormat};
pub(crate) use pictures::{
    CurveArgs, CurveQuantity, FigureArgs, FiguresArgs, LookArgs, MapArgs, MotionPlotArgs, Picture,
};
pub(crate) use record::{LoadArgs, RecordArgs, SpectrumArgs, SurfaceArgs};
pub(crate) use shared::{AnswerArgs, Format, Header, OutputArgs, UnitArgs};
pub(crate) use shell::{CompletionsArgs, ManArgs};
use std::ffi::OsString;
pub(crate) use sweep::{SweepArgs, SweepFormat, Swept, TableArgs};
pub(crate) use system::{SystemArgs, SystemQuestion};

const AFTER_HELP: &str = "\
Examples:
  stickslip response --omega 1.5 --alpha 2.5
  stickslip response --mass 800kg --period 2.2s --friction-coefficient 0.05 --frequency 2Hz --base-acceleration 0.15g
  stickslip design bands --alpha 12 --from 0.1 --to 2
  stickslip help sweep

Limits:
  The closed forms have one body, Coulomb friction and a harmonic drive. Measured loads are records (record,
  spectrum). Several bodies, several harmonics, friction that depends on speed or load, belts, elastic contacts,
  stops, and blows with a coefficient of restitution and friction under them, are systems (system).

Units:
  Without a machine every value is a ratio: lengths are in B = r_y/k, velocities in B ω_d, forces in r_y, energies
  in r_y B, phases ω_d t in rad. The values of a machine (--mass, --stiffness, --friction, --frequency) may have
  units: 800kg, 12kN/mm, 5kN, 2Hz, 0.15g. Answers are in SI units, or in those of --units, such as kN,mm. Bare
  numbers are in any one consistent system, that of --units if given, and a bare frequency is in rad/s.
  `stickslip outputs` defines every output.

Exit status:
  0    success, also if the pipe was closed, or standard output is closed (>&-) and the answer discarded
  1    an identity of verify fails, or a system error such as a full disk
  2    invalid input, described by one line on standard error
  130  interrupted by Ctrl-C, SIGTERM or SIGHUP, within 0.3 s. The output ends at a complete record. A second
       interrupt ends the command at once.

Files:
  An existing file is replaced only with --overwrite. Pictures and Parquet files are written completely or not at
  all. --resume continues a sweep that was interrupted, even by kill -9 or a full disk. Attractors and basins continue
  their --rows FILE in the same way.

On a terminal, work of more than a second shows its progress, and text is coloured unless NO_COLOR is set.";

/// A mass on a spring with dry friction under a harmonic force: m x″ + c x′ + k x + r_y sgn(x′) = p₀ sin ω_d t.
#[derive(Debug, Parser)]
#[command(name = "stickslip", version, arg_required_else_help = true, styles = STYLES, after_help = AFTER_HELP)]
pub(crate) struct CommandLine {
    /// Suppress progress and notes
    #[arg(short, long, global = true, display_order = 900)]
    pub(crate) quiet: bool,
    #[command(subcommand)]
    pub(crate) command: Command,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Whether the body sticks, how far and how fast it moves, and the minimum force that keeps it sliding.
    Response(ResponseArgs),
    /// The minimum force that keeps the body from sticking at a frequency.
    Border(BorderArgs),
    /// The exact steady motion, stops included.
    Steady(SteadyArgs),
    /// All limits that many starts lead to, with static friction above kinetic friction.
    Attractors(AttractorsArgs),
    /// The limit that each start in a plane of starts leads to, as CSV or a picture.
    Basins(BasinsArgs),
    /// The exact motion from a start, segment by segment or sampled.
    Simulate(SimulateArgs),
    /// Several bodies with contacts, elastic contacts and stops, from a file: the exact motion.
    System(Box<SystemArgs>),
    /// Inverse problems: the force, friction, frequencies or stiffness for a desired motion.
    #[command(subcommand)]
    Design(Question),
    /// Friction and damping from a measured response curve.
    Identify(IdentifyArgs),
    /// Free vibration from a start: how many half cycles, and where it comes to rest.
    Decay(DecayArgs),
    /// A body pulled at a constant speed, or on a belt: stick-slip, or smooth sliding.
    Pull(PullArgs),
    /// The motion under a record: an earthquake, or any measured load. No stop is missed.
    Record(Box<RecordArgs>),
    /// The answers under records over periods, frictions and damping ratios, as rows or a picture.
    Spectrum(Box<SpectrumArgs>),
    /// Check every equation of the paper against computed cycles, at any precision. The exit status is 1 if
    /// one fails.
    Verify(VerifyArgs),
    /// A figure of the paper, or a further one, from this library's results.
    Figure(FigureArgs),
    /// All figures at once.
    Figures(FiguresArgs),
    /// Answers over a grid of Ω and α, computed in parallel, written in order, resumable.
    Sweep(SweepArgs),
    /// The plane of Ω and α by regime, margin, stops or any output, as CSV or a picture.
    Map(MapArgs),
    /// A response curve: an amplitude over the frequency for one machine or several, as CSV or a picture.
    ResponseCurve(CurveArgs),
    /// A steady motion over time and its friction loop, as a picture or CSV.
    MotionPlot(MotionPlotArgs),
    /// Every output by name, with its unit and its meaning.
    Outputs,
    /// Every option by command, with its meaning and its default.
    Options,
    /// Print a shell completion script.
    Completions(CompletionsArgs),
    /// Write the manual page, or those of all commands.
    Man(ManArgs),
}

/// The reason why there is no command to run.
pub(crate) enum NoCommand {
    /// Help or the version was asked for.
    Answered(clap::Error),
    Failed(Failure),
}

/// The command of the given words, if all of its options apply.
pub(crate) fn parse(
    words: impl IntoIterator<Item = impl Into<OsString> + Clone>,
) -> Result<CommandLine, NoCommand> {
    let refuse = |error: clap::Error| {
        if error.use_stderr() { NoCommand::Failed(error.into()) } else { NoCommand::Answered(error) }
    };
    let words: Vec<OsString> = words.into_iter().map(Into::into).collect();
    checks::check_units(&words).map_err(NoCommand::Failed)?;
    let matches = grammar().try_get_matches_from(words).map_err(refuse)?;
    used::check(&matches).and_then(|()| checks::check_files(&matches)).map_err(NoCommand::Failed)?;
    CommandLine::from_arg_matches(&matches).map_err(refuse)
}

/// The complete grammar; the help of each command shows the options that it uses.
pub(crate) fn grammar() -> clap::Command {
    CommandLine::command()
        .mut_subcommands(|command| used::hide_unused(command, ""))
        .mut_subcommand("outputs", |command| command.after_help(outputs::text()))
}

/// The value of `--bits`.
fn bits(text: &str) -> Result<u32, String> {
    match text.trim().parse() {
        Ok(bits) if bits >= 1 => Ok(bits),
        _ => Err(format!("must be a whole number ≥ 1 and ≤ {}", u32::MAX)),
    }
}
