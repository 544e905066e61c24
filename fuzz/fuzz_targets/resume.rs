//! A sweep that is resumed from any file: either it is completed as if it had not been interrupted, or the
//! file is left as it is.
//!
//! The command's own modules are compiled in; any further module that they use must be listed here.
#![no_main]

#[allow(dead_code, unused_imports, unexpected_cfgs, reason = "the subcommands that are left out need them")]
#[path = "../../command/src"]
mod command {
    pub(crate) mod args;
    pub(crate) mod bits;
    pub(crate) mod closed;
    pub(crate) mod columns;
    pub(crate) mod enclose;
    pub(crate) mod failure;
    pub(crate) mod grid;
    pub(crate) mod input;
    pub(crate) mod interrupt;
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
    pub(crate) mod steady;
    pub(crate) mod style;
    pub(crate) mod sweep;
}

use command::args::{Command, NoCommand};
use command::{
    args, bits, closed, columns, enclose, failure, grid, input, interrupt, note, output, outputs, physical,
    points, progress, record, resume, rows, sink, steady, style, sweep,
};
use std::path::PathBuf;
use std::sync::LazyLock;

/// The file of a run.
static FILE: LazyLock<PathBuf> =
    LazyLock::new(|| std::env::temp_dir().join(format!("stickslip-resume-{}", std::process::id())));

/// Sweeps with and without their grid among the columns, as CSV and as JSON lines, with all outputs or some.
const SWEEPS: [&str; 5] = [
    "border --omega 0.5:2:4",
    "response --omega 0.4:1.5:3 --alpha 2,6 --outputs alpha,max_displacement,omega",
    "response --omega 0.4:1.5:3 --alpha 2,6 --outputs regime,max_velocity --format jsonl",
    "steady --omega 0.4,1.5 --alpha 2,6 --outputs multipliers,omega,alpha",
    "border --omega 0.5:2:7 --outputs omega,min_force_ratio --no-header --shard 2/3",
];

/// Each sweep without interruption.
static WHOLE: LazyLock<[Vec<u8>; 5]> = LazyLock::new(|| {
    SWEEPS.map(|sweep| {
        let mut out = Vec::new();
        assert!(run(sweep, &mut out).is_ok());
        out
    })
});

fn run(sweep: &str, out: &mut Vec<u8>) -> failure::Outcome {
    let words = std::iter::once("stickslip").chain(std::iter::once("sweep")).chain(sweep.split(' '));
    match args::parse(words) {
        Ok(args::CommandLine { command: Command::Sweep(args), .. }) => sweep::run(&args, out),
        Ok(_) | Err(NoCommand::Answered(_)) => unreachable!("a sweep"),
        Err(NoCommand::Failed(failure)) => Err(failure),
    }
}

libfuzzer_sys::fuzz_target!(|input: &[u8]| {
    let [which, cut, changes @ ..] = input else { return };
    let which = usize::from(*which) % SWEEPS.len();
    let whole = &WHOLE[which];
    // The beginning of the sweep's own file, then changed bytes, then bytes of the input.
    let mut kept = whole[..usize::from(*cut) * whole.len() / 255].to_vec();
    if let [changed, place, rest @ ..] = changes {
        let length = kept.len().max(1);
        if let Some(byte) = kept.get_mut(usize::from(*place) * length / 256) {
            *byte ^= changed;
        }
        kept.extend_from_slice(rest);
    }
    std::fs::write(&*FILE, &kept).expect("a temporary file");
    let line = format!("{} --resume --out {}", SWEEPS[which], FILE.display());
    let outcome = run(&line, &mut Vec::new());
    let now = std::fs::read(&*FILE).expect("the file");
    match outcome {
        Ok(()) => assert!(now == *whole, "{line}: {}", String::from_utf8_lossy(&kept)),
        Err(failure) => {
            assert!(matches!(failure, failure::Failure::Input(_)), "{}", failure.message());
            assert!(now == kept, "{line}: changed though refused");
        }
    }
});
