//! From the arguments to the ratios and, where given, the machine.

use crate::args::{ForceArgs, MachineArgs, StartArgs};
use crate::bits::Value;
use crate::failure::Failure;
use stickslip::exact::State;
use stickslip::{Drive, Error, Oscillator, PhaseFunction, Quantity, Ratios, Scales};

/// A machine in physical units and the scale of its answers.
pub(crate) struct Machine<F> {
    pub(crate) oscillator: Oscillator<F>,
    pub(crate) drive: Drive<F>,
    pub(crate) scales: Scales<F>,
}

/// What `response` is asked: the ratios and, in physical units, the machine.
pub(crate) struct Point<F> {
    pub(crate) ratios: Ratios<F>,
    pub(crate) machine: Option<Machine<F>>,
}

/// What `border` is asked: Ω and, in physical units, r_y and ω_d.
pub(crate) struct BorderPoint<F> {
    pub(crate) omega: F,
    pub(crate) physical: Option<BorderScales<F>>,
}

/// The scales a border has: force r_y, length B, time 1/ω_d, and ω_d itself.
#[derive(Clone, Copy)]
pub(crate) struct BorderScales<F> {
    pub(crate) length: F,
    pub(crate) force: F,
    pub(crate) time: F,
    pub(crate) frequency: F,
}

/// A border has no force.
pub(crate) const NO_FORCE: ForceArgs = ForceArgs { alpha: None, force: None, base_motion: None };

/// The ratios of `--omega` and `--alpha`, or the machine of the physical arguments.
pub(crate) fn point<F: Value>(machine: &MachineArgs, force: &ForceArgs) -> Result<Point<F>, Failure> {
    if !is_physical(machine) && force.force.is_none() && force.base_motion.is_none() {
        let omega = required("--omega", machine.omega.as_ref())?;
        let alpha = required("--alpha", force.alpha.as_ref())?;
        let ratios = Ratios::new(omega, alpha).map_err(|e| at_fault(e, machine, force))?;
        return Ok(Point { ratios, machine: None });
    }
    let oscillator = oscillator(machine, force)?;
    let frequency = required("--frequency", machine.frequency.as_ref())?;
    let named = |e| at_fault(e, machine, force);
    let drive = drive(&oscillator, frequency, force)?.map_err(named)?;
    let ratios = drive.ratios(&oscillator).map_err(named)?;
    let scales = Scales::new(&oscillator, &drive).map_err(named)?;
    // What was given as a ratio stays as it was typed, without the rounding of the way through k and p₀.
    let omega = number_or(ratios.omega(), "--omega", machine.omega.as_ref())?;
    let alpha = number_or(ratios.alpha(), "--alpha", force.alpha.as_ref())?;
    let ratios = Ratios::new(omega, alpha).map_err(named)?;
    Ok(Point { ratios, machine: Some(Machine { oscillator, drive, scales }) })
}

/// The state at ω_d t = 0 that `--x0` and `--v0` name, in the machine's units where there is one.
pub(crate) fn start<F: Value>(start: &StartArgs, machine: Option<&Machine<F>>) -> Result<State<F>, Failure> {
    let zero = F::int(0);
    let x0 = number_or(zero, "--x0", start.x0.as_ref())?;
    let v0 = number_or(zero, "--v0", start.v0.as_ref())?;
    let (x, v) = match machine {
        Some(Machine { scales, .. }) => (x0 / scales.length, v0 / scales.velocity),
        None => (x0, v0),
    };
    let typed = |name: &str, text: &Option<String>| format!("{name} {}", text.as_deref().unwrap_or("0"));
    State::new(zero, x, v).map_err(|e| {
        let argument = match e.quantity() {
            Some(Quantity::Velocity) => typed("--v0", &start.v0),
            _ => typed("--x0", &start.x0),
        };
        Failure::Input(format!("{argument}: {e}"))
    })
}

/// A whole number of at least 1, as typed.
pub(crate) fn count(name: &str, text: &str, greatest: u64) -> Result<u64, Failure> {
    match text.trim().parse() {
        Ok(n) if (1..=greatest).contains(&n) => Ok(n),
        _ => Err(Failure::Input(format!("{name} {text}: must be a whole number ≥ 1 and ≤ {greatest}"))),
    }
}

/// Ω of `--omega`, or of the physical arguments.
pub(crate) fn border_point<F: Value>(machine: &MachineArgs) -> Result<BorderPoint<F>, Failure> {
    let named = |e| at_fault(e, machine, &NO_FORCE);
    if !is_physical(machine) {
        let omega = required("--omega", machine.omega.as_ref())?;
        return PhaseFunction::new(omega)
            .map(|p| BorderPoint { omega: p.omega(), physical: None })
            .map_err(named);
    }
    let oscillator = oscillator(machine, &NO_FORCE)?;
    let frequency = required("--frequency", machine.frequency.as_ref())?;
    // A force of r_y has α = 1: its scales are those of the border.
    let drive = Drive::force(oscillator.friction_bound(), frequency).map_err(named)?;
    let ratios = drive.ratios(&oscillator).map_err(named)?;
    let scales = Scales::new(&oscillator, &drive).map_err(named)?;
    Ok(BorderPoint {
        omega: number_or(ratios.omega(), "--omega", machine.omega.as_ref())?,
        physical: Some(BorderScales {
            length: scales.length,
            force: scales.force,
            time: scales.time,
            frequency,
        }),
    })
}

