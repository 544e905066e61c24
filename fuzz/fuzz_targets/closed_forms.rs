//! Ω, α, ζ and a phase: the closed forms.
#![no_main]

use stickslip::generators::{DampingRatio, Point};

libfuzzer_sys::fuzz_target!(|input: (Point, f64, DampingRatio)| stickslip_fuzz::closed_forms(input));
