//! `stickslip figure` and `figures`.

use crate::args::{FigureArgs, FiguresArgs, LookArgs, Picture};
use crate::failure::{Failure, Outcome};
use crate::output::{self, PendingFile};
use crate::threads;
use clap::ValueEnum;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use std::fs;
use std::io::Write;
use std::path::Path;
use stickslip_draw::{Figure, MOST_PIXELS as MOST};
use stickslip_figures as figures;
use stickslip_front::text::{is_control, printable};

/// The width of a PNG in pixels.
#[cfg(feature = "png")]
const WIDTH: u32 = 1600;

/// The most pixels of a PNG: 160 MB of memory.
#[cfg(feature = "png")]
const MOST_OF_PNG: u64 = 40_000_000;

/// The look of a picture that has no options for it.
pub(crate) static PLAIN: LookArgs = LookArgs { title: None, size: None };

pub(crate) fn run(args: &FigureArgs, out: &mut impl Write) -> Outcome {
    let target = Target::new("--out", args.out.as_deref(), args.overwrite, &PLAIN)?;
    target.draw(out, || {
        figures::figure(&args.name).ok_or_else(|| {
            let names = figures::NAMES.join(", ");
            Failure::Input(format!("figure {}: must be one of {names}", args.name))
        })
    })
}

pub(crate) fn run_all(args: &FiguresArgs, out: &mut impl Write) -> Outcome {
    if !args.all {
        for name in figures::NAMES {
            writeln!(out, "{name}")?;
        }
        return Ok(());
    }
    let folder = &args.dir;
    check(args.format, &format!("--format {}", args.format.extension()))?;
    fs::create_dir_all(folder).map_err(|e| format!("--dir {}: {e}", folder.display()))?;
    let extension = args.format.extension();
    let place = |name: &str| folder.join(format!("{name}.{extension}"));
    // Either all files are written or none.
    figures::NAMES.iter().try_for_each(|name| {
        let place = place(name);
        output::refuse_existing(&place, &place.display().to_string(), args.overwrite)
    })?;
    let draw = |name: &str| match figures::figure(name) {
        Some(figure) => {
            let place = place(name);
            let pending = PendingFile::create(&place, &format!("--out {}", place.display()), args.overwrite)?;
            pending.fill(|out| write(&figure, args.format, None, out))
        }
        None => Ok(()),
    };
    threads::on_all(|| figures::NAMES.into_par_iter().try_for_each(draw))?;
    let place = folder.display().to_string();
    Ok(writeln!(out, "{} figures in {}", figures::NAMES.len(), printable(&place))?)
}

impl LookArgs {
    /// Fails where a look was asked for without the option of a picture.
    pub(crate) fn needs(&self, option: &str, picture: Option<&Path>) -> Outcome {
        let refused = |look: &str| Err(format!("{look}: needs a picture, {option} FILE.svg").into());
        match (picture, &self.title, &self.size) {
            (None, Some(_), _) => refused("--title"),
            (None, None, Some(_)) => refused("--size"),
            _ => Ok(()),
        }
    }

    /// The width and the height in pixels.
    fn size(&self) -> Result<Option<(u32, u32)>, Failure> {
        let read = |text: &String| {
            // The conversion saturates, and a size beyond all use is refused.
            let pixels = |part: &str| part.trim().parse::<f64>().ok().map(|pixels| pixels as u32);
            let parts = text.split_once('x').and_then(|(a, b)| Some((pixels(a)?, pixels(b)?)));
            parts.ok_or_else(|| {
                Failure::Input(format!("--size {text}: must be WIDTHxHEIGHT in pixels, such as 900x500"))
            })
        };
        self.size.as_ref().map(read).transpose()
    }
}

/// A range LOW:HIGH of values, which are above 0 unless their axis is linear.
pub(crate) fn range(option: &str, text: &str, is_linear: bool) -> Result<(f64, f64), Failure> {
    let number = |part: &str| part.trim().parse::<f64>().ok().filter(|x| x.is_finite());
    let ends = text.split_once(':').and_then(|(low, high)| Some((number(low)?, number(high)?)));
    let bad = |bound: &str| Failure::Input(format!("{option} {text}: must be {bound}"));
    match ends {
        None => Err(bad("LOW:HIGH, such as 0:0.02")),
        Some((low, high)) if low >= high => Err(bad("LOW:HIGH with LOW < HIGH")),
        Some((low, _)) if low <= 0.0 && !is_linear => Err(bad("0 < LOW < HIGH on a logarithmic axis")),
        Some(ends) => Ok(ends),
    }
}

/// The content of a file, by the extension of its name. Only `--out` has data, too.
fn picture_of(option: &str, file: &Path) -> Result<Picture, Failure> {
    let (name, has_data) = (file.display(), option == "--out");
    let end = file.extension().and_then(|e| e.to_str());
    let known = Picture::value_variants().iter().filter(|picture| has_data || **picture != Picture::Csv);
    let picture = known.copied().find(|picture| end == Some(picture.extension())).ok_or_else(|| {
        let data = if has_data { " (drawing) or .csv (data)" } else { "" };
        Failure::Input(format!("{option} {name}: the name must end in .svg, .png or .pdf{data}"))
    })?;
    check(picture, &format!("{option} {name}"))?;
    Ok(picture)
}

/// Fails for a PNG or a PDF if the build does not support it.
fn check(picture: Picture, argument: &str) -> Outcome {
    if !matches!(picture, Picture::Png | Picture::Pdf) || cfg!(feature = "png") {
        return Ok(());
    }
    Err(format!(
        "{argument}: needs a build with the feature png, or a converter of .svg such as rsvg-convert"
    )
    .into())
}

