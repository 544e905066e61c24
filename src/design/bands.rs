//! The bands of frequency in which a given force keeps the body sliding.
//!
//! Sliding is the motion that reverses twice a cycle and does not stop. A body that reverses more often
//! without stopping, which happens near the poles ([`super::frequency_bands_without_stop`]), is outside the bands. In
//! each lobe of the border, `α_min(Ω) ≤ α` holds on at most one interval, because α_min decreases strictly to
//! one minimum and then increases strictly (`src/cycle/border/lobe.rs`). The interval is empty in every
//! lobe n with (2n+1)² − 1 ≥ α, because α_min ≥ 1/Ω² − 1: a force ratio α opens at most √(1+α)/2 + 1 bands.
//! One search in each of those lobes therefore finds all bands without sampling. With a damper there is no
//! such proof, and the bands are searched (`damped`).

use super::band::{Band, Edge};
use super::damped::{BandSearch, Damper, Force};
use super::force::ratios_of;
use crate::cycle::Border;
use crate::cycle::border::{Lobe, ordered_lobes};
use crate::cycle::phase_function::PhaseFunction;
use crate::float::Float;
use crate::machine::error::{Error, Quantity, written};
use crate::machine::oscillator::{Drive, Excitation, Oscillator};
use crate::machine::ratios::{Ratios, positive};
use crate::root;
use alloc::boxed::Box;
use core::ops::RangeInclusive;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// The bands of a range, by increasing frequency: see [`frequency_bands`].
#[derive(Debug, Clone)]
pub struct Bands<F> {
    low: F,
    high: F,
    method: Method<F>,
    frequency: Option<FrequencyScale<F>>,
}

/// The method that finds the bands.
#[derive(Debug, Clone)]
enum Method<F> {
    /// The lobes that remain at α, from the next to the last.
    Lobes(F, Option<Lobe>, Lobe),
    /// A search, with a damper.
    Searched(Box<BandSearch<F>>),
}

/// The factor from frequency ratios to angular frequencies.
#[derive(Debug, Clone, Copy)]
struct FrequencyScale<F> {
    natural: F,
    low: F,
    high: F,
}

/// [`frequency_bands`] with m = k = r_y = 1 under a force of amplitude α; its errors name ratios.
pub fn bands<F: Float>(alpha: F, damping_ratio: F, range: RangeInclusive<F>) -> Result<Bands<F>, Error> {
    let (low, high) = range.into_inner();
    Ratios::new(low, alpha)?.with_damping_ratio(damping_ratio)?;
    bands_with(alpha, Damper::Ratio(damping_ratio), low, high)
}

/// The bands of [`bands`] for a damper that is valid in the range.
pub(super) fn bands_with<F: Float>(alpha: F, damper: Damper<F>, low: F, high: F) -> Result<Bands<F>, Error> {
    if !damper.is_damped() {
        return bands_by_lobes(alpha, low, high);
    }
    Ratios::new(high, alpha)?;
    searched(Force::constant(alpha), damper, low, high)
}

/// The bands by a search between two Ω that are valid, as are α and ζ at both.
fn searched<F: Float>(force: Force<F>, damper: Damper<F>, low: F, high: F) -> Result<Bands<F>, Error> {
    if low > high {
        let quantity = Quantity::FrequencyRatio;
        return Err(Error::EmptyRange { quantity, low: written(low), high: written(high) });
    }
    let method = Method::Searched(Box::new(BandSearch::new(force, damper, low, high)?));
    Ok(Bands { low, high, method, frequency: None })
}

/// The bands without damping, lobe by lobe.
fn bands_by_lobes<F: Float>(alpha: F, low: F, high: F) -> Result<Bands<F>, Error> {
    let lowest = Lobe::new(u16::MAX).low_pole();
    // Below the last lobe, there is no band for an α below 1/Ω² − 1 at its pole.
    let is_beyond = low < lowest && alpha < F::int(1) / lowest.square() - F::int(1);
    let (first, last) = ordered_lobes(if is_beyond { lowest.or_larger(low) } else { low }, high)?;
    // The conversion of a float to an integer saturates.
    let reachable = ((1.0 + alpha.to_f64()).sqrt() / 2.0) as u16;
    let next = first.min(Lobe::new(reachable)).max(last);
    Ok(Bands { low, high, method: Method::Lobes(alpha, Some(next), last), frequency: None })
}

