//! Joints without mass, pulled ends of springs, and what is refused about names and motions, from files.

use super::numbers;
use crate::command_line::{json, refused, said, stickslip};
use crate::compared::{Origin::ByHand, compared};
use crate::place::{Place, place};

fn file(place: &Place, name: &str, text: &str) -> String {
    let path = place.join(name);
    std::fs::write(&path, text).unwrap();
    path.display().to_string()
}

fn folder(name: &str) -> Place {
    let folder = place(name);
    std::fs::create_dir(&*folder).unwrap();
    folder
}

/// Two sliders with springs behind each other, and a joint of mass 0 between them.
const JOINT: &str = "units = \"N,m\"\nmasses = { joint = 0, box = \"2 kg\" }\n[[springs]]\nbetween = [\"ground\", \"joint\"]\nstiffness = 30\n[[springs]]\nbetween = [\"joint\", \
                     \"box\"]\nstiffness = 10\n[[contacts]]\nname = \"low\"\nbetween = [\"ground\", \"joint\"]\nfriction = 3\n[[contacts]]\nname = \"high\"\nbetween = [\"joint\", \
                     \"box\"]\nfriction = 2\n[[forces]]\nname = \"push\"\non = \"box\"\namplitude = 9\nfrequency = 2\n";

/// The double pendulum with the box moved by hand: at 0.3 m the upper slider has gone the way of 10 u = 3 − 2 + 30 (0.3 − u) beyond the first.
#[test]
fn a_joint_takes_its_part_of_the_way() {
    let folder = folder("joints");
    let box_moves =
        JOINT.replace("\"2 kg\"", "{ moves = { displacement = { amplitude = 0.3, frequency = 1 } } }");
    let (pushed, _) = box_moves.split_once("[[forces]]").unwrap();
    let name = file(&folder, "moved.toml", pushed);
    let found = json(&format!("system {name} steady --format json"));
    // 3 + 30 y = 2 + 10 (0.3 − y).
    let joint = (2.0 + 3.0 - 3.0) / 40.0;
    compared("system steady max_displacement", numbers(&found["max_displacement"])[0], joint, ByHand, 1e-14);
    // The loop: 4 a times each friction.
    let work = found["elements"].as_array().unwrap();
    let of = |i: usize| work[i]["work"].as_f64().unwrap();
    // From its turn the joint stays until the force has fallen by twice the friction; the steady loop is symmetric.
    for (i, due) in [4.0 * 3.0 * joint, 4.0 * 2.0 * (0.3 - joint)].into_iter().enumerate() {
        compared("system steady elements", of(i), due, ByHand, 1e-12);
    }
    let name = file(&folder, "pushed.toml", JOINT);
    let found = json(&format!("system {name} --format json"));
    // In series, 7.5 N/m.
    let due = (7.5_f64 / 2.0).sqrt();
    compared("system natural_frequencies", numbers(&found["natural_frequencies"])[0], due, ByHand, 1e-14);
    let found = json(&format!("system {name} steady --format json"));
    let [load, dampers, stored] =
        ["load_work", "damper_work", "stored_energy"].map(|key| found[key].as_f64().unwrap());
    let taken: f64 = found["elements"].as_array().unwrap().iter().map(|e| e["work"].as_f64().unwrap()).sum();
    assert!((load - dampers - stored - taken).abs() < 1e-10 * load, "{found}");
}

/// The motion at a constant speed of a spring's end is that of a body that is moved.
#[test]
fn the_end_of_a_spring_is_pulled_as_a_body_is() {
    let folder = folder("pulled_ends");
    let machine = |masses: &str, end: &str, moves: &str| {
        format!(
            "units = \"N,m\"\nmasses = {{ block = \"2 kg\"{masses} }}\n[[springs]]\nname = \"pull\"\nbetween = [\"{end}\", \"block\"]\nstiffness = 50\ndamping = 1\n{moves}[[contacts]]\nname = \"floor\"\nbetween \
             = [\"ground\", \"block\"]\nfriction = 4\nstatic_ratio = 1.5\n"
        )
    };
    for motion in [
        "0.1",
        "{ displacement = { amplitude = 0.5, frequency = 1 } }",
        "{ acceleration = { constant = 0.2 } }",
    ] {
        let ours = file(&folder, "spring.toml", &machine("", "ground", &format!("moves = {motion}\n")));
        let body =
            file(&folder, "body.toml", &machine(&format!(", hand = {{ moves = {motion} }}"), "hand", ""));
        let [ours, body] =
            [ours, body].map(|name| json(&format!("system {name} simulate --until 9s --format json")));
        assert_eq!((&ours["events"], &ours["end"]), (&body["events"], &body["end"]), "{motion}");
        assert_eq!(ours["coordinates"][1], "pull end");
        assert!(!ours["events"].as_array().unwrap().is_empty(), "{ours}");
    }
    let wrong = machine("", "ground", "moves = 0.1\n")
        .replace("\"ground\", \"block\"]\nstiffness", "\"block\", \"ground\"]\nstiffness");
    let name = file(&folder, "wrong.toml", &wrong);
    refused(
        &format!("system {name} steady"),
        &["springs[1].moves 0.1: needs the ground as the first end in between"],
    );
}

/// Each is one line that says what to write instead.
#[test]
fn what_a_joint_or_a_name_cannot_do_is_said() {
    let folder = folder("joints_refused");
    let lines = [
        (
            JOINT.replace("friction = 2\n", "friction = 2\nstatic_ratio = 1.2\n"),
            "high must have no static friction above the kinetic one",
        ),
        (JOINT.replace("joint = 0", "joint = \"-1 kg\""), "masses.joint -1 kg: must be ≥ 0"),
        (
            JOINT.replace("on = \"box\"\namplitude = 9", "on = \"joint\"\nshape = \"square\"\namplitude = 9"),
            "joint, which has no mass, must carry no force that changes at once",
        ),
        (JOINT.replace("stiffness = 30\n", "stiffness = 30\nname = \"low\"\n"), "the name low is used twice"),
        (JOINT.replace("name = \"push\"", "name = \"box\""), "the name box is used twice"),
        (
            "units = \"N,m\"\nmasses = { joint = 0, box = 1 }\n[[contacts]]\nname = \"low\"\nbetween = [\"ground\", \"joint\"]\nstiffness = 1\nfriction = 3\n[[springs]]\nbetween = \
             [\"ground\", \"box\"]\nstiffness = 1\n[[forces]]\non = \"joint\"\namplitude = 9\nfrequency = 2\n"
                .to_owned(),
            "joint, which has no mass, is held neither by a spring or damper nor by a contact that sticks",
        ),
    ];
    for (i, (text, why)) in lines.iter().enumerate() {
        let name = file(&folder, &format!("{i}.toml"), text);
        let run = stickslip(&format!("system {name} simulate --until 20s")).assert().code(2).stdout("");
        let text = said(&run.get_output().stderr);
        assert!(text.contains(why) && text.lines().count() == 1, "{why}: {text}");
    }
    let square = "units = \"N,m\"\n[masses]\nhand = { moves = { displacement = { shape = \"square\", amplitude = 1, frequency = 1 } } }\nbox = 1\n[[springs]]\nbetween = [\"hand\", \
                  \"box\"]\nstiffness = 1\n";
    let name = file(&folder, "square.toml", square);
    let run = stickslip(&format!("system {name}")).assert().code(2).stdout("");
    assert!(
        said(&run.get_output().stderr)
            .contains("must not change at once, because that takes an infinite velocity")
    );
}
