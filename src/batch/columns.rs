//! Where the outputs go: slices of one length.

use crate::regime::Regime;

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
pub(super) fn same_length(expected: usize, name: &'static str, found: usize) -> Result<(), LengthMismatch> {
    if found == expected { Ok(()) } else { Err(LengthMismatch { name, found, expected }) }
}

/// Where [`Batch::triple`](super::Batch::triple) writes, slices of the length of Ω.
#[derive(Debug)]
pub struct Triple<'a> {
    /// Maximum displacement Δ₀/B ([`crate::Cycle::max_displacement`]).
    pub max_displacement: &'a mut [f64],
    /// The border α_min ([`crate::Border::min_force_ratio`]): eq. 61 for Ω ≥ 1/2, exact below.
    pub min_force_ratio: &'a mut [f64],
    /// Loop size A₁ ([`crate::Cycle::loop_size_stiffness`]).
    pub loop_size_stiffness: &'a mut [f64],
}

/// Where [`Batch::peaks`](super::Batch::peaks) writes, slices of the length of Ω.
#[derive(Debug)]
pub struct Peaks<'a> {
    /// Maximum displacement Δ₀/B ([`crate::Cycle::max_displacement`]).
    pub max_displacement: &'a mut [f64],
    /// The exact border α_min ([`crate::Border::min_force_ratio`]).
    pub min_force_ratio: &'a mut [f64],
    /// Loop size A₁ ([`crate::Cycle::loop_size_stiffness`]).
    pub loop_size_stiffness: &'a mut [f64],
    /// Maximum velocity V₀/(Bω_d) ([`crate::Cycle::max_velocity`]).
    pub max_velocity: &'a mut [f64],
    /// Its phase ω_d t₁ ([`crate::Cycle::velocity_phase`]).
    pub velocity_phase: &'a mut [f64],
}

/// Where [`Batch::cycles`](super::Batch::cycles) writes, slices of the length of Ω.
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
pub(super) type Columns<'a> = (&'a mut [Option<Regime>], [&'a mut [f64]; 9]);

impl<'a> Triple<'a> {
    /// The slices in the kernel's order, all of length `n`.
    pub(super) fn split(self, n: usize) -> Result<[&'a mut [f64]; 3], LengthMismatch> {
        same_length(n, "maximum displacement Δ₀/B", self.max_displacement.len())?;
        same_length(n, "least force ratio α_min", self.min_force_ratio.len())?;
        same_length(n, "loop size A₁", self.loop_size_stiffness.len())?;
        Ok([self.max_displacement, self.min_force_ratio, self.loop_size_stiffness])
    }
}

impl<'a> Peaks<'a> {
    /// The slices in the kernel's order, all of length `n`.
    pub(super) fn split(self, n: usize) -> Result<[&'a mut [f64]; 5], LengthMismatch> {
        same_length(n, "maximum displacement Δ₀/B", self.max_displacement.len())?;
        same_length(n, "least force ratio α_min", self.min_force_ratio.len())?;
        same_length(n, "loop size A₁", self.loop_size_stiffness.len())?;
        same_length(n, "maximum velocity V₀/(B ω_d)", self.max_velocity.len())?;
        same_length(n, "phase ω_d t₁", self.velocity_phase.len())?;
        Ok([
            self.max_displacement,
            self.min_force_ratio,
            self.loop_size_stiffness,
            self.max_velocity,
            self.velocity_phase,
        ])
    }
}

impl<'a> Cycles<'a> {
    /// The slices in the kernel's order, all of length `n`.
    pub(super) fn split(self, n: usize) -> Result<Columns<'a>, LengthMismatch> {
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
