//! The answers of a motion under a record, collected as it is followed.

use super::body::Constants;
use super::follow::{Onset, Stretch, Watch};
use super::linear::Linear;
use super::load::Piece;
use super::number::Number;
use super::slide::Slide;
use core::cmp::Ordering;

/// A value and the time at which the motion has it first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct At<F> {
    pub(super) value: F,
    pub(super) time: F,
    /// Whether it is a limit, which the motion has at no time.
    is_limit: bool,
}

impl<F: Number> At<F> {
    fn or(self, is_other: Option<bool>, other: Self) -> Option<Self> {
        if is_other.is_none() && self.is_limit != other.is_limit {
            return None;
        }
        let is_limit = if is_other == Some(false) { self.is_limit } else { other.is_limit };
        let value = F::chosen(is_other, other.value, self.value)?;
        Some(Self { value, time: F::chosen(is_other, other.time, self.time)?, is_limit })
    }

    /// The time, if there is one.
    pub(super) fn at_time(&self) -> Option<F> {
        (!self.is_limit).then_some(self.time)
    }
}

/// The greatest and the least value of a quantity.
#[derive(Debug, Clone, Copy)]
pub(super) struct Range<F> {
    pub(super) most: At<F>,
    pub(super) least: At<F>,
}

impl<F: Number> Range<F> {
    fn new(value: F, time: F) -> Self {
        let at = At { value, time, is_limit: false };
        Self { most: at, least: at }
    }

    #[inline]
    fn include(&mut self, value: F, time: F) -> Option<()> {
        self.include_at(At { value, time, is_limit: false })
    }

    #[inline]
    fn include_at(&mut self, at: At<F>) -> Option<()> {
        let is_most = F::is_above(at.value, self.most.value);
        let is_least = F::is_above(self.least.value, at.value);
        if (is_most, is_least) == (Some(false), Some(false)) {
            return Some(());
        }
        self.most = self.most.or(is_most, at)?;
        self.least = self.least.or(is_least, at)?;
        Some(())
    }

    /// Whether all numbers between two and up to `beyond` outside them are within the range.
    #[inline(always)]
    fn has_between(&self, [one, other]: [F; 2], beyond: F) -> bool {
        let top = F::chosen(F::is_above(one, other), one, other);
        let bottom = F::chosen(F::is_above(one, other), other, one);
        top.is_some_and(|top| F::is_above(top + beyond, self.most.value) == Some(false))
            && bottom.is_some_and(|bottom| F::is_above(self.least.value, bottom - beyond) == Some(false))
    }

    /// Whether a value is within the range.
    pub(super) fn has(&self, value: F) -> bool {
        F::is_above(value, self.most.value) == Some(false)
            && F::is_above(self.least.value, value) == Some(false)
    }
}

/// The longest swing between two turning points.
#[derive(Debug, Clone, Copy)]
pub(super) struct Swing<F> {
    /// The way from one to the other; 0 where there was none.
    pub(super) length: F,
    /// The work of friction and damper in it, per mass.
    pub(super) loss: F,
}

/// A turning point: the place at which the body rests and the work of the load up to it, and the direction from there.
#[derive(Debug, Clone, Copy)]
struct Turn<F> {
    x: F,
    load_work: F,
    sign: F,
}

/// The sums and extremes of a motion, per mass.
#[derive(Debug, Clone)]
pub(super) struct Totals<F> {
    pub(super) displacement: Range<F>,
    pub(super) velocity: Range<F>,
    /// a, and a − f: with a force the acceleration, and the force on the support with its sign turned; with a moving
    /// surface the acceleration in relation to it, and in space.
    pub(super) acceleration: Range<F>,
    pub(super) free_acceleration: Range<F>,
    pub(super) slides: u64,
    /// Ends of slides that a rest follows.
    pub(super) stops: u64,
    /// Ends of slides that a slide back follows at once.
    pub(super) reversals: u64,
    is_counted: bool,
    pub(super) stick_time: F,
    /// The time at rest at the last stop.
    stick_time_before: F,
    pub(super) path: F,
    /// ∫ f v dt, without the constant force.
    pub(super) load_work: F,
    /// ∫ 2βu′v dt of a support on which the damper stands.
    pub(super) foot_work: F,
    pub(super) swing: Swing<F>,
    /// Whether the support has let go of the spring, without which there is no further cycle.
    is_free: bool,
    /// The turning point before; none at a start with a velocity.
    turn: Option<Turn<F>>,
    omega: F,
    /// ω², and the constant force per mass.
    square: F,
    mean: F,
    from: F,
}

