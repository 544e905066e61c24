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
//! Where each direction joins two bodies, or a body and the ground, the contacts are the edges of a graph, and the vectors are its bonds: u is 1 on
//! a connected set of bodies whose complement is connected, too, and 0 elsewhere. They are found set by set, so that a ring or a
//! storeyed chain of many contacts has few.
//!
//! Otherwise parallel directions are one, and a direction that no other depends on stands alone. The vectors of the rest are found
//! by trying all sets of rank − 1 directions: g vanishes there and is unique.

use super::matrix::{Matrix, add_times, dot};
use crate::float::Float;
use alloc::vec;
use alloc::vec::Vec;

/// The most directions that depend on each other, parallel ones counted once.
pub(crate) const MOST_DEPENDENT: usize = 14;

/// The most connected sets of bodies that are looked at.
const MOST_SETS: usize = 20_000;

/// The ends of each direction, where each is a multiple of `q_i − q_j` or of one coordinate: then its other end is the ground, whose place is
/// behind that of the last coordinate.
fn network<F: Float>(directions: &[&[F]]) -> Option<Vec<[usize; 2]>> {
    let ends = |direction: &&[F]| {
        let mut entries = direction.iter().enumerate().filter(|(_, x)| **x != F::int(0));
        let (i, &a) = entries.next()?;
        match (entries.next(), entries.next()) {
            (None, _) => Some([i, direction.len()]),
            (Some((j, &b)), None) if a + b == F::int(0) => Some([i, j]),
            _ => None,
        }
    };
    directions.iter().map(ends).collect()
}

/// A graph by the neighbours of each vertex.
struct Graph {
    neighbours: Vec<Vec<usize>>,
}

impl Graph {
    fn new(edges: &[[usize; 2]]) -> Self {
        let count = edges.iter().flatten().map(|&v| v.saturating_add(1)).max().unwrap_or(0);
        let mut neighbours = vec![Vec::new(); count];
        for &[a, b] in edges {
            for (from, to) in [(a, b), (b, a)] {
                if let Some(list) = neighbours.get_mut(from)
                    && !list.contains(&to)
                {
                    list.push(to);
                }
            }
        }
        Self { neighbours }
    }

    fn of(&self, vertex: usize) -> &[usize] {
        self.neighbours.get(vertex).map_or(&[], Vec::as_slice)
    }

    /// The vertices that can be reached from one without leaving those allowed.
    fn reached(&self, from: usize, allowed: impl Fn(usize) -> bool) -> Vec<usize> {
        let mut seen = vec![from];
        let mut next = 0;
        while let Some(&vertex) = seen.get(next) {
            next += 1;
            for &other in self.of(vertex) {
                if allowed(other) && !seen.contains(&other) {
                    seen.push(other);
                }
            }
        }
        seen
    }

    /// The connected sets without the last vertex of their component whose rest of the component is connected; none where there are too many.
    fn bonds(&self) -> Option<Vec<Vec<usize>>> {
        let mut bonds = Vec::new();
        let mut left = MOST_SETS;
        let mut done: Vec<usize> = Vec::new();
        for vertex in (0..self.neighbours.len()).rev() {
            if done.contains(&vertex) || self.of(vertex).is_empty() {
                continue;
            }
            let component = self.reached(vertex, |_| true);
            done.extend_from_slice(&component);
            let mut barred = vec![vertex];
            for &root in component.iter().filter(|&&root| root != vertex) {
                let border: Vec<usize> =
                    self.of(root).iter().copied().filter(|v| !barred.contains(v)).collect();
                self.grow(&mut vec![root], &border, &mut barred.clone(), &component, &mut bonds, &mut left)?;
                barred.push(root);
            }
        }
        Some(bonds)
    }

    /// All connected sets that contain a set and none of the barred vertices.
    fn grow(
        &self,
        set: &mut Vec<usize>,
        border: &[usize],
        barred: &mut Vec<usize>,
        component: &[usize],
        bonds: &mut Vec<Vec<usize>>,
        left: &mut usize,
    ) -> Option<()> {
        *left = left.checked_sub(1)?;
        let outside = component.iter().find(|v| !set.contains(v))?;
        let rest = self.reached(*outside, |v| !set.contains(&v));
        if rest.len().saturating_add(set.len()) == component.len() {
            bonds.push(set.clone());
        }
        let known = barred.len();
        for (i, &vertex) in border.iter().enumerate() {
            let mut next: Vec<usize> = border.get(i..).unwrap_or(&[]).iter().skip(1).copied().collect();
            set.push(vertex);
            let more = self.of(vertex).iter().copied();
            next.extend(more.filter(|v| !set.contains(v) && !barred.contains(v) && !border.contains(v)));
            self.grow(set, &next, barred, component, bonds, left)?;
            set.pop();
            barred.push(vertex);
        }
        barred.truncate(known);
        Some(())
    }
}

