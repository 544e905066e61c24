//! A polynomial with fast waves on it, over [0, 1]: `p(s) + Σ Re(a e^{μs})`, Re μ ≤ 0.

use super::first_passage::{bernstein, greatest_above, halves, integer, value_and_slope};
use super::matrix::{at, dot};
use crate::float::Float;
use alloc::vec;
use alloc::vec::Vec;

/// A complex number.
pub(super) type Complex<F> = (F, F);

pub(super) fn product<F: Float>((a, b): Complex<F>, (c, d): Complex<F>) -> Complex<F> {
    (a * c - b * d, a * d + b * c)
}

pub(super) fn quotient<F: Float>((a, b): Complex<F>, (c, d): Complex<F>) -> Complex<F> {
    // Scaled, so that squares stay within the range.
    let most = c.abs().or_larger(d.abs());
    let (c, d) = (c / most, d / most);
    let size = (c * c + d * d) * most;
    ((a * c + b * d) / size, (b * c - a * d) / size)
}

pub(super) fn size<F: Float>((a, b): Complex<F>) -> F {
    a.hypot(b)
}

/// `e^{λt}`.
pub(super) fn exp<F: Float>((re, im): Complex<F>, time: F) -> Complex<F> {
    let (sin, cos) = (im * time).sin_cos();
    let size = (re * time).exp();
    (size * cos, size * sin)
}

/// `Σ |a|`.
pub(super) fn reach<F: Float>(waves: &[Complex<F>]) -> F {
    waves.iter().fold(F::int(0), |sum, &a| sum + size(a))
}

/// `−a`.
pub(super) fn opposite<F: Float>(waves: &[Complex<F>]) -> Vec<Complex<F>> {
    waves.iter().map(|&(re, im)| (-re, -im)).collect()
}

/// The fast modes over a step of one unit, in each free state.
#[derive(Debug, Clone)]
pub(super) struct Waves<F> {
    /// μ.
    pub(super) rates: Vec<Complex<F>>,
    /// The amplitudes in each free state.
    pub(super) shapes: Vec<Vec<Complex<F>>>,
}

impl<F: Float> Waves<F> {
    /// Those of a row over the state.
    pub(super) fn of(&self, row: &[F]) -> Vec<Complex<F>> {
        self.from(row, 0)
    }

    /// Those of a row over the states from a place on.
    pub(super) fn from(&self, row: &[F], place: usize) -> Vec<Complex<F>> {
        let mut sum = vec![(F::int(0), F::int(0)); self.rates.len()];
        let shapes = self.shapes.iter().skip(place);
        for (&x, shape) in row.iter().zip(shapes).filter(|(x, _)| **x != F::int(0)) {
            for (sum, &(re, im)) in sum.iter_mut().zip(shape) {
                *sum = (sum.0 + x * re, sum.1 + x * im);
            }
        }
        sum
    }

    /// Those of a free state.
    pub(super) fn at(&self, i: usize) -> &[Complex<F>] {
        self.shapes.get(i).map_or(&[], Vec::as_slice)
    }

    /// Those of the derivative of a free state over a step of this length.
    pub(super) fn slope(&self, i: usize, time: F) -> Vec<Complex<F>> {
        let scaled = |(&a, &rate)| {
            let (re, im) = product(a, rate);
            (re / time, im / time)
        };
        self.at(i).iter().zip(&self.rates).map(scaled).collect()
    }

    /// The greatest value with a polynomial, where it is above `known` by more than `error`.
    pub(super) fn greatest(&self, c: &[F], waves: &[Complex<F>], known: F, error: F) -> F {
        greatest(c, waves, &self.rates, known, error)
    }
}

/// The greatest value, where it is above `known` by more than `error`. Parts whose polynomial and waves together stay below what is known are
/// left out; in the others the waves are polynomials, too, over a radian of the fastest one.
fn greatest<F: Float>(c: &[F], waves: &[Complex<F>], rates: &[Complex<F>], known: F, error: F) -> F {
    let b = bernstein(c);
    let is_finite = |list: &[F]| list.iter().all(|x| x.is_finite());
    if !is_finite(&b) || !waves.iter().all(|x| size(*x).is_finite()) {
        return known;
    }
    let mut search = Search { c, waves, rates, error, best: known };
    search.climb(&b, F::int(0), F::int(1), F::precision());
    search.best
}

struct Search<'a, F> {
    c: &'a [F],
    waves: &'a [Complex<F>],
    rates: &'a [Complex<F>],
    error: F,
    best: F,
}

