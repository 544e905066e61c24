//! `stickslip record` and `spectrum`: files, answers, refusals, parts.

use crate::command_line::{json, refused, stdout};
use crate::place::{Place, place};
use std::fs;
use std::path::Path;

/// A folder for the files of a test.
fn folder() -> Place {
    let folder = place("records");
    fs::create_dir(&*folder).unwrap();
    folder
}

/// A sum of sines under an envelope, as a record of the PEER database.
fn peer(count: usize) -> String {
    let samples = (0..count).map(|i| {
        let t = i as f64 * 0.01;
        0.2 * (t / 2.0).min(1.0) * ((7.0 * t).sin() + (17.0 * t + 1.0).sin())
    });
    let head = format!("A\nB\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS=  {count}, DT=   .0100 SEC\n");
    let mut text = head;
    for (i, sample) in samples.enumerate() {
        text += &format!("{sample:15.7E}");
        text += if i % 5 == 4 { "\n" } else { " " };
    }
    text
}

fn file(folder: &Place, name: &str, text: &str) -> String {
    let path = folder.join(name);
    fs::write(&path, text).unwrap();
    path.display().to_string()
}

fn bytes(path: &Path) -> Vec<u8> {
    fs::read(path).unwrap()
}

const ISOLATOR: &str = "--mass 800kg --period 2.5s --friction-coefficient 0.06 --damping-ratio 5%";

/// Newmark's block: a(a − r)t²/(2r) under a pulse, from CSV in other units.
#[test]
fn a_block_under_a_pulse_has_newmarks_displacement() {
    let folder = folder();
    let pulse = file(&folder, "pulse.csv", "time[ms],acceleration[mm/s2]\n0,-2000\n500,-2000\n1000,-2000\n");
    let found = json(&format!("record {pulse} --mass 2t --no-spring --friction 1kN --format json"));
    let exact = 2.0 * (2.0 - 0.5) / (2.0 * 0.5);
    let residual = found["residual_displacement"].as_f64().unwrap();
    assert!((residual / exact - 1.0).abs() < 1e-13, "{found}");
    assert_eq!(found["units"]["residual_displacement"], "m");
    // The same record with its step as an option, scaled and cut.
    let pulse = file(&folder, "step.csv", "acceleration[mm/s2]\n-1000\n-1000\n-1000\n-1000\n-1000\n");
    let args =
        format!("record {pulse} --time-step 0.5s --scale 2 --to 1s --mass 2t --no-spring --friction 1kN");
    assert_eq!(json(&format!("{args} --format json"))["residual_displacement"].as_f64(), Some(residual));
}

/// A cut has the samples at both of its ends, and the line of the record describes it.
#[test]
fn a_cut_keeps_the_samples_at_its_ends() {
    let folder = folder();
    let rows = [1, -6, 3, 5, -4, 2, -3, 1].map(|value| value.to_string());
    let all = (0..8).map(|i| format!("0.{:03},{}\n", 5 * i, rows[i])).collect::<String>();
    let part = (3..7).map(|i| format!("0.{:03},{}\n", 5 * i, rows[i])).collect::<String>();
    let head = "time[s],acc[m/s^2]\n";
    let all = file(&folder, "all.csv", &format!("{head}{all}"));
    let part = file(&folder, "part.csv", &format!("{head}{part}"));
    let forms: &[&str] = if cfg!(feature = "mp") { &["", " --bits 128", " --enclose"] } else { &[""] };
    for form in forms {
        let run = |file: &str, cut: &str| {
            let found = json(&format!("record {file} --yield-acceleration 0.05g {cut} --format json{form}"));
            let number = |value: &serde_json::Value| {
                let text = || value.as_str().or_else(|| value["mid"].as_str()).unwrap();
                value.as_f64().unwrap_or_else(|| text().parse().unwrap())
            };
            (["path", "stick_time"].map(|name| number(&found[name])), found["record"].clone())
        };
        let (cut, described) = run(&all, "--from 15ms --to 0.03s");
        // By an exact solution with rational coefficients of each piece.
        for (found, due) in cut.iter().zip([5.18333202023035e-5, 0.000874770203182591]) {
            assert!((found / due - 1.0).abs() < 1e-13, "{form}: {found} {due}");
        }
        let (_, due) = run(&part, "");
        for name in ["samples", "peak", "mean"] {
            assert_eq!(described[name], due[name], "{name}");
        }
    }
}

