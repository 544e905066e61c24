//! Tests of `tuning.rs`.

use super::{most_dissipating_frequency_ratio, most_dissipating_stiffness};
use crate::design::{OptimumKind, bands};
use crate::machine::error::Quantity;
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
        let best = most_dissipating_frequency_ratio(alpha, low..=high).unwrap();
        assert!((loop_size(best.at, alpha) / best.value - 1.0).abs() < 1e-12);
        for i in 0..=50_000 {
            let omega = low + (high - low) * f64::from(i) / 50_000.0;
            assert!(loop_size(omega, alpha) <= best.value * (1.0 + 1e-12), "{alpha} {omega} {best:?}");
        }
    }
}

/// The ranges end slightly inside a band, so that a lower band may have the larger loop.
#[test]
fn the_best_need_not_be_in_the_highest_band() {
    let mut lower = 0;
    for i in 0..40 {
        let alpha = 12.5 * 1.07f64.powi(i);
        for band in bands(alpha, 0.0, 0.03..=0.9).unwrap().skip(1) {
            let low = band.unwrap().low;
            for share in [1e-9, 1e-4, 1e-2] {
                let high = low * (1.0 + share);
                let best = most_dissipating_frequency_ratio(alpha, 0.03..=high).unwrap();
                let of_last = most_dissipating_frequency_ratio(alpha, low..=high).unwrap();
                assert!(best.value >= of_last.value, "{alpha} {high}: {best:?} {of_last:?}");
                lower += u32::from(best.at < low && best.value > of_last.value);
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
        let best = most_dissipating_frequency_ratio::<f64>(alpha, 0.1..=high).unwrap();
        assert_eq!(best.kind, OptimumKind::Interior);
        assert!((best.at / omega - 1.0).abs() < 2e-15, "{alpha}: {best:?}");
        assert!((best.value / loop_size - 1.0).abs() < 1e-14, "{alpha}: {best:?}");
    }
}

#[test]
fn which_one_it_is() {
    let optimum =
        |alpha, low, high| most_dissipating_frequency_ratio::<f64>(alpha, low..=high).map(|b| b.kind);
    assert_eq!(optimum(1.5, 0.7, 0.9), Ok(OptimumKind::RangeEnd));
    assert_eq!(optimum(1.5, 1.1, 1.2), Ok(OptimumKind::RangeEnd));
    assert_eq!(optimum(31.0, 0.05, 0.2), Ok(OptimumKind::Border));
    assert!(matches!(optimum(1.5, 0.5, 2.0), Err(Error::AtResonance { .. })));
    assert!(matches!(optimum(1.2, 0.01, 100.0), Err(Error::SticksThroughout { .. })));
    assert!(matches!(optimum(1.22, 0.95, 2.0), Err(Error::SticksThroughout { .. })));
}

/// Each band has one maximum and no minimum, as the module's documentation proves.
#[test]
fn up_and_then_down_in_each_band() {
    for alpha in [1.215, 1.25, 1.3, 12.0, 31.0, 60.0, 1e3] {
        for band in bands(alpha, 0.0, 0.02..=20.0).unwrap().map(Result::unwrap) {
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
    let ratios = most_dissipating_frequency_ratio::<f64>(1.25, 0.5..=2.0).unwrap();
    let best = most_dissipating_stiffness(&body, &drive, 2.0..=32.0).unwrap();
    assert!((best.at * ratios.at.powi(2) / 8.0 - 1.0).abs() < 1e-14);
    assert!((best.value / (ratios.value * 3.75 * 3.75 / 16.0) - 1.0).abs() < 1e-14);
    let body = Oscillator::new(2.0, best.at, 3.0).unwrap();
    let cycle = Cycle::new(drive.ratios(&body).unwrap()).unwrap();
    let energy = 4.0 * 3.0 * cycle.max_displacement * body.friction_displacement();
    assert!((best.value / energy - 1.0).abs() < 1e-10, "{energy} {best:?}");
    let base = Drive::new(crate::Excitation::FootMotion, 1.0, 2.0).unwrap();
    assert_eq!(most_dissipating_stiffness(&body, &base, 2.0..=32.0), Err(Error::BaseMotion));
    let empty = most_dissipating_stiffness(&body, &drive, 3.0..=2.0).unwrap_err();
    assert!(matches!(empty, Error::EmptyRange { quantity: Quantity::Stiffness, .. }), "{empty}");
}

/// ζ = γΩ, γ = c/(2mω_d), Ω = √(8/k), must be between 2⁻²⁵⁰ and 2²⁵⁰ over the whole range; otherwise the
/// error names the invalid ζ.
#[test]
fn the_damping_ratio_is_in_its_domain_at_both_ends() {
    let drive = Drive::force(3.75, 2.0).unwrap();
    let found = |own: f64, gamma: f64, low: f64, high: f64| {
        let body = Oscillator::new(2.0, own, 3.0).unwrap().with_damping(8.0 * gamma).unwrap();
        most_dissipating_stiffness(&body, &drive, low..=high).map(|best| best.kind)
    };
    for (own, gamma, low, high, exponent) in [
        (99.0, 2f64.powi(249), 8.0 / 64.0, 8.0 / 16.0, 251),
        (99.0, 2f64.powi(249), 8.0 / 64.0, 8.0, 252),
        (0.01, 2f64.powi(-249), 8.0, 8.0 * 16.0, -251),
        (0.01, 2f64.powi(-249), 8.0 * 16.0, 8.0 * 64.0, -252),
    ] {
        let zeta = 2f64.powi(exponent);
        let due = Ratios::new(0.5, 1.25).unwrap().with_damping_ratio(zeta).unwrap_err();
        assert_eq!(found(own, gamma, low, high), Err(due), "{gamma:e}");
    }
}
