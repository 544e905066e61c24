//! The numbers of a steady state as one table.

use super::SteadyState;
use crate::float::Float;

/// Name and value of an output.
type Output<F> = (&'static str, fn(&SteadyState<F>) -> F);

impl<F: Float> SteadyState<F> {
    /// Name and value of each output that is a number of its type; units and accuracy are those of the
    /// field of that name.
    ///
    /// ```
    /// use stickslip::{Ratios, exact::{LongRun, State, SteadyState}};
    /// let limit = LongRun::from_start(Ratios::new(0.4, 6.0)?, State::default())?;
    /// let steady = limit.steady_state().ok_or("none")?;
    /// let (name, max_displacement) = SteadyState::<f64>::OUTPUTS[0];
    /// assert_eq!((name, max_displacement(steady)), ("max_displacement", steady.max_displacement.value));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub const OUTPUTS: [Output<F>; 14] = [
        ("max_displacement", |s| s.max_displacement.value),
        ("max_displacement_phase", |s| s.max_displacement.phase.reduced()),
        ("min_displacement", |s| s.min_displacement.value),
        ("min_displacement_phase", |s| s.min_displacement.phase.reduced()),
        ("max_velocity", |s| s.max_velocity.value),
        ("max_velocity_phase", |s| s.max_velocity.phase.reduced()),
        ("min_velocity", |s| s.min_velocity.value),
        ("min_velocity_phase", |s| s.min_velocity.phase.reduced()),
        ("stick_fraction", |s| s.stick_fraction),
        ("energy_in", |s| s.energy_in),
        ("energy_out", |s| s.energy_out),
        ("damper_work", |s| s.damper_work),
        ("contraction", |s| s.contraction()),
        ("distance", |s| s.distance.0),
    ];
}
