//! The kernels of the exact motion.

use stickslip::motion::{LongRun, State, Trajectory};
use stickslip::{Cycle, Ratios};

/// The results by which steady states are compared.
fn answer(motion: &LongRun<f64>) -> [f64; 4] {
    match motion.steady_state() {
        Some(s) => [
            s.max_displacement.value,
            s.max_velocity.value,
            s.max_displacement.phase.reduced(),
            s.max_velocity.phase.reduced(),
        ],
        None => [f64::NAN; 4],
    }
}

/// The exact steady state from rest.
#[inline(never)]
pub(crate) fn steady_from_rest(omega: f64, alpha: f64) -> [f64; 4] {
    match Ratios::new(omega, alpha).and_then(|r| LongRun::from_start(r, State::default())) {
        Ok(motion) => answer(&motion),
        Err(_) => [f64::NAN; 4],
    }
}

/// The exact steady state from rest with the damping ratio ζ.
#[inline(never)]
pub(crate) fn steady_with_damping(omega: f64, alpha: f64, zeta: f64) -> [f64; 4] {
    let ratios = Ratios::new(omega, alpha).and_then(|r| r.with_damping_ratio(zeta));
    match ratios.and_then(|r| LongRun::from_start(r, State::default())) {
        Ok(motion) => answer(&motion),
        Err(_) => [f64::NAN; 4],
    }
}

/// The exact steady state from the closed-form cycle.
#[inline(never)]
pub(crate) fn steady_from_cycle(cycle: &Cycle<f64>) -> [f64; 4] {
    LongRun::try_from(cycle).map_or([f64::NAN; 4], |motion| answer(&motion))
}

/// Twenty slides from rest, which are ten periods if the motion does not stop.
#[inline(never)]
pub(crate) fn twenty_slides(omega: f64, alpha: f64) -> [f64; 1] {
    match Ratios::new(omega, alpha).and_then(|r| Trajectory::new(r, State::default())) {
        Ok(motion) => [motion.filter_map(|p| p.ok()?.end()).take(20).map(|end| end.x).sum()],
        Err(_) => [f64::NAN],
    }
}
