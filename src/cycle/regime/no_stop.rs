//! The force ratios at which the body never stops.

use super::static_friction::every_start;
use crate::cycle::Border;
use crate::cycle::six_reversals::force_ratios;
use crate::float::{Float, at_precision};
use crate::machine::error::Error;
use crate::machine::ratios::Ratios;

/// All force ratios at one Ω for which a cycle without a stop exists, of two or of six reversals: see
/// [`no_stop_force_ratios`], and [`NoStop::of`] for a static friction above the kinetic one.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
#[must_use]
pub struct NoStop<F> {
    /// The minimum and the maximum force ratio of the six-reversal cycle, if there is one.
    pub six_reversals: Option<(F, F)>,
    /// The border of the two-reversal cycle, which exists at this force ratio and above.
    pub border: F,
    /// A force ratio from which on every start leads to a motion without a stop: with η = 1 the border. With η > 1
    /// it is a bound that suffices, `2ηq (1 + 1/πζ) √(Ω² + (1 + 2ζ)²)/Ω²`, far above the least one for small ζ away
    /// from Ω = 1, and 4η/π at Ω = 1 without a damper, where the motion grows without bound; `None` where none is
    /// known, without a damper elsewhere. `src/cycle/regime/static_friction.rs` has the proof.
    pub every_start: Option<F>,
}

impl<F: Float> NoStop<F> {
    /// The force ratios of the cycles without a stop at the Ω, ζ and η of `ratios`; their α plays no part.
    ///
    /// With η = 1 the cycle is the limit of every start, as [`no_stop_force_ratios`] says. With a static
    /// friction above the kinetic one it is the same cycle, at the force ratios for which the force at each of
    /// its reversals is at least η, and attracts its neighbourhood; other starts may lead to other motions.
    ///
    /// The accuracy is that of [`no_stop_force_ratios`].
    pub fn of(ratios: &Ratios<F>) -> Self {
        at_precision!(guarded, <'a, F>(ratios: &'a Ratios<F>) -> NoStop<F>, |there, back: G| {
            let ratios = ratios.map(&there);
            let border = back(Border::of(&ratios).min_force_ratio);
            let has_one_friction = !ratios.has_higher_static_friction();
            NoStop {
                six_reversals: force_ratios(&ratios).map(|(low, high)| (back(low), back(high))),
                border,
                every_start: if has_one_friction { Some(border) } else { every_start(&ratios).map(&back) },
            }
        })
    }

    /// The minimum force ratio without a stop.
    pub fn min(&self) -> F {
        self.six_reversals.map_or(self.border, |(low, _)| low)
    }

    /// These force ratios in another unit.
    pub(crate) fn map(self, to: impl Fn(F) -> F) -> Self {
        Self {
            six_reversals: self.six_reversals.map(|(low, high)| (to(low), to(high))),
            border: to(self.border),
            every_start: self.every_start.map(&to),
        }
    }

    /// The intervals (least, greatest) by increasing force ratio, with their ends included; the last has no
    /// greatest value.
    pub fn intervals(&self) -> impl Iterator<Item = (F, Option<F>)> {
        let below = self.six_reversals.map(|(low, high)| (low, Some(high)));
        below.into_iter().chain([(self.border, None)])
    }
}

/// The force ratios for which a body of the damping ratio ζ never stops at Ω, as intervals with their ends.
///
/// They begin at the border of the two-reversal cycle. Near the poles 1/(2n+1) there is also an interval
/// below it, of six reversals a cycle ([`crate::cycle::SixReversals`]). At Ω = 1 without damping, the
/// motion at and above the border is unbounded and does not stop either. A little damping preserves some of
/// the intervals below the border; from ζ = 0.0215/(2n+1) on there is none.
///
/// **Proved:** in these intervals no motion stops in the long run. **Searched:** the body stops at all other
/// α > 1; no motion of ten reversals or more without a stop was found, nor one of six elsewhere
/// (`docs/development/theory/six-reversals.md`).
///
/// ```
/// use stickslip::no_stop_force_ratios;
/// let found = no_stop_force_ratios(0.331f64, 0.0)?;
/// let (low, high) = found.six_reversals.unwrap();
/// assert!((low - 53.67330651204315).abs() < 1e-12 && (high - 155.36188887727886).abs() < 1e-11);
/// assert!((found.border - 179.87627993590212).abs() < 1e-11);
/// assert_eq!(no_stop_force_ratios(0.4f64, 0.0)?.intervals().count(), 1);
/// let (low, high) = no_stop_force_ratios(0.331f64, 0.001)?.six_reversals.unwrap();
/// assert!((low - 56.24322231107378).abs() < 1e-11 && (high - 147.55834811749975).abs() < 1e-10);
/// assert_eq!(no_stop_force_ratios(0.331f64, 0.01)?.intervals().count(), 1);
/// # Ok::<(), stickslip::Error>(())
/// ```
///
/// The accuracy is that of [`Border::min_force_ratio`], and 64 ulp for six reversals; the
/// computation uses the type's guard bits.
///
/// # Errors
/// Where Ω or ζ is outside the domain of [`crate::Ratios`].
pub fn no_stop_force_ratios<F: Float>(omega: F, damping_ratio: F) -> Result<NoStop<F>, Error> {
    Ok(NoStop::of(&Ratios::of_machine(omega, damping_ratio)?))
}

#[cfg(test)]
mod tests {
    use super::no_stop_force_ratios;

    #[test]
    fn away_from_the_poles_it_is_the_border_alone() {
        for omega in [0.01f64, 0.22, 0.3, 0.336, 0.3295, 0.4, 0.5, 0.7, 1.0, 3.0] {
            let found = no_stop_force_ratios(omega, 0.0).unwrap();
            let intervals: Vec<_> = found.intervals().collect();
            assert_eq!(intervals, [(found.border, None)], "{omega}");
            assert_eq!(found.min(), found.border);
        }
    }

    #[test]
    fn beside_every_pole_there_is_an_interval_below_the_border() {
        for n in 1..40 {
            for off in [-0.019, -1e-3, -1e-9, 1e-13, 1e-6, 0.01, 0.024, 0.031] {
                if n == 1 && off == -0.019 {
                    continue;
                }
                let found = no_stop_force_ratios(1.0 / (f64::from(2 * n + 1) + off), 0.0).unwrap();
                let (low, high) = found.six_reversals.unwrap();
                assert!(low < high && high < found.border && found.min() == low, "{n} {off}: {found:?}");
            }
        }
    }
}
