//! The matching problem at 256, 1024 and 4096 bits.

use super::points::{Worst, special, tenth_power};
use nalgebra::RealField;
use stickslip::cycle::matching::newton;
use stickslip::float::Mp;
use stickslip::{Border, Field, Float, Ratios, Real};

/// Ω in thousandths: both sides of Ω = 1, (1/3, 1/2), (1/5, 1/4) and between.
const ORDINARY: [i32; 19] =
    [50, 150, 210, 220, 240, 250, 280, 300, 350, 400, 450, 500, 550, 700, 940, 1100, 1500, 3000, 20000];

/// α over the border, in ten thousandths.
const OVER: [i32; 3] = [10_001, 15_000, 80_000];

fn all<F: Float + RealField>(name: &str, iterations: u32) -> Worst {
    let beside = special::<F>(&[3, 10, 30]);
    let points = ORDINARY.iter().map(|n| <F as Field>::ratio(*n, 1000));
    let mut worst = Worst::default();
    for omega in points.chain(beside) {
        let border = Border::new(omega).unwrap().min_force_ratio;
        for over in OVER {
            worst.add(omega, border * <F as Field>::ratio(over, 10_000));
        }
        worst.add_border(omega);
    }
    worst.check(name, 4.0, iterations);
    worst
}

/// Includes points on the border, allowing for the bits lost there.
#[test]
fn at_256_bits() {
    let mut border = on_the_border_and_just_above();
    border.check("256 bits, border", 4.0, 100);
    border.lost_bits = 0;
    all::<Mp<4>>("256 bits", 10).merged(&border).is_on_the_page("256 bits");
}

#[test]
fn at_1024_bits() {
    all::<Mp<16>>("1024 bits", 12).is_on_the_page("1024 bits");
}

/// A quarter of the processor time of all unit tests; 256 and 1024 bits run the same text each time.
#[ignore = "run by `.ci/slow wide`"]
#[test]
fn at_4096_bits() {
    all::<Mp<64>>("4096 bits", 14).is_on_the_page("4096 bits");
}

/// Where the two cycles of eq. 42 nearly coincide, or two velocities do, a start at f64 leads to the wrong
/// one.
fn on_the_border_and_just_above() -> Worst {
    type Wide = Mp<4>;
    let one = <Wide as Field>::int(1);
    let mut worst = Worst::default();
    let points = ORDINARY.iter().map(|n| <Wide as Field>::ratio(*n, 1000));
    for omega in points.chain(special::<Wide>(&[3, 6, 8, 10, 12, 15, 18])) {
        let border = Border::new(omega).unwrap().min_force_ratio;
        for above in [<Wide as Field>::int(0), tenth_power(20), tenth_power(12), tenth_power(6)] {
            worst.add(omega, border * (one + above));
        }
    }
    worst
}

/// On the border near Ω = 1 the cycle is 10³⁰ times smaller than A: the solution reports the number of lost
/// digits.
#[test]
fn on_the_border_beside_resonance_twice_the_zeros_are_lost() {
    type Wide = Mp<8>;
    for k in [3, 10, 20, 30] {
        for sign in [1, -1] {
            let omega = <Wide as Field>::int(1) + <Wide as Field>::int(sign) * tenth_power::<Wide>(k);
            let alpha = Border::new(omega).unwrap().min_force_ratio;
            let mut worst = Worst::default();
            worst.add(omega, alpha);
            worst.check(&format!("border at 1 ± 1e-{k}"), 4.0, 140);
            let lost = newton::solve(Ratios::new(omega, alpha).unwrap()).unwrap().lost_bits;
            let zeros = f64::from(k) * 10f64.log2();
            assert!((f64::from(lost) - 2.0 * zeros).abs() < 12.0, "{lost} bits lost at 1e-{k}: {zeros}");
        }
    }
}

#[test]
fn the_border_at_resonance_itself_is_four_over_pi() {
    let found = newton::solve_border(<Mp<4> as Field>::int(1) + tenth_power::<Mp<4>>(60)).unwrap();
    let four_over_pi = <Mp<4> as Field>::int(4) / <Mp<4> as Real>::pi();
    let off = Float::to_f64((found.force_ratio - four_over_pi) / tenth_power::<Mp<4>>(60));
    // The border has the slope 2/π there.
    assert!((off - std::f64::consts::FRAC_2_PI).abs() < 1e-9 && found.iterations < 40, "{off}");
}
