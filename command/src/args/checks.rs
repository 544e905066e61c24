//! Checks of a command line beyond its grammar: a unit that was typed as a word of its own, and a file that is two
//! arguments, because one of them would destroy the other.

use super::used;
use crate::failure::Outcome;
use clap::ArgMatches;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use stickslip_front::inputs::units::Reader;

/// Fails at an option whose number is followed by a unit, as in `--force 30 N`.
pub(super) fn check_units(words: &[OsString]) -> Outcome {
    for three in words.windows(3) {
        if let [Some(option), Some(number), Some(unit)] = [0, 1, 2].map(|i| three.get(i)?.to_str())
            && option.starts_with("--")
            && number.parse::<f64>().is_ok()
            && Reader::is_unit(unit)
        {
            return Err(format!("{option} {number} {unit}: must be one word, {option} {number}{unit}").into());
        }
    }
    Ok(())
}

/// Fails if two arguments of the command are the same file, by whatever name or link.
pub(super) fn check_files(matches: &ArgMatches) -> Outcome {
    let mut matches = matches;
    while let Some((_, inner)) = matches.subcommand() {
        matches = inner;
    }
    let mut files: Vec<(&str, &PathBuf)> = Vec::new();
    for id in matches.ids() {
        // Arguments of other types are no files.
        if let Ok(Some(file)) = matches.try_get_one::<PathBuf>(id.as_str()) {
            files.push((id.as_str(), file));
        }
    }
    for (i, (first, a)) in files.iter().enumerate() {
        for (second, b) in files.iter().skip(i + 1) {
            if is_same(a, b) {
                let (first, second) = (used::option(first), used::option(second));
                return Err(format!(
                    "{first} {} and {second} {}: must be two different files",
                    a.display(),
                    b.display()
                )
                .into());
            }
        }
    }
    Ok(())
}

/// Whether two paths lead to one file, which need not exist yet.
fn is_same(a: &Path, b: &Path) -> bool {
    let place = |path: &Path| {
        let found = fs::canonicalize(path).ok();
        found.or_else(|| {
            // A link to a file that does not exist yet, or such a file itself, in an existing folder.
            let target = fs::read_link(path).map_or_else(|_| path.to_owned(), |to| beside(path, &to));
            let folder = fs::canonicalize(folder_of(&target)).ok()?;
            Some(folder.join(target.file_name()?))
        })
    };
    match (place(a), place(b)) {
        (Some(a), Some(b)) => a == b || is_one_inode(&a, &b),
        _ => a == b,
    }
}

/// The target of a link, which is relative to the link's folder.
fn beside(link: &Path, target: &Path) -> PathBuf {
    folder_of(link).join(target)
}

fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Whether two names are hard links to one file.
#[cfg(unix)]
fn is_one_inode(a: &Path, b: &Path) -> bool {
    use std::os::unix::fs::MetadataExt as _;
    let of = |path: &Path| fs::metadata(path).ok().filter(fs::Metadata::is_file).map(|m| (m.dev(), m.ino()));
    of(a).is_some_and(|a| of(b) == Some(a))
}

#[cfg(not(unix))]
fn is_one_inode(_: &Path, _: &Path) -> bool {
    false
}
