//! `stickslip response-curve`: an amplitude over the frequency, for one machine or several, stops included.

mod picture;

use crate::args::{CurveArgs, CurveQuantity};
use crate::bits::digits;
use crate::failure::{Failure, Outcome};
use crate::figure::{self, Target};
use crate::grid::Grid;
use crate::input::{self, behind_all, in_symbols, line};
use crate::interrupt;
use crate::map::margin;
use crate::progress;
use crate::record::Cell;
use clap::ValueEnum;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use std::f64::consts::TAU;
use std::io::Write;
use stickslip::inputs::units::{Kind, Reader, System};
use stickslip::inputs::{Given, Input, Naming, Point, Role};
use stickslip::motion::Amplitude;
use stickslip::{Error, Regime};
use stickslip_figures::{Figure, Origin, resolved};

/// The greatest number of curves in a picture.
const MOST_CURVES: u64 = 40;
/// The greatest number of frequencies of a curve.
const MOST_POINTS: u64 = 100_000;

/// One frequency of a curve.
#[derive(Clone, Copy)]
struct CurvePoint {
    /// The value of the axis, in consistent units.
    x: f64,
    /// The value of the axis in the axis's unit.
    frequency: f64,
    source: Source,
    regime: &'static str,
    sticks: bool,
    /// The margin to the border, α/α_min.
    margin: f64,
    value: Option<f64>,
}

/// The reason why a frequency is in a curve.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Source {
    /// The frequency was requested.
    Grid,
    /// The frequency is the natural one.
    Natural,
    /// The curve has a maximum at this frequency.
    Peak,
    /// The frequency is next to a maximum or an onset, where a line through the other points would be inaccurate.
    Flank,
    /// The body begins to move from rest at this frequency, or ends.
    Onset,
    /// The frequency was tried in search of maxima, and is not in the curve.
    #[value(skip)]
    Probe,
}

struct Line {
    name: String,
    places: Vec<CurvePoint>,
    /// The points at which the curve meets the border of sticking.
    border: Vec<(f64, f64)>,
    /// The position of Ω = 1 on the axis; NaN if it has none.
    natural: f64,
}

/// The request: the quantity over one axis, for each value of another.
pub(crate) struct AskedCurve {
    what: CurveQuantity,
    axis: Input,
    grid: Grid<f64>,
    other: Option<(Input, Grid<f64>, Vec<String>)>,
    given: Given<f64>,
    system: System,
    /// The unit of the axis in words, and its value in rad/s, or 1 for Ω.
    unit: (&'static str, f64),
    /// The inputs that all curves share.
    machine: String,
    look: Look,
}

/// The look of the axes, as far as it was chosen.
#[derive(Default)]
struct Look {
    x_range: Option<(f64, f64)>,
    range: Option<(f64, f64)>,
    is_linear: bool,
}

impl Look {
    fn of(args: &CurveArgs, is_logarithmic: bool) -> Result<Self, Failure> {
        let range = |option, text: &Option<String>, is_linear| {
            text.as_ref().map(|text| figure::range(option, text, is_linear)).transpose()
        };
        let x_range = range("--x-range", &args.x_range, !is_logarithmic)?;
        Ok(Self { x_range, range: range("--y-range", &args.y_range, args.linear)?, is_linear: args.linear })
    }
}

/// The units of frequency that an axis may have, each with its value in rad/s. The first is that of bare numbers.
const UNITS: [(&str, f64); 4] = [("Hz", TAU), ("rpm", TAU / 60.0), ("cpm", TAU / 60.0), ("rad/s", 1.0)];

/// The unit of frequency in a text.
fn unit_in(text: &str) -> (&'static str, f64) {
    let is_typed = |(name, _): &&(&str, f64)| text.to_lowercase().contains(&name.to_lowercase());
    UNITS.iter().find(is_typed).copied().unwrap_or(UNITS[0])
}

pub(crate) fn run(args: &CurveArgs, out: &mut impl Write) -> Outcome {
    let target = Target::new("--out", args.out.as_deref(), args.overwrite, &args.look)?;
    let reader = args.units.reader();
    let asked = AskedCurve::new(args, &reader)?;
    let lines = asked.lines()?;
    target.fill(out, |mut out| asked.rows(&lines, &mut out), || asked.figure(&lines))
}

impl CurvePoint {
    fn is_stuck(&self) -> bool {
        self.regime == STUCK
    }

