//! Runs long work on worker threads without the interpreter's lock; Ctrl-C still interrupts it.

use core::ops::ControlFlow;
use core::panic::AssertUnwindSafe;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::env;
use std::panic::catch_unwind;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::sync::{Arc, Mutex, OnceLock};
use std::thread;
use std::time::Duration;

/// The interval at which the interpreter is asked for signals.
const EVERY: Duration = Duration::from_millis(50);

/// Whether work should stop: set once the interpreter has a signal.
pub struct Stop(AtomicBool);

impl Stop {
    /// A flag that is not set, which suffices for short work.
    pub const fn never() -> Self {
        Self(AtomicBool::new(false))
    }

    /// The flag in the form that the library's hooks expect.
    pub fn asked(&self) -> ControlFlow<()> {
        if self.0.load(Ordering::Relaxed) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

/// The thread pools of this process and of the processes from which it was forked. A fork inherits the memory
/// of a pool but not its threads, so that work given to an inherited pool would wait for ever.
static POOLS: [OnceLock<Option<ThreadPool>>; 16] = [const { OnceLock::new() }; 16];
/// The number of forks between the first process and this one.
static FORKS: AtomicUsize = AtomicUsize::new(0);

/// Called by the interpreter in the child after a fork.
#[pyfunction]
fn forked() {
    FORKS.fetch_add(1, Ordering::Relaxed);
}

/// The most threads for each processor, as for the command: more of them cost the system more than they answer.
const MOST: usize = 8;

/// The thread pool of this process: as many threads as there are processors, or as `RAYON_NUM_THREADS` says, or one where
/// the system refuses so many. `None` where it refuses any.
fn pool() -> Option<&'static ThreadPool> {
    let own = POOLS.get(FORKS.load(Ordering::Relaxed))?;
    let build = || {
        let processors = thread::available_parallelism().map_or(1, usize::from);
        let asked = env::var("RAYON_NUM_THREADS").ok().and_then(|text| text.parse().ok());
        let count = asked.filter(|count| *count > 0).unwrap_or(processors).min(MOST * processors);
        let of = |count| ThreadPoolBuilder::new().num_threads(count).build();
        of(count).or_else(|_| of(1)).ok()
    };
    own.get_or_init(build).as_ref()
}

thread_local! {
    /// The pool of a thread alone, whose parallel iterators run on it: those of no pool would start threads.
    static ALONE: Option<ThreadPool> = ThreadPoolBuilder::new().num_threads(1).use_current_thread().build().ok();
}

/// Runs work on the calling thread.
fn alone<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    ALONE.with(|pool| match pool {
        Some(pool) => pool.install(work),
        None => work(),
    })
}

/// Waits for the end of work, and calls `signalled` at intervals to check for signals. The wait fails if
/// `signalled` fails, or if the work ends without a word.
fn awaited(
    py: Python<'_>,
    ended: Receiver<()>,
    mut signalled: impl FnMut(Python<'_>) -> PyResult<()>,
) -> PyResult<()> {
    let ended = Mutex::new(ended);
    loop {
        match py.detach(|| ended.lock().ok().map(|ended| ended.recv_timeout(EVERY))) {
            Some(Ok(())) => return Ok(()),
            Some(Err(RecvTimeoutError::Timeout)) => signalled(py)?,
            Some(Err(RecvTimeoutError::Disconnected)) | None => return Err(no_answer()),
        }
    }
}

/// Work that leaves its result in a slot, so that threads and channels are compiled once for all results.
type Task<'a> = Box<dyn FnOnce() + Send + 'a>;

/// Leaves a result in its slot.
fn leave<T>(slot: &Mutex<Option<T>>, result: T) {
    if let Ok(mut slot) = slot.lock() {
        *slot = Some(result);
    }
}

fn no_answer() -> PyErr {
    PyRuntimeError::new_err("the computation ended without an answer: this is a defect of stickslip")
}

/// Runs `work` on the worker threads, while the calling thread waits for its end and for signals. A signal,
/// for example from Ctrl-C, sets the flag and is raised when the work has ended.
pub fn interruptible<T: Send>(py: Python<'_>, work: impl FnOnce(&Stop) -> T + Send) -> PyResult<T> {
    let stop = Stop::never();
    let Some(pool) = pool() else { return Ok(py.detach(|| alone(|| work(&stop)))) };
    let slot = Mutex::new(None);
    spawned(py, pool, &stop, Box::new(|| leave(&slot, work(&stop))))?;
    slot.into_inner().ok().flatten().ok_or_else(no_answer)
}

/// Runs a task on the worker threads, as [`interruptible`] says; one that panics ends like any other.
fn spawned(py: Python<'_>, pool: &ThreadPool, stop: &Stop, task: Task<'_>) -> PyResult<()> {
    let mut raised = None;
    let (done, ended) = mpsc::channel();
    let result = pool.in_place_scope(|scope| {
        scope.spawn(move |_| {
            let _ = catch_unwind(AssertUnwindSafe(task));
            // Sending succeeds: the receiver is this function, which waits.
            let _ = done.send(());
        });
        awaited(py, ended, |py| {
            if raised.is_none()
                && let Err(signal) = py.check_signals()
            {
                stop.0.store(true, Ordering::Relaxed);
                raised = Some(signal);
            }
            Ok(())
        })
    });
    raised.map_or(result, Err)
}

/// Runs work that cannot be interrupted on a separate thread, which is abandoned on a signal, or on the calling one where the
/// system starts no other.
pub fn left_behind<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce() -> T + Send + 'static,
) -> PyResult<T> {
    let slot = Arc::new(Mutex::new(None));
    let (done, ended) = mpsc::channel();
    let filled = slot.clone();
    let task: Task<'static> = Box::new(move || {
        leave(&filled, work());
        // After a signal there is no receiver, and the result is discarded.
        let _ = done.send(());
    });
    let kept = Arc::new(Mutex::new(Some(task)));
    let run = |kept: &Mutex<Option<Task<'static>>>| {
        if let Some(task) = kept.lock().ok().and_then(|mut kept| kept.take()) {
            task();
        }
    };
    let other = kept.clone();
    if thread::Builder::new().spawn(move || run(&other)).is_err() {
        py.detach(|| run(&kept));
    }
    awaited(py, ended, |py| py.check_signals())?;
    let answer = slot.lock().ok().and_then(|mut slot| slot.take());
    answer.ok_or_else(no_answer)
}

/// Adds the function that a fork calls.
///
/// # Errors
/// Those of the interpreter.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(forked, module)?)
}
