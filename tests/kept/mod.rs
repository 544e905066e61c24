//! What is kept in the repository and held against what the library gives.

use std::path::Path;

/// What is kept under this path of the repository; with `STICKSLIP_WRITE` set it is written first.
pub(crate) fn kept(path: &str, given: &str) -> String {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    if std::env::var_os("STICKSLIP_WRITE").is_some() {
        std::fs::create_dir_all(file.parent().unwrap()).unwrap();
        std::fs::write(&file, given).unwrap();
    }
    std::fs::read_to_string(file).unwrap()
}
