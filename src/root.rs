//! Zeros of functions of one variable: a bracket at f64, then refinement at the precision of the type.

use crate::float::Float;
#[cfg(feature = "std")]
use roots::{SimpleConvergency, find_root_brent};

/// A zero of `f` in `[low, high]`, where it changes sign, by Brent's method at f64.
///
/// Where rounding hides the change of sign, the result is the end at which |f| is smaller: the zero is within
/// rounding of it.
#[cfg(feature = "std")]
pub(crate) fn bracketed(low: f64, high: f64, mut f: impl FnMut(f64) -> f64) -> f64 {
    let mut convergency = SimpleConvergency { eps: 1e-15, max_iter: 200 };
    match find_root_brent(low, high, &mut f, &mut convergency) {
        Ok(x) => x.clamp(low, high),
        Err(_) => {
            if f(low).abs() <= f(high).abs() {
                low
            } else {
                high
            }
        }
    }
}

/// A zero of `f` in `[low, high]`, where it changes sign, by halving the interval down to neighbouring numbers: the crate
/// roots needs the standard library.
#[cfg(not(feature = "std"))]
pub(crate) fn bracketed(low: f64, high: f64, mut f: impl FnMut(f64) -> f64) -> f64 {
    let (mut low, mut high) = (low, high);
    let (start, end) = (f(low), f(high));
    if (start < 0.0) == (end < 0.0) {
        return if start.abs() <= end.abs() { low } else { high };
    }
    loop {
        let middle = low + (high - low) / 2.0;
        if middle <= low || middle >= high {
            return middle;
        }
        if (f(middle) < 0.0) == (start < 0.0) {
            low = middle;
        } else {
            high = middle;
        }
    }
}

/// Newton's method inside `[low, high]` from a `start` accurate to about 1e-8; `f` gives (value, slope).
///
/// Each step doubles the correct bits, so that `log₂(PRECISION)` steps bound the loop. It ends after the step
/// whose square is below rounding, since the remaining error is of that order. Steps are measured relative to
/// the distance from the ends, where a second zero may be near.
pub(crate) fn newton<F: Float>(start: F, low: F, high: F, mut f: impl FnMut(F) -> (F, F)) -> F {
    let tolerance = F::epsilon() / F::int(64);
    let mut x = start;
    for _ in 0..F::precision().ilog2() {
        let (value, slope) = f(x);
        let step = value / slope;
        let next = x - step;
        // A slope of zero gives a step to infinity or NaN, which is outside as well.
        let inside = next > low && next < high;
        if !inside {
            break;
        }
        x = next;
        let (left, right) = (x - low, high - x);
        let room = if left < right { left } else { right };
        if step.square() <= tolerance * x.abs() * room {
            break;
        }
    }
    x
}

/// A zero in `[low, high]` of an `f` that decreases through it; `f` gives (value, slope).
///
/// This is Newton's method with a bracket. Where a step leaves the bracket, or is longer than half of the
/// last step but one, the bracket is halved instead. The number of steps is therefore at most twice the bits
/// between the ends.
pub(crate) fn newton_within<F: Float>(low: F, high: F, f: impl FnMut(F) -> (F, F)) -> F {
    newton_from(low + (high - low) / F::int(2), low, high, f)
}

/// [`newton_within`] from a `start` in `[low, high]`.
pub(crate) fn newton_from<F: Float>(start: F, low: F, high: F, mut f: impl FnMut(F) -> (F, F)) -> F {
    let (mut low, mut high, two) = (low, high, F::int(2));
    let mut x = start;
    let (mut last, mut last_but_one) = (high - low, high - low);
    loop {
        let (value, slope) = f(x);
        if value == F::int(0) {
            return x;
        }
        if value > F::int(0) {
            low = x;
        } else {
            high = x;
        }
        let mut next = x - value / slope;
        let fast = (next - x).abs() * two <= last_but_one;
        let inside = next > low && next < high;
        if !(fast && inside) {
            next = low + (high - low) / two;
            if !(next > low && next < high) {
                return x;
            }
        }
        (last_but_one, last) = (last, (next - x).abs());
        if next == x || last <= F::epsilon() * next.abs() / two {
            return next;
        }
        x = next;
    }
}

/// A zero in `[low, high]` of an `f` that decreases through it; `f` gives the value and three derivatives. The `start`
/// may be outside.
///
/// This is Halley's method with a bracket, halved as in [`newton_within`]. The search ends after the step whose
/// error, `|f‴/(6f′) − (f″/2f′)²|` times its cube, is below rounding. The estimate is not one for a step that is longer than
/// `longest`, over which f‴ changes by much: a search over a decay ended where only the other term of f is left.
pub(crate) fn halley_within<F: Float>(
    start: F,
    [low, high]: [F; 2],
    longest: Option<F>,
    mut f: impl FnMut(F) -> [F; 4],
) -> F {
    let mut search = Halley::new(start, low, high);
    loop {
        let is_found;
        (search, is_found) = search.step(f(search.x), longest);
        if is_found {
            return search.x;
        }
    }
}

