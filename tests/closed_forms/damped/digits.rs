//! Digits with damping, against 512 bits: beside the pole at Ω = 1 and ζ = 0, beside the border, far above
//! Ω = 1, and for a moving load.

use super::{Random, ratios};
use stickslip::float::Mp;
use stickslip::{Border, Cycle, Field, Float, Response};

type Wide = Mp<8>;

/// The error in units in the last place of a number as large as `size`.
fn ulps(found: f64, due: Wide, size: Wide) -> f64 {
    let size = size.to_f64().abs();
    ((Wide::from(found) - due) / Wide::from(size.next_up() - size)).abs().to_f64()
}

fn wide(omega: f64, zeta: f64, alpha: f64) -> Cycle<Wide> {
    Cycle::new(ratios(Wide::from(omega), Wide::from(zeta), Wide::from(alpha))).unwrap()
}

/// The least float that is not below the border.
fn border_from_above(omega: f64, zeta: f64) -> f64 {
    let border = Border::of(&ratios(Wide::from(omega), Wide::from(zeta), Wide::from(1))).min_force_ratio;
    let nearest = border.to_f64();
    if Wide::from(nearest) < border { nearest.next_up() } else { nearest }
}

/// With ζ → 0 the displacement is that without a damper, 24.0248575, however close Ω is to 1.
#[test]
fn a_trace_of_damping_beside_resonance_changes_nothing() {
    let (omega, alpha): (f64, f64) = (0.999_999_999_508_827_7, 1.273_239_544_422_473);
    let undamped = Cycle::new(stickslip::Ratios::new(omega, alpha).unwrap()).unwrap().max_displacement;
    assert!((undamped - 24.024_857_5).abs() < 1e-7);
    // G = 2ζ/(π (Ω − 1)²) is 3e-12 for the first.
    for (zeta, most) in [(1e-30, 1e-12), (1e-60, 1e-15)] {
        let found = Cycle::new(ratios(omega, zeta, alpha)).unwrap().max_displacement;
        assert!((found / undamped - 1.0).abs() < most, "{zeta:e}: {found} {undamped}");
    }
}

/// A float of α above the border may be worth a hundred times the displacement; every digit is right all the
/// same, and no α above the true border is called sticking.
#[test]
fn every_digit_is_right_beside_the_pole() {
    let mut random = Random(20);
    for i in 0..600 {
        let off = random.between(-0.3, 0.3) * 2f64.powi(-((random.bits() % 52) as i32));
        let (omega, zeta) = (1.0 + off, 10f64.powf(random.between(-30.0, -1.0)));
        let alpha = f64::from_bits(border_from_above(omega, zeta).to_bits() + random.bits() % 8);
        let alpha = if i % 3 == 0 { alpha * random.between(1.0, 4.0) } else { alpha };
        let at = format!("Ω = {omega:?}, ζ = {zeta:?}, α = {alpha:?}");
        let response = Response::new(ratios(omega, zeta, alpha));
        let cycle = response.cycle.unwrap_or_else(|| panic!("{at}: {:?}", response.regime));
        let due = wide(omega, zeta, alpha);
        let least = Border::of(&due.ratios).min_force_ratio;
        for (name, found, due, most) in [
            ("Δ₀", cycle.max_displacement, due.max_displacement, 1.0),
            ("A₁", cycle.loop_size_stiffness(), due.loop_size_stiffness(), 1.0),
            ("A₂", cycle.loop_size_inertia(), due.loop_size_inertia(), 1.0),
            ("α_min", response.border.min_force_ratio, least, 1.0),
        ] {
            let error = ulps(found, due, due);
            assert!(error <= most, "{name} at {at}: {found} for {due}, {error} ulp");
        }
        let phase = ulps(cycle.displacement_phase, due.displacement_phase, Wide::int(4));
        assert!(phase <= 2.0, "t₂ at {at}: {phase} ulp");
    }
}

/// Far above Ω = 1 the deviation is a small difference of terms that the damper makes large.
#[test]
fn the_deviation_keeps_its_digits_far_above_resonance() {
    for (omega, zeta) in [(965.29, 15.755), (137.97, 4.1), (30.0, 1.0), (50.0, 0.3), (200.0, 39.0)] {
        for above in [1.0, 1.5, 40.0] {
            let alpha = border_from_above(omega, zeta) * above;
            let (cycle, due) = (Cycle::new(ratios(omega, zeta, alpha)).unwrap(), wide(omega, zeta, alpha));
            let size = due.deviation().abs().or_larger(due.max_velocity);
            let error = ulps(cycle.deviation(), due.deviation(), size);
            assert!(error <= 16.0, "Ω = {omega}, ζ = {zeta}, α = {alpha}: {error} ulp");
        }
    }
}

/// Under a slow and strong force both force and spring are many times the acceleration.
#[test]
fn the_acceleration_keeps_its_digits_under_a_slow_drive() {
    for (omega, alpha) in [(0.005_073_172_847_619_801, 262_552.545_165_782_5), (0.017, 3e4), (0.31, 1e7)] {
        fn acceleration<F: stickslip::Float>(omega: F, alpha: F) -> F {
            let response = Response::new(stickslip::Ratios::new(omega, alpha).unwrap());
            stickslip::Output::MaxAcceleration.of(&response).unwrap()
        }
        let due = acceleration(Wide::from(omega), Wide::from(alpha));
        let error = ulps(acceleration(omega, alpha), due, due);
        assert!(error <= 8.0, "Ω = {omega}, α = {alpha}: {error} ulp");
    }
}
