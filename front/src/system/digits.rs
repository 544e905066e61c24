//! The digits of answers that are computed with tables of curves.
//!
//! Let a, b, c be a number with tables of N/2, N and 2N pieces, whose errors are in the proportion 16 : 4 : 1 but for terms of higher order.
//! Extrapolation takes `c + (c − b)/3`. It would be right where `b + (b − a)/3` is the same; so `|4 (c − b) − (b − a)|/3` estimates its error,
//! and no less than a 32nd of that of c, |c − b|/3, is taken: a number may have little error by chance. For the same reason no error is taken
//! to be less than a tenth of the largest one of displacements and velocities, each over the greatest of its kind. What is nothing beside the motion
//! that the loads alone would give a free body, or one on its springs, is rounding, and counts as none.
//!
//! A number is printed to the last digit whose unit is at least eight times its error, so that the digits are right but for one unit of the last.

use super::proved::{Proved, ProvedSteady};
use stickslip::system::{Model, Motion, State, Steady, SteadyKind};

/// The kinds of numbers that are compared with each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Unit {
    Displacement,
    Velocity,
    Acceleration,
    Force,
    Work,
    Time,
    /// The time of an event: later ones are no better known than earlier ones.
    Event,
    /// A number that is compared with itself alone.
    Plain,
}

/// A number of an answer.
pub(super) struct Number<'n> {
    pub(super) unit: Unit,
    /// Whether it tells a phase that answers need not share.
    pub(super) is_phase: bool,
    pub(super) value: &'n mut f64,
}

/// An answer with numbers.
pub(super) trait Numbers: Clone {
    /// All numbers that depend on the laws, in an order that is the same where the events are.
    fn numbers(&mut self) -> Vec<Number<'_>>;
    /// Whether another answer has the same events.
    fn is_like(&self, other: &Self) -> bool;
    /// The greatest speed or stretch of an element, where it is known.
    fn reach(&self, element: usize) -> Option<f64>;
    /// The time since its start, where it is that of a motion from a given one.
    fn duration(&self) -> Option<f64> {
        None
    }
    /// The steady motion that loads give its period, without a drift.
    fn steady(&self) -> Option<&Steady<f64>> {
        None
    }
    /// The time over which it is followed.
    fn span(&self) -> f64;
}

fn listed<'n>(unit: Unit, is_phase: bool, list: &'n mut [f64], into: &mut Vec<Number<'n>>) {
    into.extend(list.iter_mut().map(|value| Number { unit, is_phase, value }));
}

fn of_state<'n>(state: &'n mut State<f64>, is_phase: bool, into: &mut Vec<Number<'n>>) {
    listed(Unit::Displacement, is_phase, &mut state.displacement, into);
    listed(Unit::Velocity, is_phase, &mut state.velocity, into);
    listed(Unit::Force, is_phase, &mut state.force, into);
    listed(Unit::Acceleration, is_phase, &mut state.absolute_acceleration, into);
}

fn of_motion<'n>(motion: &'n mut Motion<f64>, is_phase: bool, into: &mut Vec<Number<'n>>) {
    of_state(&mut motion.end, is_phase, into);
    into.push(Number { unit: Unit::Plain, is_phase: false, value: &mut motion.duration });
    for list in [&mut motion.max_displacement, &mut motion.min_displacement] {
        listed(Unit::Displacement, false, list, into);
    }
    for list in [&mut motion.max_velocity, &mut motion.min_velocity] {
        listed(Unit::Velocity, false, list, into);
    }
    listed(Unit::Acceleration, false, &mut motion.max_absolute_acceleration, into);
    for element in &mut motion.elements {
        into.push(Number { unit: Unit::Time, is_phase: false, value: &mut element.time_at_rest });
        into.push(Number { unit: Unit::Work, is_phase: false, value: &mut element.work });
    }
    for value in [&mut motion.load_work, &mut motion.damper_work, &mut motion.stored] {
        into.push(Number { unit: Unit::Work, is_phase: false, value });
    }
    for event in &mut motion.events {
        into.push(Number { unit: Unit::Event, is_phase, value: &mut event.time });
        if let Some((before, after)) = &mut event.velocities {
            into.push(Number { unit: Unit::Velocity, is_phase, value: before });
            into.push(Number { unit: Unit::Velocity, is_phase, value: after });
        }
    }
}

