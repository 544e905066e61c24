//! Contacts whose directions are dependent: when a set of them can hold, whatever their shares of the force.
//!
//! Contacts that stick hold any force `Σ bᵢTᵢ` with |Tᵢ| ≤ Rᵢ: a zonotope. They hold until the force that is due leaves it
//! through a facet. The normals u of the facets are those with a vector `gᵢ = u·bᵢ` of least support (the cocircuits of the
//! directions), and the inequality of a facet is
//!
//! `Σ gᵢ Tᵢ ≤ Σ |gᵢ| Rᵢ`,
//!
//! whose left side is the same for all shares of one force. Beyond the facet exactly the contacts with gᵢ ≠ 0 slide,
//! in the directions of gᵢ. Independent directions have one such vector a contact, with one entry, and the inequality is
//! |T| ≤ R.
//!
//! Parallel directions are one, and a direction that no other depends on stands alone. The vectors of the rest are found
//! by trying all sets of rank − 1 directions: g vanishes there and is unique.

use super::matrix::{Matrix, add_times, dot};
use crate::float::Float;
use alloc::vec;
use alloc::vec::Vec;

/// The most directions that depend on each other, parallel ones counted once.
pub(crate) const MOST_DEPENDENT: usize = 14;

/// The reduced echelon form of a matrix, with the pivots' columns. Entries within rounding of zero are zero.
fn reduced<F: Float>(rows: &[Vec<F>]) -> (Vec<Vec<F>>, Vec<usize>) {
    let mut rows = rows.to_vec();
    let columns = rows.first().map_or(0, Vec::len);
    let largest = rows.iter().flatten().fold(F::int(0), |m, x| m.or_larger(x.abs()));
    let least = largest * F::epsilon() * F::int(1024);
    let mut pivots = Vec::new();
    for column in 0..columns {
        let rank = pivots.len();
        let size = |row: &Vec<F>| row.get(column).map_or(F::int(0), |x| x.abs());
        let best = rows.iter().enumerate().skip(rank).fold((F::int(0), rank), |(most, place), (i, row)| {
            if size(row) > most { (size(row), i) } else { (most, place) }
        });
        if best.0 <= least {
            for row in rows.iter_mut().skip(rank) {
                if let Some(x) = row.get_mut(column) {
                    *x = F::int(0);
                }
            }
            continue;
        }
        rows.swap(rank, best.1);
        let Some(mut pivot) = rows.get(rank).cloned() else { break };
        let by = pivot.get(column).copied().unwrap_or(F::int(1));
        pivot.iter_mut().for_each(|x| *x = *x / by);
        for (i, row) in rows.iter_mut().enumerate() {
            if i == rank {
                row.clone_from(&pivot);
            } else if let Some(&factor) = row.get(column) {
                add_times(row, -factor, &pivot);
                row.iter_mut()
                    .filter(|x| x.abs() <= F::epsilon() * F::int(1024))
                    .for_each(|x| *x = F::int(0));
            }
        }
        pivots.push(column);
        if pivots.len() == rows.len() {
            break;
        }
    }
    rows.truncate(pivots.len());
    (rows, pivots)
}

/// A matrix whose columns are these lists, each divided by its largest entry, with these entries.
fn columns<F: Float>(lists: &[&[F]]) -> (Vec<Vec<F>>, Vec<F>) {
    let sizes: Vec<F> =
        lists.iter().map(|list| list.iter().fold(F::int(0), |m, x| m.or_larger(x.abs()))).collect();
    let length = lists.first().map_or(0, |list| list.len());
    let entry = |list: &[F], size: F, k: usize| list.get(k).map_or(F::int(0), |&x| x / size);
    let rows =
        (0..length).map(|k| lists.iter().zip(&sizes).map(|(l, &s)| entry(l, s, k)).collect()).collect();
    (rows, sizes)
}

/// The number of independent ones.
pub(crate) fn rank<F: Float>(lists: &[&[F]]) -> usize {
    reduced(&columns(lists).0).1.len()
}

/// Parallel directions: their places, with their factors.
type Group<F> = Vec<(usize, F)>;

/// The directions that depend on others: groups of parallel ones, with their factors, and the matrix of the groups in
/// reduced form.
struct Rest<F> {
    groups: Vec<Group<F>>,
    rows: Vec<Vec<F>>,
}

