//! Compensated pairs: a number as the unevaluated sum of two, which doubles the precision of the type.
//!
//! These are the standard error-free transformations, with u = 2⁻ᵖ, half a unit in the last place of 1. Each
//! is exact where a type rounds to nearest and nothing overflows or underflows. This holds for `f32`, `f64`
//! and, because MPFR rounds correctly, `Mp`.
//!
//! | name | exact | operations | source |
//! |---|---|---|---|
//! | `two_sum` | a + b = hi + lo | 6 | Møller 1965, BIT 5; Knuth, *TAOCP* 2, 4.2.2, theorem B |
//! | `fast_two_sum` | a + b = hi + lo for \|a\| ≥ \|b\| | 3 | Dekker 1971, Numer. Math. 18 |
//! | `two_prod` | a b = hi + lo | 2, one of them fused | Ogita, Rump and Oishi 2005, SIAM J. Sci. Comput. 26 |
//!
//! The fused operation replaces Veltkamp's split, which Dekker's product needs: both give the same remainder,
//! to the last bit. A processor without a fused operation runs it in software ([`super::Float::fused`]).
//!
//! The operations built on them are those of Joldes, Muller and Popescu 2017 (ACM Trans. Math. Softw. 44, 15;
//! their "sloppy" sum). Only the sum by `+` and `−` keeps their last step, which makes |lo| at most half a unit of hi;
//! elsewhere [`Pair::value`] rounds once, at the end. For operands with |lo| ≤ c u |hi|, the relative errors
//! are at most
//!
//! | operation | error | \|lo\| ≤ … u \|hi\| on the way out |
//! |---|---|---|
//! | x + y of one sign | (2c + 1) u² | 1 |
//! | x + y of two signs | (2c + 1) u² (\|x\| + \|y\|)/\|x + y\| | 1 |
//! | `plus`, `less` | those of the sum | (1 + c) (\|x\| + \|y\|)/\|x + y\| |
//! | x y | (c² + 5c + 1) u² | 1 + 2c |
//! | x / y | (2c² + 7c + 6) u² | 3 + 2c |
//! | √x | (c² + 3c + 3) u² | 1 + c |
//! | √(x² − y²) | that of √ and half that of x² − y² | 2 |
//!
//! Overflow and underflow are not handled; the domain of [`crate::Ratios`] has room for both.

mod exponential;
mod operators;

use super::{Field, Float};

/// The number `hi + lo`, where |lo| is at most a few units in the last place of hi.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair<F> {
    /// The leading part.
    pub hi: F,
    /// The remainder.
    pub lo: F,
}

impl<F: Float> Pair<F> {
    /// `hi + lo` as they stand.
    #[inline(always)]
    #[must_use]
    pub const fn new(hi: F, lo: F) -> Self {
        Self { hi, lo }
    }

    /// A number of another type, given the conversions there and back, rounded to twice the digits of F.
    pub(crate) fn rounded<G: Float>(x: G, there: impl Fn(F) -> G, back: impl Fn(G) -> F) -> Self
    where
        F: Float,
    {
        let hi = back(x);
        Self::new(hi, back(x - there(hi)))
    }

    /// `x` exactly.
    #[inline(always)]
    #[must_use]
    pub fn exact(x: F) -> Self {
        // y + (−0) is y for every y, so that the compiler drops the sum; y + 0 is not y where y is −0.
        Self { hi: x, lo: -F::int(0) }
    }

    /// `a + b` exactly.
    #[inline(always)]
    #[must_use]
    pub(crate) fn two_sum(a: F, b: F) -> Self {
        // s = fl(a + b), e = fl[(a − (s − (s − a))) + (b − (s − a))]
        let hi = a + b;
        let b_part = hi - a;
        Self { hi, lo: (a - (hi - b_part)) + (b - b_part) }
    }

    /// `a + b` exactly for |a| ≥ |b| (or a = 0), in half the operations.
    #[inline(always)]
    #[must_use]
    pub(crate) fn fast_two_sum(a: F, b: F) -> Self {
        // s = fl(a + b), e = fl[(a − s) + b]
        let hi = a + b;
        Self { hi, lo: (a - hi) + b }
    }

    /// `a · b` exactly.
    #[inline(always)]
    #[must_use]
    pub(crate) fn two_prod(a: F, b: F) -> Self {
        // p = fl(a b), e = fl(a b − p), which is one fused operation
        let hi = a * b;
        Self { hi, lo: a.mul_add(b, -hi) }
    }

    /// `1/x`, given a number within a few units in the last place of it.
    #[inline(always)]
    #[must_use]
    pub(crate) fn reciprocal(x: F, near: F) -> Self {
        Self { hi: near, lo: (-near).mul_add(x, F::int(1)) * near }
    }

