//! The answers to design: the least force, the greatest friction, and the friction that dissipates most.

use crate::asked::{Asked, point};
use serde_json::{Value, json};
use stickslip::design;
use stickslip::inputs::units::Kind;
use stickslip::{Border, Error, Excitation};

/// A row: the name, the value or the reason for its absence, and the unit.
fn row(name: &str, found: Result<f64, Error>, unit: &str) -> Value {
    match found {
        Ok(value) => json!({ "name": name, "value": value, "unit": unit }),
        Err(error) => json!({ "name": name, "error": error.to_string(), "unit": unit }),
    }
}

/// As `stickslip design force`, `friction` and `dissipation`, for the machine of the question; in ratios as fractions of
/// friction and force.
pub(crate) fn design(asked: &Asked<'_>) -> Result<Value, String> {
    let given = asked.given(&asked.reader()?)?;
    let point = point(&given)?;
    let Some(machine) = &point.machine else {
        let (omega, zeta) = (point.ratios.omega(), point.ratios.damping_ratio());
        let least = Border::of(&point.ratios).min_force_ratio;
        let best = design::most_dissipating_force_ratio(omega, zeta);
        return Ok(json!([
            row("force_ratio", Ok(least), "r_y"),
            row("friction_to_force", Ok(1.0 / least), "p₀"),
            row("best_force_ratio", best.map(|best| best.at), "r_y"),
        ]));
    };
    let (body, drive) = (&machine.oscillator, &machine.drive);
    let (force, length) = (given.system.name(Kind::Force), given.system.name(Kind::Length));
    let frequency = drive.angular_frequency();
    let least = |excitation| design::min_amplitude(body, excitation, frequency);
    let best = design::most_dissipating_friction(body, drive);
    Ok(json!([
        row("force", least(Excitation::Force), &force),
        row("unbalance", least(Excitation::Unbalance), &given.system.name(Kind::Unbalance)),
        row("foot_displacement", least(Excitation::FootMotion), &length),
        row("base_displacement", least(Excitation::SurfaceMotion), &length),
        row("friction", design::max_friction(body, drive), &force),
        row("best_friction", best.as_ref().map(|best| best.at).map_err(Clone::clone), &force),
        row("energy", best.map(|best| best.value), &given.system.name(Kind::Energy)),
    ]))
}
