//! Prediction of the next velocity zero: a hint for the search, which proves its result whatever the hint.
//!
//! Two slides in the same direction at the same phase differ by a free vibration, so that a known zero
//! predicts that of a neighbouring slide. In a settling motion the error of the hint is of third order in the
//! residual, and one evaluation replaces two or three.

use super::velocity_zero::VelocityZero;
use crate::float::Float;
use crate::motion::slide::Slide;

impl<F: Float> VelocityZero<F> {
    /// Predicted time of the zero if the start of the slide is disturbed by (δx, δw), which adds a free
    /// vibration. It is of second order, and unchanged if the shift would be large.
    #[inline]
    pub(crate) fn expected(&self, (x, w): (F, F), damping: F) -> F {
        let (s, c) = self.rotation;
        // The small decrease of the velocity: −δw after a slide.
        let less = s * x - (c - damping * s) * w;
        let acceleration = self.acceleration - (s * w + c * x) + damping * less;
        let first = less / acceleration;
        let delay = first - first.square() * self.jerk / (F::int(2) * acceleration);
        if delay.abs() * F::int(4) <= self.phi { self.phi + delay } else { self.phi }
    }
}

impl<F: Float> Slide<F> {
    /// Predicted duration of the next slide, assuming that it is nearly the mirror image of this one, half a
    /// turn later.
    #[inline]
    pub(crate) fn expected_next(&self, zero: &VelocityZero<F>, next: &Self) -> F {
        self.expected_of(zero, next, next.start.since(self.start) - F::pi(), -F::int(1))
    }

    /// Predicted duration of a slide that begins almost as this one did.
    #[inline]
    pub(crate) fn expected_again(&self, zero: &VelocityZero<F>, next: &Self) -> F {
        self.expected_of(zero, next, next.start.since(self.start), F::int(1))
    }

    /// Predicted duration of a slide that begins later by an angle of the drive; with −1 for `upright`, of
    /// its mirror image.
    ///
    /// Extrapolated to the start of this slide, at w = 0, the other slide differs from this one by a free
    /// vibration.
    #[inline]
    fn expected_of(&self, zero: &VelocityZero<F>, next: &Self, later: F, upright: F) -> F {
        let late = later / self.equation.omega;
        if self.w != F::int(0) || late.abs() * F::int(4) > zero.phi {
            return zero.phi;
        }
        let (acceleration, jerk) = (upright * next.acceleration, upright * next.jerk_at_start());
        let (half, third) = (late / F::int(2), late / F::int(3));
        let x = upright * next.x - self.x + late * half * (acceleration - third * jerk);
        let w = -(late * (acceleration - half * jerk));
        zero.expected((x, w), self.equation.damping) - late
    }
}

#[cfg(test)]
mod tests {
    use crate::Ratios;
    use crate::motion::trajectory::Body;
    use crate::motion::{State, Trajectory};

    #[test]
    fn it_is_right_to_third_order() {
        for (omega, alpha) in [(0.7f64, 3.0f64), (0.9, 2.0), (1.3, 2.0), (1.5, 2.5), (2.2, 4.0)] {
            let start = State::new(0.3, 2.0, 0.0).unwrap();
            let motion = Trajectory::new(Ratios::new(omega, alpha).unwrap(), start).unwrap();
            let slides = motion.filter_map(|phase| match phase.unwrap().body {
                Body::Slide(slide, zero) => Some((slide, zero)),
                Body::Stick(_) => None,
            });
            let slides: Vec<_> = slides.take(60).collect();
            let mut better = 0;
            for pair in slides.windows(2) {
                let [(slide, zero), (next, end)] = pair else { continue };
                let change = (next.x + slide.x).abs() + (end.phi - zero.phi).abs();
                let missed = (slide.expected_next(zero, next) - end.phi).abs();
                assert!(missed <= 20.0 * change.powi(3) + 1e-14, "({omega}, {alpha}): {change} {missed}");
                better += u32::from(missed * 10.0 < (end.phi - zero.phi).abs());
            }
            assert!(better >= 10, "({omega}, {alpha}): {better}");
        }
    }
}
