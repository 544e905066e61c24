//! Responses of many points at once, where they are asked for outputs that a batch computes in loops. They have the
//! bits of a point alone.

use crate::bits::Value;
use crate::input;
use crate::outputs::{ALPHA, DAMPING_RATIO, Key, OMEGA, STATIC_FRICTION_RATIO};
use crate::record::{Cell, Record, Row};
use stickslip::batch::{Batch, Columns, is_looped_with_damper};
use stickslip::definitions::REGIME;
use stickslip::inputs::Given;
use stickslip::{Output, Ratios, Regime};

/// The columns of a row, all of which come from the ratios or from loops.
pub(crate) struct Looped(Vec<(Key, Source)>);

#[derive(Clone, Copy)]
enum Source {
    Ratio(fn(&Ratios<f64>) -> f64),
    Regime,
    /// The place among the loops' slices.
    Output(usize, Output),
}

impl Looped {
    /// These columns, if no other computation is needed.
    pub(crate) fn of(columns: impl Iterator<Item = Key>) -> Option<Self> {
        let mut outputs = 0;
        let columns = columns.map(|key| {
            let ratio = |of| Some((key, Source::Ratio(of)));
            match key.name {
                name if name == OMEGA.name => ratio(Ratios::omega),
                name if name == ALPHA.name => ratio(Ratios::alpha),
                name if name == DAMPING_RATIO.name => ratio(Ratios::damping_ratio),
                name if name == STATIC_FRICTION_RATIO.name => ratio(Ratios::static_friction_ratio),
                name if name == REGIME.name => Some((key, Source::Regime)),
                name => {
                    let output = Output::ALL.into_iter().find(|output| output.name() == name)?;
                    is_looped_with_damper(output).then_some(())?;
                    outputs += 1;
                    Some((key, Source::Output(outputs - 1, output)))
                }
            }
        });
        columns.collect::<Option<_>>().map(Self)
    }

    /// The ratios of a point, if they are in their domains.
    pub(crate) fn ratios<F: Value>(given: &Given<F>) -> Option<Ratios<f64>> {
        let ratios = input::point(given).ok()?.ratios;
        let at = Ratios::new(ratios.omega().to_f64(), ratios.alpha().to_f64()).ok()?;
        let at = at.with_damping_ratio(ratios.damping_ratio().to_f64()).ok()?;
        at.with_static_friction_ratio(ratios.static_friction_ratio().to_f64()).ok()
    }

    /// The rows at some points; `None` for those without ratios.
    pub(crate) fn records(&self, points: &[Option<Ratios<f64>>]) -> Vec<Option<Row>> {
        let (n, mut regimes) = (points.len(), vec![None; points.len()]);
        let outputs = self.0.iter().filter_map(|(_, source)| match source {
            Source::Output(_, output) => Some(*output),
            Source::Ratio(_) | Source::Regime => None,
        });
        let mut numbers: Vec<_> = outputs.map(|output| (output, vec![f64::NAN; n])).collect();
        let mut columns = Columns::new();
        for (output, slice) in &mut numbers {
            columns = columns.with(*output, slice);
        }
        if self.0.iter().any(|(_, source)| matches!(source, Source::Regime)) {
            columns = columns.with_regime(&mut regimes);
        }
        let is_plain = |at: &Ratios<f64>| !at.is_damped() && !at.has_higher_static_friction();
        let plain: Option<Vec<_>> = points.iter().map(|at| at.as_ref().filter(|at| is_plain(at))).collect();
        let computed = match plain {
            Some(plain) => {
                let (omega, alpha): (Vec<_>, Vec<_>) =
                    plain.into_iter().map(|at| (at.omega(), at.alpha())).unzip();
                Batch::new().run(&omega, &alpha, columns)
            }
            None => Batch::new().run_each(n, |i| points.get(i).copied().flatten(), columns),
        };
        // The slices have one length.
        if computed.is_err() {
            return (0..n).map(|_| None).collect();
        }
        let row = |(i, (at, regime)): (usize, (&Option<Ratios<f64>>, &Option<Regime>))| {
            let at = at.as_ref()?;
            let cell = |source: Source| match source {
                Source::Ratio(of) => Cell::Number(Some(of(at))),
                Source::Regime => Cell::Text(regime.map_or("", Regime::name)),
                Source::Output(place, _) => {
                    let value = numbers.get(place).and_then(|(_, values)| values.get(i));
                    Cell::Number(value.filter(|value| !value.is_nan()).copied())
                }
            };
            Some(Record::of(self.0.iter().map(|&(key, source)| (key, cell(source))).collect()).shown())
        };
        points.iter().zip(&regimes).enumerate().map(row).collect()
    }
}
