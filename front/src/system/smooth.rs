//! The smooth curve through samples of a displacement: a cubic spline, whose second derivative is straight between the samples.
//!
//! With M its second derivatives, h the steps and d the slopes of the chords,
//!
//! ```text
//! h₋ M₋ + 2(h₋ + h) M + h M₊ = 6(d − d₋)
//! ```
//!
//! at each sample within. At the ends the third derivative goes on over the next sample ("not a knot"), so that a parabola and a cubic
//! have their own second derivatives; a curve that repeats itself has the equation of its first sample there, too.

use super::node::Number;
use stickslip::system::{Beyond, Record};

/// The second derivative of the curve through the samples of a record, as a record; what it must be to have one.
pub(super) fn second_derivative<F: Number>(record: &Record<F>) -> Result<Record<F>, &'static str> {
    let Record { times, values, beyond, .. } = record;
    let [zero, one, two, six] = [0, 1, 2, 6].map(F::int);
    let steps: Vec<F> = times
        .windows(2)
        .map(|pair| pair.iter().rev().copied().reduce(|a, b| a - b).unwrap_or(zero))
        .collect();
    if steps.contains(&zero) {
        return Err("must not change at once: that takes an infinite acceleration");
    }
    let repeats = *beyond == Beyond::Repeat;
    if repeats && values.first() != values.last() {
        return Err("must end with its first value where it repeats itself");
    }
    let rises = values.windows(2).map(|pair| pair.iter().rev().copied().reduce(|a, b| a - b).unwrap_or(zero));
    let slopes: Vec<F> = rises.zip(&steps).map(|(rise, &step)| rise / step).collect();
    let at = |list: &[F], i: usize| list.get(i).copied().unwrap_or(zero);
    // The equation of a sample between two steps: their lengths, and the change of the slope.
    let row = |before: usize, after: usize| {
        let (h, k) = (at(&steps, before), at(&steps, after));
        [h, two * (h + k), k, six * (at(&slopes, after) - at(&slopes, before))]
    };
    let last = steps.len().saturating_sub(1);
    let mut rows: Vec<[F; 4]> = (1..steps.len()).map(|i| row(i.saturating_sub(1), i)).collect();
    let second = if repeats {
        rows.insert(0, row(last, 0));
        let mut second = around(&rows);
        second.extend(second.first().copied());
        second
    } else {
        let inner = rows.len();
        if let Some([h, middle, k, _]) = rows.first_mut().filter(|_| inner > 1) {
            // M₀ = (1 + h/k) M₁ − (h/k) M₂
            (*middle, *k) = (*middle + *h * (one + *h / *k), *k - *h * (*h / *k));
        }
        if let Some([h, middle, k, _]) = rows.last_mut().filter(|_| inner > 1) {
            (*middle, *h) = (*middle + *k * (one + *k / *h), *h - *k * (*k / *h));
        }
        if let ([[h, middle, k, _]], 1) = (rows.as_mut_slice(), inner) {
            // A parabola through three samples.
            *middle = *middle + (*h + *k);
        }
        let within = along(&rows, &rows.iter().map(|row| row[3]).collect::<Vec<_>>());
        let end = |first: F, next: F, ratio: F| {
            if inner > 1 { first + ratio * (first - next) } else { first }
        };
        let first = end(at(&within, 0), at(&within, 1), at(&steps, 0) / at(&steps, 1));
        let (a, b) = (inner.saturating_sub(1), inner.saturating_sub(2));
        let last = end(at(&within, a), at(&within, b), at(&steps, last) / at(&steps, last.saturating_sub(1)));
        [&[first], within.as_slice(), &[last]].concat()
    };
    let beyond = if repeats { Beyond::Repeat } else { Beyond::Zero };
    Ok(Record { times: times.clone(), values: second, force: Vec::new(), beyond })
}

/// The solution of equations with three diagonals, by elimination without exchange: each diagonal entry is the greatest of its row.
fn along<F: Number>(rows: &[[F; 4]], right: &[F]) -> Vec<F> {
    let mut done: Vec<[F; 2]> = Vec::with_capacity(rows.len());
    for (&[below, middle, above, _], &right) in rows.iter().zip(right) {
        let [ratio, before] = done.last().copied().unwrap_or([F::int(0); 2]);
        let below = if done.is_empty() { F::int(0) } else { below };
        let pivot = middle - below * ratio;
        done.push([above / pivot, (right - below * before) / pivot]);
    }
    let mut found = Vec::with_capacity(done.len());
    let mut next = F::int(0);
    for &[ratio, value] in done.iter().rev() {
        next = value - ratio * next;
        found.push(next);
    }
    found.reverse();
    found
}

