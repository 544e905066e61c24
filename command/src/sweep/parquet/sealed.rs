//! A checksum of a whole Parquet file, in its metadata.
//!
//! The note holds zeros while the file is written, and the checksum is that of the file with these zeros. A file is
//! checked before it is parsed: the parser need not be safe for damaged files.

use crate::resume::Checksum;
use parquet::file::metadata::KeyValue;
use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom, Write};

/// The name of the note.
pub(super) const NOTE: &str = "checksum";
/// The beginning of its value, and the digits while there is no checksum.
const BEGIN: &str = "FNV-1a of this file with zeros here: ";
const ZEROS: &str = "0000000000000000";

/// The last bytes of a file: the length of its metadata in four bytes, and a word.
const END: u64 = 8;
/// The greatest length of metadata in bytes.
const LONGEST: u64 = 1 << 28;

/// The note of a file that is being written.
pub(super) fn note() -> KeyValue {
    KeyValue::new(NOTE.to_owned(), format!("{BEGIN}{ZEROS}"))
}

/// The position of the digits of the checksum; `None` where the file has none.
fn place(mut file: &File) -> io::Result<Option<u64>> {
    let length = file.metadata()?.len();
    let Some(end) = length.checked_sub(END) else { return Ok(None) };
    file.seek(SeekFrom::Start(end))?;
    let mut count = [0; 4];
    file.read_exact(&mut count)?;
    let count = u64::from(u32::from_le_bytes(count));
    let Some(begin) = end.checked_sub(count).filter(|_| count <= LONGEST) else { return Ok(None) };
    file.seek(SeekFrom::Start(begin))?;
    let mut metadata = Vec::new();
    file.take(count).read_to_end(&mut metadata)?;
    let found = metadata.windows(BEGIN.len()).rposition(|part| part == BEGIN.as_bytes());
    let digits = |at: usize| begin + (at + BEGIN.len()) as u64;
    Ok(found.map(digits).filter(|digits| digits + ZEROS.len() as u64 <= end))
}

/// The checksum of the file with zeros in this place.
fn sum(mut file: &File, place: u64) -> io::Result<Checksum> {
    let mut sum = Checksum::EMPTY;
    let mut part = vec![0; 1 << 16];
    let mut add = |from: u64, to: u64, sum: &mut Checksum| {
        file.seek(SeekFrom::Start(from))?;
        let mut some = file.take(to - from);
        loop {
            match some.read(&mut part)? {
                0 => return Ok::<_, io::Error>(()),
                count => sum.add(part.get(..count).unwrap_or_default()),
            }
        }
    };
    add(0, place, &mut sum)?;
    sum.add(ZEROS.as_bytes());
    add(place + ZEROS.len() as u64, u64::MAX, &mut sum)?;
    Ok(sum)
}

/// Writes the checksum into a complete file.
pub(super) fn seal(mut file: &File) -> io::Result<()> {
    let place = place(file)?.ok_or_else(|| io::Error::other("the file has no place for its checksum"))?;
    let sum = sum(file, place)?;
    file.seek(SeekFrom::Start(place))?;
    file.write_all(sum.text().as_bytes())
}

/// Fails unless a file is as it was sealed.
pub(super) fn check(mut file: &File) -> Result<(), String> {
    let text = |e: io::Error| e.to_string();
    let missing = || "it is damaged, or no file of a sweep: its checksum is missing".to_owned();
    let place = place(file).map_err(text)?.ok_or_else(missing)?;
    let mut found = [0; ZEROS.len()];
    file.seek(SeekFrom::Start(place)).and_then(|_| file.read_exact(&mut found)).map_err(text)?;
    if sum(file, place).map_err(text)?.text().as_bytes() == found {
        return Ok(());
    }
    Err("it is damaged: its checksum is not that of its content. Remove it to begin anew".to_owned())
}
