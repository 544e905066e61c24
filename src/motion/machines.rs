//! In tests: machines by their four ratios, and starts spread over the plane.

use crate::Ratios;
use crate::motion::State;

/// The machine at (Ω, ζ, η, α).
pub(super) fn ratios(omega: f64, zeta: f64, eta: f64, alpha: f64) -> Ratios<f64> {
    let ratios = Ratios::new(omega, alpha).unwrap().with_damping_ratio(zeta).unwrap();
    ratios.with_static_friction_ratio(eta).unwrap()
}

/// Starts at phase 0 with |x| and |v| below `reach`, by the multiples of two irrational numbers.
pub(super) fn starts(count: u32, reach: f64) -> Vec<State<f64>> {
    let part = |i: u32, step: f64| reach * (2.0 * (f64::from(i) * step).fract() - 1.0);
    (0..count).map(|i| State::new(0.0, part(i, 0.754_878), part(i, 0.569_841)).unwrap()).collect()
}
