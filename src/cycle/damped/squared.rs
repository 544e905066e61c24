//! The square of a velocity, integrated by its power series: where the closed forms of the damper's work
//! would cancel.

use crate::float::Float;
use alloc::vec::Vec;

/// A velocity w at one time, and the drive upon it: `w″ + 2ζw′ + w = f`, `f″ = −Ω²f`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct DrivenVelocity<F> {
    pub(crate) omega: F,
    /// 2ζ.
    pub(crate) damping: F,
    /// w and w′.
    pub(crate) velocity: (F, F),
    /// f and f′.
    pub(crate) force: (F, F),
}

impl<F: Float> DrivenVelocity<F> {
    /// `∫ w² dt` from h before this time to h after it, for `max(1, Ω, 2ζ) h` not above 2.
    ///
    /// With `c_n = w⁽ⁿ⁾hⁿ/n!` and `g_n = f⁽ⁿ⁾hⁿ/n!`
    ///
    /// ```text
    /// c_{n+2} = h² (g_n − c_n)/((n+1)(n+2)) − 2ζh c_{n+1}/(n+2),   g_{n+2} = −(Ωh)² g_n/((n+1)(n+2)),
    /// ∫ w² dt = 2h Σ e_n/(n + 1) over even n,   e_n = Σ c_i c_{n−i}.
    /// ```
    ///
    /// Of w, w′, f and f′ one at least is not small, so that from n = 6 on `e_n` is at most of the order of
    /// `(2 max(1, Ω, 2ζ) h)ⁿ⁻⁶/n!` of the largest.
    pub(crate) fn square_around(&self, half: F) -> F {
        let (one, two) = (F::int(1), F::int(2));
        let pace = two * half * one.or_larger(self.omega).or_larger(self.damping);
        let (square, fall) = (half.square(), self.damping * half);
        let turn = (self.omega * half).square();
        let (mut g, mut next_g) = (self.force.0, self.force.1 * half);
        let (mut c, mut next) = (self.velocity.0, self.velocity.1 * half);
        let mut series = Vec::with_capacity(32);
        let (mut sum, mut reach) = (F::int(0), one);
        // The factorial wins long before the last.
        for n in 0..F::precision().saturating_add(32) {
            series.push(c);
            let (first, second) = (F::from_f64(f64::from(n) + 1.0), F::from_f64(f64::from(n) + 2.0));
            if n % 2 == 0 {
                // Each product is there twice, but that of the middle one with itself.
                let pairs = series.iter().zip(series.iter().rev()).take(series.len() / 2);
                let once = pairs.fold(F::int(0), |sum, (a, b)| sum + *a * *b);
                let middle = series.get(series.len() / 2).map_or(once, |c| c.square());
                sum = sum + (two * once + middle) / first;
            }
            if n > 6 {
                reach = reach * pace / first;
                if reach < F::epsilon() / F::int(64) {
                    break;
                }
            }
            let both = first * second;
            (c, next) = (next, square * (g - c) / both - fall * next / second);
            (g, next_g) = (next_g, -(turn * g / both));
        }
        two * half * sum
    }
}

#[cfg(test)]
mod tests {
    use super::DrivenVelocity;

    /// A drive alone and a free vibration alone, by their antiderivatives.
    #[test]
    fn it_is_the_antiderivative() {
        for half in [1e-3f64, 0.1, 0.8, 1.5] {
            for omega in [0.01, 0.4, 1.0, 1.3] {
                // w = sin(Ωt + 0.4) without damping
                let (sine, cosine) = 0.4f64.sin_cos();
                let stiffness = 1.0 - omega * omega;
                let driven = DrivenVelocity {
                    omega,
                    damping: 0.0,
                    velocity: (sine, omega * cosine),
                    force: (stiffness * sine, stiffness * omega * cosine),
                };
                let integral = half - 0.8f64.cos() * (2.0 * omega * half).sin() / (2.0 * omega);
                assert!((driven.square_around(half) / integral - 1.0).abs() < 1e-14, "{omega} {half}");
            }
            // w = e^{−t} at critical damping.
            let free = DrivenVelocity { omega: 1.0, damping: 2.0, velocity: (1.0, -1.0), force: (0.0, 0.0) };
            let off = free.square_around(half) / (2.0 * half).sinh() - 1.0;
            assert!(off.abs() < 1e-14, "{half}: {off:e}");
        }
    }
}
