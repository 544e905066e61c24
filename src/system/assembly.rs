//! A checked system: its state, and rows over the state for forces, stretches and velocities.
//!
//! The state z has the displacements q, the velocities q′, the forces of the elastic contacts, (sin ωt, cos ωt)
//! of each harmonic, (p, p′) of each record, and 1.

use super::dependent::{rank, too_many};
use super::error::Error;
use super::given::{at_least, check_record, column, finite, padded, place, positive, square, vector};
use super::matrix::{Matrix, add_times, dot, set};
use super::model::{Base, Element, Kind, Model, Moved, MovedBy, Normal, Record, Signal};
use super::pieces::{Piece, pieces};
use crate::float::Float;
use crate::machine::error::written;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec;
use alloc::vec::Vec;
use core::ops::ControlFlow;

/// The law of an element, ready for use.
#[derive(Debug, Clone)]
pub(crate) enum Rule<F> {
    /// `normal` is the row of N; without it N = 1.
    Contact {
        pieces: Vec<Piece<F>>,
        peak: F,
        normal: Option<Vec<F>>,
    },
    /// `place` is the force's place in the state; `bound` the row of friction N.
    Elastic {
        stiffness: F,
        place: usize,
        bound: Vec<F>,
        normal: Option<Vec<F>>,
    },
    /// `depth` is the row of y − gap.
    Stop {
        depth: Vec<F>,
        stiffness: F,
        damping: F,
    },
    /// A stop that gives no way.
    Hard {
        depth: Vec<F>,
        restitution: F,
    },
    Spring {
        pieces: Vec<Piece<F>>,
    },
}

/// An element, ready for use.
#[derive(Debug, Clone)]
pub(crate) struct Part<F> {
    pub(crate) name: String,
    /// b.
    pub(crate) direction: Vec<F>,
    /// M⁻¹b.
    pub(crate) response: Vec<F>,
    /// The row of v.
    pub(crate) velocity: Vec<F>,
    /// The row of y; none where the other side travels without end, or by a record.
    pub(crate) stretch: Option<Vec<F>>,
    /// The row of V′, less the accelerations that are prescribed to coordinates.
    pub(crate) moves: Vec<F>,
    pub(crate) rule: Rule<F>,
    /// The speed, or the size of the stretch, up to which the law is known; none where it is known everywhere.
    pub(crate) limit: Option<F>,
    /// The stop that gives no way whose force is the normal load of this contact. The load has a row where that stop is in touch
    /// ([`loaded`](super::under::loaded)); else it is below 0.
    pub(crate) under: Option<usize>,
}

impl<F: Float> Part<F> {
    /// The row of the normal load, where it varies.
    pub(crate) fn normal(&self) -> Option<&[F]> {
        match &self.rule {
            Rule::Contact { normal, .. } | Rule::Elastic { normal, .. } => normal.as_deref(),
            Rule::Stop { .. } | Rule::Hard { .. } | Rule::Spring { .. } => None,
        }
    }

    /// Whether it keeps a velocity of 0 by a force that is sought: a contact that may stick, a stop that gives no way.
    pub(crate) const fn may_hold(&self) -> bool {
        matches!(self.rule, Rule::Contact { .. } | Rule::Hard { .. })
    }
}

/// A coordinate whose motion is prescribed.
#[derive(Debug, Clone)]
pub(crate) struct Driven<F> {
    pub(crate) coordinate: usize,
    /// The rows of its displacement and its velocity, where they are prescribed.
    pub(crate) displacement: Option<Vec<F>>,
    pub(crate) velocity: Option<Vec<F>>,
    /// The row of its acceleration between the samples of records.
    pub(crate) acceleration: Vec<F>,
}

