//! The maximum speed of slow slides against dense sampling.

use crate::Ratios;
use crate::float::Float;
use crate::motion::slide::Slide;
use crate::motion::trajectory::Body;
use crate::motion::{State, Trajectory};

/// The first slides of a random motion under a slow drive, whole and cut short of their ends. The motion
/// starts from rest, or up to three times as fast as the drive alone.
fn slow_slides<F: Float>(i: u32) -> Vec<(Slide<F>, F)> {
    let spread = |step: f64| (f64::from(i) * step).fract();
    let scale = |low: f64, high: f64, step: f64| F::from_f64(low * (high / low).powf(spread(step)));
    let (omega, zeta) = (scale(0.01, 0.5, 0.618_034), scale(1e-3, 1.0, 0.437_016));
    let zeta = if i.is_multiple_of(3) { F::int(0) } else { zeta };
    let alpha = scale(1.05, 60.0, 0.754_878);
    let ratios = Ratios::new(omega, alpha).unwrap().with_damping_ratio(zeta).unwrap();
    let share = |step: f64| F::from_f64(2.0 * spread(step) - 1.0);
    let speed = if i.is_multiple_of(4) { F::int(0) } else { F::int(3) * alpha * share(0.569_840) };
    let start = State::new(F::int(3) * share(0.303_577), (alpha + F::int(1)) * share(0.220_744), speed);
    let motion = Trajectory::new(ratios, start.unwrap()).unwrap();
    let mut found = Vec::new();
    for segment in motion.take(6).map(Result::unwrap) {
        if let Body::Slide(slide, zero) = segment.body {
            let cut = F::from_f64(0.1 + 0.85 * spread(0.137_3));
            found.extend([(slide, zero.phi), (slide, zero.phi * cut)]);
        }
    }
    found
}

/// The excess of the fastest sample over the computed maximum speed, and the difference between the maximum
/// speed and the speed at its time, relative to the terms of the speed. `density` is the number of samples
/// per unit of natural time.
fn excess<F: Float>(slide: &Slide<F>, end: F, density: f64) -> F {
    let found = slide.fastest(end, &slide.motion(end)).unwrap();
    assert!(found.phi >= F::int(0) && found.phi <= end, "{slide:?}: {found:?}");
    let sign = slide.direction.sign::<F>();
    let count = (end.to_f64() * density).clamp(50.0, 4000.0).ceil();
    let sampled = (0..=count as u32).map(|i| {
        let share = F::from_f64(f64::from(i)) / F::from_f64(count);
        sign * slide.motion(end * share).w
    });
    let most = sampled.fold(F::int(0), F::or_larger);
    let there = sign * slide.motion(found.phi).w;
    let off = (there - sign * found.w).abs().or_larger(most - sign * found.w);
    off / (F::int(1) + slide.w.abs() + slide.equation.alpha)
}

#[test]
fn no_sample_of_a_slow_slide_is_faster() {
    let (mut slides, mut worst) = (0, 0.0f64);
    for i in 0..1500 {
        for (slide, end) in slow_slides::<f64>(i) {
            let off = excess(&slide, end, 8.0);
            // The rounding of the angles of a slide of length π(1 + 1/Ω), with a margin for the terms.
            let rounding = 16.0 * f64::EPSILON * (4.0 + end);
            assert!(off <= rounding, "{i}: {slide:?} up to {end}: {off:e} of {rounding:e}");
            slides += 1;
            worst = worst.max(off / rounding);
        }
    }
    assert!(slides > 6000 && worst > 0.0, "{slides} {worst}");
}

/// At 256 bits no sample exceeds the maximum either: the result is accurate far below the rounding of f64.
#[cfg(feature = "mp")]
#[test]
fn nor_is_one_at_256_bits() {
    for i in 0..40 {
        for (slide, end) in slow_slides::<crate::float::mp::Mp<4>>(3 * i + 1) {
            let off = excess(&slide, end, 2.0).to_f64();
            assert!(off <= 2f64.powi(-230), "{i}: {slide:?}: {off:e}");
        }
    }
}
