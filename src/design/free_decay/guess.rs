//! Guesses of a sampled decay, from its turning points.

use alloc::vec;
use alloc::vec::Vec;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// A guess of the motion that samples show.
#[derive(Debug, Clone, Copy)]
pub(super) struct Guess {
    /// The place of the first turning point among the samples.
    pub(super) first: usize,
    /// The time of half a cycle.
    pub(super) half: f64,
    /// The displacement at which the spring rests.
    pub(super) rest: f64,
    /// The first and the last turning point from there; the last without its sign.
    pub(super) amplitudes: [f64; 2],
    /// The half cycles between the two.
    pub(super) half_cycles: usize,
}

/// The parts of the range by which a turning point stands out.
const PARTS: [f64; 4] = [0.05, 0.12, 0.25, 0.02];
/// The greatest number of guesses.
const MOST: usize = 5;
/// Half lengths within this part of each other are the same guess.
const SAME: f64 = 0.12;

/// Different guesses, by smoothing and by the size of a turning point.
///
/// Noise hides the turning points of a decay, and makes turning points of its own. Means over 2, 4, 8 … samples have less
/// of it, and those over a quarter of a cycle lose little of the motion. Which guess is right is for the fit to say.
pub(super) fn guesses(times: &[f64], x: &[f64]) -> Vec<Guess> {
    let mut found: Vec<Guess> = Vec::new();
    let mut width = 1;
    while width * 4 <= x.len().max(4) {
        let smooth = smoothed(x, width);
        for part in PARTS {
            let of = of_turning_points(times, &smooth, width / 2, &turning_points(&smooth, part));
            // Means over more than a third of a half cycle show another motion.
            let of = of.filter(|guess| times[width - 1] - times[0] <= guess.half / 3.0);
            let Some(guess) = of.filter(|_| found.len() < MOST) else { continue };
            // Of the same first turning point and length, the guess of more half cycles is the better one.
            let is_same = |other: &&mut Guess| {
                (other.half / guess.half).ln().abs() < SAME
                    && (times[other.first] - times[guess.first]).abs() < guess.half / 4.0
            };
            match found.iter_mut().find(is_same) {
                Some(other) if other.half_cycles < guess.half_cycles => *other = guess,
                Some(_) => {}
                None => found.push(guess),
            }
        }
        width *= 2;
    }
    found
}

/// Means over so many successive samples.
fn smoothed(x: &[f64], width: usize) -> Vec<f64> {
    x.windows(width).map(|part| part.iter().sum::<f64>() / width as f64).collect()
}

/// A guess from turning points that are evenly spaced but for some at the end.
fn of_turning_points(times: &[f64], x: &[f64], shift: usize, turns: &[usize]) -> Option<Guess> {
    let time = |i: usize| times[turns[i] + shift];
    let mut count = turns.len();
    let mut half = 0.0;
    // The first half cycle may be cut.
    for i in 1..turns.len() {
        let length = time(i) - time(i - 1);
        if i >= 2 && !(0.6 * half..=1.6 * half).contains(&length) {
            if i == 2 && length > half {
                half = length;
                continue;
            }
            count = i;
            break;
        }
        half = if i == 1 { length } else { (half * (i - 1) as f64 + length) / i as f64 };
    }
    if count < 3 || half <= 0.0 {
        return None;
    }
    let half = (time(count - 1) - time(1)) / (count - 2) as f64;
    let at = |i: usize| x[turns[i]];
    // Of three successive turning points the outer ones and twice the middle one cancel but for the rest.
    let rest =
        (2..count).map(|i| (at(i - 2) + 2.0 * at(i - 1) + at(i)) / 4.0).sum::<f64>() / (count - 2) as f64;
    let amplitudes = [at(0) - rest, (at(count - 1) - rest).abs()];
    Some(Guess { first: turns[0] + shift, half, rest, amplitudes, half_cycles: count - 1 })
}

/// The places of the turning points that stand out by a part of the range, from the first one that another one follows.
fn turning_points(x: &[f64], part: f64) -> Vec<usize> {
    let most = x.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let least = x.iter().copied().fold(f64::INFINITY, f64::min);
    let enough = (most - least) * part;
    let mut found: Vec<usize> = vec![];
    let (mut high, mut low) = (0usize, 0usize);
    let mut is_rising: Option<bool> = None;
    for (i, &value) in x.iter().enumerate() {
        if value > x[high] {
            high = i;
        }
        if value < x[low] {
            low = i;
        }
        if is_rising != Some(false) && x[high] - value > enough {
            found.push(high);
            (is_rising, low) = (Some(false), i);
        } else if is_rising != Some(true) && value - x[low] > enough {
            found.push(low);
            (is_rising, high) = (Some(true), i);
        }
    }
    // The last one, which nothing follows.
    match is_rising {
        Some(true) if x.len() - high > 1 => found.push(high),
        Some(false) if x.len() - low > 1 => found.push(low),
        _ => {}
    }
    // A pull from rest begins with no turning point: the greatest of the first two begins the decay.
    if let [a, b, c, ..] = found.iter().map(|&place| x[place]).collect::<Vec<_>>()[..]
        && (a - b).abs() < (b - c).abs() * 0.9
    {
        found.remove(0);
    }
    found
}
