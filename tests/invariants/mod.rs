//! Invariants of every answer, whatever the bits of the input, shared by the property tests and the fuzz
//! targets.

#![allow(dead_code, reason = "each fuzz target and test takes what it needs")]

use stickslip::NoStop;
use stickslip::{
    Border, Cycle, Drive, Error, Oscillator, PhaseFunction, Quantity, Ratios, Regime, Response, Scales,
    Verdict, design,
};

/// Checks all promises of the closed forms at (Ω, α), and the waveform at one phase.
///
/// # Panics
///
/// If a promise is broken; the fuzzer reports this as a finding.
pub(crate) fn closed_forms(omega: f64, alpha: f64, phase: f64) {
    let range = 2f64.powi(-250)..=2f64.powi(250);
    let ratios = match Ratios::new(omega, alpha) {
        Ok(ratios) => ratios,
        Err(error) => return refused(&error, range.contains(&omega), alpha > 0.0 && alpha <= *range.end()),
    };
    assert!(range.contains(&omega) && alpha > 0.0 && alpha <= *range.end());
    let answer = Response::new(ratios);
    let border = answer.border;
    let (least, by_turning_point) = (border.min_force_ratio, border.min_force_ratio_turning_point);
    assert!(least >= by_turning_point, "α_min = {least:e} below eq. 61 = {by_turning_point:e}");
    assert!(least >= 1.209_998 && least.is_finite(), "α_min = {least:e}");
    assert!(omega < 0.5 || least == by_turning_point, "eq. 61 is exact for Ω ≥ 1/2");
    assert!(border.border_phase >= 0.0 && border.border_phase <= std::f64::consts::PI);
    assert!(border.least_displacement >= 1.0 / (omega * omega));
    let no_stop = NoStop::of(&Ratios::new(omega, alpha).unwrap());
    let is_without_stop =
        no_stop.intervals().any(|(low, high)| low <= alpha && high.is_none_or(|high| alpha <= high));
    match answer.regime {
        Regime::Stuck => assert!(alpha <= 1.0),
        Regime::Sticking => assert!(alpha > 1.0 && alpha < least && !is_without_stop),
        Regime::Unbounded => assert!(omega == 1.0 && alpha >= least),
        Regime::NonSticking => assert!(omega != 1.0 && is_without_stop),
        Regime::DependsOnStart => panic!("with one friction nothing depends on the start"),
    }
    verdict(ratios, answer.regime);
    inverse_questions(omega, alpha);
    let again = Cycle::new(ratios);
    match answer.cycle.as_ref() {
        Some(found) => {
            assert_eq!(again, Ok(*found));
            cycle(found, phase);
        }
        None => assert!(again.is_err()),
    }
}

/// The same with a damper of the damping ratio ζ.
///
/// # Panics
/// As for [`closed_forms`].
pub(crate) fn damped_closed_forms(omega: f64, alpha: f64, zeta: f64, phase: f64) {
    let range = 2f64.powi(-250)..=2f64.powi(250);
    let ratios = match Ratios::new(omega, alpha).and_then(|r| r.with_damping_ratio(zeta)) {
        Ok(ratios) => ratios,
        Err(error) if error.quantity() == Some(Quantity::DampingRatio) => {
            assert!(
                zeta != 0.0 && !range.contains(&zeta) && error.to_string().contains(" must be "),
                "{error}"
            );
            return;
        }
        Err(error) => return refused(&error, range.contains(&omega), alpha > 0.0 && alpha <= *range.end()),
    };
    if !ratios.is_damped() {
        return closed_forms(omega, alpha, phase);
    }
    let border = Border::of(&ratios);
    let least = border.min_force_ratio;
    assert!(
        least >= border.min_force_ratio_turning_point && least > 0.0 && least.is_finite(),
        "α_min = {least:e}"
    );
    // Proved: α_min ≥ 1/Ω² − 1, and the turning point suffices from half the damped frequency on.
    assert!(least >= ((1.0 - omega) * (1.0 + omega) / omega / omega).min(1e70) * (1.0 - 1e-12), "{least:e}");
    assert!(border.border_phase == 0.0 || zeta < 1.0 && omega < 0.5);
    assert!((0.0..=std::f64::consts::PI).contains(&border.border_phase));
    match Cycle::new(ratios) {
        Ok(cycle) => {
            assert!(alpha >= least);
            damped_cycle(&cycle, phase);
        }
        Err(error) => assert!(alpha < least && error.to_string().contains(" must be "), "{error}"),
    }
}

