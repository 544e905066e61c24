//! Many points at once, from slices to slices.
//!
//! ```
//! use stickslip::Output;
//! use stickslip::batch::Batch;
//! let (omega, alpha) = ([0.7, 1.5, 0.4], [2.0, 2.5, 6.0]);
//! let (mut displacement, mut border) = ([0.0; 3], [0.0; 3]);
//! Batch::new()
//!     .with(Output::MaxDisplacement, &mut displacement)
//!     .with(Output::MinForceRatio, &mut border)
//!     .run(&omega, &alpha)?;
//! assert!((displacement[0] - 3.488507872497762_f64).abs() < 1e-14);
//! // At (0.4, 6) the body sticks; the border is at α = 6.949….
//! assert!(displacement[2].is_nan() && (border[2] - 6.949737755908733_f64).abs() < 1e-13);
//! # Ok::<(), stickslip::Error>(())
//! ```
//!
//! # How it works
//!
//! Points run in blocks of 128 through short loops without branches, and only through the loops that the
//! requested outputs need. The loops are compiled once for each [`Level`], which is chosen at run time. One
//! set of loops covers Ω from 1/2 to 2²⁰; another covers 2⁻¹⁰ to 1/2, for which the points are gathered into
//! blocks of their own.
//!
//! Points with a damper have loops of their own for eight outputs, above and below Ω = 1/2 ([`Batch::run_each`]).
//!
//! The remaining points are computed one by one by [`crate::Response`]: any other Ω, an Ω within 0.0012 Ω of
//! 1/(2n) or within 2⁻²⁴ of 1, and a start too far from the peak velocity. Every point of the domain thus
//! has an answer, and its side of the border is decided as in [`crate::Regime`].
//!
//! Values that do not exist are NaN: every output where Ω or α is outside the domain of [`crate::Ratios`],
//! and all but the border where there is no non-sticking cycle.
//!
//! The loops call the same functions as a single point, so that every [`Level`] gives the same bits, and the
//! same accuracy. Neither depends on the number of threads.

mod alone;
mod amplitude;
mod block;
mod columns;
mod damped;
mod fixed;
mod kernel;
mod level;
mod low;
mod places;
mod run;
mod stages;
mod straight;
#[cfg(feature = "rayon")]
mod threads;
mod velocity;

use fixed::FixedOmega;
pub(crate) use level::Loops;
#[doc(hidden)]
pub use {columns::is_looped_with_damper, level::Level};

use crate::cycle::regime::Regime;
use crate::machine::error::Error;
use crate::machine::ratios::Ratios;
use crate::output::Output;
use columns::{Looped, Slices, same_length};
use kernel::Kernel;

/// The requested outputs, each with the slice that receives it: any of [`Output::ALL`], and the regime. They are computed
/// by the best instructions of this processor, on the calling thread unless threads are asked for.
///
/// ```
/// use stickslip::batch::Batch;
/// use stickslip::{Output, Regime};
/// let (mut border, mut regime) = ([0.0; 2], [None; 2]);
/// let batch = Batch::new().with(Output::MinForceRatio, &mut border).with_regime(&mut regime);
/// batch.run(&[0.4, 1.5], &[6.0, 2.5])?;
/// assert_eq!(regime, [Some(Regime::Sticking), Some(Regime::NonSticking)]);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug)]
#[must_use]
pub struct Batch<'a> {
    columns: Slices<'a, { Output::ALL.len() }>,
    level: Level,
    #[cfg(feature = "rayon")]
    threads: bool,
}

impl Default for Batch<'_> {
    fn default() -> Self {
        Self::new()
    }
}

impl<'a> Batch<'a> {
    /// No outputs yet.
    pub fn new() -> Self {
        Self {
            columns: Slices::default(),
            level: Level::best(),
            #[cfg(feature = "rayon")]
            threads: false,
        }
    }

    /// Adds an output, which is NaN where it does not exist. If an output is added twice, the last slice
    /// counts.
    pub fn with(mut self, output: Output, slice: &'a mut [f64]) -> Self {
        self.columns.set(output, slice);
        self
    }

