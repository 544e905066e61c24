//! Steps that fast modes do not shorten: the fast modes of a branch apart from the rest.
//!
//! Let λⱼ be fast rates of A, vⱼ and ℓⱼ their right and left vectors, `yⱼ = ℓⱼ z`, and `A′ = A − Σ vⱼ λⱼ ℓⱼ`. Then
//!
//! `e^{As} z = e^{A′s} x + Σ vⱼ e^{λⱼ s} yⱼ`, `x = z − Σ vⱼ yⱼ`.
//!
//! A′ has the slow rates alone. A guard is the Taylor polynomial of `g e^{A′s} x`, with the remainder and the rounding of `branch.rs` for A′
//! and x in place of A and z, and a rest of at most `Σ |g vⱼ| |yⱼ|`, as no fast mode grows. Where the polynomial is above both, the
//! guard has no zero, however fast the modes are. Modes that have died away, or that are small in this guard, do not shorten the step.
//!
//! **Errors of the modes.** The vectors are known to rounding. With `B = ℓ v − 1`, `R = A v − v λ` and `S = ℓ A′` the sum above obeys
//! `z′ = A z − d`, `d = v λ ℓ x(s) + R y(s)`, where `|ℓ x(s)| ≤ |B||y| + s |S| e^{|A′|s} |x|`. So it is off by at most `∫ |g e^{A(s−σ)}| |d| dσ`, and that
//! is at most `2 s G D |z|` with `G = |g|(I + |v||ℓ|) e^{|A′|h} + |g v||ℓ|` and `D = |v||λ|(|B||ℓ| + h |S| e^{|A′|h} (I + |v||ℓ|)) + |R||ℓ|`: the factor 2 is for what is of second
//! order in B, R and S, which are below 2⁻¹⁶. What `(I − v ℓ) A′ (I − v ℓ)` takes out of the rounding of A′ is added to D. It is one more row of numbers for each guard.

use super::assembly::Assembly;
use super::equation::fastest;
use super::first_passage::{bernstein, integer};
use super::guard::{Guard, Series, columns_of, degree_over, series};
use super::matrix::{Matrix, Sparse, add_times, at, dot, entries};
use super::propagator::{Bound, exponential};
use super::spectrum::{Mode, Spectrum};
use super::waves::{Complex, Waves, exp, product, quotient, size};
use crate::float::Float;
use alloc::vec;
use alloc::vec::Vec;

/// A long step is worth it from so many short ones on.
const LEAST: i32 = 8;
/// How much longer the steps must be for a branch to be split.
const GAIN: i32 = 64;

/// A fast mode, or a pair of them: `Re(v e^{λs} ℓ z)`.
#[derive(Debug, Clone)]
struct Fast<F> {
    rate: Complex<F>,
    /// v, of a pair 2 v, over the free states.
    shape: [Vec<F>; 2],
    /// ℓ over the state.
    row: [Vec<F>; 2],
}

/// A guard without the fast modes.
#[derive(Debug, Clone)]
struct Without<F> {
    taylor: Matrix<F>,
    error: Vec<F>,
    /// |g v| of each mode.
    shares: Vec<F>,
}

/// A branch with its fast modes apart.
#[derive(Debug, Clone)]
pub(crate) struct Split<F> {
    fast: Vec<Fast<F>>,
    /// A′ and its transposed matrix.
    slow: Sparse<F>,
    transposed: Sparse<F>,
    pub(super) step: F,
    degree: usize,
    /// The shortest step that is worth it.
    least: F,
    guards: Vec<Without<F>>,
}

/// A step of a split branch.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Leap<'a, F> {
    split: &'a Split<F>,
    amplitudes: &'a [Complex<F>],
    time: F,
}

fn pair<F: Float>(list: &[Vec<F>; 2], i: usize) -> Complex<F> {
    let [re, im] = list;
    (at(re, i), at(im, i))
}

