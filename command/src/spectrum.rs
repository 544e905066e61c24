//! `stickslip spectrum`: the answers under records over grids of bodies.

mod picture;

use crate::args::{SpectrumArgs, SweepFormat};
use crate::failure::{Failure, Outcome};
use crate::figure::Target;
use crate::grid::Axes;
use crate::input;
use crate::interrupt;
use crate::measured;
use crate::outputs::key;
use crate::physical::Physical;
use crate::progress::Unanswered;
use crate::row::{Cell, Cells, Row};
use crate::shaken::{Surface, needs_mass};
use crate::sweep::{self, Table};
use crate::under_record;
use std::io::Write;
use std::ops::Range;
use std::path::{Path, PathBuf};
use stickslip::Error;
use stickslip::motion::record::{Body, Record as Load, RecordAnswer, follow_each};
use stickslip_front::inputs::units::{Kind, System};
use stickslip_front::inputs::{Given, Input, Role};

/// The greatest number of bodies that are followed side by side.
const SIDE_BY_SIDE: u64 = 16;

pub(crate) fn run(args: &SpectrumArgs, out: &mut impl Write) -> Outcome {
    let format = if args.picture.is_some() { SweepFormat::Csv } else { args.table.format()? };
    let spectra = Spectra::new(args, format)?;
    args.look.needs("--picture", args.picture.as_deref())?;
    if args.picture.is_none() {
        return sweep::write_table(&args.table, format, &spectra, out);
    }
    let target = Target::new("--picture", args.picture.as_deref(), args.overwrite, &args.look)?;
    target.draw(out, || spectra.figure())
}

/// Answers, each with the place of its body in the grids; `None` for a body that has none.
type Answers = Vec<Result<(u64, Option<RecordAnswer<f64>>), Failure>>;

/// The name of a record in rows and pictures: that of its file, with the folder where another file has the same name.
fn name(file: &Path, files: &[PathBuf]) -> &'static str {
    let own = file.file_name();
    let is_only_one = files.iter().filter(|other| other.file_name() == own).count() == 1;
    let name = own.filter(|_| is_only_one).map_or(file, Path::new);
    // A cell of a row lives as long as the command.
    name.display().to_string().leak()
}

