//! Friction and damping from a measured free decay.
//!
//! In every half cycle the amplitude falls from y to `κ(y − B) − B`, κ = e^{−ζπ/d}, d = √(1 − ζ²), B = r_y/k (see
//! [`crate::motion::FreeDecay`]): the damper takes a part of it, friction an amount. Between two turning points, with
//! ω = dω_n and the sign s of the first,
//!
//! ```text
//! x = c + s [B + (y − B) e^{−ζω_nτ} (cos ωτ + (ζ/d) sin ωτ)].
//! ```
//!
//! Measured turning points, or a whole sampled decay, are fitted by least squares: first amplitude, B and ζ of the
//! turning points, and with samples also the time of the first, ω and the rest c of the spring. The fit does not know that
//! B and ζ are not negative: so its intervals contain the truth as often as they say. An estimate below 0 is given as 0.

mod fit;

use crate::machine::error::{Error, Quantity};
use crate::machine::ratios::{finite, positive};
use crate::uncertainty::Estimate;
use alloc::boxed::Box;
use alloc::vec;
use alloc::vec::Vec;
use core::f64::consts::PI;
use fit::Fit;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// The turning points that were measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "kebab-case"))]
#[non_exhaustive]
pub enum TurningPoints {
    /// Those of both sides, one in every half cycle, with their signs or without.
    EveryHalfCycle,
    /// Those of one side, one in every cycle.
    EveryCycle,
}

/// Friction and damping estimated from a free decay.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
#[must_use]
pub struct DecayIdentified {
    /// The friction displacement B = r_y/k, in the unit of the measurements.
    pub friction_displacement: Estimate,
    /// The damping ratio ζ.
    pub damping_ratio: Estimate,
    /// The first amplitude.
    pub amplitude: Estimate,
    /// The natural angular frequency ω_n, where times are known.
    pub natural_frequency: Option<Estimate>,
    /// The standard error of one measurement, estimated from the residuals.
    pub noise: f64,
    /// The turning points, as measured or as found among the samples: the time, where it is known, and the displacement
    /// from the rest of the spring.
    pub turning_points: Vec<(Option<f64>, f64)>,
    /// Measured minus computed, of each turning point or each sample that was used.
    pub residuals: Vec<f64>,
}

/// The friction displacement and the damping ratio of successive turning points, whose displacement is measured from
/// the rest of the spring, with the times at which they were measured, if they are known.
///
/// The times give the natural frequency and nothing else. Errors of the turning points count as independent with one
/// standard deviation. Accuracy without noise: 1e-9 relative to the first amplitude.
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
/// [`Error::InMeasurement`] where a turning point is not finite or 0, or not below the one before it in magnitude, or a
/// time does not increase; [`Error::DecayTooShort`] for fewer than four; [`Error::LengthMismatch`].
pub fn identify_turning_points(
    turns: &[f64],
    times: Option<&[f64]>,
    kind: TurningPoints,
) -> Result<DecayIdentified, Error> {
    let (mut last, mut most) = (f64::INFINITY, 0.0f64);
    for (index, &x) in turns.iter().enumerate() {
        let wrong = |error| Error::InMeasurement { index, error: Box::new(error) };
        let size = positive(Quantity::MaxDisplacement, x.abs()).map_err(wrong)?;
        finite(Quantity::Displacement, x).map_err(wrong)?;
        most = most.max(size);
        // Noise may let an amplitude grow a little.
        if size > last + most / 4.0 {
            return Err(wrong(Error::NotADecay));
        }
        last = size;
    }
    if turns.len() < LEAST {
        return Err(Error::DecayTooShort { count: turns.len() });
    }
    let halves = if kind == TurningPoints::EveryHalfCycle { 1 } else { 2 };
    let size: Vec<f64> = turns.iter().map(|x| x.abs()).collect();
    let (first, last) = (size.first().copied().unwrap_or(1.0), size.last().copied().unwrap_or(0.0));
    let model = |p: &[f64]| {
        let mut y = p[0];
        let kappa = ratio(p[1]);
        let mut found = Vec::with_capacity(size.len());
        for _ in &size {
            found.push(y);
            for _ in 0..halves {
                y = kappa * (y - p[2]) - p[2];
            }
        }
        found
    };
    let steps = (size.len() - 1) as f64 * f64::from(halves);
    let starts = [
        vec![first, 0.0, (first - last) / steps / 2.0],
        vec![first, ((first / last).ln() / steps / PI).clamp(0.0, 0.9), 0.0],
    ];
    let fit = Fit::best(&size, &model, &starts, &[1.0, 0.1, 1.0].map(|s| s * first))?;
    let natural_frequency = match times {
        Some(times) if times.len() != turns.len() => {
            return Err(Error::LengthMismatch { name: "times", found: times.len(), expected: turns.len() });
        }
        Some(times) => Some(frequency(times, f64::from(halves), fit.at[1])?),
        None => None,
    };
    let points = turns.iter().enumerate().map(|(i, &x)| (times.and_then(|t| t.get(i).copied()), x)).collect();
    Ok(identified(fit, natural_frequency, points))
}

