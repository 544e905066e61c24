//! Bands of frequency in which the body slides, and the kinds of their ends.

/// The kind of an end of a band.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum Edge {
    /// The border: beyond it the body sticks.
    Border,
    /// The end of the given range: the band continues.
    Range,
}

impl Edge {
    /// This end: the end of the range, or the frequency at which the border is.
    pub(super) fn place<F>(self, range: F, border: F) -> F {
        match self {
            Self::Range => range,
            Self::Border => border,
        }
    }
}

/// An interval of frequency ratios, or of angular frequencies, in which the body never sticks, with its ends
/// included.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
#[must_use]
pub struct Band<F> {
    /// Lower end.
    pub low: F,
    /// Upper end.
    pub high: F,
    /// The kind of the lower end.
    pub low_edge: Edge,
    /// The kind of the upper end.
    pub high_edge: Edge,
    /// The number n of the border's lobe that contains the band, between the poles 1/(2n+3) and 1/(2n+1).
    /// With a damper this is the lobe of the undamped border that contains the band's lower end. Only lobe 0
    /// can contain Ω = 1, where without a damper the body never sticks but its motion grows without bound.
    pub lobe: u16,
    /// The number of reversals in a cycle: 2, or 6 near the pole 1/(2n+1), of which the band has the number n.
    pub reversals_per_cycle: u32,
}
