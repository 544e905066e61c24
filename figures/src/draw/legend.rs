//! The legend of lines, marks and colours, beside the panels so that it covers nothing.

use super::line::stroke;
use super::shade::{STEPS, shade};
use super::ticks::ticks;
use super::{Anchor, Canvas, Drawn, Layout, UNITS, mark, write};
use crate::{Axis, Figure, Plane, Scale, Series, Style};
use plotters::element::Rectangle;
use plotters::style::Color;

/// Pixels between two entries.
const LINE: i32 = 22;

/// Draws the legend downwards from an upper left corner, in pixels.
pub(super) fn draw(figure: &Figure, (left, top): (i32, i32), layout: &Layout, canvas: &Canvas<'_>) -> Drawn {
    let mut y = top;
    for series in entries(figure) {
        entry(series, (left, y), canvas)?;
        y += LINE;
    }
    for plane in keys(figure) {
        write(canvas, &plane.label, (left, y + 4), 13, Anchor::Left)?;
        match &plane.scale {
            Scale::Names(names) => y = named(plane, names, (left, y + LINE + 4), canvas)?,
            Scale::Shades { low, high, logarithmic } => {
                let axis = Axis { label: String::new(), low: *low, high: *high, logarithmic: *logarithmic };
                let height = (layout.plots_height() - (y - top) - 2 * LINE).clamp(60, 300);
                ramp(&axis, (left, y + LINE), height, canvas)?;
                y += LINE + height;
            }
        }
    }
    Ok(())
}

/// The width of the legend in pixels, at seven per letter.
pub(super) fn width(figure: &Figure) -> i32 {
    let letters = |text: &str| i32::try_from(text.chars().count()).unwrap_or(i32::MAX / 16);
    let series = entries(figure).into_iter().map(|series| 42 + 7 * letters(&series.key));
    let planes = keys(figure).into_iter().flat_map(|plane| {
        let names = match &plane.scale {
            Scale::Names(names) => names.iter().map(|name| letters(name)).max(),
            Scale::Shades { .. } => Some(8),
        };
        [7 * letters(&plane.label), 28 + 7 * names.unwrap_or(0)]
    });
    series.chain(planes).max().unwrap_or(0)
}

/// The series in the legend, each key once. Series that are named at their points or have no key are omitted.
fn entries(figure: &Figure) -> Vec<&Series> {
    let mut shown: Vec<&Series> = Vec::new();
    for series in figure.panels.iter().flat_map(|panel| &panel.series) {
        let in_place = matches!(series.style, Style::Named | Style::Arrow) || series.key.is_empty();
        if !in_place && !shown.iter().any(|s| s.key == series.key) {
            shown.push(series);
        }
    }
    shown
}

/// The planes in the legend, each label once.
fn keys(figure: &Figure) -> Vec<&Plane> {
    let mut keys: Vec<&Plane> = Vec::new();
    for plane in figure.panels.iter().filter_map(|panel| panel.plane.as_ref()) {
        if !keys.iter().any(|k| k.label == plane.label && k.scale == plane.scale) {
            keys.push(plane);
        }
    }
    keys
}

fn entry(series: &Series, (left, y): (i32, i32), canvas: &Canvas<'_>) -> Drawn {
    let (x, middle) = (left * UNITS, y * UNITS);
    let line = vec![(x, middle), (x + 34 * UNITS, middle)];
    let centre = (x + 17 * UNITS, middle);
    let colour = mark::colour(series.index);
    match series.style {
        Style::Marks => mark::draw(canvas, series.index, centre)?,
        Style::Beyond => mark::beyond(canvas, series.index, (centre.0, centre.1 - 6 * UNITS))?,
        Style::Dots => {
            for shift in [-8, 0, 8] {
                mark::dot(canvas, series.index, (centre.0 + shift * UNITS, centre.1))?;
            }
        }
        Style::Line | Style::Thick | Style::Dashed | Style::Dotted => {
            stroke(canvas, line, series.style, colour)?
        }
        Style::Marked(_) => {
            stroke(canvas, line, series.style, colour)?;
            mark::draw(canvas, series.index, centre)?;
        }
        Style::Note => return write(canvas, &series.key, (left, y), 13, Anchor::Left),
        Style::Arrow | Style::Named => {}
    }
    write(canvas, &series.key, (left + 42, y), 13, Anchor::Left)
}

