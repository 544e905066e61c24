//! Ω, α and a phase.
#![no_main]

#[path = "../../tests/invariants/mod.rs"]
mod invariants;

use stickslip::generators::Point;

libfuzzer_sys::fuzz_target!(|input: (Point, f64)| {
    let (Point { omega, alpha }, phase) = input;
    invariants::closed_forms(omega, alpha, phase);
});
