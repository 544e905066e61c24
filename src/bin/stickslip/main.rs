//! The command over the library: `stickslip response`, `border`, `steady`, `simulate`, `design`, `decay`, `verify`,
//! `figure`, `figures`, `sweep`, `map`.

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
mod bits;
mod border;
mod decay;
mod design;
mod failure;
mod figure;
mod grid;
mod input;
mod interrupt;
mod map;
mod note;
mod points;
mod progress;
mod record;
mod response;
mod simulate;
mod sink;
mod steady;
mod sweep;
mod verify;

use args::{Command, CommandLine};
use clap::Parser;
use failure::{Failure, Outcome};
use std::io::{self, BufWriter, Write};
use std::process::ExitCode;

fn main() -> ExitCode {
    match CommandLine::try_parse() {
        Ok(line) => match run(&line.command) {
            Ok(()) | Err(Failure::ClosedPipe) => ExitCode::SUCCESS,
            Err(failure) => report(&failure),
        },
        Err(error) if error.use_stderr() => report(&Failure::from(error)),
        // Help and version, which a closed pipe may cut short.
        Err(error) => {
            let _ = error.print();
            ExitCode::SUCCESS
        }
    }
}

fn run(command: &Command) -> Outcome {
    let mut out = BufWriter::new(io::stdout().lock());
    match command {
        Command::Response(args) => response::run(args, &mut out)?,
        Command::Border(args) => border::run(args, &mut out)?,
        Command::Steady(args) => steady::run(args, &mut out)?,
        Command::Simulate(args) => simulate::run(args, &mut out)?,
        Command::Design(question) => design::run(question, &mut out)?,
        Command::Decay(args) => decay::run(args, &mut out)?,
        Command::Verify(args) => verify::run(args, &mut out)?,
        Command::Figure(args) => figure::run(args, &mut out)?,
        Command::Figures(args) => figure::run_all(args, &mut out)?,
        Command::Sweep(args) => sweep::run(args, &mut out)?,
        Command::Map(args) => map::run(args, &mut out)?,
    }
    Ok(out.flush()?)
}

fn report(failure: &Failure) -> ExitCode {
    let _ = writeln!(io::stderr(), "stickslip: {failure}");
    failure.exit_code()
}