/// The destination of rows or of a picture, which is known before the work begins.
pub(crate) struct Target<'a> {
    option: &'static str,
    /// The file, and its content by the extension of its name.
    file: Option<(&'a Path, Picture)>,
    overwrite: bool,
    title: Option<&'a str>,
    /// The width and the height of a picture in pixels.
    size: Option<(u32, u32)>,
}

impl<'a> Target<'a> {
    /// The file of an option, or standard output without one.
    pub(crate) fn new(
        option: &'static str,
        file: Option<&'a Path>,
        overwrite: bool,
        look: &'a LookArgs,
    ) -> Result<Self, Failure> {
        let file = file.map(|file| Ok::<_, Failure>((file, picture_of(option, file)?))).transpose()?;
        if let Some(title) = look.title.as_ref().filter(|title| title.contains(is_control)) {
            return Err(format!("--title {title}: must have no control characters").into());
        }
        if let Some((file, _)) = file {
            output::refuse_existing(file, &format!("{option} {}", file.display()), overwrite)?;
        }
        Ok(Self { option, file, overwrite, title: look.title.as_deref(), size: look.size()? })
    }

    /// Writes the rows, without a file to standard output, or draws the picture.
    pub(crate) fn fill(
        &self,
        out: &mut impl Write,
        rows: impl FnOnce(&mut dyn Write) -> Outcome,
        drawn: impl FnOnce() -> Result<Figure, Failure>,
    ) -> Outcome {
        match self.file {
            None => rows(out),
            Some((file, Picture::Csv)) => self.pending(file)?.fill(|out| rows(out)),
            Some(_) => self.draw(out, drawn),
        }
    }

    /// Draws the picture, without a file as SVG to standard output.
    pub(crate) fn draw(
        &self,
        out: &mut impl Write,
        drawn: impl FnOnce() -> Result<Figure, Failure>,
    ) -> Outcome {
        let titled =
            |figure: Figure| Figure { title: self.title.map_or(figure.title, str::to_owned), ..figure };
        match self.file {
            Some((file, picture)) => {
                self.pending(file)?.fill(|out| write(&titled(drawn()?), picture, self.size, out))
            }
            None => write(&titled(drawn()?), Picture::Svg, self.size, out),
        }
    }

    /// Writes a drawing that is no figure: its text as SVG, with the title, and the width and height in pixels.
    pub(crate) fn write_svg(
        &self,
        drawn: impl FnOnce(Option<&str>, Option<(u32, u32)>) -> Result<String, Failure>,
    ) -> Outcome {
        let Some((file, picture)) = self.file else { return Ok(()) };
        if let Some((width, height)) =
            self.size.filter(|(width, height)| *width.min(height) == 0 || *width.max(height) > MOST)
        {
            return Err(format!("--size {width}x{height}: must be ≥ 1x1 and ≤ {MOST}x{MOST}").into());
        }
        self.pending(file)?.fill(|out| write_drawing(&drawn(self.title, self.size)?, picture, self.size, out))
    }

    /// The temporary file, opened before drawing.
    fn pending(&self, file: &Path) -> Result<PendingFile, Failure> {
        PendingFile::create(file, &format!("{} {}", self.option, file.display()), self.overwrite)
    }
}

/// Writes a figure, with a width and a height in pixels if they are given.
fn write(figure: &Figure, picture: Picture, size: Option<(u32, u32)>, out: &mut impl Write) -> Outcome {
    if picture == Picture::Csv {
        return Ok(figure.write_csv(out)?);
    }
    let svg = size.map_or_else(|| figure.svg(), |size| figure.svg_of_size(size));
    write_drawing(&svg.map_err(|e| of_size(size, &e))?, picture, size, out)
}

/// Writes a drawing, whose text as SVG has this width and this height in pixels if they are given.
fn write_drawing(
    svg: &str,
    picture: Picture,
    #[cfg_attr(not(feature = "png"), expect(unused_variables, reason = "the text has its size"))]
    size: Option<(u32, u32)>,
    out: &mut impl Write,
) -> Outcome {
    match picture {
        Picture::Svg | Picture::Csv => out.write_all(svg.as_bytes())?,
        #[cfg(feature = "png")]
        Picture::Png => {
            if let Some((width, height)) = size
                && 4 * u64::from(width) * u64::from(height) > MOST_OF_PNG
            {
                return Err(format!(
                    "--size {width}x{height}: a PNG has twice this width and height, and must have ≤ {MOST_OF_PNG} pixels, \
                     because all of them are in memory. SVG and PDF may be larger"
                )
                .into());
            }
            let width = size.map_or(WIDTH, |(width, _)| width.saturating_mul(2));
            out.write_all(&stickslip_draw::png_of_svg(svg, width).map_err(|e| of_size(size, &e))?)?;
        }
        #[cfg(feature = "png")]
        Picture::Pdf => out.write_all(&stickslip_draw::pdf_of_svg(svg).map_err(|e| of_size(size, &e))?)?,
        #[cfg(not(feature = "png"))]
        Picture::Png | Picture::Pdf => check(picture, picture.extension())?,
    }
    Ok(())
}

/// The error of a drawing, behind its size if that was given.
fn of_size(size: Option<(u32, u32)>, error: &std::io::Error) -> String {
    match size {
        Some((width, height)) => format!("--size {width}x{height}: {error}"),
        None => error.to_string(),
    }
}
