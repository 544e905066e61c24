//! The given inputs, and the rules by which they determine a machine.

mod body;
mod nothing;

pub use nothing::in_place_of_zeros;

use super::input::{Input, Naming, Role};
use super::units::{InputError, Reader, System, scaled};
use std::str::FromStr;
use stickslip::internal::{non_negative, positive, springless_exponent};
use stickslip::{Drive, Error, Excitation, Float, Number, Oscillator, Quantity, Ratios, Scales};

/// The given inputs in one system of units, with the text of those that were typed.
#[derive(Debug, Clone)]
pub struct Given<F> {
    /// The system of units of the values.
    pub system: System,
    naming: Naming,
    values: Vec<(Input, F, Option<String>)>,
}

/// A body under its drive.
#[derive(Debug, Clone, Copy)]
pub struct Driven<F> {
    /// The body.
    pub oscillator: Oscillator<F>,
    /// Its drive.
    pub drive: Drive<F>,
    /// The scales of the answers.
    pub scales: Scales<F>,
    /// The ratios of the answers. A ratio that is given is used as it is, without the rounding of a conversion by k
    /// and p₀.
    pub ratios: Ratios<F>,
}

/// The ratios of a problem and, in physical units, its machine.
#[derive(Debug, Clone, Copy)]
pub struct Point<F> {
    /// The ratios.
    pub ratios: Ratios<F>,
    /// The body under its drive, if it was given.
    pub machine: Option<Driven<F>>,
}

impl<F: Float> Point<F> {
    /// The excitation; for ratios alone a force.
    pub fn excitation(&self) -> Excitation {
        self.machine.as_ref().map_or(Excitation::Force, |machine| machine.drive.excitation())
    }
}

impl<F: Float + FromStr> Given<F> {
    /// No inputs, in the system of a reader.
    pub const fn empty(reader: &Reader, naming: Naming) -> Self {
        Self { system: reader.system(), naming, values: Vec::new() }
    }

    /// Reads a typed value and sets it.
    ///
    /// # Errors
    /// As for [`Reader::value`].
    pub fn read(&mut self, input: Input, text: &str, reader: &Reader) -> Result<F, InputError> {
        let value = reader.value(&self.naming.of(input), text, input.kind())?;
        self.set_typed(input, value, text);
        Ok(value)
    }

    /// Sets a typed value.
    pub fn set_typed(&mut self, input: Input, value: F, text: &str) {
        let label = format!("{} {text}", self.naming.of(input));
        self.put(input, value, Some(label));
    }

    /// Sets a value that was not typed, from a row or a grid.
    pub fn set(&mut self, input: Input, value: F) {
        self.put(input, value, None);
    }

    fn put(&mut self, input: Input, value: F, label: Option<String>) {
        match self.values.iter_mut().find(|(own, ..)| *own == input) {
            Some((_, old, text)) => (*old, *text) = (value, label),
            None => self.values.push((input, value, label)),
        }
    }

    /// Removes and returns a value.
    pub fn take(&mut self, input: Input) -> Option<F> {
        let place = self.values.iter().position(|(own, ..)| *own == input)?;
        Some(self.values.swap_remove(place).1)
    }

    /// Whether no input is given.
    pub const fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// The value of an input, if it is given.
    pub fn get(&self, input: Input) -> Option<F> {
        self.values.iter().find(|(own, ..)| *own == input).map(|(_, value, _)| *value)
    }

    /// Whether an input is given.
    pub fn has(&self, input: Input) -> bool {
        self.get(input).is_some()
    }

    /// Whether an input of a role is given.
    pub fn has_role(&self, role: Role) -> bool {
        self.values.iter().any(|(input, ..)| input.role() == role)
    }

    /// Whether the inputs include those of a machine in physical units.
    pub fn is_physical(&self) -> bool {
        self.values.iter().any(|(input, ..)| input.is_physical())
    }

    /// The value of an input.
    ///
    /// # Errors
    /// Where the input is not given.
    pub fn required(&self, input: Input) -> Result<F, InputError> {
        self.get(input).ok_or_else(|| self.missing(&[input]))
    }

    /// The error where at least one of several inputs must be given.
    #[must_use]
    pub fn missing(&self, inputs: &[Input]) -> InputError {
        InputError(format!("{} is missing", self.naming.of_several(inputs)))
    }

