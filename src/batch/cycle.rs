//! All outputs of a cycle, over a block.

use super::amplitude::{Amplitude, Domain};
use super::block::{AtPoint, Block, each};
use super::careful;
use super::kernel::{Kernel, Work};
use super::low::{LowArrival, LowContraction, LowParts, LowSizes, LowStart, has_low_loops};
use super::peaks::{Arrival, Parts, Start};
use crate::float::pair::Pair;
use crate::nonsticking::stability::contraction;
use crate::phase_function::Frequency;

/// {Δ₀, ω_d t₂, V₀, ω_d t₁, Δ₁, α_min, λ, A₁, A₂}.
pub(crate) struct CycleKernel;

impl Kernel<9> for CycleKernel {
    const MARK: usize = 5;

    #[inline(always)]
    fn pass(&self, omega: &Block, alpha: &Block, work: &mut Work, out: [&mut Block; 9]) {
        let [k, rest, inverse, kappa, slope, a, b, c, ..] = work;
        each(&Parts::new(), [omega], [k, rest, inverse, kappa, slope]);
        all_over_alpha(omega, alpha, [k, rest, inverse, kappa, slope], [a, b, c], out);
    }

    #[inline(always)]
    fn pass_low(&self, omega: &Block, alpha: &Block, work: &mut Work, out: [&mut Block; 9]) {
        let [k, rest, inverse, sin_beta, cos_beta, least, a, b, c, ..] = work;
        each(&LowParts, [omega], [k, rest, inverse, sin_beta, cos_beta, least]);
        all_low_over_alpha(omega, alpha, [k, rest, inverse, sin_beta, cos_beta, least], [a, b, c], out);
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
        let found = Amplitude::high(&self.0, omega, alpha, Pair::new(k, rest));
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

/// The loops over α below Ω = 1/2, from `[K, what the rounded K lacks, 1/Ω, sin β, cos β, α_min]`.
#[inline(always)]
pub(crate) fn all_low_over_alpha(
    omega: &Block,
    alpha: &Block,
    [k, rest, inverse, sin_beta, cos_beta, least]: [&Block; 6],
    [theta, mark, less]: [&mut Block; 3],
    [displacement, phase2, velocity, phase1, deviation, border, contraction, size1, size2]: [&mut Block; 9],
) {
    let sizes = [&mut *displacement, &mut *mark, size1, &mut *phase2, size2, &mut *less];
    each::<5, 6>(&LowSizes::new(), [omega, alpha, k, rest, least], sizes);
    let (displacement, less, phase2) = (&*displacement, &*less, &*phase2);
    each(
        &LowStart::new(),
        [omega, displacement, less, inverse, sin_beta, cos_beta, alpha, phase2],
        [&mut *theta],
    );
    let given = [omega, displacement, less, inverse, sin_beta, cos_beta, &*theta, phase2, &*mark];
    each(&LowArrival::new(), given, [velocity, phase1, border, deviation]);
    each(&LowContraction, [omega, displacement, sin_beta, cos_beta], [contraction]);
}
