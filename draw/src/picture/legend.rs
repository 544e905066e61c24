//! The legend of lines, marks and colours, in a single panel where there is room, otherwise beside the panels.

use super::canvas::{Anchor, Canvas, Drawn, TEXT, UNITS, write};
use super::mark::stroke;
use super::scale::drawn;
use super::shade::{STEPS, shade};
use super::{letters, mark};
use crate::figure::{Axis, Figure, Series, Style};
use crate::plane::{Plane, Scale};
use plotters::element::Rectangle;
use plotters::style::{Color, RGBColor, WHITE};

/// Pixels between two entries.
const LINE: i32 = 22;
/// Pixels between the legend and the frame around it.
pub(super) const ROOM: i32 = 14;

/// Draws the legend downwards from an upper left corner, in pixels: inside a plot or not, beside plots of this height.
pub(super) fn draw(
    figure: &Figure,
    (left, top): (i32, i32),
    (is_inside, height): (bool, i32),
    canvas: &Canvas<'_>,
) -> Drawn {
    let mut y = top + LINE / 2;
    if is_inside && !entries(figure).is_empty() {
        let (width, height) = size(figure);
        let corners = [(left - 6, top - 4), (left + width + 6, top + height + 4)];
        let corners = corners.map(|(x, y)| (x * UNITS, y * UNITS));
        canvas.draw(&Rectangle::new(corners, WHITE.filled()))?;
        canvas.draw(&Rectangle::new(corners, RGBColor(200, 200, 200).stroke_width(UNITS.unsigned_abs())))?;
    }
    for series in entries(figure) {
        entry(series, (left, y), canvas)?;
        y += LINE;
    }
    for plane in keys(figure) {
        write(canvas, &plane.label, (left, y + 4), TEXT, Anchor::Left)?;
        match &plane.scale {
            Scale::Names(names) => y = named(plane, names, (left, y + LINE + 4), canvas)?,
            Scale::Shades { low, high, logarithmic } => {
                let axis = Axis::new("", (*low, *high), *logarithmic);
                let height = (height - (y - top) - 2 * LINE).clamp(60, 300);
                ramp(&axis, (left, y + LINE), height, canvas)?;
                y += LINE + height;
            }
        }
    }
    Ok(())
}

/// The width of the legend in pixels.
pub(super) fn width(figure: &Figure) -> i32 {
    let letters = |text: &str| letters::width(text, TEXT);
    let series = entries(figure).into_iter().map(|series| 42 + letters(&series.key));
    let planes = keys(figure).into_iter().flat_map(|plane| {
        let names = match &plane.scale {
            Scale::Names(names) => names.iter().map(|name| letters(name)).max(),
            Scale::Shades { .. } => Some(80),
        };
        [letters(&plane.label), 28 + names.unwrap_or(0)]
    });
    series.chain(planes).max().unwrap_or(0)
}

/// The width and the height of the legend of a figure without planes.
pub(super) fn size(figure: &Figure) -> (i32, i32) {
    let lines = i32::try_from(entries(figure).len()).unwrap_or(i32::MAX / LINE);
    (width(figure), lines * LINE)
}

/// The upper left corners of the legend in a plot, best first: its corners, then the middle of its sides. `None`
/// for a figure with planes or without entries.
pub(super) fn places(figure: &Figure, (left, top): (i32, i32), plot: (i32, i32)) -> Option<[(i32, i32); 7]> {
    let (width, height) = size(figure);
    if height == 0 || !keys(figure).is_empty() {
        return None;
    }
    let (right, middle) = (left + plot.0 - width - ROOM, left + (plot.0 - width) / 2);
    let (bottom, centre) = (top + plot.1 - height - ROOM, top + (plot.1 - height) / 2);
    let (left, top) = (left + ROOM, top + ROOM);
    let places = [(right, top), (left, top), (right, bottom), (left, bottom)];
    let [a, b, c, d] = places;
    Some([a, b, c, d, (middle, top), (right, centre), (left, centre)])
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

/// Whether the legend has series, and no planes.
pub(super) fn is_of_series(figure: &Figure) -> bool {
    keys(figure).is_empty() && !entries(figure).is_empty()
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
        Style::Note => return write(canvas, &series.key, (left, y), TEXT, Anchor::Left),
        Style::Arrow | Style::Named => {}
    }
    write(canvas, &series.key, (left + 42, y), TEXT, Anchor::Left)
}

