//! The greatest absolute value of a smooth function on an interval, and the place of a single maximum.

use crate::float::Float;
use alloc::collections::BinaryHeap;
use core::cmp::Ordering;

/// A value and its first two derivatives.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Jet<F> {
    pub(crate) value: F,
    pub(crate) slope: F,
    pub(crate) second: F,
}

impl<F: Float> Jet<F> {
    /// A bound of the absolute value within `radius`, given that `second` bounds the second derivative there.
    pub(crate) fn reach(&self, radius: F) -> F {
        self.value.abs() + radius * (self.slope.abs() + radius * self.second.abs() / F::int(2))
    }
}

/// Bounds of a function on a piece of an interval.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bound<F> {
    /// A bound of the second derivative.
    pub(crate) curvature: F,
    /// A bound of the function itself; infinite where none is known.
    pub(crate) value: F,
}

/// A piece of the interval, with the function at its middle and a bound of its absolute value.
struct Bounded<F> {
    low: F,
    high: F,
    middle: F,
    at: Jet<F>,
    reach: F,
    rest: F,
}

impl<F: Float> Bounded<F> {
    fn new(low: F, high: F, bound: &impl Fn(F, F) -> Bound<F>, f: &impl Fn(F) -> Jet<F>) -> Self {
        let (half, middle, Bound { curvature, value }) =
            (F::ratio(1, 2), low + (high - low) / F::int(2), bound(low, high));
        let (at, radius) = (f(middle), (high - low) * half);
        let near = Jet { second: curvature, ..at }.reach(radius);
        Self {
            low,
            high,
            middle,
            at,
            reach: if near < value { near } else { value },
            rest: curvature * radius.square() * half,
        }
    }
}

/// Pieces are ordered by the greatest value that they may contain.
impl<F: Float> Ord for Bounded<F> {
    fn cmp(&self, other: &Self) -> Ordering {
        self.reach.partial_cmp(&other.reach).unwrap_or(Ordering::Equal)
    }
}

impl<F: Float> PartialOrd for Bounded<F> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<F: Float> PartialEq for Bounded<F> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl<F: Float> Eq for Bounded<F> {}

/// The number of pieces of an interval before any is discarded.
const PIECES: i32 = 16;

/// The greatest number of pieces. A smooth function that has few oscillations in the interval takes some hundred.
const MOST: u32 = 1 << 20;

/// Whether a greatest value is that of a search that stopped at its bound.
pub(crate) fn is_unknown<F: Float>(greatest: F) -> bool {
    greatest.partial_cmp(&greatest).is_none()
}

/// The greater of `best` and the greatest |f| on `[low, high]`; `bound` gives bounds of f on a piece.
///
/// This is branch and bound, with the most promising piece first. On a piece of half width d about c, |f| is
/// at most `|f(c)| + |f′(c)| d + curvature d²/2`; the piece is discarded where that does not exceed the best
/// value so far. On a piece so narrow that f″ is nearly the same at its ends and its middle, Newton's method on f′ starts from
/// its middle.
///
/// NaN where 2²⁰ pieces do not suffice: for a function with very many oscillations of nearly one height.
pub(crate) fn greatest<F: Float>(
    low: F,
    high: F,
    best: F,
    bound: impl Fn(F, F) -> Bound<F>,
    f: impl Fn(F) -> Jet<F>,
) -> F {
    if is_unknown(best) {
        // Another part of the interval has no answer.
        return best;
    }
    let width = (high - low) / F::int(PIECES);
    let mut best = best.or_larger(f(low).value.abs()).or_larger(f(high).value.abs());
    let mut pieces: BinaryHeap<Bounded<F>> = (0..PIECES)
        .map(|i| Bounded::new(low + width * F::int(i), low + width * F::int(i.saturating_add(1)), &bound, &f))
        .collect();
    let slack = F::int(1) + F::int(4) * F::epsilon();
    let mut count = 0u32;
    while let Some(Bounded { low, high, middle, at, reach, rest }) = pieces.pop() {
        best = best.or_larger(at.value.abs());
        count = count.saturating_add(1);
        if count > MOST {
            return F::int(0) / F::int(0);
        }
        if !reach.is_finite() {
            // The bound is NaN or overflows, and further division would not help.
            return F::int(1) / F::int(0);
        }
        if reach <= best * slack {
            break;
        }
        // A peak may be far narrower than its height tells, beside an end where f hardly moves: f″ decides.
        let ends = (rest * F::int(1 << 20) <= best).then(|| [f(low), f(high)]);
        for end in ends.iter().flatten() {
            best = best.or_larger(end.value.abs());
        }
        let is_like_middle = |end: &Jet<F>| (end.second - at.second).abs() * F::int(4) <= at.second.abs();
        if ends.is_some_and(|ends| ends.iter().all(is_like_middle)) {
            // Its stationary point, if it has one.
            let mut x = middle;
            for _ in 0..F::precision().ilog2() {
                let at = f(x);
                let next = x - at.slope / at.second;
                // A step may leave the piece on the way to a point near its end.
                let next = if next < low {
                    low
                } else if next > high {
                    high
                } else {
                    next
                };
                if next == x || !next.is_finite() {
                    break;
                }
                x = next;
            }
            best = best.or_larger(f(x).value.abs());
        } else if middle > low && middle < high {
            pieces.push(Bounded::new(low, middle, &bound, &f));
            pieces.push(Bounded::new(middle, high, &bound, &f));
        }
    }
    best
}

