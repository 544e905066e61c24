//! The requested outputs of a batch, and the loops that compute them.

use super::alone;
use super::amplitude::Point;
use super::block::{Block, POINTS, each, set};
use super::columns::{BORDER, LOOPED, Looped};
use super::fixed::{FixedOmega, OfOmega, Row};
use super::level::Level;
use super::low::{LowOmega, has_low_loops};
use super::stages::{Answer, HighParts, LowParts, Stages, Work};
use super::velocity::Parts;
use crate::cycle::regime::{Regime, regime_of};
use crate::machine::ratios::Ratios;

/// The requested outputs as functions of Ω and α, or of α in a row of one Ω.
#[derive(Clone, Copy)]
pub(crate) struct Kernel<'a> {
    pub(crate) stages: Stages,
    row: Option<&'a FixedOmega>,
}

impl<'a> Kernel<'a> {
    pub(crate) fn new(wanted: &Looped<'_>, row: Option<&'a FixedOmega>) -> Self {
        Self { stages: Stages::of(wanted), row }
    }

    /// The level to run at: point by point where no loops cover the row.
    pub(crate) fn level(&self, level: Level) -> Level {
        let is_reached = self.row.is_none_or(|row| self.stages.is_amplitude() || row.has_loops());
        if is_reached { level } else { Level::Scalar }
    }

    /// Computes the outputs over a block.
    #[inline(always)]
    pub(crate) fn pass(&self, omega: &Block, alpha: &Block, scratch: &mut Scratch) {
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

    /// Computes the outputs over a block of points below Ω = 1/2.
    #[inline(always)]
    pub(crate) fn pass_low(&self, omega: &Block, alpha: &Block, scratch: &mut Scratch) {
        let Scratch { low, work, answer, .. } = scratch;
        each(&LowOmega, [omega], low.each_mut());
        self.stages.low(omega, alpha, low, work, answer);
    }

    /// Whether [`Kernel::pass_low`] may compute an Ω that [`Kernel::pass`] cannot.
    pub(crate) fn has_low(&self, omega: f64) -> bool {
        self.row.is_none() && has_low_loops(omega)
    }

    /// The Ω of a point, given its value in the slice of Ω.
    pub(crate) fn omega(&self, given: f64) -> f64 {
        self.row.map_or(given, FixedOmega::omega)
    }

    pub(crate) const fn row(&self) -> Option<&'a FixedOmega> {
        self.row
    }

    /// Writes the regimes, if requested, from the borders; where the border is NaN there is no regime.
    pub(crate) fn regimes(
        &self,
        slots: Option<&mut [Option<Regime>]>,
        omega: &[f64],
        alpha: &[f64],
        borders: &[f64],
    ) {
        let points = omega.iter().zip(alpha).zip(borders);
        for (slot, ((&omega, &alpha), &border)) in slots.into_iter().flatten().zip(points) {
            let ratios = Ratios::of_valid(self.omega(omega), alpha, 0.0, 1.0);
            *slot = (!border.is_nan()).then(|| regime_of(ratios, border));
        }
    }
}

/// Blocks local to a thread, so that the compiler knows that no two of them overlap.
pub(crate) struct Scratch {
    pub(crate) high: HighParts,
    pub(crate) low: LowParts,
    pub(crate) work: Work,
    pub(crate) answer: Answer,
}

impl Scratch {
    pub(crate) const fn new() -> Self {
        let block = [0.0; POINTS];
        Self { high: [block; 5], low: [block; 6], work: [block; 3], answer: [block; LOOPED.len()] }
    }

    /// Recomputes the points whose α_min is NaN, except for those for which `set_aside` returns true, given
    /// the place in the block and Ω.
    pub(crate) fn redo(
        &mut self,
        kernel: &Kernel<'_>,
        omega: &[f64],
        alpha: &[f64],
        mut set_aside: impl FnMut(usize, f64) -> bool,
    ) {
        for (i, (&omega, &alpha)) in omega.iter().zip(alpha).enumerate() {
            let is_left = self.answer[BORDER].get(i).is_some_and(|mark| mark.is_nan());
            if is_left && !set_aside(i, omega) {
                let omega = kernel.omega(omega);
                if kernel.stages.is_amplitude() {
                    set(&mut self.answer, i, alone::amplitude(Ratios::new(omega, alpha).ok()));
                } else {
                    set(&mut self.answer, i, alone::all(Ratios::new(omega, alpha).ok()));
                }
            }
        }
    }
}
