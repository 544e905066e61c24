//! `stickslip figure` and `figures`.

use crate::args::{FigureArgs, FiguresArgs};
use crate::failure::{Failure, Outcome};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use std::fs::{self, File};
use std::io::{BufWriter, Write};
use std::path::Path;
use stickslip::figures::{self, Figure};

/// What a picture file holds, by the end of its name.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Svg,
    Csv,
}

impl Kind {
    /// Of `--out FILE`.
    pub(crate) fn of(file: &Path) -> Result<Self, Failure> {
        match file.extension().and_then(|e| e.to_str()) {
            Some("svg") => Ok(Self::Svg),
            Some("csv") => Ok(Self::Csv),
            Some(_) | None => {
                let name = file.display();
                Err(Failure::Input(format!(
                    "--out {name}: the name must end in .svg (drawing) or .csv (data)"
                )))
            }
        }
    }
}

pub(crate) fn run(args: &FigureArgs, out: &mut impl Write) -> Outcome {
    let kind = args.out.as_deref().map_or(Ok(Kind::Svg), Kind::of)?;
    let figure = figures::figure(&args.name).ok_or_else(|| {
        let names = figures::NAMES.join(", ");
        Failure::Input(format!("figure {}: must be one of {names}", args.name))
    })?;
    match &args.out {
        Some(file) => save(&figure, kind, file),
        None => write(&figure, kind, out),
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
    fs::create_dir_all(folder).map_err(|e| Failure::Input(format!("--dir {}: {e}", folder.display())))?;
    figures::NAMES.into_par_iter().try_for_each(|name| match figures::figure(name) {
        Some(figure) => save(&figure, Kind::Svg, &folder.join(format!("{name}.svg"))),
        None => Ok(()),
    })?;
    Ok(writeln!(out, "{} figures in {}", figures::NAMES.len(), folder.display())?)
}

/// Writes the figure to a file.
pub(crate) fn save(figure: &Figure, kind: Kind, file: &Path) -> Outcome {
    let created = File::create(file).map_err(|e| Failure::Input(format!("--out {}: {e}", file.display())))?;
    let mut out = BufWriter::new(created);
    write(figure, kind, &mut out)?;
    Ok(out.flush()?)
}

fn write(figure: &Figure, kind: Kind, out: &mut impl Write) -> Outcome {
    match kind {
        Kind::Svg => out.write_all(figure.svg()?.as_bytes())?,
        Kind::Csv => figure.write_csv(out)?,
    }
    Ok(())
}
