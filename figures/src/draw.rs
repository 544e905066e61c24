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
        let fitted = size.map_or(Some(layout.by_itself(figure)), |size| layout.fitted(figure, size));
        fitted.ok_or_else(|| {
            // With the legend beside the plots, where it has room in any case.
            let (width, height) = Layout::of(figure, legend::width(figure)).least(figure);
            let text = format!("must be from {width}x{height}, for this picture, to {MOST}x{MOST}");
            io::Error::new(io::ErrorKind::InvalidInput, text)
        })
    };
    let inside = fitted(0)?;
    let (layout, place) = match inside.legend_inside(figure) {
        Some(place) => (inside, place),
        None => {
            let beside = fitted(legend::width(figure));
            // Beside the plots it would take half of the width, or more than there is.
            let is_wide =
                beside.as_ref().map_or(true, |layout| layout.legend >= layout.columns * layout.plot.0);
            let below = size.filter(|_| is_wide).and_then(|size| Layout::legend_below(figure, size));
            if let Some((layout, place)) = below {
                return drawn(figure, &layout, place);
            }
            let layout = beside?;
            (layout, (layout.panels_width() + BESIDE, layout.top - 5))
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
    let (lines, size) = layout.title(figure);
    for (line, y) in lines.iter().zip((12..).step_by(TITLE_LINE as usize)) {
        write(canvas, line, (layout.middle(), y), size, Anchor::Above)?;
    }
    for (panel, origin) in figure.panels.iter().zip(layout.origins()) {
        Frame::new(panel, origin, layout.plot).draw(layout.left, canvas)?;
    }
    legend::draw(figure, legend, layout, canvas)?;
    canvas.present()
}

/// The size of the title of a figure, and of the texts that give way last: 7 pt where a picture of 450 pixels is
/// 85 mm wide.
const TITLE: i32 = 18;
pub(super) const TEXT: i32 = 14;
/// The most lines of a title, and the height of one.
const TITLE_LINES: usize = 3;
const TITLE_LINE: i32 = 20;

/// Margins in pixels: left of a plot, at least, above it below a title of one line, and below it.
const LEFT: i32 = 76;
const TOP: i32 = 66;
const BELOW: i32 = 62;
/// Margin to the right of the legend, and between it and the plots.
const RIGHT: i32 = 24;
const BESIDE: i32 = 32;

/// The least width and height of a plot, and the width below which plots are rather set one below the other.
const LEAST: (i32, i32) = (90, 120);
const NARROW: i32 = 220;
/// The size of one of several plots that are one below the other.
const STACKED: (i32, i32) = (640, 180);
/// The greatest width and height of a figure.
const MOST: i32 = 10_000;

/// Sizes in pixels.
#[derive(Clone, Copy)]
pub(super) struct Layout {
    /// Width and height of a plot.
    plot: (i32, i32),
    /// Margin left of a plot, with room for the labels of the widest vertical axis.
    left: i32,
    /// Margin above the first plot, with room for the lines of the title.
    top: i32,
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
        let widest = shown.flat_map(placed).map(|(_, text)| letters::width(&text, TEXT)).max();
        let left = LEFT.max(widest.unwrap_or(0) + frame::BESIDE_LABELS);
        Self { plot, left, top: TOP, columns, panels, legend, below: 0, spare: (0, 0) }.below_title(figure)
    }

    /// This layout with room for the title.
    fn below_title(self, figure: &Figure) -> Self {
        let lines = i32::try_from(self.title(figure).0.len()).unwrap_or(1).max(1);
        Self { top: TOP + (lines - 1) * TITLE_LINE, ..self }
    }

    /// The middle of the title.
    fn middle(&self) -> i32 {
        (self.left + self.panels_width()) / 2
    }

    /// The lines of the title and their size.
    fn title(&self, figure: &Figure) -> (Vec<String>, i32) {
        let room = 2 * self.middle().min(self.size().0 - self.middle()) - 8;
        let size = (TITLE * room / letters::width(&figure.title, TITLE).max(1)).clamp(TEXT, TITLE);
        (letters::lines(&figure.title, size, room, TITLE_LINES), size)
    }

    fn rows(&self) -> i32 {
        (self.panels + self.columns - 1) / self.columns
    }

    /// The least size of the figure in pixels.
    fn least(&self, figure: &Figure) -> (i32, i32) {
        Self { plot: LEAST, ..*self }.below_title(figure).size()
    }

    /// The layout of a figure of a given size in pixels; `None` where the plots would have no room.
    fn fitted(self, figure: &Figure, size: (u32, u32)) -> Option<Self> {
        let beside = self.shared(figure, size);
        let is_wide = beside.is_some_and(|layout| layout.plot.0 >= NARROW);
        if self.columns == 1 || is_wide && !figure.is_stacked {
            return beside;
        }
        Self { columns: 1, ..self }.shared(figure, size).or(beside)
    }

    /// The layout of a figure that may choose its size.
    fn by_itself(self, figure: &Figure) -> Self {
        if figure.is_stacked && self.panels > 1 {
            return Self { columns: 1, plot: STACKED, ..self }.below_title(figure);
        }
        self
    }

    /// The plots with a share each of a given size; `None` where they would have no room.
    fn shared(self, figure: &Figure, (width, height): (u32, u32)) -> Option<Self> {
        let given = (i32::try_from(width).ok()?, i32::try_from(height).ok()?);
        if given.0 > MOST || given.1 > MOST {
            return None;
        }
        // What the plots cannot share stays empty, so that the picture has the size asked for.
        let more = given.0 - self.size().0;
        let (across, spare) = (self.plot.0 + more.div_euclid(self.columns), more.rem_euclid(self.columns));
        if across < LEAST.0 {
            return None;
        }
        let wide = Self { plot: (across, self.plot.1), spare: (spare, 0), ..self }.below_title(figure);
        let more = given.1 - wide.size().1;
        let (down, spare) = (wide.plot.1 + more.div_euclid(wide.rows()), more.rem_euclid(wide.rows()));
        (down >= LEAST.1).then_some(Self { plot: (across, down), spare: (wide.spare.0, spare), ..wide })
    }

    /// The place of the legend in the plot of a single panel, where it covers nothing.
    fn legend_inside(&self, figure: &Figure) -> Option<(i32, i32)> {
        let [panel] = figure.panels.as_slice() else { return None };
        let frame = Frame::new(panel, (self.left, self.top), self.plot);
        let places = legend::places(figure, (self.left, self.top), self.plot)?;
        places.into_iter().find(|&place| frame.is_free(place, legend::size(figure)))
    }

    /// The layout of a picture of this size with the legend below the plots, and its place.
    fn legend_below(figure: &Figure, size: (u32, u32)) -> Option<(Self, (i32, i32))> {
        let (width, height) = legend::size(figure);
        if !legend::is_of_series(figure) {
            return None;
        }
        let layout = Self { below: height + 2 * legend::ROOM, ..Self::of(figure, 0) }.fitted(figure, size)?;
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
        let width = self.panels_width() + BESIDE + self.legend + RIGHT;
        (width + self.spare.0, self.top - 30 + self.rows() * self.step().1 + 6 + self.below + self.spare.1)
    }

    /// The height of all panels, from the top of the first.
    pub(super) fn plots_height(&self) -> i32 {
        self.size().1 - self.below - self.top - BELOW
    }

    /// The upper left corner of each plot.
    fn origins(&self) -> impl Iterator<Item = (i32, i32)> + '_ {
        let (across, down) = self.step();
        (0..self.panels)
            .map(move |i| (self.left + i % self.columns * across, self.top + i / self.columns * down))
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
