//! A system as its file describes it, and the parts that bodies by name and matrices share.

use super::laws::Law as Curved;
use super::node::{Fields, Node, Number, is_double};
use crate::inputs::units::{Kind as Of, Reader, System as Units};
use stickslip::motion::record::Record as Measured;
use stickslip::system::{Base, Beyond, Error, Law, Level, Model, Record, Signal, State, System};

/// The greatest number of coordinates: the matrices are dense, 0.5 GB of them.
pub(super) const MOST_COORDINATES: usize = 2000;
/// That of numbers with more bits than a double, whose matrices take far more memory and time.
const MOST_OF_MANY_BITS: usize = 200;
/// The greatest number of elements.
pub(super) const MOST_ELEMENTS: usize = 200;
/// The greatest number of frequencies of the loads: beyond it each step takes more than a millisecond.
pub(super) const MOST_FREQUENCIES: usize = 20_000;
/// The greatest number of records.
pub(super) const MOST_RECORDS: usize = 200;
/// The greatest sum of 4 per coordinate and 70 per contact and stop, for each frequency and record: twice this are the numbers of a
/// branch that belong to loads, 50 MB.
const MOST_NUMBERS_OF_LOADS: usize = 3_000_000;
/// The greatest number of samples of all records together, which stay in memory.
pub(super) const MOST_SAMPLES: usize = 2_000_000;

/// A system as its file describes it, with the names of its parts.
#[derive(Debug, Clone)]
pub struct Described<F = f64> {
    /// Matrices, loads and elements, in SI units or in the consistent units of the matrices.
    pub model: Model<F>,
    /// The names of the coordinates: those of the bodies, or q1, q2, …
    pub coordinates: Vec<String>,
    /// The system of units; `None` for matrices whose file names none: they are any consistent ones.
    pub units: Option<Units>,
    /// Displacements and velocities at the beginning.
    pub start: State<F>,
    /// The force on each coordinate under a unit acceleration of the base, −M ι, where every coordinate is a
    /// displacement over the base.
    pub(super) inertia: Vec<F>,
    /// The motion of the base, if it moves.
    pub base: Option<Base<F>>,
    /// The laws that are curves.
    pub(super) laws: Vec<Curved>,
    /// The places of the coordinates that are chosen for answers; `None` are all.
    pub(super) shown: Option<Vec<usize>>,
    /// The masses of bodies as they are typed, where they have a unit of their own.
    pub(super) typed_masses: Vec<Option<String>>,
}

impl<F: Number> Described<F> {
    /// The name of what an event is of: an element, or a level.
    #[must_use]
    pub fn name_of(&self, element: usize) -> &str {
        let Model { elements, levels, .. } = &self.model;
        let names =
            elements.iter().map(|element| &element.name).chain(levels.iter().map(|level| &level.name));
        names.map(String::as_str).nth(element).unwrap_or("")
    }

    /// The mass of a body as it is typed, where it has a unit of its own.
    #[must_use]
    pub fn typed_mass(&self, body: usize) -> Option<&str> {
        self.typed_masses.get(body)?.as_deref()
    }

    /// The law of an element in words, where it is a curve.
    #[must_use]
    pub fn curve(&self, element: usize) -> Option<String> {
        self.laws.iter().find(|law| law.element == element).map(Curved::words)
    }

    /// Names the base without a motion of its own, as under a record in numbers of another type.
    pub fn stands_on_a_base(&mut self) {
        self.base.get_or_insert_with(|| base_of(self.inertia.len()));
    }

    /// Takes over the names of the levels of this system in numbers of another type.
    pub fn name_levels<G: Number>(&mut self, other: &Described<G>) {
        let name = |level: &Level<G>| Level {
            name: level.name.clone(),
            displacement: Vec::new(),
            velocity: Vec::new(),
            value: F::int(0),
        };
        self.model.levels = other.model.levels.iter().map(name).collect();
    }

    /// Adds a record of the base's acceleration.
    pub(super) fn shake(&mut self, record: Record<F>) {
        let Self { model, inertia, base, .. } = self;
        let records = &mut base.get_or_insert_with(|| base_of(inertia.len())).acceleration.records;
        records.resize(model.records.len(), F::int(0));
        records.push(F::int(1));
        model.records.push(Record { force: inertia.clone(), ..record });
    }

    /// The motions of this model on this base.
    pub(super) fn moving(&self, model: &Model<F>) -> Result<System<F>, Error> {
        let system = System::new(model)?;
        match &self.base {
            Some(base) => system.with_base(base),
            None => Ok(system),
        }
    }

    /// This system, where its matrices and loads have room in memory.
    pub(super) fn checked(self) -> Result<Self, String> {
        let Model { mass, harmonics, records, elements, .. } = &self.model;
        let n = mass.len();
        if n > MOST_OF_MANY_BITS && !is_double::<F>() {
            return Err(format!(
                "{n} coordinates, must be ≤ {MOST_OF_MANY_BITS} with more bits than a double has"
            ));
        }
        let each = mass.len().saturating_mul(4).saturating_add(elements.len().saturating_mul(70));
        let most = MOST_NUMBERS_OF_LOADS.checked_div(each).unwrap_or(MOST_FREQUENCIES);
        let found = harmonics.len().saturating_add(records.len());
        if found > most {
            return Err(format!(
                "loads: {found} frequencies and records, must be ≤ {most} with these coordinates, contacts and stops"
            ));
        }
        Ok(self)
    }
}