/// Draws a square for each name that occurs.
fn named(plane: &Plane, names: &[String], (left, top): (i32, i32), canvas: &Canvas<'_>) -> Drawn<i32> {
    let mut y = top;
    for (step, name) in (0u32..).zip(names) {
        if !plane.values.iter().any(|&value| plane.scale.step(value) == Some(step)) {
            continue;
        }
        let corner = |dx: i32, dy: i32| ((left + dx) * UNITS, (y + dy) * UNITS);
        canvas.draw(&Rectangle::new([corner(0, -7), corner(20, 7)], plane.scale.colour(step).filled()))?;
        write(canvas, name, (left + 28, y), TEXT, Anchor::Left)?;
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
    for (value, text) in drawn(axis).1 {
        let y = f64::from(top + height) - f64::from(height) * axis.share(value);
        write(canvas, &text, (left + 28, y.round() as i32), TEXT, Anchor::Left)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::keys;
    use crate::figure::{Axis, Figure, Panel, Series, Style};
    use crate::plane::{Plane, Scale};

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
            is_stacked: false,
        };
        let labels: Vec<_> = keys(&figure).iter().map(|plane| plane.label.as_str()).collect();
        assert_eq!(labels, ["warm", "cold", "cold"]);
        let drawing = figure.svg().unwrap();
        let (warm, cold) = (heights(&drawing, "warm"), heights(&drawing, "cold"));
        assert!(warm.len() == 1 && cold.len() == 2, "{warm:?} {cold:?}");
        // At least 60 pixels of shades lie between each key and the next.
        assert!(cold[0] > warm[0] + 600 && cold[1] > cold[0] + 600, "{warm:?} {cold:?}");
    }

    /// A panel of curves through these points of the unit square.
    fn curves(points: Vec<Vec<(f64, f64)>>) -> Figure {
        let axis = |name| Axis::linear(name, 0.0, 1.0);
        let series = points.into_iter().enumerate();
        let series = series.map(|(i, points)| Series::new(format!("curve {i}"), Style::Line, i, points));
        let panel =
            Panel { title: String::new(), x: axis("x"), y: axis("y"), plane: None, series: series.collect() };
        Figure::new("one", "", "", [panel])
    }

    /// The left edge of a text in the drawing, and its height, in units of the drawing.
    fn place(drawing: &str, text: &str) -> (i32, i32) {
        let element = drawing.split("<text ").find(|e| e.contains(&format!(">\n{text}\n"))).unwrap();
        let number = |name: &str| {
            element.split(&format!(" {name}=\"")).nth(1).unwrap().split('"').next().unwrap().parse().unwrap()
        };
        (
            format!(" {element}").split(" x=\"").nth(1).unwrap().split('"').next().unwrap().parse().unwrap(),
            number("y"),
        )
    }

    /// The legend takes the first corner that no curve crosses; without one it stands beside the plot.
    #[test]
    fn a_legend_covers_nothing() {
        let rising = vec![(0.0, 0.0), (1.0, 1.0)];
        let falling = vec![(0.0, 1.0), (1.0, 0.0)];
        let edge = |y| vec![(0.0, y), (1.0, y)];
        let plot = (super::super::LEFT * super::UNITS, (super::super::LEFT + 640) * super::UNITS);
        let middle = ((plot.0 + plot.1) / 2, (super::super::TOP + 220) * super::UNITS);
        for (points, is_right, is_top) in [
            (vec![edge(0.5)], true, true),
            (vec![rising.clone()], false, true),
            (vec![rising.clone(), edge(0.95)], true, false),
            (vec![edge(0.95), falling.clone()], false, false),
        ] {
            let (x, y) = place(&curves(points.clone()).svg().unwrap(), "curve 0");
            assert!(plot.0 < x && x < plot.1, "{points:?}: {x}");
            assert_eq!((x > middle.0, y < middle.1), (is_right, is_top), "{points:?}: {x} {y}");
        }
        let everywhere: Vec<_> = (0..=20).map(|i| edge(f64::from(i) / 20.0)).collect();
        assert!(place(&curves(everywhere).svg().unwrap(), "curve 0").0 > plot.1);
    }
}
