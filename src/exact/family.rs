//! Ω = 1/(2n): a family of periodic motions.
//!
//! There the natural period divides half of the drive's, a free vibration of fixed amplitude can ride on the forced one, and
//! any of a family of motions that do not stick is periodic: extrema `±α/(1 − Ω²) + c` with `|c| ≤ αΩ²/(1 − Ω²) − 1` (in B). One
//! multiplier of the cycle is 1. Which member a motion tends to depends on its start, so it is followed there.
//!
//! A motion outside of the family sticks, a little less in each cycle, and creeps towards the member at the edge, which touches
//! the border of sticking: the distance falls like 1/cycles only. It never grows (`shooting`), so that once the motion is
//! close to that member it is the limit to within that distance.

use super::drive::DrivePhase;
use super::equation::Equation;
use super::long_run::{LongRun, unsettled};
use super::matrix::Matrix;
use super::measures::Tally;
use super::shooting::{Budget, Residual};
use super::slide::{Direction, Slide};
use super::steady::{SteadyState, Summary};
use super::walk::{Part, Point, walk};
use crate::float::Float;
use crate::nonsticking::Border;
use crate::phase_function::PhaseFunction;
use crate::ratios::Ratios;

/// Whether (Ω, α) has a family: Ω = 1/(2n) to within its rounding, and no sticking.
pub(crate) fn is_one<F: Float>(ratios: Ratios<F>) -> bool {
    // 1/2 is the greatest of them.
    if ratios.omega() * F::int(3) > F::int(2) {
        return false;
    }
    let p = PhaseFunction::of_valid(ratios.omega());
    p.is_even_subharmonic() && ratios.alpha() >= Border::at(&p).min_force_ratio()
}

/// The member that the motion through a point tends to.
///
/// The change from cycle to cycle shrinks by the other multiplier μ, so that what is left after a change d is
/// `d μ/(1 − μ)`; it is added once it is small enough for the motion to be linear in it.
pub(crate) fn member<F: Float>(
    equation: Equation<F>,
    start: Point<F>,
    hint: F,
    mut budget: Budget,
) -> LongRun<F> {
    let one = F::int(1);
    let mut y = start;
    let mut parts = Vec::new();
    let mut added = false;
    loop {
        let cycle = walk(equation, y, 2, hint, parts);
        budget.walked(2);
        let (dx, dw) = (cycle.end.x - y.x, cycle.end.w - y.w);
        let residual = Residual::new(&equation, &y, (dx, dw));
        let change = residual.norm();
        let other = cycle.monodromy.determinant().abs();
        // Friction too small beside the motion for the type to see: nothing tells how much is left.
        let settles = one - other > rate_noise(cycle.parts.len());
        let in_the_limit = |change: F| if settles { change / (one - other) } else { one / F::int(0) };
        let left = in_the_limit(change);
        let size = one + y.x.abs() + y.w.abs();
        let rounding = F::int(4) * (residual.bound() - change);
        // A motion far outside loses less in a cycle than its own rounding: that it repeats says nothing.
        if is_near(&equation, &y) && settles && (left <= rounding || (added && change <= rounding)) {
            let off = in_the_limit(residual.bound()) + rounding;
            return finish(equation, y, &cycle.parts, cycle.monodromy, (off, off), &budget);
        }
        let sticks = cycle.parts.iter().any(|part| matches!(part, Part::Stick(..)));
        if sticks && budget.half_turns >= LONG_CREEP {
            let edge = nearest_edge(equation, &y);
            let off = (edge.x - y.x).hypot(edge.w - y.w);
            if off * F::int(16) < size {
                let cycle = walk(equation, edge, 2, hint, cycle.parts);
                return finish(equation, edge, &cycle.parts, cycle.monodromy, (off, off), &budget);
            }
        }
        if budget.half_turns > budget.most {
            return unsettled(&equation, &y, change, &budget);
        }
        // The neutral disturbance of the jump is of second order: below rounding for a jump of its root.
        let jump = !added && left.square() <= F::epsilon() * F::ratio(1, 64) * size.square() && settles;
        let reach = if jump { one / (one - other) } else { one };
        y = Point { phase: y.phase, x: y.x + dx * reach, w: y.w + dw * reach };
        added = added || jump;
        parts = cycle.parts;
    }
}

