//! No text of a picture leaves it or meets another: the figures, and axes of any range at every size.

#[path = "../../tests/text_boxes/mod.rs"]
mod text_boxes;

use stickslip_figures::{Axis, Figure, NAMES, Panel, Series, Style, figure};

/// The least size of a picture, from the message that names it.
fn least(figure: &Figure) -> (u32, u32) {
    let message = figure.svg_of_size((1, 1)).unwrap_err().to_string();
    let size = message.split("from ").nth(1).unwrap().split(',').next().unwrap();
    let (width, height) = size.split_once('x').unwrap();
    (width.parse().unwrap(), height.parse().unwrap())
}

#[test]
fn the_texts_of_the_figures_keep_apart() {
    for name in NAMES {
        let figure = figure(name).unwrap();
        let (faults, texts) = text_boxes::faults(&figure.svg().unwrap());
        assert!(faults.is_empty() && texts > 5, "{name}: {faults:#?}");
    }
}

#[test]
fn the_texts_of_any_axes_keep_apart_at_any_size() {
    let ranges = [
        (0.0, 1.0),
        (-1e9, 1e9),
        (-3e-7, 4e-7),
        (5.00004, 5.00006),
        (-250_000.0, 250_000.0),
        (3.0, 3.0),
        (1.0, 1.0 + 4.0 * f64::EPSILON),
        (0.0, 5e-324),
        (-f64::MAX, f64::MAX),
        (1e-300, 1e300),
        (0.02, 0.9),
    ];
    let mut tried = 0;
    for across in ranges {
        for up in ranges {
            for (panels, logarithmic) in [(1, false), (1, true), (2, false), (5, true)] {
                let axis = |label: &str, (low, high)| Axis::new(label, (low, high), logarithmic && low > 0.0);
                let panel = |i: usize| {
                    let curve = Series::new(
                        "peak displacement",
                        Style::Line,
                        0,
                        [(across.0, up.0), (across.1, up.1)],
                    );
                    let (x, y) =
                        (axis("displacement (mm)", across), axis("absolute acceleration (m/s²)", up));
                    Panel::new(format!("panel {i}, α = p₀/r_y"), x, y, vec![curve])
                };
                let title = "Feeder 7 after its overhaul, ".repeat(if panels == 2 { 12 } else { 1 });
                let figure = Figure::new("f", title, "", (0..panels).map(panel).collect::<Vec<_>>());
                let (width, height) = least(&figure);
                for size in [None, Some((width, height)), Some((width + 200, height + 37))] {
                    let svg = size.map_or_else(|| figure.svg(), |size| figure.svg_of_size(size)).unwrap();
                    let (faults, texts) = text_boxes::faults(&svg);
                    let of = format!("{across:?}, {up:?}, {panels} panels, {size:?}");
                    assert!(faults.is_empty(), "{of}: {faults:#?}");
                    assert!(texts > 4 * panels, "{of}: {texts} texts");
                    tried += 1;
                }
            }
        }
    }
    assert_eq!(tried, 11 * 11 * 4 * 3);
}
