//! The command over the library: `args::Command` has its subcommands, and each has a file of its own. The program only
//! calls [`main`].

#![cfg_attr(
    not(test),
    deny(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::indexing_slicing,
        clippy::unreachable,
        clippy::wildcard_enum_match_arm
    )
)]

mod args;
mod attractors;
mod basins;
mod bits;
mod closed;
mod columns;
mod curve;
mod decay;
mod described;
mod design;
#[cfg(test)]
#[path = "../../tests/drawn/mod.rs"]
mod drawn;
mod drifting;
mod enclose;
mod failure;
mod figure;
mod floor;
#[cfg(feature = "fuzz")]
pub mod fuzzed;
mod grid;
mod identify;
mod input;
mod interrupt;
mod map;
mod measured;
mod motion_plot;
mod note;
mod options;
mod output;
mod outputs;
#[cfg(feature = "parquet")]
mod parquet_file;
mod physical;
mod points;
mod progress;
mod pull;
mod resume;
mod row;
mod rows;
mod shaken;
mod shell;
mod simulate;
mod sink;
mod spectrum;
mod starts;
mod steady;
mod style;
mod sweep;
mod system;
mod threads;
mod under_record;
mod verify;

use args::Command;
use failure::{Failure, Outcome};
use output::Lines;
use std::io::{self, Write};
use std::panic::resume_unwind;
use std::process::ExitCode;
use std::thread;

/// Runs the command line of this process.
#[must_use]
pub fn main() -> ExitCode {
    if cfg!(feature = "mp") { on_large_stacks(run) } else { run() }
}

/// Numbers of thousands of bits are on the stack: without optimisation, a response of 8192 bits takes 13 MB of it.
fn on_large_stacks(run: fn() -> ExitCode) -> ExitCode {
    // Where the system refuses such a thread, the ordinary one suffices for fewer bits.
    let main = thread::Builder::new().name("main".to_owned()).stack_size(threads::STACK);
    match threads::with_room(|| main.spawn(run)) {
        Ok(running) => running.join().unwrap_or_else(|panic| resume_unwind(panic)),
        Err(_) => run(),
    }
}

fn run() -> ExitCode {
    match args::parse(std::env::args_os()) {
        Ok(line) => {
            if line.quiet {
                progress::silence();
            }
            interrupt::listen();
            interrupt::clean_after_panic();
            progress::of_time();
            ended(run_command(&line.command))
        }
        // Help and version; a closed pipe may cut them short.
        Err(args::NoCommand::Answered(help)) => {
            ended(help.print().and_then(|()| io::stdout().flush()).map_err(Failure::from))
        }
        Err(args::NoCommand::Failed(failure)) => report(&failure),
    }
}

fn ended(outcome: Outcome) -> ExitCode {
    progress::end();
    match outcome {
        Ok(()) | Err(Failure::ClosedPipe) => {
            progress::write_notes();
            ExitCode::SUCCESS
        }
        Err(failure) => report(&failure),
    }
}

fn run_command(command: &Command) -> Outcome {
    let mut out = Lines::new(io::stdout().lock(), "standard output");
    match command {
        Command::Response(args) => closed::response(args, &mut out)?,
        Command::Border(args) => closed::border(args, &mut out)?,
        Command::Steady(args) => match drifting::asked(args)? {
            Some(given) => drifting::run(args, &given, &mut out)?,
            None => steady::run(args, &mut out)?,
        },
        Command::Attractors(args) => attractors::run(args, &mut out)?,
        Command::Basins(args) => basins::run(args, &mut out)?,
        Command::Simulate(args) => simulate::run(args, &mut out)?,
        Command::System(args) => system::run(args, &mut out)?,
        Command::Design(question) => design::run(question, &mut out)?,
        Command::Identify(args) => identify::run(args, &mut out)?,
        Command::Decay(args) => decay::run(args, &mut out)?,
        Command::Pull(args) => pull::run(args, &mut out)?,
        Command::Record(args) if args.describe => described::run(args, &mut out)?,
        Command::Record(args) => under_record::run(args, &mut out)?,
        Command::Spectrum(args) => spectrum::run(args, &mut out)?,
        Command::Verify(args) => verify::run(args, &mut out)?,
        Command::Figure(args) => figure::run(args, &mut out)?,
        Command::Figures(args) => figure::run_all(args, &mut out)?,
        Command::Sweep(args) => sweep::run(args, &mut out)?,
        Command::Map(args) => map::run(args, &mut out)?,
        Command::ResponseCurve(args) => curve::run(args, &mut out)?,
        Command::MotionPlot(args) => motion_plot::run(args, &mut out)?,
        Command::Outputs => outputs::run(&mut out)?,
        Command::Options => options::run(&mut out)?,
        Command::Completions(args) => shell::completions(args, &mut out)?,
        Command::Man(args) => shell::man(args, &mut out)?,
    }
    Ok(out.flush()?)
}

fn report(failure: &Failure) -> ExitCode {
    let message = args::as_typed(failure.message(), std::env::args_os());
    let _ = writeln!(anstream::stderr(), "{} {message}", style::label());
    failure.exit_code()
}
