//! `Ball<LIMBS>`: a number that carries its error bound.
//!
//! A ball is a midpoint of `64 · LIMBS` bits and a radius: all real numbers within the radius of the
//! midpoint. Every function gives a ball that contains the exact values of the function at **every** point of
//! its arguments. Where no such ball exists, because a divisor may be zero, a radicand negative or an angle a
//! pole, the result is the whole line, never a ball that is too small.
//!
//! Each bound is a theorem, named where it is used, and rests on two facts. MPFR rounds correctly, so that a
//! midpoint is within half a unit in the last place of the exact value at the midpoints (Fousse et al.,
//! *MPFR*, ACM Trans. Math. Softw. 33 (2007) 13). The arithmetic of radii is rounded up (`radius`). Midpoint
//! and radius cost one MPFR operation where two end points cost two to four.
//!
//! | file | content |
//! |---|---|
//! | `radius` | bounds of errors, rounded up |
//! | `field` | + − × ÷ √, magnitudes, hypotenuse |
//! | `circular` | π, sine, cosine, tangent, angle, exponential |
//! | `text` | certain digits, then ± |
//! | `faults` | in tests: one bound after another made too small, each of which the tests have to notice |

mod circular;
#[cfg(test)]
mod faults;
mod field;
mod radius;
mod text;

use super::mp::Mp;
use super::{Field, Signed};
use core::cmp::Ordering;
pub(crate) use radius::Radius;
pub(crate) use text::{Written, written};

/// All real numbers within a radius of a midpoint; or the whole line.
#[derive(Debug, Clone, Copy)]
pub struct Ball<const LIMBS: usize> {
    mid: Mp<LIMBS>,
    rad: Radius,
}

/// The greatest error of a result that underflows to zero: below the least positive number of MPFR.
const UNDERFLOW: Radius = Radius::power_of_two(1 - (1 << 30));

impl<const LIMBS: usize> Ball<LIMBS> {
    /// The whole line.
    #[must_use]
    pub const fn entire() -> Self {
        Self { mid: Mp::ZERO, rad: Radius::INFINITE }
    }

    /// One number; the whole line where it is infinite or NaN.
    #[must_use]
    pub(crate) fn exact(x: Mp<LIMBS>) -> Self {
        Self::new(x, Radius::ZERO)
    }

    /// The numbers from `low` to `high`, and slightly more where their middle has to be rounded.
    ///
    /// Returns the whole line unless `low ≤ high`.
    #[must_use]
    pub(crate) fn between(low: Mp<LIMBS>, high: Mp<LIMBS>) -> Self {
        if !(low <= high && low.is_finite() && high.is_finite()) {
            return Self::entire();
        }
        let mid = (low + high).scale2(-1);
        let reach = |from: Mp<LIMBS>, to: Mp<LIMBS>| Radius::above(to.plus_up(-from));
        Self::new(mid, reach(low, mid).max(reach(mid, high)))
    }

    /// A ball with a midpoint and a radius.
    #[inline]
    pub(crate) fn new(mid: Mp<LIMBS>, rad: Radius) -> Self {
        if rad.is_infinite() || !mid.is_finite() { Self::entire() } else { Self { mid, rad } }
    }

    /// A number of an input: all numbers within 64 units in the last place of one as large as `largest`, which is more than reading and
    /// converting it can have rounded. 0 is exact.
    pub(crate) fn read<const N: usize>(x: Mp<N>, largest: Radius) -> Self {
        let mid = Mp::rounded(x);
        if mid.is_zero() {
            return Self::exact(mid);
        }
        let own = largest.times(Radius::power_of_two(6 - i64::from(x.bits())));
        let rounding = if mid.bits() < x.bits() {
            Radius::above(mid).times(Radius::power_of_two(-i64::from(mid.bits())))
        } else {
            Radius::ZERO
        };
        Self::new(mid, own.plus(rounding))
    }

    /// The midpoint.
    #[must_use]
    pub(crate) const fn mid(&self) -> Mp<LIMBS> {
        self.mid
    }

    #[inline]
    pub(crate) const fn rad(&self) -> Radius {
        self.rad
    }

    /// A lower bound of all numbers of the ball.
    #[must_use]
    pub(crate) fn lower(&self) -> Mp<LIMBS> {
        if self.is_entire() { -Mp::INFINITY } else { self.mid.minus_down(self.rad.value()) }
    }

    /// An upper bound of all numbers of the ball.
    #[must_use]
    pub(crate) fn upper(&self) -> Mp<LIMBS> {
        if self.is_entire() { Mp::INFINITY } else { self.mid.plus_up(self.rad.value()) }
    }

    /// Whether the ball is the whole line.
    #[must_use]
    pub(crate) const fn is_entire(&self) -> bool {
        self.rad.is_infinite()
    }

    #[cfg(test)]
    /// Whether x lies between [`Ball::lower`] and [`Ball::upper`].
    #[must_use]
    pub(crate) fn contains(&self, x: Mp<LIMBS>) -> bool {
        self.lower() <= x && x <= self.upper()
    }

