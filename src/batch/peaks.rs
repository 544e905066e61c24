//! {Δ₀, α_min, A₁, V₀, ω_d t₁}: the two peaks of the motion, of displacement and velocity.

use super::amplitude::{Amplifier, has_loops, one_minus_square};
use super::block::{AtPoint, Block, each, select};
use super::careful;
use super::circular::{ARCTANGENT, Arctangent, held};
use super::frequency::{Frequency, Parts};
use super::kernel::{Kernel, Work};
use super::low::{LowDisplacement, LowParts, LowPeak, LowStart, has_low_loops};
use super::velocity::{Circular, Waves, turned};
use core::f64::consts::{FRAC_PI_2, PI};

/// {Δ₀, α_min, A₁, V₀, ω_d t₁}.
pub(crate) struct PeaksKernel;

impl Kernel<5> for PeaksKernel {
    const MARK: usize = 1;

    #[inline(always)]
    fn pass(&self, omega: &Block, alpha: &Block, work: &mut Work, out: [&mut Block; 5]) {
        let [k, inverse, kappa, slope, a, b, c, ..] = work;
        each(&Parts::new(), [omega], [k, inverse, kappa, slope]);
        over_alpha(omega, alpha, [k, inverse, kappa, slope], [a, b, c], out);
    }

    #[inline(always)]
    fn pass_low(&self, omega: &Block, alpha: &Block, work: &mut Work, out: [&mut Block; 5]) {
        let [k, inverse, sin_beta, cos_beta, force, a, b, c, _] = work;
        each(&LowParts::new(), [omega], [k, inverse, sin_beta, cos_beta, force]);
        low_over_alpha(omega, alpha, [k, inverse, sin_beta, cos_beta, force], [a, b, c], out);
    }

    fn has_low(&self, omega: f64) -> bool {
        has_low_loops(omega)
    }

    fn careful(&self, omega: f64, alpha: f64) -> [f64; 5] {
        careful::peaks(omega, alpha)
    }
}

/// The loops over α, from `[K, 1/Ω, κ, u/(Ω − 1)]`.
#[inline(always)]
pub(crate) fn over_alpha(
    omega: &Block,
    alpha: &Block,
    [k, inverse, kappa, slope]: [&Block; 4],
    [phase2, psi, mark]: [&mut Block; 3],
    [displacement, border, size, velocity, phase1]: [&mut Block; 5],
) {
    each(&Displacement::new(), [omega, alpha, k, inverse], [displacement, mark, size, phase2]);
    each(&Start, [omega, displacement, inverse, kappa, slope], [psi]);
    let given = [omega, &*displacement, inverse, kappa, slope, &*psi, &*phase2, &*mark];
    each(&Peak::new(), given, [velocity, phase1, border]);
}

/// The loops over α below Ω = 1/2, from `[K, 1/Ω, sin β, cos β, (1 − Ω²) S]`.
#[inline(always)]
pub(crate) fn low_over_alpha(
    omega: &Block,
    alpha: &Block,
    [k, inverse, sin_beta, cos_beta, force]: [&Block; 5],
    [phase2, theta, mark]: [&mut Block; 3],
    [displacement, border, size, velocity, phase1]: [&mut Block; 5],
) {
    each(&LowDisplacement::new(), [omega, alpha, k, force], [displacement, mark, size, phase2]);
    each(&LowStart::new(), [omega, alpha, displacement, inverse, sin_beta, cos_beta, phase2], [theta]);
    let given = [omega, &*displacement, inverse, sin_beta, cos_beta, &*theta, &*phase2, &*mark];
    each(&LowPeak::new(), given, [velocity, phase1, border]);
}

/// `[Δ₀, α_min, A₁, ω_d t₂]` from `[Ω, α, K, 1/Ω]`; NaN for α_min says that the point is to be redone.
#[derive(Clone, Copy)]
pub(crate) struct Displacement(Arctangent, Amplifier);

impl Displacement {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self(held(ARCTANGENT), Amplifier::new())
    }
}

impl AtPoint<4, 4> for Displacement {
    #[inline(always)]
    fn at(&self, [omega, alpha, k, inverse]: [f64; 4]) -> [f64; 4] {
        let distance = one_minus_square(omega);
        let force = distance * (inverse * inverse);
        let border = force.mul_add(force, k * k).sqrt();
        let found = self.1.at(alpha, k, distance.abs(), force, border, has_loops(omega));
        // For Ω ≥ 1/2, K ≤ 0.
        let angle = self.0.first_quadrant_angle(found.sine, -k, alpha);
        [found.displacement, found.border, found.size, PI + select(omega < 1.0, -angle, angle)]
    }
}

#[inline(always)]
fn waves([omega, max_displacement, inverse, kappa, offset_slope]: [f64; 5]) -> Waves {
    Waves { max_displacement, at: Frequency { omega, inverse, kappa, offset_slope } }
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
pub(crate) struct Arrival(Circular);

impl Arrival {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self(Circular::new())
    }
}

impl AtPoint<8, 4> for Arrival {
    /// `[V₀, ω_d t₁, α_min, Δ₁]`, α_min NaN where the velocity is to be redone.
    #[inline(always)]
    fn at(&self, [omega, delta, inverse, kappa, slope, psi, phase2, border]: [f64; 8]) -> [f64; 4] {
        let fastest = waves([omega, delta, inverse, kappa, slope]).arrive(&self.0, psi);
        [
            fastest.velocity * inverse,
            turned((-omega).mul_add(fastest.psi, phase2 - FRAC_PI_2)),
            // Where there is no cycle, nothing could be found.
            select(fastest.is_found | delta.is_nan(), border, f64::NAN),
            fastest.displacement,
        ]
    }
}

/// The same without the deviation Δ₁.
#[derive(Clone, Copy)]
struct Peak(Arrival);

impl Peak {
    #[inline(always)]
    fn new() -> Self {
        Self(Arrival::new())
    }
}

impl AtPoint<8, 3> for Peak {
    #[inline(always)]
    fn at(&self, given: [f64; 8]) -> [f64; 3] {
        let [velocity, phase, border, _] = self.0.at(given);
        [velocity, phase, border]
    }
}