/// `row · (complex vector)`.
fn along<F: Float>(row: &[F], [re, im]: &[Vec<F>; 2]) -> Complex<F> {
    (dot(row, re), dot(row, im))
}

/// |x| of each entry.
fn sizes<F: Float>([re, im]: &[Vec<F>; 2]) -> Vec<F> {
    re.iter().zip(im).map(|(&a, &b)| size((a, b))).collect()
}

impl<F: Float> Fast<F> {
    /// With the row over the loads, from `ℓ A = λ ℓ`.
    fn new(system: &Assembly<F>, a: &Matrix<F>, mode: &Mode) -> Option<Self> {
        let rate = (F::from_f64(mode.rate.re), F::from_f64(mode.rate.im));
        // What grows is no rest; an undamped mode has a rounding.
        if rate.0 > size(rate) * F::epsilon() * F::int(4096) {
            return None;
        }
        let rate = (if rate.0 > F::int(0) { F::int(0) } else { rate.0 }, rate.1);
        let factor = if mode.rate.im == 0.0 { 1.0 } else { 2.0 };
        let shape = [
            mode.shape.iter().map(|x| F::from_f64(factor * x.re)).collect(),
            mode.shape.iter().map(|x| F::from_f64(factor * x.im)).collect(),
        ];
        let mut row: [Vec<F>; 2] = [
            mode.row.iter().map(|x| F::from_f64(x.re)).collect(),
            mode.row.iter().map(|x| F::from_f64(x.im)).collect(),
        ];
        let given: [Vec<F>; 2] = [a.combined(&row[0]), a.combined(&row[1])];
        let by = |i: usize| pair(&given, i);
        row.iter_mut().for_each(|row| row.resize(system.size, F::int(0)));
        let mut set = |i: usize, (re, im): Complex<F>| {
            for (row, x) in row.iter_mut().zip([re, im]) {
                super::matrix::set(row, i, x);
            }
        };
        let scaled = |(a, b): Complex<F>, s: F| (a * s, b * s);
        let plus = |(a, b): Complex<F>, (c, d): Complex<F>| (a + c, b + d);
        for (i, &frequency) in system.frequencies.iter().enumerate() {
            let sin = system.harmonic(i);
            let square = product(rate, rate);
            let both = (square.0 + frequency * frequency, square.1);
            let (p, q) = (by(sin), by(sin + 1));
            set(sin, quotient(plus(product(rate, p), scaled(q, -frequency)), both));
            set(sin + 1, quotient(plus(product(rate, q), scaled(p, frequency)), both));
        }
        for i in 0..system.records.len() {
            let value = system.record(i);
            let own = quotient(by(value), rate);
            set(value, own);
            set(value + 1, quotient(plus(own, by(value + 1)), rate));
        }
        let last = system.size.saturating_sub(1);
        set(last, quotient(by(last), rate));
        let all = row.iter().chain(&shape).flatten().all(|x| x.is_finite());
        all.then_some(Self { rate, shape, row })
    }

    /// y.
    fn amplitude(&self, z: &[F]) -> Complex<F> {
        let [re, im] = &self.row;
        (dot(re, z), dot(im, z))
    }
}

/// `y += s |x| |row|` for each entry of x: the sizes of a product of a column and a row.
fn add_sizes<F: Float>(matrix: &mut Matrix<F>, x: &[F], row: &[F]) {
    for (i, &x) in x.iter().enumerate() {
        if x != F::int(0) {
            add_times(matrix.row_mut(i), x, row);
        }
    }
}

