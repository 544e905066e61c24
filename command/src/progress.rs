//! Progress and remaining time on a terminal; parallel work whose results are written in order.

use crate::bits::Here;
use crate::failure::{Failure, Outcome, on_one_line};
use crate::interrupt;
use crate::style;
use crate::threads;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use rayon::ThreadPool;
use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, IsTerminal, Write};
use std::ops::Range;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

static QUIET: AtomicBool = AtomicBool::new(false);

/// Suppresses progress and notes.
pub(crate) fn silence() {
    QUIET.store(true, Ordering::Relaxed);
}

static NOTES: Mutex<Vec<String>> = Mutex::new(Vec::new());

/// Remembers a note for the end of the command.
pub(crate) fn note(text: &str) {
    let mut notes = NOTES.lock().unwrap_or_else(PoisonError::into_inner);
    if !notes.iter().any(|note| note == text) {
        notes.push(text.to_owned());
    }
}

/// Points of a grid, rows or bodies without an answer: the reasons of the first of them are said.
pub(crate) struct Unanswered {
    /// Their name in the plural.
    of: &'static str,
    /// The most of them whose reasons are said.
    most: u64,
    failed: AtomicU64,
}

impl Unanswered {
    pub(crate) const fn new(of: &'static str, most: u64) -> Self {
        Self { of, most, failed: AtomicU64::new(0) }
    }

    /// Says why one of them has no answer; `place` follows the words, such as ` in row 2`.
    pub(crate) fn say(&self, place: &str, failure: &Failure) {
        match self.failed.fetch_add(1, Ordering::Relaxed) {
            said if said < self.most => note(&format!("no answer{place}: {}", failure.message())),
            said if said == self.most => note(&format!("further {} have no answer, either", self.of)),
            _ => {}
        }
    }
}

/// Says why a point of a grid has no answer.
pub(crate) fn no_answer(failure: &Failure) {
    static POINTS: Unanswered = Unanswered::new("points", 20);
    POINTS.say("", failure);
}

/// Writes the notes of a command that succeeded, each on one line of standard error, unless suppressed. Where
/// it failed, standard error has the message alone.
pub(crate) fn write_notes() {
    if QUIET.load(Ordering::Relaxed) {
        return;
    }
    for text in &*NOTES.lock().unwrap_or_else(PoisonError::into_inner) {
        let _ = writeln!(anstream::stderr(), "{} note: {}", style::label(), on_one_line(text));
    }
}

/// The greatest number of points that a thread takes at a time.
const STRETCH: u64 = 64;
/// The greatest duration of a stretch: a thread that needs longer returns the rest, so that the others help,
/// and the stretches become shorter.
const LONG: Duration = Duration::from_millis(25);
/// The greatest age of answers that a kill can lose.
const AT_RISK: Duration = Duration::from_secs(1);
/// The interval at which the receiver checks for an interrupt when no answer comes.
const LOOK: Duration = Duration::from_millis(10);
/// The time after an interrupt that is left to answers in progress.
const GRACE: Duration = Duration::from_millis(100);

/// Answers the points of a range in parallel, and passes the answers on in order.
pub(crate) fn in_order<T: Send>(
    points: Range<u64>,
    answer: impl Fn(u64) -> Result<T, Failure> + Sync,
    mut take: impl FnMut(T) -> Outcome,
) -> Outcome {
    in_order_kept(points, |points| vec![answer(points.start)], |found| found.map_or(Ok(()), &mut take))
}

/// Answers the points of a range in parallel, and passes the answers on in order. `None` asks the caller to
/// keep the answers so far, because a second has passed or the command was interrupted.
///
/// `answers` gives those of the first points of a range, at least one.
///
/// An answer is passed on as soon as it and all earlier ones exist, however long the next one takes. Few
/// answers are in memory.
pub(crate) fn in_order_kept<T: Send>(
    points: Range<u64>,
    answers: impl Fn(Range<u64>) -> Vec<Result<T, Failure>> + Sync,
    mut take: impl FnMut(Option<T>) -> Outcome,
) -> Outcome {
    // Only this function and `Stretch::answers` are compiled for each type of answer: threads and order need the places of the
    // stretches alone.
    let found: Mutex<Vec<Answered<T>>> = Mutex::new(Vec::new());
    let found = || found.lock().unwrap_or_else(PoisonError::into_inner);
    let answer = |mut stretch: Stretch<'_>| {
        let start = stretch.points.start;
        let answers = stretch.answers(&answers);
        found().push(Answered { start, answers });
        start
    };
    let pass_on = |stretch: Option<u64>| {
        let Some(start) = stretch else { return take(None).map(|()| Passed::default()) };
        let taken = {
            let mut found = found();
            let place = found.iter().position(|stretch| stretch.start == start);
            place.map(|place| found.swap_remove(place).answers)
        };
        let mut passed = Passed::default();
        for one in taken.into_iter().flatten() {
            match one {
                // The thread noticed the interrupt first.
                Err(Failure::Interrupted) => return Ok(Passed { is_interrupted: true, ..passed }),
                one => take(Some(one?))?,
            }
            passed.count += 1;
        }
        Ok(passed)
    };
    stretches_in_order(threads::others(), points, &answer, &mut { pass_on })
}

