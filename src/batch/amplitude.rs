//! Δ₀ and what goes with it: for Ω ≥ 1/2 by the very functions that answer a point ([`High`]), below by a K of single digits
//! ([`Amplifier`]); and which points the loops may answer.

use super::block::select;
use crate::float::circular::held;
use crate::float::{Float, pair::Pair};
use crate::nonsticking::{Reversal, is_close_to_one, turning_point_border};
use crate::phase_function::one_minus_moderate_square;

/// The bounds of Ω within which nothing over- or underflows.
const LEAST_OMEGA: f64 = 0.5;
const GREATEST_OMEGA: f64 = 1_048_576.0;
/// The greatest α of [`crate::Ratios`], 2²⁵⁰.
const GREATEST_ALPHA: f64 = f64::from_bits((1023 + 250) << 52);
/// Where α² − K² is a smaller part of α² (α < 1.033 |K|), it amplifies the rounding of K.
const CLEAR_OF_PHASE_FUNCTION: f64 = 1.0 / 16.0;
/// Where α² and the square of the border differ by a smaller part of α², the careful path decides which is larger.
const CLEAR_OF_BORDER: f64 = 1.0 / (1u64 << 46) as f64;

/// Whether Ω is within the range of the loops: not too close to 1.
#[inline(always)]
pub(crate) fn has_loops(omega: f64) -> bool {
    Between::new(LEAST_OMEGA, GREATEST_OMEGA).has(omega) & !is_close_to_one(omega)
}

/// Bounds of a positive number, as of its bits, moved to where the least is the first integer.
#[derive(Clone, Copy)]
struct Between {
    offset: i64,
    greatest: i64,
}

impl Between {
    #[inline(always)]
    const fn new(least: f64, greatest: f64) -> Self {
        let offset = i64::MIN.wrapping_sub_unsigned(least.to_bits());
        Self { offset, greatest: offset.wrapping_add_unsigned(greatest.to_bits()) }
    }

    /// Whether least ≤ x ≤ greatest.
    #[inline(always)]
    const fn has(self, x: f64) -> bool {
        x.to_bits().cast_signed().wrapping_add(self.offset) <= self.greatest
    }
}

/// What Ω and α are compared with.
#[derive(Clone, Copy)]
pub(crate) struct Domain {
    omega: Between,
    alpha: Between,
    nan: f64,
}

impl Domain {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        held(Self {
            omega: Between::new(LEAST_OMEGA, GREATEST_OMEGA),
            alpha: Between::new(f64::MIN_POSITIVE, GREATEST_ALPHA),
            nan: f64::NAN,
        })
    }
}

/// One point with Ω ≥ 1/2.
pub(crate) struct High {
    reversal: Reversal<f64>,
    /// α_min; NaN where the point is to be redone.
    pub(crate) border: f64,
}

impl High {
    #[inline(always)]
    pub(crate) fn at(domain: &Domain, omega: f64, alpha: f64, phase_function: Pair<f64>) -> Self {
        let one_minus_square = one_minus_moderate_square(omega);
        let border = turning_point_border(phase_function, one_minus_square, omega.wide()).value();
        // Where there is no cycle, all that has α in it is NaN.
        let sliding = select(alpha >= border, alpha, domain.nan);
        let reversal = Reversal::by_formula(phase_function, one_minus_square, sliding);
        let is_answered = domain.omega.has(omega)
            & !is_close_to_one(omega)
            & domain.alpha.has(alpha)
            & !reversal.falls_short(omega);
        Self { reversal, border: select(is_answered, border, domain.nan) }
    }

    /// Δ₀; NaN where there is no cycle.
    #[inline(always)]
    pub(crate) fn displacement(&self) -> f64 {
        self.reversal.max_displacement()
    }

    /// What the rounded Δ₀ lacks; NaN where there is no cycle.
    #[inline(always)]
    pub(crate) fn rest(&self) -> f64 {
        self.reversal.max_displacement_pair().lo
    }

    /// A₁; NaN where there is no cycle.
    #[inline(always)]
    pub(crate) fn size(&self) -> f64 {
        self.reversal.loop_size_stiffness()
    }

    /// A₂; NaN where there is no cycle.
    #[inline(always)]
    pub(crate) fn inertia(&self, omega: f64) -> f64 {
        self.reversal.loop_size_inertia(omega)
    }

    /// ω_d t₂; NaN where there is no cycle.
    #[inline(always)]
    pub(crate) fn phase(&self) -> f64 {
        self.reversal.displacement_phase()
    }
}

/// Δ₀ and what goes with it, below Ω = 1/2.
pub(crate) struct Amplitude {
    /// Δ₀; NaN where there is no cycle.
    pub(crate) displacement: f64,
    /// α_min; NaN where the point is to be redone.
    pub(crate) border: f64,
    /// A₁; NaN where there is no cycle.
    pub(crate) size: f64,
    /// `α |sin ω_d t₂| = √(α² − K²)`; NaN where there is no cycle.
    pub(crate) sine: f64,
}

/// `1 − Ω²`, rounded once.
#[inline(always)]
pub(crate) fn one_minus_square(omega: f64) -> f64 {
    (-omega).mul_add(omega, 1.0)
}

/// What the amplitude is compared with.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Amplifier {
    clear_of_border: f64,
    clear_of_phase_function: f64,
    eight: f64,
}

impl Amplifier {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        held(Self {
            clear_of_border: CLEAR_OF_BORDER,
            clear_of_phase_function: CLEAR_OF_PHASE_FUNCTION,
            eight: 8.0,
        })
    }

    /// At K, `distance` = |1 − Ω²|, `force` = (1 − Ω²) S with S the least Δ₀, of which the border consists: `α_min² = force² + K²`; the
    /// border, and whether Ω is one for loops.
    #[inline(always)]
    pub(crate) fn at(
        &self,
        alpha: f64,
        k: f64,
        distance: f64,
        force: f64,
        border: f64,
        in_range: bool,
    ) -> Amplitude {
        let nan = f64::NAN;
        let alpha_square = alpha * alpha;
        let sine_square = (alpha - k) * (alpha + k);
        // α² − α_min²
        let excess = (-force).mul_add(force, sine_square);
        let rounding = self.clear_of_border * alpha_square;
        let (slides, sticks) = (excess > rounding, excess < -rounding);
        let sine = select(slides, sine_square.sqrt(), nan);
        // One quotient for two.
        let shared = 1.0 / (distance * alpha_square);
        let displacement = sine * (alpha_square * shared);
        let size = sine * (self.eight * shared);
        // Comparisons written so that NaN is redone, too.
        let clear = sine_square > self.clear_of_phase_function * alpha_square;
        let ordinary = in_range
            & Between::new(f64::MIN_POSITIVE, GREATEST_ALPHA).has(alpha)
            & ((slides & clear) | sticks);
        Amplitude { displacement, border: select(ordinary, border, nan), size, sine }
    }
}
