//! Progress and remaining time on a terminal; parallel work whose results are written in order.

use crate::failure::{Failure, Outcome};
use crate::interrupt;
use crate::style;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use std::io::{self, IsTerminal, Write};
use std::ops::Range;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};

static QUIET: AtomicBool = AtomicBool::new(false);

/// Suppresses progress and notes.
pub(crate) fn silence() {
    QUIET.store(true, Ordering::Relaxed);
}

/// A note on one line of standard error, which `--quiet` suppresses.
pub(crate) fn note(text: &str) {
    if !QUIET.load(Ordering::Relaxed) {
        OTHERWISE.end();
        let _ = writeln!(anstream::stderr(), "{} note: {text}", style::label());
    }
}

/// The greatest number of points that one thread answers in a batch.
const STRETCH: u64 = 64;
/// The greatest duration of a round of batches, after which batches become shorter. Between rounds,
/// interrupts are checked and answers written.
const ROUND: Duration = Duration::from_millis(100);

/// Answers the points of a range in batches, and passes the answers on in order.
///
/// Only a few batches per thread are in memory.
pub(crate) fn in_order<T: Send>(
    points: Range<u64>,
    answer: impl Fn(Range<u64>) -> Result<T, Failure> + Sync,
    mut take: impl FnMut(T) -> Outcome,
) -> Outcome {
    let bar = bar(points.end - points.start, "points");
    let mut stretch = 1;
    let mut start = points.start;
    while start < points.end {
        let begin = Instant::now();
        let end = points.end.min(start + 4 * stretch * rayon::current_num_threads() as u64);
        let stretches: Vec<u64> = (start..end).step_by(stretch as usize).collect();
        let answers: Vec<_> =
            stretches.into_par_iter().map(|from| answer(from..end.min(from + stretch))).collect();
        for found in answers {
            match found {
                Err(Failure::Interrupted) => interrupt::check()?,
                found => take(found?)?,
            }
        }
        bar.inc(end - start);
        start = end;
        interrupt::check()?;
        stretch = if begin.elapsed() < ROUND { (2 * stretch).min(STRETCH) } else { (stretch / 2).max(1) };
    }
    bar.finish_and_clear();
    Ok(())
}

/// A progress bar with the remaining time, on standard error if that is a terminal.
pub(crate) fn bar(count: u64, things: &str) -> ProgressBar {
    styled(ProgressBar::new(count), &format!("{{bar:40}} {{human_pos}}/{{human_len}} {things}, {{eta}} left"))
}

/// A counter without a known total, on a terminal to which no answers are written.
pub(crate) fn counter(things: &str) -> ProgressBar {
    let bar = ProgressBar::no_length();
    if io::stdout().is_terminal() {
        bar.set_draw_target(ProgressDrawTarget::hidden());
    }
    styled(bar, &format!("{{human_pos}} {things} in {{elapsed}}"))
}

fn styled(bar: ProgressBar, template: &str) -> ProgressBar {
    OTHERWISE.end();
    if QUIET.load(Ordering::Relaxed) {
        bar.set_draw_target(ProgressDrawTarget::hidden());
    }
    match ProgressStyle::with_template(template) {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}

/// The elapsed time, for a command that shows nothing else.
struct Elapsed {
    over: AtomicBool,
    bar: Mutex<Option<ProgressBar>>,
}

static OTHERWISE: Elapsed = Elapsed { over: AtomicBool::new(false), bar: Mutex::new(None) };

/// Shows the elapsed time after one second, until there is something else to show.
pub(crate) fn of_time() {
    if QUIET.load(Ordering::Relaxed) || !io::stderr().is_terminal() {
        return;
    }
    thread::spawn(|| {
        thread::sleep(Duration::from_secs(1));
        let Ok(mut bar) = OTHERWISE.bar.lock() else { return };
        if let (false, Ok(style)) =
            (OTHERWISE.over.load(Ordering::Relaxed), ProgressStyle::with_template("computing, {elapsed}"))
        {
            let shown = ProgressBar::new_spinner().with_style(style);
            shown.enable_steady_tick(Duration::from_millis(200));
            *bar = Some(shown);
        }
    });
}

/// The first answer on a terminal replaces the elapsed time.
pub(crate) fn answered() {
    if !OTHERWISE.over.load(Ordering::Relaxed) && io::stdout().is_terminal() {
        OTHERWISE.end();
    }
}

impl Elapsed {
    fn end(&self) {
        self.over.store(true, Ordering::Relaxed);
        if let Some(shown) = self.bar.lock().ok().and_then(|mut bar| bar.take()) {
            shown.finish_and_clear();
        }
    }
}

/// Removes the progress display before the final message.
pub(crate) fn end() {
    OTHERWISE.end();
}
