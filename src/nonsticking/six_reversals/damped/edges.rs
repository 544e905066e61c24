//! The force ratios of the six-reversal cycle at one Ω and ζ: its two edges.
//!
//! At f64 the cycle is continued along the force, from where it is a closed form up to the point at which a
//! reversal would become a stop, and down to the other. The result is then solved at the precision of the
//! type.

use super::super::equations::{Closing, Unknowns};
use super::{Problem, at_force, solved};
use crate::float::Float;

/// The least and the greatest α of the six-reversal cycle at a valid Ω and ζ > 0; `None` where there is no
/// such cycle.
///
/// Accuracy at f64: 64 ulp; where the two meet the problem itself has half the digits.
pub(crate) fn force_ratios<F: Float>(omega: F, zeta: F) -> Option<(F, F)> {
    let problem = near_pole(omega, zeta)?;
    let scale = problem.stiffness() / omega.square();
    let (least, greatest) = Path::new(&problem.map(F::to_f64)).ends()?;
    let (low, high) = (least.solved(&problem) * scale, greatest.solved(&problem) * scale);
    (low <= high).then_some((low, high))
}

/// The problem, where Ω and ζ are near enough to a pole: on the edges cot β is between −1/17 and 1/30, and t
/// below 1/29.
pub(in super::super) fn near_pole<F: Float>(omega: F, zeta: F) -> Option<Problem<F>> {
    let (one, two) = (F::int(1), F::int(2));
    if omega * two >= one || zeta * F::int(32) >= one {
        return None;
    }
    let problem = Problem::new(omega, zeta);
    let cotangent = problem.cos_beta / problem.sin_beta;
    let is_near = cotangent * F::int(20) < one && cotangent * F::int(-12) < one;
    (is_near && problem.loss * F::int(8) < one).then_some(problem)
}

/// An end of the force ratios at f64: the cycle there, the reversal that is a stop, and by how much the
/// type's pole is nearer.
struct End {
    at: Unknowns<f64>,
    edge: Closing<f64>,
    scale: f64,
}

impl End {
    /// AΩ² at the end, at the precision of the type.
    fn solved<F: Float>(&self, problem: &Problem<F>) -> F {
        let start = nearer(self.at.map(F::from_f64), &self.edge, F::from_f64(self.scale));
        let edge = if matches!(self.edge, Closing::Second) { Closing::Second } else { Closing::Third };
        // Where the two ends meet neither is sharp: within rounding of that the start is as good.
        solved(problem, edge, start).unwrap_or(start).forced_acceleration(problem.omega)
    }
}

/// The cycle of the greatest force when the distance from the pole is `scale` times smaller, to first order
/// in that distance: the force grows, and the arc next to the reversal that is a stop shrinks, by this
/// factor.
fn nearer<F: Float>(at: Unknowns<F>, edge: &Closing<f64>, scale: F) -> Unknowns<F> {
    let Unknowns { before, after, sine, cosine, swing } = at;
    let (before, after) =
        if matches!(edge, Closing::Second) { (before / scale, after) } else { (before, after / scale) };
    Unknowns { before, after, sine: sine * scale, cosine: cosine * scale, swing: swing * scale }
}

/// One cycle of the path: the force as AΩ², and by how much of it the reversal that is nearest to a stop is
/// not one.
#[derive(Clone, Copy)]
struct Node {
    force: f64,
    at: Unknowns<f64>,
    margin: f64,
    nearest: Closing<f64>,
}

/// The cycles with growing force at one Ω and ζ.
struct Path {
    problem: Problem<f64>,
    distance: f64,
}

impl Path {
    fn new(problem: &Problem<f64>) -> Self {
        let distance = (problem.cos_beta / problem.sin_beta).hypot(problem.loss);
        Self { problem: *problem, distance }
    }

    /// The least and the greatest force.
    fn ends(&self) -> Option<(End, End)> {
        let start = self.best(node(&self.problem, at_force(&self.problem, ORDINARY)?))?;
        let (least, beyond) = outwards(&self.problem, start, 1.0 / STEP)?;
        let least = between(&self.problem, least, beyond);
        if self.distance >= CLOSE {
            let (greatest, beyond) = outwards(&self.problem, start, STEP)?;
            return Some((least, between(&self.problem, greatest, beyond)));
        }
        // All forces up to a share of the inverse distance belong to the cycle.
        let farther = Self::new(&self.problem.towards_the_pole(CLOSE / self.distance));
        let start = farther.best(node(&farther.problem, at_force(&farther.problem, ORDINARY)?))?;
        let (greatest, beyond) = outwards(&farther.problem, start, STEP)?;
        Some((least, self.approached(between(&farther.problem, greatest, beyond))))
    }

