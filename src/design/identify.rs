//! Friction and damping from a measured response curve, by least squares that are robust to wrong values.
//!
//! With known mass, stiffness and force amplitude, the steady motion at a frequency depends on κ = r_y/p₀ and ζ
//! alone. Where the body slides throughout it is the closed form, in the symbols of `docs/development/theory/damping.md`
//!
//! ```text
//! Δ₀ = (p₀/k) [√(1 − κ²K²)/q − κG],   ω_d t₂ = δ + atan2(√(1 − κ²K²), κK),
//! ```
//!
//! and where it stops the exact motion (`model`). Both meet at the border, so that the sum of squares is
//! continuous in κ and ζ, and no measurement is left out because the body stops.
//!
//! | step | file |
//! |---|---|
//! | the best minima of a trimmed sum, the 7 smallest of 10 squares, over a grid of starts | `search` |
//! | the least squares over all values, or over those that this fit predicts where chance does not explain the others | `outliers` |
//! | whether the fit explains more than one amplitude for all frequencies does | `explained` |
//! | the same with each reading of the phases, of which the one that explains most is taken | here |
//! | the fit with other readings of amplitudes and phases, which may be better | here |
//! | lower valleys of the sum of squares, and the parameters that cannot be told apart | `valleys` |
//! | the fit with the natural frequency or the force unknown | `unknown` |

mod explained;
mod fit;
mod model;
mod outliers;
mod reading;
mod search;
mod unknown;
mod valleys;

use crate::machine::error::{Error, Quantity};
use crate::machine::oscillator::Oscillator;
use crate::machine::ratios::positive;
use fit::{Spring, identified, in_ratios, sample};
pub use reading::{AmplitudeKind, Identified, Measurement, PhaseKind, Reading, Residual};
use unknown::{Scaled, fitted};

/// The friction force and the damping ratio that fit a response curve of a body of this mass on a spring of this
/// stiffness, under a force of amplitude p₀, whose values are read as `reading` says: by default, amplitudes are peak
/// displacements.
///
/// Errors of the amplitudes count as relative, errors of the phases in radians, both with the same standard deviation unless
/// the residuals of the two differ by more than chance.
///
/// Values that the others contradict are left out: up to three of ten amplitudes, and as many phases. A model that
/// explains all values to within their noise keeps them all, so that in a curve without wrong values one is left out
/// once in 10⁵ curves. Fewer than seven values of a kind are all used.
///
/// The answer is the least sum of squares found from a grid of starts, and on both sides of each motion that begins to
/// stop near it. It is not proved to be the global minimum. The intervals hold all parameters found, in any valley of the sum,
/// that are no worse than their ends. Below Ω = 0.002 the amplitude of a body that stops is that under a slow force, to within 20Ω² p₀/k.
///
/// **With the stiffness or the force unknown**, `None`, the natural angular frequency or p₀ is fitted, too. The phases are
/// then those that `reading` names, and otherwise [`PhaseKind::Peak`], and the standard errors are those of three
/// parameters. A curve without the resonance may leave the natural frequency to chance: its interval says so. Far from
/// resonance and with friction alone, the force and friction are hardly apart.
///
/// **Without a spring**, a stiffness of 0, [`Identified::damping_ratio`] is c/(2 m ω₁), with ω₁ the lowest frequency of the curve:
/// `c = 2ζ m ω₁`. Without a damper the amplitude is `√(p₀² − π² r_y²/4)/(m ω_d²)` where the body does not stop.
///
/// ```
/// use stickslip::design::{Measurement, Reading, identify};
/// let amplitude = |w: f64| (9.0f64.powi(2) - (3.0 * core::f64::consts::FRAC_PI_2).powi(2)).sqrt() / (2.0 * w * w);
/// let measured = |w| Measurement { angular_frequency: w, amplitude: amplitude(w), phase: None };
/// let curve: Vec<_> = (4..12).map(|i| measured(f64::from(i))).collect();
/// let found = identify(2.0, Some(0.0), Some(9.0), &curve, Reading::default())?;
/// assert!((found.friction_bound.value - 3.0).abs() < 1e-6);
/// # Ok::<(), stickslip::Error>(())
/// ```
///
/// # Errors
/// Where mass or force is not > 0, or the stiffness not ≥ 0; [`Error::NotIdentified`] where stiffness and force are unknown, or the
/// force of a body without a spring, whose amplitude is a multiple of it,
/// [`Error::InMeasurement`] where a measurement is not finite, not > 0 or out of range,
/// [`Error::TooFewMeasurements`] for fewer than three, or four with an unknown, [`Error::NotIdentified`] where the curve does not
/// separate friction from damping, [`Error::Unexplained`] where the best fit lies at the end of the range
/// searched, r_y = p₀ or ζ = 100, and [`Error::CurveUnexplained`] where the fit is no nearer to the amplitudes than one
/// amplitude for all frequencies, but for chance: white noise, for example.
pub fn identify(
    mass: f64,
    stiffness: Option<f64>,
    force: Option<f64>,
    curve: &[Measurement],
    reading: Reading,
) -> Result<Identified, Error> {
    let mass = positive(Quantity::Mass, mass)?;
    let force = force.map(|force| positive(Quantity::ForceAmplitude, force)).transpose()?;
    if stiffness == Some(0.0) {
        let lowest = curve.iter().map(|point| point.angular_frequency).fold(f64::INFINITY, f64::min);
        let force = force.ok_or(Error::NotIdentified)?;
        return identified(&Spring::None { mass, lowest }, force, curve, reading);
    }
    // A friction of any size: it plays no part.
    let body = stiffness.map(|stiffness| Oscillator::new(mass, stiffness, 1.0)).transpose()?;
    match (body, force) {
        (Some(body), Some(force)) => identified(&Spring::Of(body), force, curve, reading),
        (None, Some(force)) => fitted(Scaled::Natural { mass, force }, curve, reading),
        (Some(body), None) => fitted(Scaled::Force { body }, curve, reading),
        (None, None) => Err(Error::NotIdentified),
    }
}

#[cfg(test)]
mod tests;
