//! Closed forms and laws that a motion under a record obeys.

use std::f64::consts::TAU;
use stickslip::motion::record::{Body, Record};
use stickslip::{Cycle, Excitation, Ratios};

const G: f64 = 9.80665;

/// A block under a rectangular pulse a of length t slides by a(a − r)t²/(2r), and one on a slope likewise.
#[test]
fn a_block_under_a_rectangular_pulse_has_newmarks_displacement() {
    for (a, r, t) in [(0.3 * G, 0.1 * G, 1.0), (2.0, 0.01, 0.25), (1.0, 0.99, 7.0)] {
        let record = Record::new(Excitation::SurfaceAcceleration, t / 4.0, vec![-a; 5]).unwrap();
        let answer = Body::new(3.0, 3.0 * r).unwrap().follow(&record).unwrap();
        let exact = a * (a - r) * t * t / (2.0 * r);
        // The difference of a and r has the rounding of both.
        let rounding = 4.0 * f64::EPSILON * a / (a - r);
        assert!((answer.residual_displacement.unwrap() / exact - 1.0).abs() < rounding, "{answer:?} {exact}");
        assert_eq!((answer.slides, answer.stops), (1, 1));
        // Gravity along a slope adds to the pulse and takes from friction after it.
        let slope = 0.25 * r;
        let body = Body::new(3.0, 3.0 * r).unwrap().with_mean_force(3.0 * slope).unwrap().one_way();
        let answer = body.follow(&record).unwrap();
        let (up, down) = (a + slope - r, r - slope);
        let exact = up * t * t / 2.0 * (1.0 + up / down);
        let rounding = 8.0 * f64::EPSILON * (a + slope) / up;
        assert!((answer.residual_displacement.unwrap() / exact - 1.0).abs() < rounding, "{answer:?} {exact}");
    }
}

/// The straight lines of a sampled sine are off by (2π/n)²/8 of its amplitude at most, and the steady motion under
/// them by the same order.
#[test]
fn a_sampled_sine_tends_to_the_steady_motion_quadratically() {
    let (omega, alpha, zeta, cycles) = (0.7, 2.5, 0.1, 60u32);
    let ratios = Ratios::new(omega, alpha).unwrap().with_damping_ratio(zeta).unwrap();
    let exact = Cycle::new(ratios).unwrap().max_displacement;
    // With m = k = r = 1 the displacement is in units of B.
    let body = Body::new(1.0, 1.0).unwrap().with_stiffness(1.0).unwrap().with_damping(2.0 * zeta).unwrap();
    let errors = [16, 32, 64, 128, 256].map(|n: u32| {
        let step = TAU / omega / f64::from(n);
        let samples = (0..=cycles * n).map(|i| alpha * (TAU * f64::from(i) / f64::from(n)).cos());
        let record = Record::new(Excitation::Force, step, samples.collect()).unwrap();
        let motion = body.motion(&record, 0.0, 0.0, 1.0).unwrap();
        let mut stops =
            motion.events.iter().filter(|event| event.direction == 0 && event.time < record.end());
        (stops.next_back().unwrap().displacement.abs() - exact).abs()
    });
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((1.9..2.1).contains(&order), "{errors:?}");
    }
}

/// A record at f32 agrees with f64 to f32's digits.
#[test]
fn records_in_single_precision() {
    let samples: Vec<f64> =
        (0..200).map(|i| 3.0 * (f64::from(i) * 0.3).sin() * (f64::from(i) * 0.05).sin()).collect();
    let wide = Record::new(Excitation::SurfaceAcceleration, 0.02, samples.clone()).unwrap();
    let narrow = samples.iter().map(|x| *x as f32).collect();
    let narrow = Record::new(Excitation::SurfaceAcceleration, 0.02f32, narrow).unwrap();
    let one = Body::new(1.0, 0.5).unwrap().with_stiffness(40.0).unwrap().follow(&wide).unwrap();
    let two = Body::new(1.0f32, 0.5).unwrap().with_stiffness(40.0).unwrap().follow(&narrow).unwrap();
    assert_eq!((one.slides, one.stops), (two.slides, two.stops));
    assert!((one.path - f64::from(two.path)).abs() < 1e-5 * one.path, "{one:?} {two:?}");
}

/// The damper's work, which follows from the balance, is ∫ c x′² dt.
#[test]
fn the_dampers_work_is_that_of_its_force() {
    let samples = vec![0.0, 3.0, -4.0, 2.0, 5.0, -1.0, 0.0, 0.0, 2.0, -3.0, 1.0];
    let record = Record::new(Excitation::Force, 0.3, samples).unwrap();
    let body = Body::new(2.0, 0.6).unwrap().with_stiffness(30.0).unwrap().with_damping(1.5).unwrap();
    let motion = body.motion(&record, 0.0, 0.0, 1e-4).unwrap();
    let work: f64 = motion
        .states
        .windows(2)
        .filter(|pair| pair[0].direction != 0)
        .map(|pair| {
            let (one, two) = (pair[0], pair[1]);
            // Simpson's rule with the mean velocity in between.
            let middle: f64 = (one.velocity + two.velocity) / 2.0
                + (one.acceleration - two.acceleration) * (two.time - one.time) / 8.0;
            let squares = one.velocity.powi(2) + 4.0 * middle.powi(2) + two.velocity.powi(2);
            1.5 * squares * (two.time - one.time) / 6.0
        })
        .sum();
    let exact = motion.answer.damper_work;
    assert!((work / exact - 1.0).abs() < 1e-6, "{work} {exact}");
}

/// A short pulse lets the body swing for much longer than the record: its states lie on arcs of cosines, at most an interval apart, to its
/// rest.
#[test]
fn the_states_of_a_motion_reach_its_rest() {
    let record = Record::at_times(Excitation::Force, vec![0.0, 0.05, 0.1], vec![0.0, 12.0, 0.0]).unwrap();
    let body = Body::new(2.0, 0.02).unwrap().with_stiffness(50.0).unwrap();
    let motion = body.motion(&record, 0.0, 0.0, 0.01).unwrap();
    let rest = motion.events.last().unwrap().time;
    assert!(rest > 10.0 * record.end(), "{rest}");
    let last = motion.states.last().unwrap();
    assert!(last.time == rest && last.velocity == 0.0, "{last:?}");
    let mut after = 0;
    for pair in motion.states.windows(2) {
        assert!(pair[1].time - pair[0].time <= 0.01 * (1.0 + 1e-9), "{pair:?}");
        if pair[0].time >= record.end() && pair[0].direction == pair[1].direction && pair[0].direction != 0 {
            // About the place where spring and friction balance.
            let centre = -f64::from(pair[0].direction) * 0.02 / 50.0;
            let (phase, from) = (5.0 * (pair[1].time - pair[0].time), pair[0].displacement - centre);
            let arc = centre + from * phase.cos() + pair[0].velocity / 5.0 * phase.sin();
            assert!((pair[1].displacement - arc).abs() < 1e-12, "{pair:?} {arc}");
            after += 1;
        }
    }
    assert!(after > 500, "{after}");
}