#[test]
fn a_record_of_the_peer_database_and_its_motion() {
    let folder = folder();
    let quake = file(&folder, "quake.at2", &peer(1001));
    let motion = folder.join("motion.csv").display().to_string();
    let found = json(&format!("record {quake} {ISOLATOR} --format json --out {motion}"));
    let of = |key: &str| found[key].as_f64().unwrap();
    let text = fs::read_to_string(&motion).unwrap();
    let mut rows = text.lines();
    let names =
        "time[s],displacement[m],velocity[m/s],acceleration[m/s^2],direction,absolute_acceleration[m/s^2]";
    assert_eq!(rows.next(), Some(&*format!("{names},friction[N],transmitted_force[N],load[N]")));
    let rows: Vec<Vec<f64>> =
        rows.map(|row| row.split(',').map(|cell| cell.parse().unwrap()).collect()).collect();
    let column = |place: usize| rows.iter().map(move |row| row[place]);
    assert!((column(1).fold(0.0, f64::max) / of("max_displacement") - 1.0).abs() < 1e-12, "{found}");
    // The extremes of acceleration and force are those of its states, or between two of them.
    for (place, name) in [(5, "max_absolute_acceleration"), (7, "max_transmitted_force")] {
        let greatest = column(place).fold(0.0f64, |most, value| most.max(value.abs()));
        let part = greatest / of(name);
        assert!(part <= 1.0 + 1e-13 && part > 0.99, "{name} {part}");
    }
    // Newton's law at every state: m x″ = load + friction − k x − c x′.
    let (mass, omega) = (800.0, std::f64::consts::TAU / 2.5);
    for row in &rows {
        let [_, x, v, a, _, _, friction, force, load] = row[..] else { panic!("{row:?}") };
        let support = mass * omega * (omega * x + 2.0 * 0.05 * v) - friction;
        assert!((mass * a - (load - support)).abs() < 1e-9 && (force - support).abs() < 1e-9, "{row:?}");
    }
    assert!(of("load_work") > of("friction_work"), "{found}");
    assert!(stdout(&format!("record {quake} {ISOLATOR}")).starts_with("The body slides "));
}

#[test]
fn parts_of_spectra_are_the_whole_and_rows_are_those_of_a_body_alone() {
    let folder = folder();
    let (a, b) = (file(&folder, "a.at2", &peer(600)), file(&folder, "b.at2", &peer(700)));
    let args =
        format!("spectrum {a} {b} --period 0.2s:3s:13 --friction-coefficient 0.02,0.1 --damping-ratio 5%");
    let whole = stdout(&args);
    assert_eq!(whole.lines().count(), 1 + 2 * 13 * 2);
    let parts: String = (1..=3)
        .map(|part| {
            let header = if part == 1 { "" } else { "--no-header" };
            stdout(&format!("{args} --shard {part}/3 {header}"))
        })
        .collect();
    assert_eq!(parts, whole);
    let row: Vec<&str> = whole.lines().last().unwrap().split(',').collect();
    let place_of =
        |name: &str| whole.lines().next().unwrap().split(',').position(|own| own.starts_with(name)).unwrap();
    let alone = json(&format!(
        "record {b} --mass 1kg --period 3s --friction-coefficient 0.1 --damping-ratio 5% --format json"
    ));
    for name in ["max_displacement", "residual_displacement", "path", "max_absolute_acceleration"] {
        assert_eq!(row[place_of(name)].parse::<f64>().ok(), alone[name].as_f64(), "{name}");
    }
    // A file that was cut off anywhere is continued.
    let cut = folder.join("cut.csv");
    for length in [0, 10, whole.len() / 2, whole.len()] {
        fs::write(&cut, &whole[..length]).unwrap();
        stdout(&format!("{args} --out {} --resume", cut.display()));
        assert_eq!(bytes(&cut), whole.as_bytes(), "{length}");
    }
    let other = args.replace("5%", "6%");
    refused(&format!("{other} --out {} --resume", cut.display()), &["not of these spectra"]);
}

