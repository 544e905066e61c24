//! Compensated pairs: a number as the unevaluated sum of two, which doubles the precision of the type.
//!
//! The transformations are exact where a type rounds to nearest: of any two numbers
//!
//! ```text
//! a + b = s + e,   s = fl(a + b),  e = fl[(a − (s − (s − a))) + (b − (s − a))]      (Knuth)
//! a · b = p + e,   p = fl(a · b),  e = fl(a b − p), one fused operation
//! ```
//!
//! and so for `f32`, `f64` and, because MPFR rounds correctly, `Mp`. Products, quotients and roots of pairs take the rest of a product
//! from [`Float::product_less`], so that they are accurate to `2⁻²ᵖ` where the type has a fused operation of its own and to
//! `2⁻³ᵖᐟ²` where it would be a call. None keeps |lo| below half a unit of hi: [`Pair::value`] rounds once at the end.
//!
//! Where the type has no fused operation, the cheapest arithmetic is that of *halved* numbers: a hi of half the digits, so that products
//! of two are exact, and a lo of the order `2⁻ᵖᐟ²` of it ([`Pair::halved`], [`Pair::times_halved`] and so on); it has 3/2 of the
//! digits, too. Where there is a fused operation, the same functions are those of whole pairs.
//!
//! No overflow or underflow is looked after; the domain of [`crate::Ratios`] has room for both.

mod halved;
mod operators;

use super::Float;

/// The number `hi + lo`: |lo| is a few units in the last place of hi at most, or `2⁻ᵖᐟ²` of it in a halved number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair<F> {
    /// The leading part.
    pub hi: F,
    /// The rest.
    pub lo: F,
}

impl<F: Float> Pair<F> {
    /// `hi + lo` as they stand.
    #[inline]
    #[must_use]
    pub const fn new(hi: F, lo: F) -> Self {
        Self { hi, lo }
    }

    /// `x` exactly.
    #[inline]
    #[must_use]
    pub fn exact(x: F) -> Self {
        Self { hi: x, lo: F::int(0) }
    }

    /// `a + b` exactly.
    #[inline]
    #[must_use]
    pub fn sum(a: F, b: F) -> Self {
        let hi = a + b;
        let b_part = hi - a;
        Self { hi, lo: (a - (hi - b_part)) + (b - b_part) }
    }

    /// `a + b` exactly, of |a| ≥ |b| (or a = 0) in half the operations.
    #[inline]
    #[must_use]
    pub fn ordered_sum(a: F, b: F) -> Self {
        let hi = a + b;
        Self { hi, lo: b - (hi - a) }
    }

    /// `a · b` exactly.
    #[inline]
    #[must_use]
    pub fn product(a: F, b: F) -> Self {
        let hi = a * b;
        Self { hi, lo: a.mul_add(b, -hi) }
    }

    /// π: within `2⁻²ᵖ` of it.
    #[inline]
    #[must_use]
    pub fn pi() -> Self {
        Self { hi: F::pi(), lo: F::pi_rest().0 }
    }

    /// The parts in another number type, each rounded on its own.
    #[must_use]
    pub fn map<G>(self, to: impl Fn(F) -> G) -> Pair<G> {
        Pair { hi: to(self.hi), lo: to(self.lo) }
    }

    /// The number, rounded once.
    #[inline]
    #[must_use]
    pub fn value(self) -> F {
        self.hi + self.lo
    }

    /// The same number with hi its nearest.
    #[inline]
    #[must_use]
    pub fn normalised(self) -> Self {
        Self::ordered_sum(self.hi, self.lo)
    }

    /// `√(hi + lo)`; of a zero zero, of a negative number NaN.
    #[inline]
    #[must_use]
    pub fn sqrt(self) -> Self {
        let hi = self.hi.sqrt();
        // Said so that NaN is kept.
        if hi == F::int(0) {
            return Self::exact(hi);
        }
        self.refined_root(hi)
    }

    /// The root with what its rounded value > 0 lacks.
    #[inline]
    fn refined_root(self, hi: F) -> Self {
        Self { hi, lo: (self.lo - hi.product_less(hi, self.hi)) / (hi + hi) }
    }

    /// `(hi + lo)²`.
    #[inline]
    #[must_use]
    pub fn square(self) -> Self {
        let hi = self.hi * self.hi;
        Self { hi, lo: (self.hi + self.hi).times_plus(self.lo, self.hi.product_less(self.hi, hi)) }
    }

