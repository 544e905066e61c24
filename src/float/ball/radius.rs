//! An error bound: a number ≥ 0 with 32 bits, whose arithmetic is rounded away from zero.
//!
//! `value = mantissa · 2^(exponent − 32)`, with the mantissa in [2³¹, 2³²) or 0. A function without a
//! direction in its name gives a number that is not below the exact one; one that ends in `_down` gives a
//! number that is not above it. The arithmetic uses integers, so that both properties can be read off the
//! code. The model is Arb's `mag_t` (Johansson, *Arb: efficient arbitrary-precision midpoint-radius interval
//! arithmetic*, IEEE Trans. Comput. 66 (2017) 1281–1292, section 2.1).

use crate::float::mp::Mp;

/// A bound ≥ 0, or infinite.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Radius {
    mantissa: u32,
    exponent: i64,
}

/// Bits of the mantissa.
const BITS: u32 = 32;
/// Larger exponents give an infinite bound; exponents below the negative of this give the least bound.
const GREATEST: i64 = 1 << 40;

impl Radius {
    pub(crate) const ZERO: Self = Self { mantissa: 0, exponent: 0 };
    pub(crate) const INFINITE: Self = Self { mantissa: 1 << 31, exponent: i64::MAX };
    pub(crate) const ONE: Self = Self { mantissa: 1 << 31, exponent: 1 };

    /// `2ᵉ`.
    pub(crate) const fn power_of_two(e: i64) -> Self {
        Self { mantissa: 1 << 31, exponent: e + 1 }
    }

    /// The exponent e of a bound in [2ᵉ⁻¹, 2ᵉ).
    pub(crate) const fn exponent(self) -> i64 {
        self.exponent
    }

    #[inline]
    pub(crate) const fn is_infinite(self) -> bool {
        self.exponent == i64::MAX
    }

    #[inline]
    pub(crate) const fn is_zero(self) -> bool {
        self.mantissa == 0
    }

    /// `m · 2^(e − 32)`, rounded up.
    #[inline]
    fn rounded_up(m: u64, e: i64) -> Self {
        if m == 0 {
            return Self::ZERO;
        }
        let (cut, shifted) = Self::cut(m, e);
        // Nothing is lost unless the exponent has grown.
        let is_less = shifted > e && cut << (shifted - e) != m;
        Self::of_parts(cut + u64::from(is_less), shifted)
    }

    /// `m · 2^(e − 32)`, rounded down.
    #[inline]
    fn rounded_down(m: u64, e: i64) -> Self {
        if m == 0 {
            return Self::ZERO;
        }
        let (m, e) = Self::cut(m, e);
        if e < -GREATEST { Self::ZERO } else { Self::of_parts(m, e) }
    }

    /// The first 32 bits of m > 0, and the exponent that goes with them.
    #[inline]
    fn cut(m: u64, e: i64) -> (u64, i64) {
        let zeros = m.leading_zeros();
        ((m << zeros) >> BITS, e + i64::from(BITS) - i64::from(zeros))
    }

    /// A bound of m in [2³¹, 2³²], with the exponent clamped to its range.
    #[inline]
    fn of_parts(m: u64, e: i64) -> Self {
        let (m, e) = if m >> BITS != 0 { (m >> 1, e + 1) } else { (m, e) };
        if e > GREATEST {
            return Self::INFINITE;
        }
        if e < -GREATEST {
            return Self::power_of_two(-GREATEST);
        }
        // m < 2³² now.
        Self { mantissa: m as u32, exponent: e }
    }

    /// An upper bound of `|x|`; infinite for an infinity or NaN.
    #[inline]
    pub(crate) fn above<const LIMBS: usize>(x: Mp<LIMBS>) -> Self {
        match x.exponent() {
            Some(e) => {
                let (top, rest) = x.top();
                let m = (top >> BITS) + u64::from(top << BITS != 0 || rest);
                Self::of_parts(m, e)
            }
            None if x.is_zero() => Self::ZERO,
            None => Self::INFINITE,
        }
    }

