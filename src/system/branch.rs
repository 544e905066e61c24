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

use super::assembly::{Assembly, Part, Rule};
use super::dependent::facets;
use super::equation::{Equation, fastest, pressing};
use super::few::{Few, shortened_terms};
use super::first_passage::{bernstein_of_rows, integer};
use super::guard::{Guard, Series, Trigger, columns_of, degree_of_full_accuracy, degree_over, series};
use super::matrix::{Matrix, Sparse, absolute, add_times, dot, entries, is_small, set, size_of_dot};
use super::mode::{Mode, sign};
use super::pieces::Piece;
use super::propagator::{Bound, Powers, Propagator, exponential};
use super::split::Split;
use super::tie::Tie;
use crate::float::Float;
use alloc::rc::Rc;
use alloc::vec;
use alloc::vec::Vec;
use core::cell::OnceCell;

/// Polynomials of rows over a whole step in Bernstein form, with the rows of their error bounds.
#[derive(Debug, Clone)]
pub(crate) struct Hull<F> {
    /// Column by column: for each state the coefficients of all rows.
    coefficients: Matrix<F>,
    errors: Matrix<F>,
}

/// The degree of the polynomials that show most steps to be free of events.
const LOW_DEGREE: usize = 9;
/// How many coefficients they have.
pub(crate) const LOW_COUNT: usize = LOW_DEGREE + 1;

/// A branch.
#[derive(Debug, Clone)]
pub(crate) struct Branch<F> {
    pub(crate) modes: Vec<Mode>,
    /// A and Aᵀ, most of whose entries are zero.
    a: Sparse<F>,
    transposed: Sparse<F>,
    /// The step.
    pub(crate) step: F,
    /// e^{Ah}, once it has been asked for.
    whole: OnceCell<Propagator<F>>,
    /// Set where the matrix has few entries: guards are then followed by the series of the state.
    pub(crate) few: Option<Few<F>>,
    /// The number of states that no load prescribes.
    free: usize,
    /// The powers of its free part, which branches share where it is the same.
    pub(crate) powers: Rc<Powers<F>>,
    /// The terms of the series of a small matrix.
    terms: Option<Propagator<F>>,
    /// e^{|A|h}, where the matrix has many entries.
    bound: Option<Bound<F>>,
    /// The degree of full accuracy.
    pub(crate) degree: usize,
    pub(crate) guards: Vec<Guard<F>>,
    /// The error bounds of velocities of contacts that have been asked for.
    speed_errors: Vec<OnceCell<Vec<F>>>,
    pub(crate) hull: Hull<F>,
    /// The row of each element's force.
    pub(crate) tension: Vec<Vec<F>>,
    /// What coordinates without mass do, if there are any.
    pub(crate) tie: Option<Tie<F>>,
    /// The branch without its fast modes, the one with the longest steps first; none where no modes are so much faster.
    pub(crate) splits: Vec<Split<F>>,
}

impl<F: Float> Hull<F> {
    /// The polynomials of `rows` over the step.
    fn new<'a>(size: usize, rows: impl ExactSizeIterator<Item = Terms<'a, F>>) -> Self
    where
        F: 'a,
    {
        let each = LOW_COUNT;
        let count = rows.len();
        let (mut coefficients, mut errors) = (Matrix::zero(size, count * each), Matrix::zero(size, count));
        let mut terms = Vec::new();
        for (i, row) in rows.enumerate() {
            terms.clear();
            terms.extend_from_slice(row.terms.get(..each * size).unwrap_or(&[]));
            bernstein_of_rows(&mut terms, size);
            for (k, term) in terms.chunks_exact(size.max(1)).enumerate() {
                term.iter().enumerate().for_each(|(j, &x)| coefficients.set(j, i * each + k, x));
            }
            row.error.iter().enumerate().for_each(|(j, &x)| errors.set(j, i, x));
        }
        Self { coefficients, errors }
    }

    /// The Bernstein coefficients of all rows at z, and their error bounds, by |z|.
    #[inline]
    pub(crate) fn at(&self, z: &[F], sizes: &[F], values: &mut Vec<F>, errors: &mut Vec<F>) {
        values.resize(self.coefficients.columns(), F::int(0));
        errors.resize(self.errors.columns(), F::int(0));
        self.coefficients.transposed_of(z, values);
        self.errors.transposed_of(sizes, errors);
    }
}

