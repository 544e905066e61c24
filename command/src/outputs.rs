//! The table of outputs: every column and key, with its unit and its meaning.

use crate::failure::Outcome;
use std::fmt::Write as _;
use std::io::Write;

/// Name, unit and meaning of an output.
pub(crate) type Entry = (&'static str, &'static str, &'static str);

/// The outputs in ratios, by the first command that has them.
pub(crate) const GROUPS: &[(&str, &[Entry])] = &[
    (
        "What was asked",
        &[
            ("omega", "1", "frequency ratio Ω = ω_d/ω_n"),
            ("alpha", "1", "force ratio α = p₀/r_y"),
            ("damping_ratio", "1", "damping ratio ζ = c/(2√(k m)), where damping was given"),
            (
                "static_friction_ratio",
                "1",
                "static friction ratio η = r_s/r_y, where static friction was given",
            ),
        ],
    ),
    (
        "response, border: the steady motion with two reversals a cycle, in closed form",
        &[
            (
                "regime",
                "",
                "what the body does: non-sticking, sticking, stuck or unbounded, or depends-on-start where static \
                 friction leaves it to the start",
            ),
            (
                "motion_without_stop",
                "",
                "whether a motion without a stop exists and attracts its neighbourhood, where static friction was given",
            ),
            (
                "moves_from_rest",
                "",
                "whether a body at rest is released, α > η, where static friction was given",
            ),
            ("max_displacement", "B", "maximum displacement Δ₀ (eq. 44)"),
            ("displacement_phase", "rad", "phase ω_d t₂ of the maximum displacement (eq. 43)"),
            ("max_velocity", "B ω_d", "maximum velocity V₀ (eq. 49)"),
            ("velocity_phase", "rad", "phase ω_d t₁ of the maximum velocity (eq. 46)"),
            ("deviation", "B", "displacement Δ₁ at the maximum velocity (eq. 47)"),
            ("min_force_ratio", "1", "minimum force ratio α_min without sticking"),
            ("min_force_ratio_turning_point", "1", "the same by eq. 61, which falls short below Ω = 1/2"),
            ("loop_size_stiffness", "1", "friction's energy in a cycle per p₀²/(2k), A₁ (eq. 64)"),
            ("loop_size_inertia", "1", "the same per p₀²/(2 m ω_d²), A₂ (eq. 67)"),
            ("best_force_ratio", "1", "force ratio α* of the largest A₁ (eq. 65)"),
            ("best_loop_size", "1", "that largest A₁ (eq. 66)"),
            ("best_force_ratio_slides", "", "whether the body slides at α*"),
            ("contraction", "1", "fraction of a disturbance that remains after half a cycle"),
            ("damper_work", "r_y B", "energy that the damper dissipates in a cycle, where damping was given"),
            (
                "border_phase",
                "rad",
                "phase after the maximum displacement at which the velocity first touches zero, on the border",
            ),
            ("least_displacement", "B", "maximum displacement on the border"),
            ("no_stop_force_ratios", "1", "force ratios without any stop, as intervals (border --no-stop)"),
        ],
    ),
    (
        "response, steady: the loads on the machine and its support",
        &[
            ("reversals_per_cycle", "", "reversals in a cycle: 2, or 6 close to Ω = 1/3, 1/5, …"),
            (
                "dynamic_amplification",
                "1",
                "maximum displacement over p₀/k: compares machines of different friction",
            ),
            ("max_acceleration", "B ω_d²", "maximum acceleration |x″|"),
            (
                "transmitted_force",
                "r_y",
                "maximum force of spring, damper and friction on their support, or m x″ with a moving foot",
            ),
            (
                "transmissibility",
                "1",
                "that force over p₀, or with a moving foot or base the body's absolute acceleration over that of the foot or base",
            ),
            (
                "max_absolute_displacement",
                "B",
                "maximum absolute displacement, with a base that carries the surface",
            ),
        ],
    ),
    (
        "steady: the exact steady motion, stops included",
        &[
            (
                "limit",
                "",
                "periodic, family (one of many, by the start), rest, irregular, none or not-converged",
            ),
            ("max_displacement_phase", "rad", "phase ω_d t of the maximum displacement"),
            ("min_displacement", "B", "minimum displacement"),
            ("min_displacement_phase", "rad", "its phase"),
            ("max_velocity_phase", "rad", "phase of the maximum velocity"),
            ("min_velocity", "B ω_d", "minimum velocity"),
            ("min_velocity_phase", "rad", "its phase"),
            ("sticks_per_cycle", "", "stops in a cycle"),
            ("velocity_zeros_per_cycle", "", "instants of zero velocity in a cycle, a stop being one"),
            ("stick_fraction", "1", "fraction of time at rest"),
            ("error_1", "1", "|max x + min x|/max x: 0 for a symmetric motion, as are the other three"),
            ("error_2", "1", "difference of the phases of max x and min x, less half a turn, in turns"),
            ("error_3", "1", "|max x′ + min x′|/max x′"),
            ("error_4", "1", "error_2 of the velocities"),
            ("energy_in", "r_y B", "work of the drive in a cycle"),
            (
                "energy_out",
                "r_y B",
                "work against friction in a cycle, without damper_work where damping was given",
            ),
            ("multipliers", "1", "Floquet multipliers of a cycle, as pairs of real and imaginary part"),
            ("distance", "B", "estimated distance of the motion found from the limit"),
            ("rest_position", "B", "where the body comes to rest for good"),
            ("periods", "2π/ω_d", "periods of the drive that were followed"),
            (
                "turns_per_cycle",
                "",
                "turns of the drive in a cycle (this and the next four outputs where static friction was given)",
            ),
            ("symmetric", "", "whether half a cycle is the mirror image of the other half: true or false"),
            ("lyapunov_exponent", "1", "Lyapunov exponent of an irregular motion, per turn of the drive"),
            ("lyapunov_exponent_error", "1", "its standard error"),
            ("turns_observed", "", "turns of the drive over which an irregular motion was observed"),
        ],
    ),
    (
        "attractors: one limit a row, with --unstable also motions that no start leads to",
        &[
            (
                "attractor",
                "",
                "its number, in the order of the first starts (limit is unstable where a multiplier is beyond 1)",
            ),
            ("share", "1", "fraction of the starts that lead to it"),
            ("starts", "", "number of these starts"),
            ("first_x", "B", "displacement of the first of them, at ω_d t = 0"),
            ("first_v", "B ω_d", "its velocity"),
            ("mirror", "", "number of the limit that is the mirror image of this one"),
            ("rest_from", "B", "lowest position of rest, or middle of a member of a family"),
            ("rest_to", "B", "highest position of rest"),
        ],
    ),
    (
        "simulate: one segment a row, or one sample with --samples",
        &[
            ("kind", "", "slide-forward, slide-backward or stick"),
            ("ends_by", "", "reversal, stop, grazing, release or never"),
            ("start_cycle", "", "whole cycles of the drive before the start, likewise end_cycle and cycle"),
            ("start_phase", "rad", "phase ω_d t of the start in its cycle, likewise end_phase and phase"),
            ("duration", "rad", "length of the segment, in ω_d t"),
            ("start_x", "B", "displacement at the start, likewise end_x and x"),
            ("start_v", "B ω_d", "velocity at the start, likewise v"),
            ("friction", "r_y", "force of friction"),
            ("r", "r_y", "force of spring and friction"),
        ],
    ),
    (
        "map: in addition",
        &[
            ("margin", "1", "force over the minimum force without sticking, α/α_min"),
            ("stops", "", "stops in a cycle of the exact motion"),
        ],
    ),
];

/// The outputs of a machine, under `physical` in JSON: in the units named there, or in brackets after the
/// column's name.
pub(crate) const PHYSICAL: &[(&str, &str)] = &[
    ("drive", "the drive: a force, the spring's foot, or a base that carries the surface"),
    ("frequency", "frequency of the drive in Hz"),
    ("angular_frequency", "ω_d"),
    ("natural_frequency", "ω_n = √(k/m)"),
    ("period", "natural period 2π/ω_n"),
    ("mass, stiffness, friction, damping", "m, k, r_y, c"),
    ("friction_backward", "r₋, where it was given (friction is then r₊)"),
    ("friction_bound", "r_y = (r₊ + r₋)/2, where friction differs by direction"),
    (
        "static_friction",
        "r_s = η r_y, where it was given, or η r_y ± (r₊ − r₋)/2 where friction differs by direction",
    ),
    ("friction_coefficient", "µ = r_y/(m g), where it was given"),
    ("force_amplitude", "amplitude p₀ of the force on the body"),
    ("foot_displacement", "amplitude of the spring's foot"),
    ("damped_foot_displacement", "amplitude of the foot of spring and damper"),
    ("lead_time", "the time by which the force on the body is ahead of that foot, atan(c ω_d/k)/ω_d"),
    ("base_displacement, base_velocity, base_acceleration", "amplitudes of a base that carries the surface"),
    ("friction_displacement", "B = r_y/k, the unit of length of the ratios"),
    (
        "mean_force",
        "constant force p̄ on the body, where it was given (transmitted_force does not include it)",
    ),
    (
        "mean_displacement",
        "(p̄ − (r₊ − r₋)/2)/k, from which displacements are measured, where p̄ or r₋ was given",
    ),
    ("displacement_time, velocity_time, …_time", "the instant in the cycle of the force, phase/ω_d"),
    (
        "min_force, min_force_turning_point, best_force, no_stop_forces",
        "the force ratios of these names times r_y",
    ),
    ("energy_per_cycle", "energy that friction dissipates in a cycle, 4 r_y Δ₀"),
    (
        "damper_energy_per_cycle",
        "energy that the damper dissipates, except where it stands on the moving foot",
    ),
    ("best_force_energy", "friction's energy in a cycle at best_force"),
    ("followed_for", "time for which the exact motion was followed"),
];

/// Text for the title of a picture, where the name itself is not clear.
const TITLES: &[(&str, &str)] = &[
    ("omega", "frequency ratio Ω"),
    ("alpha", "force ratio α"),
    ("displacement_phase", "phase of the maximum displacement"),
    ("velocity_phase", "phase of the maximum velocity"),
    ("deviation", "displacement at the maximum velocity"),
    ("min_force_ratio", "minimum force ratio without sticking"),
    ("min_force_ratio_turning_point", "minimum force ratio by eq. 61"),
    ("loop_size_stiffness", "loop size A₁"),
    ("loop_size_inertia", "loop size A₂"),
    ("best_force_ratio", "force ratio of the largest loop"),
    ("best_loop_size", "size of the largest loop"),
    ("best_force_ratio_slides", "sliding at the force ratio of the largest loop"),
    ("contraction", "fraction of a disturbance that remains after half a cycle"),
    ("damper_work", "energy dissipated by the damper in a cycle"),
    ("border_phase", "phase of the first stop on the border"),
    ("least_displacement", "maximum displacement on the border"),
    ("sticks_per_cycle", "stops in a cycle"),
    ("velocity_zeros_per_cycle", "velocity zeros in a cycle"),
    ("reversals_per_cycle", "reversals in a cycle"),
    ("stick_fraction", "fraction of time at rest"),
    ("error_1", "asymmetry of the displacements"),
    ("error_2", "asymmetry of the displacement phases"),
    ("error_3", "asymmetry of the velocities"),
    ("error_4", "asymmetry of the velocity phases"),
    ("energy_in", "work of the drive in a cycle"),
    ("energy_out", "work against friction in a cycle"),
    ("distance", "distance from the limit"),
    ("periods", "periods of the drive followed"),
];

/// The name of an output as text for a title.
pub(crate) fn in_words(name: &str) -> String {
    match TITLES.iter().find(|(own, _)| *own == name) {
        Some((_, words)) => (*words).to_owned(),
        None => name.replace('_', " ").replace("max ", "maximum ").replace("min ", "minimum "),
    }
}

/// The entry of an output in ratios.
pub(crate) fn entry(name: &str) -> Option<&'static Entry> {
    GROUPS.iter().flat_map(|(_, entries)| *entries).find(|(own, ..)| *own == name)
}

