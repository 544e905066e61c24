//! Bodies by name, and springs, contacts, stops and loads between them and the ground.

use super::described::{
    Described, MOST_COORDINATES, MOST_ELEMENTS, MOST_FREQUENCIES, MOST_RECORDS, MOST_SAMPLES, base_of, law,
    peak, shake,
};
use super::node::{Fields, Node, check_name, nearest};
use crate::record::{self, Options, Words};
use crate::text::{of_bytes, open_regular};
use serde_json::Value;
use std::io::{BufReader, Read};
use std::path::Path;
use stickslip::Excitation;
use stickslip::inputs::units::{Kind as Of, Reader, System as Units};
use stickslip::motion::record::Record as Measured;
use stickslip::system::{Base, Element, Harmonic, Kind, Law, Model, Normal, Record, Signal, State};

/// The name of the ground.
const GROUND: &str = "ground";

/// The greatest length of the file of a law in bytes: some 50,000 points.
const LONGEST_LAW: u64 = 1 << 21;

/// The bodies, and the system as far as it is read.
struct Builder<'p> {
    names: Vec<String>,
    model: Model<f64>,
    folder: &'p Path,
    base: Option<Base<f64>>,
}

/// The system of a file of named bodies.
pub(super) fn described(root: &Node<'_>, folder: &Path, units: Units) -> Result<Described, String> {
    let fields = root.fields()?;
    let bodies = fields.required("masses")?.entries()?;
    let n = bodies.len();
    if n == 0 || n > MOST_COORDINATES {
        return Err(format!("masses: {n} of them, must be ≥ 1 and ≤ {MOST_COORDINATES}"));
    }
    let zeros = || vec![vec![0.0; n]; n];
    let mut builder = Builder {
        names: bodies.iter().map(|(name, _)| (*name).to_owned()).collect(),
        model: Model {
            mass: zeros(),
            damping: zeros(),
            stiffness: zeros(),
            constant: vec![0.0; n],
            ..Model::default()
        },
        folder,
        base: None,
    };
    let mut start = State::rest(n);
    for (i, (name, node)) in bodies.iter().enumerate() {
        check_name(name).map_err(|must| format!("masses.{name}: {must}"))?;
        if *name == GROUND {
            return Err(node.wrong("must have another name: the ground does not move"));
        }
        let mass = if node.value().is_object() {
            let body = node.fields()?;
            let mass = body.required("mass")?;
            for (field, kind, place) in [
                ("start", Of::Length, &mut start.displacement),
                ("velocity", Of::Velocity, &mut start.velocity),
            ] {
                if let (Some(node), Some(place)) = (body.get(field), place.get_mut(i)) {
                    *place = node.quantity(kind)?;
                }
            }
            body.end()?;
            mass
        } else {
            node.clone()
        };
        let value = mass.quantity(Of::Mass)?;
        if value <= 0.0 {
            return Err(mass.wrong("must be > 0"));
        }
        add(&mut builder.model.mass, i, i, value);
    }
    let lists = |name| fields.get(name).map_or_else(|| Ok(Vec::new()), |node| node.list());
    for node in lists("springs")? {
        builder.spring(&node.fields()?)?;
    }
    for node in lists("contacts")? {
        builder.contact(&node.fields()?)?;
    }
    for node in lists("stops")? {
        builder.stop(&node.fields()?)?;
    }
    for node in lists("forces")? {
        builder.force(&node.fields()?)?;
    }
    if let Some(base) = fields.get("base") {
        builder.base(&base)?;
    }
    let _ = fields.get("units");
    let _ = fields.get("about");
    fields.end()?;
    let count = builder.model.elements.len();
    if count > MOST_ELEMENTS {
        return Err(format!("contacts and stops: {count} of them, must be ≤ {MOST_ELEMENTS}"));
    }
    let inertia = builder.inertia();
    let Builder { model, names: coordinates, base, .. } = builder;
    Described { model, coordinates, units: Some(units), start, inertia, base }.checked()
}

