//! Invariants of the exact motion from any state, and of the inverse problems.

#![allow(dead_code, reason = "each fuzz target and test takes what it needs")]

use core::ops::ControlFlow;
use stickslip::design;
use stickslip::motion::{End, Kind, LongRun, State, Trajectory, periodic_motions_from, symmetry_breaks};
use stickslip::{Border, Cycle, Error, Ratios, Regime, Response};

/// The first phases of the motion from any state: each begins where the last ended, friction respects its
/// bound, energy is lost only to friction and gained only from the drive.
///
/// # Panics
///
/// If a promise is broken; the fuzzer reports this as a finding.
pub(crate) fn trajectory(omega: f64, alpha: f64, theta: f64, x: f64, v: f64) {
    damped_trajectory(omega, alpha, 0.0, theta, x, v);
}

/// The same with a damper of the damping ratio ζ.
///
/// # Panics
/// As for [`trajectory`].
pub(crate) fn damped_trajectory(omega: f64, alpha: f64, zeta: f64, theta: f64, x: f64, v: f64) {
    let ratios = Ratios::new(omega, alpha).and_then(|r| r.with_damping_ratio(zeta));
    if let Ok(ratios) = ratios {
        trajectory_at(ratios, theta, x, v);
    }
}

/// The motion and its steady state with a static friction as well.
///
/// # Panics
/// As for [`trajectory`].
pub(crate) fn static_motion(omega: f64, alpha: f64, zeta: f64, eta: f64, theta: f64, x: f64, v: f64) {
    let ratios = Ratios::new(omega, alpha)
        .and_then(|r| r.with_damping_ratio(zeta))
        .and_then(|r| r.with_static_friction_ratio(eta));
    let Ok(ratios) = ratios else { return };
    trajectory_at(ratios, theta, x, v);
    long_run_at(ratios, theta, x, v);
    searches_at(ratios, theta, x, v);
}

/// Periodic motions found from a start, and losses of the symmetric motion around a force: all are motions of
/// the machine and lie within the requested range.
fn searches_at(ratios: Ratios<f64>, theta: f64, x: f64, v: f64) {
    let (omega, alpha) = (ratios.omega(), ratios.alpha());
    let Ok(start) = State::new(theta, x, v) else { return };
    let mut slides = 0;
    let found = periodic_motions_from(ratios, start, 1, &mut || {
        slides += 1;
        if slides < 5_000 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    });
    assert!(!matches!(found, Err(Error::SearchBound { .. })), "{found:?} of {ratios:?} from {start:?}");
    for steady in found.into_iter().flatten() {
        assert!(alpha > 1.0 && steady.turns_per_cycle == 1, "{steady:?}");
        assert!(steady.min_displacement.value <= steady.max_displacement.value, "{steady:?}");
        let most = ratios.static_friction_ratio();
        assert!(steady.is_stable() || most > 1.0 || steady.contraction() < 1.0 + 1e-6, "{steady:?}");
    }
    // The work of the search has no bound from outside: only Ω and α of ordinary machines are tried.
    if !((0.125..8.0).contains(&omega) && alpha < 100.0) {
        return;
    }
    let (low, high) = (0.9 * alpha, 1.1 * alpha);
    let breaks = symmetry_breaks(ratios, low..=high, 2);
    assert!(!matches!(breaks, Err(Error::SearchBound { .. })), "{breaks:?} of {ratios:?}");
    for one in breaks.into_iter().flatten() {
        assert!((low..=high).contains(&one.alpha) && one.motion.is_symmetric, "{one:?}");
        assert!(ratios.has_higher_static_friction(), "{one:?} of {ratios:?}");
    }
}

/// The factor 1 + 2^e for e from −52 to 3, selected by `part` of 2³²; 1 for zero.
pub(crate) fn static_friction_ratio(part: u32) -> f64 {
    if part == 0 { 1.0 } else { 1.0 + (55.0 * f64::from(part) / f64::from(u32::MAX) - 52.0).exp2() }
}

