//! `stickslip map`.

use crate::args::{MapArgs, Picture, Swept};
use crate::axes::Axes;
use crate::failure::{Failure, Outcome};
use crate::figure;
use crate::given::{Given, Parameter as P};
use crate::grid::Grid;
use crate::input;
use crate::interrupt;
use crate::note::digits;
use crate::outputs::{self, plain};
use crate::progress;
use crate::record::{Cell, PEAKS};
use crate::sweep::rows;
use crate::units::{Kind, System};
use std::f64::consts::TAU;
use std::io::Write;
use stickslip::Place;
use stickslip::figures::{Axis, Figure, Panel, Plane, Scale, Series, Style};

/// A value, with its kind where it is in the machine's units.
type Found = (Option<Kind>, Cell<f64>);

/// What is mapped.
enum Quantity<'a> {
    Regime,
    Margin,
    Stops,
    Output(Swept, &'a str),
}

impl<'a> Quantity<'a> {
    fn parse(text: &'a str) -> Self {
        match text {
            "regime" => Self::Regime,
            "margin" => Self::Margin,
            "stops" => Self::Stops,
            _ => match text.strip_prefix("steady:") {
                Some(name) => Self::Output(Swept::Steady, name),
                None => Self::Output(Swept::Response, text),
            },
        }
    }

    const fn name(&self) -> &'a str {
        match self {
            Self::Regime => "regime",
            Self::Margin => "margin",
            Self::Stops => "sticks_per_cycle",
            Self::Output(_, name) => name,
        }
    }

    const fn question(&self) -> Swept {
        match self {
            Self::Regime | Self::Margin => Swept::Response,
            Self::Stops => Swept::Steady,
            Self::Output(question, _) => *question,
        }
    }

    /// The value at a point, with the kind of those in the machine's units; `None` where there is no such output.
    fn at(&self, given: &Given<f64>) -> Result<Option<Found>, Failure> {
        if matches!(self, Self::Margin) {
            let margin = Place::new(input::point(given)?.ratios).margin();
            return Ok(Some((None, Cell::Number(Some(margin)))));
        }
        let peaks = PEAKS.contains(&self.name());
        let record = rows::answer(self.question(), given, peaks)?;
        let physical = record.physical.values.iter().find(|(name, ..)| *name == self.name());
        let found = match physical {
            Some((_, kind, cell)) => Some((Some(*kind), *cell)),
            None => {
                record.fields.iter().find(|(name, _)| *name == self.name()).map(|(_, cell)| (None, *cell))
            }
        };
        Ok(found.filter(|(_, cell)| !matches!(cell, Cell::Pairs(_) | Cell::Intervals(_))))
    }

    /// Where there is no value, and why, as a key has it.
    const fn absence(&self) -> &'static str {
        match self.question() {
            Swept::Response => "white: it sticks or rests",
            Swept::Steady | Swept::Border => "white: at rest, or none",
        }
    }
}

/// A quantity over two grids, the first across.
struct Map<'a> {
    quantity: Quantity<'a>,
    /// Of the values, where they are in the machine's units.
    kind: Option<Kind>,
    axes: Axes<f64>,
    across: (P, Grid<f64>),
    up: (P, Grid<f64>),
    system: System,
}

/// The grids of a map that is asked without any.
const DEFAULT: [(P, &str); 2] = [(P::Omega, "0.0525:1.9975:390"), (P::Alpha, "0.025:7.975:160")];

pub(crate) fn run(args: &MapArgs, out: &mut impl Write) -> Outcome {
    let kind = args.out.as_deref().map_or(Ok(Picture::Csv), figure::picture_of)?;
    let map = Map::new(args)?;
    match (&args.out, kind) {
        (Some(file), Picture::Svg | Picture::Png) => {
            map.drawable()?;
            figure::beside(file, args.overwrite)?.fill(|out| figure::write(&map.picture()?, kind, out))
        }
        (Some(file), Picture::Csv) => {
            figure::beside(file, args.overwrite)?.fill(|out| map.table(&args.quantity, out))
        }
        (None, _) => map.table(&args.quantity, out),
    }
}

