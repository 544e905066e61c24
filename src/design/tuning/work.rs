//! The work of friction as a function of the stiffness, and the proof of its greatest value.
//!
//! # One cycle at each stiffness
//!
//! In units of time 1/ω_d and of length r_y/(mω_d²) the body is `y″ + 2γy′ + vy + sgn y′ = α sin s`, with
//! `v = k/(mω_d²) = 1/Ω²` and `γ = c/(2mω_d) = ζ/Ω`, and the work of friction is 4 times the amplitude `Y =
//! Ω²Δ₀/B`: `A₂ = 8Y/α²`. The cycle is the response to the force and to the square wave of friction. With
//! `Z_n = v − n² + 2iγn` for the odd harmonics n of the latter,
//!
//! ```text
//! (Y + g)² + h² = α²/|Z₁|²,   g = Ω²G = (8γ/π) Σ 1/|Z_n|²,   h = Ω²H = (4/π) Σ (n² − v)/|Z_n|².
//! ```
//!
//! **Without the first harmonic nothing cancels.** Let now g and h be the sums over n ≥ 3, `u = v − 1`, `D =
//! |Z₁|² = u² + 4γ²`, κ = 16γ/π. Then X = Y + g is the root > 0 of
//!
//! ```text
//! D (X² + h²) + κX − (8/π) u h = α² − 16/π²,   X = 2C/(κ + s),   s = √(κ² + 4DC),
//! C = α² − 16/π² + (8/π) u h − D h²,
//! ```
//!
//! with 2DX + κ = s, and by the derivatives g′ and h′ by v, `s Y′ = Φ`:
//!
//! ```text
//! Φ = −2u (X² + h²) − 2D h h′ + (8/π)(h + u h′) − g′ s.
//! ```
//!
//! Only the poles n = 3, 5, … of g and h make dips in Y, and only D the resonance. (The text calls the sums
//! over all harmonics and those without the first alike where no confusion is possible.)
//!
//! # Where the greatest value is
//!
//! The body slides only where `Y + g ≥ 1 + vg + 2γh`, the condition at the turning point. With all harmonics
//! `Y ≥ 1 + (8γ/π) Σ (n² − 1)/|Z_n|² ≥ 1`, hence X ≥ 1.
//!
//! * **For v ≤ 1/2 Y rises with v.** With m = n² − v, `(1 + 4γ²)/|Z_n|² ≤ 1/n²` and `4γmn ≤ |Z_n|²` give `D
//!   |h′| ≤ (4/π) Σ 1/n² < 0.3`, `D g′ ≤ (4/π) Σ 1/n³ < 0.07`, κg′ < 0.03 and h′ < 0.03. So `−2D h h′ + (8/π) h
//!   ≥ 0` and `Φ ≥ 2(1 − v) X² − 0.07 (1 − v) − 0.14 X − 0.03 > 0` for 1 − v ≥ 1/2 and X ≥ 1.
//! * **Y ≤ α/√D** from the first equation, which bounds all stiffnesses farther from the resonance.
//! * **Elsewhere by bounds on pieces.** On an interval of v, `|h′| ≤ (4/π) Σ 1/|Z_n|²`, `|h″| ≤ (8/π) Σ
//!   1/|Z_n|³`, and the same with 1/n times each term for g: with the least |Z_n| of the interval they bound
//!   h, h′ and g′ around their values in its middle, and interval arithmetic then bounds X, s and Φ. Where
//!   Φ has one sign, Y is monotone, and only the ends of the interval count. Where `Y(middle) + max |Φ|/s`
//!   times half the width is not above the best value, there is nothing better. All other intervals are
//!   halved. Where Φ falls through zero between the ends of one, that zero is found by its bracket.
//!
//! So the best value is proved for each band, to rounding. The number of intervals grows with the number of
//! digits and with log(1/γ).

use super::span::Span;
use crate::cycle::damped::half_period::HalfPeriod;
use crate::float::Float;
use crate::machine::error::{Error, written};
use crate::root;
use alloc::vec;
use alloc::vec::Vec;

/// The work of friction at a force ratio and a damping constant, by the stiffness.
#[derive(Debug, Clone, Copy)]
pub(super) struct FrictionWork<F> {
    alpha: F,
    /// The damping constant γ = c/(2mω_d).
    gamma: F,
    /// `α² − 16/π²`.
    excess: F,
    /// The constant κ = 16γ/π.
    kappa: F,
}