    /// The value at this place; infinite where the motion is unbounded, and NaN where it is undecided.
    fn height(&self) -> f64 {
        let otherwise = if self.regime == UNBOUNDED { f64::INFINITY } else { f64::NAN };
        self.value.unwrap_or(otherwise)
    }
}

impl AskedCurve {
    fn new(args: &CurveArgs, reader: &Reader) -> Result<Self, Failure> {
        let mut given = Given::empty(reader, Naming::Option);
        let (mut grid, mut other, mut unit) = (None, None, UNITS[0]);
        for &(parameter, ref text) in args.machine.iter() {
            let name = parameter.option();
            let values = Grid::with_units(name, text, reader, parameter.kind())?;
            let is_axis = matches!(parameter, Input::Omega | Input::Frequency) && values.len() > 1;
            if is_axis {
                unit = unit_in(text);
                if let Some((first, _)) = grid.replace((parameter, values)) {
                    let first: Input = first;
                    return Err(
                        format!("{} and {name}: give one of the two as a grid", first.option()).into()
                    );
                }
            } else if values.len() > 1 {
                if values.len() > MOST_CURVES {
                    return Err(
                        format!("{name} {text}: {} curves, must be ≤ {MOST_CURVES}", values.len()).into()
                    );
                }
                let texts = text.split(',').map(|part| part.trim().to_owned()).collect();
                if let Some((first, ..)) = other.replace((parameter, values, texts)) {
                    let first: Input = first;
                    return Err(
                        format!("{} and {name}: only one of them may be a list", first.option()).into()
                    );
                }
            } else {
                given.set_typed(parameter, values.value(0), text);
            }
        }
        let Some((axis, grid)) = grid else {
            return Err("--frequency (or --omega): give a grid, such as 0.3Hz:5Hz:200".into());
        };
        if grid.len() > MOST_POINTS {
            return Err(
                format!("{}: {} frequencies, must be ≤ {MOST_POINTS}", axis.option(), grid.len()).into()
            );
        }
        let unit = if axis == Input::Frequency { unit } else { ("1", 1.0) };
        let (look, system) = (Look::of(args, grid.is_logarithmic())?, reader.system());
        let machine = line(&args.machine, |input| given.has(input), &system);
        Ok(Self { what: args.what, axis, grid, other, given, system, unit, machine, look })
    }

    /// The curves of a machine with each of several frictions over a band LOW:HIGH.
    pub(crate) fn of_frictions(
        what: CurveQuantity,
        over: &str,
        machine: &[(Input, String)],
        frictions: [f64; 3],
        reader: &Reader,
    ) -> Result<Self, Failure> {
        let given = input::read::<f64>(machine, reader)?;
        let grid = Grid::with_units("--over", &format!("{over}:200:log"), reader, Kind::Frequency)?;
        let system = reader.system();
        // A legend has no room for all digits.
        let short = |x: f64| digits(format!("{x:.3e}").parse::<f64>().unwrap_or(x));
        let texts = frictions.map(|friction| format!("{} {}", short(friction), system.force())).to_vec();
        let other = Some((Input::Friction, Grid::List(frictions.to_vec()), texts));
        let (axis, unit) = (Input::Frequency, unit_in(over));
        let machine = line(machine, |input| input.role() != Role::Friction, &system);
        Ok(Self { what, axis, grid, other, given, system, unit, machine, look: Look::default() })
    }

