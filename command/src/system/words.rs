//! A system and its steady motion in words.

use crate::args::SystemArgs;
use crate::bits::{Value, digits};
use crate::failure::Outcome;
use crate::note::line;
use crate::output;
use crate::row::Number;
use std::io::Write;
use stickslip::system::{
    Beyond, Border, Cycle, Element, Kind, Law, Model, Motion, MovedBy, Steady, SteadyKind,
};
use stickslip_front::inputs::units::{Kind as Of, System as Units};
use stickslip_front::system::{
    Described, Description, Digits, MOST_LISTED, NamedSystem, border_verdict, digits_sentence, frequency_of,
    is_contact, is_hard, kind_of, plural, sliding_verdict, steady_verdict, with_unit,
};

/// A natural frequency, or the growth of a direction whose stiffness is negative.
fn own(units: Option<&Units>, omega: f64) -> String {
    if omega >= 0.0 {
        return frequency_of(omega, units);
    }
    let per = if units.is_some() { "/s" } else { "" };
    format!("unstable (grows at the rate {}{per})", digits(-omega))
}

/// What the file describes, with natural frequencies free and with contacts at rest.
pub(super) fn describe(asked: &NamedSystem, args: &SystemArgs, out: &mut impl Write) -> Outcome {
    let described = &asked.described;
    let below = args.frequencies_below.as_deref();
    let below =
        below.map(|text| asked.reader().value("--frequencies-below", text, Of::Frequency)).transpose()?;
    if let (Some(text), Some(_)) = (&args.frequencies_below, below.filter(|bound| *bound <= 0.0)) {
        return Err(format!("--frequencies-below {text}: must be > 0").into());
    }
    let description = Description::new(asked);
    if super::is_json(args)? {
        let shown = match below {
            Some(bound) => description.below(bound),
            None => description,
        };
        return output::json(&shown, out);
    }
    let elements = &described.model.elements;
    let Description {
        natural_frequencies: free, natural_frequencies_stuck: stuck, rigid_modes: rigid, ..
    } = &description;
    let units = described.units.as_ref();
    let count = |kind: &str| elements.iter().filter(|element| kind_of(element) == kind).count();
    let mut parts = vec![plural(described.coordinates.len(), "coordinate", "coordinates")];
    for (kind, one, several) in [
        ("contact", "contact", "contacts"),
        ("elastic", "elastic contact", "elastic contacts"),
        ("stop", "stop", "stops"),
        ("spring", "spring with a law", "springs with laws"),
    ] {
        if count(kind) > 0 {
            parts.push(plural(count(kind), one, several));
        }
    }
    writeln!(out, "A system of {}.\n", parts.join(", "))?;
    for (i, name) in described.listed() {
        let mass = described.model.mass.get(i).and_then(|row| row.get(i)).copied().unwrap_or(0.0);
        let moved = described.model.moved.iter().find(|moved| moved.coordinate == i);
        let text = match moved.map(|moved| moved.by) {
            Some(MovedBy::Displacement) => "moved by its displacement".to_owned(),
            Some(MovedBy::Velocity) => "moved by its velocity".to_owned(),
            Some(MovedBy::Acceleration) => "moved by its acceleration".to_owned(),
            None => with_unit(mass, units, Of::Mass),
        };
        line(out, name, text)?;
    }
    more_coordinates(described, out)?;
    for (place, element) in elements.iter().enumerate().take(MOST_LISTED) {
        line(out, &element.name, of_element(element, place, described, units))?;
    }
    more(elements.len(), "contacts, stops and springs: all of them are in --format json", out)?;
    for (name, &force) in described.coordinates.iter().zip(&described.model.constant) {
        if force != 0.0 {
            line(out, "load", format!("{} on {name}, constant", with_unit(force, units, Of::Force)))?;
        }
    }
    for record in &described.model.records {
        let end = record.times.last().copied().unwrap_or(0.0);
        let end = with_unit(end, units, Of::Time);
        let text = match record.beyond {
            Beyond::Repeat => format!("record of {} samples to {end}, again and again", record.values.len()),
            Beyond::Zero | Beyond::Hold => format!("record of {} samples to {end}", record.values.len()),
        };
        line(out, "load", text)?;
    }
    for harmonic in &described.model.harmonics {
        let on = |place: usize| {
            let part = |list: &[f64]| list.get(place).copied().unwrap_or(0.0);
            let amplitude = part(&harmonic.sin).hypot(part(&harmonic.cos));
            let name = described.coordinates.get(place)?;
            (amplitude > 0.0).then(|| format!("{} on {name}", with_unit(amplitude, units, Of::Force)))
        };
        let loads: Vec<_> = (0..described.coordinates.len()).filter_map(on).collect();
        let at = frequency_of(harmonic.frequency, units);
        line(
            out,
            "load",
            format!("{} at {at}", if loads.is_empty() { "none".into() } else { loads.join(", ") }),
        )?;
    }
    let list = |frequencies: &[f64]| {
        let within = frequencies.iter().filter(|omega| below.is_none_or(|bound| **omega <= bound));
        let mut texts: Vec<_> = within.take(MOST_LISTED).map(|omega| own(units, *omega)).collect();
        let left = frequencies.len().saturating_sub(texts.len());
        if texts.is_empty() {
            texts.push("none".to_owned());
        }
        if let Some(last) = frequencies.last().filter(|_| left > 0) {
            texts.push(format!("{left} more up to {}", own(units, *last)));
        }
        texts.join(", ")
    };
    writeln!(out, "\nNatural frequencies, without dampers")?;
    let has_contacts = elements.iter().any(is_contact);
    line(out, if has_contacts { "all contacts sliding" } else { "free" }, list(free))?;
    if elements.len() > 1 {
        let contacts = description.elements.iter().zip(elements).filter(|(_, element)| is_contact(element));
        for (found, element) in contacts.clone().take(MOST_LISTED) {
            line(out, &format!("{} at rest", element.name), list(&found.natural_frequencies_stuck))?;
        }
        more(contacts.count(), "contacts at rest: all of them are in --format json", out)?;
    }
    if has_contacts {
        line(out, "all contacts at rest", list(stuck))?;
    }
    if let Some(verdict) = description.sliding.as_ref().and_then(|found| sliding_verdict(found, units)) {
        writeln!(out, "\n{verdict}")?;
    }
    if !description.sliding_both_ways.is_empty() {
        let names = description.sliding_both_ways.join(", ");
        writeln!(
            out,
            "\nThe friction of {names} changes sign with the direction of sliding: these frequencies leave out its change with the displacement."
        )?;
    }
    if description.negative_damping {
        writeln!(out, "\nThe damping is negative in some direction: it feeds the motion.")?;
    }
    if *rigid > 0 {
        writeln!(
            out,
            "\n{} without a restoring force.",
            capital(&plural(*rigid, "rigid motion", "rigid motions"))
        )?;
    }
    Ok(())
}

