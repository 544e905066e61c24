//! Which outputs a batch has, and where they go.

use crate::output::Output;
use crate::ratios::Ratios;
use crate::regime::Regime;
use crate::response::Response;

/// Slices that do not belong together: their lengths differ.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("{name} has {found} elements where {expected} are due")]
#[non_exhaustive]
pub struct LengthMismatch {
    /// The name of the slice: that of an output, `alpha` or `regime`.
    pub name: &'static str,
    /// Its length.
    pub found: usize,
    /// The length of the first slice.
    pub expected: usize,
}

/// `Err` where a slice of length `found` is not as long as the first.
pub(super) const fn same_length(
    expected: usize,
    name: &'static str,
    found: usize,
) -> Result<(), LengthMismatch> {
    if found == expected { Ok(()) } else { Err(LengthMismatch { name, found, expected }) }
}

/// The outputs a batch is asked for, each with the slice it is written to: any of [`Output::ALL`], and the
/// regime.
///
/// ```
/// use stickslip::batch::{Batch, Columns};
/// use stickslip::{Output, Regime};
/// let (mut border, mut regime) = ([0.0; 2], [None; 2]);
/// let columns = Columns::new().with(Output::MinForceRatio, &mut border).with_regime(&mut regime);
/// Batch::new().run(&[0.4, 1.5], &[6.0, 2.5], columns)?;
/// assert_eq!(regime, [Some(Regime::Sticking), Some(Regime::NonSticking)]);
/// # Ok::<(), stickslip::batch::LengthMismatch>(())
/// ```
#[derive(Debug, Default)]
#[must_use]
pub struct Columns<'a>(Slices<'a, { Output::ALL.len() }>);

/// Slices of one length, of the outputs that are wanted.
#[derive(Debug)]
pub(super) struct Slices<'a, const N: usize> {
    pub(super) numbers: [Option<&'a mut [f64]>; N],
    pub(super) regime: Option<&'a mut [Option<Regime>]>,
}

/// The outputs that the loops have, in their order.
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
/// The place of α_min among [`LOOPED`].
pub(super) const BORDER: usize = 1;
/// Where the loops write.
pub(super) type Looped<'a> = Slices<'a, { LOOPED.len() }>;

impl<'a> Columns<'a> {
    /// No output as yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// With an output, NaN where it does not exist. Of two slices for one output the last counts.
    pub fn with(mut self, output: Output, slice: &'a mut [f64]) -> Self {
        for (place, own) in self.0.numbers.iter_mut().zip(Output::ALL) {
            if own == output {
                *place = Some(slice);
                break;
            }
        }
        self
    }

    /// With the body's motion in the long run ([`crate::Regime`]); `None` where a ratio is outside its
    /// domain.
    pub fn with_regime(mut self, slice: &'a mut [Option<Regime>]) -> Self {
        self.0.regime = Some(slice);
        self
    }

    /// The slices, where all are of length `n`.
    pub(super) fn of_length(self, n: usize) -> Result<Slices<'a, { Output::ALL.len() }>, LengthMismatch> {
        for (slice, output) in self.0.numbers.iter().zip(Output::ALL) {
            slice.as_ref().map_or(Ok(()), |slice| same_length(n, output.name(), slice.len()))?;
        }
        self.0.regime.as_ref().map_or(Ok(()), |slice| same_length(n, "regime", slice.len()))?;
        Ok(self.0)
    }
}

impl<'a> Slices<'a, { Output::ALL.len() }> {
    /// Those that the loops fill; what is left here takes more than a loop.
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

    /// The answer of a point alone to its place; NaN without ratios.
    pub(super) fn put(&mut self, place: usize, ratios: Option<Ratios<f64>>) {
        let answer = ratios.map(Response::new);
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

    /// Whether one of these outputs is wanted, by its place.
    pub(super) fn has(&self, places: core::ops::Range<usize>) -> bool {
        self.numbers.get(places).is_some_and(|slices| slices.iter().any(Option::is_some))
    }

    /// The parts before and from `place` on.
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
