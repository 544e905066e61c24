//! A motion under a step, a ramp, a pull or no drive: segments or samples of the exact motion under a record.

use super::rows;
use crate::args::{ShapeArg, SimulateArgs};
use crate::bits::Value;
use crate::failure::{Failure, Outcome};
use crate::input::{behind_all, read};
use crate::outputs::{ENDS_BY, KIND};
use crate::progress;
use crate::row::{Cell, Cells, Row};
use crate::shaken::Surface;
use crate::sink::Sink;
use std::io::Write;
use stickslip::Excitation;
use stickslip::motion::record::{After, Record, RecordMotion};
use stickslip_front::inputs::units::{Kind, Reader, System};
use stickslip_front::inputs::{Given, Input, Role};

/// The most samples, and the most half turns of the body's own vibration.
const MOST: f64 = 1e6;

/// Writes the motion under another drive than a harmonic one.
pub(super) fn write<F: Value>(
    args: &SimulateArgs,
    shape: ShapeArg,
    sink: &mut Sink<impl Write>,
    reader: &Reader,
) -> Outcome {
    let name = format!("--shape {}", named(shape));
    let unused = [
        ("--phase", args.phase.is_some()),
        ("--cycles", args.cycles.is_some()),
        ("--samples", args.samples.is_some()),
    ];
    if let Some((option, _)) = unused.into_iter().find(|(_, is_typed)| *is_typed) {
        return Err(format!("{option}: must be left out with {name}, which has no cycles").into());
    }
    let mut given = read::<F>(&args.machine, reader)?;
    for input in [Input::Omega, Input::Frequency] {
        if given.has(input) {
            return Err(format!("{}: must be left out with {name}", given.label(input)).into());
        }
    }
    let positive = |option: &str, text: &Option<String>, kind: Kind| -> Result<F, Failure> {
        let Some(text) = text else { return Err(format!("{option} is missing, for {name}").into()) };
        let value = reader.value::<F>(option, text, kind)?;
        if value > F::int(0) && value.is_finite() {
            return Ok(value);
        }
        Err(format!("{option} {text}: must be > 0").into())
    };
    let duration = positive("--duration", &args.duration, Kind::Time)?;
    let rate = args.rate.as_ref().map(|_| positive("--rate", &args.rate, Kind::Frequency)).transpose()?;
    let hertz = rate.map(|rate| rate / (F::int(2) * F::pi()));
    let load = Load::read(args, shape, &given, (duration, &positive))?;
    let is_force = load.excitation == Excitation::Force && shape != ShapeArg::Free;
    let has_mass = is_force || !given.cancel_mass();
    let surface = Surface::read(&args.surface, reader)?;
    let body = surface.body(&given)?;
    if body.stiffness() > F::int(0) && (surface.is_inclined() || given.is_shifted()) {
        progress::note("displacements are measured from the relaxed spring");
    }
    if load.excitation.moves_foot() && body.stiffness() == F::int(0) {
        return Err(format!("{name}: the spring's support moves, and there is no spring").into());
    }
    let start = surface.start(reader, [Input::X0, Input::V0].map(|input| args.start.text(input)))?;
    let turns = ((body.stiffness() / body.mass()).sqrt() * duration / F::pi()).to_f64();
    let samples = hertz.map_or(0.0, |hertz| (duration * hertz).to_f64());
    for (count, things) in [(turns, "half cycles of the body"), (samples, "samples")] {
        if count > MOST {
            let text = args.duration.as_deref().unwrap_or_default();
            return Err(format!("--duration {text}: about {count:.1e} {things}, must be ≤ {MOST:.0e}").into());
        }
    }
    let record = load.record(shape, duration, hertz).map_err(|e| behind_all(&given, Failure::from(e)))?;
    let motion = body.motion(&record, start[0], start[1], duration);
    let motion = motion.map_err(|e| behind_all(&given, Failure::from(e)))?;
    let mut write = |row: Row| sink.write(&row.finite()?);
    match hertz {
        // One row at a time: a million of them have no room.
        Some(hertz) => {
            samples_of(&motion, (duration, hertz), (given.system, has_mass)).try_for_each(&mut write)
        }
        None => segments_of(&motion, (duration, start), given.system).into_iter().try_for_each(write),
    }
}

const fn named(shape: ShapeArg) -> &'static str {
    match shape {
        ShapeArg::Sine => "sine",
        ShapeArg::Step => "step",
        ShapeArg::Ramp => "ramp",
        ShapeArg::Pull => "pull",
        ShapeArg::Free => "free",
    }
}

/// A load with one bend: from `first` at the start to `last` at the time `rise`, where it stays.
struct Load<F> {
    excitation: Excitation,
    first: F,
    last: F,
    rise: F,
}

