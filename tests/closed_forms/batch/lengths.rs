//! Slices whose lengths differ.

use stickslip::batch::Batch;
use stickslip::{Error, Output, Ratios};

#[test]
fn slices_of_different_lengths() {
    let [mut ten, mut nine, mut regime] = [vec![0.0; 10], vec![0.0; 9], vec![0.0; 9]];
    let (omega, alpha) = ([1.5; 10], [3.0; 10]);
    let wanted = Batch::new().with(Output::Deviation, &mut ten).with(Output::MinForceRatio, &mut nine);
    let error = wanted.run(&omega, &alpha).unwrap_err();
    assert_eq!(error.to_string(), "min_force_ratio has 9 elements, but must have 10, as the others");
    let error = Batch::new().run(&omega, &alpha[1..]).unwrap_err();
    assert_eq!(error.to_string(), "alpha has 9 elements, but must have 10, as the others");
    let wanted = Batch::new().with(Output::Deviation, &mut regime);
    let error = wanted.run_each(10, |i| Ratios::new(omega[i], alpha[i]).ok()).unwrap_err();
    assert_eq!(error.to_string(), "deviation has 9 elements, but must have 10, as the others");
    let wanted = Batch::new().with(Output::Margin, &mut regime);
    let short = Error::LengthMismatch { name: "margin", found: 9, expected: 10 };
    assert_eq!(wanted.run(&omega, &alpha).unwrap_err(), short);
    let mut regime = [None; 9];
    let error = Batch::new().with_regime(&mut regime).run(&omega, &alpha).unwrap_err();
    assert!(error.to_string().starts_with("regime has 9"), "{error}");
}