#[test]
fn broken_records_are_refused_by_line() {
    let folder = folder();
    for (name, text, said) in [
        ("empty.csv", "", "empty.csv: has no samples"),
        ("one.csv", "time[s],acceleration[g]\n0,1\n", "the number of samples = 1 must be ≥ 2"),
        ("gap.csv", "time[s],acceleration[g]\n0,1\n1,\n", "gap.csv line 3: acceleration: is missing"),
        ("nan.csv", "time[s],acceleration[g]\n0,1\n1,NaN\n", "nan.csv line 3"),
        ("back.csv", "time[s],acceleration[g]\n0,1\n2,1\n1,1\n", "back.csv line 4: time step"),
        ("thrice.csv", "time[s],acceleration[g]\n0,1\n1,1\n1,2\n1,1\n", "thrice.csv line 5: time step"),
        ("unit.csv", "time[s],acceleration[kg]\n0,1\n", "must be an acceleration"),
        ("word.csv", "time[s],acceleration[g]\n0,1\n1,x\n", "word.csv line 3"),
        ("misspelt.csv", "time[s],accelaration[g]\n0,1\n", "Spell it acceleration"),
        ("steps.csv", "acceleration[g]\n0\n1\n", "Give the time between samples by --time-step"),
        ("short.at2", &peer(20).replace("NPTS=  20", "NPTS=  21"), "NPTS = 21, but the file has 20 samples"),
        ("more.at2", &peer(20).replace("NPTS=  20", "NPTS=  19"), "NPTS = 19, but more samples follow"),
        (
            "glued.at2",
            &peer(20).replace("E-2   ", "E-2").replace("E-2  ", "E-2").replace("E-2 ", "E-2"),
            "must be a number: NPTS = 20",
        ),
        ("gap.at2", &peer(20).replace("DT=   .0100", "DT=   ,0100"), "gap.at2 line 4: DT"),
        ("velocity.vt2", &peer(20).replace("ACCELERATION", "VELOCITY"), "VELOCITY: must be an acceleration"),
        ("counts.at2", &peer(20).replace("UNITS OF G", "UNITS OF COUNTS"), "“COUNTS” is not a known unit"),
        ("binary.dat", "\u{0}\u{1}", "binary.dat line 1: must be text"),
        ("odd.at2", &peer(20).replace("NPTS=  20, DT=   .0100 SEC", "?"), "odd.at2 line 4"),
    ] {
        let path = file(&folder, name, text);
        refused(&format!("record {path} {ISOLATOR}"), &[said]);
    }
    let good = file(&folder, "good.at2", &peer(50));
    for (args, said) in [
        ("--mass 1kg --friction-coefficient 0.1", "A body without a spring has --no-spring"),
        (
            "--mass 1kg --period 1s --no-spring --friction-coefficient 0.1",
            "must be left out with --no-spring",
        ),
        ("--mass 1kg --no-spring --damping-ratio 5% --friction-coefficient 0.1", "no critical damping"),
        (
            "--mass 1kg --no-spring --friction-coefficient 0.1 --slope 90deg",
            "slope = 90°: must be > -90° and < 90°",
        ),
        ("--mass 1kg --period 1s --friction-coefficient 0.1 --scale x", "--scale x"),
        ("--mass 1kg --period 1s --friction-coefficient 0.1 --from 3s --to 2s", "--from 3s --to 2s"),
        ("--mass 1kg --period 1s --friction-coefficient 0.1 --time-step 1s", "must be left out"),
        ("--mass 1kg --period 1s --friction-coefficient 0.1 --frequency 2Hz", "--frequency"),
    ] {
        refused(&format!("record {good} {args}"), &[said]);
    }
}

/// The unit of a file is obeyed, the answer says what was read, and a text without a header takes the rest from options.
#[test]
fn what_was_read_stands_in_the_answer() {
    let folder = folder();
    let text = peer(100);
    let g = file(&folder, "g.at2", &text);
    let gal = file(&folder, "gal.at2", &text.replace("UNITS OF G", "UNITS OF GAL"));
    let found = json(&format!("record {g} {ISOLATOR} --format json"));
    let record = &found["record"];
    let peak = text.split_whitespace().skip(12).map(|word| word.parse::<f64>().unwrap_or(0.0));
    let peak = peak.fold(0.0f64, |peak, value| if value.abs() > peak.abs() { value } else { peak });
    assert_eq!(record["kind"], "PEER");
    assert_eq!(record["samples"], 100);
    assert_eq!(record["time_step"], 0.01);
    assert_eq!(record["peak"], peak);
    assert_eq!(record["unit"], "g");
    let sentence = format!("Record (PEER): 100 samples of acceleration 0.01 s apart, 0.99 s; peak {peak:.6}");
    let answer = stdout(&format!("record {g} {ISOLATOR}"));
    assert!(answer.lines().nth(1).unwrap().starts_with(&sentence[..sentence.len() - 2]), "{answer}");
    // 1 gal is 1/980.665 g.
    let scaled = json(&format!("record {gal} {ISOLATOR} --scale 980.665 --format json"));
    let (one, other) = (found["path"].as_f64().unwrap(), scaled["path"].as_f64().unwrap());
    assert!((one / other - 1.0).abs() < 1e-12 && one > 0.0, "{one} {other}");
    let samples: Vec<&str> = text.lines().skip(4).flat_map(str::split_whitespace).collect();
    let plain = file(&folder, "plain.txt", &samples.join("\n"));
    let rows = file(
        &folder,
        "rows.txt",
        &format!("a title\n2 lines\n{}", text.lines().skip(4).collect::<Vec<_>>().join("\n")),
    );
    for args in [
        format!("record {plain} --time-step 0.01s --record-units g"),
        format!("record {rows} --time-step 0.01s --record-units g --skip 2 --column all"),
    ] {
        let own = json(&format!("{args} {ISOLATOR} --format json"));
        assert_eq!(own["path"], found["path"], "{args}");
    }
    for (args, said) in [
        (format!("record {plain}"), "plain.txt: states no unit. Give it by --record-units, such as g"),
        (format!("record {plain} --record-units g"), "Give the time between samples by --time-step"),
        (format!("record {plain} --record-units bushel --time-step 1s"), "“bushel” is not a known unit"),
        (format!("record {rows} --skip 2 --record-units g --time-step 1s"), "Choose one by --column"),
        (format!("record {g} --record-units g"), "--record-units g: must be left out"),
    ] {
        refused(&format!("{args} {ISOLATOR}"), &[said]);
    }
}

