//! The measured quantities of one steady motion as functions of friction and damping.

use crate::cycle::damped;
use crate::cycle::damped::border::turning_point;
use crate::cycle::damped::half_period::HalfPeriod;
use crate::machine::ratios::Ratios;
use crate::motion::{LongRun, SteadyState, Trajectory};
use core::f64::consts::{FRAC_2_PI, FRAC_PI_2, TAU};
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// κ = r_y/p₀ and ζ.
pub(super) type Parameters = [f64; 2];

/// The damping ratio that stands for zero in the closed forms of the damped cycle.
const LEAST_DAMPING: f64 = 1e-9;

/// The frequency ratio below which a body that stops is assumed to follow the force, with the amplitude
/// `(p₀/k)(1/q − κ)`. With little damping it moves in slides of up to 2π in natural time, the last of which
/// ends within 2π of the maximum: the phase is known to within 2πΩ, the amplitude to within 20Ω² p₀/k. The
/// exact motion has about 4/Ω slides a cycle at such frequencies.
pub(super) const SLOW: f64 = 0.002;

/// The samples of a cycle with stops, from which its mean square and its fundamental are summed.
const SAMPLES: u32 = 256;

/// One steady motion; displacements in units of p₀/k.
#[derive(Debug, Clone, Copy)]
pub(super) struct ModelMotion {
    /// Peak displacement.
    pub(super) peak: f64,
    /// The phase ω_d t at which the body arrives at its peak displacement.
    pub(super) peak_phase: f64,
    /// Whether the body stops in each cycle.
    pub(super) stops: bool,
    /// Root mean square and fundamental, if requested.
    pub(super) whole: Whole,
}

/// The quantities that depend on the whole cycle.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Whole {
    /// Root mean square of the displacement.
    pub(super) root_mean_square: f64,
    /// The lag of the fundamental of the displacement behind the force.
    pub(super) lag: f64,
}

/// The steady motion at Ω with the friction κ and the damping ζ, both ≥ 0; the quantities that depend on the
/// whole cycle only if `whole`.
///
/// Where the two-reversal cycle exists it is the closed form, otherwise the exact motion. Both meet on the
/// border. `None` where the exact motion is not found.
pub(super) fn motion(omega: f64, [kappa, zeta]: Parameters, whole: bool) -> Option<ModelMotion> {
    let half = HalfPeriod::new(omega, zeta.max(LEAST_DAMPING));
    let on_turning_point = half.k.hypot(half.stiffness * turning_point(&half));
    if kappa * on_turning_point <= 1.0 && kappa * damped::border(&half).min_force_ratio <= 1.0 {
        return Some(sliding(&half, kappa, whole));
    }
    if omega < SLOW {
        return Some(slow(&half, kappa, whole));
    }
    let ratios = Ratios::new(omega, 1.0 / kappa).ok()?;
    let ratios = if zeta > LEAST_DAMPING { ratios.with_damping_ratio(zeta).ok()? } else { ratios };
    let limit = LongRun::from_start(ratios, crate::motion::State::default()).ok()?;
    let Some(steady) = limit.steady_state() else {
        // A body at rest has no amplitude; other limits are not those of a measurement.
        let at_rest = ModelMotion {
            peak: 0.0,
            peak_phase: half.phase_lag() + FRAC_PI_2,
            stops: true,
            whole: Whole::default(),
        };
        return matches!(limit, LongRun::Rest(_)).then_some(at_rest);
    };
    Some(ModelMotion {
        peak: kappa * steady.max_displacement.value,
        peak_phase: steady.max_displacement.phase.reduced(),
        stops: steady.sticks_per_cycle > 0,
        whole: if whole { sampled(&ratios, steady, kappa)? } else { Whole::default() },
    })
}

