//! A row for each place of a grid: of values in the file, of the loads' frequency, and of records.

use super::options::{folder, note_of_units, path_and_value};
use super::picture;
use crate::args::{Format, SweepFormat, SystemArgs, SystemQuestion};
use crate::failure::{Failure, Outcome};
use crate::figure::Target;
use crate::interrupt;
use crate::output;
use crate::progress::Unanswered;
use crate::row::{Cell, Cells, Number, Row};
use crate::sweep::{Table, write_table};
use serde_json::Value as Json;
use std::io::Write;
use std::ops::Range;
use stickslip::motion::record::Record as Load;
use stickslip::{Definition, Measure};
use stickslip_front::inputs::units::{Kind as Of, Reader};
use stickslip_front::system::{Asked, Axis, Cell as Found, Grid, units_of};
use stickslip_front::text::printable;

/// The cells of the answer of a row, with the end of a motion as it is typed.
pub(super) type Answered = fn(&Grid<'static>, u64, Option<&str>) -> Result<Vec<Cell<Number>>, Failure>;

/// The rows of a grid.
struct Rows {
    grid: &'static Grid<'static>,
    /// The answers of rows in wider numbers than doubles.
    wide: Option<Answered>,
    until: Option<String>,
    keys: Vec<&'static Definition>,
    /// The names and the kinds of all rows.
    form: Row,
    failed: Unanswered,
    #[cfg(feature = "parquet")]
    notes: Vec<(String, String)>,
}

/// Keeps a value until the command ends: rows hold texts of the grid.
fn kept<T>(value: T) -> &'static T {
    Box::leak(Box::new(value))
}

/// A name that all rows share.
pub(super) fn key(name: String) -> &'static Definition {
    kept(Definition::new(name.leak(), Measure::Plain, ""))
}

/// The grid of the arguments.
fn grid(value: &Json, args: &SystemArgs) -> Result<Grid<'static>, Failure> {
    let about = |e: String| Failure::Input(format!("{}: {e}", args.file.display()));
    let units = args.units.units.or(units_of(value)?);
    let reader = Reader::new(units.as_ref(), "units in the file");
    let records = args.records.iter().map(|file| {
        let (record, _) = crate::measured::read::<f64>(file, &Default::default(), &reader)?;
        if value.get("masses").is_none() {
            note_of_units(units.as_ref(), &file.display().to_string());
        }
        Ok((printable(&file.display().to_string()).into_owned(), record))
    });
    let records = records.collect::<Result<Vec<(String, Load<f64>)>, Failure>>()?;
    let axes = args.set.iter().map(|text| {
        let (path, values) = path_and_value(text)?;
        Axis::of(path.trim(), values.trim()).map_err(|e| Failure::Input(format!("--set {e}")))
    });
    let mut axes = axes.collect::<Result<Vec<_>, Failure>>()?;
    if let Some(text) = &args.frequency {
        axes.push(Axis::of_frequency("--frequency", text)?);
    }
    let asked = match args.question {
        SystemQuestion::Curve | SystemQuestion::Steady => Asked::Steady,
        SystemQuestion::Border => Asked::Border,
        SystemQuestion::Simulate | SystemQuestion::Record | SystemQuestion::Spectrum => {
            let until = args.until.as_ref().map(|text| reader.value::<f64>("--until", text, Of::Time));
            Asked::Transient(until.transpose()?)
        }
        SystemQuestion::Describe => {
            return Err("--set: a grid belongs to steady, simulate, record, curve and border".into());
        }
    };
    let units = args.units.units.map(kept);
    let grid =
        Grid::new(kept(value.clone()), kept(folder(args).to_owned()), units, axes, kept(records), asked)
            .map_err(about)?
            .while_allowed(interrupt::keep_going);
    Ok(match &args.coordinates {
        Some(names) => grid.showing("--coordinates", names)?,
        None => grid,
    })
}

