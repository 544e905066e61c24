//! The force ratios of the six-reversal cycle at one Ω, ζ and η: its two edges.
//!
//! A static friction of η > 1 leaves the cycle as it is, and asks for more at each reversal: the force left
//! over has to be above η there. Far from friction, where α ≫ 1, the forces at the reversals are α times
//! functions of α times the distance from the pole, so that all lengths of this search scale with η.
//!
//! At f64 the cycle is continued along the force, from where it is a closed form up to the point at which a
//! reversal would become a stop, and down to the other. The result is then solved at the precision of the
//! type. Without a damper the edges are:
//!
//! | side of the pole | least α | greatest α |
//! |---|---|---|
//! | Ω > 1/(2n+1), cot β > 0 | third reversal | third reversal |
//! | Ω < 1/(2n+1), cot β < 0 | third reversal; further away the second | second reversal |

use super::equations::{Closing, Edge, Problem, Unknowns};
use super::{at_force, solved};
use crate::float::Float;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// The edges at one Ω, ζ and η.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Edges<F> {
    /// The least and the greatest α.
    pub(super) low: F,
    pub(super) high: F,
    /// The reversal that is a stop at the least α.
    pub(super) least: Edge,
}

/// The edges of the six-reversal cycle at a valid Ω, ζ ≥ 0 and η ≥ 1; `None` where there is no such cycle.
///
/// Accuracy at f64: 64 ulp; where the two meet the problem itself has half the digits.
pub(super) fn edges<F: Float>(omega: F, zeta: F, eta: F) -> Option<Edges<F>> {
    let problem = near_pole(omega, zeta, eta)?;
    let scale = problem.stiffness() / omega.square();
    let (least, greatest) = Path::new(&problem.map(F::to_f64)).ends()?;
    let (low, high) = (least.force(&problem) * scale, greatest.force_beside_pole(&problem) * scale);
    (low <= high).then_some(Edges { low, high, least: least.edge })
}

/// The problem, where Ω and ζ are near enough to a pole: on the edges cot β is between −1/17 and 1/30, and t
/// below 1/29.
fn near_pole<F: Float>(omega: F, zeta: F, eta: F) -> Option<Problem<F>> {
    let (one, two) = (F::int(1), F::int(2));
    if omega * two >= one || zeta * F::int(32) >= one {
        return None;
    }
    let problem = Problem::new(omega, zeta, eta);
    let cotangent = problem.cos_beta / problem.sin_beta;
    let is_near = cotangent * F::int(30) < one && cotangent * F::int(-17) < one;
    (is_near && problem.loss * F::int(29) < one).then_some(problem)
}

/// An end of the force ratios at f64: the cycle at this distance from the pole, and the reversal that is a
/// stop.
struct EdgeCycle {
    at: Unknowns<f64>,
    edge: Edge,
    distance: f64,
}

impl EdgeCycle {
    /// AΩ² at the end, at the precision of the type.
    fn force<F: Float>(&self, problem: &Problem<F>) -> F {
        self.from(problem, self.at.map(F::from_f64))
    }

    fn from<F: Float>(&self, problem: &Problem<F>, start: Unknowns<F>) -> F {
        // Where the two ends meet neither is sharp: within rounding of that the start is as good.
        let found = solved(problem, Closing::Stop(self.edge), start).unwrap_or(start);
        found.forced_acceleration(problem.omega)
    }

    /// The greatest AΩ², which grows towards the pole.
    ///
    /// There the short arc vanishes as the distance, and the other unknowns increase as its inverse, so that the
    /// equations lose the short arc in rounding. The product of AΩ² and the distance, which is smooth, is
    /// extrapolated: the error of the parabola through its values at t, 2t and 4t is about (20t)³ for η = 1, below a
    /// unit in the last place of p bits for the t taken.
    fn force_beside_pole<F: Float>(&self, problem: &Problem<F>) -> F {
        let (one, distance) = (F::int(1), problem.distance());
        let bits = i32::try_from(F::precision()).unwrap_or(i32::MAX);
        let t = F::exp2i(-(bits / 3 + 5)) / problem.static_friction;
        let force = |share: F| {
            let start = nearer(self.at.map(F::from_f64), F::from_f64(self.distance) / (distance * share));
            self.from(&problem.towards_the_pole(share), start)
        };
        if distance >= t {
            return force(one);
        }
        let x = distance / t;
        let product = |times: i32| force(F::int(times) / x) * F::int(times);
        let (by_one, by_two, by_four) = (x - one, x - F::int(2), x - F::int(4));
        let sum = by_two * by_four / F::int(3) * product(1) - by_one * by_four / F::int(2) * product(2)
            + by_one * by_two / F::int(6) * product(4);
        sum / x
    }
}

