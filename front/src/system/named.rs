//! Bodies by name, and springs, contacts, stops and loads between them and the ground.

use super::builder::Builder;
use super::decimal::is_of_a_double;
use super::described::{
    Described, MOST_COORDINATES, MOST_ELEMENTS, base_of, damped, empty, law, pairs, peak, restitution,
};
use super::laws::{BESIDE_CURVE, Law as Curved};
use super::node::{Fields, Node, Number, check_name, nearest};
use super::signals::{NEEDS, add as plus, slopes_of};
use super::smooth::second_derivative;
use super::spring;
use crate::inputs::units::{Kind as Of, Reader, System as Units};
use crate::text::Folder;
use serde_json::Value;
use stickslip::system::{Base, Element, Kind, Law, Level, Model, Moved, MovedBy, Normal, Signal, State};

/// The name of the ground.
pub(super) const GROUND: &str = "ground";

/// The system of a file of named bodies.
pub(super) fn described<F: Number>(
    root: &Node<'_>,
    folder: &Folder<'_>,
    units: Units,
) -> Result<Described<F>, String> {
    let fields = root.fields()?;
    let bodies = fields.required("masses")?.entries()?;
    let lists = |name| fields.get(name).map_or_else(|| Ok(Vec::new()), |node| node.list());
    let [springs, contacts] = [lists("springs")?, lists("contacts")?];
    let mut names: Vec<String> = bodies.iter().map(|(name, _)| (*name).to_owned()).collect();
    for spring in &springs {
        let spring = spring.fields()?;
        if spring.get("moves").is_some() {
            names.push(moved_part(&spring, END)?);
        }
    }
    for contact in &contacts {
        let contact = contact.fields()?;
        if contact.get("moves").is_some_and(|node| has_side(&node)) {
            names.push(moved_part(&contact, SIDE)?);
        }
    }
    let n = names.len();
    if n == 0 || n > MOST_COORDINATES {
        return Err(format!("masses: {n} of them, must be ≥ 1 and ≤ {MOST_COORDINATES}"));
    }
    let zero = F::int(0);
    let zeros = || vec![vec![zero; n]; n];
    let mut builder = Builder {
        model: Model {
            coordinates: names.clone(),
            mass: zeros(),
            damping: zeros(),
            stiffness: zeros(),
            constant: vec![zero; n],
            ..empty()
        },
        names,
        taken: Vec::new(),
        folder,
        base: None,
        start: State::rest(n),
        laws: Vec::new(),
    };
    let mut typed_masses = vec![None; n];
    for (i, (name, node)) in bodies.iter().enumerate() {
        check_name(name).map_err(|must| format!("masses.{name}: {must}"))?;
        if *name == GROUND {
            return Err(node.wrong("must have another name: the ground does not move"));
        }
        let mass = if node.value().is_object() {
            let body = node.fields()?;
            let moves = body.get("moves");
            let mass = if moves.is_some() { body.get("mass") } else { Some(body.required("mass")?) };
            for (field, kind, place) in [
                ("start", Of::Length, &mut builder.start.displacement),
                ("velocity", Of::Velocity, &mut builder.start.velocity),
            ] {
                if let (Some(node), Some(place)) = (body.get(field), place.get_mut(i)) {
                    *place = node.quantity(kind)?;
                }
            }
            if let Some(node) = moves {
                builder.moved(&node, &body, i)?;
            }
            body.end()?;
            mass
        } else {
            Some(node.clone())
        };
        let Some(mass) = mass else { continue };
        let value: F = mass.quantity(Of::Mass)?;
        if value < zero {
            return Err(mass.wrong("must be ≥ 0"));
        }
        add(&mut builder.model.mass, i, i, value);
        if let (Value::String(text), Some(typed)) = (mass.value(), typed_masses.get_mut(i)) {
            *typed = Reader::has_unit(text).then(|| text.trim().to_owned());
        }
    }
    for node in springs {
        builder.spring(&node.fields()?)?;
    }
    for node in contacts {
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
    for node in lists("levels")? {
        builder.level(&node.fields()?)?;
    }
    if let Some(node) = fields.get("damping") {
        builder.model = damped(builder.model, &node, &[])?;
    }
    let _ = fields.get("units");
    let _ = fields.get("about");
    fields.end()?;
    let count = builder.model.elements.len();
    if count > MOST_ELEMENTS {
        return Err(format!(
            "contacts, stops and springs with laws: {count} of them, must be ≤ {MOST_ELEMENTS}"
        ));
    }
    let inertia = builder.inertia();
    let Builder { model, names: coordinates, base, start, laws, .. } = builder;
    let units = Some(units);
    Described { model, coordinates, units, start, inertia, base, laws, shown: None, typed_masses }.checked()
}

fn add<F: Number>(matrix: &mut [Vec<F>], i: usize, j: usize, value: F) {
    if let Some(place) = matrix.get_mut(i).and_then(|row| row.get_mut(j)) {
        *place = *place + value;
    }
}

impl<F: Number> Builder<'_, F> {
    /// −M ι: the force of a unit acceleration of the base on each body.
    fn inertia(&self) -> Vec<F> {
        let sum = |row: &Vec<F>| row.iter().fold(F::int(0), |sum, &x| sum + x);
        self.model.mass.iter().map(|row| -sum(row)).collect()
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
    fn direction(&self, fields: &Fields<'_>) -> Result<(Vec<F>, [Option<usize>; 2]), String> {
        self.direction_of(&fields.required("between")?)
    }

    fn direction_of(&self, node: &Node<'_>) -> Result<(Vec<F>, [Option<usize>; 2]), String> {
        let list = node.list()?;
        let [first, second] = list.as_slice() else {
            return Err(node.wrong("must be two names, such as [\"ground\", \"block\"]"));
        };
        let ends = [self.body(first)?, self.body(second)?];
        if ends[0] == ends[1] {
            return Err(second.wrong("must differ from the first body"));
        }
        let mut direction = vec![F::int(0); self.names.len()];
        for (end, sign) in ends.into_iter().zip([-1, 1]) {
            if let Some(place) = end.and_then(|end| direction.get_mut(end)) {
                *place = F::int(sign);
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
        self.only(fields, &name)?;
        Ok(name)
    }

    /// Refuses a name that something else has: a value could not be set by it.
    fn only(&self, fields: &Fields<'_>, name: &str) -> Result<(), String> {
        let elements = self.model.elements.iter().map(|element| &element.name);
        if elements.chain(&self.names).chain(&self.taken).any(|other| other == name) {
            return Err(fields.node.wrong(&format!("the name {name} is used twice")));
        }
        Ok(())
    }

    /// The name of a spring or a force, if it has one.
    fn take_name(&mut self, fields: &Fields<'_>) -> Result<(), String> {
        let Some(node) = fields.get("name") else { return Ok(()) };
        let name = node.name()?;
        self.only(fields, name)?;
        self.taken.push(name.to_owned());
        Ok(())
    }

    fn spring(&mut self, fields: &Fields<'_>) -> Result<(), String> {
        let (direction, mut ends) = self.direction(fields)?;
        let value = |name: &'static str, kind: Of, like: &str| {
            let Some(node) = fields.get(name) else { return Ok(F::int(0)) };
            let value: F = node.quantity(kind)?;
            if value < F::int(0) {
                return Err(
                    node.wrong(&format!("must be ≥ 0 (a negative one, {like}, is given by matrices)"))
                );
            }
            Ok(value)
        };
        let stiffness = value("stiffness", Of::Stiffness, "as of a buckled strut")?;
        let damping = value("damping", Of::Damping, "which feeds the motion")?;
        if let Some(law) = fields.get("law") {
            if let Some(node) = fields.get("moves") {
                return Err(
                    node.wrong("must be left out beside a law: name the end that moves among the masses")
                );
            }
            if let Some(node) = fields.get("stiffness") {
                return Err(node.wrong("must be left out beside a law, whose slope it is"));
            }
            let name = self.name(fields)?;
            let points = if law.value().is_object() {
                let place = self.model.elements.len();
                let odd = spring::odd(fields)?.unwrap_or(false);
                self.laws.push(Curved::spring(&law, place, odd, |node, kind| node.quantity(kind))?);
                Vec::new()
            } else {
                let table = if law.value().is_string() {
                    self.columns(&law, [Of::Length, Of::Force])?
                } else {
                    pairs(&law, |node, i| node.quantity(if i == 0 { Of::Length } else { Of::Force }))?
                };
                spring::points(&law, fields, table)?
            };
            let (moves, kind) = (Signal::constant(F::int(0)), Kind::Spring { points });
            self.model.elements.push(Element { name, direction, moves, kind });
        } else {
            // For paths of other values, as that of a force.
            self.take_name(fields)?;
        }
        if let Some(node) = fields.get("moves") {
            if ends[0].is_some() {
                return Err(
                    node.wrong("needs the ground as the first end in between: it is the end that moves")
                );
            }
            let end = moved_part(fields, END)?;
            ends[0] = self.names.iter().position(|name| *name == end);
            if let Some(coordinate) = ends[0] {
                self.moved(&node, fields, coordinate)?;
            }
        }
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
        let (mut direction, _) = self.direction(fields)?;
        let name = self.name(fields)?;
        let friction = self.friction(fields)?;
        let moves = match fields.get("moves") {
            Some(node) if has_side(&node) => {
                let side = moved_part(fields, SIDE)?;
                if let Some(coordinate) = self.names.iter().position(|name| *name == side) {
                    self.moved(&node, fields, coordinate)?;
                    if let Some(place) = direction.get_mut(coordinate) {
                        *place = F::int(-1);
                    }
                }
                Signal::constant(F::int(0))
            }
            Some(node) => self.side(&node)?,
            None => Signal::constant(F::int(0)),
        };
        let elastic = fields.get("stiffness");
        if elastic.is_some()
            && let Some(node) = fields.get("peak").or_else(|| fields.get("static_ratio"))
        {
            return Err(node.wrong("must be left out of an elastic contact, which has one friction force"));
        }
        let kind = match elastic {
            Some(node) => match friction {
                Friction { law: Law { points }, normal, .. } if points.len() == 1 => Kind::Elastic {
                    stiffness: node.quantity(Of::Stiffness)?,
                    friction: points.first().map_or(F::int(0), |point| point.1),
                    normal,
                },
                Friction { .. } => {
                    return Err(
                        node.wrong("an elastic contact has one friction force or coefficient, without a law")
                    );
                }
            },
            None => {
                let ratio = peak(fields)?;
                let node = || fields.get("peak").or_else(|| fields.get("static_ratio"));
                if let (Some(node), true) = (node(), friction.is_curve) {
                    return Err(node.wrong(BESIDE_CURVE));
                }
                Kind::Contact { law: friction.law, peak: ratio, normal: friction.normal }
            }
        };
        fields.end()?;
        self.model.elements.push(Element { name, direction, moves, kind });
        Ok(())
    }

    /// The friction of a contact: a force, a coefficient with its normal load, or a law.
    fn friction(&mut self, fields: &Fields<'_>) -> Result<Friction<F>, String> {
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
            let coefficient: F = node.not_negative(Of::Ratio)?;
            if load.value().is_object() || load.value().is_array() {
                let normal = Some(self.normal(&load)?);
                return Ok(Friction { law: Law::constant(coefficient), normal, is_curve: false });
            }
            let friction = coefficient * load.at_least(load.constant(Of::Force)?, 0)?;
            return Ok(Friction { law: Law::constant(friction), normal: None, is_curve: false });
        }
        if let Some(load) = load {
            return Err(load.wrong("must be left out without a coefficient"));
        }
        let is_curve = table.as_ref().is_some_and(|node| node.value().is_object());
        let law = match (force, table) {
            (Some(node), _) => Law::constant(node.not_negative(Of::Force)?),
            (None, Some(node)) if is_curve => {
                self.laws.push(Curved::friction(&node, self.model.elements.len(), |node, kind| {
                    node.quantity(kind)
                })?);
                Law { points: Vec::new() }
            }
            (None, Some(node)) if node.value().is_string() => {
                Law { points: self.columns(&node, [Of::Velocity, Of::Force])? }
            }
            (None, Some(node)) => {
                law(&node, |node, i| node.not_negative(if i == 0 { Of::Velocity } else { Of::Force }))?
            }
            (None, None) => Law::constant(F::int(0)),
        };
        Ok(Friction { law, normal: None, is_curve })
    }

    /// The normal load of a contact: its parts over time, an acceleration upwards, and a spring.
    fn normal(&mut self, node: &Node<'_>) -> Result<Normal<F>, String> {
        if node.value().is_array() {
            let signal = self.signal(node, Of::Force)?;
            return Ok(Normal { signal, displacement: Vec::new(), velocity: Vec::new() });
        }
        let fields = node.fields()?;
        let others = ["vertical", "between", "stiffness", "damping"];
        let found = self.signal_of(&fields, Of::Force, &others)?;
        if found.is_none() && fields.get("between").is_none() {
            fields.end()?;
            return Err(node.wrong(NEEDS));
        }
        let mut signal = found.unwrap_or_else(|| Signal::constant(F::int(0)));
        if let Some(vertical) = fields.get("vertical") {
            let weight: F = fields.required("constant")?.quantity(Of::Force)?;
            let acceleration = self.over_time(&vertical, &fields, Of::Acceleration)?;
            let gravity: F = node.reader().value("g", "1 g", Of::Acceleration).map_err(|e| e.to_string())?;
            plus(&mut signal, weight / gravity, &acceleration);
        }
        let (mut displacement, mut velocity) = (Vec::new(), Vec::new());
        let spring = [fields.get("stiffness"), fields.get("damping")];
        let between = fields.get("between");
        if let (None, Some(node)) = (&between, spring.iter().flatten().next()) {
            return Err(node.wrong("needs between, the two ends of the spring that presses"));
        }
        if let Some(between) = between {
            let (direction, _) = self.direction_of(&between)?;
            let stiffness: F = fields.required("stiffness")?.quantity(Of::Stiffness)?;
            let damping: F = fields.quantity_or("damping", Of::Damping, 0)?;
            displacement = direction.iter().map(|&b| stiffness * b).collect();
            velocity = direction.iter().map(|&b| damping * b).collect();
        }
        fields.end()?;
        Ok(Normal { signal, displacement, velocity })
    }

    /// The velocity of a contact's other side.
    fn side(&mut self, node: &Node<'_>) -> Result<Signal<F>, String> {
        let (by, signal) = self.motion(node)?;
        match by {
            MovedBy::Velocity => Ok(signal),
            MovedBy::Displacement => Ok(Signal { rates: signal.records.clone(), ..self.derivative(&signal) }),
            MovedBy::Acceleration => Ok(self.integral(&signal)),
        }
    }

    /// A body whose motion is prescribed.
    fn moved(&mut self, node: &Node<'_>, body: &Fields<'_>, coordinate: usize) -> Result<(), String> {
        let (by, signal) = self.motion(node)?;
        let starts: &[&'static str] = match by {
            MovedBy::Displacement => &["start", "velocity"],
            MovedBy::Velocity => &["velocity"],
            MovedBy::Acceleration => &[],
        };
        if let Some(node) = starts.iter().find_map(|name| body.get(name)) {
            return Err(node.wrong("must be left out: the motion prescribes it"));
        }
        let mut moved = Moved { coordinate, by, signal };
        if by == MovedBy::Acceleration {
            // Waves of an acceleration have a velocity with the mean 0.
            let waves = self.integral(&moved.signal);
            let Signal { constant, sin, cos, records, .. } = &moved.signal;
            if *constant == F::int(0) && records.is_empty() && !(sin.is_empty() && cos.is_empty()) {
                moved = Moved { by: MovedBy::Velocity, signal: waves, ..moved };
            } else if let Some(velocity) = self.start.velocity.get_mut(coordinate) {
                *velocity = *velocity + waves.cos.iter().fold(F::int(0), |sum, &x| sum + x);
            }
        }
        self.model.moved.push(moved);
        Ok(())
    }

    fn stop(&mut self, fields: &Fields<'_>) -> Result<(), String> {
        let (direction, _) = self.direction(fields)?;
        let name = self.name(fields)?;
        let gap: F = fields.required("gap")?.quantity(Of::Length)?;
        let friction = ["coefficient", "along", "peak", "static_ratio"];
        let kind = match restitution(fields, &["stiffness", "damping"], &[&["name"], &friction[..]].concat())?
        {
            Some(restitution) => Kind::HardStop { gap, restitution },
            None => {
                let stiffness = fields.required("stiffness")?.quantity(Of::Stiffness)?;
                Kind::Stop { gap, stiffness, damping: fields.quantity_or("damping", Of::Damping, 0)? }
            }
        };
        let (along, peak) = (fields.get("along"), peak(fields)?);
        if let (Some(node), None) = (&along, fields.get("coefficient")) {
            return Err(node.wrong("needs the coefficient of a friction"));
        }
        let friction = match fields.get("coefficient") {
            Some(node) => {
                let along = along.map_or_else(|| fields.required("along"), Ok)?;
                let along = self.direction_of(&along)?.0;
                let coefficient = node.not_negative(Of::Ratio)?;
                let under = match kind {
                    Kind::Stop { damping, .. } if damping != F::int(0) => {
                        return Err(node.wrong(
                            "must be left out of a stop with damping: its force, and with it the friction, would begin at once",
                        ));
                    }
                    Kind::Stop { stiffness, .. } => {
                        let displacement = direction.iter().map(|&b| stiffness * b).collect();
                        let signal = Signal::constant(-(stiffness * gap));
                        let normal = Some(Normal { signal, displacement, velocity: Vec::new() });
                        Kind::Contact { law: Law::constant(coefficient), peak, normal }
                    }
                    _ => Kind::UnderStop { stop: self.model.elements.len(), coefficient, peak },
                };
                Some((along, under))
            }
            None => None,
        };
        fields.end()?;
        let moves = Signal::constant(F::int(0));
        self.model.elements.push(Element { name: name.clone(), direction, moves: moves.clone(), kind });
        if let Some((direction, kind)) = friction {
            let name = format!("{name} friction");
            self.model.elements.push(Element { name, direction, moves, kind });
        }
        Ok(())
    }

    fn force(&mut self, fields: &Fields<'_>) -> Result<(), String> {
        let body = fields.required("on")?;
        let Some(i) = self.body(&body)? else {
            return Err(body.wrong("must be a body: the ground does not move"));
        };
        self.take_name(fields)?;
        let force = unit(self.names.len(), i);
        let found = self.signal_of(fields, Of::Force, &["name"])?;
        // A misspelt name says more than a missing one.
        fields.end()?;
        let signal = found.ok_or_else(|| fields.node.wrong(NEEDS))?;
        self.load(&signal, &force);
        Ok(())
    }

    /// A value whose passage is an event.
    fn level(&mut self, fields: &Fields<'_>) -> Result<(), String> {
        let on = match (fields.get("on"), fields.get("between")) {
            (Some(_), Some(node)) => return Err(node.wrong("must be left out beside on")),
            (None, Some(node)) => self.direction_of(&node)?.0,
            (on, None) => {
                let node = on.map_or_else(|| fields.required("on"), Ok)?;
                let found = along(&self.names, &self.model, node.text()?);
                found.ok_or_else(|| {
                    let names =
                        self.names.iter().chain(self.model.elements.iter().map(|element| &element.name));
                    let near = nearest(node.text().unwrap_or(""), names.map(String::as_str));
                    node.wrong(&format!("is neither a body nor a contact or stop. {near}"))
                })?
            }
        };
        let name = self.name(fields)?;
        if self.model.levels.iter().any(|level| level.name == name) {
            return Err(fields.node.wrong(&format!("the name {name} is used twice")));
        }
        let (displacement, velocity, value) = match (fields.get("displacement"), fields.get("velocity")) {
            (Some(node), None) => (on, Vec::new(), node.quantity(Of::Length)?),
            (None, Some(node)) => (Vec::new(), on, node.quantity(Of::Velocity)?),
            (given, _) => {
                fields.end()?;
                let what = if given.is_some() { "must have only" } else { "needs" };
                return Err(fields.node.wrong(&format!("{what} one of displacement and velocity")));
            }
        };
        fields.end()?;
        self.model.levels.push(Level { name, displacement, velocity, value });
        Ok(())
    }

    /// The motion of the base, over which all displacements are measured.
    fn base(&mut self, node: &Node<'_>) -> Result<(), String> {
        let fields = node.fields()?;
        let kinds = [
            ("acceleration", MovedBy::Acceleration, Of::Acceleration),
            ("velocity", MovedBy::Velocity, Of::Velocity),
            ("displacement", MovedBy::Displacement, Of::Length),
        ];
        let mut given = kinds.iter().filter_map(|(name, by, kind)| Some((fields.get(name)?, *by, *kind)));
        let Some((node, by, kind)) = given.next() else {
            return Err(fields.required("acceleration").map_or_else(|e| e, |node| node.wrong("is missing")));
        };
        if let Some((other, ..)) = given.next() {
            return Err(other.wrong("must be left out beside another quantity of the motion"));
        }
        drop(given);
        let signal = self.over_time(&node, &fields, kind)?;
        let acceleration = match by {
            MovedBy::Acceleration => signal,
            MovedBy::Velocity => {
                let Signal { records, .. } = self.of_records(&node, &signal, slopes_of)?;
                Signal { records, ..self.derivative(&signal) }
            }
            // Between straight lines the velocity would change at once.
            MovedBy::Displacement => {
                let Signal { records, .. } = self.of_records(&node, &signal, second_derivative)?;
                Signal { records, ..self.derivative(&self.derivative(&signal)) }
            }
        };
        let force = self.inertia();
        self.load(&acceleration, &force);
        let base = Base { acceleration, ..base_of(force.len()) };
        self.base = Some(base);
        fields.end()
    }
}

/// The friction of a contact, and its normal load where it varies.
struct Friction<F> {
    law: Law<F>,
    normal: Option<Normal<F>>,
    /// Whether the law is a curve, which has no points yet.
    is_curve: bool,
}

/// The direction of a body or of an element by its name.
pub(super) fn along<F: Number>(bodies: &[String], model: &Model<F>, name: &str) -> Option<Vec<F>> {
    let body = bodies.iter().position(|own| own == name).map(|place| unit(bodies.len(), place));
    let element = || model.elements.iter().find(|element| element.name == name);
    body.or_else(|| element().map(|element| element.direction.clone()))
}

/// What is moved of a spring, and of a contact.
const END: &str = "end";
const SIDE: &str = "side";

/// The name of the coordinate of the end of a spring, or of the side of a contact, that is moved.
fn moved_part(fields: &Fields<'_>, part: &str) -> Result<String, String> {
    let name = fields.get("name").map(|node| node.name().map(str::to_owned)).transpose()?;
    Ok(format!("{} {part}", name.unwrap_or_else(|| fields.node.place().to_owned())))
}

/// Whether the motion of a contact's side needs a coordinate: an acceleration other than sines, whose velocity is no wave or record.
fn has_side(moves: &Node<'_>) -> bool {
    fn is_sine(value: &Value) -> bool {
        match value {
            Value::Array(parts) => parts.iter().all(is_sine),
            Value::Object(wave) => wave.iter().all(|(name, value)| match name.as_str() {
                "amplitude" | "frequency" | "phase" => true,
                "shape" => value == "sine",
                "waves" => is_sine(value),
                _ => false,
            }),
            _ => false,
        }
    }
    moves.value().get("acceleration").is_some_and(|value| !is_sine(value))
}

/// 1 at a place, and 0 elsewhere.
fn unit<F: Number>(n: usize, place: usize) -> Vec<F> {
    (0..n).map(|i| F::int(i32::from(i == place))).collect()
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

/// A value as it is typed: a number, or a text.
pub(super) fn typed(text: &str) -> Value {
    let number =
        text.parse::<f64>().ok().filter(|_| is_of_a_double(text)).and_then(serde_json::Number::from_f64);
    number.map_or_else(|| Value::String(text.to_owned()), Value::Number)
}

/// Sets a value of the file, by `name.field` of a named contact, spring, stop or body, or by its place.
pub(super) fn set(file: &mut Value, path: &str, text: &str) -> Result<(), String> {
    let about = |what: &str| format!("{path}={text}: {what}");
    let value = typed(text);
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
