//! A band of frequency in which the body slides, and what ends it.

/// What ends a band.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum Edge {
    /// The border: beyond it the body sticks.
    Border,
    /// The end of the given range: the band continues.
    Range,
}

/// An interval of frequency ratios, or of angular frequencies, in which the body never sticks; its ends
/// belong to it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
#[must_use]
pub struct Band<F> {
    /// Lower end.
    pub low: F,
    /// Upper end.
    pub high: F,
    /// What bounds the lower end.
    pub low_edge: Edge,
    /// What bounds the upper end.
    pub high_edge: Edge,
    /// The number n of the lobe of the border, between the poles 1/(2n+3) and 1/(2n+1), that the band is in;
    /// with a damper that its lower end would be in without one. Only lobe 0 can contain Ω = 1, where the
    /// body never sticks but its motion grows without bound.
    pub lobe: u16,
}
