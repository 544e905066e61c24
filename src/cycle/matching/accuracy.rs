//! How good a solution is: its residuals in units of the last place, and the bits the problem loses.

use super::Unknowns;
use super::balanced::Balanced;
use crate::float::{Field, Float};
use nalgebra::{DMatrix, RealField};

pub(super) fn in_last_places<F: Float>(residual: F, size: F) -> F {
    residual.abs() / (size * F::epsilon())
}

/// Bits that the inverse Jacobian takes from a phase, V₀ or Δ₀, the residuals being good to a few last places
/// of their terms.
pub(super) fn lost_bits<F: Float + RealField>(balanced: &Balanced<F>, u: &Unknowns<F>) -> u32 {
    let (one, system) = (<F as Field>::int(1), balanced.system());
    let (f1, g1) = system.forced_at(u.velocity_phase);
    let (rho, offset) = (u.max_velocity - g1, u.deviation + system.friction - f1);
    let parts = [system.omega, one / system.omega, system.friction, rho, offset];
    let terms = parts.into_iter().fold(1.0, |sum, x| sum + Float::to_f64(x).abs());
    let (_, jacobian, _) = balanced.equations(u);
    let matrix = DMatrix::from_row_iterator(5, 5, jacobian.into_iter().flatten());
    let Some(inverse) = matrix.try_inverse() else { return F::precision() };
    let sizes = [one, one, u.max_velocity, u.max_displacement];
    let worst = inverse.row_iter().zip(sizes).map(|(row, size)| {
        let sum = row.iter().fold(<F as Field>::int(0), |sum, y| sum + Field::abs(*y));
        4.0 * terms * Float::to_f64(sum / size).abs()
    });
    let bits = worst.fold(1.0, f64::max).log2().ceil();
    (bits as u32).min(F::precision())
}
