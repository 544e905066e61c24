//! Points, their number and the start of their slice: batches of every level are compared with each other and
//! with single points.
#![no_main]

#[path = "../../tests/invariants/batches.rs"]
mod batches;

use stickslip::generators::Point;

libfuzzer_sys::fuzz_target!(|input: (u8, u16, Vec<Point>)| {
    let (offset, length, points) = input;
    let points: Vec<(f64, f64)> = points.iter().map(|point| (point.omega, point.alpha)).collect();
    batches::batches(&points, usize::from(offset % 16), usize::from(length % 300));
});
