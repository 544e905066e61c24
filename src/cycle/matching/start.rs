//! Where Newton's method starts: from the motion without friction, the friction growing to its value, at f64;
//! and the instant of maximum velocity, searched on a grid.

use super::Unknowns;
use super::balanced::Balanced;
use super::step::{in_order, largest, newton_step, unknowns};
use crate::float::{Field, Float, Real};
use core::f64::consts::{FRAC_PI_2, PI};

/// A point of the path: the unknowns of the system with a friction.
#[derive(Debug, Clone, Copy)]
struct Point {
    at: [f64; 5],
    friction: f64,
}

/// A step is taken where it changes no phase by more than this.
const LONGEST: f64 = 0.2;

fn moved(x: &[f64; 5], by: &[f64; 5], times: f64) -> [f64; 5] {
    let mut result = *x;
    for (x, dx) in result.iter_mut().zip(by) {
        *x += times * dx;
    }
    result
}

/// `x = A sin ω_d t`: maximum velocity at t₁ = 0, maximum displacement at π/2; half a turn later where A < 0.
fn without_friction(system: &Balanced<f64>, below: bool) -> Point {
    let (sign, turn) = if below { (1.0, 0.0) } else { (-1.0, PI) };
    Point { at: [turn, turn + FRAC_PI_2, sign * system.omega, sign, 0.0], friction: 0.0 }
}

/// A step along the path to another friction: the tangent, then Newton. `None` where that does not settle
/// close by.
fn step(system: &Balanced<f64>, from: &Point, friction: f64) -> Option<Point> {
    let here = Balanced { friction: from.friction, ..*system };
    let u = unknowns(&from.at);
    let tangent = newton_step(&here.by_friction(&u), &here.jacobian(&u))?;
    let mut at = moved(&from.at, &tangent, from.friction - friction);
    let there = Balanced { friction, ..*system };
    let mut last = f64::INFINITY;
    for _ in 0..12 {
        let u = unknowns(&at);
        let correction = newton_step(&there.residuals(&u), &there.jacobian(&u))?;
        at = moved(&at, &correction, -1.0);
        let size = largest(&correction);
        if size < 1e-11 || (size < 1e-7 && size >= last / 2.0) {
            let [t1, t2, ..] = at;
            let [s1, s2, ..] = from.at;
            let close = (t1 - s1).abs() <= LONGEST && (t2 - s2).abs() <= LONGEST;
            return close.then_some(Point { at, friction });
        }
        if size > LONGEST {
            return None;
        }
        last = size;
    }
    None
}

/// Follows the path to `target`, or to where it ends, or to where `left_over` is within a tenth of zero; the
/// steps adapt, and none goes further than that.
fn follow(system: &Balanced<f64>, from: Point, target: f64, left_over: impl Fn(&Point) -> f64) -> Point {
    let (mut point, mut length) = (from, target - from.friction);
    for _ in 0..4000 {
        let left = target - point.friction;
        if left == 0.0 || left_over(&point) < 0.1 {
            break;
        }
        let last = left.abs() <= length.abs();
        let next = if last { target } else { point.friction + length };
        match step(system, &point, next).filter(|p| left_over(p) > -0.1) {
            Some(found) => {
                point = found;
                length *= 1.5;
            }
            None => length = if last { left / 2.0 } else { length / 2.0 },
        }
        if length.abs() <= 1e-15 * target.abs() {
            break;
        }
    }
    point
}

/// The cycle with all of its friction; the part of the friction where the path ends otherwise.
pub(super) fn with_friction(system: &Balanced<f64>, friction: f64) -> Result<[f64; 5], f64> {
    let below = (friction > 0.0) == (system.sin_cos_beta.1 > 0.0);
    let end = follow(system, without_friction(system, below), friction, |_| 1.0);
    let part = end.friction / friction;
    // Near the end of the branch f64 may stop short of it by rounding, and Newton's method continues from
    // there.
    if part < 1.0 - 1e-6 {
        return Err(part);
    }
    let system = Balanced { friction: end.friction, ..*system };
    let at = off_the_other_branch(end.at, below);
    Ok(on_a_grid(&system, &unknowns(&at), 96.0).map_or(at, |u| in_order(&u)))
}

/// Two cycles meet at the end of the branch, where Δ₀ = A sin ω_d t₂ passes through zero. Where f64 cannot
/// tell them apart, a Δ₀ that is small and positive is on the side of the right one.
fn off_the_other_branch(at: [f64; 5], below: bool) -> [f64; 5] {
    let sign = if below { 1.0 } else { -1.0 };
    let [t1, t2, v, d, e] = at;
    let least = 1e-6;
    let shift = if sign * d < least { sign * least - d } else { 0.0 };
    [t1, t2 + shift / Real::cos(t2), v, d + shift, e]
}

/// A cycle near the border: where the force left over at t₂ has fallen to a tenth, or the path ends before.
pub(super) fn on_the_border(system: &Balanced<f64>, sign: f64) -> [f64; 6] {
    let below = (sign > 0.0) == (system.sin_cos_beta.1 > 0.0);
    let start = without_friction(system, below);
    let excess = |p: &Point| Balanced { friction: p.friction, ..*system }.turning_point(&unknowns(&p.at));
    let whole = excess(&start);
    // More friction than any border has: the force left over is gone, or the path at its end, long before.
    let beyond = sign * 8.0 * (1.0 + system.omega).square();
    let end = follow(system, start, beyond, |p| excess(p) / whole);
    let [t1, t2, v, d, e] = end.at;
    [t1, t2, v, d, e, end.friction]
}

/// The same cycle with t₁ at the fastest point of a grid over the half cycle before t₂, and V₀ and Δ₁ the
/// velocity and the displacement there; `None` where the t₁ it has is in that half cycle, and faster.
///
/// The grid has `per_swing` points in π/ω_n and a few more. Eq. 25 alone says that the velocity is stationary
/// at t₁. In units of A, which is negative above the natural frequency.
pub(super) fn on_a_grid<F: Float>(
    system: &Balanced<F>,
    u: &Unknowns<F>,
    per_swing: f64,
) -> Option<Unknowns<F>> {
    let (given, one) = (system.given(), F::int(1));
    let upwards = one.with_sign_of(u.max_displacement);
    let velocity = |phase: F| upwards * given.rising_velocity(u, phase);
    let points = 8 + (per_swing / system.omega.to_f64()).min(1e6) as i32;
    let end = u.displacement_phase;
    let inside = u.velocity_phase < end && u.velocity_phase > end - F::pi();
    // At t₂ the velocity is zero.
    let first = if inside { u.velocity_phase } else { end };
    let mut best = (first, velocity(first));
    let threshold = best.1 + F::int(1024) * F::epsilon() * (one + one / system.omega);
    for i in 1..points {
        let phase = end - F::pi() * F::ratio(i, points);
        let here = velocity(phase);
        if here > best.1 {
            best = (phase, here);
        }
    }
    (best.1 > threshold).then(|| Unknowns {
        velocity_phase: best.0,
        max_velocity: given.rising_velocity(u, best.0),
        deviation: given.rising_displacement(u, best.0),
        ..*u
    })
}