/// The same of a sampled displacement: times that increase, and the displacement from any zero.
///
/// The decay is fitted from its first turning point to its last; what is before, such as the pull that starts it, and
/// what is after, at rest, plays no part. Errors of the samples count as independent.
///
/// # Errors
/// As [`identify_turning_points`], where fewer than four turning points stand out of the samples by a twentieth of their
/// range.
pub fn identify_decay(times: &[f64], displacements: &[f64]) -> Result<DecayIdentified, Error> {
    if times.len() != displacements.len() {
        let (found, expected) = (displacements.len(), times.len());
        return Err(Error::LengthMismatch { name: "displacements", found, expected });
    }
    let mut before = f64::NEG_INFINITY;
    for (index, (&t, &x)) in times.iter().zip(displacements).enumerate() {
        let wrong = |error| Error::InMeasurement { index, error: Box::new(error) };
        finite(Quantity::Time, t).and(finite(Quantity::Displacement, x)).map_err(wrong)?;
        before = after(before, t).map_err(wrong)?;
    }
    let turns = turning_points(displacements);
    if turns.len() < LEAST {
        return Err(Error::DecayTooShort { count: turns.len() });
    }
    let place = |i: usize| turns.get(i).copied().unwrap_or(0);
    let at = |i: usize| displacements.get(place(i)).copied().unwrap_or(0.0);
    let time = |i: usize| times.get(place(i)).copied().unwrap_or(0.0);
    let count = turns.len();
    // Of three successive turning points the outer ones and twice the middle one cancel but for the rest.
    let middles = (2..count).map(|i| (at(i - 2) + 2.0 * at(i - 1) + at(i)) / 4.0);
    let rest = middles.sum::<f64>() / (count - 2) as f64;
    let (first, last) = (at(0) - rest, (at(count - 1) - rest).abs());
    let half = (time(count - 1) - time(0)) / (count - 1) as f64;
    let range = place(0)..=place(count - 1);
    let used: Vec<f64> = displacements.get(range.clone()).unwrap_or_default().to_vec();
    let when: Vec<f64> = times.get(range).unwrap_or_default().to_vec();
    let start = time(0);
    let sign = 1f64.copysign(first);
    // Amplitude, ζ, B, rest, time of the first turning point in half cycles, half cycles in those of the guess.
    let model = |p: &[f64]| {
        let (zeta, kappa) = (p[1], ratio(p[1]));
        let d = swing(zeta);
        let length = half * p[5];
        let (mut y, mut n, mut s) = (p[0], 0.0, sign);
        let mut found = Vec::with_capacity(when.len());
        for &t in &when {
            let phase = (t - start - half * p[4]) / length;
            while phase > n + 1.0 {
                (y, n, s) = (kappa * (y - p[2]) - p[2], n + 1.0, -s);
            }
            let angle = PI * (phase - n);
            let wave = (-(zeta / d) * angle).exp() * (angle.cos() + zeta / d * angle.sin());
            found.push(p[3] + s * (p[2] + (y - p[2]) * wave));
        }
        found
    };
    let steps = (count - 1) as f64;
    let amplitude = first.abs();
    let starts = [
        vec![amplitude, 0.0, (amplitude - last) / steps / 2.0, rest, 0.0, 1.0],
        vec![amplitude, ((amplitude / last).ln() / steps / PI).clamp(0.0, 0.9), 0.0, rest, 0.0, 1.0],
    ];
    let scales = [amplitude, 0.1, amplitude, amplitude, 1.0, 1.0];
    let fit = Fit::best(&used, &model, &starts, &scales)?;
    let (zeta, length) = (fit.at[1], half * fit.at[5]);
    let d = swing(zeta);
    let value = PI / (length * d);
    let spread = (fit.error(5) / fit.at[5]).hypot(zeta * fit.error(1) / (d * d));
    let natural_frequency = fit.estimate(value, value * spread, f64::INFINITY);
    let mut y = fit.at[0];
    let points = (0..count).map(|i| {
        let s = if i % 2 == 0 { sign } else { -sign };
        let point = (Some(start + half * fit.at[4] + length * i as f64), s * y);
        y = ratio(zeta) * (y - fit.at[2]) - fit.at[2];
        point
    });
    let points = points.collect();
    Ok(identified(fit, Some(natural_frequency), points))
}

