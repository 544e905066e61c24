//! Natural frequencies, free and with contacts at rest.
//!
//! Contacts whose other side travels without end slide in one direction: the change of their friction with the normal load belongs to
//! the stiffness (`sliding`), which then is not symmetric.

use super::System;
use super::assembly::{Assembly, Rule, unit};
use super::fixed_point::eigenvalues;
use super::matrix::{Matrix, add_times, dot};
use crate::float::Float;
use alloc::vec;
use alloc::vec::Vec;

impl<F: Float> System<F> {
    /// The natural angular frequencies √λ of `K x = λ M x`, without dampers, in increasing order: with the elements at the
    /// places `held` at rest, and without the others.
    ///
    /// A contact at rest holds `b·q` and takes away one frequency; an elastic contact adds its spring; a stop is open; a spring with a law
    /// has the slope that it has at the stretch 0. A
    /// frequency of 0 is a rigid motion, and −√|λ| stands for a direction in which the stiffness is negative.
    ///
    /// A contact that slides on a side which travels without end, such as a belt, with a normal load by displacement, has its part
    /// in the stiffness. Two frequencies that have coalesced (flutter) are both the real part of √λ: [`System::sliding`] says how it grows. A
    /// contact that slides both ways has a friction without a sign, and no part.
    #[must_use]
    pub fn natural_frequencies(&self, held: &[usize]) -> Vec<F> {
        let system = &self.assembly;
        let (n, zero, one) = (system.n, F::int(0), F::int(1));
        let is_light = !system.massless.is_empty();
        let root = if is_light { Matrix::identity(n) } else { system.inverse_root_of_mass() };
        let mut directions: Vec<Vec<F>> = Vec::new();
        let mut stiffness = system.sliding_stiffness(&vec![zero; n], one, held);
        let mut holds: Vec<Vec<F>> = system.moved.iter().map(|moved| unit(n, moved.coordinate)).collect();
        for part in held.iter().filter_map(|&place| system.parts.get(place)) {
            match &part.rule {
                Rule::Elastic { stiffness: own, .. } => {
                    for (i, &b) in part.direction.iter().enumerate() {
                        add_times(stiffness.row_mut(i), b * *own, &part.direction);
                    }
                }
                Rule::Stop { .. } | Rule::Hard { .. } | Rule::Spring { .. } => {}
                _ if is_light => directions.push(part.direction.clone()),
                _ => {
                    let mut c = root.of(&part.direction);
                    let size = dot(&c, &c).sqrt();
                    // Twice is enough for vectors that are orthogonal to rounding.
                    for _ in 0..2 {
                        for other in &holds {
                            let share = dot(other, &c);
                            add_times(&mut c, -share, other);
                        }
                    }
                    let left = dot(&c, &c).sqrt();
                    if size > zero && left > size * F::exp2i(-20) {
                        c.iter_mut().for_each(|x| *x = *x / left);
                        holds.push(c);
                    }
                }
            }
        }
        if is_light {
            directions.append(&mut holds);
            let operator = system.balanced_operator(&stiffness, &directions);
            return frequencies(&operator, operator.columns());
        }
        let mut operator = root.times(&stiffness).times(&root);
        let most = operator.rows().flatten().fold(zero, |sum, x| sum + x.abs());
        // Projected on the motions that the contacts allow; the others get the greatest values, which are left out.
        let mut allowed = Matrix::identity(n);
        for c in &holds {
            for (i, &x) in c.iter().enumerate() {
                add_times(allowed.row_mut(i), -x, c);
            }
        }
        operator = allowed.times(&operator).times(&allowed);
        for c in &holds {
            for (i, &x) in c.iter().enumerate() {
                add_times(operator.row_mut(i), x * most, c);
            }
        }
        frequencies(&operator, n - holds.len())
    }
}

/// Up to where the eigenvalue of a symmetric operator is 0: its rounding.
pub(super) fn rounding_of<F: Float>(operator: &Matrix<F>) -> F {
    operator.rows().flatten().fold(F::int(0), |sum, x| sum + x.abs()) * F::epsilon() * F::int(8)
}

/// The least frequencies of an operator.
fn frequencies<F: Float>(operator: &Matrix<F>, count: usize) -> Vec<F> {
    let (zero, n) = (F::int(0), operator.columns());
    let most = operator.rows().flatten().fold(zero, |sum, x| sum + x.abs());
    let is_symmetric = (0..n).all(|i| {
        (0..i).all(|j| (operator.at(i, j) - operator.at(j, i)).abs() <= most * F::epsilon() * F::int(64))
    });
    let rounding = rounding_of(operator);
    if !is_symmetric {
        return unsymmetric(operator, count);
    }
    let mut squares = operator.symmetric_values();
    squares.sort_by(|a, b| a.partial_cmp(b).unwrap_or(core::cmp::Ordering::Equal));
    squares.truncate(count);
    let root = |square: F| {
        if square.abs() <= rounding { zero } else { square.abs().sqrt().with_sign_of(square) }
    };
    squares.into_iter().map(root).collect()
}

/// The least frequencies of a matrix that is not symmetric, at f64.
fn unsymmetric<F: Float>(operator: &Matrix<F>, count: usize) -> Vec<F> {
    let mut squares = eigenvalues(operator);
    squares.sort_by(|a, b| a.0.total_cmp(&b.0));
    squares.truncate(count);
    let most = squares.iter().fold(0.0, |most: f64, (re, im)| most.max(re.hypot(*im)));
    // Near a double root the rounding of the matrix has its square root.
    let is_real = |im: f64| im.abs() <= 1e-7 * most;
    let root = |(re, im): (f64, f64)| match re.abs() {
        size if size <= 1e-14 * most && is_real(im) => 0.0,
        size if is_real(im) => size.sqrt().copysign(re),
        _ => f64::midpoint(re.hypot(im), re).max(0.0).sqrt(),
    };
    squares.into_iter().map(|square| F::from_f64(root(square))).collect()
}

impl<F: Float> Assembly<F> {
    /// M^(−1/2) = Σ v vᵀ/√λ over the modes v of M, without the coordinates that are moved.
    pub(super) fn inverse_root_of_mass(&self) -> Matrix<F> {
        let mut mass = self.mass.clone();
        self.moved.iter().for_each(|moved| mass.set(moved.coordinate, moved.coordinate, F::int(1)));
        let mut root = inverse_root(&mass);
        self.moved.iter().for_each(|moved| root.set(moved.coordinate, moved.coordinate, F::int(0)));
        root
    }
}

/// M^(−1/2) = Σ v vᵀ/√λ over the modes v of a mass matrix.
pub(super) fn inverse_root<F: Float>(mass: &Matrix<F>) -> Matrix<F> {
    let n = mass.columns();
    let (values, vectors) = mass.symmetric_modes();
    let mut root = Matrix::zero(n, n);
    for (k, value) in values.iter().enumerate() {
        let v: Vec<F> = (0..n).map(|i| vectors.at(k, i)).collect();
        for (i, &x) in v.iter().enumerate().filter(|(_, x)| **x != F::int(0)) {
            add_times(root.row_mut(i), x / value.sqrt(), &v);
        }
    }
    root
}
