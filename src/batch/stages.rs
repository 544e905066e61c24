//! The loops over a block that the requested outputs need.

use super::amplitude::{Domain, Sizes};
use super::block::{Block, each};
use super::columns::{LOOPED, Looped};
use super::low::{LowArrival, LowContraction, LowPeak, LowSizes, LowStart};
use super::velocity::{Arrival, Contraction, Start};

/// The outputs of [`LOOPED`] over a block.
pub(crate) type Answer = [Block; LOOPED.len()];
/// Blocks for intermediate quantities that pass from one loop to the next.
pub(crate) type Work = [Block; 3];
/// Quantities of Ω ≥ 1/2: K, the low part of K, 1/Ω, κ and u/(Ω − 1).
pub(crate) type HighParts = [Block; 5];
/// Quantities of Ω < 1/2: K, the low part of K, 1/Ω, sin β, cos β and α_min.
pub(crate) type LowParts = [Block; 6];

/// The stages beyond {Δ₀, α_min, A₁}.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stages {
    is_more: bool,
    inertia: bool,
    velocity: bool,
    deviation: bool,
    contraction: bool,
}

impl Stages {
    pub(crate) fn of(wanted: &Looped<'_>) -> Self {
        Self {
            is_more: wanted.has(3..LOOPED.len()),
            inertia: wanted.has(4..5),
            velocity: wanted.has(5..8),
            deviation: wanted.has(7..8),
            contraction: wanted.has(8..LOOPED.len()),
        }
    }

    /// Whether one loop suffices: no output but {Δ₀, α_min, A₁} is requested.
    pub(crate) const fn is_amplitude(self) -> bool {
        !self.is_more
    }

    /// Runs the loops over α, for Ω ≥ 1/2.
    #[inline(always)]
    pub(crate) fn high(
        self,
        omega: &Block,
        alpha: &Block,
        [k, rest, inverse, kappa, slope]: &HighParts,
        [psi, mark, less]: &mut Work,
        [displacement, border, size1, phase2, size2, velocity, phase1, deviation, contraction]: &mut Answer,
    ) {
        let (sizes, given) = (Sizes(Domain::new()), [omega, alpha, k, rest]);
        let found = if self.velocity { &mut *mark } else { &mut *border };
        if self.inertia {
            each::<4, 6>(&sizes, given, [displacement, found, size1, phase2, less, size2]);
        } else {
            each::<4, 5>(&sizes, given, [displacement, found, size1, phase2, less]);
        }
        if self.velocity {
            each(&Start, [omega, displacement, inverse, kappa, slope], [&mut *psi]);
            let given = [omega, &*displacement, inverse, kappa, slope, psi, phase2, mark, less];
            if self.deviation {
                let [a, b, c, d, e, f, g, h, i] = given;
                let given = [a, b, c, d, e, f, g, h, i, k, rest];
                each(&Arrival::new(), given, [velocity, phase1, border, deviation]);
            } else {
                each(&Arrival::new(), given, [velocity, phase1, border]);
            }
        }
        if self.contraction {
            each(&Contraction, [omega, displacement, inverse, kappa, slope], [contraction]);
        }
    }

    /// Runs the loops over α, for Ω < 1/2.
    #[inline(always)]
    pub(crate) fn low(
        self,
        omega: &Block,
        alpha: &Block,
        [k, rest, inverse, sin_beta, cos_beta, least]: &LowParts,
        [theta, mark, less]: &mut Work,
        [displacement, border, size1, phase2, size2, velocity, phase1, deviation, contraction]: &mut Answer,
    ) {
        let (sizes, given) = (LowSizes::new(), [omega, alpha, k, rest, least]);
        if self.is_amplitude() {
            each::<5, 3>(&sizes, given, [displacement, border, size1]);
            return;
        }
        let found = if self.velocity { &mut *mark } else { &mut *border };
        each::<5, 6>(&sizes, given, [displacement, found, size1, phase2, size2, less]);
        if self.velocity {
            let given = [omega, &*displacement, less, inverse, sin_beta, cos_beta, alpha, phase2];
            each(&LowStart::new(), given, [&mut *theta]);
            let given = [omega, &*displacement, less, inverse, sin_beta, cos_beta, theta, phase2, mark];
            if self.deviation {
                each(&LowArrival::new(), given, [velocity, phase1, border, deviation]);
            } else {
                each(&LowPeak::new(), given, [velocity, phase1, border]);
            }
        }
        if self.contraction {
            each(&LowContraction, [omega, displacement, sin_beta, cos_beta], [contraction]);
        }
    }
}
