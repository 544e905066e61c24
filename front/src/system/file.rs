//! The file of a system: bodies by name with their springs, contacts and loads, or matrices.

use super::described::{
    Described, MOST_ELEMENTS, MOST_FREQUENCIES, MOST_SAMPLES, damped, empty, law, pairs, peak, restitution,
};
use super::laws::{BESIDE_CURVE, Law as Curved};
use super::named;
use super::node::{Fields, Node, Number, nearest};
use super::spring;
use super::stored::{matrix as matrix_of, of_fields};
use super::unique::Unique;
use crate::inputs::units::{Kind as Of, Reader, System as Units};
use crate::text::Folder;
use crate::text::of_bytes;
use serde_json::Value;
use stickslip::system::{Beyond, Element, Harmonic, Kind, Law, Model, Normal, Record, Signal, State};

/// The greatest length of a file in bytes: three matrices of the most coordinates in full digits are 3 MB.
pub const LONGEST: usize = 1 << 23;

/// That of TOML, of which every word and every end of a line is in memory with its place.
const LONGEST_TOML: usize = 1 << 22;

/// The greatest number of values in a file, so that it is read in 200 MB of memory and less than a second. Three matrices of
/// the most coordinates have 120,000, and two for each sample of a record are left.
pub const MOST_VALUES: usize = 500_000;

/// The text of a file.
///
/// # Errors
/// One line with the name of the file, where it is too long or no UTF-8.
pub fn decoded(bytes: Vec<u8>, name: &str) -> Result<String, String> {
    if bytes.len() > LONGEST {
        return Err(format!("{name}: must be ≤ {LONGEST} bytes"));
    }
    of_bytes(bytes).map_err(|what| format!("{name}: {what}"))
}

/// The value of a file's text: JSON where it begins with a brace, otherwise TOML.
///
/// # Errors
/// One line with the name of the file and the line of the mistake.
pub fn parsed(text: &str, name: &str) -> Result<Value, String> {
    if text.len() > LONGEST {
        return Err(format!("{name}: must be ≤ {LONGEST} bytes"));
    }
    // Each value of either language has one of these before it.
    let values = text.bytes().filter(|byte| b"{[,:=".contains(byte)).count();
    if values > MOST_VALUES {
        return Err(format!("{name}: has {values} values, must have ≤ {MOST_VALUES}"));
    }
    if is_json(text) {
        return serde_json::from_str(text).map(|Unique(value)| value).map_err(|e| format!("{name}: {e}"));
    }
    if text.len() > LONGEST_TOML {
        return Err(format!("{name}: must be ≤ {LONGEST_TOML} bytes, or JSON"));
    }
    let table: toml::Table = toml::from_str(text).map_err(|e: toml::de::Error| {
        let line = e
            .span()
            .map_or(0, |span| text.get(..span.start).unwrap_or("").matches('\n').count().saturating_add(1));
        format!("{name}, line {line}: {}", e.message().replace('\n', " "))
    })?;
    let value = toml::Value::Table(table);
    // JSON has no such numbers: they would count as fields that are left out.
    if let Some(place) = not_finite(&value) {
        return Err(format!("{name}: {}: must be finite", place.trim_start_matches('.')));
    }
    serde_json::to_value(value).map_err(|e| format!("{name}: {e}"))
}

/// Whether a text is JSON, and not TOML.
pub(super) fn is_json(text: &str) -> bool {
    text.trim_start().starts_with('{')
}

