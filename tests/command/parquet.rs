//! `stickslip sweep` to Parquet, read back.

use crate::command_line::{refused, stdout, stickslip};
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field;
use std::fs::File;
use std::path::{Path, PathBuf};

/// A path for the file of one test.
fn place(name: &str) -> PathBuf {
    let place = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_file(&place);
    place
}

fn reader(file: &Path) -> SerializedFileReader<File> {
    SerializedFileReader::new(File::open(file).unwrap()).unwrap()
}

/// The names and the rows of a file, as the CSV of the same sweep has them.
fn text(file: &Path) -> String {
    let reader = reader(file);
    let schema = reader.metadata().file_metadata().schema();
    let names: Vec<&str> = schema.get_fields().iter().map(|field| field.name()).collect();
    let mut text = names.join(",") + "\n";
    for row in reader.get_row_iter(None).unwrap() {
        let cells: Vec<String> = row
            .unwrap()
            .get_column_iter()
            .map(|(_, field)| match field {
                Field::Null => String::new(),
                Field::Double(number) => serde_json::to_string(number).unwrap(),
                Field::Long(count) => count.to_string(),
                Field::Str(text) => text.clone(),
                other => panic!("{other:?}"),
            })
            .collect();
        text += &(cells.join(",") + "\n");
    }
    text
}

#[test]
fn what_is_read_back_is_what_csv_has() {
    for (n, sweep) in [
        "response --omega 0.3:1.3:20 --alpha 0.9:8:25",
        "steady --omega 0.3:1.3:11 --alpha 0.9,1.5,4",
        "border --omega 0.1:3:40:log --outputs min_force_ratio,omega",
    ]
    .into_iter()
    .enumerate()
    {
        let file = place(&format!("back-{n}.parquet"));
        assert_eq!(stdout(&format!("sweep {sweep} --out {}", file.display())), "");
        let csv: Vec<String> = stdout(&format!("sweep {sweep}")).lines().map(written_alike).collect();
        assert_eq!(text(&file).lines().map(written_alike).collect::<Vec<_>>(), csv, "{sweep}");
    }
}

/// The numbers of a line in one spelling.
fn written_alike(line: &str) -> String {
    let cell = |cell: &str| cell.parse::<f64>().map_or(cell.to_owned(), |number| format!("{number:e}"));
    line.split(',').map(cell).collect::<Vec<_>>().join(",")
}

#[test]
fn columns_have_types_and_the_file_says_what_it_is() {
    let file = place("types.parquet");
    stdout(&format!("sweep steady --omega 0.3:1.3:3 --alpha 2:4:3 --out {}", file.display()));
    let reader = reader(&file);
    let metadata = reader.metadata().file_metadata();
    let schema: Vec<String> = metadata
        .schema()
        .get_fields()
        .iter()
        .map(|field| format!("{} {}", field.get_physical_type(), field.name()))
        .collect();
    for due in ["DOUBLE omega", "BYTE_ARRAY regime", "INT64 sticks_per_cycle", "DOUBLE multipliers_2_im"] {
        assert!(schema.iter().any(|field| field == due), "{due} in {schema:?}");
    }
    let notes = metadata.key_value_metadata().unwrap();
    let note = |key: &str| notes.iter().find(|note| note.key == key).and_then(|note| note.value.clone());
    assert_eq!(note("sweep").as_deref(), Some("steady"));
    assert_eq!(note("omega").as_deref(), Some("0.3:1.3:3"));
    assert!(note("units").unwrap().contains("r_y/k"));
    assert!(metadata.created_by().unwrap().starts_with("stickslip "));
}

#[test]
fn the_shards_together_are_the_whole() {
    let sweep = "sweep response --omega 0.3:1.3:13 --alpha 1.5:8:23";
    let whole = place("whole.parquet");
    stdout(&format!("{sweep} --out {}", whole.display()));
    let mut joined = String::new();
    for part in 1..=3 {
        let file = place(&format!("part-{part}.parquet"));
        stdout(&format!("{sweep} --shard {part}/3 --out {}", file.display()));
        let rows = text(&file);
        joined += if part == 1 { &rows } else { rows.split_once('\n').unwrap().1 };
    }
    assert_eq!(joined, text(&whole));
}

