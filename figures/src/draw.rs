//! A figure as SVG.
//!
//! The drawing library counts in whole pixels. The drawing is therefore made in quarter pixels and scaled
//! down, so that curves are smooth. Text uses the viewer's own sans-serif font.

mod frame;
mod legend;
mod letters;
mod mark;
#[cfg(feature = "png")]
mod png;
mod shade;
mod subscript;
mod ticks;

use super::Figure;
use frame::{Frame, placed};
use plotters::backend::SVGBackend;
use plotters::coord::Shift;
use plotters::drawing::{DrawingArea, DrawingAreaErrorKind, IntoDrawingArea};
use plotters::element::Text;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{BLACK, FontTransform, IntoFont, TextStyle, WHITE};
#[cfg(feature = "png")]
pub(super) use png::png;
use std::io;

/// The number of drawing units in a pixel.
const UNITS: i32 = 4;

/// The area for drawing.
pub(super) type Canvas<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// The result of drawing.
pub(super) type Drawn<T = ()> = Result<T, DrawingAreaErrorKind<io::Error>>;

/// The drawing of a figure.
pub(super) fn svg(figure: &Figure, size: Option<(u32, u32)>) -> io::Result<String> {
    let fitted = |legend| {
        let layout = Layout::of(figure, legend);
        let fitted = size.map_or(Some(layout), |size| layout.fitted(size));
        fitted.ok_or_else(|| {
            // With the legend beside the plots, where it has room in any case.
            let (width, height) = Layout::of(figure, legend::width(figure)).least();
            let text = format!("must be from {width}x{height}, for this picture, to {MOST}x{MOST}");
            io::Error::new(io::ErrorKind::InvalidInput, text)
        })
    };
    let inside = fitted(0)?;
    let (layout, place) = match inside.legend_inside(figure) {
        Some(place) => (inside, place),
        None => {
            let layout = fitted(legend::width(figure))?;
            if let Some((layout, place)) = size.and_then(|size| layout.legend_below(figure, size)) {
                return drawn(figure, &layout, place);
            }
            (layout, (layout.panels_width() + BESIDE, TOP - 5))
        }
    };
    drawn(figure, &layout, place)
}

/// The drawing in a layout, with the upper left corner of the legend.
fn drawn(figure: &Figure, layout: &Layout, place: (i32, i32)) -> io::Result<String> {
    let (width, height) = layout.size();
    let mut text = String::new();
    {
        let size = ((width * UNITS).unsigned_abs(), (height * UNITS).unsigned_abs());
        let canvas = SVGBackend::with_string(&mut text, size).into_drawing_area();
        paint(figure, layout, place, &canvas).map_err(|e| io::Error::other(e.to_string()))?;
    }
    let full = format!("width=\"{}\" height=\"{}\"", width * UNITS, height * UNITS);
    let text = text.replacen(&full, &format!("width=\"{width}\" height=\"{height}\""), 1);
    Ok(subscript::set(&text))
}

fn paint(figure: &Figure, layout: &Layout, legend: (i32, i32), canvas: &Canvas<'_>) -> Drawn {
    canvas.fill(&WHITE)?;
    let middle = layout.left + layout.panels_width() / 2 - layout.left / 2;
    title(canvas, &figure.title, (middle, 12), 18, layout.panels_width())?;
    for (panel, origin) in figure.panels.iter().zip(layout.origins()) {
        Frame::new(panel, origin, layout.plot).draw(layout.left, canvas)?;
    }
    legend::draw(figure, legend, layout, canvas)?;
    canvas.present()
}

/// Margins in pixels: left of a plot, at least, above it and below it.
const LEFT: i32 = 76;
const TOP: i32 = 66;
const BELOW: i32 = 62;
/// Margin to the right of the legend, and between it and the plots.
const RIGHT: i32 = 24;
const BESIDE: i32 = 32;

/// The least width and height of a plot.
const LEAST: i32 = 120;
/// The greatest width and height of a figure.
const MOST: i32 = 10_000;

/// Sizes in pixels.
#[derive(Clone, Copy)]
pub(super) struct Layout {
    /// Width and height of a plot.
    plot: (i32, i32),
    /// Margin left of a plot, with room for the labels of the widest vertical axis.
    left: i32,
    columns: i32,
    panels: i32,
    /// Width of the legend beside the plots; 0 where it is inside.
    legend: i32,
    /// Height of the legend below the plots; 0 where it is not there.
    below: i32,
    /// What is left of a given size to the right and below.
    spare: (i32, i32),
}

impl Layout {
    fn of(figure: &Figure, legend: i32) -> Self {
        let panels = i32::try_from(figure.panels.len()).unwrap_or(i32::MAX).max(1);
        let (plot, columns) = match panels {
            1 => ((640, 440), 1),
            2 => ((430, 400), 2),
            _ => ((400, 250), 2),
        };
        let shown = figure.panels.iter().map(|panel| &panel.y).filter(|axis| !axis.label.is_empty());
        let widest = shown.flat_map(placed).map(|(_, text)| letters::width(&text, frame::LABEL)).max();
        let left = LEFT.max(widest.unwrap_or(0) + frame::BESIDE_LABELS);
        Self { plot, left, columns, panels, legend, below: 0, spare: (0, 0) }
    }

