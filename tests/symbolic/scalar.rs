//! A number that is a formula, on which the library's own generic functions run.
//!
//! A [`Symbol`] is an index into an arena of rational functions over ℚ, so that it is `Copy` like the
//! library's other numbers. Generators are free, or the root of a rational function, or the sine or cosine of
//! an angle. If an angle is a linear combination of named angles with integer coefficients, its sine and
//! cosine follow from the addition theorems.

use super::angles::combination;
use super::fraction::Fraction;
use super::polynomial::Polynomial;
use num_rational::BigRational;
use std::cell::RefCell;
use std::collections::BTreeSet;
use stickslip::{Field, Real};

/// A rational function in the arena of this thread.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) struct Symbol(usize);

/// The definition of a generator.
#[derive(Clone)]
enum Rule {
    Free,
    /// The root of this fraction.
    Root(Fraction),
    /// The sine of an angle; the next generator is the cosine.
    Sine(Symbol),
    /// The cosine of an angle; the previous generator is the sine.
    Cosine(Symbol),
}

#[derive(Clone)]
pub(crate) struct Angle {
    pub(crate) size: Symbol,
    pub(crate) sine: Symbol,
    pub(crate) cosine: Symbol,
}

#[derive(Default)]
struct Arena {
    values: Vec<Fraction>,
    rules: Vec<(String, Rule)>,
    angles: Vec<Angle>,
    factors: Vec<Polynomial>,
    pi: Option<Symbol>,
}

thread_local! {
    static ARENA: RefCell<Arena> = RefCell::default();
}

fn arena<T>(f: impl FnOnce(&mut Arena) -> T) -> T {
    ARENA.with_borrow_mut(f)
}

pub(crate) fn stored(value: Fraction) -> Symbol {
    arena(|a| {
        a.values.push(value);
        Symbol(a.values.len() - 1)
    })
}

/// `1/of`, with its denominator in the factors known so far; new factors are added to them.
pub(crate) fn inverse(of: Symbol) -> Fraction {
    let known = arena(|a| a.factors.clone());
    let inverse = of.value().inverse(&known);
    arena(|a| a.factors.extend(inverse.denominator.keys().filter(|f| !known.contains(f)).cloned()));
    inverse
}

fn generator(name: String, rule: Rule) -> Symbol {
    let index = arena(|a| {
        a.rules.push((name, rule));
        a.rules.len() - 1
    });
    stored(Polynomial::generator(index).into())
}

/// Removes all symbols of this thread; each test starts with this call.
pub(crate) fn reset() {
    arena(|a| *a = Arena::default());
}

/// A free symbol.
pub(crate) fn free(name: &str) -> Symbol {
    generator(name.to_owned(), Rule::Free)
}

/// Names an angle with a sine and a cosine of its own.
pub(crate) fn angle(name: &str, size: Symbol) -> (Symbol, Symbol) {
    let sine = generator(format!("sin {name}"), Rule::Sine(size));
    let cosine = generator(format!("cos {name}"), Rule::Cosine(size));
    angle_with(size, sine, cosine);
    (sine, cosine)
}

/// Names an angle with the given sine and cosine.
pub(crate) fn angle_with(size: Symbol, sine: Symbol, cosine: Symbol) {
    arena(|a| a.angles.push(Angle { size, sine, cosine }));
}

pub(crate) fn named_angles() -> Vec<Angle> {
    arena(|a| a.angles.clone())
}

/// Adds a polynomial to the known factors of denominators.
pub(crate) fn factor(of: Symbol) {
    let polynomial = of.numerator();
    if polynomial.as_constant().is_none() {
        arena(|a| a.factors.push(polynomial));
    }
}

/// The relations of the generators that occur in `polynomials`, and of those that occur in the relations.
pub(crate) fn relations(polynomials: &[Polynomial]) -> Vec<Polynomial> {
    let (mut seen, mut found) = (BTreeSet::new(), Vec::new());
    let mut open: Vec<usize> = polynomials.iter().flat_map(Polynomial::generators).collect();
    while let Some(index) = open.pop() {
        if !seen.insert(index) {
            continue;
        }
        let square = |i| stored((&Polynomial::generator(i) * &Polynomial::generator(i)).into());
        let relation = match arena(|a| a.rules[index].1.clone()) {
            Rule::Free => continue,
            Rule::Root(of) => square(index) - stored(of),
            Rule::Sine(_) => square(index) + square(index + 1) - Symbol::int(1),
            Rule::Cosine(_) => {
                open.push(index - 1);
                continue;
            }
        };
        let relation = relation.value().numerator;
        open.extend(relation.generators());
        found.push(relation);
    }
    found
}

/// The polynomial as text.
pub(crate) fn written(polynomial: &Polynomial) -> String {
    let names = arena(|a| a.rules.iter().map(|(name, _)| name.clone()).collect::<Vec<_>>());
    let term = |(e, c): (&Vec<u32>, &BigRational)| {
        let powers = e.iter().enumerate().filter(|(_, n)| **n > 0);
        let powers = powers
            .map(|(i, n)| format!("·[{}]{}", names[i], if *n > 1 { format!("^{n}") } else { String::new() }));
        format!("({c}){}", powers.collect::<String>())
    };
    let terms: Vec<_> = polynomial.terms().map(term).collect();
    if terms.is_empty() { "0".to_owned() } else { terms.join(" + ") }
}

impl Symbol {
    pub(crate) fn value(self) -> Fraction {
        arena(|a| a.values[self.0].clone())
    }

    /// The numerator: it is zero where the symbol is, if the denominator is not.
    pub(crate) fn numerator(self) -> Polynomial {
        self.value().numerator
    }

