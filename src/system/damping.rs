//! Damping by the matrices of a structure: Rayleigh's, and a ratio for each of its modes.
//!
//! With the modes `K φ = ω² M φ`, `φᵀM φ = 1`, of the coordinates that are not moved, and those without mass in balance,
//!
//! ```text
//! C = Σ 2 ζ ω g gᵀ,   g = K φ/ω²
//! ```
//!
//! At a coordinate that is free, g is M φ, so that `φᵀC φ = 2 ζ ω`, and `φᵢᵀC φⱼ = 0`. At one that is moved, g is what makes the damper notice
//! the motion over that of the support alone: `g·q = 0` where the structure follows it without being strained.

use super::assembly::massless;
use super::error::Error;
use super::given::{at_least, finite, square};
use super::matrix::{Matrix, add_times, dot, set};
use super::model::Model;
use super::modes::{inverse_root, rounding_of};
use crate::float::Float;
use crate::machine::error::written;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use alloc::{format, vec};

impl<F: Float> Model<F> {
    /// This model with Rayleigh's damping beside the dampers that it has: `C + a M + b K`, a in 1/time and b in time.
    ///
    /// A mode of the angular frequency ω then has the damping ratio `(a/ω + b ω)/2`.
    ///
    /// # Errors
    /// [`Error`] where a factor is not finite, or a matrix is not square.
    ///
    /// ```
    /// use stickslip::system::{Error, Model};
    /// let one = |x: f64| vec![vec![x]];
    /// let model = Model { mass: one(2.0), damping: one(0.5), stiffness: one(8.0), ..Model::default() };
    /// assert_eq!(model.with_rayleigh(0.25, 0.125)?.damping, one(2.0));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn with_rayleigh(self, a: F, b: F) -> Result<Self, Error> {
        finite("rayleigh: a", a)?;
        finite("rayleigh: b", b)?;
        let n = self.mass.len();
        let mut added = square("mass", &self.mass, n, false)?.map(|x| a * x);
        let stiffness = square("stiffness", &self.stiffness, n, false)?;
        for (i, row) in stiffness.rows().enumerate() {
            add_times(added.row_mut(i), b, row);
        }
        self.with_damping(&added)
    }

    /// This model with the same damping ratios ζ ≥ 0 in its elastic modes, beside the dampers that it has: the first for that of the lowest
    /// frequency, and so on, and the last for all others, so that one ratio is that of all modes.
    ///
    /// The modes are those of M and K: without elements, and with prescribed coordinates at rest. Those without a restoring force, or with a
    /// negative one, get no damping. Coordinates without mass are in balance.
    ///
    /// # Errors
    /// [`Error`] without a ratio, where one is below 0 or not finite, or there are more than elastic modes; where M is not positive definite or K not
    /// symmetric; where no spring holds a coordinate without mass.
    ///
    /// ```
    /// use stickslip::system::{Error, Model};
    /// let one = |x: f64| vec![vec![x]];
    /// let model = Model { mass: one(2.0), damping: one(0.0), stiffness: one(8.0), ..Model::default() };
    /// // 2 ζ √(k m)
    /// let found = model.with_damping_ratios(&[0.25])?.damping[0][0];
    /// assert!((found - 2.0).abs() < 1e-14);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn with_damping_ratios(self, ratios: &[F]) -> Result<Self, Error> {
        const NAME: &str = "damping ratios";
        let Some(last) = ratios.last() else {
            return Err(Error::Length { name: NAME.to_string(), found: 0, expected: 1 });
        };
        for &ratio in ratios {
            finite(NAME, ratio)?;
            at_least(NAME, ratio, F::int(0))?;
        }
        let modes = self.elastic_modes()?;
        if ratios.len() > modes.len() {
            return Err(Error::TooMany { name: NAME.to_string(), found: ratios.len(), most: modes.len() });
        }
        let n = self.mass.len();
        let mut added = Matrix::zero(n, n);
        for (mode, &ratio) in modes.iter().zip(ratios.iter().chain(core::iter::repeat(last))) {
            for (i, &g) in mode.shape.iter().enumerate() {
                if g != F::int(0) {
                    // The product of two entries, and then the factor: the sum is symmetric to the last bit.
                    let row = added.row_mut(i).iter_mut().zip(&mode.shape);
                    row.for_each(|(x, &h)| *x = *x + F::int(2) * ratio * mode.frequency * (g * h));
                }
            }
        }
        self.with_damping(&added)
    }

    fn with_damping(mut self, added: &Matrix<F>) -> Result<Self, Error> {
        let own = square("damping", &self.damping, self.mass.len(), false)?;
        let sum = |(own, added): (&[F], &[F])| own.iter().zip(added).map(|(&x, &y)| x + y).collect();
        self.damping = own.rows().zip(added.rows()).map(sum).collect();
        Ok(self)
    }

    /// The modes with a restoring force, that of the lowest frequency first.
    fn elastic_modes(&self) -> Result<Vec<Elastic<F>>, Error> {
        let (n, zero) = (self.mass.len(), F::int(0));
        let mass = square("mass", &self.mass, n, true)?;
        let stiffness = symmetric(&square("stiffness", &self.stiffness, n, false)?)?;
        let light = massless(self);
        let is_moved = |i: usize| self.moved.iter().any(|moved| moved.coordinate == i);
        // What neither has mass nor is on a spring has no part.
        let joints: Vec<usize> =
            light.iter().copied().filter(|&i| stiffness.row(i).iter().any(|&x| x != zero)).collect();
        let bodies: Vec<usize> = (0..n).filter(|i| !light.contains(i) && !is_moved(*i)).collect();
        let of_bodies = submatrix(&mass, &bodies, &bodies);
        if let Err((row, value)) = of_bodies.inverse_of_definite() {
            let row = bodies.get(row).map_or(0, |i| i.saturating_add(1));
            return Err(Error::NotDefinite { row, value: written(value) });
        }
        // q_j = −K_jj⁻¹ K_jb q_b
        let joined = submatrix(&stiffness, &joints, &bodies);
        let held = submatrix(&stiffness, &joints, &joints).inverse_of_definite().map_err(|(row, _)| {
            let name = joints.get(row).map_or_else(String::new, |&i| match self.coordinates.get(i) {
                Some(name) => name.clone(),
                None => format!("coordinate {}", i.saturating_add(1)),
            });
            let condition = "must be held by springs, because it has no mass and modes have a damping ratio";
            Error::Unsupported { name, condition }
        })?;
        let follows = held.times(&joined).map(|x| -x);
        let mut balanced = submatrix(&stiffness, &bodies, &bodies);
        balanced.plus(&joined.transposed().times(&follows));
        let root = inverse_root(&of_bodies);
        let operator = root.times(&balanced).times(&root);
        let operator = half_sum(&operator);
        let rounding = rounding_of(&operator);
        let (squares, vectors) = operator.symmetric_modes();
        let mode = |(&square, vector): (&F, &[F])| {
            let own = root.of(vector);
            let mut whole = vec![zero; n];
            let joints = joints.iter().copied().zip(follows.of(&own));
            for (i, x) in bodies.iter().copied().zip(own.iter().copied()).chain(joints) {
                set(&mut whole, i, x);
            }
            let mut shape = mass.of(&whole);
            for moved in self.moved.iter().map(|moved| moved.coordinate) {
                set(&mut shape, moved, dot(stiffness.row(moved), &whole) / square);
            }
            (square > rounding).then(|| Elastic { frequency: square.sqrt(), shape })
        };
        let mut modes: Vec<_> = squares.iter().zip(vectors.rows()).filter_map(mode).collect();
        modes.sort_by(|a, b| a.frequency.partial_cmp(&b.frequency).unwrap_or(core::cmp::Ordering::Equal));
        Ok(modes)
    }
}

