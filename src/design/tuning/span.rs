//! Intervals of numbers: bounds of a formula over a range of its arguments, up to rounding.

use crate::float::Float;

/// All numbers from `low` to `high`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Span<F> {
    pub(super) low: F,
    pub(super) high: F,
}

impl<F: Float> Span<F> {
    pub(super) fn new(low: F, high: F) -> Self {
        Self { low, high }
    }

    pub(super) fn exactly(x: F) -> Self {
        Self { low: x, high: x }
    }

    pub(super) fn around(middle: F, radius: F) -> Self {
        Self { low: middle - radius, high: middle + radius }
    }

    pub(super) fn plus(self, other: Self) -> Self {
        Self { low: self.low + other.low, high: self.high + other.high }
    }

    pub(super) fn minus(self, other: Self) -> Self {
        Self { low: self.low - other.high, high: self.high - other.low }
    }

    /// This interval times a factor ≥ 0.
    pub(super) fn scaled(self, factor: F) -> Self {
        Self { low: self.low * factor, high: self.high * factor }
    }

    pub(super) fn times(self, other: Self) -> Self {
        let (a, b) = (self.low * other.low, self.low * other.high);
        let (c, d) = (self.high * other.low, self.high * other.high);
        let less = |x: F, y: F| if y < x { y } else { x };
        Self { low: less(less(a, b), less(c, d)), high: a.or_larger(b).or_larger(c.or_larger(d)) }
    }

    pub(super) fn square(self) -> Self {
        let (a, b) = (self.low.square(), self.high.square());
        let has_zero = self.low <= F::int(0) && self.high >= F::int(0);
        let low = if has_zero {
            F::int(0)
        } else if a < b {
            a
        } else {
            b
        };
        Self { low, high: a.or_larger(b) }
    }

    /// The greatest absolute value.
    pub(super) fn size(self) -> F {
        self.low.abs().or_larger(self.high.abs())
    }
}
