//! Lines, arrows and marks, in colours that can be distinguished with colour blindness and in print.

use super::canvas::{Canvas, Drawn, UNITS};
use crate::figure::Style;
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

/// Draws a line in its style.
pub(super) fn stroke(canvas: &Canvas<'_>, line: Vec<(i32, i32)>, style: Style, colour: RGBColor) -> Drawn {
    let width = if style == Style::Thick { 3 * UNITS } else { 3 * UNITS / 2 };
    let pen = colour.stroke_width(width.unsigned_abs());
    let Some((dash, gap)) = style.dashes() else { return canvas.draw(&PathElement::new(line, pen)) };
    for piece in dashes(&line, f64::from(dash * UNITS), f64::from(gap * UNITS)) {
        canvas.draw(&PathElement::new(piece, pen))?;
    }
    Ok(())
}

/// The dashes along a line.
fn dashes(line: &[(i32, i32)], dash: f64, gap: f64) -> Vec<Vec<(i32, i32)>> {
    let (mut pieces, mut piece, mut left, mut on) = (Vec::new(), Vec::new(), dash, true);
    for pair in line.windows(2) {
        let [(ax, ay), (bx, by)] = pair else { continue };
        let (ax, ay, dx, dy) = (f64::from(*ax), f64::from(*ay), f64::from(bx - ax), f64::from(by - ay));
        let length = dx.hypot(dy);
        let at = |along: f64| whole((ax + dx * along / length, ay + dy * along / length));
        let mut along = 0.0;
        while along < length {
            let next = (along + left).min(length);
            if on {
                if piece.is_empty() {
                    piece.push(at(along));
                }
                piece.push(at(next));
            }
            left -= next - along;
            along = next;
            // Rounding may leave a remainder too small to advance.
            if left < 1e-6 {
                pieces.push(std::mem::take(&mut piece));
                on = !on;
                left = if on { dash } else { gap };
            }
        }
    }
    pieces.push(piece);
    pieces.retain(|piece| piece.len() > 1);
    pieces
}

/// Draws a thin line with an arrowhead at its end.
pub(super) fn arrow(canvas: &Canvas<'_>, places: &[(f64, f64)], colour: RGBColor) -> Drawn {
    let pen = colour.stroke_width(UNITS.unsigned_abs());
    canvas.draw(&PathElement::new(places.iter().copied().map(whole).collect::<Vec<_>>(), pen))?;
    let [.., (ax, ay), (x, y)] = places else { return Ok(()) };
    let (dx, dy) = (x - ax, y - ay);
    let unit = f64::from(UNITS) / dx.hypot(dy);
    let (dx, dy) = (dx * unit, dy * unit);
    let corner = |side: f64| whole((x - 11.0 * dx - side * dy, y - 11.0 * dy + side * dx));
    canvas.draw(&Polygon::new(vec![whole((*x, *y)), corner(4.5), corner(-4.5)], colour.filled()))
}

/// The nearest point in whole units, of which the drawing library can form multiples and differences.
pub(super) fn whole((x, y): (f64, f64)) -> (i32, i32) {
    /// Beyond every figure.
    const FAR: f64 = 1e6;
    let near = |at: f64| at.round().clamp(-FAR, FAR) as i32;
    (near(x), near(y))
}

#[cfg(test)]
mod tests {
    use super::dashes;

    #[test]
    fn dashes_leave_gaps_round_corners() {
        let line = [(0, 0), (10, 0), (10, 10)];
        assert_eq!(dashes(&line, 7.0, 5.0), [vec![(0, 0), (7, 0)], vec![(10, 2), (10, 9)]]);
    }
}