/// The cycle of the greatest force when the distance from the pole is `scale` times smaller, to first order
/// in that distance: the force grows, and the shorter arc shrinks, by this factor.
fn nearer<F: Float>(at: Unknowns<F>, scale: F) -> Unknowns<F> {
    let Unknowns { before, after, sine, cosine, swing } = at;
    let (before, after) = if before < after { (before / scale, after) } else { (before, after / scale) };
    Unknowns { before, after, sine: sine * scale, cosine: cosine * scale, swing: swing * scale }
}

/// One cycle of the path: the force as AΩ², and by how much of it the reversal that is nearest to a stop is
/// not one.
#[derive(Clone, Copy)]
struct Node {
    force: f64,
    at: Unknowns<f64>,
    margin: f64,
    nearest: Edge,
}

/// The cycles with growing force at one Ω and ζ.
struct Path {
    problem: Problem<f64>,
    distance: f64,
    /// [`CLOSE`] and [`NEAREST`] at this η.
    close: f64,
    nearest: f64,
}

impl Path {
    fn new(problem: &Problem<f64>) -> Self {
        let eta = problem.static_friction;
        let (close, nearest) = (CLOSE / eta, NEAREST / eta);
        Self { problem: *problem, distance: problem.distance(), close, nearest }
    }

    /// The least and the greatest force.
    fn ends(&self) -> Option<(EdgeCycle, EdgeCycle)> {
        let start = self.ordinary()?;
        let (least, beyond) = outwards(&self.problem, start, 1.0 / STEP)?;
        let least = self.between(least, beyond);
        if self.distance >= self.close {
            let (greatest, beyond) = outwards(&self.problem, start, STEP)?;
            return Some((least, self.between(greatest, beyond)));
        }
        // All forces up to a share of the inverse distance belong to the cycle.
        let farther = Self::new(&self.problem.towards_the_pole(self.close / self.distance));
        let start = farther.ordinary()?;
        let (greatest, beyond) = outwards(&farther.problem, start, STEP)?;
        Some((least, self.approached(farther.between(greatest, beyond))))
    }

    /// A cycle without a stop.
    fn ordinary(&self) -> Option<Node> {
        let force = ORDINARY * (self.problem.static_friction + 2.0) / 3.0;
        self.best(node(&self.problem, at_force(&self.problem, force)?))
    }

    /// The greatest force at the true distance or at [`NEAREST`], from that at [`CLOSE`].
    fn approached(&self, mut end: EdgeCycle) -> EdgeCycle {
        while end.distance > self.distance && end.distance > self.nearest {
            let next = (end.distance / 4.0).max(self.distance).max(self.nearest);
            let problem = self.problem.towards_the_pole(next / self.distance);
            let start = nearer(end.at, end.distance / next);
            let Some((at, edge)) = settled(&problem, end.edge, start) else { break };
            end = EdgeCycle { at, edge, distance: next };
        }
        end
    }

    /// The end between a cycle without a stop and one beyond it.
    fn between(&self, mut inside: Node, mut beyond: Node) -> EdgeCycle {
        for _ in 0..40 {
            let ratio = (beyond.force / inside.force).sqrt();
            let Some(middle) = stepped(&self.problem, &inside, ratio) else { break };
            if middle.margin < 0.0 {
                beyond = middle;
            } else {
                inside = middle;
            }
            if (ratio - 1.0).abs() < 1e-5 {
                break;
            }
        }
        let edge = settled(&self.problem, beyond.nearest, inside.at).map_or(beyond.nearest, |(_, edge)| edge);
        EdgeCycle { at: inside.at, edge, distance: self.distance }
    }

