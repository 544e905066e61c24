//! `record --floor-spectrum`: the greatest responses of oscillators that stand on the body.

use crate::args::RecordArgs;
use crate::bits::Value;
use crate::failure::{Failure, Outcome};
use crate::grid::Grid;
use crate::physical::Units;
use crate::row::{Cell, Number};
use serde::ser::{Serialize, Serializer};
use std::io::Write;
use stickslip::motion::record::{Body, Record};
use stickslip_front::inputs::units::{Kind, Reader, System};

/// The most oscillators.
const MOST: u64 = 10_000;

/// The oscillators that were asked for.
pub(crate) struct Oscillators<F> {
    periods: Vec<F>,
    damping_ratio: F,
}

impl<F: Value> Oscillators<F> {
    pub(crate) fn read(args: &RecordArgs, reader: &Reader) -> Result<Option<Self>, Failure> {
        let Some(text) = &args.floor_spectrum else { return Ok(None) };
        let grid = Grid::<F>::with_units("--floor-spectrum", text, reader, Kind::Time)?;
        if grid.len() > MOST {
            return Err(format!("--floor-spectrum {text}: {} periods, must be ≤ {MOST}", grid.len()).into());
        }
        let periods: Vec<F> = grid.values().collect();
        if let Some(period) = periods.iter().find(|period| **period <= F::int(0)) {
            return Err(format!("--floor-spectrum {text}: the period {period} s must be > 0").into());
        }
        let damping = args.floor_damping.as_deref().unwrap_or("5%");
        let damping_ratio = reader.value::<F>("--floor-damping", damping, Kind::Ratio)?;
        if !(F::int(0)..=F::ratio(99, 100)).contains(&damping_ratio) {
            return Err(format!("--floor-damping {damping}: must be ≥ 0 and ≤ 0.99").into());
        }
        Ok(Some(Self { periods, damping_ratio }))
    }
}

/// The columns of a floor spectrum.
const COLUMNS: [(&str, Kind); 4] = [
    ("period", Kind::Time),
    ("max_displacement", Kind::Length),
    ("pseudo_acceleration", Kind::Acceleration),
    ("max_absolute_acceleration", Kind::Acceleration),
];

/// The response of one oscillator.
#[derive(Debug)]
struct Response([Cell<Number>; COLUMNS.len()]);

impl Serialize for Response {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(COLUMNS.iter().map(|(name, _)| name).zip(&self.0))
    }
}

/// The responses by period.
#[derive(serde::Serialize)]
pub(crate) struct FloorSpectrum {
    damping_ratio: Cell<Number>,
    rows: Vec<Response>,
    units: Units,
}

impl FloorSpectrum {
    pub(crate) fn new<F: Value>(
        asked: &Oscillators<F>,
        (body, [x, v]): (&Body<F>, [F; 2]),
        record: &Record<F>,
        system: System,
    ) -> Result<Self, Failure> {
        let found = body.floor_spectrum(record, x, v, &asked.periods, asked.damping_ratio);
        let found = found.map_err(|e| Failure::Input(format!("--floor-spectrum: {e}")))?;
        let mut rows = Vec::new();
        for one in &found {
            let values =
                [one.period, one.max_displacement, one.pseudo_acceleration, one.max_absolute_acceleration];
            let mut kinds = COLUMNS.iter().map(|(_, kind)| *kind);
            let shown = |value| kinds.next().map_or(value, |kind| system.shown(kind, value));
            let cells = values.map(shown).map(|value| Cell::Number(Some(value)).shown());
            for ((name, _), cell) in COLUMNS.iter().zip(&cells) {
                cell.finite(name)?;
            }
            rows.push(Response(cells));
        }
        let damping_ratio = Cell::Number(Some(asked.damping_ratio)).shown();
        Ok(Self { damping_ratio, rows, units: Units(system, COLUMNS.into()) })
    }

    /// A table of the responses.
    pub(crate) fn text(&self, of: &str, system: &System, out: &mut impl Write) -> Outcome {
        writeln!(
            out,
            "\nFloor spectrum{of}: oscillators with ζ = {} on the body\n",
            self.damping_ratio.text()
        )?;
        let titles =
            COLUMNS.map(|(name, kind)| format!("{} ({})", name.replace('_', " "), system.name(kind)));
        let mut lines = vec![titles];
        lines.extend(self.rows.iter().map(|Response(cells)| cells.each_ref().map(Cell::text)));
        // Numbers of many digits are wider than the titles.
        let width = lines.iter().flatten().map(|cell| cell.chars().count()).max().unwrap_or(0).max(32) + 2;
        for line in lines {
            writeln!(out, "{}", line.map(|cell| format!("{cell:>width$}")).concat())?;
        }
        Ok(())
    }
}
