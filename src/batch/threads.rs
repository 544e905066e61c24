//! The work spread over threads.

use super::block::POINTS;
use super::kernel::{Kernel, run};
use super::level::Level;
use crate::regime::Regime;

/// [`run`] on all threads of the current rayon pool: the halves of halves, cut between blocks, so that the result does
/// not depend on how many threads there are.
pub(crate) fn run_on_threads<K: Kernel<N>, const N: usize>(
    kernel: &K,
    level: Level,
    omega: &[f64],
    alpha: &[f64],
    out: [&mut [f64]; N],
    regimes: &mut [Option<Regime>],
) {
    /// Blocks worth a task of their own.
    const WORTH: usize = 16 * POINTS;
    let half = omega.len() / 2 / POINTS * POINTS;
    if half < WORTH {
        return run(kernel, level, omega, alpha, out, regimes);
    }
    let (left_omega, right_omega) = omega.split_at(half);
    let (left_alpha, right_alpha) = alpha.split_at(half);
    let mut rights = out.map(|slice| {
        let (left, right) = slice.split_at_mut(half);
        (left, Some(right))
    });
    let right = rights.each_mut().map(|(_, right)| right.take().unwrap_or_default());
    let (left_regimes, right_regimes) = regimes.split_at_mut(half.min(regimes.len()));
    let left = rights.map(|(left, _)| left);
    rayon::join(
        || run_on_threads(kernel, level, left_omega, left_alpha, left, left_regimes),
        || run_on_threads(kernel, level, right_omega, right_alpha, right, right_regimes),
    );
}
