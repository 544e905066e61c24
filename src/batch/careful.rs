//! What the loops leave: the library's own answer at one point.

use crate::nonsticking::{Border, Reversal};
use crate::phase_function::PhaseFunction;
use crate::ratios::Ratios;
use crate::regime::has_two_reversals;
use crate::response::Response;

/// {Δ₀, ω_d t₂, V₀, ω_d t₁, Δ₁, α_min, λ, A₁, A₂} at (Ω, α): NaN what does not exist.
pub(crate) fn all(omega: f64, alpha: f64) -> [f64; 9] {
    let nan = f64::NAN;
    let Ok(ratios) = Ratios::new(omega, alpha) else { return [nan; 9] };
    let answer = Response::new(ratios);
    let border = answer.border().min_force_ratio();
    match answer.cycle() {
        None => [nan, nan, nan, nan, nan, border, nan, nan, nan],
        Some(cycle) => [
            cycle.max_displacement(),
            cycle.displacement_phase(),
            cycle.max_velocity(),
            cycle.velocity_phase(),
            cycle.deviation(),
            border,
            cycle.contraction(),
            cycle.loop_size_stiffness(),
            cycle.loop_size_inertia(),
        ],
    }
}

/// {Δ₀, α_min, A₁}: without what the whole answer has besides.
pub(crate) fn triple(omega: f64, alpha: f64) -> [f64; 3] {
    let nan = f64::NAN;
    let Ok(ratios) = Ratios::new(omega, alpha) else { return [nan; 3] };
    let p = PhaseFunction::of_valid(ratios.omega());
    let border = Border::least_force_ratio(&p);
    if !has_two_reversals(omega, alpha, border) {
        return [nan, border, nan];
    }
    let reversal = Reversal::new(&p, alpha).of_sliding(omega);
    [reversal.max_displacement(), border, reversal.loop_size_stiffness()]
}

/// {Δ₀, α_min, A₁, V₀, ω_d t₁}.
pub(crate) fn peaks(omega: f64, alpha: f64) -> [f64; 5] {
    let [displacement, _, velocity, phase, _, border, _, size, _] = all(omega, alpha);
    [displacement, border, size, velocity, phase]
}
