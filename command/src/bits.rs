//! `--bits`: the number type a command runs at.
//!
//! The unit tests of the command are compiled without its wide numbers, because these are copies of the whole
//! command, and tests/command runs them in the program.

use crate::failure::Outcome;
use num_traits::Pow;
use std::str::FromStr;
use stickslip::Float;

pub(crate) use stickslip_front::words::digits;

/// A number type that the command can read, write and space evenly.
pub(crate) trait Value: Float + FromStr + Pow<Self, Output = Self> + Send + Sync {}

impl<F: Float + FromStr + Pow<Self, Output = Self> + Send + Sync> Value for F {}

/// A computation for any number type; [`at_bits`] makes one from a function.
pub(crate) trait Task {
    fn run<F: Value>(self) -> Outcome;
}

/// Runs the task at f64, or with at least the requested bits.
pub(crate) fn run_at_bits(bits: Option<u32>, task: impl Task) -> Outcome {
    match bits {
        None => task.run::<f64>(),
        Some(bits) => run_wide(bits, task),
    }
}

/// `at_bits!(bits, function(arguments: &Arguments, out))`: the function, generic over a [`Value`], at f64, or with at
/// least the requested bits.
macro_rules! at_bits {
    ($bits:expr, $function:ident($arguments:ident: &$given:ty, $out:ident)) => {{
        struct Chosen<'a, W>(&'a $given, &'a mut W);

        impl<W: std::io::Write> $crate::bits::Task for Chosen<'_, W> {
            fn run<F: $crate::bits::Value>(self) -> $crate::failure::Outcome {
                $function::<F>(self.0, self.1)
            }
        }

        $crate::bits::run_at_bits($bits, Chosen($arguments, $out))
    }};
}
pub(crate) use at_bits;

#[cfg(all(feature = "mp", not(test)))]
fn run_wide(bits: u32, task: impl Task) -> Outcome {
    use std::fmt::{Debug, Display, LowerExp};
    use stickslip::float::{ParseError, WithPrecision, with_precision};

    struct Wide<T>(T);

    impl<T: Task> WithPrecision for Wide<T> {
        type Output = Outcome;

        fn run<F>(self) -> Outcome
        where
            F: Float
                + FromStr<Err = ParseError>
                + Pow<F, Output = F>
                + Display
                + LowerExp
                + Debug
                + Send
                + Sync
                + 'static,
        {
            self.0.run::<F>()
        }
    }

    with_precision(bits, Wide(task)).map_err(|e| format!("--bits {bits}: {e}"))?
}

#[cfg(any(not(feature = "mp"), test))]
fn run_wide(bits: u32, _: impl Task) -> Outcome {
    without_mp(bits)
}

/// Runs a computation over [`stickslip::float::Widest`] with at least the requested bits: one copy for all of them.
#[cfg(all(feature = "mp", not(test)))]
pub(crate) fn in_one_copy(bits: u32, computation: impl FnOnce() -> Outcome) -> Outcome {
    stickslip::float::with_bits(bits, computation).map_err(|e| format!("--bits {bits}: {e}"))?
}

/// The failure of `--bits` in a build without wide numbers.
#[cfg(any(not(feature = "mp"), test))]
pub(crate) fn without_mp(bits: u32) -> Outcome {
    Err(format!("--bits {bits}: must be ≤ 53 in a build without the feature mp").into())
}

/// The precision of this thread, for others that compute for it.
#[derive(Clone, Copy)]
pub(crate) struct Here {
    #[cfg(all(feature = "mp", not(test)))]
    precision: stickslip::float::ThreadPrecision,
}

impl Here {
    pub(crate) fn new() -> Self {
        Self {
            #[cfg(all(feature = "mp", not(test)))]
            precision: stickslip::float::ThreadPrecision::here(),
        }
    }

    /// Runs a computation with this precision on the thread that calls.
    pub(crate) fn run<T>(self, computation: impl FnOnce() -> T) -> T {
        #[cfg(all(feature = "mp", not(test)))]
        return self.precision.run(computation);
        #[cfg(not(all(feature = "mp", not(test))))]
        computation()
    }
}

/// All digits, with a power of ten where there would be many zeros.
pub(crate) fn all_digits<F: Value>(x: F) -> String {
    let size = x.to_f64().abs();
    if size == 0.0 || (1e-5..1e16).contains(&size) { x.to_string() } else { format!("{x:e}") }
}
