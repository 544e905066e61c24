//! An angle as a linear combination of the named ones.

use super::polynomial::Polynomial;
use super::scalar::{Angle, Symbol, named_angles};
use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};

/// The coefficients of the named angles in this one.
pub(crate) fn combination(size: Symbol) -> Vec<(i32, Angle)> {
    let angles = named_angles();
    let mut common = size.value().denominator;
    for angle in &angles {
        for (factor, power) in angle.size.value().denominator {
            let least = common.entry(factor).or_insert(0);
            *least = (*least).max(power);
        }
    }
    // Row echelon form of the angles over the common denominator; each row keeps its combination.
    let mut rows: Vec<(Polynomial, Vec<BigRational>)> = Vec::new();
    let reduce = |mut p: Polynomial, mut of: Vec<BigRational>, rows: &[(Polynomial, Vec<BigRational>)]| {
        for (row, parts) in rows {
            let (lead, c) = row.leading().unwrap();
            let times = p.coefficient(lead) / c;
            p = &p - &row.scaled(&times);
            of = of.iter().zip(parts).map(|(a, b)| a - b * &times).collect();
        }
        (p, of)
    };
    for (i, angle) in angles.iter().enumerate() {
        let mut unit = vec![BigRational::zero(); angles.len()];
        unit[i] = BigRational::one();
        let (p, of) = reduce(angle.size.value().over(&common), unit, &rows);
        assert!(!p.is_zero(), "the named angles are independent");
        rows.push((p, of));
    }
    let (rest, of) = reduce(size.value().over(&common), vec![BigRational::zero(); angles.len()], &rows);
    assert!(rest.is_zero(), "{size:?} is not a combination of the named angles");
    let whole =
        |c: &BigRational| (-c).to_integer().to_i32().filter(|n| *c == BigRational::from_integer((-n).into()));
    of.iter().zip(angles).map(|(c, angle)| (whole(c).expect("an integer combination"), angle)).collect()
}
