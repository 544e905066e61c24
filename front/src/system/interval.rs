//! Intervals, with which a formula and its first two derivatives are enclosed over a range of its variable.
//!
//! Each operation rounds outwards: by one float after an operation that IEEE 754 rounds correctly, and by four after a function of libm, whose errors
//! are below one. A derivative that does not exist, as at the corner of `abs`, is the whole line; where only the second one fails to exist, the
//! first is the hull of both sides, so that it still bounds a difference.

/// Numbers from `low` to `high`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Interval {
    low: f64,
    high: f64,
}

const WHOLE: Interval = Interval { low: f64::NEG_INFINITY, high: f64::INFINITY };
const ZERO: Interval = Interval { low: 0.0, high: 0.0 };
const ONE: Interval = Interval { low: 1.0, high: 1.0 };

impl Interval {
    pub(super) const fn point(x: f64) -> Self {
        Self { low: x, high: x }
    }

    pub(super) const fn new(low: f64, high: f64) -> Self {
        Self { low, high }
    }

    /// The greatest size of its numbers.
    pub(super) fn size(self) -> f64 {
        self.low.abs().max(self.high.abs())
    }

    /// By so many floats wider.
    fn rounded(low: f64, high: f64, by: u32) -> Self {
        if low.is_nan() || high.is_nan() {
            return WHOLE;
        }
        let (mut low, mut high) = (low, high);
        for _ in 0..by {
            (low, high) = (low.next_down(), high.next_up());
        }
        Self { low, high }
    }

    /// A function that does not fall, on the part of the interval within `from` and `to`.
    fn rising(self, from: f64, to: f64, function: impl Fn(f64) -> f64) -> Self {
        if self.high < from || self.low > to {
            return WHOLE;
        }
        Self::rounded(function(self.low.clamp(from, to)), function(self.high.clamp(from, to)), 4)
    }

    fn has_zero(self) -> bool {
        self.low <= 0.0 && self.high >= 0.0
    }

