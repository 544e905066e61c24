//! Answers over a grid of values of the file, of its loads' frequency and of records, a row each.

use super::answer::{is_hard, kind_of};
use super::built::NamedSystem;
use super::described::Described;
use super::node::Number;
use super::why::Why;
use crate::grid::Range;
use crate::inputs::units::{Kind as Of, Reader, System as Units, split};
use crate::text::Folder;
use serde_json::Value;
use std::ops::ControlFlow;
use std::path::Path;
use stickslip::motion::record::Record;
use stickslip::system::{Motion, Steady};

/// The rows of which one must be right.
const TRIED: u64 = 1000;
/// The most rows of a grid.
pub const MOST_ROWS: u64 = 1_000_000;

/// The content of a cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Cell<'a, F = f64> {
    /// A text: of a record, of a value that is no number, or of a kind.
    Text(&'a str),
    /// A number, where there is one.
    Number(Option<F>),
    /// A count, where there is one.
    Count(Option<u64>),
}

/// The values of an axis.
#[derive(Debug, Clone)]
enum Values {
    /// Numbers in one unit, empty where they have none.
    Numbers(Vec<f64>, String),
    /// Numbers that were typed in several units of one kind: in the first of them, and as they were typed.
    Mixed(Vec<f64>, String, Vec<String>),
    /// Texts such as the names of files.
    Texts(Vec<String>),
}

/// One value that changes from row to row.
#[derive(Debug, Clone)]
pub struct Axis {
    /// The path in the file; `None` for the frequency of the loads.
    path: Option<String>,
    /// The words before a value in messages: the path, or the name of the option.
    typed: String,
    values: Values,
    /// Whether it changes together with the axis before it.
    is_beside: bool,
}

impl Axis {
    /// This axis, whose values change together with those of the axis before it, which has as many.
    #[must_use]
    pub fn beside(self) -> Self {
        Self { is_beside: true, ..self }
    }

    /// The value at a path of the file, over `FROM:TO:COUNT`, `FROM:TO:COUNT:log`, both ends with one unit, a list
    /// `A,B,C`, or one value.
    ///
    /// # Errors
    /// Names the text and the condition.
    pub fn of(path: &str, text: &str) -> Result<Self, String> {
        let typed = format!("{path}=");
        Ok(Self { path: Some(path.to_owned()), values: values(&typed, text)?, typed, is_beside: false })
    }

    /// Values at a path of the file, or of the lowest frequency of the loads for `None`, as they would be typed; bare
    /// frequencies are in rad/s.
    #[must_use]
    pub fn of_each(path: Option<&str>, typed: &[String]) -> Self {
        let values = listed(typed.iter().map(String::as_str));
        let typed = path.map_or_else(|| "frequency ".to_owned(), |path| format!("{path}="));
        Self { path: path.map(str::to_owned), typed, values, is_beside: false }
    }

    /// The number of values.
    fn len(&self) -> usize {
        match &self.values {
            Values::Numbers(numbers, _) | Values::Mixed(numbers, ..) => numbers.len(),
            Values::Texts(texts) => texts.len(),
        }
    }

    /// A value as it would be typed.
    fn typed(&self, place: usize) -> String {
        match &self.values {
            Values::Numbers(numbers, unit) => {
                numbers.get(place).map_or_else(String::new, |x| format!("{x}{unit}"))
            }
            Values::Mixed(.., texts) | Values::Texts(texts) => texts.get(place).cloned().unwrap_or_default(),
        }
    }

