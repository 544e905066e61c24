//! A wrapped double with only the methods that its traits require, of which one is wrong.

use core::cmp::Ordering;
use core::fmt::{self, Display, Formatter, LowerExp};
use core::ops::{Add, Div, Mul, Neg, Sub};
use stickslip::{Field, Float, Real};

/// Method and fault: `Faulty<0>` has none, and `Faulty<n>` has the n-th.
pub(crate) const FAULTS: [(&str, &str); 45] = [
    ("PartialOrd::partial_cmp", "negative numbers in the order of their magnitudes"),
    ("PartialOrd::partial_cmp", "NaN is less than every number"),
    ("Field::int", "integers by way of 12 bits"),
    ("Add::add", "sums cut off"),
    ("Sub::sub", "differences cut off"),
    ("Mul::mul", "products one unit too large"),
    ("Div::div", "quotients by the reciprocal"),
    ("Field::sqrt", "a root of 40 bits"),
    ("Field::sqrt", "the root of a negative number is that of its magnitude"),
    ("Field::abs", "negative numbers stay so"),
    ("Real::mul_add", "two roundings"),
    ("Real::pi", "a digit is missing at the end of π"),
    ("Float::pi_rest", "π ends with its leading part"),
    ("Float::pi_rest", "π ends with its second part"),
    ("Real::sin_cos", "sines of ten digits"),
    ("Real::sin_cos", "the argument is reduced with π of 53 bits"),
    ("Real::tan", "tangents of ten digits"),
    ("Real::atan2", "angles between −π/2 and π/2"),
    ("Float::epsilon", "half of the unit"),
    ("Float::exp2i", "positive exponents only"),
    ("Float::floor", "towards zero"),
    ("Float::round", "down"),
    ("Float::is_finite", "NaN is"),
    ("Float::from_f64", "by way of f32"),
    ("Float::to_f64", "by way of f32"),
    ("Float::RATIO_EXPONENT", "half of the exponents' range"),
    ("Float::PRECISION", "52 bits"),
    ("LowerExp::fmt", "without an exponent's sign"),
    ("Float::RATIO_EXPONENT", "a little more than a third of the exponents' range"),
    ("Float::round", "by a half added first"),
    ("PartialEq::eq", "zeros by their signs"),
    ("Field::square", "a unit too large"),
    ("Field::times", "three times is a unit too large"),
    ("Field::ratio", "in single precision"),
    ("Field::hypot", "the sum"),
    ("Field::leg", "the difference"),
    ("Real::sin", "sines of ten digits"),
    ("Real::cos", "cosines of ten digits"),
    ("Float::exp", "powers of ten digits"),
    ("Float::exp_m1", "by subtraction"),
    ("Float::angle_of", "angles below a right one only"),
    ("Float::times_sign_of", "the number itself"),
    ("Float::with_sign_of", "times the sign"),
    ("Float::or_larger", "the larger magnitude"),
    ("Display::fmt", "three decimals"),
];

#[derive(Debug, Clone, Copy)]
pub(crate) struct Faulty<const FAULT: usize>(f64);

impl<const FAULT: usize> Faulty<FAULT> {
    /// The right or the wrong value, depending on whether this type has the fault.
    fn pick<T>(method: &str, what: &str, right: T, wrong: T) -> T {
        let is = FAULT > 0 && FAULTS[FAULT - 1].0 == method && FAULTS[FAULT - 1].1.starts_with(what);
        if is { wrong } else { right }
    }
}

/// The next number towards zero where the operation is not exact.
fn cut_off(sum: f64, rest: f64) -> f64 {
    if rest * sum < 0.0 { f64::from_bits(sum.to_bits() - 1) } else { sum }
}

fn rest_of_sum(a: f64, b: f64) -> f64 {
    let sum = a + b;
    let part = sum - a;
    (a - (sum - part)) + (b - part)
}

impl<const F: usize> PartialEq for Faulty<F> {
    fn eq(&self, other: &Self) -> bool {
        let by_sign = self.0 == other.0 && self.0.is_sign_negative() == other.0.is_sign_negative();
        Self::pick("PartialEq::eq", "zeros", self.0 == other.0, by_sign)
    }
}

