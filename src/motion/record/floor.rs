//! Floor spectra: linear oscillators that stand on the body, driven by its absolute acceleration.
//!
//! Relative to the body an oscillator obeys `y″ + 2ζν y′ + ν²y = −A(t)`, ν = 2π/T. While the body slides, the part x″ of its
//! absolute acceleration A is a free vibration, and the part of a moving surface a straight line; at rest only the latter is
//! left. On a piece that is short beside ν, ω and 2β, both A and y are therefore power series whose coefficients follow from
//! each other and fall like 2ⁿ/n!, so that a piece adds no error but rounding, at resonance, too. The pieces end at the events
//! of the body.
//!
//! An extreme of a polynomial on a piece is not above the larger end by more than an eighth of the greatest second derivative:
//! pieces whose bound is below the extreme so far are left, and others are halved until the bound is the value.

use super::answers::failed;
use super::body::Body;
use super::follow::{Failure, Follower, Mode, Onset, Stretch, Watch};
use super::linear::{Free, Linear};
use super::load::{Piece, Record};
use super::number::Number;
use super::settle::Rest;
use super::slide::Slide;
use crate::float::Float;
use crate::machine::error::{Error, Quantity, written};
use crate::machine::ratios::within;
use alloc::vec::Vec;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// The greatest response of a linear oscillator that stands on a body under a record.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct FloorResponse<F> {
    /// Natural period T.
    pub period: F,
    /// Greatest displacement in relation to the body, regardless of sign.
    pub max_displacement: F,
    /// Pseudo-acceleration: (2π/T)² times the greatest displacement.
    pub pseudo_acceleration: F,
    /// Greatest acceleration in space, regardless of sign.
    pub max_absolute_acceleration: F,
}

/// The most pieces in which one oscillator is followed.
const MOST_PIECES: u32 = 40_000_000;
/// The greatest ratio of the record's duration and a period, or the inverse.
const MOST_RATIO: i32 = 1_000_000;

/// An acceleration over a stretch: a free vibration, and less a load that is a straight line.
#[derive(Debug, Clone, Copy)]
struct Shaking<F> {
    /// The vibration and its derivative at the start, with 2β and ω².
    start: [F; 2],
    law: [F; 2],
    /// The load and its slope.
    load: [F; 2],
    length: F,
}

/// An oscillator on its way.
#[derive(Debug)]
struct Oscillator<F> {
    period: F,
    /// ν, 2ζν and ν².
    frequency: F,
    rate: F,
    square: F,
    /// y and y′.
    state: [F; 2],
    most: [F; 2],
    /// The pieces that may still be taken.
    left: u32,
}

/// Oscillators that are driven while the body is followed.
struct Floor<F> {
    oscillators: Vec<Oscillator<F>>,
    /// Whether the load is an acceleration of the surface, which A includes.
    is_surface: bool,
    /// The terms of a series.
    terms: usize,
    /// The coefficients of A, of y and of the absolute acceleration.
    series: [Vec<F>; 3],
}

/// The sum of a series at 1, and of its derivative.
fn at_end<F: Float>(series: &[F]) -> [F; 2] {
    let zero = F::int(0);
    series
        .iter()
        .enumerate()
        .rev()
        .fold([zero, zero], |[sum, slope], (n, &c)| [sum + c, slope + F::count(n) * c])
}

/// Raises `most` to the greatest absolute value of a polynomial in [0, 1].
fn include<F: Float>(most: &mut F, series: &[F]) {
    let zero = F::int(0);
    let value = |t: F| series.iter().rev().fold(zero, |sum, &c| sum * t + c);
    let (first, last) = (series.first().map_or(zero, |c| c.abs()), at_end(series)[0].abs());
    *most = most.or_larger(first).or_larger(last);
    let bend = |(n, &c): (usize, &F)| F::count(n) * F::count(n.saturating_sub(1)) * c.abs();
    let eighth = series.iter().enumerate().map(bend).fold(zero, |sum, term| sum + term) * F::ratio(1, 8);
    // Intervals by their first end, their length, and their greatest value at an end.
    let mut open = Vec::new();
    open.push((zero, F::int(1), first, last));
    while let Some((from, length, left, right)) = open.pop() {
        let bound = left.or_larger(right) + eighth * length.square();
        let is_open = bound > *most * (F::int(1) + F::epsilon() * F::int(4)) && length > F::epsilon();
        if !is_open {
            continue;
        }
        let half = length * F::ratio(1, 2);
        let middle = value(from + half).abs();
        *most = most.or_larger(middle);
        open.push((from, half, left, middle));
        open.push((from + half, half, middle, right));
    }
}

