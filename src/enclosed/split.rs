//! A box of intervals cut into parts: the hull of the answers over the parts is narrower than the answer over the whole.

use super::Regime;
use super::enclosure::Enclosure;
use super::widen::Answers;
use crate::machine::error::Error;
use crate::output::Output;
use rug::Rational;

/// An interval of rational numbers, from low to high.
pub(crate) type Ends = (Rational, Rational);

/// The parameter with the relatively widest interval; `None` where all are known exactly.
pub(crate) fn widest(part: &[Ends]) -> Option<usize> {
    let width = |(low, high): &Ends| {
        let size = Rational::from(low + high);
        if size == 0 { size } else { Rational::from(high - low) / size }
    };
    let (side, width) = part.iter().map(width).enumerate().max_by(|(_, a), (_, b)| a.cmp(b))?;
    (width > 0).then_some(side)
}

/// The part cut in two across one of its sides.
pub(crate) fn halves(part: &[Ends], side: usize) -> [Vec<Ends>; 2] {
    let cut = |is_upper: bool| {
        let end = |(index, (low, high)): (usize, &Ends)| {
            let middle = || Rational::from(low + high) / 2u32;
            match (index == side, is_upper) {
                (false, _) => (low.clone(), high.clone()),
                (true, false) => (low.clone(), middle()),
                (true, true) => (middle(), high.clone()),
            }
        };
        part.iter().enumerate().map(end).collect()
    };
    [cut(false), cut(true)]
}

/// The work on a box with one interval, in evaluations of the border; with more it is twice that.
const MOST: u32 = 256;
/// The work of a cut of a part that has a regime: the peaks of the cycle take searches.
const WITH_PEAKS: u32 = 4;

/// The weight of a parameter without an effect on any output: where the whole box has no answer, its share is unknown.
const LEAST_WEIGHT: f64 = 1.0 / 64.0;

/// A part of the box with its answers.
struct Part {
    sides: Vec<Ends>,
    regime: Option<Regime>,
    is_decided: bool,
    bits: u32,
    /// Each output where it has an enclosure.
    ends: Vec<(Output, Ends)>,
}

impl Part {
    /// The answers over a part; what holds over the part that it was cut from holds here, too.
    fn new(sides: Vec<Ends>, found: &Answers, from: Option<&Self>) -> Self {
        let own = found.values.iter().filter_map(|(output, value)| Some((*output, value.ends()?)));
        let mut ends: Vec<_> = from.map(|from| from.ends.clone()).unwrap_or_default();
        for (output, (low, high)) in own {
            match ends.iter_mut().find(|(name, _)| *name == output) {
                None => ends.push((output, (low, high))),
                // A phase may be another by a turn.
                Some((_, before)) if low > before.1 || high < before.0 => {}
                Some((_, before)) => {
                    before.0 = low.max(before.0.clone());
                    before.1 = high.min(before.1.clone());
                }
            }
        }
        let regime = from.and_then(|from| from.regime).or(found.regime);
        Self { sides, regime, is_decided: found.is_decided, bits: found.bits, ends }
    }

    fn of(&self, output: Output) -> Option<&Ends> {
        self.ends.iter().find(|(name, _)| *name == output).map(|(_, ends)| ends)
    }
}

/// The answers over a box: the hull of those over its parts. `over` gives the answers over a part; of those that take a search
/// it need not give the outputs that it is told are done.
///
/// An output is done once its hull is at most 5/4 of the range that it certainly has, from the greatest of the lower ends to the
/// least of the upper ones. The others take turns, and the part at the end that is less certain is cut. The regime is certain where
/// that of each part is the same one, and an output exists where it exists in each part.
pub(super) fn over_parts(
    whole: Vec<Ends>,
    bits: u32,
    over: impl Fn(&[Ends], &[Output]) -> Result<Answers, Error>,
) -> Result<Answers, Error> {
    let answers = over(&whole, &[])?;
    let intervals = whole.iter().filter(|(low, high)| low < high).count();
    if intervals == 0 {
        return Ok(answers);
    }
    let first = Part::new(whole, &answers, None);
    let weights = weights(&first, &over)?;
    let mut parts = vec![first];
    let mut left = MOST.saturating_mul(if intervals > 1 { 2 } else { 1 });
    for turn in 0.. {
        let loose: Vec<_> =
            common(&parts).filter_map(|output| Some((output, loosest(&parts, output, bits)?))).collect();
        let Some(index) = next(&parts, turn, &loose).filter(|_| left > 0) else { break };
        let Some(side) = parts.get(index).and_then(|part| heaviest(&part.sides, &weights)) else { break };
        let is_loose = |output: &Output| loose.iter().any(|(name, _)| name == output);
        let done: Vec<_> = common(&parts).filter(|output| !is_loose(output)).collect();
        let part = parts.swap_remove(index);
        left = left.saturating_sub(if part.regime.is_some() { WITH_PEAKS } else { 1 });
        for half in halves(&part.sides, side) {
            let found = over(&half, &done)?;
            parts.push(Part::new(half, &found, Some(&part)));
        }
    }
    Ok(if parts.len() == 1 { answers } else { joined(&parts, answers, bits) })
}

