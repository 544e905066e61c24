//! Zeros of functions of one variable: a bracket at f64, then a polish at the precision of the type.

use crate::float::Float;
use roots::{SimpleConvergency, find_root_brent};

/// A zero of `f` in `[low, high]`, where it changes sign, by Brent's method at f64.
///
/// Where rounding hides the change of sign, the end at which |f| is smaller: the zero is within rounding
/// of it.
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

/// Newton's method from a `start` good to about 1e-8, inside `[low, high]`; `f` gives (value, slope).
///
/// Each step doubles the good bits, so that `log₂(PRECISION)` steps bound the loop. It ends with the step whose
/// square is below rounding: the error it leaves is of that order, measured by the distance from the ends, where a
/// second zero may be near.
pub(crate) fn newton<F: Float>(start: F, low: F, high: F, mut f: impl FnMut(F) -> (F, F)) -> F {
    let tolerance = F::epsilon() / F::int(64);
    let mut x = start;
    for _ in 0..F::PRECISION.ilog2() {
        let (value, slope) = f(x);
        let step = value / slope;
        let next = x - step;
        // A slope of zero sends the step to infinity or NaN, which are outside as well.
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

#[cfg(test)]
mod tests {
    use super::{bracketed, newton};

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
    fn newton_stays_in_its_bracket() {
        // The slope sends the first step far outside: the start is kept.
        assert_eq!(newton(1.0, 0.5, 2.0, |x: f64| (x, 1e-9)), 1.0);
    }
}