    fn cell(&self, place: usize) -> Cell<'_> {
        match &self.values {
            Values::Numbers(numbers, _) | Values::Mixed(numbers, ..) => {
                Cell::Number(numbers.get(place).copied())
            }
            Values::Texts(texts) => Cell::Text(texts.get(place).map_or("", String::as_str)),
        }
    }

    /// The name of the column, with the unit of its values in brackets, where bare numbers have the given one.
    fn name(&self, bare: &str) -> String {
        let name = self.path.as_deref().unwrap_or("frequency");
        match &self.values {
            Values::Numbers(_, unit) | Values::Mixed(_, unit, _) if !unit.is_empty() => {
                format!("{name}[{unit}]")
            }
            Values::Numbers(..) if !bare.is_empty() => format!("{name}[{bare}]"),
            Values::Numbers(..) | Values::Mixed(..) | Values::Texts(_) => name.to_owned(),
        }
    }

    /// The lowest frequency of the loads, as above; a bare one is in rad/s.
    ///
    /// # Errors
    /// Names the text and the condition.
    pub fn of_frequency(name: &str, text: &str) -> Result<Self, String> {
        let typed = format!("{name} ");
        Ok(Self { path: None, values: values(&typed, text)?, typed, is_beside: false })
    }
}

/// Values as they are typed: numbers, if all of them are numbers in one unit.
fn listed<'t>(texts: impl Iterator<Item = &'t str> + Clone) -> Values {
    let parts = texts.clone().map(|text| split(text.trim()));
    let unit = parts.clone().next().map_or("", |(_, unit)| unit);
    let number = |(number, own): (&str, &str)| {
        let x = number.trim().parse::<f64>().ok().filter(|x| x.is_finite());
        x.filter(|_| own == unit)
    };
    if let Some(numbers) = parts.map(number).collect::<Option<Vec<f64>>>() {
        return Values::Numbers(numbers, unit.to_owned());
    }
    let typed: Vec<String> = texts.map(|text| text.trim().to_owned()).collect();
    in_unit(typed, None)
}

/// Kinds of values, one of each dimension.
const KINDS: [Of; 12] = [
    Of::Mass,
    Of::Length,
    Of::Time,
    Of::Angle,
    Of::Frequency,
    Of::Velocity,
    Of::Acceleration,
    Of::Force,
    Of::Stiffness,
    Of::Damping,
    Of::Energy,
    Of::Ratio,
];

/// Values of one kind as numbers in the unit of the first that has one, where bare ones are in a system of units; otherwise as texts.
fn in_unit(typed: Vec<String>, system: Option<&Units>) -> Values {
    let reader = Reader::new(system, "");
    let read = |text: &str, kind: Of| {
        let is_known = system.is_some() || Reader::has_unit(text);
        let value = is_known.then(|| reader.value("", text, kind).ok()).flatten();
        value.filter(|x: &f64| x.is_finite())
    };
    let unit = typed.iter().find(|text| Reader::has_unit(text)).map_or("", |text| split(text).1);
    let numbers = |kind: Of| -> Option<Vec<f64>> {
        let one = read(&format!("1 {unit}"), kind)?;
        typed.iter().map(|text| Some(read(text, kind)? / one)).collect()
    };
    let found = if unit.is_empty() { None } else { KINDS.into_iter().find_map(numbers) };
    match found {
        Some(numbers) => Values::Mixed(numbers, unit.to_owned(), typed),
        None => Values::Texts(typed),
    }
}

/// The values of a text: one, a list, or a range.
fn values(name: &str, text: &str) -> Result<Values, String> {
    let bad = |what: &str| format!("{name}{text}: {what}");
    let Some(range) = Range::typed(text, MOST_ROWS).map_err(|what| bad(&what))? else {
        return Ok(listed(text.split(',')));
    };
    let ((first, unit), (last, other)) = (split(range.from), split(range.to));
    if unit != other {
        return Err(bad("both ends must have the same unit"));
    }
    let number = |text: &str| text.trim().parse::<f64>().map_err(|_| bad("each value must be a number"));
    let range = range.between(number(first)?, number(last)?).map_err(bad)?;
    Ok(Values::Numbers((0..range.count).map(|place| range.value(place)).collect(), unit.to_owned()))
}

/// The motion that a row is about.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Asked {
    /// The steady motion.
    Steady,
    /// The motion from the start to a time, or to the end of the records.
    Transient(Option<f64>),
    /// The minimum load that keeps the only contact from sticking.
    Border,
}