/// A row's Taylor terms, one after the other, with its error bound.
struct Terms<'a, F> {
    terms: &'a [F],
    error: Vec<F>,
}

impl<F: Float> Branch<F> {
    /// The branch with these modes. `longest` bounds its step, as it has that of the `others`, which are known already; where nothing in the
    /// branch is as fast, it has the step `free`.
    pub(crate) fn new<'b>(
        system: &Assembly<F>,
        modes: &[Mode],
        [longest, free]: [F; 2],
        mut others: impl Iterator<Item = &'b Self>,
    ) -> Self
    where
        F: 'b,
    {
        let Equation { a, tension, stuck, slips, tie } = Equation::new(system, modes);
        let transposed = a.transposed();
        let few = Few::new(system, &a);
        let one = F::int(1);
        let (reach, degree) =
            few.as_ref().map_or_else(|| (one, degree_of_full_accuracy(one)), |few| (few.reach, few.degree));
        // As where a contact slides the other way; the rate of a large branch is at most that of one with larger entries.
        let is_like = |b: &&Self| match (&few, &b.few) {
            (Some(_), Some(_)) => b.a.has_sizes_above(&a),
            (None, None) => b.a.has_sizes_of(&a),
            _ => false,
        };
        let other = others.find(is_like);
        let step = other.map_or_else(
            || {
                let most = reach / fastest(system, &a);
                if most < longest { most } else { free }
            },
            |other| other.step,
        );
        let bound = few.is_none().then(|| {
            other
                .and_then(|other| other.bound.clone())
                .unwrap_or_else(|| Bound::new(&transposed.map(|x| x.abs()), system.free, step, degree))
        });
        let mut guards = guards(system, modes, &tension, slips);
        guards.extend(releases(system, &stuck, &tension));
        guards.iter_mut().for_each(|guard| tie.iter().for_each(|tie| tie.substitute(&mut guard.row)));
        let mut low = Vec::with_capacity(guards.len());
        let mut all = Vec::with_capacity(guards.len());
        // A speed that is kept at a corner of the law, as between two belts, has the corner's rounding. The law is
        // continuous there.
        let rounding_of_corner = |guard: &Guard<F>| {
            corner(system, modes, guard).map_or(F::int(0), |corner| corner * F::epsilon() * F::int(64))
        };
        let corners: Vec<F> = guards.iter().map(rounding_of_corner).collect();
        for (guard, &corner) in guards.iter_mut().zip(&corners) {
            let Some(bound) = &bound else {
                (guard.entries, guard.corner) = (entries(&guard.row), corner);
                continue;
            };
            let powers = Series { transposed: &transposed, step, bound, degree };
            let terms = powers.terms(&guard.row, degree + 1);
            let rounding = powers.rounding(&guard.row);
            guard.error = powers.error_of(&rounding, &terms, degree + 1);
            low.push(powers.error_of(&rounding, &terms, LOW_DEGREE + 1));
            if let Some(last) = guard.error.last_mut() {
                *last = *last + corner;
            }
            guard.taylor = columns_of(&terms, system.size, degree + 1);
            all.push(terms);
        }
        let splits = if system.shortcuts {
            let roundings: Vec<_> = guards.iter().zip(corners).collect();
            Split::all(system, &a, &roundings, step, longest, degree)
        } else {
            Vec::new()
        };
        let hull = Hull::new(system.size, all.iter().zip(low).map(|(terms, error)| Terms { terms, error }));
        let speed_errors = vec![OnceCell::new(); modes.len()];
        let mut terms = is_small::<F>(system.size).then(|| Propagator::zero(0, 0));
        let whole = OnceCell::new();
        if few.is_none() {
            whole.get_or_init(|| Propagator::new(&transposed, system.free, step, degree, terms.as_mut()));
        }
        let powers = other.filter(|b| b.a.moves_as(&a, system.free)).map(|b| b.powers.clone());
        Self {
            modes: modes.to_vec(),
            a,
            transposed,
            step,
            whole,
            few,
            free: system.free,
            powers: powers.unwrap_or_else(|| Rc::new(Powers::new())),
            terms,
            bound,
            degree,
            guards,
            speed_errors,
            hull,
            tension,
            tie,
            splits,
        }
    }

    /// e^{Ah}.
    pub(crate) fn whole(&self) -> &Propagator<F> {
        let Self { transposed, free, step, degree, .. } = self;
        self.whole.get_or_init(|| Propagator::new(transposed, *free, *step, *degree, None))
    }

    /// Its memory in bytes.
    pub(crate) fn bytes(&self) -> usize {
        let guards =
            self.guards.iter().map(|guard| guard.taylor.entries() + 2 * guard.row.len()).sum::<usize>();
        let size = self.a.rows().count();
        let speeds = if self.few.is_some() { 2 * size } else { self.speed_errors.len() * size };
        let hull = self.hull.coefficients.entries() + self.hull.errors.entries();
        let terms = self.terms.as_ref().map_or(0, Propagator::entries);
        let powers = self.powers.entries();
        let splits: usize = self.splits.iter().map(Split::entries).sum();
        let whole = self.whole.get().map_or(0, Propagator::entries);
        let bound = self.bound.as_ref().map_or(0, Bound::entries);
        let few = self.few.as_ref().map_or(0, Few::entries);
        let entries = whole + splits + powers + terms + bound + hull + few;
        let tension = self.tension.iter().map(Vec::len).sum::<usize>();
        let sparse = 4 * self.a.rows().map(<[_]>::len).sum::<usize>();
        (guards + speeds + entries + tension + sparse) * size_of::<F>()
    }

    /// The error bound of the velocity of the contact at this place, by the row of that velocity.
    pub(crate) fn speed_error(&self, element: usize, velocity: &[F], z: &[F]) -> F {
        let Self { transposed, step, bound, degree, .. } = self;
        if let Some(few) = &self.few {
            return few.errors(&absolute(z), *step, *degree, |errors| size_of_dot(velocity, errors));
        }
        let Some(bound) = bound else { return F::int(0) };
        let error = || Series { transposed, step: *step, bound, degree: *degree }.error(velocity);
        self.speed_errors.get(element).map_or(F::int(0), |place| size_of_dot(place.get_or_init(error), z))
    }

    /// The error bounds of the polynomials of all guards over the step, at a state of these sizes.
    pub(crate) fn errors(&self, sizes: &[F], result: &mut Vec<F>) {
        result.clear();
        let guards = self.guards.iter();
        match &self.few {
            Some(few) => few.errors(sizes, self.step, self.degree, |errors| {
                result.extend(guards.map(|guard| guard.error_by(errors)));
            }),
            None => result.extend(guards.map(|guard| dot(&guard.error, sizes))),
        }
    }

    /// Its longest step.
    pub(crate) fn longest(&self) -> F {
        self.splits.first().map_or(self.step, |split| split.step.or_larger(self.step))
    }

    /// The size of an entry of `A z`: `|A| |z|`.
    pub(crate) fn size_of_slope(&self, place: usize, z: &[F]) -> F {
        self.a.size_of(place, z)
    }

    /// The roundings of a coefficient of the polynomial of a row of this length, in units of ε.
    pub(crate) fn roundings(&self, length: usize) -> F {
        integer((self.degree + 1) * (length + 3))
    }

    /// `A z`.
    pub(crate) fn derivative(&self, z: &[F]) -> Vec<F> {
        let mut result = vec![F::int(0); z.len()];
        self.a.of(z, &mut result);
        result
    }

    /// Whether rounding cannot tell the velocity along an element from zero, by what it could be within a step.
    pub(crate) fn is_slow(&self, system: &Assembly<F>, element: usize, z: &[F]) -> bool {
        let Some(part) = system.parts.get(element) else { return false };
        let bound = self.speed_error(element, &part.velocity, z);
        dot(&part.velocity, z).abs() <= bound * F::int(4)
    }

    /// How many Taylor terms are above rounding over a time t ≤ h.
    fn degree_over(&self, time: F) -> usize {
        let reach = self.few.as_ref().map_or(time, |few| time * few.reach);
        degree_over(reach, self.step, self.degree)
    }

    /// The Taylor coefficients `Aᵏ z tᵏ/k!` over a time t ≤ h, one after the other in one list.
    pub(crate) fn taylor(&self, z: &[F], time: F, terms: &mut Vec<F>) {
        terms.clear();
        terms.extend_from_slice(z);
        series(&self.a, time, self.degree_over(time), z.len(), terms);
    }

    /// All Taylor terms of full degree over a time t ≤ h.
    pub(crate) fn all_terms(&self, z: &[F], time: F, terms: &mut Vec<F>) {
        terms.clear();
        terms.extend_from_slice(z);
        series(&self.a, time, self.degree, z.len(), terms);
    }

    /// The state after a part of the time whose Taylor terms are given, which become those of the part.
    pub(crate) fn after_part(&self, part: F, terms: &mut Vec<F>, after: &mut [F]) {
        if part != F::int(1) {
            shortened_terms(terms, after.len(), part, self.degree);
        }
        after.fill(F::int(0));
        for term in terms.chunks_exact(after.len().max(1)).rev() {
            add_times(after, F::int(1), term);
        }
    }

    /// Moves columns over the free states by a time t ≤ h, by the series.
    pub(crate) fn move_columns(&self, columns: &mut [Vec<F>], time: F) {
        let mut together = Matrix::zero(self.free, columns.len());
        for (j, column) in columns.iter().enumerate() {
            column.iter().enumerate().for_each(|(i, &x)| together.set(i, j, x));
        }
        let moved = exponential(&self.a, together, time, self.degree_over(time), None);
        for (i, row) in moved.rows().enumerate() {
            columns.iter_mut().zip(row).for_each(|(column, &x)| set(column, i, x));
        }
    }

    /// (e^{At})ᵀ for the first states, which no others depend on, over a time t ≤ h.
    pub(crate) fn free_motion(&self, time: F, free: usize) -> Matrix<F> {
        exponential(&self.transposed, Matrix::identity(free), time, self.degree_over(time), None)
    }

    /// e^{At} over a time t ≤ h, where the matrix is small: whether it is. `powers` is a buffer.
    pub(crate) fn motion(&self, time: F, powers: &mut Vec<F>, motion: &mut Propagator<F>) -> bool {
        let Some(terms) = &self.terms else { return false };
        let part = time / self.step;
        let mut power = F::int(1);
        powers.clear();
        powers.push(power);
        for _ in 0..self.degree_over(time) {
            power = power * part;
            powers.push(power);
        }
        terms.sum_of_terms(powers, motion);
        true
    }

    /// z after a time t ≤ h.
    pub(crate) fn after(&self, z: &[F], time: F, terms: &mut Vec<F>, after: &mut [F]) {
        self.taylor(z, time, terms);
        after.fill(F::int(0));
        for term in terms.chunks_exact(z.len().max(1)).rev() {
            add_times(after, F::int(1), term);
        }
    }
}

