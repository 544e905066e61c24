//! Coordinates without mass, such as the joint of a pendulum bearing: the limit m → 0 of their motion.
//!
//! The forces on such a coordinate balance at all times, `0 = f − C q′ − K q − Σ b T`. Its velocity w is therefore no state, but
//! follows in each branch from the others, in three steps:
//!
//! 1. A contact that sticks ties it, `b·q′ = V`.
//! 2. Along the directions that are left, dampers carry the forces: `C w = f − K q − Σ b T`.
//! 3. Where there is no damper either, the balance holds for all times, and so does its derivative: `K w = (f − Σ b T)′` less that of
//!    the other coordinates. This is the Schur complement of the stiffness. Elastic contacts that hold, and stops in touch, belong to K.
//!
//! What is left then is free: nothing holds it, and there is no motion. Otherwise w = W z, and W replaces the velocities in all rows, so
//! that their places in the state depend on the others and no others on them.
//!
//! **Forces of contacts that stick.** With the parts β of their directions at these coordinates, the balance gives `β T` and so T
//! but for `T₀ + Y λ`, where β Y = 0: several contacts one behind the other, which all stick. These tie the bodies with mass, and λ
//! follows from their accelerations.
//!
//! **The next branch.** Velocities may change at once at an event, since nothing is inert. All contacts at these coordinates are
//! therefore decided anew, together with the others at rest. The motion over a short time h with `q = q₀ + h q′` and
//! `M (q′ − q′₀)/h = F(q, q′) − B T` is the least value of a quadratic form in the box |T| ≤ R, as in `next_branch.rs`, for M = 0, too. It
//! proposes a branch, for shorter and shorter h. A branch is taken where it is consistent, which h has no part in: the forces balance where the
//! coordinates are, what sticks has no velocity, and the first derivative that is not zero of each guard is positive.
//!
//! **Start.** A coordinate without mass that is out of balance moves at once to where the forces balance, and its contacts hold it as far
//! as they can: the displacements of the start are those before this. With a damper it takes its time.

use super::assembly::{Assembly, Rule};
use super::branch::{Branch, static_bound};
use super::branches::Branches;
use super::dependent::least;
use super::equation::given_tension;
use super::error::Error;
use super::matrix::{Matrix, absolute, add_times, at, clear, dot, set, size_of_dot};
use super::mode::Mode;
use super::tie::{largest, split, units};
use crate::float::Float;
use alloc::format;
use alloc::vec;
use alloc::vec::Vec;

/// How many derivatives of a guard are looked at.
const DERIVATIVES: usize = 8;

/// The elements that are decided anew at each event: those at coordinates without mass, with stops at their gap, and the contacts at
/// rest.
pub(crate) fn open<F: Float>(system: &Assembly<F>, z: &[F], modes: &[Mode], resting: &[usize]) -> Vec<usize> {
    let decides = |&i: &usize| {
        let Some(part) = system.parts.get(i) else { return false };
        let acts = match &part.rule {
            Rule::Stop { depth, .. } => {
                let wide = F::epsilon() * F::int(1 << 14);
                dot(depth, z).abs() <= size_of_dot(depth, &absolute(z)) * wide
            }
            Rule::Contact { .. } | Rule::Elastic { .. } | Rule::Hard { .. } | Rule::Spring { .. } => {
                modes.get(i).is_some_and(|mode| *mode != Mode::Apart)
            }
        };
        resting.contains(&i) || (acts && system.is_light(part))
    };
    (0..modes.len()).filter(decides).collect()
}

