//! The way of a body through a record: slides, stops and releases, one after another.

use super::body::Constants;
use super::linear::{Linear, Responses};
use super::load::{Factors, Piece};
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

/// The beginning of a slide.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Onset {
    /// After a rest, or at the start of the motion.
    Released,
    /// At the end of a slide in the other direction, without a rest.
    Reversed,
    /// The velocity touched zero, and goes on in its direction: the slide was none that ended.
    Touched,
}

/// Somebody who watches the motion.
pub(super) trait Watch<F> {
    /// The body slides for a time, to this moment; the load at the start is `load`, without the constant force.
    fn slid(&mut self, linear: &Linear<F>, slide: &Slide<F>, stretch: &Stretch<'_, F>) -> Option<()>;
    /// The body rests for a time > 0.
    fn rested(&mut self, x: F, piece: &Piece<F>, start: F, from: F, length: F) -> Option<()>;
    /// A slide begins.
    fn released(&mut self, time: F, x: F, sign: F, onset: Onset);
    /// A slide ends.
    fn stopped(&mut self, time: F, x: F) -> Option<()>;
    /// An impulse changes the velocity from the first of these to the second.
    fn struck(&mut self, velocities: [F; 2], time: F) -> Option<()>;
    /// The support of the spring lets go.
    fn freed(&mut self);
    /// The counts end here: the motion has no last stop.
    fn counted(&mut self);
    /// The body stays at rest under a constant load.
    fn stays(&mut self, load: F, time: F) -> Option<()>;
    /// The motion goes on without an end, and is at x at this time.
    fn goes_on(&mut self, x: F, time: F) -> Option<()>;
    /// The motion tends to x, the second of these places, under a constant load, over `swings` times the way there
    /// from the last stop.
    fn tends_to(&mut self, places: [F; 2], load: F, swings: F) -> Option<()>;
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
    /// 2βu′ of a support on which the damper stands.
    pub(super) foot: F,
    /// Whether it is no longer than the certificate allows. A longer one is inside a slide whose extremes are in the
    /// stretches before and after it.
    pub(super) is_short: bool,
}

/// The reason why a motion is not followed any further.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Failure {
    /// A sign is uncertain: balls that are too wide, or numbers beyond the range of their type.
    Uncertain,
    /// More events in a stretch than there can be.
    Bound,
    /// The caller ended the work.
    #[cfg(feature = "batch")]
    Interrupted,
}

/// A failure, and the time before which the motion is known.
pub(super) type Failed<F> = (Failure, F);

/// The most stops and releases at one time that rounding may cause.
const EVENTS_AT_ONCE: u32 = 64;
/// The most stops and releases in one step of a record.
const EVENTS: u32 = 100_000;
/// The stops and releases in a step that are not counted towards the most of all steps.
const FEW_EVENTS: u32 = 16;
/// The most stops and releases in all steps, less the few of each.
const ALL_EVENTS: u32 = 1_000_000;

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
    /// The constant load under which the last stretch of a damped slide ended with this velocity and acceleration. As
    /// parts of a free vibration they keep their digits however far they fall, where the sum of the forces has its
    /// rounding: a body that only tends to rest has no stop in it.
    pub(super) kept: Option<F>,
    pub(super) mode: Mode<F>,
    pub(super) last: Ended<F>,
    /// The greatest |x| at a stop.
    pub(super) widest: F,
    /// Stops and releases beyond the few of each step.
    events: u32,
}

/// The slide before a rest.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ended<F> {
    /// Its direction; 0 where there was none.
    sign: F,
    /// The time at which the slide began, and its length.
    began: F,
    length: F,
    /// Whether the body has rested for a time > 0 since.
    pub(super) has_rested: bool,
    /// The velocity that the slide would have lost in the time of the rest, without which it would have gone on;
    /// `None` where that is unknown.
    pub(super) lost: Option<F>,
}

impl<F: Number> Follower<F> {
    /// A body at the displacement x with the velocity v, for steps up to `longest`, or for any.
    pub(super) fn new(constants: Constants<F>, [x, v]: [F; 2], time: F, longest: Option<F>) -> Option<Self> {
        let linear = Linear::new(constants.rate, constants.square, longest)?;
        let zero = F::int(0);
        let mode = if v.positive()? {
            Mode::Slide(F::int(1))
        } else if v.negative()? {
            Mode::Slide(F::int(-1))
        } else {
            Mode::Rest
        };
        let last = Ended { sign: zero, began: time, length: zero, has_rested: false, lost: None };
        let omega = constants.square.sqrt();
        Some(Self {
            constants,
            omega,
            linear,
            x,
            v,
            a: zero,
            kept: None,
            mode,
            last,
            widest: x.abs(),
            events: 0,
        })
    }