/// The coefficients of a row's polynomial.
pub(crate) fn polynomial<F: Float>(row: &[F], terms: &[F]) -> Vec<F> {
    terms.chunks_exact(row.len().max(1)).map(|term| dot(row, term)).collect()
}

/// The guards of a branch: rows that are positive as long as it lasts.
fn guards<F: Float>(
    system: &Assembly<F>,
    modes: &[Mode],
    tension: &[Vec<F>],
    slips: Vec<Vec<F>>,
) -> Vec<Guard<F>> {
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
    let elements = system.parts.iter().zip(modes).zip(tension).zip(slips);
    for (i, (((part, mode), tension), slip)) in elements.enumerate() {
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
                if let Some(limit) =
                    part.limit.filter(|&limit| from(piece + 1).is_none_or(|high| high > limit))
                {
                    add(i, Trigger::Ends, plus(times(&speed, -one), limit));
                }
            }
            (Mode::Yields { .. }, Rule::Elastic { .. }) => add(i, Trigger::Stops, slip),
            (Mode::Holds, Rule::Elastic { bound, .. }) => {
                for forward in [true, false] {
                    let mut row = times(tension, -sign::<F>(forward));
                    add_times(&mut row, one, bound);
                    add(i, Trigger::Releases { forward }, row);
                }
            }
            (Mode::Away, Rule::Stop { depth, .. } | Rule::Hard { depth, .. }) => {
                add(i, Trigger::Closes, times(depth, -one))
            }
            (Mode::Pressed, Rule::Stop { .. }) => add(i, Trigger::Opens, tension.clone()),
            (Mode::Bends { piece }, Rule::Spring { pieces }) => {
                let stretch = part.stretch.as_deref().unwrap_or(&[]);
                let from = |k: usize| pieces.get(k).map(|p: &Piece<F>| p.from);
                if let Some((below, low)) = piece.checked_sub(1).zip(from(piece)) {
                    add(i, Trigger::Piece(below), plus(stretch.to_vec(), -low));
                }
                if let Some(high) = from(piece + 1) {
                    add(i, Trigger::Piece(piece + 1), plus(times(stretch, -one), high));
                }
                if let Some(limit) = part.limit {
                    for sign in [one, -one] {
                        add(i, Trigger::Ends, plus(times(stretch, sign), limit));
                    }
                }
            }
            (Mode::Lifted, Rule::Stop { depth, .. }) => {
                add(i, Trigger::Clears, depth.clone());
                add(i, Trigger::Presses, times(&pressing(part), -one));
            }
            _ => {}
        }
        // A contact under a stop ends with that stop.
        if let Some(normal) = part.normal().filter(|_| part.under.is_none())
            && normal.iter().rev().skip(1).any(|&x| x != F::int(0))
        {
            let apart = *mode == Mode::Apart;
            let trigger = if apart { Trigger::Meets } else { Trigger::Parts };
            add(i, trigger, times(normal, if apart { -one } else { one }));
        }
    }
    guards
}

