//! `stickslip figure` and `figures`.

use crate::args::{FigureArgs, FiguresArgs, LookArgs, Picture};
use crate::failure::{Failure, Outcome};
use crate::output::{self, PendingFile};
use clap::ValueEnum;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use std::fs;
use std::io::Write;
use std::path::Path;
use stickslip_figures::{self as figures, Figure};

/// The width of a PNG in pixels.
#[cfg(feature = "png")]
const WIDTH: u32 = 1600;

pub(crate) fn run(args: &FigureArgs, out: &mut impl Write) -> Outcome {
    let picture = args.out.as_deref().map_or(Ok(Picture::Svg), picture_of)?;
    let figure = figures::figure(&args.name).ok_or_else(|| {
        let names = figures::NAMES.join(", ");
        Failure::Input(format!("figure {}: must be one of {names}", args.name))
    })?;
    match &args.out {
        Some(file) => beside(file, args.overwrite)?.fill(|out| write(&figure, picture, out)),
        None => write(&figure, picture, out),
    }
}

pub(crate) fn run_all(args: &FiguresArgs, out: &mut impl Write) -> Outcome {
    if !args.all {
        for name in figures::NAMES {
            writeln!(out, "{name}")?;
        }
        return Ok(());
    }
    let folder = &args.dir;
    check(args.format, "--format png")?;
    fs::create_dir_all(folder).map_err(|e| Failure::Input(format!("--dir {}: {e}", folder.display())))?;
    let extension = args.format.extension();
    let place = |name: &str| folder.join(format!("{name}.{extension}"));
    // Either all files are written or none.
    figures::NAMES.iter().try_for_each(|name| {
        let place = place(name);
        output::refuse_existing(&place, &place.display().to_string(), args.overwrite)
    })?;
    figures::NAMES.into_par_iter().try_for_each(|name| match figures::figure(name) {
        Some(figure) => beside(&place(name), args.overwrite)?.fill(|out| write(&figure, args.format, out)),
        None => Ok(()),
    })?;
    Ok(writeln!(out, "{} figures in {}", figures::NAMES.len(), folder.display())?)
}

impl LookArgs {
    /// Fails where a look was asked for without the option of a picture.
    pub(crate) fn needs(&self, option: &str, picture: Option<&Path>) -> Outcome {
        let refused = |look: &str| Err(Failure::Input(format!("{look}: needs a picture, {option} FILE.svg")));
        match (picture, &self.title, &self.size) {
            (None, Some(_), _) => refused("--title"),
            (None, None, Some(_)) => refused("--size"),
            _ => Ok(()),
        }
    }

    /// The figure with the title of this look.
    pub(crate) fn titled(&self, figure: Figure) -> Figure {
        Figure { title: self.title.clone().unwrap_or(figure.title), ..figure }
    }

    /// Writes a figure with this look.
    pub(crate) fn write(&self, figure: Figure, picture: Picture, out: &mut impl Write) -> Outcome {
        write_sized(&self.titled(figure), picture, self.size()?, out)
    }

    /// The width and the height in pixels.
    pub(crate) fn size(&self) -> Result<Option<(u32, u32)>, Failure> {
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

/// The content of `--out FILE`, by the extension of its name.
pub(crate) fn picture_of(file: &Path) -> Result<Picture, Failure> {
    let name = file.display();
    let known = Picture::value_variants().iter().copied();
    let end = file.extension().and_then(|e| e.to_str());
    let picture = known.into_iter().find(|picture| end == Some(picture.extension())).ok_or_else(|| {
        Failure::Input(format!("--out {name}: the name must end in .svg or .png (drawing) or .csv (data)"))
    })?;
    check(picture, &format!("--out {name}"))?;
    Ok(picture)
}

/// A drawing, by the extension of the file's name.
pub(crate) fn drawing(file: &Path, option: &str) -> Result<Picture, Failure> {
    let name = file.display();
    let end = file.extension().and_then(|e| e.to_str());
    let picture = [Picture::Svg, Picture::Png].into_iter().find(|picture| end == Some(picture.extension()));
    let picture = picture
        .ok_or_else(|| Failure::Input(format!("{option} {name}: the name must end in .svg or .png")))?;
    check(picture, &format!("{option} {name}"))?;
    Ok(picture)
}

/// Fails for a PNG if the build does not support it.
fn check(picture: Picture, argument: &str) -> Outcome {
    if picture != Picture::Png || cfg!(feature = "png") {
        return Ok(());
    }
    Err(Failure::Input(format!(
        "{argument}: needs a build with the feature png, or a converter of .svg such as rsvg-convert"
    )))
}

/// The destination of rows or of a picture, which is known before the work begins.
pub(crate) struct Target<'a> {
    file: Option<&'a Path>,
    picture: Picture,
    overwrite: bool,
    /// The width and the height of a picture in pixels.
    size: Option<(u32, u32)>,
}

impl<'a> Target<'a> {
    /// Rows on standard output without a file; otherwise the extension of its name decides.
    pub(crate) fn new(file: Option<&'a Path>, overwrite: bool) -> Result<Self, Failure> {
        let picture = file.map_or(Ok(Picture::Csv), picture_of)?;
        if let Some(file) = file {
            output::refuse_existing(file, &format!("--out {}", file.display()), overwrite)?;
        }
        Ok(Self { file, picture, overwrite, size: None })
    }

    /// The same with a picture of a given size.
    pub(crate) fn sized(self, size: Option<(u32, u32)>) -> Self {
        Self { size, ..self }
    }

    /// Writes the rows, or draws the picture.
    pub(crate) fn fill(
        &self,
        out: &mut impl Write,
        rows: impl FnOnce(&mut dyn Write) -> Outcome,
        drawn: impl FnOnce() -> Result<Figure, Failure>,
    ) -> Outcome {
        let Some(file) = self.file else { return rows(out) };
        beside(file, self.overwrite)?.fill(|out| match self.picture {
            Picture::Csv => rows(out),
            Picture::Svg | Picture::Png => write_sized(&drawn()?, self.picture, self.size, out),
        })
    }
}

/// The temporary file for `--out FILE`, opened before drawing.
pub(crate) fn beside(file: &Path, overwrite: bool) -> Result<PendingFile, Failure> {
    PendingFile::create(file, &format!("--out {}", file.display()), overwrite)
}

pub(crate) fn write(figure: &Figure, picture: Picture, out: &mut impl Write) -> Outcome {
    write_sized(figure, picture, None, out)
}

/// The same with a width and a height in pixels.
fn write_sized(figure: &Figure, picture: Picture, size: Option<(u32, u32)>, out: &mut impl Write) -> Outcome {
    let svg = || size.map_or_else(|| figure.svg(), |size| figure.svg_of_size(size));
    match picture {
        Picture::Svg => {
            let text = svg().map_err(|e| Failure::Input(format!("--size: {e}")))?;
            out.write_all(text.as_bytes())?;
        }
        #[cfg(feature = "png")]
        Picture::Png => {
            let image = size.map_or_else(|| figure.png(WIDTH), |size| figure.png_of_size(size));
            out.write_all(&image.map_err(|e| Failure::Input(format!("--size: {e}")))?)?;
        }
        #[cfg(not(feature = "png"))]
        Picture::Png => check(picture, "png")?,
        Picture::Csv => figure.write_csv(out)?,
    }
    Ok(())
}
