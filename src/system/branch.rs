//! A branch: the state's linear equation `z′ = A z` while no element changes its mode, and the guards that end it.
//!
//! **Certificate.** Let g be a guard's row and `0 ≤ s ≤ h`. By Taylor's formula with the integral remainder
//!
//! `g e^{As} z = Σ_{k≤N} (g Aᵏ z) sᵏ/k! + ∫₀ˢ (s − σ)ᴺ/N! g A^{N+1} e^{Aσ} z dσ`,
//!
//! and as `|e^{Aσ} z| ≤ e^{|A|h} |z|` entry by entry, the remainder is at most
//! `h^{N+1}/(N+1)! |g A^{N+1}| e^{|A|h} |z|`: one row, known once per branch, times |z|. No norm occurs, so that
//! units do not matter. h is at most 1/ρ, where ρ is (an estimate of) the spectral radius of |A|; the bound holds for
//! every h.
//!
//! **Rounding.** A coefficient `g Aᵏ z hᵏ/k!` that is computed by k + 1 products with rows of length d has an error of
//! at most (k + 1)(d + 2) half units of `|g| |A|ᵏ |z| hᵏ/k!`. Summed, and with the K + 1 additions of the Bernstein
//! form, whose weights are between 0 and 1, this is at most `ε (K + 1)(d + 3) |g| e^{|A|h} |z|`: a second row.

use super::assembly::{Assembly, Part, Piece, Rule};
use super::dependent::facets;
use super::equation::{Equation, Mode, fastest, pressing, sign};
use super::matrix::{Matrix, add_times, dot};
use super::zero::{bernstein, integer};
use crate::float::Float;
use alloc::vec;
use alloc::vec::Vec;

/// What a guard's zero means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Trigger {
    /// The sliding velocity is zero.
    Stops,
    /// The speed leaves its piece of the law.
    Piece(usize),
    /// The force reaches its bound in this direction.
    Releases { forward: bool },
    /// The normal load is zero.
    Parts,
    /// The normal load comes back.
    Meets,
    /// The stretch reaches the gap.
    Closes,
    /// The force of a stop is zero.
    Opens,
    /// A lifted stop is back within its gap.
    Clears,
    /// A lifted stop presses again.
    Presses,
}

/// A guard: positive as long as its branch lasts.
#[derive(Debug, Clone)]
pub(crate) struct Guard<F> {
    pub(crate) element: usize,
    pub(crate) trigger: Trigger,
    pub(crate) row: Vec<F>,
    /// The other contacts of dependent directions that are released with this one.
    pub(crate) others: Vec<(usize, bool)>,
    /// The row whose product with |z| bounds the error of the Taylor polynomial of full degree.
    pub(crate) error: Vec<F>,
    /// For each state its part of the Taylor coefficients over the step.
    pub(crate) taylor: Matrix<F>,
}

impl<F: Float> Guard<F> {
    fn new(element: usize, trigger: Trigger, row: Vec<F>, others: Vec<(usize, bool)>) -> Self {
        Self { element, trigger, row, others, error: Vec::new(), taylor: Matrix::zero(0, 0) }
    }

    /// The Taylor polynomial at z over a part of the step.
    pub(crate) fn polynomial(&self, z: &[F], part: F, c: &mut Vec<F>) {
        c.resize(self.taylor.columns(), F::int(0));
        self.taylor.transposed_of(z, c);
        if part != F::int(1) {
            let mut factor = F::int(1);
            for c in c.iter_mut() {
                *c = *c * factor;
                factor = factor * part;
            }
        }
    }
}

/// Polynomials of rows over a whole step in Bernstein form, with the rows of their error bounds.
#[derive(Debug, Clone)]
pub(crate) struct Hull<F> {
    /// Column by column: for each state the coefficients of all rows.
    coefficients: Matrix<F>,
    errors: Matrix<F>,
    pub(crate) each: usize,
}

