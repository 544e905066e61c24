//! What leads on from a table that is not read: the options that read its first lines, tried on them, or else what was seen.

use super::samples::Samples;
use super::table::cells::{Row, row, width};
use super::{Head, Options, read_as_table};

/// Files that are no text, by their first bytes.
const BINARY: [(&[u8], &str); 8] = [
    (b"PK\x03\x04", "a zip archive or a workbook of Excel: unpack it, or save it as CSV"),
    (b"\xd0\xcf\x11\xe0", "a workbook of Excel: save it as CSV"),
    (b"\x1f\x8b", "compressed by gzip: unpack it"),
    (b"\x89HDF", "HDF5 or MATLAB 7.3: write its numbers as columns of text"),
    (b"MATLAB 5.0", "of MATLAB: write its numbers as columns of text"),
    (b"TDSm", "TDMS of LabVIEW: export it as text"),
    (b"\x93NUMPY", "of NumPy: write it by numpy.savetxt"),
    (b"RIFF", "a sound file: write its numbers as columns of text"),
];

/// Words of headers, and the layout in which they stand.
const LIKELY: [(&str, &str); 8] = [
    ("npts", "PEER"),
    ("peer", "PEER"),
    ("cosmos", "COSMOS"),
    ("scale factor", "K-NET"),
    ("accelerogram", "CSMIP"),
    ("sampling_interval", "ESM"),
    ("aceleracion", "UNAM"),
    ("timeseries", "SLIST"),
];

/// The most bytes of first lines on which options are tried.
const MOST: usize = 1 << 18;

/// What a file without text is, if it is known.
pub(super) fn binary(bytes: &[u8]) -> Option<&'static str> {
    BINARY.iter().find(|(magic, _)| bytes.starts_with(magic)).map(|(_, what)| *what)
}

/// The error of a table, with the options that would read it or with what was seen of it.
pub(super) fn led(error: String, head: &Head, options: &Options<'_>) -> String {
    let mut text = String::new();
    for (_, line) in &head.lines {
        text.push_str(line);
        text.push('\n');
    }
    let reads = |options: &Options<'_>| {
        let mut samples = Samples::<f64>::new(options.reader);
        let found = read_as_table(&mut text.as_bytes(), options, &mut samples);
        found.and_then(|found| samples.finish(found, options)).is_ok()
    };
    let error_of_a_value = error.ends_with("must be a number") || error.contains("time step = ");
    if head.lines.is_empty() || text.len() > MOST || error_of_a_value || options.skip > 0 || reads(options) {
        return error;
    }
    let most = head.lines.iter().map(|(_, line)| width(line)).max().unwrap_or(0).min(12);
    let numbers: Vec<String> = (1..=most).map(|place| place.to_string()).collect();
    let words = options.words;
    // Where a name, its unit or an option is at fault, the header is one: without it the numbers would be others.
    let is_header = ["unit", "must be left out", "has no column of"].iter().any(|part| error.contains(part));
    let may_skip = !words.skip.is_empty() && !is_header;
    let skips = [0].into_iter().chain(before_rows(head).filter(|skip| *skip > 0 && may_skip));
    for skip in skips {
        let base = Options { skip, ..*options };
        for (has_step, has_unit) in [(false, false), (false, true), (true, false), (true, true)] {
            // Five numbers a line or more, without times, are those of one series.
            let first = [None, Some("all").filter(|_| most >= 5)];
            // Beside times the first column is likely the one that is wanted, and else the last.
            let mut places: Vec<Option<&str>> = numbers.iter().map(|place| Some(place.as_str())).collect();
            if has_step {
                places.reverse();
            }
            for column in first.into_iter().chain(places).chain([Some("all")]) {
                let tried = Options {
                    time_step: base.time_step.or(has_step.then_some("0.01s")),
                    units: base.units.or(has_unit.then_some("g")),
                    column: base.column.or(column),
                    ..base
                };
                if !reads(&tried) {
                    continue;
                }
                let typed = [
                    (skip > 0).then(|| (words.skip, skip.to_string())),
                    base.column
                        .is_none()
                        .then_some(column)
                        .flatten()
                        .map(|text| (words.column, text.to_owned())),
                    (has_step && base.time_step.is_none()).then(|| (words.time_step, "0.01s".to_owned())),
                    (has_unit && base.units.is_none()).then(|| (words.units, "g".to_owned())),
                ];
                let typed: Vec<(&str, String)> = typed.into_iter().flatten().collect();
                // What was said already leads on.
                if typed.iter().all(|(word, _)| error.contains(word)) {
                    return error;
                }
                let typed: Vec<String> = typed.iter().map(|(word, text)| format!("{word} {text}")).collect();
                let values = match (has_step && base.time_step.is_none(), has_unit && base.units.is_none()) {
                    (true, true) => ", if these are its step and unit",
                    (true, false) => ", if this is its step",
                    (false, true) => ", if this is its unit",
                    (false, false) => "",
                };
                return format!("{error}. It is read with {}{values}", typed.join(" "));
            }
        }
    }
    // What these errors say is that the text is no table that is known.
    let is_unknown = ["is missing in the header", "without names", "no row of numbers"]
        .iter()
        .any(|part| error.contains(part));
    if is_unknown { format!("{error}. {}", seen(head)) } else { error }
}

/// The lines before the first three rows of numbers of one width, if no such row stands among them.
fn before_rows(head: &Head) -> Option<u64> {
    let width_of = |line: &str| (row(line) == Row::Numbers).then(|| width(line));
    let widths: Vec<Option<usize>> = head.lines.iter().map(|(_, line)| width_of(line)).collect();
    let place = widths.windows(3).position(|three| match three {
        [Some(a), Some(b), Some(c)] => a == b && b == c,
        _ => false,
    })?;
    let of_rows = widths.get(place)?;
    let is_clear = !widths.get(..place)?.contains(of_rows);
    is_clear.then_some(place as u64)
}

/// What was seen of a file that no option reads.
fn seen(head: &Head) -> String {
    let first = head.lines.iter().position(|(_, line)| row(line) == Row::Numbers);
    let numbers = match first.and_then(|place| head.lines.get(place)) {
        Some((number, line)) => format!("Its line {number} has {} numbers", width(line)),
        None => "None of its first lines begins with a number".to_owned(),
    };
    let words: Vec<String> =
        head.lines.iter().take(first.unwrap_or(8)).map(|(_, line)| line.to_lowercase()).collect();
    let likely = LIKELY.iter().find(|(word, _)| words.iter().any(|line| line.contains(word)));
    let likely = likely.map(|(word, layout)| format!(", and “{word}” is a word of {layout}"));
    numbers + &likely.unwrap_or_default()
}
