//! Measurements that do not belong to the curve, and the least squares over the others.

use super::model::Parameters;
use super::search::{CurveFit, ResponseCurve, Rule, StartGrid, descend, kept};
use crate::machine::error::Error;
use crate::uncertainty::student;
use alloc::vec::Vec;
use core::f64::consts::TAU;
use core::iter::zip;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// Least squares over the values that belong to the curve.
#[derive(Debug, Clone)]
pub(super) struct Judged {
    /// The residuals are those of all amplitudes, then of all phases.
    pub(super) fit: CurveFit,
    /// Whether each residual is too large to count.
    pub(super) suspect: Vec<bool>,
    /// The standard errors of an amplitude and of a phase.
    pub(super) noise: [f64; 2],
    /// (κκ, κζ, ζζ), where the derivatives separate friction from damping.
    pub(super) covariance: Option<[f64; 3]>,
    pub(super) degrees_of_freedom: f64,
}

impl Judged {
    /// The statistics of a fit in which the phases that count have the weight `ratio`, and the amplitudes 1.
    fn of(curve: &ResponseCurve<'_>, fit: CurveFit, ratio: f64) -> Option<(Self, Vec<[f64; 2]>)> {
        let slopes = curve.slopes(fit.at, &fit.residuals)?;
        let suspect: Vec<bool> = fit.weights.iter().map(|w| *w <= 0.0).collect();
        let count = suspect.iter().filter(|is_suspect| !**is_suspect).count();
        let degrees_of_freedom = count.saturating_sub(2).max(1) as f64;
        let variance = (fit.sum / degrees_of_freedom).max(least_variance());
        let covariance = fit.normal(&slopes).inverse().map(|inverse| inverse.map(|x| x * variance));
        let noise = [variance.sqrt(), (variance / ratio).sqrt()];
        Some((Self { fit, suspect, noise, covariance, degrees_of_freedom }, slopes))
    }

    /// The same selection at another minimum.
    pub(super) fn moved(&self, curve: &ResponseCurve<'_>, fit: CurveFit) -> Option<Self> {
        Self::of(curve, fit, (self.noise[0] / self.noise[1]).powi(2)).map(|(judged, _)| judged)
    }

    /// The sum of squares of the values that count, in units of their noise.
    fn sum(&self, counts: [usize; 2]) -> f64 {
        let counted =
            zip(&self.fit.residuals, &self.suspect).enumerate().filter(|(_, (_, is_suspect))| !**is_suspect);
        counted.map(|(i, (r, _))| (r / of_kind(i, counts, self.noise)).powi(2)).sum()
    }

    /// The logarithm of how well this explains all values, in units of which twice the difference is chance by itself: less
    /// is better. A value that is left out costs as much as its deviation as a parameter chosen among n.
    pub(super) fn misfit(&self, counts: [usize; 2]) -> f64 {
        let n = self.suspect.len() as f64;
        let kinds = [(counts[0], self.noise[0]), (counts[1], self.noise[1])];
        let noise: f64 = kinds.iter().map(|(count, noise)| *count as f64 * noise.max(LEAST_NOISE).ln()).sum();
        let left_out = self.suspect.iter().filter(|is_suspect| **is_suspect).count() as f64;
        noise + left_out * (n.ln() - FALSE_ALARM.ln())
    }
}

/// The number of times that the noise of the two kinds of values is weighed.
const WEIGHINGS: usize = 6;
/// The residual below which nothing is suspect, because the exact motion is no more accurate.
const LEAST_NOISE: f64 = 1e-9;
/// The least variance of the residuals.
pub(super) fn least_variance() -> f64 {
    LEAST_NOISE.powi(2) / 100.0
}
/// The chance that a curve without a wrong value has a suspect one.
const FALSE_ALARM: f64 = 1e-5;
/// The least number of values of a kind from which single values are judged and the noise of the kind is
/// estimated.
const FEW: usize = 7;
/// The greatest number of selections.
const ROUNDS: usize = 100;
/// The number of starts for the sum of a selection.
const STARTS: usize = 3;

