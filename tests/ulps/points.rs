//! Test points (Ω, α): random in several measures, and chosen where the formulae are most sensitive.

use super::reference::{Narrow, border_from_above};
pub(crate) use crate::random::Random;
use stickslip::{Border, PhaseFunction};

impl Random {
    /// An integer in low..=high.
    pub(crate) fn integer(&mut self, low: i64, high: i64) -> i64 {
        low + (self.bits() % (high - low + 1) as u64) as i64
    }
    /// 2⁻ᵏ u, with k below the number of digits and u in [−1, 1).
    pub(crate) fn tiny<F: Narrow>(&mut self) -> f64 {
        self.between(-1.0, 1.0) * 2f64.powi(-(self.integer(0, i64::from(F::PRECISION) - 1) as i32))
    }
}

const LEAST: f64 = 1e-3;
const GREATEST: f64 = 1e3;

type Omega<F> = fn(&mut Random) -> F;
type Alpha<F> = fn(&mut Random, F, F) -> F;

/// The measures of Ω and of α.
pub(crate) const OMEGAS: [&str; 9] = [
    "uniform in (0, 4)",
    "log-uniform",
    "random bits",
    "uniform in 1/Ω up to 30",
    "uniform in (1/2, 2)",
    "beside 1",
    "the floats beside 1",
    "beside 1/n",
    "the floats beside 1/n",
];
pub(crate) const ALPHAS: [&str; 6] = [
    "the border",
    "the floats above the border",
    "above the border by 2⁻ᵏ",
    "up to 4 times the border",
    "up to 10⁴ times the border",
    "the double multiplier",
];

/// An integer up to 1000, log-uniform.
fn subharmonic(r: &mut Random) -> f64 {
    r.between(0.0, 1000f64.ln()).exp().floor()
}

const fn omegas<F: Narrow>() -> [Omega<F>; 9] {
    [
        |r| F::from_f64(r.between(LEAST, 4.0)),
        |r| F::from_f64(r.between(LEAST.ln(), GREATEST.ln()).exp()),
        |r| {
            F::of_bits_between(F::from_f64(LEAST), F::from_f64(GREATEST), |least, greatest| {
                r.integer(least, greatest)
            })
        },
        |r| F::from_f64(1.0 / r.between(0.25, 30.0)),
        |r| F::from_f64(r.between(0.5, 2.0)),
        |r| F::from_f64(1.0 + r.tiny::<F>() / 2.0),
        |r| {
            let steps = r.integer(1, 40);
            F::int(1).stepped(if r.bits() & 1 == 0 { steps } else { -steps })
        },
        |r| {
            let n = subharmonic(r);
            F::from_f64((1.0 + r.tiny::<F>() / (2.0 * n)) / n)
        },
        |r| {
            let n = subharmonic(r);
            (F::int(1) / F::from_f64(n)).stepped(r.integer(-4, 4))
        },
    ]
}

/// Each function gets Ω and the border, rounded up.
const fn alphas<F: Narrow>() -> [Alpha<F>; 6] {
    [
        |_, _, border| border,
        |r, _, border| border.stepped(r.integer(0, 20)),
        |r, _, border| border * F::from_f64(1.0 + r.tiny::<F>().abs()),
        |r, _, border| border * F::from_f64(r.between(1.0, 4.0)),
        |r, _, border| border * F::from_f64(r.between(0.0, 1e4f64.ln()).exp()),
        |r, omega, border| {
            // Ω²(Δ₀/B) |sin(π/Ω)| = 1
            PhaseFunction::new(omega).map_or(border, |p| {
                let (one, (s, c)) = (F::int(1), p.sin_cos());
                let delta = one / (omega * omega * (F::int(2) * s * c).abs());
                let alpha = p.value().hypot((one - omega) * (one + omega) * delta);
                let greatest = F::exp2i(F::RATIO_EXPONENT - 1);
                let alpha = alpha.stepped(r.integer(-8, 8));
                if alpha >= border && alpha <= greatest { alpha } else { border }
            })
        },
    ]
}

/// Ω of the given measure, if it is in the range and not 1.
pub(crate) fn frequency_ratio<F: Narrow>(random: &mut Random, measure: usize) -> Option<F> {
    let omega = omegas::<F>()[measure](random);
    let is_in_range = omega >= F::from_f64(LEAST) && omega <= F::from_f64(GREATEST);
    (is_in_range && omega != F::int(1)).then_some(omega)
}

/// α of the given measure, given the border rounded up.
pub(crate) fn force_ratio<F: Narrow>(random: &mut Random, measure: usize, omega: F, border: F) -> F {
    alphas::<F>()[measure](random, omega, border)
}

/// A point of the given measures that does not stick according to both the number and its reference.
pub(crate) fn point<F: Narrow>(random: &mut Random, omega: usize, alpha: usize) -> Option<(F, F)> {
    let omega: F = frequency_ratio(random, omega)?;
    let border = border_from_above(omega)?;
    let own = Border::new(omega).ok()?.min_force_ratio;
    // Within its error the number's border may exceed the true one, so that such an α would count as
    // sticking.
    let least = if own > border && own < border.stepped(64) { own } else { border };
    Some((omega, alphas::<F>()[alpha](random, omega, border).or_larger(least)))
}
