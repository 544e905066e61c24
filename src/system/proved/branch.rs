//! The linear equation of a branch in balls, the guards that end it, and its Taylor series with a bound of what is left out.

use super::super::guard::Trigger;
use super::super::mode::{Mode, sign};
use super::cloud::{above, around_zero};
use super::machine::{
    Machine, Number, Part, Row, Rule, add_times, at, dot, is_zero, set, solved, unit, zeros,
};
use super::series::Series;
use crate::float::ball::Radius;
use crate::float::mp::Mp;
use crate::float::{Field, Float};
use alloc::vec::Vec;

/// A number that is positive while the branch lasts.
#[derive(Debug, Clone)]
pub(super) struct Guard {
    pub(super) element: usize,
    pub(super) trigger: Trigger,
    pub(super) row: Row,
}

/// The motion while each element keeps its mode.
#[derive(Debug)]
pub(super) struct Branch {
    pub(super) modes: Vec<Mode>,
    /// The rows of the derivative of the free states, without zeros.
    rows: Vec<Vec<(usize, Number)>>,
    /// The row of each element's force.
    pub(super) tension: Vec<Row>,
    pub(super) guards: Vec<Guard>,
    /// The length of a step, an exact number.
    pub(super) step: Number,
    degree: usize,
    /// The rows of the free states after a whole step.
    pub(super) whole: Vec<Row>,
}

fn signed(forward: bool) -> Number {
    Number::exact(sign(forward))
}

impl Part {
    /// The row of the normal load's part of the friction: N, or 1.
    pub(super) fn load(&self, size: usize) -> Row {
        match &self.rule {
            Rule::Contact { normal: Some(row), .. } => row.clone(),
            Rule::Contact { .. } | Rule::Elastic { .. } | Rule::Stop { .. } => unit(size, size - 1),
        }
    }

    /// The row of the friction at the velocity 0, static or kinetic.
    pub(super) fn friction(&self, size: usize, is_static: bool) -> Row {
        let Rule::Contact { pieces, peak, .. } = &self.rule else { return zeros(size) };
        let force = pieces.first().map_or_else(|| Number::int(0), |piece| piece.force);
        let force = match peak {
            Some(peak) if is_static => force * *peak,
            _ => force,
        };
        self.load(size).into_iter().map(|x| x * force).collect()
    }

    /// The row of the force of an element that does not stick; none of one that does.
    pub(super) fn tension(&self, mode: Mode, size: usize) -> Option<Row> {
        let mut row = zeros(size);
        match (mode, &self.rule) {
            (Mode::Stuck, _) => return None,
            (Mode::Slides { forward, piece }, Rule::Contact { pieces, normal, .. }) => {
                let (piece, s) = (pieces.get(piece)?, signed(forward));
                if normal.is_some() {
                    add_times(&mut row, s * piece.force, &self.load(size));
                } else {
                    set(&mut row, size - 1, s * (piece.force - piece.slope * piece.from));
                    add_times(&mut row, piece.slope, &self.velocity);
                }
            }
            (Mode::Holds, Rule::Elastic { place, .. }) => set(&mut row, *place, Number::int(1)),
            (Mode::Yields { forward }, Rule::Elastic { bound, .. }) => {
                add_times(&mut row, signed(forward), bound);
            }
            (Mode::Pressed, Rule::Stop { depth, stiffness, damping }) => {
                add_times(&mut row, *stiffness, depth);
                add_times(&mut row, *damping, &self.velocity);
            }
            _ => {}
        }
        Some(row)
    }

