//! Curves over Ω, resolved at their resonances.

use core::convert::Infallible;
use stickslip_front::curve::resolved;

/// A curve over Ω, with these places of resonance among its points and resolved there.
pub(super) fn resonant(
    omegas: impl Iterator<Item = f64>,
    resonances: &[f64],
    of: impl Fn(f64) -> f64,
) -> Vec<(f64, f64)> {
    let mut omegas: Vec<f64> = omegas.chain(resonances.iter().copied()).collect();
    omegas.sort_by(f64::total_cmp);
    let points: Vec<(f64, f64)> = omegas.into_iter().map(|omega| (omega, of(omega))).collect();
    let Ok::<_, Infallible>(all) =
        resolved(&points, false, |&point| point, |_| false, |omega| Ok((omega, of(omega))));
    all.into_iter().map(|(point, _)| point).collect()
}