/// The modes after an event, with the state in them: the first consistent ones of those given, and of what short steps propose. The present
/// branch is theirs. The error is a coordinate that nothing holds, if that is the reason.
pub(crate) fn decide<F: Float>(
    system: &Assembly<F>,
    branches: &mut Branches<F>,
    z: &[F],
    first: &[Vec<Mode>],
    open: &[usize],
) -> Result<(Vec<Mode>, Vec<F>), Option<usize>> {
    let mut tried: Vec<Vec<Mode>> = Vec::new();
    let mut free = None;
    let mut consistent = |modes: Vec<Mode>, branches: &mut Branches<F>| {
        if tried.contains(&modes) {
            return None;
        }
        branches.enter(system, &modes);
        let branch = branches.current()?;
        let tie = branch.tie.as_ref()?;
        tried.push(modes.clone());
        if let Some(place) = tie.free {
            free = Some(place);
            return None;
        }
        // A velocity is zero beside what it could be within a step.
        let mut within = vec![F::int(0); z.len()];
        let velocities = within.get_mut(system.n..).unwrap_or(&mut []);
        for (x, a) in velocities.iter_mut().zip(accelerations(system, branch, &absolute(z))) {
            *x = a * branch.step;
        }
        if !tie.admits(system, &branch.modes, z, &within) {
            return None;
        }
        let mut state = z.to_vec();
        tie.project(system, &modes, &mut state);
        goes_on(system, branch, &state, open).then_some((modes, state))
    };
    for modes in first {
        if let Some(found) = consistent(modes.clone(), branches) {
            return Ok(found);
        }
    }
    let modes = first.last().cloned().unwrap_or_default();
    let mut time = branches.current().map_or(F::int(1), |branch| branch.step);
    for _ in 0..10 {
        time = time / F::int(4);
        let Some(step) = Implicit::new(system, z, &modes, open, Some(time)) else { continue };
        for sure in [false, true] {
            let proposed = step.modes(system, &modes, open, sure);
            if let Some(found) = consistent(proposed, branches) {
                return Ok(found);
            }
        }
    }
    Err(free)
}

/// Whether the guards of some elements begin with a positive derivative in a branch, and what sticks stays.
fn goes_on<F: Float>(system: &Assembly<F>, branch: &Branch<F>, z: &[F], open: &[usize]) -> bool {
    let mut terms = vec![z.to_vec()];
    let mut sizes = vec![absolute(z)];
    for k in 1..=DERIVATIVES {
        let (Some(term), Some(size)) = (terms.last(), sizes.last()) else { break };
        let by = branch.step / F::int(i32::try_from(k).unwrap_or(1));
        let next = branch.derivative(term).iter().map(|&x| x * by).collect();
        let inert = accelerations(system, branch, size);
        let mut size: Vec<F> = (0..z.len()).map(|i| branch.size_of_slope(i, size) * by).collect();
        let velocities = size.get_mut(system.n..).unwrap_or(&mut []);
        velocities.iter_mut().zip(&inert).for_each(|(x, &a)| *x = x.or_larger(a * by));
        terms.push(next);
        sizes.push(size);
    }
    let wide = F::epsilon() * F::int(1 << 12);
    let first = |row: &[F], error: F| {
        let mut next = F::int(0);
        terms.iter().zip(&sizes).zip(sizes.iter().skip(1)).enumerate().find_map(
            |(k, ((term, of_term), later))| {
                // The instant is known to rounding of a step, too.
                next = next + F::int(1);
                let size = |sizes: &[F]| match &branch.tie {
                    Some(tie) => tie.size(row, sizes),
                    None => size_of_dot(row, sizes),
                };
                let doubt = (size(of_term) + next * size(later)) * wide;
                let doubt = if k == 0 { doubt.or_larger(error) } else { doubt };
                let value = dot(row, term);
                (value.abs() > doubt).then_some(value > F::int(0))
            },
        )
    };
    let of_open = |element: &usize| open.contains(element);
    let guards = branch.guards.iter().filter(|guard| of_open(&guard.element));
    let lasts = |guard: &super::guard::Guard<F>| {
        let error = dot(&guard.error, sizes.first().map_or(&[][..], Vec::as_slice)) * F::int(16);
        first(&guard.row, error) != Some(false)
    };
    let stays = |&i: &usize| {
        let Some(part) = system.parts.get(i).filter(|_| branch.modes.get(i) == Some(&Mode::Stuck)) else {
            return true;
        };
        first(&part.velocity, F::int(0)).is_none()
    };
    guards.into_iter().all(lasts) && open.iter().all(stays)
}

/// The sizes of the accelerations that all forces would give without each other.
fn accelerations<F: Float>(system: &Assembly<F>, branch: &Branch<F>, sizes: &[F]) -> Vec<F> {
    let mut force: Vec<F> = system.force.rows().map(|row| size_of_dot(row, sizes)).collect();
    // Those of contacts that stick are shares of each other, and have the rounding of the largest.
    let each = branch.tension.iter().map(|tension| size_of_dot(tension, sizes));
    let largest = each.fold(F::int(0), F::or_larger);
    for part in &system.parts {
        force.iter_mut().zip(&part.direction).for_each(|(sum, &b)| *sum = *sum + b.abs() * largest);
    }
    system.inverse_mass.rows().map(|row| size_of_dot(row, &force)).collect()
}

