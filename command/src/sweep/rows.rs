//! The rows of a sweep, each computed from its number alone.

use super::Table;
use super::loops::Looped;
use crate::args::{Header, SweepArgs, SweepFormat, Swept};
use crate::axes::Axes;
use crate::bits::Value;
use crate::failure::{Failure, Outcome};
use crate::interrupt;
use crate::outputs::{self, ALPHA, Key, OMEGA};
use crate::record::{Cell, Record, csv_text};
use crate::resume;
use crate::{border, input, response, steady};
use std::ops::Range;
use stickslip::inputs::{Given, Input, Role};
use stickslip::motion::{DEFAULT_BUDGET, State, Trajectory};

/// The command at each point of the grids, and the format of its row.
pub(crate) struct SweepRows<F> {
    question: Swept,
    axes: Axes<F>,
    outputs: Option<Vec<String>>,
    /// A row without its motion, for the names of its values.
    form: Record<F>,
    columns: Vec<String>,
    csv: bool,
    header: Header,
    /// Whether the requested outputs need the search for peaks.
    peaks: bool,
    /// The rows in loops over many points, where they have no other columns.
    looped: Option<Looped>,
    #[cfg(feature = "parquet")]
    notes: Vec<(String, String)>,
}

/// What identifies a sweep in a Parquet file.
#[cfg(feature = "parquet")]
fn notes(args: &SweepArgs) -> Vec<(String, String)> {
    let question =
        clap::ValueEnum::to_possible_value(&args.question).map(|value| value.get_name().to_owned());
    let grids = args.machine.iter().map(|(input, text)| (input.column(), text.clone()));
    let notes = [
        ("system", args.units.units.map(|system| system.to_string())),
        ("sweep", question),
        ("outputs", args.outputs.as_ref().map(|names| names.join(","))),
        ("shard", args.table.shard.clone()),
        ("bits", args.bits.map(|bits| bits.to_string())),
    ];
    grids.chain(notes.into_iter().filter_map(|(key, value)| Some((key.to_owned(), value?)))).collect()
}

impl<F: Value> SweepRows<F> {
    /// The requested rows, if every point has an answer and every column exists.
    pub(crate) fn new(args: &SweepArgs, format: SweepFormat, axes: Axes<F>) -> Result<Self, Failure> {
        let csv = format == SweepFormat::Csv;
        let outputs = args.outputs.clone();
        let peaks = outputs.as_ref().is_none_or(|names| names.iter().any(|name| outputs::is_searched(name)));
        let (question, header) = (args.question, args.table.header);
        check(question, &axes)?;
        let form = form(question, &axes.named_at(0), peaks)?;
        for (place, wanted) in outputs.iter().flatten().enumerate() {
            if outputs.iter().flatten().take(place).any(|earlier| earlier == wanted) {
                return Err(Failure::Input(format!("--outputs {wanted}: must be named only once")));
            }
            if !form.has(wanted) {
                return Err(Failure::Input(format!(
                    "--outputs {wanted}: unknown column. Choose from {}",
                    form.output_names().join(", ")
                )));
            }
        }
        let form = match &outputs {
            Some(outputs) => form.only(outputs),
            None => form,
        };
        let columns = form.names();
        let is_looped = question == Swept::Response && args.bits.is_none() && !axes.is_physical();
        let looped = is_looped.then(|| Looped::of(form.fields.iter().map(|(key, _)| *key))).flatten();
        #[cfg(feature = "parquet")]
        let notes = notes(args);
        Ok(Self {
            #[cfg(feature = "parquet")]
            notes,
            question,
            axes,
            outputs,
            form,
            columns,
            csv,
            header,
            peaks,
            looped,
        })
    }

    fn ratios(&self, point: u64) -> Result<(F, F), Failure> {
        let given = self.axes.given_at(point);
        let ratios = match self.question {
            Swept::Border => input::border_point(&given)?.ratios,
            Swept::Response | Swept::Steady => input::point(&given)?.ratios,
        };
        Ok((ratios.omega(), ratios.alpha()))
    }

    /// The requested columns, in the given order.
    pub(crate) fn record(&self, point: u64) -> Result<Record<F>, Failure> {
        let record = self.full_record(point)?;
        Ok(match &self.outputs {
            Some(outputs) => record.only(outputs),
            None => record,
        })
    }

    /// The rows of the first points of a range, at least one.
    fn first_records(&self, points: Range<u64>) -> Vec<Result<Record<F>, Failure>> {
        let alone = |point| vec![self.record(point)];
        let Some(looped) = &self.looped else { return alone(points.start) };
        if interrupt::asked() {
            return alone(points.start);
        }
        let first = points.start;
        let ratios: Vec<_> = points.map(|point| Looped::ratios(&self.axes.given_at(point))).collect();
        let found = looped.records(&ratios).into_iter().zip(first..);
        // Alone, a point without ratios has its error.
        found.map(|(record, point)| record.map_or_else(|| self.record(point), Ok)).collect()
    }

    /// The text of a row.
    fn written(&self, record: &Record<F>) -> Result<Vec<u8>, Failure> {
        if self.csv {
            return csv_text(|writer| record.write_row(writer));
        }
        let mut text = Vec::new();
        record.write_line(&mut text)?;
        Ok(text)
    }

