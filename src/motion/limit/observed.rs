//! The regime and the stops of an exact motion, consistent with the closed forms.

use super::long_run::LongRun;
use super::steady::SteadyState;
use crate::cycle::Border;
use crate::cycle::regime::{NoStop, Regime, regime_of};
use crate::float::Float;
use crate::machine::error::{Error, written};
use crate::machine::ratios::Ratios;
use crate::motion::State;

/// The steady behaviour of the exact motion, as a [`Regime`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct Observed {
    /// The regime.
    pub regime: Regime,
    /// The number of stops in a cycle, if there is a cycle and friction is not lost in its rounding.
    pub sticks: Option<u32>,
    /// The number of reversals in a cycle, if there is a cycle without a stop.
    pub reversals: Option<u32>,
    /// Whether the regime follows from the borders, because stops or clearances are too small for the
    /// arithmetic, or because the motion has not settled.
    pub by_border: bool,
}

/// The regime of a long run at (Ω, α, ζ).
///
/// **The convention at a border.** A motion is known to within [`SteadyState::distance`] and its rounding. A
/// stop, or the clearance of a velocity that nearly vanishes, may be smaller than that: within about 1e-10 of
/// a border near a pole (1e-8 at a relative distance of 1e-12 from it), and a few units in the last place
/// elsewhere. There the borders decide, which are accurate to 8 and 64 units in the last place; a rounded
/// border itself counts as non-sticking. The borders also decide where the motion has not settled, because
/// the regime is that of its limit, and where displacements are so large that friction is lost in their
/// rounding: the body is held while `|α sin θ − x| ≤ 1`, so that a stop says nothing once `64 ε (α + |x|) ≥ 1`
/// (at f64 from α = 3.5e13 on). This function and [`crate::Response::regime`] therefore agree.
///
/// With a static friction above the kinetic one, the regime is that of this motion: where the regime depends on
/// the start, no border decides.
pub fn observed<F: Float>(ratios: Ratios<F>, limit: &LongRun<F>) -> Observed {
    let by_name = |regime| Observed { regime, sticks: None, reversals: None, by_border: false };
    let border = Border::of(&ratios);
    let expected = regime_of(ratios, border.min_force_ratio);
    let reversals = if ratios.alpha() >= border.min_force_ratio { 2 } else { 6 };
    let steady = match limit {
        LongRun::Periodic(steady) | LongRun::Family(steady) => steady,
        LongRun::Rest(_) => return by_name(Regime::Stuck),
        LongRun::Irregular(motion) if motion.stops > 0 => return by_name(Regime::Sticking),
        LongRun::Irregular(_) => return by_name(Regime::NonSticking),
        LongRun::Unbounded { .. } => return by_name(Regime::Unbounded),
        LongRun::NotConverged { .. } => {
            let reversals = (expected == Regime::NonSticking).then_some(reversals);
            return Observed { reversals, by_border: true, ..by_name(expected) };
        }
    };
    let (sticks, zeros) = (steady.sticks_per_cycle, steady.velocity_zeros_per_cycle);
    let seen = if sticks > 0 { Regime::Sticking } else { Regime::NonSticking };
    let of = |regime, sticks, by_border| Observed {
        regime,
        sticks,
        reversals: (regime == Regime::NonSticking).then_some(zeros),
        by_border,
    };
    if expected == Regime::DependsOnStart {
        return of(seen, Some(sticks), false);
    }
    let is_lost = is_lost(ratios, steady);
    let agrees = expected == seen && if sticks > 0 { !is_lost } else { zeros == reversals };
    if agrees || !(is_lost || is_hidden(ratios, &border, steady)) {
        return of(seen, Some(sticks), false);
    }
    match expected {
        Regime::NonSticking => Observed { reversals: Some(reversals), ..of(expected, Some(0), true) },
        Regime::Stuck | Regime::Sticking | Regime::Unbounded | Regime::DependsOnStart => {
            of(expected, (!is_lost).then_some(sticks), true)
        }
    }
}

/// Whether friction is lost in the rounding of the motion.
///
/// At a reversal, α sin θ and x are known to some four units in the last place, as in the residual of half a
/// turn; the margin of sixteen is that of [`is_hidden`].
fn is_lost<F: Float>(ratios: Ratios<F>, steady: &SteadyState<F>) -> bool {
    let (most, least) = (steady.max_displacement.value, steady.min_displacement.value);
    let size = ratios.alpha() + most.abs().or_larger(least.abs());
    F::int(64) * F::epsilon() * size >= F::int(1)
}