    /// The given input of a role, if any.
    ///
    /// # Errors
    /// Where several are given.
    pub fn one_of(&self, role: Role) -> Result<Option<(Input, F)>, InputError> {
        // The stiffness and the natural period or frequency give the mass.
        if role == Role::Spring
            && !self.has_role(Role::Mass)
            && let Some((stiffness, Some(_))) = self.of_spring()
            && !(self.has(Input::PendulumRadius)
                || self.has(Input::Period) && self.has(Input::NaturalFrequency))
        {
            return Ok(Some((Input::Stiffness, stiffness)));
        }
        let mut found = self.values.iter().filter(|(input, ..)| input.role() == role);
        let (first, second) = (found.next(), found.next());
        if second.is_none() {
            return Ok(first.map(|(input, value, _)| (*input, *value)));
        }
        let names = Input::of_role(role).into_iter().filter(|input| self.has(*input)).take(2);
        let names: Vec<_> = names.map(|input| self.naming.of(input)).collect();
        Err(InputError(format!(
            "{}: give one of the two, because it determines the other",
            names.join(" and ")
        )))
    }

    /// An input as typed.
    #[must_use]
    pub fn label(&self, input: Input) -> String {
        let found = self.values.iter().find(|(own, ..)| *own == input);
        found.and_then(|(.., text)| text.clone()).unwrap_or_else(|| self.naming.of(input))
    }

    /// All typed inputs: the cause of an answer that overflows in these units.
    #[must_use]
    pub fn all_typed(&self) -> String {
        self.typed(|_| true)
    }

    fn typed(&self, chosen: impl Fn(Input) -> bool) -> String {
        let some = self.values.iter().filter(|(input, ..)| chosen(*input));
        some.filter_map(|(_, _, text)| text.as_deref()).collect::<Vec<_>>().join(" ")
    }

    /// The library's error, preceded by the input or inputs that caused it.
    pub fn at_fault(&self, error: &Error) -> InputError {
        let quantity = error.quantity();
        let said = match self.values.iter().find(|(input, ..)| *input == Input::Frequency) {
            Some((.., Some(text))) => in_typed_unit(error, text),
            Some((.., None)) | None => error.to_string(),
        };
        // If no input alone is the cause, all of them are.
        let blamed = self.typed(|input| quantity.is_some_and(|quantity| input.determines(quantity)));
        match if blamed.is_empty() { self.all_typed() } else { blamed } {
            // The caller names the values of a file or a grid.
            inputs if inputs.is_empty() => InputError(said),
            inputs => InputError(format!("{inputs}: {said}")),
        }
    }

    /// Checks a value that is used only in a product, where its sign would be lost.
    fn positive(&self, input: Input, value: F) -> Result<F, InputError> {
        positive(input.quantity(), value).map_err(|e| InputError(format!("{}: {e}", self.label(input))))
    }

    /// The mass.
    ///
    /// # Errors
    /// Where neither the mass, nor the weight, nor the stiffness with the natural period or frequency is given; where
    /// several are.
    pub fn mass(&self) -> Result<F, InputError> {
        match (self.one_of(Role::Mass)?, self.of_spring()) {
            (Some((Input::Weight, weight)), _) => Ok(self.positive(Input::Weight, weight)? / self.gravity()?),
            (Some((_, mass)), _) => Ok(mass),
            // m = k/ω_n²
            (None, Some((stiffness, Some(natural)))) => Ok(stiffness / natural?.square()),
            (None, _) => {
                let missing = self.missing(&[Input::Mass]);
                Err(self.in_units_beside_ratios().unwrap_or(missing))
            }
        }
    }

    /// Whether no input needs a mass or gives one: the body by its period or as a pendulum, friction by its coefficient or the
    /// yield acceleration, and everything else by ratios or as a motion of the base.
    pub fn needs_no_mass(&self) -> bool {
        self.values.iter().all(|(input, value, _)| match input.role() {
            Role::Mass | Role::MeanForce => false,
            Role::Spring => *input != Input::Stiffness || *value == F::int(0),
            Role::Friction => *input == Input::FrictionCoefficient,
            Role::Damper => *input == Input::DampingRatio,
            Role::StaticFriction => *input == Input::StaticFrictionRatio,
            Role::Body => *input != Input::FrictionBackward,
            Role::Drive => !matches!(input, Input::Force | Input::Unbalance | Input::Eccentricity),
            Role::Frequency | Role::RotatingMass | Role::Start => true,
        })
    }

