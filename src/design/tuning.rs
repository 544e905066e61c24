//! The stiffness that dissipates most under a given force.
//!
//! At fixed m, p₀, r_y and ω_d the energy `4 r_y Δ₀` is A₂ p₀²/(2 m ω_d²) (eq. 67), and with v = 1/Ω²
//!
//! ```text
//! A₂ = (8/α²) √D,   D = (α² − K²)/(v − 1)² = (α/(v − 1))² − T²/v.
//! ```
//!
//! **In each lobe of the border A₂ has one maximum and no minimum.** The best point of a band is therefore
//! that maximum if the band contains it, and otherwise the end next to it:
//!
//! * v < 1 (Ω > 1): K² falls with v and 1/(1 − v)² rises: D rises.
//! * (2n)² < v < (2n+1)², n ≥ 1: T²/v rises and (α/(v − 1))² falls: D falls.
//! * (2n+1)² < v < (2n+2)²: D′ = 0 is `α² = φ(v)`, `φ = −½(v − 1)³ (T²/v)′`, D rising where φ > α². For
//!   n ≥ 1, with u = √v, t = |T|, `φ = (u² − 1)³ [π t (1 + t²) u + 2t²]/(4u⁴)`, and both terms fall with u:
//!   `6u/(u² − 1) − 3/u < π√3 ≤ (π/2)(1/t + 3t)`. For n = 0, with κ = −K of the border's lobes,
//!   `φ = κ² − κκ′(v − 1)` and `φ′ = κκ′ − (v − 1)(κ′² + κκ″) < 0`, because (v − 1)|κ″| < |κ′| up to
//!   v = 11/3, and (v − 1) κ′² is more than the rest beyond. There φ falls from (4/π)² at v = 1 to 0 at
//!   v = 4.
//!
//! For α > 4/π the maximum of lobe 0 is at Ω = 1, where A₂ is infinite. In lobe n ≥ 1, A₂ < 8/(α (v − 1)) <
//! 2/(α n(n + 1)): lobes whose bound is below the best value found are skipped.

use super::band::{Band, Edge};
use super::bands::{band_in, bands};
use super::damped::{Damper, best_frequency_ratio};
use super::optimum::{Optimum, OptimumKind};
use crate::error::{Error, Quantity, written};
use crate::float::Float;
use crate::nonsticking::border::{Lobe, border_range, ordered_lobes};
use crate::nonsticking::{loop_size_inertia, loop_size_stiffness, max_displacement, squared_sine};
use crate::oscillator::{Drive, Oscillator};
use crate::phase_function::{PhaseFunction, one_minus_square};
use crate::ratios::{Ratios, positive};
use crate::root;

/// The Ω in `[low, high]` that makes A₂ largest at the force ratio α without sticking.
///
/// It is the global maximum: each band of the range has one candidate (see the module's documentation).
/// Accuracy at f64: 16 ulp in A₂; for an interior optimum, Ω is accurate as a root of the derivative, to
/// 1e-15.
///
/// # Errors
/// [`Error::SticksThroughout`] where there is no such Ω, [`Error::AtResonance`] where α > 4/π and the range
/// contains Ω = 1, at which A₂ is infinite, and as [`bands`].
pub fn most_dissipating_frequency_ratio<F: Float>(alpha: F, low: F, high: F) -> Result<Optimum<F>, Error> {
    bands(alpha, F::int(0), low, high)?;
    let lowest = low.or_larger(Lobe::new(u16::MAX).low_pole());
    let (first, last) = ordered_lobes(lowest, high)?;
    let mut best: Option<Optimum<F>> = None;
    let mut next = Some(last);
    while let Some(lobe) = next {
        let n = F::int(i32::from(lobe.index()));
        let is_beaten =
            |found: Optimum<F>| n > F::int(0) && found.value * alpha * n * (n + F::int(1)) > F::int(2);
        // No band exists below the pole of a lobe that α cannot reach.
        if best.is_some_and(is_beaten) || alpha < F::int(4) * n * (n + F::int(1)) {
            break;
        }
        if let Some(band) = band_in(lobe, alpha, low, high)? {
            let found = best_of_band(alpha, &band)?;
            if best.is_none_or(|best| found.value > best.value) {
                best = Some(found);
            }
        }
        next = if lobe == first { None } else { lobe.below() };
    }
    match best {
        Some(best) => Ok(best),
        None => Err(Error::SticksThroughout {
            alpha: written(alpha),
            least: written(border_range(lowest, high)?.least),
            low: written(low),
            high: written(high),
        }),
    }
}

