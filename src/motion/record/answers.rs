//! What a record does to a body: its extremes, its residual displacement, its stops and its work.

use super::alone;
use super::body::{Body, Constants};
use super::damper::Damper;
use super::follow::{Failed, Failure, Follower, Mode, Onset, Watch};
use super::load::{After, Factors, Piece, Record};
use super::number::Number;
use super::quiet::Followed;
use super::settle::Rest;
use super::totals::{Swing, Totals};
use crate::float::Float;
use crate::machine::error::{Error, Quantity, written};
use crate::machine::excitation::Excitation;
use crate::machine::ratios::finite;
use crate::output::Kind;

/// An answer: a number, which may not exist, or a count.
#[doc(hidden)]
#[derive(Debug)]
pub enum Entry<'a, T> {
    Value(Option<&'a T>),
    Count(u64),
}

/// One row for each answer: its type with its kind, and which of a number, an optional number and a count it is.
macro_rules! answers {
    ($($(#[$doc:meta])+ $answer:ident: $type:ty, $form:ident $kind:ident;)*) => {
        /// The motion of a body under a record and after it, until it rests: extremes, sums and counts, in the units of the
        /// body and the record.
        ///
        /// With a moving surface, displacement and velocity are those in relation to it. Displacements are counted from
        /// the position in which the spring is relaxed, whatever the constant force.
        ///
        /// After the record the load is that of [`Record::after`]. The answers are of the whole
        /// motion, to its rest or to the limit it tends to. A motion that never ends is cut, at
        /// [`RecordAnswer::cut_time`]: without friction and damper after one more period, which has all extremes; on a
        /// slope that is steeper than friction where the slide begins that does not end, or at the end of the record.
        ///
        /// Extremes are those of all times at which the body slides, or rests for a time > 0; an instant between two slides
        /// is none of them, nor is that of an impulse. An extreme that is the limit of the motion has no time.
        #[derive(Debug, Clone, Copy, PartialEq)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[non_exhaustive]
        pub struct RecordAnswer<F> {
            $($(#[$doc])+ pub $answer: $type,)*
            /// Whether the body never rests, and only tends to the residual displacement.
            pub tends_to_rest: bool,
        }

        impl<F> RecordAnswer<F> {
            /// The names of the answers, their kinds and their values.
            #[doc(hidden)]
            pub fn entries(&self) -> [(&'static str, Kind, Entry<'_, F>); [$(Kind::$kind),*].len()] {
                [$((stringify!($answer), Kind::$kind, answers!(@entry $form self.$answer))),*]
            }

            /// The answers in another form; `None` where one has none.
            #[cfg(feature = "mp")]
            pub(crate) fn map<G>(&self, of: impl Fn(&F) -> Option<G>) -> Option<RecordAnswer<G>> {
                Some(RecordAnswer {
                    $($answer: answers!(@map $form of, self.$answer),)*
                    tends_to_rest: self.tends_to_rest,
                })
            }
        }
    };
    (@entry number $value:expr) => { Entry::Value(Some(&$value)) };
    (@entry optional $value:expr) => { Entry::Value($value.as_ref()) };
    (@entry count $value:expr) => { Entry::Count($value) };
    (@map number $of:ident, $value:expr) => { $of(&$value)? };
    (@map optional $of:ident, $value:expr) => {
        match &$value {
            Some(value) => Some($of(value)?),
            None => None,
        }
    };
    (@map count $of:ident, $value:expr) => { $value };
}

answers! {
    /// Greatest displacement.
    max_displacement: F, number Length;
    /// Its time; `None` where it is a limit.
    max_displacement_time: Option<F>, optional Time;
    /// Least displacement.
    min_displacement: F, number Length;
    /// Its time; `None` where it is a limit.
    min_displacement_time: Option<F>, optional Time;
    /// Greatest |x|: the larger of the greatest displacement and the least one turned.
    peak_displacement: F, number Length;
    /// Greatest velocity.
    max_velocity: F, number Velocity;
    /// Its time; `None` where it is a limit.
    max_velocity_time: Option<F>, optional Time;
    /// Least velocity.
    min_velocity: F, number Velocity;
    /// Its time; `None` where it is a limit.
    min_velocity_time: Option<F>, optional Time;
    /// Greatest absolute acceleration: in space, where the surface moves.
    max_absolute_acceleration: F, number Acceleration;
    /// Greatest force of spring, damper and friction together on the body's support.
    max_transmitted_force: F, number Force;
    /// Displacement at the end of the record.
    end_displacement: F, number Length;
    /// Velocity at the end of the record.
    end_velocity: F, number Velocity;
    /// Displacement in which the body rests in the end, or which it creeps to; `None` where it never rests.
    residual_displacement: Option<F>, optional Length;
    /// Time up to which a motion is followed that never ends; `None` where it rests or tends to a limit.
    cut_time: Option<F>, optional Time;
    /// Path.
    path: F, number Length;
    /// Slides: times of motion in one direction. A velocity that touches zero and goes on ends none. Where a vibration
    /// without friction decays for ever, slides, stops and reversals are those of the record.
    slides: u64, count Ratio;
    /// Stops: ends of slides that a rest follows.
    stops: u64, count Ratio;
    /// Reversals: ends of slides that a slide in the other direction follows at once.
    reversals: u64, count Ratio;
    /// Time at rest during the record.
    stick_time: F, number Time;
    /// Amplitude D of the greatest cycle: half the distance between the turning points of the longest swing, over the rests
    /// in it. The cycle is this swing and its mirror image back. `None` where the body does not swing from rest to rest, and
    /// where it moves one way. A support that lets go ends the last cycle.
    cycle_amplitude: Option<F>, optional Length;
    /// Equivalent stiffness of the greatest cycle, k + r/D: the difference of the resisting force k x + c x′ + friction
    /// between the turning points, on arrival, over that of the displacements.
    equivalent_stiffness: Option<F>, optional Stiffness;
    /// Equivalent damping ratio of the greatest cycle: the energy that friction and damper take in it, over 2π k_eq D². `None`
    /// also where the equivalent stiffness is 0.
    equivalent_damping_ratio: Option<F>, optional Ratio;
    /// Work of friction.
    friction_work: F, number Energy;
    /// Work of the damper: ∫ c x′² dt, or ∫ c(x′ − u′)² dt where it stands on a moving support u, over the times between its
    /// jumps, whose own work has no bound.
    damper_work: F, number Energy;
    /// Work of the load and of the constant force on the body: ∫ (p + p̄)x′ dt with the force p, −m a of an acceleration a of
    /// the surface, or k u + c u′ of a support.
    load_work: F, number Energy;
}

/// The state at the end of a record, and the rest after it.
#[derive(Debug, Clone, Copy)]
pub(super) struct End<F> {
    pub(super) x: F,
    pub(super) v: F,
    pub(super) rest: Rest<F>,
    /// Whether the support of the spring has let go at the end of the record.
    pub(super) is_free: bool,
    /// ∫ 2βu′² dt of a support on which the damper stands.
    pub(super) foot: F,
}

impl<F: Number> Follower<F> {
    /// Follows the body from the end of a record, with this last sample, to its rest; whether the support of its spring has let
    /// go.
    pub(super) fn ended(
        &mut self,
        (after, excitation): (After, Excitation),
        factors: &Factors<F>,
        [end, last]: [F; 2],
        watch: &mut impl Watch<F>,
    ) -> Result<(Rest<F>, bool), Failure> {
        let is_free = after == After::Free && excitation.moves_foot();
        if is_free {
            watch.freed();
            self.let_go(excitation == Excitation::DampedFootMotion);
        } else if after == After::Zero {
            self.jump(factors, [last, F::int(0)], end, watch).ok_or(Failure::Uncertain)?;
        }
        Ok((self.settle(end, factors.after(after, last), watch)?, is_free))
    }
}

/// A body at the start of a record, at x with the velocity v, and what is collected of its motion.
pub(super) fn begun<F: Number>(
    constants: Constants<F>,
    [x, v]: [F; 2],
    longest_step: F,
    time: F,
    first: &Piece<F>,
) -> Option<(Follower<F>, Totals<F>)> {
    let follower = Follower::new(constants, [x, v], time, Some(longest_step))?;
    let a = follower.first_acceleration(first)?;
    let mut totals = Totals::new(&constants, [x, v, a], first.from, time);
    if let Mode::Slide(sign) = follower.mode {
        totals.released(time, x, sign, Onset::Released);
        totals.starts_within_a_swing();
    }
    Some((follower, totals))
}

impl<F: Float> End<F> {
    /// Follows a body from the end of a record to its rest.
    fn of(
        record: &Record<F>,
        follower: &mut Follower<F>,
        factors: &Factors<F>,
        watch: &mut impl Watch<F>,
    ) -> Result<Self, Error> {
        let end = record.end();
        let (x, v) = (follower.x, follower.v);
        let mut foot = F::int(0);
        if factors.damper > F::int(0) {
            for (_, length, samples) in record.steps().filter(|(_, length, _)| *length > F::int(0)) {
                let piece = Piece::new(factors, samples, length, F::int(1) / length);
                foot = foot + piece.work_at_rest(&follower.constants);
            }
        }
        let what = (record.after(), record.excitation());
        let ended = follower.ended(what, factors, [end, record.last()], watch);
        let (rest, is_free) = ended.map_err(|failure| failed((failure, end)))?;
        Ok(Self { x, v, rest, is_free, foot })
    }
}

impl<F: Float> Body<F> {
    /// The motion under a record from rest at x = 0.
    ///
    /// Slides and stops are those of the exact motion: between samples the load is a straight line, under which
    /// both are closed forms, and no stop is missed. At f64 the displacements are accurate to some 10⁻¹³ of their
    /// greatest value over a few thousand samples.
    ///
    /// # Errors
    /// [`Error::BeyondRange`] where the motion leaves the range of the type, [`Error::TooManyEvents`] where it has more
    /// than 10⁵ stops in one step or half turns after the record.
    pub fn follow(&self, record: &Record<F>) -> Result<RecordAnswer<F>, Error> {
        self.follow_from(record, F::int(0), F::int(0))
    }

    /// The motion under a record, from the displacement x and the velocity v.
    ///
    /// # Errors
    /// As [`Body::follow`], and where x or v is not finite, or v < 0 in a body that moves one way.
    pub fn follow_from(&self, record: &Record<F>, x: F, v: F) -> Result<RecordAnswer<F>, Error> {
        let mut followed = self.followed(record, x, v)?;
        alone::follow_alone(&mut followed, record);
        self.settled(record, [x, v], followed)
    }

    /// Fails where x or v is not finite, or v < 0 in a body that moves one way.
    pub(crate) fn check_start(&self, x: F, v: F) -> Result<(), Error> {
        finite(Quantity::Displacement, x)?;
        let v = finite(Quantity::Velocity, v)?;
        if self.is_one_way() && v < F::int(0) {
            return Err(Error::Negative { quantity: Quantity::Velocity, value: written(v) });
        }
        Ok(())
    }

    /// The body at the start of a record.
    pub(super) fn followed(&self, record: &Record<F>, x: F, v: F) -> Result<Followed<F>, Error> {
        self.check_start(x, v)?;
        let start = record.time(0);
        let constants = Constants::of(self, |x| x);
        let factors = Factors::new(record.excitation(), self.mass(), &constants);
        let first = record.steps().find(|(_, length, _)| *length > F::int(0));
        let first =
            first.map(|(_, length, samples)| Piece::new(&factors, samples, length, F::int(1) / length));
        let begun = first.and_then(|first| begun(constants, [x, v], record.longest_step(), start, &first));
        let (follower, totals) = begun.ok_or_else(|| failed((Failure::Uncertain, start)))?;
        Ok(Followed { follower, factors, totals, failure: None })
    }

    /// The answers of a body that was followed through a record from x and v.
    pub(super) fn settled(
        &self,
        record: &Record<F>,
        start: [F; 2],
        followed: Followed<F>,
    ) -> Result<RecordAnswer<F>, Error> {
        let Followed { mut follower, mut totals, failure, factors } = followed;
        if let Some(failure) = failure {
            return Err(failed(failure));
        }
        let rest = End::of(record, &mut follower, &factors, &mut totals)?;
        self.answered(record, start, rest, &totals)
    }

    /// Follows a body through a record and to its rest with somebody who watches.
    pub(super) fn watched(
        &self,
        record: &Record<F>,
        follower: &mut Follower<F>,
        factors: &Factors<F>,
        watch: &mut impl Watch<F>,
    ) -> Result<End<F>, Error> {
        for (time, length, samples) in record.steps() {
            let taken = if length > F::int(0) {
                let piece = Piece::new(factors, samples, length, F::int(1) / length);
                follower.step(&piece, time, None, watch)
            } else {
                follower.jump(factors, samples, time, watch).ok_or(Failure::Uncertain)
            };
            taken.map_err(|failure| failed((failure, time)))?;
        }
        End::of(record, follower, factors, watch)
    }

    /// The work of the damper of this body by its own integral, where the motion from x and v has an end.
    fn damper_work(&self, record: &Record<F>, [x, v]: [F; 2]) -> Result<Option<F>, Error> {
        let Followed { mut follower, factors, .. } = self.followed(record, x, v)?;
        let mut damper = Damper::new(follower.constants.rate);
        self.watched(record, &mut follower, &factors, &mut damper)?;
        Ok(damper.work().map(|work| work * self.mass()))
    }

    /// The answers of a motion from x and v.
    pub(super) fn answered(
        &self,
        record: &Record<F>,
        start: [F; 2],
        end: End<F>,
        totals: &Totals<F>,
    ) -> Result<RecordAnswer<F>, Error> {
        let weights = Weights::of(self, |x| x);
        let mut answer = weights.answer(record.excitation(), start, end, totals);
        if let Some(answer) = &mut answer {
            let size = answer.load_work.abs() + answer.friction_work.abs() + self.mass() * end.foot;
            if weights.has_damper && answer.damper_work.abs() < size * F::ratio(1, 1 << 20) {
                answer.damper_work = self.damper_work(record, start)?.unwrap_or(answer.damper_work);
            }
        }
        // Works and forces may leave a range that the motion is in.
        let answer = answer.filter(|answer| {
            answer.entries().iter().all(|(.., entry)| match entry {
                Entry::Value(Some(value)) => value.is_finite(),
                Entry::Value(None) | Entry::Count(_) => true,
            })
        });
        answer.ok_or_else(|| failed((Failure::Uncertain, record.end())))
    }
}

/// The amplitude, stiffness and damping ratio of the greatest cycle.
#[derive(Debug, Clone, Copy)]
struct Equivalent<F> {
    amplitude: Option<F>,
    stiffness: Option<F>,
    damping_ratio: Option<F>,
}

/// The parameters of a body that its answers have, and its motion per mass has not.
#[derive(Debug, Clone, Copy)]
pub(super) struct Weights<F> {
    pub(super) mass: F,
    pub(super) friction: F,
    pub(super) friction_offset: F,
    pub(super) stiffness: F,
    pub(super) mean_force: F,
    pub(super) has_damper: bool,
    pub(super) is_one_way: bool,
}

impl<F: Number> Weights<F> {
    /// Those of a body whose numbers are `known` as others.
    pub(super) fn of<G: Float>(body: &Body<G>, known: impl Fn(G) -> F) -> Self {
        Self {
            mass: known(body.mass()),
            friction: known(body.friction()),
            friction_offset: known(body.friction_offset()),
            stiffness: known(body.stiffness()),
            mean_force: known(body.mean_force()),
            has_damper: body.damping() != G::int(0),
            is_one_way: body.is_one_way(),
        }
    }

    /// The oscillator with a viscous damper that has the greatest cycle's turning points, forces there and energy:
    /// `k_eq = k + r/D`, and `ζ_eq = E/(2π k_eq D²)` with `E = 2(2rD + ∫c x′² dt)` over the swing.
    fn equivalent(&self, swing: &Swing<F>) -> Option<Equivalent<F>> {
        let two = F::int(2);
        if self.is_one_way || !swing.length.positive()? {
            return Some(Equivalent { amplitude: None, stiffness: None, damping_ratio: None });
        }
        let amplitude = swing.length / two;
        let force = self.stiffness * amplitude + self.friction;
        let stiffness = self.stiffness + self.friction / amplitude;
        let friction = self.friction * swing.length;
        let loss = if self.has_damper { self.mass * swing.loss } else { friction };
        let is_stiff = force.positive()?;
        let damping_ratio = is_stiff.then(|| loss / (F::pi() * (force * amplitude)));
        Some(Equivalent { amplitude: Some(amplitude), stiffness: Some(stiffness), damping_ratio })
    }

    /// The answers of a motion from x and v that was followed to its end.
    pub(super) fn answer(
        &self,
        excitation: Excitation,
        [x, v]: [F; 2],
        end: End<F>,
        totals: &Totals<F>,
    ) -> Option<RecordAnswer<F>> {
        let &Self { mass, friction, friction_offset, stiffness, mean_force, has_damper, .. } = self;
        let half = F::ratio(1, 2);
        let (last, speed, residual, cut) = match end.rest {
            Rest::At(x) | Rest::Limit(x) => (x, F::int(0), Some(x), None),
            Rest::Never { time, x, v } => (x, v, None, Some(time)),
        };
        let net = last - x;
        let friction_work = friction * totals.path + friction_offset * net;
        let load_work = mass * totals.load_work + mean_force * net;
        // A spring whose support has let go keeps what it stores.
        let stretched = if end.is_free { end.x } else { last };
        let stored =
            mass * (speed - v) * (speed + v) * half + stiffness * (stretched - x) * (stretched + x) * half;
        // ∫ c(x′ − u′)² dt is the work of the force −c x′, and what the support adds.
        let of_foot = mass * (end.foot - F::int(2) * totals.foot_work);
        let damper_work = if has_damper { load_work - friction_work - stored + of_foot } else { F::int(0) };
        let (acceleration, free) = (&totals.acceleration, &totals.free_acceleration);
        let mean = mean_force / mass;
        let absolute = |range: &super::totals::Range<F>, shift: F| {
            (range.most.value - shift).abs().larger((range.least.value - shift).abs())
        };
        let (acceleration, transmitted) = match excitation {
            Excitation::Force | Excitation::Unbalance => {
                (absolute(acceleration, F::int(0)), absolute(free, mean))
            }
            Excitation::FootMotion | Excitation::DampedFootMotion => {
                (absolute(acceleration, F::int(0)), absolute(acceleration, mean))
            }
            Excitation::SurfaceAcceleration | Excitation::SurfaceMotion | Excitation::SurfaceVelocity => {
                (absolute(free, F::int(0)), absolute(free, mean))
            }
        };
        let cycle = self.equivalent(&totals.swing)?;
        Some(RecordAnswer {
            max_displacement: totals.displacement.most.value,
            max_displacement_time: totals.displacement.most.at_time(),
            min_displacement: totals.displacement.least.value,
            min_displacement_time: totals.displacement.least.at_time(),
            peak_displacement: totals
                .displacement
                .most
                .value
                .abs()
                .larger(totals.displacement.least.value.abs()),
            max_velocity: totals.velocity.most.value,
            max_velocity_time: totals.velocity.most.at_time(),
            min_velocity: totals.velocity.least.value,
            min_velocity_time: totals.velocity.least.at_time(),
            max_absolute_acceleration: acceleration,
            max_transmitted_force: transmitted * mass,
            end_displacement: end.x,
            end_velocity: end.v,
            residual_displacement: residual,
            cut_time: cut,
            path: totals.path,
            slides: totals.slides,
            stops: totals.stops,
            reversals: totals.reversals,
            stick_time: totals.stick_time,
            cycle_amplitude: cycle.amplitude,
            equivalent_stiffness: cycle.stiffness,
            equivalent_damping_ratio: cycle.damping_ratio,
            friction_work,
            damper_work,
            load_work,
            tends_to_rest: matches!(end.rest, Rest::Limit(_)),
        })
    }
}

/// The error of a failure.
pub(super) fn failed<F: Float>((failure, time): Failed<F>) -> Error {
    let time = written(time);
    match failure {
        Failure::Uncertain => Error::BeyondRange { time },
        Failure::Bound => Error::TooManyEvents { time },
        #[cfg(feature = "batch")]
        Failure::Interrupted => Error::Interrupted,
    }
}