    /// Sets a unit of mass where it cancels ([`Given::needs_no_mass`]); returns whether it does.
    pub fn cancel_mass(&mut self) -> bool {
        let cancels = self.needs_no_mass();
        if cancels {
            self.set(Input::Mass, F::int(1));
        }
        cancels
    }

    /// The stiffness, and ω_n where the period or the frequency is given beside it.
    fn of_spring(&self) -> Option<(F, Option<Result<F, InputError>>)> {
        let stiffness = self.get(Input::Stiffness)?;
        let natural = if let Some(period) = self.get(Input::Period) {
            Some(self.positive(Input::Period, period).map(|period| F::int(2) * F::pi() / period))
        } else {
            self.get(Input::NaturalFrequency).map(|natural| self.positive(Input::NaturalFrequency, natural))
        };
        Some((stiffness, natural))
    }

    /// The error for a single input in physical units beside ratios.
    fn in_units_beside_ratios(&self) -> Option<InputError> {
        let mut physical = self.values.iter().map(|&(input, ..)| input).filter(|input| input.is_physical());
        let (Some(found), None) = (physical.next(), physical.next()) else { return None };
        let instead = match (found, found.role()) {
            (_, role @ (Role::Damper | Role::StaticFriction)) => {
                let ratio = Input::of_role(role).into_iter().find(|input| !input.is_physical())?;
                format!(". With ratios give {}", self.naming.of(ratio))
            }
            (_, Role::MeanForce) | (Input::FrictionBackward, _) => String::new(),
            _ => return None,
        };
        let (label, mass) = (self.label(found), self.naming.of(Input::Mass));
        Some(InputError(format!(
            "{label}: the {} needs a machine in units, and {mass} is missing{instead}",
            found.symbol()
        )))
    }

    /// The stiffness, given directly or by the natural period; `None` where neither is given.
    ///
    /// # Errors
    /// Where both are given, or the period is not > 0.
    pub fn stiffness(&self) -> Result<Option<F>, InputError> {
        Ok(match self.one_of(Role::Spring)? {
            Some((Input::Period, period)) => {
                let natural = F::int(2) * F::pi() / self.positive(Input::Period, period)?;
                Some(self.mass()? * natural.square())
            }
            Some((Input::NaturalFrequency, natural)) => {
                Some(self.mass()? * self.positive(Input::NaturalFrequency, natural)?.square())
            }
            Some((Input::PendulumRadius, radius)) => {
                Some(self.mass()? * self.gravity()? / self.positive(Input::PendulumRadius, radius)?)
            }
            found => found.map(|(_, stiffness)| stiffness),
        })
    }

    /// The friction force, given directly or as µ m g; `None` where neither is given.
    ///
    /// # Errors
    /// Where both are given, µ < 0, g is not > 0, or g is given without µ.
    pub fn friction(&self) -> Result<Option<F>, InputError> {
        let found = self.one_of(Role::Friction)?;
        if let Some((Input::FrictionCoefficient, coefficient)) = found {
            let weight = self.mass()? * self.gravity()?;
            let coefficient = non_negative(Quantity::FrictionCoefficient, coefficient)
                .map_err(|e| InputError(format!("{}: {e}", self.label(Input::FrictionCoefficient))))?;
            return Ok(Some(coefficient * weight));
        }
        if self.has(Input::Gravity) && !self.has(Input::PendulumRadius) && !self.has(Input::Weight) {
            let [gravity, coefficient, radius, weight] =
                [Input::Gravity, Input::FrictionCoefficient, Input::PendulumRadius, Input::Weight]
                    .map(|input| self.naming.of(input));
            return Err(InputError(format!(
                "{gravity}: must be left out without {coefficient}, {radius} or {weight}"
            )));
        }
        Ok(found.map(|(_, friction)| friction))
    }

