//! Responses of many points at once, where they are asked for outputs that a batch computes in loops. They have the
//! bits of a point alone.

use crate::bits::Value;
use crate::input;
use crate::outputs::{ALPHA, DAMPING_RATIO, Key, OMEGA, STATIC_FRICTION_RATIO};
use crate::physical::Physical;
use crate::row::{Cell, Cells, Row};
use stickslip::batch::{Batch, is_looped_with_damper};
use stickslip::internal::ResponseAnswer;
use stickslip::internal::definitions::REGIME;
use stickslip::{Excitation, Output, Ratios, Regime};
use stickslip_front::inputs::units::Kind;
use stickslip_front::inputs::{Given, Input, Point};

/// The columns of a row, all of which come from the ratios, from the machine or from loops.
pub(crate) struct Looped {
    fields: Vec<(Key, Source)>,
    /// Those in the machine's units.
    physical: Vec<(&'static str, Kind, Scaled)>,
    /// What the loops compute.
    outputs: Vec<Output>,
}

#[derive(Clone, Copy)]
enum Source {
    Ratio(fn(&Ratios<f64>) -> f64),
    Regime,
    /// The place among the loops' slices.
    Output(usize),
}

/// A value in the machine's units.
#[derive(Clone, Copy)]
enum Scaled {
    /// A quantity of the machine.
    Machine,
    /// An output, by its place among the loops' slices.
    Output(usize, Key),
}

/// A point of a sweep: its ratios and, in physical units, its quantities.
pub(crate) struct At<F> {
    given: Given<F>,
    point: Point<F>,
    pub(crate) ratios: Ratios<f64>,
}

impl Looped {
    /// These columns, if no other computation is needed; those in units need the kind of excitation and the names of the
    /// machine's quantities.
    pub(crate) fn of(
        columns: impl Iterator<Item = Key>,
        units: impl Iterator<Item = (&'static str, Kind)>,
        machine: Option<(Excitation, &[&'static str])>,
    ) -> Option<Self> {
        let mut looped = Self { fields: Vec::new(), physical: Vec::new(), outputs: Vec::new() };
        for key in columns {
            let source = match key.name {
                name if name == OMEGA.name => Source::Ratio(Ratios::omega),
                name if name == ALPHA.name => Source::Ratio(Ratios::alpha),
                name if name == DAMPING_RATIO.name => Source::Ratio(Ratios::damping_ratio),
                name if name == STATIC_FRICTION_RATIO.name => Source::Ratio(Ratios::static_friction_ratio),
                name if name == REGIME.name => Source::Regime,
                name => Source::Output(looped.place(name)?),
            };
            looped.fields.push((key, source));
        }
        for (name, kind) in units {
            let (excitation, of_machine) = machine?;
            let scaled = if of_machine.contains(&name) {
                Scaled::Machine
            } else {
                let mut keys = ResponseAnswer::<f64>::COLUMNS.iter().map(|column| column.definition);
                let key = keys.find(|key| key.physical_name(excitation) == Some(name))?;
                Scaled::Output(looped.place(key.name)?, key)
            };
            looped.physical.push((name, kind, scaled));
        }
        Some(looped)
    }

    /// The place among the loops' slices of the output with this name, if loops compute it.
    fn place(&mut self, name: &str) -> Option<usize> {
        let output = Output::ALL.into_iter().find(|output| output.name() == name)?;
        is_looped_with_damper(output).then_some(())?;
        let known = self.outputs.iter().position(|own| *own == output);
        Some(known.unwrap_or_else(|| {
            self.outputs.push(output);
            self.outputs.len() - 1
        }))
    }

    /// A point, if its ratios are in their domains and nothing is to be said about its answer.
    pub(crate) fn at<F: Value>(given: Given<F>) -> Option<At<F>> {
        let point = input::point(&given).ok()?;
        let ratios = point.ratios;
        let at = Ratios::new(ratios.omega().to_f64(), ratios.alpha().to_f64()).ok()?;
        let at = at.with_damping_ratio(ratios.damping_ratio().to_f64()).ok()?;
        let at = at.with_static_friction_ratio(ratios.static_friction_ratio().to_f64()).ok()?;
        given.get(Input::PendulumRadius).is_none().then_some(At { given, point, ratios: at })
    }

    /// The rows at some points; `None` for those without ratios, or with a number that does not exist in the machine's
    /// units.
    pub(crate) fn rows<F: Value>(&self, points: &[Option<At<F>>]) -> Vec<Option<Row>> {
        let (n, mut regimes) = (points.len(), vec![None; points.len()]);
        let mut numbers = vec![vec![f64::NAN; n]; self.outputs.len()];
        let mut batch = Batch::new();
        for (output, slice) in self.outputs.iter().zip(&mut numbers) {
            batch = batch.with(*output, slice);
        }
        if self.fields.iter().any(|(_, source)| matches!(source, Source::Regime)) {
            batch = batch.with_regime(&mut regimes);
        }
        let is_plain = |at: &Ratios<f64>| !at.is_damped() && !at.has_higher_static_friction();
        let ratios: Vec<_> = points.iter().map(|at| at.as_ref().map(|at| at.ratios)).collect();
        let plain: Option<Vec<_>> = ratios.iter().map(|at| at.as_ref().filter(|at| is_plain(at))).collect();
        let computed = match plain {
            Some(plain) => {
                let (omega, alpha): (Vec<_>, Vec<_>) =
                    plain.into_iter().map(|at| (at.omega(), at.alpha())).unzip();
                batch.run(&omega, &alpha)
            }
            None => batch.run_each(n, |i| ratios.get(i).copied().flatten()),
        };
        // The slices have one length.
        if computed.is_err() {
            return (0..n).map(|_| None).collect();
        }
        let row = |(i, (at, regime)): (usize, (&Option<At<F>>, &Option<Regime>))| {
            let at = at.as_ref()?;
            let number = |place: usize| {
                let value = numbers.get(place).and_then(|values| values.get(i));
                value.filter(|value| !value.is_nan()).copied()
            };
            let cell = |source: Source| match source {
                Source::Ratio(of) => Cell::Number(Some(of(&at.ratios))),
                Source::Regime => Cell::Text(regime.map_or("", Regime::name)),
                Source::Output(place) => Cell::Number(number(place)),
            };
            let row =
                Cells::of(self.fields.iter().map(|&(key, source)| (key, cell(source))).collect()).shown();
            if self.physical.is_empty() {
                return Some(row);
            }
            let physical = self.in_units(at, number)?;
            row.with_physical(physical.shown()).finite().ok()
        };
        points.iter().zip(&regimes).enumerate().map(row).collect()
    }

    /// The values in the units of the machine at a point, given those in ratios.
    fn in_units<F: Value>(&self, at: &At<F>, number: impl Fn(usize) -> Option<f64>) -> Option<Physical<F>> {
        let machine = at.point.machine.as_ref()?;
        let mut physical = Physical::of_machine(&at.given, machine);
        let own = core::mem::take(&mut physical.values);
        for &(name, kind, scaled) in &self.physical {
            let cell = match scaled {
                Scaled::Machine => own.iter().find(|(known, ..)| *known == name).map(|(_, _, cell)| *cell)?,
                Scaled::Output(place, key) => {
                    // No loop computes the largest loop at the best force ratio.
                    let unit = key.measure.size(&machine.scales);
                    Cell::Number(number(place).map(|value| F::from_f64(value) * unit))
                }
            };
            physical.values.push((name, kind, cell));
        }
        Some(physical)
    }
}