    /// The least size of the figure in pixels.
    fn least(&self) -> (i32, i32) {
        let (width, height) = self.size();
        let rows = (self.panels + self.columns - 1) / self.columns;
        (width - self.columns * (self.plot.0 - LEAST), height - rows * (self.plot.1 - LEAST))
    }

    /// The layout of a figure of a given size in pixels; `None` where the plots would have no room.
    fn fitted(self, (width, height): (u32, u32)) -> Option<Self> {
        let (own, given) = (self.size(), (i32::try_from(width).ok()?, i32::try_from(height).ok()?));
        if given.0 > MOST || given.1 > MOST {
            return None;
        }
        let rows = (self.panels + self.columns - 1) / self.columns;
        let more = (given.0 - own.0, given.1 - own.1);
        let plot = (self.plot.0 + more.0.div_euclid(self.columns), self.plot.1 + more.1.div_euclid(rows));
        // What the plots cannot share stays empty, so that the picture has the size asked for.
        let spare = (more.0.rem_euclid(self.columns), more.1.rem_euclid(rows));
        (plot.0 >= LEAST && plot.1 >= LEAST).then_some(Self { plot, spare, ..self })
    }

    /// The place of the legend in the plot of a single panel, where it covers nothing.
    fn legend_inside(&self, figure: &Figure) -> Option<(i32, i32)> {
        let [panel] = figure.panels.as_slice() else { return None };
        let frame = Frame::new(panel, (self.left, TOP), self.plot);
        let places = legend::places(figure, (self.left, TOP), self.plot)?;
        places.into_iter().find(|&place| frame.is_free(place, legend::size(figure)))
    }

    /// The layout of a picture of this size with the legend below the plots, and its place, where beside them it would take half of the width.
    fn legend_below(&self, figure: &Figure, size: (u32, u32)) -> Option<(Self, (i32, i32))> {
        let (width, height) = legend::size(figure);
        if self.legend < self.columns * self.plot.0 || !legend::is_of_series(figure) {
            return None;
        }
        let layout = Self { below: height + 2 * legend::ROOM, ..Self::of(figure, 0) }.fitted(size)?;
        let bottom = layout.size().1 - layout.spare.1;
        let fits = layout.left + width + legend::ROOM <= layout.size().0;
        fits.then_some((layout, (layout.left, bottom - layout.below + legend::ROOM / 2)))
    }

    fn step(&self) -> (i32, i32) {
        (self.plot.0 + self.left, self.plot.1 + BELOW + 30)
    }

    fn panels_width(&self) -> i32 {
        self.columns * self.step().0
    }

    fn size(&self) -> (i32, i32) {
        let rows = (self.panels + self.columns - 1) / self.columns;
        let width = self.panels_width() + BESIDE + self.legend + RIGHT;
        (width + self.spare.0, TOP - 30 + rows * self.step().1 + 6 + self.below + self.spare.1)
    }

    /// The height of all panels, from the top of the first.
    pub(super) fn plots_height(&self) -> i32 {
        self.size().1 - self.below - TOP - BELOW
    }

    /// The upper left corner of each plot.
    fn origins(&self) -> impl Iterator<Item = (i32, i32)> + '_ {
        let (across, down) = self.step();
        (0..self.panels).map(move |i| (self.left + i % self.columns * across, TOP + i / self.columns * down))
    }
}

/// The point of a text that lies at the given place.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Anchor {
    /// The middle of the text's upper edge.
    Above,
    /// The middle of the text's left edge.
    Left,
    /// The middle of the text's right edge.
    Right,
    /// The middle of the text.
    Middle,
    /// The middle of the text's lower edge; the text runs upwards.
    Upwards,
}

/// Writes a title around a place, in smaller letters where it would be too wide.
fn title(canvas: &Canvas<'_>, text: &str, place: (i32, i32), size: i32, width: i32) -> Drawn {
    // A letter is about half as wide as high; a title may be somewhat wider than its plots.
    let count = i32::try_from(text.chars().count()).unwrap_or(i32::MAX).max(1);
    let (text, size) = letters::fitted(text, size.min(2 * width / count).max(8), width + 44);
    write(canvas, &text, place, size, Anchor::Above)
}

/// Writes text of the given size at a place, both in pixels.
pub(super) fn write(canvas: &Canvas<'_>, text: &str, (x, y): (i32, i32), size: i32, anchor: Anchor) -> Drawn {
    // The backend scales the given size by 1/1.24.
    let font = ("sans-serif", f64::from(size * UNITS) * 1.24).into_font();
    let (font, pos) = match anchor {
        Anchor::Above => (font, Pos::new(HPos::Center, VPos::Top)),
        Anchor::Left => (font, Pos::new(HPos::Left, VPos::Center)),
        Anchor::Right => (font, Pos::new(HPos::Right, VPos::Center)),
        Anchor::Middle => (font, Pos::new(HPos::Center, VPos::Center)),
        Anchor::Upwards => (font.transform(FontTransform::Rotate270), Pos::new(HPos::Center, VPos::Center)),
    };
    let style = TextStyle::from(font).color(&BLACK).pos(pos);
    canvas.draw(&Text::new(text.to_owned(), (x * UNITS, y * UNITS), style))
}
