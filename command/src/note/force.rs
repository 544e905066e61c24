//! The note on forces: the minimum without sticking, the optimum for dissipation, and the border.

use super::Note;
use crate::bits::{Value, digits};
use std::io::{self, Write};
use stickslip::{Excitation, Measure, NoStop, Output, Ratios, Response};

/// The minimum force without sticking, and the force of maximum dissipation.
pub(super) fn needed_force<F: Value>(
    response: &Response<F>,
    note: &mut Note<'_, F, impl Write>,
) -> io::Result<()> {
    let border = response.border;
    writeln!(note.out, "\nForce")?;
    if let Some(force) = Output::MaxSpringForce.of(response) {
        note.in_spring("in the spring, maximum", force)?;
    }
    if let Some(force) = Output::TransmittedForce.of(response) {
        note.transmitted("transmitted, maximum", force)?;
    }
    if let Some(transmissibility) = Output::Transmissibility.of(response) {
        let of_foot = note.is_driven(Excitation::moves_foot);
        note.line(if of_foot { "per support acceleration" } else { "  per p₀" }, digits(transmissibility))?;
    }
    if note.given.is_without_friction() {
        return note.number("minimum without sticking", Measure::Force, border.min_force_ratio);
    }
    match NoStop::of(&response.ratios).six_reversals {
        _ if response.ratios.has_higher_static_friction() => forces_of_static_friction(response, note)?,
        None => note.number("minimum without sticking", Measure::Force, border.min_force_ratio)?,
        Some((low, high)) => {
            note.number("minimum without a stop", Measure::Force, low)?;
            let high = note.both(Measure::Force, high);
            note.line("  up to", format_args!("{high}  (six reversals a cycle)"))?;
            note.number("two-reversal threshold", Measure::Force, border.min_force_ratio)?;
            writeln!(note.out, "    (between these two the body stops)")?;
        }
    }
    not_to_be_held(response.ratios.omega(), border.min_force_ratio, note)?;
    if border.min_force_ratio_turning_point < border.min_force_ratio && !response.ratios.is_damped() {
        let eq_61 = digits(border.min_force_ratio_turning_point);
        writeln!(note.out, "    (eq. 61 gives {eq_61} r_y, which is too little below Ω = 1/2)")?;
    }
    let (name, best) = ("maximum dissipation at", response.best_force_ratio);
    match response.best_loop_size {
        Some(size) if response.best_is_reached() => {
            note.number(name, Measure::Force, best)?;
            if !note.given.is_without_spring() {
                note.line("  loop size A₁ there", digits(size))?;
            }
            if size.to_f64() > ABSURD {
                let text = "no machine holds a frequency so close to Ω = 1/(2n), where it is infinite";
                writeln!(note.out, "    ({text})")?;
            }
            Ok(())
        }
        None if response.best_is_reached() => {
            note.line(name, "any force above the minimum: at Ω = 1 the loop grows in every cycle")
        }
        Some(_) | None => {
            let best = digits(best);
            let text = format!("the minimum above: with the optimum of eq. 65, {best} r_y, it would stick");
            note.line(name, text)
        }
    }
}

/// A greater force ratio or loop size belongs to a pole, closer than the frequency of any machine.
const ABSURD: f64 = 1e6;

/// Adds a remark if Ω is too close to a pole for any machine.
fn not_to_be_held<F: Value>(omega: F, border: F, note: &mut Note<'_, F, impl Write>) -> io::Result<()> {
    // Away from the poles the border is a few times 1/Ω², or η.
    if omega < F::int(1) && border.to_f64() * omega.to_f64() * omega.to_f64() > ABSURD {
        let text =
            "no machine holds a frequency so close to Ω = 1/(2n+1), where the sticking threshold is infinite";
        writeln!(note.out, "    ({text})")?;
    }
    Ok(())
}

/// The forces with which the body does not stop, as the end of a sentence.
pub(crate) fn no_stop<F: Value>(found: &NoStop<F>, unit: &str) -> String {
    let border = digits(found.border);
    match found.six_reversals {
        None => format!("at a force of {border} {unit} or more"),
        Some((low, high)) => format!(
            "at a force of {} to {} {unit}, where it reverses six times a cycle, and of {border} {unit} or \
             more",
            digits(low),
            digits(high)
        ),
    }
}

/// The Ω from which the turning point decides the border, `√(1 − ζ²)/2`.
fn exact_from<F: Value>(ratios: Ratios<F>) -> F {
    let (one, zeta) = (F::int(1), ratios.damping_ratio());
    if zeta < one { ((one - zeta) * (one + zeta)).sqrt() / F::int(2) } else { F::int(0) }
}

/// The note on a border, with the forces of six reversals a cycle if requested.
pub(crate) fn border<F: Value>(
    answer: &Response<F>,
    found: Option<&NoStop<F>>,
    mut note: Note<'_, F, impl Write>,
) -> io::Result<()> {
    let (omega, border) = (answer.ratios.omega(), answer.border);
    let sentence = match found {
        None => {
            let least = digits(border.min_force_ratio);
            format!("the cycle of two reversals does not stick at a force of {least} r_y or more")
        }
        Some(found) => format!("the body does not stop {}", no_stop(found, "r_y")),
    };
    let has_spring = !note.given.is_without_spring();
    if has_spring {
        writeln!(note.out, "At Ω = {} {sentence}.\n", digits(omega))?;
    } else {
        writeln!(note.out, "Without a spring {sentence}.\n")?;
    }
    if has_spring && answer.ratios.is_damped() {
        note.line("damping ratio ζ", digits(answer.ratios.damping_ratio()))?;
    }
    if let Some((low, high)) = found.and_then(|it| it.six_reversals) {
        note.number("six reversals from", Measure::Force, low)?;
        note.number("  up to", Measure::Force, high)?;
    }
    note.number("two-reversal threshold", Measure::Force, border.min_force_ratio)?;
    not_to_be_held(omega, border.min_force_ratio, &mut note)?;
    note.number("at the turning point", Measure::Force, border.min_force_ratio_turning_point)?;
    let is_exact = omega >= exact_from(answer.ratios);
    writeln!(note.out, "    (eq. 61, {} here)", if is_exact { "exact" } else { "necessary only" })?;
    note.number("minimum displacement", Measure::Length, border.least_displacement)?;
    let touching = note.both(Measure::Angle, border.border_phase);
    note.line("velocity touches zero", format_args!("{touching} after the peak displacement"))
}

/// The forces that release a body at rest, that a cycle without a stop needs, and that suffice for every start.
fn forces_of_static_friction<F: Value>(
    response: &Response<F>,
    note: &mut Note<'_, F, impl Write>,
) -> io::Result<()> {
    let found = NoStop::of(&response.ratios);
    let release = note.both(Measure::Force, response.ratios.static_friction_ratio());
    note.line("releases a body at rest", format_args!("above {release}"))?;
    if let Some((low, high)) = found.six_reversals {
        note.number("six-reversal cycle from", Measure::Force, low)?;
        note.number("  up to", Measure::Force, high)?;
    }
    note.number("cycle without a stop", Measure::Force, found.border)?;
    let Some(bound) = found.every_start.map(|bound| note.both(Measure::Force, bound)) else { return Ok(()) };
    note.line("every start slides", format_args!("above {bound}"))?;
    writeln!(note.out, "    (this bound suffices and is not the least)")
}
