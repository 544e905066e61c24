//! The load between its samples.
//!
//! A motion follows straight lines between the samples exactly. The lines through samples of a wave with the phase a from sample
//! to sample have the fundamental `sinc²(a/2)` of it, a²/12 too little; their overtones hardly move the body. With
//! `s = 4 sin²(a/2)`, the factor `a²/s = 1 + s/12 + s²/90 + s³/560 + …` restores it, and s is −δ², the second difference.

use crate::design::least_squares::inverse;
use crate::motion::record::Record;
use alloc::vec;
use alloc::vec::Vec;
use core::f64::consts::PI;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// The coefficients of s² and s³ in those of s and s².
const SECOND: f64 = 12.0 / 90.0;
const THIRD: f64 = 90.0 / 560.0;
/// The part by which equal steps may differ.
const EQUAL: f64 = 1e-6;
/// The samples around one over which a term has to be smooth.
const AROUND: usize = 2;
/// The samples of a cycle from which lines are drawn through a harmonic load.
const LINES: f64 = 64.0;
/// The greatest number of those lines.
const MOST_LINES: f64 = 1e5;
/// The scatter of a harmonic load, as a part of its amplitude.
const SCATTER: f64 = 0.02;

/// A load for lines between samples, and what is left out of it.
pub(super) struct Between {
    pub(super) load: Record<f64>,
    /// The first term that is left out, at each sample.
    pub(super) rest: Option<Record<f64>>,
}

impl Between {
    /// The samples with straight lines between them.
    pub(super) fn straight(load: &Record<f64>) -> Self {
        Self { load: load.clone(), rest: None }
    }

    /// A load that is smooth where the differences of its samples fall, so that lines have the order that they allow; `None`
    /// where they allow no more than the lines between the samples.
    pub(super) fn smooth(load: &Record<f64>) -> Option<Self> {
        let samples = load.samples();
        let steps: Vec<f64> =
            (1..samples.len()).map(|i| load.time(i) - load.time(i.saturating_sub(1))).collect();
        // The first term is right for unequal steps, too: an interval of h has the bend h³f″/12.
        let first = inner(samples, &steps, |[a, b, c], [h, g]| {
            let bend = 2.0 * ((c - b) / g - (b - a) / h) / (h + g);
            if h > 0.0 && g > 0.0 { -(h.powi(3) + g.powi(3)) / (h + g) * bend / 12.0 } else { f64::NAN }
        });
        let further = |term: &[f64], factor: f64| {
            inner(term, &steps, |[a, b, c], [h, g]| {
                if (h - g).abs() <= EQUAL * h { factor * (2.0 * b - a - c) } else { f64::NAN }
            })
        };
        let second = further(&first, SECOND);
        let third = further(&second, THIRD);
        let falls = [falls(&first, &second, SECOND), falls(&second, &third, THIRD)];
        let (mut all, mut rest, mut is_any) = (samples.to_vec(), vec![0.0; samples.len()], false);
        for (i, (value, rest)) in all.iter_mut().zip(&mut rest).enumerate() {
            let of = |term: &[f64]| term.get(i).copied().filter(|x| x.is_finite()).unwrap_or(0.0);
            let is = |which: &[bool]| which.get(i).copied().unwrap_or(false);
            let terms = [of(&first), of(&second), of(&third)];
            let taken = match [is(&falls[0]), is(&falls[1])] {
                [true, true] => 2,
                [true, false] => 1,
                _ => 0,
            };
            is_any |= taken > 0;
            *value += terms.iter().take(taken).sum::<f64>();
            *rest = terms.get(taken).copied().unwrap_or(0.0);
        }
        if !is_any {
            return None;
        }
        rest.iter_mut().zip(&all).for_each(|(rest, value)| *rest += value);
        Some(Self { load: load.with_samples(all)?, rest: load.with_samples(rest) })
    }

    /// A load that is a constant and a harmonic but for independent errors of its samples.
    pub(super) fn harmonic(load: &Record<f64>) -> Option<Self> {
        let wave = Wave::through(load)?;
        let last = load.samples().len().saturating_sub(1);
        let lines = LINES * wave.frequency * (load.end() - load.time(0)) / (2.0 * PI);
        let parts = (lines.min(MOST_LINES) / last as f64).ceil().max(1.0);
        let (mut times, mut values) = (Vec::new(), Vec::new());
        let mut push = |time: f64, factor: f64| {
            times.push(time);
            values.push(wave.mean + factor * wave.swing(time));
        };
        let mut factor = 1.0;
        for i in 0..last {
            let (from, to) = (load.time(i), load.time(i.saturating_add(1)));
            let step = (to - from) / parts;
            let half = wave.frequency * step / 2.0;
            if half > 0.0 {
                factor = (half / half.sin()).powi(2);
                (0..parts as u32).for_each(|part| push(from + f64::from(part) * step, factor));
            }
        }
        push(load.end(), factor);
        let lines = Record::at_times(load.excitation(), times, values).ok()?.followed_by(load.after());
        Some(Self { load: lines, rest: None })
    }
}

