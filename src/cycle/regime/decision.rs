//! The decision on the regime of a point of the plane of Ω and α, with its certainty.

use super::{Family, Regime, Verdict, damped, regime_of_sliding};
use crate::cycle::Border;
use crate::cycle::border::{BorderRange, border_range};
use crate::cycle::phase_function::PhaseFunction;
use crate::cycle::six_reversals::{Within, within, within_box};
use crate::float::Float;
use crate::machine::error::{Error, Quantity, written};
use crate::machine::oscillator::{Drive, Oscillator};
use crate::machine::ratios::Ratios;

impl<F: Float> Verdict<F> {
    /// The verdict at exact ratios.
    ///
    /// Where Ω = 1/(2n) is a power of two, the border 1/Ω² − 1 is exact, and so is the verdict. Any other
    /// float is 1/(2n) only to within rounding and has a single limit, the symmetric cycle, though the motion
    /// takes 10¹⁵ cycles and more to approach it.
    ///
    /// With η > 1 a cycle without a stop matters only where a body at rest is released.
    pub fn new(ratios: Ratios<F>) -> Self {
        let (one, omega, alpha) = (F::int(1), ratios.omega(), ratios.alpha());
        let is_plain = !ratios.is_damped() && !ratios.has_higher_static_friction();
        if is_plain && PhaseFunction::of_valid(omega).value() == F::int(0) {
            return degenerate(ratios);
        }
        if alpha <= one {
            return Verdict::AtRest;
        }
        let sliding = regime_of_sliding(&ratios);
        if sliding == Regime::DependsOnStart && !ratios.moves_from_rest() {
            return Verdict::DependsOnStart;
        }
        let least = Border::of(&ratios).min_force_ratio;
        let error = F::int(if ratios.is_damped() { Self::DAMPED_BORDER_ERROR } else { Self::BORDER_ERROR });
        let error = error * F::epsilon();
        let is_below = alpha < least * (one - error);
        let exists = if is_below {
            within(&ratios)
        } else if alpha > least * (one + error) {
            Within::All
        } else {
            Within::Some
        };
        match (exists, sliding) {
            (Within::Some, _) => Verdict::Undecided(Regime::Sticking, sliding),
            (Within::None, _) => Verdict::Sticking,
            (Within::All, Regime::DependsOnStart) => Verdict::DependsOnStart,
            (Within::All, Regime::Unbounded) => Verdict::Unbounded,
            (Within::All, _) if is_below => Verdict::SixReversals,
            (Within::All, _) => Verdict::NonSticking,
        }
    }

    /// The verdict on a machine in physical units, whose ratios carry the rounding of two divisions and a
    /// square root.
    ///
    /// Ω = 1/(2n) and Ω = 1 are lines in the plane, and no rounded ratio is known to lie on them. Near them
    /// the verdict is [`Verdict::NonSticking`] or undecided, never [`Verdict::Degenerate`] or
    /// [`Verdict::Unbounded`]. With a damper, the range of the border over the rounding is evaluated at
    /// fifteen points, which is no proof; where it changes by more than an eighth, the verdict is undecided.
    ///
    /// # Errors
    /// Where a ratio leaves the domain of [`Ratios`] or of the border; [`Error::StaticFriction`] for a
    /// body whose static friction is above the kinetic one.
    pub fn of(body: &Oscillator<F>, drive: &Drive<F>) -> Result<Self, Error> {
        let ratios = drive.ratios(body)?.with_one_friction()?;
        if ratios.is_damped() {
            let error = F::int(Self::DAMPED_BORDER_ERROR) * F::epsilon();
            return damped::verdict_around(ratios, error);
        }
        // The ratios have errors of at most 1.25 ε and 1 ε, and the ends are themselves rounded.
        let around = |x: F| (x - F::int(2) * F::epsilon() * x, x + F::int(2) * F::epsilon() * x);
        Self::over(around(ratios.omega()), around(ratios.alpha()))
    }

    /// The verdict that holds for all ratios without damping in the intervals `omega` and `alpha`, each (low,
    /// high). With damping it requires ball arithmetic ([`crate::uncertainty::ParameterBox::verdict`]).
    ///
    /// # Errors
    /// Where an interval is empty or leaves the domain of [`Ratios`].
    pub(crate) fn within(omega: (F, F), alpha: (F, F)) -> Result<Self, Error> {
        Ratios::new(omega.0, alpha.0)?;
        Ratios::new(omega.1, alpha.1)?;
        if alpha.0 > alpha.1 {
            let (low, high) = (written(alpha.0), written(alpha.1));
            return Err(Error::EmptyRange { quantity: Quantity::ForceRatio, low, high });
        }
        Self::over(omega, alpha)
    }

    fn over(omega: (F, F), alpha: (F, F)) -> Result<Self, Error> {
        Ok(decide(omega, alpha, &border_range(omega.0, omega.1)?))
    }
}

// For the programs of this repository.
#[doc(hidden)]
impl<F: Float> Verdict<F> {
    /// Relative error bound of the computed border, in units of [`Float::epsilon`].
    ///
    /// The greatest error compared with the same condition at 60 digits is 3.1, over 10⁴ frequency ratios
    /// from 1e-3 to 1e3, including those near 1 and 1/n down to neighbouring floats. It does not grow at the
    /// poles, because π/2Ω is reduced exactly.
    pub const BORDER_ERROR: i32 = 8;

    /// Relative error bound of the border with damping, where a sum of three terms replaces one. The greatest error compared with the
    /// same condition at 256 bits is 8.
    pub const DAMPED_BORDER_ERROR: i32 = 16;
}

/// The verdict at Ω = 1/(2n).
///
/// There Ω is a power of two, 1/Ω² is exact, and 1/Ω² − 1 is rounded once. No α lies between it and its
/// rounded value, except that the rounded value itself may be larger.
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
    let error = F::int(Verdict::<F>::BORDER_ERROR) * F::epsilon();
    if alpha.1 <= one {
        return Verdict::AtRest;
    }
    if alpha.0 <= one {
        return if alpha.1 < border.least && within_box(omega, alpha) == Within::None {
            Verdict::Undecided(Regime::Stuck, Regime::Sticking)
        } else {
            Verdict::Undecided(Regime::Stuck, Regime::NonSticking)
        };
    }
    if alpha.1 < border.least * (one - error) {
        return match within_box(omega, alpha) {
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
