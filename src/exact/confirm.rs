//! The closed-form cycle confirmed as a motion, from one slide.
//!
//! The rising half of the cycle begins at its least displacement, `(−Δ₀, 0)` at `θ₂ − π`, and is one slide of natural length
//! `π/Ω`. Where it ends the drive has turned by π, so that its own angle needs no circular function, and the free one,
//! `π/Ω = 2β`, is the cycle's. The slide passes the section, the fastest point y at θ₁, on its way; half a turn from there goes on to
//! the velocity zero at `π/Ω + h` and back on the mirrored slide. What the latter misses −y by is free vibration,
//!
//! ```text
//! H(y) − y = −R (δx, −w′₊ h),     δx = x(π/Ω + h) − Δ₀
//! ```
//!
//! with w′₊ the acceleration after the reversal and R the rotation from θ₂ − π to θ₁: the residual that `shooting` judges, with the
//! bound on the distance that comes of it.
//!
//! # Why no velocity zero is missed
//!
//! The speed f has `f″ + f = g ∝ cos θ` (`event`). Say the half turn begins where g ≥ 0, at f = 0 with f′ > 0, and g changes
//! its sign at φ = b. Then f > 0 for `0 < φ ≤ min(b, π)`; from b, a later point, backward for `atan2(f, f′)`; and on the last
//! stretch, not longer than π, because f is positive at its beginning, and zero at its end only. For Ω ≥ 1 all of it is
//! shorter than π, and f(b) need not be looked at. In every other case the search of `velocity_zero` answers.
//!
//! That the greatest speed is the one at θ₁ is proved where the cycle finds it; here the acceleration has to vanish there.

use super::drive::DrivePhase;
use super::equation::Equation;
use super::matrix::Matrix;
use super::measures::Extreme;
use super::motion::Motion;
use super::shooting::{Residual, is_known};
use super::slide::{Direction, Slide};
use super::steady::{SteadyState, Summary};
use super::stick::force_rounding;
use super::walk::Point;
use crate::float::Float;
use crate::nonsticking::Cycle;

/// The steady state that the cycle is, where one half turn shows that it is one to within rounding.
#[inline]
pub(crate) fn confirmed<F: Float>(equation: Equation<F>, cycle: &Cycle<F>) -> Option<SteadyState<F>> {
    let (zero, two) = (F::int(0), F::int(2));
    let omega = equation.omega;
    let origin = DrivePhase::of_half_turn(0, zero);
    let least = origin.advanced(cycle.displacement_phase()).later_by_half_turns(-1);
    let slide = Slide::new(equation, least, -cycle.max_displacement(), zero, Direction::Forward);
    if slide.acceleration <= force_rounding(equation.alpha, slide.x) {
        return None;
    }
    let length = F::pi() / omega;
    let arrival = slide.after_half_turn(cycle.sin_cos_beta());
    // The velocity zero: what a step of Newton's leaves is of the order of its square.
    let h = -arrival.w / arrival.acceleration;
    let left = h.square() * arrival.jerk.abs();
    let final_step = left <= F::epsilon() / F::int(4) * length * -arrival.acceleration;
    if !final_step {
        return None;
    }
    let greatest = Extreme {
        value: arrival.x + h * arrival.w / two,
        phase: least.later_by_half_turns(1).advanced(omega * h),
    };

    let fastest = origin.advanced(cycle.velocity_phase());
    // Both phases are reduced to one turn of their own.
    let (fastest, lag) = match fastest.since(least) {
        lag if lag > F::pi() => (fastest.later_by_half_turns(-2), lag - two * F::pi()),
        lag => (fastest, lag),
    };
    let middle = slide.motion(lag / omega);
    let still = middle.acceleration.square() <= F::epsilon() * middle.w.square() && middle.w > zero;
    if !(still && slide.turns_first_at(length + h)) {
        return None;
    }

    let y = Point { phase: fastest, x: middle.x, w: middle.w };
    let (s, c) = middle.rotation;
    let (dx, dw) = (greatest.value + slide.x, slide.acceleration * h);
    let residual = Residual::new(&equation, &y, (-(c * dx + s * dw), s * dx - c * dw));
    let rest =
        (arrival.rotation.0 * c - arrival.rotation.1 * s, arrival.rotation.1 * c + arrival.rotation.0 * s);
    let monodromy = Matrix::identity()
        .after_slide(rest)
        .after_zero(-slide.acceleration / arrival.acceleration)
        .after_slide(middle.rotation);
    let inverse = monodromy.inverse_of_one_plus();
    if !(residual.is_rounding(1) && is_known(&y, inverse, &residual)) {
        return None;
    }
    let max_v = Extreme { value: middle.w / omega, phase: fastest };
    Some(SteadyState {
        equation,
        start: y,
        tally: Summary::of_reversals(
            greatest,
            max_v,
            two * slide.work_of_drive(&arrival),
            two * (greatest.value - slide.x),
        ),
        multipliers: monodromy.squared_eigenvalues(),
        distance: inverse.absolute().times(residual.bounds()),
        periods: F::ratio(1, 2),
    })
}