    fn hull(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    pub(super) fn plus(self, other: Self) -> Self {
        Self::rounded(self.low + other.low, self.high + other.high, 1)
    }

    fn negative(self) -> Self {
        Self { low: -self.high, high: -self.low }
    }

    pub(super) fn minus(self, other: Self) -> Self {
        self.plus(other.negative())
    }

    pub(super) fn times(self, other: Self) -> Self {
        if self == ZERO || other == ZERO {
            return ZERO;
        }
        let all =
            [self.low * other.low, self.low * other.high, self.high * other.low, self.high * other.high];
        if all.iter().any(|x| x.is_nan()) {
            return WHOLE;
        }
        let low = all.iter().copied().fold(f64::INFINITY, f64::min);
        Self::rounded(low, all.iter().copied().fold(f64::NEG_INFINITY, f64::max), 1)
    }

    fn inverse(self) -> Self {
        if self.has_zero() {
            // One side of 0 alone has inverses of one sign.
            return match (self.low == 0.0 && self.high > 0.0, self.high == 0.0 && self.low < 0.0) {
                (true, _) => Self::rounded(1.0 / self.high, f64::INFINITY, 1),
                (_, true) => Self::rounded(f64::NEG_INFINITY, 1.0 / self.low, 1),
                _ => WHOLE,
            };
        }
        Self::rounded(1.0 / self.high, 1.0 / self.low, 1)
    }

    pub(super) fn over(self, other: Self) -> Self {
        self.times(other.inverse())
    }

    fn square(self) -> Self {
        let size = self.size();
        let low = if self.has_zero() { 0.0 } else { self.low.abs().min(self.high.abs()) };
        let found = Self::rounded(low * low, size * size, 1);
        Self { low: found.low.max(0.0), ..found }
    }

    fn sqrt(self) -> Self {
        let found = self.rising(0.0, f64::INFINITY, f64::sqrt);
        Self { low: found.low.max(0.0), ..found }
    }

    fn exp(self) -> Self {
        let found = self.rising(f64::NEG_INFINITY, f64::INFINITY, libm::exp);
        Self { low: found.low.max(0.0), ..found }
    }

    fn sin(self) -> Self {
        use std::f64::consts::{FRAC_PI_2, TAU};
        if !(self.size() < 1e6 && self.high - self.low < TAU) {
            return Self { low: -1.0, high: 1.0 };
        }
        let turns = |x: f64, top: f64, by: f64| ((x - top) / TAU + by).floor();
        // Within rounding of a top or a bottom it has it.
        let has = |top: f64| turns(self.high, top, 1e-9) > turns(self.low, top, -1e-9);
        let (a, b) = (libm::sin(self.low), libm::sin(self.high));
        let found = Self::rounded(a.min(b), a.max(b), 4);
        let low = if has(-FRAC_PI_2) { -1.0 } else { found.low.max(-1.0) };
        let high = if has(FRAC_PI_2) { 1.0 } else { found.high.min(1.0) };
        Self { low, high }
    }

    fn cos(self) -> Self {
        let quarter = Self::rounded(std::f64::consts::FRAC_PI_2, std::f64::consts::FRAC_PI_2, 1);
        self.plus(quarter).sin()
    }

    /// `xⁿ`: for a whole n of any number, else of numbers ≥ 0.
    fn power(self, n: f64) -> Self {
        if n == 0.0 {
            return ONE;
        }
        if n < 0.0 {
            return self.power(-n).inverse();
        }
        let is_whole = n == n.floor() && n < 1e9;
        let is_even = is_whole && (n / 2.0) == (n / 2.0).floor();
        let of = |x: f64| libm::pow(x, n);
        if is_whole && !is_even {
            return self.rising(f64::NEG_INFINITY, f64::INFINITY, of);
        }
        let found = if is_even {
            let low = if self.has_zero() { 0.0 } else { self.low.abs().min(self.high.abs()) };
            Self::rounded(of(low), of(self.size()), 4)
        } else {
            self.rising(0.0, f64::INFINITY, of)
        };
        Self { low: found.low.max(0.0), ..found }
    }
}

/// A function with its first two derivatives over an interval.
#[derive(Debug, Clone, Copy)]
pub(super) struct Jet {
    pub(super) value: Interval,
    pub(super) first: Interval,
    pub(super) second: Interval,
}

impl Jet {
    pub(super) const fn number(x: f64) -> Self {
        Self { value: Interval::point(x), first: ZERO, second: ZERO }
    }

    pub(super) const fn variable(x: Interval) -> Self {
        Self { value: x, first: ONE, second: ZERO }
    }

    /// g of it, by g and its first two derivatives over its values.
    fn chain(self, g: Interval, g1: Interval, g2: Interval) -> Self {
        let second = g2.times(self.first.square()).plus(g1.times(self.second));
        Self { value: g, first: g1.times(self.first), second }
    }

    pub(super) fn plus(self, other: Self) -> Self {
        Self {
            value: self.value.plus(other.value),
            first: self.first.plus(other.first),
            second: self.second.plus(other.second),
        }
    }

    pub(super) fn negative(self) -> Self {
        Self { value: self.value.negative(), first: self.first.negative(), second: self.second.negative() }
    }

    pub(super) fn minus(self, other: Self) -> Self {
        self.plus(other.negative())
    }

    pub(super) fn times(self, other: Self) -> Self {
        let cross = self.first.times(other.first);
        Self {
            value: self.value.times(other.value),
            first: self.first.times(other.value).plus(self.value.times(other.first)),
            second: self
                .second
                .times(other.value)
                .plus(cross)
                .plus(cross)
                .plus(self.value.times(other.second)),
        }
    }

    pub(super) fn over(self, other: Self) -> Self {
        let g = other.value.inverse();
        let square = g.square();
        let inverse = other.chain(g, square.negative(), square.times(g).times(Interval::point(2.0)));
        self.times(inverse)
    }

    /// `aᵇ`.
    pub(super) fn power(self, other: Self) -> Self {
        let n = other.value.low;
        if other.value == Interval::point(n) && other.first == ZERO && other.second == ZERO {
            let x = self.value;
            let factor = Interval::point(n).times(Interval::point(n - 1.0));
            let first = Interval::point(n).times(x.power(n - 1.0));
            let second = if factor == ZERO { ZERO } else { factor.times(x.power(n - 2.0)) };
            return self.chain(x.power(n), first, second);
        }
        other.times(self.apply("ln")).apply("exp")
    }

