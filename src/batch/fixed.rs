//! Rows of one frequency ratio: what depends on Ω is computed once.

use super::block::{AtPoint, Block, POINTS, each, select};
use super::cycle::{CycleKernel, over_alpha, parts};
use super::kernel::{Kernel, Work};
use super::triple::{
    CLEAR_OF_BORDER, CLEAR_OF_PHASE_FUNCTION, GREATEST_DISPLACEMENT, TripleKernel, has_loops,
};
use crate::error::Error;
use crate::nonsticking::Border;
use crate::phase_function::{PhaseFunction, one_minus_square};

/// A frequency ratio with all that depends on it alone, for many force ratios.
///
/// ```
/// use stickslip::batch::{Batch, FixedOmega, Triple};
/// let row = FixedOmega::new(0.4)?;
/// let (mut displacement, mut border, mut size) = ([0.0; 2], [0.0; 2], [0.0; 2]);
/// let out = Triple {
///     max_displacement: &mut displacement,
///     min_force_ratio: &mut border,
///     loop_size_stiffness: &mut size,
/// };
/// Batch::new().triple_at(&row, &[6.0, 9.0], out)?;
/// assert!(displacement[0].is_nan() && displacement[1] > 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct FixedOmega {
    point: PointAt,
    omega: Block,
    of_omega: [Block; 6],
}

impl FixedOmega {
    /// At the frequency ratio Ω.
    ///
    /// # Errors
    /// Where Ω is not finite, not > 0 or outside the domain of [`crate::Ratios`].
    pub fn new(omega: f64) -> Result<Self, Error> {
        let p = PhaseFunction::new(omega)?;
        let point = PointAt {
            omega,
            phase_function: p.value(),
            distance: one_minus_square(omega).abs(),
            border: Border::at(&p).min_force_ratio(),
        };
        Ok(Self { point, omega: [omega; POINTS], of_omega: parts(omega).map(|x| [x; POINTS]) })
    }

    /// Ω.
    #[must_use]
    pub const fn omega(&self) -> f64 {
        self.point.omega
    }

    /// The exact border α_min at this Ω.
    #[must_use]
    pub const fn min_force_ratio(&self) -> f64 {
        self.point.border
    }

    /// Whether Ω is in the range of the loops over all outputs.
    pub(crate) fn has_loops(&self) -> bool {
        has_loops(self.point.omega)
    }
}

#[derive(Debug, Clone, Copy)]
struct PointAt {
    omega: f64,
    phase_function: f64,
    /// |1 − Ω²|.
    distance: f64,
    border: f64,
}

impl AtPoint<1, 3> for PointAt {
    #[inline(always)]
    fn at(&self, [alpha]: [f64; 1]) -> [f64; 3] {
        let Self { phase_function: k, distance, border, .. } = *self;
        let slides = alpha >= border;
        let displacement = ((alpha - k) * (alpha + k)).sqrt() / distance;
        let size = 8.0 * displacement / (alpha * alpha);
        let clear = (displacement <= GREATEST_DISPLACEMENT) & (alpha > CLEAR_OF_PHASE_FUNCTION * k.abs());
        let ordinary =
            (alpha > 0.0) & ((alpha - border).abs() > CLEAR_OF_BORDER * border) & (!slides | clear);
        let nan = f64::NAN;
        [select(slides, displacement, nan), select(ordinary, border, nan), select(slides, size, nan)]
    }
}

/// {Δ₀, α_min, A₁} of a row.
pub(crate) struct FixedTripleKernel<'a>(pub(crate) &'a FixedOmega);

impl Kernel<3> for FixedTripleKernel<'_> {
    const MARK: usize = 1;

    #[inline(always)]
    fn pass(&self, _: &Block, alpha: &Block, _: &mut Work, out: [&mut Block; 3]) {
        // A copy, which the outputs cannot overlap.
        let point = self.0.point;
        each(&point, [alpha], out);
    }

    fn careful(&self, _: f64, alpha: f64) -> [f64; 3] {
        TripleKernel.careful(self.0.omega(), alpha)
    }

    fn omega(&self, _: f64) -> f64 {
        self.0.omega()
    }
}

/// All outputs of a row.
pub(crate) struct FixedCycleKernel<'a>(pub(crate) &'a FixedOmega);

impl Kernel<9> for FixedCycleKernel<'_> {
    const MARK: usize = 5;

    #[inline(always)]
    fn pass(&self, _: &Block, alpha: &Block, work: &mut Work, out: [&mut Block; 9]) {
        let [.., a, b, c] = work;
        over_alpha(&self.0.omega, alpha, self.0.of_omega.each_ref(), [a, b, c], out);
    }

    fn careful(&self, _: f64, alpha: f64) -> [f64; 9] {
        CycleKernel.careful(self.0.omega(), alpha)
    }

    fn omega(&self, _: f64) -> f64 {
        self.0.omega()
    }
}
