//! What has a bound, and what is said of unusual values: files, pictures of a body at rest, units, searches.

use crate::command_line::{refused, stdout, stickslip};
use crate::place::place;

/// The standard output and the notes of an answered command.
fn said(arguments: &str) -> (String, String) {
    let output = stickslip(arguments).assert().success().get_output().clone();
    (String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap())
}

/// A record with two pulses.
const PULSES: &str = "time[s],acceleration[g]\n0,0\n0.1,0.3\n0.2,-0.3\n0.3,0\n";

#[test]
fn a_body_at_rest_has_a_picture() {
    let still = place("still.csv");
    std::fs::write(&still, "time[s],force[N]\n0,0\n1,0\n2,0\n").unwrap();
    for (n, arguments) in [
        "decay --x0 0.5 --out".to_owned(),
        "decay --mass 2kg --stiffness 4kN/m --friction 3N --x0 0.1mm --out".to_owned(),
        format!("record {} --mass 1kg --stiffness 1N/m --friction 1N --picture", still.display()),
        format!("spectrum {} --period 1s:2s:3 --friction-coefficient 1 --picture", still.display()),
        "response-curve --omega 0.5:0.9:5 --alpha 2 --y-range=0:5e-324 --linear --out".to_owned(),
        "response-curve --omega 0.5:0.9:5 --alpha 2 --x-range=0.5:0.5000000000000001 --out".to_owned(),
        "map margin --omega 0.5:0.9:5 --alpha 2:3:4 --range=0:5e-324 --out".to_owned(),
        "motion-plot --mass 2kg --stiffness 4kN/m --friction 0.3N --frequency 200Hz --force 1.2N --out"
            .to_owned(),
    ]
    .into_iter()
    .enumerate()
    {
        let picture = place(&format!("{n}.svg"));
        stdout(&format!("{arguments} {} -q", picture.display()));
        let drawing = std::fs::read_to_string(&picture).unwrap();
        // A label beside an axis has a few letters.
        let texts = drawing.split("</text>").filter_map(|part| Some(part.rsplit_once(">\n")?.1.trim()));
        let numbers = texts.filter(|text| text.starts_with(|c: char| c.is_ascii_digit() || c == '−'));
        let longest = numbers.map(|text| text.chars().count()).max().unwrap_or(0);
        assert!(longest <= 24, "{arguments}: {longest}");
    }
}

#[test]
fn bare_numbers_mean_one_thing_or_are_said() {
    let record = place("pulses.csv");
    std::fs::write(&record, PULSES).unwrap();
    let run = format!("record {} --mass 800kg --period 2.2s --friction-coefficient 0.05", record.display());
    refused(&format!("{run} --slope 0.1"), &["--slope 0.1: must have a unit", "0.1deg or 0.1rad"]);
    assert_eq!(stdout(&format!("{run} --slope 0")), stdout(&format!("{run} --slope 0deg")));
    let file = place("motion.csv");
    let out = format!("--out {}", file.display());
    refused(&format!("{run} {out} --interval 0.01"), &["--interval 0.01: has no unit beside"]);
    refused(&format!("{run} {out} --interval 0s"), &["--interval 0s: must be > 0"]);
    refused(&format!("{run} {out} --interval 1e-9s"), &["--interval 1e-9s: about 6.0e8 states, must be ≤"]);
    let machine =
        "steady --mass 1kg --stiffness 400N/m --friction-coefficient 0.4 --force 20N --frequency 1rad/s";
    let (_, notes) = said(&format!("{machine} --gravity 9.8 --units N,mm"));
    assert!(notes.contains("--gravity 9.8 is 9.8 mm/s^2") && notes.contains("9.8m/s^2"), "{notes}");
    for gravity in ["9.8m/s^2", "9810", "1622", "1g"] {
        let (_, notes) = said(&format!("{machine} --gravity {gravity} --units N,mm"));
        assert!(!notes.contains("--gravity"), "{gravity}: {notes}");
    }
}

