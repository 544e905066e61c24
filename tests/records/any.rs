//! The promises of `invariants` over bodies and records of all kinds.

use crate::drawn::cases;
#[cfg(feature = "batch")]
use crate::invariants::built;
use crate::invariants::followed;
use arbitrary::{Arbitrary, Unstructured};
use proptest::prelude::*;
use stickslip::generators::Shaken;

fn shaken(bytes: &[u8]) -> Shaken {
    Shaken::arbitrary(&mut Unstructured::new(bytes)).unwrap()
}

proptest! {
    #![proptest_config(cases(4000))]

    #[test]
    fn no_stop_is_missed(bytes in proptest::collection::vec(any::<u8>(), 600)) {
        followed(&shaken(&bytes));
    }
}

#[cfg(feature = "batch")]
proptest! {
    #![proptest_config(cases(60))]

    /// Bodies side by side have the bits of each body alone.
    #[test]
    fn a_body_has_the_same_bits_in_any_company(
        bytes in proptest::collection::vec(proptest::collection::vec(any::<u8>(), 600), 1..40)
    ) {
        let Ok((_, record)) = built(&shaken(&bytes[0])) else { return Ok(()) };
        let bodies: Vec<_> =
            bytes.iter().filter_map(|bytes| built(&shaken(bytes)).ok()).map(|(body, _)| body).collect();
        let together = stickslip::motion::record::follow_each(&bodies, &record);
        for (body, together) in bodies.iter().zip(together) {
            // Debug tells 0 from −0 and NaN from NaN.
            prop_assert_eq!(format!("{:?}", body.follow(&record)), format!("{together:?}"));
        }
    }
}
