//! The minimum force and the bands of frequency without any stop, whatever the number of reversals.

use super::band::{Band, Edge};
use super::bands::{bands, frequency_bands};
use super::force::ratios_of;
use crate::cycle::border::Lobe;
use crate::cycle::regime::NoStop;
use crate::cycle::six_reversals::force_ratios_at;
use crate::float::Float;
use crate::greatest::highest;
use crate::machine::error::{Error, Quantity};
use crate::machine::oscillator::{Drive, Oscillator};
use crate::machine::ratios::positive;
use crate::root;
use alloc::vec::Vec;
use core::ops::RangeInclusive;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// The forces p₀ under which `body` never stops at ω_d: r_y times [`NoStop::of`].
///
/// Unit of force. The same parts are proved and searched as in [`NoStop::of`].
///
/// # Errors
/// Those of [`super::min_amplitude`]; [`Error::StaticFriction`] for a body whose static friction is above the
/// kinetic one.
pub fn forces_without_stop<F: Float>(body: &Oscillator<F>, angular_frequency: F) -> Result<NoStop<F>, Error> {
    let found = NoStop::of(&ratios_of(body, angular_frequency)?);
    let forces = found.map(|x| body.friction_bound() * x);
    positive(Quantity::ForceAmplitude, forces.min())?;
    positive(Quantity::ForceAmplitude, forces.border)?;
    Ok(forces)
}

/// [`frequency_bands_without_stop`] with m = k = r_y = 1 under a force of amplitude α; its errors name ratios.
pub fn bands_without_stop<F: Float>(
    alpha: F,
    damping_ratio: F,
    range: RangeInclusive<F>,
) -> Result<Vec<Band<F>>, Error> {
    let (low, high) = range.into_inner();
    let mut found = Vec::new();
    for band in bands(alpha, damping_ratio, low..=high)? {
        found.push(band?);
    }
    // √(1 + α/5) exceeds 1/Ω at the last pole that can have such a band. The conversion of a float to an
    // integer saturates.
    let last = ((1.0 + alpha.to_f64() / 5.0).sqrt() / 2.0) as u16;
    for index in 1..=last {
        let Some(pole) = Lobe::new(index).high_pole::<F>() else { continue };
        let (from, to) = reach(pole);
        let outside = to < low || from > high;
        if !outside
            && let Some((start, end)) = around(pole, alpha, damping_ratio)
            && start <= high
            && end >= low
        {
            let (is_cut_below, is_cut_above) = (start < low, end > high);
            let edge = |is_cut| if is_cut { Edge::Range } else { Edge::Border };
            found.push(Band {
                low: if is_cut_below { low } else { start },
                high: if is_cut_above { high } else { end },
                low_edge: edge(is_cut_below),
                high_edge: edge(is_cut_above),
                lobe: index,
                reversals_per_cycle: 6,
            });
        }
    }
    found.sort_by(|a, b| a.low.partial_cmp(&b.low).unwrap_or(core::cmp::Ordering::Equal));
    Ok(found)
}

/// All bands of angular frequency in `[low, high]` in which `drive` keeps `body` from stopping, by increasing frequency.
///
/// Only the amplitude of the drive matters: the force, p₀ or `k u_g0`, must be the same at every frequency.
///
/// The list contains the bands of [`frequency_bands`], with two reversals a cycle, and a band with six reversals around
/// or just below each pole Ω = 1/(2n+1) where α is at least `5 (1/Ω² − 1)` or slightly more. Without damping the
/// bands with two reversals are proved to be complete, and those with six rest on a search
/// ([`crate::cycle::SixReversals`]). With damping both are searched, those with six reversals on a mesh of 64
/// frequencies near each pole. The ends are accurate to a few floats.
///
/// ```
/// use stickslip::design::frequency_bands_without_stop;
/// use stickslip::{Drive, Oscillator};
/// // In ratios: m = k = r_y = 1.
/// let (body, drive) = (Oscillator::new(1.0, 1.0, 1.0)?, Drive::force(80.0_f64, 1.0)?);
/// let found = frequency_bands_without_stop(&body, &drive, 0.3..=0.4)?;
/// // Up to 0.3250, from 0.3298 to 0.3342 around 1/3, and from 0.3436 on.
/// assert_eq!(found.iter().map(|band| band.reversals_per_cycle).collect::<Vec<_>>(), [2, 6, 2]);
/// assert!((found[1].low - 0.32984).abs() < 1e-4 && (found[1].high - 0.33422).abs() < 1e-4);
/// // A little damping narrows the second band, and more removes it.
/// assert_eq!(frequency_bands_without_stop(&body.with_damping_ratio(0.002)?, &drive, 0.32..=0.36)?.len(), 3);
/// assert_eq!(frequency_bands_without_stop(&body.with_damping_ratio(0.01)?, &drive, 0.32..=0.36)?.len(), 2);
/// # Ok::<(), stickslip::Error>(())
/// ```
///
/// # Errors
/// Those of [`frequency_bands`], and [`Error::ForceOfFrequency`] for other drives.
pub fn frequency_bands_without_stop<F: Float>(
    body: &Oscillator<F>,
    drive: &Drive<F>,
    range: RangeInclusive<F>,
) -> Result<Vec<Band<F>>, Error> {
    let (low, high) = range.into_inner();
    if !drive.is_same_at_any_frequency() {
        return Err(Error::ForceOfFrequency { drive: drive.excitation().name() });
    }
    // This returns the errors in physical units.
    let _ = frequency_bands(body, drive, low..=high)?;
    let natural = body.natural_frequency();
    let alpha = positive(Quantity::ForceRatio, drive.force_amplitude(body) / body.friction_bound())?;
    let (from, to) = (ratios_of(body, low)?.omega(), ratios_of(body, high)?.omega());
    let in_units = |band: Band<F>| Band {
        low: band.low_edge.place(low, band.low * natural),
        high: band.high_edge.place(high, band.high * natural),
        ..band
    };
    let found = bands_without_stop(alpha, body.damping_ratio(), from..=to)?;
    Ok(found.into_iter().map(in_units).collect())
}