/// The cycle of two reversals: `Δ₀ = √(1 − κ²K²)/q − κG`, `ω_d t₂ = δ + atan2(√(1 − κ²K²), κK)`.
fn sliding(half: &HalfPeriod<f64>, kappa: f64, whole: bool) -> ModelMotion {
    let cosine = kappa * half.k;
    let sine = ((1.0 - cosine) * (1.0 + cosine)).max(0.0).sqrt();
    let peak_phase = half.phase_lag() + sine.atan2(cosine);
    ModelMotion {
        peak: sine / half.stiffness - kappa * half.shift,
        peak_phase,
        stops: false,
        whole: if whole { harmonics(half, kappa, peak_phase) } else { Whole::default() },
    }
}

/// The harmonics of the cycle of two reversals, whose friction is a square wave:
///
/// ```text
/// sgn x′ = −(4/π) Σ sin n(θ − ω_d t₂)/n,   n odd,
/// x̂₁ = [1 + (4κ/π) e^{−iω_d t₂}]/(1 − Ω² + 2iζΩ),   |x̂ₙ| = (4κ/π)/(n |1 − n²Ω² + 2iζnΩ|).
/// ```
fn harmonics(half: &HalfPeriod<f64>, kappa: f64, peak_phase: f64) -> Whole {
    let (sin, cos) = peak_phase.sin_cos();
    let square_wave = 2.0 * FRAC_2_PI * kappa;
    let (re, im) = (1.0 + square_wave * cos, -square_wave * sin);
    // The harmonics fall as n⁻³ beyond the natural frequency.
    let last = (8.0 / half.omega).clamp(40.0, 2000.0);
    let mut square = (re.hypot(im) / half.stiffness).powi(2);
    let mut n = 3.0;
    while n <= last {
        let ratio = n * half.omega;
        let stiffness = (2.0 * half.free.zeta * ratio).hypot((1.0 - ratio) * (1.0 + ratio));
        square += (square_wave / (n * stiffness)).powi(2);
        n += 2.0;
    }
    Whole { root_mean_square: (square / 2.0).sqrt(), lag: half.phase_lag() - im.atan2(re) }
}

/// A motion so slow that the body follows the force within the play 2κ of friction; at rest from κ = 1/q on.
fn slow(half: &HalfPeriod<f64>, kappa: f64, whole: bool) -> ModelMotion {
    let (size, lag) = (1.0 / half.stiffness, half.phase_lag());
    let peak = (size - kappa).max(0.0);
    // The sum begins at the maximum, which the body has reached in any earlier cycle.
    let mut place = peak;
    let followed = (0..SAMPLES).map(|i| {
        let theta = TAU * f64::from(i) / f64::from(SAMPLES) + FRAC_PI_2;
        let force = size * theta.sin();
        place = place.clamp(force - kappa, force + kappa);
        (theta + lag, place)
    });
    ModelMotion {
        peak,
        peak_phase: lag + FRAC_PI_2,
        stops: true,
        whole: if whole { Whole::of(followed) } else { Whole::default() },
    }
}

impl Whole {
    /// The quantities of the whole cycle from evenly spaced samples (θ, x) of it.
    fn of(samples: impl Iterator<Item = (f64, f64)>) -> Self {
        let (mut count, mut square, mut in_phase, mut ahead) = (0.0, 0.0, 0.0, 0.0);
        for (theta, x) in samples {
            let (sin, cos) = theta.sin_cos();
            count += 1.0;
            square += x * x;
            in_phase += x * sin;
            ahead += x * cos;
        }
        Self { root_mean_square: (square / count).sqrt(), lag: -ahead.atan2(in_phase) }
    }
}

/// The quantities of the whole cycle for a steady state of the exact motion.
fn sampled(ratios: &Ratios<f64>, steady: &SteadyState<f64>, kappa: f64) -> Option<Whole> {
    let samples = Trajectory::new(*ratios, steady.state).ok()?.samples(SAMPLES).ok()?;
    // One turn of the drive; the iterator is endless.
    let states = samples.take(usize::try_from(SAMPLES).ok()?).map_while(Result::ok).map(|at| at.state);
    Some(Whole::of(states.map(|state| (state.phase.reduced(), kappa * state.x))))
}