/// The degree of the polynomials that show most steps to be free of events.
const LOW_DEGREE: usize = 9;

/// A branch.
#[derive(Debug, Clone)]
pub(crate) struct Branch<F> {
    pub(crate) modes: Vec<Mode>,
    pub(crate) a: Matrix<F>,
    /// Aᵀ, for products along columns.
    transposed: Matrix<F>,
    /// The step.
    pub(crate) step: F,
    /// (e^{Ah})ᵀ.
    pub(crate) whole: Matrix<F>,
    /// e^{|A|h}.
    pub(crate) bound: Matrix<F>,
    /// The degree of full accuracy.
    pub(crate) degree: usize,
    pub(crate) guards: Vec<Guard<F>>,
    /// The error bound of the velocity of each contact.
    pub(crate) speed_errors: Vec<Vec<F>>,
    pub(crate) hull: Hull<F>,
    /// The row of each element's force.
    pub(crate) tension: Vec<Vec<F>>,
}

impl<F: Float> Hull<F> {
    /// The polynomials of `rows` over the step.
    pub(crate) fn new(branch: &Powers<'_, F>, rows: &[Vec<F>]) -> Self {
        let (size, each) = (branch.a.columns(), LOW_DEGREE + 1);
        let mut all = Vec::with_capacity(rows.len() * each);
        let mut errors = Vec::with_capacity(rows.len());
        for row in rows {
            let terms = branch.terms(row, LOW_DEGREE + 1);
            // Bernstein's coefficients, state by state.
            let mut coefficients = vec![vec![F::int(0); size]; each];
            for j in 0..size {
                let c: Vec<F> =
                    terms.iter().take(each).map(|t| t.get(j).copied().unwrap_or(F::int(0))).collect();
                for (b, row) in bernstein(&c).into_iter().zip(&mut coefficients) {
                    if let Some(place) = row.get_mut(j) {
                        *place = b;
                    }
                }
            }
            all.extend(coefficients);
            errors.push(branch.error_of(row, &terms));
        }
        let of = |rows: &[Vec<F>]| {
            if rows.is_empty() { Matrix::zero(size, 0) } else { Matrix::from_rows(rows).transposed() }
        };
        Self { coefficients: of(&all), errors: of(&errors), each }
    }

    /// The Bernstein coefficients of all rows at z, and their error bounds.
    #[inline]
    pub(crate) fn at(&self, z: &[F], values: &mut Vec<F>, errors: &mut Vec<F>) {
        values.resize(self.coefficients.columns(), F::int(0));
        errors.resize(self.errors.columns(), F::int(0));
        self.coefficients.transposed_of(z, values);
        errors.fill(F::int(0));
        for (row, &z) in self.errors.rows().zip(z) {
            add_times(errors, z.abs(), row);
        }
    }
}

/// What the rows of a branch need.
pub(crate) struct Powers<'a, F> {
    pub(crate) a: &'a Matrix<F>,
    pub(crate) step: F,
    pub(crate) bound: &'a Matrix<F>,
    pub(crate) degree: usize,
}

impl<F: Float> Powers<'_, F> {
    /// The rows `g Aᵏ hᵏ/k!` for k = 0 … `last`.
    fn terms(&self, row: &[F], last: usize) -> Vec<Vec<F>> {
        let mut terms = vec![row.to_vec()];
        for k in 1..=last {
            let before = terms.last().map_or(&[][..], Vec::as_slice);
            let factor = self.step / integer(k);
            let next = self.a.combined(before).into_iter().map(|x| x * factor).collect();
            terms.push(next);
        }
        terms
    }

    /// `|row| e^{|A|h}`.
    fn bounded(&self, row: &[F]) -> Vec<F> {
        let sizes: Vec<F> = row.iter().map(|x| x.abs()).collect();
        self.bound.combined(&sizes)
    }

    /// The row of the rounding.
    fn rounding(&self, row: &[F]) -> Vec<F> {
        let count = integer::<F>((self.degree + 1) * (self.a.columns() + 3)) * F::epsilon();
        self.bounded(row).into_iter().map(|x| x * count).collect()
    }

    /// The error bound of a row's polynomial of full degree.
    pub(crate) fn error(&self, row: &[F]) -> Vec<F> {
        self.error_of(row, &self.terms(row, self.degree + 1))
    }

    /// The same, where the last of the row's terms is the first that is left out.
    fn error_of(&self, row: &[F], terms: &[Vec<F>]) -> Vec<F> {
        let mut error = self.rounding(row);
        if let Some(rest) = terms.last() {
            add_times(&mut error, F::int(1), &self.bounded(rest));
        }
        error
    }
}