/// The greatest responses of oscillators on the body, beside small steps of the history of its absolute acceleration.
#[test]
fn a_floor_spectrum_is_that_of_the_history() {
    let folder = folder();
    let quake = file(&folder, "quake.at2", &peer(401));
    let motion = folder.join("motion.csv").display().to_string();
    let args = format!("record {quake} {ISOLATOR} --units kN,mm --floor-spectrum 0.1s,0.7s");
    let found = json(&format!("{args} --floor-damping 2% --format json --out {motion} --interval 0.1ms"));
    let spectrum = &found["floor_spectrum"];
    assert_eq!((spectrum["damping_ratio"].as_f64(), &spectrum["units"]["period"]), (Some(0.02), &"s".into()));
    let text = fs::read_to_string(&motion).unwrap();
    let history: Vec<[f64; 2]> = text
        .lines()
        .skip(1)
        .map(|row| [0, 5].map(|place| row.split(',').nth(place).unwrap().parse().unwrap()))
        .collect();
    for (row, period) in spectrum["rows"].as_array().unwrap().iter().zip([0.1, 0.7]) {
        assert_eq!(row["period"].as_f64(), Some(period));
        let (square, rate) =
            ((std::f64::consts::TAU / period).powi(2), 0.04 * std::f64::consts::TAU / period);
        // y″ = −A − 2ζνy′ − ν²y by the midpoint rule.
        let ([mut y, mut u], mut most) = ([0.0f64; 2], [0.0f64; 2]);
        for pair in history.windows(2) {
            let [[from, one], [to, two]] = [pair[0], pair[1]];
            let h = to - from;
            let slope = |a: f64, y: f64, u: f64| -a - rate * u - square * y;
            let (y_half, u_half) = (y + h / 2.0 * u, u + h / 2.0 * slope(one, y, u));
            (y, u) = (y + h * u_half, u + h * slope((one + two) / 2.0, y_half, u_half));
            most = [most[0].max(y.abs()), most[1].max((rate * u + square * y).abs())];
        }
        let of = |name: &str| row[name].as_f64().unwrap();
        for (found, expected) in
            [(of("max_displacement"), most[0]), (of("max_absolute_acceleration"), most[1])]
        {
            assert!((found / expected - 1.0).abs() < 1e-3, "{found} {expected} of {row}");
        }
        assert!((of("pseudo_acceleration") / (square * of("max_displacement")) - 1.0).abs() < 1e-12);
    }
    let table = stdout(&format!("{args} --both-polarities"));
    assert_eq!(table.matches("Floor spectrum under ").count(), 2, "{table}");
    for (args, said) in [
        ("--floor-spectrum 0s", "--floor-spectrum 0s: the period 0 s must be > 0"),
        ("--floor-spectrum 1s:2s:99999", "99999 periods, must be ≤ 10000"),
        ("--floor-spectrum 1kg", "must be a time"),
        ("--floor-spectrum 1s --floor-damping 100%", "--floor-damping 100%: must be ≥ 0 and ≤ 0.99"),
        ("--floor-spectrum 1e-30s", "natural period T"),
        ("--floor-damping 5%", "--floor-spectrum"),
    ] {
        refused(&format!("record {quake} {ISOLATOR} {args}"), &[said]);
    }
}

/// Both polarities are the answers to a record and to the record turned, and the answer begins with the greater.
#[test]
fn both_polarities_are_a_record_and_its_mirror_image() {
    let folder = folder();
    let quake = file(&folder, "quake.at2", &peer(700));
    let block = "--mass 1t --no-spring --friction-coefficient 0.3 --slope 10deg --one-way --format json";
    let both = json(&format!("record {quake} {block} --both-polarities"));
    let alone = ["", "--scale -1"].map(|scale| json(&format!("record {quake} {block} {scale}")));
    let peak = |answer: &serde_json::Value| answer["peak_displacement"].as_f64().unwrap();
    for (name, own) in ["recorded", "mirrored"].into_iter().zip(&alone) {
        for (key, value) in both["polarities"][name].as_object().unwrap() {
            assert_eq!(value, &own[key], "{name} {key}");
        }
    }
    assert!(peak(&alone[0]) != peak(&alone[1]), "{both}");
    let greater = if peak(&alone[1]) > peak(&alone[0]) { "mirrored" } else { "recorded" };
    assert_eq!(both["polarity"], greater);
    assert_eq!(peak(&both), peak(&alone[0]).max(peak(&alone[1])));
}

