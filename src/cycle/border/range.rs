//! Where the exact border lies over a range of frequency ratios.

use super::Border;
use super::lobe::Lobe;
use crate::cycle::phase_function::PhaseFunction;
use crate::float::Float;
use crate::machine::error::{Error, Quantity, written};

/// Where the border lies over a range of frequency ratios.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct BorderRange<F> {
    /// The least value in the range.
    pub(crate) least: F,
    /// The greatest value in the range; `None` where a pole lies in it.
    pub(crate) greatest: Option<F>,
}

/// The least and the greatest value of the exact border for `low ≤ Ω ≤ high`.
///
/// Complete, because a lobe has no other minimum than its own and no maximum inside, and the minima grow with
/// the index: the least is at an end, or the minimum of the uppermost lobe or of the one below.
///
/// # Errors
/// Where an end is outside the domain of [`Lobe::containing`], or `low > high`.
pub(crate) fn border_range<F: Float>(low: F, high: F) -> Result<BorderRange<F>, Error> {
    let (first, last) = ordered_lobes(low, high)?;
    let at = |omega| Border::at(&PhaseFunction::of_valid(omega)).min_force_ratio;
    let (a, b) = (at(low), at(high));
    let mut least = if a < b { a } else { b };
    for lobe in [Some(last), last.below()].into_iter().flatten() {
        let minimum = lobe.minimum::<F>();
        if minimum.omega > low && minimum.omega < high && minimum.force_ratio < least {
            least = minimum.force_ratio;
        }
    }
    Ok(BorderRange { least, greatest: (first == last).then(|| a.or_larger(b)) })
}

/// The lobes of the ends of a range of frequency ratios.
pub(crate) fn ordered_lobes<F: Float>(low: F, high: F) -> Result<(Lobe, Lobe), Error> {
    let lobes = (Lobe::containing(low)?, Lobe::containing(high)?);
    if low <= high {
        Ok(lobes)
    } else {
        Err(Error::EmptyRange { quantity: Quantity::FrequencyRatio, low: written(low), high: written(high) })
    }
}

#[cfg(test)]
mod tests {
    use super::border_range;
    use crate::Error;
    use crate::cycle::border::tests::{at, close};

    #[test]
    fn the_range_of_the_border() {
        let whole = border_range(0.34, 3.0).unwrap();
        close(whole.least, 1.209_998_436_338_07, 8.0);
        assert_eq!(whole.greatest, Some(at(0.34)));
        assert_eq!(border_range(0.3, 0.34).unwrap().greatest, None);
        // The ranges: decreasing, increasing, with a minimum, over a pole, over a whole lobe.
        for (low, high) in
            [(0.5, 0.6), (0.9, 2.0), (0.26, 0.31), (0.29, 0.345), (0.18, 0.34), (0.19, 0.2), (0.7, 0.7)]
        {
            let range = border_range::<f64>(low, high).unwrap();
            let scan = || (0..=20_000).map(|i| at(low + (high - low) * f64::from(i) / 20_000.0));
            let least = scan().fold(f64::INFINITY, f64::min);
            assert!(range.least <= least && range.least > least * (1.0 - 1e-3), "{low} {high}");
            if let Some(greatest) = range.greatest {
                close(scan().fold(0.0, f64::max), greatest, 4.0);
            }
        }
        assert!(matches!(border_range(0.6, 0.5), Err(Error::EmptyRange { .. })));
    }
}
