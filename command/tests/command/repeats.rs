//! A record that repeats itself, of one body: beside the same machine as a system, beside many cycles of the record in a row, which other
//! code follows, and by hand.

use crate::command_line::{json, refused, stdout};
use crate::place::{Place, place};
use serde_json::Value;

/// A folder with a cycle of a load, and with 120 of them in a row.
fn cycles(name: &str, header: &str, cycle: &[(f64, f64)]) -> (Place, [String; 2]) {
    let folder = place(name);
    std::fs::create_dir(&*folder).unwrap();
    let length = cycle.last().unwrap().0;
    let row = |(t, x): (f64, f64)| format!("{t},{x}\n");
    let one: String = cycle.iter().map(|point| row(*point)).collect();
    let joined =
        |i: u32| cycle.iter().map(move |(t, x)| (f64::from(i) * length + t, *x)).skip(usize::from(i > 0));
    let many: String = (0..120).flat_map(joined).map(row).collect();
    let files = [("cycle.csv", one), ("many.csv", many)].map(|(name, rows)| {
        let path = folder.join(name);
        std::fs::write(&path, format!("time[s],{header}\n{rows}")).unwrap();
        path.display().to_string()
    });
    (folder, files)
}

/// Fails where two numbers differ by more than a bound.
#[track_caller]
fn agree(ours: f64, other: f64, bound: f64) {
    assert!((ours - other).abs() <= bound, "{ours} for {other}, beyond {bound:e}");
}

fn number(answer: &Value, name: &str) -> f64 {
    answer[name][0].as_f64().unwrap_or_else(|| panic!("{name}: {answer}"))
}

/// The last of 120 cycles has the extremes of the steady motion: of a body on a spring with two frictions, a damper, static friction and
/// a constant force under a force, an acceleration, and a support with and without the damper.
#[test]
fn many_cycles_lead_to_it() {
    let cycle = [(0.0, 0.0), (0.4, 3.0), (0.7, 2.0), (1.1, -3.5), (1.4, -1.0), (1.6, 0.0)];
    let machine = "--units N,m --mass 2 --stiffness 9 --friction 1.3 --friction-backward 0.8 --static-friction-ratio 1.2 --damping 0.7 \
                   --mean-force 0.4";
    let headers = ["force[N]", "acceleration[m/s^2]", "foot-displacement[m]", "damped-foot-displacement[m]"];
    for (place, header) in headers.into_iter().enumerate() {
        let (folder, [one, many]) = cycles(&format!("repeats_{place}"), header, &cycle);
        let steady = json(&format!("record {one} {machine} --repeats --format json"));
        assert_eq!((&steady["kind"], &steady["record"]["after"]), (&"periodic".into(), &"repeats".into()));
        assert!((steady["period"].as_f64().unwrap() - 1.6).abs() < 1e-12, "{steady}");
        let states = folder.join("states.csv").display().to_string();
        stdout(&format!("record {many} {machine} --out {states} --interval 0.001 --format json"));
        let rows = std::fs::read_to_string(&states).unwrap();
        let columns = |row: &str| -> Vec<f64> { row.split(',').map(|cell| cell.parse().unwrap()).collect() };
        let last: Vec<Vec<f64>> = rows
            .lines()
            .skip(1)
            .map(columns)
            .filter(|row| (119.0 * 1.6..=120.0 * 1.6).contains(&row[0]))
            .collect();
        assert!(last.len() > 1000, "{}", last.len());
        let most = |column: usize, sign: f64| {
            sign * last.iter().map(|row| sign * row[column]).fold(f64::NEG_INFINITY, f64::max)
        };
        // The states have each turn of the displacement; the greatest velocities are between two of them.
        for (name, column, sign, bound) in [
            ("max_displacement", 1, 1.0, 1e-9),
            ("min_displacement", 1, -1.0, 1e-9),
            ("max_velocity", 2, 1.0, 1e-5),
            ("min_velocity", 2, -1.0, 1e-5),
        ] {
            let (ours, other) = (number(&steady, name), most(column, sign));
            assert!(other.abs() > 0.01 && (ours - other).abs() < bound, "{header}: {name} {ours} {other}");
        }
    }
}

