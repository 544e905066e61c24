//! The motion of a system in balls: guaranteed intervals for all of its answers, and every decision certain.
//!
//! It is a text of its own beside that of the floats, and shares with it only the rows of a checked system: what a branch is, when it ends
//! and what follows it is decided anew, by certain signs. The theory is in `docs/development/theory/enclosed-systems.md`.
//!
//! | file | content |
//! |---|---|
//! | `machine` | the rows of a system in balls |
//! | `branch` | the linear equation between two events, its guards, its Taylor series with a bound of the rest |
//! | `series` | the zeros of a series |
//! | `cloud` | a set of states that linear maps do not wrap |
//! | `doubt` | what is not certain |
//! | `next` | the contacts that stick or slide after an event |
//! | `follow` | the motion from event to event |
//! | `seen` | extremes, times at rest and works |

mod branch;
mod cloud;
mod doubt;
mod follow;
mod machine;
mod next;
mod seen;
mod series;

use super::System;
use super::assembly::{Assembly, Rule};
use super::error::Error;
use super::events::{Event, EventKind};
use super::given;
use super::model::State;
use super::motion::{ElementMotion, Motion};
use crate::enclosed::Enclosure;
use crate::float::ball::Radius;
use crate::float::mp::Mp;
use crate::float::words::with_words;
use crate::machine::error::written;
use alloc::string::String;
use alloc::vec::Vec;
use doubt::{Doubt, Failure};
use follow::Follower;
use machine::{Machine, Number, Row, refused};

/// The precisions that are tried, in words of 64 bits.
const PRECISIONS: [u32; 5] = [3, 5, 9, 17, 25];
/// The precision from which on what is not certain at the same time as with fewer bits is taken to stay so.
const DECIDED: u32 = 9;

impl<const N: usize> System<Mp<N>> {
    /// The exact motion from a start at time 0 until a time, enclosed: every number as all numbers within a radius, one of which it is.
    ///
    /// The motion is that of every system within 64 units in the last place of the numbers given, those of a matrix or a list in units of its
    /// largest, so that decimal numbers that were read and converted are among them. Zeros are exact, and so is a static friction of exactly the
    /// kinetic one. No event was missed and each is in its branch, whatever the rounding: signs are certain. The computation takes the
    /// bits that it needs, up to 1600. The greatest displacements and velocities are as sharp as `bits` beside the
    /// largest of them, unless those bits do not suffice; then the radii say so.
    ///
    /// Contacts with friction constant or by a law of straight pieces, under a normal load that may vary, elastic contacts under a constant one and
    /// elastic stops are enclosed, under constant loads and waves.
    ///
    /// # Errors
    /// As [`System::simulate`]; [`Error::Unsupported`] names what is not enclosed, and [`Error::Unproved`] the element whose event is not certain at any
    /// precision: two events at one instant, a force exactly at its bound, a velocity that only touches zero.
    ///
    /// ```
    /// use stickslip::float::Mp;
    /// use stickslip::system::{Element, Kind, Law, Model, Signal, State, System};
    /// let number = |x: f64| Mp::<4>::from(x);
    /// // A mass of 1 with the friction 1 on a spring of 1 starts at 4: it turns at −2 after π, and stays at 0 after 2π.
    /// let kind = Kind::Contact { law: Law::constant(number(1.0)), peak: number(1.0), normal: None };
    /// let moves = Signal::constant(number(0.0));
    /// let contact = Element { name: "floor".into(), direction: vec![number(1.0)], moves, kind };
    /// let one = |x: f64| vec![vec![number(x)]];
    /// let model = Model { mass: one(1.0), damping: one(0.0), stiffness: one(1.0), elements: vec![contact], ..Model::default() };
    /// let start = State { displacement: vec![number(4.5)], ..State::rest(1) };
    /// let found = System::new(&model)?.enclosed(&start, number(10.0), 64)?;
    /// assert_eq!(found.events.len(), 2);
    /// assert!(found.end.displacement[0].contains(&rug_half()) && found.end.displacement[0].rad < 1e-19);
    /// # fn rug_half() -> stickslip::dependencies::rug::Float { stickslip::dependencies::rug::Float::with_val(64, 0.5) }
    /// # Ok::<(), stickslip::system::Error>(())
    /// ```
    pub fn enclosed(
        &self,
        start: &State<Mp<N>>,
        until: Mp<N>,
        bits: u32,
    ) -> Result<Motion<Enclosure>, Error> {
        let system = &self.assembly;
        // The checks of a motion.
        self.follower(start, until)?;
        given::at_least("time", until, Mp::of_int(0))?;
        refused(system)?;
        let forces =
            system.parts.iter().enumerate().filter(|(_, part)| matches!(part.rule, Rule::Elastic { .. }));
        let forces = forces.map(|(i, _)| super::matrix::at(&start.force, i));
        let states: Vec<Mp<N>> =
            start.displacement.iter().chain(&start.velocity).copied().chain(forces).collect();
        let asked = Asked { states: &states, until, bits };
        let mut last: Option<Result<Motion<Enclosure>, Error>> = None;
        let mut doubt: Option<(Doubt, f64)> = None;
        let enough =
            |words: &&u32| 64 * **words >= bits.saturating_add(64) || Some(*words) == PRECISIONS.last();
        for &words in PRECISIONS.iter().filter(enough) {
            match with_words(words, || run(system, &asked)) {
                Ok((true, found)) => return Ok(found),
                Ok((false, found)) => last = Some(Ok(found)),
                Err(Failure::Interrupted) => return Err(Error::Interrupted),
                Err(Failure::TooLong(time)) => {
                    return Err(Error::TooLong { time: written(time), limit: follow::MOST_STEPS });
                }
                Err(Failure::Doubt(found, time)) => {
                    let error = unproved(system, found, time, 64 * words);
                    // More bits do not help where two events are at one instant: they end at the same time.
                    let is_same = doubt.is_some_and(|(before, at)| {
                        before == found && (at - time).abs() <= 1e-9 * time.abs()
                    });
                    if is_same && words >= DECIDED {
                        return Err(error);
                    }
                    doubt = Some((found, time));
                    if !matches!(last, Some(Ok(_))) {
                        last = Some(Err(error));
                    }
                }
            }
        }
        last.unwrap_or(Err(Error::Interrupted))
    }
}

