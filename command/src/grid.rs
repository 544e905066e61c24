//! Evenly spaced values or a list in place of one value, and the points over several of them.

use crate::bits::{Value, all_digits};
use crate::failure::{Failure, Outcome};
use crate::input::note_unusual;
use stickslip_draw::Axis;
use stickslip_front::grid::Range;
use stickslip_front::inputs::units::{Kind, Reader};
use stickslip_front::inputs::{Given, Input, Naming};

/// The values of one argument.
#[derive(Debug, Clone)]
pub(crate) enum Grid<F> {
    Even(Range<F>),
    List(Vec<F>),
}

/// The greatest number of values of one argument.
const MOST: u64 = 1_000_000_000;

impl<F: Value> Grid<F> {
    /// `FROM:TO:COUNT`, `FROM:TO:COUNT:log` or `A,B,C`.
    pub(crate) fn parse(name: &str, text: &str) -> Result<Self, Failure> {
        let number = |part: &str| {
            let bad = || Failure::Input(format!("{name} {text}: each value must be a number"));
            part.trim().parse().map_err(|_| bad())
        };
        Self::read(name, text, number)
    }

    /// `FROM:TO:COUNT`, `FROM:TO:COUNT:log` or `A,B,C` with units: all values have units, or none.
    pub(crate) fn with_units(name: &str, text: &str, reader: &Reader, kind: Kind) -> Result<Self, Failure> {
        let ends: Vec<&str> = match text.split_once(':') {
            Some((from, rest)) => [from].into_iter().chain(rest.split(':').next()).collect(),
            None => text.split(',').collect(),
        };
        let with_unit = ends.iter().filter(|part| Reader::has_unit(part)).count();
        if with_unit != 0 && with_unit != ends.len() {
            return Err(format!("{name} {text}: give each value a unit, or none").into());
        }
        let about =
            |e: Failure, part: &str| if part == text { e } else { e.about(&format!("{name} {text}")) };
        Self::read(name, text, |part| reader.value(name, part, kind).map_err(|e| about(e.into(), part)))
    }

    fn read(name: &str, text: &str, number: impl Fn(&str) -> Result<F, Failure>) -> Result<Self, Failure> {
        let bad = |what: &str| Failure::Input(format!("{name} {text}: {what}"));
        if let Some(range) = Range::typed(text, MOST).map_err(|what| bad(&what))? {
            return range.between(number(range.from)?, number(range.to)?).map_err(bad).map(Self::Even);
        }
        let value = |part: &str| -> Result<F, Failure> {
            let value: F = number(part)?;
            if value.is_finite() { Ok(value) } else { Err(bad("each value must be finite")) }
        };
        text.split(',').map(value).collect::<Result<_, _>>().map(Self::List)
    }

    pub(crate) fn len(&self) -> u64 {
        match self {
            Self::Even(range) => range.count,
            Self::List(values) => values.len() as u64,
        }
    }

    /// The value at a place below [`Grid::len`], which depends on the place alone.
    pub(crate) fn value(&self, place: u64) -> F {
        match self {
            Self::List(values) => values.get(place as usize).copied().unwrap_or(F::int(0)),
            Self::Even(range) => range.value(place),
        }
    }

    /// The least and the greatest value.
    pub(crate) fn ends(&self) -> (F, F) {
        let values = match self {
            Self::Even(range) => &[range.from, range.to],
            Self::List(values) => values.as_slice(),
        };
        let first = values.first().copied().unwrap_or(F::int(0));
        values.iter().fold((first, first), |(low, high), &value| {
            (if value < low { value } else { low }, if value > high { value } else { high })
        })
    }

    /// Whether the grid is logarithmic.
    pub(crate) const fn is_logarithmic(&self) -> bool {
        matches!(self, Self::Even(Range { is_logarithmic: true, .. }))
    }

    /// An axis over the values.
    pub(crate) fn axis(&self, label: &str, ends: (f64, f64)) -> Axis {
        Axis::new(label, ends, self.is_logarithmic())
    }

    /// All values.
    pub(crate) fn values(&self) -> impl Iterator<Item = F> + '_ {
        (0..self.len()).map(|place| self.value(place))
    }
}

impl Grid<f64> {
    /// The place at a part of the way from the least value to the greatest.
    pub(crate) fn at(&self, share: f64) -> f64 {
        self.moved(self.ends().0, share)
    }

    /// A place moved by a part of that way.
    pub(crate) fn moved(&self, from: f64, share: f64) -> f64 {
        let (low, high) = self.ends();
        if self.is_logarithmic() { from * (high / low).powf(share) } else { from + (high - low) * share }
    }
}

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
            note_unusual(parameter, text, grid.ends().1, &reader.system());
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
        self.at(point, |given, parameter, value| given.set(parameter, value))
    }

    /// The given quantities at a point, each value with its text for messages.
    pub(crate) fn named_at(&self, point: u64) -> Given<F> {
        self.at(point, |given, parameter, value| given.set_typed(parameter, value, &all_digits(value)))
    }

    fn at(&self, point: u64, set: fn(&mut Given<F>, Input, F)) -> Given<F> {
        let (mut given, mut rest) = (self.fixed.clone(), point);
        for (parameter, grid) in self.grids.iter().rev() {
            set(&mut given, *parameter, grid.value(rest % grid.len()));
            rest /= grid.len();
        }
        given
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

#[cfg(test)]
mod tests {
    use super::Grid;

    fn values(text: &str) -> Vec<f64> {
        Grid::parse("--omega", text).ok().unwrap().values().collect()
    }

    #[test]
    fn the_ends_are_exact_and_the_rest_even() {
        assert_eq!(values("0.5:2:4"), [0.5, 1.0, 1.5, 2.0]);
        assert_eq!(values("2:1:3"), [2.0, 1.5, 1.0]);
        assert_eq!(values("0.1,3,0.7"), [0.1, 3.0, 0.7]);
        let log = values("0.1:10:3:log");
        assert!(log[0] == 0.1 && (log[1] - 1.0f64).abs() < 1e-15 && log[2] == 10.0);
        assert_eq!(values("3:3:1"), [3.0]);
        assert_eq!(values("0.1:0.2:3"), [0.1, 0.15, 0.2]);
        assert_eq!(values("0.1:0.7:7"), [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7]);
        assert_eq!(values("0:1:4")[1], 1.0 / 3.0);
        for bad in ["", "1:2", "1:2:0", "1:2:x", "1:2:3:lin", "0:2:3:log", "1:2:1", "nan", "1,,2", "1:inf:3"]
        {
            assert!(Grid::<f64>::parse("--omega", bad).is_err(), "{bad}");
        }
    }
}
