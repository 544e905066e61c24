//! The parameters that a curve cannot tell apart from the best ones, and the lower valleys among them.
//!
//! Where a motion begins to stop, its amplitude has a kink in the parameters, so that the sum of squares has several valleys
//! with walls between them. They are searched on a lattice along the axes of the ellipse of equal sums. From the fit on, it is
//! followed wherever the sum is below a level above the one of the interval: so it crosses low walls, and follows bent valleys.
//! A valley beyond a higher wall is found from the grid of starts. On each side of a wall a descent starts at the lowest node.

use super::model::Parameters;
use super::outliers::{Judged, judge, least_variance};
use super::search::{CurveFit, RANGE, ResponseCurve, Rule, StartGrid, descend};
use crate::uncertainty::student_95;
use alloc::collections::{BTreeMap, BTreeSet};
use alloc::vec::Vec;
use core::iter::zip;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// The greatest number of lower valleys that are moved to.
pub(super) const ROUNDS: usize = 8;
/// The relative decrease of a sum that counts.
const LOWER: f64 = 1e-9;
/// The distance of neighbours on the lattice, and of those of a profile over an unknown, in standard errors.
pub(super) const STEP: f64 = 0.35;
/// The smallest step with which the ends of a region are found, in steps of the lattice, and the greatest number of moves.
const SMALLEST: f64 = 1.0 / 16.0;
const MOVES: usize = 64;
/// The greatest number of motions of a lattice, and of its nodes.
const MOTIONS: usize = 1 << 22;
const NODES: usize = 1 << 13;

/// The least sum of squares, that up to which parameters are no worse than the ends of the interval, and up to which they are
/// followed.
#[derive(Debug, Clone, Copy)]
pub(super) struct Levels {
    pub(super) least: f64,
    pub(super) alike: f64,
    pub(super) followed: f64,
}

impl Levels {
    /// The levels above the least sum, whose values have this variance.
    pub(super) fn above(least: f64, variance: f64, degrees_of_freedom: f64) -> Self {
        let excess = student_95(degrees_of_freedom).powi(2) * variance;
        Self { least, alike: least + excess, followed: least + 2.0 * excess }
    }
}

/// What is known of the parameters beside those of a fit.
pub(super) struct Region {
    /// The least and the greatest value of each parameter with a sum that is alike, if there is one.
    pub(super) hull: Option<[(f64, f64); 2]>,
    /// Whether the search came to its end.
    pub(super) is_whole: bool,
}

/// The lowest valley found from a fit on, with its region if the curve tells friction from damping.
pub(super) fn lowest(
    curve: &ResponseCurve<'_>,
    mut found: Judged,
    grid: Option<&StartGrid>,
) -> (Judged, Option<Region>) {
    for round in 1.. {
        let minima = grid.map(|grid| grid.minima(curve, Rule::Weighted(&found.fit.weights), usize::MAX));
        let levels = Levels::above(found.fit.sum, found.noise[0].powi(2), found.degrees_of_freedom);
        let Some((lower, mut region)) = searched(curve, &found, minima.unwrap_or_default(), levels) else {
            return (found, None);
        };
        let is_last = lower.is_none();
        let lower = lower.filter(|_| round < ROUNDS);
        let moved = lower.and_then(|lower| Some((judge(curve, lower.at, None), found.moved(curve, lower)?)));
        let Some((again, moved)) = moved else {
            region.is_whole &= is_last;
            return (found, Some(region));
        };
        // There, other values may contradict each other.
        let misfit = |judged: &Judged| judged.misfit(curve.counts());
        found = again.ok().filter(|again| misfit(again) < misfit(&moved)).unwrap_or(moved);
    }
    (found, None)
}

