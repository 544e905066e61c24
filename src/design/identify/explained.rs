//! Whether a fit explains a curve: more of its amplitudes than one amplitude for all frequencies does.

use super::outliers::Judged;
use super::search::ResponseCurve;
use core::iter::zip;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// The noise up to which a fit explains a curve, whatever else does: of the amplitudes, and of the phases in radians.
const LITTLE: [f64; 2] = [0.1, 0.5];
/// The quantile 90 % of the normal distribution.
const CHANCE: f64 = 1.28;

/// Whether the amplitudes of a curve, those that count, are no nearer to a fit than to one amplitude for all frequencies, but
/// for chance.
///
/// The sums of the squares of the relative deviations are compared: of the fit, with two parameters, and of the amplitude
/// `Σ(1/a) / Σ(1/a²)`, whose sum is least. The fit explains something where the ratio of the mean squares is beyond the
/// 90 % quantile of F, whose logarithm is nearly normal. White noise is not beyond it; a resonance is, with noise of a fifth
/// of its height.
pub(super) fn is_unexplained(curve: &ResponseCurve<'_>, found: &Judged) -> bool {
    let [amplitudes, phases] = curve.counts();
    let [noise, phase_noise] = found.noise;
    if noise <= LITTLE[0] || phases > 0 && phase_noise <= LITTLE[1] {
        return false;
    }
    let counted = || {
        let all = zip(curve.points, zip(&found.fit.residuals, &found.suspect)).take(amplitudes);
        all.filter(|(_, (_, is_suspect))| !**is_suspect).map(|(point, (r, _))| (point.measured, *r))
    };
    let count = counted().count() as f64;
    let (once, twice) = counted()
        .fold((0.0, 0.0), |(once, twice): (f64, f64), (a, _)| (once + a.recip(), twice + a.powi(-2)));
    let level = once / twice;
    let of_fit: f64 = counted().map(|(_, r)| r * r).sum();
    let of_level: f64 = counted().map(|(a, _)| (1.0 - level / a).powi(2)).sum();
    let [of_fit_freedom, of_level_freedom] = [(count - 2.0).max(1.0), count - 1.0];
    let ratio = (of_level / of_level_freedom) / (of_fit / of_fit_freedom);
    let spread = (2.0 / (of_fit_freedom - 1.0).max(1.0) + 2.0 / (of_level_freedom - 1.0).max(1.0)).sqrt();
    ratio.is_nan() || ratio.ln() <= CHANCE * spread
}