/// A body that never slides backwards does not start backwards, which the refusal says by the option.
#[test]
fn a_start_against_the_way_is_refused_by_its_option() {
    let folder = folder();
    let quake = file(&folder, "quake.at2", &peer(700));
    let block = "--mass 1t --no-spring --friction 1kN --one-way --v0=-1cm/s";
    for line in [
        format!("record {quake} {block}"),
        format!("decay {block}"),
        format!("simulate {block} --shape free --duration 1s"),
    ] {
        refused(&line, &["--v0 -1cm/s: must be ≥ 0 with --one-way"]);
    }
}

/// A block by its yield acceleration is one by its coefficient, needs neither a mass nor `--no-spring`, and spectra have it
/// as a grid.
#[test]
fn a_block_is_given_by_its_yield_acceleration() {
    let folder = folder();
    let quake = file(&folder, "quake.at2", &peer(700));
    let by_name = json(&format!("record {quake} --yield-acceleration 0.1g --format json"));
    let block =
        json(&format!("record {quake} --mass 3t --no-spring --friction-coefficient 0.1 --format json"));
    let own = by_name.as_object().unwrap();
    for (name, value) in own {
        if name == "units" || name == "record" {
            continue;
        }
        match (value.as_f64(), block[name].as_f64()) {
            (Some(one), Some(two)) => assert!((one - two).abs() <= 1e-9 * two.abs(), "{name} {one} {two}"),
            (one, two) => assert_eq!(one, two, "{name}"),
        }
    }
    assert!(own["peak_displacement"].as_f64().unwrap() > 0.0);
    // Without a mass there are no forces and works.
    assert!(!own.contains_key("friction_work") && block["friction_work"].is_number());
    // Newmark's pulse: a(a − a_y)t²/(2a_y).
    let pulse = file(&folder, "pulse.csv", "time[s],acc[g]\n0,-0.3\n1,-0.3\n");
    let found = json(&format!("record {pulse} --yield-acceleration 0.1g --format json"));
    let exact = 9.80665 * 0.3 * 0.2 / 0.2;
    assert!((found["residual_displacement"].as_f64().unwrap() / exact - 1.0).abs() < 1e-13, "{found}");
    let rows = stdout(&format!("spectrum {quake} --yield-acceleration 0.05g:0.15g:3 --units N,mm"));
    let row: Vec<&str> = rows.lines().nth(2).unwrap().split(',').collect();
    let place =
        rows.lines().next().unwrap().split(',').position(|name| name == "peak_displacement[mm]").unwrap();
    let (of_spectrum, alone) =
        (row[place].parse::<f64>().unwrap(), own["peak_displacement"].as_f64().unwrap());
    assert!((of_spectrum / (alone * 1e3) - 1.0).abs() < 1e-9, "{rows}");
    for (args, said) in [
        ("--yield-acceleration=-1g", "yield acceleration a_y = -9.80665 must be ≥ 0"),
        ("--yield-acceleration 0.1g --friction 1N --mass 1kg", "must be left out with --friction 1N"),
        ("--yield-acceleration 0.1g --slope 5deg", "must be left out with a slope"),
        ("--yield-acceleration 0.1", "has no unit beside"),
        ("--period 1s --friction 1N", "--mass is missing"),
    ] {
        let args = if args.ends_with("0.1") { format!("{args} --period 1s") } else { args.to_owned() };
        refused(&format!("record {quake} {args}"), &[said]);
    }
    refused("response --omega 0.5 --alpha 2 --yield-acceleration 1g", &["does not use it"]);
}

