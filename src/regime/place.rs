//! The place of a point in the plane of Ω and α, and its certainty.

use super::{Family, Regime, Verdict, damped, regime_by_border};
use crate::error::{Error, Quantity, written};
use crate::float::Float;
use crate::nonsticking::Border;
use crate::nonsticking::border::{BorderRange, border_range};
use crate::nonsticking::six_reversals::{Within, within};
use crate::oscillator::{Drive, Oscillator};
use crate::phase_function::PhaseFunction;
use crate::ratios::Ratios;

/// A point of the plane: its verdict, its margin from the border, and where the velocity first touches zero
/// there.
///
/// **Undecided.** The border is known to 8 units in the last place, its error bound
/// ([`Place::BORDER_ERROR`]); if α is closer to the border, the verdict is [`Verdict::Undecided`], and a
/// wider number type decides. Ω and α are taken as exact by [`Place::new`]. [`Place::of`] and
/// [`crate::uncertainty::RatioBox`] take them as intervals: their verdict holds for every Ω and α in these,
/// over which the range of the border is known. Near a pole 1/(2n+1) that matters more than rounding: an
/// error of 1e-16 in Ω at a distance of 1e-10 from the pole is one of 1e-6 in the border.
///
/// ```
/// use stickslip::uncertainty::{Interval, RatioBox};
/// use stickslip::{Place, Ratios, Regime, Verdict};
/// let place = Place::new(Ratios::new(0.4, 6.0)?);
/// assert_eq!(place.verdict(), Verdict::Sticking);
/// assert!((place.margin() - 0.8633419_f64).abs() < 1e-7);
/// // On the border itself f64 cannot decide.
/// let border = place.border().min_force_ratio;
/// let verdict = Place::new(Ratios::new(0.4, border)?).verdict();
/// assert_eq!(verdict, Verdict::Undecided(Regime::Sticking, Regime::NonSticking));
/// // Friction known to ±20 %: α between 6/1.2 and 6/0.8 is undecided, twice the force is not.
/// let verdict = |low, high| RatioBox::new(Interval::exactly(0.4), Interval::between(low, high)?)?.verdict();
/// assert_eq!(verdict(6.0 / 1.2, 6.0 / 0.8)?.regime(), None);
/// assert_eq!(verdict(12.0 / 1.2, 12.0 / 0.8)?, Verdict::NonSticking);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub struct Place<F> {
    ratios: Ratios<F>,
    border: Border<F>,
    verdict: Verdict<F>,
}

impl<F: Float> Place<F> {
    /// Relative error bound of the computed border, in units of [`Float::epsilon`].
    ///
    /// The greatest error found against the same condition at 60 digits is 3.1, over 10⁴ frequency ratios
    /// from 1e-3 to 1e3 with those beside 1 and 1/n down to neighbouring floats. It does not grow at the
    /// poles, because π/2Ω is reduced exactly.
    #[doc(hidden)]
    pub const BORDER_ERROR: i32 = 8;

    /// The same with damping, where the sum of three terms takes the place of one. The greatest error found
    /// against the same condition at 256 bits is 8.
    #[doc(hidden)]
    pub const DAMPED_BORDER_ERROR: i32 = 16;

    /// The place of exact ratios.
    ///
    /// Where Ω is a power of two, 1/(2n) without rounding, the border 1/Ω² − 1 is exact, and so is the
    /// verdict. A float that is 1/(2n) to within its rounding only has one limit, the symmetric cycle, though
    /// it takes 10¹⁵ cycles and more to come close to it.
    pub fn new(ratios: Ratios<F>) -> Self {
        if ratios.has_higher_static_friction() {
            return Self::with_static_friction(ratios);
        }
        if ratios.is_damped() {
            return Self::damped(ratios);
        }
        let p = PhaseFunction::of_valid(ratios.omega());
        let border = Border::at(&p);
        let least = border.min_force_ratio;
        let (omega, alpha) = (ratios.omega(), ratios.alpha());
        let verdict = if p.value() == F::int(0) {
            degenerate(ratios)
        } else {
            let line = BorderRange { least, greatest: Some(least) };
            decide((omega, omega), (alpha, alpha), &line)
        };
        Self { ratios, border, verdict }
    }

