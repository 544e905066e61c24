//! Rows of one frequency ratio: what depends on Ω is computed once.

use super::amplitude::{Amplitude, Domain, has_loops};
use super::block::{AtPoint, Block, POINTS, each, each_straight, select};
use super::careful;
use super::cycle::{all_low_over_alpha, all_over_alpha};
use super::kernel::{Kernel, Work};
use super::low::{LowParts, has_low_loops};
use super::peaks::{Parts, low_over_alpha, over_alpha};
use crate::error::Error;
use crate::float::pair::Pair;
use crate::nonsticking::Border;
use crate::phase_function::{PhaseFunction, is_close_to_one};

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
    /// Below: `[K, what the rounded K lacks, 1/Ω, sin β, cos β, α_min]`.
    Low(Box<[Block; 6]>),
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
        let border = Border::new(omega)?.min_force_ratio();
        let point =
            PointAt { omega, phase_function: p.wide(), one_minus_square: p.one_minus_square(), border };
        let loops = if has_loops(omega) {
            Loops::High(Box::new(Parts::new().at([omega]).map(|x| [x; POINTS])))
        } else if has_low_loops(omega) {
            let [k, rest, inverse, sine, cosine, _] = LowParts.at([omega]);
            Loops::Low(Box::new([k, rest, inverse, sine, cosine, border].map(|x| [x; POINTS])))
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
    /// 1 − Ω².
    one_minus_square: Pair<f64>,
    border: f64,
}

#[derive(Clone, Copy)]
struct Row {
    point: PointAt,
    domain: Domain,
    /// The border, or NaN where the points of the row are to be redone: too close to Ω = 1.
    border: f64,
}

impl Row {
    #[inline(always)]
    fn new(row: &FixedOmega) -> Self {
        let PointAt { omega, border, .. } = row.point;
        let border = select(is_close_to_one(omega), f64::NAN, border);
        Self { point: row.point, domain: Domain::new(), border }
    }
}

impl AtPoint<2, 3> for Row {
    #[inline(always)]
    fn at(&self, [_, alpha]: [f64; 2]) -> [f64; 3] {
        let PointAt { omega, phase_function, one_minus_square, .. } = self.point;
        let found = Amplitude::at(&self.domain, omega, alpha, phase_function, one_minus_square, self.border);
        [found.displacement(), found.border, found.size()]
    }
}

/// {Δ₀, α_min, A₁} of a row.
pub(crate) struct FixedTripleKernel<'a>(pub(crate) &'a FixedOmega);

impl Kernel<3> for FixedTripleKernel<'_> {
    const MARK: usize = 1;

    #[inline(always)]
    fn pass(&self, _: &Block, alpha: &Block, _: &mut Work, out: [&mut Block; 3]) {
        each(&Row::new(self.0), [alpha, alpha], out);
    }

    const IS_STRAIGHT: bool = true;

    #[inline(always)]
    fn pass_straight(&self, _: &[Block], alpha: &[Block], [a, b, c]: [&mut [Block]; 3]) {
        // A copy, which the outputs cannot overlap.
        each_straight(&Row::new(self.0), alpha, alpha, a, b, c);
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
        let [a, b, c, d, e, ..] = work;
        match &self.0.loops {
            Loops::High(of_omega) => {
                over_alpha(&self.0.omega, alpha, of_omega.each_ref(), [a, b, c, d], out);
            }
            Loops::Low(of_omega) => {
                low_over_alpha(&self.0.omega, alpha, of_omega.each_ref(), [a, b, c, d, e], out);
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
                all_low_over_alpha(&self.0.omega, alpha, of_omega.each_ref(), [a, b, c], out);
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