/// The cycle at one stiffness, with the sums over n ≥ 3.
#[derive(Debug, Clone, Copy)]
struct CycleAt<F> {
    u: F,
    d: F,
    g: F,
    h: F,
    g_slope: F,
    h_slope: F,
}

/// Bounds of |g″|, |h′| and |h″|.
#[derive(Debug, Clone, Copy)]
struct Rates<F> {
    g_second: F,
    h_slope: F,
    h_second: F,
}

/// The greatest number of intervals of one band: a hundred times the greatest number known.
const INTERVALS: u32 = 1 << 16;

/// The greatest number of harmonics with poles near an interval for which bounds are computed.
const HARMONICS: i32 = 24;

impl<F: Float> FrictionWork<F> {
    pub(super) fn new(alpha: F, gamma: F) -> Self {
        let first = F::int(4) / F::pi();
        Self { alpha, gamma, excess: (alpha - first) * (alpha + first), kappa: F::int(4) * first * gamma }
    }

    /// `D = (v − 1)² + 4γ²`.
    fn distance(&self, u: F) -> F {
        u.square() + (F::int(2) * self.gamma).square()
    }

    /// The greatest `α/√D` for `low ≤ v ≤ high`: an upper bound of Y.
    pub(super) fn most_within(&self, low: F, high: F) -> F {
        let one = F::int(1);
        self.alpha / self.distance((low - one).or_larger(one - high).or_larger(F::int(0))).sqrt()
    }

    /// The cycle at v.
    ///
    /// With `s = sin(ωπ)/ω`, `c = cos ωπ`, ω² = v − γ², N = cosh γπ + c: `vg = (sinh γπ − γs)/N` and `h =
    /// s/N`, whose derivatives are, with `k = (πc − s)/(2ω²N)`, `h′ = k + (π/2) h²` and `(vg)′ = −γk + (π/2) h
    /// vg`.
    fn cycle_at(&self, v: F) -> CycleAt<F> {
        let (one, two, four) = (F::int(1), F::int(2), F::int(4));
        let (gamma, pi, omega) = (self.gamma, F::pi(), one / v.sqrt());
        let half = HalfPeriod::new(omega, gamma * omega);
        let (h, shift) = (half.h / v, half.shift);
        let frequency = v * half.free.square;
        // N e^{−γπ}, where the cosine is negative without the rounding of a difference.
        let n = if half.cosine < F::int(0) {
            omega * half.sine / h
        } else {
            (one + half.decay.square()) / two + half.cosine
        };
        let k = if (frequency * pi.square()).abs() < one {
            half.decay / n * wave_difference(frequency)
        } else {
            (pi * half.cosine / n - h) / (two * frequency)
        };
        let h_slope = k + pi / two * h.square();
        let shift_slope = pi / two * h * shift - gamma * k;
        let g_slope = (shift_slope - shift / v) / v;
        // The first harmonic: 4/π times (1 − v)/D and 2γ/D.
        let u = half.one_minus_square * v;
        let d = (half.stiffness * v).square();
        let (first, damping) = (four / pi / d, two * gamma);
        CycleAt {
            u,
            d,
            g: shift / v - first * damping,
            h: h + first * u,
            g_slope: g_slope + first * two * damping * (u / d),
            h_slope: h_slope - first * (one - two * damping * (damping / d)),
        }
    }

    /// `C`, from D, h and u.
    fn constant(&self, at: &CycleAt<F>) -> F {
        let CycleAt { u, d, h, .. } = *at;
        self.excess + F::int(8) / F::pi() * (u * h) - d * h.square()
    }

    /// `s = √(κ² + 4DC)`.
    fn root(&self, d: F, c: F) -> F {
        (self.kappa.square() + F::int(4) * (d * c.or_larger(F::int(0)))).sqrt()
    }

    /// The root X ≥ 1.
    fn amplitude(&self, d: F, c: F) -> F {
        let one = F::int(1);
        if c > F::int(0) { (F::int(2) * c / (self.kappa + self.root(d, c))).or_larger(one) } else { one }
    }

