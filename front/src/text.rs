//! Texts of others: what a terminal or a drawing must not receive, files that are no text, and files that are no files.

use std::borrow::Cow;
use std::cell::RefCell;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

/// Whether a character is one that acts on a terminal, or one that no drawing may hold: a control character, or U+FFFE and
/// U+FFFF, which are none.
#[must_use]
pub fn is_control(letter: char) -> bool {
    letter.is_control() || matches!(letter, '\u{fffe}' | '\u{ffff}')
}

/// The text with its control characters as they are written in a program, such as `\u{1b}`.
#[must_use]
pub fn printable(text: &str) -> Cow<'_, str> {
    if !text.contains(is_control) {
        return Cow::Borrowed(text);
    }
    let escaped = |letter: char| match letter {
        '\u{fffe}' | '\u{ffff}' => letter.escape_unicode().to_string(),
        letter if is_control(letter) => letter.escape_default().to_string(),
        letter => letter.to_string(),
    };
    Cow::Owned(text.chars().map(escaped).collect())
}

/// Whether bytes are a text of sixteen bits a letter, as some programs of Windows save it: by its mark, or because every
/// other byte of its beginning is zero.
#[must_use]
pub fn is_utf16(bytes: &[u8]) -> bool {
    let is_marked = bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]);
    let begin = bytes.get(..64).unwrap_or(bytes);
    let zeros = |odd: usize| begin.iter().skip(odd).step_by(2).filter(|byte| **byte == 0).count();
    let most = begin.len().div_ceil(4);
    is_marked || begin.len() >= 4 && (zeros(0) > most || zeros(1) > most) && zeros(0) != zeros(1)
}

/// What is wrong with a file that [`is_utf16`].
pub const UTF16: &str = "must be text in UTF-8, but is UTF-16: save it as UTF-8 or as CSV UTF-8";

/// The text of bytes.
///
/// # Errors
/// Where they are no UTF-8.
pub fn of_bytes(bytes: Vec<u8>) -> Result<String, &'static str> {
    String::from_utf8(bytes).map_err(
        |error| {
            if is_utf16(error.as_bytes()) { UTF16 } else { "must be text in UTF-8" }
        },
    )
}

/// Opens a file that another one names: one with an end, so that neither a device nor a pipe is waited for.
///
/// # Errors
/// Those of the system, and where it is no regular file.
pub fn open_regular(place: &Path) -> io::Result<File> {
    if fs::metadata(place)?.is_file() {
        File::open(place)
    } else {
        Err(io::Error::new(io::ErrorKind::InvalidInput, "must be a regular file"))
    }
}

/// The folder of the files that another file names. It keeps the first one that was not opened, because messages tell its error in words.
#[derive(Debug)]
pub struct Folder<'p> {
    place: &'p Path,
    unopened: RefCell<Option<(PathBuf, io::Error)>>,
}

impl<'p> Folder<'p> {
    /// The folder at this place.
    #[must_use]
    pub const fn new(place: &'p Path) -> Self {
        Self { place, unopened: RefCell::new(None) }
    }

    /// The same folder, in which every file was opened so far.
    #[must_use]
    pub const fn again(&self) -> Self {
        Self::new(self.place)
    }

    /// The path of a file in the folder.
    #[must_use]
    pub fn path(&self, file: &str) -> PathBuf {
        self.place.join(file)
    }

    /// As [`open_regular`], for a path of this folder.
    ///
    /// # Errors
    /// As there.
    pub fn open(&self, path: &Path) -> io::Result<File> {
        open_regular(path).inspect_err(|error| {
            let same = error.raw_os_error().map_or_else(
                || io::Error::new(error.kind(), error.to_string()),
                io::Error::from_raw_os_error,
            );
            self.unopened.borrow_mut().get_or_insert_with(|| (path.to_owned(), same));
        })
    }

    /// The first file that was not opened, with its error.
    #[must_use]
    pub fn unopened(self) -> Option<(PathBuf, io::Error)> {
        self.unopened.into_inner()
    }
}

#[cfg(test)]
mod tests {
    use super::{Folder, UTF16, is_utf16, of_bytes, open_regular, printable};
    use std::path::Path;

    #[test]
    fn control_characters_are_written_out() {
        assert_eq!(printable("two\nlines\u{1b}[31m\u{85}\u{fffe}"), "two\\nlines\\u{1b}[31m\\u{85}\\u{fffe}");
        assert_eq!(printable("Kupplung µ = 0.3 → ½"), "Kupplung µ = 0.3 → ½");
    }

    #[test]
    fn texts_of_sixteen_bits_are_known() {
        let text = "masses = { block = \"1 t\" }";
        let little: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
        let big: Vec<u8> = text.encode_utf16().flat_map(u16::to_be_bytes).collect();
        let marked = [vec![0xff, 0xfe], little.clone()].concat();
        for bytes in [&little, &big, &marked] {
            assert!(is_utf16(bytes));
        }
        assert_eq!(of_bytes(marked), Err(UTF16));
        for other in [text.as_bytes(), b"", b"\0", &[0; 64], "µ".as_bytes(), b"ab\0cdefgh"] {
            assert!(!is_utf16(other), "{other:?}");
        }
        assert_eq!(of_bytes(b"\xb5 = 1".to_vec()), Err("must be text in UTF-8"));
    }

    #[test]
    fn a_folder_is_no_file() {
        assert_eq!(open_regular(Path::new("/")).unwrap_err().to_string(), "must be a regular file");
    }

    #[test]
    fn a_folder_keeps_the_first_file_that_was_not_opened() {
        let folder = Folder::new(Path::new(env!("CARGO_MANIFEST_DIR")));
        assert!(folder.open(&folder.path("Cargo.toml")).is_ok());
        assert!(folder.again().unopened().is_none());
        let missing = folder.path("no.mtx");
        for path in [&missing, &folder.path("src"), &missing] {
            assert!(folder.open(path).is_err());
        }
        assert!(folder.again().unopened().is_none());
        let (path, error) = folder.unopened().unwrap();
        assert_eq!((path, error.kind()), (missing, std::io::ErrorKind::NotFound));
        assert!(error.raw_os_error().is_some());
    }
}
