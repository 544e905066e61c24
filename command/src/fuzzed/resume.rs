//! A sweep that is resumed from any file: either it is completed as if it had not been interrupted, or the
//! file is left as it is.

use crate::args::{self, Command, NoCommand};
use crate::failure::{Failure, Outcome};
use crate::sweep;
use std::path::PathBuf;
use std::sync::LazyLock;

/// The file of a run.
static FILE: LazyLock<PathBuf> = LazyLock::new(|| super::file("resume"));

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

fn run(sweep: &str, out: &mut Vec<u8>) -> Outcome {
    let words = std::iter::once("stickslip").chain(std::iter::once("sweep")).chain(sweep.split(' '));
    match args::parse(words) {
        Ok(args::CommandLine { command: Command::Sweep(args), .. }) => sweep::run(&args, out),
        Ok(_) | Err(NoCommand::Answered(_)) => unreachable!("a sweep"),
        Err(NoCommand::Failed(failure)) => Err(failure),
    }
}

/// Resumes a sweep from a file that was cut short, changed or replaced.
///
/// # Panics
/// If the file is neither completed nor left as it was, which is a finding.
pub fn resume(input: &[u8]) {
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
            assert!(matches!(failure, Failure::Input(_)), "{}", failure.message());
            assert!(now == kept, "{line}: changed though refused");
        }
    }
}