/// The frequency ratios below and above a pole that enclose all six-reversal cycles of the pole.
fn reach<F: Float>(pole: F) -> (F, F) {
    let one = F::int(1);
    (one / (one / pole + F::ratio(3, 80)), one / (one / pole - F::ratio(3, 140)))
}

/// The frequency ratios near a pole at which the body reverses six times a cycle with this force ratio and
/// damping ratio.
fn around<F: Float>(pole: F, alpha: F, zeta: F) -> Option<(F, F)> {
    let zero = F::int(0);
    let edges = |omega: F| force_ratios_at(omega, zeta, F::int(1));
    // The excess is not negative within the edges; it is relative to α.
    let excess = |omega: F| match edges(omega) {
        Some((low, high)) => {
            let (above, below) = ((alpha - low) / alpha, (high - alpha) / alpha);
            if above < below { above } else { below }
        }
        None => F::int(-1),
    };
    let (from, to) = reach(pole);
    let inside = if excess(pole) >= zero { pole } else { meshed(from, to, excess) };
    if excess(inside) < zero {
        return None;
    }
    Some((root::enclosed(from, inside, excess).1, root::enclosed(inside, to, excess).0))
}

/// The place between `from` and `to` where the excess is greatest or not negative, next to the best point of
/// a mesh.
fn meshed<F: Float>(from: F, to: F, excess: impl Fn(F) -> F) -> F {
    let at = |step: i32| from + (to - from) * F::ratio(step, MESH);
    let (mut best, mut most) = (0, excess(from));
    for step in 1..=MESH {
        let here = excess(at(step));
        if here > most {
            (best, most) = (step, here);
        }
    }
    let (low, high) = (at(best.saturating_sub(1).max(0)), at(best.saturating_add(1).min(MESH)));
    let excess = |omega: F| {
        let excess = excess(omega);
        if excess >= F::int(0) { Err(omega) } else { Ok(excess) }
    };
    highest(low, high, F::epsilon(), excess).unwrap_or_else(|found| found)
}

const MESH: i32 = 64;

#[cfg(test)]
mod tests {
    use super::{bands_without_stop, forces_without_stop, frequency_bands_without_stop};
    use crate::cycle::regime::regime;
    use crate::{Drive, Oscillator, Regime};

    #[test]
    fn inside_and_at_its_ends_the_body_never_stops_and_outside_it_does() {
        for alpha in [53.0, 60.0, 70.0, 100.0, 150.0, 400.0, 2000.0] {
            let found = bands_without_stop(alpha, 0.0, 0.05..=2.0).unwrap();
            let six = found.iter().filter(|band| band.reversals_per_cycle == 6).count();
            assert!(six >= 1, "{alpha}: {found:?}");
            for pair in found.windows(2) {
                assert!(pair[0].high < pair[1].low, "{alpha}: {pair:?}");
                let gap = pair[1].low - pair[0].high;
                for share in [1e-9, 0.1, 0.5, 0.9, 1.0 - 1e-9] {
                    assert_eq!(
                        regime(pair[0].high + gap * share, alpha),
                        Ok(Regime::Sticking),
                        "{alpha}: {pair:?}"
                    );
                }
            }
            for band in &found {
                for share in [0.0, 1e-9, 0.3, 0.7, 1.0] {
                    let omega = f64::clamp(band.low + (band.high - band.low) * share, band.low, band.high);
                    let at = regime(omega, alpha);
                    assert!(
                        omega == 1.0 || at == Ok(Regime::NonSticking),
                        "{alpha} {omega}: {at:?} {band:?}"
                    );
                }
            }
        }
    }

    #[test]
    fn in_physical_units() {
        let body = Oscillator::new(2.0, 8.0, 3.0).unwrap();
        let forces = forces_without_stop(&body, 2.0 * 0.331).unwrap();
        assert!((forces.min() / 161.019_919_536_129_45f64 - 1.0).abs() < 1e-13);
        let drive = Drive::force(240.0, 1.0).unwrap();
        let found = frequency_bands_without_stop(&body, &drive, 0.6..=0.8).unwrap();
        let ratios = bands_without_stop(80.0f64, 0.0, 0.3..=0.4).unwrap();
        assert_eq!(found.len(), ratios.len());
        for (a, b) in found.iter().zip(&ratios) {
            assert!((a.low - 2.0 * b.low).abs() < 1e-14 && (a.high - 2.0 * b.high).abs() < 1e-14);
        }
    }
}