/// The vectors of least support of a network, by its bonds.
fn cuts<F: Float>(directions: &[&[F]], bonds: &[Vec<usize>]) -> Vec<Group<F>> {
    let across = |bond: &Vec<usize>| -> Group<F> {
        let by = |direction: &&[F]| {
            bond.iter().filter_map(|&i| direction.get(i)).fold(F::int(0), |sum, &x| sum + x)
        };
        directions.iter().map(by).enumerate().filter(|(_, g)| *g != F::int(0)).collect()
    };
    bonds.iter().map(across).collect()
}

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
    if let Some(edges) = network(directions) {
        return Graph::new(&edges).bonds().is_none();
    }
    parted(directions).1.groups.len() > MOST_DEPENDENT
}

/// The vectors g of least support: for each facet, up to its sign, the places of the directions with their gᵢ.
pub(crate) fn facets<F: Float>(directions: &[&[F]]) -> Vec<Group<F>> {
    if let Some(bonds) = network(directions).and_then(|edges| Graph::new(&edges).bonds()) {
        return cuts(directions, &bonds);
    }
    facets_of_sets(directions)
}

/// [`facets`] of any directions, by trying sets of them.
fn facets_of_sets<F: Float>(directions: &[&[F]]) -> Vec<Group<F>> {
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

#[cfg(test)]
mod tests {
    use super::*;

    fn edge(n: usize, a: usize, b: usize, size: f64) -> Vec<f64> {
        let at = |i: usize| {
            if i == a {
                size
            } else if i == b {
                -size
            } else {
                0.0
            }
        };
        (0..n).map(at).collect()
    }

    /// The vectors with a first entry of 1, sorted.
    fn normal(facets: Vec<Group<f64>>) -> Vec<Vec<(usize, i64)>> {
        let mut all: Vec<Vec<(usize, i64)>> = facets
            .into_iter()
            .map(|mut facet| {
                facet.sort_by_key(|entry| entry.0);
                let first = facet[0].1;
                facet.iter().map(|&(i, g)| (i, (g / first * 1e9).round() as i64)).collect()
            })
            .collect();
        all.sort();
        all
    }

    /// A ring of n contacts lets go at any two of them; storeys on contacts to the ground and to each other at any group of neighbours.
    #[test]
    fn rings_and_storeys_of_many_contacts_have_few_facets() {
        let ring: Vec<Vec<f64>> = (0..15).map(|i| edge(15, i, (i + 1) % 15, 1.0)).collect();
        let of = |list: &[Vec<f64>]| facets(&list.iter().map(Vec::as_slice).collect::<Vec<_>>());
        let found = of(&ring);
        assert_eq!(found.len(), 15 * 14 / 2);
        assert!(found.iter().all(|facet| facet.len() == 2));
        let storeys: Vec<Vec<f64>> =
            (0..12).map(|i| edge(12, i, 99, 1.0)).chain((1..12).map(|i| edge(12, i, i - 1, 1.0))).collect();
        assert_eq!(of(&storeys).len(), 12 * 13 / 2);
    }

    /// Beside the search over all sets of directions, for graphs with parallel edges, several parts, and factors.
    #[test]
    fn bonds_are_the_facets_of_all_sets() {
        let mut seed = 7_u64;
        let mut below = |count: u64| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 33) % count
        };
        let mut dependent = 0;
        for _ in 0..300 {
            let n = 1 + below(5) as usize;
            let mut list = Vec::new();
            for _ in 0..1 + below(9) {
                let (a, b) = (below(n as u64) as usize, below(n as u64 + 1) as usize);
                if a != b {
                    list.push(edge(n, a, b, [1.0, 2.0, -0.5][below(3) as usize]));
                }
            }
            let directions: Vec<&[f64]> = list.iter().map(Vec::as_slice).collect();
            if directions.is_empty() {
                continue;
            }
            dependent += usize::from(rank(&directions) < directions.len());
            assert_eq!(normal(facets(&directions)), normal(facets_of_sets(&directions)), "{list:?}");
        }
        assert!(dependent > 150, "{dependent}");
    }
}
