//! States close to the places where the motion changes its kind.

use super::Point;
use super::numbers::{any_bits, beside, magnitude, ordinary};
use crate::cycle::Cycle;
use crate::machine::ratios::Ratios;
use arbitrary::{Arbitrary, Result, Unstructured};
use std::f64::consts::{FRAC_PI_2, PI};

/// A state (θ, x, v) for a point that need not be valid.
pub(super) fn state(u: &mut Unstructured<'_>, point: Point) -> Result<(f64, f64, f64)> {
    let Point { omega, alpha } = point;
    let kind = u.int_in_range(0..=9)?;
    let theta = phase(u)?;
    let sign = if bool::arbitrary(u)? { 1.0 } else { -1.0 };
    let (x, v) = match kind {
        0 => return Ok((theta, any_bits(u)?, any_bits(u)?)),
        1 => return Ok((theta, magnitude(u)?, magnitude(u)?)),
        2 | 3 => return Ok((theta, ordinary(u, -30.0, 30.0)?, ordinary(u, -30.0, 30.0)?)),
        // At the friction force, and at the edge of the places of rest.
        4 => (alpha * theta.sin() - sign, 0.0),
        5 => (sign * (1.0 - alpha), 0.0),
        // At the friction bound with a tiny speed.
        6 => (alpha * theta.sin() - sign, sign * ordinary(u, -260.0, -20.0)?.exp2()),
        7 | 8 => match Ratios::new(omega, alpha).and_then(Cycle::new) {
            Ok(cycle) => (cycle.displacement_at(theta), cycle.velocity_at(theta)),
            Err(_) => (0.0, 0.0),
        },
        _ => return grazing(u, point, sign),
    };
    Ok((theta, beside(u, x)?, beside(u, v)?))
}

/// A phase of the drive: ordinary, close to a quarter turn, or large.
fn phase(u: &mut Unstructured<'_>) -> Result<f64> {
    match u.int_in_range(0..=4)? {
        0 => any_bits(u),
        1 => {
            let quarters = f64::from(i8::arbitrary(u)?);
            beside(u, quarters * FRAC_PI_2)
        }
        2 => magnitude(u),
        _ => ordinary(u, -9.0, 9.0),
    }
}

/// A state from which the velocity touches zero some natural time later, `v = v′ = 0` with v″ of the
/// direction's sign.
///
/// It is computed backwards by `x = A sin θ − s + a cos φ + b sin φ`, A = α/(1 − Ω²), which does not exist at
/// Ω = 1: NaN.
fn grazing(u: &mut Unstructured<'_>, point: Point, sign: f64) -> Result<(f64, f64, f64)> {
    let Point { omega, alpha } = point;
    // s cos θ > 0
    let touch = ordinary(u, -FRAC_PI_2, FRAC_PI_2)? + if sign > 0.0 { 0.0 } else { PI };
    let before = ordinary(u, 0.0, 3.0)?;
    let amplitude = alpha / ((1.0 - omega) * (1.0 + omega));
    let (a, b) = (-amplitude * omega * omega * touch.sin(), -amplitude * omega * touch.cos());
    let theta = touch - omega * before;
    let (s, c) = before.sin_cos();
    let x = amplitude * theta.sin() - sign + a * c - b * s;
    let v = amplitude * theta.cos() + (a * s + b * c) / omega;
    Ok((theta, beside(u, x)?, beside(u, v)?))
}
