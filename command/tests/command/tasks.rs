//! Typical tasks of engineers, done with the documented commands alone, and compared with small time steps in
//! the fixed frame.
//!
//! The isolator is among the tests of units.

use crate::command_line::{json, refused, stdout, stickslip};
use crate::place::place;
use crate::units::base_motion::{Room, isolator};
use crate::units::{close, number};
use std::f64::consts::TAU;

/// Dither: the force at 40 Hz that keeps a valve spool of 200 g from sticking, and the motion with slightly
/// more and less force.
#[test]
fn dither_that_keeps_a_valve_from_sticking() {
    let valve = "--mass 200g --stiffness 8N/mm --friction 3N";
    let least = json(&format!("design force {valve} --frequency 40Hz --units N,mm --format json"));
    assert_eq!((&least["units"]["force"], &least["units"]["foot_displacement"]), (&"N".into(), &"mm".into()));
    let room = Room { mass: 0.2, stiffness: 8000.0, friction: 3.0, frequency: TAU * 40.0, damping: 0.0 };
    let steps = 20_000;
    let at = |share: f64| room.stepped(share * number(&least["force"]), 0.0, 0.0, 200, steps);
    // A reversal takes one or two steps; a stop takes many.
    assert!(at(1.02).held <= 8, "{}", at(1.02).held);
    assert!(at(0.9).held > 20, "{}", at(0.9).held);
    let over = 1.02 * number(&least["force"]);
    let motion = json(&format!("response {valve} --frequency 40Hz --force {over}N --format json"));
    assert_eq!(motion["regime"], "non-sticking");
    close(number(&motion["physical"]["max_displacement"]), at(1.02).stroke, 2e-3);
}

/// A friction damper: the friction that takes most energy out of a machine, compared with time steps at that
/// friction, below and above.
#[test]
fn the_damper_that_dissipates_most() {
    let machine = "--mass 50t --stiffness 1000kN/m --frequency 1Hz --force 12kN";
    let best = json(&format!("design dissipation {machine} --units kN,m --format json"));
    assert_eq!((&best["units"]["friction"], &best["units"]["energy"]), (&"kN".into(), &"kN·m".into()));
    let energy = |share: f64| {
        let friction = share * 1e3 * number(&best["friction"]);
        let room = Room { mass: 5e4, stiffness: 1e6, friction, frequency: TAU, damping: 0.0 };
        room.stepped(12e3, 0.0, 0.0, 100, 20_000).friction
    };
    let most = energy(1.0);
    close(1e3 * number(&best["energy"]), most, 3e-3);
    assert!(energy(0.8) < most && energy(1.2) < most, "{} {most} {}", energy(0.8), energy(1.2));
}

/// A response curve for two frictions as CSV, each point compared with time steps.
#[test]
fn a_response_curve_of_ones_own_machine() {
    let rows = stdout(
        "response-curve --mass 800kg --period 2.2s --friction-coefficient 0.05,0.12 --base-acceleration \
         0.15g \
         --frequency 0.6Hz:3Hz:4 --units N,mm",
    );
    let mut lines = rows.lines();
    assert_eq!(lines.next().unwrap(), "curve,frequency[Hz],regime,displacement[mm],margin[1],point");
    let mut regimes = Vec::new();
    for line in lines {
        let cells: Vec<&str> = line.split(',').collect();
        let coefficient = if cells[0].ends_with("0.05") { 0.05 } else { 0.12 };
        let hertz: f64 = cells[1].parse().unwrap();
        let base = 0.15 * 9.80665 / (TAU * hertz).powi(2);
        let stepped = isolator(coefficient, hertz).stepped(0.0, base, base, 100, 10_000);
        close(cells[3].parse().unwrap(), 1e3 * stepped.stroke, 5e-3);
        regimes.push(cells[2].to_owned());
    }
    assert!(regimes.len() == 8 && regimes.iter().any(|r| r == "sticking"), "{regimes:?}");
    let picture = place("task-curve.svg");
    stdout(&format!(
        "response-curve transmissibility --omega 0.3:3:100:log --alpha 1.2,2,4 --out {}",
        picture.display()
    ));
    let drawing = std::fs::read_to_string(picture).unwrap();
    for due in [
        "Transmissibility against frequency",
        "natural frequency",
        "with stops (exact)",
        "sticking threshold",
    ] {
        assert!(drawing.contains(due), "{due}");
    }
}