    /// π with an error of at most `2⁻²ᵖ`.
    #[inline(always)]
    #[must_use]
    pub(crate) fn pi() -> Self {
        Self { hi: F::pi(), lo: F::pi_rest().0 }
    }

    /// The parts in another number type, each rounded on its own.
    #[must_use]
    pub(crate) fn map<G>(self, to: impl Fn(F) -> G) -> Pair<G> {
        Pair { hi: to(self.hi), lo: to(self.lo) }
    }

    /// `self/other`, given a number within a few units in the last place of 1/other: lo contains the remainder of hi.
    #[inline(always)]
    pub(crate) fn over(self, other: Self, inverse: F) -> Self {
        let hi = self.hi * inverse;
        let rest = (-hi).mul_add(other.lo, self.lo) + (-hi).mul_add(other.hi, self.hi);
        Self { hi, lo: rest * inverse }
    }

    /// `self − other` for |other| ≤ |self|, without the last step of a sum.
    #[inline(always)]
    #[must_use]
    pub(crate) fn less(self, other: Self) -> Self {
        // The fast sum of the leading parts, written as a difference.
        let hi = self.hi - other.hi;
        let lo = (self.hi - hi) - other.hi;
        Self { hi, lo: lo + (self.lo - other.lo) }
    }

    /// The number, rounded once.
    #[inline(always)]
    #[must_use]
    pub fn value(self) -> F {
        self.hi + self.lo
    }

    /// This number with hi as its nearest value.
    #[inline(always)]
    #[must_use]
    pub(crate) fn normalised(self) -> Self {
        Self::fast_two_sum(self.hi, self.lo)
    }
}

impl<F: Float> Field for Pair<F> {
    #[inline(always)]
    fn int(n: i32) -> Self {
        Self::exact(F::int(n))
    }

    /// The root of zero is zero; that of a negative number is NaN.
    #[inline(always)]
    fn sqrt(self) -> Self {
        let hi = self.hi.sqrt();
        let lo = (self.lo - hi.mul_add(hi, -self.hi)) / (hi + hi);
        Self { hi, lo: if hi == F::int(0) { hi } else { lo } }
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Self { hi: self.hi.abs(), lo: self.lo.times_sign_of(self.hi) }
    }

    /// Without the last step of a sum.
    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        let sum = Self::two_sum(self.hi, other.hi);
        Self::new(sum.hi, sum.lo + (self.lo + other.lo))
    }

    /// Two squares do not cancel.
    #[inline(always)]
    fn hypot(self, other: Self) -> Self {
        self.square().plus(other.square()).sqrt()
    }

    /// The digits of a pair remain even if the two squares nearly cancel.
    #[inline(always)]
    fn leg(self, other: Self) -> Self {
        self.square().less(other.square()).normalised().sqrt()
    }

    /// The leading part is not rounded where n is a power of two.
    #[inline(always)]
    fn times(self, n: i32) -> Self {
        let factor = F::int(n);
        if n & n.wrapping_sub(1) == 0 {
            Self { hi: factor * self.hi, lo: factor * self.lo }
        } else {
            self * factor
        }
    }

    #[inline(always)]
    fn square(self) -> Self {
        let Self { hi, lo } = Self::two_prod(self.hi, self.hi);
        Self { hi, lo: (self.hi + self.hi).mul_add(self.lo, lo) }
    }
}

#[cfg(test)]
mod tests {
    use super::Pair;
    use crate::drawn::cases;
    use crate::float::{Field, Float};
    use proptest::prelude::*;

    /// The value of a double times 2⁶⁰ as an integer: exact in i128 for the numbers tried here.
    fn scaled(x: f64) -> i128 {
        (x * 2f64.powi(60)) as i128
    }

    fn has_twice_the_digits(a: f64, b: f64, c: f64) {
        let unit = f64::EPSILON * f64::EPSILON.sqrt();
        let (x, y) = (Pair::two_prod(a, b), Pair::two_sum(b, c));
        let within = |p: Pair<f64>, q: Pair<f64>, size: f64| (p - q).value().abs() <= 8.0 * unit * size;
        let near = |p: Pair<f64>, q: Pair<f64>| within(p, q, q.value().abs());
        assert!(near(x / y * y, x));
        assert!(near(x.sqrt().square(), x));
        // Cancellation leaves the rounding errors of the operands.
        let of = (x + y) * y;
        assert!(within(of - y.square(), x * y, of.value()));
        assert!(near(-(-x).abs(), -x));
    }

    /// An input that failed once.
    #[test]
    fn equal_numbers_have_twice_the_digits() {
        has_twice_the_digits(0.1, 0.1, 0.1);
    }

