//! Fixed points of the period map by Newton's method, and what decides whether a motion goes to one.
//!
//! Newton's step solves `(I − J) d = P(x) − x`. An element that is silent, a contact that sticks or an elastic contact that holds for
//! the whole period, keeps a linear function of the state, `ℓ·P(x) = ℓ·x`, so that `ℓ J = ℓ`: a multiplier is 1, and fixed points fill a
//! manifold. The motion keeps the same number, and the fixed point that it goes to is the one with `ℓ·x = ℓ·z`. With the rows ℓ
//! made orthonormal the step is that of `(I − J + Σ ℓᵀℓ) d = P(x) − x`: from the left ℓ gives `ℓ·d = 0`.
//!
//! Where I − J is singular beyond that, as with an undamped vibration of the loads' frequency, the limit of `Σ Jᵏ (P(x) − x)` lies in the range
//! of I − J, and is `(I − J) y` with `(I − J)² y = P(x) − x`. The point of the manifold is then right to first order in the distance only.

use super::error::Error;
use super::few::is_large;
use super::matrix::{Matrix, add_times, dot};
use super::period_map::{Mapped, PeriodMap};
use super::precision::small;
use crate::float::Float;
use alloc::vec;
use alloc::vec::Vec;
use nalgebra::{DMatrix, Schur};

/// A fixed point of the period map, with the map there.
pub(super) struct Fixed<F> {
    pub(super) x: Vec<F>,
    pub(super) mapped: Mapped<F>,
    /// J in units of the motion's sizes.
    pub(super) derivative: Matrix<F>,
    /// Its eigenvalues without those of what is kept and of the drift, the largest first; none where they are not found.
    pub(super) multipliers: Vec<(f64, f64)>,
    /// The number of multipliers 1 of what is kept, which are left out there.
    pub(super) kept: usize,
    /// By how much the map does not close.
    pub(super) by: F,
    /// Newton's next step.
    pub(super) next: F,
    /// Whether it is one of a manifold, to first order in its distance.
    pub(super) is_first_order: bool,
}

impl<F: Float> Fixed<F> {
    /// All multipliers: with 1 for each number that is kept.
    pub(super) fn all_multipliers(&self) -> Vec<(f64, f64)> {
        let mut all = vec![(1.0, 0.0); self.kept];
        all.extend_from_slice(&self.multipliers);
        all.sort_by(|a, b| b.0.hypot(b.1).total_cmp(&a.0.hypot(a.1)));
        all
    }

    /// The size of the largest multiplier of what is not kept.
    pub(super) fn largest(&self) -> Option<f64> {
        self.multipliers.first().map(|&(re, im)| re.hypot(im))
    }
}

/// J in units of the motion's sizes.
pub(super) fn scaled<F: Float>(map: &PeriodMap<'_, F>, mapped: &Mapped<F>) -> Matrix<F> {
    let free = map.system.free;
    let mut matrix = Matrix::zero(free, free);
    for (j, column) in mapped.tangent.iter().enumerate() {
        let size = map.size_at(&mapped.sizes, j);
        for (i, &value) in column.iter().enumerate() {
            matrix.set(i, j, value * size / map.size_at(&mapped.sizes, i));
        }
    }
    matrix
}

/// `I − J`.
pub(super) fn defect<F: Float>(derivative: &Matrix<F>) -> Matrix<F> {
    let mut matrix = derivative.map(|x| -x);
    for i in 0..matrix.columns() {
        let one: F = matrix.at(i, i);
        matrix.set(i, i, one + F::int(1));
    }
    matrix
}

/// Rows over the state in units of the sizes, made orthonormal; those that depend on others are left out.
fn orthonormal<F: Float>(map: &PeriodMap<'_, F>, rows: Vec<Vec<F>>, sizes: &[F; 3]) -> Vec<Vec<F>> {
    let mut basis: Vec<Vec<F>> = Vec::new();
    for mut row in rows {
        row.iter_mut().enumerate().for_each(|(i, x)| *x = *x * map.size_at(sizes, i));
        let before = dot(&row, &row).sqrt();
        for _ in 0..2 {
            for other in &basis {
                let share = dot(other, &row);
                add_times(&mut row, -share, other);
            }
        }
        let size = dot(&row, &row).sqrt();
        if size > before * F::exp2i(-20) {
            row.iter_mut().for_each(|x| *x = *x / size);
            basis.push(row);
        }
    }
    basis
}

/// The rows of what silent elements keep over a period, orthonormal in units of its sizes.
pub(super) fn kept_basis<F: Float>(map: &PeriodMap<'_, F>, mapped: &Mapped<F>) -> Vec<Vec<F>> {
    orthonormal(map, map.kept_rows(&mapped.events), &mapped.sizes)
}

