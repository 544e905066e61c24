//! The fast modes of a matrix: those whose rates are far above the others', with their right and left vectors.
//!
//! The matrix is balanced by powers of two and brought to Schur's form at f64, whose vectors follow by substitution. The left
//! vectors are made dual to the right ones within the fast modes alone, so that the others may be defective, as those of a rigid motion
//! are. Nothing is taken for granted: `split.rs` bounds what is left of the vectors' errors, and refuses modes without such vectors.

use super::matrix::Matrix;
use crate::float::Float;
use alloc::vec::Vec;
use nalgebra::{Complex, DMatrix, Schur};

/// The fast rates are at least so many times the others.
const GAP: f64 = 8.0;
/// The largest matrix whose modes are sought: their time grows as the third power.
const MOST: usize = 64;

/// A mode, or a pair of conjugate ones by the one whose rate has an imaginary part > 0.
pub(super) struct Mode {
    /// λ.
    pub(super) rate: Complex<f64>,
    /// `A v = λ v`.
    pub(super) shape: Vec<Complex<f64>>,
    /// `ℓ A = λ ℓ`, with `ℓ v = 1`.
    pub(super) row: Vec<Complex<f64>>,
}

/// The vectors of a matrix in Schur's form.
pub(super) struct Spectrum {
    matrix: DMatrix<Complex<f64>>,
    turn: DMatrix<Complex<f64>>,
    upper: DMatrix<Complex<f64>>,
    /// The scale of each state.
    scale: Vec<f64>,
    /// The places of the rates, by their sizes.
    order: Vec<usize>,
}

impl Spectrum {
    /// That of the leading rows and columns of a matrix, where it is found.
    pub(super) fn new<F: Float>(a: &Matrix<F>) -> Option<Self> {
        let n = a.columns();
        if n == 0 || n > MOST {
            return None;
        }
        let mut real = DMatrix::<f64>::from_fn(n, n, |i, j| a.at(i, j).to_f64());
        if !real.iter().all(|x| x.is_finite()) {
            return None;
        }
        let scale = balance(&mut real);
        let matrix = real.map(|x| Complex::new(x, 0.0));
        let (turn, upper) = Schur::try_new(matrix.clone(), f64::EPSILON, 1000)?.unpack();
        let mut order: Vec<usize> = (0..n).collect();
        let size = |i: &usize| upper.get((*i, *i)).map_or(0.0, |x: &Complex<f64>| x.norm());
        order.sort_by(|i, j| size(i).total_cmp(&size(j)));
        Some(Self { matrix, turn, upper, scale, order })
    }

    fn rate(&self, place: usize) -> Complex<f64> {
        self.upper.get((place, place)).copied().unwrap_or_default()
    }

    /// The numbers of slow modes beyond which there is a gap, the fewest first; rates below the least one count as that.
    pub(super) fn gaps(&self, least: f64) -> Vec<usize> {
        let size = |k: usize| self.order.get(k).map_or(0.0, |&i| self.rate(i).norm());
        let below = |k: usize| k.checked_sub(1).map_or(0.0, size).max(least);
        (0..self.order.len()).filter(|&k| size(k) > 0.0 && size(k) >= GAP * below(k)).collect()
    }

    /// The fast modes where so many are slow; none where they have no independent vectors.
    pub(super) fn fast(&self, slow: usize) -> Option<Vec<Mode>> {
        let places = self.order.get(slow..)?;
        let n = self.order.len();
        // Rates of a real matrix are real or in pairs.
        let is_real = |rate: Complex<f64>| rate.im.abs() <= rate.norm() * f64::EPSILON * 4096.0;
        let rates: Vec<Complex<f64>> = places.iter().map(|&i| self.rate(i)).collect();
        let above = rates.iter().filter(|r| !is_real(**r) && r.im > 0.0).count();
        let real = rates.iter().filter(|r| is_real(**r)).count();
        if real + 2 * above != rates.len() {
            return None;
        }
        let (mut right, mut left, mut found) = (Vec::new(), Vec::new(), Vec::new());
        for &place in places {
            let rate = self.rate(place);
            if !is_real(rate) && rate.im <= 0.0 {
                continue;
            }
            let (mut v, mut w) = (self.right(place), self.left(place));
            for list in [&mut v, &mut w] {
                turned(list, is_real(rate))?;
            }
            if !is_real(rate) {
                right.push(v.iter().map(|x| x.conj()).collect());
                left.push(w.iter().map(|x| x.conj()).collect::<Vec<_>>());
            }
            found.push(right.len());
            right.push(v);
            left.push(w);
        }
        let m = right.len();
        let mut right = DMatrix::<Complex<f64>>::from_fn(n, m, |i, j| entry(&right, j, i));
        let left = DMatrix::<Complex<f64>>::from_fn(m, n, |i, j| entry(&left, i, j));
        // Twice, so that the rounding of the inverse is taken out.
        let mut dual = (&left * &right).try_inverse()? * left;
        dual = (&dual * &right).try_inverse()? * dual;
        let rates: Vec<Complex<f64>> = (&dual * &self.matrix * &right).diagonal().iter().copied().collect();
        // Vectors from a turned matrix have slow parts of its rounding, which a product with A makes smaller by the ratio of the rates.
        for _ in 0..3 {
            let mut by = &self.matrix * &right;
            by.column_iter_mut().zip(&rates).for_each(|(mut column, rate)| column /= *rate);
            by -= &right;
            by -= &right * (&dual * &by);
            right += by;
            let mut by = &dual * &self.matrix;
            by.row_iter_mut().zip(&rates).for_each(|(mut row, rate)| row /= *rate);
            by -= &dual;
            by -= (&by * &right) * &dual;
            dual += by;
            dual = (&dual * &right).try_inverse()? * dual;
        }
        let images = &self.matrix * &right;
        let modes = found.into_iter().map(|j| {
            let (v, row) = (right.column(j), dual.row(j));
            let rate = (row * images.column(j)).get(0).copied().unwrap_or_default();
            let clean = |x: &Complex<f64>| if is_real(rate) { Complex::new(x.re, 0.0) } else { *x };
            Mode {
                rate: clean(&rate),
                shape: v.iter().zip(&self.scale).map(|(x, s)| clean(x) * *s).collect(),
                row: row.iter().zip(&self.scale).map(|(x, s)| clean(x) / *s).collect(),
            }
        });
        Some(modes.collect())
    }

