//! The properties of a cycle of the motion: extrema, stops, work, and the paper's error measures.

use super::propagation::{HalfTurns, MotionPart, follow};
use crate::float::Float;
use crate::motion::broken::{Broken, Budget};
use crate::motion::drive_phase::DrivePhase;
use crate::motion::event::velocity_zero::VelocityZero;
use crate::motion::slide::Slide;
use crate::motion::slide::motion::Motion;
use crate::motion::slide::work::Works;
use crate::motion::state::PhasePoint;

/// An extreme value and its phase.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(bound(deserialize = "F: Float + serde::Deserialize<'de>")))]
#[non_exhaustive]
pub struct Extreme<F> {
    /// The value: x/B or x′/(Bω_d).
    pub value: F,
    /// The phase at which the value is first taken; [`DrivePhase::reduced`] gives it in [0, 2π).
    pub phase: DrivePhase<F>,
}

impl<F: Float> Extreme<F> {
    /// The extreme of the mirrored motion: the opposite sign, half a turn later.
    #[inline]
    pub(crate) fn mirrored(self) -> Self {
        Self { value: -self.value, phase: self.phase.later_by_half_turns(1) }
    }

    /// Takes the place of the maximum or the minimum that it exceeds.
    fn widens(self, max: &mut Self, min: &mut Self) {
        if self.value > max.value {
            *max = self;
        }
        if self.value < min.value {
            *min = self;
        }
    }
}

/// Extrema, stops and work over some time.
#[derive(Debug, Clone, Copy)]
pub(crate) struct CycleStatistics<F> {
    pub(crate) max_x: Extreme<F>,
    pub(crate) min_x: Extreme<F>,
    pub(crate) max_v: Extreme<F>,
    pub(crate) min_v: Extreme<F>,
    pub(crate) sticks: u32,
    pub(crate) zeros: u32,
    /// Time at rest, as a phase.
    pub(crate) rest: F,
    /// Work done by the drive, in r_y B.
    pub(crate) work_in: F,
    /// Work done against friction, ∫ |dx|, in r_y B.
    pub(crate) work_out: F,
    /// Work done against the damper, in r_y B.
    pub(crate) damper: F,
}

impl<F: Float> CycleStatistics<F> {
    /// The statistics of no time, at the point `start`.
    pub(crate) fn at(start: &PhasePoint<F>, omega: F) -> Self {
        let zero = F::int(0);
        let x = Extreme { value: start.x, phase: start.phase };
        let v = Extreme { value: start.w / omega, phase: start.phase };
        Self {
            max_x: x,
            min_x: x,
            max_v: v,
            min_v: v,
            sticks: 0,
            zeros: 0,
            rest: zero,
            work_in: zero,
            work_out: zero,
            damper: zero,
        }
    }

    /// The statistics of a symmetric cycle of two slides, from its maximum displacement and velocity, the works
    /// of the drive and of the damper, and the work against friction.
    #[inline]
    pub(crate) fn of_reversals(max_x: Extreme<F>, max_v: Extreme<F>, works: Works<F>, work_out: F) -> Self {
        Self {
            max_x,
            min_x: max_x.mirrored(),
            max_v,
            min_v: max_v.mirrored(),
            sticks: 0,
            zeros: 2,
            rest: F::int(0),
            work_in: works.drive,
            work_out,
            damper: works.damper,
        }
    }

