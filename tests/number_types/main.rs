//! User-defined number types: the conformance check distinguishes right types from wrong ones, and types of
//! other crates reach their accuracy.

mod faulty;
mod foreign;
mod octuple;

use faulty::{FAULTS, Faulty};
use stickslip::float::{Broken, conformance};

#[test]
fn the_types_of_the_crate_keep_their_promises() {
    conformance::<f64>().unwrap();
    conformance::<f32>().unwrap();
    conformance::<Faulty<0>>().unwrap();
    #[cfg(feature = "mp")]
    {
        use stickslip::float::Mp;
        conformance::<Mp<1>>().unwrap();
        conformance::<Mp<4>>().unwrap();
        conformance::<Mp<16>>().unwrap();
    }
    #[cfg(feature = "dual")]
    conformance::<stickslip::float::Dual<2>>().unwrap();
}

/// The result of the check for the type with each fault.
fn found() -> Vec<Result<(), Broken>> {
    macro_rules! each {
        ($($n:literal)*) => { vec![$(conformance::<Faulty<$n>>()),*] };
    }
    each! { 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28
    29 30 31 32 33 34 35 36 37 38 39 40 41 42 43 44 45 }
}

/// Each fault is reported under the name of the method that has it.
#[test]
fn a_wrong_type_is_told_by_the_method_that_is_wrong() {
    assert_eq!(found().len(), FAULTS.len());
    for (n, (found, (method, what))) in found().into_iter().zip(FAULTS).enumerate() {
        let broken = found.expect_err(what);
        assert_eq!(broken.method, method, "fault {}, {what}: {broken}", n + 1);
        let text = broken.to_string();
        assert!(text.contains(&broken.argument) && text.contains(broken.promise), "{text}");
    }
}