    /// The lesser of two, or the greater.
    pub(super) fn extreme(self, other: Self, least: bool) -> Self {
        let (a, b) = (self.value, other.value);
        let (below, above) = if least { (self, other) } else { (other, self) };
        if a.high <= b.low {
            return below;
        }
        if b.high <= a.low {
            return above;
        }
        let value = if least {
            Interval { low: a.low.min(b.low), high: a.high.min(b.high) }
        } else {
            Interval { low: a.low.max(b.low), high: a.high.max(b.high) }
        };
        Self { value, first: self.first.hull(other.first), second: WHOLE }
    }

    /// The function with this name.
    pub(super) fn apply(self, function: &str) -> Self {
        let x = self.value;
        let infinite = f64::INFINITY;
        let all = |function: fn(f64) -> f64| x.rising(-infinite, infinite, function);
        let number = Interval::point;
        match function {
            "abs" if x.low >= 0.0 => self,
            "abs" if x.high <= 0.0 => self.negative(),
            "abs" => Self {
                value: number(0.0).hull(number(x.size())),
                first: self.first.hull(self.first.negative()),
                second: WHOLE,
            },
            "sign" if x.low > 0.0 || x.high < 0.0 => Self::number(x.low.signum()),
            "sign" => Self { value: Interval::new(-1.0, 1.0), first: WHOLE, second: WHOLE },
            "sqrt" => {
                let root = x.sqrt();
                let first = root.times(number(2.0)).inverse();
                let cube = Interval { low: x.low.max(0.0), ..x }.times(root).times(number(4.0));
                self.chain(root, first, cube.inverse().negative())
            }
            "exp" => {
                let value = x.exp();
                self.chain(value, value, value)
            }
            "ln" | "log10" => {
                let positive = Interval { low: x.low.max(0.0), ..x };
                let ln = positive.rising(0.0, infinite, libm::log);
                let inverse = positive.inverse();
                let found = self.chain(ln, inverse, inverse.square().negative());
                if function == "ln" {
                    found
                } else {
                    Self {
                        value: positive.rising(0.0, infinite, libm::log10),
                        ..found.over(Self::number(std::f64::consts::LN_10))
                    }
                    .rounded()
                }
            }
            "sin" => self.chain(x.sin(), x.cos(), x.sin().negative()),
            "cos" => self.chain(x.cos(), x.sin().negative(), x.cos().negative()),
            "tan" => self.apply("sin").over(self.apply("cos")),
            "asin" => {
                let left = Jet::number(1.0).value.minus(x.square());
                let root = left.sqrt();
                let cube = Interval { low: left.low.max(0.0), ..left }.times(root);
                self.chain(x.rising(-1.0, 1.0, libm::asin), root.inverse(), x.times(cube.inverse()))
            }
            "acos" => {
                let found = self.apply("asin").negative();
                Self { value: x.negative().rising(-1.0, 1.0, |x| libm::acos(-x)), ..found }
            }
            "atan" => {
                let inverse = ONE.plus(x.square()).inverse();
                let second = x.times(inverse.square()).times(number(-2.0));
                self.chain(all(libm::atan), inverse, second)
            }
            "sinh" => self.chain(all(libm::sinh), Self::cosh(x), all(libm::sinh)),
            "cosh" => self.chain(Self::cosh(x), all(libm::sinh), Self::cosh(x)),
            "tanh" => {
                let value = all(libm::tanh);
                let first = ONE.minus(value.square());
                self.chain(value, first, value.times(first).times(number(-2.0)))
            }
            "floor" | "ceil" => {
                let whole = if function == "floor" { f64::floor } else { f64::ceil };
                let value = Interval::new(whole(x.low), whole(x.high));
                if value.low == value.high {
                    Self::number(value.low)
                } else {
                    Self { value, first: WHOLE, second: WHOLE }
                }
            }
            _ => Self { value: WHOLE, first: WHOLE, second: WHOLE },
        }
    }