    /// The picture.
    pub(crate) fn drawn(&self) -> Result<Figure, Failure> {
        self.figure(&self.lines()?)
    }

    fn lines(&self) -> Result<Vec<Line>, Failure> {
        let count = self.other.as_ref().map_or(1, |(_, values, _)| values.len());
        (0..count)
            .map(|i| {
                let mut given = self.given.clone();
                let name = match &self.other {
                    Some((parameter, values, texts)) => {
                        given.set(*parameter, values.value(i));
                        let text = usize::try_from(i).ok().and_then(|i| texts.get(i)).cloned();
                        in_symbols(*parameter, &text.unwrap_or_else(|| digits(values.value(i))), &self.system)
                    }
                    None => shown(self.what).words.to_owned(),
                };
                self.line(name, &given)
            })
            .collect()
    }

    fn line(&self, name: String, given: &Given<f64>) -> Result<Line, Failure> {
        let first = self.point(given, self.grid.value(0))?;
        if self.what == CurveQuantity::Absolute && !first.excitation().carries_surface() {
            return Err(
                "response-curve absolute: needs --base-acceleration, --base-velocity or --base-displacement"
                    .into(),
            );
        }
        let natural = match &first.machine {
            // A machine that is tuned to each frequency has no natural frequency of its own.
            Some(_) if self.axis == Input::Frequency && given.has(Input::Omega) => f64::NAN,
            Some(machine) if self.axis == Input::Frequency => machine.oscillator.natural_frequency(),
            Some(_) | None => 1.0,
        };
        let mut xs: Vec<(f64, Source)> = self.grid.values().map(|x| (x, Source::Grid)).collect();
        let falls = xs.first().map(|first| first.0) > xs.last().map(|last| last.0);
        xs.extend(self.probes(natural).into_iter().map(|x| (x, Source::Probe)));
        self.refuse_slow(given, &xs)?;
        let places = xs.into_par_iter().map(|(x, source)| self.place(given, x, source));
        let mut places = places.collect::<Result<Vec<_>, Failure>>()?;
        let (low, high) = self.grid.ends();
        if low < natural && natural < high && places.iter().all(|place| place.x != natural) {
            places.push(self.place(given, natural, Source::Natural)?);
        }
        places.sort_by(|a, b| a.x.total_cmp(&b.x));
        for (i, pair) in places.clone().windows(2).enumerate().rev() {
            if let [a, b] = pair
                && a.is_stuck() != b.is_stuck()
            {
                let onset = self.onset(given, (a, b))?;
                places.splice(i + 1..=i, onset);
            }
        }
        // The peaks among all places first, and then the curve through those that are drawn.
        let places = self.resolved(given, &places, |_| false)?;
        let is_drawn = |place: &&CurvePoint| !matches!(place.source, Source::Probe | Source::Flank);
        let places: Vec<CurvePoint> = places.iter().filter(is_drawn).copied().collect();
        let is_corner = |place: &CurvePoint| matches!(place.source, Source::Onset | Source::Peak);
        let mut places = self.resolved(given, &places, is_corner)?;
        let mut border = Vec::new();
        for pair in places.windows(2) {
            if let [a, b] = pair
                && (a.margin >= 1.0) != (b.margin >= 1.0)
            {
                border.extend(self.crossing(given, (a.x, b.x))?);
            }
        }
        if falls {
            places.reverse();
        }
        Ok(Line { name, places, border, natural: self.in_units(natural) })
    }

