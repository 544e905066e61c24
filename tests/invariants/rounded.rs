//! f64 compared with 512 bits: a result at f64 is the exact value, rounded, to within its documented error.

#![allow(dead_code, reason = "the fuzz target and the tests take what they need")]

use stickslip::float::Mp;
use stickslip::{Border, Field as _, Float as _, PhaseFunction};

/// 512 bits.
type Exact = Mp<8>;

/// The documented accuracy of the border and of K at f64, relative.
const ACCURACY: f64 = 1e-14;

/// The error of `ours` relative to `exact`.
fn error(ours: f64, exact: Exact) -> f64 {
    if exact == Exact::ZERO { ours.abs() } else { ((Exact::from(ours) - exact) / exact).abs().to_f64() }
}

/// The quantities that depend on Ω alone.
///
/// # Panics
///
/// If a value at f64 differs from that at 512 bits by more than its accuracy; the fuzzer reports this as a
/// finding.
pub(crate) fn borders(omega: f64) {
    let Ok(p) = PhaseFunction::new(omega) else {
        assert!(Border::new(omega).is_err());
        return;
    };
    let exact_p = PhaseFunction::new(Exact::from(omega)).unwrap();
    let (ours, exact) = (Border::new(omega).unwrap(), Border::new(Exact::from(omega)).unwrap());
    let close = |name: &str, ours: f64, exact: Exact| {
        assert!(ours.is_finite(), "{name} at Ω = {omega:e}: {ours:e}");
        let error = error(ours, exact);
        assert!(
            error <= ACCURACY,
            "{name} at Ω = {omega:e}: {ours:e} for {:e}, off by {error:e}",
            exact.to_f64()
        );
    };
    close("K", p.value(), exact_p.value());
    close("α_min", ours.min_force_ratio, exact.min_force_ratio);
    close("eq. 61", ours.min_force_ratio_turning_point, exact.min_force_ratio_turning_point);
    close("S", ours.least_displacement, exact.least_displacement);
    // Where the two values of S coincide, the phase may be that of either.
    if (exact.min_force_ratio - exact.min_force_ratio_turning_point).to_f64()
        > ACCURACY * exact.min_force_ratio_turning_point.to_f64()
    {
        let apart = (Exact::from(ours.border_phase) - exact.border_phase).abs().to_f64();
        // The supremum is flat there, so that the phase is less accurate near a pole or a zero of T.
        assert!(
            apart <= 1e-6 || ours.border_phase.min(std::f64::consts::PI - ours.border_phase) < 1e-6,
            "τ* at Ω = {omega:e}"
        );
    }
    assert!(Exact::pi() > Exact::from(ours.border_phase));
}
