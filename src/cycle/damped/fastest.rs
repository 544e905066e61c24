//! The peak velocity of the half cycle, or of any slide, among however many maxima.
//!
//! The time is divided until each part is decided. Both ends of a part, with bounds of the derivatives that
//! hold from its left end on (the energies of free vibration and of its derivatives decrease), lead to one of
//! three conclusions: no velocity in the part exceeds the greatest one found, or its slope has one sign, or
//! the velocity is concave, so that there is at most one maximum, a bracketed root of the acceleration. There
//! is no sampling and no counting of maxima, for any Ω and ζ; the result is proved up to rounding.

use super::rising::{Moment, Vibration};
use crate::float::{Float, at_precision};
use crate::root::{newton, newton_within};
use alloc::vec;

/// The time τ of the peak velocity.
#[inline(never)]
pub(crate) fn fastest_time<F: Float>(motion: &Vibration<F>) -> F {
    let slope = |tau: F| {
        let [_, slope, curvature] = motion.velocity(&motion.at(tau));
        (slope, curvature)
    };
    let start = if const { F::PRECISION <= f64::MANTISSA_DIGITS } {
        FastestSearch::new(motion).run()
    } else {
        let motion = *motion;
        at_precision!(narrowed, <F>(motion: Vibration<F>) -> F, |there, back: G| {
            back(fastest_time::<G>(&motion.map(there)))
        })
    };
    let polished = newton(start, F::int(0), motion.end, slope);
    // Where the velocity is so flat that a step goes astray, the start is as good as the type can tell.
    let speed = |tau: F| motion.velocity(&motion.at(tau))[0];
    let start_bound = motion.at(F::int(0)).free.velocity_bound();
    let noise = F::int(64) * F::epsilon() * (motion.swing() + start_bound);
    let time = if speed(polished) + noise >= speed(start) { polished } else { start };
    time.implicit_root(slope)
}

/// The velocity at one end of a part.
#[derive(Clone, Copy)]
struct EndVelocity<F> {
    at: Moment<F>,
    velocity: [F; 3],
    driven: F,
}

struct FastestSearch<'a, F> {
    motion: &'a Vibration<F>,
    best: EndVelocity<F>,
    /// The rounding error of the velocity.
    noise: F,
    swing: F,
    /// When the drive alone is fastest for the first time.
    turn: F,
}

impl<'a, F: Float> FastestSearch<'a, F> {
    fn new(motion: &'a Vibration<F>) -> Self {
        let (two, start) = (F::int(2), end(motion, F::int(0)));
        let swing = motion.swing();
        let noise = two * F::epsilon() * (swing + start.at.free.velocity_bound());
        let (a, h) = motion.driven;
        let crest = F::pi() / two + h.atan2(a);
        let crest = if crest < F::int(0) { crest + two * F::pi() } else { crest };
        Self { motion, best: start, noise, swing, turn: crest / motion.omega }
    }

    fn run(mut self) -> F {
        let motion = self.motion;
        // Where the drive alone is fastest, and the crests of the free vibration around it.
        let middle = if self.turn < motion.end { self.turn } else { motion.end / F::int(2) };
        let summit = self.consider(middle);
        if motion.free.swings() {
            let (v, a, d) = (summit.at.free.v, summit.at.free.a, motion.free.frequency);
            let crest = ((a + motion.free.zeta * v) / d).atan2(v);
            for turns in [-1, 0, 1] {
                let tau = summit.at.tau + (crest + F::int(2 * turns) * F::pi()) / d;
                if tau > F::int(0) && tau < motion.end {
                    self.consider(tau);
                }
            }
        }
        let (first, last) = (end(motion, F::int(0)), self.consider(motion.end));
        let mut parts = vec![(summit, last), (first, summit)];
        while let Some((left, right)) = parts.pop() {
            if self.is_decided(&left, &right) {
                continue;
            }
            let middle = left.at.tau + (right.at.tau - left.at.tau) / F::int(2);
            if middle <= left.at.tau || middle >= right.at.tau {
                continue;
            }
            let middle = self.consider(middle);
            parts.extend([(middle, right), (left, middle)]);
        }
        self.best.at.tau
    }

    /// The velocity at τ, kept if it is the greatest.
    fn consider(&mut self, tau: F) -> EndVelocity<F> {
        let found = end(self.motion, tau);
        if found.velocity[0] > self.best.velocity[0] {
            self.best = found;
        }
        found
    }

    /// Whether the part contains no greater maximum, or its maximum has been found.
    fn is_decided(&mut self, left: &EndVelocity<F>, right: &EndVelocity<F>) -> bool {
        let (zero, two, omega) = (F::int(0), F::int(2), self.motion.omega);
        let half = (right.at.tau - left.at.tau) / two;
        let least = self.best.velocity[0] + self.noise;
        // No more than the drive alone and the free vibration give.
        let turns = |tau: F| (omega * (tau - self.turn) / (two * F::pi())).floor();
        let driven = if self.motion.whole.is_some() || turns(left.at.tau) < turns(right.at.tau) {
            self.swing
        } else {
            left.driven.or_larger(right.driven)
        };
        if driven + left.at.free.velocity_bound() <= least {
            return true;
        }
        // Bounds of |x‴| and |x⁗| in the part.
        let bend = self.swing * omega.square() + left.at.free.acceleration_bound();
        let change = self.swing * omega.square() * omega + left.at.free.jerk_bound();
        let ([v, slope, second], [w, slope_right, second_right]) = (left.velocity, right.velocity);
        let rise = |v: F, slope: F, second: F| {
            let straight = v + slope.or_larger(zero) * half;
            let by_bend = straight + bend * half.square() / two;
            let by_change = straight
                + second.or_larger(zero) * half.square() / two
                + change * half.square() * half / F::int(6);
            if by_change < by_bend { by_change } else { by_bend }
        };
        if rise(v, slope, second) <= least && rise(w, -slope_right, second_right) <= least {
            return true;
        }
        // One sign of the slope.
        let lower = if slope < slope_right { slope } else { slope_right };
        if lower > bend * half || slope.or_larger(slope_right) < -(bend * half) {
            return true;
        }
        // Concave.
        if second.or_larger(second_right) + change * half >= zero {
            return false;
        }
        if slope > zero && slope_right < zero {
            let tau = newton_within(left.at.tau, right.at.tau, |tau| {
                let [_, slope, curvature] = self.motion.velocity(&self.motion.at(tau));
                (slope, curvature)
            });
            self.consider(tau);
        }
        true
    }
}

fn end<F: Float>(motion: &Vibration<F>, tau: F) -> EndVelocity<F> {
    let at = motion.at(tau);
    EndVelocity { at, velocity: motion.velocity(&at), driven: motion.driven(&at).0 }
}