/// The directions that stand alone, in groups of parallel ones, and the rest.
fn parted<F: Float>(directions: &[&[F]]) -> (Vec<Group<F>>, Rest<F>) {
    let (matrix, sizes) = columns(directions);
    let (rows, _) = reduced(&matrix);
    let column =
        |j: usize| -> Vec<F> { rows.iter().map(|row| row.get(j).copied().unwrap_or(F::int(0))).collect() };
    let zero = F::int(0);
    // Parallel columns: the factor of a column relative to its group's first.
    let mut groups: Vec<(Vec<F>, Group<F>)> = Vec::new();
    for (j, &size) in sizes.iter().enumerate() {
        let own = column(j);
        let factor = |first: &[F]| {
            let place = first.iter().position(|&x| x != zero)?;
            let ratio = *own.get(place)? / *first.get(place)?;
            let near = |(&x, &y): (&F, &F)| (y - ratio * x).abs() <= F::epsilon() * F::int(4096);
            (ratio != zero && first.iter().zip(&own).all(near)).then_some(ratio)
        };
        let found = groups.iter_mut().find_map(|(first, group)| factor(first).map(|r| (group, r)));
        match found {
            Some((group, ratio)) => group.push((j, ratio * size)),
            None => groups.push((own, vec![(j, size)])),
        }
    }
    let firsts: Vec<&[F]> = groups.iter().map(|(first, _)| first.as_slice()).collect();
    let (rows, pivots) = reduced(&columns(&firsts).0);
    // `columns` has divided each group's first column by its largest entry.
    let scales: Vec<F> = firsts.iter().map(|f| f.iter().fold(zero, |m, x| m.or_larger(x.abs()))).collect();
    let alone = |row: &Vec<F>| row.iter().filter(|x| **x != zero).count() == 1;
    let free: Vec<usize> =
        rows.iter().zip(&pivots).filter(|(row, _)| alone(row)).map(|(_, &pivot)| pivot).collect();
    let scaled = |j: usize| -> Group<F> {
        let scale = scales.get(j).copied().unwrap_or(F::int(1));
        groups.get(j).map_or_else(Vec::new, |(_, group)| group.iter().map(|&(i, x)| (i, x * scale)).collect())
    };
    let others: Vec<usize> = (0..groups.len()).filter(|j| !free.contains(j)).collect();
    let rest = rows
        .iter()
        .filter(|row| !alone(row))
        .map(|row| others.iter().filter_map(|&j| row.get(j).copied()).collect())
        .collect();
    (
        free.into_iter().map(scaled).collect(),
        Rest { groups: others.into_iter().map(scaled).collect(), rows: rest },
    )
}

/// Whether too many of these directions depend on each other.
pub(crate) fn too_many<F: Float>(directions: &[&[F]]) -> bool {
    parted(directions).1.groups.len() > MOST_DEPENDENT
}

/// The vectors g of least support: for each facet, up to its sign, the places of the directions with their gᵢ.
pub(crate) fn facets<F: Float>(directions: &[&[F]]) -> Vec<Group<F>> {
    let (mut facets, rest) = parted(directions);
    let (rank, count) = (rest.rows.len(), rest.groups.len());
    if rank == 0 || count > MOST_DEPENDENT {
        return facets;
    }
    let mut supports: Vec<u32> = Vec::new();
    for set in 0..1_u32 << count {
        if set.count_ones() as usize != rank - 1 {
            continue;
        }
        let chosen: Vec<usize> = (0..count).filter(|&j| set >> j & 1 == 1).collect();
        let Some(g) = vanishing(&rest.rows, &chosen, count) else { continue };
        let support = (0..count).filter(|&j| g.get(j).is_some_and(|&x| x != F::int(0)));
        let support = support.fold(0, |bits, j| bits | 1_u32 << j);
        if supports.contains(&support) {
            continue;
        }
        supports.push(support);
        let members = rest.groups.iter().zip(&g).filter(|(_, x)| **x != F::int(0));
        facets.push(members.flat_map(|(group, &x)| group.iter().map(move |&(i, f)| (i, x * f))).collect());
    }
    facets
}

/// The combination of the rows that vanishes at these columns, where it is unique.
fn vanishing<F: Float>(rows: &[Vec<F>], at: &[usize], count: usize) -> Option<Vec<F>> {
    // One row for each column, the unknowns are the rows' factors.
    let conditions: Vec<Vec<F>> = at
        .iter()
        .map(|&j| rows.iter().map(|row| row.get(j).copied().unwrap_or(F::int(0))).collect())
        .collect();
    let (solved, pivots) = reduced(&conditions);
    if pivots.len() + 1 != rows.len() {
        return None;
    }
    let open = (0..rows.len()).find(|k| !pivots.contains(k))?;
    let mut g = vec![F::int(0); count];
    for (k, row) in rows.iter().enumerate() {
        let factor = match pivots.iter().position(|&p| p == k) {
            Some(place) => -solved.get(place)?.get(open).copied()?,
            None => F::int(1),
        };
        add_times(&mut g, factor, row);
    }
    let largest = g.iter().fold(F::int(0), |m, x| m.or_larger(x.abs()));
    let least = largest * F::epsilon() * F::int(4096);
    g.iter_mut().filter(|x| x.abs() <= least).for_each(|x| *x = F::int(0));
    Some(g)
}

