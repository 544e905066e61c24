//! Ω, α, ζ, η and a state: the motion from there and its steady state.
#![no_main]

use stickslip::generators::{DampingRatio, Start};

libfuzzer_sys::fuzz_target!(|input: (Start, DampingRatio, u32)| stickslip_fuzz::static_friction(input));
