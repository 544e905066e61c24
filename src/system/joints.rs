//! Bodies without mass that springs carry: their forces balance at every instant, so that a linear system is one of the bodies with mass.
//!
//! With f the bodies with mass and j those without, `K_jf q_f + K_jj q_j = f_j` and therefore
//!
//! ```text
//! M_ff q_f″ + C_ff q_f′ + (K_ff − K_fj K_jj⁻¹ K_jf) q_f = f_f − K_fj K_jj⁻¹ f_j
//! ```

use super::assembly::Assembly;
use super::matrix::{Matrix, at};
use crate::float::Float;
use alloc::vec::Vec;

/// The coordinates with mass and those without.
pub(crate) struct Joints<F> {
    kept: Vec<usize>,
    /// Each with K_jj⁻¹ e.
    light: Vec<(usize, Vec<F>)>,
}

impl<F: Float> Joints<F> {
    /// Those of a system with this stiffness; none where springs do not hold each body without mass, or a damper acts on one.
    pub(crate) fn new(system: &Assembly<F>, stiffness: &Matrix<F>, damping: &Matrix<F>) -> Option<Self> {
        let places = &system.massless;
        let is_damped = |&i: &usize| {
            (0..system.n).any(|j| damping.at(i, j) != F::int(0) || damping.at(j, i) != F::int(0))
        };
        if places.iter().any(is_damped) {
            return None;
        }
        let kept = (0..system.n).filter(|i| !places.contains(i)).collect();
        let mut own = Matrix::zero(places.len(), places.len());
        for (a, &i) in places.iter().enumerate() {
            places.iter().enumerate().for_each(|(b, &j)| own.set(a, b, stiffness.at(i, j)));
        }
        let column = |place: usize| -> Option<(usize, Vec<F>)> {
            let unit: Vec<F> = places.iter().map(|&i| F::int(i32::from(i == place))).collect();
            let (found, missing) = own.solved(&unit);
            (missing == 0).then_some((place, found))
        };
        let light = places.iter().map(|&place| column(place)).collect::<Option<Vec<_>>>()?;
        Some(Self { kept, light })
    }

    /// The rows and columns of bodies with mass.
    pub(crate) fn of_bodies(&self, matrix: &Matrix<F>) -> Matrix<F> {
        let mut result = Matrix::zero(self.kept.len(), self.kept.len());
        for (a, &i) in self.kept.iter().enumerate() {
            self.kept.iter().enumerate().for_each(|(b, &j)| result.set(a, b, matrix.at(i, j)));
        }
        result
    }

    /// The force on the bodies with mass that a force on all of them is, through springs.
    fn force(&self, stiffness: &Matrix<F>, force: &[F]) -> Vec<F> {
        let carried = |(k, (_, inverse)): (usize, &(usize, Vec<F>)), i: usize| {
            let share =
                self.light.iter().zip(inverse).fold(F::int(0), |sum, ((j, _), &x)| sum + x * at(force, *j));
            self.light.get(k).map_or(F::int(0), |(j, _)| stiffness.at(i, *j) * share)
        };
        let through =
            |i: usize| self.light.iter().enumerate().fold(F::int(0), |sum, part| sum + carried(part, i));
        self.kept.iter().map(|&i| at(force, i) - through(i)).collect()
    }

    /// The stiffness of the bodies with mass.
    pub(crate) fn balanced(&self, stiffness: &Matrix<F>) -> Matrix<F> {
        let mut result = Matrix::zero(self.kept.len(), self.kept.len());
        for (b, &j) in self.kept.iter().enumerate() {
            let column: Vec<F> = stiffness.rows().map(|row| at(row, j)).collect();
            self.force(stiffness, &column).iter().enumerate().for_each(|(a, &x)| result.set(a, b, x));
        }
        result
    }
}