/// A place on the way to a zero by Halley's method, in its bracket. Its steps have no branches, so that searches can
/// run in vector lanes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Halley<F> {
    pub(crate) x: F,
    pub(crate) low: F,
    pub(crate) high: F,
    /// The length of the last step, and of the one before.
    pub(crate) last: F,
    pub(crate) last_but_one: F,
}

impl<F: Float> Halley<F> {
    #[cfg(feature = "batch")]
    pub(crate) fn none() -> Self {
        Self::new(F::int(0), F::int(0), F::int(0))
    }

    #[inline(always)]
    pub(crate) fn new(start: F, low: F, high: F) -> Self {
        let is_inside = (start > low) & (start < high);
        let x = if is_inside { start } else { low + (high - low) / F::int(2) };
        Self { x, low, high, last: high - low, last_but_one: high - low }
    }

    /// The next place, given the value and three derivatives at this one, and whether it is the zero; `longest` is that of
    /// [`halley_within`].
    #[inline(always)]
    pub(crate) fn step(self, [value, slope, bend, third]: [F; 4], longest: Option<F>) -> (Self, bool) {
        let (zero, two, x) = (F::int(0), F::int(2), self.x);
        let tolerance = F::epsilon() / two;
        let is_before = value > zero;
        let low = if is_before { x } else { self.low };
        let high = if is_before { self.high } else { x };
        let inverse = F::int(1) / slope;
        let (newton, curve) = (value * inverse, bend * inverse / two);
        let step = newton / (F::int(1) - newton * curve);
        let (next, middle) = (x - step, low + (high - low) / two);
        let size = step.abs();
        let is_good = (size * two <= self.last_but_one) & (next > low) & (next < high);
        let error = step.square() * size * ((third * inverse).abs() / F::int(6) + curve.square());
        // The difference of two places that are far apart has the rounding of the greater.
        let is_trusted = (size <= next.abs()) & longest.is_none_or(|longest| size <= longest);
        let is_exact = is_good & is_trusted & (error <= tolerance * next.abs());
        let stays = (value == zero) | (!is_good & !((middle > low) & (middle < high)));
        let next = if is_good { next } else { middle };
        let next = if stays { x } else { next };
        let last = (next - x).abs();
        let is_found = stays | is_exact | (next == x) | (last <= tolerance * next.abs());
        (Self { x: next, low, high, last, last_but_one: self.last }, is_found)
    }
}

/// The two numbers in `[low, high]`, adjacent except for rounding, between which `f` changes sign: the first
/// on the side of `low`, the second on that of `high`. A zero counts as positive.
///
/// The search runs at the precision of the type throughout, and cannot lose the zero: the bracket only ever
/// shrinks. It uses inverse quadratic interpolation where the last three points promise a monotone one, and
/// halving elsewhere (Chandrupatla's criterion). Where `f` has one sign at both ends there is nothing to
/// enclose, and the end where |f| is smaller is returned twice.
pub(crate) fn enclosed<F: Float>(low: F, high: F, mut f: impl FnMut(F) -> F) -> (F, F) {
    let (zero, one, half) = (F::int(0), F::int(1), F::ratio(1, 2));
    let positive = |y: F| y >= zero;
    // x is the latest point, opposite is the other end of the bracket, and previous is the point before.
    let (mut opposite, mut x) = (low, high);
    let (mut at_opposite, mut y) = (f(low), f(high));
    let ordered = |a: F, b: F| if a < b { (a, b) } else { (b, a) };
    if positive(at_opposite) == positive(y) {
        let end = if at_opposite.abs() <= y.abs() { low } else { high };
        return (end, end);
    }
    let mut share = half;
    // Each halving takes a bit off the bracket; interpolation never takes more than twice as many steps.
    for _ in 0..F::precision().saturating_mul(4) {
        let width = (opposite - x).abs();
        let tolerance = F::epsilon() * x.abs().or_larger(opposite.abs());
        if width <= tolerance {
            break;
        }
        let least = tolerance / (width + width);
        let share_inside = if share < least {
            least
        } else if share > one - least {
            one - least
        } else {
            share
        };
        let next = x + share_inside * (opposite - x);
        if next == x || next == opposite {
            break;
        }
        let at_next = f(next);
        let (previous, at_previous);
        if positive(at_next) == positive(y) {
            (previous, at_previous) = (x, y);
        } else {
            (previous, at_previous) = (opposite, at_opposite);
            (opposite, at_opposite) = (x, y);
        }
        (x, y) = (next, at_next);
        let xi = (x - opposite) / (previous - opposite);
        let phi = (y - at_opposite) / (at_previous - at_opposite);
        let interpolates = phi.square() < xi && (one - phi).square() < one - xi;
        share = if interpolates {
            let at_chord = y / (at_opposite - y) * (at_previous / (at_opposite - at_previous));
            let beyond = (previous - x) / (opposite - x);
            at_chord + beyond * (y / (at_previous - y)) * (at_opposite / (at_previous - at_opposite))
        } else {
            half
        };
    }
    ordered(x, opposite)
}