/// Moves coordinates without mass that are out of balance to where the forces balance, with what their contacts can hold.
pub(crate) fn balance<F: Float>(system: &Assembly<F>, z: &mut [F], modes: &[Mode], open: &[usize]) {
    let is_light = |i: &&usize| system.parts.get(**i).is_some_and(|part| system.is_light(part));
    let open: Vec<usize> = open.iter().filter(is_light).copied().collect();
    // The weak springs of a way take off 2⁻³⁰ of it: what is left after another two is below the rounding of a double.
    for _ in 0..2 + F::precision() / 30 {
        let Some(step) = Implicit::new(system, z, modes, &open, None) else { return };
        for &i in &system.massless {
            let x = at(z, i) + at(&step.velocity, i);
            set(z, i, x);
        }
        for (&i, &force) in open.iter().zip(&step.tension) {
            if let Some(Rule::Elastic { place, .. }) = system.parts.get(i).map(|part| &part.rule) {
                set(z, *place, force);
            }
        }
    }
}

/// The motion over a short time, or the way to the balance.
struct Implicit<F> {
    /// The velocities, or the way.
    velocity: Vec<F>,
    tension: Vec<F>,
    bounds: Vec<F>,
    /// The velocities of the sliders, with their rounding.
    slip: Vec<(F, F)>,
}

