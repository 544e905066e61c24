//! The matching problem solved by Newton's method, at f64 and at high precision, and compared with the closed
//! forms.
//!
//! The solver uses eq. 21–25 and the motion without friction, and none of the closed forms.

mod damped;
mod equations;
mod failures;
mod points;
#[cfg(feature = "mp")]
mod precision;

use points::Worst;
use stickslip::cycle::matching::newton;
use stickslip::{Border, Cycle, Ratios};

#[test]
fn at_f64_over_a_grid() {
    let mut worst = Worst::default();
    for i in 1..400 {
        let omega = 0.12 + f64::from(i) * 0.006_17;
        for over in [1.000_1, 1.01, 1.5, 4.0, 50.0] {
            worst.add(omega, Border::new(omega).unwrap().min_force_ratio * over);
        }
        worst.add_border(omega);
    }
    worst.check("f64, grid", 4.0, 6);
    // The same near the poles.
    let mut near_poles = Worst::default();
    for near in points::special::<f64>(&[3, 6, 9, 12]) {
        for over in [1.000_1, 1.5, 6.0] {
            near_poles.add(near, Border::new(near).unwrap().min_force_ratio * over);
        }
        near_poles.add_border(near);
    }
    near_poles.check("f64, beside the poles", 4.0, 30);
    worst.merged(&near_poles).is_on_the_page("f64");
}

#[test]
fn the_lost_bits_are_none_away_from_the_border_and_many_beside_it_at_resonance() {
    let lost = |omega: f64, over: f64| {
        let alpha = Border::new(omega).unwrap().min_force_ratio * over;
        newton::solve(Ratios::new(omega, alpha).unwrap()).unwrap().lost_bits
    };
    // With α well above the border, the distance from Ω = 1 does not matter.
    assert!(lost(1.0 + 1e-12, 2.0) <= 7 && lost(0.7, 2.0) <= 8);
    // Close to the border, each leading zero of 1 − Ω is lost once, in Δ₀ compared with A.
    assert!(lost(1.0 + 1e-3, 1.000_001) > lost(1.0 + 1e-3, 2.0) + 5);
}

#[test]
fn the_fastest_of_several_roots_is_found() {
    // Below Ω = 1/2 eq. 46 has several roots; V₀ is the peak velocity.
    for (omega, alpha) in [(0.4f64, 9.0), (0.35, 40.0), (0.22, 30.0), (0.21, 60.0), (0.15, 100.0)] {
        let c = Cycle::new(Ratios::new(omega, alpha).unwrap()).unwrap();
        let found = newton::solve(c.ratios).unwrap().unknowns;
        let v = found.max_velocity / omega;
        assert!((v - c.max_velocity).abs() < 1e-12 * v, "{omega}");
        for i in 0..2000 {
            let phase = found.displacement_phase - std::f64::consts::PI * f64::from(i) / 2000.0;
            assert!(c.given().rising_velocity(&found, phase) / omega <= v * (1.0 + 1e-12));
        }
    }
}