    /// A lower bound of `|x|`; zero for an infinity or NaN.
    #[inline]
    pub(crate) fn below<const LIMBS: usize>(x: Mp<LIMBS>) -> Self {
        x.exponent().map_or(Self::ZERO, |e| Self::rounded_down(x.top().0 >> BITS, e))
    }

    /// The bound as an `Mp` number.
    pub(crate) fn value<const LIMBS: usize>(self) -> Mp<LIMBS> {
        if self.is_infinite() {
            return Mp::INFINITY;
        }
        // The mantissa fits in any `Mp`. An exponent beyond the range of i32 behaves like infinity, or like
        // the least number.
        let bits = i64::from(BITS);
        let shift = (self.exponent - bits).clamp(i64::from(i32::MIN), i64::from(i32::MAX));
        let value = Mp::of_f64(self.mantissa.into()).scale2(shift as i32);
        if value.is_zero() && !self.is_zero() { Mp::of_int(1).scale2(i32::MIN / 2 + 1) } else { value }
    }

    #[inline]
    pub(crate) fn plus(self, other: Self) -> Self {
        if self.is_infinite() || other.is_zero() {
            return self;
        }
        if other.is_infinite() || self.is_zero() {
            return other;
        }
        let (large, small) = if self.exponent >= other.exponent { (self, other) } else { (other, self) };
        let distance = (large.exponent - small.exponent).min(i64::from(BITS)) as u32;
        let small = u64::from(small.mantissa);
        let shifted = small >> distance;
        let shifted = shifted + u64::from(shifted << distance != small);
        Self::rounded_up(u64::from(large.mantissa) + shifted, large.exponent)
    }

    #[inline]
    pub(crate) fn times(self, other: Self) -> Self {
        self.product(other, Self::rounded_up)
    }

    #[inline]
    pub(crate) fn times_down(self, other: Self) -> Self {
        self.product(other, Self::rounded_down)
    }

    #[inline]
    fn product(self, other: Self, rounded: impl FnOnce(u64, i64) -> Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return Self::ZERO;
        }
        if self.is_infinite() || other.is_infinite() {
            return Self::INFINITE;
        }
        let product = u64::from(self.mantissa) * u64::from(other.mantissa);
        rounded(product, self.exponent + other.exponent - i64::from(BITS))
    }

    /// `self / other`, where `other` is a lower bound of the divisor; infinite where `other` is zero.
    #[inline]
    pub(crate) fn over(self, other: Self) -> Self {
        if other.is_zero() || self.is_infinite() {
            return Self::INFINITE;
        }
        if self.is_zero() || other.is_infinite() {
            return Self::ZERO;
        }
        let quotient = (u64::from(self.mantissa) << BITS).div_ceil(other.mantissa.into());
        Self::rounded_up(quotient, self.exponent - other.exponent)
    }

    /// `self · 2ᵉ`.
    #[inline]
    pub(crate) fn scaled(self, e: i64) -> Self {
        if self.is_zero() || self.is_infinite() {
            self
        } else {
            Self::of_parts(self.mantissa.into(), self.exponent + e)
        }
    }

    /// `self − other` rounded down, where `self` is a lower bound and `other` an upper one; zero where the
    /// difference is negative.
    #[inline]
    pub(crate) fn minus_down(self, other: Self) -> Self {
        if other.is_zero() || self.is_infinite() && !other.is_infinite() {
            return self;
        }
        if other.is_infinite() || self <= other {
            return Self::ZERO;
        }
        // other < self, so that its exponent is not larger.
        let distance = (self.exponent - other.exponent).min(i64::from(BITS)) as u32;
        let (large, small) = (u64::from(self.mantissa) << 31, u64::from(other.mantissa) << 31);
        let shifted = small >> distance;
        let shifted = shifted + u64::from(shifted << distance != small);
        Self::rounded_down(large.saturating_sub(shifted), self.exponent - 31)
    }
}

impl PartialOrd for Radius {
    fn partial_cmp(&self, other: &Self) -> Option<core::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Radius {
    fn cmp(&self, other: &Self) -> core::cmp::Ordering {
        let key = |r: &Self| (!r.is_zero(), r.exponent, r.mantissa);
        key(self).cmp(&key(other))
    }
}
