//! `stickslip attractors`: all limits that a set of starts leads to.

use crate::args::{AttractorsArgs, Format, Header, StreamFormat};
use crate::bits::{Value, at_bits, digits};
use crate::failure::{Failure, Outcome};
use crate::note::{Note, decay, measured_from};
use crate::outputs::{ATTRACTOR, FIRST_V, FIRST_X, MIRROR, REST_FROM, REST_TO, SHARE, STARTS};
use crate::row::{Cell, Cells, Number, Row};
use crate::sink::Sink;
use crate::starts::Starts;
use crate::{input, interrupt, output, progress, style};
use serde::Serialize;
use std::io::Write;
use stickslip::internal::definitions::{
    LIMIT, LYAPUNOV_EXPONENT, LYAPUNOV_EXPONENT_ERROR, MULTIPLIERS, STICKS_PER_CYCLE, SYMMETRIC,
    TURNS_PER_CYCLE, VELOCITY_ZEROS_PER_CYCLE,
};
use stickslip::motion::{
    Attractor, Attractors, LongRun, PeriodicMotions, Signature, Starts as Spread, State, SteadyOutput,
    SteadyState, periodic_motions_from,
};
use stickslip::{Measure, Ratios};

/// The greatest number of starts, whose limits are kept in memory.
const MOST_STARTS: u64 = 10_000_000;

pub(crate) fn run(args: &AttractorsArgs, out: &mut impl Write) -> Outcome {
    at_bits!(args.bits, search(args: &AttractorsArgs, out))
}

fn search<F: Value>(args: &AttractorsArgs, out: &mut impl Write) -> Outcome {
    let periods = input::periods(args.max_periods)?;
    let count = input::count("--starts", &args.starts, MOST_STARTS)?;
    let given = input::read::<F>(&args.machine, &args.units.reader())?;
    input::refuse_frictionless(&given)?;
    let point = input::point(&given)?;
    let reach = reach(args.reach.as_deref(), &point.ratios)?;
    let at = |number| start(number, reach);
    let all = Starts { ratios: point.ratios, count, at, periods }.limits(&given, &args.rows)?;
    let others = args.unstable.map(|turns| others(&all, point.ratios, count, at, turns)).transpose()?;
    let rows: Vec<Row> = (0..all.limits.len()).map(|place| row(&all, Some(place), reach)).collect();
    let more = others.as_ref().map(|others| others.iter().map(Other::row).collect::<Vec<_>>());
    match args.format {
        Format::Text => {
            let mut note = Note::of(&given, point.machine.as_ref(), out);
            measured_from(note.given, note.machine, note.out)?;
            text(&all, reach, &mut note)?;
            let turns = args.unstable.unwrap_or_default();
            others.map_or(Ok(()), |others| text_of_others(&others, turns, &mut note))
        }
        Format::Json => {
            let answer = AttractorsAnswer {
                ratios: Cells::of_ratios(&given, &point.ratios, true).shown(),
                starts: all.of_start.len(),
                reach: Number::of(reach),
                unsettled: all.unsettled(),
                attractors: &rows,
                other_motions: more.as_deref(),
            };
            output::json(&answer, out)
        }
        Format::Jsonl | Format::Csv => {
            let is_csv = args.format == Format::Csv;
            let format = if is_csv { StreamFormat::Csv } else { StreamFormat::Jsonl };
            let mut sink = Sink::new(format, out, Header::Names)?;
            if rows.is_empty() {
                sink.write_header(&row(&all, None, reach))?;
                progress::note(&unsettled(&all));
            }
            rows.iter().chain(more.iter().flatten()).try_for_each(|row| sink.write(row))?;
            Ok(sink.flush()?)
        }
    }
}

/// The range of the starts.
pub(crate) fn reach<F: Value>(text: Option<&str>, ratios: &Ratios<F>) -> Result<F, Failure> {
    let Some(text) = text else { return Ok(Spread::around(ratios).reach()) };
    spread(input::number("--reach", text)?).map(|spread| spread.reach())
}

/// The start with this number.
pub(crate) fn start<F: Value>(number: u64, reach: F) -> Result<State<F>, Failure> {
    Ok(spread(reach)?.get(number))
}

fn spread<F: Value>(reach: F) -> Result<Spread<F>, Failure> {
    Spread::within(reach).ok_or_else(|| Failure::Input(format!("--reach {reach}: must be > 0 and ≤ 2⁴⁰")))
}

/// The fraction of the starts that lead to a limit.
fn share<F: Value>(all: &Attractors<F>, limit: &Attractor<F>) -> f64 {
    limit.starts as f64 / all.of_start.len() as f64
}

