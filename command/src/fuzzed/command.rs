//! A command line and a file of points or of a record: the command's answer, except for computations that take long.

use super::is_one_line;
use crate::args::{self, Command, NoCommand, OutputArgs, Question};
use crate::failure::{Failure, Outcome};
use crate::{closed, decay, described, design, grid, under_record};
use std::path::PathBuf;
use std::sync::LazyLock;
use stickslip_front::inputs::Input;

/// The file of a run.
static POINTS: LazyLock<PathBuf> = LazyLock::new(|| super::file("command"));

/// Replaces the named file of points by one with the points of the input.
fn redirect(output: &mut OutputArgs, content: &[u8]) {
    if output.points.is_some() {
        std::fs::write(&*POINTS, content).expect("a temporary file");
        output.points = Some(POINTS.clone());
    }
}

/// Runs a parsed command into `out`; `None` for commands that could take long.
fn run(command: &mut Command, content: &[u8], out: &mut Vec<u8>) -> Option<Outcome> {
    Some(match command {
        Command::Response(args) => {
            redirect(&mut args.output, content);
            closed::response(args, out)
        }
        Command::Border(args) => {
            redirect(&mut args.output, content);
            closed::border(args, out)
        }
        Command::Record(args) => {
            std::fs::write(&*POINTS, content).expect("a temporary file");
            args.file = POINTS.clone();
            (args.out, args.picture, args.interval) = (None, None, None);
            // Ranges of oscillators take long.
            args.floor_spectrum = args.floor_spectrum.take().filter(|text| !text.contains(':'));
            if args.describe { described::run(args, out) } else { under_record::run(args, out) }
        }
        Command::Decay(args) => {
            args.out = None;
            decay::run(args, out)
        }
        // Bands, whose number is not bounded, and searches take long.
        Command::Design(Question::Bands(_) | Question::Dissipation(_) | Question::Stiffness(_)) => {
            return None;
        }
        // A friction over a band, too, whose pictures would be files.
        Command::Design(Question::Friction(args)) if args.over.is_some() => return None,
        Command::Design(question) => design::run(question, out),
        Command::Sweep(args) => {
            let omega = args.machine.text(Input::Omega).unwrap_or("0.5");
            return check_grid(grid::Grid::<f64>::parse("--omega", omega));
        }
        Command::Map(args) => {
            let alpha = args.machine.text(Input::Alpha).unwrap_or("2");
            return check_grid(grid::Grid::<f64>::parse("--alpha", alpha));
        }
        Command::Steady(_)
        | Command::Attractors(_)
        | Command::Basins(_)
        | Command::Simulate(_)
        | Command::Identify(_)
        | Command::Outputs
        | Command::Options
        | Command::ResponseCurve(_)
        | Command::MotionPlot(_)
        | Command::Spectrum(_)
        | Command::Verify(_)
        | Command::Figure(_)
        | Command::Figures(_)
        | Command::Completions(_)
        | Command::System(_)
        | Command::Pull(_)
        | Command::Man(_) => return None,
    })
}

/// A grid contains its own ends, and nothing outside them.
fn check_grid(grid: Result<grid::Grid<f64>, Failure>) -> Option<Outcome> {
    let grid = match grid {
        Ok(grid) => grid,
        Err(failure) => return Some(Err(failure)),
    };
    let (low, high) = grid.ends();
    assert!(grid.len() >= 1 && low.is_finite() && high.is_finite());
    for place in [0, 1, grid.len() / 2, grid.len() - 1] {
        let value = grid.value(place.min(grid.len() - 1));
        let slack = 1e-9 * (low.abs() + high.abs());
        assert!(value >= low - slack && value <= high + slack, "{value:e} of {low:e}:{high:e}");
    }
    None
}

/// The answer to a command line, which ends at the first NUL; the rest of the input is the file of points.
///
/// # Panics
/// If an answer or a refusal is not as promised, which is a finding.
pub fn command(input: &[u8]) {
    let (line, content) = match input.iter().position(|byte| *byte == 0) {
        Some(end) => (&input[..end], &input[end + 1..]),
        None => (input, &[][..]),
    };
    let Ok(line) = std::str::from_utf8(line) else { return };
    let words = std::iter::once("stickslip").chain(line.split_whitespace());
    let mut parsed = match args::parse(words) {
        Ok(parsed) => parsed,
        Err(NoCommand::Answered(_)) => return,
        Err(NoCommand::Failed(failure)) => return is_one_line(&failure),
    };
    let mut out = Vec::new();
    match run(&mut parsed.command, content, &mut out) {
        None => {}
        Some(Ok(())) => {
            let text = std::str::from_utf8(&out).expect("text");
            assert!(!text.contains("NaN") || line.contains("--format"), "{text}");
            if line.contains("--format json ") {
                serde_json::from_str::<serde_json::Value>(text).expect("JSON");
            }
        }
        Some(Err(failure)) => {
            is_one_line(&failure);
            assert!(!matches!(failure, Failure::System(_)), "{}", failure.message());
            // The rows before a bad one are complete.
            assert!(out.is_empty() || out.ends_with(b"\n"));
        }
    }
}