impl<F: Float> Branch<F> {
    /// The branch with these modes. `longest` bounds its step.
    pub(crate) fn new(system: &Assembly<F>, modes: &[Mode], longest: F) -> Self {
        let Equation { a, sizes, tension, stuck } = Equation::new(system, modes);
        let most = F::int(1) / fastest(system, &sizes);
        let step = if most < longest { most } else { longest };
        let degree = degree_of_full_accuracy::<F>();
        let (whole, bound) = (exponential(&a, step, degree), exponential(&sizes, step, degree));
        // The series of e^{|A|h} is cut: what is left out is below a unit of its terms.
        let bound = bound.map(|x| x + x * F::ratio(1, 64));
        let powers = Powers { a: &a, step, bound: &bound, degree };
        let guards = {
            let mut guards = guards(system, modes, &tension);
            guards.extend(releases(system, &stuck, &tension));
            for guard in &mut guards {
                let mut terms = powers.terms(&guard.row, degree + 1);
                guard.error = powers.error_of(&guard.row, &terms);
                // A speed that is kept at a corner of the law, as between two belts, has the corner's rounding. The law is
                // continuous there.
                if let (Some(corner), Some(last)) = (corner(system, modes, guard), guard.error.last_mut()) {
                    *last = *last + corner * F::epsilon() * F::int(64);
                }
                terms.pop();
                guard.taylor = Matrix::from_rows(&terms).transposed();
            }
            guards
        };
        let speed_errors = {
            let error = |part: &Part<F>| match part.rule {
                Rule::Contact { .. } => powers.error(&part.velocity),
                Rule::Elastic { .. } | Rule::Stop { .. } => Vec::new(),
            };
            system.parts.iter().map(error).collect()
        };
        let rows: Vec<Vec<F>> = guards.iter().map(|g| g.row.clone()).collect();
        let hull = Hull::new(&powers, &rows);
        let (whole, transposed) = (whole.transposed(), a.transposed());
        Self {
            modes: modes.to_vec(),
            a,
            transposed,
            step,
            whole,
            bound,
            degree,
            guards,
            speed_errors,
            hull,
            tension,
        }
    }

    /// The hull of further rows.
    pub(crate) fn hull_of(&self, rows: &[Vec<F>]) -> Hull<F> {
        Hull::new(&self.powers(), rows)
    }

    pub(crate) const fn powers(&self) -> Powers<'_, F> {
        Powers { a: &self.a, step: self.step, bound: &self.bound, degree: self.degree }
    }

    /// `A z`.
    pub(crate) fn derivative(&self, z: &[F]) -> Vec<F> {
        let mut result = vec![F::int(0); z.len()];
        self.transposed.transposed_of(z, &mut result);
        result
    }

    /// How many Taylor terms are above rounding over a time t ≤ h.
    fn degree_over(&self, time: F) -> usize {
        let (part, least) = (time / self.step, F::epsilon() / F::int(64));
        let mut term = part;
        (1..self.degree)
            .find(|&k| {
                term = term * part / integer(k + 1);
                term <= least
            })
            .unwrap_or(self.degree)
    }

    /// The Taylor coefficients `Aᵏ z tᵏ/k!` over a time t ≤ h, one after the other in one list.
    pub(crate) fn taylor(&self, z: &[F], time: F, terms: &mut Vec<F>) {
        let (size, degree) = (z.len(), self.degree_over(time));
        terms.clear();
        terms.resize((degree + 1) * size, F::int(0));
        if let Some(first) = terms.get_mut(..size) {
            first.copy_from_slice(z);
        }
        for k in 1..=degree {
            let (before, after) = terms.split_at_mut(k * size);
            let from = before.get((k - 1) * size..).unwrap_or(&[]);
            let to = after.get_mut(..size).unwrap_or(&mut []);
            self.transposed.transposed_of(from, to);
            let factor = time / integer(k);
            to.iter_mut().for_each(|x| *x = *x * factor);
        }
    }

    /// z after a time t ≤ h.
    pub(crate) fn after(&self, z: &[F], time: F, terms: &mut Vec<F>) -> Vec<F> {
        self.taylor(z, time, terms);
        sum_of_terms(terms, z.len(), F::int(1))
    }
}