fn unproved<F>(system: &Assembly<F>, doubt: Doubt, time: f64, bits: u32) -> Error {
    let part = doubt.element.and_then(|element| system.parts.get(element));
    let name = part.map_or_else(|| String::from("the system"), |part| part.name.clone());
    Error::Unproved { name, time: written(time), reason: doubt.reason, bits }
}

/// A motion that is to be enclosed, to so many bits.
struct Asked<'a, const N: usize> {
    states: &'a [Mp<N>],
    until: Mp<N>,
    bits: u32,
}

/// The motion at the precision of the thread, and whether it has so many bits.
fn run<const N: usize>(
    system: &Assembly<Mp<N>>,
    asked: &Asked<'_, N>,
) -> Result<(bool, Motion<Enclosure>), Failure> {
    let failed = || Failure::Doubt(Doubt::of(None, "its mass matrix needs more bits"), 0.0);
    let machine = Machine::new(system).ok_or_else(failed)?;
    let start: Row = asked.states.iter().copied().map(machine::read_one).collect();
    let until = machine::read_one(asked.until);
    let mut follower = Follower::new(&machine, &start, until.upper().to_f64())?;
    let end = follower.run(until, system.keep_going)?;
    motion(&machine, &follower, &start, end, until, asked.bits)
}

fn motion(
    machine: &Machine,
    follower: &Follower<'_>,
    start: &[Number],
    end: follow::End,
    until: Number,
    bits: u32,
) -> Result<(bool, Motion<Enclosure>), Failure> {
    let seen = &follower.seen;
    let n = machine.n;
    let (greatest, least) = (seen.greatest(), seen.least());
    let is_sharp = [(0, n), (n, 2 * n)].into_iter().all(|(from, to)| {
        let of = |list: &[Number]| list.get(from..to).unwrap_or(&[]).to_vec();
        let all: Vec<Number> = of(&greatest).into_iter().chain(of(&least)).collect();
        let size = all.iter().map(|x| Radius::below(x.mid())).fold(Radius::ZERO, Radius::max);
        let radius = all.iter().map(Number::rad).fold(Radius::ZERO, Radius::max);
        radius.is_zero() || size.exponent() - radius.exponent() >= i64::from(bits) + 2
    });
    let one = |x: &Number| Enclosure::of(x).map(|x| x.rounded(bits));
    let part = |list: &[Number], from: usize, count: usize| -> Option<Vec<Enclosure>> {
        list.iter().skip(from).take(count).map(one).collect()
    };
    let stored = seen::energy(machine, &end.z) - seen::energy(machine, start);
    let at_rest = seen.at_rest(until);
    let element = |(i, part): (usize, &machine::Part)| {
        let own = || seen.events.iter().filter(move |event| event.1 == i).map(|event| event.2);
        let begins = |kind: &EventKind| match kind {
            EventKind::Stick | EventKind::Lock => true,
            EventKind::Open => matches!(part.rule, machine::Rule::Stop { .. }),
            EventKind::Slip | EventKind::Reverse | EventKind::Touch | EventKind::Yield => false,
            EventKind::Close | EventKind::Blow | EventKind::Rise | EventKind::Fall => false,
        };
        Some(ElementMotion {
            name: part.name.clone(),
            time_at_rest: one(&machine::at(&at_rest, i))?,
            stops: own().filter(begins).count(),
            blows: 0,
            work: one(&machine::at(&seen.works, i))?,
            reach: None,
        })
    };
    let event = |(time, element, kind): &(Number, usize, EventKind)| {
        Some(Event { time: one(time)?, element: *element, kind: *kind, velocities: None })
    };
    let found = || {
        Some(Motion {
            duration: one(&until)?,
            end: State {
                displacement: part(&end.z, 0, n)?,
                velocity: part(&end.z, n, n)?,
                force: part(&end.force, 0, end.force.len())?,
                absolute_acceleration: Vec::new(),
            },
            max_displacement: part(&greatest, 0, n)?,
            min_displacement: part(&least, 0, n)?,
            max_velocity: part(&greatest, n, n)?,
            min_velocity: part(&least, n, n)?,
            max_absolute_acceleration: Vec::new(),
            events: seen.events.iter().map(event).collect::<Option<_>>()?,
            elements: machine.parts.iter().enumerate().map(element).collect::<Option<_>>()?,
            load_work: one(&seen.load_work)?,
            damper_work: one(&seen.damper_work)?,
            stored: one(&stored)?,
        })
    };
    let lost =
        || Failure::Doubt(Doubt::of(None, "its end is lost in the widths of numbers"), until.mid().to_f64());
    found().map(|found| (is_sharp, found)).ok_or_else(lost)
}
