//! Subscripts: indices written as ω_d, r_y or α_min in the text.

/// The drawing with subscripts set in its texts.
pub(super) fn set(svg: &str) -> String {
    let mut texts = svg.split("<text");
    let mut drawing = texts.next().unwrap_or_default().to_owned();
    for text in texts {
        drawing.push_str("<text");
        match (text.find('>'), text.find("</text>")) {
            (Some(start), Some(end)) if start < end => {
                let (attributes, rest) = text.split_at(start + 1);
                let (words, after) = rest.split_at(end - start - 1);
                drawing.extend([attributes, &lowered(words), after]);
            }
            _ => drawing.push_str(text),
        }
    }
    drawing
}

/// A text whose indices after single letters are set smaller and below the line.
fn lowered(text: &str) -> String {
    let mut parts = text.split('_');
    let mut before = parts.next().unwrap_or_default();
    let mut whole = before.to_owned();
    for part in parts {
        let length = part.find(|c: char| !c.is_ascii_alphanumeric()).unwrap_or(part.len());
        let (index, rest) = part.split_at(length);
        if is_symbol(before) && !index.is_empty() {
            whole.push_str(&format!("<tspan dy=\"0.3em\" font-size=\"0.72em\">{index}</tspan>"));
            if !rest.trim().is_empty() {
                // Move up again by the same length in the larger type. Viewers drop a space at the start.
                let (gap, rest) = match rest.strip_prefix(' ') {
                    Some(rest) => (" dx=\"0.32em\"", rest),
                    None => ("", rest),
                };
                whole.push_str(&format!("<tspan dy=\"-0.216em\"{gap}>{rest}</tspan>"));
            }
        } else {
            whole.push('_');
            whole.push_str(part);
        }
        before = part;
    }
    whole
}

/// Whether a text ends in a single letter: Greek, or Latin and not preceded by another Latin letter.
fn is_symbol(text: &str) -> bool {
    let mut backwards = text.chars().rev();
    match (backwards.next(), backwards.next()) {
        (Some('α'..='ω'), _) => true,
        (Some(last), before) => {
            last.is_ascii_alphabetic() && !before.is_some_and(|c| c.is_ascii_alphanumeric() || c == '_')
        }
        (None, _) => false,
    }
}

#[cfg(test)]
mod tests {
    use super::{lowered, set};

    #[test]
    fn indices_go_below_the_line_and_names_stay() {
        let low = |index: &str| format!("<tspan dy=\"0.3em\" font-size=\"0.72em\">{index}</tspan>");
        let up = |text: &str| format!("<tspan dy=\"-0.216em\">{text}</tspan>");
        assert_eq!(lowered("α_min"), format!("α{}", low("min")));
        assert_eq!(lowered("V₀/(Bω_d) of r_y"), format!("V₀/(Bω{}{}{}", low("d"), up(") of r"), low("y")));
        let apart = "<tspan dy=\"-0.216em\" dx=\"0.32em\">t</tspan>";
        assert_eq!(lowered("ω_d t"), format!("ω{}{apart}", low("d")));
        assert_eq!(lowered("|r_a| ≤ r_y\n"), format!("|r{}{}{}", low("a"), up("| ≤ r"), low("y")));
        for name in ["max_displacement", "steady:stick_fraction", "no index", "a _b"] {
            assert_eq!(lowered(name), name);
        }
    }

    #[test]
    fn only_texts_are_touched() {
        let drawing = set("<svg id=\"x_y\"><text a=\"x_y\">\nr_y\n</text><text>b</text></svg>");
        assert!(drawing.starts_with("<svg id=\"x_y\"><text a=\"x_y\">\nr<tspan"), "{drawing}");
        assert!(drawing.ends_with("</tspan></text><text>b</text></svg>"), "{drawing}");
    }
}
