//! Many points at once: slices in, slices out.
//!
//! ```
//! use stickslip::Output;
//! use stickslip::batch::{Batch, Columns};
//! let (omega, alpha) = ([0.7, 1.5, 0.4], [2.0, 2.5, 6.0]);
//! let (mut displacement, mut border) = ([0.0; 3], [0.0; 3]);
//! let columns = Columns::new()
//!     .with(Output::MaxDisplacement, &mut displacement)
//!     .with(Output::MinForceRatio, &mut border);
//! Batch::new().run(&omega, &alpha, columns)?;
//! assert!((displacement[0] - 3.488507872497762_f64).abs() < 1e-14);
//! // At (0.4, 6) the body sticks, up to α = 6.949….
//! assert!(displacement[2].is_nan() && (border[2] - 6.949737755908733_f64).abs() < 1e-13);
//! # Ok::<(), stickslip::batch::LengthMismatch>(())
//! ```
//!
//! # How
//!
//! Blocks of 128 points run through short loops without branches, those that the outputs wanted take,
//! compiled once for each [`Level`] and chosen at run time: one set of loops from Ω = 1/2 to 2²⁰, another
//! from 2⁻¹⁰ to 1/2, for which the points are gathered into blocks of their own. What a loop cannot do well
//! is left to the library's own answer at one point ([`crate::Response`]): the other Ω, those closer to
//! 1/(2n) than 0.0012 Ω of it or to 1 than 2⁻²⁴, and a start too far from the greatest velocity. So there is
//! an answer for every point of the domain, and on which side of the border it lies is decided as
//! [`crate::Regime`] decides it.
//!
//! What does not exist is NaN: every output where Ω or α is outside the domain of [`crate::Ratios`], and all
//! but the border where there is no non-sticking cycle.
//!
//! The loops run the functions that answer a point, so that every [`Level`] gives the bits of the point
//! alone, and its accuracy. Threads do not change them.

mod alone;
mod amplitude;
mod block;
mod columns;
mod fixed;
mod kernel;
mod level;
mod low;
mod places;
mod run;
mod stages;
mod steady;
mod straight;
#[cfg(feature = "rayon")]
mod threads;
mod velocity;

pub use columns::{Columns, LengthMismatch};
pub use fixed::FixedOmega;
pub use level::Level;

use crate::error::Error;
use crate::exact::LongRun;
use crate::output::Output;
use crate::ratios::Ratios;
use columns::{Looped, Slices, same_length};
use kernel::Kernel;

/// How batches are run: with which instructions, and on how many threads.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Batch {
    level: Level,
    #[cfg(feature = "rayon")]
    threads: bool,
}

impl Default for Batch {
    fn default() -> Self {
        Self::new()
    }
}

impl Batch {
    /// With the best instructions of this processor, on the calling thread.
    #[must_use]
    pub fn new() -> Self {
        Self {
            level: Level::best(),
            #[cfg(feature = "rayon")]
            threads: false,
        }
    }

    /// With given instructions; with [`Level::Portable`] where the processor does not have them.
    #[doc(hidden)]
    #[must_use]
    pub fn at_level(mut self, level: Level) -> Self {
        self.level = if level.is_available() { level } else { Level::Portable };
        self
    }

    /// On all threads of the current rayon pool. The results are the same.
    #[cfg(feature = "rayon")]
    #[must_use]
    pub fn on_threads(mut self) -> Self {
        self.threads = true;
        self
    }

    /// The instructions it runs with.
    #[doc(hidden)]
    #[must_use]
    pub const fn level(&self) -> Level {
        self.level
    }

    /// The outputs wanted at the points (Ω, α).
    ///
    /// The nine that a loop has cost what their loops cost: {Δ₀, α_min, A₁} one, V₀ with its phase, Δ₁ and λ
    /// one more each. The others are computed point by point.
    ///
    /// # Errors
    /// [`LengthMismatch`] where the slices are not of one length.
    pub fn run(&self, omega: &[f64], alpha: &[f64], columns: Columns<'_>) -> Result<(), LengthMismatch> {
        same_length(omega.len(), "alpha", alpha.len())?;
        let mut columns = columns.of_length(omega.len())?;
        self.looped(None, omega, alpha, columns.take_looped());
        self.each(omega.len(), columns, &|i| Ratios::new(*omega.get(i)?, *alpha.get(i)?).ok());
        Ok(())
    }

    /// The same at one Ω.
    ///
    /// # Errors
    /// [`LengthMismatch`] where the slices are not of one length.
    pub fn run_at(
        &self,
        row: &FixedOmega,
        alpha: &[f64],
        columns: Columns<'_>,
    ) -> Result<(), LengthMismatch> {
        let mut columns = columns.of_length(alpha.len())?;
        self.looped(Some(row), alpha, alpha, columns.take_looped());
        self.each(alpha.len(), columns, &|i| Ratios::new(row.omega(), *alpha.get(i)?).ok());
        Ok(())
    }

    /// The outputs wanted at `n` points whose ratios may have damping and static friction, each point alone;
    /// NaN where there are no ratios.
    ///
    /// # Errors
    /// [`LengthMismatch`] where a slice is not of `n` elements.
    pub fn run_each(
        &self,
        n: usize,
        ratios: impl Fn(usize) -> Option<Ratios<f64>> + Sync,
        columns: Columns<'_>,
    ) -> Result<(), LengthMismatch> {
        self.each(n, columns.of_length(n)?, &ratios);
        Ok(())
    }

    /// The exact motion in the long run from rest at the points (Ω, α): [`LongRun::from_start`] for each.
    ///
    /// An [`Error`] for a point outside the domain, in its place.
    ///
    /// # Errors
    /// [`LengthMismatch`] where the slices are not of one length.
    pub fn steady(
        &self,
        omega: &[f64],
        alpha: &[f64],
    ) -> Result<Vec<Result<LongRun<f64>, Error>>, LengthMismatch> {
        same_length(omega.len(), "force ratio α", alpha.len())?;
        #[cfg(feature = "rayon")]
        if self.threads {
            use rayon::prelude::*;
            let points = omega.par_iter().zip(alpha).with_min_len(16);
            return Ok(points.map(|(&omega, &alpha)| steady::steady(omega, alpha)).collect());
        }
        Ok(omega.iter().zip(alpha).map(|(&omega, &alpha)| steady::steady(omega, alpha)).collect())
    }

    fn looped(&self, row: Option<&FixedOmega>, omega: &[f64], alpha: &[f64], out: Looped<'_>) {
        let kernel = Kernel::new(&out, row);
        let level = kernel.level(self.level);
        if out.is_empty() {
            return;
        }
        #[cfg(feature = "rayon")]
        if self.threads {
            return threads::run_on_threads(&kernel, level, omega, alpha, out);
        }
        run::run(&kernel, level, omega, alpha, out);
    }

    /// Each point alone, for the columns that no loop fills.
    fn each(
        &self,
        n: usize,
        mut columns: Slices<'_, { Output::ALL.len() }>,
        ratios: &(impl Fn(usize) -> Option<Ratios<f64>> + Sync),
    ) {
        if columns.is_empty() {
            return;
        }
        #[cfg(feature = "rayon")]
        if self.threads {
            return threads::each(0, n, columns, ratios);
        }
        (0..n).for_each(|i| columns.put(i, ratios(i)));
    }
}
