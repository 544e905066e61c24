//! The rows of a sweep, each computed from its number alone.

use super::Table;
use super::loops::Looped;
use crate::args::{Header, SweepArgs, Swept};
use crate::bits::Value;
use crate::failure::{Failure, Outcome};
use crate::grid::Axes;
use crate::interrupt;
use crate::outputs::{self, ALPHA, Key, OMEGA};
use crate::physical::Physical;
use crate::row::{Cell, Cells, Row};
use crate::{closed, input, progress, steady};
use std::ops::Range;
use stickslip::motion::{DEFAULT_BUDGET, State, Trajectory};
use stickslip_front::inputs::{Given, Input, Role};

/// The command at each point of the grids, and the format of its row.
pub(crate) struct SweepRows<F> {
    question: Swept,
    axes: Axes<F>,
    outputs: Option<Vec<String>>,
    /// A row without its motion, for the names of its values.
    form: Row,
    columns: Vec<String>,
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
    super::notes(
        &args.machine,
        [
            ("system", args.units.units.map(|system| system.to_string())),
            ("sweep", Some(args.question.command().to_owned())),
            ("outputs", args.outputs.as_ref().map(|names| names.join(","))),
            ("shard", args.table.shard.clone()),
            ("bits", args.bits.map(|bits| bits.to_string())),
        ],
    )
}

impl<F: Value> SweepRows<F> {
    /// The requested rows, if every point has an answer and every column exists.
    pub(crate) fn new(args: &SweepArgs, axes: Axes<F>) -> Result<Self, Failure> {
        let outputs = args.outputs.clone();
        let peaks = outputs.as_ref().is_none_or(|names| names.iter().any(|name| outputs::is_searched(name)));
        let question = args.question;
        check(question, &axes)?;
        let form = form(question, &axes.named_at(0), peaks)?;
        for (place, wanted) in outputs.iter().flatten().enumerate() {
            if outputs.iter().flatten().take(place).any(|earlier| earlier == wanted) {
                return Err(format!("--outputs {wanted}: must be named only once").into());
            }
            if !form.has(wanted) {
                return Err(format!(
                    "--outputs {wanted}: unknown column. Choose from {}",
                    form.output_names().join(", ")
                )
                .into());
            }
        }
        let form = match &outputs {
            Some(outputs) => form.only(outputs),
            None => form,
        };
        let columns = form.names(Header::Names);
        let is_looped = question == Swept::Response && args.bits.is_none();
        let looped = is_looped.then(|| looped(&form, &axes.named_at(0))).flatten();
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
            peaks,
            looped,
        })
    }

    /// The requested columns of a row, in the given order; a point that has no answer is a row with its ratios, and its
    /// reason is said.
    fn alone(&self, point: u64) -> Result<Row, Failure> {
        let row = match self.full_row(point) {
            Err(failure) if failure.is_of_an_answer() => return self.without_answer(point, failure),
            found => found?,
        };
        Ok(match &self.outputs {
            Some(outputs) => row.only(outputs),
            None => row,
        })
    }

    /// The row of a point whose ratios are known, but whose motion or numbers are not.
    fn without_answer(&self, point: u64, failure: Failure) -> Result<Row, Failure> {
        let given = self.axes.given_at(point);
        let Ok(problem) = input::problem(self.question, &given) else { return Err(failure) };
        let has_alpha = self.question != Swept::Border;
        let ratios = Cells::of_ratios(&given, &problem.ratios, has_alpha).shown();
        progress::no_answer(&failure);
        Ok(self.form.blank(Some(&ratios)))
    }

    fn full_row(&self, point: u64) -> Result<Row, Failure> {
        if interrupt::asked() {
            return Err(Failure::Interrupted);
        }
        // The computation is repeated for an error message that contains the values.
        answer(self.question, &self.axes.given_at(point), self.peaks)
            .or_else(|_| answer(self.question, &self.axes.named_at(point), self.peaks))
    }
}

