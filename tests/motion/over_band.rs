//! The best friction over a band with static friction above the kinetic one, against a grid of frictions and frequencies
//! by motions from rest.

use crate::random::Random;
use stickslip::design::{Aim, BandFrictionKind, best_friction_over_band};
use stickslip::motion::{LongRun, State};
use stickslip::{Drive, Error, Excitation, Oscillator};

/// The number of designs: more by the environment variable `DESIGNS`.
fn designs(few: u32) -> u32 {
    std::env::var("DESIGNS").ok().and_then(|n| n.parse().ok()).unwrap_or(few)
}

/// The transmitted force or the absolute displacement of the motion from rest on a base that carries the surface; infinite
/// where it has no periodic limit.
fn amplitude(body: &Oscillator<f64>, drive: &Drive<f64>, aim: Aim) -> f64 {
    let ratios = drive.ratios(body).unwrap();
    let force = drive.force_amplitude(body);
    let base = force / (body.mass() * drive.angular_frequency().powi(2));
    match LongRun::from_start(ratios, State::default()) {
        // The body moves with its base, and friction carries its inertia.
        Ok(LongRun::Rest(_)) => {
            if aim == Aim::TransmittedForce {
                force
            } else {
                base
            }
        }
        Ok(limit) => {
            limit.steady_state().and_then(|steady| steady.peaks().ok()).map_or(f64::INFINITY, |peaks| {
                if aim == Aim::TransmittedForce {
                    peaks.transmitted_force * body.friction_bound()
                } else {
                    peaks.absolute_displacement * body.friction_displacement()
                }
            })
        }
        Err(_) => f64::INFINITY,
    }
}

#[test]
fn no_friction_of_a_grid_is_better() {
    let mut random = Random(3);
    let (count, mut refused, mut at_rest, mut worst) = (designs(10), 0, 0, 0.0f64);
    for i in 0..count {
        let (eta, zeta) =
            (random.between(1.05, 2.5), if random.next() < 0.3 { 0.0 } else { random.scale(0.005, 0.3) });
        let of = |friction: f64| {
            let body = Oscillator::new(1.0, 1.0, friction).unwrap().with_damping_ratio(zeta).unwrap();
            body.with_static_friction_ratio(eta).unwrap()
        };
        let low = random.between(0.2, 1.2);
        let high = low + random.between(0.2, 2.0);
        let aim = if random.next() < 0.5 { Aim::TransmittedForce } else { Aim::AbsoluteDisplacement };
        let kind =
            [Excitation::SurfaceAcceleration, Excitation::SurfaceMotion][usize::from(random.next() < 0.5)];
        let size = random.scale(0.1, 10.0);
        let drive = Drive::new(kind, size, 1.0).unwrap();
        let best = match best_friction_over_band(&of(1.0), &drive, low..=high, aim) {
            Err(Error::BandTooCostly { .. }) => {
                refused += 1;
                continue;
            }
            best => best.unwrap(),
        };
        at_rest += u32::from(best.friction >= best.rest);
        // The greatest amplitude over a grid, unless one is above a limit.
        let greatest = |friction: f64, steps: u32, limit: f64| -> f64 {
            let mut most = 0.0f64;
            for k in 0..=steps {
                // The middle of the grid comes first.
                let k = (k * 37 + steps / 2) % (steps + 1);
                let omega = low + (high - low) * f64::from(k) / f64::from(steps);
                most = most.max(amplitude(&of(friction), &Drive::new(kind, size, omega).unwrap(), aim));
                if most > limit {
                    break;
                }
            }
            most
        };
        let own = greatest(best.friction, 60, f64::INFINITY);
        assert!(own <= best.greatest * 1.001, "{i}: {own} {best:?}");
        let typed: f64 = format!("{:.6e}", best.friction).parse().unwrap();
        let own = greatest(typed, 60, f64::INFINITY);
        assert!(own <= best.greatest * 1.001, "{i}, as typed: {own} {best:?}");
        for k in 1..=60 {
            let friction = best.rest * f64::from(k) / 60.0;
            let limit = best.greatest / 1.001;
            if greatest(friction, 30, limit) < limit {
                // The coarse grid may have missed a peak.
                let fine = greatest(friction, 3000, limit);
                worst = worst.max(best.greatest / fine - 1.0);
                assert!(
                    fine >= limit,
                    "{i}: {friction} {fine} eta {eta} zeta {zeta} {low} {high} {drive:?} {aim:?} {best:?}"
                );
            }
        }
        // Rest, by the greatest force or motion of the base over the band.
        let rest = [low, high]
            .map(|omega| amplitude(&of(best.rest * 1.01), &Drive::new(kind, size, omega).unwrap(), aim));
        assert!(best.greatest <= rest[0].max(rest[1]) * (1.0 + 1e-9), "{i}: {rest:?} {best:?}");
    }
    assert!(refused * 10 <= count, "of {count}: {refused} refused, {at_rest} at rest, at most {worst} worse");
    assert!(at_rest < count - refused, "{at_rest} of {count} at rest");
}