/// Two hundred thousand points to Parquet, which are two groups of rows, some of which are compared with single answers.
#[cfg(feature = "parquet")]
#[test]
fn many_points_to_parquet() {
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::record::RowAccessor;
    let file = place("task-many.parquet");
    stdout(&format!(
        "sweep response --mass 800kg --period 2.2s --friction-coefficient 0.05 --units N,mm --frequency \
         0.5Hz:5Hz:400 \
         --base-acceleration 0.08g:0.5g:500 --outputs \
         frequency,base_acceleration,physical.max_displacement --out {}",
        file.display()
    ));
    let reader = SerializedFileReader::new(std::fs::File::open(file).unwrap()).unwrap();
    assert_eq!(reader.metadata().file_metadata().num_rows(), 200_000);
    let schema = reader.metadata().file_metadata().schema_descr();
    let names: Vec<&str> = schema.columns().iter().map(|column| column.name()).collect();
    assert_eq!(names, ["frequency[Hz]", "base_acceleration[mm/s^2]", "max_displacement[mm]"]);
    for row in reader.get_row_iter(None).unwrap().skip(499).step_by(60_000) {
        let row = row.unwrap();
        let (hertz, acceleration) = (row.get_double(0).unwrap(), row.get_double(1).unwrap());
        let one = json(&format!(
            "response --mass 800kg --period 2.2s --friction-coefficient 0.05 --units N,mm --frequency \
             {hertz}Hz \
             --base-acceleration {acceleration}mm/s^2 --format json"
        ));
        close(number(&one["physical"]["max_displacement"]), row.get_double(2).unwrap(), 1e-12);
    }
}

/// Friction and damping from a curve made by time steps: a measurement that is independent of the closed
/// forms.
#[test]
fn friction_and_damping_from_a_measured_curve() {
    let file = place("task-measured.csv");
    let constant = 2.0 * 0.04 * 800.0 * TAU / 2.2;
    let mut text = "frequency[Hz],amplitude[mm]\n".to_owned();
    for hertz in [0.55, 0.6, 0.7, 0.85, 1.0, 1.3, 1.8, 2.5] {
        let base = 0.15 * 9.80665 / (TAU * hertz).powi(2);
        let room = Room { damping: constant, ..isolator(0.05, hertz) };
        text += &format!("{hertz},{}\n", 1e3 * room.stepped(0.0, base, base, 150, 8000).stroke);
    }
    std::fs::write(&file, text).unwrap();
    let name = file.display();
    let machine = "--mass 800kg --period 2.2s --base-acceleration 0.15g";
    let found = json(&format!("identify {name} {machine} --format json"));
    close(number(&found["friction"]["value"]), 0.05 * 800.0 * 9.80665, 0.01);
    close(number(&found["friction_coefficient"]["value"]), 0.05, 0.01);
    close(number(&found["damping_ratio"]["value"]), 0.04, 0.01);
    close(number(&found["damping"]["value"]), constant, 0.01);
    for key in ["friction", "friction_coefficient", "damping_ratio", "damping"] {
        let of = |part: &str| number(&found[key][part]);
        let [low, high] = [0, 1].map(|end| number(&found[key]["interval_95"][end]));
        close((low + high) / 2.0, of("value"), 1e-12);
        assert!(
            high - low > 3.9 * of("standard_error") && of("standard_error") > 0.0,
            "{key}: {low} to {high}"
        );
    }
    assert_eq!((found["used"].as_u64(), &found["friction"]["unit"]), (Some(8), &"N".into()));
    assert!(stdout(&format!("identify {name} {machine}")).contains("explain 8 of 8 measurements"));
    refused(
        &format!("identify {name} --mass 800kg --period 2.2s --base-displacement 3mm"),
        &["--base-displacement"],
    );
    refused(&format!("identify {name} --mass 800kg --period 2.2s --force 3m"), &["--force 3m", "a force"]);
    for (text, part) in [
        ("frequency[Hz],size[mm]\n", "column amplitude is missing"),
        ("frequency[s],amplitude[mm]\n", "“s” is a unit of time"),
        ("frequency[Hz],amplitude[mm]\n1,x\n", "line 2: amplitude x: must be a number"),
        ("frequency[Hz],amplitude[mm]\n1,-2\n", "must be > 0"),
        ("frequency[Hz],amplitude[mm]\n1,2\n", "measurements"),
    ] {
        let output = stickslip(&format!("identify - {machine}")).write_stdin(text).output().unwrap();
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0), "{text}");
        assert!(message.contains(part) && message.lines().count() == 1, "{part}: {message}");
    }
}