    /// The guards of this element.
    fn guards(&self, element: usize, mode: Mode, tension: &[Number], size: usize) -> Vec<Guard> {
        let mut guards = Vec::new();
        let mut push = |trigger, row: Row| guards.push(Guard { element, trigger, row });
        let times = |s: Number, row: &[Number]| -> Row { row.iter().map(|x| *x * s).collect() };
        let plus = |mut row: Row, constant: Number| {
            let sum = at(&row, size - 1) + constant;
            set(&mut row, size - 1, sum);
            row
        };
        match (mode, &self.rule) {
            (Mode::Stuck, Rule::Contact { .. }) => {
                for forward in [true, false] {
                    let mut row = self.friction(size, true);
                    add_times(&mut row, -signed(forward), tension);
                    push(Trigger::Releases { forward }, row);
                }
            }
            (Mode::Slides { forward, piece }, Rule::Contact { pieces, .. }) => {
                let speed = times(signed(forward), &self.velocity);
                match pieces.get(piece).filter(|_| piece > 0) {
                    Some(own) => push(Trigger::Piece(piece - 1), plus(speed.clone(), -own.from)),
                    None => push(Trigger::Stops, speed.clone()),
                }
                if let Some(next) = pieces.get(piece + 1) {
                    push(Trigger::Piece(piece + 1), plus(times(-Number::int(1), &speed), next.from));
                }
            }
            (Mode::Holds, Rule::Elastic { bound, .. }) => {
                for forward in [true, false] {
                    let mut row = bound.clone();
                    add_times(&mut row, -signed(forward), tension);
                    push(Trigger::Releases { forward }, row);
                }
            }
            (Mode::Yields { forward }, _) => push(Trigger::Stops, times(signed(forward), &self.velocity)),
            (Mode::Away, Rule::Stop { depth, .. }) => {
                push(Trigger::Closes, times(-Number::int(1), depth));
            }
            (Mode::Pressed, _) => push(Trigger::Opens, tension.to_vec()),
            (Mode::Lifted, Rule::Stop { depth, stiffness, damping }) => {
                push(Trigger::Clears, depth.clone());
                let mut pull = times(-*stiffness, depth);
                add_times(&mut pull, -*damping, &self.velocity);
                push(Trigger::Presses, pull);
            }
            _ => {}
        }
        if let Rule::Contact { normal: Some(row), .. } = &self.rule {
            if mode == Mode::Apart {
                push(Trigger::Meets, times(-Number::int(1), row));
            } else {
                push(Trigger::Parts, row.clone());
            }
        }
        guards
    }
}

/// The Taylor series of a state over a step, in parts of it.
pub(super) struct Flow {
    /// Of all states, one after the other.
    terms: Vec<Row>,
    /// The factor of the power after the last, at most.
    rest: Vec<Radius>,
}

impl Flow {
    /// The series of a row.
    pub(super) fn of(&self, row: &[Number]) -> Series {
        let mut list: Row = self.terms.iter().map(|term| dot(row, term)).collect();
        let reach =
            row.iter().zip(&self.rest).fold(Radius::ZERO, |sum, (x, rest)| sum.plus(above(x).times(*rest)));
        list.push(around_zero(reach));
        Series(list)
    }

    /// The series of a state.
    pub(super) fn entry(&self, place: usize) -> Series {
        let mut list: Row = self.terms.iter().map(|term| at(term, place)).collect();
        list.push(around_zero(self.rest.get(place).copied().unwrap_or(Radius::INFINITE)));
        Series(list)
    }
}

