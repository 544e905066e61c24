//! `stickslip map`.

mod limits;
mod picture;
mod resonance;

use crate::args::{MapArgs, Swept};
use crate::failure::{Failure, Outcome};
use crate::figure::{self, Target};
use crate::grid::{Axes, Grid};
use crate::input;
use crate::interrupt;
use crate::outputs::{self, plain};
use crate::progress;
use crate::record::{Cell, Number};
use crate::sweep::loops::Looped;
use crate::sweep::rows;
use std::f64::consts::TAU;
use std::io::Write;
use stickslip::inputs::units::{Kind, System};
use stickslip::inputs::{Given, Input};
use stickslip::{Output, Ratios};

pub(crate) use picture::{capital, ends};

/// A value, with its kind if it is in the machine's units.
type MapValue = (Option<Kind>, Cell<Number>);

/// What is mapped.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Mapped {
    Regime,
    Margin,
    Stops,
    Limits,
    Output,
}

/// Quantity to map, and the question that it is an output of.
struct Quantity<'a> {
    mapped: Mapped,
    name: &'a str,
    question: Swept,
}

impl<'a> Quantity<'a> {
    fn parse(text: &'a str) -> Self {
        let (mapped, name, question) = match text {
            "regime" => (Mapped::Regime, text, Swept::Response),
            "margin" => (Mapped::Margin, text, Swept::Response),
            "stops" => (Mapped::Stops, "sticks_per_cycle", Swept::Steady),
            "limits" => (Mapped::Limits, text, Swept::Steady),
            _ => match text.strip_prefix("steady:") {
                Some(name) => (Mapped::Output, name, Swept::Steady),
                None => (Mapped::Output, text, Swept::Response),
            },
        };
        Self { mapped, name, question }
    }

    /// The loops of a batch that compute it in ratios, if there are any.
    fn looped(&self) -> Option<Looped> {
        let is_closed =
            matches!(self.mapped, Mapped::Regime | Mapped::Output) && self.question == Swept::Response;
        Looped::of(core::iter::once(outputs::find(self.name).filter(|_| is_closed)?))
    }

    /// The value at a point, with the kind of values in the machine's units; `None` if there is no such
    /// output.
    fn value_at(&self, given: &Given<f64>) -> Result<Option<MapValue>, Failure> {
        if self.mapped == Mapped::Margin {
            let margin = margin(input::point(given)?.ratios);
            return Ok(Some((None, Cell::Number(Some(Number::Double(margin))))));
        }
        if self.mapped == Mapped::Limits {
            return Ok(Some((None, Cell::Text(limits::described(input::point(given)?.ratios)?))));
        }
        let peaks = outputs::is_searched(self.name);
        let record = rows::answer(self.question, given, peaks)?;
        let physical = record.physical.values.iter().find(|(name, ..)| *name == self.name);
        let found = match physical {
            Some((_, kind, cell)) => Some((Some(*kind), cell.clone())),
            None => record
                .fields
                .iter()
                .find(|(key, _)| key.name == self.name)
                .map(|(_, cell)| (None, cell.clone())),
        };
        Ok(found.filter(|(_, cell)| !matches!(cell, Cell::Pairs(_) | Cell::Intervals(_))))
    }

    /// The reasons for missing values, as text for a key: some of bodies that never move, and others.
    const fn absence(&self, at_rest: bool, others: bool) -> &'static str {
        match (self.question, at_rest, others) {
            (Swept::Response, ..) => "white: the body sticks or stays at rest",
            (_, true, true) => "white: at rest, or no periodic motion",
            (_, true, false) => "white: the body never moves",
            (_, false, _) => "white: no periodic motion",
        }
    }
}

/// A quantity over two grids, of which the first is horizontal.
struct Map<'a> {
    quantity: Quantity<'a>,
    /// The kind of the values, if they are in the machine's units.
    kind: Option<Kind>,
    axes: Axes<f64>,
    across: (Input, Grid<f64>),
    up: (Input, Grid<f64>),
    system: System,
    /// The unit of frequencies, and its value in rad/s.
    frequency: (String, f64),
    /// The inputs that all points share.
    machine: String,
    /// The values of the first and the last shade, where they were chosen.
    range: Option<(f64, f64)>,
}

/// The default grids of a map.
const DEFAULT: [(Input, &str); 2] = [(Input::Omega, "0.0525:1.9975:390"), (Input::Alpha, "0.025:7.975:160")];

pub(crate) fn run(args: &MapArgs, out: &mut impl Write) -> Outcome {
    let target = Target::new("--out", args.out.as_deref(), args.overwrite, &args.look)?;
    let map = Map::new(args)?;
    target.fill(out, |mut out| map.table(&args.quantity, &mut out), || map.picture())
}

