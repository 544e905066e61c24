//! The verdicts on a system in a sentence, as every front prints them.

use super::answer::{is_hard, kind_of};
use super::described::Described;
use super::description::OfSliding;
use super::node::Number;
use super::tabled::{Digits, OfTable};
use crate::inputs::units::{Kind as Of, System as Units};
use crate::words::digits;
use std::f64::consts::TAU;
use stickslip::system::{Border, Element, EventKind, GREATEST_COEFFICIENT, Kind, Motion, Steady, SteadyKind};

/// One of a thing in words, or several in digits.
#[must_use]
pub fn plural(count: usize, one: &str, several: &str) -> String {
    if count == 1 { format!("one {one}") } else { format!("{count} {several}") }
}

/// A number with the unit of its kind, where the units are known.
#[must_use]
pub fn with_unit<F: Number>(x: F, units: Option<&Units>, kind: Of) -> String {
    units.map_or_else(
        || digits(x),
        |system| {
            let (unit, factor) = system.for_reading(kind);
            format!("{} {unit}", digits(factor.times(x)))
        },
    )
}

/// A frequency in words: in hertz where the units are known.
#[must_use]
pub fn frequency_of(omega: f64, units: Option<&Units>) -> String {
    if units.is_some() { format!("{} Hz", digits(omega / TAU)) } else { digits(omega) }
}

/// The verdict on steady sliding; none where no friction can make it unstable.
#[must_use]
pub fn sliding_verdict(found: &OfSliding, units: Option<&Units>) -> Option<String> {
    let rate = |x: f64| format!("{}{}", digits(x), if units.is_some() { "/s" } else { "" });
    let at = |omega: f64| {
        if omega > 0.0 {
            format!("oscillates at {}", frequency_of(omega, units))
        } else {
            "does not oscillate".into()
        }
    };
    let now = match found.growth {
        growth if growth > 0.0 => format!(
            "Steady sliding is unstable: a disturbance grows at the rate {} and {}.",
            rate(growth),
            at(found.frequency)
        ),
        _ if !found.is_coupled => return None,
        growth if growth < 0.0 => {
            format!("Steady sliding is stable: the slowest disturbance decays at the rate {}.", rate(-growth))
        }
        _ => "Steady sliding is stable: no disturbance grows.".to_owned(),
    };
    let Some(threshold) = found.threshold else {
        let none = format!(
            " No friction up to a coefficient of {GREATEST_COEFFICIENT} starts flutter or divergence."
        );
        return Some(if found.growth > 0.0 || !found.is_coupled { now } else { now + &none });
    };
    let from = threshold.coefficient.map_or_else(
        || format!("{} times these coefficients of friction", digits(threshold.factor)),
        |coefficient| format!("a coefficient of friction of {}", digits(coefficient)),
    );
    let how = if threshold.frequency > 0.0 {
        format!("It flutters from {from} on, at {}.", frequency_of(threshold.frequency, units))
    } else {
        format!("It diverges from {from} on.")
    };
    Some(format!("{now} {how}"))
}

/// What is known of the digits of an answer under laws that are curves.
#[must_use]
pub fn digits_sentence(digits: &Digits, units: Option<&Units>) -> String {
    let table = |of: &OfTable| {
        let within: f64 = format!("{:.1e}", of.within).parse().unwrap_or(of.within);
        let within = with_unit(within, units, Of::Force);
        let seen = if of.proved { "" } else { " at 17 points of each piece" };
        format!(
            "The law of {} is a table of {} pieces, within {within} of the curve{seen}. ",
            of.name, of.pieces
        )
    };
    let tables: String = digits.tables.iter().map(table).collect();
    let known = if digits.events_agree {
        "The digits are estimated from tables of half and a quarter of these pieces."
    } else {
        "The tables do not have the same events: the digits are those in which they agree, and the events are those of the finest table."
    };
    let greatest = |list: &[f64], of: Of| {
        let most = list.iter().copied().fold(0.0, f64::max);
        // Rounded upwards.
        let text = format!("{:.1e}", most * 1.05);
        with_unit(text.parse().unwrap_or(most), units, of)
    };
    let proved = digits.bound.as_ref().map_or_else(String::new, |bound| {
        let (displacement, velocity) = (greatest(&bound.displacement, Of::Length), greatest(&bound.velocity, Of::Velocity));
        format!(" It is proved that displacements are right within {displacement}, and velocities within {velocity}.")
    });
    let steady = digits.steady_bound.as_ref().map_or_else(String::new, |bound| {
        let (way, velocity) = (greatest(&bound.half_range, Of::Length), greatest(&bound.velocity_rms, Of::Velocity));
        format!(" It is proved of every motion with this period that its velocities are within {velocity} of those under the table in the root mean square, and that half the distance between the extremes of a displacement is right within {way}.")
    });
    format!("{tables}{known}{proved}{steady}")
}