impl<F: Number> Totals<F> {
    /// Of a body at x with the velocity v and the acceleration a at a time, under a load.
    pub(super) fn new(constants: &Constants<F>, [x, v, a]: [F; 3], load: F, time: F) -> Self {
        let zero = F::int(0);
        Self {
            displacement: Range::new(x, time),
            velocity: Range::new(v, time),
            acceleration: Range::new(a, time),
            free_acceleration: Range::new(a - load, time),
            slides: 0,
            stops: 0,
            reversals: 0,
            is_counted: false,
            stick_time: zero,
            stick_time_before: zero,
            path: zero,
            load_work: zero,
            foot_work: zero,
            swing: Swing { length: zero, loss: zero },
            is_free: false,
            turn: None,
            omega: constants.square.sqrt(),
            square: constants.square,
            mean: constants.mean,
            from: x,
        }
    }

    /// The motion begins with a velocity, and not at a turning point.
    pub(super) fn starts_within_a_swing(&mut self) {
        self.turn = None;
    }

    /// Takes the swing from the turning point before to this place, if it is the longest one.
    ///
    /// The body rests at both ends, so that friction and damper take `∫ (f + p̄) dx − ω²Δ(x²)/2`.
    #[inline(always)]
    fn swings(&mut self, x: F) -> Option<()> {
        let Some(turn) = self.turn.filter(|_| !self.is_free) else { return Some(()) };
        let way = x - turn.x;
        let length = way.abs();
        let is_longest = F::is_above(length, self.swing.length);
        if is_longest != Some(false) {
            let middle = (x + turn.x) * F::ratio(1, 2);
            let loss = self.load_work - turn.load_work + way * (self.mean - self.square * middle);
            self.swing.length = F::chosen(is_longest, length, self.swing.length)?;
            self.swing.loss = F::chosen(is_longest, loss, self.swing.loss)?;
        }
        Some(())
    }

    /// Adds the works of a load that ends at `last` with this slope, and 2βu′ of the support, on a way with this integral.
    #[inline(always)]
    pub(super) fn works(&mut self, [last, slope, foot]: [F; 3], moved: F, area: F) {
        self.load_work = self.load_work + last * moved - slope * area;
        self.foot_work = self.foot_work + foot * moved;
    }

