//! The promises of `invariants` over inputs of any bits, and over inputs that mostly have an answer.

mod invariants;
#[path = "invariants/motion.rs"]
mod motion;

use proptest::num::f64::ANY;
use proptest::prelude::*;
use stickslip::Border;

/// What fuzzing has found, kept.
#[test]
fn findings() {
    // dα_min/dΩ beyond the largest double, at Ω just above the least that is taken.
    invariants::physical_units(
        8.256_667_5e-317,
        3.473_060_714_266_497_4e-164,
        1000.0,
        3.25,
        12.000_000_000_000_455,
        true,
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn any_three_numbers(omega in ANY, alpha in ANY, phase in ANY) {
        invariants::closed_forms(omega, alpha, phase);
    }

    #[test]
    fn any_magnitude(e in -250.0..250.0, over in -2.0..8.0, phase in -700.0..700.0) {
        let omega = 2f64.powf(e);
        let least = Border::new(omega).unwrap().min_force_ratio();
        invariants::closed_forms(omega, least * 2f64.powf(over), phase);
    }

    #[test]
    fn beside_a_whole_quotient(n in 1u32..60, bits in -60i64..60, over in 0.0..3.0, phase in -7.0..7.0) {
        let omega = f64::from_bits((1.0 / f64::from(n)).to_bits().wrapping_add_signed(bits));
        let least = Border::new(omega).unwrap().min_force_ratio();
        invariants::closed_forms(omega, least * 2f64.powf(over), phase);
        invariants::closed_forms(omega, least.next_down(), phase);
    }

    #[test]
    fn any_machine(numbers in prop::array::uniform5(ANY), base in any::<bool>()) {
        let [m, k, r, p, w] = numbers.map(f64::abs);
        invariants::physical_units(m, k, r, p, w, base);
        invariants::physical_units(numbers[0], k, r, p, w, base);
    }

    #[test]
    fn any_motion(numbers in prop::array::uniform5(ANY)) {
        let [omega, alpha, theta, x, v] = numbers;
        motion::trajectory(omega, alpha, theta, x, v);
        motion::long_run(omega, alpha, theta, x, v);
    }

    #[test]
    fn any_ordinary_motion(e in -6.0..6.0, a in -1.0..8.0, theta in -9.0..9.0, x in -30.0..30.0, v in -30.0..30.0) {
        motion::trajectory(2f64.powf(e), 2f64.powf(a), theta, x, v);
        motion::long_run(2f64.powf(e), 2f64.powf(a), theta, x, v);
    }

    #[test]
    fn any_question(e in -8.0..6.0, a in 0.0..12.0, t in -2.0..12.0, low in -6.0..3.0, width in 0.0..2.0) {
        motion::questions(2f64.powf(e), 2f64.powf(t), 2f64.powf(a), 2f64.powf(low), 2f64.powf(low + width));
    }
}
