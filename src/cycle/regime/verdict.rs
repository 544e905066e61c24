//! The verdict on the regime at a point of the plane.

use super::Regime;
use crate::cycle::phase_function::one_minus_square;
use crate::float::Float;
use crate::machine::ratios::Ratios;

/// The steady behaviour of the body, as far as the arithmetic can decide.
///
/// **Undecided.** The border is known to 8 units in the last place, with a damper to 16: these are bounds of its error
/// ([`Verdict::BORDER_ERROR`], [`Verdict::DAMPED_BORDER_ERROR`]). If α is closer to the border, the verdict is [`Verdict::Undecided`], and a
/// wider number type decides. [`Verdict::new`] takes Ω and α as exact. [`Verdict::of`] and
/// [`crate::uncertainty::ParameterBox`] take them as intervals: their verdict holds for every Ω and α in these,
/// over which the range of the border is known. Near a pole 1/(2n+1) that matters more than rounding: an
/// error of 1e-16 in Ω at a distance of 1e-10 from the pole is an error of 1e-6 in the border.
///
/// ```
/// use stickslip::uncertainty::{Interval, ParameterBox};
/// use stickslip::{Border, Ratios, Regime, Verdict};
/// assert_eq!(Verdict::new(Ratios::new(0.4, 6.0)?), Verdict::Sticking);
/// // On the border itself f64 cannot decide.
/// let border: f64 = Border::new(0.4)?.min_force_ratio;
/// assert_eq!(Verdict::new(Ratios::new(0.4, border)?), Verdict::Undecided(Regime::Sticking, Regime::NonSticking));
/// // Friction known to ±20 %: α between 6/1.2 and 6/0.8 is undecided; with twice the force it is decided.
/// let (omega, damping_ratio) = (Interval::exactly(0.4), Interval::exactly(0.0));
/// let verdict = |low, high| {
///     ParameterBox::Ratios { omega, alpha: Interval { low, high }, damping_ratio }.verdict()
/// };
/// assert_eq!(verdict(6.0 / 1.2, 6.0 / 0.8)?.regime(), None);
/// assert_eq!(verdict(12.0 / 1.2, 12.0 / 0.8)?, Verdict::NonSticking);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
#[non_exhaustive]
#[must_use]
pub enum Verdict<F> {
    /// α ≤ 1: the body ends at rest.
    AtRest,
    /// α > 1, below the border of the two-reversal cycle and outside the force ratios of six reversals: the
    /// body stops for some time in every cycle, or with η > 1, where α > η, again and again. That no motion with more reversals avoids a stop was
    /// searched, not proved.
    Sticking,
    /// α ≥ α_min(Ω): the body never stops for longer than an instant, reverses twice a cycle, and settles on
    /// one symmetric cycle.
    NonSticking,
    /// Near a pole 1/(2n+1), below the border: the body never stops, reverses six times a cycle, and settles
    /// on one symmetric cycle ([`crate::cycle::SixReversals`]).
    SixReversals,
    /// α ≥ α_min(Ω) at Ω = 1/(2n) exactly: the body settles on a member of a family of cycles that depends on
    /// the start.
    Degenerate(Family<F>),
    /// Ω = 1 and α > 4/π: the body never stops, and its displacement grows without bound.
    Unbounded,
    /// The static friction is above the kinetic one, and no behaviour is that of every start
    /// ([`Regime::DependsOnStart`]).
    DependsOnStart,
    /// One of these two regimes: the point is closer to the border between them than the arithmetic or the
    /// input can resolve.
    Undecided(Regime, Regime),
}

impl<F: Float> Verdict<F> {
    /// The regime, where it is decided.
    #[must_use]
    pub const fn regime(&self) -> Option<Regime> {
        match self {
            Self::AtRest => Some(Regime::Stuck),
            Self::Sticking => Some(Regime::Sticking),
            Self::NonSticking | Self::SixReversals | Self::Degenerate(_) => Some(Regime::NonSticking),
            Self::Unbounded => Some(Regime::Unbounded),
            Self::DependsOnStart => Some(Regime::DependsOnStart),
            Self::Undecided(..) => None,
        }
    }

    /// Whether the body sticks (ends at rest, or stops in every cycle) at every point that the verdict
    /// covers, or at none. `None` if the points differ, or if the verdict is undecided.
    #[must_use]
    pub const fn sticks(&self) -> Option<bool> {
        match self {
            Self::AtRest | Self::Sticking | Self::Undecided(Regime::Stuck, Regime::Sticking) => Some(true),
            Self::NonSticking
            | Self::SixReversals
            | Self::Degenerate(_)
            | Self::Unbounded
            | Self::Undecided(Regime::NonSticking, Regime::Unbounded) => Some(false),
            Self::DependsOnStart | Self::Undecided(..) => None,
        }
    }

