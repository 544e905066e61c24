//! Ω over the whole range of the exact motion, α and a state: the motion from there and its steady state.
#![no_main]

#[path = "../../tests/invariants/motion.rs"]
mod motion;

use stickslip::generators::{Point, Start};

libfuzzer_sys::fuzz_target!(|input: (u32, Start)| {
    let (part, Start { point: Point { alpha, .. }, theta, x, v }) = input;
    motion::any_frequency(part, alpha, theta, x, v);
});
