//! Bodies that only tend to rest: however small the speed of such a slide is beside its rounding, it has no stop, and the
//! next change of the load finds it in motion.

use stickslip::Excitation;
use stickslip::Float;
use stickslip::motion::record::{After, Body, Record, RecordAnswer};

/// A body by m, k, c, r and η.
fn body<F: Float>([m, k, c, r, eta]: [f64; 5]) -> Body<F> {
    let of = F::from_f64;
    Body::new(of(m), of(r))
        .and_then(|body| body.with_stiffness(of(k)))
        .and_then(|body| body.with_damping(of(c)))
        .and_then(|body| body.with_static_friction_ratio(of(eta)))
        .unwrap()
}

fn record<F: Float>(excitation: Excitation, times: &[f64], samples: &[f64]) -> Record<F> {
    let of = |numbers: &[f64]| numbers.iter().map(|x| F::from_f64(*x)).collect();
    Record::at_times(excitation, of(times), of(samples)).unwrap()
}

/// The same answers alone and with others, to the last bit.
fn follow(of: Body<f64>, record: &Record<f64>) -> RecordAnswer<f64> {
    let found = of.follow(record).unwrap();
    #[cfg(feature = "batch")]
    {
        let others = [of, body([1.0, 30.0, 0.1, 0.5, 1.0]), of, body([2.0, 9.0, 50.0, 0.0, 1.0])];
        let each = stickslip::motion::record::follow_each(&others, record);
        assert_eq!((each[0].as_ref(), each[2].as_ref()), (Ok(&found), Ok(&found)));
    }
    found
}

/// A critically damped body after a pulse, by an independent program of 110 digits.
#[test]
fn a_critically_damped_body_creeps_after_a_pulse() {
    let times = [0.0, 2.0, 4.0, 14.0, 16.0, 18.0, 22.0, 22.6, 26.6, 30.6, 31.2, 41.2];
    let mut samples = [0.0; 12];
    samples[5] = -7.5;
    let pulse = record(Excitation::SurfaceAcceleration, &times, &samples);
    let found = follow(body([2.0, 50.0, 20.0, 2.4, 1.2]), &pulse);
    assert!((found.stick_time - 17.652_839_194_6).abs() < 1e-9, "{found:?}");
    assert_eq!((found.slides, found.stops, found.tends_to_rest), (2, 1, true));
}

/// Without friction a decaying vibration turns every π/d, also when it is far below the rounding of its place.
#[test]
fn a_decaying_vibration_turns_every_half_period() {
    let (beta, omega, place) = (0.2, 1.0f64, 7.0);
    let d = (omega * omega - beta * beta).sqrt();
    for count in [3, 11, 400] {
        let times: Vec<f64> = (0..count).map(|i| 800.0 * f64::from(i) / f64::from(count - 1)).collect();
        let held = record(Excitation::Force, &times, &vec![place; times.len()]).followed_by(After::Hold);
        let found = follow(body([1.0, omega * omega, 2.0 * beta, 0.0, 1.0]), &held);
        let turns = (800.0 * d / std::f64::consts::PI).floor();
        assert_eq!(
            (found.reversals, found.stops, found.stick_time),
            (turns as u64, 0, 0.0),
            "{count} {found:?}"
        );
        assert!(found.tends_to_rest && (found.residual_displacement.unwrap() - place).abs() < 1e-13);
    }
    // Without a spring, too, a body that a damper alone slows down never stops.
    let still = record(Excitation::Force, &[0.0, 5.0, 100.0], &[0.0; 3]);
    let coasts = body([1.0, 0.0, 5.0, 0.0, 1.0]).follow_from(&still, 0.0, 2.0).unwrap();
    assert_eq!((coasts.slides, coasts.stops, coasts.stick_time, coasts.tends_to_rest), (1, 0, 0.0, true));
    assert!((coasts.residual_displacement.unwrap() - 0.4f64).abs() < 1e-15);
    // A creep without friction has no turn at all.
    for c in [2.0, 2.5, 40.0] {
        let held = record(Excitation::Force, &[0.0, 100.0, 300.0], &[3.0; 3]).followed_by(After::Hold);
        let found = follow(body([1.0, 1.0, c, 0.0, 1.0]), &held);
        assert_eq!((found.slides, found.stops, found.stick_time), (1, 0, 0.0), "{c} {found:?}");
    }
}

/// Pulses with pauses in which the body creeps: at f64 as at 1024 bits, at which no speed is lost in rounding.
#[cfg(feature = "mp")]
#[test]
fn pauses_of_a_creep_are_no_rests_at_any_precision() {
    use stickslip::float::Mp;
    let sizes = [9.0, -7.0, 0.0, 4.0, 11.0, -12.0, 3.0, 5.0];
    for zeta in [0.97, 1.0, 1.02, 1.7, 6.0] {
        for (friction, eta) in [(1.5, 1.0), (1.5, 1.3)] {
            let (mut times, mut samples) = (vec![0.0], vec![0.0]);
            for (i, size) in sizes.iter().enumerate() {
                let last: f64 = times[times.len() - 1];
                let pause = [4.0, 9.0, 1.0, 20.0][i % 4];
                times.extend([last + 0.5, last + 1.0, last + 1.0 + pause / 2.0, last + 1.0 + pause]);
                samples.extend([*size, size / 2.0, size / 2.0, size / 2.0]);
            }
            let of = [2.0, 50.0, 2.0 * zeta * 10.0, friction, eta];
            let found = follow(body(of), &record(Excitation::Force, &times, &samples));
            let due = body::<Mp<16>>(of).follow(&record(Excitation::Force, &times, &samples)).unwrap();
            let counts = |slides, stops, reversals| [slides, stops, reversals];
            assert_eq!(
                counts(found.slides, found.stops, found.reversals),
                counts(due.slides, due.stops, due.reversals),
                "{of:?}"
            );
            assert!((found.stick_time - due.stick_time.to_f64()).abs() < 1e-11, "{of:?} {found:?}");
            assert!((found.path - due.path.to_f64()).abs() < 1e-13 * found.path, "{of:?}");
            assert_eq!(found.tends_to_rest, due.tends_to_rest);
        }
    }
}
