//! The way of a body through a record: slides, stops and releases, one after another.

use super::body::Constants;
use super::linear::{Linear, Responses};
use super::load::Piece;
use super::number::Number;
use super::slide::{Moment, Slide};

/// What the body does.
#[derive(Debug, Clone, Copy)]
pub(super) enum Mode<F> {
    Rest,
    /// In the direction ±1.
    Slide(F),
}

impl<F: Number> Mode<F> {
    /// ±1, and 0 at rest.
    pub(super) fn sign(self) -> F {
        match self {
            Self::Rest => F::int(0),
            Self::Slide(sign) => sign,
        }
    }
}

/// Somebody who watches the motion.
pub(super) trait Watch<F> {
    /// The body slides for a time, to this moment; the load at the start is `load`, without the constant force.
    fn slid(&mut self, linear: &Linear<F>, slide: &Slide<F>, stretch: &Stretch<'_, F>) -> Option<()>;
    /// The body rests for a time.
    fn rested(&mut self, x: F, piece: &Piece<F>, start: F, from: F, length: F) -> Option<()>;
    /// A slide begins.
    fn released(&mut self, time: F, x: F, sign: F);
    /// A slide ends.
    fn stopped(&mut self, time: F, x: F) -> Option<()>;
}

/// A stretch of a slide.
#[derive(Debug)]
pub(super) struct Stretch<'a, F> {
    /// The time and the displacement at its start.
    pub(super) time: F,
    pub(super) x: F,
    /// Its length.
    pub(super) length: F,
    /// The load per mass at its start and its end.
    pub(super) load: [F; 2],
    pub(super) responses: &'a Responses<F>,
    pub(super) end: &'a Moment<F>,
}

/// The reason why a motion is not followed any further.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Failure {
    /// A sign is uncertain: balls that are too wide, or numbers beyond the range of their type.
    Uncertain,
    /// More events in a stretch than there can be.
    Bound,
    /// The caller ended the work.
    Interrupted,
}

/// A failure, and the time before which the motion is known.
pub(super) type Failed<F> = (Failure, F);

/// The most stops and releases at one time that rounding may cause.
const EVENTS_AT_ONCE: u32 = 64;
/// The most stops and releases in one step of a record.
const EVENTS: u32 = 100_000;

/// A body on its way.
#[derive(Debug, Clone)]
pub(super) struct Follower<F> {
    pub(super) constants: Constants<F>,
    pub(super) omega: F,
    pub(super) linear: Linear<F>,
    pub(super) x: F,
    pub(super) v: F,
    /// The acceleration while it slides.
    pub(super) a: F,
    pub(super) mode: Mode<F>,
}

impl<F: Number> Follower<F> {
    /// A body at the displacement x with the velocity v, for steps up to `longest`, or for any.
    pub(super) fn new(constants: Constants<F>, x: F, v: F, longest: Option<F>) -> Option<Self> {
        let linear = Linear::new(constants.rate, constants.square, longest)?;
        let zero = F::int(0);
        let mode = if v.positive()? {
            Mode::Slide(F::int(1))
        } else if v.negative()? {
            Mode::Slide(F::int(-1))
        } else {
            Mode::Rest
        };
        Some(Self { constants, omega: constants.square.sqrt(), linear, x, v, a: zero, mode })
    }

    /// The responses after a step, where it is shorter than π/d.
    pub(super) fn whole_step(&self, length: F) -> Option<Responses<F>> {
        if self.parts(length)? == 1 { self.linear.at(length) } else { None }
    }

    /// The least number of equal parts of a length in which the certificate of a stop holds.
    fn parts(&self, length: F) -> Option<i32> {
        let parts = length * self.linear.shortness;
        // Without a spring and a damper any length is one part.
        if parts.positive()? { parts.whole()?.checked_add(1) } else { Some(1) }
    }

    /// The force per mass on the body, less friction, of a slide: `f + p̄ − 2βv − ω²x − r`.
    #[inline(always)]
    pub(super) fn acceleration(&self, load: F, sign: F) -> F {
        let c = &self.constants;
        load + c.mean - sign * c.friction - c.rate * self.v - c.square * self.x
    }

    pub(super) fn slide(&self, slope: F, sign: F) -> Slide<F> {
        Slide { v: self.v, a: self.a, slope, sign }
    }

