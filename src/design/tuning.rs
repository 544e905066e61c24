//! The stiffness that dissipates most under a given force.
//!
//! At fixed m, c, p₀, r_y and ω_d the energy `4 r_y Δ₀` that friction dissipates in a cycle is A₂ p₀²/(2 m
//! ω_d²) (eq. 67), a function of `v = k/(mω_d²) = 1/Ω²` alone. In each band of frequencies in which the body
//! slides its greatest value is proved, with and without a damper ([`work`]). The bands are proved without a
//! damper and searched with one ([`super::frequency_bands`]).
//!
//! Bands are taken from high frequencies to low ones, a part of the range at a time: below the resonance A₂ is at most
//! `8/(α √((v − 1)² + 4γ²))`, which falls with Ω, so that the rest is skipped once the bound is below the best
//! value found. Without a damper and for α > 4/π A₂ is infinite at Ω = 1.

mod span;
mod work;

use super::band::{Band, Edge};
use super::bands::{bands, bands_with};
use super::damped::Damper;
use super::optimum::{Optimum, OptimumKind};
use crate::Cycle;
use crate::cycle::border::{Lobe, border_range};
use crate::float::Float;
use crate::machine::error::{Error, Number, Quantity, written};
use crate::machine::oscillator::{Drive, Oscillator};
use crate::machine::ratios::{Ratios, positive};
use core::ops::RangeInclusive;
use work::FrictionWork;

/// The number of harmonics of the friction, even ones included, whose resonances lie in the first part of the
/// range; each further part has twice as many.
const HARMONICS: i32 = 64;

/// Ω of [`most_dissipating_stiffness`] with m = r_y = ω_d = 1 under a force of amplitude α, and A₂; its errors name ratios.
pub fn most_dissipating_frequency_ratio<F: Float>(
    alpha: F,
    range: RangeInclusive<F>,
) -> Result<Optimum<F>, Error> {
    let (low, high) = range.into_inner();
    let none = F::int(0);
    bands(alpha, none, low..=high)?;
    let mut best = best_frequency_ratio(alpha, none, low.or_larger(Lobe::new(u16::MAX).low_pole()), high);
    if let Err(Error::SticksThroughout { low: named, .. }) = &mut best {
        *named = written(low);
    }
    best
}

/// The Ω in a valid range that makes A₂ largest without sticking, with the damping constant `γ = c/(2mω_d) ≥
/// 0`.
fn best_frequency_ratio<F: Float>(alpha: F, gamma: F, low: F, high: F) -> Result<Optimum<F>, Error> {
    let (one, two) = (F::int(1), F::int(2));
    let work = FrictionWork::new(alpha, gamma);
    let mut best: Option<Optimum<F>> = None;
    let mut least: Option<F> = None;
    let (mut top, mut harmonics) = (high, F::int(HARMONICS));
    loop {
        let stiffness = one / top.square();
        let is_beaten =
            |best: Optimum<F>| work.most_within(stiffness, stiffness) <= work_of(best.value, alpha);
        if stiffness > one && (stiffness - one > alpha || best.is_some_and(is_beaten)) {
            break;
        }
        let bottom = low.or_larger(top / two).or_larger(one / (one / top + harmonics));
        // A part narrower than the rounding is merged with the rest.
        let bottom = if bottom < top { bottom } else { low };
        harmonics = two * harmonics;
        let mut found = bands_with(alpha, Damper::Constant(gamma), bottom, top)?;
        for band in found.by_ref() {
            best = best_of_band(&work, alpha, gamma, (low, high), &band?, best)?;
        }
        if let Some(here) = found.least() {
            least = Some(least.map_or(here, |old| if here < old { here } else { old }));
        }
        if bottom <= low {
            break;
        }
        top = bottom;
    }
    match best {
        Some(best) => Ok(best),
        None => Err(Error::SticksThroughout {
            alpha: written(alpha),
            least: match least {
                Some(least) => written(least),
                None if gamma > F::int(0) => {
                    Number::spelled((one / high.square() - one).to_f64(), "1/Ω² − 1")
                }
                None => written(border_range(low, high)?.least),
            },
            low: written(low),
            high: written(high),
        }),
    }
}

