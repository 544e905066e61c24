//! The promises of `invariants` over bodies and records of all kinds.

use crate::drawn::cases;
#[cfg(any(feature = "batch", feature = "mp"))]
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
        let Ok((_, record)) = built::<f64>(&shaken(&bytes[0])) else { return Ok(()) };
        let bodies: Vec<_> =
            bytes.iter().filter_map(|bytes| built(&shaken(bytes)).ok()).map(|(body, _)| body).collect();
        let together = stickslip::motion::record::follow_each(&bodies, &record);
        for (body, together) in bodies.iter().zip(together) {
            // Debug tells 0 from −0 and NaN from NaN.
            prop_assert_eq!(format!("{:?}", body.follow(&record)), format!("{together:?}"));
        }
    }
}

#[cfg(feature = "mp")]
proptest! {
    #![proptest_config(cases(60))]

    /// An enclosure contains the answers at eight times its precision, and counts the same stops.
    #[test]
    fn what_is_enclosed_is_there(bytes in proptest::collection::vec(any::<u8>(), 600)) {
        use stickslip::float::Mp;
        let shaken = shaken(&bytes);
        let Ok((body, record)) = built::<Mp<17>>(&shaken) else { return Ok(()) };
        let [x, v] = shaken.start.map(Mp::<17>::from);
        let found = match stickslip::enclosed::follow(&body, &record, x, v, 64) {
            Ok(found) => found,
            Err(stickslip::Error::UncertainEvent { .. } | stickslip::Error::TooManyEvents { .. }) => return Ok(()),
            Err(error) => panic!("{error} of {shaken:?}"),
        };
        let exact = body.follow_from(&record, x, v).unwrap();
        let counts = (exact.slides, exact.stops, exact.reversals);
        prop_assert_eq!((found.slides, found.stops, found.reversals), counts);
        for (name, found, exact) in [
            ("max_displacement", &found.max_displacement, exact.max_displacement),
            ("min_displacement", &found.min_displacement, exact.min_displacement),
            ("max_velocity", &found.max_velocity, exact.max_velocity),
            ("max_absolute_acceleration", &found.max_absolute_acceleration, exact.max_absolute_acceleration),
            ("max_transmitted_force", &found.max_transmitted_force, exact.max_transmitted_force),
            ("end_displacement", &found.end_displacement, exact.end_displacement),
            ("end_velocity", &found.end_velocity, exact.end_velocity),
            ("path", &found.path, exact.path),
            ("stick_time", &found.stick_time, exact.stick_time),
            ("friction_work", &found.friction_work, exact.friction_work),
            ("damper_work", &found.damper_work, exact.damper_work),
            ("load_work", &found.load_work, exact.load_work),
        ] {
            prop_assert!(found.contains(&rug::Float::from(exact)), "{} {} and {} of {:?}", name, found, exact, shaken);
        }
        for (found, exact) in [
            (&found.residual_displacement, exact.residual_displacement),
            (&found.max_velocity_time, exact.max_velocity_time),
            (&found.cut_time, exact.cut_time),
        ] {
            match (found, exact) {
                (Some(found), Some(exact)) => prop_assert!(found.contains(&rug::Float::from(exact))),
                (found, exact) => prop_assert_eq!(found.is_some(), exact.is_some()),
            }
        }
    }
}
