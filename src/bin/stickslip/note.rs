//! The answer as an engineer's note: the regime first, then the numbers, then the force it would need.

use crate::bits::Value;
use crate::input::BorderScales;
use crate::machine::{Machine, base_motion, transmitted};
use crate::style;
use std::io::{self, Write};
use stickslip::regime::{NoStop, no_stop_force_ratios};
use stickslip::units::{Kind, System};
use stickslip::{Cycle, PhaseFunction, Ratios, Regime, Response};

/// Seven significant digits at f64, without the zeros that say nothing; all digits of a wider number.
pub(crate) fn digits<F: Value>(x: F) -> String {
    if F::PRECISION > f64::MANTISSA_DIGITS {
        return x.to_string();
    }
    let x = x.to_f64();
    let rounded: f64 = format!("{x:.6e}").parse().unwrap_or(x);
    if rounded == 0.0 || (1e-4..1e7).contains(&rounded.abs()) {
        format!("{rounded}")
    } else {
        format!("{rounded:e}")
    }
}

/// All digits, with a power of ten where it would take many zeros.
pub(crate) fn all_digits<F: Value>(x: F) -> String {
    let size = x.to_f64().abs();
    if size == 0.0 || (1e-5..1e16).contains(&size) { x.to_string() } else { format!("{x:e}") }
}

/// A number in its dimensionless unit and, where there is a machine, in the user's.
pub(crate) fn both<F: Value>(x: F, unit: &str, scale: Option<F>, name: &str) -> String {
    let own = format!("{} {unit}", digits(x));
    match scale {
        Some(scale) => format!("{:<22} = {} {name}", own.trim_end(), digits(x * scale)),
        None => own.trim_end().to_owned(),
    }
}

/// What the body does, in one sentence.
fn verdict<F: Value>(response: &Response<F>) -> String {
    let (omega, alpha) = (response.ratios().omega(), response.ratios().alpha());
    let margin = digits(alpha / response.border().min_force_ratio());
    match response.regime() {
        Regime::Stuck => {
            "Stuck: α ≤ 1, so the force never exceeds friction and the body comes to rest for good.".into()
        }
        Regime::Sticking => format!(
            "Sticking: the body stops in each cycle; the force is {margin} of the minimum for continuous sliding."
        ),
        Regime::NonSticking if response.cycle().is_none() => format!(
            "Non-sticking: the body never stops; it reverses six times a cycle. The force is {margin} of the minimum for two reversals."
        ),
        Regime::NonSticking => {
            format!(
                "Non-sticking: the body never stops; the force is {margin} times the minimum for continuous sliding."
            )
        }
        Regime::Unbounded => format!(
            "Unbounded: at Ω = {omega} and α > 4/π = 1.27324 friction cannot hold the resonance; the displacement grows in every cycle."
        ),
    }
}

/// The note on a response.
pub(crate) fn response<F: Value>(
    response: &Response<F>,
    machine: Option<&Machine<F>>,
    units: &System,
    out: &mut impl Write,
) -> io::Result<()> {
    let (omega, alpha) = (response.ratios().omega(), response.ratios().alpha());
    writeln!(out, "{}\n", style::verdict(&verdict(response)))?;
    writeln!(out, "  frequency ratio Ω        {}", digits(omega))?;
    writeln!(out, "  force ratio α            {}", digits(alpha))?;
    if response.ratios().is_damped() {
        writeln!(out, "  damping ratio ζ          {}", digits(response.ratios().damping_ratio()))?;
    }
    if response.ratios().has_higher_static_friction() {
        let eta = digits(response.ratios().static_friction_ratio());
        writeln!(out, "  static friction ratio η  {eta}")?;
    }
    if let Some(machine) = machine {
        given(machine, out)?;
    }
    if response.ratios().has_higher_static_friction() && response.regime() != Regime::Stuck {
        writeln!(
            out,
            "\nWith static friction above the kinetic one the motion can depend on the start, and the verdict is that of\n\
             the border alone; `stickslip steady` follows one start."
        )?;
    }
    if let Some(cycle) = response.cycle() {
        motion(cycle, machine, units, out)?;
    } else if response.regime() == Regime::NonSticking {
        writeln!(
            out,
            "\nThe closed forms hold for two reversals only; `stickslip steady` gives this motion."
        )?;
    }
    if response.regime() == Regime::NonSticking
        && !response.ratios().is_damped()
        && PhaseFunction::new(omega).is_ok_and(|p| p.value() == F::int(0))
    {
        let (one, least) = (F::int(1), response.border().min_force_ratio());
        let shift = digits(alpha / least - one);
        writeln!(
            out,
            "\nAt Ω = 1/(2n) this is the symmetric member of a family of cycles, whose centres lie within"
        )?;
        writeln!(out, "±{shift} B. The start decides which is reached; see `stickslip steady`.")?;
    }
    needed_force(response, machine, units, out)
}

