//! Stops with a restitution: blows, and contact after ever smaller ones.
//!
//! **A blow.** At `g = b·q − gap = 0` with `v = b·q′ > 0` the velocity jumps: `q′₊ = q′ − Σ M⁻¹bᵢ Pᵢ`. Frictions are finite and take no part.
//! Stops that are hit at one instant, and stops in touch, act at once by Newton's law as Moreau wrote it for several:
//!
//! `vᵢ₊ + eᵢ vᵢ ≤ 0`, `Pᵢ ≥ 0`, and one of both is zero.
//!
//! These are the conditions for the least value of `½ Pᵀ G P − Σ (1 + eᵢ) vᵢ Pᵢ` with P ≥ 0, `G = Bᵀ M⁻¹ B`: the velocities after it are
//! unique, so that a symmetric machine stays symmetric, and `Σ Pᵢ (1 − eᵢ) vᵢ/2 ≥ 0` is lost. One stop alone has `P = (1 + e) v/(b·M⁻¹b)`.
//!
//! **Ever smaller blows.** Under an acceleration a towards the stop a flight that begins with the velocity v takes 2 v/a and ends with v. The flights
//! after a blow that arrives with v therefore take `2 e v/(a (1 − e))` together, a geometric sum. Where contacts turn during
//! the flights, their ratio r is not e: the sum is `r/(1 − r)` times the last flight, with r as it is measured. The rest of the sum is taken where it is below 2⁻²⁴ (`small(24)`) of
//! a step, and where its error `|a′| T²/a`, by the change of a within it, is below 2⁻⁴⁸ of a step. What moves across M⁻¹b meanwhile differs from the motion in
//! touch by the third power of v: the flights are v²/2a high, and take v/a.
//!
//! **Small distances.** After a blow the distance from the stop is exactly 0, and the state knows it only to its rounding. It is therefore carried
//! beside the state, from the Taylor polynomial of the guard: its other coefficients are known relative to velocities and accelerations. At 0 the
//! polynomial is divided by the time.

use super::assembly::{Assembly, Part, Rule};
use super::branch::Branch;
use super::dependent::least;
use super::first_passage::{first_passage, shorten, value_and_slope};
use super::guard::{Guard, Trigger};
use super::matrix::{add_times, dot, size_of_dot};
use super::mode::{Mode, places};
use super::precision::small;
use super::under::{Rub, rubbed, rubs};
use crate::float::Float;
use alloc::vec;
use alloc::vec::Vec;

/// The last blow of a stop.
#[derive(Debug, Clone)]
struct Last<F> {
    /// The velocity away from the stop after it.
    speed: F,
    /// The time since then.
    flight: F,
    /// Whether another event has come since then.
    is_disturbed: bool,
    /// By how much it was slower than the blow before.
    ratio: Option<F>,
}

/// What is known of each stop with a restitution.
#[derive(Debug, Clone)]
struct Near<F> {
    element: usize,
    /// The distance from it, where it is known better than by the state.
    distance: Option<F>,
    /// The polynomial of the distance over the step that is tried.
    polynomial: Vec<F>,
    last: Option<Last<F>>,
}

/// The stops with a restitution during a motion.
#[derive(Debug, Clone)]
pub(crate) struct Blows<F> {
    stops: Vec<Near<F>>,
}

impl<F: Float> Blows<F> {
    pub(crate) fn new(system: &Assembly<F>) -> Self {
        let hard = system.parts.iter().enumerate().filter(|(_, part)| matches!(part.rule, Rule::Hard { .. }));
        let near = |(element, _)| Near { element, distance: None, polynomial: Vec::new(), last: None };
        Self { stops: hard.map(near).collect() }
    }

    /// Forgets all.
    pub(crate) fn clear(&mut self) {
        for stop in &mut self.stops {
            (stop.distance, stop.last) = (None, None);
        }
    }

    /// Whether a body is so near to a stop that its distance is carried.
    pub(crate) fn is_near(&self) -> bool {
        self.stops.iter().any(|stop| stop.distance.is_some())
    }

