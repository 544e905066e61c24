//! The answer as a note: the regime first, then the numbers, then the necessary force.

mod force;
mod lines;

use crate::bits::{Value, digits};
use crate::style;
use lines::with_unit;
pub(crate) use lines::{Note, both, line, measured_from};
use std::io::{self, Write};
use stickslip::motion::SteadyOutput;
use stickslip::{Cycle, Excitation, Measure, Output, PhaseFunction, Regime, Response};
use stickslip_front::inputs::units::{Kind, System};
use stickslip_front::inputs::{Driven, Given, Input, Role};
use stickslip_front::words;

use force::needed_force;
pub(crate) use force::{border, no_stop};

/// The note on a response.
pub(crate) fn response<F: Value>(
    response: &Response<F>,
    mut note: Note<'_, F, impl Write>,
) -> io::Result<()> {
    let (omega, alpha) = (response.ratios.omega(), response.ratios.alpha());
    let (has_drive, has_friction) = (!note.given.is_without_drive(), !note.given.is_without_friction());
    let verdict = match (has_drive, has_friction, &response.cycle) {
        (false, _, _) => "At rest: nothing shakes the body.".to_owned(),
        (true, false, Some(_)) => "Non-sticking: without friction the body never stops.".to_owned(),
        _ => words::verdict(response),
    };
    writeln!(note.out, "{}\n", style::verdict(&verdict))?;
    let has_spring = !note.given.is_without_spring();
    if has_spring {
        note.line("frequency ratio Ω", digits(omega))?;
    }
    if has_friction {
        note.line("force ratio α", digits(note.given.drive_as_given(alpha)))?;
    }
    if response.ratios.is_damped() && has_spring {
        note.line("damping ratio ζ", digits(response.ratios.damping_ratio()))?;
    }
    if response.ratios.has_higher_static_friction() {
        let eta = digits(response.ratios.static_friction_ratio());
        note.line("static friction ratio η", eta)?;
    }
    if let Some(machine) = note.machine {
        of_machine(note.given, machine, note.out)?;
    }
    if response.regime == Regime::DependsOnStart {
        writeln!(note.out, "\n`stickslip steady` follows one start, and `stickslip attractors` many.")?;
    }
    if let Some(cycle) = response.cycle.as_ref() {
        motion(response, cycle, &mut note)?;
        equivalent(&mut note, |output, _| output.of(response))?;
    } else if response.reversals_per_cycle() == Some(6) {
        writeln!(
            note.out,
            "\nThe closed forms hold for two reversals only. `stickslip steady` gives this motion."
        )?;
    }
    if response.cycle.is_some()
        && !response.ratios.is_damped()
        && PhaseFunction::new(omega).is_ok_and(|p| p.value() == F::int(0))
    {
        let (one, least) = (F::int(1), response.border.min_force_ratio);
        let shift = digits(response.ratios.static_friction_ratio() * (alpha / least - one));
        writeln!(
            note.out,
            "\nAt Ω = 1/(2n) this is the symmetric member of a family of cycles, whose centres lie within"
        )?;
        writeln!(note.out, "±{shift} B. The start decides which is reached, see `stickslip steady`.")?;
    }
    needed_force(response, &mut note)
}

/// The machine and its drive, which show how the arguments were understood.
fn of_machine<F: Value>(given: &Given<F>, machine: &Driven<F>, out: &mut impl Write) -> io::Result<()> {
    let (Driven { oscillator, drive, scales, .. }, system) = (machine, &given.system);
    let (force, length) = (system.force(), system.length());
    if let Some(base) = words::base_motion(drive.excitation()) {
        line(out, "base motion", base)?;
    }
    let frequency = |x: F| {
        let hertz = digits(x / (F::int(2) * F::pi()));
        format!("{:<22} = {hertz} Hz", with_unit(x, "rad/s"))
    };
    line(out, "forcing frequency ω_d", frequency(drive.angular_frequency()))?;
    let has_spring = !given.is_without_spring();
    if has_spring {
        line(out, "natural frequency ω_n", frequency(oscillator.natural_frequency()))?;
    }
    line(out, "mass m", mass(oscillator.mass(), system))?;
    if has_spring {
        line(out, "stiffness k", with_unit(oscillator.stiffness(), &system.name(Kind::Stiffness)))?;
    } else {
        line(out, "stiffness k", "0, no spring")?;
    }
    let bound = digits(given.friction_as_given(oscillator.friction_bound()));
    match given.directional_friction() {
        Ok(Some((forward, backward))) => {
            let (forward, backward) = (digits(forward), digits(backward));
            line(
                out,
                "friction force r_y",
                format_args!("{bound} {force} = ({forward} forward + {backward} backward)/2"),
            )?;
        }
        _ => line(out, "friction force r_y", format_args!("{bound} {force}"))?,
    }
    if given.has_role(Role::Damper) {
        line(out, "damping constant c", with_unit(oscillator.damping(), &system.name(Kind::Damping)))?;
    }
    if drive.excitation() == Excitation::Unbalance {
        line(out, "unbalance m_e e", unbalance(given.drive_as_given(drive.amplitude()), system))?;
    }
    line(
        out,
        "force amplitude p₀",
        with_unit(given.drive_as_given(drive.force_amplitude(oscillator)), force),
    )?;
    if has_spring && !given.is_without_friction() {
        line(out, "friction displacement B", with_unit(scales.length, length))?;
    }
    if let Some(force) = given.get(Input::MeanForce) {
        writeln!(out, "  mean force p̄             {} {}", digits(force), system.force())?;
    }
    if has_spring && given.is_shifted() {
        mean_displacement(scales.mean_displacement, system, out)?;
    }
    Ok(())
}

