//! Random systems whose laws are curves, of the generators that the fuzz targets share.

#[path = "../../../tests/invariants/blows.rs"]
mod blows;
#[path = "../../../tests/invariants/curves.rs"]
mod invariants;

use crate::drawn::cases;
use arbitrary::{Arbitrary, Unstructured};
use core::cell::Cell;
use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use stickslip::generators::{Curve, Curved};

#[test]
fn every_curve_is_obeyed_within_its_table_and_digits() {
    let (events, forces) = (Cell::new(0), Cell::new(0));
    let (stribeck, formulas) = (Cell::new(0), Cell::new(0));
    let bytes = proptest::collection::vec(any::<u8>(), 300..900);
    TestRunner::new(cases(16))
        .run(&bytes, |bytes| {
            let curved = Curved::arbitrary(&mut Unstructured::new(&bytes)).unwrap();
            let seen = invariants::motion(&curved, 25);
            events.set(events.get() + seen.events);
            forces.set(forces.get() + seen.forces);
            for (_, curve) in &curved.curves {
                let count = if matches!(curve, Curve::Stribeck { .. }) { &stribeck } else { &formulas };
                count.set(count.get() + 1);
            }
            Ok(())
        })
        .unwrap();
    assert!(events.get() > 60 && forces.get() > 120, "{} {}", events.get(), forces.get());
    assert!(stribeck.get() > 4 && formulas.get() > 4, "{} {}", stribeck.get(), formulas.get());
}