impl<F: Float> Implicit<F> {
    /// Over a time; without one the way of the coordinates without mass to their balance, where no damper holds them.
    fn new(system: &Assembly<F>, z: &[F], modes: &[Mode], open: &[usize], time: Option<F>) -> Option<Self> {
        let (n, zero, one) = (system.n, F::int(0), F::int(1));
        let h = time.unwrap_or(one);
        let mut force = system.force.clone();
        for (i, (part, mode)) in system.parts.iter().zip(modes).enumerate() {
            if !open.contains(&i)
                && let Some(row) = given_tension(part, *mode)
            {
                force.less_product(&part.direction, &row);
            }
        }
        let holds = |(i, part, mode): (usize, &super::assembly::Part<F>, &Mode)| match (&part.rule, mode) {
            (Rule::Elastic { stiffness, place, .. }, Mode::Holds) if !open.contains(&i) => {
                Some((part.direction.clone(), *stiffness, *place))
            }
            _ => None,
        };
        let parts = || system.parts.iter().zip(modes).enumerate().map(|(i, (part, mode))| (i, part, mode));
        let holding: Vec<(Vec<F>, F, usize)> = parts().filter_map(holds).collect();
        let mut matrix = Matrix::zero(n, n);
        let mut right = vec![zero; n];
        for k in 0..n {
            let row = force.row(k).to_vec();
            for l in 0..n {
                let own =
                    |sum: F, (b, by, place): &(Vec<F>, F, usize)| sum + at(&row, *place) * *by * at(b, l);
                let stiffness = -holding.iter().fold(at(&row, l), own);
                let rest = if time.is_some() { system.mass.at(k, l) / h - at(&row, n + l) } else { zero };
                matrix.set(k, l, rest + h * stiffness);
            }
            let mut still = row;
            still.get_mut(n..2 * n).unwrap_or(&mut []).fill(zero);
            let mut sum = dot(&still, z);
            if time.is_some() {
                let momentum = dot(system.mass.row(k), z.get(n..2 * n).unwrap_or(&[]));
                sum = sum + momentum / h + h * dot(&system.derivative(&still), z);
            }
            set(&mut right, k, sum);
        }
        for k in 0..n {
            for l in 0..k {
                let mean = (matrix.at(k, l) + matrix.at(l, k)) / F::int(2);
                matrix.set(k, l, mean);
                matrix.set(l, k, mean);
            }
        }
        // Coordinates whose velocity is known.
        let mut given: Vec<Option<F>> = vec![None; n];
        if time.is_none() {
            for (i, given) in given.iter_mut().enumerate() {
                let moves = system.massless.contains(&i) && system.damping.at(i, i) <= zero;
                *given = (!moves).then_some(zero);
            }
        }
        for driven in &system.moved {
            let velocity = at(z, n + driven.coordinate) + h * dot(&driven.acceleration, z);
            if let Some(given) = given.get_mut(driven.coordinate) {
                *given = Some(if time.is_some() { velocity } else { zero });
            }
        }
        let known = || given.iter().enumerate().filter_map(|(i, x)| Some((i, (*x)?)));
        for (l, x) in known() {
            for (k, right) in right.iter_mut().enumerate() {
                *right = *right - matrix.at(k, l) * x;
            }
        }
        for (l, x) in known() {
            set(&mut right, l, x);
            (0..n).for_each(|k| {
                let own = if k == l { one } else { zero };
                matrix.set(k, l, own);
                matrix.set(l, k, own);
            });
        }
        // What nothing holds but its contacts gets a weak spring here: the branch is asked for its own.
        let elastic = open.iter().filter_map(|&i| match system.parts.get(i).map(|part| &part.rule) {
            Some(Rule::Elastic { stiffness, .. }) => Some(h * *stiffness),
            _ => None,
        });
        let own = system.massless.iter().map(|&i| matrix.at(i, i));
        let mut scale = own.chain(elastic).fold(zero, F::or_larger);
        if scale <= zero {
            scale = largest(&matrix);
        }
        for &i in &system.massless {
            let x = matrix.at(i, i) + scale * F::exp2i(-30);
            matrix.set(i, i, x);
        }
        let inverse = matrix.inverse_of_definite().ok()?;
        let mut velocity = inverse.of(&right);
        let mut loads = z.to_vec();
        loads.get_mut(..system.free).unwrap_or(&mut []).fill(zero);
        let later = |row: &[F]| {
            dot(row, &loads) + if time.is_some() { h * dot(&system.derivative(row), z) } else { zero }
        };
        let count = open.len();
        let mut coupling = Matrix::zero(count, count);
        let (mut way, mut doubt, mut bounds) = (Vec::new(), Vec::new(), Vec::new());
        let mut directions: Vec<Vec<F>> = Vec::new();
        let (mut compliances, mut presses) = (Vec::new(), Vec::new());
        for &i in open {
            let part = system.parts.get(i)?;
            let mut direction = part.direction.clone();
            let side = if time.is_some() { later(&part.velocity) } else { zero };
            let mut apart = dot(&direction, &velocity) + side;
            let mut size = size_of_dot(&direction, &velocity) + side.abs();
            known().for_each(|(k, _)| clear(&mut direction, k));
            let mut compliance = zero;
            if let Rule::Elastic { stiffness, place, .. } = &part.rule {
                compliance = one / (h * *stiffness);
                apart = apart + at(z, *place) * compliance;
                size = size + (at(z, *place) * compliance).abs();
            }
            if let Rule::Stop { depth, stiffness, .. } = &part.rule {
                compliance = one / (h * *stiffness);
                apart = apart + dot(depth, z) / h;
                size = size + size_of_dot(depth, z) / h;
                presses.push(way.len());
            }
            way.push(apart);
            doubt.push(size * F::epsilon() * F::int(4096));
            let bound = static_bound(part);
            bounds.push((dot(&bound, z) + later(&bound) - dot(&bound, &loads)).or_larger(zero));
            directions.push(direction);
            compliances.push(compliance);
        }
        for (i, a) in directions.iter().enumerate() {
            let image = inverse.of(a);
            for (j, b) in directions.iter().enumerate() {
                let own = if i == j { compliances.get(i).copied().unwrap_or(zero) } else { zero };
                coupling.set(i, j, dot(b, &image) + own);
            }
        }
        let high: Vec<Option<F>> =
            bounds.iter().enumerate().map(|(i, &b)| (!presses.contains(&i)).then_some(b)).collect();
        let low: Vec<Option<F>> = bounds.iter().map(|&b| Some(-b)).collect();
        let tension = least(&coupling, &way, &doubt, &low, &high).ok()?;
        let slip = way
            .iter()
            .zip(coupling.rows())
            .zip(&doubt)
            .map(|((&a, row), &doubt)| {
                (a - dot(row, &tension), doubt + size_of_dot(row, &tension) * F::epsilon())
            })
            .collect();
        let mut pull = vec![zero; n];
        directions.iter().zip(&tension).for_each(|(b, &t)| add_times(&mut pull, t, b));
        add_times(&mut velocity, -one, &inverse.of(&pull));
        Some(Self { velocity, tension, bounds, slip })
    }