/// The file of a record that repeats itself has its cycle: each of its states is one of the last of 120 cycles, it ends as it begins, and a rest
/// over the seam lasts to the end.
#[test]
fn its_cycle_is_written() {
    let rows = |file: &str| -> Vec<Vec<f64>> {
        let text = std::fs::read_to_string(file).unwrap();
        text.lines().skip(1).map(|row| row.split(',').map(|cell| cell.parse().unwrap()).collect()).collect()
    };
    let cases = [
        ("force[N]", vec![(0.0, 0.5), (0.4, 3.0), (0.7, 2.0), (1.1, -3.5), (1.4, -1.0), (1.6, 0.5)]),
        // It rests at the seam, where the load jumps.
        ("force[N]", vec![(0.0, 0.1), (0.2, 0.1), (0.4, 4.0), (1.0, -4.0), (1.2, 0.3), (1.6, -0.1)]),
        ("acceleration[m/s^2]", vec![(0.0, 2.0), (0.8, -4.0), (1.6, -1.0)]),
    ];
    for (place, (header, cycle)) in cases.iter().enumerate() {
        let (folder, [one, many]) = cycles(&format!("repeats_out_{place}"), header, cycle);
        // Where the load jumps at the seam, the row at it stands twice.
        if cycle[0].1 != cycle.last().unwrap().1 {
            let row = |i: u32| cycle.iter().map(move |(t, x)| format!("{:.6},{x}\n", f64::from(i) * 1.6 + t));
            let text: String = (0..120).flat_map(row).collect();
            std::fs::write(&many, format!("time[s],{header}\n{text}")).unwrap();
        }
        let machine =
            "--units N,m --mass 2 --stiffness 9 --friction 1.3 --static-friction-ratio 1.1 --damping 0.4";
        let [ours, all] = ["ours.csv", "all.csv"].map(|name| folder.join(name).display().to_string());
        stdout(&format!("record {one} {machine} --repeats --out {ours} --interval 0.02"));
        stdout(&format!("record {many} {machine} --out {all} --interval 0.0005"));
        let (ours, all) = (rows(&ours), rows(&all));
        assert!(ours.len() > 20, "{ours:?}");
        let (first, last) = (&ours[0], ours.last().unwrap());
        agree(last[0] - first[0], 1.6, 1e-12);
        agree(last[1], first[1], 1e-12);
        agree(last[2], first[2], 1e-12);
        for row in &ours {
            let time = 118.0 * 1.6 + row[0];
            let before = all.iter().rev().find(|other| other[0] <= time + 1e-9).unwrap();
            // A parabola over at most one interval, or a rest.
            let late = if before[4] == 0.0 { 0.0 } else { time - before[0] };
            agree(row[1], before[1] + before[2] * late + before[3] * late * late / 2.0, 1e-8);
        }
    }
    // The seam of a record of which the motion rests there: its last row has the load of the last sample.
    let (folder, [one, _]) = cycles("repeats_out_rest", "force[N]", &cases[1].1);
    let out = folder.join("rest.csv").display().to_string();
    stdout(&format!(
        "record {one} --units N,m --mass 2 --stiffness 9 --friction 2 --damping 3 --repeats --out {out} --picture {out}.svg"
    ));
    let found = rows(&out);
    let last = found.last().unwrap();
    assert_eq!((last[0], last[2], last[4]), (1.6, 0.0, 0.0), "{found:?}");
    agree(*last.last().unwrap(), -0.1, 1e-12);
    assert!(std::fs::read_to_string(format!("{out}.svg")).unwrap().starts_with("<svg"));
}

/// The answer is that of a system with the same body, to the last digit.
#[test]
fn it_is_that_of_a_system() {
    let cycle = [(0.0, 0.0), (0.2, 5.0), (0.5, -6.0), (0.8, 0.0)];
    let (folder, [one, _]) = cycles("repeats_system", "acceleration[m/s^2]", &cycle);
    let file = folder.join("machine.toml");
    let text = "units = \"N,m\"\nmasses = { body = 2 }\n[[springs]]\nbetween = [\"ground\", \"body\"]\nstiffness = 30\n[[springs]]\nbetween = \
                [\"ground\", \"body\"]\ndamping = 0.5\n[[contacts]]\nname = \"surface\"\nbetween = [\"ground\", \"body\"]\nfriction = 4\n\
                [base]\nacceleration = { file = \"cycle.csv\", repeats = true }\n";
    std::fs::write(&file, text).unwrap();
    let system = json(&format!("system {} steady --format json", file.display()));
    let mut own = json(&format!(
        "record {one} --units N,m --mass 2 --stiffness 30 --damping 0.5 --friction 4 --repeats --format json"
    ));
    assert_eq!(own["record"]["samples"], 4, "{own}");
    own.as_object_mut().unwrap().remove("record");
    assert_eq!(own, system);
    let text = stdout(&format!("record {one} --mass 2kg --stiffness 30N/m --friction 4N --repeats"));
    assert!(text.contains("It repeats itself.") && text.contains("Periodic"), "{text}");
}