/// A mode with a restoring force.
struct Elastic<F> {
    /// ω.
    frequency: F,
    /// g = K φ/ω².
    shape: Vec<F>,
}

/// Some rows and columns of a matrix.
fn submatrix<F: Float>(matrix: &Matrix<F>, rows: &[usize], columns: &[usize]) -> Matrix<F> {
    let mut result = Matrix::zero(rows.len(), columns.len());
    for (a, &i) in rows.iter().enumerate() {
        columns.iter().enumerate().for_each(|(b, &j)| result.set(a, b, matrix.at(i, j)));
    }
    result
}

/// `(A + Aᵀ)/2`.
fn half_sum<F: Float>(matrix: &Matrix<F>) -> Matrix<F> {
    let mut sum = matrix.clone();
    sum.plus(&matrix.transposed());
    sum.map(|x| x / F::int(2))
}

/// A stiffness that is symmetric to rounding, with equal halves.
fn symmetric<F: Float>(stiffness: &Matrix<F>) -> Result<Matrix<F>, Error> {
    let most = stiffness.rows().flatten().fold(F::int(0), |most, x| most.or_larger(x.abs()));
    let rounding = most * F::epsilon() * F::int(64);
    for (i, row) in stiffness.rows().enumerate() {
        for (j, &value) in row.iter().enumerate().take(i) {
            let mirrored = stiffness.at(j, i);
            if (value - mirrored).abs() > rounding {
                let (row, column) = (i.saturating_add(1), j.saturating_add(1));
                let (value, mirrored) = (written(value), written(mirrored));
                return Err(Error::NotSymmetric {
                    name: "stiffness".to_string(),
                    row,
                    column,
                    value,
                    mirrored,
                });
            }
        }
    }
    Ok(half_sum(stiffness))
}
