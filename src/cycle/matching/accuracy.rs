//! How good a solution is: its residuals in units of the last place, and the bits the problem loses.

use super::balanced::Balanced;
use super::{Given, Unknowns};
use crate::float::{Field, Float};
use nalgebra::{DMatrix, RealField};

/// The largest term of eq. 21–25.
pub(super) fn largest_term<F: Float>(given: &Given<F>, u: &Unknowns<F>) -> F {
    let a = given.amplitude.abs();
    let terms = [a * given.omega.square(), given.rho(u).abs(), given.offset(u).abs(), u.max_displacement];
    terms.into_iter().fold(a, F::or_larger)
}

pub(super) fn in_last_places<F: Float>(residual: F, size: F) -> F {
    residual.abs() / (size * F::epsilon())
}

/// Bits that the inverse Jacobian takes from a phase, V₀ or Δ₀, the residuals being good to a few last places
/// of their terms.
pub(super) fn lost_bits<F: Float + RealField>(system: &Balanced<F>, u: &Unknowns<F>) -> u32 {
    let given = system.given();
    let one = <F as Field>::int(1);
    let parts =
        [system.omega, one / system.omega, given.friction_displacement, given.rho(u), given.offset(u)];
    let terms = parts.into_iter().fold(1.0, |sum, x| sum + Float::to_f64(x).abs());
    lost_bits_of(&system.jacobian(u), terms, u)
}

/// The bits that the problem loses, by the Jacobian and the size of the terms.
pub(super) fn lost_bits_of<F: Float>(jacobian: &[[F; 5]; 5], terms: f64, u: &Unknowns<F>) -> u32 {
    let entries = jacobian.iter().flatten().map(|&entry| Float::to_f64(entry));
    let Some(inverse) = DMatrix::from_row_iterator(5, 5, entries).try_inverse() else { return F::PRECISION };
    let one = F::int(1);
    let sizes = [one, one, u.max_velocity, u.max_displacement];
    let worst = inverse.row_iter().zip(sizes).map(|(row, size)| {
        4.0 * terms * row.iter().map(|y| y.abs()).sum::<f64>() / Float::to_f64(size).abs()
    });
    let bits = worst.fold(1.0, f64::max).log2().ceil();
    (bits as u32).min(F::PRECISION)
}