    /// Y and Φ at a cycle.
    fn work_and_growth(&self, at: &CycleAt<F>) -> (F, F) {
        let CycleAt { u, d, g, h, g_slope, h_slope } = *at;
        let (two, c) = (F::int(2), self.constant(at));
        let (x, s) = (self.amplitude(d, c), self.root(d, c));
        let first = F::int(8) / F::pi();
        let growth =
            first * (h + u * h_slope) - two * (u * (x.square() + h.square()) + d * h * h_slope) - g_slope * s;
        (x - g, growth)
    }

    /// The bounds for `low ≤ v ≤ high`, if not too many poles are near; they are infinite if the interval
    /// contains an undamped pole.
    fn rates(&self, low: F, high: F) -> Option<Rates<F>> {
        let (one, two, three) = (F::int(1), F::int(2), F::int(3));
        let odd = |x: F| two * ((x - one) / two).floor() + one;
        let (from, to) = (low.sqrt(), high.sqrt());
        let first = (odd(from) - F::int(6)).or_larger(three);
        let last = odd(to) + F::int(8);
        if last - first > F::int(2 * HARMONICS) {
            return None;
        }
        let zero = F::int(0);
        // Σ 1/|Z_n|², Σ 1/|Z_n|³ and Σ 1/n|Z_n|³.
        let mut sums = [zero; 3];
        let mut add = |n: F, square: F, cube: F| {
            for (sum, term) in sums.iter_mut().zip([square, cube, cube / n]) {
                *sum = *sum + term;
            }
        };
        let mut n = first;
        while n <= last {
            let pole = n.square();
            let off = (low - pole).or_larger(pole - high).or_larger(zero);
            let z = off.square() + (two * self.gamma * n).square();
            add(n, one / z, one / (z * z.sqrt()));
            n = n + two;
        }
        // The harmonics on either side, |n² − v| = |n − √v| (n + √v): at steps of 2 from the distance e on,
        // Σ 1/(n − √v)² ≤ 1/e² + 1/2e and Σ 1/|n − √v|³ ≤ 1/e³ + 1/4e².
        let mut add_beyond = |n: F, e: F, sum: F| {
            let (square, cube) = (one / e.square() + one / (two * e), one / (e * e.square()));
            add(n, square / sum.square(), (cube + one / (F::int(4) * e.square())) / (sum * sum.square()));
        };
        add_beyond(last + two, last + two - to, last + two + to);
        if first > three {
            add_beyond(three, from - (first - two), from);
        }
        let unit = F::int(4) / F::pi();
        let [square, cube, g_cube] = sums;
        Some(Rates { g_second: two * unit * g_cube, h_slope: unit * square, h_second: two * unit * cube })
    }

    /// Bounds of Φ and of s on an interval of u around a middle.
    fn growth_within(&self, at: &CycleAt<F>, rates: &Rates<F>, u: Span<F>, radius: F) -> (Span<F>, Span<F>) {
        let (two, first) = (F::int(2), F::int(8) / F::pi());
        let near = |value: F, rate: F| Span::around(value, rate * radius);
        let (h, h_slope) = (near(at.h, rates.h_slope), near(at.h_slope, rates.h_second));
        let g_slope = near(at.g_slope, rates.g_second);
        let (u_square, h_square) = (u.square(), h.square());
        let d = u_square.plus(Span::exactly((two * self.gamma).square()));
        let c = Span::exactly(self.excess).plus(u.times(h).scaled(first)).minus(d.times(h_square));
        // X rises with C and falls with D.
        let x = Span::new(self.amplitude(d.high, c.low), self.amplitude(d.low, c.high));
        let s = Span::new(self.root(d.low, c.low), self.root(d.high, c.high));
        let growth = h
            .plus(u.times(h_slope))
            .scaled(first)
            .minus(u.times(x.square().plus(h_square)).plus(d.times(h.times(h_slope))).scaled(two))
            .minus(g_slope.times(s));
        (growth, s)
    }

