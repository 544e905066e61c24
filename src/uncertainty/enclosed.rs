//! Ranges in ball arithmetic: every output over a box of ratios or of machines, the rounding of the formulae
//! included.

mod machine;
mod parts;
mod verdict;

use super::ratios::RatioBox;
use super::{Evidence, Interval, Range};
use crate::cycle::regime::{Regime as Decided, Verdict};
use crate::enclosed::{self, Enclosure, KnownRatios, Regime, Response};
use crate::float::Float;
use crate::machine::error::Error;
use crate::machine::excitation::Excitation;
use crate::output::Output;
use parts::{Ends, Over};
use rug::Rational;
use rug::float::Round;

/// Bits of the balls: the box widens them far more than rounding does.
const BITS: u32 = 64;

impl<F: Float> RatioBox<F> {
    /// [`super::ParameterBox::enclosed`].
    pub(super) fn enclosed(&self, output: Output, pieces: u32) -> Result<Option<Range<F>>, Error> {
        let Some([omega, alpha, zeta]) = self.ends() else { return Ok(None) };
        // The border does not depend on α.
        let is_of_border = !output.is_of_cycle() && output != Output::Margin;
        let alpha = if is_of_border { (alpha.0.clone(), alpha.0) } else { alpha };
        let found = parts::range(vec![omega, alpha, zeta], pieces, |part| of_ratios(output, part))?;
        Ok(found.map(guaranteed))
    }

    /// The verdict from the margin in ball arithmetic; where that may lie on either side of 1, the box is cut into at most
    /// `pieces` parts.
    pub(super) fn enclosed_verdict(&self, pieces: u32) -> Result<Verdict<F>, Error> {
        let Some([omega, alpha, zeta]) = self.ends() else {
            return Ok(Verdict::Undecided(Decided::Sticking, Decided::NonSticking));
        };
        verdict::by_margin([&omega, &alpha, &zeta], || {
            let whole = vec![omega.clone(), alpha.clone(), zeta.clone()];
            parts::is_above_one(whole, pieces, |part| of_ratios(Output::Margin, part))
        })
    }

    /// The intervals of Ω, α and ζ.
    fn ends(&self) -> Option<[Ends; 3]> {
        Some([ends(self.omega)?, ends(self.alpha)?, ends(self.damping_ratio)?])
    }
}

/// The values of an output for Ω, α and ζ in these intervals.
fn of_ratios(output: Output, part: &[Ends]) -> Result<Over, Error> {
    let [omega, alpha, zeta] = part else { return Ok(Over::Undecided) };
    let found = response(output, [omega, alpha, zeta], None)?;
    Ok(over(output, &found, Enclosure::ends))
}

/// The closed forms for Ω, α and ζ in these intervals, under an excitation.
fn response(output: Output, ratios: [&Ends; 3], excitation: Option<Excitation>) -> Result<Response, Error> {
    let [omega, alpha, zeta] = ratios.map(|(low, high)| enclosed::Known::of_ends(low.clone(), high.clone()));
    let ratios = KnownRatios::new(&omega).with_force_ratio(&alpha).with_damping_ratio(&zeta);
    enclosed::response_for(output, &ratios, excitation, BITS)
}

/// The values of an output from the closed forms over a part of a box; `to` bounds an enclosure.
fn over(output: Output, found: &Response, to: impl Fn(&Enclosure) -> Option<Ends>) -> Over {
    let exists = match found.regime {
        Some(Regime::NonSticking) => true,
        Some(_) if output.is_of_cycle() => return Over::Nowhere,
        _ => !output.is_of_cycle(),
    };
    let values = found.get(output).filter(|_| exists).and_then(to);
    values.map_or(Over::Undecided, Over::Values)
}

/// The ends as rational numbers. An end that is no f64 is moved outwards by a unit in the last place.
fn ends<F: Float>(interval: Interval<F>) -> Option<Ends> {
    let (low, high) = (interval.low.to_f64(), interval.high.to_f64());
    let low = if F::from_f64(low) == interval.low { low } else { low.next_down() };
    let high = if F::from_f64(high) == interval.high { high } else { high.next_up() };
    Some((Rational::from_f64(low)?, Rational::from_f64(high)?))
}

fn guaranteed<F: Float>((low, high): Ends) -> Range<F> {
    Range { low: rounded(&low, -1), high: rounded(&high, 1), evidence: Evidence::Guaranteed { sharp: false } }
}

/// The nearest number of the type below (−1) or above (1), or one slightly farther out.
fn rounded<F: Float>(x: &Rational, side: i32) -> F {
    let round = if side < 0 { Round::Down } else { Round::Up };
    let bound = rug::Float::with_val_round(53, x, round).0.to_f64();
    let found = F::from_f64(bound);
    // A type with fewer digits has rounded a second time.
    let is_inside = if side < 0 { found.to_f64() > bound } else { found.to_f64() < bound };
    if is_inside { found + F::int(side) * F::epsilon() * found.abs() } else { found }
}

#[cfg(test)]
mod tests {
    use super::{Rational, rounded};
    use crate::Float;

    /// The ends lie outside also in a type with fewer digits than f64, which rounds a second time.
    #[test]
    fn the_rounded_ends_lie_outside() {
        fn check<F: Float>(x: &Rational) {
            let (low, high) = (rounded::<F>(x, -1), rounded::<F>(x, 1));
            let exact = |x: F| Rational::from_f64(x.to_f64()).unwrap();
            assert!(exact(low) <= *x && *x <= exact(high), "{x} {low} {high}");
            assert!(high - low <= F::int(4) * F::epsilon() * high.abs(), "{x} {low} {high}");
        }
        for numerator in 1..200 {
            for denominator in [3, 7, 1 << 25, (1 << 30) - 1] {
                for x in [Rational::from((numerator, denominator)), Rational::from((-numerator, denominator))]
                {
                    check::<f32>(&x);
                    check::<f64>(&x);
                }
            }
        }
    }
}
