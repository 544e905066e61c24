//! Motions that keep to one branch for ever, since no guard of it can reach zero.
//!
//! Let x be a fixed point whose period has no event, m the least value of a guard g over it, and δ the difference from x of a motion in the same branch
//! with the same kept numbers. While the motion stays in the branch, `M δ″ + C δ′ + K δ = 0` with the springs of the branch in K and its dampers
//! in C, on the displacements that contacts at rest allow. The energy `E = ½ δ′·M δ′ + ½ δ·K δ` of each solution does not grow where C is not
//! negative, nor does that of `Aʲδ`, which is a solution, too. So with the norm dual to E
//!
//! `|g δ(t)| ≤ ‖g A⁻ʲ‖ √(2 E(Aʲδ))`, `‖(g_q, g_v)‖² = g_q·K⁻¹g_q + g_v·M⁻¹g_v`,
//!
//! now and ever after, for each j. With j = 0 the fast modes decide, which a structure has many of and which hardly move; a few j more
//! weigh the slow ones instead. Where the least of these bounds is below m for all guards, no event ever comes. The motion is linear then, and goes to x as its
//! multipliers say.

use super::assembly::{Assembly, Rule};
use super::branch::Branch;
use super::events::{Event, Stretch, Watch};
use super::first_passage::bernstein;
use super::matrix::{Matrix, add_times, at, dot, set};
use super::mode::Mode;
use super::waves;
use crate::float::Float;
use alloc::vec;
use alloc::vec::Vec;

/// The greatest j, and one.
const POWERS: usize = 5;

/// What bounds the guards of a branch.
pub(super) struct Calm<F> {
    stiffness: Matrix<F>,
    damping: Matrix<F>,
    /// M⁻¹ and K⁻¹ on the displacements that contacts at rest allow.
    inverse_mass: Matrix<F>,
    flexibility: Matrix<F>,
    /// ‖g A⁻ʲ‖ of each guard.
    norms: Vec<[F; POWERS]>,
}

/// A symmetric matrix without the coordinates that are prescribed: in their places it has ones on its diagonal.
pub(super) fn without_moved<F: Float>(system: &Assembly<F>, matrix: &Matrix<F>) -> Matrix<F> {
    let mut matrix = matrix.clone();
    for moved in &system.moved {
        for i in 0..system.n {
            matrix.set(i, moved.coordinate, F::int(0));
            matrix.set(moved.coordinate, i, F::int(0));
        }
        matrix.set(moved.coordinate, moved.coordinate, F::int(1));
    }
    matrix
}

/// Half the sum of a matrix and its transposed one.
pub(super) fn symmetric_part<F: Float>(matrix: &Matrix<F>) -> Matrix<F> {
    let mut sum = matrix.transposed();
    sum.plus(matrix);
    sum.map(|x| x / F::int(2))
}

/// Whether a symmetric matrix is not negative, to rounding.
pub(super) fn is_dissipative<F: Float>(matrix: &Matrix<F>) -> bool {
    let n = matrix.columns();
    let most = matrix.rows().flatten().fold(F::int(0), |most, x| most.or_larger(x.abs()));
    let mut lifted = matrix.clone();
    for i in 0..n {
        let diagonal = matrix.at(i, i);
        lifted.set(i, i, diagonal + most * F::epsilon() * F::int(64));
    }
    most == F::int(0) || lifted.cholesky(F::int(0)).is_ok()
}

/// Whether a matrix is symmetric, to rounding.
pub(super) fn is_symmetric<F: Float>(matrix: &Matrix<F>) -> bool {
    let most = matrix.rows().flatten().fold(F::int(0), |most, x| most.or_larger(x.abs()));
    let doubt = most * F::epsilon() * F::int(64);
    (0..matrix.columns()).all(|i| (0..i).all(|j| (matrix.at(i, j) - matrix.at(j, i)).abs() <= doubt))
}