fn add(matrix: &mut [Vec<f64>], i: usize, j: usize, value: f64) {
    if let Some(place) = matrix.get_mut(i).and_then(|row| row.get_mut(j)) {
        *place += value;
    }
}

impl Builder<'_> {
    /// −M ι: the force of a unit acceleration of the base on each body.
    fn inertia(&self) -> Vec<f64> {
        self.model.mass.iter().map(|row| -row.iter().sum::<f64>()).collect()
    }

    /// A body by its name; `None` for the ground.
    fn body(&self, node: &Node<'_>) -> Result<Option<usize>, String> {
        let name = node.text()?;
        if name == GROUND {
            return Ok(None);
        }
        self.names.iter().position(|own| own == name).map(Some).ok_or_else(|| {
            let names = [GROUND].into_iter().chain(self.names.iter().map(String::as_str));
            node.wrong(&format!("is no body. {}", nearest(name, names)))
        })
    }

    /// The direction of `between = [first, second]`: of the second body in relation to the first.
    fn direction(&self, fields: &Fields<'_>) -> Result<(Vec<f64>, [Option<usize>; 2]), String> {
        let node = fields.required("between")?;
        let list = node.list()?;
        let [first, second] = list.as_slice() else {
            return Err(node.wrong("must be two names, such as [\"ground\", \"block\"]"));
        };
        let ends = [self.body(first)?, self.body(second)?];
        if ends[0] == ends[1] {
            return Err(second.wrong("must differ from the first body"));
        }
        let mut direction = vec![0.0; self.names.len()];
        for (end, sign) in ends.into_iter().zip([-1.0, 1.0]) {
            if let Some(place) = end.and_then(|end| direction.get_mut(end)) {
                *place = sign;
            }
        }
        Ok((direction, ends))
    }

    /// The name of an element: as given, or its kind and its place in the list.
    fn name(&self, fields: &Fields<'_>) -> Result<String, String> {
        let name = match fields.get("name") {
            Some(node) => node.name()?.to_owned(),
            None => fields.node.place().to_owned(),
        };
        if self.model.elements.iter().any(|element| element.name == name) || self.names.contains(&name) {
            return Err(fields.node.wrong(&format!("the name {name} is used twice")));
        }
        Ok(name)
    }

    fn spring(&mut self, fields: &Fields<'_>) -> Result<(), String> {
        let (_, ends) = self.direction(fields)?;
        let value = |name: &'static str, kind: Of, like: &str| {
            let Some(node) = fields.get(name) else { return Ok(0.0) };
            let value = node.quantity(kind)?;
            if value < 0.0 {
                return Err(
                    node.wrong(&format!("must be ≥ 0 (a negative one, {like}, is given by matrices)"))
                );
            }
            Ok(value)
        };
        let stiffness = value("stiffness", Of::Stiffness, "as of a buckled strut")?;
        let damping = value("damping", Of::Damping, "which feeds the motion")?;
        // For paths of other values, as that of a force.
        fields.get("name").map_or(Ok(""), |node| node.name())?;
        fields.end()?;
        for (matrix, value) in [(&mut self.model.stiffness, stiffness), (&mut self.model.damping, damping)] {
            match ends {
                [Some(a), Some(b)] => {
                    add(matrix, a, a, value);
                    add(matrix, b, b, value);
                    add(matrix, a, b, -value);
                    add(matrix, b, a, -value);
                }
                [Some(a), None] | [None, Some(a)] => add(matrix, a, a, value),
                [None, None] => {}
            }
        }
        Ok(())
    }

    fn contact(&mut self, fields: &Fields<'_>) -> Result<(), String> {
        let (direction, _) = self.direction(fields)?;
        let name = self.name(fields)?;
        let friction = self.friction(fields)?;
        let moves = match fields.get("moves") {
            Some(node) => self.motion(&node)?,
            None => Signal::constant(0.0),
        };
        let elastic = fields.get("stiffness");
        if elastic.is_some()
            && let Some(node) = fields.get("peak").or_else(|| fields.get("static_ratio"))
        {
            return Err(node.wrong("must be left out of an elastic contact, which has one friction force"));
        }
        let kind = match elastic {
            Some(node) => match friction {
                Friction { law: Law { points }, normal: None } if points.len() == 1 => Kind::Elastic {
                    stiffness: node.quantity(Of::Stiffness)?,
                    friction: points.first().map_or(0.0, |point| point.1),
                },
                Friction { .. } => {
                    return Err(node.wrong(
                        "an elastic contact has one friction force, without a law or a variable load",
                    ));
                }
            },
            None => Kind::Contact { law: friction.law, peak: peak(fields)?, normal: friction.normal },
        };
        fields.end()?;
        self.model.elements.push(Element { name, direction, moves, kind });
        Ok(())
    }

    /// The friction of a contact: a force, a coefficient with its normal load, or a law.
    fn friction(&mut self, fields: &Fields<'_>) -> Result<Friction, String> {
        let coefficient = fields.get("coefficient");
        let (force, table) = (fields.get("friction"), fields.get("law"));
        let load = fields.get("normal_load");
        let given = [&force, &coefficient, &table].into_iter().flatten().count();
        if given == 0 {
            // A misspelt name says more than a missing one.
            fields.end_with(&["name", "stiffness", "moves", "peak", "static_ratio"])?;
        }
        if given != 1 {
            let what = if given == 0 { "needs" } else { "must have only" };
            let one = "one of friction, coefficient with normal_load, and law";
            return Err(fields.node.wrong(&format!("{what} {one}")));
        }
        if let Some(node) = coefficient {
            let Some(load) = load else {
                return Err(node.wrong("needs normal_load, the force that presses the surfaces together"));
            };
            let coefficient = node.not_negative(Of::Ratio)?;
            if load.value().is_object() {
                let signal = self.signal(&load, Of::Force)?;
                let normal = Some(Normal { signal, displacement: Vec::new() });
                return Ok(Friction { law: Law::constant(coefficient), normal });
            }
            let friction = coefficient * load.not_negative(Of::Force)?;
            return Ok(Friction { law: Law::constant(friction), normal: None });
        }
        if let Some(load) = load {
            return Err(load.wrong("must be left out without a coefficient"));
        }
        let law = match (force, table) {
            (Some(node), _) => Law::constant(node.not_negative(Of::Force)?),
            (None, Some(node)) if node.value().is_string() => {
                self.law_of_file(&node).map_err(|e| format!("{}: {e}", node.place()))?
            }
            (None, Some(node)) => {
                law(&node, |node, i| node.not_negative(if i == 0 { Of::Velocity } else { Of::Force }))?
            }
            (None, None) => Law::constant(0.0),
        };
        Ok(Friction { law, normal: None })
    }

    /// A law from a CSV file of two columns: speed and force.
    fn law_of_file(&self, node: &Node<'_>) -> Result<Law<f64>, String> {
        let file = self.folder.join(node.text()?);
        let name = file.display().to_string();
        let bad = |e: &dyn std::fmt::Display| format!("{name}: {e}");
        let mut bytes = Vec::new();
        let source = open_regular(&file).map_err(|e| bad(&e))?;
        source.take(LONGEST_LAW + 1).read_to_end(&mut bytes).map_err(|e| bad(&e))?;
        if bytes.len() as u64 > LONGEST_LAW {
            return Err(bad(&format!("must be ≤ {LONGEST_LAW} bytes")));
        }
        let text = of_bytes(bytes).map_err(|e| bad(&e))?;
        let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(text.as_bytes());
        let header = reader.headers().map_err(|e| bad(&e))?.clone();
        let mut kinds = [Of::Velocity, Of::Force].into_iter().zip(&header).map(|(kind, text)| {
            let (_, unit) = crate::names::name_and_unit(text);
            (kind, unit.map(str::to_owned))
        });
        let (Some(speed), Some(force)) = (kinds.next(), kinds.next()) else {
            return Err(bad(&"must have the columns speed and force"));
        };
        let mut points = Vec::new();
        for (line, row) in reader.records().enumerate() {
            let row = row.map_err(|e| bad(&e))?;
            let value = |i: usize, (kind, unit): &(Of, Option<String>)| {
                let text = format!("{}{}", row.get(i).unwrap_or(""), unit.as_deref().unwrap_or(""));
                let place = format!("{name}, line {}", line.saturating_add(2));
                node.reader().value::<f64>(&place, &text, *kind).map_err(|e| e.to_string())
            };
            points.push((value(0, &speed)?, value(1, &force)?));
        }
        Ok(Law { points })
    }

    fn stop(&mut self, fields: &Fields<'_>) -> Result<(), String> {
        let (direction, _) = self.direction(fields)?;
        let name = self.name(fields)?;
        let kind = Kind::Stop {
            gap: fields.required("gap")?.quantity(Of::Length)?,
            stiffness: fields.required("stiffness")?.quantity(Of::Stiffness)?,
            damping: fields.quantity_or("damping", Of::Damping, 0.0)?,
        };
        fields.end()?;
        self.model.elements.push(Element { name, direction, moves: Signal::constant(0.0), kind });
        Ok(())
    }

    /// The place of a frequency among the harmonics, to which it is added where it is new.
    fn harmonic(&mut self, node: &Node<'_>) -> Result<usize, String> {
        let frequency = node.quantity(Of::Frequency)?;
        if frequency <= 0.0 {
            return Err(node.wrong("must be > 0"));
        }
        let (n, harmonics) = (self.names.len(), &mut self.model.harmonics);
        if let Some(place) = harmonics.iter().position(|harmonic| harmonic.frequency == frequency) {
            return Ok(place);
        }
        let place = harmonics.len();
        if place == MOST_FREQUENCIES {
            return Err(node.wrong(&format!("must be one of ≤ {MOST_FREQUENCIES} frequencies in the file")));
        }
        harmonics.push(Harmonic { frequency, sin: vec![0.0; n], cos: vec![0.0; n] });
        Ok(place)
    }

    /// A harmonic `{ amplitude, frequency, phase }`: the place of its frequency, and its parts in phase with the sine and
    /// with the cosine.
    fn wave(&mut self, fields: &Fields<'_>, kind: Of) -> Result<(usize, [f64; 2]), String> {
        let amplitude = fields.required("amplitude")?.quantity(kind)?;
        let place = self.harmonic(&fields.required("frequency")?)?;
        let (sine, cosine) = fields.quantity_or("phase", Of::Angle, 0.0)?.sin_cos();
        Ok((place, [amplitude * cosine, amplitude * sine]))
    }

    /// A constant, or a constant with a harmonic: `{ constant, amplitude, frequency, phase }`.
    fn signal(&mut self, node: &Node<'_>, kind: Of) -> Result<Signal<f64>, String> {
        if !node.value().is_object() {
            return Ok(Signal::constant(node.quantity(kind)?));
        }
        let fields = node.fields()?;
        let mut signal = Signal::constant(fields.quantity_or("constant", kind, 0.0)?);
        if fields.get("amplitude").is_some() {
            let (place, [sin, cos]) = self.wave(&fields, kind)?;
            signal.sin = vec![0.0; place.saturating_add(1)];
            signal.cos = signal.sin.clone();
            if let (Some(to), Some(into)) = (signal.sin.last_mut(), signal.cos.last_mut()) {
                (*to, *into) = (sin, cos);
            }
        }
        fields.end()?;
        Ok(signal)
    }

    /// The velocity of a contact's other side: of a belt, or of a harmonic motion of the surface.
    fn motion(&mut self, node: &Node<'_>) -> Result<Signal<f64>, String> {
        self.signal(node, Of::Velocity)
    }

    fn force(&mut self, fields: &Fields<'_>) -> Result<(), String> {
        let body = fields.required("on")?;
        let Some(i) = self.body(&body)? else {
            return Err(body.wrong("must be a body: the ground does not move"));
        };
        fields.get("name").map_or(Ok(""), |node| node.name())?;
        let force = unit(self.names.len(), i);
        match (fields.get("record"), fields.get("constant"), fields.get("amplitude")) {
            (Some(node), None, None) => self.record(&node, Excitation::Force, force)?,
            (None, Some(node), None) => {
                if let Some(place) = self.model.constant.get_mut(i) {
                    *place += node.quantity(Of::Force)?;
                }
            }
            (None, None, Some(_)) => {
                let (place, parts) = self.wave(fields, Of::Force)?;
                self.load(place, parts, &force);
            }
            (record, constant, amplitude) => {
                // A misspelt name says more than a missing one.
                fields.end_with(&["frequency", "phase"])?;
                let is_given = record.or(constant).or(amplitude).is_some();
                let what = if is_given { "must have only" } else { "needs" };
                let one = "one of amplitude with frequency, constant, and record";
                return Err(fields.node.wrong(&format!("{what} {one}")));
            }
        }
        fields.end()
    }

    /// Adds a load at a frequency.
    fn load(&mut self, place: usize, [sin, cos]: [f64; 2], force: &[f64]) {
        if let Some(harmonic) = self.model.harmonics.get_mut(place) {
            for (i, share) in force.iter().enumerate() {
                for (part, size) in [(&mut harmonic.sin, sin), (&mut harmonic.cos, cos)] {
                    if let Some(place) = part.get_mut(i) {
                        *place += size * share;
                    }
                }
            }
        }
    }

    /// The motion of the base, over which all displacements are measured.
    fn base(&mut self, node: &Node<'_>) -> Result<(), String> {
        let fields = node.fields()?;
        let acceleration = fields.required("acceleration")?;
        let force = self.inertia();
        let mut base = base_of(force.len());
        if acceleration.value().is_object() {
            let wave = acceleration.fields()?;
            let (place, parts) = self.wave(&wave, Of::Acceleration)?;
            wave.end()?;
            self.load(place, parts, &force);
            let Signal { sin, cos, .. } = &mut base.acceleration;
            for (list, part) in [sin, cos].into_iter().zip(parts) {
                list.resize(place, 0.0);
                list.push(part);
            }
        } else {
            shake(&mut base, &self.model);
            self.record(&acceleration, Excitation::SurfaceAcceleration, force)?;
        }
        self.base = Some(base);
        fields.end()
    }

    /// A record from a file beside this one.
    fn record(&mut self, node: &Node<'_>, of: Excitation, force: Vec<f64>) -> Result<(), String> {
        let file = self.folder.join(node.text()?);
        let record = of_file(&file, &file.display().to_string(), node.reader())
            .map_err(|e| format!("{}: {e}", node.place()))?;
        if record.excitation() != of {
            return Err(node.wrong(&format!("must be a record of {}", of.name())));
        }
        let others = &self.model.records;
        let count = others.iter().fold(record.samples().len(), |sum, of| sum.saturating_add(of.times.len()));
        if count > MOST_SAMPLES || others.len() == MOST_RECORDS {
            let most =
                format!("must be one of ≤ {MOST_RECORDS} records, with ≤ {MOST_SAMPLES} samples together");
            return Err(node.wrong(&most));
        }
        self.model.records.push(samples(&record, force));
        Ok(())
    }
}

