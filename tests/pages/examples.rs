//! The examples print what docs/development/examples.md shows, and their most important numbers are verified in another
//! way.

#[path = "../../examples/damper.rs"]
#[allow(dead_code, reason = "its main runs it as a program")]
mod damper;
#[path = "../../examples/dither.rs"]
#[allow(dead_code, reason = "its main runs it as a program")]
mod dither;
#[path = "../../examples/isolator.rs"]
#[allow(dead_code, reason = "its main runs it as a program")]
mod isolator;
#[cfg(feature = "serde")]
#[path = "../../examples/machine.rs"]
#[allow(dead_code, reason = "its main runs it as a program")]
mod machine;
#[cfg(feature = "mp")]
#[path = "../../examples/resonance.rs"]
#[allow(dead_code, reason = "its main runs it as a program")]
mod resonance;
#[cfg(feature = "dual")]
#[path = "../../examples/sensitivities.rs"]
#[allow(dead_code, reason = "its main runs it as a program")]
mod sensitivities;

use std::f64::consts::TAU;
use stickslip::motion::{LongRun, State};
use stickslip::{Drive, Oscillator, Ratios};

/// The output of an example in docs/development/examples.md.
fn shown(name: &str) -> String {
    let page = include_str!("../../docs/development/examples.md");
    let block = page
        .split("```console\n")
        .skip(1)
        .filter_map(|block| block.split("```").next()?.split_once('\n'))
        .find(|(command, _)| command.contains(&format!("--example {name}")));
    block.unwrap_or_else(|| panic!("docs/development/examples.md does not show {name}")).1.to_owned()
}

type Answer = fn(&mut Vec<u8>) -> Result<(), Box<dyn std::error::Error>>;

fn printed(answer: Answer) -> String {
    let mut out = Vec::new();
    answer(&mut out).unwrap();
    String::from_utf8(out).unwrap()
}

/// The numbers of a line, in order.
fn numbers(line: &str) -> Vec<f64> {
    line.split_whitespace().filter_map(|word| word.parse().ok()).collect()
}

/// Peak displacement of the exact motion from rest, in units of length, and its stops in a cycle.
fn exact(body: &Oscillator<f64>, force: f64, frequency: f64) -> (f64, u32) {
    let ratios: Ratios<f64> = Drive::force(force, frequency).unwrap().ratios(body).unwrap();
    let motion = LongRun::from_start(ratios, State::default()).unwrap();
    let steady = motion.steady_state().unwrap();
    (steady.max_displacement.value * body.friction_displacement(), steady.sticks_per_cycle)
}

#[test]
fn the_page_shows_what_they_print() {
    assert_eq!(printed(dither::answer), shown("dither"));
    assert_eq!(printed(isolator::answer), shown("isolator"));
    assert_eq!(printed(damper::answer), shown("damper"));
    #[cfg(feature = "serde")]
    assert_eq!(printed(machine::answer), shown("machine"));
    #[cfg(feature = "mp")]
    assert_eq!(printed(resonance::answer), shown("resonance"));
    #[cfg(feature = "dual")]
    assert_eq!(printed(sensitivities::answer), shown("sensitivities"));
}

/// At one percent below the minimum force the exact motion sticks; at 20 % above, its displacement is the
/// stated one.
#[test]
fn the_dither_is_the_least() {
    let spool = Oscillator::new(0.050, 20e3, 6.0).unwrap();
    for line in shown("dither").lines().skip(1) {
        let found = numbers(line);
        let (hertz, least, micrometres) = (found[0], found[1], found[2]);
        assert!(exact(&spool, 0.99 * least, TAU * hertz).1 > 0, "{line}");
        let (shake, stops) = exact(&spool, 1.2 * least, TAU * hertz);
        assert_eq!(stops, 0, "{line}");
        assert!((1e6 * shake / micrometres - 1.0).abs() < 0.02, "{line}: {shake}");
    }
}

