//! The fit of a sampled decay.

use super::fit::{EXACT, Ends};
use super::guess::{Guess, guesses};
use super::{
    AMPLITUDE, Alike, DecayIdentified, FRICTION, Fit, ZETA, held, identified, increasing, measured, next,
    ratio, slides, swing,
};
use crate::machine::error::{Error, written};
use alloc::boxed::Box;
use alloc::vec;
use alloc::vec::Vec;
use core::f64::consts::PI;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// The places of the further parameters: the displacement at which the spring rests, and the time of the first turning
/// point and of half a cycle, in half cycles of the guess.
const REST: usize = 3;
const START: usize = 4;
const HALF: usize = 5;

/// The least number of turning points.
const LEAST: usize = 3;
/// The number of samples from which the numbers of half cycles are compared.
const FEW: usize = 500;
/// The numbers of half cycles that are tried beyond the best so far.
const BEYOND: usize = 3;
/// The tolerance of the fits that are compared.
const ROUGH: Ends = Ends::at(1e-5);
/// The damping ratio from which on there are no turning points to be seen.
const MOST_DAMPING: f64 = 0.85;
/// The dampings of the starts.
const DAMPINGS: [f64; 6] = [0.0, 0.003, 0.01, 0.03, 0.08, 0.2];
/// The numbers of half cycles from which the search begins.
const STARTS: usize = 3;
/// The part of the first amplitude above which a misfit that is no noise is none of the model's.
const MISFIT: f64 = 0.03;
/// The part of the first amplitude above which noise hides whether the model explains anything.
const MOST_NOISE: f64 = 0.5;

/// The friction displacement and the damping ratio of a sampled displacement: times that increase, and the displacement
/// from any zero.
///
/// The decay is fitted from its first turning point to the end of the samples, rest included: the turning point at which
/// the body rests bounds its static friction. What is before, such as the pull that starts it, plays no part. Errors of the
/// samples count as independent; where the residuals show that they are not, the intervals are wider accordingly.
///
/// # Errors
/// As [`super::identify_turning_points`], with [`Error::DecayTooShort`] for fewer than three turning points;
/// [`Error::NoDecay`] where no decay stands out of the noise, and [`Error::DecayUnexplained`] where the samples differ from
/// the best fit by more than noise.
pub fn identify_decay(times: &[f64], displacements: &[f64]) -> Result<DecayIdentified, Error> {
    if times.len() != displacements.len() {
        let (found, expected) = (displacements.len(), times.len());
        return Err(Error::LengthMismatch { name: "displacements", found, expected });
    }
    for (index, &x) in displacements.iter().enumerate() {
        measured(x, 0.0).map_err(|error| Error::InMeasurement { index, error: Box::new(error) })?;
    }
    increasing(times)?;
    let every = times.len().div_ceil(FEW).max(1);
    let mut best: Option<(Samples<'_>, Vec<Ending>)> = None;
    for guess in guesses(times, displacements) {
        let samples =
            Samples { times, values: displacements, start: times[guess.first], guess, tolerance: EXACT };
        let fits = samples.thinned(every, |samples| samples.explored());
        let sum = |fits: &[Ending]| {
            let mean = |fit: &Fit| fit.sum / fit.residuals.len() as f64;
            fits.iter().map(|(_, fit)| mean(fit)).fold(f64::INFINITY, f64::min)
        };
        if best.as_ref().is_none_or(|(_, known)| sum(&fits) < sum(known)) && !fits.is_empty() {
            best = Some((samples, fits));
        }
    }
    let Some((samples, fits)) = best else { return Err(Error::DecayTooShort { count: 0, least: LEAST }) };
    let samples = samples.beginning_at_first_turn(&fits);
    let fits = fits.into_iter().filter_map(|(end, fit)| {
        let again = samples.fit(end, &[fit.at])?;
        Some((end, again))
    });
    let fits = Alike::of(fits.collect()).ok_or(Error::NotADecay)?;
    samples.answer(&fits)
}

/// The half cycles until rest, if there is one within the samples, and the fit with them.
type Ending = (Option<usize>, Fit);

/// The samples from the first turning point of a guess on.
struct Samples<'a> {
    times: &'a [f64],
    values: &'a [f64],
    /// The time from which the first turning point is counted.
    start: f64,
    guess: Guess,
    /// Where the fit ends.
    tolerance: Ends,
}

