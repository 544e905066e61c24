//! The motion at one instant of a slide, with its derivatives.

use super::event::Jet;
use crate::float::Float;

/// What moves at one instant of a slide; rates are by natural time φ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Motion<F> {
    pub(crate) x: F,
    pub(crate) w: F,
    /// `w′ = α sin θ − x − s`
    pub(crate) acceleration: F,
    /// `w″ = αΩ cos θ − w`
    pub(crate) jerk: F,
    /// `α sin θ`
    pub(crate) force: F,
    /// (sin φ, cos φ) of the time since the start of the slide.
    pub(crate) rotation: (F, F),
}

impl<F: Float> Motion<F> {
    /// The two derivatives of w after the jerk: `w‴ = −Ω² α sin θ − w′` and `w⁗ = −Ω² αΩ cos θ − w″`.
    #[inline]
    pub(crate) fn higher(&self, omega: F) -> (F, F) {
        let square = omega.square();
        (-(square * self.force + self.acceleration), -(square * (self.jerk + self.w) + self.jerk))
    }

    /// The velocity with its derivatives, turned to the sign of the slide.
    #[inline]
    pub(crate) fn velocity_jet(&self, omega: F, sign: F) -> Jet<F> {
        let third = self.higher(omega).0;
        Jet {
            value: sign * self.w,
            first: sign * self.acceleration,
            second: sign * self.jerk,
            third: sign * third,
        }
    }

    /// The acceleration with its derivatives, turned to a sign.
    #[inline]
    pub(crate) fn acceleration_jet(&self, omega: F, sign: F) -> Jet<F> {
        let (second, third) = self.higher(omega);
        Jet {
            value: sign * self.acceleration,
            first: sign * self.jerk,
            second: sign * second,
            third: sign * third,
        }
    }
}