/// The largest A₂ of one band.
fn best_of_band<F: Float>(alpha: F, band: &Band<F>) -> Result<Optimum<F>, Error> {
    let (zero, one) = (F::int(0), F::int(1));
    if band.low <= one && band.high >= one {
        return Err(Error::AtResonance { quantity: Quantity::LoopSizeInertia });
    }
    let rises = |omega| growth(alpha, omega);
    let at_end = |edge| if edge == Edge::Border { OptimumKind::Border } else { OptimumKind::RangeEnd };
    let (omega, optimum) = if band.low > one || rises(band.low) <= zero {
        (band.low, at_end(band.low_edge))
    } else if rises(band.high) >= zero {
        (band.high, at_end(band.high_edge))
    } else {
        (root::enclosed(band.low, band.high, rises).0, OptimumKind::Interior)
    };
    let p = PhaseFunction::of_valid(omega);
    let displacement = max_displacement(p.value(), alpha, one_minus_square(omega));
    let loop_size = loop_size_inertia(loop_size_stiffness(displacement, alpha), omega);
    Ok(Optimum { at: omega, value: loop_size, kind: optimum })
}

/// `2(α² − K²) − Ω(1 − Ω²) K K′`, which has the sign of dA₂/dΩ for Ω < 1.
fn growth<F: Float>(alpha: F, omega: F) -> F {
    let p = PhaseFunction::of_valid(omega);
    let k = p.value();
    F::int(2) * squared_sine(k, alpha) - omega * one_minus_square(omega) * (k * p.slope())
}

/// The stiffness k in `[low, high]` with which the force of `drive` dissipates most in a cycle without
/// sticking.
///
/// Mass, friction bound and damping constant c are those of `body`; its own stiffness plays no part.
/// [`most_dissipating_frequency_ratio`] in physical units: `k = m ω_d²/Ω²`. With a damper it maximises the
/// energy dissipated by friction, and is searched, not proved (`src/design/damped.rs`).
///
/// # Errors
/// As there (except that with a damper there is an answer at Ω = 1); [`Error::BaseMotion`], because the force
/// of a base motion, k u_g0, is not fixed; and where a stiffness is not finite, not > 0 or `low > high`.
pub fn most_dissipating_stiffness<F: Float>(
    body: &Oscillator<F>,
    drive: &Drive<F>,
    low: F,
    high: F,
) -> Result<Optimum<F>, Error> {
    if drive.excitation().moves_foot() {
        return Err(Error::BaseMotion);
    }
    body.with_one_friction()?;
    let frequency = drive.angular_frequency();
    let inertia = positive(Quantity::PseudoStiffness, body.mass() * frequency.square())?;
    let (soft, hard) = (positive(Quantity::Stiffness, low)?, positive(Quantity::Stiffness, high)?);
    if soft > hard {
        let (low, high) = (written(low), written(high));
        return Err(Error::EmptyRange { quantity: Quantity::Stiffness, low, high });
    }
    let p0 = drive.force_amplitude(body);
    let alpha = positive(Quantity::ForceRatio, p0 / body.friction_bound())?;
    let omega = |stiffness: F| (inertia / stiffness).sqrt();
    let best = if body.damping() > F::int(0) {
        // ζ = γΩ must be in its domain at both ends.
        let gamma = body.damping() / (F::int(2) * body.mass() * frequency);
        for omega in [omega(hard), omega(soft)] {
            Ratios::new(omega, alpha)?.with_damping_ratio(gamma * omega)?;
        }
        best_frequency_ratio(alpha, Damper::Constant(gamma), omega(hard), omega(soft))?
    } else {
        most_dissipating_frequency_ratio(alpha, omega(hard), omega(soft))?
    };
    let stiffness = if best.at == omega(hard) {
        hard
    } else if best.at == omega(soft) {
        soft
    } else {
        inertia / best.at.square()
    };
    let energy = best.value * (p0 / F::int(2) * (p0 / inertia));
    Ok(Optimum {
        at: positive(Quantity::Stiffness, stiffness)?,
        value: positive(Quantity::PseudoStaticEnergy, energy)?,
        kind: best.kind,
    })
}

#[cfg(test)]
mod tests;