    /// The greatest force at the true distance, from that at [`CLOSE`].
    fn approached(&self, mut end: End) -> End {
        let mut distance = CLOSE;
        while distance > self.distance && distance > NEAREST {
            let next = (distance / 4.0).max(self.distance);
            let problem = self.problem.towards_the_pole(next / self.distance);
            let Some(mut found) = solved(&problem, end.edge, nearer(end.at, &end.edge, distance / next))
            else {
                break;
            };
            let reached = node(&problem, found);
            if reached.margin < -1e-9
                && let Some(other) = solved(&problem, reached.nearest, found)
            {
                (found, end.edge) = (other, reached.nearest);
            }
            (end.at, distance) = (found, next);
        }
        End { scale: distance / self.distance, ..end }
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
    let [first, second, third] = problem.forces(&at);
    let (second, third) = (second - 1.0, -third - 1.0);
    let nearest = if second < third { Closing::Second } else { Closing::Third };
    Node { force, at, margin: second.min(third).min(-first - 1.0) / force, nearest }
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
        if !(WEAKEST / 2.0..100.0 / NEAREST).contains(&here.force) {
            return None;
        }
    }
    None
}

/// The end between a cycle without a stop and one beyond it.
fn between(problem: &Problem<f64>, inside: Node, beyond: Node) -> End {
    let (mut inside, mut beyond) = (inside, beyond);
    for _ in 0..40 {
        let ratio = (beyond.force / inside.force).sqrt();
        let Some(middle) = stepped(problem, &inside, ratio) else { break };
        if middle.margin < 0.0 {
            beyond = middle;
        } else {
            inside = middle;
        }
        if (ratio - 1.0).abs() < 1e-5 {
            break;
        }
    }
    End { at: inside.at, edge: beyond.nearest, scale: 1.0 }
}

/// A force, as AΩ², that belongs to the cycle at every pole.
const ORDINARY: f64 = 9.5;
/// On the edges no force is below this.
const WEAKEST: f64 = 4.0;
/// From one cycle of the path to the next.
const STEP: f64 = 1.1;
/// Distance from the pole, as hypot(cot β, t), from which on the whole path is followed.
const CLOSE: f64 = 0.004;
/// Closer than this to the pole the greatest force is inversely proportional to the distance, to within
/// rounding.
const NEAREST: f64 = 1e-12;

#[cfg(test)]
mod tests {
    use super::force_ratios;
    use crate::phase_function::PhaseFunction;

    /// Some cycles exist near each pole up to ζ = 0.019/(2n+1), and none from 0.0215/(2n+1) on.
    #[test]
    fn a_little_damping_leaves_some() {
        for n in 1..=8 {
            let odd = f64::from(2 * n + 1);
            assert!(force_ratios(1.0 / (odd + 0.003), 0.0185 / odd).is_some(), "{n}");
            for i in -22..=40 {
                let omega = 1.0 / (odd + 0.001 * f64::from(i));
                let found = force_ratios(omega, 0.0215 / odd);
                assert!(found.is_none(), "{n} {omega}: {found:?}");
            }
        }
    }

    /// As ζ → 0 the edges tend to those without damping, except for the greatest force at the poles.
    #[test]
    fn without_a_damper_they_are_those_of_no_damper() {
        for omega in [0.331f64, 0.3333, 0.334, 0.335, 0.1995, 0.2003, 0.0907] {
            let (low, high) =
                super::super::super::force_ratios_at(&PhaseFunction::new(omega).unwrap()).unwrap();
            let (least, greatest) = force_ratios(omega, 1e-18).unwrap();
            assert!((least / low - 1.0).abs() < 1e-13 && (greatest / high - 1.0).abs() < 1e-13, "{omega}");
        }
        let greatest = |zeta: f64| force_ratios(1.0 / 3.0, zeta).unwrap().1;
        for zeta in [1e-6, 1e-9, 1e-13] {
            assert!((greatest(zeta) * zeta / 1.697_65 - 1.0).abs() < 1e-4, "{zeta}: {}", greatest(zeta));
        }
    }
}
