//! The columns beside resonance in a picture of a map, and the line on which the motion is unbounded.

use super::BORDER_POINTS;
use super::points::{Map, Mapped};
use crate::failure::Failure;
use crate::input;
use stickslip::{Regime, Response};
use stickslip_front::inputs::{Given, Input, Point, Role};

/// The narrowest column beside resonance, as a part of the axis: a pixel.
const COLUMN: f64 = 1.0 / 640.0;

impl Map<'_> {
    /// The values across, with columns added at resonance, and whether each was requested.
    ///
    /// One column is added at Ω = 1, and others at half the distance each time on either side, down to a
    /// pixel. Without them a wide column would show the value at one frequency, and near resonance the value
    /// at no other frequency is the same.
    pub(super) fn columns(&self) -> (Vec<f64>, Vec<bool>) {
        let (low, high) = self.across.1.ends();
        let mut columns: Vec<(f64, bool)> = self.across.1.values().map(|x| (x, true)).collect();
        let one = self.natural(&self.axes.given_at(0)).ok().flatten().filter(|one| low < *one && *one < high);
        if let Some(one) = one.filter(|_| self.has_one_resonance()) {
            let logarithmic = self.across.1.is_logarithmic();
            let share = |x: f64| {
                if logarithmic { (x / one).ln() / (high / low).ln() } else { (x - one) / (high - low) }
            };
            let shares = || columns.iter().map(|column| share(column.0)).filter(|share| *share != 0.0);
            let nearest = |sign: f64| shares().map(|s| s * sign).filter(|s| *s > 0.0).fold(1.0, f64::min);
            let mut added = vec![one];
            for (sign, nearest) in [(-1.0, nearest(-1.0)), (1.0, nearest(1.0))] {
                let halved = std::iter::successors(Some(nearest / 2.0), |share| Some(share / 2.0));
                let halved = halved.take_while(|share| *share >= COLUMN);
                added.extend(halved.map(|share| self.across.1.moved(one, sign * share)));
            }
            added.retain(|x| columns.iter().all(|column| column.0 != *x));
            columns.extend(added.into_iter().map(|x| (x, false)));
            columns.sort_by(|a, b| a.0.total_cmp(&b.0));
        }
        columns.into_iter().unzip()
    }

    /// Whether resonance is at the same place in every row, and the quantity changes there.
    fn has_one_resonance(&self) -> bool {
        let is_same = !matches!(self.up.0.role(), Role::Mass | Role::Spring | Role::Frequency);
        is_same && matches!(self.quantity.mapped, Mapped::Regime | Mapped::Output)
    }

    /// The value across at which Ω = 1, if the axis is the frequency or Ω.
    fn natural(&self, given: &Given<f64>) -> Result<Option<f64>, Failure> {
        Ok(match (self.across.0, &input::point(given)?.machine) {
            (Input::Omega, _) => Some(1.0),
            (Input::Frequency, Some(machine)) if !given.has(Input::Omega) => {
                Some(machine.oscillator.natural_frequency())
            }
            _ => None,
        })
    }

    /// The line on which the motion is unbounded, with NaN where the motion is bounded.
    pub(super) fn unbounded(&self) -> Vec<(f64, f64)> {
        let scales = [self.across.0, self.up.0].map(|parameter| self.on_axis(parameter).1);
        let mut given = self.axes.given_at(0);
        let at = |i: u32| {
            let y = self.up.1.at(f64::from(i) / f64::from(BORDER_POINTS));
            given.set(self.up.0, y);
            let x = self.natural(&given).ok().flatten()?;
            given.set(self.across.0, x);
            let [x, shown] = [x * scales[0], y * scales[1]];
            Some((x, if is_unbounded(&given) { shown } else { f64::NAN }))
        };
        (0..=BORDER_POINTS).filter_map(at).collect()
    }
}

/// Whether the motion grows without bound.
pub(super) fn is_unbounded(given: &Given<f64>) -> bool {
    let at = |point: Point<f64>| Response::new(point.ratios).regime == Regime::Unbounded;
    input::point(given).is_ok_and(at)
}
