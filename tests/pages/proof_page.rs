//! `docs/development/proof.md` lists every equation, and every test that it names exists.

use std::collections::BTreeSet;
use std::path::Path;

const PAGE: &str = include_str!("../../docs/development/proof.md");

/// The names in backquotes that begin with `tests::`.
fn named() -> BTreeSet<&'static str> {
    PAGE.split('`').filter(|part| part.starts_with("tests::")).collect()
}

/// Whether `tests::folder::file::name` or `tests::file::name` is a function there.
fn exists(path: &str) -> bool {
    let parts: Vec<&str> = path.split("::").collect();
    let Some((name, modules)) = parts.split_last() else { return false };
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(modules.join("/"));
    let sources = [file.with_extension("rs"), file.join("main.rs"), file.join("mod.rs")];
    sources
        .iter()
        .filter_map(|f| std::fs::read_to_string(f).ok())
        .any(|text| text.contains(&format!("fn {name}(")))
}

#[test]
fn every_test_named_exists() {
    assert!(named().len() > 30);
    for path in named() {
        assert!(exists(path), "{path} does not exist");
    }
    assert!(!exists("tests::symbolic::matching::no_such_test") && !exists("tests::no_such_file::f"));
}

#[test]
fn every_equation_has_its_row() {
    let mut found = Vec::new();
    for line in PAGE.lines() {
        let Some(cell) = line.strip_prefix("| ").and_then(|l| l.split('|').next()) else { continue };
        let number = |s: &str| s.trim().parse::<u32>().ok();
        for part in cell.split(',') {
            match part.split_once('–') {
                Some((from, to)) => {
                    found.extend(number(from).zip(number(to)).map_or(0..0, |(a, b)| a..b + 1))
                }
                None => found.extend(number(part)),
            }
        }
        if found.last() == Some(&66) {
            break;
        }
    }
    found.sort_unstable();
    assert_eq!(found, (1..=67).collect::<Vec<_>>());
}
