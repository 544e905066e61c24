//! Results with private fields as maps, by the names that the command's JSON has. Results with public fields derive it.

use crate::exact::SteadyState;
use crate::float::Float;
use crate::nonsticking::{Border, Cycle};
use crate::output::Output;
use crate::response::Response;
use serde::ser::{Serialize, SerializeMap, Serializer};

/// The ratios, the regime, and every [`Output`]; null where it does not exist.
impl<F: Float + Serialize> Serialize for Response<F> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let ratios = self.ratios();
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("omega", &ratios.omega())?;
        map.serialize_entry("alpha", &ratios.alpha())?;
        map.serialize_entry("damping_ratio", &ratios.damping_ratio())?;
        map.serialize_entry("static_friction_ratio", &ratios.static_friction_ratio())?;
        map.serialize_entry("regime", self.regime().name())?;
        for output in Output::ALL {
            map.serialize_entry(output.name(), &output.of(self))?;
        }
        map.end()
    }
}

/// The ratios, and every [`Output`] of the cycle.
impl<F: Float + Serialize> Serialize for Cycle<F> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let ratios = self.ratios();
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("omega", &ratios.omega())?;
        map.serialize_entry("alpha", &ratios.alpha())?;
        map.serialize_entry("damping_ratio", &ratios.damping_ratio())?;
        for output in Output::ALL {
            if let Some(value) = output.of_cycle(self) {
                map.serialize_entry(output.name(), &value)?;
            }
        }
        map.serialize_entry("damper_work", &self.damper_work())?;
        map.end()
    }
}

impl<F: Float + Serialize> Serialize for Border<F> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry(Output::MinForceRatio.name(), &self.min_force_ratio())?;
        map.serialize_entry(Output::TurningPointForceRatio.name(), &self.turning_point())?;
        map.serialize_entry(Output::LeastDisplacement.name(), &self.least_displacement())?;
        map.serialize_entry(Output::TouchingPhase.name(), &self.phase())?;
        map.end()
    }
}

/// Every one of [`SteadyState::OUTPUTS`], the counts of a cycle, and the multipliers as pairs of a real and an imaginary part.
impl<F: Float + Serialize> Serialize for SteadyState<F> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("turns_per_cycle", &self.turns_per_cycle())?;
        map.serialize_entry("sticks_per_cycle", &self.sticks_per_cycle())?;
        map.serialize_entry("velocity_zeros_per_cycle", &self.velocity_zeros_per_cycle())?;
        map.serialize_entry("symmetric", &self.is_symmetric())?;
        map.serialize_entry("stable", &self.is_stable())?;
        map.serialize_entry("multipliers", &self.multipliers())?;
        for (name, output) in Self::OUTPUTS {
            map.serialize_entry(name, &output(self))?;
        }
        map.serialize_entry("periods", &self.periods())?;
        map.serialize_entry("state", &self.state())?;
        map.end()
    }
}

#[cfg(test)]
mod tests {
    use crate::exact::{LongRun, State};
    use crate::{Border, Cycle, Output, Ratios, Response};
    use serde_json::{Value, json, to_value};

    #[test]
    fn every_output_by_the_name_it_has_in_json() {
        let response = Response::new(Ratios::new(1.5f64, 2.5).unwrap());
        let map = to_value(response).unwrap();
        for output in Output::ALL {
            assert_eq!(map[output.name()], json!(output.of(&response)), "{}", output.name());
        }
        assert_eq!((&map["omega"], &map["regime"]), (&json!(1.5), &json!("non-sticking")));
        // Where there is no cycle its outputs are null, and not left out.
        let sticks = to_value(Response::new(Ratios::new(0.4f64, 2.0).unwrap())).unwrap();
        assert_eq!(sticks["max_velocity"], Value::Null);
        assert!(sticks.as_object().unwrap().contains_key("max_velocity"));
        let cycle = to_value(Cycle::new(Ratios::new(1.5f64, 2.5).unwrap()).unwrap()).unwrap();
        assert_eq!(cycle["max_displacement"], map["max_displacement"]);
        assert!(cycle.get("margin").is_none());
        let border = to_value(Border::new(1.5f64).unwrap()).unwrap();
        assert_eq!(border["border_phase"], map["border_phase"]);
    }

    #[test]
    fn each_kind_of_long_run() {
        let limit = |omega: f64, alpha| {
            LongRun::from_start(Ratios::new(omega, alpha).unwrap(), State::rest()).unwrap()
        };
        let sticks = limit(0.4, 6.0);
        let map = to_value(sticks).unwrap();
        let steady = sticks.steady_state().unwrap();
        assert_eq!(map["periodic"]["stick_fraction"], json!(steady.stick_fraction()));
        assert_eq!(map["periodic"]["sticks_per_cycle"], json!(2));
        assert_eq!(to_value(limit(0.7, 0.5)).unwrap()["rest"]["position"], json!(0.0));
        assert!(to_value(limit(1.0, 2.0)).unwrap()["unbounded"]["growth"].as_f64().unwrap() > 0.0);
    }
}
