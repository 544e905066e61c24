//! Figures of panels with axes, lines, marks and planes, as data in CSV and as pictures in SVG, PNG and PDF.
//!
//! ```
//! use stickslip_draw::{Axis, Figure, Panel, Series, Style};
//! let (x, y) = (Axis::linear("time (s)", 0.0, 1.0), Axis::linear("displacement (m)", 0.0, 2.0));
//! let line = Series::new("body", Style::Line, 0, [(0.0, 0.0), (1.0, 2.0)]);
//! let figure = Figure::new("motion", "A motion", "", [Panel::new("", x, y, vec![line])]);
//! assert!(figure.svg()?.starts_with("<svg"));
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

mod figure;
mod picture;
mod plane;

pub use figure::{Axis, Figure, Panel, Series, Style};
pub use plane::{Plane, Scale};
#[cfg(feature = "png")]
use std::io;

/// The greatest width and height of a drawing in pixels.
pub const MOST_PIXELS: u32 = picture::MOST.unsigned_abs();

/// A drawing in SVG as PNG, `width` pixels wide, in DejaVu Sans.
///
/// # Errors
/// [`io::ErrorKind::Other`] where the text is no SVG, or the width is 0, or too large for an image in memory.
#[cfg(feature = "png")]
pub fn png_of_svg(svg: &str, width: u32) -> io::Result<Vec<u8>> {
    picture::png(svg, width)
}

/// A drawing in SVG of solid lines, areas and texts as a page of PDF of its own size; its texts, in DejaVu Sans, can be found and copied.
///
/// # Errors
/// [`io::ErrorKind::Other`] where the text is no SVG, or has images or gradients.
#[cfg(feature = "png")]
pub fn pdf_of_svg(svg: &str) -> io::Result<Vec<u8>> {
    picture::pdf(svg)
}
