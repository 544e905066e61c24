//! Checks of π, the circular functions and the exponential.

use super::{Both, Broken, hold};
use crate::float::pair::Pair;
use crate::float::{AtPrecision, Field, Float, pi_digits};
use alloc::vec::Vec;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

pub(super) fn check<F: Float>() -> Result<(), Broken> {
    pi::<F>()?;
    circular::<F>()?;
    angles::<F>()?;
    exponentials::<F>()?;
    precisions::<F>()
}

/// Checks the three parts of π against its digits.
fn pi<F: Float>() -> Result<(), Broken> {
    let count = pi_digits::count(F::PRECISION.saturating_mul(3));
    let (first, (second, third)) = (F::pi(), F::pi_rest());
    let mut left = pi_digits::pi(count);
    let nearest = "is the nearest number to what is left of π";
    for (method, part) in [("Real::pi", first), ("Float::pi_rest", second), ("Float::pi_rest", third)] {
        left = pi_digits::less(&left, &pi_digits::digits_of(part, count));
        // Half a unit in the last place; the digits of the last part end slightly beyond it.
        let last = F::epsilon() * part.abs() * F::ratio(33, 64);
        hold(pi_digits::number::<F>(&left).abs() <= last, method, format_args!("{part:e}"), nearest)?;
    }
    Ok(())
}

/// `(sin x, cos x)` in pairs by their series, for |x| up to about 4.
fn series<F: Float>(x: Pair<F>) -> (Pair<F>, Pair<F>) {
    let one = Pair::<F>::int(1);
    let (mut sine, mut cosine, mut term) = (Pair::int(0), one, one);
    for n in 1..=terms::<F>() {
        term = term * x / Pair::int(n);
        match n % 4 {
            1 => sine = sine + term,
            2 => cosine = cosine - term,
            3 => sine = sine - term,
            _ => cosine = cosine + term,
        }
    }
    (sine, cosine)
}

/// The number of terms after which a series at 4 is accurate to twice the digits: n! > 4ⁿ 2²ᵖ.
fn terms<F: Float>() -> i32 {
    let (mut n, mut bits) = (16, 0.0);
    while bits < f64::from(F::PRECISION) * 2.0 + 8.0 {
        n += 1;
        bits += (f64::from(n) / 4.0).log2();
    }
    n
}

/// Whether a result is within a number of units in the last place.
fn within<F: Float>(found: F, exact: Pair<F>, units: i32) -> bool {
    (exact - found.wide()).value().abs() <= F::int(units) * F::epsilon() * exact.value().abs()
}

fn arguments<F: Float>() -> Vec<F> {
    let ratios = [
        (1, 1000),
        (1, 10),
        (1, 2),
        (7, 9),
        (1, 1),
        (11, 7),
        (3, 2),
        (2, 1),
        (3, 1),
        (22, 7),
        (10, 1),
        (100, 1),
        (355, 1),
    ];
    let some = ratios.into_iter().map(|(p, q)| F::ratio(p, q));
    let own = [F::pi(), F::pi() / F::int(2), F::pi() / F::int(4), F::exp2i(-20)];
    some.chain(own).flat_map(|x| [x, -x]).collect()
}

fn circular<F: Float>() -> Result<(), Broken> {
    for x in arguments::<F>() {
        let half_turns = (x / F::pi()).round();
        let (sine, cosine) = series(x.wide() - Pair::pi() * half_turns.wide());
        let is_odd = (half_turns / F::int(2)).floor() * F::int(2) != half_turns;
        let (sine, cosine) = if is_odd { (-sine, -cosine) } else { (sine, cosine) };
        let (s, c) = x.sin_cos();
        // Where the function is small, its accuracy depends on the argument's distance from a multiple of
        // π/2.
        let close = "is within 2 units in the last place, beside multiples of π/2 too";
        hold(within(s, sine, 2), "Real::sin_cos", format_args!("{x} (the sine)"), close)?;
        hold(within(c, cosine, 2), "Real::sin_cos", format_args!("{x} (the cosine)"), close)?;
        hold(within(x.sin(), sine, 2), "Real::sin", x, close)?;
        hold(within(x.cos(), cosine, 2), "Real::cos", x, close)?;
        hold(within(x.tan(), sine / cosine, 4), "Real::tan", x, "is within 4 units in the last place")?;
        if x.abs() <= F::int(1) {
            let (s, c) = F::sin_cos_acute(x.wide());
            let third = |found: Pair<F>, exact: Pair<F>| {
                (found - exact).value().abs() * F::int(3)
                    <= F::epsilon() * exact.value().abs().or_larger(F::ratio(1, 2))
            };
            let is = third(s, sine) && third(c, cosine);
            hold(is, "Float::sin_cos_acute", x, "is within a third of a unit in the last place")?;
        }
    }
    Ok(())
}

