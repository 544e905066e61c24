//! The instant of maximum velocity of a half cycle, searched on a grid.

use super::Unknowns;
use super::balanced::Balanced;
use crate::float::Float;

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
