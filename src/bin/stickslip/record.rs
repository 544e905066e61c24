//! Answers as records: one list of names and values, written as JSON or CSV.

use crate::bits::Value;
use crate::failure::{Failure, Outcome};
use crate::input::{BorderScales, Machine};
use crate::note;
use serde::ser::{Serialize, SerializeMap, Serializer};
use std::io::{self, Write};
use stickslip::Response;
use stickslip::regime::NoStop;

/// A value of a record.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Cell<F> {
    Text(&'static str),
    /// `None` for what does not exist there.
    Number(Option<F>),
    /// A whole number.
    Count(Option<u64>),
    /// Whether something holds.
    Flag(bool),
    /// Two intervals at most, the greatest of the last one missing.
    Intervals([Option<(F, Option<F>)>; 2]),
    /// Two complex numbers, each as its real and imaginary part.
    Pairs(Option<[(F, F); 2]>),
}

impl<F: Value> Cell<F> {
    /// A failure under that name where a number is infinite.
    pub(crate) fn finite(&self, name: &str) -> Outcome {
        let one = |x: F| {
            let text = format!("{name} = {x} must be finite: it is beyond the largest number in these units");
            if x.is_finite() { Ok(()) } else { Err(Failure::Input(text)) }
        };
        match self {
            Self::Number(number) => number.map_or(Ok(()), one),
            Self::Pairs(pairs) => {
                pairs.iter().flatten().try_for_each(|&(re, im)| one(re).and_then(|()| one(im)))
            }
            Self::Intervals(intervals) => intervals
                .iter()
                .flatten()
                .try_for_each(|&(low, high)| one(low).and_then(|()| high.map_or(Ok(()), one))),
            Self::Text(_) | Self::Count(_) | Self::Flag(_) => Ok(()),
        }
    }

    /// As a reader wants it: seven digits at f64, a dash for what does not exist.
    pub(crate) fn text(&self) -> String {
        let dash = || "–".to_owned();
        match self {
            Self::Text(text) => (*text).to_owned(),
            Self::Number(number) => number.map_or_else(dash, note::digits),
            Self::Count(count) => count.map_or_else(dash, |n| n.to_string()),
            Self::Flag(flag) => flag.to_string(),
            Self::Intervals(intervals) => {
                let text = |&(low, high): &(F, Option<F>)| match high {
                    Some(high) => format!("{} to {}", note::digits(low), note::digits(high)),
                    None => format!("{} and more", note::digits(low)),
                };
                intervals.iter().flatten().map(text).collect::<Vec<_>>().join(", ")
            }
            Self::Pairs(pairs) => pairs.map_or_else(dash, |pairs| {
                pairs.map(|(re, im)| format!("{} {} i", note::digits(re), note::digits(im))).join(", ")
            }),
        }
    }
}

/// A number at f64; a string with all digits of a wider one, which a reader of JSON would round.
impl<F: Value> Serialize for Cell<F> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Text(text) => text.serialize(serializer),
            Self::Number(Some(number)) if F::PRECISION > f64::MANTISSA_DIGITS => {
                serializer.collect_str(number)
            }
            Self::Number(number) => number.map(F::to_f64).serialize(serializer),
            Self::Count(count) => count.serialize(serializer),
            Self::Flag(flag) => flag.serialize(serializer),
            Self::Intervals(intervals) => serializer.collect_seq(
                intervals.iter().flatten().map(|&(low, high)| [Some(low), high].map(Self::Number)),
            ),
            Self::Pairs(None) => serializer.serialize_none(),
            Self::Pairs(Some(pairs)) => {
                serializer.collect_seq(pairs.map(|(re, im)| [re, im].map(|x| Self::Number(Some(x)))))
            }
        }
    }
}

/// Named values in order, and those in physical units.
#[derive(Debug)]
pub(crate) struct Record<F> {
    pub(crate) fields: Vec<(&'static str, Cell<F>)>,
    pub(crate) physical: Vec<(&'static str, Cell<F>)>,
}

impl<F: Value> Serialize for Record<F> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for (name, cell) in &self.fields {
            map.serialize_entry(name, cell)?;
        }
        if !self.physical.is_empty() {
            map.serialize_entry("physical", &Nested(&self.physical))?;
        }
        map.end()
    }
}

struct Nested<'a, F>(&'a [(&'static str, Cell<F>)]);

impl<F: Value> Serialize for Nested<'_, F> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, cell)| (name, cell)))
    }
}

