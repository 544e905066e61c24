//! The exact motion against independent values.

use stickslip::Ratios;
use stickslip::exact::{Kind, State, Trajectory};

fn motion(omega: f64, alpha: f64) -> Trajectory<f64> {
    Trajectory::new(Ratios::new(omega, alpha).unwrap(), State::rest()).unwrap()
}

/// (max x, sticks, velocity zeros) of the hundredth cycle.
fn settled(omega: f64, alpha: f64) -> (f64, u32, u32) {
    let (mut max, mut sticks, mut zeros) = (0.0f64, 0, 0);
    for phase in motion(omega, alpha).skip_while(|p| p.start().phase.cycles() < 500) {
        if phase.start().phase.cycles() >= 501 {
            break;
        }
        match phase.kind() {
            Kind::Stick => sticks += 1,
            Kind::Slide(_) => zeros += 1,
        }
        max = max.max(phase.end().unwrap().x);
    }
    (max, sticks, zeros)
}

#[test]
fn reference_values_where_it_sticks() {
    for (omega, alpha, x, sticks, zeros, digits) in [
        (0.4, 6.0, 6.79382, 2, 4, 5e-6),
        (0.1, 3.0, 2.1600252446, 4, 4, 1e-10),
        (0.5, 2.0, 2.6068584084, 2, 2, 1e-10),
        (0.7, 1.2, 1.4174370977, 2, 2, 1e-10),
        (0.8, 1.1, 0.0565765889, 2, 2, 1e-10),
    ] {
        let (max, s, z) = settled(omega, alpha);
        assert!((max - x).abs() < digits, "({omega}, {alpha}): {max}");
        assert_eq!(s, sticks, "({omega}, {alpha})");
        assert_eq!(z, zeros, "({omega}, {alpha})");
    }
}
