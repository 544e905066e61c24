//! One pair of axes and its contents.

use super::canvas::{Anchor, Canvas, Drawn, LINE, Margins, TEXT, UNITS, write};
use super::mark::{arrow, stroke, whole};
use super::scale::drawn;
use super::ticks::{minor, number};
use super::{letters, mark};
use crate::figure::{Axis, Panel, Series, Style};
use crate::plane::Plane;
use plotters::element::{PathElement, Rectangle};
use plotters::style::{BLACK, Color, RGBColor, WHITE};

/// The room of these texts beyond the plot: of the title, of the horizontal axis and of the vertical one.
const OVER: i32 = 44;
const BEYOND: i32 = 50;
const ALONG: i32 = 10;

/// A length of the drawing in pixels.
fn pixels(length: f64) -> i32 {
    (length / f64::from(UNITS)).round() as i32
}

/// A panel with its place in the drawing, in units of the drawing.
pub(super) struct Frame<'a> {
    panel: &'a Panel,
    left: f64,
    top: f64,
    width: f64,
    height: f64,
}

impl<'a> Frame<'a> {
    /// The panel with a plot of this size at this upper left corner, both in pixels.
    pub(super) fn new(panel: &'a Panel, (x, y): (i32, i32), (width, height): (i32, i32)) -> Self {
        let [left, top, width, height] = [x, y, width, height].map(|pixels| f64::from(pixels * UNITS));
        Self { panel, left, top, width, height }
    }

    /// Draws the panel with these margins; an axis that the panel below has, too, is labelled only there.
    pub(super) fn draw(&self, margins: &Margins, is_shared: bool, canvas: &Canvas<'_>) -> Drawn {
        let grid = RGBColor(222, 222, 222).stroke_width(UNITS.unsigned_abs());
        let (right, bottom) = (self.left + self.width, self.top + self.height);
        let shown = |axis: &Axis| {
            if axis.label.is_empty() { (String::new(), Vec::new()) } else { drawn(axis) }
        };
        let ((x_label, x_ticks), (y_label, y_ticks)) = (shown(&self.panel.x), shown(&self.panel.y));
        for (value, _) in &x_ticks {
            let x = self.place((*value, self.panel.y.low)).0;
            canvas.draw(&PathElement::new(vec![whole((x, self.top)), whole((x, bottom))], grid))?;
        }
        for (value, _) in &y_ticks {
            let y = self.place((self.panel.x.low, *value)).1;
            canvas.draw(&PathElement::new(vec![whole((self.left, y)), whole((right, y))], grid))?;
        }
        if let Some(plane) = &self.panel.plane {
            self.plane(plane, canvas)?;
        }
        for series in &self.panel.series {
            self.series(series, canvas)?;
        }
        if !(x_ticks.is_empty() && y_ticks.is_empty()) {
            let corners = [(self.left, self.top), (right, self.top), (right, bottom), (self.left, bottom)];
            let round = corners.into_iter().chain([(self.left, self.top)]).map(whole).collect::<Vec<_>>();
            canvas.draw(&PathElement::new(round, BLACK.stroke_width(UNITS.unsigned_abs())))?;
            self.minor_ticks(canvas)?;
        }
        if !is_shared {
            self.words_below(&x_label, &x_ticks, margins, canvas)?;
        }
        self.words_beside(&y_label, &y_ticks, margins, canvas)?;
        self.words_above(margins, canvas)
    }

    /// Short lines within the frame at the values between the labels of a logarithmic axis.
    fn minor_ticks(&self, canvas: &Canvas<'_>) -> Drawn {
        const LENGTH: f64 = 5.0;
        let (length, bottom) = (LENGTH * f64::from(UNITS), self.top + self.height);
        let shown = |axis: &Axis| if axis.label.is_empty() { Vec::new() } else { minor(axis) };
        let across = shown(&self.panel.x).into_iter().map(|value| {
            let x = self.place((value, self.panel.y.low)).0;
            [(x, bottom), (x, bottom - length)]
        });
        let up = shown(&self.panel.y).into_iter().map(|value| {
            let y = self.place((self.panel.x.low, value)).1;
            [(self.left, y), (self.left + length, y)]
        });
        let style = BLACK.stroke_width(UNITS.unsigned_abs());
        across.chain(up).try_for_each(|line| canvas.draw(&PathElement::new(line.map(whole).to_vec(), style)))
    }

    /// The left and the upper edge, the width and the height, in pixels.
    fn pixels(&self) -> [i32; 4] {
        [self.left, self.top, self.width, self.height].map(pixels)
    }