    /// The acceleration with which the motion begins, on the first step of a record.
    pub(super) fn first_acceleration(&self, piece: &Piece<F>) -> Option<F> {
        let nothing = F::int(0);
        Some(match self.mode {
            Mode::Slide(sign) => self.acceleration(piece.from, sign),
            Mode::Rest => match self.rest(piece, nothing, piece.length)? {
                Some(Release { after, a, .. }) if !after.positive()? => a,
                _ => nothing,
            },
        })
    }

    /// The responses after a step, where it is shorter than π/d.
    pub(super) fn whole_step(&self, length: F) -> Option<Responses<F>> {
        if Self::parts(length, self.linear.shortness)? == 1 { self.linear.at(length) } else { None }
    }

    /// Whether without a spring nothing but a damper changes the speed of a slide over a step: it then has one zero at most,
    /// but may fall as far as e^{−2βt}.
    fn is_fading(&self, piece: &Piece<F>) -> bool {
        let Constants { rate, square, .. } = &self.constants;
        let is_constant = (piece.slope.positive(), piece.slope.negative()) == (Some(false), Some(false));
        is_constant && square.positive() == Some(false) && rate.positive() == Some(true)
    }

    /// The least number of equal parts of a length in which the certificate of a stop holds, by 1 over the longest one.
    fn parts(length: F, shortness: F) -> Option<i32> {
        let parts = length * shortness;
        // Without a spring and a damper any length is one part.
        if parts.positive()? { parts.whole()?.checked_add(1) } else { Some(1) }
    }

    /// The force per mass on the body, less friction, of a slide: `f + p̄ − 2βv − ω²x − r`.
    #[inline(always)]
    pub(super) fn acceleration(&self, load: F, sign: F) -> F {
        let c = &self.constants;
        load + c.mean - sign * c.friction - c.rate * self.v - c.square * self.x
    }

    /// Whether the acceleration is that with which the body came to a load.
    fn has_kept(&self, load: F) -> bool {
        self.kept.is_some_and(|kept| kept.is_same(load))
    }

    /// Sets the acceleration of a slide that comes to a load.
    pub(super) fn meet(&mut self, load: F, sign: F) {
        if !self.has_kept(load) {
            self.a = self.acceleration(load, sign);
        }
    }

    pub(super) fn slide(&self, slope: F, sign: F) -> Slide<F> {
        Slide { v: self.v, a: self.a, slope, sign }
    }

    /// Follows the body through one step of the load that begins at the time `start`; `whole` are the responses after
    /// the step, where they are known, and it is shorter than π/d.
    pub(super) fn step(
        &mut self,
        piece: &Piece<F>,
        start: F,
        whole: Option<&Responses<F>>,
        watch: &mut impl Watch<F>,
    ) -> Result<(), Failure> {
        if let Mode::Slide(sign) = self.mode {
            self.meet(piece.from, sign);
        }
        self.step_from(piece, [start, F::int(0)], whole, watch)
    }

