//! Points from a file or a pipe: one answer for each row, and messages about bad rows.

use crate::command_line::stickslip;
use crate::place::place;
use serde_json::Value;

/// Feeds `input` to `response --points -` and returns (standard output, standard error, exit status).
fn points(format: &str, input: &str) -> (String, String, i32) {
    let assert = stickslip(&format!("response --points - --format {format}")).write_stdin(input).assert();
    let output = assert.get_output();
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
    (text(&output.stdout), text(&output.stderr), output.status.code().unwrap())
}
#[test]
fn points_are_answered_row_by_row() {
    let (out, err, code) = points("jsonl", "alpha, note ,omega\n2.5,first,1.5\n6,second,0.4\n");
    assert_eq!((err.as_str(), code), ("stickslip: note: -: column note is not used\n", 0));
    let rows: Vec<Value> = out.lines().map(|l| serde_json::from_str(l).unwrap()).collect();
    assert_eq!(rows.len(), 2);
    assert_eq!(rows[0]["omega"], 1.5);
    assert_eq!(rows[1]["regime"], "sticking");
    let (csv, _, _) = points("csv", "omega,alpha\n1.5,2.5\n0.4,6\n");
    let lines: Vec<&str> = csv.lines().collect();
    assert!(lines[0].starts_with("omega,alpha,regime,max_displacement"));
    assert!(lines[1].starts_with("1.5,2.5,non-sticking,1.632993"));
    assert!(lines[2].starts_with("0.4,6.0,sticking,,,,,,6.9497"));
    assert_eq!(points("jsonl", "omega,alpha\n"), (String::new(), String::new(), 0));
}
#[test]
fn a_bad_row_stops_after_the_good_ones() {
    for (row, parts) in [
        ("x,2", ["line 4", "omega x"]),
        ("1.5,-2", ["line 4", "α = -2 must be > 0"]),
        ("1.5", ["line 4", "1 fields"]),
        ("1.5,", ["line 4", "alpha"]),
        ("NaN,2", ["line 4", "omega NaN: must be a finite number, and is NaN"]),
    ] {
        for format in ["jsonl", "csv"] {
            let (out, err, code) = points(format, &format!("omega,alpha\n1.5,2.5\n2,2\n{row}\n3,4\n"));
            assert_eq!(code, 2, "{row}");
            assert_eq!(out.lines().count(), if format == "csv" { 3 } else { 2 }, "{row}: {out}");
            assert!(out.ends_with('\n'));
            assert!(parts.iter().all(|p| err.contains(p)), "{row}: {err}");
            assert_eq!(err.matches('\n').count(), 1, "{err}");
        }
    }
    let (out, err, code) = points("jsonl", "omega,force\n1,2\n");
    assert_eq!((out.as_str(), code), ("", 2));
    assert!(
        err.contains(
            "column mass (or --mass), or weight (or --weight) is missing in the header “omega,force”"
        ),
        "{err}"
    );
    let (out, err, code) = points("jsonl", "omega,beta\n1,2\n");
    assert_eq!((out.as_str(), code), ("", 2));
    assert!(err.contains("column alpha (or --alpha) is missing"), "{err}");
    // Columns of a spreadsheet with other separators, and a typing error in an optional column.
    let (out, err, code) = points("jsonl", "omega;alpha\n1,5;2\n");
    assert_eq!((out.as_str(), code), ("", 2));
    assert!(err.contains("Columns must be separated by commas"), "{err}");
    let (out, err, code) = points("jsonl", "omega,alpha,dampng_ratio\n1.5,2.5,0.1\n");
    assert_eq!((out.as_str(), code), ("", 2));
    assert!(err.contains("column dampng_ratio is unknown. Spell it damping_ratio, or rename it"), "{err}");
    let (out, err, code) = points("jsonl", "omega,alpha,label\n1.5,2.5,seven\n");
    assert!(code == 0 && out.lines().count() == 1, "{err}");
    let (_, err, code) = points("jsonl", "omega,alpha\n\"1,5\",2.5\n");
    assert_eq!(code, 2);
    assert!(err.contains("must be a number, with a decimal point in place of the comma"), "{err}");
}
#[test]
fn a_column_is_there_once_and_a_header_alone_has_a_header() {
    let (out, err, code) = points("csv", "omega,alpha,omega\n1,2,3\n");
    assert_eq!((out.as_str(), code), ("", 2));
    assert!(err.contains("column omega must be there once only"), "{err}");
    for (command, header) in [
        ("response", "omega,alpha,regime,max_displacement,"),
        ("steady", "omega,alpha,regime,limit,"),
        ("border", "omega,min_force_ratio,"),
    ] {
        let asked =
            stickslip(&format!("{command} --points - --format csv")).write_stdin("omega,alpha\n").assert();
        let answer = asked.success().get_output().stdout.clone();
        let answer = String::from_utf8(answer).unwrap();
        assert!(answer.starts_with(header) && answer.lines().count() == 1, "{answer}");
    }
}
/// A row without an end is refused before it fills the memory; the message quotes as much of it as is
/// readable.
#[test]
fn a_row_without_end_is_refused() {
    let digits = "7".repeat(3_000_000);
    for input in [
        digits.clone(),
        format!("omega,alpha\n1.5,2.5\n{digits}"),
        format!("omega,alpha\n1.5,2.5\n\"{}", "7\n".repeat(1_000_000)),
        format!("{}\n1\n", "column,".repeat(1_000_000)),
    ] {
        let (out, err, code) = points("jsonl", &input);
        assert_eq!(code, 2, "{err}");
        assert!(err.contains("must be ≤ 262144") && err.lines().count() == 1 && err.len() < 2_000, "{err}");
        assert_eq!(out.lines().count(), usize::from(input.contains("2.5")));
    }
    // The message does not repeat a long line that is no header.
    let (_, err, code) = points("jsonl", &format!("{}\n", "column,".repeat(20_000)));
    assert!(code == 2 && err.contains("column omega (or --omega) is missing") && err.len() < 2_000, "{err}");
}
#[test]
fn a_live_pipe_sees_each_answer_before_the_next_question() {
    use std::io::{BufRead, BufReader, Write};
    use std::process::{Command, Stdio};
    for format in ["jsonl", "csv"] {
        let mut child = Command::new(assert_cmd::cargo::cargo_bin!("stickslip"))
            .args(["response", "--points", "-", "--format", format])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let mut questions = child.stdin.take().unwrap();
        let mut answers = BufReader::new(child.stdout.take().unwrap()).lines();
        questions.write_all(b"omega,alpha\n1.5,2.5\n").unwrap();
        if format == "csv" {
            assert!(answers.next().unwrap().unwrap().starts_with("omega"));
        }
        assert!(answers.next().unwrap().unwrap().contains("1.6329931"));
        questions.write_all(b"0.4,6\n").unwrap();
        assert!(answers.next().unwrap().unwrap().contains("sticking"));
        drop(questions);
        assert!(answers.next().is_none());
        assert!(child.wait().unwrap().success());
    }
}
#[test]
fn a_closed_pipe_ends_quietly() {
    use std::process::{Command, Stdio};
    let rows = "omega,alpha\n".to_owned() + &"1.5,2.5\n".repeat(20_000);
    let file = place("closed-pipe.csv");
    std::fs::write(&file, rows).unwrap();
    let mut child = Command::new(assert_cmd::cargo::cargo_bin!("stickslip"))
        .args(["response", "--points"])
        .arg(&file)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(0));
    assert!(output.stderr.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
}