    /// The labels of the horizontal axis and its name.
    fn words_below(
        &self,
        name: &str,
        ticks: &[(f64, String)],
        margins: &Margins,
        canvas: &Canvas<'_>,
    ) -> Drawn {
        let [left, top, width, height] = self.pixels();
        let across = |(value, text): &(f64, String)| {
            (pixels(self.place((*value, self.panel.y.low)).0), letters::width(text, TEXT))
        };
        let places: Vec<_> = ticks.iter().map(across).collect();
        for (((_, text), (x, length)), shown) in ticks.iter().zip(&places).zip(letters::shown(&places, 6)) {
            // Beyond the plot there is as much room as between it and its neighbour.
            let is_within = x - length / 2 > left - margins.left && x + length / 2 < left + width + 50;
            if shown && is_within {
                write(canvas, text, (*x, top + height + 7), TEXT, Anchor::Above)?;
            }
        }
        let places = (top + height + 28..).step_by(LINE as usize);
        for (line, y) in letters::name_in_lines(name, TEXT, width + BEYOND, margins.lines).iter().zip(places)
        {
            write(canvas, line, (left + width / 2, y), TEXT, Anchor::Above)?;
        }
        Ok(())
    }

    /// The labels of the vertical axis and its name.
    fn words_beside(
        &self,
        name: &str,
        ticks: &[(f64, String)],
        margins: &Margins,
        canvas: &Canvas<'_>,
    ) -> Drawn {
        let [left, top, _, height] = self.pixels();
        let down = |(value, _): &(f64, String)| (pixels(self.place((self.panel.x.low, *value)).1), TEXT);
        let places: Vec<_> = ticks.iter().map(down).collect();
        for (((_, text), (y, _)), shown) in ticks.iter().zip(&places).zip(letters::shown(&places, 1)) {
            if shown {
                write(canvas, text, (left - 7, *y), TEXT, Anchor::Right)?;
            }
        }
        let places = (left - margins.left + 13..).step_by(LINE as usize);
        for (line, x) in letters::name_in_lines(name, TEXT, height + ALONG, margins.lines).iter().zip(places)
        {
            write(canvas, line, (x, top + height / 2), TEXT, Anchor::Upwards)?;
        }
        Ok(())
    }

    /// The title, and a remark within the frame.
    fn words_above(&self, margins: &Margins, canvas: &Canvas<'_>) -> Drawn {
        let [left, top, width, height] = self.pixels();
        let (middle, title) =
            (left + width / 2, letters::lines(&self.panel.title, TEXT, width + OVER, margins.lines));
        let places = (0..).step_by(LINE as usize).map(|up| top - 22 - up);
        for (line, y) in title.iter().rev().zip(places) {
            write(canvas, line, (middle, y), TEXT, Anchor::Above)?;
        }
        let remark = self.remark().map(|remark| letters::lines(&remark, TEXT, width - 8, 4));
        let places = (top + height / 5..).step_by(LINE as usize);
        for (line, y) in remark.iter().flatten().zip(places) {
            write(canvas, line, (middle, y), TEXT, Anchor::Middle)?;
        }
        Ok(())
    }

    /// The lines of the title, of the name of the horizontal axis and of that of the vertical one.
    pub(super) fn lines(panel: &Panel, (width, height): (i32, i32), most: usize) -> [i32; 3] {
        let title = letters::lines(&panel.title, TEXT, width + OVER, most);
        let name = |axis: &Axis, room: i32| letters::name_in_lines(&drawn(axis).0, TEXT, room, most);
        [title, name(&panel.x, width + BEYOND), name(&panel.y, height + ALONG)]
            .map(|lines| lines.len() as i32)
    }

    /// The place of a point of the plot, in units of the drawing; infinite values are on the upper edge.
    fn place(&self, (x, y): (f64, f64)) -> (f64, f64) {
        let y = if y == f64::INFINITY { 1.0 } else { self.panel.y.share(y) };
        let x = self.panel.x.share(x);
        (self.left + self.width * x, self.top + self.height * (1.0 - y))
    }

    /// The words for a panel in which nothing is seen, or only a level line.
    fn remark(&self) -> Option<String> {
        let panel = self.panel;
        let is_blank = |plane: &Plane| plane.values.iter().all(|&value| plane.scale.step(value).is_none());
        if panel.x.label.is_empty() && panel.y.label.is_empty()
            || panel.plane.as_ref().is_some_and(|p| !is_blank(p))
        {
            return None;
        }
        if !panel.series.iter().any(|series| self.shows(series)) {
            return Some("no values in this range".to_owned());
        }
        let mut points = panel.series.iter().flat_map(|series| &series.points).filter(|(_, y)| !y.is_nan());
        let (first, level) = *points.next()?;
        let is_level = panel.series.iter().all(|series| series.style.is_line())
            && panel.series.iter().flat_map(|series| &series.points).any(|(x, y)| !y.is_nan() && *x != first)
            && points.all(|(_, y)| *y == level);
        is_level.then(|| format!("constant: {}", number(level)))
    }

