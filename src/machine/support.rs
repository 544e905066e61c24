//! The force on the support, by the excitation.

use crate::float::{Field, Float};
use crate::machine::excitation::Excitation;
use crate::machine::ratios::Ratios;

/// The force on the support under an excitation, if there is one.
///
/// If the support moves, support and surface together carry the force m x″, which is `Ω²` times the acceleration, because
/// nothing else acts on the body. The transmissibility is then the ratio of the accelerations of body and support, where a
/// damper on the support leaves `√(1 + (2ζΩ)²) u₀ = p₀/k`. Otherwise the two values are the force of spring, damper and
/// friction, and that force over p₀.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Support<F> {
    pub(crate) excitation: Option<Excitation>,
    pub(crate) omega: F,
    pub(crate) alpha: F,
    pub(crate) damping_ratio: F,
}

impl<F: Float> From<&Ratios<F>> for Support<F> {
    fn from(ratios: &Ratios<F>) -> Self {
        Self {
            excitation: ratios.excitation(),
            omega: ratios.omega(),
            alpha: ratios.alpha(),
            damping_ratio: ratios.damping_ratio(),
        }
    }
}

impl<F: Field> Support<F> {
    /// Whether the support carries m x″, so that its force is that of the peak acceleration.
    pub(crate) fn is_foot(&self) -> bool {
        self.excitation.is_some_and(Excitation::moves_foot)
    }

    /// The transmitted force in r_y: of the peak acceleration in B ω_d² where the support moves, otherwise the maximum
    /// force of spring, damper and friction.
    pub(crate) fn force(&self, carried: F) -> F {
        if self.is_foot() { carried * self.omega.square() } else { carried }
    }

    /// The amplitude of the support of the spring in B where it moves, and 2ζ if the damper stands on it, otherwise 0.
    pub(crate) fn foot(&self) -> Option<(F, F)> {
        self.is_foot().then(|| {
            let has_damper = self.excitation == Some(Excitation::DampedFootMotion);
            let damping = if has_damper { F::int(2) * self.damping_ratio } else { F::int(0) };
            (self.alpha / F::int(1).hypot(damping * self.omega), damping)
        })
    }

    /// The transmissibility, from the same maximum.
    pub(crate) fn transmissibility(&self, carried: F) -> F {
        if self.excitation == Some(Excitation::DampedFootMotion) {
            let damper = F::int(2) * self.damping_ratio * self.omega;
            return carried * F::int(1).hypot(damper) / self.alpha;
        }
        carried / self.alpha
    }
}