/// All bands of angular frequency in `[low, high]` in which `drive` keeps `body` sliding: `α_min(Ω) ≤ α`.
///
/// Only the amplitude of the drive matters, not its frequency. Where the force is the same at every frequency, p₀ or
/// `k u_g0`, and without a damper the list is complete, and contains each band once (see the module's documentation). At
/// each end the computed border is at most α, and a float or two outside it is above α, so that [`crate::Response`] agrees
/// with the band. A band narrower than two floats next to an end of the range may be missing. Bands in lobes
/// beyond the resolution of the type near a pole are known only to rounding.
///
/// **With a damper**, the same at every frequency, the bands are searched, not proved ([`Bands::is_searched`]). The
/// border is evaluated on a mesh that is fine near its peaks, each of its extrema near α is located, and the
/// ends are exact. A band or a gap far narrower than any known structure of the border may be missed. There
/// is provably none below Ω = 1/√(1 + α) (`src/design/damped.rs`). The force of a rotating unbalance, of a moving base given
/// by its displacement or velocity, or of a damper on a moving support changes with the frequency: these bands are searched
/// on a mesh, too.
///
/// ```
/// use stickslip::design::{Edge, frequency_bands};
/// use stickslip::{Drive, Oscillator};
/// // In ratios: m = k = r_y = 1.
/// let (body, drive) = (Oscillator::new(1.0, 1.0, 1.0)?, Drive::force(12.0_f64, 1.0)?);
/// let found = frequency_bands(&body, &drive, 0.1..=2.0)?.collect::<Result<Vec<_>, _>>()?;
/// assert_eq!(found.len(), 2); // around 0.2971, and from 0.3707 on
/// assert!((found[0].low - 0.280666).abs() < 1e-6 && (found[0].high - 0.301070).abs() < 1e-6);
/// assert!((found[1].low - 0.370699).abs() < 1e-6 && found[1].high_edge == Edge::Range);
/// let damped = body.with_damping_ratio(0.05)?;
/// let damped = frequency_bands(&damped, &drive, 0.1..=2.0)?.collect::<Result<Vec<_>, _>>()?;
/// assert!(damped.len() == 1 && (damped[0].low - 0.378354).abs() < 1e-6);
/// # Ok::<(), stickslip::Error>(())
/// ```
///
/// # Errors
/// Where `low > high`, or a ratio is outside the domain of [`Ratios`], or `low` is below the last lobe, Ω =
/// 7.6e-6, and α would keep the body sliding even there. The iterator itself gives [`Error::Undecided`] for a
/// lobe whose minimum is too close to α for the type to decide whether it contains a band.
pub fn frequency_bands<F: Float>(
    body: &Oscillator<F>,
    drive: &Drive<F>,
    range: RangeInclusive<F>,
) -> Result<Bands<F>, Error> {
    let (low, high) = range.into_inner();
    let (natural, zeta) = (body.natural_frequency(), body.damping_ratio());
    let found = if drive.is_same_at_any_frequency() {
        let alpha = positive(Quantity::ForceRatio, drive.force_amplitude(body) / body.friction_bound())?;
        let ratio = |frequency: F| Ok::<F, Error>(ratios_of(body, frequency)?.omega());
        bands(alpha, zeta, ratio(low)?..=ratio(high)?)?
    } else {
        let ratio = |frequency: F| Ok::<F, Error>(drive.at(frequency)?.ratios(body)?.omega());
        let (from, to) = (ratio(low)?, ratio(high)?);
        searched(growing(body, drive, natural)?, Damper::Ratio(zeta), from, to)?
    };
    Ok(Bands { frequency: Some(FrequencyScale { natural, low, high }), ..found })
}

/// α as a function of Ω: a support with its damper has `p₀² = (k² + c²ω_d²) u₀²`, other drives a power of ω_d.
fn growing<F: Float>(body: &Oscillator<F>, drive: &Drive<F>, natural: F) -> Result<Force<F>, Error> {
    let zero = F::int(0);
    let alpha = drive.at(natural)?.force_amplitude(body) / body.friction_bound();
    Ok(Force(match drive.excitation() {
        Excitation::Force | Excitation::FootMotion | Excitation::SurfaceAcceleration => [alpha, zero, zero],
        Excitation::SurfaceVelocity => [zero, alpha, zero],
        Excitation::Unbalance | Excitation::SurfaceMotion => [zero, zero, alpha],
        Excitation::DampedFootMotion => {
            let spring = body.stiffness() * drive.amplitude() / body.friction_bound();
            [spring, spring * F::int(2) * body.damping_ratio(), zero]
        }
    }))
}