/// With `g` behind force and length, accelerations are shown in g, and bare ones read in it: everything else stays.
#[test]
fn accelerations_are_in_g_where_asked() {
    let folder = folder();
    let quake = file(&folder, "quake.at2", &peer(400));
    let options = "--both-polarities --floor-spectrum 0.2s --format json";
    let args = format!("record {quake} {ISOLATOR} {options}");
    let (plain, in_g) = (json(&format!("{args} --units N,mm")), json(&format!("{args} --units N,mm,g")));
    let compare = |plain: &serde_json::Value, in_g: &serde_json::Value| {
        let mut scaled = 0;
        for (name, value) in plain.as_object().unwrap() {
            let (Some(one), Some(two)) = (value.as_f64(), in_g[name].as_f64()) else { continue };
            let is_acceleration = name.contains("acceleration");
            let unit = if is_acceleration { 9806.65 } else { 1.0 };
            assert!((two * unit - one).abs() <= 1e-14 * one.abs(), "{name} {one} {two}");
            scaled += u32::from(is_acceleration);
        }
        scaled
    };
    assert_eq!(compare(&plain, &in_g), 1);
    assert_eq!(compare(&plain["polarities"]["mirrored"], &in_g["polarities"]["mirrored"]), 1);
    assert_eq!(compare(&plain["floor_spectrum"]["rows"][0], &in_g["floor_spectrum"]["rows"][0]), 2);
    assert_eq!(in_g["units"]["max_absolute_acceleration"], "g");
    assert_eq!(in_g["floor_spectrum"]["units"]["pseudo_acceleration"], "g");
    // Histories, spectra and bare values.
    let history = folder.join("h.csv").display().to_string();
    stdout(&format!("record {quake} {ISOLATOR} --units N,mm,g --out {history}"));
    let text = fs::read_to_string(&history).unwrap();
    assert!(text.starts_with("time[s],displacement[mm],velocity[mm/s],acceleration[g],direction,"), "{text}");
    let greatest = text.lines().skip(1).map(|row| row.split(',').nth(5).unwrap().parse::<f64>().unwrap());
    let part = greatest.fold(0.0f64, |most, a| most.max(a.abs()))
        / in_g["max_absolute_acceleration"].as_f64().unwrap();
    assert!(part > 0.99 && part <= 1.0 + 1e-13, "{part}");
    let spectrum = |units: &str, yields: &str| {
        let rows = stdout(&format!("spectrum {quake} --yield-acceleration {yields} --units {units}"));
        let cells =
            |line: usize| rows.lines().nth(line).unwrap().split(',').map(str::to_owned).collect::<Vec<_>>();
        cells(0).into_iter().zip(cells(1)).collect::<std::collections::BTreeMap<_, _>>()
    };
    let (bare, typed) = (spectrum("N,mm,g", "0.1"), spectrum("N,mm,g", "0.1g"));
    assert_eq!(bare, typed);
    let of = |row: &std::collections::BTreeMap<String, String>, name: &str| row[name].parse::<f64>().unwrap();
    assert!((of(&bare, "yield_acceleration[g]") - 0.1).abs() < 1e-15, "{bare:?}");
    let plain = spectrum("N,mm", "980.665");
    assert!((of(&plain, "yield_acceleration[mm/s^2]") - 980.665).abs() < 1e-9);
    assert_eq!(of(&plain, "peak_displacement[mm]"), of(&bare, "peak_displacement[mm]"));
    // A column without a unit is in that of bare numbers.
    let column = file(&folder, "bare.csv", "time,acceleration\n0,-0.3\n1,-0.3\n");
    let found = json(&format!("record {column} --yield-acceleration 0.1 --units N,m,g --format json"));
    assert!(
        (found["residual_displacement"].as_f64().unwrap() / (9.80665 * 0.3) - 1.0).abs() < 1e-13,
        "{found}"
    );
    assert_eq!((found["record"]["peak"].as_f64(), &found["record"]["unit"]), (Some(-0.3), &"g".into()));
    refused("response --omega 0.5 --alpha 2 --units N,mm,g", &["--units"]);
    refused(
        "response --mass 1 --stiffness 1 --friction 1 --frequency 2 --force 3 --units N,mm,g",
        &["must be N,mm"],
    );
    refused(&format!("record {quake} {ISOLATOR} --enclose --units N,mm,g"), &["must be N,mm"]);
    refused(
        &format!("record {quake} {ISOLATOR} --units N,g"),
        &["must be a unit of force and one of length"],
    );
}

/// Records have the names of their files in spectra, with the folder where two are alike, and in pictures.
#[test]
fn records_have_names_in_spectra() {
    let folder = folder();
    fs::create_dir(folder.join("other")).unwrap();
    let (a, b) = (file(&folder, "a.at2", &peer(200)), file(&folder, "b.at2", &peer(210)));
    let other = file(&folder, "other/b.at2", &peer(220));
    let grid = "--period 0.5s,1s --friction-coefficient 0.05";
    let names = |args: &str| -> Vec<String> {
        let rows = stdout(&format!("spectrum {args} {grid}"));
        rows.lines().skip(1).map(|row| row.split(',').next().unwrap().to_owned()).collect()
    };
    assert_eq!(names(&format!("{a} {b}")), ["a.at2", "a.at2", "b.at2", "b.at2"]);
    assert_eq!(names(&format!("{b} {a} {other}")), [&b, &b, "a.at2", "a.at2", &other, &other]);
    refused(&format!("spectrum {a} {a} {grid}"), &["a.at2: must be given only once"]);
    let picture = folder.join("p.svg").display().to_string();
    stdout(&format!("spectrum --quiet {a} {b} {grid} --picture {picture}"));
    let text = fs::read_to_string(&picture).unwrap();
    assert!(["a.at2", "b.at2", "mean"].iter().all(|name| text.contains(name)), "{text}");
    assert!(!text.contains(&a));
}