/// The answers of a stretch.
struct Answered<T> {
    start: u64,
    answers: Vec<Result<T, Failure>>,
}

/// The part of a stretch's answers that was passed on.
#[derive(Default)]
struct Passed {
    count: u64,
    /// Whether the next one ended by an interrupt.
    is_interrupted: bool,
}

/// Answers the points in stretches, each by `answer`, which returns its first point, and has the stretches passed on in order;
/// with `None` those so far are to be kept. Without other threads this one answers.
fn stretches_in_order(
    others: Option<&ThreadPool>,
    points: Range<u64>,
    answer: &(dyn Fn(Stretch<'_>) -> u64 + Sync),
    pass_on: &mut dyn FnMut(Option<u64>) -> Result<Passed, Failure>,
) -> Outcome {
    let bar = bar(points.end - points.start, "points");
    let work = OpenPoints::new(&points);
    let (sender, receiver) = mpsc::channel();
    let mut taking = Taking {
        work: &work,
        receiver,
        pass_on,
        next: points.start,
        waiting: BTreeSet::new(),
        kept: Instant::now(),
        is_kept: true,
    };
    let here = Here::new();
    let show = |next: u64| bar.set_position(next - points.start);
    let outcome = match others {
        Some(pool) => pool.in_place_scope(|scope| {
            for _ in 0..work.threads {
                let (work, sender) = (&work, sender.clone());
                scope.spawn(move |_| {
                    here.run(|| {
                        while let Some(stretch) = work.claim() {
                            if sender.send(answer(stretch)).is_err() {
                                break;
                            }
                        }
                    });
                });
            }
            drop(sender);
            let outcome = taking.all(show);
            work.stop();
            outcome
        }),
        // This thread answers, too, and takes each stretch before it begins the next one.
        None => {
            let mut outcome = Ok(true);
            while outcome.is_ok()
                && let Some(stretch) = work.claim()
                && sender.send(answer(stretch)).is_ok()
            {
                outcome = taking.step(Duration::ZERO, show);
            }
            drop(sender);
            outcome.and_then(|_| taking.all(show))
        }
    };
    if outcome.is_ok() {
        bar.finish_and_clear();
    }
    outcome
}

/// The points that no thread has taken yet.
struct OpenPoints {
    threads: u64,
    left: Mutex<Left>,
    /// Wakes threads that wait for points.
    change: Condvar,
}

struct Left {
    /// The points that belong to no stretch, as ranges by their start: those of no stretch yet, and the rest of stretches
    /// that took too long.
    open: BTreeMap<u64, u64>,
    /// The greatest length of a stretch now.
    stretch: u64,
    /// The number of stretches that are being answered.
    busy: u64,
    /// The first point whose answer was not passed on.
    next: u64,
    stopped: bool,
}

impl OpenPoints {
    fn new(points: &Range<u64>) -> Self {
        let open = if points.is_empty() { BTreeMap::new() } else { [(points.start, points.end)].into() };
        let left = Left { open, stretch: 1, busy: 0, next: points.start, stopped: false };
        let threads = threads::count() as u64;
        Self { threads, left: Mutex::new(left), change: Condvar::new() }
    }

    fn left(&self) -> MutexGuard<'_, Left> {
        self.left.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The next stretch, once it is not too far ahead; `None` if no points are left.
    fn claim(&self) -> Option<Stretch<'_>> {
        let mut left = self.left();
        loop {
            if left.stopped {
                return None;
            }
            let most = left.stretch;
            match left.open.first_key_value().map(|(start, end)| (*start, *end)) {
                Some((start, end)) if start < left.next + 4 * most * self.threads => {
                    left.open.remove(&start);
                    let cut = end.min(start + most);
                    if cut < end {
                        left.open.insert(cut, end);
                    }
                    left.busy += 1;
                    return Some(Stretch { work: self, points: start..cut, begin: Instant::now() });
                }
                None if left.busy == 0 => return None,
                Some(_) | None => {}
            }
            left = self.change.wait(left).unwrap_or_else(PoisonError::into_inner);
        }
    }

    fn passed_on(&self, next: u64) {
        self.left().next = next;
        self.change.notify_all();
    }

    fn stop(&self) {
        self.left().stopped = true;
        self.change.notify_all();
    }
}

/// Consecutive points of one thread. When dropped, a stretch returns the points without an answer.
struct Stretch<'a> {
    work: &'a OpenPoints,
    points: Range<u64>,
    begin: Instant,
}