impl Numbers for Motion<f64> {
    fn numbers(&mut self) -> Vec<Number<'_>> {
        let mut found = Vec::new();
        of_motion(self, false, &mut found);
        found
    }

    fn is_like(&self, other: &Self) -> bool {
        let kinds = |of: &Self| of.events.iter().map(|e| (e.element, e.kind)).collect::<Vec<_>>();
        kinds(self) == kinds(other)
    }

    fn reach(&self, element: usize) -> Option<f64> {
        self.elements.get(element)?.reach
    }

    fn duration(&self) -> Option<f64> {
        Some(self.duration)
    }

    fn span(&self) -> f64 {
        self.duration
    }
}

/// A steady motion, and whether a load gives it its phase.
#[derive(Clone)]
pub(super) struct OfSteady {
    pub(super) found: Steady<f64>,
    pub(super) is_loaded: bool,
}

impl Numbers for OfSteady {
    fn numbers(&mut self) -> Vec<Number<'_>> {
        let is_phase = !self.is_loaded;
        let mut found = Vec::new();
        let Steady { start, motion, drift, mean_velocity, period, multipliers, .. } = &mut self.found;
        of_state(start, is_phase, &mut found);
        listed(Unit::Displacement, false, drift, &mut found);
        listed(Unit::Velocity, false, mean_velocity, &mut found);
        if is_phase {
            found.push(Number { unit: Unit::Plain, is_phase: false, value: period });
        }
        for (re, im) in multipliers {
            found.push(Number { unit: Unit::Plain, is_phase: false, value: re });
            found.push(Number { unit: Unit::Plain, is_phase: false, value: im });
        }
        of_motion(motion, is_phase, &mut found);
        found
    }

    fn is_like(&self, other: &Self) -> bool {
        let (a, b) = (&self.found, &other.found);
        let kinds = |of: &Steady<f64>| {
            let mut all: Vec<_> = of.motion.events.iter().map(|e| (e.element, e.kind.name())).collect();
            // Its period may begin elsewhere.
            if !self.is_loaded {
                all.sort_unstable();
            }
            all
        };
        (a.kind, a.periods, a.multipliers.len()) == (b.kind, b.periods, b.multipliers.len())
            && kinds(a) == kinds(b)
    }

    fn reach(&self, element: usize) -> Option<f64> {
        self.found.motion.reach(element)
    }

    fn steady(&self) -> Option<&Steady<f64>> {
        let Steady { kind, drift, .. } = &self.found;
        let is_held = *kind == SteadyKind::Periodic && drift.iter().all(|by| *by == 0.0);
        (self.is_loaded && is_held).then_some(&self.found)
    }

    fn span(&self) -> f64 {
        self.found.motion.duration
    }
}

/// States at times, with a motion over them that tells how far they reach.
#[derive(Clone)]
pub(super) struct OfStates {
    pub(super) states: Vec<State<f64>>,
    pub(super) motion: Motion<f64>,
}

impl Numbers for OfStates {
    fn numbers(&mut self) -> Vec<Number<'_>> {
        let mut found = self.motion.numbers();
        for state in &mut self.states {
            of_state(state, false, &mut found);
        }
        found
    }

    fn is_like(&self, other: &Self) -> bool {
        self.motion.is_like(&other.motion)
    }

    fn reach(&self, element: usize) -> Option<f64> {
        self.motion.reach(element)
    }

    fn span(&self) -> f64 {
        self.motion.duration
    }
}

/// The time of a passage, if there is one, with the motion up to it.
#[derive(Clone)]
pub(super) struct OfPassage {
    pub(super) time: Option<f64>,
    pub(super) motion: Option<Motion<f64>>,
}

impl Numbers for OfPassage {
    fn numbers(&mut self) -> Vec<Number<'_>> {
        let mut found = self.motion.as_mut().map_or_else(Vec::new, Numbers::numbers);
        found.extend(self.time.as_mut().map(|value| Number { unit: Unit::Event, is_phase: false, value }));
        found
    }

    fn is_like(&self, other: &Self) -> bool {
        match (&self.motion, &other.motion) {
            (Some(a), Some(b)) => a.is_like(b),
            (a, b) => a.is_none() && b.is_none(),
        }
    }

    fn reach(&self, element: usize) -> Option<f64> {
        self.motion.as_ref()?.reach(element)
    }

    fn span(&self) -> f64 {
        self.motion.as_ref().map_or(f64::INFINITY, |motion| motion.duration)
    }
}

