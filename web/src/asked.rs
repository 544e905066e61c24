//! The inputs of a question: a machine in units, or its ratios, and the start of its motion.

use serde_json::Value;
use stickslip::motion::State;
use stickslip_front::inputs::units::{Kind, Reader, System};
use stickslip_front::inputs::{Given, Input, Naming, Point, Role};

/// A question as the page asks it.
pub struct Asked<'a>(pub(crate) &'a Value);

/// The size of B, or 1 for ratios.
pub(crate) fn length(point: &Point<f64>) -> f64 {
    point.machine.map_or(1.0, |machine| machine.scales.length)
}

/// A machine with the start of its motion.
pub(crate) struct Problem {
    /// The inputs as they were typed.
    pub(crate) typed: Given<f64>,
    /// The inputs, with a friction and a drive of 0 as ones far below the rounding of every motion.
    pub(crate) given: Given<f64>,
    pub(crate) point: Point<f64>,
    /// At rest at the origin, unless x₀ or v₀ is given.
    pub(crate) start: State<f64>,
    /// Whether x₀ or v₀ is given.
    pub(crate) has_start: bool,
    /// Whether the friction is given as 0.
    pub(crate) is_frictionless: bool,
    /// Whether the drive is given as 0: the vibration is free.
    pub(crate) is_free: bool,
    /// Whether the stiffness is given as 0: there is no Ω, ζ and B.
    pub(crate) is_without_spring: bool,
}

impl Asked<'_> {
    /// The reader of typed values in the units of the question.
    pub(crate) fn reader(&self) -> Result<Reader, String> {
        let named = self.0.get("units").and_then(Value::as_str).filter(|text| !text.is_empty());
        let system =
            named.map(|text| text.parse::<System>().map_err(|e| format!("units {text}: {e}"))).transpose()?;
        Ok(Reader::new(system.as_ref(), "units, such as kN,m"))
    }

    /// The typed inputs that are not blank, without the start.
    fn typed(&self) -> impl Iterator<Item = (&str, &str)> {
        let all = self.0.get("inputs").and_then(Value::as_object).into_iter().flatten();
        all.map(|(name, text)| (name.as_str(), text.as_str().unwrap_or_default().trim()))
            .filter(|(_, text)| !text.is_empty())
    }

    /// The typed inputs of the machine.
    pub(crate) fn given(&self, reader: &Reader) -> Result<Given<f64>, String> {
        let mut given = Given::empty(reader, Naming::Field);
        for (name, text) in self.typed() {
            let input = Input::named(name).ok_or_else(|| format!("{name}: is unknown"))?;
            if !matches!(input, Input::X0 | Input::V0) {
                given.read(input, text, reader)?;
            }
        }
        Ok(given)
    }

    /// The machine and its start.
    pub(crate) fn problem(&self) -> Result<Problem, String> {
        let reader = self.reader()?;
        let typed = self.given(&reader)?;
        // Friction and drive may be 0 here, as the library's own conditions do not say.
        for (name, text) in self.typed() {
            let Some(input) = Input::named(name) else { continue };
            if matches!(input.role(), Role::Drive | Role::Friction)
                && input != Input::Alpha
                && typed.get(input).is_some_and(|x| x < 0.0)
            {
                return Err(format!("{} {text}: must be ≥ 0", name.replace('_', " ")));
            }
        }
        let (is_frictionless, is_free) = (typed.is_without_friction(), typed.is_without_drive());
        let is_without_spring = typed.is_without_spring();
        let given = typed.without_zeros()?.into_owned();
        let point = given.point()?;
        let (mut start, has_start) = self.start(&reader, point.machine.is_some())?;
        if let Some(machine) = &point.machine {
            start = [start[0] / machine.scales.length, start[1] / machine.scales.velocity];
        }
        let start = State::new(0.0, start[0], start[1]).map_err(|e| {
            let is_velocity = e.quantity() == Some(stickslip::Quantity::Velocity);
            format!("{}: {e}", if is_velocity { "v0" } else { "x0" })
        })?;
        Ok(Problem { typed, given, point, start, has_start, is_frictionless, is_free, is_without_spring })
    }

    /// The displacement and the velocity of the start, in units or as ratios, and whether one of them is given.
    pub(crate) fn start(&self, reader: &Reader, is_in_units: bool) -> Result<([f64; 2], bool), String> {
        let mut start = [0.0; 2];
        let mut is_given = false;
        for (place, input) in start.iter_mut().zip([Input::X0, Input::V0]) {
            let name = input.column();
            let Some((_, text)) = self.typed().find(|(own, _)| *own == name) else { continue };
            *place = reader.value(&name, text, if is_in_units { input.kind() } else { Kind::Ratio })?;
            is_given = true;
        }
        Ok((start, is_given))
    }

    /// A number of the question.
    pub(crate) fn number(&self, name: &str, otherwise: f64) -> f64 {
        self.0.get(name).and_then(Value::as_f64).unwrap_or(otherwise)
    }

    /// A count of the question, of at most `most`.
    pub(crate) fn count(&self, name: &str, otherwise: u64, most: u64) -> u64 {
        self.0.get(name).and_then(Value::as_u64).unwrap_or(otherwise).min(most)
    }

    /// The numbers of a list of the question.
    pub(crate) fn numbers(&self, name: &str) -> Vec<f64> {
        let list = self.0.get(name).and_then(Value::as_array);
        list.into_iter().flatten().filter_map(Value::as_f64).collect()
    }

    /// A text of the question.
    pub(crate) fn text(&self, name: &str) -> Option<&str> {
        self.0.get(name).and_then(Value::as_str).filter(|text| !text.trim().is_empty())
    }
}
