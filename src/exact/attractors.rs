//! All limits that a set of starts leads to.
//!
//! With a static friction above the kinetic one a machine can have several limits, and which it tends to depends on the start. Nothing here proves
//! that there are no others than those found: the answer is one about the starts that were followed.

use super::drive::DrivePhase;
use super::irregular::Irregular;
use super::long_run::LongRun;
use super::shooting::Budget;
use super::state::{Point, State};
use super::steady::SteadyState;
use super::trajectory::Trajectory;
use super::walk::follow;
use crate::error::Error;
use crate::float::Float;
use crate::ratios::Ratios;

/// A limit, and how many starts lead to it.
#[derive(Debug, Clone, PartialEq)]
pub struct Attractor<F> {
    limit: LongRun<F>,
    first_start: usize,
    starts: u64,
    mirror: Option<usize>,
    range: Option<(F, F)>,
    /// The states of a periodic motion at the phases nπ, upside down at the odd ones.
    orbit: Vec<Point<F>>,
}

impl<F: Float> Attractor<F> {
    /// The limit, as the first of its starts led to it.
    pub const fn limit(&self) -> &LongRun<F> {
        &self.limit
    }

    /// The first of its starts, by its place in the list.
    pub const fn first_start(&self) -> usize {
        self.first_start
    }

    /// How many of the starts lead to it.
    pub const fn starts(&self) -> u64 {
        self.starts
    }

    /// The limit that is this one turned upside down, by its place among those found; `None` where it is symmetric, and where no start
    /// led to that one.
    pub const fn mirror(&self) -> Option<usize> {
        self.mirror
    }

    /// From the least to the greatest place of rest x/B, or middle of a member of a family, that was found; `None` for all other limits.
    pub const fn range(&self) -> Option<(F, F)> {
        self.range
    }
}

/// The limits of a set of starts, each once, in the order of their first starts.
#[derive(Debug, Clone, PartialEq)]
pub struct Attractors<F> {
    found: Vec<Attractor<F>>,
    of_start: Vec<Option<usize>>,
}

/// The limits that the motion at (Ω, α, ζ, η) tends to from each of the starts, each followed for at most `periods` periods of the drive.
///
/// ```
/// use stickslip::Ratios;
/// use stickslip::exact::{State, attractors};
/// let ratios = Ratios::new(0.5f64, 4.0)?.with_damping_ratio(0.02)?.with_static_friction_ratio(1.3)?;
/// let starts = [(0.0, 0.0), (3.0, 0.0), (-3.0, 1.0)].map(|(x, v)| State::new(0.0, x, v));
/// let starts: Vec<_> = starts.into_iter().collect::<Result<_, _>>()?;
/// let found = attractors(ratios, &starts, 1000)?;
/// // A motion and its mirror image, one stop in each cycle.
/// assert_eq!(found.limits().len(), 2);
/// assert_eq!((found.limits()[0].mirror(), found.limits()[1].mirror()), (Some(1), Some(0)));
/// # Ok::<(), stickslip::Error>(())
/// ```
///
/// # Errors
/// As for [`Trajectory::new`].
pub fn attractors<F: Float>(
    ratios: Ratios<F>,
    starts: &[State<F>],
    periods: u32,
) -> Result<Attractors<F>, Error> {
    let limits: Result<Vec<_>, _> =
        starts.iter().map(|start| LongRun::within(ratios, *start, periods)).collect();
    Attractors::of_limits(limits?)
}

impl<F: Float> Attractors<F> {
    /// The limits among those of several starts, in their order: for starts that were followed elsewhere, such as on several threads. The
    /// answer does not depend on how.
    ///
    /// * Periodic motions are one where they come to the same states, to 2⁻²⁰ of their size.
    /// * Places of rest are one limit, and so are the members of a family, with the range that was found.
    /// * Irregular motions are one where their extrema agree to 1/32 of their range.
    ///
    /// # Errors
    /// As for [`Trajectory::new`].
    pub fn of_limits(limits: impl IntoIterator<Item = LongRun<F>>) -> Result<Self, Error> {
        let mut all = Self { found: Vec::new(), of_start: Vec::new() };
        for limit in limits {
            let place = all.add(limit)?;
            all.of_start.push(place);
        }
        Ok(all)
    }

