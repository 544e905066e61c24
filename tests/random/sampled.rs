//! The motion by dense sampling: the textbook solution of a slide, sampled 64 times in each period of its
//! faster wave.
//!
//! It shares no code with the library: it uses amplitudes of the forced and the free wave, signs of samples,
//! and bisection.

#![allow(dead_code, reason = "each test takes what it needs")]

use std::f64::consts::{PI, TAU};

/// A slide from (θ, x, w = x′/ω_n) in the direction s: `w = F cos θ + a cos φ − b sin φ`. With damping, the
/// forced wave also has a lag δ, `x = A sin(θ − δ) − s + e^{−ζφ} [b cos dφ + (a + ζb) sin(dφ)/d]`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Slide {
    pub(crate) omega: f64,
    pub(crate) zeta: f64,
    lag: f64,
    pub(crate) forced: f64,
    pub(crate) a: f64,
    pub(crate) b: f64,
    pub(crate) theta: f64,
    pub(crate) sign: f64,
}

impl Slide {
    pub(crate) fn new(omega: f64, alpha: f64, (theta, x, w): (f64, f64, f64), sign: f64) -> Self {
        let forced = alpha / ((1.0 - omega) * (1.0 + omega));
        let (sine, cosine) = theta.sin_cos();
        let (a, b) = (w - forced * omega * cosine, x + sign - forced * sine);
        Self { omega, zeta: 0.0, lag: 0.0, forced, a, b, theta, sign }
    }

    pub(crate) fn damped([omega, zeta, alpha]: [f64; 3], (theta, x, w): (f64, f64, f64), sign: f64) -> Self {
        if zeta == 0.0 {
            return Self::new(omega, alpha, (theta, x, w), sign);
        }
        let (damper, spring) = (2.0 * zeta * omega, (1.0 - omega) * (1.0 + omega));
        let (forced, lag) = (alpha / damper.hypot(spring), damper.atan2(spring));
        let (sine, cosine) = (theta - lag).sin_cos();
        let (a, b) = (w - forced * omega * cosine, x + sign - forced * sine);
        Self { omega, zeta, lag, forced, a, b, theta, sign }
    }

    /// Displacement and velocity of the free wave.
    fn free(&self, phi: f64) -> (f64, f64) {
        let (a, b, zeta) = (self.a, self.b, self.zeta);
        if zeta == 0.0 {
            let (sine, cosine) = phi.sin_cos();
            return (a * sine + b * cosine, a * cosine - b * sine);
        }
        let d = (1.0 - zeta * zeta).abs().sqrt();
        if zeta < 1.0 {
            let (decay, (sine, cosine)) = ((-zeta * phi).exp(), (d * phi).sin_cos());
            let x = decay * (b * cosine + (a + zeta * b) * sine / d);
            return (x, decay * (a * cosine - (b + zeta * a) * sine / d));
        }
        // p e^{−t/(ζ + d)} + (b − p) e^{−(ζ + d)t}
        let (slow, fast) = (1.0 / (zeta + d), zeta + d);
        let p = (a + fast * b) / (2.0 * d);
        let (e, f) = (p * (-slow * phi).exp(), (b - p) * (-fast * phi).exp());
        (e + f, -(slow * e + fast * f))
    }

    /// The speed in the direction of the slide after the natural time φ.
    pub(crate) fn speed(&self, phi: f64) -> f64 {
        let drive = self.forced * self.omega * (self.theta - self.lag + self.omega * phi).cos();
        self.sign * (drive + self.free(phi).1)
    }

    fn x(&self, phi: f64) -> f64 {
        let drive = self.forced * (self.theta - self.lag + self.omega * phi).sin();
        drive - self.sign + self.free(phi).0
    }

    /// The size of the terms of the velocity.
    pub(crate) fn size(&self) -> f64 {
        (self.forced * self.omega).abs() + self.a.abs() + self.b.abs()
    }

    /// A sixty-fourth of the shorter period.
    pub(crate) fn step(&self) -> f64 {
        TAU / 64.0 / self.omega.max(1.0).max(2.0 * self.zeta)
    }

