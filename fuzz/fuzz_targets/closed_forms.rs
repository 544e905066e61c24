//! Any three doubles as Ω, α and a phase.
#![no_main]

#[path = "../../tests/invariants/mod.rs"]
mod invariants;

libfuzzer_sys::fuzz_target!(|input: (f64, f64, f64)| {
    let (omega, alpha, phase) = input;
    invariants::closed_forms(omega, alpha, phase);
});
