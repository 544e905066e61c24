//! Halved numbers: a hi of half the digits, so that products of two are exact without a fused operation; those of whole pairs where
//! there is one.

use super::Pair;
use crate::float::Float;

impl<F: Float> Pair<F> {
    /// The square of a halved number; its lo of the order `2⁻ᵖᐟ²` of it.
    #[inline]
    #[must_use]
    pub fn halved_square(self) -> Self {
        if F::IS_FUSED {
            return self.square();
        }
        Self { hi: self.hi * self.hi, lo: self.lo * (self.value() + self.hi) }
    }

    /// `x²`, its lo of the order `2⁻ᵖᐟ²` of it.
    #[inline]
    #[must_use]
    pub fn loose_square(x: F) -> Self {
        if F::IS_FUSED {
            return Self::product(x, x);
        }
        let (hi, lo) = x.halves();
        Self { hi: hi * hi, lo: lo * (x + hi) }
    }

    /// `x` exactly, halved.
    #[inline]
    #[must_use]
    pub fn exact_halved(x: F) -> Self {
        if F::IS_FUSED {
            return Self::exact(x);
        }
        let (hi, lo) = x.halves();
        Self { hi, lo }
    }

    /// The same number with a hi of half the digits ([`Float::halves`]).
    #[inline]
    #[must_use]
    pub fn halved(self) -> Self {
        if F::IS_FUSED {
            return self;
        }
        let (hi, low) = self.hi.halves();
        Self { hi, lo: low + self.lo }
    }

    /// The product of two halved numbers, the product of the leading parts being exact; not halved itself.
    #[inline]
    #[must_use]
    pub fn times_halved(self, other: Self) -> Self {
        if F::IS_FUSED {
            return self * other;
        }
        Self { hi: self.hi * other.hi, lo: self.hi * other.lo + self.lo * other.value() }
    }

    /// The square root of a number > 0, halved.
    #[inline]
    #[must_use]
    pub fn halved_sqrt(self) -> Self {
        if F::IS_FUSED {
            return self.refined_root(self.hi.sqrt());
        }
        let root = self.value().sqrt();
        let (hi, _) = root.halves();
        Self { hi, lo: ((self.hi - hi * hi) + self.lo) / (root + hi) }
    }

    /// The quotient of two numbers, halved.
    #[inline]
    #[must_use]
    pub fn halved_ratio(a: F, b: F) -> Self {
        if F::IS_FUSED {
            let hi = a / b;
            return Self { hi, lo: -(hi.product_less(b, a) / b) };
        }
        let (hi, _) = (a / b).halves();
        let (high, low) = b.halves();
        Self { hi, lo: ((a - hi * high) - hi * low) / b }
    }

    /// The quotient of two halved numbers, halved.
    #[inline]
    #[must_use]
    pub fn halved_quotient(self, other: Self) -> Self {
        if F::IS_FUSED {
            return self / other;
        }
        let divisor = other.value();
        let (hi, _) = (self.value() / divisor).halves();
        Self { hi, lo: ((self.hi - hi * other.hi) + (self.lo - hi * other.lo)) / divisor }
    }
}