    /// A cycle without a stop, from any: that which is farthest from one.
    fn best(&self, start: Node) -> Option<Node> {
        if start.margin > 0.0 {
            return Some(start);
        }
        let mut best = start;
        for (ratio, last) in [(STEP, 10.0 / self.distance), (1.0 / STEP, WEAKEST)] {
            let mut here = start;
            while (here.force - last) * (ratio - 1.0) < 0.0 {
                let Some(next) = stepped(&self.problem, &here, ratio) else { break };
                if next.margin > best.margin {
                    best = next;
                }
                here = next;
            }
        }
        // The margin has one maximum along the path.
        let mut ratio = STEP;
        while best.margin <= 0.0 && ratio > 1.0 + 1e-7 {
            ratio = ratio.sqrt();
            for ratio in [ratio, 1.0 / ratio] {
                if let Some(next) = stepped(&self.problem, &best, ratio)
                    && next.margin > best.margin
                {
                    best = next;
                }
            }
        }
        (best.margin > 0.0).then_some(best)
    }
}

/// The cycle with a force that is `ratio` times as large.
fn stepped(problem: &Problem<f64>, from: &Node, ratio: f64) -> Option<Node> {
    let Node { force, at, .. } = *from;
    let start = Unknowns { cosine: at.cosine * ratio, swing: at.swing * ratio, ..at };
    solved(problem, Closing::Force(force * ratio), start).map(|at| node(problem, at))
}

fn node(problem: &Problem<f64>, at: Unknowns<f64>) -> Node {
    let force = at.forced_acceleration(problem.omega);
    let ([first, second, third], eta) = (problem.forces(&at), problem.static_friction);
    let (second, third) = (second - eta, -third - eta);
    let nearest = if second < third { Edge::Second } else { Edge::Third };
    Node { force, at, margin: second.min(third).min(-first - eta) / force, nearest }
}

/// The last cycle without a stop in this direction, and one beyond the end.
fn outwards(problem: &Problem<f64>, from: Node, ratio: f64) -> Option<(Node, Node)> {
    let (mut here, mut ratio) = (from, ratio);
    // The path may turn back not far beyond the end: where a step leads to nothing it is halved.
    while (ratio - 1.0).abs() > 1e-9 {
        match stepped(problem, &here, ratio) {
            None => ratio = ratio.sqrt(),
            Some(next) if next.margin < 0.0 => return Some((here, next)),
            Some(next) => here = next,
        }
        if !(WEAKEST / 2.0..100.0 * problem.static_friction / NEAREST).contains(&here.force) {
            return None;
        }
    }
    None
}

/// The cycle on an edge, from one that is close to it, and the reversal that is a stop there: another one than
/// given where that other is one already.
fn settled(problem: &Problem<f64>, edge: Edge, near: Unknowns<f64>) -> Option<(Unknowns<f64>, Edge)> {
    let found = solved(problem, Closing::Stop(edge), near)?;
    let reached = node(problem, found);
    // Beyond the rounding of the forces.
    let other =
        (reached.margin < -1e-13).then(|| solved(problem, Closing::Stop(reached.nearest), found)).flatten();
    Some(other.map_or((found, edge), |other| (other, reached.nearest)))
}

/// A force, as AΩ², that belongs to the cycle at every pole; with η it grows as the least force at the pole,
/// which is nearly proportional to η + 2.
const ORDINARY: f64 = 9.5;
/// On the edges no force is below this.
const WEAKEST: f64 = 4.0;
/// From one cycle of the path to the next.
const STEP: f64 = 1.1;
/// Distance from the pole, as hypot(cot β, t), from which on the whole path is followed; inversely
/// proportional to η.
const CLOSE: f64 = 0.004;
/// Closer than this to the pole the cycle of the greatest force is that at this distance, scaled; inversely
/// proportional to η.
const NEAREST: f64 = 1e-7;

#[cfg(test)]
mod tests {
    use super::edges;

