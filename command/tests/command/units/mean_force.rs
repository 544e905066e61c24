//! A mean force and friction that differs by direction, compared with small time steps of the machine itself,
//! which use neither a shift nor a mean friction.

use super::close;
use crate::command_line::{json, refused, stdout, stickslip};
use std::f64::consts::TAU;

const BODY: &str = "--mass 2 --stiffness 8 --friction 5 --friction-backward 3";
/// The displacement about which the motion is symmetric, (p̄ − (r₊ − r₋)/2)/k.
const MEAN: f64 = 1.0;

/// Explicit time steps from rest at `x`: in each step friction, −5 against forward and 3 against backward
/// motion, removes as much of the momentum as it can. Calls `at` after every step with the step's number, the
/// place, the velocity and the force of friction.
fn stepped(mut x: f64, (force, frequency): (f64, f64), steps: u32, mut at: impl FnMut(u32, f64, f64, f64)) {
    let dt = TAU / 4.0 / 20_000.0;
    let mut v = 0.0;
    for step in 0..steps {
        let free = v + dt * (9.0 + force * (frequency * dt * f64::from(step)).sin() - 8.0 * x) / 2.0;
        let friction = (free * 2.0 / dt).clamp(-3.0, 5.0);
        v = free - dt * friction / 2.0;
        x += dt * v;
        at(step + 1, x, v, friction);
    }
}

#[test]
fn places_and_friction_are_those_of_small_time_steps() {
    let rows = stdout(&format!(
        "simulate {BODY} --frequency 4 --force 12 --mean-force 9 --x0 0.3 --cycles 3 --samples 8 --format csv"
    ));
    let mut lines = rows.lines();
    let header: Vec<&str> = lines.next().unwrap().split(',').collect();
    let place = |name: &str| header.iter().position(|column| *column == name).unwrap();
    let rows: Vec<Vec<f64>> =
        lines.map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect()).collect();
    let mut compared = 0;
    stepped(0.3 + MEAN, (12.0, 4.0), 60_000, |step, x, v, friction| {
        if step % 2500 != 0 {
            return;
        }
        let row = &rows[step as usize / 2500];
        let of = |name: &str| row[place(name)];
        assert!((of("displacement[m]") + MEAN - x).abs() < 1e-3, "{step}: {x} {row:?}");
        assert!((of("velocity[m/s]") - v).abs() < 1e-2, "{step}: {v} {row:?}");
        if v.abs() > 0.05 {
            assert_eq!(of("friction_force[N]"), friction, "{step}");
            compared += 1;
        }
    });
    assert!(compared > 15, "{compared}");
}

/// The steady motion between its extrema, the drive's work in a cycle, and the free decay to a place of rest.
#[test]
fn steady_states_and_decays_are_those_of_small_time_steps() {
    let steady =
        json(&format!("steady {BODY} --frequency 4 --force 12 --mean-force 9 --format json"))["physical"]
            .clone();
    let number = |name: &str| steady[name].as_f64().unwrap();
    assert_eq!((number("mean_force"), number("mean_displacement")), (9.0, MEAN));
    assert_eq!((number("friction"), number("friction_backward"), number("friction_bound")), (5.0, 3.0, 4.0));
    let (mut least, mut most, mut work) = (f64::INFINITY, f64::NEG_INFINITY, 0.0);
    stepped(MEAN, (12.0, 4.0), 800_000, |step, x, v, friction| {
        if step > 780_000 {
            (least, most) = (least.min(x), most.max(x));
            work += friction * v * TAU / 4.0 / 20_000.0;
        }
    });
    close(number("max_displacement") + MEAN, most, 1e-3);
    close(number("min_displacement") + MEAN, least, 1e-3);
    close(number("energy_out"), work, 1e-3);

    let decay = json(&format!("decay {BODY} --mean-force 9 --x0 2.9 --format json"))["physical"].clone();
    let mut rest = 0.0;
    stepped(2.9 + MEAN, (0.0, 0.0), 200_000, |_, x, _, _| rest = x);
    assert_eq!(decay["mean_displacement"].as_f64(), Some(MEAN));
    assert!((decay["rest_position"].as_f64().unwrap() + MEAN - rest).abs() < 1e-3, "{decay} {rest}");
    // Without a shift, no mean displacement is written.
    let plain = json("decay --mass 2 --stiffness 8 --friction 4 --x0 2.9 --format json");
    assert_eq!(
        (plain["physical"]["rest_position"].as_f64(), plain["physical"].get("mean_displacement")),
        (decay["rest_position"].as_f64(), None)
    );
}