#[test]
fn answers_are_in_the_units_typed_and_in_their_words() {
    let bands = "design bands --mass 50kg --stiffness 1000N/m --friction 5N --force 12N";
    assert!(stdout(&format!("{bands} --from 10rpm --to 100rpm")).contains("10.47198 rad/s = 100 rpm"));
    assert!(stdout(&format!("{bands} --from 0.2Hz --to 1Hz")).contains("6.283185 rad/s = 1 Hz"));
    let map = "map margin --mass 50kg --stiffness 1000N/m --friction 5N --force 10N:20N:2 --frequency";
    assert!(
        stdout(&format!("{map} 60rpm:120rpm:2")).starts_with("frequency[rpm],force[N],margin\n60.0,10.0,")
    );
    assert!(stdout(&format!("{map} 1Hz:2Hz:2")).starts_with("frequency[Hz],"));
    assert!(stdout("decay --x0 1.5").starts_with("At rest after 1 half cycle.\n"));
    assert!(stdout("decay --x0 0.5").starts_with("At rest from the start.\n"));
    assert_eq!(stdout("decay --v0 7"), stdout("decay --x0 0 --v0 7"));
    refused("decay --damping-ratio 0.1", &["--x0"]);
    let record = place("pulses.csv");
    std::fs::write(&record, PULSES).unwrap();
    let run = format!("record {} --mass 800kg --period 2.2s", record.display());
    assert_eq!(stdout(&format!("{run} --friction-coefficient 0")), stdout(&format!("{run} --friction 0N")));
    refused(&format!("{run} --friction-coefficient=-0.1"), &["--friction-coefficient -0.1", "must be ≥ 0"]);
}

#[test]
fn messages_name_the_argument_and_its_limits() {
    let file = place("small.svg");
    let out = format!("--out {}", file.display());
    refused("steady --omega 0.5 --alpha 3 --max-periods 1.5", &["--max-periods 1.5: must be a whole number"]);
    refused(
        "steady --omega 0.5 --alpha 3 --max-periods 99999999999999999999",
        &["must be a smaller whole number"],
    );
    // A body that stays at rest is drawn, and one that comes to rest with its way there.
    for line in ["--omega 0.5 --alpha 0.5", "--omega 0.5 --alpha 0.5 --x0 9"] {
        let svg = stdout(&format!("motion-plot {line}"));
        assert!(svg.contains("Motion to its rest") && svg.contains("at rest"), "{line}");
        assert_eq!(svg.contains("sliding"), line.contains("x0"), "{line}");
    }
    refused("motion-plot --omega 1 --alpha 3", &["motion-plot: there is no periodic motion to draw."]);
    refused("map foo", &["limits", "an output of response"]);
    let plot = "motion-plot --omega 0.15 --alpha 3";
    refused(&format!("{plot} {out} --size 50x50"), &["--size 50x50: must be from 497x466", "to 10000x10000"]);
    let due = "must be from ";
    let refusal = stickslip(&format!("{plot} {out} --size 50x50")).output().unwrap();
    let message = String::from_utf8(refusal.stderr).unwrap();
    let least = message.split(due).nth(1).unwrap().split(',').next().unwrap();
    stdout(&format!("{plot} {out} --size {least}"));
}

/// White on a map of machines is a body that never moves, and its key says so.
#[test]
fn white_is_what_the_key_says() {
    let machine = "--mass 800kg --period 2.2s --friction-coefficient 0.05 --frequency 1Hz:3Hz:4";
    let key = |quantity: &str, accelerations: &str| {
        let file = place("key.svg");
        stdout(&format!(
            "map {quantity} {machine} --base-acceleration {accelerations} --out {}",
            file.display()
        ));
        let drawing = std::fs::read_to_string(&file).unwrap();
        drawing.lines().find(|line| line.starts_with("white: ")).map(str::to_owned)
    };
    let stroke = "steady:max_displacement_phase";
    assert_eq!(key(stroke, "0.02g:0.4g:5").as_deref(), Some("white: the body never moves"));
    assert_eq!(key(stroke, "0.1g:0.4g:5"), None);
}