    /// The statistics of one cycle of a motion that repeats after these half turns.
    ///
    /// Stops and velocity zeros are counted from a point in the middle of a slide. At a beginning in a stop
    /// the stop would be cut in two, and rounding would decide on which side of the beginning a velocity zero
    /// lies.
    ///
    /// # Errors
    /// As for [`follow`].
    pub(crate) fn of_cycle(half_turns: &HalfTurns<F>, budget: &mut Budget<'_>) -> Result<Self, Broken> {
        let HalfTurns { equation, start, m, .. } = *half_turns;
        let omega = equation.omega;
        let whole = |statistics: Self| if m.is_multiple_of(2) { statistics } else { statistics.doubled() };
        let mut statistics = Self::at(&start, omega);
        half_turns.each_part(budget, |part| statistics.add(part))?;
        let most = if statistics.max_v.value > -statistics.min_v.value {
            statistics.max_v.value
        } else {
            -statistics.min_v.value
        };
        let seam = seam(&start, most * omega, |visit| half_turns.each_part(budget, visit))?;
        let Some((seam, half)) = seam else { return Ok(whole(statistics)) };
        let mut statistics = Self::at(&seam, omega);
        follow(equation, seam, m, half, budget, |part| statistics.add(&part))?;
        Ok(whole(statistics))
    }

    /// Adds a part of the motion to the statistics.
    ///
    /// # Errors
    /// As for [`Slide::fastest`].
    pub(crate) fn add(&mut self, part: &MotionPart<F>) -> Result<(), Broken> {
        match part {
            MotionPart::Slide(slide, end) => {
                self.zeros = self.zeros.saturating_add(1);
                self.slide(slide, end.phi, end.phase, &slide.motion_at(end))
            }
            MotionPart::Onward(slide, phi, phase, end) => self.slide(slide, *phi, *phase, end),
            MotionPart::Stick(stick, length) => {
                self.sticks = self.sticks.saturating_add(1);
                self.rest = self.rest + *length;
                let damper = stick.equation.damper_work_at_rest(stick.start.reduced(), *length);
                self.work_in = self.work_in + damper;
                self.damper = self.damper + damper;
                Ok(())
            }
        }
    }

    fn slide(
        &mut self,
        slide: &Slide<F>,
        phi: F,
        phase: DrivePhase<F>,
        end: &Motion<F>,
    ) -> Result<(), Broken> {
        let omega = slide.equation.omega;
        Extreme { value: end.x, phase }.widens(&mut self.max_x, &mut self.min_x);
        let fastest = slide.fastest(phi, end)?;
        let v = fastest.w / omega;
        if v > self.max_v.value || v < self.min_v.value {
            let phase = slide.start.advanced(omega * fastest.phi);
            Extreme { value: v, phase }.widens(&mut self.max_v, &mut self.min_v);
        }
        self.work_out = self.work_out + (end.x - slide.x).abs();
        let works = slide.works(phi, end);
        self.work_in = self.work_in + works.drive;
        self.damper = self.damper + works.damper;
        Ok(())
    }

    /// The statistics of a whole turn from those of its first half, if the second half has the opposite sign.
    pub(crate) fn doubled(mut self) -> Self {
        let two = F::int(2);
        for extreme in [self.max_x.mirrored(), self.min_x.mirrored()] {
            extreme.widens(&mut self.max_x, &mut self.min_x);
        }
        for extreme in [self.max_v.mirrored(), self.min_v.mirrored()] {
            extreme.widens(&mut self.max_v, &mut self.min_v);
        }
        Self {
            sticks: self.sticks.saturating_mul(2),
            zeros: self.zeros.saturating_mul(2),
            rest: two * self.rest,
            work_in: two * self.work_in,
            work_out: two * self.work_out,
            damper: two * self.damper,
            ..self
        }
    }

    /// The paper's error measures of this cycle of `turns` turns.
    pub(crate) fn errors(&self, turns: u32) -> ErrorMeasures<F> {
        let half = F::from_f64(f64::from(turns)) * F::pi();
        let cycle = F::int(2) * half;
        let size = |max: F, min: F| (max + min).abs() / max;
        let shift = |max: DrivePhase<F>, min: DrivePhase<F>| (min.since(max).abs() - half) / cycle;
        ErrorMeasures {
            error_1: size(self.max_x.value, self.min_x.value),
            error_2: shift(self.max_x.phase, self.min_x.phase),
            error_3: size(self.max_v.value, self.min_v.value),
            error_4: shift(self.max_v.phase, self.min_v.phase),
        }
    }
}

