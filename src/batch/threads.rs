//! The work spread over threads.

use super::block::POINTS;
use super::columns::{Looped, Slices};
use super::kernel::Kernel;
use super::level::Level;
use super::run::run;
use crate::output::Output;
use crate::ratios::Ratios;

/// [`run`] on all threads of the current rayon pool: the halves of halves, cut between blocks, so that the
/// result does not depend on how many threads there are.
pub(crate) fn run_on_threads(
    kernel: &Kernel<'_>,
    level: Level,
    omega: &[f64],
    alpha: &[f64],
    out: Looped<'_>,
) {
    /// Blocks worth a task of their own.
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

/// Each point alone, on all threads: the halves of halves again. The first point is the one at `start`.
pub(crate) fn each(
    start: usize,
    n: usize,
    mut columns: Slices<'_, { Output::ALL.len() }>,
    ratios: &(impl Fn(usize) -> Option<Ratios<f64>> + Sync),
) {
    let half = n / 2;
    if half < POINTS {
        return (0..n).for_each(|i| columns.put(i, ratios(start + i)));
    }
    let (left, right) = columns.split_at(half);
    rayon::join(|| each(start, half, left, ratios), || each(start + half, n - half, right, ratios));
}
