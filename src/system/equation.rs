//! The linear equation of a branch, `z′ = A z`, with the forces of all elements, and the greatest rate in it.

use super::assembly::{Assembly, Part, Rule, unit};
use super::matrix::{Matrix, Sparse, add_times, entries};
use super::mode::{Mode, sign};
use super::tie::Tie;
use crate::float::Float;
use alloc::vec;
use alloc::vec::Vec;

/// The equation while each element keeps its mode.
pub(crate) struct Equation<F> {
    pub(crate) a: Sparse<F>,
    /// The row of each element's force.
    pub(crate) tension: Vec<Vec<F>>,
    /// The contacts that stick, and the stops in touch that give no way.
    pub(crate) stuck: Vec<usize>,
    /// The row of the velocity of the slider of each elastic contact that yields, in its direction: `s v − (r N)′/k`.
    pub(crate) slips: Vec<Vec<F>>,
    /// What coordinates without mass do, if there are any.
    pub(crate) tie: Option<Tie<F>>,
}

impl<F: Float> Equation<F> {
    pub(crate) fn new(system: &Assembly<F>, modes: &[Mode]) -> Self {
        let (n, size, zero) = (system.n, system.size, F::int(0));
        let mut force = system.force.clone();
        let mut tension = vec![vec![zero; size]; modes.len()];
        let mut stuck = Vec::new();
        for (i, ((part, mode), tension)) in system.parts.iter().zip(modes).zip(&mut tension).enumerate() {
            match given_tension(part, *mode) {
                Some(row) => *tension = row,
                None if mode.is_held() => stuck.push(i),
                None => {}
            }
            force.less_product(&part.direction, tension);
        }
        let tie = (!system.massless.is_empty()).then(|| Tie::new(system, modes, &stuck, &force));
        let inverse = inverse_by_shares(system, &stuck);
        // The second round takes out the rounding of the first, which would set what is stuck in motion after a long time.
        for _ in 0..if stuck.is_empty() { 0 } else { 3 } {
            if let Some(tie) = &tie {
                tie.hold(system, &stuck, &mut force, &mut tension);
                continue;
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
            let held = inverse.times(&Matrix::from_rows(&left));
            for (&i, row) in stuck.iter().zip(held.rows()) {
                if let (Some(part), Some(tension)) = (system.parts.get(i), tension.get_mut(i)) {
                    add_times(tension, F::int(1), row);
                    force.less_product(&part.direction, row);
                }
            }
        }
        if let Some(tie) = &tie {
            (0..n).for_each(|i| tie.substitute(force.row_mut(i)));
            tension.iter_mut().for_each(|row| tie.substitute(row));
        }
        let mut free = Matrix::zero(system.free, size);
        for i in 0..n {
            free.set(i, n + i, F::int(1));
            force.combine_few(system.inverse_mass.row(i), free.row_mut(n + i));
        }
        for driven in &system.moved {
            free.row_mut(n + driven.coordinate).copy_from_slice(&driven.acceleration);
        }
        for &(slot, ref row) in tie.iter().flat_map(Tie::rows) {
            free.row_mut(slot - n).copy_from_slice(row);
        }
        let velocity = |part: &Part<F>| {
            let mut row = part.velocity.clone();
            tie.iter().for_each(|tie| tie.substitute(&mut row));
            row
        };
        let mut slips = vec![Vec::new(); modes.len()];
        for ((part, mode), slip) in system.parts.iter().zip(modes).zip(&mut slips) {
            let Rule::Elastic { stiffness, place, bound, normal } = &part.rule else { continue };
            match mode {
                Mode::Holds => add_times(free.row_mut(*place), *stiffness, &velocity(part)),
                Mode::Yields { forward } => {
                    *slip = velocity(part).into_iter().map(|v| sign::<F>(*forward) * v).collect();
                    if normal.is_some() {
                        let mut rate = system.derivative(bound);
                        for (i, &by) in bound.iter().enumerate().take(2 * n) {
                            if by != zero {
                                add_times(&mut rate, by, free.row(i));
                            }
                        }
                        add_times(slip, -F::int(1) / *stiffness, &rate);
                        add_times(free.row_mut(*place), sign(*forward), &rate);
                    }
                }
                Mode::Stuck | Mode::Slides { .. } | Mode::Apart => {}
                Mode::Away | Mode::Pressed | Mode::Lifted | Mode::Resting | Mode::Bends { .. } => {}
            }
        }
        // The velocities of what has no mass change as those that they follow from.
        for &(slot, ref row) in tie.iter().flat_map(Tie::rows) {
            let mut rate = system.derivative(row);
            for (&by, row) in row.iter().zip(free.rows()).filter(|(by, _)| **by != zero) {
                add_times(&mut rate, by, row);
            }
            free.row_mut(slot).copy_from_slice(&rate);
        }
        let mut given = vec![Vec::new(); size - system.free];
        let mut set = |row: usize, column: usize, value: F| {
            if let Some(row) = given.get_mut(row - system.free) {
                row.push((column, value));
            }
        };
        for (i, &frequency) in system.frequencies.iter().enumerate() {
            let place = system.harmonic(i);
            set(place, place + 1, frequency);
            set(place + 1, place, -frequency);
        }
        for i in 0..system.records.len() {
            let place = system.record(i);
            set(place, place + 1, F::int(1));
        }
        let rows = free.rows().map(entries).chain(given);
        Self { a: Sparse::new(size, rows), tension, stuck, slips, tie }
    }
}

/// The greatest rate of an equation: the spectral radius of |A|, and the frequencies of the loads.
pub(crate) fn fastest<F: Float>(system: &Assembly<F>, a: &Sparse<F>) -> F {
    let radius = F::from_f64(spectral_radius(a, system.free));
    system.frequencies.iter().fold(radius, |a, &b| a.or_larger(b))
}

/// The row of the force of an element that neither sticks nor is open.
pub(crate) fn given_tension<F: Float>(part: &Part<F>, mode: Mode) -> Option<Vec<F>> {
    match (mode, &part.rule) {
        (Mode::Slides { forward, piece }, _) => Some(sliding(part, forward, piece)),
        (Mode::Holds, Rule::Elastic { place, .. })
        | (Mode::Yields { .. }, Rule::Elastic { place, normal: None, .. }) => {
            Some(unit(part.velocity.len(), *place))
        }
        (Mode::Yields { forward }, Rule::Elastic { bound, .. }) => {
            Some(bound.iter().map(|&x| sign::<F>(forward) * x).collect())
        }
        (Mode::Pressed, _) => Some(pressing(part)),
        (Mode::Bends { piece }, _) => Some(super::spring::tension(part, piece)),
        _ => None,
    }
}

/// The row of the force of a sliding contact: `s N (force + slope (w − from))`, w = s v.
fn sliding<F: Float>(part: &Part<F>, forward: bool, piece: usize) -> Vec<F> {
    let mut row = vec![F::int(0); part.velocity.len()];
    if let Rule::Contact { pieces, normal, .. } = &part.rule
        && let Some(piece) = pieces.get(piece)
    {
        let sign: F = sign(forward);
        if let Some(normal) = normal {
            add_times(&mut row, sign * piece.force, normal);
        } else {
            if let Some(last) = row.last_mut() {
                *last = sign * (piece.force - piece.slope * piece.from);
            }
            add_times(&mut row, piece.slope, &part.velocity);
        }
    }
    row
}

/// The row of the force of a stop in touch.
pub(crate) fn pressing<F: Float>(part: &Part<F>) -> Vec<F> {
    let mut row = vec![F::int(0); part.velocity.len()];
    if let Rule::Stop { depth, stiffness, damping } = &part.rule {
        add_times(&mut row, *stiffness, depth);
        add_times(&mut row, *damping, &part.velocity);
    }
    row
}

/// G⁻¹ of the contacts that stick. Dependent ones share their force in proportion to their bounds, as far as that holds it:
/// with the least `Σ Tᵢ²/Rᵢ`. A stop that gives no way takes most of it, as one with 2¹⁰ times the greatest bound.
fn inverse_by_shares<F: Float>(system: &Assembly<F>, stuck: &[usize]) -> Matrix<F> {
    let coupling = system.coupling_of(stuck);
    if !system.is_dependent {
        return coupling.pseudo_inverse();
    }
    let bound = |i: &usize| match system.parts.get(*i).map(|p| &p.rule) {
        Some(Rule::Contact { pieces, peak, .. }) => pieces.first().map_or(F::int(0), |p| p.force) * *peak,
        _ => F::int(0),
    };
    let bounds: Vec<F> = stuck.iter().map(bound).collect();
    let largest = bounds.iter().fold(F::int(0), |m, &x| m.or_larger(x));
    if largest <= F::int(0) {
        return coupling.pseudo_inverse();
    }
    let is_stop = |i: &usize| matches!(system.parts.get(*i).map(|part| &part.rule), Some(Rule::Hard { .. }));
    let root = |(i, &x): (&usize, &F)| {
        let share = if is_stop(i) { F::exp2i(10) } else { (x / largest).or_larger(F::exp2i(-20)) };
        share.sqrt()
    };
    let roots: Vec<F> = stuck.iter().zip(&bounds).map(root).collect();
    let scaled = |matrix: &Matrix<F>| {
        let mut result = matrix.clone();
        for (i, &a) in roots.iter().enumerate() {
            result.row_mut(i).iter_mut().zip(&roots).for_each(|(x, &b)| *x = *x * a * b);
        }
        result
    };
    scaled(&scaled(&coupling).pseudo_inverse())
}

/// The spectral radius of the absolute values of the leading part of a matrix, a little above: `‖A¹⁰²⁴‖^{1/1024}` at f64, where
/// ‖·‖ is the greatest sum of a row. It sets the steps, so that its logarithm must be the same on every processor: that of libm.
fn spectral_radius<F: Float>(a: &Sparse<F>, free: usize) -> f64 {
    let leading = |row: &[(usize, F)]| -> Vec<(usize, f64)> {
        row.iter().take_while(|(j, _)| *j < free).map(|&(j, x)| (j, x.abs().to_f64())).collect()
    };
    let a = Sparse::new(free, a.rows().take(free).map(leading));
    let entries: usize = a.rows().map(<[_]>::len).sum();
    // The sums of the rows of A¹⁰²⁴ are A¹⁰²⁴ (1, 1, …). A product with a square has eight times the speed, and a quotient a quarter.
    let products = entries.saturating_add(4 * free).saturating_mul(8 * 1024);
    if products < free.pow(3).saturating_mul(11) { by_products(&a, free) } else { by_squares(&a, free) }
}

/// The root of the norm by products with a vector.
fn by_products(a: &Sparse<f64>, free: usize) -> f64 {
    let (mut x, mut next) = (vec![1.0; free], vec![0.0; free]);
    let mut log = 0.0;
    for _ in 0..1024 {
        a.of(&x, &mut next);
        let largest = next.iter().copied().fold(0.0, f64::max);
        if largest <= 0.0 {
            return 0.0;
        }
        log += libm::log(largest);
        x.iter_mut().zip(&next).for_each(|(x, y)| *x = y / largest);
    }
    libm::exp(log / 1024.0)
}

/// The root of the norm by squares.
fn by_squares(a: &Sparse<f64>, free: usize) -> f64 {
    let mut power = Matrix::zero(free, free);
    for (i, row) in a.rows().enumerate() {
        row.iter().for_each(|&(j, x)| power.set(i, j, x));
    }
    let mut square = power.clone();
    let (mut exponent, mut log) = (1.0_f64, 0.0_f64);
    for _ in 0..=10 {
        let largest = power.rows().map(|r| r.iter().sum::<f64>()).fold(0.0, f64::max);
        if largest <= 0.0 {
            return 0.0;
        }
        log += libm::log(largest) / exponent;
        power.change(|x| x / largest);
        power.product(&power, &mut square);
        core::mem::swap(&mut power, &mut square);
        exponent *= 2.0;
    }
    libm::exp(log)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A chain of sixty masses: the greatest rate of |A| = [0, I; |K|, |C|] is the root of x² = c x + k, with the greatest
    /// eigenvalues c and k of |C| and |K|, which have the same vectors.
    #[test]
    fn both_ways_give_the_radius_of_a_chain() {
        let n = 60;
        let entry = |i: usize| {
            let mut row = Vec::new();
            for (first, factor) in [(0, 300.0), (n, 0.5)] {
                for j in i.saturating_sub(1)..(i + 2).min(n) {
                    row.push((first + j, if i == j { 2.0 * factor } else { -factor }));
                }
            }
            row
        };
        let rows = (0..n).map(|i| vec![(n + i, 1.0)]).chain((0..n).map(entry));
        let a = Sparse::<f64>::new(2 * n, rows);
        let most = 2.0 + 2.0 * libm::cos(core::f64::consts::PI / (n + 1) as f64);
        let (k, c) = (300.0 * most, 0.5 * most);
        let due = c / 2.0 + libm::sqrt(c * c / 4.0 + k);
        let sizes = a.map(f64::abs);
        let found = [spectral_radius(&a, 2 * n), by_products(&sizes, 2 * n), by_squares(&sizes, 2 * n)];
        // The norm of the power has the sizes of the units in it: 34¹ᐟ¹⁰²⁴ − 1 = 0.0034.
        assert!(found.iter().all(|x| (0.0..0.005).contains(&(x / due - 1.0))), "{found:?} {due}");
        assert!((found[1] / found[2] - 1.0).abs() < 1e-12 && found[0] == found[1], "{found:?}");
    }
}
