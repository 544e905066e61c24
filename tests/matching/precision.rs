//! The same at 256, 1024 and 4096 bits.

use crate::points::{Worst, special};
use nalgebra::RealField;
use stickslip::float::mp::Mp;
use stickslip::{Border, Float, Real};

/// Both sides of Ω = 1, (1/3, 1/2), (1/5, 1/4) and between, in thousandths.
const ORDINARY: [i32; 16] =
    [150, 210, 220, 240, 280, 300, 350, 400, 450, 550, 700, 940, 1100, 1500, 3000, 20000];

/// α over the border, in ten thousandths.
const OVER: [i32; 3] = [10_001, 15_000, 80_000];

fn all<F: Float + RealField>(name: &str, iterations: u32) {
    let beside = special::<F>(&[3, 10, 30]);
    let points = ORDINARY.iter().map(|n| <F as Real>::ratio(*n, 1000));
    let mut worst = Worst::default();
    for omega in points.chain(beside) {
        let border = Border::new(omega).unwrap().min_force_ratio();
        for over in OVER {
            worst.add(omega, border * <F as Real>::ratio(over, 10_000));
        }
        worst.add_border(omega);
    }
    worst.check(name, 4.0, iterations);
}

#[test]
fn at_256_bits() {
    all::<Mp<4>>("256 bits", 10);
}

#[test]
fn at_1024_bits() {
    all::<Mp<16>>("1024 bits", 12);
}

#[test]
fn at_4096_bits() {
    all::<Mp<64>>("4096 bits", 14);
}
