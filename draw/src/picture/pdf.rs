//! A drawing as a page of PDF: paths, and texts in an embedded font.
//!
//! Our drawings have solid lines, areas and texts, and nothing else of SVG, so that the operators of a page that are
//! used here are few: PDF 32000-1:2008, 7.5 (the file), 8.5 (paths), 8.4 (line styles), 9.4 (texts).

mod letters;
mod objects;

use super::png::tree;
use letters::Letters;
use objects::{number, packed};
use resvg::tiny_skia::{PathSegment, Transform};
use resvg::usvg::{Color, FillRule, Group, LineCap, LineJoin, Node, Paint, Path, Stroke, Text};
use std::fmt::Write as _;
use std::io::{self, Write as _};

/// Points in a pixel of CSS, in which the size of a drawing is.
const POINTS: f32 = 0.75;

/// The drawing as a page of its own size.
pub(crate) fn pdf(svg: &str) -> io::Result<Vec<u8>> {
    let tree = tree(svg)?;
    let (width, height) = (tree.size().width() * POINTS, tree.size().height() * POINTS);
    // A page counts upwards from its lower left corner.
    let mut content = format!("{POINTS} 0 0 -{POINTS} 0 {} cm\n", number(height));
    let mut letters = Letters::new();
    group(tree.root(), &mut letters, &mut content)?;
    file(width, height, content.as_bytes(), &letters)
}

fn group(group: &Group, letters: &mut Letters, content: &mut String) -> io::Result<()> {
    for node in group.children() {
        match node {
            Node::Group(inner) => self::group(inner, letters, content)?,
            Node::Path(of) => path(of, content)?,
            Node::Text(of) => text(of, letters, content)?,
            Node::Image(_) => return Err(io::Error::other("a drawing with an image has no PDF")),
        }
    }
    Ok(())
}

/// The glyphs of a text, each at its place: a drawing spaces and turns its texts.
fn text(text: &Text, letters: &mut Letters, content: &mut String) -> io::Result<()> {
    for span in text.layouted().iter().filter(|span| span.visible) {
        let Some(fill) = &span.fill else { continue };
        line(content, &colour(fill.paint(), fill.opacity().get())?, "rg");
        content.push_str("BT\n/F 1 Tf\n");
        let units = letters.units();
        for glyph in &span.positioned_glyphs {
            let id = u16::try_from(glyph.id.0).map_err(io::Error::other)?;
            let to = text.abs_transform().pre_concat(glyph.outline_transform()).pre_scale(units, units);
            let Transform { sx, kx, ky, sy, tx, ty } = to;
            line(content, &[sx, ky, kx, sy, tx, ty], "Tm");
            let _ = writeln!(content, "<{:04x}> Tj", letters.number(id, &glyph.text));
        }
        content.push_str("ET\n");
    }
    Ok(())
}

fn path(path: &Path, content: &mut String) -> io::Result<()> {
    if !path.is_visible() {
        return Ok(());
    }
    let (fill, stroke) = (path.fill(), path.stroke());
    let painted = match (fill, stroke) {
        (None, None) => return Ok(()),
        (Some(of), None) if of.rule() == FillRule::EvenOdd => "f*",
        (Some(_), None) => "f",
        (None, Some(_)) => "S",
        (Some(of), Some(_)) if of.rule() == FillRule::EvenOdd => "B*",
        (Some(_), Some(_)) => "B",
    };
    let transform = path.abs_transform();
    if let Some(fill) = fill {
        let [r, g, b] = colour(fill.paint(), fill.opacity().get())?;
        line(content, &[r, g, b], "rg");
    }
    if let Some(stroke) = stroke {
        let [r, g, b] = colour(stroke.paint(), stroke.opacity().get())?;
        line(content, &[r, g, b], "RG");
        style(stroke, transform, content);
    }
    let at = |x: f32, y: f32| {
        let Transform { sx, kx, ky, sy, tx, ty } = transform;
        (sx * x + kx * y + tx, ky * x + sy * y + ty)
    };
    let mut last = (0.0, 0.0);
    for segment in path.data().segments() {
        match segment {
            PathSegment::MoveTo(p) | PathSegment::LineTo(p) => {
                last = at(p.x, p.y);
                let operator = if matches!(segment, PathSegment::MoveTo(_)) { "m" } else { "l" };
                line(content, &[last.0, last.1], operator);
            }
            PathSegment::QuadTo(a, p) => {
                // A curve of the second degree as one of the third.
                let (a, p) = (at(a.x, a.y), at(p.x, p.y));
                let towards =
                    |of: (f32, f32)| (of.0 + (a.0 - of.0) * 2.0 / 3.0, of.1 + (a.1 - of.1) * 2.0 / 3.0);
                let (b, c) = (towards(last), towards(p));
                line(content, &[b.0, b.1, c.0, c.1, p.0, p.1], "c");
                last = p;
            }
            PathSegment::CubicTo(a, b, p) => {
                let (a, b, p) = (at(a.x, a.y), at(b.x, b.y), at(p.x, p.y));
                line(content, &[a.0, a.1, b.0, b.1, p.0, p.1], "c");
                last = p;
            }
            PathSegment::Close => line(content, &[], "h"),
        }
    }
    line(content, &[], painted);
    Ok(())
}

