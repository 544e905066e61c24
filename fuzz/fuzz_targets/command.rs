//! A command line and a file of points or of a record: the command's answer, except for computations that take long.
//!
//! The command's own modules are compiled in; any further module that they use must be listed here.
#![no_main]

#[allow(dead_code, unused_imports, reason = "the subcommands that are left out need them")]
#[path = "../../command/src"]
mod command {
    pub(crate) mod args;
    pub(crate) mod attractors;
    pub(crate) mod bits;
    pub(crate) mod closed;
    pub(crate) mod columns;
    pub(crate) mod curve;
    pub(crate) mod decay;
    pub(crate) mod design;
    pub(crate) mod enclose;
    pub(crate) mod failure;
    pub(crate) mod figure;
    pub(crate) mod floor;
    pub(crate) mod follow;
    pub(crate) mod grid;
    pub(crate) mod input;
    pub(crate) mod interrupt;
    pub(crate) mod map;
    pub(crate) mod measured;
    pub(crate) mod motion_plot;
    pub(crate) mod note;
    pub(crate) mod output;
    pub(crate) mod outputs;
    pub(crate) mod physical;
    pub(crate) mod points;
    pub(crate) mod progress;
    pub(crate) mod record;
    pub(crate) mod resume;
    pub(crate) mod rows;
    pub(crate) mod sink;
    pub(crate) mod starts;
    pub(crate) mod steady;
    pub(crate) mod style;
    pub(crate) mod sweep;
}

use command::args::{Command, NoCommand, OutputArgs, Question};
use command::{
    args, attractors, bits, closed, columns, curve, decay, design, enclose, failure, figure, floor, follow,
    grid, input, interrupt, map, measured, motion_plot, note, output, outputs, physical, points, progress,
    record, resume, rows, sink, starts, steady, style, sweep,
};
use failure::Failure;
use std::path::PathBuf;
use std::sync::LazyLock;
use stickslip::inputs::Input;

/// The file of a run.
static POINTS: LazyLock<PathBuf> =
    LazyLock::new(|| std::env::temp_dir().join(format!("stickslip-fuzz-{}.csv", std::process::id())));

/// Replaces the named file of points by one with the points of the input.
fn redirect(output: &mut OutputArgs, content: &[u8]) {
    if output.points.is_some() {
        std::fs::write(&*POINTS, content).expect("a temporary file");
        output.points = Some(POINTS.clone());
    }
}

/// Runs a parsed command into `out`; `None` for commands that could take long.
fn run(command: &mut Command, content: &[u8], out: &mut Vec<u8>) -> Option<failure::Outcome> {
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
            follow::run(args, out)
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
fn check_grid(grid: Result<grid::Grid<f64>, Failure>) -> Option<failure::Outcome> {
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

/// A failure is a single nonempty line that a terminal can show.
fn is_one_line(failure: &Failure) {
    let text = failure.message();
    assert!(
        !text.trim().is_empty() && !text.chars().any(char::is_control) && text.len() < 10_000,
        "{text:?}"
    );
    assert!(!matches!(failure, Failure::System(_)), "{text}");
}

libfuzzer_sys::fuzz_target!(|input: &[u8]| {
    // The command line ends at the first NUL, with its words separated by white space; the rest is the file
    // of points.
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
            // The rows before a bad one are complete.
            assert!(out.is_empty() || out.ends_with(b"\n"));
        }
    }
});