/// The unit of an output in ratios, by its name; `None` for text and counts.
pub(crate) fn unit_of(name: &str) -> Option<&'static str> {
    let whole = entry(name).or_else(|| {
        // Parts of a pair or of an interval.
        let ends = ["_1_re", "_1_im", "_2_re", "_2_im", "_1_low", "_1_high", "_2_low", "_2_high"];
        ends.iter().find_map(|end| entry(name.strip_suffix(end)?))
    });
    whole.map(|(_, unit, _)| *unit).filter(|unit| !unit.is_empty())
}

/// A unit in plain characters, for the columns of a table.
pub(crate) fn plain(unit: &str) -> String {
    unit.replace("ω_d", "wd").replace('π', "pi").replace('²', "^2").replace('·', "*")
}

/// The whole table as text.
pub(crate) fn text() -> String {
    let mut text = String::new();
    for (title, entries) in GROUPS {
        let _ = writeln!(text, "{title}\n");
        for (name, unit, meaning) in *entries {
            let _ = writeln!(text, "  {name:<31}{:<9}{meaning}", if unit.is_empty() { "–" } else { unit });
        }
        text.push('\n');
    }
    text.push_str("For a machine, under physical, each with its unit\n\n");
    for (name, meaning) in PHYSICAL {
        if name.chars().count() > 29 {
            let _ = writeln!(text, "  {name}\n  {:<31}{meaning}", "");
        } else {
            let _ = writeln!(text, "  {name:<31}{meaning}");
        }
    }
    text
}

/// `stickslip outputs`.
pub(crate) fn run(out: &mut impl Write) -> Outcome {
    Ok(out.write_all(text().as_bytes())?)
}

#[cfg(test)]
mod tests {
    use super::{TITLES, entry, in_words};

    #[test]
    fn titles_are_of_outputs_and_in_words() {
        assert!(TITLES.iter().all(|(name, _)| entry(name).is_some()));
        assert_eq!(in_words("stick_fraction"), "fraction of time at rest");
        assert_eq!(in_words("max_acceleration"), "maximum acceleration");
    }
}