/// A lower minimum than a fit, if one is found, and the region of the levels; `None` where the covariance is not positive.
pub(super) fn searched(
    curve: &ResponseCurve<'_>,
    found: &Judged,
    mut minima: Vec<CurveFit>,
    levels: Levels,
) -> Option<(Option<CurveFit>, Region)> {
    let weights = &found.fit.weights;
    let sum = |at| curve.sum_at(weights, at);
    let lattice = Lattice::new(found.fit.at, found.covariance?)?;
    let most = MOTIONS.checked_div(curve.points.len()).map_or(NODES, |most| most.min(NODES));
    let (mut low, mut seen) = (BTreeMap::new(), BTreeSet::new());
    let from = core::iter::once(found.fit.at).chain(minima.iter().map(|other| other.at));
    let mut queue: Vec<Node> = from.flat_map(|place| neighbours(lattice.nearest(place))).collect();
    while let Some(node) = queue.pop().filter(|_| seen.len() < most) {
        let Some(place) = lattice.place(node).filter(|_| seen.insert(node)) else { continue };
        let Some((sum, stops)) = sum(place).filter(|(sum, _)| *sum <= levels.followed) else { continue };
        low.insert(node, (place, sum, stops));
        queue.extend(neighbours(node).filter(|next| !seen.contains(next)));
    }
    let is_lowest = |node: &Node, (_, lowest, stops): &(Parameters, f64, Vec<bool>)| {
        let mut beside = neighbours(*node).filter_map(|next| low.get(&next));
        beside.all(|(_, sum, other)| lowest <= sum || stops != other)
    };
    let starts = low.iter().filter(|(node, here)| is_lowest(node, here)).map(|(_, here)| here.0);
    minima.extend(starts.filter_map(|start| descend(curve, Rule::Weighted(weights), start).ok()));
    let is_alike = |place| sum(place).is_some_and(|(sum, _)| sum <= levels.alike);
    let places = low.values().map(|here| here.0).chain(minima.iter().map(|other| other.at));
    let alike: Vec<Parameters> =
        core::iter::once(found.fit.at).chain(places).filter(|place| is_alike(*place)).collect();
    let end = |of: fn(Parameters) -> f64| {
        let last = alike.iter().max_by(|a, b| of(**a).total_cmp(&of(**b)))?;
        Some(of(lattice.end(*last, of, is_alike)))
    };
    let hull = || {
        let kappa = (-end(|[kappa, _]| -kappa)?, end(|[kappa, _]| kappa)?);
        Some([kappa, (-end(|[_, zeta]| -zeta)?, end(|[_, zeta]| zeta)?)])
    };
    let region = Region { hull: hull(), is_whole: seen.len() < most };
    let best = minima.into_iter().min_by(|a, b| a.sum.total_cmp(&b.sum));
    let least = found.fit.sum;
    Some((best.filter(|best| least - best.sum > LOWER * least + least_variance()), region))
}

/// Places of the lattice, in steps from the fit.
type Node = [i32; 2];

/// A lattice whose first axis moves κ alone, and whose second moves ζ, with the κ that fits it.
struct Lattice {
    at: Parameters,
    first: f64,
    second: Parameters,
}

impl Lattice {
    /// The lattice around a fit with its covariance (κκ, κζ, ζζ).
    fn new(at: Parameters, [a, b, c]: [f64; 3]) -> Option<Self> {
        let (alone, error) = ((a - b * b / c).sqrt(), c.sqrt());
        let is_positive = alone > 0.0 && error > 0.0 && alone.is_finite() && error.is_finite();
        is_positive.then_some(Self { at, first: STEP * alone, second: [STEP * b / error, STEP * error] })
    }

    /// The place so many steps along each axis from another one, and at the end of the range where it lies beyond.
    fn moved(&self, [kappa, zeta]: Parameters, [i, j]: [f64; 2]) -> (Parameters, Parameters) {
        let free = [kappa + i * self.first + j * self.second[0], zeta + j * self.second[1]];
        let [of_kappa, of_zeta] = RANGE;
        (free, [free[0].clamp(of_kappa.0, of_kappa.1), free[1].clamp(of_zeta.0, of_zeta.1)])
    }

    /// The place of a node; of one within a step beyond the range, at its end.
    fn place(&self, node: Node) -> Option<Parameters> {
        let (free, place) = self.moved(self.at, node.map(f64::from));
        let is_near = |((free, place), step): ((f64, f64), f64)| (free - place).abs() < step;
        zip(zip(free, place), [self.first, self.second[1]]).all(is_near).then_some(place)
    }

    fn nearest(&self, [kappa, zeta]: Parameters) -> Node {
        let second = ((zeta - self.at[1]) / self.second[1]).round();
        let first = ((kappa - self.at[0] - second * self.second[0]) / self.first).round();
        // A conversion keeps to the range of its type.
        [first, second].map(|steps| steps.clamp(-1e9, 1e9) as i32)
    }

    /// The place at which a quantity is greatest, from a place on by ever smaller steps.
    fn end(
        &self,
        mut here: Parameters,
        quantity: impl Fn(Parameters) -> f64,
        is_within: impl Fn(Parameters) -> bool,
    ) -> Parameters {
        let mut size = 0.5;
        for _ in 0..MOVES {
            if size < SMALLEST {
                break;
            }
            let beside = neighbours([0; 2]).map(|node| self.moved(here, node.map(|x| size * f64::from(x))).1);
            let mut further = beside.filter(|there| quantity(*there) > quantity(here));
            match further.find(|there| is_within(*there)) {
                Some(there) => here = there,
                None => size *= 0.5,
            }
        }
        here
    }
}

/// A node and the nodes beside it.
fn neighbours([i, j]: Node) -> impl Iterator<Item = Node> {
    (-1..=1).flat_map(move |x| (-1..=1).map(move |y| [i.saturating_add(x), j.saturating_add(y)]))
}