    /// Follows the body through the rest of a step from a time in it on, at which its acceleration is set.
    pub(super) fn step_from(
        &mut self,
        piece: &Piece<F>,
        [start, mut from]: [F; 2],
        whole: Option<&Responses<F>>,
        watch: &mut impl Watch<F>,
    ) -> Result<(), Failure> {
        let (mut events, mut at_once) = (0u32, 0u32);
        // Stretches since the last event, and whether the slide has no stop in this step.
        let (mut walked, mut goes_on) = (0i32, false);
        // The responses after the rest of the step.
        let whole = if self.is_fading(piece) { None } else { whole };
        let mut after = if from.positive().ok_or(Failure::Uncertain)? { None } else { whole };
        while events < EVENTS && at_once < EVENTS_AT_ONCE {
            let left = piece.length - from;
            if !left.positive().ok_or(Failure::Uncertain)? {
                break;
            }
            match self.mode {
                Mode::Rest => {
                    let Some(rest) = self.rest(piece, from, left).ok_or(Failure::Uncertain)? else {
                        self.rested(piece, start, from, left, watch).ok_or(Failure::Uncertain)?;
                        break;
                    };
                    let wait = rest.after;
                    if wait.positive().ok_or(Failure::Uncertain)? {
                        self.rested(piece, start, from, wait, watch).ok_or(Failure::Uncertain)?;
                        (at_once, after) = (0, None);
                    } else {
                        at_once = at_once.saturating_add(1);
                    }
                    from = from + wait;
                    // From rest, and a force that is that of sliding, v is the response S₂ ≥ 0 to a unit step times
                    // the slope of the load.
                    goes_on = rest.is_smooth;
                    self.begin([rest.sign, rest.a], start + from, piece.from, watch)
                        .ok_or(Failure::Uncertain)?;
                    walked = 0;
                    events = events.saturating_add(1);
                }
                Mode::Slide(sign) => {
                    let reach = match whole {
                        // A part of a short step is short.
                        Some(_) => Reach { length: left, is_short: true, is_last: true },
                        None => self.reach(left, walked, self.is_fading(piece))?,
                    };
                    let (length, is_short) = (reach.length, reach.is_short);
                    let how = How { can_stop: !goes_on && is_short, is_short };
                    let responses = match after {
                        Some(responses) => *responses,
                        None => self.linear.at(length).ok_or(Failure::Uncertain)?,
                    };
                    let stop =
                        self.stretch_to(piece, [start, from], (length, responses), sign, how, watch)?;
                    walked = if stop.is_some() { 0 } else { walked.saturating_add(1) };
                    goes_on &= stop.is_none();
                    let passed = match stop {
                        Some(stop) => stop,
                        None if reach.is_last => break,
                        None => length,
                    };
                    if passed.positive().ok_or(Failure::Uncertain)? {
                        (at_once, after) = (0, None);
                    }
                    from = from + passed;
                }
            }
        }
        self.events = self.events.saturating_add(events.saturating_sub(FEW_EVENTS));
        if events < EVENTS && at_once < EVENTS_AT_ONCE && self.events < ALL_EVENTS {
            return Ok(());
        }
        Err(Failure::Bound)
    }

    /// The length of the next stretch of a slide with so much of a step left, after so many stretches since it began
    /// in this step, and whether it is short enough for the certificate of a stop.
    ///
    /// v is the sum of a constant and of a free vibration, whose swings do not grow. Where it has had no zero over
    /// more than a period, or as long as the slowest decay is not lost in rounding, it has none in this step. Its extremes,
    /// and those of a and of a less the load, are in the stretches already taken or in as many before the end of the
    /// step, so that one stretch leads there.
    fn reach(&self, left: F, walked: i32, is_fading: bool) -> Result<Reach<F>, Failure> {
        let many = F::MOST_TERMS.saturating_mul(2);
        let shortness = if is_fading { self.constants.rate * F::ratio(1, 4) } else { self.linear.shortness };
        Ok(match Self::parts(left, shortness) {
            Some(parts) if parts <= many => {
                Reach { length: left / F::int(parts), is_short: true, is_last: parts == 1 }
            }
            _ => {
                let length = F::ratio(31, 32) / shortness;
                length.positive().filter(|is_positive| *is_positive).ok_or(Failure::Bound)?;
                let is_short = walked < F::MOST_TERMS;
                let length = if is_short { length } else { left - length * F::int(F::MOST_TERMS) };
                Reach { length, is_short, is_last: false }
            }
        })
    }

    /// A rest of a time > 0.
    #[inline(always)]
    pub(super) fn rested(
        &mut self,
        piece: &Piece<F>,
        start: F,
        from: F,
        length: F,
        watch: &mut impl Watch<F>,
    ) -> Option<()> {
        let c = &self.constants;
        let middle = piece.from + piece.slope * (from + length * F::ratio(1, 2));
        let missing = c.friction - self.last.sign * (middle + c.mean - c.square * self.x);
        self.last.lost = self.last.lost.map(|lost| lost + missing * length);
        self.last.has_rested = true;
        watch.rested(self.x, piece, start, from, length)
    }

    /// The size of the forces per mass on the body at rest, whose sum has their rounding.
    #[inline(always)]
    fn size(&self, load: F) -> F {
        let c = &self.constants;
        load.abs() + c.mean.abs() + c.square * self.widest.larger(self.x.abs()) + c.held
    }

