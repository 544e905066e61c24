//! Numbers, inputs and results in the formats of serde. Results with private fields are serialised as maps, with the names of the command's JSON. Results with
//! public fields derive it.

use crate::cycle::Cycle;
use crate::cycle::response::Response;
#[cfg(feature = "mp")]
use crate::enclosed::{self, Enclosure};
use crate::float::Float;
use crate::machine::error::{Error, Quantity};
use crate::motion::record::Record;
use crate::motion::{FreeDecay, Segment, SteadyOutput, SteadyState};
use crate::named::UnknownName;
use crate::output::Output;
#[cfg(feature = "dual")]
use crate::sensitivity::{Sensitivities, Sensitivity};
#[cfg(feature = "random")]
use crate::uncertainty::MonteCarlo;
use serde::ser::{Serialize, SerializeMap, Serializer};

mod inputs;
mod results;

pub(crate) use inputs::{
    BodyFields, DriveFields, DrivePhaseFields, OscillatorFields, RatiosFields, RecordFields, StateFields,
};
pub(crate) use results::{
    CycleFields, Followed, FreeDecayFields, ResponseFields, SegmentFields, SteadyFields, Within, infinite,
    unbounded,
};

/// Serialises as the text that `Display` prints.
macro_rules! as_text {
    ($($type:ty),* $(,)?) => {
        $(impl Serialize for $type {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.collect_str(self)
            }
        })*
    };
}

as_text!(Error, Quantity, UnknownName);
#[cfg(feature = "mp")]
as_text!(crate::float::ParseError, crate::float::PrecisionError);
#[cfg(feature = "matching")]
as_text!(crate::cycle::MatchingError);
#[cfg(feature = "system")]
as_text!(crate::system::Error);

/// Serialises as the name in the command's JSON.
macro_rules! as_name {
    ($($type:ident),*) => {
        $(impl Serialize for $type {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.serialize_str(self.definition().name)
            }
        })*
    };
}

as_name!(Output, SteadyOutput);

/// The excitation, the times and the samples, and the load after them; equal steps by the first time and the step.
impl<F: Float + Serialize> Serialize for Record<F> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        in_map(serializer, None, |map| {
            map.serialize_entry("excitation", &self.excitation())?;
            match self.times() {
                Ok((start, step)) => {
                    map.serialize_entry("start", &start)?;
                    map.serialize_entry("step", &step)?;
                }
                Err(times) => map.serialize_entry("times", times)?,
            }
            map.serialize_entry("samples", self.samples())?;
            map.serialize_entry("after", &self.after())
        })
    }
}

/// The kind, the event that ends it, the states at both ends, the duration, and under `within` the rest that is needed to read it back.
impl<F: Float + Serialize> Serialize for Segment<F> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        in_map(serializer, Some(6), |map| {
            map.serialize_entry("kind", &self.kind)?;
            map.serialize_entry("ends_by", &self.ends_by)?;
            map.serialize_entry("start", &self.start())?;
            map.serialize_entry("end", &self.end())?;
            map.serialize_entry("duration", &self.duration())?;
            map.serialize_entry("within", &Within::from(self))
        })
    }
}

/// A map of `len` entries, if their number is known.
fn in_map<S: Serializer>(
    serializer: S,
    len: Option<usize>,
    entries: impl FnOnce(&mut S::SerializeMap) -> Result<(), S::Error>,
) -> Result<S::Ok, S::Error> {
    let mut map = serializer.serialize_map(len)?;
    entries(&mut map)?;
    map.end()
}

/// The ratios, the regime, and every [`Output`]; null for those that do not exist.
impl<F: Float + Serialize> Serialize for Response<F> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let ratios = self.ratios;
        in_map(serializer, None, |map| {
            map.serialize_entry("omega", &ratios.omega())?;
            map.serialize_entry("alpha", &ratios.alpha())?;
            map.serialize_entry("damping_ratio", &ratios.damping_ratio())?;
            map.serialize_entry("static_friction_ratio", &ratios.static_friction_ratio())?;
            map.serialize_entry("excitation", &ratios.excitation())?;
            map.serialize_entry("regime", self.regime.name())?;
            map.serialize_entry("motion_without_stop", &self.has_motion_without_stop())?;
            map.serialize_entry("moves_from_rest", &ratios.moves_from_rest())?;
            for output in Output::ALL {
                map.serialize_entry(output.name(), &output.of(self))?;
            }
            Ok(())
        })
    }
}