impl<F: Float> Slide<F> {
    /// The motion when the drive has turned by π: natural time π/Ω, by (sin β, cos β) of β = π/2Ω.
    #[inline]
    fn after_half_turn(&self, sin_cos_beta: (F, F)) -> Motion<F> {
        self.motion_of(&self.equation.half_turn(sin_cos_beta))
    }

    /// Whether the velocity of a forward slide from rest has its first zero at `end`, a zero to within rounding, half a turn later.
    #[inline]
    fn turns_first_at(&self, end: F) -> bool {
        let omega = self.equation.omega;
        let boundary = (F::pi() / F::int(2) - self.start.angle()) / omega;
        let (pi, backward) = (F::pi(), end - boundary <= F::pi());
        if self.start.is_even() && backward {
            if boundary <= pi {
                return true;
            }
            let m = self.motion(boundary);
            if m.w > F::int(0) && boundary - m.w.atan2(m.acceleration) <= pi {
                return true;
            }
        }
        self.velocity_zero(end)
            .is_some_and(|zero| !zero.grazes && (zero.phi - end).square() <= F::epsilon() * end.square())
    }
}

#[cfg(test)]
mod tests {
    use super::confirmed;
    use crate::exact::equation::Equation;
    use crate::exact::long_run::{LongRun, fastest_point};
    use crate::exact::shooting::Budget;
    use crate::nonsticking::Cycle;
    use crate::phase_function::PhaseFunction;
    use crate::{Border, Ratios};

    /// The cycle at a multiple of the border, which need not be a motion.
    fn cycle(omega: f64, times: f64) -> (Equation<f64>, Cycle<f64>) {
        let alpha = Border::new(omega).unwrap().min_force_ratio() * times;
        let ratios = Ratios::new(omega, alpha).unwrap();
        (Equation::new(ratios), Cycle::at(&PhaseFunction::new(omega).unwrap(), ratios))
    }

    #[test]
    fn it_is_what_newtons_method_finds() {
        let (mut found, mut all) = (0, 0);
        for i in 0..3000 {
            let omega = 0.13 * 1.0013f64.powi(i);
            let (equation, cycle) = cycle(omega, 1.0 + 0.003 * f64::from(1 + i % 97));
            all += 1;
            let Some(here) = confirmed(equation, &cycle) else { continue };
            found += 1;
            let (section, hint) = fastest_point(equation, &cycle);
            let budget = Budget { half_turns: 0, most: 100 };
            let LongRun::Periodic(there) = LongRun::shot(equation, section, hint, || None, budget) else {
                panic!("Ω = {omega}")
            };
            let size = 1.0 + cycle.max_displacement();
            let close = |a: f64, b: f64, units: f64| {
                assert!((a - b).abs() <= units * f64::EPSILON, "Ω = {omega}: {a} {b} {here:?} {there:?}");
            };
            let apart = |d: (f64, f64), e: (f64, f64)| (d.0 + d.1 + e.0 + e.1) / f64::EPSILON;
            let units = apart(here.distance(), there.distance()) + 8.0 * size;
            close(here.max_displacement(), there.max_displacement(), units);
            close(here.min_displacement(), there.min_displacement(), units);
            close(here.max_velocity(), there.max_velocity(), units);
            close(here.min_velocity(), there.min_velocity(), units);
            close(here.energy_out(), there.energy_out(), 4.0 * units);
            for (a, b) in [
                (here.max_displacement_phase(), there.max_displacement_phase()),
                (here.min_displacement_phase(), there.min_displacement_phase()),
                (here.max_velocity_phase(), there.max_velocity_phase()),
                (here.min_velocity_phase(), there.min_velocity_phase()),
            ] {
                close((a - b).sin(), 0.0, 8.0 + omega * units);
            }
            assert_eq!((here.sticks_per_cycle(), here.velocity_zeros_per_cycle()), (0, 2));
            assert_eq!((there.sticks_per_cycle(), there.velocity_zeros_per_cycle()), (0, 2));
            for ((a, b), (c, d)) in here.multipliers().into_iter().zip(there.multipliers()) {
                assert!((a - c).abs() < 1e-9 && (b - d).abs() < 1e-6, "Ω = {omega}: {here:?} {there:?}");
            }
        }
        assert!(found * 10 > all * 9, "{found} of {all}");
    }

    #[test]
    fn below_the_border_nothing_is_confirmed() {
        for i in 0..3000 {
            let omega = 0.13 * 1.0013f64.powi(i);
            let times = 1.0 - 1e-6 * f64::from(1 + i % 97);
            let (equation, cycle) = cycle(omega, times);
            assert_eq!(confirmed(equation, &cycle), None, "Ω = {omega}, {times} times the border");
        }
    }
}
