//! The points that the loops cannot compute: the library's answer at a single point.

use super::columns::LOOPED;
use crate::cycle::border::least_with_static_friction;
use crate::cycle::phase_function::PhaseFunction;
use crate::cycle::regime::has_two_reversals;
use crate::cycle::response::Response;
use crate::cycle::{Reversal, damped};
use crate::float::{Float, Task};
use crate::machine::ratios::Ratios;

/// The outputs of [`LOOPED`] at (Ω, α); NaN where one does not exist.
pub(crate) fn all(omega: f64, alpha: f64) -> [f64; LOOPED.len()] {
    Ratios::new(omega, alpha).map_or([f64::NAN; LOOPED.len()], all_of)
}

/// The outputs of [`LOOPED`]; NaN where one does not exist.
fn all_of(ratios: Ratios<f64>) -> [f64; LOOPED.len()] {
    let answer = Response::new(ratios);
    LOOPED.map(|output| output.of(&answer).unwrap_or(f64::NAN))
}

/// {Δ₀, α_min, A₁} of a point that may have a damper and static friction; NaN where one does not exist.
pub(crate) fn amplitude_of(ratios: Ratios<f64>) -> [f64; 3] {
    if ratios.is_damped() {
        return damped::amplitude(&ratios);
    }
    if ratios.has_higher_static_friction() {
        let [displacement, border, size, ..] = all_of(ratios);
        return [displacement, border, size];
    }
    f64::fused(Amplitude(ratios))
}

/// {Δ₀, α_min, A₁}, without the rest of the answer.
#[inline]
pub(crate) fn amplitude(omega: f64, alpha: f64) -> [f64; 3] {
    match Ratios::new(omega, alpha) {
        Ok(ratios) => f64::fused(Amplitude(ratios)),
        Err(_) => [f64::NAN; 3],
    }
}

struct Amplitude(Ratios<f64>);

impl Task for Amplitude {
    type Output = [f64; 3];

    #[inline(always)]
    fn run(self) -> [f64; 3] {
        let (omega, alpha) = (self.0.omega(), self.0.alpha());
        let p = PhaseFunction::of_valid(omega);
        let border = least_with_static_friction(&p, 1.0);
        if !has_two_reversals(omega, alpha, border) {
            return [f64::NAN, border, f64::NAN];
        }
        let reversal = Reversal::new(&p, alpha).of_sliding(omega);
        [reversal.max_displacement(), border, reversal.loop_size_stiffness()]
    }
}
