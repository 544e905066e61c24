//! Several bodies, described as in a file of `stickslip system`.

use crate::asked::Asked;
use crate::record::load;
use serde_json::{Map, Value, json};
use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::path::Path;
use stickslip_front::curve::{Origin, SETTLED};
use stickslip_front::inputs::units::Kind;
use stickslip_front::limits::{MOST_ADDED, MOST_SCATTERED};
use stickslip_front::record::Channel;
use stickslip_front::system::{
    Answer, Described, Description, Digits, NamedSystem, OfBorder, Samples, border_verdict, digits_sentence,
    parsed, steady_verdict,
};

/// The most samples of a motion, and the most places of a curve.
const MOST: u64 = 10_000;

/// The system of the question: its `text` as in a file.
fn named(asked: &Asked<'_>) -> Result<NamedSystem, String> {
    let value = parsed(asked.text("text").unwrap_or_default(), "system")?;
    NamedSystem::new(&value, [], Path::new(""), None)
}

/// A value as JSON.
fn as_json(value: &impl serde::Serialize) -> Result<Value, String> {
    serde_json::to_value(value).map_err(|e| e.to_string())
}

/// A verdict with what is known of the digits.
fn with_digits(verdict: String, described: &Described, digits: Option<&Digits>) -> String {
    match digits {
        Some(digits) => format!("{verdict} {}", digits_sentence(digits, described.units.as_ref())),
        None => verdict,
    }
}

/// Why a system has no least load without sticking.
fn no_border(system: &NamedSystem, error: &stickslip::system::Error) -> String {
    let model = &system.described.model;
    if !model.elements.iter().any(stickslip_front::system::is_contact) {
        "There is no contact with friction, and nothing sticks.".to_owned()
    } else if model.records.is_empty()
        && model.harmonics.iter().all(|load| load.cos.iter().chain(&load.sin).all(|&x| x == 0.0))
    {
        "There is no load, and no multiple of it keeps the contact from sticking.".to_owned()
    } else if matches!(error, stickslip::system::Error::Unsupported { .. }) {
        "No least load without sticking is computed: that takes one rigid contact with one friction force, without a stop or a belt, under one sine wave."
            .to_owned()
    } else {
        format!("No least load without sticking is computed: {error}.")
    }
}

/// The system on a base that moves as the record in the text `record`, if there is one, and what was read of that.
fn shaken(asked: &Asked<'_>) -> Result<(NamedSystem, Option<String>), String> {
    let system = named(asked)?;
    if asked.text("record").is_none() {
        return Ok((system, None));
    }
    let channel = Channel::from(load(asked, &system.reader(), "record")?);
    let read = channel.sentences(stickslip_front::words::digits);
    Ok((system.with_record(&channel.record, asked.text("name").unwrap_or("record"))?, Some(read)))
}

/// What the system is, its steady motion, or with `until` or a record the motion from its start to that time or to the end of
/// the record, with `count` samples, and the least load without sticking, as `stickslip system` answers.
pub(crate) fn system(asked: &Asked<'_>) -> Result<Value, String> {
    let (system, read) = shaken(asked)?;
    let (engine, described) = (&system.system, &system.described);
    let count = asked.count("count", 400, MOST).max(1);
    let times = |until: f64| -> Vec<f64> { (0..=count).map(|i| until * (i as f64 / count as f64)).collect() };
    let failed = |e: stickslip_front::system::Why| e.to_string();
    let mut found = Map::new();
    let mut add = |name: &str, value: Value| found.insert(name.to_owned(), value);
    add("description", as_json(&Description::new(&system))?);
    let samples = |start: &stickslip::system::State<f64>, until: f64| -> Result<Value, String> {
        let times = times(until);
        let states = system.states(start, &times).map_err(failed)?;
        as_json(&Samples::new(described, &times, &states))
    };
    let until = match asked.text("until") {
        Some(text) => Some((system.reader().value("until", text, Kind::Time)?, format!("until {text}"))),
        None => read.is_some().then(|| (system.end_of_records(), "end of the record".to_owned())),
    };
    add("read", json!(read));
    if let Some((until, typed)) = until {
        system.check_until(until, &typed)?;
        let (motion, digits) = system.simulate(&described.start, until).map_err(failed)?;
        let verdict = format!("The motion from the start to {} s.", stickslip_front::words::digits(until));
        add("verdict", json!(with_digits(verdict, described, digits.as_ref())));
        add("motion", as_json(&Answer::transient(described, &motion).with_digits(digits.as_ref()))?);
        add("samples", samples(&described.start, until)?);
    } else {
        let (steady, digits) = system.steady(&described.start).map_err(failed)?;
        let verdict = steady_verdict(described, &steady);
        add("verdict", json!(with_digits(verdict, described, digits.as_ref())));
        add("motion", as_json(&Answer::steady(described, &steady).with_digits(digits.as_ref()))?);
        add(
            "samples",
            if steady.period > 0.0 { samples(&steady.start, steady.period)? } else { Value::Null },
        );
    }
    match engine.border() {
        Ok(border) => {
            let cycle = engine.cycle().map_err(|e| e.to_string())?.filter(|cycle| cycle.margin >= 1.0);
            add("border", as_json(&OfBorder::new(&border, cycle.as_ref()))?);
            add("border_verdict", json!(border_verdict(described, &border)));
        }
        Err(error) => {
            add("border", Value::Null);
            add("border_verdict", json!(no_border(&system, &error)));
        }
    }
    Ok(Value::Object(found))
}

