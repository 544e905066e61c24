//! The typed inputs, read by the rules of the library: the ratios and, if given, the machine.

use crate::args::{StartArgs, Swept};
use crate::bits::Value;
use crate::failure::Failure;
use crate::progress;
use std::borrow::Cow;
use stickslip::motion::State;
use stickslip::{Drive, Error, Oscillator, Quantity, Ratios};
use stickslip_front::inputs::units::{self, Kind, Reader, System, split};
use stickslip_front::inputs::{Driven, Given, Input, Naming, Point, Role};

/// The typed inputs, in the system of the reader.
pub(crate) fn read<F: Value>(typed: &[(Input, String)], reader: &Reader) -> Result<Given<F>, Failure> {
    let mut given = Given::empty(reader, Naming::Option);
    for (input, text) in typed {
        let value = given.read(*input, text, reader)?;
        note_unusual(*input, text, value, &reader.system());
    }
    note_bare_mass(typed, reader);
    Ok(given)
}

/// A note where a mass without a unit, beside values that have one, is in a unit of mass that follows from those of force
/// and length, such as 1 t for N and mm.
pub(crate) fn note_bare_mass(typed: &[(Input, String)], reader: &Reader) {
    let system = reader.system();
    let mass = typed.iter().find(|(input, text)| *input == Input::Mass && !Reader::has_unit(text));
    let Some((input, text)) = mass.filter(|_| reader.has_converted() && system.mass() != Some("kg")) else {
        return;
    };
    let Ok(number) = text.trim().parse::<f64>() else { return };
    let (option, own, (unit, factor)) = (input.option(), system.name(Kind::Mass), system.mass_for_reading());
    let read = if own == unit {
        String::new()
    } else {
        format!(", {} {unit}", crate::bits::digits(factor.times(number)))
    };
    progress::note(&format!(
        "{option} {text} is {text} {own}{read}, because a bare number is in the units of --units {system}. A mass in kg is \
         {option} {text}kg"
    ));
}

/// The failure, preceded by all typed inputs, if there are any.
pub(crate) fn behind_all<F: Value>(given: &Given<F>, failure: Failure) -> Failure {
    match given.all_typed() {
        inputs if inputs.is_empty() => failure,
        inputs => failure.about(&inputs),
    }
}

/// A note where a damping ratio without % is so large that a percentage was probably meant, and where gravity without a
/// unit is far from that of every planet, so that another unit was probably meant.
pub(crate) fn note_unusual<F: Value>(input: Input, text: &str, value: F, system: &System) {
    /// Gravity on the surface of Ceres and of Jupiter, as parts of that of the Earth.
    const PLANETS: [f64; 2] = [0.029, 2.5];
    let share = value.to_f64() / system.gravity::<f64>();
    if input == Input::Gravity && !Reader::has_unit(text) && !(PLANETS[0]..=PLANETS[1]).contains(&share) {
        let (option, unit) = (input.option(), crate::outputs::plain(&system.name(Kind::Acceleration)));
        progress::note(&format!(
            "{option} {text} is {text} {unit}, {} of standard gravity, because a bare number is in the units of \
             --units {system}. Gravity in m/s² is {option} {text}m/s^2",
            crate::bits::digits(share)
        ));
    }
    if input == Input::DampingRatio && value >= F::int(1) && !text.contains('%') {
        let (option, percent) = (input.option(), crate::bits::digits(F::int(100) * value));
        progress::note(&format!(
            "{option} {text} is {percent} % of critical damping. A damping ratio of {text} percent is {option} {text}%"
        ));
    }
}

/// The unit of the first frequency that was typed with one, and its value in rad/s.
pub(crate) fn frequency_unit<'a, F: Value>(typed: impl IntoIterator<Item = &'a str>) -> Option<(String, F)> {
    let units = typed.into_iter().flat_map(|text| text.split([':', ','])).map(|part| split(part).1);
    let of = |unit: &str| Reader::new(None, "").value::<F>("", &format!("1{unit}"), Kind::Frequency).ok();
    units.filter(|unit| !unit.is_empty()).find_map(|unit| Some((unit.to_owned(), of(unit)?)))
}