    /// Whether anything of a series lies within the frame.
    fn shows(&self, series: &Series) -> bool {
        let tip = |(x, y): (f64, f64)| (x, if series.style == Style::Beyond { f64::INFINITY } else { y });
        let places: Vec<_> = series.points.iter().map(|&point| self.place(tip(point))).collect();
        if series.style.is_line() {
            return !self.clipped(&places).is_empty();
        }
        series.style != Style::Note && places.into_iter().any(|place| self.holds(place))
    }

    fn holds(&self, (x, y): (f64, f64)) -> bool {
        let within = |at: f64, low: f64, length: f64| at >= low - 0.5 && at <= low + length + 0.5;
        within(x, self.left, self.width) && within(y, self.top, self.height)
    }

    /// Whether nothing is drawn in a rectangle, in pixels, nor close to it.
    pub(super) fn is_free(&self, (x, y): (i32, i32), (width, height): (i32, i32)) -> bool {
        let units = |pixels: i32| f64::from(pixels * UNITS);
        let area = |room: i32| {
            ((units(x - room), units(y - room)), (units(width + 2 * room), units(height + 2 * room)))
        };
        let remark = || {
            let at = (self.left + self.width / 2.0, self.top + self.height / 5.0);
            let (from, to) = ((at.0 - units(120), at.1), (at.0 + units(120), at.1));
            within(area(12), from, to).is_none() || self.remark().is_none()
        };
        self.panel.plane.is_none()
            && remark()
            && self.panel.series.iter().all(|series| {
                let is_tip = series.style == Style::Beyond;
                let on_edge = |(x, y): (f64, f64)| (x, if is_tip { f64::INFINITY } else { y });
                let points = series.points.iter();
                let places: Vec<_> = points.map(|&point| self.place(on_edge(point))).collect();
                // Letters at a point are wider than marks, and marks than lines.
                let around = |room| places.iter().all(|&at| within(area(room), at, at).is_none());
                if series.style.is_line() {
                    return places.windows(2).all(|pair| match pair {
                        [from, to] => within(area(8), *from, *to).is_none(),
                        _ => true,
                    });
                }
                series.style == Style::Note || around(if series.style == Style::Named { 40 } else { 12 })
            })
    }

    fn area(&self) -> Area {
        ((self.left, self.top), (self.width, self.height))
    }

    fn series(&self, series: &Series, canvas: &Canvas<'_>) -> Drawn {
        let places: Vec<(f64, f64)> = series.points.iter().map(|&point| self.place(point)).collect();
        let shown = || places.iter().copied().filter(|place| self.holds(*place)).map(whole);
        match series.style {
            Style::Marks => return shown().try_for_each(|place| mark::draw(canvas, series.index, place)),
            Style::Dots => return shown().try_for_each(|place| mark::dot(canvas, series.index, place)),
            Style::Beyond => {
                let tips = series.points.iter().map(|&(x, _)| self.place((x, f64::INFINITY)));
                let mut tips = tips.filter(|place| self.holds(*place)).map(whole);
                return tips.try_for_each(|tip| mark::beyond(canvas, series.index, tip));
            }
            Style::Note => return Ok(()),
            Style::Named => {
                let named = |(x, y): (i32, i32)| {
                    write(canvas, &series.name, (x / UNITS, y / UNITS), 15, Anchor::Middle)
                };
                return shown().try_for_each(named);
            }
            Style::Line | Style::Thick | Style::Dashed | Style::Dotted | Style::Marked(_) | Style::Arrow => {}
        }
        let colour = mark::colour(series.index);
        if series.style == Style::Arrow {
            return arrow(canvas, &places, colour);
        }
        for line in self.clipped(&places) {
            if self.panel.plane.is_some() && series.style == Style::Thick {
                let halo = WHITE.stroke_width(6 * UNITS.unsigned_abs());
                canvas.draw(&PathElement::new(line.clone(), halo))?;
            }
            stroke(canvas, line, series.style, colour)?;
        }
        if let Style::Marked(every) = series.style {
            let some = places.iter().copied().skip(every / 2).step_by(every.max(1));
            for place in some.filter(|place| self.holds(*place)) {
                mark::draw(canvas, series.index, whole(place))?;
            }
        }
        Ok(())
    }