    /// The factors of the denominator, which must not vanish.
    pub(crate) fn denominator(self) -> Vec<Polynomial> {
        self.value().denominator.into_keys().collect()
    }

    pub(crate) fn is_zero(self) -> bool {
        self.numerator().is_zero()
    }

    /// The index of the only generator of the symbol.
    fn index(self) -> usize {
        let value = self.value();
        let mut generators = value.numerator.generators().into_iter();
        let index = generators.next().unwrap();
        assert_eq!(value, Polynomial::generator(index).into(), "not a generator");
        index
    }

    /// The derivative with respect to a free symbol, through roots and angles.
    pub(crate) fn derivative(self, by: Symbol) -> Symbol {
        let Fraction { numerator, denominator } = self.value();
        let divisor = denominator.iter().fold(Fraction::int(1), |product, (factor, power)| {
            (0..*power).fold(product, |p, _| p.times(&factor.clone().into()))
        });
        let (n, d) = (stored(numerator.clone().into()), stored(divisor.clone()));
        let slope = |p: &Polynomial| {
            p.generators().into_iter().fold(Symbol::int(0), |sum, index| {
                sum + stored(p.partial(index).into()) * generator_slope(index, by)
            })
        };
        (slope(&numerator) * d - n * slope(&divisor.numerator)) / (d * d)
    }
}

/// The derivative of a generator with respect to a free symbol.
fn generator_slope(index: usize, by: Symbol) -> Symbol {
    let itself = stored(Polynomial::generator(index).into());
    let neighbour = |i| stored(Polynomial::generator(i).into());
    match arena(|a| a.rules[index].1.clone()) {
        Rule::Free => Symbol::int(i32::from(by.index() == index)),
        Rule::Root(of) => stored(of).derivative(by) / (Symbol::int(2) * itself),
        Rule::Sine(size) => neighbour(index + 1) * size.derivative(by),
        Rule::Cosine(size) => -(neighbour(index - 1) * size.derivative(by)),
    }
}

impl std::fmt::Debug for Symbol {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Fraction { numerator, denominator } = self.value();
        write!(f, "{}", written(&numerator))?;
        denominator.iter().try_for_each(|(factor, power)| write!(f, " / ({})^{power}", written(factor)))
    }
}

impl Field for Symbol {
    fn int(n: i32) -> Self {
        stored(Fraction::int(n))
    }

    /// A generator whose square is `self`; the sign of the root is left open.
    fn sqrt(self) -> Self {
        let of = self.value();
        let known = arena(|a| a.rules.iter().position(|(_, rule)| matches!(rule, Rule::Root(f) if *f == of)));
        match known {
            Some(index) => stored(Polynomial::generator(index).into()),
            None => generator(format!("√({self:?})"), Rule::Root(of)),
        }
    }

    fn abs(self) -> Self {
        (self * self).sqrt()
    }
}

impl Real for Symbol {
    /// π is a free generator; the angle π/2 has the sine 1 and the cosine 0.
    fn pi() -> Self {
        if let Some(pi) = arena(|a| a.pi) {
            return pi;
        }
        let pi = free("π");
        arena(|a| a.pi = Some(pi));
        angle_with(pi / Self::int(2), Self::int(1), Self::int(0));
        pi
    }

    fn sin_cos(self) -> (Self, Self) {
        let mut result = (Self::int(0), Self::int(1));
        for (n, angle) in combination(self) {
            let sine = if n < 0 { -angle.sine } else { angle.sine };
            for _ in 0..n.abs() {
                let (s, c) = result;
                result = (s * angle.cosine + c * sine, c * angle.cosine - s * sine);
            }
        }
        result
    }

    fn tan(self) -> Self {
        let (s, c) = self.sin_cos();
        s / c
    }

    /// A new angle with the sine `self/h` and the cosine `x/h`, h² = self² + x².
    fn atan2(self, x: Self) -> Self {
        let (size, h) = (free("atan2"), self.hypot(x));
        angle_with(size, self / h, x / h);
        size
    }

    fn mul_add(self, a: Self, b: Self) -> Self {
        self * a + b
    }
}

#[test]
fn addition_theorems_and_derivatives() {
    reset();
    let (x, y) = (free("x"), free("y"));
    let ((sx, cx), (sy, cy)) = (angle("x", x), angle("y", y));
    let (s, c) = (x - y + Symbol::pi()).sin_cos();
    assert_eq!((s + (sx * cy - cx * sy)).value(), Fraction::int(0));
    assert_eq!((c + (cx * cy + sx * sy)).value(), Fraction::int(0));
    assert_eq!((x + x).sin_cos().0.value(), (Symbol::int(2) * sx * cx).value());
    // d(sin x cos x)/dx = cos² − sin², d√(x + y)/dx = 1/(2√(x + y)), d(1/x)/dx = −1/x².
    assert!(((sx * cx).derivative(x) - (cx * cx - sx * sx)).is_zero());
    let root = (x + y).sqrt();
    assert!((root.derivative(x) - Symbol::int(1) / (Symbol::int(2) * root)).is_zero());
    assert!(((Symbol::int(1) / x).derivative(x) + Symbol::int(1) / (x * x)).is_zero());
    let relation = &relations(&[root.numerator()])[0];
    assert_eq!(*relation, (root * root - x - y).numerator());
    assert_eq!(relations(&[cx.numerator()]).len(), 1);
}

#[test]
#[should_panic(expected = "not a combination")]
fn the_sine_of_an_unknown_angle_is_refused() {
    reset();
    let _ = (free("x") * free("y")).sin_cos();
}
