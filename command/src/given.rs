//! The given quantities of a machine and its drive: from arguments, columns of a file, or grids.

mod parameter;

use crate::args::{ForceArgs, MachineArgs};
use crate::bits::Value;
use crate::failure::Failure;
use crate::progress;
use stickslip::units::{self, Reader, System};
use stickslip::{Error, Number, Quantity};

use Parameter as P;
pub(crate) use parameter::Parameter;

/// The given quantities in one system of units, with the text of those that were typed.
#[derive(Debug, Clone)]
pub(crate) struct Given<F> {
    pub(crate) system: System,
    values: Vec<(Parameter, F, Option<String>)>,
}

impl<F: Value> Given<F> {
    pub(crate) fn of(machine: &MachineArgs, force: &ForceArgs, reader: &Reader) -> Result<Self, Failure> {
        let mut given = Self { system: reader.system(), values: Vec::new() };
        for parameter in Parameter::ALL {
            if let Some(text) = typed(machine, force, parameter) {
                let value = reader.value(parameter.option(), text, parameter.kind())?;
                note_percentage(parameter, text, value);
                given.values.push((parameter, value, Some(format!("{} {text}", parameter.option()))));
            }
        }
        Ok(given)
    }

    /// Whether nothing is given.
    pub(crate) const fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    pub(crate) const fn empty(system: System) -> Self {
        Self { system, values: Vec::new() }
    }

    /// The typed quantities, in order.
    pub(crate) fn typed<'a>(
        machine: &'a MachineArgs,
        force: &'a ForceArgs,
    ) -> impl Iterator<Item = (Parameter, &'a str)> {
        Parameter::ALL.into_iter().filter_map(move |p| Some((p, typed(machine, force, p)?.as_str())))
    }

    /// Sets a typed value.
    pub(crate) fn set_typed(&mut self, parameter: Parameter, value: F, text: &str) {
        self.set(parameter, value);
        if let Some((.., typed)) = self.values.iter_mut().find(|(p, ..)| *p == parameter) {
            *typed = Some(format!("{} {text}", parameter.option()));
        }
    }

    pub(crate) fn get(&self, parameter: Parameter) -> Option<F> {
        self.values.iter().find(|(p, ..)| *p == parameter).map(|(_, value, _)| *value)
    }

    /// Removes and returns a value.
    pub(crate) fn take(&mut self, parameter: Parameter) -> Option<F> {
        let place = self.values.iter().position(|(p, ..)| *p == parameter)?;
        Some(self.values.swap_remove(place).1)
    }

    /// Sets a value that was not typed, from a row or a grid.
    pub(crate) fn set(&mut self, parameter: Parameter, value: F) {
        match self.values.iter_mut().find(|(p, ..)| *p == parameter) {
            Some((_, old, text)) => (*old, *text) = (value, None),
            None => self.values.push((parameter, value, None)),
        }
    }

    pub(crate) fn has(&self, parameter: Parameter) -> bool {
        self.get(parameter).is_some()
    }

    /// The value, or an error if it is missing.
    pub(crate) fn required(&self, parameter: Parameter) -> Result<F, Failure> {
        self.get(parameter).ok_or_else(|| Failure::Input(format!("{} is missing", parameter.option())))
    }

    /// Whether the quantities include those of a machine in physical units.
    pub(crate) fn is_physical(&self) -> bool {
        self.values.iter().any(|(p, ..)| p.is_physical())
    }

    /// The error for a single quantity in physical units where all else are ratios.
    pub(crate) fn in_units_beside_ratios(&self) -> Option<Failure> {
        let mut physical = self.values.iter().map(|&(p, ..)| p).filter(|p| p.is_physical());
        let (found, others) = (physical.next()?, physical.next());
        let instead = match (found, others) {
            (P::Damping, None) => ". With ratios give --damping-ratio",
            (P::StaticFriction, None) => ". With ratios give --static-friction-ratio",
            (P::MeanForce | P::FrictionBackward, None) => "",
            _ => return None,
        };
        Some(Failure::Input(format!(
            "{}: the {} needs a machine in units, and --mass is missing{instead}",
            self.label(found),
            found.symbol(),
        )))
    }

    /// The given one of several equivalent quantities, if any.
    pub(crate) fn one_of(&self, several: &[Parameter]) -> Result<Option<(Parameter, F)>, Failure> {
        let mut found = several.iter().filter_map(|&p| Some((p, self.get(p)?)));
        match (found.next(), found.next()) {
            (Some((first, _)), Some((second, _))) => Err(Failure::Input(format!(
                "{} and {}: give one of the two, because it determines the other",
                first.option(),
                second.option()
            ))),
            (first, _) => Ok(first),
        }
    }

    /// Checks a value that the library uses only in a product, where its sign would be lost.
    pub(crate) fn positive(&self, parameter: Parameter, value: F) -> Result<F, Failure> {
        let broken = if value.is_finite() { "> 0" } else { "finite" };
        if value > F::int(0) && value.is_finite() {
            return Ok(value);
        }
        let (name, symbol) = (self.label(parameter), parameter.symbol());
        Err(Failure::Input(format!("{name}: {symbol} = {value} must be {broken}")))
    }

    /// The argument as typed.
    pub(crate) fn label(&self, parameter: Parameter) -> String {
        let found = self.values.iter().find(|(p, ..)| *p == parameter);
        found.and_then(|(.., text)| text.clone()).unwrap_or_else(|| parameter.option().to_owned())
    }

    /// All typed arguments: the cause of an answer that overflows in these units.
    pub(crate) fn all_typed(&self) -> String {
        self.values.iter().filter_map(|(.., text)| text.as_deref()).collect::<Vec<_>>().join(" ")
    }

    /// The failure, preceded by all typed arguments, if there are any.
    pub(crate) fn behind_all(&self, failure: Failure) -> Failure {
        match self.all_typed() {
            arguments if arguments.is_empty() => failure,
            arguments => failure.about(&arguments),
        }
    }

    /// The library's error, preceded by the argument or arguments that caused it.
    pub(crate) fn at_fault(&self, error: Error) -> Failure {
        let quantity = error.quantity();
        let blamed = |p: &Parameter| quantity.is_some_and(|q| p.quantities().contains(&q));
        let typed = |is_its_own: bool| {
            let some = self.values.iter().filter(move |(p, ..)| !is_its_own || blamed(p));
            some.filter_map(|(_, _, text)| text.as_deref()).collect::<Vec<_>>().join(" ")
        };
        let said = match self.values.iter().find(|(p, ..)| *p == P::Frequency) {
            Some((.., Some(text))) => in_typed_unit(&error, text),
            Some((.., None)) | None => error.to_string(),
        };
        // If no argument alone is the cause, all of them are.
        match if typed(true).is_empty() { typed(false) } else { typed(true) } {
            // The caller names the values of a file or a grid.
            arguments if arguments.is_empty() => Failure::Input(said),
            arguments => Failure::Input(format!("{arguments}: {said}")),
        }
    }
}

