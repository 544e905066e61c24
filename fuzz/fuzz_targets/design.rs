//! The arguments of the inverse problems.
#![no_main]

#[path = "../../tests/invariants/motion.rs"]
mod motion;

use stickslip::generators::{DampingRatio, Question};

libfuzzer_sys::fuzz_target!(|input: (Question, DampingRatio)| {
    let (q, DampingRatio(zeta)) = input;
    motion::damped_questions(q.point.omega, zeta, q.target, q.point.alpha, q.low, q.high);
});
