//! The worst error of each output over many points, and its place.

use super::COUNT;
use super::points::{ALPHAS, OMEGAS, Random, point};
use super::reference::{Narrow, errors};

/// The worst error of one output.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Worst {
    pub(crate) error: f64,
    pub(crate) omega: f64,
    pub(crate) alpha: f64,
    /// Indices of the measures of the point.
    pub(crate) measures: (usize, usize),
}

/// The worst of each output, and the number of points.
#[derive(Debug, Clone)]
pub(crate) struct Survey {
    pub(crate) worst: [Worst; COUNT],
    pub(crate) points: u64,
}

const NOTHING: Worst = Worst { error: -1.0, omega: f64::NAN, alpha: f64::NAN, measures: (0, 0) };

impl Survey {
    pub(crate) fn empty() -> Self {
        Self { worst: [NOTHING; COUNT], points: 0 }
    }

    /// `count` points of each pair of measures.
    pub(crate) fn of<F: Narrow>(seed: u64, count: u64) -> Self {
        let mut survey = Self::empty();
        let mut random = Random(seed);
        for _ in 0..count {
            for measures in (0..OMEGAS.len()).flat_map(|o| (0..ALPHAS.len()).map(move |a| (o, a))) {
                survey.add::<F>(&mut random, measures);
            }
        }
        survey
    }

    fn add<F: Narrow>(&mut self, random: &mut Random, measures: (usize, usize)) {
        let Some((omega, alpha)) = point::<F>(random, measures.0, measures.1) else { return };
        let Some(errors) = errors(omega, alpha) else { return };
        let (omega, alpha) = (omega.to_f64(), alpha.to_f64());
        self.points += 1;
        for (worst, error) in self.worst.iter_mut().zip(errors) {
            if is_worse(error, worst.error) {
                *worst = Worst { error, omega, alpha, measures };
            }
        }
    }

    /// Combines two surveys.
    pub(crate) fn merge(mut self, other: &Self) -> Self {
        self.points += other.points;
        for (mine, its) in self.worst.iter_mut().zip(other.worst) {
            if is_worse(its.error, mine.error) {
                *mine = its;
            }
        }
        self
    }
}

/// NaN counts as the worst error.
fn is_worse(error: f64, known: f64) -> bool {
    error > known || error.is_nan()
}

/// `x` in hexadecimal, as C's `%a`.
pub(crate) fn hex(x: f64) -> String {
    let bits = x.to_bits();
    let (sign, exponent, fraction) = (bits >> 63, (bits >> 52) & 0x7ff, bits & ((1 << 52) - 1));
    if x == 0.0 || !x.is_normal() {
        return format!("{x}");
    }
    let digits = format!("{fraction:013x}");
    let digits = digits.trim_end_matches('0');
    let point = if digits.is_empty() { "" } else { "." };
    format!("{}0x1{point}{digits}p{}", if sign == 1 { "-" } else { "" }, exponent as i64 - 1023)
}
