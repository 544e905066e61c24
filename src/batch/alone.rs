//! The points that the loops leave: the library's own answer at one point.

use super::columns::LOOPED;
use crate::nonsticking::{Border, Reversal};
use crate::phase_function::PhaseFunction;
use crate::ratios::Ratios;
use crate::regime::has_two_reversals;
use crate::response::Response;

/// The outputs of [`LOOPED`] at (Ω, α): NaN where one does not exist.
pub(crate) fn all(omega: f64, alpha: f64) -> [f64; LOOPED.len()] {
    let Ok(ratios) = Ratios::new(omega, alpha) else { return [f64::NAN; LOOPED.len()] };
    let answer = Response::new(ratios);
    LOOPED.map(|output| output.of(&answer).unwrap_or(f64::NAN))
}

/// {Δ₀, α_min, A₁}, without the rest of the answer.
pub(crate) fn amplitude(omega: f64, alpha: f64) -> [f64; LOOPED.len()] {
    let nan = f64::NAN;
    let mut found = [nan; LOOPED.len()];
    let Ok(ratios) = Ratios::new(omega, alpha) else { return found };
    let p = PhaseFunction::of_valid(ratios.omega());
    let border = Border::least_force_ratio(&p);
    let slides = has_two_reversals(omega, alpha, border);
    let reversal = slides.then(|| Reversal::new(&p, alpha).of_sliding(omega));
    let of_cycle = |value: fn(&Reversal<f64>) -> f64| reversal.as_ref().map_or(nan, value);
    let three = [of_cycle(Reversal::max_displacement), border, of_cycle(Reversal::loop_size_stiffness)];
    for (slot, value) in found.iter_mut().zip(three) {
        *slot = value;
    }
    found
}
