//! The reason why a calculation along the motion ended early, in one word of memory, and the budget of a search.

use crate::float::Float;
use crate::machine::error::Error;
use alloc::boxed::Box;
use core::ops::ControlFlow;

/// Why the calculation of a motion ended early: a boxed [`Error`], so that the result of every slide stays
/// small.
#[derive(Debug)]
pub(crate) struct Broken(Box<Error>);

impl From<Error> for Broken {
    #[cold]
    fn from(error: Error) -> Self {
        Self(Box::new(error))
    }
}

impl From<Broken> for Error {
    #[cold]
    fn from(Broken(error): Broken) -> Self {
        *error
    }
}

/// The budget of a search: the half turns propagated, counted over all attempts, and a function that says
/// whether to continue.
pub(crate) struct Budget<'a> {
    pub(crate) half_turns: u64,
    pub(crate) most: u64,
    keep_going: Option<&'a mut dyn FnMut() -> ControlFlow<()>>,
}

impl<'a> Budget<'a> {
    /// A budget of at most `most` half turns.
    pub(crate) fn of(most: u64) -> Self {
        Self { half_turns: 0, most, keep_going: None }
    }

    /// This budget with a function that is asked at every slide and stop whether to continue.
    pub(crate) fn while_allowed(self, keep_going: &'a mut dyn FnMut() -> ControlFlow<()>) -> Self {
        Self { keep_going: Some(keep_going), ..self }
    }

    /// Counts the half turns propagated.
    pub(crate) fn spend(&mut self, half_turns: u64) {
        self.half_turns = self.half_turns.saturating_add(half_turns);
    }

    /// The number of periods of the drive propagated.
    pub(crate) fn periods<F: Float>(&self) -> F {
        F::from_f64(self.half_turns as f64) / F::int(2)
    }

    /// Asks the caller whether to continue, at every slide and stop.
    ///
    /// # Errors
    /// [`Error::Interrupted`] where the caller breaks off.
    #[inline]
    pub(crate) fn ask(&mut self) -> Result<(), Broken> {
        let goes_on = self.keep_going.as_mut().is_none_or(|keep_going| keep_going().is_continue());
        if goes_on { Ok(()) } else { Err(Broken::from(Error::Interrupted)) }
    }
}