    /// The quotient, within one unit in the last place of the type.
    #[inline]
    #[must_use]
    pub fn over(self, other: Self) -> F {
        if F::IS_FUSED {
            return (self / other).value();
        }
        let divisor = other.value();
        let rest = (other.hi - divisor) + other.lo;
        let quotient = self.value() / divisor;
        (self.hi + (self.lo - quotient * rest)) / divisor
    }

    /// `√[(hi + lo)² + other²]`, rounded once, for squares within the range of the type.
    #[inline]
    #[must_use]
    pub fn hypot(self, other: Self) -> F {
        (self.square() + other.square()).sqrt().value()
    }

    /// `|hi + lo|`, of |lo| < |hi|.
    #[inline]
    #[must_use]
    pub fn abs(self) -> Self {
        if self.hi < F::int(0) { -self } else { self }
    }
}

#[cfg(test)]
mod tests {
    use super::Pair;
    use crate::float::Float;
    use proptest::prelude::*;

    /// The rational value of a double as integer and exponent is exact in i128 for such as these: k·2⁻⁶⁰.
    fn scaled(x: f64) -> i128 {
        (x * 2f64.powi(60)) as i128
    }

    proptest! {
        #[test]
        fn sums_are_exact(a in -1e3f64..1e3, b in -1e-3f64..1e-3) {
            let (a, b) = (scaled(a) >> 8 << 8, scaled(b));
            let (a, b) = (a as f64, b as f64);
            for pair in [Pair::sum(a, b), Pair::sum(b, a), Pair::ordered_sum(a, b)] {
                prop_assert_eq!(pair.hi as i128 + pair.lo as i128, a as i128 + b as i128);
                prop_assert!(pair.lo.abs() <= f64::EPSILON / 2.0 * pair.hi.abs());
            }
        }

        #[test]
        fn products_are_exact(a in 1i64..1 << 53, b in -(1i64 << 53)..1 << 53) {
            let pair = Pair::product(a as f64, b as f64);
            prop_assert_eq!(pair.hi as i128 + pair.lo as i128, i128::from(a) * i128::from(b));
        }

        #[test]
        fn what_is_built_on_them_has_twice_the_digits(a in 0.1f64..10.0, b in 0.1f64..10.0, c in 0.1f64..10.0) {
            let unit = f64::EPSILON * f64::EPSILON.sqrt();
            let (x, y) = (Pair::product(a, b), Pair::sum(b, c));
            let within = |p: Pair<f64>, q: Pair<f64>, size: f64| (p - q).value().abs() <= 8.0 * unit * size;
            let near = |p: Pair<f64>, q: Pair<f64>| within(p, q, q.value().abs());
            prop_assert!(near(x / y * y, x));
            prop_assert!(near(x.sqrt().square(), x));
            // What cancels leaves the rounding of what it was made of.
            let of = (x + y) * y;
            prop_assert!(within(of - y.square(), x * y, of.value()));
            prop_assert!(near(-(-x).abs(), -x));
            prop_assert_eq!(x.hypot(y), (x.square() + y.square()).sqrt().normalised().hi);
        }
    }

    /// π − 3 less its leading digits, to twice the digits: a pair that is only as good as its leading part fails.
    fn pi_has_twice_the_digits<F: Float>() {
        // sin of the leading part is what is missing from π, to the third order.
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
            use crate::float::{Real, mp::Mp};
            pi_has_twice_the_digits::<Mp<1>>();
            pi_has_twice_the_digits::<Mp<4>>();
            let (second, third) = Mp::<2>::pi_rest();
            let sum = Mp::<6>::rounded(Mp::<2>::pi()) + Mp::rounded(second) + Mp::rounded(third);
            assert!((sum - Mp::pi()).abs() <= Mp::<6>::epsilon() * Mp::of_int(4));
            // The doubles agree with the wide number.
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
        assert_eq!(wide(Pair::sum(a, b)), wide_a + wide_b);
        assert_eq!(wide(Pair::sum(b, -a)), wide_b - wide_a);
        assert_eq!(wide(Pair::product(a, b)), wide_a * wide_b);
        let quotient = wide(Pair::product(a, b) / Pair::sum(a, b));
        let exact = wide_a * wide_b / (wide_a + wide_b);
        assert!((quotient - exact).abs() <= exact * Mp::<5>::exp2i(-251));
    }
}
