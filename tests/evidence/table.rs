//! docs/development/evidence.md names for every output the test that holds it against a number of another origin. Every output is
//! there, every name there is an output, and every test named exists and is run.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use stickslip::internal::ResponseAnswer;
use stickslip::motion::record::{Body, Record};
use stickslip::motion::{SteadyAnswer, SteadyOutput};
use stickslip::{Excitation, Output};

const PAGE: &str = include_str!("../../docs/development/evidence.md");
const API: &str = include_str!("../../.ci/public-api.txt");

/// A row of a table of the page: the command or the part of the library, its outputs or functions, and the tests.
struct Row {
    of: &'static str,
    names: Vec<&'static str>,
    origin: &'static str,
    tests: Vec<&'static str>,
}

fn quoted(cell: &'static str) -> Vec<&'static str> {
    cell.split('`').skip(1).step_by(2).collect()
}

fn rows() -> Vec<Row> {
    let cells = PAGE.lines().filter_map(|line| line.strip_prefix("| `"));
    cells
        .map(|line| {
            let cells: Vec<&str> = line.split(" | ").collect();
            assert_eq!(cells.len(), 4, "{line}");
            let of = cells[0].split('`').next().unwrap();
            Row { of, names: quoted(cells[1]), origin: cells[2], tests: quoted(cells[3]) }
        })
        .collect()
}

/// The names of the rows of a command, each once.
fn names(of: &str) -> BTreeSet<&'static str> {
    let mut all = BTreeSet::new();
    for name in rows().into_iter().filter(|row| row.of == of).flat_map(|row| row.names) {
        assert!(all.insert(name), "{of}: {name} stands twice");
    }
    assert!(!all.is_empty(), "docs/development/evidence.md has no rows of {of}");
    all
}

/// Fails where the page lacks a name of the library, or has one that the library lacks.
fn same<'a>(of: &str, found: impl IntoIterator<Item = &'a str>) {
    let (page, library) = (names(of), found.into_iter().collect::<BTreeSet<_>>());
    let lacks: Vec<_> = library.iter().filter(|name| !page.contains(*name)).collect();
    assert!(
        lacks.is_empty(),
        "{of}: outputs without a row in docs/development/evidence.md, with its test: {lacks:?}"
    );
    let beyond: Vec<_> = page.iter().filter(|name| !library.contains(*name)).collect();
    assert!(
        beyond.is_empty(),
        "{of}: docs/development/evidence.md has outputs that do not exist: {beyond:?}"
    );
}

#[test]
fn every_output_of_the_library_has_its_row() {
    same("response", ResponseAnswer::<f64>::COLUMNS.map(|column| column.definition.name));
    same("steady", SteadyAnswer::<f64>::COLUMNS.map(|column| column.definition.name));
    let record = Record::new(Excitation::Force, 1.0, vec![0.0, 0.0]).unwrap();
    let answer = Body::new(1.0, 1.0).unwrap().follow(&record).unwrap();
    same("record", answer.entries().map(|(name, ..)| name));
    // The outputs that functions name are those of the commands.
    let (response, steady, border) = (names("response"), names("steady"), names("border"));
    for name in Output::ALL.map(|output| output.definition().name) {
        let is_there = response.contains(name) || border.contains(name) || name == "margin";
        assert!(is_there, "{name} has no row in docs/development/evidence.md");
    }
    for name in SteadyOutput::ALL.map(|output| output.definition().name) {
        assert!(
            steady.contains(name) || name == "contraction",
            "{name} has no row in docs/development/evidence.md"
        );
    }
}

/// Every public function is in the table with its test, or is one of those that give no number of a motion: inputs,
/// number types and names.
#[test]
fn every_public_function_has_its_row() {
    let listed: Vec<&str> =
        rows().into_iter().filter(|row| row.of == "fn").flat_map(|row| row.names).collect();
    let without: Vec<&str> = PAGE
        .split_once("give no number of a motion:")
        .and_then(|(_, rest)| rest.split("\n\n").nth(1))
        .map(quoted)
        .unwrap();
    let is_of = |name: &str, pattern: &str| match pattern.strip_suffix('*') {
        Some(start) => name.starts_with(start),
        None => name == pattern,
    };
    let mut used: BTreeSet<&str> = BTreeSet::new();
    for line in API.lines().filter_map(|line| line.strip_prefix("fn ")) {
        let name = line.split(['(', '<']).next().unwrap();
        let patterns = listed.iter().chain(&without).filter(|pattern| is_of(name, pattern));
        let patterns: Vec<&str> = patterns.copied().collect();
        assert!(!patterns.is_empty(), "{name} has no row in docs/development/evidence.md, with its test");
        used.extend(patterns);
    }
    let idle: Vec<_> = listed.iter().chain(&without).filter(|pattern| !used.contains(*pattern)).collect();
    assert!(idle.is_empty(), "docs/development/evidence.md has functions that do not exist: {idle:?}");
}