    fn force_ratios(omega: f64, zeta: f64, eta: f64) -> Option<(f64, f64)> {
        edges(omega, zeta, eta).map(|found| (found.low, found.high))
    }

    /// Some cycles exist near each pole up to ζ = 0.019/(2n+1), and none from 0.0215/(2n+1) on.
    #[test]
    fn a_little_damping_leaves_some() {
        for n in 1..=8 {
            let odd = f64::from(2 * n + 1);
            assert!(force_ratios(1.0 / (odd + 0.003), 0.0185 / odd, 1.0).is_some(), "{n}");
            for i in -22..=40 {
                let omega = 1.0 / (odd + 0.001 * f64::from(i));
                let found = force_ratios(omega, 0.0215 / odd, 1.0);
                assert!(found.is_none(), "{n} {omega}: {found:?}");
            }
        }
    }

    /// As ζ → 0 the edges tend to those without damping, except for the greatest force at the poles.
    #[test]
    fn a_vanishing_damper_is_no_damper() {
        for omega in [0.331f64, 0.3333, 0.334, 0.335, 0.1995, 0.2003, 0.0907] {
            let (low, high) = force_ratios(omega, 0.0, 1.0).unwrap();
            let (least, greatest) = force_ratios(omega, 1e-18, 1.0).unwrap();
            assert!((least / low - 1.0).abs() < 1e-13 && (greatest / high - 1.0).abs() < 1e-13, "{omega}");
        }
        let greatest = |zeta: f64| force_ratios(1.0 / 3.0, zeta, 1.0).unwrap().1;
        for zeta in [1e-6, 1e-9, 1e-13] {
            assert!((greatest(zeta) * zeta / 1.697_65 - 1.0).abs() < 1e-4, "{zeta}: {}", greatest(zeta));
        }
    }

    /// On the edges with a static friction of η the least force at a reversal of the cycle, which does not depend
    /// on η, is η; between them it is greater, and beyond them less.
    #[test]
    fn on_the_edges_a_reversal_has_the_static_friction() {
        use crate::Ratios;
        use crate::cycle::SixReversals;
        let least = |omega, alpha, zeta| {
            let ratios = Ratios::new(omega, alpha).unwrap().with_damping_ratio(zeta).unwrap();
            SixReversals::new(ratios).map_or(f64::NAN, |it| it.forces().into_iter().fold(f64::MAX, f64::min))
        };
        for (omega, zeta, eta) in [
            (0.331, 0.0, 1.01),
            (0.331, 5e-4, 1.01),
            (0.331, 0.0, 1.5),
            (0.3335, 1e-4, 1.3),
            (0.3334, 0.0, 4.0),
            (1.0 / 3.0, 1e-6, 30.0),
            (1.0 / 3.0, 0.0, 1e6),
            (0.2, 1e-5, 10.0),
            (0.199_9, 0.0, 2.0),
            (0.0907, 0.0, 1.2),
        ] {
            let (low, high): (f64, f64) =
                force_ratios(omega, zeta, eta).unwrap_or_else(|| panic!("{omega} {zeta} {eta}"));
            let (one, at) =
                (force_ratios(omega, zeta, 1.0).unwrap(), format!("{omega} {zeta} {eta}: {low} {high}"));
            assert!(one.0 < low && low < high && high < one.1 * (1.0 + 1e-12), "{at} {one:?}");
            for (alpha, is) in
                [(low * (1.0 + 1e-9), true), ((low * high).sqrt(), true), (low * (1.0 - 1e-9), false)]
            {
                assert_eq!(least(omega, alpha, zeta) > eta, is, "{at} {alpha}");
            }
            for (alpha, is) in [(high * (1.0 - 1e-9), true), (high * (1.0 + 1e-9), false)] {
                assert_eq!(least(omega, alpha, zeta) > eta, is, "{at} {alpha}");
            }
        }
        // Farther from the pole than its greatest force allows there is none.
        assert_eq!(force_ratios(0.331, 0.0, 4.0), None);
        assert_eq!(force_ratios(0.331, 2e-3, 2.0), None);
    }
}