    /// Whether the ball contains 0: exactly, without the rounding of [`Ball::lower`].
    #[must_use]
    pub(crate) fn contains_zero(&self) -> bool {
        Radius::below(self.mid) <= self.rad
    }

    /// The sign, where it is certain; `Equal` only for the number 0.
    #[must_use]
    pub fn sign(&self) -> Option<Ordering> {
        let zero = Mp::ZERO;
        if self.rad.is_zero() || !self.contains_zero() { self.mid.partial_cmp(&zero) } else { None }
    }

    /// Whether every number of the ball is above 0.
    #[must_use]
    pub(crate) fn is_positive(&self) -> bool {
        self.sign() == Some(Ordering::Greater)
    }

    /// Whether every number of the ball is below 0.
    #[must_use]
    pub(crate) fn is_negative(&self) -> bool {
        self.sign() == Some(Ordering::Less)
    }

    /// Whether every number of `self` is below every number of `other`.
    #[must_use]
    pub fn is_below(&self, other: &Self) -> bool {
        self.upper() < other.lower()
    }

    /// Whether every number of `self` lies strictly inside `other`.
    #[must_use]
    pub(crate) fn is_inside(&self, other: &Self) -> bool {
        other.lower() < self.lower() && self.upper() < other.upper()
    }

    /// The least ball that contains both balls, up to rounding.
    #[must_use]
    pub(crate) fn hull(&self, other: &Self) -> Self {
        let low = if other.lower() < self.lower() { other.lower() } else { self.lower() };
        let high = if other.upper() > self.upper() { other.upper() } else { self.upper() };
        Self::between(low, high)
    }

    /// A ball that contains the numbers common to both balls; `None` where there are none.
    #[must_use]
    pub(crate) fn intersection(&self, other: &Self) -> Option<Self> {
        // A ball inside the other is returned unchanged, so that rounding a middle does not enlarge it.
        if self.is_entire() || other.is_inside(self) {
            return Some(*other);
        }
        if other.is_entire() || self.is_inside(other) {
            return Some(*self);
        }
        let low = if other.lower() > self.lower() { other.lower() } else { self.lower() };
        let high = if other.upper() < self.upper() { other.upper() } else { self.upper() };
        (low <= high).then(|| Self::between(low, high))
    }

    /// The range of max(x, y) for x in `self` and y in `other`.
    #[must_use]
    pub(crate) fn larger(&self, other: &Self) -> Self {
        if self.is_below(other) {
            return *other;
        }
        if other.is_below(self) {
            return *self;
        }
        let low = if other.lower() > self.lower() { other.lower() } else { self.lower() };
        let high = if other.upper() > self.upper() { other.upper() } else { self.upper() };
        Self::between(low, high)
    }

    #[cfg(test)]
    /// This ball at another precision. A lower precision widens it by the rounding of its midpoint.
    #[must_use]
    pub(crate) fn at_width<const OTHER: usize>(&self) -> Ball<OTHER> {
        let mid = Mp::<OTHER>::rounded(self.mid);
        let rounding = if OTHER < LIMBS { half_unit(mid) } else { Radius::ZERO };
        Ball::new(mid, self.rad.plus(rounding))
    }
}

/// Half a unit in the last place of a result that MPFR rounded to nearest.
#[inline]
fn half_unit<const LIMBS: usize>(x: Mp<LIMBS>) -> Radius {
    // BITS is a u32, far below the range of an exponent.
    x.exponent().map_or(UNDERFLOW, |e| Radius::power_of_two(e - i64::from(x.bits()) - 1))
}

/// The sum of the parts of an error bound.
///
/// In tests, one of the parts can be made too small (`faults`), and the differential tests must detect it.
#[cfg_attr(test, track_caller)]
#[inline]
fn bound<const N: usize>(parts: [Radius; N]) -> Radius {
    #[cfg(test)]
    let parts = faults::injected(parts, core::panic::Location::caller());
    parts.into_iter().fold(Radius::ZERO, Radius::plus)
}

impl<const W: usize> Signed for Ball<W> {
    fn positive(self) -> Option<bool> {
        match self.sign() {
            Some(sign) => Some(sign == Ordering::Greater),
            None => (self.upper() <= Mp::ZERO).then_some(false),
        }
    }

    fn larger(self, other: Self) -> Self {
        Self::larger(&self, &other)
    }

    fn chosen(is_first: Option<bool>, first: Self, second: Self) -> Option<Self> {
        Some(match is_first {
            Some(true) => first,
            Some(false) => second,
            None => first.hull(&second),
        })
    }

    fn exponential(self) -> Self {
        self.exp()
    }

    fn exponential_less_one(self) -> Self {
        self.exp() - Self::int(1)
    }

    fn hyperbolic(self) -> [Self; 2] {
        Self::hyperbolic(self)
    }
}

#[cfg(test)]
mod tests;
