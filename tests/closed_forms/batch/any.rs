//! Batches of arbitrary points.

use arbitrary::{Arbitrary, Unstructured};
use proptest::prelude::*;
use stickslip::generators::Point;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    /// For any number of deliberately difficult points, wherever their slice begins.
    #[test]
    fn batches_keep_their_promises(
        bytes in prop::collection::vec(any::<u8>(), 0..600),
        offset in 0usize..16,
        length in 0usize..400,
    ) {
        let mut from = Unstructured::new(&bytes);
        let mut points = Vec::new();
        while !from.is_empty() {
            let Ok(Point { omega, alpha }) = Point::arbitrary(&mut from) else { break };
            points.push((omega, alpha));
        }
        crate::batches::batches(&points, offset, length);
    }
}
