//! Ω, α, ζ, η and a state: the motion from there and its steady state.
#![no_main]

#[path = "../../tests/invariants/motion.rs"]
mod motion;

use stickslip::generators::{DampingRatio, Point, Start};

libfuzzer_sys::fuzz_target!(|input: (Start, DampingRatio, u32)| {
    let (Start { point: Point { omega, alpha }, theta, x, v }, DampingRatio(zeta), part) = input;
    motion::static_motion(omega, alpha, zeta, motion::static_friction_ratio(part), theta, x, v);
});