    /// Follows the body through one step of the load that begins at the time `start`.
    pub(super) fn step(
        &mut self,
        piece: &Piece<F>,
        start: F,
        watch: &mut impl Watch<F>,
    ) -> Result<(), Failure> {
        if let Mode::Slide(sign) = self.mode {
            self.a = self.acceleration(piece.from, sign);
        }
        let mut from = F::int(0);
        let (mut events, mut at_once) = (0u32, 0u32);
        while events < EVENTS && at_once < EVENTS_AT_ONCE {
            let left = piece.length - from;
            if !left.positive().ok_or(Failure::Uncertain)? {
                return Ok(());
            }
            match self.mode {
                Mode::Rest => {
                    let Some(rest) = self.rest(piece, from, left).ok_or(Failure::Uncertain)? else {
                        watch.rested(self.x, piece, start, from, left).ok_or(Failure::Uncertain)?;
                        return Ok(());
                    };
                    let Release { after, sign, a } = rest;
                    watch.rested(self.x, piece, start, from, after).ok_or(Failure::Uncertain)?;
                    at_once = if after.positive().ok_or(Failure::Uncertain)? {
                        0
                    } else {
                        at_once.saturating_add(1)
                    };
                    from = from + after;
                    (self.mode, self.v, self.a) = (Mode::Slide(sign), F::int(0), a);
                    watch.released(start + from, self.x, sign);
                    events = events.saturating_add(1);
                }
                Mode::Slide(sign) => {
                    let parts = self.parts(left).ok_or(Failure::Bound)?;
                    let length = left / F::int(parts);
                    let is_stopped = self.stretch(piece, start, from, length, sign, watch)?;
                    let passed = match is_stopped {
                        Some(stop) => stop,
                        None if parts == 1 => return Ok(()),
                        None => length,
                    };
                    if passed.positive().ok_or(Failure::Uncertain)? {
                        at_once = 0;
                    }
                    from = from + passed;
                }
            }
        }
        Err(Failure::Bound)
    }

    /// Releases a body at rest under the load at the start of a step; the direction, if it moves.
    pub(super) fn release(
        &mut self,
        piece: &Piece<F>,
        time: F,
        watch: &mut impl Watch<F>,
    ) -> Option<Option<F>> {
        let zero = F::int(0);
        Some(self.rest(piece, zero, zero)?.map(|Release { sign, a, .. }| {
            (self.mode, self.v, self.a) = (Mode::Slide(sign), zero, a);
            watch.released(time, self.x, sign);
            sign
        }))
    }

    /// Follows a slide for a length shorter than π/d, or to its stop.
    pub(super) fn stretch(
        &mut self,
        piece: &Piece<F>,
        start: F,
        from: F,
        length: F,
        sign: F,
        watch: &mut impl Watch<F>,
    ) -> Result<Option<F>, Failure> {
        let slide = self.slide(piece.slope, sign);
        let linear = &self.linear;
        let mut responses = linear.at(length).ok_or(Failure::Uncertain)?;
        let mut end = slide.moment(linear, &responses);
        let stop = slide.stop(linear, self.omega, length, &end).ok_or(Failure::Uncertain)?;
        let length = stop.unwrap_or(length);
        if stop.is_some() {
            responses = linear.at(length).ok_or(Failure::Uncertain)?;
            end = Moment { v: F::int(0), ..slide.moment(linear, &responses) };
        }
        let load = |t: F| piece.from + piece.slope * t;
        let stretch = Stretch {
            time: start + from,
            x: self.x,
            length,
            load: [load(from), load(from + length)],
            responses: &responses,
            end: &end,
        };
        watch.slid(linear, &slide, &stretch).ok_or(Failure::Uncertain)?;
        (self.x, self.v) = (self.x + end.moved, end.v);
        self.a = self.acceleration(load(from + length), sign);
        if stop.is_some() {
            watch.stopped(start + (from + length), self.x).ok_or(Failure::Uncertain)?;
            self.mode = Mode::Rest;
        }
        Ok(stop)
    }

    /// The release of the body at rest at the time `from` of a step, within the time `left`; `None` where it stays.
    ///
    /// The force on it, `f + p̄ − ω²x`, is linear in time, so that a division gives the time. The acceleration at
    /// that time is exactly that of the static bound, `±(held − r)`.
    fn rest(&self, piece: &Piece<F>, from: F, left: F) -> Option<Option<Release<F>>> {
        let c = &self.constants;
        let offset = c.mean - c.square * self.x;
        let now = piece.from + piece.slope * from + offset;
        let later = piece.to + offset;
        for sign in [F::int(1), F::int(-1)] {
            if c.is_one_way && sign.negative()? {
                break;
            }
            if (sign * now - c.held).positive()? {
                return Some(Some(Release { after: F::int(0), sign, a: now - sign * c.friction }));
            }
            if (sign * later - c.held).positive()? {
                let after = (c.held - sign * now) / (sign * piece.slope);
                let after = if (left - after).negative()? { left } else { after };
                return Some(Some(Release { after, sign, a: sign * c.excess }));
            }
        }
        Some(None)
    }
}

#[derive(Debug, Clone, Copy)]
struct Release<F> {
    after: F,
    sign: F,
    a: F,
}
