//! Progress and time left on a terminal; work done in parallel and written in order.

use crate::failure::{Failure, Outcome};
use crate::interrupt;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use std::io::{self, IsTerminal};
use std::ops::Range;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};

static QUIET: AtomicBool = AtomicBool::new(false);

/// From now on nobody is told of progress.
pub(crate) fn silence() {
    QUIET.store(true, Ordering::Relaxed);
}

/// Points that one thread answers at a stretch, at most.
const STRETCH: u64 = 64;
/// How long a round of stretches may take before the next has shorter ones: in between an interrupt is heard,
/// and what was answered is written.
const ROUND: Duration = Duration::from_millis(100);

/// Answers the points of a range, a stretch at a time, and hands the answers on in order.
///
/// No more stretches are in memory than a few for each thread.
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

/// A bar of `count` things done and the time left, on standard error where that is a terminal.
pub(crate) fn bar(count: u64, things: &str) -> ProgressBar {
    styled(ProgressBar::new(count), &format!("{{bar:40}} {{human_pos}}/{{human_len}} {things}, {{eta}} left"))
}

/// Things done of nobody knows how many: on a terminal, where the answers go elsewhere.
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

/// The time that passes, where a command has nothing else to show.
struct Elapsed {
    over: AtomicBool,
    bar: Mutex<Option<ProgressBar>>,
}

static OTHERWISE: Elapsed = Elapsed { over: AtomicBool::new(false), bar: Mutex::new(None) };

/// From a second on, shows the time until there is something else to show.
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

/// The first answer on a terminal takes the place of the time.
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

/// Removes what is shown, before the last words.
pub(crate) fn end() {
    OTHERWISE.end();
}
