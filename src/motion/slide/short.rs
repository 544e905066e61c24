//! The motion of a short slide, by Taylor's series.
//!
//! A body that has just been released starts with zero velocity and zero acceleration, and reverses after
//! `w = αΩ [cos θ_i · C − sin θ_i · S]` has increased and decreased by no more than a small fraction of `αΩφ`.
//! Where the force hardly exceeds friction the slide is short, and the closed forms of C and S, which consist
//! of functions of order φ, lose all its digits: at α = 1 + 1e-14 the zero was wrong by half its place. The
//! derivatives at the start are known to full relative accuracy, each from the equation of motion:
//!
//! ```text
//! w⁽ⁿ⁺²⁾ = (αΩ cos(θ_i + Ωφ))⁽ⁿ⁾ − w⁽ⁿ⁾ − 2ζw⁽ⁿ⁺¹⁾,   w⁽⁰⁾ = w_i,   w⁽¹⁾ = a_i
//! ```

use super::Slide;
use super::equation::Equation;
use super::motion::Motion;
use crate::float::Float;

impl<F: Float> Slide<F> {
    /// Whether φ is short compared with both periods and the decay: `max(1, Ω, 4ζ) φ < 1/8`.
    #[inline]
    pub(crate) fn is_short(&self, phi: F) -> bool {
        let (one, eight) = (F::int(1), phi * F::int(8));
        let is_slow = eight * F::int(2) * self.equation.damping < one;
        eight < one && eight * self.equation.omega < one && is_slow
    }

    /// The motion at a short φ.
    ///
    /// From the third derivative of w on each term is a `(max(1, Ω) φ)²/n²`-th of an earlier one, or with
    /// damping a `4ζφ/n`-th. The series therefore has **at most PRECISION terms**, about 12 at f64.
    pub(crate) fn short(&self, phi: F) -> Motion<F> {
        let (zero, one) = (F::int(0), F::int(1));
        let Equation { omega, damping, .. } = self.equation;
        let (sine, cosine) = self.sin_cos_start();
        // f and f′ of f = αΩ cos θ; its higher derivatives are −Ω² times f and f′.
        let rate = self.equation.alpha * omega;
        let (mut force_rate, mut next_force_rate) = (rate * cosine, -(rate * omega * sine));
        let (mut derivative, mut next) = (self.w, self.acceleration);
        let (mut travelled, mut w, mut acceleration) = (zero, zero, zero);
        let mut power = one;
        let mut reach = one;
        for n in 1..=F::precision() as i32 {
            let longer = power * phi / F::int(n);
            travelled = travelled + derivative * longer;
            w = w + derivative * power;
            acceleration = acceleration + next * power;
            (derivative, next) = (next, force_rate - derivative - damping * next);
            (force_rate, next_force_rate) = (next_force_rate, -(omega.square() * force_rate));
            power = longer;
            // At least one of the first four terms is not small.
            if n > 3 {
                reach = reach / (F::int(8) * F::int(n));
                if reach < F::epsilon() / F::int(64) {
                    break;
                }
            }
        }
        let (sin_drive, cos_drive) = (omega * phi).sin_cos();
        let jerk = rate * (cosine * cos_drive - sine * sin_drive) - w;
        Motion {
            x: self.x + travelled,
            w,
            acceleration,
            jerk: jerk - damping * acceleration,
            force: self.equation.alpha * (sine * cos_drive + cosine * sin_drive),
            rotation: self.equation.free_waves(phi),
        }
    }

    /// The greatest size of the terms of w at a short φ, as coefficients of 1, φ, φ², φ³.
    #[inline]
    pub(crate) fn short_velocity_scale(&self) -> [F; 4] {
        let (sine, cosine) = self.sin_cos_start();
        let omega = self.equation.omega;
        let rate = self.equation.alpha * omega;
        [self.w.abs(), self.acceleration.abs(), (rate * cosine).abs(), (rate * omega * sine).abs()]
    }
}

#[cfg(test)]
mod tests {
    use crate::Ratios;
    use crate::motion::drive_phase::DrivePhase;
    use crate::motion::slide::equation::Equation;
    use crate::motion::slide::{Direction, Slide};

    fn slide(omega: f64, theta: f64, w: f64) -> Slide<f64> {
        let equation = Equation::new(Ratios::new(omega, 1.7).unwrap());
        Slide::new(equation, DrivePhase::of(theta).unwrap(), -0.3, w, Direction::Forward)
    }

    #[test]
    fn it_is_the_closed_form() {
        for omega in [1e-3f64, 0.3, 1.0, 1.2, 30.0, 1e4] {
            for w in [0.0, 0.4] {
                let s = slide(omega, 0.3, w);
                for i in 1..=64 {
                    let phi = f64::from(i) / 512.0 / omega.max(1.0);
                    let (series, closed) = (s.short(phi), s.motion_of(&s.equation.waves(phi)));
                    let close = |a: f64, b: f64, size: f64| {
                        assert!((a - b).abs() <= 4e-15 * size, "Ω = {omega}, φ = {phi}: {a:e} {b:e}");
                    };
                    close(series.x, closed.x, 1.0);
                    close(series.w, closed.w, w + 2.0 * phi * omega.max(1.0));
                    close(series.acceleration, closed.acceleration, 1.0 + omega);
                    close(series.jerk, closed.jerk, 1.0 + omega);
                    close(series.force, closed.force, 1.0);
                    close(series.rotation.0, phi.sin(), phi);
                    close(series.rotation.1, phi.cos(), 1.0);
                }
            }
        }
    }

    /// Compares `x − x_i` and w of a slide released near the crest of the force with their first terms.
    #[test]
    fn a_slide_just_let_go_keeps_its_digits() {
        for omega in [1e-3f64, 0.7, 1.0, 768.0] {
            let (alpha, early) = (1.0f64, 2f64.powi(-24));
            let equation = Equation::new(Ratios::new(omega, alpha).unwrap());
            let start = DrivePhase::of(std::f64::consts::FRAC_PI_2 - early).unwrap();
            let s = Slide::released(equation, start, 0.0, Direction::Forward);
            // With the phase h = Ωφ: w = α (e h²/2 − h³/6) and x = α (e h³/6 − h⁴/24)/Ω², up to terms smaller
            // by h².
            for part in [0.1, 1.0, 2.9, 3.1] {
                let h = part * early;
                let m = s.motion(h / omega);
                let w = alpha * (early * h * h / 2.0 - h * h * h / 6.0) / omega;
                let x = alpha * (early * h.powi(3) / 6.0 - h.powi(4) / 24.0) / omega.powi(2);
                assert!((m.w / w - 1.0).abs() < 1e-6, "Ω = {omega}: {:e} for {w:e}", m.w);
                assert!((m.x / x - 1.0).abs() < 1e-6, "Ω = {omega}: {:e} for {x:e}", m.x);
            }
            let zero = s.velocity_zero(1.0).unwrap();
            assert!((zero.phi * omega / (3.0 * early) - 1.0).abs() < 1e-6 && !zero.grazes);
        }
    }
}
