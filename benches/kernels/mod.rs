//! The library's side of the comparison, one function a kernel.

use stickslip::Ratios;
use stickslip::exact::{LongRun, State, SteadyState, Trajectory};
use stickslip::nonsticking::{Cycle, loop_size_stiffness, max_displacement, turning_point_border};
use stickslip::phase_function::{PhaseFunction, one_minus_square};

/// {Δ₀, eq. 61, A₁}
#[inline]
pub(crate) fn triple(omega: f64, alpha: f64) -> [f64; 3] {
    let Ok(p) = PhaseFunction::new(omega) else { return [f64::NAN; 3] };
    let k = p.value();
    let delta = max_displacement(k, alpha, one_minus_square(omega));
    [delta, turning_point_border(k, omega), loop_size_stiffness(delta, alpha)]
}

/// {Δ₀, t₂, V₀, t₁, Δ₁, contraction} of a checked [`Cycle`].
#[inline]
pub(crate) fn cycle(omega: f64, alpha: f64) -> [f64; 6] {
    match Ratios::new(omega, alpha).and_then(Cycle::new) {
        Ok(c) => [
            c.max_displacement(),
            c.displacement_phase(),
            c.max_velocity(),
            c.velocity_phase(),
            c.deviation(),
            c.contraction(),
        ],
        Err(_) => [f64::NAN; 6],
    }
}

/// What a steady state is compared by.
fn answer(motion: &LongRun<f64>) -> [f64; 4] {
    match motion.steady_state() {
        Some(s) => {
            [s.max_displacement(), s.max_velocity(), s.max_displacement_phase(), s.max_velocity_phase()]
        }
        None => [f64::NAN; 4],
    }
}

/// The exact steady state from rest.
#[inline]
pub(crate) fn steady_from_rest(omega: f64, alpha: f64) -> [f64; 4] {
    match Ratios::new(omega, alpha).and_then(|r| LongRun::from_start(r, State::rest())) {
        Ok(motion) => answer(&motion),
        Err(_) => [f64::NAN; 4],
    }
}

/// The exact steady state from the closed-form cycle.
#[inline]
pub(crate) fn steady_from_cycle(cycle: &Cycle<f64>) -> [f64; 4] {
    SteadyState::from_cycle(cycle).map_or([f64::NAN; 4], |motion| answer(&motion))
}

/// Twenty slides from rest: ten periods where the motion does not stop.
#[inline]
pub(crate) fn twenty_slides(omega: f64, alpha: f64) -> [f64; 1] {
    match Ratios::new(omega, alpha).and_then(|r| Trajectory::new(r, State::rest())) {
        Ok(motion) => [motion.filter_map(|p| p.end()).take(20).map(|end| end.x).sum()],
        Err(_) => [f64::NAN],
    }
}