    /// The place of ratios with damping: no family and no unbounded motion, and undecided within
    /// [`Place::DAMPED_BORDER_ERROR`] of the border and next to the edges of six reversals.
    fn damped(ratios: Ratios<F>) -> Self {
        let (border, alpha, one) = (Border::of(&ratios), ratios.alpha(), F::int(1));
        let error = F::int(Self::DAMPED_BORDER_ERROR) * F::epsilon();
        let least = border.min_force_ratio;
        let verdict = if alpha <= one {
            Verdict::AtRest
        } else if alpha < least * (one - error) {
            match damped::within(ratios) {
                Within::All => Verdict::SixReversals,
                Within::None => Verdict::Sticking,
                Within::Some => Verdict::Undecided(Regime::Sticking, Regime::NonSticking),
            }
        } else if alpha > least * (one + error) {
            Verdict::NonSticking
        } else {
            Verdict::Undecided(Regime::Sticking, Regime::NonSticking)
        };
        Self { ratios, border, verdict }
    }

    /// The place of ratios with a static friction above the kinetic one, where only the border is known for
    /// every start.
    fn with_static_friction(ratios: Ratios<F>) -> Self {
        let border = Border::of(&ratios);
        let (least, one) = (border.min_force_ratio, F::int(1));
        let error = F::int(if ratios.is_damped() { Self::DAMPED_BORDER_ERROR } else { Self::BORDER_ERROR });
        let regime = regime_by_border(ratios, &border);
        let verdict = if regime == Regime::Stuck {
            Verdict::AtRest
        } else if (ratios.alpha() - least).abs() <= error * F::epsilon() * least {
            let at_resonance = ratios.omega() == one && !ratios.is_damped();
            let above = if at_resonance { Regime::Unbounded } else { Regime::NonSticking };
            Verdict::Undecided(Regime::Sticking, above)
        } else {
            Verdict::DependsOnStart(regime)
        };
        Self { ratios, border, verdict }
    }

    /// The place of a machine in physical units, whose ratios carry the rounding of two divisions and a
    /// square root.
    ///
    /// Ω = 1/(2n) and Ω = 1 are lines in the plane, on which no such ratio is known to lie: beside them the
    /// verdict is [`Verdict::NonSticking`] or undecided, never [`Verdict::Degenerate`] or
    /// [`Verdict::Unbounded`]. With a damper the range of the border over the rounding is evaluated at
    /// fifteen points, which is no proof; where it changes by more than an eighth the verdict is undecided.
    ///
    /// # Errors
    /// Where a ratio leaves the domain of [`Ratios`] or of the border; [`Error::StaticFriction`] for a
    /// body whose static friction is above the kinetic one.
    pub fn of(body: &Oscillator<F>, drive: &Drive<F>) -> Result<Self, Error> {
        let ratios = drive.ratios(body)?.with_one_friction()?;
        if ratios.is_damped() {
            let error = F::int(Self::DAMPED_BORDER_ERROR) * F::epsilon();
            let verdict = damped::verdict_around(ratios, error)?;
            return Ok(Self { ratios, border: Border::of(&ratios), verdict });
        }
        // 1.25 and 1 times ε at most, and the rounding of the ends themselves.
        let around = |x: F| (x - F::int(2) * F::epsilon() * x, x + F::int(2) * F::epsilon() * x);
        Self::over(ratios, around(ratios.omega()), around(ratios.alpha()))
    }