impl<const F: usize> PartialOrd for Faulty<F> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        let right = self.0.partial_cmp(&other.0);
        let by_size = if self.0 < 0.0 && other.0 < 0.0 { other.0.partial_cmp(&self.0) } else { right };
        let found = Self::pick("PartialOrd::partial_cmp", "negative", right, by_size);
        Self::pick("PartialOrd::partial_cmp", "NaN", found, Some(right.unwrap_or(Ordering::Less)))
    }
}

impl<const F: usize> Add for Faulty<F> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let sum = self.0 + other.0;
        Self(Self::pick("Add::add", "sums", sum, cut_off(sum, rest_of_sum(self.0, other.0))))
    }
}

impl<const F: usize> Sub for Faulty<F> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        let sum = self.0 - other.0;
        Self(Self::pick("Sub::sub", "differences", sum, cut_off(sum, rest_of_sum(self.0, -other.0))))
    }
}

impl<const F: usize> Mul for Faulty<F> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let product = self.0 * other.0;
        let is_exact = self.0.mul_add(other.0, -product) == 0.0;
        let wrong = if is_exact { product } else { f64::from_bits(product.to_bits() + 1) };
        Self(Self::pick("Mul::mul", "products", product, wrong))
    }
}

impl<const F: usize> Div for Faulty<F> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        Self(Self::pick("Div::div", "quotients", self.0 / other.0, self.0 * (1.0 / other.0)))
    }
}

impl<const F: usize> Neg for Faulty<F> {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<const F: usize> Display for Faulty<F> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let (text, short) = (self.0.to_string(), format!("{:.3}", self.0));
        f.write_str(Self::pick("Display::fmt", "three", &text, &short))
    }
}

impl<const F: usize> LowerExp for Faulty<F> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let text = format!("{:e}", self.0);
        let wrong = text.replace("e-", "e");
        f.write_str(Self::pick("LowerExp::fmt", "without", &text, &wrong))
    }
}

impl<const F: usize> Field for Faulty<F> {
    fn int(n: i32) -> Self {
        Self(Self::pick("Field::int", "integers", f64::from(n), f64::from(n & !0xfff | (n & 0xffe))))
    }
    fn sqrt(self) -> Self {
        let root = self.0.sqrt();
        let short = f64::from_bits(root.to_bits() & !0xfff);
        let root = Self::pick("Field::sqrt", "a root", root, short);
        Self(Self::pick("Field::sqrt", "the root", root, self.0.abs().sqrt()))
    }
    fn abs(self) -> Self {
        Self(Self::pick("Field::abs", "negative", self.0.abs(), self.0))
    }
    fn ratio(p: i32, q: i32) -> Self {
        let single = f64::from(p as f32 / q as f32);
        Self(Self::pick("Field::ratio", "in single", f64::from(p) / f64::from(q), single))
    }
    fn square(self) -> Self {
        let square = self.0 * self.0;
        Self(Self::pick("Field::square", "a unit", square, square * (1.0 + f64::EPSILON)))
    }
    fn hypot(self, other: Self) -> Self {
        Self(Self::pick("Field::hypot", "the sum", self.0.hypot(other.0), self.0.abs() + other.0.abs()))
    }
    fn leg(self, other: Self) -> Self {
        let leg = ((self.0 - other.0) * (self.0 + other.0)).sqrt();
        Self(Self::pick("Field::leg", "the difference", leg, self.0 - other.0))
    }
    fn times(self, n: i32) -> Self {
        let times = f64::from(n) * self.0;
        let wrong = if n == 3 { times * (1.0 + f64::EPSILON) } else { times };
        Self(Self::pick("Field::times", "three", times, wrong))
    }
}