/// A limit as a row, or an empty one for its names.
fn row<F: Value>(all: &Attractors<F>, place: Option<usize>, reach: F) -> Row {
    let found = place.and_then(|place| all.limits.get(place));
    LimitData {
        number: place.map_or(0, |place| place + 1),
        name: found.map_or("", |found| found.limit.name()),
        share: found.map_or(0.0, |found| share(all, found)),
        starts: found.map_or(0, |found| found.starts),
        first: found.and_then(|found| start(found.first_start as u64, reach).ok()),
        mirror: found.and_then(|found| found.mirror).map(|place| place + 1),
        limit: found.map(|found| found.limit),
        range: found.and_then(|found| found.range),
    }
    .row()
}

/// The number of starts that had not settled, in a sentence.
fn unsettled<F: Value>(all: &Attractors<F>) -> String {
    let (unsettled, count) = (all.unsettled(), all.of_start.len());
    format!("{unsettled} of {count} starts had not settled. Allow more periods with --max-periods.")
}

/// The data of a limit, or of a motion that no start leads to.
pub(crate) struct LimitData<F> {
    pub(crate) number: usize,
    pub(crate) name: &'static str,
    pub(crate) share: f64,
    pub(crate) starts: u64,
    pub(crate) first: Option<State<F>>,
    pub(crate) mirror: Option<usize>,
    pub(crate) limit: Option<LongRun<F>>,
    pub(crate) range: Option<(F, F)>,
}

impl<F: Value> LimitData<F> {
    pub(crate) fn row(&self) -> Row {
        let limit = self.limit.as_ref();
        let steady = limit.and_then(LongRun::steady_state);
        let (least, most) = limit.and_then(LongRun::extrema).unzip();
        let exponent =
            limit.and_then(|it| if let LongRun::Irregular(motion) = it { Some(motion) } else { None });
        let count = |of: fn(&SteadyState<F>) -> u32| Cell::Count(steady.map(|s| u64::from(of(s))));
        Cells::of(vec![
            (ATTRACTOR, Cell::Count(Some(self.number as u64))),
            (LIMIT, Cell::Text(self.name)),
            (SHARE, Cell::Number(Some(F::from_f64(self.share)))),
            (STARTS, Cell::Count(Some(self.starts))),
            (FIRST_X, Cell::Number(self.first.map(|s| s.x))),
            (FIRST_V, Cell::Number(self.first.map(|s| s.v))),
            (MIRROR, Cell::Count(self.mirror.map(|number| number as u64))),
            (SYMMETRIC, Cell::Flag(steady.map(|s| s.is_symmetric))),
            (TURNS_PER_CYCLE, count(|s| s.turns_per_cycle)),
            (SteadyOutput::MaxDisplacement.definition(), Cell::Number(most)),
            (SteadyOutput::MinDisplacement.definition(), Cell::Number(least)),
            (STICKS_PER_CYCLE, count(|it| it.sticks_per_cycle)),
            (VELOCITY_ZEROS_PER_CYCLE, count(|it| it.velocity_zeros_per_cycle)),
            (SteadyOutput::StickFraction.definition(), Cell::Number(steady.map(|it| it.stick_fraction))),
            (MULTIPLIERS, Cell::Pairs(steady.map(|it| it.multipliers))),
            (LYAPUNOV_EXPONENT, Cell::Number(exponent.map(|it| it.lyapunov_exponent))),
            (LYAPUNOV_EXPONENT_ERROR, Cell::Number(exponent.map(|it| it.lyapunov_exponent_error))),
            (REST_FROM, Cell::Number(self.range.map(|(low, _)| low))),
            (REST_TO, Cell::Number(self.range.map(|(_, high)| high))),
        ])
        .shown()
    }
}

/// The answer as JSON.
#[derive(Serialize)]
struct AttractorsAnswer<'a> {
    #[serde(flatten)]
    ratios: Row,
    starts: usize,
    reach: Number,
    unsettled: usize,
    attractors: &'a [Row],
    #[serde(skip_serializing_if = "Option::is_none")]
    other_motions: Option<&'a [Row]>,
}

