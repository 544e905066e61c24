//! The reversal of the motion to more digits than the type has: `α |sin ω_d t₂| = √(α² − K²)` and Δ₀/B.
//!
//! `α² − K² = (α − |K|)(α + |K|)`, where α ≈ |K| is what cancels: an error of K counts κ = K²/(α² − K²) times. Where that is
//! little, K with the roundings of the type is good enough, and only what comes after it is done to more digits. Elsewhere K is
//! computed again as a pair.
//!
//! The cancellation has no bound beside Ω = 1 alone. On the border `α² − K² = (1/Ω² − 1)²` for Ω ≥ 1/2, with
//! |1/Ω² − 1| = (2/π)|w|(1 + Ω)/Ω, and |K| = (2/π)(1 + Ω)(1 − g), g = w²/3 + … ≥ 0. From α + |K| ≤ 2|K| + |1/Ω² − 1| follows
//!
//! ```text
//! α − |K| ≥ (w²/π) [(1 + Ω)/Ω²] / [1 + |w|/(2Ω)],
//! ```
//!
//! which is (2/π) w² at Ω = 1: of the order of g. The pair of K has an error of the order of `2⁻ᵖ g`, and of
//! `2⁻³ᵖᐟ²`, which is too much only very close to Ω = 1. There
//!
//! ```text
//! (π/2)(α − |K|) = (π/2) α − (1 + Ω) + (1 + Ω) g,
//! ```
//!
//! in which π takes three parts, (1 + Ω) is exact and g has its full relative accuracy.

use crate::float::{Float, pair::Pair};
use crate::phase_function::{
    PhaseFunction, cotangent_defect, one_minus_square_halved, one_minus_square_pair,
};

/// The reversal at the maximum displacement: `√(α² − K²)` and Δ₀/B to more digits than the type has.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reversal<F> {
    alpha: F,
    /// K(Ω), as good as it is needed here.
    pub(crate) phase_function: Pair<F>,
    /// `α |sin ω_d t₂|` (eq. 40).
    pub(crate) sine: Pair<F>,
    /// Δ₀/B (eq. 44), with the sign of 1 − Ω.
    displacement: Pair<F>,
}

/// K is good enough where its doubt counts less than a sixth: then it takes its part of two units in the last place.
const CONDITION: i32 = 6;

impl<F: Float> Reversal<F> {
    /// The reversal at the frequency ratio of `p` and the force ratio α: NaN where α < |K|, infinite at Ω = 1. An α below |K| by
    /// rounding is taken as the border, where Δ₀/B = 1/Ω².
    // Always inline: the common path then keeps everything in registers.
    #[inline(always)]
    pub fn new(p: &PhaseFunction<F>, alpha: F) -> Self {
        // Before the branch, so that it is shared with the border.
        let (k, width) = (p.pair(), one_minus_square_halved(p.omega()));
        let (minus, plus) = (Pair::ordered_sum(alpha, -k.hi), Pair::ordered_sum(alpha, k.hi));
        // κ = K²/(α² − K²) is the condition number of Δ₀ by K.
        let counts_little = k.hi * k.hi * p.doubt() * F::int(CONDITION) < minus.hi * plus.hi;
        if !counts_little {
            let (phase_function, sine, displacement) = refined(p.omega(), k, p.doubt(), alpha);
            return Self { alpha, phase_function, sine, displacement };
        }
        let (minus, plus) = (Pair::new(minus.hi, minus.lo - k.lo), Pair::new(plus.hi, plus.lo + k.lo));
        let sine = minus.halved().times_halved(plus.halved()).halved_sqrt();
        Self { alpha, phase_function: k, sine, displacement: sine.halved_quotient(width) }
    }

    /// The reversal of a body that does not stick, which has Δ₀/B ≥ 1/Ω² (eq. 61).
    ///
    /// α − |K| can be all rounding of α on the border, and fall short of that or be negative.
    #[inline]
    pub(crate) fn of_sliding(self, omega: F) -> Self {
        let least = F::int(1) - F::int(4) * F::epsilon();
        if self.max_displacement() * omega * omega >= least { self } else { self.on_the_border(omega) }
    }

    #[cold]
    #[inline(never)]
    fn on_the_border(self, omega: F) -> Self {
        let square = Pair::exact(omega).square();
        let (width, least) = (one_minus_square_pair(omega), Pair::exact(F::int(1)) / square);
        let displacement = if width.hi < F::int(0) { -least } else { least };
        Self { sine: width.abs() / square, displacement, ..self }
    }

    /// Maximum displacement Δ₀/B (eq. 44). Accuracy at f64: 2 ulp.
    #[inline]
    pub fn max_displacement(&self) -> F {
        self.displacement.value().abs()
    }

    /// Maximum displacement Δ₀/B rounded, and what that lacks.
    #[inline]
    pub(crate) fn max_displacement_pair(&self) -> Pair<F> {
        self.displacement.normalised().abs()
    }

    /// Loop size `A₁ = 8(Δ₀/B)/α²` (eq. 64). Accuracy at f64: 2 ulp.
    #[inline]
    pub fn loop_size_stiffness(&self) -> F {
        F::int(8) * self.displacement.over(Pair::loose_square(self.alpha)).abs()
    }