impl<F: Float> Split<F> {
    /// The splits of a branch with this matrix and these guards, whose steps are `short` and at most `longest`: the one with the longest step first. `corners` are
    /// the roundings of guards that are met at the corner of a law.
    pub(crate) fn all(
        system: &Assembly<F>,
        a: &Sparse<F>,
        guards: &[(&Guard<F>, F)],
        short: F,
        longest: F,
        degree: usize,
    ) -> Vec<Self> {
        // Rates at f64 would lose what another number type has; massless joints have velocities that are no states.
        let is_plain =
            size_of::<F>() <= size_of::<f64>() && system.massless.is_empty() && system.levels.is_empty();
        let loads = system.frequencies.iter().fold(F::int(1) / longest, |most, &x| most.or_larger(x));
        let gain = F::int(GAIN);
        if !is_plain || short * loads * gain > F::int(1) {
            return Vec::new();
        }
        let mut free = Matrix::zero(system.free, system.free);
        let mut whole = Matrix::zero(system.free, system.size);
        for (i, row) in a.rows().take(system.free).enumerate() {
            for &(j, x) in row {
                whole.set(i, j, x);
                free.set(i, j, x);
            }
        }
        let Some(spectrum) = Spectrum::new(&free) else { return Vec::new() };
        let mut splits: Vec<Self> = Vec::new();
        for slow in spectrum.gaps(loads.to_f64()) {
            let Some(modes) = spectrum.fast(slow) else { continue };
            let fast: Option<Vec<Fast<F>>> =
                modes.iter().map(|mode| Fast::new(system, &whole, mode)).collect();
            let Some(split) =
                fast.and_then(|fast| Self::new(system, &whole, fast, guards, (short, longest), degree))
            else {
                continue;
            };
            if split.step >= short * gain
                && splits.last().is_none_or(|last| split.step * F::int(LEAST) <= last.step)
            {
                splits.push(split);
            }
        }
        splits
    }

