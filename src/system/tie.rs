//! What coordinates without mass do in a branch: the rows that replace their velocities, and the forces that balance there. `massless.rs` has
//! the derivation.

use super::assembly::{Assembly, Part, Rule};
use super::matrix::{Matrix, absolute, add_times, at, clear, dot, set, size_of_dot};
use super::mode::{Mode, sign, yields};
use crate::float::Float;
use alloc::vec;
use alloc::vec::Vec;

/// The entries of a row at some places.
fn part_of<F: Float>(row: &[F], places: &[usize]) -> Vec<F> {
    places.iter().map(|&i| at(row, i)).collect()
}

/// The eigenvectors of a symmetric matrix in the span of an orthonormal basis: those with a positive value, the others, and whether one of these
/// is negative. `largest` is the size beside which a value is zero.
pub(super) struct Split<F> {
    pub(super) held: Vec<(F, Vec<F>)>,
    pub(super) open: Vec<Vec<F>>,
    falls: bool,
}

pub(super) fn split<F: Float>(matrix: &Matrix<F>, basis: &[Vec<F>], largest: F) -> Split<F> {
    let mut inner = Matrix::zero(basis.len(), basis.len());
    for (i, a) in basis.iter().enumerate() {
        let image = matrix.of(a);
        basis.iter().enumerate().for_each(|(j, b)| inner.set(i, j, dot(b, &image)));
    }
    let mut result = Split { held: Vec::new(), open: Vec::new(), falls: false };
    let none = largest * F::epsilon() * F::int(1024);
    let (values, modes) = inner.symmetric_modes();
    for (&value, mode) in values.iter().zip(modes.rows()) {
        let mut vector = vec![F::int(0); matrix.columns()];
        mode.iter().zip(basis).for_each(|(&x, b)| add_times(&mut vector, x, b));
        if value > none {
            result.held.push((value, vector));
        } else {
            result.falls |= value < -none;
            result.open.push(vector);
        }
    }
    result
}

pub(super) fn units<F: Float>(count: usize) -> Vec<Vec<F>> {
    Matrix::identity(count).rows().map(<[F]>::to_vec).collect()
}

pub(super) fn largest<F: Float>(matrix: &Matrix<F>) -> F {
    matrix.rows().flatten().fold(F::int(0), |most, x| most.or_larger(x.abs()))
}

/// A direction along which springs balance the forces.
#[derive(Debug, Clone)]
struct Balance<F> {
    /// The row of the displacement that is missing to the balance.
    missing: Vec<F>,
    /// The direction, at displacements and at forces of elastic contacts.
    way: Vec<(usize, F)>,
}

/// What the coordinates without mass do in a branch.
#[derive(Debug, Clone)]
pub(crate) struct Tie<F> {
    /// A coordinate that nothing holds.
    pub(crate) free: Option<usize>,
    /// The places of the velocities, with their rows W.
    velocity: Vec<(usize, Vec<F>)>,
    balance: Vec<Balance<F>>,
    /// `β⁺` of each contact that sticks.
    lift: Vec<Vec<F>>,
    /// Y.
    slack: Vec<Vec<F>>,
    /// `(Yᵀ Bᵀ M⁻¹ B Y)⁺`.
    inverse: Matrix<F>,
    /// What takes the velocities of all that sticks out of the bodies with mass: rows of impulses, with what each does.
    still: Vec<(Vec<F>, Vec<F>)>,
}

