//! The motion after a record: the load is zero, and the body slides to its rest, or to the limit it creeps to.

use super::follow::{Failure, Follower, Mode, Watch};
use super::linear::{Free, Linear};
use super::load::Piece;
use super::number::Number;

/// The most half turns that are followed after a record.
const TURNS: u32 = 100_000;
/// The most doublings of a time: the range of any type.
const DOUBLINGS: u32 = 1 << 20;

/// The end of a motion.
#[derive(Debug, Clone, Copy)]
pub(super) enum Rest<F> {
    /// It rests at x.
    At(F),
    /// It slides for ever towards x.
    Limit(F),
    /// It never comes to rest: a slope steeper than friction, or neither friction nor damper.
    Never,
}

impl<F: Number> Follower<F> {
    /// Follows the body without a load from a time on.
    pub(super) fn settle(&mut self, time: F, watch: &mut impl Watch<F>) -> Result<Rest<F>, Failure> {
        let zero = F::int(0);
        let c = self.constants;
        self.linear = Linear::new(c.rate, c.square, None).ok_or(Failure::Uncertain)?;
        let has_friction = c.friction.positive().ok_or(Failure::Uncertain)?;
        let mut piece = Piece { length: zero, from: zero, to: zero, slope: zero };
        let mut from = zero;
        let mut stops = 0u32;
        // Stretches since the last stop, in each of which a near-critical slide decays by e⁴ or turns.
        let mut creeps = 0i32;
        for _ in 0..TURNS {
            let sign = match self.mode {
                Mode::Rest => match self.release(&piece, time + from, watch).ok_or(Failure::Uncertain)? {
                    Some(sign) => sign,
                    None => return Ok(Rest::At(self.x)),
                },
                Mode::Slide(sign) => {
                    self.a = self.acceleration(zero, sign);
                    sign
                }
            };
            let shortness = self.linear.shortness;
            let length = match self.linear.free {
                Free::Oscillating { .. } if !has_friction && stops >= 2 => {
                    let is_damped = c.rate.positive().ok_or(Failure::Uncertain)?;
                    return Ok(if is_damped { Rest::Limit(c.mean / c.square) } else { Rest::Never });
                }
                Free::Oscillating { .. } if creeps > F::MOST_TERMS => {
                    // What is left of the way to the stop is lost in rounding; the swing beyond the limit is no longer
                    // than the way to it.
                    let limit = (c.mean - sign * c.friction) / c.square;
                    let limit = limit.widened(self.x - limit);
                    watch.stopped(time + from, limit).ok_or(Failure::Uncertain)?;
                    (self.x, self.v, self.mode) = (limit, zero, Mode::Rest);
                    return Ok(Rest::At(limit));
                }
                Free::Oscillating { .. } => F::ratio(31, 32) / shortness,
                Free::Creeping { slow, fast, .. } => {
                    if let Some(rest) = self.creep(slow, fast, sign).ok_or(Failure::Uncertain)? {
                        return Ok(rest);
                    }
                    if shortness.positive().ok_or(Failure::Uncertain)? {
                        F::int(1) / shortness
                    } else {
                        self.length_to_stop(sign)?
                    }
                }
            };
            piece.length = length;
            match self.stretch(&piece, time, from, length, sign, watch)? {
                Some(stop) => {
                    (stops, creeps) = (stops.saturating_add(1), 0);
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

    /// The end of a slide that does not stop, for β ≥ ω: with the speed `v = Ae^{−λ₁t} + Be^{−λ₂t}`,
    /// (λ₂ − λ₁)A = a + λ₂v, it vanishes at some time only if A < 0.
    fn creep(&self, slow: F, fast: F, sign: F) -> Option<Option<Rest<F>>> {
        let c = &self.constants;
        let part = sign * (self.acceleration(F::int(0), sign) + fast * self.v);
        if part.negative()? {
            return Some(None);
        }
        Some(Some(if slow.positive()? {
            Rest::Limit((c.mean - sign * c.friction) / c.square)
        } else if part.positive()? || !fast.positive()? {
            Rest::Never
        } else {
            Rest::Limit(self.x + self.v / fast)
        }))
    }

    /// A time at which a slide that stops has stopped.
    fn length_to_stop(&self, sign: F) -> Result<F, Failure> {
        let slide = self.slide(F::int(0), sign);
        let braking = self.constants.friction + self.constants.mean.abs();
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
