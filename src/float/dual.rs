//! An f64 with its first derivatives.

mod operators;

use super::{Field, Float, Real, Task};
use core::cmp::Ordering;
use core::fmt::{self, Display, LowerExp};
use num_dual::DualSVec64;

/// An f64 with its first derivatives by N parameters, on which every closed form of the crate runs.
///
/// The exact motion (`motion`) also runs on it, with the values of f64. Its events and its limit are found by
/// iterations that do not apply the implicit function theorem, so derivatives of a steady state are not
/// reliable.
///
/// It wraps [`num_dual::DualSVec64`] and implements [`Field`], [`Real`] and [`Float`]:
///
/// * **The value is that of f64, to the last bit.** Quotients, roots and angles are rounded once, as f64
///   rounds them, and the derivatives are computed separately.
/// * **Decisions see the value alone.** Order, equality, rounding and the choice of a branch act on it; two
///   numbers of one value are equal whatever their derivatives. At a decision the derivatives are those of
///   the side taken: `|x|` at 0 is differentiated as x, `√x` at 0 has an infinite derivative or none (NaN).
/// * **Roots found by iteration** get the derivatives of the implicit function, [`Float::implicit_root`], and
///   a maximum those of the function at the fixed point (the envelope theorem): the phase of the border and
///   its minimum displacement (`cycle::border`), the phase of the peak velocity
///   (`cycle::velocity`).
/// * **K(Ω)** is differentiated by its own closed form, which keeps its digits through Ω = 1 and far above
///   it.
///
/// ```
/// use stickslip::float::Dual;
/// use stickslip::{Cycle, Ratios};
/// let [omega, alpha] = Dual::parameters([1.5, 2.5]);
/// let delta = Cycle::new(Ratios::new(omega, alpha)?)?.max_displacement;
/// // Δ₀/B = √(α² − K²)/|1 − Ω²|, so that ∂Δ₀/∂α = α/(Δ₀ (1 − Ω²)²)
/// assert!((delta.value() - 1.632993161855452).abs() < 1e-15);
/// assert!((delta.derivatives()[1] - 2.5 / (1.632993161855452 * 1.25 * 1.25)).abs() < 1e-15);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Dual<const N: usize>(DualSVec64<N>);

impl<const N: usize> Dual<N> {
    /// The parameters themselves: each has the derivative 1 with respect to itself and 0 with respect to the
    /// others.
    #[must_use]
    pub fn parameters(values: [f64; N]) -> [Self; N] {
        let mut index = 0;
        values.map(|value| {
            let parameter = Self(DualSVec64::from_re(value).derivative(index));
            index += 1;
            parameter
        })
    }

    /// A number that does not depend on the parameters.
    #[must_use]
    pub(crate) fn of(value: f64) -> Self {
        Self(DualSVec64::from_re(value))
    }

    /// The number without its derivatives.
    #[must_use]
    pub const fn value(self) -> f64 {
        self.0.re
    }

    /// The derivatives with respect to the parameters.
    #[must_use]
    pub fn derivatives(self) -> [f64; N] {
        self.0.eps.0.map_or([0.0; N], Into::into)
    }

    /// `value` with the derivatives of `self` times `slope`: the chain rule.
    #[cfg_attr(debug_assertions, inline(never))] // as `combined`
    #[cfg_attr(not(debug_assertions), inline)]
    fn chained(self, value: f64, slope: f64) -> Self {
        Self(DualSVec64::new(value, self.0.eps * slope))
    }

    /// `value` with `a` times the derivatives of `self` and `b` times those of `other`.
    ///
    /// Every operation calls it. Inlined, it triples the speed, and is two fifths of the code of the tests, which are
    /// therefore compiled without.
    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline)]
    fn combined(self, value: f64, a: f64, other: Self, b: f64) -> Self {
        Self(DualSVec64::new(value, self.0.eps * a + other.0.eps * b))
    }
}

impl<const N: usize> From<f64> for Dual<N> {
    fn from(value: f64) -> Self {
        Self::of(value)
    }
}

impl<const N: usize> From<DualSVec64<N>> for Dual<N> {
    fn from(number: DualSVec64<N>) -> Self {
        Self(number)
    }
}

impl<const N: usize> From<Dual<N>> for DualSVec64<N> {
    fn from(number: Dual<N>) -> Self {
        number.0
    }
}

/// Displays the value, with the digits of an f64. The derivatives are in [`Dual::derivatives`].
impl<const N: usize> Display for Dual<N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Display::fmt(&self.value(), f)
    }
}

/// Displays the value with a power of ten.
impl<const N: usize> LowerExp for Dual<N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        LowerExp::fmt(&self.value(), f)
    }
}

impl<const N: usize> PartialEq for Dual<N> {
    fn eq(&self, other: &Self) -> bool {
        self.value() == other.value()
    }
}

impl<const N: usize> PartialOrd for Dual<N> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value().partial_cmp(&other.value())
    }
}

impl<const N: usize> Field for Dual<N> {
    #[inline]
    fn int(n: i32) -> Self {
        Self::of(f64::from(n))
    }
    #[inline]
    fn sqrt(self) -> Self {
        let root = self.value().sqrt();
        self.chained(root, 0.5 / root)
    }
    #[inline]
    fn abs(self) -> Self {
        self.chained(self.value().abs(), if self.value() < 0.0 { -1.0 } else { 1.0 })
    }
    #[inline]
    fn hypot(self, other: Self) -> Self {
        let length = Field::hypot(self.value(), other.value());
        self.combined(length, self.value() / length, other, other.value() / length)
    }
}

