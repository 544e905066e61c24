//! The periodic motion with stops, by the map from stop to stop (`stop_map`).
//!
//! The limit is the same from every start (`shooting`), and no start needs to be followed. The fixed point of
//! G is sought among all displacements at which a body can rest and be released, `−(1 + α) < x < α − 1` for a
//! release forward.
//!
//! **G(x) − x never increases.** Two bodies at rest at x and y under the same drive, and again half a turn
//! later, have not moved apart (`shooting`): `|G(x) − G(y)| ≤ |x − y|`. The signs found therefore bracket a
//! zero. Within the bracket the zero of the cubic through the last two points, with their slopes G′ − 1, is
//! tried next; this converges with the order 1 + √3. If it does not halve the residual, the bracket is
//! halved. Only passages that can be the last need a proof (`event`); the others end at their predicted
//! times. Stops that do not overlap in time can break the bracket: this costs a search, but never gives a
//! wrong answer.
//!
//! The result is judged as in `shooting`, by the residual of half a turn and its rounding. If there are no
//! such stops half a turn apart, this search has no answer, and `shooting` must find the motion.

use super::fixed_point::{Residual, is_known};
use super::long_run::LongRun;
use super::measures::CycleStatistics;
use super::propagation::MotionPart;
use super::slight;
use super::steady::{SteadyParts, SteadyState};
use super::stop_map::{Expected, Passage, Station, passage};
use crate::cycle::damped::border::is_far_below;
use crate::cycle::damped::half_period::HalfPeriod;
use crate::cycle::damped::rising::Rising;
use crate::cycle::damped::{at_turning_point, border};
use crate::cycle::displacement::max_displacement;
use crate::cycle::phase_function::{PhaseFunction, one_minus_square};
use crate::float::{Float, fused};
use crate::motion::broken::{Broken, Budget};
use crate::motion::limit::stop_map::Miss;
use crate::motion::slide::Direction;
use crate::motion::slide::equation::Equation;
use crate::motion::slide::stick::Stick;
use crate::motion::state::PhasePoint;
use alloc::vec::Vec;

/// The search uses stops that are released forward, around θ = 0.
const STATION: Station = Station { half_turn: 0, direction: Direction::Forward };

/// The greatest number of passages that the search tries.
const MOST_PASSAGES: u32 = 40;

/// Prediction of the closed form without stops for a motion that may stick, α > 1 and η = 1.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sticking<F> {
    equation: Equation<F>,
    /// `a = √(α² − K²)/q`; NaN where α < |K|, infinite at Ω = 1.
    amplitude: F,
    /// The shift G by which friction reduces the extremum to a − G.
    shift: F,
    /// Whether the motion is known to stick, or to reverse more than twice: with damping from the border,
    /// without damping only where the body would stop at its turning points by more than rounding.
    pub(crate) is_below: bool,
    /// With damping, the rising half of the cycle without stops, from its border on: it is the limit of every
    /// start.
    pub(crate) rising: Option<Rising<F>>,
}

impl<F: Float> Sticking<F> {
    #[inline]
    pub(crate) fn new(equation: Equation<F>) -> Self {
        if equation.is_damped() {
            Self::damped(equation)
        } else {
            fused!(<F>(equation: Equation<F>) -> Sticking<F> { Sticking::undamped(equation) })
        }
    }

    #[inline(always)]
    fn undamped(equation: Equation<F>) -> Self {
        let Equation { omega, alpha, .. } = equation;
        let k = PhaseFunction::of_valid(omega).value();
        let amplitude = max_displacement(k, alpha, one_minus_square(omega));
        let is_below = amplitude * omega.square() < F::ratio(15, 16) || !amplitude.is_finite();
        Self { equation, amplitude, shift: F::int(0), is_below, rising: None }
    }

    #[cold]
    #[inline(never)]
    fn damped(equation: Equation<F>) -> Self {
        let Equation { omega, alpha, .. } = equation;
        let half = HalfPeriod::new(omega, equation.zeta());
        let rising = Rising::of_force(half, alpha);
        // A force below the condition at the turning point, or far above the border, needs no search for the
        // border.
        let slides = alpha >= at_turning_point(&half).0
            && (is_far_below(&half, rising.amplitude) || alpha >= border(&half).min_force_ratio);
        Self {
            equation,
            amplitude: max_displacement(half.k, alpha, half.stiffness),
            shift: half.shift,
            is_below: !slides,
            rising: slides.then_some(rising),
        }
    }

    /// The limit, if it has stops half a turn apart and the search finds them.
    ///
    /// # Errors
    /// As for [`passage`].
    pub(crate) fn limit(&self, budget: &mut Budget<'_>) -> Result<Option<LongRun<F>>, Broken> {
        let equation = self.equation;
        let found = fixed_point(equation, self.guess(), self.other_guesses(), budget)?;
        match found.map_or(Ok(None), |passage| steady(equation, &passage, budget))? {
            Some(limit) => Ok(Some(limit)),
            None => slight::limit(equation, STATION, budget),
        }
    }

    /// The minimum displacement by the closed form, as if the motion did not stick; without a closed form,
    /// the position at which a slow drive would leave the body.
    fn guess(&self) -> F {
        let (one, alpha) = (F::int(1), self.equation.alpha);
        let (by_cycle, slow) = (self.shift - self.amplitude, one - alpha);
        if by_cycle > -(one + alpha) && by_cycle < slow { by_cycle } else { slow }
    }

