use crate::design::{Aim, Measurement};
use crate::motion::attractors;
use crate::motion::record::{After, Body, Record};
use crate::motion::{FreeDecay, LongRun, Segment, State, Trajectory};
use crate::uncertainty::{Interval, ParameterBox, Parameters};
use crate::{
    Border, Cycle, Drive, Excitation, Oscillator, Output, Ratios, Response, Scales, Steady, Verdict,
};
use serde_json::{Value, from_value, json, to_value};

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
    let (body, drive) = (Oscillator::new(1.0, 1.0, 1.0).unwrap(), Drive::force(2.5, 1.5).unwrap());
    let found = crate::sensitivity::Sensitivities::by_parameters(&body, &drive).unwrap();
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
    let found = crate::enclosed::KnownRatios::new(&omega)
        .with_force_ratio(&alpha)
        .with_damping_ratio(&zeta)
        .with_static_friction_ratio(&eta)
        .response(64)
        .unwrap();
    let map = to_value(&found).unwrap();
    let (mid, rad) = found.get(Output::MaxDisplacement).unwrap().decimal();
    assert_eq!(map["max_displacement"], json!({ "mid": mid, "rad": rad }));
    assert_eq!((&map["regime"], &map["bits"]), (&json!("non-sticking"), &json!(found.bits)));
    let motion = crate::enclosed::KnownRatios::new(&omega)
        .with_force_ratio(&alpha)
        .with_damping_ratio(&zeta)
        .with_static_friction_ratio(&eta)
        .steady(64)
        .unwrap()
        .unwrap();
    let map = to_value(&motion).unwrap();
    assert_eq!((&map["symmetric"], &map["sticks_per_cycle"]), (&json!(true), &json!(0)));
}

fn back<T: serde::Serialize + serde::de::DeserializeOwned + PartialEq + core::fmt::Debug>(written: &T) {
    let text = serde_json::to_string(written).unwrap();
    assert_eq!(serde_json::from_str::<T>(&text).as_ref().ok(), Some(written), "{text}");
}

/// What is read back after writing has the same bits.
#[test]
fn results_are_read_as_they_were_written() {
    let at = |omega: f64, alpha, zeta, eta| {
        let ratios = Ratios::new(omega, alpha).unwrap().with_damping_ratio(zeta).unwrap();
        ratios.with_static_friction_ratio(eta).unwrap().with_excitation(Excitation::DampedFootMotion)
    };
    for (omega, alpha, zeta, eta) in [
        (1.5, 2.5, 0.0, 1.0),
        (0.4, 9.0, 0.0, 1.0),
        (0.4, 6.0, 0.03, 1.0),
        (0.5, 4.0, 0.02, 1.3),
        (0.7, 0.5, 0.0, 1.0),
        (0.5, 40.0, 0.0, 1.0),
    ] {
        let ratios = at(omega, alpha, zeta, eta);
        let response = Response::new(ratios);
        back(&response);
        let guarded = Response::guarded(ratios);
        let read: Response<f64> = serde_json::from_str(&serde_json::to_string(&guarded).unwrap()).unwrap();
        let shown = |found: Response<f64>| format!("{found:?}");
        assert_eq!(shown(read), shown(guarded));
        back(&response.border);
        response.cycle.iter().for_each(back);
        back(&Verdict::new(ratios));
        let limit = LongRun::from_start(ratios, State::default()).unwrap();
        back(&limit);
        limit.steady_state().into_iter().for_each(|steady| back(&steady.peaks().unwrap()));
        let starts = [State::default(), State::new(0.0, -3.0, 1.0).unwrap()];
        back(&attractors(ratios, &starts, 1000).unwrap());
        for start in starts {
            // Slides and stops, of a motion without end and of one that comes to rest.
            Trajectory::new(ratios, start).unwrap().take(30).for_each(|segment| back(&segment.unwrap()));
        }
        let mut motion = Trajectory::new(ratios, State::default()).unwrap().samples(7).unwrap();
        back(&motion.next().unwrap().unwrap());
    }
    // A number that was not computed here is kept, and a cycle that does not exist is refused.
    let mut map = to_value(Response::new(at(1.5, 2.5, 0.0, 1.0))).unwrap();
    map["max_displacement"] = json!(1.25);
    let read: Response<f64> = serde_json::from_value(map.clone()).unwrap();
    assert_eq!(read.cycle.unwrap().max_displacement, 1.25);
    map["alpha"] = json!(1.1);
    let said = serde_json::from_value::<Response<f64>>(map).unwrap_err().to_string();
    assert!(said.contains("α = 1.1"), "{said}");
    for (zeta, eta) in [(0.0, 1.0), (0.05, 1.2), (2.0, 1.0)] {
        back(&FreeDecay::new(12.0f64, 6.0, zeta, eta).unwrap());
    }
    let body = Oscillator::new(50.0f64, 1000.0, 5.0).unwrap().with_damping_ratio(0.02).unwrap();
    let drive = Drive::new(Excitation::SurfaceAcceleration, 0.3, 5.0).unwrap();
    back(&Scales::new(&body, &drive).unwrap());
    let steady = Steady::of(&body, &drive).unwrap();
    back(&steady);
    back(&steady.samples(5).unwrap());
    let record = Record::new(Excitation::Force, 0.5, vec![0.0, 8.0, -9.0, 0.0]).unwrap();
    let block = Body::new(2.0f64, 0.7).unwrap().with_stiffness(3.0).unwrap();
    back(&block.follow(&record).unwrap());
}