    fn cosh(x: Interval) -> Interval {
        let low = if x.has_zero() { 0.0 } else { x.low.abs().min(x.high.abs()) };
        Interval::rounded(libm::cosh(low), libm::cosh(x.size()), 4)
    }

    /// With derivatives that a rounded constant has changed by less than a float each.
    fn rounded(self) -> Self {
        let wider = |x: Interval| Interval::rounded(x.low, x.high, 1);
        Self { first: wider(self.first), second: wider(self.second), ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::super::formula::Formula;
    use super::*;

    /// Values, and differences of first and second order, lie within the enclosures over intervals of all sizes.
    #[test]
    fn formulas_and_their_derivatives_are_enclosed() {
        let texts = [
            "5 + v + 10*exp(-2*v)",
            "3 + tanh(4*v) - v^3/7",
            "abs(v - 0.7) + max(v, 0.4)*min(2*v, 1) + sign(v + 2)",
            "sqrt(1 + v^2)*cos(3*v) + sin(v)^2",
            "(v + 1)^1.5 + 2^v + (v + 2)^v",
            "ln(1 + v) + log10(2 + v) + atan(v)/(1 + v)",
            "asin(v/3) + acos(v/3) + tan(v/3) + sinh(v) - cosh(v/2)",
            "floor(v/10) + ceil(v/10 + 0.1) + v^-2*0 + (v - 1)^4",
        ];
        let mut tight = 0;
        for text in texts {
            let formula = Formula::new(text, "v").unwrap();
            for i in 0..200 {
                let low = 0.01 + 1.4 * f64::from(i) / 200.0;
                for length in [0.0, 1e-6, 1e-3, 0.05, 0.5] {
                    let high = low + length;
                    let jet = formula.jet(Interval::new(low, high));
                    let is_in =
                        |x: f64, of: Interval, doubt: f64| x >= of.low - doubt && x <= of.high + doubt;
                    let h = 1e-4;
                    for part in [0.0, 0.3, 0.5, 1.0] {
                        let x = low + part * length;
                        assert!(is_in(formula.at(x), jet.value, 0.0), "{text} at {x}: {jet:?}");
                        // Differences of points of the interval; their rounding is below 10⁻¹¹, and 10⁻⁷ of the second.
                        if part == 0.5 && length > 2.0 * h {
                            let [a, b, c] = [-h, 0.0, h].map(|by| formula.at(x + by));
                            assert!(is_in((c - a) / (2.0 * h), jet.first, 1e-11), "{text} at {x}: {jet:?}");
                            assert!(
                                is_in((c - 2.0 * b + a) / (h * h), jet.second, 1e-6),
                                "{text} at {x}: {jet:?}"
                            );
                        }
                    }
                    let span = jet.value.high - jet.value.low;
                    tight +=
                        usize::from(length < 1e-5 && span < 1e-4 && jet.first.high - jet.first.low < 1e-3);
                }
            }
        }
        assert!(tight > 2400, "{tight} enclosures of small intervals are narrow");
    }

    #[test]
    fn what_has_no_derivative_is_the_whole_line() {
        let jet =
            |text: &str, low: f64, high: f64| Formula::new(text, "v").unwrap().jet(Interval::new(low, high));
        assert_eq!(jet("abs(v)", -1.0, 2.0).second, WHOLE);
        assert_eq!(jet("abs(v)", -1.0, 2.0).first, Interval::new(-1.0, 1.0));
        assert_eq!(jet("sign(v)", -1.0, 2.0).first, WHOLE);
        assert_eq!(jet("sqrt(v)", 0.0, 1.0).first.high, f64::INFINITY);
        assert_eq!(jet("v^1.5", 0.0, 1.0).second.high, f64::INFINITY);
        assert!(jet("v^1.5", 0.0, 1.0).first.high < 1.51);
        assert_eq!(jet("1/v", -1.0, 1.0).value, WHOLE);
        assert_eq!(jet("ln(v - 5)", 0.0, 1.0).value, WHOLE);
    }
}
