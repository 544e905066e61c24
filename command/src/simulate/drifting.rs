//! A body without a spring that a constant force, or friction by direction, moves on: the motion of a system of this one body, in the rows of
//! any other.

use super::extent::{Extent, Spacing, at_phase};
use super::rows::{self, When};
use crate::args::SimulateArgs;
use crate::drifting::{check, one_body};
use crate::failure::{Failure, Outcome};
use crate::input;
use crate::row::{Cell, Cells, Row};
use crate::sink::Sink;
use std::f64::consts::TAU;
use std::io::Write;
use stickslip::motion;
use stickslip::system::State;
use stickslip_front::inputs::units::{Reader, System};
use stickslip_front::inputs::{Driven, Given};
use stickslip_front::system::OneBody;

/// The most samples: their states are in memory.
const MOST: u64 = 1_000_000;

/// Writes the segments or samples of the motion.
pub(super) fn write(
    args: &SimulateArgs,
    given: &Given<f64>,
    sink: &mut Sink<impl Write>,
    reader: &Reader,
) -> Outcome {
    check(given, args.bits, true)?;
    let given = input::with_any_mass(given);
    let phase = at_phase(motion::State::default(), args.phase.as_deref(), reader)?.phase.reduced();
    let (one, machine) = one_body(&given, &args.start, phase, reader)?;
    let extent = Extent::new(args, Some(&machine), reader)?;
    let period = TAU / machine.drive.angular_frequency();
    let until = extent.turns * period;
    one.system.check_until(until, &extent.typed).map_err(Failure::Input)?;
    let drifting = Drifting { one: &one, machine: &machine, period, phase, system: given.system };
    let segments = drifting.segments(until)?;
    let mut write = |row: Row| sink.write(&row.in_units_of(true, false).finite()?);
    let Some(spacing) = extent.spacing else {
        return segments.iter().map(|segment| drifting.row(segment)).try_for_each(write);
    };
    let rows = extent.rows(spacing);
    if rows > MOST {
        return Err(
            format!("{}: about {:.1e} samples, must be ≤ {MOST:.0e}", extent.typed, rows as f64).into()
        );
    }
    let turns = (0..rows).map(|i| match spacing {
        Spacing::PerCycle(n) => (i / n, (i % n) as f64 / n as f64),
        Spacing::Turns(turns) => {
            let turns = i as f64 * turns;
            (turns.floor() as u64, turns - turns.floor())
        }
    });
    let turns: Vec<_> = turns.collect();
    let times: Vec<f64> = turns.iter().map(|(whole, part)| (*whole as f64 + part) * period).collect();
    let states = one.states(&one.system.described.start, &times).map_err(Failure::from)?;
    let samples = turns.into_iter().zip(&times).zip(&states);
    samples
        .map(|((turn, time), state)| drifting.sample(turn, *time, state, &segments))
        .try_for_each(&mut write)
}

/// A slide or a rest, from one time to another.
struct Segment {
    times: [f64; 2],
    displacements: [f64; 2],
    velocity: f64,
    kind: &'static str,
    ends_by: &'static str,
}

struct Drifting<'a> {
    one: &'a OneBody,
    machine: &'a Driven<f64>,
    period: f64,
    phase: f64,
    system: System,
}

impl Drifting<'_> {
    /// The segments of the motion until a time. The direction of each is that of its middle.
    fn segments(&self, until: f64) -> Result<Vec<Segment>, Failure> {
        let motion = self.one.simulate(until).map_err(Failure::from)?;
        let events = motion.events.iter().map(|event| event.time);
        let mut bounds: Vec<f64> = [0.0].into_iter().chain(events).chain([until]).collect();
        bounds.dedup();
        let pairs = || bounds.iter().zip(bounds.iter().skip(1)).filter(|(from, to)| to > from);
        let times: Vec<f64> = pairs().flat_map(|(&from, &to)| [from, f64::midpoint(from, to), to]).collect();
        let states = self.one.states(&self.one.system.described.start, &times).map_err(Failure::from)?;
        let mut segments: Vec<Segment> = Vec::new();
        for ((&from, &to), states) in pairs().zip(states.chunks_exact(3)) {
            let [begin, middle, end] = states else { continue };
            let speed = first(&middle.velocity);
            let (kind, ends_by) = if speed > 0.0 {
                ("slide-forward", "reversal")
            } else if speed < 0.0 {
                ("slide-backward", "reversal")
            } else {
                ("stick", "release")
            };
            let [from_x, to_x] = [begin, end].map(|state| first(&state.displacement));
            // A touch of the velocity with zero ends no slide.
            if let Some(last) = segments.last_mut().filter(|last| last.kind == kind) {
                (last.times[1], last.displacements[1]) = (to, to_x);
                continue;
            }
            if let Some(last) = segments.last_mut().filter(|last| last.kind != "stick" && kind == "stick") {
                last.ends_by = "stop";
            }
            // At an event the velocity is 0.
            let velocity = if segments.is_empty() { first(&begin.velocity) } else { 0.0 };
            segments.push(Segment {
                times: [from, to],
                displacements: [from_x, to_x],
                velocity,
                kind,
                ends_by,
            });
        }
        if let Some(last) = segments.last_mut() {
            last.ends_by = "end";
        }
        Ok(segments)
    }

    /// The whole cycles and the phase of so many turns after the start.
    fn when(&self, (whole, part): (u64, f64)) -> When<f64> {
        let phase = TAU * part + self.phase;
        let over = phase >= TAU;
        let cycles = whole.saturating_add(u64::from(over));
        (Cell::Count(Some(cycles)), Cell::Number(Some(if over { phase - TAU } else { phase })))
    }

    fn row(&self, segment: &Segment) -> Row {
        let Segment { times: [from, to], displacements, velocity, kind, ends_by } = *segment;
        let at = |time: f64| {
            let whole = (time / self.period).floor();
            self.when((whole as u64, time / self.period - whole))
        };
        let duration = (to - from) / self.period * TAU;
        let fields = rows::segment(kind, ends_by, [at(from), at(to)], [Some(duration), None, None, None]);
        let [begin, end] = displacements;
        let physical =
            rows::segment_in_units(self.system, [from, to].map(Some), [begin, velocity, end].map(Some));
        Cells::of(fields).with_physical(physical).shown()
    }

    fn sample(&self, turn: (u64, f64), time: f64, state: &State<f64>, segments: &[Segment]) -> Row {
        let (x, v, friction) = (first(&state.displacement), first(&state.velocity), first(&state.force));
        let Driven { oscillator: body, drive, scales, .. } = self.machine;
        // The segment that begins at an event, as of any other motion.
        let place = segments.partition_point(|segment| segment.times[0] <= time).saturating_sub(1);
        let acceleration = match segments.get(place) {
            Some(segment) if segment.kind != "stick" => {
                let load = drive.force_amplitude(body) * (TAU * turn.1 + self.phase).sin();
                (load + self.one.mean_force - body.damping() * v - friction) / body.mass()
            }
            _ => 0.0,
        };
        let ratio = (friction - self.one.offset) / scales.force;
        let fields = rows::sample(self.when(turn), [None, None, Some(ratio), Some(ratio)]);
        let physical = rows::sample_in_units(self.system, [time, x, v, acceleration], Some(friction));
        Cells::of(fields).with_physical(physical).shown()
    }
}

/// The entry of the only body.
fn first(list: &[f64]) -> f64 {
    list.first().copied().unwrap_or(f64::NAN)
}
