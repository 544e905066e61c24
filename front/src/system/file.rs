//! The file of a system: bodies by name with their springs, contacts and loads, or matrices.

use super::described::{Described, MOST_COORDINATES, MOST_ELEMENTS, law, peak};
use super::named;
use super::node::{Fields, Node, nearest};
use serde_json::Value;
use std::path::Path;
use stickslip::inputs::units::{Reader, System as Units};
use stickslip::system::{Element, Harmonic, Kind, Law, Model, Normal, Record, Signal, State};

/// The greatest length of a file in bytes.
pub const LONGEST: usize = 1 << 26;

/// The value of a file's text: JSON where it begins with a brace, otherwise TOML.
///
/// # Errors
/// One line with the name of the file and the line of the mistake.
pub fn parsed(text: &str, name: &str) -> Result<Value, String> {
    if text.len() > LONGEST {
        return Err(format!("{name}: must be ≤ {LONGEST} bytes"));
    }
    if text.trim_start().starts_with('{') {
        return serde_json::from_str(text).map_err(|e| format!("{name}: {e}"));
    }
    let table: toml::Table = toml::from_str(text).map_err(|e: toml::de::Error| {
        let line = e.span().map_or(0, |span| text.get(..span.start).unwrap_or("").lines().count().max(1));
        format!("{name}, line {line}: {}", e.message().replace('\n', " "))
    })?;
    let value = toml::Value::Table(table);
    // JSON has no such numbers: they would count as fields that are left out.
    if let Some(place) = not_finite(&value, "") {
        return Err(format!("{name}: {place}: must be finite"));
    }
    serde_json::to_value(value).map_err(|e| format!("{name}: {e}"))
}

/// The place of a number that is none, or infinite.
fn not_finite(value: &toml::Value, place: &str) -> Option<String> {
    match value {
        toml::Value::Float(x) if !x.is_finite() => Some(format!("{place} {x}")),
        toml::Value::Array(list) => list
            .iter()
            .enumerate()
            .find_map(|(i, value)| not_finite(value, &format!("{place}[{}]", i.saturating_add(1)))),
        toml::Value::Table(table) => table.iter().find_map(|(name, value)| {
            let place = if place.is_empty() { name.clone() } else { format!("{place}.{name}") };
            not_finite(value, &place)
        }),
        _ => None,
    }
}

/// The system of units that a value names.
///
/// # Errors
/// Where it names none that is known.
pub fn units_of(value: &Value) -> Result<Option<Units>, String> {
    match value.get("units") {
        None | Some(Value::Null) => Ok(None),
        Some(Value::String(text)) => text.parse().map(Some).map_err(|e| format!("units {text}: {e}")),
        Some(other) => Err(format!("units {other}: must be a text such as \"N,mm\"")),
    }
}

/// The system of a value, with records beside the file in `folder`.
pub(super) fn described(value: &Value, folder: &Path, units: Option<&Units>) -> Result<Described, String> {
    let own = units_of(value)?;
    let asked = units.copied().or(own);
    let reader = Reader::new(own.as_ref().or(units), "units = \"N,mm\"");
    let root = Node::root(value, &reader);
    let fields = root.fields()?;
    if fields.get("masses").is_some() {
        // Answers in other units than those of the file: bare numbers are then refused by the reader.
        let reader = Reader::new(asked.as_ref(), "units = \"N,mm\"");
        if own.is_some() && units.is_some() && own != asked {
            let typed = units.map_or_else(String::new, ToString::to_string);
            return Err(format!("units {typed}: must be left out, because the file names its own"));
        }
        return named::described(&Node::root(value, &reader), folder, asked.unwrap_or_default());
    }
    if let Some(typed) = units {
        return Err(format!(
            "units {typed}: must be left out: matrices have the units that their file names, or none"
        ));
    }
    by_matrices(&fields, own)
}

