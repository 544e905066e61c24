//! The precision is increased until the answers are sharp or the limit is reached.

use super::{Enclosure, Regime};
use crate::float::ball::{Ball, Radius};
use crate::float::mp::Mp;
use crate::float::words::at_words;
use crate::machine::error::{Error, written};
use crate::output::Output;

/// The greatest number of bits.
pub(super) const GREATEST: u32 = 8256;

/// A computation in balls of any precision.
pub trait InBalls {
    /// The result at one precision.
    type Found;
    /// Runs it in balls of the precision that is set on this thread.
    fn run<const W: usize>(&self) -> Self::Found;
}

/// Runs a computation at one precision after another, in words of 64 bits, until the result of one is accepted; from the
/// first that has 64 bits more than asked for, or the last.
pub fn with_more_bits<C: InBalls, T>(
    precisions: &[u32],
    bits: u32,
    computation: &C,
    mut accepted: impl FnMut(u32, C::Found) -> Option<T>,
) -> Option<T> {
    let enough =
        precisions.iter().filter(|words| 64 * **words >= bits + 64 || Some(*words) == precisions.last());
    enough
        .copied()
        .find_map(|words| accepted(words, at_words!(words, |CAPACITY| computation.run::<CAPACITY>())))
}

/// The precisions of the closed forms.
pub const PRECISIONS: [u32; 5] = [2, 5, 17, 65, 129];

/// The answers at one precision.
#[derive(Debug, Clone)]
pub(super) struct Answers {
    pub(super) regime: Option<Regime>,
    pub(super) values: Vec<(Output, Enclosure)>,
    pub(super) bits: u32,
    /// The number of certain bits of the least certain output.
    sharpness: i64,
    is_exact: bool,
    pub(super) is_decided: bool,
}

impl Answers {
    pub(super) fn new<const W: usize>(
        regime: Option<Regime>,
        values: Vec<(Output, Option<Ball<W>>)>,
        is_exact: bool,
        is_decided: bool,
    ) -> Self {
        let bits = Mp::<W>::bits_now();
        let known = values.iter().filter_map(|(output, ball)| Some((*output, ball.as_ref()?)));
        let sharpness = known.clone().map(|(_, ball)| certain_bits(ball)).min().unwrap_or(0);
        let values = known.filter_map(|(output, ball)| Some((output, Enclosure::of(ball)?))).collect();
        Self { regime, values, bits, sharpness, is_exact, is_decided }
    }

    /// The answers rounded to the requested bits, where they are that sharp.
    fn rounded(mut self, bits: u32) -> Self {
        for (_, value) in &mut self.values {
            *value = value.rounded(bits);
        }
        self
    }
}

/// The number of bits of a ball that its radius leaves certain; all of them for an exact number and for one
/// that is itself tiny.
fn certain_bits<const W: usize>(ball: &Ball<W>) -> i64 {
    let all = i64::from(Mp::<W>::bits_now());
    let size = Radius::below(ball.mid());
    if ball.is_entire() {
        0
    } else if ball.rad().is_zero() {
        all
    } else if size.is_zero() {
        if ball.rad() < Radius::power_of_two(-all) { all } else { 0 }
    } else {
        (size.exponent() - ball.rad().exponent()).clamp(0, all)
    }
}

/// Whether so many bits of a ball are certain, and two more, so that the final rounding leaves one unit in the last place.
pub(super) fn has_bits<const W: usize>(ball: &Ball<W>, bits: u32) -> bool {
    certain_bits(ball) >= least_sharpness(bits)
}

/// With fewer certain bits the intervals are wide beside any rounding at 128 bits.
const WIDE: i64 = 32;

/// Two bits more than requested.
fn least_sharpness(bits: u32) -> i64 {
    i64::from(bits) + 2
}

/// The answers at the requested bits, recomputed with more bits where they are undecided or not sharp enough.
pub(super) fn sharpest(question: &impl InBalls<Found = Answers>, bits: u32) -> Result<Answers, Error> {
    let mut last: Option<Answers> = None;
    let found = with_more_bits(&PRECISIONS, bits, question, |_, found| {
        let is_sharp = found.sharpness >= least_sharpness(bits);
        // With intervals for the ratios, further bits cannot reduce the width that the intervals cause.
        let is_wide = found.is_decided && found.sharpness < WIDE;
        let is_final =
            !found.is_exact && (is_wide || last.as_ref().is_some_and(|l| found.sharpness <= l.sharpness));
        let is_enough = found.is_decided && is_sharp || is_final;
        let found = last.insert(found);
        is_enough.then(|| found.clone())
    });
    // `valid` has made sure that there is such a precision.
    let nothing = Error::OutOfRange {
        quantity: crate::Quantity::Precision,
        value: written(f64::from(bits)),
        least: written(1.0),
        greatest: written(f64::from(GREATEST - 64)),
    };
    found.or(last).map(|found| found.rounded(bits)).ok_or(nothing)
}

#[cfg(test)]
mod tests {
    use super::certain_bits;
    use crate::float::ball::{Ball, Radius};
    use crate::float::mp::Mp;

    #[test]
    fn the_bits_that_the_radius_leaves_are_certain() {
        let all = i64::from(Mp::<2>::BITS);
        let bits = |mid: f64, e: i64| certain_bits(&Ball::<2>::new(Mp::of_f64(mid), Radius::power_of_two(e)));
        // 1 and 2⁻ᵉ are each the least number of their binade.
        assert_eq!([0, -1, -20, -100].map(|e| bits(1.0, e)), [0, 1, 20, 100]);
        assert_eq!([bits(-1.75, -20), bits(3.0, -20), bits(0.25, -20)], [20, 21, 18]);
        assert_eq!((bits(1.0, 5), bits(1.0, -all - 9)), (0, all));
        // A ball around zero has all bits or none.
        assert_eq!([-all - 1, -all, 0].map(|e| bits(0.0, e)), [all, 0, 0]);
        let exact = |x: f64| certain_bits(&Ball::<2>::exact(Mp::of_f64(x)));
        assert_eq!((exact(0.0), exact(0.1), certain_bits(&Ball::<2>::entire())), (all, all, 0));
    }
}
