//! A body without a spring that a constant force moves on: its steady motion with its drift, and samples of a cycle or from the start.

use crate::answer::{kinds, of_machine};
use crate::asked::Asked;
use crate::motion::{FIRST_TURNS, MOST_TURNS, support};
use serde_json::{Value, json};
use std::f64::consts::TAU;
use stickslip::system::{State, SteadyKind};
use stickslip_front::inputs::units::Kind;
use stickslip_front::inputs::{Driven, Given};
use stickslip_front::system::{Answer, OneBody, steady_verdict};
use stickslip_front::words;

/// A body that drifts.
pub(crate) struct Drifting {
    given: Given<f64>,
    one: OneBody,
    machine: Driven<f64>,
    has_start: bool,
}

impl Drifting {
    /// The body of the question, if it drifts.
    pub(crate) fn asked(asked: &Asked<'_>) -> Result<Option<Self>, String> {
        let reader = asked.reader()?;
        let given = asked.given(&reader)?;
        if given.drifts().is_none() {
            return Ok(None);
        }
        let (start, has_start) = asked.start(&reader, true)?;
        let (one, machine) = OneBody::drifting(&given, start, 0.0)?;
        Ok(Some(Self { given, one, machine, has_start }))
    }

    /// The answer of `stickslip steady`.
    pub(crate) fn answer(&self) -> Result<Value, String> {
        let described = &self.one.system.described;
        let found = self.one.steady().map_err(|e| e.to_string())?;
        let base = words::base_motion_sentence(self.machine.drive.excitation());
        Ok(json!({
            "drift": serde_json::to_value(Answer::steady(described, &found)).map_err(|e| e.to_string())?,
            "verdict": steady_verdict(described, &found),
            "notes": base.into_iter().collect::<Vec<_>>(),
            "has_start": self.has_start,
            "is_without_spring": true,
            "kinds": kinds(&self.given, &self.machine, true),
            "machine": of_machine(&self.given, &self.machine),
        }))
    }

    /// Samples of the motion, `per_turn` in a turn of the drive: of its cycle, or from its start.
    pub(crate) fn samples(&self, is_from_start: bool, per_turn: u32) -> Result<Value, String> {
        let found = (!is_from_start).then(|| self.one.steady()).transpose().map_err(|e| e.to_string())?;
        let cycle = found.as_ref().filter(|found| found.kind == SteadyKind::Periodic);
        let (start, turns) = cycle.map_or((&self.one.system.described.start, FIRST_TURNS), |found| {
            (&found.start, u32::try_from(found.periods).unwrap_or(MOST_TURNS).min(MOST_TURNS))
        });
        let Driven { oscillator: body, drive, .. } = &self.machine;
        let period = TAU / drive.angular_frequency();
        let turn = |place: u32| f64::from(place % per_turn) / f64::from(per_turn);
        let places = 0..=per_turn * turns;
        let times: Vec<f64> =
            places.clone().map(|place| (f64::from(place / per_turn) + turn(place)) * period).collect();
        let states = self.one.states(start, &times).map_err(|e| e.to_string())?;
        let column = |of: fn(&State<f64>) -> &[f64]| -> Vec<f64> {
            states.iter().map(|state| of(state).first().copied().unwrap_or(f64::NAN)).collect()
        };
        let unit = |kind: Kind| self.given.system.name(kind);
        let velocities = column(|state| &state.velocity);
        let loads = places.map(|place| drive.force_amplitude(body) * (TAU * turn(place)).sin());
        Ok(json!({
            "time": times,
            "displacement": column(|state| &state.displacement),
            "rest": velocities.iter().map(|v| *v == 0.0).collect::<Vec<_>>(),
            "velocity": velocities,
            "friction": column(|state| &state.force),
            "load": loads.collect::<Vec<_>>(),
            "turns": turns,
            "steady": cycle.is_some(),
            "support": support(&self.machine, false),
            "bound": body.static_friction_ratio() * body.friction_bound(),
            "units": {
                "time": unit(Kind::Time), "displacement": unit(Kind::Length), "velocity": unit(Kind::Velocity),
                "friction": unit(Kind::Force),
            },
        }))
    }
}
