//! A figure as SVG.
//!
//! The drawing library counts in whole pixels. The drawing is therefore made in quarter pixels and scaled
//! down, so that curves are smooth. Text uses the viewer's own sans-serif font.

mod canvas;
mod frame;
mod legend;
mod letters;
mod mark;
#[cfg(feature = "png")]
mod pdf;
#[cfg(feature = "png")]
mod png;
mod scale;
mod shade;
mod subscript;
mod ticks;

use crate::figure::{Figure, Panel};
use canvas::{Anchor, Canvas, Drawn, LINE, Margins, TEXT, UNITS, write};
use frame::Frame;
#[cfg(feature = "png")]
pub(super) use pdf::pdf;
use plotters::backend::SVGBackend;
use plotters::drawing::IntoDrawingArea;
use plotters::style::WHITE;
#[cfg(feature = "png")]
pub(super) use png::png;
use std::io;

impl Figure {
    /// The drawing as an SVG file without embedded fonts.
    ///
    /// # Errors
    ///
    /// Errors of the drawing library, none of which are known to occur.
    pub fn svg(&self) -> io::Result<String> {
        svg(self, None)
    }

    /// The drawing as an SVG file with a width and a height in pixels.
    ///
    /// # Errors
    /// [`io::ErrorKind::InvalidInput`] where the plots would have no room, or the size is beyond all use.
    pub fn svg_of_size(&self, size: (u32, u32)) -> io::Result<String> {
        svg(self, Some(size))
    }
}

/// The drawing of a figure.
fn svg(figure: &Figure, size: Option<(u32, u32)>) -> io::Result<String> {
    let figure = &*scale::in_one_unit(figure);
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
            // Beside the plots it would take a third of the width, or more than there is.
            let is_wide =
                beside.as_ref().map_or(true, |layout| 2 * layout.legend >= layout.columns * layout.plot.0);
            let below = size.filter(|_| is_wide).and_then(|size| Layout::legend_below(figure, size));
            if let Some((layout, place)) = below {
                return drawn(figure, &layout, place);
            }
            let layout = beside?;
            (layout, (layout.panels_width() + BESIDE, layout.margins.top - 5))
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
    for (line, y) in lines.iter().zip((12..).step_by(LINE as usize)) {
        write(canvas, line, (layout.middle(), y), size, Anchor::Above)?;
    }
    for ((panel, origin), is_shared) in figure.panels.iter().zip(layout.origins()).zip(layout.shared()) {
        Frame::new(panel, origin, layout.plot).draw(&layout.margins, is_shared, canvas)?;
    }
    let is_inside = layout.legend == 0;
    legend::draw(figure, legend, (is_inside, layout.plots_height()), canvas)?;
    canvas.present()
}

/// The size of the title of a figure.
const TITLE: i32 = 18;
/// The most lines of a title.
const TITLE_LINES: usize = 3;

/// Margins in pixels: left of a plot, at least, above it below a title of one line, and below it.
const LEFT: i32 = 76;
const TOP: i32 = 66;
const BELOW: i32 = 62;
/// The height of a panel's title above its plot, and the room below a plot whose axis is that of the panel below it.
const HEAD: i32 = 30;
const SHARED: i32 = 12;
/// Left of the labels of a vertical axis: the axis' name with its margins; right of them, the gap to the plot.
const BESIDE_LABELS: i32 = 30;
/// Between the columns of plots, so that a name does not lean on the frame beside it.
const BETWEEN: i32 = 16;
/// Margin to the right of the legend, and between it and the plots.
const RIGHT: i32 = 24;
const BESIDE: i32 = 32;

/// The least width and height of a plot, and the width below which plots are rather set one below the other.
const LEAST: (i32, i32) = (90, 120);
const NARROW: i32 = 220;
/// The size of one of several plots that are one below the other.
const STACKED: (i32, i32) = (640, 180);
/// The greatest width and height of a drawing in pixels.
pub(super) const MOST: i32 = 10_000;

