//! Systems in code: bodies by name, and what is between them.

use super::matrix::set;
use super::{
    Beyond, Element, Error, Harmonic, Kind, Law, Model, Moved, MovedBy, Record, Signal, State, System,
};
use crate::float::Float;
use alloc::borrow::ToOwned;
use alloc::format;
use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;

/// The name of what does not move.
const GROUND: &str = "ground";

/// A system that is built by the names of its bodies, in one consistent system of units.
///
/// Each step returns the builder. A mistake in a step, such as an unknown body, is the error of [`Builder::model`] and [`Builder::build`].
/// A body is named before what is attached to it; `"ground"` does not move. Every number is checked by [`System::new`].
///
/// ```
/// use stickslip::system::{Element, System};
/// // A block of 1 t on a bearing with 0.45 kN of friction, and a roof of 0.5 t on it, in kN, m and t.
/// let built = System::builder()
///     .mass("block", 1.0)
///     .mass("roof", 0.5)
///     .spring("ground", "block", 200.0)
///     .damper("ground", "block", 0.3)
///     .spring("block", "roof", 300.0)
///     .contact("ground", "block", 0.45)
///     .between("block", "roof", Element::stop([], 0.02, 1000.0).named("buffer"))
///     .wave("roof", 1.5, 6.0 * core::f64::consts::PI);
/// let (system, roof) = (built.build()?, built.place("roof").unwrap());
/// let steady = system.steady(&built.start())?;
/// let most: f64 = steady.motion.max_displacement[roof];
/// assert!((most - 3.432_331e-3).abs() < 1e-8);
/// # Ok::<(), stickslip::system::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Builder<F> {
    model: Model<F>,
    displacement: Vec<F>,
    velocity: Vec<F>,
    /// The first mistake.
    wrong: Option<Error>,
}

impl<F: Float + Default> Default for Builder<F> {
    fn default() -> Self {
        let model = Model::default();
        Self { model, displacement: Vec::new(), velocity: Vec::new(), wrong: None }
    }
}

impl<F: Float + Default> System<F> {
    /// A system that is built by the names of its bodies.
    #[must_use]
    pub fn builder() -> Builder<F> {
        Builder::default()
    }
}

/// The stretch of what is between two bodies, `q₂ − q₁`, by its places and signs.
type Ends = [Option<usize>; 2];

impl<F: Float> Builder<F> {
    /// A further body, at rest in the origin.
    #[must_use]
    pub fn mass(mut self, name: &str, mass: F) -> Self {
        if name == GROUND || self.place(name).is_some() {
            return self.unsupported(name, "must have a name of its own");
        }
        let n = self.model.coordinates.len();
        self.model.coordinates.push(name.to_owned());
        self.displacement.push(F::int(0));
        self.velocity.push(F::int(0));
        let Model { mass: m, damping, stiffness, constant, harmonics, records, elements, .. } =
            &mut self.model;
        for (matrix, value) in [(m, mass), (damping, F::int(0)), (stiffness, F::int(0))] {
            matrix.iter_mut().for_each(|row| row.push(F::int(0)));
            let mut row = vec![F::int(0); n];
            row.push(value);
            matrix.push(row);
        }
        let vectors = harmonics.iter_mut().flat_map(|h| [&mut h.sin, &mut h.cos]);
        let vectors = vectors.chain(records.iter_mut().map(|record| &mut record.force));
        let vectors = vectors.chain(elements.iter_mut().map(|element| &mut element.direction));
        vectors.chain([constant]).for_each(|vector| vector.push(F::int(0)));
        self
    }

    /// The displacement and the velocity of a body at the start.
    #[must_use]
    pub fn starts(mut self, name: &str, displacement: F, velocity: F) -> Self {
        match self.place(name) {
            Some(i) => {
                set(&mut self.displacement, i, displacement);
                set(&mut self.velocity, i, velocity);
                self
            }
            None => self.no_body(name),
        }
    }

    /// A spring between two bodies, or between a body and the ground.
    #[must_use]
    pub fn spring(self, first: &str, second: &str, stiffness: F) -> Self {
        self.linked(|model| &mut model.stiffness, [first, second], stiffness)
    }

