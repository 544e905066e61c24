//! Many starts computed in parallel, each with its limit, as rows that can be resumed.

use crate::args::{Header, RowsArgs};
use crate::bits::Value;
use crate::failure::{Failure, Outcome};
use crate::interrupt;
use crate::outputs::{ALPHA, DAMPING_RATIO, Key, OMEGA, STATIC_FRICTION_RATIO, key};
use crate::resume::{self, not_this};
use crate::row::{Cell, Cells, Row, csv_text};
use crate::steady::of_motion;
use std::fs::File;
use std::io::{self, BufRead, BufReader, Write};
use std::path::Path;
use stickslip::Ratios;
use stickslip::internal::definitions::LIMIT;
use stickslip::motion::{Attractors, LongRun, Signature, State, SteadyOutput, Trajectory};
use stickslip_front::inputs::Given;

/// The source of the rows, for error messages.
const OF: &str = "these starts";

/// A number of starts of one machine, each computed from its number.
pub(crate) struct Starts<F, S> {
    pub(crate) ratios: Ratios<F>,
    pub(crate) count: u64,
    pub(crate) at: S,
    pub(crate) periods: u32,
}

impl<F: Value, S: Fn(u64) -> Result<State<F>, Failure> + Sync> Starts<F, S> {
    /// The limits, in the order of the starts for any number of threads. Rows of a resumed file are not
    /// computed again, except for the first start of each limit.
    pub(crate) fn limits(&self, given: &Given<F>, rows: &RowsArgs) -> Result<Attractors<F>, Failure> {
        Trajectory::new(self.ratios, State::<F>::default()).map_err(|e| of_motion(given, e))?;
        let mut all = Attractors::new();
        let Some(name) = &rows.rows else {
            self.follow_on(0, &mut all, &mut io::sink())?;
            return Ok(all);
        };
        resume::to_file(("--rows", name), rows.resume, self, &(0..self.count), true, &mut |from, out| {
            self.read(name, from, &mut all).map_err(|e| e.about(&format!("--resume: {}", name.display())))?;
            self.follow_on(from, &mut all, out)
        })?;
        Ok(all)
    }

    /// Computes the limits from one start on.
    fn follow_on(&self, from: u64, all: &mut Attractors<F>, out: &mut impl Write) -> Outcome {
        resume::write(
            from..self.count,
            out,
            |numbers| vec![self.answer(numbers.start)],
            |(limit, row), out| {
                out.write_all(&row)?;
                Ok(all.add(limit)?)
            },
        )
    }

    /// The limit of a start, and its row.
    fn answer(&self, number: u64) -> Result<(LongRun<F>, Vec<u8>), Failure> {
        let limit = follow(self.ratios, (self.at)(number)?, self.periods)?;
        let signature = Signature::of(&limit)?;
        let row = self.row(number, limit.name(), &signature)?;
        Ok((limit, row.line(true)?))
    }

    /// Counts the starts whose limits the file contains.
    fn read(&self, name: &Path, rows: u64, all: &mut Attractors<F>) -> Outcome {
        let mut lines = BufReader::new(File::open(name)?).lines().skip(1);
        for number in 0..rows {
            let line = lines.next().transpose()?.unwrap_or_default();
            let bad = || not_this(OF, number + 1);
            let signature = signature(&line).ok_or_else(bad)?;
            if all.count(&signature) {
                continue;
            }
            let (limit, row) = self.answer(number)?;
            if row.trim_ascii_end() != line.as_bytes() {
                return Err(bad());
            }
            all.add(limit)?;
            interrupt::check()?;
        }
        Ok(())
    }

    /// The columns that identify the row of a start.
    fn of_start(&self, number: u64) -> Result<Vec<(Key, Cell<F>)>, Failure> {
        let start = (self.at)(number)?;
        let number = |x: F| Cell::Number(Some(x));
        Ok(vec![
            (OMEGA, number(self.ratios.omega())),
            (ALPHA, number(self.ratios.alpha())),
            (DAMPING_RATIO, number(self.ratios.damping_ratio())),
            (STATIC_FRICTION_RATIO, number(self.ratios.static_friction_ratio())),
            (key!("max_periods"), Cell::Count(Some(self.periods.into()))),
            (key!("bits"), Cell::Count(Some(F::precision().into()))),
            (key!("x0"), number(start.x)),
            (key!("v0"), number(start.v)),
        ])
    }