impl<const N: usize> Real for Dual<N> {
    #[inline]
    fn pi() -> Self {
        Self::of(core::f64::consts::PI)
    }
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (s, c) = Real::sin_cos(self.value());
        (self.chained(s, c), self.chained(c, -s))
    }
    #[inline]
    fn tan(self) -> Self {
        let tangent = Real::tan(self.value());
        self.chained(tangent, tangent.mul_add(tangent, 1.0))
    }
    #[inline]
    fn atan2(self, x: Self) -> Self {
        let radius = Field::hypot(self.value(), x.value());
        let (sine, cosine) = (self.value() / radius, x.value() / radius);
        self.combined(Real::atan2(self.value(), x.value()), cosine / radius, x, -(sine / radius))
    }
    #[inline]
    fn mul_add(self, a: Self, b: Self) -> Self {
        let product = self.combined(0.0, a.value(), a, self.value());
        product.combined(self.value().mul_add(a.value(), b.value()), 1.0, b, 1.0)
    }
}

impl<const N: usize> Float for Dual<N> {
    const PRECISION: u32 = <f64 as Float>::PRECISION;
    const RATIO_EXPONENT: i32 = <f64 as Float>::RATIO_EXPONENT;

    #[inline]
    fn pi_rest() -> (Self, Self) {
        let (second, third) = <f64 as Float>::pi_rest();
        (Self::of(second), Self::of(third))
    }
    #[inline]
    fn epsilon() -> Self {
        Self::of(f64::EPSILON)
    }
    #[inline]
    fn exp2i(e: i32) -> Self {
        Self::of(<f64 as Float>::exp2i(e))
    }
    #[inline]
    fn to_f64(self) -> f64 {
        self.value()
    }
    #[inline]
    fn from_f64(x: f64) -> Self {
        Self::of(x)
    }
    #[inline]
    fn floor(self) -> Self {
        Self::of(self.value().floor())
    }
    #[inline]
    fn round(self) -> Self {
        Self::of(self.value().round())
    }
    #[inline]
    fn is_finite(self) -> bool {
        self.value().is_finite()
    }
    #[inline]
    fn exp(self) -> Self {
        let power = Float::exp(self.value());
        self.chained(power, power)
    }
    #[inline]
    fn exp_m1(self) -> Self {
        self.chained(Float::exp_m1(self.value()), Float::exp(self.value()))
    }
    #[inline]
    fn angle_of(sine: Self, cosine: Self) -> Self {
        sine.combined(f64::angle_of(sine.value(), cosine.value()), cosine.value(), cosine, -sine.value())
    }
    #[inline(always)]
    fn fused<T: Task>(task: T) -> T::Output {
        f64::fused(task)
    }
    #[inline]
    fn constant(self) -> Self {
        Self::of(self.value())
    }
    #[inline]
    fn differentiated_as(self, like: impl FnOnce() -> Self) -> Self {
        Self(DualSVec64::new(self.value(), like().0.eps))
    }
}

#[cfg(test)]
mod tests {
    use super::Dual;
    use crate::float::{Field, Float, Real};

    type Function<const N: usize> = fn([Dual<N>; N]) -> Dual<N>;

    #[test]
    fn derivatives_are_those_of_differences() {
        let functions: [Function<2>; 16] = [
            |[x, y]| x + y,
            |[x, y]| x - y,
            |[x, y]| x * y,
            |[x, y]| x / y,
            |[x, y]| x % y,
            |[x, y]| x.atan2(y),
            |[x, y]| x.atan2(-y),
            |[x, y]| x.hypot(y),
            |[x, y]| x.mul_add(y, y),
            |[x, y]| (-x * y).abs() + x.abs(),
            |[x, y]| x.sqrt() * y.tan(),
            |[x, y]| (x / y).sin() * (x * y).cos(),
            |[x, y]| x.with_sign_of(-y).or_larger(y),
            |[x, y]| x.floor() + y.round() + x,
            |[x, y]| (-x * y).exp(),
            |[x, y]| (x / y).exp_m1(),
        ];
        let h = 1e-6;
        for (i, f) in functions.iter().enumerate() {
            for (x, y) in [(0.7, 0.3), (2.3, 0.4), (0.2, 1.1), (5.1, 0.9)] {
                let at = |x, y| f(Dual::parameters([x, y])).value();
                let expected =
                    [(at(x + h, y) - at(x - h, y)) / (2.0 * h), (at(x, y + h) - at(x, y - h)) / (2.0 * h)];
                let found = f(Dual::parameters([x, y])).derivatives();
                for (a, b) in found.iter().zip(expected) {
                    assert!((a - b).abs() < 1e-7 * (1.0 + b.abs()), "{i} at ({x}, {y}): {a} {b}");
                }
            }
        }
    }

    #[test]
    fn decisions_see_the_value() {
        let [x] = Dual::parameters([2.0]);
        assert!(x == Dual::of(2.0) && x < Dual::of(2.5) && x.to_string() == "2");
        assert_eq!(x.constant().derivatives(), [0.0]);
        assert_eq!((x * x).differentiated_as(|| x).derivatives(), [1.0]);
        let zero = x - Dual::of(2.0);
        assert_eq!(zero.abs().derivatives(), [1.0]);
        // The root of y³ = x, by its residual at the rounded root.
        let root = Dual::of(8.0f64.cbrt()).implicit_root(|y| (y * y * y - x * x * x, Dual::int(3) * y * y));
        assert!((root.derivatives()[0] - 1.0f64).abs() < 1e-15);
    }
}
