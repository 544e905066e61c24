//! The greatest speed within a slide.
//!
//! The acceleration of a slide obeys `f″ + f = g` as the velocity does, with `g ∝ −sin θ`: its zeros are found with the
//! same proof, one after the other, and the greatest speed is at one of them or at an end. Outside 1/2 ≤ Ω ≤ 2 there can
//! be as many as fast periods in the slide; but a point that lies a fast period or more from where the slow wave is greatest
//! is exceeded by the one a fast period closer, so that only the neighbourhoods of that crest and of the ends count.

use super::event::{Found, Jet, Search, Verdict, next_zero};
use super::slide::{Motion, Slide};
use crate::float::Float;

/// The fastest instant of a slide: its natural time and the velocity there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Fastest<F> {
    pub(crate) phi: F,
    pub(crate) w: F,
}

impl<F: Float> Slide<F> {
    /// The greatest speed for natural times from 0 to `end`.
    pub(crate) fn fastest(&self, end: F) -> Fastest<F> {
        let (zero, one, two) = (F::int(0), F::int(1), F::int(2));
        let omega = self.equation.omega;
        let mut best = Fastest { phi: zero, w: self.w };
        if omega * two >= one && omega <= two {
            self.scan(zero, end, &mut best);
            return best;
        }
        let fast = two * F::pi() / one.or_larger(omega);
        let crest = self.slow_crest();
        for (from, to) in [(zero, fast), (crest - fast, crest + fast), (end - fast, end)] {
            let from = from.or_larger(zero);
            let to = if to < end { to } else { end };
            if from < to {
                self.scan(from, to, &mut best);
            }
        }
        best
    }

    /// The natural time of the crest of the slow wave that lies in the slide, if one does.
    fn slow_crest(&self) -> F {
        let (one, two) = (F::int(1), F::int(2));
        let omega = self.equation.omega;
        let (sine, cosine) = self.start.sin_cos();
        let sign = self.direction.sign::<F>();
        let crest = if omega < one {
            // s cos θ = 1
            (-(sign * sine)).atan2(sign * cosine) / omega
        } else {
            let forced = self.equation.alpha * omega / ((one - omega) * (one + omega));
            let rate = self.acceleration + forced * omega * sine;
            (sign * rate).atan2(sign * (self.w - forced * cosine))
        };
        let period = two * F::pi() / if omega < one { omega } else { one };
        if crest < F::int(0) { crest + period } else { crest }
    }

    /// Every zero of the acceleration in [from, to], and the ends.
    fn scan(&self, from: F, to: F, best: &mut Fastest<F>) {
        let zero = F::int(0);
        let sign = self.direction.sign::<F>();
        let mut consider = |phi: F, w: F| {
            if sign * w > sign * best.w {
                *best = Fastest { phi, w };
            }
        };
        let starts = from == zero;
        let mut at = from;
        let first = self.motion(at);
        consider(at, first.w);
        let mut motion = if starts {
            Motion { acceleration: self.acceleration, jerk: self.jerk_at_start(), ..first }
        } else {
            first
        };
        let mut speeds_up = sign * motion.acceleration > zero;
        let mut from_zero = false;
        if motion.acceleration == zero {
            (speeds_up, from_zero) = (true, true);
        }
        for _ in 0..MOST_EXTREMA {
            let side = if speeds_up { sign } else { -sign };
            let Verdict::Zero(found) = self.acceleration_zero(at, to, &motion, side, from_zero) else {
                break;
            };
            let Found { at: passed, step, motion: m, .. } = found;
            at = at + passed + step;
            if at >= to {
                break;
            }
            let half = step / F::int(2);
            let w = m.w + step * (m.acceleration + half * m.jerk);
            if speeds_up {
                consider(at, w);
            }
            // The jerk that follows is all that the next search starts from.
            motion = Motion { acceleration: zero, w, ..m };
            (speeds_up, from_zero) = (!speeds_up, true);
        }
        consider(to, self.motion(to).w);
    }

    /// The first zero after φ = `at` of the acceleration, whose sign there is `side`.
    fn acceleration_zero(
        &self,
        at: F,
        to: F,
        motion: &Motion<F>,
        side: F,
        from_zero: bool,
    ) -> Verdict<F, Motion<F>> {
        let (one, omega) = (F::int(1), self.equation.omega);
        let quarter = F::pi() / F::int(2);
        // −sin θ = cos(θ + π/2)
        let shifted = self.start.advanced(omega * at + quarter);
        let jet = |m: &Motion<F>| Jet {
            value: side * m.acceleration,
            first: side * m.jerk,
            second: -(side * (omega.square() * m.force + m.acceleration)),
        };
        let search = Search {
            omega,
            angle: shifted.angle(),
            helping: shifted.is_even() == (side > F::int(0)),
            from_zero,
            limit: Some(to - at),
            hint: quarter / one.or_larger(omega),
            safe: None,
            noise: F::int(4) * F::epsilon() * self.velocity_scale() * one.or_larger(omega),
        };
        next_zero(&search, jet(motion), |phi| {
            let m = self.motion(at + phi);
            (jet(&m), m)
        })
    }
}

/// Two fast periods hold four extrema; a slide with Ω in [1/2, 2] at most six.
const MOST_EXTREMA: u32 = 16;

#[cfg(test)]
mod tests {
    use crate::Ratios;
    use crate::exact::trajectory::Body;
    use crate::exact::{State, Trajectory};

    #[test]
    fn no_sample_is_faster() {
        for (omega, alpha) in [
            (0.03f64, 3.0f64),
            (0.1, 3.0),
            (0.23, 30.0),
            (0.4, 9.0),
            (0.5, 4.0),
            (0.7, 2.0),
            (1.3, 2.0),
            (2.5, 3.0),
            (40.0, 50.0),
        ] {
            let start = State::new(0.3, 4.0, -9.0 / omega).unwrap();
            for phase in Trajectory::new(Ratios::new(omega, alpha).unwrap(), start).unwrap().take(12) {
                let Body::Slide(slide, zero) = &phase.body else { continue };
                let fastest = slide.fastest(zero.phi);
                assert!((slide.motion(fastest.phi).w - fastest.w).abs() < 1e-13 * fastest.w.abs().max(1.0));
                let n = 20_000;
                for i in 0..=n {
                    let w = slide.motion(zero.phi * f64::from(i) / f64::from(n)).w;
                    assert!(w.abs() <= fastest.w.abs() + 1e-13, "Ω = {omega}: {w} {fastest:?} in {phase:?}");
                }
            }
        }
    }
}
