//! `stickslip sweep` from the user's side.

mod resumed;

use crate::command_line::{refused, stdout, stickslip};
use crate::place::place;
use serde_json::Value;
#[cfg(feature = "mp")]
use stickslip::Float as _;

#[test]
fn a_sweep_answers_each_point_in_order_as_the_command_does() {
    let sweep = stdout("sweep response --omega 0.5:2:31 --alpha 1.1:9:41");
    let points: Vec<&str> = sweep.lines().skip(1).collect();
    assert_eq!(points.len(), 31 * 41);
    let csv: String =
        points.iter().map(|row| row.splitn(3, ',').take(2).collect::<Vec<_>>().join(",") + "\n").collect();
    let one_by_one = stickslip("response --points - --format csv")
        .write_stdin(format!("omega,alpha\n{csv}"))
        .assert()
        .success()
        .get_output()
        .stdout
        .clone();
    assert_eq!(sweep, String::from_utf8(one_by_one).unwrap());
    // Ω varies slowest, and the ends of a grid are exact.
    assert!(points[0].starts_with("0.5,1.1,") && points[40].starts_with("0.5,9.0,"));
    assert!(points[41].starts_with("0.55,1.1,") && points[31 * 41 - 1].starts_with("2.0,9.0,"));
}

/// The energy of the second point is beyond the largest number in N·m: it is a row without an answer, and its reason is said.
#[test]
fn a_point_without_an_answer_is_one_row_with_its_reason() {
    let machine =
        "--mass 1 --stiffness 1e-7 --friction 1e149 --alpha 5 --omega 0.5,0.9999999,1.5 --units N,m";
    for (question, column, is_known) in
        [("response", "physical.energy_per_cycle", true), ("steady", "energy_in", false)]
    {
        let asked = format!("sweep {question} {machine} --outputs omega,alpha,{column} --format jsonl");
        let output = stickslip(&asked).assert().success().get_output().clone();
        let rows: Vec<Value> =
            output.stdout.split(|b| *b == b'\n').filter_map(|row| serde_json::from_slice(row).ok()).collect();
        assert_eq!(rows.len(), 3, "{asked}");
        for (row, omega) in rows.iter().zip([0.5, 0.9999999, 1.5]) {
            assert_eq!((&row["omega"], &row["alpha"]), (&Value::from(omega), &Value::from(5.0)));
        }
        if !is_known {
            assert!(rows[0]["energy_in"].is_number() && rows[2]["energy_in"].is_number());
            assert!(rows[1]["energy_in"].is_null());
        }
        let said = String::from_utf8(output.stderr).unwrap();
        assert!(said.contains("note: no answer: ") && said.contains("--omega 0.9999999"), "{said}");
        assert!(said.contains("must be finite"), "{said}");
        // Alone, it is an error.
        let alone = asked.replace("sweep ", "").replace("0.5,0.9999999,1.5", "0.9999999");
        let alone = alone.split(" --outputs").next().unwrap().to_owned();
        refused(&alone, &["must be finite"]);
    }
    // In ratios that point has a loop, and in joules none.
    for (name, missing) in [("energy_per_cycle", 2), ("loop_size_stiffness", 0)] {
        let asked = format!("map {name} {}", machine.replace("--alpha 5", "--alpha 5,6"));
        let output = stickslip(&asked).assert().success().get_output().clone();
        let map = String::from_utf8(output.stdout).unwrap();
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(map.lines().filter(|row| row.ends_with(',')).count(), missing, "{map}");
        assert_eq!(said.matches("--omega 0.9999999 --alpha").count(), missing, "{said}");
    }
}

