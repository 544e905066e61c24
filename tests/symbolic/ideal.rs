//! Decides whether a polynomial follows from others, and finds the cofactors that prove it.
//!
//! `groebner` finds the cofactors. [`super::polynomial`], which shares no code with it, verifies them by one
//! expansion.

use super::polynomial::{Polynomial, rational, trimmed};
use super::scalar::{Symbol, relations, written};
use groebner::{LiftBasis, Monomial, MonomialOrder};
use num_rational::BigRational;
use std::collections::{BTreeMap, BTreeSet};

/// Hypotheses, prepared for many claims.
pub(crate) struct Ideal {
    generators: Vec<Polynomial>,
    indices: Vec<usize>,
    lift: LiftBasis<BigRational>,
}

/// `claim = Σ cofactor · generator`.
pub(crate) struct Certificate {
    pub(crate) generators: Vec<Polynomial>,
    pub(crate) cofactors: Vec<Polynomial>,
}

impl Certificate {
    /// Verifies the certificate by one expansion: the products sum to the claim.
    pub(crate) fn shows(&self, claim: &Polynomial) -> bool {
        let products = self.generators.iter().zip(&self.cofactors).map(|(g, h)| g * h);
        products.fold(Polynomial::zero(), |sum, p| &sum + &p) == *claim
    }
}

type Dense = groebner::Polynomial<BigRational>;

fn to_dense(p: &Polynomial, indices: &[usize]) -> Dense {
    let exponents =
        |e: &Vec<u32>| indices.iter().map(|i| e.get(*i).copied().unwrap_or(0)).collect::<Vec<_>>();
    let terms = p.terms().map(|(e, c)| (Monomial::new(exponents(e)), c.clone())).collect();
    Dense::new(terms, indices.len(), MonomialOrder::GRevLex)
}

fn from_dense(p: &Dense, indices: &[usize]) -> Polynomial {
    let width = indices.iter().max().map_or(0, |i| i + 1);
    Polynomial::from_terms(p.terms.iter().map(|(m, c)| {
        let mut exponents = vec![0; width];
        for (i, e) in indices.iter().zip(m.exps()) {
            exponents[*i] = *e;
        }
        (exponents, c.clone())
    }))
}

/// The numerators and the factors of the denominators.
fn mentioned<'a>(symbols: impl Iterator<Item = &'a Symbol>) -> Vec<Polynomial> {
    symbols.flat_map(|s| std::iter::once(s.numerator()).chain(s.denominator())).collect()
}

impl Ideal {
    /// The ideal of the numerators of `hypotheses`, with the relations of all their generators and of those
    /// of `others`.
    pub(crate) fn new(hypotheses: &[Symbol], others: &[Symbol]) -> Self {
        let mut generators: Vec<Polynomial> = hypotheses.iter().map(|h| h.numerator()).collect();
        let all = mentioned(hypotheses.iter().chain(others));
        generators.extend(relations(&all));
        Self::of(generators, &all)
    }

    /// The ideal of the hypotheses alone.
    pub(crate) fn without_relations(hypotheses: &[Symbol], others: &[Symbol]) -> Self {
        let generators: Vec<Polynomial> = hypotheses.iter().map(|h| h.numerator()).collect();
        Self::of(generators, &mentioned(hypotheses.iter().chain(others)))
    }

    fn of(generators: Vec<Polynomial>, all: &[Polynomial]) -> Self {
        let used: BTreeSet<usize> = all.iter().chain(&generators).flat_map(Polynomial::generators).collect();
        let indices: Vec<usize> = used.into_iter().collect();
        let dense: Vec<Dense> = generators.iter().map(|g| to_dense(g, &indices)).collect();
        let lift = LiftBasis::new(&dense).unwrap();
        Self { generators, indices, lift }
    }

    /// The certificate that `claim` vanishes where the hypotheses do; `None` if it is not in the ideal.
    ///
    /// Free generators that occur in no hypothesis act as coefficients: the factor of each of their powers is
    /// lifted separately.
    pub(crate) fn certificate(&self, claim: &Polynomial) -> Option<Certificate> {
        let (mut parts, known) =
            (BTreeMap::<Vec<u32>, Polynomial>::new(), |i: &usize| self.indices.contains(i));
        let outside: Vec<Polynomial> =
            claim.generators().into_iter().filter(|i| !known(i)).map(Polynomial::generator).collect();
        assert!(
            relations(&outside).is_empty(),
            "{} has generators with relations not in the ideal",
            written(claim)
        );
        for (exponents, c) in claim.terms() {
            let part = |inside: bool| {
                let kept =
                    exponents.iter().enumerate().map(|(i, e)| if known(&i) == inside { *e } else { 0 });
                trimmed(kept.collect())
            };
            let term = Polynomial::from_terms([(part(true), c.clone())]);
            let sum = parts.entry(part(false)).or_insert_with(Polynomial::zero);
            *sum = &*sum + &term;
        }
        let mut cofactors = vec![Polynomial::zero(); self.generators.len()];
        for (power, part) in parts {
            let times = Polynomial::from_terms([(power, rational(1))]);
            for (sum, h) in
                cofactors.iter_mut().zip(self.lift.lift(&to_dense(&part, &self.indices)).unwrap()?)
            {
                *sum = &*sum + &(&times * &from_dense(&h, &self.indices));
            }
        }
        let certificate = Certificate { generators: self.generators.clone(), cofactors };
        assert!(certificate.shows(claim), "a certificate that does not expand to its claim");
        Some(certificate)
    }

    /// Whether the numerator of `claim` is in the ideal, with a certificate.
    pub(crate) fn holds(&self, claim: Symbol) -> bool {
        self.certificate(&claim.numerator()).is_some()
    }

    /// Asserts that `claim` is in the ideal, and that it is not if the sign of any one term is changed.
    pub(crate) fn assert_exactly(&self, name: &str, claim: Symbol) {
        let claim = claim.numerator();
        assert!(self.certificate(&claim).is_some(), "eq. {name} does not follow: {}", written(&claim));
        for (exponents, _) in claim.terms() {
            let mutant = claim.with_sign_flipped(exponents);
            assert!(
                self.certificate(&mutant).is_none(),
                "eq. {name} follows in a wrong form too: {}",
                written(&mutant)
            );
        }
    }
}