fn trajectory_at(ratios: Ratios<f64>, theta: f64, x: f64, v: f64) {
    let (omega, alpha) = (ratios.omega(), ratios.alpha());
    let (zeta, eta) = (ratios.damping_ratio(), ratios.static_friction_ratio());
    let Ok(start) = State::new(theta, x, v) else { return };
    let Ok(motion) = Trajectory::new(ratios, start) else {
        let far = 2f64.powi(20);
        assert!(!(far.recip()..=far).contains(&omega) || zeta > far || eta > far);
        return;
    };
    let mut last = start;
    for (i, phase) in motion.take(24).enumerate() {
        let phase = phase.unwrap_or_else(|error| panic!("{error} of {ratios:?} from {start:?}"));
        let from = phase.start();
        assert!(from.phase == last.phase && from.x == last.x, "phase {i} of {ratios:?} from {start:?}");
        let at = phase.at(from.phase);
        let most = if phase.kind == Kind::Stick { eta } else { 1.0 };
        assert!(at.friction.abs() <= most);
        let Some(to) = phase.end() else {
            assert!(phase.ends_by == End::Never && phase.kind == Kind::Stick);
            return;
        };
        let length = phase.duration().unwrap_or(f64::NAN);
        assert!(length >= 0.0, "phase {i} lasts {length:e}");
        assert!(to.x.is_finite() && to.v == 0.0);
        if phase.kind == Kind::Stick {
            assert_eq!(to.x, from.x);
            // Friction gives way when the force on it reaches η r_y.
            let (sine, _) = to.phase.reduced().sin_cos();
            let force = (alpha * sine - to.x).abs();
            let scale = eta + alpha + to.x.abs();
            assert!((force - eta).abs() <= 1e-9 * scale, "release at {force:e} of {scale:e}");
        }
        last = to;
    }
}

/// The steady state from any state: it is classified, and its properties are consistent.
///
/// # Panics
///
/// As for [`trajectory`].
pub(crate) fn long_run(omega: f64, alpha: f64, theta: f64, x: f64, v: f64) -> bool {
    damped_long_run(omega, alpha, 0.0, theta, x, v)
}

/// The same with a damper of the damping ratio ζ.
///
/// # Panics
/// As for [`trajectory`].
pub(crate) fn damped_long_run(omega: f64, alpha: f64, zeta: f64, theta: f64, x: f64, v: f64) -> bool {
    let ratios = Ratios::new(omega, alpha).and_then(|r| r.with_damping_ratio(zeta));
    ratios.is_ok_and(|ratios| long_run_at(ratios, theta, x, v))
}

