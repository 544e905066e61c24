//! The frequency ratio, or the stiffness, at which friction dissipates most, with a damper.
//!
//! At fixed m, c, p₀, r_y and ω_d, the energy dissipated by friction is `4 r_y Δ₀ = A₂ p₀²/(2mω_d²)` as
//! without a damper, `A₂ = 8Ω²(Δ₀/B)/α²`, with ζ = γΩ, γ = c/(2mω_d). The maximum is searched, not proved, in
//! every band: on the mesh of the bands and around each of its maxima there. At Ω = 1 it is finite.

use super::super::band::{Band, Edge};
use super::super::optimum::{Optimum, OptimumKind};
use super::{Damper, Search, highest};
use crate::error::{Error, Number, written};
use crate::float::Float;
use crate::nonsticking::damped::half_period_at;
use crate::nonsticking::{loop_size_inertia, loop_size_stiffness, max_displacement};

/// The Ω in `[low, high]` with the largest A₂ among the bands, for the given damper.
///
/// # Errors
/// [`Error::SticksThroughout`] where there is no band.
pub(in crate::design) fn best_frequency_ratio<F: Float>(
    alpha: F,
    damper: Damper<F>,
    low: F,
    high: F,
) -> Result<Optimum<F>, Error> {
    let mut search = Search::new(alpha, damper, low, high);
    let mut best: Option<Optimum<F>> = None;
    for band in search.by_ref() {
        let found = best_of_band(alpha, damper, &band);
        if best.is_none_or(|best| found.value > best.value) {
            best = Some(found);
        }
    }
    best.ok_or_else(|| Error::SticksThroughout {
        alpha: written(alpha),
        least: search.least().map_or_else(|| Number::spelled(f64::NAN, "1/Ω² − 1"), written),
        low: written(low),
        high: written(high),
    })
}

/// A₂ at Ω, where the body does not stick.
fn loop_size<F: Float>(alpha: F, damper: Damper<F>, omega: F) -> F {
    let half = half_period_at(omega, damper.ratio(omega));
    let displacement = max_displacement(half.k, alpha, half.stiffness) - half.shift;
    loop_size_inertia(loop_size_stiffness(displacement, alpha), omega)
}

/// The largest A₂ of one band: at an end, or at a maximum between points of the mesh.
fn best_of_band<F: Float>(alpha: F, damper: Damper<F>, band: &Band<F>) -> Optimum<F> {
    let size = |omega: F| loop_size(alpha, damper, omega);
    let at_end = |omega: F, edge: Edge| Optimum {
        at: omega,
        value: size(omega),
        kind: if edge == Edge::Border { OptimumKind::Border } else { OptimumKind::RangeEnd },
    };
    let (first, last) = (at_end(band.low, band.low_edge), at_end(band.high, band.high_edge));
    let mut best = if last.value > first.value { last } else { first };
    let (mut before, mut middle) = ((band.low, first.value), (band.low, first.value));
    while middle.0 < band.high {
        let next = damper.next(middle.0);
        let next = if next < band.high { next } else { band.high };
        let here = (next, size(next));
        if middle.1 >= before.1 && middle.1 >= here.1 && middle.0 > band.low {
            let omega = highest(before.0, next, size, |_| false);
            let found = Optimum { at: omega, value: size(omega), kind: OptimumKind::Interior };
            if found.value > best.value {
                best = found;
            }
        }
        (before, middle) = (middle, here);
    }
    best
}
