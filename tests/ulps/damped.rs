//! Errors with a damper, in ulp and in ulp per condition number, and the points at which they are taken.
//!
//! The condition number κ of an output is its relative change for a relative change of α and of ζ: an input
//! that is rounded in its last place moves the output by so many of its own.

use super::points::{ALPHAS, OMEGAS, Random, force_ratio, frequency_ratio};
use super::reference::{Narrow, answers, difference_in_ulp, errors_at, rounded_up, widened};
use super::{COUNT, OUTPUTS};
use stickslip::{Border, Field, Float, Ratios};

/// The measures of ζ.
pub(crate) const ZETAS: [&str; 4] =
    ["log-uniform from 1e-30 to 1", "uniform in (0, 1)", "beside 1", "log-uniform from 1 to 40"];

/// The outputs that have a meaning with a damper: all but K.
pub(crate) const DAMPED: usize = COUNT - 1;

/// The worst error of one output, and its place.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Worst {
    pub(crate) error: f64,
    pub(crate) ratios: Option<Ratios<f64>>,
}

/// The worst of each output in ulp, the worst in ulp per 1 + κ, and the number of points.
#[derive(Debug, Clone)]
pub(crate) struct Survey {
    pub(crate) worst: [[Worst; 2]; DAMPED],
    pub(crate) points: u64,
}

impl Survey {
    pub(crate) fn empty() -> Self {
        Self { worst: [[Worst { error: -1.0, ratios: None }; 2]; DAMPED], points: 0 }
    }

    /// `count` points of each measure of Ω, α and ζ, a third of them with static friction.
    pub(crate) fn of(seed: u64, count: u64) -> Self {
        let (mut survey, mut random) = (Self::empty(), Random(seed));
        for i in 0..count {
            for omega in 0..OMEGAS.len() {
                // The last measure of α is that of a multiplier without a damper.
                for (alpha, zeta) in (0..ALPHAS.len() - 1).flat_map(|a| (0..ZETAS.len()).map(move |z| (a, z)))
                {
                    if let Some(ratios) = point(&mut random, [omega, alpha, zeta], i % 3 == 2) {
                        survey.add(ratios);
                    }
                }
            }
        }
        survey
    }

    fn add(&mut self, ratios: Ratios<f64>) {
        let Some(errors) = errors(ratios) else { return };
        self.points += 1;
        for (worst, errors) in self.worst.iter_mut().zip(errors) {
            for (worst, error) in worst.iter_mut().zip(errors) {
                worst.take(Worst { error, ratios: Some(ratios) });
            }
        }
    }

    /// Combines two surveys.
    pub(crate) fn merge(mut self, other: &Self) -> Self {
        self.points += other.points;
        for (mine, its) in self.worst.iter_mut().flatten().zip(other.worst.iter().flatten()) {
            mine.take(*its);
        }
        self
    }
}

impl Worst {
    /// NaN counts as the worst error.
    fn take(&mut self, other: Self) {
        if other.error > self.error || other.error.is_nan() {
            *self = other;
        }
    }
}

/// A point of the given measures on or above the border, according to both the number and its reference.
fn point(random: &mut Random, [omega, alpha, zeta]: [usize; 3], is_held: bool) -> Option<Ratios<f64>> {
    let omega: f64 = frequency_ratio(random, omega)?;
    let zeta = match zeta {
        0 => random.between(1e-30f64.ln(), 0.0).exp(),
        1 => random.between(0.0, 1.0),
        2 => 1.0 + random.tiny::<f64>(),
        _ => random.between(0.0, 40f64.ln()).exp(),
    };
    let eta = if is_held { 1.0 + 2.0 * random.tiny::<f64>().abs() } else { 1.0 };
    let at = |alpha| {
        Ratios::new(omega, alpha).ok()?.with_damping_ratio(zeta).ok()?.with_static_friction_ratio(eta).ok()
    };
    let border: f64 = rounded_up::<f64>(Border::of(&widened(&at(2.0)?)?).min_force_ratio)?;
    let own = Border::of(&at(2.0)?).min_force_ratio;
    let alpha: f64 = force_ratio(random, alpha, omega, border);
    at(alpha.max(border).max(own).max(1f64.next_up()))
}

/// The error of each output in its unit, and that over 1 + κ.
pub(crate) fn errors(ratios: Ratios<f64>) -> Option<[[f64; 2]; DAMPED]> {
    let errors = errors_at(ratios)?;
    let exact = widened(&ratios)?;
    let wide = answers(exact)?;
    let near = |alpha, zeta| {
        let ratios = Ratios::new(exact.omega(), alpha).ok()?.with_damping_ratio(zeta).ok()?;
        answers(ratios.with_static_friction_ratio(exact.static_friction_ratio()).ok()?)
    };
    type Wide = <f64 as Narrow>::Wide;
    let (more, less) = (Wide::int(1) + Wide::exp2i(-80), Wide::int(1) - Wide::exp2i(-80));
    let (alpha, zeta) = (exact.alpha(), exact.damping_ratio());
    let beside = [near(alpha * more, zeta), near(alpha, zeta * more).or_else(|| near(alpha, zeta * less))];
    let mut found = [[0.0; 2]; DAMPED];
    for (i, found) in found.iter_mut().enumerate() {
        let condition: f64 = beside
            .iter()
            .filter_map(|values| {
                let moved =
                    difference_in_ulp::<f64>(OUTPUTS[i].unit, values.as_ref()?[i]?, wide[i]?, wide[2]?);
                // 2⁻⁸⁰ of an input, in units of its last place.
                Some(moved * 2f64.powi(80 - 52))
            })
            .sum();
        *found = [errors[i], errors[i] / (1.0 + condition)];
    }
    Some(found)
}