    /// Includes a quantity g(t) over a stretch, its extremes inside it, too.
    ///
    /// `at` gives g and four derivatives at a time; `longest` is that of the search. g″ is a free vibration and g′ such a vibration plus a constant, so
    /// that g″ has one zero at most on a stretch, and g′ two, one on either side of it.
    #[inline(never)]
    fn include(
        range: &mut Range<F>,
        [time, length]: [F; 2],
        [start, end]: [[F; 5]; 2],
        longest: Option<F>,
        at: impl Fn(F) -> Option<[F; 5]>,
    ) -> Option<()> {
        range.include(start[0], time)?;
        range.include(end[0], time + length)?;
        let sign_of = |x: F| Some(x.positive()?.cmp(&x.negative()?));
        let number = |sign: Ordering| if sign == Ordering::Less { F::int(-1) } else { F::int(1) };
        let are_opposite = |one: Ordering, two: Ordering| one != Ordering::Equal && two == one.reverse();
        let (first, last) = (sign_of(start[1])?, sign_of(end[1])?);
        let (bend, last_bend) = (sign_of(start[2])?, sign_of(end[2])?);
        let nothing = F::int(0);
        // The zero of g′ between two moments, where it has the sign `sign` at the first.
        let extreme = |[low, high]: [F; 2], [from, to]: [&[F; 5]; 2], sign: Ordering| {
            let of = |[_, d1, d2, d3, d4]: [F; 5]| [d1, d2, d3, d4].map(|d| number(sign) * d);
            let ends = [from, to].map(|g| [number(sign) * g[1], number(sign) * g[2]]);
            let t = F::zero_within([low, high], longest, ends, |t| at(t).map(of))?;
            Some((at(t)?[0], time + t))
        };
        if are_opposite(first, last) {
            // Where g″ has no zero, g is on one side of its tangents at the ends, which meet this far beyond both.
            let (down, up) = (start[1].abs(), end[1].abs());
            let beyond = number(first) * (down * up / (down + up) * length);
            if bend == last_bend
                && bend != Ordering::Equal
                && range.has(start[0] + beyond)
                && range.has(end[0] + beyond)
            {
                return Some(());
            }
            let (g, t) = extreme([nothing, length], [&start, &end], first)?;
            return range.include(g, t);
        }
        if are_opposite(bend, last_bend) && first == last && are_opposite(bend, first) {
            let sign = number(bend);
            let ends = [start, end].map(|g| [sign * g[2], sign * g[3]]);
            let turn = F::zero_within([nothing, length], longest, ends, |t| {
                // The fifth derivative serves the error of the last step alone, which the fourth bounds as well.
                let [_, _, d2, d3, d4] = at(t)?;
                Some([d2, d3, d4, d4].map(|d| sign * d))
            })?;
            let middle = at(turn)?;
            if are_opposite(first, sign_of(middle[1])?) {
                let (g, t) = extreme([nothing, turn], [&start, &middle], first)?;
                range.include(g, t)?;
                let (g, t) = extreme([turn, length], [&middle, &end], first.reverse())?;
                range.include(g, t)?;
            }
        }
        Some(())
    }
}

impl<F: Number> Totals<F> {
    /// Includes the extremes of a stretch that is short enough for the certificate of a stop.
    #[inline(always)]
    pub(super) fn extremes(
        &mut self,
        linear: &Linear<F>,
        slide: &Slide<F>,
        stretch: &Stretch<'_, F>,
    ) -> Option<()> {
        let Stretch { length, load: [first, last], end, .. } = *stretch;
        let beyond = slide.beyond(&linear.law, self.omega, length);
        let is_inside = [
            self.velocity.has_between([slide.v, end.v], beyond[0]),
            self.acceleration.has_between([slide.a, end.a], beyond[1]),
            self.free_acceleration.has_between([slide.a - first, end.a - last], beyond[1]),
        ];
        if is_inside == [true; 3] {
            return Some(());
        }
        self.include_extremes(linear, slide, stretch, is_inside)
    }

    /// Includes the extremes of velocity, acceleration and force of a stretch, but of those that are inside their ranges.
    #[inline(never)]
    fn include_extremes(
        &mut self,
        linear: &Linear<F>,
        slide: &Slide<F>,
        stretch: &Stretch<'_, F>,
        [has_velocity, has_acceleration, has_free]: [bool; 3],
    ) -> Option<()> {
        let Stretch { time, length, load: [first, last], end, .. } = *stretch;
        let next = |[.., third, fourth]: [F; 5]| linear.law.next(third, fourth);
        let at = |t: F| {
            let moment = slide.at(linear, t)?;
            let g = slide.derivatives(&linear.law, moment.v, moment.a);
            Some((g, next(g)))
        };
        let ends = slide.derivatives_at_ends(&linear.law, length, end).map(|g| (g, next(g)));
        let (times, longest) = ([time, length], linear.longest_step(length));
        // Where it touches zero, the velocity is none of the other direction, but for rounding.
        let of_velocity = |([v, a, jerk, bend, third], _): ([F; 5], F)| {
            [slide.sign * (slide.sign * v).larger(F::int(0)), a, jerk, bend, third]
        };
        if !has_velocity {
            Self::include(&mut self.velocity, times, ends.map(of_velocity), longest, |t| {
                at(t).map(of_velocity)
            })?;
        }
        let of_acceleration =
            |([_, a, jerk, bend, third], fourth): ([F; 5], F)| [a, jerk, bend, third, fourth];
        let of = ends.map(of_acceleration);
        if !has_acceleration {
            Self::include(&mut self.acceleration, times, of, longest, |t| at(t).map(of_acceleration))?;
        }
        if has_free {
            return Some(());
        }
        // The jerk less the slope of the load is exactly 0 at a release without an excess of static friction.
        let less = |load: F, ([v, a, _, bend, third], fourth): ([F; 5], F)| {
            [a - load, linear.law.next(v, a), bend, third, fourth]
        };
        let [start, finish] = ends;
        Self::include(
            &mut self.free_acceleration,
            times,
            [less(first, start), less(last, finish)],
            longest,
            |t| Some(less(first + slide.slope * t, at(t)?)),
        )
    }
}