/// Whether a limit was found and compared.
fn long_run_at(ratios: Ratios<f64>, theta: f64, x: f64, v: f64) -> bool {
    let (omega, alpha) = (ratios.omega(), ratios.alpha());
    let (zeta, eta) = (ratios.damping_ratio(), ratios.static_friction_ratio());
    let Ok(start) = State::new(theta, x, v) else { return false };
    // The work is bounded: a cycle has up to 4 + 4/Ω slides.
    let mut slides = 0;
    let limit = LongRun::within(ratios, start, 200, &mut || {
        slides += 1;
        if slides < 5_000 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    });
    assert!(limit != Err(Error::Interrupted) || slides == 5_000);
    assert!(!matches!(limit, Err(Error::SearchBound { .. })), "{limit:?} of {ratios:?} from {start:?}");
    let Ok(limit) = limit else { return false };
    match &limit {
        LongRun::Rest(rest) => {
            let slack = 1e-12 * (eta + x.abs());
            assert!(alpha <= eta && rest.position.abs() <= (eta - alpha) + slack, "{rest:?} of {ratios:?}");
        }
        LongRun::Unbounded { growth } => assert!(omega == 1.0 && *growth > 0.0 && zeta == 0.0),
        LongRun::NotConverged { .. } => return false,
        LongRun::Irregular(motion) => {
            assert!(eta > 1.0 && motion.max_displacement >= motion.min_displacement);
            assert!(motion.turns > 0 && motion.lyapunov_exponent.is_finite());
        }
        LongRun::Periodic(steady) | LongRun::Family(steady) => {
            assert!(alpha > 1.0);
            assert!(steady.min_displacement.value <= steady.max_displacement.value);
            assert!(steady.min_velocity.value <= 0.0 && steady.max_velocity.value >= 0.0);
            assert!((0.0..1.0).contains(&steady.stick_fraction));
            let (sticks, zeros) = (steady.sticks_per_cycle, steady.velocity_zeros_per_cycle);
            let most = f64::from(steady.turns_per_cycle) * (24.0 + 4.0 / omega);
            assert!(eta > 1.0 || steady.turns_per_cycle == 1);
            assert!(sticks <= zeros && f64::from(zeros) <= most, "{steady:?}");
            // No part of a motion drives two of them apart, except by rounding of a few units each, and near
            // a double root by the square root of it.
            let rounding = 16.0 * f64::EPSILON * f64::from(zeros) + 2e-7;
            assert!(steady.contraction() <= 1.0 + rounding, "{} at {ratios:?}", steady.contraction());
            let (work_in, work_out) = (steady.energy_in, steady.energy_out + steady.damper_work);
            // The effect on the energy of the distance from the limit, and of rounding in the large terms.
            let (far, fast) = steady.distance;
            assert!(far >= 0.0 && fast >= 0.0);
            let size = alpha * (steady.max_displacement.value - steady.min_displacement.value);
            assert!(
                (work_in - work_out).abs()
                    <= 1e-9 * size.abs() * (1.0 + 1.0 / omega) + 64.0 * far * (1.0 + alpha),
                "{work_in:e} in, {work_out:e} out at {ratios:?}"
            );
        }
    }
    true
}

/// The motion and its steady state at a frequency ratio from 2⁻²⁰ to 2²⁰, ends included, selected
/// log-uniformly by `part` of 2³².
///
/// # Panics
///
/// As for [`trajectory`].
pub(crate) fn any_frequency(part: u32, alpha: f64, theta: f64, x: f64, v: f64) {
    let omega = (40.0 * f64::from(part) / f64::from(u32::MAX) - 20.0).exp2();
    trajectory(omega, alpha, theta, x, v);
    long_run(omega, alpha, theta, x, v);
}

/// The relative effect of the rounding of α on Δ₀: `dΔ₀/Δ₀ = α² /((1 − Ω²) Δ₀)² · dα/α`, times a few units.
fn condition(omega: f64, alpha: f64, max_displacement: f64) -> f64 {
    let sine = (1.0 - omega) * (1.0 + omega) * max_displacement / alpha;
    64.0 * f64::EPSILON / (sine * sine)
}