    /// Gravity, by default the standard one.
    ///
    /// # Errors
    /// Where gravity is not > 0.
    pub fn gravity(&self) -> Result<F, InputError> {
        self.get(Input::Gravity)
            .map_or_else(|| Ok(self.system.gravity()), |g| self.positive(Input::Gravity, g))
    }

    /// The stiffness of a body that is driven at ω_d. Without a spring it is so small that the spring cannot be seen, at
    /// this frequency or above.
    ///
    /// # Errors
    /// As for [`Given::stiffness`], and where an input needs a spring that is not there.
    pub fn stiffness_at(&self, frequency: Option<F>) -> Result<Option<F>, InputError> {
        match frequency.filter(|_| self.is_without_spring()) {
            Some(frequency) => {
                self.check_without_spring()?;
                let body = Oscillator::without_spring(self.mass()?, F::int(1), frequency);
                Ok(Some(body.map_err(|e| self.at_fault(&e))?.stiffness()))
            }
            None => self.stiffness(),
        }
    }

    /// Whether the stiffness is given as 0.
    pub fn is_without_spring(&self) -> bool {
        self.get(Input::Stiffness) == Some(F::int(0))
    }

    /// Refuses what a body without a spring does not have: a damping ratio, a support of its spring, and a place about which
    /// it moves under a constant force.
    fn check_without_spring(&self) -> Result<(), InputError> {
        for input in [Input::DampingRatio, Input::FootDisplacement] {
            if self.has(input) {
                return Err(InputError(format!("{}: must be left out without a spring", self.label(input))));
            }
        }
        if springless_exponent::<F>() > F::RATIO_EXPONENT {
            let most = F::RATIO_EXPONENT.saturating_sub(2).saturating_mul(2) & !63;
            let label = self.label(Input::Stiffness);
            return Err(InputError(format!("{label}: without a spring answers have at most {most} bits")));
        }
        if self.is_without_friction() && self.has_role(Role::Drive) {
            let input = self.first_of(Role::Friction).unwrap_or(Input::Friction);
            return Err(InputError(format!(
                "{}: must be > 0 without a spring, because the motion is linear then",
                self.label(input)
            )));
        }
        match self.drifts() {
            Some(input) => Err(InputError(format!(
                "{}: must be left out without a spring, because the body drifts. `stickslip steady` answers with the drift",
                self.label(input)
            ))),
            None => Ok(()),
        }
    }

    /// The input by which the body drifts, which is without a spring then: a constant force, or a friction that differs by direction.
    pub fn drifts(&self) -> Option<Input> {
        if !self.is_without_spring() {
            return None;
        }
        let is_other =
            |backward: F| Input::of_role(Role::Friction).into_iter().all(|f| self.get(f) != Some(backward));
        if self.get(Input::MeanForce).is_some_and(|force| force != F::int(0)) {
            return Some(Input::MeanForce);
        }
        self.get(Input::FrictionBackward).is_some_and(is_other).then_some(Input::FrictionBackward)
    }

    /// The friction against forward and against backward motion, if they are given apart.
    ///
    /// # Errors
    /// As for [`Given::friction`].
    pub fn directional_friction(&self) -> Result<Option<(F, F)>, InputError> {
        Ok(self.friction()?.zip(self.get(Input::FrictionBackward)))
    }

    /// The body, whose stiffness may follow from Ω and the frequency of the drive: two of Ω, the frequency and the
    /// spring are given.
    ///
    /// # Errors
    /// Where an input of the body is missing, wrong or superfluous.
    pub fn oscillator(&self) -> Result<Oscillator<F>, InputError> {
        let mass = self.mass()?;
        let friction = self.friction()?.ok_or_else(|| self.missing(&Input::of_role(Role::Friction)))?;
        let spring = self.one_of(Role::Spring)?;
        let body = match (self.get(Input::Omega), self.get(Input::Frequency), spring) {
            (Some(_), Some(_), Some((spring, _))) => {
                let [omega, frequency, spring] =
                    [Input::Omega, Input::Frequency, spring].map(|input| self.naming.of(input));
                return Err(InputError(format!(
                    "{omega}, {frequency} and {spring}: give two of the three, because they determine the third"
                )));
            }
            (Some(omega), Some(frequency), None) => Oscillator::tuned(mass, friction, frequency, omega),
            (Some(_), None, None) => {
                return Err(self.missing(&[&[Input::Frequency], &*Input::of_role(Role::Spring)].concat()));
            }
            (_, frequency, Some(_)) => {
                Oscillator::new(mass, self.stiffness_at(frequency)?.unwrap_or(F::int(0)), friction)
            }
            (None, _, None) => {
                return Err(self.missing(&[&*Input::of_role(Role::Spring), &[Input::Omega]].concat()));
            }
        };
        body.map_err(|e| self.at_fault(&e)).and_then(|body| self.with_damper(body))
    }