fn text<F: Value>(all: &Attractors<F>, reach: F, note: &mut Note<'_, F, impl Write>) -> Outcome {
    let (count, reach) = (all.of_start.len(), digits(reach));
    let limits = match all.limits.len() {
        0 => "No limit".to_owned(),
        1 => "One limit".to_owned(),
        n => format!("{n} limits"),
    };
    let sentence =
        format!("{limits} from {count} starts at ω_d t = 0, |x| ≤ {reach} B, |v| ≤ {reach} B ω_d.");
    writeln!(note.out, "{}", style::verdict(&sentence))?;
    if all.unsettled() > 0 {
        writeln!(note.out, "{}", unsettled(all))?;
    }
    for (place, found) in all.limits.iter().enumerate() {
        let part = digits((share(all, found) * 1e4).round() / 1e2);
        writeln!(
            note.out,
            "\n{}. {}, {part} % of the starts",
            place + 1,
            stickslip_front::words::described(found)
        )?;
        if let Some(steady) = found.limit.steady_state() {
            of_cycle(steady, note)?;
            note.line("a disturbance", decay(steady.contraction(), "a cycle"))?;
        } else if let LongRun::Irregular(motion) = found.limit {
            note.number("maximum displacement", Measure::Length, motion.max_displacement)?;
            note.number("minimum displacement", Measure::Length, motion.min_displacement)?;
            note.line("Lyapunov exponent", format_args!("{} a turn", digits(motion.lyapunov_exponent)))?;
        } else if let Some((low, high)) = found.range {
            note.number("from", Measure::Length, low)?;
            note.number("to", Measure::Length, high)?;
        }
    }
    Ok(())
}

/// The extrema and the stops of a cycle.
fn of_cycle<F: Value>(steady: &SteadyState<F>, note: &mut Note<'_, F, impl Write>) -> Outcome {
    note.number("maximum displacement", Measure::Length, steady.max_displacement.value)?;
    note.number("minimum displacement", Measure::Length, steady.min_displacement.value)?;
    Ok(note.line("stops in a cycle", steady.sticks_per_cycle)?)
}

/// A motion that no start leads to, with its number and that of its mirror image.
struct Other<F> {
    number: usize,
    mirror: Option<usize>,
    steady: SteadyState<F>,
}

/// The motions found to which no start leads, by Newton's method from the starts, in parallel; the numbers continue
/// those of the limits.
fn others<F: Value>(
    all: &Attractors<F>,
    ratios: Ratios<F>,
    count: u64,
    at: impl Fn(u64) -> Result<State<F>, Failure> + Sync,
    turns: u32,
) -> Result<Vec<Other<F>>, Failure> {
    let mut motions = PeriodicMotions::new();
    progress::in_order(
        0..count,
        |number| Ok(periodic_motions_from(ratios, at(number)?, turns, &mut interrupt::keep_going)?),
        |found| Ok(found.into_iter().try_for_each(|steady| motions.add(steady))?),
    )?;
    let mut numbers = Vec::new();
    let mut next = all.limits.len();
    for motion in motions.found() {
        let signature = Signature::of(&LongRun::Periodic(motion.steady_state))?;
        let place = all.place_of(&signature);
        numbers.push((place.is_none(), 1 + place.unwrap_or(next)));
        next += usize::from(place.is_none());
    }
    let number = |place: usize| numbers.get(place).map(|(_, number)| *number);
    let others = motions.found().iter().zip(&numbers).filter(|(_, (is_other, _))| *is_other);
    let other = others.map(|(motion, (_, own))| Other {
        number: *own,
        mirror: motion.mirror.and_then(number),
        steady: motion.steady_state,
    });
    Ok(other.collect())
}

impl<F: Value> Other<F> {
    fn row(&self) -> Row {
        LimitData {
            number: self.number,
            name: if self.steady.is_stable() { "periodic" } else { "unstable" },
            share: 0.0,
            starts: 0,
            first: None,
            mirror: self.mirror,
            limit: Some(LongRun::Periodic(self.steady)),
            range: None,
        }
        .row()
    }
}

fn text_of_others<F: Value>(others: &[Other<F>], turns: u32, note: &mut Note<'_, F, impl Write>) -> Outcome {
    let of = if turns == 1 { "one turn".to_owned() } else { format!("{turns} turns or fewer") };
    let found = match others.len() {
        0 => "No periodic motion",
        1 => "A periodic motion",
        _ => "Periodic motions",
    };
    writeln!(note.out, "\n{found} of {of} that no start leads to, by a search from the same starts.")?;
    for Other { number, mirror, steady } in others {
        let stability = if steady.is_stable() { "stable" } else { "unstable" };
        let mirror = mirror.map_or(String::new(), |number| format!(", the mirror image of {number}"));
        writeln!(note.out, "\n{number}. {}, {stability}{mirror}", stickslip_front::words::shape(steady))?;
        of_cycle(steady, note)?;
        let [(re, im), _] = steady.multipliers;
        let imaginary = if im == F::int(0) { String::new() } else { format!(" ± {} i", digits(im.abs())) };
        note.line("greatest multiplier", format_args!("{}{imaginary} in a cycle", digits(re)))?;
    }
    Ok(())
}