    proptest! {
        #![proptest_config(cases(256))]

        #[test]
        fn sums_are_exact(a in -1e3f64..1e3, b in -1e-3f64..1e-3) {
            let (a, b) = (scaled(a) >> 8 << 8, scaled(b));
            let (a, b) = (a as f64, b as f64);
            for pair in [Pair::two_sum(a, b), Pair::two_sum(b, a), Pair::fast_two_sum(a, b)] {
                prop_assert_eq!(pair.hi as i128 + pair.lo as i128, a as i128 + b as i128);
                prop_assert!(pair.lo.abs() <= f64::EPSILON / 2.0 * pair.hi.abs());
            }
        }

        #[test]
        fn products_are_exact(a in 1i64..1 << 53, b in -(1i64 << 53)..1 << 53) {
            let pair = Pair::two_prod(a as f64, b as f64);
            prop_assert_eq!(pair.hi as i128 + pair.lo as i128, i128::from(a) * i128::from(b));
        }

        #[test]
        fn what_is_built_on_them_has_twice_the_digits(a in 0.1f64..10.0, b in 0.1f64..10.0, c in 0.1f64..10.0) {
            has_twice_the_digits(a, b, c);
        }

        #[test]
        fn sides_of_a_triangle_and_multiples(a in 0.1f64..10.0, b in 0.1f64..10.0, c in 1e-12f64..1.0) {
            let x = Pair::two_sum(a, 1e-17 * b);
            let near = |found: Pair<f64>, exact: Pair<f64>, ulps: f64| {
                let error = (found - exact).value().abs();
                error <= ulps * (exact.hi.next_up() - exact.hi)
            };
            // The bound holds however close the two are.
            let longer = Pair::exact(a + a * c);
            let (difference, sum) = (longer - x, longer + x);
            prop_assert!(near(longer.leg(x), (difference * sum).sqrt(), 1e-9));
            prop_assert_eq!((x.times(8).hi, x.times(8).lo), (8.0 * x.hi, 8.0 * x.lo));
            prop_assert!(near(x.times(3), x + x + x, 0.5));
        }
    }

    /// π − 3 minus its leading digits, to twice the digits: a pair that is only as accurate as its leading
    /// part fails.
    fn pi_has_twice_the_digits<F: Float>() {
        // The sine of the leading part is the part missing from π, to the third order.
        let missing = F::pi().sin();
        let (second, third) = F::pi_rest();
        assert!((second - missing).abs() <= F::epsilon() * missing.abs(), "{second} {missing}");
        assert!(third != F::int(0) && third.abs() <= F::epsilon() * second.abs());
    }

    #[test]
    fn the_rest_of_pi() {
        pi_has_twice_the_digits::<f64>();
        #[cfg(feature = "mp")]
        {
            use crate::float::Real;
            use crate::float::mp::Mp;
            pi_has_twice_the_digits::<Mp<1>>();
            pi_has_twice_the_digits::<Mp<4>>();
            let (second, third) = Mp::<2>::pi_rest();
            let sum = Mp::<6>::rounded(Mp::<2>::pi()) + Mp::rounded(second) + Mp::rounded(third);
            assert!((sum - Mp::pi()).abs() <= Mp::<6>::epsilon() * Mp::of_int(4));
            // The two parts at f64 agree with the wide number.
            let (second, third) = <f64 as Float>::pi_rest();
            let sum = Mp::<4>::from(<f64 as Real>::pi()) + Mp::from(second) + Mp::from(third);
            assert!((sum - Mp::pi()).abs() <= Mp::<4>::exp2i(-160));
            let (second, third) = <f32 as Float>::pi_rest();
            let sum = Mp::<4>::from(<f32 as Real>::pi()) + Mp::from(second) + Mp::from(third);
            assert!((sum - Mp::pi()).abs() <= Mp::<4>::exp2i(-73));
        }
    }

    #[cfg(feature = "mp")]
    #[test]
    fn the_transformations_are_exact_at_any_precision() {
        use crate::float::mp::Mp;
        let (a, b) = (Mp::<2>::of_int(1) / Mp::of_int(7), Mp::<2>::of_int(5) / Mp::of_int(3_000_017));
        let wide = |p: Pair<Mp<2>>| Mp::<5>::rounded(p.hi) + Mp::rounded(p.lo);
        let (wide_a, wide_b) = (Mp::<5>::rounded(a), Mp::<5>::rounded(b));
        assert_eq!(wide(Pair::two_sum(a, b)), wide_a + wide_b);
        assert_eq!(wide(Pair::two_sum(b, -a)), wide_b - wide_a);
        assert_eq!(wide(Pair::two_prod(a, b)), wide_a * wide_b);
        let quotient = wide(Pair::two_prod(a, b) / Pair::two_sum(a, b));
        let exact = wide_a * wide_b / (wide_a + wide_b);
        assert!((quotient - exact).abs() <= exact * Mp::<5>::exp2i(-251));
    }
}