/// The forces that make `½ Tᵀ G T − aᵀ T` least within `low ≤ T ≤ high`. Where it falls without end, the error is a direction
/// in which it does; it is empty where rounding has no end.
///
/// G is positive semidefinite. A set of forces is free and the others are at a bound; the free ones go to their least value or
/// to the first bound on the way. Each round lowers the value, so that it ends. `doubt` is the rounding of a.
pub(crate) fn least<F: Float>(
    matrix: &Matrix<F>,
    a: &[F],
    doubt: &[F],
    low: &[Option<F>],
    high: &[Option<F>],
) -> Result<Vec<F>, Vec<F>> {
    let (count, zero, one) = (a.len(), F::int(0), F::int(1));
    let bound = |list: &[Option<F>], i: usize| list.get(i).copied().flatten();
    if let ([a], true) = (a, matrix.at(0, 0) > zero) {
        // One force alone: the bound next to the least value, which takes no search.
        let force = one / matrix.at(0, 0) * *a;
        let below = bound(low, 0).filter(|&low| force < low);
        return Ok(vec![bound(high, 0).filter(|&high| force > high).or(below).unwrap_or(force)]);
    }
    let mut force: Vec<F> = (0..count)
        .map(|i| {
            let above = bound(low, i).map_or(zero, |l| l.or_larger(zero));
            bound(high, i).map_or(above, |h| if h < above { h } else { above })
        })
        .collect();
    let mut fixed: Vec<Option<bool>> = vec![None; count];
    let left = |force: &[F]| -> Vec<F> {
        a.iter().zip(matrix.rows()).map(|(&a, row)| a - dot(row, force)).collect()
    };
    for _ in 0..(64 + 32 * count * count) {
        let free: Vec<usize> = (0..count).filter(|&i| fixed.get(i) == Some(&None)).collect();
        let gradient = left(&force);
        if !free.is_empty() {
            let mut part = Matrix::zero(free.len(), free.len());
            for (k, &i) in free.iter().enumerate() {
                free.iter().enumerate().for_each(|(l, &j)| part.set(k, l, matrix.at(i, j)));
            }
            let right: Vec<F> = free.iter().filter_map(|&i| gradient.get(i).copied()).collect();
            let mut way = part.pseudo_inverse().of(&right);
            let missed: Vec<F> = right.iter().zip(part.of(&way)).map(|(&r, x)| r - x).collect();
            // A part of a outside of the range of G: down without end.
            // The error of the solution is one of its size, not one of each row's.
            let sure = free.iter().zip(part.rows()).zip(&right).fold(zero, |most, ((&i, row), r)| {
                let own = doubt.get(i).copied().unwrap_or(zero) + r.abs() * F::epsilon() * F::int(256);
                most.or_larger(own + rounding(row, &way) + rounding(matrix.row(i), &force))
            });
            let endless = missed.iter().any(|m| m.abs() > sure);
            if endless {
                way = missed;
            }
            let mut first: Option<(F, usize, bool)> = None;
            for (&i, &step) in free.iter().zip(&way) {
                let upward = step > zero;
                let end = if upward { bound(high, i) } else { bound(low, i) };
                if step == zero {
                    continue;
                }
                let Some(end) = end else { continue };
                let share = (end - force.get(i).copied().unwrap_or(zero)) / step;
                let share = if share > zero { share } else { zero };
                if (endless || share < one) && first.is_none_or(|(least, ..)| share < least) {
                    first = Some((share, i, upward));
                }
            }
            let share = match first {
                Some((share, ..)) => share,
                None if endless => {
                    let mut direction = vec![zero; count];
                    for (&i, &step) in free.iter().zip(&way) {
                        if let Some(place) = direction.get_mut(i) {
                            *place = step;
                        }
                    }
                    return Err(direction);
                }
                None => one,
            };
            for (&i, &step) in free.iter().zip(&way) {
                if let Some(force) = force.get_mut(i) {
                    *force = *force + share * step;
                }
            }
            if let Some((_, i, upward)) = first {
                if let (Some(place), Some(force)) = (fixed.get_mut(i), force.get_mut(i)) {
                    *place = Some(upward);
                    *force = bound(if upward { high } else { low }, i).unwrap_or(*force);
                }
                continue;
            }
        }
        // All free ones are at their least: is there one at a bound that would leave it?
        let gradient = left(&force);
        let mut worst: Option<(F, usize)> = None;
        for (i, place) in fixed.iter().enumerate() {
            let (Some(upward), Some(&g), Some(&doubt)) = (*place, gradient.get(i), doubt.get(i)) else {
                continue;
            };
            let excess = if upward { -g } else { g } - doubt - rounding(matrix.row(i), &force);
            if excess > zero && worst.is_none_or(|(most, _)| excess > most) {
                worst = Some((excess, i));
            }
        }
        let Some((_, i)) = worst else { return Ok(force) };
        if let Some(place) = fixed.get_mut(i) {
            *place = None;
        }
    }
    Err(Vec::new())
}

/// The rounding of a row's product with forces that are known to the rounding of the largest.
pub(crate) fn rounding<F: Float>(row: &[F], force: &[F]) -> F {
    let sum = row.iter().fold(F::int(0), |sum, x| sum + x.abs());
    let largest = force.iter().fold(F::int(0), |most, x| most.or_larger(x.abs()));
    sum * largest * F::epsilon() * F::int(256)
}