/// The verdict on a steady motion.
#[must_use]
pub fn steady_verdict(described: &Described, found: &Steady<f64>) -> String {
    let units = described.units.as_ref();
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
            let blows: usize = found.motion.elements.iter().map(|element| element.blows).sum();
            let has_hard = described.model.elements.iter().any(is_hard);
            let blows = match blows {
                _ if !has_hard => String::new(),
                0 => " and no blow".to_owned(),
                blows => format!(" and {}", plural(blows, "blow", "blows")),
            };
            format!(
                "Periodic: it repeats itself after {}{multiple}, with {}{blows} in it.{}{}",
                with_unit(found.period, units, Of::Time),
                if stops == 0 { "no rest".to_owned() } else { plural(stops, "rest", "rests") },
                drift_sentence(described, found),
                grazing_sentence(described, &found.motion)
            ) + choice_sentence(found)
        }
        SteadyKind::Rest => format!("Rest: nothing moves in the end.{}", choice_sentence(found)),
        SteadyKind::Uniform => {
            let drift = drift_sentence(described, found);
            format!("Uniform: all velocities are constant.{drift}{}", choice_sentence(found))
        }
        SteadyKind::Growing => "Growing: the motion grows without bound.".to_owned(),
        SteadyKind::Unsettled => format!(
            "Not settled after {} periods: the last of them changed the motion by {} of its size.{}",
            found.followed,
            digits(found.change),
            decay_sentence(found) + irregular_sentence(found)
        ),
    }
}

/// The growth of a disturbance by which rounding errors become about a thousandth of the motion, enough to lead to another one.
const CHOSEN_BY_ROUNDING: f64 = 1e12;

/// Whether rounding may have chosen between this motion and others on the way to it.
fn choice_sentence(found: &Steady<f64>) -> &'static str {
    if found.disturbance_growth < CHOSEN_BY_ROUNDING {
        return "";
    }
    " On the way to it rounding errors become as large as the motion: they may have chosen between it and other motions."
}

/// Whether rounding decides the states of a motion that does not settle.
fn irregular_sentence(found: &Steady<f64>) -> &'static str {
    if found.disturbance_growth < CHOSEN_BY_ROUNDING {
        return "";
    }
    " The motion is irregular: small disturbances become as large as it is, so that rounding decides its states."
}

/// The part of a motion's displacement within which a stop is grazed. A body that goes so far beyond its gap has the root of that part of its
/// velocity there.
const GRAZED: f64 = 1e-6;

