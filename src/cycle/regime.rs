//! The steady behaviour of the body over the plane of Ω and α.
//!
//! [`Regime`] classifies a point by comparison with the rounded border. [`Verdict`] says so where the
//! arithmetic cannot decide.

pub(crate) mod damped;
mod decision;
mod no_stop;
mod static_friction;
mod verdict;

pub use no_stop::NoStop;
use static_friction::leads_from_every_start;
#[cfg(feature = "mp")]
pub(crate) use static_friction::sliding_bound;
pub use verdict::{Family, Verdict};

use crate::cycle::six_reversals;
use crate::float::Float;
use crate::machine::ratios::Ratios;
use crate::named::named;

named! {
    /// The steady behaviour of the body.
    ///
    /// With a static friction above the kinetic one it can depend on the start, and a name is given only where every
    /// start leads to this behaviour; elsewhere it is [`Regime::DependsOnStart`] (`src/cycle/regime/static_friction.rs` has
    /// the proofs). The regime of one motion from one start is that of the motion.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
    #[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
    pub enum Regime [name] {
        /// α ≤ 1: the force cannot overcome friction permanently, and the body ends at rest.
        Stuck = "stuck",
        /// α > 1 and no motion without a stop: the body stops for some time in every cycle. With η > 1 it stops
        /// again and again, α > η, and the motion itself depends on the start.
        Sticking = "sticking",
        /// The body never stops for longer than an instant: either α ≥ α_min(Ω), where it reverses twice a cycle,
        /// or α lies within the force ratios of six reversals a cycle near a pole 1/(2n+1)
        /// ([`crate::cycle::SixReversals`]). With η > 1 only above
        /// [`NoStop::every_start`].
        NonSticking = "non-sticking",
        /// Ω = 1 and α > 4/π, or with η > 1 α > 4η/π: the body never stops in the long run and its displacement grows
        /// without bound.
        Unbounded = "unbounded",
        /// η > 1, α > 1 and none of the others for every start. For α ≤ η a body at rest within |x| ≤ η − α stays at
        /// rest. Where a motion without a stop exists ([`crate::Response::reversals_per_cycle`]) it is the limit of its neighbourhood; elsewhere all motions
        /// end at rest or stop again and again.
        DependsOnStart = "depends-on-start",
    }
}

impl Regime {
    /// All regimes, in the order of their numbers in lists and codes.
    pub const ALL: [Self; 5] =
        [Self::Stuck, Self::Sticking, Self::NonSticking, Self::Unbounded, Self::DependsOnStart];
}

/// The regime at these ratios, where the border of the two-reversal cycle is `least`.
#[inline(always)]
pub(crate) fn regime_of<F: Float>(ratios: Ratios<F>, least: F) -> Regime {
    let alpha = ratios.alpha();
    if alpha <= F::int(1) {
        Regime::Stuck
    } else if alpha >= least || six_reversals::is_within(&ratios) {
        regime_of_sliding(&ratios)
    } else if ratios.moves_from_rest() {
        Regime::Sticking
    } else {
        Regime::DependsOnStart
    }
}

/// The regime at ratios where a motion without a stop exists.
#[inline(always)]
fn regime_of_sliding<F: Float>(ratios: &Ratios<F>) -> Regime {
    if !leads_from_every_start(ratios) {
        Regime::DependsOnStart
    } else if ratios.is_at_resonance() {
        Regime::Unbounded
    } else {
        Regime::NonSticking
    }
}

/// Whether the two-reversal cycle exists at (Ω, α), where its border is `least`.
#[inline]
pub(crate) fn has_two_reversals<F: Float>(omega: F, alpha: F, least: F) -> bool {
    alpha >= least && omega != F::int(1)
}

/// The regime at (Ω, α).
#[cfg(test)]
pub(crate) fn regime<F: Float>(omega: F, alpha: F) -> Result<Regime, crate::Error> {
    Ok(crate::Response::new(Ratios::new(omega, alpha)?).regime)
}

#[cfg(test)]
mod tests {
    use super::{Regime, regime};
    use crate::Border;

    #[test]
    fn the_border_belongs_to_what_slides() {
        for omega in [0.22, 0.4, 0.7, 1.5] {
            let least: f64 = Border::new(omega).unwrap().min_force_ratio;
            assert_eq!(regime(omega, least), Ok(Regime::NonSticking));
            assert_eq!(regime(omega, least.next_down()), Ok(Regime::Sticking));
        }
        assert_eq!((regime(0.7, 1.0f64), regime(1.0, 1.3f64)), (Ok(Regime::Stuck), Ok(Regime::Unbounded)));
    }

    /// Stops and velocity zeros per cycle of the exact motion for increasing α, at Ω = 0.331 and 0.336.
    #[test]
    fn beside_a_pole_there_is_a_second_region_without_stops() {
        for (omega, alpha, expected) in [
            (0.331, 53.5, Regime::Sticking),
            (0.331, 61.6, Regime::NonSticking),
            (0.331, 155.0, Regime::NonSticking),
            (0.331, 157.5, Regime::Sticking),
            (0.331, 179.0, Regime::Sticking),
            (0.331, 180.0, Regime::NonSticking),
            (0.336, 100.0, Regime::Sticking),
            (1.0 / 3.0, 68.0, Regime::Sticking),
            (1.0 / 3.0, 69.0, Regime::NonSticking),
            (1.0 / 3.0, 1e15, Regime::NonSticking),
        ] {
            assert_eq!(regime(omega, alpha), Ok(expected), "{omega} {alpha}");
        }
    }

    #[test]
    fn names() {
        use Regime::{DependsOnStart, NonSticking, Sticking, Stuck, Unbounded};
        let all = [Stuck, Sticking, NonSticking, Unbounded, DependsOnStart];
        let names = ["stuck", "sticking", "non-sticking", "unbounded", "depends-on-start"];
        assert_eq!(all.map(Regime::name), names);
        assert_eq!(format!("{:>9}", Regime::Sticking), " sticking");
    }
}