/// Whether a point is as near as the members of the family are, to within a factor: `|x| ≤ α(1 + Ω²)/(1 − Ω²) − 1` there.
fn is_near<F: Float>(equation: &Equation<F>, y: &Point<F>) -> bool {
    let (one, omega) = (F::int(1), equation.omega);
    let reach = equation.alpha * (one + omega.square()) / ((one - omega) * (one + omega));
    y.x.abs() + y.w.abs() <= F::int(8) * reach
}

/// The rounding of what a cycle of so many parts leaves of a disturbance, with room.
fn rate_noise<F: Float>(parts: usize) -> F {
    F::int(64) * F::epsilon() * F::from_f64(parts as f64 + 1.0)
}

/// Half turns after which a motion of a family that still sticks is taken to creep.
const LONG_CREEP: u64 = 400;

/// The member at the edge of the family that is nearest to y, at the phase of y.
///
/// The members are the symmetric cycle and `c cos ω_n(t − t₂)`, |c| up to `αΩ²/(1 − Ω²) − 1`.
fn nearest_edge<F: Float>(equation: Equation<F>, y: &Point<F>) -> Point<F> {
    let (zero, one) = (F::int(0), F::int(1));
    let Equation { omega, alpha, .. } = equation;
    let amplitude = alpha / ((one - omega) * (one + omega));
    let room = omega.square() * amplitude - one;
    // t₂ is at π/2: K = 0. The half turn before y begins at an extremum, a maximum where sin θ > 0.
    let before = DrivePhase::of_half_turn(y.phase.half_turns(), -(F::pi() / F::int(2)));
    let maximum = !before.is_even();
    let (side, direction) = if maximum { (one, Direction::Backward) } else { (-one, Direction::Forward) };
    let phi = y.phase.since(before) / omega;
    let at = |c: F| {
        let motion = Slide::new(equation, before, side * amplitude + c, zero, direction).motion(phi);
        Point { phase: y.phase, x: motion.x, w: motion.w }
    };
    let (high, low) = (at(room), at(-room));
    let distance = |p: &Point<F>| (p.x - y.x).hypot(p.w - y.w);
    if distance(&high) <= distance(&low) { high } else { low }
}

fn finish<F: Float>(
    equation: Equation<F>,
    start: Point<F>,
    parts: &[Part<F>],
    monodromy: Matrix<F>,
    distance: (F, F),
    budget: &Budget,
) -> LongRun<F> {
    let (zero, one) = (F::int(0), F::int(1));
    let tally = Tally::of(&start, equation.omega, parts);
    // No disturbance grows (`shooting`): above 1 it is all rounding, of a friction that the type cannot see beside the force.
    let other = monodromy.determinant();
    let other = if other.abs() > one { one.with_sign_of(other) } else { other };
    LongRun::Family(SteadyState {
        equation,
        start,
        tally: Summary::of(&tally),
        multipliers: [(one, zero), (other, zero)],
        distance,
        periods: F::from_f64(budget.half_turns as f64) / F::int(2),
    })
}

#[cfg(test)]
mod tests {
    use super::{is_near, is_one, member, nearest_edge};
    use crate::exact::DrivePhase;
    use crate::exact::equation::Equation;
    use crate::exact::long_run::LongRun;
    use crate::exact::shooting::Budget;
    use crate::exact::walk::{Part, Point, walk};
    use crate::{Border, Ratios};

    /// The equation at Ω = 1/(2n), some times above the border, with α/(1 − Ω²) and the greatest |c|.
    fn family(n: u32, times: f64) -> (Equation<f64>, f64, f64) {
        let omega = 1.0 / f64::from(2 * n);
        let ratios = Ratios::new(omega, Border::new(omega).unwrap().min_force_ratio() * times).unwrap();
        assert!(is_one(ratios));
        let equation = Equation::new(ratios);
        let amplitude = equation.alpha / (1.0 - omega * omega);
        (equation, amplitude, omega * omega * amplitude - 1.0)
    }

