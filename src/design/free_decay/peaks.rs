//! The fit of measured turning points.

use super::fit::EXACT;
use super::{
    AMPLITUDE, Alike, DecayIdentified, FRICTION, Fit, GREATEST, TurningPoints, ZETA, held, identified,
    increasing, measured, next, ratio, slides, swing,
};
use crate::machine::error::{Error, Quantity};
use crate::machine::ratios::positive;
use crate::uncertainty::Estimate;
use alloc::boxed::Box;
use alloc::vec;
use alloc::vec::Vec;
use core::f64::consts::PI;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// The least number of turning points.
const LEAST: usize = 4;

/// The friction displacement and the damping ratio of successive turning points, whose displacement is measured from
/// the rest of the spring, with the times at which they were measured, if they are known.
///
/// Turning points of both signs are those of both sides, whatever `kind` says. Turning points at the end that do not fall
/// any more are those of a body at rest, where that explains them better. The times give the natural frequency and nothing
/// else. Errors of the turning points count as independent with one standard deviation. Accuracy without noise: 1e-9
/// relative to the first amplitude.
///
/// ```
/// use stickslip::design::{TurningPoints, identify_turning_points};
/// let peaks = [40.0, 33.1, 26.5, 20.2, 14.1];
/// let found = identify_turning_points(&peaks, None, TurningPoints::EveryCycle)?;
/// assert!((found.friction_displacement.value - 1.4).abs() < 0.1);
/// assert!(found.damping_ratio.value < 0.01);
/// # Ok::<(), stickslip::Error>(())
/// ```
///
/// # Errors
/// [`Error::InMeasurement`] where a turning point is not finite or 0, or its size not from 10⁻⁷⁵ to 10⁷⁵, or not below the one before it in magnitude, or a
/// time does not increase; [`Error::DecayTooShort`] for fewer than four; [`Error::NotADecay`] for amplitudes that grow, and
/// [`Error::NegativeFriction`] for those that fall as with a negative friction or damping; [`Error::LengthMismatch`].
pub fn identify_turning_points(
    turns: &[f64],
    times: Option<&[f64]>,
    kind: TurningPoints,
) -> Result<DecayIdentified, Error> {
    let (mut last, mut most) = (f64::INFINITY, 0.0f64);
    for (index, &x) in turns.iter().enumerate() {
        let wrong = |error| Error::InMeasurement { index, error: Box::new(error) };
        let size = positive(Quantity::MaxDisplacement, x.abs()).map_err(wrong)?;
        measured(x, GREATEST.recip()).map_err(wrong)?;
        most = most.max(size);
        // Noise may let an amplitude grow a little.
        if size > last + most / 4.0 {
            return Err(wrong(Error::NotADecay));
        }
        last = size;
    }
    if turns.len() < LEAST {
        return Err(Error::DecayTooShort { count: turns.len(), least: LEAST });
    }
    let has_both_signs = turns.iter().any(|&x| x > 0.0) && turns.iter().any(|&x| x < 0.0);
    let kind = if has_both_signs { TurningPoints::EveryHalfCycle } else { kind };
    let halves: usize = if kind == TurningPoints::EveryHalfCycle { 1 } else { 2 };
    let size: Vec<f64> = turns.iter().map(|x| x.abs()).collect();
    let fits = Alike::of(fits(&size, halves)).ok_or(Error::NotADecay)?;
    let mut found = identified(&fits)?;
    found.natural_frequency = match times {
        Some(times) if times.len() != turns.len() => {
            return Err(Error::LengthMismatch { name: "times", found: times.len(), expected: turns.len() });
        }
        Some(times) => {
            increasing(times)?;
            // After rest there are no turning points.
            let moving = fits.half_cycles().map_or(times.len(), |n| (n / halves + 1).min(times.len()));
            let times = times.get(..moving).filter(|times| times.len() >= 3).unwrap_or(times);
            Some(frequency(times, halves as f64, fits.best().at[ZETA]))
        }
        None => None,
    };
    found.half_cycles = fits.half_cycles();
    found.static_friction_displacement = found.half_cycles.map(|n| held(&fits.best().at, n));
    found.read_as = Some(kind);
    found.turning_points =
        turns.iter().enumerate().map(|(i, &x)| (times.and_then(|t| t.get(i).copied()), x)).collect();
    Ok(found)
}

/// The fit of a motion that goes on, unless friction would have stopped it or one that comes to rest explains more than
/// chance would; then the fits that come to rest.
fn fits(size: &[f64], halves: usize) -> Vec<(Option<usize>, Fit)> {
    let whole = (size.len() - 1) * halves;
    let (first, last) = (size[0], size[size.len() - 1]);
    let scales = [1.0, 0.1, 1.0].map(|s| s * first);
    let to = |end: usize, place: usize| {
        let model = |p: &[f64]| -> Vec<f64> {
            let (mut y, kappa) = (p[AMPLITUDE], ratio(p[ZETA]));
            let mut amplitudes = vec![y];
            for n in 1..=whole {
                y = if n <= end { next(y, kappa, p[FRICTION]) } else { y };
                if n % halves == 0 {
                    amplitudes.push(if n < end { y } else { y.abs() });
                }
            }
            amplitudes
        };
        let steps = (place * halves) as f64;
        let last = size.get(place).copied().unwrap_or(last);
        let starts = [
            vec![first, 0.0, (first - last) / steps / 2.0],
            vec![first, ((first / last).ln() / steps / PI).clamp(0.0, 0.9), 0.0],
        ];
        Fit::best(size, &model, &starts, &scales, EXACT).filter(|fit| slides(&fit.at, end))
    };
    let mut at_rest: Vec<(Option<usize>, Fit)> = (2..whole)
        .filter_map(|end| Some((Some(end), to(end, end / halves)?)))
        // Static friction of more than a few times the kinetic one would stop a body anywhere.
        .filter(|(end, fit)| end.is_some_and(|n| held(&fit.at, n).0 <= MOST_STATIC * fit.at[FRICTION]))
        .collect();
    let Some(going_on) = to(whole, size.len() - 1) else { return at_rest };
    let least = at_rest.iter().map(|(_, fit)| fit.sum).fold(f64::INFINITY, f64::min);
    let is_worse =
        going_on.sum > least * (1.0 + 9.0 / going_on.degrees_of_freedom()) + f64::EPSILON * first * first;
    if !is_worse {
        at_rest.clear();
        at_rest.push((None, going_on));
    }
    at_rest
}

/// The greatest ratio of static to kinetic friction that a rest among turning points may have.
const MOST_STATIC: f64 = 3.0;

/// The natural frequency from the times of turning points that are so many half cycles apart, by a straight line.
fn frequency(times: &[f64], halves: f64, zeta: f64) -> Estimate {
    let n = times.len() as f64;
    let (middle, mean) = ((n - 1.0) / 2.0, times.iter().sum::<f64>() / n);
    let off = |i: usize| i as f64 - middle;
    let square: f64 = (0..times.len()).map(|i| off(i) * off(i)).sum();
    let slope = times.iter().enumerate().map(|(i, t)| off(i) * (t - mean)).sum::<f64>() / square;
    let rest: f64 = times.iter().enumerate().map(|(i, t)| (t - mean - slope * off(i)).powi(2)).sum();
    let spread = (rest / (n - 2.0) / square).sqrt() / slope;
    let value = halves * PI / (slope * swing(zeta));
    let range = (0.0, f64::INFINITY);
    Estimate { value, standard_error: value * spread, degrees_of_freedom: n - 2.0, range, alike: None }
}