/// The place of a value in the selection.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Selection {
    Counted,
    Outside,
    /// The value was counted and is now left out.
    Removed,
    /// The value is counted for good: it was removed once, and the others agreed with it.
    Restored,
}

impl Selection {
    fn counts(self) -> bool {
        matches!(self, Self::Counted | Self::Restored)
    }
}

/// Whether a sum of squares is larger than another one by more than chance, with their degrees of freedom:
/// beyond the 99.9 % quantile of the ratio, whose logarithm is nearly normal.
pub(super) fn is_larger(ratio: f64, degrees: [f64; 2]) -> bool {
    let [m, n] = degrees.map(|d| (d - 1.0).max(1.0));
    ratio.ln() > 3.09 * (2.0 / m + 2.0 / n).sqrt()
}

/// The least squares over all values, unless leaving some out explains the others better than chance would.
///
/// The values that the others contradict are those of [`selected`], k of n. They are left out where their k deviations, as
/// parameters of their own, lessen the sum of squares by more than the best of all choices of k values would by chance:
/// with the ratio x of the two sums, `C(n, k) I_x((n − k − 2)/2, k/2) < 10⁻⁵` by the F distribution. So a model that
/// explains all values keeps all values, however far a single one pulls.
///
/// # Errors
/// As for [`selected`], where there is no fit of all values either.
pub(super) fn judge(
    curve: &ResponseCurve<'_>,
    start: Parameters,
    grid: Option<&StartGrid>,
) -> Result<Judged, Error> {
    let all = whole(curve, start, grid);
    let some = selected(curve, start, grid);
    let (all, some) = match (all, some) {
        (Ok(all), Ok(some)) => (all, some),
        (all, some) => return all.or(some),
    };
    let counts = curve.counts();
    let left_out = some.suspect.iter().filter(|is_suspect| **is_suspect).count();
    if left_out == 0 {
        return Ok(if some.misfit(counts) < all.misfit(counts) { some } else { all });
    }
    // Both sums in units of the noise of the selection.
    let of_all: f64 =
        all.fit.residuals.iter().enumerate().map(|(i, r)| (r / of_kind(i, counts, some.noise)).powi(2)).sum();
    let ratio = some.sum(counts) / of_all;
    Ok(if is_no_chance(ratio, some.suspect.len(), left_out) { some } else { all })
}

/// The least squares over all values, each kind with its own noise if the two differ by more than chance.
fn whole(curve: &ResponseCurve<'_>, start: Parameters, grid: Option<&StartGrid>) -> Result<Judged, Error> {
    let counts = curve.counts();
    let (mut ratio, mut at) = (1.0, start);
    let mut found = None;
    for _ in 0..WEIGHINGS {
        let weights: Vec<f64> =
            (0..counts[0].saturating_add(counts[1])).map(|i| of_kind(i, counts, [1.0, ratio])).collect();
        let rule = Rule::Weighted(&weights);
        let near = descend(curve, rule, at);
        let others = grid.map_or(Err(Error::NotIdentified), |grid| grid.best(curve, rule, STARTS));
        let fit = match (near, others) {
            (Ok(near), Ok(other)) => {
                if other.sum < near.sum {
                    other
                } else {
                    near
                }
            }
            (near, other) => near.or(other)?,
        };
        at = fit.at;
        let next = own_noise(of_each(&fit, &weights, counts), numbers(&weights, counts));
        let is_same = (next / ratio).ln().abs() <= 0.05;
        found = Some((fit, ratio));
        ratio = next;
        if is_same {
            break;
        }
    }
    let (fit, ratio) = found.ok_or(Error::NotIdentified)?;
    Judged::of(curve, fit, ratio).map(|(judged, _)| judged).ok_or(Error::NotIdentified)
}

