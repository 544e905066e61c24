//! Whether a machine whose contacts slide on travelling sides, such as belts, slides steadily.
//!
//! Where the other side of a contact travels at V, the contact slides with `v = b·q′ − V` in one direction s around the equilibrium.
//! Its force `s r(|v|) (N₀ + n·q)` is linear there: it adds `s r(|V|) b nᵀ` to the stiffness, which is then not symmetric,
//! and `r′(|V|) b bᵀ` to the damping. The roots λ of
//!
//! `det(λ² M + λ (C + Σ r′ b bᵀ) + K + Σ s r b nᵀ) = 0`
//!
//! say whether a disturbance grows. A falling law feeds it as a negative damper. Unsymmetric stiffness lets two frequencies
//! coalesce (mode coupling, flutter) or one of them fall to 0 (divergence) where the friction is large enough: that friction is sought on a mesh
//! of factors of the coefficients, on which the growth changes its sign, and between two of them by bisection.

use super::System;
use super::assembly::{Assembly, Part, Rule};
use super::fixed_point::eigenvalues;
use super::joints::Joints;
use super::matrix::{Matrix, add_times};
use super::modes::inverse_root;
use crate::float::Float;
use alloc::vec;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// The stability of steady sliding.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Sliding {
    /// The greatest rate of growth of a small disturbance, by which its logarithm increases in a unit of time: below 0 all decay.
    /// 0 where it is less than 10⁻⁶ of the fastest motion, and no damper acts.
    pub growth: f64,
    /// The angular frequency of that disturbance; 0 where it does not oscillate.
    pub frequency: f64,
    /// From where on the coefficients of those contacts whose normal load depends on the displacement make sliding unstable,
    /// if they do.
    pub threshold: Option<SlidingThreshold>,
}

/// The friction from which on sliding is unstable.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct SlidingThreshold {
    /// The factor of the coefficients of friction.
    pub factor: f64,
    /// The angular frequency of the disturbance that begins to grow; 0 for divergence, otherwise it is flutter.
    pub frequency: f64,
}

/// The greatest coefficient of friction at which a threshold is sought.
pub const GREATEST_COEFFICIENT: f64 = 10.0;
/// The steps of the mesh of factors.
const STEPS: u32 = 500;
/// The operations of all eigenvalues of a mesh, beyond which it has fewer steps.
const OPERATIONS: usize = 1 << 28;
const FEWEST: u32 = 24;
/// The part of the fastest rate that is not told from 0: near a double root the rounding of the matrix has its square root.
const ROUNDING: f64 = 1e-6;

impl<F: Float> Part<F> {
    /// The direction in which a contact slides on a side that travels, `sgn(−V)`, with r and r′ there.
    pub(super) fn sliding(&self) -> Option<(F, F, F)> {
        let Rule::Contact { pieces, .. } = &self.rule else { return None };
        if self.under.is_some() {
            return None;
        }
        let velocity = *self.velocity.last()?;
        if velocity == F::int(0) {
            return None;
        }
        let piece = pieces.iter().rev().find(|piece| piece.from <= velocity.abs())?;
        let force = piece.force + piece.slope * (velocity.abs() - piece.from);
        Some((F::int(1).with_sign_of(velocity), force, piece.slope))
    }

    /// n, for a normal load that depends on the displacement.
    fn normal_by_displacement(&self, n: usize) -> Option<&[F]> {
        let Rule::Contact { normal: Some(row), .. } = &self.rule else { return None };
        row.get(..n).filter(|by| by.iter().any(|x| *x != F::int(0)))
    }
}

impl<F: Float> Assembly<F> {
    /// K at a displacement with the friction of the contacts that slide on travelling sides, with `factor` times their coefficients, but for
    /// those held.
    pub(super) fn sliding_stiffness(&self, q: &[F], factor: F, held: &[usize]) -> Matrix<F> {
        let mut stiffness = self.tangent_stiffness(q);
        for (_, part) in self.parts.iter().enumerate().filter(|(i, _)| !held.contains(i)) {
            let (Some((sign, force, _)), Some(by)) = (part.sliding(), part.normal_by_displacement(self.n))
            else {
                continue;
            };
            for (row, &b) in part.direction.iter().enumerate() {
                add_times(stiffness.row_mut(row), factor * sign * force * b, by);
            }
        }
        stiffness
    }

    /// C with the slopes of the laws of the contacts that slide on travelling sides, and with the change of their friction by
    /// velocities.
    fn sliding_damping(&self) -> Matrix<F> {
        let (mut damping, n) = (self.damping.clone(), self.n);
        for part in &self.parts {
            let Some((sign, force, slope)) = part.sliding() else { continue };
            let by = part.normal().and_then(|row| row.get(n..2 * n)).unwrap_or(&[]);
            for (row, &b) in part.direction.iter().enumerate() {
                add_times(damping.row_mut(row), slope * b, &part.direction);
                add_times(damping.row_mut(row), sign * force * b, by);
            }
        }
        damping
    }