    /// `T x = λ x` by substitution from the end, turned back.
    fn right(&self, place: usize) -> Vec<Complex<f64>> {
        let mut x = alloc::vec![Complex::default(); self.order.len()];
        set(&mut x, place, Complex::new(1.0, 0.0));
        for i in (0..place).rev() {
            let sum: Complex<f64> = (i + 1..=place).map(|j| self.upper_at(i, j) * at(&x, j)).sum();
            set(&mut x, i, -sum / self.apart(i, place));
        }
        let n = x.len();
        (0..n).map(|i| (0..=place).map(|j| self.turn_at(i, j) * at(&x, j)).sum()).collect()
    }

    /// `y T = λ y`, turned back.
    fn left(&self, place: usize) -> Vec<Complex<f64>> {
        let n = self.order.len();
        let mut y = alloc::vec![Complex::default(); n];
        set(&mut y, place, Complex::new(1.0, 0.0));
        for j in place + 1..n {
            let sum: Complex<f64> = (place..j).map(|i| at(&y, i) * self.upper_at(i, j)).sum();
            set(&mut y, j, -sum / self.apart(j, place));
        }
        (0..n).map(|i| (place..n).map(|j| at(&y, j) * self.turn_at(i, j).conj()).sum()).collect()
    }

    /// The distance of two rates; equal ones are taken a rounding apart.
    fn apart(&self, i: usize, place: usize) -> Complex<f64> {
        let (by, size) = (self.rate(i) - self.rate(place), self.rate(place).norm());
        if by.norm() > size * f64::EPSILON { by } else { Complex::new(size * f64::EPSILON, 0.0) }
    }

    fn upper_at(&self, i: usize, j: usize) -> Complex<f64> {
        self.upper.get((i, j)).copied().unwrap_or_default()
    }

    fn turn_at(&self, i: usize, j: usize) -> Complex<f64> {
        self.turn.get((i, j)).copied().unwrap_or_default()
    }
}

fn at(list: &[Complex<f64>], i: usize) -> Complex<f64> {
    list.get(i).copied().unwrap_or_default()
}

fn entry(lists: &[Vec<Complex<f64>>], list: usize, i: usize) -> Complex<f64> {
    lists.get(list).map_or_else(Complex::default, |list| at(list, i))
}

fn set(list: &mut [Complex<f64>], i: usize, x: Complex<f64>) {
    if let Some(place) = list.get_mut(i) {
        *place = x;
    }
}

/// Turns a vector so that its largest entry is 1, and drops the imaginary parts of a real one and what is far below rounding: what does not
/// move at all.
fn turned(list: &mut [Complex<f64>], is_real: bool) -> Option<()> {
    let largest = list.iter().copied().max_by(|a, b| a.norm().total_cmp(&b.norm()))?;
    if !(largest.norm() > 0.0 && largest.norm().is_finite()) {
        return None;
    }
    for x in list.iter_mut() {
        *x /= largest;
        if is_real {
            x.im = 0.0;
        }
        if x.norm() < f64::EPSILON * f64::EPSILON {
            *x = Complex::default();
        }
    }
    Some(())
}

/// Scales the states by powers of two, so that rows and columns have sums of like size (Parlett and Reinsch): the scales.
fn balance(a: &mut DMatrix<f64>) -> Vec<f64> {
    let n = a.nrows();
    let mut scale = alloc::vec![1.0; n];
    for _ in 0..64 {
        let mut is_done = true;
        for i in 0..n {
            let sum = |list: &mut dyn Iterator<Item = &f64>| -> f64 { list.map(|x| x.abs()).sum() };
            let own = a.get((i, i)).map_or(0.0, |x: &f64| x.abs());
            let row = sum(&mut a.row(i).iter()) - own;
            let column = sum(&mut a.column(i).iter()) - own;
            if !(row > 0.0 && column > 0.0) {
                continue;
            }
            // √(row/column) to a power of two.
            let by = libm::exp2(libm::round(libm::log2(row / column) / 2.0));
            if by == 1.0 || column * by + row / by >= 0.95 * (column + row) || !by.is_finite() || by == 0.0 {
                continue;
            }
            is_done = false;
            a.row_mut(i).iter_mut().for_each(|x| *x /= by);
            a.column_mut(i).iter_mut().for_each(|x| *x *= by);
            if let Some(scale) = scale.get_mut(i) {
                *scale *= by;
            }
        }
        if is_done {
            break;
        }
    }
    scale
}