impl<const F: usize> Real for Faulty<F> {
    fn pi() -> Self {
        Self(Self::pick("Real::pi", "a digit", <f64 as Real>::pi(), <f64 as Real>::pi() - 2.0 * f64::EPSILON))
    }
    fn sin_cos(self) -> (Self, Self) {
        let (s, c) = Real::sin_cos(self.0);
        let (s, c) = Self::pick("Real::sin_cos", "sines", (s, c), (s * (1.0 + 1e-10), c));
        let turn = std::f64::consts::TAU;
        let wrong = Real::sin_cos(self.0 - (self.0 / turn).round() * turn);
        let (s, c) = Self::pick("Real::sin_cos", "the argument", (s, c), wrong);
        (Self(s), Self(c))
    }
    fn sin(self) -> Self {
        let sine = self.sin_cos().0.0;
        Self(Self::pick("Real::sin", "sines", sine, sine * (1.0 + 1e-10)))
    }
    fn cos(self) -> Self {
        let cosine = self.sin_cos().1.0;
        Self(Self::pick("Real::cos", "cosines", cosine, cosine * (1.0 + 1e-10)))
    }
    fn tan(self) -> Self {
        let tangent = Real::tan(self.0);
        Self(Self::pick("Real::tan", "tangents", tangent, tangent * (1.0 + 1e-10)))
    }
    fn atan2(self, x: Self) -> Self {
        Self(Self::pick("Real::atan2", "angles", Real::atan2(self.0, x.0), Real::atan2(self.0 / x.0, 1.0)))
    }
    fn mul_add(self, a: Self, b: Self) -> Self {
        Self(Self::pick("Real::mul_add", "two", self.0.mul_add(a.0, b.0), self.0 * a.0 + b.0))
    }
}

impl<const FAULT: usize> Float for Faulty<FAULT> {
    const PRECISION: u32 = if FAULT == 27 { 52 } else { 53 };
    const RATIO_EXPONENT: i32 = match FAULT {
        26 => 511,
        // Three times it overflows, and does not underflow.
        29 => 350,
        _ => 255,
    };

    fn pi_rest() -> (Self, Self) {
        let (second, third) = <f64 as Float>::pi_rest();
        let second = Self::pick("Float::pi_rest", "π ends with its leading", second, 0.0);
        (Self(second), Self(Self::pick("Float::pi_rest", "π ends with its second", third, 0.0)))
    }
    fn epsilon() -> Self {
        Self(Self::pick("Float::epsilon", "half", f64::EPSILON, f64::EPSILON / 2.0))
    }
    fn exp2i(e: i32) -> Self {
        Self(Self::pick("Float::exp2i", "positive", 2f64.powi(e), 2f64.powi(e.abs())))
    }
    fn to_f64(self) -> f64 {
        Self::pick("Float::to_f64", "by way", self.0, f64::from(self.0 as f32))
    }
    fn from_f64(x: f64) -> Self {
        Self(Self::pick("Float::from_f64", "by way", x, f64::from(x as f32)))
    }
    fn floor(self) -> Self {
        Self(Self::pick("Float::floor", "towards", self.0.floor(), self.0.trunc()))
    }
    fn round(self) -> Self {
        let round = Self::pick("Float::round", "down", self.0.round(), self.0.floor());
        Self(Self::pick("Float::round", "by a half", round, (self.0 + 0.5).floor()))
    }
    fn is_finite(self) -> bool {
        Self::pick("Float::is_finite", "NaN", self.0.is_finite(), !self.0.is_infinite())
    }
    fn exp(self) -> Self {
        let power = Float::exp(self.0);
        Self(Self::pick("Float::exp", "powers", power, power * (1.0 + 1e-10)))
    }
    fn exp_m1(self) -> Self {
        Self(Self::pick("Float::exp_m1", "by sub", Float::exp_m1(self.0), Float::exp(self.0) - 1.0))
    }
    fn angle_of(sine: Self, cosine: Self) -> Self {
        let angle = Real::atan2(sine.0, cosine.0);
        Self(Self::pick("Float::angle_of", "angles below", angle, sine.0.asin()))
    }
    fn or_larger(self, other: Self) -> Self {
        let by_size = if other.0.abs() > self.0.abs() { other.0 } else { self.0 };
        Self(Self::pick("Float::or_larger", "the larger", self.0.max(other.0), by_size))
    }
    fn times_sign_of(self, sign: Self) -> Self {
        let times = if sign.0 < 0.0 { -self.0 } else { self.0 };
        Self(Self::pick("Float::times_sign_of", "the number", times, self.0))
    }
    fn with_sign_of(self, sign: Self) -> Self {
        let (times, sized) = if sign.0 < 0.0 { (-self.0, -self.0.abs()) } else { (self.0, self.0.abs()) };
        Self(Self::pick("Float::with_sign_of", "times", sized, times))
    }
}