pub(super) fn run(value: &Json, args: &SystemArgs, wide: Option<Answered>, out: &mut impl Write) -> Outcome {
    let rows = Rows::new(value, args, wide)?;
    if let Some(file) = &args.picture {
        let target = Target::new("--picture", Some(file), args.overwrite, &args.look)?;
        let first = rows.grid.described()?;
        let title = picture::heading(&first, "Peak displacement");
        target.draw(out, || picture::curve(rows.grid, &first, &title))?;
        if args.out.is_none() {
            return Ok(());
        }
    }
    let resolved = if args.resolve { Some(ResolvedRows::new(&rows, args)?) } else { None };
    let table: &dyn Table = resolved.as_ref().map_or(&rows, |rows| rows);
    let format = match args.format {
        None if args.out.is_some() => args.table().format()?,
        None | Some(Format::Csv) => SweepFormat::Csv,
        Some(Format::Jsonl) => SweepFormat::Jsonl,
        Some(Format::Json) if args.out.is_none() => {
            let found = (0..table.len()).map(|i| table.row(i)).collect::<Result<Vec<_>, _>>()?;
            return output::json(&found, out);
        }
        Some(Format::Json) => return Err("--format json: with --out choose csv, jsonl or parquet".into()),
        Some(Format::Text) => return Err("--format text: a table is csv, json or jsonl".into()),
    };
    write_table(&args.table(), format, table, out)
}

impl Rows {
    fn new(value: &Json, args: &SystemArgs, wide: Option<Answered>) -> Result<Self, Failure> {
        let grid = kept(grid(value, args)?);
        let mut rows = Self {
            grid,
            wide,
            until: args.until.clone(),
            keys: grid.names().iter().cloned().map(key).collect(),
            form: Cells::of(Vec::<(_, Cell<f64>)>::new()).shown(),
            failed: Unanswered::new("rows", 5),
            #[cfg(feature = "parquet")]
            notes: vec![
                ("file".to_owned(), value.to_string()),
                ("question".to_owned(), format!("{:?}", args.question)),
                ("names".to_owned(), grid.names().join(",")),
                ("grid".to_owned(), format!("{:?} {:?} {:?}", args.set, args.frequency, args.records)),
                ("coordinates".to_owned(), args.coordinates.clone().unwrap_or_default()),
                ("until".to_owned(), args.until.clone().unwrap_or_default()),
                ("bits".to_owned(), args.bits.map_or_else(String::new, |bits| bits.to_string())),
                ("shard".to_owned(), args.shard.clone().unwrap_or_default()),
            ],
        };
        rows.form = rows.row(0, rows.blank());
        Ok(rows)
    }

    fn row(&self, point: u64, answer: Vec<Cell<Number>>) -> Row {
        let given = self.grid.given(point).into_iter();
        let cells = given.map(|found| self.given(found)).chain(answer);
        Row::of_numbers(self.keys.iter().copied().zip(cells).collect(), self.wide.is_some())
    }

    /// A value on an axis: a text of its digits, as the answers are, beside wider numbers.
    fn given(&self, found: Found<'static>) -> Cell<Number> {
        let shown = cell(&found).shown();
        if let (Cell::Number(Some(number)), true) = (&shown, self.wide.is_some()) {
            return Cell::Number(Some(number.clone().into_text()));
        }
        shown
    }

    /// The cells of a row without an answer.
    fn blank(&self) -> Vec<Cell<Number>> {
        self.grid.blank().iter().map(|found| cell(found).shown()).collect()
    }

    fn answer(&self, point: u64) -> Result<Vec<Cell<Number>>, Failure> {
        match self.wide {
            Some(answered) => answered(self.grid, point, self.until.as_deref()),
            None => Ok(self.grid.answer(point)?.iter().map(|found| cell(found).shown()).collect()),
        }
    }
}

pub(super) const fn cell<F: Copy>(found: &Found<'static, F>) -> Cell<F> {
    match *found {
        Found::Text(text) => Cell::Text(text),
        Found::Number(number) => Cell::Number(number),
        Found::Count(count) => Cell::Count(count),
    }
}