/// Outputs of a batch's loops have the digits of the rows with all columns, which are computed one by one.
#[test]
fn a_sweep_and_a_map_by_loops_have_the_digits_of_whole_rows() {
    let names = "velocity_phase,regime,omega,max_displacement,deviation,alpha,min_force_ratio,\
                 loop_size_stiffness,loop_size_inertia,displacement_phase,max_velocity";
    let ratios = "--omega 0.35:2.3:40 --alpha 0.5:9:18";
    for machine in [
        ratios,
        &format!("{ratios} --damping-ratio 5%"),
        &format!("{ratios} --damping-ratio 0,0.3,0.9 --static-friction-ratio 1,1.2"),
        "--mass 50kg --stiffness 3kN/m --friction 5N --damping-ratio 0,0.05 --frequency 0.4Hz:3Hz:40 --force 4N:60N:9",
    ] {
        let sweep = format!("sweep response {machine}");
        let (whole, some) = (stdout(&sweep), stdout(&format!("{sweep} --outputs {names}")));
        let columns: Vec<&str> = whole.lines().next().unwrap().split(',').collect();
        let places = names.split(',').map(|name| columns.iter().position(|column| *column == name).unwrap());
        let places: Vec<_> = places.collect();
        assert_eq!(whole.lines().count(), some.lines().count());
        for (whole, some) in whole.lines().zip(some.lines()) {
            let cells: Vec<&str> = whole.split(',').collect();
            assert_eq!(places.iter().map(|&place| cells[place]).collect::<Vec<_>>().join(","), some);
        }
    }
    let grids = "--omega 0.35:2.3:40 --alpha 0.5:9:18 --damping-ratio 5%";
    for name in ["max_velocity", "regime"] {
        let map = stdout(&format!("map {name} {grids}"));
        let rows = stdout(&format!("sweep response {grids} --outputs omega,alpha,{name},contraction"));
        let value = |row: &str| row.split(',').nth(2).unwrap().to_owned();
        let mut due: Vec<_> = rows.lines().skip(1).collect();
        // A map runs along Ω first.
        due.sort_by_key(|row| row.split(',').nth(1).unwrap().parse::<f64>().unwrap().to_bits());
        let due: Vec<_> = due.into_iter().map(value).collect();
        assert_eq!(map.lines().skip(1).map(value).collect::<Vec<_>>(), due, "{name}");
    }
}

/// So have a machine's values in units, which the loops give in ratios.
#[test]
fn a_machine_in_units_by_loops_has_the_digits_of_whole_rows() {
    let machine = "--mass 50kg --stiffness 3kN/m --friction 5N --frequency 0.2Hz:3Hz:40 --force 4N:60N:9";
    let names =
        ["max_displacement", "frequency", "force_amplitude", "min_force", "energy_per_cycle", "max_velocity"];
    for (damper, excitation) in [("0,0.05", ""), ("0.05", ""), ("0", ""), ("0.05", "cm")] {
        let sweep = match excitation {
            "" => format!("sweep response {machine} --damping-ratio {damper}"),
            _ => format!(
                "sweep response {} --damping-ratio {damper}",
                machine.replace("--force 4N:60N:9", "--base-displacement 1cm:20cm:9")
            ),
        };
        let asked = names.map(|name| format!("physical.{name}")).join(",");
        let (whole, some) = (stdout(&sweep), stdout(&format!("{sweep} --outputs alpha,regime,{asked}")));
        let columns: Vec<&str> = whole.lines().next().unwrap().split(',').collect();
        let place = |name: &str| columns.iter().position(|column| column.split('[').next() == Some(name));
        let in_units = |name: &str| columns.iter().position(|column| column.starts_with(&format!("{name}[")));
        let places: Vec<_> = [place("alpha"), place("regime")]
            .into_iter()
            .chain(names.map(in_units))
            .map(Option::unwrap)
            .collect();
        assert_eq!(whole.lines().count(), some.lines().count());
        for (whole, some) in whole.lines().zip(some.lines()) {
            let cells: Vec<&str> = whole.split(',').collect();
            assert_eq!(places.iter().map(|&place| cells[place]).collect::<Vec<_>>().join(","), some);
        }
    }
    for name in ["max_displacement", "min_force", "force_amplitude"] {
        let grids = format!("{machine} --damping-ratio 5%");
        let map = stdout(&format!("map {name} {grids}"));
        let rows = stdout(&format!("sweep response {grids} --outputs contraction,physical.{name}"));
        let value = |row: &str| row.rsplit(',').next().unwrap().to_owned();
        let (map, rows): (Vec<_>, Vec<_>) =
            (map.lines().skip(1).map(value).collect(), rows.lines().skip(1).map(value).collect());
        assert_eq!((map.len(), rows.len()), (360, 360));
        // A map runs along the frequency first, a sweep along the force.
        for (i, cell) in map.iter().enumerate() {
            assert_eq!(*cell, rows[i % 40 * 9 + i / 40], "{name} {i}");
        }
    }
}

