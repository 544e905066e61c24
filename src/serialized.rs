//! Results with private fields as maps, by the names that the command's JSON has. Results with public fields
//! derive it.

#[cfg(feature = "mp")]
use crate::enclosed::{self, Enclosure};
use crate::exact::{FreeDecay, SteadyState};
use crate::float::Float;
use crate::nonsticking::{Border, Cycle};
use crate::output::Output;
use crate::regime::Place;
use crate::response::Response;
#[cfg(feature = "dual")]
use crate::sensitivity::{Sensitivities, Sensitivity};
#[cfg(feature = "random")]
use crate::uncertainty::random::MonteCarlo;
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

/// Every one of [`SteadyState::OUTPUTS`], the counts of a cycle, and the multipliers as pairs of a real and
/// an imaginary part.
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

/// A creep never comes to rest: its `rest_time` is null.
impl<F: Float + Serialize> Serialize for FreeDecay<F> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("half_cycles", &self.half_cycles())?;
        map.serialize_entry("first_turn", &self.first_turn())?;
        map.serialize_entry("rest_position", &self.rest_position())?;
        map.serialize_entry("rest_time", &Some(self.rest_time()).filter(|time| time.is_finite()))?;
        map.end()
    }
}

/// The ratios, the verdict, the margin and the border.
impl<F: Float + Serialize> Serialize for Place<F> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("ratios", &self.ratios())?;
        map.serialize_entry("verdict", &self.verdict())?;
        map.serialize_entry(Output::Margin.name(), &self.margin())?;
        map.serialize_entry("border", self.border())?;
        map.end()
    }
}

/// The value, and its derivatives in the order of the parameters.
#[cfg(feature = "dual")]
impl<const N: usize> Serialize for Sensitivity<N> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(2))?;
        map.serialize_entry("value", &self.value)?;
        map.serialize_entry("by", self.by.as_slice())?;
        map.end()
    }
}

/// The regime, and every output that exists with its derivatives.
#[cfg(feature = "dual")]
impl<const N: usize> Serialize for Sensitivities<N> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("regime", &self.regime())?;
        for (output, found) in self.iter() {
            map.serialize_entry(output.name(), &found)?;
        }
        map.end()
    }
}

/// How many draws there were, how many of them in each regime, and the values of each output that was kept.
#[cfg(feature = "random")]
impl Serialize for MonteCarlo {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("draws", &self.draws())?;
        map.serialize_entry("invalid", &self.invalid())?;
        for (regime, count) in self.regimes() {
            map.serialize_entry(regime.name(), count)?;
        }
        for output in Output::ALL {
            let values = self.values(output);
            if !values.is_empty() {
                map.serialize_entry(output.name(), values)?;
            }
        }
        map.end()
    }
}

/// Midpoint and radius in decimal, with two digits more than are certain.
#[cfg(feature = "mp")]
impl Serialize for Enclosure {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let (mid, rad) = self.decimal();
        let mut map = serializer.serialize_map(Some(2))?;
        map.serialize_entry("mid", &mid)?;
        map.serialize_entry("rad", &rad)?;
        map.end()
    }
}

#[cfg(feature = "mp")]
impl Serialize for enclosed::Regime {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

/// The regime, every [`Output`], and the bits; null where it does not exist or is not certain.
#[cfg(feature = "mp")]
impl Serialize for enclosed::Response {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("regime", &self.regime())?;
        for output in Output::ALL {
            map.serialize_entry(output.name(), &self.get(output))?;
        }
        map.serialize_entry("bits", &self.bits())?;
        map.end()
    }
}

#[cfg(test)]
mod tests {
    use crate::exact::{FreeDecay, LongRun, State, attractors};
    use crate::{Border, Cycle, Output, Place, Ratios, Response};
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

    #[test]
    fn decay_and_place() {
        let decay = FreeDecay::new(12.0f64, 6.0, 0.0, 1.0).unwrap();
        let map = to_value(decay).unwrap();
        assert_eq!(map["half_cycles"], json!(8));
        assert_eq!(map["rest_position"], json!(decay.rest_position()));
        let creep = FreeDecay::new(12.0f64, 6.0, 2.0, 1.0).unwrap();
        assert_eq!(to_value(creep).unwrap()["rest_time"], Value::Null);
        let place = Place::new(Ratios::new(0.4f64, 7.0).unwrap());
        let map = to_value(place).unwrap();
        assert_eq!((&map["verdict"], &map["margin"]), (&json!("non-sticking"), &json!(place.margin())));
    }

    #[test]
    fn limits_of_several_starts() {
        let ratios = Ratios::new(0.5f64, 4.0).unwrap().with_damping_ratio(0.02).unwrap();
        let ratios = ratios.with_static_friction_ratio(1.3).unwrap();
        let starts = [State::rest(), State::new(0.0, -3.0, 1.0).unwrap()];
        let map = to_value(attractors(ratios, &starts, 1000).unwrap()).unwrap();
        assert_eq!(map["limits"].as_array().unwrap().len(), 2);
        assert_eq!((&map["limits"][0]["mirror"], &map["of_start"]), (&json!(1), &json!([0, 1])));
        assert!(map["limits"][1]["limit"]["periodic"]["max_displacement"].is_number());
    }

    #[cfg(feature = "dual")]
    #[test]
    fn sensitivities() {
        let found = crate::sensitivity::Sensitivities::by_ratios(Ratios::new(1.5, 2.5).unwrap());
        let (map, stroke) = (to_value(&found).unwrap(), found.of(Output::MaxDisplacement).unwrap());
        assert_eq!(map["max_displacement"]["by"], json!(stroke.by));
        assert_eq!(
            (&map["max_displacement"]["value"], &map["regime"]),
            (&json!(stroke.value), &json!("non-sticking"))
        );
    }

    #[cfg(feature = "mp")]
    #[test]
    fn enclosures() {
        let [omega, alpha, zeta, eta] = ["1.5", "2.5", "0", "1"].map(|text| text.parse().unwrap());
        let found = crate::enclosed::response(&omega, &alpha, &zeta, &eta, 64).unwrap();
        let map = to_value(&found).unwrap();
        let (mid, rad) = found.get(Output::MaxDisplacement).unwrap().decimal();
        assert_eq!(map["max_displacement"], json!({ "mid": mid, "rad": rad }));
        assert_eq!((&map["regime"], &map["bits"]), (&json!("non-sticking"), &json!(found.bits())));
        let motion = crate::enclosed::steady(&omega, &alpha, &zeta, &eta, 64).unwrap().unwrap();
        let map = to_value(&motion).unwrap();
        assert_eq!((&map["symmetric"], &map["sticks_per_cycle"]), (&json!(true), &json!(0)));
    }
}