    /// At t₂, where the members have their maximum: ω_d t₂ = π/2.
    fn at_maximum(x: f64, w: f64) -> Point<f64> {
        Point { phase: DrivePhase::new(std::f64::consts::FRAC_PI_2).unwrap(), x, w }
    }

    fn limit(equation: Equation<f64>, y: Point<f64>, most: u64) -> LongRun<f64> {
        member(equation, y, 1.0, Budget { half_turns: 0, most })
    }

    /// Cycles of the motion itself, and whether the last of them sticks.
    fn followed(equation: Equation<f64>, mut y: Point<f64>, cycles: u32) -> (Point<f64>, bool) {
        let mut sticks = false;
        for _ in 0..cycles {
            let cycle = walk(equation, y, 2, 1.0, Vec::new());
            sticks = cycle.parts.iter().any(|part| matches!(part, Part::Stick(..)));
            y = Point { phase: y.phase, ..cycle.end };
        }
        (y, sticks)
    }

    #[test]
    fn a_family_is_at_the_even_parts_of_one_above_the_border() {
        let is = |omega: f64, times: f64| {
            let least = Border::new(omega).unwrap().min_force_ratio();
            is_one(Ratios::new(omega, least * times).unwrap())
        };
        assert!([0.5, 0.25, 1.0 / 6.0, 1e-3].into_iter().all(|omega| is(omega, 1.001) && !is(omega, 0.999)));
        assert!([0.51, 1.0 / 3.0, 1.0, 2.0, 0.5 + 1e-9].into_iter().all(|omega| !is(omega, 1.5)));
    }

    #[test]
    fn near_is_within_eight_times_the_reach() {
        // 8 · 12 (1 + 1/4)/(1 − 1/4) = 160
        let equation = Equation::new(Ratios::new(0.5, 12.0).unwrap());
        let near = |x, w| is_near(&equation, &at_maximum(x, w));
        assert!(near(159.0, 0.0) && near(-80.0, 79.0) && near(0.0, -159.0));
        assert!(!near(161.0, 0.0) && !near(-80.0, 81.0) && !near(0.0, -161.0));
    }

    #[test]
    fn a_start_tends_to_where_the_motion_itself_does() {
        for n in 1..5 {
            for times in [1.02, 1.3, 4.0] {
                let (equation, amplitude, room) = family(n, times);
                for i in 0..8 {
                    let part = |step: f64| 2.0 * (f64::from(i) * step).fract() - 1.0;
                    let start = at_maximum(amplitude + room * part(0.618_034), 0.3 * room * part(0.754_878));
                    let (there, sticks) = followed(equation, start, 600);
                    if sticks {
                        continue;
                    }
                    let LongRun::Family(found) = limit(equation, start, 40_000) else {
                        panic!("n = {n}, {start:?}")
                    };
                    let c = (found.max_displacement() + found.min_displacement()) / 2.0;
                    let at = format!("n = {n}, {times} times, start {i}: {found:?}");
                    let off = found.distance().0 + 1e-12 * amplitude;
                    assert!((found.max_displacement() - c - amplitude).abs() <= off, "{at}");
                    assert!(
                        c.abs() <= room + off && (c - (there.x - amplitude)).abs() <= off,
                        "{there:?} {at}"
                    );
                    assert!(found.distance().0 < 1e-7 * amplitude && found.sticks_per_cycle() == 0, "{at}");
                    assert!(found.periods() < 200.0, "{at}");
                }
            }
        }
    }

    /// A member stays what it is, to within the distance that is named.
    #[test]
    fn a_member_is_its_own_limit() {
        for n in 1..5 {
            for times in [1.3, 4.0, 50.0] {
                let (equation, amplitude, room) = family(n, times);
                for i in -9..=9 {
                    let c = room * f64::from(i) / 10.0;
                    let start = at_maximum(amplitude + c, 0.0);
                    let LongRun::Family(found) = limit(equation, start, 400) else { panic!("n = {n}, {i}") };
                    let (max, min) = (found.max_displacement(), found.min_displacement());
                    let off = found.distance().0;
                    assert!(
                        (max - amplitude - c).abs() <= off && (min + amplitude - c).abs() <= off,
                        "{found:?}"
                    );
                    let [(one, zero), (other, _)] = found.multipliers();
                    assert!((one, zero) == (1.0, 0.0) && other.abs() < 0.999, "{found:?}");
                    assert!(
                        off > 0.0 && off < 1e-12 * amplitude && found.periods() < 60.0,
                        "{n} {i} {found:?}"
                    );
                }
            }
        }
    }

