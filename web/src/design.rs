//! The answers to design: the least force, the greatest friction, and the friction that dissipates most.

use crate::asked::{Asked, Problem};
use serde_json::{Value, json};
use stickslip::design;
use stickslip::{Border, Error, Excitation, NoStop};
use stickslip_front::inputs::Input;
use stickslip_front::inputs::units::Kind;

/// A row: the name, the value or the reason for its absence, and the unit.
fn row(name: &str, found: Result<f64, Error>, unit: &str) -> Value {
    match found {
        Ok(value) => json!({ "name": name, "value": value, "unit": unit }),
        Err(error) => json!({ "name": name, "error": error.to_string(), "unit": unit }),
    }
}

/// As `stickslip design force`, `friction` and `dissipation`, for the machine of the question; in ratios as fractions of
/// friction and force. With a static friction above the kinetic one, the cycle without a stop, the release of a body at
/// rest, and every start have forces of their own.
pub(crate) fn design(asked: &Asked<'_>) -> Result<Value, String> {
    let Problem { given, point, is_free, is_frictionless, is_without_spring, .. } = asked.problem()?;
    if is_free || is_frictionless {
        return Ok(json!([]));
    }
    let ratios = &point.ratios;
    let least = Border::of(ratios).min_force_ratio;
    let (force, size) = match &point.machine {
        Some(machine) => (given.system.name(Kind::Force), machine.scales.force),
        None => ("r_y".to_owned(), 1.0),
    };
    let mut rows = Vec::new();
    if let (Some((low, high)), false) =
        (NoStop::of(ratios).six_reversals, ratios.has_higher_static_friction())
    {
        rows.push(row("six_reversals_from", Ok(low * size), &force));
        rows.push(row("six_reversals_to", Ok(high * size), &force));
        rows.push(row("two_reversals_from", Ok(least * size), &force));
    }
    if ratios.has_higher_static_friction() {
        rows.push(row("cycle_force", Ok(least * size), &force));
        rows.push(row("release_force", Ok(ratios.static_friction_ratio() * size), &force));
        rows.extend(
            NoStop::of(ratios).every_start.map(|bound| row("every_start_force", Ok(bound * size), &force)),
        );
    }
    let Some(machine) = &point.machine else {
        if ratios.has_higher_static_friction() {
            rows.push(row("cycle_friction", Ok(1.0 / least), "p₀"));
        } else {
            let best = design::most_dissipating_force_ratio(ratios.omega(), ratios.damping_ratio());
            rows.push(row("force_ratio", Ok(least), "r_y"));
            rows.push(row("friction_to_force", Ok(1.0 / least), "p₀"));
            rows.push(row("best_force_ratio", best.map(|best| best.at), "r_y"));
        }
        return Ok(Value::Array(rows));
    };
    let (body, drive) = (&machine.oscillator, &machine.drive);
    let most = design::max_friction(body, drive);
    if ratios.has_higher_static_friction() {
        // A static friction that is given as a force has another ratio with another friction.
        if !given.has(Input::StaticFriction) {
            rows.push(row("cycle_friction", most, &force));
        }
        return Ok(Value::Array(rows));
    }
    let length = given.system.name(Kind::Length);
    let unbalance = given.system.name(Kind::Unbalance);
    let least = |excitation| design::min_amplitude(body, excitation, drive.angular_frequency());
    let best = design::most_dissipating_friction(body, drive);
    let is_damped_foot = drive.excitation() == Excitation::DampedFootMotion;
    let foot = if is_damped_foot { Excitation::DampedFootMotion } else { Excitation::FootMotion };
    rows.extend([
        row("force", least(Excitation::Force), &force),
        row("unbalance", least(Excitation::Unbalance), &unbalance),
        row("foot_displacement", least(foot), &length),
        row("base_displacement", least(Excitation::SurfaceMotion), &length),
        row("friction", most, &force),
        row("best_friction", best.as_ref().map(|best| best.at).map_err(Clone::clone), &force),
        row("energy", best.map(|best| best.value), &given.system.name(Kind::Energy)),
    ]);
    if is_without_spring {
        rows.retain(|row| row.get("name").and_then(Value::as_str) != Some("foot_displacement"));
    }
    Ok(Value::Array(rows))
}
