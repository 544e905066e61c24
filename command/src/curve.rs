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
use crate::row::Cell;
use crate::threads;
use clap::ValueEnum;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use std::f64::consts::TAU;
use std::io::Write;
use stickslip::motion::Amplitude;
use stickslip::{Error, Regime};
use stickslip_draw::Figure;
use stickslip_front::curve::{Axis, Place, Source};
use stickslip_front::inputs::units::{Kind, Reader, System};
use stickslip_front::inputs::{Given, Input, Naming, Point, Role};

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

struct Line {
    name: String,
    places: Vec<CurvePoint>,
    /// The points at which the curve meets the sticking threshold.
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

impl Place for CurvePoint {
    fn x(&self) -> f64 {
        self.x
    }

    fn height(&self) -> f64 {
        let otherwise = if self.regime == UNBOUNDED { f64::INFINITY } else { f64::NAN };
        self.value.unwrap_or(otherwise)
    }

    fn is_stuck(&self) -> bool {
        self.regime == STUCK
    }

    fn source(&self) -> Source {
        self.source
    }

    fn because(self, source: Source) -> Self {
        Self { source, ..self }
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
        let xs: Vec<f64> = self.grid.values().collect();
        let falls = xs.first() > xs.last();
        let axis = Axis {
            values: &xs,
            at: |share| self.grid.at(share),
            is_logarithmic: self.grid.is_logarithmic(),
            natural,
        };
        let at = |x, source| self.place(given, x, source);
        let each = |all: Vec<(f64, Source)>| {
            self.refuse_slow(given, natural, &all)?;
            let all = all.into_par_iter();
            threads::on_all(|| all.map(|(x, source)| at(x, source)).collect::<Result<Vec<_>, Failure>>())
        };
        let mut places = axis.through(each, at)?;
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
    fn refuse_slow(&self, given: &Given<f64>, natural: f64, xs: &[(f64, Source)]) -> Outcome {
        let mut slides = 0.0;
        // If all of them stuck there would be so many.
        if xs.iter().map(|(x, _)| natural / x).sum::<f64>() <= MOST_SLIDES {
            return Ok(());
        }
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
            "{name} {low}…: the cycles of this curve have about {slides:.0e} slides in all, must be ≤ {MOST_SLIDES:.0e}. A cycle of \
             so low a frequency has many stops. Single points are answered by steady"
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
                let source = place.source.name();
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
            (Amplitude::Displacement, Kind::Length, "peak displacement", "p₀/k", 0)
        }
        CurveQuantity::Velocity => (Amplitude::Velocity, Kind::Velocity, "peak velocity", "p₀/√(k m)", 1),
        CurveQuantity::Acceleration => {
            (Amplitude::Acceleration, Kind::Acceleration, "peak acceleration", "p₀/m", 2)
        }
        CurveQuantity::Force => (Amplitude::TransmittedForce, Kind::Force, "transmitted force", "p₀", 0),
        CurveQuantity::Transmissibility => {
            (Amplitude::Transmissibility, Kind::Ratio, "transmissibility", "1", 0)
        }
        CurveQuantity::Absolute => {
            (Amplitude::AbsoluteDisplacement, Kind::Length, "peak absolute displacement", "p₀/k", 0)
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