/// A grid of systems and the question about each: records vary slowest, and the last axis fastest.
#[derive(Debug)]
pub struct Grid<'a> {
    value: &'a Value,
    folder: &'a Path,
    units: Option<&'a Units>,
    axes: Vec<Axis>,
    records: &'a [(String, Record<f64>)],
    asked: Asked,
    names: Vec<String>,
    /// A row without an answer, which has a cell of its kind for each name.
    blank: Vec<Cell<'static>>,
    count: u64,
    keep_going: fn() -> ControlFlow<()>,
    /// The coordinates that are chosen.
    shown: Option<Vec<usize>>,
}

/// The place of a row on each axis, and its record.
type Place<'a> = (Vec<usize>, Option<&'a (String, Record<f64>)>);

impl<'a> Grid<'a> {
    /// A grid over a value of a file, as for [`NamedSystem::new`], and over records of the base, if there are any.
    ///
    /// # Errors
    /// Where the grid is too large, or the system of its first row is wrong.
    pub fn new(
        value: &'a Value,
        folder: &'a Path,
        units: Option<&'a Units>,
        axes: Vec<Axis>,
        records: &'a [(String, Record<f64>)],
        asked: Asked,
    ) -> Result<Self, String> {
        for pair in axes.windows(2) {
            if let [before, axis] = pair
                && axis.is_beside
                && axis.len() != before.len()
            {
                let (name, other, n, due) = (axis.name(""), before.name(""), axis.len(), before.len());
                return Err(format!("{name}: has {n} values, must have as many as {other}, which has {due}"));
            }
        }
        let lengths = axes.iter().filter(|axis| !axis.is_beside).map(|axis| axis.len() as u64);
        let lengths = lengths.chain([records.len().max(1) as u64]);
        let count = lengths.into_iter().try_fold(1u64, u64::checked_mul).filter(|n| *n <= MOST_ROWS);
        let count = count.ok_or_else(|| format!("the grid must have ≤ {MOST_ROWS} rows"))?;
        let (names, blank) = (Vec::new(), Vec::new());
        let keep_going = || ControlFlow::Continue(());
        let mut grid =
            Self { value, folder, units, axes, records, asked, names, blank, count, keep_going, shown: None };
        let described = grid.described()?;
        for axis in &mut grid.axes {
            if let (Values::Texts(typed), Some(system)) = (&mut axis.values, &described.units) {
                axis.values = in_unit(core::mem::take(typed), Some(system));
            }
        }
        Ok(grid.named(&described))
    }

    /// This grid with the columns of a description.
    fn named(self, described: &Described) -> Self {
        let record = self.records.first().map(|_| "record".to_owned());
        let axes = self.axes.iter().map(|axis| axis.name(&self.unit_of_bare(axis, described)));
        let (answers, blank): (Vec<String>, _) = columns(described, self.asked).into_iter().unzip();
        let names = record.into_iter().chain(axes).chain(answers).collect();
        Self { names, blank, ..self }
    }

    /// This grid with the answers of chosen coordinates, as for [`Described::show`].
    ///
    /// # Errors
    /// As [`Described::show`].
    pub fn showing(mut self, argument: &str, names: &str) -> Result<Self, String> {
        let mut described = self.described()?;
        described.show(argument, names)?;
        self.shown.clone_from(&described.shown);
        Ok(self.named(&described))
    }

    /// This grid, whose motions are followed as long as `keep_going` returns [`ControlFlow::Continue`].
    #[must_use]
    pub fn while_allowed(self, keep_going: fn() -> ControlFlow<()>) -> Self {
        Self { keep_going, ..self }
    }

    /// The number of rows.
    #[must_use]
    pub const fn len(&self) -> u64 {
        self.count
    }

    /// Whether there are no rows: never.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// The names of the columns, with units in brackets: of the record, of the axes, then of the answers.
    #[must_use]
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The number of values of each record and each axis: records first, if there are any.
    #[must_use]
    pub fn lengths(&self) -> Vec<usize> {
        let records = self.records.first().map(|_| self.records.len());
        records.into_iter().chain(self.axes.iter().map(Axis::len)).collect()
    }

