//! Ω, α, ζ and a phase: the closed forms.
#![no_main]

#[path = "../../tests/invariants/mod.rs"]
mod invariants;

use stickslip::generators::{DampingRatio, Point};

libfuzzer_sys::fuzz_target!(|input: (Point, f64, DampingRatio)| {
    let (Point { omega, alpha }, phase, DampingRatio(zeta)) = input;
    invariants::damped_closed_forms(omega, alpha, zeta, phase);
});