    /// Whether a body is at a stop, within the rounding of the state: it may leave it or press it.
    pub(crate) fn is_at(&self, system: &Assembly<F>, z: &[F], element: usize) -> bool {
        let distance = self.stops.iter().find(|stop| stop.element == element).and_then(|stop| stop.distance);
        match (distance, system.parts.get(element).map(|part| &part.rule)) {
            (Some(distance), Some(Rule::Hard { depth, .. })) => {
                distance <= size_of_dot(depth, z) * F::epsilon() * F::int(16)
            }
            _ => false,
        }
    }

    fn stop(&mut self, element: usize) -> Option<&mut Near<F>> {
        self.stops.iter_mut().find(|stop| stop.element == element)
    }

    /// A body is at a stop.
    pub(crate) fn arrive(&mut self, element: usize) {
        if let Some(stop) = self.stop(element) {
            stop.distance = Some(F::int(0));
        }
    }

    /// Another event has come.
    pub(crate) fn disturb(&mut self) {
        self.stops.iter_mut().filter_map(|stop| stop.last.as_mut()).for_each(|last| last.is_disturbed = true);
    }

    /// Where a guard whose distance is carried certainly passes zero within a time, as a part of it; the outer option is none where its
    /// distance is not carried. `c` is its polynomial.
    pub(crate) fn passage(
        &mut self,
        branch: &Branch<F>,
        guard: &Guard<F>,
        (z, sizes): (&[F], &[F]),
        part: F,
    ) -> Option<Option<F>> {
        if guard.trigger != Trigger::Closes {
            return None;
        }
        let stop = self.stop(guard.element)?;
        let distance = stop.distance?;
        let c = &mut stop.polynomial;
        guard.polynomial(z, part, c);
        if let Some(first) = c.first_mut() {
            *first = distance;
        }
        // The rounding of the first coefficient, which is known, is none. That of the others falls with the time at least.
        let all = dot(&guard.error, sizes);
        let first = size_of_dot(&guard.row, sizes) * F::epsilon() * branch.roundings(guard.row.len());
        let error = part * (all - first).or_larger(all * F::epsilon() * F::int(16));
        Some(passage(c, error))
    }

    /// The motion goes on by a part of the time that was tried.
    pub(crate) fn moved(&mut self, system: &Assembly<F>, sizes: &[F], part: F, lasted: F) {
        for stop in &mut self.stops {
            if let Some(last) = &mut stop.last {
                last.flight = last.flight + lasted;
            }
            if let (Some(distance), Some(hard)) = (&mut stop.distance, system.parts.get(stop.element)) {
                // Below 0 by no more than rounding: a passage would have been certain.
                *distance = value_and_slope(&stop.polynomial, part).0.or_larger(F::int(0));
                let Rule::Hard { depth, .. } = &hard.rule else { continue };
                // Farther away the state knows it well enough.
                let is_far = *distance > size_of_dot(depth, sizes) * F::exp2i(-8);
                if is_far || stop.polynomial.is_empty() {
                    stop.distance = None;
                }
                stop.polynomial.clear();
            }
        }
    }
}

/// Where a distance certainly passes zero: the first place in [0, 1]. Beside 0 the polynomial is looked at over parts that grow, so that its
/// error is small beside it.
fn passage<F: Float>(c: &[F], error: F) -> Option<F> {
    let (zero, one) = (F::int(0), F::int(1));
    let at = |k: usize| c.get(k).copied().unwrap_or(zero);
    let (distance, speed, fall) = (at(0), at(1), -at(2));
    let mut part = one;
    if fall > zero {
        let due = (speed + (speed * speed + F::int(4) * distance * fall).sqrt()) / fall;
        part = if due > zero && due < one { due } else { one };
    }
    let mut scaled = Vec::with_capacity(c.len());
    loop {
        scaled.clear();
        let mut factor = one;
        for &c in c {
            scaled.push(c * factor);
            factor = factor * part;
        }
        if distance == zero && !scaled.is_empty() {
            scaled.remove(0);
        }
        let error = error * part;
        if !(error.is_finite() && scaled.iter().all(|c| c.is_finite())) {
            return Some(zero);
        }
        shorten(&mut scaled, error);
        if let Some(found) = first_passage(&scaled, error) {
            return Some(found * part);
        }
        if part >= one {
            return None;
        }
        let longer = part * F::int(16);
        part = if longer < one { longer } else { one };
    }
}

