//! Sign, kind and exponent: the operations that need no MPFR call.

use super::{Mp, limb_t, mpfr};

impl<const LIMBS: usize> Mp<LIMBS> {
    /// The number with its sign bit inverted.
    #[inline]
    pub(in crate::float::mp) fn negated(self) -> Self {
        Self { kind: -self.kind, ..self }
    }

    /// `|self|`.
    #[inline]
    #[must_use]
    pub(crate) fn abs(self) -> Self {
        Self { kind: self.kind.abs(), ..self }
    }

    /// Whether the sign is negative: true for −0 and −∞ too, never for NaN.
    #[inline]
    #[must_use]
    pub(crate) fn is_sign_negative(self) -> bool {
        self.kind < 0
    }

    /// Whether this is NaN.
    #[doc(hidden)]
    #[inline]
    #[must_use]
    pub fn is_nan(self) -> bool {
        self.kind == mpfr::NAN_KIND
    }

    /// Whether this is a zero of either sign.
    #[inline]
    #[must_use]
    pub(crate) fn is_zero(self) -> bool {
        self.kind.abs() == mpfr::ZERO_KIND
    }

    /// Neither infinite nor NaN.
    #[inline]
    #[must_use]
    pub(crate) fn is_finite(self) -> bool {
        self.kind.abs() >= mpfr::ZERO_KIND
    }

    /// The exponent e of `|self|` in `[2ᵉ⁻¹, 2ᵉ)`; `None` for zeros, infinities and NaN.
    #[inline]
    #[must_use]
    pub(crate) fn exponent(self) -> Option<i64> {
        (self.kind.abs() == mpfr::REGULAR_KIND).then_some(self.exponent)
    }

    /// The top limb of a regular number, and whether any of the others is nonzero.
    #[inline]
    pub(in crate::float) fn top(&self) -> (limb_t, bool) {
        self.significand()
            .split_last()
            .map_or((0, false), |(top, others)| (*top, others.iter().any(|&limb| limb != 0)))
    }
}