/// A body at rest transmits 3 N, and moves by 300 m with its base; the cycle in closed form exists there, too, and is worse.
#[test]
fn rest_is_not_worse_than_the_answer() {
    for (zeta, eta, low, high, aim, at_rest) in [
        (0.02, 1.6, 0.5, 1.5, Aim::TransmittedForce, 3.0),
        (0.0, 1.3, 0.1, 5.0, Aim::AbsoluteDisplacement, 300.0),
    ] {
        let body = Oscillator::new(1.0, 1.0, 1.0).unwrap().with_damping_ratio(zeta).unwrap();
        let body = body.with_static_friction_ratio(eta).unwrap();
        let drive = Drive::new(Excitation::SurfaceAcceleration, 3.0, 1.0).unwrap();
        let best = best_friction_over_band(&body, &drive, low..=high, aim).unwrap();
        assert!(best.greatest <= at_rest * (1.0 + 1e-12), "{best:?}");
        let body = Oscillator::new(1.0, 1.0, best.friction).unwrap().with_damping_ratio(zeta).unwrap();
        let body = body.with_static_friction_ratio(eta).unwrap();
        let own = [low, high].map(|omega| {
            amplitude(&body, &Drive::new(Excitation::SurfaceAcceleration, 3.0, omega).unwrap(), aim)
        });
        assert!(own[0].max(own[1]) <= at_rest * (1.0 + 1e-12), "{own:?} {best:?}");
    }
}

/// Overdamped bodies at low frequencies have very many steps: they are refused after those of the search.
#[test]
fn a_costly_band_is_refused() {
    for zeta in [20.0, 100.0] {
        let body = Oscillator::new(1.0, 1.0, 1.0).unwrap().with_damping_ratio(zeta).unwrap();
        let drive = Drive::new(Excitation::SurfaceAcceleration, 3.0, 1.0).unwrap();
        let found = best_friction_over_band(&body, &drive, 0.01..=0.2, Aim::TransmittedForce);
        assert!(matches!(found, Err(Error::BandTooCostly { .. })), "{found:?}");
    }
}

/// Where the crest is the motion with the base, every friction of a piece is as good: the answer says how far, beside the
/// greatest amplitudes of a grid of frequencies of its own.
#[test]
fn a_flat_optimum_is_said_to_be_flat() {
    let mut flat = Vec::new();
    for (zeta, low, high, excitation, aim) in [
        (0.05, 0.44, 4.4, Excitation::SurfaceMotion, Aim::AbsoluteDisplacement),
        (0.0, 0.5, 4.0, Excitation::SurfaceMotion, Aim::AbsoluteDisplacement),
        (0.02, 0.6, 5.0, Excitation::SurfaceAcceleration, Aim::TransmittedForce),
        (0.1, 0.8, 1.2, Excitation::SurfaceAcceleration, Aim::TransmittedForce),
        (0.1, 2.0, 4.0, Excitation::SurfaceMotion, Aim::AbsoluteDisplacement),
    ] {
        let of =
            |friction: f64| Oscillator::new(1.0, 1.0, friction).unwrap().with_damping_ratio(zeta).unwrap();
        let drive = |omega| Drive::new(excitation, 2.0, omega).unwrap();
        let best = best_friction_over_band(&of(1.0), &drive(1.0), low..=high, aim).unwrap();
        let greatest = |friction: f64| {
            let at = |i: u32| low * (high / low).powf(f64::from(i) / 400.0);
            (0..=400).map(|i| amplitude(&of(friction), &drive(at(i)), aim)).fold(0.0, f64::max)
        };
        let own = |friction: f64| greatest(friction) / best.greatest - 1.0;
        let end = best.up_to.unwrap_or(best.friction);
        for i in 0..=20 {
            // The grid may miss a peak.
            let friction = best.friction * (end / best.friction).powf(f64::from(i) / 20.0);
            assert!(own(friction) < 1e-9, "{i}: {} {best:?}", own(friction));
        }
        // What is left out is worse.
        assert!(best.kind == BandFrictionKind::None || own(0.98 * best.friction) > 1e-5, "{best:?}");
        if end < best.rest {
            assert!(own(1.02 * end + 0.01 * best.rest) > 1e-5, "{best:?}");
        } else {
            assert!(own(3.0 * end) < 1e-9, "{best:?}");
        }
        flat.push(best.up_to.is_some_and(|end| end >= best.rest));
        assert!(flat.last() == Some(&true) || best.up_to.is_none(), "{best:?}");
    }
    assert_eq!(flat, [true, true, false, false, false]);
}
