//! The numbers of a steady state as one table.

use super::SteadyState;
use crate::float::Float;

/// Name and value of an output.
type Output<F> = (&'static str, fn(&SteadyState<F>) -> F);

impl<F: Float> SteadyState<F> {
    /// Name and value of each output that is a number of its type; units and accuracy are those of the
    /// function of that name.
    ///
    /// ```
    /// use stickslip::{Ratios, exact::{LongRun, State, SteadyState}};
    /// let limit = LongRun::from_start(Ratios::new(0.4, 6.0)?, State::rest())?;
    /// let steady = limit.steady_state().ok_or("none")?;
    /// let (name, max_displacement) = SteadyState::<f64>::OUTPUTS[0];
    /// assert_eq!((name, max_displacement(steady)), ("max_displacement", steady.max_displacement()));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub const OUTPUTS: [Output<F>; 14] = [
        ("max_displacement", |s| s.max_displacement()),
        ("max_displacement_phase", |s| s.max_displacement_phase()),
        ("min_displacement", |s| s.min_displacement()),
        ("min_displacement_phase", |s| s.min_displacement_phase()),
        ("max_velocity", |s| s.max_velocity()),
        ("max_velocity_phase", |s| s.max_velocity_phase()),
        ("min_velocity", |s| s.min_velocity()),
        ("min_velocity_phase", |s| s.min_velocity_phase()),
        ("stick_fraction", |s| s.stick_fraction()),
        ("energy_in", |s| s.energy_in()),
        ("energy_out", |s| s.energy_out()),
        ("damper_work", |s| s.damper_work()),
        ("contraction", |s| s.contraction()),
        ("distance", |s| s.distance().0),
    ];
}