    /// Loop size `A₂ = Ω² A₁` (eq. 67) at the frequency ratio Ω of this reversal. Accuracy at f64: 2 ulp.
    #[inline]
    pub fn loop_size_inertia(&self, omega: F) -> F {
        F::int(8)
            * (self.displacement * Pair::exact(omega).square()).over(Pair::exact(self.alpha).square()).abs()
    }

    /// The same in another number type.
    pub(crate) fn map<G: Float>(self, to: impl Fn(F) -> G) -> Reversal<G> {
        Reversal {
            alpha: to(self.alpha),
            phase_function: self.phase_function.map(&to),
            sine: self.sine.map(&to),
            displacement: self.displacement.map(&to),
        }
    }

    /// Δ₁/B of eq. 47 at the centred time ψ of the maximum velocity.
    ///
    /// `α sin ω_d t₁ = −[α cos ω_d t₂ cos Ωψ + α sin ω_d t₂ sin Ωψ]`: without the rounding of ω_d t₁, and in pairs, because
    /// above Ω = 1 the terms are larger than V₀.
    #[inline]
    pub(crate) fn deviation(&self, omega: F, psi: F) -> F {
        let (s, c) = sin_cos(Pair::product(omega, psi));
        let sine = if omega < F::int(1) { self.sine } else { -self.sine };
        -(self.phase_function * c + sine * s + Pair::exact(F::int(1))).value()
    }
}

/// K, `√(α² − K²)` and Δ₀/B, with the sign of 1 − Ω, where α is so close to |K| that the error of K counts, and where it has none.
#[cold]
#[inline(never)]
fn refined<F: Float>(omega: F, k: Pair<F>, doubt: F, alpha: F) -> (Pair<F>, Pair<F>, Pair<F>) {
    let k = if doubt.is_finite() { PhaseFunction::refined_at(omega).pair() } else { k };
    let size = k.abs();
    let width = one_minus_square_pair(omega);
    let excess = excess(omega, size, alpha);
    if excess.hi <= F::int(0) && -excess.hi <= F::int(2) * F::epsilon() * alpha {
        // Close to Ω = 1 the border differs from |K| by less than the rounding of α: there this is the border.
        let displacement = F::int(1) / omega.square();
        return (k, width.abs() * displacement, Pair::exact(displacement.with_sign_of(width.hi)));
    }
    let Pair { hi, lo } = Pair::ordered_sum(alpha, size.hi);
    let sine = (excess * Pair::new(hi, lo + size.lo)).sqrt();
    let displacement = if width.hi == F::int(0) { Pair::exact(sine.hi / width.hi) } else { sine / width };
    (k, sine, displacement)
}

/// Maximum displacement Δ₀/B (eq. 44, [`super::max_displacement`]) at the frequency ratio of `p`.
///
/// In compensated pairs: accurate however close α is to |K|, and Ω to 1. Units of B = r_y/k. NaN where α < |K|, infinite
/// at Ω = 1. Accuracy at f64: 2 ulp.
#[inline]
pub fn max_displacement_at<F: Float>(p: &PhaseFunction<F>, alpha: F) -> F {
    Reversal::new(p, alpha).max_displacement()
}

/// `(sin, cos)` of a pair, each with the one rounding of the type's own function.
#[inline]
fn sin_cos<F: Float>(angle: Pair<F>) -> (Pair<F>, Pair<F>) {
    let (s, c) = angle.hi.sin_cos();
    (Pair::new(s, c * angle.lo), Pair::new(c, -(s * angle.lo)))
}

/// `α − |K|`.
#[inline]
fn excess<F: Float>(omega: F, k: Pair<F>, alpha: F) -> Pair<F> {
    let bits = if F::PRECISION < f64::MANTISSA_DIGITS { F::PRECISION as i32 / 5 } else { 10 };
    if (F::int(1) - omega).abs() < F::exp2i(-bits) {
        return excess_close_to_one(omega, alpha);
    }
    let Pair { hi, lo } = Pair::ordered_sum(alpha, -k.hi);
    Pair::new(hi, lo - k.lo)
}

/// [`excess`] beside Ω = 1.
#[cold]
#[inline(never)]
fn excess_close_to_one<F: Float>(omega: F, alpha: F) -> Pair<F> {
    let (half, (second, third)) = (F::ratio(1, 2), F::pi_rest());
    let w = Pair::exact(F::int(1) - omega) / omega * (Pair::pi() * half);
    let one_plus = Pair::sum(F::int(1), omega);
    let bend = one_plus * cotangent_defect(w.square());
    let (first, second) = (Pair::product(alpha, F::pi() * half), Pair::product(alpha, second * half));
    let third = alpha * (third * half);
    let terms =
        [first.hi, -one_plus.hi, first.lo, -one_plus.lo, second.hi, bend.hi, bend.lo, second.lo, third];
    sum(terms) * (Pair::exact(F::int(2)) / Pair::pi())
}

/// The sum to three times the digits of its largest term, rounded to a pair.
fn sum<F: Float, const N: usize>(terms: [F; N]) -> Pair<F> {
    let zero = F::int(0);
    let (mut high, mut middle, mut low) = (zero, zero, zero);
    for term in terms {
        let first = Pair::sum(high, term);
        let second = Pair::sum(middle, first.lo);
        (high, middle, low) = (first.hi, second.hi, low + second.lo);
    }
    let top = Pair::sum(high, middle);
    let rest = Pair::sum(top.lo, low);
    let all = Pair::sum(top.hi, rest.hi);
    Pair::new(all.hi, all.lo + rest.lo)
}
