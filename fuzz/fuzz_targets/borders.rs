//! Ω: the quantities that depend on it alone, at f64 compared with 512 bits.
#![no_main]

use stickslip::generators::Point;

libfuzzer_sys::fuzz_target!(|point: Point| stickslip_fuzz::borders(point));
