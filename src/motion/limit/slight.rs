//! The periodic motion just above α = 1: a slight slide at every crest of the force, and stops between.
//!
//! Let δ = α − 1. From x = 0 the force exceeds friction by at most δ, and moves the body by about 9δ²/2Ω². The motion from
//! any start approaches its limit by a share of δ a turn, so that no start reaches it. The limit itself is simple: the
//! slide from −X ends at X. Both are so close to 0 that they are known to a relative rounding, which the search for the
//! fixed point (`stops`) does not assume: it knows x to the rounding of the force.
//!
//! `X ← ½ (slide from −X)` contracts by about 9δ/Ω². The release, close to the crest of the force, is known to the rounding
//! of its phase, a share ε/√δ of its distance from the crest.

use super::long_run::LongRun;
use super::measures::CycleStatistics;
use super::propagation::MotionPart;
use super::steady::{SteadyParts, SteadyState};
use super::stop_map::{Expected, Passage, Station, passage};
use crate::float::Float;
use crate::motion::broken::{Broken, Budget};
use crate::motion::slide::equation::Equation;
use crate::motion::slide::stick::Stick;
use crate::motion::state::PhasePoint;
use alloc::vec::Vec;

/// The greatest δ/Ω² for which the slide is slight.
const SLIGHT: i32 = -10;

/// The limit, if α is that close to 1; for η = 1.
///
/// # Errors
/// As for [`passage`].
pub(super) fn limit<F: Float>(
    equation: Equation<F>,
    station: Station,
    budget: &mut Budget<'_>,
) -> Result<Option<LongRun<F>>, Broken> {
    let (zero, one, two) = (F::int(0), F::int(1), F::int(2));
    let excess = equation.alpha - one;
    let square = equation.omega.square();
    let least = if square < one { square } else { one };
    if !(excess > zero && excess <= F::exp2i(SLIGHT) * least) {
        return Ok(None);
    }
    // The rounding of the release, and that of its slide, with a margin.
    let share = F::int(64) * F::epsilon() / excess.sqrt();
    let mut x = zero;
    for _ in 0..16 {
        let expected = Expected { by: None, is_proved: true };
        let Some(found) = passage(equation, station, x, expected, Vec::new(), budget)? else {
            return Ok(None);
        };
        let half = (found.stop.x - x) / two;
        if found.parts.len() != 1 || half.partial_cmp(&zero) != Some(core::cmp::Ordering::Greater) {
            return Ok(None);
        }
        if (half + x).abs() <= share * half {
            return steady(equation, station, &found, share * half, budget);
        }
        x = -half;
    }
    Ok(None)
}

/// The steady state of this passage, whose ends are known to `off`.
fn steady<F: Float>(
    equation: Equation<F>,
    station: Station,
    found: &Passage<F>,
    off: F,
    budget: &Budget<'_>,
) -> Result<Option<LongRun<F>>, Broken> {
    let zero = F::int(0);
    let stop = Stick {
        start: found.stop.start.later_by_half_turns(-1),
        x: -found.stop.x,
        release: Some((found.release, station.direction)),
        ..found.stop
    };
    let length = found.release.since(stop.start);
    // The state is in the middle of the stop, where the force is far from friction.
    let start = PhasePoint { phase: stop.start.advanced(length / F::int(2)), x: stop.x, w: zero };
    let mut statistics = CycleStatistics::at(&PhasePoint { phase: stop.start, ..start }, equation.omega);
    statistics.add(&MotionPart::Stick(stop, length))?;
    for part in &found.parts {
        statistics.add(part)?;
    }
    Ok(Some(LongRun::Periodic(SteadyState::of(SteadyParts {
        equation,
        start,
        half_turns: 1,
        statistics: statistics.doubled(),
        multipliers: [(found.rate.square(), zero), (zero, zero)],
        distance: (off, off * equation.omega),
        periods: budget.periods(),
    }))))
}

#[cfg(test)]
mod tests {
    use crate::Ratios;
    use crate::motion::{LongRun, State, Trajectory};
    use std::f64::consts::PI;

