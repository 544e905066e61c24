//! Dense matrices of a system's size: products along columns, which vectorise, and the solutions that the
//! contacts need.

use crate::float::Float;
use alloc::vec;
use alloc::vec::Vec;

/// `Σ aᵢbᵢ`.
pub(crate) fn dot<F: Float>(a: &[F], b: &[F]) -> F {
    a.iter().zip(b).fold(F::int(0), |sum, (&x, &y)| sum + x * y)
}

/// `Σ |aᵢ||bᵢ|`.
pub(crate) fn size_of_dot<F: Float>(a: &[F], b: &[F]) -> F {
    a.iter().zip(b).fold(F::int(0), |sum, (&x, &y)| sum + (x * y).abs())
}

/// |z|.
pub(crate) fn absolute<F: Float>(z: &[F]) -> Vec<F> {
    z.iter().map(|x| x.abs()).collect()
}

/// `y += s x`.
#[inline(always)]
pub(crate) fn add_times<F: Float>(y: &mut [F], s: F, x: &[F]) {
    for (y, &x) in y.iter_mut().zip(x) {
        *y = *y + s * x;
    }
}

/// A matrix in row-major order.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Matrix<F> {
    columns: usize,
    items: Vec<F>,
}

/// The entries of a square matrix that are not zero, row by row.
#[derive(Debug, Clone)]
pub(crate) struct Sparse<F> {
    /// Where each row ends.
    ends: Vec<usize>,
    /// The entries with their columns.
    entries: Vec<(usize, F)>,
}

impl<F: Float> Sparse<F> {
    pub(crate) fn rows(&self) -> impl Iterator<Item = &[(usize, F)]> {
        let mut from = 0;
        self.ends.iter().map(move |&to| {
            let row = self.entries.get(from..to).unwrap_or(&[]);
            from = to;
            row
        })
    }

    /// `M x`. Of a shorter result the first entries are computed, with zeros at the end of x.
    #[inline]
    pub(crate) fn of(&self, x: &[F], result: &mut [F]) {
        for (row, result) in self.rows().zip(result) {
            let mut sum = F::int(0);
            for &(j, a) in row {
                // The columns increase.
                let Some(&x) = x.get(j) else { break };
                sum = sum + a * x;
            }
            *result = sum;
        }
    }

    /// `s M X`, row by row.
    pub(crate) fn times(&self, x: &Matrix<F>, s: F, result: &mut Matrix<F>) {
        for (row, result) in self.rows().zip(result.items.chunks_exact_mut(x.columns.max(1))) {
            let (fours, rest) = result.as_chunks_mut::<4>();
            let (twos, ones) = rest.as_chunks_mut::<2>();
            let mut from = 0;
            x.combine(row, s, &mut from, fours);
            x.combine(row, s, &mut from, twos);
            x.combine(row, s, &mut from, ones.as_chunks_mut::<1>().0);
        }
    }
}

impl<F: Float> Matrix<F> {
    pub(crate) fn zero(rows: usize, columns: usize) -> Self {
        Self { columns, items: vec![F::int(0); rows * columns] }
    }

    pub(crate) fn identity(n: usize) -> Self {
        let mut one = Self::zero(n, n);
        (0..n).for_each(|i| one.set(i, i, F::int(1)));
        one
    }

    pub(crate) fn from_rows(rows: &[Vec<F>]) -> Self {
        Self { columns: rows.first().map_or(0, Vec::len), items: rows.concat() }
    }

    /// The first rows of a list of all entries.
    pub(crate) fn from_list(columns: usize, items: &[F], rows: usize) -> Self {
        Self { columns, items: items.get(..rows * columns).unwrap_or(items).to_vec() }
    }

    pub(crate) const fn columns(&self) -> usize {
        self.columns
    }

    pub(crate) fn row(&self, i: usize) -> &[F] {
        self.items.get(i * self.columns..(i + 1) * self.columns).unwrap_or(&[])
    }

    pub(crate) fn row_mut(&mut self, i: usize) -> &mut [F] {
        self.items.get_mut(i * self.columns..(i + 1) * self.columns).unwrap_or(&mut [])
    }

    pub(crate) fn rows(&self) -> impl Iterator<Item = &[F]> {
        self.items.chunks_exact(self.columns.max(1))
    }

    pub(crate) fn at(&self, i: usize, j: usize) -> F {
        self.row(i).get(j).copied().unwrap_or(F::int(0))
    }

    pub(crate) fn set(&mut self, i: usize, j: usize, value: F) {
        if let Some(item) = self.row_mut(i).get_mut(j) {
            *item = value;
        }
    }

    pub(crate) fn map(&self, f: impl Fn(F) -> F) -> Self {
        Self { columns: self.columns, items: self.items.iter().map(|&x| f(x)).collect() }
    }

    pub(crate) fn transposed(&self) -> Self {
        let rows = self.rows().count();
        let mut result = Self::zero(self.columns, rows);
        for (i, row) in self.rows().enumerate() {
            row.iter().enumerate().for_each(|(j, &x)| result.set(j, i, x));
        }
        result
    }

