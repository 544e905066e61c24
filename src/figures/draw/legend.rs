//! What lines, marks and colours mean, beside the panels so that nothing is covered.

use super::frame::stroke;
use super::shade::{STEPS, shade};
use super::ticks::ticks;
use super::{Anchor, Canvas, Drawn, Layout, UNITS, mark, write};
use crate::figures::{Axis, Figure, Plane, Scale, Series, Style};
use plotters::element::Rectangle;
use plotters::style::Color;

/// Pixels between two entries.
const LINE: i32 = 22;

/// The legend from an upper left corner down, in pixels.
pub(super) fn draw(figure: &Figure, (left, top): (i32, i32), layout: &Layout, canvas: &Canvas<'_>) -> Drawn {
    let mut shown: Vec<&Series> = Vec::new();
    for series in figure.panels.iter().flat_map(|panel| &panel.series) {
        if !shown.iter().any(|s| s.name == series.name) {
            shown.push(series);
        }
    }
    let mut y = top;
    for series in shown {
        entry(series, (left, y), canvas)?;
        y += LINE;
    }
    let mut keys: Vec<&Plane> = Vec::new();
    for plane in figure.panels.iter().filter_map(|panel| panel.plane.as_ref()) {
        if !keys.iter().any(|k| k.label == plane.label && k.scale == plane.scale) {
            keys.push(plane);
        }
    }
    for plane in keys {
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

fn entry(series: &Series, (left, y): (i32, i32), canvas: &Canvas<'_>) -> Drawn {
    let (x, middle) = (left * UNITS, y * UNITS);
    let line = vec![(x, middle), (x + 34 * UNITS, middle)];
    let centre = (x + 17 * UNITS, middle);
    let colour = mark::colour(series.index);
    match series.style {
        Style::Marks => mark::draw(canvas, series.index, centre)?,
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
    }
    write(canvas, &series.name, (left + 42, y), 13, Anchor::Left)
}

/// A square for each name that occurs.
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

/// The shades from the lowest value, below, to the highest.
fn ramp(axis: &Axis, (left, top): (i32, i32), height: i32, canvas: &Canvas<'_>) -> Drawn {
    let steps = STEPS as i32;
    for step in 0..steps {
        let y = |step: i32| (top + height) * UNITS - height * UNITS * step / steps;
        let colour = shade(f64::from(step) / f64::from(steps - 1));
        // Steps overlap, or the paper shows between them.
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

/// What can go wrong in drawing.
type Error = plotters::drawing::DrawingAreaErrorKind<std::io::Error>;