impl<F: Float> Search<'_, F> {
    fn climb(&mut self, b: &[F], low: F, high: F, depth: u32) {
        let (zero, pairs) = (F::int(0), || self.waves.iter().zip(self.rates));
        // No wave grows.
        let reach = |(&a, &rate): (&Complex<F>, &Complex<F>)| size(a) * (rate.0 * low).exp();
        let all = pairs().fold(zero, |sum, pair| sum + reach(pair));
        if b.iter().all(|&b| b + all <= self.best + self.error) {
            return;
        }
        // A wave that is rounding is none.
        let seen = |pair: &(&Complex<F>, &Complex<F>)| reach(*pair) > self.error * F::ratio(1, 64);
        let fastest = pairs().filter(seen).fold(zero, |most, (_, &rate)| most.or_larger(size(rate)));
        if fastest * (high - low) <= F::int(1) || depth == 0 {
            let polynomial = self.over(low, high - low);
            self.best = greatest_above(&polynomial, self.best, self.error);
            return;
        }
        let middle = low + (high - low) / F::int(2);
        for s in [low, middle, high] {
            let waves = pairs().fold(zero, |sum, (&a, &rate)| sum + product(exp(rate, s), a).0);
            self.best = self.best.or_larger(value_and_slope(self.c, s).0 + waves);
        }
        let (left, right) = halves(b);
        self.climb(&left, low, middle, depth - 1);
        self.climb(&right, middle, high, depth - 1);
    }

    /// The polynomial of all over a part.
    fn over(&self, low: F, length: F) -> Vec<F> {
        // Horner's scheme gives p(low + s), then powers of the length.
        let mut list = self.c.to_vec();
        let degree = list.len().saturating_sub(1);
        for from in 0..degree {
            for k in (from..degree).rev() {
                let above = at(&list, k + 1);
                if let Some(place) = list.get_mut(k) {
                    *place = *place + low * above;
                }
            }
        }
        let mut factor = F::int(1);
        for c in &mut list {
            *c = *c * factor;
            factor = factor * length;
        }
        // The terms of eˣ, |x| ≤ 1, to rounding.
        list.resize(list.len().max(WAVE_TERMS), F::int(0));
        for (&a, &rate) in self.waves.iter().zip(self.rates) {
            let by = (rate.0 * length, rate.1 * length);
            // Faster than those that are seen: it is rounding.
            if size(by) > F::int(1) {
                continue;
            }
            let mut term = product(exp(rate, low), a);
            for (k, c) in list.iter_mut().take(WAVE_TERMS).enumerate() {
                *c = *c + term.0;
                let (re, im) = product(term, by);
                let next = integer::<F>(k + 1);
                term = (re / next, im / next);
            }
        }
        list
    }
}

/// The terms of eˣ, |x| ≤ 1, above rounding at f64.
const WAVE_TERMS: usize = 20;

/// `∫₀¹ sᵏ e^{μs} ds` for k = 0 … `count` − 1. Of `μ I_k + k I_{k−1} = e^μ` each place follows from the one below where k ≤ |μ|, and from
/// the one above elsewhere, so that no rounding grows.
fn moments<F: Float>(rate: Complex<F>, count: usize) -> Vec<Complex<F>> {
    let (end, most) = (exp(rate, F::int(1)), size(rate));
    let mut list = vec![(F::int(0), F::int(0)); count];
    let mut last = (F::int(0), F::int(0));
    let mut risen = 0;
    for (k, place) in list.iter_mut().enumerate() {
        let by = integer::<F>(k.max(1));
        if most < by {
            break;
        }
        let from = if k == 0 { (F::int(1), F::int(0)) } else { (by * last.0, by * last.1) };
        last = quotient((end.0 - from.0, end.1 - from.1), rate);
        *place = last;
        risen = k + 1;
    }
    if risen == count {
        return list;
    }
    // From an end that is so far away that it does not matter.
    let mut last = (F::int(0), F::int(0));
    for k in (risen + 1..=4 * count.max(24) + 32).rev() {
        let (re, im) = product(rate, last);
        let by = integer::<F>(k);
        last = ((end.0 - re) / by, (end.1 - im) / by);
        if let Some(place) = list.get_mut(k - 1) {
            *place = last;
        }
    }
    list
}

/// `(e^μ − 1)/μ`.
fn mean<F: Float>(rate: Complex<F>) -> Complex<F> {
    moments(rate, 1).first().copied().unwrap_or((F::int(0), F::int(0)))
}

/// The integrals of products of two such functions.
pub(super) struct Products<F> {
    /// The moments of each wave.
    single: Vec<[Vec<F>; 2]>,
    /// The means of the products of waves, `e^{(μ + ν)s}` and `e^{(μ + ν̄)s}`.
    double: Vec<Vec<[Complex<F>; 2]>>,
}

impl<F: Float> Products<F> {
    pub(super) fn new(rates: &[Complex<F>], count: usize) -> Self {
        let single = rates.iter().map(|&rate| {
            let (re, im) = moments(rate, count).into_iter().unzip();
            [re, im]
        });
        let double = rates.iter().map(|&(a, b)| {
            let with = |&(c, d): &Complex<F>| [mean((a + c, b + d)), mean((a + c, b - d))];
            rates.iter().map(with).collect()
        });
        Self { single: single.collect(), double: double.collect() }
    }