/// A checked system.
#[derive(Debug, Clone)]
pub(crate) struct Assembly<F> {
    /// The number of coordinates.
    pub(crate) n: usize,
    /// The size of the state.
    pub(crate) size: usize,
    /// The number of states that are not given functions of time: q, q′ and elastic forces.
    pub(crate) free: usize,
    pub(crate) mass: Matrix<F>,
    pub(crate) damping: Matrix<F>,
    pub(crate) stiffness: Matrix<F>,
    pub(crate) inverse_mass: Matrix<F>,
    /// The rows of f − C q′ − K q, without elements.
    pub(crate) force: Matrix<F>,
    /// The rows of f alone.
    pub(crate) load: Matrix<F>,
    pub(crate) parts: Vec<Part<F>>,
    /// bᵢ·M⁻¹bⱼ.
    pub(crate) coupling: Matrix<F>,
    /// Whether the direction of a contact, or of a stop that gives no way, is a combination of those of others.
    pub(crate) is_dependent: bool,
    pub(crate) frequencies: Vec<F>,
    pub(crate) records: Vec<Record<F>>,
    pub(crate) moved: Vec<Driven<F>>,
    /// The coordinates without mass that are not moved.
    pub(crate) massless: Vec<usize>,
    /// The names of coordinates, as far as they have one.
    pub(crate) names: Vec<String>,
    /// The rows of the quantities of the levels, less their values.
    pub(crate) levels: Vec<Vec<F>>,
    /// Whether a sample of a record may change a velocity at once.
    pub(crate) jerks: bool,
    /// The elements whose other side moves, and which may carry a body along.
    pub(crate) carriers: Vec<usize>,
    /// The row of the base's acceleration at each coordinate; none without a base.
    pub(crate) base: Vec<Vec<F>>,
    /// Whether fast modes are set apart, and large branches with few entries are followed by series.
    pub(crate) shortcuts: bool,
    /// Whether motions are followed further.
    pub(crate) keep_going: fn() -> ControlFlow<()>,
}