impl<F: Value> Load<F> {
    fn read(
        args: &SimulateArgs,
        shape: ShapeArg,
        given: &Given<F>,
        (duration, positive): (F, &impl Fn(&str, &Option<String>, Kind) -> Result<F, Failure>),
    ) -> Result<Self, Failure> {
        let name = format!("--shape {}", named(shape));
        let zero = F::int(0);
        let left_out = [
            ("--rise", args.rise.is_some() && shape != ShapeArg::Ramp),
            ("--speed", args.speed.is_some() && shape != ShapeArg::Pull),
        ];
        if let Some((option, _)) = left_out.into_iter().find(|(_, is_wrong)| *is_wrong) {
            return Err(format!("{option}: must be left out with {name}").into());
        }
        let drive = given.one_of(Role::Drive)?;
        let (input, amplitude) = match (shape, drive) {
            (ShapeArg::Free | ShapeArg::Pull, Some((input, _))) => {
                return Err(format!("{}: must be left out with {name}", given.label(input)).into());
            }
            (ShapeArg::Free, None) => {
                return Ok(Self { excitation: Excitation::Force, first: zero, last: zero, rise: duration });
            }
            (ShapeArg::Pull, None) => {
                let far = positive("--speed", &args.speed, Kind::Velocity)? * duration;
                return Ok(Self {
                    excitation: Excitation::FootMotion,
                    first: zero,
                    last: far,
                    rise: duration,
                });
            }
            (ShapeArg::Sine | ShapeArg::Step | ShapeArg::Ramp, _) => given.amplitude()?,
        };
        let always = [Excitation::Force, Excitation::FootMotion, Excitation::SurfaceAcceleration];
        // A step of the support would give a damper a force without bound.
        let is_damped_ramp = |of| of == Excitation::DampedFootMotion && shape == ShapeArg::Ramp;
        let has_answer = |of: &Excitation| always.contains(of) || is_damped_ramp(*of);
        let Some(excitation) = input.excitation().filter(has_answer) else {
            let allowed = "--force, --foot-displacement or --base-acceleration";
            return Err(format!("{}: must be {allowed} with {name}", given.label(input)).into());
        };
        let (first, rise) = if shape == ShapeArg::Ramp {
            (zero, positive("--rise", &args.rise, Kind::Time)?)
        } else {
            (amplitude, duration)
        };
        Ok(Self { excitation, first, last: amplitude, rise })
    }

    fn at(&self, time: F, shape: ShapeArg) -> F {
        if time >= self.rise && shape != ShapeArg::Pull {
            return self.last;
        }
        self.first + (self.last - self.first) * (time / self.rise)
    }

    /// The load up to the duration and a little further, with samples at the rate, at the bend and at the duration.
    fn record(&self, shape: ShapeArg, duration: F, hertz: Option<F>) -> Result<Record<F>, stickslip::Error> {
        let mut times = vec![F::int(0)];
        if let Some(hertz) = hertz {
            let grid = (1..).map(|i| F::int(i) / hertz).take_while(|time| *time < duration);
            times.extend(grid);
        }
        if self.rise < duration {
            let place = times.partition_point(|time| *time < self.rise);
            if times.get(place) != Some(&self.rise) {
                times.insert(place, self.rise);
            }
        }
        times.extend([duration, duration * F::ratio(65, 64)]);
        let samples = times.iter().map(|time| self.at(*time, shape)).collect();
        Ok(Record::at_times(self.excitation, times, samples)?.followed_by(After::Hold))
    }
}

/// A row of each sample.
fn samples_of<F: Value>(
    motion: &RecordMotion<F>,
    (duration, hertz): (F, F),
    (system, has_mass): (System, bool),
) -> impl Iterator<Item = Row> {
    let count = (duration * hertz * (F::int(1) + F::int(4) * F::epsilon())).floor().to_f64() as i32;
    let mut states = motion.states.iter().peekable();
    (0..=count).filter_map(move |i| {
        let time = F::int(i) / hertz;
        let last = if time < duration { time } else { duration };
        while states.peek().is_some_and(|state| state.time < last) {
            states.next();
        }
        let mut found = *states.peek()?;
        // After an event at this time it is the motion to come.
        while let Some(state) = states.next_if(|state| state.time == last) {
            found = state;
        }
        // On the side of the spring's force, as under a harmonic drive.
        let friction = has_mass.then(|| F::int(0) - found.friction);
        let values = [last, found.displacement, found.velocity, found.acceleration];
        Some(Cells::of(Vec::new()).with_physical(rows::sample_in_units(system, values, friction)).shown())
    })
}

/// A row of each slide and stick up to the duration.
fn segments_of<F: Value>(
    motion: &RecordMotion<F>,
    (duration, start): (F, [F; 2]),
    system: System,
) -> Vec<Row> {
    let zero = F::int(0);
    // Each beginning: its time, its displacement, its velocity and its direction.
    let mut beginnings: Vec<(F, F, F, i8)> = Vec::new();
    let mut events = motion.events.iter().peekable();
    match events.peek() {
        Some(event) if event.time <= zero => {}
        _ => beginnings.push((zero, start[0], start[1], 0)),
    }
    for event in events.filter(|event| event.time <= duration) {
        let velocity = if event.time <= zero { start[1] } else { zero };
        beginnings.push((event.time, event.displacement, velocity, event.direction));
    }
    let last = motion.states.iter().rev().find(|state| state.time <= duration);
    let at_end = last.map_or(start[0], |state| state.displacement);
    let ends = beginnings.iter().skip(1).map(|next| (next.0, next.1));
    // A rest without length, at which the body turns, has no row.
    let rows: Vec<_> = beginnings
        .iter()
        .zip(ends.chain([(duration, at_end)]))
        .filter(|((from, ..), (to, _))| to > from)
        .collect();
    let nexts: Vec<_> = rows.iter().skip(1).map(|(next, _)| Some(next.3)).chain([None]).collect();
    let rows = rows.into_iter().zip(nexts).map(|((&(from, x, v, direction), (to, end)), next)| {
        let kind = match direction {
            1 => "slide-forward",
            -1 => "slide-backward",
            _ => "stick",
        };
        let ends_by = match (direction, next) {
            (_, None) => "end",
            (0, Some(_)) => "release",
            (_, Some(0)) => "stop",
            (_, Some(_)) => "reversal",
        };
        let physical = rows::segment_in_units(system, [from, to].map(Some), [x, v, end].map(Some));
        let fields = vec![(KIND, Cell::Text(kind)), (ENDS_BY, Cell::Text(ends_by))];
        Cells::of(fields).with_physical(physical).shown()
    });
    rows.collect()
}
