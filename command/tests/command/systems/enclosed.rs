//! `system … simulate --enclose`: the digits of mpmath and closed forms inside, and what is declined by name.

use crate::command_line::{json, refused, stdout};
use crate::compared::Origin::{AnotherProgram, ByHand};
use crate::compared::recorded;
use crate::place::place;
use serde_json::Value;
use stickslip::Float;
use stickslip::float::{Field, Mp};

const CASES: &str = include_str!("../../../../tests/data/system_digits.json");

type Wide = Mp<8>;

fn number(digits: &str) -> Wide {
    digits.parse().unwrap()
}

/// Fails where a number of which only some digits are known is not in an enclosure, or where that is wide.
fn holds(name: &str, found: &Value, due: Wide, rounding: f64, size: f64) {
    let [mid, rad] = ["mid", "rad"].map(|part| number(found[part].as_str().unwrap()));
    let off = Field::abs(mid - due).to_f64();
    let rad = rad.to_f64();
    assert!(off <= rad + rounding, "{name}: {found} {due}");
    assert!(rad <= 1e-37 * size, "{name}: {found} is wider than its bits");
}

/// Every number of mpmath that this command encloses, at 128 bits, where mpmath has 48 digits.
#[test]
fn the_digits_of_another_program_lie_inside() {
    let cases: Value = serde_json::from_str(CASES).unwrap();
    let folder = place("enclosed-digits");
    std::fs::create_dir(&*folder).unwrap();
    let mut count = 0;
    for (name, case) in cases.as_object().unwrap() {
        let text = case["file"].as_str().unwrap();
        // One has a stop with a restitution, two other questions.
        let Some(until) = case["until"].as_str().filter(|_| !text.contains("restitution")) else { continue };
        let file = folder.join(if text.starts_with('{') { "machine.json" } else { "machine.toml" });
        std::fs::write(&file, text).unwrap();
        let question = format!("system {} simulate --until {until} --enclose --bits 128", file.display());
        let found = json(&format!("{question} --format json"));
        for what in ["displacement", "velocity"] {
            let due: Vec<Wide> =
                case[what].as_array().unwrap().iter().map(|x| number(x.as_str().unwrap())).collect();
            let size = due.iter().map(|x| x.to_f64().abs()).fold(0.0, f64::max);
            for (found, due) in found["end"][what].as_array().unwrap().iter().zip(due) {
                holds(&format!("{name}: {what}"), found, due, 1e-44 * size, size);
                recorded("--enclose system", found, &due, AnotherProgram, 0.0);
                recorded("fn system::System::enclosed", found, &due, AnotherProgram, 0.0);
            }
        }
        let (events, due) = (found["events"].as_array().unwrap(), case["events"].as_array().unwrap());
        assert_eq!(events.len(), due.len(), "{name}");
        for (event, due) in events.iter().zip(due) {
            assert_eq!((&event["element"], &event["kind"]), (&due[1], &due[2]), "{name}");
            let due = number(due[0].as_str().unwrap());
            holds(&format!("{name}: events"), &event["time"], due, 1e-43, due.to_f64());
            recorded("--enclose system", event, &due, AnotherProgram, 0.0);
        }
        count += 1;
    }
    assert_eq!(count, 4);
}

/// A mass of 1 with the friction 1 on a spring of 1 from 4.5: it turns after π at −2.5 and comes to rest after 2π at 0.5.
#[test]
fn a_free_vibration_ends_where_the_closed_form_has_it() {
    let folder = place("enclosed-by-hand");
    std::fs::create_dir(&*folder).unwrap();
    let file = folder.join("free.json");
    let text = r#"{"mass":[[1]],"stiffness":[[1]],"elements":[{"type":"contact","name":"floor","direction":[1],"friction":1}],"start":{"displacement":[4.5]}}"#;
    std::fs::write(&file, text).unwrap();
    let question = format!("system {} simulate --until 10 --enclose --bits 128", file.display());
    let found = json(&format!("{question} --format json"));
    let pi = <Wide as stickslip::float::Real>::pi();
    let tenths = |x: f64| Wide::from(x * 10.0) / Wide::from(10.0);
    for (place, due, size) in [
        ("/events/0/time", pi, 3.0),
        ("/events/1/time", pi * tenths(2.0), 6.0),
        ("/end/displacement/0", tenths(0.5), 4.5),
        ("/end/velocity/0", tenths(0.0), 3.5),
        ("/max_displacement/0", tenths(4.5), 4.5),
        ("/min_displacement/0", tenths(-2.5), 4.5),
        // The first half swing is about 1 with the amplitude 3.5, the second about −1 with 1.5.
        ("/min_velocity/0", tenths(-3.5), 3.5),
        ("/max_velocity/0", tenths(1.5), 3.5),
        ("/elements/0/work", tenths(10.0), 10.0),
        ("/elements/0/time_at_rest", tenths(10.0) - pi * tenths(2.0), 4.0),
        ("/load_work", tenths(0.0), 1.0),
        ("/damper_work", tenths(0.0), 1.0),
        ("/stored_energy", tenths(-10.0), 10.0),
        ("/duration", tenths(10.0), 10.0),
        ("/start/displacement/0", tenths(4.5), 4.5),
    ] {
        let found = found.pointer(place).unwrap_or_else(|| panic!("{place}: {found}"));
        holds(place, found, due, 1e-140, size);
        recorded("--enclose system", found, &due, ByHand, 0.0);
    }
    assert_eq!(found["elements"][0]["stops"], 1);
    let text = stdout(&question);
    assert!(text.starts_with("Proved: the motion from the start to 10 has 2 events.\n\n"), "{text}");
    assert!(
        text.contains("  6.28318530717958647692528676655900576") && text.contains("  floor: stick\n"),
        "{text}"
    );
    assert!(
        text.ends_with(
            "\nEach value lies within ± of the number printed, for the numbers of the file as typed.\n"
        ),
        "{text}"
    );
}

