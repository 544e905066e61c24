//! Answers of a body without friction or without a spring, which are computed with one far below rounding.

use stickslip::float::Float;
use stickslip::{Definition, Measure, Output};

/// Whether a value is in units of the friction, which do not exist without it.
#[must_use]
pub const fn is_of_friction(measure: Measure) -> bool {
    use Measure::{Acceleration, EnergyOfLargestLoop, Force, ForceRatio, Length, Velocity, Work};
    matches!(measure, Length | Velocity | Acceleration | Force | ForceRatio | Work | EnergyOfLargestLoop)
}

/// A value of a body without friction, computed with a friction of ε² of the drive: 0 where it is a multiple of the
/// friction. A motion of the drive's own size is ε⁻² in units of the friction, and its work ε⁻⁴.
#[must_use]
pub fn without_friction<F: Float>(measure: Measure, x: F) -> F {
    let size = F::int(1) / F::epsilon();
    let of_motion = [Measure::Length, Measure::Velocity, Measure::Acceleration, Measure::Force];
    let of_friction =
        [Measure::ForceRatio, Measure::EnergyStiffness, Measure::EnergyInertia, Measure::EnergyOfLargestLoop];
    let is_multiple = of_friction.contains(&measure)
        || of_motion.contains(&measure) && x.abs() < size
        || measure == Measure::Work && x.abs() < size.square() * size;
    if is_multiple { F::int(0) } else { x }
}

/// Whether a value is in units of the spring, k, B = r_y/k or ω_n, which do not exist without it.
#[must_use]
pub const fn is_of_spring(measure: Measure) -> bool {
    use Measure::{
        Acceleration, Damping, EnergyOfLargestLoop, EnergyStiffness, Length, Stiffness, Velocity, Work,
    };
    matches!(
        measure,
        Length | Velocity | Acceleration | Stiffness | Damping | Work | EnergyStiffness | EnergyOfLargestLoop
    )
}

/// Whether an output does not exist without a spring, in any unit: its force, and ratios to its stiffness.
#[must_use]
pub fn needs_spring(output: &Definition) -> bool {
    let those = [Output::MaxSpringForce, Output::DynamicAmplification, Output::EquivalentDampingRatio];
    those.into_iter().any(|one| one.definition().name == output.name)
}
