//! Steps that are long beside the decay of the motion, and starts that are slow beside the step, held against the closed form.

use crate::generator::Random;
use stickslip::Excitation;
use stickslip::motion::record::{Body, Record};

/// 1 − e^{−z}, and the integrals of it from 0, once and twice: by their series where they would cancel.
fn decays(z: f64) -> [f64; 3] {
    let first = -(-z).exp_m1();
    if z > 1.0 {
        return [first, z - first, z * z / 2.0 - z + first];
    }
    let sum = |from: i32| {
        let mut term = (1..=from).fold(1.0, |term, n| term * z / f64::from(n));
        let mut sum = 0.0;
        for n in from + 1..from + 25 {
            sum += term;
            term *= -z / f64::from(n);
        }
        sum
    };
    [first, sum(2), sum(3)]
}

/// Without a spring the force f₀ + su gives the velocity `f₀/c (1 − e^{−z}) + sm/c² (z − 1 + e^{−z})` after the time u =
/// zm/c. It stops where that vanishes, which halving finds.
#[test]
fn a_body_with_a_damper_alone_stops_where_its_velocity_vanishes() {
    let mut random = Random(5);
    for _ in 0..3_000 {
        let (mass, length) = (random.scale(0.1, 10.0), random.scale(0.01, 20.0));
        let damping = random.scale(1.0, 1e5) * mass / length;
        // It slides back from rest, the load turns it, and it is held until the load exceeds the friction again.
        let (first, last) = (-1.0 - random.scale(1e-3, 1.0), random.scale(3.0, 1e3));
        let body = Body::new(mass, 1.0).and_then(|body| body.with_damping(damping)).unwrap();
        let record = Record::new(Excitation::Force, length, vec![first, last]).unwrap();
        let found = body.follow(&record).unwrap();
        let (rate, slope) = (damping / mass, (last - first) / length);
        let (begin, rise) = ((first + 1.0) / damping, slope / damping / rate);
        let velocity = |u: f64| {
            let [one, two, _] = decays(rate * u);
            begin * one + rise * two
        };
        let (mut low, mut high) = (0.0, length);
        for _ in 0..2_000 {
            let middle = low + (high - low) / 2.0;
            if velocity(middle) < 0.0 { low = middle } else { high = middle }
        }
        let [_, two, three] = decays(rate * low);
        let due = (begin * two + rise * three) / rate;
        let released = (1.0 - first) / slope;
        let by = (found.stick_time - (released - low)).abs();
        let at = format!("{} constants of time: {found:?}", rate * length);
        assert!(by <= 1e-13 * released, "{} for {}, {at}", found.stick_time, released - low);
        let by = (found.min_displacement - due).abs();
        assert!(by <= 1e-12 * due.abs(), "{} for {due}, {at}", found.min_displacement);
    }
}

/// A body that starts far more slowly than the load changes moves `mv²/2` over the force that brakes it.
#[test]
fn a_slow_start_stops_after_its_energy_is_lost() {
    for exponent in (20..150).step_by(3) {
        let v = 10f64.powi(-exponent);
        for sign in [1.0, -1.0] {
            let body = Body::new(23.7, 0.49)
                .and_then(|body| body.with_stiffness(1e4))
                .and_then(|body| body.with_static_friction_ratio(1.5))
                .and_then(|body| body.with_mean_force(-sign * 0.1775))
                .unwrap();
            let record = Record::new(Excitation::Force, 0.108, vec![sign * 0.05, sign * 0.2]).unwrap();
            let found = body.follow_from(&record, 0.0, sign * v).unwrap();
            let due = sign * 23.7 * v * v / (2.0 * (0.49 + 0.1775 - 0.05));
            let x = found.end_displacement;
            assert!((x / due - 1.0).abs() < 1e-14, "{v:e}: {x:e} for {due:e}");
        }
    }
}

/// Without friction and damper a body that no load moves rests as long as the record, not for the period of the vibration
/// that would follow.
#[test]
fn the_time_at_rest_is_that_of_the_record() {
    for (stiffness, samples) in [(4.0, 2), (0.25, 11)] {
        let body = Body::new(1.0, 0.0).and_then(|body| body.with_stiffness(stiffness)).unwrap();
        let record = Record::new(Excitation::Force, 0.5, vec![0.0; samples]).unwrap();
        let found = body.follow(&record).unwrap();
        assert_eq!((found.stick_time, found.slides), (record.end(), 0));
    }
}

/// Motions of a body with friction and a damper alone over steps of up to 10⁴ time constants, enclosed: signs do not fade with
/// e^{−cu/m}. Where the body is at rest at both ends its way is `(∫ f du ∓ r u)/c`, and it stops where `f = r − ms/c`, s being the slope
/// of the load, but for e^{−1000}.
#[cfg(feature = "mp")]
#[test]
fn steps_of_thousands_of_time_constants_are_enclosed() {
    use stickslip::enclosed;
    use stickslip::float::Mp;
    let of = |x: f64| Mp::<4>::from(x);
    for (length, mass, damping, friction) in
        [(2e3, 1.0, 1.0, 0.25), (3e3, 2.0, 1.5, 0.5), (1e4, 1.0, 1.0, 0.25)]
    {
        // Constant, falling to −1, and constant; then the force is zero.
        let samples = [2.0, 2.0, -1.0, -1.0].map(of).to_vec();
        let record = Record::new(Excitation::Force, of(length), samples).unwrap();
        let body = Body::new(of(mass), of(friction)).and_then(|body| body.with_damping(of(damping))).unwrap();
        let found = enclosed::follow(&body, &record, of(0.0), of(0.0), 64);
        let found = found.unwrap_or_else(|e| panic!("{length}: {e}"));
        let (slope, push, pull) = (3.0 / length, 2.0 - friction, 1.0 - friction);
        let stop = push / slope + mass / damping;
        let most = (push * length + push * stop - slope * stop * stop / 2.0) / damping;
        let back = length - (2.0 + friction) / slope;
        let braked = mass / damping * (1.0 / friction).ln();
        let way = slope * back * back / 2.0 + pull * length - friction * braked;
        let close = |name: &str, found: &enclosed::Enclosure, due: f64| {
            let off = (found.mid.to_f64() - due).abs();
            assert!(
                off <= 1e-13 * most && found.rad.to_f64() <= 1e-15 * most,
                "{length} {name}: {found}, {due}"
            );
        };
        close("most", &found.max_displacement, most);
        close("end", &found.residual_displacement.unwrap(), most - way / damping);
        assert_eq!(found.slides, 2, "{length}");
    }
}
