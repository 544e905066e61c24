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
//! Blocks of 128 points run through short loops without branches, compiled once for each [`Level`] and chosen at run time.
//! What such a loop cannot do well is left to the library's own code for one point ([`crate::Cycle`], [`crate::Border`]):
//! Ω < 1/2 or above 2²⁰, α closer to the border than 2⁻⁴⁶ of it or to |K| than 1/32, a velocity whose steps do not settle. So
//! there is an answer for every point of the domain, and on which side of the border it lies is decided as
//! [`mod@crate::regime`] decides it.
//!
//! What does not exist is NaN: every output where Ω or α is outside the domain of [`crate::Ratios`], and all but the border where
//! there is no non-sticking cycle.
//!
//! [`Level::Portable`], [`Level::Avx2`] and [`Level::Avx512`] give the same bits, and threads do not change them.

mod block;
mod circular;
mod cycle;
mod fixed;
mod frequency;
mod kernel;
mod level;
mod steady;
mod triple;
mod velocity;

pub use fixed::FixedOmega;
pub use level::Level;

use crate::error::Error;
use crate::exact::LongRun;
use crate::regime::Regime;
use kernel::Kernel;

/// Slices that do not belong together: their lengths differ.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("{name} has {found} elements where {expected} are due")]
pub struct LengthMismatch {
    /// Which slice.
    pub name: &'static str,
    /// Its length.
    pub found: usize,
    /// The length of the first slice.
    pub expected: usize,
}

/// `Err` where a slice of length `found` is not as long as the first.
fn same_length(expected: usize, name: &'static str, found: usize) -> Result<(), LengthMismatch> {
    if found == expected { Ok(()) } else { Err(LengthMismatch { name, found, expected }) }
}

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

/// Where [`Batch::triple`] writes, slices of the length of Ω.
#[derive(Debug)]
pub struct Triple<'a> {
    /// Maximum displacement Δ₀/B ([`crate::Cycle::max_displacement`]).
    pub max_displacement: &'a mut [f64],
    /// The border α_min ([`crate::Border::min_force_ratio`]): eq. 61 for Ω ≥ 1/2, exact below.
    pub min_force_ratio: &'a mut [f64],
    /// Loop size A₁ ([`crate::Cycle::loop_size_stiffness`]).
    pub loop_size_stiffness: &'a mut [f64],
}

/// Where [`Batch::cycles`] writes, slices of the length of Ω.
#[derive(Debug)]
pub struct Cycles<'a> {
    /// What the body does in the long run ([`mod@crate::regime`]); `None` where Ω or α is outside the domain.
    pub regime: &'a mut [Option<Regime>],
    /// Maximum displacement Δ₀/B ([`crate::Cycle::max_displacement`]).
    pub max_displacement: &'a mut [f64],
    /// Its phase ω_d t₂ ([`crate::Cycle::displacement_phase`]).
    pub displacement_phase: &'a mut [f64],
    /// Maximum velocity V₀/(Bω_d) ([`crate::Cycle::max_velocity`]).
    pub max_velocity: &'a mut [f64],
    /// Its phase ω_d t₁ ([`crate::Cycle::velocity_phase`]).
    pub velocity_phase: &'a mut [f64],
    /// Deviation Δ₁/B ([`crate::Cycle::deviation`]).
    pub deviation: &'a mut [f64],
    /// The exact border α_min ([`crate::Border::min_force_ratio`]).
    pub min_force_ratio: &'a mut [f64],
    /// Contraction per half cycle ([`crate::Cycle::contraction`]).
    pub contraction: &'a mut [f64],
    /// Loop size A₁ ([`crate::Cycle::loop_size_stiffness`]).
    pub loop_size_stiffness: &'a mut [f64],
    /// Loop size A₂ ([`crate::Cycle::loop_size_inertia`]).
    pub loop_size_inertia: &'a mut [f64],
}

/// The slices of [`Cycles`] in the kernel's order.
type Columns<'a> = (&'a mut [Option<Regime>], [&'a mut [f64]; 9]);

impl<'a> Triple<'a> {
    /// The slices in the kernel's order, all of length `n`.
    fn split(self, n: usize) -> Result<[&'a mut [f64]; 3], LengthMismatch> {
        same_length(n, "maximum displacement Δ₀/B", self.max_displacement.len())?;
        same_length(n, "least force ratio α_min", self.min_force_ratio.len())?;
        same_length(n, "loop size A₁", self.loop_size_stiffness.len())?;
        Ok([self.max_displacement, self.min_force_ratio, self.loop_size_stiffness])
    }
}

impl<'a> Cycles<'a> {
    /// The slices in the kernel's order, all of length `n`.
    fn split(self, n: usize) -> Result<Columns<'a>, LengthMismatch> {
        same_length(n, "regime", self.regime.len())?;
        let named = [
            ("maximum displacement Δ₀/B", self.max_displacement),
            ("phase ω_d t₂", self.displacement_phase),
            ("maximum velocity V₀/(B ω_d)", self.max_velocity),
            ("phase ω_d t₁", self.velocity_phase),
            ("deviation Δ₁/B", self.deviation),
            ("least force ratio α_min", self.min_force_ratio),
            ("contraction", self.contraction),
            ("loop size A₁", self.loop_size_stiffness),
            ("loop size A₂", self.loop_size_inertia),
        ];
        named.iter().try_for_each(|(name, slice)| same_length(n, name, slice.len()))?;
        Ok((self.regime, named.map(|(_, slice)| slice)))
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

    /// [`Batch::cycles`] at one Ω.
    ///
    /// # Errors
    /// [`LengthMismatch`] where the slices are not of one length.
    pub fn cycles_at(&self, row: &FixedOmega, alpha: &[f64], out: Cycles<'_>) -> Result<(), LengthMismatch> {
        let (regime, out) = out.split(alpha.len())?;
        let level = if row.has_loops() { self.level } else { Level::Scalar };
        let mut at = *self;
        at.level = level;
        at.run(&fixed::FixedCycleKernel(row), alpha, alpha, out, regime);
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
            return kernel::run_on_threads(kernel, self.level, omega, alpha, out, regimes);
        }
        kernel::run(kernel, self.level, omega, alpha, out, regimes);
    }
}