/// Sizes in pixels.
#[derive(Clone, Copy)]
pub(super) struct Layout {
    /// Width and height of a plot.
    plot: (i32, i32),
    margins: Margins,
    columns: i32,
    panels: i32,
    /// The panels, a bit each, whose horizontal axis is that of the panel below them.
    shared: u64,
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
        let margins = Margins { left: LEFT, top: TOP, head: HEAD, below: BELOW, lines: 2 };
        Self { plot, margins, columns, panels, shared: 0, legend, below: 0, spare: (0, 0) }.with_room(figure)
    }

    /// This layout, one panel below the other.
    fn in_a_column(self, figure: &Figure) -> Self {
        let is_same = |pair: &[Panel]| matches!(pair, [a, b] if a.x == b.x && !a.x.label.is_empty());
        let pairs = (0..u64::BITS).zip(figure.panels.windows(2));
        let shared = pairs.filter(|(_, pair)| is_same(pair)).fold(0, |bits, (i, _)| bits | 1 << i);
        Self { columns: 1, shared, ..self }
    }

    /// This layout with room for the texts around plots of its size.
    fn with_room(self, figure: &Figure) -> Self {
        let lines = figure.panels.iter().map(|panel| Frame::lines(panel, self.plot, self.margins.lines));
        let most = lines.fold([1; 3], |[a, b, c], [d, e, f]| [a.max(d), b.max(e), c.max(f)]);
        let [head, below, beside] = most.map(|lines| (lines - 1) * LINE);
        let shown = figure.panels.iter().map(|panel| &panel.y).filter(|axis| !axis.label.is_empty());
        let labels = shown.flat_map(|axis| scale::drawn(axis).1);
        let widest = labels.map(|(_, text)| letters::width(&text, TEXT)).max().unwrap_or(0);
        let left = LEFT.max(widest + BESIDE_LABELS + beside);
        let margins =
            Margins { left, top: TOP + head, head: HEAD + head, below: BELOW + below, ..self.margins };
        let layout = Self { margins, ..self };
        let lines = i32::try_from(layout.title(figure).0.len()).unwrap_or(1).max(1);
        Self { margins: Margins { top: margins.top + (lines - 1) * LINE, ..margins }, ..layout }
    }

    /// The middle of the title.
    fn middle(&self) -> i32 {
        (self.margins.left + self.panels_width()) / 2
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

    /// This layout with one line for each text around its plots.
    fn in_one_line(self) -> Self {
        Self { margins: Margins { lines: 1, ..self.margins }, ..self }
    }

    /// The least size of the figure in pixels.
    fn least(&self, figure: &Figure) -> (i32, i32) {
        Self { plot: LEAST, ..self.in_one_line() }.with_room(figure).size()
    }

    /// The layout of a figure of a given size in pixels; `None` where the plots would have no room.
    fn fitted(self, figure: &Figure, size: (u32, u32)) -> Option<Self> {
        self.fitted_as_is(figure, size).or_else(|| self.in_one_line().fitted_as_is(figure, size))
    }

    fn fitted_as_is(self, figure: &Figure, size: (u32, u32)) -> Option<Self> {
        let beside = self.shared_out(figure, size);
        let is_wide = beside.is_some_and(|layout| layout.plot.0 >= NARROW);
        if self.columns == 1 || is_wide && !figure.is_stacked {
            return beside;
        }
        self.in_a_column(figure).shared_out(figure, size).or(beside)
    }

    /// The layout of a figure that may choose its size.
    fn by_itself(self, figure: &Figure) -> Self {
        if figure.is_stacked && self.panels > 1 {
            return Self { plot: STACKED, ..self.in_a_column(figure) }.with_room(figure);
        }
        self
    }

    /// The plots with a share each of a given size; `None` where they would have no room.
    fn shared_out(self, figure: &Figure, (width, height): (u32, u32)) -> Option<Self> {
        let given = (i32::try_from(width).ok()?, i32::try_from(height).ok()?);
        if given.0 > MOST || given.1 > MOST {
            return None;
        }
        let fills = |of: Self| {
            // What the plots cannot share stays empty, so that the picture has the size asked for.
            let of = Self { spare: (0, 0), ..of };
            let (own, rows) = (of.size(), of.rows());
            let (across, down) = (given.0 - own.0, given.1 - own.1);
            let plot = (of.plot.0 + across.div_euclid(of.columns), of.plot.1 + down.div_euclid(rows));
            let spare = (across.rem_euclid(of.columns), down.rem_euclid(rows));
            (plot.0 >= LEAST.0 && plot.1 >= LEAST.1).then_some(Self { plot, spare, ..of })
        };
        // A narrower plot has more lines of text, and more lines leave less room: the steps have an end.
        let mut layout = fills(Self { plot: (MOST, MOST), ..self }.with_room(figure))?;
        loop {
            let next = fills(layout.with_room(figure))?;
            if next.margins == layout.margins {
                return Some(next);
            }
            layout = next;
        }
    }

    /// The place of the legend in the plot of a single panel, where it covers nothing.
    fn legend_inside(&self, figure: &Figure) -> Option<(i32, i32)> {
        let [panel] = figure.panels.as_slice() else { return None };
        let frame = Frame::new(panel, (self.margins.left, self.margins.top), self.plot);
        let places = legend::places(figure, (self.margins.left, self.margins.top), self.plot)?;
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
        let fits = layout.margins.left + width + legend::ROOM <= layout.size().0;
        fits.then_some((layout, (layout.margins.left, bottom - layout.below + legend::ROOM / 2)))
    }

    /// The width from one plot to the next.
    fn across(&self) -> i32 {
        self.plot.0 + self.margins.left + BETWEEN
    }

    /// For each panel, whether its horizontal axis is labelled at the panel below it only.
    fn shared(&self) -> impl Iterator<Item = bool> + '_ {
        (0..self.panels.unsigned_abs()).map(|i| self.shared.checked_shr(i).is_some_and(|bits| bits & 1 == 1))
    }

    /// The height of each row: a plot with its title and the texts below it.
    fn rows_down(&self) -> impl Iterator<Item = i32> + '_ {
        let below = move |is_shared| if is_shared { SHARED } else { self.margins.below };
        let every = self.columns.unsigned_abs() as usize;
        self.shared().step_by(every).map(move |is_shared| self.margins.head + self.plot.1 + below(is_shared))
    }

    fn panels_width(&self) -> i32 {
        self.columns * self.across() - BETWEEN
    }

    fn size(&self) -> (i32, i32) {
        let width = self.panels_width() + BESIDE + self.legend + RIGHT;
        let height = self.margins.top - self.margins.head + self.rows_down().sum::<i32>() + 6 + self.below;
        (width + self.spare.0, height + self.spare.1)
    }

    /// The height of all panels, from the top of the first.
    fn plots_height(&self) -> i32 {
        self.size().1 - self.below - self.margins.top - self.margins.below
    }

    /// The upper left corner of each plot.
    fn origins(&self) -> impl Iterator<Item = (i32, i32)> + '_ {
        let tops = self.rows_down().scan(self.margins.top, |top, down| {
            let own = *top;
            *top += down;
            Some(own)
        });
        tops.flat_map(move |top| (0..self.columns).map(move |i| (self.margins.left + i * self.across(), top)))
    }
}
