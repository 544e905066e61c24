//! A cycle by its closed form validated as a motion, from one slide.
//!
//! The rising half of the cycle begins at its minimum displacement, `(−Δ₀, 0)` at `θ₂ − π`, and is one slide
//! of natural length `T = π/Ω`. On its way the slide passes the section, a point y; half a turn from y leads to
//! the velocity zero and back on the mirrored slide. The difference between the end of that half turn and −y
//! is a free vibration,
//!
//! ```text
//! H(y) − y = −R (δx, w w′₊/w′₋),     δx = x(T) − Δ₀,  w = w(T)
//! ```
//!
//! with w′₋ and w′₊ the accelerations before and after the reversal and R the free vibration from θ₂ − π to the
//! section: the residual that `shooting` judges, together with its bound on the distance. The sign of the
//! residual matters to neither. The velocity zero is within rounding of T, because friction reverses with the
//! velocity: `w′₋ = w′₊ − 2 < −2`.
//!
//! Without damping the section is the fastest point, at θ₁: the cycle proves that the maximum speed is there,
//! and the validation requires a zero acceleration. At the end the drive has turned by π, and the free angle,
//! `T = 2β`, is known from the cycle, so that neither needs a circular function. With damping the section is in
//! the middle, and the maximum speed is sought along the slide, because the closed form takes longer for it.
//!
//! # Why no velocity zero is missed
//!
//! The speed f has `f″ + 2ζf′ + f = g ∝ cos θ` (`event`). Let the half turn begin where g ≥ 0, at f = 0 with
//! f′ > 0, and let g change its sign at φ = b. Then f > 0 for `0 < φ ≤ min(b, π/d)`, d = √(1 − ζ²); also within
//! the cover of the later point b; and on the last stretch, if it is not longer than π/d, because f is positive
//! at its beginning, and zero only at its end. For Ω ≥ 1 the whole slide is shorter than π, and f(b) is not
//! needed. In every other case the search of `velocity_zero` answers.

use super::fixed_point::{Residual, is_known};
use super::matrix::{Matrix, freely, reversal_ratio};
use super::measures::{CycleStatistics, Extreme};
use super::steady::{SteadyParts, SteadyState};
use crate::cycle::Cycle;
use crate::float::Float;
use crate::motion::drive_phase::DrivePhase;
use crate::motion::event::cover::Cover;
use crate::motion::slide::equation::Equation;
use crate::motion::slide::motion::{Motion, SlideJet};
use crate::motion::slide::stick::force_rounding;
use crate::motion::slide::work::Works;
use crate::motion::slide::{Direction, Slide};
use crate::motion::state::PhasePoint;

/// The steady state of a cycle with a maximum displacement and its phase, if half a turn of the motion agrees with
/// it to within rounding. `cycle` is the cycle without damping.
///
/// # Errors
/// Otherwise the section, and the natural time from there to the maximum displacement.
#[inline(always)]
pub(crate) fn validated<F: Float>(
    equation: Equation<F>,
    (displacement, displacement_phase): (F, F),
    cycle: Option<&Cycle<F>>,
) -> Result<SteadyState<F>, (PhasePoint<F>, F)> {
    let (zero, two, pi) = (F::int(0), F::int(2), F::pi());
    let Equation { omega, damping, .. } = equation;
    let length = pi / omega;
    let origin = DrivePhase::of_half_turn(0, zero);
    let least = origin.advanced(displacement_phase).later_by_half_turns(-1);
    let slide = Slide::new(equation, least, -displacement, zero, Direction::Forward);
    let (section, before) = cycle.map_or((least.advanced(pi / two), length / two), |cycle| {
        let fastest = origin.advanced(cycle.velocity_phase);
        // Each phase is reduced to one turn.
        let lag = fastest.since(least);
        (fastest, if lag > pi { lag - two * pi } else { lag } / omega)
    });
    let middle = slide.motion(before);
    let y = PhasePoint { phase: section, x: middle.x, w: middle.w };
    let start = (y, length - before);
    let slides = slide.acceleration > equation.static_excess() + force_rounding(&equation, slide.x);
    let is_fastest = middle.acceleration.square() <= F::epsilon() * middle.w.square();
    if !(slides && middle.w > zero && (is_fastest || cycle.is_none()) && slide.turns_first_at(length)) {
        return Err(start);
    }

    // The motion at the end, and the free vibrations from the section to there.
    let (arrival, rest) = match cycle {
        Some(cycle) => {
            let arrival = slide.motion_of(&equation.half_turn(cycle.sin_cos_beta()));
            let ((s, c), (sine, cosine)) = (middle.rotation, arrival.rotation);
            (arrival, (sine * c - cosine * s, cosine * c + sine * s))
        }
        None => (slide.motion(length), middle.rotation),
    };
    let reversal = reversal_ratio(slide.acceleration);
    let off = (arrival.x + slide.x, arrival.w * reversal);
    let residual = Residual::new(&equation, &y, freely(off, middle.rotation, damping));
    let monodromy = Matrix::identity()
        .after_slide(rest, damping)
        .after_zero(reversal)
        .after_slide(middle.rotation, damping);
    let distance = monodromy.inverse_of_one_plus().absolute().times(residual.bounds());
    if !(residual.is_rounding(1) && is_known(&y, distance)) {
        return Err(start);
    }
    let max_v = if cycle.is_some() {
        Extreme { value: middle.w / omega, phase: section }
    } else {
        let fastest = slide.fastest(length, &arrival).map_err(|_| start)?;
        Extreme { value: fastest.w / omega, phase: least.advanced(omega * fastest.phi) }
    };
    let works = slide.works(length, &arrival);
    Ok(SteadyState::of(SteadyParts {
        equation,
        start: y,
        half_turns: 1,
        statistics: CycleStatistics::of_reversals(
            Extreme { value: arrival.x, phase: least.later_by_half_turns(1) },
            max_v,
            Works { drive: two * works.drive, damper: two * works.damper },
            two * (arrival.x - slide.x),
        ),
        multipliers: monodromy.squared_eigenvalues(),
        distance,
        periods: F::ratio(1, 2),
    }))
}

impl<F: Float> Slide<F> {
    /// Whether the velocity of a forward slide from rest has its first zero at `end`, half a turn later,
    /// where it is zero to within rounding.
    #[inline]
    fn turns_first_at(&self, end: F) -> bool {
        self.does_not_turn_before(end)
            || self
                .velocity_zero(end)
                .is_ok_and(|zero| !zero.grazes && (zero.phi - end).square() <= F::epsilon() * end.square())
    }

    /// Whether the signs of the drive's power alone show that no velocity zero precedes the zero at `end`.
    #[inline]
    fn does_not_turn_before(&self, end: F) -> bool {
        let cover = Cover::new(self.equation.vibration());
        let longest = cover.longest();
        let boundary = (F::pi() / F::int(2) - self.start.angle()) / self.equation.omega;
        if !self.start.is_even() || end - boundary > longest {
            return false;
        }
        if boundary <= longest {
            return true;
        }
        let Motion { w, acceleration, jerk, .. } = self.motion(boundary);
        let zero = F::int(0);
        let jet = SlideJet { value: w, first: acceleration, second: jerk, third: zero };
        w > zero && cover.reaches_back(jet, boundary - longest)
    }
}

#[cfg(test)]
mod tests;
