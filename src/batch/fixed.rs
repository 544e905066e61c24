//! Rows of one frequency ratio: what depends on Ω is computed once.

use super::amplitude::{Amplifier, Domain, High, has_loops};
use super::block::{AtPoint, Block, POINTS, each, each_straight};
use super::careful;
use super::cycle::{all_low_over_alpha, all_over_alpha};
use super::kernel::{Kernel, Work};
use super::low::{LowParts, has_low_loops};
use super::peaks::{Parts, low_over_alpha, over_alpha};
use crate::error::Error;
use crate::float::pair::Pair;
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
    loops: Loops,
}

/// What the loops need of Ω.
#[derive(Debug, Clone)]
enum Loops {
    /// Ω ≥ 1/2: `[K, what the rounded K lacks, 1/Ω, κ, u/(Ω − 1)]`.
    High(Box<[Block; 5]>),
    /// Below: `[K, 1/Ω, sin β, cos β, (1 − Ω²) S]`.
    Low(Box<[Block; 5]>),
    /// Beyond: each point on its own.
    None,
}

impl FixedOmega {
    /// At the frequency ratio Ω.
    ///
    /// # Errors
    /// Where Ω is not finite, not > 0 or outside the domain of [`crate::Ratios`].
    pub fn new(omega: f64) -> Result<Self, Error> {
        let p = PhaseFunction::new(omega)?;
        let border = Border::at(&p);
        let one_minus_square = one_minus_square(omega);
        let point = PointAt {
            omega,
            phase_function: p.wide(),
            distance: one_minus_square.abs(),
            force: one_minus_square * border.least_displacement(),
            border: border.min_force_ratio(),
        };
        let loops = if has_loops(omega) {
            Loops::High(Box::new(Parts::new().at([omega]).map(|x| [x; POINTS])))
        } else if has_low_loops(omega) {
            Loops::Low(Box::new(LowParts::new().at([omega]).map(|x| [x; POINTS])))
        } else {
            Loops::None
        };
        Ok(Self { point, omega: [omega; POINTS], loops })
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

    /// Whether the loops over α reach this Ω.
    pub(crate) const fn has_loops(&self) -> bool {
        !matches!(self.loops, Loops::None)
    }
}

#[derive(Debug, Clone, Copy)]
struct PointAt {
    omega: f64,
    phase_function: Pair<f64>,
    /// |1 − Ω²|.
    distance: f64,
    /// (1 − Ω²) S.
    force: f64,
    border: f64,
}

/// Ω ≥ 1/2.
#[derive(Clone, Copy)]
struct Row(PointAt, Domain);

impl AtPoint<2, 3> for Row {
    #[inline(always)]
    fn at(&self, [_, alpha]: [f64; 2]) -> [f64; 3] {
        let found = High::at(&self.1, self.0.omega, alpha, self.0.phase_function);
        [found.displacement(), found.border, found.size()]
    }
}

/// Ω < 1/2.
#[derive(Clone, Copy)]
struct LowRow(PointAt, Amplifier);

impl AtPoint<2, 3> for LowRow {
    #[inline(always)]
    fn at(&self, [_, alpha]: [f64; 2]) -> [f64; 3] {
        let PointAt { phase_function, distance, force, border, .. } = self.0;
        let found = self.1.at(alpha, phase_function.value(), distance, force, border, distance > 0.0);
        [found.displacement, found.border, found.size]
    }
}

/// {Δ₀, α_min, A₁} of a row.
pub(crate) struct FixedTripleKernel<'a>(pub(crate) &'a FixedOmega);

impl Kernel<3> for FixedTripleKernel<'_> {
    const MARK: usize = 1;

    #[inline(always)]
    fn pass(&self, _: &Block, alpha: &Block, _: &mut Work, out: [&mut Block; 3]) {
        // A copy, which the outputs cannot overlap.
        match self.0.loops {
            Loops::High(_) => each(&Row(self.0.point, Domain::new()), [alpha, alpha], out),
            Loops::Low(_) | Loops::None => each(&LowRow(self.0.point, Amplifier::new()), [alpha, alpha], out),
        }
    }

    const IS_STRAIGHT: bool = true;

    #[inline(always)]
    fn pass_straight(&self, _: &[Block], alpha: &[Block], [a, b, c]: [&mut [Block]; 3]) {
        if let Loops::High(_) = self.0.loops {
            each_straight(&Row(self.0.point, Domain::new()), alpha, alpha, a, b, c);
        } else {
            each_straight(&LowRow(self.0.point, Amplifier::new()), alpha, alpha, a, b, c);
        }
    }

    fn careful(&self, _: f64, alpha: f64) -> [f64; 3] {
        careful::triple(self.0.omega(), alpha)
    }

    fn omega(&self, _: f64) -> f64 {
        self.0.omega()
    }
}

/// {Δ₀, α_min, A₁, V₀, ω_d t₁} of a row.
pub(crate) struct FixedPeaksKernel<'a>(pub(crate) &'a FixedOmega);

impl Kernel<5> for FixedPeaksKernel<'_> {
    const MARK: usize = 1;

    #[inline(always)]
    fn pass(&self, _: &Block, alpha: &Block, work: &mut Work, out: [&mut Block; 5]) {
        let [a, b, c, d, ..] = work;
        match &self.0.loops {
            Loops::High(of_omega) => {
                over_alpha(&self.0.omega, alpha, of_omega.each_ref(), [a, b, c, d], out);
            }
            Loops::Low(of_omega) => {
                low_over_alpha(&self.0.omega, alpha, of_omega.each_ref(), [a, b, c], out);
            }
            Loops::None => {}
        }
    }

    fn careful(&self, _: f64, alpha: f64) -> [f64; 5] {
        careful::peaks(self.0.omega(), alpha)
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
        let [a, b, c, ..] = work;
        match &self.0.loops {
            Loops::High(of_omega) => {
                all_over_alpha(&self.0.omega, alpha, of_omega.each_ref(), [a, b, c], out);
            }
            Loops::Low(of_omega) => {
                all_low_over_alpha(&self.0.omega, alpha, of_omega.each_ref(), [a, b], out);
            }
            Loops::None => {}
        }
    }

    fn careful(&self, _: f64, alpha: f64) -> [f64; 9] {
        careful::all(self.0.omega(), alpha)
    }

    fn omega(&self, _: f64) -> f64 {
        self.0.omega()
    }
}