/// The key names what the missing cells of the rows are: their regimes, or the limits of their motions.
#[test]
fn white_has_every_reason_of_its_cells() {
    let machine = "--mass 800kg --period 2.2s --friction-coefficient 0.05 --frequency 0.2Hz:3Hz:6";
    let drives = "--base-acceleration 0.02g:0.4g:5";
    for (quantity, of, static_friction) in [
        ("max_displacement", "sweep response", ""),
        ("contraction", "sweep response", "--static-friction-ratio 1.4"),
        ("steady:max_displacement_phase", "sweep steady", ""),
        ("steady:max_velocity_phase", "sweep steady", "--static-friction-ratio 3 --damping-ratio 2%"),
        // A force has no absolute displacement of a base.
        ("steady:max_absolute_displacement", "sweep steady", ""),
    ] {
        let name = quantity.split(':').next_back().unwrap();
        let drives = if name.contains("absolute") { "--force 200N:4kN:5" } else { drives };
        let file = place("reasons.svg");
        let machine = format!("{machine} {drives} {static_friction}");
        stdout(&format!("map {quantity} {machine} -q --out {}", file.display()));
        let drawing = std::fs::read_to_string(&file).unwrap();
        let key = drawing.lines().find_map(|line| line.strip_prefix("white: "));
        let kind = if of.ends_with("steady") { "limit" } else { "regime" };
        let values = stdout(&format!("map {quantity} {machine} -q"));
        let rows = stdout(&format!("{of} {machine} -q --outputs {kind},omega"));
        let missing = values.lines().filter(|row| row.ends_with(','));
        let missing = missing.map(|row| row.split(',').take(2).collect::<Vec<_>>().join(","));
        let at = |row: &String| values.lines().position(|other| other.starts_with(&format!("{row},")));
        // The rows of a sweep are in another order: the drive varies fastest.
        let mut due: Vec<&str> = missing
            .map(|row| {
                let place = at(&row).unwrap() - 1;
                let place = place % 6 * 5 + place / 6;
                match rows.lines().nth(place + 1).unwrap().split(',').next().unwrap() {
                    "sticking" => "the body sticks",
                    "stuck" | "rest" => "the body never moves",
                    "depends-on-start" => "depends on the start",
                    "irregular" | "none" | "not-converged" => "no periodic motion",
                    _ => "no such value",
                }
            })
            .collect();
        due.sort_unstable();
        due.dedup();
        let mut found: Vec<&str> = key.map_or(Vec::new(), |key| key.split(", ").collect());
        found.sort_unstable();
        assert_eq!(found, due, "{quantity} {machine}");
    }
}

/// A body without an answer is a row without numbers, and its reason is said; the others have theirs.
#[test]
fn one_bad_body_is_one_row() {
    let record = place("pulses.csv");
    std::fs::write(&record, PULSES).unwrap();
    let spectrum = format!("spectrum {} --friction-coefficient 0.05 --period", record.display());
    let (rows, notes) = said(&format!("{spectrum} 1s,1e-300s,2s"));
    let rows: Vec<&str> = rows.lines().collect();
    let good = stdout(&format!("{spectrum} 1s,2s -q"));
    let good: Vec<&str> = good.lines().collect();
    assert_eq!((rows[0], rows[1], rows[3]), (good[0], good[1], good[2]));
    assert!(rows[2].trim_end_matches(',').ends_with("1e-300,0.05") || rows[2].contains("1e-300"), "{rows:?}");
    assert!(rows[2].ends_with(",,,,"), "{}", rows[2]);
    assert!(notes.contains("no answer") && notes.contains("--period 1e-300"), "{notes}");
    refused(&format!("{spectrum}=-1s,-2s"), &["--period"]);
}

