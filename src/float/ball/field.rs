//! The field operations. The bounds are those of Johansson (2017), section 3. Each is derived in its line
//! from the distance between two points, with x within r of a and y within s of b.

use super::{Ball, Radius, bound, half_unit};
use crate::float::Field;
use crate::float::mp::Mp;
use core::ops::{Add, Div, Mul, Neg, Sub};

// These are not inlined: each consists of calls into MPFR that take far longer, and there is a copy for each
// precision.
impl<const LIMBS: usize> Add for Ball<LIMBS> {
    type Output = Self;

    /// `|(x + y) − (a + b)| ≤ r + s`.
    #[inline(never)]
    fn add(self, other: Self) -> Self {
        let mid = self.mid + other.mid;
        // Numbers that cancel exactly have no rounding error.
        let rounding = if self.mid == -other.mid { Radius::ZERO } else { half_unit(mid) };
        Self::new(mid, bound([self.rad, other.rad, rounding]))
    }
}

impl<const LIMBS: usize> Sub for Ball<LIMBS> {
    type Output = Self;

    #[inline(never)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<const LIMBS: usize> Neg for Ball<LIMBS> {
    type Output = Self;

    #[inline(never)]
    fn neg(self) -> Self {
        Self { mid: -self.mid, rad: self.rad }
    }
}

impl<const LIMBS: usize> Mul for Ball<LIMBS> {
    type Output = Self;

    /// `xy − ab = a(y − b) + b(x − a) + (x − a)(y − b)`.
    #[inline(never)]
    fn mul(self, other: Self) -> Self {
        if self.is_entire() || other.is_entire() {
            return Self::entire();
        }
        let mid = self.mid * other.mid;
        let (a, b) = (Radius::above(self.mid), Radius::above(other.mid));
        // A product with an exact zero is exact.
        let rounding = if a.is_zero() || b.is_zero() { Radius::ZERO } else { half_unit(mid) };
        let (r, s) = (self.rad, other.rad);
        Self::new(mid, bound([a.times(s), b.times(r), r.times(s), rounding]))
    }
}

impl<const LIMBS: usize> Div for Ball<LIMBS> {
    type Output = Self;

    /// `x/y − a/b = [(x − a) − (a/b)(y − b)]/y`, and `|y| ≥ |b| − s`.
    #[inline(never)]
    fn div(self, other: Self) -> Self {
        if self.is_entire() || other.is_entire() || other.contains_zero() {
            return Self::entire();
        }
        let mid = self.mid / other.mid;
        let rounding = if self.mid.is_zero() { Radius::ZERO } else { half_unit(mid) };
        // |a/b| is at most the rounded quotient plus its rounding error.
        let quotient = Radius::above(mid).plus(rounding);
        let least = Radius::below(other.mid).minus_down(other.rad);
        let moved = bound([self.rad, quotient.times(other.rad)]).over(least);
        Self::new(mid, bound([moved, rounding]))
    }
}

impl<const LIMBS: usize> Field for Ball<LIMBS> {
    #[inline(never)]
    fn int(n: i32) -> Self {
        Self { mid: Mp::of_int(n), rad: Radius::ZERO }
    }

    /// `|√x − √a| = |x − a|/(√x + √a)`, and `√x ≥ √(a − r) ≥ √a (1 − r/a)`. The result is the whole line
    /// where a radicand may be negative.
    #[inline(never)]
    fn sqrt(self) -> Self {
        if self.rad.is_zero() && self.mid.is_zero() {
            return self;
        }
        let a = Radius::below(self.mid);
        if self.mid.is_sign_negative() || a < self.rad {
            return Self::entire();
        }
        let mid = self.mid.sqrt();
        let two_less_share = Radius::ONE.scaled(1).minus_down(self.rad.over(a));
        let least = Radius::below(mid).minus_down(half_unit(mid)).times_down(two_less_share);
        let moved = if self.rad.is_zero() { Radius::ZERO } else { self.rad.over(least) };
        Self::new(mid, bound([moved, half_unit(mid)]))
    }

    /// The result is [0, |a| + r] where the sign is not certain.
    #[inline(never)]
    fn abs(self) -> Self {
        if self.is_entire() || !self.contains_zero() || self.rad.is_zero() {
            return Self { mid: self.mid.abs(), rad: self.rad };
        }
        Self::between(Mp::ZERO, self.mid.abs().plus_up(self.rad.value()))
    }

    /// `x² − a² = (x − a)(2a + (x − a))`.
    #[inline(never)]
    fn square(self) -> Self {
        if self.is_entire() {
            return self;
        }
        let (mid, r) = (self.mid.square(), self.rad);
        let rounding = if self.mid.is_zero() { Radius::ZERO } else { half_unit(mid) };
        Self::new(mid, bound([Radius::above(self.mid).scaled(1).times(r), r.times(r), rounding]))
    }

    /// `|hypot(x, y) − hypot(a, b)| ≤ hypot(x − a, y − b) ≤ r + s`, by the triangle inequality.
    #[inline(never)]
    fn hypot(self, other: Self) -> Self {
        let mid = self.mid.hypot(other.mid);
        let rounding = if mid.is_zero() { Radius::ZERO } else { half_unit(mid) };
        Self::new(mid, bound([self.rad, other.rad, rounding]))
    }
}