impl<F: Float> Iterator for Bands<F> {
    type Item = Result<Band<F>, Error>;

    fn next(&mut self) -> Option<Self::Item> {
        loop {
            let found = match &mut self.method {
                Method::Searched(search) => Ok(Some(search.next()?)),
                Method::Lobes(alpha, next, last) => {
                    let lobe = (*next)?;
                    *next = if lobe == *last { None } else { lobe.above() };
                    band_in(lobe, *alpha, self.low, self.high)
                }
            };
            match found {
                Ok(None) => {}
                Ok(Some(band)) => return Some(Ok(self.in_units(band))),
                Err(error) => return Some(Err(error)),
            }
        }
    }
}

impl<F: Float> Bands<F> {
    /// Whether the bands are searched, and not proved to be all.
    pub const fn is_searched(&self) -> bool {
        matches!(self.method, Method::Searched(_))
    }

    /// The least value of the border found by a search so far.
    pub(super) fn least(&self) -> Option<F> {
        match &self.method {
            Method::Searched(search) => search.least(),
            Method::Lobes(..) => None,
        }
    }

    /// The band in physical units.
    fn in_units(&self, band: Band<F>) -> Band<F> {
        let Some(FrequencyScale { natural, low, high }) = self.frequency else { return band };
        Band {
            low: band.low_edge.place(low, band.low * natural),
            high: band.high_edge.place(high, band.high * natural),
            ..band
        }
    }
}

/// The band of `lobe` within `[low, high]`, if there is one.
fn band_in<F: Float>(lobe: Lobe, alpha: F, low: F, high: F) -> Result<Option<Band<F>>, Error> {
    // The excess is not negative where the body slides.
    let excess = |omega: F| alpha - Border::at(&PhaseFunction::of_valid(omega)).min_force_ratio;
    let slides = |omega: F| excess(omega) >= F::int(0);
    let from = low.or_larger(lobe.low_pole());
    let to = lobe.high_pole().filter(|&pole| pole < high).unwrap_or(high);
    let minimum = lobe.minimum::<F>();
    let best = if minimum.omega < from {
        from
    } else if minimum.omega > to {
        to
    } else {
        if is_too_close(alpha, minimum.force_ratio, minimum.omega) {
            return Err(Error::Undecided {
                alpha: written(alpha),
                least: written(minimum.force_ratio),
                omega: written(minimum.omega),
            });
        }
        minimum.omega
    };
    if !slides(best) {
        return Ok(None);
    }
    let (start, low_edge) = if slides(from) {
        (from, if from > low { Edge::Border } else { Edge::Range })
    } else {
        (root::enclosed(from, best, excess).1, Edge::Border)
    };
    let (end, high_edge) = if slides(to) {
        (to, if to < high { Edge::Border } else { Edge::Range })
    } else {
        (root::enclosed(best, first_beyond(best, to, slides), excess).0, Edge::Border)
    };
    Ok(Some(Band { low: start, high: end, low_edge, high_edge, lobe: lobe.index(), reversals_per_cycle: 2 }))
}

/// A frequency ratio in `(from, to]` where the body sticks, close to the band's end; the body sticks at `to`.
fn first_beyond<F: Float>(from: F, to: F, slides: impl Fn(F) -> bool) -> F {
    let mut end = from + from;
    while end < to && slides(end) {
        end = end + end;
    }
    if end < to { end } else { to }
}

/// Whether α is too close to the minimum of a lobe for the type to decide. The tolerance is the error of the
/// border and, next to a corner, the change of the border within the rounding of its Ω.
fn is_too_close<F: Float>(alpha: F, least: F, omega: F) -> bool {
    let one = F::int(1);
    let error = F::int(crate::Verdict::<F>::BORDER_ERROR) * F::epsilon() * (one + one / omega);
    (alpha - least).abs() <= error * least
}

#[cfg(test)]
mod tests;