    /// The body with its backward friction, its damper and its static friction, as given.
    ///
    /// # Errors
    /// Where one of them is wrong or given twice.
    pub fn with_damper(&self, body: Oscillator<F>) -> Result<Oscillator<F>, InputError> {
        let static_friction = self.one_of(Role::StaticFriction)?;
        let body = match self.get(Input::FrictionBackward) {
            Some(backward) => body.with_directional_friction(body.friction_bound(), backward),
            None => Ok(body),
        }
        .map_err(|e| self.at_fault(&e))?;
        match self.one_of(Role::Damper)? {
            Some((Input::Damping, damping)) => body.with_damping(damping),
            Some((_, ratio)) => body.with_damping_ratio(ratio),
            None => Ok(body),
        }
        .and_then(|body| match static_friction {
            Some((Input::StaticFriction, force)) => body.with_static_friction(force),
            Some((_, ratio)) => body.with_static_friction_ratio(ratio),
            None => Ok(body),
        })
        .map_err(|e| self.at_fault(&e))
    }

    /// The frequency of the drive, given directly or as Ω ω_n of a body with a spring.
    ///
    /// # Errors
    /// Where neither is given, or Ω is not > 0.
    pub fn frequency(&self, body: &Oscillator<F>) -> Result<F, InputError> {
        match (self.get(Input::Frequency), self.get(Input::Omega)) {
            (None, Some(omega)) => Ok(self.positive(Input::Omega, omega)? * body.natural_frequency()),
            _ => self.required(Input::Frequency),
        }
    }

    /// The input that gives the amplitude of the excitation, and its value. Eccentricity and eccentric mass are an
    /// unbalance.
    ///
    /// # Errors
    /// Where none or several are given, or one of eccentricity and eccentric mass without the other.
    pub fn amplitude(&self) -> Result<(Input, F), InputError> {
        let found = self.one_of(Role::Drive)?;
        match (found, self.get(Input::EccentricMass)) {
            (Some((Input::Eccentricity, eccentricity)), Some(mass)) => {
                let mass = self.positive(Input::EccentricMass, mass)?;
                Ok((Input::Unbalance, mass * self.positive(Input::Eccentricity, eccentricity)?))
            }
            (Some((Input::Eccentricity, _)), None) => Err(self.missing(&[Input::EccentricMass])),
            (Some(found), None) => Ok(found),
            (None, None) => Err(self.missing(&Input::of_role(Role::Drive))),
            (_, Some(_)) => Err(InputError(format!(
                "{}: needs {}, and no other drive",
                self.label(Input::EccentricMass),
                self.naming.of(Input::Eccentricity)
            ))),
        }
    }

    /// The drive of a body at a frequency.
    ///
    /// # Errors
    /// As for [`Given::amplitude`], and where the amplitude, the frequency or the mean force is wrong.
    pub fn drive(&self, body: &Oscillator<F>, frequency: F) -> Result<Drive<F>, InputError> {
        let (input, amplitude) = self.amplitude()?;
        match input.excitation() {
            Some(excitation) => Drive::new(excitation, amplitude, frequency),
            None => positive(Quantity::ForceRatio, amplitude)
                .and_then(|alpha| Drive::force(alpha * body.friction_bound(), frequency)),
        }
        .and_then(|drive| self.with_mean_force(drive))
        .map_err(|e| self.at_fault(&e))
    }

    /// The drive with its constant force, if it is given.
    ///
    /// # Errors
    /// Where the force is not finite.
    pub fn with_mean_force(&self, drive: Drive<F>) -> Result<Drive<F>, Error> {
        self.get(Input::MeanForce).map_or(Ok(drive), |force| drive.with_mean_force(force))
    }