    /// The unit of bare numbers on an axis of a system with units: the one in which they mean the same. A bare frequency is in rad/s.
    fn unit_of_bare(&self, axis: &Axis, described: &Described) -> String {
        let Some(units) = described.units else { return String::new() };
        let last = axis.path.as_deref().map_or("frequency", |path| path.rsplit('.').next().unwrap_or(""));
        if last == "frequency" {
            return "rad/s".to_owned();
        }
        let (Some(path), Values::Numbers(numbers, unit)) = (axis.path.as_deref(), &axis.values) else {
            return String::new();
        };
        if !unit.is_empty() {
            return String::new();
        }
        let with = |text: &str| {
            let found = NamedSystem::new(self.value, [(path, text)], self.folder, self.units).ok()?;
            Some((found.described.model, found.described.start))
        };
        // A number that is 0, or that the system does not take, says nothing.
        let tried = numbers.iter().filter(|x| **x != 0.0).find_map(|x| Some((x, with(&x.to_string())?)));
        let Some((x, due)) = tried else { return String::new() };
        let names = KINDS.into_iter().filter(|kind| *kind != Of::Ratio).map(|kind| units.name(kind));
        let same = |unit: &String| with(&format!("{x} {unit}")).is_some_and(|found| found == due);
        names.into_iter().find(same).unwrap_or_default()
    }

