//! The works where the damper stands on the moving support of the spring.
//!
//! The support moves by `u = U sin(θ − l)`, `U = α/√(1 + (2ζΩ)²)`, `tan l = 2ζΩ`, so that `u + 2ζu′ = α sin θ`. The body
//! as seen from the support, y = x − u, obeys the same equation of motion under another force,
//!
//! ```text
//! y″ + 2ζy′ + y + s = −u″ = Ω²U sin(θ − l),
//! ```
//!
//! and the work against the damper is that of its slide, `∫ 2ζ y′² dφ`: the difference of two velocities is never
//! formed. The support pulls with `(u − x) + 2ζ(u′ − x′)`; in a cycle its work exceeds that of the force `α sin θ` along x
//! by as much as the damper's work exceeds `∫ 2ζ x′² dφ`.

use super::Slide;
use super::equation::Equation;
use super::work::Works;
use crate::float::Float;
use crate::machine::excitation::Excitation;

impl<F: Float> Equation<F> {
    /// Whether the damper stands on the moving support.
    pub(crate) fn has_damped_foot(&self) -> bool {
        self.is_damped() && self.excitation == Some(Excitation::DampedFootMotion)
    }

    /// U, and sine and cosine of the lag l.
    fn foot(&self) -> (F, (F, F)) {
        let damper = self.damping * self.omega;
        let size = F::int(1).hypot(damper);
        (self.alpha / size, (damper / size, F::int(1) / size))
    }

    /// Work against a damper on the moving support while the body rests, from the angle `start` of the drive for `length`:
    /// `∫ 2ζu′² dφ = ζΩU² [L + sin L cos(2θ + L − 2l)]`; 0 for other dampers.
    pub(crate) fn damper_work_at_rest(&self, start: F, length: F) -> F {
        if !self.has_damped_foot() {
            return F::int(0);
        }
        let (size, (sine, cosine)) = self.foot();
        let two = F::int(2);
        let middle = two * (start - sine.atan2(cosine)) + length;
        let waves = length + length.sin() * middle.cos();
        self.damping / two * self.omega * size.square() * waves
    }
}

impl<F: Float> Slide<F> {
    /// The works of a support with the damper, from those of the force α sin θ and of 2ζx′.
    pub(super) fn works_of_foot(&self, works: Works<F>, phi: F) -> Works<F> {
        let relative = self.seen_from_foot();
        let damper = relative.damped_works(phi, &relative.motion(phi)).damper;
        Works { drive: works.drive + (damper - works.damper), damper }
    }

    /// The slide of y.
    fn seen_from_foot(&self) -> Self {
        let Equation { omega, damping, static_friction, .. } = self.equation;
        let (size, (sin_lag, cos_lag)) = self.equation.foot();
        let (s, c) = self.sin_cos_start();
        let (sine, cosine) = (s * cos_lag - c * sin_lag, c * cos_lag + s * sin_lag);
        let square = omega.square();
        let equation = Equation::of(omega, square * size, damping / F::int(2), static_friction);
        let start = self.start.advanced(-sin_lag.atan2(cos_lag));
        let (x, w) = (self.x - size * sine, self.w - size * omega * cosine);
        Self::with_sin_cos(equation, start, (sine, cosine), x, w, self.direction)
    }
}