    /// A viscous damper between two bodies, or between a body and the ground.
    #[must_use]
    pub fn damper(self, first: &str, second: &str, constant: F) -> Self {
        self.linked(|model| &mut model.damping, [first, second], constant)
    }

    /// Dry friction between two bodies, or between a body and the ground, with the name `first-second`. [`Builder::between`] takes contacts with
    /// more.
    #[must_use]
    pub fn contact(self, first: &str, second: &str, friction: F) -> Self {
        let name = format!("{first}-{second}");
        self.between(first, second, Element::contact([], friction).named(&name))
    }

    /// An element of the second body in relation to the first; its direction is set.
    #[must_use]
    pub fn between(mut self, first: &str, second: &str, mut element: Element<F>) -> Self {
        match self.ends(first, second) {
            Ok(ends) => {
                element.direction = self.direction(ends);
                self.model.elements.push(element);
                self
            }
            Err(wrong) => self.with(wrong),
        }
    }

    /// A constant force on a body.
    #[must_use]
    pub fn force(mut self, on: &str, force: F) -> Self {
        match self.place(on) {
            Some(i) => {
                add(&mut self.model.constant, i, force);
                self
            }
            None => self.no_body(on),
        }
    }

    /// The force `amplitude · sin ωt` on a body.
    #[must_use]
    pub fn wave(self, on: &str, amplitude: F, frequency: F) -> Self {
        self.harmonic(on, frequency, amplitude, F::int(0))
    }

    /// The force `sin · sin ωt + cos · cos ωt` on a body.
    #[must_use]
    pub fn harmonic(mut self, on: &str, frequency: F, sin: F, cos: F) -> Self {
        let Some(i) = self.place(on) else { return self.no_body(on) };
        let n = self.model.coordinates.len();
        let harmonics = &mut self.model.harmonics;
        let known = harmonics.iter().position(|own| own.frequency == frequency);
        let at = known.unwrap_or(harmonics.len());
        if known.is_none() {
            let zeros = || vec![F::int(0); n];
            harmonics.push(Harmonic { frequency, sin: zeros(), cos: zeros() });
        }
        if let Some(own) = harmonics.get_mut(at) {
            add(&mut own.sin, i, sin);
            add(&mut own.cos, i, cos);
        }
        self
    }

    /// A force on a body by samples, straight between them, and zero before and after them.
    #[must_use]
    pub fn record(mut self, on: &str, times: Vec<F>, values: Vec<F>) -> Self {
        let Some(i) = self.place(on) else { return self.no_body(on) };
        let mut force = vec![F::int(0); self.model.coordinates.len()];
        set(&mut force, i, F::int(1));
        self.model.records.push(Record { times, values, force, beyond: Beyond::Zero });
        self
    }

    /// A constant velocity of a body, whatever force that takes, from its displacement at the start.
    #[must_use]
    pub fn travels(mut self, name: &str, velocity: F) -> Self {
        let Some(coordinate) = self.place(name) else { return self.no_body(name) };
        self.model.moved.push(Moved {
            coordinate,
            by: MovedBy::Velocity,
            signal: Signal::constant(velocity),
        });
        self
    }

    /// The place of a body among the coordinates.
    #[must_use]
    pub fn place(&self, name: &str) -> Option<usize> {
        self.model.coordinates.iter().position(|own| own == name)
    }

    /// The names of the coordinates.
    #[must_use]
    pub fn coordinates(&self) -> &[String] {
        &self.model.coordinates
    }

    /// The state at the start.
    #[must_use]
    pub fn start(&self) -> State<F> {
        let (displacement, velocity) = (self.displacement.clone(), self.velocity.clone());
        State { displacement, velocity, ..State::rest(0) }
    }

    /// The model, to which anything may be added.
    ///
    /// # Errors
    /// The first mistake of a step.
    pub fn model(&self) -> Result<Model<F>, Error> {
        self.wrong.clone().map_or_else(|| Ok(self.model.clone()), Err)
    }