/// A file that is replaced keeps its modes; what a killed command left is removed, and other files are not.
#[cfg(unix)]
#[test]
fn files_keep_their_modes_and_no_parts_are_left() {
    use std::os::unix::fs::PermissionsExt as _;
    let file = place("figure.svg");
    let figure = format!("figure 8 --out {}", file.display());
    stdout(&figure);
    std::fs::set_permissions(&*file, std::fs::Permissions::from_mode(0o600)).unwrap();
    let beside = |suffix: &str| file.with_extension(format!("svg.{suffix}"));
    // A process of this number cannot exist.
    let left = [beside("4194399-0.part"), beside("4194399-17.part")];
    let others = [beside("part"), beside("notes-0.part"), beside(&format!("{}-0.part", std::process::id()))];
    left.iter().chain(&others).for_each(|path| std::fs::write(path, "").unwrap());
    stdout(&format!("{figure} --overwrite"));
    assert_eq!(std::fs::metadata(&*file).unwrap().permissions().mode() & 0o777, 0o600);
    assert!(left.iter().all(|path| !path.exists()) && others.iter().all(|path| path.exists()));
}

/// A file without an end is refused.
#[cfg(target_os = "linux")]
#[test]
fn a_file_without_an_end_is_refused() {
    for command in ["record", "spectrum"] {
        let machine = "--period 2s --friction-coefficient 0.05";
        let mass = if command == "record" { "--mass 1kg" } else { "" };
        refused(&format!("{command} /dev/zero {machine} {mass}"), &["/dev/zero", "must be"]);
    }
}

/// Searches among very many oscillations end, and much damping is no obstacle.
#[test]
fn searches_of_peaks_end() {
    let begin = std::time::Instant::now();
    stdout("steady --omega 1e-3 --alpha 100 --damping-ratio 400000%");
    stdout("steady --omega 1e-4 --alpha 3");
    assert!(begin.elapsed().as_secs() < 20, "{:?}", begin.elapsed());
}

/// A mass without a unit beside values with units is in the named system's own unit, and that is said.
#[test]
fn a_bare_mass_beside_units_is_said() {
    let body = "--stiffness 0.8N/mm --friction 3N --frequency 3Hz --force 12N";
    for (mass, units, due) in [
        ("0.002", "N,mm", "--mass 0.002 is 0.002 t, because a bare number is in the units of --units N,mm"),
        ("0.002", "kip,in", "--mass 0.002 is 0.002 kip·s²/in, 772.1772 lb, because"),
    ] {
        let (_, notes) = said(&format!("response --mass {mass} {body} --units {units}"));
        assert!(notes.contains(due) && notes.contains("A mass in kg is --mass 0.002kg"), "{notes}");
    }
    for line in [
        format!("response --mass 2kg {body} --units N,mm"),
        "response --mass 2 --stiffness 800 --friction 3 --frequency 19 --force 12 --units N,m".to_owned(),
        "response --mass 0.002 --stiffness 0.8 --friction 3 --frequency 19 --force 12 --units N,mm"
            .to_owned(),
    ] {
        let (_, notes) = said(&line);
        assert!(!notes.contains("--mass"), "{line}: {notes}");
    }
    // Units of the columns of a file are units, too.
    let peaks = place("mass.csv");
    std::fs::write(&peaks, "peak[mm]\n40\n33.1\n26.5\n20.2\n14.1\n").unwrap();
    let (_, notes) =
        said(&format!("identify --decay {} --mass 0.03 --stiffness 12 --units N,mm", peaks.display()));
    assert!(notes.contains("--mass 0.03 is 0.03 t"), "{notes}");
}

/// A measured motion of another body is refused in little time, whatever the mass.
#[test]
fn a_motion_of_another_mass_is_refused() {
    let file = place("other.csv");
    let row = |i: u32| {
        let t = 0.01 * f64::from(i);
        format!("{t},{},{}", 12.0 * (14.0 * t).sin(), 20.0 * (14.0 * t - 0.5).sin())
    };
    let rows: Vec<String> = (0..400).map(row).collect();
    std::fs::write(&file, format!("time[s],force[N],displacement[mm]\n{}\n", rows.join("\n"))).unwrap();
    for (mass, due) in [("2e-9kg", "natural frequency ω_n = 632455.532033675"), ("2e9kg", "explain it")] {
        let line = format!("identify --motion {} --mass {mass} --stiffness 800N/m", file.display());
        refused(&line, &[due]);
    }
}