/// The border next to α, if the stop or clearance is below the accuracy of the motion.
pub(super) fn is_hidden<F: Float>(ratios: Ratios<F>, border: &Border<F>, steady: &SteadyState<F>) -> bool {
    let (omega, alpha) = (ratios.omega(), ratios.alpha());
    let (x, v) = steady.distance;
    let known = F::int(16) * x.or_larger(v);
    let rounding = F::int(64) * F::epsilon() * alpha;
    let at_turn = omega.square() / (F::int(1) + omega.square());
    let close = |edge: F, share: F| {
        let gap = (alpha - edge).abs();
        gap <= rounding || gap * share <= known
    };
    // A velocity that nearly vanishes inside a slide clears zero by |α − α_min| sin τ*; the excess force at a
    // reversal grows as α Ω².
    let touching = if border.border_phase == F::int(0) { at_turn } else { border.border_phase.sin().abs() };
    if close(border.min_force_ratio, touching) {
        return true;
    }
    NoStop::of(&ratios).six_reversals.is_some_and(|(low, high)| close(low, at_turn) || close(high, at_turn))
}

/// Stops and velocity zeros in one cycle of the steady motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Stops {
    /// The number of stops of finite duration.
    pub sticks: u32,
    /// The number of instants at which the velocity becomes zero: the beginnings of stops, and reversals
    /// without a stop. It is 2 where the body does not stick.
    pub velocity_zeros: u32,
}