    /// Begins a slide in a direction with an acceleration.
    ///
    /// It continues the slide before where its direction is the same, and where it would have lost no more velocity in
    /// the time of the rest than rounding may have taken: a velocity that touches zero is one that stops for the root of
    /// a rounding. Only a static friction that is that of sliding lets it go on.
    #[inline(always)]
    pub(super) fn begin(
        &mut self,
        [sign, a]: [F; 2],
        time: F,
        load: F,
        watch: &mut impl Watch<F>,
    ) -> Option<()> {
        let last = self.last;
        let onset = if (last.sign * sign).positive()? {
            let is_touch = !last.has_rested
                || (!self.constants.excess.positive()?
                    && last.lost.is_some_and(|lost| F::is_lost(lost, self.size(load) * last.length)));
            if is_touch { Onset::Touched } else { Onset::Released }
        } else if (last.sign * sign).negative()? && !last.has_rested {
            Onset::Reversed
        } else {
            Onset::Released
        };
        (self.mode, self.v, self.a, self.kept) = (Mode::Slide(sign), F::int(0), a, None);
        let began = if onset == Onset::Touched { last.began } else { time };
        self.last = Ended { sign, began, length: F::int(0), has_rested: false, lost: None };
        watch.released(time, self.x, sign, onset);
        Some(())
    }

    /// Ends a slide.
    #[inline(always)]
    pub(super) fn end(&mut self, time: F, sign: F, watch: &mut impl Watch<F>) -> Option<()> {
        let (zero, began) = (F::int(0), self.last.began);
        self.last = Ended { sign, began, length: time - began, has_rested: false, lost: Some(zero) };
        self.widest = self.widest.larger(self.x.abs());
        (self.v, self.mode) = (zero, Mode::Rest);
        if self.constants.held.positive() == Some(true) {
            self.kept = None;
        }
        watch.stopped(time, self.x)
    }

    /// Takes a jump of a record from one sample to another: a damper on the support strikes the body with the impulse c Δu
    /// per mass. Friction, which is bounded, has none, unless the body moves one way.
    pub(super) fn jump(
        &mut self,
        factors: &Factors<F>,
        [first, second]: [F; 2],
        time: F,
        watch: &mut impl Watch<F>,
    ) -> Option<()> {
        let (zero, before) = (F::int(0), self.v);
        let step = second - first;
        if (step.positive(), step.negative()) != (Some(false), Some(false)) {
            self.kept = None;
        }
        let change = factors.damper * step;
        if !change.positive()? && !change.negative()? {
            return Some(());
        }
        let after = before + change;
        let sign = match (after.positive()?, after.negative()?) {
            (true, _) => F::int(1),
            (_, true) if !self.constants.is_one_way => F::int(-1),
            _ => zero,
        };
        if let Mode::Slide(way) = self.mode {
            if (way * sign).positive()? {
                self.v = after;
                return watch.struck([before, after], time);
            }
            watch.struck([before, zero], time)?;
            self.end(time, way, watch)?;
        }
        if !sign.positive()? && !sign.negative()? {
            return Some(());
        }
        self.begin([sign, zero], time, second * factors.factor, watch)?;
        self.v = after;
        watch.struck([zero, after], time)
    }

    /// Takes away the spring, whose support lets go, and the damper if it stands on the support, too.
    pub(super) fn let_go(&mut self, is_damper_on_foot: bool) {
        (self.constants.square, self.omega, self.kept) = (F::int(0), F::int(0), None);
        if is_damper_on_foot {
            self.constants.rate = F::int(0);
        }
    }

    /// Releases a body at rest under the load at the start of a step; the direction, if it moves.
    pub(super) fn release(
        &mut self,
        piece: &Piece<F>,
        time: F,
        watch: &mut impl Watch<F>,
    ) -> Option<Option<F>> {
        let zero = F::int(0);
        let Some(release) = self.rest(piece, zero, zero)? else { return Some(None) };
        self.begin([release.sign, release.a], time, piece.from, watch)?;
        Some(Some(release.sign))
    }

    /// Follows a slide for a length shorter than π/d, or to its stop.
    pub(super) fn stretch(
        &mut self,
        piece: &Piece<F>,
        times: [F; 2],
        length: F,
        sign: F,
        how: How,
        watch: &mut impl Watch<F>,
    ) -> Result<Option<F>, Failure> {
        let responses = self.linear.at(length).ok_or(Failure::Uncertain)?;
        self.stretch_to(piece, times, (length, responses), sign, how, watch)
    }

