//! {Δ₀, α_min, A₁} by a single loop, written directly to the slices of the caller.

use super::alone;
use super::amplitude::Point;
use super::block::{AtPoint, POINTS};
use super::columns::{BORDER, Looped};
use super::fixed::{FixedOmega, Row};
use super::kernel::Kernel;
use super::level::{Level, Loops};
use super::places::Places;
use crate::machine::ratios::Ratios;

/// The greatest number of points per call: few enough to stay in the first-level cache until they are
/// checked.
const STRETCH: usize = 8 * POINTS;

struct Pass<'a> {
    row: Option<&'a FixedOmega>,
    omega: &'a [f64],
    alpha: &'a [f64],
    out: [&'a mut [f64]; 3],
}

impl Loops for Pass<'_> {
    type Output = bool;

    #[inline(always)]
    fn run(self) -> bool {
        let Self { row, omega, alpha, out: [displacement, border, size] } = self;
        match row {
            None => each(&Point::new(), omega, alpha, displacement, border, size),
            // A copy, which cannot overlap the outputs.
            Some(row) => each(&Row::new(row), omega, alpha, displacement, border, size),
        }
        is_any_nan(border)
    }
}

/// One loop from slices to slices. They are parameters because only then does the compiler know that they do
/// not overlap.
#[inline(always)]
fn each(f: &impl AtPoint<2, 3>, omega: &[f64], alpha: &[f64], a: &mut [f64], b: &mut [f64], c: &mut [f64]) {
    let outputs = a.iter_mut().zip(b).zip(c);
    for ((&omega, &alpha), ((a, b), c)) in omega.iter().zip(alpha).zip(outputs) {
        [*a, *b, *c] = f.at([omega, alpha]);
    }
}

/// Whether any number is NaN: one NaN makes a sum NaN. Sixteen sums allow vector instructions.
#[inline(always)]
pub(crate) fn is_any_nan(numbers: &[f64]) -> bool {
    let mut sums = [0.0; 16];
    for numbers in numbers.as_chunks::<16>().0 {
        for (sum, number) in sums.iter_mut().zip(numbers) {
            *sum += number;
        }
    }
    let mut total = 0.0;
    for sum in sums {
        total += sum;
    }
    total.is_nan()
}

/// Buffers for those of the three outputs that are not requested.
pub(crate) struct Rooms([Vec<f64>; 3]);

impl Rooms {
    pub(crate) fn new(out: &Looped<'_>) -> Self {
        let [a, b, c, ..] = out.numbers.each_ref();
        Self([a, b, c].map(|slice| vec![0.0; if slice.is_some() { 0 } else { STRETCH }]))
    }

    /// Computes the whole blocks from `start` on, up to the limit of one call, and sets aside the points
    /// below Ω = 1/2. Returns the number of points.
    pub(crate) fn stretch(
        &mut self,
        kernel: &Kernel<'_>,
        level: Level,
        [omega, alpha]: [&[f64]; 2],
        start: usize,
        out: &mut Looped<'_>,
        low: &mut Places,
    ) -> usize {
        let left = omega.len().saturating_sub(start);
        let n = STRETCH.min(left - left % POINTS);
        let part = start..start + n;
        let [omega, alpha] = [omega, alpha].map(|slice| slice.get(part.clone()).unwrap_or_default());
        let mut slices = out.numbers.iter_mut().zip(&mut self.0).map(|(slice, room)| match slice {
            Some(slice) => slice.get_mut(part.clone()).unwrap_or_default(),
            None => room.get_mut(..n).unwrap_or_default(),
        });
        let mut columns: [&mut [f64]; 3] = core::array::from_fn(|_| slices.next().unwrap_or_default());
        if level.run(Pass { row: kernel.row(), omega, alpha, out: columns.each_mut().map(|c| &mut **c) }) {
            for (i, (&omega, &alpha)) in omega.iter().zip(alpha).enumerate() {
                if !columns[BORDER].get(i).is_some_and(|mark| mark.is_nan()) {
                    continue;
                }
                if kernel.has_low(omega) {
                    low.push(start + i);
                    continue;
                }
                let found = alone::amplitude(Ratios::new(kernel.omega(omega), alpha).ok());
                for (column, value) in columns.iter_mut().zip(found) {
                    if let Some(slot) = column.get_mut(i) {
                        *slot = value;
                    }
                }
            }
        }
        let regimes = out.regime.as_mut().and_then(|slice| slice.get_mut(part));
        kernel.regimes(regimes, omega, alpha, columns[BORDER]);
        n
    }
}
