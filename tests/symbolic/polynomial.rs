//! Exact polynomials over ℚ, with the operations needed to expand a certificate.

use num_rational::BigRational;
use num_traits::{FromPrimitive, One, Zero};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::{Add, Mul, Neg, Sub};

/// Exponents of the generators, without trailing zeros, so that their order as vectors is lexicographic.
pub(crate) type Exponents = Vec<u32>;

/// A sum of monomials with nonzero rational coefficients.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Polynomial(BTreeMap<Exponents, BigRational>);

pub(crate) fn rational(n: i32) -> BigRational {
    BigRational::from_i32(n).unwrap()
}

pub(crate) fn trimmed(mut exponents: Exponents) -> Exponents {
    while exponents.last() == Some(&0) {
        exponents.pop();
    }
    exponents
}

/// The product of two monomials.
fn product(a: &[u32], b: &[u32]) -> Exponents {
    let at = |e: &[u32], i| e.get(i).copied().unwrap_or(0);
    (0..a.len().max(b.len())).map(|i| at(a, i) + at(b, i)).collect()
}

/// The quotient of two monomials, where b divides a.
fn quotient(a: &[u32], b: &[u32]) -> Option<Exponents> {
    if b.len() > a.len() {
        return None;
    }
    let exponents = a.iter().enumerate().map(|(i, e)| e.checked_sub(b.get(i).copied().unwrap_or(0)));
    exponents.collect::<Option<_>>().map(trimmed)
}

impl Polynomial {
    pub(crate) fn zero() -> Self {
        Self(BTreeMap::new())
    }

    pub(crate) fn constant(c: BigRational) -> Self {
        Self::zero().plus_term(Vec::new(), c)
    }

    pub(crate) fn int(n: i32) -> Self {
        Self::constant(rational(n))
    }

    /// The generator with this index.
    pub(crate) fn generator(index: usize) -> Self {
        let mut exponents = vec![0; index];
        exponents.push(1);
        Self::zero().plus_term(exponents, BigRational::one())
    }

    pub(crate) fn from_terms(terms: impl IntoIterator<Item = (Exponents, BigRational)>) -> Self {
        terms.into_iter().fold(Self::zero(), |sum, (e, c)| sum.plus_term(trimmed(e), c))
    }

    fn plus_term(mut self, exponents: Exponents, c: BigRational) -> Self {
        let old = self.0.remove(&exponents).unwrap_or_else(BigRational::zero);
        let sum = old + c;
        if !sum.is_zero() {
            self.0.insert(exponents, sum);
        }
        self
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    pub(crate) fn terms(&self) -> impl Iterator<Item = (&Exponents, &BigRational)> {
        self.0.iter()
    }

    /// The greatest term in lexicographic order.
    pub(crate) fn leading(&self) -> Option<(&Exponents, &BigRational)> {
        self.0.last_key_value()
    }

    pub(crate) fn coefficient(&self, exponents: &[u32]) -> BigRational {
        self.0.get(exponents).cloned().unwrap_or_else(BigRational::zero)
    }

    /// The value of a polynomial without generators.
    pub(crate) fn as_constant(&self) -> Option<BigRational> {
        self.0.keys().all(Vec::is_empty).then(|| self.coefficient(&[]))
    }

    /// The generators that occur in the polynomial.
    pub(crate) fn generators(&self) -> BTreeSet<usize> {
        let indices = self.0.keys().flat_map(|e| e.iter().enumerate().filter(|(_, n)| **n > 0));
        indices.map(|(i, _)| i).collect()
    }

    pub(crate) fn scaled(&self, c: &BigRational) -> Self {
        Self::from_terms(self.0.iter().map(|(e, a)| (e.clone(), a * c)))
    }

    /// The partial derivative with respect to one generator.
    pub(crate) fn partial(&self, index: usize) -> Self {
        let terms = self.0.iter().filter_map(|(e, c)| {
            let n = e.get(index).copied().filter(|n| *n > 0)?;
            let mut lower = e.clone();
            lower[index] -= 1;
            Some((lower, c * BigRational::from_u32(n).unwrap()))
        });
        Self::from_terms(terms)
    }

    /// `self/divisor`, if there is no remainder.
    pub(crate) fn exact_quotient(&self, divisor: &Self) -> Option<Self> {
        let (lead, c) = divisor.leading()?;
        let (mut rest, mut result) = (self.clone(), Self::zero());
        while let Some((e, a)) = rest.leading() {
            let term = Self::from_terms([(quotient(e, lead)?, a / c)]);
            rest = &rest - &(&term * divisor);
            result = &result + &term;
        }
        Some(result)
    }

    /// The same polynomial with the sign of one term changed, as by a writing error.
    pub(crate) fn with_sign_flipped(&self, exponents: &[u32]) -> Self {
        Self::from_terms(
            self.0.iter().map(|(e, c)| (e.clone(), if e == exponents { -c.clone() } else { c.clone() })),
        )
    }
}

impl Add for &Polynomial {
    type Output = Polynomial;
    fn add(self, other: Self) -> Polynomial {
        other.0.iter().fold(self.clone(), |sum, (e, c)| sum.plus_term(e.clone(), c.clone()))
    }
}

impl Neg for &Polynomial {
    type Output = Polynomial;
    fn neg(self) -> Polynomial {
        self.scaled(&rational(-1))
    }
}

impl Sub for &Polynomial {
    type Output = Polynomial;
    fn sub(self, other: Self) -> Polynomial {
        self + &-other
    }
}

impl Mul for &Polynomial {
    type Output = Polynomial;
    fn mul(self, other: Self) -> Polynomial {
        let mut sum = Polynomial::zero();
        for (a, x) in &self.0 {
            for (b, y) in &other.0 {
                sum = sum.plus_term(product(a, b), x * y);
            }
        }
        sum
    }
}

#[test]
fn arithmetic_of_small_polynomials() {
    let (x, y) = (Polynomial::generator(0), Polynomial::generator(1));
    let (sum, difference) = (&x + &y, &x - &y);
    let squares = &(&x * &x) - &(&y * &y);
    assert_eq!(&sum * &difference, squares);
    assert_eq!(squares.exact_quotient(&sum), Some(difference));
    assert_eq!(squares.exact_quotient(&x), None);
    assert_eq!(squares.partial(1), y.scaled(&rational(-2)));
    assert_eq!(squares.with_sign_flipped(&[0, 2]), &(&x * &x) + &(&y * &y));
    assert!((&x - &x).is_zero() && Polynomial::int(3).as_constant() == Some(rational(3)));
    assert_eq!(squares.generators(), [0, 1].into());
}
