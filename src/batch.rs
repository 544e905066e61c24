//! Many points at once: slices in, slices out.
//!
//! ```
//! use stickslip::batch::{Batch, Triple};
//! let (omega, alpha) = ([0.7, 1.5, 0.4], [2.0, 2.5, 6.0]);
//! let (mut displacement, mut border, mut size) = ([0.0; 3], [0.0; 3], [0.0; 3]);
//! Batch::new().triple(
//!     &omega,
//!     &alpha,
//!     Triple {
//!         max_displacement: &mut displacement,
//!         min_force_ratio: &mut border,
//!         loop_size_stiffness: &mut size,
//!     },
//! )?;
//! assert!((displacement[0] - 3.488507872497762_f64).abs() < 1e-14);
//! // At (0.4, 6) the body sticks, up to α = 6.949….
//! assert!(displacement[2].is_nan() && (border[2] - 6.949737755908733_f64).abs() < 1e-13);
//! # Ok::<(), stickslip::batch::LengthMismatch>(())
//! ```
//!
//! # How
//!
//! Blocks of 128 points run through short loops without branches, compiled once for each [`Level`] and chosen at run time: one set of
//! loops from Ω = 1/2 to 2²⁰, another from 2⁻¹⁰ to 1/2, for which the points are gathered into blocks of their own. What a loop
//! cannot do well is left to the library's own answer at one point ([`crate::Response`]): the other Ω, those closer to
//! 1/(2n) than 0.0012 Ω of it or to 1 than 2⁻²⁴, and a start too far from the greatest velocity.
//! So there is an answer for every point of the domain, and on which side of the border it lies is decided as
//! [`mod@crate::regime`] decides it.
//!
//! What does not exist is NaN: every output where Ω or α is outside the domain of [`crate::Ratios`], and all but the border where
//! there is no non-sticking cycle.
//!
//! The loops run the functions that answer a point, so that every [`Level`] gives the bits of the point alone, and its accuracy. Threads
//! do not change them.

mod amplitude;
mod block;
mod careful;
mod columns;
mod cycle;
mod fixed;
mod kernel;
mod level;
mod low;
mod peaks;
mod places;
mod steady;
#[cfg(feature = "rayon")]
mod threads;
mod triple;

pub use columns::{Cycles, LengthMismatch, Peaks, Triple};
pub use fixed::FixedOmega;
pub use level::Level;

use crate::error::Error;
use crate::exact::LongRun;
use crate::regime::Regime;
use columns::same_length;
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
    #[must_use]
    pub const fn level(&self) -> Level {
        self.level
    }

    /// {Δ₀/B, α_min, A₁} at the points (Ω, α).
    ///
    /// # Errors
    /// [`LengthMismatch`] where the slices are not of one length.
    pub fn triple(&self, omega: &[f64], alpha: &[f64], out: Triple<'_>) -> Result<(), LengthMismatch> {
        same_length(omega.len(), "force ratio α", alpha.len())?;
        let out = out.split(omega.len())?;
        self.run(&triple::TripleKernel, omega, alpha, out, &mut []);
        Ok(())
    }

    /// {Δ₀/B, α_min, A₁, V₀/(Bω_d), ω_d t₁} at the points (Ω, α).
    ///
    /// # Errors
    /// [`LengthMismatch`] where the slices are not of one length.
    pub fn peaks(&self, omega: &[f64], alpha: &[f64], out: Peaks<'_>) -> Result<(), LengthMismatch> {
        same_length(omega.len(), "force ratio α", alpha.len())?;
        let out = out.split(omega.len())?;
        self.run(&peaks::PeaksKernel, omega, alpha, out, &mut []);
        Ok(())
    }

    /// The regime and all outputs of [`crate::Cycle`] at the points (Ω, α).
    ///
    /// # Errors
    /// [`LengthMismatch`] where the slices are not of one length.
    pub fn cycles(&self, omega: &[f64], alpha: &[f64], out: Cycles<'_>) -> Result<(), LengthMismatch> {
        same_length(omega.len(), "force ratio α", alpha.len())?;
        let (regime, out) = out.split(omega.len())?;
        self.run(&cycle::CycleKernel, omega, alpha, out, regime);
        Ok(())
    }

    /// [`Batch::triple`] at one Ω.
    ///
    /// # Errors
    /// [`LengthMismatch`] where the slices are not of one length.
    pub fn triple_at(&self, row: &FixedOmega, alpha: &[f64], out: Triple<'_>) -> Result<(), LengthMismatch> {
        let out = out.split(alpha.len())?;
        self.run(&fixed::FixedTripleKernel(row), alpha, alpha, out, &mut []);
        Ok(())
    }

    /// [`Batch::peaks`] at one Ω.
    ///
    /// # Errors
    /// [`LengthMismatch`] where the slices are not of one length.
    pub fn peaks_at(&self, row: &FixedOmega, alpha: &[f64], out: Peaks<'_>) -> Result<(), LengthMismatch> {
        let out = out.split(alpha.len())?;
        self.for_row(row).run(&fixed::FixedPeaksKernel(row), alpha, alpha, out, &mut []);
        Ok(())
    }

    /// [`Batch::cycles`] at one Ω.
    ///
    /// # Errors
    /// [`LengthMismatch`] where the slices are not of one length.
    pub fn cycles_at(&self, row: &FixedOmega, alpha: &[f64], out: Cycles<'_>) -> Result<(), LengthMismatch> {
        let (regime, out) = out.split(alpha.len())?;
        self.for_row(row).run(&fixed::FixedCycleKernel(row), alpha, alpha, out, regime);
        Ok(())
    }

    /// The same, point by point where the loops do not reach.
    const fn for_row(mut self, row: &FixedOmega) -> Self {
        if !row.has_loops() {
            self.level = Level::Scalar;
        }
        self
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

    fn run<K: Kernel<N>, const N: usize>(
        &self,
        kernel: &K,
        omega: &[f64],
        alpha: &[f64],
        out: [&mut [f64]; N],
        regimes: &mut [Option<Regime>],
    ) {
        #[cfg(feature = "rayon")]
        if self.threads {
            return threads::run_on_threads(kernel, self.level, omega, alpha, out, regimes);
        }
        kernel::run(kernel, self.level, omega, alpha, out, regimes);
    }
}