    /// The modes that it proposes: what is at its bound slides or, where asked, only what certainly moves.
    fn modes(&self, system: &Assembly<F>, modes: &[Mode], open: &[usize], sure: bool) -> Vec<Mode> {
        let mut result = modes.to_vec();
        let each = open.iter().zip(&self.tension).zip(&self.bounds).zip(&self.slip);
        for (((&i, &tension), &bound), &(slip, doubt)) in each {
            let (Some(part), Some(mode)) = (system.parts.get(i), result.get_mut(i)) else { continue };
            let moves = tension.abs() >= bound && (!sure || slip.abs() > doubt);
            let forward = if bound > F::int(0) { tension > F::int(0) } else { slip > F::int(0) };
            *mode = match (&part.rule, moves) {
                (Rule::Stop { .. }, _) if tension > F::int(0) => Mode::Pressed,
                (Rule::Stop { .. }, _) => Mode::Away,
                (Rule::Elastic { .. }, true) => Mode::Yields { forward },
                (Rule::Elastic { .. }, false) => Mode::Holds,
                (_, true) => Mode::Slides { forward, piece: 0 },
                (_, false) => Mode::Stuck,
            };
        }
        result
    }
}

impl<F: Float> Assembly<F> {
    /// Whether an element acts on a coordinate without mass.
    pub(crate) fn is_light(&self, part: &super::assembly::Part<F>) -> bool {
        self.massless.iter().any(|&i| at(&part.direction, i) != F::int(0))
    }

    /// The operator of the natural frequencies, `M^(−1/2) K M^(−1/2)` along the motions that some directions allow, with what has no mass
    /// in balance.
    pub(crate) fn balanced_operator(&self, stiffness: &Matrix<F>, held: &[Vec<F>]) -> Matrix<F> {
        let (n, zero, one) = (self.n, F::int(0), F::int(1));
        let scale: Vec<F> = (0..n)
            .map(|i| {
                let own = [self.mass.at(i, i), stiffness.at(i, i).abs()].into_iter().find(|x| *x > zero);
                one / own.unwrap_or(one).sqrt()
            })
            .collect();
        let scaled = |matrix: &Matrix<F>| {
            let mut result = matrix.clone();
            for (i, &a) in scale.iter().enumerate() {
                result.row_mut(i).iter_mut().zip(&scale).for_each(|(x, &b)| *x = *x * a * b);
            }
            result
        };
        let mut outer = Matrix::zero(n, n);
        for direction in held {
            let c: Vec<F> = direction.iter().zip(&scale).map(|(&x, &s)| x * s).collect();
            let size = dot(&c, &c);
            if size > zero {
                c.iter().enumerate().for_each(|(i, &x)| add_times(outer.row_mut(i), x / size, &c));
            }
        }
        let allowed = split(&outer, &units(n), largest(&outer)).open;
        let (mass, stiffness) = (scaled(&self.mass), scaled(stiffness));
        let inert = split(&mass, &allowed, largest(&mass));
        let light = inert.open;
        let mut own = Matrix::zero(light.len(), light.len());
        for (i, a) in light.iter().enumerate() {
            let image = stiffness.of(a);
            light.iter().enumerate().for_each(|(j, b)| own.set(j, i, dot(b, &image)));
        }
        let inverse = own.pseudo_inverse();
        let count = inert.held.len();
        let mut operator = Matrix::zero(count, count);
        for (j, (mass, vector)) in inert.held.iter().enumerate() {
            let mut shape = vector.clone();
            let pull: Vec<F> = light.iter().map(|u| dot(u, &stiffness.of(vector))).collect();
            inverse.of(&pull).iter().zip(&light).for_each(|(&x, u)| add_times(&mut shape, -x, u));
            let image = stiffness.of(&shape);
            for (i, (other, vector)) in inert.held.iter().enumerate() {
                operator.set(i, j, dot(vector, &image) / (*mass * *other).sqrt());
            }
        }
        operator
    }

