//! Errors in units in the last place: the outputs, their units, and the allowed errors.
//!
//! This table serves the harness (`benches/accuracy.rs`) and the test (`tests/closed_forms/accuracy.rs`).

pub(crate) mod points;
pub(crate) mod reference;
pub(crate) mod worst;

/// The quantity to which one unit in the last place refers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Unit {
    /// The output itself.
    Own,
    /// The output or 1, whichever is larger; differences modulo 2π.
    Phase,
    /// The output or V₀, whichever is larger.
    Velocity,
}

/// One output of the closed forms.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Output {
    pub(crate) name: &'static str,
    pub(crate) symbol: &'static str,
    pub(crate) unit: Unit,
    /// The required accuracy, if there is a requirement.
    pub(crate) goal: Option<f64>,
    /// The greatest error in ulp at any point of harness or test. It is infinite for the contraction, which
    /// behaves like a square root at its double root.
    pub(crate) allowed: f64,
}

const fn output(
    name: &'static str,
    symbol: &'static str,
    unit: Unit,
    goal: Option<f64>,
    allowed: f64,
) -> Output {
    Output { name, symbol, unit, goal, allowed }
}

/// Every output, in the order of [`reference::answers`].
pub(crate) const OUTPUTS: [Output; COUNT] = [
    output("max_displacement", "Δ₀", Unit::Own, Some(2.0), 1.5),
    output("displacement_phase", "ω_d t₂", Unit::Phase, Some(2.0), 1.9),
    output("max_velocity", "V₀", Unit::Own, Some(4.0), 4.0),
    output("velocity_phase", "ω_d t₁", Unit::Phase, Some(4.0), 4.0),
    output("deviation", "Δ₁", Unit::Velocity, Some(4.0), 4.0),
    output("min_force_ratio", "α_min", Unit::Own, Some(2.0), 1.0),
    output("min_force_ratio_turning_point", "eq. 61", Unit::Own, Some(2.0), 1.0),
    output("border_phase", "τ*", Unit::Phase, None, 3.3),
    output("loop_size_stiffness", "A₁", Unit::Own, Some(2.0), 2.0),
    output("loop_size_inertia", "A₂", Unit::Own, Some(2.0), 1.0),
    output("best_force_ratio", "α*", Unit::Own, Some(2.0), 1.0),
    output("best_loop_size", "A₁max", Unit::Own, Some(2.0), 1.0),
    output("contraction", "λ", Unit::Own, None, f64::INFINITY),
    output("phase_function", "K", Unit::Own, None, 1.0),
];

pub(crate) const COUNT: usize = 14;