    /// The first zero of the speed, if it is before `limit`.
    fn first_zero(&self, limit: f64) -> Option<f64> {
        let h = self.step();
        let (mut before, mut last) = (0.0, self.speed(0.0).max(0.0));
        let mut phi = 0.0;
        while phi < limit {
            let next = phi + h;
            let now = self.speed(next);
            if now < 0.0 {
                return self.crossing(phi, next);
            }
            // A sample below both its neighbours: search the minimum between them.
            if last < before && last <= now && last < 0.02 * self.size() {
                let (mut low, mut high) = (phi - h, next);
                while high - low > 1e-7 * h {
                    let (c, d) = (low + 0.4 * (high - low), low + 0.6 * (high - low));
                    (low, high) = if self.speed(c) < self.speed(d) { (low, d) } else { (c, high) };
                }
                if self.speed(low) < 0.0 {
                    return self.crossing(phi - h, low);
                }
            }
            (before, last, phi) = (last, now, next);
        }
        None
    }

    fn crossing(&self, low: f64, high: f64) -> Option<f64> {
        let (mut low, mut high) = (low, high);
        // The slide may begin at rest: find the first instant at which it moves, if there is one.
        if low == 0.0 {
            let mut start = high / 2.0;
            while self.speed(start) <= 0.0 {
                (high, start) = (start, start / 2.0);
                if start < 1e-9 * self.step() {
                    return Some(0.0);
                }
            }
            low = start;
        }
        for _ in 0..60 {
            let middle = (low + high) / 2.0;
            if self.speed(middle) > 0.0 { low = middle } else { high = middle }
        }
        Some(high)
    }
}

/// Stops and velocity zeros in a cycle of the periodic motion through (θ, x, w), counted from the middle of a
/// slide.
pub(crate) fn counts(omega: f64, alpha: f64, start: (f64, f64, f64)) -> (u32, u32) {
    damped_counts([omega, 0.0, alpha], start)
}

/// The same at (Ω, ζ, α).
pub(crate) fn damped_counts([omega, zeta, alpha]: [f64; 3], start: (f64, f64, f64)) -> (u32, u32) {
    let (mut theta, mut x, mut w) = start;
    let (mut stops, mut zeros) = (0, 0);
    let mut seam: Option<f64> = None;
    for _ in 0..10_000_000 {
        let sign = if w != 0.0 {
            w.signum()
        } else {
            let force = alpha * theta.sin() - x;
            if force.abs() > 1.0 + 1e-13 * (1.0 + alpha + x.abs()) {
                force.signum()
            } else {
                let (release, sign) = release(alpha, theta, x);
                if seam.is_some_and(|seam| theta > seam + TAU) {
                    break;
                }
                // A stop shorter than a millionth of the natural unit of time is rounding.
                if release - theta > 1e-6 * omega.min(1e-3) {
                    stops += u32::from(seam.is_some());
                }
                theta = release;
                sign
            }
        };
        let slide = Slide::damped([omega, zeta, alpha], (theta, x, w), sign);
        let longest = PI * (1.0 + 2.0 / omega) * if zeta > 0.3 { 100.0 * (1.0 + zeta) } else { 2.0 };
        let phi = slide.first_zero(longest).expect("every slide ends");
        if zeros == 0 && seam.is_none() && w == 0.0 {
            seam = Some(theta + omega * phi / 2.0);
        }
        (theta, x, w) = (theta + omega * phi, slide.x(phi), 0.0);
        match seam {
            Some(seam) if theta > seam + TAU => break,
            Some(_) => zeros += 1,
            None => {}
        }
    }
    (stops, zeros)
}

/// The phase at which friction yields to α sin θ at the place x, and the direction.
fn release(alpha: f64, theta: f64, x: f64) -> (f64, f64) {
    let later = |angle: f64| angle + TAU * ((theta - 1e-12 - angle) / TAU).ceil();
    let forward = if x + 1.0 < alpha { later(((x + 1.0) / alpha).asin()) } else { f64::INFINITY };
    let backward = if 1.0 - x < alpha { later(PI - ((x - 1.0) / alpha).asin()) } else { f64::INFINITY };
    if forward < backward { (forward.max(theta), 1.0) } else { (backward.max(theta), -1.0) }
}
