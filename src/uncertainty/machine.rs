//! The parameters of a machine in intervals.

use super::enclosure::{OmegaPiece, hull, pieces};
use super::ratios::RatioBox;
#[cfg(feature = "mp")]
use super::ratios::VERDICT_PARTS;
use super::{Evidence, Interval, Parameters, Range, samples};
use crate::cycle::regime::Verdict;
use crate::cycle::response::Response;
use crate::float::Float;
use crate::machine::error::Error;
use crate::machine::oscillator::{Excitation, Scales};
use crate::output::Output;

impl<F: Float> Parameters<Interval<F>> {
    /// This box, if its ends are valid.
    pub(super) fn checked(self) -> Result<Self, Error> {
        for interval in self.intervals() {
            interval.check()?;
        }
        for end in [F::int(0), F::int(1)] {
            self.at([end; 6]).machine()?;
        }
        Ok(self)
    }

    /// m, k, r_y, the amplitude, ω_d and c.
    pub(super) fn intervals(&self) -> [Interval<F>; 6] {
        let Self { excitation: _, mass, stiffness, friction_bound, amplitude, angular_frequency, damping } =
            *self;
        [mass, stiffness, friction_bound, amplitude, angular_frequency, damping]
    }

    /// The parameters at a share of the way through each interval.
    fn at(&self, shares: [F; 6]) -> Parameters<F> {
        let mut places = self.intervals().into_iter().zip(shares).map(|(interval, share)| interval.at(share));
        let [mass, stiffness, friction_bound, amplitude, angular_frequency, damping] =
            core::array::from_fn(|_| places.next().unwrap_or(F::int(0)));
        let excitation = self.excitation;
        Parameters { excitation, mass, stiffness, friction_bound, amplitude, angular_frequency, damping }
    }

    /// The amplitude of the force.
    fn force(&self) -> Interval<F> {
        let at = |end: fn(Interval<F>) -> F| {
            let [mass, stiffness, _, amplitude, frequency, damping] = self.intervals().map(end);
            self.excitation.force_amplitude(amplitude, frequency, [mass, stiffness, damping])
        };
        let force = Interval { low: at(|x| x.low), high: at(|x| x.high) };
        // The margins of α and Δ₀ include one rounding of the force.
        let is_product = matches!(self.excitation, Excitation::Force | Excitation::FootMotion);
        if is_product { force } else { force.outward(2) }
    }

    /// [`super::ParameterBox::ratios`].
    pub(super) fn ratios(&self) -> Result<RatioBox<F>, Error> {
        let ratio = self.stiffness.over(self.mass);
        let natural = Interval { low: ratio.low.sqrt(), high: ratio.high.sqrt() };
        let omega = self.angular_frequency.over(natural);
        let alpha = self.force().over(self.friction_bound);
        let wider = |i: Interval<F>| {
            let share = F::int(2) * F::epsilon();
            Interval { low: i.low - share * i.low, high: i.high + share * i.high }
        };
        let root = self.stiffness.times(self.mass);
        let critical = |square: F| F::int(2) * square.sqrt();
        let critical = Interval { low: critical(root.low), high: critical(root.high) };
        RatioBox::new(wider(omega), wider(alpha), wider(self.damping.over(critical)))
    }

    /// [`super::ParameterBox::verdict`].
    pub(super) fn verdict(&self) -> Result<Verdict<F>, Error> {
        let ratios = self.ratios()?;
        #[cfg(feature = "mp")]
        if self.is_damped() {
            return self.enclosed_verdict(VERDICT_PARTS);
        }
        ratios.verdict()
    }

    /// [`super::ParameterBox::range`].
    pub(super) fn range(&self, output: Output, points: u32) -> Result<Option<Range<F>>, Error> {
        match self.guaranteed(output, points)? {
            Some(range) => Ok(Some(range)),
            None => {
                let varied = if self.is_damped() { 6 } else { 5 };
                samples::range((points, varied), |shares| self.value(output, shares))
            }
        }
    }

    /// An output at a share of the way through each interval.
    fn value(&self, output: Output, shares: [F; 6]) -> Result<Option<F>, Error> {
        let (body, drive) = self.at(shares).machine()?;
        let response = Response::new(drive.ratios(&body)?);
        let unit = output.unit(&Scales::new(&body, &drive)?);
        Ok(output.of(&response).map(|y| y * unit))
    }

    fn is_damped(&self) -> bool {
        self.damping.high > F::int(0)
    }

    fn guaranteed(&self, output: Output, count: u32) -> Result<Option<Range<F>>, Error> {
        if self.is_damped() {
            return Ok(None);
        }
        let ratios = self.ratios()?;
        if output == Output::MinForceRatio {
            // Ω does not depend on r_y, so that the two factors are independent.
            let border = ratios.range(output, count)?;
            return Ok(border.map(|border| {
                let ends = Interval { low: border.low, high: border.high };
                let force = ends.times(self.friction_bound);
                Range { low: force.low, high: force.high, ..border }
            }));
        }
        if output == Output::Margin {
            let range = ratios.range(output, count)?;
            return Ok(range.map(|range| Range { evidence: Evidence::Guaranteed { sharp: false }, ..range }));
        }
        let is_work = matches!(output, Output::LoopSizeStiffness | Output::LoopSizeInertia);
        if !(is_work || output == Output::MaxDisplacement) || ratios.verdict()? != Verdict::NonSticking {
            return Ok(None);
        }
        let found = pieces(ratios.omega, count);
        let bounds = found.iter().filter_map(|piece| {
            let stiffness = self.stiffness_in(piece)?;
            let force = Self { stiffness, ..*self }.force();
            // Δ₀ = √(p₀² − K² r_y²)/(k |1 − Ω²|), and 4 r_y Δ₀
            let root = if is_work {
                let work = piece.work(force, self.friction_bound);
                Interval { low: F::int(4) * work.low, high: F::int(4) * work.high }
            } else {
                piece.root(force, self.friction_bound)
            };
            Some(root.times(piece.resonance).over(stiffness))
        });
        Ok(hull(bounds, false))
    }

    /// The stiffnesses for which the frequency ratio can lie in a piece, `k = m ω_d²/Ω²`; `None` where there
    /// are none.
    fn stiffness_in(&self, piece: &OmegaPiece<F>) -> Option<Interval<F>> {
        let squared = |i: Interval<F>| i.times(i);
        let reachable = self.mass.times(squared(self.angular_frequency)).over(squared(piece.omega));
        // A margin larger than rounding.
        let share = F::int(16) * F::epsilon();
        let low = self.stiffness.low.or_larger(reachable.low - share * reachable.low);
        let high = reachable.high + share * reachable.high;
        let high = if high < self.stiffness.high { high } else { self.stiffness.high };
        (low <= high).then_some(Interval { low, high })
    }
}