/// The place of the greatest value of f between two places, by golden-section search, to the part `share` of it;
/// f has one maximum there, and ends the search by its error.
pub(crate) fn highest<F: Float, E>(
    low: F,
    high: F,
    share: F,
    mut f: impl FnMut(F) -> Result<F, E>,
) -> Result<F, E> {
    let part = (F::int(5).sqrt() - F::int(1)) / F::int(2);
    let (mut low, mut high) = (low, high);
    let mut left = high - part * (high - low);
    let mut right = low + part * (high - low);
    let (mut at_left, mut at_right) = (f(left)?, f(right)?);
    for _ in 0..F::precision() {
        if high - low <= share * high {
            break;
        }
        if at_left >= at_right {
            (high, right, at_right) = (right, left, at_left);
            left = high - part * (high - low);
            at_left = f(left)?;
        } else {
            (low, left, at_left) = (left, right, at_right);
            right = low + part * (high - low);
            at_right = f(right)?;
        }
    }
    Ok(if at_left >= at_right { left } else { right })
}

#[cfg(test)]
mod tests {
    use super::{Bound, Jet, greatest};

    fn known(curvature: f64) -> impl Fn(f64, f64) -> Bound<f64> {
        move |_, _| Bound { curvature, value: f64::INFINITY }
    }

    #[test]
    fn the_greatest_of_two_waves_is_found() {
        // |sin 40t + 0.3 cos 3t| on [0, 7]: the greatest of about ninety crests.
        let f = |t: f64| Jet {
            value: (40.0 * t).sin() + 0.3 * (3.0 * t).cos(),
            slope: 40.0 * (40.0 * t).cos() - 0.9 * (3.0 * t).sin(),
            second: -1600.0 * (40.0 * t).sin() - 2.7 * (3.0 * t).cos(),
        };
        let found = greatest(0.0, 7.0, 0.0, known(1603.0), f);
        let sampled = (0..7_000_000).map(|i| f(f64::from(i) * 1e-6).value.abs()).fold(0.0, f64::max);
        assert!(found >= sampled && found < sampled + 1e-8, "{found} {sampled}");
        assert_eq!(greatest(0.0, 1.0, 5.0, known(1603.0), f), 5.0);
    }

    /// Waves of 10⁻⁸ of the height: pieces too low to tell them apart hold several.
    #[test]
    fn waves_far_lower_than_the_value_are_told_apart() {
        let f = |t: f64| {
            let ((sine, cosine), size) = ((1000.0 * t).sin_cos(), 1e-8 * (1.0 + t));
            Jet {
                value: 1.0 + size * sine,
                slope: 1e-8 * sine + 1000.0 * size * cosine,
                second: 2e-5 * cosine - 1e6 * size * sine,
            }
        };
        let found = greatest(0.0, 1.0, 0.0, known(0.021), f);
        // The last crest is at t = 317.5 π/1000 = 0.9975.
        let sampled = (0..1_000_000).map(|i| f(f64::from(i) * 1e-6).value).fold(0.0, f64::max);
        assert!(found >= sampled && found < sampled + 1e-14, "{found} {sampled}");
    }

    #[test]
    fn oscillations_of_one_height_are_not_searched_for_ever() {
        // Their crests differ by less than a bound of the curvature can tell.
        let f = |t: f64| Jet { value: t.sin(), slope: t.cos(), second: -t.sin() };
        let found = greatest(
            0.0,
            1e9,
            0.0,
            |_, _| Bound { curvature: 1.0, value: f64::INFINITY },
            |t| Jet { value: f(t).value + 1e-9 * (1e-9 * t).sin(), ..f(t) },
        );
        assert!(found.is_nan(), "{found}");
    }

    #[test]
    fn an_end_may_be_the_greatest() {
        let line = |t: f64| Jet { value: 2.0 - t, slope: -1.0, second: 0.0 };
        assert_eq!(greatest(0.0, 5.0, 0.0, known(1e-9), line), 3.0);
        assert_eq!(greatest(0.0, 1.0, 0.0, known(1e-9), line), 2.0);
    }
}