fn damped_cycle(cycle: &Cycle<f64>, phase: f64) {
    let (omega, zeta, alpha) = {
        let ratios = cycle.ratios;
        (ratios.omega(), ratios.damping_ratio(), ratios.alpha())
    };
    let (delta, speed) = (cycle.max_displacement, cycle.max_velocity);
    // The scale of the terms whose difference gives Δ₀ = a − G and the velocity.
    let forced = alpha / (2.0 * zeta * omega).hypot((1.0 - omega) * (1.0 + omega));
    let size = forced + 2.0;
    // The motion is comparable with the rounding of its terms: Ω = 1 with ζ below the rounding of Ω
    // (docs/development/robustness.md).
    if size > 1e12 {
        return;
    }
    assert!(delta > -1e-12 * size && delta.is_finite(), "Δ₀ = {delta:e}");
    assert!(speed > 0.0 && speed.is_finite(), "V₀ = {speed:e}");
    assert!(cycle.damper_work() >= -1e-9 * size * alpha && cycle.damper_work().is_finite());
    for value in [cycle.displacement_phase, cycle.velocity_phase] {
        assert!((0.0..std::f64::consts::TAU).contains(&value), "phase {value:e}");
    }
    assert!(cycle.deviation().is_finite());
    assert!((0.0..=1.0 + 1e-15).contains(&cycle.contraction()), "λ = {:e}", cycle.contraction());
    let (x, v) = (cycle.displacement_at(phase), cycle.velocity_at(phase));
    assert_eq!(x.is_nan(), !phase.is_finite());
    if phase.is_finite() {
        let slack = 1e-11 * (1.0 + 1.0 / omega);
        assert!(x.abs() <= delta + slack * size, "|x| = {x:e} above Δ₀ = {delta:e}");
        assert!(v.abs() <= speed + slack * (size + (1.0 + zeta) / omega), "|v| = {v:e} above V₀ = {speed:e}");
    }
}

/// A decided verdict agrees with the rounded border, except within a few units in its last place at Ω =
/// 1/(2n).
fn verdict(ratios: Ratios<f64>, regime: Regime) {
    let verdict = Verdict::new(ratios);
    let margin = ratios.alpha() / Border::of(&ratios).min_force_ratio;
    assert!(margin >= 0.0 && margin.is_finite(), "margin {margin:e}");
    match verdict.regime() {
        Some(decided) => assert!(decided == regime || (margin - 1.0).abs() < 1e-15, "{verdict:?} {regime:?}"),
        None => assert!((margin - 1.0).abs() < 1e-14 || is_at_an_edge(ratios), "{verdict:?}"),
    }
}

/// Whether α is within rounding of an edge of six reversals.
fn is_at_an_edge(ratios: Ratios<f64>) -> bool {
    let no_stop = NoStop::of(&ratios);
    let close = |edge: f64| (ratios.alpha() / edge - 1.0).abs() < 1e-12;
    no_stop.six_reversals.is_some_and(|(low, high)| close(low) || close(high))
}

/// An answer is finite and keeps the body sliding, whatever the target.
fn inverse_questions(omega: f64, target: f64) {
    let p = PhaseFunction::new(omega).unwrap();
    let least = Border::new(omega).unwrap().min_force_ratio;
    // Below 2⁻²³⁶ the slope itself can be beyond the largest double: it is about 2/(Ω⁴ |cos β|), and the
    // nearest float to a pole has |cos β| near 2⁻⁶².
    let slope = Border::slope(&p);
    assert!(slope.is_finite() || omega < 2f64.powi(-236) && !slope.is_nan(), "{slope:e} at Ω = {omega:e}");
    for force in [
        design::force_ratio_for_displacement(omega, 0.0, target),
        design::force_ratio_for_velocity(omega, 0.0, target),
    ] {
        match force {
            Ok(force) => assert!(force >= least * (1.0 - 1e-15) && force.is_finite(), "{force:e}"),
            Err(error) => assert!(error.to_string().contains(" must be "), "{error}"),
        }
    }
    if let Ok(best) = design::most_dissipating_force_ratio(omega, 0.0) {
        assert!(best.at >= least && best.value >= 0.0, "{best:?}");
    }
    let (low, high) = (omega * 0.9, omega * 1.1);
    if let Ok(mut bands) = design::bands(target, 0.0, low..=high)
        && let Some(Ok(band)) = bands.next()
    {
        assert!(low <= band.low && band.low <= band.high && band.high <= high, "{band:?}");
        assert!(Border::new(band.low).unwrap().min_force_ratio <= target);
        assert!(Border::new(band.high).unwrap().min_force_ratio <= target);
    }
}