/// Whether the ratio of the sum of squares without k of n values to that with them is below what chance would make of the
/// best choice of them.
fn is_no_chance(ratio: f64, n: usize, k: usize) -> bool {
    let (n, k) = (n as f64, k as f64);
    let (a, b) = ((n - k - 2.0) / 2.0, k / 2.0);
    if a < 0.5 || ratio > 0.99 {
        return false;
    }
    let choices = ln_gamma(n + 1.0) - ln_gamma(k + 1.0) - ln_gamma(n - k + 1.0);
    // I_x(a, b) = xᵃ (1 − x)ᵇ/(a B(a, b)) Σ (a + b)ᵢ/(a + 1)ᵢ xⁱ, whose terms fall at least as xⁱ (1 + b/i).
    let (mut term, mut sum, mut i) = (1.0, 1.0, 0.0);
    while term > 1e-6 * sum && i < 1e5 {
        term *= ratio * (a + b + i) / (a + 1.0 + i);
        sum += term;
        i += 1.0;
    }
    let beta = ln_gamma(a) + ln_gamma(b) - ln_gamma(a + b);
    let chance =
        a * ratio.max(f64::MIN_POSITIVE).ln() + b * (1.0 - ratio).ln() - a.ln() - beta + f64::ln(sum);
    choices + chance < FALSE_ALARM.ln()
}

/// ln Γ(x) for x ≥ 1/2 by Stirling's series from 8 on, to 1e-10.
fn ln_gamma(x: f64) -> f64 {
    let (mut x, mut product) = (x, 1.0);
    while x < 8.0 {
        product *= x;
        x += 1.0;
    }
    let square = x * x;
    let series = (1.0 / 12.0 - (1.0 / 360.0 - 1.0 / (1260.0 * square)) / square) / x;
    (x - 0.5) * x.ln() - x + 0.5 * TAU.ln() + series - f64::ln(product)
}