/// The answer from a fit of the first amplitude, ζ and B, and of further parameters or none.
fn identified(
    fit: Fit,
    natural_frequency: Option<Estimate>,
    turning_points: Vec<(Option<f64>, f64)>,
) -> DecayIdentified {
    let of = |i: usize, greatest| fit.estimate(fit.at[i].max(0.0), fit.error(i), greatest);
    DecayIdentified {
        friction_displacement: of(2, f64::INFINITY),
        damping_ratio: of(1, 1.0),
        amplitude: of(0, f64::INFINITY),
        natural_frequency,
        noise: fit.noise(),
        turning_points,
        residuals: fit.residuals,
    }
}

/// The least number of turning points.
const LEAST: usize = 4;

/// κ = e^{−ζπ/√(1 − ζ²)}, with a continuation below ζ = 0 for the fit.
fn ratio(zeta: f64) -> f64 {
    (-zeta * PI / swing(zeta)).exp()
}

/// √(1 − ζ²), above 0.
fn swing(zeta: f64) -> f64 {
    (1.0 - zeta * zeta).max(1e-12).sqrt()
}

/// A time after another one.
fn after(before: f64, t: f64) -> Result<f64, Error> {
    if t <= before {
        positive(Quantity::TimeStep, t - before)?;
    }
    Ok(t)
}

/// The natural frequency from the times of turning points that are so many half cycles apart, by a straight line.
fn frequency(times: &[f64], halves: f64, zeta: f64) -> Result<Estimate, Error> {
    let mut before = f64::NEG_INFINITY;
    for (index, &t) in times.iter().enumerate() {
        let wrong = |error| Error::InMeasurement { index, error: Box::new(error) };
        finite(Quantity::Time, t).map_err(wrong)?;
        before = after(before, t).map_err(wrong)?;
    }
    let n = times.len() as f64;
    let (middle, mean) = ((n - 1.0) / 2.0, times.iter().sum::<f64>() / n);
    let off = |i: usize| i as f64 - middle;
    let square: f64 = (0..times.len()).map(|i| off(i) * off(i)).sum();
    let slope = times.iter().enumerate().map(|(i, t)| off(i) * (t - mean)).sum::<f64>() / square;
    let rest: f64 = times.iter().enumerate().map(|(i, t)| (t - mean - slope * off(i)).powi(2)).sum();
    let spread = (rest / (n - 2.0) / square).sqrt() / slope;
    let value = halves * PI / (slope * swing(zeta));
    let range = (0.0, f64::INFINITY);
    Ok(Estimate { value, standard_error: value * spread, degrees_of_freedom: n - 2.0, range })
}

