//! `stickslip sweep` to Parquet files, which are read back.

use crate::command_line::listens;
use crate::command_line::{GOES_ON, refused, stdout};
use crate::place::place;
#[cfg(unix)]
use crate::random::Random;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field;
use std::fs::File;
use std::path::{Path, PathBuf};

fn reader(file: &Path) -> SerializedFileReader<File> {
    SerializedFileReader::new(File::open(file).unwrap()).unwrap()
}

/// The names and rows of a file in the form of the CSV of the same sweep.
pub(crate) fn text(file: &Path) -> String {
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
                Field::Bool(flag) => flag.to_string(),
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

/// The motion under a record, whose direction is the fifth column of CSV and the last one here.
#[test]
fn a_motion_under_a_record_is_what_csv_has() {
    let folder = tempfile::tempdir().unwrap();
    let name = |name: &str| folder.path().join(name).display().to_string();
    let rows: String = (0..200).map(|i| format!("{}\n", 3.0 * (0.3 * f64::from(i)).sin())).collect();
    std::fs::write(name("a.txt"), rows).unwrap();
    let record = format!("record {} --time-step 0.05s --record-units m/s^2", name("a.txt"));
    let body = "--mass 2kg --period 1s --friction-coefficient 0.1 --units kN,mm";
    for file in ["a.parquet", "a.csv"] {
        stdout(&format!("{record} {body} --out {}", name(file)));
    }
    let numbers = |line: &str| line.split(',').map(|cell| cell.parse::<f64>().unwrap()).collect::<Vec<_>>();
    let (parquet, csv) =
        (text(Path::new(&name("a.parquet"))), std::fs::read_to_string(name("a.csv")).unwrap());
    assert!(csv.lines().count() > 200 && parquet.lines().count() == csv.lines().count());
    for (place, (row, due)) in parquet.lines().zip(csv.lines()).enumerate() {
        let mut due: Vec<&str> = due.split(',').collect();
        let direction = due.remove(4);
        due.push(if place == 0 { "direction[1]" } else { direction });
        let due = due.join(",");
        if place == 0 {
            assert_eq!(row, due);
        } else {
            assert_eq!(numbers(row), numbers(&due));
        }
    }
}

/// A time history of more rows than a group holds in memory.
#[test]
fn a_time_history_is_what_csv_has() {
    let folder = tempfile::tempdir().unwrap();
    for (n, run) in [
        "simulate --omega 0.4 --alpha 6 --cycles 3",
        "simulate --mass 50 --stiffness 1000 --friction 5 --frequency 2Hz --force 12 --units N,m --rate 1kHz --duration 132s",
    ]
    .into_iter()
    .enumerate()
    {
        let file = folder.path().join(format!("{n}.parquet"));
        assert_eq!(stdout(&format!("{run} --out {}", file.display())), "");
        let csv: Vec<String> = stdout(&format!("{run} --format csv")).lines().map(written_alike).collect();
        let read: Vec<String> = text(&file).lines().map(written_alike).collect();
        assert!(read == csv, "{run}: {:?} {:?}", read.first(), csv.first());
        let groups = SerializedFileReader::new(std::fs::File::open(&file).unwrap()).unwrap().num_row_groups();
        assert_eq!(groups, 1 + n, "{run}");
        refused(&format!("{run} --out {}", file.display()), &["must not exist yet"]);
    }
    refused(
        "simulate --omega 0.4 --alpha 6 --cycles 3 --format parquet",
        &["--format parquet", "--out FILE"],
    );
}

/// The numbers of a line in a uniform format.
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

/// `symmetric` is a truth value, null at a point whose motion has no period.
#[test]
fn truth_values_are_booleans() {
    let file = place("booleans.parquet");
    stdout(&format!(
        "sweep steady --static-friction-ratio 1.3 --omega 0.5:1.5:2 --alpha 0.5:4:2 --out {}",
        file.display()
    ));
    let reader = reader(&file);
    let rows = reader.get_row_iter(None).unwrap().map(Result::unwrap);
    let symmetric = |row: parquet::record::Row| {
        row.get_column_iter().find(|(name, _)| *name == "symmetric").map(|(_, field)| field.clone()).unwrap()
    };
    let found: Vec<_> = rows.map(symmetric).collect();
    assert_eq!(found, [Field::Null, Field::Bool(false), Field::Null, Field::Bool(true)]);
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

/// The directory with the parts of an incomplete file.
fn parts(file: &Path) -> PathBuf {
    let mut name = file.as_os_str().to_owned();
    name.push(".parts");
    name.into()
}

/// The total number of rows in all parts.
fn rows_of_parts(file: &Path) -> i64 {
    let Ok(found) = std::fs::read_dir(parts(file)) else { return 0 };
    let names =
        found.map(|entry| entry.unwrap().path()).filter(|p| p.extension().is_some_and(|e| e == "parquet"));
    names.map(|part| reader(&part).metadata().file_metadata().num_rows()).sum()
}

/// Starts a sweep and stops it after some time by a signal; returns the exit status, unless the sweep ended
/// before.
#[cfg(unix)]
fn broken_off(sweep: &str, signal: &str, after: std::time::Duration) -> Option<i32> {
    use std::process::{Command, Stdio};
    let mut child = Command::new(assert_cmd::cargo::cargo_bin!("stickslip"))
        .args(sweep.split(' '))
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    listens(&mut child);
    std::thread::sleep(after);
    let _ =
        Command::new("kill").args([signal, &child.id().to_string()]).stderr(Stdio::null()).status().unwrap();
    child.wait().unwrap().code()
}

/// If the sweep is killed or interrupted at any time, complete parts are kept, and resuming gives the same
/// result as an uninterrupted sweep.
#[cfg(unix)]
#[test]
fn a_sweep_that_is_broken_off_goes_on_where_it_was() {
    let sweep = "sweep steady --omega 0.05:1.3:100 --alpha 0.9:8:110";
    let whole = place("all.parquet");
    let begin = std::time::Instant::now();
    stdout(&format!("{sweep} --out {}", whole.display()));
    let usual = begin.elapsed();
    let whole = text(&whole);
    let file = place("broken-off.parquet");
    let goes_on = format!("{sweep} --out {} --resume", file.display());
    let mut kept = 0;
    for (round, signal) in (1u32..).zip(["-INT", "-KILL", "-TERM", "-KILL", "-INT", "-KILL"]) {
        let status = broken_off(&goes_on, signal, usual * round / 12);
        if status == Some(0) {
            break;
        }
        assert_eq!(status, if signal == "-KILL" { None } else { Some(130) });
        // A signal can come after the file is in its place and before the command ends.
        if file.exists() {
            assert!(text(&file) == whole, "there before it is whole");
            break;
        }
        // No complete row is lost; an interrupt keeps all.
        let now = rows_of_parts(&file);
        assert!(now >= kept, "{now} rows of {kept}");
        kept = now;
    }
    assert!(kept > 0);
    for _ in 0..2 {
        // Resuming a complete file changes nothing.
        stdout(&goes_on);
        assert!(text(&file) == whole);
        assert!(!parts(&file).exists());
    }
    let groups = reader(&file).metadata().num_row_groups();
    assert_eq!(groups, 1, "the parts are put together");
}

#[test]
fn another_sweep_or_a_cut_file_is_not_gone_on_with() {
    let file = place("another.parquet");
    let sweep = "response --omega 0.5:2:10 --alpha 2,3";
    stdout(&format!("sweep {sweep} --out {}", file.display()));
    let kept = std::fs::read(&file).unwrap();
    for (arguments, part) in [
        ("response --omega 0.6:2:10 --alpha 2,3 --resume", "its omega is “0.5:2:10”, here it is “0.6:2:10”"),
        ("response --omega 0.5:2:10:log --alpha 2,3 --resume", "here it is “0.5:2:10:log”"),
        ("steady --omega 0.5:2:10 --alpha 2,3 --resume", "its sweep is “response”"),
        ("response --omega 0.5:2:10 --alpha 2,3 --outputs regime --resume", "its outputs is “”"),
        ("response --omega 0.5:2:10 --alpha 2,3 --shard 1/3 --resume", "its shard is “”, here it is “1/3”"),
        ("response --omega 0.5:2:10 --alpha 2,3", "must not exist yet"),
        ("response --omega 0.5:2:10 --alpha 2,3 --resume --no-header", "--no-header"),
    ] {
        refused(&format!("sweep {arguments} --out {}", file.display()), &[part]);
        assert_eq!(std::fs::read(&file).unwrap(), kept, "{arguments}");
        assert!(!parts(&file).exists(), "{arguments}");
    }
    for length in [0, 4, kept.len() / 2, kept.len() - 1] {
        std::fs::write(&file, &kept[..length]).unwrap();
        refused(&format!("sweep {sweep} --resume --out {}", file.display()), &["another.parquet"]);
        assert_eq!(std::fs::read(&file).unwrap(), kept[..length]);
    }
    refused(&format!("sweep {sweep} --format parquet"), &["--format parquet", "--out FILE"]);
}

/// Files of other origin do not disturb a sweep, and a sweep does not touch them.
#[test]
fn what_is_beside_the_file_is_left_alone() {
    let file = place("beside.parquet");
    let sweep = format!("sweep border --omega 0.5:2:10 --out {}", file.display());
    let resumed = file.with_extension("parquet.resumed");
    std::fs::write(&resumed, "notes").unwrap();
    std::fs::create_dir(parts(&file)).unwrap();
    std::fs::write(parts(&file).join("notes"), "notes").unwrap();
    refused(&sweep, &["Continue it with --resume"]);
    refused(&format!("{sweep} --resume"), &["notes", "is not a part of a sweep"]);
    assert_eq!(std::fs::read_to_string(parts(&file).join("notes")).unwrap(), "notes");
    // The same for a part of another sweep.
    std::fs::remove_file(parts(&file).join("notes")).unwrap();
    let part = parts(&file).join("000000000000-000000000010.parquet");
    stdout(&format!("sweep border --omega 0.5:2:10:log --out {}", part.display()));
    refused(&format!("{sweep} --resume"), &["of another sweep", "0.5:2:10:log"]);
    assert!(part.exists() && !file.exists());
    std::fs::remove_dir_all(parts(&file)).unwrap();
    stdout(&sweep);
    assert_eq!(std::fs::read_to_string(&resumed).unwrap(), "notes");
    // Beside a finished file, too, parts of another sweep are named and stay; its own, and what a killed command left, go.
    let whole = std::fs::read(&file).unwrap();
    std::fs::create_dir(parts(&file)).unwrap();
    stdout(&format!("sweep border --omega 0.5:2:10:log --out {}", part.display()));
    refused(&format!("{sweep} --resume"), &["of another sweep", "000000000010.parquet"]);
    assert!(part.exists());
    std::fs::write(&part, &whole).unwrap();
    let mut left = file.to_path_buf().into_os_string();
    left.push(".999999999-0.part");
    std::fs::write(&left, "half").unwrap();
    stdout(&format!("{sweep} --resume"));
    assert!(!parts(&file).exists() && !Path::new(&left).exists());
    assert_eq!(std::fs::read(&file).unwrap(), whole);
}

/// A limit on the file size acts like a full disk.
#[cfg(unix)]
#[test]
fn a_full_disk_leaves_parts_that_can_be_gone_on_with() {
    let command = assert_cmd::cargo::cargo_bin!("stickslip").display().to_string();
    let sweep = "sweep response --omega 0.3:3:500 --alpha 1.1:9:300 --outputs omega,max_displacement";
    let file = place("full.parquet");
    let line = format!("trap '' XFSZ; ulimit -f 100; exec '{command}' {sweep} --out {}", file.display());
    for more in ["", "--resume"] {
        let limited = format!("{line} {more}");
        let output = std::process::Command::new("sh").args(["-c", &limited]).output().unwrap();
        let message = String::from_utf8(output.stderr).unwrap().replace(GOES_ON, "");
        assert_eq!(output.status.code(), Some(1), "{message}");
        assert!(message.contains("full.parquet") && message.contains("File too large"), "{message}");
        assert!(message.lines().count() == 1 && !file.exists());
    }
    stdout(&format!("{sweep} --out {} --resume", file.display()));
    assert_eq!(reader(&file).metadata().file_metadata().num_rows(), 150_000);
    let groups = reader(&file).metadata().row_groups().iter().map(|g| g.num_rows()).max().unwrap();
    assert!(groups <= 1 << 17, "{groups}");
}

/// If two commands write one file, one of them is refused, and the file is complete.
#[cfg(target_os = "linux")]
#[test]
fn two_commands_do_not_share_the_parts() {
    use std::process::Command;
    let file = place("shared.parquet");
    let sweep =
        format!("sweep steady --omega 0.05:1.3:100 --alpha 0.9:8:100 --out {} --resume", file.display());
    let start =
        || Command::new(assert_cmd::cargo::cargo_bin!("stickslip")).args(sweep.split(' ')).spawn().unwrap();
    let mut first = start();
    while !parts(&file).join("lock").exists() {
        assert!(first.try_wait().unwrap().is_none());
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    std::thread::sleep(std::time::Duration::from_millis(20));
    let second = start().wait().unwrap().code();
    assert_eq!(first.wait().unwrap().code(), Some(0));
    // The second command may have started after the first had finished.
    assert!(second == Some(2) || second == Some(0), "{second:?}");
    assert_eq!(reader(&file).metadata().file_metadata().num_rows(), 10_000);
    assert!(!parts(&file).exists());
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

/// A finished file, or a part, of which one bit is another is named and left alone, wherever the bit is.
#[test]
fn a_changed_bit_of_a_file_is_named() {
    let file = place("changed.parquet");
    let sweep = "sweep steady --omega 0.3:1.3:8 --alpha 0.9:8:6";
    stdout(&format!("{sweep} --out {}", file.display()));
    let whole = std::fs::read(&file).unwrap();
    let mut random = Random(1);
    for n in 0..60 {
        let mut changed = whole.clone();
        let count = changed.len() as u64;
        let place = random.below(count) as usize;
        changed[place] ^= 1 << random.below(8);
        std::fs::write(&file, &changed).unwrap();
        refused(&format!("{sweep} --resume --out {}", file.display()), &["changed.parquet", "damaged"]);
        assert!(std::fs::read(&file).unwrap() == changed, "{n}: byte {place}");
    }
    // The same for a part of an unfinished sweep.
    std::fs::remove_file(&file).unwrap();
    std::fs::create_dir(parts(&file)).unwrap();
    let part = parts(&file).join("000000000000-000000000048.parquet");
    let middle = whole.len() / 2;
    let mut changed = whole.clone();
    changed[middle] ^= 16;
    std::fs::write(&part, &changed).unwrap();
    refused(&format!("{sweep} --resume --out {}", file.display()), &["000000000048.parquet", "damaged"]);
    std::fs::write(&part, &whole).unwrap();
    stdout(&format!("{sweep} --resume --out {}", file.display()));
    assert!(std::fs::read(&file).unwrap() == whole);
}