    /// Refuses a curve whose motions with stops have too many half turns in a cycle, of which there are some 1/Ω.
    fn refuse_slow(&self, given: &Given<f64>, xs: &[(f64, Source)]) -> Outcome {
        let mut slides = 0.0;
        for (x, _) in xs {
            let ratios = self.point(given, *x)?.ratios;
            let sticks = margin(ratios) < 1.0 && ratios.alpha() > ratios.static_friction_ratio();
            slides += if sticks { 1.0 / ratios.omega() } else { 0.0 };
        }
        if slides <= MOST_SLIDES {
            return Ok(());
        }
        let (name, low) =
            (self.axis.option(), digits(self.in_units(self.grid.ends().0.min(self.grid.ends().1))));
        Err(format!(
            "{name} {low}…: a cycle of so low a frequency has too many stops, about {slides:.0e} slides along this curve, must \
             be ≤ {MOST_SLIDES:.0e}. Single points are answered by steady"
        )
        .into())
    }

    /// The point at a value of the axis.
    fn point(&self, given: &Given<f64>, x: f64) -> Result<Point<f64>, Failure> {
        let mut given = given.clone();
        given.set(self.axis, x);
        interrupt::check()?;
        input::point(&given)
    }

    fn place(&self, given: &Given<f64>, x: f64, source: Source) -> Result<CurvePoint, Failure> {
        let point = self.point(given, x)?;
        let margin = margin(point.ratios);
        let (value, regime, sticks) = self.value(&point)?;
        Cell::Number(value).shown().finite(shown(self.what).words).map_err(|e| behind_all(given, e))?;
        Ok(CurvePoint { x, frequency: self.in_units(x), source, regime, sticks, margin, value })
    }

    /// The curve through these places, resolved at its peaks and beside its corners.
    fn resolved(
        &self,
        given: &Given<f64>,
        places: &[CurvePoint],
        is_corner: impl Fn(&CurvePoint) -> bool,
    ) -> Result<Vec<CurvePoint>, Failure> {
        let at = |x: f64| self.place(given, x, Source::Flank);
        let of = |place: &CurvePoint| (place.x, place.height());
        let all = resolved(places, self.grid.is_logarithmic(), of, is_corner, at)?;
        let named = |(place, origin): (CurvePoint, Origin)| match (origin, place.source) {
            (Origin::Peak, Source::Flank | Source::Probe) => CurvePoint { source: Source::Peak, ..place },
            _ => place,
        };
        Ok(all.into_iter().map(named).collect())
    }

    /// Frequencies between those of the grid, so that no peak wider than a five-hundredth of the axis is missed. Below
    /// the natural frequency the peaks of a motion with stops follow each other in equal steps of 1/Ω, and so do these.
    /// Those next to a frequency of the curve would only repeat it.
    fn probes(&self, natural: f64) -> Vec<f64> {
        let (low, high) = self.grid.ends();
        if self.grid.len() >= PROBES {
            return Vec::new();
        }
        let mut own: Vec<f64> = self.grid.values().chain(Some(natural).filter(|x| x.is_finite())).collect();
        own.sort_by(f64::total_cmp);
        let evenly = (1..PROBES).map(|i| self.grid.at(i as f64 / PROBES as f64));
        let longest = 1.0 / SLOWEST;
        let (from, to) = ((natural / high).max(1.0), (natural / low).min(longest));
        let inverse = (1..(longest * PER_PERIOD) as u32).map(|i| f64::from(i) / PER_PERIOD);
        let slowly = inverse.filter(|period| *period > from && *period < to).map(|period| natural / period);
        let is_other = |&x: &f64| {
            let after = own.partition_point(|own| *own < x);
            let beside = [after.checked_sub(1), Some(after)];
            let away = (high - low).abs().min(x.abs()) * 1e-6;
            beside.into_iter().flatten().filter_map(|i| own.get(i)).all(|own| (own - x).abs() > away)
        };
        let mut found: Vec<f64> = evenly.chain(slowly).filter(is_other).collect();
        found.sort_by(f64::total_cmp);
        found.dedup_by(|a, b| (*a - *b).abs() <= a.abs() * 1e-6);
        found
    }

