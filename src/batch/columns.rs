//! The requested outputs of a batch, and the slices that receive them.

use super::block::Block;
use crate::cycle::regime::Regime;
use crate::cycle::response::Response;
use crate::machine::error::Error;
use crate::output::Output;

/// An error unless a slice of length `found` is as long as the first.
pub(super) const fn same_length(expected: usize, name: &'static str, found: usize) -> Result<(), Error> {
    if found == expected { Ok(()) } else { Err(Error::LengthMismatch { name, found, expected }) }
}

/// Slices of one length for the requested outputs.
#[derive(Debug)]
pub(super) struct Slices<'a, const N: usize> {
    pub(super) numbers: [Option<&'a mut [f64]>; N],
    pub(super) regime: Option<&'a mut [Option<Regime>]>,
}

/// The outputs that the loops compute, in their order.
pub(super) const LOOPED: [Output; 9] = [
    Output::MaxDisplacement,
    Output::MinForceRatio,
    Output::LoopSizeStiffness,
    Output::DisplacementPhase,
    Output::LoopSizeInertia,
    Output::MaxVelocity,
    Output::VelocityPhase,
    Output::Deviation,
    Output::Contraction,
];
/// Whether the loops compute an output with a damper and static friction, too: all of `LOOPED` but λ.
#[must_use]
pub fn is_looped_with_damper(output: Output) -> bool {
    output != Output::Contraction && LOOPED.contains(&output)
}

/// The place of α_min among [`LOOPED`].
pub(super) const BORDER: usize = 1;
/// The slices that the loops write to.
pub(super) type Looped<'a> = Slices<'a, { LOOPED.len() }>;

impl<'a> Slices<'a, { Output::ALL.len() }> {
    /// Adds the slice of an output, in place of an earlier one.
    pub(super) fn set(&mut self, output: Output, slice: &'a mut [f64]) {
        for (place, own) in self.numbers.iter_mut().zip(Output::ALL) {
            if own == output {
                *place = Some(slice);
                break;
            }
        }
    }

    /// An error unless all slices have length `n`.
    pub(super) fn of_length(&self, n: usize) -> Result<(), Error> {
        for (slice, output) in self.numbers.iter().zip(Output::ALL) {
            slice.as_ref().map_or(Ok(()), |slice| same_length(n, output.name(), slice.len()))?;
        }
        self.regime.as_ref().map_or(Ok(()), |slice| same_length(n, "regime", slice.len()))
    }

    /// Whether no number is requested that the loops do not compute with a damper.
    pub(super) fn is_looped_with_damper(&self) -> bool {
        let mut columns = self.numbers.iter().zip(Output::ALL);
        columns.all(|(slice, output)| slice.is_none() || is_looped_with_damper(output))
    }

    /// Removes the slices that the loops fill; the others are computed point by point.
    pub(super) fn take_looped(&mut self) -> Looped<'a> {
        let mut looped = Looped { regime: self.regime.take(), ..Looped::default() };
        for (slice, own) in self.numbers.iter_mut().zip(Output::ALL) {
            for (place, output) in looped.numbers.iter_mut().zip(LOOPED) {
                if own == output {
                    *place = slice.take();
                }
            }
        }
        looped
    }

    /// Whether an output that needs the peak velocity is requested.
    pub(super) fn has_velocity(&self) -> bool {
        let mut columns = self.numbers.iter().zip(Output::ALL);
        columns.any(|(slice, output)| slice.is_some() && output.needs_velocity())
    }

    /// Writes the outputs of the point at a place; NaN without an answer.
    pub(super) fn put(&mut self, place: usize, answer: Option<Response<f64>>) {
        for (slice, output) in self.numbers.iter_mut().zip(Output::ALL) {
            if let Some(slot) = slice.as_mut().and_then(|slice| slice.get_mut(place)) {
                *slot = answer.as_ref().and_then(|answer| output.of(answer)).unwrap_or(f64::NAN);
            }
        }
        if let Some(slot) = self.regime.as_mut().and_then(|slice| slice.get_mut(place)) {
            *slot = answer.map(|answer| answer.regime);
        }
    }
}

impl<const N: usize> Default for Slices<'_, N> {
    fn default() -> Self {
        Self { numbers: [const { None }; N], regime: None }
    }
}

impl<const N: usize> Slices<'_, N> {
    pub(super) fn is_empty(&self) -> bool {
        self.regime.is_none() && self.numbers.iter().all(Option::is_none)
    }

    /// Writes the first `n` numbers of each block from `start` on.
    pub(super) fn put_numbers(&mut self, start: usize, n: usize, blocks: &[Block]) {
        for (slice, block) in self.numbers.iter_mut().zip(blocks) {
            let part = slice.as_mut().and_then(|slice| slice.get_mut(start..)?.get_mut(..n));
            if let (Some(part), Some(values)) = (part, block.get(..n)) {
                part.copy_from_slice(values);
            }
        }
    }

    /// Whether any of the outputs at these places is requested.
    pub(super) fn has(&self, places: core::ops::Range<usize>) -> bool {
        self.numbers.get(places).is_some_and(|slices| slices.iter().any(Option::is_some))
    }

    /// The parts before `place` and from it on.
    #[cfg(feature = "rayon")]
    pub(super) fn split_at(self, place: usize) -> (Self, Self) {
        let (mut low, mut high) = (Self::default(), Self::default());
        for ((slice, low), high) in self.numbers.into_iter().zip(&mut low.numbers).zip(&mut high.numbers) {
            (*low, *high) = slice.map(|slice| slice.split_at_mut(place)).unzip();
        }
        (low.regime, high.regime) = self.regime.map(|slice| slice.split_at_mut(place)).unzip();
        (low, high)
    }
}
