//! Where Newton's method starts: from the motion without friction, the friction growing to its value, at f64;
//! and the instant of peak velocity, searched on a grid.
//!
//! A path may end at a fold: then there is no cycle with that friction.

use super::Unknowns;
use super::balanced::Balanced;
use super::step::{in_order, largest, newton_step, unknowns};
use crate::float::{Float, Real};

/// A step of the path must not move t₂ further than this.
const LONGEST: f64 = 0.2;

/// The greatest number of instants that a path looks at for the fastest one, of some 0.1 µs each.
const MOST_INSTANTS: u64 = 1 << 23;

/// The instants of a search in the half cycle: so many in π/ω_n, and a few more.
fn instants<F: Float>(omega: F, per_swing: f64) -> i32 {
    8 + (per_swing / omega.to_f64()).min(2e6) as i32
}

/// Newton's method from a cycle with a little less friction: `None` where it does not settle close by.
fn settled(system: &Balanced<f64>, from: &Unknowns<f64>) -> Option<Unknowns<f64>> {
    let mut at = in_order(from);
    let scale = 1.0 + system.omega;
    let mut last = f64::INFINITY;
    for _ in 0..12 {
        let (residuals, jacobian, _) = system.equations(&unknowns(&at));
        let step = newton_step(&residuals, &jacobian)?;
        for (x, dx) in at.iter_mut().zip(&step) {
            *x -= dx;
        }
        let [t1, t2, lengths @ ..] = step;
        let size = t1.abs().max(t2.abs()).max(largest(&lengths) / scale);
        if size < 1e-11 || (size < 1e-7 && size >= last / 2.0) {
            let found = unknowns(&at);
            let close = (found.displacement_phase - from.displacement_phase).abs() <= LONGEST;
            return close.then_some(found);
        }
        last = size;
    }
    None
}

/// The instants in π/ω_n among which a path looks for the fastest one.
const PER_SWING: f64 = 32.0;

/// Follows the path to the system's friction, or to where it ends, or to where `left_over` is within a tenth of
/// zero; the steps adapt, and none goes further than that. Gives the cycle and its friction.
fn follow(
    system: &Balanced<f64>,
    left_over: impl Fn(&Balanced<f64>, &Unknowns<f64>) -> f64,
) -> (Unknowns<f64>, f64) {
    let target = system.friction;
    let (mut at, mut friction, mut length) = (system.without_friction(), 0.0, target);
    let (search, mut instants_left) =
        (instants(system.omega, PER_SWING).unsigned_abs().into(), MOST_INSTANTS);
    for _ in 0..4000 {
        let left = target - friction;
        let here = system.with_friction(friction);
        if left == 0.0 || left_over(&here, &at) < 0.1 {
            break;
        }
        let last = left <= length;
        let next = if last { target } else { friction + length };
        let there = system.with_friction(next);
        match settled(&there, &at).filter(|u| left_over(&there, u) > -0.1) {
            Some(found) => (at, friction, length) = (found, next, length * 1.5),
            // The stationary velocity at t₁ may be about to vanish, and the fastest instant be another one.
            None => {
                // Beyond the budget the path ends here, as at a fold.
                let Some(rest) = instants_left.checked_sub(search) else { break };
                instants_left = rest;
                match faster(&here, &at, PER_SWING).and_then(|u| settled(&here, &u)) {
                    Some(u) => at = u,
                    None => length = if last { left / 2.0 } else { length / 2.0 },
                }
            }
        }
        if length <= 1e-15 * target {
            break;
        }
    }
    (at, friction)
}

/// The cycle with all of its friction; the part of the friction where the path ends otherwise.
pub(super) fn with_friction(system: &Balanced<f64>) -> Result<[f64; 5], f64> {
    let (end, friction) = follow(system, |_, _| 1.0);
    let part = friction / system.friction;
    // Near the end of the branch f64 may stop short of it by rounding, and Newton's method continues from
    // there.
    if part < 1.0 - 1e-6 {
        return Err(part);
    }
    let system = system.with_friction(friction);
    let at = off_the_other_branch(end, &system.without_friction());
    Ok(in_order(&faster(&system, &at, 96.0).unwrap_or(at)))
}

/// Two cycles meet at the end of the branch, where Δ₀ passes through zero. Where f64 cannot tell them apart, a
/// Δ₀ that is small and positive is on the side of the right one.
fn off_the_other_branch(at: Unknowns<f64>, free: &Unknowns<f64>) -> Unknowns<f64> {
    let (t2, shift) = (at.displacement_phase, 1e-6 - at.max_displacement);
    if shift <= 0.0 {
        return at;
    }
    // Without friction Δ₀ would be sin(ω_d t₂ − lag).
    let slope = -Real::sin(t2 - free.displacement_phase);
    Unknowns { displacement_phase: t2 + shift / slope, max_displacement: at.max_displacement + shift, ..at }
}

/// A cycle near the border, with its friction: where the force left over at t₂ has fallen to a tenth, or the
/// path ends before. The friction of `system` is more than that of any border.
pub(super) fn on_the_border(system: &Balanced<f64>) -> [f64; 6] {
    let whole = system.with_friction(0.0).turning_point(&system.without_friction());
    let (end, friction) = follow(system, |system, u| system.turning_point(u) / whole);
    let [t1, t2, v, d, e] = in_order(&end);
    [t1, t2, v, d, e, friction]
}

/// This cycle with t₁ at the fastest point of a grid over the half cycle before t₂, and V₀ and Δ₁ the
/// velocity and the displacement there; `None` where the t₁ it has is in that half cycle, and faster.
///
/// The grid has `per_swing` points in π/ω_n and a few more. Eq. 25 alone says that the velocity is stationary
/// at t₁.
pub(super) fn faster<F: Float>(system: &Balanced<F>, u: &Unknowns<F>, per_swing: f64) -> Option<Unknowns<F>> {
    let (one, two, omega) = (F::int(1), F::int(2), system.omega);
    let points = instants(omega, per_swing);
    let end = u.displacement_phase;
    let inside = u.velocity_phase < end && u.velocity_phase > end - F::pi();
    let before = if inside { system.rising(u, u.velocity_phase).1 } else { F::int(0) };
    let size = u.max_velocity.abs().or_larger(two);
    let mut most = before + F::int(1024) * F::epsilon() * (one + one / omega) * size;
    let mut best = None;
    for i in 1..points {
        let velocity_phase = end - F::pi() * F::ratio(i, points);
        let (deviation, max_velocity) = system.rising(u, velocity_phase);
        if max_velocity > most {
            most = max_velocity;
            best = Some(Unknowns { velocity_phase, max_velocity, deviation, ..*u });
        }
    }
    best
}
