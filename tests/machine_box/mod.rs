//! A box of machines, for tests that give its values in a row.

use stickslip::Excitation;
use stickslip::uncertainty::{Interval, ParameterBox, Parameters};

/// The machines of m, k, r_y, the amplitude, ω_d and c.
pub(crate) fn machine(excitation: Excitation, intervals: [Interval<f64>; 6]) -> ParameterBox<f64> {
    let [mass, stiffness, friction_bound, amplitude, angular_frequency, damping] = intervals;
    ParameterBox::Machine(Parameters {
        excitation,
        mass,
        stiffness,
        friction_bound,
        amplitude,
        angular_frequency,
        damping,
    })
}