impl<F: Float> Assembly<F> {
    /// Checks a model, and builds its rows.
    pub(crate) fn new(model: &Model<F>) -> Result<Self, Error> {
        let n = model.mass.len();
        if n == 0 {
            return Err(Error::Length { name: "mass".to_string(), found: 0, expected: 1 });
        }
        let mass = square("mass", &model.mass, n, true)?;
        let damping = square("damping", &model.damping, n, false)?;
        let stiffness = square("stiffness", &model.stiffness, n, false)?;
        let inverse_mass = inverse(&mass, &model.moved, &massless(model))?;
        let elastic = model.elements.iter().filter(|e| matches!(e.kind, Kind::Elastic { .. })).count();
        let free = 2 * n + elastic;
        let inputs = free + 2 * model.harmonics.len();
        let size = inputs + 2 * model.records.len() + 1;
        let mut load = Matrix::zero(n, size);
        column(&mut load, size - 1, "constant", &model.constant)?;
        for (i, harmonic) in model.harmonics.iter().enumerate() {
            let name = place("harmonics", i);
            positive(&format!("{name}.frequency"), harmonic.frequency)?;
            column(&mut load, free + 2 * i, &format!("{name}.sin"), &harmonic.sin)?;
            column(&mut load, free + 2 * i + 1, &format!("{name}.cos"), &harmonic.cos)?;
        }
        for (i, record) in model.records.iter().enumerate() {
            let name = place("records", i);
            check_record(&name, record)?;
            column(&mut load, inputs + 2 * i, &format!("{name}.force"), &record.force)?;
        }
        let mut force = load.clone();
        for i in 0..n {
            add_times(force.row_mut(i), F::int(-1), stiffness.row(i));
            let velocities = force.row_mut(i).get_mut(n..2 * n).unwrap_or(&mut []);
            add_times(velocities, F::int(-1), damping.row(i));
        }
        let mut assembly = Self {
            n,
            size,
            free,
            mass,
            damping,
            stiffness,
            inverse_mass,
            force,
            load,
            parts: Vec::new(),
            coupling: Matrix::zero(0, 0),
            is_dependent: false,
            frequencies: model.harmonics.iter().map(|h| h.frequency).collect(),
            records: model.records.clone(),
            moved: Vec::new(),
            massless: massless(model),
            names: model.coordinates.clone(),
            levels: Vec::new(),
            jerks: false,
            carriers: Vec::new(),
            base: Vec::new(),
            shortcuts: true,
            keep_going: || ControlFlow::Continue(()),
        };
        for (i, level) in model.levels.iter().enumerate() {
            let name = if level.name.is_empty() { self::place("levels", i) } else { level.name.clone() };
            let mut row = vec![F::int(0); size];
            add_times(
                &mut row,
                F::int(1),
                &padded(&format!("{name}: displacement"), &level.displacement, n)?,
            );
            let velocity = padded(&format!("{name}: velocity"), &level.velocity, n)?;
            add_times(row.get_mut(n..).unwrap_or(&mut []), F::int(1), &velocity);
            if let Some(last) = row.last_mut() {
                *last = -finite(&format!("{name}: value"), level.value)?;
            }
            assembly.levels.push(row);
        }
        for (i, moved) in model.moved.iter().enumerate() {
            let driven = assembly.driven(&self::place("moved", i), moved)?;
            assembly.moved.push(driven);
        }
        let mut place = 2 * n;
        for (i, element) in model.elements.iter().enumerate() {
            let part = assembly.part(element, i, place)?;
            place += usize::from(matches!(part.rule, Rule::Elastic { .. }));
            assembly.parts.push(part);
        }
        let by_records = |row: &[F]| {
            let places = assembly.record(0)..size - 1;
            row.get(places).is_some_and(|row| row.iter().any(|&x| x != F::int(0)))
        };
        assembly.jerks = assembly.parts.iter().any(|part| by_records(&part.velocity))
            || assembly.massless.iter().any(|&i| by_records(assembly.load.row(i)))
            || assembly
                .parts
                .iter()
                .any(|part| assembly.is_light(part) && part.normal().is_some_and(by_records))
            || assembly.moved.iter().any(|moved| moved.velocity.as_deref().is_some_and(by_records));
        let carries = |part: &Part<F>| part.velocity.iter().skip(2 * n).any(|x| *x != F::int(0));
        let held = assembly.parts.iter().enumerate().filter(|(_, part)| part.may_hold() && carries(part));
        let carriers = held.map(|(i, _)| i).collect();
        assembly.carriers = carriers;
        let count = assembly.parts.len();
        let mut coupling = Matrix::zero(count, count);
        for (i, a) in assembly.parts.iter().enumerate() {
            for (j, b) in assembly.parts.iter().enumerate() {
                coupling.set(i, j, dot(&a.direction, &b.response));
            }
        }
        assembly.coupling = coupling;
        assembly.check_under()?;
        let contacts: Vec<&[F]> =
            assembly.parts.iter().filter(|part| part.may_hold()).map(|p| p.direction.as_slice()).collect();
        assembly.is_dependent = rank(&contacts) < contacts.len();
        if assembly.is_dependent && too_many(&contacts) {
            return Err(Error::Unsupported {
                name: "elements".to_string(),
                condition: "must have at most 14 contacts and stops with a restitution whose directions depend on each other, parallel \
                            ones counted once, or 20000 connected sets of bodies where each of them joins two",
            });
        }
        if !assembly.massless.is_empty() {
            assembly.check_massless()?;
        }
        Ok(assembly)
    }

    /// The rows of `influence · acceleration` of a base.
    pub(crate) fn rows_of_base(&self, base: &Base<F>) -> Result<Vec<Vec<F>>, Error> {
        let influence = vector("base: influence", &base.influence, self.n)?;
        let row = self.signal("base: acceleration", &base.acceleration)?;
        Ok(influence.iter().map(|&by| row.iter().map(|&x| x * by).collect()).collect())
    }

    /// bᵢ·M⁻¹bⱼ of some elements.
    pub(crate) fn coupling_of(&self, elements: &[usize]) -> Matrix<F> {
        let mut matrix = Matrix::zero(elements.len(), elements.len());
        for (a, &i) in elements.iter().enumerate() {
            elements.iter().enumerate().for_each(|(b, &j)| matrix.set(a, b, self.coupling.at(i, j)));
        }
        matrix
    }

    /// The velocity b·q′ of the bodies along an element.
    pub(crate) fn along(&self, element: usize, z: &[F]) -> F {
        let velocities = z.get(self.n..2 * self.n).unwrap_or(&[]);
        self.parts.get(element).map_or(F::int(0), |part| dot(&part.direction, velocities))
    }

    /// The greatest size of each state that is a given function of time.
    pub(crate) fn reach(&self) -> Vec<F> {
        let waves = self.frequencies.iter().flat_map(|_| [F::int(1); 2]);
        let records = self.records.iter().flat_map(|record| <[F; 2]>::from(record.reach()));
        waves.chain(records).chain([F::int(1)]).collect()
    }

