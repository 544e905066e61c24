//! How slices are cut into blocks, what was left to the careful path is done, and the work is spread over threads.

use super::block::{Block, POINTS, padded};
use super::level::{Level, Loops};
use crate::regime::Regime;

/// Blocks for what passes from one loop to the next: made once for all the blocks of a run.
pub(crate) type Work = [Block; 9];

/// A set of `N` outputs as functions of Ω and α.
pub(crate) trait Kernel<const N: usize>: Sync {
    /// The output that is never NaN where a point was computed: NaN there means that the point is left to
    /// [`Kernel::careful`].
    const MARK: usize;

    /// The outputs over a block; `#[inline(always)]`, as all it calls.
    fn pass(&self, omega: &Block, alpha: &Block, work: &mut Work, out: [&mut Block; N]);

    /// The outputs at one point by the library's own code for one point.
    fn careful(&self, omega: f64, alpha: f64) -> [f64; N];

    /// The Ω of a point, where the slice of Ω has `given`: that, unless the kernel has an Ω of its own.
    #[inline]
    fn omega(&self, given: f64) -> f64 {
        given
    }
}

struct Pass<'a, K, const N: usize> {
    kernel: &'a K,
    omega: &'a Block,
    alpha: &'a Block,
    work: &'a mut Work,
    out: [&'a mut Block; N],
}

impl<K: Kernel<N>, const N: usize> Loops for Pass<'_, K, N> {
    #[inline(always)]
    fn run(self) {
        self.kernel.pass(self.omega, self.alpha, self.work, self.out);
    }
}

/// The regime at a point whose border is known; `None` where that is NaN.
#[inline]
fn regime(omega: f64, alpha: f64, border: f64) -> Option<Regime> {
    if border.is_nan() {
        None
    } else if alpha <= 1.0 {
        Some(Regime::Stuck)
    } else if alpha < border {
        Some(Regime::Sticking)
    } else if omega == 1.0 {
        Some(Regime::Unbounded)
    } else {
        Some(Regime::NonSticking)
    }
}

/// Runs a kernel over slices of equal length; the regimes, where they are wanted, into a slice of that length, or an
/// empty one.
pub(crate) fn run<K: Kernel<N>, const N: usize>(
    kernel: &K,
    level: Level,
    omega: &[f64],
    alpha: &[f64],
    out: [&mut [f64]; N],
    regimes: &mut [Option<Regime>],
) {
    let mut regimes = regimes.chunks_mut(POINTS);
    let mut out = out.map(|slice| slice.chunks_mut(POINTS));
    // Blocks of the thread's own: that no two of them overlap is then known to the compiler, too.
    let (mut answer, mut work) = ([[0.0; POINTS]; N], [[0.0; POINTS]; 9]);
    for (omega, alpha) in omega.chunks(POINTS).zip(alpha.chunks(POINTS)) {
        if level == Level::Scalar {
            redo(kernel, omega, alpha, &mut answer, |_| true);
        } else {
            over_block(kernel, level, omega, alpha, &mut work, &mut answer);
        }
        if let (Some(slots), Some(borders)) = (regimes.next(), answer.get(K::MARK)) {
            for (((slot, &omega), &alpha), &border) in slots.iter_mut().zip(omega).zip(alpha).zip(borders) {
                *slot = regime(kernel.omega(omega), alpha, border);
            }
        }
        for (slices, block) in out.iter_mut().zip(&answer) {
            if let Some(slice) = slices.next()
                && let Some(points) = block.get(..slice.len())
            {
                slice.copy_from_slice(points);
            }
        }
    }
}

/// One block, or what there is of it.
fn over_block<K: Kernel<N>, const N: usize>(
    kernel: &K,
    level: Level,
    omega: &[f64],
    alpha: &[f64],
    work: &mut Work,
    answer: &mut [Block; N],
) {
    if let (Some(omega), Some(alpha)) = (omega.first_chunk(), alpha.first_chunk()) {
        level.run(Pass { kernel, omega, alpha, work, out: answer.each_mut() });
    } else if let (Some(omega), Some(alpha)) = (padded(omega), padded(alpha)) {
        level.run(Pass { kernel, omega: &omega, alpha: &alpha, work, out: answer.each_mut() });
    }
    redo(kernel, omega, alpha, answer, f64::is_nan);
}

/// Does the points whose mark says so.
fn redo<K: Kernel<N>, const N: usize>(
    kernel: &K,
    omega: &[f64],
    alpha: &[f64],
    answer: &mut [Block; N],
    is_left: impl Fn(f64) -> bool,
) {
    /// Points looked at together: few blocks have none left, most eighths of a block do.
    const GROUP: usize = 16;
    for start in (0..omega.len()).step_by(GROUP) {
        let marks = answer.get(K::MARK).and_then(|block| block.get(start..start + GROUP)).unwrap_or_default();
        if !marks.iter().fold(false, |any, &mark| any | is_left(mark)) {
            continue;
        }
        let points = omega.iter().zip(alpha).enumerate().skip(start).take(GROUP);
        for (i, (&omega, &alpha)) in points {
            let mark = answer.get(K::MARK).and_then(|block| block.get(i)).copied().unwrap_or_default();
            if is_left(mark) {
                for (block, value) in answer.iter_mut().zip(kernel.careful(omega, alpha)) {
                    if let Some(slot) = block.get_mut(i) {
                        *slot = value;
                    }
                }
            }
        }
    }
}

/// The same on all threads of the current rayon pool: the halves of halves, cut between blocks, so that the result does
/// not depend on how many threads there are.
#[cfg(feature = "rayon")]
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
