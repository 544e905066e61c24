//! Boxes of Ω, α and ζ.

use super::enclosure::{OmegaPiece, hull, pieces};
use super::{Evidence, Interval, Range, samples};
use crate::cycle::border::border_range;
#[cfg(not(feature = "mp"))]
use crate::cycle::regime::Regime;
use crate::cycle::regime::Verdict;
use crate::cycle::response::Response;
use crate::float::Float;
use crate::machine::error::Error;
use crate::machine::ratios::Ratios;
use crate::output::Output;

/// The greatest number of parts for a verdict with damping.
#[cfg(feature = "mp")]
pub(super) const VERDICT_PARTS: u32 = 1000;

/// Ω, α and ζ in intervals whose ends are in the domain of [`Ratios`].
#[derive(Debug, Clone, Copy)]
pub(super) struct RatioBox<F> {
    pub(super) omega: Interval<F>,
    pub(super) alpha: Interval<F>,
    pub(super) damping_ratio: Interval<F>,
}

impl<F: Float> RatioBox<F> {
    /// # Errors
    /// Where an interval is empty, or an end is outside the domain of [`Ratios`].
    pub(super) fn new(
        omega: Interval<F>,
        alpha: Interval<F>,
        damping_ratio: Interval<F>,
    ) -> Result<Self, Error> {
        for interval in [omega, alpha, damping_ratio] {
            interval.check()?;
        }
        Ratios::new(omega.low, alpha.low)?.with_damping_ratio(damping_ratio.low)?;
        Ratios::new(omega.high, alpha.high)?.with_damping_ratio(damping_ratio.high)?;
        Ok(Self { omega, alpha, damping_ratio })
    }

    fn is_damped(&self) -> bool {
        self.damping_ratio.high > F::int(0)
    }

    /// [`super::ParameterBox::verdict`].
    pub(super) fn verdict(&self) -> Result<Verdict<F>, Error> {
        if self.is_damped() {
            return self.damped_verdict();
        }
        let ends = |interval: Interval<F>| (interval.low, interval.high);
        Verdict::within(ends(self.omega), ends(self.alpha))
    }

    /// [`super::ParameterBox::range`].
    pub(super) fn range(&self, output: Output, points: u32) -> Result<Option<Range<F>>, Error> {
        match self.guaranteed(output, points)? {
            Some(range) => Ok(Some(range)),
            None => samples::range((points, if self.is_damped() { 3 } else { 2 }), |[o, a, z]: [F; 3]| {
                let ratios = Ratios::new(self.omega.at(o), self.alpha.at(a))?;
                Ok(output.of(&Response::new(ratios.with_damping_ratio(self.damping_ratio.at(z))?)))
            }),
        }
    }

    #[cfg(feature = "mp")]
    fn damped_verdict(&self) -> Result<Verdict<F>, Error> {
        self.enclosed_verdict(VERDICT_PARTS)
    }

    /// Without ball arithmetic nothing is proved about a damper, except that the body sticks below α = 1.
    #[cfg(not(feature = "mp"))]
    fn damped_verdict(&self) -> Result<Verdict<F>, Error> {
        let one = F::int(1);
        Ok(if self.alpha.high <= one {
            Verdict::AtRest
        } else if self.alpha.low <= one {
            Verdict::Undecided(Regime::Stuck, Regime::NonSticking)
        } else {
            Verdict::Undecided(Regime::Sticking, Regime::NonSticking)
        })
    }

    fn guaranteed(&self, output: Output, count: u32) -> Result<Option<Range<F>>, Error> {
        if self.is_damped() {
            return Ok(None);
        }
        let Self { omega, alpha, .. } = *self;
        let one = Interval::exactly(F::int(1));
        if output == Output::MinForceRatio {
            return self.border(|border| border, true).map(Some);
        }
        if output == Output::Margin {
            return self.border(|border| alpha.over(border), omega.is_exact()).map(Some);
        }
        if output == Output::BestForceRatio {
            return self.best_force_ratio();
        }
        if !output.is_of_cycle() || self.verdict()? != Verdict::NonSticking {
            return Ok(None);
        }
        let sharp = omega.is_exact();
        if output == Output::MaxVelocity && sharp {
            let ends = samples::range((0, 1), |[a]: [F; 1]| {
                Ok(output.of(&Response::new(Ratios::new(omega.low, alpha.at(a))?)))
            })?;
            let ends = ends.map(|range| Interval { low: range.low, high: range.high });
            return Ok(hull(ends.into_iter(), sharp));
        }
        // A₁ = 8 Δ₀/α², with the friction share ρ = 1/α: 8 ρ √(1 − K²ρ²)/|1 − Ω²|; A₂ = Ω² A₁.
        let loop_size = |piece: &OmegaPiece<F>| {
            let work = piece.work(one, one.over(alpha)).times(piece.resonance);
            Interval { low: F::int(8) * work.low, high: F::int(8) * work.high }
        };
        let bounds = |piece: &OmegaPiece<F>| {
            if output == Output::MaxDisplacement {
                Some(piece.root(alpha, one).times(piece.resonance))
            } else if output == Output::LoopSizeStiffness {
                Some(loop_size(piece))
            } else if output == Output::LoopSizeInertia {
                Some(loop_size(piece).times(piece.omega.times(piece.omega)))
            } else {
                None
            }
        };
        Ok(hull(pieces(omega, count).iter().filter_map(bounds), sharp))
    }

    /// A range that follows from the range of the border; without an upper bound where the box contains a
    /// pole.
    fn border(&self, f: impl Fn(Interval<F>) -> Interval<F>, sharp: bool) -> Result<Range<F>, Error> {
        let border = border_range(self.omega.low, self.omega.high)?;
        let infinite = F::int(1) / F::int(0);
        let border = Interval { low: border.least, high: border.greatest.unwrap_or(infinite) };
        let interval = f(border.outward(10)).outward(2);
        Ok(Range { low: interval.low, high: interval.high, evidence: Evidence::Guaranteed { sharp } })
    }

    /// √2 |K|, which is monotone on each piece; `None` where the box contains a pole.
    fn best_force_ratio(&self) -> Result<Option<Range<F>>, Error> {
        if border_range(self.omega.low, self.omega.high)?.greatest.is_none() {
            return Ok(None);
        }
        let best = |k_squared: F| (F::int(2) * k_squared).sqrt();
        let found = pieces(self.omega, 1);
        let each =
            found.iter().map(|p| Interval { low: best(p.k_squared.low), high: best(p.k_squared.high) });
        Ok(hull(each, true))
    }
}