    /// The positions to try if there is no stop at the first guess. One is where the spring
    /// balances the drive's amplitude, beyond which a body stops after a slide of a whole free period. The
    /// other is the minimum of the closed form, where a fast drive leaves the body.
    fn other_guesses(&self) -> [Option<F>; 2] {
        let alpha = self.equation.alpha;
        let by_cycle = self.shift - self.amplitude;
        [Some(-alpha), (by_cycle > F::int(1) - alpha).then_some(by_cycle)]
    }
}

/// The passage that starts at the fixed point of G.
fn fixed_point<F: Float>(
    equation: Equation<F>,
    guess: F,
    others: [Option<F>; 2],
    budget: &mut Budget<'_>,
) -> Result<Option<Passage<F>>, Broken> {
    let (zero, one, two) = (F::int(0), F::int(1), F::int(2));
    let (mut low, mut high) = (-(one + equation.alpha), equation.alpha - one);
    let mut x = guess;
    let mut best: Option<Passage<F>> = None;
    let mut before: Option<Miss<F>> = None;
    let mut spare = Vec::with_capacity(8);
    let mut is_proved = true;
    let mut failures = 0..MOST_FAILURES;
    let mut others = others.into_iter().flatten();
    for _ in 0..MOST_PASSAGES {
        if budget.half_turns > budget.most {
            break;
        }
        let expected = Expected { by: best.as_ref(), is_proved };
        let Some(tried) = passage(equation, STATION, x, expected, spare, budget)? else {
            // There is no such stop at this displacement: the next one is closer to the last stop, or at
            // another guess.
            let Some(last) = &best else {
                let Some(other) = others.next() else { break };
                (x, spare) = (other, Vec::new());
                continue;
            };
            if failures.next().is_none() {
                break;
            }
            if x > last.from {
                high = x;
            } else {
                low = x;
            }
            x = (x + last.from) / two;
            spare = Vec::new();
            is_proved = true;
            continue;
        };
        if tried.left.is_rounding(1) {
            if tried.is_proved {
                return Ok(Some(tried));
            }
            // The passage is computed once more, with proofs.
            spare = best.replace(tried).map_or_else(Vec::new, |passage| passage.parts);
            is_proved = true;
            continue;
        }
        let here = Miss { x, value: tried.left.x, slope: tried.rate - one };
        if here.value > zero {
            low = x;
        } else {
            high = x;
        }
        // The cubic does not apply where the number of slides differs.
        if best.as_ref().is_some_and(|last| last.parts.len() != tried.parts.len()) {
            before = None;
        }
        let halves =
            before.is_none() || best.as_ref().is_none_or(|last| here.value.abs() * two <= last.left.x.abs());
        let next = x + here.step(before);
        x = if halves && next > low && next < high { next } else { (low + high) / two };
        let is_closed = x <= low || x >= high;
        before = Some(here);
        // With a residual above ε^¼ the next passage is not the last one, and with one above ε^⅓ it rarely
        // is.
        let share = (here.value / (one + x.abs())).abs();
        is_proved = share * share.square() <= F::epsilon();
        let last = best.replace(tried);
        if is_closed {
            // The residual is rounding, slightly more than expected.
            let nearest = last.filter(|last| last.left.x.abs() < here.value.abs()).or(best);
            return Ok(nearest.filter(|found| found.is_proved && found.left.is_rounding(64)));
        }
        spare = last.map_or_else(Vec::new, |passage| passage.parts);
    }
    Ok(None)
}

/// Maximum number of displacements without a stop before the search ends.
const MOST_FAILURES: u32 = 4;

/// The steady state through a fixed point of G.
fn steady<F: Float>(
    equation: Equation<F>,
    found: &Passage<F>,
    budget: &Budget<'_>,
) -> Result<Option<LongRun<F>>, Broken> {
    let (zero, one, two) = (F::int(0), F::int(1), F::int(2));
    // The stop at the beginning of the passage is the one at its end with the opposite sign.
    let stop = Stick {
        start: found.stop.start.later_by_half_turns(-1),
        x: -found.stop.x,
        release: Some((found.release, STATION.direction)),
        ..found.stop
    };
    let mut statistics =
        CycleStatistics::at(&PhasePoint { phase: stop.start, x: stop.x, w: zero }, equation.omega);
    let length = found.release.since(stop.start);
    statistics.add(&MotionPart::Stick(stop, length))?;
    let mut longest = None;
    for part in &found.parts {
        statistics.add(part)?;
        if let MotionPart::Slide(slide, end) = part
            && longest.is_none_or(|(_, most)| end.phi > most)
        {
            longest = Some((slide, end.phi));
        }
    }
    let Some((slide, phi)) = longest else { return Ok(None) };
    let off = (found.left.bounds().0 / (one - found.rate)).abs();
    // The state is the middle of the longest slide, with its own rounding, with the opposite sign and half a
    // turn later, so that the next stop is this one again.
    let middle = slide.motion(phi / two);
    let phase = slide.start.advanced(equation.omega * phi / two).later_by_half_turns(1);
    let y = PhasePoint { phase, x: -middle.x, w: -middle.w };
    let distance = Residual::new(&equation, &y, (off, off)).bounds();
    if !is_known(&y, distance) || length < zero {
        return Ok(None);
    }
    Ok(Some(LongRun::Periodic(SteadyState::of(SteadyParts {
        equation,
        start: y,
        half_turns: 1,
        statistics: statistics.doubled(),
        multipliers: [(found.rate.square(), zero), (zero, zero)],
        distance,
        periods: budget.periods(),
    }))))
}

#[cfg(test)]
mod tests;
