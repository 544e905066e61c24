//! The force ratios at which the body never stops.

use crate::error::Error;
use crate::float::{AtPrecision, Float};
use crate::nonsticking::Border;
use crate::nonsticking::six_reversals::{self, damped};
use crate::phase_function::PhaseFunction;
use crate::ratios::Ratios;

/// All force ratios at one Ω for which the body never stops and reverses twice or six times a cycle: see
/// [`no_stop_force_ratios`].
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
#[must_use]
pub struct NoStop<F> {
    /// The minimum and the maximum force ratio of the six-reversal cycle, if there is one.
    pub six_reversals: Option<(F, F)>,
    /// The border of the two-reversal cycle: at this force ratio and above, the body never stops.
    pub border: F,
}

impl<F: Float> NoStop<F> {
    /// The minimum force ratio without a stop.
    pub fn min(&self) -> F {
        self.six_reversals.map_or(self.border, |(low, _)| low)
    }

    /// The same in another unit.
    pub(crate) fn map(self, to: impl Fn(F) -> F) -> Self {
        Self {
            six_reversals: self.six_reversals.map(|(low, high)| (to(low), to(high))),
            border: to(self.border),
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
/// below it, of six reversals a cycle ([`crate::nonsticking::SixReversals`]). At Ω = 1 without damping, the
/// motion at and above the border is unbounded and does not stop either. A little damping preserves some of
/// the intervals below the border; from ζ = 0.0215/(2n+1) on there is none.
///
/// **Proved:** in these intervals no motion stops in the long run. **Searched:** the body stops at all other
/// α > 1; no motion of ten reversals or more without a stop was found, nor one of six elsewhere
/// (`docs/theory/six-reversals.md`).
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
/// The accuracy is that of [`Border::min_force_ratio`], and 40 ulp for six reversals; without damping the
/// computation uses the type's guard bits.
///
/// # Errors
/// Where Ω or ζ is outside the domain of [`crate::Ratios`].
pub fn no_stop_force_ratios<F: Float>(omega: F, damping_ratio: F) -> Result<NoStop<F>, Error> {
    let ratios = Ratios::new(omega, F::int(1))?.with_damping_ratio(damping_ratio)?;
    if ratios.is_damped() {
        return Ok(NoStop {
            six_reversals: damped::force_ratios(omega, damping_ratio),
            border: Border::of(&ratios).min_force_ratio,
        });
    }
    without_damping(omega)
}

/// The same at ζ = 0.
fn without_damping<F: Float>(omega: F) -> Result<NoStop<F>, Error> {
    struct Task<F>(F);

    impl<F: Float> AtPrecision<F> for Task<F> {
        type Output = Result<NoStop<F>, Error>;

        fn run<G: Float>(self, there: impl Fn(F) -> G, back: impl Fn(G) -> F) -> Self::Output {
            let p = PhaseFunction::new(there(self.0))?;
            Ok(NoStop {
                six_reversals: six_reversals::force_ratios_at(&p).map(|(low, high)| (back(low), back(high))),
                border: back(Border::at(&p).min_force_ratio),
            })
        }
    }

    F::guarded(Task(omega))
}

/// The force ratios without a stop at the Ω and ζ of these ratios, for a static friction equal to the kinetic
/// one.
pub(crate) fn no_stop_of<F: Float>(ratios: &Ratios<F>) -> Result<NoStop<F>, Error> {
    no_stop_force_ratios(ratios.omega(), ratios.damping_ratio())
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
