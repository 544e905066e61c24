//! Ranges in ball arithmetic: every output over a box of ratios, the rounding of the formulae included.

use super::{Interval, Known, Range, RatioBox};
use crate::enclosed::{self, Enclosure, Regime};
use crate::error::Error;
use crate::float::Float;
use crate::output::Output;
use rug::{Rational, float::Round};

/// Bits of the balls: the boxes make them much wider than rounding does.
const BITS: u32 = 64;

/// An interval of ratios as rational numbers, from low to high.
type Ends = (Rational, Rational);

impl<F: Float> RatioBox<F> {
    /// The range of any output over the box, proved in ball arithmetic: no formula is assumed to be right to so many digits, and no output
    /// to be monotone. `None` where it is undecided whether the output exists in every part of the box.
    ///
    /// The box is cut into `pieces` parts at most, of the same share of Ω and of α, and each is enclosed as [`enclosed::response`] does it.
    /// The range exceeds the sharp one by an amount that shrinks with the parts like 1/√pieces, and like 1/pieces where one ratio is exact. A part takes
    /// about a millisecond, and tens of them for the maximum acceleration below Ω = 1/2. A phase may leave [0, 2π) by as much.
    ///
    /// # Errors
    /// Where a ratio is outside the domain of [`crate::Ratios`].
    ///
    /// ```
    /// use stickslip::Output;
    /// use stickslip::uncertainty::{Interval, RatioBox};
    /// let ratios = RatioBox::new(Interval::between(0.7, 0.72)?, Interval::exactly(2.0))?;
    /// let phase = ratios.enclosed(Output::VelocityPhase, 100)?.unwrap();
    /// assert!(phase.is_guaranteed() && 0.71 < phase.low && phase.high < 0.83);
    /// # Ok::<(), stickslip::Error>(())
    /// ```
    pub fn enclosed(&self, output: Output, pieces: u32) -> Result<Option<Range<F>>, Error> {
        let (Some(omega), Some(alpha)) = (ends(self.omega()), ends(self.alpha())) else { return Ok(None) };
        let is_of_border = !output.is_of_cycle() && output != Output::Margin;
        let (by_omega, by_alpha) = match (omega.0 == omega.1, alpha.0 == alpha.1 || is_of_border) {
            (true, true) => (1, 1),
            (true, false) => (1, pieces.max(1)),
            (false, true) => (pieces.max(1), 1),
            (false, false) => (pieces.max(1).isqrt(), pieces.max(1).isqrt()),
        };
        let mut range: Option<Ends> = None;
        for omega in parts(&omega, by_omega) {
            for alpha in parts(&alpha, by_alpha) {
                let found = enclosed::response_for(output, &omega, &alpha, BITS)?;
                let exists = !output.is_of_cycle() || found.regime() == Some(Regime::NonSticking);
                let Some((low, high)) = found.get(output).filter(|_| exists).and_then(bounds) else {
                    return Ok(None);
                };
                range = Some(match range {
                    None => (low, high),
                    Some(so_far) => (so_far.0.min(low), so_far.1.max(high)),
                });
            }
        }
        let known = Known::Guaranteed { sharp: false };
        Ok(range.map(|(low, high)| Range { low: rounded(&low, -1), high: rounded(&high, 1), known }))
    }
}

/// The ends as rational numbers; a unit in the last place of f64 farther out where an end is no f64.
fn ends<F: Float>(interval: Interval<F>) -> Option<Ends> {
    let (low, high) = (interval.low().to_f64(), interval.high().to_f64());
    let low = if F::from_f64(low) == interval.low() { low } else { low.next_down() };
    let high = if F::from_f64(high) == interval.high() { high } else { high.next_up() };
    Some((Rational::from_f64(low)?, Rational::from_f64(high)?))
}

/// An interval cut into equal parts.
fn parts((low, high): &Ends, count: u32) -> Vec<enclosed::Known> {
    let at = |i: u32| Rational::from(high - low) * Rational::from((i, count)) + low;
    let part = |i: u32| enclosed::Known::of_ends(at(i), at(i.saturating_add(1)));
    (0..count).map(part).collect()
}

/// The ends of an enclosure.
fn bounds(found: &Enclosure) -> Option<Ends> {
    let (mid, rad) = (found.mid().to_rational()?, found.rad().to_rational()?);
    Some((Rational::from(&mid - &rad), mid + rad))
}

/// The nearest number of the type below (−1) or above (1), or one that is a little farther.
fn rounded<F: Float>(x: &Rational, side: i32) -> F {
    let round = if side < 0 { Round::Down } else { Round::Up };
    let bound = rug::Float::with_val_round(53, x, round).0.to_f64();
    let found = F::from_f64(bound);
    // A type with fewer digits has rounded once more.
    let is_inside = if side < 0 { found.to_f64() > bound } else { found.to_f64() < bound };
    if is_inside { found + F::int(side) * F::epsilon() * found.abs() } else { found }
}
