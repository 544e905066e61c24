//! The verdicts on a system in a sentence, as every front prints them.

use super::answer::kind_of;
use super::described::Described;
use stickslip::inputs::units::{Kind as Of, System as Units};
use stickslip::system::{Border, Steady, SteadyKind};
use stickslip::words::digits;

/// One of a thing in words, or several in digits.
#[must_use]
pub fn plural(count: usize, one: &str, several: &str) -> String {
    if count == 1 { format!("one {one}") } else { format!("{count} {several}") }
}

/// A number with the unit of its kind, where the units are known.
#[must_use]
pub fn with_unit(x: f64, units: Option<&Units>, kind: Of) -> String {
    units.map_or_else(|| digits(x), |system| format!("{} {}", digits(x), system.name(kind)))
}

/// The verdict on a steady motion.
#[must_use]
pub fn steady_verdict(described: &Described, found: &Steady<f64>) -> String {
    let kinds = described.model.elements.iter().map(kind_of);
    let rests = found.motion.elements.iter().zip(kinds).filter(|(_, kind)| *kind != "stop");
    let stops: usize = rests.map(|(element, _)| element.stops).sum();
    match found.kind {
        SteadyKind::Periodic => {
            let multiple = if found.periods == 1 {
                String::new()
            } else {
                format!(", {} periods of the loads", found.periods)
            };
            format!(
                "Periodic: it repeats itself after {}{multiple}, with {} in it.",
                with_unit(found.period, described.units.as_ref(), Of::Time),
                if stops == 0 { "no rest".to_owned() } else { plural(stops, "rest", "rests") }
            )
        }
        SteadyKind::Rest => "Rest: nothing moves in the end.".to_owned(),
        SteadyKind::Growing => "Growing: the motion grows without bound.".to_owned(),
        SteadyKind::Unsettled => format!(
            "Not settled after {} periods: the last of them changed the motion by {} of its size.",
            found.followed,
            digits(found.change)
        ),
    }
}

/// The verdict on the least load that keeps the contact from sticking.
#[must_use]
pub fn border_verdict(found: &Border<f64>) -> String {
    format!(
        "The contact never sticks if the load is at least {} times this one.",
        digits(found.least_load_factor)
    )
}
