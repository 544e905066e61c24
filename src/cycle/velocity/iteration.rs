//! The peak velocity by iteration: Householder's third-order steps from the centre, from a bracketed root
//! at f64, or from a start at a lower precision.

use super::centre::from_centre;
use super::step::{arrive, householder, is_final};
use super::{Fastest, fastest};
use crate::cycle::displacement::squared_sine;
use crate::cycle::half_cycle::{HalfCycle, VelocityJet};
use crate::cycle::phase_function::PhaseFunction;
use crate::float::{Field, Float, Real, at_precision};
use crate::root;

/// The peak velocity by iteration, and (sin, cos) of its ψ where that is known.
#[inline(never)]
pub(super) fn from_centre_or_afar<F: Float>(
    half: &HalfCycle<F>,
    k: F,
    alpha: F,
) -> (Fastest<F>, Option<(F, F)>) {
    let centred = if half.omega() >= F::ratio(1, 2) { from_centre(half) } else { None };
    match centred {
        Some((found, at)) => (found, Some(at)),
        None => (from_afar(half.omega(), half.max_displacement(), k, alpha), None),
    }
}

/// [`fastest()`] and x/B there, from a start at a lower precision. The displacement takes no circular functions
/// of its own, which are the cost at high precision.
pub(super) fn fastest_and_displacement<F: Float>(half: &HalfCycle<F>, k: F, alpha: F) -> (Fastest<F>, F) {
    polish(half, start(half.in_range(), k, alpha))
}

/// Householder steps from the bracketed root.
///
/// Takes numbers and builds the half cycle again, so that the common path keeps its own in registers.
#[inline(never)]
fn from_afar<F: Float>(omega: F, max_displacement: F, k: F, alpha: F) -> Fastest<F> {
    let half = HalfCycle::new(&PhaseFunction::of_valid(omega), max_displacement);
    let start = from_bracket(&half.map(F::to_f64), k.to_f64(), alpha.to_f64());
    polish(&half, F::from_f64(start)).0
}

/// The ψ of the peak velocity at a lower precision.
fn start<F: Float>(half: HalfCycle<F>, k: F, alpha: F) -> F {
    at_precision!(narrowed, <F>(half: HalfCycle<F>, k: F, alpha: F) -> F, |there, back: G| {
        let (half, k, alpha) = (half.map(&there), there(k), there(alpha));
        if const { G::PRECISION > f64::MANTISSA_DIGITS } {
            return back(fastest(&half, k, alpha).psi);
        }
        // Not by `from_afar`: built again from an Ω rounded to f64, the half cycle would lose its distance
        // from a pole of K.
        let centred =
            if half.omega() >= G::ratio(1, 2) { from_centre(&half).map(|(found, _)| found) } else { None };
        let bracketed =
            || polish(&half, G::from_f64(from_bracket(&half.map(G::to_f64), k.to_f64(), alpha.to_f64()))).0;
        back(centred.unwrap_or_else(bracketed).psi)
    })
}

/// Householder steps from a start that is already good: `log₄(PRECISION)` of them, or until one is final;
/// with the displacement there.
fn polish<F: Float>(half: &HalfCycle<F>, start: F) -> (Fastest<F>, F) {
    let mut psi = start;
    let mut angles = half.angles(psi);
    let mut jet = half.velocity_of(&angles);
    for _ in 0..F::precision().ilog2() {
        let step = householder(&jet);
        if !step.is_finite() {
            break;
        }
        psi = psi + step;
        if is_final(half, step) {
            return (arrive(&jet, psi, step), slide(half.displacement_of(&angles), half.omega(), &jet, step));
        }
        angles = half.angles(psi);
        jet = half.velocity_of(&angles);
    }
    (Fastest { psi, velocity: jet.value }, half.displacement_of(&angles))
}

/// The displacement a step from `x`, dx/dψ = −Ωv, by Taylor's formula to the fourth order.
fn slide<F: Float>(x: F, omega: F, jet: &VelocityJet<F>, step: F) -> F {
    let third = jet.second + jet.third * step / F::int(4);
    let second = jet.first + third * step / F::int(3);
    x - omega * step * (jet.value + second * step / F::int(2))
}

/// The root of v′ in the bracket of the module's head, at f64.
#[cold]
pub(super) fn from_bracket(half: &HalfCycle<f64>, k: f64, alpha: f64) -> f64 {
    use core::f64::consts::{FRAC_PI_2, TAU};
    let omega = half.omega();
    // asin(K/α) as atan2(K, √(α² − K²))
    let angle = Real::atan2(k, Field::sqrt(squared_sine(k, alpha).or_larger(0.0)));
    let centre = if half.is_below_one() { -angle } else { angle } / omega;
    let crest = FRAC_PI_2.with_sign_of(half.cos_beta());
    let crest = crest + TAU * ((centre - crest) / TAU).round();
    let end = if half.is_below_one() { crest } else { FRAC_PI_2 / omega };
    let slope = |psi: f64| half.velocity(psi).first;
    // Half a turn from the crest ψ_c is a minimum between two equal maxima, where v′ has no sign but by
    // rounding: the half of the bracket with the maximum is told by v′ a quarter turn from the crest.
    let quarter = end + FRAC_PI_2.with_sign_of(centre - end);
    let start =
        if half.is_below_one() && (end - centre).abs() > FRAC_PI_2 && slope(quarter) * (end - centre) > 0.0 {
            quarter
        } else {
            centre
        };
    root::bracketed(start.min(end), start.max(end), slope)
}