/// The ratios, and every [`Output`] of the cycle.
impl<F: Float + Serialize> Serialize for Cycle<F> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let ratios = self.ratios;
        in_map(serializer, None, |map| {
            map.serialize_entry("omega", &ratios.omega())?;
            map.serialize_entry("alpha", &ratios.alpha())?;
            map.serialize_entry("damping_ratio", &ratios.damping_ratio())?;
            map.serialize_entry("static_friction_ratio", &ratios.static_friction_ratio())?;
            map.serialize_entry("excitation", &ratios.excitation())?;
            for output in Output::ALL {
                if let Some(value) = output.of_cycle(self) {
                    map.serialize_entry(output.name(), &value)?;
                }
            }
            map.serialize_entry("damper_work", &self.damper_work())
        })
    }
}

/// Every [`SteadyOutput`], the counts of a cycle, the multipliers as pairs of a real and an imaginary part, and under
/// `followed` the rest that is needed to read it back.
impl<F: Float + Serialize> Serialize for SteadyState<F> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        in_map(serializer, None, |map| {
            map.serialize_entry("turns_per_cycle", &self.turns_per_cycle)?;
            map.serialize_entry("sticks_per_cycle", &self.sticks_per_cycle)?;
            map.serialize_entry("velocity_zeros_per_cycle", &self.velocity_zeros_per_cycle)?;
            map.serialize_entry("symmetric", &self.is_symmetric)?;
            map.serialize_entry("stable", &self.is_stable())?;
            map.serialize_entry("multipliers", &self.multipliers)?;
            for output in SteadyOutput::ALL {
                map.serialize_entry(output.definition().name, &output.of(self))?;
            }
            map.serialize_entry("periods", &self.periods)?;
            map.serialize_entry("state", &self.state)?;
            map.serialize_entry("followed", &Followed::from(self))
        })
    }
}

/// The vibration and its start; a creep never comes to rest: its `rest_time` is null.
impl<F: Float + Serialize> Serialize for FreeDecay<F> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        in_map(serializer, None, |map| {
            map.serialize_entry("half_cycles", &self.half_cycles)?;
            map.serialize_entry("first_turn", &self.first_turn)?;
            map.serialize_entry("rest_position", &self.rest_position)?;
            map.serialize_entry("rest_time", &Some(self.rest_time).filter(|time| time.is_finite()))?;
            map.serialize_entry("start", &self.start())?;
            map.serialize_entry("damping_ratio", &self.damping_ratio())?;
            map.serialize_entry("static_friction_ratio", &self.static_friction_ratio())
        })
    }
}

/// The value, and its derivatives by m, k, r_y, the amplitude and ω_d.
#[cfg(feature = "dual")]
impl Serialize for Sensitivity {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        in_map(serializer, Some(2), |map| {
            map.serialize_entry("value", &self.value)?;
            map.serialize_entry("by", self.by.as_slice())
        })
    }
}

/// The regime, and every output that exists with its derivatives.
#[cfg(feature = "dual")]
impl Serialize for Sensitivities {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        in_map(serializer, None, |map| {
            map.serialize_entry("regime", &self.regime)?;
            for (output, found) in &self.outputs {
                map.serialize_entry(output.name(), &found)?;
            }
            Ok(())
        })
    }
}

/// The number of draws, the number in each regime, and the values of each output that was kept.
#[cfg(feature = "random")]
impl Serialize for MonteCarlo {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        in_map(serializer, None, |map| {
            map.serialize_entry("draws", &self.draws)?;
            map.serialize_entry("invalid", &self.invalid)?;
            for (regime, count) in self.regimes() {
                map.serialize_entry(regime.name(), count)?;
            }
            for output in Output::ALL {
                let values = self.values(output);
                if !values.is_empty() {
                    map.serialize_entry(output.name(), values)?;
                }
            }
            Ok(())
        })
    }
}

/// Midpoint and radius in decimal, with two digits more than are certain.
#[cfg(feature = "mp")]
impl Serialize for Enclosure {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let (mid, rad) = self.decimal();
        in_map(serializer, Some(2), |map| {
            map.serialize_entry("mid", &mid)?;
            map.serialize_entry("rad", &rad)
        })
    }
}

#[cfg(feature = "mp")]
impl Serialize for enclosed::Regime {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

/// The regime, every [`Output`], and the bits; null for outputs that do not exist or are not certain.
#[cfg(feature = "mp")]
impl Serialize for enclosed::Response {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        in_map(serializer, None, |map| {
            map.serialize_entry("regime", &self.regime)?;
            map.serialize_entry("moves_from_rest", &self.moves_from_rest)?;
            for output in Output::ALL {
                map.serialize_entry(output.name(), &self.get(output))?;
            }
            map.serialize_entry("bits", &self.bits)
        })
    }
}

#[cfg(test)]
mod tests;
