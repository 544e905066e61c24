//! Dense matrices of a system's size: products along columns, which vectorise, and the solutions that the
//! contacts need.

use crate::float::Float;
use alloc::vec;
use alloc::vec::Vec;
use nalgebra::{DMatrix, SymmetricEigen};

/// `Σ aᵢbᵢ`.
pub(crate) fn dot<F: Float>(a: &[F], b: &[F]) -> F {
    a.iter().zip(b).fold(F::int(0), |sum, (&x, &y)| sum + x * y)
}

/// `Σ |aᵢ||bᵢ|`.
pub(crate) fn size_of_dot<F: Float>(a: &[F], b: &[F]) -> F {
    a.iter().zip(b).fold(F::int(0), |sum, (&x, &y)| sum + (x * y).abs())
}

/// A sum and the rounding of its last addition (Kahan): the rounding of many does not add up.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sum<F> {
    pub(crate) value: F,
    pub(crate) late: F,
}

impl<F: Float> Sum<F> {
    pub(crate) fn at(value: F) -> Self {
        Self { value, late: F::int(0) }
    }

    pub(crate) fn add(&mut self, x: F) {
        let by = self.late + x;
        let value = self.value + by;
        *self = Self { value, late: by - (value - self.value) };
    }
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

/// An entry of a row; 0 beyond it.
pub(crate) fn at<F: Float>(row: &[F], i: usize) -> F {
    row.get(i).copied().unwrap_or(F::int(0))
}

/// Sets an entry of a row, if it has one there.
pub(crate) fn set<F: Float>(row: &mut [F], place: usize, x: F) {
    if let Some(entry) = row.get_mut(place) {
        *entry = x;
    }
}

/// Sets an entry of a row to 0.
pub(crate) fn clear<F: Float>(row: &mut [F], place: usize) {
    set(row, place, F::int(0));
}

/// Whether whole matrices of this size are cheap at this precision.
pub(crate) fn is_small<F: Float>(size: usize) -> bool {
    size <= 8 && F::precision() <= 64
}

/// Whether what is zero is skipped in matrices of this size.
const fn is_large(size: usize) -> bool {
    size > 64
}

/// A matrix in row-major order. Each row is followed by zeros up to a multiple of four or eight, so that products work on whole
/// blocks.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Matrix<F> {
    columns: usize,
    /// The length of a row with its zeros.
    stride: usize,
    items: Vec<F>,
}

/// The entries of a square matrix that are not zero, row by row.
#[derive(Debug, Clone)]
pub(crate) struct Sparse<F> {
    /// Where each row ends.
    ends: Vec<usize>,
    /// The entries with their columns.
    entries: Vec<(usize, F)>,
    /// The transposed matrix of a small one at a precision of the processor, where a product with all entries is faster.
    all: Option<Matrix<F>>,
}

/// A block of `s Σ aᵢ xᵢ`, with the place of the block of xᵢ.
#[inline(always)]
fn combined<F: Float, const N: usize>(
    row: &[(usize, F)],
    x: &[[F; N]],
    s: F,
    place: impl Fn(usize) -> usize,
) -> [F; N] {
    let mut sums = [F::int(0); N];
    for &(i, a) in row {
        let Some(x) = x.get(place(i)) else { break };
        sums.iter_mut().zip(x).for_each(|(sum, &x)| *sum = *sum + a * x);
    }
    sums.map(|x| x * s)
}

/// `s Σ xᵢ (row i)` of rows that have `each` blocks, or without s. The sums of a block stay in registers.
#[inline]
fn blocks<F: Float, const N: usize>(
    each: usize,
    rows: &[[F; N]],
    x: &[F],
    s: impl Fn(F) -> F,
    result: &mut [F],
) {
    for (block, result) in result.chunks_mut(N).take(each).enumerate() {
        let mut sums = [F::int(0); N];
        let mut add = |x: F, row: &[F; N]| sums.iter_mut().zip(row).for_each(|(sum, &a)| *sum = *sum + x * a);
        if each == 1 {
            x.iter().zip(rows).for_each(|(&x, row)| add(x, row));
        } else {
            let mut place = block;
            for &x in x {
                let Some(row) = rows.get(place) else { break };
                add(x, row);
                place += each;
            }
        }
        put(&sums.map(&s), result);
    }
}