/// The answer says what follows the record: by default a support stays, and an acceleration ends.
#[test]
fn the_answer_says_what_follows_the_record() {
    let folder = folder();
    let foot = file(&folder, "foot.csv", "time[s],foot-displacement[m]\n0,0\n2,0.5\n");
    let quake = file(&folder, "quake.at2", &peer(300));
    let machine = "--mass 2kg --stiffness 40N/m --friction 1N";
    for (args, line, name) in [
        (format!("{foot} {machine}"), "After the record the support stays where it is.", "hold"),
        (format!("{foot} {machine} --after zero"), "After the record the support is at 0.", "zero"),
        (format!("{foot} {machine} --after free"), "After the record the support lets go.", "free"),
        (format!("{quake} {ISOLATOR}"), "After the record the acceleration is zero.", "zero"),
        (
            format!("{quake} {ISOLATOR} --after hold"),
            "After the record the acceleration stays at its last sample.",
            "hold",
        ),
    ] {
        assert_eq!(stdout(&format!("record {args}")).lines().nth(2), Some(line), "{args}");
        assert_eq!(json(&format!("record {args} --format json"))["record"]["after"], name, "{args}");
    }
    // The sentence names the support, and the key keeps its value.
    let read = stdout(&format!("record {foot} {machine}"));
    assert!(read.contains(": 2 samples of support displacement 2 s apart"), "{read}");
    let found = json(&format!("record {foot} {machine} --format json"));
    assert_eq!(found["record"]["quantity"], "foot displacement");
    // Beside a support that stays the body rests within r/k of it, and of one that jumped back within r/k of 0.
    let rest = |after: &str| {
        let found = json(&format!("record {foot} {machine} {after} --format json"));
        found["residual_displacement"].as_f64().unwrap()
    };
    assert!((rest("") - 0.5).abs() <= 0.025 && rest("--after zero").abs() <= 0.025);
    assert!(rest("--after free") > 0.5);
    refused(&format!("record {foot} {machine} --after later"), &["--after", "zero, hold, free"]);
    // Spectra follow it, too.
    let row = stdout(&format!("spectrum {foot} --stiffness 40N/m --friction 1N --mass 1kg,2kg --after zero"));
    assert!(row.lines().nth(2).unwrap().contains(&rest("--after zero").to_string()), "{row}");
}

/// Every enclosure contains the answer at f64, to its rounding; what is not certain is an error, and a file or a picture
/// has no enclosure.
#[cfg(feature = "mp")]
#[test]
fn answers_are_enclosed() {
    let folder = folder();
    let quake = file(&folder, "quake.at2", &peer(500));
    // Critical damping, too, whose body tends to rest.
    for body in [ISOLATOR, "--mass 1t --period 1s --friction 1N --damping-ratio 100%"] {
        let found = json(&format!("record {quake} {body} --enclose --format json --units kN,mm"));
        let plain = json(&format!("record {quake} {body} --format json --units kN,mm"));
        assert_eq!(found["units"], plain["units"]);
        for (name, value) in plain.as_object().unwrap() {
            let Some(value) = value.as_f64() else { continue };
            let Some(mid) = found[name]["mid"].as_str() else {
                assert_eq!(found[name], plain[name], "{name}");
                continue;
            };
            let (mid, rad): (f64, f64) =
                (mid.parse().unwrap(), found[name]["rad"].as_str().unwrap().parse().unwrap());
            assert!((mid - value).abs() <= 1e-11 * value.abs() + 1e-13, "{name}: {mid} {value}");
            // The end of a motion that fades is as sharp as the motion was great.
            let most = name.strip_prefix("end_").map(|of| plain[format!("max_{of}")].as_f64().unwrap());
            assert!(rad <= 1e-18 * mid.abs().max(most.unwrap_or(0.0)), "{name}: {rad}");
        }
    }
    let text = stdout(&format!("record {quake} {ISOLATOR} --enclose"));
    assert!(text.contains("This is certain.") && text.contains(" ± "), "{text}");
    for look in ["--title Quake", "--size 900x600"] {
        refused(&format!("record {quake} {ISOLATOR} {look}"), &["needs a picture"]);
        refused(
            &format!("spectrum {quake} --period 1s:2s:3 --friction-coefficient 0.1 {look}"),
            &["needs a picture"],
        );
    }
    let picture = folder.join("motion.svg").display().to_string();
    stdout(&format!("record {quake} {ISOLATOR} --picture {picture} --title Quake --size 1200x700"));
    let drawn = fs::read_to_string(&picture).unwrap();
    assert!(drawn.contains("width=\"1200\" height=\"700\"") && drawn.contains("Quake\n"));
    for option in ["--out motion.csv", "--picture motion.svg"] {
        refused(
            &format!("record {quake} {ISOLATOR} --enclose {option}"),
            &["--enclose", "cannot be used with"],
        );
    }
}