/// The files in which a test of this path may be: `tests::evidence::steady::name` is in tests/evidence/steady.rs,
/// `command::evidence::name` in command/tests/command/evidence.rs, `src::motion::limit::rest::name` beside the code.
fn files(path: &str) -> (Vec<std::path::PathBuf>, &str) {
    let (modules, name) = path.rsplit_once("::").unwrap_or(("", path));
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = match modules.strip_prefix("command::") {
        Some(rest) => root.join("command/tests/command").join(rest.replace("::", "/")),
        None => root.join(modules.replace("::", "/")),
    };
    (
        vec![
            folder.with_extension("rs"),
            folder.join("main.rs"),
            folder.join("mod.rs"),
            folder.join("tests.rs"),
        ],
        name,
    )
}

/// Whether a source has this test, and runs it.
fn is_run(text: &str, name: &str) -> bool {
    let lines: Vec<&str> = text.lines().map(str::trim).collect();
    let place = lines.iter().position(|line| {
        line.strip_prefix("fn ")
            .and_then(|rest| rest.strip_prefix(name))
            .is_some_and(|rest| rest.starts_with('('))
    });
    let Some(place) = place else { return false };
    let above =
        lines[..place].iter().rev().take_while(|line| line.starts_with("#[") || line.starts_with("//"));
    let above: Vec<_> = above.collect();
    above.iter().any(|line| **line == "#[test]") && !above.iter().any(|line| line.starts_with("#[ignore"))
}

#[test]
fn every_test_named_exists_and_is_run() {
    let mut sources: BTreeMap<std::path::PathBuf, String> = BTreeMap::new();
    let mut named = BTreeSet::new();
    for row in rows() {
        assert!(!row.tests.is_empty(), "{} {:?} names no test", row.of, row.names);
        named.extend(row.tests);
    }
    assert!(named.len() > 40, "{}", named.len());
    for path in &named {
        if let Some((file, name)) = path.strip_prefix("python::").and_then(|path| path.split_once("::")) {
            let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("python/tests/{file}.py"));
            let text = std::fs::read_to_string(file);
            assert!(text.is_ok_and(|text| text.contains(&format!("\ndef {name}("))), "{path} is not a test");
            continue;
        }
        let (files, name) = files(path);
        let found = files.into_iter().any(|file| {
            if !file.exists() {
                return false;
            }
            let text = sources.entry(file.clone()).or_insert_with(|| std::fs::read_to_string(file).unwrap());
            is_run(text, name)
        });
        assert!(found, "{path} of docs/development/evidence.md is not a test that runs");
    }
    // Those of this program are compiled into it.
    let own = std::process::Command::new(std::env::current_exe().unwrap()).arg("--list").output().unwrap();
    let own = String::from_utf8(own.stdout).unwrap();
    for path in named.iter().filter_map(|path| path.strip_prefix("tests::evidence::")) {
        let needs_mp = path.starts_with("enclosed::") && cfg!(not(feature = "mp"));
        assert!(
            needs_mp || own.lines().any(|line| line == format!("{path}: test")),
            "{path} is not compiled"
        );
    }
    assert!(!is_run("#[test]\n#[ignore = \"slow\"]\nfn one() {}", "one") && !is_run("fn one() {}", "one"));
}

/// Where numbers come from that the library's own reading did not make.
const ORIGINS: [&str; 12] = [
    "samples",
    "small steps",
    "another program",
    "by hand",
    "algebra",
    "definitions",
    "inputs",
    "as of",
    "differences",
    "the equation of motion",
    "the Fourier series",
    "the distribution function",
];

#[test]
fn no_origin_is_the_librarys_own_reading() {
    for Row { of, names, origin, .. } in rows() {
        let origin = origin.trim_start_matches("recorded: ");
        assert!(ORIGINS.iter().any(|known| origin.contains(known)), "{of} {names:?}: {origin}");
        for own in ["the rest of the library", "the exact motion", "the closed forms of"] {
            assert!(!origin.contains(own), "{of} {names:?}: {origin}");
        }
    }
}

/// The page says how many outputs and functions there are.
#[test]
fn the_page_counts_its_rows() {
    let count =
        |is: fn(&Row) -> bool| rows().iter().filter(|row| is(row)).map(|row| row.names.len()).sum::<usize>();
    let (outputs, functions) =
        (count(|row| row.of != "fn" && !row.of.starts_with("python")), count(|row| row.of == "fn"));
    let said = format!("{outputs} outputs of commands and {functions} functions of the library");
    assert!(PAGE.contains(&said), "docs/development/evidence.md should say “{said}”");
}
