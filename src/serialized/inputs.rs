//! Inputs are read from maps of their fields, by the rules of their constructors: a value that breaks one is an error
//! of the format, with the inequality. What is written is read back with the same bits.

use crate::Excitation;
use crate::float::Float;
use crate::machine::error::Error;
use crate::motion::record::{After, Body, Record};
use crate::motion::{DrivePhase, State};
use crate::named::UnknownName;
use crate::output::Output;
use crate::{Drive, Oscillator, Ratios};
use alloc::borrow::ToOwned;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use serde::Deserialize;

/// The condition that a field violates.
#[derive(thiserror::Error, Debug)]
#[error("{0}")]
pub(crate) struct Unread(String);

impl Unread {
    /// The condition in words.
    pub(super) fn of(condition: &str) -> Self {
        Self(condition.to_owned())
    }
}

impl From<Error> for Unread {
    fn from(error: Error) -> Self {
        Self(error.to_string())
    }
}

/// Defines the fields from which an input is read; those with a value may be left out.
macro_rules! fields {
    ($($name:ident -> $input:ident { $($field:ident: $type:ty $(= $value:expr)?,)* } by $read:expr;)*) => {
        $(
            #[derive(Deserialize)]
            #[serde(deny_unknown_fields, bound(deserialize = "F: Float + Deserialize<'de>"))]
            pub(crate) struct $name<F> {
                $($(#[serde(default = $value)])? $field: $type,)*
            }

            impl<F: Float> TryFrom<$name<F>> for $input<F> {
                type Error = Unread;

                fn try_from($name { $($field),* }: $name<F>) -> Result<Self, Unread> {
                    let read: fn($($type),*) -> Result<Self, Unread> = $read;
                    read($($field),*)
                }
            }
        )*
    };
}

fields! {
    RatiosFields -> Ratios {
        omega: F, alpha: F, damping_ratio: F = "zero", static_friction_ratio: F = "one",
        excitation: Option<Excitation> = "absent",
    } by |omega, alpha, damping_ratio, static_friction_ratio, excitation| {
        Ok(Ratios::new(omega, alpha)?
            .with_damping_ratio(damping_ratio)?
            .with_static_friction_ratio(static_friction_ratio)?
            .under(excitation))
    };
    OscillatorFields -> Oscillator {
        mass: F, stiffness: F, friction_bound: F, damping: F = "zero", friction_offset: F = "zero",
        static_friction_ratio: F = "one", static_friction: Option<F> = "absent",
    } by |mass, stiffness, friction_bound, damping, friction_offset, static_friction_ratio, static_friction| {
        let body = Oscillator::new(mass, stiffness, friction_bound)?
            .with_damping(damping)?
            .with_friction_offset(friction_offset)?
            .with_static_friction_ratio(static_friction_ratio)?;
        Ok(static_friction.map_or(Ok(body), |static_friction| body.with_static_friction(static_friction))?)
    };
    DriveFields -> Drive {
        excitation: Excitation, amplitude: F, angular_frequency: F, mean_force: F = "zero",
    } by |excitation, amplitude, angular_frequency, mean_force| {
        Ok(Drive::new(excitation, amplitude, angular_frequency)?.with_mean_force(mean_force)?)
    };
    DrivePhaseFields -> DrivePhase {
        half_turns: i64 = "no_turns", angle: F,
    } by |half_turns, angle| Ok(DrivePhase::from_half_turns(half_turns, angle)?);
    StateFields -> State {
        phase: DrivePhase<F> = "no_phase", x: F, v: F,
    } by |phase, x, v| Ok(State { phase, ..State::new(F::int(0), x, v)? });
    BodyFields -> Body {
        mass: F, friction: F, stiffness: F = "zero", damping: F = "zero", static_friction_ratio: F = "one",
        mean_force: F = "zero", friction_offset: F = "zero", is_one_way: bool = "no",
    } by |mass, friction, stiffness, damping, static_friction_ratio, mean_force, friction_offset, is_one_way| {
        let body = Body::new(mass, friction)?
            .with_stiffness(stiffness)?
            .with_damping(damping)?
            .with_static_friction_ratio(static_friction_ratio)?
            .with_mean_force(mean_force)?
            .with_friction_offset(friction_offset)?;
        Ok(if is_one_way { body.one_way() } else { body })
    };
    RecordFields -> Record {
        excitation: Excitation, start: Option<F> = "absent", step: Option<F> = "absent", times: Option<Vec<F>> = "absent",
        samples: Vec<F>, after: Option<After> = "absent",
    } by |excitation, start, step, times, samples, after| {
        let record = match (start, step, times) {
            (_, Some(step), None) => {
                Record::new(excitation, step, samples)?.beginning_at(start.unwrap_or_else(zero))?
            }
            (None, None, Some(times)) => Record::at_times(excitation, times, samples)?,
            (Some(_), None, Some(_)) => {
                return Err(Unread::of("record: start must be left out beside times"));
            }
            (_, Some(_), Some(_)) | (_, None, None) => {
                return Err(Unread::of("record: needs a step or times, and not both"));
            }
        };
        let after = after.unwrap_or_else(|| record.after());
        Ok(record.followed_by(after))
    };
}

pub(super) fn zero<F: Float>() -> F {
    F::int(0)
}

pub(super) fn one<F: Float>() -> F {
    F::int(1)
}

const fn no_turns() -> i64 {
    0
}

fn no_phase<F: Float>() -> DrivePhase<F> {
    State::default().phase
}

const fn no() -> bool {
    false
}

pub(super) const fn absent<T>() -> Option<T> {
    None
}

/// An output by its name.
impl TryFrom<String> for Output {
    type Error = UnknownName;

    fn try_from(name: String) -> Result<Self, UnknownName> {
        name.parse()
    }
}