/// The amplitude `Y = A₂ α²/8` of the friction's work.
fn work_of<F: Float>(loop_size: F, alpha: F) -> F {
    loop_size * alpha * (alpha / F::int(8))
}

/// The larger of the largest A₂ of one band and the `best` so far.
fn best_of_band<F: Float>(
    work: &FrictionWork<F>,
    alpha: F,
    gamma: F,
    (low, high): (F, F),
    band: &Band<F>,
    best: Option<Optimum<F>>,
) -> Result<Option<Optimum<F>>, Error> {
    let one = F::int(1);
    if gamma == F::int(0) && band.low <= one && band.high >= one {
        return Err(Error::AtResonance { quantity: Quantity::LoopSizeInertia });
    }
    let (soft, hard) = (one / band.high.square(), one / band.low.square());
    let mut best = best;
    let mut consider = |omega: F, kind: OptimumKind| -> Result<Option<F>, Error> {
        let cycle = Cycle::new(Ratios::new(omega, alpha)?.with_damping_ratio(gamma * omega)?)?;
        let value = positive(Quantity::LoopSizeInertia, cycle.loop_size_inertia())?;
        let found = Optimum { at: omega, value, kind };
        if best.is_none_or(|best| found.value > best.value) {
            best = Some(found);
        }
        Ok(best.map(|best| best.value))
    };
    let at_end = |omega: F, edge: Edge| match edge {
        Edge::Border => OptimumKind::Border,
        Edge::Range if omega > low && omega < high => OptimumKind::Interior,
        Edge::Range => OptimumKind::RangeEnd,
    };
    consider(band.low, at_end(band.low, band.low_edge))?;
    let least = consider(band.high, at_end(band.high, band.high_edge))?.unwrap_or(F::int(0));
    if let Some(v) = work.improved(soft, hard, work_of(least, alpha))? {
        let omega = one / v.sqrt();
        if omega > band.low && omega < band.high {
            consider(omega, OptimumKind::Interior)?;
        }
    }
    Ok(best)
}

/// The stiffness k in `[low, high]` with which the force of `drive` dissipates most in a cycle without
/// sticking, and the energy.
///
/// Mass, friction force and damping constant c are those of `body`; its own stiffness plays no part.
/// `k = m ω_d²/Ω²` with the Ω that makes A₂ largest. With a damper the stiffness maximises the energy dissipated by friction.
/// It is proved to be the best of each band of stiffness in which the body slides (see the module's documentation); the bands
/// themselves are proved without a damper, and searched with one ([`super::frequency_bands`]). Accuracy at f64: 16 ulp in A₂;
/// for an interior optimum, Ω is accurate as a root of the derivative, to 1e-15.
///
/// # Errors
/// [`Error::SticksThroughout`] where there is no such stiffness, [`Error::AtResonance`] where α > 4/π and the range
/// contains Ω = 1 without a damper, at which A₂ is infinite, and those of [`super::frequency_bands`];
/// [`Error::BaseMotion`], because the force of a moving support, k u_g0, is not fixed; and where a stiffness is
/// not finite, not > 0 or `low > high`.
pub fn most_dissipating_stiffness<F: Float>(
    body: &Oscillator<F>,
    drive: &Drive<F>,
    stiffnesses: RangeInclusive<F>,
) -> Result<Optimum<F>, Error> {
    let (low, high) = stiffnesses.into_inner();
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
        best_frequency_ratio(alpha, gamma, omega(hard), omega(soft))?
    } else {
        most_dissipating_frequency_ratio(alpha, omega(hard)..=omega(soft))?
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
