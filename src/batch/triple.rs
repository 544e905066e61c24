//! {Δ₀, α_min, A₁} of a block.

use super::block::{AtPoint, Block, each, select};
use super::frequency::phase_function_alone;
use super::kernel::{Kernel, Work};
use crate::nonsticking::{Border, Reversal};
use crate::phase_function::{PhaseFunction, one_minus_square};
use crate::ratios::Ratios;

/// The bounds within which nothing over- or underflows and `β` needs no more than q = 2.
const LEAST_OMEGA: f64 = 0.5;
const GREATEST_OMEGA: f64 = 1_048_576.0;
/// The same for Δ₀; at Ω = 1 it is infinite.
pub(crate) const GREATEST_DISPLACEMENT: f64 = 1e60;

/// Whether Ω is within the range of the loops.
#[expect(clippy::manual_range_contains, reason = "one condition, where `contains` is two branches")]
#[inline(always)]
pub(crate) fn has_loops(omega: f64) -> bool {
    (omega >= LEAST_OMEGA) & (omega <= GREATEST_OMEGA)
}

/// Where α exceeds |K| by less than this factor, α² − K² amplifies the rounding of K.
pub(crate) const CLEAR_OF_PHASE_FUNCTION: f64 = 1.03125;
/// Where α is closer to the border than this, relatively, the careful path decides on which side it lies.
pub(crate) const CLEAR_OF_BORDER: f64 = 1.0 / (1u64 << 46) as f64;

/// {Δ₀, α_min, A₁}.
pub(crate) struct TripleKernel;

impl Kernel<3> for TripleKernel {
    const MARK: usize = 1;

    #[inline(always)]
    fn pass(&self, omega: &Block, alpha: &Block, _: &mut Work, out: [&mut Block; 3]) {
        each(&Point, [omega, alpha], out);
    }

    fn careful(&self, omega: f64, alpha: f64) -> [f64; 3] {
        let Ok(ratios) = Ratios::new(omega, alpha) else { return [f64::NAN; 3] };
        let p = PhaseFunction::of_valid(ratios.omega());
        let border = Border::at(&p).min_force_ratio();
        if alpha < border || omega == 1.0 {
            return [f64::NAN, border, f64::NAN];
        }
        let reversal = Reversal::new(&p, alpha);
        [reversal.max_displacement(), border, reversal.loop_size_stiffness()]
    }
}

/// `[Δ₀, α_min, A₁]`; NaN for α_min says that the point is to be redone.
struct Point;

impl AtPoint<2, 3> for Point {
    #[inline(always)]
    fn at(&self, [omega, alpha]: [f64; 2]) -> [f64; 3] {
        let (k, inverse) = phase_function_alone(omega);
        let q = one_minus_square(omega);
        let force = q * inverse * inverse;
        let border = force.mul_add(force, k * k).sqrt();
        let slides = alpha >= border;
        let displacement = ((alpha - k) * (alpha + k)).sqrt() / q.abs();
        let size = 8.0 * displacement / (alpha * alpha);
        // Comparisons written so that NaN is redone, too; at Ω = 1 the displacement is infinite.
        let clear = (displacement <= GREATEST_DISPLACEMENT) & (alpha > CLEAR_OF_PHASE_FUNCTION * k.abs());
        let ordinary = has_loops(omega)
            & (alpha > 0.0)
            & ((alpha - border).abs() > CLEAR_OF_BORDER * border)
            & (!slides | clear);
        let nan = f64::NAN;
        [select(slides, displacement, nan), select(ordinary, border, nan), select(slides, size, nan)]
    }
}
