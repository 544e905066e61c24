//! The names of the columns of a file, and the errors of its rows.

/// The error for input that the reader cannot parse as a row.
pub(crate) fn unreadable(name: &str, error: &csv::Error) -> String {
    let line = error.position().map_or(String::new(), |p| format!(" line {}", p.line()));
    let text = if let csv::ErrorKind::UnequalLengths { expected_len, len, .. } = error.kind() {
        let hint =
            if len > expected_len { ". A decimal needs a point, because commas separate fields" } else { "" };
        format!("{len} fields, must be {expected_len} as in the header{hint}")
    } else {
        error.to_string()
    };
    format!("{name}{line}: {text}")
}

/// The name of a column and its unit, from a header such as `frequency[Hz]`.
pub(crate) fn name_and_unit(header: &str) -> (&str, Option<&str>) {
    let text = header.trim_start_matches('\u{feff}').trim();
    match text.strip_suffix(']').and_then(|text| text.split_once('[')) {
        Some((own, unit)) => (own.trim(), Some(unit.trim())),
        None => (text, None),
    }
}

/// Whether `text` looks like a misspelling of `column`: one edit in ten letters, two in more.
pub(crate) fn is_misspelt(text: &str, column: &str) -> bool {
    let allowed = match column.len() {
        0..5 => 0,
        5..10 => 1,
        _ => 2,
    };
    text.len() <= column.len() + 2 && strsim::osa_distance(&text.to_lowercase(), column) <= allowed
}