/// The record of a file in these units.
fn of_file(file: &Path, name: &str, reader: &Reader) -> Result<Measured<f64>, String> {
    let opened = open_regular(file).map_err(|e| format!("{name}: {e}"))?;
    let found = record::read(BufReader::new(opened), &Options::new(name, reader, Words::COMMAND))?;
    Ok(found.record)
}

/// The samples of a record, with the force on each body where they are 1.
pub(super) fn samples(record: &Measured<f64>, force: Vec<f64>) -> Record<f64> {
    let values = record.samples().to_vec();
    let times = (0..values.len()).map(|i| record.time(i)).collect();
    Record { times, values, force }
}

/// The friction of a contact, and its normal load where it varies.
struct Friction {
    law: Law<f64>,
    normal: Option<Normal<f64>>,
}

/// 1 at a place, and 0 elsewhere.
fn unit(n: usize, place: usize) -> Vec<f64> {
    (0..n).map(|i| if i == place { 1.0 } else { 0.0 }).collect()
}

/// The steps of a path such as `contacts[1].friction`: names, and places in brackets.
fn steps(path: &str) -> Option<Vec<&str>> {
    let mut steps = Vec::new();
    for part in path.split('.') {
        let (name, places) = part.split_at(part.find('[').unwrap_or(part.len()));
        steps.push(name.trim());
        for place in places.split_inclusive(']') {
            place_of(place)?;
            steps.push(place);
        }
    }
    Some(steps)
}

