//! The greatest absolute value of a smooth function on an interval.

use crate::float::Float;

/// A value and its first two derivatives.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Jet<F> {
    pub(crate) value: F,
    pub(crate) slope: F,
    pub(crate) second: F,
}

/// Pieces that an interval is cut into before any is left out.
const PIECES: i32 = 16;

/// The greater of `best` and the greatest |f| on `[low, high]`, where `|f″| ≤ curvature`.
///
/// By bisection: a piece of half width d about c holds nothing above `|f(c)| + |f′(c)| d + curvature d²/2`, and is left out
/// where that is no more than the best so far. Pieces narrow enough for it are left to Newton's method on f′, from their middle.
pub(crate) fn greatest<F: Float>(low: F, high: F, best: F, curvature: F, f: impl Fn(F) -> Jet<F>) -> F {
    let (two, half) = (F::int(2), F::ratio(1, 2));
    let width = (high - low) / F::int(PIECES);
    let mut best = best.or_larger(f(low).value.abs()).or_larger(f(high).value.abs());
    let mut pieces: Vec<(F, F)> = (0..PIECES)
        .map(|i| (low + width * F::int(i), low + width * F::ratio(i.saturating_mul(2).saturating_add(2), 2)))
        .collect();
    let slack = F::int(1) + F::int(4) * F::epsilon();
    while let Some((a, b)) = pieces.pop() {
        let (middle, radius) = ((a + b) * half, (b - a) * half);
        let at = f(middle);
        let rest = curvature * radius.square() * half;
        best = best.or_larger(at.value.abs());
        if at.value.abs() + at.slope.abs() * radius + rest <= best * slack {
            continue;
        }
        // So narrow that f″ hardly changes: its stationary point, if it has one.
        if rest * F::int(1 << 20) <= best {
            let mut x = middle;
            for _ in 0..F::PRECISION.ilog2() {
                let at = f(x);
                let next = x - at.slope / at.second;
                if !(next > a && next < b) {
                    break;
                }
                x = next;
            }
            best = best.or_larger(f(x).value.abs());
            continue;
        }
        if radius <= F::epsilon() * (a.abs() + b.abs()) / two {
            continue;
        }
        pieces.push((a, middle));
        pieces.push((middle, b));
    }
    best
}

#[cfg(test)]
mod tests {
    use super::{Jet, greatest};

    #[test]
    fn the_greatest_of_two_waves_is_found() {
        // |sin 40t + 0.3 cos 3t| on [0, 7]: some crest among ninety.
        let f = |t: f64| Jet {
            value: (40.0 * t).sin() + 0.3 * (3.0 * t).cos(),
            slope: 40.0 * (40.0 * t).cos() - 0.9 * (3.0 * t).sin(),
            second: -1600.0 * (40.0 * t).sin() - 2.7 * (3.0 * t).cos(),
        };
        let found = greatest(0.0, 7.0, 0.0, 1603.0, f);
        let sampled = (0..7_000_000).map(|i| f(f64::from(i) * 1e-6).value.abs()).fold(0.0, f64::max);
        assert!(found >= sampled && found < sampled + 1e-8, "{found} {sampled}");
        assert_eq!(greatest(0.0, 1.0, 5.0, 1603.0, f), 5.0);
    }

    #[test]
    fn an_end_may_be_the_greatest() {
        let line = |t: f64| Jet { value: 2.0 - t, slope: -1.0, second: 0.0 };
        assert_eq!(greatest(0.0, 5.0, 0.0, 1e-9, line), 3.0);
        assert_eq!(greatest(0.0, 1.0, 0.0, 1e-9, line), 2.0);
    }
}
