//! `stickslip map`.

mod limits;
mod picture;
mod points;
mod resonance;
mod symmetry;

use crate::args::MapArgs;
use crate::failure::Outcome;
use crate::figure::Target;

use std::io::Write;

pub(crate) use picture::{capital, ends};
use points::Map;
pub(crate) use points::margin;

pub(crate) fn run(args: &MapArgs, out: &mut impl Write) -> Outcome {
    let target = Target::new("--out", args.out.as_deref(), args.overwrite, &args.look)?;
    let map = Map::new(args)?;
    target.fill(out, |mut out| map.table(&args.quantity, &mut out), || map.picture())
}

/// The number of points of the border, more than a picture can show.
const BORDER_POINTS: u32 = 1000;