impl Branch {
    /// The branch with these modes; none where forces that hold cannot be told apart at this precision.
    pub(super) fn new(machine: &Machine, modes: &[Mode], longest: f64) -> Option<Self> {
        let (n, size) = (machine.n, machine.size);
        let mut force = machine.force.clone();
        let mut tension: Vec<Row> = Vec::with_capacity(modes.len());
        let mut stuck = Vec::new();
        for (i, (part, mode)) in machine.parts.iter().zip(modes).enumerate() {
            let row = part.tension(*mode, size).unwrap_or_else(|| {
                stuck.push(i);
                zeros(size)
            });
            pull(&mut force, &part.direction, &row);
            tension.push(row);
        }
        let held = held(machine, &stuck, &force)?;
        for (&i, row) in stuck.iter().zip(held) {
            if let (Some(part), Some(tension)) = (machine.parts.get(i), tension.get_mut(i)) {
                pull(&mut force, &part.direction, &row);
                *tension = row;
            }
        }
        let mut rows: Vec<Row> = (0..n).map(|i| unit(size, n + i)).collect();
        for share in &machine.inverse {
            let mut row = zeros(size);
            share
                .iter()
                .zip(&force)
                .filter(|(by, _)| !is_zero(by))
                .for_each(|(by, force)| add_times(&mut row, *by, force));
            rows.push(row);
        }
        for (part, mode) in machine.parts.iter().zip(modes) {
            let Rule::Elastic { stiffness, .. } = &part.rule else { continue };
            let by = if *mode == Mode::Holds { *stiffness } else { Number::int(0) };
            rows.push(part.velocity.iter().map(|x| *x * by).collect());
        }
        let mut guards = Vec::new();
        for (i, (part, mode)) in machine.parts.iter().zip(modes).enumerate() {
            guards.extend(part.guards(i, *mode, tension.get(i).map_or(&[], Vec::as_slice), size));
        }
        let entries = |row: &Row| row.iter().copied().enumerate().filter(|(_, x)| !is_zero(x)).collect();
        let rows: Vec<Vec<(usize, Number)>> = rows.iter().map(entries).collect();
        let rate = fastest(machine, &rows);
        let step = if rate * longest > 1.0 { 1.0 / rate } else { longest };
        let step = Number::exact(Mp::from_f64(step));
        let mut branch =
            Self { modes: modes.to_vec(), rows, tension, guards, step, degree: degree(), whole: Vec::new() };
        branch.whole = branch.after(machine, step, Number::int(1));
        Some(branch)
    }

    /// The derivative of the free states.
    pub(super) fn derivative(&self, z: &[Number]) -> Row {
        self.rows
            .iter()
            .map(|row| row.iter().fold(Number::int(0), |sum, (j, a)| sum + *a * at(z, *j)))
            .collect()
    }

    /// The series of the motion from a state over a step.
    pub(super) fn flow(&self, machine: &Machine, z: &[Number], step: Number) -> Flow {
        let mut terms: Vec<Row> = Vec::with_capacity(self.degree + 1);
        let mut last = z.to_vec();
        let mut power = 0;
        for _ in 0..self.degree {
            power += 1;
            let by = step / Number::int(power);
            let mut next: Row = self.derivative(&last).into_iter().map(|x| x * by).collect();
            for (i, frequency) in machine.frequencies.iter().enumerate() {
                let (place, by) = (machine.free + 2 * i, *frequency * by);
                let [sin, cos] = [at(&last, place), at(&last, place + 1)];
                next.extend([cos * by, -(sin * by)]);
            }
            next.push(Number::int(0));
            terms.push(core::mem::replace(&mut last, next));
        }
        terms.push(last);
        let rest = self.rest(machine, z, step);
        Flow { terms, rest }
    }

    /// Bounds of `Σ_{k>N} |Aᵏ z| hᵏ/k!`, and of its first four derivatives by the part of the step, as of one power N + 1 of it.
    ///
    /// With p ≥ |z| and `h|A| p ≤ μ p`, entry by entry, `|Aᵏ z| hᵏ ≤ μᵏ p`. The sum of the i-th derivatives is then at most
    /// `μ^(N+1)/(N+1−i)! p/(1 − μ/(N+2−i))`, which is less than the i-th derivative of the power with the factor `μ^(N+1)/(N+1)! p/(1 − μ/(N−2))`.
    fn rest(&self, machine: &Machine, z: &[Number], step: Number) -> Vec<Radius> {
        let step = above(&step);
        let size: Vec<Radius> = z.iter().map(above).collect();
        let rates: Vec<Radius> = machine.frequencies.iter().map(above).collect();
        let times = |p: &[Radius]| -> Vec<Radius> {
            let entry = |j: usize| p.get(j).copied().unwrap_or(Radius::ZERO);
            let free = self.rows.iter().map(|row| {
                row.iter().fold(Radius::ZERO, |sum, (j, a)| sum.plus(above(a).times(entry(*j)))).times(step)
            });
            let waves = rates.iter().enumerate().flat_map(|(i, rate)| {
                let place = machine.free + 2 * i;
                [place + 1, place].map(|j| rate.times(entry(j)).times(step))
            });
            free.chain(waves).chain([Radius::ZERO]).collect()
        };
        // p = Σ (h|A|/2)ʲ |z| would have μ = 2; what is left out of it is small.
        let mut p = size.clone();
        for _ in 0..2 * size.len() + 24 {
            p = times(&p).into_iter().zip(&size).map(|(x, size)| x.scaled(-1).plus(*size)).collect();
        }
        let most = times(&p).into_iter().zip(&p);
        let most = most.map(|(x, p)| if x.is_zero() { Radius::ZERO } else { x.over(*p) });
        let mu = most.fold(Radius::ZERO, Radius::max);
        let count = |k: usize| Radius::above(Mp::<2>::from_f64(k as f64));
        let mut factor = Radius::ONE.over(Radius::ONE.minus_down(mu.over(count(self.degree - 2))));
        for k in 1..=self.degree + 1 {
            factor = factor.times(mu).over(count(k));
        }
        p.into_iter().map(|p| p.times(factor)).collect()
    }

