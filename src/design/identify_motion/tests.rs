use super::identify_motion;
use crate::Excitation;
use crate::motion::record::{Body, Record};

/// Numbers that repeat in every run, nearly normal: the sum of twelve uniform ones.
fn normal(state: &mut u64) -> f64 {
    let mut uniform = || {
        *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*state >> 11) as f64 / (1u64 << 53) as f64
    };
    (0..12).map(|_| uniform()).sum::<f64>() - 6.0
}

/// Lines between the samples would be too low by a tenth of a per cent, of which friction takes several of its errors.
#[test]
fn a_curved_load_between_its_samples_is_no_friction() {
    // 40 times as many lines: an error of the load that is 1600 times less.
    const FINE: usize = 40;
    let (mass, stiffness, friction, zeta) = (2.0, 800.0, 4.0, 0.05);
    let body = Body::new(mass, friction).and_then(|b| b.with_stiffness(stiffness)).unwrap();
    let body = body.with_damping_ratio(zeta).unwrap();
    let omega = core::f64::consts::TAU * 4.0;
    let step = 1.0 / 200.0;
    let one = |t: f64| 9.0 * (omega * t).sin();
    let two = |t: f64| 6.0 * (omega * t).sin() + 5.0 * (1.37 * omega * t + 0.4).sin();
    for (which, wave) in [&one as &dyn Fn(f64) -> f64, &two].into_iter().enumerate() {
        let fine = step / FINE as f64;
        let samples = (0..=400 * FINE).map(|i| wave(i as f64 * fine)).collect();
        let dense = Record::new(Excitation::Force, fine, samples).unwrap();
        let motion = body.motion(&dense, 0.0, 0.0, fine).unwrap();
        let place = |time: f64| {
            let at = motion.states.partition_point(|state| state.time <= time + 1e-9);
            motion.states[at - 1].displacement
        };
        let exact: Vec<f64> = (0..=400).map(|i| place(f64::from(i) * step)).collect();
        let most = exact.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let samples = (0..=400).map(|i| wave(f64::from(i) * step)).collect();
        let load = Record::new(Excitation::Force, step, samples).unwrap();
        let (mut state, mut inside) = (which as u64 + 7, 0);
        for _ in 0..10 {
            let measured: Vec<f64> = exact.iter().map(|x| x + 0.003 * most * normal(&mut state)).collect();
            let found = identify_motion(mass, Some(stiffness), &load, &measured).unwrap();
            let (low, high) = found.friction.interval();
            inside += u32::from((low..=high).contains(&friction));
        }
        // Fewer than 7 of 10 intervals of 95 % have a probability of 1e-3.
        assert!(inside >= 7, "{which}: {inside} of 10");
    }
}

/// A load that is straight between its samples is told from one that is not by the displacements.
#[test]
fn straight_lines_are_known_by_the_motion() {
    let body = Body::new(2.0, 4.0).and_then(|b| b.with_stiffness(800.0)).unwrap();
    let body = body.with_damping_ratio(0.05).unwrap();
    let samples = (0..200).map(|i| 9.0 * (0.3 * f64::from(i)).sin()).collect();
    let load = Record::new(Excitation::Force, 0.01, samples).unwrap();
    let motion = body.motion(&load, 0.0, 0.0, 1.0).unwrap();
    let place = |time: f64| {
        let at = motion.states.partition_point(|state| state.time <= time);
        motion.states[at - 1].displacement
    };
    let exact: Vec<f64> = (0..200).map(|i| place(load.time(i))).collect();
    let found = identify_motion(2.0, Some(800.0), &load, &exact).unwrap();
    assert!((found.friction.value - 4.0).abs() < 1e-6 && (found.damping_ratio.value - 0.05).abs() < 1e-7);
}