    /// The place of sin ωt of a harmonic; that of cos ωt is the next.
    pub(crate) const fn harmonic(&self, i: usize) -> usize {
        self.free + 2 * i
    }

    /// The place of a record's value; that of its slope is the next.
    pub(crate) const fn record(&self, i: usize) -> usize {
        self.free + 2 * self.frequencies.len() + 2 * i
    }

    /// The row of a signal.
    fn signal(&self, name: &str, signal: &Signal<F>) -> Result<Vec<F>, Error> {
        let mut row = vec![F::int(0); self.size];
        if let Some(last) = row.last_mut() {
            *last = finite(&format!("{name}.constant"), signal.constant)?;
        }
        let (waves, records) = (self.frequencies.len(), self.records.len());
        for (list, word, expected, first) in [
            (&signal.sin, "sin", waves, self.harmonic(0)),
            (&signal.cos, "cos", waves, self.harmonic(0) + 1),
            (&signal.records, "records", records, self.record(0)),
            (&signal.rates, "rates", records, self.record(0) + 1),
        ] {
            if list.len() > expected {
                return Err(Error::Length { name: format!("{name}.{word}"), found: list.len(), expected });
            }
            for (i, &x) in list.iter().enumerate() {
                let x = finite(&place(&format!("{name}.{word}"), i), x)?;
                if let Some(place) = row.get_mut(first + 2 * i) {
                    *place = x;
                }
            }
        }
        Ok(row)
    }

    /// The row of a signal's derivative between the samples of records.
    pub(crate) fn derivative(&self, row: &[F]) -> Vec<F> {
        let mut result = vec![F::int(0); self.size];
        for (i, &frequency) in self.frequencies.iter().enumerate() {
            let place = self.harmonic(i);
            let [sin, cos] = [place, place + 1].map(|k| row.get(k).copied().unwrap_or(F::int(0)));
            for (k, x) in [(place, -frequency * cos), (place + 1, frequency * sin)] {
                if let Some(result) = result.get_mut(k) {
                    *result = x;
                }
            }
        }
        for i in 0..self.records.len() {
            let place = self.record(i);
            if let (Some(result), Some(&by)) = (result.get_mut(place + 1), row.get(place)) {
                *result = by;
            }
        }
        result
    }

    /// The rows of a coordinate that is moved.
    fn driven(&self, name: &str, moved: &Moved<F>) -> Result<Driven<F>, Error> {
        let unsupported = |name: String, condition| Err(Error::Unsupported { name, condition });
        if moved.coordinate >= self.n || self.moved.iter().any(|other| other.coordinate == moved.coordinate) {
            return unsupported(format!("{name}.coordinate"), "must be another one of the coordinates");
        }
        if moved.signal.rates.iter().any(|&by| by != F::int(0)) {
            return unsupported(format!("{name}.signal.rates"), "must be empty: prescribe another quantity");
        }
        let row = self.signal(&format!("{name}.signal"), &moved.signal)?;
        let (first, coordinate) = (self.derivative(&row), moved.coordinate);
        Ok(match moved.by {
            MovedBy::Displacement => {
                let acceleration = self.derivative(&first);
                Driven { coordinate, displacement: Some(row), velocity: Some(first), acceleration }
            }
            MovedBy::Velocity => {
                Driven { coordinate, displacement: None, velocity: Some(row), acceleration: first }
            }
            MovedBy::Acceleration => {
                Driven { coordinate, displacement: None, velocity: None, acceleration: row }
            }
        })
    }

