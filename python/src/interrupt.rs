//! Long work without the interpreter's lock, which Ctrl-C still ends.

use core::ops::ControlFlow;
use pyo3::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc;
use std::thread;
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

/// Runs `work` on a thread of its own, while this one waits for it and for signals. A signal, such as that of Ctrl-C, sets the flag and
/// is raised when the work has ended.
pub(crate) fn interruptible<T: Send>(py: Python<'_>, work: impl FnOnce(&Stop) -> T + Send) -> PyResult<T> {
    let stop = Stop(AtomicBool::new(false));
    thread::scope(|scope| {
        let (done, ended) = mpsc::channel::<()>();
        let worker = scope.spawn(|| {
            // Dropped at the end of the work, whatever its end: that wakes the waiting thread.
            let _done = done;
            work(&stop)
        });
        let ended = std::sync::Mutex::new(ended);
        let mut raised = None;
        while !worker.is_finished() {
            py.detach(|| {
                if let Ok(ended) = ended.lock() {
                    let _ = ended.recv_timeout(EVERY);
                }
            });
            if raised.is_none()
                && let Err(signal) = py.check_signals()
            {
                stop.0.store(true, Ordering::Relaxed);
                raised = Some(signal);
            }
        }
        let result = py.detach(|| worker.join());
        match (raised, result) {
            (Some(signal), _) => Err(signal),
            (None, Ok(value)) => Ok(value),
            (None, Err(_)) => {
                Err(crate::refused("the work ended without an answer: a defect of this package"))
            }
        }
    })
}
