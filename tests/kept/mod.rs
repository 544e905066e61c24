//! Files kept in the repository and compared with the library's results.

use std::path::Path;

/// The files of one test. With `STICKSLIP_WRITE` set they are written and the test fails, because a run that
/// compares nothing must not pass.
#[derive(Default)]
pub(crate) struct Kept {
    written: usize,
}

impl Kept {
    /// The contents of the file kept at this path of the repository.
    pub(crate) fn at(&mut self, path: &str, given: &str) -> String {
        // The root of the repository is the folder of the crate of this test, or the one above.
        let own = Path::new(env!("CARGO_MANIFEST_DIR"));
        let file = own.ancestors().find(|folder| folder.join("docs").exists()).unwrap().join(path);
        if std::env::var_os("STICKSLIP_WRITE").is_some() {
            std::fs::create_dir_all(file.parent().unwrap()).unwrap();
            std::fs::write(&file, given).unwrap();
            self.written += 1;
        }
        std::fs::read_to_string(file).unwrap()
    }
}

impl Drop for Kept {
    fn drop(&mut self) {
        let nothing_written = self.written == 0 || std::thread::panicking();
        assert!(nothing_written, "{} files written and not compared: unset STICKSLIP_WRITE", self.written);
    }
}
