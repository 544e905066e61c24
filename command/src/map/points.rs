//! The points of a map, and what is shown at each.

use super::limits;
use crate::args::{MapArgs, Swept};
use crate::failure::{Failure, Outcome};
use crate::grid::{Axes, Grid};
use crate::outputs::plain;
use crate::row::{Cell, Number};
use crate::sweep::loops::Looped;
use crate::sweep::rows;
use crate::{figure, input, interrupt, outputs, progress};
use std::f64::consts::TAU;
use std::io::Write;
use stickslip::internal::definitions::LIMIT;
use stickslip::{Output, Ratios, Regime, Response};
use stickslip_front::inputs::units::{Kind, System};
use stickslip_front::inputs::{Given, Input};

/// The default grids of a map.
const DEFAULT: [(Input, &str); 2] = [(Input::Omega, "0.0525:1.9975:390"), (Input::Alpha, "0.025:7.975:160")];

/// A value, with its kind if it is in the machine's units, and the reason if it is missing.
pub(super) struct MapValue {
    pub(super) kind: Option<Kind>,
    pub(super) cell: Cell<Number>,
    pub(super) absence: Absence,
}

/// The reason for a missing value, in the order of a key.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Absence {
    Sticks,
    AtRest,
    DependsOnStart,
    NotPeriodic,
    /// The motion was not found, or its numbers leave their type; a note has the reason.
    NoAnswer,
    /// There is a motion, but it has no such value.
    NoSuchValue,
}

impl Absence {
    /// That of a value of the closed forms.
    pub(super) fn of_regime(ratios: Ratios<f64>) -> Self {
        match Response::new(ratios).regime {
            Regime::Stuck => Self::AtRest,
            Regime::Sticking => Self::Sticks,
            Regime::DependsOnStart => Self::DependsOnStart,
            Regime::NonSticking | Regime::Unbounded => Self::NoSuchValue,
        }
    }

    /// That of a value of the exact motion, from the name of its limit.
    pub(super) fn of_limit(name: &str) -> Self {
        match name {
            "rest" => Self::AtRest,
            "irregular" | "none" | "not-converged" => Self::NotPeriodic,
            _ => Self::NoSuchValue,
        }
    }

    pub(super) const fn in_words(self) -> &'static str {
        match self {
            Self::Sticks => "the body sticks",
            Self::AtRest => "the body never moves",
            Self::DependsOnStart => "depends on the start",
            Self::NotPeriodic => "no periodic motion",
            Self::NoAnswer => "no answer",
            Self::NoSuchValue => "no such value",
        }
    }
}

/// What is mapped.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Mapped {
    Regime,
    Margin,
    Stops,
    Limits,
    Output,
}

/// Quantity to map, and the question that it is an output of.
pub(super) struct Quantity<'a> {
    pub(super) mapped: Mapped,
    pub(super) name: &'a str,
    pub(super) question: Swept,
}

