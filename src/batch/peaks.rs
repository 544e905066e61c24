//! {Δ₀, α_min, A₁, V₀, ω_d t₁}: the two peaks of the motion, of displacement and velocity.

use super::amplitude::{Amplitude, Domain};
use super::block::{AtPoint, Block, each, select};
use super::careful;
use super::kernel::{Kernel, Work};
use super::low::{LowParts, LowPeak, LowSizes, LowStart, has_low_loops};
use crate::float::circular::held;
use crate::float::pair::Pair;
use crate::nonsticking::{Circular, Waves, velocity_phase};
use crate::phase_function::{Frequency, Offset, Quotient};

/// {Δ₀, α_min, A₁, V₀, ω_d t₁}.
pub(crate) struct PeaksKernel;

impl Kernel<5> for PeaksKernel {
    const MARK: usize = 1;

    #[inline(always)]
    fn pass(&self, omega: &Block, alpha: &Block, work: &mut Work, out: [&mut Block; 5]) {
        let [k, rest, inverse, kappa, slope, a, b, c, d, ..] = work;
        each(&Parts::new(), [omega], [k, rest, inverse, kappa, slope]);
        over_alpha(omega, alpha, [k, rest, inverse, kappa, slope], [a, b, c, d], out);
    }

    #[inline(always)]
    fn pass_low(&self, omega: &Block, alpha: &Block, work: &mut Work, out: [&mut Block; 5]) {
        let [k, rest, inverse, sin_beta, cos_beta, least, a, b, c, d, e] = work;
        each(&LowParts, [omega], [k, rest, inverse, sin_beta, cos_beta, least]);
        low_over_alpha(omega, alpha, [k, rest, inverse, sin_beta, cos_beta, least], [a, b, c, d, e], out);
    }

    fn has_low(&self, omega: f64) -> bool {
        has_low_loops(omega)
    }

    fn careful(&self, omega: f64, alpha: f64) -> [f64; 5] {
        careful::peaks(omega, alpha)
    }
}

/// The loops over α, from `[K, what the rounded K lacks, 1/Ω, κ, u/(Ω − 1)]`.
#[inline(always)]
pub(crate) fn over_alpha(
    omega: &Block,
    alpha: &Block,
    [k, rest, inverse, kappa, slope]: [&Block; 5],
    [phase2, psi, mark, less]: [&mut Block; 4],
    [displacement, border, size, velocity, phase1]: [&mut Block; 5],
) {
    each(&Displacement(Domain::new()), [omega, alpha, k, rest], [displacement, mark, size, phase2, less]);
    each(&Start, [omega, displacement, inverse, kappa, slope], [psi]);
    let given = [omega, &*displacement, inverse, kappa, slope, &*psi, &*phase2, &*mark, &*less];
    each(&Arrival::new(), given, [velocity, phase1, border]);
}

/// The loops over α below Ω = 1/2, from `[K, what the rounded K lacks, 1/Ω, sin β, cos β, α_min]`.
#[inline(always)]
pub(crate) fn low_over_alpha(
    omega: &Block,
    alpha: &Block,
    [k, rest, inverse, sin_beta, cos_beta, least]: [&Block; 6],
    [phase2, theta, mark, less, size2]: [&mut Block; 5],
    [displacement, border, size, velocity, phase1]: [&mut Block; 5],
) {
    let sizes = [&mut *displacement, &mut *mark, size, &mut *phase2, size2, &mut *less];
    each::<5, 6>(&LowSizes::new(), [omega, alpha, k, rest, least], sizes);
    let (displacement, less, phase2) = (&*displacement, &*less, &*phase2);
    each(
        &LowStart::new(),
        [omega, displacement, less, inverse, sin_beta, cos_beta, alpha, phase2],
        [&mut *theta],
    );
    let given = [omega, displacement, less, inverse, sin_beta, cos_beta, &*theta, phase2, &*mark];
    each(&LowPeak::new(), given, [velocity, phase1, border]);
}

/// What depends on Ω alone.
#[derive(Clone, Copy)]
pub(crate) struct Parts(Quotient<f64>, Offset<f64>);

impl Parts {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self(held(Quotient::new()), held(Offset::new()))
    }
}

impl AtPoint<1, 5> for Parts {
    /// `[K, what the rounded K lacks, 1/Ω, κ, u/(Ω − 1)]`.
    #[inline(always)]
    fn at(&self, [omega]: [f64; 1]) -> [f64; 5] {
        let k = self.0.at(omega);
        let Frequency { inverse, kappa, offset_slope, .. } = Frequency::new(&self.1, omega, k);
        [k.hi, k.lo, inverse, kappa, offset_slope]
    }
}

/// `[Δ₀, α_min, A₁, ω_d t₂, what the rounded Δ₀ lacks]` from `[Ω, α, K, what the rounded K lacks]`; NaN for α_min says that the point is to be redone.
#[derive(Clone, Copy)]
pub(crate) struct Displacement(Domain);

impl AtPoint<4, 5> for Displacement {
    #[inline(always)]
    fn at(&self, [omega, alpha, k, rest]: [f64; 4]) -> [f64; 5] {
        let found = Amplitude::high(&self.0, omega, alpha, Pair::new(k, rest));
        [found.displacement(), found.border, found.size(), found.phase(), found.rest()]
    }
}

#[inline(always)]
fn waves([omega, max_displacement, inverse, kappa, offset_slope]: [f64; 5]) -> Waves<f64> {
    Waves { max_displacement, rest: 0.0, at: Frequency { omega, inverse, kappa, offset_slope } }
}

/// ψ near the greatest velocity.
pub(crate) struct Start;

impl AtPoint<5, 1> for Start {
    #[inline(always)]
    fn at(&self, given: [f64; 5]) -> [f64; 1] {
        [waves(given).start()]
    }
}

/// The greatest velocity.
#[derive(Clone, Copy)]
pub(crate) struct Arrival(Circular<f64>);

impl Arrival {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self(held(Circular::new()))
    }
}

impl Arrival {
    #[inline(always)]
    fn find(
        &self,
        [omega, delta, inverse, kappa, slope, psi, phase2, border, rest]: [f64; 9],
    ) -> ([f64; 3], f64) {
        let waves = Waves { rest, ..waves([omega, delta, inverse, kappa, slope]) };
        let (fastest, velocity) = waves.arrive(&self.0, psi);
        // Where there is no cycle, nothing could be found.
        let border = select(fastest.is_found | delta.is_nan(), border, f64::NAN);
        ([velocity, velocity_phase(phase2, omega, fastest.psi), border], fastest.psi)
    }
}

impl AtPoint<9, 3> for Arrival {
    /// `[V₀, ω_d t₁, α_min]`, α_min NaN where the velocity is to be redone.
    #[inline(always)]
    fn at(&self, given: [f64; 9]) -> [f64; 3] {
        self.find(given).0
    }
}

impl AtPoint<11, 4> for Arrival {
    /// The same and Δ₁, from K and what the rounded K lacks, too.
    #[inline(always)]
    fn at(
        &self,
        [omega, delta, inverse, kappa, slope, psi, phase2, border, less, k, rest]: [f64; 11],
    ) -> [f64; 4] {
        let ([velocity, phase1, border], psi) =
            self.find([omega, delta, inverse, kappa, slope, psi, phase2, border, less]);
        let beta = Frequency { omega, inverse, kappa, offset_slope: slope }.sin_cos_beta();
        [velocity, phase1, border, self.0.deviation(omega, beta, Pair::new(k, rest), psi)]
    }
}
