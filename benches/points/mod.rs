//! Points for the benches: Ω uniform in (0.5, 2.5) except within 0.02 of 1, and α from 1.05 to 4.05 times the
//! border.

#[path = "../../tests/random/generator.rs"]
mod generator;

use generator::Random;
use stickslip::Border;

/// `n` points from a fixed seed.
#[allow(dead_code, reason = "some programs choose the least Ω")]
pub(crate) fn points(n: usize) -> Vec<(f64, f64)> {
    points_from(n, 0.5)
}

/// The same with Ω from `least`: from 0.35 on, 7 % of the points are below 1/2.
#[allow(dead_code, reason = "not every program chooses the least Ω")]
pub(crate) fn points_from(n: usize, least: f64) -> Vec<(f64, f64)> {
    let mut random = Random(7);
    let mut points = Vec::with_capacity(n);
    while points.len() < n {
        let omega = least + (2.5 - least) * random.next();
        if (omega - 1.0).abs() > 0.02
            && let Ok(border) = Border::new(omega)
        {
            points.push((omega, border.min_force_ratio * (1.05 + 3.0 * random.next())));
        }
    }
    points
}
