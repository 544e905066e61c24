//! Errors in units in the last place: the outputs, their units, and the allowed errors.
//!
//! This table serves the harness (`benches/accuracy.rs`) and the test (`tests/closed_forms/accuracy.rs`).

pub(crate) mod damped;
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

const fn output(output: stickslip::Output, unit: Unit, allowed: f64) -> Output {
    let stickslip::Definition { name, symbol, ulps, .. } = *output.definition();
    let goal = match ulps {
        Some(ulps) => Some(ulps as f64),
        None => None,
    };
    Output { name, symbol, unit, goal, allowed }
}

/// Every output, in the order of [`reference::answers`].
pub(crate) const OUTPUTS: [Output; COUNT] = [
    output(stickslip::Output::MaxDisplacement, Unit::Own, 1.5),
    output(stickslip::Output::DisplacementPhase, Unit::Phase, 1.9),
    output(stickslip::Output::MaxVelocity, Unit::Own, 4.0),
    output(stickslip::Output::VelocityPhase, Unit::Phase, 4.0),
    output(stickslip::Output::Deviation, Unit::Velocity, 4.0),
    output(stickslip::Output::MinForceRatio, Unit::Own, 1.0),
    output(stickslip::Output::MinForceRatioTurningPoint, Unit::Own, 1.0),
    output(stickslip::Output::BorderPhase, Unit::Phase, 3.3),
    output(stickslip::Output::LoopSizeStiffness, Unit::Own, 2.0),
    output(stickslip::Output::LoopSizeInertia, Unit::Own, 1.0),
    output(stickslip::Output::BestForceRatio, Unit::Own, 1.0),
    output(stickslip::Output::BestLoopSize, Unit::Own, 1.0),
    output(stickslip::Output::Contraction, Unit::Own, f64::INFINITY),
    Output { name: "phase_function", symbol: "K", unit: Unit::Own, goal: None, allowed: 1.0 },
];

pub(crate) const COUNT: usize = 14;
