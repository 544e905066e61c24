//! The instants at which a displacement or a velocity passes a value.
//!
//! Over a stretch the quantity less the value is a polynomial with an error bound. From a certain sign on it has passed where it is certainly
//! of the other sign: at the zero before that place. A touch that rounding cannot tell from a passage is none, and neither is a start at the
//! value.

use super::assembly::Assembly;
use super::branch::polynomial;
use super::events::{Event, EventKind, Stretch};
use super::first_passage::{first_passage, integer};
use super::follow::shorten;
use super::matrix::{add_times, size_of_dot};
use crate::float::Float;
use alloc::vec;
use alloc::vec::Vec;

/// On which side of its value each quantity is.
pub(crate) struct Sides {
    /// None as long as it is not certain.
    above: Vec<Option<bool>>,
}

impl Sides {
    pub(crate) fn new<F>(system: &Assembly<F>) -> Self {
        Self { above: vec![None; system.levels.len()] }
    }

    /// Adds the passages in a stretch, whose Taylor terms are known, in the order of time.
    pub(crate) fn pass<F: Float>(
        &mut self,
        system: &Assembly<F>,
        stretch: &Stretch<'_, F>,
        terms: &[F],
        events: &mut Vec<Event<F>>,
    ) {
        let first = events.len();
        for (i, (row, above)) in system.levels.iter().zip(&mut self.above).enumerate() {
            let mut c = polynomial(row, terms);
            let size =
                terms.chunks_exact(system.size.max(1)).fold(F::int(0), |sum, z| sum + size_of_dot(row, z));
            let error = size * F::epsilon() * integer(system.size);
            if !(error.is_finite() && c.iter().all(|c| c.is_finite())) {
                continue;
            }
            shorten(&mut c, error);
            let (mut begin, mut length) = (F::int(0), F::int(1));
            let falls = |c: &[F]| first_passage(c, error);
            let rises = |c: &[F]| first_passage(&c.iter().map(|&c| -c).collect::<Vec<_>>(), error);
            if above.is_none() {
                *above = match (falls(&c), rises(&c)) {
                    (None, None) => None,
                    (Some(_), None) => Some(false),
                    (None, Some(_)) => Some(true),
                    (Some(down), Some(up)) => Some(up < down),
                };
            }
            // Each passage is at a zero of the polynomial.
            for _ in 0..c.len() {
                let Some(side) = *above else { break };
                let Some(at) = (if side { falls(&c) } else { rises(&c) }) else { break };
                begin = begin + length * at;
                length = length * (F::int(1) - at);
                *above = Some(!side);
                let kind = if side { EventKind::Fall } else { EventKind::Rise };
                let time = stretch.at + stretch.time * begin;
                let element = system.parts.len() + i;
                events.push(Event { time, element, kind, velocities: None });
                if length <= F::int(0) {
                    break;
                }
                c = shifted(&c, at);
            }
        }
        if let Some(new) = events.get_mut(first..) {
            new.sort_by(|a, b| a.time.partial_cmp(&b.time).unwrap_or(core::cmp::Ordering::Equal));
        }
    }
}

/// The polynomial `p(a + (1 − a) s)`.
fn shifted<F: Float>(c: &[F], a: F) -> Vec<F> {
    // Horner's scheme on polynomials.
    let mut result = vec![F::int(0); c.len()];
    for &c in c.iter().rev() {
        let times = result.clone();
        result.iter_mut().for_each(|x| *x = *x * a);
        add_times(result.get_mut(1..).unwrap_or(&mut []), F::int(1) - a, &times);
        if let Some(constant) = result.first_mut() {
            *constant = *constant + c;
        }
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shifted_polynomial_has_the_same_values() {
        let c = [1.0, -3.0, 0.5, 2.0];
        let value = |c: &[f64], s: f64| c.iter().rev().fold(0.0, |sum, c| sum * s + c);
        let moved = shifted(&c, 0.3);
        for s in [0.0, 0.2, 1.0] {
            assert!((value(&moved, s) - value(&c, 0.3 + 0.7 * s)).abs() < 1e-15);
        }
    }
}
