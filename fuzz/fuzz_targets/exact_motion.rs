//! Ω, α, ζ and a state: the motion from there.
#![no_main]

use stickslip::generators::{DampingRatio, Start};

libfuzzer_sys::fuzz_target!(|input: (Start, DampingRatio)| stickslip_fuzz::exact_motion(input));