/// Adds damping by modes: `rayleigh`, two factors of the masses and of the stiffnesses, and `ratio`, one for all elastic modes or a list by
/// mode, beside `others`, which are read elsewhere. The dampers of the model are there already.
pub(super) fn damped<F: Number>(
    mut model: Model<F>,
    node: &Node<'_>,
    others: &[&'static str],
) -> Result<Model<F>, String> {
    let fields = node.fields()?;
    if ["rayleigh", "ratio"].iter().chain(others).all(|name| fields.get(name).is_none()) {
        // A misspelt name says more than a missing one.
        fields.end()?;
        return Err(node.wrong("needs one of rayleigh and ratio"));
    }
    let about = |node: &Node<'_>, error: &Error| format!("{}: {error}", node.place());
    if let Some(node) = fields.get("rayleigh") {
        let list = node.list()?;
        let [of_mass, of_stiffness] = list.as_slice() else {
            return Err(node.wrong(
                "must be two numbers, [a, b] of C = a M + b K: a in 1/s, and b in s or as a text with a unit",
            ));
        };
        let has_unit = of_stiffness.value().as_str().is_some_and(Reader::has_unit);
        let b = if has_unit { of_stiffness.quantity(Of::Time)? } else { of_stiffness.number()? };
        model = model.with_rayleigh(of_mass.number()?, b).map_err(|e| about(&node, &e))?;
    }
    if let Some(node) = fields.get("ratio") {
        let given = if node.value().is_array() { node.list()? } else { vec![node.clone()] };
        if given.is_empty() {
            return Err(node.wrong("must have a damping ratio, such as \"2 %\""));
        }
        let ratios: Vec<F> =
            given.iter().map(|node| node.not_negative(Of::Ratio)).collect::<Result<_, _>>()?;
        model = model.with_damping_ratios(&ratios).map_err(|e| match e {
            Error::TooMany { most: 0, .. } => node.wrong("must be left out: no spring restores a motion"),
            Error::TooMany { found, most, .. } => node.wrong(&format!(
                "has {found} ratios, must have ≤ {most}, one for each mode with a restoring force"
            )),
            other => about(&node, &other),
        })?;
    }
    fields.end_with(others)?;
    Ok(model)
}

/// A model without a part.
pub(super) const fn empty<F>() -> Model<F> {
    Model {
        coordinates: Vec::new(),
        mass: Vec::new(),
        damping: Vec::new(),
        stiffness: Vec::new(),
        elements: Vec::new(),
        constant: Vec::new(),
        harmonics: Vec::new(),
        records: Vec::new(),
        moved: Vec::new(),
        levels: Vec::new(),
    }
}

/// The base of coordinates that are displacements over it, at rest so far.
pub(super) fn base_of<F: Number>(coordinates: usize) -> Base<F> {
    Base { influence: vec![F::int(1); coordinates], acceleration: Signal::constant(F::int(0)) }
}

/// The static friction over the kinetic one, under either name.
pub(super) fn peak<F: Number>(fields: &Fields<'_>) -> Result<F, String> {
    match (fields.get("peak"), fields.get("static_ratio")) {
        (Some(_), Some(node)) => Err(node.wrong("must be left out beside peak, which is the same")),
        (Some(node), None) | (None, Some(node)) => node.at_least(node.number()?, 1),
        (None, None) => Ok(F::int(1)),
    }
}

/// The restitution of a stop that gives no way, from 0 to 1; none for an elastic stop. `elastic` are the fields of that one, and `others`
/// those of both, which are read elsewhere.
pub(super) fn restitution<F: Number>(
    fields: &Fields<'_>,
    elastic: &[&'static str],
    others: &[&'static str],
) -> Result<Option<F>, String> {
    let Some(node) = fields.get("restitution") else {
        if fields.get("stiffness").is_none() {
            // A misspelt name says more than a missing one.
            fields.end_with(&[elastic, others].concat())?;
            return Err(fields.node.wrong("needs one of stiffness and restitution"));
        }
        return Ok(None);
    };
    if let Some(node) = elastic.iter().find_map(|name| fields.get(name)) {
        return Err(node.wrong("must be left out of a stop with a restitution, which gives no way"));
    }
    let value = node.at_least(node.number()?, 0)?;
    if value > F::int(1) {
        return Err(node.wrong("must be ≤ 1"));
    }
    Ok(Some(value))
}

/// A law from pairs of a speed and a force.
pub(super) fn law<F: Number>(
    node: &Node<'_>,
    of: impl Fn(&Node<'_>, usize) -> Result<F, String>,
) -> Result<Law<F>, String> {
    Ok(Law { points: pairs(node, of)? })
}

/// Pairs of a speed or a displacement, and a force.
pub(super) fn pairs<F>(
    node: &Node<'_>,
    of: impl Fn(&Node<'_>, usize) -> Result<F, String>,
) -> Result<Vec<(F, F)>, String> {
    let pair = |node: &Node<'_>| match node.list()?.as_slice() {
        [first, force] => Ok((of(first, 0)?, of(force, 1)?)),
        _ => Err(node.wrong("must be a pair of a speed, of a spring a displacement, and a force")),
    };
    node.list()?.iter().map(pair).collect()
}

/// The samples of a record without a force.
pub(super) fn samples<F: Number>(record: &Measured<F>, beyond: Beyond) -> Record<F> {
    let values = record.samples().to_vec();
    let times = (0..values.len()).map(|i| record.time(i)).collect();
    Record { times, values, force: Vec::new(), beyond }
}