    /// The parts of a line within the frame.
    fn clipped(&self, places: &[(f64, f64)]) -> Vec<Vec<(i32, i32)>> {
        let mut lines: Vec<Vec<(i32, i32)>> = Vec::new();
        for pair in places.windows(2) {
            let [from, to] = pair else { continue };
            let Some((a, b)) = within(self.area(), *from, *to) else { continue };
            let (a, b) = (whole(a), whole(b));
            match lines.last_mut() {
                Some(line) if line.last() == Some(&a) => {
                    if a != b {
                        line.push(b);
                    }
                }
                Some(_) | None => lines.push(vec![a, b]),
            }
        }
        lines
    }

    /// Draws the plane as rows of rectangles; neighbours of the same colour are merged.
    fn plane(&self, plane: &Plane, canvas: &Canvas<'_>) -> Drawn {
        let x: Vec<f64> = plane.x.iter().map(|&x| self.place((x, self.panel.y.low)).0).collect();
        let y: Vec<f64> = plane.y.iter().map(|&y| self.place((self.panel.x.low, y)).1).collect();
        let across = cells(&x, (self.left, self.left + self.width));
        let down = cells(&y, (self.top, self.top + self.height));
        for (row, (low, high)) in plane.values.chunks(plane.x.len().max(1)).zip(down) {
            let mut steps = row.iter().map(|&value| plane.scale.step(value)).zip(&across).peekable();
            while let Some((step, &(left, end))) = steps.next() {
                let mut right = end;
                while let Some((_, &(_, next))) = steps.next_if(|(other, _)| *other == step) {
                    right = next;
                }
                if let Some(step) = step {
                    // Rows and cells overlap, because otherwise the background would show between them; the
                    // next cell covers the overlap.
                    let (lap, top) = (f64::from(UNITS), low.min(high));
                    let corner = ((right + lap).min(self.left + self.width), low.max(high));
                    let corners = [whole((left, (top - lap).max(self.top))), whole(corner)];
                    canvas.draw(&Rectangle::new(corners, plane.scale.colour(step).filled()))?;
                }
            }
        }
        Ok(())
    }
}

/// The upper left corner of a rectangle, its width and its height.
type Area = ((f64, f64), (f64, f64));

/// The part of a straight piece within a rectangle.
fn within(
    ((left, top), (width, height)): Area,
    (ax, ay): (f64, f64),
    (bx, by): (f64, f64),
) -> Option<((f64, f64), (f64, f64))> {
    if [ax, ay, bx, by].iter().any(|c| !c.is_finite()) {
        return None;
    }
    let (dx, dy) = (bx - ax, by - ay);
    let (mut enter, mut leave) = (0.0f64, 1.0f64);
    let sides = [(-dx, ax - left), (dx, left + width - ax), (-dy, ay - top), (dy, top + height - ay)];
    for (towards, room) in sides {
        if towards == 0.0 {
            if room < 0.0 {
                return None;
            }
        } else if towards < 0.0 {
            enter = enter.max(room / towards);
        } else {
            leave = leave.min(room / towards);
        }
    }
    let at = |t: f64| (ax + t * dx, ay + t * dy);
    (enter <= leave).then(|| (at(enter), at(leave)))
}

/// The cell around each place: half way to its neighbours, within the frame.
fn cells(places: &[f64], (low, high): (f64, f64)) -> Vec<(f64, f64)> {
    let before = std::iter::once(None).chain(places.iter().copied().map(Some));
    let after = places.iter().copied().skip(1).map(Some).chain([None]);
    let cell = |((at, before), after): ((&f64, Option<f64>), Option<f64>)| {
        let half = |next: Option<f64>, other: Option<f64>| {
            next.map_or_else(|| other.map_or(*at, |o| at + (at - o) / 2.0), |n| (at + n) / 2.0)
                .clamp(low, high)
        };
        (half(before, after), half(after, before))
    };
    places.iter().zip(before).zip(after).map(cell).collect()
}

#[cfg(test)]
mod tests {
    use super::cells;

    #[test]
    fn cells_meet_and_stay_within() {
        assert_eq!(cells(&[1.0, 2.0, 4.0], (0.0, 4.5)), [(0.5, 1.5), (1.5, 3.0), (3.0, 4.5)]);
        assert_eq!(cells(&[4.0, 2.0], (0.0, 9.0)), [(5.0, 3.0), (3.0, 1.0)]);
    }
}
