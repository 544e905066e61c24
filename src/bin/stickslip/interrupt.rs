//! Ctrl-C between two answers, not within one.

use crate::failure::{Failure, Outcome};
use std::sync::atomic::{AtomicBool, Ordering};

static ASKED_TO_STOP: AtomicBool = AtomicBool::new(false);

/// From now on Ctrl-C is an answer of [`check`].
pub(crate) fn listen() {
    // Where the system refuses a handler, its own way of stopping stays.
    let _ = ctrlc::set_handler(|| ASKED_TO_STOP.store(true, Ordering::Relaxed));
}

/// Fails once the user has asked to stop.
pub(crate) fn check() -> Outcome {
    if ASKED_TO_STOP.load(Ordering::Relaxed) { Err(Failure::Interrupted) } else { Ok(()) }
}