/// Natural frequencies of a spectrum are answered in the unit that was typed; JSON lines, whose names have none, are in rad/s.
#[test]
fn frequencies_of_a_spectrum_have_the_unit_that_was_typed() {
    let record = place("typed.csv");
    std::fs::write(&record, "time[s],acceleration[g]\n0,0\n0.1,0.3\n0.2,-0.3\n0.3,0\n").unwrap();
    let run = format!("spectrum {} --friction-coefficient 0.05 --natural-frequency", record.display());
    let rows = |range: &str| stdout(&format!("{run} {range}"));
    let (rpm, radians) = (rows("60rpm:120rpm:2"), rows("6.283185307179586rad/s:12.566370614359172rad/s:2"));
    let (rpm, radians): (Vec<_>, Vec<_>) = (rpm.lines().collect(), radians.lines().collect());
    assert!(rpm[0].starts_with("record,natural_frequency[rpm],"), "{}", rpm[0]);
    assert!(radians[0].starts_with("record,natural_frequency[rad/s],"), "{}", radians[0]);
    assert!(rpm[1].starts_with("typed.csv,60.0,") && rpm[2].starts_with("typed.csv,120.0,"), "{rpm:?}");
    let answers = |row: &str| row.split(',').skip(2).map(str::to_owned).collect::<Vec<_>>();
    assert_eq!(answers(rpm[1]), answers(radians[1]));
    let line = stdout(&format!("{run} 60rpm --format jsonl"));
    assert!(line.contains("\"natural_frequency\":6.283185307179586"), "{line}");
    let picture = place("typed.svg");
    stdout(&format!("{run} 60rpm:120rpm:5 --picture {}", picture.display()));
    assert!(std::fs::read_to_string(&picture).unwrap().contains("natural frequency (rpm)"));
}

/// Columns of a floor spectrum stand apart at any precision.
#[cfg(feature = "mp")]
#[test]
fn columns_of_a_floor_spectrum_stand_apart() {
    let folder = folder();
    let quake = file(&folder, "floor.csv", "time[s],acceleration[g]\n0,0\n0.1,0.3\n0.2,-0.3\n0.3,0\n");
    for bits in ["", " --bits 128", " --bits 256"] {
        let text = stdout(&format!("record {quake} {ISOLATOR} --floor-spectrum 0.1s:0.3s:3{bits}"));
        let rows: Vec<_> = text.lines().skip_while(|line| !line.contains("pseudo")).collect();
        assert_eq!(rows.len(), 4, "{text}");
        for row in &rows[1..] {
            assert_eq!(row.split_whitespace().count(), 4, "{row}");
        }
    }
}

/// A body that only tends to rest is said to do that, plainly and with certainty.
#[test]
fn a_body_that_only_tends_to_rest_is_said_to() {
    let folder = folder();
    let push = file(&folder, "push.csv", "time[s],force[N]\n0,0\n1,9\n2,0\n30,0\n");
    let forms: &[&str] = if cfg!(feature = "mp") { &["", " --bits 128", " --enclose"] } else { &[""] };
    for form in forms {
        for (machine, ends) in [
            ("--friction 0 --damping 3", "only tends to rest"),
            ("--friction 1 --damping 60", "only tends to rest"),
            ("--friction 1 --damping 3", "comes to rest"),
        ] {
            let line = format!("record {push} --units N,m --mass 2 --stiffness 50 {machine}{form}");
            let text = stdout(&line);
            assert!(text.lines().next().unwrap().contains(ends), "{line}: {text}");
        }
    }
    // A step upon a critically damped body: the body creeps, and never stops.
    let events = stdout(
        "simulate --mass 1kg --stiffness 100N/m --damping-ratio 100% --friction 1N --force 20N --shape step \
         --duration 30s --format csv",
    );
    assert_eq!(events.lines().count(), 2, "{events}");
}

/// A file is described without a machine: each channel in a line, in JSON, and as a picture.
#[test]
fn a_record_is_described() {
    let file = "../tests/data/layouts/unam.txt";
    let text = stdout(&format!("record {file} --describe"));
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.len(), 3);
    assert!(lines[1].starts_with("Record (UNAM “N00E”): 45 samples of acceleration 0.02 s apart"), "{text}");
    assert!(
        lines[1].ends_with("Its Fourier amplitude is greatest at 5.664062 Hz. It has no gaps."),
        "{text}"
    );
    let found = json(&format!("record {file} --describe --format json"));
    let channel = &found["channels"][2];
    assert_eq!((channel["channel"].as_str(), channel["samples"].as_u64()), (Some("N90E"), Some(45)));
    assert_eq!(channel["peak_frequency"].as_f64(), Some(29.0 * 50.0 / 256.0));
    let folder = folder();
    let picture = folder.join("record.svg");
    stdout(&format!("record {file} --describe --picture {}", picture.display()));
    let svg = fs::read_to_string(&picture).unwrap();
    assert!(["V", "N00E", "N90E"].iter().all(|name| svg.contains(name)), "{svg}");
    refused(
        &format!("record {file} --describe --mass 3kg"),
        &["--mass 3kg: record does not use it with --describe"],
    );
    refused(&format!("record {file} --describe --scale 2"), &["--scale 2: must be left out with --describe"]);
}
