//! Every test file is compiled: each file next to a `main.rs` of `tests/`, or in a folder that belongs to the
//! unit tests, is a module there.

use std::path::Path;

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
