//! The figures of the paper, redrawn from this library's results, and some additional ones.
//!
//! | file | figures |
//! |---|---|
//! | `oscillator` | 1: the oscillator and its law of friction |
//! | `symmetry` | 3: the error measures |
//! | `response` | 4–7: Δ₀/B, the two phases, Δ₁/B, V₀/(Bω_d) |
//! | `border` | 8: the least force ratio without sticking; the neighbourhood of the poles 1/3 and 1/5 |
//! | `dissipation` | 9a, 9b, 10a, 10b: the loop sizes |
//! | `stops` | the map of stops per cycle |
//! | `portrait` | 2: a cycle without stops in the phase plane; two motions with their transients |
//! | `accuracy` | digits lost near Ω = 1 |
//! | `multipliers` | the rate at which the motion settles |
//! | `damping` | the effect of viscous damping |
//! | `draw` | a figure as SVG, PNG or PDF |
//!
//! A figure is data first: [`Figure::write_csv`] writes the data that [`Figure::svg`] draws.
//!
//! ```
//! let border = stickslip_figures::figure("8").unwrap();
//! assert!(border.svg()?.starts_with("<svg"));
//! # Ok::<(), std::io::Error>(())
//! ```

#![cfg_attr(
    not(test),
    deny(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::indexing_slicing,
        clippy::unreachable,
        clippy::wildcard_enum_match_arm
    )
)]

mod accuracy;
mod border;
mod damping;
mod dissipation;
mod draw;
mod multipliers;
mod oscillator;
mod plane;
mod portrait;
mod response;
mod stops;
mod symmetry;

#[doc(hidden)]
pub use plane::{Plane, Scale};
#[doc(hidden)]
use std::io::{self, Write};
use stickslip::motion::{LongRun, State, SteadyState};
use stickslip::{Cycle, Error, Ratios};

/// Defines the figures from one row each: the name, and the function that makes it.
macro_rules! figures {
    ($($name:literal => $of:path),* $(,)?) => {
        /// The names of all figures, in order; those of the paper have their numbers.
        pub const NAMES: [&str; [$($name),*].len()] = [$($name),*];

        /// The figure with that name, one of [`NAMES`].
        #[must_use]
        pub fn figure(name: &str) -> Option<Figure> {
            match name {
                $($name => Some($of()),)*
                _ => None,
            }
        }
    };
}

figures! {
    "1" => oscillator::with_friction,
    "2" => portrait::in_phase_plane,
    "3" => symmetry::errors,
    "4" => response::max_displacement,
    "5" => response::phases,
    "6" => response::deviation,
    "7" => response::max_velocity,
    "8" => border::least_force,
    "9a" => dissipation::best_force,
    "9b" => dissipation::largest_loop,
    "10a" => dissipation::loop_by_friction,
    "10b" => dissipation::loop_by_frequency,
    "stops" => stops::per_cycle,
    "portrait" => portrait::two_motions,
    "accuracy" => accuracy::beside_one,
    "multipliers" => multipliers::of_the_cycle,
    "poles" => border::beside_poles,
    "damping" => damping::four_ratios,
}

/// A figure: panels side by side, and a caption.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// One of [`NAMES`], or a name chosen by the user for a figure of their own.
    pub name: String,
    /// The content in a line.
    pub title: String,
    /// The observations to make in the figure, with the parameters.
    pub caption: String,
    /// The panels, row by row.
    #[doc(hidden)]
    pub panels: Vec<Panel>,
    /// Whether the panels are one below the other, as those over one axis of time.
    #[doc(hidden)]
    pub is_stacked: bool,
}

/// One pair of axes and its contents.
#[derive(Debug, Clone, PartialEq)]
#[doc(hidden)]
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
#[doc(hidden)]
pub struct Axis {
    /// Quantity and unit; empty for an axis that is not shown.
    pub label: String,
    /// Value at the start of the axis.
    pub low: f64,
    /// Value at the end of the axis.
    pub high: f64,
    /// Whether the scale is logarithmic.
    pub logarithmic: bool,
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
        Self { label: label.to_owned(), low, high, logarithmic }
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

