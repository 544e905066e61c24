//! The width of a text, and texts that fit their room. Fonts differ, so that widths are those of a wide one (DejaVu Sans).

/// The width of a text of this size, in pixels.
pub(super) fn width(text: &str, size: i32) -> i32 {
    let ems: f64 = text.chars().map(ems).sum();
    (ems * f64::from(size)).ceil() as i32
}

/// The width of a letter in its size.
fn ems(letter: char) -> f64 {
    match letter {
        'i' | 'j' | 'l' | 'I' | '\'' => 0.30,
        ' ' | '.' | ',' | ':' | ';' | '·' | '/' | '|' | '′' => 0.34,
        'f' | 't' | 'r' | '(' | ')' | '[' | ']' | '-' | '!' | '⁰'..='⁹' | '¹' | '²' | '³' | '₀'..='₉' => {
            0.42
        }
        '⁻' | '"' | '*' | '°' | '?' => 0.54,
        'm' | 'w' | 'M' | 'W' | '%' | '@' | '…' | '–' | '—' => 1.0,
        'A'..='Z' | '−' | '=' | '+' | '<' | '>' | '~' | '≤' | '≥' | '→' | 'Ω' | 'φ' | 'ω' | '&' | '#' => {
            0.84
        }
        letter if letter.is_alphanumeric() && u32::from(letter) > 0x2e80 => 1.0,
        _ => 0.68,
    }
}

/// The text in lines of this width, at most so many; what remains is cut. Lines end at commas where that gives no more
/// of them than allowed, so that a symbol stays beside its value.
pub(super) fn lines(text: &str, size: i32, room: i32, most: usize) -> Vec<String> {
    let places = text.match_indices(", ").map(|(place, _)| place + 1);
    let ends: Vec<usize> = places.chain([text.len()]).collect();
    let starts = std::iter::once(0).chain(ends.iter().map(|end| end + 1));
    let clauses = set(starts.zip(&ends).filter_map(|(from, to)| text.get(from..*to)), size, room);
    if clauses.len() <= most && clauses.iter().all(|line| width(line, size) <= room) {
        return clauses;
    }
    let mut lines = set(text.split(' '), size, room);
    if lines.len() > most {
        let rest = lines.split_off(most.saturating_sub(1)).join(" ");
        lines.push(rest);
    }
    lines.into_iter().map(|line| cut(&line, size, room)).collect()
}

/// The parts of a text in lines that are as long as the room allows.
fn set<'a>(parts: impl Iterator<Item = &'a str>, size: i32, room: i32) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for part in parts {
        match lines.last_mut() {
            Some(line) if width(line, size) + width(" ", size) + width(part, size) <= room => {
                line.push(' ');
                line.push_str(part);
            }
            Some(_) | None => lines.push(part.to_owned()),
        }
    }
    lines
}

/// The name of an axis in lines of this width: where it has to be cut, its unit stays whole.
pub(super) fn name_in_lines(text: &str, size: i32, room: i32, most: usize) -> Vec<String> {
    let found = lines(text, size, room, most);
    let is_cut = found.iter().any(|line| line.ends_with('…'));
    match text.rfind(" (").map(|place| text.split_at(place)) {
        Some((name, unit)) if is_cut && most > 1 => {
            vec![cut(name, size, room), cut(unit.trim_start(), size, room)]
        }
        Some((name, unit)) if is_cut && width(unit, size) < room => {
            vec![cut(name, size, room - width(unit, size)) + unit]
        }
        _ => found,
    }
}

/// The text, cut where it is wider than the room.
fn cut(text: &str, size: i32, room: i32) -> String {
    if width(text, size) <= room {
        return text.to_owned();
    }
    let mut kept = String::new();
    for letter in text.chars() {
        kept.push(letter);
        if width(&kept, size) + width("…", size) > room {
            kept.pop();
            break;
        }
    }
    kept + "…"
}

/// Which of the texts at these places, each with the length that it takes there, are shown: all, or every second, third, … one, so that none meets another.
pub(super) fn shown(places: &[(i32, i32)], gap: i32) -> Vec<bool> {
    let apart = |every: &usize| {
        let kept: Vec<_> = places.iter().step_by(*every).collect();
        kept.windows(2).all(|pair| match pair {
            [(a, first), (b, second)] => (a - b).abs() >= (first + second) / 2 + gap,
            _ => true,
        })
    };
    let every = (1..places.len()).find(apart).unwrap_or(places.len()).max(1);
    (0..places.len()).map(|i| i % every == 0).collect()
}

#[cfg(test)]
mod tests {
    use super::{lines, name_in_lines, shown, width};

    #[test]
    fn a_long_text_is_set_in_lines() {
        assert_eq!(lines("a block on a bench", 14, 1000, 3), ["a block on a bench"]);
        assert_eq!(lines("a block on a bench", 14, 80, 3), ["a block", "on a", "bench"]);
        let two = lines("a block on a bench", 14, 80, 2);
        assert!(two.len() == 2 && two[1].starts_with("on a b") && two[1].ends_with('…'), "{two:?}");
        assert_eq!(lines("", 14, 80, 3), [""]);
        let one = lines("aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa", 14, 80, 3);
        assert_eq!(lines("a", 14, 0, 1), ["…"]);
        assert!(one.len() == 1 && one[0].ends_with('…') && width(&one[0], 14) <= 80, "{one:?}");
    }

    #[test]
    fn a_value_stays_beside_its_symbol() {
        let title = "Motion: m = 50 t, k = 1 kN/mm, f = 1 Hz";
        assert_eq!(lines(title, 14, 160, 3), ["Motion: m = 50 t,", "k = 1 kN/mm,", "f = 1 Hz"]);
        // Two lines have no room for whole clauses.
        assert_eq!(lines(title, 14, 150, 2)[0], "Motion: m = 50 t, k");
        assert_eq!(lines("k = 1 kN/mm", 14, 70, 2), ["k = 1", "kN/mm"]);
    }

    #[test]
    fn an_axis_keeps_its_unit() {
        let name = "residual displacement (mm)";
        assert_eq!(name_in_lines(name, 14, 400, 2), [name]);
        assert_eq!(name_in_lines(name, 14, 170, 2), ["residual", "displacement (mm)"]);
        assert_eq!(name_in_lines(name, 14, 120, 2), ["residual displ…", "(mm)"]);
        let one = name_in_lines(name, 14, 120, 1);
        assert!(one.len() == 1 && one[0].ends_with("… (mm)") && width(&one[0], 14) <= 120, "{one:?}");
        assert_eq!(name_in_lines("displacement x/B", 14, 60, 1), ["displ…"]);
    }

    #[test]
    fn labels_that_would_meet_are_left_out() {
        assert_eq!(shown(&[(0, 10), (20, 10), (40, 10)], 5), [true, true, true]);
        assert_eq!(shown(&[(0, 18), (20, 18), (40, 18)], 5), [true, false, true]);
        assert_eq!(shown(&[(40, 90), (20, 90), (0, 90)], 5), [true, false, false]);
        assert!(shown(&[], 5).is_empty() && shown(&[(1, 900)], 5) == [true]);
    }
}
