//! Rows of one frequency ratio, whose quantities of Ω are computed once.

use super::amplitude::{Amplitude, Domain, has_loops};
use super::block::{AtPoint, Block, POINTS, select};
use super::low::LowOmega;
use super::stages::{HighParts, LowParts};
use super::velocity::Parts;
use crate::cycle::Border;
use crate::cycle::phase_function::{PhaseFunction, is_close_to_one};
use crate::float::pair::Pair;

/// The least number of points for which the quantities of Ω pay off.
const WORTH: usize = POINTS;

/// A frequency ratio with all quantities that depend on it alone, for many force ratios.
#[derive(Debug, Clone)]
pub(crate) struct FixedOmega {
    point: PointAt,
    omega: Block,
    of_omega: OfOmega,
}

/// The quantities of Ω that the loops use.
#[derive(Debug, Clone)]
pub(crate) enum OfOmega {
    /// Ω ≥ 1/2.
    High(Box<HighParts>),
    /// Ω < 1/2.
    Low(Box<LowParts>),
    /// No loop covers this Ω, and each point is computed by itself.
    None,
}

impl FixedOmega {
    /// The Ω of a slice long enough for this to pay off, if it is one number inside the domain of [`crate::Ratios`].
    pub(crate) fn of_all(omega: &[f64]) -> Option<Self> {
        let &first = omega.first()?;
        // A whole part at once, so that the bits are compared in lanes.
        let differs = |part: &[f64]| part.iter().fold(0, |bits, x| bits | (x.to_bits() ^ first.to_bits()));
        let is_one = omega.chunks(POINTS).all(|part| differs(part) == 0);
        if omega.len() >= WORTH && is_one { Self::new(first) } else { None }
    }

    /// At the frequency ratio Ω.
    fn new(omega: f64) -> Option<Self> {
        let p = PhaseFunction::new(omega).ok()?;
        let border = Border::new(omega).ok()?.min_force_ratio;
        let point =
            PointAt { omega, phase_function: p.wide(), one_minus_square: p.one_minus_square(), border };
        let of_omega = if has_loops(omega) {
            OfOmega::High(Box::new(Parts::new().at([omega]).map(|x| [x; POINTS])))
        } else if let [k, rest, inverse, sine, cosine, near] = LowOmega.at([omega])
            && !near.is_nan()
        {
            OfOmega::Low(Box::new([k, rest, inverse, sine, cosine, border].map(|x| [x; POINTS])))
        } else {
            // The points of this Ω are computed one by one, as in a batch.
            OfOmega::None
        };
        Some(Self { point, omega: [omega; POINTS], of_omega })
    }

    /// Ω.
    pub(crate) const fn omega(&self) -> f64 {
        self.point.omega
    }

    /// Whether there are loops over α for this Ω.
    pub(crate) const fn has_loops(&self) -> bool {
        !matches!(self.of_omega, OfOmega::None)
    }

    pub(crate) const fn of_omega(&self) -> &OfOmega {
        &self.of_omega
    }

    /// A block filled with Ω.
    pub(crate) const fn block(&self) -> &Block {
        &self.omega
    }
}

/// The quantities of Ω at one point.
#[derive(Debug, Clone, Copy)]
struct PointAt {
    omega: f64,
    phase_function: Pair<f64>,
    /// 1 − Ω².
    one_minus_square: Pair<f64>,
    border: f64,
}

/// `[Δ₀, α_min, A₁]` of a row.
#[derive(Clone, Copy)]
pub(crate) struct Row {
    point: PointAt,
    domain: Domain,
    /// The border, or NaN where the points of the row must be recomputed because Ω is too close to 1.
    border: f64,
}

impl Row {
    #[inline(always)]
    pub(crate) fn new(row: &FixedOmega) -> Self {
        let PointAt { omega, border, .. } = row.point;
        let border = select(is_close_to_one(omega), f64::NAN, border);
        Self { point: row.point, domain: Domain::new(), border }
    }
}

impl AtPoint<2, 3> for Row {
    #[inline(always)]
    fn at(&self, [_, alpha]: [f64; 2]) -> [f64; 3] {
        let PointAt { omega, phase_function, one_minus_square, .. } = self.point;
        let found = Amplitude::at(&self.domain, omega, alpha, phase_function, one_minus_square, self.border);
        [found.displacement(), found.border, found.size()]
    }
}
