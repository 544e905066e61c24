//! A row of answers: one list of names and values, written as JSON or CSV.

mod cell;

use crate::args::Header;
use crate::bits::Value;
use crate::failure::{Failure, Outcome};
use crate::input::behind_all;
use crate::outputs::{ALPHA, DAMPING_RATIO, Key, OMEGA, STATIC_FRICTION_RATIO, plain};
use crate::physical::Physical;
use serde::ser::{Serialize, SerializeMap, Serializer};
use std::io::{self, Write};
use stickslip::internal::{Column, When};
use stickslip::{Measure, NoStop, Output, Ratios, Response};
use stickslip_front::inputs::{Driven, Given, Point, Role};
use stickslip_front::without::{is_of_friction, is_of_spring, needs_spring, without_friction};

pub(crate) use cell::{Cell, Number};

/// The text of some rows of CSV.
pub(crate) fn csv_text(
    fill: impl FnOnce(&mut csv::Writer<&mut Vec<u8>>) -> Outcome,
) -> Result<Vec<u8>, Failure> {
    let mut text = Vec::new();
    {
        let mut writer = csv::WriterBuilder::new().buffer_capacity(1 << 10).from_writer(&mut text);
        fill(&mut writer)?;
        writer.flush()?;
    }
    Ok(text)
}

/// The name of an output in the machine's units.
fn physical_name(wanted: &str) -> &str {
    wanted.strip_prefix("physical.").unwrap_or(wanted)
}

/// Named values in order, and those in physical units: of a number type while they are computed, as a [`Row`] where they are
/// written.
#[derive(Debug)]
pub(crate) struct Cells<F> {
    pub(crate) fields: Vec<(Key, Cell<F>)>,
    pub(crate) physical: Physical<F>,
    /// In a [`Row`], whether its numbers are wider than a double, even those that do not exist.
    is_wide: bool,
}

/// A row as it is written.
pub(crate) type Row = Cells<Number>;

impl Serialize for Row {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for (key, cell) in &self.fields {
            map.serialize_entry(key.name, cell)?;
        }
        let beside = self.physical.values_beside();
        for (name, _, cell) in beside {
            map.serialize_entry(name, cell)?;
        }
        if beside.is_empty() && !self.physical.is_empty() {
            map.serialize_entry("physical", &self.physical)?;
        }
        map.end()
    }
}

impl<F> Cells<F> {
    /// A row without physical units.
    pub(crate) fn of(fields: Vec<(Key, Cell<F>)>) -> Self {
        Self { fields, physical: Physical::default(), is_wide: false }
    }

    /// The row with these values in physical units.
    pub(crate) fn with_physical(self, physical: Physical<F>) -> Self {
        Self { physical, ..self }
    }
}

impl<F: Value> Cells<F> {
    /// The row as it is written.
    pub(crate) fn shown(self) -> Row {
        let fields = self.fields.into_iter().map(|(key, cell)| (key, cell.shown()));
        let is_wide = F::PRECISION > f64::MANTISSA_DIGITS;
        Cells { fields: fields.collect(), physical: self.physical.shown(), is_wide }
    }

    /// Ω, α if `has_alpha`, and ζ and η where they were given.
    pub(crate) fn of_ratios(given: &Given<F>, ratios: &Ratios<F>, has_alpha: bool) -> Self {
        let others = [
            (has_alpha, ALPHA, Some(ratios.alpha()).filter(|_| !given.is_without_friction())),
            (given.has_role(Role::Damper), DAMPING_RATIO, Some(ratios.damping_ratio())),
            (
                given.has_role(Role::StaticFriction),
                STATIC_FRICTION_RATIO,
                Some(ratios.static_friction_ratio()),
            ),
        ];
        let mut fields = vec![(OMEGA, Cell::Number(Some(ratios.omega())))];
        let others = others.into_iter().filter(|(is_there, ..)| *is_there);
        fields.extend(others.map(|(_, key, ratio)| (key, Cell::Number(ratio))));
        Self::of(fields)
    }

    /// The ratios and the columns of an answer.
    pub(crate) fn of_answer<A>(
        given: &Given<F>,
        ratios: &Ratios<F>,
        answer: &A,
        columns: impl IntoIterator<Item = Column<A, F>>,
    ) -> Self {
        let mut row = Self::of_ratios(given, ratios, true);
        let columns = columns.into_iter().filter(|column| match column.when {
            When::Always => true,
            When::Damping => given.has_role(Role::Damper),
            When::StaticFriction => given.has_role(Role::StaticFriction),
        });
        row.fields.extend(columns.map(|column| (column.definition, (column.of)(answer).into())));
        row
    }

