//! The stiffness that dissipates most under a given force.
//!
//! At fixed m, p₀, r_y and ω_d the energy `4 r_y Δ₀` is A₂ p₀²/(2 m ω_d²) (eq. 67), and with v = 1/Ω²
//!
//! ```text
//! A₂ = (8/α²) √D,   D = (α² − K²)/(v − 1)² = (α/(v − 1))² − T²/v.
//! ```
//!
//! **In each lobe of the border A₂ has one maximum and no minimum**, so that the best of a band is that maximum where
//! the band contains it, and else the end next to it:
//!
//! * v < 1 (Ω > 1): K² falls with v and 1/(1 − v)² rises: D rises.
//! * (2n)² < v < (2n+1)², n ≥ 1: T²/v rises and (α/(v − 1))² falls: D falls.
//! * (2n+1)² < v < (2n+2)²: D′ = 0 is `α² = φ(v)`, `φ = −½(v − 1)³ (T²/v)′`, D rising where φ > α². For n ≥ 1, with u = √v, t = |T|,
//!   `φ = (u² − 1)³ [π t (1 + t²) u + 2t²]/(4u⁴)`, and both terms fall with u: `6u/(u² − 1) − 3/u < π√3 ≤ (π/2)(1/t + 3t)`.
//!   For n = 0, with κ = −K of the border's lobes, `φ = κ² − κκ′(v − 1)` and
//!   `φ′ = κκ′ − (v − 1)(κ′² + κκ″) < 0`, because (v − 1)|κ″| < |κ′| up to v = 11/3, and (v − 1) κ′² is more than the rest beyond.
//!   There φ falls from (4/π)² at v = 1 to 0 at v = 4.
//!
//! For α > 4/π the maximum of lobe 0 is Ω = 1, where A₂ is infinite. In lobe n ≥ 1 A₂ < 8/(α (v − 1)) < 2/(α n(n + 1)): lobes whose
//! bound is below what has been found need not be looked into.

use super::bands::{Band, Edge, band_in, bands};
use super::damped::{Damper, best_frequency_ratio};
use super::dissipation::Optimum;
use crate::error::{Error, Quantity, written};
use crate::float::Float;
use crate::nonsticking::border::{Lobe, border_range, ordered_lobes};
use crate::nonsticking::{loop_size_inertia, loop_size_stiffness, max_displacement, squared_sine};
use crate::oscillator::{Drive, Oscillator};
use crate::phase_function::{PhaseFunction, one_minus_square};
use crate::ratios::{Ratios, positive};
use crate::root;

/// The frequency ratio of the largest loop A₂ among the cycles that do not stick.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BestFrequencyRatio<F> {
    /// The frequency ratio Ω.
    pub omega: F,
    /// The loop size A₂ there.
    pub loop_size: F,
    /// What makes it the best.
    pub optimum: Optimum,
}