    fn place(&self, row: u64) -> Place<'a> {
        let mut left = row;
        let mut next = |length: usize| {
            let length = length.max(1) as u64;
            let place = left.checked_rem(length).unwrap_or(0);
            left = left.checked_div(length).unwrap_or(0);
            place as usize
        };
        let of = |axis: &Axis| if axis.is_beside { None } else { Some(next(axis.len())) };
        let mut own: Vec<Option<usize>> = self.axes.iter().rev().map(of).collect();
        own.reverse();
        let mut last = 0;
        let beside = |place: Option<usize>| {
            last = place.unwrap_or(last);
            last
        };
        let places = own.into_iter().map(beside).collect();
        (places, self.records.get(next(self.records.len())))
    }

    /// The system of a row, with another value on the last axis, if there is one.
    fn system(&self, place: &Place<'a>, other: Option<f64>) -> Result<NamedSystem, String> {
        let found = self.without_record(place, other)?;
        match place.1 {
            Some((name, record)) => found.with_record(record, name),
            None => Ok(found),
        }
    }

    /// That system without its record.
    fn without_record<F: Number>(
        &self,
        (places, _): &Place<'a>,
        other: Option<f64>,
    ) -> Result<NamedSystem<F>, String> {
        let mut typed: Vec<String> = self.axes.iter().zip(places).map(|(axis, at)| axis.typed(*at)).collect();
        if let (Some(x), Some(typed), Some(Values::Numbers(_, unit) | Values::Mixed(_, unit, _))) =
            (other, typed.last_mut(), self.axes.last().map(|axis| &axis.values))
        {
            *typed = format!("{x}{unit}");
        }
        let chosen = || self.axes.iter().zip(&typed);
        let set = chosen().filter_map(|(axis, text)| Some((axis.path.as_deref()?, text.as_str())));
        let mut found = NamedSystem::<F>::read(self.value, set, &Folder::new(self.folder), self.units)?;
        for (axis, text) in chosen().filter(|(axis, _)| axis.path.is_none()) {
            let frequency = found.reader().value(axis.typed.trim(), text, Of::Frequency);
            found = found
                .at_frequency(frequency.map_err(|e| e.to_string())?)
                .map_err(|e| format!("{}{text}: {e}", axis.typed))?;
        }
        found.described.shown.clone_from(&self.shown);
        Ok(found)
    }

    /// The description of the first row that has one: all have the same parts.
    ///
    /// # Errors
    /// What is wrong with the first row, where none of the first rows is right.
    pub fn described(&self) -> Result<Described, String> {
        let system = |row: u64| self.system(&self.place(row), None).map(|found| found.described);
        let first = system(0).map_err(|e| if self.count > 1 { format!("row 1: {e}") } else { e });
        first.or_else(|why| (1..self.count.min(TRIED)).find_map(|row| system(row).ok()).ok_or(why))
    }

    /// The cells of a row that say which it is: its record, and the values on the axes.
    #[must_use]
    pub fn given(&self, row: u64) -> Vec<Cell<'_>> {
        let (places, record) = self.place(row);
        let record = record.map(|(name, _)| Cell::Text(name.as_str()));
        record.into_iter().chain(self.axes.iter().zip(places).map(|(axis, at)| axis.cell(at))).collect()
    }

    /// The cells of a row's answer, without values where there is none.
    #[must_use]
    pub fn blank(&self) -> &[Cell<'static>] {
        &self.blank
    }

    /// The cells of a row's answer.
    ///
    /// # Errors
    /// The reason why there is none, on one line.
    pub fn answer(&self, row: u64) -> Result<Vec<Cell<'static>>, String> {
        self.answer_of(self.system(&self.place(row), None)?)
    }

    /// The cells of an answer between rows: that of a row with another value on the last axis, in the unit of the axis.
    ///
    /// # Errors
    /// As [`Grid::answer`].
    pub fn answer_at(&self, row: u64, last: f64) -> Result<Vec<Cell<'static>>, String> {
        self.answer_of(self.system(&self.place(row), Some(last))?)
    }

    /// The cells of a row's answer in numbers of another type, without records and without laws that are curves. `until` is the end of a
    /// motion.
    ///
    /// # Errors
    /// As [`Grid::answer`].
    #[cfg(feature = "mp")]
    pub(super) fn answer_in<F: Number>(
        &self,
        row: u64,
        until: Option<(&str, &str)>,
    ) -> Result<Vec<Cell<'static, F>>, String> {
        let of = self.without_record::<F>(&self.place(row), None)?;
        let until = until.map(|(name, text)| of.reader().value::<F>(name, text, Of::Time));
        let until = until.transpose().map_err(|e| e.to_string())?;
        self.answer_by(
            of,
            until,
            |of| of.system.steady(&of.described.start).map_err(Why::from),
            |of, until| of.system.simulate(&of.described.start, until).map_err(Why::from),
        )
    }

    fn answer_of(&self, of: NamedSystem) -> Result<Vec<Cell<'static>>, String> {
        let until = if let Asked::Transient(until) = self.asked { until } else { None };
        self.answer_by(
            of,
            until,
            |of| Ok(of.steady(&of.described.start)?.0),
            |of, until| Ok(of.simulate(&of.described.start, until)?.0),
        )
    }

    fn answer_by<F: Number>(
        &self,
        of: NamedSystem<F>,
        until: Option<F>,
        steady: impl Fn(&NamedSystem<F>) -> Result<Steady<F>, Why>,
        simulate: impl Fn(&NamedSystem<F>, F) -> Result<Motion<F>, Why>,
    ) -> Result<Vec<Cell<'static, F>>, String> {
        let of = of.while_allowed(self.keep_going);
        let because = |e: Why| e.to_string();
        let number = |x: F| Cell::Number(Some(x));
        Ok(match self.asked {
            Asked::Border => {
                let found = of.system.border().map_err(|e| e.to_string())?;
                let release = Cell::Number(found.least_load_factor_from_rest);
                vec![number(found.least_load_factor), number(found.touching_time), release]
            }
            Asked::Steady => {
                let found = steady(&of).map_err(because)?;
                let periods = Cell::Count(Some(found.periods as u64));
                let mut cells = vec![Cell::Text(found.kind.name()), periods];
                cells.extend(of_motion(&of.described, &found.motion, Some(&found)));
                cells
            }
            Asked::Transient(_) => {
                let until = until.unwrap_or_else(|| of.end_of_records());
                of.check_until(until, &format!("until {until}"))?;
                let found = simulate(&of, until).map_err(because)?;
                let mut cells = vec![number(found.duration)];
                cells.extend(of_motion(&of.described, &found, None));
                cells
            }
        })
    }
}