/// The stops with a restitution that a motion only just reaches, or only just misses.
fn grazing_sentence(described: &Described, motion: &Motion<f64>) -> String {
    let largest = |a: &[f64], b: &[f64]| a.iter().chain(b).fold(0.0f64, |most, x| most.max(x.abs()));
    let speed = largest(&motion.max_velocity, &motion.min_velocity);
    let size = largest(&motion.max_displacement, &motion.min_displacement);
    let grazed = |(i, element): (usize, &Element<f64>)| {
        let Kind::HardStop { gap, .. } = element.kind else { return None };
        let own = || motion.events.iter().filter(|event| event.element == i);
        // Blows that end in contact become ever smaller.
        if own().any(|event| event.kind != EventKind::Blow) {
            return None;
        }
        let weakest = own().filter_map(|event| event.velocities).map(|pair| pair.0).reduce(f64::min);
        let is_grazed = match weakest {
            Some(weakest) => weakest <= GRAZED.sqrt() * speed,
            None => {
                let far = |(i, b): (usize, &f64)| {
                    let list = if *b > 0.0 { &motion.max_displacement } else { &motion.min_displacement };
                    b * list.get(i).copied().unwrap_or(0.0)
                };
                let sides = element.direction.iter().enumerate().filter(|(_, b)| **b != 0.0);
                let reach: Vec<f64> = sides.map(far).collect();
                // Of two bodies that move, the sum of both is no distance.
                matches!(reach.as_slice(), [one] if (gap - one).abs() <= GRAZED * size)
            }
        };
        is_grazed.then(|| {
            format!(
                " The motion grazes {}: there a small disturbance may be multiplied without bound, and no multiplier says how.",
                element.name
            )
        })
    };
    described.model.elements.iter().enumerate().filter_map(grazed).collect()
}

/// How fast the change of a motion falls that has not settled, and how much of it is left.
fn decay_sentence(found: &Steady<f64>) -> String {
    let decay = found.decay;
    if !(decay > 0.0 && decay < 1.0) {
        return String::new();
    }
    let (falls, left) = (digits(100.0 * (1.0 - decay)), digits(found.change * decay / (1.0 - decay)));
    format!(" The change falls by {falls} % a period; {left} of the size is left.")
}

/// Where a motion drifts to, coordinate by coordinate; nothing without a drift.
fn drift_sentence(described: &Described, found: &Steady<f64>) -> String {
    let units = described.units.as_ref();
    let moves = |speed: f64| speed != 0.0;
    let of = |(name, by, speed): (&String, f64, f64)| {
        let mean = with_unit(speed, units, Of::Velocity);
        if by == 0.0 {
            format!("{name} moves at {mean}")
        } else {
            format!("{name} drifts by {} a period, {mean} in the mean", with_unit(by, units, Of::Length))
        }
    };
    let part = |list: &[f64], place: usize| list.get(place).copied().unwrap_or(0.0);
    let at = |(i, name)| (name, part(&found.drift, i), part(&found.mean_velocity, i));
    let parts: Vec<String> =
        described.listed().map(at).filter(|(_, _, speed)| moves(*speed)).map(of).collect();
    if parts.is_empty() { String::new() } else { format!(" {}.", parts.join("; ")) }
}

/// The verdict on the least load that keeps the contact from sticking, by the names of the contact and of the loaded
/// coordinates.
#[must_use]
pub fn border_verdict(described: &Described, found: &Border<f64>) -> String {
    let contact = described.model.elements.iter().find(|element| kind_of(element) == "contact");
    // A contact that is called so needs no second name.
    let contact = match contact.map_or("", |element| element.name.as_str()) {
        "" | "contact" => "the contact".to_owned(),
        name => format!("the contact {name}"),
    };
    let part = |list: &[f64], i: usize| list.get(i).copied().unwrap_or(0.0);
    let is_loaded =
        |i: usize| described.model.harmonics.iter().any(|h| part(&h.sin, i) != 0.0 || part(&h.cos, i) != 0.0);
    let loaded: Vec<&str> = described
        .coordinates
        .iter()
        .enumerate()
        .filter(|(i, _)| is_loaded(*i))
        .map(|(_, name)| name.as_str())
        .collect();
    let load = match (&described.base, loaded.as_slice()) {
        (Some(_), _) => "the motion of the base".to_owned(),
        (None, [one]) => format!("the load on {one}"),
        (None, [first, second]) => format!("the load on {first} and {second}"),
        (None, _) => "the load".to_owned(),
    };
    let least = digits(found.least_load_factor);
    match found.least_load_factor_from_rest {
        None => {
            let contact = contact.replacen('t', "T", 1);
            format!("{contact} never sticks if {load} is at least {least} times this one.")
        }
        Some(release) => format!(
            "Once it slides, {contact} never sticks if {load} is at least {least} times this one. From rest it starts to slide \
             if {load} is at least {} times this one.",
            digits(release)
        ),
    }
}
