//! From the arguments to the ratios and, if given, the machine.

use crate::args::StartArgs;
use crate::bits::Value;
use crate::failure::Failure;
use crate::given::{Given, Parameter as P};
use crate::machine::Machine;
use stickslip::exact::State;
use stickslip::units::{self, Kind, Reader, System};
use stickslip::{Drive, Quantity, Ratios, Scales};

/// The input of `response`: the ratios and, in physical units, the machine.
pub(crate) struct Point<F> {
    pub(crate) ratios: Ratios<F>,
    pub(crate) machine: Option<Machine<F>>,
}

/// The input of `border`: Ω and ζ, at α = 1, and, in physical units, r_y and ω_d.
pub(crate) struct BorderPoint<F> {
    pub(crate) ratios: Ratios<F>,
    pub(crate) physical: Option<BorderScales<F>>,
}

/// The scales of a border: force r_y, length B, time 1/ω_d, and ω_d itself.
#[derive(Clone, Copy)]
pub(crate) struct BorderScales<F> {
    pub(crate) length: F,
    pub(crate) force: F,
    pub(crate) time: F,
    pub(crate) frequency: F,
    pub(crate) system: System,
}

/// The ratios of `--omega` and `--alpha`, or the machine of the physical arguments.
pub(crate) fn point<F: Value>(given: &Given<F>) -> Result<Point<F>, Failure> {
    let named = |e| given.at_fault(e);
    if given.is_empty() {
        let text = "--omega and --alpha are missing. Give both, or a machine: --mass, --stiffness (or --period), \
                    --friction (or --friction-coefficient), --frequency and --force";
        return Err(Failure::Input(text.to_owned()));
    }
    if !given.is_physical() {
        let ratios = Ratios::new(given.required(P::Omega)?, given.required(P::Alpha)?).map_err(named)?;
        return Ok(Point { ratios: completed(given, ratios)?, machine: None });
    }
    let oscillator = given.oscillator()?;
    let drive = given.drive(&oscillator, given.frequency(&oscillator)?)?;
    let ratios = drive.ratios(&oscillator).map_err(named)?;
    let scales = Scales::new(&oscillator, &drive).map_err(named)?;
    // A given ratio is used as typed, without the rounding of a conversion by k and p₀.
    let omega = given.get(P::Omega).unwrap_or(ratios.omega());
    let alpha = given.get(P::Alpha).unwrap_or(ratios.alpha());
    let zeta = given.get(P::DampingRatio).unwrap_or(ratios.damping_ratio());
    let eta = given.get(P::StaticFrictionRatio).unwrap_or(ratios.static_friction_ratio());
    let ratios = Ratios::new(omega, alpha)
        .and_then(|r| r.with_damping_ratio(zeta)?.with_static_friction_ratio(eta))
        .map_err(named)?;
    let machine = Machine {
        oscillator,
        drive,
        scales,
        system: given.system,
        has_damper: given.has_damper(),
        has_static_friction: given.has_static_friction(),
        directional_friction: given.directional_friction()?,
        mean_force: given.get(P::MeanForce),
        friction_coefficient: given.get(P::FrictionCoefficient),
    };
    Ok(Point { ratios, machine: Some(machine) })
}

/// The ratios with the given damping and static friction.
pub(crate) fn completed<F: Value>(given: &Given<F>, ratios: Ratios<F>) -> Result<Ratios<F>, Failure> {
    let zeta = given.get(P::DampingRatio).unwrap_or(F::int(0));
    let eta = given.get(P::StaticFrictionRatio).unwrap_or(F::int(1));
    ratios
        .with_damping_ratio(zeta)
        .and_then(|ratios| ratios.with_static_friction_ratio(eta))
        .map_err(|e| given.at_fault(e))
}

