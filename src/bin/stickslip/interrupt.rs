//! Interrupts: heard within 0.3 s, wherever the command is.
//!
//! The first signal asks for an orderly end: work is left at the next point, and what is complete is written.
//! Work that does not ask in time, or waits for input, is ended from here, never in the middle of a write. A
//! second signal ends the command at once.

use crate::failure::{Failure, Outcome};
use std::io::{IsTerminal, Write};
use std::process;
use std::sync::Once;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::thread;
use std::time::{Duration, Instant};

static ASKED_TO_STOP: AtomicBool = AtomicBool::new(false);
static HEARD: AtomicBool = AtomicBool::new(false);
static WRITING: AtomicBool = AtomicBool::new(false);
/// Writes that have begun.
static WRITES: AtomicU32 = AtomicU32::new(0);

/// Time to hear an interrupt before the command is ended from here.
const GRACE: Duration = Duration::from_millis(150);
/// Time to end a write that has begun: one to a pipe that nobody reads may never end.
const LAST_WRITE: Duration = Duration::from_millis(50);

/// From now on Ctrl-C, SIGTERM and SIGHUP are interrupts.
pub(crate) fn listen() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let hear = || {
            if ASKED_TO_STOP.swap(true, Ordering::SeqCst) {
                end();
            }
            thread::spawn(watch);
        };
        // Where the system refuses a handler, its own way of stopping stays.
        let _ = ctrlc::set_handler(hear);
    });
}

/// Whether the user has asked to stop: for work in parallel, which leaves the rest undone.
pub(crate) fn asked() -> bool {
    ASKED_TO_STOP.load(Ordering::SeqCst)
}

/// Fails once the user has asked to stop; the caller then ends in order, at its own pace.
pub(crate) fn check() -> Outcome {
    if asked() {
        HEARD.store(true, Ordering::SeqCst);
        return Err(Failure::Interrupted);
    }
    Ok(())
}

/// A write, which an interrupt does not cut.
pub(crate) fn uncut<T>(write: impl FnOnce() -> T) -> T {
    WRITES.fetch_add(1, Ordering::SeqCst);
    WRITING.store(true, Ordering::SeqCst);
    let done = write();
    WRITING.store(false, Ordering::SeqCst);
    done
}

/// Ends the command unless it has heard of the interrupt in time, and where its last words find no reader.
///
/// By the clock and not by a number of sleeps, each of which a busy machine makes longer.
fn watch() {
    thread::sleep(GRACE);
    let (mut writes, mut since) = (WRITES.load(Ordering::SeqCst), Instant::now());
    while since.elapsed() < LAST_WRITE {
        let (heard, writing) = (HEARD.load(Ordering::SeqCst), WRITING.load(Ordering::SeqCst));
        if !heard && !writing {
            break;
        }
        let now = WRITES.load(Ordering::SeqCst);
        // What has heard and goes on may take its time.
        if heard && (!writing || now != writes) {
            since = Instant::now();
        }
        writes = now;
        thread::sleep(LAST_WRITE / 10);
    }
    end();
}

fn end() -> ! {
    let mut out = anstream::stderr();
    // The line of a progress bar that was being drawn.
    let clear = if std::io::stderr().is_terminal() { "\r\u{1b}[K" } else { "" };
    let _ = writeln!(out, "{clear}{} {}", crate::style::label(), Failure::Interrupted);
    process::exit(i32::from(Failure::INTERRUPTED));
}