    /// Where friction is below the rounding of the motion nothing tells how far the limit is.
    #[test]
    fn friction_that_cannot_be_seen_settles_nothing() {
        for times in [1e15, 1e16, 1e40] {
            for part in [1.1, 1.0, 0.3] {
                let (equation, amplitude, _) = family(1, times);
                let found = limit(equation, at_maximum(amplitude * part, 0.0), 100);
                assert!(matches!(found, LongRun::NotConverged { .. }), "{times} {part} {found:?}");
            }
        }
    }

    /// Where it can hardly be seen, a member is still found or said not to be, to within a distance that grows as friction fades.
    #[test]
    fn friction_that_can_hardly_be_seen() {
        for times in [1e6, 1e9, 1e12] {
            let (equation, amplitude, room) = family(1, times);
            for i in -9..=9 {
                let c = room * f64::from(i) / 10.0;
                let start = at_maximum(amplitude + c, 0.0);
                let LongRun::Family(found) = limit(equation, start, 400) else {
                    assert!(times > 1e6, "{i}");
                    continue;
                };
                let (max, min) = (found.max_displacement(), found.min_displacement());
                let off = found.distance().0;
                assert!(
                    (max - amplitude - c).abs() <= off && (min + amplitude - c).abs() <= off,
                    "{found:?}"
                );
                assert!((1e-16 * times..1e-14 * times).contains(&(off / amplitude)), "{off} {found:?}");
            }
        }
    }

    /// From outside it creeps to the edge.
    #[test]
    fn outside_of_the_family_the_edge_is_the_limit() {
        for n in 1..5 {
            let (equation, amplitude, room) = family(n, 1.3);
            for side in [1.0, -1.0] {
                let start = at_maximum(amplitude + 1.5 * side * room, 0.0);
                let LongRun::Family(found) = limit(equation, start, 40_000) else { panic!("n = {n}") };
                let c = (found.max_displacement() + found.min_displacement()) / 2.0;
                assert!((c - side * room).abs() < 1e-9 * amplitude, "n = {n}: {c} for {room}");
                let off = found.distance().0;
                assert!(off < 0.1 * amplitude && found.periods() < 400.0, "{off} {}", found.periods());
                // It has stuck all the time, and is as near as it says.
                let (there, _) = followed(equation, start, found.periods() as u32);
                assert!((there.x - amplitude - side * room).abs() <= off, "n = {n}: {there:?} {off}");
            }
            let unfinished = limit(equation, at_maximum(amplitude + 1.5 * room, 0.0), 20);
            assert!(matches!(unfinished, LongRun::NotConverged { .. }), "{unfinished:?}");
        }
    }

    /// The edge is a motion that does not stick, at any phase.
    #[test]
    fn the_edge_is_a_member() {
        for n in 1..5 {
            let (equation, amplitude, room) = family(n, 1.7);
            for i in 0..60 {
                let phase = DrivePhase::new(0.1 + 0.1 * f64::from(i)).unwrap();
                for side in [1.0, -1.0] {
                    // Some way outside, at the same phase.
                    let (outside, _) = followed(equation, at_maximum(amplitude + side * room, 0.0), 1);
                    let on = walk(equation, outside, 4, 1.0, Vec::new()).end;
                    assert!((on.x - amplitude - side * room).abs() < 1e-9 * amplitude);
                    let edge = nearest_edge(equation, &Point { phase, x: side * 1e6, w: 0.0 });
                    let (back, _) = followed(equation, edge, 1);
                    assert!((back.x - edge.x).hypot(back.w - edge.w) < 1e-9 * amplitude, "n = {n}, {i}");
                }
            }
        }
    }
}
