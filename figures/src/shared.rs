//! What several figures show: points of the closed forms and of the motion, and the axis of Ω.

use stickslip::motion::{LongRun, State, SteadyState};
use stickslip::{Cycle, Error, Ratios};
use stickslip_draw::Axis;

/// An axis of Ω from `low` to `high`.
pub(crate) fn of_frequency_ratio(low: f64, high: f64) -> Axis {
    Axis::linear("frequency ratio Ω = ω_d/ω_n", low, high)
}

/// `count` numbers from `low` to `high`, both included.
pub(crate) fn evenly(low: f64, high: f64, count: u32) -> impl Iterator<Item = f64> + Clone {
    let last = f64::from(count.max(2) - 1);
    (0..count).map(move |i| low + (high - low) * f64::from(i) / last)
}

/// A value of the closed-form cycle; NaN where it would stick.
pub(crate) fn of_cycle(omega: f64, alpha: f64, value: fn(&Cycle<f64>) -> f64) -> f64 {
    Ratios::new(omega, alpha).and_then(Cycle::new).as_ref().map_or(f64::NAN, value)
}

/// The limit of the motion from rest.
pub(crate) fn from_rest(omega: f64, alpha: f64) -> Result<LongRun<f64>, Error> {
    Ratios::new(omega, alpha).and_then(|ratios| LongRun::from_start(ratios, State::default()))
}

/// The steady state that the motion from rest reaches.
pub(crate) fn settled(omega: f64, alpha: f64) -> Option<SteadyState<f64>> {
    from_rest(omega, alpha).ok()?.steady_state().copied()
}

/// The values of 1/α in the paper's figures 4 to 7, with their names and places in the palette.
pub(crate) fn inverse_force_ratios(greatest: u32) -> impl Iterator<Item = (usize, f64, String)> {
    (1..=greatest).map(|tenth| {
        let inverse = f64::from(tenth) / 10.0;
        (tenth as usize - 1, 1.0 / inverse, format!("1/α = {inverse}"))
    })
}
