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

/// The text in lines of this width, at most so many; what remains is cut.
pub(super) fn lines(text: &str, size: i32, room: i32, most: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ') {
        match lines.last_mut() {
            Some(line) if width(line, size) + width(" ", size) + width(word, size) <= room => {
                line.push(' ');
                line.push_str(word);
            }
            Some(_) | None => lines.push(word.to_owned()),
        }
    }
    if lines.len() > most {
        let rest = lines.split_off(most.saturating_sub(1)).join(" ");
        lines.push(rest);
    }
    lines.into_iter().map(|line| cut(&line, size, room)).collect()
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
    use super::{lines, shown, width};

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
    fn labels_that_would_meet_are_left_out() {
        assert_eq!(shown(&[(0, 10), (20, 10), (40, 10)], 5), [true, true, true]);
        assert_eq!(shown(&[(0, 18), (20, 18), (40, 18)], 5), [true, false, true]);
        assert_eq!(shown(&[(40, 90), (20, 90), (0, 90)], 5), [true, false, false]);
        assert!(shown(&[], 5).is_empty() && shown(&[(1, 900)], 5) == [true]);
    }
}
