//! The parameters of a machine in intervals.

use super::enclosure::{OmegaPiece, hull, pieces};
#[cfg(feature = "mp")]
use super::ratios::VERDICT_PARTS;
use super::{Evidence, Interval, Range, RatioBox, samples};
use crate::cycle::regime::Verdict;
use crate::cycle::response::Response;
use crate::float::Float;
use crate::machine::error::Error;
use crate::machine::oscillator::{Drive, Excitation, Oscillator, Scales};
use crate::output::Output;

/// Mass, stiffness, friction force, amplitude and angular frequency in independent intervals, and a damper if
/// there is one ([`MachineBox::with_damping`]).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[must_use]
pub struct MachineBox<F> {
    mass: Interval<F>,
    stiffness: Interval<F>,
    friction_bound: Interval<F>,
    amplitude: Interval<F>,
    angular_frequency: Interval<F>,
    damping: Interval<F>,
    is_foot_motion: bool,
}

impl<F: Float> MachineBox<F> {
    /// A machine under a force: m, k, r_y, p₀, ω_d.
    ///
    /// # Errors
    /// Where an end of an interval is not finite or not > 0.
    pub fn force(
        mass: Interval<F>,
        stiffness: Interval<F>,
        friction_bound: Interval<F>,
        amplitude: Interval<F>,
        angular_frequency: Interval<F>,
    ) -> Result<Self, Error> {
        let damping = Interval::exactly(F::int(0));
        Self { mass, stiffness, friction_bound, amplitude, angular_frequency, damping, is_foot_motion: false }
            .checked()
    }

    /// A machine whose spring stands on a moving support, of amplitude u_g0: m, k, r_y, u_g0, ω_d. Its force
    /// has the amplitude k u_g0 ([`Excitation::FootMotion`]).
    ///
    /// # Errors
    /// As [`MachineBox::force`].
    pub fn foot_motion(
        mass: Interval<F>,
        stiffness: Interval<F>,
        friction_bound: Interval<F>,
        amplitude: Interval<F>,
        angular_frequency: Interval<F>,
    ) -> Result<Self, Error> {
        let damping = Interval::exactly(F::int(0));
        Self { mass, stiffness, friction_bound, amplitude, angular_frequency, damping, is_foot_motion: true }
            .checked()
    }

    /// This box with a viscous damper whose constant c lies in an interval.
    ///
    /// Ranges are then sampled ([`MachineBox::range`]) or, with the feature `mp`, proved
    /// (`MachineBox::enclosed`).
    ///
    /// # Errors
    /// Where an end is not finite or below 0.
    pub fn with_damping(self, damping: Interval<F>) -> Result<Self, Error> {
        Self { damping, ..self }.checked()
    }

    fn checked(self) -> Result<Self, Error> {
        for end in [F::int(0), F::int(1)] {
            self.machine_at([end; 6])?;
        }
        Ok(self)
    }

    /// The machine at a share of the way through each interval.
    fn machine_at(&self, [m, k, r, a, w, c]: [F; 6]) -> Result<(Oscillator<F>, Drive<F>), Error> {
        let body = Oscillator::new(self.mass.at(m), self.stiffness.at(k), self.friction_bound.at(r))?
            .with_damping(self.damping.at(c))?;
        let (amplitude, frequency) = (self.amplitude.at(a), self.angular_frequency.at(w));
        Ok((body, Drive::new(self.excitation(), amplitude, frequency)?))
    }

    /// A force, or the motion of the support.
    pub(super) const fn excitation(&self) -> Excitation {
        if self.is_foot_motion { Excitation::FootMotion } else { Excitation::Force }
    }

    /// m, k, r_y, the amplitude, ω_d and c.
    #[cfg(feature = "mp")]
    pub(super) fn parameters(&self) -> [Interval<F>; 6] {
        let Self { mass, stiffness, friction_bound, amplitude, angular_frequency, damping, .. } = *self;
        [mass, stiffness, friction_bound, amplitude, angular_frequency, damping]
    }

