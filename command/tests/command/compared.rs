//! Comparisons of an answer with a number of another origin. Each that ran leaves a row below the folder of the target, which
//! `.ci/evidence` holds against docs/development/evidence.md.

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
    /// Arithmetic that the test shows.
    ByHand,
}

impl Origin {
    const fn name(self) -> &'static str {
        match self {
            Self::SmallSteps => "small steps",
            Self::DenseSamples => "dense samples",
            Self::ByHand => "by hand",
        }
    }
}

/// Fails where a number is further than the bound from one of another origin. An output is named by its row of the page and
/// its own name, such as `system steady load_work`.
pub(crate) fn compared(output: &str, ours: f64, other: f64, origin: Origin, bound: f64) {
    assert!((ours - other).abs() <= bound, "{output}: {ours} for {other} of {origin:?}, beyond {bound:e}");
    row(output, &ours, &other, origin, bound);
}

/// Fails where a count or a word is not that of another origin.
pub(crate) fn agreed<T: PartialEq<U> + Debug, U: Debug>(output: &str, ours: T, other: U, origin: Origin) {
    assert!(ours == other, "{output}: {ours:?} for {other:?} of {origin:?}");
    row(output, &ours, &other, origin, 0.0);
}

/// Leaves a row in the file of this thread.
fn row(output: &str, ours: &dyn Debug, other: &dyn Debug, origin: Origin, bound: f64) {
    thread_local! {
        static ROWS: OnceCell<File> = const { OnceCell::new() };
    }
    ROWS.with(|rows| {
        let mut file = rows.get_or_init(|| {
            let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("evidence");
            std::fs::create_dir_all(&folder).unwrap();
            let (program, thread) = (env!("CARGO_CRATE_NAME"), std::thread::current().id());
            let name = format!("{program}-{}-{thread:?}.tsv", std::process::id());
            File::options().create(true).append(true).open(folder.join(name)).unwrap()
        });
        writeln!(file, "{output}\t{ours:?}\t{other:?}\t{}\t{bound:e}", origin.name()).unwrap();
    });
}