/// Width, ends, corners and dashes of a line.
fn style(stroke: &Stroke, transform: Transform, content: &mut String) {
    let scale = (transform.sx * transform.sy - transform.kx * transform.ky).abs().sqrt();
    line(content, &[stroke.width().get() * scale], "w");
    let cap = match stroke.linecap() {
        LineCap::Butt => 0.0,
        LineCap::Round => 1.0,
        LineCap::Square => 2.0,
    };
    let join = match stroke.linejoin() {
        LineJoin::Miter | LineJoin::MiterClip => 0.0,
        LineJoin::Round => 1.0,
        LineJoin::Bevel => 2.0,
    };
    line(content, &[cap], "J");
    line(content, &[join], "j");
    let dashes = stroke.dasharray().unwrap_or_default().iter().map(|length| number(length * scale));
    let dashes = dashes.collect::<Vec<_>>().join(" ");
    let _ = writeln!(content, "[{dashes}] {} d", number(stroke.dashoffset() * scale));
}

/// The parts of a colour, from 0 to 1.
fn colour(paint: &Paint, opacity: f32) -> io::Result<[f32; 3]> {
    let Paint::Color(Color { red, green, blue }) = paint else {
        return Err(io::Error::other("a drawing with gradients or patterns has no PDF"));
    };
    if opacity < 1.0 {
        return Err(io::Error::other("a transparent drawing has no PDF"));
    }
    Ok([red, green, blue].map(|part| f32::from(*part) / 255.0))
}

/// Numbers and an operator, on a line.
fn line(content: &mut String, numbers: &[f32], operator: &str) {
    for value in numbers {
        content.push_str(&number(*value));
        content.push(' ');
    }
    content.push_str(operator);
    content.push('\n');
}

/// The file of a page: its objects, the table of their places, and where that table is.
fn file(width: f32, height: f32, content: &[u8], letters: &Letters) -> io::Result<Vec<u8>> {
    let fonts = if letters.is_empty() { "" } else { "/Font<</F 5 0 R>>" };
    let page = format!(
        "<</Type/Page/Parent 2 0 R/MediaBox[0 0 {} {}]/Resources<<{fonts}>>/Contents 4 0 R>>",
        number(width),
        number(height)
    );
    let mut objects = vec![
        b"<</Type/Catalog/Pages 2 0 R>>".to_vec(),
        b"<</Type/Pages/Kids[3 0 R]/Count 1>>".to_vec(),
        page.into_bytes(),
        packed(content, "")?,
    ];
    if !letters.is_empty() {
        objects.extend(letters.objects(5)?);
    }
    let mut out = b"%PDF-1.4\n%\xe2\xe3\xcf\xd3\n".to_vec();
    let mut places = Vec::new();
    for (object, index) in objects.iter().zip(1..) {
        places.push(out.len());
        writeln!(out, "{index} 0 obj")?;
        out.extend(object);
        out.extend(b"\nendobj\n");
    }
    let table = out.len();
    writeln!(out, "xref\n0 {}\n0000000000 65535 f ", places.len() + 1)?;
    for place in &places {
        writeln!(out, "{place:010} 00000 n ")?;
    }
    let count = places.len() + 1;
    writeln!(out, "trailer\n<</Size {count}/Root 1 0 R>>\nstartxref\n{table}\n%%EOF")?;
    Ok(out)
}