    /// Adds the regime of the steady motion ([`crate::Regime`]); `None` where a ratio is outside its
    /// domain.
    pub fn with_regime(mut self, slice: &'a mut [Option<Regime>]) -> Self {
        self.columns.regime = Some(slice);
        self
    }

    /// Uses all threads of the current rayon pool. The results are the same.
    #[cfg(feature = "rayon")]
    pub fn on_threads(mut self) -> Self {
        self.threads = true;
        self
    }

    /// Computes the requested outputs at the points (Ω, α).
    ///
    /// Nine outputs are computed by loops: {Δ₀, α_min, A₁} need one loop; V₀ with its phase, Δ₁ and λ need
    /// one more each. The others are computed point by point. Where all Ω are one number, as in a row of a map, what
    /// depends on Ω alone is computed once: the same bits, sooner.
    ///
    /// # Errors
    /// [`Error::LengthMismatch`] where the slices differ in length.
    pub fn run(mut self, omega: &[f64], alpha: &[f64]) -> Result<(), Error> {
        same_length(omega.len(), "alpha", alpha.len())?;
        self.columns.of_length(omega.len())?;
        let looped = self.columns.take_looped();
        self.looped(omega, alpha, looped);
        self.each(omega.len(), &|i| Ratios::new(*omega.get(i)?, *alpha.get(i)?).ok());
        Ok(())
    }

    /// Computes the requested outputs at `n` points whose ratios may have damping and static friction; NaN where
    /// there are no ratios.
    ///
    /// If nothing but {Δ₀, α_min, A₁, A₂, ω_d t₂, V₀, ω_d t₁, Δ₁} and the regime is requested, loops compute the points
    /// with 1/2 ≤ Ω ≤ 2²⁰ and 0 < ζ ≤ 7/8, except those within 10⁻⁶ or so of Ω = 1 with as little damping, those with a
    /// large ζ/Ω, and for V₀ those whose peak velocity is more than 1/ω_n or a sixth of a cycle from the middle of
    /// the half cycle. Loops of their own compute those with 2⁻¹⁰ ≤ Ω < 1/2 and 0 < ζ ≤ 1/2, except those beside
    /// Ω = 1/n, and for V₀ those where a few bounds do not prove it the greatest. All others, and all other outputs, are
    /// computed point by point.
    ///
    /// # Errors
    /// [`Error::LengthMismatch`] where a slice does not have `n` elements.
    pub fn run_each(
        self,
        n: usize,
        ratios: impl Fn(usize) -> Option<Ratios<f64>> + Sync,
    ) -> Result<(), Error> {
        self.columns.of_length(n)?;
        self.each(n, &ratios);
        Ok(())
    }

    fn looped(&self, omega: &[f64], alpha: &[f64], out: Looped<'_>) {
        if out.is_empty() {
            return;
        }
        let row = FixedOmega::of_all(omega);
        let kernel = Kernel::new(&out, row.as_ref());
        let level = kernel.level(self.level);
        #[cfg(feature = "rayon")]
        if self.threads {
            return threads::run_on_threads(&kernel, level, omega, alpha, out);
        }
        run::run(&kernel, level, omega, alpha, out);
    }

    /// Computes the columns that no loop without a damper fills.
    fn each(self, n: usize, ratios: &(impl Fn(usize) -> Option<Ratios<f64>> + Sync)) {
        if self.columns.is_empty() {
            return;
        }
        #[cfg(feature = "rayon")]
        if self.threads {
            return threads::each(self.level, 0, n, self.columns, ratios);
        }
        damped::run(self.level, 0, n, self.columns, ratios);
    }
}

// For the programs of this repository.
#[doc(hidden)]
impl<'a> Batch<'a> {
    /// Selects an instruction set; [`Level::Portable`] where the processor does not have it.
    pub fn at_level(mut self, level: Level) -> Self {
        self.level = if level.is_available() { level } else { Level::Portable };
        self
    }

    /// The instruction set in use.
    #[must_use]
    pub const fn level(&self) -> Level {
        self.level
    }
}