/// A file with the first rows of a sweep, as one that was broken off in time has them.
fn broken_off(name: &str, sweep: &str) -> PathBuf {
    let file = place(name);
    stdout(&format!("sweep {sweep} --shard 1/3 --out {}", file.display()));
    file
}

#[test]
fn a_sweep_goes_on_after_its_last_row() {
    let sweep = "steady --omega 0.3:1.3:13 --alpha 0.9:8:23";
    let whole = place("all.parquet");
    stdout(&format!("sweep {sweep} --out {}", whole.display()));
    let file = broken_off("resumed.parquet", sweep);
    for _ in 0..2 {
        // Once it is whole, going on changes nothing.
        stdout(&format!("sweep {sweep} --out {} --resume", file.display()));
        assert_eq!(text(&file), text(&whole));
        assert!(!file.with_extension("parquet.resumed").exists());
    }
    assert_eq!(reader(&file).num_row_groups(), 2);
}

#[test]
fn another_sweep_or_a_cut_file_is_not_gone_on_with() {
    let sweep = "response --omega 0.5:2:10 --alpha 2,3";
    let file = broken_off("another.parquet", sweep);
    let kept = std::fs::read(&file).unwrap();
    for (arguments, part) in [
        ("response --omega 0.6:2:10 --alpha 2,3 --resume", "row 1 is not of this sweep"),
        ("response --omega 0.5:2.5:10 --alpha 2,3 --resume", "row 6 is not of this sweep"),
        ("steady --omega 0.5:2:10 --alpha 2,3 --resume", "columns are not those"),
        ("response --omega 0.5:2:2 --alpha 2,3 --resume", "6 rows, must be ≤ 4"),
        ("response --omega 0.5:2:10 --alpha 2,3", "must not exist yet"),
        ("response --omega 0.5:2:10 --alpha 2,3 --resume --no-header", "--no-header"),
    ] {
        refused(&format!("sweep {arguments} --out {}", file.display()), &[part]);
        assert_eq!(std::fs::read(&file).unwrap(), kept, "{arguments}");
    }
    std::fs::write(&file, &kept[..kept.len() / 2]).unwrap();
    refused(&format!("sweep {sweep} --resume --out {}", file.display()), &["cut off", "begin anew"]);
    refused(&format!("sweep {sweep} --format parquet"), &["--format parquet", "--out FILE"]);
}

/// Many row groups, each of bounded size, and Ctrl-C between them: the file has its end, and can be gone on with.
#[cfg(unix)]
#[test]
fn an_interrupted_sweep_is_a_file_that_can_be_gone_on_with() {
    use std::process::Command;
    let file = place("interrupted.parquet");
    let sweep = format!("sweep response --omega 0.3:3:1000 --alpha 1.1:9:300 --out {}", file.display());
    let mut child =
        Command::new(assert_cmd::cargo::cargo_bin!("stickslip")).args(sweep.split(' ')).spawn().unwrap();
    while std::fs::metadata(&file).map_or(0, |m| m.len()) < 100_000 {
        assert_eq!(child.try_wait().unwrap(), None, "it ended before it was interrupted");
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    assert_eq!(child.wait().unwrap().code(), Some(130));
    let rows = |file: &Path| reader(file).metadata().file_metadata().num_rows();
    assert!((1..300_000).contains(&rows(&file)), "{}", rows(&file));
    stickslip(&format!("{sweep} --resume")).assert().success().stderr("");
    assert_eq!(rows(&file), 300_000);
    let groups = reader(&file).metadata().row_groups().iter().map(|g| g.num_rows()).max().unwrap();
    assert!(groups <= 1 << 17, "{groups}");
}

#[cfg(feature = "mp")]
#[test]
fn numbers_of_more_bits_are_texts_with_all_digits() {
    let sweep = "response --omega 0.7 --alpha 1.1,2,3 --bits 256 --outputs max_displacement";
    let file = place("bits.parquet");
    stdout(&format!("sweep {sweep} --out {}", file.display()));
    let rows = text(&file);
    assert_eq!(rows, stdout(&format!("sweep {sweep}")).replace("\"\"", ""));
    assert!(rows.lines().nth(2).unwrap().len() > 75, "{rows}");
}
