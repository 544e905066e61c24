//! Points, their number and the start of their slice: batches of every level are compared with each other and
//! with single points.
#![no_main]

use stickslip::generators::Point;

libfuzzer_sys::fuzz_target!(|input: (u8, u16, Vec<Point>)| stickslip_fuzz::batch(input));