    /// The error about a coordinate without mass.
    pub(crate) fn without_mass(&self, coordinate: usize, condition: &'static str) -> Error {
        let name = self.names.get(coordinate).cloned();
        let name = name.unwrap_or_else(|| format!("mass[{}]", coordinate.saturating_add(1)));
        Error::Unsupported { name: format!("{name}, which has no mass,"), condition }
    }

    /// Checks what coordinates without mass carry.
    pub(crate) fn check_massless(&self) -> Result<(), Error> {
        let zero = F::int(0);
        let refused = |coordinate: usize, condition| Err(self.without_mass(coordinate, condition));
        let unsupported = |name: &str, condition| Err(Error::Unsupported { name: name.into(), condition });
        for &i in &self.massless {
            for matrix in [&self.stiffness, &self.damping] {
                if (0..self.n).any(|j| matrix.at(i, j) != matrix.at(j, i)) {
                    return refused(i, "must have symmetric rows of the stiffness and the damping");
                }
            }
            let acts = self.parts.iter().any(|part| at(&part.direction, i) != zero);
            let held = self.force.row(i).get(..2 * self.n).unwrap_or(&[]).iter().any(|x| *x != zero);
            if !acts && !held {
                return refused(
                    i,
                    "needs a spring, a damper or a contact that carries it; or give it a mass",
                );
            }
            for (k, record) in self.records.iter().enumerate() {
                if at(self.load.row(i), self.record(k)) != zero && record.jumps() {
                    return refused(
                        i,
                        "must carry no force that changes at once, because it would jump: give it a mass, or the force a steep \
                         straight line between the values",
                    );
                }
            }
        }
        for part in &self.parts {
            if self.massless.iter().any(|&i| part.normal().is_some_and(|row| at(row, i) != zero)) {
                return unsupported(
                    &part.name,
                    "must not be pressed by a spring at a body without mass: give it a mass",
                );
            }
            if matches!(part.rule, Rule::Hard { .. }) {
                return unsupported(
                    &part.name,
                    "must have a stiffness in place of a restitution beside a body without mass: give the stop a stiffness, or the body a mass",
                );
            }
            if !self.is_light(part) {
                continue;
            }
            match &part.rule {
                Rule::Contact { pieces, peak, normal } => {
                    if pieces.len() > 1 {
                        return unsupported(
                            &part.name,
                            "must have one friction at every speed, because it touches a body without mass: give the body a mass",
                        );
                    }
                    if *peak != F::int(1) {
                        return unsupported(
                            &part.name,
                            "must have no static friction above the kinetic one, because a body without mass would jump where it \
                             falls: give the body a mass",
                        );
                    }
                    self.check_pressed(&part.name, normal.as_deref())?;
                }
                Rule::Elastic { normal, .. } => self.check_pressed(&part.name, normal.as_deref())?,
                Rule::Hard { .. } => {}
                Rule::Spring { .. } => {
                    return unsupported(
                        &part.name,
                        "must have a stiffness in place of a law, because it touches a body without mass: give the body a mass",
                    );
                }
                Rule::Stop { damping, .. } => {
                    if *damping > zero {
                        return unsupported(
                            &part.name,
                            "must have no damping, because it touches a body without mass: give the body a mass",
                        );
                    }
                }
            }
        }
        let jumps = |driven: &super::assembly::Driven<F>| {
            let row = driven.displacement.as_deref().unwrap_or(&[]);
            self.records
                .iter()
                .enumerate()
                .any(|(k, record)| at(row, self.record(k)) != zero && record.jumps())
        };
        if self.moved.iter().any(jumps) {
            return unsupported(
                "moved",
                "must not change its displacement at once beside a body without mass: give a steep straight line between the values",
            );
        }
        if self.is_dependent {
            return unsupported(
                "contacts",
                "must have independent directions beside a body without mass: give the body a mass, or join parallel contacts to one",
            );
        }
        Ok(())
    }

    /// A normal load at a coordinate without mass depends on time only.
    fn check_pressed(&self, name: &str, normal: Option<&[F]>) -> Result<(), Error> {
        let by_state = normal.and_then(|row| row.get(..2 * self.n)).unwrap_or(&[]);
        if by_state.iter().any(|x| *x != F::int(0)) {
            return Err(Error::Unsupported {
                name: name.into(),
                condition: "must have a normal load over time alone, because it touches a body without mass: give the body a mass",
            });
        }
        Ok(())
    }
}
