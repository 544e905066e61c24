//! The rows of a sweep, each made from its number alone.

use super::is_csv;
use crate::args::{SweepArgs, Swept};
use crate::bits::Value;
use crate::failure::{Failure, Outcome};
use crate::grid::Grid;
use crate::record::Record;
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
    csv: bool,
}

impl<F: Value> Rows<F> {
    /// The rows asked for, once every point is known to have an answer and every column to exist.
    pub(crate) fn new(args: &SweepArgs, omega: Grid<F>, alpha: Grid<F>) -> Result<Self, Failure> {
        let csv = is_csv(args.format)?;
        let rows = Self { question: args.question, omega, alpha, outputs: args.outputs.clone(), csv };
        check(args.question, &rows.omega, &rows.alpha)?;
        let first = rows.full_record(0)?;
        for wanted in rows.outputs.iter().flatten() {
            if !first.fields.iter().any(|(name, _)| name == wanted) {
                let names: Vec<&str> = first.fields.iter().map(|(name, _)| *name).collect();
                return Err(Failure::Input(format!("--outputs {wanted}: must be of {}", names.join(","))));
            }
        }
        Ok(rows)
    }

    pub(crate) fn len(&self) -> u64 {
        self.omega.len().saturating_mul(self.alpha.len())
    }

    /// The line of column names; nothing for JSON lines.
    pub(crate) fn header(&self) -> Result<Vec<u8>, Failure> {
        self.bytes(|writer| if self.csv { self.record(0)?.write_header(writer) } else { Ok(()) })
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

    fn bytes(
        &self,
        fill: impl FnOnce(&mut csv::Writer<&mut Vec<u8>>) -> Outcome,
    ) -> Result<Vec<u8>, Failure> {
        let mut text = Vec::new();
        {
            let mut writer = csv::Writer::from_writer(&mut text);
            fill(&mut writer)?;
            writer.flush()?;
        }
        Ok(text)
    }

    /// The columns wanted, in the order they were named.
    fn record(&self, point: u64) -> Result<Record<F>, Failure> {
        let mut record = self.full_record(point)?;
        if let Some(outputs) = &self.outputs {
            let named = |wanted: &String| record.fields.iter().find(|(name, _)| name == wanted).copied();
            record.fields = outputs.iter().filter_map(named).collect();
        }
        Ok(record)
    }

    fn full_record(&self, point: u64) -> Result<Record<F>, Failure> {
        let (slow, fast) = (point / self.alpha.len(), point % self.alpha.len());
        let (omega, alpha) = (self.omega.value(slow), self.alpha.value(fast));
        answer(self.question, omega, alpha).map_err(|e| Failure::Input(format!("--omega, --alpha: {e}")))
    }
}

/// What the command of that name answers at a point.
pub(crate) fn answer<F: Value>(question: Swept, omega: F, alpha: F) -> Result<Record<F>, Error> {
    Ok(match question {
        Swept::Response => Record::of_response(&Response::guarded(Ratios::new(omega, alpha)?)),
        Swept::Steady => {
            let ratios = Ratios::new(omega, alpha)?;
            steady::record(ratios, &LongRun::within(ratios, State::rest(), DEFAULT_BUDGET)?)
        }
        Swept::Border => Record::of_border(&Response::guarded(Ratios::new(omega, F::int(1))?)),
    })
}

/// Fails where a value of the grids has no answer. The domains are intervals: their ends decide.
pub(crate) fn check<F: Value>(question: Swept, omega: &Grid<F>, alpha: &Grid<F>) -> Outcome {
    let named = |name: &str, value: F, e: Error| Err(Failure::Input(format!("{name} {value}: {e}")));
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
