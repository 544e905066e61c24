//! How slices are cut into blocks, and the points that the loops left are done.

use super::alone;
use super::amplitude::Point;
use super::block::{Block, POINTS, each, pad};
use super::columns::{BORDER, LOOPED, Looped};
use super::fixed::{FixedOmega, OfOmega, Row};
use super::level::{Level, Loops};
use super::low::{LowOmega, has_low_loops};
use super::places::Places;
use super::stages::{Answer, HighParts, LowParts, Stages, Work};
use super::straight::{Rooms, is_any_nan};
use super::velocity::Parts;
use crate::regime::{Regime, regime_above};

/// The outputs wanted, as functions of Ω and α, or of α in a row of one Ω.
#[derive(Clone, Copy)]
pub(crate) struct Kernel<'a> {
    stages: Stages,
    row: Option<&'a FixedOmega>,
}

impl<'a> Kernel<'a> {
    pub(crate) fn new(wanted: &Looped<'_>, row: Option<&'a FixedOmega>) -> Self {
        Self { stages: Stages::of(wanted), row }
    }

    /// The level it runs at: point by point where the loops do not reach the row.
    pub(crate) fn level(&self, level: Level) -> Level {
        let is_reached = self.row.is_none_or(|row| self.stages.is_amplitude() || row.has_loops());
        if is_reached { level } else { Level::Scalar }
    }

    /// The outputs over a block.
    #[inline(always)]
    fn pass(&self, omega: &Block, alpha: &Block, scratch: &mut Scratch) {
        let Scratch { high, work, answer, .. } = scratch;
        match self.row {
            None if self.stages.is_amplitude() => {
                let [displacement, border, size, ..] = answer;
                each(&Point::new(), [omega, alpha], [displacement, border, size]);
            }
            None => {
                each(&Parts::new(), [omega], high.each_mut());
                self.stages.high(omega, alpha, high, work, answer);
            }
            Some(row) if self.stages.is_amplitude() => {
                let [displacement, border, size, ..] = answer;
                each(&Row::new(row), [alpha, alpha], [displacement, border, size]);
            }
            Some(row) => match row.of_omega() {
                OfOmega::High(parts) => self.stages.high(row.block(), alpha, parts, work, answer),
                OfOmega::Low(parts) => self.stages.low(row.block(), alpha, parts, work, answer),
                OfOmega::None => {}
            },
        }
    }

    /// The same over a block of points below Ω = 1/2.
    #[inline(always)]
    fn pass_low(&self, omega: &Block, alpha: &Block, scratch: &mut Scratch) {
        let Scratch { low, work, answer, .. } = scratch;
        each(&LowOmega, [omega], low.each_mut());
        self.stages.low(omega, alpha, low, work, answer);
    }

    /// Whether [`Kernel::pass_low`] may have the answer at an Ω for which [`Kernel::pass`] has none.
    pub(crate) fn has_low(&self, omega: f64) -> bool {
        self.row.is_none() && has_low_loops(omega)
    }

    fn alone(&self, omega: f64, alpha: f64) -> [f64; LOOPED.len()] {
        let omega = self.omega(omega);
        if self.stages.is_amplitude() { alone::amplitude(omega, alpha) } else { alone::all(omega, alpha) }
    }

    /// The Ω of a point, where the slice of Ω has `given`.
    pub(crate) fn omega(&self, given: f64) -> f64 {
        self.row.map_or(given, FixedOmega::omega)
    }

    pub(crate) const fn row(&self) -> Option<&'a FixedOmega> {
        self.row
    }

    /// The regimes where they are wanted, from the borders: where that is NaN there is no regime.
    pub(crate) fn regimes(
        &self,
        slots: Option<&mut [Option<Regime>]>,
        omega: &[f64],
        alpha: &[f64],
        borders: &[f64],
    ) {
        let points = omega.iter().zip(alpha).zip(borders);
        for (slot, ((&omega, &alpha), &border)) in slots.into_iter().flatten().zip(points) {
            *slot = (!border.is_nan()).then(|| regime_above(self.omega(omega), alpha, border));
        }
    }
}

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

/// Blocks of a thread's own: that no two of them overlap is then known to the compiler, too.
struct Scratch {
    high: HighParts,
    low: LowParts,
    work: Work,
    answer: Answer,
}

impl Scratch {
    const fn new() -> Self {
        let block = [0.0; POINTS];
        Self { high: [block; 5], low: [block; 6], work: [block; 3], answer: [block; LOOPED.len()] }
    }

    /// Does the points of which α_min is NaN, but for those that are `set_aside`, by their place in the block and Ω.
    fn redo(
        &mut self,
        kernel: &Kernel<'_>,
        omega: &[f64],
        alpha: &[f64],
        mut set_aside: impl FnMut(usize, f64) -> bool,
    ) {
        for (i, (&omega, &alpha)) in omega.iter().zip(alpha).enumerate() {
            let is_left = self.answer[BORDER].get(i).is_some_and(|mark| mark.is_nan());
            if is_left && !set_aside(i, omega) {
                for (block, value) in self.answer.iter_mut().zip(kernel.alone(omega, alpha)) {
                    if let Some(slot) = block.get_mut(i) {
                        *slot = value;
                    }
                }
            }
        }
    }
}

impl Looped<'_> {
    /// The answers of the points from `start` on.
    fn put(&mut self, kernel: &Kernel<'_>, start: usize, omega: &[f64], alpha: &[f64], answer: &Answer) {
        let n = omega.len();
        for (slice, block) in self.numbers.iter_mut().zip(answer) {
            let part = slice.as_mut().and_then(|slice| slice.get_mut(start..)?.get_mut(..n));
            if let (Some(part), Some(values)) = (part, block.get(..n)) {
                part.copy_from_slice(values);
            }
        }
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

/// A block of the points set aside.
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

/// `points` as a block; where there are fewer, `room` with them.
fn whole<'a>(points: &'a [f64], room: &'a mut Block) -> &'a Block {
    points.first_chunk().unwrap_or_else(|| {
        pad(points, room);
        room
    })
}