/// What a number has at least of the largest relative error of displacements and velocities.
const SHARED: f64 = 0.1;
/// The part of the greatest number of a kind below which a bound is told.
const USEFUL: f64 = 0.1;
/// What an extrapolated number has at least of the error of the finest table.
const LEAST: f64 = 1.0 / 32.0;

/// Displacements and velocities below which a body that loads act on is at rest but for rounding.
#[derive(Debug, Clone, Copy)]
pub(super) struct Nothing {
    displacement: f64,
    velocity: f64,
}

impl Nothing {
    /// Of a model that is followed for a time: 2⁻⁴⁰ of `F τ²/m` and `F τ/m`, with the sum F of the amplitudes of its loads and τ that time, or
    /// √(m/k) if that is shorter, for the heaviest mass and the stiffest entries.
    pub(super) fn new(model: &Model<f64>, time: f64) -> Self {
        let sum = |list: &[f64]| list.iter().map(|x| x.abs()).sum::<f64>();
        let harmonics = model.harmonics.iter().map(|h| sum(&h.sin) + sum(&h.cos));
        let greatest = |list: &[f64]| list.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let records = model.records.iter().map(|record| sum(&record.force) * greatest(&record.values));
        let force = sum(&model.constant) + harmonics.chain(records).sum::<f64>();
        let [mass, stiffness] = [&model.mass, &model.stiffness]
            .map(|matrix| matrix.iter().map(|row| greatest(row)).fold(0.0_f64, f64::max));
        let time = time.min((mass / stiffness).sqrt());
        let velocity = f64::EPSILON * 4096.0 * force * time / mass;
        let of = |x: f64| if x.is_finite() { x } else { 0.0 };
        Self { displacement: of(velocity * time), velocity: of(velocity) }
    }

    fn of(self, unit: Unit) -> f64 {
        match unit {
            Unit::Displacement => self.displacement,
            Unit::Velocity => self.velocity,
            _ => 0.0,
        }
    }
}

/// A number with what is estimated of it.
struct Estimate {
    unit: Unit,
    is_phase: bool,
    value: f64,
    error: f64,
}

/// The best answer from those with tables of more and more pieces, with its numbers rounded to their digits, and the largest relative error
/// of its displacements and velocities.
pub(super) fn extrapolated<T: Numbers>(coarsest: &T, coarse: &T, fine: &T, nothing: Nothing) -> (T, f64) {
    let values = |of: &T| -> Vec<f64> { of.clone().numbers().iter().map(|number| *number.value).collect() };
    let (b, c) = (values(coarse), values(fine));
    let agree = coarse.is_like(fine) && b.len() == c.len();
    let a = (agree && coarsest.is_like(coarse)).then(|| values(coarsest)).filter(|a| a.len() == b.len());
    let mut answer = fine.clone();
    let mut numbers = answer.numbers();
    let place = |list: &[f64], i: usize| list.get(i).copied();
    let mut estimates: Vec<Estimate> = Vec::with_capacity(c.len());
    for (i, number) in numbers.iter().enumerate() {
        let value = *number.value;
        let by = place(&b, i).map_or(0.0, |b| value - b);
        let before = a.as_deref().and_then(|a| Some(place(&b, i)? - place(a, i)?));
        let (value, error) = match (agree && !number.is_phase, before) {
            (true, Some(before)) => {
                let third = by / 3.0;
                (value + third, ((4.0 * by - before) / 3.0).abs().max(third.abs() * LEAST))
            }
            (true, None) => (value + by / 3.0, by.abs() / 3.0),
            // Lists of other events: the numbers before them are those of the same quantities.
            (false, _) => (value, by.abs()),
        };
        let (unit, is_phase) = (number.unit, number.is_phase);
        estimates.push(Estimate { unit, is_phase, value, error });
    }
    let size = |unit: Unit| {
        let same = estimates.iter().filter(|of| of.unit == unit);
        same.fold(0.0_f64, |most, of| most.max(of.value.abs()))
    };
    let units = [
        Unit::Displacement,
        Unit::Velocity,
        Unit::Acceleration,
        Unit::Force,
        Unit::Work,
        Unit::Time,
        Unit::Event,
        Unit::Plain,
    ];
    let sizes = units.map(|unit| (unit, size(unit)));
    let size = |unit: Unit| sizes.iter().find(|own| own.0 == unit).map_or(0.0, |own| own.1);
    let is_state = |unit: Unit| matches!(unit, Unit::Displacement | Unit::Velocity);
    let relative = |of: &Estimate| {
        let size = size(of.unit).max(nothing.of(of.unit));
        if of.error > 0.0 { of.error / size } else { 0.0 }
    };
    let of_state = estimates.iter().filter(|of| is_state(of.unit) && !of.is_phase);
    let shared = of_state.map(relative).filter(|x| x.is_finite()).fold(0.0, f64::max);
    let mut latest = 0.0_f64;
    for (number, of) in numbers.iter_mut().zip(&estimates) {
        let common = size(of.unit) * shared;
        let mut error = match of.unit {
            Unit::Plain => of.error,
            _ if of.is_phase || (!agree && of.unit == Unit::Event) => common,
            // What is exactly the same with all tables does not depend on them.
            _ if of.error > 0.0 => of.error.max(SHARED * common),
            _ => 0.0,
        };
        if of.unit == Unit::Event && error > 0.0 {
            latest = latest.max(of.error);
            error = if of.is_phase { error } else { latest.max(SHARED * common) };
        }
        *number.value = rounded(of.value, error);
    }
    drop(numbers);
    (answer, shared)
}