/// A refusal must have a cause, and the message must name it.
fn refused(error: &Error, omega_is_in_range: bool, alpha_is_in_range: bool) {
    match error.quantity() {
        Some(Quantity::FrequencyRatio) => assert!(!omega_is_in_range, "{error}"),
        Some(Quantity::ForceRatio) => assert!(!alpha_is_in_range, "{error}"),
        other => panic!("{error} names {other:?}"),
    }
    assert!(error.to_string().contains(" must be "));
}

fn cycle(cycle: &Cycle<f64>, phase: f64) {
    let (delta, speed) = (cycle.max_displacement, cycle.max_velocity);
    let omega = cycle.ratios.omega();
    assert!(delta > 0.0 && delta.is_finite(), "Δ₀ = {delta:e}");
    assert!(speed > 0.0 && speed.is_finite(), "V₀ = {speed:e}");
    for value in [cycle.displacement_phase, cycle.velocity_phase] {
        assert!((0.0..std::f64::consts::TAU).contains(&value), "phase {value:e}");
    }
    assert!(cycle.deviation().is_finite());
    assert!((0.0..=1.0 + 1e-15).contains(&cycle.contraction()), "λ = {:e}", cycle.contraction());
    let multipliers = cycle.multipliers();
    let modulus = |[first, second]: [(f64, f64); 2]| first.0.hypot(first.1).max(second.0.hypot(second.1));
    assert!(modulus(multipliers.cycle) <= 1.0 + 4e-15, "{multipliers:?}");
    let [first, second] = multipliers.half_cycle;
    assert!(first.0.hypot(first.1) >= second.0.hypot(second.1), "{multipliers:?}");
    assert!((modulus(multipliers.half_cycle) - cycle.contraction()).abs() <= 1e-7, "{multipliers:?}");
    assert!(cycle.loop_size_stiffness() >= 0.0 && cycle.loop_size_inertia() >= 0.0);
    let (x, v) = (cycle.displacement_at(phase), cycle.velocity_at(phase));
    assert_eq!(x.is_nan(), !phase.is_finite());
    if phase.is_finite() {
        // A phase is known to its own rounding; the faster wave turns 1/Ω times per turn of the drive.
        let slack = 1.0 + 1e-11 * (1.0 + 1.0 / omega);
        assert!(x.abs() <= delta * slack, "|x| = {x:e} above Δ₀ = {delta:e}");
        assert!(v.abs() <= speed * slack, "|v| = {v:e} above V₀ = {speed:e}");
    }
}

/// Physical input either gives an error that says what is wrong, or leads to ratios and finite scales.
///
/// # Panics
///
/// If it does neither.
pub(crate) fn physical_units(
    mass: f64,
    stiffness: f64,
    friction_bound: f64,
    amplitude: f64,
    frequency: f64,
    base: bool,
) {
    let good = |x: f64| x.is_finite() && x > 0.0;
    let body = Oscillator::new(mass, stiffness, friction_bound);
    assert_eq!(body.is_ok(), good(mass) && good(stiffness) && good(friction_bound));
    let drive = if base {
        Drive::new(stickslip::Excitation::FootMotion, amplitude, frequency)
    } else {
        Drive::force(amplitude, frequency)
    };
    assert_eq!(drive.is_ok(), good(amplitude) && good(frequency));
    let (Ok(body), Ok(drive)) = (body, drive) else { return };
    if let Ok(scales) = Scales::new(&body, &drive) {
        for scale in [scales.length, scales.velocity, scales.time, scales.force] {
            assert!(good(scale));
        }
    }
    match drive.ratios(&body) {
        Ok(ratios) => closed_forms(ratios.omega(), ratios.alpha(), 0.3),
        Err(error) => assert!(error.to_string().contains(" must be "), "{error}"),
    }
}
