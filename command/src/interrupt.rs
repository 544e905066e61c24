//! Interrupts take effect within 0.3 s, whatever the command is doing.
//!
//! The first signal asks for an orderly end: work stops at the next point, and complete records are written.
//! Work that does not check in time, or waits for input, is ended by a thread here, never in the middle of a
//! write. A second signal ends the command at once.

use crate::failure::{Failure, Outcome};
use crate::threads;
use std::fs;
use std::io::{IsTerminal, Write};
use std::ops::ControlFlow;
use std::panic;
use std::path::{Path, PathBuf};
use std::process;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

static ASKED_TO_STOP: AtomicBool = AtomicBool::new(false);
static HEARD: AtomicBool = AtomicBool::new(false);
static WRITING: AtomicBool = AtomicBool::new(false);
/// The number of writes that have begun.
static WRITES: AtomicU32 = AtomicU32::new(0);

/// The time within which the command must notice an interrupt before it is ended from here.
const GRACE: Duration = Duration::from_millis(150);
/// The time to finish a write that has begun; a write to a pipe without a reader may never end.
const LAST_WRITE: Duration = Duration::from_millis(50);

/// Installs the handler of Ctrl-C, SIGTERM and SIGHUP.
pub(crate) fn listen() {
    let hear = || {
        if ASKED_TO_STOP.swap(true, Ordering::SeqCst) {
            end();
        }
        if !threads::start(watch) {
            watch();
        }
    };
    // If the system refuses a handler, or the thread that it needs, its own behaviour remains.
    if threads::start(|| ()) {
        let _ = ctrlc::set_handler(hear);
    }
}

/// Whether the user has asked to stop; parallel work checks this and leaves the rest undone.
pub(crate) fn asked() -> bool {
    ASKED_TO_STOP.load(Ordering::SeqCst)
}

/// Fails once the user has asked to stop; the caller then ends in order.
pub(crate) fn check() -> Outcome {
    if asked() {
        HEARD.store(true, Ordering::SeqCst);
        return Err(Failure::Interrupted);
    }
    Ok(())
}

/// Tells a long search of the library to stop once the user has asked to stop.
pub(crate) fn keep_going() -> ControlFlow<()> {
    if asked() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
}

/// The temporary files that exist now.
static TEMPORARY: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// A temporary file, which is removed when this is dropped, and when an interrupt ends the command.
pub(crate) struct Temporary(PathBuf);

impl Temporary {
    pub(crate) fn new(place: PathBuf) -> Self {
        TEMPORARY.lock().unwrap_or_else(PoisonError::into_inner).push(place.clone());
        Self(place)
    }

    pub(crate) fn place(&self) -> &Path {
        &self.0
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        // A complete file has been renamed.
        let _ = fs::remove_file(&self.0);
        TEMPORARY.lock().unwrap_or_else(PoisonError::into_inner).retain(|place| *place != self.0);
    }
}

/// Performs a write that an interrupt does not cut.
pub(crate) fn uncut<T>(write: impl FnOnce() -> T) -> T {
    WRITES.fetch_add(1, Ordering::SeqCst);
    WRITING.store(true, Ordering::SeqCst);
    let done = write();
    WRITING.store(false, Ordering::SeqCst);
    done
}

/// Ends the command unless it has noticed the interrupt in time, and also if nobody reads its last output.
/// Time is measured by the clock and not by a number of sleeps, which take longer on a busy machine.
fn watch() {
    thread::sleep(GRACE);
    let (mut writes, mut since) = (WRITES.load(Ordering::SeqCst), Instant::now());
    while since.elapsed() < LAST_WRITE {
        let (heard, writing) = (HEARD.load(Ordering::SeqCst), WRITING.load(Ordering::SeqCst));
        if !heard && !writing {
            break;
        }
        let now = WRITES.load(Ordering::SeqCst);
        // A command that has noticed the interrupt and makes progress may take its time.
        if heard && (!writing || now != writes) {
            since = Instant::now();
        }
        writes = now;
        thread::sleep(LAST_WRITE / 10);
    }
    end();
}

/// Removes the temporary files, for an end that does not drop them.
fn remove_temporary() {
    for place in &*TEMPORARY.lock().unwrap_or_else(PoisonError::into_inner) {
        let _ = fs::remove_file(place);
    }
}

/// Has a panic remove the temporary files: it ends a release at once, without unwinding.
pub(crate) fn clean_after_panic() {
    let report = panic::take_hook();
    panic::set_hook(Box::new(move |panic| {
        remove_temporary();
        report(panic);
    }));
}

/// Ends the interrupted command without its threads.
pub(crate) fn end() -> ! {
    remove_temporary();
    let mut out = anstream::stderr();
    // Clears the line of a progress bar.
    let clear = if std::io::stderr().is_terminal() { "\r\u{1b}[K" } else { "" };
    let _ = writeln!(out, "{clear}{} {}", crate::style::label(), Failure::Interrupted);
    process::exit(i32::from(Failure::INTERRUPTED));
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::{env, mem};

    /// The panic is that of a process of its own, because other tests have temporary files here.
    #[test]
    fn a_panic_removes_the_temporary_files() {
        const PLACE: &str = "STICKSLIP_TEMPORARY_OF_A_PANIC";
        if let Some(place) = env::var_os(PLACE) {
            clean_after_panic();
            mem::forget(Temporary::new(place.into()));
            panic!("on purpose");
        }
        let file = tempfile::NamedTempFile::new().unwrap();
        let mut again = process::Command::new(env::current_exe().unwrap());
        again
            .args(["--exact", "interrupt::tests::a_panic_removes_the_temporary_files"])
            .env(PLACE, file.path());
        assert_eq!(again.output().unwrap().status.code(), Some(101));
        assert!(!file.path().exists());
    }
}
