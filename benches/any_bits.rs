//! Calls of the f64 interface with random bits, in any number: `cargo bench --features generators --bench
//! any_bits -- 1e9`.
//!
//! There must be no panic, no NaN or infinity in place of a value, and an error exactly where the input is
//! outside the domain. Half of the inputs have arbitrary bits, a quarter has arbitrary bits with exponents in
//! the domain, and a quarter comes from `stickslip::generators`. The run uses all threads, and the inputs
//! depend only on the number of threads. It prints the number of calls by kind.

#![allow(clippy::print_stdout, reason = "a bench prints what it counted")]

use arbitrary::{Arbitrary, Unstructured};
use std::hint::black_box;
use std::time::Instant;
use stickslip::generators::{Machine, Point};
use stickslip::{
    Border, Cycle, Drive, Error, Oscillator, PhaseFunction, Ratios, Regime, Response, Scales, design,
};

#[path = "../tests/random/mod.rs"]
mod random;
use random::Random;

/// The domain of Ω, and of an α that moves the body: 2⁻²⁵⁰ to 2²⁵⁰.
fn in_domain(x: f64) -> bool {
    (2f64.powi(-250)..=2f64.powi(250)).contains(&x)
}

/// The numbers of calls that gave a value and of calls that were refused.
#[derive(Default, Clone, Copy)]
struct Count {
    answered: u64,
    refused: u64,
}

impl Count {
    fn calls(&self) -> u64 {
        self.answered + self.refused
    }

    /// Counts a call that must give a finite value if and only if `due` is true.
    fn value(&mut self, name: &str, input: [f64; 3], found: Result<f64, Error>, due: Option<bool>) {
        match found {
            Ok(x) => {
                assert!(x.is_finite() && due != Some(false), "{name} {input:?} gave {x:e}");
                black_box(x);
                self.answered += 1;
            }
            Err(error) => {
                assert!(due != Some(true), "{name} {input:?} refused: {error}");
                black_box(error);
                self.refused += 1;
            }
        }
    }
}

/// The next three input numbers.
fn numbers(random: &mut Random) -> [f64; 3] {
    let kind = random.bits();
    match kind & 3 {
        0 | 1 => [(); 3].map(|()| f64::from_bits(random.bits())),
        2 => [(); 3].map(|()| {
            let bits = random.bits();
            // The exponent is in 2⁻²⁵⁶ … 2²⁵⁵, and the sign is kept once in eight.
            let exponent = (bits >> 52 & 0x1ff) + 1023 - 256;
            let sign = if bits >> 61 == 0 { bits & 1 << 63 } else { 0 };
            f64::from_bits(sign | exponent << 52 | bits & ((1 << 52) - 1))
        }),
        _ => {
            let mut bytes = [0; 48];
            for chunk in bytes.chunks_mut(8) {
                chunk.copy_from_slice(&random.bits().to_le_bytes());
            }
            let mut u = Unstructured::new(&bytes);
            let Point { omega, alpha } = Point::arbitrary(&mut u).expect("bytes enough");
            [omega, alpha, f64::arbitrary(&mut u).expect("bytes enough")]
        }
    }
}