/// One row for each body under each record.
struct Spectra<'a> {
    loads: Vec<(&'static str, Load<f64>)>,
    axes: Axes<f64>,
    /// The inputs of a row with their names as columns.
    inputs: Vec<(Input, &'static str)>,
    surface: Surface<f64>,
    system: System,
    /// The unit of natural frequencies as typed, and its value in rad/s; `None` where names have no units.
    frequency: Option<(&'static str, f64)>,
    has_mass: bool,
    form: Row,
    /// The answers of a body that has none.
    blank: under_record::Columns<f64>,
    /// The number of bodies without an answer so far.
    failed: Unanswered,
    args: &'a SpectrumArgs,
}

impl<'a> Spectra<'a> {
    fn new(args: &'a SpectrumArgs, format: SweepFormat) -> Result<Self, Failure> {
        let reader = args.units.reader();
        let axes = Axes::<f64>::new(&args.machine, &reader)?;
        let mut loads: Vec<(&'static str, Load<f64>)> = Vec::new();
        for (place, file) in args.files.iter().enumerate() {
            if args.files.iter().take(place).any(|earlier| earlier == file) {
                return Err(format!("{}: must be given only once", file.display()).into());
            }
            loads.push((name(file, &args.files), measured::read(file, &args.load, &reader)?.0));
        }
        let inputs = Input::ALL.into_iter().filter(|input| axes.has(*input));
        let inputs = inputs.map(|input| (input, &*input.column().leak())).collect();
        let (surface, system) = (Surface::read(&args.surface, &reader)?, reader.system());
        let has_mass = Input::of_role(Role::Mass).into_iter().any(|input| axes.has(input));
        let form = Cells::of(Vec::new());
        let rest = Load::new(stickslip::Excitation::Force, 1.0, vec![0.0; 2])?;
        let answer = Body::new(1.0, 1.0).and_then(|body| body.follow(&rest))?;
        let blank =
            under_record::columns(&answer, system).map(|(name, kind, cell)| (name, kind, cell.absent()));
        let failed = Unanswered::new("bodies", 20);
        let frequency = input::frequency_unit(args.machine.text(Input::NaturalFrequency));
        let frequency = frequency.map(|(unit, factor)| (&*unit.leak(), factor));
        let frequency = frequency.filter(|_| format != SweepFormat::Jsonl);
        let mut spectra =
            Self { loads, axes, inputs, surface, system, frequency, has_mass, form, blank, failed, args };
        // A single bad body is a row without answers; where each is bad, an argument is.
        let (mut first_bad, mut is_any_good) = (None, false);
        spectra.axes.at_ends(|given| {
            match spectra.body(given.clone()) {
                Ok(_) => is_any_good = true,
                Err(failure) => first_bad = first_bad.take().or(Some(failure)),
            }
            Ok(())
        })?;
        if let Some(failure) = first_bad.filter(|_| !is_any_good) {
            return Err(failure);
        }
        let first = spectra.loads.first().map_or("", |(name, _)| name);
        spectra.form = spectra.row(first, &spectra.axes.given_at(0), Some(&Some(answer)));
        Ok(spectra)
    }

    fn body(&self, mut given: Given<f64>) -> Result<Body<f64>, Failure> {
        if !self.has_mass {
            given.set(Input::Mass, 1.0);
        }
        self.surface.body(&given)
    }

    /// The value of an input in the unit of its column or axis.
    fn shown(&self, input: Input, value: f64) -> f64 {
        match (input.kind(), self.frequency) {
            (Kind::Frequency, Some((_, factor))) => value / factor,
            (kind, _) => self.system.shown(kind, value),
        }
    }

    /// A row: the record, the inputs, and the answers, empty for a body that has none.
    fn row(&self, name: &'static str, given: &Given<f64>, answer: Option<&Option<RecordAnswer<f64>>>) -> Row {
        let value = |input: Input| Cell::Number(given.get(input).map(|value| self.shown(input, value)));
        let mut values: Vec<_> =
            self.inputs.iter().map(|&(input, column)| (column, input.kind(), value(input))).collect();
        let answers = answer.map(|answer| {
            answer.as_ref().map_or(self.blank, |answer| under_record::columns(answer, self.system))
        });
        let answers = answers.into_iter().flatten();
        // Forces, works and stiffnesses are those of a mass.
        values.extend(answers.filter(|(_, kind, _)| self.has_mass || !needs_mass(*kind)));
        let cells = vec![(key!("record"), Cell::Text(name))];
        let physical = Physical::beside(self.system, values);
        let physical = physical.with_frequencies_in(self.frequency.map(|(unit, _)| unit));
        Cells::of(cells).with_physical(physical).shown()
    }

    /// The record of a row, its name, and the place of its body.
    fn place(&self, point: u64) -> Result<(&'static str, &Load<f64>, u64), Failure> {
        let bodies = self.axes.len();
        let load = usize::try_from(point / bodies).ok().and_then(|load| self.loads.get(load));
        let (name, load) = load.ok_or(Failure::Interrupted)?;
        Ok((name, load, point % bodies))
    }

    /// The answers of the first rows of a range, which share a record.
    fn answers(&self, points: Range<u64>) -> Answers {
        self.followed(points).unwrap_or_else(|failure| vec![Err(failure)])
    }

    fn followed(&self, points: Range<u64>) -> Result<Answers, Failure> {
        interrupt::check()?;
        let (name, load, first) = self.place(points.start)?;
        let count = SIDE_BY_SIDE.min(points.end - points.start).min(self.axes.len() - first);
        let bodies: Vec<_> = (first..first + count).map(|body| self.body(self.axes.given_at(body))).collect();
        let good: Vec<_> = bodies.iter().flatten().copied().collect();
        let mut answers = follow_each(&good, load).into_iter();
        let answer = |(place, body): (u64, Result<Body<f64>, Failure>)| {
            let given = || self.axes.named_at(place);
            let found = match body.map(|_| answers.next()) {
                // The body again, with its values in the message.
                Err(failure) => Err(self.body(given()).err().unwrap_or(failure)),
                Ok(None | Some(Err(Error::Interrupted))) => return Err(Failure::Interrupted),
                Ok(Some(Err(error))) => {
                    Err(Failure::Input(format!("{} {name}: {error}", given().all_typed())))
                }
                Ok(Some(Ok(answer))) => Ok(answer),
            };
            found.map(|answer| (place, Some(answer))).or_else(|failure| {
                self.failed.say("", &failure);
                Ok((place, None))
            })
        };
        Ok((first..).zip(bodies).map(answer).collect())
    }
}

impl Table for Spectra<'_> {
    fn of(&self) -> &'static str {
        "these spectra"
    }

    fn len(&self) -> u64 {
        self.axes.len().saturating_mul(self.loads.len() as u64)
    }

    fn form(&self) -> &Row {
        &self.form
    }

    fn rows(&self, points: Range<u64>) -> Vec<Result<Row, Failure>> {
        let name = self.place(points.start).map_or("", |(name, ..)| name);
        let row = |(body, answer)| self.row(name, &self.axes.given_at(body), Some(&answer));
        self.answers(points).into_iter().map(|found| found.map(row)).collect()
    }

    /// A row begins with the name of its record and with its inputs.
    fn hold_their_grid(&self) -> bool {
        true
    }

    fn is_on_grid(&self, line: &[u8], point: u64, is_csv: bool) -> Result<bool, Failure> {
        let (name, _, body) = self.place(point)?;
        let due = self.row(name, &self.axes.given_at(body), None).line(is_csv)?;
        let due = due.trim_ascii_end();
        let due = due.strip_suffix(b"}").unwrap_or(due);
        Ok(line.strip_prefix(due).is_some_and(|rest| rest.first() == Some(&b',')))
    }

    #[cfg(feature = "parquet")]
    fn notes(&self) -> Vec<(String, String)> {
        let args = self.args;
        let names = self.loads.iter().map(|(name, _)| *name).collect::<Vec<_>>().join(",");
        let others = [
            ("records", Some(names)),
            ("one_way", args.surface.one_way.then(String::new)),
            ("slope", args.surface.slope.clone()),
            ("time_step", args.load.time_step.clone()),
            ("time_column", args.load.time_column.clone()),
            ("column", args.load.column.clone()),
            ("skip", (args.load.skip > 0).then(|| args.load.skip.to_string())),
            ("record_units", args.load.record_units.clone()),
            ("scale", args.load.scale.clone()),
            ("from", args.load.from.clone()),
            ("to", args.load.to.clone()),
            ("remove_mean", args.load.remove_mean.clone()),
            ("resample", args.load.resample.clone()),
            (
                "after",
                args.load.after.map(|after| stickslip::motion::record::After::from(after).name().to_owned()),
            ),
            ("shard", args.table.shard.clone()),
            ("system", args.units.units.map(|system| system.to_string())),
        ];
        sweep::notes(&args.machine, others)
    }
}
