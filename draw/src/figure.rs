//! A figure as data: panels, axes, series and planes.

use crate::plane::{Plane, share};
use std::io::{self, Write};

/// A figure: panels side by side, and a caption.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// Its name.
    pub name: String,
    /// The content in a line.
    pub title: String,
    /// The observations to make in the figure, with the parameters.
    pub caption: String,
    /// The panels, row by row.
    pub panels: Vec<Panel>,
    /// Whether the panels are one below the other, as those over one axis of time.
    pub is_stacked: bool,
}

/// One pair of axes and its contents.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// The title that distinguishes the panel from the others; empty for a single panel.
    pub title: String,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// Values over the plane of the axes, behind the series.
    pub plane: Option<Plane>,
    /// Lines and marks, drawn in this order.
    pub series: Vec<Series>,
}

/// An axis: name with unit, and range.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// Quantity and unit; empty for an axis that is not shown.
    pub label: String,
    /// Value at the start of the axis.
    pub low: f64,
    /// Value at the end of the axis.
    pub high: f64,
    /// Whether the scale is logarithmic.
    pub logarithmic: bool,
    /// The greatest value of the axes of its unit in the figure, whose prefix it has, too; 0 for an axis by itself.
    pub(crate) beside: f64,
}

impl Panel {
    /// A panel without a plane.
    pub fn new(title: impl Into<String>, x: Axis, y: Axis, series: Vec<Series>) -> Self {
        Self { title: title.into(), x, y, plane: None, series }
    }

    /// This panel over a plane.
    #[must_use]
    pub fn over(self, plane: Plane) -> Self {
        Self { plane: Some(plane), ..self }
    }
}

impl Axis {
    /// An axis with a linear or a logarithmic scale.
    #[must_use]
    pub fn new(label: &str, (low, high): (f64, f64), logarithmic: bool) -> Self {
        Self { label: label.to_owned(), low, high, logarithmic, beside: 0.0 }
    }

    /// An axis with a linear scale.
    #[must_use]
    pub fn linear(label: &str, low: f64, high: f64) -> Self {
        Self::new(label, (low, high), false)
    }

    /// An axis with a logarithmic scale.
    #[must_use]
    pub fn logarithmic(label: &str, low: f64, high: f64) -> Self {
        Self::new(label, (low, high), true)
    }

    /// From 0 at the start of the axis to 1 at its end.
    pub(crate) fn share(&self, value: f64) -> f64 {
        share((self.low, self.high), self.logarithmic, value)
    }
}

/// Points of one kind, with a name.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// The name in the data.
    pub name: String,
    /// The text in the legend, by default the name. Series with the same text share an entry; those without
    /// text have none.
    pub key: String,
    /// The style of the series.
    pub style: Style,
    /// The index of the colour and the mark.
    pub index: usize,
    /// (x, y); a NaN breaks a line, and an infinite y lies on the upper edge.
    pub points: Vec<(f64, f64)>,
}

/// The style in which a series is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Style {
    /// A full line.
    Line,
    /// A full line of double width.
    Thick,
    /// A dashed line.
    Dashed,
    /// A dotted line.
    Dotted,
    /// A full line with a mark at every n-th point.
    Marked(usize),
    /// Marks without a line.
    Marks,
    /// Small dots.
    Dots,
    /// An arrowhead on the upper edge at each x, where a line leaves the panel.
    Beyond,
    /// A thin line with an arrowhead at its end, not in the legend.
    Arrow,
    /// The name itself, written at each point; not in the legend.
    Named,
    /// The name as a note in the legend, without points.
    Note,
}

impl Style {
    /// Whether points are joined by a line.
    pub(crate) const fn is_line(self) -> bool {
        matches!(self, Self::Line | Self::Thick | Self::Dashed | Self::Dotted | Self::Marked(_) | Self::Arrow)
    }

    /// The lengths of a dash and of a gap in pixels, of a line that has them.
    pub(crate) fn dashes(self) -> Option<(i32, i32)> {
        let of = [(Self::Dashed, (7, 4)), (Self::Dotted, (2, 3))];
        of.into_iter().find(|(style, _)| *style == self).map(|(_, lengths)| lengths)
    }
}

impl Series {
    /// A series; `index` chooses the colour and the mark.
    pub fn new(
        name: impl Into<String>,
        style: Style,
        index: usize,
        points: impl IntoIterator<Item = (f64, f64)>,
    ) -> Self {
        let name = name.into();
        Self { key: name.clone(), name, style, index, points: points.into_iter().collect() }
    }

    /// Arrowheads at these x, where curves are unbounded.
    pub fn unbounded(places: impl IntoIterator<Item = f64>) -> Self {
        Self::new("unbounded", Style::Beyond, 0, places.into_iter().map(|x| (x, f64::INFINITY)))
    }

    /// This series with another text in the legend.
    #[must_use]
    pub fn with_key(self, key: impl Into<String>) -> Self {
        Self { key: key.into(), ..self }
    }
}

impl Figure {
    /// A figure of these panels.
    pub fn new(
        name: impl Into<String>,
        title: impl Into<String>,
        caption: impl Into<String>,
        panels: impl Into<Vec<Panel>>,
    ) -> Self {
        let panels = panels.into();
        Self { name: name.into(), title: title.into(), caption: caption.into(), panels, is_stacked: false }
    }

    /// This figure with its panels one below the other, where its height has room.
    #[must_use]
    pub fn stacked(self) -> Self {
        Self { is_stacked: true, ..self }
    }

    /// A figure of one panel.
    #[must_use]
    pub fn single(name: &str, title: &str, caption: &str, x: Axis, y: Axis, series: Vec<Series>) -> Self {
        Self::new(name, title, caption, [Panel::new("", x, y, series)])
    }

    /// Writes the data with the columns panel, series, x, y and value; a plane fills x, y and value, and an
    /// infinite value has an empty y.
    ///
    /// # Errors
    ///
    /// Errors of `out`.
    pub fn write_csv(&self, out: &mut impl Write) -> io::Result<()> {
        writeln!(out, "panel,series,x,y,value")?;
        for panel in &self.panels {
            let title = quoted(&panel.title);
            if let Some(plane) = &panel.plane {
                for (x, y, value) in plane.points() {
                    writeln!(out, "{title},{},{x},{y},{value}", quoted(&plane.label))?;
                }
            }
            for series in &panel.series {
                let beyond = series.style == Style::Beyond;
                let is_shown = |(x, y): &&(f64, f64)| x.is_finite() && (beyond || y.is_finite());
                for (x, y) in series.points.iter().filter(is_shown) {
                    let y = if beyond { String::new() } else { y.to_string() };
                    writeln!(out, "{title},{},{x},{y},", quoted(&series.name))?;
                }
            }
        }
        Ok(())
    }
}

/// A field of CSV, quoted if necessary.
fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}
