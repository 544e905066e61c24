//! The rows of a sweep, each made from its number alone.

use crate::args::{Header, SweepArgs, SweepFormat, Swept};
use crate::bits::Value;
use crate::failure::{Failure, Outcome};
use crate::grid::Grid;
use crate::interrupt;
use crate::note;
use crate::physical::Physical;
use crate::record::{Cell, Record};
use crate::steady;
use std::ops::Range;
use stickslip::exact::{DEFAULT_BUDGET, LongRun, State, Trajectory};
use stickslip::{Error, PhaseFunction, Ratios, Response};

/// What is asked at each point of two grids, and how it is written.
pub(crate) struct Rows<F> {
    question: Swept,
    omega: Grid<F>,
    alpha: Grid<F>,
    outputs: Option<Vec<String>>,
    columns: Vec<String>,
    csv: bool,
}

impl<F: Value> Rows<F> {
    /// The rows asked for, once every point is known to have an answer and every column to exist.
    pub(crate) fn new(args: &SweepArgs, omega: Grid<F>, alpha: Grid<F>) -> Result<Self, Failure> {
        let csv = args.format() == SweepFormat::Csv;
        let outputs = args.outputs.clone();
        let mut rows = Self { question: args.question, omega, alpha, outputs, columns: Vec::new(), csv };
        check(args.question, &rows.omega, &rows.alpha)?;
        let first = rows.full_record(0)?;
        for (place, wanted) in rows.outputs.iter().flatten().enumerate() {
            if rows.outputs.iter().flatten().take(place).any(|earlier| earlier == wanted) {
                return Err(Failure::Input(format!("--outputs {wanted}: must be named once")));
            }
            if !first.fields.iter().any(|(name, _)| name == wanted) {
                let names: Vec<&str> = first.fields.iter().map(|(name, _)| *name).collect();
                return Err(Failure::Input(format!("--outputs {wanted}: must be of {}", names.join(","))));
            }
        }
        rows.columns = rows.record(0)?.names();
        Ok(rows)
    }

    pub(crate) fn len(&self) -> u64 {
        self.omega.len().saturating_mul(self.alpha.len())
    }

    /// The line of column names; nothing for JSON lines.
    pub(crate) fn header(&self) -> Result<Vec<u8>, Failure> {
        self.bytes(
            |writer| if self.csv { self.record(0)?.write_header(writer, Header::Names) } else { Ok(()) },
        )
    }

    /// The text of some rows.
    pub(crate) fn text(&self, points: Range<u64>) -> Result<Vec<u8>, Failure> {
        if self.csv {
            return self.bytes(|writer| {
                points.into_iter().try_for_each(|point| self.record(point)?.write_row(writer))
            });
        }
        let mut text = Vec::new();
        for point in points {
            self.record(point)?.write_line(&mut text)?;
        }
        Ok(text)
    }

    /// Whether Ω and, where there is one, α are among the columns.
    pub(crate) fn hold_their_grid(&self) -> bool {
        let among = |name: &str| self.columns.iter().any(|column| column == name);
        among("omega") && (self.question == Swept::Border || among("alpha"))
    }

    /// Whether the Ω and α of a row as written, those it has, are the ones of a point of the grid.
    pub(crate) fn is_on_grid(&self, line: &[u8], point: u64) -> Result<bool, Failure> {
        let (omega, alpha) = self.ratios(point);
        let due = [("omega", omega), ("alpha", alpha)];
        for (name, value) in
            due.into_iter().filter(|(name, _)| *name == "omega" || self.question != Swept::Border)
        {
            let Some(place) = self.columns.iter().position(|n| n == name) else { continue };
            let cell =
                Record { fields: vec![(name, Cell::Number(Some(value)))], physical: Physical::default() };
            let same = if self.csv {
                let due = self.bytes(|writer| cell.write_row(writer))?;
                let found = line.trim_ascii_end().split(|byte| *byte == b',').nth(place);
                found == Some(due.trim_ascii_end())
            } else {
                let mut due = Vec::new();
                cell.write_line(&mut due)?;
                // `{"omega":0.5}` as one of the members of the row.
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

    fn ratios(&self, point: u64) -> (F, F) {
        let (slow, fast) = (point / self.alpha.len(), point % self.alpha.len());
        (self.omega.value(slow), self.alpha.value(fast))
    }

    fn bytes(
        &self,
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

    /// The columns wanted, in the order they were named.
    pub(crate) fn record(&self, point: u64) -> Result<Record<F>, Failure> {
        let mut record = self.full_record(point)?;
        if let Some(outputs) = &self.outputs {
            let named = |wanted: &String| record.fields.iter().find(|(name, _)| name == wanted).copied();
            record.fields = outputs.iter().filter_map(named).collect();
        }
        Ok(record)
    }

    fn full_record(&self, point: u64) -> Result<Record<F>, Failure> {
        if interrupt::asked() {
            return Err(Failure::Interrupted);
        }
        let (omega, alpha) = self.ratios(point);
        answer(self.question, omega, alpha).map_err(|e| Failure::Input(format!("--omega, --alpha: {e}")))
    }
}

/// What the command of that name answers at a point.
pub(crate) fn answer<F: Value>(question: Swept, omega: F, alpha: F) -> Result<Record<F>, Error> {
    Ok(match question {
        Swept::Response => Record::of_response(&Response::guarded(Ratios::new(omega, alpha)?)),
        Swept::Steady => {
            let ratios = Ratios::new(omega, alpha)?;
            steady::record(ratios, &LongRun::within(ratios, State::rest(), DEFAULT_BUDGET)?)?
        }
        Swept::Border => Record::of_border(&Response::guarded(Ratios::new(omega, F::int(1))?)),
    })
}

/// Fails where a value of the grids has no answer. The domains are intervals: their ends decide.
pub(crate) fn check<F: Value>(question: Swept, omega: &Grid<F>, alpha: &Grid<F>) -> Outcome {
    let named = |name: &str, value: F, e: Error| {
        Err(Failure::Input(format!("{name} {}: {e}", note::all_digits(value))))
    };
    for omega in omega.bounds() {
        if let Err(e) = PhaseFunction::new(omega) {
            return named("--omega", omega, e);
        }
        let in_motion =
            Ratios::new(omega, F::int(1)).and_then(|ratios| Trajectory::new(ratios, State::rest()));
        if let (Swept::Steady, Err(e)) = (question, in_motion) {
            return named("--omega", omega, e);
        }
    }
    for alpha in alpha.bounds() {
        if let Err(e) = Ratios::new(F::int(1), alpha) {
            return named("--alpha", alpha, e);
        }
    }
    Ok(())
}