/// A blow at one stop.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Blow<F> {
    pub(crate) element: usize,
    /// P.
    pub(crate) impulse: F,
    /// The mean of the velocities b·q′ of the bodies before and after it.
    pub(crate) mean: F,
    /// The velocities along the stop before and after it, where they are told.
    pub(crate) told: Option<(F, F)>,
}

/// The derivative of the velocities after a blow by those before: `q′₊ = q′ − Σ by (row·z)`.
#[derive(Debug, Clone)]
pub(crate) struct Reset<F> {
    n: usize,
    rows: Vec<Vec<F>>,
    by: Vec<Vec<F>>,
}

impl<F: Float> Reset<F> {
    /// The change of a disturbance or of a derivative of the state.
    pub(crate) fn apply(&self, x: &mut [F]) {
        let along: Vec<F> = self.rows.iter().map(|row| dot(row, x)).collect();
        let velocities = x.get_mut(self.n..2 * self.n).unwrap_or(&mut []);
        for (by, along) in self.by.iter().zip(along) {
            add_times(velocities, -along, by);
        }
    }
}

/// What blows do at an instant.
pub(crate) struct Strike<F> {
    pub(crate) blows: Vec<Blow<F>>,
    pub(crate) reset: Reset<F>,
    /// The time after which ever smaller blows end.
    pub(crate) later: F,
    /// The change of the state.
    change: Vec<F>,
}

impl<F: Float> Strike<F> {
    /// Whether it leaves the velocity along an element as it is.
    pub(crate) fn keeps(&self, part: &Part<F>) -> bool {
        keeps(part, &self.change)
    }
}

/// Whether a change of the state is none along an element but for rounding. What rounding has left to the velocity of an element at rest is no
/// velocity, and a branch in which it rests knows no error of it.
fn keeps<F: Float>(part: &Part<F>, change: &[F]) -> bool {
    dot(&part.velocity, change).abs() <= size_of_dot(&part.velocity, change) * F::epsilon() * F::int(64)
}

/// A stop that takes part in a blow.
struct Struck<F> {
    element: usize,
    /// Whether it is hit; otherwise it has been in touch.
    is_hit: bool,
    /// Whether it is in touch afterwards, unless another one pushes the body away.
    closes: bool,
    /// 1 + e, with e = 0 where it is in touch afterwards.
    factor: F,
    /// The velocity after it that is told, where it is above rounding.
    after: Option<F>,
    /// The velocities along the stop, and of the bodies alone, before it.
    velocity: F,
    body: F,
    doubt: F,
}