const BODY: &str = r#""mass":[[1]],"stiffness":[[1]],"damping":[[0.1]]"#;

/// What is not enclosed has its name, as has what no precision decides.
#[test]
fn what_is_not_enclosed_is_declined_by_name() {
    let folder = place("enclosed-refused");
    std::fs::create_dir(&*folder).unwrap();
    let file = folder.join("machine.json");
    let declined = |text: &str, due: &str| {
        std::fs::write(&file, text).unwrap();
        refused(&format!("system {} simulate --until 9 --enclose", file.display()), &[due]);
    };
    let contact = r#"{"type":"contact","name":"c","direction":[1],"friction":0.3"#;
    for (element, due) in [
        (
            r#"{"type":"stop","name":"s","direction":[1],"gap":1,"restitution":0.5}"#,
            "s is a stop with a restitution",
        ),
        (
            r#"{"type":"spring","name":"s","direction":[1],"law":[[0,0],[1,1],[2,3]]}"#,
            "s is a spring with a law",
        ),
        (
            r#"{"type":"elastic","name":"e","direction":[1],"stiffness":3,"friction":1,"normal":{"const":1,"displacement":[0.1]}}"#,
            "e is an elastic contact under a normal load that varies",
        ),
        (
            &format!("{contact}}},{{\"type\":\"contact\",\"name\":\"d\",\"direction\":[1],\"friction\":1}}"),
            "contacts must have independent directions",
        ),
        // No precision tells the side of a force that is at its bound.
        (
            &format!("{contact}}}"),
            "c at time 0: whether it sticks or slides is not certain: its force is at its bound, even at 576 bits",
        ),
    ] {
        declined(&format!(r#"{{{BODY},"elements":[{element}],"constant":[0.3]}}"#), due);
    }
    let record = r#""record":{"times":[0,1],"values":[0,1],"force":[1]}"#;
    declined(
        &format!(r#"{{{BODY},"elements":[{contact}}}],{record}}}"#),
        "record must be left out of a motion that is enclosed",
    );
    // Two equal halves come to rest at one instant.
    let twins = r#"{"mass":[[1,0],[0,1]],"stiffness":[[1,0],[0,1]],"elements":[{"type":"contact","name":"left","direction":[1,0],"friction":0.3},{"type":"contact","name":"right","direction":[0,1],"friction":0.3}],"start":{"displacement":[2,2]}}"#;
    declined(
        twins,
        "right at time 3.141592653589793: its event and one of another contact are at the same instant, even at 576 bits",
    );
    let joint = "units=\"N,m\"\nmasses={joint=0,a=\"1 kg\"}\n[[springs]]\nbetween=[\"ground\",\"joint\"]\nstiffness=3\n[[springs]]\nbetween=[\"joint\",\"a\"]\nstiffness=3\n";
    let toml = folder.join("machine.toml");
    let moved = "units=\"N,m\"\nmasses={cart={moves={displacement={amplitude=1,frequency=1}}},a=\"1 kg\"}\n[[springs]]\nbetween=[\"cart\",\"a\"]\nstiffness=3\n";
    let level = "units=\"N,m\"\nmasses={a=\"1 kg\"}\n[[springs]]\nbetween=[\"ground\",\"a\"]\nstiffness=3\n[[levels]]\non=\"a\"\ndisplacement=1\n";
    for (text, due) in [
        (joint, "mass must be > 0 at each body of a motion that is enclosed"),
        (moved, "moves of a body must be left out of a motion that is enclosed"),
        (level, "levels must be left out of a motion that is enclosed"),
    ] {
        std::fs::write(&toml, text).unwrap();
        refused(&format!("system {} simulate --until 9 --enclose", toml.display()), &[due]);
    }
    std::fs::write(&file, format!("{{{BODY}}}")).unwrap();
    for (rest, due) in [
        ("steady --enclose", "--enclose: this question does not use it"),
        ("simulate --until 1 --enclose --samples 3", "--samples: must be left out beside --enclose"),
        ("simulate --until 1 --enclose --picture a.svg", "--picture: must be left out beside --enclose"),
        ("simulate --until q1=1 --enclose", "--until q1=1: must be a time beside --enclose"),
        ("simulate --until 1 --enclose --bits 1501", "--bits 1501: must be ≤ 1500 beside --enclose"),
        (
            "simulate --until 1 --enclose --set constant[1]=1:2:2",
            "--set: must not be a grid beside --enclose",
        ),
        ("simulate --enclose", "--until is missing"),
    ] {
        refused(&format!("system {} {rest}", file.display()), &[due]);
    }
}
