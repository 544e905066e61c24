//! The numbers by which a record is followed: floats, whose signs are certain, and balls, whose signs may not be.

use crate::float::{Float, Signed};
use crate::root::halley_within;

/// A number with a sign, which may be uncertain, and what a record asks of it.
pub(super) trait Number: Signed {
    /// More terms than a series that converges as eˣ at x = 4 needs.
    const MOST_TERMS: i32;
    /// Whether this number is at most `reach`, to which a series serves.
    fn is_within(self, reach: Self) -> Option<bool>;
    /// This number, widened by the error of a series.
    fn widened(self, error: Self) -> Self;
    /// Whether a term of a series, in which the first is of size 1, is lost in rounding.
    fn is_negligible(term: Self) -> bool;
    /// Whether this number is within the rounding of a sum of numbers of this size, each known to 64 units in its last
    /// place. The sign of a ball is certain, so that none is.
    fn is_lost(self, size: Self) -> bool;
    /// Whether two loads without a jump between them are the same.
    fn is_same(self, other: Self) -> bool;
    /// The zero in `[low, high]` of a function that is positive at `low`, negative at `high` and has no other
    /// zero between them; `f` gives the value and three derivatives, `ends` the values at both ends, and `longest` is
    /// that of [`halley_within`].
    fn zero_within(
        between: [Self; 2],
        longest: Option<Self>,
        ends: [[Self; 2]; 2],
        f: impl Fn(Self) -> Option<[Self; 4]>,
    ) -> Option<Self>;
    /// The number n, which is exact up to 2⁵³.
    fn count(n: usize) -> Self;
    /// n for `n ≤ self < n + 1`, if it is below 2³¹.
    fn whole(self) -> Option<i32>;
}

/// The zero between two times of the parabola through a value and a derivative at the first and a value at the second,
/// improved by the cubic through the derivative at the second, too.
#[inline(always)]
pub(super) fn first_guess<F: Float>(
    [low, high]: [F; 2],
    [[value, slope], [end, end_slope]]: [[F; 2]; 2],
) -> F {
    let (one, two, length) = (F::int(1), F::int(2), high - low);
    let (first, last) = (slope * length, end_slope * length);
    let bend = end - value - first;
    let part = two * value / ((first.square() - two * two * bend * value).sqrt() - first);
    let cubic = last - first - two * bend;
    let there = part.square() * (part - one) * cubic;
    let steepness = first + two * bend * part + part * (F::int(3) * part - two) * cubic;
    low + length * (part - there / steepness)
}

impl<F: Float> Number for F {
    #[expect(clippy::cast_possible_wrap, reason = "bits of a type are far below i32::MAX")]
    const MOST_TERMS: i32 = 40 + F::PRECISION as i32;

    #[inline(always)]
    fn is_within(self, reach: Self) -> Option<bool> {
        (reach - self).negative().map(|is_beyond| !is_beyond)
    }

    #[inline(always)]
    fn widened(self, _: Self) -> Self {
        self
    }

    fn is_negligible(term: Self) -> bool {
        term.abs() < F::epsilon() * F::ratio(1, 64)
    }

    fn is_lost(self, size: Self) -> bool {
        self <= size * F::epsilon() * F::int(64)
    }

    #[inline(always)]
    fn is_same(self, other: Self) -> bool {
        self == other
    }

    #[inline(always)]
    fn zero_within(
        between: [Self; 2],
        longest: Option<Self>,
        ends: [[Self; 2]; 2],
        f: impl Fn(Self) -> Option<[Self; 4]>,
    ) -> Option<Self> {
        let nan = F::int(0) / F::int(0);
        let of = |t| f(t).unwrap_or([nan; 4]);
        let root = halley_within(first_guess(between, ends), between, longest, of);
        Some(root.implicit_root(|t| {
            let [value, slope, ..] = of(t);
            (value, slope)
        }))
    }

    fn count(n: usize) -> Self {
        #[expect(clippy::cast_precision_loss, reason = "counts of samples are far below 2⁵³")]
        F::from_f64(n as f64)
    }

    fn whole(self) -> Option<i32> {
        let whole = self.floor().to_f64();
        #[expect(clippy::cast_possible_truncation, reason = "the value is within the type")]
        (whole >= 0.0 && whole < f64::from(i32::MAX)).then_some(whole as i32)
    }
}