#[test]
fn a_mean_force_is_given_in_units_in_rows_and_in_sweeps() {
    let text = stdout(&format!("response {BODY} --frequency 4 --force 12 --mean-force 9"));
    for line in
        ["4 N = (5 forward + 3 backward)/2", "mean force p̄             9 N", "mean displacement        1 m ("]
    {
        assert!(text.contains(line), "{text}");
    }
    let steady = stdout(&format!("steady {BODY} --frequency 4 --force 12 --mean-force 9"));
    assert!(steady.starts_with("Displacements are measured from the mean displacement of 1 m."), "{steady}");
    // The forces are those of the symmetric motion, and the text says so where there is more.
    let plain = stdout(&format!("response {BODY} --frequency 4 --force 12"));
    for (text, is_given) in [(&text, true), (&steady, true), (&plain, false)] {
        assert_eq!(text.contains("(without the mean force p̄"), is_given, "{text}");
    }
    let help = stdout("response --help").split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(help.contains("η r_y ± (r₊ − r₋)/2"), "{help}");
    for question in ["attractors --starts 5", "steady --mean-force 0"] {
        let text = stdout(&format!("{question} {BODY} --frequency 4 --force 12"));
        assert!(
            text.starts_with("Displacements are measured from the mean displacement of -0.125 m."),
            "{text}"
        );
    }
    let picture = stdout(&format!("motion-plot {BODY} --frequency 4 --force 12"));
    assert!(picture.contains("displacement from the mean (m)"));
    assert!(stdout(&format!("decay {BODY} --x0 2.9")).contains("mean displacement        -0.125 m"));

    let rows = "frequency[rad/s],mean_force[kN],friction_backward[N],static_ratio\n4,0.009,3,1.25\n4,0,5,1\n";
    let arguments =
        "response --mass 2kg --stiffness 8N/m --friction 5N --force 12N --points - --format jsonl";
    let answers = stickslip(arguments).write_stdin(rows).assert().success();
    let answers = String::from_utf8(answers.get_output().stdout.clone()).unwrap();
    let found: Vec<serde_json::Value> =
        answers.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let seen = |i: usize| {
        let number = |value: &serde_json::Value| value.as_f64().unwrap();
        let physical = &found[i]["physical"];
        (
            number(&found[i]["alpha"]),
            number(&found[i]["static_friction_ratio"]),
            number(&physical["mean_displacement"]),
        )
    };
    assert_eq!((seen(0), seen(1)), ((3.0, 1.25, MEAN), (2.4, 1.0, 0.0)));

    let sweep = stdout(&format!(
        "sweep response {BODY} --frequency 4 --force 12 --mean-force 1:9:3 --outputs alpha,physical.mean_displacement"
    ));
    assert_eq!(sweep, "alpha,mean_displacement[m]\n3.0,0.0\n3.0,0.5\n3.0,1.0\n");
}

#[test]
fn what_has_no_mean_force_refuses_it() {
    for (arguments, parts) in [
        (
            format!("response {BODY} --frequency 4 --force 12 --friction-backward 0"),
            vec!["cannot be used multiple times"],
        ),
        (
            "response --mass 2 --stiffness 8 --friction 5 --friction-backward 0 --frequency 4 --force 12"
                .to_owned(),
            vec!["--friction-backward 0", "> 0"],
        ),
        (
            format!("response {BODY} --frequency 4 --force 12 --mean-force nan"),
            vec!["--mean-force nan", "finite"],
        ),
        (
            format!("response {BODY} --frequency 4 --force 12 --mean-force 2mm"),
            vec!["--mean-force 2mm", "force"],
        ),
        (
            "response --omega 2 --alpha 3 --mean-force 1".to_owned(),
            vec!["--mean-force 1", "machine in units", "--mass"],
        ),
        (
            "response --omega 2 --alpha 3 --friction-backward 1".to_owned(),
            vec!["--friction-backward 1", "machine in units"],
        ),
        (
            "response --mass 2 --stiffness 8 --friction-backward 3 --frequency 4 --force 12".to_owned(),
            vec!["--friction", "missing"],
        ),
        (
            format!("map max_displacement {BODY} --frequency 4 --force 12 --mean-force 2"),
            vec!["--mean-force 2", "does not use it"],
        ),
        (
            "design friction --mass 2 --stiffness 8 --frequency 4 --force 12 --friction-backward 3"
                .to_owned(),
            vec!["--friction-backward 3", "does not use it"],
        ),
    ] {
        refused(&arguments, &parts);
    }
}
