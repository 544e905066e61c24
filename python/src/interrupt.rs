//! Long work without the interpreter's lock, on threads of this process, which Ctrl-C still ends.

use core::ops::ControlFlow;
use core::panic::AssertUnwindSafe;
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::panic::catch_unwind;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::sync::{Mutex, OnceLock};
use std::time::Duration;

/// How often the interpreter is asked for a signal.
const EVERY: Duration = Duration::from_millis(50);

/// Whether work is to be left: set once the interpreter has a signal.
pub(crate) struct Stop(AtomicBool);

impl Stop {
    /// Never set: for work that is short.
    pub(crate) const fn never() -> Self {
        Self(AtomicBool::new(false))
    }

    /// The answer in the form that the library's hooks take.
    pub(crate) fn asked(&self) -> ControlFlow<()> {
        if self.0.load(Ordering::Relaxed) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

/// The pools of this process and of those it was forked from, of which a fork has the memory but not the
/// threads: work given to one of them would wait for ever.
static POOLS: [OnceLock<Option<ThreadPool>>; 16] = [const { OnceLock::new() }; 16];
/// How many forks this process is away from the first one.
static FORKS: AtomicUsize = AtomicUsize::new(0);

/// Told by the interpreter in the child after a fork.
#[pyfunction]
fn forked() {
    FORKS.fetch_add(1, Ordering::Relaxed);
}

/// The threads of this process; `None` where the system gives none.
fn pool() -> Option<&'static ThreadPool> {
    let own = POOLS.get(FORKS.load(Ordering::Relaxed))?;
    own.get_or_init(|| ThreadPoolBuilder::new().build().ok()).as_ref()
}

/// Waits for an answer, and for signals, with which `signalled` is called; an error where it returns one, or
/// where the work ended without an answer.
fn awaited<T: Send>(
    py: Python<'_>,
    ended: Receiver<T>,
    mut signalled: impl FnMut(Python<'_>) -> PyResult<()>,
) -> PyResult<T> {
    let ended = Mutex::new(ended);
    loop {
        match py.detach(|| ended.lock().ok().map(|ended| ended.recv_timeout(EVERY))) {
            Some(Ok(answer)) => return Ok(answer),
            Some(Err(RecvTimeoutError::Timeout)) => signalled(py)?,
            Some(Err(RecvTimeoutError::Disconnected)) | None => return Err(no_answer()),
        }
    }
}

fn no_answer() -> PyErr {
    crate::refused("the work ended without an answer: a defect of this package")
}

/// Runs `work` on the threads of this process, while this one waits for it and for signals. A signal, such as
/// that of Ctrl-C, sets the flag and is raised when the work has ended.
pub(crate) fn interruptible<T: Send>(py: Python<'_>, work: impl FnOnce(&Stop) -> T + Send) -> PyResult<T> {
    let stop = Stop::never();
    let Some(pool) = pool() else { return Ok(py.detach(|| work(&stop))) };
    let mut raised = None;
    let (done, ended) = mpsc::channel();
    let result = pool.in_place_scope(|scope| {
        let stop = &stop;
        scope.spawn(move |_| {
            // Nobody but this function receives, and it waits.
            let _ = done.send(catch_unwind(AssertUnwindSafe(|| work(stop))));
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
    match raised {
        Some(signal) => Err(signal),
        None => result?.map_err(|_| no_answer()),
    }
}

/// Runs work that nothing can break off on a thread of its own, which a signal leaves behind.
pub(crate) fn left_behind<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce() -> T + Send + 'static,
) -> PyResult<T> {
    let (done, ended) = mpsc::channel();
    std::thread::spawn(move || {
        // Nobody waits for it after a signal.
        let _ = done.send(work());
    });
    awaited(py, ended, |py| py.check_signals())
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(forked, module)?)
}
