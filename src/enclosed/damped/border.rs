//! The border with damping, or with static friction above the kinetic one, in balls.
//!
//! The documentation of `crate::cycle::damped::border` proves that ρ(τ), the function of the condition,
//! has at most one maximum between two zeros of p, which are known, and none elsewhere. Where ρ′ is certainly
//! positive at one of them and negative at the other, the maximum is enclosed. Pairs of zeros are examined
//! from both ends of the half cycle inwards, until no value between them can reach the greatest one found.

use crate::cycle::border::border_force_ratio;
use crate::cycle::damped::border::{exceeds, rise, turning_point, zeros};
use crate::cycle::damped::half_period::HalfPeriod;
use crate::cycle::damped::touch::NearerEnd;
use crate::enclosed::border::Border;
use crate::enclosed::root::only_zero;
use crate::float::ball::Ball;
use crate::float::{Field, Real};
use crate::root::newton_within;
use rug::Integer;

/// The greatest number of zeros of p that are examined.
const MOST: i32 = 2000;

/// A maximum of ρ and its time.
type Touch<const W: usize> = (Ball<W>, Ball<W>);

/// The border at this half period.
pub(in crate::enclosed) fn border<const W: usize>(half: &HalfPeriod<Ball<W>>) -> Border<W> {
    let at_turning_point = turning_point(half);
    let force_ratio = |s: Ball<W>| border_force_ratio(half.k, half.stiffness * s);
    let of = |s: Ball<W>, phase| Border {
        min_force_ratio: force_ratio(s),
        turning_point: force_ratio(at_turning_point),
        least_displacement: s - half.shift,
        phase,
    };
    let found = touches(half, at_turning_point);
    let Some(found) = found else { return of(Ball::entire(), None) };
    let s = found.iter().fold(at_turning_point, |s, (value, _)| s.larger(value));
    // This is the only maximum that may be the largest.
    let mut phases: Vec<Ball<W>> = found
        .iter()
        .filter(|(value, _)| !value.is_below(&s))
        .map(|(_, tau)| half.omega * *tau)
        .chain((!at_turning_point.is_below(&s)).then(|| Ball::int(0)))
        .collect();
    let phase = phases.pop().filter(|_| phases.is_empty());
    of(s, phase)
}

/// All maxima of ρ that may exceed `least`; `None` where they are undecided.
fn touches<const W: usize>(half: &HalfPeriod<Ball<W>>, least: Ball<W>) -> Option<Vec<Touch<W>>> {
    // Above ζ = 1, and for Ω ≥ d/2, the turning point suffices: for 4Ω² ≥ d² = 1 − ζ².
    if !crate::float::Signed::negative((half.omega * Ball::int(2)).square() - half.free.square)? {
        return Some(Vec::new());
    }
    let d = half.free.frequency;
    let (first, _) = zeros(half, NearerEnd::First, &half.at(Ball::int(0)).free)?;
    let zero = |n: i32| first + Ball::int(n) * Ball::pi() / d;
    let last = last_zero(half, first)?;
    let (mut best, mut found) = (least, Vec::new());
    // Pairs of neighbours (n, n + 1), from both ends.
    for n in 0..(last + 1) / 2 {
        if n > MOST {
            return None;
        }
        let (low, high) = (half.at(zero(n)), half.at(zero(last - n)));
        if exceeds(half, [&low, &high], best) == Some(false) {
            break;
        }
        let other = last - n - 1;
        for pair in [Some(n), (other != n).then_some(other)].into_iter().flatten() {
            let touch = maximum_between(half, zero(pair), zero(pair + 1))?;
            if let Some((value, tau)) = touch {
                best = best.larger(&value);
                found.push((value, tau));
            }
        }
    }
    Some(found)
}

/// The number of zeros between the first one and T.
fn last_zero<const W: usize>(half: &HalfPeriod<Ball<W>>, first: Ball<W>) -> Option<i32> {
    let steps = (half.period - first) * half.free.frequency / Ball::pi();
    if steps.is_negative() {
        return Some(0);
    }
    let floor = |x: crate::float::mp::Mp<W>| x.to_rational().map(|x| Integer::from(x.floor_ref()));
    let (low, high) = (floor(steps.lower())?, floor(steps.upper())?);
    (low == high).then(|| low.to_i32()).flatten()
}

/// The maximum of ρ between two neighbouring zeros of p, if there is one; the outer `None` means undecided.
#[allow(clippy::option_option, reason = "undecided is not none")]
fn maximum_between<const W: usize>(
    half: &HalfPeriod<Ball<W>>,
    low: Ball<W>,
    high: Ball<W>,
) -> Option<Option<Touch<W>>> {
    let slope = |tau: Ball<W>| rise(half, NearerEnd::First, &half.at(tau));
    let (rises, falls) = (slope(low).0, slope(high).0);
    if rises.is_negative() || falls.is_positive() {
        return Some(None);
    }
    if !(rises.is_positive() && falls.is_negative()) {
        return None;
    }
    // Just below Ω = 1/(2n) the maximum is close to the turning point, where the slope of ρ has a triple zero: Newton's
    // method alone does not arrive from the middle.
    let start = newton_within(low.mid(), high.mid(), |tau| {
        let (value, derivative) = slope(Ball::exact(tau));
        (value.mid(), derivative.mid())
    });
    let tau = only_zero(start, |tau| slope(tau).0, |tau| slope(tau).1)?;
    if !(low.is_below(&tau) && tau.is_below(&high)) {
        return None;
    }
    // ρ = [b cos Ωτ − h′]/(Ω sin Ωτ), which is stationary at the maximum.
    let value = |tau: Ball<W>| {
        let at = half.at(tau);
        (half.omega * half.h * at.drive.1 - at.free.v) / (half.omega * at.drive.0)
    };
    Some(Some((value(tau), tau)))
}
