//! Destinations of answers: standard output and files that receive complete lines, and files that appear
//! complete or not at all.

use crate::failure::{Failure, Outcome};
use crate::interrupt::{self, Temporary};
use crate::progress;
use serde::Serialize;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::process;
use std::sync::atomic::{AtomicU32, Ordering};
use stickslip_front::text::open_regular;

/// The number of bytes that are gathered before a write.
const GATHERED: usize = 1 << 14;

/// The greatest number of bytes without the end of a line; beyond it the output is no text.
const NO_LINE: usize = 1 << 20;

/// A stream that receives only complete lines, so that it ends at a complete record whenever the command
/// ends. Its errors contain its name.
pub(crate) struct Lines<W> {
    out: W,
    name: String,
    gathered: Vec<u8>,
}

impl<W: Write> Lines<W> {
    pub(crate) fn new(out: W, name: impl Into<String>) -> Self {
        Self { out, name: name.into(), gathered: Vec::new() }
    }

    /// The stream itself. What it has not received is lost.
    pub(crate) fn into_inner(self) -> W {
        self.out
    }

    fn hand_on(&mut self, count: usize) -> io::Result<()> {
        if count > 0 {
            progress::answered();
        }
        let later = self.gathered.split_off(count);
        let due = std::mem::replace(&mut self.gathered, later);
        interrupt::uncut(|| self.out.write_all(&due)).map_err(|e| named(&self.name, e))
    }
}

impl<W: Write> Write for Lines<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.gathered.extend_from_slice(bytes);
        if self.gathered.len() >= GATHERED
            && let Some(end) = self.gathered.iter().rposition(|byte| *byte == b'\n')
        {
            self.hand_on(end + 1)?;
        } else if self.gathered.len() >= NO_LINE {
            self.hand_on(self.gathered.len())?;
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.hand_on(self.gathered.len())?;
        interrupt::uncut(|| self.out.flush()).map_err(|e| named(&self.name, e))
    }
}

/// The error with the name of the file or stream.
pub(crate) fn named(name: &str, error: io::Error) -> io::Error {
    io::Error::new(error.kind(), format!("{name}: {error}"))
}

/// Writes an answer as JSON, indented.
pub(crate) fn json(answer: &impl Serialize, out: &mut impl Write) -> Outcome {
    serde_json::to_writer_pretty(&mut *out, answer)?;
    Ok(out.write_all(b"\n")?)
}

/// A file that is written under a temporary name in the same directory, and renamed when complete.
pub(crate) struct PendingFile {
    place: PathBuf,
    beside: Temporary,
    file: File,
    overwrite: bool,
}

impl PendingFile {
    /// Opens the temporary file before the work begins.
    ///
    /// `argument` names the place in errors. An existing file is kept, unless it is to be overwritten.
    pub(crate) fn create(place: &Path, argument: &str, overwrite: bool) -> Result<Self, Failure> {
        refuse_existing(place, argument, overwrite)?;
        // The target of a link is replaced, not the link.
        let place = if overwrite { fs::canonicalize(place) } else { Err(ErrorKind::NotFound.into()) }
            .unwrap_or_else(|_| place.to_owned());
        let bad = |e| Failure::Input(format!("{argument}: {e}"));
        loop {
            let beside = unique(&place);
            match OpenOptions::new().read(true).write(true).create_new(true).open(&beside) {
                Ok(file) => {
                    let pending = Self { place, beside: Temporary::new(beside), file, overwrite };
                    pending.begin();
                    return Ok(pending);
                }
                Err(e) if e.kind() == ErrorKind::AlreadyExists => {}
                Err(e) => return Err(bad(e)),
            }
        }
    }

    /// Takes the modes of a file that is replaced, and removes the temporary files of commands that were killed.
    fn begin(&self) {
        // A file system may have no locks or no modes.
        let _ = self.file.try_lock();
        if let Some(replaced) = fs::metadata(&self.place).ok().filter(|_| self.overwrite) {
            let _ = self.file.set_permissions(replaced.permissions());
        }
        remove_left(&self.place);
    }

