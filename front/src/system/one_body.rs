//! One body as a system: on its spring, damper and surface, under a load that repeats itself.
//!
//! The friction of a system is the mean of both directions, and half their difference a constant force. That force is the friction's in
//! the works of the answer.

use super::built::NamedSystem;
use super::described::samples;
use super::signals::slopes_of;
use super::why::Why;
use crate::inputs::units::System as Units;
use serde_json::json;
use std::ops::ControlFlow;
use std::path::Path;
use stickslip::Excitation;
use stickslip::motion::record::{Body, Record};
use stickslip::system::{Beyond, Record as Samples, Steady};

/// A load that repeats itself.
#[derive(Debug, Clone, Copy)]
pub enum Repeated<'a> {
    /// The force `amplitude · sin(frequency · t)` on the body.
    Sine {
        /// Its amplitude.
        amplitude: f64,
        /// Its angular frequency.
        frequency: f64,
    },
    /// A record, again and again: its last sample is at the time of the first one of the next cycle.
    Record(&'a Record<f64>),
}

/// One body as a system.
#[derive(Debug, Clone)]
pub struct OneBody {
    /// The system, whose coordinate is the body and whose contact its surface.
    pub system: NamedSystem,
    /// Half the difference of the frictions against forward and against backward motion.
    offset: f64,
}

impl OneBody {
    /// A body in a system of units, which starts with this displacement and velocity.
    ///
    /// # Errors
    /// For a record that is no such load, and a support with a damper whose motion jumps.
    pub fn new(
        body: &Body<f64>,
        units: Units,
        [start, velocity]: [f64; 2],
        load: Repeated<'_>,
    ) -> Result<Self, String> {
        let (forward, backward) = body.directional_friction();
        let offset = 0.5 * (forward - backward);
        let parts = [("stiffness", body.stiffness()), ("damping", body.damping())];
        let parts = parts.into_iter().filter(|(_, value)| *value > 0.0);
        let springs: Vec<_> =
            parts.map(|(name, value)| json!({ "between": ["ground", "body"], name: value })).collect();
        let mut forces = vec![json!({ "on": "body", "constant": body.mean_force() - offset })];
        if let Repeated::Sine { amplitude, frequency } = load {
            forces.push(json!({ "on": "body", "amplitude": amplitude, "frequency": frequency }));
        }
        let value = json!({
            "units": units.to_string(),
            "masses": { "body": { "mass": body.mass(), "start": start, "velocity": velocity } },
            "springs": springs,
            "contacts": [{
                "name": "surface",
                "between": ["ground", "body"],
                "friction": 0.5 * forward + 0.5 * backward,
                "static_ratio": body.static_friction_ratio(),
            }],
            "forces": forces,
        });
        let system = NamedSystem::new(&value, [], Path::new(""), None)?;
        let system = match load {
            Repeated::Sine { .. } => system,
            Repeated::Record(record) => under(system, body, record)?,
        };
        Ok(Self { system, offset })
    }

    /// This body, whose motions are followed as long as `keep_going` returns [`ControlFlow::Continue`].
    #[must_use]
    pub fn while_allowed(self, keep_going: fn() -> ControlFlow<()>) -> Self {
        Self { system: self.system.while_allowed(keep_going), ..self }
    }

    /// The motion that the start leads to. Its works are those of friction by direction.
    ///
    /// # Errors
    /// Those of the search.
    pub fn steady(&self) -> Result<Steady<f64>, Why> {
        let (mut found, _) = self.system.steady(&self.system.described.start)?;
        for (element, drift) in found.motion.elements.iter_mut().zip(&found.drift) {
            element.work += self.offset * drift;
            found.motion.load_work += self.offset * drift;
        }
        Ok(found)
    }
}

/// The system of a body under a record that repeats itself.
fn under(system: NamedSystem, body: &Body<f64>, record: &Record<f64>) -> Result<NamedSystem, String> {
    let NamedSystem { mut described, .. } = system;
    let repeated = samples(record, Beyond::Repeat);
    let mut push = |record: Samples<f64>, force: f64| {
        described.model.records.push(Samples { force: vec![force], ..record });
    };
    match record.excitation() {
        Excitation::SurfaceAcceleration => described.shake(repeated),
        Excitation::Force => push(repeated, 1.0),
        Excitation::FootMotion => push(repeated, body.stiffness()),
        Excitation::DampedFootMotion => {
            push(slopes_of(&repeated)?, body.damping());
            push(repeated, body.stiffness());
        }
        other => {
            return Err(format!(
                "must be a record of a force, an acceleration or a support, not of {}",
                other.name()
            ));
        }
    }
    NamedSystem::of(described)
}
