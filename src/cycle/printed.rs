//! The paper's formulae as printed, where they are wrong.
//!
//! They are for comparison only: `docs/errata.md` shows each with its correction, and a test compares each
//! with the reference value. Eq. 37, 48 and 49 share their error and are represented by eq. 49.

use crate::float::Real;

/// Phase `ω_d t₂` by eq. 43 as printed: `π/2 + arccos(Δ₀/A)`, in (π/2, 3π/2).
///
/// Wrong where K(Ω) > 0: on (1/3, 1/2), (1/5, 1/4), … the phase is `π/2 − arccos(Δ₀/A)`. Correct form:
/// [`crate::cycle::equations::displacement_phase`]. `ratio` is Δ₀/A.
#[inline]
pub fn displacement_phase<R: Real>(ratio: R) -> R {
    // arccos r = atan2(√(1 − r²), r)
    let arc_cosine = ((R::int(1) - ratio) * (R::int(1) + ratio)).sqrt().atan2(ratio);
    R::pi() / R::int(2) + arc_cosine
}

/// Peak velocity `V₀/(Bω_d)` by eq. 49 as printed, both roots positive.
///
/// ```text
/// √[α² − (1 + Δ₁/B)²]/|1−Ω²| + √[2/(Ω²(1 + cos π₁)) − (1/Ω − 1/(Ω(1−Ω²)) − ΩΔ₁/(B(1−Ω²)))²]
/// ```
///
/// Wrong for every Ω > 1 (second root), and near the border for some Ω in (1/2, 1) (first root). Correct
/// form: [`crate::cycle::equations::max_velocity_from_phase`].
pub fn max_velocity<R: Real>(omega: R, alpha: R, cos_pi_1: R, deviation: R) -> R {
    let one = R::int(1);
    let q = crate::cycle::phase_function::one_minus_square(omega);
    let first = (alpha.square() - (one + deviation).square()).sqrt() / q.abs();
    let inner = one / omega - one / (omega * q) - omega * deviation / q;
    first + (R::int(2) / (omega.square() * (one + cos_pi_1)) - inner.square()).sqrt()
}