impl<'a> Map<'a> {
    fn new(args: &'a MapArgs) -> Result<Self, Failure> {
        let quantity = Quantity::parse(&args.quantity);
        let reader = args.units.reader();
        let mut axes = Axes::new(&args.machine, &args.force, &reader)?;
        if !axes.is_physical() {
            for (parameter, text) in DEFAULT {
                if axes.grids().len() < 2 && axes.grids().iter().all(|(p, _)| *p != parameter) {
                    axes.make_grid(parameter, Grid::parse(parameter.option(), text)?);
                }
            }
        }
        let is_across = |p: P| matches!(p, P::Omega | P::Frequency);
        let (across, up) = match axes.grids() {
            [a, b] if is_across(b.0) && !is_across(a.0) => (b.clone(), a.clone()),
            [a, b] => (a.clone(), b.clone()),
            grids => {
                return Err(Failure::Input(format!(
                    "map: {} of the quantities are grids, must be two, such as --frequency 0.3Hz:5Hz:200 --force \
                     1kN:20kN:100",
                    grids.len()
                )));
            }
        };
        // Row by row: the one that goes across is the fast one.
        axes.order([up.clone(), across.clone()]);
        rows::check(quantity.question(), &axes)?;
        let Some((kind, _)) = quantity.at(&axes.at(0))? else {
            let known = "regime, margin, stops, an output of response, or steady: and an output of steady";
            return Err(Failure::Input(format!("map {}: must be one of {known}", args.quantity)));
        };
        Ok(Self { quantity, kind, axes, across, up, system: reader.system })
    }

    /// The points in order, row by row.
    fn cells(&self, mut take: impl FnMut(Given<f64>, Cell<f64>) -> Outcome) -> Outcome {
        progress::in_order(
            0..self.axes.len(),
            |points| {
                let cell = |point| {
                    if interrupt::asked() {
                        return Err(Failure::Interrupted);
                    }
                    let given = self.axes.at(point);
                    let found = self.quantity.at(&given)?.map_or(Cell::Number(None), |(_, cell)| cell);
                    Ok((given, found))
                };
                points.map(cell).collect::<Result<Vec<_>, Failure>>()
            },
            |found| found.into_iter().try_for_each(|(given, cell)| take(given, cell)),
        )
    }

    /// The unit of a parameter on an axis, and what a value of it is there.
    fn on_axis(&self, parameter: P) -> (String, f64) {
        let kind = parameter.kind();
        if kind == Kind::Ratio {
            (String::new(), 1.0)
        } else if kind == Kind::Frequency {
            (Kind::Hertz.unit(&self.system), 1.0 / TAU)
        } else {
            (kind.unit(&self.system), 1.0)
        }
    }

    fn table(&self, quantity: &str, out: &mut impl Write) -> Outcome {
        let column = |parameter: P| match self.on_axis(parameter).0 {
            unit if unit.is_empty() => parameter.column(),
            unit => format!("{}[{}]", parameter.column(), plain(&unit)),
        };
        let quantity = match self.kind {
            Some(kind) => format!("{quantity}[{}]", plain(&kind.unit(&self.system))),
            None => quantity.to_owned(),
        };
        let (x, y) = (self.across.0, self.up.0);
        let mut writer = csv::Writer::from_writer(out);
        writer.write_record([column(x), column(y), quantity])?;
        let value = |given: &Given<f64>, parameter| {
            Cell::Number(given.get(parameter).map(|v| v * self.on_axis(parameter).1))
        };
        let outcome =
            self.cells(|given, cell| Ok(writer.serialize((value(&given, x), value(&given, y), cell))?));
        writer.flush()?;
        outcome
    }

    /// What the colours stand for, in words, with the unit.
    fn label(&self) -> (String, String) {
        let words = match self.quantity {
            Quantity::Regime => "regime".to_owned(),
            Quantity::Margin => "margin over the border, α/α_min".to_owned(),
            Quantity::Stops => "stops in a cycle".to_owned(),
            Quantity::Output(..) => outputs::in_words(self.quantity.name()),
        };
        let unit = match self.kind {
            Some(kind) => kind.unit(&self.system),
            None => outputs::unit_of(self.quantity.name()).unwrap_or("1").to_owned(),
        };
        let label = if unit == "1" { words.clone() } else { format!("{words} ({unit})") };
        (words, label)
    }