/// That of equations whose first and last unknowns are neighbours, too, by a correction of rank 1.
fn around<F: Number>(rows: &[[F; 4]]) -> Vec<F> {
    let zero = F::int(0);
    let (Some(&[corner, first, ..]), Some(&[_, end, other, _])) = (rows.first(), rows.last()) else {
        return Vec::new();
    };
    if rows.len() < 3 {
        // Two unknowns: both neighbours of each are the other one. One: its own neighbour.
        let whole: Vec<[F; 4]> = match *rows {
            [[a, b, c, r]] => vec![[zero, a + b + c, zero, r]],
            [[a, b, c, r], [d, e, f, s]] => vec![[zero, b, a + c, r], [d + f, e, zero, s]],
            _ => Vec::new(),
        };
        return along(&whole, &whole.iter().map(|row| row[3]).collect::<Vec<_>>());
    }
    // A = T + u vᵀ with u = (g, 0, …, other), v = (1, 0, …, corner/g)
    let g = -first;
    let mut cut = rows.to_vec();
    if let Some(row) = cut.first_mut() {
        row[1] = first - g;
    }
    if let Some(row) = cut.last_mut() {
        row[1] = end - other * corner / g;
    }
    let count = rows.len();
    let u: Vec<F> = (0..count)
        .map(|i| {
            if i == 0 {
                g
            } else if i.saturating_add(1) == count {
                other
            } else {
                zero
            }
        })
        .collect();
    let (y, q) = (along(&cut, &rows.iter().map(|row| row[3]).collect::<Vec<_>>()), along(&cut, &u));
    let of = |list: &[F]| {
        let [first, last] = [list.first(), list.last()].map(|x| x.copied().unwrap_or(zero));
        first + last * corner / g
    };
    let share = of(&y) / (F::int(1) + of(&q));
    y.iter().zip(&q).map(|(&y, &q)| y - share * q).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    fn of(times: Vec<f64>, value: impl Fn(f64) -> f64, beyond: Beyond) -> Record<f64> {
        let values = times.iter().map(|&t| value(t)).collect();
        second_derivative(&Record { times, values, force: vec![], beyond }).unwrap()
    }

    /// A polynomial of degree 3 at uneven times, of degree 2 at three and of degree 1 at two has its own second derivative.
    #[test]
    fn a_cubic_is_met() {
        let cubic = |t: f64| 2.0 - t + 3.0 * t * t - 0.7 * t.powi(3);
        for times in [vec![0.0, 0.3, 1.0, 1.1, 2.5], vec![-1.0, 0.0, 0.5, 0.6]] {
            let found = of(times, cubic, Beyond::Zero);
            for (t, second) in found.times.iter().zip(&found.values) {
                assert!((second - (6.0 - 4.2 * t)).abs() < 1e-11, "{t}: {second}");
            }
        }
        let parabola = of(vec![0.0, 0.4, 1.0], |t| 3.0 * t * t - t, Beyond::Zero);
        assert!(parabola.values.iter().all(|second| (second - 6.0).abs() < 1e-12), "{parabola:?}");
        assert_eq!(of(vec![0.0, 1.0], |t| t, Beyond::Zero).values, [0.0; 2]);
    }

    /// A sine that repeats itself: the second derivative of its spline is off by (ωh)²/12 of its amplitude, and the more samples the less.
    #[test]
    fn a_period_of_a_sine_is_met() {
        for count in [12, 48, 200] {
            let h = 1.0 / f64::from(count);
            let times = (0..=count).map(|i| f64::from(i) * h).collect();
            let values: Vec<f64> =
                (0..=count).map(|i| (TAU * f64::from(i % count) * h + 0.4).sin()).collect();
            let found =
                second_derivative(&Record { times, values, force: vec![], beyond: Beyond::Repeat }).unwrap();
            let most = TAU * TAU * (TAU * h).powi(2) / 12.0 * 1.2;
            for (t, second) in found.times.iter().zip(&found.values) {
                let due = -TAU * TAU * (TAU * t + 0.4).sin();
                assert!((second - due).abs() < most, "{count}, {t}: {second} {due}");
            }
        }
        // Two and three samples a period: a saw.
        let saw = of(vec![0.0, 0.5, 1.0], |t| if t == 0.5 { 1.0 } else { 0.0 }, Beyond::Repeat);
        assert!((saw.values[0] - 24.0).abs() < 1e-12 && (saw.values[1] + 24.0).abs() < 1e-12, "{saw:?}");
    }

    #[test]
    fn what_jumps_has_none() {
        let jump = Record {
            times: vec![0.0, 1.0, 1.0],
            values: vec![0.0, 1.0, 2.0],
            force: vec![],
            beyond: Beyond::Zero,
        };
        assert!(second_derivative(&jump).is_err());
        let open = Record {
            times: vec![0.0, 1.0, 2.0],
            values: vec![0.0, 1.0, 2.0],
            force: vec![],
            beyond: Beyond::Repeat,
        };
        assert!(second_derivative(&open).is_err());
    }
}
