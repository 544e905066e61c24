//! The boxes of the texts in a drawing: none leaves the drawing, and none meets another.

/// The widths of the letters of DejaVu Sans, a wide font, in thousandths of the size: from a space to `~`, and further ones.
const WIDTHS: [u16; 95] = [
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361, 318, 337, 636, 636, 636, 636, 636,
    636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531, 1000, 684, 686, 698, 770, 632, 575, 775, 752, 295,
    295, 656, 557, 863, 748, 787, 603, 787, 695, 635, 611, 732, 684, 989, 685, 611, 685, 390, 337, 390, 838,
    500, 500, 613, 635, 550, 635, 615, 352, 635, 634, 278, 278, 579, 278, 974, 634, 612, 635, 635, 411, 521,
    392, 634, 592, 818, 592, 592, 525, 636, 337, 636, 838,
];

/// The width of a letter in its size.
fn width(letter: char) -> f64 {
    let thousandths = match letter {
        ' '..='~' => WIDTHS[letter as usize - ' ' as usize],
        '−' | '≤' | '≥' | '→' => 838,
        '·' => 318,
        '⁰'..='⁹' | '¹' | '²' | '³' | '₀'..='₉' => 401,
        '⁻' => 528,
        '′' => 227,
        '…' => 1000,
        _ => 660,
    };
    f64::from(thousandths) / 1000.0
}

/// A text with its box: left, top, right and bottom.
#[derive(Debug, Clone)]
pub(crate) struct Text {
    pub(crate) words: String,
    pub(crate) of: [f64; 4],
}

fn attribute<'a>(tag: &'a str, name: &str) -> Option<&'a str> {
    tag.split(&format!(" {name}=\"")).nth(1)?.split('"').next()
}

/// The size of a drawing in its own units, and its texts.
pub(crate) fn texts(svg: &str) -> ([f64; 2], Vec<Text>) {
    let head = svg.split('>').find(|tag| tag.contains("<svg")).unwrap();
    let ends: Vec<f64> =
        attribute(head, "viewBox").unwrap().split([' ', ',']).map(|number| number.parse().unwrap()).collect();
    let text = |element: &str| {
        let (tag, rest) = element.split_once('>').unwrap();
        let tag = format!(" {tag}");
        // A size that all texts share is that of the drawing.
        let number = |name: &str| {
            attribute(&tag, name).or_else(|| attribute(head, name)).unwrap().parse::<f64>().unwrap()
        };
        let (x, y, size) = (number("x"), number("y"), number("font-size"));
        let rest = rest.split("</text>").next().unwrap();
        // Subscripts are smaller; their tags have no text.
        let weight = if tag.contains("bold") { 1.1 } else { 1.0 };
        let mut words = String::new();
        let mut length = 0.0;
        for part in rest.split('<') {
            let (tag, shown) = part.split_once('>').unwrap_or(("", part));
            let shown =
                shown.trim_matches('\n').replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&");
            let share = if tag.contains("font-size") { 0.72 } else { weight };
            length += share * size * shown.chars().map(width).sum::<f64>();
            words += &shown;
        }
        let baseline = match attribute(&tag, "dy") {
            Some("0.76em") => 0.76 * size,
            Some("0.5ex") => 0.27 * size,
            None => 0.0,
            other => panic!("{words}: a text placed by {other:?}"),
        };
        let start = match attribute(&tag, "text-anchor") {
            Some("middle") => -length / 2.0,
            Some("end") => -length,
            Some("start") | None => 0.0,
            other => panic!("{words}: a text anchored by {other:?}"),
        };
        // Letters reach from the height of a capital above the line to the tail of a g below it.
        let (above, below) = (baseline - 0.73 * size, baseline + 0.2 * size);
        let of = if tag.contains("rotate(270") {
            [x + above, y - start - length, x + below, y - start]
        } else {
            [x + start, y + above, x + start + length, y + below]
        };
        Text { words: words.trim().to_owned(), of }
    };
    let found = svg.split("<text").skip(1).map(text).filter(|text| !text.words.is_empty()).collect();
    ([ends[2], ends[3]], found)
}

/// What is wrong with the texts of a drawing, and their number.
pub(crate) fn faults(svg: &str) -> (Vec<String>, usize) {
    let ([width, height], found) = texts(svg);
    let mut faults = Vec::new();
    for (i, text) in found.iter().enumerate() {
        let [left, top, right, bottom] = text.of;
        if left < 0.0 || top < 0.0 || right > width || bottom > height {
            faults
                .push(format!("“{}” leaves the drawing: {:.0?} of {width} × {height}", text.words, text.of));
        }
        for other in &found[..i] {
            let [l, t, r, b] = other.of;
            if left < r && l < right && top < b && t < bottom {
                faults.push(format!(
                    "“{}” meets “{}”: {:.0?} and {:.0?}",
                    text.words, other.words, text.of, other.of
                ));
            }
        }
    }
    (faults, found.len())
}