/// `Σ (term k) sᵏ`.
pub(crate) fn sum_of_terms<F: Float>(terms: &[F], size: usize, s: F) -> Vec<F> {
    let mut sum = vec![F::int(0); size];
    for term in terms.chunks_exact(size.max(1)).rev() {
        sum.iter_mut().zip(term).for_each(|(sum, &x)| *sum = *sum * s + x);
    }
    sum
}

/// The coefficients of a row's polynomial.
pub(crate) fn polynomial<F: Float>(row: &[F], terms: &[F]) -> Vec<F> {
    terms.chunks_exact(row.len().max(1)).map(|term| dot(row, term)).collect()
}

/// The guards of a branch: rows that are positive as long as it lasts.
fn guards<F: Float>(system: &Assembly<F>, modes: &[Mode], tension: &[Vec<F>]) -> Vec<Guard<F>> {
    let mut guards: Vec<Guard<F>> = Vec::new();
    let mut add = |element: usize, trigger: Trigger, row: Vec<F>| {
        guards.push(Guard::new(element, trigger, row, Vec::new()));
    };
    let times = |row: &[F], factor: F| -> Vec<F> { row.iter().map(|&x| x * factor).collect() };
    let plus = |mut row: Vec<F>, constant: F| {
        if let Some(last) = row.last_mut() {
            *last = *last + constant;
        }
        row
    };
    let one = F::int(1);
    for (i, ((part, mode), tension)) in system.parts.iter().zip(modes).zip(tension).enumerate() {
        match (*mode, &part.rule) {
            (Mode::Slides { forward, piece }, Rule::Contact { pieces, .. }) => {
                let speed = times(&part.velocity, sign(forward));
                let from = |k: usize| pieces.get(k).map(|p: &Piece<F>| p.from);
                match piece.checked_sub(1) {
                    None => add(i, Trigger::Stops, speed.clone()),
                    Some(below) => {
                        let low = from(piece).unwrap_or(F::int(0));
                        add(i, Trigger::Piece(below), plus(speed.clone(), -low));
                    }
                }
                if let Some(high) = from(piece + 1) {
                    add(i, Trigger::Piece(piece + 1), plus(times(&speed, -one), high));
                }
            }
            (Mode::Yields { forward }, Rule::Elastic { .. }) => {
                add(i, Trigger::Stops, times(&part.velocity, sign(forward)));
            }
            (Mode::Holds, Rule::Elastic { friction, .. }) => {
                for forward in [true, false] {
                    let row = plus(times(tension, -sign::<F>(forward)), *friction);
                    add(i, Trigger::Releases { forward }, row);
                }
            }
            (Mode::Away, Rule::Stop { depth, .. }) => add(i, Trigger::Closes, times(depth, -one)),
            (Mode::Pressed, Rule::Stop { .. }) => add(i, Trigger::Opens, tension.clone()),
            (Mode::Lifted, Rule::Stop { depth, .. }) => {
                add(i, Trigger::Clears, depth.clone());
                add(i, Trigger::Presses, times(&pressing(part), -one));
            }
            _ => {}
        }
        if let Rule::Contact { normal: Some(normal), .. } = &part.rule
            && normal.iter().rev().skip(1).any(|&x| x != F::int(0))
        {
            let apart = *mode == Mode::Apart;
            let trigger = if apart { Trigger::Meets } else { Trigger::Parts };
            add(i, trigger, times(normal, if apart { -one } else { one }));
        }
    }
    guards
}