    /// The last place at rest and the first in motion, or the other way round, between two places.
    fn onset(
        &self,
        given: &Given<f64>,
        (a, b): (&CurvePoint, &CurvePoint),
    ) -> Result<[CurvePoint; 2], Failure> {
        let (mut a, mut b) = (*a, *b);
        loop {
            let x = a.x + (b.x - a.x) / 2.0;
            if x <= a.x || x >= b.x {
                return Ok([a, b].map(|place| CurvePoint { source: Source::Onset, ..place }));
            }
            let middle = self.place(given, x, Source::Onset)?;
            if middle.is_stuck() == a.is_stuck() { a = middle } else { b = middle }
        }
    }

    /// The point where the curve meets the border, between two frequencies on either side of it: by
    /// bisection, to the last bit.
    fn crossing(&self, given: &Given<f64>, (from, to): (f64, f64)) -> Result<Option<(f64, f64)>, Failure> {
        let slides = |x: f64| -> Result<bool, Failure> { Ok(margin(self.point(given, x)?.ratios) >= 1.0) };
        let (mut inside, mut outside) = if slides(from)? { (from, to) } else { (to, from) };
        loop {
            let middle = inside + (outside - inside) / 2.0;
            if middle == inside || middle == outside {
                let place = self.place(given, inside, Source::Flank)?;
                return Ok(place.value.map(|value| (place.frequency, value)));
            }
            if slides(middle)? { inside = middle } else { outside = middle }
        }
    }

    /// A value of the axis in its unit.
    fn in_units(&self, x: f64) -> f64 {
        x / self.unit.1
    }

    fn is_machine(&self) -> bool {
        self.axis.is_physical() || self.given.is_physical()
    }

    fn rows(&self, lines: &[Line], out: &mut impl Write) -> Outcome {
        let what = self.what.to_possible_value();
        let what = what.as_ref().map_or("", |what| what.get_name());
        let unit = self.unit_of_quantity();
        let name = if self.axis == Input::Frequency { "frequency" } else { "omega" };
        let axis = format!("{name}[{}]", self.unit.0);
        let mut writer = csv::Writer::from_writer(out);
        writer.write_record(["curve", &axis, "regime", &format!("{what}[{unit}]"), "margin[1]", "point"])?;
        for line in lines {
            for place in &line.places {
                let value = place.value.map_or(String::new(), |x| x.to_string());
                let (frequency, margin) = (place.frequency.to_string(), place.margin.to_string());
                let source = place.source.to_possible_value();
                let source = source.as_ref().map_or("", |source| source.get_name());
                writer.write_record([&line.name, &frequency, place.regime, &value, &margin, source])?;
            }
        }
        Ok(writer.flush()?)
    }
}

/// The most slides in the cycles of all points of a curve: some seconds and 200 MB.
const MOST_SLIDES: f64 = 5e5;

/// What is shown of a quantity.
struct Shown {
    amplitude: Amplitude,
    kind: Kind,
    words: &'static str,
    /// The unit in ratios, in which the quantity is one over α.
    unit: &'static str,
    /// The power of Ω in this unit.
    power: i32,
}

const fn shown(what: CurveQuantity) -> Shown {
    let (amplitude, kind, words, unit, power) = match what {
        CurveQuantity::Displacement => {
            (Amplitude::Displacement, Kind::Length, "maximum displacement", "p₀/k", 0)
        }
        CurveQuantity::Velocity => (Amplitude::Velocity, Kind::Velocity, "maximum velocity", "p₀/√(k m)", 1),
        CurveQuantity::Acceleration => {
            (Amplitude::Acceleration, Kind::Acceleration, "maximum acceleration", "p₀/m", 2)
        }
        CurveQuantity::Force => (Amplitude::TransmittedForce, Kind::Force, "transmitted force", "p₀", 0),
        CurveQuantity::Transmissibility => {
            (Amplitude::Transmissibility, Kind::Ratio, "transmissibility", "1", 0)
        }
        CurveQuantity::Absolute => {
            (Amplitude::AbsoluteDisplacement, Kind::Length, "maximum absolute displacement", "p₀/k", 0)
        }
    };
    Shown { amplitude, kind, words, unit, power }
}

impl AskedCurve {
    /// The value at a point, in the machine's units or in those of p₀; `None` where it grows without bound. Beside it
    /// the regime by name, and whether the body sticks.
    fn value(&self, point: &Point<f64>) -> Result<(Option<f64>, &'static str, bool), Failure> {
        let Shown { amplitude, kind, power, .. } = shown(self.what);
        let found = match amplitude.of(point.ratios, point.excitation()) {
            // One point of a curve whose motion is not found.
            Err(error @ (Error::SearchBound { .. } | Error::NotSettled { .. })) => {
                progress::no_answer(&Failure::from(error));
                return Ok((None, UNDECIDED, false));
            }
            found => found.map_err(|e| format!("{}: {e}", self.axis.option()))?,
        };
        let in_units = |x: f64| match &point.machine {
            _ if kind == Kind::Ratio => x,
            Some(machine) => x * amplitude.unit(&machine.scales),
            // 1/α overflows for the least α.
            None => x / point.ratios.alpha() * point.ratios.omega().powi(power),
        };
        let regime = found.regime.map_or(UNDECIDED, Regime::name);
        let sticks = matches!(found.regime, Some(Regime::Sticking | Regime::Stuck));
        Ok((found.value.map(in_units), regime, sticks))
    }

