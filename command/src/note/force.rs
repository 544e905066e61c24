//! The note on forces: the minimum without sticking, the optimum for dissipation, and the border.

use super::{both, static_friction};
use crate::bits::{Value, digits};
use crate::machine::{Machine, transmitted};
use std::io::{self, Write};
use stickslip::inputs::units::System;
use stickslip::{NoStop, Ratios, Response, Scales};

/// The minimum force without sticking, and the force of maximum dissipation.
pub(super) fn needed_force<F: Value>(
    response: &Response<F>,
    machine: Option<&Machine<F>>,
    units: &System,
    out: &mut impl Write,
) -> io::Result<()> {
    let border = response.border;
    let forces = |x| both(x, "r_y", machine.map(|m| m.scales.force), units.force());
    writeln!(out, "\nForce")?;
    if let Some(cycle) = response.cycle.as_ref() {
        let (ratios, acceleration) = (response.ratios, cycle.max_acceleration());
        let (force, ratio) = transmitted(machine, &ratios, cycle.transmitted_force(), acceleration);
        writeln!(out, "  transmitted, maximum     {}", forces(force))?;
        super::without_mean_force(machine, out)?;
        let name = if machine.is_some_and(|m| m.drive.excitation().moves_foot()) {
            "per foot acceleration"
        } else {
            "per p₀"
        };
        writeln!(out, "    {name:<22} {}", digits(ratio))?;
    }
    match NoStop::of(&response.ratios).six_reversals {
        _ if response.ratios.has_higher_static_friction() => static_friction::forces(response, forces, out)?,
        None => writeln!(out, "  minimum without sticking {}", forces(border.min_force_ratio))?,
        Some((low, high)) => {
            writeln!(out, "  minimum without a stop   {}", forces(low))?;
            writeln!(out, "    up to                  {}  (six reversals a cycle)", forces(high))?;
            writeln!(out, "  two-reversal border      {}", forces(border.min_force_ratio))?;
            writeln!(out, "    (between these two the body stops)")?;
        }
    }
    not_to_be_held(response.ratios.omega(), border.min_force_ratio, out)?;
    if border.turning_point < border.min_force_ratio && !response.ratios.is_damped() {
        let eq_61 = digits(border.turning_point);
        writeln!(out, "    (eq. 61 gives {eq_61} r_y, which is too little below Ω = 1/2)")?;
    }
    match response.best_loop_size {
        Some(size) if response.best_is_reached() => {
            writeln!(out, "  maximum dissipation at   {}", forces(response.best_force_ratio))?;
            writeln!(out, "    loop size A₁ there     {}", digits(size))?;
            if size.to_f64() > ABSURD {
                writeln!(
                    out,
                    "    (no machine holds a frequency so close to Ω = 1/(2n), where it is infinite)"
                )?;
            }
            Ok(())
        }
        None if response.best_is_reached() => {
            writeln!(
                out,
                "  maximum dissipation at   any force above the minimum: at Ω = 1 the loop grows in every cycle"
            )
        }
        Some(_) | None => writeln!(
            out,
            "  maximum dissipation at   the minimum above: with the optimum of eq. 65, {} r_y, it would stick",
            digits(response.best_force_ratio)
        ),
    }
}

/// A greater force ratio or loop size belongs to a pole, closer than the frequency of any machine.
const ABSURD: f64 = 1e6;

/// Adds a remark if Ω is too close to a pole for any machine.
fn not_to_be_held<F: Value>(omega: F, border: F, out: &mut impl Write) -> io::Result<()> {
    // Away from the poles the border is a few times 1/Ω².
    if border.to_f64() * omega.to_f64() * omega.to_f64() > ABSURD {
        writeln!(
            out,
            "    (no machine holds a frequency so close to Ω = 1/(2n+1), where the border is infinite)"
        )?;
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
    scales: Option<&Scales<F>>,
    units: &System,
    out: &mut impl Write,
) -> io::Result<()> {
    let (omega, border) = (answer.ratios.omega(), answer.border);
    let forces = |x| both(x, "r_y", scales.map(|s| s.force), units.force());
    let lengths = |x| both(x, "B", scales.map(|s| s.length), units.length());
    let times = |x| both(x, "rad", scales.map(|s| s.time), "s");
    match found {
        None => {
            let least = digits(border.min_force_ratio);
            let cycle = "the cycle of two reversals does not stick at a force of";
            writeln!(out, "At Ω = {} {cycle} {least} r_y or more.\n", digits(omega))?;
        }
        Some(found) => {
            writeln!(out, "At Ω = {} the body does not stop {}.\n", digits(omega), no_stop(found, "r_y"))?;
        }
    }
    if answer.ratios.is_damped() {
        writeln!(out, "  damping ratio ζ          {}", digits(answer.ratios.damping_ratio()))?;
    }
    if let Some((low, high)) = found.and_then(|it| it.six_reversals) {
        writeln!(out, "  six reversals from       {}", forces(low))?;
        writeln!(out, "    up to                  {}", forces(high))?;
    }
    writeln!(out, "  two-reversal border      {}", forces(border.min_force_ratio))?;
    not_to_be_held(omega, border.min_force_ratio, out)?;
    writeln!(out, "  at the turning point     {}", forces(border.turning_point))?;
    writeln!(
        out,
        "    (eq. 61{})",
        if omega >= exact_from(answer.ratios) { ", exact here" } else { ", necessary only here" }
    )?;
    writeln!(out, "  minimum displacement     {}", lengths(border.min_displacement))?;
    writeln!(
        out,
        "  velocity touches zero    {} after the maximum displacement",
        times(border.touching_phase)
    )
}