    /// The same, given the responses after the length.
    fn stretch_to(
        &mut self,
        piece: &Piece<F>,
        [start, from]: [F; 2],
        (length, mut responses): (F, Responses<F>),
        sign: F,
        how: How,
        watch: &mut impl Watch<F>,
    ) -> Result<Option<F>, Failure> {
        let slide = self.slide(piece.slope, sign);
        let linear = &self.linear;
        let mut end = slide.moment(&linear.law, &responses);
        if self.is_fading(piece) {
            // Each keeps its digits however far it falls.
            let fade = (-(self.constants.rate * length)).exponential();
            let push = piece.from + self.constants.mean - sign * self.constants.friction;
            end.a = slide.a * fade;
            if (push.positive(), push.negative()) == (Some(false), Some(false)) {
                end.v = slide.v * fade;
            }
        }
        let stop = if how.can_stop {
            slide.stop(linear, self.omega, length, &end).ok_or(Failure::Uncertain)?
        } else {
            // A velocity that is not opposed, but for rounding.
            end.v = sign * (sign * end.v).larger(F::int(0));
            None
        };
        let length = stop.unwrap_or(length);
        if stop.is_some() {
            responses = linear.at(length).ok_or(Failure::Uncertain)?;
            end = Moment { v: F::int(0), ..slide.moment(&linear.law, &responses) };
        }
        let load = |t: F| piece.from + piece.slope * t;
        let stretch = Stretch {
            time: start + from,
            x: self.x,
            length,
            load: [load(from), load(from + length)],
            responses: &responses,
            end: &end,
            foot: piece.foot,
            is_short: how.is_short,
        };
        watch.slid(linear, &slide, &stretch).ok_or(Failure::Uncertain)?;
        (self.x, self.v) = (self.x + end.moved, end.v);
        let is_constant = (piece.slope.positive(), piece.slope.negative()) == (Some(false), Some(false));
        if is_constant && self.constants.rate.positive() == Some(true) {
            (self.a, self.kept) = (end.a, Some(piece.from));
        } else {
            (self.a, self.kept) = (self.acceleration(load(from + length), sign), None);
        }
        if stop.is_some() {
            self.end(start + (from + length), sign, watch).ok_or(Failure::Uncertain)?;
        }
        Ok(stop)
    }

    /// The release of the body at rest at the time `from` of a step, within the time `left`; `None` where it stays.
    ///
    /// The force on it, `f + p̄ − ω²x`, is linear in time, so that a division gives the time. The acceleration at
    /// that time is exactly that of the static bound, `±(held − r)`. A force within rounding of the bound holds the body.
    fn rest(&self, piece: &Piece<F>, from: F, left: F) -> Option<Option<Release<F>>> {
        let c = &self.constants;
        let offset = c.mean - c.square * self.x;
        let load = piece.from + piece.slope * from;
        // Without friction the force on the body that has just stopped is that with which it stopped.
        let own = if c.held.positive()? || !self.has_kept(load) { None } else { Some(self.a) };
        let is_constant = !piece.slope.positive()? && !piece.slope.negative()?;
        let now = own.unwrap_or(load + offset);
        let later = own.filter(|_| is_constant).unwrap_or(piece.to + offset);
        let size = self.size(load.abs().larger(piece.to.abs()));
        let exceeds = |force: F| {
            let excess = force - c.held;
            Some(excess.positive()? && (own.is_some() || !F::is_lost(excess, size)))
        };
        let signs = || [F::int(1), F::int(-1)].into_iter().take(if c.is_one_way { 1 } else { 2 });
        // What holds now comes before what will hold.
        for sign in signs() {
            if exceeds(sign * now)? {
                let a = now - sign * c.friction;
                return Some(Some(Release { after: F::int(0), sign, a, is_smooth: false }));
            }
        }
        for sign in signs() {
            if exceeds(sign * later)? {
                let after = (c.held - sign * now) / (sign * piece.slope);
                let after = if (left - after).negative()? { left } else { after.larger(F::int(0)) };
                let is_smooth = !c.excess.positive()?;
                return Some(Some(Release { after, sign, a: sign * c.excess, is_smooth }));
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
    /// Whether the velocity begins with the square of the time.
    is_smooth: bool,
}

/// The next stretch of a slide.
#[derive(Debug, Clone, Copy)]
struct Reach<F> {
    length: F,
    is_short: bool,
    /// Whether it leads to the end of the step.
    is_last: bool,
}

/// How a stretch is taken.
#[derive(Debug, Clone, Copy)]
pub(super) struct How {
    /// Whether it may have a stop.
    pub(super) can_stop: bool,
    pub(super) is_short: bool,
}

impl How {
    /// A stretch that the certificate of a stop allows.
    pub(super) const SHORT: Self = Self { can_stop: true, is_short: true };
}
