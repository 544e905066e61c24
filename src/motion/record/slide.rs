//! A slide under a load that changes linearly, and the certificate of the stop that ends it.
//!
//! While the body slides, a = x″ satisfies `a″ + 2βa′ + ω²a = 0`: it is a free vibration, whose zeros are π/d
//! apart (d = √(ω² − β²); there is one at most where β ≥ ω). On a stretch shorter than π/d the velocity therefore
//! turns once at most, and the signs of v and a at both ends decide whether it vanishes there (`Linear::shortness` has
//! one more bound, which is due to rounding):
//!
//! * v > 0 at the start and v ≤ 0 at the end: it vanishes once, and falls as it does.
//! * v > 0 at both ends: it vanishes only if it turns from falling to rising, a < 0 at the start and a > 0 at the
//!   end, and is ≤ 0 at the zero of a.
//! * v = 0 at the start, with a > 0, or with a = 0 and a′ > 0: the first case or none, after the zero of a. Where
//!   a = 0 at the start it has no other zero on the stretch, and v rises throughout. Otherwise the slide ends where
//!   it starts.
//!
//! No step size and no tolerance enter; only the rounding of the signs.

use super::linear::{Law, Linear, Responses};
use super::number::Number;

/// The start of a stretch of sliding: velocity and acceleration, and the slope of the load.
#[derive(Debug, Clone, Copy)]
pub(super) struct Slide<F> {
    pub(super) v: F,
    pub(super) a: F,
    pub(super) slope: F,
    /// ±1, the direction.
    pub(super) sign: F,
}

/// The state at a later time of a slide.
#[derive(Debug, Clone, Copy)]
pub(super) struct Moment<F> {
    /// The displacement since the start.
    pub(super) moved: F,
    pub(super) v: F,
    pub(super) a: F,
}

impl<F: Number> Slide<F> {
    /// The velocity after the time of these responses: `v = v₀(1 − ω²S₂) + a₀S₁ + sS₂`.
    #[inline(always)]
    pub(super) fn velocity(&self, law: &Law<F>, s: &Responses<F>) -> F {
        self.v * (F::int(1) - law.square * s.step) + self.a * s.impulse + self.slope * s.step
    }

    /// The acceleration: `a = a₀(1 − 2βS₁ − ω²S₂) + (s − ω²v₀)S₁`.
    #[inline(always)]
    pub(super) fn acceleration(&self, law: &Law<F>, s: &Responses<F>) -> F {
        self.a * (F::int(1) - law.rate * s.impulse - law.square * s.step)
            + (self.slope - law.square * self.v) * s.impulse
    }

    /// The displacement since the start: `v₀(S₁ + 2βS₂) + a₀S₂ + sS₃`.
    #[inline(always)]
    pub(super) fn moved(&self, law: &Law<F>, s: &Responses<F>) -> F {
        self.v * (s.impulse + law.rate * s.step) + self.a * s.step + self.slope * s.ramp
    }

    /// The integral of [`Slide::moved`]: `v₀(S₂ + 2βS₃) + a₀S₃ + sS₄`.
    #[inline(always)]
    pub(super) fn area(&self, law: &Law<F>, s: &Responses<F>) -> F {
        self.v * (s.step + law.rate * s.ramp) + self.a * s.ramp + self.slope * s.parabola
    }

    /// The jerk a′ at a moment: `s − ω²v − 2βa`.
    #[inline(always)]
    pub(super) fn jerk(&self, law: &Law<F>, v: F, a: F) -> F {
        self.slope - law.square * v - law.rate * a
    }

    #[inline(always)]
    pub(super) fn moment(&self, law: &Law<F>, s: &Responses<F>) -> Moment<F> {
        Moment { moved: self.moved(law, s), v: self.velocity(law, s), a: self.acceleration(law, s) }
    }

    /// The state at a time.
    pub(super) fn at(&self, linear: &Linear<F>, t: F) -> Option<Moment<F>> {
        Some(self.moment(&linear.law, &linear.at(t)?))
    }

    /// An upper bound of |a| within a time: `|a₀| + t√(a₀′² + ω²a₀²)`, because the energy `a′² + ω²a²` of a free
    /// vibration does not grow.
    #[inline(always)]
    pub(super) fn greatest_acceleration(&self, law: &Law<F>, omega: F, t: F) -> F {
        let jerk = self.jerk(law, self.v, self.a).abs() + omega * self.a.abs();
        self.a.abs() + t * jerk
    }

    /// The first time in (0, `length`] at which the velocity vanishes, given the state at `length`; `length` is
    /// shorter than π/d. The outer `None` says that a sign is uncertain.
    #[inline(always)]
    pub(super) fn stop(&self, linear: &Linear<F>, omega: F, length: F, end: &Moment<F>) -> Option<Option<F>> {
        let end_speed = self.sign * end.v;
        if !end_speed.positive()? {
            return self.stop_before(linear, length, end).map(Some);
        }
        if (self.sign * self.a).negative()? && (self.sign * end.a).positive()? {
            return self.stop_at_turn(linear, omega, length, end);
        }
        Some(None)
    }

