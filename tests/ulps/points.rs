//! Where to look: (Ω, α) random in several measures, and chosen where the formulae have the least to go on.

use super::reference::border_from_above;
use stickslip::{Border, PhaseFunction};

/// SplitMix64.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }
    /// In [low, high).
    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.bits() >> 11) as f64 / (1u64 << 53) as f64)
    }
    /// In low..=high.
    fn integer(&mut self, low: i64, high: i64) -> i64 {
        low + (self.bits() % (high - low + 1) as u64) as i64
    }
    /// 2⁻ᵏ u, k in 0..=52 and u in [−1, 1).
    fn tiny(&mut self) -> f64 {
        self.between(-1.0, 1.0) * 2f64.powi(-(self.integer(0, 52) as i32))
    }
}

const LEAST: f64 = 1e-3;
const GREATEST: f64 = 1e3;

/// `x` moved by so many floats.
fn floats_on(x: f64, steps: i64) -> f64 {
    f64::from_bits(x.to_bits().wrapping_add_signed(steps))
}

type Omega = fn(&mut Random) -> f64;
type Alpha = fn(&mut Random, f64, f64) -> f64;

/// The measures of Ω.
pub(crate) const OMEGAS: [(&str, Omega); 9] = [
    ("uniform in (0, 4)", |r| r.between(LEAST, 4.0)),
    ("log-uniform", |r| r.between(LEAST.ln(), GREATEST.ln()).exp()),
    ("random bits", |r| f64::from_bits(r.integer(LEAST.to_bits() as i64, GREATEST.to_bits() as i64) as u64)),
    ("uniform in 1/Ω up to 30", |r| 1.0 / r.between(0.25, 30.0)),
    ("uniform in (1/2, 2)", |r| r.between(0.5, 2.0)),
    ("beside 1", |r| 1.0 + r.tiny() / 2.0),
    ("the floats beside 1", |r| {
        let steps = r.integer(1, 40);
        if r.bits() & 1 == 0 { floats_on(1.0, steps) } else { floats_on(1.0, -steps) }
    }),
    ("beside 1/n", |r| {
        let n = (r.between(0.0, 1000f64.ln()).exp()).floor();
        (1.0 + r.tiny() / (2.0 * n)) / n
    }),
    ("the floats beside 1/n", |r| {
        let n = (r.between(0.0, 1000f64.ln()).exp()).floor();
        let steps = r.integer(-4, 4);
        floats_on(1.0 / n, steps)
    }),
];

/// The measures of α; each is given Ω and the border, rounded up.
pub(crate) const ALPHAS: [(&str, Alpha); 6] = [
    ("the border", |_, _, border| border),
    ("the floats above the border", |r, _, border| floats_on(border, r.integer(0, 20))),
    ("above the border by 2⁻ᵏ", |r, _, border| border * (1.0 + r.tiny().abs())),
    ("up to 4 times the border", |r, _, border| border * r.between(1.0, 4.0)),
    ("up to 10⁴ times the border", |r, _, border| border * r.between(0.0, 1e4f64.ln()).exp()),
    ("the double multiplier", |r, omega, border| {
        // Ω²(Δ₀/B) |sin(π/Ω)| = 1
        PhaseFunction::new(omega).map_or(border, |p| {
            let (s, c) = p.sin_cos();
            let delta = 1.0 / (omega * omega * (2.0 * s * c).abs());
            let alpha = p.value().hypot((1.0 - omega) * (1.0 + omega) * delta);
            floats_on(alpha, r.integer(-8, 8)).clamp(border, 1e60)
        })
    }),
];

/// A point of the given measures on which f64 and the reference agree that the body does not stick.
pub(crate) fn point(random: &mut Random, omega: usize, alpha: usize) -> Option<(f64, f64)> {
    let omega = OMEGAS[omega].1(random).clamp(LEAST, GREATEST);
    if omega == 1.0 {
        return None;
    }
    let border = border_from_above(omega)?;
    let own = Border::new(omega).ok()?.min_force_ratio();
    // Within its error f64 may put the border above the true one, and name such an α sticking.
    let least = if own > border && own < floats_on(border, 64) { own } else { border };
    Some((omega, ALPHAS[alpha].1(random, omega, border).max(least)))
}