/// The machine and its drive, so that a reader sees how the arguments were understood.
pub(crate) fn given<F: Value>(machine: &Machine<F>, out: &mut impl Write) -> io::Result<()> {
    let Machine { oscillator, drive, scales, system, has_damper, .. } = machine;
    let (force, length) = (system.force(), system.length());
    let hertz = |frequency: F| digits(frequency / (F::int(2) * F::pi()));
    let (driven, natural) = (drive.angular_frequency(), oscillator.natural_frequency());
    if let Some(base) = base_motion(drive.excitation()) {
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
    writeln!(out, "  mass m                   {} {}", digits(oscillator.mass()), system.name(Kind::Mass))?;
    writeln!(out, "  stiffness k              {} {force}/{length}", digits(oscillator.stiffness()))?;
    writeln!(out, "  friction bound r_y       {} {force}", digits(oscillator.friction_bound()))?;
    if *has_damper {
        writeln!(
            out,
            "  damping constant c       {} {}",
            digits(oscillator.damping()),
            system.name(Kind::Damping)
        )?;
    }
    writeln!(out, "  force amplitude p₀       {} {force}", digits(drive.force_amplitude(oscillator)))?;
    writeln!(out, "  friction displacement B  {} {length}", digits(scales.length))
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
    let speed = both(cycle.max_velocity(), "B ω_d", scales.map(|s| s.velocity), &format!("{length}/s"));
    writeln!(out, "\nMotion (steady, symmetric, twice-reversing)")?;
    writeln!(out, "  maximum displacement     {}", lengths(cycle.max_displacement()))?;
    writeln!(out, "    at ω_d t₂              {}", phases(cycle.displacement_phase()))?;
    writeln!(out, "  maximum velocity         {speed}")?;
    writeln!(out, "    at ω_d t₁              {}", phases(cycle.velocity_phase()))?;
    writeln!(out, "    where x = Δ₁           {}", lengths(cycle.deviation()))?;
    let acceleration = scales.map(|s| s.velocity / s.time);
    let acceleration =
        both(cycle.max_acceleration(), "B ω_d²", acceleration, &units.name(Kind::Acceleration));
    writeln!(out, "  maximum acceleration     {acceleration}")?;
    if machine.is_some_and(|m| m.drive.excitation().carries_surface()) {
        writeln!(out, "  absolute displacement    {}", lengths(cycle.max_absolute_displacement()))?;
    }
    writeln!(out, "  dynamic amplification    k Δ₀/p₀ = {}", digits(cycle.dynamic_amplification()))?;
    writeln!(out, "  a disturbance            {}", decay(cycle.contraction(), "half a cycle"))?;
    writeln!(out, "\nDissipation in a cycle")?;
    if let Some(Machine { scales, .. }) = machine {
        let energy = scales.energy_stiffness * cycle.loop_size_stiffness();
        writeln!(out, "  energy 4 r_y Δ₀          {} {force}·{length}", digits(energy))?;
    }
    if cycle.ratios().is_damped() {
        let scale = scales.map(|s| s.force * s.length);
        let work = both(cycle.damper_work(), "r_y B", scale, &format!("{force}·{length}"));
        writeln!(out, "  energy of the damper     {work}")?;
    }
    writeln!(out, "  per static energy        A₁ = {}", digits(cycle.loop_size_stiffness()))?;
    writeln!(out, "  per pseudo-static energy A₂ = {}", digits(cycle.loop_size_inertia()))
}

/// The share of a disturbance that is left after a time.
pub(crate) fn decay<F: Value>(left: F, time: &str) -> String {
    let left = digits(left);
    if left == "1" { "does not decay".to_owned() } else { format!("decays to {left} of its size in {time}") }
}

/// The minimum force without sticking, and the force of maximum dissipation.
fn needed_force<F: Value>(
    response: &Response<F>,
    machine: Option<&Machine<F>>,
    units: &System,
    out: &mut impl Write,
) -> io::Result<()> {
    let border = response.border();
    let forces = |x| both(x, "r_y", machine.map(|m| m.scales.force), units.force());
    writeln!(out, "\nForce")?;
    if let Some(cycle) = response.cycle() {
        let (ratios, acceleration) = (response.ratios(), cycle.max_acceleration());
        let at = (ratios.omega(), ratios.alpha());
        let (force, ratio) = transmitted(machine, at, cycle.transmitted_force(), acceleration);
        writeln!(out, "  transmitted, maximum     {}", forces(force))?;
        let name = if machine.is_some_and(|m| m.drive.excitation().moves_foot()) {
            "per foot acceleration"
        } else {
            "per p₀"
        };
        writeln!(out, "    {name:<22} {}", digits(ratio))?;
    }
    let ratios = response.ratios();
    let no_stop = (!ratios.is_damped()).then(|| no_stop_force_ratios(ratios.omega()).ok()).flatten();
    match no_stop.as_ref().and_then(NoStop::six_reversals) {
        None => writeln!(out, "  minimum without sticking {}", forces(border.min_force_ratio()))?,
        Some((low, high)) => {
            writeln!(out, "  minimum without a stop   {}", forces(low))?;
            writeln!(out, "    up to                  {}  (six reversals a cycle)", forces(high))?;
            writeln!(out, "  two-reversal border      {}", forces(border.min_force_ratio()))?;
            writeln!(out, "    (between these two the body stops)")?;
        }
    }
    not_to_be_held(response.ratios().omega(), border.min_force_ratio(), out)?;
    if border.turning_point() < border.min_force_ratio() && !response.ratios().is_damped() {
        let eq_61 = digits(border.turning_point());
        writeln!(out, "    (eq. 61 gives {eq_61} r_y, which is too little below Ω = 1/2)")?;
    }
    match response.best_loop_size() {
        Some(size) if response.best_is_reached() => {
            writeln!(out, "  of maximum dissipation   {}", forces(response.best_force_ratio()))?;
            writeln!(out, "    with A₁ =              {}", digits(size))?;
            if size.to_f64() > ABSURD {
                writeln!(out, "    (Ω is too close to 1/(2n), where it is infinite, for any machine)")?;
            }
            Ok(())
        }
        None if response.best_is_reached() => {
            writeln!(
                out,
                "  of maximum dissipation   any above the minimum: at Ω = 1 the loop grows in every cycle"
            )
        }
        Some(_) | None => writeln!(
            out,
            "  of maximum dissipation   the minimum above; the optimum of eq. 65, {} r_y, would stick",
            digits(response.best_force_ratio())
        ),
    }
}

/// Beyond this a force ratio or a loop size is that of a pole, which no machine's frequency comes so close
/// to.
const ABSURD: f64 = 1e6;

/// Says so where Ω is so close to a pole that no machine can be held there.
fn not_to_be_held<F: Value>(omega: F, border: F, out: &mut impl Write) -> io::Result<()> {
    // Away from the poles the border is 1/Ω² or a few times that.
    if border.to_f64() * omega.to_f64() * omega.to_f64() > ABSURD {
        writeln!(out, "    (Ω is too close to 1/(2n+1), where the border is infinite, for any machine)")?;
    }
    Ok(())
}

/// With which forces the body does not stop, as the end of a sentence.
pub(crate) fn no_stop<F: Value>(found: &NoStop<F>, unit: &str) -> String {
    let border = digits(found.border());
    match found.six_reversals() {
        None => format!("at a force of {border} {unit} or more"),
        Some((low, high)) => format!(
            "at a force of {} to {} {unit}, where it reverses six times a cycle, and of {border} {unit} or more",
            digits(low),
            digits(high)
        ),
    }
}

/// From here on the turning point decides the border, `√(1 − ζ²)/2`.
fn exact_from<F: Value>(ratios: Ratios<F>) -> F {
    let (one, zeta) = (F::int(1), ratios.damping_ratio());
    if zeta < one { ((one - zeta) * (one + zeta)).sqrt() / F::int(2) } else { F::int(0) }
}

/// The note on a border, with the forces of six reversals a cycle where they were asked for.
pub(crate) fn border<F: Value>(
    answer: &Response<F>,
    found: Option<&NoStop<F>>,
    scales: Option<BorderScales<F>>,
    units: &System,
    out: &mut impl Write,
) -> io::Result<()> {
    let (omega, border) = (answer.ratios().omega(), answer.border());
    let forces = |x| both(x, "r_y", scales.map(|s| s.force), units.force());
    let lengths = |x| both(x, "B", scales.map(|s| s.length), units.length());
    let times = |x| both(x, "rad", scales.map(|s| s.time), "s");
    match found {
        None => {
            let least = digits(border.min_force_ratio());
            let cycle = "the cycle of two reversals does not stick at a force of";
            writeln!(out, "At Ω = {} {cycle} {least} r_y or more.\n", digits(omega))?;
        }
        Some(found) => {
            writeln!(out, "At Ω = {} the body does not stop {}.\n", digits(omega), no_stop(found, "r_y"))?;
        }
    }
    if answer.ratios().is_damped() {
        writeln!(out, "  damping ratio ζ          {}", digits(answer.ratios().damping_ratio()))?;
    }
    if let Some((low, high)) = found.and_then(NoStop::six_reversals) {
        writeln!(out, "  six reversals from       {}", forces(low))?;
        writeln!(out, "    up to                  {}", forces(high))?;
    }
    writeln!(out, "  two-reversal border      {}", forces(border.min_force_ratio()))?;
    not_to_be_held(omega, border.min_force_ratio(), out)?;
    writeln!(out, "  at the turning point     {}", forces(border.turning_point()))?;
    writeln!(
        out,
        "    (eq. 61{})",
        if omega >= exact_from(answer.ratios()) { ", exact here" } else { ", necessary only here" }
    )?;
    writeln!(out, "  minimum displacement     {}", lengths(border.least_displacement()))?;
    writeln!(out, "  velocity touches zero    {} after the maximum displacement", times(border.phase()))
}