/// The inverse problems: either an error that says what is wrong, or an answer that the forward functions
/// confirm.
///
/// # Panics
///
/// As for [`trajectory`].
pub(crate) fn questions(omega: f64, target: f64, alpha: f64, low: f64, high: f64) {
    if let Ok(force) = design::force_ratio_for_displacement(omega, 0.0, target)
        && let Ok(cycle) = Ratios::new(omega, force).and_then(Cycle::new)
    {
        let slack = 1e-9 + condition(omega, force, target);
        assert!((cycle.max_displacement / target - 1.0).abs() < slack, "{omega:e} {target:e} {force:e}");
    }
    if let Ok(force) = design::force_ratio_for_velocity(omega, 0.0, target)
        && let Ok(cycle) = Ratios::new(omega, force).and_then(Cycle::new)
    {
        // Near Ω = 1 the next force of the type can move the body much further.
        let slack = 1e-9 + condition(omega, force, cycle.max_displacement.min(target));
        assert!((cycle.max_velocity / target - 1.0).abs() < slack, "{omega:e} {target:e} {force:e}");
    }
    if let Ok(best) = design::most_dissipating_force_ratio(omega, 0.0) {
        let least = Border::new(omega).map_or(f64::NAN, |b| b.min_force_ratio);
        assert!(best.at >= least && best.value > 0.0);
    }
    if let Ok(bands) = design::bands(alpha, 0.0, low..=high) {
        let mut last = low;
        // A wide range at low frequency has a great many bands.
        for band in bands.take(64) {
            let Ok(band) = band else { continue };
            assert!(last <= band.low && band.low <= band.high && band.high <= high);
            last = band.high;
            for end in [band.low, band.high] {
                assert_ne!(
                    Response::new(Ratios::new(end, alpha).unwrap()).regime,
                    Regime::Sticking,
                    "{end:e} of {alpha:e}"
                );
            }
        }
    }
}

/// The same with a damper of the damping ratio ζ: substituting the answer gives the target.
///
/// # Panics
///
/// As for [`trajectory`].
pub(crate) fn damped_questions(omega: f64, zeta: f64, target: f64, alpha: f64, low: f64, high: f64) {
    let at = |omega: f64, alpha: f64| Ratios::new(omega, alpha).and_then(|r| r.with_damping_ratio(zeta));
    let Ok(ratios) = at(omega, 1.0) else { return };
    if !ratios.is_damped() {
        return questions(omega, target, alpha, low, high);
    }
    let least = Border::of(&ratios).min_force_ratio;
    // The rounding of α in the terms whose difference is the target, and where a = √(α² − K²)/q absorbs all
    // of it.
    let stiffness = (2.0 * zeta * omega).hypot((1.0 - omega) * (1.0 + omega));
    let slack = |force: f64| {
        let swing = force / stiffness / target;
        1e-9 + 1e-12 * (swing + 2.0 / target) * (1.0 + 1.0 / omega) + 1e-14 * swing * swing
    };
    let by_displacement = design::force_ratio_for_displacement(omega, zeta, target);
    if let Ok(force) = by_displacement
        && let Ok(cycle) = at(omega, force.max(least)).and_then(Cycle::new)
    {
        let off = (cycle.max_displacement / target - 1.0).abs();
        assert!(off < slack(force), "{omega:e} {zeta:e} {target:e}: {off:e} by {force:e}");
    }
    let by_velocity = design::force_ratio_for_velocity(omega, zeta, target);
    if let Ok(force) = by_velocity
        && let Ok(cycle) = at(omega, force.max(least)).and_then(Cycle::new)
    {
        let off = (cycle.max_velocity / target - 1.0).abs();
        assert!(off < slack(force) * (1.0 + zeta), "{omega:e} {zeta:e} {target:e}: {off:e} by {force:e}");
    }
    for error in [by_displacement.err(), by_velocity.err()].into_iter().flatten() {
        assert!(error.to_string().contains(" must be "), "{error}");
    }
    let best = design::most_dissipating_force_ratio(omega, zeta).unwrap();
    assert!(best.at >= least && best.value.is_finite(), "{best:?}");
    // The work is bounded: there are up to √α/2 bands, with a mesh of some hundred points for each.
    if alpha < 1e3
        && high < 1e3
        && let Ok(bands) = design::bands(alpha, zeta, low..=high)
    {
        let mut last = low;
        for band in bands.map(Result::unwrap) {
            assert!(last <= band.low && band.low <= band.high && band.high <= high, "{band:?}");
            last = band.high;
            for end in [band.low, band.high] {
                let border = Border::of(&at(end, 1.0).unwrap()).min_force_ratio;
                assert!(border <= alpha, "{end:e} of {alpha:e}: {border:e}");
            }
        }
    }
}