    /// The border at Ω and the best force ratio, from a response at any α.
    pub(crate) fn of_border(given: &Given<F>, response: &Response<F>) -> Self {
        let mut row = Self::of_ratios(given, &response.ratios, false);
        let outputs = [
            Output::MinForceRatio,
            Output::MinForceRatioTurningPoint,
            Output::BorderPhase,
            Output::LeastDisplacement,
            Output::BestForceRatio,
        ];
        row.fields.extend(outputs.map(|output| (output.definition(), Cell::Number(output.of(response)))));
        row
    }

    /// The intervals as a value.
    pub(crate) fn intervals(no_stop: &NoStop<F>) -> Cell<F> {
        let mut intervals = no_stop.intervals();
        Cell::Intervals([intervals.next(), intervals.next()])
    }

    /// The row with the answer in the units of the machine, if there is one, behind its own quantities; both loop
    /// sizes are the energy of a cycle.
    pub(crate) fn in_units(
        mut self,
        given: &Given<F>,
        point: &Point<F>,
        physical: fn(&Given<F>, &Driven<F>) -> Physical<F>,
    ) -> Result<Row, Failure> {
        let Some(machine) = &point.machine else { return Ok(self.shown()) };
        let best = self.fields.iter().find(|(key, _)| *key == Output::BestForceRatio.definition());
        let best = match best {
            Some((_, Cell::Number(Some(ratio)))) => *ratio,
            _ => F::int(0),
        };
        let stiffness = machine.oscillator.stiffness();
        let size = |measure| Measure::size_with(measure, &machine.scales, best, stiffness);
        let has_friction = !given.is_without_friction();
        for (key, cell) in self.fields.iter_mut().filter(|_| !has_friction) {
            if let Cell::Number(Some(x)) = cell {
                *x = without_friction(key.measure, *x);
            }
        }
        let has_spring = !given.is_without_spring();
        for (_, cell) in self.fields.iter_mut().filter(|(key, _)| !has_spring && needs_spring(key)) {
            *cell = Cell::Number(None);
        }
        self.physical = physical(given, machine).with(&self.fields, machine.drive.excitation(), size);
        let row = self.shown().in_units_of(has_friction, has_spring);
        row.finite().map_err(|e| behind_all(given, e))
    }
}

/// Whether a column is a displacement or a velocity of `simulate`, in ratios.
fn is_state(key: Key) -> bool {
    matches!(key.name, "x" | "v" | "end_x" | "end_v")
}

impl Row {
    /// A row of numbers that are wider than a double, or not.
    pub(crate) fn of_numbers(fields: Vec<(Key, Cell<Number>)>, is_wide: bool) -> Self {
        Self { fields, physical: Physical::default(), is_wide }
    }

    /// The row without the values in units of a friction or of a spring that is not there.
    pub(crate) fn in_units_of(mut self, has_friction: bool, has_spring: bool) -> Self {
        let is_without = |key: Key| {
            let of_ratio = [OMEGA, DAMPING_RATIO].contains(&key);
            !has_friction && (is_of_friction(key.measure) || is_state(key))
                || !has_spring && (of_ratio || is_of_spring(key.measure) || is_state(key))
        };
        for (_, cell) in self.fields.iter_mut().filter(|(key, _)| is_without(key)) {
            *cell = cell.blank();
        }
        self
    }

    /// Whether the row has an output of this name: a field, or in the machine's units `physical.NAME`,
    /// `NAME[unit]`, or NAME where no field has that name.
    pub(crate) fn has(&self, wanted: &str) -> bool {
        self.fields.iter().any(|(key, _)| key.name == wanted) || self.physical.has(physical_name(wanted))
    }

    /// The names of all outputs.
    pub(crate) fn output_names(&self) -> Vec<String> {
        let own = self.fields.iter().map(|(key, _)| key.name.to_owned());
        own.chain(self.physical.values.iter().map(|(name, ..)| format!("physical.{name}"))).collect()
    }

    /// The row with these outputs only, in this order, with those in the machine's units last.
    pub(crate) fn only(mut self, wanted: &[String]) -> Self {
        let field = |wanted: &String| self.fields.iter().find(|(key, _)| key.name == wanted).cloned();
        let fields: Vec<_> = wanted.iter().filter_map(field).collect();
        let is_field = |wanted: &String| fields.iter().any(|(key, _)| key.name == wanted);
        let physical = wanted.iter().filter(|w| !is_field(w)).map(|w| physical_name(w));
        self.physical = self.physical.only(physical);
        self.fields = fields;
        self
    }