    /// A v in `(low, high)` with a larger Y than `best`, if there is one: that of the greatest Y, and Y
    /// there. The body slides throughout.
    ///
    /// # Errors
    /// [`Error::SearchBound`] where the bound of the number of intervals is reached.
    pub(super) fn improved(&self, low: F, high: F, best: F) -> Result<Option<F>, Error> {
        let (one, two) = (F::int(1), F::int(2));
        let slack = one + F::int(16) * F::epsilon();
        let mut best = best;
        let mut found: Option<F> = None;
        let low = low.or_larger(F::ratio(1, 2));
        let mut left = if low < high { vec![(low, high)] } else { Vec::new() };
        let mut intervals = 0u32;
        while let Some((low, high)) = left.pop() {
            intervals = intervals.saturating_add(1);
            if intervals > INTERVALS {
                return Err(Error::SearchBound {
                    search: "the best stiffness",
                    omega: written(one / high.sqrt()),
                    alpha: written(self.alpha),
                    phase: written(F::int(0)),
                    bound: "65,536 intervals",
                });
            }
            let middle = low + (high - low) / two;
            if self.most_within(low, high) <= best * slack {
                continue;
            }
            if !(middle > low && middle < high) {
                // For a resonance narrower than the distance of two numbers, the better one of the two is
                // taken.
                for v in [low, high] {
                    let work = self.work_and_growth(&self.cycle_at(v)).0;
                    if work > best {
                        (best, found) = (work, Some(v));
                    }
                }
                continue;
            }
            if let Some(rates) = self.rates(low, high) {
                let at = self.cycle_at(middle);
                let radius = (high - middle).or_larger(middle - low);
                let u = Span::new(low - one, high - one);
                let (growth, s) = self.growth_within(&at, &rates, u, radius);
                let is_monotone = growth.low > F::int(0) || growth.high < F::int(0);
                let (here, _) = self.work_and_growth(&at);
                let reach = here + radius * (growth.size() / s.low);
                if is_monotone {
                    // The end may be the last number before a resonance that is narrower than the distance of
                    // two numbers.
                    let end = if growth.low > F::int(0) { high } else { low };
                    let work = self.work_and_growth(&self.cycle_at(end)).0;
                    if work > best * slack {
                        (best, found) = (work, Some(end));
                    }
                }
                if is_monotone || reach <= best * slack {
                    continue;
                }
                let is_new = found.is_none_or(|v| v <= low || v >= high);
                if is_new
                    && reach <= here * F::ratio(5, 4)
                    && let Some(v) = self.summit(low, high)
                {
                    let work = self.work_and_growth(&self.cycle_at(v)).0;
                    if work > best {
                        (best, found) = (work, Some(v));
                    }
                }
            }
            // The interval nearer to the resonance comes first.
            left.push((middle, high));
            left.push((low, middle));
        }
        Ok(found.map(|v| self.settled(v, best)))
    }

    /// A zero at which Φ falls, if its signs at the ends show one.
    fn summit(&self, low: F, high: F) -> Option<F> {
        let growth = |v: F| self.work_and_growth(&self.cycle_at(v)).1;
        let falls = growth(low) > F::int(0) && growth(high) < F::int(0);
        falls.then(|| root::enclosed(low, high, growth).0)
    }

    /// The zero of Φ next to the best v found: the rounding of Y leaves an error of √ε in v, the rounding of
    /// Φ one of a few ε.
    fn settled(&self, v: F, best: F) -> F {
        let mut off = v * F::epsilon() * F::int(4);
        for _ in 0..F::precision() / 2 {
            if let Some(zero) = self.summit(v - off, v + off) {
                let work = self.work_and_growth(&self.cycle_at(zero)).0;
                return if best <= work * (F::int(1) + F::epsilon() * F::int(1 << 12)) { zero } else { v };
            }
            off = off + off;
        }
        v
    }
}

/// `[π cos ωπ − sin(ωπ)/ω]/2ω²` near ω² = 0: with x = (ωπ)², `π³ Σ_{j ≥ 1} (−x)^{j−1} (−j)/(2j + 1)!`.
fn wave_difference<F: Float>(frequency: F) -> F {
    let pi = F::pi();
    let x = frequency * pi.square();
    let (mut sum, mut term) = (F::int(0), F::ratio(-1, 6));
    for j in 1..i32::try_from(F::precision()).unwrap_or(i32::MAX) {
        let next = sum + term * F::int(j);
        if next == sum {
            break;
        }
        sum = next;
        let n = F::int(2) * F::int(j) + F::int(2);
        term = -(term * x / (n * (n + F::int(1))));
    }
    pi * pi.square() * sum
}

#[cfg(test)]
mod tests;
