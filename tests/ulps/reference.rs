//! The outputs at f64 and at f32, their references at 128 bits and at f64, and the error between them.

use super::{COUNT, OUTPUTS, Unit};
use stickslip::float::Mp;
use stickslip::{Border, Cycle, Field, Float, PhaseFunction, Ratios, Real, Response};

/// A number type whose errors are measured.
pub(crate) trait Narrow: Float {
    /// The number type of the reference.
    type Wide: Float;
    fn widened(self) -> Self::Wide;
    fn nearest(wide: Self::Wide) -> Self;
    /// The number that many steps away.
    fn stepped(self, steps: i64) -> Self;
    /// A random number between two positive ones.
    fn of_bits_between(least: Self, greatest: Self, integer: impl FnOnce(i64, i64) -> i64) -> Self;
    /// The exponent of the binade of |x|.
    fn exponent(x: Self::Wide) -> i32;
}

macro_rules! narrow {
    ($float:ident, $wide:ty, $bits:ident) => {
        impl Narrow for $float {
            type Wide = $wide;

            fn widened(self) -> $wide {
                self.into()
            }
            fn nearest(wide: $wide) -> Self {
                wide.to_f64() as $float
            }
            fn stepped(self, steps: i64) -> Self {
                Self::from_bits((self.to_bits() as i64 + steps) as $bits)
            }
            fn of_bits_between(least: Self, greatest: Self, integer: impl FnOnce(i64, i64) -> i64) -> Self {
                Self::from_bits(integer(least.to_bits() as i64, greatest.to_bits() as i64) as $bits)
            }
            fn exponent(x: $wide) -> i32 {
                (x.abs().to_f64().to_bits() >> 52) as i32 - 1023
            }
        }
    };
}

// The cancellation in the reference is at most 2²⁰ (closer to Ω = 1 the difference is formed to three times
// the digits), so that more than a hundred of its bits are correct.
narrow!(f64, Mp<2>, u64);
// Accurate to a few units in its last place, which are 2⁻²⁹ of those of f32.
narrow!(f32, f64, u32);

/// Every output in the order of [`OUTPUTS`]; `None` where there is no cycle.
pub(crate) fn answers<F: Float>(ratios: Ratios<F>) -> Option<[Option<F>; COUNT]> {
    let response = Response::new(ratios);
    let (cycle, border) = (response.cycle.as_ref()?, response.border);
    Some([
        Some(cycle.max_displacement),
        Some(cycle.displacement_phase),
        Some(cycle.max_velocity),
        Some(cycle.velocity_phase),
        Some(cycle.deviation()),
        Some(border.min_force_ratio),
        Some(border.min_force_ratio_turning_point),
        Some(border.border_phase),
        Some(cycle.loop_size_stiffness()),
        Some(cycle.loop_size_inertia()),
        Some(response.best_force_ratio),
        response.best_loop_size,
        Some(cycle.contraction()),
        Some(PhaseFunction::new(ratios.omega()).ok()?.value()),
    ])
}

/// The least number that is not below the border.
pub(crate) fn border_from_above<F: Narrow>(omega: F) -> Option<F> {
    rounded_up(Border::new(omega.widened()).ok()?.min_force_ratio)
}

/// The least number that is not below another.
pub(crate) fn rounded_up<F: Narrow>(border: F::Wide) -> Option<F> {
    let nearest = F::nearest(border);
    Some(if nearest.widened() < border { nearest.stepped(1) } else { nearest })
}

/// The size of one unit in the last place of a narrow number as large as `x`.
fn ulp<F: Narrow>(x: F::Wide) -> F::Wide {
    // A power of two that was rounded up from below counts for the coarser binade, which costs at most a
    // factor of two on one float.
    F::Wide::exp2i(F::exponent(x).max(-960) + 1 - F::PRECISION as i32)
}

/// The error of each output at (Ω, α) in its unit; `None` where neither precision has a cycle.
pub(crate) fn errors<F: Narrow>(omega: F, alpha: F) -> Option<[f64; COUNT]> {
    errors_at(Ratios::new(omega, alpha).ok()?)
}

/// The ratios at the precision of the reference.
pub(crate) fn widened<F: Narrow>(ratios: &Ratios<F>) -> Option<Ratios<F::Wide>> {
    let wide = Ratios::new(ratios.omega().widened(), ratios.alpha().widened()).ok()?;
    let wide = wide.with_damping_ratio(ratios.damping_ratio().widened()).ok()?;
    wide.with_static_friction_ratio(ratios.static_friction_ratio().widened()).ok()
}

/// The same for a machine that may have a damper and static friction.
pub(crate) fn errors_at<F: Narrow>(ratios: Ratios<F>) -> Option<[f64; COUNT]> {
    let narrow = answers(ratios)?;
    let exact = widened(&ratios)?;
    let wide = answers(exact)?;
    let speed = wide[2]?;
    let mut errors = [0.0; COUNT];
    for (((error, output), narrow), wide) in errors.iter_mut().zip(OUTPUTS).zip(narrow).zip(wide) {
        *error = match (narrow, wide) {
            (Some(narrow), Some(wide)) => difference_in_ulp::<F>(output.unit, narrow.widened(), wide, speed),
            // An output must exist at both precisions or at neither.
            _ if narrow.is_some() == wide.is_some() => 0.0,
            _ => f64::INFINITY,
        };
    }
    // If two maxima are equal except for rounding, either may be found.
    let mut excused = [false; COUNT];
    if is_other_maximum(exact, narrow[3]?, wide[3]?, speed) {
        [excused[3], excused[4]] = [true; 2];
    }
    let is_other_supremum = (narrow[7]?.widened() - wide[7]?).abs() > F::Wide::ratio(1, 100);
    excused[7] = is_other_supremum && errors[5] <= OUTPUTS[5].allowed;
    for (error, _) in errors.iter_mut().zip(excused).filter(|&(_, excused)| excused) {
        *error = 0.0;
    }
    Some(errors)
}

/// The difference of two values of an output in its unit; `speed` is V₀.
pub(crate) fn difference_in_ulp<F: Narrow>(unit: Unit, one: F::Wide, other: F::Wide, speed: F::Wide) -> f64 {
    let mut difference = (one - other).abs();
    let size = match unit {
        Unit::Own => other.abs(),
        Unit::Phase => {
            let around = (F::Wide::pi() * F::Wide::int(2) - difference).abs();
            if around < difference {
                difference = around;
            }
            other.abs().or_larger(F::Wide::int(1))
        }
        Unit::Velocity => other.abs().or_larger(speed),
    };
    let zero = F::Wide::int(0);
    let is_exact_zero = other == zero && difference == zero;
    if is_exact_zero { 0.0 } else { (difference / ulp::<F>(size)).to_f64() }
}

/// Whether `phase` is that of another maximum of the velocity that is equal except for rounding. Below Ω =
/// 1/2 there are points on whose two sides different maxima are the greatest; the same holds for the border's
/// supremum.
fn is_other_maximum<F: Narrow>(exact: Ratios<F::Wide>, phase: F, right: F::Wide, speed: F::Wide) -> bool {
    let is_elsewhere = (phase.widened() - right).abs() > F::Wide::ratio(1, 100);
    is_elsewhere
        && Cycle::new(exact).is_ok_and(|cycle| {
            (cycle.velocity_at(phase.widened()) - speed).abs() <= ulp::<F>(speed) * F::Wide::int(8)
        })
}
