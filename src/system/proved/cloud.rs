//! A set of states that linear maps move without wrapping: `centre + Q e`, where Q is nearly orthonormal and `|e| ≤ spread` entry by entry
//! (Lohner's method).

use super::machine::{Number, Row, dot, identity, unit};
use crate::float::Field;
use crate::float::ball::Radius;
use alloc::vec::Vec;

#[derive(Debug, Clone)]
pub(super) struct Cloud {
    /// Exact numbers.
    pub(super) centre: Row,
    /// The columns of Q, exact numbers.
    pub(super) frame: Vec<Row>,
    pub(super) spread: Vec<Radius>,
}

/// The size of a number, at most.
pub(super) fn above(x: &Number) -> Radius {
    if x.is_entire() { Radius::INFINITE } else { Radius::above(x.mid()).plus(x.rad()) }
}

/// ± a radius.
pub(super) fn around_zero(rad: Radius) -> Number {
    Number::new(Number::int(0).mid(), rad)
}

impl Cloud {
    /// All states of a box.
    pub(super) fn of_box(states: &[Number]) -> Self {
        let centre = states.iter().map(|x| Number::exact(x.mid())).collect();
        Self { centre, frame: identity(states.len()), spread: states.iter().map(Number::rad).collect() }
    }

    /// A box that contains the states.
    pub(super) fn hull(&self) -> Row {
        let mut reach: Vec<Radius> = self.centre.iter().map(|_| Radius::ZERO).collect();
        for (column, spread) in self.frame.iter().zip(&self.spread) {
            for (reach, q) in reach.iter_mut().zip(column) {
                *reach = reach.plus(above(q).times(*spread));
            }
        }
        self.centre.iter().zip(reach).map(|(centre, reach)| Number::new(centre.mid(), reach)).collect()
    }

    /// The states `centre + frame e`: a set like this one, whose centre and columns are given as balls.
    pub(super) fn moved(&self, centre: &[Number], frame: &[Row]) -> Self {
        let order = self.order(frame);
        let columns: Vec<&Row> = order.iter().filter_map(|&i| frame.get(i)).collect();
        let spread: Vec<Radius> = order.iter().filter_map(|&i| self.spread.get(i)).copied().collect();
        let size = centre.len();
        let basis = orthonormal(&columns, size);
        // Q⁻¹ = (1 + D)⁻¹ Qᵀ with D = QᵀQ − 1.
        let mut doubt = Radius::ZERO;
        for (i, a) in basis.iter().enumerate() {
            let row = basis.iter().enumerate().map(|(j, b)| {
                let due = Number::int(i32::from(i == j));
                above(&(dot(a, b) - due))
            });
            doubt = doubt.max(row.fold(Radius::ZERO, Radius::plus));
        }
        let share = doubt.over(Radius::ONE.minus_down(doubt));
        let errors: Vec<Radius> = centre.iter().map(Number::rad).collect();
        let along = |q: &Row| {
            let own =
                columns.iter().zip(&spread).map(|(column, spread)| above(&dot(q, column)).times(*spread));
            let error = q.iter().zip(&errors).map(|(q, error)| above(q).times(*error));
            own.chain(error).fold(Radius::ZERO, Radius::plus)
        };
        let inner: Vec<Radius> = basis.iter().map(along).collect();
        let most = inner.iter().copied().fold(Radius::ZERO, Radius::max).times(share);
        Self {
            centre: centre.iter().map(|x| Number::exact(x.mid())).collect(),
            frame: basis,
            spread: inner.into_iter().map(|x| x.plus(most)).collect(),
        }
    }

    /// The columns by the length of their part of the set, longest first.
    fn order(&self, frame: &[Row]) -> Vec<usize> {
        let length = |(i, column): (usize, &Row)| {
            let reach = column.iter().map(above).fold(Radius::ZERO, Radius::plus);
            (i, reach.times(self.spread.get(i).copied().unwrap_or(Radius::ZERO)))
        };
        let mut lengths: Vec<(usize, Radius)> = frame.iter().enumerate().map(length).collect();
        lengths.sort_by(|a, b| b.1.partial_cmp(&a.1).unwrap_or(core::cmp::Ordering::Equal));
        lengths.into_iter().map(|(i, _)| i).collect()
    }
}

/// Nearly orthonormal vectors of exact numbers, of which the first span the columns, nearly.
fn orthonormal(columns: &[&Row], size: usize) -> Vec<Row> {
    let mut basis: Vec<Row> = Vec::with_capacity(size);
    let units: Vec<Row> = (0..size).map(|i| unit(size, i)).collect();
    // Columns that others span, and unit vectors in their place: what is left of one must be a part of it.
    for (column, least) in
        columns.iter().map(|c| (*c, -40)).chain(units.iter().map(|c| (c, -3 - size.ilog2().cast_signed())))
    {
        if basis.len() == size {
            break;
        }
        let before = length(column);
        let mut rest: Row = column.iter().map(|x| Number::exact(x.mid())).collect();
        // Twice is enough.
        for _ in 0..2 {
            for q in &basis {
                let by = dot(q, &rest);
                rest = rest.iter().zip(q).map(|(x, q)| Number::exact((*x - by * *q).mid())).collect();
            }
        }
        let after = length(&rest);
        let is_part = !Radius::below(after.mid()).is_zero()
            && Radius::below(after.mid()) > Radius::above(before.mid()).scaled(i64::from(least));
        if is_part {
            basis.push(rest.iter().map(|x| Number::exact((*x / after).mid())).collect());
        }
    }
    // A set that is not of full size would be no enclosure.
    if basis.len() < size {
        return units;
    }
    basis
}

fn length(column: &[Number]) -> Number {
    let sum = column.iter().fold(Number::int(0), |sum, x| sum + Number::exact(x.mid()).square());
    Number::exact(Number::exact(sum.mid()).sqrt().mid())
}