impl<F: Float> Tie<F> {
    /// `force` has the rows of all forces but for those of the contacts that stick.
    pub(crate) fn new(system: &Assembly<F>, modes: &[Mode], stuck: &[usize], force: &Matrix<F>) -> Self {
        let (n, zero) = (system.n, F::int(0));
        let places = &system.massless;
        let count = places.len();
        let sticks = || stuck.iter().filter_map(|&i| system.parts.get(i));
        let beta: Vec<Vec<F>> = sticks().map(|part| part_of(&part.direction, places)).collect();
        let (mut gram, mut outer) = (Matrix::zero(stuck.len(), stuck.len()), Matrix::zero(count, count));
        for (i, a) in beta.iter().enumerate() {
            beta.iter().enumerate().for_each(|(j, b)| gram.set(i, j, dot(a, b)));
            a.iter().enumerate().for_each(|(k, &x)| add_times(outer.row_mut(k), x, a));
        }
        let slack = split(&gram, &units(stuck.len()), largest(&gram)).open;
        let lift: Vec<Vec<F>> = gram
            .pseudo_inverse()
            .rows()
            .map(|row| {
                let mut sum = vec![zero; count];
                row.iter().zip(&beta).for_each(|(&x, b)| add_times(&mut sum, x, b));
                sum
            })
            .collect();
        let mut tie = Self {
            free: None,
            velocity: places.iter().map(|&i| (n + i, vec![zero; system.size])).collect(),
            balance: Vec::new(),
            lift,
            slack,
            inverse: Matrix::zero(0, 0),
            still: Vec::new(),
        };
        for (part, lift) in sticks().zip(tie.lift.clone()) {
            let mut row: Vec<F> = part.velocity.iter().map(|&x| -x).collect();
            places.iter().for_each(|&i| clear(&mut row, n + i));
            tie.add(&lift, &row);
        }
        let rows: Vec<&[F]> = places.iter().map(|&i| force.row(i)).collect();
        let mut statics: Vec<Vec<F>> = rows.iter().map(|row| row.to_vec()).collect();
        statics.iter_mut().for_each(|row| places.iter().for_each(|&i| clear(row, n + i)));
        let along = |u: &[F], rows: &[Vec<F>]| {
            let mut sum = vec![zero; system.size];
            u.iter().zip(rows).for_each(|(&x, row)| add_times(&mut sum, x, row));
            sum
        };
        let left = split(&outer, &units(count), largest(&outer)).open;
        // Dampers.
        let mut damping = Matrix::zero(count, count);
        for (k, row) in rows.iter().enumerate() {
            places.iter().enumerate().for_each(|(l, &i)| damping.set(k, l, -at(row, n + i)));
        }
        let by_dampers = split(&damping, &left, largest(&damping));
        let known: Vec<Vec<F>> = tie.velocity.iter().map(|(_, row)| row.clone()).collect();
        for (value, u) in &by_dampers.held {
            let mut row = along(u, &statics);
            add_times(&mut row, -F::int(1), &along(&damping.of(u), &known));
            let by: Vec<F> = u.iter().map(|&x| x / *value).collect();
            tie.add(&by, &row);
        }
        // Springs.
        let holding = || {
            system.parts.iter().zip(modes).filter_map(|(part, mode)| match (&part.rule, mode) {
                (Rule::Elastic { stiffness, place, .. }, Mode::Holds) => Some((part, *stiffness, *place)),
                _ => None,
            })
        };
        let mut stiffness = Matrix::zero(count, count);
        for (k, row) in rows.iter().enumerate() {
            for (l, &i) in places.iter().enumerate() {
                let own = |sum: F, (part, by, place): (&Part<F>, F, usize)| {
                    sum + at(row, place) * by * at(&part.direction, i)
                };
                stiffness.set(k, l, -holding().fold(at(row, i), own));
            }
        }
        let by_springs = split(&stiffness, &by_dampers.open, largest(&stiffness));
        let mut found = Vec::new();
        for (value, u) in &by_springs.held {
            let row = along(u, &statics);
            let mut rate = system.derivative(&row);
            for i in 0..n {
                let by = at(&row, i);
                match places.iter().position(|&place| place == i) {
                    Some(k) => {
                        tie.velocity.get(k).into_iter().for_each(|(_, row)| add_times(&mut rate, by, row));
                    }
                    None => {
                        let x = at(&rate, n + i) + by;
                        set(&mut rate, n + i, x);
                    }
                }
            }
            for (part, by, place) in holding() {
                let mut own = part.velocity.clone();
                tie.substitute(&mut own);
                add_times(&mut rate, at(&row, place) * by, &own);
            }
            let by: Vec<F> = u.iter().map(|&x| x / *value).collect();
            found.push((by, rate));
            let mut missing = row;
            missing.iter_mut().for_each(|x| *x = *x / *value);
            let mut way: Vec<(usize, F)> = places.iter().copied().zip(u.iter().copied()).collect();
            way.extend(
                holding().map(|(part, by, place)| (place, by * dot(&part_of(&part.direction, places), u))),
            );
            tie.balance.push(Balance { missing, way });
        }
        found.iter().for_each(|(by, rate)| tie.add(by, rate));
        if by_springs.falls || by_dampers.falls || !by_springs.open.is_empty() {
            let vector = by_springs.open.first();
            let entry = |k: usize| vector.map_or(zero, |u| at(u, k).abs());
            let most = (0..count).fold(0, |most, k| if entry(k) > entry(most) { k } else { most });
            tie.free = places.get(most).copied();
        }
        tie.hold_still(system, stuck);
        tie
    }