/// The velocities after the blows at the stops in `hit`. Those that end in contact have the mode [`Mode::Resting`] afterwards. The stop that cannot
/// be decided is the error.
pub(crate) fn strike<F: Float>(
    system: &Assembly<F>,
    branch: &Branch<F>,
    z: &mut [F],
    modes: &mut [Mode],
    hit: &[usize],
    known: &mut Blows<F>,
) -> Result<Strike<F>, usize> {
    let (zero, one) = (F::int(0), F::int(1));
    let before = z.to_vec();
    let slope = branch.derivative(z);
    let bend = branch.derivative(&slope);
    let mut later = zero;
    let mut touching = places(modes, |mode| mode == Mode::Resting);
    touching.retain(|element| !hit.contains(element));
    let mut all: Vec<Struck<F>> = Vec::new();
    for element in hit.iter().copied().chain(touching) {
        let Some(part) = system.parts.get(element) else { return Err(element) };
        let Rule::Hard { restitution, .. } = &part.rule else { return Err(element) };
        let [velocity, pressing, change] = [&*z, &slope, &bend].map(|list| dot(&part.velocity, list));
        let is_hit = hit.contains(&element);
        let ends = if !is_hit || branch.is_slow(system, element, z) {
            Some(zero)
        } else {
            known.left(element, *restitution, velocity, [pressing, change], branch.step)
        };
        later = later.or_larger(ends.unwrap_or(zero));
        all.push(Struck {
            element,
            is_hit,
            closes: ends.is_some(),
            factor: if ends.is_some() { one } else { one + *restitution },
            after: (is_hit && !branch.is_slow(system, element, z)).then(|| zero - *restitution * velocity),
            velocity,
            body: system.along(element, z),
            doubt: size_of_dot(&part.velocity, z) * F::epsilon() * F::int(256),
        });
    }
    let elements: Vec<usize> = all.iter().map(|one| one.element).collect();
    let due: Vec<F> = all.iter().map(|one| one.factor * one.velocity).collect();
    let doubt: Vec<F> = all.iter().map(|one| one.doubt).collect();
    let (low, high) = (vec![Some(zero); all.len()], vec![None; all.len()]);
    let impulses = least(&system.coupling_of(&elements), &due, &doubt, &low, &high)
        .map_err(|_| hit.first().copied().unwrap_or_default())?;
    let n = system.n;
    let pairs: Vec<(usize, F)> = elements.iter().copied().zip(impulses.iter().copied()).collect();
    let rubs = rubs(system, z, &pairs)?;
    let (mut blows, mut active) = (Vec::new(), Vec::new());
    for rub in &rubs {
        let body = system.along(rub.element, z);
        blows.push(Blow { element: rub.element, impulse: rub.impulse, mean: body, told: None });
    }
    for &(element, impulse) in
        pairs.iter().chain(&rubs.iter().map(|rub| (rub.element, rub.impulse)).collect::<Vec<_>>())
    {
        let response = system.parts.get(element).map_or(&[][..], |part| &part.response);
        add_times(z.get_mut(n..2 * n).unwrap_or(&mut []), -impulse, response);
    }
    for blow in &mut blows {
        blow.mean = (blow.mean + system.along(blow.element, z)) / F::int(2);
    }
    place_at_gap(system, z, &elements);
    let change: Vec<F> = z.iter().zip(&before).map(|(&after, &before)| after - before).collect();
    for (one, &impulse) in all.iter().zip(&impulses) {
        let element = one.element;
        let Some(part) = system.parts.get(element) else { return Err(element) };
        let speed = -dot(&part.velocity, z);
        let stays = branch.is_slow(system, element, z) || (!one.is_hit && keeps(part, &change));
        let leaves = !one.closes || (speed > zero && !stays);
        if let Some(mode) = modes.get_mut(element) {
            *mode = if leaves { Mode::Away } else { Mode::Resting };
        }
        known.arrive(element);
        if one.is_hit {
            known.record(element, speed);
        }
        if impulse > zero {
            active.push((element, one.factor));
            let mean = (one.body + system.along(element, z)) / F::int(2);
            // A stop that closes at another one's blow may be left faster than by itself.
            let after = one.after.map(|after| if leaves { -speed } else { after });
            blows.push(Blow { element, impulse, mean, told: after.map(|after| (one.velocity, after)) });
        }
    }
    Ok(Strike { blows, reset: reset(system, &active, &rubs), later, change })
}

/// Takes the rounding of their distances out of the displacements of bodies at stops.
pub(crate) fn place_at_gap<F: Float>(system: &Assembly<F>, z: &mut [F], elements: &[usize]) {
    let depth = |&i: &usize| match system.parts.get(i).map(|part| &part.rule) {
        Some(Rule::Hard { depth, .. }) => dot(depth, z),
        _ => F::int(0),
    };
    let depths: Vec<F> = elements.iter().map(depth).collect();
    if depths.iter().all(|&x| x == F::int(0)) {
        return;
    }
    let shares = system.coupling_of(elements).pseudo_inverse().of(&depths);
    for (part, share) in elements.iter().filter_map(|&i| system.parts.get(i)).zip(shares) {
        add_times(z.get_mut(..system.n).unwrap_or(&mut []), -share, &part.response);
    }
}

/// The direction of an element without what stops in touch take: b·q beside those that do not change.
pub(crate) fn beside<F: Float>(system: &Assembly<F>, element: usize, touching: &[usize]) -> Vec<F> {
    let mut row = system.parts.get(element).map_or_else(Vec::new, |part| part.direction.clone());
    if touching.is_empty() {
        return row;
    }
    let size = dot(&row, &row);
    let own: Vec<F> = touching.iter().map(|&i| system.coupling.at(element, i)).collect();
    let shares = system.coupling_of(touching).pseudo_inverse().of(&own);
    for (part, share) in touching.iter().filter_map(|&i| system.parts.get(i)).zip(shares) {
        add_times(&mut row, -share, &part.direction);
    }
    if dot(&row, &row) <= size * small(40) {
        row.fill(F::int(0));
    }
    row
}

