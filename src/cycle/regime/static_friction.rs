//! The regime with a static friction above the kinetic one, η > 1: what every start leads to, and what depends
//! on it.
//!
//! Three statements, which the answers keep apart:
//!
//! * **The cycles without a stop.** A motion that does not stop is a motion of η = 1, too: the equation while
//!   the body slides is the same, and η > 1 only asks for a greater force at the reversals. So the cycle of two
//!   reversals exists from the border α_min(Ω, ζ, η) on, and that of six between its edges ([`super::NoStop::of`]), with
//!   the multipliers of η = 1: they attract their neighbourhood.
//! * **A body at rest** at x stays where `|α sin θ − x| ≤ η` for all θ, that is where `|x| ≤ η − α`: somewhere for
//!   α ≤ η, and nowhere for α > η ([`Ratios::moves_from_rest`]).
//! * **Everything else** depends on the start, except for the proofs below.
//!
//! # What every start leads to
//!
//! * **α ≤ 1: rest.** The energy `½(x² + w²)` changes by `(α sin θ − sgn w) w − 2ζw² ≤ −(1 − α |sin θ|)|w|`, and each
//!   slide begins with an acceleration of η − 1 or more, so that it takes at least a fixed share of it: the number
//!   of slides is finite.
//! * **α > η and no cycle without a stop: stops again and again.** A motion that does not stop from some time on is
//!   a motion of η = 1, and tends to the limit of η = 1, which is one for all starts (`motion::shooting`). If this
//!   limit has a stop, where the force left over is below friction, its neighbours stop there, too. If it has none,
//!   it is a cycle whose force at some reversal is below η, and its neighbours stop at that reversal. (That the limit
//!   of η = 1 is one of these cycles is proved and searched as in [`super::NoStop::of`].)
//! * **ζ > 0 and a great α: the cycle of two reversals.** Let `x = x_l + y`, x_l the motion of the linear
//!   oscillator, of amplitude α/q. Friction is at most η, moving or not, so that in the long run `|y| ≤ ηC` and
//!   `|y′| ≤ η(1 + C)`, where C = coth(πζ/2d) and 1 + C are bounds of the integrals of |h| and |h′|, h the impulse
//!   response. At a velocity zero x_l′ = −y′, and the force left over is `x_l″ + 2ζx_l′ − y`. With
//!   `C ≤ 1 + 2/(πζ)` its size is above η where
//!
//!   ```text
//!   α > 2ηq (1 + 1/πζ) √(Ω² + (1 + 2ζ)²)/Ω²,
//!   ```
//!
//!   so that no velocity zero is a stop, and the motion tends to the cycle. The bound is sufficient, not the
//!   least one.
//! * **Ω = 1, ζ = 0 and α > 4η/π: growth without bound.** `x′ sin θ − x cos θ` grows by `πα − ∮ r sin θ dθ ≥ πα − 4η`
//!   in each turn.

use crate::float::{Float, Real};
use crate::machine::ratios::Ratios;

/// Whether every start leads to a motion without a stop, given that there is one: with η = 1, and where α is so
/// great.
#[inline(always)]
pub(super) fn leads_from_every_start<F: Float>(ratios: &Ratios<F>) -> bool {
    // The rounding of the bound must not matter.
    let sure = F::int(1) + F::int(16) * F::epsilon();
    !ratios.has_higher_static_friction()
        || every_start(ratios).is_some_and(|least| ratios.alpha() > least * sure)
}

/// A force ratio above which every start leads to the motion without a stop, for η > 1; `None` where none is
/// known, without a damper away from Ω = 1.
#[inline(never)]
pub(super) fn every_start<F: Float>(ratios: &Ratios<F>) -> Option<F> {
    let (omega, zeta, eta) = (ratios.omega(), ratios.damping_ratio(), ratios.static_friction_ratio());
    if ratios.is_damped() {
        Some(sliding_bound(omega, zeta, eta))
    } else {
        (omega == F::int(1)).then(|| F::int(4) * eta / F::pi())
    }
}

/// `2ηq (1 + 1/πζ) √(Ω² + (1 + 2ζ)²)/Ω²`.
pub(crate) fn sliding_bound<F: Real>(omega: F, zeta: F, eta: F) -> F {
    let (one, two) = (F::int(1), F::int(2));
    let q = (two * zeta * omega).hypot((one - omega) * (one + omega));
    let gain = one + one / (F::pi() * zeta);
    two * eta * q * gain * omega.hypot(one + two * zeta) / omega.square()
}

#[cfg(test)]
mod tests;
