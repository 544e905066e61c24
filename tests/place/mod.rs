//! Files of tests, none of which another test or another run can touch.

use std::ffi::OsStr;
use std::ops::Deref;
use std::path::{Path, PathBuf};

/// A path in a folder of its own, which is removed with this value.
pub(crate) struct Place {
    path: PathBuf,
    _folder: tempfile::TempDir,
}

/// A path of this name, where nothing is yet.
pub(crate) fn place(name: &str) -> Place {
    let folder = tempfile::tempdir().unwrap();
    Place { path: folder.path().join(name), _folder: folder }
}

impl Deref for Place {
    type Target = Path;

    fn deref(&self) -> &Path {
        &self.path
    }
}

impl AsRef<Path> for Place {
    fn as_ref(&self) -> &Path {
        self
    }
}

impl AsRef<OsStr> for Place {
    fn as_ref(&self) -> &OsStr {
        self.as_os_str()
    }
}