/// The place from 0 of a step such as `[1]`, which is the first, as in messages.
fn place_of(step: &str) -> Option<usize> {
    step.trim().strip_prefix('[')?.strip_suffix(']')?.trim().parse::<usize>().ok()?.checked_sub(1)
}

/// Sets a value of the file, by `name.field` of a named contact, spring, stop or body, or by its place.
pub(super) fn set(file: &mut Value, path: &str, text: &str) -> Result<(), String> {
    let about = |what: &str| format!("{path}={text}: {what}");
    let value = text.parse::<f64>().ok().and_then(serde_json::Number::from_f64);
    let value = value.map_or_else(|| Value::String(text.to_owned()), Value::Number);
    let steps = steps(path).ok_or_else(|| about("a place in brackets must be a whole number ≥ 1"))?;
    let Some((last, steps)) = steps.split_last() else { return Err(about("needs a name")) };
    let by_name = |file: &Value| -> Option<Vec<String>> {
        let (first, rest) = steps.split_first()?;
        let lists = ["contacts", "springs", "stops", "forces", "elements"];
        let found = lists.into_iter().find_map(|list| {
            let items = file.get(list)?.as_array()?;
            let at = items.iter().position(|item| item.get("name").and_then(Value::as_str) == Some(first))?;
            Some(vec![list.to_owned(), format!("[{}]", at.saturating_add(1))])
        });
        let body = || file.get("masses")?.get(first).map(|_| vec!["masses".to_owned(), (*first).to_owned()]);
        let mut place = found.or_else(body)?;
        place.extend(rest.iter().map(|step| (*step).to_owned()));
        Some(place)
    };
    let place = by_name(file).unwrap_or_else(|| steps.iter().map(|step| (*step).to_owned()).collect());
    let no_place = |step: &str, items: usize| {
        about(&format!("{step} is no place of the list, which has [1] to [{items}]"))
    };
    let mut at = file;
    for step in &place {
        let next = match at {
            Value::Array(items) => {
                let count = items.len();
                let item = place_of(step).and_then(|i| items.get_mut(i));
                Some(item.ok_or_else(|| no_place(step, count))?)
            }
            Value::Object(map) => map.get_mut(step),
            Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => None,
        };
        at = next.ok_or_else(|| about(&format!("{step} is neither a name nor a place in the file")))?;
    }
    match at {
        Value::Object(map) => {
            map.insert((*last).to_owned(), value);
            Ok(())
        }
        // The mass of a body that is one number.
        Value::String(_) | Value::Number(_) if *last == "mass" => {
            *at = value;
            Ok(())
        }
        Value::Array(items) => {
            let count = items.len();
            let item = place_of(last).and_then(|i| items.get_mut(i));
            *item.ok_or_else(|| no_place(last, count))? = value;
            Ok(())
        }
        Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => Err(about("is no table")),
    }
}
