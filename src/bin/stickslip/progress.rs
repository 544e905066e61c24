//! Progress and time left on a terminal; work done in parallel and written in order.

use crate::failure::Outcome;
use crate::interrupt;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};

static QUIET: AtomicBool = AtomicBool::new(false);

/// From now on nobody is told of progress.
pub(crate) fn silence() {
    QUIET.store(true, Ordering::Relaxed);
}

/// Points that one thread answers at a stretch.
const STRETCH: u64 = 64;

/// Answers the points of a range, a stretch at a time, and hands the answers on in order.
///
/// No more stretches are in memory than a few for each thread.
pub(crate) fn in_order<T: Send>(
    points: Range<u64>,
    answer: impl Fn(Range<u64>) -> Result<T, crate::failure::Failure> + Sync,
    mut take: impl FnMut(T) -> Outcome,
) -> Outcome {
    let bar = bar(points.end - points.start, "points");
    let at_once = STRETCH * 4 * rayon::current_num_threads() as u64;
    let mut start = points.start;
    while start < points.end {
        let end = points.end.min(start + at_once);
        let stretches: Vec<u64> = (start..end).step_by(STRETCH as usize).collect();
        let answers: Vec<_> =
            stretches.into_par_iter().map(|from| answer(from..end.min(from + STRETCH))).collect();
        for found in answers {
            take(found?)?;
        }
        bar.inc(end - start);
        start = end;
        interrupt::check()?;
    }
    bar.finish_and_clear();
    Ok(())
}

/// A bar of `count` things done and the time left, on standard error where that is a terminal.
pub(crate) fn bar(count: u64, things: &str) -> ProgressBar {
    let bar = ProgressBar::new(count);
    if QUIET.load(Ordering::Relaxed) {
        bar.set_draw_target(ProgressDrawTarget::hidden());
    }
    match ProgressStyle::with_template(&format!(
        "{{bar:40}} {{human_pos}}/{{human_len}} {things}, {{eta}} left"
    )) {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