/// A point in the middle of the longest slide, and its time from the slide's end, where a cycle begins at rest or nearly so:
/// slower than 1/1024 of its greatest speed |w|. `None` where it begins well within a slide, or has none. `each` passes
/// every part of the cycle on.
///
/// # Errors
/// Those of `each`.
#[inline]
pub(crate) fn seam<F: Float>(
    start: &PhasePoint<F>,
    greatest: F,
    each: impl FnOnce(&mut dyn FnMut(&MotionPart<F>) -> Result<(), Broken>) -> Result<(), Broken>,
) -> Result<Option<(PhasePoint<F>, F)>, Broken> {
    if start.w.abs() * F::int(1024) > greatest {
        return Ok(None);
    }
    let mut longest: Option<(Slide<F>, F)> = None;
    each(&mut |part| {
        if let MotionPart::Slide(slide, VelocityZero { phi, .. }) | MotionPart::Onward(slide, phi, ..) = part
            && longest.is_none_or(|(_, length)| *phi > length)
        {
            longest = Some((*slide, *phi));
        }
        Ok(())
    })?;
    Ok(longest.map(|(slide, length)| {
        let half = length / F::int(2);
        (slide.point(half), half)
    }))
}

/// The asymmetry of a cycle: the four error measures of Hong & Liu 2001, section 3.
///
/// ```text
/// Error 1 = |max x + min x|/max x        Error 2 = (|t₄ − t₂| − π/ω_d)/T
/// Error 3 = |max x′ + min x′|/max x′     Error 4 = (|t₃ − t₁| − π/ω_d)/T
/// ```
///
/// with t₂, t₄ the times of max x, min x and t₁, t₃ those of max x′, min x′ within the cycle, T = 2π/ω_d. All
/// are zero for a motion with `x(t + π/ω_d) = −x(t)`. For a cycle of several turns T is the length of the
/// cycle, and T/2 replaces π/ω_d.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct ErrorMeasures<F> {
    /// Asymmetry of the displacements.
    pub error_1: F,
    /// Asymmetry of the phases of the displacements.
    pub error_2: F,
    /// Asymmetry of the velocities.
    pub error_3: F,
    /// Asymmetry of the phases of the velocities.
    pub error_4: F,
}

#[cfg(test)]
mod tests {
    use super::{CycleStatistics, Extreme};
    use crate::motion::drive_phase::DrivePhase;
    use crate::motion::state::PhasePoint;

    fn phase(theta: f64) -> DrivePhase<f64> {
        DrivePhase::of(theta).unwrap()
    }

    #[test]
    fn error_measures_of_a_lopsided_cycle() {
        let start = PhasePoint { phase: phase(0.0), x: 0.0, w: 0.0 };
        let extreme = |value, theta| Extreme { value, phase: phase(theta) };
        let statistics = CycleStatistics {
            max_x: extreme(4.0, 1.0),
            min_x: extreme(-3.0, 1.0 + 1.5 * std::f64::consts::PI),
            max_v: extreme(2.0, 5.0),
            min_v: extreme(-2.5, 5.0 - std::f64::consts::PI),
            ..CycleStatistics::at(&start, 0.5)
        };
        let errors = statistics.errors(1);
        assert_eq!((errors.error_1, errors.error_3), (0.25, 0.25));
        assert!((errors.error_2 - 0.25).abs() < 1e-15 && errors.error_4.abs() < 1e-15, "{errors:?}");
    }

    #[test]
    fn a_tally_begins_at_the_start() {
        let statistics = CycleStatistics::at(&PhasePoint { phase: phase(0.3), x: 1.5, w: 2.0 }, 0.5);
        let (x, v) = (Extreme { value: 1.5, phase: phase(0.3) }, Extreme { value: 4.0, phase: phase(0.3) });
        assert_eq!((statistics.max_x, statistics.min_x, statistics.max_v, statistics.min_v), (x, x, v, v));
        assert_eq!(
            (statistics.sticks, statistics.zeros, statistics.work_in, statistics.work_out),
            (0, 0, 0.0, 0.0)
        );
    }
}