    fn new(
        system: &Assembly<F>,
        whole: &Matrix<F>,
        fast: Vec<Fast<F>>,
        guards: &[(&Guard<F>, F)],
        (short, longest): (F, F),
        degree: usize,
    ) -> Option<Self> {
        let (n, free, zero, one) = (system.size, system.free, F::int(0), F::int(1));
        let minus = |(a, b): Complex<F>, (c, d): Complex<F>| (a - c, b - d);
        // A′.
        let mut rest = whole.clone();
        for mode in &fast {
            for i in 0..free {
                let (re, im) = product(pair(&mode.shape, i), mode.rate);
                let [first, second] = &mode.row;
                add_times(rest.row_mut(i), -re, first);
                add_times(rest.row_mut(i), im, second);
            }
        }
        let mut given = vec![Vec::new(); n.saturating_sub(free)];
        let mut put = |row: usize, entry: (usize, F)| {
            given.get_mut(row - free).into_iter().for_each(|row| row.push(entry))
        };
        for (i, &frequency) in system.frequencies.iter().enumerate() {
            let place = system.harmonic(i);
            put(place, (place + 1, frequency));
            put(place + 1, (place, -frequency));
        }
        for i in 0..system.records.len() {
            put(system.record(i), (system.record(i) + 1, one));
        }
        // The rounding of this difference in the directions of fast modes would drive them without their own force, so that it is taken out:
        // (I − v ℓ) A′ (I − v ℓ).
        let mut taken = Matrix::zero(free, n);
        let first = Sparse::new(n, rest.rows().map(entries).chain(given.iter().cloned()));
        let left: Vec<[Vec<F>; 2]> = fast
            .iter()
            .map(|mode| [&mode.row[0], &mode.row[1]].map(|row| transposed_product(&first, row)))
            .collect();
        for (mode, [re, im]) in fast.iter().zip(&left) {
            for i in 0..free {
                let (by, turned) = pair(&mode.shape, i);
                add_times(taken.row_mut(i), by, re);
                add_times(taken.row_mut(i), -turned, im);
            }
        }
        less(&mut rest, &taken);
        let mut other = Matrix::zero(free, n);
        for mode in &fast {
            let images = [rest.of(&mode.shape[0]), rest.of(&mode.shape[1])];
            for i in 0..free {
                let (by, turned) = pair(&images, i);
                add_times(other.row_mut(i), by, &mode.row[0]);
                add_times(other.row_mut(i), -turned, &mode.row[1]);
            }
        }
        less(&mut rest, &other);
        let slow = Sparse::new(n, rest.rows().map(entries).chain(given));
        let most = one / fastest(system, &slow);
        let step = if most < longest { most } else { longest };
        if !step.is_finite() || step < short {
            return None;
        }
        let transposed = slow.transposed();
        let bound = Bound::new(&transposed.map(|x| x.abs()), free, step, degree);
        let whole_sizes = whole.map(|x| x.abs());
        let (shapes, rows): (Vec<Vec<F>>, Vec<Vec<F>>) =
            fast.iter().map(|mode| (sizes(&mode.shape), sizes(&mode.row))).unzip();
        // I + |v||ℓ|.
        let mut spread = Matrix::identity(n);
        shapes.iter().zip(&rows).for_each(|(shape, row)| add_sizes(&mut spread, shape, row));
        if !shapes.iter().zip(&rows).all(|(shape, row)| dot(shape, row) <= F::exp2i(12)) {
            return None;
        }
        let rounding = F::epsilon() * integer(2 * n + 8);
        let mut defect = taken.map(|x| x.abs());
        defect.plus(&other.map(|x| x.abs()));
        for ((mode, shape), row) in fast.iter().zip(&shapes).zip(&rows) {
            // What is left of ℓ v = 1, of ℓ A′ = 0 and of A v = v λ, each with its own rounding.
            let mut doubt = vec![zero; n];
            for (k, (other, size_of_other)) in fast.iter().zip(&shapes).enumerate() {
                let is_own = core::ptr::eq(other, mode);
                let [first, second] = &mode.row;
                let (a, b) = (along(first, &other.shape), along(second, &other.shape));
                // ℓ v and ℓ v̄: a pair has 2 v.
                let half = if other.rate.1 == zero { one } else { F::ratio(1, 2) };
                let direct = ((a.0 - b.1) * half, (a.1 + b.0) * half);
                let turned = ((a.0 + b.1) * half, (b.0 - a.1) * half);
                let mut off = size(minus(direct, (if is_own { one } else { zero }, zero)));
                if other.rate.1 != zero {
                    off = off + size(turned);
                }
                off = off + dot(row, size_of_other) * rounding;
                let is_small = off * (size(mode.rate) * step + F::int(1)) <= F::exp2i(-16);
                if !is_small {
                    return None;
                }
                add_times(&mut doubt, off, rows.get(k)?);
            }
            let image = [transposed_product(&slow, &mode.row[0]), transposed_product(&slow, &mode.row[1])];
            let mut left = sizes(&image);
            add_times(&mut left, rounding, &whole_sizes.combined(row));
            add_times(&mut left, rounding * size(mode.rate), row);
            left.iter_mut().for_each(|x| *x = *x * step);
            let grown = bound.of(&left);
            add_times(&mut doubt, one, &spread.combined(&grown));
            let fastest = size(mode.rate);
            let by: Vec<F> = shape.iter().map(|&x| x * fastest).collect();
            add_sizes(&mut defect, &by, &doubt);
            let images = [whole.of(&mode.shape[0]), whole.of(&mode.shape[1])];
            let bounds = whole_sizes.of(shape);
            let off: Vec<F> = (0..free)
                .map(|i| {
                    let due = product(mode.rate, pair(&mode.shape, i));
                    size(minus(pair(&images, i), due)) + at(&bounds, i) * rounding
                })
                .collect();
            add_sizes(&mut defect, &off, row);
        }
        let powers = Series { transposed: &transposed, step, bound: &bound, degree };
        let without = guards.iter().map(|&(guard, corner)| {
            let mut row = guard.row.clone();
            let mut reach: Vec<F> = row.iter().map(|x| x.abs()).collect();
            let (mut shares, mut grown) = (Vec::new(), vec![zero; n]);
            for (mode, sizes) in fast.iter().zip(&rows) {
                let (re, im) = along(&guard.row, &mode.shape);
                let share = size((re, im));
                let [first, second] = &mode.row;
                add_times(&mut row, -re, first);
                add_times(&mut row, im, second);
                add_times(&mut reach, share, sizes);
                add_times(&mut grown, share, sizes);
                shares.push(share);
            }
            let terms = powers.terms(&row, degree + 1);
            let mut error = powers.error_of(&powers.rounding(&reach), &terms, degree + 1);
            add_times(&mut grown, one, &bound.of(&reach));
            add_times(&mut error, step * F::int(2), &defect.combined(&grown));
            if let Some(last) = error.last_mut() {
                *last = *last + corner;
            }
            Without { taylor: columns_of(&terms, n, degree + 1), error, shares }
        });
        let guards: Vec<Without<F>> = without.collect();
        let all = guards.iter().flat_map(|guard| &guard.error).all(|x| x.is_finite());
        let least = short * F::int(LEAST);
        all.then_some(Self { fast, slow, transposed, step, degree, least, guards })
    }