/// A bound of the motion with the finest tables as one of the answer that was extrapolated from it, where it says a digit of displacements and
/// velocities at least.
pub(super) fn told<T: Numbers>(bound: Proved, fine: &T, answer: &T) -> Option<Proved> {
    let of = |numbers: &T, unit: Unit| -> Vec<f64> {
        numbers
            .clone()
            .numbers()
            .iter()
            .filter(|number| number.unit == unit)
            .map(|number| *number.value)
            .collect()
    };
    let moved = |list: &[f64], unit: Unit| -> Option<Vec<f64>> {
        let (a, b) = (of(fine, unit), of(answer, unit));
        let by = a.iter().zip(&b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let size = b.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let list: Vec<f64> = list.iter().map(|x| x + by).collect();
        list.iter().all(|x| *x <= USEFUL * size).then_some(list)
    };
    let displacement = moved(&bound.displacement, Unit::Displacement)?;
    let velocity = moved(&bound.velocity, Unit::Velocity)?;
    Some(Proved { displacement, velocity })
}

/// The same of a steady motion.
pub(super) fn told_of_steady(
    bound: ProvedSteady,
    fine: &Motion<f64>,
    answer: &Motion<f64>,
) -> Option<ProvedSteady> {
    let half = |of: &Motion<f64>| -> Vec<f64> {
        of.max_displacement.iter().zip(&of.min_displacement).map(|(a, b)| (a - b) / 2.0).collect()
    };
    let own = half(answer);
    let pairs = half(fine).into_iter().zip(&own).zip(&bound.half_range);
    let half_range: Vec<f64> = pairs.map(|((fine, own), x)| x + (fine - own).abs()).collect();
    let size = own.iter().copied().fold(0.0, f64::max);
    half_range.iter().all(|x| *x <= USEFUL * size).then_some(ProvedSteady { half_range, ..bound })
}

/// A number to the last digit whose unit is at least eight times its estimated error: of 500 random machines some had four times the estimate.
fn rounded(x: f64, error: f64) -> f64 {
    if !(error > 0.0 && error.is_finite() && x.is_finite()) {
        return x;
    }
    let last = (8.0 * error).log10().ceil();
    let found = if last > 0.0 {
        let unit = 10.0_f64.powf(last);
        (x / unit).round() * unit
    } else {
        format!("{x:.*}", (-last).min(300.0) as usize).parse().unwrap_or(x)
    };
    // No negative zero.
    found + 0.0
}

#[cfg(test)]
mod tests {
    use super::rounded;

    #[test]
    fn numbers_have_the_digits_of_their_errors() {
        for (x, error, due) in [
            (1.768_518, 1e-6, 1.768_52),
            (1.768_518, 1.2e-6, 1.768_52),
            (1.768_518, 1.3e-6, 1.7685),
            (1_234.5, 6.0, 1200.0),
            (-0.000_4, 1e-2, 0.0),
            (3.0, 0.0, 3.0),
        ] {
            let found = rounded(x, error);
            assert!(found == due && found.is_sign_positive() == (found >= 0.0), "{x} {error}: {found}");
            assert!((found - x).abs() + error <= 2.0 * error.max(1e-300) * 10.0, "{x}");
        }
    }
}
