//! Ranges by sampling: every corner of a box, its middle, and points spread over it.

use super::{Evidence, Range};
use crate::float::Float;
use crate::machine::error::Error;

/// The least and the greatest value of a function of N shares in [0, 1], of which the first few are varied;
/// `None` where the function exists at no point.
///
/// The points are all corners, the middle, and `points` more: `frac(1/2 + i √p)` with a prime p for each
/// share, a sequence that fills the box evenly and is the same in every run.
pub(super) fn range<F: Float, const N: usize>(
    (points, varied): (u32, usize),
    mut f: impl FnMut([F; N]) -> Result<Option<F>, Error>,
) -> Result<Option<Range<F>>, Error> {
    const PRIMES: [i32; 8] = [2, 3, 5, 7, 11, 13, 17, 19];
    let (zero, one, half) = (F::int(0), F::int(1), F::ratio(1, 2));
    let mut ends: Option<(F, F)> = None;
    let (mut looked_at, mut existing) = (0, 0);
    let mut look = |shares: [F; N]| -> Result<(), Error> {
        looked_at = u32::saturating_add(looked_at, 1);
        if let Some(y) = f(shares)? {
            existing = u32::saturating_add(existing, 1);
            ends = Some(match ends {
                None => (y, y),
                Some((low, high)) => (if y < low { y } else { low }, high.or_larger(y)),
            });
        }
        Ok(())
    };
    for corner in 0..1_u32 << varied {
        look(core::array::from_fn(|i| if corner >> i & 1 == 1 { one } else { zero }))?;
    }
    look([half; N])?;
    let steps: [F; N] = core::array::from_fn(|i| PRIMES.get(i).map_or(half, |&p| fraction(F::int(p).sqrt())));
    let mut shares = [half; N];
    for _ in 0..points {
        for (share, &step) in shares.iter_mut().zip(&steps) {
            *share = fraction(*share + step);
        }
        look(shares)?;
    }
    let evidence = Evidence::Sampled { points: looked_at, existing };
    Ok(ends.map(|(low, high)| Range { low, high, evidence }))
}

fn fraction<F: Float>(x: F) -> F {
    x - x.floor()
}

#[cfg(test)]
mod tests {
    use super::{Evidence, range};

    #[test]
    fn corners_the_middle_and_points_between() {
        let mut seen: Vec<[f64; 2]> = Vec::new();
        let found = range((50, 2), |shares: [f64; 2]| {
            seen.push(shares);
            Ok((shares[0] < 0.9).then_some(shares[0] - shares[1]))
        });
        let found = found.unwrap().unwrap();
        let values = || seen.iter().filter(|s| s[0] < 0.9).map(|s| s[0] - s[1]);
        assert_eq!((found.low, found.high), (-1.0, values().fold(0.0, f64::max)));
        assert_eq!(seen[..5], [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0], [0.5, 0.5]]);
        for (i, shares) in seen[5..].iter().enumerate() {
            for (share, prime) in shares.iter().zip([2.0f64, 3.0]) {
                assert!((share - (0.5 + (i + 1) as f64 * prime.sqrt()).fract()).abs() < 1e-12, "{i}");
            }
        }
        assert_eq!(found.evidence, Evidence::Sampled { points: 55, existing: values().count() as u32 });
        assert_eq!(range((9, 1), |_: [f64; 1]| Ok(None)), Ok(None));
    }
}