impl<F: Float> Calm<F> {
    /// For a branch, where its guards have such bounds.
    pub(super) fn new(system: &Assembly<F>, branch: &Branch<F>) -> Option<Self> {
        if !system.massless.is_empty() || branch.tie.is_some() || !is_symmetric(&system.stiffness) {
            return None;
        }
        let (mut stiffness, mut damping) = (system.stiffness.clone(), symmetric_part(&system.damping));
        let mut held: Vec<&[F]> = Vec::new();
        let depends = |row: &[F]| row.iter().take(system.free).any(|&x| x != F::int(0));
        for (part, mode) in system.parts.iter().zip(&branch.modes) {
            let (spring, damper) = match (*mode, &part.rule) {
                (Mode::Stuck, _) => {
                    held.push(&part.direction);
                    continue;
                }
                (Mode::Holds, Rule::Elastic { stiffness, .. }) => (*stiffness, F::int(0)),
                (Mode::Yields { .. }, Rule::Elastic { bound, .. }) if depends(bound) => return None,
                (Mode::Slides { piece, .. }, Rule::Contact { pieces, normal, .. }) => {
                    let slope = pieces.get(piece).map_or(F::int(0), |piece| piece.slope);
                    match normal {
                        Some(normal) if slope != F::int(0) || depends(normal) => return None,
                        _ => (F::int(0), slope),
                    }
                }
                (Mode::Pressed, Rule::Stop { stiffness, damping, .. }) => (*stiffness, *damping),
                (Mode::Bends { piece }, Rule::Spring { pieces }) => {
                    (pieces.get(piece).map_or(F::int(0), |piece| piece.slope), F::int(0))
                }
                (Mode::Yields { .. } | Mode::Apart | Mode::Away, _) => continue,
                _ => return None,
            };
            for (i, &b) in part.direction.iter().enumerate().filter(|(_, b)| **b != F::int(0)) {
                add_times(stiffness.row_mut(i), b * spring, &part.direction);
                add_times(damping.row_mut(i), b * damper, &part.direction);
            }
        }
        if !is_dissipative(&without_moved(system, &damping)) {
            return None;
        }
        let mut flexibility = without_moved(system, &stiffness).inverse_of_definite().ok()?;
        system.moved.iter().for_each(|moved| flexibility.set(moved.coordinate, moved.coordinate, F::int(0)));
        let flexibility = within(flexibility, &held);
        let inverse_mass = within(system.inverse_mass.clone(), &held);
        let mut calm = Self { stiffness, damping, inverse_mass, flexibility, norms: Vec::new() };
        calm.norms =
            branch.guards.iter().map(|guard| calm.norms(system, &branch.modes, &guard.row)).collect();
        Some(calm)
    }

    /// ‖g A⁻ʲ‖ of a guard's row.
    fn norms(&self, system: &Assembly<F>, modes: &[Mode], row: &[F]) -> [F; POWERS] {
        let n = system.n;
        let [mut q, mut v] = [0, n].map(|from| row.get(from..from + n).unwrap_or(&[]).to_vec());
        for (part, mode) in system.parts.iter().zip(modes) {
            if let (Mode::Holds, Rule::Elastic { stiffness, place, .. }) = (mode, &part.rule) {
                add_times(&mut q, at(row, *place) * *stiffness, &part.direction);
            }
        }
        [(); POWERS].map(|()| {
            let bent = self.flexibility.of(&q);
            let norm = (dot(&q, &bent) + dot(&v, &self.inverse_mass.of(&v))).sqrt();
            let mut next = self.damping.of(&bent);
            next.iter_mut().zip(&v).for_each(|(x, &v)| *x = v - *x);
            v = system.mass.of(&bent).into_iter().map(|x| -x).collect();
            q = next;
            norm
        })
    }

    /// √(2 E(Aʲδ)) of a difference δ of two states.
    fn sizes(&self, system: &Assembly<F>, delta: &[F]) -> [F; POWERS] {
        let n = system.n;
        let [mut q, mut v] = [0, n].map(|from| delta.get(from..from + n).unwrap_or(&[]).to_vec());
        for moved in &system.moved {
            set(&mut q, moved.coordinate, F::int(0));
            set(&mut v, moved.coordinate, F::int(0));
        }
        [(); POWERS].map(|()| {
            let mut force = self.stiffness.of(&q);
            let energy = dot(&q, &force) + dot(&v, &system.mass.of(&v));
            add_times(&mut force, F::int(1), &self.damping.of(&v));
            let slope = self.inverse_mass.of(&force).into_iter().map(|x| -x).collect();
            q = core::mem::replace(&mut v, slope);
            energy.sqrt()
        })
    }