    fn row(&self, number: u64, kind: &'static str, signature: &Signature<F>) -> Result<Row, Failure> {
        let (half_turns, [x, v, off_x, off_v, most, least]) = match *signature {
            Signature::Periodic { half_turns, x, v, distance: (off_x, off_v) } => {
                (Some(half_turns.into()), [Some(x), Some(v), Some(off_x), Some(off_v), None, None])
            }
            Signature::Family { middle: place } | Signature::Rest { position: place } => {
                (None, [Some(place), None, None, None, None, None])
            }
            Signature::Irregular { max_displacement: most, min_displacement: least } => {
                (None, [None, None, None, None, Some(most), Some(least)])
            }
            Signature::Unbounded | Signature::NotConverged => (None, [None; 6]),
        };
        let mut fields = self.of_start(number)?;
        fields.extend([
            (LIMIT, Cell::Text(kind)),
            (key!("half_turns"), Cell::Count(half_turns)),
            (key!("x"), Cell::Number(x)),
            (key!("v"), Cell::Number(v)),
            (SteadyOutput::Distance.definition(), Cell::Number(off_x)),
            (key!("velocity_distance"), Cell::Number(off_v)),
            (SteadyOutput::MaxDisplacement.definition(), Cell::Number(most)),
            (SteadyOutput::MinDisplacement.definition(), Cell::Number(least)),
        ]);
        Ok(Cells::of(fields).shown())
    }
}

impl<F: Value, S: Fn(u64) -> Result<State<F>, Failure> + Sync> resume::Rows for Starts<F, S> {
    fn of(&self) -> &'static str {
        OF
    }

    fn header(&self) -> Result<Vec<u8>, Failure> {
        let row = self.row(0, "", &Signature::NotConverged)?;
        csv_text(|writer| row.write_header(writer, Header::Names))
    }

    fn text(&self, number: u64) -> Result<Vec<u8>, Failure> {
        Ok(self.answer(number)?.1)
    }

    fn hold_their_grid(&self) -> bool {
        true
    }

    fn is_on_grid(&self, line: &[u8], number: u64) -> Result<bool, Failure> {
        let row = Cells::of(self.of_start(number)?).shown();
        let due = row.line(true)?;
        let rest = line.strip_prefix(due.trim_ascii_end());
        Ok(rest.is_some_and(|rest| rest.starts_with(b",")))
    }
}

/// The signature of the limit in a row.
fn signature<F: Value>(line: &str) -> Option<Signature<F>> {
    let mut cells = line.split(',').skip(8);
    let kind = cells.next()?;
    let half_turns = cells.next()?;
    let mut number = || cells.next()?.parse::<F>().ok();
    let (x, v) = (number(), number());
    let (off_x, off_v, most, least) = (number(), number(), number(), number());
    Some(match kind {
        "periodic" => Signature::Periodic {
            half_turns: half_turns.parse().ok()?,
            x: x?,
            v: v?,
            distance: (off_x?, off_v?),
        },
        "family" => Signature::Family { middle: x? },
        "rest" => Signature::Rest { position: x? },
        "irregular" => Signature::Irregular { max_displacement: most?, min_displacement: least? },
        "none" => Signature::Unbounded,
        "not-converged" => Signature::NotConverged,
        _ => return None,
    })
}

/// The limit of a start, unless the user asks to stop.
pub(crate) fn follow<F: Value>(
    ratios: Ratios<F>,
    start: State<F>,
    periods: u32,
) -> Result<LongRun<F>, Failure> {
    Ok(LongRun::within(ratios, start, periods, &mut interrupt::keep_going)?)
}