    /// The row of a normal load.
    fn normal(&self, name: &str, normal: &Normal<F>) -> Result<Vec<F>, Error> {
        let name = format!("{name}: normal");
        let signal = &normal.signal;
        let mut row = self.signal(&name, signal)?;
        let is_used = |list: &[F], i: usize| list.get(i).is_some_and(|&by| by != F::int(0));
        let jumps =
            self.records.iter().enumerate().any(|(i, record)| {
                is_used(&signal.rates, i) || (is_used(&signal.records, i) && record.jumps())
            });
        if jumps {
            return Err(Error::Unsupported {
                name,
                condition: "must not change at once: the friction would, too. Give a steep straight line between the values",
            });
        }
        let n = self.n;
        let displacement = padded(&format!("{name}.displacement"), &normal.displacement, n)?;
        let velocity = padded(&format!("{name}.velocity"), &normal.velocity, n)?;
        add_times(&mut row, F::int(1), &displacement);
        add_times(row.get_mut(n..).unwrap_or(&mut []), F::int(1), &velocity);
        Ok(row)
    }

    /// The row of `y = b·q − Y`, where `Y = ∫V` of waves is `−(s/ω) cos ωt + (c/ω) sin ωt`.
    fn stretch(&self, direction: &[F], moving: &[F]) -> Vec<F> {
        let mut row = vec![F::int(0); self.size];
        add_times(&mut row, F::int(1), direction);
        for (k, &frequency) in self.frequencies.iter().enumerate() {
            let at = self.harmonic(k);
            let [sin, cos] = [at, at + 1].map(|j| moving.get(j).copied().unwrap_or(F::int(0)));
            for (j, x) in [(at, -cos / frequency), (at + 1, sin / frequency)] {
                if let Some(row) = row.get_mut(j) {
                    *row = x;
                }
            }
        }
        row
    }

    /// An element with its rows.
    fn part(&self, element: &Element<F>, i: usize, place: usize) -> Result<Part<F>, Error> {
        let name = if element.name.is_empty() { self::place("elements", i) } else { element.name.clone() };
        let (n, zero) = (self.n, F::int(0));
        let direction = vector(&format!("{name}: direction"), &element.direction, n)?;
        if direction.iter().all(|&x| x == zero) {
            return Err(Error::Unsupported {
                name: format!("{name}: direction"),
                condition: "must have an entry other than 0",
            });
        }
        let moving = self.signal(&format!("{name}: moves"), &element.moves)?;
        let mut velocity: Vec<F> = moving.iter().map(|&x| -x).collect();
        add_times(velocity.get_mut(n..).unwrap_or(&mut []), F::int(1), &direction);
        let travels = moving.iter().skip(self.record(0)).any(|&x| x != zero);
        let stretch = (!travels).then(|| self.stretch(&direction, &moving));
        let rule = match &element.kind {
            Kind::Contact { law, peak, normal } => {
                let pieces = pieces(&name, law)?;
                let peak = at_least(&format!("{name}: peak"), *peak, F::int(1))?;
                if normal.is_some() && law.points.len() > 1 {
                    return Err(Error::Unsupported {
                        name: format!("{name}: law"),
                        condition: "must have one point where the normal load varies: the product of a load and of a friction that \
                                    both change is not linear. Give one coefficient, or a constant normal load",
                    });
                }
                let normal = normal.as_ref().map(|normal| self.normal(&name, normal)).transpose()?;
                Rule::Contact { pieces, peak, normal }
            }
            Kind::UnderStop { coefficient, peak, .. } => {
                let coefficient = at_least(&format!("{name}: coefficient"), *coefficient, zero)?;
                let peak = at_least(&format!("{name}: peak"), *peak, F::int(1))?;
                let pieces = vec![Piece { from: zero, force: coefficient, slope: zero }];
                let mut open = vec![zero; self.size];
                set(&mut open, self.size - 1, F::int(-1));
                Rule::Contact { pieces, peak, normal: Some(open) }
            }
            Kind::Elastic { stiffness, friction, normal } => {
                let stiffness = positive(&format!("{name}: stiffness"), *stiffness)?;
                let friction = positive(&format!("{name}: friction"), *friction)?;
                let normal = normal.as_ref().map(|normal| self.normal(&name, normal)).transpose()?;
                let mut bound = normal.clone().unwrap_or_else(|| unit(self.size, self.size - 1));
                bound.iter_mut().for_each(|x| *x = *x * friction);
                Rule::Elastic { stiffness, place, bound, normal }
            }
            Kind::Stop { gap, stiffness, damping } => Rule::Stop {
                depth: depth(&name, stretch.as_ref(), *gap)?,
                stiffness: positive(&format!("{name}: stiffness"), *stiffness)?,
                damping: at_least(&format!("{name}: damping"), *damping, zero)?,
            },
            Kind::HardStop { gap, restitution } => Rule::Hard {
                depth: depth(&name, stretch.as_ref(), *gap)?,
                restitution: share(&format!("{name}: restitution"), *restitution)?,
            },
            Kind::Spring { points } => {
                if stretch.is_none() {
                    return Err(Error::Unsupported {
                        name: format!("{name}: moves.constant"),
                        condition: "must be 0, as the factors of records: the other side of a spring moves by waves",
                    });
                }
                Rule::Spring { pieces: super::spring::pieces(&name, points)? }
            }
        };
        let response = self.inverse_mass.of(&direction);
        if matches!(rule, Rule::Hard { .. }) && dot(&direction, &response) <= zero {
            return Err(Error::Unsupported {
                name: format!("{name}: direction"),
                condition: "must move a mass: a stop with a restitution acts on a body that is not moved as prescribed",
            });
        }
        let mut moves = self.derivative(&moving);
        for driven in &self.moved {
            let by = direction.get(driven.coordinate).copied().unwrap_or(zero);
            add_times(&mut moves, -by, &driven.acceleration);
        }
        let under = if let Kind::UnderStop { stop, .. } = &element.kind { Some(*stop) } else { None };
        Ok(Part { name, direction, response, velocity, stretch, moves, rule, limit: None, under })
    }
}