/// What is read back after writing has the same bits.
#[test]
fn inputs_are_read_as_they_were_written() {
    let ratios = Ratios::new(0.1f64 + 0.2, 2.5).unwrap().with_damping_ratio(0.02).unwrap();
    back(&ratios.with_static_friction_ratio(1.3).unwrap());
    let body = Oscillator::new(50.0f64, 1000.0, 5.0).unwrap().with_damping(1.0 / 3.0).unwrap();
    back(&body.with_directional_friction(5.1, 4.7).unwrap().with_static_friction_ratio(1.1).unwrap());
    for excitation in [Excitation::Force, Excitation::Unbalance, Excitation::SurfaceAcceleration] {
        back(&excitation);
        back(&Drive::new(excitation, 0.1f64, 0.7).unwrap().with_mean_force(-0.3).unwrap());
    }
    let mut motion = Trajectory::new(ratios, State::default()).unwrap();
    for _ in 0..20 {
        back(&motion.next().unwrap().unwrap().start());
    }
    let interval = Interval { low: 0.1f64, high: 0.3 };
    back(&ParameterBox::Ratios { omega: interval, alpha: interval, damping_ratio: interval });
    back(&ParameterBox::Machine(Parameters {
        excitation: Excitation::SurfaceMotion,
        mass: interval,
        stiffness: interval,
        friction_bound: interval,
        amplitude: interval,
        angular_frequency: interval,
        damping: interval,
    }));
    for output in Output::ALL {
        back(&output);
        assert_eq!(to_value(output).unwrap(), json!(output.name()));
    }
    let block = Body::new(2.0f64, 0.7).unwrap().with_directional_friction(0.9, 0.3).unwrap();
    back(&block.with_mean_force(0.2).unwrap().one_way());
    let samples = vec![0.0f64, 0.1, -0.2];
    back(&Record::new(Excitation::Force, 0.01, samples.clone()).unwrap().beginning_at(0.3).unwrap());
    let record = Record::at_times(Excitation::SurfaceAcceleration, vec![0.0, 0.1, 0.4], samples).unwrap();
    back(&record.followed_by(After::Hold));
    back(&Measurement { angular_frequency: 3.0, amplitude: 0.1, phase: None });
    for (aim, name) in [(Aim::Displacement, "displacement"), (Aim::TransmittedForce, "transmitted-force")] {
        back(&aim);
        assert_eq!(to_value(aim).unwrap(), json!(name));
    }
}

