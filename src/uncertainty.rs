//! Parameters that are known to lie in intervals, or by their distributions, and the resulting ranges of the
//! outputs.
//!
//! | file | content |
//! |---|---|
//! | `parameters` | the machine by named values, the box of ratios or of machines |
//! | `ratios`, `machine` | the answers about each |
//! | `enclosure` | guaranteed ranges of the displacement and the energy |
//! | `enclosed` | ranges of any output in ball arithmetic (feature `mp`) |
//! | `samples` | points of a box, for outputs that are not known to be monotone |
//! | `random` | Monte-Carlo over distributions (feature `random`) |
//!
//! # Which start
//!
//! The results hold for every start: a box has no static friction above the kinetic one, and the limit is
//! therefore unique. At Ω = 1/(2n) each start leads to a member of a family, none of which sticks.
//!
//! # What is guaranteed, and why
//!
//! Let the body not stick anywhere in the box. Then, with `Δ₀/B = √(α² − K²)/|1 − Ω²|` and the border
//! α_min(Ω):
//!
//! | output | monotone in | so that its range is |
//! |---|---|---|
//! | α_min | neither: one minimum in each lobe | known exactly (one minimum in each lobe), sticking or not |
//! | α/α_min | α | enclosed by the ends of α and of α_min, sticking or not |
//! | Δ₀ | α (rising); physical: p₀ (rising), r_y (falling) | enclosed over pieces of Ω, see below |
//! | 4 r_y Δ₀ | p₀ (rising); in r_y one maximum, r_y = p₀/(√2 \|K\|) | enclosed likewise |
//! | V₀ | Δ₀/B, hence α (rising) | exact for one Ω; sampled over an interval of them |
//! | K², hence α* = √2 \|K\| | Ω: falling from 1/(2n+1) to 1/(2n), rising from there to 1/(2n−1); for n = 1 to ∞ | exact |
//!
//! K² increases for Ω > 1/2 because κ(v) of `src/cycle/border/lobe.rs` decreases with v = 1/Ω². Below
//! 1/2 it is monotone because T is, within each half lobe, and `|T′/T| ≥ π` outweighs the other terms
//! (ibid.). V₀ increases with Δ₀ because ∂V₀/∂(Δ₀/B) = cos Ωψ at its maximum, which is not negative.
//! **Pieces:** between two neighbouring zeros or poles of K both `K²` and `|1 − Ω²|` are monotone in Ω. Their
//! values at the ends of a piece therefore bound them within, and the bounds of all pieces together bound the
//! output. These bounds are not sharp: they exceed the range by an amount that decreases like 1/pieces.
//!
//! All other outputs (phases, Δ₁, contraction, …) are not known to be monotone. Their ranges are **sampled**
//! at every corner of the box and at points spread over it. A sampled range lies inside the true one, and is
//! marked as sampled.
//!
//! # Rounding
//!
//! A guaranteed range holds for the exact values: it is widened at both ends by more than the formulae can
//! lose to rounding. Sums, products, quotients and roots lose half a unit in the last place each, by IEEE
//! 754. K(Ω) and the border count as accurate to 2 and 8 units. K² then has a margin of 10 units, 1/|1 − Ω²|
//! of 4 for three roundings, the border of 10, and values computed from them of 8 more. The 2 and the 8 are
//! measured bounds: with the feature `mp` a test compares the ranges with enclosures at 10⁵ points.
//! `ParameterBox::enclosed` (feature `mp`) rests on no measured bound: it computes the range of any output in balls,
//! with damping too.
//!
//! ```
//! use stickslip::uncertainty::{Interval, ParameterBox, Parameters};
//! use stickslip::{Excitation, Output};
//! // Friction known to ±20 %, the stiffness to ±2 %.
//! let machine = ParameterBox::Machine(Parameters {
//!     excitation: Excitation::Force,
//!     mass: Interval::exactly(50.0),
//!     stiffness: Interval::relative(1000.0, 0.02),
//!     friction_bound: Interval::relative(5.0, 0.2),
//!     amplitude: Interval::exactly(12.0),
//!     angular_frequency: Interval::exactly(6.0),
//!     damping: Interval::exactly(0.0),
//! });
//! assert_eq!(machine.verdict()?.sticks(), Some(false));
//! let stroke = machine.range(Output::MaxDisplacement, 1000)?.unwrap();
//! assert!(stroke.is_guaranteed() && 0.0102 < stroke.low && stroke.high < 0.0138);
//! # Ok::<(), stickslip::Error>(())
//! ```

#[cfg(feature = "mp")]
#[cfg_attr(not(test), allow(clippy::arithmetic_side_effects, reason = "operators of rational numbers"))]
mod enclosed;
mod enclosure;
mod estimate;
mod machine;
mod parameters;
#[cfg(feature = "random")]
mod random;
mod ratios;
mod samples;