#[cfg(test)]
mod tests {
    use super::{bracketed, enclosed, newton, newton_within};

    #[test]
    fn the_enclosure_is_two_neighbours() {
        let calls = core::cell::Cell::new(0);
        let f = |x: f64| {
            calls.set(calls.get() + 1);
            x.cos()
        };
        let (below, above) = enclosed(1.0, 2.0, f);
        assert!(below.cos() > 0.0 && above.cos() < 0.0);
        assert!(above - below <= 2.0 * f64::EPSILON, "{below} {above}");
        assert!(calls.get() < 14, "{} evaluations", calls.get());
        // A corner, a jump and a flat start are hard cases for any interpolation.
        for corner in [1e-9, 0.3, 0.999] {
            let (a, b) =
                enclosed(0.0, 1.0, |x: f64| if x < corner { -1e-3 } else { 1e5 * (x - corner) + 1.0 });
            assert!(a < corner && b >= corner && b - a <= f64::EPSILON * b, "{a} {b}");
        }
        let (a, b) = enclosed(0.0f64, 1.0, |x| x.powi(9) - 0.5f64.powi(27));
        assert!(a <= 0.125 && b >= 0.125 && b - a <= 1e-15, "{a} {b}");
    }

    #[test]
    fn a_zero_is_on_the_positive_side() {
        assert_eq!(enclosed(0.0, 1.0, |x: f64| x - 0.5).1, 0.5);
        assert_eq!(enclosed(0.0, 1.0, |x: f64| 0.5 - x).0, 0.5);
        assert_eq!(enclosed(1.0, 2.0, |x: f64| x), (1.0, 1.0));
    }

    #[test]
    fn the_zero_of_the_cosine() {
        let start = bracketed(1.0, 2.0, f64::cos);
        assert!((start - std::f64::consts::FRAC_PI_2).abs() < 1e-12);
        let polished = newton(1.57, 1.0, 2.0, |x: f64| (x.cos(), -x.sin()));
        assert_eq!(polished, std::f64::consts::FRAC_PI_2);
    }

    #[test]
    fn no_change_of_sign_gives_the_nearer_end() {
        assert_eq!(bracketed(1.0, 2.0, |x| x), 1.0);
        assert_eq!(bracketed(-2.0, -1.0, |x| x), -1.0);
    }

    #[test]
    fn newton_ends_at_the_rounding_of_the_root() {
        for off in [0.0, 1e-9, 2e-8, 5e-8, 1e-7] {
            let root = newton(2f64.sqrt() + off, 1.0, 2.0, |x| (x * x - 2.0, 2.0 * x));
            assert!((root - 2f64.sqrt()).abs() <= f64::EPSILON, "{off:e}: {:e}", root - 2f64.sqrt());
        }
        // The size of the root does not matter.
        for size in [2f64.powi(-100), 1e-3, 1e4, 2f64.powi(100)] {
            let (exact, two) = (2f64.sqrt() * size, 2.0 * size * size);
            let root = newton(exact * (1.0 + 1e-7), size, 2.0 * size, |x| (x * x - two, 2.0 * x));
            assert!((root / exact - 1.0).abs() <= f64::EPSILON, "{size:e}: {:e}", root / exact - 1.0);
        }
    }

    #[test]
    fn newton_within_a_bracket_finds_what_newton_alone_does_not() {
        for (low, high) in [(-8.0, 0.5), (-0.1, 90.0), (-1e-9, 1e9), (-3.0, 3.0)] {
            // The function is flat far off: Newton's method alone diverges from |x| > 1.39.
            let calls = core::cell::Cell::new(0);
            let root = newton_within(low, high, |x: f64| {
                calls.set(calls.get() + 1);
                (-(x - 0.125).atan(), -1.0 / (1.0 + (x - 0.125) * (x - 0.125)))
            });
            assert!((root - 0.125).abs() <= f64::EPSILON && calls.get() < 80, "{root} {}", calls.get());
        }
        // At a jump the slope carries no information.
        let root = newton_within(0.0, 1.0, |x: f64| (if x < 0.3 { 1.0 } else { -1.0 }, 0.0));
        assert!((root - 0.3).abs() < 1e-15, "{root}");
    }

    #[test]
    fn newton_stays_in_its_bracket() {
        // The slope sends the first step far outside, so that the start is kept.
        assert_eq!(newton(1.0, 0.5, 2.0, |x: f64| (x, 1e-9)), 1.0);
    }
}