/// The least squares over the values that a trimmed fit explains, to which all others are added that lie
/// within the errors of a prediction; values that turn out to lie beyond are removed one by one. A value
/// changes its place at most three times, so that the selection ends. With a grid of starts for this curve, the sum
/// of the selection is compared with the least from these.
///
/// # Errors
/// [`Error::NotIdentified`] where the selection or a descent does not end.
fn selected(curve: &ResponseCurve<'_>, start: Parameters, grid: Option<&StartGrid>) -> Result<Judged, Error> {
    let counts = curve.counts();
    let trimmed = descend(curve, Rule::Trimmed, start)?;
    let spread = spread(&trimmed.residuals, counts);
    let mut ratio = own_noise(spread, counts.map(|n| kept(n) as f64));
    let mut places = core(curve, &trimmed, spread)?;
    let mut at = trimmed.at;
    for round in 0..ROUNDS {
        let weight = |(i, place): (usize, &Selection)| {
            if place.counts() { of_kind(i, counts, [1.0, ratio]) } else { 0.0 }
        };
        let weights: Vec<f64> = places.iter().enumerate().map(weight).collect();
        let fit = descend(curve, Rule::Weighted(&weights), at)?;
        at = fit.at;
        let (judged, slopes) = Judged::of(curve, fit, ratio).ok_or(Error::NotIdentified)?;
        let Judged { fit, noise, covariance, degrees_of_freedom, .. } = &judged;
        let (noise, covariance, degrees_of_freedom) = (*noise, *covariance, *degrees_of_freedom);
        let variance = noise[0].powi(2);
        let count = weights.iter().filter(|w| **w > 0.0).count();
        let limit = quantile(FALSE_ALARM / count as f64, degrees_of_freedom);
        let mut has_changed = false;
        // These are values outside the selection that a prediction covers. The noise of the smaller residuals
        // alone is too small.
        let cut_off = of_smaller(count as f64 / places.len() as f64);
        for (i, ((place, r), slope)) in zip(zip(&mut places, &fit.residuals), &slopes).enumerate() {
            let error = (of_kind(i, counts, noise) / cut_off)
                .max(LEAST_NOISE)
                .hypot(of_prediction(covariance, slope));
            if !place.counts() && r.abs() <= limit * error {
                *place = if *place == Selection::Outside { Selection::Counted } else { Selection::Restored };
                has_changed = true;
            }
        }
        if !has_changed {
            let alone = fit.normal(&slopes).inverse_within(at).map(|inverse| inverse.map(|x| x * variance));
            // The deviation of the value from its prediction by the others, divided by its standard error
            // without the value.
            let beyond = |i: usize| -> f64 {
                let [Some(r), Some(w)] = [&fit.residuals, &fit.weights].map(|v| v.get(i)) else { return 0.0 };
                let Some(slope) = slopes.get(i).filter(|_| *w > 0.0 && of_kind(i, counts, counts) >= FEW)
                else {
                    return 0.0;
                };
                let rest = 1.0 - (w * of_prediction(alone, slope).powi(2) / variance).min(1.0);
                let own = w * r * r / rest;
                let others = (fit.sum - own).max(0.0) / (degrees_of_freedom - 1.0).max(1.0);
                // A value that alone determines a parameter has no residual.
                if rest > 1e-6 { (own / others.max(LEAST_NOISE.powi(2))).sqrt() / limit } else { 0.0 }
            };
            let counted = (0..places.len()).filter(|&i| places.get(i) == Some(&Selection::Counted));
            let worst = counted.max_by(|&i, &j| beyond(i).total_cmp(&beyond(j)));
            if let Some(worst) = worst.filter(|&i| beyond(i) > 1.0)
                && let Some(place) = places.get_mut(worst)
            {
                *place = Selection::Removed;
                has_changed = true;
            }
        }
        let next = own_noise(of_each(fit, &weights, counts), numbers(&weights, counts));
        // At the limit of chance the weight could alternate for ever.
        if round < ROUNDS / 10 && (next / ratio).ln().abs() > 0.05 {
            ratio = next;
            has_changed = true;
        }
        if !has_changed {
            let others = grid.and_then(|grid| grid.best(curve, Rule::Weighted(&weights), STARTS).ok());
            if let Some(better) = others.filter(|other| other.sum < fit.sum * (1.0 - 1e-6)) {
                at = better.at;
                continue;
            }
            return Ok(judged);
        }
    }
    Err(Error::NotIdentified)
}

/// The entry for amplitudes or for phases, by the kind of a residual.
fn of_kind<T>(index: usize, counts: [usize; 2], [amplitude, phase]: [T; 2]) -> T {
    if index < counts[0] { amplitude } else { phase }
}

/// The standard error of a computed value, from the covariance of the parameters.
fn of_prediction(covariance: Option<[f64; 3]>, [x, y]: &[f64; 2]) -> f64 {
    covariance.map_or(f64::INFINITY, |[a, b, c]| (a * x * x + 2.0 * b * x * y + c * y * y).max(0.0).sqrt())
}

/// The values that a trimmed fit explains to 2.5 standard errors, as its median residual gives them.
fn core(curve: &ResponseCurve<'_>, trimmed: &CurveFit, spread: [f64; 2]) -> Result<Vec<Selection>, Error> {
    let counts = curve.counts();
    let slopes = curve.slopes(trimmed.at, &trimmed.residuals).ok_or(Error::NotIdentified)?;
    let spread_of = |i: usize| of_kind(i, counts, spread);
    let weights = trimmed.weights.iter().enumerate().map(|(i, w)| w / spread_of(i).powi(2)).collect();
    let covariance = CurveFit { weights, ..trimmed.clone() }.normal(&slopes).inverse();
    let judged = zip(zip(&trimmed.residuals, &trimmed.weights), &slopes).enumerate();
    Ok(judged
        .map(|(i, ((r, weight), slope))| {
            let is_few = of_kind(i, counts, counts) < FEW;
            let of_prediction = if *weight > 0.0 { 0.0 } else { of_prediction(covariance, slope) };
            let within = r.abs() <= 2.5 * spread_of(i).hypot(of_prediction);
            if is_few || within { Selection::Counted } else { Selection::Outside }
        })
        .collect())
}