    /// The place of ratios without damping known to lie in the intervals `omega` and `alpha`, each (low,
    /// high): the verdict holds for all. With damping it takes balls
    /// ([`crate::uncertainty::RatioBox::verdict`]).
    ///
    /// The margin and the border are those of the middle.
    ///
    /// # Errors
    /// Where an interval is empty or leaves the domain of [`Ratios`].
    pub(crate) fn within(omega: (F, F), alpha: (F, F)) -> Result<Self, Error> {
        let middle = |(low, high): (F, F)| low + (high - low) / F::int(2);
        Ratios::new(omega.0, alpha.0)?;
        Ratios::new(omega.1, alpha.1)?;
        if alpha.0 > alpha.1 {
            let (low, high) = (written(alpha.0), written(alpha.1));
            return Err(Error::EmptyRange { quantity: Quantity::ForceRatio, low, high });
        }
        Self::over(Ratios::new(middle(omega), middle(alpha))?, omega, alpha)
    }

    fn over(ratios: Ratios<F>, omega: (F, F), alpha: (F, F)) -> Result<Self, Error> {
        let verdict = decide(omega, alpha, &border_range(omega.0, omega.1)?);
        Ok(Self { ratios, border: Border::new(ratios.omega())?, verdict })
    }

    /// The ratios (Ω, α); the middle of intervals.
    pub const fn ratios(&self) -> Ratios<F> {
        self.ratios
    }

    /// The steady behaviour of the body.
    pub const fn verdict(&self) -> Verdict<F> {
        self.verdict
    }

    /// The border at this Ω.
    pub const fn border(&self) -> &Border<F> {
        &self.border
    }

    /// The margin α/α_min: the force over the minimum force without sticking.
    pub fn margin(&self) -> F {
        self.ratios.alpha() / self.border.min_force_ratio
    }
}

/// The verdict at Ω = 1/(2n).
///
/// Ω is a power of two there, 1/Ω² exact, and 1/Ω² − 1 is rounded once: no α lies between it and its rounded
/// value, except that the rounded one itself may be larger.
fn degenerate<F: Float>(ratios: Ratios<F>) -> Verdict<F> {
    let (one, alpha) = (F::int(1), ratios.alpha());
    let least = one / ratios.omega().square() - one;
    if alpha >= least {
        Verdict::Degenerate(Family::at(ratios, least))
    } else if alpha > one {
        Verdict::Sticking
    } else {
        Verdict::AtRest
    }
}

/// The verdict that holds for all Ω and α of two intervals, given the computed range of the border over the
/// first.
fn decide<F: Float>(omega: (F, F), alpha: (F, F), border: &BorderRange<F>) -> Verdict<F> {
    let one = F::int(1);
    let error = F::int(Place::<F>::BORDER_ERROR) * F::epsilon();
    if alpha.1 <= one {
        return Verdict::AtRest;
    }
    if alpha.0 <= one {
        return if alpha.1 < border.least && within(omega, alpha) == Within::None {
            Verdict::Undecided(Regime::Stuck, Regime::Sticking)
        } else {
            Verdict::Undecided(Regime::Stuck, Regime::NonSticking)
        };
    }
    if alpha.1 < border.least * (one - error) {
        return match within(omega, alpha) {
            Within::None => Verdict::Sticking,
            Within::All => Verdict::SixReversals,
            Within::Some => Verdict::Undecided(Regime::Sticking, Regime::NonSticking),
        };
    }
    let (at_resonance, may_resonate) = (omega.0 == one && omega.1 == one, omega.0 <= one && omega.1 >= one);
    let slides = border.greatest.is_some_and(|greatest| alpha.0 > greatest * (one + error));
    match (slides, at_resonance, may_resonate) {
        (true, true, _) => Verdict::Unbounded,
        (true, false, true) => Verdict::Undecided(Regime::NonSticking, Regime::Unbounded),
        (true, false, false) => Verdict::NonSticking,
        (false, true, _) => Verdict::Undecided(Regime::Sticking, Regime::Unbounded),
        (false, false, _) => Verdict::Undecided(Regime::Sticking, Regime::NonSticking),
    }
}

#[cfg(test)]
mod tests;