    /// `w += by row`.
    fn add(&mut self, by: &[F], row: &[F]) {
        self.velocity.iter_mut().zip(by).for_each(|((_, own), &by)| add_times(own, by, row));
    }

    fn hold_still(&mut self, system: &Assembly<F>, stuck: &[usize]) {
        let coupling = system.coupling_of(stuck);
        let count = self.slack.len();
        let mut inner = Matrix::zero(count, count);
        for (a, y) in self.slack.iter().enumerate() {
            let image = coupling.of(y);
            self.slack.iter().enumerate().for_each(|(b, y)| inner.set(a, b, dot(y, &image)));
        }
        self.inverse = inner.pseudo_inverse();
        let mut both = Vec::new();
        for y in &self.slack {
            let (mut row, mut response) = (vec![F::int(0); system.size], vec![F::int(0); system.n]);
            for (&i, &x) in stuck.iter().zip(y) {
                let Some(part) = system.parts.get(i) else { continue };
                add_times(&mut row, x, &part.velocity);
                add_times(&mut response, x, &part.response);
            }
            self.substitute(&mut row);
            both.push((row, response));
        }
        for (a, (_, response)) in both.iter().enumerate() {
            let mut row = vec![F::int(0); system.size];
            self.inverse.row(a).iter().zip(&both).for_each(|(&x, (other, _))| add_times(&mut row, x, other));
            self.still.push((row, response.clone()));
        }
    }

    /// Adds the forces of the contacts that stick, as far as they are missing to the balance and to the rest of the bodies.
    pub(crate) fn hold(
        &self,
        system: &Assembly<F>,
        stuck: &[usize],
        force: &mut Matrix<F>,
        tension: &mut [Vec<F>],
    ) {
        let mut apply = |force: &mut Matrix<F>, place: usize, row: &[F]| {
            if let (Some(part), Some(tension)) = (system.parts.get(place), tension.get_mut(place)) {
                add_times(tension, F::int(1), row);
                force.less_product(&part.direction, row);
            }
        };
        let balance: Vec<Vec<F>> = system
            .massless
            .iter()
            .map(|&i| {
                let mut row = force.row(i).to_vec();
                self.substitute(&mut row);
                row
            })
            .collect();
        for (&i, lift) in stuck.iter().zip(&self.lift) {
            let mut row = vec![F::int(0); system.size];
            lift.iter().zip(&balance).for_each(|(&x, own)| add_times(&mut row, x, own));
            apply(force, i, &row);
        }
        let left: Vec<Vec<F>> = stuck
            .iter()
            .filter_map(|&i| system.parts.get(i))
            .map(|part| {
                let mut row = force.combined(&part.response);
                add_times(&mut row, F::int(-1), &part.moves);
                row
            })
            .collect();
        for (a, _) in self.slack.iter().enumerate() {
            let mut row = vec![F::int(0); system.size];
            for (y, &x) in self.slack.iter().zip(self.inverse.row(a)) {
                y.iter().zip(&left).for_each(|(&y, own)| add_times(&mut row, x * y, own));
            }
            let y = self.slack.get(a).map_or(&[][..], Vec::as_slice);
            for (&i, &y) in stuck.iter().zip(y) {
                let share: Vec<F> = row.iter().map(|&x| x * y).collect();
                apply(force, i, &share);
            }
        }
    }