/// An input as on a picture: `r_y = 5 kN`, or the quantity in words where it has no symbol.
pub(crate) fn in_symbols(input: Input, text: &str, system: &System) -> String {
    let is_word = |part: &&str| part.len() > 1 && part.chars().all(|c| c.is_ascii_lowercase());
    let symbol: Vec<&str> = input.symbol().split(' ').skip_while(is_word).collect();
    let value = match split(text) {
        ("", _) => text.to_owned(),
        (number, "") if input.kind() == Kind::Ratio => number.to_owned(),
        (number, "") => format!("{number} {}", system.name(input.kind())),
        (number, unit @ ("%" | "°")) => format!("{number}{unit}"),
        (number, unit) => format!("{number} {}", unit.replace('*', "·")),
    };
    if input == Input::Frequency && !value.ends_with("rad/s") {
        // ω_d is in rad/s only.
        format!("f = {value}")
    } else if symbol.is_empty() {
        format!("{} {value}", input.symbol())
    } else {
        format!("{} = {value}", symbol.join(" "))
    }
}

/// The typed inputs that are shown on a picture, in a line.
pub(crate) fn line(typed: &[(Input, String)], shown: impl Fn(Input) -> bool, system: &System) -> String {
    let shown = typed.iter().filter(|(input, _)| shown(*input));
    shown.map(|(input, text)| in_symbols(*input, text, system)).collect::<Vec<_>>().join(", ")
}

/// The name of a displacement, which in a shifted motion is measured from the mean.
pub(crate) fn displacement<F: Value>(given: &Given<F>) -> &'static str {
    if given.is_shifted() { "displacement from the mean" } else { "displacement" }
}

/// The shift of the motion, which is the same under any drive.
pub(crate) fn mean_displacement<F: Value>(given: &Given<F>, body: &Oscillator<F>) -> Result<F, Failure> {
    Drive::force(body.friction_bound(), body.natural_frequency())
        .and_then(|drive| given.with_mean_force(drive))
        .and_then(|drive| stickslip::Scales::new(body, &drive))
        .map(|scales| scales.mean_displacement)
        .map_err(|e| given.at_fault(&e).into())
}

/// Says that the answer is that of a unit of mass.
pub(crate) fn note_unit_mass(system: &System) {
    let unit = system.name(Kind::Mass);
    progress::note(&format!(
        "--mass is left out: motions do not depend on it, and forces, stiffness and energies are those of 1 {unit}"
    ));
}

/// The inputs with a mass of 1 where none is given and the mass cancels: the body by its period or as a pendulum, friction
/// by its coefficient, and everything else by ratios or as a motion of the base.
pub(crate) fn with_any_mass<F: Value>(given: &Given<F>) -> Cow<'_, Given<F>> {
    let cancels = given.is_physical()
        && given.has_role(Role::Spring)
        && (given.has(Input::FrictionCoefficient) || !given.has_role(Role::Friction))
        && given.needs_no_mass();
    if !cancels {
        return Cow::Borrowed(given);
    }
    note_unit_mass(&given.system);
    let mut given = given.clone();
    given.set(Input::Mass, F::int(1));
    Cow::Owned(given)
}

/// The displacement and the velocity at the start, typed in units; 0 where one is left out.
pub(crate) fn start_in_units<F: Value>(
    reader: &Reader,
    typed: [Option<&str>; 2],
) -> Result<[F; 2], units::InputError> {
    let read = |input: Input, text: Option<&str>| match text {
        Some(text) => reader.value(input.option(), text, input.kind()),
        None => Ok(F::int(0)),
    };
    let [x0, v0] = typed;
    Ok([read(Input::X0, x0)?, read(Input::V0, v0)?])
}

/// Says that there is no friction, where it was given as 0.
pub(crate) fn note_frictionless<F: Value>(given: &Given<F>) {
    if given.is_without_friction() {
        progress::note("without friction α, B and the values in B and r_y do not exist, and are left out");
    }
}

/// Refuses friction 0 where limits are searched by their starts: a linear motion has but one. A body without a spring has one, too,
/// at any place: its velocity alone decides, and of two slides that begin at rest the earlier one ends later.
pub(crate) fn refuse_frictionless<F: Value>(given: &Given<F>) -> Result<(), Failure> {
    if given.is_without_spring() {
        let label = given.label(Input::Stiffness);
        return Err(format!(
            "{label}: every start has one limit, but for its place, which no spring holds. `stickslip steady` answers with it"
        )
        .into());
    }
    if !given.is_without_friction() {
        return Ok(());
    }
    let label = given.first_of(Role::Friction).map_or_else(String::new, |input| given.label(input));
    Err(format!(
        "{label}: must be > 0. Without friction the motion is linear, and has only the limit of steady"
    )
    .into())
}