/// The speed at which a guard passes from one piece of a law to the next.
fn corner<F: Float>(system: &Assembly<F>, modes: &[Mode], guard: &Guard<F>) -> Option<F> {
    let part = system.parts.get(guard.element)?;
    match (guard.trigger, modes.get(guard.element)?, &part.rule) {
        (Trigger::Piece(to), Mode::Slides { piece, .. }, Rule::Contact { pieces, .. }) => {
            pieces.get(to.max(*piece)).map(|p| p.from)
        }
        _ => None,
    }
}

/// The bound of a contact at rest as a row: peak r(0) N.
pub(crate) fn static_bound<F: Float>(part: &Part<F>) -> Vec<F> {
    let mut row = vec![F::int(0); part.velocity.len()];
    if let Rule::Contact { peak, normal, pieces } = &part.rule {
        let force = pieces.first().map_or(F::int(0), |p| p.force) * *peak;
        match normal {
            Some(normal) => add_times(&mut row, force, normal),
            None => row.iter_mut().rev().take(1).for_each(|last| *last = force),
        }
    }
    row
}

/// The guards of the contacts that stick: `Σ |gᵢ| Rᵢ ∓ Σ gᵢ Tᵢ` for each facet g of what they can hold.
fn releases<F: Float>(system: &Assembly<F>, stuck: &[usize], tension: &[Vec<F>]) -> Vec<Guard<F>> {
    let parts = || stuck.iter().filter_map(|&i| system.parts.get(i));
    let facets: Vec<Vec<(usize, F)>> = if system.is_dependent {
        facets(&parts().map(|p| p.direction.as_slice()).collect::<Vec<_>>())
    } else {
        (0..stuck.len()).map(|place| vec![(place, F::int(1))]).collect()
    };
    let bounds: Vec<Vec<F>> = parts().map(static_bound).collect();
    let mut guards = Vec::new();
    for facet in facets {
        for forward in [true, false] {
            let mut row = vec![F::int(0); system.size];
            let mut members = Vec::new();
            for &(place, g) in &facet {
                let Some(&element) = stuck.get(place) else { continue };
                if let (Some(tension), Some(bound)) = (tension.get(element), bounds.get(place)) {
                    add_times(&mut row, -sign::<F>(forward) * g, tension);
                    add_times(&mut row, g.abs(), bound);
                }
                members.push((element, (g > F::int(0)) == forward));
            }
            let mut members = members.into_iter();
            let Some((element, forward)) = members.next() else { continue };
            let (trigger, others) = (Trigger::Releases { forward }, members.collect());
            guards.push(Guard::new(element, trigger, row, others));
        }
    }
    guards
}

/// The degree from which on the terms of eˣ, x ≤ 1, are below rounding.
fn degree_of_full_accuracy<F: Float>() -> usize {
    let (mut degree, mut term) = (1, F::int(1));
    let least = F::epsilon() / F::int(64);
    while term > least {
        degree += 1;
        term = term / integer(degree + 1);
    }
    degree
}

/// `e^{A t}` by its series, for a matrix whose absolute values have a spectral radius of at most 1/t.
fn exponential<F: Float>(a: &Matrix<F>, time: F, degree: usize) -> Matrix<F> {
    let mut sum = Matrix::identity(a.columns());
    let mut term = sum.clone();
    for k in 1..=degree {
        let factor = time / integer(k);
        term = a.times(&term).map(|x| x * factor);
        sum.plus(&term);
    }
    sum
}