    /// A row without the velocities of the coordinates without mass.
    pub(crate) fn substitute(&self, row: &mut [F]) {
        substitute(&self.velocity, row);
    }

    /// The size of a row's product, in whose terms these velocities have the sizes of what they follow from.
    pub(crate) fn size(&self, row: &[F], sizes: &[F]) -> F {
        let mut rest = row.to_vec();
        let own = self.velocity.iter().fold(F::int(0), |sum, (slot, velocity)| {
            clear(&mut rest, *slot);
            sum + at(row, *slot).abs() * size_of_dot(velocity, sizes)
        });
        own + size_of_dot(&rest, sizes)
    }

    /// The velocities' rows, with their places.
    pub(crate) fn rows(&self) -> &[(usize, Vec<F>)] {
        &self.velocity
    }

    /// Brings a state, or a disturbance of one, to what the branch admits: what sticks has no velocity, the forces balance, and velocities
    /// without mass follow.
    pub(crate) fn project(&self, system: &Assembly<F>, modes: &[Mode], z: &mut [F]) {
        let n = system.n;
        for (part, mode) in system.parts.iter().zip(modes) {
            if let Mode::Yields { forward } = mode {
                yields(part, *forward, z);
            }
        }
        let impulses: Vec<F> = self.still.iter().map(|(row, _)| dot(row, z)).collect();
        for ((_, response), &impulse) in self.still.iter().zip(&impulses) {
            add_times(z.get_mut(n..2 * n).unwrap_or(&mut []), -impulse, response);
        }
        let missing: Vec<F> = self.balance.iter().map(|balance| dot(&balance.missing, z)).collect();
        for (balance, &missing) in self.balance.iter().zip(&missing) {
            for &(place, by) in &balance.way {
                let x = at(z, place) + by * missing;
                set(z, place, x);
            }
        }
        let velocities: Vec<F> = self.velocity.iter().map(|(_, row)| dot(row, z)).collect();
        self.velocity.iter().zip(velocities).for_each(|((slot, _), x)| set(z, *slot, x));
    }

    /// Whether a state is that of the branch with these modes but for rounding. `within` has what the velocities could be within a step.
    pub(crate) fn admits(&self, system: &Assembly<F>, modes: &[Mode], z: &[F], within: &[F]) -> bool {
        let sizes = absolute(z);
        let wide = F::epsilon() * F::int(1 << 14);
        let is_balanced = |balance: &Balance<F>| {
            dot(&balance.missing, z).abs() <= size_of_dot(&balance.missing, &sizes) * wide
        };
        let yields = |(part, mode): (&Part<F>, &Mode)| match (&part.rule, mode) {
            (Rule::Elastic { place, bound, .. }, Mode::Yields { forward }) if system.is_light(part) => {
                let force = sign::<F>(*forward) * dot(bound, z);
                (force - at(z, *place)).abs() <= size_of_dot(bound, &sizes) * wide
            }
            _ => true,
        };
        let rests = |(part, mode): (&Part<F>, &Mode)| {
            if *mode != Mode::Stuck {
                return true;
            }
            let mut row = part.velocity.clone();
            self.substitute(&mut row);
            let size = self.size(&part.velocity, &sizes) + self.size(&part.velocity, within);
            dot(&row, z).abs() <= size * wide
        };
        let parts = || system.parts.iter().zip(modes);
        self.balance.iter().all(is_balanced) && parts().all(yields) && parts().all(rests)
    }
}

fn substitute<F: Float>(velocity: &[(usize, Vec<F>)], row: &mut [F]) {
    for (slot, own) in velocity {
        let by = at(row, *slot);
        if by != F::int(0) {
            clear(row, *slot);
            add_times(row, by, own);
        }
    }
}
