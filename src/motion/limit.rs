//! The limit of a motion from one start: which of the searches finds it.
//!
//! | file | content |
//! |---|---|
//! | `long_run`, `steady`, `irregular`, `measures`, `peaks`, `amplitude`, `steady_outputs`, `observed` | the results: what the motion tends to, what a cycle of it amounts to, its regime |
//! | `propagation`, `matrix` | the motion part by part; m half turns of it with their derivative |
//! | `fixed_point`, `orbit` | the states that m half turns bring back, and Newton's method for them |
//! | `shooting`, `section` | η = 1: the limit of every start, by Newton's method from one of them |
//! | `stop_map`, `stops` | from stop to stop, one number on: the limit where it sticks |
//! | `slight` | the same just above α = 1, where it hardly moves |
//! | `validate` | the closed-form cycle, if there is one, shown to be that fixed point |
//! | `family`, `rest` | limits that are not unique: Ω = 1/(2n), α ≤ 1 |
//! | `followed` | the limit of one start, where η > 1 |

#[cfg(test)]
pub(crate) mod accounts;
pub(crate) mod amplitude;
pub(crate) mod family;
pub(crate) mod fixed_point;
pub(crate) mod followed;
pub(crate) mod irregular;
pub(crate) mod long_run;
pub(crate) mod matrix;
pub(crate) mod measures;
pub(crate) mod observed;
pub(crate) mod orbit;
pub(crate) mod peaks;
pub(crate) mod propagation;
pub(crate) mod rest;
pub(crate) mod section;
pub(crate) mod shooting;
mod slight;
pub(crate) mod steady;
pub(crate) mod steady_outputs;
pub(crate) mod stop_map;
pub(crate) mod stops;
pub(crate) mod validate;

use super::broken::Budget;
use super::slide::equation::Equation;
use super::state::State;
use super::trajectory::resolved;
use crate::cycle::{Cycle, SixReversals};
use crate::float::Float;
use crate::machine::error::Error;
use crate::machine::ratios::Ratios;
use core::ops::ControlFlow;
use long_run::{DEFAULT_BUDGET, LongRun, growth_at_resonance};
use rest::come_to_rest;
use section::{cycle_guess, fastest_point, on_six_reversals, settle_in};
use shooting::{Guess, shoot};
use stops::Sticking;
use validate::validated;

impl<F: Float> LongRun<F> {
    /// The limit of the motion at (Ω, α) from a start.
    ///
    /// With η = 1 the limit is the same from every start, except for a family and for rest. A motion with
    /// stops is found from stop to stop, and a motion without stops from its closed form. Neither search
    /// follows the motion from this start: half a turn of the motion shows that the result is the limit.
    ///
    /// With η > 1 the result holds for this start: a periodic motion of up to 64 turns of the drive (127, if
    /// it is symmetric), rest, or an irregular motion.
    ///
    /// # Errors
    /// As for [`super::Trajectory::new`].
    pub fn from_start(ratios: Ratios<F>, start: State<F>) -> Result<Self, Error> {
        Self::budgeted(ratios, start, Budget::of(2 * u64::from(DEFAULT_BUDGET)))
    }