/// The names of the answers, with an empty cell of each.
fn columns(described: &Described, asked: Asked) -> Vec<(String, Cell<'static>)> {
    let unit =
        |kind: Of| described.units.map_or_else(String::new, |system| format!("[{}]", system.name(kind)));
    let time = if described.units.is_some() { "[s]" } else { "" };
    let number = |name: String| (name, Cell::Number(None));
    let mut columns = match asked {
        Asked::Border => {
            return vec![
                number("least_load_factor".to_owned()),
                number(format!("touching_time{time}")),
                number("least_load_factor_from_rest".to_owned()),
            ];
        }
        Asked::Steady => {
            vec![("kind".to_owned(), Cell::Text("")), ("periods".to_owned(), Cell::Count(None))]
        }
        Asked::Transient(_) => vec![number(format!("duration{time}"))],
    };
    for name in described.shown(&described.coordinates) {
        let quantities = [
            ("max_displacement", Of::Length),
            ("min_displacement", Of::Length),
            ("max_velocity", Of::Velocity),
            ("min_velocity", Of::Velocity),
            ("end_displacement", Of::Length),
        ];
        let count = if asked == Asked::Steady { 4 } else { 5 };
        let quantities = quantities.into_iter().take(count);
        columns.extend(quantities.map(|(what, kind)| number(format!("{name}.{what}{}", unit(kind)))));
    }
    for element in &described.model.elements {
        let name = &element.name;
        if kind_of(element) != "spring" {
            columns.push(number(format!("{name}.rest_fraction")));
            columns.push((format!("{name}.stops"), Cell::Count(None)));
        }
        if is_hard(element) {
            columns.push((format!("{name}.blows"), Cell::Count(None)));
        }
        columns.push(number(format!("{name}.work{}", unit(Of::Energy))));
    }
    if asked == Asked::Steady {
        for name in described.shown(&described.coordinates) {
            columns.push(number(format!("{name}.drift{}", unit(Of::Length))));
            columns.push(number(format!("{name}.mean_velocity{}", unit(Of::Velocity))));
        }
    }
    if described.base.is_some() {
        let unit = unit(Of::Acceleration);
        let names = described.shown(&described.coordinates);
        columns.extend(names.map(|name| number(format!("{name}.max_absolute_acceleration{unit}"))));
    }
    columns
}

/// The cells of a motion, in the order of the columns, with its end, or with the drift of a steady one.
fn of_motion<F: Number>(
    described: &Described<F>,
    motion: &Motion<F>,
    steady: Option<&Steady<F>>,
) -> Vec<Cell<'static, F>> {
    let mut cells = Vec::new();
    for i in described.places() {
        let lists =
            [&motion.max_displacement, &motion.min_displacement, &motion.max_velocity, &motion.min_velocity];
        let end = steady.is_none().then_some(&motion.end.displacement);
        cells.extend(lists.into_iter().chain(end).map(|list| Cell::Number(list.get(i).copied())));
    }
    for (given, element) in described.model.elements.iter().zip(&motion.elements) {
        if kind_of(given) != "spring" {
            cells.push(Cell::Number(Some(element.time_at_rest / motion.duration)));
            cells.push(Cell::Count(Some(element.stops as u64)));
        }
        if is_hard(given) {
            cells.push(Cell::Count(Some(element.blows as u64)));
        }
        cells.push(Cell::Number(Some(element.work)));
    }
    if let Some(steady) = steady {
        let pairs = described.shown(&steady.drift).zip(described.shown(&steady.mean_velocity));
        cells.extend(pairs.flat_map(|(&by, &speed)| [by, speed].map(|x| Cell::Number(Some(x)))));
    }
    cells.extend(described.shown(&motion.max_absolute_acceleration).map(|&most| Cell::Number(Some(most))));
    cells
}