    fn full_record(&self, point: u64) -> Result<Record<F>, Failure> {
        if interrupt::asked() {
            return Err(Failure::Interrupted);
        }
        // The computation is repeated for an error message that contains the values.
        answer(self.question, &self.axes.given_at(point), self.peaks)
            .or_else(|_| answer(self.question, &self.axes.named_at(point), self.peaks))
    }
}

impl<F: Value> Table<F> for SweepRows<F> {
    fn len(&self) -> u64 {
        self.axes.len()
    }

    #[cfg(feature = "parquet")]
    fn form(&self) -> &Record<F> {
        &self.form
    }

    #[cfg(feature = "parquet")]
    fn record(&self, point: u64) -> Result<Record<F>, Failure> {
        Self::record(self, point)
    }

    #[cfg(feature = "parquet")]
    fn records(&self, points: Range<u64>) -> Vec<Result<Record<F>, Failure>> {
        self.first_records(points)
    }

    #[cfg(feature = "parquet")]
    fn notes(&self) -> Vec<(String, String)> {
        self.notes.clone()
    }
}

impl<F: Value> resume::Rows for SweepRows<F> {
    const OF: &'static str = "this sweep";

    /// The header line; empty for JSON lines.
    fn header(&self) -> Result<Vec<u8>, Failure> {
        csv_text(|writer| if self.csv { self.form.write_header(writer, self.header) } else { Ok(()) })
    }

    fn text(&self, point: u64) -> Result<Vec<u8>, Failure> {
        self.written(&self.record(point)?)
    }

    fn texts(&self, points: Range<u64>) -> Vec<Result<Vec<u8>, Failure>> {
        let records = self.first_records(points).into_iter();
        records.map(|record| record.and_then(|record| self.written(&record))).collect()
    }

    /// Whether Ω and, if there is one, α are among the columns. For a machine they distinguish the rows of
    /// one machine, but not two machines.
    fn hold_their_grid(&self) -> bool {
        let among = |key: Key| self.columns.iter().any(|column| column == key.name);
        among(OMEGA) && (self.question == Swept::Border || among(ALPHA))
    }

    /// Whether the Ω and α in a written row, if the row contains them, are those of a point of the grid.
    fn is_on_grid(&self, line: &[u8], point: u64) -> Result<bool, Failure> {
        let (omega, alpha) = self.ratios(point)?;
        let due = [Some((OMEGA, omega)), (self.question != Swept::Border).then_some((ALPHA, alpha))];
        for (key, value) in due.into_iter().flatten() {
            let Some(place) = self.columns.iter().position(|name| name == key.name) else { continue };
            let cell = Record::of(vec![(key, Cell::Number(Some(value)))]);
            let same = if self.csv {
                let due = csv_text(|writer| cell.write_row(writer))?;
                let found = line.trim_ascii_end().split(|byte| *byte == b',').nth(place);
                found == Some(due.trim_ascii_end())
            } else {
                let mut due = Vec::new();
                cell.write_line(&mut due)?;
                // The object `{"omega":0.5}` as a member of the row.
                let inner = |text: &[u8]| {
                    text.trim_ascii_end().strip_prefix(b"{")?.strip_suffix(b"}").map(<[u8]>::to_vec)
                };
                inner(&due).is_some_and(|due| {
                    inner(line)
                        .is_some_and(|found| found.split(|byte| *byte == b',').any(|member| member == due))
                })
            };
            if !same {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

/// The answer of the command with this name for the given quantities.
pub(crate) fn answer<F: Value>(question: Swept, given: &Given<F>, peaks: bool) -> Result<Record<F>, Failure> {
    Ok(match question {
        Swept::Response => response::answer(given, &input::point(given)?, peaks)?.1,
        Swept::Steady => {
            steady::answer(given, &input::point(given)?, State::default(), DEFAULT_BUDGET, peaks)?.1
        }
        Swept::Border => border::record(given, &input::border_point(given)?, false)?.2,
    })
}

/// The names of the values of all rows, in a record without a motion, which can take long to compute.
fn form<F: Value>(question: Swept, given: &Given<F>, peaks: bool) -> Result<Record<F>, Failure> {
    match question {
        Swept::Steady => steady::form(given, &input::point(given)?, peaks),
        Swept::Response | Swept::Border => answer(question, given, peaks),
    }
}

/// Fails if a point of the grids has no answer.
pub(crate) fn check<F: Value>(question: Swept, axes: &Axes<F>) -> Outcome {
    if question == Swept::Border
        && let Some(drive) = Input::of_role(Role::Drive).into_iter().find(|p| axes.has(*p))
    {
        return Err(Failure::Input(format!(
            "{}: must be left out, because a border has none",
            drive.option()
        )));
    }
    axes.at_ends(|given| match question {
        Swept::Border => input::border_point(given).map(|_| ()),
        Swept::Response => input::point(given).map(|_| ()),
        Swept::Steady => {
            let ratios = input::point(given)?.ratios;
            Trajectory::new(ratios, State::default()).map(|_| ()).map_err(|e| given.at_fault(&e).into())
        }
    })
}
