//! Lines, dashed lines, arrows.

use super::{Canvas, Drawn, UNITS};
use crate::Style;
use plotters::element::{PathElement, Polygon};
use plotters::style::{Color, RGBColor};

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

/// The nearest point in whole units.
pub(super) fn whole((x, y): (f64, f64)) -> (i32, i32) {
    (x.round() as i32, y.round() as i32)
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