/// The row of y − gap of a stop.
fn depth<F: Float>(name: &str, stretch: Option<&Vec<F>>, gap: F) -> Result<Vec<F>, Error> {
    let Some(mut depth) = stretch.cloned() else {
        return Err(Error::Unsupported {
            name: format!("{name}: moves.constant"),
            condition: "must be 0, as the factors of records: the other side of a stop moves by waves",
        });
    };
    if let Some(last) = depth.last_mut() {
        *last = -finite(&format!("{name}: gap"), gap)?;
    }
    Ok(depth)
}

/// A number from 0 to 1.
fn share<F: Float>(name: &str, value: F) -> Result<F, Error> {
    if at_least(name, value, F::int(0))? <= F::int(1) {
        return Ok(value);
    }
    let name = format!("{name} = {}", written(value));
    Err(Error::Unsupported { name, condition: "must be ≤ 1" })
}

/// The coordinates without mass that are not moved.
pub(crate) fn massless<F: Float>(model: &Model<F>) -> Vec<usize> {
    let is_moved = |i: usize| model.moved.iter().any(|moved| moved.coordinate == i);
    let rows = model.mass.iter().enumerate();
    let light = rows.filter(|(i, row)| !is_moved(*i) && row.iter().all(|x| *x == F::int(0)));
    light.map(|(i, _)| i).collect()
}

/// M⁻¹, without the coordinates that are moved, which no force accelerates, and those without mass, which have no acceleration of their own.
fn inverse<F: Float>(mass: &Matrix<F>, moved: &[Moved<F>], massless: &[usize]) -> Result<Matrix<F>, Error> {
    let n = mass.columns();
    let mut definite = mass.clone();
    let places = || moved.iter().map(|moved| moved.coordinate).filter(|&i| i < n);
    for i in places() {
        if mass.row(i).iter().enumerate().any(|(j, &x)| j != i && x != F::int(0)) {
            return Err(Error::Unsupported {
                name: place("mass", i),
                condition: "must have no entry beside the diagonal, because the coordinate is moved",
            });
        }
        at_least(&place("mass", i), mass.at(i, i), F::int(0))?;
        definite.set(i, i, F::int(1));
    }
    for &i in massless {
        definite.set(i, i, F::int(1));
    }
    let mut inverse = definite
        .inverse_of_definite()
        .map_err(|(row, value)| Error::NotDefinite { row: row + 1, value: written(value) })?;
    places().chain(massless.iter().copied()).for_each(|i| inverse.set(i, i, F::int(0)));
    Ok(inverse)
}

/// A row with 1 at a place.
pub(crate) fn unit<F: Float>(size: usize, place: usize) -> Vec<F> {
    let mut row = vec![F::int(0); size];
    if let Some(one) = row.get_mut(place) {
        *one = F::int(1);
    }
    row
}
