//! Any doubles as Ω, α and a state: the motion from there and what it tends to.
#![no_main]

#[path = "../../tests/invariants/motion.rs"]
mod motion;

libfuzzer_sys::fuzz_target!(|input: [f64; 5]| {
    let [omega, alpha, theta, x, v] = input;
    motion::trajectory(omega, alpha, theta, x, v);
    motion::long_run(omega, alpha, theta, x, v);
});
