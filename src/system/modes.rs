//! Natural frequencies, free and with contacts at rest.

use super::System;
use super::assembly::Rule;
use super::matrix::{Matrix, add_times, dot};
use crate::float::Float;
use alloc::vec::Vec;

impl<F: Float> System<F> {
    /// The natural angular frequencies √λ of `K x = λ M x`, without dampers, in increasing order: with the elements at the
    /// places `held` at rest, and without the others.
    ///
    /// A contact at rest holds `b·q` and takes away one frequency; an elastic contact adds its spring; a stop is open. A
    /// frequency of 0 is a rigid motion, and −√|λ| stands for a direction in which the stiffness is negative.
    #[must_use]
    pub fn natural_frequencies(&self, held: &[usize]) -> Vec<F> {
        let system = &self.assembly;
        let (n, zero, one) = (system.n, F::int(0), F::int(1));
        let (values, vectors) = system.mass.symmetric_modes();
        // M^(−1/2) = Σ v vᵀ/√λ, v the rows of `vectors`.
        let mut root = Matrix::zero(n, n);
        for (k, value) in values.iter().enumerate() {
            let v: Vec<F> = (0..n).map(|i| vectors.at(k, i)).collect();
            for (i, &x) in v.iter().enumerate() {
                add_times(root.row_mut(i), x / value.sqrt(), &v);
            }
        }
        let mut stiffness = system.stiffness.clone();
        let mut holds: Vec<Vec<F>> = Vec::new();
        for part in held.iter().filter_map(|&place| system.parts.get(place)) {
            match &part.rule {
                Rule::Elastic { stiffness: own, .. } => {
                    for (i, &b) in part.direction.iter().enumerate() {
                        add_times(stiffness.row_mut(i), b * *own, &part.direction);
                    }
                }
                Rule::Stop { .. } => {}
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
                    if left > size * F::exp2i(-20) {
                        c.iter_mut().for_each(|x| *x = *x / left);
                        holds.push(c);
                    }
                }
            }
        }
        let mut operator = root.times(&stiffness).times(&root);
        let most = operator.rows().flatten().fold(one, |sum, x| sum + x.abs());
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
        let (mut squares, _) = operator.symmetric_modes();
        squares.sort_by(|a, b| a.partial_cmp(b).unwrap_or(core::cmp::Ordering::Equal));
        squares.truncate(n - holds.len());
        let rounding = most * F::epsilon() * F::int(8);
        squares
            .into_iter()
            .map(
                |square| {
                    if square.abs() <= rounding { zero } else { square.abs().sqrt().with_sign_of(square) }
                },
            )
            .collect()
    }
}