/// The first entries of a block. A loop over them would become a call.
#[inline(always)]
fn put<F: Float, const N: usize>(block: &[F; N], result: &mut [F]) {
    if let Some(result) = result.first_chunk_mut::<N>() {
        *result = *block;
        return;
    }
    let (mut from, mut to) = (block.as_slice(), result);
    if to.len() >= 4 {
        let (four, rest) = to.split_at_mut(4);
        if let (Some(a), Some(b)) = (from.first_chunk::<4>(), four.first_chunk_mut::<4>()) {
            *b = *a;
        }
        (from, to) = (from.get(4..).unwrap_or(&[]), rest);
    }
    let [a, b, c] = [from.first(), from.get(1), from.get(2)];
    match (to, a, b, c) {
        ([x], Some(&a), ..) => *x = a,
        ([x, y], Some(&a), Some(&b), _) => (*x, *y) = (a, b),
        ([x, y, z], Some(&a), Some(&b), Some(&c)) => (*x, *y, *z) = (a, b, c),
        _ => {}
    }
}

/// The entries of a row that are not zero, with their columns.
pub(crate) fn entries<F: Float>(row: &[F]) -> Vec<(usize, F)> {
    row.iter().copied().enumerate().filter(|(_, x)| *x != F::int(0)).collect()
}

impl<F: Float> Sparse<F> {
    /// A matrix of this size by the entries of its rows, in ascending order.
    pub(crate) fn new(size: usize, rows: impl Iterator<Item = Vec<(usize, F)>>) -> Self {
        let mut sparse = Self { ends: Vec::with_capacity(size), entries: Vec::new(), all: None };
        for row in rows {
            sparse.entries.extend(row);
            sparse.ends.push(sparse.entries.len());
        }
        if is_small::<F>(size) {
            let mut all = Matrix::zero(size, size);
            for (i, row) in sparse.rows().enumerate() {
                row.iter().for_each(|&(j, x)| all.set(j, i, x));
            }
            sparse.all = Some(all);
        }
        sparse
    }

    pub(crate) fn transposed(&self) -> Self {
        let size = self.ends.len();
        let mut rows = vec![Vec::new(); size];
        for (i, row) in self.rows().enumerate() {
            for &(j, x) in row {
                if let Some(row) = rows.get_mut(j) {
                    row.push((i, x));
                }
            }
        }
        Self::new(size, rows.into_iter())
    }

    /// The square matrix of the rows and columns from this one on.
    pub(crate) fn square_from(&self, first: usize) -> Self {
        let rows = self.rows().skip(first);
        let rows =
            rows.map(|row| row.iter().filter_map(|&(j, x)| Some((j.checked_sub(first)?, x))).collect());
        Self::new(self.ends.len() - first, rows)
    }

    pub(crate) fn map(&self, f: impl Fn(F) -> F) -> Self {
        let rows = self.rows().map(|row| row.iter().map(|&(j, x)| (j, f(x))).collect());
        Self::new(self.ends.len(), rows)
    }

    /// Whether the entries of another matrix have the same places and sizes.
    pub(crate) fn has_sizes_of(&self, other: &Self) -> bool {
        let same = |(a, b): (&(usize, F), &(usize, F))| a.0 == b.0 && a.1.abs() == b.1.abs();
        self.ends == other.ends && self.entries.iter().zip(&other.entries).all(same)
    }

    /// Whether no entry of another matrix is larger.
    pub(crate) fn has_sizes_above(&self, other: &Self) -> bool {
        self.rows().zip(other.rows()).all(|(above, row)| {
            let mut above = above.iter();
            row.iter().all(|&(j, x)| above.any(|&(i, y)| i == j && y.abs() >= x.abs()))
        })
    }