    /// The system.
    ///
    /// # Errors
    /// The first mistake of a step, or what [`System::new`] refuses.
    pub fn build(&self) -> Result<System<F>, Error> {
        System::new(&self.model()?)
    }

    /// This builder with what acts along the stretch of two bodies in a matrix.
    fn linked(
        mut self,
        matrix: fn(&mut Model<F>) -> &mut Vec<Vec<F>>,
        [first, second]: [&str; 2],
        value: F,
    ) -> Self {
        match self.ends(first, second) {
            Ok(ends) => {
                link(matrix(&mut self.model), ends, &value);
                self
            }
            Err(wrong) => self.with(wrong),
        }
    }

    fn ends(&self, first: &str, second: &str) -> Result<Ends, Error> {
        let end = |name: &str| match self.place(name) {
            None if name != GROUND => Err(no_body(name)),
            found => Ok(found),
        };
        let ends = [end(first)?, end(second)?];
        if first == second {
            return Err(Error::Unsupported {
                name: second.to_owned(),
                condition: "must differ from the first body",
            });
        }
        Ok(ends)
    }

    fn direction(&self, [first, second]: Ends) -> Vec<F> {
        let mut direction = vec![F::int(0); self.model.coordinates.len()];
        for (end, sign) in [(first, -1), (second, 1)] {
            if let Some(i) = end {
                set(&mut direction, i, F::int(sign));
            }
        }
        direction
    }

    /// This builder with a mistake, unless it has one already.
    fn with(mut self, wrong: Error) -> Self {
        self.wrong.get_or_insert(wrong);
        self
    }

    fn no_body(self, name: &str) -> Self {
        self.with(no_body(name))
    }

    fn unsupported(self, name: &str, condition: &'static str) -> Self {
        self.with(Error::Unsupported { name: name.to_owned(), condition })
    }
}

fn no_body(name: &str) -> Error {
    Error::Unsupported { name: name.to_owned(), condition: "must be a body that is named before, or ground" }
}

fn add<F: Float>(vector: &mut [F], i: usize, value: F) {
    if let Some(place) = vector.get_mut(i) {
        *place = *place + value;
    }
}

/// Adds what acts along the stretch of two bodies to a matrix.
fn link<F: Float>(matrix: &mut [Vec<F>], [first, second]: Ends, value: &F) {
    let mut at = |i: Option<usize>, j: Option<usize>, value: F| {
        if let (Some(row), Some(j)) = (i.and_then(|i| matrix.get_mut(i)), j) {
            add(row, j, value);
        }
    };
    at(first, first, *value);
    at(second, second, *value);
    at(first, second, -*value);
    at(second, first, -*value);
}

impl<F: Float> Element<F> {
    /// Dry friction with one force along a direction, whose other side is at rest.
    ///
    /// ```
    /// use stickslip::system::{Element, Model, System};
    /// let model = Model {
    ///     mass: vec![vec![1.0]],
    ///     damping: vec![vec![0.0]],
    ///     stiffness: vec![vec![1.0]],
    ///     elements: vec![Element::contact([1.0], 0.5).with_peak(1.2).on_belt(0.1)],
    ///     ..Model::default()
    /// };
    /// assert_eq!(System::new(&model)?.coordinates(), 1);
    /// # Ok::<(), stickslip::system::Error>(())
    /// ```
    #[must_use]
    pub fn contact(direction: impl Into<Vec<F>>, friction: F) -> Self {
        let kind = Kind::Contact { law: Law::constant(friction), peak: F::int(1), normal: None };
        Self::new("contact", direction, kind)
    }

    /// Dry friction that depends on the speed.
    #[must_use]
    pub fn with_law(mut self, points: impl Into<Vec<(F, F)>>) -> Self {
        if let Kind::Contact { law, .. } = &mut self.kind {
            law.points = points.into();
        }
        self
    }

    /// A spring with a slider.
    #[must_use]
    pub fn elastic(direction: impl Into<Vec<F>>, stiffness: F, friction: F) -> Self {
        Self::new("elastic", direction, Kind::Elastic { stiffness, friction, normal: None })
    }

