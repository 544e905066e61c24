//! Every test file is compiled: each file next to a `main.rs` of `tests/`, or in a folder that belongs to the
//! unit tests, is a module there. Tests share no file, and draw the same inputs in every run.

use crate::equation_index::rust_files;
use std::path::Path;

/// The sources of library and tests, each with its path.
fn sources() -> impl Iterator<Item = (String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut files = Vec::new();
    for folder in ["src", "tests"] {
        rust_files(&root.join(folder), &mut files);
    }
    files.into_iter().map(|file| (file.display().to_string(), std::fs::read_to_string(file).unwrap()))
}

/// A test has its files in a `place` of its own, not in a folder of all tests. Only the rows of comparisons are left to a later program, in a
/// file for each thread.
#[test]
fn no_test_writes_where_another_does() {
    for (file, text) in sources().filter(|(file, _)| !file.ends_with("tests/compared/mod.rs")) {
        assert!(!text.contains(concat!("CARGO_TARGET_", "TMPDIR")), "{file}");
    }
}

/// Property tests have the configuration of `drawn`, with its seed.
#[test]
fn property_tests_draw_the_same_inputs_in_every_run() {
    let mut found = 0;
    for (file, text) in sources() {
        let blocks = text.matches(concat!("proptest", "! {")).count();
        assert_eq!(blocks, text.matches(concat!("#![proptest_config", "(cases(")).count(), "{file}");
        found += blocks;
    }
    assert!(found > 15, "{found}");
}

#[test]
fn every_test_file_is_a_module_of_its_program() {
    let mut modules = 0;
    for folder in std::fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests")).unwrap() {
        let folder = folder.unwrap().path();
        let is_of_the_library =
            ["formulae", "matching", "symbolic"].iter().any(|name| folder.ends_with(name));
        let root = folder.join(if is_of_the_library { "mod.rs" } else { "main.rs" });
        let Ok(main) = std::fs::read_to_string(root) else { continue };
        for file in std::fs::read_dir(&folder).unwrap() {
            let file = file.unwrap().path();
            let name = file.file_stem().unwrap().to_str().unwrap();
            if file.extension().is_some_and(|e| e == "rs") && name != "main" && name != "mod" {
                assert!(main.lines().any(|line| line == format!("mod {name};")), "{}", file.display());
                modules += 1;
            }
        }
    }
    assert!(modules > 50, "{modules}");
}