/// A number as typed.
pub(crate) fn number<F: Value>(name: &str, text: &str) -> Result<F, Failure> {
    text.trim().parse().map_err(|_| Failure::Input(format!("{name} {text}: must be a number")))
}

pub(crate) fn is_physical(machine: &MachineArgs) -> bool {
    [&machine.mass, &machine.stiffness, &machine.friction, &machine.frequency].iter().any(|a| a.is_some())
}

pub(crate) fn required<F: Value>(name: &str, given: Option<&String>) -> Result<F, Failure> {
    match given {
        Some(text) => number(name, text),
        None => Err(Failure::Input(format!("{name} is missing"))),
    }
}

fn number_or<F: Value>(otherwise: F, name: &str, given: Option<&String>) -> Result<F, Failure> {
    given.map_or(Ok(otherwise), |text| number(name, text))
}

fn oscillator<F: Value>(machine: &MachineArgs, force: &ForceArgs) -> Result<Oscillator<F>, Failure> {
    let mass = required("--mass", machine.mass.as_ref())?;
    let friction = required("--friction", machine.friction.as_ref())?;
    match (&machine.stiffness, &machine.omega) {
        (Some(_), Some(_)) => {
            let text = "--omega and --stiffness: give one of the two, the other follows";
            return Err(Failure::Input(text.to_owned()));
        }
        (Some(k), None) => Oscillator::new(mass, number("--stiffness", k)?, friction),
        (None, Some(omega)) => {
            let frequency = required("--frequency", machine.frequency.as_ref())?;
            Oscillator::tuned(mass, friction, frequency, number("--omega", omega)?)
        }
        (None, None) => return Err(Failure::Input("--stiffness (or --omega) is missing".to_owned())),
    }
    .map_err(|e| at_fault(e, machine, force))
}

/// The drive that the arguments name; the inner error is the library's.
fn drive<F: Value>(
    oscillator: &Oscillator<F>,
    frequency: F,
    force: &ForceArgs,
) -> Result<Result<Drive<F>, Error>, Failure> {
    match (&force.force, &force.base_motion, &force.alpha) {
        (Some(p0), None, None) => Ok(Drive::force(number("--force", p0)?, frequency)),
        (None, Some(ug), None) => Ok(Drive::base_motion(number("--base-motion", ug)?, frequency)),
        (None, None, Some(alpha)) => {
            Ok(Drive::with_force_ratio(oscillator, number("--alpha", alpha)?, frequency))
        }
        (None, None, None) => {
            Err(Failure::Input("--force (or --base-motion, or --alpha) is missing".to_owned()))
        }
        (..) => Err(Failure::Input("--force, --base-motion and --alpha: give one of the three".to_owned())),
    }
}

/// An argument, its value, and the quantities that it decides on.
pub(crate) type Given<'a> = (&'a str, &'a Option<String>, &'a [Quantity]);

/// The arguments of a machine and its drive.
pub(crate) fn given<'a>(machine: &'a MachineArgs, force: &'a ForceArgs) -> [Given<'a>; 8] {
    use Quantity as Q;
    [
        ("--omega", &machine.omega, &[Q::FrequencyRatio, Q::Stiffness]),
        ("--mass", &machine.mass, &[Q::Mass, Q::FrequencyRatio, Q::PseudoStiffness]),
        ("--stiffness", &machine.stiffness, &[Q::Stiffness, Q::FrequencyRatio, Q::FrictionDisplacement]),
        ("--friction", &machine.friction, &[Q::FrictionBound, Q::ForceRatio, Q::FrictionDisplacement]),
        (
            "--frequency",
            &machine.frequency,
            &[Q::AngularFrequency, Q::FrequencyRatio, Q::VelocityScale, Q::TimeScale, Q::PseudoStiffness],
        ),
        ("--alpha", &force.alpha, &[Q::ForceRatio, Q::ForceAmplitude]),
        (
            "--force",
            &force.force,
            &[Q::ForceAmplitude, Q::ForceRatio, Q::StaticEnergy, Q::PseudoStaticEnergy],
        ),
        ("--base-motion", &force.base_motion, &[Q::BaseAmplitude, Q::ForceAmplitude, Q::ForceRatio]),
    ]
}

/// All that was typed of a machine and its drive.
pub(crate) fn typed(machine: &MachineArgs, force: &ForceArgs) -> String {
    let written = given(machine, force)
        .into_iter()
        .filter_map(|(name, value, _)| Some(format!("{name} {}", value.as_ref()?)));
    written.collect::<Vec<_>>().join(" ")
}

/// The library's error behind the argument, or arguments, that it comes from.
pub(crate) fn at_fault(error: Error, machine: &MachineArgs, force: &ForceArgs) -> Failure {
    behind(error, &given(machine, force))
}

/// The error behind those of the arguments that decide on its quantity, or behind all where none does alone.
pub(crate) fn behind(error: Error, given: &[Given<'_>]) -> Failure {
    let quantity = error.quantity();
    let is_its_own = |(_, _, quantities): &&Given<'_>| quantity.is_some_and(|q| quantities.contains(&q));
    let written = |(name, value, _): &Given<'_>| value.as_ref().map(|v| format!("{name} {v}"));
    let mut named: Vec<String> = given.iter().filter(is_its_own).filter_map(written).collect();
    if named.is_empty() {
        named = given.iter().filter_map(written).collect();
    }
    Failure::Input(format!("{}: {error}", named.join(" ")))
}