/// The rows of a grid of one axis, with those beside its peaks.
struct ResolvedRows<'a> {
    of: &'a Rows,
    found: picture::Resolved,
    source: &'static Definition,
    form: Row,
}

impl<'a> ResolvedRows<'a> {
    fn new(of: &'a Rows, args: &SystemArgs) -> Result<Self, Failure> {
        if !matches!(args.question, SystemQuestion::Curve | SystemQuestion::Steady) {
            return Err("--resolve: belongs to curve and steady".into());
        }
        let described = of.grid.described()?;
        let found = picture::resolved(of.grid, &described, "--resolve")?;
        let form = Cells::of(Vec::<(_, Cell<f64>)>::new()).shown();
        let mut rows = Self { of, found, source: key("source".to_owned()), form };
        rows.form = rows.row(f64::NAN, of.grid.blank());
        Ok(rows)
    }

    fn row(&self, x: f64, answer: &[Found<'static>]) -> Row {
        let Self { of, found, source, .. } = self;
        let mut given = of.grid.given(0);
        if let Some(place) = given.get_mut(found.axis) {
            *place = Found::Number(Some(x));
        }
        let cells = given.iter().map(cell).chain(answer.iter().map(cell));
        let mut cells: Vec<(_, Cell<f64>)> = of.keys.iter().copied().zip(cells).collect();
        cells.push((source, Cell::Text(if found.given.contains(&x) { "grid" } else { "added" })));
        Cells::of(cells).shown()
    }
}

impl Table for ResolvedRows<'_> {
    fn of(&self) -> &'static str {
        "this grid with its peaks"
    }

    fn len(&self) -> u64 {
        self.found.places.len() as u64
    }

    fn form(&self) -> &Row {
        &self.form
    }

    fn rows(&self, points: Range<u64>) -> Vec<Result<Row, Failure>> {
        let place = usize::try_from(points.start).ok().and_then(|place| self.found.places.get(place));
        vec![place.map(|(x, answer)| self.row(*x, answer)).ok_or(Failure::Interrupted)]
    }

    fn hold_their_grid(&self) -> bool {
        true
    }

    /// It is not continued.
    fn is_on_grid(&self, _: &[u8], _: u64, _: bool) -> Result<bool, Failure> {
        Ok(false)
    }

    #[cfg(feature = "parquet")]
    fn notes(&self) -> Vec<(String, String)> {
        self.of.notes.clone()
    }
}

impl Table for Rows {
    fn of(&self) -> &'static str {
        "this grid"
    }

    fn len(&self) -> u64 {
        self.grid.len()
    }

    fn form(&self) -> &Row {
        &self.form
    }

    fn rows(&self, points: Range<u64>) -> Vec<Result<Row, Failure>> {
        let point = points.start;
        if interrupt::asked() {
            return vec![Err(Failure::Interrupted)];
        }
        let row = match self.answer(point) {
            Ok(answer) => self.row(point, answer),
            Err(_) if interrupt::asked() => return vec![Err(Failure::Interrupted)],
            Err(why) => {
                self.failed.say(&format!(" in row {}", point + 1), &why);
                self.row(point, self.blank())
            }
        };
        vec![Ok(row)]
    }

    /// A row begins with its place on the axes.
    fn hold_their_grid(&self) -> bool {
        true
    }

    fn is_on_grid(&self, line: &[u8], point: u64, is_csv: bool) -> Result<bool, Failure> {
        let due = self.row(point, Vec::new()).line(is_csv)?;
        let due = due.trim_ascii_end();
        let due = due.strip_suffix(b"}").unwrap_or(due);
        Ok(line.strip_prefix(due).is_some_and(|rest| rest.first() == Some(&b',')))
    }

    #[cfg(feature = "parquet")]
    fn notes(&self) -> Vec<(String, String)> {
        self.notes.clone()
    }
}