impl<F: Value> Record<F> {
    /// All outputs of a response; `None` in the cells that a regime does not have.
    pub(crate) fn of_response(response: &Response<F>) -> Self {
        let (ratios, border, cycle) = (response.ratios(), response.border(), response.cycle());
        let of_cycle = |value: fn(&stickslip::Cycle<F>) -> F| Cell::Number(cycle.map(value));
        Self {
            fields: vec![
                ("omega", Cell::Number(Some(ratios.omega()))),
                ("alpha", Cell::Number(Some(ratios.alpha()))),
                ("regime", Cell::Text(response.regime().name())),
                ("max_displacement", of_cycle(|c| c.max_displacement())),
                ("displacement_phase", of_cycle(|c| c.displacement_phase())),
                ("max_velocity", of_cycle(|c| c.max_velocity())),
                ("velocity_phase", of_cycle(|c| c.velocity_phase())),
                ("deviation", of_cycle(|c| c.deviation())),
                ("min_force_ratio", Cell::Number(Some(border.min_force_ratio()))),
                ("min_force_ratio_turning_point", Cell::Number(Some(border.turning_point()))),
                ("loop_size_stiffness", Cell::Number(response.loop_size_stiffness())),
                ("loop_size_inertia", Cell::Number(response.loop_size_inertia())),
                ("best_force_ratio", Cell::Number(Some(response.best_force_ratio()))),
                ("best_loop_size", Cell::Number(response.best_loop_size())),
                ("contraction", of_cycle(|c| c.contraction())),
                ("reversals_per_cycle", Cell::Count(response.reversals_per_cycle().map(u64::from))),
                ("best_force_ratio_slides", Cell::Flag(response.best_is_reached())),
            ],
            physical: Vec::new(),
        }
    }

    /// The border at Ω and the best force ratio there, of a response at any α.
    pub(crate) fn of_border(response: &Response<F>) -> Self {
        let border = response.border();
        Self {
            fields: vec![
                ("omega", Cell::Number(Some(response.ratios().omega()))),
                ("min_force_ratio", Cell::Number(Some(border.min_force_ratio()))),
                ("min_force_ratio_turning_point", Cell::Number(Some(border.turning_point()))),
                ("border_phase", Cell::Number(Some(border.phase()))),
                ("least_displacement", Cell::Number(Some(border.least_displacement()))),
                ("best_force_ratio", Cell::Number(Some(response.best_force_ratio()))),
            ],
            physical: Vec::new(),
        }
    }

    /// The same with the force ratios without any stop.
    pub(crate) fn with_no_stop(mut self, no_stop: &NoStop<F>) -> Self {
        self.fields.push(("no_stop_force_ratios", Self::intervals(no_stop)));
        self
    }

    /// Its intervals as a value.
    pub(crate) fn intervals(no_stop: &NoStop<F>) -> Cell<F> {
        let mut intervals = no_stop.intervals();
        Cell::Intervals([intervals.next(), intervals.next()])
    }

    /// The same names in the machine's units: ω_d, p₀, lengths, velocities, times, forces, and loop sizes as the energy
    /// of a cycle, the best one at the best force.
    pub(crate) fn with_machine(mut self, machine: &Machine<F>) -> Self {
        let scales = &machine.scales;
        let ratio = |name: &str| match self.fields.iter().find(|(found, _)| *found == name) {
            Some((_, Cell::Number(Some(number)))) => *number,
            Some(_) | None => F::int(1),
        };
        // A₁ is in units of p₀²/(2k), p₀ = α r_y, and at the best force of (α* r_y)²/(2k).
        let best = ratio("best_force_ratio") / ratio("alpha");
        let p0 = machine.drive.force_amplitude(&machine.oscillator);
        self.physical = self.rescaled(|name| match name {
            "max_displacement" | "deviation" => Some(scales.length),
            "max_velocity" => Some(scales.velocity),
            "displacement_phase" | "velocity_phase" => Some(scales.time),
            "min_force_ratio" | "min_force_ratio_turning_point" | "best_force_ratio" => Some(scales.force),
            "loop_size_stiffness" => Some(scales.energy_stiffness),
            "best_loop_size" => Some(scales.energy_stiffness * best * best),
            "loop_size_inertia" => Some(scales.energy_inertia),
            "contraction" => Some(F::int(1)),
            _ => None,
        });
        let known = [("omega", machine.drive.angular_frequency()), ("alpha", p0)];
        self.physical.splice(0..0, known.map(|(name, value)| (name, Cell::Number(Some(value)))));
        self
    }

    /// The border in the machine's units.
    pub(crate) fn with_border_scales(mut self, scales: BorderScales<F>) -> Self {
        self.physical = self.rescaled(|name| match name {
            "min_force_ratio"
            | "min_force_ratio_turning_point"
            | "best_force_ratio"
            | "no_stop_force_ratios" => Some(scales.force),
            "border_phase" => Some(scales.time),
            "least_displacement" => Some(scales.length),
            _ => None,
        });
        self.physical.insert(0, ("omega", Cell::Number(Some(scales.frequency))));
        self
    }