    /// The number of its entries in memory.
    pub(crate) fn entries(&self) -> usize {
        let guards: usize = self.guards.iter().map(|guard| guard.taylor.entries() + guard.error.len()).sum();
        let modes: usize = self.fast.iter().map(|mode| 4 * at_len(&mode.row)).sum();
        4 * self.slow.rows().map(<[_]>::len).sum::<usize>() + guards + modes
    }

    /// The longest time, at most `rest`, over which no guard reaches zero, where it is worth a step. It leaves the amplitudes of the fast modes.
    pub(crate) fn clear_time(
        &self,
        z: &[F],
        sizes: &[F],
        rest: F,
        amplitudes: &mut Vec<Complex<F>>,
        c: &mut Vec<F>,
    ) -> Option<F> {
        if rest < self.least {
            return None;
        }
        amplitudes.clear();
        amplitudes.extend(self.fast.iter().map(|mode| mode.amplitude(z)));
        let (zero, half) = (F::int(0), F::ratio(1, 2));
        let mut part = F::int(1);
        while part * self.step * half >= rest {
            part = part * half;
        }
        for guard in &self.guards {
            let waves =
                guard.shares.iter().zip(&*amplitudes).fold(zero, |sum, (&share, &y)| sum + share * size(y));
            let error = dot(&guard.error, sizes) + waves;
            c.resize(guard.taylor.columns(), zero);
            guard.taylor.transposed_of(z, c);
            // Also where it is not a number.
            if !(c.first().is_some_and(|&first| first > error)) {
                return None;
            }
            while !is_above(c, part, error) {
                part = part * half;
                if part * self.step < self.least {
                    return None;
                }
            }
        }
        let time = part * self.step;
        Some(if time > rest { rest } else { time })
    }

    /// The step of this length from a state with these amplitudes.
    pub(crate) const fn leap<'a>(&'a self, amplitudes: &'a [Complex<F>], time: F) -> Leap<'a, F> {
        Leap { split: self, amplitudes, time }
    }
}

fn less<F: Float>(matrix: &mut Matrix<F>, by: &Matrix<F>) {
    matrix.plus(&by.map(|x| -x));
}

/// Whether a polynomial over a part of [0, 1] is above a bound.
fn is_above<F: Float>(c: &[F], part: F, bound: F) -> bool {
    let mut factor = F::int(1);
    let scaled: Vec<F> = c
        .iter()
        .map(|&c| {
            let x = c * factor;
            factor = factor * part;
            x
        })
        .collect();
    let Some((&first, rest)) = scaled.split_first() else { return true };
    let bend = rest.iter().fold(F::int(0), |sum, c| sum + c.abs());
    first - bend > bound || bernstein(&scaled).iter().all(|&b| b > bound)
}