/// The Ω in `[low, high]` that makes A₂ largest at the force ratio α, of those at which the body does not stick.
///
/// The global one: each band of the range has one candidate, by the module's head. Accuracy at f64: 16 ulp in A₂; in Ω, where
/// the optimum is inside, that of a root of the derivative, 1e-15.
///
/// # Errors
/// [`Error::SticksThroughout`] where there is no such Ω, [`Error::AtResonance`] where α > 4/π and the range contains Ω = 1,
/// at which A₂ is infinite, and as [`bands`].
pub fn most_dissipating_frequency_ratio<F: Float>(
    alpha: F,
    low: F,
    high: F,
) -> Result<BestFrequencyRatio<F>, Error> {
    bands(alpha, low, high)?;
    let lowest = low.or_larger(Lobe::new(u16::MAX).low_pole());
    let (first, last) = ordered_lobes(lowest, high)?;
    let mut best: Option<BestFrequencyRatio<F>> = None;
    let mut next = Some(last);
    while let Some(lobe) = next {
        let n = F::int(i32::from(lobe.index()));
        let is_beaten = |found: BestFrequencyRatio<F>| {
            n > F::int(0) && found.loop_size * alpha * n * (n + F::int(1)) > F::int(2)
        };
        // No band below the pole of a lobe that is out of reach.
        if best.is_some_and(is_beaten) || alpha < F::int(4) * n * (n + F::int(1)) {
            break;
        }
        if let Some(band) = band_in(lobe, alpha, low, high)? {
            let found = best_of_band(alpha, &band)?;
            if best.is_none_or(|best| found.loop_size > best.loop_size) {
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
fn best_of_band<F: Float>(alpha: F, band: &Band<F>) -> Result<BestFrequencyRatio<F>, Error> {
    let (zero, one) = (F::int(0), F::int(1));
    if band.low <= one && band.high >= one {
        return Err(Error::AtResonance { quantity: Quantity::LoopSizeInertia });
    }
    let rises = |omega| growth(alpha, omega);
    let at_end = |edge| if edge == Edge::Border { Optimum::Border } else { Optimum::RangeEnd };
    let (omega, optimum) = if band.low > one || rises(band.low) <= zero {
        (band.low, at_end(band.low_edge))
    } else if rises(band.high) >= zero {
        (band.high, at_end(band.high_edge))
    } else {
        (root::enclosed(band.low, band.high, rises).0, Optimum::Interior)
    };
    let p = PhaseFunction::of_valid(omega);
    let displacement = max_displacement(p.value(), alpha, one_minus_square(omega));
    let loop_size = loop_size_inertia(loop_size_stiffness(displacement, alpha), omega);
    Ok(BestFrequencyRatio { omega, loop_size, optimum })
}

/// `2(α² − K²) − Ω(1 − Ω²) K K′`, which below Ω = 1 has the sign of dA₂/dΩ.
fn growth<F: Float>(alpha: F, omega: F) -> F {
    let p = PhaseFunction::of_valid(omega);
    let k = p.value();
    F::int(2) * squared_sine(k, alpha) - omega * one_minus_square(omega) * (k * p.slope())
}

/// The stiffness that dissipates most.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BestStiffness<F> {
    /// The stiffness k.
    pub stiffness: F,
    /// The energy dissipated in a cycle, `4 r_y Δ₀`.
    pub energy: F,
    /// What makes it the best.
    pub optimum: Optimum,
}

/// The stiffness k in `[low, high]` with which the force of `drive` dissipates most in a cycle, of those with which the
/// body does not stick.
///
/// Mass, friction bound and damping constant c are those of `body`; its own stiffness plays no part. [`most_dissipating_frequency_ratio`] in
/// physical units: `k = m ω_d²/Ω²`. With a damper it is the energy that friction takes, and the best of a search, not of a proof
/// (`src/design/damped.rs`).
///
/// # Errors
/// As there (but with a damper there is an answer at Ω = 1); [`Error::BaseMotion`], because the force of a base motion, k u_g0, is not fixed; and
/// where a stiffness is not finite, not > 0 or `low > high`.
pub fn most_dissipating_stiffness<F: Float>(
    body: &Oscillator<F>,
    drive: &Drive<F>,
    low: F,
    high: F,
) -> Result<BestStiffness<F>, Error> {
    if drive.is_base_motion() {
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
        // ζ = γΩ has to be in its domain at both ends.
        let gamma = body.damping() / (F::int(2) * body.mass() * frequency);
        for omega in [omega(hard), omega(soft)] {
            Ratios::new(omega, alpha)?.with_damping_ratio(gamma * omega)?;
        }
        best_frequency_ratio(alpha, Damper::Constant(gamma), omega(hard), omega(soft))?
    } else {
        most_dissipating_frequency_ratio(alpha, omega(hard), omega(soft))?
    };
    let stiffness = if best.omega == omega(hard) {
        hard
    } else if best.omega == omega(soft) {
        soft
    } else {
        inertia / best.omega.square()
    };
    let energy = best.loop_size * (p0 / F::int(2) * (p0 / inertia));
    Ok(BestStiffness {
        stiffness: positive(Quantity::Stiffness, stiffness)?,
        energy: positive(Quantity::PseudoStaticEnergy, energy)?,
        optimum: best.optimum,
    })
}

#[cfg(test)]
mod tests {
    use super::{most_dissipating_frequency_ratio, most_dissipating_stiffness};
    use crate::design::{Optimum, bands};
    use crate::error::Quantity;
    use crate::{Cycle, Drive, Error, Oscillator, Ratios};

    fn loop_size(omega: f64, alpha: f64) -> f64 {
        Cycle::new(Ratios::new(omega, alpha).unwrap()).map_or(0.0, |c| c.loop_size_inertia())
    }

    #[test]
    fn none_of_the_range_is_better() {
        for (alpha, low, high) in [
            (1.22, 0.1, 10.0),
            (1.27, 0.1, 10.0),
            (1.5, 0.1, 0.99),
            (1.5, 1.01, 10.0),
            (12.0, 0.1, 0.34),
            (12.0, 0.1, 0.9),
            (13.0, 0.28, 0.33),
            (31.0, 0.05, 0.2),
            (31.0, 0.05, 0.34),
            (1e4, 0.005, 0.02),
        ] {
            let best = most_dissipating_frequency_ratio(alpha, low, high).unwrap();
            assert!((loop_size(best.omega, alpha) / best.loop_size - 1.0).abs() < 1e-12);
            for i in 0..=50_000 {
                let omega = low + (high - low) * f64::from(i) / 50_000.0;
                assert!(
                    loop_size(omega, alpha) <= best.loop_size * (1.0 + 1e-12),
                    "{alpha} {omega} {best:?}"
                );
            }
        }
    }

    /// Ranges that end a little inside of a band, so that a band below may have the larger loop.
    #[test]
    fn the_best_need_not_be_in_the_highest_band() {
        let mut lower = 0;
        for i in 0..40 {
            let alpha = 12.5 * 1.07f64.powi(i);
            for band in bands(alpha, 0.03, 0.9).unwrap().skip(1) {
                let low = band.unwrap().low;
                for share in [1e-9, 1e-4, 1e-2] {
                    let high = low * (1.0 + share);
                    let best = most_dissipating_frequency_ratio(alpha, 0.03, high).unwrap();
                    let of_last = most_dissipating_frequency_ratio(alpha, low, high).unwrap();
                    assert!(best.loop_size >= of_last.loop_size, "{alpha} {high}: {best:?} {of_last:?}");
                    lower += u32::from(best.omega < low && best.loop_size > of_last.loop_size);
                }
            }
        }
        assert!(lower > 10, "{lower}");
    }

    #[test]
    fn inside_to_fifteen_digits() {
        // The zero of dA₂/dΩ at 50 digits.
        for (alpha, omega, loop_size) in [
            (1.25, 0.934_679_833_045_693_5, 8.501_909_588_802_311),
            (1.22, 0.868_047_389_393_012_8, 5.868_376_101_991_35),
            (12.0, 0.298_450_666_351_024_6, 0.059_335_671_086_871_225),
        ] {
            let high = if alpha > 2.0 { 0.34 } else { 9.0 };
            let best = most_dissipating_frequency_ratio::<f64>(alpha, 0.1, high).unwrap();
            assert_eq!(best.optimum, Optimum::Interior);
            assert!((best.omega / omega - 1.0).abs() < 2e-15, "{alpha}: {best:?}");
            assert!((best.loop_size / loop_size - 1.0).abs() < 1e-14, "{alpha}: {best:?}");
        }
    }

    #[test]
    fn which_one_it_is() {
        let optimum =
            |alpha, low, high| most_dissipating_frequency_ratio::<f64>(alpha, low, high).map(|b| b.optimum);
        assert_eq!(optimum(1.5, 0.7, 0.9), Ok(Optimum::RangeEnd));
        assert_eq!(optimum(1.5, 1.1, 1.2), Ok(Optimum::RangeEnd));
        assert_eq!(optimum(31.0, 0.05, 0.2), Ok(Optimum::Border));
        assert!(matches!(optimum(1.5, 0.5, 2.0), Err(Error::AtResonance { .. })));
        assert!(matches!(optimum(1.2, 0.01, 100.0), Err(Error::SticksThroughout { .. })));
        assert!(matches!(optimum(1.22, 0.95, 2.0), Err(Error::SticksThroughout { .. })));
    }

    /// One maximum and no minimum in each band, as the module's head proves.
    #[test]
    fn up_and_then_down_in_each_band() {
        for alpha in [1.215, 1.25, 1.3, 12.0, 31.0, 60.0, 1e3] {
            for band in bands(alpha, 0.02, 20.0).unwrap().map(Result::unwrap) {
                let peaks = |low: f64, high: f64| {
                    let at = |i: i32| loop_size(low + (high - low) * f64::from(i) / 3000.0, alpha);
                    (1..2999)
                        .filter(|&i| at(i) < at(i - 1) * (1.0 - 1e-13) && at(i + 1) > at(i) * (1.0 + 1e-13))
                        .count()
                };
                let high = if band.low < 1.0 { band.high.min(0.999) } else { band.high };
                assert_eq!(peaks(band.low, high), 0, "a minimum: {alpha} {band:?}");
            }
        }
    }

    #[test]
    fn in_physical_units() {
        let body = Oscillator::new(2.0, 99.0, 3.0).unwrap();
        let drive = Drive::force(3.75, 2.0).unwrap();
        // m ω_d² = 8: k = 8/Ω².
        let ratios = most_dissipating_frequency_ratio::<f64>(1.25, 0.5, 2.0).unwrap();
        let best = most_dissipating_stiffness(&body, &drive, 2.0, 32.0).unwrap();
        assert!((best.stiffness * ratios.omega.powi(2) / 8.0 - 1.0).abs() < 1e-14);
        assert!((best.energy / (ratios.loop_size * 3.75 * 3.75 / 16.0) - 1.0).abs() < 1e-14);
        let body = Oscillator::new(2.0, best.stiffness, 3.0).unwrap();
        let cycle = Cycle::new(drive.ratios(&body).unwrap()).unwrap();
        let energy = 4.0 * 3.0 * cycle.max_displacement() * body.friction_displacement();
        assert!((best.energy / energy - 1.0).abs() < 1e-10, "{energy} {best:?}");
        let base = Drive::base_motion(1.0, 2.0).unwrap();
        assert_eq!(most_dissipating_stiffness(&body, &base, 2.0, 32.0), Err(Error::BaseMotion));
        let empty = most_dissipating_stiffness(&body, &drive, 3.0, 2.0).unwrap_err();
        assert!(matches!(empty, Error::EmptyRange { quantity: Quantity::Stiffness, .. }), "{empty}");
    }
}
