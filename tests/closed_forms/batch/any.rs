//! Batches of arbitrary points.

use crate::drawn::cases;
use arbitrary::{Arbitrary, Unstructured};
use proptest::prelude::*;
use stickslip::generators::Point;

/// Deliberately difficult points, wherever their slice begins.
fn keeps_its_promises(bytes: &[u8], offset: usize, length: usize) {
    let mut from = Unstructured::new(bytes);
    let mut points = Vec::new();
    while !from.is_empty() {
        let Ok(Point { omega, alpha }) = Point::arbitrary(&mut from) else { break };
        points.push((omega, alpha));
    }
    crate::batches::batches(&points, offset, length);
}

proptest! {
    #![proptest_config(cases(40))]

    /// For any number of deliberately difficult points, wherever their slice begins.
    #[test]
    fn batches_keep_their_promises(
        bytes in prop::collection::vec(any::<u8>(), 0..600),
        offset in 0usize..16,
        length in 0usize..400,
    ) {
        keeps_its_promises(&bytes, offset, length);
    }
}

/// An input that failed once.
#[test]
fn a_batch_that_broke_one() {
    let bytes = [
        142, 222, 208, 4, 4, 157, 218, 133, 81, 25, 234, 30, 247, 238, 172, 45, 115, 48, 53, 233, 134, 231,
        239, 38, 208, 210, 161, 142, 72, 162, 105, 39, 172, 94, 123, 7, 21, 161, 135, 218, 23, 23, 68, 14,
        142, 57, 138, 93, 175, 143, 164, 112, 245, 125, 238, 91, 208, 48, 168, 14, 104, 246, 20, 160, 12, 34,
        188, 4, 245, 140, 18, 2, 70, 108, 253, 200, 76, 92, 81, 135, 180, 87, 79, 30, 114, 136, 32, 154, 84,
        253, 254, 162, 201, 97, 176, 190, 220, 126, 33, 223, 146, 51, 78, 13, 105, 143, 78, 189, 170, 231,
        107, 34, 6, 11, 20, 210,
    ];
    keeps_its_promises(&bytes, 14, 104);
}
