//! No test file is left out: each one beside a `main.rs` of `tests/` is a module of it.

use std::path::Path;

#[test]
fn every_test_file_is_a_module_of_its_program() {
    let mut modules = 0;
    for folder in std::fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests")).unwrap() {
        let folder = folder.unwrap().path();
        let Ok(main) = std::fs::read_to_string(folder.join("main.rs")) else { continue };
        for file in std::fs::read_dir(&folder).unwrap() {
            let file = file.unwrap().path();
            let name = file.file_stem().unwrap().to_str().unwrap();
            if file.extension().is_some_and(|e| e == "rs") && name != "main" {
                assert!(main.lines().any(|line| line == format!("mod {name};")), "{}", file.display());
                modules += 1;
            }
        }
    }
    assert!(modules > 50, "{modules}");
}