impl Stretch<'_> {
    /// The answers, up to the first failure or for some time; at least one.
    fn answers<T>(
        &mut self,
        answers: impl Fn(Range<u64>) -> Vec<Result<T, Failure>>,
    ) -> Vec<Result<T, Failure>> {
        let mut found = Vec::new();
        while !self.points.is_empty() {
            let some = answers(self.points.clone());
            self.points.start += some.len() as u64;
            let failed = some.iter().any(Result::is_err);
            found.extend(some);
            if failed || self.begin.elapsed() > LONG {
                break;
            }
        }
        found
    }
}

impl Drop for Stretch<'_> {
    fn drop(&mut self) {
        let mut left = self.work.left();
        left.busy -= 1;
        if !self.points.is_empty() {
            left.open.insert(self.points.start, self.points.end);
        }
        let is_long = self.begin.elapsed() > LONG;
        left.stretch = if is_long { (left.stretch / 2).max(1) } else { (2 * left.stretch).min(STRETCH) };
        drop(left);
        self.work.change.notify_all();
    }
}

/// The receiver of the stretches, which has them passed on in order.
struct Taking<'a> {
    work: &'a OpenPoints,
    receiver: Receiver<u64>,
    pass_on: &'a mut dyn FnMut(Option<u64>) -> Result<Passed, Failure>,
    next: u64,
    /// The first points of stretches that were answered before earlier ones.
    waiting: BTreeSet<u64>,
    kept: Instant,
    is_kept: bool,
}

impl Taking<'_> {
    /// Passes the answers on until there are no more.
    fn all(&mut self, show: impl Fn(u64)) -> Outcome {
        while self.step(LOOK, &show)? {}
        interrupt::check()
    }

    /// Passes on the answers that come within `time`; `false` if no more can come.
    fn step(&mut self, time: Duration, show: impl Fn(u64)) -> Result<bool, Failure> {
        if !self.wait(time)? {
            return Ok(false);
        }
        show(self.next);
        if self.kept.elapsed() > AT_RISK {
            self.keep()?;
        }
        if interrupt::check().is_err() {
            self.interrupted()?;
        }
        Ok(true)
    }

    /// Passes on the answers that are there within `time`; `false` if no more can come.
    fn wait(&mut self, time: Duration) -> Result<bool, Failure> {
        match self.receiver.recv_timeout(time) {
            Ok(start) => self.waiting.insert(start),
            Err(RecvTimeoutError::Timeout) => return Ok(true),
            Err(RecvTimeoutError::Disconnected) => return Ok(false),
        };
        while self.waiting.remove(&self.next) {
            let passed = (self.pass_on)(Some(self.next))?;
            self.next += passed.count;
            self.is_kept &= passed.count == 0;
            if passed.is_interrupted {
                break;
            }
            self.work.passed_on(self.next);
        }
        Ok(true)
    }

    fn keep(&mut self) -> Outcome {
        if !self.is_kept {
            (self.pass_on)(None)?;
        }
        (self.kept, self.is_kept) = (Instant::now(), true);
        Ok(())
    }

    /// Keeps the existing answers, and ends the command if a point takes too long.
    fn interrupted(&mut self) -> Outcome {
        self.work.stop();
        self.keep()?;
        let begin = Instant::now();
        while self.wait(GRACE.saturating_sub(begin.elapsed()))? {
            if begin.elapsed() >= GRACE {
                self.keep()?;
                interrupt::end();
            }
        }
        self.keep()?;
        Err(Failure::Interrupted)
    }
}

