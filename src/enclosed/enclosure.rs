//! An enclosure of an output, at the precision at which it was found.

use crate::float::ball::{Ball, Radius, Written, written};
use crate::float::mp::Mp;
use core::fmt;
use rug::float::Round;
use rug::{Float, Rational};

/// All numbers within a radius of a midpoint, one of which is the output.
///
/// [`Display`](core::fmt::Display) prints the digits that are certain to within one unit in the last place,
/// then ± and the radius. Where fewer than three are certain it prints two more, because their rounding would widen the radius.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
#[must_use]
pub struct Enclosure {
    /// The midpoint.
    pub mid: Float,
    /// The radius.
    pub rad: Float,
}

impl Default for Enclosure {
    /// No information: an infinite radius.
    fn default() -> Self {
        Self { mid: Float::new(64), rad: Float::with_val(64, rug::float::Special::Infinity) }
    }
}

impl Enclosure {
    /// The least and the greatest of these numbers.
    pub(crate) fn ends(&self) -> Option<(Rational, Rational)> {
        let (mid, rad) = (self.mid.to_rational()?, self.rad.to_rational()?);
        Some((Rational::from(&mid - &rad), mid + rad))
    }

    /// The numbers between two ends, with a midpoint of `bits` bits.
    pub(super) fn between(low: &Rational, high: &Rational, bits: u32) -> Self {
        let mid = Float::with_val(bits, Rational::from(low + high) / 2u32);
        let exact = mid.to_rational().unwrap_or_default();
        let reach = Rational::from(high - &exact).max(exact - low);
        Self { mid, rad: Float::with_val_round(64, reach, Round::Up).0 }
    }

    /// This enclosure with a midpoint of `bits` bits, and a radius that includes the rounding of the
    /// midpoint.
    pub(crate) fn rounded(&self, bits: u32) -> Self {
        let mid = Float::with_val(bits, &self.mid);
        let moved = Float::with_val_round(64, &mid - &self.mid, Round::AwayZero).0.abs();
        let rad = Float::with_val_round(64, &self.rad + &moved, Round::Up).0;
        // The radius is not smaller than the bits imply: if a decision needed more bits, all further digits
        // would be nines or zeros.
        let least = Float::with_val_round(64, &mid >> (bits + 2), Round::AwayZero).0.abs();
        let rad = if rad.is_zero() { rad } else { rad.max(&least) };
        Self { mid, rad }
    }

    /// Whether the enclosure contains a number of any precision.
    #[must_use]
    pub fn contains(&self, x: &Float) -> bool {
        let (Some((low, high)), Some(x)) = (self.ends(), x.to_rational()) else { return false };
        low <= x && x <= high
    }

    /// Midpoint and radius in decimal, with two digits more than are certain, as in the JSON output.
    #[must_use]
    pub fn decimal(&self) -> (String, String) {
        let Written { mid, rad } = self.written(2);
        (mid, rad)
    }

    fn written(&self, more: u32) -> Written {
        let number = |x: &Float| x.to_rational().unwrap_or_default();
        written(&number(&self.mid), &number(&self.rad), more)
    }
}

// For the programs of this repository.
#[doc(hidden)]
impl Enclosure {
    /// The numbers of a ball; `None` for the whole line.
    #[must_use]
    pub fn of<const W: usize>(ball: &Ball<W>) -> Option<Self> {
        let (mid, rad) = (ball.mid().to_rug(), ball.rad().value::<1>().to_rug());
        (!ball.is_entire() && rad.is_finite()).then_some(Self { mid, rad })
    }

    /// A number of an input, with what reading and converting it can have rounded, to so many bits.
    pub fn read<const N: usize>(x: Mp<N>, bits: u32) -> Self {
        let whole = Ball::<N>::read(x, Radius::above(x));
        Self::of(&whole).unwrap_or_default().rounded(bits)
    }

    /// This enclosure as a ball.
    #[must_use]
    pub fn ball<const W: usize>(&self) -> Ball<W> {
        let mid = Mp::from_rug(&self.mid);
        let rounding = mid.to_rug() - &self.mid;
        let rounding = Radius::above(Mp::<2>::from_rug(&rounding)).scaled(1);
        Ball::new(mid, Radius::above(Mp::<2>::from_rug(&self.rad)).plus(rounding))
    }
}

impl fmt::Display for Enclosure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let is_wide = Float::with_val(64, &self.rad << 10u32) > *self.mid.as_abs();
        let Written { mid, rad } = self.written(if is_wide { 2 } else { 0 });
        f.pad(&format!("{mid} ± {rad}"))
    }
}
