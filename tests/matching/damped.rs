//! The matching equations with damping, solved without the closed forms and compared with them.

use nalgebra::RealField;
use stickslip::cycle::matching::newton::{self, MatchingError};
use stickslip::float::{Field, Real};
use stickslip::{Border, Cycle, Float, Ratios};

/// Damping ratios below, at and above ζ = 1, in thousandths.
const DAMPING: [i32; 8] = [1, 10, 50, 200, 700, 1000, 1200, 3000];

/// The worst error of Δ₀, ω_d t₂, V₀, ω_d t₁ and Δ₁ in units in the last place, after allowing for the bits
/// that the solution reports as lost; and the number of cycles.
fn worst<F: Float + RealField>(omegas: &[i32], over: &[i32]) -> (f64, u32) {
    let (mut worst, mut cycles) = (0.0f64, 0);
    for &zeta in &DAMPING {
        let zeta = <F as Field>::ratio(zeta, 1000);
        for &omega in omegas {
            let omega = <F as Field>::ratio(omega, 1000);
            let least = Border::of(&Ratios::of_machine(omega, zeta).unwrap()).min_force_ratio;
            for &over in over {
                let alpha = least * <F as Field>::ratio(over, 1000);
                let cycle =
                    Cycle::new(Ratios::new(omega, alpha).unwrap().with_damping_ratio(zeta).unwrap()).unwrap();
                let found = match newton::solve(cycle.ratios) {
                    Ok(found) => found,
                    Err(error) => panic!("({omega}, {zeta}, {alpha}): {error}"),
                };
                let u = &found.unknowns;
                let turn = <F as Real>::pi() * <F as Field>::int(2);
                // The difference of two phases is the angle between them.
                let apart = |a: F, b: F| {
                    let d = (a - b) / turn;
                    (d - Float::round(d)) * turn
                };
                let speed = cycle.max_velocity * omega;
                // The phase of a flat maximum has an error that corresponds to that of the velocity.
                let errors = [
                    (u.max_displacement - cycle.max_displacement) / cycle.max_displacement,
                    apart(u.displacement_phase, cycle.displacement_phase),
                    (u.max_velocity - speed) / speed,
                    apart(u.velocity_phase, cycle.velocity_phase),
                    (u.deviation - cycle.deviation()) / (cycle.max_displacement + <F as Field>::int(1)),
                ];
                let unit = <F as Float>::epsilon() * Float::exp2i(found.lost_bits.min(60) as i32);
                for (i, error) in errors.into_iter().enumerate() {
                    let error = Float::to_f64(error / unit).abs();
                    assert!(
                        error < 8.0,
                        "{i} at ({omega}, {zeta}, {alpha}): {error} beyond {} bits",
                        found.lost_bits
                    );
                    worst = worst.max(error);
                }
                assert!(found.lost_bits < 40, "({omega}, {zeta}, {alpha}): {}", found.lost_bits);
                assert!(
                    found
                        .residuals
                        .iter()
                        .all(|r| Float::to_f64(*r) < 64.0 * (1.0 + 1.0 / Float::to_f64(omega)))
                );
                cycles += 1;
            }
        }
    }
    (worst, cycles)
}

#[test]
fn newtons_method_leads_to_the_closed_forms() {
    // Close to 1/3, 1/2 and 1, at them, below and above.
    let (worst, cycles) = worst::<f64>(
        &[150, 210, 250, 300, 333, 340, 420, 500, 700, 950, 999, 1000, 1001, 1300, 2500, 9000],
        &[1010, 1500, 8000],
    );
    assert!(worst > 0.0 && cycles == 8 * 16 * 3, "{worst} {cycles}");
}

#[cfg(feature = "mp")]
#[test]
fn and_so_at_256_bits() {
    let (worst, cycles) = worst::<stickslip::float::Mp<4>>(&[210, 340, 500, 1000, 2500], &[1001, 3000]);
    assert!(worst > 0.0 && cycles == 8 * 5 * 2, "{worst} {cycles}");
}

#[test]
fn without_a_cycle_the_path_ends() {
    for (omega, zeta) in [(0.7, 0.05), (1.0, 0.3), (2.0, 1.0)] {
        let ratios = |alpha: f64| Ratios::new(omega, alpha).unwrap().with_damping_ratio(zeta).unwrap();
        // The force is so small that the motion without friction would not reach a tenth of B.
        let found = newton::solve(ratios(0.05));
        assert!(
            matches!(found, Err(MatchingError::NoCycle { .. } | MatchingError::NotACycle { .. })),
            "({omega}, {zeta}): {found:?}"
        );
    }
}