/// A progress bar with the remaining time, on standard error if this is a terminal.
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
    // A bar is on a terminal only.
    if io::stderr().is_terminal() {
        OTHERWISE.end();
    }
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

/// The time after which the elapsed time is shown on a terminal, and the time between two changes of it.
const SHOWN_AFTER: Duration = Duration::from_secs(1);
const TICK: Duration = Duration::from_millis(200);
/// The time after which a line says that the work goes on, where standard error is no terminal.
const SAID_AFTER: Duration = Duration::from_secs(2);

/// Shows the elapsed time until there is something else to show. Where standard error is no terminal, one line says that the
/// work goes on.
pub(crate) fn of_time() {
    if !QUIET.load(Ordering::Relaxed) {
        // The work goes on without it.
        threads::start(if io::stderr().is_terminal() { show_elapsed } else { say_that_it_goes_on });
    }
}

fn show_elapsed() {
    thread::sleep(SHOWN_AFTER);
    loop {
        let Ok(mut bar) = OTHERWISE.bar.lock() else { return };
        if OTHERWISE.over.load(Ordering::Relaxed) {
            return;
        }
        if bar.is_none() {
            let Ok(style) = ProgressStyle::with_template("computing, {elapsed}") else { return };
            *bar = Some(ProgressBar::new_spinner().with_style(style));
        }
        if let Some(shown) = &*bar {
            shown.tick();
        }
        drop(bar);
        thread::sleep(TICK);
    }
}

fn say_that_it_goes_on() {
    thread::sleep(SAID_AFTER);
    if !OTHERWISE.over.load(Ordering::Relaxed) {
        let _ = writeln!(anstream::stderr(), "{} note: still computing. Ctrl-C ends it", style::label());
    }
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

#[cfg(test)]
mod tests {
    use super::{Passed, Stretch, in_order, in_order_kept, stretches_in_order};
    use crate::failure::Failure;
    use std::thread;
    use std::time::Duration;

    /// Points that take between no time and twice the greatest duration of a stretch.
    fn slow(point: u64) -> Result<u64, Failure> {
        if point % 37 == 5 {
            thread::sleep(Duration::from_millis(point % 50));
        }
        Ok(point)
    }

    #[test]
    fn answers_come_in_order_whatever_they_take() {
        for points in [0..0, 3..4, 5..1000] {
            let mut found = Vec::new();
            let take = |point| {
                found.push(point);
                Ok(())
            };
            assert!(in_order(points.clone(), slow, take).is_ok());
            assert_eq!(found, points.collect::<Vec<_>>());
        }
    }

    /// Where the system starts no thread, the calling one answers in the same order.
    #[test]
    fn one_thread_answers_alone() {
        let (mut all, mut next) = (Vec::new(), 0);
        let found = std::sync::Mutex::new(Vec::new());
        let answer = |mut stretch: Stretch<'_>| {
            let start = stretch.points.start;
            let answers = stretch.answers(|points| vec![slow(points.start)]);
            found.lock().unwrap().push((start, answers.into_iter().map(Result::unwrap).collect::<Vec<_>>()));
            start
        };
        let mut pass_on = |stretch: Option<u64>| {
            let Some(start) = stretch else { return Ok(Passed::default()) };
            assert_eq!(start, next);
            let (_, some) = found.lock().unwrap().pop().unwrap();
            next += some.len() as u64;
            let count = some.len() as u64;
            all.extend(some);
            Ok(Passed { count, is_interrupted: false })
        };
        assert!(stretches_in_order(None, 0..1000, &answer, &mut pass_on).is_ok());
        assert_eq!(all, (0..1000).collect::<Vec<_>>());
    }

    #[test]
    fn the_answers_before_a_failure_are_taken() {
        for bad in [0, 1, 77, 499] {
            let mut found = Vec::new();
            let answer =
                |point| if point < bad { slow(point) } else { Err(Failure::Input(format!("{point}"))) };
            let take = |point: Option<u64>| {
                found.extend(point);
                Ok(())
            };
            let outcome = in_order_kept(0..500, |points| vec![answer(points.start)], take);
            assert!(matches!(outcome, Err(Failure::Input(text)) if text == bad.to_string()));
            assert_eq!(found, (0..bad).collect::<Vec<_>>());
        }
    }
}
