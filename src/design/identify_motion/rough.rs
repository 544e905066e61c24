//! A first stiffness from a load and the motion under it.

use crate::design::least_squares::inverse;
use crate::machine::excitation::Excitation;
use crate::motion::record::Record;
use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Ordering;

/// The stiffness by linear least squares; `None` where it is not > 0.
///
/// The equation of motion, twice integrated over the time τ since the start, is linear in k, c, r and three constants:
/// `k ∬x + c ∫x + r ∬sgn x′ + a + bτ + dτ² = ∬f − m x`. A support that moves by u has `k ∬(x − u)` and no load. Integrals by the
/// trapezoidal rule; the sign of the velocity is that of the difference of neighbours, which at rest is as often + as −.
pub(super) fn stiffness(mass: f64, load: &Record<f64>, displacements: &[f64]) -> Option<f64> {
    let excitation = load.excitation();
    let foot = if excitation.moves_foot() { 1.0 } else { 0.0 };
    let forced = if excitation.carries_surface() { -mass } else { 1.0 - foot };
    let start = load.time(0);
    let times: Vec<f64> = (0..displacements.len()).map(|i| load.time(i) - start).collect();
    let integral = |values: &[f64]| {
        let (mut sum, mut all) = (0.0, vec![0.0]);
        for (t, v) in times.windows(2).zip(values.windows(2)) {
            let ([t0, t1], [v0, v1]) = (t, v) else { continue };
            sum += (t1 - t0) * (v0 + v1) / 2.0;
            all.push(sum);
        }
        all
    };
    let twice = |values: &[f64]| integral(&integral(values));
    let stretched: Vec<f64> = displacements.iter().zip(load.samples()).map(|(x, u)| x - foot * u).collect();
    let force: Vec<f64> = load.samples().iter().map(|f| forced * f).collect();
    let mut signs: Vec<f64> = displacements
        .windows(2)
        .map(|pair| match pair.last().partial_cmp(&pair.first()) {
            Some(Ordering::Greater) => 1.0,
            Some(Ordering::Less) => -1.0,
            _ => 0.0,
        })
        .collect();
    signs.extend(signs.last().copied());
    let columns = [
        twice(&stretched),
        integral(if excitation == Excitation::DampedFootMotion { &stretched } else { displacements }),
        twice(&signs),
        times.iter().map(|_| 1.0).collect(),
        times.clone(),
        times.iter().map(|t| t * t).collect(),
    ];
    let right: Vec<f64> = twice(&force).iter().zip(displacements).map(|(f, x)| f - mass * x).collect();
    let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
    let matrix: Vec<Vec<f64>> =
        columns.iter().map(|a| columns.iter().map(|b| product(a, b)).collect()).collect();
    let inverse = inverse(&matrix)?;
    let found = inverse
        .first()?
        .iter()
        .zip(&columns)
        .map(|(part, column)| part * product(column, &right))
        .sum::<f64>();
    (found > 0.0 && found.is_finite()).then_some(found)
}
