//! A value with its derivatives, which the search for a zero looks at.

/// A value and its first three derivatives.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Jet<F> {
    pub(crate) value: F,
    pub(crate) first: F,
    pub(crate) second: F,
    pub(crate) third: F,
}
