//! The parts of an incomplete Parquet file: `FILE.parts/START-END.parquet`.

use super::{PendingFile, Sweep, error_at, open, sealed};
use crate::failure::{Failure, Outcome};
use crate::interrupt;
use crate::output::{self, Lines, named, put_new, with_suffix};
use crate::parquet_file::Group;
use parquet::file::reader::FileReader;
use std::fs::{self, File};
use std::ops::Range;
use std::path::{Path, PathBuf};

/// A directory of parts, locked by this command.
pub(super) struct Parts {
    folder: PathBuf,
    lock: File,
    /// The ranges of the parts, in order and contiguous.
    parts: Vec<Range<u64>>,
}

/// The lock file exists as long as the directory does; the lock on it decides.
const LOCK: &str = "lock";

impl Parts {
    /// Opens the directory of a file, or creates it; an existing one is resumed only if requested.
    pub(super) fn open(file: &Path, resume: bool) -> Result<Self, Failure> {
        let folder = with_suffix(file, ".parts");
        let name = folder.display();
        if !resume && folder.exists() {
            let text = format!(
                "--out {}: {name} has the parts of an interrupted sweep. Continue it with --resume",
                file.display()
            );
            return Err(text.into());
        }
        let bad = |e: std::io::Error| Failure::Input(format!("--out {}: {name}: {e}", file.display()));
        let made = fs::create_dir(&folder);
        if made.is_err() && !folder.is_dir() {
            made.map_err(bad)?;
        }
        let mut ranges = Vec::new();
        let mut left = Vec::new();
        for entry in fs::read_dir(&folder).map_err(bad)? {
            let path = entry.map_err(bad)?.path();
            let end = path.extension().and_then(|end| end.to_str());
            match (range_of(&path), end) {
                (Some(range), _) => ranges.push(range),
                (None, Some("part")) => left.push(path),
                (None, _) if path.ends_with(LOCK) => {}
                (None, _) => return Err(error_at(&path, "is not a part of a sweep")),
            }
        }
        let lock =
            File::options().create(true).truncate(false).write(true).open(folder.join(LOCK)).map_err(bad)?;
        output::take(&lock, &format!("--out {}", file.display()))?;
        // Incomplete parts, which were being written when the sweep was interrupted.
        left.iter().try_for_each(fs::remove_file).map_err(bad)?;
        ranges.sort_unstable_by_key(|range| (range.start, range.end));
        Ok(Self { folder, lock, parts: ranges })
    }

    /// The point after the last part, if each part belongs to this sweep.
    pub(super) fn check(&self, sweep: &Sweep<'_>) -> Result<u64, Failure> {
        let mut next = sweep.part.start;
        for range in &self.parts {
            let path = self.path(range);
            if range.start != next || range.end <= next || range.end > sweep.part.end {
                return Err(error_at(
                    &path,
                    &format!("of another sweep, whose next part begins at row {next}"),
                ));
            }
            sweep.check(&path, range.clone()).map_err(|what| error_at(&path, &what))?;
            next = range.end;
            interrupt::check()?;
        }
        Ok(next)
    }

    /// Writes a part, which appears complete or not at all.
    pub(super) fn add(
        &mut self,
        range: Range<u64>,
        fill: impl FnOnce(&mut Lines<&File>) -> Outcome,
    ) -> Outcome {
        let path = self.path(&range);
        let pending = PendingFile::create(&path, &path.display().to_string(), false)?;
        pending.fill_and_seal(fill, sealed::seal)?;
        self.parts.push(range);
        Ok(())
    }

    /// Merges the parts into the file, which appears complete or not at all, and removes them.
    pub(super) fn become_file(self, file: &Path, sweep: &Sweep<'_>) -> Outcome {
        if let [whole] = self.parts.as_slice() {
            put_new(&self.path(whole), file).map_err(|e| named(&file.display().to_string(), e))?;
            return self.remove(&[]);
        }
        let argument = format!("--out {}", file.display());
        let merge = |out: &mut Lines<&File>| {
            let mut writer = sweep.writer(out)?;
            let mut gathered = Group::of(sweep.rows.form());
            for range in &self.parts {
                let reader = open(&self.path(range))?;
                for group in 0..reader.num_row_groups() {
                    let group = reader.get_row_group(group)?;
                    let readers = (0..group.num_columns()).map(|column| group.get_column_reader(column));
                    let mut readers = readers.collect::<Result<Vec<_>, _>>()?;
                    let mut left = usize::try_from(group.metadata().num_rows()).unwrap_or(0);
                    while left > 0 {
                        interrupt::check()?;
                        left -= gathered.read(&mut readers, left)?;
                        if gathered.is_full() {
                            gathered.write(&mut writer)?;
                        }
                    }
                }
            }
            gathered.write(&mut writer)?;
            writer.finish()?;
            Ok(())
        };
        PendingFile::create(file, &argument, false)?.fill_and_seal(merge, sealed::seal)?;
        let parts = self.parts.clone();
        self.remove(&parts)
    }

    /// Removes what a command that was killed left of a file that was completed: its remaining parts, and its temporary
    /// files. Parts of another sweep are named, and stay.
    pub(super) fn remove_left(file: &Path, sweep: &Sweep<'_>) -> Outcome {
        output::remove_left(file);
        if !with_suffix(file, ".parts").exists() {
            return Ok(());
        }
        let parts = Self::open(file, true)?;
        for range in &parts.parts {
            let path = parts.path(range);
            let is_within = sweep.part.start <= range.start && range.end <= sweep.part.end;
            let checked = if is_within && range.start < range.end {
                sweep.check(&path, range.clone())
            } else {
                Err(format!("of another sweep, which {} is not", file.display()))
            };
            checked.map_err(|what| error_at(&path, &what))?;
        }
        let ranges = parts.parts.clone();
        parts.remove(&ranges)
    }

    /// Removes a directory without parts.
    pub(super) fn remove_empty(self) -> Outcome {
        if self.parts.is_empty() { self.remove(&[]) } else { Ok(()) }
    }

    fn remove(self, parts: &[Range<u64>]) -> Outcome {
        parts.iter().try_for_each(|range| fs::remove_file(self.path(range)))?;
        drop(self.lock);
        fs::remove_file(self.folder.join(LOCK))?;
        Ok(fs::remove_dir(&self.folder)?)
    }

    fn path(&self, range: &Range<u64>) -> PathBuf {
        self.folder.join(format!("{:012}-{:012}.parquet", range.start, range.end))
    }
}

/// The points of a part, from its name.
fn range_of(path: &Path) -> Option<Range<u64>> {
    let (start, end) = path.file_name()?.to_str()?.strip_suffix(".parquet")?.split_once('-')?;
    Some(start.parse().ok()?..end.parse().ok()?)
}