impl<F: Float> Oscillator<F> {
    fn new(period: F, damping_ratio: F) -> Self {
        let frequency = F::int(2) * F::pi() / period;
        let zero = F::int(0);
        Self {
            period,
            frequency,
            rate: F::int(2) * damping_ratio * frequency,
            square: frequency.square(),
            state: [zero; 2],
            most: [zero; 2],
            left: MOST_PIECES,
        }
    }

    /// Drives the oscillator through a stretch; `None` where that takes too many pieces.
    fn drive(&mut self, shaking: &Shaking<F>, terms: usize, series: &mut [Vec<F>; 3]) -> Option<()> {
        let Shaking { start, law: [rate, square], load: [load, slope], length } = *shaking;
        let fastest = self.frequency.or_larger(square.sqrt()).or_larger(rate);
        let parts = (length * fastest).to_f64().ceil().max(1.0);
        if parts.is_nan() || parts > f64::from(self.left) {
            self.left = 0;
            return None;
        }
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a whole number within u32"
        )]
        let parts = parts as u32;
        self.left = self.left.saturating_sub(parts);
        let h = length / F::from_f64(f64::from(parts));
        let [mut a, mut jerk] = start;
        // The next coefficient of f″ + rf′ + sf + forcing, from those before.
        let next = |n: usize, [r, s]: [F; 2], [now, after]: [F; 2], forcing: F| {
            let k = F::count(n);
            let one = F::int(1);
            -(r * h * (k + one) * after + s * h.square() * now + forcing) / ((k + one) * (k + one + one))
        };
        let [shakes, moves, feels] = series;
        for part in 0..parts {
            let t = h * F::from_f64(f64::from(part));
            shakes.clear();
            moves.clear();
            feels.clear();
            let (mut now, mut after) = ([a, self.state[0]], [jerk * h, self.state[1] * h]);
            for n in 0..terms {
                let from_load = match n {
                    0 => load + slope * t,
                    1 => slope * h,
                    _ => F::int(0),
                };
                shakes.push(now[0]);
                moves.push(now[1]);
                // y″ + A = −2ζν y′ − ν²y.
                feels
                    .push(-(self.rate * F::count(n.saturating_add(1)) * after[1] / h + self.square * now[1]));
                let forcing = h.square() * (now[0] - from_load);
                let then = [
                    next(n, [rate, square], [now[0], after[0]], F::int(0)),
                    next(n, [self.rate, self.square], [now[1], after[1]], forcing),
                ];
                (now, after) = (after, then);
            }
            let (shaken, moved) = (at_end(shakes), at_end(moves));
            (a, jerk) = (shaken[0], shaken[1] / h);
            self.state = [moved[0], moved[1] / h];
            include(&mut self.most[0], moves);
            include(&mut self.most[1], feels);
        }
        Some(())
    }

    fn response(&self) -> FloorResponse<F> {
        let [displacement, acceleration] = self.most;
        FloorResponse {
            period: self.period,
            max_displacement: displacement,
            pseudo_acceleration: self.square * displacement,
            max_absolute_acceleration: acceleration,
        }
    }
}

impl<F: Float> Floor<F> {
    fn drive(&mut self, shaking: Shaking<F>) -> Option<()> {
        if shaking.length <= F::int(0) {
            return Some(());
        }
        let load = if self.is_surface { shaking.load } else { [F::int(0); 2] };
        let shaking = Shaking { load, ..shaking };
        let (terms, series) = (self.terms, &mut self.series);
        self.oscillators.iter_mut().try_for_each(|oscillator| oscillator.drive(&shaking, terms, series))
    }

    /// The motion after its last event: of a body at rest, on which a free vibration has all its extremes in a period, or one
    /// that tends to a limit.
    fn end(&mut self, follower: &Follower<F>, rest: &Rest<F>, load: F, damping_ratio: F) -> Option<()> {
        let zero = F::int(0);
        if let (Rest::Limit(_), Mode::Slide(sign)) = (rest, follower.mode) {
            let linear = &follower.linear;
            let decay = match linear.free {
                Free::Oscillating { decay, .. } => decay,
                Free::Creeping { slow, .. } if slow > zero => slow,
                Free::Creeping { fast, .. } => fast,
                Free::Critical { decay, .. } => decay,
            };
            let slide = follower.slide(zero, sign);
            self.drive(Shaking {
                start: [slide.a, slide.jerk(&linear.law, slide.v, slide.a)],
                law: [linear.law.rate, linear.law.square],
                load: [load, zero],
                // The rest is below the rounding of the beginning.
                length: F::count(usize::try_from(F::precision()).unwrap_or(usize::MAX)) * F::ratio(3, 4)
                    / decay,
            })?;
        }
        if matches!(rest, Rest::Never { .. }) {
            return Some(());
        }
        let load = if self.is_surface { load } else { zero };
        let (terms, series) = (self.terms, &mut self.series);
        let slower = (F::int(1) - damping_ratio.square()).sqrt();
        self.oscillators.iter_mut().try_for_each(|oscillator| {
            let length = oscillator.period / slower;
            let shaking = Shaking { start: [zero; 2], law: [zero; 2], load: [load, zero], length };
            oscillator.drive(&shaking, terms, series)
        })
    }
}

