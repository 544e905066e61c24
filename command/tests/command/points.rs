//! The columns of a file of points: known ones are used, and a note names the others.

use crate::command_line::{json, refused, stickslip};
use crate::place::{Place, place};

/// A file of points and its name.
fn file(text: &str) -> (Place, String) {
    let file = place("points.csv");
    std::fs::write(&file, text).unwrap();
    let name = file.display().to_string();
    (file, name)
}

/// The answers as JSON, and standard error.
fn answers(line: &str) -> (Vec<serde_json::Value>, String) {
    let assert = stickslip(line).assert().success();
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
    let output = assert.get_output();
    let rows = text(&output.stdout).lines().map(|row| serde_json::from_str(row).unwrap()).collect();
    (rows, text(&output.stderr))
}

#[test]
fn a_start_is_a_column() {
    let (_file, points) = file("omega,alpha,x0,v0\n0.5,6,2,0.2\n0.5,6,0,0\n0.5,6,-3,1\n");
    let (rows, notes) = answers(&format!("steady --points {points}"));
    assert_eq!(notes, "");
    for (row, start) in rows.iter().zip(["--x0 2 --v0 0.2", "", "--x0 -3 --v0 1"]) {
        let single = json(&format!("steady --omega 0.5 --alpha 6 {start} --format json"));
        assert_eq!(row["max_displacement"], single["max_displacement"], "{start}");
    }
    assert_ne!(rows[0]["max_displacement"], rows[1]["max_displacement"]);
    let twice = format!("steady --points {points} --x0 1");
    refused(&twice, &["column x0 must be left out, or --x0"]);
    // Of a machine, in its units.
    let machine = "--mass 800kg --period 2.2s --friction 500N --frequency 0.227272727272727272Hz --force 3kN";
    let (_file, points) = file("x0[mm],V0[m/s]\n40,0.1\n0,0\n");
    let (rows, notes) = answers(&format!("steady {machine} --points {points}"));
    assert_eq!(notes, "");
    let single = json(&format!("steady {machine} --x0 40mm --v0 0.1m/s --format json"));
    assert_eq!(rows[0]["physical"]["max_displacement"], single["physical"]["max_displacement"]);
}

/// Rows of `attractors --rows` are points of `steady`, with their starts.
#[test]
fn rows_of_starts_are_points() {
    let machine = "--omega 0.573 --alpha 3.92 --damping-ratio 0.005 --static-friction-ratio 1.87";
    let (_file, rows) = file("");
    std::fs::remove_file(&rows).unwrap();
    stickslip(&format!("attractors {machine} --starts 4 --rows {rows}")).assert().success();
    let (found, notes) = answers(&format!("steady --points {rows}"));
    assert_eq!(notes.lines().count(), 1, "{notes}");
    let unread = "columns max_periods, bits, half_turns, x, v, velocity_distance are not used";
    assert!(notes.starts_with("stickslip: note: ") && notes.contains(unread), "{notes}");
    for (row, text) in found.iter().zip(std::fs::read_to_string(&rows).unwrap().lines().skip(1)) {
        let cells: Vec<&str> = text.split(',').collect();
        let start = format!("--x0 {} --v0 {}", cells[6], cells[7]);
        let single = json(&format!("steady {machine} {start} --format json"));
        assert_eq!(row["max_displacement"], single["max_displacement"], "{start}");
    }
    assert_eq!(found.len(), 4);
}

#[test]
fn a_note_names_the_columns_that_are_not_used() {
    let (_file, points) = file("omega,alpha,zeta,Sample No\n1.5,2.5,0.1,1\n1.5,3,0.1,2\n");
    for command in ["response", "steady"] {
        let (rows, notes) = answers(&format!("{command} --points {points}"));
        assert_eq!(notes.lines().count(), 2, "{notes}");
        assert!(notes.contains("column zeta is read as damping_ratio"), "{notes}");
        assert!(notes.contains("column Sample No is not used"), "{notes}");
        assert_eq!(rows[0]["damping_ratio"], 0.1);
        let (same, silent) = answers(&format!("{command} --points {points} --quiet"));
        assert_eq!((same, silent), (rows, String::new()));
    }
    // A border has no force.
    let (_, notes) = answers(&format!("border --points {points}"));
    assert!(notes.contains("columns alpha, Sample No are not used"), "{notes}");
    refused(&format!("response --points {points} --damping-ratio 0.2"), &["column zeta", "--damping-ratio"]);
}

/// Spreadsheets write names with capitals and units, and this command writes `omega[1]`.
#[test]
fn a_column_is_known_in_any_case_and_with_its_unit() {
    let (_file, points) = file("Omega[1],ALPHA[1]\n1.5,2.5\n");
    let (rows, notes) = answers(&format!("response --points {points}"));
    assert_eq!((rows[0]["alpha"].as_f64(), notes.as_str()), (Some(2.5), ""));
    let (_file, machine) =
        file("Mass[kg],Stiffness[kN/m],Friction[N],Frequency[Hz],Base acceleration[g]\n800,10,500,2,0.15\n");
    let (rows, notes) = answers(&format!("response --points {machine}"));
    assert_eq!((rows[0]["physical"]["frequency"].as_f64(), notes.as_str()), (Some(2.0), ""));
}

/// Files of spreadsheets in countries where a decimal has a comma.
#[test]
fn semicolons_and_decimal_commas_are_named() {
    let (_file, points) = file("omega;alpha\n0,5;2\n");
    let line = format!("response --points {points}");
    refused(&line, &["column omega (or --omega) is missing", "separated by commas", "with a point"]);
    let (_file, points) = file("omega,alpha\n0,5,2\n");
    refused(&format!("response --points {points}"), &["3 fields, must be 2", "A decimal needs a point"]);
    let (_file, points) = file("omega,alpha\n\"0,5\",2\n");
    refused(&format!("response --points {points}"), &["omega 0,5: must be a number", "decimal point"]);
    let (_file, points) = file("omega,alpha\n0.5,\n");
    refused(&format!("response --points {points}"), &["line 2: alpha: must be a number, but is empty"]);
}