    /// The limits.
    pub fn limits(&self) -> &[Attractor<F>] {
        &self.found
    }

    /// The limit of a start, by its place among those found; `None` where that start had not settled.
    pub fn of_start(&self, start: usize) -> Option<usize> {
        self.of_start.get(start).copied().flatten()
    }

    /// How many starts there were.
    pub const fn starts(&self) -> usize {
        self.of_start.len()
    }

    /// How many of them had not settled.
    pub fn unsettled(&self) -> usize {
        self.of_start.iter().filter(|place| place.is_none()).count()
    }

    /// Counts a limit in, and says which it is.
    fn add(&mut self, limit: LongRun<F>) -> Result<Option<usize>, Error> {
        let state = match &limit {
            LongRun::NotConverged { .. } => return Ok(None),
            LongRun::Periodic(steady) => Some(at_zero(steady)?),
            LongRun::Family(_) | LongRun::Rest(_) | LongRun::Irregular(_) | LongRun::Unbounded { .. } => None,
        };
        let mut mirror = None;
        for (place, known) in self.found.iter_mut().enumerate() {
            match known.compare(&limit, state.as_ref()) {
                Likeness::Same => {
                    known.starts = known.starts.saturating_add(1);
                    known.widen(&limit);
                    return Ok(Some(place));
                }
                Likeness::Mirrored => mirror = Some(place),
                Likeness::Other => {}
            }
        }
        let place = self.found.len();
        let orbit = match (&limit, state) {
            (LongRun::Periodic(steady), Some(state)) => orbit(steady, state)?,
            _ => Vec::new(),
        };
        if let Some(other) = mirror.and_then(|other| self.found.get_mut(other)) {
            other.mirror = Some(place);
        }
        let range = middle(&limit).map(|x| (x, x));
        let first_start = self.of_start.len();
        self.found.push(Attractor { limit, first_start, starts: 1, mirror, range, orbit });
        Ok(Some(place))
    }
}

/// How one limit is like another.
enum Likeness {
    Same,
    Mirrored,
    Other,
}

impl<F: Float> Attractor<F> {
    /// How it is like a limit; of a periodic one `state` is the state at a phase nπ, upside down at an odd one.
    fn compare(&self, limit: &LongRun<F>, state: Option<&Point<F>>) -> Likeness {
        match (&self.limit, limit, state) {
            (LongRun::Periodic(own), LongRun::Periodic(other), Some(state)) => {
                if own.half_turns != other.half_turns {
                    return Likeness::Other;
                }
                let size = F::int(1) + state.x.abs() + state.w.abs();
                let is_here = |p: &Point<F>| (p.x - state.x).hypot(p.w - state.w) <= F::exp2i(-20) * size;
                match self.orbit.iter().position(is_here) {
                    // Every second state of a motion that is not symmetric is on its mirror image.
                    Some(place) if own.is_symmetric() || place % 2 == 0 => Likeness::Same,
                    Some(_) => Likeness::Mirrored,
                    None => Likeness::Other,
                }
            }
            (LongRun::Irregular(own), LongRun::Irregular(other), _) => alike(own, other),
            (LongRun::Family(_), LongRun::Family(_), _)
            | (LongRun::Rest(_), LongRun::Rest(_), _)
            | (LongRun::Unbounded { .. }, LongRun::Unbounded { .. }, _) => Likeness::Same,
            _ => Likeness::Other,
        }
    }

    /// Takes the place of a limit into the range.
    fn widen(&mut self, limit: &LongRun<F>) {
        if let (Some((low, high)), Some(x)) = (self.range, middle(limit)) {
            self.range = Some((if x < low { x } else { low }, high.or_larger(x)));
        }
    }
}

