//! One step of Householder's third-order method towards the peak velocity.

use super::Fastest;
use crate::cycle::half_cycle::{HalfCycle, VelocityJet};
use crate::float::Float;

/// A step h is the last where the error it leaves, of the order h⁴, is below rounding; h in the angle of the
/// faster wave.
#[inline]
pub(super) fn is_final<F: Float>(half: &HalfCycle<F>, step: F) -> bool {
    let step = step * half.omega().or_larger(F::int(1));
    step.square().square() * F::int(64) <= F::epsilon()
}

/// The point a final step arrives at; the velocity there by Taylor's formula to the third order.
#[inline]
pub(super) fn arrive<F: Float>(jet: &VelocityJet<F>, psi: F, step: F) -> Fastest<F> {
    let cubic = jet.third * step / F::int(3) + jet.second;
    let velocity = jet.value + step * (jet.first + step / F::int(2) * cubic);
    Fastest { psi, velocity }
}

/// The step of Householder's third-order method on v′ = 0.
#[inline]
pub(super) fn householder<F: Float>(jet: &VelocityJet<F>) -> F {
    let inverse = F::int(1) / jet.second;
    let newton = -(jet.first * inverse);
    let curvature = jet.third * inverse * newton;
    let bend = jet.fourth * inverse * newton.square() / F::int(6);
    newton * (F::int(1) + curvature / F::int(2)) / (F::int(1) + curvature + bend)
}