/// A law in words: a curve as it is written, or the points of a table.
fn law_of(described: &Described, element: usize, points: usize) -> String {
    described.curve(element).unwrap_or_else(|| format!("a law of {points} points"))
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

fn of_element(element: &Element<f64>, place: usize, described: &Described, units: Option<&Units>) -> String {
    let ends = |sign: f64| {
        let place = element.direction.iter().position(|b| *b == sign);
        place.and_then(|i| described.coordinates.get(i)).map_or("ground", String::as_str)
    };
    let between = if element.direction.iter().all(|b| [0.0, 1.0, -1.0].contains(b)) {
        format!(" between {} and {}", ends(-1.0), ends(1.0))
    } else {
        String::new()
    };
    let force = |x: f64| with_unit(x, units, Of::Force);
    let above = |peak: f64| {
        if peak > 1.0 { format!(", static {} times that", digits(peak)) } else { String::new() }
    };
    match &element.kind {
        Kind::Contact { law: Law { points }, peak, normal } => {
            let friction = match points.as_slice() {
                [(_, one)] if normal.is_none() => force(*one),
                [(_, one)] => format!("a coefficient of {}", digits(*one)),
                several => law_of(described, place, several.len()),
            };
            format!("contact{between}, friction {friction}{}", above(*peak))
        }
        Kind::UnderStop { stop, coefficient, peak } => {
            let stop = described.model.elements.get(*stop).map_or("", |stop| stop.name.as_str());
            let what = format!("a coefficient of {} under {stop}", digits(*coefficient));
            format!("contact{between}, friction {what}{}", above(*peak))
        }
        Kind::Elastic { stiffness, friction, normal } => {
            let most = match normal {
                Some(_) => format!("a coefficient of {}", digits(*friction)),
                None => force(*friction),
            };
            format!("elastic contact{between}, {} up to {most}", with_unit(*stiffness, units, Of::Stiffness))
        }
        Kind::Stop { gap, stiffness, .. } => format!(
            "stop{between} beyond {}, {}",
            with_unit(*gap, units, Of::Length),
            with_unit(*stiffness, units, Of::Stiffness)
        ),
        Kind::Spring { points } => format!("spring{between}, {}", law_of(described, place, points.len())),
        Kind::HardStop { gap, restitution } => format!(
            "stop{between} beyond {}, restitution {}",
            with_unit(*gap, units, Of::Length),
            digits(*restitution)
        ),
    }
}

/// What is known of the digits of an answer, where laws are curves.
pub(super) fn digits_known(described: &Described, digits: Option<&Digits>, out: &mut impl Write) -> Outcome {
    if let Some(digits) = digits {
        writeln!(out, "{}", digits_sentence(digits, described.units.as_ref()))?;
    }
    Ok(())
}

/// A multiplier below it is rounding: that of the derivative of a period is some hundred units of a double.
const ROUNDING_OF_MULTIPLIERS: f64 = 1e-12;

/// The verdict on a steady motion.
pub(super) fn steady(
    described: &Described,
    found: &Steady<f64>,
    known: Option<&Digits>,
    out: &mut impl Write,
) -> Outcome {
    writeln!(out, "{}", steady_verdict(described, found))?;
    digits_known(described, known, out)?;
    writeln!(out)?;
    if found.kind == SteadyKind::Periodic && !found.multipliers.is_empty() {
        let largest = found.multipliers.iter().map(|(re, im)| re.hypot(*im)).fold(0.0, f64::max);
        let by = if largest < ROUNDING_OF_MULTIPLIERS {
            format!("less than {ROUNDING_OF_MULTIPLIERS:e}")
        } else {
            format!("at most {}", digits(largest))
        };
        line(out, "a disturbance", format!("is multiplied by {by} in this time"))?;
    }
    Ok(())
}

/// The least load that keeps the contact from sticking, and the motion at the load of the file.
pub(super) fn border<F: Value>(
    described: &Described,
    model: &Model<F>,
    found: &Border<F>,
    cycle: Option<&Cycle<F>>,
    out: &mut impl Write,
) -> Outcome {
    let units = described.units.as_ref();
    writeln!(out, "{}\n", border_verdict(described, &found.map(&|x: &F| x.to_f64())))?;
    for harmonic in &model.harmonics {
        for (i, name) in described.coordinates.iter().enumerate() {
            let part = |list: &[F]| list.get(i).copied().unwrap_or(F::int(0));
            let amplitude = part(&harmonic.sin).hypot(part(&harmonic.cos));
            if amplitude > F::int(0) {
                let least = |factor: F| with_unit(amplitude * factor, units, Of::Force);
                line(out, &format!("least load on {name}"), least(found.least_load_factor))?;
                if let Some(release) = found.least_load_factor_from_rest {
                    line(out, &format!("load on {name} from rest"), least(release))?;
                }
            }
        }
    }
    let touching = with_unit(found.touching_time, units, Of::Time);
    line(out, "velocity touches zero", format!("{touching} after the reversal"))?;
    match cycle {
        Some(cycle) => {
            writeln!(out, "\nAt the load of the file it slides with two reversals a period")?;
            line(out, "amplitude of the contact", with_unit(cycle.max_displacement, units, Of::Length))?;
            line(out, "peak velocity", with_unit(cycle.max_velocity, units, Of::Velocity))?;
            line(out, "friction work", with_unit(cycle.work, units, Of::Energy))?;
        }
        None => writeln!(out, "\nAt the load of the file it sticks, or does not slide.")?,
    }
    Ok(())
}

/// How many of a list are not shown, and where they are.
fn more(count: usize, what: &str, out: &mut impl Write) -> Outcome {
    match count.checked_sub(MOST_LISTED) {
        Some(left) if left > 0 => Ok(writeln!(out, "  and {left} more {what}")?),
        _ => Ok(()),
    }
}

/// How many coordinates a text does not list, unless they are chosen.
fn more_coordinates(described: &Described, out: &mut impl Write) -> Outcome {
    let count = described.places().count();
    let is_cut = described.listed().count() < count;
    more(if is_cut { count } else { 0 }, "coordinates: --coordinates NAMES shows those, or all", out)
}

/// A number as it is written.
pub(super) fn shown<F: Value>(x: &F) -> Number {
    Number::of(*x)
}

/// A motion as it is written in words.
pub(super) fn text_of<F: Value>(mut motion: Motion<F>) -> Motion<Number> {
    without_rounding(&mut motion);
    motion.map(&shown)
}

/// Takes out of the works what is below their rounding: it has no digit that is right.
fn without_rounding<F: Value>(motion: &mut Motion<F>) {
    let zero = F::int(0);
    let works = motion.elements.iter().fold(zero, |sum, found| sum + found.work.abs());
    let least = (works + motion.load_work.abs() + motion.damper_work.abs()) * F::epsilon() * F::int(4504);
    let own = [&mut motion.load_work, &mut motion.damper_work, &mut motion.stored];
    for work in motion.elements.iter_mut().map(|found| &mut found.work).chain(own) {
        if work.abs() < least {
            *work = zero;
        }
    }
}

/// A motion as text: its extremes, its elements and its events.
pub(super) fn motion(described: &Described, motion: &Motion<Number>, out: &mut impl Write) -> Outcome {
    let unit =
        |kind: Of| described.units.map_or_else(String::new, |system| format!(" {}", system.name(kind)));
    let work = |x: &Number| format!("{}{}", x.digits(), unit(Of::Energy));
    let (length, velocity) = (unit(Of::Length), unit(Of::Velocity));
    for (i, name) in described.listed() {
        let at = |list: &[Number]| list.get(i).map_or_else(String::new, Number::digits);
        writeln!(out, "{name}")?;
        let range =
            |least: &[Number], most: &[Number], unit: &str| format!("{} to {}{unit}", at(least), at(most));
        line(out, "displacement", range(&motion.min_displacement, &motion.max_displacement, &length))?;
        line(out, "velocity", range(&motion.min_velocity, &motion.max_velocity, &velocity))?;
        if let Some(most) = motion.max_absolute_acceleration.get(i) {
            line(out, "absolute acceleration", format!("up to {}{}", most.digits(), unit(Of::Acceleration)))?;
        }
    }
    more_coordinates(described, out)?;
    let elements = &described.model.elements;
    for (element, found) in elements.iter().zip(&motion.elements).take(MOST_LISTED) {
        writeln!(out, "{} ({})", element.name, kind_of(element))?;
        let rest = match element.kind {
            Kind::Stop { .. } | Kind::HardStop { .. } => Some("open"),
            Kind::Elastic { .. } => Some("holds"),
            Kind::Contact { .. } | Kind::UnderStop { .. } => Some("sticks"),
            Kind::Spring { .. } => None,
        };
        let seconds = if described.units.is_some() { " s" } else { "" };
        if let Some(rest) = rest {
            let times = plural(found.stops, "time", "times");
            line(out, rest, format!("{}{seconds}, {times}", found.time_at_rest.digits()))?;
        }
        if is_hard(element) {
            line(out, "blows", digits(found.blows as f64))?;
        }
        line(out, "work", work(&found.work))?;
    }
    more(elements.len(), "contacts, stops and springs: all of them are in --format json", out)?;
    writeln!(out, "energy")?;
    line(out, "work of the loads", work(&motion.load_work))?;
    line(out, "work on the dampers", work(&motion.damper_work))?;
    line(out, "stored", work(&motion.stored))?;
    if motion.events.is_empty() {
        return Ok(writeln!(out, "no events")?);
    }
    writeln!(out, "events")?;
    for event in motion.events.iter().take(MOST_LISTED) {
        let name = described.name_of(event.element);
        let seconds = if described.units.is_some() { " s" } else { "" };
        let from_to = event.velocities.as_ref().map_or_else(String::new, |(before, after)| {
            format!(" from {} to {}{velocity}", before.digits(), after.digits())
        });
        writeln!(out, "  {:>14}{seconds}  {name}: {}{from_to}", event.time.digits(), event.kind)?;
    }
    more(motion.events.len(), "events: all of them are in --format json", out)
}
