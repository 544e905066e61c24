//! Ω, α, ζ and a state: the steady state of the motion from there.
#![no_main]

#[path = "../../tests/invariants/motion.rs"]
mod motion;

use stickslip::generators::{DampingRatio, Point, Start};

libfuzzer_sys::fuzz_target!(|input: (Start, DampingRatio)| {
    let (Start { point: Point { omega, alpha }, theta, x, v }, DampingRatio(zeta)) = input;
    motion::damped_long_run(omega, alpha, zeta, theta, x, v);
});