/// A function of each three neighbours and the steps between them, at the ends that of the nearest three.
fn inner(values: &[f64], steps: &[f64], of: impl Fn([f64; 3], [f64; 2]) -> f64) -> Vec<f64> {
    let all = values.windows(3).zip(steps.windows(2)).map(|(values, steps)| match (values, steps) {
        (&[a, b, c], &[h, g]) => of([a, b, c], [h, g]),
        _ => f64::NAN,
    });
    let mut found = vec![f64::NAN];
    found.extend(all);
    found.push(f64::NAN);
    let at = |i: usize, found: &[f64]| found.get(i).copied().unwrap_or(f64::NAN);
    let n = found.len();
    let ends = [1, n.saturating_sub(2)].map(|i| at(i, &found));
    for (place, value) in [0, n.saturating_sub(1)].into_iter().zip(ends) {
        if let Some(own) = found.get_mut(place) {
            *own = value;
        }
    }
    found
}

/// Where a term is greater than its second differences, which are the next term over a factor.
fn falls(term: &[f64], next: &[f64], factor: f64) -> Vec<bool> {
    (0..term.len())
        .map(|i| {
            let around = i.saturating_sub(AROUND)..term.len().min(i.saturating_add(AROUND).saturating_add(1));
            let most = |of: &[f64]| {
                let of = of.get(around.clone()).unwrap_or_default();
                of.iter().fold(0.0_f64, |most, x| if x.is_nan() { f64::NAN } else { most.max(x.abs()) })
            };
            most(next) <= factor * most(term) && most(term) > 0.0
        })
        .collect()
}

/// A constant and a harmonic.
struct Wave {
    start: f64,
    frequency: f64,
    mean: f64,
    /// The parts by the cosine and the sine of the time since the start.
    parts: [f64; 2],
}

impl Wave {
    fn swing(&self, time: f64) -> f64 {
        let (sine, cosine) = (self.frequency * (time - self.start)).sin_cos();
        self.parts[0] * cosine + self.parts[1] * sine
    }

    fn at_samples(&self, load: &Record<f64>) -> Vec<f64> {
        (0..load.samples().len()).map(|i| self.mean + self.swing(load.time(i))).collect()
    }

    /// The one through the samples, if they scatter about it independently and little.
    fn through(load: &Record<f64>) -> Option<Self> {
        let samples = load.samples();
        let count = samples.len() as f64;
        let (low, high) = samples
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(*x), high.max(*x)));
        let (middle, size) = (f64::midpoint(low, high), (high - low) / 2.0);
        // The times at which the load crosses the middle on its way from a quarter of its size to the other side's.
        let (mut crossings, mut side, mut crossed) = (Vec::new(), 0.0, None);
        for (i, pair) in samples.windows(2).enumerate() {
            let &[before, after] = pair else { continue };
            let (before, after) = (before - middle, after - middle);
            if before * after <= 0.0 && before != after {
                let (from, to) = (load.time(i), load.time(i.saturating_add(1)));
                crossed = Some(from + (to - from) * before / (before - after));
            }
            if after.abs() > size / 4.0 {
                let changes = side != 0.0 && after.signum() != side;
                side = after.signum();
                crossings.extend(crossed.take().filter(|_| changes));
            }
        }
        let (first, last) = (crossings.first()?, crossings.last()?);
        let turns = crossings.len().saturating_sub(1) as f64;
        if crossings.len() < 3 || last <= first {
            return None;
        }
        let start = load.time(0);
        let mut wave =
            Self { start, frequency: PI * turns / (last - first), mean: middle, parts: [0.0, size] };
        let mut residuals = Vec::new();
        for turn in 0..STEPS {
            // The frequency is a parameter from the second step on.
            let columns = wave.columns(load, turn > 0);
            residuals = wave.at_samples(load).iter().zip(samples).map(|(w, f)| f - w).collect();
            let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
            let matrix: Vec<Vec<f64>> =
                columns.iter().map(|a| columns.iter().map(|b| product(a, b)).collect()).collect();
            let right: Vec<f64> = columns.iter().map(|a| product(a, &residuals)).collect();
            let step: Vec<f64> = inverse(&matrix)?.iter().map(|row| product(row, &right)).collect();
            let of = |i: usize| step.get(i).copied().unwrap_or(0.0);
            wave.mean += of(0);
            wave.parts[0] += of(1);
            wave.parts[1] += of(2);
            wave.frequency += of(3);
        }
        let amplitude = wave.parts[0].hypot(wave.parts[1]);
        let square: f64 = residuals.iter().map(|x| x * x).sum();
        let scatter = (square / count).sqrt();
        let correlation = |by: usize| {
            residuals.iter().zip(residuals.iter().skip(by)).map(|(a, b)| a * b).sum::<f64>() / square
        };
        let is_free = [1, 2, 3].iter().all(|by| correlation(*by).abs() <= 4.0 / count.sqrt());
        let is_wave = amplitude > 0.0 && wave.frequency > 0.0 && scatter.is_finite();
        (is_wave && (scatter <= ROUNDED * amplitude || is_free && scatter <= SCATTER * amplitude))
            .then_some(wave)
    }

    fn columns(&self, load: &Record<f64>, with_frequency: bool) -> Vec<Vec<f64>> {
        let mut columns = vec![Vec::new(); if with_frequency { 4 } else { 3 }];
        for i in 0..load.samples().len() {
            let time = load.time(i) - self.start;
            let (sine, cosine) = (self.frequency * time).sin_cos();
            let slope = time * (self.parts[1] * cosine - self.parts[0] * sine);
            for (column, value) in columns.iter_mut().zip([1.0, cosine, sine, slope]) {
                column.push(value);
            }
        }
        columns
    }
}

/// Steps of the fit of a harmonic.
const STEPS: usize = 12;
/// The scatter of a harmonic load of a few typed digits, as a part of its amplitude.
const ROUNDED: f64 = 1e-4;