    /// The unit of the quantity.
    fn unit_of_quantity(&self) -> String {
        let Shown { kind, unit, .. } = shown(self.what);
        if self.is_machine() { self.system.name(kind) } else { unit.to_owned() }
    }

    /// The name of the quantity with its unit, for an axis.
    fn label(&self) -> String {
        let Shown { kind, words, unit, .. } = shown(self.what);
        if self.is_machine() || kind == Kind::Ratio {
            format!("{words} ({})", self.unit_of_quantity())
        } else if self.what == CurveQuantity::Displacement {
            "dynamic amplification k Δ₀/p₀".to_owned()
        } else {
            format!("{words}, in {unit}")
        }
    }
}

/// The regime of a motion that grows without bound.
const UNBOUNDED: &str = Regime::Unbounded.name();
/// The regime where no limit was found.
const UNDECIDED: &str = "undecided";
/// The regime of a body at rest.
const STUCK: &str = Regime::Stuck.name();
/// The number of intervals into which a curve is divided in search of its peaks.
const PROBES: u64 = 512;
/// The number of places tried in a unit of 1/Ω, and the least Ω for which they are.
const PER_PERIOD: f64 = 24.0;
const SLOWEST: f64 = 0.03;

#[cfg(test)]
mod tests {
    use super::{AskedCurve, margin};
    use crate::args::{Command, CommandLine};
    use crate::input;
    use clap::Parser;

    #[test]
    fn curves_meet_the_border_on_the_border() {
        let words = "stickslip response-curve --omega 0.2:2:30 --alpha 1.3,1.5,4 --damping-ratio 0.05";
        let Command::ResponseCurve(args) = CommandLine::parse_from(words.split(' ')).command else {
            panic!()
        };
        let asked = AskedCurve::new(&args, &args.units.reader()).ok().unwrap();
        let lines = asked.lines().ok().unwrap();
        let mut met = 0;
        for (line, alpha) in lines.iter().zip([1.3, 1.5, 4.0]) {
            for &(omega, amplification) in &line.border {
                let mut given = asked.given.clone();
                given.set(asked.axis, omega);
                given.set(asked.other.as_ref().unwrap().0, alpha);
                let point = input::point(&given).ok().unwrap();
                assert!((margin(point.ratios) - 1.0).abs() < 1e-14, "{alpha} {omega}");
                let cycle = stickslip::Cycle::new(point.ratios).unwrap();
                assert_eq!(amplification, cycle.max_displacement / alpha);
                met += 1;
            }
        }
        assert!(met >= 3, "{met}");
    }
}