/// The steady motion at a frequency of the loads: the greatest displacements, the rests of the contacts and the kind, where
/// there is one.
#[derive(Clone)]
struct Place {
    frequency: f64,
    sizes: Vec<f64>,
    rests: Option<usize>,
    kind: Option<&'static str>,
}

impl Place {
    const fn none(frequency: f64) -> Self {
        Self { frequency, sizes: Vec::new(), rests: None, kind: None }
    }

    fn of(system: &NamedSystem, frequency: f64) -> Result<Self, String> {
        let at = system.clone().at_frequency(frequency * std::f64::consts::TAU)?;
        let Ok((steady, _)) = at.steady(&at.described.start) else {
            return Ok(Self::none(frequency));
        };
        let (most, least) = (&steady.motion.max_displacement, &steady.motion.min_displacement);
        let kinds = at.described.model.elements.iter().map(stickslip_front::system::kind_of);
        let held = steady.motion.elements.iter().zip(kinds).filter(|(_, kind)| *kind != "stop");
        Ok(Self {
            frequency,
            sizes: most.iter().zip(least).map(|(most, least)| most.abs().max(least.abs())).collect(),
            rests: Some(held.map(|(element, _)| element.stops).sum()),
            kind: Some(steady.kind.name()),
        })
    }

    /// As [`Self::of`], for the system of a text; what was answered for it is kept.
    fn known(text: &str, system: &NamedSystem, frequency: f64) -> Result<Self, String> {
        KNOWN.with_borrow_mut(|(of, places)| {
            if of != text {
                places.clear();
                text.clone_into(of);
            }
            if let Some(place) = places.get(&frequency.to_bits()) {
                return Ok(place.clone());
            }
            let place = Self::of(system, frequency)?;
            places.insert(frequency.to_bits(), place.clone());
            Ok(place)
        })
    }

    /// Whether there is neither a periodic motion nor a rest.
    fn is_scattered(&self) -> bool {
        !self.kind.is_some_and(|kind| SETTLED.contains(&kind))
    }

    fn size(&self, coordinate: usize) -> Option<f64> {
        self.sizes.get(coordinate).copied()
    }

    fn height(&self, coordinate: usize) -> f64 {
        self.size(coordinate).filter(|_| !self.is_scattered()).unwrap_or(f64::NAN)
    }
}

thread_local! {
    /// The text of a system, and its places by the bits of their frequencies: a curve is asked for in parts, each with those before.
    static KNOWN: RefCell<(String, BTreeMap<u64, Place>)> = const { RefCell::new((String::new(), BTreeMap::new())) };
}

/// The greatest displacements and the rests of the steady motion over the `frequencies` of the loads in Hz, and, unless `resolved`
/// is false, over further ones beside the peaks; null where a frequency has no answer.
pub(crate) fn curve(asked: &Asked<'_>) -> Result<Value, String> {
    let system = named(asked)?;
    let text = asked.text("text").unwrap_or_default();
    let coordinates = system.described.coordinates.clone();
    let frequencies = asked.numbers("frequencies");
    let frequencies = frequencies.iter().take(MOST as usize);
    let mut places = frequencies
        .map(|&frequency| Place::known(text, &system, frequency))
        .collect::<Result<Vec<_>, _>>()?;
    let is_resolved = asked.0.get("resolved").and_then(Value::as_bool).unwrap_or(true);
    let scattered = Cell::new(0);
    for coordinate in 0..if is_resolved { coordinates.len() } else { 0 } {
        let added = Cell::new(0);
        let at = |frequency: f64| {
            added.set(added.get() + 1);
            if added.get() > MOST_ADDED || scattered.get() > MOST_SCATTERED {
                return Ok(Place::none(frequency));
            }
            let place = Place::known(text, &system, frequency)?;
            scattered.set(scattered.get() + usize::from(place.is_scattered()));
            Ok::<Place, String>(place)
        };
        let of = |place: &Place| (place.frequency, place.height(coordinate));
        let found = stickslip_front::curve::resolved(&places, true, of, |_| false, at)?;
        // What was not asked for is left out.
        let is_there = |(place, origin): &(Place, Origin)| *origin == Origin::Given || place.kind.is_some();
        places = found.into_iter().filter(is_there).map(|(place, _)| place).collect();
    }
    let unit = system.described.units.map_or_else(String::new, |units| units.name(Kind::Length));
    let column = |coordinate| places.iter().map(|place| place.size(coordinate)).collect::<Vec<_>>();
    Ok(json!({
        "frequency": places.iter().map(|place| place.frequency).collect::<Vec<_>>(),
        "displacement": (0..coordinates.len()).map(column).collect::<Vec<_>>(),
        "rests": places.iter().map(|place| place.rests).collect::<Vec<_>>(),
        "kind": places.iter().map(|place| place.kind).collect::<Vec<_>>(),
        "coordinates": coordinates,
        "unit": unit,
    }))
}