    /// `∫₀¹ (p + Σ Re(a e^{μs})) (q + Σ Re(b e^{μs})) ds` without that of p q.
    pub(super) fn beside(&self, (p, a): (&[F], &[Complex<F>]), (q, b): (&[F], &[Complex<F>])) -> F {
        let mut sum = F::int(0);
        for (list, waves) in [(q, a), (p, b)] {
            for (&(re, im), [first, second]) in waves.iter().zip(&self.single) {
                sum = sum + re * dot(list, first) - im * dot(list, second);
            }
        }
        let half = F::ratio(1, 2);
        for (&a, row) in a.iter().zip(&self.double) {
            for (&b, &[both, turned]) in b.iter().zip(row) {
                sum = sum
                    + half * (product(product(a, b), both).0 + product(product(a, (b.0, -b.1)), turned).0);
            }
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `∫ s² e^{μs} ds = e^μ (1/μ − 2/μ² + 2/μ³) − 2/μ³`, and series where |μ| is small.
    #[test]
    fn moments_are_those_of_the_closed_form() {
        for rate in [(-3.0, 40.0), (0.0, 1e4), (-50.0, 0.0), (-1e5, 0.0), (0.0, 26.0), (-2.0, 20.0)] {
            let found = moments::<f64>(rate, 20);
            let one = quotient((1.0, 0.0), rate);
            let (two, three) = (product(one, one), product(one, product(one, one)));
            let end = product(
                exp(rate, 1.0),
                (one.0 - 2.0 * two.0 + 2.0 * three.0, one.1 - 2.0 * two.1 + 2.0 * three.1),
            );
            let due = (end.0 - 2.0 * three.0, end.1 - 2.0 * three.1);
            let error = size((found[2].0 - due.0, found[2].1 - due.1));
            assert!(error < 4e-15 * size(one), "{rate:?} {:?} {due:?}", found[2]);
        }
        let rates = [
            (0.0, 0.0),
            (-1e-9, 0.0),
            (0.0, 0.5),
            (-3.0, 1.0),
            (0.0, 6.2),
            (0.0, 23.9),
            (-23.0, 3.0),
            (0.0, 25.0),
        ];
        for rate in rates {
            // ∫ sᵏ e^{μs} ds by Boole's rule with 4,096 parts.
            for k in [0, 1, 3, 19] {
                let f = |i: i32| {
                    let s = f64::from(i) / 4096.0;
                    let (re, im) = exp(rate, s);
                    (s.powi(k) * re, s.powi(k) * im)
                };
                let weight = |i: i32| match i % 4 {
                    _ if i == 0 || i == 4096 => 7.0,
                    0 => 14.0,
                    2 => 12.0,
                    _ => 32.0,
                };
                let sum = (0..=4096)
                    .fold((0.0, 0.0), |sum, i| (sum.0 + weight(i) * f(i).0, sum.1 + weight(i) * f(i).1));
                let by = 2.0 / (45.0 * 4096.0);
                let due = (sum.0 * by, sum.1 * by);
                let found = moments::<f64>(rate, 20)[k as usize];
                assert!(size((found.0 - due.0, found.1 - due.1)) < 1e-14, "{rate:?} {k} {found:?} {due:?}");
            }
        }
    }

    /// The greatest value and the integral of a product, beside dense sampling.
    #[test]
    fn waves_on_a_polynomial_are_those_of_dense_samples() {
        let c = [0.1, 1.0, -1.3, 0.2];
        let q = [-0.3, 0.4, 0.7];
        let waves = [(0.01, 0.02), (-0.2, 0.0), (1e-3, -2e-3), (-0.4, 0.0)];
        let others = [(0.5, -0.1), (0.3, 0.0), (0.0, 0.2), (0.0, 0.0)];
        let rates = [(-0.2, 900.0), (-30.0, 0.0), (0.0, 170.0), (-2e4, 0.0)];
        let value = |c: &[f64], waves: &[(f64, f64)], s: f64| {
            value_and_slope(c, s).0
                + waves.iter().zip(&rates).map(|(&a, &rate)| product(exp(rate, s), a).0).sum::<f64>()
        };
        let count = 1 << 18;
        let at = |i: i32| f64::from(i) / f64::from(count);
        let due = (0..=count).map(|i| value(&c, &waves, at(i))).fold(f64::MIN, f64::max);
        let found = greatest(&c, &waves, &rates, -9.0, 1e-15);
        // Half a part from a crest of the curvature Σ |a||μ|² = 1.9·10⁴ a sample is 3.5·10⁻⁸ low.
        assert!(found >= due && found - due < 3.5e-8, "{found} {due}");
        assert_eq!(greatest(&c, &waves, &rates, found, 1e-14), found);
        // A wave that is rounding everywhere adds nothing.
        let crest = greatest(&c, &[(1e-18, 0.0)], &[(-300.0, 0.0)], -9.0, 1e-15);
        assert!((crest - greatest_above(&c, -9.0, 1e-15)).abs() < 1e-14, "{crest}");
        let middle = |i: i32| (f64::from(i) + 0.5) / f64::from(count);
        let integral = (0..count)
            .map(|i| {
                let s = middle(i);
                value(&c, &waves, s) * value(&q, &others, s)
                    - value_and_slope(&c, s).0 * value_and_slope(&q, s).0
            })
            .sum::<f64>()
            / f64::from(count);
        let found = Products::new(&rates, 8).beside((&c, &waves), (&q, &others));
        assert!((found - integral).abs() < 1e-7, "{found} {integral}");
    }
}
