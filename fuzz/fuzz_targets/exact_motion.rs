//! Ω, α and a state: the motion from there.
#![no_main]

#[path = "../../tests/invariants/motion.rs"]
mod motion;

use stickslip::generators::{Point, Start};

libfuzzer_sys::fuzz_target!(|start: Start| {
    let Start { point: Point { omega, alpha }, theta, x, v } = start;
    motion::trajectory(omega, alpha, theta, x, v);
});