/// A mass in a unit for a reader and, if that is another one, in the system's own unit.
fn mass<F: Value>(mass: F, system: &System) -> String {
    let (unit, factor) = system.mass_for_reading();
    let (read, own) = (format!("{} {unit}", digits(factor.times(mass))), system.name(Kind::Mass));
    if own == unit { read } else { format!("{read:<22} = {} {own}", digits(mass)) }
}

/// An unbalance in a unit for a reader, likewise: in kg·m, which is t·mm, or in pounds times the system's own length.
fn unbalance<F: Value>(unbalance: F, system: &System) -> String {
    let ((mut unit, mut factor), own) = (system.for_reading(Kind::Unbalance), system.name(Kind::Unbalance));
    if own == unit && system.mass().is_none() {
        let (mass, of) = system.mass_for_reading();
        (unit, factor) = (format!("{mass}·{}", system.length()), of);
    }
    let read = format!("{} {unit}", digits(factor.times(unbalance)));
    if system.mass().is_some() { read } else { format!("{read:<22} = {} {own}", digits(unbalance)) }
}

/// The shift of the motion by a mean force and by friction that differs by direction.
pub(crate) fn mean_displacement<F: Value>(mean: F, system: &System, out: &mut impl Write) -> io::Result<()> {
    let (mean, length) = (digits(mean), system.length());
    line(out, "mean displacement", format_args!("{mean} {length} (displacements are measured from there)"))
}

/// The numbers of a non-sticking cycle.
fn motion<F: Value>(
    response: &Response<F>,
    cycle: &Cycle<F>,
    note: &mut Note<'_, F, impl Write>,
) -> io::Result<()> {
    writeln!(note.out, "\nMotion (steady, symmetric, two reversals a cycle)")?;
    note.number("peak displacement", Measure::Length, cycle.max_displacement)?;
    note.number("  at ω_d t₂", Measure::Angle, cycle.displacement_phase)?;
    note.number("peak velocity", Measure::Velocity, cycle.max_velocity)?;
    note.number("  at ω_d t₁", Measure::Angle, cycle.velocity_phase)?;
    note.number("  at displacement Δ₁", Measure::Length, cycle.deviation())?;
    if let Some(acceleration) = Output::MaxAcceleration.of(response) {
        note.number("peak acceleration", Measure::Acceleration, acceleration)?;
    }
    let absolute = Output::MaxAbsoluteDisplacement.of(response);
    if let Some(absolute) = absolute.filter(|_| note.is_driven(Excitation::carries_surface)) {
        note.number("absolute displacement", Measure::Length, absolute)?;
    }
    let has_spring = !note.given.is_without_spring();
    if has_spring {
        let amplification = digits(cycle.max_displacement / cycle.ratios.alpha());
        note.line("dynamic amplification", format_args!("k Δ₀/p₀ = {amplification}"))?;
    }
    note.line("a disturbance", decay(cycle.contraction(), "half a cycle"))?;
    writeln!(note.out, "\nDissipation in a cycle")?;
    let given = note.given;
    let friction_part = |of_friction: F| given.friction_as_given(of_friction);
    if let Some(scales) = note.scales {
        let energy = scales.energy_stiffness * friction_part(cycle.loop_size_stiffness());
        note.line("energy 4 r_y Δ₀", with_unit(energy, &note.given.system.name(Kind::Energy)))?;
    }
    if cycle.ratios.is_damped() {
        note.number("energy of the damper", Measure::Work, cycle.damper_work())?;
    }
    if has_spring {
        note.line(
            "energy over p₀²/(2k)",
            format_args!("A₁ = {}", digits(friction_part(cycle.loop_size_stiffness()))),
        )?;
    }
    note.line(
        "energy over p₀²/(2mω_d²)",
        format_args!("A₂ = {}", digits(friction_part(cycle.loop_size_inertia()))),
    )
}

/// The equivalent oscillator of a motion, by its outputs in the closed forms and in the steady state.
pub(crate) fn equivalent<F: Value>(
    note: &mut Note<'_, F, impl Write>,
    of: impl Fn(Output, SteadyOutput) -> Option<F>,
) -> io::Result<()> {
    if let Some(damping) = of(Output::EquivalentDamping, SteadyOutput::EquivalentDamping) {
        note.number("equivalent damping c_eq", Measure::Damping, damping)?;
    }
    let ratio = of(Output::EquivalentDampingRatio, SteadyOutput::EquivalentDampingRatio);
    if let Some(ratio) = ratio.filter(|_| !note.given.is_without_spring()) {
        note.line("  damping ratio ζ_eq", digits(ratio))?;
    }
    if let Some(stiffness) = of(Output::EquivalentStiffness, SteadyOutput::EquivalentStiffness) {
        note.number("equivalent stiffness", Measure::Stiffness, stiffness)?;
    }
    if let Some(ratio) = of(Output::EffectiveDampingRatio, SteadyOutput::EffectiveDampingRatio) {
        note.line("  damping ratio ξ_eff", digits(ratio))?;
    }
    Ok(())
}

/// The fraction of a disturbance that remains after a time.
pub(crate) fn decay<F: Value>(left: F, time: &str) -> String {
    let left = digits(left);
    if left == "1" { "does not decay".to_owned() } else { format!("decays to {left} of its size in {time}") }
}