    /// With θ from the crest and a = √(2δ), the speed of the slide from −a is `[a²(θ + a)/2 − (θ³ + a³)/6]/Ω` to the
    /// leading order: it ends at 2a, after `9a⁴/8Ω² = 9δ²/2Ω²`. The next order is a share of the slide's duration, √δ/Ω.
    #[test]
    fn the_slide_at_the_crest_is_that_of_the_excess() {
        for omega in [0.3, 0.6, 1.0, 3.0] {
            for excess in [1e-5, 1e-7, 1e-9, 1e-11, 1e-13, 4e-15, f64::EPSILON] {
                for zeta in [0.0, 0.2] {
                    let alpha = 1.0 + excess;
                    let excess = alpha - 1.0;
                    let ratios = Ratios::new(omega, alpha).unwrap().with_damping_ratio(zeta).unwrap();
                    let limit = LongRun::from_start(ratios, State::default()).unwrap();
                    let steady = limit.steady_state().unwrap_or_else(|| panic!("{ratios:?}: {limit:?}"));
                    let most = 9.0 * excess * excess / (4.0 * omega * omega);
                    let room = 10.0 * excess.sqrt() * (1.0 + 1.0 / omega).powi(2)
                        + 64.0 * f64::EPSILON / excess.sqrt();
                    let (x, least) = (steady.max_displacement, steady.min_displacement);
                    assert!((x.value / most - 1.0).abs() < room, "{ratios:?}: {x:?} for {most:e}");
                    assert_eq!((x.value, steady.sticks_per_cycle), (-least.value, 2), "{ratios:?}");
                    let late = (8.0 * excess).sqrt();
                    assert!(
                        (x.phase.reduced() - PI / 2.0 - late).abs() < room * late + 1e-15,
                        "{ratios:?}: {x:?}"
                    );
                    assert!((least.phase.since(x.phase).abs() - PI).abs() < 1e-15, "{ratios:?}");
                    // The body is followed from the state without falling into rest.
                    let slides = Trajectory::new(ratios, steady.state).unwrap().take(8).map(Result::unwrap);
                    assert_eq!(slides.count(), 8, "{ratios:?}");
                    // From the middle of a slide on, the acceleration α sin θ − 1, of the order of δ, has a rounding of ε.
                    let rounding = 1e-6 + 8.0 * f64::EPSILON / excess;
                    assert!(
                        steady.errors().unwrap().error_1 < rounding && steady.periods < 100.0,
                        "{ratios:?}"
                    );
                }
            }
        }
    }

    /// From the static friction on, a float decides: at α = η the body rests, and above it leaves with an acceleration.
    #[test]
    fn one_float_above_the_static_friction_the_body_moves() {
        for (omega, eta, zeta) in
            [(0.6, 1.5, 0.0), (0.6, 1.1, 0.05), (1.7, 2.0, 0.0), (0.3, 1.3, 0.1), (3.0, 1.2, 0.4)]
        {
            let at = |alpha: f64| {
                let ratios = Ratios::new(omega, alpha).unwrap().with_damping_ratio(zeta).unwrap();
                let ratios = ratios.with_static_friction_ratio(eta).unwrap();
                let moves = Trajectory::new(ratios, State::default()).unwrap().nth(1).is_some();
                (moves, LongRun::from_start(ratios, State::default()).unwrap())
            };
            let (moves, limit) = at(eta);
            assert!(!moves && limit.rest_position() == Some(0.0), "{eta}: {limit:?}");
            let far = at(eta * (1.0 + 1e-9)).1.extrema().unwrap();
            let mut alpha: f64 = eta;
            for _ in 0..24 {
                alpha = alpha.next_up();
                let (moves, limit) = at(alpha);
                let found = limit.extrema().unwrap_or_else(|| panic!("{alpha} {eta}: {limit:?}"));
                assert!(moves && (found.1 - far.1).abs() < 1e-6 * far.1, "{alpha} {eta}: {found:?} {far:?}");
            }
        }
    }
}
