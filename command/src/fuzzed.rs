//! The command as the fuzz targets call it: any bytes as a command line, as a file of points, as the beginning of a sweep.

#![allow(
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    clippy::unreachable,
    reason = "a panic is a finding"
)]

mod command;
mod points;
mod resume;

pub use command::command;
pub use points::points;
pub use resume::resume;

use crate::failure::Failure;
use std::path::PathBuf;

/// A file of this process.
#[expect(clippy::disallowed_methods, reason = "a target has no folder of its own")]
fn file(name: &str) -> PathBuf {
    std::env::temp_dir().join(format!("stickslip-{name}-{}", std::process::id()))
}

/// A failure is a single nonempty line that a terminal can show.
fn is_one_line(failure: &Failure) {
    let text = failure.message();
    assert!(
        !text.trim().is_empty() && !text.chars().any(char::is_control) && text.len() < 10_000,
        "{text:?}"
    );
}