#[test]
fn steady_and_border_are_swept_too() {
    let steady = stdout("sweep steady --omega 0.4 --alpha 6,7 --format jsonl");
    let rows: Vec<Value> = steady.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(
        (rows[0]["sticks_per_cycle"].as_u64(), rows[1]["sticks_per_cycle"].as_u64()),
        (Some(2), Some(0))
    );
    let border = stdout("sweep border --omega 0.4,0.45 --outputs min_force_ratio,omega");
    let rows: Vec<&str> = border.lines().collect();
    assert_eq!(rows[0], "min_force_ratio,omega");
    assert!(rows[1].starts_with("6.94973775590873") && rows[1].ends_with(",0.4"), "{border}");
    assert!(rows[2].starts_with("4.14019511498566"), "{border}");
}

#[test]
fn a_grid_can_have_equal_ratios() {
    let rows = stdout("sweep border --omega 0.01:100:5:log --outputs omega --no-header");
    let values: Vec<f64> = rows.lines().map(|row| row.parse().unwrap()).collect();
    assert_eq!((values[0], values[4], values.len()), (0.01, 100.0, 5));
    for pair in values.windows(2) {
        assert!((pair[1] / pair[0] / 10.0 - 1.0).abs() < 1e-14, "{values:?}");
    }
}

#[test]
fn the_shards_one_after_the_other_are_the_whole() {
    for format in ["csv", "jsonl"] {
        let sweep = format!("sweep steady --omega 0.3:1.3:13 --alpha 1.5:8:23 --format {format}");
        let whole = stdout(&sweep);
        for parts in [1, 2, 7] {
            let joined: String = (1..=parts)
                .map(|part| {
                    let header = if part == 1 { "" } else { "--no-header" };
                    stdout(&format!("{sweep} --shard {part}/{parts} {header}"))
                })
                .collect();
            assert!(joined == whole, "{format}, {parts} parts");
        }
    }
}

/// A map of steady states from Ω = 0.1, many with stops: no answer depends on the cells computed before it.
#[test]
fn a_map_with_stops_is_the_same_by_shards_and_threads() {
    let run = |arguments: &str, threads: u32| {
        let mut command = stickslip(arguments);
        let output = command.env("RAYON_NUM_THREADS", threads.to_string()).assert().success();
        String::from_utf8(output.get_output().stdout.clone()).unwrap()
    };
    for damping in ["", "--damping-ratio 0.05", "--damping-ratio 0.4"] {
        let sweep = format!("sweep steady --omega 0.1:2:24 --alpha 1.05:10:20 {damping}");
        let whole = run(&sweep, 1);
        let column = whole.lines().next().unwrap().split(',').position(|name| name == "sticks_per_cycle");
        let stops = |row: &&str| row.split(',').nth(column.unwrap()).is_some_and(|n| n.parse() != Ok(0));
        assert!(whole.lines().skip(1).filter(stops).count() > 100, "{damping}");
        assert!(run(&sweep, 3) == whole, "{damping}: three threads");
        for parts in [2, 5] {
            let header = |part| if part == 1 { "" } else { "--no-header" };
            let joined: String = (1..=parts)
                .map(|part| run(&format!("{sweep} --shard {part}/{parts} {}", header(part)), 1 + part % 3))
                .collect();
            assert!(joined == whole, "{damping}: {parts} parts");
        }
    }
}