/// The place of rest, or the middle of a member of a family.
fn middle<F: Float>(limit: &LongRun<F>) -> Option<F> {
    match limit {
        LongRun::Rest(rest) => Some(rest.position),
        LongRun::Family(member) => Some((member.max_displacement() + member.min_displacement()) / F::int(2)),
        LongRun::Periodic(_)
        | LongRun::Irregular(_)
        | LongRun::Unbounded { .. }
        | LongRun::NotConverged { .. } => None,
    }
}

fn alike<F: Float>(own: &Irregular<F>, other: &Irregular<F>) -> Likeness {
    let (most, least) = (own.max_displacement(), own.min_displacement());
    let room = (most - least) / F::int(32);
    let is_near = |a: F, b: F| (a - b).abs() <= room;
    if is_near(most, other.max_displacement()) && is_near(least, other.min_displacement()) {
        Likeness::Same
    } else if is_near(most, -other.min_displacement()) && is_near(least, -other.max_displacement()) {
        Likeness::Mirrored
    } else {
        Likeness::Other
    }
}

/// The state of a periodic motion at the next phase nπ, upside down where n is odd.
fn at_zero<F: Float>(steady: &SteadyState<F>) -> Result<Point<F>, Error> {
    let (start, zero) = (steady.state(), F::int(0));
    let upright = |phase: DrivePhase<F>, x: F, w: F| {
        let origin = DrivePhase::of_half_turn(0, zero);
        if phase.is_even() { Point { phase: origin, x, w } } else { Point { phase: origin, x: -x, w: -w } }
    };
    let angle = start.phase.angle();
    if angle == zero {
        return Ok(upright(start.phase, start.x, steady.start.w));
    }
    let later = i64::from(angle > zero);
    let target = DrivePhase::of_half_turn(start.phase.half_turns(), zero).later_by_half_turns(later);
    for phase in Trajectory::of(steady.equation, start) {
        let phase = phase?;
        if phase.end().is_none_or(|end| target.since(end.phase) <= zero) {
            let state = phase.at(target).state;
            return Ok(upright(target, state.x, state.v * steady.equation.omega));
        }
    }
    Ok(upright(target, start.x, zero))
}

/// The states of a cycle at the phases nπ, upside down at the odd ones, from the one given on.
fn orbit<F: Float>(steady: &SteadyState<F>, from: Point<F>) -> Result<Vec<Point<F>>, Error> {
    let (equation, mut y) = (steady.equation, from);
    let usual = F::pi() / equation.omega;
    let mut states = Vec::new();
    for _ in 0..steady.half_turns {
        states.push(y);
        let (end, _) = follow(equation, y, 1, usual, &mut Budget::of(0), |_| Ok(()))?;
        y = Point { phase: y.phase, x: -end.x, w: -end.w };
    }
    Ok(states)
}

#[cfg(test)]
mod tests {
    use super::attractors;
    use crate::Ratios;
    use crate::exact::{LongRun, State};

    fn starts(count: u32, reach: f64) -> Vec<State<f64>> {
        let part = |i: u32, step: f64| reach * (2.0 * (f64::from(i) * step).fract() - 1.0);
        (0..count).map(|i| State::new(0.0, part(i, 0.754_878), part(i, 0.569_841)).unwrap()).collect()
    }

    fn ratios(omega: f64, zeta: f64, eta: f64, alpha: f64) -> Ratios<f64> {
        let ratios = Ratios::new(omega, alpha).unwrap().with_damping_ratio(zeta).unwrap();
        ratios.with_static_friction_ratio(eta).unwrap()
    }

    /// Greatest and least displacement, stops, turns, symmetry and mirror image of each limit, by the greatest displacement.
    type Found = (f64, f64, u32, u32, bool, bool);