/// A system of matrices: in the units that the file names, or in any consistent ones.
fn by_matrices(fields: &Fields<'_>, units: Option<Units>) -> Result<Described, String> {
    if fields.get("mass").is_none() {
        return Err(
            "masses is missing: bodies by name, such as [masses] block = \"1 t\", or the matrix mass"
                .to_owned(),
        );
    }
    let mass = fields.required("mass")?.matrix()?;
    let n = mass.len();
    if n == 0 || n > MOST_COORDINATES {
        return Err(format!("mass: has {n} rows, must be ≥ 1 and ≤ {MOST_COORDINATES}"));
    }
    let zeros = || vec![vec![0.0; n]; n];
    let matrix = |name| fields.get(name).map_or_else(|| Ok(zeros()), |node| node.matrix());
    let mut model =
        Model { damping: matrix("damping")?, stiffness: matrix("stiffness")?, mass, ..Model::default() };
    if let Some(constant) = fields.get("constant") {
        model.constant = constant.numbers()?;
    }
    for node in fields.get("harmonics").map_or_else(|| Ok(Vec::new()), |node| node.list())? {
        let harmonic = node.fields()?;
        let part = |name| harmonic.get(name).map_or_else(|| Ok(Vec::new()), |node| node.numbers());
        model.harmonics.push(Harmonic {
            frequency: harmonic.required("frequency")?.number()?,
            sin: part("sin")?,
            cos: part("cos")?,
        });
        harmonic.end()?;
    }
    if let Some(node) = fields.get("record") {
        let record = node.fields()?;
        model.records.push(Record {
            times: record.required("times")?.numbers()?,
            values: record.required("values")?.numbers()?,
            force: record.required("force")?.numbers()?,
        });
        record.end()?;
    }
    let elements = fields.get("elements").map_or_else(|| Ok(Vec::new()), |node| node.list())?;
    if elements.len() > MOST_ELEMENTS {
        return Err(format!("elements: {} of them, must be ≤ {MOST_ELEMENTS}", elements.len()));
    }
    for (i, node) in elements.iter().enumerate() {
        model.elements.push(element(node, i)?);
    }
    let mut start = State::rest(n);
    if let Some(node) = fields.get("start") {
        let state = node.fields()?;
        for (name, place) in [("displacement", &mut start.displacement), ("velocity", &mut start.velocity)] {
            if let Some(node) = state.get(name) {
                *place = node.numbers()?;
                if place.len() != n {
                    return Err(node.wrong(&format!("has {} numbers, must have {n}", place.len())));
                }
            }
        }
        state.end()?;
    }
    for name in ["name", "source", "run", "about", "units"] {
        // A case may say where it comes from, and what is to be computed.
        let _ = fields.get(name);
    }
    fields.end()?;
    let inertia = model.mass.iter().map(|row| -row.iter().sum::<f64>()).collect();
    let coordinates = (1..=n).map(|i| format!("q{i}")).collect();
    Ok(Described { model, coordinates, units, start, inertia, base: None })
}

/// `{"const", "sin", "cos"}`: a constant and the parts at each frequency.
fn signal(node: &Node<'_>) -> Result<Signal<f64>, String> {
    if node.value().is_number() {
        return Ok(Signal::constant(node.number()?));
    }
    let fields = node.fields()?;
    let part = |name| fields.get(name).map_or_else(|| Ok(Vec::new()), |node| node.numbers());
    let constant = fields.get("const").map_or(Ok(0.0), |node| node.number())?;
    let found = Signal { constant, sin: part("sin")?, cos: part("cos")? };
    // The part of a normal load that depends on the displacements is read beside it.
    let _ = fields.get("displacement");
    fields.end()?;
    Ok(found)
}

fn element(node: &Node<'_>, i: usize) -> Result<Element<f64>, String> {
    let fields = node.fields()?;
    let number = |name: &'static str| fields.required(name).and_then(|node| node.number());
    let mut direction = fields.required("direction")?.numbers()?;
    let kind = fields.required("type")?;
    let kind = match kind.text()? {
        "contact" => {
            let law = match (fields.get("law"), fields.get("friction")) {
                (Some(_), Some(node)) => return Err(node.wrong("must be left out beside a law")),
                (Some(node), None) => law(&node, |node, _| node.number())?,
                (None, _) => Law::constant(number("friction")?),
            };
            let normal = fields.get("normal").map(|node| {
                let displacement = match node.value().get("displacement") {
                    Some(_) => node.fields()?.required("displacement")?.numbers()?,
                    None => Vec::new(),
                };
                Ok::<_, String>(Normal { signal: signal(&node)?, displacement })
            });
            Kind::Contact { law, peak: peak(&fields)?, normal: normal.transpose()? }
        }
        "elastic" => Kind::Elastic { stiffness: number("stiffness")?, friction: number("friction")? },
        "stop" => {
            let side = fields.get("side").map_or(Ok(1.0), |node| node.number())?;
            if side.abs() != 1.0 {
                return Err(fields.required("side")?.wrong("must be 1 or -1"));
            }
            direction.iter_mut().for_each(|b| *b *= side);
            let damping = fields.get("damping").map_or(Ok(0.0), |node| node.number())?;
            Kind::Stop { gap: number("gap")?, stiffness: number("stiffness")?, damping }
        }
        other => {
            let kinds = ["contact", "elastic", "stop"];
            return Err(kind.wrong(&format!("is unknown. {}", nearest(other, kinds.into_iter()))));
        }
    };
    let name = fields.get("name").map_or_else(
        || Ok(format!("element {}", i.saturating_add(1))),
        |node| node.text().map(str::to_owned),
    )?;
    let moves = fields.get("belt").map_or_else(|| Ok(Signal::constant(0.0)), |node| signal(&node))?;
    fields.end()?;
    Ok(Element { name, direction, moves, kind })
}
