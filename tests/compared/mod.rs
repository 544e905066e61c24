//! Comparisons of an answer with a number of another origin. Each that ran leaves a row below the folder of the target, from which
//! `.ci/evidence` makes the tables of docs/development/evidence.md.

#![allow(dead_code, reason = "each test takes what it needs")]

use std::cell::OnceCell;
use std::fmt::Debug;
use std::fs::File;
use std::io::Write;
use std::path::Path;

/// Where a number comes from that our own reading did not make.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Origin {
    /// Small steps that share no formula with the library.
    SmallSteps,
    /// The body of dense samples, `tests/evidence/sampled.rs`.
    DenseSamples,
    /// Numbers that a program of its own left in tests/data.
    AnotherProgram,
    /// Arithmetic that the test shows, from definitions and laws.
    ByHand,
}

impl Origin {
    const fn name(self) -> &'static str {
        match self {
            Self::SmallSteps => "small steps",
            Self::DenseSamples => "dense samples",
            Self::AnotherProgram => "another program",
            Self::ByHand => "by hand",
        }
    }
}

/// Fails where a number is further than the bound from one of another origin. An output is named by its row of the page and
/// its own name, such as `system steady load_work`.
#[track_caller]
pub(crate) fn compared(output: &str, ours: f64, other: f64, origin: Origin, bound: f64) {
    assert!((ours - other).abs() <= bound, "{output}: {ours} for {other} of {origin:?}, beyond {bound:e}");
    recorded(output, &ours, &other, origin, bound);
}

/// Fails where a number is off by more than a part of one of another origin.
#[track_caller]
pub(crate) fn near(output: &str, ours: f64, other: f64, origin: Origin, part: f64) {
    compared(output, ours, other, origin, part * other.abs());
}

/// Fails where a count or a word is not that of another origin.
#[track_caller]
pub(crate) fn agreed<T: PartialEq<U> + Debug, U: Debug>(output: &str, ours: T, other: U, origin: Origin) {
    assert!(ours == other, "{output}: {ours:?} for {other:?} of {origin:?}");
    recorded(output, &ours, &other, origin, 0.0);
}

/// Leaves the row of a comparison that has held, in the file of this thread. A thread of a test has its name.
pub(crate) fn recorded(output: &str, ours: &dyn Debug, other: &dyn Debug, origin: Origin, bound: f64) {
    thread_local! {
        static ROWS: OnceCell<File> = const { OnceCell::new() };
    }
    let (program, thread) = (env!("CARGO_CRATE_NAME"), std::thread::current());
    ROWS.with(|rows| {
        let mut file = rows.get_or_init(|| {
            let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("evidence");
            std::fs::create_dir_all(&folder).unwrap();
            let name = format!("{program}-{}-{:?}.tsv", std::process::id(), thread.id());
            File::options().create(true).append(true).open(folder.join(name)).unwrap()
        });
        let test = format!("{program}::{}", thread.name().unwrap_or_default());
        let row = format!("{output}\t{ours:?}\t{other:?}\t{}\t{bound:e}\t{test}\n", origin.name());
        file.write_all(row.as_bytes()).unwrap();
    });
}