/// A track that jerks, as by hand: 0.9 g for 0.02 s against a friction of 0.5 g, then 0.3 g with it. With a slope the friction is that of
/// the force across, and gravity pulls along: the part goes on where both frictions are the greater ones.
#[test]
fn a_track_that_jerks_carries_its_part() {
    const G: f64 = 9.80665;
    let cycle = [(0.0, 0.3), (0.06, 0.3), (0.06, -0.9), (0.08, -0.9)];
    let (_folder, [one, _]) = cycles("repeats_jerk", "acceleration[g]", &cycle);
    let drift = |options: &str| {
        let found = json(&format!("record {one} --mass 1kg --no-spring {options} --repeats --format json"));
        assert_eq!(found["kind"], "periodic", "{found}");
        (number(&found, "drift"), found)
    };
    let by_hand = |against: f64, with: f64| {
        let speed = against * G * 0.02;
        speed * speed / 2.0 * (1.0 / (against * G) + 1.0 / (with * G))
    };
    let (flat, _) = drift("--friction-coefficient 0.5");
    agree(flat, by_hand(0.4, 0.8), 1e-12);
    let angle = 2.0_f64.to_radians();
    let (sin, cos) = angle.sin_cos();
    let (down, _) = drift("--friction-coefficient 0.5 --slope 2deg");
    agree(down, by_hand(0.9 + sin - 0.5 * cos, 0.3 - sin + 0.5 * cos), 1e-11);
    // The friction of the direction in which the part slides takes up its work.
    let (two, found) = drift("--friction 4N --friction-backward 6N");
    let forward = 4.0 / G;
    agree(two, by_hand(0.9 - forward, 0.3 + forward), 1e-11);
    let work = found["elements"][0]["work"].as_f64().unwrap();
    agree(work, 4.0 * two, 1e-11);
    let note = crate::command_line::stickslip(&format!(
        "record {one} --no-spring --friction-coefficient 0.5 --repeats"
    ));
    let mut note = note;
    let said = String::from_utf8(note.assert().success().get_output().stderr.clone()).unwrap();
    assert!(said.contains("--mass is left out"), "{said}");
}

/// The digits of a track that jerks are those of the squares of velocities by hand, as far as they go.
#[cfg(feature = "mp")]
#[test]
fn it_has_any_number_of_digits() {
    let (_folder, [one, _]) = cycles(
        "repeats_digits",
        "acceleration[m/s^2]",
        &[(0.0, 3.0), (0.0625, 3.0), (0.0625, -9.0), (0.078_125, -9.0)],
    );
    let line = format!("record {one} --units N,m --mass 1 --no-spring --friction 5 --repeats --format json");
    let found = json(&format!("{line} --bits 160"));
    // 9 − 5 for 1/64 s, then 3 + 5 back: v = 1/16, v²/2 (1/4 + 1/8) = 3/4096, without a rounding.
    assert_eq!(found["drift"][0].as_str().unwrap().parse::<f64>().unwrap(), 3.0 / 4096.0);
    let speed = found["mean_velocity"][0].as_str().unwrap();
    // 3/4096 · 64/5 = 0.009375, of which the digits are many.
    assert!(speed.trim_end_matches('0').len() <= "0.009375".len() || speed.len() > 40, "{speed}");
    // A body on a spring under a force of thirds: the digits of 128 bits are among those of 256.
    let (_folder, [one, _]) =
        cycles("repeats_spring", "force[N]", &[(0.0, 0.0), (0.5, 9.0), (1.0, -9.0), (1.5, 3.0), (2.0, 0.0)]);
    let line =
        format!("record {one} --mass 2.1 --stiffness 30 --friction 3.3 --units N,m --repeats --format json");
    let [few, some, many] = ["", " --bits 128", " --bits 256"].map(|bits| json(&format!("{line}{bits}")));
    for place in ["/start/displacement/0", "/max_velocity/0", "/elements/0/work", "/events/0/time"] {
        let [some, many] = [&some, &many].map(|found| found.pointer(place).unwrap().as_str().unwrap());
        assert!(many.len() > some.len() && some.len() > 35, "{place}: {some} {many}");
        assert_eq!(some[..33], many[..33], "{place}");
        let few = few.pointer(place).unwrap().as_f64().unwrap();
        agree(few, many.parse().unwrap(), 1e-11);
    }
    assert_eq!(some["events"].as_array().unwrap().len(), few["events"].as_array().unwrap().len());
    let text = crate::command_line::stdout(&format!("{} --bits 128", line.replace(" --format json", "")));
    assert!(text.contains("It repeats itself.") && text.contains("period"), "{text}");
}

#[test]
fn what_it_does_not_have_is_refused() {
    let (_folder, [one, _]) =
        cycles("repeats_refused", "damped-foot-displacement[m]", &[(0.0, 0.0), (1.0, 2.0), (2.0, 1.0)]);
    let machine =
        format!("record {one} --units N,m --mass 2 --stiffness 9 --friction 1 --damping 1 --repeats");
    refused(&machine, &[&one, "must end with its first value where it repeats itself"]);
    for option in [
        "--after hold",
        "--both-polarities",
        "--enclose",
        "--one-way",
        "--interval 1s",
        "--floor-spectrum 1s",
    ] {
        let name = option.split(' ').next().unwrap();
        refused(&format!("{machine} {option}"), &[name]);
    }
    refused(&format!("{machine} --bits 64 --picture x.svg"), &["--bits 64: must be"]);
    refused(
        &format!("record {one} --units N,mm,g --mass 2 --stiffness 9 --friction 1 --repeats"),
        &["--units"],
    );
}
