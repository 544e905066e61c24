//! The maximum speed within a slide.
//!
//! The acceleration of a slide obeys `f″ + 2ζf′ + f = g` like the velocity, with `g ∝ −sin θ`. Its zeros are
//! found in order with the same proof, and the maximum speed is at one of them or at an end.
//!
//! * For Ω < 1/2 there can be as many zeros as the free periods in the slide, but only the neighbourhoods of the
//!   crests of the forced wave matter; their width depends on the size of the free wave (`crests`). Slides with
//!   few zeros are searched as a whole, except for Ω < 1/4 with a damper, whose motion takes longer to evaluate.
//! * Long slides with Ω > 2 or ζ ≥ 1/2, and those with many zeros around a crest, are searched like the
//!   closed-form cycle.

mod crests;

use super::cover::Cover;
use super::next_zero;
use super::search::{FoundZero, Verdict, ZeroSearch};
use crate::float::Float;
use crate::motion::broken::Broken;
use crate::motion::slide::Slide;
use crate::motion::slide::equation::Equation;
use crate::motion::slide::motion::Motion;

/// The fastest instant of a slide: its natural time and the velocity there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Fastest<F> {
    pub(crate) phi: F,
    pub(crate) w: F,
}

impl<F: Float> Slide<F> {
    /// The maximum speed for natural times from 0 to `end`, where the motion is `arrival`.
    ///
    /// # Errors
    /// [`crate::Error::SearchBound`].
    pub(crate) fn fastest(&self, end: F, arrival: &Motion<F>) -> Result<Fastest<F>, Broken> {
        let (zero, one, two, four) = (F::int(0), F::int(1), F::int(2), F::int(4));
        let Equation { omega, damping, .. } = self.equation;
        let mut best = Fastest { phi: zero, w: self.w };
        let start = self.motion_at_start();
        let is_long = end > four * F::pi() || (omega * four < one && self.equation.is_damped());
        if omega * two < one
            && is_long
            && let Some(parts) = self.around_crests(end, arrival, &mut best)
        {
            for (from, to) in parts {
                if from < to {
                    let motion = |phi: F| if phi >= end { *arrival } else { self.motion(phi) };
                    let first = if from > zero { motion(from) } else { start };
                    self.scan((from, &first), (to, &motion(to)), &mut best)?;
                }
            }
            return Ok(best);
        }
        let middle = omega * two >= one && omega <= two && damping < one;
        if !middle && end * one.or_larger(omega) > F::int(16) {
            return Ok(self.fastest_of_waves(end, arrival));
        }
        self.scan((zero, &start), (end, arrival), &mut best)?;
        Ok(best)
    }

    /// Finds every zero of the acceleration between two instants of known motion, and includes these instants
    /// in the comparison.
    ///
    /// # Errors
    /// [`crate::Error::SearchBound`].
    fn scan(
        &self,
        (from, first): (F, &Motion<F>),
        (to, last): (F, &Motion<F>),
        best: &mut Fastest<F>,
    ) -> Result<(), Broken> {
        let zero = F::int(0);
        let sign = self.direction.sign::<F>();
        let mut consider = |phi: F, w: F| {
            if sign * w > sign * best.w {
                *best = Fastest { phi, w };
            }
        };
        consider(from, first.w);
        consider(to, last.w);
        let noise =
            F::int(4) * F::epsilon() * self.velocity_scale() * F::int(1).or_larger(self.equation.omega);
        let (mut at, mut motion) = (from, *first);
        // At an extremum to within rounding, or at a release, the sign of the jerk decides.
        let mut from_zero = motion.acceleration.abs() <= noise;
        let mut speeds_up = sign * if from_zero { motion.jerk } else { motion.acceleration } > zero;
        for _ in 0..MOST_EXTREMA {
            let side = if speeds_up { sign } else { -sign };
            let search = self.acceleration_search(at, to, side, from_zero, noise);
            let jet = |m: &Motion<F>| m.acceleration_jet(&self.equation, side);
            let verdict = next_zero(&search, jet(&motion), |phi| {
                let m = if at + phi >= to { *last } else { self.motion(at + phi) };
                (jet(&m), m)
            });
            let found = match verdict {
                Verdict::Zero(found) => found,
                Verdict::Clear(_) => return Ok(()),
                Verdict::Lost(_) => break,
            };
            let FoundZero { at: passed, step, motion: m, .. } = found;
            at = at + passed + step;
            if at >= to {
                return Ok(());
            }
            let (half, third) = (step / F::int(2), step / F::int(3));
            let (fourth, _) = m.higher(&self.equation);
            let w = m.w + step * (m.acceleration + half * (m.jerk + third * fourth));
            if speeds_up {
                consider(at, w);
            }
            motion = Motion { acceleration: zero, w, jerk: m.jerk + step * fourth, ..m };
            (speeds_up, from_zero) = (!speeds_up, true);
        }
        Err(self.lost("the greatest speed"))
    }

    /// The search for the first zero of the acceleration from φ = `at` on; `side` is the sign of the
    /// acceleration there.
    #[inline]
    fn acceleration_search(&self, at: F, to: F, side: F, from_zero: bool, noise: F) -> ZeroSearch<'_, F> {
        let omega = self.equation.omega;
        // −sin θ = cos(θ + π/2)
        let shifted = self.start.advanced(omega * at + F::pi() / F::int(2));
        ZeroSearch {
            omega,
            pace: self.equation.pace(),
            cover: Cover::new(self.equation.vibration()),
            waves: None,
            angle: shifted.angle(),
            helping: shifted.is_even() == (side > F::int(0)),
            from_zero,
            limit: Some(to - at),
            // The end is evaluated first, because the motion is known there.
            hint: to - at,
            safe: None,
            noise,
            short_noise: None,
        }
    }
}

/// Two fast periods hold four extrema; a slide with Ω in [1/2, 2] at most six.
const MOST_EXTREMA: u32 = 16;

#[cfg(test)]
mod tests {
    use crate::Ratios;
    use crate::motion::trajectory::Body;
    use crate::motion::{State, Trajectory};

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
            for phase in Trajectory::new(Ratios::new(omega, alpha).unwrap(), start)
                .unwrap()
                .take(12)
                .map(Result::unwrap)
            {
                let Body::Slide(slide, zero) = &phase.body else { continue };
                // The whole slide, and parts that end earlier.
                for share in [1.0, 0.83, 0.61, 0.37, 0.12] {
                    let end = zero.phi * share;
                    let last = if share == 1.0 { slide.motion_at(zero) } else { slide.motion(end) };
                    let fastest = slide.fastest(end, &last).unwrap();
                    let size = fastest.w.abs().max(1.0);
                    assert!((slide.motion(fastest.phi).w - fastest.w).abs() < 1e-13 * size);
                    let n = 8_000;
                    for i in 0..=n {
                        let w = slide.motion(end * f64::from(i) / f64::from(n)).w;
                        assert!(
                            w.abs() <= fastest.w.abs() + 1e-13,
                            "Ω = {omega}: {w} {fastest:?} in {phase:?}"
                        );
                    }
                }
            }
        }
    }
}