    /// An elastic stop without damping behind a gap.
    #[must_use]
    pub fn stop(direction: impl Into<Vec<F>>, gap: F, stiffness: F) -> Self {
        Self::new("stop", direction, Kind::Stop { gap, stiffness, damping: F::int(0) })
    }

    /// A stop that gives no way behind a gap, with a coefficient of restitution from 0 to 1.
    #[must_use]
    pub fn hard_stop(direction: impl Into<Vec<F>>, gap: F, restitution: F) -> Self {
        Self::new("stop", direction, Kind::HardStop { gap, restitution })
    }

    fn new(name: &str, direction: impl Into<Vec<F>>, kind: Kind<F>) -> Self {
        let moves = Signal::constant(F::int(0));
        Self { name: name.to_owned(), direction: direction.into(), moves, kind }
    }

    /// This element with another name.
    #[must_use]
    pub fn named(self, name: &str) -> Self {
        Self { name: name.to_owned(), ..self }
    }

    /// This contact with a static friction over the kinetic one; other elements have none.
    #[must_use]
    pub fn with_peak(mut self, ratio: F) -> Self {
        if let Kind::Contact { peak, .. } = &mut self.kind {
            *peak = ratio;
        }
        self
    }

    /// This element, whose other side moves with a constant velocity, as a belt does.
    #[must_use]
    pub fn on_belt(self, velocity: F) -> Self {
        Self { moves: Signal::constant(velocity), ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_built_model_is_the_one_of_its_matrices() {
        let built = System::builder()
            .mass("a", 2.0)
            .wave("a", 5.0, 3.0)
            .mass("b", 1.0)
            .spring("ground", "a", 7.0)
            .spring("a", "b", 4.0)
            .damper("b", "ground", 0.5)
            .contact("a", "b", 0.25)
            .harmonic("b", 3.0, 0.0, 1.5)
            .force("b", -1.0)
            .record("a", vec![0.0, 1.0], vec![2.0, 0.0])
            .starts("b", 0.1, -0.2);
        let model = built.model().unwrap();
        let contact = Element::contact([-1.0, 1.0], 0.25).named("a-b");
        let due = Model {
            coordinates: vec!["a".to_owned(), "b".to_owned()],
            mass: vec![vec![2.0, 0.0], vec![0.0, 1.0]],
            damping: vec![vec![0.0, 0.0], vec![0.0, 0.5]],
            stiffness: vec![vec![11.0, -4.0], vec![-4.0, 4.0]],
            elements: vec![contact],
            constant: vec![0.0, -1.0],
            harmonics: vec![Harmonic { frequency: 3.0, sin: vec![5.0, 0.0], cos: vec![0.0, 1.5] }],
            records: vec![Record {
                times: vec![0.0, 1.0],
                values: vec![2.0, 0.0],
                force: vec![1.0, 0.0],
                beyond: Beyond::Zero,
            }],
            ..Model::default()
        };
        assert_eq!(model, due);
        assert_eq!(
            built.start(),
            State { displacement: vec![0.0, 0.1], velocity: vec![0.0, -0.2], ..State::rest(0) }
        );
        assert_eq!(built.coordinates(), ["a", "b"]);
        assert_eq!(built.build().unwrap().coordinates(), 2);
    }

    #[test]
    fn the_first_mistake_is_named() {
        let one = || System::builder().mass("a", 1.0).spring("ground", "a", 1.0);
        for (wrong, due) in [
            (
                one().spring("a", "b", 1.0).contact("c", "a", 1.0),
                "b must be a body that is named before, or ground",
            ),
            (one().mass("a", 2.0), "a must have a name of its own"),
            (one().mass("ground", 2.0), "ground must have a name of its own"),
            (one().damper("a", "a", 1.0), "a must differ from the first body"),
            (one().wave("ground", 1.0, 1.0), "ground must be a body that is named before, or ground"),
            (one().mass("m", -1.0), "mass must be positive definite: pivot 2 is -1"),
        ] {
            assert_eq!(wrong.build().unwrap_err().to_string(), due);
        }
    }
}
