//! Colours and marks that can be distinguished with colour blindness and in print.

use super::{Canvas, Drawn, UNITS};
use plotters::element::{Circle, PathElement, Polygon, Rectangle};
use plotters::style::{Color, RGBColor};

/// The palette of Okabe and Ito without its yellow: seven colours that also differ in lightness.
const COLOURS: [RGBColor; 7] = [
    RGBColor(0, 0, 0),
    RGBColor(230, 159, 0),
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
];

/// The colour of the series `index`.
pub(super) fn colour(index: usize) -> RGBColor {
    COLOURS.get(index % COLOURS.len()).copied().unwrap_or_default()
}

/// Draws the mark of the series `index` at a place in units of the drawing.
pub(super) fn draw(canvas: &Canvas<'_>, index: usize, (x, y): (i32, i32)) -> Drawn {
    let style = colour(index).filled();
    let r = 7 * UNITS / 2;
    let long = r * 5 / 4;
    let cross = |ends: [(i32, i32); 2]| {
        let [(a, b), (c, d)] = ends;
        let stroke = colour(index).stroke_width(2 * UNITS.unsigned_abs());
        canvas.draw(&PathElement::new(vec![(x + a, y + b), (x - a, y - b)], stroke))?;
        canvas.draw(&PathElement::new(vec![(x + c, y + d), (x - c, y - d)], stroke))
    };
    // Series of one colour have different marks.
    match (index + index / COLOURS.len() * 2) % 7 {
        0 => canvas.draw(&Circle::new((x, y), r, style)),
        1 => canvas.draw(&Rectangle::new([(x - r, y - r), (x + r, y + r)], style)),
        2 => canvas.draw(&Polygon::new(vec![(x, y - long), (x + long, y + r), (x - long, y + r)], style)),
        3 => canvas
            .draw(&Polygon::new(vec![(x, y - long), (x + long, y), (x, y + long), (x - long, y)], style)),
        4 => cross([(r, r), (r, -r)]),
        5 => canvas.draw(&Polygon::new(vec![(x, y + long), (x + long, y - r), (x - long, y - r)], style)),
        _ => cross([(long, 0), (0, long)]),
    }
}

/// Draws an arrowhead whose tip is at a place.
pub(super) fn beyond(canvas: &Canvas<'_>, index: usize, (x, y): (i32, i32)) -> Drawn {
    let (r, long) = (4 * UNITS, 11 * UNITS);
    let corners = vec![(x, y), (x + r, y + long), (x - r, y + long)];
    canvas.draw(&Polygon::new(corners, colour(index).filled()))
}

/// Draws a small dot.
pub(super) fn dot(canvas: &Canvas<'_>, index: usize, place: (i32, i32)) -> Drawn {
    canvas.draw(&Circle::new(place, 3 * UNITS / 2, colour(index).filled()))
}
