//! The answer as a note: the regime first, then the numbers, then the necessary force.

mod force;
mod static_friction;

use crate::bits::{Value, digits};
use crate::machine::Machine;
use crate::style;
use std::io::{self, Write};
use stickslip::inputs::units::{Kind, System};
use stickslip::words;
use stickslip::{Cycle, Excitation, PhaseFunction, Regime, Response};

use force::needed_force;
pub(crate) use force::{border, no_stop};

/// A number in its dimensionless unit and, if there is a machine, in the user's unit.
pub(crate) fn both<F: Value>(x: F, unit: &str, scale: Option<F>, name: &str) -> String {
    let own = format!("{} {unit}", digits(x));
    match scale {
        Some(scale) => format!("{:<22} = {} {name}", own.trim_end(), digits(x * scale)),
        None => own.trim_end().to_owned(),
    }
}

/// The text of [`both`] within a sentence, without aligned columns.
pub(crate) fn both_in_words<F: Value>(x: F, unit: &str, scale: Option<F>, name: &str) -> String {
    both(x, unit, scale, name).split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The note on a response.
pub(crate) fn response<F: Value>(
    response: &Response<F>,
    machine: Option<&Machine<F>>,
    units: &System,
    out: &mut impl Write,
) -> io::Result<()> {
    let (omega, alpha) = (response.ratios.omega(), response.ratios.alpha());
    writeln!(out, "{}\n", style::verdict(&words::verdict(response)))?;
    writeln!(out, "  frequency ratio Ω        {}", digits(omega))?;
    writeln!(out, "  force ratio α            {}", digits(alpha))?;
    if response.ratios.is_damped() {
        writeln!(out, "  damping ratio ζ          {}", digits(response.ratios.damping_ratio()))?;
    }
    if response.ratios.has_higher_static_friction() {
        let eta = digits(response.ratios.static_friction_ratio());
        writeln!(out, "  static friction ratio η  {eta}")?;
    }
    if let Some(machine) = machine {
        given(machine, out)?;
    }
    if response.regime == Regime::DependsOnStart {
        writeln!(out, "\n`stickslip steady` follows one start, and `stickslip attractors` many.")?;
    }
    if let Some(cycle) = response.cycle.as_ref() {
        motion(cycle, machine, units, out)?;
    } else if response.reversals_per_cycle() == Some(6) {
        writeln!(
            out,
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
            out,
            "\nAt Ω = 1/(2n) this is the symmetric member of a family of cycles, whose centres lie within"
        )?;
        writeln!(out, "±{shift} B. The start decides which is reached, see `stickslip steady`.")?;
    }
    needed_force(response, machine, units, out)
}

/// The machine and its drive, which show how the arguments were understood.
pub(crate) fn given<F: Value>(machine: &Machine<F>, out: &mut impl Write) -> io::Result<()> {
    let Machine { oscillator, drive, scales, system, has_damper, .. } = machine;
    let (force, length) = (system.force(), system.length());
    let hertz = |frequency: F| digits(frequency / (F::int(2) * F::pi()));
    let (driven, natural) = (drive.angular_frequency(), oscillator.natural_frequency());
    if let Some(base) = words::base_motion(drive.excitation()) {
        writeln!(out, "  base motion              {base}")?;
    }
    writeln!(
        out,
        "  drive frequency ω_d      {:<22} = {} Hz",
        format!("{} rad/s", digits(driven)),
        hertz(driven)
    )?;
    writeln!(
        out,
        "  natural frequency ω_n    {:<22} = {} Hz",
        format!("{} rad/s", digits(natural)),
        hertz(natural)
    )?;
    writeln!(out, "  mass m                   {}", mass(oscillator.mass(), system))?;
    writeln!(out, "  stiffness k              {} {force}/{length}", digits(oscillator.stiffness()))?;
    let bound = digits(oscillator.friction_bound());
    match machine.directional_friction {
        Some((forward, backward)) => {
            let (forward, backward) = (digits(forward), digits(backward));
            writeln!(
                out,
                "  friction bound r_y       {bound} {force} = ({forward} forward + {backward} backward)/2"
            )?;
        }
        None => writeln!(out, "  friction bound r_y       {bound} {force}")?,
    }
    if *has_damper {
        writeln!(
            out,
            "  damping constant c       {} {}",
            digits(oscillator.damping()),
            system.name(Kind::Damping)
        )?;
    }
    if drive.excitation() == Excitation::Unbalance {
        writeln!(
            out,
            "  unbalance m_e e          {} {}",
            digits(drive.amplitude()),
            system.name(Kind::Unbalance)
        )?;
    }
    writeln!(out, "  force amplitude p₀       {} {force}", digits(drive.force_amplitude(oscillator)))?;
    writeln!(out, "  friction displacement B  {} {length}", digits(scales.length))?;
    if let Some(force) = machine.mean_force {
        writeln!(out, "  mean force p̄             {} {}", digits(force), system.force())?;
    }
    if machine.is_shifted() {
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

/// The shift of the motion by a mean force and by friction that differs by direction.
pub(crate) fn mean_displacement<F: Value>(mean: F, system: &System, out: &mut impl Write) -> io::Result<()> {
    let (mean, length) = (digits(mean), system.length());
    writeln!(out, "  mean displacement        {mean} {length} (displacements are measured from there)")
}

/// A note that the transmitted force does not contain the mean force, if one was given.
pub(crate) fn without_mean_force<F: Value>(
    machine: Option<&Machine<F>>,
    out: &mut impl Write,
) -> io::Result<()> {
    match machine.and_then(|machine| machine.mean_force) {
        Some(_) => writeln!(out, "    (without the mean force p̄, which the support carries in addition)"),
        None => Ok(()),
    }
}

/// The displacement from which a shifted motion is measured, in a sentence.
pub(crate) fn measured_from<F: Value>(machine: Option<&Machine<F>>, out: &mut impl Write) -> io::Result<()> {
    let Some(machine) = machine.filter(|machine| machine.is_shifted()) else { return Ok(()) };
    let (mean, unit) = (digits(machine.scales.mean_displacement), machine.system.length());
    writeln!(out, "Displacements are measured from the mean displacement of {mean} {unit}.")
}

/// The numbers of a non-sticking cycle.
fn motion<F: Value>(
    cycle: &Cycle<F>,
    machine: Option<&Machine<F>>,
    units: &System,
    out: &mut impl Write,
) -> io::Result<()> {
    let scales = machine.map(|m| &m.scales);
    let (force, length) = (units.force(), units.length());
    let lengths = |x| both(x, "B", scales.map(|s| s.length), length);
    let phases = |x| both(x, "rad", scales.map(|s| s.time), "s");
    let speed = both(cycle.max_velocity, "B ω_d", scales.map(|s| s.velocity), &format!("{length}/s"));
    writeln!(out, "\nMotion (steady, symmetric, two reversals a cycle)")?;
    writeln!(out, "  maximum displacement     {}", lengths(cycle.max_displacement))?;
    writeln!(out, "    at ω_d t₂              {}", phases(cycle.displacement_phase))?;
    writeln!(out, "  maximum velocity         {speed}")?;
    writeln!(out, "    at ω_d t₁              {}", phases(cycle.velocity_phase))?;
    writeln!(out, "    where x = Δ₁           {}", lengths(cycle.deviation()))?;
    let acceleration = scales.map(|s| s.velocity / s.time);
    let acceleration =
        both(cycle.max_acceleration(), "B ω_d²", acceleration, &units.name(Kind::Acceleration));
    writeln!(out, "  maximum acceleration     {acceleration}")?;
    if machine.is_some_and(|m| m.drive.excitation().carries_surface()) {
        writeln!(out, "  absolute displacement    {}", lengths(cycle.max_absolute_displacement()))?;
    }
    writeln!(
        out,
        "  dynamic amplification    k Δ₀/p₀ = {}",
        digits(cycle.max_displacement / cycle.ratios.alpha())
    )?;
    writeln!(out, "  a disturbance            {}", decay(cycle.contraction(), "half a cycle"))?;
    writeln!(out, "\nDissipation in a cycle")?;
    if let Some(Machine { scales, .. }) = machine {
        let energy = scales.energy_stiffness * cycle.loop_size_stiffness();
        writeln!(out, "  energy 4 r_y Δ₀          {} {force}·{length}", digits(energy))?;
    }
    if cycle.ratios.is_damped() && !machine.is_some_and(Machine::has_damped_foot) {
        let scale = scales.map(|s| s.force * s.length);
        let work = both(cycle.damper_work(), "r_y B", scale, &format!("{force}·{length}"));
        writeln!(out, "  energy of the damper     {work}")?;
    }
    writeln!(out, "  per static energy        A₁ = {}", digits(cycle.loop_size_stiffness()))?;
    writeln!(out, "  per pseudo-static energy A₂ = {}", digits(cycle.loop_size_inertia()))
}

/// The fraction of a disturbance that remains after a time.
pub(crate) fn decay<F: Value>(left: F, time: &str) -> String {
    let left = digits(left);
    if left == "1" { "does not decay".to_owned() } else { format!("decays to {left} of its size in {time}") }
}