/// Fields that a machine need not have are left out, and a value outside its domain is an error with the inequality.
#[test]
fn inputs_obey_the_rules_of_their_constructors() {
    let plain: Oscillator<f64> =
        serde_json::from_value(json!({ "mass": 50, "stiffness": 1000, "friction_bound": 5 })).unwrap();
    assert_eq!(plain, Oscillator::new(50.0, 1000.0, 5.0).unwrap());
    let state: State<f64> = serde_json::from_value(json!({ "x": 0.5, "v": -1 })).unwrap();
    assert_eq!(state, State::new(0.0, 0.5, -1.0).unwrap());
    fn refused<T: serde::de::DeserializeOwned>(input: Value, parts: &[&str]) {
        let said =
            serde_json::from_value::<T>(input.clone()).err().map(|e| e.to_string()).unwrap_or_default();
        assert!(parts.iter().all(|part| said.contains(part)), "{input}: {said}");
    }
    refused::<Ratios<f64>>(json!({ "omega": -1, "alpha": 2 }), &["Ω = -1", "> 0"]);
    refused::<Ratios<f64>>(json!({ "omega": 1, "alpha": 2, "zeta": 0 }), &["zeta"]);
    refused::<Ratios<f64>>(json!({ "omega": 1 }), &["alpha"]);
    refused::<Oscillator<f64>>(
        json!({ "mass": 1, "stiffness": 1, "friction_bound": 1, "friction_offset": -1 }),
        &["r₊ = 0"],
    );
    refused::<Oscillator<f64>>(
        json!({ "mass": 1, "stiffness": 1, "friction_bound": 1, "friction_offset": 2 }),
        &["r₋ = -1"],
    );
    refused::<Drive<f64>>(
        json!({ "excitation": "force", "amplitude": 0, "angular_frequency": 1 }),
        &["p₀ = 0"],
    );
    refused::<Drive<f64>>(json!({ "excitation": "push", "amplitude": 1, "angular_frequency": 1 }), &["push"]);
    refused::<State<f64>>(json!({ "phase": { "angle": 2 }, "x": 0, "v": 0 }), &["= 2", "1.57"]);
    refused::<State<f64>>(
        json!({ "phase": { "half_turns": i64::MAX, "angle": 0 }, "x": 0, "v": 0 }),
        &["cycles"],
    );
    refused::<Output>(json!("max_speed"), &["max_speed"]);
    refused::<Body<f64>>(json!({ "mass": 1, "friction": 1, "friction_offset": 2 }), &["r₋ = -1"]);
    refused::<Record<f64>>(json!({ "excitation": "force", "samples": [0, 1] }), &["a step or times"]);
    refused::<Record<f64>>(
        json!({ "excitation": "force", "step": 1, "times": [0, 1], "samples": [0, 1] }),
        &["a step or times"],
    );
    refused::<Record<f64>>(json!({ "excitation": "force", "times": [1, 1], "samples": [0, 1] }), &["> 0"]);
    refused::<Record<f64>>(
        json!({ "excitation": "force", "start": 5, "times": [0, 1], "samples": [0, 1] }),
        &["start must be left out beside times"],
    );
    assert_eq!(
        to_value(Ratios::new(0.7, f64::NAN).unwrap_err()).unwrap(),
        json!("force ratio α = NaN must be finite")
    );
}

/// A segment has its ends and its kind, is exact at each instant when it is read back, and one whose ends are not those of its kind is refused.
#[test]
fn segments() {
    let motion = Trajectory::new(Ratios::new(0.4, 6.0).unwrap(), State::default()).unwrap();
    let segments: Vec<_> = motion.take(2).collect::<Result<_, _>>().unwrap();
    let written = to_value(segments[1]).unwrap();
    assert_eq!((&written["kind"], &written["ends_by"]), (&json!("slide-forward"), &json!("reversal")));
    assert_eq!(from_value::<State<f64>>(written["start"].clone()).unwrap(), segments[1].start());
    assert_eq!(from_value::<Option<State<f64>>>(written["end"].clone()).unwrap(), segments[1].end());
    assert_eq!(written["duration"].as_f64(), segments[1].duration());
    let read: Segment<f64> = from_value(written.clone()).unwrap();
    let middle = segments[1].start().phase.advanced(0.5 * segments[1].duration().unwrap());
    assert_eq!(read.at(middle), segments[1].at(middle));
    for (field, value, due) in [
        ("kind", json!("stick"), "fields of its kind"),
        ("end", Value::Null, "needs the ends"),
        ("start", json!({ "x": f64::MAX, "v": 0 }), "≤"),
    ] {
        let mut other = written.clone();
        other[field] = value;
        let said = from_value::<Segment<f64>>(other).unwrap_err().to_string();
        assert!(said.contains(due), "{field}: {said}");
    }
}

/// A model is read back, and what it leaves out is as by default.
#[cfg(feature = "system")]
#[test]
fn models() {
    use crate::system::{Element, Model, System};
    let model = System::builder()
        .mass("a", 2.0)
        .mass("b", 1.0)
        .spring("ground", "a", 7.0)
        .between("ground", "a", Element::contact([], 0.5).with_peak(1.5).on_belt(0.1))
        .between("a", "b", Element::elastic([], 3.0, 1.0))
        .between("b", "ground", Element::stop([], 0.1, 50.0))
        .wave("a", 1.0, 2.0)
        .record("b", vec![0.0, 1.0], vec![1.0, 0.0])
        .travels("b", 0.5)
        .model()
        .unwrap();
    assert_eq!(from_value::<Model<f64>>(to_value(&model).unwrap()).unwrap(), model);
    let short = json!({ "mass": [[1.0]], "stiffness": [[2.0]], "damping": [[0.0]] });
    let due = Model {
        mass: vec![vec![1.0]],
        stiffness: vec![vec![2.0]],
        damping: vec![vec![0.0]],
        ..Model::default()
    };
    assert_eq!(from_value::<Model<f64>>(short).unwrap(), due);
}