    /// Whether no guard reaches zero after a difference δ from a motion whose guards have these least values.
    pub(super) fn stays(&self, system: &Assembly<F>, delta: &[F], margins: &Margins<F>) -> bool {
        let sizes = self.sizes(system, delta);
        let least = |norms: &[F; POWERS]| {
            let bounds = norms.iter().zip(&sizes).map(|(&norm, &size)| norm * size);
            bounds.reduce(|a, b| if b < a { b } else { a })
        };
        // An eighth is left for rounding.
        self.norms.len() == margins.least.len()
            && self.norms.iter().zip(&margins.least).all(|(norms, &(.., margin))| {
                least(norms).is_some_and(|bound| bound * F::int(8) <= margin * F::int(7))
            })
    }
}

/// The inverse of a matrix on the displacements without those directions: `Y − Y B (BᵀY B)⁺ BᵀY`.
fn within<F: Float>(mut inverse: Matrix<F>, held: &[&[F]]) -> Matrix<F> {
    let moved: Vec<Vec<F>> = held.iter().map(|b| inverse.of(b)).collect();
    let mut coupling = Matrix::zero(held.len(), held.len());
    for (i, b) in held.iter().enumerate() {
        moved.iter().enumerate().for_each(|(j, y)| coupling.set(i, j, dot(b, y)));
    }
    let coupling = coupling.pseudo_inverse();
    for (i, y) in moved.iter().enumerate() {
        let mut sum = vec![F::int(0); y.len()];
        moved.iter().enumerate().for_each(|(j, other)| add_times(&mut sum, coupling.at(i, j), other));
        for (k, &x) in y.iter().enumerate().filter(|(_, x)| **x != F::int(0)) {
            add_times(inverse.row_mut(k), -x, &sum);
        }
    }
    inverse
}

/// The least values of guards over a motion.
pub(super) struct Margins<F> {
    /// The place of each guard in its branch, its element and its least value.
    pub(super) least: Vec<(usize, usize, F)>,
    terms: Vec<F>,
    polynomial: Vec<F>,
}

impl<F: Float> Margins<F> {
    pub(super) const fn new() -> Self {
        Self { least: Vec::new(), terms: Vec::new(), polynomial: Vec::new() }
    }
}

impl<F: Float> Watch<F> for Margins<F> {
    fn stretch(&mut self, system: &Assembly<F>, stretch: &Stretch<'_, F>) {
        stretch.taylor(&mut self.terms);
        let waves = stretch.leap.as_ref().and_then(|leap| leap.waves(stretch.from, stretch.to));
        let Self { least, terms, polynomial } = self;
        for (place, guard) in stretch.branch.guards.iter().enumerate() {
            polynomial.clear();
            polynomial.extend(terms.chunks_exact(system.size.max(1)).map(|term| dot(&guard.row, term)));
            let reach = waves.as_ref().map_or(F::int(0), |waves| waves::reach(&waves.of(&guard.row)));
            for b in bernstein(polynomial) {
                let margin = b - reach;
                match least.iter_mut().find(|(at, element, _)| (*at, *element) == (place, guard.element)) {
                    Some((.., least)) => *least = if margin >= *least { *least } else { margin },
                    None => least.push((place, guard.element, margin)),
                }
            }
        }
    }

    fn event(&mut self, _: Event<F>) {}
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::follow::Follower;
    use crate::system::{Element, Harmonic, Kind, Law, Model, Signal, State, System};

