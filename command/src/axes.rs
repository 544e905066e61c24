//! Points over grids: each argument is a single value or a grid of values.

use crate::bits::{Value, all_digits};
use crate::failure::{Failure, Outcome};
use crate::given::note_percentage;
use crate::grid::Grid;
use stickslip::inputs::units::Reader;
use stickslip::inputs::{Given, Input, Naming};

/// The points of all grids, each computed from its number alone; the last grid varies fastest.
#[derive(Clone)]
pub(crate) struct Axes<F> {
    fixed: Given<F>,
    grids: Vec<(Input, Grid<F>)>,
}

impl<F: Value> Axes<F> {
    /// The typed parameters that the command uses.
    pub(crate) fn new(typed: &[(Input, String)], reader: &Reader) -> Result<Self, Failure> {
        let (mut fixed, mut grids) = (Given::empty(reader, Naming::Option), Vec::new());
        for &(parameter, ref text) in typed {
            let grid = Grid::with_units(parameter.option(), text, reader, parameter.kind())?;
            note_percentage(parameter, text, grid.ends().1);
            if grid.len() == 1 {
                fixed.set_typed(parameter, grid.value(0), text);
            } else {
                grids.push((parameter, grid));
            }
        }
        Ok(Self { fixed, grids })
    }

    /// The number of points.
    pub(crate) fn len(&self) -> u64 {
        self.grids.iter().fold(1, |product, (_, grid)| product.saturating_mul(grid.len()))
    }

    /// The grids, slowest first.
    pub(crate) fn grids(&self) -> &[(Input, Grid<F>)] {
        &self.grids
    }

    /// Whether the points are those of a machine.
    pub(crate) fn is_physical(&self) -> bool {
        self.fixed.is_physical() || self.grids.iter().any(|(parameter, _)| parameter.is_physical())
    }

    /// Whether a parameter is given, as one value or as a grid.
    pub(crate) fn has(&self, parameter: Input) -> bool {
        self.fixed.has(parameter) || self.grids.iter().any(|(p, _)| *p == parameter)
    }

    /// Replaces a single value, or none, by a grid.
    pub(crate) fn make_grid(&mut self, parameter: Input, grid: Grid<F>) {
        if let Some(value) = self.fixed.take(parameter) {
            self.grids.push((parameter, Grid::List(vec![value])));
        } else {
            self.grids.push((parameter, grid));
        }
    }

    /// Puts the grids in another order.
    pub(crate) fn order<const N: usize>(&mut self, grids: [(Input, Grid<F>); N]) {
        self.grids = grids.into();
    }

    /// The given quantities at a point below [`Axes::len`].
    pub(crate) fn given_at(&self, point: u64) -> Given<F> {
        let mut given = self.fixed.clone();
        self.each(point, |parameter, value| given.set(parameter, value));
        given
    }

    /// The given quantities at a point below [`Axes::len`], each value with its text for messages.
    pub(crate) fn named_at(&self, point: u64) -> Given<F> {
        let mut given = self.fixed.clone();
        self.each(point, |parameter, value| {
            given.set_typed(parameter, value, &all_digits(value));
        });
        given
    }

    fn each(&self, point: u64, mut take: impl FnMut(Input, F)) {
        let mut rest = point;
        for (parameter, grid) in self.grids.iter().rev() {
            take(*parameter, grid.value(rest % grid.len()));
            rest /= grid.len();
        }
    }

    /// Applies a check to every combination of the ends of the grids.
    ///
    /// Ω, α and the scales are monotone in each parameter, and their domains are intervals, so that these
    /// points suffice.
    pub(crate) fn at_ends(&self, mut check: impl FnMut(&Given<F>) -> Outcome) -> Outcome {
        for corner in 0..1u64 << self.grids.len() {
            let mut given = self.fixed.clone();
            for (i, (parameter, grid)) in self.grids.iter().enumerate() {
                let (low, high) = grid.ends();
                let value = if corner >> i & 1 == 0 { low } else { high };
                given.set_typed(*parameter, value, &all_digits(value));
            }
            check(&given)?;
        }
        Ok(())
    }
}