    /// The limit of the motion at (Ω, α) from a start, within at most `periods` periods of the drive, as long
    /// as `keep_going` returns [`ControlFlow::Continue`]. `keep_going` is called at every slide and stop,
    /// each of which takes about a microsecond at f64.
    ///
    /// ```
    /// use std::ops::ControlFlow;
    /// use stickslip::motion::{LongRun, State};
    /// use stickslip::{Error, Ratios};
    /// let mut slides = 0;
    /// let mut few = || { slides += 1; if slides < 1000 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) } };
    /// let limit = LongRun::within(Ratios::new(1e-5f64, 2.0)?, State::default(), 100, &mut few);
    /// assert_eq!(limit, Err(Error::Interrupted));
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Interrupted`] where `keep_going` ends the search, and as for [`super::Trajectory::new`].
    pub fn within(
        ratios: Ratios<F>,
        start: State<F>,
        periods: u32,
        keep_going: &mut dyn FnMut() -> ControlFlow<()>,
    ) -> Result<Self, Error> {
        Self::budgeted(ratios, start, Budget::of(2 * u64::from(periods)).while_allowed(keep_going))
    }

    fn budgeted(ratios: Ratios<F>, start: State<F>, mut budget: Budget<'_>) -> Result<Self, Error> {
        let ratios = resolved(ratios)?;
        if ratios.alpha() <= F::int(1) {
            return come_to_rest(ratios, start, &mut budget);
        }
        if ratios.has_higher_static_friction() {
            return followed::limit(ratios, start, &mut budget);
        }
        if let Some(growth) = growth_at_resonance(&ratios) {
            return Ok(Self::Unbounded { growth });
        }
        let equation = Equation::new(ratios);
        if family::is_one(ratios) {
            let (section, hint) = settle_in(equation, start, &mut budget)?;
            return family::member(equation, section, hint, &mut budget);
        }
        let sticking = Sticking::new(equation);
        let is_known = sticking.is_below || sticking.rising.is_some();
        let cycle = if is_known { None } else { Cycle::find(ratios) };
        let damped = sticking.rising.map(|rising| (rising.max_displacement, rising.displacement_phase()));
        let undamped = cycle.as_ref().map(|cycle| (cycle.max_displacement, cycle.displacement_phase));
        if let Some(turn) = damped.or(undamped) {
            return of_closed_form(ratios, turn, cycle.as_ref(), &mut budget);
        }
        if let Some(limit) = sticking.limit(&mut budget)? {
            return Ok(limit);
        }
        let (section, hint) = settle_in(equation, start, &mut budget)?;
        // Below the border the motion has six reversals or stops, and its limit is that of the motion from
        // rest.
        let guess = || {
            let (at, hint) = match SixReversals::new(ratios) {
                Some(cycle) => on_six_reversals(equation, &cycle),
                None => settle_in(equation, State::default(), &mut Budget::of(0))?,
            };
            Ok(Some(Guess { at, hint, is_limit: false }))
        };
        Ok(shoot(equation, section, hint, guess, &mut budget)?)
    }
}

/// The exact motion of a non-sticking cycle. It is validated where the closed forms hold, by half a cycle of
/// the motion itself. The cycle proves that the motion is nowhere faster than at ω_d t₁.
///
/// Errors are those of [`crate::motion::Trajectory::new`].
impl<F: Float> TryFrom<&Cycle<F>> for LongRun<F> {
    type Error = Error;

    fn try_from(cycle: &Cycle<F>) -> Result<Self, Error> {
        let ratios = resolved(cycle.ratios)?;
        let budget = &mut Budget::of(2 * u64::from(DEFAULT_BUDGET));
        if family::is_one(ratios) {
            let equation = Equation::new(ratios);
            let (section, hint) = fastest_point(equation, cycle);
            return family::member(equation, section, hint, budget);
        }
        let turn = (cycle.max_displacement, cycle.displacement_phase);
        of_closed_form(ratios, turn, (!ratios.is_damped()).then_some(cycle), budget)
    }
}

/// The exact motion of a cycle without stops that is no member of a family, from its maximum displacement and the
/// phase of it. `cycle` is the cycle without damping.
#[inline(always)]
fn of_closed_form<F: Float>(
    ratios: Ratios<F>,
    turn: (F, F),
    cycle: Option<&Cycle<F>>,
    budget: &mut Budget<'_>,
) -> Result<LongRun<F>, Error> {
    let equation = Equation::new(ratios);
    let (section, hint) = match validated(equation, turn, cycle) {
        Ok(steady) => return Ok(LongRun::Periodic(steady)),
        Err(section) => section,
    };
    if ratios.has_higher_static_friction() {
        return followed::limit(ratios, section.state(equation.omega), budget);
    }
    let guess = || Ok(cycle.map(|cycle| cycle_guess(equation, cycle)));
    Ok(shoot(equation, section, hint, guess, budget)?)
}

#[cfg(test)]
mod tests {
    use super::{Budget, Equation, settle_in, shoot};
    use crate::motion::{LongRun, State};
    use crate::{Border, Ratios};

    /// With damping and without stops, the closed form gives the limit of the motion from rest, which is
    /// computed without it.
    #[test]
    fn a_damped_cycle_is_what_the_motion_from_rest_leads_to() {
        let mut validated = 0u32;
        for i in 0..300u32 {
            let spread = |step: f64| (f64::from(i) * step).fract();
            let omega = 10f64.powf(2.3 * spread(0.618_034) - 1.1);
            let zeta = 10f64.powf(3.0 * spread(0.437_016) - 2.5);
            let least = Border::of(&Ratios::of_machine(omega, zeta).unwrap()).min_force_ratio;
            let ratios = Ratios::new(omega, least * (1.001 + 3.0 * spread(0.754_878))).unwrap();
            let ratios = ratios.with_damping_ratio(zeta).unwrap();
            let here = LongRun::from_start(ratios, State::default()).unwrap();
            let here = here.steady_state().unwrap_or_else(|| panic!("{ratios:?}"));
            validated += u32::from(here.periods == 0.5);
            let equation = Equation::new(ratios);
            let (at, hint) = settle_in(equation, State::default(), &mut Budget::of(0)).unwrap();
            let there = shoot(equation, at, hint, || Ok(None), &mut Budget::of(2000)).unwrap();
            let there = there.steady_state().unwrap_or_else(|| panic!("{ratios:?}: {there:?}"));
            let size = 1.0 + here.max_displacement.value + here.max_velocity.value * omega;
            let off = |s: &crate::motion::SteadyState<f64>| s.distance.0 + s.distance.1 * omega;
            let room = off(here) + off(there) + 64.0 * f64::EPSILON * size * (1.0 + 1.0 / omega);
            for (a, b) in [
                (here.max_displacement.value, there.max_displacement.value),
                (here.min_displacement.value, there.min_displacement.value),
                (here.max_velocity.value * omega, there.max_velocity.value * omega),
            ] {
                assert!((a - b).abs() <= room, "{ratios:?}: {a} {b} {room:e}");
            }
            assert!(here.periods <= 1.0, "{ratios:?}: {}", here.periods);
            assert_eq!((here.sticks_per_cycle, there.sticks_per_cycle), (0, 0), "{ratios:?}");
            assert_eq!(here.velocity_zeros_per_cycle, 2, "{ratios:?}");
        }
        // The rest is off by little more than the rounding of a residual, and Newton's method takes a step.
        assert!(validated > 285, "{validated} of 300");
    }

    /// The number of periods computed over a grid of ratios and starts; a useless step on the way to the
    /// limit increases it.
    #[test]
    fn the_way_to_the_limit_is_short() {
        let (mut periods, mut most) = (0.0, 0.0f64);
        for i in 0..400u32 {
            let spread = |step: f64| (f64::from(i) * step).fract();
            let omega = 10f64.powf(2.0 * spread(0.618_034) - 1.3);
            let alpha = 1.05 + 2.0 * spread(0.754_878) * Border::new(omega).unwrap().min_force_ratio;
            let ratios = Ratios::new(omega, alpha).unwrap();
            let far = State::new(7.0 * spread(0.569_840), 3.0 * alpha, -2.0 * alpha / omega).unwrap();
            for start in [State::default(), far] {
                let limit = LongRun::from_start(ratios, start).unwrap();
                let Some(steady) = limit.steady_state() else { panic!("{omega} {alpha} {limit:?}") };
                (periods, most) = (periods + steady.periods, most.max(steady.periods));
            }
        }
        // The mean is 1.52 periods per start.
        assert!(periods <= 1220.0 && most <= 44.0, "{periods} {most}");
    }
}