    #[cfg(feature = "mp")]
    pub(super) const fn is_foot_motion(&self) -> bool {
        self.is_foot_motion
    }

    /// The amplitude of the force for stiffnesses in an interval.
    fn force_at(&self, stiffness: Interval<F>) -> Interval<F> {
        if self.is_foot_motion { self.amplitude.times(stiffness) } else { self.amplitude }
    }

    /// The box of ratios that contains those of all machines of this box: Ω = ω_d √(m/k), α = p₀/r_y, ζ =
    /// c/(2√(km)), each monotone in each parameter.
    ///
    /// The ends of the box are attained. Under support motion and with a damper, k and m occur in more than one
    /// ratio, so that not all of the box is attained. The box is widened by the possible rounding of the
    /// quotients and the root.
    ///
    /// # Errors
    /// Where a ratio leaves the domain of [`crate::Ratios`].
    pub fn ratios(&self) -> Result<RatioBox<F>, Error> {
        let ratio = self.stiffness.over(self.mass);
        let natural = Interval { low: ratio.low.sqrt(), high: ratio.high.sqrt() };
        let omega = self.angular_frequency.over(natural);
        let alpha = self.force_at(self.stiffness).over(self.friction_bound);
        let wider = |i: Interval<F>| {
            let share = F::int(2) * F::epsilon();
            Interval { low: i.low - share * i.low, high: i.high + share * i.high }
        };
        let root = self.stiffness.times(self.mass);
        let critical = |square: F| F::int(2) * square.sqrt();
        let critical = Interval { low: critical(root.low), high: critical(root.high) };
        RatioBox::new(wider(omega), wider(alpha))?.with_damping_ratio(wider(self.damping.over(critical)))
    }

    /// The verdict that holds for the whole box; [`Verdict::sticks`] says whether the body sticks.
    ///
    /// Under support motion, a box that is only just decided may be called undecided ([`MachineBox::ratios`]). A damper
    /// needs the feature `mp`, as in [`RatioBox::verdict`], which also says what is proved and what is searched.
    ///
    /// ```
    /// # #[cfg(feature = "mp")] {
    /// use stickslip::Verdict;
    /// use stickslip::uncertainty::{Interval, MachineBox};
    /// let machine = |force| {
    ///     let friction = Interval::relative(5.0, 0.05)?;
    ///     let exactly = Interval::exactly;
    ///     let undamped = MachineBox::force(exactly(50.0), exactly(1000.0), friction, exactly(force), exactly(6.0))?;
    ///     undamped.with_damping(Interval::relative(20.0, 0.2)?)
    /// };
    /// assert_eq!(machine(12.0)?.verdict()?, Verdict::NonSticking);
    /// assert_eq!(machine(5.5)?.verdict()?, Verdict::Sticking);
    /// # }
    /// # Ok::<(), stickslip::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`MachineBox::ratios`] and [`RatioBox::verdict`].
    pub fn verdict(&self) -> Result<Verdict<F>, Error> {
        let ratios = self.ratios()?;
        #[cfg(feature = "mp")]
        if self.is_damped() {
            return self.enclosed_verdict(VERDICT_PARTS);
        }
        ratios.verdict()
    }

    /// The range of an output over the box, in physical units ([`Output::unit`]); `None` where the output
    /// exists at none of the points tried.
    ///
    /// The range is guaranteed for Δ₀, the energy of a cycle (both loop sizes), the minimum force and the
    /// margin (see the module's documentation). It is sampled for all other outputs, with a damper, and for
    /// outputs of the cycle where the body may stick. `points` is the number of points or of pieces.
    ///
    /// # Errors
    /// As for [`MachineBox::ratios`], and where a scale overflows or underflows.
    pub fn range(&self, output: Output, points: u32) -> Result<Option<Range<F>>, Error> {
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
        let (body, drive) = self.machine_at(shares)?;
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
        let found = pieces(ratios.omega(), count);
        let bounds = found.iter().filter_map(|piece| {
            let stiffness = self.stiffness_in(piece)?;
            let force = self.force_at(stiffness);
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
