//! What is not certain, and when.

/// What is not certain, and of which element.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Doubt {
    pub(super) element: Option<usize>,
    pub(super) reason: &'static str,
}

impl Doubt {
    pub(super) const fn of(element: Option<usize>, reason: &'static str) -> Self {
        Self { element, reason }
    }
}

/// Why a motion in balls ends early, and when.
#[derive(Debug)]
pub(super) enum Failure {
    Doubt(Doubt, f64),
    TooLong(f64),
    Interrupted,
}
