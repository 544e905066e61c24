//! Any doubles as what the questions asked backwards are asked with.
#![no_main]

#[path = "../../tests/invariants/motion.rs"]
mod motion;

libfuzzer_sys::fuzz_target!(|input: [f64; 5]| {
    let [omega, target, alpha, low, high] = input;
    motion::questions(omega, target, alpha, low, high);
});
