//! The threads of parallel work.

use rayon::{ThreadPool, ThreadPoolBuilder};
use std::env;
use std::hint::black_box;
use std::sync::OnceLock;
use std::thread;

/// The stack of a thread: a response of 8192 bits takes 13 MB of it without optimisation.
#[cfg(feature = "mp")]
pub(crate) const STACK: usize = 32 << 20;
#[cfg(not(feature = "mp"))]
pub(crate) const STACK: usize = 2 << 20;

/// The memory that is left beside the stacks of the threads.
const ROOM: usize = 16 << 20;

/// The most threads for each processor: more of them have cost the system more than they answer.
const MOST: usize = 8;

/// The threads, and whether the one that asked for them is the only one, because the system starts no other.
struct Threads {
    pool: ThreadPool,
    is_alone: bool,
}

/// As many threads as there are processors, or as `RAYON_NUM_THREADS` says. Where the system refuses so many, it is one, and
/// where it refuses any, the calling thread.
fn threads() -> Option<&'static Threads> {
    static THREADS: OnceLock<Option<Threads>> = OnceLock::new();
    let build = || {
        let processors = thread::available_parallelism().map_or(1, usize::from);
        let asked = env::var("RAYON_NUM_THREADS").ok().and_then(|text| text.parse().ok());
        let count = asked.filter(|count| *count > 0).unwrap_or(processors).min(MOST * processors);
        let builder = |count| ThreadPoolBuilder::new().num_threads(count).stack_size(STACK);
        let pool = with_room(|| builder(count).build().or_else(|_| builder(1).build()));
        let threads = pool.map(|pool| Threads { pool, is_alone: false });
        let alone = || builder(1).use_current_thread().build().map(|pool| Threads { pool, is_alone: true });
        threads.or_else(|_| alone()).ok()
    };
    THREADS.get_or_init(build).as_ref()
}

/// Starts threads, and leaves room beside their stacks, where the system gives so much: they would leave none for the answers.
pub(crate) fn with_room<T>(start: impl FnOnce() -> T) -> T {
    let mut room: Vec<u8> = Vec::new();
    let _ = room.try_reserve_exact(ROOM);
    let started = start();
    drop(black_box(room));
    started
}

/// Has the iterators of a piece of work run on the threads.
pub(crate) fn on_all<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    match threads() {
        Some(threads) => threads.pool.install(work),
        None => work(),
    }
}

/// The threads, if there is one beside the calling one.
pub(crate) fn others() -> Option<&'static ThreadPool> {
    threads().filter(|threads| !threads.is_alone).map(|threads| &threads.pool)
}

/// The number of threads.
pub(crate) fn count() -> usize {
    others().map_or(1, ThreadPool::current_num_threads)
}

/// Starts a thread that the work does not need, if the system allows it.
pub(crate) fn start(work: impl FnOnce() + Send + 'static) -> bool {
    thread::Builder::new().spawn(work).is_ok()
}