    /// The border of sticking, where the picture has α upwards, or what α is proportional to: from the border itself.
    fn border(&self) -> Vec<(f64, f64)> {
        let up = self.up.0;
        let inverse = matches!(up, P::Friction | P::FrictionCoefficient);
        if !inverse && !P::DRIVES.contains(&up) {
            return Vec::new();
        }
        let ((left, right), (low, _)) = (self.across.1.ends(), self.up.1.ends());
        let mut given = self.axes.at(0);
        let logarithmic = self.across.1.is_logarithmic();
        let at = |i: u32| {
            let share = f64::from(i) / f64::from(BORDER_POINTS);
            if logarithmic { left * (right / left).powf(share) } else { left + (right - left) * share }
        };
        let (across, upwards) = (self.on_axis(self.across.0).1, self.on_axis(up).1);
        let mut points = Vec::new();
        for x in (0..=BORDER_POINTS).map(at) {
            given.set(self.across.0, x);
            given.set(up, low);
            let Ok(point) = input::point(&given) else { continue };
            let margin = Place::new(point.ratios).margin();
            points.push((x * across, upwards * if inverse { low * margin } else { low / margin }));
        }
        points
    }

    /// The light end of the shades is for what moves, as in every picture of ours: the part of the time at rest goes the
    /// other way.
    fn lit(&self, scale: Scale) -> Scale {
        match scale {
            Scale::Shades { low, high, logarithmic } if self.quantity.name() == "stick_fraction" => {
                Scale::Shades { low: high, high: low, logarithmic }
            }
            Scale::Shades { .. } | Scale::Names(_) => scale,
        }
    }

    /// Fails where a picture would be too large.
    fn drawable(&self) -> Outcome {
        let (points, (x, y)) = (self.axes.len(), (self.across.0.option(), self.up.0.option()));
        if points > MOST {
            return Err(Failure::Input(format!("{x}, {y}: {points} points, must be ≤ {MOST} in a picture")));
        }
        for (parameter, grid) in [&self.across, &self.up] {
            if grid.len() > MOST_ACROSS {
                return Err(Failure::Input(format!(
                    "{}: {} values, must be ≤ {MOST_ACROSS} in a picture",
                    parameter.option(),
                    grid.len()
                )));
            }
        }
        Ok(())
    }

    fn axis(&self, (parameter, grid): &(P, Grid<f64>), ends: (f64, f64)) -> Axis {
        let label = match (self.on_axis(*parameter).0, *parameter) {
            (_, P::Omega) => "frequency ratio Ω = ω_d/ω_n".to_owned(),
            (_, P::Alpha) => "force ratio α = p₀/r_y".to_owned(),
            (unit, P::Frequency) => format!("frequency ({unit})"),
            (unit, _) if unit.is_empty() => parameter.symbol().to_owned(),
            (unit, _) => format!("{} ({unit})", parameter.symbol()),
        };
        if grid.is_logarithmic() {
            Axis::logarithmic(&label, ends.0, ends.1)
        } else {
            Axis::linear(&label, ends.0, ends.1)
        }
    }

    fn picture(&self) -> Result<Figure, Failure> {
        let values = |(parameter, grid): &(P, Grid<f64>)| -> Vec<f64> {
            grid.values().map(|v| v * self.on_axis(*parameter).1).collect()
        };
        let (x, y) = (values(&self.across), values(&self.up));
        let (Some(across), Some(up)) = (ends(&x), ends(&y)) else {
            let (x, y) = (self.across.0.option(), self.up.0.option());
            return Err(Failure::Input(format!("{x}, {y}: a picture needs two values or more, ascending")));
        };
        // From the lightest, for a body that never stops, to the darkest, for one at rest; other names as they come.
        let regimes = ["non-sticking", "unbounded", "sticking", "stuck"];
        let mut names: Vec<String> = regimes.map(str::to_owned).to_vec();
        let mut named = false;
        let mut values = Vec::new();
        let mut whole = true;
        self.cells(|_, cell| {
            values.push(match cell {
                Cell::Text(name) => {
                    named = true;
                    place_of(name, &mut names)
                }
                Cell::Count(count) => count.map_or(f64::NAN, |n| n as f64),
                Cell::Number(number) => {
                    whole = false;
                    number.unwrap_or(f64::NAN)
                }
                Cell::Flag(flag) => {
                    named = true;
                    place_of(if flag { "true" } else { "false" }, &mut names)
                }
                Cell::Pairs(_) | Cell::Intervals(_) => f64::NAN,
            });
            Ok(())
        })?;
        let (words, label) = self.label();
        let mut title = capital(&words);
        let scale = match (named, whole) {
            (true, _) => Scale::Names(names),
            (false, true) => counted(&mut values),
            (false, false) => self.lit(clipped(Plane::shades(&values), &values, &mut title)),
        };
        let mut series = Vec::new();
        let border = self.border();
        if !border.is_empty() {
            series.push(Series::new("exact border of sticking", Style::Thick, 0, border));
        }
        if values.iter().any(|v| v.is_nan()) {
            series.push(Series::new(self.quantity.absence(), Style::Note, 0, []));
        }
        Ok(Figure {
            name: "map".to_owned(),
            title,
            caption: String::new(),
            panels: vec![Panel {
                title: String::new(),
                x: self.axis(&self.across, across),
                y: self.axis(&self.up, up),
                series,
                plane: Some(Plane { label, x, y, values, scale }),
            }],
        })
    }
}