/// `row A`, by A itself.
fn transposed_product<F: Float>(a: &Sparse<F>, row: &[F]) -> Vec<F> {
    let mut result = vec![F::int(0); row.len()];
    for (entries, &x) in a.rows().zip(row) {
        for &(j, a) in entries {
            if let Some(place) = result.get_mut(j) {
                *place = *place + x * a;
            }
        }
    }
    result
}

fn at_len<F>(row: &[Vec<F>; 2]) -> usize {
    row[0].len()
}

impl<F: Float> Leap<'_, F> {
    /// The Taylor terms of the state without its fast modes.
    pub(crate) fn taylor(&self, z: &[F], terms: &mut Vec<F>) {
        terms.clear();
        terms.extend_from_slice(z);
        for (mode, &(re, im)) in self.split.fast.iter().zip(self.amplitudes) {
            let [first, second] = &mode.shape;
            add_times(terms, -re, first);
            add_times(terms, im, second);
        }
        let Split { slow, step, degree, .. } = self.split;
        series(slow, self.time, degree_over(self.time, *step, *degree), z.len(), terms);
    }

    /// `A′ z`.
    pub(crate) fn derivative(&self, z: &[F]) -> Vec<F> {
        let mut result = vec![F::int(0); z.len()];
        self.split.slow.of(z, &mut result);
        result
    }

    /// The state after it.
    pub(crate) fn after(&self, z: &[F], terms: &mut Vec<F>, after: &mut [F]) {
        self.taylor(z, terms);
        after.fill(F::int(0));
        for term in terms.chunks_exact(z.len().max(1)).rev() {
            add_times(after, F::int(1), term);
        }
        for (mode, &y) in self.split.fast.iter().zip(self.amplitudes) {
            let (re, im) = product(exp(mode.rate, self.time), y);
            let [first, second] = &mode.shape;
            add_times(after, re, first);
            add_times(after, -im, second);
        }
    }

    /// `(e^{At})ᵀ` for the free states.
    pub(crate) fn free_motion(&self, free: usize) -> Matrix<F> {
        let Split { fast, transposed, step, degree, .. } = self.split;
        let degree = degree_over(self.time, *step, *degree);
        let mut motion = exponential(transposed, Matrix::identity(free), self.time, degree, None);
        // A′ leaves v as it is.
        for mode in fast {
            let (re, im) = exp(mode.rate, self.time);
            let by = (re - F::int(1), im);
            for j in 0..free {
                let (re, im) = product(by, pair(&mode.row, j));
                let [first, second] = &mode.shape;
                add_times(motion.row_mut(j), re, first);
                add_times(motion.row_mut(j), -im, second);
            }
        }
        motion
    }

    /// The fast modes in the states, where they are above the rounding of the state at either end.
    pub(crate) fn waves(&self, from: &[F], to: &[F]) -> Option<Waves<F>> {
        let zero = F::int(0);
        let mut shapes = Vec::with_capacity(from.len());
        let mut are_seen = false;
        let free = self.split.fast.first().map_or(0, |mode| at_len(&mode.shape));
        for i in 0..free {
            let amplitudes: Vec<Complex<F>> = self
                .split
                .fast
                .iter()
                .zip(self.amplitudes)
                .map(|(mode, &y)| product(pair(&mode.shape, i), y))
                .collect();
            let all = amplitudes.iter().fold(zero, |sum, &x| sum + size(x));
            let most = at(from, i).abs().or_larger(at(to, i).abs());
            are_seen |= all > most * F::epsilon();
            shapes.push(amplitudes);
        }
        let rates = self.split.fast.iter().map(|mode| (mode.rate.0 * self.time, mode.rate.1 * self.time));
        are_seen.then(|| Waves { rates: rates.collect(), shapes })
    }
}