    pub(crate) fn rescaled(&self, scale: impl Fn(&str) -> Option<F>) -> Vec<(&'static str, Cell<F>)> {
        let rescale = |&(name, cell): &(&'static str, Cell<F>)| match cell {
            Cell::Number(value) => scale(name).map(|unit| (name, Cell::Number(value.map(|v| v * unit)))),
            Cell::Intervals(intervals) => scale(name).map(|unit| {
                let scaled = |(low, high): (F, Option<F>)| (low * unit, high.map(|x| x * unit));
                (name, Cell::Intervals(intervals.map(|interval| interval.map(scaled))))
            }),
            Cell::Text(_) | Cell::Count(_) | Cell::Flag(_) | Cell::Pairs(_) => None,
        };
        self.fields.iter().filter_map(rescale).collect()
    }

    /// The record, where each of its numbers is one. Units that are too small make infinity of a motion, which JSON does not have.
    pub(crate) fn finite(self) -> Result<Self, Failure> {
        self.fields.iter().chain(&self.physical).try_for_each(|&(name, cell)| cell.finite(name))?;
        Ok(self)
    }

    /// One line of JSON.
    pub(crate) fn write_line(&self, out: &mut impl Write) -> Outcome {
        serde_json::to_writer(&mut *out, self)?;
        Ok(out.write_all(b"\n")?)
    }

    /// JSON for a single answer, indented.
    pub(crate) fn write_pretty(&self, out: &mut impl Write) -> Outcome {
        serde_json::to_writer_pretty(&mut *out, self)?;
        Ok(out.write_all(b"\n")?)
    }

    /// One row of CSV; an empty cell for what does not exist. Every number in the digits that give it back.
    pub(crate) fn write_row(&self, out: &mut csv::Writer<impl Write>) -> Outcome {
        Ok(out.serialize(self.cells().collect::<Vec<_>>())?)
    }

    /// The header of the rows.
    pub(crate) fn write_header(&self, out: &mut csv::Writer<impl Write>) -> Outcome {
        Ok(out.write_record(self.names())?)
    }

    /// The cells of a row, each of one value: four for a pair of complex numbers.
    pub(crate) fn cells(&self) -> impl Iterator<Item = Cell<F>> + '_ {
        let single = |cell| [Some(cell), None, None, None];
        let cells = move |&(_, cell): &(&'static str, Cell<F>)| match cell {
            Cell::Pairs(pairs) => {
                let number = |part: fn([(F, F); 2]) -> F| Some(Cell::Number(pairs.map(part)));
                [
                    number(|[(re, _), _]| re),
                    number(|[(_, im), _]| im),
                    number(|[_, (re, _)]| re),
                    number(|[_, (_, im)]| im),
                ]
            }
            Cell::Intervals(intervals) => intervals
                .map(|interval| {
                    let (low, high) = interval.map_or((None, None), |(low, high)| (Some(low), high));
                    [Some(Cell::Number(low)), Some(Cell::Number(high))]
                })
                .as_flattened()
                .try_into()
                .unwrap_or([None; 4]),
            Cell::Text(_) | Cell::Number(_) | Cell::Count(_) | Cell::Flag(_) => single(cell),
        };
        self.fields.iter().flat_map(cells).flatten()
    }

    /// The names of those cells.
    pub(crate) fn names(&self) -> Vec<String> {
        let names = |(name, cell): &(&'static str, Cell<F>)| match cell {
            Cell::Pairs(_) => ["1_re", "1_im", "2_re", "2_im"].map(|part| format!("{name}_{part}")).to_vec(),
            Cell::Intervals(_) => {
                ["1_low", "1_high", "2_low", "2_high"].map(|part| format!("{name}_{part}")).to_vec()
            }
            Cell::Text(_) | Cell::Number(_) | Cell::Count(_) | Cell::Flag(_) => vec![(*name).to_owned()],
        };
        self.fields.iter().flat_map(names).collect()
    }

    /// One row of a table to read: seven digits, columns of one width.
    pub(crate) fn write_table_row(&self, out: &mut impl Write) -> io::Result<()> {
        for (i, (_, cell)) in self.fields.iter().enumerate() {
            let text = cell.text();
            let gap = if i == 0 { "" } else { "  " };
            write!(out, "{gap}{text:>COLUMN$}")?;
        }
        writeln!(out)
    }

    /// The header of a table to read.
    pub(crate) fn write_table_header(&self, out: &mut impl Write) -> io::Result<()> {
        let names: Vec<String> = self.fields.iter().map(|(name, _)| format!("{name:>COLUMN$}")).collect();
        writeln!(out, "{}", names.join("  "))
    }
}

/// Width of a column of a table to read.
const COLUMN: usize = 14;