/// Every answer at (Ω, α), with a third number as a phase and as a target.
fn closed_forms(count: &mut Count, input: [f64; 3]) {
    let [omega, alpha, third] = input;
    let (known, moved) = (in_domain(omega), alpha > 0.0 && alpha <= 2f64.powi(250));
    count.value("K", input, PhaseFunction::new(omega).map(|p| p.value()), Some(known));
    let border = Border::new(omega).map(|b| b.min_force_ratio);
    let least = border.as_ref().copied().unwrap_or(f64::NAN);
    count.value("border", input, border, Some(known));
    let ratios = Ratios::new(omega, alpha);
    let slides = known && moved && omega != 1.0 && alpha >= least;
    count.value(
        "regime",
        input,
        Ratios::new(omega, alpha)
            .map(|at| Response::new(at).regime)
            .map(|r| f64::from(u8::from(r == Regime::NonSticking))),
        Some(known && moved),
    );
    count.value("V₀ for", input, design::force_ratio_for_velocity(omega, 0.0, third), None);
    count.value("Δ₀ for", input, design::force_ratio_for_displacement(omega, 0.0, third), None);
    count.value("ratios", input, ratios.clone().map(|r| r.alpha()), Some(known && moved));
    let Ok(ratios) = ratios else { return };
    count.value("cycle", input, Cycle::new(ratios).map(|c| c.max_velocity), Some(slides));
    let answer = Response::new(ratios);
    assert_eq!(answer.cycle.as_ref().is_some(), slides, "{input:?}");
    count.value("α*", input, Ok(answer.best_force_ratio), Some(true));
    let Some(cycle) = answer.cycle.as_ref() else { return };
    for (name, x) in [
        ("Δ₀", cycle.max_displacement),
        ("V₀", cycle.max_velocity),
        ("t₂", cycle.displacement_phase),
        ("t₁", cycle.velocity_phase),
        ("A₁", cycle.loop_size_stiffness()),
        ("A₂", cycle.loop_size_inertia()),
        ("λ", cycle.contraction()),
    ] {
        assert!(x >= 0.0, "{name} {input:?}: {x:e}");
        count.value(name, input, Ok(x), Some(true));
    }
    count.value("Δ₁", input, Ok(cycle.deviation()), Some(true));
    let x = cycle.displacement_at(third);
    assert_eq!(x.is_nan(), !third.is_finite(), "x {input:?}");
    count.answered += 1;
}

/// A machine with arbitrary numbers.
fn machine(count: &mut Count, random: &mut Random) {
    let mut bytes = [0; 64];
    for chunk in bytes.chunks_mut(8) {
        chunk.copy_from_slice(&random.bits().to_le_bytes());
    }
    let m = Machine::arbitrary(&mut Unstructured::new(&bytes)).expect("bytes enough");
    let good = |x: f64| x.is_finite() && x > 0.0;
    let input = [m.mass, m.stiffness, m.friction_bound];
    let body = Oscillator::new(m.mass, m.stiffness, m.friction_bound);
    count.value("body", input, body.clone().map(|b| b.mass()), Some(input.iter().all(|&x| good(x))));
    let excitation = if m.base { stickslip::Excitation::FootMotion } else { stickslip::Excitation::Force };
    let input = [m.amplitude, m.frequency, 0.0];
    let drive = Drive::new(excitation, m.amplitude, m.frequency);
    count.value(
        "drive",
        input,
        drive.clone().map(|d| d.amplitude()),
        Some(good(m.amplitude) && good(m.frequency)),
    );
    let (Ok(body), Ok(drive)) = (body, drive) else { return };
    count.value("scales", input, Scales::new(&body, &drive).map(|s| s.energy_inertia), None);
    count.value("α", input, drive.ratios(&body).map(|r| r.alpha()), None);
    count.value("friction", input, design::max_friction(&body, &drive), None);
}

/// The calls of one thread, until there are `most`.
fn run(seed: u64, most: u64) -> Count {
    let mut random = Random(seed);
    let mut count = Count::default();
    while count.calls() < most {
        let input = numbers(&mut random);
        closed_forms(&mut count, input);
        machine(&mut count, &mut random);
    }
    count
}

fn main() {
    let asked = std::env::args().skip(1).find_map(|text| text.parse::<f64>().ok()).unwrap_or(1e6);
    let threads = std::thread::available_parallelism().map_or(1, |n| n.get() as u64);
    let began = Instant::now();
    let counts: Vec<Count> = std::thread::scope(|scope| {
        let each = asked as u64 / threads + 1;
        let threads: Vec<_> = (0..threads).map(|seed| scope.spawn(move || run(seed, each))).collect();
        threads.into_iter().map(|thread| thread.join().expect("no panic")).collect()
    });
    let sum = |of: fn(&Count) -> u64| counts.iter().map(of).sum::<u64>();
    println!(
        "{} calls, {} answered, {} refused, none wrong, in {:.0} s",
        sum(Count::calls),
        sum(|c| c.answered),
        sum(|c| c.refused),
        began.elapsed().as_secs_f64()
    );
}