/// A machine swept over three quantities, and mapped over two; map and sweep agree with single answers.
#[test]
fn machines_over_a_range() {
    let rows = stdout(
        "sweep steady --mass 800kg --period 2.2s --friction-coefficient 0.05,0.12 --frequency 0.8Hz,2Hz \
         --units N,mm \
         --base-acceleration 0.15g --outputs \
         friction_coefficient,frequency,regime,physical.max_displacement,dynamic_amplification",
    );
    let lines: Vec<&str> = rows.lines().collect();
    assert_eq!(
        lines[0],
        "regime,dynamic_amplification,friction_coefficient[1],frequency[Hz],max_displacement[mm]"
    );
    assert_eq!(lines.len(), 5);
    for (line, (mu, hertz)) in lines[1..].iter().zip([(0.05, 0.8), (0.05, 2.0), (0.12, 0.8), (0.12, 2.0)]) {
        let one = json(&format!(
            "steady --mass 800kg --period 2.2s --friction-coefficient {mu} --frequency {hertz}Hz --units \
             N,mm \
             --base-acceleration 0.15g --format json"
        ));
        let cells: Vec<&str> = line.split(',').collect();
        assert_eq!(cells[0], one["regime"]);
        close(cells[1].parse().unwrap(), number(&one["dynamic_amplification"]), 1e-14);
        close(cells[2].parse().unwrap(), mu, 1e-14);
        close(cells[4].parse().unwrap(), number(&one["physical"]["max_displacement"]), 1e-14);
    }
    let header = stdout("sweep border --omega 0.5,0.7 --header units");
    assert!(
        header.starts_with("omega[1],min_force_ratio[1],") && header.contains(",least_displacement[B],"),
        "{header}"
    );
    let bands = stdout("design bands --mass 1kg --period 2s --friction 1N --force 3N --from 0.1Hz --to 3Hz");
    assert!(bands.contains("rad/s = 3 Hz"), "{bands}");
    let with_units = stdout(
        "sweep response --mass 1kg --period 2s --friction 1N --force 3N,4N --frequency 3Hz --units N,mm \
         --outputs \
         max_displacement[mm],alpha",
    );
    assert!(with_units.starts_with("alpha,max_displacement[mm]\n3.0,"), "{with_units}");
    refused(
        "sweep response --mass 1kg --period 2s --friction 1N --force 3N,4N --frequency 3Hz --units N,mm \
         --outputs \
         max_displacement[m]",
        &["--outputs max_displacement[m]", "Choose from omega,"],
    );
    let map = stdout(
        "map steady:max_displacement --mass 800kg --period 2.2s --friction-coefficient 0.05,0.12 \
         --frequency 0.8Hz,2Hz \
         --base-acceleration 0.15g --units N,mm",
    );
    let mapped: Vec<&str> = map.lines().collect();
    assert_eq!(mapped[0], "frequency[Hz],friction_coefficient,steady:max_displacement[mm]");
    for (map, sweep) in mapped[1..].iter().zip(&lines[1..]) {
        assert_eq!(map.rsplit(',').next(), sweep.rsplit(',').next());
    }
    for (arguments, parts) in [
        (
            "map --mass 1kg --period 2s --friction 1N --force 1N:3N:4 --frequency 2Hz",
            vec!["1 grid", "must be two"],
        ),
        (
            "sweep response --mass 1kg --period 2s --friction 1N --force 1N:3N:4",
            vec!["--frequency is missing"],
        ),
        (
            "sweep response --mass 1kg --period 2s --friction 1N --force 1N:3m:4 --frequency 2Hz",
            vec!["--force 1N:3m:4", "“m” is a unit of length"],
        ),
        (
            "sweep response --mass 1kg --period 2s --friction 1N --force 1N:3:4 --frequency 2Hz",
            vec!["--force 1N:3:4", "each value a unit, or none"],
        ),
        (
            "sweep response --mass 1kg --period -1s:2s:4 --friction 1N --force 1N --frequency 2Hz",
            vec!["--period -1", "must be > 0"],
        ),
        ("sweep border --omega 0.5 --force 3N", vec!["--force", "a border has none"]),
        ("sweep response --omega 0.5:1:3 --alpha 2 --units kN,m", vec!["--units", "does not use it"]),
        ("map nonesuch --omega 0.5:1:3 --alpha 1:2:3", vec!["map nonesuch", "must be one of"]),
        ("response-curve --omega 0.5:2:10 --alpha 1:5:41", vec!["41 curves, must be ≤ 40"]),
        ("response-curve --omega 0.5 --alpha 2", vec!["give a grid"]),
        ("response-curve absolute --omega 0.5:2:10 --alpha 2", vec!["--base-acceleration"]),
    ] {
        refused(arguments, &parts);
    }
}