impl<F: Float> Watch<F> for Floor<F> {
    fn slid(&mut self, linear: &Linear<F>, slide: &Slide<F>, stretch: &Stretch<'_, F>) -> Option<()> {
        self.drive(Shaking {
            start: [slide.a, slide.jerk(&linear.law, slide.v, slide.a)],
            law: [linear.law.rate, linear.law.square],
            load: [stretch.load[0], slide.slope],
            length: stretch.length,
        })
    }

    fn rested(&mut self, _: F, piece: &Piece<F>, _: F, from: F, length: F) -> Option<()> {
        let zero = F::int(0);
        let load = [piece.from + piece.slope * from, piece.slope];
        self.drive(Shaking { start: [zero; 2], law: [zero; 2], load, length })
    }

    fn released(&mut self, _: F, _: F, _: F, _: Onset) {}

    fn stopped(&mut self, _: F, _: F) -> Option<()> {
        Some(())
    }

    fn struck(&mut self, [before, after]: [F; 2], _: F) -> Option<()> {
        for Oscillator { state: [_, velocity], .. } in &mut self.oscillators {
            *velocity = *velocity - (after - before);
        }
        Some(())
    }

    fn freed(&mut self) {}

    fn counted(&mut self) {}

    fn stays(&mut self, _: F, _: F) -> Option<()> {
        Some(())
    }

    fn goes_on(&mut self, _: F, _: F) -> Option<()> {
        Some(())
    }

    fn tends_to(&mut self, _: [F; 2], _: F, _: F) -> Option<()> {
        Some(())
    }
}

impl<F: Float> Body<F> {
    /// The floor spectrum: the greatest responses of linear oscillators of these natural periods and one damping ratio that
    /// stand on the body while it moves under a record from x with the velocity v. They begin at rest on the body, and their
    /// mass is none beside its own.
    ///
    /// They are followed exactly, until the body has come to rest and a period beyond; of a motion that never ends, to
    /// [`RecordAnswer::cut_time`](super::RecordAnswer::cut_time). At f64 the responses are accurate to some 10⁻¹³ of the
    /// greatest over a few thousand samples.
    ///
    /// # Errors
    /// As [`Body::follow_from`]; where the damping ratio is not within [0, 0.99], or a period not within 10⁻⁶ and 10⁶ times
    /// the duration of the record; and [`Error::TooManyEvents`] where the body is so stiff or its decay so slow that more than
    /// 4·10⁷ pieces are needed.
    pub fn floor_spectrum(
        &self,
        record: &Record<F>,
        x: F,
        v: F,
        periods: &[F],
        damping_ratio: F,
    ) -> Result<Vec<FloorResponse<F>>, Error> {
        let most = F::ratio(99, 100);
        if !(damping_ratio >= F::int(0) && damping_ratio <= most) {
            return Err(Error::OutOfRange {
                quantity: Quantity::DampingRatio,
                value: written(damping_ratio),
                least: written(F::int(0)),
                greatest: written(most),
            });
        }
        let duration = record.end() - record.time(0);
        let many = F::int(MOST_RATIO);
        let oscillators = periods.iter().map(|&period| {
            let period = within(Quantity::NaturalPeriod, period, duration / many, duration * many)?;
            Ok(Oscillator::new(period, damping_ratio))
        });
        let mut terms = 2usize;
        let mut size = F::int(1);
        while size > F::epsilon() * F::ratio(1, 64) {
            terms = terms.saturating_add(1);
            size = size * F::int(2) / F::count(terms);
        }
        let mut floor = Floor {
            oscillators: oscillators.collect::<Result<_, Error>>()?,
            is_surface: record.excitation().carries_surface(),
            terms,
            series: [Vec::new(), Vec::new(), Vec::new()],
        };
        let mut followed = self.followed(record, x, v)?;
        let load = followed.factors.after(record.after(), record.last());
        let is_long = |floor: &Floor<F>| floor.oscillators.iter().any(|oscillator| oscillator.left == 0);
        let end = record.end();
        let too_long = || failed((Failure::Bound, end));
        let ended = self.watched(record, &mut followed.follower, &followed.factors, &mut floor);
        let ended = ended.map_err(|error| if is_long(&floor) { too_long() } else { error })?;
        floor.end(&followed.follower, &ended.rest, load, damping_ratio).ok_or_else(too_long)?;
        Ok(floor.oscillators.iter().map(Oscillator::response).collect())
    }
}
