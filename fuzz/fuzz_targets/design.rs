//! The arguments of the inverse problems.
#![no_main]

use stickslip::generators::{DampingRatio, Question};

libfuzzer_sys::fuzz_target!(|input: (Question, DampingRatio)| stickslip_fuzz::design(input));
