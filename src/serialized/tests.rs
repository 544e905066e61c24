use crate::motion::attractors;
use crate::motion::{FreeDecay, LongRun, State};
use crate::{Border, Cycle, Output, Ratios, Response, Verdict};
use serde_json::{Value, json, to_value};

#[test]
fn every_output_by_the_name_it_has_in_json() {
    let response = Response::new(Ratios::new(1.5f64, 2.5).unwrap());
    let map = to_value(response).unwrap();
    for output in Output::ALL {
        assert_eq!(map[output.name()], json!(output.of(&response)), "{}", output.name());
    }
    assert_eq!((&map["omega"], &map["regime"]), (&json!(1.5), &json!("non-sticking")));
    // Without a cycle its outputs are null and not omitted.
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
        LongRun::from_start(Ratios::new(omega, alpha).unwrap(), State::default()).unwrap()
    };
    let sticks = limit(0.4, 6.0);
    let map = to_value(sticks).unwrap();
    let steady = sticks.steady_state().unwrap();
    assert_eq!(map["periodic"]["stick_fraction"], json!(steady.stick_fraction));
    assert_eq!(map["periodic"]["sticks_per_cycle"], json!(2));
    assert_eq!(to_value(limit(0.7, 0.5)).unwrap()["rest"]["position"], json!(0.0));
    assert!(to_value(limit(1.0, 2.0)).unwrap()["unbounded"]["growth"].as_f64().unwrap() > 0.0);
}

#[test]
fn decay_and_place() {
    let decay = FreeDecay::new(12.0f64, 6.0, 0.0, 1.0).unwrap();
    let map = to_value(decay).unwrap();
    assert_eq!(map["half_cycles"], json!(8));
    assert_eq!(map["rest_position"], json!(decay.rest_position));
    let creep = FreeDecay::new(12.0f64, 6.0, 2.0, 1.0).unwrap();
    assert_eq!(to_value(creep).unwrap()["rest_time"], Value::Null);
    assert_eq!(to_value(Verdict::new(Ratios::new(0.4f64, 7.0).unwrap())).unwrap(), json!("non-sticking"));
}

#[test]
fn limits_of_several_starts() {
    let ratios = Ratios::new(0.5f64, 4.0).unwrap().with_damping_ratio(0.02).unwrap();
    let ratios = ratios.with_static_friction_ratio(1.3).unwrap();
    let starts = [State::default(), State::new(0.0, -3.0, 1.0).unwrap()];
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
    assert_eq!((&map["regime"], &map["bits"]), (&json!("non-sticking"), &json!(found.bits)));
    let motion = crate::enclosed::steady(&omega, &alpha, &zeta, &eta, 64).unwrap().unwrap();
    let map = to_value(&motion).unwrap();
    assert_eq!((&map["symmetric"], &map["sticks_per_cycle"]), (&json!(true), &json!(0)));
}
