//! `stickslip basins`: the limit that each start in a plane of starts leads to.

use crate::args::BasinsArgs;
use crate::attractors::reach;
use crate::bits::digits;
use crate::bits::{Value, at_bits};
use crate::failure::{Failure, Outcome};
use crate::figure::Target;
use crate::grid::Grid;
use crate::input;
use crate::map;
use crate::starts::Starts;
use std::io::Write;
use stickslip::motion::{Attractors, State};
use stickslip_draw::{Axis, Figure, Panel, Plane, Scale, Series, Style};
use stickslip_front::grid::Range;
use stickslip_front::inputs::units::Kind;

/// The number of values of a grid that is not given.
const COUNT: u64 = 101;
/// The greatest number of starts, whose limits are kept in memory.
const MOST: u64 = 1_000_000;
/// The greatest number of names in the key of a picture; the last one stands for all others.
const MOST_NAMES: usize = 7;

/// The starts and the limits that they lead to.
struct Basins<F> {
    x: Axed<F>,
    v: Axed<F>,
    all: Attractors<F>,
    /// The inputs in a line.
    machine: String,
}

/// The values along an axis, in the units in which they were given.
struct Axed<F> {
    grid: Grid<F>,
    /// B, or B ω_d, in the units of the axis.
    scale: F,
    label: String,
    column: String,
}

pub(crate) fn run(args: &BasinsArgs, out: &mut impl Write) -> Outcome {
    at_bits!(args.bits, draw(args: &BasinsArgs, out))
}

fn draw<F: Value>(args: &BasinsArgs, out: &mut impl Write) -> Outcome {
    args.look.needs("--out", args.out.as_deref())?;
    let target = Target::new("--out", args.out.as_deref(), args.overwrite, &args.look)?;
    let basins = Basins::<F>::new(args)?;
    target.fill(out, |mut out| basins.table(&mut out), || basins.figure())
}

impl<F: Value> Basins<F> {
    fn new(args: &BasinsArgs) -> Result<Self, Failure> {
        let periods = input::periods(args.max_periods)?;
        let reader = args.units.reader();
        let given = input::read::<F>(&args.machine, &reader)?;
        input::refuse_frictionless(&given)?;
        let point = input::point(&given)?;
        let scales = point.machine.as_ref().map(|m| m.scales);
        let reach: F = reach(None, &point.ratios)?;
        let axis = |option: &str, text: &Option<String>, kind: Kind, symbol: &str, scale: Option<F>| {
            let kind = if scale.is_some() { kind } else { Kind::Ratio };
            let scale = scale.unwrap_or(F::int(1));
            let grid = match text {
                Some(text) => Grid::with_units(option, text, &reader, kind)?,
                None => {
                    let (from, to) = (-reach * scale, reach * scale);
                    Grid::Even(Range { from, to, count: COUNT, is_logarithmic: false })
                }
            };
            let unit = if scales.is_some() { given.system.name(kind) } else { symbol.to_owned() };
            let name = option.trim_start_matches('-');
            let displacement = input::displacement(&given);
            let what = if name == "x0" { displacement } else { "velocity" };
            let (label, column) = (format!("{what} at the start ({unit})"), format!("{name}[{unit}]"));
            Ok::<_, Failure>(Axed { grid, scale, label, column })
        };
        let x = axis("--x0", &args.x0, Kind::Length, "B", scales.map(|s| s.length))?;
        let v = axis("--v0", &args.v0, Kind::Velocity, "B ω_d", scales.map(|s| s.velocity))?;
        let count = x.grid.len().saturating_mul(v.grid.len());
        if count > MOST {
            return Err(format!("--x0, --v0: {count} starts, must be ≤ {MOST}").into());
        }
        let start = |number: u64| {
            let (across, up) = (number % x.grid.len(), number / x.grid.len());
            let (place, speed) = (x.grid.value(across), v.grid.value(up));
            State::new(F::int(0), place / x.scale, speed / v.scale)
                .map_err(|e| Failure::Input(format!("--x0 {place}, --v0 {speed}: {e}")))
        };
        let all = Starts { ratios: point.ratios, count, at: start, periods }.limits(&given, &args.rows)?;
        let machine = input::line(&args.machine, |_| true, &given.system);
        Ok(Self { x, v, all, machine })
    }

    /// The starts, row by row, each with the number of its limit.
    fn starts(&self) -> impl Iterator<Item = (F, F, Option<usize>)> {
        let places = self.v.grid.values().flat_map(|v| self.x.grid.values().map(move |x| (x, v)));
        places.enumerate().map(|(number, (x, v))| (x, v, self.all.of_start.get(number).copied().flatten()))
    }

    fn table(&self, out: &mut impl Write) -> Outcome {
        let mut writer = csv::Writer::from_writer(out);
        writer.write_record([&self.x.column, &self.v.column, "attractor", "limit"])?;
        for (x, v, place) in self.starts() {
            let number = place.map_or(String::new(), |place| (place + 1).to_string());
            let limit = place.and_then(|place| self.all.limits.get(place));
            let limit = limit.map_or("Not settled".to_owned(), stickslip_front::words::described);
            writer.write_record([x.to_string(), v.to_string(), number, limit])?;
        }
        Ok(writer.flush()?)
    }

    fn figure(&self) -> Result<Figure, Failure> {
        let drawn = |axed: &Axed<F>| axed.grid.values().map(F::to_f64).collect::<Vec<f64>>();
        let (x, y) = (drawn(&self.x), drawn(&self.v));
        let ends = |values: &[f64], option: &str| {
            map::ends(values).ok_or_else(|| {
                Failure::from(format!("{option}: a picture needs two values or more, ascending"))
            })
        };
        let (across, up) = (ends(&x, "--x0")?, ends(&y, "--v0")?);
        let shown = self.all.limits.len().min(MOST_NAMES);
        let mut names: Vec<String> = (0..shown).filter_map(|place| self.name(place)).collect();
        if self.all.limits.len() > shown
            && let Some(last) = names.last_mut()
        {
            *last = format!("{shown} or higher: other limits");
        }
        let value = |place: Option<usize>| place.map_or(f64::NAN, |place| place.min(MOST_NAMES - 1) as f64);
        let values: Vec<f64> = self.starts().map(|(.., place)| value(place)).collect();
        let mut series = Vec::new();
        if self.all.unsettled() > 0 {
            series.push(Series::new("white: not settled", Style::Note, 0, []));
        }
        Ok(Figure::new(
            "basins",
            "The limit that each start leads to",
            "",
            vec![
                Panel::new(
                    self.machine.clone(),
                    Axis::linear(&self.x.label, across.0, across.1),
                    Axis::linear(&self.v.label, up.0, up.1),
                    series,
                )
                .over(Plane {
                    label: "limit".to_owned(),
                    x,
                    y,
                    values,
                    scale: Scale::Names(names),
                }),
            ],
        ))
    }

    /// A limit by its number and its extrema.
    fn name(&self, place: usize) -> Option<String> {
        let limit = self.all.limits.get(place)?.limit;
        let kind = limit.name();
        // Four digits of B distinguish two limits.
        let in_units = |x: F| digits((x.to_f64() * 1e4).round() / 1e4 * self.x.scale.to_f64());
        Some(match limit.extrema() {
            Some((low, high)) => {
                format!("{}: {kind}, x from {} to {}", place + 1, in_units(low), in_units(high))
            }
            None => format!("{}: {kind}", place + 1),
        })
    }
}