impl<F: Value> Table for SweepRows<F> {
    fn of(&self) -> &'static str {
        "this sweep"
    }

    fn len(&self) -> u64 {
        self.axes.len()
    }

    fn form(&self) -> &Row {
        &self.form
    }

    fn rows(&self, points: Range<u64>) -> Vec<Result<Row, Failure>> {
        let Some(looped) = self.looped.as_ref().filter(|_| !interrupt::asked()) else {
            return vec![self.alone(points.start)];
        };
        let first = points.start;
        let points: Vec<_> = points.map(|point| Looped::at(self.axes.given_at(point))).collect();
        let found = looped.rows(&points).into_iter().zip(first..);
        // Alone, a point without ratios has its error.
        found.map(|(row, point)| row.map_or_else(|| self.alone(point), Ok)).collect()
    }

    #[cfg(feature = "parquet")]
    fn notes(&self) -> Vec<(String, String)> {
        self.notes.clone()
    }

    /// Whether Ω and, if there is one, α are among the columns. For a machine they distinguish the rows of
    /// one machine, but not two machines.
    fn hold_their_grid(&self) -> bool {
        let among = |key: Key| self.columns.iter().any(|column| column == key.name);
        among(OMEGA) && (self.question == Swept::Border || among(ALPHA))
    }

    /// Whether the Ω and α in a written row, if the row contains them, are those of a point of the grid.
    fn is_on_grid(&self, line: &[u8], point: u64, is_csv: bool) -> Result<bool, Failure> {
        let ratios = input::problem(self.question, &self.axes.given_at(point))?.ratios;
        let alpha = (self.question != Swept::Border).then_some((ALPHA, ratios.alpha()));
        let due = [Some((OMEGA, ratios.omega())), alpha];
        // The object `{"omega":0.5}` as a member of the row.
        let inner = |text: &[u8]| text.strip_prefix(b"{")?.strip_suffix(b"}").map(<[u8]>::to_vec);
        let line = line.trim_ascii_end();
        for (key, value) in due.into_iter().flatten() {
            let Some(place) = self.columns.iter().position(|name| name == key.name) else { continue };
            let due = Cells::of(vec![(key, Cell::Number(Some(value)))]).shown().line(is_csv)?;
            let due = due.trim_ascii_end();
            let is_same = if is_csv {
                line.split(|byte| *byte == b',').nth(place) == Some(due)
            } else {
                let members = inner(line).zip(inner(due));
                members.is_some_and(|(row, due)| row.split(|byte| *byte == b',').any(|member| member == due))
            };
            if !is_same {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

/// The loops that compute all columns of a row, if there are any.
pub(crate) fn looped<F: Value>(form: &Row, given: &Given<F>) -> Option<Looped> {
    let point = input::point(given).ok()?;
    let machine = point.machine.as_ref();
    let names: Vec<_> = machine
        .map(|machine| {
            Physical::of_machine(given, machine).values.into_iter().map(|(name, ..)| name).collect()
        })
        .unwrap_or_default();
    Looped::of(
        form.fields.iter().map(|(key, _)| *key),
        form.physical.values.iter().map(|(name, kind, _)| (*name, *kind)),
        machine.map(|machine| (machine.drive.excitation(), &names[..])),
    )
}

/// The answer of the command with this name for the given quantities.
pub(crate) fn answer<F: Value>(question: Swept, given: &Given<F>, peaks: bool) -> Result<Row, Failure> {
    let point = input::problem(question, given)?;
    Ok(match question {
        Swept::Response => closed::response_at(given, &point, peaks)?.1,
        Swept::Steady => steady::answer(given, &point, State::default(), DEFAULT_BUDGET, peaks)?.1,
        Swept::Border => closed::border_at(given, &point, false)?.1,
    })
}

/// The names of the values of all rows, in a row without a motion, which can take long to compute.
fn form<F: Value>(question: Swept, given: &Given<F>, peaks: bool) -> Result<Row, Failure> {
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
        return Err(format!("{}: must be left out, because a border has none", drive.option()).into());
    }
    axes.at_ends(|given| {
        let ratios = input::problem(question, given)?.ratios;
        if question == Swept::Steady {
            Trajectory::new(ratios, State::default()).map_err(|e| given.at_fault(&e))?;
        }
        Ok(())
    })
}
