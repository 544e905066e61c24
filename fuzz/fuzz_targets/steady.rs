//! Ω, α and a state: what the motion from there tends to.
#![no_main]

#[path = "../../tests/invariants/motion.rs"]
mod motion;

use stickslip::generators::{Point, Start};

libfuzzer_sys::fuzz_target!(|start: Start| {
    let Start { point: Point { omega, alpha }, theta, x, v } = start;
    motion::long_run(omega, alpha, theta, x, v);
});