    fn next(seed: &mut u64) -> f64 {
        *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*seed >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Five bodies on springs, of which one sticks and one holds a slider, one is on a belt and one before a stop: no guard gets farther from
    /// the motion at rest than the bound says, by samples of the motion itself, and the bound is not far above it.
    #[test]
    fn bounds_hold_for_the_motion() {
        let n = 5;
        let mut seed = 1;
        let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
        for _ in 0..20 {
            let zero = || vec![vec![0.0; n]; n];
            let (mut mass, mut damping, mut stiffness) = (zero(), zero(), zero());
            for i in 0..n {
                mass[i][i] = 0.5 + next(&mut seed);
                for (matrix, x) in
                    [(&mut stiffness, 1.0 + 20.0 * next(&mut seed)), (&mut damping, 0.05 * next(&mut seed))]
                {
                    matrix[i][i] += x;
                    if i > 0 {
                        matrix[i - 1][i - 1] += x;
                        matrix[i - 1][i] -= x;
                        matrix[i][i - 1] -= x;
                    }
                }
            }
            let unit = |at: usize| (0..n).map(|i| if i == at { 1.0 } else { 0.0 }).collect::<Vec<f64>>();
            let element = |at: usize, moves: f64, kind: Kind<f64>| Element {
                name: String::new(),
                direction: unit(at),
                moves: Signal::constant(moves),
                kind,
            };
            let law = Law { points: vec![(0.0, 1.0), (10.0, 1.5)] };
            let elements = vec![
                element(1, 0.0, Kind::Contact { law: Law::constant(1e3), peak: 1.0, normal: None }),
                element(2, 0.0, Kind::Elastic { stiffness: 3.0, friction: 1e3, normal: None }),
                element(3, 5.0, Kind::Contact { law, peak: 1.0, normal: None }),
                element(4, 0.0, Kind::Stop { gap: 1e3, stiffness: 1.0, damping: 0.0 }),
            ];
            let harmonics = vec![Harmonic { frequency: 1.0, sin: vec![0.0; n], cos: vec![] }];
            let model = Model { mass, damping, stiffness, elements, harmonics, ..Model::default() };
            let system = System::new(&model).unwrap();
            let state = |displacement: Vec<f64>, velocity: Vec<f64>| {
                let force = vec![0.0, 3.0 * displacement[2]];
                State { displacement, velocity, force, ..State::rest(n) }
            };
            let mut random = |held: usize| -> Vec<f64> {
                (0..n).map(|i| if i == held { 0.0 } else { next(&mut seed) - 0.5 }).collect()
            };
            let (a, b) = (state(random(1), random(1)), state(random(1), random(1)));
            let of = |start: &State<f64>| Follower::new(&system.assembly, start, 400.0).unwrap();
            let (mut one, mut other) = (of(&a), of(&b));
            let branch = one.branch().unwrap().clone();
            assert_eq!(branch.modes, other.branch().unwrap().modes);
            let calm = Calm::new(&system.assembly, &branch).unwrap();
            let delta = |one: &Follower<'_, f64>, other: &Follower<'_, f64>| -> Vec<f64> {
                one.z.iter().zip(&other.z).map(|(a, b)| a - b).collect()
            };
            let first = delta(&one, &other);
            let sizes = calm.sizes(&system.assembly, &first);
            let mut seen = vec![0.0_f64; branch.guards.len()];
            for k in 1..4000 {
                one.run(0.1 * f64::from(k), &mut ()).unwrap();
                other.run(0.1 * f64::from(k), &mut ()).unwrap();
                assert_eq!(one.branch().unwrap().modes, branch.modes);
                let delta = delta(&one, &other);
                for (seen, guard) in seen.iter_mut().zip(&branch.guards) {
                    *seen = seen.max(dot(&guard.row, &delta).abs());
                }
            }
            for (seen, norms) in seen.iter().zip(&calm.norms) {
                for (j, (norm, size)) in norms.iter().zip(&sizes).enumerate() {
                    assert!(*seen <= norm * size, "{j}: {seen} {}", norm * size);
                }
                let bound = norms.iter().zip(&sizes).map(|(a, b)| a * b).fold(f64::INFINITY, f64::min);
                (least, most) = (least.min(seen / bound), most.max(seen / bound));
            }
        }
        assert!(least > 0.1 && most > 0.5 && most < 1.0, "{least} {most}");
    }
}
