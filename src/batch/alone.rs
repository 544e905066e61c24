//! The points that the loops cannot compute: the library's answer at a single point.

use super::columns::LOOPED;
use crate::cycle::response;
use crate::cycle::response::Response;
use crate::machine::ratios::Ratios;

/// The outputs of [`LOOPED`] at a point; NaN where one does not exist.
pub(crate) fn all(ratios: Option<Ratios<f64>>) -> [f64; LOOPED.len()] {
    ratios.map_or([f64::NAN; LOOPED.len()], |ratios| {
        let answer = Response::new(ratios);
        LOOPED.map(|output| output.of(&answer).unwrap_or(f64::NAN))
    })
}

/// {Δ₀, α_min, A₁}, without the rest of the answer.
#[inline]
pub(crate) fn amplitude(ratios: Option<Ratios<f64>>) -> [f64; 3] {
    ratios.map_or([f64::NAN; 3], response::amplitude)
}
