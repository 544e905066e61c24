//! What the questions asked backwards are asked with.
#![no_main]

#[path = "../../tests/invariants/motion.rs"]
mod motion;

use stickslip::generators::Question;

libfuzzer_sys::fuzz_target!(|q: Question| {
    motion::questions(q.point.omega, q.target, q.point.alpha, q.low, q.high);
});