    /// Whether the leading rows and columns of another matrix are the same.
    pub(crate) fn moves_as(&self, other: &Self, size: usize) -> bool {
        let leading =
            |row: &'_ [(usize, F)]| row.iter().take_while(|(j, _)| *j < size).copied().collect::<Vec<_>>();
        self.rows().zip(other.rows()).take(size).all(|(a, b)| leading(a) == leading(b))
    }

    /// `Σ |aⱼ xⱼ|` of a row.
    pub(crate) fn size_of(&self, row: usize, x: &[F]) -> F {
        let from = row.checked_sub(1).and_then(|above| self.ends.get(above)).copied().unwrap_or(0);
        let row = self.ends.get(row).and_then(|&to| self.entries.get(from..to)).unwrap_or(&[]);
        row.iter().filter_map(|&(j, a)| Some((a * *x.get(j)?).abs())).fold(F::int(0), |sum, x| sum + x)
    }

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
        self.times_of(|sum| sum, x, result);
    }

    /// `s M x`. A longer result may have zeros up to its eighth entry.
    #[inline]
    pub(crate) fn times_of(&self, s: impl Fn(F) -> F, x: &[F], result: &mut [F]) {
        if let Some(all) = &self.all {
            return all.times_transposed_of(s, x, result);
        }
        for (row, result) in self.rows().zip(result) {
            let mut sum = F::int(0);
            for &(j, a) in row {
                // The columns increase.
                let Some(&x) = x.get(j) else { break };
                sum = sum + a * x;
            }
            *result = s(sum);
        }
    }

    /// `s M X`, row by row.
    pub(crate) fn times(&self, x: &Matrix<F>, s: F, result: &mut Matrix<F>) {
        if x.stride.is_multiple_of(8) {
            self.combine(x.stride / 8, x.items.as_chunks::<8>().0, s, result.items.as_chunks_mut().0);
        } else {
            self.combine(x.stride / 4, x.items.as_chunks::<4>().0, s, result.items.as_chunks_mut().0);
        }
    }

    /// [`times`](Self::times) for matrices whose rows have `each` blocks.
    #[inline]
    fn combine<const N: usize>(&self, each: usize, x: &[[F; N]], s: F, result: &mut [[F; N]]) {
        if each == 1 {
            for (row, result) in self.rows().zip(result) {
                *result = combined(row, x, s, |i| i);
            }
            return;
        }
        for (row, result) in self.rows().zip(result.chunks_exact_mut(each.max(1))) {
            for (block, result) in result.iter_mut().enumerate() {
                *result = combined(row, x, s, |i| i * each + block);
            }
        }
    }
}

impl<F: Float> Matrix<F> {
    pub(crate) fn zero(rows: usize, columns: usize) -> Self {
        // Longer blocks are faster where a number is cheap.
        let block = if columns > 4 && F::precision() <= 64 { 8 } else { 4 };
        let stride = columns.next_multiple_of(block);
        Self { columns, stride, items: vec![F::int(0); rows * stride] }
    }

    pub(crate) fn identity(n: usize) -> Self {
        let mut one = Self::zero(n, n);
        (0..n).for_each(|i| one.set(i, i, F::int(1)));
        one
    }

    pub(crate) fn from_rows(rows: &[Vec<F>]) -> Self {
        let mut matrix = Self::zero(rows.len(), rows.first().map_or(0, Vec::len));
        for (to, from) in matrix.items.chunks_exact_mut(matrix.stride.max(1)).zip(rows) {
            to.iter_mut().zip(from).for_each(|(to, &from)| *to = from);
        }
        matrix
    }

    /// Its first rows.
    pub(crate) fn leading(&self, rows: usize) -> Self {
        let mut items = self.items.clone();
        items.truncate(rows * self.stride);
        Self { columns: self.columns, stride: self.stride, items }
    }

    pub(crate) const fn columns(&self) -> usize {
        self.columns
    }

    /// The number of entries in memory, with the zeros behind the rows.
    pub(crate) const fn entries(&self) -> usize {
        self.items.len()
    }

    pub(crate) fn row(&self, i: usize) -> &[F] {
        let from = i * self.stride;
        self.items.get(from..from + self.columns).unwrap_or(&[])
    }

