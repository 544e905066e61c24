//! Quotients of polynomials, with the denominator kept as a product of factors.
//!
//! There are no greatest common divisors: a factor of the denominator is cancelled where it divides the
//! numerator. The numerator is then the claim of an identity without spurious factors, and the denominator
//! contains the quantities that must not vanish.

use super::polynomial::Polynomial;
use std::collections::BTreeMap;

#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Fraction {
    pub(crate) numerator: Polynomial,
    /// The nonconstant factors and their powers.
    pub(crate) denominator: BTreeMap<Polynomial, u32>,
}

fn expanded(factors: &BTreeMap<Polynomial, u32>) -> Polynomial {
    let mut product = Polynomial::int(1);
    for (factor, power) in factors {
        for _ in 0..*power {
            product = &product * factor;
        }
    }
    product
}

/// The product of the factors that `factors` lacks compared with `multiple`.
fn lacking(factors: &BTreeMap<Polynomial, u32>, multiple: &BTreeMap<Polynomial, u32>) -> Polynomial {
    let rest = multiple.iter().map(|(f, n)| (f.clone(), n - factors.get(f).copied().unwrap_or(0)));
    expanded(&rest.collect())
}

impl From<Polynomial> for Fraction {
    fn from(numerator: Polynomial) -> Self {
        Self { numerator, denominator: BTreeMap::new() }
    }
}

impl Fraction {
    pub(crate) fn int(n: i32) -> Self {
        Polynomial::int(n).into()
    }

    fn cancelled(mut self) -> Self {
        for (factor, power) in std::mem::take(&mut self.denominator) {
            let mut left = power;
            while let Some(quotient) = self.numerator.exact_quotient(&factor).filter(|_| left > 0) {
                self.numerator = quotient;
                left -= 1;
            }
            if left > 0 {
                self.denominator.insert(factor, left);
            }
        }
        self
    }

    pub(crate) fn plus(&self, other: &Self) -> Self {
        let mut denominator = self.denominator.clone();
        for (factor, power) in &other.denominator {
            let least = denominator.entry(factor.clone()).or_insert(0);
            *least = (*least).max(*power);
        }
        let a = &self.numerator * &lacking(&self.denominator, &denominator);
        let b = &other.numerator * &lacking(&other.denominator, &denominator);
        Self { numerator: &a + &b, denominator }.cancelled()
    }

    pub(crate) fn negated(&self) -> Self {
        Self { numerator: -&self.numerator, denominator: self.denominator.clone() }
    }

    pub(crate) fn minus(&self, other: &Self) -> Self {
        self.plus(&other.negated())
    }

    pub(crate) fn times(&self, other: &Self) -> Self {
        let mut denominator = self.denominator.clone();
        for (factor, power) in &other.denominator {
            *denominator.entry(factor.clone()).or_insert(0) += power;
        }
        Self { numerator: &self.numerator * &other.numerator, denominator }.cancelled()
    }

    /// `1/self`: the numerator becomes a product of its generators, the factors in `known` and the remainder.
    pub(crate) fn inverse(&self, known: &[Polynomial]) -> Self {
        assert!(!self.numerator.is_zero(), "division by zero");
        let (mut rest, mut denominator) = (self.numerator.clone(), BTreeMap::new());
        let generators: Vec<_> = rest.generators().into_iter().map(Polynomial::generator).collect();
        for factor in generators.iter().chain(known) {
            while let Some(quotient) = rest.exact_quotient(factor) {
                rest = quotient;
                *denominator.entry(factor.clone()).or_insert(0) += 1;
            }
        }
        let (_, lead) = rest.leading().unwrap();
        let unit = lead.recip();
        let monic = rest.scaled(&unit);
        if monic.as_constant().is_none() {
            denominator.insert(monic, 1);
        }
        Self { numerator: expanded(&self.denominator).scaled(&unit), denominator }.cancelled()
    }

    /// The numerator over the common multiple of both denominators: equal fractions have equal ones.
    pub(crate) fn over(&self, multiple: &BTreeMap<Polynomial, u32>) -> Polynomial {
        &self.numerator * &lacking(&self.denominator, multiple)
    }
}

#[test]
fn quotients_cancel() {
    let x = Fraction::from(Polynomial::generator(0));
    let one = Fraction::int(1);
    let (sum, difference) = (x.plus(&one), x.minus(&one));
    let quotient = x.times(&x).minus(&one).times(&sum.inverse(&[]));
    assert_eq!(quotient, difference);
    // 1/(x+1) + 1/(x−1) = 2x/((x+1)(x−1))
    let both = sum.inverse(&[]).plus(&difference.inverse(&[]));
    assert_eq!(both.numerator, x.plus(&x).numerator);
    assert_eq!(both.denominator.len(), 2);
    assert_eq!(x.plus(&x).times(&x.plus(&x).inverse(&[])), one);
}
