//! Frequency and force ratios, and targets of inverse problems.

use super::numbers::{any_bits, beside, magnitude, ordinary};
use crate::{Border, Cycle, PhaseFunction, Ratios};
use arbitrary::{Arbitrary, Result, Unstructured};
use std::f64::consts::{PI, SQRT_2};

/// The Ω at which the border has its global minimum.
const LEAST_BORDER: f64 = 0.849_158_848_834_442;

/// A frequency ratio: any bits, any magnitude, ordinary, or close to one of the places in the module's table.
///
/// # Errors
/// As for [`any_bits`].
pub(crate) fn frequency_ratio(u: &mut Unstructured<'_>) -> Result<f64> {
    let place = match u.int_in_range(0..=9)? {
        0 => return any_bits(u),
        1 => return ordinary(u, -6.0, 6.0).map(f64::exp2),
        2 => return ordinary(u, -251.0, 251.0).map(f64::exp2),
        3 | 4 => 1.0,
        5 => 1.0 / (1.0 + f64::from(u8::arbitrary(u)?)),
        6 => 1.0 / (1.0 + 2.0 * f64::from(u8::arbitrary(u)?)),
        7 => 1.0 / (1.0 + f64::from(u16::arbitrary(u)?)),
        8 => *u.choose(&[0.5, LEAST_BORDER, 2.0, 1e-3, 1e3])?,
        _ => {
            let end = f64::exp2(f64::from(*u.choose(&[20u8, 250, 64, 10])?));
            if bool::arbitrary(u)? { end } else { 1.0 / end }
        }
    };
    beside(u, place)
}

/// A force ratio for a given Ω, which need not be valid.
///
/// # Errors
/// As for [`any_bits`].
pub(crate) fn force_ratio(u: &mut Unstructured<'_>, omega: f64) -> Result<f64> {
    let kind = u.int_in_range(0..=12)?;
    let place = match kind {
        0 => return any_bits(u),
        1 => return magnitude(u),
        2 => return ordinary(u, -1.0, 8.0).map(f64::exp2),
        3 => return u32::arbitrary(u).map(|bits| f64::from_bits(bits.into())),
        4 => 1.0,
        5 => 4.0 / PI,
        _ => {
            let Ok(p) = PhaseFunction::new(omega) else { return magnitude(u) };
            let border = Border::at(&p);
            match kind {
                6 => p.value().abs(),
                7 => SQRT_2 * p.value().abs(),
                8 => border.min_force_ratio_turning_point,
                9 | 10 => border.min_force_ratio,
                _ => border.min_force_ratio * ordinary(u, 0.0, 8.0)?.exp2(),
            }
        }
    };
    beside(u, place)
}

/// A damping ratio: zero (a quarter of them), close to ζ = 1, ordinary, tiny, of any magnitude, or any bits.
///
/// # Errors
/// As for [`any_bits`].
pub(crate) fn damping_ratio(u: &mut Unstructured<'_>) -> Result<f64> {
    match u.int_in_range(0..=7)? {
        0 | 1 => Ok(0.0),
        2 => beside(u, 1.0),
        3 => any_bits(u),
        4 => magnitude(u),
        5 => ordinary(u, -60.0, 6.0).map(f64::exp2),
        _ => ordinary(u, -12.0, 3.0).map(f64::exp2),
    }
}

/// A peak displacement or velocity: that of the border at this Ω, a larger one, or one of any magnitude.
pub(super) fn target(u: &mut Unstructured<'_>, omega: f64) -> Result<f64> {
    let kind = u.int_in_range(0..=4)?;
    let Ok(border) = Border::new(omega) else { return magnitude(u) };
    let place = match kind {
        0 => return magnitude(u),
        1 => return ordinary(u, -2.0, 12.0).map(f64::exp2),
        2 => border.least_displacement,
        // NaN at Ω = 1, where no steady motion has a peak velocity.
        3 => Ratios::new(omega, border.min_force_ratio)
            .ok()
            .and_then(Cycle::find)
            .map_or(f64::NAN, |cycle| cycle.max_velocity),
        _ => border.least_displacement * ordinary(u, 0.0, 12.0)?.exp2(),
    };
    beside(u, place)
}
