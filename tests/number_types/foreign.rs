//! Types of other crates: the result of the conformance check, and the accuracy that they reach.

use super::octuple::Octuple;
use ::f256::f256;
use stickslip::float::Foreign;
use stickslip::float::conformance;
use stickslip::{Border, Cycle, Field, Float, Ratios, Real};
use twofloat::TwoFloat;

/// {Δ₀, V₀, ω_d t₂, ω_d t₁, α_min, A₁} at one point.
fn answers<F: Float>(omega: (i32, i32), alpha: (i32, i32)) -> [F; 6] {
    let ratios = Ratios::new(F::ratio(omega.0, omega.1), F::ratio(alpha.0, alpha.1)).unwrap();
    let cycle = Cycle::new(ratios).unwrap();
    [
        cycle.max_displacement,
        cycle.max_velocity,
        cycle.displacement_phase,
        cycle.velocity_phase,
        Border::new(ratios.omega()).unwrap().min_force_ratio,
        cycle.loop_size_stiffness(),
    ]
}

const POINTS: [((i32, i32), (i32, i32)); 5] =
    [((3, 2), (5, 2)), ((3, 4), (2, 1)), ((7, 16), (9, 1)), ((5, 1), (2, 1)), ((129, 128), (3, 2))];

/// The largest relative difference, as a power of two.
fn largest<F: Float>(of: impl Fn(F) -> Octuple) -> f64 {
    let mut most = 0.0f64;
    for (omega, alpha) in POINTS {
        let (ours, exact) = (answers::<F>(omega, alpha), answers::<Octuple>(omega, alpha));
        for (ours, exact) in ours.into_iter().zip(exact) {
            most = most.max(((of(ours) - exact) / exact).to_f64().abs());
        }
    }
    most
}

#[test]
fn wrapped_doubles_are_doubles() {
    type Double = Foreign<f64, 53, 255>;
    conformance::<Double>().unwrap();
    conformance::<Foreign<f32, 24, 31>>().unwrap();
    for (omega, alpha) in POINTS {
        let (ours, theirs) = (answers::<Double>(omega, alpha), answers::<f64>(omega, alpha));
        for (ours, theirs) in ours.into_iter().zip(theirs) {
            assert!(
                (ours.0 - theirs).abs() <= 2.0 * f64::EPSILON * theirs.abs(),
                "{omega:?}: {ours} {theirs}"
            );
        }
    }
    assert!(largest::<Double>(|x| Octuple::from_f64(x.0)) < 2f64.powi(-50));
}

#[test]
fn octuple_precision_is_reached_to_the_last_digits() {
    conformance::<Octuple>().unwrap();
    // The 39 digits that the documentation of another type states.
    let known = "1.65415227648207641780635849288984578644";
    let [_, velocity, ..] = answers::<Octuple>((3, 2), (5, 2));
    assert!(velocity.to_string().starts_with(known), "{velocity}");
    #[cfg(feature = "mp")]
    for (omega, alpha) in POINTS {
        use stickslip::float::Mp;
        let (ours, wide) = (answers::<Octuple>(omega, alpha), answers::<Mp<5>>(omega, alpha));
        for (ours, wide) in ours.into_iter().zip(wide) {
            let ours: Mp<5> = ours.to_string().parse().unwrap();
            assert!(((ours - wide) / wide).abs() < Mp::exp2i(-228), "{omega:?}: {ours} {wide}");
        }
    }
}

/// A pair of doubles has no fixed number of digits, so that it does not round as the formulae need; it also
/// states 2.2e-308 as the unit of 1. It is refused, and rightly: its answers have the accuracy of a double.
#[test]
fn a_double_double_is_refused_and_has_the_digits_of_a_double() {
    type Double = Foreign<TwoFloat, 106, 255>;
    assert_eq!(conformance::<Double>().unwrap_err().method, "Float::PRECISION");
    let wide = |x: Double| Octuple::from_f64(x.0.hi()) + Octuple::from_f64(x.0.lo());
    let error = largest::<Double>(wide);
    assert!(error < 2f64.powi(-50) && error > 2f64.powi(-60), "{error:e}");
}

/// The fault that the check found in f256 0.11.3, and that `Octuple` avoids. This test fails when the crate
/// fixes it.
#[test]
fn the_fault_in_the_other_crate_is_there() {
    let one = f256::from(1);
    assert_eq!(one.atan2(&one), ::f256::consts::FRAC_PI_2);
    assert_eq!(Octuple::int(1).atan2(Octuple::int(1)) * Octuple::int(4), Octuple::pi());
}