/// The error on a frequency, or on Ω, with its bounds in the unit of the typed frequency `--option TEXT`.
pub(crate) fn in_typed_unit(error: &Error, typed: &str) -> String {
    if let Error::NotPositive { quantity: Quantity::AngularFrequency, .. } = error {
        return "the frequency must be > 0".to_owned();
    }
    let Error::OutOfRange { quantity, value, least, greatest } = error else { return error.to_string() };
    let text = typed.split_once(' ').map_or(typed, |(_, text)| text);
    let bound = |bound: &Number| units::scaled(text, bound.to_f64() / value.to_f64());
    let is_frequency = matches!(quantity, Quantity::AngularFrequency | Quantity::FrequencyRatio);
    match (bound(least), bound(greatest)) {
        (Some(least), Some(greatest)) if is_frequency && Reader::has_unit(text) => {
            format!("the frequency must be ≥ {least} and ≤ {greatest}")
        }
        _ => error.to_string(),
    }
}

/// A note where a damping ratio without % is so large that a percentage was probably meant.
pub(crate) fn note_percentage<F: Value>(parameter: Parameter, text: &str, value: F) {
    if parameter == P::DampingRatio && value >= F::int(1) && !text.contains('%') {
        let (option, percent) = (parameter.option(), crate::bits::digits(F::int(100) * value));
        progress::note(&format!(
            "{option} {text} is {percent} % of critical damping. A damping ratio of {text} percent is {option} {text}%"
        ));
    }
}

fn typed<'a>(machine: &'a MachineArgs, force: &'a ForceArgs, parameter: Parameter) -> Option<&'a String> {
    match parameter {
        P::Omega => &machine.omega,
        P::Mass => &machine.mass,
        P::Stiffness => &machine.stiffness,
        P::Period => &machine.period,
        P::Friction => &machine.friction,
        P::FrictionCoefficient => &machine.friction_coefficient,
        P::Gravity => &machine.gravity,
        P::FrictionBackward => &machine.friction_backward,
        P::DampingRatio => &machine.damping_ratio,
        P::Damping => &machine.damping,
        P::StaticFrictionRatio => &machine.static_friction_ratio,
        P::StaticFriction => &machine.static_friction,
        P::MeanForce => &machine.mean_force,
        P::Frequency => &machine.frequency,
        P::Alpha => &force.alpha,
        P::Force => &force.force,
        P::BaseAcceleration => &force.base_acceleration,
        P::BaseVelocity => &force.base_velocity,
        P::BaseDisplacement => &force.base_displacement,
        P::FootDisplacement => &force.foot_displacement,
        P::DampedFootDisplacement => &force.damped_foot_displacement,
        // The start is no quantity of the machine: `input::start` reads it.
        P::X0 | P::V0 => &None,
    }
    .as_ref()
}
