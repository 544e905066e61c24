//! The outputs at f64, the same at 128 bits, and the distance between them.

use super::{COUNT, OUTPUTS, Unit};
use stickslip::float::mp::Mp;
use stickslip::{Border, Float, PhaseFunction, Ratios, Response};

/// The number of the reference. Its own cancellation is 2²⁰ at most (closer to Ω = 1 the difference is formed to three times the
/// digits), so that more than a hundred bits are right.
pub(crate) type Wide = Mp<2>;

/// Every output at (Ω, α) in the order of [`OUTPUTS`]; `None` where there is no cycle.
pub(crate) fn answers<F: Float>(omega: F, alpha: F) -> Option<[Option<F>; COUNT]> {
    let response = Response::new(Ratios::new(omega, alpha).ok()?);
    let (cycle, border) = (response.cycle()?, response.border());
    Some([
        Some(cycle.max_displacement()),
        Some(cycle.displacement_phase()),
        Some(cycle.max_velocity()),
        Some(cycle.velocity_phase()),
        Some(cycle.deviation()),
        Some(border.min_force_ratio()),
        Some(border.turning_point()),
        Some(border.phase()),
        Some(cycle.loop_size_stiffness()),
        Some(cycle.loop_size_inertia()),
        Some(response.best_force_ratio()),
        response.best_loop_size(),
        Some(cycle.contraction()),
        Some(PhaseFunction::new(omega).ok()?.value()),
    ])
}

/// The least f64 that is not below the border.
pub(crate) fn border_from_above(omega: f64) -> Option<f64> {
    let border = Border::new(Wide::from(omega)).ok()?.min_force_ratio();
    let nearest = border.to_f64();
    Some(if Wide::from(nearest) < border { nearest.next_up() } else { nearest })
}

/// Size of one unit in the last place of an f64 as large as `x`.
fn ulp(x: Wide) -> Wide {
    let x = x.abs().to_f64();
    // A power of two rounded up from below counts for the coarser binade: at most a factor of two, on one float.
    let exponent = (x.to_bits() >> 52) as i32 - 1023;
    Wide::exp2i(exponent.max(-960) - 52)
}

/// The error of each output at (Ω, α), in its unit; `None` where there is no cycle at either precision.
pub(crate) fn errors(omega: f64, alpha: f64) -> Option<[f64; COUNT]> {
    let narrow = answers(omega, alpha)?;
    let wide = answers(Wide::from(omega), Wide::from(alpha))?;
    let speed = wide[2]?;
    let mut errors = [0.0; COUNT];
    for (((error, output), narrow), wide) in errors.iter_mut().zip(OUTPUTS).zip(narrow).zip(wide) {
        let (Some(narrow), Some(wide)) = (narrow, wide) else {
            // What does not exist must not exist at either precision.
            *error = if narrow.is_some() == wide.is_some() { 0.0 } else { f64::INFINITY };
            continue;
        };
        let mut difference = (Wide::from(narrow) - wide).abs();
        let unit = match output.unit {
            Unit::Own => wide.abs(),
            Unit::Phase => {
                let around = (Wide::pi() * Wide::of_int(2) - difference).abs();
                if around < difference {
                    difference = around;
                }
                wide.abs().or_larger(Wide::of_int(1))
            }
            Unit::Velocity => wide.abs().or_larger(speed),
        };
        *error = if wide.is_zero() && difference.is_zero() { 0.0 } else { (difference / ulp(unit)).to_f64() };
    }
    Some(errors)
}