pub use estimate::Estimate;

#[cfg(feature = "identify")]
pub(crate) use estimate::{student, student_95};
pub use parameters::{ParameterBox, Parameters};
#[cfg(feature = "random")]
pub use random::MonteCarlo;

use crate::float::Float;
use crate::machine::error::{Error, written};

/// The knowledge of a parameter: it lies between two numbers, inclusive.
///
/// The ends are checked where the interval is used: `low ≤ high`, and both valid for the parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[must_use]
pub struct Interval<F> {
    /// The lower end.
    pub low: F,
    /// The upper end.
    pub high: F,
}

impl<F: Float> Interval<F> {
    /// A parameter that is known exactly.
    pub const fn exactly(x: F) -> Self {
        Self { low: x, high: x }
    }

    /// `x (1 ± share)`, x and the share positive.
    pub fn relative(x: F, share: F) -> Self {
        Self::absolute(x, x * share)
    }

    /// `x ± off`, off positive.
    pub fn absolute(x: F, off: F) -> Self {
        Self { low: x - off, high: x + off }
    }

    /// An error unless the ends are in order.
    fn check(&self) -> Result<(), Error> {
        let Self { low, high } = *self;
        let empty = || Error::EmptyInterval { low: written(low), high: written(high) };
        if low <= high { Ok(()) } else { Err(empty()) }
    }

    /// Whether the interval is a single number.
    pub(crate) fn is_exact(&self) -> bool {
        self.low == self.high
    }

    /// The point a share of the way from the lower end to the upper.
    fn at(&self, share: F) -> F {
        if share == F::int(1) { self.high } else { self.low + (self.high - self.low) * share }
    }
}

/// How a range was obtained.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
#[non_exhaustive]
pub enum Evidence {
    /// No parameters in the box give a value outside this range.
    Guaranteed {
        /// Whether both ends are values attained in the box, except for the margin for rounding.
        sharp: bool,
    },
    /// The least and the greatest value found at some points: the range is at least that wide.
    Sampled {
        /// The number of points tried.
        points: u32,
        /// The number of points at which the output exists because the body does not stick there.
        existing: u32,
    },
}

/// The range of an output.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
#[must_use]
pub struct Range<F> {
    /// Its lower end.
    pub low: F,
    /// Its upper end; infinite where the output is not bounded in the box.
    pub high: F,
    /// How the range was obtained.
    pub evidence: Evidence,
}

impl<F: Float> Range<F> {
    /// Whether the range holds for all parameters of the box.
    pub const fn is_guaranteed(&self) -> bool {
        matches!(self.evidence, Evidence::Guaranteed { .. })
    }
}

#[cfg(test)]
mod tests {
    use super::{Evidence, Interval, Range};
    use crate::{Ratios, Verdict};

    #[test]
    fn intervals() {
        let valid = |found: Interval<f64>| found.check().map(|()| (found.low, found.high));
        assert_eq!(valid(Interval { low: 1.0, high: 3.0 }), Ok((1.0, 3.0)));
        assert_eq!(valid(Interval::exactly(1.0)), Ok((1.0, 1.0)));
        assert_eq!(valid(Interval::relative(4.0, 0.25)), Ok((3.0, 5.0)));
        assert_eq!(valid(Interval::absolute(4.0, 0.5)), Ok((3.5, 4.5)));
        let text = |found: Interval<f64>| found.check().unwrap_err().to_string();
        assert_eq!(text(Interval { low: 3.0, high: 1.0 }), "interval: 3 must be ≤ 1");
        assert_eq!(text(Interval::absolute(4.0, -0.5)), "interval: 4.5 must be ≤ 3.5");
        assert!(valid(Interval { low: f64::NAN, high: 1.0 }).is_err());
        assert!(valid(Interval::relative(4.0, -0.5)).is_err());
        let wide = Interval { low: 1.0, high: 3.0 };
        assert!(Interval::exactly(2.0).is_exact() && !wide.is_exact());
        assert_eq!([0.0, 0.25, 1.0].map(|share| wide.at(share)), [1.0, 1.5, 3.0]);
    }

    #[test]
    fn what_is_known() {
        let range = |evidence| Range { low: 1.0, high: 2.0, evidence };
        assert!(range(Evidence::Guaranteed { sharp: false }).is_guaranteed());
        assert!(!range(Evidence::Sampled { points: 3, existing: 3 }).is_guaranteed());
        for (omega, alpha, sticking) in [
            (0.7, 0.9, Some(true)),
            (0.7, 1.2, Some(true)),
            (0.7, 2.0, Some(false)),
            (0.5, 9.0, Some(false)),
            (1.0, 2.0, Some(false)),
        ] {
            let verdict = Verdict::new(Ratios::new(omega, alpha).unwrap());
            assert_eq!(verdict.sticks(), sticking, "{omega} {alpha}");
        }
    }
}
