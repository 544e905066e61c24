//! How slices are cut into blocks, and what the loops left is done.

use super::block::{Block, POINTS, STRETCH, pad};
use super::level::{Level, Loops};
use super::places::Places;
use crate::regime::{Regime, regime_above};

/// Blocks for what passes from one loop to the next: made once for all the blocks of a run.
pub(crate) type Work = [Block; 11];

/// A set of `N` outputs as functions of Ω and α.
pub(crate) trait Kernel<const N: usize>: Sync {
    /// The output that is never NaN where a point was computed: NaN there means that the point is left to
    /// [`Kernel::careful`].
    const MARK: usize;

    /// The outputs over a block; `#[inline(always)]`, as all it calls.
    fn pass(&self, omega: &Block, alpha: &Block, work: &mut Work, out: [&mut Block; N]);

    /// Whether there is [`Kernel::pass_straight`].
    const IS_STRAIGHT: bool = false;

    /// [`Kernel::pass`] for outputs of one loop, which need no blocks in between: over as many blocks as there are.
    #[inline(always)]
    fn pass_straight(&self, _omega: &[Block], _alpha: &[Block], _out: [&mut [Block]; N]) {}

    /// The outputs over a block of points with [`Kernel::has_low`]; `#[inline(always)]`, as all it calls.
    #[inline(always)]
    fn pass_low(&self, _omega: &Block, _alpha: &Block, _work: &mut Work, _out: [&mut Block; N]) {}

    /// Whether [`Kernel::pass_low`] may have the answer at an Ω for which [`Kernel::pass`] has none.
    #[inline]
    fn has_low(&self, _omega: f64) -> bool {
        false
    }

    /// The outputs at one point by the library's own code for one point.
    fn careful(&self, omega: f64, alpha: f64) -> [f64; N];

    /// The Ω of a point, where the slice of Ω has `given`: that, unless the kernel has an Ω of its own.
    #[inline]
    fn omega(&self, given: f64) -> f64 {
        given
    }
}

/// Whether a mark says that its point is left: one NaN makes a sum NaN. In sixteen sums, of which vectors are made.
#[inline(always)]
fn is_any_left(marks: &[Block]) -> bool {
    let mut sums = [0.0; 16];
    for marks in marks.as_flattened().as_chunks::<16>().0 {
        for (sum, mark) in sums.iter_mut().zip(marks) {
            *sum += mark;
        }
    }
    let mut total = 0.0;
    for sum in sums {
        total += sum;
    }
    total.is_nan()
}

struct Pass<'a, K, const N: usize> {
    kernel: &'a K,
    omega: &'a Block,
    alpha: &'a Block,
    scratch: &'a mut Scratch<N>,
}

impl<K: Kernel<N>, const N: usize> Loops for Pass<'_, K, N> {
    type Output = bool;

    #[inline(always)]
    fn run(self) -> bool {
        let Scratch { work, answer } = self.scratch;
        self.kernel.pass(self.omega, self.alpha, work, answer.each_mut());
        answer.get(K::MARK).is_none_or(|marks| is_any_left(core::slice::from_ref(marks)))
    }
}

struct PassStraight<'a, 'b, K, const N: usize> {
    kernel: &'a K,
    omega: &'a [Block],
    alpha: &'a [Block],
    out: &'a mut [&'b mut [f64]; N],
}

impl<K: Kernel<N>, const N: usize> Loops for PassStraight<'_, '_, K, N> {
    type Output = bool;

    #[inline(always)]
    fn run(self) -> bool {
        let mut out = self.out.each_mut().map(|column| column.as_chunks_mut().0);
        self.kernel.pass_straight(self.omega, self.alpha, out.each_mut().map(|blocks| &mut **blocks));
        is_any_left(out.get(K::MARK).map_or(&[], |blocks| &**blocks))
    }
}

struct PassLow<'a, K, const N: usize>(Pass<'a, K, N>);

impl<K: Kernel<N>, const N: usize> Loops for PassLow<'_, K, N> {
    type Output = bool;

    #[inline(always)]
    fn run(self) -> bool {
        let Pass { kernel, omega, alpha, scratch: Scratch { work, answer } } = self.0;
        kernel.pass_low(omega, alpha, work, answer.each_mut());
        answer.get(K::MARK).is_none_or(|marks| is_any_left(core::slice::from_ref(marks)))
    }
}

/// Blocks of a thread's own: that no two of them overlap is then known to the compiler, too.
struct Scratch<const N: usize> {
    work: Work,
    answer: [Block; N],
}

impl<const N: usize> Scratch<N> {
    const fn new() -> Self {
        Self { work: [[0.0; POINTS]; 11], answer: [[0.0; POINTS]; N] }
    }

    /// The answers where they belong.
    fn put(&self, columns: &mut [&mut [f64]; N]) {
        for (column, block) in columns.iter_mut().zip(&self.answer) {
            if let Some(values) = block.get(..column.len()) {
                column.copy_from_slice(values);
            }
        }
    }
}

/// Where the outputs go.
struct Out<'a, const N: usize> {
    columns: [&'a mut [f64]; N],
    /// Of the same length, or empty.
    regimes: &'a mut [Option<Regime>],
}