/// Newton's step in units of the sizes, and whether it is right to first order only.
fn step<F: Float>(derivative: &Matrix<F>, kept: &[Vec<F>], right: &[F]) -> (Vec<F>, bool) {
    let mut matrix = defect(derivative);
    for row in kept {
        for (i, &x) in row.iter().enumerate() {
            add_times(matrix.row_mut(i), x, row);
        }
    }
    let (step, missing) = matrix.solved(right);
    if missing == 0 {
        return (step, false);
    }
    let (y, _) = matrix.times(&matrix).solved(right);
    (matrix.of(&y), true)
}

/// Newton's method from a state: the fixed point, where it is one. It leaves the motion elsewhere.
pub(super) fn newton<F: Float>(
    map: &mut PeriodMap<'_, F>,
    from: &[F],
    multiple: usize,
) -> Result<Option<Fixed<F>>, Error> {
    let closed = F::epsilon() * F::int(4096);
    let mut x = from.to_vec();
    let mut best: Option<Fixed<F>> = None;
    for round in 0..12 {
        // Where Newton's next error will be below rounding, this round is the last.
        let is_last =
            multiple == 1 && best.as_ref().is_some_and(|b| b.next < F::epsilon().sqrt() * F::int(16));
        let mapped = match map.map(&x, multiple, is_last, best.as_ref().map(|best| &best.mapped)) {
            Ok(mapped) => mapped,
            Err(Error::Interrupted) => return Err(Error::Interrupted),
            Err(_) => return Ok(None),
        };
        let by = map.distance(&mapped.to, &x, &mapped.sizes);
        let derivative = scaled(map, &mapped);
        if !by.is_finite() || !derivative.rows().flatten().all(|x: &F| x.is_finite()) {
            return Ok(None);
        }
        let sizes = mapped.sizes;
        let kept = kept_basis(map, &mapped);
        let right: Vec<F> = mapped.to.iter().zip(&x).map(|(&a, &b)| a - b).collect();
        let (step, is_first_order) = step(&derivative, &kept, &map.scaled(right, &sizes));
        let next = step.iter().fold(F::int(0), |most, x| most.or_larger(x.abs()));
        let (least, was_closed) =
            best.as_ref().map_or((F::int(0), false), |b| (b.by, b.by <= closed && b.next <= closed.sqrt()));
        // Rounding of the map stalls it, and a fixed point that is not there. A double one, at which an element only just begins to slide, is
        // met in steps of a half: a large system leaves it alone.
        let (most, gain) = if is_large(map.system) { (1, if round > 4 { 16 } else { 2 }) } else { (3, 2) };
        let stalls = round > 0 && by * F::int(gain) > least && (was_closed || round > most);
        if best.is_none() || by <= least {
            let (multipliers, kept) = (Vec::new(), kept.len());
            best =
                Some(Fixed { x: x.clone(), mapped, derivative, multipliers, kept, by, next, is_first_order });
        }
        if next <= F::epsilon() * F::int(16) || stalls || !next.is_finite() {
            break;
        }
        for (i, (x, step)) in x.iter_mut().zip(step).enumerate() {
            *x = *x + step * map.size_at(&sizes, i);
        }
        map.keep_bounds(&mut x);
    }
    let is_found = |b: &Fixed<F>| b.by <= closed && b.next <= small(20);
    Ok(best.filter(is_found).map(|mut fixed| {
        let all = eigenvalues(&fixed.derivative);
        fixed.multipliers = without_kept(all, fixed.kept, map.drift.count());
        fixed
    }))
}

/// The eigenvalues without those of what is kept, which are 1, and of the drift, which are 0.
pub(super) fn without_kept(mut values: Vec<(f64, f64)>, kept: usize, drifts: usize) -> Vec<(f64, f64)> {
    for _ in 0..kept {
        let apart = |&(re, im): &(f64, f64)| (re - 1.0).hypot(im);
        let nearest = values.iter().enumerate().min_by(|(_, a), (_, b)| apart(a).total_cmp(&apart(b)));
        if let Some((place, _)) = nearest {
            values.remove(place);
        }
    }
    values.truncate(values.len().saturating_sub(drifts));
    values
}

/// The eigenvalues of a matrix at f64, the largest first; none where they cannot be found.
pub(super) fn eigenvalues<F: Float>(matrix: &Matrix<F>) -> Vec<(f64, f64)> {
    let n = matrix.columns();
    let matrix = DMatrix::<f64>::from_fn(n, n, |i, j| matrix.at(i, j).to_f64());
    if !matrix.iter().all(|x| x.is_finite()) {
        return Vec::new();
    }
    // A small entry of a matrix with large ones may stay above the first limit.
    let schur =
        [1.0, 16.0, 4096.0].iter().find_map(|wide| Schur::try_new(matrix.clone(), wide * f64::EPSILON, 1000));
    let Some(schur) = schur else { return Vec::new() };
    let mut values: Vec<(f64, f64)> = schur.complex_eigenvalues().iter().map(|c| (c.re, c.im)).collect();
    values.sort_by(|a, b| b.0.hypot(b.1).total_cmp(&a.0.hypot(a.1)));
    values
}
