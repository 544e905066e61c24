//! The area for drawing, and texts on it.

use plotters::backend::SVGBackend;
use plotters::coord::Shift;
use plotters::drawing::{DrawingArea, DrawingAreaErrorKind};
use plotters::element::Text;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{BLACK, FontTransform, IntoFont, TextStyle};
use std::io;
use stickslip_front::text::printable;

/// The number of drawing units in a pixel.
pub(super) const UNITS: i32 = 4;

/// The area for drawing.
pub(super) type Canvas<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// The result of drawing.
pub(super) type Drawn<T = ()> = Result<T, DrawingAreaErrorKind<io::Error>>;

/// The size of the texts that give way last: 7 pt where a picture of 450 pixels is 85 mm wide.
pub(super) const TEXT: i32 = 14;

/// The height of a line.
pub(super) const LINE: i32 = 20;

/// The margins of the plots, in pixels: each grows with the lines of its texts.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) struct Margins {
    /// Left of a plot, with room for the labels and the name of the widest vertical axis.
    pub(super) left: i32,
    /// Above the first plot, with room for the lines of the title.
    pub(super) top: i32,
    /// Between a plot and what is above it.
    pub(super) head: i32,
    /// Below a plot, with room for the name of the horizontal axis.
    pub(super) below: i32,
    /// The most lines of a panel's title and of an axis' name: where two leave the plots no room, one, cut if need be.
    pub(super) lines: usize,
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
    canvas.draw(&Text::new(printable(text).into_owned(), (x * UNITS, y * UNITS), style))
}