/// The derivative of blows at these stops, each with its 1 + e, with the frictions under them.
fn reset<F: Float>(system: &Assembly<F>, active: &[(usize, F)], rubs: &[Rub<F>]) -> Reset<F> {
    let elements: Vec<usize> = active.iter().map(|one| one.0).collect();
    let row = |&i: &usize| system.parts.get(i).map_or_else(Vec::new, |part| part.velocity.clone());
    let inverse = system.coupling_of(&elements).pseudo_inverse();
    let rubbed = rubbed(system, rubs);
    let by = |(k, &(_, factor)): (usize, &(usize, F))| {
        let mut by = vec![F::int(0); system.n];
        for (i, element) in elements.iter().enumerate() {
            let share = factor * inverse.at(i, k);
            let response = system.parts.get(*element).map(|part| &part.response);
            let others = rubbed.by_stop.iter().filter(|(stop, _)| stop == element).map(|(_, by)| by);
            response.into_iter().chain(others).for_each(|change| add_times(&mut by, share, change));
        }
        by
    };
    let (rests, stops): (Vec<usize>, Vec<Vec<F>>) = rubbed.by_rest.iter().cloned().unzip();
    Reset {
        n: system.n,
        rows: elements.iter().chain(&rests).map(row).collect(),
        by: active.iter().enumerate().map(by).chain(stops).collect(),
    }
}

impl<F: Float> Blows<F> {
    /// The velocity with which a body leaves a stop.
    fn record(&mut self, element: usize, speed: F) {
        let Some(stop) = self.stop(element) else { return };
        let ratio = stop.last.as_ref().filter(|last| last.speed > F::int(0)).map(|last| speed / last.speed);
        stop.last = Some(Last { speed, flight: F::int(0), is_disturbed: false, ratio });
    }

    /// The time after which the blows of a stop end, where their sum is known: before one that arrives with the velocity `v`, under the
    /// acceleration towards the stop and its change.
    fn left(&self, element: usize, e: F, v: F, [pressing, change]: [F; 2], step: F) -> Option<F> {
        let (zero, one) = (F::int(0), F::int(1));
        if e == zero {
            return Some(zero);
        }
        let last = self.stops.iter().find(|stop| stop.element == element)?.last.as_ref()?;
        let time = if last.is_disturbed {
            // As many events in each flight repeat themselves with it.
            let (ratio, before) = (e * v / last.speed, last.ratio?);
            let is_steady = (ratio - before).abs() * F::int(16) <= one - ratio;
            is_steady.then(|| last.flight * ratio / (one - ratio))?
        } else {
            F::int(2) * e * v / (pressing * (one - e))
        };
        let is_short = time > zero && time <= step * small(24);
        // Also where it is not a number.
        let is_known = pressing > zero && change.abs() * time * time <= pressing * step * small(48);
        (is_short && is_known).then_some(time)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `p = x + v s − a s²/2` passes zero at `(v + √(v² + 2 a x))/a`, for distances far below the rounding of the state.
    #[test]
    fn a_distance_far_below_rounding_passes_zero_where_it_does() {
        for (x, v) in [(0.0, 1e-3), (0.0, 1e-9), (1e-18, 0.0), (1e-20, -1e-9), (1e-20, 1e-10)] {
            let a = 0.7_f64;
            let found = passage(&[x, v, -a / 2.0], 1e-14).unwrap();
            let due = (v + (v * v + 2.0 * a * x).sqrt()) / a;
            assert!((found / due - 1.0).abs() < 1e-14, "{x} {v}: {found} {due}");
        }
        // Away under an acceleration away.
        assert_eq!(passage(&[0.0, 1e-9, 0.1], 1e-14), None);
        assert_eq!(passage(&[0.0, -1e-18, 0.1], 1e-14), None);
        assert_eq!(passage(&[0.0, -1e-9, 0.1], 1e-14), Some(0.0));
    }
}