/// The places of the turning points that stand out by a twentieth of the range, from the first one that another one
/// follows.
fn turning_points(x: &[f64]) -> Vec<usize> {
    let most = x.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let least = x.iter().copied().fold(f64::INFINITY, f64::min);
    let enough = (most - least) / 20.0;
    let mut found: Vec<usize> = Vec::new();
    let (mut high, mut low) = (0usize, 0usize);
    let mut is_rising: Option<bool> = None;
    for (i, &value) in x.iter().enumerate() {
        let of = |place: usize| x.get(place).copied().unwrap_or(value);
        if value > of(high) {
            high = i;
        }
        if value < of(low) {
            low = i;
        }
        if is_rising != Some(false) && of(high) - value > enough {
            found.push(high);
            (is_rising, low) = (Some(false), i);
        } else if is_rising != Some(true) && value - of(low) > enough {
            found.push(low);
            (is_rising, high) = (Some(true), i);
        }
    }
    // A pull from rest begins with no turning point: the greatest of the first two begins the decay.
    let size = |i: usize| found.get(i).and_then(|&place| x.get(place)).copied();
    if let (Some(a), Some(b), Some(c)) = (size(0), size(1), size(2))
        && (a - b).abs() < (b - c).abs() * 0.9
    {
        found.remove(0);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::{DecayIdentified, TurningPoints, identify_decay, identify_turning_points};
    use crate::machine::error::Error;
    use crate::motion::FreeDecay;

    /// Turning points of the exact motion in B, by its own recursion.
    fn turns(first: f64, zeta: f64, count: usize) -> Vec<f64> {
        let (mut x, mut found) = (first, Vec::new());
        let kappa = (-zeta * std::f64::consts::PI / (1.0 - zeta * zeta).sqrt()).exp();
        for _ in 0..count {
            found.push(x);
            x = -x.signum() * (kappa * (x.abs() - 1.0) - 1.0);
        }
        found
    }

    /// Normal numbers of a fixed seed.
    struct Noise(u64);

    impl Noise {
        fn uniform(&mut self) -> f64 {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            ((self.0 >> 11) as f64 + 0.5) / (1u64 << 53) as f64
        }
        fn normal(&mut self) -> f64 {
            (-2.0 * self.uniform().ln()).sqrt() * (std::f64::consts::TAU * self.uniform()).cos()
        }
    }

    #[test]
    fn exact_turning_points_give_their_parameters_back() {
        for (zeta, friction, first) in
            [(0.0, 0.3, 40.0), (0.02, 0.5, 30.0), (0.2, 0.01, 4000.0), (0.05, 2.0, 40.0)]
        {
            let all: Vec<f64> = turns(first, zeta, 9).into_iter().map(|x| friction * x).collect();
            // The recursion is that of the exact motion.
            let decay = FreeDecay::new(first, 0.0, zeta, 1.0).unwrap();
            assert!(decay.half_cycles >= 8);
            let one_side: Vec<f64> = all.iter().copied().step_by(2).collect();
            let of = |turns: &[f64], kind| identify_turning_points(turns, None, kind).unwrap();
            for found in [of(&all, TurningPoints::EveryHalfCycle), of(&one_side, TurningPoints::EveryCycle)] {
                assert!(
                    (found.friction_displacement.value - friction).abs() < 1e-6 * friction * first,
                    "{found:?}"
                );
                assert!((found.damping_ratio.value - zeta).abs() < 1e-7, "{zeta}: {found:?}");
            }
        }
    }

    /// A decay sampled from the closed form of each half cycle, with noise of a part of the first amplitude.
    fn sampled(friction: f64, zeta: f64, noise: f64, random: &mut Noise) -> DecayIdentified {
        let (natural, rest) = (9.0, 0.7);
        let turns: Vec<f64> = turns(40.0, zeta, 12).into_iter().map(|x| friction * x).collect();
        let d = (1.0 - zeta * zeta).sqrt();
        let half = std::f64::consts::PI / (natural * d);
        let (mut times, mut values) = (Vec::new(), Vec::new());
        for i in 0..900 {
            let t = f64::from(i) * half * 10.9 / 900.0;
            let n = (t / half) as usize;
            let (x, angle) = (turns[n], natural * d * (t - half * n as f64));
            let middle = x.signum() * friction;
            let wave = (-zeta / d * angle).exp() * (angle.cos() + zeta / d * angle.sin());
            times.push(t);
            values.push(rest + middle + (x - middle) * wave + noise * 40.0 * friction * random.normal());
        }
        identify_decay(&times, &values).unwrap()
    }

    #[test]
    fn a_sampled_decay_gives_its_parameters_back() {
        for zeta in [0.0, 0.01, 0.06] {
            let found = sampled(0.4, zeta, 0.0, &mut Noise(1));
            assert!((found.friction_displacement.value - 0.4).abs() < 1e-5, "{zeta}: {found:?}");
            assert!((found.damping_ratio.value - zeta).abs() < 1e-6, "{zeta}");
            assert!((found.natural_frequency.unwrap().value - 9.0).abs() < 1e-5, "{zeta}");
        }
    }

    /// With one per cent of noise the intervals contain the truth in 95 of 100 measurements: of 2,000 decays by their
    /// turning points, and of 60 by their samples.
    #[test]
    fn the_intervals_contain_the_truth() {
        let mut random = Noise(3);
        let (mut inside, mut tried) = ([0u32; 2], 0);
        for i in 0..2000 {
            let zeta = [0.0, 0.005, 0.02, 0.05][i % 4];
            let count = [6, 8, 10][i % 3];
            let noisy: Vec<f64> = turns(60.0, zeta, count)
                .into_iter()
                .map(|x| 0.5 * (x + 0.01 * 60.0 * random.normal()))
                .collect();
            let found = identify_turning_points(&noisy, None, TurningPoints::EveryHalfCycle).unwrap();
            for (inside, (estimate, truth)) in
                inside.iter_mut().zip([(found.friction_displacement, 0.5), (found.damping_ratio, zeta)])
            {
                let (low, high) = estimate.interval();
                *inside += u32::from(low <= truth && truth <= high);
            }
            tried += 1;
        }
        for inside in inside {
            let share = f64::from(inside) / f64::from(tried);
            assert!((0.94..=0.97).contains(&share), "{share}");
        }
        let mut inside = [0u32; 3];
        for i in 0..60 {
            let zeta = [0.0, 0.01, 0.03][i % 3];
            let found = sampled(0.4, zeta, 0.01, &mut random);
            let truth = [
                (found.friction_displacement, 0.4),
                (found.damping_ratio, zeta),
                (found.natural_frequency.unwrap(), 9.0),
            ];
            for (inside, (estimate, truth)) in inside.iter_mut().zip(truth) {
                let (low, high) = estimate.interval();
                *inside += u32::from(low <= truth && truth <= high);
            }
        }
        // Of 60, at least 53 with a probability of 99 %.
        assert!(inside.iter().all(|&inside| inside >= 53), "{inside:?}");
    }

    #[test]
    fn what_is_no_decay_is_refused() {
        let of = |turns: &[f64]| identify_turning_points(turns, None, TurningPoints::EveryCycle);
        assert!(matches!(of(&[3.0, 2.0, 1.0]), Err(Error::DecayTooShort { count: 3 })));
        for wrong in [f64::NAN, f64::INFINITY, 0.0] {
            assert!(matches!(of(&[4.0, 3.0, wrong, 1.0]), Err(Error::InMeasurement { index: 2, .. })));
        }
        assert!(matches!(of(&[1.0, 3.0, 9.0, 27.0]), Err(Error::InMeasurement { index: 1, .. })));
        let times = identify_turning_points(
            &[4.0, 3.0, 2.0, 1.0],
            Some(&[0.0, 1.0, 1.0, 2.0]),
            TurningPoints::EveryCycle,
        );
        assert!(matches!(times, Err(Error::InMeasurement { index: 2, .. })));
        let flat: Vec<f64> = (0..50).map(f64::from).collect();
        assert!(matches!(identify_decay(&flat, &[0.5; 50]), Err(Error::DecayTooShort { .. })));
        assert!(matches!(identify_decay(&flat, &[0.5; 49]), Err(Error::LengthMismatch { .. })));
        assert!(identify_decay(&[0.0, 0.0], &[1.0, 2.0]).is_err());
    }
}