    /// An axis of Ω from `low` to `high`.
    pub(crate) fn frequency_ratio(low: f64, high: f64) -> Self {
        Self::linear("frequency ratio Ω = ω_d/ω_n", low, high)
    }

    /// From 0 at the start of the axis to 1 at its end.
    pub(crate) fn share(&self, value: f64) -> f64 {
        plane::share((self.low, self.high), self.logarithmic, value)
    }
}

/// Points of one kind, with a name.
#[derive(Debug, Clone, PartialEq)]
#[doc(hidden)]
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
#[doc(hidden)]
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
    #[doc(hidden)]
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
    #[doc(hidden)]
    #[must_use]
    pub fn stacked(self) -> Self {
        Self { is_stacked: true, ..self }
    }

    /// A figure of one panel.
    pub(crate) fn single(
        name: &str,
        title: &str,
        caption: &str,
        x: Axis,
        y: Axis,
        series: Vec<Series>,
    ) -> Self {
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

    /// The drawing as an SVG file without embedded fonts.
    ///
    /// # Errors
    ///
    /// Errors of the drawing library, none of which are known to occur.
    pub fn svg(&self) -> io::Result<String> {
        draw::svg(self, None)
    }

    /// The drawing as an SVG file with a width and a height in pixels.
    ///
    /// # Errors
    /// [`io::ErrorKind::InvalidInput`] where the plots would have no room, or the size is beyond all use.
    pub fn svg_of_size(&self, size: (u32, u32)) -> io::Result<String> {
        draw::svg(self, Some(size))
    }
}

/// The greatest width and height of a drawing in pixels.
pub const MOST_PIXELS: u32 = draw::MOST.unsigned_abs();

/// A drawing in SVG as PNG, `width` pixels wide, in DejaVu Sans.
///
/// # Errors
/// [`io::ErrorKind::Other`] where the text is no SVG, or the width is 0, or too large for an image in memory.
#[cfg(feature = "png")]
pub fn png_of_svg(svg: &str, width: u32) -> io::Result<Vec<u8>> {
    draw::png(svg, width)
}

/// A drawing in SVG of solid lines, areas and texts as a page of PDF of its own size, letters as outlines of DejaVu Sans.
///
/// # Errors
/// [`io::ErrorKind::Other`] where the text is no SVG, or has images or gradients.
#[cfg(feature = "png")]
pub fn pdf_of_svg(svg: &str) -> io::Result<Vec<u8>> {
    draw::pdf(svg)
}

/// A field of CSV, quoted if necessary.
fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}

/// `count` numbers from `low` to `high`, both included.
pub(crate) fn evenly(low: f64, high: f64, count: u32) -> impl Iterator<Item = f64> + Clone {
    let last = f64::from(count.max(2) - 1);
    (0..count).map(move |i| low + (high - low) * f64::from(i) / last)
}

/// A value of the closed-form cycle; NaN where it would stick.
pub(crate) fn of_cycle(omega: f64, alpha: f64, value: fn(&Cycle<f64>) -> f64) -> f64 {
    Ratios::new(omega, alpha).and_then(Cycle::new).as_ref().map_or(f64::NAN, value)
}

/// The limit of the motion from rest.
pub(crate) fn from_rest(omega: f64, alpha: f64) -> Result<LongRun<f64>, Error> {
    Ratios::new(omega, alpha).and_then(|ratios| LongRun::from_start(ratios, State::default()))
}

/// The steady state that the motion from rest reaches.
pub(crate) fn settled(omega: f64, alpha: f64) -> Option<SteadyState<f64>> {
    from_rest(omega, alpha).ok()?.steady_state().copied()
}

/// The values of 1/α in the paper's figures 4 to 7, with their names and places in the palette.
pub(crate) fn inverse_force_ratios(greatest: u32) -> impl Iterator<Item = (usize, f64, String)> {
    (1..=greatest).map(|tenth| {
        let inverse = f64::from(tenth) / 10.0;
        (tenth as usize - 1, 1.0 / inverse, format!("1/α = {inverse}"))
    })
}
