//! The names of columns, with their units.

/// The name of a column and its unit, from a header such as `frequency[Hz]` or `Time (s)`.
#[must_use]
pub fn name_and_unit(header: &str) -> (&str, Option<&str>) {
    let text = header.trim_start_matches('\u{feff}').trim();
    let within = |open: char, close: char| text.strip_suffix(close).and_then(|text| text.split_once(open));
    match within('[', ']').or_else(|| within('(', ')')) {
        Some((own, unit)) => (own.trim(), Some(unit.trim())),
        None => (text, None),
    }
}

/// Whether `text` looks like a misspelling of `column`: one edit in ten letters, two in more.
#[must_use]
pub fn is_misspelt(text: &str, column: &str) -> bool {
    let allowed = match column.len() {
        0..5 => 0,
        5..10 => 1,
        _ => 2,
    };
    text.len() <= column.len().saturating_add(2)
        && strsim::osa_distance(&text.to_lowercase(), column) <= allowed
}