/// The standard error of each kind of value by its median residual, with the correction of Rousseeuw and
/// Leroy for few of them.
fn spread(residuals: &[f64], counts: [usize; 2]) -> [f64; 2] {
    let (amplitudes, phases) = residuals.split_at(counts[0].min(residuals.len()));
    let of = |group: &[f64]| {
        let mut sizes: Vec<f64> = group.iter().map(|r| r.abs()).collect();
        sizes.sort_by(f64::total_cmp);
        let median = sizes.get(sizes.len() / 2).copied().unwrap_or(0.0);
        let few = 1.0 + 5.0 / (group.len() as f64 - 2.0).max(1.0);
        (1.4826 * few * median).max(LEAST_NOISE)
    };
    [of(amplitudes), of(phases)]
}

/// The weight of a phase beside that of an amplitude: 1, unless the noise of the two differs by more than
/// chance.
fn own_noise([of_amplitude, of_phase]: [f64; 2], numbers: [f64; 2]) -> f64 {
    let ratio = (of_amplitude / of_phase).powi(2);
    let is_enough = numbers.iter().all(|n| *n >= FEW as f64);
    if is_enough && is_larger(ratio.max(1.0 / ratio), numbers) { ratio } else { 1.0 }
}

/// The numbers of amplitudes and of phases that count.
fn numbers(weights: &[f64], counts: [usize; 2]) -> [f64; 2] {
    let (amplitudes, phases) = weights.split_at(counts[0].min(weights.len()));
    [amplitudes, phases].map(|group| group.iter().filter(|w| **w > 0.0).count() as f64)
}

/// The root mean square of the residuals that count, of each kind.
fn of_each(fit: &CurveFit, weights: &[f64], counts: [usize; 2]) -> [f64; 2] {
    let (amplitudes, phases) = fit.residuals.split_at(counts[0].min(fit.residuals.len()));
    let (of_amplitudes, of_phases) = weights.split_at(counts[0].min(weights.len()));
    [(amplitudes, of_amplitudes), (phases, of_phases)].map(|(residuals, weights)| {
        let counted = zip(residuals, weights).filter(|(_, w)| **w > 0.0);
        let (count, sum) = counted.fold((0.0, 0.0), |(n, sum), (r, _)| (n + 1.0, sum + r * r));
        (sum / f64::max(count, 1.0)).sqrt().max(LEAST_NOISE)
    })
}

/// The standard deviation of the smaller part of normal numbers, `√(1 − 2zφ(z)/part)`, z being their greatest.
fn of_smaller(part: f64) -> f64 {
    if part >= 1.0 {
        return 1.0;
    }
    let z = normal(1.0 - part);
    let density = (-0.5 * z * z).exp() / TAU.sqrt();
    (1.0 - 2.0 * z * density / part).max(0.1).sqrt()
}

/// The two-sided quantile of Student's distribution: a value beyond it has this probability.
fn quantile(probability: f64, degrees_of_freedom: f64) -> f64 {
    student(normal(probability), degrees_of_freedom)
}

/// The two-sided quantile of the normal distribution (Abramowitz and Stegun, 26.2.23).
fn normal(probability: f64) -> f64 {
    let t = (-2.0 * (probability / 2.0).ln()).sqrt();
    t - (2.515_517 + t * (0.802_853 + t * 0.010_328))
        / (1.0 + t * (1.432_788 + t * (0.189_269 + t * 0.001_308)))
}
