//! All outputs of a cycle, over a block.

use super::amplitude::{Domain, High};
use super::block::{AtPoint, Block, each, select};
use super::careful;
use super::kernel::{Kernel, Work};
use super::low::{LowArrival, LowDisplacement, LowParts, LowStart, has_low_loops};
use super::peaks::{Arrival, Parts, Start};
use crate::float::circular::{SinCos, TO_HALF_PI, held};
use crate::float::pair::Pair;
use crate::nonsticking::stability::contraction;
use crate::phase_function::Frequency;
use core::f64::consts::PI;

/// {Δ₀, ω_d t₂, V₀, ω_d t₁, Δ₁, α_min, λ, A₁, A₂}.
pub(crate) struct CycleKernel;

impl Kernel<9> for CycleKernel {
    const MARK: usize = 5;

    #[inline(always)]
    fn pass(&self, omega: &Block, alpha: &Block, work: &mut Work, out: [&mut Block; 9]) {
        let [k, rest, inverse, kappa, slope, a, b, c, _] = work;
        each(&Parts::new(), [omega], [k, rest, inverse, kappa, slope]);
        all_over_alpha(omega, alpha, [k, rest, inverse, kappa, slope], [a, b, c], out);
    }

    #[inline(always)]
    fn pass_low(&self, omega: &Block, alpha: &Block, work: &mut Work, out: [&mut Block; 9]) {
        let [k, inverse, sin_beta, cos_beta, force, a, b, ..] = work;
        each(&LowParts::new(), [omega], [k, inverse, sin_beta, cos_beta, force]);
        all_low_over_alpha(omega, alpha, [k, inverse, sin_beta, cos_beta, force], [a, b], out);
    }

    fn has_low(&self, omega: f64) -> bool {
        has_low_loops(omega)
    }

    fn careful(&self, omega: f64, alpha: f64) -> [f64; 9] {
        careful::all(omega, alpha)
    }
}

/// The loops over α, from `[K, what the rounded K lacks, 1/Ω, κ, u/(Ω − 1)]`.
#[inline(always)]
pub(crate) fn all_over_alpha(
    omega: &Block,
    alpha: &Block,
    [k, rest, inverse, kappa, slope]: [&Block; 5],
    [psi, mark, less]: [&mut Block; 3],
    [displacement, phase2, velocity, phase1, deviation, border, contraction, size1, size2]: [&mut Block; 9],
) {
    each(&Sizes(Domain::new()), [omega, alpha, k, rest], [displacement, mark, size1, phase2, size2, less]);
    each(&Start, [omega, displacement, inverse, kappa, slope], [psi]);
    let given = [omega, &*displacement, inverse, kappa, slope, &*psi, &*phase2, &*mark, &*less, k, rest];
    each(&Arrival::new(), given, [velocity, phase1, border, deviation]);
    each(&Contraction, [omega, displacement, inverse, kappa, slope], [contraction]);
}

/// `[Δ₀, α_min, A₁, ω_d t₂, A₂, what the rounded Δ₀ lacks]` from `[Ω, α, K, what the rounded K lacks]`; NaN for α_min says that the point is to be redone.
struct Sizes(Domain);

impl AtPoint<4, 6> for Sizes {
    #[inline(always)]
    fn at(&self, [omega, alpha, k, rest]: [f64; 4]) -> [f64; 6] {
        let found = High::at(&self.0, omega, alpha, Pair::new(k, rest));
        let (displacement, border) = (found.displacement(), found.border);
        [displacement, border, found.size(), found.phase(), found.inertia(omega), found.rest()]
    }
}

/// The contraction λ.
struct Contraction;

impl AtPoint<5, 1> for Contraction {
    #[inline(always)]
    fn at(&self, [omega, displacement, inverse, kappa, offset_slope]: [f64; 5]) -> [f64; 1] {
        let at = Frequency { omega, inverse, kappa, offset_slope };
        [contraction(omega, displacement, at.sin_cos_beta())]
    }
}

/// The loops over α below Ω = 1/2, from `[K, 1/Ω, sin β, cos β, (1 − Ω²) S]`.
#[inline(always)]
pub(crate) fn all_low_over_alpha(
    omega: &Block,
    alpha: &Block,
    [k, inverse, sin_beta, cos_beta, force]: [&Block; 5],
    [theta, mark]: [&mut Block; 2],
    [displacement, phase2, velocity, phase1, deviation, border, contraction, size1, size2]: [&mut Block; 9],
) {
    each(&LowDisplacement::new(), [omega, alpha, k, force], [displacement, mark, size1, phase2]);
    each(&LowStart::new(), [omega, alpha, displacement, inverse, sin_beta, cos_beta, phase2], [theta]);
    let given = [omega, &*displacement, inverse, sin_beta, cos_beta, &*theta, &*phase2, &*mark];
    each(&LowArrival::new(), given, [velocity, phase1, border, deviation]);
    each(&Rest::new(), [omega, displacement, inverse, size1], [contraction, size2]);
}

/// The contraction λ and the loop size A₂ below Ω = 1/2.
#[derive(Clone, Copy)]
struct Rest(SinCos<f64, 8, 8>);

impl Rest {
    #[inline(always)]
    fn new() -> Self {
        Self(held(TO_HALF_PI))
    }
}

impl AtPoint<4, 2> for Rest {
    /// `[λ, A₂]` from `[Ω, Δ₀, 1/Ω, A₁]`.
    #[inline(always)]
    fn at(&self, [omega, displacement, inverse, size]: [f64; 4]) -> [f64; 2] {
        // sin and cos of π/Ω up to sign, from its distance to the nearest multiple of π.
        let multiple = inverse.round_ties_even();
        let (sine, cosine) = self.0.sin_cos(PI * (-multiple).mul_add(omega, 1.0) * inverse);
        let square = omega * omega;
        let g = square * displacement;
        let g_sine = g * sine.abs();
        let is_complex = g_sine > 1.0;
        let x = select(is_complex, g, g_sine);
        let product = (x - 1.0) * (x + 1.0);
        let modulus = select(is_complex, 0.0, g * cosine) + product.abs().sqrt();
        [modulus / (g + 1.0), square * size]
    }
}