    /// The rows of the free states after a part of a step.
    pub(super) fn after(&self, machine: &Machine, step: Number, part: Number) -> Vec<Row> {
        let size = machine.size;
        let mut rows: Vec<Row> = (0..machine.free).map(|_| zeros(size)).collect();
        for j in 0..size {
            let flow = self.flow(machine, &unit(size, j), step);
            for (i, row) in rows.iter_mut().enumerate() {
                set(row, j, flow.entry(i).at(part));
            }
        }
        rows
    }
}

/// `force −= b T`, as rows.
pub(super) fn pull(force: &mut [Row], direction: &[Number], tension: &[Number]) {
    for (row, b) in force.iter_mut().zip(direction).filter(|(_, b)| !is_zero(b)) {
        add_times(row, -*b, tension);
    }
}

/// The rows of the forces that keep the velocities of some contacts.
fn held(machine: &Machine, stuck: &[usize], force: &[Row]) -> Option<Vec<Row>> {
    let left = |i: &usize| {
        let part = machine.parts.get(*i)?;
        let mut row = zeros(machine.size);
        part.response.iter().zip(force).for_each(|(by, force)| add_times(&mut row, *by, force));
        add_times(&mut row, -Number::int(1), &part.moves);
        Some(row)
    };
    let left: Vec<Row> = stuck.iter().map(left).collect::<Option<_>>()?;
    let coupling: Vec<Row> =
        stuck.iter().map(|&i| stuck.iter().map(|&j| machine.coupling(i, j)).collect()).collect();
    solved(&coupling, &left)
}

/// The degree from which on the terms are below the rounding where h|A| is 2 at most.
fn degree() -> usize {
    let bits = i64::from(Mp::<26>::bits_now()) + 8;
    let (mut degree, mut log) = (1_i32, 0.0);
    while log > -(bits as f64) || degree < 8 {
        degree += 1;
        log += 1.0 - libm::log2(f64::from(degree));
    }
    usize::try_from(degree).unwrap_or(8)
}

/// About the greatest rate of the equation and of its loads.
fn fastest(machine: &Machine, rows: &[Vec<(usize, Number)>]) -> f64 {
    let double = |x: &Number| x.mid().to_f64().abs();
    let rows: Vec<Vec<(usize, f64)>> = rows
        .iter()
        .map(|row| row.iter().filter(|(j, _)| *j < machine.free).map(|(j, a)| (*j, double(a))).collect())
        .collect();
    let mut x: Vec<f64> = rows.iter().map(|_| 1.0).collect();
    let mut log = 0.0;
    let rounds = 256;
    for _ in 0..rounds {
        let next: Vec<f64> = rows
            .iter()
            .map(|row| row.iter().map(|(j, a)| a * x.get(*j).copied().unwrap_or(0.0)).sum::<f64>())
            .collect();
        let largest = next.iter().copied().fold(0.0, f64::max);
        if largest <= 0.0 || !largest.is_finite() {
            log = f64::NEG_INFINITY;
            break;
        }
        log += libm::log(largest);
        x = next.into_iter().map(|y| y / largest).collect();
    }
    machine.frequencies.iter().map(double).fold(libm::exp(log / f64::from(rounds)), f64::max)
}

/// A state with the loads.
pub(super) fn joined(free: &[Number], loads: &[Number]) -> Row {
    free.iter().chain(loads).copied().collect()
}