    pub(crate) fn row_mut(&mut self, i: usize) -> &mut [F] {
        let from = i * self.stride;
        self.items.get_mut(from..from + self.columns).unwrap_or(&mut [])
    }

    pub(crate) fn rows(&self) -> impl Iterator<Item = &[F]> {
        self.items.chunks_exact(self.stride.max(1)).map(|row| row.get(..self.columns).unwrap_or(row))
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
        let mut result = self.clone();
        result.change(f);
        result
    }

    /// Applies a function to each entry.
    pub(crate) fn change(&mut self, f: impl Fn(F) -> F) {
        for row in self.items.chunks_exact_mut(self.stride.max(1)) {
            row.iter_mut().take(self.columns).for_each(|x| *x = f(*x));
        }
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
        if is_large(self.columns) {
            self.rows().enumerate().for_each(|(i, row)| other.combine_few(row, result.row_mut(i)));
        } else {
            self.product(other, &mut result);
        }
        result
    }

    /// [`times`](Self::times), in place of another matrix of its shape.
    pub(crate) fn product(&self, other: &Self, result: &mut Self) {
        for (row, sum) in self.rows().zip(result.items.chunks_exact_mut(other.stride.max(1))) {
            other.transposed_of(row, sum);
        }
    }

    /// `self −= b Tᵀ`: less the force T of an element that acts along b.
    pub(crate) fn less_product(&mut self, b: &[F], tension: &[F]) {
        for (i, &b) in b.iter().enumerate() {
            if b != F::int(0) {
                add_times(self.row_mut(i), -b, tension);
            }
        }
    }

    pub(crate) fn plus(&mut self, other: &Self) {
        self.items.iter_mut().zip(&other.items).for_each(|(x, &y)| *x = *x + y);
    }

    /// Puts the entries of a matrix of whole blocks behind those of others of its shape: this one has one in each row.
    pub(crate) fn push(&mut self, matrix: &Self) {
        (self.columns, self.stride) = (matrix.items.len(), matrix.items.len());
        self.items.extend_from_slice(&matrix.items);
    }

    /// `Σ xᵢ Mᵢ` of the matrices that were [pushed](Self::push).
    pub(crate) fn sum_of_pushed(&self, x: &[F], result: &mut Self) {
        self.transposed_of(x, &mut result.items);
    }

    /// `M x`.
    pub(crate) fn of(&self, x: &[F]) -> Vec<F> {
        self.rows().map(|row| dot(row, x)).collect()
    }

    /// `Mᵀ x`, along the rows: with the transposed matrix in memory this is `M x` along columns. A shorter x has zeros at its
    /// end, and of a shorter result the first entries are computed.
    #[inline]
    pub(crate) fn transposed_of(&self, x: &[F], result: &mut [F]) {
        self.times_transposed_of(|sum| sum, x, result);
    }

    /// [`transposed_of`](Self::transposed_of), each entry by s.
    #[inline]
    fn times_transposed_of(&self, s: impl Fn(F) -> F, x: &[F], result: &mut [F]) {
        if self.stride.is_multiple_of(8) && result.len() > 4 {
            blocks(self.stride / 8, self.items.as_chunks::<8>().0, x, s, result);
        } else {
            blocks(self.stride / 4, self.items.as_chunks::<4>().0, x, s, result);
        }
    }

    /// `Σ xᵢ (row i)`.
    pub(crate) fn combined(&self, x: &[F]) -> Vec<F> {
        let mut result = vec![F::int(0); self.columns];
        self.transposed_of(x, &mut result);
        result
    }

    /// `Σ xᵢ (row i)` into zeros, where many xᵢ may be zero.
    pub(crate) fn combine_few(&self, x: &[F], result: &mut [F]) {
        if !is_large(self.columns) {
            return self.transposed_of(x, result);
        }
        for (&x, row) in x.iter().zip(self.rows()).filter(|(x, _)| **x != F::int(0)) {
            add_times(result, x, row);
        }
    }

