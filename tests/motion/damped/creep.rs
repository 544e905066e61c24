//! Creeping slides: strong damping, far starts and fast drives.

use super::{forced_response, from_rest, ratios};
use crate::random::Random;
use std::f64::consts::{PI, TAU};
use stickslip::float::Mp;
use stickslip::float::{Field, Float};
use stickslip::motion::{Kind, State, Trajectory};
use stickslip::{Border, Cycle};

/// A start far outside on an overdamped spring creeps inwards during many turns of the drive, in a single
/// slide.
#[test]
fn a_long_creep_is_one_slide() {
    let start = State::new(0.0, -1e6, 0.0).unwrap();
    let motion = Trajectory::new(ratios(1.0, 50.0, 2.0), start).unwrap();
    let first = motion.map(Result::unwrap).next().unwrap();
    assert!(first.duration().unwrap() > 100.0 * PI, "{first:?}");
    assert!(first.kind != Kind::Stick);
}

/// The start is so far out that the forced motion is below its rounding. The free vibration forgets the
/// start, and the place of the reversal is as accurate as from nearby.
#[test]
fn a_creep_from_far_out_keeps_its_digits() {
    type Wide = Mp<8>;
    let mut random = Random(91);
    let mut compared = 0;
    for number in 0..300 {
        let omega = random.scale(1e-3, 1e3);
        let zeta = match number % 3 {
            0 => random.scale(1.0, 50.0),
            1 => 1.0 + random.between(-1.0, 1.0) * random.scale(1e-12, 1e-2),
            _ => random.between(0.5, 1.0),
        };
        let (alpha, theta) = (random.scale(1.1, 20.0), random.between(0.0, TAU));
        let far = random.scale(1e6, 1e70) * if random.next() < 0.5 { -1.0 } else { 1.0 };
        let speed = if random.next() < 0.5 { 0.0 } else { far * random.between(-2.0, 2.0) / omega };
        let narrow = Trajectory::new(ratios(omega, zeta, alpha), State::new(theta, far, speed).unwrap());
        let wide = Trajectory::new(
            ratios(Wide::from(omega), Wide::from(zeta), Wide::from(alpha)),
            State::new(theta.into(), far.into(), speed.into()).unwrap(),
        );
        for (ours, exact) in narrow.unwrap().zip(wide.unwrap()).take(3) {
            let (ours, exact) = (ours.unwrap(), exact.unwrap());
            let (Some(a), Some(b)) = (ours.end(), exact.end()) else { break };
            let given = [omega, zeta, alpha, theta, far, speed];
            // The remaining influence of the start's rounding at the end of the slide.
            let left = ours.start().x.abs()
                * 1e-14
                * (-zeta.min(1.0 / zeta) * ours.duration().unwrap() / omega / 2.0).exp();
            let unit = (1e-11 * (1.0 + alpha) * (1.0 + omega.recip()) + left) * (1.0 + zeta);
            let off = (Wide::from(a.x) - b.x).to_f64().abs();
            assert!(off <= unit, "{given:?}: {off:e} of {unit:e}, {ours:?} {exact:?}");
            compared += 1;
            // If a reversal is far out, rounding decides the next event.
            if ours.start().x.abs() < 1e6 {
                break;
            }
        }
    }
    assert!(compared > 300, "{compared}");
}

/// Near ζ = 1, a fast drive leads to the closed-form cycle as elsewhere.
#[test]
fn fast_drives_settle_beside_critical_damping() {
    for omega in [1e2, 1e4, 1e5, 1e6] {
        for zeta in [0.999, 1.0 - 1e-9, 1.0, 1.0 + 1e-9, 1.001, 1.1, 3.0] {
            let least = Border::of(&ratios(omega, zeta, 1.0)).min_force_ratio;
            for over in [1.01, 2.0, 10.0] {
                let steady = from_rest(ratios(omega, zeta, least * over));
                let cycle = Cycle::new(ratios(omega, zeta, least * over)).unwrap();
                let off = steady.max_displacement.value / cycle.max_displacement - 1.0;
                assert!(off.abs() < 1e-9, "{omega} {zeta} {over}: {off:e} {steady:?}");
            }
        }
    }
}

/// A slow creep under a fast drive ends when its velocity has decreased to that of the drive: after up to
/// 10¹⁰ turns, when floats no longer resolve the phase.
#[test]
fn a_long_creep_under_a_fast_drive_is_one_slide() {
    let far = 2f64.powi(20);
    for (omega, zeta, alpha, theta, eta) in [
        (far, 259253.69232680587, 1.8620958891178843, -0.836716609037648, 1.0000056910680057),
        (far, far, 1.9, 0.1, 1.0),
        (far, 1e3, 1.2, 0.1, 1.3),
        (1e5, 1e5, 3.0, -0.4, 1.0),
        (40.0, far, 1.5, 0.2, 1.0),
    ] {
        let ratios = ratios(omega, zeta, alpha).with_static_friction_ratio(eta).unwrap();
        let x = -1.0 - 1.5 * alpha / omega.hypot(2.0 * zeta) - alpha;
        let start = State::new(theta, x, 0.0).unwrap();
        let slide = Trajectory::new(ratios, start)
            .unwrap()
            .map(Result::unwrap)
            .find(|phase| phase.kind != Kind::Stick)
            .unwrap();
        // The displacement decays as e^{−σt} to −1; the amplitude of the forced velocity is G.
        let slow = 1.0 / (zeta + (zeta * zeta - 1.0).sqrt());
        let (in_phase, behind) = forced_response(omega, zeta, alpha);
        let gain = omega * in_phase.hypot(behind);
        let creep = slow * (-1.0 - slide.start().x) / (1.0 - slow * slow);
        let time = (creep / gain).ln() / slow;
        let lasts = slide.duration().unwrap() / omega;
        let turn = TAU / omega;
        assert!((lasts - time).abs() < turn + 1e-9 / slow, "{ratios:?}: {lasts} for {time}");
    }
}
