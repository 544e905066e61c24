//! The line on which the symmetric motion is lost, in a picture of the limits.

use super::points::{Map, Mapped};
use crate::failure::Failure;
use crate::{input, interrupt, progress};
use stickslip::motion::{Loss, SymmetryBreak, symmetry_breaks};
use stickslip::{Error, Ratios};
use stickslip_front::inputs::Role;

/// The points at which a stable symmetric motion is lost, and the number of columns where the search failed.
#[derive(Default)]
pub(super) struct Breaks {
    pub(super) by_multiplier: Vec<(f64, f64)>,
    pub(super) others: Vec<(f64, f64)>,
    pub(super) missing: usize,
}

impl Map<'_> {
    /// The points at which a stable symmetric motion is lost, by a multiplier of −1 or otherwise, for a
    /// picture of the limits whose vertical axis is the force.
    pub(super) fn breaks(&self) -> Result<Breaks, Failure> {
        let up = self.up.0;
        let (low, high) = self.up.1.ends();
        if !matches!(self.quantity.mapped, Mapped::Limits) || up.role() != Role::Drive || low < 0.0 {
            return Ok(Breaks::default());
        }
        let (across, upwards) = (self.on_axis(self.across.0).1, self.on_axis(up).1);
        let columns = (4 * self.across.1.len()).min(MOST_COLUMNS);
        let steps = u32::try_from(2 * self.up.1.len()).unwrap_or(u32::MAX).min(MOST_STEPS);
        let mut found = Breaks::default();
        progress::in_order(
            0..columns + 1,
            |place| {
                interrupt::check()?;
                let x = self.across.1.at(place as f64 / columns as f64);
                let mut given = self.axes.given_at(0);
                given.set(self.across.0, x);
                given.set(up, high);
                let ratios = input::point(&given)?.ratios;
                Ok((x, breaks(ratios, low / high, steps)?))
            },
            |(x, column)| {
                let Some([multiplier, other]) = column else {
                    found.missing += 1;
                    return Ok(());
                };
                let place = |share: f64| (x * across, share * high * upwards);
                found.by_multiplier.extend(multiplier.into_iter().map(place));
                found.others.extend(other.into_iter().map(place));
                Ok(())
            },
        )?;
        Ok(found)
    }
}

/// The fractions of the force at which a stable symmetric motion of one turn is lost: at a multiplier of −1,
/// and by a jump or a fold. `None` if the search exceeded its bound.
fn breaks(ratios: Ratios<f64>, from: f64, steps: u32) -> Result<Option<[Vec<f64>; 2]>, Failure> {
    let high = ratios.alpha();
    let low = (from * high).max(LEAST);
    // Nothing is lost with η = 1.
    if !ratios.has_higher_static_friction() || low >= high {
        return Ok(Some([Vec::new(), Vec::new()]));
    }
    let found = match symmetry_breaks(ratios, low..=high, steps) {
        // A large map is drawn without this point of the line, and a note reports the omission.
        Err(Error::SearchBound { .. }) => return Ok(None),
        found => found.map_err(|e| e.to_string())?,
    };
    let (by_multiplier, others): (Vec<_>, Vec<_>) =
        found.into_iter().partition(|one| one.loss == Loss::Multiplier);
    let shares = |breaks: Vec<SymmetryBreak<f64>>| breaks.into_iter().map(|one| one.alpha / high).collect();
    Ok(Some([by_multiplier, others].map(shares)))
}

/// A force ratio just above those at which nothing moves.
const LEAST: f64 = 1.001;

/// The greatest number of columns in which the loss of symmetry is searched, and of steps upwards.
const MOST_COLUMNS: u64 = 400;
const MOST_STEPS: u32 = 200;