    /// The greatest growth of a disturbance, and its frequency, with a factor of the coefficients, by M^(−1/2) of the bodies with mass and
    /// by the damping between two of it. Joints are in balance.
    fn growth(&self, root: &Matrix<F>, damping: &Matrix<F>, factor: F) -> Option<Growth> {
        let n = root.columns();
        let at = self.sliding_equilibrium(factor);
        let stiffness = self.sliding_stiffness(&at, factor, &[]);
        let joints = Joints::new(self, &stiffness, &self.sliding_damping())?;
        let stiffness = root.times(&joints.balanced(&stiffness)).times(root);
        let most =
            |matrix: &Matrix<F>| matrix.rows().flatten().fold(F::int(0), |most, x| most.or_larger(x.abs()));
        // Times in units of the fastest motion, so that the entries are of one size.
        let rate = most(&stiffness).sqrt().or_larger(most(damping));
        let rate = if rate > F::int(0) { rate } else { F::int(1) };
        let mut matrix = Matrix::zero(2 * n, 2 * n);
        for i in 0..n {
            matrix.set(i, n + i, F::int(1));
            for j in 0..n {
                matrix.set(n + i, j, -(stiffness.at(i, j) / rate.square()));
                matrix.set(n + i, n + j, -(damping.at(i, j) / rate));
            }
        }
        let values = eigenvalues(&matrix);
        let (growth, frequency) = values.into_iter().max_by(|a, b| a.0.total_cmp(&b.0))?;
        Some(Growth { growth, frequency: frequency.abs(), rate: rate.to_f64() })
    }
}

/// A growth and a frequency in units of a rate.
#[derive(Clone, Copy)]
struct Growth {
    growth: f64,
    frequency: f64,
    rate: f64,
}

impl Growth {
    /// The frequency, 0 within rounding.
    fn frequency(self) -> f64 {
        if self.frequency > ROUNDING { self.frequency * self.rate } else { 0.0 }
    }
}

impl<F: Float> System<F> {
    /// The stability of steady sliding; none where no contact has a side that travels without end, a coordinate is moved, or a body without
    /// mass has a damper or is not held by springs.
    ///
    /// It is that of the equilibrium in which all such contacts slide and are closed, with stops open. Contacts that slide both ways, and elastic ones, have a
    /// friction that is constant there. A threshold is sought up to coefficients of [`GREATEST_COEFFICIENT`], on a mesh: instability in a
    /// band narrower than a step, 1/50 for up to twenty coordinates, may be missed.
    #[must_use]
    pub fn sliding(&self) -> Option<Sliding> {
        let system = &self.assembly;
        if !system.parts.iter().any(|part| part.sliding().is_some()) || !system.moved.is_empty() {
            return None;
        }
        let (at_rest, damping) = (vec![F::int(0); system.n], system.sliding_damping());
        let joints = Joints::new(system, &system.sliding_stiffness(&at_rest, F::int(1), &[]), &damping)?;
        let root = inverse_root(&joints.of_bodies(&system.mass));
        let damping = root.times(&joints.of_bodies(&damping)).times(&root);
        let at = |factor: f64| system.growth(&root, &damping, F::from_f64(factor));
        let (here, frictionless) = (at(1.0)?, at(0.0)?);
        // With dampers everywhere the growth passes through 0, otherwise it leaves 0.
        let enough = if frictionless.growth < -ROUNDING { 0.0 } else { ROUNDING };
        let grows = |found: Growth| found.growth > enough;
        let growth = if here.growth.abs() <= enough { 0.0 } else { here.growth * here.rate };
        let moving = system.parts.iter().filter(|part| part.normal_by_displacement(system.n).is_some());
        let greatest =
            moving.filter_map(|part| part.sliding()).map(|(_, force, _)| force.to_f64()).fold(0.0, f64::max);
        let threshold = || {
            if greatest <= 0.0 || grows(frictionless) {
                return None;
            }
            let cube = (2 * system.n).pow(3).saturating_mul(20);
            let steps = u32::try_from(OPERATIONS / cube).unwrap_or(STEPS).clamp(FEWEST, STEPS);
            let factor = |step: u32| GREATEST_COEFFICIENT / greatest * f64::from(step) / f64::from(steps);
            let first = (1..=steps).find(|step| at(factor(*step)).is_some_and(grows))?;
            let (mut low, mut high) = (factor(first - 1), factor(first));
            while high - low > 4.0 * f64::EPSILON * high {
                let middle = f64::midpoint(low, high);
                if at(middle).is_some_and(grows) { high = middle } else { low = middle }
            }
            Some(SlidingThreshold { factor: high, frequency: at(high)?.frequency() })
        };
        Some(Sliding { growth, frequency: here.frequency(), threshold: threshold() })
    }
}
