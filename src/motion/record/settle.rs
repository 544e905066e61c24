//! The motion after a record: the load is constant, and the body slides to its rest, or to the limit it tends to.

use super::follow::{Failure, Follower, How, Mode, Watch};
use super::linear::{Free, Linear, growth};
use super::load::Piece;
use super::number::Number;

/// The most half turns that are followed after a record.
const TURNS: u32 = 100_000;
/// The most doublings of a time: the range of any type.
const DOUBLINGS: u32 = 1 << 20;
/// The stops of a free vibration after which it has taken more than a period, and with it all its extremes.
const PERIOD: u32 = 3;

/// The end of a motion.
#[derive(Debug, Clone, Copy)]
pub(super) enum Rest<F> {
    /// It rests at x.
    At(F),
    /// It moves for ever towards x.
    Limit(F),
    /// It never comes to rest, and is followed to a time: a slope steeper than friction, to the slide that does not end;
    /// neither friction nor damper, for a period of the free vibration, which is all of it.
    Never { time: F, x: F, v: F },
}

impl<F: Number> Follower<F> {
    /// Follows the body under a constant load per mass from a time on.
    pub(super) fn settle(&mut self, time: F, load: F, watch: &mut impl Watch<F>) -> Result<Rest<F>, Failure> {
        let zero = F::int(0);
        let c = self.constants;
        self.linear = Linear::new(c.rate, c.square, None).ok_or(Failure::Uncertain)?;
        // A body that moves one way is held at its first stop.
        let is_held = c.is_one_way || c.friction.positive().ok_or(Failure::Uncertain)?;
        if let (Free::Oscillating { decay, frequency }, false) = (self.linear.free, is_held) {
            return if c.rate.positive().ok_or(Failure::Uncertain)? {
                self.decay(time, load, decay / frequency, watch)
            } else {
                self.vibrate(time, load, frequency, watch)
            };
        }
        let mut from = zero;
        // Stretches since the last stop, in each of which a near-critical slide decays by e⁴ or turns.
        let mut creeps = 0i32;
        for _ in 0..TURNS {
            let Some(sign) = self.direction(time + from, load, watch)? else { return Ok(Rest::At(self.x)) };
            let limit = (c.mean + load - sign * c.friction) / c.square;
            let shortness = self.linear.shortness;
            let mut how = How::SHORT;
            let length = match self.linear.free.rates() {
                None if creeps > F::MOST_TERMS => {
                    // What is left of the way to the stop is lost in rounding; the swing beyond the limit is no longer
                    // than the way to it.
                    self.x = limit.widened(self.x - limit);
                    self.end(time + from, sign, watch).ok_or(Failure::Uncertain)?;
                    return Ok(Rest::At(self.x));
                }
                None => F::ratio(31, 32) / shortness,
                Some([slow, fast]) => {
                    match self.creep(load, slow, fast, sign).ok_or(Failure::Uncertain)? {
                        Creep::Stops if slow.positive().ok_or(Failure::Uncertain)? => F::int(1) / shortness,
                        Creep::Stops => self.length_to_stop(load, sign)?,
                        Creep::Runs => {
                            watch.goes_on(self.x, time + from).ok_or(Failure::Uncertain)?;
                            return Ok(Rest::Never { time: time + from, x: self.x, v: self.v });
                        }
                        Creep::Slows => {
                            let has_spring = slow.positive().ok_or(Failure::Uncertain)?;
                            let limit = if has_spring { limit } else { self.x + self.v / fast };
                            // The load may have changed at once, so that one stretch is taken at least.
                            if creeps > 0 && self.is_falling(sign) || creeps > F::MOST_TERMS {
                                watch.tends_to([self.x, limit], load, F::int(1)).ok_or(Failure::Uncertain)?;
                                return Ok(Rest::Limit(limit));
                            }
                            how.can_stop = false;
                            F::int(1) / if has_spring { shortness } else { fast }
                        }
                    }
                }
            };
            let piece = Piece::constant(load, length);
            match self.stretch(&piece, [time, from], length, sign, how, watch)? {
                Some(stop) => {
                    creeps = 0;
                    from = from + stop;
                }
                None => {
                    creeps = creeps.saturating_add(1);
                    from = from + length;
                }
            }
        }
        Err(Failure::Bound)
    }

    /// The direction in which the body goes on, with its acceleration set; `None` at rest.
    fn direction(&mut self, time: F, load: F, watch: &mut impl Watch<F>) -> Result<Option<F>, Failure> {
        match self.mode {
            Mode::Rest => {
                let piece = Piece::constant(load, F::int(0));
                let sign = self.release(&piece, time, watch).ok_or(Failure::Uncertain)?;
                if sign.is_none() {
                    watch.stays(load, time).ok_or(Failure::Uncertain)?;
                }
                Ok(sign)
            }
            Mode::Slide(sign) => {
                self.meet(load, sign);
                Ok(Some(sign))
            }
        }
    }

