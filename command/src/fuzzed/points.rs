//! Any bytes as a file of points. Each row has the answer that the command gives to its values as arguments,
//! up to the first invalid row, for which a single line states the error.

use super::is_one_line;
use crate::args::{self, Command, NoCommand};
use crate::closed;
use crate::failure::{Failure, Outcome};
use csv::{ReaderBuilder, StringRecord, Trim};
use serde_json::Value;
use std::path::PathBuf;
use std::sync::LazyLock;
use stickslip_front::inputs::Input;

/// The file with the points of a run.
static FILE: LazyLock<PathBuf> = LazyLock::new(|| super::file("points"));

const COMMANDS: [&str; 4] = ["response", "border", "response --units kN,mm", "border --units kN,mm"];
/// Headers before the input bytes; the first is empty, so that the bytes have their own header.
const HEADERS: [&str; 7] = [
    "",
    "omega,alpha\n",
    "note,alpha,omega,damping_ratio\r\n",
    "mass[t],stiffness[kN/mm],friction[kN],frequency[Hz],force[kN]\n",
    "mass,period,friction_coefficient,frequency,base_acceleration\n",
    "mass,stiffness,friction,friction_backward,mean_force,frequency,force,static_ratio\n",
    "\u{feff}\"omega\" , \"alpha\"\n",
];
/// Rows before the input bytes.
const ROWS: [&str; 4] = ["", "1.5,2.5\n", "a,3,0.4,0.05\n", "1,8,3,2,12\n"];

/// Runs a command line; returns its output as text.
fn run<'a>(words: impl Iterator<Item = &'a str>) -> (Outcome, String) {
    let mut out = Vec::new();
    let outcome = match args::parse(std::iter::once("stickslip").chain(words)) {
        Ok(args::CommandLine { command: Command::Response(args), .. }) => closed::response(&args, &mut out),
        Ok(args::CommandLine { command: Command::Border(args), .. }) => closed::border(&args, &mut out),
        Ok(_) | Err(NoCommand::Answered(_)) => return (Ok(()), String::new()),
        Err(NoCommand::Failed(failure)) => Err(failure),
    };
    (outcome, String::from_utf8(out).expect("text"))
}

/// The rows according to another reader, up to the first invalid one.
fn rows(content: &[u8]) -> (StringRecord, Vec<StringRecord>) {
    let mut reader = ReaderBuilder::new().trim(Trim::All).from_reader(content);
    let header = reader.headers().cloned().unwrap_or_default();
    (header, reader.records().map_while(Result::ok).collect())
}

/// The arguments that correspond to the values of a row, of those that the command accepts.
fn arguments(used: &[Input], header: &StringRecord, row: &StringRecord) -> Vec<String> {
    let option = |(name, text): (&str, &str)| {
        let name = name.trim_start_matches('\u{feff}').trim();
        let within = |open, close| name.strip_suffix(close).and_then(|name| name.split_once(open));
        let (own, unit) = match within('[', ']').or_else(|| within('(', ')')) {
            Some((own, unit)) => (own.trim(), unit.trim()),
            None => (name, ""),
        };
        let own = own.to_lowercase().replace(['-', ' '], "_");
        let named = used.iter().find(|p| p.is_column(&own));
        let known = named.or_else(|| used.iter().find(|p| p.letter() == Some(own.as_str())))?;
        Some(format!("{}={text}{unit}", known.option()))
    };
    header.iter().zip(row).filter_map(option).collect()
}

/// The answers to a file of points, beside those of each of its rows as arguments.
///
/// # Panics
/// If they differ, or a refusal is not as promised, which is a finding.
pub fn points(input: &[u8]) {
    let [command, header, first, rest @ ..] = input else { return };
    let command = COMMANDS[usize::from(*command) % COMMANDS.len()];
    let mut content = HEADERS[usize::from(*header) % HEADERS.len()].as_bytes().to_vec();
    content.extend_from_slice(ROWS[usize::from(*first) % ROWS.len()].as_bytes());
    content.extend_from_slice(rest);
    // A row without an end, longer than the reader accepts.
    if rest.ends_with(b"\0\0") {
        content.extend(std::iter::repeat_n(b'1', 1 << 19));
    }
    std::fs::write(&*FILE, &content).expect("a temporary file");
    let file = FILE.to_str().expect("a path of text");
    let with_points = |format| run(command.split(' ').chain(["--points", file, "--format", format]));
    let (outcome, lines) = with_points("jsonl");
    let answers: Vec<Value> =
        lines.lines().map(|line| serde_json::from_str(line).expect("an object a line")).collect();
    let (header, rows) = rows(&content);
    let used = args::used::columns(command.split(' ').next().unwrap_or_default());
    match &outcome {
        Ok(()) => assert_eq!(answers.len(), rows.len(), "{}", String::from_utf8_lossy(&content)),
        Err(failure) => {
            is_one_line(failure);
            assert!(matches!(failure, Failure::Input(_)), "{}", failure.message());
            assert!(answers.len() <= rows.len());
        }
    }
    for (row, answer) in rows.iter().zip(&answers).take(20) {
        let arguments = arguments(&used, &header, row);
        let words =
            command.split(' ').chain(arguments.iter().map(String::as_str)).chain(["--format", "json"]);
        let (alone, text) = run(words);
        assert!(alone.is_ok(), "{arguments:?}: {}", alone.err().map_or_else(String::new, |e| e.message()));
        assert_eq!(&serde_json::from_str::<Value>(&text).expect("JSON"), answer, "{arguments:?}");
    }
    // The same rows as CSV.
    let (again, table) = with_points("csv");
    assert_eq!(again.is_ok(), outcome.is_ok());
    let mut reader = ReaderBuilder::new().from_reader(table.as_bytes());
    let count = reader.records().collect::<Result<Vec<_>, _>>().expect("rows of CSV").len();
    assert_eq!(count, answers.len(), "{table}");
}