    /// The stop of a slide that ends with v ≤ 0.
    #[inline(never)]
    fn stop_before(&self, linear: &Linear<F>, length: F, end: &Moment<F>) -> Option<F> {
        let mut low = F::int(0);
        if !(self.sign * self.v).positive()? {
            let a = self.sign * self.a;
            let is_opposed = if a.positive()? || a.negative()? {
                a.negative()?
            } else {
                !(self.sign * self.jerk(&linear.law, self.v, self.a)).positive()?
            };
            if is_opposed {
                // The load has changed at once, to the other direction.
                return Some(F::int(0));
            }
            if !a.positive()? || !(self.sign * end.a).negative()? {
                // v would be positive at the end, but for rounding.
                return Some(length);
            }
            low = self.turn(linear, length, self.sign, end)?;
        }
        let from = if low.positive()? { self.at(linear, low)? } else { self.start() };
        self.zero(linear, [low, length], [&from, end])
    }

    /// The stop of a slide whose speed has a minimum, if that is ≤ 0.
    #[inline(never)]
    fn stop_at_turn(&self, linear: &Linear<F>, omega: F, length: F, end: &Moment<F>) -> Option<Option<F>> {
        // The minimum is not below the smaller end by more than t max |a|.
        let lost = length * self.greatest_acceleration(&linear.law, omega, length);
        if (self.sign * self.v - lost).positive()? && (self.sign * end.v - lost).positive()? {
            return Some(None);
        }
        let turn = self.turn(linear, length, -self.sign, end)?;
        let least = self.at(linear, turn)?;
        if (self.sign * least.v).positive()? {
            return Some(None);
        }
        self.zero(linear, [F::int(0), turn], [&self.start(), &least]).map(Some)
    }

    /// The start as a moment.
    fn start(&self) -> Moment<F> {
        Moment { moved: F::int(0), v: self.v, a: self.a }
    }

    /// The zero of the acceleration, which has the sign `sign` at the start and the other one at `length`.
    fn turn(&self, linear: &Linear<F>, length: F, sign: F, end: &Moment<F>) -> Option<F> {
        let of = |moment: &Moment<F>| {
            let [_, a, jerk, bend, third] = self.derivatives(&linear.law, moment.v, moment.a);
            [a, jerk, bend, third].map(|d| sign * d)
        };
        let ends = [&self.start(), end].map(|moment| {
            let [a, jerk, ..] = of(moment);
            [a, jerk]
        });
        F::zero_within([F::int(0), length], linear.longest_step(length), ends, |t| {
            Some(of(&self.at(linear, t)?))
        })
    }

    /// The zero of the velocity between two times, where it falls.
    fn zero(&self, linear: &Linear<F>, [low, high]: [F; 2], ends: [&Moment<F>; 2]) -> Option<F> {
        let sign = self.sign;
        let ends = ends.map(|moment| [sign * moment.v, sign * moment.a]);
        F::zero_within([low, high], linear.longest_step(high - low), ends, |t| {
            Some(self.speed(&linear.law, &linear.at(t)?))
        })
    }

    /// The speed in the direction of the slide and three derivatives, after the time of these responses.
    #[inline(always)]
    pub(super) fn speed(&self, law: &Law<F>, s: &Responses<F>) -> [F; 4] {
        let (v, a) = (self.velocity(law, s), self.acceleration(law, s));
        let [v, a, jerk, bend, _] = self.derivatives(law, v, a);
        [v, a, jerk, bend].map(|d| self.sign * d)
    }

    /// How far v, and a or a less the load, can be beyond the greater of their ends within a time T: an extreme of g is no
    /// further from the nearer end than T²/8 times the greatest |g″|, which an energy that does not grow bounds.
    #[inline(always)]
    pub(super) fn beyond(&self, law: &Law<F>, omega: F, time: F) -> [F; 2] {
        let jerk = self.jerk(law, self.v, self.a);
        let bend = law.rate * jerk + law.square * self.a;
        let eighth = time.square() * F::ratio(1, 8);
        [(jerk, self.a), (bend, jerk)].map(|(second, first)| (second.abs() + omega * first.abs()) * eighth)
    }

    /// The velocity and its four derivatives at the start and after a time.
    ///
    /// Without a spring the jerk is `a₀′e^{−2βt}`, whose sign is that of its start however far it has fallen; the sum of the forces
    /// has their rounding.
    #[inline(always)]
    pub(super) fn derivatives_at_ends(&self, law: &Law<F>, time: F, end: &Moment<F>) -> [[F; 5]; 2] {
        let start = self.derivatives(law, self.v, self.a);
        let [v, a, jerk, bend, third] = self.derivatives(law, end.v, end.a);
        let is_without_spring = law.square.positive() == Some(false);
        if !is_without_spring || law.rate.positive() != Some(true) {
            return [start, [v, a, jerk, bend, third]];
        }
        let fade = (-(law.rate * time)).exponential();
        let [_, _, jerk, bend, third] = start.map(|derivative| derivative * fade);
        [start, [v, a, jerk, bend, third]]
    }

    /// The velocity v and its derivatives a, a′, a″ and a‴ at a moment: each derivative of a free vibration is −2β
    /// times itself less ω² times the one before.
    #[inline(always)]
    pub(super) fn derivatives(&self, law: &Law<F>, v: F, a: F) -> [F; 5] {
        let jerk = self.jerk(law, v, a);
        let bend = law.next(a, jerk);
        [v, a, jerk, bend, law.next(jerk, bend)]
    }
}
