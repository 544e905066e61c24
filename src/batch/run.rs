//! Slices are cut into blocks, and the points that the loops cannot compute are added.

use super::block::{Block, POINTS, pad};
use super::columns::{BORDER, Looped};
use super::kernel::{Kernel, Scratch};
use super::level::{Level, Loops};
use super::places::Places;
use super::stages::Answer;
use super::straight::{Rooms, is_any_nan};

struct Pass<'a> {
    kernel: &'a Kernel<'a>,
    omega: &'a Block,
    alpha: &'a Block,
    scratch: &'a mut Scratch,
}

impl Loops for Pass<'_> {
    type Output = bool;

    #[inline(always)]
    fn run(self) -> bool {
        self.kernel.pass(self.omega, self.alpha, self.scratch);
        is_any_nan(&self.scratch.answer[BORDER])
    }
}

struct PassLow<'a>(Pass<'a>);

impl Loops for PassLow<'_> {
    type Output = bool;

    #[inline(always)]
    fn run(self) -> bool {
        let Pass { kernel, omega, alpha, scratch } = self.0;
        kernel.pass_low(omega, alpha, scratch);
        is_any_nan(&scratch.answer[BORDER])
    }
}

impl Looped<'_> {
    /// Writes the answers of the points from `start` on.
    fn put(&mut self, kernel: &Kernel<'_>, start: usize, omega: &[f64], alpha: &[f64], answer: &Answer) {
        self.put_numbers(start, omega.len(), answer);
        let regimes = self.regime.as_mut().and_then(|slice| slice.get_mut(start..));
        kernel.regimes(regimes, omega, alpha, &answer[BORDER]);
    }
}

/// Runs a kernel over slices of equal length.
pub(crate) fn run<'a>(
    kernel: &Kernel<'_>,
    level: Level,
    omega: &'a [f64],
    alpha: &'a [f64],
    mut out: Looped<'_>,
) {
    let mut scratch = Scratch::new();
    let (mut omega_room, mut alpha_room) = ([0.0; POINTS], [0.0; POINTS]);
    let mut low = Places::default();
    let mut done = 0;
    if kernel.stages.is_amplitude() && level != Level::Scalar {
        let mut rooms = Rooms::new(&out);
        while let n @ 1.. = rooms.stretch(kernel, level, [omega, alpha], done, &mut out, &mut low) {
            done += n;
            while low.is_full() {
                low_points(kernel, level, omega, alpha, &mut scratch, &mut low, &mut out);
            }
        }
    }
    let rest = |slice: &'a [f64]| slice.get(done..).unwrap_or_default().chunks(POINTS);
    for ((omegas, alphas), start) in rest(omega).zip(rest(alpha)).zip((done..).step_by(POINTS)) {
        if level == Level::Scalar {
            scratch.answer[BORDER].fill(f64::NAN);
            scratch.redo(kernel, omegas, alphas, |_, _| false);
        } else {
            let (omega, alpha) = (whole(omegas, &mut omega_room), whole(alphas, &mut alpha_room));
            if level.run(Pass { kernel, omega, alpha, scratch: &mut scratch }) {
                scratch.redo(kernel, omegas, alphas, |i, omega| {
                    let is_low = kernel.has_low(omega);
                    if is_low {
                        low.push(start + i);
                    }
                    is_low
                });
            }
        }
        out.put(kernel, start, omegas, alphas, &scratch.answer);
        while low.is_full() {
            low_points(kernel, level, omega, alpha, &mut scratch, &mut low, &mut out);
        }
    }
    while !low.is_empty() {
        low_points(kernel, level, omega, alpha, &mut scratch, &mut low, &mut out);
    }
}

/// Computes a block of the points set aside.
fn low_points(
    kernel: &Kernel<'_>,
    level: Level,
    omega: &[f64],
    alpha: &[f64],
    scratch: &mut Scratch,
    low: &mut Places,
    out: &mut Looped<'_>,
) {
    let places = low.pop();
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
    let count = places.len();
    let (omega, alpha) = (omega.get(..count).unwrap_or_default(), alpha.get(..count).unwrap_or_default());
    if is_any_left {
        scratch.redo(kernel, omega, alpha, |_, _| false);
    }
    for (slice, block) in out.numbers.iter_mut().zip(&scratch.answer) {
        let Some(slice) = slice else { continue };
        for (&place, &value) in places.iter().zip(block) {
            if let Some(slot) = slice.get_mut(place) {
                *slot = value;
            }
        }
    }
    if let Some(slots) = &mut out.regime {
        let mut found = [None; POINTS];
        kernel.regimes(Some(&mut found), omega, alpha, &scratch.answer[BORDER]);
        for (&place, regime) in places.iter().zip(found) {
            if let Some(slot) = slots.get_mut(place) {
                *slot = regime;
            }
        }
    }
}

/// `points` as a block; if there are fewer, they are copied to `room` and padded.
fn whole<'a>(points: &'a [f64], room: &'a mut Block) -> &'a Block {
    points.first_chunk().unwrap_or_else(|| {
        pad(points, room);
        room
    })
}