impl<F: Number> Watch<F> for Totals<F> {
    #[inline(always)]
    fn slid(&mut self, linear: &Linear<F>, slide: &Slide<F>, stretch: &Stretch<'_, F>) -> Option<()> {
        let Stretch { time, length, load: [_, last], responses, end, foot, is_short, .. } = *stretch;
        let area = slide.area(&linear.law, responses);
        self.works([last, slide.slope, foot], end.moved, area);
        if !is_short {
            self.velocity.include(end.v, time + length)?;
            self.acceleration.include(end.a, time + length)?;
            return self.free_acceleration.include(end.a - last, time + length);
        }
        self.extremes(linear, slide, stretch)
    }

    #[inline(always)]
    fn rested(&mut self, _: F, piece: &Piece<F>, start: F, from: F, length: F) -> Option<()> {
        self.stick_time = self.stick_time + length;
        let zero = F::int(0);
        self.acceleration.include(zero, start + from)?;
        self.velocity.include(zero, start + from)?;
        for t in [from, from + length] {
            self.free_acceleration.include(-(piece.from + piece.slope * t), start + t)?;
        }
        Some(())
    }

    #[inline(always)]
    fn released(&mut self, _: F, x: F, sign: F, onset: Onset) {
        // A body that goes on in its direction is in the same swing.
        if self.turn.is_none_or(|turn| (turn.sign * sign).negative() != Some(false)) {
            self.turn = Some(Turn { x, load_work: self.load_work, sign });
        }
        let (slides, stops, reversals) = match onset {
            Onset::Released => (1, 0, 0),
            Onset::Reversed => (1, 1, 1),
            Onset::Touched => {
                self.stick_time = self.stick_time_before;
                (0, 1, 0)
            }
        };
        if !self.is_counted {
            self.slides = self.slides.saturating_add(slides);
            self.stops = self.stops.saturating_sub(stops);
            self.reversals = self.reversals.saturating_add(reversals);
        }
        self.from = x;
    }

    #[inline(always)]
    fn stopped(&mut self, time: F, x: F) -> Option<()> {
        self.stick_time_before = self.stick_time;
        self.stops = self.stops.saturating_add(u64::from(!self.is_counted));
        self.swings(x)?;
        self.goes_on(x, time)
    }

    fn struck(&mut self, [before, after]: [F; 2], time: F) -> Option<()> {
        self.load_work = self.load_work + (after - before) * (after + before) * F::ratio(1, 2);
        self.velocity.include(after, time)
    }

    fn freed(&mut self) {
        self.is_free = true;
    }

    fn counted(&mut self) {
        self.is_counted = true;
    }

    fn stays(&mut self, load: F, time: F) -> Option<()> {
        let zero = F::int(0);
        self.velocity.include(zero, time)?;
        self.acceleration.include(zero, time)?;
        self.free_acceleration.include(-load, time)
    }

    #[inline(always)]
    fn goes_on(&mut self, x: F, time: F) -> Option<()> {
        self.path = self.path + (x - self.from).abs();
        self.displacement.include(x, time)
    }

    fn tends_to(&mut self, [now, x]: [F; 2], load: F, swings: F) -> Option<()> {
        self.load_work = self.load_work + load * (x - now);
        self.swings(x)?;
        self.path = self.path + (x - self.from).abs() * swings;
        let zero = F::int(0);
        let limit = |value: F| At { value, time: zero, is_limit: true };
        self.displacement.include_at(limit(x))?;
        self.velocity.include_at(limit(zero))?;
        self.acceleration.include_at(limit(zero))?;
        self.free_acceleration.include_at(limit(-load))
    }
}
