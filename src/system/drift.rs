//! What a system has no measure for: displacements that no force notices, and numbers too small to be a motion.
//!
//! Let U span the displacements that no spring, no stop and no normal load notices: K u = 0, b·u = 0 for each stop, and n·u = 0
//! for each normal load `N = … + n·q`. Contacts act by velocities and elastic contacts by a force of their own, so that the motion
//! from `q + U s` is that from q, moved by U s. The period map P has the same symmetry, `P(q + U s, …) = P(q, …) + U s`, and
//! its limit lives in the quotient: the part of `P(z) − z` in U is the **drift**.

use super::assembly::{Assembly, Driven, Rule, unit};
use super::first_passage::integer;
use super::matrix::{Matrix, add_times, dot, size_of_dot};
use super::spring::stiffest;
use crate::float::Float;
use alloc::vec;
use alloc::vec::Vec;

/// A displacement that no force notices, and its dual: `dual·u = 1`, and 0 for the other ones.
struct Way<F> {
    u: Vec<F>,
    /// M u.
    dual: Vec<F>,
}

/// The displacements that no force notices.
pub(crate) struct Drift<F> {
    ways: Vec<Way<F>>,
    /// How many of them, the first ones, are measured by a coordinate that travels.
    carried: usize,
}

impl<F: Float> Drift<F> {
    /// A spring k that a mass m does not notice in a time t, `k t² ≤ ε m`, is none: its limit would be found after 1/ε of these times.
    pub(crate) fn new(system: &Assembly<F>, time: F) -> Self {
        let n = system.n;
        let mut noticed: Vec<Vec<F>> = Vec::new();
        let springs = system.stiffness.rows().map(<[F]>::to_vec);
        noticed.extend(
            springs.enumerate().filter(|(i, row)| !is_weak(system, time, *i, row)).map(|(_, row)| row),
        );
        for part in &system.parts {
            let row = match &part.rule {
                Rule::Stop { depth, .. } | Rule::Hard { depth, .. } => Some(depth.as_slice()),
                Rule::Spring { .. } => part.stretch.as_deref(),
                // The force of a stop that gives no way notices what others do.
                Rule::Contact { .. } | Rule::Elastic { .. } => part.normal().filter(|_| part.under.is_none()),
            };
            noticed.extend(row.and_then(|row| row.get(..n)).map(<[F]>::to_vec));
        }
        // A displacement that is prescribed is noticed; one whose velocity is, is not.
        let travels = |moved: &&Driven<F>| moved.displacement.is_none() && moved.velocity.is_some();
        let placed = system.moved.iter().filter(|moved| !travels(moved));
        noticed.extend(placed.map(|moved| unit(n, moved.coordinate)));
        // In units in which each coordinate has the mass 1, and each row the size 1.
        let moved = |i: usize| system.moved.iter().any(|moved| moved.coordinate == i);
        let mass = |i: usize| {
            if moved(i) || system.massless.contains(&i) { F::int(1) } else { system.mass.at(i, i) }
        };
        let scale: Vec<F> = (0..n).map(|i| F::int(1) / mass(i).sqrt()).collect();
        let mut gram = Matrix::zero(n, n);
        for row in &noticed {
            let row: Vec<F> = row.iter().zip(&scale).map(|(&x, &s)| x * s).collect();
            let size = dot(&row, &row);
            if size > F::int(0) {
                row.iter().enumerate().for_each(|(i, &x)| add_times(gram.row_mut(i), x / size, &row));
            }
        }
        // A large matrix whose pivots are far above rounding is definite, and has no such displacement.
        let is_definite = n > 32 && gram.cholesky(F::epsilon() * integer(64 * n)).is_ok();
        let (values, modes) =
            if is_definite { (Vec::new(), Matrix::zero(0, 0)) } else { gram.symmetric_modes() };
        // The values are squares, which are known to rounding; whether a weak spring notices a candidate is seen row by row.
        let none = F::epsilon() * F::int(64);
        let candidates = values.iter().zip(modes.rows()).filter(|(value, _)| **value <= none);
        let candidates =
            candidates.map(|(_, mode)| -> Vec<F> { mode.iter().zip(&scale).map(|(&x, &s)| x * s).collect() });
        let mut candidates: Vec<Vec<F>> = candidates
            .filter(|u| {
                let rounding = |row: &Vec<F>| size_of_dot(row, u) * F::epsilon() * F::int(256);
                noticed.iter().all(|row| dot(row, u).abs() <= rounding(row))
            })
            .collect();
        let mut ways: Vec<Way<F>> = Vec::new();
        // What travels as it is prescribed measures its way itself.
        for moved in system.moved.iter().filter(travels) {
            let at = |u: &Vec<F>| u.get(moved.coordinate).copied().unwrap_or(F::int(0));
            let far = |u: &Vec<F>| at(u).abs() > size_of_dot(u, u).sqrt() * F::exp2i(-20);
            let Some(place) = candidates.iter().position(far) else { continue };
            let u = candidates.swap_remove(place);
            let one = at(&u);
            for other in &mut candidates {
                let share = at(other) / one;
                add_times(other, -share, &u);
            }
            let mut dual = unit(n, moved.coordinate);
            dual.iter_mut().for_each(|x| *x = *x / one);
            ways.push(Way { u, dual });
        }
        let carried = ways.len();
        for mut u in candidates {
            for way in &ways {
                let share = dot(&way.dual, &u);
                add_times(&mut u, -share, &way.u);
            }
            let mut dual = system.mass.of(&u);
            // What has no mass is measured by itself.
            for &i in &system.massless {
                if let (Some(dual), Some(&x)) = (dual.get_mut(i), u.get(i)) {
                    *dual = x;
                }
            }
            for way in ways.iter().take(carried) {
                let share = dot(&dual, &way.u);
                add_times(&mut dual, -share, &way.dual);
            }
            let size = dot(&dual, &u).sqrt();
            let [u, dual] = [u, dual].map(|list| list.iter().map(|&x| x / size).collect());
            ways.push(Way { u, dual });
        }
        Self { ways, carried }
    }