fn angles<F: Float>() -> Result<(), Broken> {
    let (zero, one) = (F::int(0), F::int(1));
    let close = "is the angle in [−π, π] within 2 units in the last place";
    for y in [zero, F::exp2i(-20), F::ratio(1, 3), F::ratio(7, 8), one, F::int(5), F::int(1000)] {
        for x in [zero, F::ratio(1, 3), one, F::int(3), F::int(900)] {
            for (y, x) in [(y, x), (-y, x), (y, -x), (-y, -x)] {
                if y == zero && x <= zero {
                    continue;
                }
                let angle = y.atan2(x);
                let (sine, cosine) = series(angle.wide());
                let (wide_y, wide_x) = (y.wide(), x.wide());
                // sin(exact − angle) times the distance, and the cosine likewise.
                let off = (wide_y * cosine - wide_x * sine).value();
                let along = (wide_x * cosine + wide_y * sine).value();
                let is = along > zero && off.abs() <= F::int(2) * F::epsilon() * angle.abs() * along;
                hold(is, "Real::atan2", Both(y, x), close)?;
            }
        }
    }
    hold(zero.atan2(-one) == F::pi(), "Real::atan2", Both(zero, -one), "is π")?;
    for n in 0..=20 {
        let (s, c) = (F::pi() * F::ratio(n, 20)).sin_cos();
        let (angle, same) = (F::angle_of(s, c), s.atan2(c));
        let is =
            s < zero || (angle - same).abs() <= F::int(4) * F::epsilon() * same.or_larger(F::ratio(1, 8));
        hold(is, "Float::angle_of", Both(s, c), "is the angle of atan2")?;
    }
    Ok(())
}

/// `eˣ − 1` in pairs by its series, |x| ≤ 4.
fn exponential_series<F: Float>(x: Pair<F>) -> Pair<F> {
    let mut term = Pair::<F>::int(1);
    (1..=terms::<F>()).fold(Pair::int(0), |sum, n| {
        term = term * x / Pair::int(n);
        sum + term
    })
}

fn exponentials<F: Float>() -> Result<(), Broken> {
    let one = Pair::<F>::int(1);
    for (p, q) in [(1, 1000), (1, 10), (1, 2), (1, 1), (2, 1), (4, 1)] {
        for x in [F::ratio(p, q), -F::ratio(p, q)] {
            // For a negative number, e⁻ˣ − 1 = −(eˣ − 1)/eˣ, without cancellation.
            let rise = exponential_series(x.abs().wide());
            let less_one = if x < F::int(0) { -rise / (rise + one) } else { rise };
            let units = 16 + 16 * p / q;
            let close = "is within some units in the last place, |x| times as many beyond 1";
            hold(within(x.exp(), less_one + one, units), "Float::exp", x, close)?;
            hold(within(x.exp_m1(), less_one, units), "Float::exp_m1", x, close)?;
        }
    }
    Ok(())
}

/// Converts to the other precision and back.
struct Return<F>(F);

impl<F: Float> AtPrecision<F> for Return<F> {
    type Output = F;

    fn run<G: Float>(self, there: impl Fn(F) -> G, back: impl Fn(G) -> F) -> F {
        back(there(self.0))
    }
}

fn precisions<F: Float>() -> Result<(), Broken> {
    let x = F::ratio(1, 3);
    let kept = F::guarded(Return(x));
    hold(kept == x, "Float::guarded", x, "runs at the type itself or a wider one, and comes back")?;
    let near = (F::narrowed(Return(x)) - x).abs() <= F::ratio(1, 1 << 20);
    hold(near, "Float::narrowed", x, "runs at a narrower type, and comes back")?;
    let same = x.differentiated_as(|| F::int(2));
    hold(same == x && x.constant() == x, "Float::constant", x, "is the value itself")
}