/// The state at ω_d t = 0 given by `--x0` and `--v0`, or by a row of a file, in the units of the point.
pub(crate) fn start<F: Value>(
    start: &StartArgs,
    given: &Given<F>,
    machine: Option<&Machine<F>>,
    reader: &Reader,
) -> Result<State<F>, Failure> {
    let read = |parameter: P, text: &Option<String>| match (given.get(parameter), text) {
        (Some(value), _) => Ok(value),
        // Without a machine there are only ratios.
        (None, Some(text)) => {
            let kind = if machine.is_some() { parameter.kind() } else { Kind::Ratio };
            reader.value(parameter.option(), text, kind)
        }
        (None, None) => Ok(F::int(0)),
    };
    let x0 = read(P::X0, &start.x0)?;
    let v0 = read(P::V0, &start.v0)?;
    let (x, v) = match machine {
        Some(Machine { scales, .. }) => (x0 / scales.length, v0 / scales.velocity),
        None => (x0, v0),
    };
    let argument = |parameter: P, text: &Option<String>| match given.get(parameter) {
        Some(value) => format!("{} {value}", parameter.column()),
        None => format!("{} {}", parameter.option(), text.as_deref().unwrap_or("0")),
    };
    State::new(F::int(0), x, v).map_err(|e| {
        let argument = match e.quantity() {
            Some(Quantity::Velocity) => argument(P::V0, &start.v0),
            _ => argument(P::X0, &start.x0),
        };
        Failure::Input(format!("{argument}: {e}"))
    })
}

/// The greatest number of periods of a motion.
pub(crate) fn periods(most: u32) -> Result<u32, Failure> {
    if most >= 1 { Ok(most) } else { Err(Failure::Input("--max-periods 0: must be ≥ 1".to_owned())) }
}

/// An integer of at least 1.
pub(crate) fn count(name: &str, text: &str, greatest: u64) -> Result<u64, Failure> {
    match text.trim().parse() {
        Ok(n) if (1..=greatest).contains(&n) => Ok(n),
        _ => Err(Failure::Input(format!("{name} {text}: must be a whole number ≥ 1 and ≤ {greatest}"))),
    }
}

/// Ω of `--omega`, or of the physical arguments.
pub(crate) fn border_point<F: Value>(given: &Given<F>) -> Result<BorderPoint<F>, Failure> {
    let named = |e| given.at_fault(e);
    if given.is_empty() {
        let text = "--omega is missing. Give it, or a machine: --mass, --stiffness (or --period), --friction (or \
                    --friction-coefficient) and --frequency";
        return Err(Failure::Input(text.to_owned()));
    }
    if !given.is_physical() {
        let ratios = Ratios::new(given.required(P::Omega)?, F::int(1)).map_err(named)?;
        return Ok(BorderPoint { ratios: completed(given, ratios)?, physical: None });
    }
    let oscillator = given.oscillator()?;
    let frequency = given.frequency(&oscillator)?;
    // A force of r_y has α = 1: its scales are those of the border.
    let drive = Drive::force(oscillator.friction_bound(), frequency).map_err(named)?;
    let ratios = drive.ratios(&oscillator).map_err(named)?;
    let scales = Scales::new(&oscillator, &drive).map_err(named)?;
    let omega = given.get(P::Omega).unwrap_or(ratios.omega());
    let zeta = given.get(P::DampingRatio).unwrap_or(ratios.damping_ratio());
    let eta = given.get(P::StaticFrictionRatio).unwrap_or(ratios.static_friction_ratio());
    Ok(BorderPoint {
        ratios: Ratios::new(omega, F::int(1))
            .and_then(|r| r.with_damping_ratio(zeta)?.with_static_friction_ratio(eta))
            .map_err(named)?,
        physical: Some(BorderScales {
            length: scales.length,
            force: scales.force,
            time: scales.time,
            frequency,
            system: given.system,
        }),
    })
}

/// A typed number.
pub(crate) fn number<F: Value>(name: &str, text: &str) -> Result<F, Failure> {
    Ok(units::number(name, text)?)
}