    /// Fills the file and renames it. The temporary file is removed if either fails or the command is
    /// interrupted.
    pub(crate) fn fill(self, fill: impl FnOnce(&mut Lines<&File>) -> Outcome) -> Outcome {
        self.fill_and_seal(fill, |_| Ok(()))
    }

    /// As [`PendingFile::fill`], with a change of the whole file before it appears.
    pub(crate) fn fill_and_seal(
        self,
        fill: impl FnOnce(&mut Lines<&File>) -> Outcome,
        seal: impl FnOnce(&File) -> io::Result<()>,
    ) -> Outcome {
        let name = self.place.display().to_string();
        let mut out = Lines::new(&self.file, name.clone());
        fill(&mut out)?;
        out.flush()?;
        seal(&self.file).map_err(|e| named(&name, e))?;
        self.file.sync_all().map_err(|e| named(&name, e))?;
        let (from, to) = (self.beside.place(), &self.place);
        // A file of that name may have appeared since it was checked.
        let put = if self.overwrite { fs::rename(from, to) } else { put_new(from, to) };
        Ok(put.map_err(|e| named(&name, e))?)
    }
}

/// Moves a file to a place that must be free. A hard link detects an existing file; not all file systems
/// support it.
pub(crate) fn put_new(from: &Path, to: &Path) -> io::Result<()> {
    match fs::hard_link(from, to) {
        Ok(()) => fs::remove_file(from),
        Err(e) if e.kind() == ErrorKind::AlreadyExists => Err(e),
        Err(_) if to.exists() => Err(ErrorKind::AlreadyExists.into()),
        Err(_) => fs::rename(from, to),
    }
}

/// A unique name in the same directory.
fn unique(place: &Path) -> PathBuf {
    static COUNT: AtomicU32 = AtomicU32::new(0);
    let count = COUNT.fetch_add(1, Ordering::Relaxed);
    with_suffix(place, &format!(".{}-{count}.part", process::id()))
}

/// Removes the temporary files of this name whose commands were killed: they have no lock, and no process.
pub(crate) fn remove_left(place: &Path) {
    let (Some(folder), Some(name)) = (place.parent(), place.file_name()) else { return };
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let process = |beside: &Path| {
        let numbers = beside.file_name()?.to_str()?.strip_prefix(name.to_str()?)?;
        let (process, count) = numbers.strip_prefix('.')?.strip_suffix(".part")?.split_once('-')?;
        count.parse::<u32>().ok()?;
        process.parse::<u32>().ok()
    };
    for beside in fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path()) {
        let Some(process) = process(&beside) else { continue };
        let is_running = process == std::process::id() || Path::new(&format!("/proc/{process}")).exists();
        let is_left = || open_regular(&beside).is_ok_and(|file| file.try_lock().is_ok());
        if !is_running && is_left() {
            let _ = fs::remove_file(&beside);
        }
    }
}

/// The path with a suffix added to its name.
pub(crate) fn with_suffix(place: &Path, suffix: &str) -> PathBuf {
    let mut name = place.as_os_str().to_owned();
    name.push(suffix);
    name.into()
}

/// Fails for an existing file that is not to be overwritten, and for a path that is no file.
pub(crate) fn refuse_existing(place: &Path, argument: &str, overwrite: bool) -> Outcome {
    match fs::metadata(place) {
        Ok(found) if !found.is_file() => {
            Err(format!("{argument}: must be a regular file, or not exist yet").into())
        }
        // A link to nothing is there, too.
        Ok(_) | Err(_) if !overwrite && fs::symlink_metadata(place).is_ok() => {
            Err(format!("{argument}: must not exist yet. Replace it with --overwrite").into())
        }
        Ok(_) | Err(_) => Ok(()),
    }
}

/// Locks a file for this command, if the system supports it.
pub(crate) fn take(file: &File, argument: &str) -> Outcome {
    match file.try_lock() {
        Err(TryLockError::WouldBlock) => Err(format!("{argument}: another command is writing to it").into()),
        Ok(()) | Err(TryLockError::Error(_)) => Ok(()),
    }
}
