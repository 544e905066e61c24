use super::{Aim, Band, BandFrictionKind, best_friction_over_band};
use crate::machine::error::Error;
use crate::{Drive, Excitation, Oscillator};

/// A body of 2 kg with ω_n = 3.
fn body(zeta: f64, eta: f64) -> Oscillator<f64> {
    let body = Oscillator::new(2.0, 18.0, 1.0).unwrap().with_damping_ratio(zeta).unwrap();
    body.with_static_friction_ratio(eta).unwrap()
}

/// The greatest amplitude by a dense mesh of its own, with the neighbourhood of its greatest places once more.
fn dense(band: &Band<'_, f64>, friction: f64, low: f64, high: f64) -> f64 {
    let at = |omega: f64| band.at(friction, omega).unwrap();
    let place = |i: u32, n: u32, low: f64, high: f64| low + (high - low) * f64::from(i) / f64::from(n);
    let mut places: Vec<(f64, f64)> =
        (0..=500).map(|i| place(i, 500, low, high)).map(|w| (w, at(w))).collect();
    places.sort_by(|a, b| b.1.total_cmp(&a.1));
    let mut apart: Vec<(f64, f64)> = Vec::new();
    for place in places {
        if apart.len() < 3 && apart.iter().all(|other| (other.0 - place.0).abs() > 0.02 * high) {
            apart.push(place);
        }
    }
    for most in &mut apart {
        for step in [3e-3, 1e-4, 5e-6, 2e-7] {
            let (from, to) = ((most.0 - step * high).max(low), (most.0 + step * high).min(high));
            for omega in (0..=50).map(|i| place(i, 50, from, to)) {
                if at(omega) > most.1 {
                    *most = (omega, at(omega));
                }
            }
        }
    }
    apart.into_iter().map(|most| most.1).fold(0.0, f64::max)
}

/// No friction of a mesh of its own is better by more than 10⁻⁹.
#[test]
fn no_other_friction_is_better() {
    let cases = [
        (Excitation::SurfaceMotion, Aim::AbsoluteDisplacement, 0.5, 4.0),
        (Excitation::SurfaceMotion, Aim::TransmittedForce, 0.3, 2.0),
        (Excitation::SurfaceAcceleration, Aim::Acceleration, 0.8, 3.0),
        (Excitation::SurfaceVelocity, Aim::AbsoluteDisplacement, 0.4, 5.0),
        (Excitation::Unbalance, Aim::TransmittedForce, 0.7, 6.0),
        (Excitation::Force, Aim::TransmittedForce, 0.6, 1.8),
    ];
    for (i, (excitation, aim, low, high)) in cases.into_iter().enumerate() {
        for zeta in if i % 2 == 0 { [0.07] } else { [0.0] } {
            let (body, drive) = (body(zeta, 1.0), Drive::new(excitation, 0.7, 1.0).unwrap());
            let (low, high) = (3.0 * low, 3.0 * high);
            let best = best_friction_over_band(&body, &drive, low..=high, aim).unwrap();
            let band = Band::new(&body, &drive, low, high, aim).unwrap();
            let own = dense(&band, best.friction, low, high);
            assert!(own <= best.greatest * (1.0 + 1e-9), "{i} {zeta}: {own} {best:?}");
            let spread = (0..16).map(|k| best.rest * 0.4f64.powi(k));
            let near = (-4..=4).map(|k| best.friction * (1.0 + 3e-3 * f64::from(k)));
            for friction in spread.chain(near).filter(|&friction| friction <= best.rest) {
                let other = dense(&band, friction, low, high);
                assert!(other >= best.greatest * (1.0 - 1e-9), "{i} {zeta}: {friction} {other} {best:?}");
            }
        }
    }
}

/// The classical isolator: where the body moves with its base at the crest, and the peak beyond, balance.
#[test]
fn two_frequencies_balance() {
    let drive = Drive::new(Excitation::SurfaceMotion, 0.05, 1.0).unwrap();
    let body = body(0.0, 1.0);
    let best = best_friction_over_band(&body, &drive, 1.5..=12.0, Aim::AbsoluteDisplacement).unwrap();
    assert_eq!((best.kind, best.at.len()), (BandFrictionKind::Interior, 2));
    assert!((best.greatest / 0.05 - 1.0).abs() < 1e-9, "{best:?}");
    assert!(best.at[0].0 == 1.5 && best.at[0].1 > 3.0 && best.at[1].0 == best.at[1].1, "{best:?}");
    let band = Band::new(&body, &drive, 1.5, 12.0, Aim::AbsoluteDisplacement).unwrap();
    assert!(band.value(best.friction * 0.999, f64::INFINITY).unwrap() > 0.05 * 1.000_1);
}

#[test]
fn a_displacement_is_least_at_rest() {
    let drive = Drive::force(7.0, 1.0).unwrap();
    for aim in [Aim::Displacement, Aim::Acceleration] {
        let best = best_friction_over_band(&body(0.1, 1.4), &drive, 1.0..=2.0, aim).unwrap();
        assert_eq!((best.kind, best.greatest), (BandFrictionKind::Rest, 0.0));
        assert!((best.friction - 5.0).abs() < 1e-14);
    }
    let best = best_friction_over_band(&body(0.0, 1.0), &drive, 6.0..=9.0, Aim::TransmittedForce).unwrap();
    assert_eq!(best.kind, BandFrictionKind::None);
}

#[test]
fn wrong_bands_are_refused() {
    let (body, drive) = (body(0.0, 1.0), Drive::force(7.0, 1.0).unwrap());
    let of = |low, high, aim| best_friction_over_band(&body, &drive, low..=high, aim);
    assert!(matches!(of(2.0, 2.0, Aim::Displacement), Err(Error::EmptyRange { .. })));
    assert!(matches!(of(-1.0, 2.0, Aim::Displacement), Err(Error::NotPositive { .. })));
    assert!(of(1.0, f64::NAN, Aim::Displacement).is_err());
    assert!(matches!(of(1.0, 2.0, Aim::AbsoluteDisplacement), Err(Error::SurfaceAtRest { .. })));
}
