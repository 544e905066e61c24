//! One body as a system: on its spring, damper and surface, under a load that repeats itself.
//!
//! The friction of a system is the mean of both directions, and half their difference a constant force. That force is the friction's in
//! the works of the answer.

use super::built::NamedSystem;
use super::described::{Described, samples};
use super::node::Number;
use super::signals::slopes_of;
use super::why::Why;
use crate::inputs::units::{InputError, System as Units};
use crate::inputs::{Driven, Given, Input};
use crate::text::Folder;
use serde_json::json;
use std::ops::ControlFlow;
use std::path::Path;
use stickslip::Excitation;
use stickslip::motion::record::{Body, Record};
use stickslip::system::{Beyond, Error, Harmonic, Kind, Law, Motion, Record as Samples, State, Steady};

/// A load that repeats itself.
#[derive(Debug, Clone, Copy)]
pub enum Repeated<'a, F = f64> {
    /// The force `amplitude · sin(frequency · t + phase)` on the body.
    Sine {
        /// Its amplitude.
        amplitude: F,
        /// Its angular frequency.
        frequency: F,
        /// Its phase at the start.
        phase: F,
    },
    /// A record, again and again: its last sample is at the time of the first one of the next cycle.
    Record(&'a Record<F>),
}

/// One body as a system.
#[derive(Debug, Clone)]
pub struct OneBody<F = f64> {
    /// The system, whose coordinate is the body and whose contact its surface.
    pub system: NamedSystem<F>,
    /// The constant force on the body.
    pub mean_force: F,
    /// Half the difference of the frictions against forward and against backward motion.
    pub offset: F,
}

impl<F: Number> OneBody<F> {
    /// A body in a system of units, which starts with this displacement and velocity.
    ///
    /// # Errors
    /// For a record that is no such load, and a support with a damper whose motion jumps.
    pub fn new(
        body: &Body<F>,
        units: Units,
        [start, velocity]: [F; 2],
        load: Repeated<'_, F>,
    ) -> Result<Self, String> {
        let (forward, backward) = body.directional_friction();
        let half = F::ratio(1, 2);
        let offset = half * (forward - backward);
        // The names and the units are those of a file, the numbers those of the body.
        let value = json!({
            "units": units.to_string(),
            "masses": { "body": 1 },
            "contacts": [{ "name": "surface", "between": ["ground", "body"], "friction": 1 }],
        });
        let NamedSystem { mut described, .. } =
            NamedSystem::<F>::read(&value, [], &Folder::new(Path::new("")), None)?;
        let one = |x: F| vec![vec![x]];
        let model = &mut described.model;
        (model.mass, model.damping, model.stiffness) =
            (one(body.mass()), one(body.damping()), one(body.stiffness()));
        model.constant = vec![body.mean_force() - offset];
        for element in &mut model.elements {
            let law = Law::constant(half * forward + half * backward);
            element.kind = Kind::Contact { law, peak: body.static_friction_ratio(), normal: None };
        }
        if let Repeated::Sine { amplitude, frequency, phase } = load {
            let (sin, cos) = phase.sin_cos();
            let harmonic = Harmonic { frequency, sin: vec![amplitude * cos], cos: vec![amplitude * sin] };
            model.harmonics.push(harmonic);
        }
        described.inertia = vec![F::int(0) - body.mass()];
        described.start.displacement = vec![start];
        described.start.velocity = vec![velocity];
        let system = match load {
            Repeated::Sine { .. } => NamedSystem::of(described)?,
            Repeated::Record(record) => {
                under(&mut described, body, record)?;
                NamedSystem::of(described)?
            }
        };
        Ok(Self { system, mean_force: body.mean_force(), offset })
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
    pub fn steady(&self) -> Result<Steady<F>, Error> {
        let mut found = self.system.system.steady(&self.system.described.start)?;
        for (element, &drift) in found.motion.elements.iter_mut().zip(&found.drift) {
            element.work = element.work + self.offset * drift;
            found.motion.load_work = found.motion.load_work + self.offset * drift;
        }
        Ok(found)
    }
}

impl OneBody {
    /// A body without a spring that a constant force, or friction by direction, moves on ([`Given::drifts`]), at a phase of its drive at the start, and the
    /// machine whose friction is the mean of both directions.
    ///
    /// # Errors
    /// Where an input of the machine is missing or wrong.
    pub fn drifting(
        given: &Given<f64>,
        start: [f64; 2],
        phase: f64,
    ) -> Result<(Self, Driven<f64>), InputError> {
        let friction = given.friction()?.unwrap_or(0.0);
        let backward = given.get(Input::FrictionBackward).unwrap_or(friction);
        let mut symmetric = given.clone();
        symmetric.take(Input::MeanForce);
        symmetric.replace_friction(0.5 * friction + 0.5 * backward);
        let machine = symmetric.driven()?;
        let both = machine.oscillator.with_directional_friction(friction, backward);
        both.map_err(|e| given.at_fault(&e))?;
        let drive = &machine.drive;
        let load = Repeated::Sine {
            amplitude: drive.force_amplitude(&machine.oscillator),
            frequency: drive.angular_frequency(),
            phase,
        };
        Ok((Self::new(&given.body(None)?, given.system, start, load).map_err(InputError)?, machine))
    }

    /// The motion from the start until a time. Its works are those of [`OneBody::system`].
    ///
    /// # Errors
    /// As [`System::simulate`](stickslip::system::System::simulate).
    pub fn simulate(&self, until: f64) -> Result<Motion<f64>, Why> {
        Ok(self.system.simulate(&self.system.described.start, until)?.0)
    }

    /// The states at times that increase, from a start. The force of the surface is that of its direction.
    ///
    /// # Errors
    /// As [`System::states`](stickslip::system::System::states).
    pub fn states(&self, start: &State<f64>, times: &[f64]) -> Result<Vec<State<f64>>, Why> {
        let mut states = self.system.states(start, times)?;
        for force in states.iter_mut().flat_map(|state| &mut state.force) {
            *force += self.offset;
        }
        Ok(states)
    }
}

/// A body under a record that repeats itself.
fn under<F: Number>(described: &mut Described<F>, body: &Body<F>, record: &Record<F>) -> Result<(), String> {
    let repeated = samples(record, Beyond::Repeat);
    let mut push = |record: Samples<F>, force: F| {
        described.model.records.push(Samples { force: vec![force], ..record });
    };
    match record.excitation() {
        Excitation::SurfaceAcceleration => described.shake(repeated),
        Excitation::Force => push(repeated, F::int(1)),
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
    Ok(())
}