/// The stops per cycle of the steady motion at (Ω, α); `None` where there is no cycle: at rest (α ≤ 1), and
/// at Ω = 1 above the border.
///
/// For a family (Ω = 1/(2n)), these are the stops of the member that a start from rest leads to. They are the
/// same for all members except those at its edge. Next to a border, a stop shorter than the accuracy of the
/// motion is an error, not a count ([`observed()`]).
///
/// With a static friction above the kinetic one, the motion can depend on the start; this is an error.
///
/// Near a pole 1/(2n+1) there may be no stop although α is below the border: then there are six velocity
/// zeros ([`crate::Verdict::SixReversals`]).
///
/// ```
/// use stickslip::Ratios;
/// use stickslip::internal::stops_per_cycle;
/// let stops = |omega, alpha| Ok::<_, stickslip::Error>(stops_per_cycle(Ratios::new(omega, alpha)?)?.map(|s| (s.sticks, s.velocity_zeros)));
/// assert_eq!(stops(0.1, 3.0)?, Some((4, 4)));
/// assert_eq!(stops(0.4, 6.0)?, Some((2, 4))); // two of the zeros are reversals without a stop
/// assert_eq!(stops(0.4, 7.0)?, Some((0, 2)));
/// assert_eq!(stops(0.4, 0.9)?, None);
/// # Ok::<(), stickslip::Error>(())
/// ```
///
/// # Errors
/// [`Error::Undecided`] where a stop, or the clearance without one, is below the accuracy of the motion;
/// [`Error::StaticFriction`] where η > 1; [`Error::NotSettled`] where the motion creeps for longer than
/// [`crate::motion::DEFAULT_BUDGET`] periods; and as for [`crate::motion::Trajectory::new`].
pub fn stops_per_cycle<F: Float>(ratios: Ratios<F>) -> Result<Option<Stops>, Error> {
    let limit = LongRun::from_start(ratios.with_one_friction()?, State::default())?;
    if limit.steady_state().is_some() && observed(ratios, &limit).by_border {
        let alpha = ratios.alpha();
        let away = |x: &F| (*x - alpha).abs();
        let border = Border::of(&ratios).min_force_ratio;
        let edges = NoStop::of(&ratios);
        let all = edges.intervals().flat_map(|(low, high)| [Some(low), high]).flatten();
        let nearest = all.fold(border, |best, x| if away(&x) < away(&best) { x } else { best });
        let (alpha, omega) = (written(alpha), written(ratios.omega()));
        return Err(Error::Undecided { alpha, least: written(nearest), omega });
    }
    match limit {
        LongRun::Periodic(steady) | LongRun::Family(steady) => Ok(Some(Stops {
            sticks: steady.sticks_per_cycle,
            velocity_zeros: steady.velocity_zeros_per_cycle,
        })),
        LongRun::Rest(_) | LongRun::Unbounded { .. } => Ok(None),
        LongRun::Irregular(_) | LongRun::NotConverged { .. } => {
            Err(Error::NotSettled { omega: written(ratios.omega()), alpha: written(ratios.alpha()) })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{is_hidden, observed};
    use crate::motion::{LongRun, State};
    use crate::{Border, NoStop, Ratios, Regime};

    /// A motion without a period sticks where it has stops.
    #[test]
    fn stops_of_an_irregular_motion_count() {
        let ratios = Ratios::new(0.45, 7.5).unwrap().with_damping_ratio(0.02).unwrap();
        let ratios = ratios.with_static_friction_ratio(2.5).unwrap();
        let limit = LongRun::from_start(ratios, State::default()).unwrap();
        let LongRun::Irregular(mut motion) = limit else { panic!("{limit:?}") };
        assert!(motion.stops > 0);
        for (stops, regime) in [(motion.stops, Regime::Sticking), (0, Regime::NonSticking)] {
            motion.stops = stops;
            assert_eq!(observed(ratios, &LongRun::Irregular(motion)).regime, regime, "{stops}");
        }
    }

    /// Near a pole, in the gap between the forces of six reversals and the border, the body stops. From 64 ε
    /// (α + |x|) = 1 on, a stop of the computed motion has no meaning.
    #[test]
    fn a_stop_of_a_motion_in_which_friction_is_lost_does_not_count() {
        let ratios = Ratios::new(0.331, 170.0).unwrap();
        let limit = LongRun::from_start(ratios, State::default()).unwrap();
        let LongRun::Periodic(mut steady) = limit else { panic!("{limit:?}") };
        let (sticks, least) = (steady.sticks_per_cycle, 1.0 / (64.0 * f64::EPSILON));
        assert!(sticks > 0);
        for (size, stops, by_border) in
            [(0.99 * least, Some(sticks), false), (1.01 * least, None, true), (-1.01 * least, None, true)]
        {
            (steady.max_displacement.value, steady.min_displacement.value) = (size.max(0.0), size.min(0.0));
            let seen = observed(ratios, &LongRun::Periodic(steady));
            assert_eq!((seen.regime, seen.sticks, seen.by_border), (Regime::Sticking, stops, by_border));
        }
        // Without a stop the motion and the border agree.
        let ratios = Ratios::new(0.331, 200.0).unwrap();
        let limit = LongRun::from_start(ratios, State::default()).unwrap();
        let LongRun::Periodic(mut steady) = limit else { panic!("{limit:?}") };
        steady.max_displacement.value = 1.01 * least;
        let seen = observed(ratios, &LongRun::Periodic(steady));
        assert_eq!((seen.sticks, seen.reversals, seen.by_border), (Some(0), Some(2), false));
        // From this force on, the border decides and the stops of the motion count as rounding.
        steady.sticks_per_cycle = 2;
        let seen = observed(ratios, &LongRun::Periodic(steady));
        assert_eq!((seen.sticks, seen.reversals, seen.by_border), (Some(0), Some(2), true));
    }

    /// A difference is hidden if it is below 64 units in the last place of α, or below sixteen times the
    /// distance divided by the clearance rate: sin τ* inside a slide, Ω²/(1 + Ω²) at a reversal.
    #[test]
    fn what_is_smaller_than_the_motion_is_known_is_hidden() {
        let of = |omega: f64, alpha: f64| Ratios::new(omega, alpha).unwrap();
        let limit = LongRun::from_start(of(0.7, 3.0), State::default()).unwrap();
        let mut steady = *limit.steady_state().unwrap();
        for (x, v) in [(0.0, 0.0), (1e-9, 3e-10), (3e-10, 1e-9)] {
            steady.distance = (x, v);
            let known = 16.0 * f64::max(x, v);
            let true_border = Border::of(&of(0.7, 3.0));
            for (border_phase, share) in [(0.0, 0.49 / 1.49), (0.3, 0.3f64.sin()), (-0.3, 0.3f64.sin())] {
                let reach = f64::max(64.0 * f64::EPSILON * 3.0, known / share);
                for (part, is) in [(-1.01, false), (-0.99, true), (0.0, true), (0.99, true), (1.01, false)] {
                    let border = Border { min_force_ratio: 3.0 + part * reach, border_phase, ..true_border };
                    assert_eq!(
                        is_hidden(of(0.7, 3.0), &border, &steady),
                        is,
                        "{x} {v} {border_phase} {part}"
                    );
                }
            }
            // The edges of six reversals are decided at reversals.
            let border = Border::new(0.331).unwrap();
            let (low, high) = NoStop::of(&Ratios::new(0.331, 1.0).unwrap()).six_reversals.unwrap();
            let share = 0.331f64.powi(2) / (1.0 + 0.331f64.powi(2));
            for edge in [low, high] {
                let reach = f64::max(64.0 * f64::EPSILON * edge, known / share);
                for (part, is) in [(-1.01, false), (-0.98, true), (0.0, true), (0.98, true), (1.01, false)] {
                    let ratios = of(0.331, edge + part * reach);
                    assert_eq!(is_hidden(ratios, &border, &steady), is, "{x} {v} {edge} {part}");
                }
            }
        }
    }
}
