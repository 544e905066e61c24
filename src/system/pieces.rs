//! The straight pieces of a law.

use super::error::Error;
use super::given::{at_least, finite};
use super::model::Law;
use crate::float::Float;
use crate::machine::error::written;
use alloc::format;
use alloc::string::ToString;
use alloc::vec::Vec;

/// A straight piece of a law: `r = force + slope (w − from)` from the speed `from` on.
#[derive(Debug, Clone)]
pub(crate) struct Piece<F> {
    pub(crate) from: F,
    pub(crate) force: F,
    pub(crate) slope: F,
}

/// The straight pieces of a law.
pub(super) fn pieces<F: Float>(name: &str, law: &Law<F>) -> Result<Vec<Piece<F>>, Error> {
    let zero = F::int(0);
    let Some(&(first, _)) = law.points.first() else {
        return Err(Error::Length { name: format!("{name}: law"), found: 0, expected: 1 });
    };
    if first != zero {
        return Err(Error::Unsupported {
            name: format!("{name}: law"),
            condition: "must begin at the speed 0",
        });
    }
    for &(speed, force) in &law.points {
        finite(&format!("{name}: speed of the law"), speed)?;
        at_least(&format!("{name}: friction"), force, zero)?;
    }
    let mut pieces = straight_pieces(
        &format!("{name}: speeds of the law"),
        &format!("{name}: slope of the law"),
        &law.points,
    )?;
    match pieces.last() {
        None => {
            let force = law.points.first().map_or(zero, |p| p.1);
            pieces.push(Piece { from: zero, force, slope: zero });
        }
        Some(last) if last.slope < zero => {
            let from = last.from - last.force / last.slope;
            pieces.push(Piece { from, force: zero, slope: zero });
        }
        Some(_) => {}
    }
    Ok(pieces)
}

/// The straight pieces between points whose first numbers increase: with the names of these numbers and of the slopes for errors.
pub(super) fn straight_pieces<F: Float>(
    places: &str,
    slopes: &str,
    points: &[(F, F)],
) -> Result<Vec<Piece<F>>, Error> {
    let pairs = points.iter().zip(points.iter().skip(1));
    let piece = |(&(from, force), &(to, next)): (&(F, F), &(F, F))| {
        if to <= from {
            return Err(Error::NotIncreasing {
                name: places.to_string(),
                value: written(from),
                next: written(to),
            });
        }
        Ok(Piece { from, force, slope: finite(slopes, (next - force) / (to - from))? })
    };
    pairs.map(piece).collect()
}
