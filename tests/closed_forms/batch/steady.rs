//! Steady states of many points.

use stickslip::Ratios;
use stickslip::batch::Batch;

#[test]
fn the_exact_motion() {
    use stickslip::motion::{LongRun, State};
    let omega = [1.5, 0.4, 0.7, 0.5, 1.0, f64::NAN];
    let alpha = [2.5, 6.0, 1.2, 4.0, 2.0, 2.0];
    let answers = Batch::new().steady(&omega, &alpha).unwrap();
    for (i, answer) in answers.iter().enumerate() {
        let expected = Ratios::new(omega[i], alpha[i]).and_then(|r| LongRun::from_start(r, State::default()));
        match (answer, expected) {
            (Ok(LongRun::Periodic(a)), Ok(LongRun::Periodic(b))) => {
                assert!(
                    (a.max_displacement.value / b.max_displacement.value - 1.0).abs() < 1e-12,
                    "{}",
                    omega[i]
                );
                assert!((a.max_velocity.value / b.max_velocity.value - 1.0).abs() < 1e-12, "{}", omega[i]);
            }
            (a, b) => assert_eq!(a, &b),
        }
    }
}