    /// Cholesky's factor's test and the inverse of a symmetric positive definite matrix; the failing pivot
    /// otherwise, with its value.
    pub(crate) fn inverse_of_definite(&self) -> Result<Self, (usize, F)> {
        let n = self.columns;
        let l = self.cholesky(F::epsilon())?;
        // L⁻¹ row by row, then M⁻¹ = L⁻ᵀL⁻¹.
        let mut inverse = Self::zero(n, n);
        let mut known = Vec::new();
        for (i, row) in l.rows().enumerate() {
            known.clear();
            known.resize(i, F::int(0));
            for (&x, before) in row.iter().take(i).zip(inverse.rows()).filter(|(x, _)| **x != F::int(0)) {
                add_times(&mut known, x, before);
            }
            let pivot = at(row, i);
            let own = inverse.row_mut(i);
            own.iter_mut().zip(&known).for_each(|(to, &known)| *to = -known / pivot);
            set(own, i, F::int(1) / pivot);
        }
        Ok(inverse.transposed().times(&inverse))
    }

    /// Cholesky's factor L of a symmetric matrix whose pivots are above `least` of its diagonal; the first other pivot, with its value.
    pub(crate) fn cholesky(&self, least: F) -> Result<Self, (usize, F)> {
        let n = self.columns;
        let mut l = Self::zero(n, n);
        let first = |row: &[F]| row.iter().position(|x| *x != F::int(0)).unwrap_or(n);
        let begins: Vec<usize> = self.rows().map(first).collect();
        for (i, &begin) in begins.iter().enumerate() {
            // What is zero before the first entry of a row is zero in L, too.
            for (j, &other) in begins.iter().enumerate().take(i + 1).skip(begin) {
                let from = begin.max(other).min(j);
                let part = |row: usize| l.row(row).get(from..j).unwrap_or(&[]);
                let rest = self.at(i, j) - dot(part(i), part(j));
                if i == j {
                    if rest <= least * self.at(i, i) {
                        return Err((i, rest));
                    }
                    l.set(i, i, rest.sqrt());
                } else {
                    let pivot = l.at(j, j);
                    l.set(i, j, rest / pivot);
                }
            }
            if begin > i {
                return Err((i, self.at(i, i)));
            }
        }
        Ok(l)
    }

    /// This matrix for an eigenvalue problem of nalgebra, where it is large and its numbers have no more digits than doubles. The page has
    /// no room for it.
    fn for_nalgebra(&self) -> Option<DMatrix<f64>> {
        if cfg!(target_arch = "wasm32") {
            return None;
        }
        let n = self.columns;
        let is_plain = n > 32 && size_of::<F>() <= size_of::<f64>();
        let matrix = is_plain.then(|| DMatrix::from_fn(n, n, |i, j| self.at(i, j).to_f64()));
        matrix.filter(|matrix| matrix.iter().all(|x| x.is_finite()))
    }

    /// The eigenvalues of a symmetric matrix.
    pub(crate) fn symmetric_values(&self) -> Vec<F> {
        match self.for_nalgebra() {
            Some(matrix) => matrix.symmetric_eigenvalues().iter().map(|&x| F::from_f64(x)).collect(),
            None => self.symmetric_modes().0,
        }
    }

    /// The eigenvalues and eigenvectors (as rows) of a symmetric matrix, by Jacobi's rotations, and of a large one by tridiagonal matrices.
    pub(crate) fn symmetric_modes(&self) -> (Vec<F>, Self) {
        let n = self.columns;
        let is_diagonal = || {
            self.rows()
                .enumerate()
                .all(|(i, row)| row.iter().enumerate().all(|(j, x)| i == j || *x == F::int(0)))
        };
        if let Some(found) = self.for_nalgebra().filter(|_| !is_diagonal()).map(SymmetricEigen::new) {
            let mut vectors = Self::zero(n, n);
            for (k, column) in found.eigenvectors.column_iter().enumerate() {
                column.iter().enumerate().for_each(|(i, &x)| vectors.set(k, i, F::from_f64(x)));
            }
            return (found.eigenvalues.iter().map(|&x| F::from_f64(x)).collect(), vectors);
        }
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