/// Most points of a picture, and most from one side to the other: it has to be in memory, and nobody sees more.
const MOST: u64 = 4_000_000;
const MOST_ACROSS: u64 = 20_000;
/// The count that stands for all above it, too.
const MOST_NAMES: f64 = 7.0;
/// Points of the border, more than a picture can show.
const BORDER_POINTS: u32 = 1000;
/// Shades beyond this many times the values of nearly all points are those of a pole.
const POLE: f64 = 100.0;

/// A name for each count, the last one for all above: a key of more lines is not read.
fn counted(values: &mut [f64]) -> Scale {
    let most = values.iter().copied().filter(|v| v.is_finite()).fold(0.0, f64::max);
    let mut names: Vec<String> = (0..=most.min(MOST_NAMES) as u64).map(|n| n.to_string()).collect();
    if most > MOST_NAMES {
        // What is not a number stays none.
        values.iter_mut().filter(|value| **value > MOST_NAMES).for_each(|value| *value = MOST_NAMES);
        if let Some(last) = names.last_mut() {
            last.push_str(" or more");
        }
    }
    Scale::Names(names)
}

/// The shades without what is close to a pole, which the title then says.
fn clipped(scale: Scale, values: &[f64], title: &mut String) -> Scale {
    let Scale::Shades { low, high, logarithmic: true } = scale else { return scale };
    let mut sorted: Vec<f64> = values.iter().copied().filter(|v| v.is_finite()).collect();
    sorted.sort_by(f64::total_cmp);
    let at = |share: f64| sorted.get((sorted.len() as f64 * share) as usize).copied();
    let (Some(few), Some(most)) = (at(0.05), at(0.95)) else { return scale };
    let (new_low, new_high) = (low.max(few / POLE), high.min(most * POLE));
    match (new_low > low, new_high < high) {
        (false, false) => {}
        (true, false) => title.push_str(&format!(", cut off below {}", digits(round(new_low)))),
        (false, true) => title.push_str(&format!(", cut off above {}", digits(round(new_high)))),
        (true, true) => title.push_str(&format!(
            ", cut off below {} and above {}",
            digits(round(new_low)),
            digits(round(new_high))
        )),
    }
    let cut = |new: f64, old: f64| if new == old { old } else { round(new) };
    Scale::Shades { low: cut(new_low, low), high: cut(new_high, high), logarithmic: true }
}

/// The nearest power of ten.
fn round(value: f64) -> f64 {
    10f64.powf(value.log10().round())
}

/// The text with a capital.
pub(crate) fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}

/// The first and the last value, where all are ascending.
fn ends(values: &[f64]) -> Option<(f64, f64)> {
    let ascending = values.windows(2).all(|pair| matches!(pair, [a, b] if a < b));
    match values {
        [first, .., last] if ascending => Some((*first, *last)),
        _ => None,
    }
}

/// The place of a name in the list, at its end where it is new.
fn place_of(name: &str, names: &mut Vec<String>) -> f64 {
    let place = names.iter().position(|n| n == name).unwrap_or_else(|| {
        names.push(name.to_owned());
        names.len() - 1
    });
    place as f64
}
