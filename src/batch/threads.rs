//! Batches on several threads.

use super::block::POINTS;
use super::columns::{Looped, Slices};
use super::damped;
use super::kernel::Kernel;
use super::level::Level;
use super::run::run;
use crate::machine::ratios::Ratios;
use crate::output::Output;

/// Runs [`run`] on all threads of the current rayon pool. The slices are halved recursively between blocks,
/// so that the result does not depend on the number of threads.
pub(crate) fn run_on_threads(
    kernel: &Kernel<'_>,
    level: Level,
    omega: &[f64],
    alpha: &[f64],
    out: Looped<'_>,
) {
    /// The least number of points for which a further task pays off.
    const WORTH: usize = 16 * POINTS;
    let half = omega.len() / 2 / POINTS * POINTS;
    if half < WORTH {
        return run(kernel, level, omega, alpha, out);
    }
    let (left_omega, right_omega) = omega.split_at(half);
    let (left_alpha, right_alpha) = alpha.split_at(half);
    let (left, right) = out.split_at(half);
    rayon::join(
        || run_on_threads(kernel, level, left_omega, left_alpha, left),
        || run_on_threads(kernel, level, right_omega, right_alpha, right),
    );
}

/// Runs [`damped::run`] on all threads, by recursive halving. The first point is the one at `start`.
pub(crate) fn each(
    level: Level,
    start: usize,
    n: usize,
    columns: Slices<'_, { Output::ALL.len() }>,
    ratios: &(impl Fn(usize) -> Option<Ratios<f64>> + Sync),
) {
    let half = n / 2 / POINTS * POINTS;
    if half == 0 {
        return damped::run(level, start, n, columns, ratios);
    }
    let (left, right) = columns.split_at(half);
    rayon::join(
        || each(level, start, half, left, ratios),
        || each(level, start + half, n - half, right, ratios),
    );
}
