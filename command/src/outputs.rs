//! The table of outputs: the library's definitions, and those of the command's own columns.

use crate::failure::Outcome;
use std::fmt::Write as _;
use std::io::Write;
use stickslip::internal::{ResponseAnswer, definitions as d};
use stickslip::motion::SteadyAnswer;
use stickslip::{Definition, Measure, Output as O};
use stickslip_front::quantities::{self, Quantity};

/// The name of a column, with its unit and its meaning.
pub(crate) type Key = &'static Definition;

/// A column without a unit, which the table of outputs does not list.
macro_rules! key {
    ($name:literal) => {
        const { &stickslip::Definition::new($name, stickslip::Measure::Plain, "") }
    };
}
pub(crate) use key;

stickslip::define! {
    pub(crate) OMEGA("omega", One, "frequency ratio Ω = ω_d/ω_n").title("frequency ratio Ω");
    pub(crate) ALPHA("alpha", One, "force ratio α = p₀/r_y").title("force ratio α");
    pub(crate) DAMPING_RATIO("damping_ratio", One, "damping ratio ζ = c/(2√(k m)), where damping was given");
    pub(crate) STATIC_FRICTION_RATIO("static_friction_ratio", One,
        "static friction ratio η = r_s/r_y, where static friction was given");
    pub(crate) ATTRACTOR("attractor", Plain,
        "number of the limit, in the order of the first starts (limit is unstable where a multiplier is beyond 1)");
    pub(crate) SHARE("share", One, "fraction of the starts that lead to the limit");
    pub(crate) STARTS("starts", Plain, "number of the starts that lead to the limit");
    pub(crate) FIRST_X("first_x", Length, "displacement of the first start that leads to the limit, at ω_d t = 0");
    pub(crate) FIRST_V("first_v", Velocity, "velocity of the first start that leads to the limit");
    pub(crate) MIRROR("mirror", Plain, "number of the limit that is the mirror image of this one");
    pub(crate) REST_FROM("rest_from", Length, "lowest position of rest, or middle of a member of a family");
    pub(crate) REST_TO("rest_to", Length, "highest position of rest");
    pub(crate) KIND("kind", Plain, "slide-forward, slide-backward or stick");
    pub(crate) ENDS_BY("ends_by", Plain, "reversal, stop, grazing, release, never, or end (of the time that was asked for)");
    pub(crate) START_CYCLE("start_cycle", Plain, "whole cycles of the drive before the start, likewise end_cycle and cycle");
    pub(crate) START_PHASE("start_phase", Angle, "phase ω_d t of the start in its cycle, likewise end_phase and phase");
    pub(crate) DURATION("duration", Angle, "length of the segment, in ω_d t");
    pub(crate) START_X("start_x", Length, "displacement at the start, likewise end_x and x");
    pub(crate) START_V("start_v", Velocity, "velocity at the start, likewise v");
    pub(crate) FRICTION("friction", Force, "friction force r_a of eq. 1, in the direction of sliding: the force on the body is its opposite");
    pub(crate) R("r", Force, "force of spring and friction, r = x + r_a");
}

/// The outputs of the closed forms, those of the border among them.
const CLOSED_FORMS: [Key; 20] = [
    d::REGIME,
    d::MOTION_WITHOUT_STOP,
    d::MOVES_FROM_REST,
    O::MaxDisplacement.definition(),
    O::DisplacementPhase.definition(),
    O::MaxVelocity.definition(),
    O::VelocityPhase.definition(),
    O::Deviation.definition(),
    O::MinForceRatio.definition(),
    O::MinForceRatioTurningPoint.definition(),
    O::LoopSizeStiffness.definition(),
    O::LoopSizeInertia.definition(),
    O::BestForceRatio.definition(),
    O::BestLoopSize.definition(),
    d::BEST_FORCE_RATIO_SLIDES,
    O::Contraction.definition(),
    d::DAMPER_WORK,
    O::BorderPhase.definition(),
    O::LeastDisplacement.definition(),
    d::NO_STOP_FORCE_RATIOS,
];