impl<const N: usize> Out<'_, N> {
    /// The outputs of `n` points from `start` on.
    fn part(&mut self, start: usize, n: usize) -> [&mut [f64]; N] {
        self.columns.each_mut().map(|column| {
            let rest = column.get_mut(start..).unwrap_or_default();
            rest.get_mut(..n).unwrap_or_default()
        })
    }

    /// The answers of points that are not together.
    fn scatter(&mut self, places: &[usize], answer: &[Block; N]) {
        for (column, block) in self.columns.iter_mut().zip(answer) {
            for (&place, &value) in places.iter().zip(block) {
                if let Some(slot) = column.get_mut(place) {
                    *slot = value;
                }
            }
        }
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
    let mut out = Out { columns: out, regimes };
    // Loops that are straight have no use for it but at the end.
    let (mut scratch, mut rooms) = (None, (None, None));
    let mut low = Places::default();
    let mut start = 0;
    while let left @ 1.. = omega.len().saturating_sub(start) {
        let is_straight = K::IS_STRAIGHT && left >= POINTS && level != Level::Scalar;
        let n = if is_straight { (left - left % POINTS).min(STRETCH) } else { left.min(POINTS) };
        let [omegas, alphas] = [omega, alpha].map(|from| from.get(start..start + n).unwrap_or_default());
        let mut columns = out.part(start, n);
        let mut set_aside = |i, omega| {
            let is_low = kernel.has_low(kernel.omega(omega));
            if is_low {
                low.push(start + i);
            }
            is_low
        };
        if level == Level::Scalar {
            columns.iter_mut().for_each(|column| column.fill(f64::NAN));
            redo(kernel, omegas, alphas, &mut columns, |_, _| false);
        } else if is_straight {
            let (omega, alpha) = (omegas.as_chunks().0, alphas.as_chunks().0);
            if level.run(PassStraight { kernel, omega, alpha, out: &mut columns }) {
                redo(kernel, omegas, alphas, &mut columns, set_aside);
            }
        } else {
            let scratch = scratch.get_or_insert_with(Scratch::new);
            let (omega, alpha) = (whole(omegas, &mut rooms.0), whole(alphas, &mut rooms.1));
            let is_any_left = level.run(Pass { kernel, omega, alpha, scratch });
            scratch.put(&mut columns);
            if is_any_left {
                redo(kernel, omegas, alphas, &mut columns, &mut set_aside);
            }
        }
        start += n;
        while low.is_full() {
            low_points(
                kernel,
                level,
                omega,
                alpha,
                scratch.get_or_insert_with(Scratch::new),
                &mut low,
                &mut out,
            );
        }
    }
    while !low.is_empty() {
        low_points(kernel, level, omega, alpha, scratch.get_or_insert_with(Scratch::new), &mut low, &mut out);
    }
    let borders = out.columns.get(K::MARK).into_iter().flat_map(|column| column.iter());
    for (((slot, &omega), &alpha), &border) in out.regimes.iter_mut().zip(omega).zip(alpha).zip(borders) {
        // Where the border is NaN there is no regime.
        *slot = (!border.is_nan()).then(|| regime_above(kernel.omega(omega), alpha, border));
    }
}

/// A block of the points set aside.
fn low_points<K: Kernel<N>, const N: usize>(
    kernel: &K,
    level: Level,
    omega: &[f64],
    alpha: &[f64],
    scratch: &mut Scratch<N>,
    low: &mut Places,
    out: &mut Out<'_, N>,
) {
    let places = low.pop();
    let count = places.len();
    let last = places.last().copied().unwrap_or_default();
    let gather = |from: &[f64]| {
        let mut block = [from.get(last).copied().unwrap_or_default(); POINTS];
        for (slot, &place) in block.iter_mut().zip(&places) {
            *slot = from.get(place).copied().unwrap_or_default();
        }
        block
    };
    let (omega, alpha) = (gather(omega), gather(alpha));
    let is_any_left = level.run(PassLow(Pass { kernel, omega: &omega, alpha: &alpha, scratch }));
    let (omega, alpha) = (omega.get(..count).unwrap_or_default(), alpha.get(..count).unwrap_or_default());
    if is_any_left {
        let mut answer = scratch.answer.each_mut().map(<[f64; POINTS]>::as_mut_slice);
        redo(kernel, omega, alpha, &mut answer, |_, _| false);
    }
    out.scatter(&places, &scratch.answer);
}

/// The first block of `points`; where there is less, `room` with it.
fn whole<'a>(points: &'a [f64], room: &'a mut Option<Block>) -> &'a Block {
    points.first_chunk().unwrap_or_else(|| {
        let room = room.get_or_insert([0.0; POINTS]);
        pad(points, room);
        room
    })
}

/// Does the points whose mark says so, but for those that are `set_aside`, by their place in the block and Ω.
fn redo<K: Kernel<N>, const N: usize>(
    kernel: &K,
    omega: &[f64],
    alpha: &[f64],
    answer: &mut [&mut [f64]; N],
    mut set_aside: impl FnMut(usize, f64) -> bool,
) {
    for (i, (&omega, &alpha)) in omega.iter().zip(alpha).enumerate() {
        let mark = answer.get(K::MARK).and_then(|block| block.get(i)).copied().unwrap_or_default();
        if mark.is_nan() && !set_aside(i, omega) {
            for (column, value) in answer.iter_mut().zip(kernel.careful(omega, alpha)) {
                if let Some(slot) = column.get_mut(i) {
                    *slot = value;
                }
            }
        }
    }
}