/// The place of a number that is none, or infinite, behind that of the value.
fn not_finite(value: &toml::Value) -> Option<String> {
    match value {
        toml::Value::Float(x) if !x.is_finite() => Some(format!(" {x}")),
        toml::Value::Array(list) => list
            .iter()
            .zip(1..)
            .find_map(|(value, place): (_, usize)| not_finite(value).map(|rest| format!("[{place}]{rest}"))),
        toml::Value::Table(table) => {
            table.iter().find_map(|(name, value)| not_finite(value).map(|rest| format!(".{name}{rest}")))
        }
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
pub(super) fn described<F: Number>(
    value: &Value,
    folder: &Folder<'_>,
    units: Option<&Units>,
) -> Result<Described<F>, String> {
    let own = units_of(value)?;
    let asked = units.copied().or(own);
    let reader = Reader::new(own.as_ref().or(units), "units = \"N,mm\"");
    let root = Node::root(value, &reader);
    let fields = root.fields()?;
    if let (Some(_), Some(_)) = (fields.get("masses"), fields.get("mass")) {
        return Err("masses, mass: must be one of the two: bodies by name, or a matrix".to_owned());
    }
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
    by_matrices(&fields, folder, own)
}

/// A system of matrices: in the units that the file names, or in any consistent ones.
fn by_matrices<F: Number>(
    fields: &Fields<'_>,
    folder: &Folder<'_>,
    units: Option<Units>,
) -> Result<Described<F>, String> {
    if fields.get("mass").is_none() {
        return Err(
            "masses is missing: bodies by name, such as [masses] block = \"1 t\", or the matrix mass"
                .to_owned(),
        );
    }
    let mass = matrix_of(&fields.required("mass")?, folder, None)?;
    let (n, zero) = (mass.len(), F::int(0));
    let zeros = || vec![vec![zero; n]; n];
    let matrix =
        |node: Option<Node<'_>>| node.map_or_else(|| Ok(zeros()), |node| matrix_of(&node, folder, Some(n)));
    let by_modes = fields.get("damping").filter(|node| node.value().is_object());
    let damping = match &by_modes {
        Some(node) => {
            let own = node.fields()?;
            if let (Some(node), true) = (own.get("matrix"), own.get("file").is_some()) {
                return Err(node.wrong("must be left out beside file"));
            }
            if own.get("file").is_some() {
                of_fields(&own, folder, Some(n), &["matrix", "rayleigh", "ratio"])?
            } else {
                matrix(own.get("matrix"))?
            }
        }
        None => matrix(fields.get("damping"))?,
    };
    let mut model = Model { damping, stiffness: matrix(fields.get("stiffness"))?, mass, ..empty() };
    if let Some(node) = &by_modes {
        model = damped(model, node, &["matrix", "file", "array"])?;
    }
    if let Some(constant) = fields.get("constant") {
        model.constant = constant.vector(n)?;
    }
    let harmonics = fields.get("harmonics").map_or_else(|| Ok(Vec::new()), |node| node.list())?;
    if harmonics.len() > MOST_FREQUENCIES {
        return Err(format!("harmonics: {} of them, must be ≤ {MOST_FREQUENCIES}", harmonics.len()));
    }
    for node in harmonics {
        let harmonic = node.fields()?;
        let part = |name| harmonic.get(name).map_or_else(|| Ok(Vec::new()), |node| node.vector(n));
        model.harmonics.push(Harmonic {
            frequency: harmonic.required("frequency")?.quantity(Of::Frequency)?,
            sin: part("sin")?,
            cos: part("cos")?,
        });
        harmonic.end()?;
    }
    if let Some(node) = fields.get("record") {
        let record = node.fields()?;
        let times = record.required("times")?.numbers()?;
        if times.len() > MOST_SAMPLES {
            return Err(format!("record.times: has {} numbers, must have ≤ {MOST_SAMPLES}", times.len()));
        }
        let values = record.required("values")?.vector(times.len())?;
        let repeats = record
            .get("repeats")
            .map(|node| node.value().as_bool().ok_or_else(|| node.wrong("must be true or false")));
        let beyond = if repeats.transpose()?.unwrap_or(false) { Beyond::Repeat } else { Beyond::Zero };
        model.records.push(Record { times, values, force: record.required("force")?.vector(n)?, beyond });
        record.end()?;
    }
    let elements = fields.get("elements").map_or_else(|| Ok(Vec::new()), |node| node.list())?;
    if elements.len() > MOST_ELEMENTS {
        return Err(format!("elements: {} of them, must be ≤ {MOST_ELEMENTS}", elements.len()));
    }
    let mut laws = Vec::new();
    for (i, node) in elements.iter().enumerate() {
        model.elements.push(element(node, i, n, &mut laws)?);
    }
    // A stop may be named before it is described.
    let names: Vec<String> = model.elements.iter().map(|element| element.name.clone()).collect();
    for (node, element) in elements.iter().zip(&mut model.elements) {
        if let Kind::UnderStop { stop, .. } = &mut element.kind {
            let node = node.fields()?.required("stop")?;
            let named = node.text()?;
            *stop = names.iter().position(|name| name == named).ok_or_else(|| {
                let near = nearest(named, names.iter().map(String::as_str));
                node.wrong(&format!("is no element. {near}"))
            })?;
        }
    }
    let mut start = State::rest(n);
    if let Some(node) = fields.get("start") {
        let state = node.fields()?;
        for (name, place) in [("displacement", &mut start.displacement), ("velocity", &mut start.velocity)] {
            if let Some(node) = state.get(name) {
                *place = node.vector(n)?;
            }
        }
        state.end()?;
    }
    for name in ["name", "source", "run", "about", "units"] {
        // A case may say where it comes from, and what is to be computed.
        let _ = fields.get(name);
    }
    let coordinates = coordinates(fields, n, &model.elements)?;
    fields.end()?;
    let inertia = model.mass.iter().map(|row| -row.iter().fold(zero, |sum, &x| sum + x)).collect();
    let typed_masses = Vec::new();
    Described { model, coordinates, units, start, inertia, base: None, laws, shown: None, typed_masses }
        .checked()
}

/// The names of the coordinates of matrices, q1, q2 and so on by default. Answers and elements are told apart by them.
fn coordinates<F: Number>(
    fields: &Fields<'_>,
    n: usize,
    elements: &[Element<F>],
) -> Result<Vec<String>, String> {
    let Some(node) = fields.get("coordinates") else { return Ok((1..=n).map(|i| format!("q{i}")).collect()) };
    let given = node.list()?;
    if given.len() != n {
        return Err(format!("coordinates: has {} names, must have {n}", given.len()));
    }
    let mut names: Vec<String> = Vec::with_capacity(n);
    for node in given {
        let name = node.name()?;
        if name == named::GROUND {
            return Err(node.wrong("must have another name: the ground does not move"));
        }
        if names.iter().chain(elements.iter().map(|element| &element.name)).any(|other| other == name) {
            return Err(node.wrong("is used twice"));
        }
        names.push(name.to_owned());
    }
    Ok(names)
}

/// `{"const", "sin", "cos"}`: a constant and the parts at each frequency.
fn signal<F: Number>(node: &Node<'_>) -> Result<Signal<F>, String> {
    if !node.value().is_object() {
        return Ok(Signal::constant(node.number()?));
    }
    let fields = node.fields()?;
    let part = |name| fields.get(name).map_or_else(|| Ok(Vec::new()), |node| node.numbers());
    let constant = fields.get("const").map_or(Ok(F::int(0)), |node| node.number())?;
    let (sin, cos) = (part("sin")?, part("cos")?);
    let found = Signal { sin, cos, ..Signal::constant(constant) };
    // The parts of a normal load that depend on the motion are read beside it.
    fields.end_with(&["displacement", "velocity"])?;
    Ok(found)
}

/// The normal load of an element, if it has one: a signal with `displacement` and `velocity`.
fn normal<F: Number>(fields: &Fields<'_>, n: usize) -> Result<Option<Normal<F>>, String> {
    let Some(node) = fields.get("normal") else { return Ok(None) };
    let part = |name: &'static str| match node.value().get(name) {
        Some(_) => node.fields()?.required(name)?.vector(n),
        None => Ok(Vec::new()),
    };
    let (displacement, velocity) = (part("displacement")?, part("velocity")?);
    Ok(Some(Normal { signal: signal(&node)?, displacement, velocity }))
}

fn element<F: Number>(
    node: &Node<'_>,
    i: usize,
    n: usize,
    laws: &mut Vec<Curved>,
) -> Result<Element<F>, String> {
    let fields = node.fields()?;
    let number = |name: &'static str| fields.required(name).and_then(|node| node.number());
    let mut direction = fields.required("direction")?.vector(n)?;
    let kind = fields.required("type")?;
    let kind = match kind.text()? {
        "contact" if fields.get("stop").is_some() => {
            Kind::UnderStop { stop: 0, coefficient: number("friction")?, peak: peak(&fields)? }
        }
        "contact" => {
            let law = match (fields.get("law"), fields.get("friction")) {
                (Some(_), Some(node)) => return Err(node.wrong("must be left out beside a law")),
                (Some(node), None) if node.value().is_object() => {
                    if let Some(node) = fields.get("peak").or_else(|| fields.get("static_ratio")) {
                        return Err(node.wrong(BESIDE_CURVE));
                    }
                    laws.push(Curved::friction(&node, i, |node, _| node.number())?);
                    Law { points: Vec::new() }
                }
                (Some(node), None) => law(&node, |node, _| node.number())?,
                (None, _) => Law::constant(number("friction")?),
            };
            Kind::Contact { law, peak: peak(&fields)?, normal: normal(&fields, n)? }
        }
        "elastic" => {
            let (stiffness, friction) = (number("stiffness")?, number("friction")?);
            Kind::Elastic { stiffness, friction, normal: normal(&fields, n)? }
        }
        "stop" => {
            let side: F = fields.get("side").map_or(Ok(F::int(1)), |node| node.number())?;
            if side.abs() != F::int(1) {
                return Err(fields.required("side")?.wrong("must be 1 or -1"));
            }
            direction.iter_mut().for_each(|b: &mut F| *b = *b * side);
            let gap = number("gap")?;
            match restitution(&fields, &["stiffness", "damping"], &["name", "belt"])? {
                Some(restitution) => Kind::HardStop { gap, restitution },
                None => {
                    let damping = fields.get("damping").map_or(Ok(F::int(0)), |node| node.number())?;
                    Kind::Stop { gap, stiffness: number("stiffness")?, damping }
                }
            }
        }
        "spring" => {
            let law = fields.required("law")?;
            let points = if law.value().is_object() {
                let odd = spring::odd(&fields)?.unwrap_or(false);
                laws.push(Curved::spring(&law, i, odd, |node, _| node.number())?);
                Vec::new()
            } else {
                spring::points(&law, &fields, pairs(&law, |node, _| node.number())?)?
            };
            Kind::Spring { points }
        }
        other => {
            let kinds = ["contact", "elastic", "stop", "spring"];
            return Err(kind.wrong(&format!("is unknown. {}", nearest(other, kinds.into_iter()))));
        }
    };
    let name = fields.get("name").map_or_else(
        || Ok(format!("element {}", i.saturating_add(1))),
        |node| node.name().map(str::to_owned),
    )?;
    let moves = fields.get("belt").map_or_else(|| Ok(Signal::constant(F::int(0))), |node| signal(&node))?;
    fields.end()?;
    Ok(Element { name, direction, moves, kind })
}
