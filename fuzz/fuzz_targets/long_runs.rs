//! Ω over the whole range of the exact motion, α and a state: the motion from there and its steady state.
#![no_main]

use stickslip::generators::Start;

libfuzzer_sys::fuzz_target!(|input: (u32, Start)| stickslip_fuzz::long_runs(input));