    /// Whether each coordinate that travels as it is prescribed takes along all that notices its displacement.
    pub(crate) fn carries(&self, system: &Assembly<F>) -> bool {
        system.moved.iter().all(|moved| {
            let row = moved.displacement.as_ref().or(moved.velocity.as_ref());
            let comes_back =
                |row: &Vec<F>| row.iter().rev().take(1 + 2 * system.records.len()).all(|&x| x == F::int(0));
            let measures = |way: &Way<F>| way.dual.get(moved.coordinate).is_some_and(|&x| x != F::int(0));
            moved.displacement.is_some()
                || row.is_some_and(comes_back)
                || (row.is_some() && self.ways.iter().take(self.carried).any(measures))
        })
    }

    /// The number of independent ones.
    pub(crate) const fn count(&self) -> usize {
        self.ways.len()
    }

    /// The part of a displacement in U.
    pub(crate) fn part(&self, q: &[F]) -> Vec<F> {
        let mut part = vec![F::int(0); q.len()];
        for way in &self.ways {
            add_times(&mut part, dot(&way.dual, q), &way.u);
        }
        part
    }

    /// Takes the part in U out of the displacements at the beginning of a list.
    pub(crate) fn remove(&self, list: &mut [F]) {
        for way in &self.ways {
            let share = dot(&way.dual, list);
            add_times(list, -share, &way.u);
        }
    }

    /// The combinations of rows over the state that vanish on U.
    pub(crate) fn blind(&self, mut rows: Vec<Vec<F>>) -> Vec<Vec<F>> {
        for way in &self.ways {
            let by = |row: &Vec<F>| dot(&way.u, row);
            let size =
                |row: &Vec<F>| row.iter().zip(&way.u).fold(F::int(0), |sum, (&x, &u)| sum + (x * u).abs());
            let sees = |row: &Vec<F>| by(row).abs() > size(row) * F::epsilon() * F::int(4096);
            let Some(place) = rows.iter().position(sees) else { continue };
            let pivot = rows.swap_remove(place);
            for row in &mut rows {
                let factor = by(row) / by(&pivot);
                add_times(row, -factor, &pivot);
            }
        }
        rows
    }
}

/// Whether the row of a body in K is too weak to change its motion in a time: `|k_ij| t² ≤ ε √(m_i m_j)`.
fn is_weak<F: Float>(system: &Assembly<F>, time: F, i: usize, row: &[F]) -> bool {
    let has_mass =
        |i: usize| !system.massless.contains(&i) && system.moved.iter().all(|moved| moved.coordinate != i);
    let root = |i: usize| system.mass.at(i, i).sqrt();
    let weak = |j: usize, k: F| k.abs() * time * time <= F::epsilon() * root(i) * root(j);
    has_mass(i) && row.iter().enumerate().all(|(j, &k)| k == F::int(0) || (has_mass(j) && weak(j, k)))
}