    pub(crate) fn times(&self, other: &Self) -> Self {
        let rows = self.rows().count();
        let mut result = Self::zero(rows, other.columns);
        for (row, sum) in self.rows().zip(result.items.chunks_exact_mut(other.columns.max(1))) {
            other.transposed_of(row, sum);
        }
        result
    }

    pub(crate) fn plus(&mut self, other: &Self) {
        add_times(&mut self.items, F::int(1), &other.items);
    }

    /// `M x`.
    pub(crate) fn of(&self, x: &[F]) -> Vec<F> {
        self.rows().map(|row| dot(row, x)).collect()
    }

    /// `Mᵀ x`, along the rows: with the transposed matrix in memory this is `M x` along columns. A shorter x has zeros at its
    /// end, and of a shorter result the first entries are computed.
    pub(crate) fn transposed_of(&self, x: &[F], result: &mut [F]) {
        let (count, mut from) = (result.len(), 0);
        while from + 8 <= count {
            self.block::<8>(from, x, result);
            from += 8;
        }
        // A block may begin before the end of the last one, and compute some entries again.
        match (count - from, count) {
            (0, _) => {}
            (5.., 8..) => self.block::<8>(count - 8, x, result),
            (5.., _) => {
                self.block::<4>(from, x, result);
                self.block::<4>(count - 4, x, result);
            }
            (_, 4..) => self.block::<4>(count - 4, x, result),
            _ => (0..count).for_each(|from| self.block::<1>(from, x, result)),
        }
    }

    /// Entries of `Mᵀ x` from one place on. Their sums stay in registers.
    #[inline]
    fn block<const N: usize>(&self, from: usize, x: &[F], result: &mut [F]) {
        let mut sums = [F::int(0); N];
        let mut rows = self.items.get(from..).unwrap_or(&[]);
        for &x in x {
            let Some(part) = rows.first_chunk::<N>() else { break };
            sums.iter_mut().zip(part).for_each(|(sum, &a)| *sum = *sum + x * a);
            let Some(next) = rows.get(self.columns..) else { break };
            rows = next;
        }
        if let Some(block) = result.get_mut(from..).and_then(|rest| rest.first_chunk_mut::<N>()) {
            *block = sums;
        }
    }

    /// Entries of `s Σ xᵢ (row i)` from one place on.
    #[inline]
    fn combine<const N: usize>(&self, x: &[(usize, F)], s: F, from: &mut usize, blocks: &mut [[F; N]]) {
        for block in blocks {
            let mut sums = [F::int(0); N];
            for &(i, x) in x {
                let row = self.items.get(i * self.columns + *from..).and_then(|row| row.first_chunk::<N>());
                let Some(row) = row else { break };
                sums.iter_mut().zip(row).for_each(|(sum, &a)| *sum = *sum + x * a);
            }
            *block = sums.map(|x| x * s);
            *from += N;
        }
    }

    /// `Σ xᵢ (row i)`.
    pub(crate) fn combined(&self, x: &[F]) -> Vec<F> {
        let mut result = vec![F::int(0); self.columns];
        self.transposed_of(x, &mut result);
        result
    }

    /// Its entries other than zero.
    pub(crate) fn sparse(&self) -> Sparse<F> {
        let mut sparse = Sparse { ends: Vec::new(), entries: Vec::new() };
        for row in self.rows() {
            let entries = row.iter().enumerate().filter(|(_, x)| **x != F::int(0));
            sparse.entries.extend(entries.map(|(j, &x)| (j, x)));
            sparse.ends.push(sparse.entries.len());
        }
        sparse
    }

    /// Cholesky's factor's test and the inverse of a symmetric positive definite matrix; the failing pivot
    /// otherwise, with its value.
    pub(crate) fn inverse_of_definite(&self) -> Result<Self, (usize, F)> {
        let n = self.columns;
        let mut l = Self::zero(n, n);
        for i in 0..n {
            for j in 0..=i {
                let (left, right) = (l.row(i), l.row(j));
                let rest = self.at(i, j) - dot(left.get(..j).unwrap_or(&[]), right.get(..j).unwrap_or(&[]));
                if i == j {
                    if rest <= F::epsilon() * self.at(i, i) {
                        return Err((i, rest));
                    }
                    l.set(i, i, rest.sqrt());
                } else {
                    let pivot = l.at(j, j);
                    l.set(i, j, rest / pivot);
                }
            }
        }
        // L⁻¹, then M⁻¹ = L⁻ᵀL⁻¹.
        let mut inverse = Self::zero(n, n);
        for j in 0..n {
            for i in j..n {
                let known = (j..i).fold(F::int(0), |sum, k| sum + l.at(i, k) * inverse.at(k, j));
                let right = F::int(i32::from(i == j));
                inverse.set(i, j, (right - known) / l.at(i, i));
            }
        }
        Ok(inverse.transposed().times(&inverse))
    }