/// The cabinet and the floor in the fixed frame, by small steps of Heun's method, independent of the library.
#[test]
fn the_cabinet_slides_as_far_in_the_frame_of_the_room() {
    for line in shown("isolator").lines().skip(1).take(3) {
        let found = numbers(line);
        let (frequency, slide, felt) = (TAU * found[0], found[1], found[2]);
        let (mass, stiffness, friction) = (800.0, 800.0 * (TAU / 2.5_f64).powi(2), 0.06 * 800.0 * 9.81);
        let floor = |t: f64| {
            let reach = 2.0 / (frequency * frequency);
            (reach * (frequency * t).sin(), reach * frequency * (frequency * t).cos())
        };
        let acceleration = |t: f64, x: f64, v: f64| {
            let (u, rate) = floor(t);
            -(stiffness * (x - u) + friction * (v - rate).signum()) / mass
        };
        let steps = 20_000;
        let (dt, cycles) = (TAU / frequency / f64::from(steps), 40);
        let (mut x, mut v) = (0.0, 0.0);
        let (mut furthest, mut hardest) = (0.0_f64, 0.0_f64);
        for i in 0..cycles * steps {
            let t = f64::from(i) * dt;
            let a = acceleration(t, x, v);
            let b = acceleration(t + dt, x + dt * v, v + dt * a);
            if i >= (cycles - 1) * steps {
                furthest = furthest.max((x - floor(t).0).abs());
                hardest = hardest.max(a.abs());
            }
            (x, v) = (x + dt * (v + dt * a / 2.0), v + dt * (a + b) / 2.0);
        }
        assert!((furthest / slide - 1.0).abs() < 2e-3, "{line}: {furthest}");
        assert!((hardest / felt - 1.0).abs() < 2e-3, "{line}: {hardest}");
    }
}

/// The energies are those of the exact motion, and no other slip load dissipates more.
#[test]
fn the_damper_eats_most_at_the_best_slip_load() {
    let page = shown("damper");
    let best = numbers(page.lines().next().unwrap());
    let (slip_load, most) = (best[0] * 1e3, best[1]);
    let energy = |load: f64| {
        let floor = Oscillator::new(20e3, 8e6, load).unwrap();
        4.0 * load * exact(&floor, 30e3, 4.0 * TAU).0
    };
    assert!((energy(slip_load) / most - 1.0).abs() < 1e-3);
    for share in [0.3, 0.6, 0.9, 0.98, 1.02, 1.1, 1.2] {
        assert!(energy(share * slip_load) < most, "{share}");
    }
    for line in page.lines().skip(2) {
        let found = numbers(line);
        assert!((energy(found[0] * 1e3) / found[2] - 1.0).abs() < 2e-3, "{line}");
    }
}

/// Compared with differences of the exact motion, which does not use dual numbers.
#[cfg(feature = "dual")]
#[test]
fn the_sensitivities_are_differences() {
    let stroke = |p: [f64; 5]| exact(&Oscillator::new(p[0], p[1], p[2]).unwrap(), p[3], p[4]).0;
    let at = [120.0, 90e3, 400.0, 900.0, TAU * 3.4];
    let page = shown("sensitivities");
    for (i, line) in page.lines().skip(2).take(5).enumerate() {
        let (mut up, mut down) = (at, at);
        up[i] *= 1.0 + 1e-5;
        down[i] *= 1.0 - 1e-5;
        let elasticity = (stroke(up) - stroke(down)) / stroke(at) / 2e-5;
        assert!((elasticity - numbers(line)[1]).abs() < 1e-3, "{line}: {elasticity}");
    }
}

/// The trough moves as small steps of time say.
#[cfg(feature = "serde")]
#[test]
fn the_trough_of_the_file_moves_as_far_as_it_is_said() {
    let (mass, stiffness, friction, damping, speed) = (240.0, 180e3, 150.0, 300.0, TAU * 10.0);
    let force = 0.35 * speed * speed;
    let (mut x, mut v, mut greatest) = (0.0, 0.0, 0.0f64);
    let (step, turns) = (TAU / speed / 20_000.0, 400);
    for i in 0..20_000 * turns {
        let drive = force * (speed * step * f64::from(i)).sin();
        let next: f64 = v + step * (drive - stiffness * x - damping * v - friction * f64::signum(v)) / mass;
        v = next;
        x += step * v;
        if i > 20_000 * (turns - 2) {
            greatest = greatest.max(x);
        }
    }
    let said = numbers(&shown("machine"))[0];
    assert!((1e3 * greatest - said).abs() < 2e-3, "{greatest} {said}");
}
