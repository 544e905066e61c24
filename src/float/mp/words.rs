//! The precision of a computation: the number of limbs that the results of the two capacities have on this thread.
//!
//! A type for each precision would be a copy of every formula, and compiling the copies is what takes the time. A number
//! of a capacity keeps its own number of limbs, so that numbers of several precisions may meet: MPFR rounds to that of
//! the result, and a computation has the same bits as in the type that has just as many limbs.

use core::cell::Cell;

thread_local! {
    static WORDS: Cell<u32> = const { Cell::new(u32::MAX) };
}

/// Whether the numbers with this many limbs take their precision from the computation. No other type takes one of these as
/// its wider or narrower one.
pub(crate) const fn is_capacity(limbs: usize) -> bool {
    matches!(limbs, 26 | GREATEST)
}

/// The limbs of the greater capacity.
pub(crate) const GREATEST: usize = 130;

/// The number of limbs set on this thread; without one, more than any number has.
pub(crate) fn here() -> u32 {
    WORDS.get()
}

/// Runs a computation in which the results of the capacities have this many limbs, on this thread.
pub(crate) fn with_words<T>(words: u32, computation: impl FnOnce() -> T) -> T {
    struct Before(u32);
    // A panic must not leave the thread with another's precision.
    impl Drop for Before {
        fn drop(&mut self) {
            WORDS.set(self.0);
        }
    }
    let _before = Before(WORDS.replace(words));
    computation()
}

/// Evaluates an expression at a precision of some limbs, generic over the least capacity that has room for guards, and
/// for guards of those:
/// `at_words!(words, |CAPACITY| code)`.
macro_rules! at_words {
    ($words:expr, |$capacity:ident| $code:expr) => {{
        let words: u32 = $words;
        $crate::float::words::with_words(words, || {
            if words < 18 {
                const $capacity: usize = 26;
                $code
            } else {
                const $capacity: usize = $crate::float::words::GREATEST;
                $code
            }
        })
    }};
}
pub(crate) use at_words;
