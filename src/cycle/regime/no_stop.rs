//! The force ratios at which the body never stops.

use super::static_friction::every_start;
use crate::cycle::Border;
use crate::cycle::six_reversals::force_ratios;
use crate::float::{Float, at_precision};
use crate::machine::ratios::Ratios;

/// All force ratios at one Ω for which a cycle without a stop exists, of two or of six reversals
/// ([`NoStop::of`]).
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
    /// The force ratios at the Ω, ζ and η of `ratios` for which the body never stops, as intervals with their ends; their
    /// α plays no part.
    ///
    /// They begin at the border of the two-reversal cycle. Near the poles 1/(2n+1) there is also an interval
    /// below it, of six reversals a cycle ([`crate::cycle::SixReversals`]). At Ω = 1 without damping, the
    /// motion at and above the border is unbounded and does not stop either. A little damping preserves some of
    /// the intervals below the border; from ζ = 0.0215/(2n+1) on there is none.
    ///
    /// **Proved** for η = 1: in these intervals no motion stops in the long run. **Searched:** the body stops at all other
    /// α > 1; no motion of ten reversals or more without a stop was found, nor one of six elsewhere
    /// (`docs/development/theory/six-reversals.md`). With a static friction above the kinetic one it is the same cycle, at
    /// the force ratios for which the force at each of its reversals is at least η, and attracts its neighbourhood; other
    /// starts may lead to other motions.
    ///
    /// The accuracy is that of [`Border::min_force_ratio`], and 64 ulp for six reversals; the
    /// computation uses the type's guard bits.
    ///
    /// ```
    /// use stickslip::{NoStop, Ratios};
    /// let at = |omega: f64, zeta| Ok::<_, stickslip::Error>(NoStop::of(&Ratios::new(omega, 1.0)?.with_damping_ratio(zeta)?));
    /// let found = at(0.331, 0.0)?;
    /// let (low, high) = found.six_reversals.unwrap();
    /// assert!((low - 53.67330651204315).abs() < 1e-12 && (high - 155.36188887727886).abs() < 1e-11);
    /// assert!((found.border - 179.87627993590212).abs() < 1e-11);
    /// assert_eq!(at(0.4, 0.0)?.intervals().count(), 1);
    /// let (low, high) = at(0.331, 0.001)?.six_reversals.unwrap();
    /// assert!((low - 56.24322231107378).abs() < 1e-11 && (high - 147.55834811749975).abs() < 1e-10);
    /// assert_eq!(at(0.331, 0.01)?.intervals().count(), 1);
    /// # Ok::<(), stickslip::Error>(())
    /// ```
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

#[cfg(test)]
mod tests {
    use super::NoStop;
    use crate::Ratios;

    #[test]
    fn away_from_the_poles_it_is_the_border_alone() {
        for omega in [0.01f64, 0.22, 0.3, 0.336, 0.3295, 0.4, 0.5, 0.7, 1.0, 3.0] {
            let found = NoStop::of(&Ratios::new(omega, 1.0).unwrap());
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
                let found = NoStop::of(&Ratios::new(1.0 / (f64::from(2 * n + 1) + off), 1.0).unwrap());
                let (low, high) = found.six_reversals.unwrap();
                assert!(low < high && high < found.border && found.min() == low, "{n} {off}: {found:?}");
            }
        }
    }
}