    #[must_use]
    const fn name(&self) -> &'static str {
        match self {
            Self::AtRest => "at rest",
            Self::Sticking => "sticking",
            Self::NonSticking => "non-sticking",
            Self::SixReversals => "non-sticking, six reversals",
            Self::Degenerate(_) => "degenerate",
            Self::Unbounded => "unbounded",
            Self::DependsOnStart => "depends on the start",
            Self::Undecided(..) => "undecided",
        }
    }
}

/// Displays a name of a few words.
impl<F: Float> core::fmt::Display for Verdict<F> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.pad(self.name())
    }
}

/// The non-sticking cycles at Ω = 1/(2n): one for each shift c of the middle of the motion.
///
/// There a half cycle is a whole number of natural periods. A falling half from x = A + c, A = α/(1 − Ω²), is
/// `x = A cos τ + 1 + (c − 1) cos(τ/Ω)`, which reaches −A + c after τ = π for any c; the rising half is its
/// mirror image with −c. The body slides throughout where `A sin τ > (1 − c) sin(τ/Ω)/Ω` on (0, π). Since
/// `|sin(τ/Ω)/sin τ| ≤ 1/Ω` with equality at the ends, the family is complete:
///
/// ```text
/// extrema ±α/(1 − Ω²) + c,   |c| ≤ αΩ²/(1 − Ω²) − 1 = α/α_min − 1.
/// ```
///
/// Units of B = r_y/k. The symmetric cycle of eq. 40–49 is c = 0.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
#[must_use]
pub struct Family<F> {
    /// Half the stroke, α/(1 − Ω²) in units of B, the same for all: Δ₀/B of the symmetric cycle.
    pub max_displacement: F,
    /// The greatest |c|, in units of B.
    pub max_shift: F,
}

impl<F: Float> Family<F> {
    /// The family at Ω = 1/(2n) and α ≥ α_min = 1/Ω² − 1.
    pub(super) fn at(ratios: Ratios<F>, least: F) -> Self {
        Self {
            max_displacement: ratios.alpha() / one_minus_square(ratios.omega()),
            max_shift: (ratios.alpha() - least) / least,
        }
    }

    /// Maximum and minimum displacement (units of B) of the cycle shifted by c; `None` where it would stick.
    pub fn extremes(&self, shift: F) -> Option<(F, F)> {
        let exists = shift.abs() <= self.max_shift;
        exists.then(|| (self.max_displacement + shift, shift - self.max_displacement))
    }
}

#[cfg(test)]
mod tests {
    use super::{Family, Verdict};
    use crate::{Ratios, Regime};

    #[test]
    fn the_family_slides_up_to_its_max_shift_and_no_further() {
        for (omega, alpha) in [(0.5, 4.0), (0.25, 17.0), (0.125, 100.0), (1.0 / 64.0, 4096.0)] {
            let ratios = Ratios::new(omega, alpha).unwrap();
            let family = Family::at(ratios, 1.0 / (omega * omega) - 1.0);
            let (a, c) = (family.max_displacement, family.max_shift);
            // The velocity of the falling half must have the sign of sliding over the half cycle, for both
            // shifts.
            let slides = |shift: f64| {
                (1..20_000).all(|i| {
                    let tau = std::f64::consts::PI * f64::from(i) / 20_000.0;
                    let swing = (tau / omega).sin() / omega;
                    a * tau.sin() > (1.0 - shift) * swing && a * tau.sin() > (1.0 + shift) * swing
                })
            };
            assert!(slides(0.0) && slides(c * 0.999) && slides(-c * 0.999), "{omega} {alpha}");
            assert!(!slides(c + 1e-3 * (1.0 + c)) && !slides(-c - 1e-3 * (1.0 + c)), "{omega} {alpha}");
            assert_eq!(family.extremes(c), Some((a + c, c - a)));
            assert_eq!(family.extremes(-c * 1.001), None);
        }
    }

    #[test]
    fn names_and_regimes() {
        let family = Family::at(Ratios::new(0.5, 4.0).unwrap(), 3.0);
        for (verdict, name, regime) in [
            (Verdict::AtRest, "at rest", Some(Regime::Stuck)),
            (Verdict::Sticking, "sticking", Some(Regime::Sticking)),
            (Verdict::NonSticking, "non-sticking", Some(Regime::NonSticking)),
            (Verdict::SixReversals, "non-sticking, six reversals", Some(Regime::NonSticking)),
            (Verdict::Degenerate(family), "degenerate", Some(Regime::NonSticking)),
            (Verdict::Unbounded, "unbounded", Some(Regime::Unbounded)),
            (Verdict::DependsOnStart, "depends on the start", Some(Regime::DependsOnStart)),
            (Verdict::Undecided(Regime::Sticking, Regime::NonSticking), "undecided", None),
        ] {
            assert_eq!((verdict.to_string(), verdict.regime()), (name.to_owned(), regime));
        }
    }
}