    /// A vibration that is damped, without friction. From one stop to the next the distance from the limit falls by
    /// q = e^{−πβ/d}, so that the way from one at the distance X on is X(1 + q)/(1 − q).
    fn decay(&mut self, time: F, load: F, rate: F, watch: &mut impl Watch<F>) -> Result<Rest<F>, Failure> {
        let limit = (self.constants.mean + load) / self.constants.square;
        let length = F::ratio(31, 32) / self.linear.shortness;
        let piece = Piece::constant(load, length);
        let mut from = F::int(0);
        let (mut stops, mut walked) = (0u32, 0i32);
        watch.counted();
        while stops < PERIOD && walked <= F::MOST_TERMS {
            let Some(sign) = self.direction(time + from, load, watch)? else { return Ok(Rest::At(self.x)) };
            let stop = self.stretch(&piece, [time, from], length, sign, How::SHORT, watch)?;
            (stops, walked) =
                if stop.is_some() { (stops.saturating_add(1), 0) } else { (stops, walked.saturating_add(1)) };
            from = from + stop.unwrap_or(length);
        }
        // The last stop may be the last of all.
        if self.direction(time + from, load, watch)?.is_none() {
            return Ok(Rest::At(self.x));
        }
        let z = F::pi() * rate;
        let swings = if stops < PERIOD {
            F::int(1)
        } else {
            let less = z * growth(z).ok_or(Failure::Uncertain)?[0];
            (F::int(2) - less) / less
        };
        watch.tends_to([self.x, limit], load, swings).ok_or(Failure::Uncertain)?;
        Ok(Rest::Limit(limit))
    }

    /// A vibration without friction and damper, for a period.
    fn vibrate(
        &mut self,
        time: F,
        load: F,
        frequency: F,
        watch: &mut impl Watch<F>,
    ) -> Result<Rest<F>, Failure> {
        if self.direction(time, load, watch)?.is_none() {
            return Ok(Rest::At(self.x));
        }
        let period = F::int(2) * F::pi() / frequency;
        self.step(&Piece::constant(load, period), time, None, watch)?;
        let end = time + period;
        if self.direction(end, load, watch)?.is_none() {
            return Ok(Rest::At(self.x));
        }
        watch.goes_on(self.x, end).ok_or(Failure::Uncertain)?;
        Ok(Rest::Never { time: end, x: self.x, v: self.v })
    }

    /// Whether the speed of a slide that does not stop falls for ever, ever more slowly: a and a′ have one zero at most,
    /// and their last signs.
    fn is_falling(&self, sign: F) -> bool {
        let jerk = self.slide(F::int(0), sign).jerk(&self.linear.law, self.v, self.a);
        (sign * self.a).positive() == Some(false) && (sign * jerk).negative() == Some(false)
    }

    /// The further course of a slide, for β ≥ ω: with the speed `v = Ae^{−λ₁t} + Be^{−λ₂t}`,
    /// (λ₂ − λ₁)A = a + λ₂v, it vanishes at some time only if A < 0.
    fn creep(&self, load: F, slow: F, fast: F, sign: F) -> Option<Creep> {
        let c = &self.constants;
        let has_spring = slow.positive()?;
        let part =
            if has_spring { sign * (self.a + fast * self.v) } else { sign * (load + c.mean) - c.friction };
        let is_even = !has_spring && F::is_lost(part.abs(), load.abs() + c.mean.abs() + c.friction);
        Some(if !is_even && part.negative()? {
            Creep::Stops
        } else if has_spring || (fast.positive()? && (is_even || !part.positive()?)) {
            Creep::Slows
        } else {
            Creep::Runs
        })
    }

    /// A time at which a slide that stops has stopped.
    fn length_to_stop(&self, load: F, sign: F) -> Result<F, Failure> {
        let slide = self.slide(F::int(0), sign);
        let braking = self.constants.friction + self.constants.mean.abs() + load.abs();
        let mut length = (sign * self.v) / braking;
        for doubling in 0..DOUBLINGS {
            let moment = slide.at(&self.linear, length).ok_or(Failure::Uncertain)?;
            match (sign * moment.v).positive() {
                Some(false) => return Ok(length),
                Some(true) => {}
                // Friction alone stops the body exactly at the first time.
                None if doubling == 0 => {}
                None => return Err(Failure::Uncertain),
            }
            length = length + length;
        }
        Err(Failure::Bound)
    }
}

/// The course of a slide whose free vibration does not oscillate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Creep {
    /// It stops.
    Stops,
    /// It slows down for ever.
    Slows,
    /// It goes on without a limit.
    Runs,
}