    fn found(ratios: Ratios<f64>, count: u32) -> Vec<Found> {
        let all = attractors(ratios, &starts(count, 10.0), 1000).unwrap();
        assert_eq!(all.unsettled(), 0);
        assert_eq!(all.limits().iter().map(super::Attractor::starts).sum::<u64>(), u64::from(count));
        let mut found: Vec<_> = all
            .limits()
            .iter()
            .map(|limit| {
                let LongRun::Periodic(s) = limit.limit() else { panic!("{limit:?}") };
                if let Some(mirror) = limit.mirror() {
                    let other = all.limits()[mirror].limit().steady_state().unwrap();
                    assert!((other.max_displacement() + s.min_displacement()).abs() < 1e-9);
                }
                (
                    s.max_displacement(),
                    s.min_displacement(),
                    s.sticks_per_cycle(),
                    s.turns_per_cycle(),
                    s.is_symmetric(),
                    limit.mirror().is_some(),
                )
            })
            .collect();
        found.sort_by(|a, b| b.0.total_cmp(&a.0));
        found
    }

    fn same(found: &[Found], expected: &[Found]) {
        let is = |a: &Found, b: &Found| {
            let close = (a.0 - b.0).abs() < 1e-6 && (a.1 - b.1).abs() < 1e-6;
            close && (a.2, a.3, a.4, a.5) == (b.2, b.3, b.4, b.5)
        };
        let all = found.len() == expected.len() && found.iter().zip(expected).all(|(a, b)| is(a, b));
        assert!(all, "{found:#?} for {expected:#?}");
    }

    /// The five regular cases of an independent simulation: every motion, and none besides.
    #[test]
    fn limits_of_an_independent_simulation() {
        let pair = |most: f64, least: f64, stops, turns| {
            let one = (most, -least, stops, turns, false, true);
            [one, (least, -most, stops, turns, false, true)]
        };
        same(&found(ratios(0.5, 0.02, 1.3, 4.0), 60), &pair(5.362_738, 5.185_938, 1, 1));
        same(&found(ratios(0.54, 0.03, 2.4, 4.2), 60), &pair(6.913_339, 5.098_781, 1, 1));
        let [high, low] = pair(6.221_430, 5.496_536, 1, 1);
        let between = (5.770_820, -5.770_820, 0, 1, true, false);
        same(&found(ratios(0.573, 0.005, 1.87, 3.92), 60), &[high, between, low]);
        let two = [(4.921_033, 4), (2.734_118, 2)].map(|(x, stops)| (x, -x, stops, 1, true, false));
        same(&found(ratios(0.1356, 0.0388, 2.7673, 4.4107), 60), &two);
        let three = found(ratios(0.428, 0.013, 2.9, 5.6), 60);
        let [high, low] = pair(8.623_030, 6.190_593, three[0].2, 3);
        same(&three, &[high, low]);
    }

    /// A start at another phase is told to lead to the same motion.
    #[test]
    fn one_limit_whatever_the_phase_of_the_start() {
        let ratios = ratios(0.5, 0.02, 1.3, 4.0);
        let starts: Vec<_> = (0..24)
            .map(|i| State::new(f64::from(i) * 0.7, 6.0 * (f64::from(i) * 0.618).sin(), 0.3).unwrap())
            .collect();
        let all = attractors(ratios, &starts, 1000).unwrap();
        assert_eq!(all.limits().len(), 2, "{:?}", all.limits());
        let of_start = |i: usize| all.of_start(i).map(|place| all.limits()[place].first_start());
        assert!((0..24).all(|i| of_start(i).is_some_and(|first| first <= i)));
    }

    /// Places of rest are one limit with their range.
    #[test]
    fn places_of_rest_are_one_limit() {
        let all = attractors(ratios(0.8, 0.02, 1.6, 1.5), &starts(40, 5.0), 1000).unwrap();
        let rest = all.limits().iter().find(|limit| matches!(limit.limit(), LongRun::Rest(_))).unwrap();
        let (low, high) = rest.range().unwrap();
        assert!(-0.1 <= low && low <= high && high <= 0.1 + 1e-12, "{low} {high}");
        assert!(all.limits().iter().any(|limit| limit.limit().steady_state().is_some()));
    }
}