/// The outputs that every part has.
fn common(parts: &[Part]) -> impl Iterator<Item = Output> {
    let first = parts.first().into_iter().flat_map(|part| &part.ends).map(|(output, _)| *output);
    first.filter(|output| parts.iter().all(|part| part.of(*output).is_some()))
}

/// The part of the widths of the outputs for which each parameter is responsible, over the width of its interval; 0 for an exact one.
fn weights(
    whole: &Part,
    over: &impl Fn(&[Ends], &[Output]) -> Result<Answers, Error>,
) -> Result<Vec<f64>, Error> {
    let of = |(side, (low, high)): (usize, &Ends)| {
        if low == high {
            return Ok(0.0);
        }
        let mut thin = whole.sides.clone();
        if let Some(ends) = thin.get_mut(side) {
            let middle = Rational::from(low + high) / 2u32;
            *ends = (middle.clone(), middle);
        }
        let thin = Part::new(thin.clone(), &over(&thin, &[])?, None);
        let width = |(low, high): &Ends| Rational::from(high - low).to_f64();
        let share = |(output, ends): &(Output, Ends)| Some(1.0 - width(thin.of(*output)?) / width(ends));
        let shares = whole.ends.iter().filter_map(share).filter(|share| *share > 0.0);
        Ok((shares.sum::<f64>() + LEAST_WEIGHT) / width(&(low.clone(), high.clone())))
    };
    whole.sides.iter().enumerate().map(of).collect()
}

/// The side whose width matters most; `None` where all are known exactly.
fn heaviest(sides: &[Ends], weights: &[f64]) -> Option<usize> {
    let weighed =
        sides.iter().zip(weights).map(|((low, high), weight)| Rational::from(high - low).to_f64() * weight);
    let (side, weight) = weighed.enumerate().max_by(|(_, a), (_, b)| a.total_cmp(b))?;
    (weight > 0.0).then_some(side)
}

/// The part to be cut; `None` where the hulls are close to the ranges, or no cut would help.
fn next(parts: &[Part], turn: usize, loose: &[(Output, usize)]) -> Option<usize> {
    let regimes = || parts.iter().filter_map(|part| part.regime);
    // Where two parts have different regimes, the box has none.
    let is_mixed = regimes().any(|regime| Some(regime) != regimes().next());
    let most = parts.iter().map(|part| part.ends.len()).max()?;
    let is_open = |part: &Part| !part.is_decided || part.ends.len() < most;
    let undecided = parts.iter().position(is_open).filter(|_| !is_mixed);
    let place = turn.checked_rem(loose.len()).and_then(|place| loose.get(place)).map(|(_, index)| *index);
    // Both take turns: a part beside a pole remains undecided.
    if turn & 1 == 0 { undecided.or(place) } else { place.or(undecided) }
}

/// The part whose cut makes the hull of an output narrower; `None` where the hull is close to the range.
fn loosest(parts: &[Part], output: Output, bits: u32) -> Option<usize> {
    let all = || parts.iter().enumerate().filter_map(|(index, part)| Some((index, part.of(output)?)));
    let (lowest, low) = all().map(|(index, (low, _))| (index, low)).min_by_key(|(_, low)| *low)?;
    let (highest, high) = all().map(|(index, (_, high))| (index, high)).max_by_key(|(_, high)| *high)?;
    // The least value is not above the one, nor the greatest below the other.
    let (least, greatest) = (all().map(|(_, (_, high))| high).min()?, all().map(|(_, (low, _))| low).max()?);
    let (below, above) = (Rational::from(least - low), Rational::from(high - greatest));
    let (width, range) = (Rational::from(high - low), Rational::from(greatest - least));
    // Rounding alone.
    let is_sharp = Rational::from(low + high).abs() >= width.clone() << bits;
    (!is_sharp && width * 4u32 > range * 5u32).then_some(if below > above { lowest } else { highest })
}

/// The hull of the parts.
fn joined(parts: &[Part], whole: Answers, bits: u32) -> Answers {
    let regime = parts.first().and_then(|part| part.regime);
    let regime = regime.filter(|_| parts.iter().all(|part| part.regime == regime));
    let hull = |output: Output| {
        let all = || parts.iter().filter_map(|part| part.of(output));
        let (low, high) = (all().map(|(low, _)| low).min()?, all().map(|(_, high)| high).max()?);
        Some((output, Enclosure::between(low, high, bits)))
    };
    let mut joined = whole;
    joined.regime = regime;
    joined.values = common(parts).filter_map(hull).collect();
    joined.bits = parts.iter().map(|part| part.bits).max().unwrap_or(joined.bits);
    joined
}
