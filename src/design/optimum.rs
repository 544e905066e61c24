//! An optimum: its place, its value, and its kind.

/// The kind of an optimum.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
#[non_exhaustive]
pub enum OptimumKind {
    /// The derivative is zero there, inside the region where the body does not stick.
    Interior,
    /// On the border: on one side the body sticks, on the other it dissipates less.
    Border,
    /// An end of the given range.
    RangeEnd,
    /// Inside the region where the body sticks in every cycle, by the exact motion.
    Sticking,
}

/// An optimum among the cycles that do not stick.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[must_use]
#[non_exhaustive]
pub struct Optimum<F> {
    /// The argument: a force ratio, frequency ratio, friction bound or stiffness, as the function says.
    pub at: F,
    /// The largest value: the loop size A₁ or A₂ of a ratio, the energy of a cycle in physical units.
    pub value: F,
    /// The kind of optimum.
    pub kind: OptimumKind,
}

/// An optimum among all motions, with a bound on every other value.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[must_use]
#[non_exhaustive]
pub struct BoundedOptimum<F> {
    /// The argument, as of [`Optimum`].
    pub at: F,
    /// The largest value that was found.
    pub value: F,
    /// [`OptimumKind::Sticking`], or what it is among the motions that do not stick.
    pub kind: OptimumKind,
    /// An upper bound on the value at any argument, rounding included. It is proven if each exact motion is
    /// within its [`crate::exact::SteadyState::distance`] of the limit.
    pub bound: F,
    /// The optimum of those that do not stick.
    pub non_sticking: Optimum<F>,
    /// Exact motions that were computed.
    pub motions: u32,
}
