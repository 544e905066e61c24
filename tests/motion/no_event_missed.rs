//! No velocity zero is missed: random motions against brute force.
//!
//! Every slide is sampled at 10⁴ instants by the textbook solution (amplitudes of the forced and the free wave,
//! turned on by rotations), which shares nothing with the library's own evaluation but the start of the slide. A
//! velocity of the wrong sign before the end that the library found is a zero that it missed.

use crate::random::Random;
use stickslip::Ratios;
use stickslip::exact::{Direction, Kind, Phase, State, Trajectory};

const MOTIONS: u64 = 100_000;
const SAMPLES: usize = 10_000;

/// One motion: ratios and start. All of Ω from 1e-3 to 1e3, with a preference for where zeros crowd.
fn draw(random: &mut Random) -> (f64, f64, State<f64>) {
    let omega = match (random.next() * 4.0) as u32 {
        0 => random.scale(1e-3, 1e3),
        1 => random.between(0.08, 0.5),
        _ => random.between(0.3, 2.5),
    };
    let alpha = random.scale(1.001, 50.0);
    let theta = random.between(0.0, std::f64::consts::TAU);
    let reach = random.scale(0.01, 10.0) * (1.0 + alpha) / (1.0 + omega * omega);
    let x = reach * random.between(-1.0, 1.0);
    let v = if random.next() < 0.4 { 0.0 } else { reach * random.between(-1.0, 1.0) / omega };
    (omega, alpha, State::new(theta, x, v).unwrap())
}

/// The least velocity, in the direction of the slide, over its samples, and the size of its terms.
fn least_velocity(omega: f64, alpha: f64, phase: &Phase<f64>, sign: f64) -> (f64, f64) {
    let start = phase.start();
    let (sine, cosine) = start.phase.sin_cos();
    let forced = alpha / ((1.0 - omega) * (1.0 + omega));
    // w = forced Ω cos θ + a cos φ − b sin φ
    let a = omega * start.v - forced * omega * cosine;
    let b = start.x + sign - forced * sine;
    let h = phase.duration().unwrap() / omega / (SAMPLES as f64);
    const LANES: usize = 8;
    const BLOCK: usize = 50;
    let (mut least, f) = (f64::INFINITY, forced * omega * sign);
    let (step_drive, step_free) = ((omega * h * LANES as f64).sin_cos(), (h * LANES as f64).sin_cos());
    // Rotations by LANES samples; each block of BLOCK starts afresh, so that rounding does not pile up.
    let mut first = 0;
    while first < SAMPLES {
        let mut d = [(0.0, 0.0); LANES];
        let mut n = [(0.0, 0.0); LANES];
        for lane in 0..LANES {
            let phi = (first + lane) as f64 * h;
            let (s, c) = (omega * phi).sin_cos();
            d[lane] = (sine * c + cosine * s, cosine * c - sine * s);
            n[lane] = phi.sin_cos();
        }
        let mut lows = [f64::INFINITY; LANES];
        for step in 0..BLOCK {
            for lane in 0..LANES {
                let w = f * d[lane].1 + sign * (a * n[lane].1 - b * n[lane].0);
                let counts = first + lane + LANES * step < SAMPLES && first + lane + step > 0;
                lows[lane] = if counts && w < lows[lane] { w } else { lows[lane] };
                let turn = |(s, c): (f64, f64), (u, v): (f64, f64)| (s * v + c * u, c * v - s * u);
                d[lane] = turn(d[lane], step_drive);
                n[lane] = turn(n[lane], step_free);
            }
        }
        least = lows.iter().fold(least, |m, &w| m.min(w));
        first += LANES * BLOCK;
    }
    (least, (forced * omega).abs() + a.abs() + b.abs())
}

#[test]
fn brute_force_finds_no_earlier_zero() {
    let mut random = Random(42);
    let (mut slides, mut with_dips) = (0u64, 0u64);
    for number in 0..MOTIONS {
        let (omega, alpha, start) = draw(&mut random);
        if (omega - 1.0).abs() < 1e-4 {
            continue;
        }
        let motion = Trajectory::new(Ratios::new(omega, alpha).unwrap(), start).unwrap();
        for phase in motion.take(3).map(Result::unwrap) {
            let Kind::Slide(direction) = phase.kind() else { continue };
            let sign = if direction == Direction::Forward { 1.0 } else { -1.0 };
            let (least, size) = least_velocity(omega, alpha, &phase, sign);
            let turned = phase.duration().unwrap() * (1.0 + 1.0 / omega);
            assert!(
                least > -1e-15 * size * (4.0 + turned),
                "motion {number}, Ω = {omega}, α = {alpha}, {start:?}: velocity {least:e} of {size:e} in {phase:?}"
            );
            let end = phase.at(phase.end().unwrap().phase).state.v * omega;
            assert!(
                end.abs() < 1e-15 * size * (4.0 + 4.0 * turned + 2.0 / omega),
                "motion {number}, Ω = {omega}, α = {alpha}: {end:e} of {size:e} at the end of {phase:?}"
            );
            slides += 1;
            with_dips += u64::from(least < 0.05 * size && phase.duration().unwrap() > 3.0 * omega);
            break;
        }
    }
    assert!(slides >= MOTIONS * 9 / 10, "{slides}");
    assert!(with_dips > 1000, "{with_dips}");
}