    /// The row of a point that has no answer: its ratios alone, if they are known.
    pub(crate) fn blank(&self, ratios: Option<&Self>) -> Self {
        let known = |key: Key| ratios?.fields.iter().find(|(own, _)| own.name == key.name);
        let fields = self
            .fields
            .iter()
            .map(|(key, cell)| (*key, known(*key).map_or_else(|| cell.blank(), |(_, cell)| cell.clone())));
        Self { fields: fields.collect(), physical: self.physical.blank(), is_wide: self.is_wide }
    }

    /// The row, if all its numbers are finite. In units that are too small a motion overflows to infinity,
    /// which JSON does not have.
    pub(crate) fn finite(self) -> Result<Self, Failure> {
        let physical = self.physical.values.iter().map(|(name, _, cell)| (*name, cell));
        self.fields
            .iter()
            .map(|(key, cell)| (key.name, cell))
            .chain(physical)
            .try_for_each(|(name, cell)| cell.finite(name))?;
        Ok(self)
    }

    /// Whether the numbers have more digits than a double, even those that do not exist.
    #[cfg_attr(
        not(feature = "parquet"),
        allow(dead_code, reason = "only the columns of Parquet have a type")
    )]
    pub(crate) const fn is_wide(&self) -> bool {
        self.is_wide
    }

    /// One line of JSON.
    pub(crate) fn write_line(&self, out: &mut impl Write) -> Outcome {
        serde_json::to_writer(&mut *out, self)?;
        Ok(out.write_all(b"\n")?)
    }

    /// The row as text, of CSV or of JSON lines.
    pub(crate) fn line(&self, is_csv: bool) -> Result<Vec<u8>, Failure> {
        if is_csv {
            return csv_text(|writer| self.write_row(writer));
        }
        let mut text = Vec::new();
        self.write_line(&mut text)?;
        Ok(text)
    }

    /// One row of CSV, with an empty cell for a missing value. Each number has the digits that identify it.
    pub(crate) fn write_row(&self, out: &mut csv::Writer<impl Write>) -> Outcome {
        Ok(out.serialize(self.cells().collect::<Vec<_>>())?)
    }

    /// The header of the rows.
    pub(crate) fn write_header(&self, out: &mut csv::Writer<impl Write>, header: Header) -> Outcome {
        Ok(out.write_record(self.names(header))?)
    }

    /// The cells of a row, each with one value, those in physical units last.
    pub(crate) fn cells(&self) -> impl Iterator<Item = Cell<Number>> + '_ {
        let physical = self.physical.values.iter().map(|(_, _, cell)| cell);
        let cells = self.fields.iter().map(|(_, cell)| cell).chain(physical);
        cells.flat_map(|cell| cell.clone().parts()).flatten()
    }

    /// The names of the cells of a row, with units if they are asked for in brackets after each dimensionless name that
    /// has one.
    pub(crate) fn names(&self, header: Header) -> Vec<String> {
        let own = self.fields.iter().flat_map(|(key, cell)| {
            let unit = plain(if header == Header::Units { key.measure.unit() } else { "" });
            let unit = if unit.is_empty() { unit } else { format!("[{unit}]") };
            cell.part_names(key.name).into_iter().map(move |name| name + &unit)
        });
        own.chain(self.physical.names()).collect()
    }

    /// One row of a table for reading, with seven digits and columns of equal width.
    pub(crate) fn write_table_row(&self, out: &mut impl Write) -> io::Result<()> {
        let beside = self.physical.values_beside().iter().map(|(_, _, cell)| cell);
        for (i, cell) in self.fields.iter().map(|(_, cell)| cell).chain(beside).enumerate() {
            let text = cell.text();
            let gap = if i == 0 { "" } else { "  " };
            write!(out, "{gap}{text:>COLUMN$}")?;
        }
        writeln!(out)
    }

    /// The header of a table for reading.
    pub(crate) fn write_table_header(&self, out: &mut impl Write) -> io::Result<()> {
        let own = self.fields.iter().map(|(key, _)| key.name.to_owned());
        let beside = self.physical.names().take(self.physical.values_beside().len());
        let names: Vec<String> = own.chain(beside).map(|name| format!("{name:>COLUMN$}")).collect();
        writeln!(out, "{}", names.join("  "))
    }
}

/// The width of a column in a table for reading.
const COLUMN: usize = 14;
