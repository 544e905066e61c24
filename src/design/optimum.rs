//! An optimum: its place, its value, and its kind.

/// The kind of an optimum.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
#[non_exhaustive]
pub enum OptimumKind {
    /// The derivative is zero, inside the region where the body does not stick.
    Interior,
    /// On the border: on one side of it the body sticks, on the other the cycle dissipates less.
    Border,
    /// An end of the given range.
    RangeEnd,
    /// Inside the region where the body sticks in every cycle, by the exact motion.
    Sticking,
}

/// An optimum among the cycles that do not stick.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[must_use]
#[non_exhaustive]
pub struct Optimum<F> {
    /// The argument: a force ratio, frequency ratio, friction force or stiffness, depending on the function.
    pub at: F,
    /// The largest value: the loop size A₁ or A₂ for a ratio, the energy of a cycle in physical units.
    pub value: F,
    /// The kind of optimum.
    pub kind: OptimumKind,
}

/// An optimum among all motions, with a bound on every other value.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[must_use]
#[non_exhaustive]
pub struct BoundedOptimum<F> {
    /// The argument, as in [`Optimum`].
    pub at: F,
    /// The largest value that was found.
    pub value: F,
    /// [`OptimumKind::Sticking`], or the kind among the motions that do not stick.
    pub kind: OptimumKind,
    /// An upper bound on the value at any argument, rounding included. It is proven if each exact motion is
    /// within its [`crate::motion::SteadyState::distance`] of the limit.
    pub bound: F,
    /// The optimum among the motions that do not stick.
    pub non_sticking: Optimum<F>,
    /// The number of exact motions computed.
    pub motions: u32,
}