/// The sizes of displacements, velocities and forces that loads and frictions make, and the greatest rate of the springs.
pub(crate) struct Natural<F> {
    pub(crate) sizes: [F; 3],
    pub(crate) rate: F,
}

impl<F: Float> Natural<F> {
    /// The sum of the loads and frictions, what it does to the springs or, where they are so weak that it does less to the masses in a
    /// time, to the masses, and the velocities of belts.
    pub(crate) fn new(system: &Assembly<F>, time: F) -> Self {
        let zero = F::int(0);
        let (n, free) = (system.n, system.free);
        let reach = system.reach();
        let size = |row: &[F]| size_of_dot(row.get(free..).unwrap_or(&[]), &reach);
        let (mut force, mut stiffness, mut speed) = (zero, zero, zero);
        for row in system.stiffness.rows() {
            stiffness = row.iter().fold(stiffness, |most, x| most.or_larger(x.abs()));
        }
        for row in system.load.rows() {
            force = force + size(row);
        }
        for part in &system.parts {
            speed = speed.or_larger(size(&part.velocity));
            match &part.rule {
                // What presses on a stop is a load itself.
                Rule::Contact { .. } if part.under.is_some() => {}
                Rule::Contact { pieces, peak, normal } => {
                    let load = normal.as_ref().map_or(F::int(1), |row| size(row));
                    let most = pieces.iter().fold(zero, |most, piece| most.or_larger(piece.force));
                    force = force + most * *peak * load;
                }
                Rule::Elastic { stiffness: own, bound, .. } => {
                    force = force + size(bound);
                    stiffness = stiffness.or_larger(*own);
                }
                Rule::Stop { stiffness: own, .. } => stiffness = stiffness.or_larger(*own),
                Rule::Spring { pieces } => stiffness = stiffness.or_larger(stiffest(pieces)),
                Rule::Hard { .. } => {}
            }
        }
        let moved = |i: &usize| system.moved.iter().any(|moved| moved.coordinate == *i);
        let mass = (0..n).filter(|i| !moved(i) && !system.massless.contains(i)).map(|i| system.mass.at(i, i));
        let mass = mass.reduce(|a, b| if b < a { b } else { a }).unwrap_or(F::int(1));
        let rate = (stiffness / mass).sqrt();
        // A load F moves a mass on a spring by F/k and F/√(k m) at most, and one without a spring by F t²/m and F t/m.
        let is_stiff = rate * time > F::int(1);
        let displacement = if is_stiff { force / stiffness } else { force / mass * time * time };
        let velocity = if is_stiff { displacement * rate } else { force / mass * time };
        let sizes = [displacement, velocity.or_larger(speed), force];
        Self { sizes: sizes.map(|x| if x.is_finite() { x } else { zero }), rate }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::{Element, Kind, Model, Signal, System};

    fn drift(stiffness: Vec<Vec<f64>>, elements: Vec<Element<f64>>) -> Drift<f64> {
        let n = stiffness.len();
        let diagonal = |x: f64| -> Vec<Vec<f64>> {
            (0..n)
                .map(|i| (0..n).map(|j| if i == j { x * (1 + 99 * i) as f64 } else { 0.0 }).collect())
                .collect()
        };
        let model =
            Model { mass: diagonal(3.0), damping: diagonal(1.0), stiffness, elements, ..Model::default() };
        Drift::new(&System::new(&model).unwrap().assembly, 1.0)
    }

    /// Two bodies on a spring of 698 move as one; a spring of 10⁻⁹ of that to the ground, or a stop, holds them.
    #[test]
    fn a_weak_spring_or_a_stop_holds_the_whole() {
        let pair = |ground: f64| vec![vec![698.0 + ground, -698.0], vec![-698.0, 698.0]];
        let free = drift(pair(0.0), Vec::new());
        assert_eq!(free.count(), 1);
        let part = free.part(&[2.0, -1.0]);
        // The centre of mass: (2 − 100)/101.
        assert!(part.iter().all(|x| (x + 98.0 / 101.0).abs() < 1e-14), "{part:?}");
        assert_eq!(drift(pair(698e-9), Vec::new()).count(), 0);
        let stop = Element {
            name: String::new(),
            direction: vec![0.0, 1.0],
            moves: Signal::constant(0.0),
            kind: Kind::Stop { gap: 1.0, stiffness: 1.0, damping: 0.0 },
        };
        assert_eq!(drift(pair(0.0), vec![stop]).count(), 0);
        assert_eq!(drift(vec![vec![0.0; 3]; 3], Vec::new()).count(), 3);
    }
}