/// Draws a square for each name that occurs.
fn named(
    plane: &Plane,
    names: &[String],
    (left, top): (i32, i32),
    canvas: &Canvas<'_>,
) -> Result<i32, Error> {
    let mut y = top;
    for (step, name) in (0u32..).zip(names) {
        if !plane.values.iter().any(|&value| plane.scale.step(value) == Some(step)) {
            continue;
        }
        let corner = |dx: i32, dy: i32| ((left + dx) * UNITS, (y + dy) * UNITS);
        canvas.draw(&Rectangle::new([corner(0, -7), corner(20, 7)], plane.scale.colour(step).filled()))?;
        write(canvas, name, (left + 28, y), 13, Anchor::Left)?;
        y += LINE;
    }
    Ok(y)
}

/// Draws the shades from the lowest value at the bottom to the highest.
fn ramp(axis: &Axis, (left, top): (i32, i32), height: i32, canvas: &Canvas<'_>) -> Drawn {
    let steps = STEPS as i32;
    for step in 0..steps {
        let y = |step: i32| (top + height) * UNITS - height * UNITS * step / steps;
        let colour = shade(f64::from(step) / f64::from(steps - 1));
        // Steps overlap, because otherwise the background would show between them.
        let lap = if step + 1 < steps { UNITS } else { 0 };
        let corners = [(left * UNITS, y(step + 1) - lap), ((left + 20) * UNITS, y(step))];
        canvas.draw(&Rectangle::new(corners, colour.filled()))?;
    }
    for (value, text) in ticks(axis) {
        let share = if axis.logarithmic {
            (value / axis.low).ln() / (axis.high / axis.low).ln()
        } else {
            (value - axis.low) / (axis.high - axis.low)
        };
        let y = f64::from(top + height) - f64::from(height) * share;
        write(canvas, &text, (left + 28, y.round() as i32), 13, Anchor::Left)?;
    }
    Ok(())
}

/// Errors of drawing.
type Error = plotters::drawing::DrawingAreaErrorKind<std::io::Error>;

#[cfg(test)]
mod tests {
    use super::keys;
    use crate::{Axis, Figure, Panel, Plane, Scale};

    /// A panel with a plane of this label and shades up to `high`.
    fn panel(label: &str, high: f64) -> Panel {
        let plane = Plane {
            label: label.to_owned(),
            x: vec![1.0, 2.0],
            y: vec![1.0, 2.0],
            values: vec![0.0, 0.5, 0.25, high],
            scale: Scale::Shades { low: 0.0, high, logarithmic: false },
        };
        let axis = |name| Axis::linear(name, 1.0, 2.0);
        Panel { title: String::new(), x: axis("x"), y: axis("y"), plane: Some(plane), series: Vec::new() }
    }

    /// The heights at which a text occurs in the drawing.
    fn heights(drawing: &str, text: &str) -> Vec<i32> {
        let elements = drawing.split("<text ").skip(1);
        let with_it =
            elements.filter(|e| e.split('<').next().unwrap().trim_end().ends_with(&format!(">\n{text}")));
        with_it.map(|e| e.split("y=\"").nth(1).unwrap().split('"').next().unwrap().parse().unwrap()).collect()
    }

    #[test]
    fn a_key_for_each_meaning_one_below_the_other() {
        let figure = Figure {
            name: "two".to_owned(),
            title: String::new(),
            caption: String::new(),
            panels: vec![panel("warm", 1.0), panel("warm", 1.0), panel("cold", 1.0), panel("cold", 2.0)],
        };
        let labels: Vec<_> = keys(&figure).iter().map(|plane| plane.label.as_str()).collect();
        assert_eq!(labels, ["warm", "cold", "cold"]);
        let drawing = figure.svg().unwrap();
        let (warm, cold) = (heights(&drawing, "warm"), heights(&drawing, "cold"));
        assert!(warm.len() == 1 && cold.len() == 2, "{warm:?} {cold:?}");
        // At least 60 pixels of shades lie between each key and the next.
        assert!(cold[0] > warm[0] + 600 && cold[1] > cold[0] + 600, "{warm:?} {cold:?}");
    }
}