    /// The eigenvalues and eigenvectors (as rows) of a symmetric matrix, by Jacobi's rotations.
    pub(crate) fn symmetric_modes(&self) -> (Vec<F>, Self) {
        let n = self.columns;
        let (mut a, mut v) = (self.clone(), Self::identity(n));
        // Each sweep at least squares the part off the diagonal, once it is small.
        for _ in 0..F::precision() {
            let mut turned = false;
            for p in 0..n {
                for q in (p + 1)..n {
                    let (app, aqq, apq) = (a.at(p, p), a.at(q, q), a.at(p, q));
                    if apq.abs() <= F::epsilon() * F::epsilon() * (app * aqq).abs().sqrt() || apq == F::int(0)
                    {
                        continue;
                    }
                    if app.abs() + apq.abs() == app.abs() && aqq.abs() + apq.abs() == aqq.abs() {
                        a.set(p, q, F::int(0));
                        a.set(q, p, F::int(0));
                        continue;
                    }
                    turned = true;
                    let theta = (aqq - app) / (apq + apq);
                    let t = F::int(1).with_sign_of(theta) / (theta.abs() + theta.hypot(F::int(1)));
                    let c = F::int(1) / t.hypot(F::int(1));
                    let s = t * c;
                    for k in 0..n {
                        let (kp, kq) = (a.at(k, p), a.at(k, q));
                        a.set(k, p, c * kp - s * kq);
                        a.set(k, q, s * kp + c * kq);
                    }
                    for k in 0..n {
                        let (pk, qk) = (a.at(p, k), a.at(q, k));
                        a.set(p, k, c * pk - s * qk);
                        a.set(q, k, s * pk + c * qk);
                        let (vp, vq) = (v.at(p, k), v.at(q, k));
                        v.set(p, k, c * vp - s * vq);
                        v.set(q, k, s * vp + c * vq);
                    }
                }
            }
            if !turned {
                break;
            }
        }
        ((0..n).map(|i| a.at(i, i)).collect(), v)
    }

    /// The solution of least size of a symmetric positive semidefinite system, as a matrix: the inverse, with
    /// directions that rounding cannot tell from null left out.
    pub(crate) fn pseudo_inverse(&self) -> Self {
        let n = self.columns;
        if n == 1 {
            let g = self.at(0, 0);
            let mut result = Self::zero(1, 1);
            if g > F::int(0) {
                result.set(0, 0, F::int(1) / g);
            }
            return result;
        }
        let (values, modes) = self.symmetric_modes();
        let largest = values.iter().fold(F::int(0), |a, &b| a.or_larger(b.abs()));
        let least = F::epsilon() * F::int(1024) * largest;
        let mut result = Self::zero(n, n);
        for (&value, mode) in values.iter().zip(modes.rows()) {
            if value > least {
                for i in 0..n {
                    let factor = mode.get(i).copied().unwrap_or(F::int(0)) / value;
                    add_times(result.row_mut(i), factor, mode);
                }
            }
        }
        result
    }

    /// A solution of `M x = y` by elimination with complete pivoting. Unknowns whose pivots rounding cannot
    /// tell from zero are 0; their number is the second result.
    pub(crate) fn solved(&self, y: &[F]) -> (Vec<F>, usize) {
        let n = self.columns;
        let mut a = self.clone();
        let mut y = y.to_vec();
        let mut order: Vec<usize> = (0..n).collect();
        let largest = a.items.iter().fold(F::int(0), |m, x| m.or_larger(x.abs()));
        let least = largest * F::epsilon() * F::int(256);
        let mut rank = 0;
        while rank < n {
            let (mut best, mut place) = (F::int(0), (rank, rank));
            for i in rank..n {
                for j in rank..n {
                    if a.at(i, j).abs() > best {
                        (best, place) = (a.at(i, j).abs(), (i, j));
                    }
                }
            }
            if best <= least {
                break;
            }
            for k in 0..n {
                let (one, other) = (a.at(rank, k), a.at(place.0, k));
                a.set(rank, k, other);
                a.set(place.0, k, one);
            }
            y.swap(rank, place.0);
            for k in 0..n {
                let (one, other) = (a.at(k, rank), a.at(k, place.1));
                a.set(k, rank, other);
                a.set(k, place.1, one);
            }
            order.swap(rank, place.1);
            let from = a.row(rank).to_vec();
            let pivot = a.at(rank, rank);
            let top = y.get(rank).copied().unwrap_or(F::int(0));
            for i in (rank + 1)..n {
                let factor = a.at(i, rank) / pivot;
                add_times(a.row_mut(i), -factor, &from);
                if let Some(y) = y.get_mut(i) {
                    *y = *y - factor * top;
                }
            }
            rank += 1;
        }
        let mut x = vec![F::int(0); n];
        let mut solved = vec![F::int(0); n];
        for i in (0..rank).rev() {
            let known = dot(a.row(i), &solved);
            let value = (y.get(i).copied().unwrap_or(F::int(0)) - known) / a.at(i, i);
            if let Some(place) = solved.get_mut(i) {
                *place = value;
            }
            if let Some(place) = order.get(i).and_then(|&j| x.get_mut(j)) {
                *place = value;
            }
        }
        (x, n - rank)
    }
}