/// The speed, or the size of the stretch, at which a guard passes from one piece of a law to the next.
fn corner<F: Float>(system: &Assembly<F>, modes: &[Mode], guard: &Guard<F>) -> Option<F> {
    let part = system.parts.get(guard.element)?;
    match (guard.trigger, modes.get(guard.element)?, &part.rule) {
        (Trigger::Piece(to), Mode::Slides { piece, .. }, Rule::Contact { pieces, .. }) => {
            pieces.get(to.max(*piece)).map(|p| p.from)
        }
        (Trigger::Piece(to), Mode::Bends { piece }, Rule::Spring { pieces }) => {
            pieces.get(to.max(*piece)).map(|p| p.from.abs())
        }
        _ => None,
    }
}

/// The bound of a contact at rest as a row: peak r(0) N; of an elastic one r N.
pub(crate) fn static_bound<F: Float>(part: &Part<F>) -> Vec<F> {
    let mut row = vec![F::int(0); part.velocity.len()];
    if let Rule::Elastic { bound, .. } = &part.rule {
        row.clone_from(bound);
    }
    if let Rule::Contact { peak, normal, pieces } = &part.rule {
        let force = pieces.first().map_or(F::int(0), |p| p.force) * *peak;
        match normal {
            Some(normal) => add_times(&mut row, force, normal),
            None => row.iter_mut().rev().take(1).for_each(|last| *last = force),
        }
    }
    row
}

/// The guards of the contacts that stick: `Σ |gᵢ| Rᵢ ∓ Σ gᵢ Tᵢ` for each facet g of what they can hold. A stop that gives no way holds any
/// force ≥ 0: its bound is 0 on one side, and there is none on the other.
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
            let presses = |&(place, g): &(usize, F)| {
                let rule = stuck.get(place).and_then(|&i| system.parts.get(i)).map(|part| &part.rule);
                matches!(rule, Some(Rule::Hard { .. })) && (g > F::int(0)) == forward
            };
            if facet.iter().any(presses) {
                continue;
            }
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