impl<'a> Map<'a> {
    fn new(args: &'a MapArgs) -> Result<Self, Failure> {
        let quantity = Quantity::parse(&args.quantity);
        let reader = args.units.reader();
        let mut axes = Axes::new(&args.machine, &reader)?;
        if !axes.is_physical() {
            for (parameter, text) in DEFAULT {
                if axes.grids().len() < 2 && axes.grids().iter().all(|(p, _)| *p != parameter) {
                    axes.make_grid(parameter, Grid::parse(parameter.option(), text)?);
                }
            }
        }
        let is_across = |p: Input| matches!(p, Input::Omega | Input::Frequency);
        let (across, up) = match axes.grids() {
            [a, b] if is_across(b.0) && !is_across(a.0) => (b.clone(), a.clone()),
            [a, b] => (a.clone(), b.clone()),
            grids => {
                return Err(format!(
                    "map: {} {}, must be two, such as --frequency 0.3Hz:5Hz:200 --force 1kN:20kN:100",
                    grids.len(),
                    if grids.len() == 1 { "grid" } else { "grids" }
                )
                .into());
            }
        };
        // Points are computed row by row: the horizontal grid varies fastest.
        axes.order([up.clone(), across.clone()]);
        rows::check(quantity.question, &axes)?;
        let Some((kind, _)) = quantity.value_at(&axes.given_at(0))? else {
            let known =
                "regime, margin, stops, limits, an output of response, or steady: and an output of steady";
            return Err(format!("map {}: must be one of {known}", args.quantity).into());
        };
        let range = args.range.as_ref().map(|text| figure::range("--range", text, true)).transpose()?;
        let system = reader.system();
        let frequency = input::frequency_unit(args.machine.text(Input::Frequency));
        let frequency = frequency.unwrap_or_else(|| (system.name(Kind::Hertz), TAU));
        let is_fixed = |input| input != across.0 && input != up.0;
        let machine = input::line(&args.machine, is_fixed, &system);
        Ok(Self { quantity, kind, axes, across, up, system, frequency, machine, range })
    }

    /// Computes the points in order, row by row.
    fn cells(&self, axes: &Axes<f64>, mut take: impl FnMut(Given<f64>, Cell<Number>) -> Outcome) -> Outcome {
        let looped = self.quantity.looped().filter(|_| !axes.is_physical());
        let one = |given: Given<f64>| {
            let found = match self.quantity.value_at(&given) {
                // A point whose ratios are known, but whose motion or numbers are not.
                Err(failure) if failure.is_of_an_answer() && input::point(&given).is_ok() => {
                    let place = [self.across.0, self.up.0].map(|input| {
                        let value = given.get(input).map_or_else(String::new, |value| value.to_string());
                        format!("{} {value}", input.option())
                    });
                    progress::no_answer(&failure.about(&place.join(" ")));
                    None
                }
                found => found?,
            };
            Ok((given, found.map_or(Cell::Number(None), |(_, cell)| cell)))
        };
        progress::in_order_kept(
            0..axes.len(),
            |points| {
                if interrupt::asked() {
                    return vec![Err(Failure::Interrupted)];
                }
                let Some(looped) = &looped else { return vec![one(axes.given_at(points.start))] };
                let given: Vec<_> = points.map(|point| axes.given_at(point)).collect();
                let ratios: Vec<_> = given.iter().map(Looped::ratios).collect();
                let cells = looped.records(&ratios).into_iter().map(|record| {
                    record.and_then(|record| record.fields.into_iter().next().map(|(_, cell)| cell))
                });
                // Alone, a point without ratios has its error.
                let answer = |(given, cell)| match cell {
                    Some(cell) => Ok((given, cell)),
                    None => one(given),
                };
                given.into_iter().zip(cells).map(answer).collect()
            },
            |found| found.map_or(Ok(()), |(given, cell)| take(given, cell)),
        )
    }

    /// The unit of a parameter on an axis, and the scale of its values.
    fn on_axis(&self, parameter: Input) -> (String, f64) {
        let kind = parameter.kind();
        if kind == Kind::Ratio {
            (String::new(), 1.0)
        } else if kind == Kind::Frequency {
            (self.frequency.0.clone(), 1.0 / self.frequency.1)
        } else if kind == Kind::Mass {
            let (unit, factor) = self.system.mass_for_reading();
            (unit.to_owned(), factor.times(1.0))
        } else {
            (self.system.name(kind), 1.0)
        }
    }

    fn table(&self, quantity: &str, out: &mut impl Write) -> Outcome {
        let column = |parameter: Input| match self.on_axis(parameter).0 {
            unit if unit.is_empty() => parameter.column(),
            unit => format!("{}[{}]", parameter.column(), plain(&unit)),
        };
        let quantity = match self.kind {
            Some(kind) => format!("{quantity}[{}]", plain(&self.system.name(kind))),
            None => quantity.to_owned(),
        };
        let (x, y) = (self.across.0, self.up.0);
        let mut writer = csv::Writer::from_writer(out);
        writer.write_record([column(x), column(y), quantity])?;
        let value = |given: &Given<f64>, parameter| {
            Cell::Number(given.get(parameter).map(|v| v * self.on_axis(parameter).1)).shown()
        };
        let outcome = self.cells(&self.axes, |given, cell| {
            Ok(writer.serialize((value(&given, x), value(&given, y), cell))?)
        });
        writer.flush()?;
        outcome
    }
}

/// The force over the minimum force without sticking, α/α_min.
pub(crate) fn margin(ratios: Ratios<f64>) -> f64 {
    let [least] = Output::values([Output::MinForceRatio], ratios);
    ratios.alpha() / least
}

/// The number of points of the border, more than a picture can show.
const BORDER_POINTS: u32 = 1000;