impl<'a> Quantity<'a> {
    pub(super) fn parse(text: &'a str) -> Self {
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

    /// The loops of a batch that compute it, if there are any.
    pub(super) fn looped(&self, given: &Given<f64>) -> Option<Looped> {
        let is_closed =
            matches!(self.mapped, Mapped::Regime | Mapped::Output) && self.question == Swept::Response;
        if !is_closed {
            return None;
        }
        let row = rows::answer(self.question, given, outputs::is_searched(self.name)).ok()?;
        // As `value_at` has it.
        let name = [self.name.to_owned()];
        let only = if row.physical.has(self.name) { [format!("physical.{}", self.name)] } else { name };
        rows::looped(&row.only(&only), given)
    }

    /// The value at a point, with the kind of values in the machine's units; `None` if there is no such
    /// output.
    pub(super) fn value_at(&self, given: &Given<f64>) -> Result<Option<MapValue>, Failure> {
        if self.mapped == Mapped::Margin {
            let margin = margin(input::point(given)?.ratios);
            return Ok(Some(MapValue::of(Cell::Number(Some(Number::Double(margin))))));
        }
        if self.mapped == Mapped::Limits {
            return Ok(Some(MapValue::of(Cell::Text(limits::described(input::point(given)?.ratios)?))));
        }
        let peaks = outputs::is_searched(self.name);
        let record = rows::answer(self.question, given, peaks)?;
        let physical = record.physical.values.iter().find(|(name, ..)| *name == self.name);
        let own =
            |wanted: &str| record.fields.iter().find(|(key, _)| key.name == wanted).map(|(_, cell)| cell);
        let found = match physical {
            Some((_, kind, cell)) => Some((Some(*kind), cell.clone())),
            None => own(self.name).map(|cell| (None, cell.clone())),
        };
        let absence = match own(LIMIT.name) {
            Some(Cell::Text(limit)) => Absence::of_limit(limit),
            _ => Absence::of_regime(input::point(given)?.ratios),
        };
        let found = found.filter(|(_, cell)| !matches!(cell, Cell::Pairs(_) | Cell::Intervals(_)));
        Ok(found.map(|(kind, cell)| MapValue { kind, cell, absence }))
    }
}

impl MapValue {
    /// A value that is in no unit and never missing.
    pub(super) const fn of(cell: Cell<Number>) -> Self {
        Self { kind: None, cell, absence: Absence::NoSuchValue }
    }
}

/// A quantity over two grids, of which the first is horizontal.
pub(super) struct Map<'a> {
    pub(super) quantity: Quantity<'a>,
    /// The kind of the values, if they are in the machine's units.
    pub(super) kind: Option<Kind>,
    pub(super) axes: Axes<f64>,
    pub(super) across: (Input, Grid<f64>),
    pub(super) up: (Input, Grid<f64>),
    pub(super) system: System,
    /// The unit of frequencies, and its value in rad/s.
    pub(super) frequency: (String, f64),
    /// The inputs that all points share.
    pub(super) machine: String,
    /// The values of the first and the last shade, where they were chosen.
    pub(super) range: Option<(f64, f64)>,
}

impl<'a> Map<'a> {
    pub(super) fn new(args: &'a MapArgs) -> Result<Self, Failure> {
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
        let Some(MapValue { kind, .. }) = quantity.value_at(&axes.given_at(0))? else {
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
    pub(super) fn cells(
        &self,
        axes: &Axes<f64>,
        mut take: impl FnMut(Given<f64>, MapValue) -> Outcome,
    ) -> Outcome {
        let looped = self.quantity.looped(&axes.given_at(0));
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
            let none = MapValue { kind: None, cell: Cell::Number(None), absence: Absence::NoAnswer };
            Ok((given, found.unwrap_or(none)))
        };
        progress::in_order_kept(
            0..axes.len(),
            |points| {
                if interrupt::asked() {
                    return vec![Err(Failure::Interrupted)];
                }
                let Some(looped) = &looped else { return vec![one(axes.given_at(points.start))] };
                let given: Vec<_> = points.map(|point| axes.given_at(point)).collect();
                let points: Vec<_> = given.iter().cloned().map(Looped::at).collect();
                let values = looped.rows(&points).into_iter().zip(&points).map(|(row, at)| {
                    let row = row?;
                    let physical = row.physical.values.into_iter().map(|(_, kind, cell)| (Some(kind), cell));
                    let (kind, cell) =
                        row.fields.into_iter().map(|(_, cell)| (None, cell)).chain(physical).next()?;
                    let absence = if cell.is_absent() {
                        Absence::of_regime(at.as_ref()?.ratios)
                    } else {
                        Absence::NoSuchValue
                    };
                    Some(MapValue { kind, cell, absence })
                });
                // Alone, a point without ratios has its error.
                let answer = |(given, value)| match value {
                    Some(value) => Ok((given, value)),
                    None => one(given),
                };
                given.into_iter().zip(values).map(answer).collect()
            },
            |found| found.map_or(Ok(()), |(given, value)| take(given, value)),
        )
    }

    /// The unit of a parameter on an axis, and the scale of its values.
    pub(super) fn on_axis(&self, parameter: Input) -> (String, f64) {
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

    pub(super) fn table(&self, quantity: &str, out: &mut impl Write) -> Outcome {
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
        let outcome = self.cells(&self.axes, |given, found| {
            Ok(writer.serialize((value(&given, x), value(&given, y), found.cell))?)
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
