//! Points over grids: what was given, each argument one value or a grid of them.

use crate::args::{ForceArgs, MachineArgs};
use crate::bits::Value;
use crate::failure::{Failure, Outcome};
use crate::given::{Given, Parameter};
use crate::grid::Grid;
use crate::note;
use stickslip::units::Reader;

/// The points of all grids, each made from its number alone: the last grid is the fast one.
pub(crate) struct Axes<F> {
    fixed: Given<F>,
    grids: Vec<(Parameter, Grid<F>)>,
}

impl<F: Value> Axes<F> {
    /// What was typed, of the parameters that are of use.
    pub(crate) fn new(machine: &MachineArgs, force: &ForceArgs, reader: &Reader) -> Result<Self, Failure> {
        let (mut fixed, mut grids) = (Given::empty(reader.system()), Vec::new());
        for (parameter, text) in Given::<F>::typed(machine, force) {
            let grid = Grid::with_units(parameter.option(), text, reader, parameter.kind())?;
            if grid.len() == 1 {
                fixed.set_typed(parameter, grid.value(0), text);
            } else {
                grids.push((parameter, grid));
            }
        }
        Ok(Self { fixed, grids })
    }

    /// How many points there are.
    pub(crate) fn len(&self) -> u64 {
        self.grids.iter().fold(1, |product, (_, grid)| product.saturating_mul(grid.len()))
    }

    /// The grids, the slow one first.
    pub(crate) fn grids(&self) -> &[(Parameter, Grid<F>)] {
        &self.grids
    }

    /// Whether any of its points is of a machine.
    pub(crate) fn is_physical(&self) -> bool {
        self.fixed.is_physical() || self.grids.iter().any(|(parameter, _)| parameter.is_physical())
    }

    /// Whether it is given, as one value or as many.
    pub(crate) fn has(&self, parameter: Parameter) -> bool {
        self.fixed.has(parameter) || self.grids.iter().any(|(p, _)| *p == parameter)
    }

    /// Has a grid where one value, or none, was.
    pub(crate) fn make_grid(&mut self, parameter: Parameter, grid: Grid<F>) {
        if let Some(value) = self.fixed.take(parameter) {
            self.grids.push((parameter, Grid::List(vec![value])));
        } else {
            self.grids.push((parameter, grid));
        }
    }

    /// The same grids in another order.
    pub(crate) fn order<const N: usize>(&mut self, grids: [(Parameter, Grid<F>); N]) {
        self.grids = grids.into();
    }

    /// What is given at a point below [`Axes::len`].
    pub(crate) fn at(&self, point: u64) -> Given<F> {
        let mut given = self.fixed.clone();
        self.each(point, |parameter, value| given.set(parameter, value));
        given
    }

    /// The same with each value as text, for a message.
    pub(crate) fn named_at(&self, point: u64) -> Given<F> {
        let mut given = self.fixed.clone();
        self.each(point, |parameter, value| {
            given.set_typed(parameter, value, &note::all_digits(value));
        });
        given
    }

    fn each(&self, point: u64, mut take: impl FnMut(Parameter, F)) {
        let mut rest = point;
        for (parameter, grid) in self.grids.iter().rev() {
            take(*parameter, grid.value(rest % grid.len()));
            rest /= grid.len();
        }
    }

    /// Holds a check against the points that bound all others: every combination of the ends of the grids.
    ///
    /// Ω, α and the scales rise or fall with each parameter, and their domains are intervals: so these points
    /// decide.
    pub(crate) fn at_ends(&self, mut check: impl FnMut(&Given<F>) -> Outcome) -> Outcome {
        for corner in 0..1u64 << self.grids.len() {
            let mut given = self.fixed.clone();
            for (i, (parameter, grid)) in self.grids.iter().enumerate() {
                let (low, high) = grid.ends();
                let value = if corner >> i & 1 == 0 { low } else { high };
                given.set_typed(*parameter, value, &note::all_digits(value));
            }
            check(&given)?;
        }
        Ok(())
    }
}