impl Samples<'_> {
    fn window(&self) -> (&[f64], &[f64]) {
        let from = self.guess.first;
        (&self.times[from..], &self.values[from..])
    }

    /// An answer from every nth sample from the first turning point on.
    fn thinned<T>(&self, every: usize, of: impl FnOnce(&Samples<'_>) -> T) -> T {
        let (times, values) = self.window();
        let times: Vec<f64> = times.iter().copied().step_by(every).collect();
        let values: Vec<f64> = values.iter().copied().step_by(every).collect();
        of(&Samples {
            times: &times,
            values: &values,
            start: self.start,
            guess: Guess { first: 0, ..self.guess },
            tolerance: ROUGH,
        })
    }

    /// These samples without those before the first turning point that fits have found.
    fn beginning_at_first_turn(mut self, fits: &[Ending]) -> Self {
        let Some((_, fit)) = fits.iter().min_by(|a, b| a.1.sum.total_cmp(&b.1.sum)) else { return self };
        let turn = self.start + self.guess.half * fit.at[START];
        let before = self.window().0.iter().take_while(|&&t| t < turn).count();
        self.guess.first += before.min(self.window().0.len().saturating_sub(1));
        self
    }

    /// The half cycles from the first turning point to the last sample.
    fn half_cycles(&self, at: &[f64]) -> usize {
        let last = self.times[self.times.len() - 1];
        let phase = (last - self.start) / self.guess.half - at[START];
        (phase / at[HALF]).ceil().clamp(0.0, 1e6) as usize
    }

    fn sign(&self) -> f64 {
        1f64.copysign(self.guess.amplitudes[0])
    }

    /// The displacements of a motion that comes to rest after so many half cycles.
    fn motion(&self, p: &[f64], end: usize) -> Vec<f64> {
        let (zeta, kappa) = (p[ZETA], ratio(p[ZETA]));
        let d = swing(zeta);
        let (start, length) = (self.start + self.guess.half * p[START], self.guess.half * p[HALF]);
        let (mut y, mut n, mut s) = (p[AMPLITUDE], 0usize, self.sign());
        let turn = |t: f64| ((t - start) / length).max(0.0);
        let of = |t: &f64| {
            let phase = turn(*t);
            while n < end && phase > (n + 1) as f64 {
                (y, n, s) = (next(y, kappa, p[FRICTION]), n + 1, -s);
            }
            if n >= end {
                return p[REST] + s * y;
            }
            let angle = PI * (phase - n as f64);
            let (sin, cos) = angle.sin_cos();
            let wave = (-(zeta / d) * angle).exp() * (cos + zeta / d * sin);
            p[REST] + s * (p[FRICTION] + (y - p[FRICTION]) * wave)
        };
        self.window().0.iter().map(of).collect()
    }

    /// The fit of a motion that comes to rest after so many half cycles, or goes on, from several starts; if friction lets
    /// the body go that often.
    fn fit(&self, end: Option<usize>, starts: &[Vec<f64>]) -> Option<Fit> {
        let amplitude = self.guess.amplitudes[0].abs();
        let scales = [amplitude, 0.1, amplitude, amplitude, 1.0, 1.0];
        let half_cycles = end.unwrap_or(usize::MAX);
        let values = self.window().1;
        if values.len() <= scales.len() {
            return None;
        }
        let fit = Fit::best(values, &|p| self.motion(p, half_cycles), starts, &scales, self.tolerance)?;
        let within = self.half_cycles(&fit.at);
        let is_motion = fit.at[HALF] > 0.0
            && fit.at[ZETA].abs() < MOST_DAMPING
            && end.is_none_or(|end| end < within)
            && slides(&fit.at, half_cycles.min(within))
            && fit.at[START].abs() < 1.0;
        is_motion.then_some(fit)
    }

    /// The sum of squares of a start.
    fn sum(&self, end: usize, at: &[f64]) -> f64 {
        self.motion(at, end).iter().zip(self.window().1).map(|(a, b)| (a - b).powi(2)).sum()
    }

    /// Starts for each number of half cycles until rest: a damping, and the friction with which the body then rests at the
    /// rest of the spring, from `y_N = κᴺy₀ − B (1 + κ)(1 − κᴺ)/(1 − κ) = 0`. The best ones first, one for each number.
    fn starts(&self) -> Vec<(usize, Vec<f64>)> {
        let Guess { rest, amplitudes: [first, _], half_cycles, .. } = self.guess;
        let amplitude = first.abs();
        let within = self.half_cycles(&[amplitude, 0.0, 0.0, rest, 0.0, 1.0]);
        let mut starts = Vec::new();
        for end in 1..=(2 * half_cycles + 6).min(within) {
            let of = |zeta: f64| {
                let (kappa, n) = (ratio(zeta), end as f64);
                let left = kappa.powf(n);
                let sum = if zeta > 0.0 { (1.0 + kappa) * (1.0 - left) / (1.0 - kappa) } else { 2.0 * n };
                let start = vec![amplitude, zeta, amplitude * left / sum, rest, 0.0, 1.0];
                (self.sum(end, &start), start)
            };
            let best = DAMPINGS.into_iter().map(of).min_by(|a, b| a.0.total_cmp(&b.0));
            starts.extend(best.map(|(sum, start)| (sum, end, start)));
        }
        starts.sort_by(|a, b| a.0.total_cmp(&b.0));
        starts.into_iter().map(|(_, end, start)| (end, start)).collect()
    }

    /// The fits with the numbers of half cycles near the best one.
    fn explored(&self) -> Vec<Ending> {
        let Guess { rest, amplitudes: [first, last], half_cycles, .. } = self.guess;
        let (amplitude, steps) = (first.abs(), half_cycles as f64);
        let decrement = ((amplitude / last).ln() / steps / PI).clamp(0.0, 0.9);
        let going_on = [
            vec![amplitude, 0.0, (amplitude - last) / steps / 2.0, rest, 0.0, 1.0],
            vec![amplitude, decrement, 0.0, rest, 0.0, 1.0],
        ];
        let mut fits: Vec<Ending> = Vec::new();
        fits.extend(self.fit(None, &going_on).map(|fit| (None, fit)));
        let starts = self.starts();
        for (end, start) in starts.iter().take(STARTS) {
            fits.extend(self.fit(Some(*end), core::slice::from_ref(start)).map(|fit| (Some(*end), fit)));
        }
        let least = |fits: &[Ending]| fits.iter().map(|f| f.1.sum).fold(f64::INFINITY, f64::min);
        // Upwards and downwards from the best, each from the fit before and from its own start.
        let at_rest = fits.iter().filter(|(end, _)| end.is_some());
        let best =
            at_rest.min_by(|a, b| a.1.sum.total_cmp(&b.1.sum)).map(|(end, fit)| (*end, fit.at.clone()));
        let Some((Some(middle), at)) = best else { return fits };
        for is_up in [true, false] {
            let mut from = at.clone();
            let (mut end, mut beyond) = (middle, 0);
            while beyond < BEYOND && (is_up || end > 1) {
                end = if is_up { end + 1 } else { end - 1 };
                let known = least(&fits);
                let own = starts.iter().find(|start| start.0 == end).map(|start| start.1.clone());
                let from_both: Vec<Vec<f64>> = [Some(from.clone()), own].into_iter().flatten().collect();
                let found = self.fit(Some(end), &from_both);
                beyond = if found.as_ref().is_some_and(|fit| fit.sum < known) { 0 } else { beyond + 1 };
                if let Some(fit) = found {
                    from.clone_from(&fit.at);
                    fits.push((Some(end), fit));
                }
            }
        }
        // The others are worse by more than chance, with the few samples, too.
        let least = least(&fits);
        fits.retain(|(_, fit)| {
            fit.sum <= least * (1.0 + 25.0 / fit.degrees_of_freedom()) + f64::MIN_POSITIVE
        });
        fits.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.sum.total_cmp(&b.1.sum)));
        fits.dedup_by_key(|(end, _)| *end);
        fits
    }

    /// The answer, unless the samples are noise or are not explained.
    fn answer(&self, fits: &Alike) -> Result<DecayIdentified, Error> {
        let (best, values) = (fits.best(), self.window().1);
        let count = values.len() as f64;
        let mean = values.iter().sum::<f64>() / count;
        let spread: f64 = values.iter().map(|x| (x - mean).powi(2)).sum();
        // The best of many frequencies explains some of any noise.
        if count * (spread / best.sum).ln() < 30.0 + 2.0 * count.ln() {
            return Err(Error::NoDecay { noise: written((spread / count).sqrt()) });
        }
        let mut found = identified(fits)?;
        let (amplitude, noise) = (best.at[AMPLITUDE], best.noise());
        if noise > MOST_NOISE * amplitude || noise * best.correlation().sqrt() > MISFIT * amplitude {
            return Err(Error::DecayUnexplained { misfit: written(noise / amplitude) });
        }
        let half_cycles = fits.half_cycles().unwrap_or(usize::MAX).min(self.half_cycles(&best.at));
        let count = half_cycles + usize::from(fits.half_cycles().is_some());
        if count < LEAST {
            return Err(Error::DecayTooShort { count, least: LEAST });
        }
        let (zeta, length) = (best.at[ZETA], self.guess.half * best.at[HALF]);
        let d = swing(zeta);
        let value = PI / (length * d);
        let spread = (fits.error(HALF) / best.at[HALF]).hypot(zeta * fits.error(ZETA) / (d * d));
        found.natural_frequency = Some(best.estimate(value, value * spread, f64::INFINITY));
        found.half_cycles = fits.half_cycles();
        found.static_friction_displacement = fits.at_rest().map(|all| {
            let bounds = all.into_iter().map(|(n, at)| held(at, n));
            bounds.fold((f64::INFINITY, 0.0), |all, one| (all.0.min(one.0), f64::max(all.1, one.1)))
        });
        let (mut y, mut sign) = (best.at[AMPLITUDE], self.sign());
        found.turning_points = (0..count)
            .map(|i| {
                let time = self.start + self.guess.half * best.at[START] + length * i as f64;
                let point = (Some(time), sign * y);
                (y, sign) = (next(y, ratio(zeta), best.at[FRICTION]), -sign);
                point
            })
            .collect();
        Ok(found)
    }
}