    /// The machine, or the ratios alone. A friction or a drive of 0 is one far below the rounding
    /// ([`Given::without_zeros`]).
    ///
    /// # Errors
    /// As for [`Given::driven`].
    pub fn point(&self) -> Result<Point<F>, InputError> {
        let given = self.without_zeros()?;
        if given.is_physical() {
            let machine = given.driven()?;
            return Ok(Point { ratios: machine.ratios, machine: Some(machine) });
        }
        let ratios = Ratios::new(given.required(Input::Omega)?, given.required(Input::Alpha)?);
        let ratios = given.completed(ratios.map_err(|e| given.at_fault(&e))?)?;
        Ok(Point { ratios, machine: None })
    }

    /// Whether a constant force or backward friction was given, which shift the motion.
    pub fn is_shifted(&self) -> bool {
        self.has(Input::MeanForce) || self.has(Input::FrictionBackward)
    }

    /// The machine.
    ///
    /// # Errors
    /// Where an input is missing, wrong or superfluous.
    pub fn driven(&self) -> Result<Driven<F>, InputError> {
        let body = self.oscillator()?;
        self.under(body, self.drive(&body, self.frequency(&body)?)?)
    }

    /// The machine under a force of r_y, at α = 1: its scales are those of the border.
    ///
    /// # Errors
    /// As for [`Given::driven`].
    pub fn on_border(&self) -> Result<Driven<F>, InputError> {
        let body = self.oscillator()?;
        let drive = Drive::force(body.friction_bound(), self.frequency(&body)?);
        self.under(body, drive.map_err(|e| self.at_fault(&e))?)
    }

    fn under(&self, oscillator: Oscillator<F>, drive: Drive<F>) -> Result<Driven<F>, InputError> {
        let or = |input, computed| self.get(input).unwrap_or(computed);
        let ratios = |found: Ratios<F>| {
            Ratios::new(or(Input::Omega, found.omega()), or(Input::Alpha, found.alpha()))?
                .with_damping_ratio(or(Input::DampingRatio, found.damping_ratio()))?
                .with_static_friction_ratio(or(Input::StaticFrictionRatio, found.static_friction_ratio()))
                .map(|ratios| match found.excitation() {
                    Some(excitation) => ratios.with_excitation(excitation),
                    None => ratios,
                })
        };
        let all = || {
            let (found, scales) = (drive.ratios(&oscillator)?, Scales::new(&oscillator, &drive)?);
            Ok(Driven { oscillator, drive, scales, ratios: ratios(found)? })
        };
        all().map_err(|e: Error| self.at_fault(&e))
    }

    /// The ratios with the given damping and static friction.
    ///
    /// # Errors
    /// Where one of them is outside its domain.
    pub fn completed(&self, ratios: Ratios<F>) -> Result<Ratios<F>, InputError> {
        let zeta = self.get(Input::DampingRatio).unwrap_or(F::int(0));
        let eta = self.get(Input::StaticFrictionRatio).unwrap_or(F::int(1));
        let completed = ratios.with_damping_ratio(zeta).and_then(|r| r.with_static_friction_ratio(eta));
        completed.map_err(|e| self.at_fault(&e))
    }
}

/// The error on a frequency, or on Ω, with its bounds in the unit of the typed frequency `NAME TEXT`.
#[must_use]
pub fn in_typed_unit(error: &Error, typed: &str) -> String {
    if let Error::NotPositive { quantity: Quantity::AngularFrequency, .. } = error {
        return "the frequency must be > 0".to_owned();
    }
    let Error::OutOfRange { quantity, value, least, greatest } = error else { return error.to_string() };
    let text = typed.split_once(' ').map_or(typed, |(_, text)| text);
    let bound = |bound: &Number| scaled(text, bound.to_f64() / value.to_f64());
    let is_frequency = matches!(quantity, Quantity::AngularFrequency | Quantity::FrequencyRatio);
    match (bound(least), bound(greatest)) {
        (Some(least), Some(greatest)) if is_frequency && Reader::has_unit(text) => {
            format!("the frequency must be ≥ {least} and ≤ {greatest}")
        }
        _ => error.to_string(),
    }
}
