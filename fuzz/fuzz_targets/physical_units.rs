//! Any doubles as mass, stiffness, friction bound, amplitude and frequency.
#![no_main]

#[path = "../../tests/invariants/mod.rs"]
mod invariants;

libfuzzer_sys::fuzz_target!(|input: ([f64; 5], bool)| {
    let ([mass, stiffness, friction_bound, amplitude, frequency], base) = input;
    invariants::physical_units(mass, stiffness, friction_bound, amplitude, frequency, base);
});