/// The outputs in ratios, grouped by the first command that has them.
fn groups() -> [(&'static str, Vec<Key>); 7] {
    let others =
        |key: &Key, listed: &[Key]| !CLOSED_FORMS.iter().chain(listed).any(|own| own.name == key.name);
    let response = ResponseAnswer::<f64>::COLUMNS.map(|column| column.definition);
    let loads: Vec<_> = response.into_iter().filter(|key| others(key, &[])).collect();
    let steady = SteadyAnswer::<f64>::COLUMNS.map(|column| column.definition);
    let steady = steady.into_iter().filter(|key| others(key, &loads)).collect();
    [
        ("What was asked", vec![OMEGA, ALPHA, DAMPING_RATIO, STATIC_FRICTION_RATIO]),
        (
            "response, border: the steady motion with two reversals a cycle, in closed form",
            CLOSED_FORMS.to_vec(),
        ),
        ("response, steady: the loads on the machine and its support", loads),
        ("steady: the exact steady motion, stops included", steady),
        (
            "attractors: one limit a row, with --unstable also motions that no start leads to",
            vec![ATTRACTOR, SHARE, STARTS, FIRST_X, FIRST_V, MIRROR, REST_FROM, REST_TO],
        ),
        (
            "simulate: one segment a row, or one sample with --samples",
            vec![KIND, ENDS_BY, START_CYCLE, START_PHASE, DURATION, START_X, START_V, FRICTION, R],
        ),
        (
            "map: in addition",
            vec![
                O::Margin.definition(),
                const { &Definition::new("stops", Measure::Plain, "stops in a cycle of the exact motion") },
            ],
        ),
    ]
}

/// The outputs of a machine, under `physical` in JSON: in the units named there, or in brackets after the
/// column's name. Its quantities stand between the drive and what follows from the outputs in ratios.
const PHYSICAL: [&str; 2] = [
    "\
For a machine, under physical, each with its unit

  drive                          the drive: a force, a rotating unbalance, the spring's support, or a base that carries the surface
",
    "  displacement_time, velocity_time, …_time
                                 the instant in the cycle of the force, phase/ω_d
  min_force, min_force_turning_point, best_force, no_stop_forces
                                 the force ratios of these names times r_y
  energy_per_cycle               energy that friction dissipates in a cycle, 4 r_y Δ₀
  damper_energy_per_cycle        energy that the damper dissipates, on a moving support by the velocity between body and support
  best_force_energy              friction's energy in a cycle at best_force
  followed_for                   time for which the exact motion was followed
",
];

/// The outputs of the motion under a record.
const RECORD: &str = "\
record, spectrum: the motion under a record, each with its unit

  max_displacement               most positive displacement from the relaxed spring, and over the surface where that moves
  min_displacement               most negative displacement
  max_velocity, min_velocity     most positive and most negative velocity
  peak_displacement              peak displacement, regardless of sign
  …_time                         time at which the motion has that value first, none where it only tends to it
  max_absolute_acceleration      peak acceleration in space, regardless of sign
  max_transmitted_force          peak force of spring, damper and friction together on their support
  end_displacement, end_velocity
                                 state at the end of the record
  residual_displacement          displacement at rest after the record or its limit, none where the body never rests
  cut_time                       time up to which a motion that never ends is followed, none where it ends
  path                           path of the body, to its rest or its limit
  slides                         number of slides: motion in one direction
  stops, reversals               numbers of slides that end with a rest, and of those that a slide back follows at once
  stick_time                     time at rest during the record
  cycle_amplitude                half the distance D between the turning points of the longest swing: the greatest cycle
  equivalent_stiffness           stiffness k + r/D of the oscillator with the forces of this cycle at its turning points
  equivalent_damping_ratio       damping ratio of this oscillator, with which it dissipates the energy of this cycle, E/(2π k_eq D²)
  friction_work, damper_work     work dissipated by friction and by the damper, which may stand on the moving support
  load_work                      work of the load and of a constant force on the body
  friction                       in the file of --out: the friction force on the body, against its motion
";

/// The definition of an output in ratios.
pub(crate) fn find(name: &str) -> Option<Key> {
    groups().into_iter().flat_map(|(_, keys)| keys).find(|key| key.name == name)
}

/// Whether an output needs a search of its own; `wanted` is its name, or for a machine's units
/// `physical.NAME` or `NAME[unit]`.
pub(crate) fn is_searched(wanted: &str) -> bool {
    let name = wanted.strip_prefix("physical.").unwrap_or(wanted);
    name.split('[').next().and_then(find).is_some_and(|key| key.is_searched)
}

/// The name of an output as text for a title.
pub(crate) fn in_words(name: &str) -> String {
    match find(name).map(|key| key.title).filter(|title| !title.is_empty()) {
        Some(title) => title.to_owned(),
        None => name.replace('_', " ").replace("max ", "peak ").replace("min ", "minimum "),
    }
}

/// A unit in plain characters, for the columns of a table.
pub(crate) fn plain(unit: &str) -> String {
    unit.replace("ω_d", "wd").replace('π', "pi").replace('²', "^2").replace('·', "*")
}

/// The whole table as text.
pub(crate) fn text() -> String {
    let mut text = String::new();
    for (title, keys) in groups() {
        let _ = writeln!(text, "{title}\n");
        for key in keys {
            let unit = if key.measure == Measure::Plain { "–" } else { key.measure.unit() };
            let _ = writeln!(text, "  {:<31}{unit:<9}{}", key.name, key.text());
        }
        text.push('\n');
    }
    let [drive, further] = PHYSICAL;
    let _ = write!(text, "{RECORD}\n{drive}");
    for Quantity { name, meaning, .. } in quantities::ALL {
        let _ = writeln!(text, "  {name:<31}{meaning}");
    }
    text + further
}

/// `stickslip outputs`.
pub(crate) fn run(out: &mut impl Write) -> Outcome {
    Ok(out.write_all(text().as_bytes())?)
}

#[cfg(test)]
mod tests {
    use super::in_words;

    #[test]
    fn titles_are_in_words() {
        assert_eq!(in_words("stick_fraction"), "fraction of time at rest");
        assert_eq!(in_words("max_acceleration"), "peak acceleration");
        assert_eq!(in_words("damper_energy_per_cycle"), "damper energy per cycle");
    }
}