/// A note where a friction pendulum leaves the displacements for which its stiffness is m g/R.
pub(crate) fn note_pendulum<F: Value>(given: &Given<F>, reach: F) {
    /// Displacement over the radius at which the horizontal force of the bowl, m g x/√(R² − x²), exceeds m g x/R by 2 %.
    const SHARE: f64 = 0.2;
    let Some(radius) = given.get(Input::PendulumRadius) else { return };
    if reach.to_f64() > SHARE * radius.to_f64() {
        progress::note(
            "--pendulum-radius: the displacement exceeds a fifth of the radius, where the force of the bowl exceeds \
             k x = m g x/R by 2 % or more",
        );
    }
}

/// The ratios of `--omega` and `--alpha`, or the machine of the physical arguments.
pub(crate) fn point<F: Value>(given: &Given<F>) -> Result<Point<F>, Failure> {
    if given.is_empty() {
        let text = "--omega and --alpha are missing. Give both, or a machine: --mass, --stiffness (or --period), \
                    --friction (or --friction-coefficient), --frequency and --force";
        return Err(text.into());
    }
    note_frictionless(given);
    Ok(given.point()?)
}

/// Ω of `--omega` at α = 1, or the machine under a force of r_y.
fn border_point<F: Value>(given: &Given<F>) -> Result<Point<F>, Failure> {
    let named = |e: Error| given.at_fault(&e);
    if given.is_empty() {
        let text = "--omega is missing. Give it, or a machine: --mass, --stiffness (or --period), --friction (or \
                    --friction-coefficient) and --frequency";
        return Err(text.into());
    }
    if !given.is_physical() {
        let ratios = Ratios::new(given.required(Input::Omega)?, F::int(1)).map_err(named)?;
        return Ok(Point { ratios: given.completed(ratios)?, machine: None });
    }
    if !given.is_without_friction() {
        let machine = given.on_border()?;
        return Ok(Point { ratios: machine.ratios, machine: Some(machine) });
    }
    progress::note("without friction no force is needed: the minimum is 0 times r_y = 0");
    let mut any = given.clone();
    any.replace_friction(F::int(1));
    let mut machine = any.on_border()?;
    // Lengths and forces of a border are multiples of the friction.
    let (scales, zero) = (&mut machine.scales, F::int(0));
    (scales.length, scales.velocity, scales.force) = (zero, zero, zero);
    Ok(Point { ratios: machine.ratios, machine: Some(machine) })
}

/// The problem of a question.
pub(crate) fn problem<F: Value>(question: Swept, given: &Given<F>) -> Result<Point<F>, Failure> {
    if question == Swept::Border { border_point(given) } else { point(given) }
}

/// The state at ω_d t = 0 given by `--x0` and `--v0`, or by a row of a file, in the units of the point.
pub(crate) fn start<F: Value>(
    start: &StartArgs,
    given: &Given<F>,
    machine: Option<&Driven<F>>,
    reader: &Reader,
) -> Result<State<F>, Failure> {
    let read = |input: Input| match (given.get(input), start.text(input)) {
        (Some(value), _) => Ok(value),
        // Without a machine there are only ratios.
        (None, Some(text)) => {
            let kind = if machine.is_some() { input.kind() } else { Kind::Ratio };
            reader.value(input.option(), text, kind)
        }
        (None, None) => Ok(F::int(0)),
    };
    let (x0, v0) = (read(Input::X0)?, read(Input::V0)?);
    let (x, v) = match machine {
        Some(Driven { scales, .. }) => (x0 / scales.length, v0 / scales.velocity),
        None => (x0, v0),
    };
    State::new(F::int(0), x, v).map_err(|e| {
        let input = if e.quantity() == Some(Quantity::Velocity) { Input::V0 } else { Input::X0 };
        let argument = match given.get(input) {
            Some(value) => format!("{} {value}", input.column()),
            None => format!("{} {}", input.option(), start.text(input).unwrap_or("0")),
        };
        Failure::Input(format!("{argument}: {e}"))
    })
}

/// The greatest number of periods of a motion.
pub(crate) fn periods(most: u32) -> Result<u32, Failure> {
    if most >= 1 { Ok(most) } else { Err("--max-periods 0: must be ≥ 1".into()) }
}

/// An integer of at least 1.
pub(crate) fn count(name: &str, text: &str, greatest: u64) -> Result<u64, Failure> {
    match text.trim().parse() {
        Ok(n) if (1..=greatest).contains(&n) => Ok(n),
        _ => Err(format!("{name} {text}: must be a whole number ≥ 1 and ≤ {greatest}").into()),
    }
}

/// A typed number.
pub(crate) fn number<F: Value>(name: &str, text: &str) -> Result<F, Failure> {
    Ok(units::number(name, text)?)
}