#[test]
fn bad_input_is_one_line_with_argument_value_and_inequality() {
    for (arguments, parts) in [
        ("response --omega 0.5:2:0 --alpha 2", vec!["--omega 0.5:2:0", "count", "≥ 1"]),
        ("response --omega 0.5:2 --alpha 2", vec!["--omega 0.5:2", "FROM:TO:COUNT"]),
        ("response --omega 0.5:2:5:lin --alpha 2", vec!["--omega 0.5:2:5:lin", "FROM:TO:COUNT:log"]),
        ("response --omega 0.5,x --alpha 2", vec!["--omega 0.5,x", "number"]),
        ("response --omega 0.5 --alpha nan", vec!["--alpha nan", "finite"]),
        ("response --omega 0:2:5:log --alpha 2", vec!["--omega 0:2:5:log", "> 0"]),
        ("response --omega -1:2:5 --alpha 2", vec!["--omega -1", "must be > 0"]),
        ("response --omega 1,2 --alpha 3,0", vec!["--alpha 0", "must be > 0"]),
        ("response --omega 1,2", vec!["--alpha is missing"]),
        ("border --omega 1,2 --alpha 2", vec!["--alpha", "must be left out"]),
        ("steady --omega 1e-9:1:3 --alpha 2", vec!["--omega 1e-9", "≥"]),
        (
            "response --omega 1:2:5 --alpha 2 --outputs omega,speed",
            vec!["--outputs speed", "Choose from omega,"],
        ),
        ("response --omega 1:2:5 --alpha 2 --format text", vec!["--format", "csv, jsonl, parquet"]),
        ("response --omega 1:2:5 --alpha 2 --shard 0/3", vec!["--shard 0/3", "1 ≤ I ≤ N"]),
        ("response --omega 1:2:5 --alpha 2 --shard 4/3", vec!["--shard 4/3", "1 ≤ I ≤ N"]),
        ("response --omega 1:2:5 --alpha 2 --shard -1", vec!["--shard -1", "I/N"]),
        ("response --omega 1:2:5 --alpha 2 --outputs omega,alpha,omega", vec!["--outputs omega", "once"]),
        ("response --omega 1:2:5 --alpha 2 --resume", vec!["--resume", "--out"]),
        ("response --omega 1:2:5 --alpha 2 --out /dev/full --resume", vec!["/dev/full", "regular file"]),
        ("response --omega 1:2:5 --alpha 2 --out /dev/null", vec!["/dev/null", "must not exist yet"]),
        ("response --omega 1:2:5 --alpha 2 --out rows.xlsx", vec!["--out rows.xlsx", ".csv", "--format"]),
        ("response --omega 1:2:5 --alpha 2 --out /nowhere/at/all.csv", vec!["--out /nowhere/at/all.csv"]),
    ] {
        refused(&format!("sweep {arguments}"), &parts);
    }
}

/// With many bits the grid itself has that precision, and numbers keep all their digits.
#[cfg(feature = "mp")]
#[test]
fn a_sweep_has_as_many_bits_as_asked_for() {
    let rows = stdout(
        "sweep response --omega 0.1:0.9:9 --alpha 200 --bits 256 --outputs omega,min_force_ratio --no-header",
    );
    let third: Vec<&str> = rows.lines().nth(2).unwrap().split(',').collect();
    let (omega, least) = (third[0], third[1]);
    assert!(omega.len() > 75 && omega.starts_with(&format!("0.2{}", "9".repeat(70))), "{omega}");
    let single = stdout(&format!("border --omega {omega} --bits 256 --format json"));
    let single: Value = serde_json::from_str(&single).unwrap();
    assert_eq!(single["min_force_ratio"].as_str(), Some(least));
}

/// The same holds for logarithmic grids.
#[cfg(feature = "mp")]
#[test]
fn equal_ratios_have_as_many_bits_as_asked_for() {
    use stickslip::float::Mp;
    let values = |grid: &str| -> Vec<Mp<5>> {
        let rows = stdout(&format!("sweep border --omega {grid}:log --bits 256 --outputs omega --no-header"));
        rows.lines().map(|row| row.parse().unwrap()).collect()
    };
    let powers: Vec<Mp<5>> = [1, 2, 4, 8, 16].map(Mp::from).to_vec();
    assert_eq!(values("1:16:5"), powers);
    let grid = values("0.01:3:8");
    let seventh = grid[7] / grid[0];
    for (n, value) in (0..).zip(&grid) {
        let due = (0..n).fold(Mp::from(1), |power, _| power * seventh);
        let found = (0..7).fold(Mp::from(1), |power, _| power * (*value / grid[0]));
        assert!((found / due - Mp::from(1)).to_f64().abs() < 1e-74, "{n}: {value}");
    }
}

/// The extension of the file name selects the format of the rows.
#[test]
fn a_file_of_json_lines_is_named_so() {
    let file = place("rows.jsonl");
    stdout(&format!("sweep border --omega 0.5:2:4 --out {}", file.display()));
    let text = std::fs::read_to_string(file).unwrap();
    assert_eq!(text, stdout("sweep border --omega 0.5:2:4 --format jsonl"));
    assert!(text.starts_with('{'));
}

#[cfg(not(feature = "parquet"))]
#[test]
fn a_build_without_parquet_says_so() {
    for run in ["sweep border --omega 1", "simulate --omega 1.5 --alpha 3 --cycles 1"] {
        refused(&format!("{run} --out rows.parquet"), &["--format parquet", "feature parquet"]);
    }
}
